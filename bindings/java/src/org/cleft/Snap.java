// Made by tools/generate.py from src/capi/options.toml.
package org.cleft;

/** Rules that move background points onto interfaces. */
public enum Snap {
    /** By the quality of the elements around. */
    QUALITY(CleftNative.CLEFT_SNAP_QUALITY),
    /** By the safe distances of the paper. */
    SAFE(CleftNative.CLEFT_SNAP_SAFE),
    /** Never. */
    NONE(CleftNative.CLEFT_SNAP_NONE);

    final int number;

    Snap(int number) {
        this.number = number;
    }
}
