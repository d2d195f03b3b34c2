// SPDX-License-Identifier: MIT
in vec3 direction;
out vec4 colour;

float hash1(float n) { return fract(sin(n) * 43758.5453); }
float noise1(float x) { float i = floor(x), f = fract(x); f = f * f * (3.0 - 2.0 * f); return mix(hash1(i), hash1(i + 1.0), f); }

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
