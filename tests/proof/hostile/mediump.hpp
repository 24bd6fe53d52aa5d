// SPDX-License-Identifier: MIT
//
// The two-channel encodings in mediump: the text of the GLSL snippets itself, compiled with a float that is binary16.
#pragma once

#include <umbrage/core/unorm.hpp>

#include "half.hpp"

namespace mediump {
using vec2 = half_vector<2>;
using vec3 = half_vector<3>;
using vec4 = half_vector<4>;
#define UMBRAGE_HIGHP
#define UMBRAGE_PRECISE
#include "rg.glsl.hpp"

// Written through to_unorm into an 8-bit target and sampled again, all in half.
inline vec2 stored(vec2 k, umbrage::unorm_store store) {
    const vec2 written = umbrage_to_unorm(k);
    const auto byte = [store](half c) { return half(umbrage::store_unorm(c.v, store) / 255.0); };
    return {byte(written.x), byte(written.y)};
}

}  // namespace mediump
