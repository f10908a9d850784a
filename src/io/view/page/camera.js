// The camera turns around a target on two angles, z up. All places are seen from the middle of the box.

const kOpening = 28 * kDegree; // of the height of a picture: little distortion, as a long lens has

function cameraAxes({ yaw, pitch }) {
    return {
        right: [-Math.sin(yaw), Math.cos(yaw), 0],
        // Not from a cross product with z, which has no direction when the camera looks along it.
        up: [-Math.sin(pitch) * Math.cos(yaw), -Math.sin(pitch) * Math.sin(yaw), Math.cos(pitch)],
        back: direction(yaw, pitch),
    };
}

function cameraEye(camera) {
    return plus(camera.target, times(camera.distance, direction(camera.yaw, camera.pitch)));
}

// Column by column, as WebGL has it.
function viewMatrix(camera) {
    const { right, up, back } = cameraAxes(camera);
    const eye = cameraEye(camera);
    const column = (i) => [right[i], up[i], back[i], 0];
    return new Float32Array([
        ...column(0),
        ...column(1),
        ...column(2),
        -dot(right, eye),
        -dot(up, eye),
        -dot(back, eye),
        1,
    ]);
}

function projectionMatrix(camera, aspect, radius) {
    const focal = 1 / Math.tan(kOpening / 2);
    const reach = norm(camera.target) + radius;
    // The near plane is as far as the mesh allows, which keeps the depths of small meshes apart.
    const near = Math.max(camera.distance - reach, camera.distance / 1000);
    const far = camera.distance + reach;
    const depth = near - far;
    return new Float32Array([
        focal / aspect,
        0,
        0,
        0,
        0,
        focal,
        0,
        0,
        0,
        0,
        (near + far) / depth,
        -1,
        0,
        0,
        (2 * near * far) / depth,
        0,
    ]);
}

// The distance from which a ball fills a picture.
function distanceFor(radius, aspect) {
    return radius / Math.sin(kOpening / 2) / Math.min(1, aspect);
}

// The least distance from which all of some points lie in a picture; isThere[i] tells whether point i is one of them.
function distanceToFit(camera, aspect, positions, isThere) {
    const kFilled = 0.92; // of the picture
    const { right, up, back } = cameraAxes(camera);
    const high = kFilled * Math.tan(kOpening / 2);
    const wide = high * aspect;
    let distance = 0;
    for (let p = 0, i = 0; p < isThere.length; ++p, i += 3) {
        if (!isThere[p]) continue;
        const from = minus([positions[i], positions[i + 1], positions[i + 2]], camera.target);
        const aside = Math.max(Math.abs(dot(from, right)) / wide, Math.abs(dot(from, up)) / high);
        distance = Math.max(distance, dot(from, back) + aside);
    }
    return distance;
}

// Both in one, so that a vertex costs one product.
function cameraMatrix(camera, aspect, radius) {
    const [a, b] = [projectionMatrix(camera, aspect, radius), viewMatrix(camera)];
    const product = new Float32Array(16);
    for (let column = 0; column < 4; ++column)
        for (let row = 0; row < 4; ++row)
            for (let k = 0; k < 4; ++k) product[4 * column + row] += a[4 * k + row] * b[4 * column + k];
    return product;
}

// From over the left shoulder of who looks, so that faces which look at them are not all alike.
function lightOf(camera) {
    const { right, up, back } = cameraAxes(camera);
    const light = plus(plus(times(-0.35, right), times(0.45, up)), times(0.82, back));
    return times(1 / norm(light), light);
}

// A place in the picture, both from -1 to 1; null behind the camera.
function projected(camera, aspect, place) {
    const { right, up, back } = cameraAxes(camera);
    const from = minus(place, cameraEye(camera));
    const depth = -dot(from, back);
    if (depth <= 0) return null;
    const scale = 1 / (depth * Math.tan(kOpening / 2));
    return [(dot(from, right) * scale) / aspect, dot(from, up) * scale];
}

// The ray through a place of the picture.
function rayThrough(camera, aspect, x, y) {
    const { right, up, back } = cameraAxes(camera);
    const half = Math.tan(kOpening / 2);
    const way = minus(plus(times(x * half * aspect, right), times(y * half, up)), back);
    return { from: cameraEye(camera), way };
}

function turn(camera, right, up) {
    camera.yaw -= right;
    camera.pitch = clamp(camera.pitch + up, -Math.PI / 2, Math.PI / 2);
}

// In heights of the picture.
function pan(camera, right, up) {
    const height = 2 * camera.distance * Math.tan(kOpening / 2);
    const axes = cameraAxes(camera);
    camera.target = plus(camera.target, plus(times(-right * height, axes.right), times(-up * height, axes.up)));
}

function zoom(camera, factor, radius) {
    camera.distance = clamp(camera.distance * factor, radius / 5000, radius * 20);
}
