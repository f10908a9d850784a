// What is drawn over a picture: the axes in a corner, a ring around the chosen tetrahedron, dots at the worst ones.

const kAxisColours = { x: "#d5433b", y: "#2f9e44", z: "#3b78d8" };

class Overlay {
    constructor() {
        this.marks = makeSvg("g");
        this.axes = makeSvg("svg", { class: "axes", viewBox: "-40 -40 80 80", "aria-hidden": "true" });
        const whole = makeSvg(
            "svg",
            { class: "marks", width: "100%", height: "100%", "aria-hidden": "true" },
            this.marks,
        );
        whole.style.cssText = "position:absolute;inset:0;pointer-events:none";
        this.root = make("div", {}, whole, this.axes);
    }

    draw(view) {
        this.drawAxes(view.page.state.camera);
        this.drawMarks(view);
    }

    // The one that looks away first, so that the others lie over it.
    drawAxes(camera) {
        const { right, up, back } = cameraAxes(camera);
        const ends = Object.entries(kAxes).map(([name, axis]) => ({
            name,
            x: 26 * dot(axis, right),
            y: -26 * dot(axis, up),
            depth: dot(axis, back),
        }));
        ends.sort((a, b) => a.depth - b.depth);
        this.axes.replaceChildren(
            ...ends.flatMap(({ name, x, y, depth }) => {
                const fill = kAxisColours[name];
                const opacity = depth < -0.1 ? 0.55 : 1;
                const label = makeSvg("text", { x: 1.32 * x, y: 1.32 * y, fill, opacity });
                label.textContent = name.toUpperCase();
                return [
                    makeSvg("line", { x1: 0, y1: 0, x2: x, y2: y, stroke: fill, "stroke-width": 2.5, opacity }),
                    label,
                ];
            }),
        );
    }

    drawMarks(view) {
        const { page, canvas } = view;
        const [width, height] = [canvas.clientWidth, canvas.clientHeight];
        const circle = (place, attributes) => {
            const at = projected(page.state.camera, view.aspect(), place);
            return (
                at &&
                makeSvg("circle", { cx: ((at[0] + 1) / 2) * width, cy: ((1 - at[1]) / 2) * height, ...attributes })
            );
        };
        const dots = page.state.marks
            ? page
                  .worstOf(view)
                  .map((tet) =>
                      circle(page.centreOf(tet), { r: 3.5, fill: "#e6194b", stroke: "#fff", "stroke-width": 1 }),
                  )
            : [];
        const { chosen } = page.state;
        if (chosen && chosen.view === view)
            dots.push(circle(page.centreOf(chosen.tet), { r: 16, fill: "none", stroke: "#e6194b", "stroke-width": 2 }));
        this.marks.replaceChildren(...dots.filter(Boolean));
    }
}
