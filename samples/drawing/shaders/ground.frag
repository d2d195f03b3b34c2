// SPDX-License-Identifier: MIT
in vec3 at, facing;
uniform int surface;                     // 0 lawn, 1 paving, 2 boards, 3 sand
out vec4 colour;

vec3 lawn(vec2 p, inout vec3 n) {
    vec2 q = mat2(0.8, 0.6, -0.6, 0.8) * p;
    float fine = grain(p * vec2(430.0, 170.0)) * 0.5 + grain(q * vec2(190.0, 460.0)) * 0.5;
    float blades = 0.30 * fine + 0.70 * (0.38 * grain(p * vec2(190.0, 70.0)) + 0.34 * grain(q * vec2(75.0, 210.0)) + 0.28 * grain(p * 37.0));
    float patches = 0.45 * grain(p * 5.3) + 0.35 * grain(p * 1.7 + 3.0) + 0.20 * noise2(p * 0.31);
    vec3 c = mix(vec3(0.020, 0.040, 0.008), vec3(0.110, 0.165, 0.034), blades * blades * 1.5);
    c = mix(c, c * vec3(1.5, 1.15, 0.7), smoothstep(0.40, 0.75, patches));
    n = normalize(n + 0.5 * vec3(grain(p * 60.0) - 0.5, 0.0, grain(p * 60.0 + 31.0) - 0.5));
    return mix(c, vec3(0.090, 0.066, 0.036) * (0.6 + 0.8 * blades), smoothstep(0.60, 0.78, patches) * 0.8);
}

// 1 in the gap around a tile; `own`: position from the tile's middle; w: m per pixel.
float joint(vec2 own, vec2 half_size, float width, vec2 w) {
    vec2 d = half_size - abs(own);
    vec2 gap = clamp((width - d) / w + 0.5, 0.0, 1.0) * min(vec2(1.0), 2.0 * width / w);
    return max(gap.x, gap.y);
}

vec3 paving(vec2 p, inout vec3 n) {
    float row = floor(p.y / 0.4);
    vec2 tile = vec2(floor(p.x / 0.6 + 0.5 * mod(row, 2.0)), row);
    vec2 own = vec2((fract(p.x / 0.6 + 0.5 * mod(row, 2.0)) - 0.5) * 0.6, (fract(p.y / 0.4) - 0.5) * 0.4);
    float speck = 0.5 * grain(p * 260.0) + 0.3 * grain(p * 80.0) + 0.2 * grain(p * 17.0);
    vec3 c = mix(vec3(0.17, 0.165, 0.155), vec3(0.34, 0.325, 0.30), speck) * (0.86 + 0.28 * hash2(tile));
    c *= 0.9 + 0.2 * grain(p * 2.3);
    n = normalize(n + 0.12 * vec3(grain(p * 90.0) - 0.5, 0.0, grain(p * 90.0 + 31.0) - 0.5));
    return mix(c, vec3(0.045, 0.043, 0.035), 0.85 * joint(own, vec2(0.3, 0.2), 0.004, fwidth(p) + 1e-5));
}

vec3 boards(vec2 p, inout vec3 n) {
    float plank = floor(p.y / 0.14);
    float run = p.x / 1.8 + hash2(vec2(plank, 3.0)), piece = floor(run);
    vec2 own = vec2((fract(run) - 0.5) * 1.8, (fract(p.y / 0.14) - 0.5) * 0.14);
    float lot = hash2(vec2(plank, piece));
    vec2 q = p + 13.0 * lot;
    float rings = grain(vec2(q.x * 2.2, q.y * 55.0 + 3.0 * noise2(q * vec2(1.5, 9.0))));
    float fibre = 0.6 * rings + 0.4 * grain(q * vec2(9.0, 320.0));
    vec3 c = mix(vec3(0.150, 0.082, 0.036), vec3(0.330, 0.205, 0.105), fibre) * (0.78 + 0.44 * lot);
    n = normalize(n + 0.10 * vec3(0.0, 0.0, grain(q * vec2(9.0, 320.0)) - 0.5));
    return mix(c, vec3(0.020, 0.014, 0.010), 0.9 * joint(own, vec2(0.9, 0.07), 0.0025, fwidth(p) + 1e-5));
}

vec3 sand(vec2 p, inout vec3 n) {
    float ripple = noise2(vec2(p.x * 14.0 + 2.0 * noise2(p * 3.0), p.y * 3.0));
    n = normalize(n + vec3(0.5 * (ripple - 0.5), 0.0, 0.0));
    return mix(vec3(0.20, 0.17, 0.11), vec3(0.42, 0.36, 0.24), 0.5 * grain(p * 220.0) + 0.5 * ripple);
}

void main() {
    vec3 v = eye - at;
    float metres = length(v);
    v /= metres;
    vec3 n = normalize(facing), grass = n, c;
    float edge = surface == 1 ? 4.8 : surface == 2 ? 3.36 : -1.0; // m: half side of what is laid on the lawn
    float inside = edge - max(abs(at.x), abs(at.z)), w = fwidth(inside) + 1e-4;
    float laid = edge < 0.0 ? 0.0 : clamp(inside / w + 0.5, 0.0, 1.0);
    if (surface == 3) {
        c = sand(at.xz, n);
    } else {
        c = lawn(at.xz, grass);
        vec3 hard = n, on = surface == 1 ? paving(at.xz, hard) : boards(at.xz, hard);
        c = mix(c, on, laid);
        n = mix(grass, hard, laid);
    }
    float lit = max(dot(n, sun), 0.0);
    if (lit > 0.0) lit *= sun_seen(at, 0.0001);
    c *= sunlight * lit + ambient(n);
    if (laid > 0.5) { // worn by feet: a little shine
        vec3 h = normalize(v + sun);
        c += 0.05 * sunlight * lit * pow(max(dot(n, h), 0.0), 30.0);
    }
    colour = vec4(developed(through_air(c, -v, metres)), 1.0);
}
