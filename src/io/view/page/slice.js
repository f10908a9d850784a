// A flat cut: the polygons in which the plane meets the tetrahedra. One corner on a side gives a triangle, two on each
// give four corners, which are two triangles without an edge between them.

// Corners of the polygon in order: pairs of corners of the tetrahedron whose edge the plane meets.
function polygonOf(signs) {
    const here = [0, 1, 2, 3].filter((c) => signs[c]);
    const there = [0, 1, 2, 3].filter((c) => !signs[c]);
    if (here.length === 2)
        return [
            [here[0], there[0]],
            [here[0], there[1]],
            [here[1], there[1]],
            [here[1], there[0]],
        ];
    const [alone, others] = here.length === 1 ? [here[0], there] : [there[0], here];
    return others.map((c) => [alone, c]);
}
// By the bits of the corners that are on the side that stays.
const kPolygons = Array.from({ length: 16 }, (_, bits) =>
    bits === 0 || bits === 15 ? [] : polygonOf([0, 1, 2, 3].map((c) => (bits >> c) & 1)),
);

function sidesOf(mesh, distances, tet) {
    const { tets } = mesh;
    let bits = 0;
    for (let c = 0; c < 4; ++c) if (distances[tets[4 * tet + c]] >= 0) bits |= 1 << c;
    return bits;
}

function slicedTets(mesh, kept, distances) {
    const found = [];
    for (let t = 0; t < kept.length; ++t) if (kept[t] && kPolygons[sidesOf(mesh, distances, t)].length) found.push(t);
    return found;
}

function putCrossing(mesh, distances, tet, [from, to], room, at) {
    const a = mesh.tets[4 * tet + from];
    const b = mesh.tets[4 * tet + to];
    const share = distances[a] / (distances[a] - distances[b]);
    for (let axis = 0; axis < 3; ++axis) {
        const start = mesh.positions[3 * a + axis];
        room.places[at + axis] = start + share * (mesh.positions[3 * b + axis] - start);
    }
}

// Vertices of the cut, and the tetrahedron of each triangle.
function sliceVertices(mesh, kept, distances, colours) {
    const cut = slicedTets(mesh, kept, distances);
    const room = vertexRoom(cut.reduce((sum, t) => sum + kPolygons[sidesOf(mesh, distances, t)].length - 2, 0));
    const owners = new Uint32Array(room.triangles);
    let triangle = 0;
    for (const tet of cut) {
        const polygon = kPolygons[sidesOf(mesh, distances, tet)];
        for (let second = 1; second + 1 < polygon.length; ++second, ++triangle) {
            // Bit i is the edge opposite to vertex i. One from the first corner across the polygon is none.
            const edges = 1 | (second + 2 === polygon.length ? 2 : 0) | (second === 1 ? 4 : 0);
            owners[triangle] = tet;
            [polygon[0], polygon[second], polygon[second + 1]].forEach((crossing, c) => {
                const at = 12 * triangle + 4 * c;
                putCrossing(mesh, distances, tet, crossing, room, at);
                room.colours[at + 3] = (colours[tet] | (edges << 24)) >>> 0;
            });
        }
    }
    return { ...room, owners };
}
