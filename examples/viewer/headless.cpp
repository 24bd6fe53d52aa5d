// SPDX-License-Identifier: MIT
#include "headless.hpp"

#include <string>

namespace viewer {
namespace {

/// Mesa's display without any window system where there is one, else what EGL takes for the default.
EGLDisplay open_display() {
    EGLDisplay display = EGL_NO_DISPLAY;
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
        display = eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
    display = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (display != EGL_NO_DISPLAY && eglInitialize(display, nullptr, nullptr)) return display;
    throw no_context("no OpenGL without a window here: EGL opens no display (Debian: libegl1 libgl1-mesa-dri)");
}

}  // namespace

headless::headless(bool es2) : display_(open_display()) {
    const auto fail = [&](const char* what) {
        const EGLint error = eglGetError();
        eglTerminate(display_);
        throw no_context("no OpenGL " + std::string(es2 ? "ES 2" : "3.3") + " without a window here: " + what +
                         ", EGL error " + std::to_string(error));
    };
    const EGLint wish[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
                           es2 ? EGL_OPENGL_ES2_BIT : EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display_, wish, &config, 1, &count) || count == 0) fail("no configuration");
    eglBindAPI(es2 ? EGL_OPENGL_ES_API : EGL_OPENGL_API);
    const EGLint es[] = {EGL_CONTEXT_CLIENT_VERSION, 2, EGL_NONE};
    const EGLint core[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    const EGLContext context = eglCreateContext(display_, config, EGL_NO_CONTEXT, es2 ? es : core);
    if (context == EGL_NO_CONTEXT) fail("no context");
    EGLSurface surface = EGL_NO_SURFACE;  // we draw into textures: a surface only where EGL insists
    if (!epoxy_has_egl_extension(display_, "EGL_KHR_surfaceless_context")) {
        const EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
        surface = eglCreatePbufferSurface(display_, config, size);
    }
    if (!eglMakeCurrent(display_, surface, surface, context)) fail("the context cannot be used");
}

headless::~headless() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglTerminate(display_);
}

}  // namespace viewer
