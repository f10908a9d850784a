using System;
using System.Threading;

namespace Cleft
{
    /// <summary>
    /// The bytes that objects hold outside the heap, which the collector does not see: a mesh is a few bytes to it. So
    /// objects that nobody disposes of would pile up long before the heap fills. GC.AddMemoryPressure reports them to
    /// .NET, but Mono ignores it. So when what is held has grown by more than a budget, the collector is asked to
    /// find the objects that nobody reaches any more.
    /// </summary>
    internal static class NativeMemory
    {
        private const long Budget = 128L << 20;
        private const int Patience = 500;  // milliseconds

        private static readonly object collecting = new object();
        private static long held;
        private static long least;  // that was held since the last collection: most likely all in use

        internal static void Add(long bytes)
        {
            Interlocked.Add(ref held, bytes);
            GC.AddMemoryPressure(bytes);
        }

        internal static void Remove(long bytes)
        {
            GC.RemoveMemoryPressure(bytes);
            long now = Interlocked.Add(ref held, -bytes);
            for (long before = Volatile.Read(ref least); now < before; before = Volatile.Read(ref least))
                Interlocked.CompareExchange(ref least, now, before);
        }

        /// <summary>
        /// Makes room if more than the budget may be garbage; with much in use, if it may be a third of all.
        /// </summary>
        internal static void MakeRoom()
        {
            if (!IsOverBudget)
                return;
            lock (collecting)
                if (IsOverBudget)
                    Collect();
        }

        private static bool IsOverBudget
        {
            get {
                long inUse = Volatile.Read(ref least);
                return Volatile.Read(ref held) - inUse > Math.Max(Budget, inUse / 2);
            }
        }

        /// <summary>
        /// First lets the finalizers end what they are about to free; only then asks for a collection, which costs
        /// more. Does not wait for all finalizers, since one of the user's may wait for a lock that this thread holds.
        /// </summary>
        private static void Collect()
        {
            DateTime deadline = DateTime.UtcNow.AddMilliseconds(Patience);
            WaitWhileFreeing(() => true, deadline);
            if (!IsOverBudget)
                return;
            var finalized = new bool[1];
            MakeGarbage(finalized);
            GC.Collect();
            WaitWhileFreeing(() => Volatile.Read(ref finalized[0]), deadline);
            Volatile.Write(ref least, Volatile.Read(ref held));
        }

        /// <summary>Waits until finalizers run and then nothing is freed for a while.</summary>
        private static void WaitWhileFreeing(Func<bool> finalizersRun, DateTime deadline)
        {
            long before;
            do {
                before = Volatile.Read(ref held);
                Thread.Sleep(1);
            } while ((!finalizersRun() || Volatile.Read(ref held) < before) && DateTime.UtcNow < deadline);
        }

        /// <summary>Tells when the finalizers have come to it.</summary>
        private sealed class Witness
        {
            private readonly bool[] finalized;
            internal Witness(bool[] finalized) { this.finalized = finalized; }
            ~Witness() { Volatile.Write(ref finalized[0], true); }
        }

        /// <summary>
        /// An object that the next collection finds. On a thread of its own, for no stack may hold it.
        /// </summary>
        private static void MakeGarbage(bool[] finalized)
        {
            var thread = new Thread(() => new Witness(finalized).ToString());
            thread.Start();
            thread.Join();
        }
    }

    /// <summary>About how many bytes the objects of the library hold, from the counts that it tells.</summary>
    internal static class NativeSize
    {
        /// <summary>A context, options, a report: what has no large arrays.</summary>
        internal const long Small = 2048;

        /// <summary>
        /// One number of single precision a voxel and function; of a label map one or two bytes, and two for the
        /// weight.
        /// </summary>
        internal static long OfVolume(NativeHandle volume)
        {
            long functions = CleftNative.cleft_volume_indicator_count(volume);
            int ofLabel = CleftNative.cleft_volume_label_count(volume) > 256 ? 2 : 1;
            return Small + Voxels(volume) * (functions > 0 ? 4 * functions : ofLabel + 2);
        }

        internal static long OfSizing(NativeHandle sizing)
        {
            long[] dims = new long[3];
            CleftException.Check(CleftNative.cleft_sizing_dims(sizing, dims));
            return Small + 4 * dims[0] * dims[1] * dims[2];
        }

        /// <summary>Three coordinates a point; four corners and a label a tetrahedron.</summary>
        internal static long OfMesh(NativeHandle mesh)
        {
            return Small + 24 * CleftNative.cleft_mesh_point_count(mesh) + 20 * CleftNative.cleft_mesh_tet_count(mesh);
        }

        /// <summary>Three corners and two labels a triangle; on the hull a label and a side.</summary>
        internal static long OfSurface(NativeHandle surface)
        {
            return Small + 20 * (CleftNative.cleft_surface_interface_count(surface)
                + CleftNative.cleft_surface_hull_count(surface));
        }

        private static long Voxels(NativeHandle volume)
        {
            long[] dims = new long[3];
            CleftException.Check(CleftNative.cleft_volume_dims(volume, dims));
            return dims[0] * dims[1] * dims[2];
        }
    }
}
