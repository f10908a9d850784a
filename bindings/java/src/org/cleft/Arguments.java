package org.cleft;

import java.util.Arrays;
import java.util.Objects;

/** What arguments must be. The sentence on a wrong one has its name in Java, and its value. */
final class Arguments {
    private Arguments() {}

    static void length(String name, long found, long wanted) {
        if (found != wanted)
            throw new IllegalArgumentException(name + " has " + elements(found) + "; it must have " + wanted);
    }

    static void groups(String name, long found, int each, String what) {
        if (found % each != 0)
            throw new IllegalArgumentException(
                    name + " has " + elements(found) + "; it must have " + each + " a " + what);
    }

    static void positive(String name, double value) {
        if (!(value > 0) || Double.isInfinite(value))
            throw new IllegalArgumentException(name + " is " + value + "; it must be above 0 and finite");
    }

    static void finite(String name, double value) {
        if (!Double.isFinite(value))
            throw new IllegalArgumentException(name + " is " + value + "; it must be finite");
    }

    static void finite(String name, double[] values) {
        for (int i = 0; i < values.length; ++i)
            finite(name + "[" + i + "]", values[i]);
    }

    /** As the library refuses points of its world. */
    static void finitePoint(String name, double value) {
        if (!Double.isFinite(value))
            throw CleftException.of(CleftNative.CLEFT_ERROR_NOT_FINITE, name + " is " + value + "; it must be finite");
    }

    static void atLeastOne(String name, long value) {
        if (value < 1)
            throw new IllegalArgumentException(name + " is " + value + "; it must be at least 1");
    }

    static void indexBase(int indexBase) {
        if (indexBase != 0 && indexBase != 1)
            throw new IllegalArgumentException("indexBase is " + indexBase + "; it must be 0 or 1");
    }

    /** Neither the array nor one of its elements may be null. */
    static <T> T[] noNulls(String name, T[] values) {
        Objects.requireNonNull(values, name);
        for (int i = 0; i < values.length; ++i)
            if (values[i] == null)
                throw new NullPointerException(name + "[" + i + "]");
        return values;
    }

    /** All numbers of voxels are there, and their product is a number. */
    static long product(String name, long[] dims) {
        try {
            return Math.multiplyExact(Math.multiplyExact(dims[0], dims[1]), dims[2]);
        } catch (ArithmeticException overflow) {
            throw new IllegalArgumentException(name + " are too many voxels: " + Arrays.toString(dims));
        }
    }

    private static String elements(long count) {
        return count == 1 ? "1 element" : count + " elements";
    }
}
