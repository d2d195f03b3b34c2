// SPDX-License-Identifier: MIT
in vec3 at, facing, own;
in float look;                          // 0 stone, 1 wood, 2 cloth
uniform float texel;
out vec4 colour;
float noise3(vec3 p) {
    float z = floor(p.z), f = fract(p.z);
    return mix(noise2(p.xy + z * vec2(37.0, 17.0)), noise2(p.xy + (z + 1.0) * vec2(37.0, 17.0)), f * f * (3.0 - 2.0 * f));
}

void main() {
    vec3 v = eye - at;
    float metres = length(v);
    v /= metres;
    vec3 n = normalize(facing);
    bool wooden = look > 0.5 && look < 1.5;
    float fibre = 0.7 * grain(vec2(own.x * 3.0, own.z * 70.0 + own.y * 50.0)) + 0.3 * grain(vec2(own.x * 13.0, (own.z + own.y) * 290.0));
    float w = length(fwidth(own));
    float speck = 0.30 * mix(noise3(own * 150.0), 0.5, smoothstep(0.002, 0.007, w)) + 0.35 * noise3(own * 41.0) + 0.35 * noise3(own * 9.0 + 4.0);
    vec3 c = wooden ? mix(vec3(0.13, 0.07, 0.03), vec3(0.34, 0.21, 0.11), fibre)
                        : mix(vec3(0.11, 0.108, 0.10), vec3(0.36, 0.35, 0.32), speck);
    if (look > 1.5) { // a coat, trousers, a cap
        c = own.y > 0.52 ? vec3(0.30, 0.17, 0.11) : own.y > -0.12 ? vec3(0.04, 0.075, 0.16) : vec3(0.035, 0.032, 0.03);
        c *= 0.8 + 0.4 * grain(vec2(atan(own.z, own.x) * 40.0, own.y * 130.0));
    }
    n = normalize(n + (wooden ? 0.1 : 0.35) * (vec3(speck, fibre, noise3(own * 60.0 + 9.0)) - 0.5));
    float facing_sun = dot(normalize(facing), sun), lit = max(dot(n, sun), 0.0) * step(0.0, facing_sun);
    if (lit > 0.0) lit *= sun_seen(at + 1.5 * texel * normalize(facing), texel * 2.0);
    float hollow = 0.55 + 0.45 * smoothstep(0.0, 0.10, at.y); // less sky near the ground
    c *= sunlight * lit + hollow * ambient(n);
    colour = vec4(developed(through_air(c, -v, metres)), 1.0);
}
