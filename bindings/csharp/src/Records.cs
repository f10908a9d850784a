// Made by tools/generate.py from src/capi/options.toml and include/cleft/*.h.
using System.Collections.Generic;

namespace Cleft
{
    public sealed partial class Quality
    {
        internal Quality(NativeQuality row)
        {
            TetCount = row.tet_count;
            MinDihedral = row.min_dihedral;
            MaxDihedral = row.max_dihedral;
            TetsBelow5 = row.tets_below_5;
            TetsBelow10 = row.tets_below_10;
            TetsBelow15 = row.tets_below_15;
            TetsBelow20 = row.tets_below_20;
            TetsAbove165 = row.tets_above_165;
            RadiusRatioMedian = row.radius_ratio_median;
            RadiusRatio95 = row.radius_ratio_95;
            RadiusRatioMax = row.radius_ratio_max;
            EdgeRatioMax = row.edge_ratio_max;
            MinEdge = row.min_edge;
            MeanEdge = row.mean_edge;
            MaxEdge = row.max_edge;
            MinVolume = row.min_volume;
            TotalVolume = row.total_volume;
            long[] dihedralHistogram = new long[36];
            for (int index = 0; index < 36; ++index)
                dihedralHistogram[index] = row.histogram_bin(index);
            DihedralHistogram = dihedralHistogram;
        }

        /// <summary>Number of tetrahedra.</summary>
        public long TetCount { get; }
        /// <summary>The least dihedral angle, in degrees.</summary>
        public double MinDihedral { get; }
        /// <summary>The greatest dihedral angle, in degrees.</summary>
        public double MaxDihedral { get; }
        /// <summary>Tetrahedra whose least dihedral angle is below 5 degrees.</summary>
        public long TetsBelow5 { get; }
        /// <summary>Tetrahedra whose least dihedral angle is below 10 degrees.</summary>
        public long TetsBelow10 { get; }
        /// <summary>Tetrahedra whose least dihedral angle is below 15 degrees.</summary>
        public long TetsBelow15 { get; }
        /// <summary>Tetrahedra whose least dihedral angle is below 20 degrees.</summary>
        public long TetsBelow20 { get; }
        /// <summary>Tetrahedra whose greatest dihedral angle is above 165 degrees.</summary>
        public long TetsAbove165 { get; }
        /// <summary>Median of the radius ratio, circumradius / (3 * inradius); the least is 1.</summary>
        public double RadiusRatioMedian { get; }
        /// <summary>95th percentile of the radius ratio.</summary>
        public double RadiusRatio95 { get; }
        /// <summary>The greatest radius ratio.</summary>
        public double RadiusRatioMax { get; }
        /// <summary>The greatest ratio of longest to shortest edge of one tetrahedron.</summary>
        public double EdgeRatioMax { get; }
        /// <summary>The length of the shortest edge.</summary>
        public double MinEdge { get; }
        /// <summary>The mean length of an edge.</summary>
        public double MeanEdge { get; }
        /// <summary>The length of the longest edge.</summary>
        public double MaxEdge { get; }
        /// <summary>The least volume of a tetrahedron.</summary>
        public double MinVolume { get; }
        /// <summary>The volume of all tetrahedra.</summary>
        public double TotalVolume { get; }
        /// <summary>Counts of all dihedral angles, in bins of 5 degrees.</summary>
        public IReadOnlyList<long> DihedralHistogram { get; }
    }

    public sealed partial class MetricQuality
    {
        internal MetricQuality(NativeMetricQuality row)
        {
            TetCount = row.tet_count;
            EdgeCount = row.edge_count;
            EdgesInRange = row.edges_in_range;
            EdgeLeast = row.edge_least;
            Edge01 = row.edge_01;
            EdgeMedian = row.edge_median;
            Edge99 = row.edge_99;
            EdgeGreatest = row.edge_greatest;
            MeanRatioLeast = row.mean_ratio_least;
            MeanRatio01 = row.mean_ratio_01;
            MeanRatioMedian = row.mean_ratio_median;
            MinDihedral = row.min_dihedral;
            MaxDihedral = row.max_dihedral;
            long[] dihedralHistogram = new long[36];
            for (int index = 0; index < 36; ++index)
                dihedralHistogram[index] = row.histogram_bin(index);
            DihedralHistogram = dihedralHistogram;
        }

        /// <summary>Number of tetrahedra.</summary>
        public long TetCount { get; }
        /// <summary>Number of edges.</summary>
        public long EdgeCount { get; }
        /// <summary>Edges whose length in the metric is within 1/sqrt(2) to sqrt(2).</summary>
        public long EdgesInRange { get; }
        /// <summary>The least length of an edge in the metric.</summary>
        public double EdgeLeast { get; }
        /// <summary>1st percentile of the lengths.</summary>
        public double Edge01 { get; }
        /// <summary>Median of the lengths.</summary>
        public double EdgeMedian { get; }
        /// <summary>99th percentile of the lengths.</summary>
        public double Edge99 { get; }
        /// <summary>The greatest length.</summary>
        public double EdgeGreatest { get; }
        /// <summary>The least mean ratio: 1 is regular in the metric, 0 flat.</summary>
        public double MeanRatioLeast { get; }
        /// <summary>1st percentile of the mean ratio.</summary>
        public double MeanRatio01 { get; }
        /// <summary>Median of the mean ratio.</summary>
        public double MeanRatioMedian { get; }
        /// <summary>The least dihedral angle in the metric, in degrees.</summary>
        public double MinDihedral { get; }
        /// <summary>The greatest dihedral angle in the metric, in degrees.</summary>
        public double MaxDihedral { get; }
        /// <summary>Counts of all dihedral angles in the metric, in bins of 5 degrees.</summary>
        public IReadOnlyList<long> DihedralHistogram { get; }
    }

    public sealed partial class Validation
    {
        internal Validation(NativeValidation row)
        {
            IsValid = row.valid != 0;
            NegativeTets = row.negative_tets;
            FlatTets = row.flat_tets;
            RepeatedCorners = row.repeated_corners;
            CrowdedFaces = row.crowded_faces;
            FoldedFaces = row.folded_faces;
            HullOffBox = row.hull_off_box;
            OpenInterfaceEdges = row.open_interface_edges;
            UnusedPoints = row.unused_points;
            RepeatedPoints = row.repeated_points;
            Volume = row.volume;
            BoxVolume = row.box_volume;
            HullArea = row.hull_area;
            BoxArea = row.box_area;
            InterfaceTriangles = row.interface_triangles;
            HullTriangles = row.hull_triangles;
        }

        /// <summary>True if there is no fault.</summary>
        public bool IsValid { get; }
        /// <summary>Tetrahedra of negative orientation, by an exact predicate.</summary>
        public long NegativeTets { get; }
        /// <summary>Tetrahedra that are flat, or of a volume below 1e-12 of their mean edge cubed.</summary>
        public long FlatTets { get; }
        /// <summary>Tetrahedra that name a point twice.</summary>
        public long RepeatedCorners { get; }
        /// <summary>Faces that more than two tetrahedra share.</summary>
        public long CrowdedFaces { get; }
        /// <summary>Faces whose two tetrahedra lie on the same side.</summary>
        public long FoldedFaces { get; }
        /// <summary>Hull triangles that are in no side of the bounding box.</summary>
        public long HullOffBox { get; }
        /// <summary>Edges inside the box that only one interface triangle has.</summary>
        public long OpenInterfaceEdges { get; }
        /// <summary>Points that no tetrahedron uses.</summary>
        public long UnusedPoints { get; }
        /// <summary>Points with the coordinates of another point.</summary>
        public long RepeatedPoints { get; }
        /// <summary>The volume of all tetrahedra.</summary>
        public double Volume { get; }
        /// <summary>The volume of the bounding box.</summary>
        public double BoxVolume { get; }
        /// <summary>The area of the hull.</summary>
        public double HullArea { get; }
        /// <summary>The area of the bounding box.</summary>
        public double BoxArea { get; }
        /// <summary>
        /// Faces between tetrahedra of different labels, counted face by face. cleft_surface_interface_count() of the
        /// mesh must be the same.
        /// </summary>
        public long InterfaceTriangles { get; }
        /// <summary>Faces that only one tetrahedron has; cleft_surface_hull_count() must be the same.</summary>
        public long HullTriangles { get; }
    }

    public sealed partial class LabelReport
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
            Lost = row.lost != 0;
            LargeComponentsBroken = row.large_components_broken;
            LargeComponentsJoined = row.large_components_joined;
        }

        /// <summary>The label.</summary>
        public int Label { get; }
        /// <summary>Number of its voxels.</summary>
        public long Voxels { get; }
        /// <summary>The volume of its voxels.</summary>
        public double VoxelVolume { get; }
        /// <summary>The volume of its tetrahedra.</summary>
        public double MeshVolume { get; }
        /// <summary>Number of its tetrahedra.</summary>
        public long Tets { get; }
        /// <summary>Components of its voxels.</summary>
        public long VoxelComponents { get; }
        /// <summary>Components of its tetrahedra.</summary>
        public long MeshComponents { get; }
        /// <summary>Voxel components of more than 30 voxels.</summary>
        public long LargeComponents { get; }
        /// <summary>Large components in which no tetrahedron of the label lies.</summary>
        public long LargeComponentsLost { get; }
        /// <summary>True if the label has voxels but no tetrahedron.</summary>
        public bool Lost { get; }
        /// <summary>
        /// Large components that lie in several components of the mesh, each with half a voxel or more. Such a part
        /// broke because it is thinner than the tetrahedra around it; a smaller size there keeps it whole.
        /// </summary>
        public long LargeComponentsBroken { get; }
        /// <summary>
        /// Large components that share a component of the mesh with another large one, each with half a voxel or more.
        /// They touch over an edge or corner of voxels, or are nearer than one element.
        /// </summary>
        public long LargeComponentsJoined { get; }
    }

    public sealed partial class Contact
    {
        internal Contact(NativeContact row)
        {
            First = row.first;
            Second = row.second;
            Triangles = row.triangles;
        }

        /// <summary>The lower of the two labels.</summary>
        public int First { get; }
        /// <summary>The higher of the two labels.</summary>
        public int Second { get; }
        /// <summary>Number of triangles that the two labels share.</summary>
        public long Triangles { get; }
    }

    public sealed partial class Distance
    {
        internal Distance(NativeDistance row)
        {
            First = row.first;
            Second = row.second;
            Third = row.third;
            IsLine = row.is_line != 0;
            Elements = row.elements;
            Points = row.points;
            MeshMean = row.mesh_mean;
            Mesh99 = row.mesh_99;
            MeshGreatest = row.mesh_greatest;
            VolumeMean = row.volume_mean;
            Volume99 = row.volume_99;
            VolumeGreatest = row.volume_greatest;
        }

        /// <summary>The lowest of the labels.</summary>
        public int First { get; }
        /// <summary>The next one.</summary>
        public int Second { get; }
        /// <summary>The highest of the labels of a line; for an interface the same as `second`.</summary>
        public int Third { get; }
        /// <summary>True if it is a line where three labels meet.</summary>
        public bool IsLine { get; }
        /// <summary>Number of triangles of the interface, or of edges of the line, in the mesh.</summary>
        public long Elements { get; }
        /// <summary>Number of points of the volume's interface or line that were looked at.</summary>
        public long Points { get; }
        /// <summary>Mean distance from the mesh to the volume.</summary>
        public double MeshMean { get; }
        /// <summary>99 % of the mesh are no farther from the volume.</summary>
        public double Mesh99 { get; }
        /// <summary>Greatest distance from the mesh to the volume.</summary>
        public double MeshGreatest { get; }
        /// <summary>Mean distance from the volume to the mesh.</summary>
        public double VolumeMean { get; }
        /// <summary>99 % of the points are no farther from the mesh.</summary>
        public double Volume99 { get; }
        /// <summary>Greatest distance from the volume to the mesh.</summary>
        public double VolumeGreatest { get; }
    }

    public sealed partial class Estimate
    {
        internal Estimate(NativeEstimate row)
        {
            IsRough = row.is_rough != 0;
            Tets = row.tets;
            WholeTets = row.whole_tets;
            BackgroundTets = row.background_tets;
            PeakBytes = row.peak_bytes;
        }

        /// <summary>
        /// True if the numbers may be far off, since several interfaces cross one edge: the sizes are large against the
        /// parts.
        /// </summary>
        public bool IsRough { get; }
        /// <summary>Tetrahedra of the finished mesh, in the labels that strip and only keep.</summary>
        public double Tets { get; }
        /// <summary>Tetrahedra of the mesh before labels are left out.</summary>
        public double WholeTets { get; }
        /// <summary>Tetrahedra of the background.</summary>
        public double BackgroundTets { get; }
        /// <summary>
        /// An upper bound on the memory of a process that reads the volume and makes the mesh, in bytes.
        /// </summary>
        public double PeakBytes { get; }
    }
}
