package org.cleft;

import java.nio.DoubleBuffer;
import java.nio.IntBuffer;
import java.util.Map;

/**
 * Points, tetrahedra and their labels; a background mesh has the label 0 only. Made by a {@link Mesher} or read by
 * {@link MeshFiles}; it never changes, but for the names of its labels, and may be read by many threads.
 *
 * <p>Arrays are copies. Views are read-only buffers over the library's memory, which they keep: they stay good when the
 * mesh is closed or collected, and the memory is freed with the last of them. A view cannot have more than 2 GiB.
 */
public final class Mesh extends NativeObject {
    Mesh(long address) {
        super("Mesh", address, NativeSize.ofMesh(address), CleftNative::cleft_mesh_destroy);
    }

    /**
     * How many points there are.
     *
     * @return their number
     */
    public long pointCount() {
        return with(CleftNative::cleft_mesh_point_count);
    }

    /**
     * How many tetrahedra there are.
     *
     * @return their number
     */
    public long tetCount() {
        return with(CleftNative::cleft_mesh_tet_count);
    }

    /**
     * World coordinates, x y z of each point.
     *
     * @return a copy
     */
    public double[] points() {
        double[] points = new double[length(pointCount(), 3)];
        checked(address -> CleftNative.cleft_mesh_copy_points(address, points, points.length));
        return points;
    }

    /**
     * The corners of each tetrahedron, 4 numbers of points from 0, positively oriented.
     *
     * @return a copy
     */
    public int[] tets() {
        return tets(0);
    }

    /**
     * The corners of each tetrahedron, 4 numbers of points.
     *
     * @param indexBase the number of the first point, 0 or 1
     * @return a copy
     */
    public int[] tets(int indexBase) {
        int[] tets = new int[length(tetCount(), 4)];
        Arguments.indexBase(indexBase);
        checked(address -> CleftNative.cleft_mesh_copy_tets(address, indexBase, tets, tets.length));
        return tets;
    }

    /**
     * The label of each tetrahedron.
     *
     * @return a copy
     */
    public int[] tetLabels() {
        int[] labels = new int[length(tetCount(), 1)];
        checked(address -> CleftNative.cleft_mesh_copy_tet_labels(address, labels, labels.length));
        return labels;
    }

    /**
     * The labels that occur.
     *
     * @return a copy, ascending
     */
    public int[] labels() {
        IntBuffer view =
                view(CleftNative::cleft_mesh_labels, address -> 4 * CleftNative.cleft_mesh_label_count(address))
                        .asIntBuffer();
        int[] labels = new int[view.remaining()];
        view.get(labels);
        return labels;
    }

    /**
     * The name of a label, as a file gave it or {@link #labelName(int, String)} did.
     *
     * @param label the label
     * @return the name, "" if it has none
     */
    public String labelName(int label) {
        return with(address -> CleftNative.cleft_mesh_label_name(address, label));
    }

    /**
     * The labels that have a name.
     *
     * @return from label to name, in the order of {@link #labels}
     */
    public Map<Integer, String> labelNames() {
        return LabelNames.of(labels(), this::labelName);
    }

    /**
     * Names a label. A mesh begins with the names of its volume; formats that have names for groups write them. Not
     * while another thread uses the mesh.
     *
     * @param label a label of the mesh
     * @param name one line of text; "" takes the name away
     * @return this mesh
     */
    public Mesh labelName(int label, String name) {
        LabelNames.check("the mesh", labels(), label, name);
        checked(address -> CleftNative.cleft_mesh_set_label_name(address, label, name));
        return this;
    }

    /**
     * World coordinates, x y z of each point, without a copy.
     *
     * @return a view
     */
    public DoubleBuffer pointsView() {
        return view(CleftNative::cleft_mesh_points, address -> 24 * CleftNative.cleft_mesh_point_count(address))
                .asDoubleBuffer();
    }

    /**
     * The corners of each tetrahedron, from 0, without a copy.
     *
     * @return a view
     */
    public IntBuffer tetsView() {
        return view(CleftNative::cleft_mesh_tets, address -> 16 * CleftNative.cleft_mesh_tet_count(address))
                .asIntBuffer();
    }

    /**
     * The label of each tetrahedron, without a copy.
     *
     * @return a view
     */
    public IntBuffer tetLabelsView() {
        return view(CleftNative::cleft_mesh_tet_labels, address -> 4 * CleftNative.cleft_mesh_tet_count(address))
                .asIntBuffer();
    }

    /**
     * Points and tetrahedra of ten nodes.
     *
     * @param points those of the mesh, then the middles of the edges: x y z of each
     * @param tets 4 corners, then the middles of the edges 01, 12, 02, 03, 13, 23
     */
    public record Quadratic(double[] points, int[] tets) {}

    /**
     * Tetrahedra of ten nodes, with a point at the middle of each edge.
     *
     * @param indexBase the number of the first point, 0 or 1
     * @return copies
     */
    public Quadratic quadratic(int indexBase) {
        Arguments.indexBase(indexBase);
        long[] count = new long[1];
        checked(address -> CleftNative.cleft_mesh_copy_quadratic(address, indexBase, null, 0, null, 0, count));
        double[] points = new double[length(count[0], 3)];
        int[] tets = new int[length(tetCount(), 10)];
        checked(address -> CleftNative.cleft_mesh_copy_quadratic(
                address, indexBase, points, points.length, tets, tets.length, count));
        return new Quadratic(points, tets);
    }

    @Override
    String description() {
        return " of " + pointCount() + " points, " + tetCount() + " tetrahedra, " + labels().length + " labels";
    }
}
