// SPDX-License-Identifier: MIT
in vec3 at, facing;
in vec2 across;
in float upper;
flat in vec4 lot;
uniform int look;                        // 0 leaf, 1 petal, 2 paper, 3 confetti, 4 rubber
uniform float texel;                     // m: of the shadow map
out vec4 colour;

float line(float x, float half_width) {  // 1 where x is near 0, antialiased, fainter where finer than a pixel
    float w = max(fwidth(x), 1e-6);
    return clamp((half_width - abs(x)) / w + 0.5, 0.0, 1.0) * min(1.0, 2.0 * half_width / w);
}

vec3 leaf_colour(float top, out float vein) {
    vec3 gold = vec3(0.80, 0.45, 0.035), orange = vec3(0.80, 0.24, 0.02), red = vec3(0.50, 0.05, 0.025),
         brown = vec3(0.34, 0.17, 0.065), green = vec3(0.25, 0.32, 0.05);
    float pick = lot.x * 5.0;
    vec3 c = pick < 1.3 ? mix(gold, green, 0.8 * lot.y * lot.y) : pick < 2.7 ? mix(gold, orange, lot.y)
           : pick < 3.9 ? mix(orange, red, lot.y) : mix(brown, orange, 0.55 * lot.y * lot.y);
    float spots = 0.6 * grain(across * 10.0 + lot.zw * 37.0) + 0.4 * grain(across * 29.0 + lot.wz * 37.0);
    c = mix(c, c * vec3(0.55, 0.38, 0.35), smoothstep(0.52, 0.85, spots) * (0.25 + 0.6 * lot.w));
    float side = abs(across.y - 0.5), u = across.x;
    c = mix(c, 0.75 * c + vec3(0.02, 0.06, 0.0), smoothstep(0.20, 0.0, side) * lot.z);
    // Side veins leave the midrib forward and bend to the tip, alternating between both sides.
    float along = u - 0.75 * side - 0.6 * side * side + (across.y > 0.5 ? 0.04 : 0.0);
    float fine = line(abs(fract(along * 10.0) - 0.5) - 0.5, 0.05) * smoothstep(0.31, 0.2, side) * smoothstep(1.0, 0.9, u);
    vein = max(0.7 * fine, line(side, 0.011 * (1.2 - u)));
    if (top < 0.0) c = mix(c, vec3(0.48, 0.38, 0.22), 0.28);
    return mix(c, top > 0.0 ? 0.6 * c + vec3(0.14, 0.09, 0.02) : 0.5 * c, 0.6 * vein);
}

vec3 paper_colour(float top) {
    vec3 c = mix(vec3(0.80, 0.79, 0.75), vec3(0.78, 0.80, 0.82), lot.x);
    if (lot.y > 0.72) c = mix(vec3(0.75, 0.55, 0.18), vec3(0.30, 0.55, 0.70), step(0.86, lot.y));
    if (top <= 0.0) return 0.97 * c;
    c = mix(c, vec3(0.25, 0.38, 0.62), 0.55 * line(abs(fract(across.y * 14.0) - 0.5) - 0.5, 0.035)); // ruled
    return mix(c, vec3(0.72, 0.20, 0.18), 0.6 * line(across.x - 0.14, 0.004));
}

void main() {
    vec3 v = eye - at;
    float metres = length(v);
    v /= metres;
    vec3 n = normalize(facing);
    float faces = dot(n, v) < 0.0 ? -1.0 : 1.0;
    n *= faces;
    float top = upper * faces, vein = 0.0, gloss = 0.10, through = 0.75;
    vec3 base;
    if (look == 0) {
        base = leaf_colour(top, vein);
    } else if (look == 1) {
        base = mix(vec3(0.80, 0.50, 0.56), vec3(0.72, 0.22, 0.36), 0.55 * lot.x + 0.45 * smoothstep(0.5, 0.0, across.x));
        through = 0.6;
    } else if (look == 2) {
        base = paper_colour(top);
        through = 0.28;
    } else if (look == 3) {
        vec3 wheel = 0.5 + 0.5 * cos(6.2832 * (lot.x + vec3(0.0, 0.33, 0.67)));
        base = lot.y < 0.15 ? vec3(0.80) : 0.03 + 0.80 * wheel * wheel;
        gloss = 0.6;
        through = 0.15;
    } else {
        base = lot.x < 0.5 ? vec3(0.42, 0.05, 0.035) : vec3(0.05, 0.13, 0.30);
        gloss = 0.5;
        through = 0.0;
    }
    // Slanting surfaces change their depth within the reach of the shadow's filter.
    float facing_sun = dot(n, sun), slant = sqrt(1.0 - facing_sun * facing_sun) / max(abs(facing_sun), 0.2);
    float seen = sun_seen(at, texel * (1.5 + 2.0 * slant));
    float lit = max(facing_sun, 0.0) * seen, behind = max(-facing_sun, 0.0) * seen;
    vec3 c = base * (sunlight * lit + ambient(n) + 0.25 * through * ambient(-n));
    // Light from behind passes through the tissue: deeper in colour, less at the veins.
    c += pow(base, vec3(1.25)) * sunlight * 1.35 * through * behind * (1.0 - 0.6 * vein);
    vec3 h = normalize(v + sun);
    c += sunlight * gloss * (0.5 * pow(max(dot(n, h), 0.0), 40.0) * lit) + gloss * 0.35 * sky(reflect(-v, n)) * pow(1.0 - max(dot(n, v), 0.0), 4.0);
    colour = vec4(developed(through_air(c, -v, metres)), 1.0);
}
