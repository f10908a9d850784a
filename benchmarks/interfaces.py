"""Interfaces of meshes, from the PLY files that `cleft mesh` writes, and points on them."""
import numpy as np

FACE = np.dtype([("count", "u1"), ("corners", "<i4", 3), ("labels", "<i4", 2)])


def read_triangles(ply):
    """The corners of all triangles of a binary PLY file of interfaces, shaped (n, 3, 3)."""
    header, _, body = ply.read_bytes().partition(b"end_header\n")
    counts = [int(header.split(b"element %s " % kind)[1].split()[0]) for kind in (b"vertex", b"face")]
    points = np.frombuffer(body, "<f8", 3 * counts[0]).reshape(-1, 3)
    return points[np.frombuffer(body, FACE, counts[1], 24 * counts[0])["corners"]]


def samples(triangles, each=28):
    """Points that are spread evenly over each triangle, its corners among them: all of one triangle after another."""
    side = int((np.sqrt(8 * each + 1) - 3) / 2)
    weights = [(i, j, side - i - j) for i in range(side + 1) for j in range(side + 1 - i)]
    return np.einsum("wc,tcd->twd", np.array(weights) / side, triangles).reshape(-1, 3)


def areas(triangles):
    edges = triangles[:, 1:] - triangles[:, :1]
    return np.linalg.norm(np.cross(edges[:, 0], edges[:, 1]), axis=1) / 2
