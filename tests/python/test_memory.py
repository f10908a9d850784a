"""Memory stays flat over many objects made, used, failed and dropped."""
import gc
import unittest

import numpy as np

import cleft
from support import ball_labels


def resident_kilobytes():
    with open("/proc/self/status") as status:
        return next(int(line.split()[1]) for line in status if line.startswith("VmRSS"))


def cycle(labels):
    volume = cleft.Volume(labels)
    mesher = cleft.Mesher(progress=lambda fraction, stage: None, log=lambda level, sentence: None)
    mesh = cleft.mesh(volume, background="lattice", size=4.0, improve="off", strip=[0], mesher=mesher)
    views = mesh.points, mesh.tets, mesh.labels, mesh.surface().hull_triangles
    mesh.report(volume), mesh.quality(), cleft.Sizing.constant(volume, 2.0).values
    for wrong in ({"size": -1}, {"background": "none"}):
        try:
            cleft.mesh(volume, **wrong)
        except ValueError:
            pass
    try:
        cleft.mesh(volume, size=4.0, mesher=cleft.Mesher(progress=lambda fraction, stage: False))
    except cleft.Cancelled:
        pass
    cleft.Mesh(np.eye(4, 3), [[0, 1, 2, 3]]).close()
    return views


class Memory(unittest.TestCase):
    def test_a_thousand_cycles(self):
        labels = ball_labels(8)
        for _ in range(200):  # until allocators have what they keep
            cycle(labels)
        gc.collect()
        before = resident_kilobytes()
        for _ in range(1000):
            cycle(labels)
        gc.collect()
        self.assertLess(resident_kilobytes() - before, 2048)


if __name__ == "__main__":
    unittest.main()
