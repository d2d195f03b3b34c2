// SPDX-License-Identifier: MIT
in vec3 at, facing;
in vec4 tint;
out vec4 colour;
void main() {
    vec3 n = normalize(facing);
    float light = 0.45 + 0.55 * abs(dot(n, sun));
    colour = vec4(developed(1.5 * tint.rgb * light), tint.a);
}
