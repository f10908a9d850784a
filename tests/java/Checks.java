import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.Comparator;
import java.util.Objects;
import org.cleft.Background;
import org.cleft.CleftException;
import org.cleft.Grid;
import org.cleft.Mesh;
import org.cleft.Mesher;
import org.cleft.Options;
import org.cleft.Volume;

/** What the tests share: running methods named test..., asserting, and a small volume. */
final class Checks {
    interface Body {
        void run() throws Exception;
    }

    private Checks() {}

    /** Runs all methods test...() of a class, each on an object of its own; fails the program if one of them fails. */
    static void runAll(Class<?> tests) throws Exception {
        Method[] methods = Arrays.stream(tests.getDeclaredMethods())
                .filter(method -> method.getName().startsWith("test"))
                .sorted(Comparator.comparing(Method::getName))
                .toArray(Method[]::new);
        int failed = methods.length == 0 ? 1 : 0;
        for (Method method : methods)
            try {
                var constructor = tests.getDeclaredConstructor();
                constructor.setAccessible(true);
                method.setAccessible(true);
                method.invoke(constructor.newInstance());
                System.out.println("ok " + method.getName());
            } catch (InvocationTargetException failure) {
                ++failed;
                System.out.println("FAILED " + method.getName());
                failure.getCause().printStackTrace(System.out);
            }
        System.exit(failed == 0 ? 0 : 1);
    }

    static void check(boolean condition, String what) {
        if (!condition)
            throw new AssertionError(what);
    }

    static void equal(Object wanted, Object found) {
        check(Objects.deepEquals(wanted, found), "wanted " + wanted + ", found " + found);
    }

    static void near(double wanted, double found, double relative) {
        check(Math.abs(wanted - found) <= relative * Math.abs(wanted), "wanted " + wanted + ", found " + found);
    }

    /** The body must throw this kind of exception, with some sentence. */
    static <T extends Throwable> T thrown(Class<T> kind, Body body) {
        try {
            body.run();
        } catch (Throwable failure) {
            check(kind.isInstance(failure), "wanted " + kind + ", found " + failure);
            check(!(failure instanceof CleftException) || !failure.getMessage().isEmpty(), "no sentence");
            return kind.cast(failure);
        }
        throw new AssertionError("nothing was thrown, wanted " + kind);
    }

    static final Grid GRID = new Grid(12, 13, 14);

    /** 1 in a ball off the middle, 7 in a slab at high x, else 0; no symmetry between the axes. */
    static byte[] ballLabels() {
        byte[] labels = new byte[12 * 13 * 14];
        for (int k = 0; k < 14; ++k)
            for (int j = 0; j < 13; ++j)
                for (int i = 0; i < 12; ++i) {
                    double r2 = (i - 4.8) * (i - 4.8) + (j - 6) * (j - 6) + (k - 7.2) * (k - 7.2);
                    labels[i + 12 * (j + 13 * k)] = (byte) (i >= 9 ? 7 : r2 < 3.6 * 3.6 ? 1 : 0);
                }
        return labels;
    }

    static Volume ballVolume(Mesher mesher) {
        return mesher.labels(ballLabels(), GRID, null);
    }

    static Options quick() {
        return new Options().background(Background.LATTICE).size(3);
    }

    static Mesh ballMesh(Mesher mesher) {
        try (Volume volume = ballVolume(mesher); Options options = quick()) {
            return mesher.mesh(volume, options);
        }
    }

    /** A volume whose meshing takes seconds. */
    static Volume slowVolume(Mesher mesher) {
        var random = new java.util.Random(1);
        byte[] labels = new byte[40 * 40 * 40];
        for (int i = 0; i < labels.length; ++i)
            labels[i] = (byte) random.nextInt(3);
        return mesher.labels(labels, new Grid(40, 40, 40), null);
    }

    static boolean same(Mesh a, Mesh b) {
        return Arrays.equals(a.points(), b.points()) && Arrays.equals(a.tets(), b.tets())
                && Arrays.equals(a.tetLabels(), b.tetLabels());
    }
}
