// The worst tetrahedra, and the card of the one that is chosen.

function worstTable(page, view, by) {
    const heads = [["no."], ["label"], ["angles"], ["ratio"]];
    const rows = view.mesh.data.worst[by].map((tet) => {
        const go = make(
            "button",
            { type: "button", title: "Fly there", onclick: () => page.flyTo(view, tet) },
            whole(tet.tet + 1),
        );
        const row = make(
            "tr",
            {},
            make("td", {}, go),
            make("td", {}, String(tet.label)),
            make(
                "td",
                { className: tet.least_angle < page.goal ? "bad" : "" },
                anglesText(tet.least_angle, tet.greatest_angle),
            ),
            make("td", {}, short(tet.radius_ratio)),
        );
        page.rowsOfTets.push({ row, view, tet });
        return row;
    });
    const table = tableOf(heads, []);
    table.tBodies[0].append(...rows);
    return make("div.worst", {}, scrolling(table));
}

function addWorst(page) {
    const place = make("div");
    const show = (by) => {
        page.worstBy = by;
        page.rowsOfTets = [];
        place.replaceChildren(
            ...page.views.flatMap((view) => [
                ...(page.isComparison ? [make("p.hint", {}, view.mesh.title)] : []),
                worstTable(page, view, by),
            ]),
        );
        page.redraw();
    };
    const by = choices(
        "worst",
        [
            ["angle", "least angles"],
            ["ratio", "greatest radius ratios"],
        ],
        "angle",
        show,
    );
    const marks = tick("marks", "dots in the picture", (value) => {
        page.state.marks = value;
        page.redraw();
    });
    addSection(
        "Worst tetrahedra",
        true,
        make("div.line", {}, by, marks.label),
        place,
        make("p.hint", {}, "Numbers count from 1, in the order of the mesh."),
    );
    show("angle");
    return () => {
        marks.box.checked = page.state.marks;
        for (const { row, view, tet } of page.rowsOfTets)
            row.classList.toggle("chosen", page.state.chosen?.view === view && page.state.chosen.tet.tet === tet.tet);
    };
}

function showCard(page, view) {
    const { chosen } = page.state;
    const { card } = view;
    card.hidden = chosen?.view !== view;
    if (card.hidden) return;
    const { tet } = chosen;
    const name = view.mesh.labels.find((row) => row.label === tet.label)?.name ?? "";
    const centre = page.frame.toFile(page.centreOf(tet)).map((x) => page.frame.text(x));
    view.cutHere = make("button", { type: "button", onclick: () => page.cutAt(tet) }, "Cut here");
    card.replaceChildren(
        make("button.close", { type: "button", ariaLabel: "Close", onclick: () => page.choose(null) }, "×"),
        make("h3", {}, `Tetrahedron ${whole(tet.tet + 1)}`),
        factsOf([
            ["Material", `${tet.label} ${name}`],
            ["Dihedral angles", anglesText(tet.least_angle, tet.greatest_angle)],
            ["Radius ratio", short(tet.radius_ratio)],
            ["Volume", short(tet.volume)],
            ["Centre", centre.join(", ")],
        ]),
        make(
            "div.tools",
            {},
            view.cutHere,
            make("button", { type: "button", onclick: () => page.showOnly(tet.label) }, "Only this material"),
        ),
    );
}

// Where the cut is already, there is nothing to do.
function updateCard(page, view) {
    const { chosen } = page.state;
    if (chosen?.view !== view) return;
    view.cutHere.disabled = page.isCutAt(chosen.tet);
    view.cutHere.title = view.cutHere.disabled ? "The cut is here" : "";
}
