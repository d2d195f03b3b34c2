// SPDX-License-Identifier: MIT
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in uvec2 body;      // its place in the batch, and its key
uniform samplerBuffer transforms;        // of each body three rows of four
out vec3 at, facing;
out vec2 across;
out float upper;                         // above 0 on the side of body +z
flat out vec4 lot;                       // four random numbers of this body

uint mixed(uint x) { x ^= x >> 16; x *= 0x7feb352du; x ^= x >> 15; x *= 0x846ca68bu; return x ^ (x >> 16); }

void main() {
    vec4 p = vec4(position, 1.0);
    int row = int(body.x) * 3;
    vec4 r0 = texelFetch(transforms, row), r1 = texelFetch(transforms, row + 1), r2 = texelFetch(transforms, row + 2);
    at = vec3(dot(r0, p), dot(r1, p), dot(r2, p));
    uint h = mixed(body.y * 0x9e3779b9u + 1u);
    at.y += 0.0004 * float(h >> 8) / 16777216.0; // sheets that lie in one plane would be drawn through each other
    facing = vec3(dot(r0.xyz, normal), dot(r1.xyz, normal), dot(r2.xyz, normal));
    across = uv;
    upper = normal.z;
    lot = vec4(h & 255u, (h >> 8) & 255u, (h >> 16) & 255u, h >> 24) / 255.0;
    gl_Position = to_clip * vec4(at, 1.0);
}
