// Faces that look at the eye. A graphics card finds them by itself. Where there is none, each corner of a face costs
// time, and half of the faces look away.

// The plane of each triangle: its normal, and how far it is along that. Normals have no length of their own.
function planesOf({ places, triangles }) {
    const planes = new Float32Array(4 * triangles);
    for (let i = 0; i < triangles; ++i) {
        const at = 12 * i;
        const [ux, uy, uz] = [0, 1, 2].map((axis) => places[at + 4 + axis] - places[at + axis]);
        const [vx, vy, vz] = [0, 1, 2].map((axis) => places[at + 8 + axis] - places[at + axis]);
        planes[4 * i] = uy * vz - uz * vy;
        planes[4 * i + 1] = uz * vx - ux * vz;
        planes[4 * i + 2] = ux * vy - uy * vx;
        for (let axis = 0; axis < 3; ++axis) planes[4 * i + 3] += planes[4 * i + axis] * places[at + axis];
    }
    return planes;
}

// Puts the vertices of the triangles that look at the eye into `vertices`, and returns their number.
function putFacing(planes, [x, y, z], vertices) {
    let count = 0;
    for (let i = 0, vertex = 0; i < planes.length; i += 4, vertex += 3) {
        if (planes[i] * x + planes[i + 1] * y + planes[i + 2] * z <= planes[i + 3]) continue;
        vertices[count++] = vertex;
        vertices[count++] = vertex + 1;
        vertices[count++] = vertex + 2;
    }
    return count;
}
