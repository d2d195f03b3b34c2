// Precedes every fragment shader of the scene, after frame.glsl: light, air, shadow. Colours are linear until `developed`.    SPDX-License-Identifier: MIT
uniform mat4 to_light;         // world to the box that the shadow map holds, -1 to 1
uniform vec2 light_box;        // m: its half width and half depth
uniform sampler2D depth_map;
uniform sampler2DShadow lit_map;

const vec3 sunlight = vec3(3.3, 2.85, 2.25);
const vec3 from_sky = vec3(0.52, 0.66, 0.88), from_ground = vec3(0.33, 0.31, 0.22);

float hash2(vec2 p) { return fract(sin(dot(p, vec2(127.1, 311.7))) * 43758.5453); }
float noise2(vec2 p) {
    vec2 i = floor(p), f = fract(p);
    f = f * f * (3.0 - 2.0 * f);
    return mix(mix(hash2(i), hash2(i + vec2(1, 0)), f.x), mix(hash2(i + vec2(0, 1)), hash2(i + vec2(1, 1)), f.x), f.y);
}
// Noise that fades to its mean where it would be finer than a pixel.
float grain(vec2 p) {
    vec2 w = fwidth(p);
    return mix(noise2(p), 0.5, smoothstep(0.35, 1.1, max(w.x, w.y)));
}

vec3 sky(vec3 d) {
    float up = max(d.y, 0.0);
    vec3 c = mix(vec3(0.66, 0.72, 0.78), vec3(0.11, 0.25, 0.56), 1.0 - exp(-2.6 * up));
    float toward = max(dot(d, sun), 0.0);
    c += vec3(1.0, 0.72, 0.42) * (0.32 * pow(toward, 6.0) + 0.6 * pow(toward, 90.0));
    return c;
}

vec3 through_air(vec3 c, vec3 d, float metres) {
    vec3 air = 0.85 * sky(normalize(vec3(d.x, 0.04, d.z)));
    return mix(air, c, exp(-pow(metres / 90.0, 1.3)));
}

vec3 ambient(vec3 n) { return mix(from_ground, from_sky, 0.5 + 0.5 * n.y); }

// The sun's visible share at a point: percentage-closer soft shadows, the sun as a disc. slack: m towards the sun without
// occluders, so that a surface does not shadow itself.
float sun_seen(vec3 at, float slack) {
    vec3 p = (to_light * vec4(at + slack * sun, 1.0)).xyz * 0.5 + 0.5;
    float side = max(abs(p.x - 0.5), abs(p.y - 0.5));
    if (side > 0.495 || p.z > 1.0) return 1.0;
    float per_metre = 0.5 / light_box.x, texel = 1.0 / float(textureSize(depth_map, 0).x);
    float turn = 6.2832 * fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715))));
    float search = max(0.016 * per_metre, 3.0 * texel), sum = 0.0, blockers = 0.0;
    for (int i = 0; i < 12; ++i) {
        float a = turn + 2.39996 * float(i), r = sqrt((float(i) + 0.5) / 12.0);
        float z = textureLod(depth_map, p.xy + search * r * vec2(cos(a), sin(a)), 0.0).r;
        if (z < p.z) { sum += z; blockers += 1.0; }
    }
    if (blockers == 0.0) return 1.0;
    float gap = (p.z - sum / blockers) * 2.0 * light_box.y;
    float soft = max(min(0.0065 * gap, 0.03) * per_metre, 1.5 * texel), seen = 0.0;
    for (int i = 0; i < 14; ++i) {
        float a = turn + 2.39996 * float(i), r = sqrt((float(i) + 0.5) / 14.0);
        seen += textureLod(lit_map, vec3(p.xy + soft * r * vec2(cos(a), sin(a)), p.z), 0.0);
    }
    return mix(seen / 14.0, 1.0, smoothstep(0.44, 0.495, side));
}

vec3 developed(vec3 c) { // a filmic curve, then the curve of sRGB
    c *= 0.62;
    c = clamp(c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0); // Narkowicz's fit of ACES
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}
