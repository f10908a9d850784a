// Made by tools/generate.py from src/capi/options.toml.
package org.cleft;

/** Engines of Delaunay tetrahedra, which give the same mesh. */
public enum DelaunayEngine {
    /** Cleft's own, which works on all threads. */
    CLEFT(CleftNative.CLEFT_DELAUNAY_CLEFT),
    /** TetGen, on one thread; refused where the library has no TetGen. */
    TETGEN(CleftNative.CLEFT_DELAUNAY_TETGEN);

    final int number;

    DelaunayEngine(int number) {
        this.number = number;
    }
}
