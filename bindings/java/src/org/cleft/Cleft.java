package org.cleft;

/** What there is to know of the library. */
public final class Cleft {
    private Cleft() {}

    /**
     * The version of the native library.
     *
     * @return as in "1.2.3"
     */
    public static String version() {
        NativeLibrary.core();
        return CleftNative.cleft_version(null, null, null);
    }

    /**
     * Is TetGen in this build, so that it can make {@link DelaunayEngine#TETGEN} meshes?
     *
     * @return whether it can
     */
    public static boolean hasTetgen() {
        NativeLibrary.core();
        return CleftNative.cleft_has_tetgen() != 0;
    }
}
