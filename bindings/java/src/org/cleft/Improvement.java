// Made by tools/generate.py from src/capi/options.toml.
package org.cleft;

/** Effort spent on the worst dihedral angles. */
public enum Improvement {
    /** None. */
    OFF(CleftNative.CLEFT_IMPROVE_OFF),
    /** Some: the default. */
    FAST(CleftNative.CLEFT_IMPROVE_FAST),
    /** As much as helps. */
    BEST(CleftNative.CLEFT_IMPROVE_BEST);

    final int number;

    Improvement(int number) {
        this.number = number;
    }
}
