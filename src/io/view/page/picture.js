// Draws by WebGL 2: the surface, the flat cut, and the chosen tetrahedron.

// Without a graphics card each sample costs time that turning needs.
function drawsBySoftware() {
    const gl = document.createElement("canvas").getContext("webgl2");
    const info = gl?.getExtension("WEBGL_debug_renderer_info");
    const name = info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : "";
    gl?.getExtension("WEBGL_lose_context")?.loseContext();
    return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

class Picture {
    constructor(canvas, software) {
        // The buffer is kept for printing and for saving a picture. It hides what is behind it, as mixing costs time.
        this.gl = canvas.getContext("webgl2", { antialias: !software, preserveDrawingBuffer: true, alpha: false });
        if (!this.gl) throw new Error("this browser has no WebGL 2");
        this.canvas = canvas;
        this.software = software;
        this.make();
    }

    // Also after the browser took the context away.
    make() {
        const { gl } = this;
        this.plain = linked(gl, kTriangleVertices, kTriangleFragments);
        this.clipped = linked(gl, kTriangleVertices, clippedFragments());
        this.mark = linked(gl, kMarkVertices, kMarkFragments);
        this.surface = this.triangles();
        this.slice = this.triangles();
        this.chosen = this.corners();
        this.order = gl.createBuffer(); // of vertices; see facing.js
    }

    triangles() {
        const { gl } = this;
        const set = { array: gl.createVertexArray(), buffer: gl.createBuffer(), vertices: 0 };
        gl.bindVertexArray(set.array);
        gl.bindBuffer(gl.ARRAY_BUFFER, set.buffer);
        gl.enableVertexAttribArray(0);
        gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 16, 0);
        gl.enableVertexAttribArray(1);
        gl.vertexAttribPointer(1, 4, gl.UNSIGNED_BYTE, true, 16, 12);
        return set;
    }

    corners() {
        const { gl } = this;
        const set = { array: gl.createVertexArray(), buffer: gl.createBuffer(), vertices: 0 };
        gl.bindVertexArray(set.array);
        gl.bindBuffer(gl.ARRAY_BUFFER, set.buffer);
        gl.enableVertexAttribArray(0);
        gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
        return set;
    }

    fill(set, bytes, vertices) {
        this.gl.bindBuffer(this.gl.ARRAY_BUFFER, set.buffer);
        this.gl.bufferData(this.gl.ARRAY_BUFFER, bytes, this.gl.DYNAMIC_DRAW);
        set.vertices = vertices;
    }

    setTriangles(surface, slice) {
        this.fill(this.surface, surface.bytes, 3 * surface.triangles);
        this.fill(this.slice, slice.bytes, 3 * slice.triangles);
        if (!this.software) return;
        this.planes = planesOf(surface);
        this.facing = new Uint32Array(3 * surface.triangles);
    }

    // Its faces, then its edges; null: none is chosen.
    setChosen(corners) {
        const edges = [0, 1, 0, 2, 0, 3, 1, 2, 1, 3, 2, 3];
        const places = corners ? [...kFaces.flat(), ...edges].flatMap((c) => corners[c]) : [];
        this.fill(this.chosen, new Float32Array(places), places.length / 3);
    }

    resize(scale) {
        const width = Math.max(1, Math.round(this.canvas.clientWidth * scale));
        const height = Math.max(1, Math.round(this.canvas.clientHeight * scale));
        if (this.canvas.width === width && this.canvas.height === height) return;
        this.canvas.width = width;
        this.canvas.height = height;
    }

    use(program, camera, radius) {
        const { gl } = this;
        gl.useProgram(program);
        const place = (name) => gl.getUniformLocation(program, name);
        gl.uniformMatrix4fv(place("camera"), false, cameraMatrix(camera, this.aspect(), radius));
        return place;
    }

    aspect() {
        return this.canvas.clientWidth / Math.max(1, this.canvas.clientHeight);
    }

    drawTriangles(set, program, camera, settings) {
        const { gl } = this;
        if (set.vertices === 0) return;
        const place = this.use(program, camera, settings.radius);
        const { normal, offset } = settings.plane ?? { normal: [0, 0, 0], offset: 0 };
        gl.uniform4f(place("plane"), ...normal, offset);
        gl.uniform3f(place("light"), ...lightOf(camera));
        gl.uniform1f(place("edges"), settings.edges ? 0.6 : 0);
        gl.uniform3f(place("edgeColour"), ...settings.edgeColour);
        gl.bindVertexArray(set.array);
        if (this.software && set === this.surface) this.drawFacing(camera);
        else gl.drawArrays(gl.TRIANGLES, 0, set.vertices);
    }

    drawFacing(camera) {
        const { gl } = this;
        const count = putFacing(this.planes, cameraEye(camera), this.facing);
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, this.order);
        gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, this.facing.subarray(0, count), gl.STREAM_DRAW);
        gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 0);
    }

    drawChosen(camera, settings) {
        const { gl } = this;
        if (this.chosen.vertices === 0) return;
        const place = this.use(this.mark, camera, settings.radius);
        gl.bindVertexArray(this.chosen.array);
        gl.disable(gl.DEPTH_TEST);
        gl.enable(gl.BLEND);
        gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
        gl.uniform4f(place("colour"), 1, 0.1, 0.35, 0.45);
        gl.drawArrays(gl.TRIANGLES, 0, 12);
        gl.uniform4f(place("colour"), 0.75, 0, 0.2, 1);
        gl.drawArrays(gl.LINES, 12, 12);
        gl.disable(gl.BLEND);
    }

    draw(camera, settings) {
        const { gl } = this;
        this.resize(settings.scale);
        gl.viewport(0, 0, this.canvas.width, this.canvas.height);
        gl.clearColor(...settings.paper, 1);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
        gl.enable(gl.DEPTH_TEST);
        gl.enable(gl.CULL_FACE);
        this.drawTriangles(this.surface, settings.plane ? this.clipped : this.plain, camera, settings);
        gl.disable(gl.CULL_FACE);
        this.drawTriangles(this.slice, this.plain, camera, settings);
        this.drawChosen(camera, settings);
    }
}
