/* SPDX-License-Identifier: MIT */
#include "failure.h"
#include "gl.h"

static GLuint compile(const char* name, GLenum kind, const char* const text[2]) {
    const GLuint shader = glCreateShader(kind);
    glShaderSource(shader, 2, text, NULL);
    glCompileShader(shader);
    GLint good = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
    if (!good) {
        char log[2000] = "";
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        fail("report it with this text", "OpenGL (%s) does not compile the shader %s: %s", gl_name(), name, log);
    }
    return shader;
}

GLuint make_program(const char* name, const char* const vertex[2], const char* const fragment[2]) {
    const GLuint program = glCreateProgram();
    const GLuint parts[2] = {compile(name, GL_VERTEX_SHADER, vertex), compile(name, GL_FRAGMENT_SHADER, fragment)};
    for (int i = 0; i < 2; ++i) glAttachShader(program, parts[i]);
    glLinkProgram(program);
    for (int i = 0; i < 2; ++i) glDeleteShader(parts[i]);
    GLint good = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &good);
    if (!good) {
        char log[2000] = "";
        glGetProgramInfoLog(program, sizeof log, NULL, log);
        fail("report it with this text", "OpenGL (%s) does not link the shader %s: %s", gl_name(), name, log);
    }
    return program;
}

GLint uniform(GLuint program, const char* name) {
    return glGetUniformLocation(program, name);
}

const char* gl_name(void) {
    const GLubyte* name = glGetString(GL_RENDERER);
    return name ? (const char*)name : "unknown";
}

void gl_check(const char* what) {
    const GLenum error = glGetError();
    if (error != GL_NO_ERROR)
        fail("try a smaller --size or --count", "OpenGL (%s) failed at %s with error 0x%04x", gl_name(), what,
             (unsigned)error);
}

void gl_attribute(GLuint place, GLint size, size_t stride, size_t offset, GLuint divisor) {
    glEnableVertexAttribArray(place);
    glVertexAttribPointer(place, size, GL_FLOAT, GL_FALSE, (GLsizei)stride, (const void*)offset);
    glVertexAttribDivisor(place, divisor);
}
