// Which faces are drawn: the boundary of what is kept. All that lies inside it cannot be seen, so a million tetrahedra
// are a hundred thousand triangles.

// 1 for each tetrahedron whose material is shown. With a crinkle cut also its centre must be on the side that stays.
function keptTets(mesh, state, distances) {
    const { tets, materials } = mesh;
    const shown = mesh.labels.map((row) => (state.hidden.has(row.label) ? 0 : 1));
    const kept = new Uint8Array(mesh.tetCount);
    for (let t = 0; t < kept.length; ++t) kept[t] = shown[materials[t]];
    if (distances && !state.cut.flat)
        for (let t = 0, i = 0; t < kept.length; ++t, i += 4)
            if (distances[tets[i]] + distances[tets[i + 1]] + distances[tets[i + 2]] + distances[tets[i + 3]] < 0)
                kept[t] = 0;
    return kept;
}

// Is a face of the hull in a side of the box? Such a side is no surface of a material.
function isOnBox(mesh, code) {
    const corners = kFaces[code & 3].map((c) => 3 * mesh.tets[(code & ~3) + c]);
    for (let axis = 0; axis < 3; ++axis)
        for (const side of [mesh.box.low[axis], mesh.box.high[axis]])
            if (corners.every((p) => Math.abs(mesh.positions[p + axis] - side) <= mesh.closeness)) return true;
    return false;
}

// Codes of the faces between kept tetrahedra and the rest.
function boundaryFaces(mesh, kept) {
    const { neighbours } = mesh;
    const codes = [];
    for (let t = 0; t < kept.length; ++t) {
        if (!kept[t]) continue;
        for (let code = 4 * t; code < 4 * t + 4; ++code)
            if (neighbours[code] === kNone || !kept[neighbours[code]]) codes.push(code);
    }
    return codes;
}

// Codes of the faces of kept tetrahedra where another material begins, or nothing inside the box.
function interfaceFaces(mesh, kept) {
    const { neighbours, materials } = mesh;
    const codes = [];
    for (let t = 0; t < kept.length; ++t) {
        if (!kept[t]) continue;
        for (let code = 4 * t; code < 4 * t + 4; ++code) {
            const behind = neighbours[code];
            if (behind === kNone ? !isOnBox(mesh, code) : materials[behind] !== materials[t]) codes.push(code);
        }
    }
    return codes;
}

// A vertex has 16 bytes: a place, and a colour with the edges to be drawn.
const kAllEdges = 7;
function vertexRoom(triangles) {
    const bytes = new ArrayBuffer(48 * triangles);
    return { bytes, places: new Float32Array(bytes), colours: new Uint32Array(bytes), triangles };
}

function faceVertices(mesh, codes, colours) {
    const { tets, positions } = mesh;
    const room = vertexRoom(codes.length);
    let at = 0;
    for (const code of codes) {
        const face = kFaces[code & 3];
        const colour = (colours[code >> 2] | (kAllEdges << 24)) >>> 0;
        for (let c = 0; c < 3; ++c, at += 4) {
            const p = 3 * tets[(code & ~3) + face[c]];
            room.places[at] = positions[p];
            room.places[at + 1] = positions[p + 1];
            room.places[at + 2] = positions[p + 2];
            room.colours[at + 3] = colour;
        }
    }
    return room;
}
