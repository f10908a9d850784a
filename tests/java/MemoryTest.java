import java.nio.file.Files;
import java.nio.file.Path;
import org.cleft.*;

/** Memory stays flat over many objects made, used, failed and dropped. */
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
}
