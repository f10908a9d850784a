using System;
using System.IO;
using System.Linq;
using Cleft;

/// <summary>Memory stays flat over many objects made, used, failed and dropped.</summary>
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
        var options = new Options { Background = Background.Lattice, Size = 4, Improve = Improvement.Off, Strip = new[] { 0 } };
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
}
