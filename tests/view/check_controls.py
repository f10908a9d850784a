"""The mouse, fingers, keys and buttons of the page."""
import pathlib
import tempfile

from browser import run_script, skip_without_browser

skip_without_browser()

from support import balls, cleft, write_nrrd  # noqa: E402


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        volume, page = folder / "balls.nrrd", folder / "balls.html"
        write_nrrd(volume, (16, 16, 16), balls())
        done = cleft("mesh", volume, "--view", page, "-q")
        assert done.returncode == 0, done.stderr
        run_script("controls", page=page)


main()
