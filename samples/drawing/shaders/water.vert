// SPDX-License-Identifier: MIT
layout(location = 0) in vec3 position;
uniform vec4 waves[3];                   // wave number times direction (x, z), phase with time, amplitude
out vec3 at;
out vec2 slope;
void main() {
    at = vec3(position.x, 0.0, position.z);
    slope = vec2(0.0);
    float calm = 1.0 - smoothstep(8.0, 12.0, length(position.xz)); // beyond the mesh there is one large face
    for (int i = 0; i < 3; ++i) {
        float turn = dot(waves[i].xy, position.xz) + waves[i].z;
        at.y += calm * waves[i].w * cos(turn);
        slope -= calm * waves[i].w * sin(turn) * waves[i].xy;
    }
    gl_Position = to_clip * vec4(at, 1.0);
}
