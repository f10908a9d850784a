// The head of the page and the figures of each mesh.

function addFigures(page, mesh) {
    const { data } = mesh;
    const { quality } = data;
    const size = minus(data.high, data.low);
    addSection(
        page.isComparison ? mesh.title : "Mesh",
        !page.isComparison,
        factsOf([
            ["Tetrahedra", whole(data.tets)],
            ["Points", whole(data.points)],
            ["Materials", whole(mesh.labels.length)],
            ["Box", size.map(short).join(" × ")],
            ["Dihedral angles", anglesText(quality.min_dihedral, quality.max_dihedral)],
            [
                "Radius ratio",
                `median ${short(quality.radius_ratio_median)}, greatest ${short(quality.radius_ratio_max)}`,
            ],
            ["Edges", `${short(quality.min_edge)} to ${short(quality.max_edge)}, mean ${short(quality.mean_edge)}`],
            ["Volume", short(quality.total_volume)],
        ]),
    );
}

function fillHead(page) {
    byId("title").textContent = page.meshes.map((mesh) => mesh.title).join("  |  ");
    const materials = ({ labels }) => `${whole(labels.length)} material${labels.length === 1 ? "" : "s"}`;
    const counts = page.meshes.map(({ data }) => `${whole(data.tets)} tetrahedra, ${materials(data)}`);
    byId("subtitle").textContent = counts.join("  |  ");
}

// A part of a mesh is never shown as if it were all of it.
function tellReductions(meshes) {
    for (const { data } of meshes) {
        if (!data.reduction) continue;
        const what =
            data.reduction === "interfaces"
                ? "those at interfaces and at the hull"
                : "those around the middle of the mesh, at interfaces where these are known";
        notice(
            `“${data.title}” has ${whole(data.tets)} tetrahedra. The picture has ${whole(data.shown_tets)} of them: ` +
                `${what}. ` +
                "All figures, the histogram and the worst tetrahedra are of the whole mesh.",
        );
    }
}

// Returns what brings the notice up to the state.
function tellHidden(page) {
    if (!page.surrounding) return () => {};
    const { label, isAlone } = page.surrounding;
    const name = page.meshes.flatMap(({ labels }) => labels).find((row) => row.label === label)?.name;
    const why = isAlone ? "surrounds all others" : "has most of the sides of the box and would cover the others";
    const told = make(
        "p.notice",
        { id: "surrounding" },
        `Label ${label}${name ? ` (${name})` : ""} ${why}. It is hidden. `,
        make("button", { type: "button", onclick: () => page.showLabel(label, true) }, "Show it"),
    );
    byId("notices").append(told);
    return () => {
        told.hidden = !page.state.hidden.has(label);
    };
}
