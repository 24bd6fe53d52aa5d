// SPDX-License-Identifier: MIT
//
// Context in which generated C++ reads GLSL: GLSL's names, from GLM, and textures. There are no out parameters and no
// array constructors.
#pragma once

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>

#include <umbrage/light/point/cube_map.hpp>

#ifdef PARITY_ARITHMETIC
#include "../arithmetic/vectors.hpp"
#endif
#include "../texture.hpp"

// The text is compiled several times, in a namespace each: with floats (glsl_as_cpp), with floats that are fused
// (glsl_as_fused), with numbers of arithmetic/ (glsl_as_numbers, which defines PARITY_ARITHMETIC).
#ifndef PARITY_TEXT
#define PARITY_TEXT glsl_as_cpp
#endif
namespace parity::PARITY_TEXT {

// Named one by one: a using-directive would let the C library's double functions in.
#ifdef PARITY_ARITHMETIC
using arithmetic::abs, arithmetic::ceil, arithmetic::clamp, arithmetic::dot, arithmetic::exp2,
    arithmetic::floatBitsToUint, arithmetic::floor, arithmetic::fract, arithmetic::given, arithmetic::max,
    arithmetic::min, arithmetic::read, arithmetic::sqrt, arithmetic::uintBitsToFloat;
using glsl_float = arithmetic::number;
#else
using glsl_float = float;
using glm::abs, glm::ceil, glm::clamp, glm::dot, glm::exp2, glm::floatBitsToUint, glm::floor, glm::fract, glm::max,
    glm::min, glm::sqrt, glm::uintBitsToFloat;
/// Clamped vector. A NaN becomes the lower limit, as on GPUs. GLM's clamp would make it a texel's number.
inline glm::vec2 clamp(glm::vec2 v, glm::vec2 low, glm::vec2 high) { return min(max(low, v), high); }
inline float given(float v) { return v; }
inline float read(float v, int) { return v; }
#endif
using glm::ivec2, glm::ivec3, glm::uint;
using vec2 = glm::vec<2, glsl_float>;
using vec3 = glm::vec<3, glsl_float>;
using vec4 = glm::vec<4, glsl_float>;
using mat4 = glm::mat<4, 4, glsl_float>;

/// Arguments and result of a call.
inline vec4 given(glm::vec4 v) { return {given(v.x), given(v.y), given(v.z), given(v.w)}; }

/// Linear filter of four values around `at`, with texel centers at integers.
template <class Value>
[[nodiscard]] float weighted(glm::dvec2 at, Value&& value) {
    const glm::dvec2 first = floor(at), weight = at - first;
    const ivec2 texel(first);
    return float(glm::mix(glm::mix(double(value(texel)), double(value(texel + ivec2(1, 0))), weight.x),
                          glm::mix(double(value(texel + ivec2(0, 1))), double(value(texel + ivec2(1, 1))), weight.x),
                          weight.y));
}
#ifdef PARITY_ARITHMETIC
/// Linear filter with weights of as many bits as the rules have. A sampler's result is continuous, so the choice of
/// texels decides nothing.
template <class Value>
[[nodiscard]] glsl_float bilinear(vec2 at, Value&& value) {
    const int bits = arithmetic::rules_in_use().sub_texel_bits;
    glm::dvec2 snapped(0.0), real(0.0);
    double error = 0.0;
    for (int c : {0, 1}) {
        const double v = at[c].value(), steps = std::ldexp(1.0, bits);
        const arithmetic::knowledge k = known(at[c]);
        snapped[c] = bits ? std::floor(v * steps + (arithmetic::drawn(2) ? 0.5 : 0.0)) / steps : v;
        real[c] = k.real;
        error += k.bound() + (bits ? 1.0 / steps : 0.0);
    }
    return arithmetic::made(weighted(snapped, value), weighted(real, value), error);
}
#else
template <class Value>
[[nodiscard]] float bilinear(vec2 at, Value&& value) {
    const vec2 first = floor(at), weight = at - first;
    const ivec2 texel(first);
    return glm::mix(glm::mix(value(texel), value(texel + ivec2(1, 0)), weight.x),
                    glm::mix(value(texel + ivec2(0, 1)), value(texel + ivec2(1, 1)), weight.x), weight.y);
}
#endif

/// One kind of GLSL's samplers.
template <int Kind>
struct sampler {
    const filled_texture* of = nullptr;

    [[nodiscard]] vec4 texel(ivec2 at, int layer = 0) const {
        const ivec2 size = of->image.size;
        const glm::vec4 v = umbrage::fetch_clamped(
            umbrage::image_view<const glm::vec4>(of->texels.data() + size.x * size.y * layer, size), at);
        return {read(v.x, of->unorm_bits), read(v.y, of->unorm_bits), read(v.z, of->unorm_bits),
                read(v.w, of->unorm_bits)};
    }
    /// Texel that contains a point in [0, 1].
    [[nodiscard]] ivec2 under(vec2 p) const { return ivec2(floor(p * vec2(of->image.size))); }
    /// First of the four texels around a point in [0, 1].
    [[nodiscard]] ivec2 before(vec2 p) const { return ivec2(floor(p * vec2(of->image.size) - glsl_float(0.5f))); }
    [[nodiscard]] float compared(glsl_float receiver, ivec2 at, int layer) const {
        const glsl_float stored = texel(at, layer).x;
        return (of->image.compare == texture_image::less_equal ? receiver <= stored : receiver >= stored) ? 1.0f : 0.0f;
    }
    /// As gathers have them.
    template <class Of>
    [[nodiscard]] static vec4 four(ivec2 at, Of&& value) {
        return {glsl_float(value(at + ivec2(0, 1))), glsl_float(value(at + ivec2(1, 1))),
                glsl_float(value(at + ivec2(1, 0))), glsl_float(value(at))};
    }
    [[nodiscard]] glsl_float compared(glsl_float receiver, vec2 p, int layer) const {
        if (!of->image.linear) return compared(receiver, under(p), layer);
        const auto lit = [&](ivec2 at) { return compared(receiver, at, layer); };
        return bilinear(p * vec2(of->image.size) - glsl_float(0.5f), lit);
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
inline vec4 texelFetch(usampler2D map, ivec2 texel, int) { return map.texel(texel) * glsl_float(bound_map::whole); }
inline vec4 textureLod(sampler2D map, vec2 p, glsl_float) { return map.texel(map.under(p)); }
inline vec4 textureLod(sampler2DArray map, vec3 p, glsl_float) { return map.texel(map.under(vec2(p)), int(p.z)); }
inline vec4 textureLod(samplerCube map, vec3 direction, glsl_float) {
    const glm::vec3 at = umbrage::cube_coordinate(glm::vec3(direction));
    return map.texel(ivec2(glm::floor(glm::vec2(at) * glm::vec2(map.of->image.size))), int(at.z));
}
inline vec4 textureGather(sampler2D map, vec2 p, int channel) {
    return map.four(map.before(p), [&](ivec2 at) { return map.texel(at)[channel]; });
}
inline vec4 textureGather(sampler2DArray map, vec3 p, int channel) {
    return map.four(map.before(vec2(p)), [&](ivec2 at) { return map.texel(at, int(p.z))[channel]; });
}
inline glsl_float textureLod(sampler2DShadow map, vec3 p, glsl_float) { return map.compared(p.z, vec2(p), 0); }
inline glsl_float textureGrad(sampler2DArrayShadow map, vec4 p, vec2, vec2) {
    return map.compared(p.w, vec2(p), int(p.z));
}
inline vec4 textureGather(sampler2DShadow map, vec2 p, glsl_float receiver) {
    return map.four(map.before(p), [&](ivec2 at) { return map.compared(receiver, at, 0); });
}
inline vec4 textureGather(sampler2DArrayShadow map, vec3 p, glsl_float receiver) {
    return map.four(map.before(vec2(p)), [&](ivec2 at) { return map.compared(receiver, at, int(p.z)); });
}

/// An entry's call, in the order of entries().
using function = vec4 (*)(const sample&, const filled_texture* const*);
extern const std::vector<function> functions;

}  // namespace parity::PARITY_TEXT
