package org.cleft;

/** About how many bytes the objects of the library hold, from the counts that it tells. */
final class NativeSize {
    /** A context, options: what has no arrays. */
    static final long SMALL = 2048;

    private NativeSize() {}

    /** One number of single precision a voxel and function; of a label map one or two bytes, and two for the weight. */
    static long ofVolume(long volume) {
        long functions = CleftNative.cleft_volume_indicator_count(volume);
        int ofLabel = CleftNative.cleft_volume_label_count(volume) > 256 ? 2 : 1;
        return SMALL + voxels(volume) * (functions > 0 ? 4 * functions : ofLabel + 2);
    }

    static long ofSizing(long sizing) {
        long[] dims = new long[3];
        CleftException.check(CleftNative.cleft_sizing_dims(sizing, dims));
        return SMALL + 4 * product(dims);
    }

    /** Three coordinates a point; four corners and a label a tetrahedron. */
    static long ofMesh(long mesh) {
        return SMALL + 24 * CleftNative.cleft_mesh_point_count(mesh) + 20 * CleftNative.cleft_mesh_tet_count(mesh);
    }

    /** Three corners and two labels a triangle; on the hull a label and a side. */
    static long ofSurface(long surface) {
        return SMALL + 20 * (CleftNative.cleft_surface_interface_count(surface)
                + CleftNative.cleft_surface_hull_count(surface));
    }

    private static long voxels(long volume) {
        long[] dims = new long[3];
        CleftException.check(CleftNative.cleft_volume_dims(volume, dims));
        return product(dims);
    }

    private static long product(long[] dims) {
        return dims[0] * dims[1] * dims[2];
    }
}
