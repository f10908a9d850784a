// Begins: reads the data, loads the meshes, and shows them.

function say(text) {
    let busy = document.querySelector(".busy");
    if (!busy) {
        busy = make("div.busy", { role: "status" });
        byId("views").append(make("div.view", {}, busy));
    }
    busy.textContent = text;
}

async function begin() {
    followSystem();
    const data = JSON.parse(textOf("data"));
    const reports = data.meshes.map(readReport);
    const ends = (choose, end) => [0, 1, 2].map((axis) => choose(...data.meshes.map((mesh) => mesh[end][axis])));
    const frame = new Frame(ends(Math.min, "low"), ends(Math.max, "high"));
    const meshes = [];
    for (const [number, mesh] of data.meshes.entries()) meshes.push(await loadMesh(mesh, number, frame, say));
    byId("views").replaceChildren();
    if (data.places) notice(`${data.places}.`);
    show(new Page(meshes, reports, frame, data.goal), reports);
}

function show(page, reports) {
    fillHead(page);
    tellReductions(page.meshes);
    page.updates.push(tellHidden(page));
    addBar(page);
    page.addPanel(reports);
    for (const view of page.views) {
        new Pointers(view);
        new ResizeObserver(() => page.fitWindow()).observe(view.canvas);
    }
    listenToKeys(page);
    addEventListener("beforeprint", () => page.draw(performance.now()));
    Object.assign(page.state.camera, page.home());
    page.refresh();
    // All may lie on the side that is cut away: a few large tetrahedra, or a mesh far from the other one.
    if (page.views.some((view) => view.codes.length === 0)) {
        page.firstCut = "none";
        page.changeCut({ kind: "none" });
    }
    // For a console, and for tests.
    globalThis.cleftPage = Object.assign(page, { anglesOf, cornersOf, measured, projected });
    document.documentElement.dataset.ready = Math.round(performance.now());
}

begin().catch((error) => {
    byId("views").replaceChildren();
    notice(`The mesh cannot be shown: ${error.message}. A browser of 2023 or later with WebGL 2 can.`);
    document.documentElement.dataset.ready = "failed";
    throw error;
});
