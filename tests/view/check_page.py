"""One mesh in the page: what is drawn, and everything that the panel tells and can do."""
import json
import pathlib
import tempfile

from browser import run_script, skip_without_browser

skip_without_browser()

from support import balls, cleft, write_nrrd  # noqa: E402


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        volume, mesh, page, report = (folder / f"balls{end}" for end in (".nrrd", ".vtu", ".html", ".json"))
        write_nrrd(volume, (16, 16, 16), balls())
        part, small, small_page = (folder / name for name in ("part.html", "small.vtu", "small.html"))
        for arguments in (
            ("mesh", volume, "-o", mesh, "--json", report),
            ("view", mesh, "-o", page, "--report", report),
            ("view", mesh, "-o", part, "--max-shown", 500),
            ("mesh", volume, "--scale", "1e-9", "-o", small),
            ("view", small, "-o", small_page),
        ):
            done = cleft(*arguments, "-q")
            assert done.returncode == 0, done.stderr
        run_script("page", page=page, part=part, small=small_page, report=json.loads(report.read_text()))


main()
