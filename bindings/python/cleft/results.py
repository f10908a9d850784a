"""What the library tells of a mesh, as plain values."""
from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Estimate:
    """What a mesh will come to."""

    # <Estimate> made by tools/generate.py from include/cleft/cleft.h
    #: true if the numbers may be far off, since several interfaces cross one edge: the sizes are large against the
    #: parts
    is_rough: bool
    tets: float  #: tetrahedra of the finished mesh, in the labels that strip and only keep
    whole_tets: float  #: tetrahedra of the mesh before labels are left out
    background_tets: float  #: tetrahedra of the background
    peak_bytes: float  #: an upper bound on the memory of a process that reads the volume and makes the mesh, in bytes
    # </Estimate>


@dataclass(frozen=True)
class Quality:
    """The shape of a mesh in figures; angles are dihedral angles, in degrees."""

    # <Quality> made by tools/generate.py from include/cleft/cleft.h
    tet_count: int  #: number of tetrahedra
    min_dihedral: float  #: the least dihedral angle, in degrees
    max_dihedral: float  #: the greatest dihedral angle, in degrees
    tets_below_5: int  #: tetrahedra whose least dihedral angle is below 5 degrees
    tets_below_10: int  #: tetrahedra whose least dihedral angle is below 10 degrees
    tets_below_15: int  #: tetrahedra whose least dihedral angle is below 15 degrees
    tets_below_20: int  #: tetrahedra whose least dihedral angle is below 20 degrees
    tets_above_165: int  #: tetrahedra whose greatest dihedral angle is above 165 degrees
    radius_ratio_median: float  #: median of the radius ratio, circumradius / (3 * inradius); the least is 1
    radius_ratio_95: float  #: 95th percentile of the radius ratio
    radius_ratio_max: float  #: the greatest radius ratio
    edge_ratio_max: float  #: the greatest ratio of longest to shortest edge of one tetrahedron
    min_edge: float  #: the length of the shortest edge
    mean_edge: float  #: the mean length of an edge
    max_edge: float  #: the length of the longest edge
    min_volume: float  #: the least volume of a tetrahedron
    total_volume: float  #: the volume of all tetrahedra
    dihedral_histogram: tuple[int, ...]  #: counts of all dihedral angles, in bins of 5 degrees
    # </Quality>


@dataclass(frozen=True)
class MetricQuality:
    """How well a mesh meets a metric, which measures an edge of the wanted length as 1."""

    # <MetricQuality> made by tools/generate.py from include/cleft/cleft.h
    tet_count: int  #: number of tetrahedra
    edge_count: int  #: number of edges
    edges_in_range: int  #: edges whose length in the metric is within 1/sqrt(2) to sqrt(2)
    edge_least: float  #: the least length of an edge in the metric
    edge_01: float  #: 1st percentile of the lengths
    edge_median: float  #: median of the lengths
    edge_99: float  #: 99th percentile of the lengths
    edge_greatest: float  #: the greatest length
    mean_ratio_least: float  #: the least mean ratio: 1 is regular in the metric, 0 flat
    mean_ratio_01: float  #: 1st percentile of the mean ratio
    mean_ratio_median: float  #: median of the mean ratio
    min_dihedral: float  #: the least dihedral angle in the metric, in degrees
    max_dihedral: float  #: the greatest dihedral angle in the metric, in degrees
    dihedral_histogram: tuple[int, ...]  #: counts of all dihedral angles in the metric, in bins of 5 degrees
    # </MetricQuality>


@dataclass(frozen=True)
class Validation:
    """What is wrong with a mesh: the counts of faults are 0 for a sound one, which is true in a condition."""

    # <Validation> made by tools/generate.py from include/cleft/cleft.h
    valid: bool  #: true if there is no fault
    negative_tets: int  #: tetrahedra of negative orientation, by an exact predicate
    flat_tets: int  #: tetrahedra that are flat, or of a volume below 1e-12 of their mean edge cubed
    repeated_corners: int  #: tetrahedra that name a point twice
    crowded_faces: int  #: faces that more than two tetrahedra share
    folded_faces: int  #: faces whose two tetrahedra lie on the same side
    hull_off_box: int  #: hull triangles that are in no side of the bounding box
    open_interface_edges: int  #: edges inside the box that only one interface triangle has
    unused_points: int  #: points that no tetrahedron uses
    repeated_points: int  #: points with the coordinates of another point
    volume: float  #: the volume of all tetrahedra
    box_volume: float  #: the volume of the bounding box
    hull_area: float  #: the area of the hull
    box_area: float  #: the area of the bounding box
    #: faces between tetrahedra of different labels, counted face by face. cleft_surface_interface_count() of the mesh
    #: must be the same
    interface_triangles: int
    hull_triangles: int  #: faces that only one tetrahedron has; cleft_surface_hull_count() must be the same
    # </Validation>
    first_fault: str  #: the first fault and its place, "" if there is none

    def __bool__(self) -> bool:
        return self.valid


@dataclass(frozen=True)
class LabelReport:
    """What became of one label; volumes in world units cubed."""

    # <LabelReport> made by tools/generate.py from include/cleft/cleft.h
    label: int  #: the label
    voxels: int  #: number of its voxels
    voxel_volume: float  #: the volume of its voxels
    mesh_volume: float  #: the volume of its tetrahedra
    tets: int  #: number of its tetrahedra
    voxel_components: int  #: components of its voxels
    mesh_components: int  #: components of its tetrahedra
    large_components: int  #: voxel components of more than 30 voxels
    large_components_lost: int  #: large components in which no tetrahedron of the label lies
    lost: bool  #: true if the label has voxels but no tetrahedron
    #: large components that lie in several components of the mesh, each with half a voxel or more. Such a part broke
    #: because it is thinner than the tetrahedra around it; a smaller size there keeps it whole
    large_components_broken: int
    #: large components that share a component of the mesh with another large one, each with half a voxel or more. They
    #: touch over an edge or corner of voxels, or are nearer than one element
    large_components_joined: int
    # </LabelReport>


@dataclass(frozen=True)
class Contact:
    """Two labels that share triangles in the mesh, but of which no two voxels share a face or an edge, a corner at
    most.

    The gap between them is narrower than the tetrahedra there; a smaller size opens it.
    """

    # <Contact> made by tools/generate.py from include/cleft/cleft.h
    first: int  #: the lower of the two labels
    second: int  #: the higher of the two labels
    triangles: int  #: number of triangles that the two labels share
    # </Contact>


@dataclass(frozen=True)
class Distance:
    """How far an interface of the mesh is from that of the volume, in world units, or a line where three labels meet.

    `mesh_` stands for distances from the mesh to the volume, `volume_` for those from the volume to the mesh.
    """

    # <Distance> made by tools/generate.py from include/cleft/cleft.h
    first: int  #: the lowest of the labels
    second: int  #: the next one
    third: int  #: the highest of the labels of a line; for an interface the same as `second`
    is_line: bool  #: true if it is a line where three labels meet
    elements: int  #: number of triangles of the interface, or of edges of the line, in the mesh
    points: int  #: number of points of the volume's interface or line that were looked at
    mesh_mean: float  #: mean distance from the mesh to the volume
    mesh_99: float  #: 99 % of the mesh are no farther from the volume
    mesh_greatest: float  #: greatest distance from the mesh to the volume
    volume_mean: float  #: mean distance from the volume to the mesh
    volume_99: float  #: 99 % of the points are no farther from the mesh
    volume_greatest: float  #: greatest distance from the volume to the mesh
    # </Distance>


class Report(list[LabelReport]):
    """The reports of all labels of a volume, in its order, and the `contacts` that its voxels do not have.

    `distances` are those of interfaces and then of lines, if they were asked for.
    """

    def __init__(self) -> None:
        super().__init__()
        self.contacts: list[Contact] = []
        self.distances: list[Distance] = []


def from_struct(kind: Any, struct: Any, **more: Any) -> Any:
    """A value of a class above, from the library's struct of the same field names and from `more`."""
    values = {}
    for field in dataclasses.fields(kind):
        if field.name not in more:
            value = getattr(struct, field.name)
            values[field.name] = bool(value) if field.type == "bool" else value
    return kind(**values, **more)
