// Colours of labels, which come with the page, and of measures. People with every kind of colour blindness can tell
// them apart. They are those of `cleft render`: see src/io/render/colour_scale.cpp.

// From poor to good: red over pale yellow to blue. From small to large: lighter and lighter.
const kPoorToGood = [
    [165, 15, 40],
    [233, 112, 56],
    [251, 235, 170],
    [135, 190, 225],
    [45, 90, 170],
];
const kSmallToLarge = [
    [52, 42, 118],
    [38, 100, 150],
    [52, 158, 152],
    [146, 208, 132],
    [252, 238, 160],
];

const mixed = (a, b, share) => a.map((x, i) => Math.round(x + share * (b[i] - x)));

function shadeOf(ramp, share) {
    const at = clamp(share, 0, 1) * (ramp.length - 1);
    const below = Math.min(Math.floor(at), ramp.length - 2);
    return mixed(ramp[below], ramp[below + 1], at - below);
}

const cssColour = ([r, g, b]) => `rgb(${r} ${g} ${b})`;
// As the bytes of a vertex; which edges of the triangle are drawn goes into the fourth byte.
const packedColour = ([r, g, b]) => (r | (g << 8) | (b << 16)) >>> 0;

// `share` is the place of a value between the ends of the ramp. None has a greater least angle than the regular
// tetrahedron, whose angles are 70.5 degrees.
function scaleOf(by, meshes, unit) {
    if (by === "angle")
        return { title: "Least dihedral angle, degrees", ramp: kPoorToGood, share: (x) => x / 70, ticks: [0, 35, 70] };
    if (by === "ratio") {
        const ramp = [...kPoorToGood].reverse();
        return { title: "Radius ratio", ramp, share: (x) => (x - 1) / 3, ticks: [1, 2, 3, 4] };
    }
    const [low, high] = rangeOfSizes(meshes);
    // Sizes of a uniform mesh differ by the rounding of coordinates, which is nothing to show.
    if (high - low <= 1e-6 * high + Math.max(...meshes.map(({ closeness }) => closeness)))
        return {
            title: "Mean edge: all tetrahedra have one size",
            ramp: Array(2).fill(shadeOf(kSmallToLarge, 0.5)),
            share: () => 0.5,
            ticks: ["", unit * low, ""],
        };
    // Sizes differ by factors.
    const share = (x) => Math.log(x / low) / Math.log(high / low);
    return {
        title: "Mean edge",
        ramp: kSmallToLarge,
        share,
        ticks: [low, Math.sqrt(low * high), high].map((x) => unit * x),
    };
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
    // Where nearly all have one size, the others are what there is to see.
    return at(0.99) > 1.001 * at(0.01) ? [at(0.01), at(0.99)] : [at(0), at(1)];
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
    const shades = Array.from({ length: kShades }, (_, i) => packedColour(shadeOf(scale.ramp, i / (kShades - 1))));
    const values = measured(mesh, by);
    for (let t = 0; t < colours.length; ++t)
        colours[t] = shades[Math.round(clamp(scale.share(values[t]), 0, 1) * (kShades - 1))];
    return colours;
}
