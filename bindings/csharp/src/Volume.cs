using System;
using System.Collections.Generic;

namespace Cleft
{
    /// <summary>
    /// A labelled volume, or indicator functions; made by a Mesher or read by MeshFiles. It never changes, but for the
    /// names of its labels, and may be used by many threads.
    /// </summary>
    public sealed class Volume : NativeObject
    {
        internal Volume(IntPtr address)
            : base(new NativeHandle(address, CleftNative.cleft_volume_destroy, NativeSize.OfVolume)) { }

        /// <summary>Voxels, and where they lie.</summary>
        public Grid Grid
        {
            get {
                long[] dims = new long[3];
                double[] affine = new double[12];
                CleftException.Check(CleftNative.cleft_volume_dims(Handle, dims));
                CleftException.Check(CleftNative.cleft_volume_affine(Handle, affine));
                return new Grid(dims[0], dims[1], dims[2]).WithAffine(affine);
            }
        }

        /// <summary>The label of each material; a view.</summary>
        public ArrayView<int> Labels =>
            new IntView(Handle, CleftNative.cleft_volume_labels, CleftNative.cleft_volume_label_count);

        /// <summary>
        /// How many indicator functions: 1 for a signed function, 0 for a label map. Tells what a file was taken for.
        /// </summary>
        public long IndicatorCount => CleftNative.cleft_volume_indicator_count(Handle);

        /// <summary>The names of the labels that have one, as a file gave them or SetLabelName() did.</summary>
        public IReadOnlyDictionary<int, string> LabelNames => Cleft.LabelNames.Of(Labels, LabelName);

        /// <summary>The name of a label, "" if it has none.</summary>
        public string LabelName(int label) { return CleftNative.cleft_volume_label_name(Handle, label); }

        /// <summary>
        /// Names a label of the volume, in one line of text; "" takes the name away. Meshes that are made of the volume
        /// after that have the name too. Not while another thread uses the volume.
        /// </summary>
        public Volume SetLabelName(int label, string name)
        {
            Cleft.LabelNames.Check("the volume", Labels, label, name);
            CleftException.Check(CleftNative.cleft_volume_set_label_name(Handle, label, name));
            return this;
        }

        /// <summary>How many voxels each label has.</summary>
        public IReadOnlyDictionary<int, long> VoxelCounts
        {
            get {
                int[] labels = Labels.ToArray();
                long[] counts = new long[labels.Length];
                CleftException.Check(CleftNative.cleft_volume_copy_voxel_counts(Handle, counts, counts.Length));
                var map = new Dictionary<int, long>();
                for (int i = 0; i < labels.Length; ++i)
                    map[labels[i]] = counts[i];
                return map;
            }
        }

        /// <summary>The labels at points of the world (x y z of each), as the mesh sees them.</summary>
        public int[] Sample(params double[] points)
        {
            Arguments.Groups(points, 3, "point", nameof(points));
            for (int i = 0; i < points.Length; ++i)
                Arguments.FinitePoint(points[i], nameof(points) + "[" + i + "]");
            int[] labels = new int[points.Length / 3];
            CleftException.Check(CleftNative.cleft_volume_sample(Handle, points, labels.Length, labels));
            return labels;
        }

        internal override string Description => " of " + Grid.Size + " voxels, " + Labels.Count + " labels";
    }

    /// <summary>
    /// The wanted edge length at each point; made by a Mesher or read by MeshFiles. It never changes.
    /// </summary>
    public sealed class Sizing : NativeObject
    {
        internal Sizing(IntPtr address)
            : base(new NativeHandle(address, CleftNative.cleft_sizing_destroy, NativeSize.OfSizing)) { }

        /// <summary>Values, and where they lie.</summary>
        public Grid Grid
        {
            get {
                long[] dims = new long[3];
                double[] affine = new double[12];
                CleftException.Check(CleftNative.cleft_sizing_dims(Handle, dims));
                CleftException.Check(CleftNative.cleft_sizing_affine(Handle, affine));
                return new Grid(dims[0], dims[1], dims[2]).WithAffine(affine);
            }
        }

        /// <summary>
        /// The values, x fastest; a view. Of a field with a metric, these are the lengths of regular tetrahedra that
        /// are as large.
        /// </summary>
        public ArrayView<float> Values
        {
            get {
                long count = Grid.Voxels;
                return new FloatView(Handle, CleftNative.cleft_sizing_values, handle => count);
            }
        }

        /// <summary>Whether the wanted lengths depend on the direction.</summary>
        public bool HasMetric => CleftNative.cleft_sizing_has_metric(Handle) != 0;

        /// <summary>
        /// The metric: xx, xy, xz, yy, yz, zz of each voxel, x fastest. A field without one throws an
        /// InvalidArgumentException.
        /// </summary>
        public float[] CopyMetric()
        {
            float[] tensors = new float[HasMetric ? 6 * Grid.Voxels : 0];
            CleftException.Check(CleftNative.cleft_sizing_copy_metric(Handle, tensors, tensors.LongLength));
            return tensors;
        }

        /// <summary>Tetrahedra that a background of this field will have, within some 10 %.</summary>
        public double ExpectedTets => CleftNative.cleft_sizing_expected_tets(Handle);

        /// <summary>The field at a point of the world.</summary>
        public double At(double x, double y, double z)
        {
            Arguments.FinitePoint(x, nameof(x));
            Arguments.FinitePoint(y, nameof(y));
            Arguments.FinitePoint(z, nameof(z));
            double[] size = new double[1];
            CleftException.Check(CleftNative.cleft_sizing_at(Handle, new[] { x, y, z }, size));
            return size[0];
        }

        internal override string Description => FormattableString.Invariant($" of about {ExpectedTets:0} tetrahedra");
    }
}
