package org.cleft;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * Loads the native modules: from the folder that the property org.cleft.library.path names; or those in the jar, by way
 * of a folder of their own that is removed again; or those of the system.
 */
final class NativeLibrary {
    static final String PROPERTY = "org.cleft.library.path";

    private static final List<String> CORE = List.of("libcleft.so.0", "libcleft_java.so");
    private static final List<String> FILES = List.of("libcleft.so.0", "libcleft_io.so.0", "libcleft_io_java.so");

    private static boolean coreLoaded;
    private static boolean filesLoaded;

    private NativeLibrary() {}

    /** Loads what everything needs. */
    static synchronized void core() {
        if (!coreLoaded)
            load("cleft_java", CORE, "libtet1.5");
        coreLoaded = true;
    }

    /** Loads what reads and writes files. */
    static synchronized void files() {
        core();
        if (!filesLoaded)
            load("cleft_io_java", FILES,
                    "libgdcm3.0, libtiff6, libpng16-16, libjpeg62-turbo, libdeflate0 and zlib1g");
        filesLoaded = true;
    }

    private static void load(String name, List<String> files, String needs) {
        List<String> failures = new ArrayList<>();
        if (!loadFromFolder(name, failures) && !loadFromJar(files, failures) && !loadFromSystem(name, failures))
            throw new UnsatisfiedLinkError(
                    "the native library of Cleft cannot be loaded: " + String.join("; ", failures)
                    + ". It needs the Debian packages " + needs + ", and " + PROPERTY + " may name its folder");
    }

    /** From the folder that the property names: if it is set, from nowhere else. */
    private static boolean loadFromFolder(String name, List<String> failures) {
        String folder = System.getProperty(PROPERTY);
        if (folder == null)
            return false;
        try {
            System.load(Path.of(folder, System.mapLibraryName(name)).toAbsolutePath().toString());
            return true;
        } catch (UnsatisfiedLinkError error) {
            failures.add("from " + PROPERTY + ": " + error.getMessage());
            return false;
        }
    }

    private static boolean loadFromSystem(String name, List<String> failures) {
        if (System.getProperty(PROPERTY) != null)
            return false;
        try {
            System.loadLibrary(name);
            return true;
        } catch (UnsatisfiedLinkError error) {
            failures.add("from the system: " + error.getMessage());
            return false;
        }
    }

    /** Loads the last of the files, which finds the others beside itself. */
    private static boolean loadFromJar(List<String> files, List<String> failures) {
        if (System.getProperty(PROPERTY) != null)
            return false;
        String platform = (System.getProperty("os.name") + "-" + System.getProperty("os.arch"))
                .toLowerCase(Locale.ROOT);
        String main = files.get(files.size() - 1);
        if (NativeLibrary.class.getResource(resource(platform, main)) == null) {
            failures.add("the jar has none for " + platform);
            return false;
        }
        Path folder = null;
        try {
            folder = Files.createTempDirectory("cleft-");
            for (String file : files)
                try (InputStream in = NativeLibrary.class.getResourceAsStream(resource(platform, file))) {
                    if (in != null)
                        Files.copy(in, folder.resolve(file));
                }
            System.load(folder.resolve(main).toString());
            return true;
        } catch (IOException error) {
            failures.add("from the jar: no folder can be made for it in java.io.tmpdir (" + error + ")");
            return false;
        } catch (UnsatisfiedLinkError error) {
            failures.add("from the jar: " + error.getMessage());
            return false;
        } finally {
            remove(folder, files);
        }
    }

    private static String resource(String platform, String file) {
        return "/org/cleft/native/" + platform + "/" + file;
    }

    /** A loaded library needs its file no more, where files that are in use can be removed. */
    private static void remove(Path folder, List<String> files) {
        if (folder == null)
            return;
        try {
            for (String file : files)
                Files.deleteIfExists(folder.resolve(file));
            Files.delete(folder);
        } catch (IOException error) {
            folder.toFile().deleteOnExit();
        }
    }
}
