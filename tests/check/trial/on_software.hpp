// SPDX-License-Identifier: MIT
//
// One investigation of a text, by the software that runs its language here.
#pragma once

#include <doctest/doctest.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>

#include "../program/runs.hpp"

namespace check {

/// True for make prove. Metal compiles a text for a second, so that make test-all takes a sample of its texts.
inline bool all_rounds() { return std::getenv("UMBRAGE_ALL_ROUNDS") != nullptr; }

inline std::unique_ptr<parity::backend> found(parity::dialect in) {
    try {
        return implementation(in);
    } catch (const cannot_run& error) {
        MESSAGE("SKIPPED: ", error.what());
        return nullptr;
    }
}

/// Null where nothing here runs the language: then a test is left out, and says so.
inline parity::backend* software(parity::dialect in) {
    // each a static that is made when it is asked for, and so ends before Vulkan's own
    if (in == parity::dialect::hlsl) {
        static const auto lavapipe = found(in);
        return lavapipe.get();
    }
    if (in == parity::dialect::wgsl) {
        static const auto naga = found(in);
        return naga.get();
    }
    if (in == parity::dialect::msl) {
        static const auto compiler = found(in);
        return compiler.get();
    }
    static const auto llvmpipe = found(in);
    return llvmpipe.get();
}

inline parity::backend* llvmpipe() { return software(parity::version::v330); }

/// @param file   whose ending says the language
inline verdict of_text(std::string_view file, const std::string& text, const std::string& call,
                       const std::string& is = "") {
    guest_text g{.file = std::string(file), .text = text, .call = call};
    if (text.find("shadowMap") != text.npos) g.uniforms[0] = "shadowMap";
    g.in = dialect_of(g.file, text);
    g.is = subject_of(call);
    return investigate(g, {is}, *software(g.in));
}

inline verdict of_glsl(const std::string& text, const std::string& call, const std::string& is = "") {
    return of_text("guest.frag", text, call, is);
}

}  // namespace check
