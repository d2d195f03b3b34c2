// Ground, objects and shadows; append to shader_air.
// SPDX-License-Identifier: MIT
#pragma once

inline constexpr const char* shader_solid_vertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
uniform mat4 to_clip;
uniform mat4 to_world;
out vec3 at, facing, own;
void main() {
    own = position;
    at = (to_world * vec4(position, 1.0)).xyz;
    facing = mat3(to_world) * normal;
    gl_Position = to_clip * vec4(at, 1.0);
}
)";

inline constexpr const char* shader_solid_fragment = R"(
in vec3 at, facing, own;
uniform int surface;                     // 0 soil, 1 stone, 2 wood, 3 cloth
uniform vec4 walker;                     // middle, radius; radius 0: nobody
uniform float walker_half_length;
uniform int box_count;
uniform int round_from;                  // boxes before, ellipsoids from here on
uniform mat4 to_box[12];                 // world to a box of half extents 1, or a ball of radius 1
out vec4 colour;

// The sun's share past an upright capsule: softer with distance.
float past_walker(vec3 from) {
    if (walker.w == 0.0) return 1.0;
    vec3 low = walker.xyz - vec3(0.0, walker_half_length, 0.0), axis = vec3(0.0, 2.0 * walker_half_length, 0.0);
    vec3 r = from - low;
    // Nearest points of the ray from + t sun and the segment low + s axis.
    float b = dot(sun, axis), c = dot(axis, axis), d = dot(sun, r), e = dot(axis, r);
    float s = clamp((e - b * d) / (c - b * b), 0.0, 1.0);
    float t = max(s * b - d, 0.0);
    float gap = distance(from + t * sun, low + s * axis);
    float soft = 0.012 * t + 0.004;
    return t > 0.0 ? smoothstep(walker.w - soft, walker.w + soft, gap) : 1.0;
}

float past_furniture(vec3 from) {
    float left = 1.0;
    for (int i = 0; i < box_count; ++i) {
        vec3 o = (to_box[i] * vec4(from, 1.0)).xyz, d = mat3(to_box[i]) * sun;
        if (i >= round_from) {
            float along = -dot(o, d) / dot(d, d);
            if (along > 0.0) left *= smoothstep(0.85, 1.1, length(o + along * d));
            continue;
        }
        vec3 a = (-1.0 - o) / d, b = (1.0 - o) / d, near = min(a, b), far = max(a, b);
        float in_ = max(max(near.x, near.y), near.z), out_ = min(min(far.x, far.y), far.z);
        if (out_ > 0.002) left *= 1.0 - smoothstep(-0.002, 0.03, out_ - max(in_, 0.002));
    }
    return left;
}

void main() {
    vec3 v = eye - at;
    float metres = length(v);
    v /= metres;
    vec3 n = normalize(facing);
    float lit = max(dot(n, sun), 0.0);
    if (lit > 0.0) lit *= past_walker(at + 0.004 * n) * past_furniture(at + 0.004 * n);
    vec3 light = vec3(2.9, 2.15, 1.35);
    vec3 around = mix(vec3(0.20, 0.15, 0.08), vec3(0.44, 0.55, 0.72), 0.5 + 0.5 * n.y);
    vec3 base;
    if (surface == 0) {
        float blades = noise2(at.xz * vec2(160.0, 60.0)) * 0.5 + noise2(at.xz * vec2(70.0, 110.0)) * 0.5;
        float patches = noise2(at.xz * 1.3 + 5.0) * 0.6 + noise2(at.xz * 5.1) * 0.4;
        base = mix(vec3(0.035, 0.060, 0.014), vec3(0.085, 0.110, 0.026), blades);
        base = mix(base, vec3(0.100, 0.075, 0.040), smoothstep(0.45, 0.8, patches) * 0.8);
    } else if (surface == 1) {
        float speckled = noise2(own.xy * 90.0 + own.z * 37.0) * 0.5 + noise2(own.xz * 23.0 + own.y * 11.0) * 0.5;
        base = mix(vec3(0.12, 0.115, 0.11), vec3(0.30, 0.29, 0.27), speckled);
    } else if (surface == 2) {
        float grain = noise2(vec2(own.x * 3.0, own.z * 110.0)) * 0.7 + noise2(vec2(own.x * 14.0, own.z * 260.0)) * 0.3;
        base = mix(vec3(0.15, 0.075, 0.030), vec3(0.33, 0.19, 0.09), grain);
        base *= 0.25 + 0.75 * smoothstep(0.0, 0.05, abs(fract(own.z * 7.0 + 0.5) - 0.5));
    } else {
        float thread = noise2(vec2(atan(own.z, own.x) * 40.0, own.y * 130.0));
        base = own.y > 0.52 ? vec3(0.30, 0.17, 0.11) : own.y > -0.12 ? vec3(0.04, 0.075, 0.16) : vec3(0.035, 0.032, 0.03);
        base *= 0.8 + 0.4 * thread;
    }
    vec3 c = base * (light * lit + 0.75 * around);
    if (surface == 0) {
        // Towards its borders it becomes the field around it.
        float border = 10.0 - max(abs(at.x), abs(at.z));
        c = mix(soil(at.xz, metres, glow_towards(-v)), c, smoothstep(0.0, 4.0, border));
    }
    colour = vec4(developed(through_air(c, -v, metres)), 1.0);
}
)";

inline constexpr const char* shader_shadow_vertex = R"(
layout(location = 0) in vec4 middle;     // of the shadow, and how dark it is
layout(location = 1) in vec3 along;      // half axes of the body's shadow on the ground
layout(location = 2) in vec3 across;
layout(location = 3) in float soft;      // width of its edge over its size
uniform mat4 to_clip;
out vec2 place;
out float dark, edge;
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    edge = soft;
    place = corner * (1.0 + soft);
    dark = middle.w;
    gl_Position = to_clip * vec4(middle.xyz + place.x * along + place.y * across, 1.0);
}
)";

inline constexpr const char* shader_shadow_fragment = R"(
in vec2 place;
in float dark, edge;
out vec4 colour;
void main() {
    colour = vec4(0.0, 0.0, 0.0, dark * smoothstep(1.0 + edge, 1.0 - edge, length(place)));
}
)";
