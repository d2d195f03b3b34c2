// SPDX-License-Identifier: MIT
#include "renderer/program.h"

#include "failure.h"
#include "renderer/gl.h"

namespace {

GLuint compile(const char* name, GLenum stage, const std::string& source) {
    const GLuint shader = glCreateShader(stage);
    const char* text = source.c_str();
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    GLint done = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    if (!done) {
        char words[2048] = "";
        glGetShaderInfoLog(shader, sizeof words, nullptr, words);
        throw Failure(std::string("shader ") + name + " does not compile: " + words,
                      "report it with your OpenGL driver");
    }
    return shader;
}

} // namespace

unsigned make_program(const char* name, const std::string& vertex, const std::string& fragment) {
    const GLuint program = glCreateProgram();
    const GLuint stages[] = {compile(name, GL_VERTEX_SHADER, vertex), compile(name, GL_FRAGMENT_SHADER, fragment)};
    for (const GLuint stage : stages) glAttachShader(program, stage);
    glLinkProgram(program);
    for (const GLuint stage : stages) glDeleteShader(stage);
    GLint done = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &done);
    if (!done) {
        char words[2048] = "";
        glGetProgramInfoLog(program, sizeof words, nullptr, words);
        throw Failure(std::string("shader ") + name + " does not link: " + words, "report it with your OpenGL driver");
    }
    return program;
}
