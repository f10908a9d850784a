// One mesh of the page: its arrays, and what follows from them.

const nextFrame = () => new Promise((resolve) => setTimeout(resolve));

function placed(data, steps, origin) {
    const positions = new Float32Array(steps.length);
    for (let i = 0; i < steps.length; ++i) positions[i] = data.low[i % 3] - origin[i % 3] + data.step * steps[i];
    return positions;
}

// `origin` is where the page has its zero, so that places far from that of the file keep their digits.
async function loadMesh(data, number, origin, say) {
    say("Unpacking");
    await nextFrame();
    const steps = await unpack(`points-${number}`, 3, false);
    const tets = await unpack(`tets-${number}`, 4, true);
    const materials = await unpack(`materials-${number}`, 1, false);
    const numbers = await unpack(`numbers-${number}`, 1, false);
    say("Finding faces");
    await nextFrame();
    const box = { low: minus(data.low, origin), high: minus(data.high, origin) };
    return {
        data,
        tets,
        materials,
        numbers,
        box,
        title: data.title,
        labels: data.labels,
        tetCount: tets.length / 4,
        positions: placed(data, steps, origin),
        neighbours: neighboursOf(tets, steps.length / 3),
        measures: {},
        // Coordinates are rounded to a step, and then to 32 bits.
        closeness: 4 * data.step + 1e-6 * norm(minus(data.high, data.low)),
    };
}

// What is told of a tetrahedron that was picked, in the form of those that come with the page.
function describedTet(mesh, tet, origin) {
    const corners = cornersOf(mesh, tet);
    const angles = anglesOf(corners);
    return {
        tet: mesh.numbers ? mesh.numbers[tet] : tet,
        label: mesh.labels[mesh.materials[tet]].label,
        least_angle: Math.min(...angles),
        greatest_angle: Math.max(...angles),
        radius_ratio: radiusRatio(corners),
        volume: Math.abs(volumeOf(corners)),
        corners: corners.flatMap((corner) => plus(corner, origin)),
    };
}
