"""What the tests of the command share: running it, and volumes to run it on."""
import array
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

CLEFT = os.environ["CLEFT"]
DATA = pathlib.Path(os.environ["TEST_DATA"])

OK, CHECK_FAILED, USAGE, CANNOT_READ, CANNOT_WRITE, MESHING_FAILED, LABEL_LOST, OUT_OF_MEMORY = range(8)
INTERRUPTED = 130
HANGS = 300  # seconds after which a run is taken to hang


def cleft(*arguments, **keywords):
    """Runs the command and answers a CompletedProcess with texts."""
    done = subprocess.run([CLEFT, *map(str, arguments)], capture_output=True, text=True, timeout=HANGS, **keywords)
    # A run that takes long says so, on a slow machine any. Tests may not depend on it.
    if "--progress" not in arguments:
        done.stderr = re.sub(r"^cleft: \d+ % after .*\n", "", done.stderr, flags=re.MULTILINE)
    return done


def read_terminal(terminal):
    """All that comes from a terminal until the last program has left it."""
    text = b""
    try:
        while piece := os.read(terminal, 1 << 16):
            text += piece
    except OSError:  # that is how Linux tells the end
        pass
    os.close(terminal)
    return text.decode()


def write_nrrd(path, dims, labels, kind="uint8", spacing=(1, 1, 1), origin=(0, 0, 0)):
    """Writes a volume, x fastest, as an uncompressed NRRD."""
    code = {"uint8": "B", "int16": "h", "int32": "i", "float": "f", "double": "d"}[kind]
    directions = " ".join("(%s)" % ",".join(str(spacing[a] if a == b else 0) for b in range(3)) for a in range(3))
    header = (
        "NRRD0004\ntype: %s\ndimension: 3\nspace: left-posterior-superior\nsizes: %s\n"
        "space directions: %s\nkinds: domain domain domain\nendian: little\nencoding: raw\n"
        "space origin: (%s)\n\n" % (kind, " ".join(map(str, dims)), directions, ",".join(map(str, origin)))
    )
    with open(path, "wb") as file:
        file.write(header.encode())
        file.write(array.array(code, labels).tobytes())


def balls(n=16):
    """Two touching balls of labels 3 and 7 in label 0."""

    def label(x, y, z):
        def inside(cx):
            return (x - cx) ** 2 + (y - n / 2) ** 2 + (z - n / 2) ** 2 < (0.22 * n) ** 2

        return 3 if inside(0.28 * n) else 7 if inside(0.72 * n) else 0

    return [label(x + 0.5, y + 0.5, z + 0.5) for z in range(n) for y in range(n) for x in range(n)]


class CommandTest(unittest.TestCase):
    """A test with a folder of its own and a small volume in it."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.volume = self.folder / "balls.nrrd"
        write_nrrd(self.volume, (16, 16, 16), balls())

    def path(self, name):
        return self.folder / name

    def run_ok(self, *arguments, **keywords):
        done = cleft(*arguments, **keywords)
        self.assertEqual(done.returncode, OK, done.stderr)
        return done

    def mesh(self, *arguments, output="out.vtu"):
        """Meshes, checks the mesh with `cleft check`, and answers the report."""
        self.run_ok("mesh", *arguments, "-o", self.path(output), "--json", self.path("report.json"), "--quiet")
        self.assertEqual(cleft("check", self.path(output)).returncode, OK)
        return json.loads(self.path("report.json").read_text())

    def assert_fails(self, exit_code, done, *words):
        self.assertEqual(done.returncode, exit_code, done.stdout + done.stderr)
        for word in words:
            self.assertIn(str(word), done.stderr)
