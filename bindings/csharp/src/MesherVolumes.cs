using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Cleft
{
    // Volumes and sizing fields, from arrays.
    public sealed partial class Mesher
    {
        // ---------------------------------------------------------------------------------------------- volumes

        /// <summary>A label map, x fastest; copied. Of the options, the smoothing is read.</summary>
        public Volume Labels(byte[] voxels, Grid grid, Options options = null)
        {
            return Labels(voxels, VoxelType.UInt8, grid, options);
        }

        /// <summary>A label map, x fastest; copied. Of the options, the smoothing is read.</summary>
        public Volume Labels(short[] voxels, Grid grid, Options options = null)
        {
            return Labels(voxels, VoxelType.Int16, grid, options);
        }

        /// <summary>A label map, x fastest; copied. Of the options, the smoothing is read.</summary>
        public Volume Labels(ushort[] voxels, Grid grid, Options options = null)
        {
            return Labels(voxels, VoxelType.UInt16, grid, options);
        }

        /// <summary>A label map, x fastest; copied. Of the options, the smoothing is read.</summary>
        public Volume Labels(int[] voxels, Grid grid, Options options = null)
        {
            return Labels(voxels, VoxelType.Int32, grid, options);
        }

        /// <summary>A label map, x fastest; copied. Of the options, the smoothing is read.</summary>
        public Volume Labels(uint[] voxels, Grid grid, Options options = null)
        {
            return Labels(voxels, VoxelType.UInt32, grid, options);
        }

        /// <summary>
        /// A label map in memory of yours, x fastest, as many voxels as the grid has; copied. For volumes outside the
        /// heap.
        /// </summary>
        public Volume Labels(IntPtr voxels, VoxelType type, Grid grid, Options options = null)
        {
            Arguments.NotNull(grid, nameof(grid));
            CheckWhole(type);
            if (voxels == IntPtr.Zero)
                throw new ArgumentNullException(nameof(voxels));
            NativeHandle how = HandleOf(options);
            return new Volume(Make((NativeHandle context, out IntPtr made) => CleftNative.cleft_volume_create_labels(
                context, (int)type, voxels, grid.Dims, grid.Affine, how, out made)));
        }

        private Volume Labels(Array voxels, VoxelType type, Grid grid, Options options)
        {
            Arguments.NotNull(voxels, nameof(voxels));
            Arguments.NotNull(grid, nameof(grid));
            grid.CheckLength(voxels, nameof(voxels));
            return Pinned(new[] { voxels }, addresses => Labels(addresses[0], type, grid, options));
        }

        private static void CheckWhole(VoxelType type)
        {
            Arguments.Defined(type, nameof(type));
            if (type == VoxelType.Float32 || type == VoxelType.Float64)
                throw new ArgumentOutOfRangeException(nameof(type), type, "a label map has whole numbers");
        }

        /// <summary>
        /// Indicator functions, one for each material, x fastest; copied: the greatest wins. One alone is a signed
        /// function, inside where it is above 0. Labels: what the materials are called, two for one function, the
        /// outside first; or null for 0, 1, 2, ...
        /// </summary>
        public Volume Indicators(double[][] fields, Grid grid, int[] labels = null)
        {
            return Indicators(fields, VoxelType.Float64, grid, labels);
        }

        /// <summary>Indicator functions of single precision; else as those of double precision.</summary>
        public Volume Indicators(float[][] fields, Grid grid, int[] labels = null)
        {
            return Indicators(fields, VoxelType.Float32, grid, labels);
        }

        private Volume Indicators(Array[] fields, VoxelType type, Grid grid, int[] labels)
        {
            Arguments.NotNull(fields, nameof(fields));
            Arguments.NotNull(grid, nameof(grid));
            if (fields.Length == 0)
                throw new ArgumentException("fields has no elements; it must have one a material", nameof(fields));
            for (int k = 0; k < fields.Length; ++k)
                grid.CheckLength(fields[k], nameof(fields), "[" + k + "]");
            if (labels != null)
                Arguments.Length(labels, fields.Length == 1 ? 2 : fields.Length, nameof(labels));
            return Pinned(fields, addresses => new Volume(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_volume_create_indicators(context, (int)type, addresses, addresses.Length, grid.Dims,
                    grid.Affine, labels, out made))));
        }

        // ----------------------------------------------------------------------------------------------- sizing

        /// <summary>The sizing field of a volume, from its features and the options of sizes.</summary>
        public Sizing Sizing(Volume volume, Options options = null)
        {
            NativeHandle of = Required(volume, nameof(volume)), how = HandleOf(options);
            return new Sizing(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_sizing_create(context, of, how, out made)));
        }

        /// <summary>One size everywhere, in world units.</summary>
        public Sizing ConstantSizing(Volume volume, double size)
        {
            NativeHandle of = Required(volume, nameof(volume));
            return new Sizing(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_sizing_create_constant(context, of, size, out made)));
        }

        /// <summary>
        /// A sizing field of your own, one edge length above 0 a voxel, x fastest; copied. With combine, the lesser of
        /// it and of the computed field, for which the options are read.
        /// </summary>
        public Sizing Sizing(Volume volume, double[] values, bool combine = false, Options options = null)
        {
            return Sizing(volume, values, VoxelType.Float64, combine, options);
        }

        /// <summary>A sizing field of your own in single precision; else as that of double precision.</summary>
        public Sizing Sizing(Volume volume, float[] values, bool combine = false, Options options = null)
        {
            return Sizing(volume, values, VoxelType.Float32, combine, options);
        }

        private Sizing Sizing(Volume volume, Array values, VoxelType type, bool combine, Options options)
        {
            NativeHandle of = Required(volume, nameof(volume)), how = HandleOf(options);
            volume.Grid.CheckLength(values, nameof(values));
            return Pinned(new[] { values }, addresses => new Sizing(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_sizing_create_values(
                    context, of, (int)type, addresses[0], combine ? 1 : 0, how, out made))));
        }

        /// <summary>
        /// One metric everywhere: xx, xy, xz, yy, yz, zz of a symmetric M. An edge v is to have v^T M v = 1, in world
        /// units.
        /// </summary>
        public Sizing ConstantMetricSizing(Volume volume, double[] tensor)
        {
            NativeHandle of = Required(volume, nameof(volume));
            Arguments.Length(tensor, 6, nameof(tensor));
            return new Sizing(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_sizing_create_constant_metric(context, of, tensor, out made)));
        }

        /// <summary>
        /// A sizing field with a metric, wanted lengths that depend on the direction: xx, xy, xz, yy, yz, zz of a
        /// symmetric M for each voxel, x fastest; copied. An edge v is to have v^T M v = 1, in world units. With
        /// combine, no length is greater than that of the computed field, for which the options are read.
        /// </summary>
        public Sizing MetricSizing(Volume volume, double[] tensors, bool combine = false, Options options = null)
        {
            return MetricSizing(volume, tensors, VoxelType.Float64, combine, options);
        }

        /// <summary>A sizing field with a metric in single precision; else as that of double precision.</summary>
        public Sizing MetricSizing(Volume volume, float[] tensors, bool combine = false, Options options = null)
        {
            return MetricSizing(volume, tensors, VoxelType.Float32, combine, options);
        }

        private Sizing MetricSizing(Volume volume, Array tensors, VoxelType type, bool combine, Options options)
        {
            NativeHandle of = Required(volume, nameof(volume)), how = HandleOf(options);
            volume.Grid.CheckLength(tensors, 6, nameof(tensors));
            return Pinned(new[] { tensors }, addresses => new Sizing(Make((NativeHandle context, out IntPtr made) =>
                CleftNative.cleft_sizing_create_metric(
                    context, of, (int)type, addresses[0], combine ? 1 : 0, how, out made))));
        }

        /// <summary>Runs something with the addresses of arrays that the collector leaves where they are.</summary>
        private static T Pinned<T>(Array[] arrays, Func<IntPtr[], T> use)
        {
            var pins = new List<GCHandle>();
            try {
                foreach (Array array in arrays)
                    pins.Add(GCHandle.Alloc(array, GCHandleType.Pinned));
                return use(pins.ConvertAll(pin => pin.AddrOfPinnedObject()).ToArray());
            } finally {
                pins.ForEach(pin => pin.Free());
            }
        }
    }
}
