// Made by tools/generate.py from src/capi/options.toml.
package org.cleft;

/** Effort spent on the worst dihedral angles. */
public enum Improvement {
    /** No improvement. */
    OFF(CleftNative.CLEFT_IMPROVE_OFF),
    /** Moderate effort, the default. */
    FAST(CleftNative.CLEFT_IMPROVE_FAST),
    /** Effort until nothing improves further. */
    BEST(CleftNative.CLEFT_IMPROVE_BEST);

    final int number;

    Improvement(int number) {
        this.number = number;
    }
}
