// SPDX-License-Identifier: MIT
in vec2 uv;
in vec4 tint;
uniform sampler2D atlas;
out vec4 colour;
void main() { colour = vec4(tint.rgb, tint.a * (uv.x < 0.0 ? 1.0 : texture(atlas, uv).r)); }
