using System;
using System.Collections.Generic;
using System.Runtime.ExceptionServices;
using System.Threading;

namespace Cleft
{
    /// <summary>
    /// Makes volumes, sizing fields and meshes, and tells how they are made: with how many threads, with what progress.
    /// One call runs on a Mesher at a time; another thread that tries gets an InvalidOperationException. <see
    /// cref="Cancel"/> is for other threads. Where options may be null, null stands for the defaults.
    /// </summary>
    public sealed partial class Mesher : NativeObject
    {
        // What the library calls: held here as long as the context knows of them.
        private readonly NativeProgress nativeProgress;
        private readonly NativeLog nativeLog;
        private ExceptionDispatchInfo thrown;
        private int busy;

        /// <summary>A mesher with one thread.</summary>
        public Mesher() : base(Create())
        {
            nativeProgress = OnProgress;
            nativeLog = OnLog;
            CleftException.Check(CleftNative.cleft_context_set_progress(Handle, nativeProgress, IntPtr.Zero));
            CleftException.Check(CleftNative.cleft_context_set_log(Handle, nativeLog, IntPtr.Zero));
        }

        private static NativeHandle Create()
        {
            NativeModules.Core();
            CleftException.Check(CleftNative.cleft_context_create(out IntPtr made));
            return new NativeHandle(made, CleftNative.cleft_context_destroy);
        }

        /// <summary>
        /// Threads that calls use, 1 to 1024, or 0 for as many as the machine has. The result does not depend on it.
        /// </summary>
        public int Threads
        {
            get { return CleftNative.cleft_context_threads(Handle); }
            set { Run(context => CleftNative.cleft_context_set_threads(context, value)); }
        }

        /// <summary>
        /// Receives the fraction done and the stage in words, on the thread that made the call. It returns true to go
        /// on, false to stop with a CancelledException. What it throws stops the call and comes out of it. May be null.
        /// </summary>
        public Func<double, string, bool> Progress { get; set; }

        /// <summary>
        /// Receives warnings and remarks, on the thread that made the call. It is <see cref="ShowWarnings"/> until it
        /// is set. May be null.
        /// </summary>
        public Action<LogLevel, string> Log { get; set; } = ShowWarnings;

        /// <summary>Prints warnings on the standard error, and nothing else.</summary>
        public static void ShowWarnings(LogLevel level, string sentence)
        {
            if (level == LogLevel.Warning)
                Console.Error.WriteLine("cleft: warning: " + sentence);
        }

        /// <summary>Stops calls with a CancelledException when it is cancelled.</summary>
        public CancellationToken Cancellation { get; set; }

        /// <summary>Asks the call that runs on this mesher to stop soon; from any thread.</summary>
        public void Cancel() { CleftException.Check(CleftNative.cleft_context_cancel(Handle)); }

        /// <summary>Figures that the stages noted: seconds, counts, angles before and after.</summary>
        public IReadOnlyDictionary<string, double> Metrics()
        {
            var figures = new Dictionary<string, double>();
            double[] value = new double[1];
            Run(context => {
                long count = CleftNative.cleft_context_metric_count(context);
                for (long index = 0; index < count; ++index) {
                    CleftException.Check(CleftNative.cleft_context_metric(context, index, out IntPtr name, value));
                    figures[Utf8.Read(name)] = value[0];
                }
                return CleftNative.CLEFT_OK;
            });
            return figures;
        }

        /// <summary>Forgets the figures.</summary>
        public void ClearMetrics() { Run(CleftNative.cleft_context_clear_metrics); }

        // ------------------------------------------------------------------------------------------------ calls

        internal override string Description => " of " + Threads + " threads";

        internal delegate int Maker(NativeHandle context, out IntPtr made);

        /// <summary>Runs a call that makes something, and answers its address.</summary>
        internal IntPtr Make(Maker maker)
        {
            IntPtr made = IntPtr.Zero;
            Run(context => maker(context, out made));
            return made;
        }

        /// <summary>Runs a call on this context; what a function of the user threw comes out first.</summary>
        internal void Run(Func<NativeHandle, int> call)
        {
            if (Interlocked.CompareExchange(ref busy, 1, 0) != 0)
                throw new InvalidOperationException("this Mesher is running another call; use one Mesher a thread");
            try {
                NativeHandle context = Handle;
                thrown = null;
                bool held = false;
                try {
                    context.DangerousAddRef(ref held);  // also while the sentence of a failure is read
                    int status = call(context);
                    thrown?.Throw();
                    if (status == CleftNative.CLEFT_ERROR_CANCELLED && Cancellation.IsCancellationRequested)
                        throw new CancelledException(Sentence(context), Cancellation);
                    if (status != CleftNative.CLEFT_OK)
                        CleftException.Check(status, status == CleftNative.CLEFT_ERROR_BUSY ? null : Sentence(context));
                } finally {
                    if (held)
                        context.DangerousRelease();
                    GC.KeepAlive(this);
                }
            } finally {
                Volatile.Write(ref busy, 0);
            }
        }

        private static string Sentence(NativeHandle context)
        {
            return context.IsClosed ? null : Wording.InCSharp(CleftNative.cleft_context_last_error(context));
        }

        private int OnProgress(double fraction, IntPtr stage, IntPtr user)
        {
            try {
                if (thrown != null || Cancellation.IsCancellationRequested)
                    return 1;
                Func<double, string, bool> progress = Progress;
                return progress == null || progress(fraction, Utf8.Read(stage)) ? 0 : 1;
            } catch (Exception failure) {
                thrown = ExceptionDispatchInfo.Capture(failure);
                return 1;
            }
        }

        private void OnLog(int level, IntPtr sentence, IntPtr user)
        {
            try {
                if (thrown == null)
                    Log?.Invoke((LogLevel)level, Wording.InCSharp(Utf8.Read(sentence)));
            } catch (Exception failure) {
                thrown = ExceptionDispatchInfo.Capture(failure);
            }
        }
    }
}
