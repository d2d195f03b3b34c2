// SPDX-License-Identifier: MIT
layout(location = 0) in vec2 position;   // px from the top left
layout(location = 1) in vec2 place;      // px in the atlas; under 0: all of the colour
layout(location = 2) in vec4 shade;
uniform vec2 picture;                    // px
uniform vec2 atlas_size;
out vec2 uv;
out vec4 tint;
void main() {
    uv = place / atlas_size;
    tint = shade;
    gl_Position = vec4(2.0 * position.x / picture.x - 1.0, 1.0 - 2.0 * position.y / picture.y, 0.0, 1.0);
}
