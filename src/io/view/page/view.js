// One mesh in the page: its picture, what lies over it, and what of it is drawn.

class View {
    constructor(page, mesh, number) {
        this.page = page;
        this.mesh = mesh;
        this.canvas = make("canvas.mesh", { tabIndex: 0 });
        this.canvas.setAttribute("role", "img");
        this.canvas.setAttribute(
            "aria-label",
            `${mesh.title}: ${whole(mesh.data.tets)} tetrahedra. ` +
                "Arrow keys turn, plus and minus zoom, question mark tells all keys.",
        );
        this.over = new Overlay();
        this.card = make("div.card", { hidden: true });
        this.box = make("div.view", {}, this.canvas, this.over.root, this.card);
        if (page.isComparison)
            this.box.append(make("div.name", { className: `name ${number ? "key-other" : "key-first"}` }, mesh.title));
        byId("views").append(this.box);
        this.picture = new Picture(this.canvas, page.software);
        this.canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
        this.canvas.addEventListener("webglcontextrestored", () => {
            this.picture.make();
            page.refresh();
        });
    }

    // After a change of what is drawn, and not of the camera alone.
    update() {
        const { mesh, page } = this;
        const { state } = page;
        const plane = cutPlane(state.cut, page.box);
        const distances = plane ? distancesFrom(mesh, plane) : null;
        const colours = this.colours(state.by);
        const kept = keptTets(mesh, state, distances);
        const isFlat = plane !== null && state.cut.flat;
        this.codes = state.interfaces ? interfaceFaces(mesh, kept) : boundaryFaces(mesh, kept);
        this.surface = faceVertices(mesh, this.codes, colours);
        this.slice = isFlat && !state.interfaces ? sliceVertices(mesh, kept, distances, colours) : vertexRoom(0);
        this.clip = isFlat ? plane : null;
        this.picture.setTriangles(this.surface, this.slice);
    }

    colours(by) {
        if (this.coloured !== by) {
            this.coloursNow = coloursOf(this.mesh, by, this.page.scales[by]);
            this.coloured = by;
        }
        return this.coloursNow;
    }

    draw() {
        const { state, radius } = this.page;
        this.picture.draw(state.camera, {
            radius,
            scale: this.page.pixels(),
            plane: this.clip,
            edges: state.edges,
            edgeColour: [0.08, 0.09, 0.1],
            paper: isDark() ? [0.1, 0.115, 0.135] : [0.945, 0.955, 0.965],
        });
        this.over.draw(this);
    }

    aspect() {
        return this.picture.aspect();
    }

    // The tetrahedron at a place of the window, or null.
    at(clientX, clientY) {
        const box = this.canvas.getBoundingClientRect();
        const x = ((clientX - box.left) / box.width) * 2 - 1;
        const y = 1 - ((clientY - box.top) / box.height) * 2;
        const ray = rayThrough(this.page.state.camera, this.aspect(), x, y);
        const none = { far: Infinity, tet: -1, place: null };
        const best = nearest(ray, this.surface, this.clip, (i) => this.codes[i] >> 2, none);
        const found = nearest(ray, this.slice, null, (i) => this.slice.owners[i], best);
        return found.tet < 0 ? null : found;
    }
}
