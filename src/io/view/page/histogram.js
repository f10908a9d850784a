// All dihedral angles of the meshes, in bins of five degrees, with the goal. Of two meshes the second is a line, and
// both are shares, as one may have more tetrahedra.

const kPicture = { width: 340, height: 132, left: 34, low: 18 };

function sharesOf(mesh) {
    const counts = mesh.data.quality.dihedral_histogram;
    const all = counts.reduce((sum, count) => sum + count, 0) || 1;
    return counts.map((count) => count / all);
}

function addHistogram(page) {
    const shares = page.meshes.map(sharesOf);
    const top = Math.max(...shares.flat()) || 1;
    const { width, height, left, low } = kPicture;
    const x = (angle) => left + ((width - left) * angle) / 180;
    const y = (share) => (height - low) * (1 - share / top) + 2;
    const svg = makeSvg("svg", {
        class: "histogram",
        viewBox: `0 0 ${width} ${height + 4}`,
        role: "img",
        "aria-label": "Histogram of the dihedral angles",
    });
    svg.append(...bars(page, shares[0], x, y), ...axisOf(x, y, top));
    if (shares[1]) svg.append(lineOf(shares[1], x, y));
    svg.append(...goalOf(page.goal, x, y, top));
    const { more } = addSection("Dihedral angles", true, svg, ...legendOf(page));
    const { min_dihedral: least, max_dihedral: greatest } = page.meshes[0].data.quality;
    more.textContent = anglesText(least, greatest);
}

function bars(page, shares, x, y) {
    const counts = page.meshes[0].data.quality.dihedral_histogram;
    const step = 180 / counts.length;
    return counts.map((count, i) => {
        const title = makeSvg("title");
        title.textContent = `${i * step}° to ${(i + 1) * step}°: ${whole(count)}, ${(100 * shares[i]).toFixed(2)} %`;
        const bar = makeSvg(
            "rect",
            {
                class: (i + 1) * step <= page.goal ? "bar below" : "bar",
                x: x(i * step) + 0.5,
                y: y(shares[i]),
                width: x(step) - x(0) - 1,
                height: Math.max(0, y(0) - y(shares[i])),
                "data-count": count,
            },
            title,
        );
        return bar;
    });
}

function axisOf(x, y, top) {
    const text = (attributes, words) => {
        const element = makeSvg("text", attributes);
        element.textContent = words;
        return element;
    };
    const angles = [0, 30, 60, 90, 120, 150, 180].map((angle) =>
        text({ x: x(angle), y: y(0) + 14, "text-anchor": angle === 180 ? "end" : "middle" }, `${angle}°`),
    );
    return [
        makeSvg("line", { class: "axis", x1: x(0), x2: x(180), y1: y(0), y2: y(0) }),
        ...angles,
        text({ x: x(0) - 5, y: y(top) + 8, "text-anchor": "end" }, `${(100 * top).toFixed(0)} %`),
        text({ x: x(0) - 5, y: y(0), "text-anchor": "end" }, "0"),
    ];
}

function lineOf(shares, x, y) {
    const step = 180 / shares.length;
    const points = shares.flatMap((share, i) => [`${x(i * step)},${y(share)}`, `${x((i + 1) * step)},${y(share)}`]);
    return makeSvg("polyline", { class: "other", points: points.join(" ") });
}

function goalOf(goal, x, y, top) {
    if (!goal) return [];
    const text = makeSvg("text", { class: "goal-text", x: x(goal) + 4, y: y(top) + 8 });
    text.textContent = `goal ${short(goal)}°`;
    return [makeSvg("line", { class: "goal", x1: x(goal), x2: x(goal), y1: y(0), y2: y(top) }), text];
}

function legendOf(page) {
    if (!page.isComparison) return [];
    return page.meshes.map((mesh, i) => {
        const { min_dihedral: least, max_dihedral: greatest } = mesh.data.quality;
        return make(
            "p.hint",
            {},
            make(`span.${i ? "key-other" : "key-first"}`, {}, i ? "line " : "bars "),
            `${mesh.title}: ${anglesText(least, greatest)}`,
        );
    });
}
