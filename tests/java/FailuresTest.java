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
            volume::dims, volume::labels, volume::voxelCounts, () -> volume.sample(0, 0, 0), mesh::points, mesh::pointsView,
            mesh::labels, () -> mesh.quadratic(0), sizing::values, () -> sizing.at(0, 0, 0), sizing::expectedTets,
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
            () -> mesher.surface(null), () -> mesher.report(volume, null), () -> mesher.meshOf(null, new int[4], null, 0),
            () -> mesher.meshOf(new double[3], null, null, 0), () -> volume.sample((double[]) null),
            () -> mesher.sizing(volume, (float[]) null, false, null)
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
            () -> mesher.labels(ByteBuffer.allocateDirect(8).order(ByteOrder.nativeOrder()), VoxelType.INT32, Checks.GRID, null),
            () -> mesher.indicators(new double[0][], Checks.GRID, null),
            () -> mesher.indicators(new double[][] {new double[3]}, Checks.GRID, null),
            () -> mesher.indicators(new float[][] {new float[12 * 13 * 14]}, Checks.GRID, new int[1]),
            () -> mesher.sizing(volume, new float[3], false, null), () -> volume.sample(1, 2),
            () -> mesher.meshOf(new double[4], new int[4], null, 0), () -> mesher.meshOf(points, new int[5], null, 0),
            () -> mesher.meshOf(points, new int[4], new int[2], 0), () -> new Grid(0, 1, 1), () -> new Grid(1, -1, 1),
            () -> new Grid(Long.MAX_VALUE, 2, 2), () -> Checks.GRID.spacing(1, 0, 1), () -> Checks.GRID.affine(1, 2, 3),
            () -> Checks.GRID.spacing(1, Double.NaN, 1), () -> Checks.GRID.origin(Double.NaN, 0, 0),
            () -> Checks.ballMesh(mesher).tets(2), () -> Checks.ballMesh(mesher).quadratic(-1)
        })
            Checks.thrown(IllegalArgumentException.class, body);
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
            () -> mesher.meshOf(points, new int[] {0, 1, 2, 3}, null, 2),
            () -> mesher.meshOf(new double[] {0, 0, Double.NaN}, new int[0], null, 0),
            () -> mesher.labels(Checks.ballLabels(), Checks.GRID.affine(new double[12]), null)
        })
            Checks.thrown(CleftException.InvalidArgument.class, body);
        values[5] = Double.NaN;
        Checks.thrown(CleftException.NotFinite.class, () -> mesher.indicators(new double[][] {values}, Checks.GRID, null));
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
}
