using System;
using System.Collections.Generic;

namespace Cleft
{
    /// <summary>Kinds of background meshes.</summary>
    public enum Background
    {
        /// <summary>Relaxed particles and their Delaunay tetrahedra: the best shapes.</summary>
        Particles = CleftNative.CLEFT_BACKGROUND_PARTICLES,
        /// <summary>A regular lattice: quick, one size everywhere.</summary>
        Lattice = CleftNative.CLEFT_BACKGROUND_LATTICE,
        /// <summary>An adaptive lattice.</summary>
        Octree = CleftNative.CLEFT_BACKGROUND_OCTREE
    }

    /// <summary>Rules that move background points onto interfaces.</summary>
    public enum Snap
    {
        /// <summary>By the quality of the elements around.</summary>
        Quality = CleftNative.CLEFT_SNAP_QUALITY,
        /// <summary>By the paper's safe distances.</summary>
        Safe = CleftNative.CLEFT_SNAP_SAFE,
        /// <summary>Never.</summary>
        None = CleftNative.CLEFT_SNAP_NONE
    }

    /// <summary>Effort spent on the worst dihedral angles.</summary>
    public enum Improvement
    {
        /// <summary>None.</summary>
        Off = CleftNative.CLEFT_IMPROVE_OFF,
        /// <summary>Some: the default.</summary>
        Fast = CleftNative.CLEFT_IMPROVE_FAST,
        /// <summary>As much as helps.</summary>
        Best = CleftNative.CLEFT_IMPROVE_BEST
    }

    /// <summary>Types of voxels.</summary>
    public enum VoxelType
    {
        /// <summary>Whole numbers of 8 bits without sign.</summary>
        UInt8 = CleftNative.CLEFT_TYPE_UINT8,
        /// <summary>Whole numbers of 16 bits without sign.</summary>
        UInt16 = CleftNative.CLEFT_TYPE_UINT16,
        /// <summary>Whole numbers of 16 bits.</summary>
        Int16 = CleftNative.CLEFT_TYPE_INT16,
        /// <summary>Whole numbers of 32 bits without sign.</summary>
        UInt32 = CleftNative.CLEFT_TYPE_UINT32,
        /// <summary>Whole numbers of 32 bits.</summary>
        Int32 = CleftNative.CLEFT_TYPE_INT32,
        /// <summary>Real numbers, single precision.</summary>
        Float32 = CleftNative.CLEFT_TYPE_FLOAT32,
        /// <summary>Real numbers, double precision.</summary>
        Float64 = CleftNative.CLEFT_TYPE_FLOAT64
    }

    /// <summary>Sides of the box in the axes of the voxels: the numbers in Surface.HullSides.</summary>
    public enum Side
    {
        /// <summary>The least x.</summary>
        XMin = CleftNative.CLEFT_SIDE_X_MIN,
        /// <summary>The greatest x.</summary>
        XMax = CleftNative.CLEFT_SIDE_X_MAX,
        /// <summary>The least y.</summary>
        YMin = CleftNative.CLEFT_SIDE_Y_MIN,
        /// <summary>The greatest y.</summary>
        YMax = CleftNative.CLEFT_SIDE_Y_MAX,
        /// <summary>The least z.</summary>
        ZMin = CleftNative.CLEFT_SIDE_Z_MIN,
        /// <summary>The greatest z.</summary>
        ZMax = CleftNative.CLEFT_SIDE_Z_MAX,
        /// <summary>No side of the box.</summary>
        Other = CleftNative.CLEFT_SIDE_OTHER
    }

    /// <summary>How much a sentence of the log matters.</summary>
    public enum LogLevel
    {
        /// <summary>Something may not be as wished.</summary>
        Warning = CleftNative.CLEFT_LOG_WARNING,
        /// <summary>Good to know.</summary>
        Info = CleftNative.CLEFT_LOG_INFO,
        /// <summary>For those who look for a fault.</summary>
        Debug = CleftNative.CLEFT_LOG_DEBUG
    }

    /// <summary>The shape of a mesh in figures. Angles are dihedral angles, in degrees.</summary>
    public sealed class Quality
    {
        internal Quality(NativeQuality q)
        {
            TetCount = q.tet_count;
            MinDihedral = q.min_dihedral;
            MaxDihedral = q.max_dihedral;
            TetsBelow5 = q.tets_below_5;
            TetsBelow10 = q.tets_below_10;
            TetsBelow15 = q.tets_below_15;
            TetsBelow20 = q.tets_below_20;
            TetsAbove165 = q.tets_above_165;
            RadiusRatioMedian = q.radius_ratio_median;
            RadiusRatio95 = q.radius_ratio_95;
            RadiusRatioMax = q.radius_ratio_max;
            EdgeRatioMax = q.edge_ratio_max;
            MinEdge = q.min_edge;
            MeanEdge = q.mean_edge;
            MaxEdge = q.max_edge;
            MinVolume = q.min_volume;
            TotalVolume = q.total_volume;
            long[] bins = new long[36];
            for (int bin = 0; bin < bins.Length; ++bin)
                bins[bin] = q.histogram_bin(bin);
            DihedralHistogram = bins;
        }

        /// <summary>Tetrahedra.</summary>
        public long TetCount { get; }
        /// <summary>The least angle.</summary>
        public double MinDihedral { get; }
        /// <summary>The greatest angle.</summary>
        public double MaxDihedral { get; }
        /// <summary>Tetrahedra whose least angle is below 5 degrees.</summary>
        public long TetsBelow5 { get; }
        /// <summary>Tetrahedra whose least angle is below 10 degrees.</summary>
        public long TetsBelow10 { get; }
        /// <summary>Tetrahedra whose least angle is below 15 degrees.</summary>
        public long TetsBelow15 { get; }
        /// <summary>Tetrahedra whose least angle is below 20 degrees.</summary>
        public long TetsBelow20 { get; }
        /// <summary>Tetrahedra whose greatest angle is above 165 degrees.</summary>
        public long TetsAbove165 { get; }
        /// <summary>Circumradius / (3 inradius), 1 for the regular tetrahedron: the median.</summary>
        public double RadiusRatioMedian { get; }
        /// <summary>Its 95th percentile.</summary>
        public double RadiusRatio95 { get; }
        /// <summary>Its greatest value.</summary>
        public double RadiusRatioMax { get; }
        /// <summary>Longest / shortest edge of one tetrahedron.</summary>
        public double EdgeRatioMax { get; }
        /// <summary>The shortest edge.</summary>
        public double MinEdge { get; }
        /// <summary>The mean edge.</summary>
        public double MeanEdge { get; }
        /// <summary>The longest edge.</summary>
        public double MaxEdge { get; }
        /// <summary>The least volume of a tetrahedron.</summary>
        public double MinVolume { get; }
        /// <summary>The volume of all.</summary>
        public double TotalVolume { get; }
        /// <summary>All angles, in 36 bins of 5 degrees.</summary>
        public IReadOnlyList<long> DihedralHistogram { get; }

        /// <summary>What this is, in a few words.</summary>
        public override string ToString()
        {
            return FormattableString.Invariant(
                $"Quality of {TetCount} tetrahedra: dihedral angles {MinDihedral:0.0} to {MaxDihedral:0.0} degrees");
        }
    }

    /// <summary>What is wrong with a mesh; all counts are 0 for a sound one.</summary>
    public sealed class Validation
    {
        internal Validation(NativeValidation v, string sentence)
        {
            IsValid = v.valid != 0;
            NegativeTets = v.negative_tets;
            FlatTets = v.flat_tets;
            RepeatedCorners = v.repeated_corners;
            CrowdedFaces = v.crowded_faces;
            FoldedFaces = v.folded_faces;
            HullOffBox = v.hull_off_box;
            OpenInterfaceEdges = v.open_interface_edges;
            UnusedPoints = v.unused_points;
            RepeatedPoints = v.repeated_points;
            Volume = v.volume;
            BoxVolume = v.box_volume;
            HullArea = v.hull_area;
            BoxArea = v.box_area;
            InterfaceTriangles = v.interface_triangles;
            HullTriangles = v.hull_triangles;
            FirstFault = IsValid ? "" : sentence;
        }

        /// <summary>Is nothing wrong?</summary>
        public bool IsValid { get; }
        /// <summary>Tetrahedra turned inside out.</summary>
        public long NegativeTets { get; }
        /// <summary>Tetrahedra without volume.</summary>
        public long FlatTets { get; }
        /// <summary>Tetrahedra that name a point twice.</summary>
        public long RepeatedCorners { get; }
        /// <summary>Faces of more than two tetrahedra.</summary>
        public long CrowdedFaces { get; }
        /// <summary>Faces whose two tetrahedra lie on one side.</summary>
        public long FoldedFaces { get; }
        /// <summary>Hull triangles in no side of the bounding box.</summary>
        public long HullOffBox { get; }
        /// <summary>Edges inside the box with one interface triangle only.</summary>
        public long OpenInterfaceEdges { get; }
        /// <summary>Points of no tetrahedron.</summary>
        public long UnusedPoints { get; }
        /// <summary>Points at the place of another.</summary>
        public long RepeatedPoints { get; }
        /// <summary>The volume of the tetrahedra.</summary>
        public double Volume { get; }
        /// <summary>The volume of the bounding box.</summary>
        public double BoxVolume { get; }
        /// <summary>The area of the hull.</summary>
        public double HullArea { get; }
        /// <summary>The area of the bounding box.</summary>
        public double BoxArea { get; }
        /// <summary>Triangles between two labels.</summary>
        public long InterfaceTriangles { get; }
        /// <summary>Triangles of the hull.</summary>
        public long HullTriangles { get; }
        /// <summary>The first fault and its place, "" if there is none.</summary>
        public string FirstFault { get; }

        /// <summary>What this is, in a few words.</summary>
        public override string ToString() { return IsValid ? "Validation: nothing is wrong" : "Validation: " + FirstFault; }
    }

    /// <summary>What became of one label. Volumes are in world units cubed.</summary>
    public sealed class LabelReport
    {
        internal LabelReport(NativeLabelReport row)
        {
            Label = row.label;
            Voxels = row.voxels;
            VoxelVolume = row.voxel_volume;
            MeshVolume = row.mesh_volume;
            Tets = row.tets;
            VoxelComponents = row.voxel_components;
            MeshComponents = row.mesh_components;
            LargeComponents = row.large_components;
            LargeComponentsLost = row.large_components_lost;
            LargeComponentsBroken = row.large_components_broken;
            LargeComponentsJoined = row.large_components_joined;
            Lost = row.lost != 0;
        }

        /// <summary>The label.</summary>
        public int Label { get; }
        /// <summary>Its voxels.</summary>
        public long Voxels { get; }
        /// <summary>Their volume.</summary>
        public double VoxelVolume { get; }
        /// <summary>The volume of its tetrahedra.</summary>
        public double MeshVolume { get; }
        /// <summary>Its tetrahedra.</summary>
        public long Tets { get; }
        /// <summary>Pieces of its voxels, joined by faces.</summary>
        public long VoxelComponents { get; }
        /// <summary>Pieces of its tetrahedra, joined by faces.</summary>
        public long MeshComponents { get; }
        /// <summary>Voxel components of more than 30 voxels.</summary>
        public long LargeComponents { get; }
        /// <summary>Of those, the ones in which no tetrahedron of the label lies.</summary>
        public long LargeComponentsLost { get; }
        /// <summary>Of those, the ones that lie in several components of the mesh.</summary>
        public long LargeComponentsBroken { get; }
        /// <summary>Of those, the ones that lie in one component of the mesh with another.</summary>
        public long LargeComponentsJoined { get; }
        /// <summary>Has the label voxels, but no tetrahedron?</summary>
        public bool Lost { get; }

        /// <summary>What this is, in a few words.</summary>
        public override string ToString()
        {
            return FormattableString.Invariant(
                $"LabelReport of {Label}: {Voxels} voxels of volume {VoxelVolume}, {Tets} tetrahedra of {MeshVolume}");
        }
    }

    /// <summary>What values an option takes.</summary>
    public enum OptionType
    {
        /// <summary>Whole numbers.</summary>
        Integer = CleftNative.CLEFT_OPTION_TYPE_INTEGER,
        /// <summary>Real numbers.</summary>
        Real = CleftNative.CLEFT_OPTION_TYPE_REAL,
        /// <summary>One of several names.</summary>
        Choice = CleftNative.CLEFT_OPTION_TYPE_CHOICE,
        /// <summary>On or off.</summary>
        Flag = CleftNative.CLEFT_OPTION_TYPE_FLAG
    }

    /// <summary>One row of the library's table of options.</summary>
    public sealed class OptionDescription
    {
        private OptionDescription(NativeOptionDescription row)
        {
            Name = row.name;
            Type = (OptionType)row.type;
            Default = row.value;
            Least = row.least;
            Greatest = row.greatest;
            Choices = row.choices.Length == 0 ? new string[0] : row.choices.Split('|');
            Text = row.text;
        }

        /// <summary>As in "feature_scale".</summary>
        public string Name { get; }
        /// <summary>What values it takes.</summary>
        public OptionType Type { get; }
        /// <summary>The default, as a number.</summary>
        public double Default { get; }
        /// <summary>The least value.</summary>
        public double Least { get; }
        /// <summary>The greatest value.</summary>
        public double Greatest { get; }
        /// <summary>Names of the choices 0, 1, ...; empty for other types.</summary>
        public IReadOnlyList<string> Choices { get; }
        /// <summary>What it does.</summary>
        public string Text { get; }

        /// <summary>All options that have one value.</summary>
        public static IReadOnlyList<OptionDescription> Table()
        {
            NativeModules.Core();
            var rows = new List<OptionDescription>();
            for (int index = 0; index < CleftNative.cleft_option_count(); ++index)
                using (var row = new NativeOptionDescription()) {
                    CleftException.Check(CleftNative.cleft_option_info(index, row));
                    rows.Add(new OptionDescription(row));
                }
            return rows;
        }
    }

    /// <summary>What there is to know of the library.</summary>
    public static class Library
    {
        /// <summary>The version of the native library, as in "1.2.3".</summary>
        public static string Version
        {
            get {
                NativeModules.Core();
                return CleftNative.cleft_version(null, null, null);
            }
        }

        /// <summary>Can this build make Background.Particles (is TetGen in it)?</summary>
        public static bool HasTetgen
        {
            get {
                NativeModules.Core();
                return CleftNative.cleft_has_tetgen() != 0;
            }
        }
    }
}
