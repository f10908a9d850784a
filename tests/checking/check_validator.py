"""Measures meshes a second time, with numpy and no code of the library, and compares.

usage: check_validator.py WRITE_CASES [DIRECTORY]

WRITE_CASES is the program that writes NAME.mesh and NAME.json for good and broken meshes. Every number of the JSON
files is measured here again by other means: counts must be equal, measures equal to 1e-9.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
from collections import Counter

import numpy as np

SIDE_TOLERANCE = 1e-6
SAME_PLACE = 1e-9
FLAT_VOLUME = 1e-12


def read_medit(path):
    words = iter(path.read_text().split())
    points = tets = None
    for word in words:
        if word == "Vertices":
            count = int(next(words))
            points = np.array([[float(next(words)) for _ in range(4)] for _ in range(count)])[:, :3]
        elif word == "Tetrahedra":
            count = int(next(words))
            tets = np.array([[int(next(words)) for _ in range(5)] for _ in range(count)])
    return points, tets[:, :4] - 1, tets[:, 4]


def determinants(points, tets):
    edges = points[tets[:, 1:]] - points[tets[:, :1]]
    return np.linalg.det(edges)


def measure_tets(points, tets):
    volumes = determinants(points, tets) / 6
    corner_pairs = [(i, j) for i in range(4) for j in range(i)]
    lengths = np.stack([np.linalg.norm(points[tets[:, i]] - points[tets[:, j]], axis=1) for i, j in corner_pairs], 1)
    flat_volume = FLAT_VOLUME * lengths.mean() ** 3
    return {
        "tets": len(tets),
        "repeated_corner": sum(len(set(tet)) < 4 for tet in tets.tolist()),
        "negative": np.sum(volumes < -flat_volume),
        "flat": np.sum(np.abs(volumes) <= flat_volume),
        "volume": volumes.sum(),
        "total_volume": volumes.sum(),
        "min_volume": volumes.min(),
        "min_edge": lengths.min(),
        "mean_edge": lengths.mean(),
        "max_edge": lengths.max(),
    }


def outward_unit_normals(points, tets):
    """Normals of the four faces, face i opposite corner i, pointing away from that corner; and their areas."""
    normals, areas = [], []
    for i in range(4):
        a, b, c = (points[tets[:, j]] for j in range(4) if j != i)
        normal = np.cross(b - a, c - a)
        length = np.linalg.norm(normal, axis=1)
        inward = np.einsum("ij,ij->i", normal, points[tets[:, i]] - a) > 0
        normal[inward] *= -1
        with np.errstate(invalid="ignore"):
            normals.append(normal / length[:, None])
        areas.append(length / 2)
    return normals, np.stack(areas, 1)


def measure_shapes(points, tets):
    """Of tetrahedra that are not flat."""
    normals, areas = outward_unit_normals(points, tets)
    angles = []
    for i in range(4):
        for j in range(i):
            cosine = np.einsum("ij,ij->i", normals[i], normals[j])
            angles.append(180 - np.degrees(np.arccos(np.clip(cosine, -1, 1))))
    angles = np.stack(angles, 1)
    least = angles.min(1)
    edges = points[tets[:, 1:]] - points[tets[:, :1]]
    centres = np.linalg.solve(2 * edges, (edges**2).sum(2)[:, :, None])[:, :, 0]
    circumradius = np.linalg.norm(centres, axis=1)
    inradius = 3 * np.abs(np.linalg.det(edges) / 6) / areas.sum(1)
    ratios = circumradius / (3 * inradius)
    return {
        "min_dihedral": least.min(),
        "max_dihedral": angles.max(),
        "below_5": np.sum(least < 5),
        "below_10": np.sum(least < 10),
        "below_15": np.sum(least < 15),
        "below_20": np.sum(least < 20),
        "above_165": np.sum(angles.max(1) > 165),
        "radius_ratio_median": np.percentile(ratios, 50),
        "radius_ratio_95": np.percentile(ratios, 95),
    }


class Box:
    def __init__(self, points):
        self.lo, self.hi = points.min(0), points.max(0)
        self.longest = (self.hi - self.lo).max()

    def volume(self):
        return np.prod(self.hi - self.lo)

    def area(self):
        x, y, z = self.hi - self.lo
        return 2 * (x * y + y * z + z * x)

    def holds_in_one_side(self, points):
        near = lambda wall: np.all(np.abs(points - wall) <= SIDE_TOLERANCE * self.longest, axis=0)
        return bool(np.any(near(self.lo)) or np.any(near(self.hi)))


def measure_points(points, tets):
    used = np.unique(tets)
    box = Box(points[used])
    places = {tuple(place) for place in np.round((points[used] - box.lo) / (SAME_PLACE * box.longest)).tolist()}
    return {
        "unused_points": len(points) - len(used),
        "repeated_points": len(used) - len(places),
        "box_volume": box.volume(),
        "box_area": box.area(),
    }


def faces_of(tets):
    """Sorted points of each face: the (tetrahedron, opposite point) pairs that have it."""
    faces = {}
    for t, tet in enumerate(tets.tolist()):
        for i in range(4):
            key = tuple(sorted(tet[:i] + tet[i + 1 :]))
            faces.setdefault(key, []).append((t, tet[i]))
    return faces


def is_folded(points, face, owners):
    a, b, c = points[list(face)]
    normal = np.cross(b - a, c - a)
    first, second = (normal @ (points[opposite] - a) for _, opposite in owners)
    return first * second > 0


def triangle_area(points, face):
    a, b, c = points[list(face)]
    return np.linalg.norm(np.cross(b - a, c - a)) / 2


def measure_faces(points, tets, material):
    box = Box(points[np.unique(tets)])
    faces = faces_of(tets)
    hull = [face for face, owners in faces.items() if len(owners) == 1]
    shared = {face: owners for face, owners in faces.items() if len(owners) == 2}
    interface = [face for face, ((s, _), (t, _)) in shared.items() if material[s] != material[t]]
    edges = Counter(edge for a, b, c in interface for edge in ((a, b), (b, c), (a, c)))
    open_edges = [edge for edge, count in edges.items() if count == 1]
    return {
        "hull_faces": len(hull),
        "shared_faces": len(shared),
        "crowded_faces": len(faces) - len(hull) - len(shared),
        "folded_faces": sum(is_folded(points, face, owners) for face, owners in shared.items()),
        "hull_off_box": sum(not box.holds_in_one_side(points[list(face)]) for face in hull),
        "hull_area": sum(triangle_area(points, face) for face in hull),
        "interface_faces": len(interface),
        "open_interface_edges": sum(not box.holds_in_one_side(points[list(edge)]) for edge in open_edges),
    }


def is_valid(m):
    faults = (
        "repeated_corner",
        "negative",
        "flat",
        "crowded_faces",
        "folded_faces",
        "hull_off_box",
        "open_interface_edges",
        "unused_points",
        "repeated_points",
    )
    return (
        not any(m[fault] for fault in faults)
        and np.isclose(m["volume"], m["box_volume"], rtol=1e-9, atol=0)
        and np.isclose(m["hull_area"], m["box_area"], rtol=1e-9, atol=0)
    )


def measure(points, tets, material):
    m = {**measure_points(points, tets), **measure_tets(points, tets), **measure_faces(points, tets, material)}
    if not m["flat"]:
        m.update(measure_shapes(points, tets))
    m["valid"] = bool(is_valid(m))
    return m


def agree(name, theirs, ours):
    if isinstance(theirs, float) and "dihedral" in name:
        return abs(theirs - ours) < 1e-5  # the arc cosine is blunt near 0 and 180 degrees
    if isinstance(theirs, float):
        return abs(theirs - ours) <= 1e-9 * abs(ours)
    return theirs == ours


def compare(directory):
    cases = sorted(directory.glob("*.mesh"))
    wrong = compared = 0
    for case in cases:
        ours = measure(*read_medit(case))
        theirs = json.loads(case.with_suffix(".json").read_text())
        for name in sorted(theirs.keys() & ours.keys()):
            compared += 1
            if not agree(name, theirs[name], ours[name]):
                wrong += 1
                print(f"{case.stem}: {name}: the library has {theirs[name]!r}, this script {ours[name]!r}")
    print(f"{len(cases)} meshes, {compared} numbers, {wrong} unlike")
    return wrong == 0 and len(cases) > 10 and compared > 20 * len(cases)


def main():
    with tempfile.TemporaryDirectory() as temporary:
        directory = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else temporary)
        subprocess.run([sys.argv[1], str(directory)], check=True)
        sys.exit(0 if compare(directory) else 1)


if __name__ == "__main__":
    main()
