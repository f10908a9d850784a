package org.cleft;

import java.util.AbstractList;
import java.util.ArrayList;
import java.util.List;

/**
 * What became of each label: a row a label, in the order of {@link Volume#labels}; and the labels that came to touch.
 */
public final class Report extends AbstractList<LabelReport> {
    private final List<LabelReport> rows;
    private final List<Contact> contacts;
    private final List<Distance> distances;

    /** Reads a report of the library, whose owner stays the caller. */
    Report(long report) {
        rows = rowsOf(report);
        contacts = contactsOf(report);
        distances = distancesOf(report);
    }

    /**
     * Pairs of labels that touch in the mesh, but not in the volume.
     *
     * @return the pairs, ascending; empty if all is well
     */
    public List<Contact> contacts() {
        return contacts;
    }

    /**
     * How far the interfaces of the mesh are from those of the volume.
     *
     * @return interfaces by their labels, then lines; empty if they were not asked for
     */
    public List<Distance> distances() {
        return distances;
    }

    @Override
    public LabelReport get(int index) {
        return rows.get(index);
    }

    @Override
    public int size() {
        return rows.size();
    }

    private static List<LabelReport> rowsOf(long report) {
        NativeLabelReport row = new NativeLabelReport();
        try {
            List<LabelReport> rows = new ArrayList<>();
            for (long index = 0; index < CleftNative.cleft_report_count(report); ++index) {
                CleftException.check(CleftNative.cleft_report_label(report, index, row));
                rows.add(LabelReport.of(row));
            }
            return List.copyOf(rows);
        } finally {
            row.delete();
        }
    }

    private static List<Distance> distancesOf(long report) {
        NativeDistance row = new NativeDistance();
        try {
            List<Distance> distances = new ArrayList<>();
            for (long index = 0; index < CleftNative.cleft_report_distance_count(report); ++index) {
                CleftException.check(CleftNative.cleft_report_distance(report, index, row));
                distances.add(Distance.of(row));
            }
            return List.copyOf(distances);
        } finally {
            row.delete();
        }
    }

    private static List<Contact> contactsOf(long report) {
        NativeContact row = new NativeContact();
        try {
            List<Contact> contacts = new ArrayList<>();
            for (long index = 0; index < CleftNative.cleft_report_contact_count(report); ++index) {
                CleftException.check(CleftNative.cleft_report_contact(report, index, row));
                contacts.add(Contact.of(row));
            }
            return List.copyOf(contacts);
        } finally {
            row.delete();
        }
    }
}
