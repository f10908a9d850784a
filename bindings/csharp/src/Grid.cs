using System;

namespace Cleft
{
    /// <summary>
    /// How many voxels there are, and where they lie: new Grid(64, 64, 40).WithSpacing(0.5, 0.5, 2).WithOrigin(0, 0,
    /// 0). It never changes. Voxel (i, j, k) is number i + nx * (j + ny * k) of an array: x runs fastest.
    /// </summary>
    public sealed class Grid
    {
        private readonly long[] dims;
        private readonly double[] spacing; // null: 1
        private readonly double[] origin;
        private readonly double[] affine;

        /// <summary>A grid of cubes of side 1; the corner of its box is at zero.</summary>
        public Grid(long nx, long ny, long nz) : this(new[] { nx, ny, nz }, null, null, null)
        {
            Arguments.AtLeastOne(nx, nameof(nx));
            Arguments.AtLeastOne(ny, nameof(ny));
            Arguments.AtLeastOne(nz, nameof(nz));
            if (nx > long.MaxValue / ny)
                throw new ArgumentOutOfRangeException(nameof(ny), ny, "nx times ny is too many voxels");
            if (nx * ny > long.MaxValue / nz)
                throw new ArgumentOutOfRangeException(nameof(nz), nz, "nx times ny times nz is too many voxels");
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
            Arguments.Positive(x, nameof(x));
            Arguments.Positive(y, nameof(y));
            Arguments.Positive(z, nameof(z));
            CheckNoAffine();
            return new Grid(dims, new[] { x, y, z }, origin, null);
        }

        /// <summary>
        /// The grid with the centre of voxel (0, 0, 0) at this place. Without one, the corner of the box is at zero.
        /// </summary>
        public Grid WithOrigin(double x, double y, double z)
        {
            Arguments.Finite(x, nameof(x));
            Arguments.Finite(y, nameof(y));
            Arguments.Finite(z, nameof(z));
            CheckNoAffine();
            return new Grid(dims, spacing, new[] { x, y, z }, null);
        }

        /// <summary>
        /// The grid with this matrix from voxel indices to the world, 3 rows of 4 numbers. A grid has either a matrix
        /// or spacing and origin: one beside the other is an InvalidOperationException.
        /// </summary>
        public Grid WithAffine(params double[] rows)
        {
            Arguments.Length(rows, 12, nameof(rows));
            foreach (double number in rows)
                Arguments.Finite(number, nameof(rows));
            if (spacing != null || origin != null)
                throw new InvalidOperationException(
                    "an affine is given beside spacing or origin: a grid has one or the other");
            return new Grid(dims, null, null, (double[])rows.Clone());
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
                    rows[5 * axis] = spacing == null ? 1 : spacing[axis];
                    rows[4 * axis + 3] = origin == null ? rows[5 * axis] / 2 : origin[axis];
                }
                return rows;
            }
        }

        /// <summary>What this is, in a few words.</summary>
        public override string ToString() { return "Grid of " + Size + " voxels"; }

        internal string Size => string.Join(" x ", dims);

        private void CheckNoAffine()
        {
            if (affine != null)
                throw new InvalidOperationException(
                    "spacing or origin is given beside an affine: a grid has one or the other");
        }

        /// <summary>
        /// Throws unless an argument of this name has an element a voxel; <paramref name="part"/>: which of it.
        /// </summary>
        internal void CheckLength(Array array, string name, string part = "")
        {
            if (array == null)
                throw new ArgumentNullException(name, name + part + " is null");
            if (array.LongLength != Voxels)
                throw new ArgumentException(
                    name + part + " has " + array.LongLength + " elements; the grid has " + Voxels + " voxels", name);
        }

        /// <summary>An array with several elements a voxel.</summary>
        internal void CheckLength(Array array, int each, string name)
        {
            if (Arguments.NotNull(array, name).LongLength != each * Voxels)
                throw new ArgumentException(name + " has " + array.LongLength + " elements; the grid has " + Voxels +
                    " voxels, with " + each + " elements each", name);
        }
    }
}
