"""What the scripts that test the reading of volumes share: they run dump_volume, the path of which is their argument.
"""
import os
import subprocess
import sys
import tempfile

import numpy as np

LPS, RAS = 0, 1
AUTO, LABELS, INDICATORS = 0, 1, 2
FLIP = np.diag([-1.0, -1.0, 1.0])  # between LPS and RAS
FORMAT, ARGUMENT, FILE, NOT_FINITE = -14, -5, -13, -6

DUMP = sys.argv[1]
FOLDER = tempfile.mkdtemp()


def path(name):
    return os.path.join(FOLDER, name)


def write(name, *parts):
    """A file of these parts, which are bytes or text."""
    with open(path(name), "wb") as file:
        for part in parts:
            file.write(part.encode() if isinstance(part, str) else part)
    return path(name)


def run_dump(paths, world=LPS, kind=AUTO, spacing=(0, 0, 0), silent=True):
    out = path("out.bin")
    run = subprocess.run(
        [DUMP, str(world), str(kind), *map(str, spacing), out, *paths],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert run.stderr == "" or not silent, "the library printed: " + run.stderr
    assert run.returncode in (0, 1), "crashed: %d" % run.returncode
    return run, out


def read(*paths, **options):
    """dims, affine (3 x 4), labels, the label at each voxel centre as [i, j, k]."""
    run, out = run_dump(paths, **options)
    assert run.returncode == 0, run.stdout
    data = open(out, "rb").read()
    dims = np.frombuffer(data, "<i8", 3)
    affine = np.frombuffer(data, "<f8", 12, 24).reshape(3, 4)
    count = np.frombuffer(data, "<i8", 1, 120)[0]
    labels = np.frombuffer(data, "<i4", count, 128)
    centres = np.frombuffer(data, "<i4", -1, 128 + 4 * count).reshape(dims, order="F")
    return dims, affine, labels, centres


def refused(status, words, *paths, named=True, **options):
    """The reading fails with the status and a sentence that names the last file and has the words."""
    run, _ = run_dump(paths, **options)
    assert run.returncode == 1, "not refused: %r" % (paths,)
    number, sentence = run.stdout.strip().splitlines()[-1].split(" ", 1)
    assert int(number) == status and words in sentence, run.stdout
    assert not named or os.path.basename(paths[-1]) in sentence, run.stdout


def check(voxels, affine, *paths, **options):
    dims, got, labels, centres = read(*paths, **options)
    assert tuple(dims) == voxels.shape, dims
    assert np.abs(got - affine).max() < 1e-5 * max(1, np.abs(affine).max()), (got, affine)
    assert labels.tolist() == np.unique(voxels).tolist(), labels
    assert (centres == voxels).all()


def random_labels(shape, dtype, values, seed=0):
    return np.random.default_rng(seed).choice(np.array(values), shape).astype(dtype)


def warned(words, *paths, **options):
    """The reading reports something that has the words."""
    run, _ = run_dump(paths, **options)
    reported = [line for line in run.stdout.splitlines() if line.startswith("warning: ")]
    assert any(words in line for line in reported), run.stdout


def reads_quietly(*paths, **options):
    """The reading succeeds, and reports nothing."""
    run, _ = run_dump(paths, **options)
    reported = [line for line in run.stdout.splitlines() if not line.startswith("name: ")]
    assert run.returncode == 0 and reported == [], run.stdout


def run_tests(names):
    for name, test in list(names.items()):
        if name.startswith("test_"):
            test()
            print("ok", name)
