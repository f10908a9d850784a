import java.nio.DoubleBuffer;
import java.nio.IntBuffer;
import java.nio.file.Path;
import java.util.Map;
import java.util.TreeMap;
import org.cleft.LabelReport;
import org.cleft.Mesh;
import org.cleft.MeshFiles;
import org.cleft.Mesher;
import org.cleft.Options;
import org.cleft.Volume;

/**
 * Meshes a label map, prints what became of each label, and writes the mesh:
 *
 * <pre>java -cp cleft.jar LabelStatistics.java VOLUME MESH</pre>
 *
 * VOLUME is NIfTI, NRRD, MetaImage ...; MESH is .vtu, .msh, .mesh, .inp ...
 */
final class LabelStatistics {
    public static void main(String[] arguments) {
        if (arguments.length != 2) {
            System.err.println("usage: java -cp cleft.jar LabelStatistics.java VOLUME MESH");
            System.exit(2);
        }
        try (Mesher mesher = new Mesher().threads(0).progress(LabelStatistics::show);
                Options options = new Options().featureScale(2);
                Volume volume = MeshFiles.readVolume(mesher, MeshFiles.Reading.DEFAULT, options, Path.of(arguments[0]));
                Mesh mesh = mesher.mesh(volume, options)) {
            System.out.printf("%8s %10s %14s %14s %12s%n", "label", "tets", "mesh volume", "voxel volume", "mean edge");
            Map<Integer, Double> edges = meanEdges(mesh);
            for (LabelReport row : mesher.report(volume, mesh))
                System.out.printf("%8d %10d %14.3f %14.3f %12.4f%n", row.label(), row.tets(), row.meshVolume(),
                        row.voxelVolume(), edges.getOrDefault(row.label(), Double.NaN));
            System.out.printf("%d points, %d tetrahedra, least dihedral angle %.1f degrees%n", mesh.pointCount(),
                    mesh.tetCount(), mesher.quality(mesh).minDihedral());
            MeshFiles.writeMesh(mesher, mesh, Path.of(arguments[1]));
            System.out.println(arguments[1] + " is written");
        }
    }

    private static boolean show(double fraction, String stage) {
        if (System.console() != null)
            System.err.printf("\r%3.0f %% %-40s", 100 * fraction, stage);
        return true;  // go on
    }

    /** The mean length of the edges of the tetrahedra of each label, from views: nothing is copied. */
    private static Map<Integer, Double> meanEdges(Mesh mesh) {
        DoubleBuffer points = mesh.pointsView();
        IntBuffer tets = mesh.tetsView();
        IntBuffer labels = mesh.tetLabelsView();
        Map<Integer, double[]> sums = new TreeMap<>();  // of lengths, of edges
        for (int t = 0; t < labels.limit(); ++t) {
            double[] sum = sums.computeIfAbsent(labels.get(t), label -> new double[2]);
            for (int a = 0; a < 4; ++a)
                for (int b = a + 1; b < 4; ++b) {
                    sum[0] += distance(points, tets.get(4 * t + a), tets.get(4 * t + b));
                    ++sum[1];
                }
        }
        Map<Integer, Double> means = new TreeMap<>();
        sums.forEach((label, sum) -> means.put(label, sum[0] / sum[1]));
        return means;
    }

    private static double distance(DoubleBuffer points, int a, int b) {
        double square = 0;
        for (int axis = 0; axis < 3; ++axis) {
            double difference = points.get(3 * a + axis) - points.get(3 * b + axis);
            square += difference * difference;
        }
        return Math.sqrt(square);
    }
}
