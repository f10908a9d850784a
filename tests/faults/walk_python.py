"""Meshes, looks and reads and writes again and again, until nothing fails any more; reports how often it failed."""
import gc
import os

import numpy as np

import cleft

LABELS = np.zeros((5, 4, 6), np.uint8)
LABELS[1:4, 1:3, 1:4] = 7
PATH = os.path.join(os.environ["WALK_FOLDER"], "a.vtu")
CALM = 20  # runs on end that do not fail


def work(mesher):
    volume = cleft.Volume(LABELS, mesher=mesher)
    mesh = cleft.mesh(volume, mesher=mesher, background="lattice", size=2.0)
    mesh.quality(mesher=mesher), mesh.validate(mesher=mesher), mesh.report(volume, mesher=mesher)
    mesh.surface(mesher=mesher)
    cleft.write_mesh(mesh, PATH, mesher=mesher)
    return mesh.points.tobytes() + mesh.tets.tobytes() + cleft.read_mesh(PATH, mesher=mesher).points.tobytes()


failed, calm, wanted = 0, 0, None
while calm < CALM:
    try:
        got = work(cleft.Mesher())
        wanted = wanted or got
        assert got == wanted
        calm += 1
    except MemoryError:
        failed += 1
        calm = 0
    gc.collect()  # an exception and what it passed through hold each other
print(failed)
