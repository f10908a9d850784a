import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.cleft.Background;
import org.cleft.Grid;
import org.cleft.Mesh;
import org.cleft.Mesher;
import org.cleft.Options;
import org.cleft.Volume;

/** The golden case of tests/golden/README.md. */
final class Golden {
    private static int square(int x) {
        return x * x;
    }

    private static int labelAt(int i, int j, int k) {
        if (square(i - 10) + square(j - 7) + square(k - 6) <= 14)
            return 200;
        return square(i - 5) + square(j - 6) + square(k - 5) <= 17 ? 3 : 0;
    }

    public static void main(String[] arguments) {
        byte[] labels = new byte[16 * 14 * 12];
        for (int k = 0; k < 12; ++k)
            for (int j = 0; j < 14; ++j)
                for (int i = 0; i < 16; ++i)
                    labels[i + 16 * (j + 14 * k)] = (byte) labelAt(i, j, k);
        Grid grid = new Grid(16, 14, 12).affine(1, 0, 0, -4.5, 0, 1.25, 0, 2.25, 0, 0, 1.5, 100);
        try (Mesher mesher = new Mesher().threads(1);
                Options options = new Options().background(Background.PARTICLES);
                Volume volume = mesher.labels(labels, grid, options);
                Mesh mesh = mesher.mesh(volume, options)) {
            ByteBuffer bytes = ByteBuffer.allocate((int) (24 * mesh.pointCount() + 20 * mesh.tetCount()))
                    .order(ByteOrder.nativeOrder());
            for (double coordinate : mesh.points())
                bytes.putDouble(coordinate);
            for (int corner : mesh.tets())
                bytes.putInt(corner);
            for (int label : mesh.tetLabels())
                bytes.putInt(label);
            long hash = 0xcbf29ce484222325L;
            for (byte b : bytes.array())
                hash = (hash ^ (b & 0xff)) * 0x100000001b3L;
            System.out.printf("%016x%n", hash);
        }
    }
}
