// What the run reported: labels in voxels against the mesh, its options, and the times of its stages.

// A report of anyone: null if it is none.
function readReport(number) {
    const text = textOf(`report-${number}`);
    if (!text) return null;
    try {
        const report = JSON.parse(text);
        if (report && typeof report === "object") return report;
    } catch {
        /* told below */
    }
    notice("The report of the run is not readable, so its tables are missing.");
    return null;
}

const listOf = (value) => (Array.isArray(value) ? value.filter((row) => row && typeof row === "object") : []);

function labelsOfReport(report) {
    const rows = listOf(report.labels).filter((row) => !row.left_out);
    if (!rows.length) return null;
    const hasNames = rows.some((row) => row.name);
    const name = (cell) => (hasNames ? [cell] : []);
    const heads = [["label"], ...name(["name", "text"]), ["voxels"], ["mesh"], ["%"], ["parts"]];
    const cells = rows.map((row) => [
        [String(row.label)],
        ...name([String(row.name ?? ""), "text"]),
        [short(row.voxel_volume)],
        [short(row.mesh_volume)],
        [Number(row.difference_percent).toFixed(2), ...(Math.abs(row.difference_percent) > 3 ? ["bad"] : [])],
        [`${whole(row.voxel_components)} → ${whole(row.mesh_components)}`, ...(row.lost ? ["bad"] : [])],
    ]);
    return scrolling(tableOf(heads, cells));
}

function optionsOfReport(report) {
    if (!report.options || typeof report.options !== "object") return null;
    const rows = Object.entries(report.options).map(([name, value]) => [
        [name, "text"],
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

// Stages have the times of their steps among them. Bars show which take long.
function timesOfReport(report) {
    const stages = listOf(report.stages);
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
                make("span", {}, String(stage.name)),
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
            make("p.hint", {}, "Volumes, how far the mesh is off, and parts that hang together."),
        );
    const distances = distancesOfReport(report);
    if (distances) addSection(`Distances of interfaces${of}`, false, distances);
    const options = optionsOfReport(report);
    if (options) addSection(`Options${of}`, false, options);
    const times = timesOfReport(report);
    if (times)
        addSection(`Times${of}`, false, times).more.textContent =
            `${Number(report.seconds).toFixed(1)} s, ${report.threads} thread${report.threads === 1 ? "" : "s"}`;
    const warnings = (Array.isArray(report.warnings) ? report.warnings : []).map(String);
    if (warnings.length) addSection(`Warnings${of}`, true, ...warnings.map((text) => make("p.hint", {}, text)));
}

// The least angle that the run aimed at: see the option min_angle.
function goalOfReport(report) {
    const wanted = Number(report?.options?.min_angle);
    return wanted > 0 ? wanted : report?.options?.improve === "best" ? 32 : 25;
}
