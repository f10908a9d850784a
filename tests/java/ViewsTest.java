import java.nio.DoubleBuffer;
import java.nio.FloatBuffer;
import java.nio.IntBuffer;
import java.nio.ReadOnlyBufferException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.cleft.*;

/** Views: without a copy, read-only, and good as long as they are held, whatever the garbage collector does. */
final class ViewsTest {
    private final Mesher mesher = new Mesher();

    public static void main(String[] arguments) throws Exception {
        Checks.runAll(ViewsTest.class);
    }

    void testViewsAreTheArrays() {
        Mesh mesh = Checks.ballMesh(mesher);
        Checks.check(DoubleBuffer.wrap(mesh.points()).equals(mesh.pointsView()), "points");
        Checks.check(IntBuffer.wrap(mesh.tets()).equals(mesh.tetsView()), "tets");
        Checks.check(IntBuffer.wrap(mesh.tetLabels()).equals(mesh.tetLabelsView()), "labels");
        Sizing sizing = mesher.constantSizing(Checks.ballVolume(mesher), 2);
        Checks.check(FloatBuffer.wrap(sizing.values()).equals(sizing.valuesView()), "values");
    }

    void testViewsAreReadOnly() {
        Mesh mesh = Checks.ballMesh(mesher);
        DoubleBuffer view = mesh.pointsView();
        Checks.check(view.isDirect() && view.isReadOnly(), "not a view");
        Checks.thrown(ReadOnlyBufferException.class, () -> view.put(0, 1.0));
    }

    void testEmptyMesh() {
        Mesh empty = mesher.meshOf(new double[0], new int[0], null, 0);
        Checks.equal(0, empty.pointsView().remaining());
        Checks.equal(0, empty.tets().length);
    }

    /** The memory behind views must not be given back while a part of a part of one is held. */
    void testGarbageCollection() {
        double[] points;
        int[] tets;
        try (Mesh mesh = Checks.ballMesh(mesher)) {
            points = mesh.points();
            tets = mesh.tets();
        }
        List<DoubleBuffer> kept = new ArrayList<>();
        List<IntBuffer> keptTets = new ArrayList<>();
        for (int round = 0; round < 100; ++round) {
            Mesh mesh = Checks.ballMesh(mesher);
            kept.add(mesh.pointsView().slice(3, points.length - 3).duplicate());
            keptTets.add(mesh.tetsView().asReadOnlyBuffer());
            if (round % 2 == 0)
                mesh.close();  // while views are held; the others are left to the collector
            if (round % 10 == 9) {
                System.gc();
                kept.subList(0, kept.size() / 2).clear();
            }
        }
        System.gc();
        DoubleBuffer wanted = DoubleBuffer.wrap(points).slice(3, points.length - 3);
        for (DoubleBuffer view : kept)
            Checks.check(wanted.equals(view), "the memory of a view has changed");
        for (IntBuffer view : keptTets)
            Checks.check(IntBuffer.wrap(tets).equals(view), "the memory of a view has changed");
    }

    void testCollectorsInTheMiddleOfCalls() throws Exception {
        Thread collector = new Thread(() -> {
            while (!Thread.currentThread().isInterrupted())
                System.gc();
        });
        collector.setDaemon(true);
        collector.start();
        double[] points = Checks.ballMesh(mesher).points();
        for (int round = 0; round < 10; ++round) {
            Mesher own = new Mesher().progress((fraction, stage) -> true);
            Checks.check(Arrays.equals(points, Checks.ballMesh(own).points()), "another mesh");
            Checks.check(Checks.ballMesh(own).pointsView().get(5) == points[5], "another point");
        }
        collector.interrupt();
        collector.join();
    }
}
