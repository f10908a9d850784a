// The parts of the panel that say what is drawn: the cut, and how the mesh looks.

const kColourings = ["material", "angle", "ratio", "size"];
const kColouringNames = {
    material: "material",
    angle: "least dihedral angle",
    ratio: "radius ratio",
    size: "size",
};

function choices(name, pairs, chosen, change) {
    const select = make(
        "select",
        { id: `${name}-choice`, name, onchange: () => change(select.value) },
        ...pairs.map(([value, text]) => make("option", { value }, text)),
    );
    select.value = chosen;
    return select;
}

function tick(id, text, change) {
    const box = make("input", { type: "checkbox", id, onchange: () => change(box.checked) });
    return { box, label: make("label", {}, box, text) };
}

function slider(id, text, low, high, step, change) {
    const input = make("input", {
        type: "range",
        id,
        min: low,
        max: high,
        step,
        ariaLabel: text,
        title: text,
        oninput: () => change(Number(input.value)),
    });
    return input;
}

// Returns what brings the controls up to the state.
function addCut(page) {
    const { cut } = page.state;
    const kinds = [
        ["none", "no cut"],
        ["x", "across x"],
        ["y", "across y"],
        ["z", "across z"],
        ["free", "free"],
    ];
    const kind = choices("cut", kinds, cut.kind, (value) => page.changeCut({ kind: value }));
    const at = slider("cut-at", "Place of the cut", 0, 1, 0.001, (value) => page.changeCut({ at: value }));
    const place = make("output");
    const flat = tick("cut-flat", "flat, through tetrahedra", (value) => page.changeCut({ flat: value }));
    const flipped = tick("cut-flip", "other side", (value) => page.changeCut({ flipped: value }));
    const yaw = slider("cut-yaw", "Direction of the free cut around z", -180, 180, 1, (value) =>
        page.changeCut({ yaw: value * kDegree }),
    );
    const pitch = slider("cut-pitch", "Direction of the free cut above x and y", -90, 90, 1, (value) =>
        page.changeCut({ pitch: value * kDegree }),
    );
    const face = make("button", { type: "button", id: "cut-face", onclick: () => page.cutFacing() }, "Face me");
    const free = make("div.line", {}, "Direction", yaw, pitch, face);
    const ticks = make("div.line", {}, flat.label, flipped.label);
    // On paper there is nothing to set.
    addSection("Cut", true, make("div.line", {}, kind, at, place), free, ticks).section.classList.add("controls");
    return () => {
        kind.value = cut.kind;
        at.value = cut.at;
        at.disabled = cut.kind === "none";
        place.textContent = page.placeOfCut();
        flat.box.checked = cut.flat;
        flipped.box.checked = cut.flipped;
        free.hidden = cut.kind !== "free";
        yaw.value = cut.yaw / kDegree;
        pitch.value = cut.pitch / kDegree;
    };
}

function addLooks(page) {
    const { state } = page;
    const by = choices(
        "by",
        kColourings.map((name) => [name, kColouringNames[name]]),
        state.by,
        (value) => page.change({ by: value }),
    );
    const edges = tick("edges", "edges", (value) => page.change({ edges: value }));
    const interfaces = tick("interfaces", "interfaces alone", (value) => page.change({ interfaces: value }));
    const ticks = make("div.line", {}, edges.label, interfaces.label);
    const choice = make("div.line", {}, make("label.wide", {}, "Colour by ", by));
    addSection("Show", true, choice, ticks).section.classList.add("controls");
    return () => {
        by.value = state.by;
        edges.box.checked = state.edges;
        interfaces.box.checked = state.interfaces;
    };
}
