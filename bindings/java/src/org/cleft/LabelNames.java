package org.cleft;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.function.IntFunction;

/** What volumes and meshes share of the names of labels. */
final class LabelNames {
    private LabelNames() {}

    /** The names that are not empty, in the order of the labels. */
    static Map<Integer, String> of(int[] labels, IntFunction<String> name) {
        Map<Integer, String> names = new LinkedHashMap<>();
        for (int label : labels)
            if (!name.apply(label).isEmpty())
                names.put(label, name.apply(label));
        return names;
    }

    /** Throws as the library would, with a sentence. */
    static void check(String what, int[] labels, int label, String name) {
        if (Objects.requireNonNull(name, "name").chars().anyMatch(Character::isISOControl))
            throw CleftException.of(CleftNative.CLEFT_ERROR_ARGUMENT, "name has a control character in it");
        if (Arrays.stream(labels).noneMatch(one -> one == label))
            throw CleftException.of(CleftNative.CLEFT_ERROR_ARGUMENT,
                    "label is " + label + ", which " + what + " has not; it has " + listed(labels));
    }

    private static String listed(int[] labels) {
        int most = 10;
        String some = Arrays.toString(Arrays.copyOf(labels, Math.min(most, labels.length)));
        return some + (labels.length > most ? " and " + (labels.length - most) + " more" : "");
    }
}
