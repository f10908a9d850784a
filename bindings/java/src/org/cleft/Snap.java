// Made by tools/generate.py from src/capi/options.toml.
package org.cleft;

/** Rules that move background points onto interfaces. */
public enum Snap {
    /** By the quality of the surrounding elements. */
    QUALITY(CleftNative.CLEFT_SNAP_QUALITY),
    /** By the safe distances of the published method. */
    SAFE(CleftNative.CLEFT_SNAP_SAFE),
    /** No point moves. */
    NONE(CleftNative.CLEFT_SNAP_NONE);

    final int number;

    Snap(int number) {
        this.number = number;
    }
}
