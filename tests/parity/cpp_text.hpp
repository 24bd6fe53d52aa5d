// SPDX-License-Identifier: MIT
//
// What generated C++ needs to read GLSL: its names, lent by GLM, and textures. No out parameters, no array
// constructors.
#pragma once

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>

#include "entry.hpp"

namespace parity::glsl_as_cpp {

// Named one by one: a using-directive would let the C library's double functions in.
using glm::abs, glm::acos, glm::asin, glm::atan, glm::ceil, glm::clamp, glm::cos, glm::cross, glm::distance, glm::dot,
    glm::exp, glm::exp2, glm::floatBitsToInt, glm::floatBitsToUint, glm::floor, glm::fract, glm::intBitsToFloat,
    glm::inversesqrt, glm::length, glm::log, glm::log2, glm::max, glm::min, glm::mix, glm::mod, glm::normalize,
    glm::pow, glm::sign, glm::sin, glm::sqrt, glm::step, glm::tan, glm::uintBitsToFloat;
using glm::all, glm::any, glm::equal, glm::greaterThan, glm::greaterThanEqual, glm::lessThan, glm::lessThanEqual,
    glm::notEqual;
using glm::bvec2, glm::bvec3, glm::bvec4, glm::ivec2, glm::ivec3, glm::ivec4, glm::mat3, glm::mat4, glm::vec2,
    glm::vec3, glm::vec4, glm::uint;

using sampler2D = umbrage::image_view<const vec4>;

/// Of a NaN the lower limit, as processors of graphics have it; GLM's would make it a texel's number.
inline vec2 clamp(vec2 v, vec2 low, vec2 high) { return min(max(low, v), high); }

inline vec4 texelFetch(sampler2D map, ivec2 texel, int) { return map[texel]; }
inline ivec2 textureSize(sampler2D map, int) { return map.size; }

/// An entry's call, in the order of entries().
using function = vec4 (*)(const sample&);
extern const std::vector<function> functions;

}  // namespace parity::glsl_as_cpp
