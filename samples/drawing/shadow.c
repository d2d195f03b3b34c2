/* SPDX-License-Identifier: MIT */
#include "shadow.h"

#include "failure.h"
#include "shaders.h"

enum { map_side = 4096 };

void shadow_create(shadow* s) {
    glGenTextures(1, &s->texture);
    glBindTexture(GL_TEXTURE_2D, s->texture);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, map_side, map_side, 0, GL_DEPTH_COMPONENT, GL_FLOAT, NULL);
    glGenFramebuffers(1, &s->target);
    glBindFramebuffer(GL_FRAMEBUFFER, s->target);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, s->texture, 0);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        fail(NULL, "OpenGL (%s) cannot make a shadow map", gl_name());
    glGenSamplers(2, s->samplers);
    for (int i = 0; i < 2; ++i) {
        const GLint filter = i == 0 ? GL_NEAREST : GL_LINEAR;
        glSamplerParameteri(s->samplers[i], GL_TEXTURE_MIN_FILTER, filter);
        glSamplerParameteri(s->samplers[i], GL_TEXTURE_MAG_FILTER, filter);
        glSamplerParameteri(s->samplers[i], GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glSamplerParameteri(s->samplers[i], GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }
    glSamplerParameteri(s->samplers[1], GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    glSamplerParameteri(s->samplers[1], GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
}

void shadow_free(shadow* s) {
    glDeleteFramebuffers(1, &s->target);
    glDeleteTextures(1, &s->texture);
    glDeleteSamplers(2, s->samplers);
}

void shadow_begin(const shadow* s, const camera* c, pass* p) {
    const vec3 back = from_array(p->light->sun), right = unit(cross(v3(0.0f, 1.0f, 0.0f), back)),
               up = cross(back, right);
    /* The visible part lies about equally behind and before the target, near the ground. */
    p->light_half = clamped(1.15f * c->distance, 0.3f, 12.0f);
    p->light_depth = 2.0f * p->light_half + 6.0f;
    p->texel = 2.0f * p->light_half / map_side;
    /* The box moves by whole texels, so that shadow edges stay still while the camera moves. */
    const vec3 ahead = v3(-p->view.back.x, 0.0f, -p->view.back.z);
    vec3 middle = add(v3(c->target.x, 0.0f, c->target.z), scaled(ahead, 0.15f * c->distance));
    const float x = roundf(dot(middle, right) / p->texel) * p->texel, y = roundf(dot(middle, up) / p->texel) * p->texel;
    middle = add(add(scaled(right, x), scaled(up, y)), scaled(back, dot(middle, back)));
    const mat4 view = view_matrix(right, up, back, middle), lens = orthographic(p->light_half, p->light_depth);
    p->to_light = product(&lens, &view);
    p->depth_texture = s->texture;
    for (int i = 0; i < 2; ++i) p->depth_samplers[i] = s->samplers[i];
    glBindFramebuffer(GL_FRAMEBUFFER, s->target);
    glViewport(0, 0, map_side, map_side);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glClear(GL_DEPTH_BUFFER_BIT);
}

int shadow_holds(const pass* p, vec3 middle, float radius) {
    const float reach = 1.0f + radius / p->light_half;
    for (int row = 0; row < 2; ++row) {
        const float* m = p->to_light.m + row;
        const float at = m[0] * middle.x + m[4] * middle.y + m[8] * middle.z + m[12];
        if (fabsf(at) > reach) return 0;
    }
    return 1;
}
