// What the user has chosen: the same for all views of the page.

function firstState(meshes) {
    const state = {
        camera: { yaw: 0, pitch: 0, distance: 1, target: [0, 0, 0] },
        cut: { kind: "y", at: 0.5, flipped: false, flat: false, yaw: 30 * kDegree, pitch: 20 * kDegree },
        hidden: new Set(),
        interfaces: false,
        edges: true,
        by: "material",
        marks: false,
        chosen: null, // { view, tet }
    };
    const around = meshes.map(surroundingLabel);
    // In all meshes or in none: a label is shown or hidden in the page.
    if (around[0] !== null && around.every((label) => label === around[0])) state.hidden.add(around[0]);
    return state;
}

// The label that alone has the sides of the box, if others are inside. All else is hidden behind it.
function surroundingLabel(mesh) {
    if (mesh.labels.length < 2) return null;
    let found = null;
    for (let code = 0; code < mesh.neighbours.length; ++code) {
        // Where the page has a part of the mesh, most faces without a neighbour are no hull.
        if (mesh.neighbours[code] !== kNone || !isOnBox(mesh, code)) continue;
        const { label } = mesh.labels[mesh.materials[code >> 2]];
        if (found !== null && found !== label) return null;
        found = label;
    }
    return found;
}

// The box of what is shown, without the cut; of everything if nothing is.
function boxOfShown(meshes, hidden) {
    const box = { low: [Infinity, Infinity, Infinity], high: [-Infinity, -Infinity, -Infinity] };
    for (const mesh of meshes) {
        const shown = mesh.labels.map((row) => !hidden.has(row.label));
        for (let i = 0; i < mesh.tets.length; ++i) {
            if (!shown[mesh.materials[i >> 2]]) continue;
            for (let axis = 0, p = 3 * mesh.tets[i]; axis < 3; ++axis) {
                const x = mesh.positions[p + axis];
                if (x < box.low[axis]) box.low[axis] = x;
                if (x > box.high[axis]) box.high[axis] = x;
            }
        }
    }
    return box.low[0] <= box.high[0] ? box : boxOfAll(meshes);
}

function boxOfAll(meshes) {
    const pick = (choose, end) => [0, 1, 2].map((axis) => choose(...meshes.map((mesh) => mesh.box[end][axis])));
    return { low: pick(Math.min, "low"), high: pick(Math.max, "high") };
}
