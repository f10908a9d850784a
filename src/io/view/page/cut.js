// The plane that cuts the mesh, and the side of it that stays.

const kAxes = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

function cutNormal(cut) {
    return kAxes[cut.kind] ?? direction(cut.yaw, cut.pitch);
}

// How far the box reaches along a direction.
function cutRange(box, normal) {
    let [low, high] = [0, 0];
    for (let axis = 0; axis < 3; ++axis) {
        const ends = [normal[axis] * box.low[axis], normal[axis] * box.high[axis]];
        low += Math.min(...ends);
        high += Math.max(...ends);
    }
    return [low, high];
}

// Where dot(normal, x) >= offset stays. Null: nothing is cut.
function cutPlane(cut, box) {
    if (cut.kind === "none") return null;
    const normal = cutNormal(cut);
    const [low, high] = cutRange(box, normal);
    const offset = low + cut.at * (high - low);
    return cut.flipped ? { normal: times(-1, normal), offset: -offset } : { normal, offset };
}

// The plane through a place, as a position of the slider.
function cutThrough(cut, box, place) {
    const normal = cutNormal(cut);
    const [low, high] = cutRange(box, normal);
    return high > low ? clamp((dot(normal, place) - low) / (high - low), 0, 1) : 0.5;
}

// Distances of all points from the plane, positive where they stay.
function distancesFrom(mesh, plane) {
    const { positions } = mesh;
    const [a, b, c] = plane.normal;
    const distances = new Float32Array(positions.length / 3);
    for (let p = 0, i = 0; p < distances.length; ++p, i += 3)
        distances[p] = a * positions[i] + b * positions[i + 1] + c * positions[i + 2] - plane.offset;
    return distances;
}
