// The light of a clear day. Colours are linear until `developed`.    SPDX-License-Identifier: MIT
const vec3 sunlight = vec3(3.3, 2.85, 2.25);
const vec3 from_sky = vec3(0.52, 0.66, 0.88), from_ground = vec3(0.33, 0.31, 0.22);

vec3 sky(vec3 d) {
    float up = max(d.y, 0.0);
    vec3 c = mix(vec3(0.66, 0.72, 0.78), vec3(0.11, 0.25, 0.56), 1.0 - exp(-2.6 * up));
    float toward = max(dot(d, sun), 0.0);
    c += vec3(1.0, 0.72, 0.42) * (0.32 * pow(toward, 6.0) + 0.6 * pow(toward, 90.0));
    return c;
}

vec3 through_air(vec3 c, vec3 d, float metres) {
    vec3 air = 0.85 * sky(normalize(vec3(d.x, 0.04, d.z)));
    return mix(air, c, exp(-pow(metres / haze, 1.3)));
}

vec3 ambient(vec3 n) { return mix(from_ground, from_sky, 0.5 + 0.5 * n.y); }

vec3 developed(vec3 c) { // a filmic curve, then the curve of sRGB
    c *= 0.62;
    c = clamp(c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0); // Narkowicz's fit of ACES
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}
