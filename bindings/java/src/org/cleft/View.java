package org.cleft;

import java.nio.file.Path;
import java.util.Objects;

/**
 * What a page that shows a mesh has besides: {@code new View().title("head").report(json)}. It never changes: the
 * methods that set something answer a new one.
 */
public final class View implements Cloneable {
    private String title = "";
    private String report = "";
    private Path names;
    private double goal;
    private long maxTets;
    private Mesh other;
    private String otherTitle = "";
    private String otherReport = "";

    /** One mesh, without a report. */
    public View() {}

    private interface Change {
        void make(View twin);
    }

    private View with(Change change) {
        try {
            View twin = (View) clone();
            change.make(twin);
            return twin;
        } catch (CloneNotSupportedException impossible) {
            throw new AssertionError(impossible);
        }
    }

    /**
     * The same with a title.
     *
     * @param text what the mesh is called
     * @return a description
     */
    public View title(String text) {
        Objects.requireNonNull(text, "text");
        return with(twin -> twin.title = text);
    }

    /**
     * The same with the report of a run.
     *
     * @param json what {@code cleft mesh --json} reported
     * @return a description
     */
    public View report(String json) {
        Objects.requireNonNull(json, "json");
        return with(twin -> twin.report = json);
    }

    /**
     * The same with names of labels.
     *
     * @param table a file with a label and its name a line, or a table of ITK-SNAP or FreeSurfer
     * @return a description
     */
    public View names(Path table) {
        Objects.requireNonNull(table, "table");
        return with(twin -> twin.names = table);
    }

    /**
     * The same with another goal.
     *
     * @param degrees the least dihedral angle that is marked
     * @return a description
     */
    public View goal(double degrees) {
        Arguments.positive("degrees", degrees);
        return with(twin -> twin.goal = degrees);
    }

    /**
     * The same with another limit.
     *
     * @param tets how many tetrahedra the page has at most
     * @return a description
     */
    public View maxTets(long tets) {
        if (tets < 1)
            throw new IllegalArgumentException("tets is " + tets + "; it must be at least 1");
        return with(twin -> twin.maxTets = tets);
    }

    /**
     * The same with a second mesh to compare with.
     *
     * @param mesh the mesh
     * @param text what it is called
     * @param json its report, or ""
     * @return a description
     */
    public View other(Mesh mesh, String text, String json) {
        Objects.requireNonNull(mesh, "mesh");
        Objects.requireNonNull(text, "text");
        Objects.requireNonNull(json, "json");
        return with(twin -> {
            twin.other = mesh;
            twin.otherTitle = text;
            twin.otherReport = json;
        });
    }

    Mesh second() {
        return other;
    }

    Path table() {
        return names;
    }

    /** Writes the page; {@code handles} are those of the two meshes. */
    int write(long context, long[] handles, byte[] table, byte[] path) {
        return CleftIoNative.cleft_io_write_view(context, handles[0], maxTets, goal, Text.bytes("title", title),
                Text.bytes("report", report), table, handles[1], Text.bytes("otherTitle", otherTitle),
                Text.bytes("otherReport", otherReport), path);
    }
}
