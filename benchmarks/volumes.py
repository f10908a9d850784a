"""Volumes to measure on: those of the repository, generated ones, and whatever else is at hand."""
import pathlib
import re
import zlib

import numpy as np

DATA = pathlib.Path(__file__).resolve().parent.parent / "tests" / "data"
ATLASES = pathlib.Path("/usr/share/mricron/templates")  # Debian's mricron-data


def centres(shape, spacing=(1, 1, 1)):
    """Voxel centres, indexed [k][j][i], coordinates x, y, z last."""
    k, j, i = np.indices(shape) + 0.5
    return np.stack([i, j, k], -1) * np.asarray(spacing)


def sphere_distances(shape, spheres, spacing=(1, 1, 1)):
    """Signed distances, positive inside, to each sphere (centre, radius), and to what is outside of all."""
    x = centres(shape, spacing)
    inside = [radius - np.linalg.norm(x - centre, axis=-1) for centre, radius in spheres]
    return [-np.max(inside, axis=0)] + inside


def largest(fields):
    return np.argmax(fields, axis=0).astype(np.uint8)


KISSING = [((32, 32, 18), 14), ((32, 32, 46), 14)]
UNEQUAL = [((32, 32, 20), 16), ((32, 32, 44), 8)]


def torus(shape=(48, 48, 48), spacing=(1, 1, 1)):
    x = centres(shape, spacing) - 24
    across = np.hypot(x[..., 0], x[..., 1]) - 13
    return (np.hypot(across, x[..., 2]) < 5).astype(np.uint8)


def voronoi_grains(n=64, grains=37):
    x = np.arange(n) + 0.5
    nearest = np.zeros((n, n, n), np.uint8)
    least = np.full((n, n, n), np.inf)
    for grain, seed in enumerate(np.random.RandomState(1).rand(grains, 3) * n):
        along_x, along_y, along_z = [(x - coordinate) ** 2 for coordinate in seed]
        squared = along_x + along_y[:, None] + along_z[:, None, None]
        nearest[squared < least] = grain
        np.minimum(least, squared, out=least)
    return nearest


def noise(n=24, labels=5):
    return np.random.RandomState(1).randint(0, labels, (n, n, n)).astype(np.uint8)


def checkerboard(n=20):
    return (np.indices((n, n, n)).sum(0) % 2).astype(np.uint8)


def sheets(n=20):
    v = np.zeros((n, n, n), np.uint8)
    v[n // 2] = 1
    v[:, n // 4, :] = 2
    return v


def rods(n=20):
    v = np.zeros((n, n, n), np.uint8)
    v[n // 2, n // 2, :] = 1
    v[n // 5, :, 3 * n // 4] = 2
    return v


def single_voxel(n=9):
    v = np.zeros((n, n, n), np.uint8)
    v[n // 2, n // 2, n // 2] = 1
    return v


# name: (labels or fields, spacing, spheres whose distance is known)
def generated():
    return {
        "kissing spheres, labels": (largest(sphere_distances((64, 64, 64), KISSING)), (1, 1, 1), KISSING),
        "kissing spheres, distances": (sphere_distances((64, 64, 64), KISSING), (1, 1, 1), KISSING),
        "unequal spheres, distances": (sphere_distances((64, 64, 64), UNEQUAL), (1, 1, 1), UNEQUAL),
        "torus": (torus(), (1, 1, 1), None),
        "torus, 0.5 x 0.5 x 3": (torus((16, 96, 96), (0.5, 0.5, 3)), (0.5, 0.5, 3), None),
        "Voronoi grains": (voronoi_grains(), (1, 1, 1), None),
        "noise, 5 labels": (noise(), (1, 1, 1), None),
        "checkerboard": (checkerboard(), (1, 1, 1), None),
        "one-voxel sheets": (sheets(), (1, 1, 1), None),
        "one-voxel rods": (rods(), (1, 1, 1), None),
        "single voxel": (single_voxel(), (1, 1, 1), None),
        "single label": (np.full((8, 7, 6), 3, np.uint8), (1, 1, 1), None),
    }


def write_nrrd(path, values, spacing):
    kind = {"uint8": "uint8", "float64": "double"}[values.dtype.name]
    sizes = " ".join(map(str, values.shape[::-1]))
    directions = " ".join("(%s)" % ",".join(str(spacing[a] if a == b else 0) for b in range(3)) for a in range(3))
    # The box begins at 0: the first voxel's centre is half a spacing from it.
    origin = ",".join(str(s / 2) for s in spacing)
    header = (
        "NRRD0004\ntype: %s\ndimension: 3\nspace: left-posterior-superior\nsizes: %s\nspace directions: %s\n"
        "kinds: domain domain domain\nendian: little\nencoding: raw\nspace origin: (%s)\n\n"
        % (kind, sizes, directions, origin)
    )
    path.write_bytes(header.encode() + np.ascontiguousarray(values).tobytes())


def write_generated(folder):
    """Writes the generated volumes; answers {name: (files, spheres)}."""
    written = {}
    for number, (name, (values, spacing, spheres)) in enumerate(generated().items()):
        fields = values if isinstance(values, list) else [values]
        files = []
        for index, field in enumerate(fields):
            files.append(folder / ("%d_%d.nrrd" % (number, index)))
            write_nrrd(files[-1], field, spacing)
        written[name] = (files, spheres)
    return written


def kept():
    """Volumes in the repository, and the atlases of mricron-data if it is installed, as write_generated answers."""
    found = {
        "mickey": ([DATA / "mickey.nrrd"], None),
        "CIT168": ([DATA / "CIT168.nrrd"], None),
        "four indicators": ([DATA / ("spheres%d.nrrd" % i) for i in range(1, 5)], None),
    }
    for name, file in (("AAL", "aal.nii.gz"), ("JHU, 1 mm", "JHU-WhiteMatter-labels-1mm.nii.gz")):
        if (ATLASES / file).exists():
            found[name] = ([ATLASES / file], None)
    return found


def read_nrrd(path):
    head, _, data = path.read_bytes().partition(b"\n\n")
    fields = dict(line.split(": ", 1) for line in head.decode().splitlines()[1:] if ": " in line)
    if fields["encoding"] in ("gzip", "gz"):
        data = zlib.decompress(data, zlib.MAX_WBITS | 32)  # whatever head it has
    elif fields["encoding"] != "raw":
        raise ValueError("the encoding %s is not read here" % fields["encoding"])
    words = {"unsigned char": "u1", "uint8": "u1", "short": "i2", "uint16": "u2", "unsigned short": "u2"}
    word = np.dtype(words[fields["type"]]).newbyteorder("<" if fields.get("endian", "little") == "little" else ">")
    sizes = [int(size) for size in fields["sizes"].split()]
    directions = re.findall(r"\(([^)]*)\)", fields["space directions"])
    spacing = [np.linalg.norm([float(number) for number in axis.split(",")]) for axis in directions]
    return np.frombuffer(data, word, int(np.prod(sizes))).reshape(sizes[::-1]), spacing


def read_labels(path):
    """Labels, indexed [k][j][i], and the spacing of a file of NRRD or NIfTI."""
    path = pathlib.Path(path)
    if path.suffix == ".nrrd":
        return read_nrrd(path)
    import nibabel

    image = nibabel.load(path)
    return np.asarray(image.dataobj).T, [float(length) for length in image.header.get_zooms()[:3]]


def more(folder):
    """Every volume in a folder of the user's."""
    kinds = (".nrrd", ".nii", ".nii.gz", ".tif", ".tiff", ".mha")
    return {path.name: ([path], None) for path in sorted(pathlib.Path(folder).iterdir()) if path.name.endswith(kinds)}
