// SPDX-License-Identifier: MIT
in vec3 at;
in vec2 slope;
uniform float time;
out vec4 colour;
void main() {
    vec3 v = eye - at;
    float metres = length(v);
    v /= metres;
    vec2 p = at.xz * 34.0, drift = time * vec2(0.5, 0.3);
    float fine = exp(-0.12 * metres);
    vec2 ripple = fine * vec2(grain(p + drift) - grain(p + drift + vec2(0.6, 0.0)), grain(p - drift) - grain(p - drift + vec2(0.0, 0.6)));
    vec3 n = normalize(vec3(-slope.x, 1.0, -slope.y) + 0.12 * vec3(ripple.x, 0.0, ripple.y));
    float facing = max(dot(n, v), 0.0), mirror = 0.02 + 0.98 * pow(1.0 - facing, 5.0);
    vec3 r = reflect(-v, n);
    r.y = abs(r.y);
    float seen = sun_seen(at, 0.02);
    vec3 shine = 0.9 * sky(r) + vec3(5.0, 4.4, 3.6) * pow(max(dot(r, sun), 0.0), 350.0) * seen;
    vec3 murk = vec3(0.020, 0.075, 0.070) * (0.35 * sunlight * (0.35 + 0.65 * seen) + ambient(vec3(0.0, 1.0, 0.0)));
    float hidden = 1.0 - exp(-0.55 / max(facing, 0.08)); // of what is below, by the way through the water
    float alpha = mix(hidden, 1.0, mirror);
    vec3 c = (mix(murk * hidden, shine, mirror)) / alpha;
    colour = vec4(developed(through_air(c, -v, metres)), alpha);
}
