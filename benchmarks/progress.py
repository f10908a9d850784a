#!/usr/bin/python3
"""How near progress is to the time that meshing takes: the greatest difference between a fraction that is reported and
the share of the time that has passed, and in which stage it occurs. Where a stage is silent, the fraction stays behind
until the next report; the greatest difference just before a report is the second figure.

    benchmarks/progress.py VOLUME... [--package build/release/bindings/python] [--background KIND...]

Meshing has the default options and one thread. Time is CPU time of this process, so that other programs matter little.
"""
import argparse
import pathlib
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
KINDS = ("particles", "octree", "lattice")


def reports_of(cleft, volume, kind):
    """(CPU seconds from the beginning, fraction, stage) of each report, and the CPU seconds of the whole call."""
    reports = []
    begin = time.process_time()

    def note(fraction, stage):
        reports.append((time.process_time() - begin, fraction, stage))

    cleft.mesh(volume, background=kind, mesher=cleft.Mesher(threads=1, progress=note))
    return reports, time.process_time() - begin


def greatest(differences):
    return "%+.2f (%s)" % max(differences, key=lambda difference: abs(difference[0]))


def measure(reports, whole):
    """Fraction less share of the time: where a report comes, and just before the next one comes."""
    ends = [now for now, _, _ in reports[1:]] + [whole]
    return "%s; before a report %s" % (
        greatest((fraction - now / whole, stage) for now, fraction, stage in reports),
        greatest((fraction - end / whole, stage) for (_, fraction, stage), end in zip(reports, ends)),
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("volumes", nargs="+")
    parser.add_argument("--package", default=ROOT / "build/release/bindings/python", help="the folder of the package")
    parser.add_argument("--background", nargs="+", choices=KINDS, default=["particles"])
    arguments = parser.parse_args()
    sys.path.insert(0, str(arguments.package))
    import cleft

    for path in arguments.volumes:
        volume = cleft.read_volume(path)
        for kind in arguments.background:
            found = measure(*reports_of(cleft, volume, kind))
            print("%s, %s: %s" % (pathlib.Path(path).name, kind, found), flush=True)


if __name__ == "__main__":
    main()
