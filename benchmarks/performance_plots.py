"""The plots of docs/performance.md, from the figures of performance.py."""
import matplotlib

matplotlib.use("svg")
import matplotlib.pyplot as plt

import programs

# Text stays text: small files. Names and dates that change with each run would make each picture a new one.
plt.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "cleft", "font.size": 9, "font.family": "sans-serif"})
COLOURS = {
    "volume": "#8c8c8c",
    "sizing": "#c9b458",
    "background": "#4c72b0",
    "cleaving": "#55a868",
    "surfaces": "#64b5cd",
    "improving": "#c44e52",
    "surfaces_again": "#3a7d8c",
    "fitting": "#8172b2",
    "finish": "#937860",
    "result_check": "#ccb974",
    "refine": "#2f4b7c",
    "perturb": "#dd8452",
    "exude": "#da8bc3",
}
OTHER_COLOUR = "#000000"


def save(figure, path):
    figure.tight_layout()
    figure.savefig(path, metadata={"Date": None, "Creator": None})
    plt.close(figure)


def runs_on_one_thread(runs):
    return {name: runs[name + ", 1"] for name in programs.MESHERS if name + ", 1" in runs}


def bars_of_stages(data, path):
    """CPU time of a tetrahedron by stage, one thread, in the largest volume."""
    volume = data["volumes"][-1]
    runs = runs_on_one_thread(volume["runs"])
    figure, axes = plt.subplots(figsize=(7.5, 2.6))
    left = dict.fromkeys(runs, 0)
    named = dict.fromkeys(stage for run in runs.values() for stage in run["stages"] if "." not in stage)
    for stage in named:
        widths = [1e6 * run["stages"].get(stage, {}).get("cpu_seconds", 0) / run["tets"] for run in runs.values()]
        axes.barh(
            list(runs),
            widths,
            left=list(left.values()),
            color=COLOURS.get(stage, OTHER_COLOUR),
            label=stage,
            height=0.7,
        )
        left = {name: begin + width for (name, begin), width in zip(left.items(), widths)}
    axes.invert_yaxis()
    axes.set_xlabel("%s, one thread: CPU microseconds a tetrahedron" % volume["name"])
    axes.legend(ncol=2, fontsize=7, frameon=False, bbox_to_anchor=(1, 1), loc="upper left")
    save(figure, path)


def bars_of_growth(data, path):
    """How many times the CPU time and the peak of memory are, where voxels or tetrahedra are eightfold."""
    base = data["growth"]["base"]
    names = list(runs_on_one_thread(base))
    figure, both = plt.subplots(1, 2, figsize=(7.5, 2.6), sharey=True)
    for axes, (kind, title) in zip(both, (("cpu_seconds", "CPU time"), ("peak_bytes", "peak of memory"))):
        for shift, (grown, colour) in enumerate((("voxels", "#c9b458"), ("tets", "#4c72b0"))):
            runs = data["growth"][grown]
            ratios = [runs[name + ", 1"][kind] / base[name + ", 1"][kind] for name in names]
            label = {"voxels": "eightfold voxels", "tets": "edges half as long"}[grown]
            axes.barh([i + 0.4 * shift for i in range(len(names))], ratios, height=0.36, color=colour, label=label)
        axes.axvline(8, color="black", linewidth=0.7, linestyle=":")
        axes.set_xlabel("times the %s" % title)
    both[0].set_yticks([i + 0.2 for i in range(len(names))], names)
    both[0].invert_yaxis()
    both[1].legend(fontsize=7, frameon=False, loc="lower right")
    save(figure, path)


def draw(data, folder):
    folder.mkdir(exist_ok=True)
    bars_of_stages(data, folder / "performance_programs.svg")
    bars_of_growth(data, folder / "performance_growth.svg")
