// SPDX-License-Identifier: MIT
//
// OpenGL without a window, through EGL: for servers and tests.
//
//     viewer::headless context(false);  // OpenGL 3.3 core is current from here on
//
#pragma once

#include <stdexcept>

#include <epoxy/egl.h>

namespace viewer {

/// Thrown where this machine cannot give a context, as opposed to a fault of ours.
struct no_context : std::runtime_error {
    using runtime_error::runtime_error;
};

class headless {
public:
    /// @param es2   OpenGL ES 2 instead of OpenGL 3.3 core
    /// @throws no_context  with the reason
    explicit headless(bool es2);
    ~headless();
    headless(const headless&) = delete;
    headless& operator=(const headless&) = delete;

private:
    EGLDisplay display_;
};

}  // namespace viewer
