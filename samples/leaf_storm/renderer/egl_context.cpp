// SPDX-License-Identifier: MIT
#include "renderer/egl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <cstdio>

#include "failure.h"
#include "renderer/gl.h"

EglContext::EglContext() {
    const auto fail = [this](const char* what) {
        char code[32];
        std::snprintf(code, sizeof code, " (EGL 0x%04x)", static_cast<unsigned>(eglGetError()));
        close();
        throw Failure("no OpenGL for the picture: " + std::string(what) + code,
                      "install EGL and a driver (Debian: libegl1 libgl1-mesa-dri), or leave --png out");
    };
    // Mesa's surfaceless platform needs neither display nor device; on other systems the default display can work.
    using GetPlatformDisplay = EGLDisplay (*)(EGLenum, void*, const EGLint*);
    const auto get_platform_display =
        reinterpret_cast<GetPlatformDisplay>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (get_platform_display) display_ = get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr)) {
        display_ = eglGetDisplay(EGL_DEFAULT_DISPLAY);
        if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr)) fail("no EGL display");
    }
    if (!eglBindAPI(EGL_OPENGL_API)) fail("EGL has no desktop OpenGL");
    const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display_, wanted, &config, 1, &count) || count == 0) fail("no configuration");
    const EGLint version[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
    if (context_ == EGL_NO_CONTEXT) fail("no OpenGL 3.3 core context");
    if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
        fail("the context cannot be used without a surface");
}

EglContext::~EglContext() {
    close();
}

std::string EglContext::renderer() const {
    const GLubyte* name = glGetString(GL_RENDERER);
    return name ? reinterpret_cast<const char*>(name) : "unknown";
}

void EglContext::close() {
    if (!display_) return;
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_) eglDestroyContext(display_, context_);
    eglTerminate(display_);
    display_ = context_ = nullptr;
}
