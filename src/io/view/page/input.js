// Mouse, touch and keys on a picture.

const kClick = 4; // pixels that a click may move
const kTurn = 0.0075; // radians a pixel

class Pointers {
    constructor(view) {
        this.view = view;
        this.page = view.page;
        this.down = new Map();
        this.moved = 0;
        const { canvas } = view;
        canvas.addEventListener("pointerdown", (event) => this.begin(event));
        canvas.addEventListener("pointermove", (event) => this.move(event));
        for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, (event) => this.end(event));
        canvas.addEventListener("contextmenu", (event) => event.preventDefault());
        canvas.addEventListener("wheel", (event) => this.wheel(event), { passive: false });
        canvas.addEventListener("dblclick", (event) => this.centre(event));
    }

    begin(event) {
        this.view.canvas.setPointerCapture(event.pointerId);
        this.view.canvas.focus({ preventScroll: true });
        this.down.set(event.pointerId, [event.clientX, event.clientY]);
        this.moved = this.down.size > 1 ? Infinity : 0;
    }

    move(event) {
        const before = this.down.get(event.pointerId);
        if (!before) return;
        const now = [event.clientX, event.clientY];
        const step = [now[0] - before[0], now[1] - before[1]];
        this.moved += Math.hypot(...step);
        if (this.down.size === 2) this.pinch(event.pointerId, before, now);
        else if (this.down.size === 1) this.drag(event, step);
        this.down.set(event.pointerId, now);
        this.page.moving();
    }

    drag(event, [right, low]) {
        const { camera } = this.page.state;
        const height = this.view.canvas.clientHeight;
        if (event.shiftKey || event.buttons & 6) pan(camera, right / height, -low / height);
        else turn(camera, kTurn * right, kTurn * low);
    }

    // Two fingers: their distance zooms, and their middle moves.
    pinch(id, before, now) {
        const other = [...this.down].find(([key]) => key !== id)[1];
        const apart = (a) => Math.max(1, Math.hypot(a[0] - other[0], a[1] - other[1]));
        const height = this.view.canvas.clientHeight;
        zoom(this.page.state.camera, apart(before) / apart(now), this.page.radius);
        pan(this.page.state.camera, (now[0] - before[0]) / 2 / height, -(now[1] - before[1]) / 2 / height);
    }

    end(event) {
        const wasDown = this.down.delete(event.pointerId);
        if (wasDown && event.type === "pointerup" && event.button === 0 && this.moved < kClick)
            this.page.pick(this.view, event.clientX, event.clientY);
    }

    wheel(event) {
        event.preventDefault();
        const lines = event.deltaMode === 1 ? 30 * event.deltaY : event.deltaY;
        zoom(this.page.state.camera, Math.exp(clamp(lines, -300, 300) * 0.0015), this.page.radius);
        this.page.moving();
    }

    centre(event) {
        const found = this.view.at(event.clientX, event.clientY);
        if (found) this.page.fly({ target: found.place });
    }
}

// What each key does, and how it is told.
const kKeys = [
    {
        keys: ["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown"],
        say: "turn; with Shift move",
        shown: ["←", "→", "↑", "↓"],
    },
    { keys: ["+", "=", "-", "_"], say: "nearer and farther", shown: ["+", "−"] },
    { keys: ["0", "Home"], say: "all as it was first", shown: ["0"] },
    {
        keys: ["x", "y", "z", "f", "n"],
        say: "cut across x, y, z, freely, or not at all",
        shown: ["X", "Y", "Z", "F", "N"],
    },
    { keys: ["[", "]"], say: "move the cut", shown: ["[", "]"] },
    { keys: ["r"], say: "keep the other side of the cut", shown: ["R"] },
    { keys: ["c"], say: "cut whole tetrahedra, or flat", shown: ["C"] },
    { keys: ["e"], say: "edges", shown: ["E"] },
    { keys: ["i"], say: "interfaces alone", shown: ["I"] },
    { keys: ["b"], say: "next colouring", shown: ["B"] },
    { keys: ["w"], say: "the next of the worst tetrahedra", shown: ["W"] },
    { keys: ["Escape"], say: "close these keys, or let go of the chosen one", shown: ["Esc"] },
    { keys: ["?"], say: "these keys", shown: ["?"] },
];

function keyActions(page) {
    const { camera } = page.state;
    const step = 6 * kDegree;
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
    const arrow = (event) => {
        const [right, up] = way[event.key];
        if (event.shiftKey) pan(camera, right * 0.05, up * 0.05);
        else turn(camera, -right * step, up * step);
        page.moving();
    };
    const nearer = (factor) => () => {
        zoom(camera, factor, page.radius);
        page.moving();
    };
    const cutBy = (change) => () => page.changeCut({ at: clamp(page.state.cut.at + change, 0, 1) });
    const cutAs = (kind) => () => page.changeCut({ kind });
    return {
        ...Object.fromEntries(Object.keys(way).map((key) => [key, arrow])),
        "+": nearer(1 / 1.15),
        "=": nearer(1 / 1.15),
        "-": nearer(1.15),
        _: nearer(1.15),
        0: () => page.reset(),
        Home: () => page.reset(),
        x: cutAs("x"),
        y: cutAs("y"),
        z: cutAs("z"),
        f: cutAs("free"),
        n: cutAs("none"),
        "[": cutBy(-0.01),
        "]": cutBy(0.01),
        r: () => page.changeCut({ flipped: !page.state.cut.flipped }),
        c: () => page.changeCut({ flat: !page.state.cut.flat }),
        e: () => page.change({ edges: !page.state.edges }),
        i: () => page.change({ interfaces: !page.state.interfaces }),
        b: () => page.change({ by: kColourings[(kColourings.indexOf(page.state.by) + 1) % kColourings.length] }),
        w: () => page.nextWorst(),
        Escape: () => page.escape(),
        "?": () => page.toggleKeys(),
    };
}

// Keys that the element with the focus has for itself: a text all, and a slider, a choice or a list those that move it.
function isOwnKey({ target, key }) {
    if (target.matches("input[type=search]")) return true;
    return !target.matches("body, canvas.mesh") && (key.startsWith("Arrow") || key === "Home");
}

// Nothing needs the focus when the page was just opened.
function listenToKeys(page) {
    const actions = keyActions(page);
    addEventListener("keydown", (event) => {
        if (isOwnKey(event) || event.ctrlKey || event.metaKey || event.altKey) return;
        const action = actions[event.key] ?? actions[event.key.toLowerCase()];
        if (!action) return;
        event.preventDefault();
        action(event);
    });
}

function showKeys() {
    const list = kKeys.flatMap(({ shown, say }) => [
        make("dt", {}, ...shown.flatMap((key) => [make("kbd", {}, key), " "])),
        make("dd", {}, say),
    ]);
    byId("keys").append(
        make(
            "p.hint",
            {},
            "Drag to turn, drag with Shift or the right button to move, wheel to zoom; with fingers: one turns, two ",
            "move and zoom. A click tells of a tetrahedron, a double click puts it in the middle.",
        ),
        make("p.hint", {}, "Keys. Arrows move a slider, a choice or a list while it has the focus:"),
        make("dl", {}, ...list),
    );
}
