using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using Cleft;

/// <summary>Progress, log and cancelling.</summary>
sealed class CallbacksTest
{
    readonly Mesher mesher = new Mesher();

    sealed class OwnException : Exception { }

    void TestProgress()
    {
        var fractions = new List<double>();
        Thread caller = Thread.CurrentThread;
        Volume volume = Checks.BallVolume(mesher);
        mesher.Threads = 2;
        mesher.Progress = (fraction, stage) => {
            GC.Collect();  // which would take delegates that nobody holds
            fractions.Add(fraction);
            Checks.Check(Thread.CurrentThread == caller && stage.Length > 0, "wrong thread or no stage");
            return true;
        };
        mesher.Mesh(volume, Checks.Quick());
        Checks.Check(fractions.Count > 3, "no progress");
        Checks.Check(fractions.SequenceEqual(fractions.OrderBy(fraction => fraction)), "backwards");
    }

    void TestFalseCancels()
    {
        mesher.Progress = (fraction, stage) => false;
        Checks.Thrown<CancelledException>(() => Checks.BallMesh(mesher));
        mesher.Progress = null;
        Checks.Check(Checks.BallMesh(mesher).TetCount > 0, "no mesh");
    }

    void TestExceptionsComeOut()
    {
        mesher.Progress = (fraction, stage) => throw new OwnException();
        Checks.Thrown<OwnException>(() => Checks.BallMesh(mesher));
        mesher.Progress = null;
        Checks.BallMesh(mesher).Dispose();
    }

    void TestLog()
    {
        var levels = new List<LogLevel>();
        var tooFew = new Options { Background = Background.Lattice, Tets = 1 };  // cannot be met, which is warned of
        Volume volume = Checks.BallVolume(mesher);
        mesher.Log = (level, sentence) => levels.Add(level);
        mesher.Mesh(volume, tooFew);
        Checks.Check(levels.Contains(LogLevel.Warning), "no warning");
        mesher.Log = (level, sentence) => throw new OwnException();
        Checks.Thrown<OwnException>(() => mesher.Mesh(volume, tooFew));
    }

    /// <summary>
    /// Smoothing is of the volume: given to a later call alone, it changes nothing, and that is reported.
    /// </summary>
    void TestSmoothWithoutEffect()
    {
        var warnings = new List<string>();
        mesher.Log = (level, sentence) => {
            if (level == LogLevel.Warning)
                warnings.Add(sentence);
        };
        Options options = Checks.Quick();
        options.Smooth = 3;
        mesher.Mesh(Checks.BallVolume(mesher), options);
        Checks.Check(warnings.Count == 1 && warnings[0].StartsWith("Smooth is 3"), string.Join("; ", warnings));
    }

    static string StandardErrorOf(Action body)
    {
        TextWriter old = Console.Error;
        var text = new StringWriter();
        Console.SetError(text);
        try {
            body();
        } finally {
            Console.SetError(old);
        }
        return text.ToString();
    }

    /// <summary>Who gives no function sees warnings all the same.</summary>
    void TestWarningsAreShown()
    {
        var tooFew = new Options { Background = Background.Lattice, Tets = 1 };
        Volume volume = Checks.BallVolume(mesher);
        string shown = StandardErrorOf(() => mesher.Mesh(volume, tooFew));
        Checks.Check(shown.StartsWith("cleft: warning: "), shown);
        mesher.Log = null;
        Checks.Equal("", StandardErrorOf(() => mesher.Mesh(volume, tooFew)));
        mesher.Log = Mesher.ShowWarnings;
        Checks.Equal("", StandardErrorOf(() => Checks.BallMesh(mesher).Dispose()));
    }

    void TestCancelFromAnotherThread()
    {
        var started = new ManualResetEvent(false);
        Volume volume = Checks.SlowVolume(mesher);
        mesher.Progress = (fraction, stage) => started.Set();
        var thread = new Thread(() => {
            started.WaitOne();
            mesher.Cancel();
        });
        thread.Start();
        Checks.Thrown<CancelledException>(() => mesher.Mesh(volume));
        thread.Join();
    }

    // A token that is cancelled as soon as a call reports its progress.
    CancellationToken TokenCancelledWithin()
    {
        var source = new CancellationTokenSource();
        mesher.Cancellation = source.Token;
        mesher.Progress = (fraction, stage) => {
            source.Cancel();
            return true;
        };
        return source.Token;
    }

    void TestCancellationToken()
    {
        Volume volume = Checks.SlowVolume(mesher);
        CancellationToken token = TokenCancelledWithin();
        var cancelled = Checks.Thrown<OperationCanceledException>(() => mesher.Mesh(volume));
        Checks.Check(cancelled is CancelledException && cancelled.CancellationToken == token, "not of the token");
    }

    void TestCancelledTask()
    {
        Volume volume = Checks.SlowVolume(mesher);
        CancellationToken token = TokenCancelledWithin();
        Task task = Task.Run(() => mesher.Mesh(volume), token);
        Checks.Thrown<AggregateException>(task.Wait);
        Checks.Check(task.IsCanceled && !task.IsFaulted, "the task has failed, not been cancelled");
    }

    void TestOneCallAtATime()
    {
        mesher.Progress = (fraction, stage) => mesher.Metrics().Count >= 0;
        Checks.Thrown<InvalidOperationException>(() => Checks.BallMesh(mesher));
    }

    void TestCallbacksMayMeshElsewhere()
    {
        long tets = 0;
        mesher.Progress = (fraction, stage) => {
            if (tets == 0)
                tets = Checks.BallMesh(new Mesher()).TetCount;
            return true;
        };
        Checks.Equal(Checks.BallMesh(mesher).TetCount, tets);
    }
}
