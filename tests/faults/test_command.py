"""The command while memory, calls on files, or time fail it: the outputs are all old or all new, with nothing beside
them, one sentence says why, and the exit status is a documented one.
test_command.py CLEFT PRELOAD [--all]"""
import errno
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time

CLEFT, PRELOAD = map(os.path.abspath, sys.argv[1:3])
ALL = "--all" in sys.argv
ALLOCATIONS, FILES = 1, 3
DONE, CANNOT_READ, CANNOT_WRITE, MESHING_FAILED, OUT_OF_MEMORY = 0, 3, 4, 5, 7
SOME = 20  # trials of a kind without --all
HANGS = 120  # seconds

found = []
trials = 0


def report(*words):
    found.append(words)
    print(*words, flush=True)


def voxels(n):
    values = [
        7 if (i - n / 2) ** 2 + (j - n / 2) ** 2 + (k - n / 2) ** 2 < n * n / 9 else 3 * (2 * i > n)
        for k in range(n)
        for j in range(n)
        for i in range(n)
    ]
    head = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: %d %d %d\nencoding: raw\n\n" % (n, n, n)
    return head.encode() + bytes(values)


class Job:
    """A command in a folder of its own, with old files where its outputs go."""

    def __init__(self, arguments, outputs, status_of_reading=CANNOT_READ):
        self.arguments, self.outputs, self.status_of_reading = arguments, outputs, status_of_reading
        self.folder = tempfile.TemporaryDirectory()
        with open(self.path("in.nrrd"), "wb") as file:
            file.write(voxels(4))
        self.count_file = os.path.join(self.folder.name, "..", os.path.basename(self.folder.name) + ".count")
        subprocess.run(
            [CLEFT, "mesh", "in.nrrd", "-o", "in.vtk", "--background", "lattice"],
            cwd=self.folder.name,
            check=True,
            stdout=subprocess.DEVNULL,
        )
        self.inputs = self.contents()
        self.calls(ALLOCATIONS, 0)  # makes the outputs
        self.new = self.contents()

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def contents(self):
        result = {}
        for name in os.listdir(self.folder.name):
            if os.path.isdir(self.path(name)):
                result[name] = b"a folder"
                continue
            with open(self.path(name), "rb") as file:
                # Of reports, the times differ.
                result[name] = b"report" if name.endswith(".json") and b'"program"' in file.read(50) else None
                file.seek(0)
                result[name] = result[name] or file.read()
        return result

    def plant(self):
        for name in os.listdir(self.folder.name):
            if os.path.isdir(self.path(name)):
                shutil.rmtree(self.path(name))
            elif name not in self.inputs:
                os.remove(self.path(name))
        for name in self.outputs:
            with open(self.path(name), "w") as file:
                file.write("{}" if name.endswith(".json") else "old " + name)
        self.old = self.contents()

    def run(self, kind, at, on=0, error=0):
        self.plant()
        faults = "%d %d %d %d %s" % (kind, at, on, error, self.count_file)
        environment = dict(os.environ, LD_PRELOAD=PRELOAD, CLEFT_FAULTS=faults)
        return subprocess.run(
            [CLEFT, *self.arguments],
            cwd=self.folder.name,
            env=environment,
            timeout=HANGS,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )

    def calls(self, kind, error):
        """The number of calls when none fails."""
        run = self.run(kind, 0, error=error)
        assert run.returncode == DONE, run
        with open(self.count_file) as file:
            return int(file.read())

    def check(self, name, run, wanted):
        global trials
        trials += 1
        left = self.contents()
        where = "%s: %s:" % (" ".join(self.arguments), name)
        if run.returncode != DONE and run.returncode not in wanted:
            report(where, "exit status", run.returncode, run.stderr)
        # A report of the failure stands for the old one.
        same = {name: text for name, text in left.items() if not name.endswith(".json")}
        wanted_files = self.new if run.returncode == DONE else self.old
        if same != {name: text for name, text in wanted_files.items() if not name.endswith(".json")}:
            report(
                where,
                "exit status",
                run.returncode,
                "left",
                sorted(set(left) ^ set(wanted_files)) or "other bytes",
                run.stderr,
            )
        reported = [line for line in run.stderr.splitlines() if not line.startswith("cleft: warning")]
        if run.returncode != DONE and not (reported and all(re.match(r"cleft( \w+)?: \S", line) for line in reported)):
            report(where, "said", repr(run.stderr))

    def sweep(self, kind, name, wanted, on=0, error=0):
        calls = self.calls(kind, error)
        for at in range(1, calls + 1, 1 if ALL and kind == FILES else max(1, calls // (SOME * (20 if ALL else 1)))):
            self.check("%s %d of %d" % (name, at, calls), self.run(kind, at, on, error), wanted)

    def sweep_all(self):
        for number in (errno.ENOSPC, errno.EIO, errno.EDQUOT) if ALL else (errno.ENOSPC,):
            self.sweep(FILES, errno.errorcode[number] + " of a call on a file", (CANNOT_WRITE,), error=number)
        memory = (OUT_OF_MEMORY,)
        self.sweep(ALLOCATIONS, "allocation", memory)
        self.sweep(ALLOCATIONS, "all allocations on", memory, on=1)


def test_each_call_that_fails():
    jobs = [
        Job(
            [
                "mesh",
                "in.nrrd",
                "-o",
                "a.vtu",
                "-o",
                "b.msh",
                "-o",
                "c.node",
                "--json",
                "r.json",
                "--background",
                "octree",
            ],
            ["a.vtu", "b.msh", "c.node", "c.ele", "c.face", "r.json"],
        ),
        Job(["mesh", "in.nrrd", "-o", "a.mesh"], ["a.mesh"]),
        Job(["sizing", "in.nrrd", "-o", "s.nii.gz", "--json", "r.json"], ["s.nii.gz", "r.json"]),
        Job(["convert", "in.vtk", "s.stl"], ["s.stl"]),
        Job(["info", "in.nrrd", "--json", "r.json"], ["r.json"]),
        Job(["check", "in.vtk"], []),
    ]
    for job in jobs:
        job.sweep_all()


def test_limits_of_memory():
    """No end by a signal, whatever the limit; with enough of it, the mesh."""
    for background in "particles", "octree", "lattice":
        job = Job(["mesh", "in.nrrd", "-o", "a.vtu", "--background", background, "--threads", "2"], ["a.vtu"])
        with open(job.path("in.nrrd"), "wb") as file:
            file.write(voxels(24))
        job.inputs = job.contents()
        job.calls(ALLOCATIONS, 0)
        job.new = job.contents()
        need = least_limit(job)
        step = 256 << 10 if ALL else 4 << 20
        limits = range(need // 2, need + (8 << 20), step)
        for limit in limits:
            job.plant()
            if loads(limit):
                job.check("at most %d KB" % (limit >> 10), limited(job, limit), (OUT_OF_MEMORY,))


def limited(job, limit):
    return subprocess.run(
        [CLEFT, *job.arguments],
        cwd=job.folder.name,
        timeout=HANGS,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)),
    )


def loads(limit):
    """Whether the libraries can be loaded, and their variables made: what comes before main() is not the command's."""
    run = subprocess.run(
        [CLEFT, "--version"],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)),
    )
    return run.returncode in (DONE, OUT_OF_MEMORY)


def least_limit(job):
    low, high = 1 << 20, 1 << 32
    while high - low > 1 << 20:
        middle = (low + high) // 2
        job.plant()
        low, high = (low, middle) if limited(job, middle).returncode == DONE else (middle, high)
    return high


def test_signals():
    """Killed, the old output or the new one is there whole, and the next run works. Asked to end, it leaves nothing."""
    generator = random.Random(4)
    job = Job(["mesh", "in.nrrd", "-o", "a.vtu", "-o", "b.msh", "--json", "r.json"], ["a.vtu", "b.msh", "r.json"])
    start = time.monotonic()
    job.calls(ALLOCATIONS, 0)
    takes = time.monotonic() - start
    for number in signal.SIGKILL, signal.SIGTERM, signal.SIGINT, signal.SIGHUP:
        for _ in range(200 if ALL else 10):
            job.plant()
            process = subprocess.Popen(
                [CLEFT, *job.arguments],
                cwd=job.folder.name,
                stdout=subprocess.DEVNULL,
                stderr=subprocess.PIPE,
                text=True,
            )
            time.sleep(generator.uniform(0, takes))
            process.send_signal(number)
            process.stderr.read()
            process.stderr.close()
            process.wait(HANGS)
            check_signal(job, number, process.returncode)
    if job.run(ALLOCATIONS, 0).returncode != DONE:
        report("after signals, the next run fails")


def check_signal(job, number, status):
    global trials
    trials += 1
    left = job.contents()
    for name in job.outputs:
        if left.get(name) not in (job.old[name], job.new[name]):
            report("signal", number, name, "is neither old nor new")
    beside = [name for name in left if name not in job.old]
    if number == signal.SIGKILL:
        beside = [name for name in beside if not name.startswith(".cleft-")]
    if beside:
        report("signal", number, "left", beside, "exit status", status)
    if status not in (DONE, -number) and (number == signal.SIGKILL or status != 128 + number):
        report("signal", number, "exit status", status)


if __name__ == "__main__":
    wanted = [word for word in sys.argv[3:] if not word.startswith("-")]
    for name, test in list(globals().items()):
        if name.startswith("test_") and (not wanted or any(word in name for word in wanted)):
            trials, before = 0, len(found)
            start = time.monotonic()
            test()
            print(
                "%-28s %6d trials, %d faults, %.0f s" % (name, trials, len(found) - before, time.monotonic() - start),
                flush=True,
            )
    sys.exit(1 if found else 0)
