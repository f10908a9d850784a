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

        /// <summary>Tetrahedra.</summary>
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
        /// <summary>Circumradius / (3 inradius), 1 for the regular tetrahedron: the median.</summary>
        public double RadiusRatioMedian { get; }
        /// <summary>95th percentile of the radius ratio.</summary>
        public double RadiusRatio95 { get; }
        /// <summary>The greatest radius ratio.</summary>
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
        /// <summary>All angles, in bins of 5 degrees.</summary>
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

        /// <summary>True if nothing is wrong.</summary>
        public bool IsValid { get; }
        /// <summary>Tetrahedra that are turned inside out, by an exact predicate.</summary>
        public long NegativeTets { get; }
        /// <summary>Tetrahedra that are flat, or of less volume than 1e-12 of the cube of their mean edge.</summary>
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
        /// <summary>
        /// Faces between tetrahedra of different labels, counted face by face: a surface finds as many, by another way.
        /// </summary>
        public long InterfaceTriangles { get; }
        /// <summary>Faces of one tetrahedron, counted so, too.</summary>
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
        /// <summary>Its voxels.</summary>
        public long Voxels { get; }
        /// <summary>The volume of its voxels.</summary>
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
        /// <summary>True if the label has voxels but no tetrahedron.</summary>
        public bool Lost { get; }
        /// <summary>
        /// Of the large components, those that lie in several components of the mesh, each with half a voxel or more:
        /// parts thinner than the tetrahedra around broke; a smaller size there keeps them.
        /// </summary>
        public long LargeComponentsBroken { get; }
        /// <summary>
        /// Of the large components, those that lie in one component of the mesh with another of them, each with half a
        /// voxel or more. They touch over an edge or a corner of voxels, or are nearer than an element tells apart.
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
        /// <summary>The other.</summary>
        public int Second { get; }
        /// <summary>The triangles that the two share.</summary>
        public long Triangles { get; }
    }

    public sealed partial class Estimate
    {
        internal Estimate(NativeEstimate row)
        {
            IsBound = row.is_bound != 0;
            Tets = row.tets;
            WholeTets = row.whole_tets;
            BackgroundTets = row.background_tets;
            PeakBytes = row.peak_bytes;
        }

        /// <summary>True if there may be fewer: labels have few points each, and most cuts may have to stay.</summary>
        public bool IsBound { get; }
        /// <summary>Tetrahedra of the finished mesh, in the labels that strip and only keep.</summary>
        public double Tets { get; }
        /// <summary>Tetrahedra of the mesh from which the other labels are left out.</summary>
        public double WholeTets { get; }
        /// <summary>Tetrahedra of the background that is cleaved.</summary>
        public double BackgroundTets { get; }
        /// <summary>The most memory that a process takes to make the mesh, in bytes, no less.</summary>
        public double PeakBytes { get; }
    }
}
