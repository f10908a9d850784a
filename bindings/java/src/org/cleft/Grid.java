package org.cleft;

import java.util.Arrays;
import java.util.Objects;

/**
 * How many voxels there are, and where they lie: {@code new Grid(64, 64, 40).spacing(0.5, 0.5, 2).origin(0, 0, 0)}. It
 * never changes: the methods that set something answer a new one. Voxel (i, j, k) is number {@code i + nx * (j + ny * k)}
 * of an array: x runs fastest.
 */
public final class Grid {
    private final long[] dims;
    private final double[] spacing;
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
        this(new long[] {nx, ny, nz}, new double[] {1, 1, 1}, null, null);
        for (long n : dims)
            if (n < 1)
                throw new IllegalArgumentException("a grid has at least one voxel along each axis, not " + n);
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
        if (!(x > 0 && y > 0 && z > 0) || Double.isInfinite(x + y + z))
            throw new IllegalArgumentException("spacing must be above 0 and finite: " + x + " " + y + " " + z);
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
        if (!Double.isFinite(x + y + z))
            throw new IllegalArgumentException("origin must be finite: " + x + " " + y + " " + z);
        return new Grid(dims, spacing, new double[] {x, y, z}, null);
    }

    /**
     * The grid with this matrix from voxel indices to the world, instead of spacing and origin.
     *
     * @param rows 3 rows of 4 numbers; voxel centres are at whole indices
     * @return a new grid
     */
    public Grid affine(double... rows) {
        if (rows.length != 12)
            throw new IllegalArgumentException("affine has 12 numbers, not " + rows.length);
        return new Grid(dims, spacing, origin, rows.clone());
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
            rows[5 * axis] = spacing[axis];
            rows[4 * axis + 3] = origin == null ? spacing[axis] / 2 : origin[axis];
        }
        return rows;
    }

    /**
     * How many voxels there are.
     *
     * @return their number
     */
    public long voxels() {
        try {
            return Math.multiplyExact(Math.multiplyExact(dims[0], dims[1]), dims[2]);
        } catch (ArithmeticException overflow) {
            throw new IllegalArgumentException("too many voxels: " + Arrays.toString(dims));
        }
    }

    void checkLength(String name, long length) {
        if (length != voxels())
            throw new IllegalArgumentException(
                    name + " has " + length + " elements; the grid has " + voxels() + " voxels");
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
