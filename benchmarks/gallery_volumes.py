"""The volumes of docs/gallery.md that are generated, and those of the metrics in docs/guide.md: numpy alone, and the
same voxels in every run."""
import numpy as np

import volumes


def to_segment(x, start, end):
    """Distance of points from the segment between two points."""
    along = end - start
    share = np.clip((x - start) @ along / (along @ along), 0, 1)
    return np.linalg.norm(x - start - share[..., None] * along, axis=-1)


def around(start, end, radius):
    """The voxels around a segment, as slices along z, y, x."""
    low = np.floor(np.minimum(start, end) - radius).astype(int).clip(0)
    high = np.ceil(np.maximum(start, end) + radius).astype(int).clip(0)
    return tuple(slice(low[axis], high[axis]) for axis in (2, 1, 0))


def grown_tree(root, goals, is_free, bend=0.4):
    """Points, the parent of each, and their order. The next of the branches that are free has the least length, with a
    share of the way from the root (Cuntz and others, 2010)."""
    points = np.vstack([root, goals])
    parents, ways, order = np.full(len(points), -1), np.zeros(len(points)), [0]
    costs = np.full((len(points), len(points)), np.inf)  # of a branch to a point from one that is reached
    costs[:, 0] = np.linalg.norm(points - points[0], axis=1)
    costs[0] = np.inf
    while np.isfinite(costs).any():
        child, parent = np.unravel_index(np.argmin(costs), costs.shape)
        if not is_free(points[parent], points[child]):
            costs[child, parent] = np.inf
            continue
        length = np.linalg.norm(points[child] - points[parent])
        parents[child], ways[child] = parent, ways[parent] + length
        costs[child] = np.inf
        order.append(child)
        costs[:, child] = np.linalg.norm(points - points[child], axis=1) + bend * ways[child]
        costs[order, child] = np.inf
    return points, parents, order


def vessels(x, root, goals, thinnest, taken):
    """The voxels of a tree of vessels, which keeps off `taken` voxels. The radius of a vessel grows with the cube root
    of the ends that it supplies."""

    def is_free(start, end):
        near = around(start, end, 4)
        return not (taken[near] & (to_segment(x[near], start, end) < 4)).any()

    points, parents, order = grown_tree(np.array(root, float), goals, is_free)
    ends, tree = np.zeros(len(points)), np.zeros(x.shape[:-1], bool)
    for point in reversed(order[1:]):
        ends[point] = max(ends[point], 1)
        ends[parents[point]] += ends[point]
        start, end = points[parents[point]], points[point]
        radius = thinnest * ends[point] ** (1 / 3)
        near = around(start, end, radius + 1)
        tree[near] |= to_segment(x[near], start, end) < radius
    return tree


def organ():
    """An organ (1) with two trees of vessels (2, 3) and a tumour (4). Voxels of 1.5 mm."""
    x = volumes.centres((80, 96, 112))
    balls = (((44, 48, 42), (36, 38, 32)), ((74, 44, 46), (32, 28, 22)), ((36, 52, 34), (28, 34, 26)))
    # A smooth union of ellipsoids; the vessels keep off its surface.
    shares = [1 / (((x - middle) / radii) ** 2).sum(-1) ** 3 for middle, radii in balls]
    depth = np.sum(shares, axis=0)
    tumour = np.linalg.norm(x - (26, 34, 46), axis=-1) < 8
    labels = (depth > 1).astype(np.uint8)
    goals = np.argwhere((depth > 1.6)[::10, ::10, ::10])[:, ::-1] * 10.0 + 5
    random = np.random.RandomState(4)
    goals += random.rand(*goals.shape) * 8 - 4
    random.shuffle(goals)
    half = len(goals) // 2
    portal = vessels(x, (50, 38, 12), goals[:half], 1.1, tumour)
    veins = vessels(x, (46, 84, 60), goals[half:], 1.1, tumour | portal)
    labels[portal & (labels == 1)] = 2
    labels[veins & (labels == 1)] = 3
    labels[tumour] = 4
    return labels, (1.5, 1.5, 1.5)


def grains(n=64, count=56):
    """Grains that fill a cube: cells of distances from seeds, each seed the farthest of some candidates."""
    random = np.random.RandomState(5)
    seeds = [random.rand(3) * n]
    while len(seeds) < count:
        candidates = random.rand(6, 3) * n
        away = np.linalg.norm(candidates[:, None] - np.array(seeds)[None], axis=-1).min(1)
        seeds.append(candidates[np.argmax(away)])
    x = volumes.centres((n, n, n))
    return np.argmin([((x - seed) ** 2).sum(-1) for seed in seeds], axis=0).astype(np.uint8) + 1, (1, 1, 1)


def geology():
    """Folded layers in two blocks along a fault: 1 to 6 in the block that stays, 11 to 16 in the one that slid down. A
    dome of salt (8) pierces the latter. Voxels of 25 x 25 x 10 m."""
    x = volumes.centres((92, 80, 112), (25, 25, 10))
    east, north, height = x[..., 0], x[..., 1], x[..., 2]
    slid = east > 1150 + 0.8 * (360 - height) + 70 * np.sin(north / 450)
    fold = 50 * np.sin(east / 420) + 35 * np.cos(north / 380 + east / 900)
    level = height - fold + np.where(slid, 110, 0)
    labels = 1 + np.digitize(level, (170, 300, 430, 560, 700)) + np.where(slid, 10, 0)
    away = np.hypot(east - 2050, north - 800)
    dome = slid & (height < 830 - 300 * (away / 330) ** 2 - 200 * (away / 420) ** 6)
    labels[dome] = 8
    return labels.astype(np.uint8), (25, 25, 10)


def weave(period=44):
    """Four warps (1 to 4) and four wefts (5 to 8) of a plain weave in resin (0). Voxels of 0.05 mm."""
    n, middle = 2 * period, 14
    x = volumes.centres((2 * middle, n, n))
    labels = np.zeros(x.shape[:-1], np.uint8)
    pitch = period / 2
    for number in range(4):
        for label, along, across in ((1 + number, 0, 1), (5 + number, 1, 0)):
            sign = (1 if number % 2 else -1) * (1 if along == 0 else -1)
            height = middle + sign * 5.8 * np.sin(np.pi * (x[..., along] / pitch))
            from_axis = (x[..., across] - pitch * (number + 0.5)) / (0.42 * pitch)
            labels[from_axis**2 + ((x[..., 2] - height) / 4.2) ** 2 < 1] = label
    return labels, (0.05, 0.05, 0.05)


def sheets(n=60):
    """Two parallel sheets that are two voxels thick (1, 2), and one that crosses them (3)."""
    labels = np.zeros((n, n, n), np.uint8)
    labels[18:20] = 1
    labels[38:40] = 2
    labels[:, :, 30:32] = 3
    return labels, (1, 1, 1)


def fibres(length=96, width=36):
    """Seven fibres in a bundle that bends and twists (1), in a matrix (0). Voxels of 0.01 mm."""
    x = volumes.centres((width, width, length))
    along = x[..., 0] / length
    across, up = x[..., 1] - width / 2, x[..., 2] - width / 2 + 3 * np.sin(np.pi * along)
    turned = np.stack([np.cos(along) * across - np.sin(along) * up, np.sin(along) * across + np.cos(along) * up], -1)
    angles = np.arange(6) * np.pi / 3
    middles = [(0, 0), *zip(9 * np.cos(angles), 9 * np.sin(angles))]
    labels = np.any([np.linalg.norm(turned - middle, axis=-1) < 2.8 for middle in middles], axis=0)
    return labels.astype(np.uint8), (0.01, 0.01, 0.01)


def scan():
    """A head in slices of 6 mm: skull (1), brain (2), ventricles (3) and a tumour (4). Voxels of 1.5 mm in a slice."""
    spacing = (1.5, 1.5, 6)
    x = volumes.centres((26, 112, 92), spacing) - (69, 84, 78)
    labels = np.zeros(x.shape[:-1], np.uint8)
    for label, middle, radii in (
        (1, (0, 0, 0), (63, 78, 70)),
        (2, (0, 0, 0), (53, 68, 60)),
        (3, (-11, 0, 8), (7, 26, 13)),
        (3, (11, 0, 8), (7, 26, 13)),
        (4, (31, -28, 12), (12, 14, 15)),
    ):
        labels[(((x - middle) / radii) ** 2).sum(-1) < 1] = label
    return labels, spacing


# Distances of spheres, one file for each material, as volumes.sphere_distances makes them.
SPHERES = {"equal": volumes.KISSING, "unequal": volumes.UNEQUAL}
LABELS = {"organ": organ, "grains": grains, "geology": geology, "weave": weave}
# Those of the guide.
LABELS |= {"sheets": sheets, "fibres": fibres, "scan": scan}


def write(folder, names=None):
    """Writes the generated volumes, or those named, into a folder."""
    for name, make in LABELS.items():
        if names is None or name in names:
            volumes.write_nrrd(folder / (name + ".nrrd"), *make())
    for name, spheres in SPHERES.items():
        if names is None or name in names:
            for number, field in enumerate(volumes.sphere_distances((64, 64, 64), spheres)):
                volumes.write_nrrd(folder / ("%s%d.nrrd" % (name, number)), field, (1, 1, 1))
