// What the run reported: labels in voxels against the mesh, its options, and the times of its stages.

// A report of anyone: null if it is none, or of another mesh.
function readReport(mesh, number) {
    const text = textOf(`report-${number}`);
    if (!text) return null;
    try {
        const report = JSON.parse(text);
        const tets = report?.mesh?.tets ?? mesh.tets;
        if (tets !== mesh.tets) {
            notice(`The report is of another mesh, which has ${whole(tets)} tetrahedra, so its tables are missing.`);
            return null;
        }
        if (report && typeof report === "object") return report;
    } catch {
        /* told below */
    }
    notice("The report of the run is not readable, so its tables are missing.");
    return null;
}

const listOf = (value) => (Array.isArray(value) ? value.filter((row) => row && typeof row === "object") : []);

// No minus without a digit behind it.
const percentText = (percent) => Number(percent).toFixed(2).replace(/^-0\.00$/, "0.00");

function labelsOfReport(report) {
    const rows = listOf(report.labels).filter((row) => !row.left_out);
    if (!rows.length) return null;
    const hasNames = rows.some((row) => row.name);
    const name = (cell) => (hasNames ? [cell] : []);
    // The difference comes first, as there may be no room for all.
    const heads = [["label"], ...name(["name", "text"]), ["%"], ["voxels"], ["mesh"], ["parts"]];
    const cells = rows.map((row) => [
        [String(row.label)],
        ...name([String(row.name ?? ""), "text"]),
        [percentText(row.difference_percent), ...(Math.abs(row.difference_percent) > 3 ? ["bad"] : [])],
        [short(row.voxel_volume)],
        [short(row.mesh_volume)],
        [`${whole(row.voxel_components)} → ${whole(row.mesh_components)}`, ...(row.lost ? ["bad"] : [])],
    ]);
    return scrolling(tableOf(heads, cells));
}

// As on the command line. The report has the names of the library, and lists by their plural.
const optionName = (name) => `--${name === "label_sizes" ? "label-size" : name.replaceAll("_", "-")}`;

function optionsOfReport(report) {
    if (!report.options || typeof report.options !== "object") return null;
    const rows = Object.entries(report.options).map(([name, value]) => [
        [optionName(name), "text"],
        [typeof value === "object" ? JSON.stringify(value) : String(value), "text"],
    ]);
    return scrolling(
        tableOf(
            [
                ["option", "text"],
                ["value", "text"],
            ],
            rows,
        ),
    );
}

// The report has stages in the order in which they end. Here each stands before its parts.
function wholesFirst(stages) {
    let groups = []; // of a stage and its parts
    for (const stage of stages) {
        const isPart = ([first]) => first.part_of === stage.name;
        const parts = groups.filter(isPart).flat();
        groups = [...groups.filter((group) => !isPart(group)), [stage, ...parts]];
    }
    return groups.flat();
}

// Bars show which take long.
function timesOfReport(report) {
    const stages = wholesFirst(listOf(report.stages).filter((stage) => typeof stage.name === "string"));
    if (!stages.length) return null;
    const longest = Math.max(...stages.map((stage) => stage.seconds), 1e-9);
    return make(
        "div.times",
        {},
        ...stages.map((stage) => {
            const bar = make("div");
            bar.style.width = `${(100 * stage.seconds) / longest}%`;
            return make(
                "div.time",
                {},
                make(stage.part_of ? "span.part" : "span", {}, stage.name),
                make("div.track", {}, bar),
                make("span", {}, `${Number(stage.seconds).toFixed(2)} s`),
            );
        }),
    );
}

// How far interfaces are from those of the volume: with --distances. Both ways are looked at; the worse one is told.
function distancesOfReport(report) {
    const rows = listOf(report.distances);
    if (!rows.length) return null;
    const worse = (row, name) => short(Math.max(Number(row.mesh?.[name]), Number(row.volume?.[name])));
    const cells = rows.map((row) => [
        [[].concat(row.labels).join(", "), "text"],
        ...["mean", "99", "greatest"].map((name) => [worse(row, name)]),
    ]);
    return scrolling(tableOf([["labels", "text"], ["mean"], ["99 %"], ["greatest"]], cells));
}

function addReport(page, mesh, report) {
    if (!report) return;
    const of = page.isComparison ? ` of ${mesh.title}` : "";
    const labels = labelsOfReport(report);
    if (labels)
        addSection(
            `Voxels and mesh${of}`,
            false,
            labels,
            make("p.hint", {}, "How far the volume of the mesh is off, both volumes, and parts that hang together."),
        );
    const distances = distancesOfReport(report);
    if (distances) addSection(`Distances of interfaces${of}`, false, distances);
    const options = optionsOfReport(report);
    if (options) addSection(`Options${of}`, false, options);
    const times = timesOfReport(report);
    if (times)
        addSection(`Times${of}`, false, times).more.textContent =
            `${Number(report.seconds).toFixed(1)} s, ${report.threads} thread${report.threads === 1 ? "" : "s"}`;
}

// Names of options are not broken at the ends of lines.
const withOptions = (text) =>
    text.split(/(--[a-z][a-z-]{1,30})/).map((part, i) => (i % 2 ? make("span.option", {}, part) : part));

// Above all else: they say what of the rest is to be doubted.
function addWarnings(page, mesh, report) {
    const warnings = (Array.isArray(report?.warnings) ? report.warnings : []).map(String);
    const of = page.isComparison ? ` of ${mesh.title}` : "";
    const lines = warnings.map((text) => make("p.hint", {}, ...withOptions(text)));
    if (lines.length) addSection(`Warnings${of}`, true, ...lines);
}

// The least angle that the run aimed at: see the option min_angle.
function goalOfReport(report) {
    const wanted = Number(report?.options?.min_angle);
    return wanted > 0 ? wanted : report?.options?.improve === "best" ? 32 : 25;
}
