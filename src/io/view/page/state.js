// What the user has chosen: the same for all views of the page.

// `surrounding` is that of surroundingOf().
function firstState(surrounding) {
    return {
        camera: { yaw: 0, pitch: 0, distance: 1, target: [0, 0, 0] },
        cut: { kind: "y", at: 0.5, flipped: false, flat: false, yaw: 30 * kDegree, pitch: 20 * kDegree },
        hidden: new Set(surrounding ? [surrounding.label] : []),
        interfaces: false,
        edges: true,
        by: "material",
        marks: false,
        chosen: null, // { view, tet }
    };
}

// The label that hides all others in the meshes, or null. A label is shown or hidden in the whole page, so it must hide
// them in each mesh that has it.
function surroundingOf(meshes) {
    const around = meshes.map(surroundingLabel);
    const first = around.find(Boolean) ?? null;
    const has = ({ labels }) => labels.some((row) => row.label === first.label);
    return first && meshes.every((mesh, i) => around[i]?.label === first.label || !has(mesh)) ? first : null;
}

// The label that alone has the sides of the box, if others are inside. Or 0, which most volumes have around all else,
// if it has most of the sides: a neck or a bed often reaches one of them.
function surroundingLabel(mesh) {
    const kMost = 2 / 3;
    if (mesh.labels.length < 2) return null;
    const areas = areasOnBox(mesh);
    if (areas.size === 1) return { label: [...areas.keys()][0], isAlone: true };
    const all = [...areas.values()].reduce((sum, area) => sum + area, 0);
    return (areas.get(0) ?? 0) > kMost * all ? { label: 0, isAlone: false } : null;
}

// What each label has of the sides of the box.
function areasOnBox(mesh) {
    const areas = new Map();
    for (let code = 0; code < mesh.neighbours.length; ++code) {
        // Where the page has a part of the mesh, most faces without a neighbour are no hull.
        if (mesh.neighbours[code] !== kNone || !isOnBox(mesh, code)) continue;
        const { label } = mesh.labels[mesh.materials[code >> 2]];
        areas.set(label, (areas.get(label) ?? 0) + norm(normalsOf(cornersOf(mesh, code >> 2))[code & 3]));
    }
    return areas;
}

// 1 for each point of what is shown, without the cut; of everything if nothing is shown in any mesh.
function shownPoints(meshes, hidden) {
    const isShown = ({ label }) => !hidden.has(label);
    const hasAny = meshes.some(({ labels }) => labels.some(isShown));
    return meshes.map((mesh) => {
        const shown = mesh.labels.map((row) => !hasAny || isShown(row));
        const isThere = new Uint8Array(mesh.positions.length / 3);
        for (let i = 0; i < mesh.tets.length; ++i) if (shown[mesh.materials[i >> 2]]) isThere[mesh.tets[i]] = 1;
        return isThere;
    });
}

// `points` are those of shownPoints().
function boxOfPoints(meshes, points) {
    const box = { low: [Infinity, Infinity, Infinity], high: [-Infinity, -Infinity, -Infinity] };
    meshes.forEach(({ positions }, number) => {
        for (let i = 0; i < positions.length; ++i) {
            if (!points[number][Math.floor(i / 3)]) continue;
            box.low[i % 3] = Math.min(box.low[i % 3], positions[i]);
            box.high[i % 3] = Math.max(box.high[i % 3], positions[i]);
        }
    });
    return box;
}

function boxOfAll(meshes) {
    const pick = (choose, end) => [0, 1, 2].map((axis) => choose(...meshes.map((mesh) => mesh.box[end][axis])));
    return { low: pick(Math.min, "low"), high: pick(Math.max, "high") };
}
