// Precedes every fragment shader of the scene, after frame.glsl and before the light: noise and shadow.    SPDX-License-Identifier: MIT
uniform float haze;            // m: where the air hides most of what is there
uniform mat4 to_light;         // world to the box that the shadow map holds, -1 to 1
uniform vec2 light_box;        // m: its half width and half depth
uniform sampler2D depth_map;
uniform sampler2DShadow lit_map;

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
        float a = turn + 2.39996 * float(i), r = sqrt(float(i) / 12.0); // the first at the point itself
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
