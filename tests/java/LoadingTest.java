import java.io.File;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Enumeration;
import java.util.List;
import java.util.zip.ZipEntry;
import java.util.zip.ZipFile;

/** Where the native library comes from: the property, else the jar, which leaves nothing behind. */
final class LoadingTest {
    public static void main(String[] arguments) throws Exception {
        Checks.runAll(LoadingTest.class);
    }

    /** What a program that makes a small mesh prints. */
    private static String run(boolean succeeds, String... properties) throws Exception {
        List<String> command =
                new ArrayList<>(List.of(System.getenv("JAVA"), "-cp", System.getProperty("java.class.path")));
        command.addAll(List.of(properties));
        command.add("LoadingTest$Program");
        Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
        String output = new String(process.getInputStream().readAllBytes());
        Checks.check((process.waitFor() == 0) == succeeds, output);
        return output;
    }

    static final class Program {
        public static void main(String[] arguments) throws Exception {
            System.out.println(org.cleft.Cleft.version() + " " + org.cleft.MeshFiles.formats().size());
            Files.readAllLines(Path.of("/proc/self/maps")).stream().filter(line -> line.contains("libcleft"))
                    .forEach(System.out::println);
        }
    }

    void testFromTheJar() throws Exception {
        Path folder = Files.createTempDirectory("cleft-test-");
        String output = run(true, "-Djava.io.tmpdir=" + folder);
        Checks.check(output.contains(folder + File.separator + "cleft-"), output);
        for (String name : List.of("libcleft.so.0", "libcleft_io.so.0", "libcleft_java.so", "libcleft_io_java.so"))
            Checks.check(output.contains(name), output);
        Files.delete(folder);  // fails if something was left in it
    }

    void testFromTheProperty() throws Exception {
        Path folder = Files.createTempDirectory("cleft-test-");
        String jar = System.getProperty("java.class.path").split(File.pathSeparator)[0];
        List<Path> files = new ArrayList<>();
        try (ZipFile zip = new ZipFile(jar)) {
            for (Enumeration<? extends ZipEntry> entries = zip.entries(); entries.hasMoreElements();) {
                ZipEntry entry = entries.nextElement();
                if (entry.getName().contains(".so")) {
                    files.add(folder.resolve(Path.of(entry.getName()).getFileName().toString()));
                    Files.copy(zip.getInputStream(entry), files.get(files.size() - 1));
                }
            }
        }
        String output = run(true, "-Dorg.cleft.library.path=" + folder);
        Checks.check(output.contains(folder + "/libcleft_java.so"), output);
        for (Path file : files)
            Files.delete(file);
        Files.delete(folder);
    }

    void testLicenceIsInTheJar() throws Exception {
        String jar = System.getProperty("java.class.path").split(File.pathSeparator)[0];
        try (ZipFile zip = new ZipFile(jar)) {
            Checks.check(zip.getEntry("META-INF/LICENSE") != null, "no licence");
        }
    }

    void testFromNowhere() throws Exception {
        String output = run(false, "-Dorg.cleft.library.path=/no/such/folder");
        Checks.check(output.contains("UnsatisfiedLinkError") && output.contains("from org.cleft.library.path: ")
                && output.contains("/no/such/folder/libcleft_java.so") && output.contains("libtet1.5"), output);
        output = run(false, "-Djava.io.tmpdir=/no/such/folder");
        Checks.check(output.contains("org.cleft.library.path") && output.contains("from the jar: no folder")
                && output.contains("java.io.tmpdir"), output);
    }
}
