using System;
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
            () => mesher.Indicators((double[][])null, Checks.Grid), () => mesher.Indicators(new double[][] { null }, Checks.Grid),
            () => mesher.Mesh(null), () => mesher.Sizing(null), () => mesher.ConstantSizing(null, 1),
            () => mesher.BackgroundMesh(null), () => mesher.Cleave(volume, null), () => mesher.Improve(null, mesh),
            () => mesher.Strip(null, null), () => mesher.Quality(null), () => mesher.Validate(null), () => mesher.Surface(null),
            () => mesher.Report(volume, null), () => mesher.MeshOf(null, new int[4]), () => mesher.MeshOf(new double[3], null),
            () => volume.Sample(null), () => mesher.Sizing(volume, (float[])null), () => MeshFiles.ReadMesh(mesher, null),
            () => MeshFiles.ReadMesh(null, "a.vtu"), () => MeshFiles.WriteMesh(mesher, null, "a.vtu"),
            () => MeshFiles.ReadVolume(mesher, (string)null), () => mesh.Points.CopyTo(0, null), () => Checks.Grid.WithAffine(null)
        })
            Checks.Thrown<ArgumentNullException>(body);
    }

    void TestWrongLengths()
    {
        Volume volume = Checks.BallVolume(mesher);
        Mesh mesh = Checks.BallMesh(mesher);
        foreach (Action body in new Action[] {
            () => mesher.Labels(new byte[12 * 13 * 14 - 1], Checks.Grid), () => mesher.Labels(new short[0], Checks.Grid),
            () => mesher.Indicators(new double[0][], Checks.Grid),
            () => mesher.Indicators(new[] { new double[3] }, Checks.Grid),
            () => mesher.Indicators(new[] { new float[12 * 13 * 14] }, Checks.Grid, new int[1]),
            () => mesher.Sizing(volume, new float[3]), () => volume.Sample(1, 2),
            () => mesher.MeshOf(new double[4], new int[4]), () => mesher.MeshOf(new double[12], new int[5]),
            () => mesher.MeshOf(new double[12], new int[4], new int[2]), () => new Grid(0, 1, 1), () => new Grid(1, -1, 1),
            () => new Grid(long.MaxValue, 2, 2), () => Checks.Grid.WithSpacing(1, 0, 1), () => Checks.Grid.WithAffine(1, 2, 3),
            () => Checks.Grid.WithSpacing(1, double.NaN, 1), () => Checks.Grid.WithOrigin(double.NaN, 0, 0),
            () => mesh.CopyTets(2), () => mesh.CopyQuadratic(out int[] tets, -1), () => mesh.Points[-1].ToString(),
            () => mesh.Points[mesh.Points.Count].ToString(), () => mesh.Points.CopyTo(1, new double[mesh.Points.Count])
        })
            Checks.Thrown<ArgumentException>(body);
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
            () => mesher.MeshOf(points, new[] { 0, 1, 2, 3 }, null, 2),
            () => mesher.MeshOf(new[] { 0, 0, double.NaN }, new int[0]),
            () => mesher.Labels(Checks.BallLabels(), Checks.Grid.WithAffine(new double[12])),
            () => mesher.Labels(IntPtr.Zero, VoxelType.UInt8, Checks.Grid)
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
}
