package org.cleft;

import java.lang.reflect.Array;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Objects;

/**
 * Makes volumes and sizing fields from arrays that have an element a voxel, and tells what is wrong with such arrays.
 */
final class VoxelArrays {
    private VoxelArrays() {}

    /** A label map from a Java array, whose elements the type describes. */
    static Volume labels(Mesher mesher, VoxelType type, Object voxels, Grid grid, Options options) {
        checkLength("voxels", voxels, grid);
        return volume(mesher, type, voxels, grid, options);
    }

    /** A label map from a buffer. */
    static Volume labels(Mesher mesher, VoxelType type, ByteBuffer voxels, Grid grid, Options options) {
        Objects.requireNonNull(voxels, "voxels");
        Objects.requireNonNull(grid, "grid");
        if (!Objects.requireNonNull(type, "type").isWhole)
            throw new IllegalArgumentException("type is " + type + "; a label map has whole numbers");
        if (!voxels.isDirect() || voxels.order() != ByteOrder.nativeOrder())
            throw new IllegalArgumentException("voxels must be a direct buffer in the byte order of the machine");
        if (voxels.limit() != grid.voxels() * type.bytes)
            throw new IllegalArgumentException("voxels has " + voxels.limit() + " bytes; the grid has "
                    + grid.voxels() + " voxels of " + type.bytes);
        return volume(mesher, type, voxels, grid, options);
    }

    private static Volume volume(Mesher mesher, VoxelType type, Object voxels, Grid grid, Options options) {
        return new Volume(mesher.make((context, arguments, out) -> CleftNative.cleft_volume_create_labels(
                context, type.number, voxels, grid.dims(), grid.affine(), arguments[0], out), options));
    }

    /** Indicator functions: an array of Java arrays. */
    static Volume indicators(Mesher mesher, VoxelType type, Object[] fields, Grid grid, int[] labels) {
        if (Arguments.noNulls("fields", fields).length == 0)
            throw new IllegalArgumentException("fields has no elements; it must have one a material");
        for (int k = 0; k < fields.length; ++k)
            checkLength("fields[" + k + "]", fields[k], grid);
        if (labels != null)
            Arguments.length("labels", labels.length, fields.length == 1 ? 2 : fields.length);
        return new Volume(mesher.make((context, arguments, out) -> CleftNative.cleft_volume_create_indicators(
                context, type.number, fields, grid.dims(), grid.affine(), labels, out)));
    }

    /** A sizing field of the user's own. */
    static Sizing sizing(
            Mesher mesher, Volume volume, VoxelType type, Object values, boolean combine, Options options) {
        Objects.requireNonNull(volume, "volume");
        checkLength("values", values, volume.grid());
        return new Sizing(mesher.make((context, arguments, out) -> CleftNative.cleft_sizing_create_values(
                context, arguments[0], type.number, values, combine ? 1 : 0, arguments[1], out), volume, options));
    }

    /** A sizing field with one metric everywhere. */
    static Sizing constantMetricSizing(Mesher mesher, Volume volume, double[] tensor) {
        Objects.requireNonNull(volume, "volume");
        Arguments.length("tensor", Objects.requireNonNull(tensor, "tensor").length, 6);
        return new Sizing(mesher.make((context, arguments, out) ->
                CleftNative.cleft_sizing_create_constant_metric(context, arguments[0], tensor, out), volume));
    }

    /** A sizing field with a metric of the user's own, of 6 numbers a voxel. */
    static Sizing metricSizing(
            Mesher mesher, Volume volume, VoxelType type, Object tensors, boolean combine, Options options) {
        Objects.requireNonNull(volume, "volume");
        Objects.requireNonNull(tensors, "tensors");
        volume.grid().checkLength("tensors", Array.getLength(tensors), 6);
        return new Sizing(mesher.make((context, arguments, out) -> CleftNative.cleft_sizing_create_metric(
                context, arguments[0], type.number, tensors, combine ? 1 : 0, arguments[1], out), volume, options));
    }

    private static void checkLength(String name, Object array, Grid grid) {
        Objects.requireNonNull(array, name);
        Objects.requireNonNull(grid, "grid").checkLength(name, Array.getLength(array));
    }
}
