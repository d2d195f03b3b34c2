// Late light of an autumn day: a low sun ahead, haze, woods on the horizon. Colours are linear until `developed`.    SPDX-License-Identifier: MIT
const vec3 sunlight = vec3(2.9, 2.15, 1.35);
const vec3 from_sky = vec3(0.44, 0.55, 0.72), from_ground = vec3(0.30, 0.20, 0.09);

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

vec3 ambient(vec3 n) { return mix(from_ground, from_sky, 0.5 + 0.5 * n.y); }

vec3 developed(vec3 c) { // a filmic curve, then the curve of sRGB
    c *= 0.95;
    c = clamp(c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0); // Narkowicz's fit of ACES
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}
