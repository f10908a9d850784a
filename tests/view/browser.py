"""What the tests of the page share: a browser, and scripts that run in it."""
import fcntl
import json
import os
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).parent
sys.path.insert(0, str(HERE.parent / "cli"))

SKIPPED = 77


def installed():
    """A folder with what package-lock.json names. Tests that run side by side make it once."""
    folder = pathlib.Path(os.environ["NODE_FOLDER"])
    folder.mkdir(parents=True, exist_ok=True)
    lock = (HERE / "package-lock.json").read_text()
    with open(folder / "busy", "w") as busy:
        fcntl.flock(busy, fcntl.LOCK_EX)
        done = folder / "done"
        if not done.exists() or done.read_text() != lock:
            for name in ("package.json", "package-lock.json"):
                shutil.copy(HERE / name, folder)
            subprocess.run(["npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund"], cwd=folder, check=True)
            done.write_text(lock)
    return folder


def skip_without_browser():
    for program in ("chromium", "node", "npm"):
        if not shutil.which(program):
            print(f"skipped: there is no {program}")
            sys.exit(SKIPPED)


def script_command(name, **about):
    """The command that runs NAME.mjs, which gets `about` as JSON, and its environment."""
    folder = installed()
    # Modules are looked for beside a script, and what npm made is in the build folder.
    for script in HERE.glob("*.mjs"):
        shutil.copy(script, folder)
    paths = {key: str(value) if isinstance(value, pathlib.Path) else value for key, value in about.items()}
    environment = {**os.environ, "ABOUT": json.dumps(paths), "CHROMIUM": shutil.which("chromium")}
    return ["node", "--test", str(folder / f"{name}.mjs")], environment


def run_script(name, **about):
    """Runs NAME.mjs. Its exit status is that of this program."""
    command, environment = script_command(name, **about)
    sys.exit(subprocess.run(command, env=environment).returncode)
