"""What write_sample wrote as bare arrays, for the scripts that compare what other programs read."""
import os
import subprocess
import sys
import tempfile

import numpy as np

INTERFACE_COLUMNS = 5  # three corners, two labels
HULL_COLUMNS = 5  # three corners, label, side
NAME = 'Right lung, "größer" & <b> \''  # of the second label
PLAIN_NAME = "Right_lung_gr_er_b"
SIDES = ["box_x_min", "box_x_max", "box_y_min", "box_y_max", "box_z_min", "box_z_max", "hull"]


class Sample:
    def __init__(self, folder):
        load = lambda name, dtype, columns: np.fromfile(os.path.join(folder, name), dtype).reshape(-1, columns)
        self.folder = folder
        self.points = load("points.f64", "<f8", 3)
        self.tets = load("tets.i32", "<i4", 4)
        self.labels = load("labels.i32", "<i4", 1)[:, 0]
        self.named = sorted(set(self.labels.tolist()))[1]
        self.interface = load("interface.i32", "<i4", INTERFACE_COLUMNS)
        self.hull = load("hull.i32", "<i4", HULL_COLUMNS)

    def path(self, name):
        return os.path.join(self.folder, name)

    def groups(self):
        """Name of each surface group -> set of its triangles (sorted corners)."""
        groups = {}
        for a, b, c, first, second in self.interface:
            groups.setdefault("interface_%s_%s" % (word(first), word(second)), set()).add(corners(a, b, c))
        for a, b, c, label, side in self.hull:
            groups.setdefault("%s_%s" % (SIDES[side], word(label)), set()).add(corners(a, b, c))
        return groups

    def materials(self):
        """Name of each material -> set of its tetrahedra (sorted corners)."""
        materials = {}
        for tet, label in zip(self.tets, self.labels):
            materials.setdefault(self.material(label), set()).add(corners(*tet))
        return materials

    def material(self, label):
        """What a label is called."""
        return "material_" + word(label) + ("_" + PLAIN_NAME if label == self.named else "")

    def check_tets(self, points, tets, labels, ordered=True):
        """The same points in every bit, the same tetrahedra with the same labels."""
        same(np.asarray(points, "<f8").tobytes(), self.points.tobytes(), "points")
        if ordered:
            same(np.asarray(tets).tolist(), self.tets.tolist(), "tetrahedra")
            same(np.asarray(labels).ravel().tolist(), self.labels.tolist(), "labels")
        rows = lambda t, l: sorted(tuple(map(int, tet)) + (int(label),) for tet, label in zip(t, l))
        same(rows(tets, np.ravel(labels)), rows(self.tets, self.labels), "tetrahedra with labels")


def word(label):
    return "minus%d" % -int(label) if label < 0 else "%d" % label


def corners(*points):
    return tuple(sorted(int(p) for p in points))


def same(got, wanted, what):
    if got != wanted:
        sys.exit("%s differ:\n%.300r\nwanted:\n%.300r" % (what, got, wanted))


def run_checks(*checks, labels=()):
    """Writes the sample by the program named on the command line, with other labels if given, and runs the checks on
    it.
    """
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.argv[1], folder, *map(str, labels)], check=True)
        sample = Sample(folder)
        for check in checks:
            check(sample)
            print("ok", check.__name__)


# The sample's own labels, those that programs like to keep for themselves, and the extremes.
LABELS = [(), (-1, 0, 1), (-2, -1, 5), (-(2**31), -1, 2**31 - 1)]


def check_surface(sample):
    """The library's interface triangles are the faces of two tetrahedra of different labels, its hull the others."""
    labels_of = {}
    for tet, label in zip(sample.tets.tolist(), sample.labels.tolist()):
        for left_out in range(4):
            labels_of.setdefault(corners(*(p for i, p in enumerate(tet) if i != left_out)), []).append(label)
    wanted = sorted(face + tuple(sorted(labels)) for face, labels in labels_of.items() if len(set(labels)) == 2)
    same(sorted(corners(*row[:3]) + tuple(row[3:]) for row in sample.interface.tolist()), wanted, "interfaces")
    wanted = sorted(face + tuple(labels) for face, labels in labels_of.items() if len(labels) == 1)
    same(sorted(corners(*row[:3]) + (row[3],) for row in sample.hull.tolist()), wanted, "hull")


def run_checks_with_all_labels(*checks):
    for labels in LABELS:
        run_checks(check_surface, *checks, labels=labels)
