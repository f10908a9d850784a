"""What the library tells of a mesh, as plain values."""
from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Quality:
    """The shape of a mesh in figures; angles are dihedral angles, in degrees."""

    tet_count: int
    min_dihedral: float
    max_dihedral: float
    tets_below_5: int  #: tetrahedra whose least dihedral angle is below 5 degrees
    tets_below_10: int
    tets_below_15: int
    tets_below_20: int
    tets_above_165: int  #: tetrahedra whose greatest dihedral angle is above 165 degrees
    radius_ratio_median: float  #: circumradius / (3 inradius), 1 for the regular tetrahedron
    radius_ratio_95: float
    radius_ratio_max: float
    edge_ratio_max: float
    min_edge: float
    mean_edge: float
    max_edge: float
    min_volume: float
    total_volume: float
    dihedral_histogram: tuple[int, ...]  #: all angles, in 36 bins of 5 degrees


@dataclass(frozen=True)
class Validation:
    """What is wrong with a mesh: the counts of faults are 0 for a sound one, which is true in a condition."""

    valid: bool
    negative_tets: int
    flat_tets: int
    repeated_corners: int
    crowded_faces: int  #: faces of more than two tetrahedra
    folded_faces: int  #: faces whose two tetrahedra lie on one side
    hull_off_box: int  #: hull triangles in no side of the bounding box
    open_interface_edges: int
    unused_points: int
    repeated_points: int
    volume: float
    box_volume: float
    hull_area: float
    box_area: float
    interface_triangles: int  #: between different labels, counted face by face: a surface has as many
    hull_triangles: int  #: faces of one tetrahedron
    first_fault: str  #: the first fault and its place, "" if there is none

    def __bool__(self) -> bool:
        return self.valid


@dataclass(frozen=True)
class LabelReport:
    """What became of one label; volumes in world units cubed."""

    label: int
    voxels: int
    voxel_volume: float
    mesh_volume: float
    tets: int
    voxel_components: int
    mesh_components: int
    large_components: int  #: voxel components of more than 30 voxels
    large_components_lost: int  #: of those, the ones in which no tetrahedron of the label lies
    large_components_broken: int  #: of those, the ones that lie in several components of the mesh
    large_components_joined: int  #: of those, the ones that lie in one component of the mesh with another
    lost: bool  #: the label has voxels but no tetrahedron


@dataclass(frozen=True)
class Contact:
    """Two labels that share triangles in the mesh, but of which no two voxels share a face or an edge, a corner at most.

    The gap between them is narrower than the tetrahedra there; a smaller size opens it.
    """

    first: int  #: the lower of the two labels
    second: int
    triangles: int  #: that the two share


class Report(list[LabelReport]):
    """The reports of all labels of a volume, in its order, and the `contacts` that its voxels do not have."""

    def __init__(self) -> None:
        super().__init__()
        self.contacts: list[Contact] = []


def from_struct(kind: Any, struct: Any, **more: Any) -> Any:
    """A value of a class above, from the library's struct of the same field names and from `more`."""
    values = {field.name: getattr(struct, field.name) for field in dataclasses.fields(kind) if field.name not in more}
    for flag in {"valid", "lost"} & set(values):
        values[flag] = bool(values[flag])
    return kind(**values, **more)
