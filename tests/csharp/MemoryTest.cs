using System;
using System.IO;
using System.Linq;
using System.Threading;
using Cleft;

/// <summary>
/// Memory stays flat over many objects made, used, failed and dropped; and bounded where nobody disposes or collects.
/// </summary>
sealed class MemoryTest
{
    static long ResidentKilobytes()
    {
        string line = File.ReadLines("/proc/self/status").First(text => text.StartsWith("VmRSS"));
        return long.Parse(new string(line.Where(char.IsDigit).ToArray()));
    }

    /// <summary>Disposed of, or left to the collector.</summary>
    static void Cycle(bool dispose)
    {
        var mesher = new Mesher { Progress = (fraction, stage) => true, Log = (level, sentence) => { } };
        var options =
            new Options { Background = Background.Lattice, Size = 4, Improve = Improvement.Off, Strip = new[] { 0 } };
        Volume volume = Checks.BallVolume(mesher);
        Mesh mesh = mesher.Mesh(volume, options);
        Surface surface = mesher.Surface(mesh);
        Checks.Check(mesh.Points[0] == mesh.CopyPoints()[0] && surface.HullSides.Count > 0, "no mesh");
        mesher.Report(volume, mesh);
        mesher.Quality(mesh);
        Checks.Thrown<CleftException>(() => options.Size = -1);
        mesher.Progress = (fraction, stage) => false;
        Checks.Thrown<CancelledException>(() => mesher.Mesh(volume, options));
        if (dispose)
            foreach (NativeObject thing in new NativeObject[] { surface, mesh, volume, options, mesher })
                thing.Dispose();
    }

    static long AfterCycles(int count)
    {
        for (int n = 0; n < count; ++n) {
            Cycle(n % 2 == 0);
            if (n % 20 == 19) {
                GC.Collect();
                GC.WaitForPendingFinalizers();
            }
        }
        return ResidentKilobytes();
    }

    void TestAThousandCycles()
    {
        long before = AfterCycles(200);
        long after = AfterCycles(1000);
        Checks.Check(after - before < 8192, "memory grew by " + (after - before) + " kB");
    }

    /// <summary>The budget of 128 MiB, and as much again for what the allocator keeps. In kB.</summary>
    const long Bound = 256 << 10;

    /// <summary>
    /// Makes objects of 3 MB or more and drops each. The heap stays nearly empty: nothing else makes the collector run.
    /// </summary>
    static void MakeUnclosed(int count, Func<int, NativeObject> make)
    {
        NativeObject kept = make(0);
        long before = ResidentKilobytes(), most = before;
        for (int n = 1; n <= count; ++n) {
            make(n);
            most = Math.Max(most, ResidentKilobytes());
        }
        Console.WriteLine(count + " unclosed objects held at most " + (most - before) + " kB");
        Checks.Check(most - before < Bound, "unclosed objects held " + (most - before) + " kB");
        Checks.Check(!kept.IsDisposed && kept.ToString().Contains(" of "), "one that is in use is gone");
    }

    readonly double[] points = new double[3 * 60000];
    readonly int[] tets = new int[4 * 100000];

    void TestUnclosedMeshes()
    {
        var mesher = new Mesher();
        MakeUnclosed(400, n => mesher.MeshOf(points, tets));
    }

    void TestUnclosedVolumes()
    {
        var mesher = new Mesher();
        byte[] labels = new byte[100 * 100 * 100];
        MakeUnclosed(150, n => mesher.Labels(labels, new Grid(100, 100, 100)));
    }

    void TestUnclosedSizings()
    {
        var mesher = new Mesher();
        Volume volume = mesher.Labels(new byte[100 * 100 * 100], new Grid(100, 100, 100));
        MakeUnclosed(150, n => mesher.ConstantSizing(volume, 1 + n));
    }

    /// <summary>What is in use is no reason to collect again and again, nor are objects that are disposed of.</summary>
    void TestObjectsInUse()
    {
        var mesher = new Mesher();
        Mesh[] kept = Enumerable.Range(0, 100).Select(n => mesher.MeshOf(points, tets)).ToArray();
        int collections = GC.CollectionCount(GC.MaxGeneration);
        for (int n = 0; n < 400; ++n)
            mesher.MeshOf(points, tets).Dispose();
        collections = GC.CollectionCount(GC.MaxGeneration) - collections;
        Checks.Check(collections <= 1, collections + " collections for objects that are disposed of");
        foreach (Mesh mesh in kept) {
            Checks.Equal(60000L, mesh.PointCount);
            mesh.Dispose();
        }
    }

    void TestUnclosedInThreads()
    {
        long before = ResidentKilobytes();
        Thread[] threads = Enumerable.Range(0, 4).Select(t => new Thread(() => {
            var mesher = new Mesher();
            for (int n = 0; n < 100; ++n)
                mesher.MeshOf(points, tets);
        })).ToArray();
        foreach (Thread thread in threads)
            thread.Start();
        foreach (Thread thread in threads)
            thread.Join();
        long grown = ResidentKilobytes() - before;
        Checks.Check(grown < Bound, "unclosed objects held " + grown + " kB");
    }
}
