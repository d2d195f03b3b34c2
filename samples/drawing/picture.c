/* SPDX-License-Identifier: MIT */
#include "picture.h"

#include <stdlib.h>
#include <string.h>

#include "failure.h"

void picture_create(picture* p) {
    memset(p, 0, sizeof *p);
    glGenFramebuffers(2, p->target);
    glGenRenderbuffers(2, p->colour);
    glGenRenderbuffers(1, &p->depth);
}

void picture_free(picture* p) {
    glDeleteFramebuffers(2, p->target);
    glDeleteRenderbuffers(2, p->colour);
    glDeleteRenderbuffers(1, &p->depth);
    memset(p, 0, sizeof *p);
}

void picture_resize(picture* p, int width, int height) {
    if (p->width == width && p->height == height) return;
    GLint most = 0, samples = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
    glGetIntegerv(GL_MAX_SAMPLES, &samples);
    if (width > most || height > most)
        fail("try a smaller --size", "OpenGL (%s) makes pictures of at most %d pixels", gl_name(), most);
    for (int i = 0; i < 2; ++i) {
        const GLsizei wanted = i == 1 ? 0 : samples < 4 ? samples : 4;
        glBindFramebuffer(GL_FRAMEBUFFER, p->target[i]);
        glBindRenderbuffer(GL_RENDERBUFFER, p->colour[i]);
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, wanted, GL_RGBA8, width, height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, p->colour[i]);
        if (i == 0) {
            glBindRenderbuffer(GL_RENDERBUFFER, p->depth);
            glRenderbufferStorageMultisample(GL_RENDERBUFFER, wanted, GL_DEPTH_COMPONENT24, width, height);
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, p->depth);
        }
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
            fail("try a smaller --size", "OpenGL (%s) cannot make a picture of %d x %d", gl_name(), width, height);
    }
    p->width = width, p->height = height;
}

void picture_begin(const picture* p) {
    glBindFramebuffer(GL_FRAMEBUFFER, p->target[0]);
    glViewport(0, 0, p->width, p->height);
    glEnable(GL_MULTISAMPLE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_TRUE);
    glDisable(GL_BLEND);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void picture_resolve(const picture* p) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, p->target[0]);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, p->target[1]);
    glBlitFramebuffer(0, 0, p->width, p->height, 0, 0, p->width, p->height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, p->target[1]);
}

void picture_read(const picture* p, unsigned char* rgb) {
    const size_t row = 3 * (size_t)p->width, rows = (size_t)p->height;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, p->target[1]);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, p->width, p->height, GL_RGB, GL_UNSIGNED_BYTE, rgb);
    gl_check("reading the picture");
    unsigned char* kept = allocate(row, 1); /* OpenGL's rows begin at the bottom */
    for (size_t y = 0; y < rows / 2; ++y) {
        unsigned char *a = rgb + y * row, *b = rgb + (rows - 1 - y) * row;
        memcpy(kept, a, row);
        memcpy(a, b, row);
        memcpy(b, kept, row);
    }
    free(kept);
}
