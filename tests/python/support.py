"""What the tests of the Python package share: a small volume, quick to mesh."""
import numpy as np

import cleft

QUICK = {"background": "lattice", "size": 3.0}


def ball_labels(n=12, kind=np.uint8):
    """labels[i, j, k]: 1 in a ball off the middle, 7 in a slab at high i, else 0; no symmetry between the axes."""
    i, j, k = np.ogrid[:n, : n + 1, : n + 2]
    labels = np.zeros((n, n + 1, n + 2), kind)
    labels[(i - 0.4 * n) ** 2 + (j - 0.5 * n) ** 2 + (k - 0.6 * n) ** 2 < (0.3 * n) ** 2] = 1
    labels[n - 3 :] = 7
    return labels


def ball_volume(n=12, **keywords):
    return cleft.Volume(ball_labels(n), **keywords)


def ball_mesh(n=12, **keywords):
    return cleft.mesh(ball_volume(n), **{**QUICK, **keywords})


def same_mesh(a, b):
    return np.array_equal(a.points, b.points) and np.array_equal(a.tets, b.tets) and np.array_equal(a.labels, b.labels)
