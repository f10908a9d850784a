package org.cleft;

import java.nio.IntBuffer;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;

/**
 * A labelled volume, or indicator functions; made by a {@link Mesher} or read by {@link MeshFiles}. It never
 * changes, but for the names of its labels.
 */
public final class Volume extends NativeObject {
    Volume(long address) {
        super("Volume", address, NativeSize.ofVolume(address), CleftNative::cleft_volume_destroy);
    }

    /**
     * The numbers of voxels along x, y and z.
     *
     * @return three numbers
     */
    public long[] dims() {
        long[] dims = new long[3];
        checked(address -> CleftNative.cleft_volume_dims(address, dims));
        return dims;
    }

    /**
     * The matrix from voxel indices to the world.
     *
     * @return 3 rows of 4 numbers
     */
    public double[] affine() {
        double[] affine = new double[12];
        checked(address -> CleftNative.cleft_volume_affine(address, affine));
        return affine;
    }

    /**
     * Voxels and their place in the world.
     *
     * @return a grid
     */
    public Grid grid() {
        long[] dims = dims();
        return new Grid(dims[0], dims[1], dims[2]).affine(affine());
    }

    /**
     * The label of each material.
     *
     * @return a copy
     */
    public int[] labels() {
        IntBuffer view =
                view(CleftNative::cleft_volume_labels, address -> 4 * CleftNative.cleft_volume_label_count(address))
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
        return with(address -> CleftNative.cleft_volume_label_name(address, label));
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
     * Names a label. Meshes that are made of the volume after that have the name too. Not while another thread uses the
     * volume.
     *
     * @param label a label of the volume
     * @param name one line of text; "" takes the name away
     * @return this volume
     */
    public Volume labelName(int label, String name) {
        LabelNames.check("the volume", labels(), label, name);
        checked(address -> CleftNative.cleft_volume_set_label_name(address, label, name));
        return this;
    }

    /**
     * How many indicator functions the volume has. Tells what a file was taken for.
     *
     * @return 1 for a signed function, 0 for a label map
     */
    public long indicatorCount() {
        return with(CleftNative::cleft_volume_indicator_count);
    }

    /**
     * How many voxels each label has.
     *
     * @return from label to count, in the order of {@link #labels}
     */
    public Map<Integer, Long> voxelCounts() {
        int[] labels = labels();
        long[] counts = new long[labels.length];
        checked(address -> CleftNative.cleft_volume_copy_voxel_counts(address, counts, counts.length));
        Map<Integer, Long> map = new LinkedHashMap<>();
        for (int i = 0; i < labels.length; ++i)
            map.put(labels[i], counts[i]);
        return map;
    }

    /**
     * The labels at points of the world, as the mesh sees them.
     *
     * @param points x y z of each
     * @return a label a point
     */
    public int[] sample(double... points) {
        Arguments.groups("points", Objects.requireNonNull(points, "points").length, 3, "point");
        for (int i = 0; i < points.length; ++i)
            Arguments.finitePoint("points[" + i + "]", points[i]);
        int[] labels = new int[points.length / 3];
        checked(address -> CleftNative.cleft_volume_sample(address, points, labels.length, labels));
        return labels;
    }

    @Override
    String description() {
        return " of " + grid().size() + " voxels, " + labels().length + " labels";
    }
}
