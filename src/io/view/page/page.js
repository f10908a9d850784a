// The page: its meshes, its state, and what changes it.

class Page {
    constructor(meshes, reports, frame, goal) {
        this.meshes = meshes;
        this.frame = frame;
        this.goal = goal || goalOfReport(reports.find(Boolean));
        this.isComparison = meshes.length > 1;
        this.surrounding = surroundingOf(meshes);
        this.state = firstState(this.surrounding);
        this.firstCut = this.state.cut.kind;
        this.box = boxOfAll(meshes);
        this.radius = norm(minus(this.box.high, this.box.low)) / 2 || 1;
        this.software = drawsBySoftware();
        this.slow = 1; // pixels are this much larger while something moves
        this.views = meshes.map((mesh, number) => new View(this, mesh, number));
        this.legend = makeLegend();
        this.views[0].box.append(this.legend.root);
        this.scales = Object.fromEntries(kColourings.slice(1).map((by) => [by, null]));
        this.updates = [];
    }

    addPanel(reports) {
        this.meshes.forEach((mesh, number) => addWarnings(this, mesh, reports[number]));
        for (const mesh of this.meshes) addFigures(this, mesh);
        this.updates.push(addCut(this), addLooks(this), addMaterials(this));
        addHistogram(this);
        this.updates.push(addWorst(this));
        this.meshes.forEach((mesh, number) => addReport(this, mesh, reports[number]));
    }

    // ------------------------------------------------------------------ what is drawn

    refresh() {
        const { by } = this.state;
        if (by !== "material") this.scales[by] ??= scaleOf(by, this.meshes, this.frame.unit);
        for (const view of this.views) view.update();
        this.legend.show(this.scales[by] ?? null);
        for (const update of this.updates) update();
        this.redraw();
    }

    // At the next frame, once for all that happens until then.
    redraw() {
        this.nextDraw ??= requestAnimationFrame((time) => {
            this.nextDraw = null;
            this.draw(time);
        });
    }

    // A change of what is drawn: it is found at the next frame, too, as a slider may move several times until then.
    change(values) {
        Object.assign(this.state, values);
        this.pending ??= requestAnimationFrame(() => {
            this.pending = null;
            this.refresh();
        });
    }

    draw(time) {
        for (const view of this.views) {
            view.draw();
            updateCard(this, view);
        }
        this.measure(time);
        this.directions();
    }

    // Where frames take long, there are fewer pixels until all stands still.
    measure(time) {
        const gap = time - (this.lastFrame ?? -Infinity);
        this.lastFrame = time;
        if (!this.isMoving || gap > 500) return;
        if (gap > 45) this.slow = Math.min(2.5, this.slow * 1.15);
        else if (gap < 22) this.slow = Math.max(1, this.slow / 1.05);
    }

    moving() {
        this.isMoving = true;
        clearTimeout(this.rest);
        this.rest = setTimeout(() => {
            this.isMoving = false;
            this.redraw();
        }, 160);
        this.redraw();
    }

    pixels() {
        const most = this.software ? 1 : Math.min(2, devicePixelRatio);
        return this.isMoving ? most / this.slow : most;
    }

    // ------------------------------------------------------------------ labels and cuts

    showLabels(labels, shown) {
        for (const label of labels)
            if (shown) this.state.hidden.delete(label);
            else this.state.hidden.add(label);
        this.change({});
    }

    showLabel(label, shown) {
        this.showLabels([label], shown);
    }

    showOnly(label) {
        this.state.hidden = new Set(this.meshes.flatMap((mesh) => mesh.labels.map((row) => row.label)));
        this.showLabels([label], true);
    }

    changeCut(values) {
        // Of a new axis the far side stays, so that one looks onto the cut.
        if (values.kind && values.kind !== this.state.cut.kind && kAxes[values.kind])
            values.flipped = dot(kAxes[values.kind], cameraAxes(this.state.camera).back) < 0 ? false : true;
        Object.assign(this.state.cut, values);
        this.change({});
    }

    cutFacing() {
        const { yaw, pitch } = this.state.camera;
        this.changeCut({ kind: "free", yaw: Math.atan2(Math.sin(yaw), Math.cos(yaw)), pitch, flipped: true });
    }

    // The cut at a tetrahedron, which is just kept, and seen by who looks now.
    cutOf(tet) {
        const cut = { ...this.state.cut };
        if (cut.kind === "none") cut.kind = "y";
        cut.flipped = dot(cutNormal(cut), cameraAxes(this.state.camera).back) >= 0;
        cut.at = clamp(cutThrough(cut, this.box, this.centreOf(tet)) + (cut.flipped ? 1e-6 : -1e-6), 0, 1);
        return cut;
    }

    cutAt(tet) {
        // Not by changeCut(), which has its own side for a new axis.
        Object.assign(this.state.cut, this.cutOf(tet));
        this.change({});
    }

    isCutAt(tet) {
        const { cut } = this.state;
        const there = this.cutOf(tet);
        return ["kind", "flipped", "at"].every((name) => cut[name] === there[name]);
    }

    placeOfCut() {
        const plane = cutPlane({ ...this.state.cut, flipped: false }, this.box);
        if (!plane) return "";
        // Where the normal of the plane, as an arrow from the zero of the file, meets it.
        const { unit, origin } = this.frame;
        return this.frame.text(unit * plane.offset + dot(plane.normal, origin));
    }

    // ------------------------------------------------------------------ tetrahedra

    centreOf(tet) {
        const sum = [0, 1, 2].map(
            (axis) => tet.corners[axis] + tet.corners[3 + axis] + tet.corners[6 + axis] + tet.corners[9 + axis],
        );
        return this.frame.toPage(times(1 / 4, sum));
    }

    worstOf(view) {
        return view.mesh.data.worst[this.worstBy];
    }

    choose(chosen) {
        this.state.chosen = chosen;
        for (const view of this.views) {
            const corners =
                chosen?.view === view
                    ? [0, 3, 6, 9].map((c) => this.frame.toPage(chosen.tet.corners.slice(c, c + 3)))
                    : null;
            view.picture.setChosen(corners);
            showCard(this, view);
        }
        for (const update of this.updates) update();
        this.redraw();
    }

    pick(view, clientX, clientY) {
        const found = view.at(clientX, clientY);
        this.choose(found && { view, tet: describedTet(view.mesh, found.tet, this.frame) });
    }

    // A cut goes along, so that the tetrahedron is not hidden in the mesh.
    flyTo(view, tet) {
        const centre = this.centreOf(tet);
        const reach = Math.max(
            ...[0, 3, 6, 9].map((c) => norm(minus(this.frame.toPage(tet.corners.slice(c, c + 3)), centre))),
        );
        if (this.state.cut.kind !== "none") this.cutAt(tet);
        this.choose({ view, tet });
        this.fly({
            target: centre,
            distance: clamp(distanceFor(9 * reach, view.aspect()), 0, this.state.camera.distance),
        });
    }

    nextWorst() {
        const all = this.rowsOfTets;
        if (!all.length) return;
        const at = all.findIndex(
            ({ view, tet }) => this.state.chosen?.view === view && this.state.chosen.tet.tet === tet.tet,
        );
        const next = all[(at + 1) % all.length];
        this.flyTo(next.view, next.tet);
    }

    // ------------------------------------------------------------------ the camera

    fly(goal) {
        const { camera } = this.state;
        const start = { ...camera };
        const end = { ...camera, ...goal };
        const takes = matchMedia("(prefers-reduced-motion: reduce)").matches ? 0 : 450;
        const begin = performance.now();
        cancelAnimationFrame(this.flight);
        const step = () => {
            const share = takes ? clamp((performance.now() - begin) / takes, 0, 1) : 1;
            const eased = share * share * (3 - 2 * share);
            for (const name of ["yaw", "pitch", "distance"])
                camera[name] = start[name] + eased * (end[name] - start[name]);
            camera.target = plus(start.target, times(eased, minus(end.target, start.target)));
            this.moving();
            if (share < 1) this.flight = requestAnimationFrame(step);
        };
        step();
    }

    // From where all that is shown fills the views.
    home() {
        const { low, high } = boxOfPoints(this.meshes, shownPoints(this.meshes, this.state.hidden));
        const camera = { yaw: -58 * kDegree, pitch: 20 * kDegree, target: times(0.5, plus(low, high)) };
        return { ...camera, distance: this.filling(camera) };
    }

    // The distance of a camera from where it sees all that is shown.
    filling(camera, aspects = this.views.map((view) => view.aspect())) {
        const points = shownPoints(this.meshes, this.state.hidden);
        const distances = this.meshes.map((mesh, number) =>
            distanceToFit(camera, aspects[number], mesh.positions, points[number]),
        );
        return Math.max(...distances) || 1;
    }

    // Who sees all of the mesh sees all of it in a window of another shape, too.
    fitWindow() {
        const { camera } = this.state;
        const aspects = this.views.map((view) => view.aspect());
        if (this.aspects && aspects.some((aspect, number) => aspect !== this.aspects[number])) {
            const before = this.filling(camera, this.aspects);
            if (camera.distance > 0.99 * before) camera.distance *= this.filling(camera, aspects) / before;
        }
        this.aspects = aspects;
        this.redraw();
    }

    // How the page opened. The theme stays.
    reset() {
        const { camera, cut, ...others } = firstState(this.surrounding);
        Object.assign(this.state.cut, cut, { kind: this.firstCut });
        Object.assign(this.state, others);
        this.choose(null);
        // At once, as a notice that comes back changes the room for the picture.
        this.refresh();
        this.fitWindow();
        this.fly(this.home());
    }

    lookAlong(yaw, pitch) {
        const { camera } = this.state;
        // The shortest way around.
        const turns = Math.round((camera.yaw - yaw) / (2 * Math.PI));
        const goal = { yaw: yaw + 2 * Math.PI * turns, pitch };
        // Who sees all of the mesh sees all of it from the other side, too. Who is nearer stays so.
        if (camera.distance > 0.99 * this.filling(camera)) goal.distance = this.filling({ ...camera, ...goal });
        this.fly(goal);
    }

    // ------------------------------------------------------------------ the bar

    toggleKeys() {
        const keys = byId("keys");
        keys.hidden = !keys.hidden;
        byId("help").setAttribute("aria-expanded", String(!keys.hidden));
    }

    escape() {
        if (byId("keys").hidden) this.choose(null);
        else this.toggleKeys();
    }

    directions() {
        const { back } = cameraAxes(this.state.camera);
        for (const button of byId("directions").children)
            pressed(button, dot(back, kDirections[button.dataset.name].from) > 0.9999);
    }
}

// From where each button looks.
const kDirections = Object.fromEntries(
    Object.entries(kAxes).flatMap(([name, axis]) => [
        [
            `+${name}`,
            {
                from: axis,
                yaw: Math.atan2(axis[1], axis[0]) - (axis[2] ? Math.PI / 2 : 0),
                pitch: (axis[2] * Math.PI) / 2,
            },
        ],
        [
            `-${name}`,
            {
                from: times(-1, axis),
                yaw: Math.atan2(-axis[1], -axis[0]) - (axis[2] ? Math.PI / 2 : 0) + 0,
                pitch: (-axis[2] * Math.PI) / 2,
            },
        ],
    ]),
);
