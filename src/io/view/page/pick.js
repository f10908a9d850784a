// What lies under the pointer: the nearest triangle of those that are drawn.

// How far along the ray it meets the triangle, or infinity. By Möller and Trumbore.
function meets(ray, a, b, c) {
    const [ab, ac] = [minus(b, a), minus(c, a)];
    const p = cross(ray.way, ac);
    const det = dot(ab, p);
    if (det === 0) return Infinity;
    const s = minus(ray.from, a);
    const u = dot(s, p) / det;
    if (u < 0 || u > 1) return Infinity;
    const q = cross(s, ab);
    const v = dot(ray.way, q) / det;
    if (v < 0 || u + v > 1) return Infinity;
    const far = dot(ac, q) / det;
    return far > 0 ? far : Infinity;
}

// `room` has vertices of triangles, of which triangle i belongs to the tetrahedron owner(i).
function nearest(ray, room, plane, owner, best) {
    const corner = (at) => [room.places[at], room.places[at + 1], room.places[at + 2]];
    for (let i = 0; i < room.triangles; ++i) {
        const far = meets(ray, corner(12 * i), corner(12 * i + 4), corner(12 * i + 8));
        if (far >= best.far) continue;
        const place = plus(ray.from, times(far, ray.way));
        // Within rounding: the flat cut itself lies in the plane.
        if (plane && dot(plane.normal, place) < plane.offset - 1e-6 * Math.abs(far)) continue;
        best = { far, place, tet: owner(i) };
    }
    return best;
}
