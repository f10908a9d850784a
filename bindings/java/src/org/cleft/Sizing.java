package org.cleft;

import java.nio.FloatBuffer;

/** The wanted edge length at each point; made by a {@link Mesher} or read by {@link MeshFiles}. It never changes. */
public final class Sizing extends NativeObject {
    Sizing(long address) {
        super("Sizing", address, NativeSize.ofSizing(address), CleftNative::cleft_sizing_destroy);
    }

    /**
     * The numbers of values along x, y and z.
     *
     * @return three numbers
     */
    public long[] dims() {
        long[] dims = new long[3];
        checked(address -> CleftNative.cleft_sizing_dims(address, dims));
        return dims;
    }

    /**
     * The matrix from indices to the world.
     *
     * @return 3 rows of 4 numbers
     */
    public double[] affine() {
        double[] affine = new double[12];
        checked(address -> CleftNative.cleft_sizing_affine(address, affine));
        return affine;
    }

    /**
     * The values, x fastest, without a copy: read-only, and good as long as the buffer is held. Of a field with a
     * metric, these are the lengths of regular tetrahedra that are as large.
     *
     * @return a view
     */
    public FloatBuffer valuesView() {
        long[] dims = dims();
        return view(CleftNative::cleft_sizing_values, address -> 4 * dims[0] * dims[1] * dims[2]).asFloatBuffer();
    }

    /**
     * The values, x fastest.
     *
     * @return a copy
     */
    public float[] values() {
        FloatBuffer view = valuesView();
        float[] values = new float[view.remaining()];
        view.get(values);
        return values;
    }

    /**
     * Do the wanted lengths depend on the direction?
     *
     * @return whether the field has a metric
     */
    public boolean hasMetric() {
        return with(address -> CleftNative.cleft_sizing_has_metric(address) != 0);
    }

    /**
     * The metric: xx, xy, xz, yy, yz, zz of each voxel, x fastest. A field without one throws a {@link CleftException}.
     *
     * @return a copy
     */
    public float[] metric() {
        long[] dims = dims();
        float[] tensors = new float[hasMetric() ? length(dims[0] * dims[1] * dims[2], 6) : 0];
        checked(address -> CleftNative.cleft_sizing_copy_metric(address, tensors, tensors.length));
        return tensors;
    }

    /**
     * The field at a point of the world.
     *
     * @param x of the point
     * @param y of the point
     * @param z of the point
     * @return the wanted edge length there
     */
    public double at(double x, double y, double z) {
        Arguments.finitePoint("x", x);
        Arguments.finitePoint("y", y);
        Arguments.finitePoint("z", z);
        double[] size = new double[1];
        checked(address -> CleftNative.cleft_sizing_at(address, new double[] {x, y, z}, size));
        return size[0];
    }

    /**
     * Tetrahedra that a background of this field will have, within some 10 %.
     *
     * @return their number
     */
    public double expectedTets() {
        return with(CleftNative::cleft_sizing_expected_tets);
    }

    @Override
    String description() {
        return " of about " + Math.round(expectedTets()) + " tetrahedra";
    }
}
