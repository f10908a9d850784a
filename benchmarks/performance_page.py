"""The tables of docs/performance.md, from the figures of performance.py."""
import math
import statistics
import textwrap

import performance_plots
import programs
import quality
import speed

PROGRAMS = programs.MESHERS
BACKGROUNDS = PROGRAMS[:3]
LEAST_SECONDS = 0.05  # of a stage whose ratios are told: noise is a large part of less


def table(columns, rows):
    return quality.line(columns) + quality.line(["---"] * len(columns)) + "".join(map(quality.line, rows))


def key(program, threads):
    return "%s, %d" % (program, threads)


def cost(run):
    """CPU seconds of a tetrahedron."""
    return run["cpu_seconds"] / run["tets"]


def memory(run):
    """Bytes of a tetrahedron."""
    return run["peak_bytes"] / run["tets"]


def times(number):
    return "%.2f" % number


def megabytes(number):
    return "%.0f" % (number / 1e6)


def side_by_side(volume, threads):
    """One row for each program and number of threads. All ratios are to `particles` on one thread."""
    runs = volume["runs"]
    first = runs[key("particles", 1)]
    for program in PROGRAMS:
        for count in sorted({1, threads}):
            run = runs.get(key(program, count))
            if run:
                yield [
                    volume["name"],
                    program,
                    str(count),
                    times(cost(run) / cost(first)),
                    times((run["seconds"] / run["tets"]) / (first["seconds"] / first["tets"])),
                    times(speed_up(runs, program, count)),
                    times(memory(run) / memory(first)),
                    "%.1f" % run["min_dihedral"],
                    "{:,}".format(run["tets"]),
                    "%.1f" % run["seconds"],
                    "%.1f" % run["cpu_seconds"],
                    megabytes(run["peak_bytes"]),
                ]


def programs_table(data):
    columns = (
        "volume",
        "program",
        "threads",
        "CPU time a tetrahedron",
        "time a tetrahedron",
        "speed-up",
        "memory a tetrahedron",
        "least angle",
        "tetrahedra",
        "seconds",
        "CPU s",
        "peak, MB",
    )
    return table(columns, (row for volume in data["volumes"] for row in side_by_side(volume, data["threads"])))


def delaunay_of(run):
    return run["stages"]["background.delaunay"]


def delaunay_table(data):
    columns = ("volume", "points", "CPU time", "time on all threads", "CPU s", "TetGen's CPU s")
    rows = []
    for volume in data["volumes"]:
        runs = volume["runs"]
        own, parallel = (delaunay_of(runs[key("particles", count)]) for count in (1, data["threads"]))
        tetgen = delaunay_of(runs["particles, TetGen, 1"])
        rows.append(
            [
                volume["name"],
                "{:,}".format(int(runs[key("particles", 1)]["points"])),
                times(own["cpu_seconds"] / tetgen["cpu_seconds"]),
                times(parallel["seconds"] / tetgen["seconds"]),
                times(own["cpu_seconds"]),
                times(tetgen["cpu_seconds"]),
            ]
        )
    return table(columns, rows)


def stage_row(names, one, many, tetgen):
    """Times of a stage on one thread and on many."""
    is_timed = one["seconds"] > LEAST_SECONDS
    return [
        *names,
        times(one["cpu_seconds"] / tetgen),
        times(one["seconds"] / many["seconds"]) if is_timed else "",
        "%.0f %%" % (100 * one["serial_seconds"] / one["cpu_seconds"]) if is_timed else "",
        times(one["cpu_seconds"]),
        times(one["seconds"]),
        times(many["seconds"]),
        megabytes(one["peak_bytes"]),
    ]


def stages_of(run):
    """The stages of one background: its own steps where it has some."""
    return speed.without_parents(list(run["stages"]))


def stages_table(data):
    """Of the largest volume."""
    columns = (
        "background",
        "stage",
        "of TetGen's Delaunay",
        "speed-up",
        "serial share",
        "CPU s",
        "seconds",
        "seconds, all threads",
        "peak so far, MB",
    )
    runs = data["volumes"][-1]["runs"]
    tetgen = delaunay_of(runs["particles, TetGen, 1"])["cpu_seconds"]
    rows = []
    for background in BACKGROUNDS:
        one, many = (runs[key(background, count)] for count in (1, data["threads"]))
        for stage in stages_of(one):
            rows.append(stage_row((background, stage), one["stages"][stage], many["stages"][stage], tetgen))
        rows.append(stage_row((background, "all"), one, many, tetgen))
    return table(columns, rows)


def goals_table(data):
    """Of the largest volume: what Cleft does beyond conforming tetrahedra, left out step by step."""
    runs = data["volumes"][-1]["runs"]
    rows = []
    for background in BACKGROUNDS:
        whole = runs[key(background, 1)]
        for name in ("default", *programs.FEWER_GOALS):
            run = whole if name == "default" else runs["%s %s, 1" % (background, name)]
            rows.append(
                [
                    background,
                    name,
                    times(run["cpu_seconds"] / whole["cpu_seconds"]),
                    "{:,}".format(run["tets"]),
                    "%.1f" % run["min_dihedral"],
                    times(run["cpu_seconds"]),
                ]
            )
    return table(("background", "goals", "of the default", "tetrahedra", "least angle", "CPU s"), rows)


def exponent(ratio, growth):
    return "%.2f" % (math.log(ratio) / math.log(growth))


def growth_row(program, stage, base, voxels, tets, growth):
    cells = [program, stage]
    for grown, factor in ((voxels, 8), (tets, growth)):
        ratio = grown["cpu_seconds"] / base["cpu_seconds"]
        cells += [times(ratio), exponent(ratio, factor), times(grown["peak_bytes"] / base["peak_bytes"])]
    return cells + [times(step["cpu_seconds"]) for step in (base, voxels, tets)]


def growth_table(data):
    columns = (
        "program",
        "stage",
        "voxels: CPU",
        "exponent",
        "peak",
        "tetrahedra: CPU",
        "exponent",
        "peak",
        "CPU s: base",
        "voxels",
        "tetrahedra",
    )
    rows = []
    for program in PROGRAMS:
        steps = [data["growth"][name].get(key(program, 1)) for name in ("base", "voxels", "tets")]
        if None in steps:
            continue
        growth = steps[2]["tets"] / steps[0]["tets"]
        rows.append(growth_row(program, "all", *steps, growth))
        for stage in stages_of(steps[0]) if program in BACKGROUNDS else ():
            # Some volumes need no surfaces_again, say.
            parts = [step["stages"][stage] for step in steps if stage in step["stages"]]
            if len(parts) == len(steps) and min(part["cpu_seconds"] for part in parts) > LEAST_SECONDS:
                rows.append(growth_row(program, stage, *parts, growth))
    return table(columns, rows)


def numbers_of_growth(data):
    """The numbers of tetrahedra, so that a reader sees how nearly eightfold they are."""
    names = ("base", "voxels", "tets")
    rows = []
    for program in PROGRAMS:
        steps = [data["growth"][name].get(key(program, 1)) for name in names]
        if None not in steps:
            rows.append([program, *("{:,}".format(step["tets"]) for step in steps)])
    sides = ["%d^3 voxels, edges of %g" % tuple(data["series"][name]) for name in names]
    return table(["program", *sides], rows)


def speed_up(runs, program, threads):
    return runs[key(program, 1)]["seconds"] / runs[key(program, threads)]["seconds"]


def outside_delaunay(run):
    """Seconds."""
    return run["seconds"] - delaunay_of(run)["seconds"]


def summary_text(data):
    """The ratios that say most, of the largest volume."""
    volume, threads = data["volumes"][-1], data["threads"]
    runs = volume["runs"]
    first = runs[key("particles", 1)]
    said = []
    if key(programs.REFINE, 1) in runs:
        refined, optimised = (runs[key(program, 1)] for program in PROGRAMS[3:])
        said.append(
            "A tetrahedron of CGAL takes %.2f times the CPU time of one of `particles` after refining, and %.2f times "
            "after perturbing and exuding. It takes %.1f times the memory."
            % (cost(refined) / cost(first), cost(optimised) / cost(first), memory(optimised) / memory(first))
        )
    octree, lattice = (cost(runs[key(background, 1)]) / cost(first) for background in BACKGROUNDS[1:])
    tetgen = delaunay_of(runs["particles, TetGen, 1"])["cpu_seconds"]
    ups = ["%.2f (%s)" % (speed_up(runs, name, threads), name) for name in PROGRAMS if key(name, 1) in runs]
    said += [
        "One of `octree` takes %.2f times the CPU time of one of `particles`, and one of `lattice` %.2f times."
        % (octree, lattice),
        "Cleft's Delaunay tetrahedra take %.2f times the CPU time of TetGen's."
        % (delaunay_of(first)["cpu_seconds"] / tetgen),
        "The speed-up by all %d cores is %s. That of independent work is %.2f."
        % (threads, ", ".join(ups), speed_up(runs, programs.INDEPENDENT, threads)),
        "Outside of its Delaunay tetrahedra, `particles` takes %.2f of the time on all cores; `octree` takes %.2f, and "
        "independent work %.2f."
        % (
            outside_delaunay(runs[key("particles", threads)]) / outside_delaunay(first),
            1 / speed_up(runs, "octree", threads),
            1 / speed_up(runs, programs.INDEPENDENT, threads),
        ),
    ]
    head = "In %s, and on one thread unless said otherwise:\n\n" % volume["name"]
    return head + "".join(textwrap.fill("- " + text, 120, subsequent_indent="  ") + "\n" for text in said)


def delay(data):
    """How much longer the runs on one thread took than their CPU time: the middle one of all."""
    every = [volume["runs"] for volume in data["volumes"]] + list(data["growth"].values())
    chosen = [run for runs in every for name, run in runs.items() if name.endswith(", 1") and "cpu_seconds" in run]
    return statistics.median(run["seconds"] / run["cpu_seconds"] - 1 for run in chosen)


def machine_text(data):
    sizes = "; ".join(
        "%s, %s voxels, %d labels" % (volume["name"], " x ".join(map(str, volume["dims"])), volume["labels"])
        for volume in data["volumes"]
    )
    machine = (
        "The machine had %d cores (%s). Each figure is the least of %d turns or more. Runs on one thread took %.0f %% "
        "longer than their CPU time: other programs and the disk had the rest."
        % (data["threads"], data["processor"], data["repeat"], 100 * delay(data))
    )
    return "".join(textwrap.fill(text, 120) + "\n" for text in ("The volumes: %s." % sizes, machine))


PARTS = {
    "summary": summary_text,
    "machine": machine_text,
    "programs": programs_table,
    "delaunay": delaunay_table,
    "stages": stages_table,
    "goals": goals_table,
    "growth": growth_table,
    "numbers": numbers_of_growth,
}


def write(data, page):
    """Prints every table, and puts them into the page if there is one, with its plots beside."""
    for mark, make in PARTS.items():
        text = make(data)
        print(text)
        if page:
            quality.write_into(page, mark, text)
    if page:
        performance_plots.draw(data, page.parent / "images")
