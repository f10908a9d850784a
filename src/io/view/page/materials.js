// The list of materials: what each label is called, its volume, and whether it is shown.

// The labels of all meshes, ascending.
function allLabels(meshes) {
    const rows = new Map();
    meshes.forEach((mesh, number) =>
        mesh.labels.forEach((row) => {
            if (!rows.has(row.label)) rows.set(row.label, { label: row.label, colour: row.colour, name: "", of: [] });
            rows.get(row.label).of[number] = row;
            rows.get(row.label).name ||= row.name;
        }),
    );
    return [...rows.values()].sort((a, b) => a.label - b.label);
}

function materialRow(page, row) {
    const box = make("input", { type: "checkbox", onchange: () => page.showLabel(row.label, box.checked) });
    const swatch = make("span.swatch");
    swatch.style.background = cssColour(row.colour);
    const volumes = row.of.map((of) => short(of?.volume ?? 0));
    const counts = row.of.map((of) => `${whole(of?.tets ?? 0)} tetrahedra`).join(" and ");
    const element = make(
        "label.material",
        { title: counts },
        box,
        swatch,
        make("span.number", {}, String(row.label)),
        make("span.label-name", {}, row.name),
        make("span.volume", {}, volumes.join(" | ")),
    );
    element.dataset.label = row.label;
    return { row, box, element, words: `${row.label} ${row.name}`.toLowerCase() };
}

function addMaterials(page) {
    const rows = allLabels(page.meshes).map((row) => materialRow(page, row));
    const list = make("div.scroll.materials", {}, ...rows.map(({ element }) => element));
    const search = make("input", {
        type: "search",
        id: "material-search",
        placeholder: "Find a label or a name",
        ariaLabel: "Find a label or a name",
        oninput: () => {
            const words = search.value.toLowerCase();
            for (const item of rows) item.element.hidden = !item.words.includes(words);
        },
    });
    const found = () => rows.filter(({ element }) => !element.hidden).map(({ row }) => row.label);
    const button = (id, text, show) =>
        make("button", { type: "button", id, onclick: () => page.showLabels(found(), show) }, text);
    const part = addSection(
        "Materials",
        true,
        make("div.line", {}, search, button("show-all", "Show", true), button("hide-all", "Hide", false)),
        list,
    );
    part.more.textContent = `${whole(rows.length)}, with volumes`;
    return () => {
        for (const { row, box, element } of rows) {
            const shown = !page.state.hidden.has(row.label);
            if (box.checked !== shown) box.checked = shown;
            element.classList.toggle("off", !shown);
        }
    };
}
