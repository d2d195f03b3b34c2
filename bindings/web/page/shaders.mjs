// SPDX-License-Identifier: MIT
// GLSL ES 3.0: sky, ground, bodies and their shadows.

const common = `#version 300 es
precision highp float;
uniform mat4 viewProjection;
uniform vec3 eye, sun;
uniform float haze; // 1/m
const vec3 horizon = vec3(0.86, 0.80, 0.70);
float hash(uint x) {
  x = (x ^ (x >> 16)) * 0x45d9f3bu; x = (x ^ (x >> 16)) * 0x45d9f3bu;
  return float((x ^ (x >> 16)) & 0xffffu) / 65535.0;
}
vec3 sky(vec3 ray) {
  vec3 up = mix(horizon, vec3(0.47, 0.61, 0.79), smoothstep(0.0, 0.55, ray.y));
  float s = max(dot(ray, sun), 0.0);
  return up + vec3(1.0, 0.8, 0.5) * (0.35 * pow(s, 24.0) + pow(s, 900.0));
}
vec3 hazy(vec3 colour, vec3 at) {
  vec3 way = at - eye;
  float far = length(way);
  return mix(colour, sky(normalize(vec3(way.x, max(way.y, 0.0), way.z))), 1.0 - exp(-far * haze));
}
`;

export const skyVertex = `${common}
out vec2 at;
void main() {
  at = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
  gl_Position = vec4(at, 0.9999, 1.0);
}`;
export const skyFragment = `${common}
uniform mat4 inverseRays; // columns: right, up, forward of the view, scaled
in vec2 at;
out vec4 colour;
void main() {
  vec3 ray = normalize(at.x * inverseRays[0].xyz + at.y * inverseRays[1].xyz + inverseRays[2].xyz);
  colour = vec4(sky(ray), 1.0);
}`;

export const groundVertex = `${common}
uniform float room;
out vec3 world;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
  world = vec3(corner.x, 0.0, corner.y) * room * 60.0;
  gl_Position = viewProjection * vec4(world, 1.0);
}`;
export const groundFragment = `${common}
uniform float room;
in vec3 world;
out vec4 colour;
float value(vec2 p) {
  ivec2 i = ivec2(floor(p));
  vec2 f = smoothstep(0.0, 1.0, fract(p));
  #define AT(a, b) hash(uint(i.x + a) * 7919u + uint(i.y + b) * 104729u)
  return mix(mix(AT(0, 0), AT(1, 0), f.x), mix(AT(0, 1), AT(1, 1), f.x), f.y);
}
void main() {
  vec2 p = world.xz / room;
  float near = exp(-0.25 * length(world - eye) / room); // finer grain only where it would not flicker
  float grain = 0.5 * value(3.0 * p) + 0.3 * value(11.0 * p) + near * (0.35 * value(60.0 * p) + 0.35 * value(170.0 * p) - 0.35);
  vec3 grass = mix(vec3(0.19, 0.20, 0.08), vec3(0.44, 0.40, 0.17), grain);
  colour = vec4(hazy(grass * (0.55 + 0.6 * sun.y), world), 1.0);
}`;

// shadow 1: projects the body along the light onto the ground.
export const bodyVertex = `${common}
layout(location = 0) in vec3 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in mat4 place;
layout(location = 6) in uint key;
uniform float half_length, shadow;
uniform vec3 colours[6];
uniform int colour_count;
out vec3 world, tint;
out vec2 at;
void main() {
  vec4 p = place * vec4(half_length * position, 1.0);
  if (shadow > 0.5) p.xyz -= sun * ((p.y - 0.002 * half_length) / sun.y);
  world = p.xyz;
  at = uv;
  tint = colours[int(key) % colour_count] * (0.8 + 0.35 * hash(key));
  gl_Position = viewProjection * p;
}`;
export const bodyFragment = `${common}
uniform float shadow, ribs;
in vec3 world, tint;
in vec2 at;
out vec4 colour;
void main() {
  if (shadow > 0.5) { colour = vec4(0.05, 0.05, 0.02, 0.45 * exp(-length(world - eye) * haze * 2.0)); return; }
  vec3 view = normalize(eye - world);
  vec3 normal = normalize(cross(dFdx(world), dFdy(world))); // flat: of the sheet itself, whatever its shape
  if (dot(normal, view) < 0.0) normal = -normal;
  float facing = dot(normal, sun);
  // Thin sheets glow where the sun is behind them.
  float light = 0.42 + 0.25 * normal.y + (facing > 0.0 ? 0.62 * facing : -0.45 * facing);
  float side = abs(at.y - 0.5);
  float rib = ribs * (smoothstep(0.035, 0.0, side) + 0.35 * smoothstep(0.8, 1.0, sin(60.0 * (at.x - 0.8 * side))));
  vec3 lit = tint * (1.0 - 0.3 * rib) * light;
  lit += 0.18 * pow(max(dot(reflect(-sun, normal), view), 0.0), 24.0);
  colour = vec4(hazy(lit, world), 1.0);
}`;
