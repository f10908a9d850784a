"""Runs `faults` with files to read in a folder of its own: run_faults.py FAULTS [ARGUMENT...]."""
import os
import subprocess
import sys
import tempfile

with tempfile.TemporaryDirectory() as folder:
    make_files = os.path.join(os.path.dirname(os.path.abspath(__file__)), "make_files.py")
    subprocess.run([sys.executable, "-B", make_files, folder], check=True)
    sys.exit(subprocess.run([sys.argv[1], "--files", folder, *sys.argv[2:]]).returncode)
