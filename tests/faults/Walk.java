import java.nio.file.Path;
import java.util.Arrays;
import org.cleft.*;

/** Meshes, looks and reads and writes again and again, until nothing fails any more; reports how often it failed. */
final class Walk {
    private static final Path PATH = Path.of(System.getenv("WALK_FOLDER"), "a.vtu");
    private static final int CALM = 20; // runs on end that do not fail

    private static double[] work() {
        byte[] labels = new byte[5 * 4 * 6];
        for (int voxel = 0; voxel < labels.length; ++voxel)
            labels[voxel] = (byte) (voxel % 5 > 1 && voxel / 20 > 2 ? 7 : 0);
        try (Mesher mesher = new Mesher();
                Options options = new Options().background(Background.LATTICE).size(2);
                Volume volume = mesher.labels(labels, new Grid(5, 4, 6), null);
                Mesh mesh = mesher.mesh(volume, options);
                Surface surface = mesher.surface(mesh)) {
            mesher.quality(mesh);
            mesher.validate(mesh, true);
            mesher.report(volume, mesh);
            MeshFiles.writeMesh(mesher, mesh, PATH);
            try (Mesh again = MeshFiles.readMesh(mesher, PATH)) {
                return again.points();
            }
        }
    }

    public static void main(String[] arguments) {
        int failed = 0;
        double[] wanted = null;
        for (int calm = 0; calm < CALM; ++calm)
            try {
                double[] got = work();
                wanted = wanted == null ? got : wanted;
                if (!Arrays.equals(wanted, got))
                    throw new AssertionError("not the same mesh");
            } catch (CleftException.OutOfMemory | OutOfMemoryError failure) {
                ++failed;
                calm = -1;
            }
        System.out.println(failed);
    }
}
