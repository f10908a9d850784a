using System;

namespace Cleft
{
    /// <summary>
    /// How many voxels there are, and where they lie: new Grid(64, 64, 40).WithSpacing(0.5, 0.5, 2).WithOrigin(0, 0, 0). It
    /// never changes. Voxel (i, j, k) is number i + nx * (j + ny * k) of an array: x runs fastest.
    /// </summary>
    public sealed class Grid
    {
        private readonly long[] dims;
        private readonly double[] spacing;
        private readonly double[] origin;
        private readonly double[] affine;

        /// <summary>A grid of cubes of side 1; the corner of its box is at zero.</summary>
        public Grid(long nx, long ny, long nz) : this(new[] { nx, ny, nz }, new double[] { 1, 1, 1 }, null, null)
        {
            if (nx < 1 || ny < 1 || nz < 1)
                throw new ArgumentOutOfRangeException(nameof(nx), "a grid has at least one voxel along each axis");
            if (nx > long.MaxValue / ny || nx * ny > long.MaxValue / nz)
                throw new ArgumentOutOfRangeException(nameof(nx), "too many voxels");
        }

        private Grid(long[] dims, double[] spacing, double[] origin, double[] affine)
        {
            this.dims = dims;
            this.spacing = spacing;
            this.origin = origin;
            this.affine = affine;
        }

        /// <summary>The grid with these sides of a voxel, all above 0.</summary>
        public Grid WithSpacing(double x, double y, double z)
        {
            if (!(x > 0 && y > 0 && z > 0) || double.IsInfinity(x + y + z))
                throw new ArgumentOutOfRangeException(nameof(x), "spacing must be above 0 and finite");
            return new Grid(dims, new[] { x, y, z }, origin, null);
        }

        /// <summary>
        /// The grid with the centre of voxel (0, 0, 0) at this place. Without one, the corner of the box is at zero.
        /// </summary>
        public Grid WithOrigin(double x, double y, double z)
        {
            double sum = x + y + z;
            if (double.IsNaN(sum) || double.IsInfinity(sum))
                throw new ArgumentOutOfRangeException(nameof(x), "origin must be finite");
            return new Grid(dims, spacing, new[] { x, y, z }, null);
        }

        /// <summary>
        /// The grid with this matrix from voxel indices to the world, 3 rows of 4 numbers, instead of spacing and origin.
        /// </summary>
        public Grid WithAffine(params double[] rows)
        {
            if (rows == null)
                throw new ArgumentNullException(nameof(rows));
            if (rows.Length != 12)
                throw new ArgumentException("affine has 12 numbers, not " + rows.Length, nameof(rows));
            return new Grid(dims, spacing, origin, (double[])rows.Clone());
        }

        /// <summary>The numbers of voxels along x, y and z.</summary>
        public long[] Dims => (long[])dims.Clone();

        /// <summary>How many voxels there are.</summary>
        public long Voxels => dims[0] * dims[1] * dims[2];

        /// <summary>The matrix from voxel indices to the world: 3 rows of 4 numbers.</summary>
        public double[] Affine
        {
            get {
                if (affine != null)
                    return (double[])affine.Clone();
                double[] rows = new double[12];
                for (int axis = 0; axis < 3; ++axis) {
                    rows[5 * axis] = spacing[axis];
                    rows[4 * axis + 3] = origin == null ? spacing[axis] / 2 : origin[axis];
                }
                return rows;
            }
        }

        /// <summary>What this is, in a few words.</summary>
        public override string ToString() { return "Grid of " + Size + " voxels"; }

        internal string Size => string.Join(" x ", dims);

        internal void CheckLength(Array array, string name)
        {
            if (array == null)
                throw new ArgumentNullException(name);
            if (array.LongLength != Voxels)
                throw new ArgumentException(
                    "there are " + array.LongLength + " elements; the grid has " + Voxels + " voxels", name);
        }
    }
}
