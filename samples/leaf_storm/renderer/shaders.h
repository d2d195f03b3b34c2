// SPDX-License-Identifier: MIT
#pragma once

// Late light of an autumn day: a low sun ahead of the camera, haze, woods on the horizon. Colours are linear.
inline constexpr const char* shader_air = R"(#version 330 core
uniform vec3 eye;
uniform vec3 sun;          // towards it
uniform float haze;        // m: where the air hides 63 % of what is there

float hash1(float n) { return fract(sin(n) * 43758.5453); }
float hash2(vec2 p) { return fract(sin(dot(p, vec2(127.1, 311.7))) * 43758.5453); }
float noise1(float x) { float i = floor(x), f = fract(x); f = f * f * (3.0 - 2.0 * f); return mix(hash1(i), hash1(i + 1.0), f); }
float noise2(vec2 p) {
    vec2 i = floor(p), f = fract(p);
    f = f * f * (3.0 - 2.0 * f);
    return mix(mix(hash2(i), hash2(i + vec2(1, 0)), f.x), mix(hash2(i + vec2(0, 1)), hash2(i + vec2(1, 1)), f.x), f.y);
}

vec3 sky(vec3 d) {
    float up = clamp(d.y, 0.0, 1.0);
    vec3 colour = mix(vec3(0.50, 0.29, 0.13), vec3(0.19, 0.25, 0.33), smoothstep(0.0, 0.36, up));
    colour = mix(colour, vec3(0.045, 0.11, 0.25), smoothstep(0.2, 0.75, up));
    float toward = max(dot(d, sun), 0.0);
    colour += vec3(1.0, 0.52, 0.17) * (0.30 * pow(toward, 7.0) + 0.55 * pow(toward, 60.0));
    colour += vec3(5.0, 3.9, 2.2) * smoothstep(0.9986, 0.9996, toward);
    return colour;
}

vec3 through_air(vec3 colour, vec3 d, float metres) {
    float left = exp(-pow(metres / haze, 1.4));
    vec3 air = 0.62 * min(sky(normalize(vec3(d.x, abs(d.y) * 0.3 + 0.03, d.z))), vec3(1.6));
    return mix(air, colour, left);
}

// Grass and fallen leaves, from afar. glow: how much of the low sun there is in their direction.
vec3 soil(vec2 place, float metres, float glow) {
    vec2 p = place * (60.0 / haze);
    float near = exp(-metres / haze * 3.0);
    float grain = mix(0.5, noise2(p * vec2(3.1, 1.9)), near) * 0.5 + mix(0.5, noise2(p * 1.1), sqrt(near)) * 0.5;
    vec3 ground = mix(vec3(0.012, 0.020, 0.005), vec3(0.060, 0.052, 0.010), smoothstep(0.2, 0.8, grain));
    ground = mix(ground, vec3(0.17, 0.062, 0.010), 0.9 * smoothstep(0.50, 0.85, mix(0.45, noise2(p * 1.9 + 7.0), near) * 0.6 + 0.4 * noise2(p * 0.3)));
    return ground * (0.7 + 3.2 * glow);
}

float glow_towards(vec3 d) {
    return pow(max(dot(normalize(vec3(d.x, 0.0, d.z)), normalize(vec3(sun.x, 0.0, sun.z))), 0.0), 9.0);
}

vec3 developed(vec3 c) { // filmic curve (Narkowicz's fit of ACES); the frame buffer encodes to sRGB
    c *= 0.95;
    return clamp(c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0);
}
)";

inline constexpr const char* shader_sky_vertex = R"(
uniform mat4 from_clip;    // clip to world, about the eye
out vec3 direction;
void main() {
    vec2 p = vec2(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0);
    vec4 far = from_clip * vec4(p, 1.0, 1.0);
    direction = far.xyz / far.w;
    gl_Position = vec4(p, 1.0, 1.0);
}
)";

inline constexpr const char* shader_sky_fragment = R"(
in vec3 direction;
out vec4 colour;

// Everything behind the storm is out of focus, as behind a long lens: soft outlines, and discs of light in the woods.

float crowns(float x, float seed) { // outline of a wood: round crowns of many sizes
    float top = 0.0, i = floor(x);
    for (float k = -1.0; k <= 1.0; ++k) {
        float j = i + k + seed;
        float q = (x - i - k - 0.2 - 0.6 * hash1(j * 1.7)) / (0.55 + 0.5 * hash1(j * 2.3));
        float w = max(0.0, 1.0 - q * q);
        top += pow((0.55 + 0.45 * hash1(j * 3.1)) * sqrt(w), 6.0);
    }
    return pow(top, 1.0 / 6.0) + 0.10 * noise1(x * 3.0 + seed);
}

float lights(vec2 p, float seed) { // soft discs, brighter at the rim
    float sum = 0.0;
    vec2 i = floor(p);
    for (float y = -1.0; y <= 1.0; ++y) {
        for (float x = -1.0; x <= 1.0; ++x) {
            vec2 j = i + vec2(x, y) + seed;
            vec2 centre = i + vec2(x, y) + vec2(hash2(j + 3.1), hash2(j + 7.7));
            float r = 0.28 + 0.34 * hash2(j + 1.3), q = distance(p, centre) / r;
            sum += step(0.72, hash2(j)) * hash2(j + 5.9) * smoothstep(1.0, 0.9, q) * (0.65 + 0.35 * q * q);
        }
    }
    return sum;
}

void main() {
    vec3 d = normalize(direction);
    vec3 c = sky(d);
    vec2 drift = d.xz / (d.y + 0.22);
    float cloud = 0.55 * noise2(drift * vec2(1.1, 1.9)) + 0.3 * noise2(drift * vec2(2.6, 4.3)) + 0.15 * noise2(drift * vec2(5.1, 8.7));
    c = mix(c, c * 1.1 + vec3(0.07, 0.052, 0.038), smoothstep(0.40, 0.85, cloud) * smoothstep(0.06, 0.4, d.y));
    float a = atan(d.x, -d.z);
    float glow = glow_towards(d);
    // From the hills at the back to the trees at the sides: nearer is taller, darker, less hazy and more out of focus.
    for (int k = 0; k < 4; ++k) {
        float depth = float(k) / 3.0, soft = mix(0.006, 0.022, depth);
        float rise = k == 3 ? 0.03 + 0.40 * smoothstep(0.10, 0.60, abs(a - 0.10)) : mix(0.13, 0.17, depth);
        float top = rise * (0.30 + 0.75 * crowns(a * mix(17.0, 6.0, depth), 31.0 * float(k) + 5.0));
        vec2 p = vec2(a, d.y);
        float foliage = noise2(p * mix(60.0, 22.0, depth) + 9.0 * float(k)) * 0.6 + noise2(p * mix(25.0, 9.0, depth)) * 0.4;
        vec3 wood = mix(vec3(0.010, 0.014, 0.007), vec3(0.090, 0.042, 0.008), smoothstep(0.35, 0.8, foliage));
        float under = smoothstep(top + soft, top - soft, d.y);
        wood += vec3(0.34, 0.15, 0.028) * (0.30 + 1.2 * glow) * lights(p * mix(40.0, 17.0, depth), 11.0 * float(k)) * smoothstep(0.0, 0.10, d.y);
        vec3 mist = 0.55 * min(sky(normalize(vec3(d.x, 0.07, d.z))), vec3(1.0));
        vec3 seen = mix(wood, mist, mix(0.66, 0.06, sqrt(depth)) + 0.16 * (1.0 - smoothstep(0.0, 0.10, d.y)));
        c = mix(c, seen, under);
    }
    float metres = eye.y / max(-d.y, 1e-3);
    vec3 ground = soil((eye + d * metres).xz, metres, glow);
    c = mix(c, through_air(ground, d, metres * 0.45), smoothstep(0.012, -0.012, d.y));
    colour = vec4(developed(c), 1.0);
}
)";

inline constexpr const char* shader_body_vertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in uvec2 body;      // its place in the batch, and its key
uniform samplerBuffer transforms;        // three rows of four, for each body
uniform mat4 to_clip;
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
    facing = vec3(dot(r0.xyz, normal), dot(r1.xyz, normal), dot(r2.xyz, normal));
    across = uv;
    upper = normal.z;
    uint h = mixed(body.y * 0x9e3779b9u + 1u);
    lot = vec4(h & 255u, (h >> 8) & 255u, (h >> 16) & 255u, h >> 24) / 255.0;
    gl_Position = to_clip * vec4(at, 1.0);
}
)";

inline constexpr const char* shader_body_fragment = R"(
in vec3 at, facing;
in vec2 across;
in float upper;
flat in vec4 lot;
uniform int look;                        // 0 leaf, 1 petal, 2 paper
out vec4 colour;

float stripe(float x, float half_width) { // antialiased line where x is near 0
    float w = fwidth(x);
    return clamp((half_width - abs(x)) / max(w, 1e-5) + 0.5, 0.0, 1.0) * min(1.0, 2.5 * half_width / max(w, 1e-5));
}

void main() {
    vec3 v = eye - at;
    float metres = length(v);
    v /= metres;
    vec3 n = normalize(facing);
    bool front = dot(n, v) > 0.0;
    if (!front) n = -n;
    float top = upper * (front ? 1.0 : -1.0);

    vec3 base;
    float vein = 0.0, gloss = 0.25, clear = 0.8;
    float side = abs(across.y - 0.5), u = across.x;
    if (look == 0) {
        vec3 gold = vec3(0.86, 0.44, 0.035), amber = vec3(0.88, 0.29, 0.022), red = vec3(0.58, 0.055, 0.022),
             tan_ = vec3(0.42, 0.20, 0.065), lime = vec3(0.42, 0.44, 0.05);
        base = lot.x < 0.26 ? mix(gold, amber, lot.y) : lot.x < 0.62 ? mix(amber, red, lot.y)
             : lot.x < 0.76 ? mix(red, tan_, 0.6 * lot.y) : lot.x < 0.90 ? mix(gold, lime, lot.y) : mix(tan_, amber, 0.5 * lot.y);
        float mottled = noise2(across * vec2(9.0, 11.0) + lot.zw * 40.0) * 0.6 + noise2(across * 31.0 + lot.wz * 40.0) * 0.4;
        base = mix(base, base * vec3(0.62, 0.42, 0.40), smoothstep(0.5, 0.85, mottled) * (0.35 + 0.5 * lot.w));
        base = mix(base, base * vec3(0.85, 1.15, 0.9) + vec3(0.0, 0.03, 0.0), smoothstep(0.16, 0.0, side) * lot.z * 0.7);
        // Side veins leave the midrib forward and bend towards the tip; left and right alternate.
        float along = u - 0.62 * side - 0.9 * side * side + (across.y > 0.5 ? 0.03 : 0.0);
        float pattern = abs(fract(along * 11.0) - 0.5);
        float fine = stripe(0.5 - pattern, 0.055) * smoothstep(0.30, 0.22, side) * smoothstep(0.97, 0.9, u) * 0.75;
        vein = max(fine, stripe(side, 0.010 * (1.15 - u)));
        if (top < 0.0) base = mix(base, vec3(0.55, 0.42, 0.24), 0.30);
        base = mix(base, top > 0.0 ? base * 0.55 + vec3(0.17, 0.11, 0.02) : base * 0.45, 0.65 * vein);
    } else if (look == 1) {
        base = mix(vec3(0.66, 0.40, 0.45), vec3(0.60, 0.15, 0.27), 0.15 + 0.5 * lot.x + 0.45 * smoothstep(0.45, 0.0, u));
        clear = 0.55;
    } else {
        vec3 a = 0.5 + 0.5 * cos(6.2832 * (lot.x + vec3(0.0, 0.33, 0.67)));
        base = lot.y < 0.2 ? vec3(0.82) : a * a * 0.8 + 0.03;
        gloss = 0.5;
        clear = 0.25;
    }

    float lit = max(dot(n, sun), 0.0), behind = max(dot(-n, sun), 0.0);
    vec3 light = vec3(2.9, 2.15, 1.35);
    vec3 around = mix(vec3(0.30, 0.20, 0.09), vec3(0.44, 0.55, 0.72), 0.5 + 0.5 * n.y);
    vec3 c = base * (light * lit + around);
    // Light from behind comes through coloured twice over, less at the veins.
    c += pow(base, vec3(0.85)) * light * (look == 1 ? vec3(0.95, 0.72, 0.85) : vec3(1.0, 0.80, 0.45)) * clear * (0.25 * max(1.0 - lit, 0.0) * behind + 0.75 * behind) * (1.0 - 0.55 * vein);
    vec3 h = normalize(v + sun);
    float edge = pow(1.0 - max(dot(n, v), 0.0), 5.0);
    c += light * gloss * (0.35 * pow(max(dot(n, h), 0.0), 28.0) * lit + 0.05 * edge);
    colour = vec4(developed(through_air(c, -v, metres)), 1.0);
}
)";
