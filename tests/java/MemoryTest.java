import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.cleft.*;

/** Memory stays flat over many objects made, used, failed and dropped; and bounded where nobody closes or collects. */
final class MemoryTest {
    public static void main(String[] arguments) throws Exception {
        Checks.runAll(MemoryTest.class);
    }

    private static long residentKilobytes() throws Exception {
        return Files.readAllLines(Path.of("/proc/self/status")).stream()
                .filter(line -> line.startsWith("VmRSS"))
                .mapToLong(line -> Long.parseLong(line.replaceAll("\\D", "")))
                .findFirst().orElseThrow();
    }

    /** Closed if `close`, else left to the collector. */
    private static void cycle(boolean close) {
        Mesher mesher = new Mesher().progress((fraction, stage) -> true).log((level, sentence) -> {});
        Options options = new Options().background(Background.LATTICE).size(4).improve(Improvement.OFF).strip(0);
        Volume volume = Checks.ballVolume(mesher);
        Mesh mesh = mesher.mesh(volume, options);
        Surface surface = mesher.surface(mesh);
        Checks.check(mesh.pointsView().get(0) == mesh.points()[0] && surface.hullSides().length > 0, "no mesh");
        mesher.report(volume, mesh);
        mesher.quality(mesh);
        Checks.thrown(CleftException.class, () -> options.size(-1));
        mesher.progress((fraction, stage) -> false);
        Checks.thrown(CleftException.Cancelled.class, () -> mesher.mesh(volume, options));
        if (close)
            for (NativeObject object : new NativeObject[] {surface, mesh, volume, options, mesher})
                object.close();
    }

    private static long afterCycles(int count) throws Exception {
        for (int n = 0; n < count; ++n) {
            cycle(n % 2 == 0);
            if (n % 100 == 99)
                System.gc();
        }
        System.gc();
        Thread.sleep(100);  // for the cleaner
        return residentKilobytes();
    }

    void testAThousandCycles() throws Exception {
        long before = afterCycles(200);
        long after = afterCycles(1000);
        Checks.check(after - before < 8192, "memory grew by " + (after - before) + " kB");
    }

    /** The budget of 128 MiB, and as much again for what the allocator keeps. In kB. */
    private static final long BOUND = 256 << 10;

    private interface Maker {
        NativeObject make(int n);
    }

    /**
     * Makes objects of 3 MB or more and drops each. The heap stays nearly empty: nothing else makes the collector run.
     */
    private static void makeUnclosed(int count, Maker maker) throws Exception {
        NativeObject kept = maker.make(0);
        long before = residentKilobytes();
        long most = before;
        for (int n = 1; n <= count; ++n) {
            maker.make(n);
            most = Math.max(most, residentKilobytes());
        }
        System.out.println(count + " unclosed objects held at most " + (most - before) + " kB");
        Checks.check(most - before < BOUND, "unclosed objects held " + (most - before) + " kB");
        Checks.check(!kept.isClosed() && kept.toString().contains(" of "), "one that is in use is gone");
    }

    void testUnclosedMeshes() throws Exception {
        Mesher mesher = new Mesher();
        double[] points = new double[3 * 60_000];
        int[] tets = new int[4 * 100_000];
        makeUnclosed(400, n -> mesher.meshOf(points, tets, null, 0));
    }

    void testUnclosedVolumes() throws Exception {
        Mesher mesher = new Mesher();
        byte[] labels = new byte[100 * 100 * 100];
        makeUnclosed(150, n -> mesher.labels(labels, new Grid(100, 100, 100), null));
    }

    void testUnclosedSizings() throws Exception {
        Mesher mesher = new Mesher();
        Volume volume = mesher.labels(new byte[100 * 100 * 100], new Grid(100, 100, 100), null);
        makeUnclosed(150, n -> mesher.constantSizing(volume, 1 + n));
    }

    void testUnclosedSurfaces() throws Exception {
        Mesher mesher = new Mesher();
        int[] tets = new int[4 * 40_000];  // which share no points: each face is of the hull
        double[] points = new double[3 * tets.length];
        for (int i = 0; i < tets.length; ++i)
            tets[i] = i;
        for (int t = 0; t < tets.length / 4; ++t)
            for (int axis = 0; axis < 3; ++axis) {
                points[12 * t + 3 * (axis + 1) + axis] = 1;
                for (int corner = 0; corner < 4; ++corner)
                    points[12 * t + 3 * corner] += 2 * t;
            }
        Mesh mesh = mesher.meshOf(points, tets, null, 0);
        makeUnclosed(100, n -> mesher.surface(mesh));
    }

    /** What is in use is no reason to collect again and again, nor are objects that are closed. */
    void testObjectsInUse() throws Exception {
        Mesher mesher = new Mesher();
        double[] points = new double[3 * 60_000];
        int[] tets = new int[4 * 100_000];
        List<Mesh> kept = new ArrayList<>();
        for (int n = 0; n < 100; ++n)
            kept.add(mesher.meshOf(points, tets, null, 0));
        long collections = collections();
        for (int n = 0; n < 400; ++n)
            mesher.meshOf(points, tets, null, 0).close();
        Checks.check(collections() - collections <= 1, collections() - collections + " collections for closed objects");
        for (Mesh mesh : kept)
            Checks.equal(60_000L, mesh.pointCount());
        kept.forEach(Mesh::close);
    }

    private static long collections() {
        return ManagementFactory.getGarbageCollectorMXBeans().stream()
                .mapToLong(bean -> bean.getCollectionCount()).sum();
    }

    /**
     * Threads that make objects at the same time keep to the bound together. One of them is interrupted during each
     * call, too late to cancel it: waiting for memory neither fails by that nor swallows it.
     */
    void testUnclosedInThreads() throws Exception {
        long before = residentKilobytes();
        double[] points = new double[3 * 60_000];
        int[] tets = new int[4 * 100_000];
        int[] interrupts = new int[4];
        Thread[] threads = new Thread[4];
        for (int t = 0; t < threads.length; ++t) {
            int mine = t;
            threads[t] = new Thread(() -> {
                Mesher mesher = new Mesher();
                if (mine == 0)
                    mesher.progress((fraction, stage) -> {
                        Thread.currentThread().interrupt();
                        return true;
                    });
                for (int n = 0; n < 100; ++n) {
                    mesher.meshOf(points, tets, null, 0);
                    interrupts[mine] += Thread.interrupted() ? 1 : 0;
                }
            });
            threads[t].start();
        }
        for (Thread thread : threads)
            thread.join();
        Checks.equal(new int[] {100, 0, 0, 0}, interrupts);
        long grown = residentKilobytes() - before;
        Checks.check(grown < BOUND, "unclosed objects held " + grown + " kB");
    }
}
