using System;
using System.IO;
using System.Linq;
using Cleft;

/// <summary>
/// Meshes, looks and reads and writes again and again, until nothing fails any more; reports how often it failed.
/// tests/faults/walk.py lets allocations fail meanwhile.
/// </summary>
sealed class WalkTest
{
    const int Calm = 20;  // runs on end that do not fail

    static double[] Work(string path)
    {
        byte[] labels = Enumerable.Range(0, 5 * 4 * 6).Select(v => (byte)(v % 5 > 1 && v / 20 > 2 ? 7 : 0)).ToArray();
        using (var mesher = new Mesher())
        using (var options = new Options { Background = Background.Lattice, Size = 2 })
        using (Volume volume = mesher.Labels(labels, new Grid(5, 4, 6)))
        using (Mesh mesh = mesher.Mesh(volume, options))
        using (Surface surface = mesher.Surface(mesh)) {
            mesher.Quality(mesh);
            mesher.Validate(mesh, true);
            mesher.Report(volume, mesh);
            MeshFiles.WriteMesh(mesher, mesh, path);
            using (Mesh again = MeshFiles.ReadMesh(mesher, path))
                return again.CopyPoints();
        }
    }

    void TestWalk()
    {
        string path = Path.Combine(Environment.GetEnvironmentVariable("WALK_FOLDER"), "a.vtu");
        int failed = 0;
        double[] wanted = null;
        for (int calm = 0; calm < Calm; ++calm)
            try {
                double[] got = Work(path);
                wanted = wanted ?? got;
                Checks.Equal(wanted, got);
            } catch (NativeMemoryException) {
                ++failed;
                calm = -1;
            } catch (OutOfMemoryException) {
                ++failed;
                calm = -1;
            }
        Console.WriteLine("failed " + failed);
    }
}
