"""What the library tells of a mesh, as plain values."""
from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Estimate:
    """What a mesh will come to."""

    # <Estimate> made by tools/generate.py from include/cleft/cleft.h
    is_bound: bool  #: true if there may be fewer: labels have few points each, and most cuts may have to stay
    tets: float  #: tetrahedra of the finished mesh, in the labels that strip and only keep
    whole_tets: float  #: tetrahedra of the mesh from which the other labels are left out
    background_tets: float  #: tetrahedra of the background that is cleaved
    peak_bytes: float  #: the most memory that a process takes to make the mesh, in bytes, no less
    # </Estimate>


@dataclass(frozen=True)
class Quality:
    """The shape of a mesh in figures; angles are dihedral angles, in degrees."""

    # <Quality> made by tools/generate.py from include/cleft/cleft.h
    tet_count: int  #: tetrahedra
    min_dihedral: float  #: the least dihedral angle, in degrees
    max_dihedral: float  #: the greatest dihedral angle, in degrees
    tets_below_5: int  #: tetrahedra whose least dihedral angle is below 5 degrees
    tets_below_10: int  #: tetrahedra whose least dihedral angle is below 10 degrees
    tets_below_15: int  #: tetrahedra whose least dihedral angle is below 15 degrees
    tets_below_20: int  #: tetrahedra whose least dihedral angle is below 20 degrees
    tets_above_165: int  #: tetrahedra whose greatest dihedral angle is above 165 degrees
    radius_ratio_median: float  #: circumradius / (3 inradius), 1 for the regular tetrahedron: the median
    radius_ratio_95: float  #: 95th percentile of the radius ratio
    radius_ratio_max: float  #: the greatest radius ratio
    edge_ratio_max: float  #: longest / shortest edge of one tetrahedron
    min_edge: float  #: the shortest edge
    mean_edge: float  #: the mean edge
    max_edge: float  #: the longest edge
    min_volume: float  #: the least volume of a tetrahedron
    total_volume: float  #: the volume of all
    dihedral_histogram: tuple[int, ...]  #: all angles, in bins of 5 degrees
    # </Quality>


@dataclass(frozen=True)
class Validation:
    """What is wrong with a mesh: the counts of faults are 0 for a sound one, which is true in a condition."""

    # <Validation> made by tools/generate.py from include/cleft/cleft.h
    valid: bool  #: true if nothing is wrong
    negative_tets: int  #: tetrahedra that are turned inside out, by an exact predicate
    flat_tets: int  #: tetrahedra that are flat, or of less volume than 1e-12 of the cube of their mean edge
    repeated_corners: int  #: tetrahedra that name a point twice
    crowded_faces: int  #: faces of more than two tetrahedra
    folded_faces: int  #: faces whose two tetrahedra lie on one side
    hull_off_box: int  #: hull triangles in no side of the bounding box
    open_interface_edges: int  #: edges inside the box with one interface triangle only
    unused_points: int  #: points of no tetrahedron
    repeated_points: int  #: points at the place of another
    volume: float  #: the volume of the tetrahedra
    box_volume: float  #: the volume of the bounding box
    hull_area: float  #: the area of the hull
    box_area: float  #: the area of the bounding box
    #: faces between tetrahedra of different labels, counted face by face: a surface finds as many, by another way
    interface_triangles: int
    hull_triangles: int  #: faces of one tetrahedron, counted so, too
    # </Validation>
    first_fault: str  #: the first fault and its place, "" if there is none

    def __bool__(self) -> bool:
        return self.valid


@dataclass(frozen=True)
class LabelReport:
    """What became of one label; volumes in world units cubed."""

    # <LabelReport> made by tools/generate.py from include/cleft/cleft.h
    label: int  #: the label
    voxels: int  #: its voxels
    voxel_volume: float  #: the volume of its voxels
    mesh_volume: float  #: the volume of its tetrahedra
    tets: int  #: its tetrahedra
    voxel_components: int  #: pieces of its voxels, joined by faces
    mesh_components: int  #: pieces of its tetrahedra, joined by faces
    large_components: int  #: voxel components of more than 30 voxels
    large_components_lost: int  #: of those, the ones in which no tetrahedron of the label lies
    lost: bool  #: true if the label has voxels but no tetrahedron
    #: of the large components, those that lie in several components of the mesh, each with half a voxel or more: parts
    #: thinner than the tetrahedra around broke; a smaller size there keeps them
    large_components_broken: int
    #: of the large components, those that lie in one component of the mesh with another of them, each with half a voxel
    #: or more. They touch over an edge or a corner of voxels, or are nearer than an element tells apart
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
    second: int  #: the other
    triangles: int  #: the triangles that the two share
    # </Contact>


class Report(list[LabelReport]):
    """The reports of all labels of a volume, in its order, and the `contacts` that its voxels do not have."""

    def __init__(self) -> None:
        super().__init__()
        self.contacts: list[Contact] = []


def from_struct(kind: Any, struct: Any, **more: Any) -> Any:
    """A value of a class above, from the library's struct of the same field names and from `more`."""
    values = {}
    for field in dataclasses.fields(kind):
        if field.name not in more:
            value = getattr(struct, field.name)
            values[field.name] = bool(value) if field.type == "bool" else value
    return kind(**values, **more)
