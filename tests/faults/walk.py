"""Runs a program in another language while each allocation of Cleft fails in turn. It must end in the exception for
want of memory, or in the same mesh, each time, and lose nothing. walk.py LANGUAGE BUILD_FOLDER PRELOAD [--all]"""
import glob
import os
import re
import subprocess
import sys
import tempfile

LANGUAGE, BUILD, PRELOAD = sys.argv[1:4]
# In C#, one allocation among 3500 came out of the wrong call. Mono takes some seconds for all of them.
STEP = 1 if "--all" in sys.argv or LANGUAGE == "csharp" else 61
HERE = os.path.dirname(os.path.abspath(__file__))


def command():
    if LANGUAGE == "python":
        return ["/usr/bin/python3", "-B", os.path.join(HERE, "walk_python.py")]
    if LANGUAGE == "java":
        jars = glob.glob(os.path.join(BUILD, "bindings", "java", "cleft-*.jar"))
        return ["java", "-XX:TieredStopAtLevel=1", "-cp", jars[0], os.path.join(HERE, "Walk.java")]
    run = os.path.join(BUILD, "tests", "csharp", "run")
    return ["mono", os.path.join(run, "Tests.exe"), "WalkTest"]


with tempfile.TemporaryDirectory() as folder:
    count = os.path.join(folder, "count")
    environment = dict(
        os.environ,
        LD_PRELOAD=PRELOAD,
        CLEFT_FAULTS_WALK="%d %s" % (STEP, count),
        WALK_FOLDER=folder,
        PYTHONPATH=os.path.join(BUILD, "bindings", "python"),
    )
    run = subprocess.run(command(), env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    print(run.stdout)
    with open(count) as file:
        contexts, lost = map(int, file.read().split())
    print("%d contexts, %d blocks lost" % (contexts, lost))
    # The program reports how many of its runs failed.
    reported = re.findall(r"^(?:failed )?(\d+)$", run.stdout, re.MULTILINE)
    failed = int(reported[-1]) if reported else 0
    sys.exit(not (run.returncode == 0 and lost == 0 and failed > 10 and contexts > failed))
