/* How things are coloured; the numbers are the shaders'.    SPDX-License-Identifier: MIT */
#ifndef DRAWING_LOOKS_H
#define DRAWING_LOOKS_H

enum look { look_leaf, look_petal, look_paper, look_confetti, look_rubber };
enum ground_look { ground_lawn, ground_paving, ground_boards, ground_sand };
enum solid_look { solid_stone, solid_wood, solid_cloth };

#endif
