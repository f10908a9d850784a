// Which tetrahedra share a face. Face f of a tetrahedron lies opposite to its corner f, and its corners turn to the
// left, seen from outside.

const kFaces = [
    [1, 2, 3],
    [0, 3, 2],
    [0, 1, 3],
    [0, 2, 1],
];
const kNone = -1;

// Faces by their least corner: where those of each point begin, and their codes (4 * tetrahedron + face).
function facesByPoint(tets, pointCount) {
    const starts = new Uint32Array(pointCount + 2);
    const least = new Int32Array(tets.length);
    for (let code = 0; code < tets.length; ++code) {
        const face = kFaces[code & 3];
        const first = code & ~3;
        least[code] = Math.min(tets[first + face[0]], tets[first + face[1]], tets[first + face[2]]);
        ++starts[least[code] + 2];
    }
    for (let p = 2; p < starts.length; ++p) starts[p] += starts[p - 1];
    const codes = new Uint32Array(tets.length);
    for (let code = 0; code < tets.length; ++code) codes[starts[least[code] + 1]++] = code;
    return { starts, codes };
}

// The tetrahedron behind each face, or kNone. If a broken mesh has a face more than twice, the first two are a pair.
function neighboursOf(tets, pointCount) {
    const { starts, codes } = facesByPoint(tets, pointCount);
    const neighbours = new Int32Array(tets.length).fill(kNone);
    // Two numbers that tell faces with one least corner apart: the sum and the greatest of their corners.
    const sums = new Float64Array(tets.length);
    const greatest = new Int32Array(tets.length);
    for (let i = 0; i < codes.length; ++i) {
        const face = kFaces[codes[i] & 3];
        const first = codes[i] & ~3;
        const [a, b, c] = [tets[first + face[0]], tets[first + face[1]], tets[first + face[2]]];
        sums[i] = a + b + c;
        greatest[i] = Math.max(a, b, c);
    }
    for (let p = 0; p < pointCount; ++p)
        for (let i = starts[p]; i < starts[p + 1]; ++i) {
            if (neighbours[codes[i]] !== kNone) continue;
            for (let j = i + 1; j < starts[p + 1]; ++j)
                if (sums[j] === sums[i] && greatest[j] === greatest[i] && neighbours[codes[j]] === kNone) {
                    neighbours[codes[i]] = codes[j] >> 2;
                    neighbours[codes[j]] = codes[i] >> 2;
                    break;
                }
        }
    return neighbours;
}
