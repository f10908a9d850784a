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

// As in docs/method.md: circumradius / (3 * inradius).
function radiusRatio(p) {
    const [a, b, c] = [minus(p[1], p[0]), minus(p[2], p[0]), minus(p[3], p[0])];
    const volume = Math.abs(dot(a, cross(b, c))) / 6;
    const area = normalsOf(p).reduce((sum, normal) => sum + norm(normal) / 2, 0);
    const n = plus(plus(times(dot(a, a), cross(b, c)), times(dot(b, b), cross(c, a))), times(dot(c, c), cross(a, b)));
    return norm(n) / (12 * volume) / ((9 * volume) / area);
}

function meanEdge([a, b, c, d]) {
    const edges = [minus(b, a), minus(c, a), minus(d, a), minus(c, b), minus(d, b), minus(d, c)];
    return edges.reduce((sum, edge) => sum + norm(edge), 0) / 6;
}

// The least angle of each tetrahedron. There may be millions, so this does without vectors.
// The cosine of the angle inside between two faces is that between the one outer normal and the other turned round.
function leastAngles({ tets, positions }) {
    const angles = new Float32Array(tets.length / 4);
    const normals = new Float64Array(12);
    for (let t = 0; t < angles.length; ++t) {
        for (let f = 0; f < 4; ++f) putUnitNormal(tets, positions, t, kFaces[f], normals, 3 * f);
        let greatest = -1;
        for (let i = 0; i < 9; i += 3)
            for (let j = i + 3; j < 12; j += 3) {
                let product = normals[i] * normals[j];
                product += normals[i + 1] * normals[j + 1] + normals[i + 2] * normals[j + 2];
                if (-product > greatest) greatest = -product;
            }
        angles[t] = Math.acos(Math.min(1, greatest)) / kDegree;
    }
    return angles;
}

function putUnitNormal(tets, positions, tet, face, normals, at) {
    const a = 3 * tets[4 * tet + face[0]];
    const b = 3 * tets[4 * tet + face[1]];
    const c = 3 * tets[4 * tet + face[2]];
    const ux = positions[b] - positions[a];
    const uy = positions[b + 1] - positions[a + 1];
    const uz = positions[b + 2] - positions[a + 2];
    const vx = positions[c] - positions[a];
    const vy = positions[c + 1] - positions[a + 1];
    const vz = positions[c + 2] - positions[a + 2];
    const x = uy * vz - uz * vy;
    const y = uz * vx - ux * vz;
    const z = ux * vy - uy * vx;
    const length = Math.sqrt(x * x + y * y + z * z) || 1;
    normals[at] = x / length;
    normals[at + 1] = y / length;
    normals[at + 2] = z / length;
}

function eachTet(mesh, measure) {
    const values = new Float32Array(mesh.tetCount);
    for (let t = 0; t < mesh.tetCount; ++t) values[t] = measure(cornersOf(mesh, t));
    return values;
}

// A measure of each tetrahedron, computed when it is first asked for.
const kMeasures = {
    angle: leastAngles,
    ratio: (mesh) => eachTet(mesh, radiusRatio),
    size: (mesh) => eachTet(mesh, meanEdge),
};
function measured(mesh, name) {
    mesh.measures[name] ??= kMeasures[name](mesh);
    return mesh.measures[name];
}
