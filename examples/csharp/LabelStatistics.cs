using System;
using System.Collections.Generic;
using Cleft;

/// <summary>
/// Meshes a label map, prints what became of each label, and writes the mesh: LabelStatistics.exe VOLUME MESH.
/// VOLUME is NIfTI, NRRD, MetaImage ...; MESH is .vtu, .msh, .mesh, .inp ...
/// </summary>
static class LabelStatistics
{
    static int Main(string[] arguments)
    {
        if (arguments.Length != 2) {
            Console.Error.WriteLine("usage: LabelStatistics.exe VOLUME MESH");
            return 2;
        }
        using (var mesher = new Mesher { Threads = 0, Progress = Show })
        using (var options = new Options { FeatureScale = 2 })
        using (Volume volume = MeshFiles.ReadVolume(mesher, arguments[0], options))
        using (Mesh mesh = mesher.Mesh(volume, options)) {
            Dictionary<int, double> edges = MeanEdges(mesh);
            Console.WriteLine(
                "{0,8} {1,10} {2,14} {3,14} {4,12}", "label", "tets", "mesh volume", "voxel volume", "mean edge");
            foreach (LabelReport row in mesher.Report(volume, mesh))
                Console.WriteLine("{0,8} {1,10} {2,14:F3} {3,14:F3} {4,12:F4}", row.Label, row.Tets, row.MeshVolume,
                    row.VoxelVolume, edges.ContainsKey(row.Label) ? edges[row.Label] : double.NaN);
            Console.WriteLine("{0} points, {1} tetrahedra, least dihedral angle {2:F1} degrees", mesh.PointCount,
                mesh.TetCount, mesher.Quality(mesh).MinDihedral);
            MeshFiles.WriteMesh(mesher, mesh, arguments[1]);
            Console.WriteLine(arguments[1] + " is written");
        }
        return 0;
    }

    static bool Show(double fraction, string stage)
    {
        if (!Console.IsErrorRedirected)
            Console.Error.Write("\r{0,3:F0} % {1,-40}", 100 * fraction, stage);
        return true;  // go on
    }

    /// <summary>The mean length of the edges of the tetrahedra of each label, from views: nothing is copied.</summary>
    static Dictionary<int, double> MeanEdges(Mesh mesh)
    {
        ArrayView<double> points = mesh.Points;
        ArrayView<int> tets = mesh.Tets, labels = mesh.TetLabels;
        var sums = new Dictionary<int, double>();
        var counts = new Dictionary<int, long>();
        for (long t = 0; t < labels.LongCount; ++t)
            for (int a = 0; a < 4; ++a)
                for (int b = a + 1; b < 4; ++b) {
                    sums.TryGetValue(labels[t], out double sum);
                    counts.TryGetValue(labels[t], out long count);
                    sums[labels[t]] = sum + Distance(points, tets[4 * t + a], tets[4 * t + b]);
                    counts[labels[t]] = count + 1;
                }
        var means = new Dictionary<int, double>();
        foreach (KeyValuePair<int, double> sum in sums)
            means[sum.Key] = sum.Value / counts[sum.Key];
        return means;
    }

    static double Distance(ArrayView<double> points, long a, long b)
    {
        double square = 0;
        for (int axis = 0; axis < 3; ++axis) {
            double difference = points[3 * a + axis] - points[3 * b + axis];
            square += difference * difference;
        }
        return Math.Sqrt(square);
    }
}
