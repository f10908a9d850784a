using System;
using System.Collections.Generic;
using Cleft;

/// <summary>Wrong use gives C#'s ordinary exceptions.</summary>
sealed class FailuresTest
{
    readonly Mesher mesher = new Mesher();

    void TestDisposedObjects()
    {
        Volume volume = Checks.BallVolume(mesher);
        Mesh mesh = Checks.BallMesh(mesher);
        Sizing sizing = mesher.ConstantSizing(volume, 2);
        Surface surface = mesher.Surface(mesh);
        Mesher other = new Mesher();
        foreach (NativeObject thing in new NativeObject[] { volume, mesh, sizing, surface, other }) {
            Checks.Check(!thing.IsDisposed, "disposed too early");
            thing.Dispose();
            thing.Dispose();
            Checks.Check(thing.IsDisposed, "not disposed");
        }
        foreach (Action body in new Action[] {
            () => volume.Grid.ToString(), () => volume.Labels.ToArray(), () => volume.Sample(0, 0, 0),
            () => mesh.Points.ToArray(), () => mesh.CopyTets(), () => mesh.PointCount.ToString(),
            () => mesh.CopyQuadratic(out int[] tets), () => sizing.Values.ToArray(), () => sizing.At(0, 0, 0),
            () => sizing.HasMetric.ToString(), () => sizing.CopyMetric(),
            () => sizing.ExpectedTets.ToString(), () => surface.HullSides.ToArray(), () => other.Threads.ToString(),
            () => other.Cancel(), () => other.Metrics(), () => other.Threads = 2, () => mesher.Mesh(volume),
            () => mesher.Quality(mesh), () => mesher.Surface(mesh), () => mesher.BackgroundMesh(sizing),
            () => Checks.BallVolume(other), () => MeshFiles.WriteMesh(mesher, mesh, "never.vtu")
        })
            Checks.Thrown<ObjectDisposedException>(body);
    }

    void TestNull()
    {
        Volume volume = Checks.BallVolume(mesher);
        Mesh mesh = Checks.BallMesh(mesher);
        foreach (Action body in new Action[] {
            () => mesher.Labels((byte[])null, Checks.Grid), () => mesher.Labels(new byte[1], null),
            () => mesher.Indicators((double[][])null, Checks.Grid),
            () => mesher.Indicators(new double[][] { null }, Checks.Grid),
            () => mesher.Mesh(null), () => mesher.Sizing(null), () => mesher.ConstantSizing(null, 1),
            () => mesher.BackgroundMesh(null), () => mesher.Cleave(volume, null), () => mesher.Improve(null, mesh),
            () => mesher.Strip(null, null), () => mesher.Quality(null), () => mesher.Validate(null),
            () => mesher.Surface(null),
            () => mesher.Report(volume, null), () => mesher.MeshOf(null, new int[4]),
            () => mesher.MeshOf(new double[3], null),
            () => volume.Sample(null), () => mesher.Sizing(volume, (float[])null),
            () => MeshFiles.ReadMesh(mesher, null),
            () => MeshFiles.ReadMesh(null, "a.vtu"), () => MeshFiles.WriteMesh(mesher, null, "a.vtu"),
            () => MeshFiles.ReadVolume(mesher, (string)null), () => mesh.Points.CopyTo(0, null),
            () => Checks.Grid.WithAffine(null)
        })
            Checks.Thrown<ArgumentNullException>(body);
    }

    void TestWrongLengths()
    {
        Volume volume = Checks.BallVolume(mesher);
        Mesh mesh = Checks.BallMesh(mesher);
        foreach (Action body in new Action[] {
            () => mesher.Labels(new byte[12 * 13 * 14 - 1], Checks.Grid),
            () => mesher.Labels(new short[0], Checks.Grid),
            () => mesher.Indicators(new double[0][], Checks.Grid),
            () => mesher.Indicators(new[] { new double[3] }, Checks.Grid),
            () => mesher.Indicators(new[] { new float[12 * 13 * 14] }, Checks.Grid, new int[1]),
            () => mesher.Sizing(volume, new float[3]), () => volume.Sample(1, 2),
            () => mesher.MetricSizing(volume, new float[12 * 13 * 14]),
            () => mesher.ConstantMetricSizing(volume, new double[9]),
            () => mesher.MeshOf(new double[4], new int[4]), () => mesher.MeshOf(new double[12], new int[5]),
            () => mesher.MeshOf(new double[12], new int[4], new int[2]), () => new Grid(0, 1, 1),
            () => new Grid(1, -1, 1),
            () => new Grid(long.MaxValue, 2, 2), () => Checks.Grid.WithSpacing(1, 0, 1),
            () => Checks.Grid.WithAffine(1, 2, 3),
            () => Checks.Grid.WithSpacing(1, double.NaN, 1), () => Checks.Grid.WithOrigin(double.NaN, 0, 0),
            () => mesh.CopyTets(2), () => mesh.CopyQuadratic(out int[] tets, -1), () => mesh.Points[-1].ToString(),
            () => mesh.Points[mesh.Points.Count].ToString(), () => mesh.Points.CopyTo(1, new double[mesh.Points.Count])
        })
            Checks.Thrown<ArgumentException>(body);
    }

    void TestAnAffineStandsAlone()
    {
        double[] affine = { 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0 };
        Grid grid = new Grid(2, 2, 2);
        foreach (Action body in new Action[] {
            () => grid.WithSpacing(1, 1, 1).WithAffine(affine), () => grid.WithOrigin(0, 0, 0).WithAffine(affine),
            () => grid.WithAffine(affine).WithSpacing(1, 1, 1), () => grid.WithAffine(affine).WithOrigin(0, 0, 0)
        })
            Checks.Thrown<InvalidOperationException>(body);
    }

    void TestWrongNumbers()
    {
        Volume volume = Checks.BallVolume(mesher);
        double[] points = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 };
        double[] values = new double[12 * 13 * 14];
        foreach (Action body in new Action[] {
            () => mesher.ConstantSizing(volume, double.NaN), () => mesher.ConstantSizing(volume, 0),
            () => mesher.Sizing(volume, values), () => volume.Sample(0, double.NaN, 0),
            () => mesher.ConstantSizing(volume, 1).At(double.NaN, 0, 0), () => mesher.Threads = -1,
            () => mesher.MeshOf(points, new[] { 0, 1, 2, 4 }), () => mesher.MeshOf(points, new[] { 0, 1, 2, -1 }),
            () => mesher.MeshOf(new[] { 0, 0, double.NaN }, new int[0]),
            () => mesher.Labels(Checks.BallLabels(), Checks.Grid.WithAffine(new double[12]))
        })
            Checks.Thrown<InvalidArgumentException>(body);
        values[5] = double.NaN;
        Checks.Thrown<NotFiniteException>(() => mesher.Indicators(new[] { values }, Checks.Grid));
    }

    void TestStrict()
    {
        byte[] labels = new byte[8000];
        labels[10 + 20 * (10 + 20 * 10)] = 1;
        Volume volume = mesher.Labels(labels, new Grid(20, 20, 20));
        var lost = Checks.Thrown<LabelLostException>(() => mesher.Mesh(volume, new Options {
            Background = Background.Lattice, Size = 8, Improve = Improvement.Off, Snap = Snap.None, Strict = true }));
        Checks.Equal(-12, lost.Status);
        Checks.Check(lost.Message.Length > 10, "no sentence");
    }

    void TestDisposingUnderACall()
    {
        Volume volume = Checks.SlowVolume(mesher);
        mesher.Progress = (fraction, stage) => {
            volume.Dispose();
            mesher.Dispose();
            return fraction < 0.3;
        };
        Checks.Thrown<CancelledException>(() => mesher.Mesh(volume));
        Checks.Thrown<ObjectDisposedException>(() => volume.Grid.ToString());
    }

    /// <summary>Who gives a wrong argument gets its name, in the exception and in its sentence.</summary>
    void TestNamesOfArguments()
    {
        Volume volume = Checks.BallVolume(mesher);
        Mesh mesh = Checks.BallMesh(mesher);
        byte[] labels = Checks.BallLabels();
        var raw = new RawVoxels { Dims = new long[] { 1, 1, 1 } };
        int voxels = labels.Length;
        var wrong = new Dictionary<string, Action[]> {
            ["nx"] = new Action[] { () => new Grid(0, 1, 1) },
            ["ny"] = new Action[] { () => new Grid(1, -1, 1), () => new Grid(long.MaxValue, 2, 1) },
            ["nz"] = new Action[] { () => new Grid(1, 1, 0), () => new Grid(long.MaxValue, 1, 2) },
            ["x"] = new Action[] { () => Checks.Grid.WithSpacing(0, 1, 1),
                () => Checks.Grid.WithOrigin(double.NaN, 0, 0) },
            ["y"] = new Action[] { () => Checks.Grid.WithSpacing(1, double.NaN, 1) },
            ["z"] = new Action[] { () => Checks.Grid.WithOrigin(0, 0, double.PositiveInfinity) },
            ["rows"] = new Action[] { () => Checks.Grid.WithAffine(1, 2), () => Checks.Grid.WithAffine(null) },
            ["voxels"] = new Action[] {
                () => mesher.Labels((byte[])null, Checks.Grid), () => mesher.Labels(new int[1], Checks.Grid),
                () => mesher.Labels(IntPtr.Zero, VoxelType.UInt8, Checks.Grid) },
            ["grid"] = new Action[] { () => mesher.Labels(labels, null),
                () => mesher.Indicators(new[] { new double[1] }, null) },
            ["type"] = new Action[] {
                () => mesher.Labels(new IntPtr(8), VoxelType.Float32, Checks.Grid),
                () => mesher.Labels(new IntPtr(8), (VoxelType)99, Checks.Grid) },
            ["fields"] = new Action[] {
                () => mesher.Indicators((float[][])null, Checks.Grid),
                () => mesher.Indicators(new float[0][], Checks.Grid),
                () => mesher.Indicators(new[] { new float[voxels], null }, Checks.Grid),
                () => mesher.Indicators(new[] { new float[voxels], new float[3] }, Checks.Grid) },
            ["labels"] = new Action[] {
                () => mesher.Indicators(new[] { new float[voxels] }, Checks.Grid, new int[3]),
                () => mesher.MeshOf(new double[12], new int[4], new int[2]) },
            ["values"] = new Action[] {
                () => mesher.Sizing(volume, (double[])null), () => mesher.Sizing(volume, new float[3]) },
            ["tensors"] = new Action[] {
                () => mesher.MetricSizing(volume, (double[])null), () => mesher.MetricSizing(volume, new float[3]) },
            ["tensor"] = new Action[] {
                () => mesher.ConstantMetricSizing(volume, null),
                () => mesher.ConstantMetricSizing(volume, new double[9]) },
            ["points"] = new Action[] {
                () => mesher.MeshOf(null, new int[4]), () => mesher.MeshOf(new double[2], new int[4]),
                () => volume.Sample(1) },
            ["tets"] = new Action[] { () => mesher.MeshOf(new double[12], null),
                () => mesher.MeshOf(new double[12], new int[5]) },
            ["indexBase"] = new Action[] {
                () => mesher.MeshOf(new double[12], new int[4], null, 2), () => mesh.CopyTets(-1),
                () => mesh.CopyQuadratic(out int[] tets, 2) },
            ["volume"] = new Action[] { () => mesher.Mesh(null), () => mesher.Report(null, mesh),
                () => mesher.Sizing(null) },
            ["mesh"] = new Action[] { () => mesher.Quality(null), () => MeshFiles.WriteMesh(mesher, null, "a.vtu") },
            ["background"] = new Action[] { () => mesher.Cleave(volume, null) },
            ["cleaved"] = new Action[] { () => mesher.Improve(volume, null) },
            ["whole"] = new Action[] { () => mesher.Strip(null, null) },
            ["sizing"] = new Action[] { () => mesher.BackgroundMesh(null), () => mesher.MetricQuality(mesh, null),
                () => MeshFiles.WriteSizing(mesher, null, "a.nrrd") },
            ["mesher"] = new Action[] { () => MeshFiles.ReadMesh(null, "a.vtu"),
                () => MeshFiles.ReadVolume(null, "a.nrrd") },
            ["path"] = new Action[] {
                () => MeshFiles.ReadMesh(mesher, null), () => MeshFiles.ReadVolume(mesher, (string)null),
                () => MeshFiles.Guess(null), () => MeshFiles.ReadMesh(mesher, "a\0b.vtu"),
                () => MeshFiles.ReadMesh(mesher, "half a \ud83d.vtu") },
            ["paths"] = new Action[] { () => MeshFiles.ReadVolume(mesher, new[] { "a.nrrd", null }) },
            ["raw"] = new Action[] { () => MeshFiles.ReadRaw(mesher, null, null, "a.raw") },
            ["format"] = new Action[] { () => MeshFiles.WriteMesh(mesher, mesh, "a.vtu", "jpeg") },
            ["world"] = new Action[] {
                () => MeshFiles.WriteSizing(mesher, mesher.ConstantSizing(volume, 1), "a.nrrd", (World)7) },
            ["order"] = new Action[] { () => MeshFiles.ReadMetric(mesher, null, "a.nrrd", (TensorOrder)7) },
            ["name"] = new Action[] { () => volume.SetLabelName(0, null), () => new Options().Set(null, "1"),
                () => volume.SetLabelName(1, "half a \ud83d") },
            ["value"] = new Action[] { () => new Options().Set("size", null), () => new Options().Set("size", "1\0") },
            ["Strip"] = new Action[] { () => new Options().Strip = null },
            ["Only"] = new Action[] { () => new Options().Only = null },
            ["Dims"] = new Action[] {
                () => MeshFiles.ReadRaw(mesher, new RawVoxels(), null, "a.raw"),
                () => MeshFiles.ReadRaw(mesher, new RawVoxels { Dims = new long[] { 1, 0, 1 } }, null, "a.raw") },
            ["Skip"] = new Action[] {
                () => MeshFiles.ReadRaw(mesher, new RawVoxels { Dims = raw.Dims, Skip = -1 }, null, "a.raw") },
            ["Type"] = new Action[] {
                () => MeshFiles.ReadRaw(mesher, new RawVoxels { Dims = raw.Dims, Type = 0 }, null, "a.raw") },
            ["Spacing"] = new Action[] {
                () => MeshFiles.ReadVolume(mesher, "a.nrrd", null, new Reading { Spacing = new double[2] }),
                () => MeshFiles.ReadVolume(mesher, "a.nrrd", null, new Reading { Spacing = new[] { 0, -1.0, 0 } }),
                () => MeshFiles.ReadRaw(
                    mesher, new RawVoxels { Dims = raw.Dims, Spacing = new[] { 1.0 } }, null, "a.raw") },
            ["Scale"] = new Action[] { () => MeshFiles.ReadVolume(mesher, "a.nrrd", null, new Reading { Scale = 0 }) },
            ["World"] = new Action[] {
                () => MeshFiles.ReadVolume(mesher, "a.nrrd", null, new Reading { World = (World)5 }) },
            ["Kind"] = new Action[] {
                () => MeshFiles.ReadVolume(mesher, "a.nrrd", null, new Reading { Kind = (VoxelKind)5 }),
                () => MeshFiles.ReadRaw(mesher, new RawVoxels { Dims = raw.Dims, Kind = (VoxelKind)5 }, null, "a.raw") }
        };
        foreach (KeyValuePair<string, Action[]> entry in wrong)
            foreach (Action body in entry.Value) {
                var thrown = Checks.Thrown<ArgumentException>(body);
                Checks.Equal(entry.Key, thrown.ParamName);
                Checks.Check(thrown.Message.Contains(entry.Key), thrown.Message);
            }
    }

    /// <summary>Options are called in sentences as in C#, but names of files are left alone.</summary>
    void TestNamesOfOptions()
    {
        Volume volume = Checks.BallVolume(mesher);
        foreach (var wrong in new Dictionary<string, Action> {
            ["SizeMax is -1"] = () => new Options { SizeMax = -1 }.Dispose(),
            ["Size is "] = () => new Options { Size = double.NaN }.Dispose(),
            ["SizeMax is 2, less than SizeMin"] = () => mesher.Mesh(volume, new Options { SizeMin = 3, SizeMax = 2 }),
            ["Strip would leave"] = () => mesher.Mesh(volume, new Options { Strip = volume.Labels.ToArray() }),
            ["Only would leave"] = () => mesher.Mesh(volume, new Options { Only = new[] { 99 } }),
            ["the size of label 3 is -1"] = () => new Options().SetLabelSize(3, -1),
            ["Threads is 2000"] = () => mesher.Threads = 2000,
            ["size_max is not a number"] = () => new Options().Set("size_max", "x"),
            ["'/no/size_max.vtu'"] = () => MeshFiles.ReadMesh(mesher, "/no/size_max.vtu")
        }) {
            var thrown = Checks.Thrown<CleftException>(wrong.Value);
            Checks.Check(thrown.Message.Contains(wrong.Key), thrown.Message);
        }
    }
}
