import java.lang.reflect.Constructor;
import java.lang.reflect.Executable;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.nio.ByteBuffer;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.cleft.*;

/** Null for each parameter of each public method and constructor in turn: it is taken, or refused by its name. */
final class NullsTest {
    private static final List<Class<?>> KINDS = List.of(
            Mesher.class, Options.class, Volume.class, Sizing.class, Mesh.class, Surface.class,
            Grid.class, RawVoxels.class, MeshFiles.class, MeshFiles.Reading.class, Picture.class,
            View.class);

    private final Mesher mesher = new Mesher().log(null);
    private final Map<Class<?>, Object> samples = new HashMap<>();

    public static void main(String[] arguments) throws Exception {
        Checks.runAll(NullsTest.class);
    }

    private void makeSamples() {
        int voxels = (int) Checks.GRID.voxels();
        Volume volume = Checks.ballVolume(mesher);
        Mesh mesh = Checks.ballMesh(mesher);
        Path path = Path.of("no such folder", "a.vtu");
        for (Object sample : new Object[] {mesher, Checks.quick(), volume, mesh, mesher.constantSizing(volume, 3),
                mesher.surface(mesh), Checks.GRID, new RawVoxels(VoxelType.UINT8, 1, 1, 1), MeshFiles.Reading.DEFAULT,
                new Picture(), new View(), "text",
                new byte[voxels], new short[voxels], new int[voxels], new long[3], new float[voxels],
                new double[voxels],
                new float[2][voxels], new double[2][voxels], new Path[] {path}})
            samples.put(sample.getClass(), sample);
        samples.put(Path.class, path);
        samples.put(ByteBuffer.class, ByteBuffer.allocateDirect(voxels).order(java.nio.ByteOrder.nativeOrder()));
        samples.put(Progress.class, (Progress) (fraction, stage) -> true);
        samples.put(Log.class, (Log) (level, sentence) -> {});
        samples.put(int.class, 0);
        samples.put(long.class, 1L);
        samples.put(float.class, 1f);
        samples.put(double.class, 1.0);
        samples.put(boolean.class, false);
    }

    void testEveryNull() throws Exception {
        makeSamples();
        List<Executable> all = new ArrayList<>();
        for (Class<?> kind : KINDS) {
            all.addAll(List.of(kind.getConstructors()));
            for (Method method : kind.getDeclaredMethods())
                if (Modifier.isPublic(method.getModifiers()) && !method.getName().equals("equals")
                        && !method.isSynthetic())
                    all.add(method);
        }
        int tried = 0;
        for (Executable one : all)
            for (int at = 0; at < one.getParameterCount(); ++at)
                if (!one.getParameterTypes()[at].isPrimitive()) {
                    tryNull(one, at);
                    ++tried;
                }
        Checks.check(tried > 60, "only " + tried + " were tried");
    }

    private void tryNull(Executable one, int at) throws Exception {
        Object[] arguments = new Object[one.getParameterCount()];
        for (int i = 0; i < arguments.length; ++i) {
            Class<?> type = one.getParameterTypes()[i];
            // Any choice will do, also of an option that is new.
            Object sample = type.isEnum() ? type.getEnumConstants()[0] : samples.get(type);
            Checks.check(sample != null, "there is no sample of " + type);
            arguments[i] = i == at ? null : sample;
        }
        try {
            if (one instanceof Constructor<?> constructor)
                constructor.newInstance(arguments);
            else
                ((Method) one).invoke(samples.get(one.getDeclaringClass()), arguments);
        } catch (InvocationTargetException thrown) {
            if (thrown.getCause() instanceof NullPointerException failure)
                Checks.check(failure.getMessage().matches("\\w+(\\[\\d+\\])?"), one + ": " + failure.getMessage());
            else
                Checks.check(!thrown.getCause().getMessage().contains("NULL"), one + ": " + thrown.getCause());
        }
    }
}
