using System;
using System.Collections.Generic;

namespace Cleft
{
    /// <summary>
    /// Points, tetrahedra and their labels; a background mesh has the label 0 only. Made by a Mesher or read by
    /// MeshFiles; it never changes, but for the names of its labels, and may be used by many threads. Arrays come as
    /// views, without a copy, or as copies of your own.
    /// </summary>
    public sealed class Mesh : NativeObject
    {
        internal Mesh(IntPtr address)
            : base(new NativeHandle(address, CleftNative.cleft_mesh_destroy, NativeSize.OfMesh)) { }

        /// <summary>How many points there are.</summary>
        public long PointCount => CleftNative.cleft_mesh_point_count(Handle);

        /// <summary>How many tetrahedra there are.</summary>
        public long TetCount => CleftNative.cleft_mesh_tet_count(Handle);

        /// <summary>World coordinates, x y z of each point; a view.</summary>
        public ArrayView<double> Points => new DoubleView(
            Handle, CleftNative.cleft_mesh_points, handle => 3 * CleftNative.cleft_mesh_point_count(handle));

        /// <summary>The corners of each tetrahedron, 4 numbers of points from 0, positively oriented; a view.</summary>
        public ArrayView<int> Tets => new IntView(
            Handle, CleftNative.cleft_mesh_tets, handle => 4 * CleftNative.cleft_mesh_tet_count(handle));

        /// <summary>The label of each tetrahedron; a view.</summary>
        public ArrayView<int> TetLabels =>
            new IntView(Handle, CleftNative.cleft_mesh_tet_labels, CleftNative.cleft_mesh_tet_count);

        /// <summary>The labels that occur, ascending; a view.</summary>
        public ArrayView<int> Labels =>
            new IntView(Handle, CleftNative.cleft_mesh_labels, CleftNative.cleft_mesh_label_count);

        /// <summary>
        /// The names of the labels that have one. A mesh begins with the names of its volume; formats that have names
        /// for groups write them.
        /// </summary>
        public IReadOnlyDictionary<int, string> LabelNames => Cleft.LabelNames.Of(Labels, LabelName);

        /// <summary>The name of a label, "" if it has none.</summary>
        public string LabelName(int label) { return CleftNative.cleft_mesh_label_name(Handle, label); }

        /// <summary>
        /// Names a label of the mesh, in one line of text; "" takes the name away. Not while another thread uses the
        /// mesh.
        /// </summary>
        public Mesh SetLabelName(int label, string name)
        {
            Cleft.LabelNames.Check("the mesh", Labels, label, name);
            CleftException.Check(CleftNative.cleft_mesh_set_label_name(Handle, label, name));
            return this;
        }

        /// <summary>A copy of the points.</summary>
        public double[] CopyPoints()
        {
            double[] points = new double[3 * PointCount];
            CleftException.Check(CleftNative.cleft_mesh_copy_points(Handle, points, points.LongLength));
            return points;
        }

        /// <summary>A copy of the corners, counted from <paramref name="indexBase"/>, 0 or 1.</summary>
        public int[] CopyTets(int indexBase = 0)
        {
            int[] tets = new int[4 * TetCount];
            Arguments.IndexBase(indexBase, nameof(indexBase));
            CleftException.Check(CleftNative.cleft_mesh_copy_tets(Handle, indexBase, tets, tets.LongLength));
            return tets;
        }

        /// <summary>A copy of the labels of the tetrahedra.</summary>
        public int[] CopyTetLabels()
        {
            int[] labels = new int[TetCount];
            CleftException.Check(CleftNative.cleft_mesh_copy_tet_labels(Handle, labels, labels.LongLength));
            return labels;
        }

        /// <summary>
        /// Tetrahedra of ten nodes: 4 corners, then the middles of the edges 01, 12, 02, 03, 13, 23. Answers the
        /// points, those of the mesh first.
        /// </summary>
        public double[] CopyQuadratic(out int[] tets, int indexBase = 0)
        {
            Arguments.IndexBase(indexBase, nameof(indexBase));
            long[] count = new long[1];
            CleftException.Check(CleftNative.cleft_mesh_copy_quadratic(Handle, indexBase, null, 0, null, 0, count));
            double[] points = new double[3 * count[0]];
            tets = new int[10 * TetCount];
            CleftException.Check(CleftNative.cleft_mesh_copy_quadratic(
                Handle, indexBase, points, points.LongLength, tets, tets.LongLength, count));
            return points;
        }

        internal override string Description =>
            " of " + PointCount + " points, " + TetCount + " tetrahedra, " + Labels.Count + " labels";
    }

    /// <summary>
    /// The triangles of a mesh: those between labels, and those of the hull. They number the points of the mesh. All
    /// arrays are views.
    /// </summary>
    public sealed class Surface : NativeObject
    {
        internal Surface(IntPtr address)
            : base(new NativeHandle(address, CleftNative.cleft_surface_destroy, NativeSize.OfSurface)) { }

        /// <summary>
        /// Triangles between labels, 3 points each; normals point from the first label to the second.
        /// </summary>
        public ArrayView<int> InterfaceTriangles => new IntView(Handle, CleftNative.cleft_surface_interface_triangles,
            handle => 3 * CleftNative.cleft_surface_interface_count(handle));

        /// <summary>The two labels of each triangle between labels, the lower first.</summary>
        public ArrayView<int> InterfaceLabels => new IntView(Handle, CleftNative.cleft_surface_interface_labels,
            handle => 2 * CleftNative.cleft_surface_interface_count(handle));

        /// <summary>Triangles of the hull, 3 points each, normals outward, sorted by side, then by label.</summary>
        public ArrayView<int> HullTriangles => new IntView(Handle, CleftNative.cleft_surface_hull_triangles,
            handle => 3 * CleftNative.cleft_surface_hull_count(handle));

        /// <summary>The label inside each triangle of the hull.</summary>
        public ArrayView<int> HullLabels =>
            new IntView(Handle, CleftNative.cleft_surface_hull_labels, CleftNative.cleft_surface_hull_count);

        /// <summary>The side of each triangle of the hull, as the number of a <see cref="Side"/>.</summary>
        public ArrayView<int> HullSides =>
            new IntView(Handle, CleftNative.cleft_surface_hull_sides, CleftNative.cleft_surface_hull_count);

        internal override string Description => " of " + CleftNative.cleft_surface_interface_count(Handle)
            + " triangles between labels, " + CleftNative.cleft_surface_hull_count(Handle) + " of the hull";
    }
}
