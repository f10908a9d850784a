package org.cleft;

import java.nio.IntBuffer;
import java.util.function.LongFunction;

/** The triangles of a mesh: those between labels, and those of the hull. They number the points of the mesh. */
public final class Surface extends NativeObject {
    Surface(long address) {
        super("Surface", address, NativeSize.ofSurface(address), CleftNative::cleft_surface_destroy);
    }

    /**
     * Triangles between labels, 3 points each; normals point from the first label of the pair to the second.
     *
     * @return a copy, sorted by pair
     */
    public int[] interfaceTriangles() {
        return copy(CleftNative::cleft_surface_interface_triangles, CleftNative::cleft_surface_interface_count, 3);
    }

    /**
     * The two labels of each triangle between labels, the lower first.
     *
     * @return a copy
     */
    public int[] interfaceLabels() {
        return copy(CleftNative::cleft_surface_interface_labels, CleftNative::cleft_surface_interface_count, 2);
    }

    /**
     * Triangles of the hull, 3 points each, normals outward.
     *
     * @return a copy, sorted by side, then by label
     */
    public int[] hullTriangles() {
        return copy(CleftNative::cleft_surface_hull_triangles, CleftNative::cleft_surface_hull_count, 3);
    }

    /**
     * The label inside each triangle of the hull.
     *
     * @return a copy
     */
    public int[] hullLabels() {
        return copy(CleftNative::cleft_surface_hull_labels, CleftNative::cleft_surface_hull_count, 1);
    }

    /**
     * The side of each triangle of the hull, as the ordinal of a {@link Side}.
     *
     * @return a copy
     */
    public int[] hullSides() {
        return copy(CleftNative::cleft_surface_hull_sides, CleftNative::cleft_surface_hull_count, 1);
    }

    @Override
    String description() {
        return " of " + with(CleftNative::cleft_surface_interface_count) + " triangles between labels, "
                + with(CleftNative::cleft_surface_hull_count) + " of the hull";
    }

    private int[] copy(LongFunction<Long> start, LongFunction<Long> count, int width) {
        IntBuffer view = view(start, address -> 4L * width * count.apply(address)).asIntBuffer();
        int[] values = new int[view.remaining()];
        view.get(values);
        return values;
    }
}
