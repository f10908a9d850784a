"""Two meshes in one page: one camera, one cut."""
import pathlib
import tempfile

from browser import run_script, skip_without_browser

skip_without_browser()

from support import balls, cleft, write_nrrd  # noqa: E402


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        volume, page = folder / "balls.nrrd", folder / "both.html"
        meshes = [folder / "coarse.vtu", folder / "fine.vtu"]
        write_nrrd(volume, (16, 16, 16), balls())
        for mesh, size in zip(meshes, (4, 2)):
            done = cleft("mesh", volume, "-o", mesh, "--size-max", size, "-q")
            assert done.returncode == 0, done.stderr
        done = cleft("view", *meshes, "-o", page, "-q")
        assert done.returncode == 0, done.stderr
        run_script("compare", page=page)


main()
