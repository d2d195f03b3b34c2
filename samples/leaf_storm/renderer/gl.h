// OpenGL 3.3 core as libOpenGL exports it: no loader is needed.
// SPDX-License-Identifier: MIT
#pragma once

#define GL_GLEXT_PROTOTYPES 1
#include <GL/glcorearb.h>
