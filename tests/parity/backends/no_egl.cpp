// SPDX-License-Identifier: MIT
//
// For machines without EGL.
#include "../backend.hpp"

parity::backends parity::egl_backends(std::string_view) { return {}; }
