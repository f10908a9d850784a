// Shapes of tetrahedra, for colours. Those of the worst ones come with the page, from numbers of double precision.

function cornersOf(mesh, tet) {
    return [0, 1, 2, 3].map((c) => {
        const p = 3 * mesh.tets[4 * tet + c];
        return [mesh.positions[p], mesh.positions[p + 1], mesh.positions[p + 2]];
    });
}

function volumeOf([a, b, c, d]) {
    return dot(minus(b, a), cross(minus(c, a), minus(d, a))) / 6;
}

// Normals of the four faces, whose lengths are twice the areas.
function normalsOf(p) {
    return kFaces.map(([a, b, c]) => cross(minus(p[b], p[a]), minus(p[c], p[a])));
}

// Of two faces with outer normals m and n, the angle inside is that between m and -n.
function anglesOf(corners) {
    const normals = normalsOf(corners);
    const angles = [];
    for (let i = 0; i < 4; ++i)
        for (let j = i + 1; j < 4; ++j) {
            const [m, n] = [normals[i], times(-1, normals[j])];
            angles.push(Math.atan2(norm(cross(m, n)), dot(m, n)) / kDegree);
        }
    return angles;
}

function leastAngle(corners) {
    return Math.min(...anglesOf(corners));
}

// As in docs/method.md: circumradius / (3 * inradius).
function radiusRatio(p) {
    const [a, b, c] = [minus(p[1], p[0]), minus(p[2], p[0]), minus(p[3], p[0])];
    const volume = Math.abs(dot(a, cross(b, c))) / 6;
    const area = normalsOf(p).reduce((sum, normal) => sum + norm(normal) / 2, 0);
    const n = plus(plus(times(dot(a, a), cross(b, c)), times(dot(b, b), cross(c, a))), times(dot(c, c), cross(a, b)));
    return norm(n) / (12 * volume) / ((9 * volume) / area);
}

// The edge of a regular tetrahedron of the same volume.
function sizeOf(corners) {
    return Math.cbrt(6 * Math.SQRT2 * Math.abs(volumeOf(corners)));
}

// A measure of each tetrahedron, computed when it is first asked for.
const kMeasures = { angle: leastAngle, ratio: radiusRatio, size: sizeOf };
function measured(mesh, name) {
    if (!mesh.measures[name]) {
        const values = new Float32Array(mesh.tetCount);
        for (let t = 0; t < mesh.tetCount; ++t) values[t] = kMeasures[name](cornersOf(mesh, t));
        mesh.measures[name] = values;
    }
    return mesh.measures[name];
}
