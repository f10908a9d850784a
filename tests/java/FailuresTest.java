import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.cleft.*;

/** Wrong use gives Java's ordinary exceptions. */
final class FailuresTest {
    private final Mesher mesher = new Mesher();

    public static void main(String[] arguments) throws Exception {
        Checks.runAll(FailuresTest.class);
    }

    void testClosedObjects() {
        Volume volume = Checks.ballVolume(mesher);
        Mesh mesh = Checks.ballMesh(mesher);
        Sizing sizing = mesher.constantSizing(volume, 2);
        Surface surface = mesher.surface(mesh);
        Mesher other = new Mesher();
        for (NativeObject object : new NativeObject[] {volume, mesh, sizing, surface, other}) {
            Checks.check(!object.isClosed(), "closed too early");
            object.close();
            object.close();
            Checks.check(object.isClosed(), "not closed");
        }
        for (Checks.Body body : new Checks.Body[] {
            volume::dims, volume::labels, volume::voxelCounts, () -> volume.sample(0, 0, 0), mesh::points,
            mesh::pointsView,
            mesh::labels, () -> mesh.quadratic(0), sizing::values, sizing::hasMetric, sizing::metric,
            () -> sizing.at(0, 0, 0), sizing::expectedTets,
            surface::hullSides, other::threads, other::cancel, other::metrics, () -> other.threads(2),
            () -> mesher.mesh(volume, null), () -> mesher.quality(mesh), () -> mesher.surface(mesh),
            () -> mesher.background(sizing, null), () -> Checks.ballVolume(other)
        })
            Checks.thrown(IllegalStateException.class, body);
    }

    void testNull() {
        Volume volume = Checks.ballVolume(mesher);
        Mesh mesh = Checks.ballMesh(mesher);
        for (Checks.Body body : new Checks.Body[] {
            () -> mesher.labels((byte[]) null, Checks.GRID, null), () -> mesher.labels(new byte[1], null, null),
            () -> mesher.labels((ByteBuffer) null, VoxelType.UINT8, Checks.GRID, null),
            () -> mesher.indicators((double[][]) null, Checks.GRID, null),
            () -> mesher.indicators(new double[][] {null}, Checks.GRID, null), () -> mesher.mesh(null, null),
            () -> mesher.sizing(null, null), () -> mesher.constantSizing(null, 1), () -> mesher.background(null, null),
            () -> mesher.cleave(volume, null, null), () -> mesher.improve(null, mesh, null),
            () -> mesher.strip(null, null), () -> mesher.quality(null), () -> mesher.validate(null, true),
            () -> mesher.surface(null), () -> mesher.report(volume, null),
            () -> mesher.meshOf(null, new int[4], null, 0),
            () -> mesher.meshOf(new double[3], null, null, 0), () -> volume.sample((double[]) null),
            () -> mesher.sizing(volume, (float[]) null, false, null),
            () -> mesher.metricSizing(volume, (float[]) null, false, null),
            () -> mesher.metricSizing(null, new double[6], false, null),
            () -> mesher.metricQuality(mesh, null), () -> mesher.metricQuality(null, mesher.constantSizing(volume, 1)),
            () -> mesher.constantMetricSizing(volume, null), () -> mesher.constantMetricSizing(null, new double[6])
        })
            Checks.thrown(NullPointerException.class, body);
    }

    void testWrongLengths() {
        Volume volume = Checks.ballVolume(mesher);
        double[] points = new double[12];
        ByteBuffer heap = ByteBuffer.allocate(12 * 13 * 14);
        ByteBuffer swapped = ByteBuffer.allocateDirect(12 * 13 * 14).order(
                ByteOrder.nativeOrder() == ByteOrder.BIG_ENDIAN ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
        for (Checks.Body body : new Checks.Body[] {
            () -> mesher.labels(new byte[12 * 13 * 14 - 1], Checks.GRID, null),
            () -> mesher.labels(new short[0], Checks.GRID, null), () -> mesher.labels(new int[1], Checks.GRID, null),
            () -> mesher.labels(heap, VoxelType.UINT8, Checks.GRID, null),
            () -> mesher.labels(swapped, VoxelType.UINT8, Checks.GRID, null),
            () -> mesher.labels(
                    ByteBuffer.allocateDirect(8).order(ByteOrder.nativeOrder()), VoxelType.INT32, Checks.GRID, null),
            () -> mesher.indicators(new double[0][], Checks.GRID, null),
            () -> mesher.indicators(new double[][] {new double[3]}, Checks.GRID, null),
            () -> mesher.indicators(new float[][] {new float[12 * 13 * 14]}, Checks.GRID, new int[1]),
            () -> mesher.sizing(volume, new float[3], false, null), () -> volume.sample(1, 2),
            () -> mesher.metricSizing(volume, new float[12 * 13 * 14], false, null),
            () -> mesher.constantMetricSizing(volume, new double[9]),
            () -> mesher.meshOf(new double[4], new int[4], null, 0), () -> mesher.meshOf(points, new int[5], null, 0),
            () -> mesher.meshOf(points, new int[4], new int[2], 0), () -> new Grid(0, 1, 1), () -> new Grid(1, -1, 1),
            () -> new Grid(Long.MAX_VALUE, 2, 2), () -> Checks.GRID.spacing(1, 0, 1), () -> Checks.GRID.affine(1, 2, 3),
            () -> Checks.GRID.spacing(1, Double.NaN, 1), () -> Checks.GRID.origin(Double.NaN, 0, 0),
            () -> Checks.ballMesh(mesher).tets(2), () -> Checks.ballMesh(mesher).quadratic(-1)
        })
            Checks.thrown(IllegalArgumentException.class, body);
    }

    void testAnAffineStandsAlone() {
        double[] affine = {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0};
        Grid grid = new Grid(2, 2, 2);
        for (Checks.Body body : new Checks.Body[] {
            () -> grid.spacing(1, 1, 1).affine(affine), () -> grid.origin(0, 0, 0).affine(affine),
            () -> grid.affine(affine).spacing(1, 1, 1), () -> grid.affine(affine).origin(0, 0, 0)
        })
            Checks.thrown(IllegalStateException.class, body);
    }

    void testWrongNumbers() {
        Volume volume = Checks.ballVolume(mesher);
        double[] points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
        double[] values = new double[12 * 13 * 14];
        for (Checks.Body body : new Checks.Body[] {
            () -> mesher.constantSizing(volume, Double.NaN), () -> mesher.constantSizing(volume, 0),
            () -> mesher.sizing(volume, values, false, null), () -> volume.sample(0, Double.NaN, 0),
            () -> mesher.constantSizing(volume, 1).at(Double.NaN, 0, 0), () -> mesher.threads(-1),
            () -> mesher.meshOf(points, new int[] {0, 1, 2, 4}, null, 0),
            () -> mesher.meshOf(points, new int[] {0, 1, 2, -1}, null, 0),
            () -> mesher.meshOf(new double[] {0, 0, Double.NaN}, new int[0], null, 0),
            () -> mesher.labels(Checks.ballLabels(), Checks.GRID.affine(new double[12]), null)
        })
            Checks.thrown(CleftException.InvalidArgument.class, body);
        values[5] = Double.NaN;
        Checks.thrown(
                CleftException.NotFinite.class, () -> mesher.indicators(new double[][] {values}, Checks.GRID, null));
    }

    void testStrict() {
        byte[] labels = new byte[8000];
        labels[10 + 20 * (10 + 20 * 10)] = 1;
        Volume volume = mesher.labels(labels, new Grid(20, 20, 20), null);
        CleftException lost = Checks.thrown(CleftException.LabelLost.class, () -> mesher.mesh(volume, new Options()
                .background(Background.LATTICE).size(8).improve(Improvement.OFF).snap(Snap.NONE).strict(true)));
        Checks.equal(-12, lost.status());
    }

    void testClosingUnderACall() throws Exception {
        Volume volume = Checks.slowVolume(mesher);
        mesher.progress((fraction, stage) -> {
            volume.close();
            mesher.close();
            return fraction < 0.3;
        });
        Checks.thrown(CleftException.Cancelled.class, () -> mesher.mesh(volume, null));
        Checks.thrown(IllegalStateException.class, volume::dims);
    }

    private static void named(Class<? extends RuntimeException> kind, String name, Checks.Body... bodies) {
        for (Checks.Body body : bodies) {
            String message = Checks.thrown(kind, body).getMessage();
            Checks.check(
                    message.matches("(?s)(.*\\W)?\\Q" + name + "\\E(\\W.*)?"), name + " is not named in: " + message);
        }
    }

    /** Who gives null gets the name of the argument. */
    void testNamesOfNulls() {
        Volume volume = Checks.ballVolume(mesher);
        Mesh mesh = Checks.ballMesh(mesher);
        var path = java.nio.file.Path.of("a.vtu");
        Class<NullPointerException> kind = NullPointerException.class;
        named(kind, "voxels", () -> mesher.labels((byte[]) null, Checks.GRID, null),
                () -> mesher.labels((ByteBuffer) null, VoxelType.UINT8, Checks.GRID, null));
        named(kind, "grid", () -> mesher.labels(new short[1], null, null),
                () -> mesher.indicators(new double[][] {{1}}, null, null));
        named(kind, "fields", () -> mesher.indicators((float[][]) null, Checks.GRID, null));
        named(kind, "fields[1]",
                () -> mesher.indicators(new double[][] {new double[12 * 13 * 14], null}, Checks.GRID, null));
        named(kind, "volume", () -> mesher.mesh(null, null), () -> mesher.sizing(null, new float[1], false, null),
                () -> mesher.report(null, mesh));
        named(kind, "values", () -> mesher.sizing(volume, (double[]) null, false, null));
        named(kind, "points", () -> mesher.meshOf(null, new int[4], null, 0), () -> volume.sample((double[]) null));
        named(kind, "tets", () -> mesher.meshOf(new double[3], null, null, 0));
        named(kind, "background", () -> mesher.cleave(volume, null, null));
        named(kind, "labels", () -> new Options().strip((int[]) null), () -> new Options().only((int[]) null));
        named(kind, "name", () -> new Options().set(null, "1"), () -> volume.labelName(0, null));
        named(kind, "value", () -> new Options().set("size", null), () -> new Options().background(null));
        named(kind, "mesher", () -> MeshFiles.readMesh(null, path), () -> MeshFiles.readVolume(null, path));
        named(kind, "path", () -> MeshFiles.readMesh(mesher, null), () -> MeshFiles.readVolume(mesher, null),
                () -> MeshFiles.guess(null));
        named(kind, "paths[1]", () -> MeshFiles.readVolume(mesher, MeshFiles.Reading.DEFAULT, null, path, null));
        named(kind, "reading", () -> MeshFiles.readVolume(mesher, null, null, path));
        named(kind, "format", () -> MeshFiles.writeMesh(mesher, mesh, path, null));
        named(kind, "raw", () -> MeshFiles.readRaw(mesher, null, null, path));
        named(kind, "type", () -> new RawVoxels(null, 1, 1, 1));
        named(kind, "meaning", () -> new RawVoxels(VoxelType.INT16, 1, 1, 1).kind(null));
        named(kind, "rows", () -> Checks.GRID.affine((double[]) null));
    }

    /** Who gives a wrong argument gets its name in Java. */
    void testNamesOfArguments() {
        Volume volume = Checks.ballVolume(mesher);
        Mesh mesh = Checks.ballMesh(mesher);
        var path = java.nio.file.Path.of("a.raw");
        Class<IllegalArgumentException> kind = IllegalArgumentException.class;
        named(kind, "nx", () -> new Grid(0, 1, 1));
        named(kind, "ny", () -> new Grid(1, -1, 1));
        named(kind, "nz", () -> new Grid(1, 1, 0));
        named(kind, "y", () -> Checks.GRID.spacing(1, 0, 1));
        named(kind, "z", () -> Checks.GRID.origin(1, 0, Double.NaN));
        named(kind, "rows", () -> Checks.GRID.affine(1, 2));
        named(kind, "voxels", () -> mesher.labels(new byte[1], Checks.GRID, null));
        named(kind, "type", () -> mesher.labels(ByteBuffer.allocateDirect(8), VoxelType.FLOAT32, Checks.GRID, null));
        named(kind, "fields[1]", () -> mesher.indicators(
                new float[][] {new float[12 * 13 * 14], new float[2]}, Checks.GRID, null));
        named(kind, "labels", () -> mesher.meshOf(new double[12], new int[4], new int[2], 0));
        named(kind, "indexBase", () -> mesher.meshOf(new double[12], new int[4], null, 2), () -> mesh.tets(-1),
                () -> mesh.quadratic(3));
        named(kind, "ny", () -> new RawVoxels(VoxelType.INT16, 1, 0, 1));
        named(kind, "z", () -> new RawVoxels(VoxelType.INT16, 1, 1, 1).spacing(1, 1, -1));
        named(kind, "bytes", () -> new RawVoxels(VoxelType.INT16, 1, 1, 1).skip(-1));
        named(kind, "format", () -> MeshFiles.writeMesh(mesher, mesh, path, "jpeg"));
        named(kind, "scale", () -> MeshFiles.Reading.DEFAULT.scaled(0),
                () -> MeshFiles.Reading.DEFAULT.scaled(Double.NaN));
        named(kind, "value", () -> new Options().set("size", "1\0"));
        named(kind, "name", () -> volume.labelName(1, "half a \ud83d"));
        Class<CleftException.InvalidArgument> ours = CleftException.InvalidArgument.class;
        named(ours, "threads", () -> mesher.threads(-1));
        named(ours, "y", () -> mesher.constantSizing(volume, 1).at(0, Double.NaN, 0));
        named(ours, "points[4]", () -> volume.sample(0, 0, 0, 0, Double.NaN, 0));
        named(ours, "label", () -> volume.labelName(5, "five"), () -> mesh.labelName(5, "five"));
        named(ours, "name", () -> volume.labelName(1, "two\nlines"));
    }

    /** Options are called in sentences as in Java, but names of files are left alone. */
    void testNamesOfOptions() {
        Volume volume = Checks.ballVolume(mesher);
        Class<CleftException> kind = CleftException.class;
        named(kind, "sizeMax is -1", () -> new Options().sizeMax(-1));
        named(kind, "maxTets", () -> new Options().maxTets(-1));
        named(kind, "sizeMax is 2, less than sizeMin", () -> mesher.mesh(volume, new Options().sizeMin(3).sizeMax(2)));
        named(kind, "size_max is not a number", () -> new Options().set("size_max", "x"));
        named(kind, "/no/size_max.vtu", () -> MeshFiles.readMesh(mesher, java.nio.file.Path.of("/no/size_max.vtu")));
    }
}
