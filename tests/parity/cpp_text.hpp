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

#include <umbrage/light/cube_map.hpp>

#include "texture.hpp"

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

/// Of a NaN the lower limit, as processors of graphics have it; GLM's would make it a texel's number.
inline vec2 clamp(vec2 v, vec2 low, vec2 high) { return min(max(low, v), high); }

/// One kind of GLSL's samplers.
template <int Kind>
struct sampler {
    const filled_texture* of = nullptr;

    [[nodiscard]] vec4 texel(ivec2 at, int layer = 0) const {
        const ivec2 size = of->image.size;
        return umbrage::fetch_clamped(
            umbrage::image_view<const vec4>(of->texels.data() + size.x * size.y * layer, size), at);
    }
    /// Of a point in [0, 1]: the texel that it lies in,
    [[nodiscard]] ivec2 under(vec2 p) const { return ivec2(floor(p * vec2(of->image.size))); }
    /// and the one before it both ways.
    [[nodiscard]] ivec2 before(vec2 p) const { return ivec2(floor(p * vec2(of->image.size) - 0.5f)); }
    [[nodiscard]] float compared(float receiver, ivec2 at, int layer) const {
        const float stored = texel(at, layer).x;
        return (of->image.compare == texture_image::less_equal ? receiver <= stored : receiver >= stored) ? 1.0f : 0.0f;
    }
    /// As gathers have them.
    template <class Of>
    [[nodiscard]] static vec4 four(ivec2 at, Of&& value) {
        return {value(at + ivec2(0, 1)), value(at + ivec2(1, 1)), value(at + ivec2(1, 0)), value(at)};
    }
    [[nodiscard]] float compared(float receiver, vec2 p, int layer) const {
        const ivec2 size = of->image.size;
        if (!of->image.linear) return compared(receiver, under(p), layer);
        const vec2 weight = fract(p * vec2(size) - 0.5f);
        const vec4 lit = four(before(p), [&](ivec2 at) { return compared(receiver, at, layer); });
        return mix(mix(lit.w, lit.z, weight.x), mix(lit.x, lit.y, weight.x), weight.y);
    }
};
using sampler2D = sampler<0>;
using sampler2DArray = sampler<1>;
using samplerCube = sampler<2>;
using usampler2D = sampler<3>;
using sampler2DShadow = sampler<4>;
using sampler2DArrayShadow = sampler<5>;

template <int Kind>
ivec2 textureSize(sampler<Kind> map, int) {
    return map.of->image.size;
}
inline vec4 texelFetch(sampler2D map, ivec2 texel, int) { return map.texel(texel); }
inline vec4 texelFetch(sampler2DArray map, ivec3 texel, int) { return map.texel(ivec2(texel), texel.z); }
inline vec4 texelFetch(usampler2D map, ivec2 texel, int) { return map.texel(texel) * bound_map::whole; }
inline vec4 textureLod(sampler2D map, vec2 p, float) { return map.texel(map.under(p)); }
inline vec4 textureLod(sampler2DArray map, vec3 p, float) { return map.texel(map.under(vec2(p)), int(p.z)); }
inline vec4 textureLod(samplerCube map, vec3 direction, float) {
    const vec3 at = umbrage::cube_coordinate(direction);
    return map.texel(map.under(vec2(at)), int(at.z));
}
inline vec4 textureGather(sampler2D map, vec2 p, int channel) {
    return map.four(map.before(p), [&](ivec2 at) { return map.texel(at)[channel]; });
}
inline vec4 textureGather(sampler2DArray map, vec3 p, int channel) {
    return map.four(map.before(vec2(p)), [&](ivec2 at) { return map.texel(at, int(p.z))[channel]; });
}
inline float textureLod(sampler2DShadow map, vec3 p, float) { return map.compared(p.z, vec2(p), 0); }
inline float textureGrad(sampler2DArrayShadow map, vec4 p, vec2, vec2) { return map.compared(p.w, vec2(p), int(p.z)); }
inline vec4 textureGather(sampler2DShadow map, vec2 p, float receiver) {
    return map.four(map.before(p), [&](ivec2 at) { return map.compared(receiver, at, 0); });
}
inline vec4 textureGather(sampler2DArrayShadow map, vec3 p, float receiver) {
    return map.four(map.before(vec2(p)), [&](ivec2 at) { return map.compared(receiver, at, int(p.z)); });
}

/// An entry's call, in the order of entries().
using function = vec4 (*)(const sample&, const filled_texture* const*);
extern const std::vector<function> functions;

}  // namespace parity::glsl_as_cpp
