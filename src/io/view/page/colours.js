// Colours of labels, which come with the page, and of measures: viridis, whose lightness rises from end to end, so that
// people with every kind of colour blindness can tell values apart.

const kViridis = [
    [68, 1, 84],
    [71, 44, 122],
    [59, 81, 139],
    [44, 113, 142],
    [33, 144, 141],
    [39, 173, 129],
    [92, 200, 99],
    [170, 220, 50],
    [253, 231, 37],
];

const mixed = (a, b, share) => a.map((x, i) => Math.round(x + share * (b[i] - x)));

function viridis(share) {
    const at = clamp(share, 0, 1) * (kViridis.length - 1);
    const below = Math.min(Math.floor(at), kViridis.length - 2);
    return mixed(kViridis[below], kViridis[below + 1], at - below);
}

const cssColour = ([r, g, b]) => `rgb(${r} ${g} ${b})`;
// As the bytes of a vertex; which edges of the triangle are drawn goes into the fourth byte.
const packedColour = ([r, g, b]) => (r | (g << 8) | (b << 16)) >>> 0;

// What is bad is bright: it stands out from the rest, which is dark. `share` maps a value to 0 ... 1.
function scaleOf(by, meshes, goal) {
    if (by === "angle") {
        const high = Math.max(goal, 5) * 2;
        return {
            title: "Least dihedral angle, degrees",
            low: 0,
            high,
            share: (x) => 1 - x / high,
            ticks: [0, goal, high],
        };
    }
    if (by === "ratio")
        return { title: "Radius ratio", low: 1, high: 4, share: (x) => (x - 1) / 3, ticks: [1, 2, 3, 4] };
    const [low, high] = rangeOfSizes(meshes);
    const share = (x) => (high > low ? Math.log(x / low) / Math.log(high / low) : 0.5);
    return { title: "Size (edge of a regular one)", low, high, share, ticks: [low, Math.sqrt(low * high), high] };
}

// Without the outermost hundredth at both ends, which would leave one colour for all the rest.
function rangeOfSizes(meshes) {
    const sample = [];
    for (const mesh of meshes) {
        const sizes = measured(mesh, "size");
        const step = Math.max(1, Math.floor(sizes.length / 20000));
        for (let t = 0; t < sizes.length; t += step) if (sizes[t] > 0) sample.push(sizes[t]);
    }
    sample.sort((a, b) => a - b);
    const at = (share) => sample[Math.round(share * (sample.length - 1))] ?? 1;
    return [at(0.01), at(0.99)];
}

// The colour of each tetrahedron.
function coloursOf(mesh, by, scale) {
    const colours = new Uint32Array(mesh.tetCount);
    if (by === "material") {
        const ofMaterial = mesh.labels.map((row) => packedColour(row.colour));
        for (let t = 0; t < colours.length; ++t) colours[t] = ofMaterial[mesh.materials[t]];
        return colours;
    }
    const kShades = 256;
    const shades = Array.from({ length: kShades }, (_, i) => packedColour(viridis(i / (kShades - 1))));
    const values = measured(mesh, by);
    for (let t = 0; t < colours.length; ++t)
        colours[t] = shades[Math.round(clamp(scale.share(values[t]), 0, 1) * (kShades - 1))];
    return colours;
}
