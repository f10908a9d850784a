// One mesh of the page: its arrays, and what follows from them.

const nextFrame = () => new Promise((resolve) => setTimeout(resolve));

function placed(data, steps, frame) {
    const positions = new Float32Array(steps.length);
    const low = frame.toPage(data.low);
    const step = data.step / frame.unit;
    for (let i = 0; i < steps.length; ++i) positions[i] = low[i % 3] + step * steps[i];
    return positions;
}

async function loadMesh(data, number, frame, say) {
    say("Unpacking");
    await nextFrame();
    const steps = await unpack(`points-${number}`, 3, false);
    const tets = await unpack(`tets-${number}`, 4, true);
    const materials = await unpack(`materials-${number}`, 1, false);
    const numbers = await unpack(`numbers-${number}`, 1, false);
    say("Finding faces");
    await nextFrame();
    const box = { low: frame.toPage(data.low), high: frame.toPage(data.high) };
    return {
        data,
        tets,
        materials,
        numbers,
        box,
        title: data.title,
        labels: data.labels,
        tetCount: tets.length / 4,
        positions: placed(data, steps, frame),
        neighbours: neighboursOf(tets, steps.length / 3),
        measures: {},
        // Coordinates are rounded to a step, and then to 32 bits.
        closeness: (4 * data.step) / frame.unit + 1e-6,
    };
}

// What is told of a tetrahedron that was picked, in the form of those that come with the page.
function describedTet(mesh, tet, frame) {
    const corners = cornersOf(mesh, tet);
    const angles = anglesOf(corners);
    return {
        tet: mesh.numbers ? mesh.numbers[tet] : tet,
        label: mesh.labels[mesh.materials[tet]].label,
        least_angle: Math.min(...angles),
        greatest_angle: Math.max(...angles),
        radius_ratio: radiusRatio(corners),
        volume: Math.abs(volumeOf(corners)) * frame.unit ** 3,
        corners: corners.flatMap((corner) => frame.toFile(corner)),
    };
}
