// Made by tools/generate.py from src/capi/options.toml.
package org.cleft;

/** Kinds of background meshes. */
public enum Background {
    /** Relaxed particles and their Delaunay tetrahedra, which have the best shapes. */
    PARTICLES(CleftNative.CLEFT_BACKGROUND_PARTICLES),
    /** A regular lattice, which is quick and has one size everywhere. */
    LATTICE(CleftNative.CLEFT_BACKGROUND_LATTICE),
    /** An adaptive lattice, which is quick and follows the sizing field. */
    OCTREE(CleftNative.CLEFT_BACKGROUND_OCTREE);

    final int number;

    Background(int number) {
        this.number = number;
    }
}
