import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.Map;
import org.cleft.*;

/** Reading and writing. */
final class FilesTest {
    private static final Path DATA = Path.of(System.getenv("TEST_DATA"));
    private final Mesher mesher = new Mesher();

    public static void main(String[] arguments) throws Exception {
        Checks.runAll(FilesTest.class);
    }

    private interface Use {
        void of(Path folder) throws Exception;
    }

    private static void inFolder(Use use) throws Exception {
        Path folder = Files.createTempDirectory("cleft-test-");
        try {
            use.of(folder);
        } finally {
            try (var paths = Files.walk(folder)) {
                for (Path path : paths.sorted(Comparator.reverseOrder()).toList())
                    Files.delete(path);
            }
        }
    }

    void testMeshes() throws Exception {
        inFolder(folder -> {
            Mesh mesh = Checks.ballMesh(mesher);
            for (String name : new String[] {"a b.vtu", "a.msh", "a.mesh"}) {
                MeshFiles.writeMesh(mesher, mesh, folder.resolve(name));
                Checks.equal(MeshFiles.Content.MESH, MeshFiles.guess(folder.resolve(name)));
                Checks.equal(mesh.tetCount(), MeshFiles.readMesh(mesher, folder.resolve(name)).tetCount());
            }
            Path table = folder.resolve("names.txt");
            Files.writeString(table, "1 heart\n7 slab\n");
            MeshFiles.readLabelNames(mesher, mesh, table);
            Checks.equal(Map.of(1, "heart", 7, "slab"), mesh.labelNames());
            Volume volume = Checks.ballVolume(mesher);
            MeshFiles.readLabelNames(mesher, volume, table);
            Checks.equal(mesh.labelNames(), volume.labelNames());
            MeshFiles.writeMesh(mesher, mesh, folder.resolve("b.dat"), "msh22");
            Checks.check(Files.readString(folder.resolve("b.dat")).contains("2.2"), "no msh 2.2");
            Checks.thrown(IllegalArgumentException.class,
                    () -> MeshFiles.writeMesh(mesher, mesh, folder.resolve("b"), "jpeg"));
            Checks.thrown(CleftException.FileFailure.class,
                    () -> MeshFiles.writeMesh(mesher, mesh, folder.resolve("none/a.vtu")));
        });
    }

    /** Lists a folder, as a program would, and reads what is there. */
    static final class Reader {
        public static void main(String[] arguments) throws Exception {
            try (var paths = Files.list(Path.of(arguments[0])); Mesher mesher = new Mesher()) {
                for (Path path : paths.toList())
                    System.out.println(MeshFiles.readVolume(mesher, path).labels().length + " labels");
            }
        }
    }

    /** Names of files are bytes; the locale may have no letters for them. */
    void testNamesOfAnyBytes() throws Exception {
        inFolder(folder -> {
            String script = "cp \"$1\" \"$(printf '%s/\\303\\244 %%.nrrd' \"$2\")\" && "
                    + "LC_ALL=C \"$3\" -cp \"$4\" 'FilesTest$Reader' \"$2\"; rm -f \"$2\"/*";
            Process process = new ProcessBuilder("sh", "-c", script, "sh", DATA.resolve("mickey.nrrd").toString(),
                    folder.toString(), System.getenv("JAVA"), System.getProperty("java.class.path"))
                    .redirectErrorStream(true).start();
            Checks.equal("5 labels\n", new String(process.getInputStream().readAllBytes()));
        });
    }

    void testVolumes() throws Exception {
        Path path = DATA.resolve("mickey.nrrd");
        Volume volume = MeshFiles.readVolume(mesher, path);
        Checks.check(volume.labels().length > 1, "no labels");
        Checks.equal(MeshFiles.Content.VOLUME, MeshFiles.guess(path));
        var reading = new MeshFiles.Reading(
                MeshFiles.World.RAS, MeshFiles.VoxelKind.LABELS, new double[] {0, 0, 9});
        Volume other = MeshFiles.readVolume(mesher, reading, null, path);
        Checks.near(-volume.affine()[0], other.affine()[0], 1e-12);
        Checks.near(9, Math.abs(other.affine()[10]), 1e-12);
    }

    void testScale() {
        Path path = DATA.resolve("mickey.nrrd");
        double[] millimetres = MeshFiles.readVolume(mesher, path).affine();
        double[] metres = MeshFiles.readVolume(mesher, MeshFiles.Reading.DEFAULT.scaled(0.001), null, path).affine();
        for (int i = 0; i < 12; ++i)
            Checks.near(millimetres[i] / 1000, metres[i], 1e-12);
    }

    /** A sentence may have any letters in it, also where it is cut off. */
    void testSentences() {
        String name = "\u00e4\ud83d\ude00".repeat(40);
        String folder = ("/no-" + name).repeat(5);
        for (String prefix : new String[] {"", "a", "aa", "aaa", "aaaa", "aaaaa"}) {
            String sentence = Checks.thrown(CleftException.FileFailure.class,
                    () -> MeshFiles.readMesh(mesher, Path.of("/" + prefix + folder + ".vtu"))).getMessage();
            Checks.check(sentence.contains("/no-" + name), sentence);
        }
    }

    void testRaw() throws Exception {
        inFolder(folder -> {
            Path path = folder.resolve("labels.raw");
            byte[] labels = Checks.ballLabels();
            byte[] shorts = new byte[4 + 2 * labels.length];
            for (int i = 0; i < labels.length; ++i)
                shorts[5 + 2 * i] = labels[i];
            Files.write(path, shorts);
            RawVoxels raw = new RawVoxels(VoxelType.INT16, 12, 13, 14).bigEndian(true);
            Volume volume = MeshFiles.readRaw(mesher, raw.skip(4), null, path);
            Checks.check(Checks.same(Checks.ballMesh(mesher), mesher.mesh(volume, Checks.quick())), "another mesh");
            Volume tall = MeshFiles.readRaw(mesher, raw.skip(4).spacing(1, 1, 2), null, path);
            Checks.equal(new Grid(12, 13, 14).spacing(1, 1, 2), tall.grid());
            Checks.thrown(CleftException.InvalidFormat.class, () -> MeshFiles.readRaw(mesher, raw, null, path));
        });
    }

    /** The kind decides what voxels mean, not their type; the volume reports how many functions it holds. */
    void testRawKinds() throws Exception {
        inFolder(folder -> {
            ByteBuffer whole = ByteBuffer.allocate(4 * 8).order(ByteOrder.LITTLE_ENDIAN);
            ByteBuffer rest = ByteBuffer.allocate(4 * 8).order(ByteOrder.LITTLE_ENDIAN);
            for (int voxel = 0; voxel < 8; ++voxel) {
                whole.putFloat(voxel % 2);
                rest.putFloat(1 - voxel % 2);
            }
            Path one = Files.write(folder.resolve("one.raw"), whole.array());
            Path two = Files.write(folder.resolve("two.raw"), rest.array());
            RawVoxels raw = new RawVoxels(VoxelType.FLOAT32, 2, 2, 2);
            for (MeshFiles.VoxelKind kind : MeshFiles.VoxelKind.values()) {
                boolean asFunctions = kind == MeshFiles.VoxelKind.INDICATORS;
                Checks.equal(
                        asFunctions ? 1L : 0L,
                        MeshFiles.readRaw(mesher, raw.kind(kind), null, one).indicatorCount());
                Checks.equal(
                        asFunctions ? 2L : 0L,
                        MeshFiles.readRaw(mesher, raw.kind(kind), null, one, two).indicatorCount());
            }
        });
    }

    void testMetric() throws Exception {
        inFolder(folder -> {
            Path path = folder.resolve("metric.nrrd");
            Volume volume = Checks.ballVolume(mesher);
            Sizing sizing = mesher.constantMetricSizing(volume, new double[] {0.3, 0.01, -0.02, 0.4, 0.03, 0.5});
            MeshFiles.writeSizing(mesher, sizing, MeshFiles.World.LPS, path);
            for (Volume given : new Volume[] {volume, null}) {
                float[] again = MeshFiles.readMetric(mesher, given, MeshFiles.Reading.DEFAULT,
                        MeshFiles.TensorOrder.FILE, false, null, path).metric();
                float[] wanted = sizing.metric();
                Checks.equal(wanted.length, again.length);
                for (int i = 0; i < wanted.length; ++i)
                    Checks.check(Math.abs(wanted[i] - again[i]) < 1e-5, "a tensor comes back");
            }
        });
    }

    void testSizing() throws Exception {
        inFolder(folder -> {
            Path path = folder.resolve("sizes.nrrd");
            Volume volume = Checks.ballVolume(mesher);
            Sizing sizing = mesher.sizing(volume, new Options().size(2.5));
            MeshFiles.writeSizing(mesher, sizing, MeshFiles.World.LPS, path);
            Sizing again = MeshFiles.readSizing(mesher, volume, MeshFiles.Reading.DEFAULT, false, null, path);
            Checks.equal(sizing.values(), again.values());
            MeshFiles.Field field = MeshFiles.readField(mesher, MeshFiles.Reading.DEFAULT, path);
            Checks.equal(volume.dims(), field.grid().dims());
            Checks.check(Arrays.stream(field.values()).allMatch(value -> value == field.values()[0]), "values");
        });
    }

    void testPictures() throws Exception {
        inFolder(folder -> {
            Path path = folder.resolve("a.png");
            Mesh mesh = Checks.ballMesh(mesher);
            Picture picture = new Picture().size(64, 48).cut(0, 0.5).cut(2, 0.5).legend(true);
            MeshFiles.writePicture(mesher, mesh, picture, path);
            ByteBuffer start = ByteBuffer.wrap(Files.readAllBytes(path));
            Checks.equal(64, start.getInt(16));
            Checks.equal(48, start.getInt(20));
            MeshFiles.writePicture(mesher, mesh, picture.by(MeshFiles.Colouring.ANGLE).range(0, 90)
                    .backdrop(MeshFiles.Backdrop.NONE).view(0, 0, 1).up(1, 0, 0).zoom(2).edges(false).lineWidth(2)
                    .whole(1), path);
            Checks.equal(6, (int) Files.readAllBytes(path)[25]);
            Checks.thrown(CleftException.InvalidArgument.class,
                    () -> MeshFiles.writePicture(mesher, mesh, picture.cut(1, 1.5), path));
            Checks.thrown(CleftException.InvalidArgument.class,
                    () -> MeshFiles.writePicture(mesher, mesh, picture.strip(mesh.labels()), path));
            Checks.thrown(IllegalArgumentException.class, () -> picture.cut(3, 0.5));
            Checks.thrown(IllegalArgumentException.class, () -> picture.zoom(0));
            Checks.thrown(NullPointerException.class, () -> MeshFiles.writePicture(mesher, mesh, null, path));
        });
    }

    void testViews() throws Exception {
        inFolder(folder -> {
            Path path = folder.resolve("a.html");
            Path names = folder.resolve("names.txt");
            Mesh mesh = Checks.ballMesh(mesher);
            MeshFiles.writeView(mesher, mesh, new View(), path);
            Checks.check(Files.readString(path).contains("<title>Mesh</title>"), "no title");
            Files.writeString(names, "1 inner\n");
            View view = new View().title("a").report("{\"a\":1}").names(names).goal(15).maxTets(5);
            MeshFiles.writeView(mesher, mesh, view.other(mesh, "b", ""), path);
            String page = Files.readString(path);
            for (String part : new String[] {"<title>a | b</title>", "{\"a\":1}", "\"name\":\"inner\"", "\"goal\":15,",
                    "\"shown_tets\":5,"})
                Checks.check(page.contains(part), "no " + part);
            Checks.thrown(CleftException.InvalidArgument.class,
                    () -> MeshFiles.writeView(mesher, mesh, view.goal(91), path));
            Checks.thrown(IllegalArgumentException.class, () -> view.maxTets(0));
            Checks.thrown(IllegalArgumentException.class,
                    () -> MeshFiles.writeView(mesher, mesh, view.title("a\0"), path));
        });
    }

    void testFormats() {
        Checks.check(MeshFiles.formats().stream().anyMatch(row -> row.name().equals("vtu") && row.readsMesh()
                && row.writesMesh() && row.extensions().contains(".vtu")), "no vtu");
        Checks.check(MeshFiles.formats().stream().anyMatch(row -> row.readsVolume()), "no volumes");
    }

    void testFailures() throws Exception {
        inFolder(folder -> {
            Path broken = folder.resolve("broken.vtu");
            Files.writeString(broken, "not XML");
            Checks.thrown(CleftException.InvalidFormat.class, () -> MeshFiles.readMesh(mesher, broken));
            Checks.thrown(CleftException.FileFailure.class, () -> MeshFiles.readMesh(mesher, folder.resolve("a.vtu")));
            Checks.thrown(
                    CleftException.FileFailure.class, () -> MeshFiles.readVolume(mesher, folder.resolve("a.nii")));
            Checks.thrown(CleftException.InvalidArgument.class,
                    () -> MeshFiles.readVolume(mesher, MeshFiles.Reading.DEFAULT, null));
            Checks.thrown(NullPointerException.class, () -> MeshFiles.readMesh(mesher, null));
            Checks.thrown(NullPointerException.class, () -> MeshFiles.writeMesh(mesher, null, broken));
            Checks.thrown(IllegalArgumentException.class, () -> new MeshFiles.Reading(
                    MeshFiles.World.LPS, MeshFiles.VoxelKind.AUTO, new double[2]));
            mesher.close();
            Checks.thrown(IllegalStateException.class, () -> MeshFiles.readMesh(mesher, broken));
        });
    }
}
