// SPDX-License-Identifier: MIT
//
// One investigation of a GLSL text on llvmpipe.
#pragma once

#include <doctest/doctest.h>

#include <string>

#include "../program/runs.hpp"

namespace check {

/// Null where there is no EGL: then a test is left out, and says so.
inline parity::backend* llvmpipe() {
    static const std::unique_ptr<parity::backend> one = []() -> std::unique_ptr<parity::backend> {
        try {
            return implementation(parity::version::v330);
        } catch (const cannot_run& error) {
            MESSAGE("SKIPPED: ", error.what());
            return nullptr;
        }
    }();
    return one.get();
}

inline verdict of_glsl(const std::string& text, const std::string& call, const std::string& is = "") {
    guest_text g{.file = "guest.frag", .text = text, .call = call};
    if (text.find("uniform sampler2D shadowMap;") != text.npos) g.uniforms[0] = "shadowMap";
    g.in = dialect_of(g.file, text);
    g.is = subject_of(call);
    return investigate(g, {is}, *llvmpipe());
}

}  // namespace check
