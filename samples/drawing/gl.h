/* OpenGL 3.3 core as libOpenGL exports it: no loader is needed.    SPDX-License-Identifier: MIT */
#ifndef DRAWING_GL_H
#define DRAWING_GL_H

#define GL_GLEXT_PROTOTYPES 1
#include <GL/glcorearb.h>
#include <stddef.h>

/* Creates an OpenGL 3.3 core context without window or display, current until the program ends. Fails with a message. */
void context_without_display(void);

/* Compiles and links, or fails with the compiler's log. Each shader has two parts; the first has #version. */
GLuint make_program(const char* name, const char* const vertex[2], const char* const fragment[2]);

GLint uniform(GLuint program, const char* name);

/* GL_RENDERER, for messages. */
const char* gl_name(void);

/* Fails if OpenGL has an error pending. */
void gl_check(const char* what);

/* Binds a vertex buffer to an array object: attribute `place` of `size` floats at `offset` in elements of `stride` bytes. */
void gl_attribute(GLuint place, GLint size, size_t stride, size_t offset, GLuint divisor);

#endif
