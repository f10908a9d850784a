package org.cleft;

import java.util.Arrays;
import java.util.Objects;

/**
 * How many voxels there are, and where they lie: {@code new Grid(64, 64, 40).spacing(0.5, 0.5, 2).origin(0, 0, 0)}. It
 * never changes: the methods that set something answer a new one. Voxel (i, j, k) is number {@code i + nx * (j + ny *
 * k)} of an array: x runs fastest.
 */
public final class Grid {
    private final long[] dims;
    private final double[] spacing; // null: 1
    private final double[] origin;
    private final double[] affine;

    /**
     * A grid of cubes of side 1; the corner of its box is at zero.
     *
     * @param nx voxels along x
     * @param ny voxels along y
     * @param nz voxels along z
     */
    public Grid(long nx, long ny, long nz) {
        this(new long[] {nx, ny, nz}, null, null, null);
        Arguments.atLeastOne("nx", nx);
        Arguments.atLeastOne("ny", ny);
        Arguments.atLeastOne("nz", nz);
        voxels();
    }

    private Grid(long[] dims, double[] spacing, double[] origin, double[] affine) {
        this.dims = dims;
        this.spacing = spacing;
        this.origin = origin;
        this.affine = affine;
    }

    /**
     * The grid with these sides of a voxel.
     *
     * @param x along x, above 0
     * @param y along y, above 0
     * @param z along z, above 0
     * @return a new grid
     */
    public Grid spacing(double x, double y, double z) {
        Arguments.positive("x", x);
        Arguments.positive("y", y);
        Arguments.positive("z", z);
        checkNoAffine();
        return new Grid(dims, new double[] {x, y, z}, origin, null);
    }

    /**
     * The grid with the centre of voxel (0, 0, 0) at this place. Without one, the corner of the box is at zero.
     *
     * @param x of the centre
     * @param y of the centre
     * @param z of the centre
     * @return a new grid
     */
    public Grid origin(double x, double y, double z) {
        Arguments.finite("x", x);
        Arguments.finite("y", y);
        Arguments.finite("z", z);
        checkNoAffine();
        return new Grid(dims, spacing, new double[] {x, y, z}, null);
    }

    /**
     * The grid with this matrix from voxel indices to the world. A grid has either a matrix or spacing and origin:
     * one beside the other is an IllegalStateException.
     *
     * @param rows 3 rows of 4 numbers; voxel centres are at whole indices
     * @return a new grid
     */
    public Grid affine(double... rows) {
        Arguments.length("rows", Objects.requireNonNull(rows, "rows").length, 12);
        Arguments.finite("rows", rows);
        if (spacing != null || origin != null)
            throw new IllegalStateException("affine is given beside spacing or origin: a grid has one or the other");
        return new Grid(dims, null, null, rows.clone());
    }

    /**
     * The numbers of voxels along x, y and z.
     *
     * @return three numbers
     */
    public long[] dims() {
        return dims.clone();
    }

    /**
     * The matrix from voxel indices to the world.
     *
     * @return 3 rows of 4 numbers
     */
    public double[] affine() {
        if (affine != null)
            return affine.clone();
        double[] rows = new double[12];
        for (int axis = 0; axis < 3; ++axis) {
            rows[5 * axis] = spacing == null ? 1 : spacing[axis];
            rows[4 * axis + 3] = origin == null ? rows[5 * axis] / 2 : origin[axis];
        }
        return rows;
    }

    /**
     * How many voxels there are.
     *
     * @return their number
     */
    public long voxels() {
        return Arguments.product("nx, ny, nz", dims);
    }

    private void checkNoAffine() {
        if (affine != null)
            throw new IllegalStateException("spacing or origin is given beside affine: a grid has one or the other");
    }

    /** Throws unless an argument of this name has an element a voxel. */
    void checkLength(String name, long length) {
        if (length != voxels())
            throw new IllegalArgumentException(
                    name + " has " + length + " elements; the grid has " + voxels() + " voxels");
    }

    /** An array with several elements a voxel. */
    void checkLength(String name, long length, int each) {
        if (length % each != 0 || length / each != voxels())
            throw new IllegalArgumentException(name + " has " + length + " elements; the grid has " + voxels()
                    + " voxels, with " + each + " elements each");
    }

    @Override
    public String toString() {
        return "Grid of " + size() + " voxels";
    }

    String size() {
        return dims[0] + " x " + dims[1] + " x " + dims[2];
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof Grid grid && Arrays.equals(dims, grid.dims) && Arrays.equals(affine(), grid.affine());
    }

    @Override
    public int hashCode() {
        return Objects.hash(Arrays.hashCode(dims), Arrays.hashCode(affine()));
    }
}
