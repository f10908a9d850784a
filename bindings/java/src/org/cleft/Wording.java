package org.cleft;

import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/**
 * Sentences of the library, in which options are called as the methods of {@link Options} are: sizeMax for size_max.
 */
final class Wording {
    private static final Pattern WORDS = Pattern.compile("\\b[a-z]+(_[a-z]+)+\\b");
    private static final Map<String, String> METHODS = OptionDescription.table().stream()
            .collect(Collectors.toMap(OptionDescription::name, row -> methodOf(row.name())));

    private Wording() {}

    /** The sentence for one who writes Java. What is quoted, names of files, stays as it is. */
    static String inJava(String sentence) {
        int first = sentence.indexOf('\'');
        int end = sentence.lastIndexOf('\'') + 1;
        if (first < 0)
            return renamed(sentence);
        return renamed(sentence.substring(0, first)) + sentence.substring(first, end)
                + renamed(sentence.substring(end));
    }

    private static String renamed(String part) {
        return WORDS.matcher(part).replaceAll(word -> METHODS.getOrDefault(word.group(), word.group()));
    }

    private static String methodOf(String option) {
        return Pattern.compile("_(.)").matcher(option).replaceAll(letter -> letter.group(1).toUpperCase());
    }
}
