// SPDX-License-Identifier: MIT
uniform mat3 corners;          // right, up and ahead, as long as the picture's half sides at distance 1
out vec3 direction;
void main() {
    vec2 p = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    direction = corners * vec3(p, 1.0);
    gl_Position = vec4(p, 1.0, 1.0);
}
