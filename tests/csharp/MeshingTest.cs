using System;
using System.Linq;
using System.Runtime.InteropServices;
using System.Threading;
using Cleft;

/// <summary>The stages and what can be asked of their results.</summary>
sealed class MeshingTest
{
    readonly Mesher mesher = new Mesher();

    void TestMeshIsSound()
    {
        Mesh mesh = Checks.BallMesh(mesher);
        Validation found = mesher.Validate(mesh, true);
        Checks.Check(found.IsValid && found.FirstFault == "", found.FirstFault);
        Checks.Equal(new[] { 0, 1, 7 }, mesh.Labels.ToArray());
        Checks.Near(12 * 13 * 14, mesher.Quality(mesh).TotalVolume, 1e-12);
        Checks.Equal(mesh.Points.ToArray(), mesh.CopyPoints());
        Checks.Equal(mesh.Tets.ToArray(), mesh.CopyTets());
        Checks.Equal(mesh.TetLabels.ToArray(), mesh.CopyTetLabels());
        Checks.Check(mesh.Tets.All(point => point >= 0 && point < mesh.PointCount), "corners");
    }

    void TestWords()
    {
        Volume volume = Checks.BallVolume(mesher);
        Mesh mesh = Checks.BallMesh(mesher);
        Checks.Equal("Volume of 12 x 13 x 14 voxels, 3 labels", volume.ToString());
        Checks.Equal("Grid of 12 x 13 x 14 voxels", volume.Grid.ToString());
        Checks.Equal($"Mesh of {mesh.PointCount} points, {mesh.TetCount} tetrahedra, 3 labels", mesh.ToString());
        Checks.Equal("Mesher of 1 threads", mesher.ToString());
        Checks.Equal("Validation: nothing is wrong", mesher.Validate(mesh).ToString());
        foreach (object thing in new object[] {
            mesher.Sizing(volume), mesher.Surface(mesh), mesher.Quality(mesh), mesher.Report(volume, mesh)[0] })
            Checks.Check(thing.ToString().StartsWith(thing.GetType().Name + " of "), thing.ToString());
    }

    void TestVoxelsOfAnyType()
    {
        byte[] labels = Checks.BallLabels();
        Mesh wanted = Checks.BallMesh(mesher);
        IntPtr memory = Marshal.AllocHGlobal(labels.Length);
        Marshal.Copy(labels, 0, memory, labels.Length);
        foreach (Volume volume in new[] {
            mesher.Labels(Array.ConvertAll(labels, label => (short)label), Checks.Grid),
            mesher.Labels(Array.ConvertAll(labels, label => (ushort)label), Checks.Grid),
            mesher.Labels(Array.ConvertAll(labels, label => (int)label), Checks.Grid),
            mesher.Labels(Array.ConvertAll(labels, label => (uint)label), Checks.Grid),
            mesher.Labels(memory, VoxelType.UInt8, Checks.Grid)
        })
            Checks.Check(Checks.Same(wanted, mesher.Mesh(volume, Checks.Quick())), "another mesh");
        Marshal.FreeHGlobal(memory);
        int[] extremes = Array.ConvertAll(labels, label => label == 7 ? int.MinValue : int.MaxValue);
        Checks.Equal(new[] { int.MinValue, int.MaxValue }, mesher.Labels(extremes, Checks.Grid).Labels.ToArray());
    }

    void TestWorld()
    {
        Grid grid = Checks.Grid.WithSpacing(0.5, 1, 2).WithOrigin(10, 20, 30);
        Volume volume = mesher.Labels(Checks.BallLabels(), grid);
        Checks.Equal(grid.Affine, volume.Grid.Affine);
        Checks.Equal(new long[] { 12, 13, 14 }, volume.Grid.Dims);
        Checks.Equal(new[] { 7, 1 }, volume.Sample(10 + 0.5 * 11, 20, 30, 10 + 0.5 * 5, 26, 30 + 2 * 7));
        Checks.Equal(new[] { 1, 0, 0, 0.5, 0, 1, 0, 0.5, 0, 0, 1, 0.5 }, Checks.BallVolume(mesher).Grid.Affine);
        double[] affine = { 0, -2, 0, 5, 1, 0, 0, 6, 0, 0, 3, 7 };
        Checks.Equal(affine, mesher.Labels(Checks.BallLabels(), Checks.Grid.WithAffine(affine)).Grid.Affine);
    }

    void TestStagesByHand()
    {
        Volume volume = Checks.BallVolume(mesher);
        Options options = Checks.Quick();
        Sizing sizing = mesher.Sizing(volume, options);
        Mesh background = mesher.BackgroundMesh(sizing, options);
        Checks.Equal(new[] { 0 }, background.Labels.ToArray());
        Mesh improved = mesher.Improve(volume, mesher.Cleave(volume, background, options), options);
        Checks.Check(mesher.Validate(improved, true).IsValid, "not valid");
        Checks.Equal(improved.TetCount, mesher.Mesh(volume, sizing, background, options).TetCount);
        Checks.Equal(new[] { 1, 7 }, mesher.Strip(improved, new Options { Strip = new[] { 0 } }).Labels.ToArray());
        Checks.Equal(new[] { 1 }, mesher.Strip(improved, new Options { Only = new[] { 1 } }).Labels.ToArray());
    }

    void TestTheOneCallIsTheFiveCalls()
    {
        double[] affine = { 0.7, 0.1, 0, -3.1, 0.2, -0.9, 0.3, 100.3, 0.1, 0, 1.3, 7.7 };
        Volume volume = mesher.Labels(Checks.BallLabels(), Checks.Grid.WithAffine(affine));
        Sizing own = mesher.Sizing(
            volume, Enumerable.Range(0, 12 * 13 * 14).Select(i => 1.5f + 0.1f * (i % 12)).ToArray());
        foreach (Background kind in Enum.GetValues(typeof(Background))) {
            SameByStages(volume, null, new Options { Background = kind });
            SameByStages(volume, null, new Options { Background = kind, Tets = 3000, Strip = new[] { 0 } });
            SameByStages(volume, own, new Options { Background = kind, Strict = true, Strip = new[] { 0 } });
        }
    }

    void SameByStages(Volume volume, Sizing given, Options options)
    {
        Mesh background = mesher.BackgroundMesh(given ?? mesher.Sizing(volume, options), options);
        Mesh improved = mesher.Improve(volume, mesher.Cleave(volume, background, options), options);
        Mesh stages = mesher.Strip(improved, options), whole = mesher.Mesh(volume, given, null, options);
        Checks.Equal(whole.CopyPoints(), stages.CopyPoints());
        Checks.Equal(whole.CopyTets(), stages.CopyTets());
        Checks.Equal(whole.CopyTetLabels(), stages.CopyTetLabels());
    }

    void TestEstimate()
    {
        Volume volume = Checks.BallVolume(mesher);
        Options options = new Options { Background = Background.Octree, Size = 1 };
        Estimate estimate = mesher.Estimate(volume, options: options);
        double tets = mesher.Mesh(volume, options).TetCount;
        Checks.Near(tets, estimate.Tets, 0.15);
        Checks.Check(estimate.PeakBytes > 100 * tets, "memory");
        Mesh own = mesher.BackgroundMesh(mesher.ConstantSizing(volume, 2));
        Checks.Near(own.TetCount, mesher.Estimate(volume, background: own).BackgroundTets, 0);
    }

    void TestSizing()
    {
        Volume volume = Checks.BallVolume(mesher);
        Checks.Near(2.5, mesher.ConstantSizing(volume, 2.5).At(6, 6, 6), 1e-6);
        float[] wanted = Enumerable.Range(0, 12 * 13 * 14).Select(i => i < 1000 ? 1.5f : 3).ToArray();
        Sizing sizing = mesher.Sizing(volume, wanted);
        Checks.Equal(wanted, sizing.Values.ToArray());
        double[] doubles = Array.ConvertAll(wanted, value => (double)value);
        Checks.Equal(wanted, mesher.Sizing(volume, doubles).Values.ToArray());
        Checks.Equal(volume.Grid.Affine, sizing.Grid.Affine);
        Checks.Check(sizing.ExpectedTets > 100, "expected");
        Sizing both = mesher.Sizing(volume, wanted, true, new Options { Size = 2 });
        Checks.Check(both.Values.All(value => value <= 2), "combined");
    }

    void TestMetric()
    {
        Volume volume = Checks.BallVolume(mesher);
        double[] tensors = Enumerable.Range(0, 6 * 12 * 13 * 14)
            .Select(i => new[] { 0.2 + 1e-4 * i, 0.01, -0.02, 0.3, 0.03, 0.5 }[i % 6]).ToArray();
        float[] floats = Array.ConvertAll(tensors, value => (float)value);
        foreach (Sizing sizing in new[] { mesher.MetricSizing(volume, tensors), mesher.MetricSizing(volume, floats) }) {
            Checks.Check(sizing.HasMetric, "it has a metric");
            float[] metric = sizing.CopyMetric();
            Checks.Equal(tensors.Length, metric.Length);
            Checks.Check(metric.Zip(tensors, (a, b) => Math.Abs(a - b)).Max() < 1e-5, "tensors come back");
        }
        float[] bounded = mesher.MetricSizing(volume, tensors, true, new Options { SizeMax = 0.5 }).CopyMetric();
        Checks.Near(4, bounded[0], 1e-5);
        Sizing flat = mesher.ConstantMetricSizing(volume, new[] { 1.0 / 9, 0, 0, 1.0 / 9, 0, 1 });
        Checks.Near(1, flat.CopyMetric()[5], 1e-6);
        Mesh mesh = mesher.Mesh(volume, flat, null, Checks.Quick());
        MetricQuality quality = mesher.MetricQuality(mesh, flat);
        Checks.Equal(mesh.TetCount, quality.TetCount);
        Checks.Equal(6 * mesh.TetCount, quality.DihedralHistogram.Sum());
        Checks.Check(quality.EdgesInRange > 0 && quality.EdgesInRange <= quality.EdgeCount, "edges in range");
        Checks.Check(0 < quality.EdgeLeast && quality.EdgeLeast < 1 && quality.EdgeGreatest > 1, "lengths");
        Sizing plain = mesher.ConstantSizing(volume, 2);
        Checks.Check(!plain.HasMetric, "sizes alone");
        Checks.Thrown<InvalidArgumentException>(() => plain.CopyMetric());
        Checks.Thrown<InvalidArgumentException>(() => mesher.MetricQuality(mesh, plain));
    }

    void TestIndicators()
    {
        double[] inside = Enumerable.Range(0, 12 * 13 * 14).Select(i => 5.5 - i % 12).ToArray();
        double[] outside = Array.ConvertAll(inside, value => -value);
        float[] single = Array.ConvertAll(inside, value => (float)value);
        Checks.Equal(new[] { 0, 1 }, mesher.Indicators(new[] { single }, Checks.Grid).Labels.ToArray());
        Volume volume = mesher.Indicators(new[] { inside, outside }, Checks.Grid, new[] { 40, -3 });
        Checks.Equal(new[] { -3, 40 }, mesher.Mesh(volume, Checks.Quick()).Labels.ToArray());
    }

    void TestReport()
    {
        Volume volume = Checks.BallVolume(mesher);
        var rows = mesher.Report(volume, mesher.Mesh(volume, Checks.Quick()));
        Checks.Equal(new[] { 0, 1, 7 }, rows.Select(row => row.Label).ToArray());
        Checks.Check(rows.All(row => !row.Lost && volume.VoxelCounts[row.Label] == row.Voxels), "rows");
        Checks.Near(12 * 13 * 14, rows.Sum(row => row.MeshVolume), 1e-12);
    }

    void TestQuality()
    {
        Mesh mesh = Checks.BallMesh(mesher);
        Quality quality = mesher.Quality(mesh);
        Checks.Equal(mesh.TetCount, quality.TetCount);
        Checks.Equal(6 * mesh.TetCount, quality.DihedralHistogram.Sum());
        Checks.Check(0 < quality.MinDihedral && quality.MinDihedral < 60 && quality.MaxDihedral < 180, "angles");
    }

    void TestSurface()
    {
        Mesh mesh = Checks.BallMesh(mesher);
        Surface surface = mesher.Surface(mesh);
        mesh.Dispose();
        Checks.Equal(surface.InterfaceTriangles.Count / 3, surface.InterfaceLabels.Count / 2);
        Checks.Equal(surface.HullTriangles.Count / 3, surface.HullLabels.Count);
        Checks.Equal(6, surface.HullSides.Select(side => (Side)side).Distinct().Count());
    }

    void TestArraysThereAndBack()
    {
        Mesh mesh = Checks.BallMesh(mesher);
        Mesh again = mesher.MeshOf(mesh.CopyPoints(), mesh.CopyTets(1), mesh.CopyTetLabels(), 1);
        Checks.Check(Checks.Same(mesh, again), "another mesh");
        Checks.Equal(new[] { 0 }, mesher.MeshOf(mesh.CopyPoints(), mesh.CopyTets()).Labels.ToArray());
        Validation found = mesher.Validate(
            mesher.MeshOf(new double[] { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 }, new[] { 1, 0, 2, 3 }));
        Checks.Check(!found.IsValid && found.NegativeTets == 1 && found.FirstFault != "", found.FirstFault);
    }

    void TestQuadratic()
    {
        Mesh mesh = Checks.BallMesh(mesher);
        double[] points = mesh.CopyQuadratic(out int[] tets);
        Checks.Equal(10 * mesh.TetCount, (long)tets.Length);
        Checks.Near((points[3 * tets[0]] + points[3 * tets[1]]) / 2 + 1, points[3 * tets[4]] + 1, 1e-12);
        mesh.CopyQuadratic(out int[] fromOne, 1);
        Checks.Equal(tets[0] + 1, fromOne[0]);
    }

    void TestThreads()
    {
        Volume volume = Checks.BallVolume(mesher);
        Mesh one = mesher.Mesh(volume, Checks.Quick());
        mesher.Threads = 2;
        Checks.Equal(2, mesher.Threads);
        Checks.Check(Checks.Same(one, mesher.Mesh(volume, Checks.Quick())), "another mesh");
        bool[] same = new bool[4];
        Thread[] threads = Enumerable.Range(0, 4).Select(n => new Thread(() =>
            same[n] = Checks.Same(one, new Mesher().Mesh(volume, Checks.Quick())))).ToArray();
        foreach (Thread thread in threads)
            thread.Start();
        foreach (Thread thread in threads)
            thread.Join();
        Checks.Check(same.All(yes => yes), "another mesh in a thread");
    }

    void TestMetricsAndVersion()
    {
        Checks.BallMesh(mesher).Dispose();
        Checks.Check(mesher.Metrics().Count > 3, "no figures");
        mesher.ClearMetrics();
        Checks.Equal(0, mesher.Metrics().Count);
        Checks.Equal(3, Library.Version.Split('.').Length);
    }

    void TestNamesOfLabels()
    {
        Volume volume = Checks.BallVolume(mesher).SetLabelName(1, "Herz \u2764 \ud83d\ude00").SetLabelName(7, "slab");
        Checks.Equal("", volume.LabelName(0));
        Checks.Equal("", volume.LabelName(99));
        Checks.Check(
            volume.LabelNames.Count == 2 && volume.LabelNames[1] == "Herz \u2764 \ud83d\ude00", "names of the volume");
        Mesh mesh = mesher.Mesh(volume, Checks.Quick());
        Checks.Check(
            mesh.LabelNames.OrderBy(row => row.Key).SequenceEqual(volume.LabelNames.OrderBy(row => row.Key)), "names");
        Mesh slab = mesher.Strip(mesh, new Options { Only = new[] { 7 } });
        Checks.Check(slab.LabelNames.Count == 1 && slab.LabelName(7) == "slab", "names of the stripped mesh");
        mesh.SetLabelName(1, "").SetLabelName(0, "outside");
        Checks.Check(
            mesh.LabelNames.Count == 2 && mesh.LabelName(0) == "outside" && mesh.LabelName(1) == "", "set names");
        foreach (Action body in new Action[] {
            () => volume.SetLabelName(5, "five"), () => mesh.SetLabelName(5, "five"),
            () => mesh.SetLabelName(0, "two\nlines") })
            Checks.Thrown<InvalidArgumentException>(body);
    }

    /// <summary>
    /// No label is special: not -1, nor the extremes of 32 bits, in any place where a label can be given or asked for.
    /// </summary>
    void TestAnyLabels()
    {
        Mesh wanted = Checks.BallMesh(mesher);
        Volume ball = Checks.BallVolume(mesher);
        byte[] old = { 0, 1, 7 };
        foreach (int[] names in new[] {
            new[] { -1, 5, 9 }, new[] { -3, -1, 0 }, new[] { int.MinValue, -1, int.MaxValue },
            new[] { int.MinValue, int.MinValue + 1, -1 }, new[] { 0, int.MaxValue - 1, int.MaxValue } }) {
            int[] labels = Array.ConvertAll(Checks.BallLabels(), label => names[Array.IndexOf(old, label)]);
            Volume volume = mesher.Labels(labels, Checks.Grid);
            Checks.Equal(names, volume.Labels.ToArray());
            Checks.Equal(new[] { names[2], names[1] }, volume.Sample(11.5, 0.5, 0.5, 5.5, 6.5, 7.5));
            Mesh mesh = mesher.Mesh(volume, Checks.Quick());
            Checks.Equal(names, mesh.Labels.ToArray());
            Checks.Equal(wanted.CopyPoints(), mesh.CopyPoints());
            Checks.Equal(wanted.CopyTets(), mesh.CopyTets());
            int[] renamed = Array.ConvertAll(wanted.CopyTetLabels(), label => names[Array.IndexOf(old, (byte)label)]);
            Checks.Equal(renamed, mesh.CopyTetLabels());
            Checks.Equal(renamed, mesh.TetLabels.ToArray());
            Checks.Equal("minus one", mesh.SetLabelName(names[1], "minus one").LabelNames[names[1]]);
            Checks.Equal(names, mesher.MeshOf(mesh.CopyPoints(), mesh.CopyTets(), renamed).Labels.ToArray());
            Checks.Check(mesher.Validate(mesh, true).IsValid, "not valid");
            Surface surface = mesher.Surface(mesh), same = mesher.Surface(wanted);
            Checks.Equal(same.InterfaceTriangles.ToArray(), surface.InterfaceTriangles.ToArray());
            Checks.Equal(same.HullSides.ToArray(), surface.HullSides.ToArray());
            Validation found = mesher.Validate(mesh, true);
            Checks.Equal(3 * found.InterfaceTriangles, surface.InterfaceTriangles.LongCount);
            Checks.Equal(3 * found.HullTriangles, surface.HullTriangles.LongCount);
            for (int m = 0; m < 3; ++m) {
                Checks.Equal(
                    new[] { names[m] }, mesher.Strip(mesh, new Options { Only = new[] { names[m] } }).Labels.ToArray());
                Checks.Equal(2, mesher.Strip(mesh, new Options { Strip = new[] { names[m] } }).Labels.Count);
                LabelReport row = mesher.Report(volume, mesh)[m];
                Checks.Check(row.Label == names[m] && row.Voxels == volume.VoxelCounts[names[m]], row.ToString());
                Func<int, Options> fine = label =>
                    new Options { Background = Background.Lattice, SizeMax = 4 }.SetLabelSize(label, 0.7);
                Checks.Equal(
                    mesher.Sizing(ball, fine(old[m])).Values.ToArray(),
                    mesher.Sizing(volume, fine(names[m])).Values.ToArray());
            }
        }
    }

    void TestContacts()
    {
        mesher.Log = null;
        foreach (int[] names in new[] { new[] { 1, 0, 2 }, new[] { -2, 5, int.MaxValue }, new[] { int.MinValue, 0, 9 },
                                        new[] { -1, 0, 3 }, new[] { -9, -1, 4 }, new[] { -9, 2, -1 } }) {
            int[] labels = Enumerable.Range(0, 20 * 20 * 20)
                .Select(v => v % 20 < 10 ? names[0] : v % 20 == 10 ? names[1] : names[2]).ToArray();
            Volume volume = mesher.Labels(labels, new Grid(20, 20, 20));
            Mesh coarse = mesher.Mesh(volume, new Options { Background = Background.Lattice, Size = 6 });
            int[] pairs = mesher.Surface(coarse).InterfaceLabels.ToArray();
            long triangles = Enumerable.Range(0, pairs.Length / 2)
                .LongCount(i => pairs[2 * i] == names[0] && pairs[2 * i + 1] == names[2]);
            Report report = mesher.Report(volume, coarse);
            Checks.Check(triangles > 0 && report.Contacts.Count == 1 && report.Count == 3, report.ToString());
            Contact contact = report.Contacts[0];
            Checks.Check(
                contact.First == names[0] && contact.Second == names[2] && contact.Triangles == triangles,
                contact.ToString());
            Checks.Equal(0, report.Distances.Count);
            Distance distance = mesher.Report(volume, coarse, true).Distances
                .Single(d => !d.IsLine && d.First == names[0] && d.Second == names[2]);
            Checks.Check(distance.Elements == triangles && distance.MeshGreatest > 0, distance.ToString());
            Mesh fine = mesher.Mesh(volume, new Options { Background = Background.Lattice, Size = 1 });
            Checks.Equal(0, mesher.Report(volume, fine).Contacts.Count);
        }
    }
}
