package org.cleft;

import java.util.ArrayList;
import java.util.List;

/**
 * One row of the library's table of options.
 *
 * @param name as in "feature_scale"
 * @param type what values it takes
 * @param defaultValue the default, as a number
 * @param least the least value
 * @param greatest the greatest value
 * @param choices names of the choices 0, 1, ...; empty for other types
 * @param text what it does
 * @param group the heading under which help lists it
 * @param calls the calls that read it, as C names them: "volume", "sizing", "background", "cleave", "improve", "mesh"
 */
public record OptionDescription(
        String name,
        Type type,
        double defaultValue,
        double least,
        double greatest,
        List<String> choices,
        String text,
        String group,
        List<String> calls) {
    /** What values an option takes. */
    public enum Type {
        // <constants> made by tools/generate.py from include/cleft/cleft.h
        /** Whole numbers. */
        INTEGER,
        /** Real numbers. */
        REAL,
        /** One of several names. */
        CHOICE,
        /** On or off. */
        FLAG
        // </constants>
    }

    /**
     * All options that have one value.
     *
     * @return the rows of the table
     */
    public static List<OptionDescription> table() {
        NativeLibrary.core();
        List<OptionDescription> rows = new ArrayList<>();
        NativeOptionDescription row = new NativeOptionDescription();
        try {
            for (int index = 0; index < CleftNative.cleft_option_count(); ++index) {
                CleftException.check(CleftNative.cleft_option_info(index, row));
                String choices = row.getChoices();
                rows.add(new OptionDescription(row.getName(), Type.values()[row.getType() - 1], row.getValue(),
                        row.getLeast(), row.getGreatest(),
                        choices.isEmpty() ? List.of() : List.of(choices.split("\\|")),
                        row.getText(), row.getGroup(), List.of(row.getCalls().split("\\|"))));
            }
        } finally {
            row.delete();
        }
        return List.copyOf(rows);
    }
}
