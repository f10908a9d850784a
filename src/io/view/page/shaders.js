// Two programs: triangles with their edges, and one tetrahedron that stands out.

const kTriangleVertices = `#version 300 es
precision highp float;
layout(location = 0) in vec3 place;
layout(location = 1) in vec4 colour;
uniform mat4 camera;
flat out vec3 tint;
out vec3 corner, at;
void main() {
  ivec3 edges = ivec3(int(colour.a * 255.0 + 0.5)) & ivec3(1, 2, 4);
  // 1 at the own corner. An edge that is not drawn is never near.
  corner = vec3(ivec3(equal(ivec3(gl_VertexID % 3), ivec3(0, 1, 2))) | ivec3(equal(edges, ivec3(0))));
  tint = colour.rgb;
  at = place;
  gl_Position = camera * vec4(place, 1.0);
}`;

// The normal comes from the derivatives, so flat faces need none. Edges of triangles that are smaller than some pixels
// would make everything black: they fade.
const kTriangleFragments = `#version 300 es
precision highp float;
flat in vec3 tint;
in vec3 corner, at;
uniform vec4 plane;
uniform vec3 light;
uniform float edges;
uniform vec3 edgeColour;
out vec4 shade;
void main() {
#ifdef CLIPPED
  if (dot(plane.xyz, at) < plane.w) discard;
#endif
  vec3 normal = normalize(cross(dFdx(at), dFdy(at)));
  vec3 colour = tint * (0.52 + 0.48 * abs(dot(normal, light)));
  if (edges > 0.0) {
    vec3 width = fwidth(corner);
    vec3 away = smoothstep(width * 0.2, width * 1.1, corner);
    vec3 fade = 1.0 - smoothstep(0.03, 0.5, width);
    vec3 lines = (1.0 - away) * fade;
    colour = mix(colour, edgeColour, max(max(lines.x, lines.y), lines.z) * edges);
  }
  shade = vec4(colour, 1.0);
}`;

const kMarkVertices = `#version 300 es
precision highp float;
layout(location = 0) in vec3 place;
uniform mat4 camera;
void main() { gl_Position = camera * vec4(place, 1.0); }`;

const kMarkFragments = `#version 300 es
precision highp float;
uniform vec4 colour;
out vec4 shade;
void main() { shade = colour; }`;

function compiled(gl, type, text) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader) ?? "no shader");
    return shader;
}

function linked(gl, vertices, fragments) {
    const program = gl.createProgram();
    gl.attachShader(program, compiled(gl, gl.VERTEX_SHADER, vertices));
    gl.attachShader(program, compiled(gl, gl.FRAGMENT_SHADER, fragments));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS))
        throw new Error(gl.getProgramInfoLog(program) ?? "no program");
    return program;
}

function clippedFragments() {
    return kTriangleFragments.replace("#version 300 es", "#version 300 es\n#define CLIPPED");
}
