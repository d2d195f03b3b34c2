// SPDX-License-Identifier: MIT
in vec3 direction;
out vec4 colour;

float wood(float a, float seed) { // outline of trees along the horizon
    float h = 0.0;
    for (int k = 0; k < 4; ++k) h += exp2(-0.9 * float(k)) * noise2(vec2(a * 9.0 * exp2(float(k)) + seed, seed));
    return h / 2.0;
}

void main() {
    vec3 d = normalize(direction);
    vec3 c = sky(d);
    c += vec3(30.0, 26.0, 20.0) * smoothstep(0.99985, 0.99995, dot(d, sun));
    if (d.y > 0.0) {
        vec2 p = d.xz / (d.y + 0.18);
        float cloud = 0.5 * noise2(p * 1.3 + 3.0) + 0.28 * noise2(p * 2.9) + 0.14 * noise2(p * 6.1) + 0.08 * noise2(p * 13.0);
        float dense = smoothstep(0.48, 0.78, cloud) * smoothstep(0.0, 0.25, d.y);
        c = mix(c, vec3(1.15, 1.10, 1.04) * (0.75 + 0.5 * noise2(p * 2.3 + 9.0)), 0.75 * dense);
    }
    float a = atan(d.x, -d.z);
    for (int k = 0; k < 3; ++k) { // from the hills to the near trees
        float near = float(k) / 2.0, top = mix(0.055, 0.050, near) * (0.35 + 1.1 * wood(a + 0.7 * float(k), 17.0 * float(k) + 3.0));
        vec2 q = vec2(a, 1.3 * d.y) * mix(150.0, 75.0, near) + 5.0 * float(k);
        float leaves = 0.5 * noise2(q) + 0.3 * noise2(2.3 * q + 7.0) + 0.2 * noise2(5.1 * q);
        vec3 green = mix(vec3(0.030, 0.045, 0.018), vec3(0.13, 0.10, 0.025), leaves);
        vec3 seen = through_air(green * (1.0 + 1.3 * max(dot(normalize(vec3(d.x, 0.0, d.z)), sun), 0.0)), d, mix(95.0, 34.0, near));
        seen = mix(through_air(seen, d, 60.0), seen, smoothstep(-0.01, 0.035, d.y)); // mist lies low
        c = mix(c, seen, smoothstep(top + 0.004, top - 0.002, d.y));
    }
    colour = vec4(developed(c), 1.0);
}
