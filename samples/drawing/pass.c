/* SPDX-License-Identifier: MIT */
#include "pass.h"

#include <stdlib.h>
#include <string.h>

#include "failure.h"
#include "shaders.h"

const sunshine light_day = {{-0.4794f, 0.6592f, -0.5793f}, shader_day_glsl, shader_sky_frag};
const sunshine light_evening = {{0.38f, 0.27f, -0.8847f}, shader_evening_glsl, shader_evening_sky_frag};

GLuint pass_program(const sunshine* l, const char* name, const char* vertex, const char* fragment) {
    char* shading = allocate(strlen(shader_air_glsl) + strlen(l->air) + strlen(fragment) + 1, 1);
    strcat(strcat(strcpy(shading, shader_air_glsl), l->air), fragment);
    const char* const vertex_text[2] = {shader_frame_glsl, vertex};
    const char* const fragment_text[2] = {shader_frame_glsl, shading};
    const GLuint program = make_program(name, vertex_text, fragment_text);
    free(shading);
    glUseProgram(program);
    glUniform1i(uniform(program, "depth_map"), 0);
    glUniform1i(uniform(program, "lit_map"), 1);
    glUniform1i(uniform(program, "transforms"), 2);
    return program;
}

void pass_use(const pass* p, GLuint program) {
    glUseProgram(program);
    glUniform3f(uniform(program, "eye"), p->view.eye.x, p->view.eye.y, p->view.eye.z);
    glUniform3fv(uniform(program, "sun"), 1, p->light->sun);
    glUniform1f(uniform(program, "haze"), p->haze);
    glUniformMatrix4fv(uniform(program, "to_clip"), 1, GL_FALSE, p->view.to_clip.m);
    glUniformMatrix4fv(uniform(program, "to_light"), 1, GL_FALSE, p->to_light.m);
    glUniform2f(uniform(program, "light_box"), p->light_half, p->light_depth);
    glUniform1f(uniform(program, "texel"), p->texel);
    for (GLuint i = 0; i < 2; ++i) {
        glActiveTexture(GL_TEXTURE0 + i);
        glBindTexture(GL_TEXTURE_2D, p->depth_texture);
        glBindSampler(i, p->depth_samplers[i]);
    }
}

void pass_use_for_shadow(const pass* p, GLuint program) {
    glUseProgram(program);
    glUniformMatrix4fv(uniform(program, "to_clip"), 1, GL_FALSE, p->to_light.m);
}
