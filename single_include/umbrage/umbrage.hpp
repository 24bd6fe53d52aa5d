// SPDX-License-Identifier: MIT
//
// All of umbrage in one file, made by single_include/amalgamate.cmake: do not edit.
//
// MIT License
//
// Copyright (c) 2026 the umbrage authors
//
// Permission is hereby granted, free of charge, to any person obtaining a copy
// of this software and associated documentation files (the "Software"), to deal
// in the Software without restriction, including without limitation the rights
// to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
// copies of the Software, and to permit persons to whom the Software is
// furnished to do so, subject to the following conditions:
//
// The above copyright notice and this permission notice shall be included in all
// copies or substantial portions of the Software.
//
// THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
// IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
// FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
// AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
// LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
// OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
// SOFTWARE.
//

#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <glm/common.hpp>
#include <glm/fwd.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_precision.hpp>
#include <glm/mat2x2.hpp>
#include <glm/mat2x3.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <map>
#include <new>
#include <numbers>
#include <optional>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

// ---- umbrage/config.hpp
// What depends on the compiler or its flags, outside of simd/: how errors are reported, and how bits are read.
//
//     umbrage::set_error_handler([](const char* message) { log(message); std::exit(1); });  // with -fno-exceptions
//

// A function that is compiled for whatever instruction set its caller is compiled for.
#if defined(__GNUC__) || defined(__clang__)
#define UMBRAGE_INLINE __attribute__((always_inline))
#else
#define UMBRAGE_INLINE
#endif

namespace umbrage {

/// Takes the message of an error, "umbrage::function: what is wrong". Where exceptions are switched off, set-up
/// functions call it in place of throwing std::invalid_argument, and end the program if it returns.
using error_handler = void (*)(const char* message);

namespace detail {

inline error_handler handler = nullptr;

/// Reports bad input to a set-up function.
/// @throws std::invalid_argument   where exceptions are switched on
[[noreturn]] inline void fail(const std::string& message) {
#if defined(__cpp_exceptions)
    throw std::invalid_argument(message);
#else
    if (handler) handler(message.c_str());
    else std::fprintf(stderr, "%s\n", message.c_str());
    std::abort();
#endif
}

/// std::bit_cast, which some libraries of C++20 lack.
template <class To, class From>
[[nodiscard]] UMBRAGE_INLINE constexpr To bit_cast(const From& from) {
#if defined(__cpp_lib_bit_cast)
    return std::bit_cast<To>(from);
#else
    return __builtin_bit_cast(To, from);
#endif
}

}  // namespace detail

/// Sets what bad input leads to where exceptions are switched off; where they are on, nothing calls it.
/// @param handler   nullptr: the message goes to standard error and the program ends
/// @return          the one before
inline error_handler set_error_handler(error_handler handler) {
    const error_handler before = detail::handler;
    detail::handler = handler;
    return before;
}

}  // namespace umbrage

// ---- umbrage/shader/snippet.hpp
// GLSL twins: what a snippet is. Texts are made of them in glsl.hpp.
//

namespace umbrage::glsl {

/// How exactly a snippet and its C++ twin agree.
///   a  bit for bit on every implementation: every intermediate is representable, so nothing can round
///   b  bit for bit where + - * round to nearest in written order; a few ulp elsewhere
///   c  within snippet::ulp units in the last place on every implementation tried: division, square root; or within
///      snippet::within, where the hardware has weights of its own
enum class tier { a, b, c };

/// A GLSL dialect. `vulkan` is GLSL 450 with GL_KHR_vulkan_glsl.
enum class version { v100, v110, v120, v130, v150, v300_es, v310_es, v320_es, v330, v430, v450, v460, vulkan };

inline constexpr std::array versions{version::v100,    version::v110,    version::v120,    version::v130, version::v150,
                                     version::v300_es, version::v310_es, version::v320_es, version::v330, version::v430,
                                     version::v450,    version::v460,    version::vulkan};

/// What follows `#version`, e.g. "300 es".
[[nodiscard]] constexpr std::string_view directive(version v) {
    switch (v) {
        case version::v100: return "100";
        case version::v110: return "110";
        case version::v120: return "120";
        case version::v130: return "130";
        case version::v150: return "150";
        case version::v300_es: return "300 es";
        case version::v310_es: return "310 es";
        case version::v320_es: return "320 es";
        case version::v330: return "330";
        case version::v430: return "430";
        case version::v450: return "450";
        case version::v460: return "460";
        case version::vulkan: return "450";
    }
    return "";
}

/// What of a snippet is a map's own affair. The text of such a snippet is what holds for a shader's one map, with
/// macros to change it; bind() puts another in its place.
enum class hook {
    none,
    cleared_depth,
    beyond_far,
    before_far,
    compare,
    texel,
    fetch_depth,
    lit,
    lit_2x2,
    gather_lit,
    lit_filtered,
    lit_at,
    depth_at,
    chosen
};

struct snippet;

/// Snippets that lie in a list<>; a span, but for what it costs to compile.
struct snippet_span {
    const snippet* const* first = nullptr;
    std::size_t size = 0;

    constexpr snippet_span() = default;
    template <std::size_t Size>
    constexpr snippet_span(const std::array<const snippet*, Size>& snippets) : first(snippets.data()), size(Size) {}
    [[nodiscard]] constexpr const snippet* const* begin() const { return first; }
    [[nodiscard]] constexpr const snippet* const* end() const { return first + size; }
};

/// A snippet's GLSL: as it is written down, or what a function puts together each time it is asked for, which spares
/// whoever includes the header the work.
class snippet_text {
public:
    constexpr snippet_text(const char* written) : written_(written) {}
    constexpr snippet_text(std::string (*make)()) : make_(make) {}

    [[nodiscard]] std::string str() const { return make_ ? make_() : written_; }

private:
    const char* written_ = "";
    std::string (*make_)() = nullptr;
};

/// One GLSL function (with its overloads) and what is known of it.
struct snippet {
    std::string_view name;       ///< of the C++ twin; the GLSL function is umbrage_<name>
    std::string_view summary{};  ///< one line
    tier exactness = tier::a;
    int ulp = 0;                     ///< tier c: greatest distance from the C++ twin, twice the worst seen or 1
    float within = 0.0f;             ///< tier c without ulp: greatest difference from the C++ twin
    version lowest = version::v100;  ///< v100: every dialect; v300_es: 300 es and 330 upwards
    snippet_span needs{};            ///< a list<>
    hook role = hook::none;
    bool scaled = false;  ///< makes depths on a scale of their own, on which 1.0 is not the far plane
    snippet_text source;

    /// No two have one name.
    friend constexpr bool operator==(const snippet& a, const snippet& b) { return a.name == b.name; }
};

/// Snippets in a row: those that one needs, a header's, a room's.
template <const snippet*... Snippets>
inline constexpr std::array<const snippet*, sizeof...(Snippets)> list{Snippets...};

/// True when `s` compiles in dialect `v`.
[[nodiscard]] constexpr bool supports(const snippet& s, version v) {
    return s.lowest == version::v100 || v >= version::v300_es;
}

namespace detail {

struct constant {
    char key;  ///< `$key` in the text
    int value;
    std::string_view text{};  ///< in place of the value's digits, though it be ""
};

/// Appends `text` with each `$key` replaced by the decimal digits of its value, or its text.
template <class Text>
constexpr void append(Text& out, std::string_view text, std::initializer_list<constant> constants) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '$') {
            out.push_back(text[i]);
            continue;
        }
        ++i;
        for (const constant& c : constants) {
            if (c.key != text[i]) continue;
            for (char letter : c.text) out.push_back(letter);
            if (c.text.data() != nullptr) continue;
            if (c.value < 0) out.push_back('-');
            const int digits = c.value < 0 ? -c.value : c.value;
            int unit = 1;
            while (digits / unit >= 10) unit *= 10;
            for (; unit > 0; unit /= 10) out.push_back(static_cast<char>('0' + digits / unit % 10));
        }
    }
}

/// Of a family's member: its text.
[[nodiscard]] inline std::string filled(std::string_view text, std::initializer_list<constant> constants) {
    std::string out;
    append(out, text, constants);
    return out;
}

/// Its name, at compile time.
struct short_name {
    char data[24]{};
    std::size_t size = 0;

    constexpr short_name(std::string_view text, std::initializer_list<constant> constants) {
        append(*this, text, constants);
    }
    constexpr void push_back(char letter) { data[size++] = letter; }
    [[nodiscard]] constexpr std::string_view view() const { return {data, size}; }
};

}  // namespace detail
}  // namespace umbrage::glsl

// ---- umbrage/clip_space.hpp
// Conventions as values: which way the camera looks, what depth means, where the first texel is.
// Passed explicitly everywhere; GLM's configuration macros are neither read nor needed.
//
//     auto light = umbrage::make_spot_light({.position = p, .direction = d, .clip = umbrage::vulkan_clip_space});
//

namespace umbrage {

/// Of the world and of view space alike, as in lookAtRH and lookAtLH: the view is a rotation, never a mirror.
/// Seen from the light, x is to the right and y up; right looks down -z, left down +z. A mesh keeps its winding: what
/// goes clockwise for the light goes clockwise in NDC, y up.
enum class handedness { right, left };
enum class depth_range { zero_to_one, minus_one_to_one };  ///< of z/w between the planes
enum class depth_direction { forward, reversed };          ///< reversed: the near plane has the greater depth
enum class texture_origin { bottom, top };                 ///< where texel (0, 0) is: at NDC y = -1, or y = +1

struct clip_space {
    handedness hand = handedness::right;
    depth_range range = depth_range::zero_to_one;
    depth_direction direction = depth_direction::forward;
    texture_origin origin = texture_origin::bottom;

    friend constexpr bool operator==(const clip_space&, const clip_space&) = default;
};

/// Right-handed world, z/w in [-1, 1], texels from the bottom. With glClipControl: vulkan_clip_space.
inline constexpr clip_space opengl_clip_space{.range = depth_range::minus_one_to_one};

/// Right-handed world, z/w in [0, 1]; the first texel is at NDC y = -1, which Vulkan draws at the top.
inline constexpr clip_space vulkan_clip_space{};

/// Left-handed world, as D3DXMatrixLookAtLH has it, z/w in [0, 1], texels from the top.
inline constexpr clip_space direct3d_clip_space{.hand = handedness::left, .origin = texture_origin::top};

/// Right-handed world, z/w in [0, 1], texels from the top: WebGPU as three.js and glTF viewers use it, and right-handed
/// worlds under Direct3D. WebGPU and Metal have no hand of their own: for a left-handed world take direct3d_clip_space.
inline constexpr clip_space webgpu_clip_space{.origin = texture_origin::top};
inline constexpr clip_space metal_clip_space = webgpu_clip_space;

/// The depth of the far plane, to which a map is cleared.
[[nodiscard]] constexpr float cleared_depth(depth_direction direction) {
    return direction == depth_direction::forward ? 1.0f : 0.0f;
}
[[nodiscard]] constexpr float cleared_depth(clip_space clip) { return cleared_depth(clip.direction); }

namespace glsl {

inline constexpr snippet cleared_depth{
    .name = "cleared_depth",
    .summary = "depth of the far plane",
    .exactness = tier::a,
    .role = hook::cleared_depth,
    .source = R"GLSL(
// umbrage_cleared_depth: depth of the far plane, 1.0; after #define UMBRAGE_REVERSED 0.0
UMBRAGE_HIGHP float umbrage_cleared_depth() {
#ifdef UMBRAGE_REVERSED
    return 0.0;
#else
    return 1.0;
#endif
}
)GLSL",
};

inline constexpr auto clip_space_snippets = list<&cleared_depth>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/scalar.hpp
// The scalar ground rules: which types are depths, what NaN means, what clamping does.
//
//     float d = umbrage::saturate(z);  // everything from 1 up, and NaN: 1;  everything from 0 down: 0
//

namespace umbrage {

/// Scalars that primitives work on.
template <class T>
concept real = std::same_as<T, float> || std::same_as<T, double>;

/// Tests the bits, so that -ffast-math cannot remove it.
[[nodiscard]] constexpr bool is_nan(float v) {
    return (detail::bit_cast<std::uint32_t>(v) & 0x7FFFFFFFu) > 0x7F800000u;
}
[[nodiscard]] constexpr bool is_nan(double v) {
    return (detail::bit_cast<std::uint64_t>(v) & 0x7FFFFFFFFFFFFFFFull) > 0x7FF0000000000000ull;
}

/// True for everything but NaN and the infinities.
[[nodiscard]] constexpr bool is_finite(float v) {
    return (detail::bit_cast<std::uint32_t>(v) & 0x7FFFFFFFu) < 0x7F800000u;
}
[[nodiscard]] constexpr bool is_finite(double v) {
    return (detail::bit_cast<std::uint64_t>(v) & 0x7FFFFFFFFFFFFFFFull) < 0x7FF0000000000000ull;
}

namespace detail {

/// Of a vector or a matrix: true when no element is NaN or infinite.
template <class Elements>
[[nodiscard]] constexpr bool all_finite(const Elements& v) {
    for (decltype(v.length()) i = 0; i < v.length(); ++i) {
        if constexpr (requires { is_finite(v[i]); }) {
            if (!is_finite(v[i])) return false;
        } else if (!all_finite(v[i])) {
            return false;
        }
    }
    return true;
}

}  // namespace detail

/// Clamps to [0, 1]. NaN of either sign becomes far, the cleared depth; -0 becomes +0.
/// @param far   1, or 0 where depth is reversed
/// @formula     v >= 1 ? 1 : (v > 0 ? v : (v <= 0 ? 0 : far))
/// @exactness   A: selects, never computes; by the order of the bits, so that -ffast-math leaves no -0 and no
///              flushing mode takes a denormal
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T saturate(T v, T far = T(1)) {
    using bits = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
    const auto own = detail::bit_cast<bits>(v), one = detail::bit_cast<bits>(T(1)), below = own < one ? own : one;
    return detail::bit_cast<T>(is_nan(v) ? detail::bit_cast<bits>(far) : (below > 0 ? below : 0));
}

namespace glsl {

inline constexpr snippet saturate{
    .name = "saturate",
    .summary = "clamp to [0, 1], NaN to far",
    .exactness = tier::a,
    .needs = list<&cleared_depth>,
    .source = R"GLSL(
// umbrage_saturate: v clamped to [0, 1]; NaN becomes the far plane's depth
UMBRAGE_HIGHP float umbrage_saturate(UMBRAGE_HIGHP float v) {
    // not v > 0.0 ? v : 0.0, of which Mesa makes max(v, 0.0): softpipe's gives NaN for a signalling one
    return v > 0.0 && v < 1.0 ? v : (v >= 1.0 ? 1.0 : (v <= 0.0 ? 0.0 : umbrage_cleared_depth()));
}
)GLSL",
};

inline constexpr auto scalar_snippets = list<&saturate>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/compare.hpp
// The depth test of a shadow map, and the two classic samples' ways to write it.
//
//     bool lit = umbrage::less_equal{}(receiver - bias, stored);
//
// Filters compare once per texel with less_equal and no epsilon inside; for reversed Z pass greater_equal, or
// comparison where the direction is known when the program runs (in GLSL: #define UMBRAGE_REVERSED). A NaN on either
// side is in shadow. A receiver beyond the far plane, where no map reaches, is lit: filters ask beyond_far before they
// compare.

namespace umbrage {

/// Lit when the receiver is no farther than the stored occluder.
/// @exactness     A
struct less_equal {
    template <real T>
    [[nodiscard]] constexpr bool operator()(T receiver, T stored) const {
        return !is_nan(receiver) && !is_nan(stored) && receiver <= stored;
    }
    template <real T>
    [[nodiscard]] static constexpr bool beyond_far(T receiver) {
        return !is_nan(receiver) && receiver > T(1);
    }
    template <real T>
    [[nodiscard]] static constexpr T towards_light(T depth, T by) {
        return depth - by;
    }
};

/// The same for reversed Z, where near is 1.
struct greater_equal {
    template <real T>
    [[nodiscard]] constexpr bool operator()(T receiver, T stored) const {
        return !is_nan(receiver) && !is_nan(stored) && receiver >= stored;
    }
    template <real T>
    [[nodiscard]] static constexpr bool beyond_far(T receiver) {
        return !is_nan(receiver) && receiver < T(0);
    }
    template <real T>
    [[nodiscard]] static constexpr T towards_light(T depth, T by) {
        return depth + by;
    }
};

/// less_equal for depths on a scale of their own, as level_rg and decode_ps14 have them, where 1 is not the far plane:
/// receivers beyond it come in as what every texel lights.
struct less_equal_scaled : less_equal {
    template <real T>
    [[nodiscard]] static constexpr bool beyond_far(T) {
        return false;
    }
};

/// less_equal, or greater_equal where depth is reversed.
struct comparison {
    depth_direction direction = depth_direction::forward;

    template <real T>
    [[nodiscard]] constexpr bool operator()(T receiver, T stored) const {
        return direction == depth_direction::forward ? less_equal{}(receiver, stored)
                                                     : greater_equal{}(receiver, stored);
    }
    template <real T>
    [[nodiscard]] constexpr bool beyond_far(T receiver) const {
        return direction == depth_direction::forward ? less_equal::beyond_far(receiver)
                                                     : greater_equal::beyond_far(receiver);
    }
    template <real T>
    [[nodiscard]] constexpr T towards_light(T depth, T by) const {
        return direction == depth_direction::forward ? less_equal::towards_light(depth, by)
                                                     : greater_equal::towards_light(depth, by);
    }
};

/// True for receivers behind the far plane, where no map reaches; never for a comparison on a scale of its own.
/// @exactness     A
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr bool beyond_far(T receiver, const Compare& is_lit = {}) {
    if constexpr (requires { is_lit.beyond_far(receiver); }) return is_lit.beyond_far(receiver);
    else return false;
}

/// True for receivers up to the far plane; false beyond it, and for NaN, which neither beyond_far nor this is true of.
/// @exactness     A
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr bool before_far(T receiver, const Compare& is_lit = {}) {
    return !is_nan(receiver) && !beyond_far(receiver, is_lit);
}

/// Visibility of one comparison.
/// @param receiver   depth, biased;   stored  depth from the map
/// @return           1 when lit, 0 in shadow
/// @exactness        A
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr T compare(T receiver, T stored, Compare is_lit = {}) {
    return is_lit(receiver, stored) ? T(1) : T(0);
}

/// Visibility as the DirectX SDK's ShadowMap sample tests it.
/// @param receiver, stored   depths;   epsilon  in depth, added to the stored side
/// @return        0 when stored + epsilon < receiver, else 1: NaN is lit here
/// @exactness     B: one sum
/// @cite          Microsoft DirectX SDK, ShadowMap sample
template <real T>
[[nodiscard]] constexpr T compare_dx_sdk(T receiver, T stored, T epsilon) {
    const T limit = stored + epsilon;
    return !is_nan(limit) && !is_nan(receiver) && limit < receiver ? T(0) : T(1);
}

/// Visibility as the directional-light exercise tests it.
/// @param current, stored    depths;   epsilon  in depth, added to the stored side
/// @return        1 when current < stored + epsilon, else 0: NaN is in shadow here
/// @exactness     B: one sum
template <real T>
[[nodiscard]] constexpr T compare_exercise(T current, T stored, T epsilon) {
    const T limit = stored + epsilon;
    return !is_nan(limit) && !is_nan(current) && current < limit ? T(1) : T(0);
}

namespace glsl {

inline constexpr snippet beyond_far{
    .name = "beyond_far",
    .summary = "receivers behind the far plane",
    .exactness = tier::a,
    .role = hook::beyond_far,
    .source = R"GLSL(
// UMBRAGE_BEYOND_FAR: receivers behind the far plane, which no map shadows
#ifndef UMBRAGE_BEYOND_FAR
#ifdef UMBRAGE_REVERSED
#define UMBRAGE_BEYOND_FAR(receiver) ((receiver) < 0.0)
#else
#define UMBRAGE_BEYOND_FAR(receiver) ((receiver) > 1.0)
#endif
#endif
// umbrage_beyond_far: whether a receiver is behind the far plane
bool umbrage_beyond_far(UMBRAGE_HIGHP float receiver) {
    return UMBRAGE_BEYOND_FAR(receiver);
}
)GLSL",
};

inline constexpr snippet before_far{
    .name = "before_far",
    .summary = "receivers up to the far plane, NaN is none",
    .exactness = tier::a,
    .needs = list<&beyond_far>,
    .role = hook::before_far,
    .source = R"GLSL(
// umbrage_before_far: whether a receiver is a number, and not behind the far plane
bool umbrage_before_far(UMBRAGE_HIGHP float receiver) {
    // a sum of choices, not an or of comparisons, which compilers take for true
    UMBRAGE_HIGHP float number = (receiver > 0.0 ? 1.0 : 0.0) + (receiver <= 0.0 ? 1.0 : 0.0);
    return umbrage_beyond_far(receiver) ? false : number > 0.5;
}
)GLSL",
};

inline constexpr snippet compare{
    .name = "compare",
    .summary = "one comparison",
    .exactness = tier::a,
    .role = hook::compare,
    .source = R"GLSL(
// UMBRAGE_LIT: 1.0 when the receiver is no farther than the stored depth, after #define UMBRAGE_REVERSED no less
#ifndef UMBRAGE_LIT
#ifdef UMBRAGE_REVERSED
#define UMBRAGE_LIT(receiver, stored) ((receiver) >= (stored) ? 1.0 : 0.0)
#else
#define UMBRAGE_LIT(receiver, stored) ((receiver) <= (stored) ? 1.0 : 0.0)
#endif
#endif
// umbrage_compare: visibility of one comparison
UMBRAGE_HIGHP float umbrage_compare(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return UMBRAGE_LIT(receiver, stored);
}
)GLSL",
};

inline constexpr snippet compare_dx_sdk{
    .name = "compare_dx_sdk",
    .summary = "stored + epsilon < receiver is shadow",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_compare_dx_sdk: 0.0 when stored + epsilon < receiver, else 1.0
UMBRAGE_HIGHP float umbrage_compare_dx_sdk(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored,
                                           UMBRAGE_HIGHP float epsilon) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float limit = stored + epsilon;
    return limit < receiver ? 0.0 : 1.0;
}
)GLSL",
};

inline constexpr snippet compare_exercise{
    .name = "compare_exercise",
    .summary = "current < stored + epsilon is lit",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_compare_exercise: 1.0 when current < stored + epsilon, else 0.0
UMBRAGE_HIGHP float umbrage_compare_exercise(UMBRAGE_HIGHP float current, UMBRAGE_HIGHP float stored,
                                             UMBRAGE_HIGHP float epsilon) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float limit = stored + epsilon;
    return current < limit ? 1.0 : 0.0;
}
)GLSL",
};

inline constexpr auto compare_snippets = list<&beyond_far, &before_far, &compare, &compare_dx_sdk, &compare_exercise>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/bias/constant.hpp
// A receiver moved towards the light, which is what every bias in depth comes to.
//
//     float receiver = umbrage::biased(p.z, bias, filter.is_lit);  // p.z - bias, or p.z + bias where depth is reversed
//

namespace umbrage {

/// A bias in depth within its range: with 1 nothing is in shadow, so that no bias need be greater.
/// @return        0 below 2^-64, so that no denormal counts; 1 from 1 up, and for NaN
/// @exactness     A: selects
template <real T>
[[nodiscard]] constexpr T clamp_bias(T bias) {
    const T clamped = saturate(bias);
    return clamped < T(0x1p-64) ? T(0) : clamped;
}

/// A receiver moved towards the light; the direction of depth is the comparison's.
///
/// @param receiver   depth; NaN stays NaN, in shadow
/// @param bias       in depth: towards the light above 0, away from it below; of 2^64 and more, and NaN: none
/// @param is_lit     less_equal, greater_equal or comparison: the filter's own
/// @return           the receiver that a filter compares
/// @formula          receiver - bias; receiver + bias where depth is reversed
/// @exactness        B: one sum
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr T biased(T receiver, T bias, const Compare& is_lit = {}) {
    constexpr T beyond(0x1p64);
    const bool some = !is_nan(bias) && bias < beyond && bias > -beyond;
    return is_lit.towards_light(receiver, some ? bias : T(0));
}

namespace glsl {

inline constexpr snippet clamp_bias{
    .name = "clamp_bias",
    .summary = "clamp of a bias to [0, 1], NaN to 1",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_clamp_bias: a bias in depth clamped to [0, 1], 0.0 below 2^-64; NaN becomes 1.0, and nothing is in shadow
UMBRAGE_HIGHP float umbrage_clamp_bias(UMBRAGE_HIGHP float bias) {
    UMBRAGE_HIGHP float least = (1.0 / 18446744073709551616.0);
    return bias >= least && bias < 1.0 ? bias : (bias < least ? 0.0 : 1.0);
}
)GLSL",
};

inline constexpr snippet biased{
    .name = "biased",
    .summary = "receiver moved towards the light",
    .exactness = tier::b,
    .needs = list<&cleared_depth>,
    .source = R"GLSL(
// umbrage_biased: receiver moved towards the light by bias, in depth; 2^64 and more, and NaN, is none
UMBRAGE_HIGHP float umbrage_biased(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float bias) {
    UMBRAGE_HIGHP float by = abs(bias) < 18446744073709551616.0 ? bias : 0.0;
    return umbrage_cleared_depth() > 0.5 ? receiver - by : receiver + by;
}
)GLSL",
};

inline constexpr auto constant_snippets = list<&clamp_bias, &biased>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/unorm.hpp
// Between integer channels 0..255 and what an 8-bit render target takes and gives.
//
//     vec4 colour = umbrage_to_unorm(channels);    // writing: the same byte whether the store rounds or truncates
//     vec4 channels = umbrage_from_unorm(texel);   // reading: whole numbers, however the driver divides by 255
//

namespace umbrage {

/// The value to write so that an 8-bit UNORM target stores channel k, rounding or truncating.
///
/// @param k     whole number 0..255
/// @return      about (k + 1/4) / 255, at most 1.00098, which the store clamps
/// @formula     (257 k + 64) / 65536
/// @exactness   A: 17 significant bits
template <real T>
[[nodiscard]] constexpr T to_unorm(T k) {
    return k * T(257.0 / 65536.0) + T(64.0 / 65536.0);
}
template <glm::length_t L, real T>
[[nodiscard]] constexpr glm::vec<L, T> to_unorm(glm::vec<L, T> k) {
    for (glm::length_t i = 0; i < L; ++i) k[i] = to_unorm(k[i]);
    return k;
}

/// The channel behind a value read from an 8-bit UNORM texture.
///
/// @param c     k / 255, up to thousands of ulp off; values no texture gives are not clamped
/// @return      k, a whole number 0..255
/// @formula     floor(255 c + 1/2)
/// @exactness   A for values farther than 2^-15 from the midpoint of two channels
template <real T>
[[nodiscard]] T from_unorm(T c) {
    return std::floor(c * T(255) + T(0.5));
}
template <glm::length_t L, real T>
[[nodiscard]] glm::vec<L, T> from_unorm(glm::vec<L, T> c) {
    for (glm::length_t i = 0; i < L; ++i) c[i] = from_unorm(c[i]);
    return c;
}

/// What an 8-bit UNORM render target stores of a written value: C++ only, the target is the twin.
enum class unorm_store { rounds, truncates };

/// @param c     any value; clamped to [0, 1], NaN stores 0 as graphics interfaces ask
template <real T>
[[nodiscard]] constexpr std::uint8_t store_unorm8(T c, unorm_store mode = unorm_store::rounds) {
    if (is_nan(c)) return 0;
    const T scaled = saturate(c) * T(255);
    return static_cast<std::uint8_t>(mode == unorm_store::rounds ? scaled + T(0.5) : scaled);
}
template <glm::length_t L, real T>
[[nodiscard]] constexpr glm::vec<L, std::uint8_t> store_unorm8(glm::vec<L, T> c,
                                                               unorm_store mode = unorm_store::rounds) {
    glm::vec<L, std::uint8_t> bytes(0);
    for (glm::length_t i = 0; i < L; ++i) bytes[i] = store_unorm8(c[i], mode);
    return bytes;
}

/// What sampling gives back of stored bytes.
template <real T = float, glm::length_t L>
[[nodiscard]] constexpr glm::vec<L, T> load_unorm8(glm::vec<L, std::uint8_t> bytes) {
    glm::vec<L, T> c(0);
    for (glm::length_t i = 0; i < L; ++i) c[i] = T(bytes[i]) / T(255);
    return c;
}

namespace glsl {

inline constexpr snippet to_unorm{
    .name = "to_unorm",
    .summary = "channel 0..255 to the value an 8-bit target stores as it",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_to_unorm: what to write so that an 8-bit target stores channel k, whether it rounds or truncates
// k * 257 / 65536 + 64 / 65536; not written so, since 65536.0 is infinite in mediump
UMBRAGE_HIGHP float umbrage_to_unorm(UMBRAGE_HIGHP float k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
UMBRAGE_HIGHP vec2 umbrage_to_unorm(UMBRAGE_HIGHP vec2 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
UMBRAGE_HIGHP vec3 umbrage_to_unorm(UMBRAGE_HIGHP vec3 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
UMBRAGE_HIGHP vec4 umbrage_to_unorm(UMBRAGE_HIGHP vec4 k) {
    return k * 0.0039215087890625 + 0.0009765625;
}
)GLSL",
};

inline constexpr snippet from_unorm{
    .name = "from_unorm",
    .summary = "value read from an 8-bit texture to channel 0..255",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_from_unorm: channel 0..255 behind a value read from an 8-bit texture, however the driver divides by 255
UMBRAGE_HIGHP float umbrage_from_unorm(UMBRAGE_HIGHP float c) {
    return floor(c * 255.0 + 0.5);
}
UMBRAGE_HIGHP vec2 umbrage_from_unorm(UMBRAGE_HIGHP vec2 c) {
    return floor(c * 255.0 + 0.5);
}
UMBRAGE_HIGHP vec3 umbrage_from_unorm(UMBRAGE_HIGHP vec3 c) {
    return floor(c * 255.0 + 0.5);
}
UMBRAGE_HIGHP vec4 umbrage_from_unorm(UMBRAGE_HIGHP vec4 c) {
    return floor(c * 255.0 + 0.5);
}
)GLSL",
};

inline constexpr auto unorm_snippets = list<&to_unorm, &from_unorm>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/depth/encoding.hpp
// What an encoding is: a value that turns depths into texels and back, and knows what there is to know of itself.
//
//     umbrage::rg<11> encoding{.direction = light.clip.direction};
//     umbrage::image<glm::u8vec2> map(size, encoding.cleared());
//
// The library's own are listed in encodings.hpp. Functions over images take any type with texel, encode and decode.

namespace umbrage {

/// What the writer's snippet returns.
enum class written {
    depth,   ///< a float to write into a float target
    bytes,   ///< whole channels 0..255: umbrage_to_unorm makes them the values to write
    values,  ///< values to write into a UNORM target as they are; what the store makes of them is part of the format
};

/// How far a decoded depth may lie from the encoded one, for every depth in [0, 1).
struct decoding_error {
    double below = 0.0;  ///< what a receiver's bias has to cover where depth runs forward
    double above = 0.0;  ///< the same where it is reversed
};

/// Depths to texels and back: all that functions over images ask for.
template <class Encoding>
concept encoding = std::copyable<Encoding> && requires(const Encoding& e, float depth) {
    typename Encoding::texel;
    { e.encode(depth) } -> std::same_as<typename Encoding::texel>;
    { e.decode(typename Encoding::texel{}) } -> std::same_as<float>;
};

/// What an encoding of the library tells of itself, for tools, tables and shaders.
template <class Encoding>
concept known_encoding = encoding<Encoding> && requires(const Encoding& e) {
    { Encoding::name } -> std::convertible_to<std::string_view>;     // a C++ identifier, without the template
    { Encoding::summary } -> std::convertible_to<std::string_view>;  // one sentence
    { Encoding::writer } -> std::convertible_to<const glsl::snippet*>;
    { Encoding::reader } -> std::convertible_to<const glsl::snippet*>;  // null: the texel is the depth (written::depth)
    { Encoding::writes } -> std::convertible_to<written>;
    { Encoding::codes } -> std::convertible_to<std::uint64_t>;            // texels that the writer can give
    { e.direction } -> std::convertible_to<depth_direction>;              // far is 1 forward, 0 reversed
    { e.error(unorm_store::truncates) } -> std::same_as<decoding_error>;  // by default the store rounds
    { e.cleared() } -> std::same_as<typename Encoding::texel>;            // an empty map's: decodes to the far plane
};

/// Whether the reader asks which place of a code's interval it shall answer: lower_edge, centre or upper_edge.
template <class Encoding>
concept has_edge = requires(Encoding e) {
    { e.edge } -> std::convertible_to<float>;
};

namespace detail {

/// Says in words what a type lacks that is used as an encoding.
template <class Encoding>
consteval bool is_encoding() {
    static_assert(
        requires { typename Encoding::texel; }, "an umbrage encoding needs a type `texel`");
    static_assert(
        requires(const Encoding& e, float d) { e.encode(d); }, "an umbrage encoding needs `texel encode(float) const`");
    static_assert(encoding<Encoding>,
                  "an umbrage encoding needs `float decode(texel) const`, and `encode` to return a texel");
    return true;
}

/// The edge on whose side no surface shadows itself through quantisation alone.
[[nodiscard]] constexpr float safe_edge(depth_direction direction) {
    return direction == depth_direction::forward ? 1.0f : 0.0f;
}

}  // namespace detail
}  // namespace umbrage

// ---- umbrage/filter/filter.hpp
// What a filter is: a value that makes visibility of a map's texels, and knows what there is to know of itself.
//
//     umbrage::filters::box filter{.radius = 2, .is_lit = {light.clip.direction}};
//     float visibility = filter(umbrage::clamped(map), coord, depth - bias);
//
// The library's own are listed in filters.hpp. Functions over images take any callable like them.

namespace umbrage {
namespace detail {

/// A map as filters see it.
struct any_fetch {
    float operator()(glm::ivec2 texel) const;
};

}  // namespace detail

/// A callable (fetch, coord, receiver) -> visibility: all that functions over images ask for.
template <class Filter>
concept filter = std::copy_constructible<Filter> &&
    requires(const Filter& f, const detail::any_fetch& fetch, float receiver) {
    { f(fetch, glm::vec2(), receiver) } -> std::convertible_to<float>;
};

/// What a filter of the library tells of itself, for tools, tables and biases.
template <class Filter>
concept known_filter = filter<Filter> && requires(const Filter& f, float depth) {
    { f.name } -> std::convertible_to<std::string_view>;         // a C++ identifier
    { f.snippet } -> std::convertible_to<const glsl::snippet*>;  // of the same result
    { f.reach() } -> std::same_as<float>;  // from a receiver to the farthest point of its texels, an axis, in texels
    { f.is_lit(depth, depth) } -> std::same_as<bool>;  // the comparison, its direction inside
};

namespace detail {

/// Says in words what a type lacks that is used as a filter.
template <class Filter>
consteval bool is_filter() {
    static_assert(filter<Filter>,
                  "an umbrage filter is a callable (fetch, glm::vec2 coord, float receiver) -> float, const");
    return true;
}

}  // namespace detail
}  // namespace umbrage

// ---- umbrage/bias/acne_free.hpp
// The smallest bias with which no plane shadows itself, from the plane's slope in the map, how far the filter reads and
// how the map is stored.
//
//     umbrage::filters::box filter{.radius = 2};
//     glm::vec2 slope = umbrage::plane_slope(plane_matrix, normal, world);  // of depth, a texel
//     float bias = umbrage::acne_free_bias(slope, filter, umbrage::rg<11>{});
//     float visibility = filter(fetch, glm::vec2(p), umbrage::biased(p.z, bias, filter.is_lit));
//
// A filter compares a receiver with depths of its plane at centres of texels that lie up to its reach away, in x and in
// y: there the plane may be nearer by reach (|a| + |b|), and what is stored of it nearer still by the encoding's error.
// That much is needed, and no more: with 9/10 of it some receiver is dark.

namespace umbrage {

/// Texels that a reach grows by where the depth pass moves vertices by up to 1/512 texel, as rasterizers do.
template <real T>
inline constexpr T snapping_reach = T(1) / T(128);

/// The smallest bias in depth without acne, for filters that read whole rows and columns.
///
/// @param slope   change of the receiver's depth from one texel to the next, in x and y: plane_slope, receiver_plane
/// @param reach   of the filter, texels; with coordinates that round, 2^-12 more for 4096 texels, and in proportion;
///                snapping_reach more where a rasterizer has moved vertices
/// @param error   how far a decoded depth may lie before the true one: decoding_error::below, where depth is reversed
///                above; of a UNORM depth texture 1/2 / (2^bits - 1)
/// @return        0 .. 1; 1, with which nothing is in shadow, for slopes and reaches that are infinite, and for NaN
/// @formula       reach (|slope.x| + |slope.y|) + error + 2^-23, the last for rounding in binary32 of depth once it is
///                there; what a matrix in floats lost of it before, some 2^-22 of a z/w near 1, is to be added to error
/// @detaches      casters nearer to the receiver than detachment() lose their shadow
/// @exactness     B
template <real T>
[[nodiscard]] constexpr T acne_free_bias(glm::vec<2, T> slope, T reach, T error) {
    const T sum = (slope.x < T(0) ? -slope.x : slope.x) + (slope.y < T(0) ? -slope.y : slope.y);
    return clamp_bias(reach * sum + (error + T(0x1p-23)));
}

/// The smallest bias in depth without acne, for filters that read a disc.
///
/// @param slope, error   as for acne_free_bias
/// @param radius         from the receiver to the farthest point, texels; the texel that a point falls into lies up to
///                       half a texel, and 1/128 for the points' rounding, farther
/// @return               0 .. 1; 1 for what is infinite, and for NaN
/// @formula              radius |slope| + (1/2 + 1/128) (|slope.x| + |slope.y|) + error + 2^-23
/// @exactness            C: a square root, of which GLSL allows a few ulp; 0 seen
template <real T>
[[nodiscard]] T acne_free_disc_bias(glm::vec<2, T> slope, T radius, T error) {
    const T sum = std::abs(slope.x) + std::abs(slope.y);
    const T length = std::sqrt(slope.x * slope.x + slope.y * slope.y);
    return clamp_bias(radius * length + (sum * T(0.5078125) + (error + T(0x1p-23))));
}

/// The smallest bias for a filter over a map of an encoding, whose direction of depth says which of its errors counts.
/// @param more   what the reach is to grow by, texels: snapping_reach, rounding of coordinates
[[nodiscard]] constexpr float acne_free_bias(glm::vec2 slope, const known_filter auto& filter,
                                             const known_encoding auto& encoding, float more = 0.0f) {
    const decoding_error both = encoding.error();
    const auto error = float(encoding.direction == depth_direction::forward ? both.below : both.above);
    if constexpr (requires { filter.farthest_point(); })
        return acne_free_disc_bias(slope, filter.farthest_point() + more, error);
    else return acne_free_bias(slope, filter.reach() + more, error);
}

/// Depth before a receiver within which a caster's shadow is lost, wholly or in part.
///
/// @param bias           of the receiver, in depth
/// @param caster_slope   of the caster's depth, a texel; |slope.x| + |slope.y| of a caster that faces the light is 0
/// @param reach          of the filter, texels
/// @return               0 .. 1: casters at least so far before the receiver shadow it as without bias; 1 for what is
///                       infinite, and for NaN
/// @formula              bias + reach (|caster_slope.x| + |caster_slope.y|) + 2^-23. On a floor beside a wall that
///                       stands square to it light leaks in for bias sin(t), t between the floor's normal and the
///                       light: in world units at most sqrt(2) reach texel tan(t) sin(t)
/// @exactness            B
template <real T>
[[nodiscard]] constexpr T detachment(T bias, glm::vec<2, T> caster_slope, T reach) {
    return acne_free_bias(caster_slope, reach, bias);
}

namespace glsl {

inline constexpr snippet acne_free_bias{
    .name = "acne_free_bias",
    .summary = "smallest bias without acne, for a slope, a reach and an encoding's error",
    .exactness = tier::b,
    .needs = list<&clamp_bias>,
    .source = R"GLSL(
// umbrage_acne_free_bias: the smallest bias in depth with which no plane shadows itself, 0.0 to 1.0
//   slope  change of depth from one texel to the next;   reach  of the filter, texels
//   error  how far a decoded depth may lie before the true one
UMBRAGE_HIGHP float umbrage_acne_free_bias(UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP float reach,
                                           UMBRAGE_HIGHP float error) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float bias =
        reach * (abs(slope.x) + abs(slope.y)) + (error + (1.0 / 8388608.0));
    return umbrage_clamp_bias(bias);
}
)GLSL",
};

inline constexpr snippet acne_free_disc_bias{
    .name = "acne_free_disc_bias",
    .summary = "smallest bias without acne, for filters that read a disc",
    .exactness = tier::c,
    .ulp = 1,
    .needs = list<&clamp_bias>,
    .source = R"GLSL(
// umbrage_acne_free_disc_bias: the smallest bias in depth with which no plane shadows itself, 0.0 to 1.0
//   slope   change of depth from one texel to the next;   radius  to the disc's farthest point, texels
//   error   how far a decoded depth may lie before the true one
UMBRAGE_HIGHP float umbrage_acne_free_disc_bias(UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP float radius,
                                                UMBRAGE_HIGHP float error) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = slope.x * slope.x + slope.y * slope.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float beside =
        (abs(slope.x) + abs(slope.y)) * 0.5078125 + (error + (1.0 / 8388608.0));
    UMBRAGE_PRECISE UMBRAGE_HIGHP float bias = radius * sqrt(square) + beside;
    return umbrage_clamp_bias(bias);
}
)GLSL",
};

inline constexpr snippet detachment{
    .name = "detachment",
    .summary = "depth before a receiver within which its bias loses a caster's shadow",
    .exactness = tier::b,
    .needs = list<&acne_free_bias>,
    .source = R"GLSL(
// umbrage_detachment: depth before a receiver within which a caster's shadow is lost, wholly or in part, 0.0 to 1.0
//   bias   of the receiver, in depth;   caster_slope  change of the caster's depth from one texel to the next
//   reach  of the filter, texels
UMBRAGE_HIGHP float umbrage_detachment(UMBRAGE_HIGHP float bias, UMBRAGE_HIGHP vec2 caster_slope,
                                       UMBRAGE_HIGHP float reach) {
    return umbrage_acne_free_bias(caster_slope, reach, bias);
}
)GLSL",
};

inline constexpr auto acne_free_snippets = list<&acne_free_bias, &acne_free_disc_bias, &detachment>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/bias/kernel.hpp
// A bias that grows with the filter's kernel and the angle at which light falls, from a surface's normal.
//
//     float width = umbrage::offset_width(filter.reach(), umbrage::texels_to_world(1.0f, units, w));
//     float world = umbrage::kernel_bias(normal, light_direction, way, width, 20.0f);  // way as for normal_offset
//     float bias = umbrage::world_to_depth(world, units, w);
//

namespace umbrage {

/// How far along the light a filter's kernel reaches before a surface's plane.
///
/// @param normal      of the surface, of any length, on the side that is seen
/// @param direction   of the light, a spot's axis, of length one
/// @param way         from the light to the point over w; for a directional light its direction once more
/// @param width       of the kernel, offset_width, in world units; or in depth: the result is in the same
/// @param greatest    tangent from which on the bias grows no more, >= 0
/// @return            2^-64 to 2^64; width greatest where light grazes or comes from behind, for a normal of zero and
///                    NaN; 0 for what is not
/// @formula           width min(|normal x direction| / -(normal . way), greatest), a tangent: up to the greatest one,
///                    acne_free_bias without its constant part, times 1 to sqrt(2), whichever way the plane is turned
/// @detaches          casters nearer than the bias along the light lose their shadow: at most width greatest
/// @exactness         C: a square root and a division, of each of which GLSL allows a few ulp; 0 seen
template <real T>
[[nodiscard]] T kernel_bias(glm::vec<3, T> normal, glm::vec<3, T> direction, glm::vec<3, T> way, T width, T greatest) {
    const T x = normal.y * direction.z + normal.z * -direction.y;
    const T y = normal.z * direction.x + normal.x * -direction.z;
    const T z = normal.x * direction.y + normal.y * -direction.x;
    const T sine = std::sqrt(x * x + y * y + z * z);
    const T cosine = -(normal.x * way.x + normal.y * way.y + normal.z * way.z);
    const bool grazing = is_nan(cosine) || is_nan(sine) || !(cosine * greatest > sine);
    const T bias = width * (grazing ? greatest : sine / cosine);
    return !is_nan(bias) && bias >= T(0x1p-64) && bias < T(0x1p64) ? bias : T(0);
}

namespace glsl {

inline constexpr snippet kernel_bias{
    .name = "kernel_bias",
    .summary = "bias by the kernel's width and the angle at which light falls",
    .exactness = tier::c,
    .ulp = 1,
    .source = R"GLSL(
// umbrage_kernel_bias: how far along the light a kernel reaches before a surface's plane, in the units of width
//   normal  of the surface;   direction  of the light, of length one;   way  from the light to the point over w; of a
//   directional light its direction;   width  sqrt(2) reach texel;   greatest  tangent, where growth ends
UMBRAGE_HIGHP float umbrage_kernel_bias(UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec3 direction, UMBRAGE_HIGHP vec3 way,
                                        UMBRAGE_HIGHP float width, UMBRAGE_HIGHP float greatest) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = normal.y * direction.z + normal.z * -direction.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = normal.z * direction.x + normal.x * -direction.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = normal.x * direction.y + normal.y * -direction.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = x * x + y * y + z * z;
    UMBRAGE_HIGHP float sine = sqrt(square);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float cosine = -(normal.x * way.x + normal.y * way.y + normal.z * way.z);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float edge = cosine * greatest;
    UMBRAGE_HIGHP float tangent = edge > sine ? sine / cosine : greatest;
    UMBRAGE_HIGHP float bias = width * tangent;
    return bias >= (1.0 / 18446744073709551616.0) && bias < 18446744073709551616.0 ? bias : 0.0;
}
)GLSL",
};

inline constexpr auto kernel_snippets = list<&kernel_bias>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/light/light_space.hpp
// A light's view of the world: two matrices and the convention they follow. Every set-up function either returns
// matrices of finite numbers, whose product is finite too, or reports which argument is to blame.
//
//     auto light = umbrage::make_spot_light({.position = {0, 5, 0}, .direction = {0, -1, 0}});
//     glm::mat4 clip_from_world = light.projection * light.view;
//

namespace umbrage {

template <real T>
struct light_space {
    glm::mat<4, 4, T> view{T(1)};        ///< world -> light's view space, a rotation; down -z (right) or +z (left)
    glm::mat<4, 4, T> projection{T(1)};  ///< view space -> clip space
    clip_space clip;
};

namespace detail {

/// Reports an argument of a set-up function, or several, unless what they need is met.
inline void require(bool met, const char* function, const char* arguments, const char* problem) {
    if (met) return;
    std::string message = "umbrage::";  // appended to: of sums GCC 12 believes at times that they overrun
    for (const char* part : {function, ": ", arguments, " ", problem}) message += part;
    fail(message);
}

/// True for what neither overflowed nor is lost where denormals count as zero.
template <real T>
[[nodiscard]] bool is_normal(T v) {
    return is_finite(v) && glm::abs(v) >= std::numeric_limits<T>::min();
}

/// The one check of a light's matrices.
template <real T>
[[nodiscard]] light_space<T> checked(const light_space<T>& light, const char* function, const char* arguments) {
    const bool finite = all_finite(light.view) && all_finite(light.projection);
    require(finite && all_finite(light.projection * light.view), function, arguments,
            "give a matrix that is not finite");
    return light;
}

/// Unit vector; scaled first, so that nothing overflows or underflows. Zero stays zero.
template <real T>
[[nodiscard]] glm::vec<3, T> unit(glm::vec<3, T> v) {
    const T scale = glm::max(glm::max(glm::abs(v.x), glm::abs(v.y)), glm::abs(v.z));
    return scale > T(0) ? glm::normalize(v / scale) : v;
}

/// Two vectors of length one that stand square to one of length one, and to each other.
template <real T>
[[nodiscard]] std::array<glm::vec<3, T>, 2> across(glm::vec<3, T> v) {
    const glm::vec<3, T> size = glm::abs(v);
    const glm::length_t least = size.x <= size.y && size.x <= size.z ? 0 : (size.z <= size.y ? 2 : 1);
    glm::vec<3, T> axis(0);
    axis[least] = T(1);
    const glm::vec<3, T> side = glm::normalize(glm::cross(v, axis));
    return {side, glm::cross(v, side)};
}

/// look_along in the name of another function, whose argument `position` is; the result is the caller's to check.
template <real T>
[[nodiscard]] glm::mat<4, 4, T> look_along(glm::vec<3, T> position, glm::vec<3, T> direction, glm::vec<3, T> up,
                                           handedness hand, const char* function, const char* position_name) {
    require(all_finite(position), function, position_name, "must be finite");
    require(all_finite(direction), function, "direction", "must be finite");
    require(all_finite(up), function, "up", "must be finite");
    const glm::vec<3, T> forward = unit(direction);
    require(forward != glm::vec<3, T>(0), function, "direction", "must not be zero");

    glm::vec<3, T> side = glm::cross(forward, unit(up));
    if (!(glm::length(side) > T(1e-3))) side = across(forward)[0];
    const glm::vec<3, T> above = glm::normalize(glm::cross(side, forward));
    side = glm::cross(forward, above);  // again: up nearly parallel to forward leaves the first a hundred ulp askew
    const T towards = hand == handedness::right ? T(1) : T(-1);  // left: half a turn about y

    glm::mat<4, 4, T> view(T(1));
    for (glm::length_t i = 0; i < 3; ++i) {
        view[i][0] = towards * side[i];
        view[i][1] = above[i];
        view[i][2] = -towards * forward[i];
    }
    view[3][0] = -towards * glm::dot(side, position);
    view[3][1] = -glm::dot(above, position);
    view[3][2] = towards * glm::dot(forward, position);
    return view;
}

}  // namespace detail

/// World to light's view space by a rotation: x to the right, y up.
///
/// @param position    of the light, world
/// @param direction   it looks along, any length > 0
/// @param up          hint; where it is parallel to direction, or nearly (1e-3), the world axis least along direction
///                    takes its place, so that any direction works
/// @param hand        of the world and the view; right: looks down -z, as glm::lookAtRH, left: down +z, as
/// glm::lookAtLH
/// @throws std::invalid_argument  zero or non-finite direction or position
template <real T>
[[nodiscard]] glm::mat<4, 4, T> look_along(glm::vec<3, T> position, glm::vec<3, T> direction, glm::vec<3, T> up,
                                           handedness hand) {
    const auto view = detail::look_along(position, direction, up, hand, "look_along", "position");
    detail::require(detail::all_finite(view), "look_along", "position", "is too far out");
    return view;
}

namespace detail {

/// Rows that send view-space distance z_near to the near depth and z_far to the far depth of the convention.
template <real T>
struct depth_ends {
    T at_near, at_far;
};
template <real T>
[[nodiscard]] constexpr depth_ends<T> ends(clip_space clip) {
    const T low = clip.range == depth_range::zero_to_one ? T(0) : T(-1);
    return clip.direction == depth_direction::forward ? depth_ends<T>{low, T(1)} : depth_ends<T>{T(1), low};
}

/// perspective in the name of another function, which has checked the tangents.
template <real T>
[[nodiscard]] glm::mat<4, 4, T> perspective(T tan_half_x, T tan_half_y, T z_near, T z_far, clip_space clip,
                                            const char* function) {
    require(is_normal(z_near) && z_near > T(0), function, "z_near", "must be above 0, finite and no denormal");
    require(!is_nan(z_far) && z_near < z_far, function, "z_far", "must be above z_near");
    const auto [at_near, at_far] = ends<T>(clip);
    const T forward = clip.hand == handedness::right ? T(-1) : T(1);
    // the formula over powers of two, which keeps its bits and does not overflow; no far plane: z_near is nothing to it
    const bool bounded = is_finite(z_far);
    const int far_scale = bounded ? std::ilogb(z_far) : 0, near_scale = std::ilogb(z_near);
    const T f = bounded ? std::scalbn(z_far, -far_scale) : T(1), n = bounded ? std::scalbn(z_near, -far_scale) : T(0);
    const T product = std::scalbn(z_near, -near_scale) * f * (at_near - at_far);
    glm::mat<4, 4, T> m(T(0));
    m[0][0] = T(1) / tan_half_x;
    m[1][1] = T(1) / tan_half_y;
    m[2][2] = forward * (f * at_far - n * at_near) / (f - n);
    m[3][2] = std::scalbn(product / (f - n), near_scale);
    m[2][3] = forward;
    require(is_finite(m[3][2]), function, "z_near and z_far", "are too large and too close together");
    return m;
}

/// orthographic in the name of another function, whose arguments give the box and the planes.
template <real T>
[[nodiscard]] glm::mat<4, 4, T> orthographic(glm::vec<2, T> low, glm::vec<2, T> high, T z_near, T z_far,
                                             clip_space clip, const char* function, const char* box,
                                             const char* planes) {
    require(all_finite(low) && all_finite(high), function, box, "must give a finite box");
    require(low.x < high.x && low.y < high.y, function, box, "must give a box with some width and height");
    require(is_finite(z_near) && is_finite(z_far), function, planes, "must be finite");
    require(z_near < z_far, function, planes, "must be in order, some distance apart");
    const auto [at_near, at_far] = ends<T>(clip);
    const T forward = clip.hand == handedness::right ? T(-1) : T(1);
    glm::mat<4, 4, T> m(T(1));
    for (glm::length_t i = 0; i < 2; ++i) {
        m[i][i] = T(2) / (high[i] - low[i]);
        m[3][i] = -(high[i] + low[i]) / (high[i] - low[i]);
        require(is_normal(m[i][i]) && is_finite(m[3][i]), function, box, "give too large or too small a box");
    }
    m[2][2] = forward * (at_far - at_near) / (z_far - z_near);
    m[3][2] = (z_far * at_near - z_near * at_far) / (z_far - z_near);
    require(is_normal(m[2][2]) && is_finite(m[3][2]), function, planes, "are too far apart or too close together");
    return m;
}

}  // namespace detail

/// Perspective projection.
///
/// @param tan_half_x, tan_half_y   tangent of half the opening angle, > 0
/// @param z_near, z_far            0 < z_near < z_far, world units; an infinite z_far is no far plane: depth then nears
///                                 the far depth with distance, forward or reversed
/// @throws std::invalid_argument   anything else, and what gives a matrix that is not finite
/// @formula       z/w = A + B / distance through (z_near, near depth), (z_far, far depth)
template <real T>
[[nodiscard]] glm::mat<4, 4, T> perspective(T tan_half_x, T tan_half_y, T z_near, T z_far, clip_space clip) {
    const auto opening = [](T tangent) { return tangent > T(0) && detail::is_normal(T(1) / tangent); };
    detail::require(opening(tan_half_x), "perspective", "tan_half_x", "must be above 0, and 1 / tan_half_x finite");
    detail::require(opening(tan_half_y), "perspective", "tan_half_y", "must be above 0, and 1 / tan_half_y finite");
    return detail::perspective(tan_half_x, tan_half_y, z_near, z_far, clip, "perspective");
}

/// Orthographic projection of the box between two corners of view space, z given as distances in front of the light.
///
/// @param low, high        x and y of the corners, low < high
/// @param z_near, z_far    z_near < z_far, world units, may be negative (behind the light's position)
/// @throws std::invalid_argument   an empty or non-finite box, and one that gives a matrix that is not finite
template <real T>
[[nodiscard]] glm::mat<4, 4, T> orthographic(glm::vec<2, T> low, glm::vec<2, T> high, T z_near, T z_far,
                                             clip_space clip) {
    return detail::orthographic(low, high, z_near, z_far, clip, "orthographic", "low and high", "z_near and z_far");
}

}  // namespace umbrage

// ---- umbrage/light/texture_matrix.hpp
// From world to the shadow map: the texture matrix, the four tap matrices, and what a vertex shader does with them.
//
//     glm::mat4 m = umbrage::texture_matrix(light, {1024, 1024});
//     glm::vec3 p = umbrage::project_coordinate(umbrage::shadow_coordinate(m, world));  // texels, texels, depth
//

namespace umbrage {

/// World to texels and depth, before the division by w.
///
/// @param map_size   texels, each >= 1; the first texel's centre is (0.5, 0.5)
/// @return           (x w, y w, depth w, w); depth in [0, 1] whatever the clip space, reversed stays reversed
/// @formula          scale and bias * projection * view; y is flipped for texture_origin::top, and z of
///                   [-1, 1] clip space becomes z / 2 + 1 / 2
/// @throws std::invalid_argument  map_size below 1, or a matrix that is not finite
template <real T>
[[nodiscard]] glm::mat<4, 4, T> texture_matrix(const light_space<T>& light, glm::ivec2 map_size) {
    detail::require(map_size.x >= 1 && map_size.y >= 1, "texture_matrix", "map_size", "must be above 0");
    const glm::vec<2, T> half = glm::vec<2, T>(map_size) * T(0.5);
    glm::mat<4, 4, T> scale_bias(T(1));
    scale_bias[0][0] = half.x;
    scale_bias[1][1] = light.clip.origin == texture_origin::bottom ? half.y : -half.y;
    scale_bias[3][0] = half.x;
    scale_bias[3][1] = half.y;
    if (light.clip.range == depth_range::minus_one_to_one) {
        scale_bias[2][2] = T(0.5);
        scale_bias[3][2] = T(0.5);
    }
    const glm::mat<4, 4, T> m = scale_bias * light.projection * light.view;
    detail::require(detail::all_finite(m), "texture_matrix", "light and map_size", "give a matrix that is not finite");
    return m;
}

namespace detail {

/// How a point's texels and depth change with a step along a vector.
template <real T>
[[nodiscard]] glm::vec<3, T> step(const glm::mat<4, 4, T>& texture_matrix, glm::vec<3, T> world, glm::vec<3, T> along) {
    const glm::vec<4, T> h = texture_matrix * glm::vec<4, T>(world, T(1));
    const glm::vec<4, T> d = texture_matrix * glm::vec<4, T>(along, T(0));
    return (glm::vec<3, T>(d) - glm::vec<3, T>(h) * (d.w / h.w)) / h.w;
}

}  // namespace detail

/// The same to [0, 1]: what texture look-ups with normalised coordinates take.
template <real T>
[[nodiscard]] glm::mat<4, 4, T> texture_matrix_uv(const light_space<T>& light) {
    return texture_matrix(light, {1, 1});
}

/// The taps of the 2002 sample: half a texel off in both directions.
template <real T>
inline const std::array<glm::vec<2, T>, 4> default_taps{
    {{T(-0.5), T(-0.5)}, {T(0.5), T(-0.5)}, {T(-0.5), T(0.5)}, {T(0.5), T(0.5)}}};

/// One texture matrix per tap, for hardware and shaders that cannot move a projective coordinate afterwards.
///
/// @param texture_matrix   world to texels
/// @param offsets          of the taps, in texels
/// @return                 matrices with the offset applied before the division by w: equal in exact arithmetic to
///                         adding it afterwards; in binary32 within 6 ulp of (|m0 x| + |m1 y| + |m2 z| + |m3|) / w,
///                         the magnitudes that add up to a coordinate (worst seen 4.5; tap_coordinate stays closer)
/// @formula                translate(offset) * texture_matrix
/// @throws std::invalid_argument  a matrix that is not finite
/// @cite                   ATI Radeon SDK, ShadowMap sample, 2002
template <real T>
[[nodiscard]] std::array<glm::mat<4, 4, T>, 4> tap_matrices(
    const glm::mat<4, 4, T>& texture_matrix, const std::array<glm::vec<2, T>, 4>& offsets = default_taps<T>) {
    std::array<glm::mat<4, 4, T>, 4> taps;
    for (std::size_t tap = 0; tap < 4; ++tap) {
        taps[tap] = texture_matrix;
        for (int column = 0; column < 4; ++column) {
            taps[tap][column][0] += offsets[tap].x * texture_matrix[column][3];
            taps[tap][column][1] += offsets[tap].y * texture_matrix[column][3];
        }
        detail::require(detail::all_finite(taps[tap]), "tap_matrices", "texture_matrix and offsets",
                        "give a matrix that is not finite");
    }
    return taps;
}

/// A world position through a texture matrix; the vertex shader's part.
/// @formula       m[3] + m[0] x + m[1] y + m[2] z, sums from left to right: an order that GLSL compilers without
///                `precise` were seen to keep, where they move m[3] forward from the end
/// @exactness     B
template <real T>
[[nodiscard]] constexpr glm::vec<4, T> shadow_coordinate(const glm::mat<4, 4, T>& m, glm::vec<3, T> world) {
    glm::vec<4, T> c(0);
    for (glm::length_t row = 0; row < 4; ++row)
        c[row] = m[3][row] + m[0][row] * world.x + m[1][row] * world.y + m[2][row] * world.z;
    return c;
}

/// A tap's coordinate from the middle's: what the tap's own matrix would have given.
/// @param coordinate   as shadow_coordinate returns it, before the division by w;   offset  in texels
/// @return             after the division within 3 ulp of the offset added afterwards (worst seen 1.9)
/// @formula            (x + offset.x w, y + offset.y w, z, w)
/// @exactness          B
template <real T>
[[nodiscard]] constexpr glm::vec<4, T> tap_coordinate(glm::vec<4, T> coordinate, glm::vec<2, T> offset) {
    return {coordinate.x + offset.x * coordinate.w, coordinate.y + offset.y * coordinate.w, coordinate.z, coordinate.w};
}

/// The division: what filters take.
/// @return        (x, y) in texels, z depth; for w <= 0 (not in front of the light) or NaN in w (65536, 65536, 0),
///                which every filter takes as lit
/// @exactness     C: divisions, of each of which GLSL allows 2.5 ulp; 0 seen
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> project_coordinate(glm::vec<4, T> coordinate) {
    if (is_nan(coordinate.w) || !(coordinate.w > T(0))) return {T(65536), T(65536), T(0)};
    return {coordinate.x / coordinate.w, coordinate.y / coordinate.w, coordinate.z / coordinate.w};
}

namespace glsl {

inline constexpr snippet shadow_coordinate{
    .name = "shadow_coordinate",
    .summary = "world to texels and depth, before the division",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_shadow_coordinate: texture matrix times world position; (x w, y w, depth w, w), x and y in texels
UMBRAGE_HIGHP vec4 umbrage_shadow_coordinate(UMBRAGE_HIGHP mat4 m, UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 c = m[3] + m[0] * world.x + m[1] * world.y + m[2] * world.z;
    return c;
}
)GLSL",
};

inline constexpr snippet tap_coordinate{
    .name = "tap_coordinate",
    .summary = "a tap's coordinate from the middle's, before the division",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_tap_coordinate: coordinate, before the division by w, moved by offset texels
UMBRAGE_HIGHP vec4 umbrage_tap_coordinate(UMBRAGE_HIGHP vec4 coordinate, UMBRAGE_HIGHP vec2 offset) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 moved = vec2(coordinate.x, coordinate.y) + offset * coordinate.w;
    return vec4(moved.x, moved.y, coordinate.z, coordinate.w);
}
)GLSL",
};

inline constexpr snippet project_coordinate{
    .name = "project_coordinate",
    .summary = "the division by w, lit behind the light",
    .exactness = tier::c,
    .ulp = 1,
    .source = R"GLSL(
// umbrage_project_coordinate: (x, y) in texels and depth; for w <= 0.0 a coordinate that every filter takes as lit
UMBRAGE_HIGHP vec3 umbrage_project_coordinate(UMBRAGE_HIGHP vec4 coordinate) {
    UMBRAGE_HIGHP vec3 p = vec3(coordinate.x / coordinate.w, coordinate.y / coordinate.w, coordinate.z / coordinate.w);
    return coordinate.w > 0.0 ? p : vec3(65536.0, 65536.0, 0.0);
}
)GLSL",
};

inline constexpr auto texture_matrix_snippets = list<&shadow_coordinate, &tap_coordinate, &project_coordinate>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/bias/light_units.hpp
// Texels, world units and depth, each in the others, at a point that a light sees: directional or spot, by one formula.
//
//     glm::vec2 units = umbrage::make_light_units(light, map.size());
//     float w = umbrage::shadow_coordinate(to_texels, world).w;  // 1 for a directional light
//     float bias = umbrage::world_to_depth(0.02f, units, w);     // two centimetres
//
// Across the light a texel's footprint grows with w, the distance along a spot's axis; depth grows by less and less a
// world unit, as 1 / w^2. A directional light has w = 1 everywhere.
//
// In a warped map both change from point to point, and depth from texel to texel at one distance too: it drifts. A bias
// in world units there moves the point that is looked up, the same way everywhere and in every dialect:
//
//     auto here = umbrage::light_units_at(to_texels, light_direction, world);
//     float width = umbrage::offset_width(filter.reach(), here.units.x);
//     float bias_world = umbrage::kernel_bias(normal, light_direction, light_direction, width, 20.0f) +
//                        filter.reach() * here.drift_world;
//     glm::vec4 looked_up = umbrage::shadow_coordinate(to_texels, world - bias_world * light_direction);
//
// acne_free_bias by plane_slope, in shaders too, has no need of this.

namespace umbrage {

/// A light's measures at w = 1.
///
/// @param light      whose view is a rotation, not warped
/// @param map_size   texels, each >= 1
/// @return           x: edge of a texel's footprint across the light, world units, the longer where they differ;
///                   y: depth a world unit along the light, where it is z/w
/// @throws std::invalid_argument  map_size below 1, a warped map, or measures that are not finite and above 0
template <real T>
[[nodiscard]] glm::vec<2, T> make_light_units(const light_space<T>& light, glm::ivec2 map_size) {
    constexpr auto function = "make_light_units";
    detail::require(map_size.x >= 1 && map_size.y >= 1, function, "map_size", "must be above 0");
    const glm::mat<4, 4, T>& p = light.projection;
    detail::require(p[0][3] == T(0) && p[1][3] == T(0), function, "light", "must not be warped: see light_units_at");
    const T edge = glm::max(T(2) / (glm::abs(p[0][0]) * T(map_size.x)), T(2) / (glm::abs(p[1][1]) * T(map_size.y)));
    const bool perspective = p[2][3] != T(0);
    const T along = glm::abs(perspective ? p[3][2] : p[2][2]);
    const T depth = light.clip.range == depth_range::minus_one_to_one ? along * T(0.5) : along;
    detail::require(detail::is_normal(edge) && detail::is_normal(depth), function, "light",
                    "gives measures that are not finite and above 0");
    return {edge, depth};
}

template <real T>
struct light_measures {
    glm::vec<2, T> units{T(0)};  ///< as make_light_units, for a w of 1 whatever the point's own is; the edge is the
                                 ///< longest that a texel's footprint across the light is
    T drift_world = T(0);        ///< by how much depth changes at one distance along the light over a texel in x and
                                 ///< one in y, world units; 0 unless the map is warped
};

/// A light's measures at a point, of a warped map too.
///
/// @param texture_matrix   world to texels
/// @param direction        of the light, a spot's axis, any length > 0
/// @param world            the point, where the map's w is above 0
/// @formula                with J = d(texel) / d(world across the light): 1 / its least singular value; |d(depth) /
///                         d(world)| along the light; |J^-T d(depth) / d(world across the light)|_1 over that
template <real T>
[[nodiscard]] light_measures<T> light_units_at(const glm::mat<4, 4, T>& texture_matrix, glm::vec<3, T> direction,
                                               glm::vec<3, T> world) {
    const glm::vec<3, T> along = detail::unit(direction);
    const auto sides = detail::across(along);
    const glm::vec<3, T> a = detail::step(texture_matrix, world, sides[0]),
                         b = detail::step(texture_matrix, world, sides[1]);
    const T depth = glm::abs(detail::step(texture_matrix, world, along).z), area = glm::abs(a.x * b.y - a.y * b.x);
    const T longest = (std::hypot(a.x + b.y, a.y - b.x) + std::hypot(a.x - b.y, a.y + b.x)) / T(2);
    const T drift = (glm::abs(a.z * b.y - b.z * a.y) + glm::abs(b.z * a.x - a.z * b.x)) / area;
    return {{longest / area, depth}, drift / depth};
}

/// Texels across the light as world units.
///
/// @param units   make_light_units
/// @param w       of the point's shadow_coordinate
/// @return        2^-64 to 2^64; 0 for what is not, as for w <= 0, and for NaN
/// @formula       texels units.x w
/// @exactness     B: two products
template <real T>
[[nodiscard]] constexpr T texels_to_world(T texels, glm::vec<2, T> units, T w) {
    const T world = texels * units.x * w;
    return !is_nan(world) && world >= T(0x1p-64) && world < T(0x1p64) ? world : T(0);
}

/// World units along the light as depth, z/w.
///
/// @param units   make_light_units
/// @param w       of the point's shadow_coordinate, > 0
/// @return        0 .. 1; 1 for w = 0 and for NaN
/// @formula       world units.y / w^2: the slope of z/w at the point; what lies nearer to a spot changes by more, so
///                that a point moved towards it by `world` has w / (w - world) times that, which covers a bias
/// @exactness     C: one division, of which GLSL allows 2.5 ulp; 0 seen
template <real T>
[[nodiscard]] constexpr T world_to_depth(T world, glm::vec<2, T> units, T w) {
    return clamp_bias(world * units.y / (w * w));
}

namespace glsl {

inline constexpr snippet texels_to_world{
    .name = "texels_to_world",
    .summary = "texels across a light as world units",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_texels_to_world: texels across a light as world units; 0.0 for w <= 0.0
//   units  (edge of a texel, depth a world unit) at w = 1.0;   w  of the point's shadow coordinate
UMBRAGE_HIGHP float umbrage_texels_to_world(UMBRAGE_HIGHP float texels, UMBRAGE_HIGHP vec2 units,
                                            UMBRAGE_HIGHP float w) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float world = texels * units.x * w;
    return world >= (1.0 / 18446744073709551616.0) && world < 18446744073709551616.0 ? world : 0.0;
}
)GLSL",
};

inline constexpr snippet world_to_depth{
    .name = "world_to_depth",
    .summary = "world units along a light as depth",
    .exactness = tier::c,
    .ulp = 1,
    .needs = list<&clamp_bias>,
    .source = R"GLSL(
// umbrage_world_to_depth: world units along a light as depth, 0.0 to 1.0
//   units  (edge of a texel, depth a world unit) at w = 1.0;   w  of the point's shadow coordinate, above 0.0
UMBRAGE_HIGHP float umbrage_world_to_depth(UMBRAGE_HIGHP float world, UMBRAGE_HIGHP vec2 units,
                                           UMBRAGE_HIGHP float w) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float along = world * units.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = w * w;
    return umbrage_clamp_bias(along / square);
}
)GLSL",
};

inline constexpr auto light_units_snippets = list<&texels_to_world, &world_to_depth>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/bias/normal_offset.hpp
// The point to look up instead of a surface's own: off it along the normal, by what the surface's tilt asks for.
//
//     float width = umbrage::offset_width(filter.reach(), umbrage::texels_to_world(1.0f, units, w));
//     glm::vec3 way = spot ? (world - light_position) / w : light_direction;
//     glm::vec3 point = world + umbrage::normal_offset(normal, light_direction, way, width, 0.0f);
//
// In world space, so that the direction of depth does not matter; nothing where the light falls straight on a surface.

namespace umbrage {

/// How far along its normal a surface is looked up where light grazes it, so that no plane shadows itself.
/// @param reach   of the filter, texels, as for acne_free_bias;   texel_world  edge of a texel's footprint
/// @return        world units
/// @formula       sqrt(2) reach texel_world, the root rounded up: to the corner of what the filter reads
template <real T>
[[nodiscard]] constexpr T offset_width(T reach, T texel_world) {
    return T(1.4142137) * reach * texel_world;
}

/// The way from a surface to the point that is looked up in its place.
///
/// @param normal        of the surface, of length one, on the side that is seen; zero: no offset
/// @param direction     of the light, a spot's axis, of length one: what a map's texels lie across
/// @param way           from the light to the point over w, the distance along the axis; for a directional light its
///                      direction once more
/// @param width         world units, offset_width
/// @param error_world   world units along the light that the map's depths are off by, e of acne_free_bias
/// @return              world units; 0 where it is not finite, or 2^64 and more
/// @formula             normal (width |normal x direction| + error_world |normal . way|): with t the angle between
///                      normal and light, d along the normal wins d / cos t along the light, where a texel's step loses
///                      texel tan t. Enough for a directional light; for a spot where the normal looks against its axis
/// @detaches            as width tan t + error_world along the light: on a floor beside a wall that stands square to it
///                      light leaks in for up to width tan t sin t
/// @exactness           C: a square root, of which GLSL allows a few ulp; 0 seen
template <real T>
[[nodiscard]] glm::vec<3, T> normal_offset(glm::vec<3, T> normal, glm::vec<3, T> direction, glm::vec<3, T> way, T width,
                                           T error_world) {
    const T x = normal.y * direction.z + normal.z * -direction.y;
    const T y = normal.z * direction.x + normal.x * -direction.z;
    const T z = normal.x * direction.y + normal.y * -direction.x;
    const T straight = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    const T along = width * std::sqrt(x * x + y * y + z * z) + error_world * std::abs(straight);
    const glm::vec<3, T> offset = normal * along;
    const T extent = std::abs(offset.x) + std::abs(offset.y) + std::abs(offset.z);
    const bool finite = !is_nan(extent) & (extent < T(0x1p64));  // no branch: loops become vectors
    return {finite ? offset.x : T(0), finite ? offset.y : T(0), finite ? offset.z : T(0)};
}

namespace glsl {

inline constexpr snippet normal_offset{
    .name = "normal_offset",
    .summary = "way off a surface to the point that is looked up in its place",
    .exactness = tier::c,
    .ulp = 1,
    .source = R"GLSL(
// umbrage_normal_offset: what to add to a surface's point, world units, before it is looked up
//   normal, direction  of the surface and the light, of length one;   way  from the light to the point over w; of a
//   directional light its direction;   width  sqrt(2) reach texel;   error_world  of the map's depths; world units
UMBRAGE_HIGHP vec3 umbrage_normal_offset(UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec3 direction,
                                         UMBRAGE_HIGHP vec3 way, UMBRAGE_HIGHP float width,
                                         UMBRAGE_HIGHP float error_world) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = normal.y * direction.z + normal.z * -direction.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = normal.z * direction.x + normal.x * -direction.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = normal.x * direction.y + normal.y * -direction.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float straight = normal.x * way.x + normal.y * way.y + normal.z * way.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = x * x + y * y + z * z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float along = width * sqrt(square) + error_world * abs(straight);
    UMBRAGE_HIGHP vec3 offset = normal * along;
    return abs(offset.x) + abs(offset.y) + abs(offset.z) < 18446744073709551616.0 ? offset : vec3(0.0, 0.0, 0.0);
}
)GLSL",
};

inline constexpr auto normal_offset_snippets = list<&normal_offset>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/bias/rasterizer.hpp
// The bias that the depth pass adds to casters, as the numbers that each API's rasterizer takes: with them no plane
// shadows itself under a filter, and receivers need no bias of their own.
//
//     auto [factor, units, clamp] = umbrage::make_polygon_offset({.reach = filter.reach()});
//     glPolygonOffset(factor, units);
//
// Rasterizers multiply by the greater slope of depth, |a| or |b|, where a filter needs |a| + |b|; and by a step of the
// depth buffer, which in one of floats is that of the primitive's greatest depth.

namespace umbrage {

enum class depth_format { unorm16, unorm24, float32 };  ///< of the depth buffer

/// What a rasterizer's bias has to cover.
struct raster_bias {
    float reach = 0.5f;         ///< of the filter, texels, as for acne_free_bias
    float constant = 0x1p-23f;  ///< in depth: the encoding's error and 2^-23
    float greatest = 0.0f;      ///< no bias is greater, in depth: slopes beyond may shadow themselves; 0: no limit
    float least_depth = 0.5f;   ///< of a buffer of floats, above 0: primitives all below it get less than `constant`
    depth_format format = depth_format::unorm24;
    depth_direction direction = depth_direction::forward;
};

struct polygon_offset {
    float factor, units;  ///< glPolygonOffset
    float clamp;          ///< glPolygonOffsetClamp
};

/// In the order of vkCmdSetDepthBias.
struct vulkan_depth_bias {
    float constant_factor, clamp, slope_factor;
};

/// Of D3D11_RASTERIZER_DESC and D3D12_RASTERIZER_DESC.
struct direct3d_depth_bias {
    std::int32_t depth_bias;
    float depth_bias_clamp, slope_scaled_depth_bias;
};

namespace detail {

/// In steps of the depth buffer, rounded up, towards the far plane.
[[nodiscard]] inline vulkan_depth_bias raster_numbers(const raster_bias& bias, const char* function) {
    const auto not_negative = [](float v) { return is_finite(v) && v >= 0.0f; };
    require(not_negative(bias.reach) && is_finite(2.0f * bias.reach), function, "reach", "must be finite, 0 or more");
    require(not_negative(bias.constant), function, "constant", "must be finite, 0 or more");
    require(not_negative(bias.greatest), function, "greatest", "must be finite, 0 or more");
    require(is_normal(bias.least_depth) && bias.least_depth > 0.0f && bias.least_depth <= 1.0f, function, "least_depth",
            "must be above 0, no denormal, and at most 1");
    const int step = bias.format == depth_format::unorm16   ? -16
                     : bias.format == depth_format::unorm24 ? -24
                                                            : std::ilogb(bias.least_depth) - 23;
    const float units = std::ceil(std::scalbn(bias.constant, -step));
    require(is_finite(units), function, "constant and least_depth", "give too many steps of the depth buffer");
    const float away = bias.direction == depth_direction::forward ? 1.0f : -1.0f;
    return {away * units, away * bias.greatest, away * 2.0f * bias.reach};
}

}  // namespace detail

/// For glPolygonOffset, where GL_POLYGON_OFFSET_FILL is on.
/// @return        factor 2 reach, units constant / step, both negative where depth is reversed
/// @throws std::invalid_argument  what is not finite or negative, a least_depth outside (0, 1]
[[nodiscard]] inline polygon_offset make_polygon_offset(const raster_bias& bias) {
    const auto numbers = detail::raster_numbers(bias, "make_polygon_offset");
    return {numbers.slope_factor, numbers.constant_factor, numbers.clamp};
}

/// For vkCmdSetDepthBias; a clamp other than 0 needs the feature depthBiasClamp.
/// @return        the same numbers
/// @throws std::invalid_argument  as make_polygon_offset
[[nodiscard]] inline vulkan_depth_bias make_vulkan_depth_bias(const raster_bias& bias) {
    return detail::raster_numbers(bias, "make_vulkan_depth_bias");
}

/// For Direct3D's rasterizer state.
/// @return        the same numbers, the constant as a whole one
/// @throws std::invalid_argument  as make_polygon_offset, and for more than 2^31 - 128 steps
[[nodiscard]] inline direct3d_depth_bias make_direct3d_depth_bias(const raster_bias& bias) {
    const auto numbers = detail::raster_numbers(bias, "make_direct3d_depth_bias");
    detail::require(std::abs(numbers.constant_factor) < 0x1p31f, "make_direct3d_depth_bias", "constant and least_depth",
                    "give too many steps of the depth buffer");
    return {static_cast<std::int32_t>(numbers.constant_factor), numbers.clamp, numbers.slope_factor};
}

}  // namespace umbrage

// ---- umbrage/bias/slope.hpp
// How depth changes from texel to texel where a map sees a plane, and the slope-scaled bias that rasterizers have.
//
//     glm::mat4 planes = umbrage::plane_matrix(umbrage::texture_matrix(light, map.size()));  // for planes, not points
//     glm::vec2 slope = umbrage::plane_slope(planes, normal, world);
//     float bias = umbrage::slope_bias(slope, 1.0f, 0.0005f);
//

namespace umbrage {

/// What sends planes where a texture matrix sends their points; a map sees a plane as a plane, spot or not.
///
/// @param texture_matrix   world to texels
/// @return                 for plane_slope; the inverse is taken in double
/// @throws std::invalid_argument  a matrix without an inverse, or not finite
/// @formula                transpose(inverse(texture_matrix))
template <real T>
[[nodiscard]] glm::mat<4, 4, T> plane_matrix(const glm::mat<4, 4, T>& texture_matrix) {
    const glm::mat<4, 4, T> m(glm::transpose(glm::inverse(glm::dmat4(texture_matrix))));
    detail::require(detail::all_finite(texture_matrix) && detail::all_finite(m), "plane_matrix", "texture_matrix",
                    "has no finite inverse");
    return m;
}

/// A slope within what a bias tells apart.
/// @return        -2 .. 2, 2 for NaN: with a reach of half a texel up, acne_free_bias is 1 from 2 on
/// @exactness     A: selects
template <real T>
[[nodiscard]] constexpr T clamp_slope(T slope) {
    if (is_nan(slope)) return T(2);
    return slope > T(-2) ? (slope < T(2) ? slope : T(2)) : T(-2);
}

/// Change of depth from one texel to the next, of the plane through a world.
///
/// @param plane_matrix   of the texture matrix
/// @param normal         of the plane, world, of any length
/// @param world          a point on the plane
/// @return               slope in x and y, each -2 .. 2; 2 where the light sees the plane edge-on and for NaN
/// @formula              q = plane_matrix (normal, -normal . world), slope = -(q.x, q.y) / q.z
/// @exactness            C: two divisions, of each of which GLSL allows 2.5 ulp; 0 seen
template <real T>
[[nodiscard]] constexpr glm::vec<2, T> plane_slope(const glm::mat<4, 4, T>& plane_matrix, glm::vec<3, T> normal,
                                                   glm::vec<3, T> world) {
    const T d = -(normal.x * world.x + normal.y * world.y + normal.z * world.z);
    glm::vec<3, T> q(0);
    for (glm::length_t i = 0; i < 3; ++i)
        q[i] = plane_matrix[3][i] * d + plane_matrix[0][i] * normal.x + plane_matrix[1][i] * normal.y +
               plane_matrix[2][i] * normal.z;
    return {clamp_slope(-q.x / q.z), clamp_slope(-q.y / q.z)};
}

/// The bias that rasterizers know, in a shader: so much a slope, on a base.
///
/// @param slope      change of depth from one texel to the next
/// @param factor     texels
/// @param base       depth
/// @return           0 .. 1; 1 for NaN
/// @formula          factor max(|slope.x|, |slope.y|) + base; with a factor of twice a filter's reach it is at
///                   least acne_free_bias, as |slope.x| + |slope.y| <= 2 max(|slope.x|, |slope.y|)
/// @exactness        B
template <real T>
[[nodiscard]] constexpr T slope_bias(glm::vec<2, T> slope, T factor, T base) {
    const T x = clamp_bias(factor * (slope.x < T(0) ? -slope.x : slope.x) + base);
    const T y = clamp_bias(factor * (slope.y < T(0) ? -slope.y : slope.y) + base);
    return x > y ? x : y;
}

namespace glsl {

inline constexpr snippet clamp_slope{
    .name = "clamp_slope",
    .summary = "clamp of a slope to [-2, 2], NaN to 2",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_clamp_slope: change of depth a texel clamped to [-2, 2]; NaN becomes 2.0
UMBRAGE_HIGHP float umbrage_clamp_slope(UMBRAGE_HIGHP float slope) {
    return slope > -2.0 && slope < 2.0 ? slope : (slope <= -2.0 ? -2.0 : 2.0);
}
)GLSL",
};

inline constexpr snippet plane_slope{
    .name = "plane_slope",
    .summary = "change of a plane's depth from texel to texel",
    .exactness = tier::c,
    .ulp = 1,
    .needs = list<&clamp_slope>,
    .source = R"GLSL(
// umbrage_plane_slope: change of depth from one texel to the next, in x and y, of the plane through a point
//   plane_matrix  transpose of the texture matrix' inverse;   normal  of any length;   world  point on the plane
UMBRAGE_HIGHP vec2 umbrage_plane_slope(UMBRAGE_HIGHP mat4 plane_matrix, UMBRAGE_HIGHP vec3 normal,
                                       UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d = -(normal.x * world.x + normal.y * world.y + normal.z * world.z);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 q = plane_matrix[3] * d + plane_matrix[0] * normal.x +
                                           plane_matrix[1] * normal.y + plane_matrix[2] * normal.z;
    return vec2(umbrage_clamp_slope(-q.x / q.z), umbrage_clamp_slope(-q.y / q.z));
}
)GLSL",
};

inline constexpr snippet slope_bias{
    .name = "slope_bias",
    .summary = "bias by the greater slope, as rasterizers have it",
    .exactness = tier::b,
    .needs = list<&clamp_bias>,
    .source = R"GLSL(
// umbrage_slope_bias: factor times the greater slope, and a base, 0.0 to 1.0
//   slope  change of depth from one texel to the next;   factor  in texels;   base  in depth
UMBRAGE_HIGHP float umbrage_slope_bias(UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP float factor,
                                       UMBRAGE_HIGHP float base) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 bias = abs(slope) * factor + base;
    UMBRAGE_HIGHP float x = umbrage_clamp_bias(bias.x);  // of both: a maximum of a NaN is what a GPU makes it
    UMBRAGE_HIGHP float y = umbrage_clamp_bias(bias.y);
    return x > y ? x : y;
}
)GLSL",
};

inline constexpr auto slope_snippets = list<&clamp_slope, &plane_slope, &slope_bias>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/bias/receiver_plane.hpp
// The receiver's own plane: every texel is compared with the depth that the plane has at the texel's centre, so that no
// reach of a filter needs a bias. The slope comes from the plane (plane_slope), or from derivatives across the screen.
//
//     glm::vec2 slope = umbrage::plane_slope(plane_matrix, normal, world);
//     float visibility = filter(umbrage::on_receiver_plane(fetch, slope, coord), coord, p.z - rounding);
//
// In GLSL with both as globals, ahead of the filter:
//
//     #define STORED(map, size, texel) umbrage_fetch_clamped(map, size, texel).x
//     #define UMBRAGE_FETCH(map, size, texel) umbrage_on_receiver_plane(STORED(map, size, texel), slope, coord, texel)
//

namespace umbrage {

/// The plane through a receiver and its neighbours on the screen.
///
/// @param dx, dy   derivatives of (x and y in texels, depth) along the screen: dFdx, dFdy, taken outside of branches
/// @return         x, y: change of depth from one texel to the next, as plane_slope; z: how far the sum of both may be
///                 off, the bias a texel of reach that is left to add: acne_free_bias({z, 0}, reach, error).
///                 (0, 0, 0), a plane that faces the light, where the texels of a pixel are nearly in line or fewer
///                 than 2^-10, so that nothing is known of the slope; and for NaN
/// @formula        by Cramer's rule; z = 3.3 (2^-25 + (|x| + |y|) 2^-13) s / |determinant|, for coordinates below 4096,
///                 with s / |determinant|, s the sum of the four magnitudes, for 1 / least texels a pixel
/// @exactness      C: divisions, of each of which GLSL allows 2.5 ulp
/// @cite           Isidoro: Shadow Mapping, Tricks and Techniques, GDC 2006
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> receiver_plane(glm::vec<3, T> dx, glm::vec<3, T> dy) {
    const auto magnitude = [](T v) { return v < T(0) ? -v : v; };
    const T determinant = dx.x * dy.y + dx.y * -dy.x;
    const T sum = magnitude(dx.x) + magnitude(dx.y) + magnitude(dy.x) + magnitude(dy.y);
    const T a = clamp_slope((dy.y * dx.z + dx.y * -dy.z) / determinant);
    const T b = clamp_slope((dx.x * dy.z + dy.x * -dx.z) / determinant);
    const T off = (T(0x1p-25) + (magnitude(a) + magnitude(b)) * T(0x1p-13)) * T(3.3);
    const T least = sum * T(0x1p-10);
    const bool known = !is_nan(determinant) && !is_nan(sum) && magnitude(determinant) > least && sum < T(0x1p64);
    if (!known) return glm::vec<3, T>(0);
    return {a, b, clamp_slope(off * (sum / magnitude(determinant)))};
}

/// A stored depth as the receiver's own texel would hold it: moved along the receiver's plane to the receiver.
///
/// @param stored   depth from the map
/// @param slope    of the receiver's plane, a texel, -2 .. 2
/// @param coord    receiver in texels;   texel  whose depth is stored
/// @param far      the cleared depth: 1, or 0 where depth is reversed
/// @return         what to compare with the receiver; a cleared texel, and what is nearer than 2^-64 to one, stays
/// @formula        stored - slope . (texel + 1/2 - coord)
/// @exactness      B
template <real T>
[[nodiscard]] constexpr T on_receiver_plane(T stored, glm::vec<2, T> slope, glm::vec<2, T> coord, glm::vec<2, T> texel,
                                            T far = T(1)) {
    const T x = texel.x + T(0.5) - coord.x, y = texel.y + T(0.5) - coord.y;
    const T before = stored - far;
    const bool cleared = before < T(0x1p-64) && before > T(-0x1p-64);
    return cleared ? stored : stored - (slope.x * x + slope.y * y);
}

/// The same of all texels, as the fetch callable that filters take.
/// @param fetch       ivec2 texel -> stored depth;   coord  that the filter is called with
/// @param direction   of the map's depth, which says what it is cleared to
template <std::invocable<glm::ivec2> Fetch>
[[nodiscard]] auto on_receiver_plane(Fetch fetch, glm::vec2 slope, glm::vec2 coord,
                                     depth_direction direction = depth_direction::forward) {
    return [=, far = cleared_depth(direction)](glm::ivec2 texel) {
        return on_receiver_plane(static_cast<float>(fetch(texel)), slope, coord, glm::vec2(texel), far);
    };
}

namespace glsl {

inline constexpr snippet receiver_plane{
    .name = "receiver_plane",
    .summary = "slope of a receiver's plane from derivatives, and how far it may be off",
    .exactness = tier::c,
    .ulp = 1,
    .needs = list<&clamp_slope>,
    .source = R"GLSL(
// umbrage_receiver_plane: change of a receiver's depth a texel in x and y, and by how much their sum may be off
//   dx, dy  dFdx and dFdy of (x and y in texels, depth); zero where they tell nothing of the plane
UMBRAGE_HIGHP vec3 umbrage_receiver_plane(UMBRAGE_HIGHP vec3 dx, UMBRAGE_HIGHP vec3 dy) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float determinant = dx.x * dy.y + dx.y * -dy.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float sum = abs(dx.x) + abs(dx.y) + abs(dy.x) + abs(dy.y);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float along_x = dy.y * dx.z + dx.y * -dy.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float along_y = dx.x * dy.z + dy.x * -dx.z;
    UMBRAGE_HIGHP float a = umbrage_clamp_slope(along_x / determinant);
    UMBRAGE_HIGHP float b = umbrage_clamp_slope(along_y / determinant);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float off = ((1.0 / 33554432.0) + (abs(a) + abs(b)) * (1.0 / 8192.0)) * 3.3;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float error = off * (sum / abs(determinant));
    UMBRAGE_HIGHP float least = sum * (1.0 / 1024.0);
    bool known = abs(determinant) > least && sum < 18446744073709551616.0;
    return known ? vec3(a, b, umbrage_clamp_slope(error)) : vec3(0.0, 0.0, 0.0);
}
)GLSL",
};

inline constexpr snippet on_receiver_plane{
    .name = "on_receiver_plane",
    .summary = "stored depth moved along the receiver's plane to the receiver",
    .exactness = tier::b,
    .needs = list<&cleared_depth>,
    .source = R"GLSL(
// umbrage_on_receiver_plane: a texel's depth as the receiver's own texel would hold it; a cleared one stays cleared
//   stored  depth of the texel;   slope  of the receiver's plane, a texel;   coord  receiver in texels
UMBRAGE_HIGHP float umbrage_on_receiver_plane(UMBRAGE_HIGHP float stored, UMBRAGE_HIGHP vec2 slope,
                                              UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 way = texel + 0.5 - coord;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = stored - (slope.x * way.x + slope.y * way.y);
    bool cleared = abs(stored - umbrage_cleared_depth()) < (1.0 / 18446744073709551616.0);
    return cleared ? stored : depth;
}
)GLSL",
};

inline constexpr auto receiver_plane_snippets = list<&receiver_plane, &on_receiver_plane>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/depth/code.hpp
// A depth as a whole number of 2^Bits steps, and back: what every encoding of ours is made of.
//
//     std::uint32_t x = umbrage::to_code<11>(0.5f);                         // 1024
//     float d = umbrage::from_code<11>(float(x), umbrage::upper_edge<float>);  // 1025 / 2048
//

namespace umbrage {

/// Where in a code's interval [x, x + 1) * 2^-Bits a decoder answers. With the upper edge no surface shadows itself
/// through quantisation alone (d <= decode(encode(d)) for every d in [0, 1]), and the cleared depth 1 decodes to 1.
template <real T>
inline constexpr T lower_edge = T(0);
template <real T>
inline constexpr T centre = T(0.5);
template <real T>
inline constexpr T upper_edge = T(1);

/// @param depth   clamped to [0, 1]; NaN counts as far: 1, or 0 where depth is reversed
/// @return        0 .. 2^Bits - 1
/// @formula       min(floor(depth 2^Bits), 2^Bits - 1)
/// @exactness     A: scaling by a power of two, floor, min
template <int Bits, real T>
[[nodiscard]] constexpr std::uint32_t to_code(T depth, T far = T(1)) {
    static_assert(Bits >= 1 && Bits <= 24, "a binary32 significand has 24 bits");
    constexpr std::uint32_t codes = std::uint32_t(1) << Bits;
    const auto x = static_cast<std::uint32_t>(saturate(depth, far) * T(codes));
    return x < codes ? x : codes - 1;
}

/// @param code    0 .. 2^Bits - 1
/// @param edge    lower_edge, centre or upper_edge
/// @return        (code + edge) 2^-Bits
/// @exactness     A, but for the centre of 24 bits in binary32, which needs a 25th bit from code 2^23 on (then B)
template <int Bits, real T>
[[nodiscard]] constexpr T from_code(T code, T edge) {
    return (code + edge) * (T(1) / T(std::uint32_t(1) << Bits));
}

/// How far from_code's answer may lie below and above a depth that to_code was given.
[[nodiscard]] constexpr decoding_error edge_error(int bits, float edge) {
    const double step = 1.0 / static_cast<double>(std::uint32_t(1) << bits);
    return {.below = (1.0 - static_cast<double>(edge)) * step, .above = static_cast<double>(edge) * step};
}

}  // namespace umbrage

// ---- umbrage/depth/depth32f.hpp
// A map of plain floats, with the face of an encoding.
//
//     umbrage::image<float> map(size, umbrage::depth32f{}.cleared());
//

namespace umbrage {

/// Clamped to [0, 1] on the way in; on the way out the texel is the depth.
struct depth32f {
    using texel = float;
    static constexpr std::string_view name = "depth32f";
    static constexpr std::string_view summary = "A float texture: nothing to encode.";
    static constexpr const glsl::snippet* writer = &glsl::saturate;
    static constexpr const glsl::snippet* reader = nullptr;
    static constexpr written writes = written::depth;
    static constexpr std::uint64_t codes = 0x3F800001;  ///< floats from 0 to 1

    depth_direction direction = depth_direction::forward;

    [[nodiscard]] constexpr texel encode(float depth) const { return saturate(depth, cleared_depth(direction)); }
    [[nodiscard]] constexpr float decode(texel t) const { return t; }
    [[nodiscard]] constexpr decoding_error error(unorm_store = {}) const { return {}; }
    [[nodiscard]] constexpr texel cleared() const { return cleared_depth(direction); }
};

}  // namespace umbrage

// ---- umbrage/depth/float_bits.hpp
// The bit pattern of any binary32 value in four 8-bit channels, R least significant.
//
//     glm::u8vec4 texel = umbrage::encode_float_bits(view_space_distance);
//     float same = umbrage::decode_float_bits(texel);
//

namespace umbrage {

/// Float to channels.
///
/// @param v       any value; infinities, NaN and its payload survive
/// @return        integer channels 0..255, R least significant
/// @exactness     A: no arithmetic. Hardware that flushes denormals may deliver them as zero before we see them.
template <class = void>  // templates alone may be constexpr where GLM_FORCE_INTRINSICS makes vectors no constants
[[nodiscard]] constexpr glm::u8vec4 encode_float_bits(float v) {
    const auto bits = detail::bit_cast<std::uint32_t>(v);
    return {static_cast<std::uint8_t>(bits & 0xFF), static_cast<std::uint8_t>(bits >> 8 & 0xFF),
            static_cast<std::uint8_t>(bits >> 16 & 0xFF), static_cast<std::uint8_t>(bits >> 24)};
}

/// Bytes to float.
[[nodiscard]] constexpr float decode_float_bits(glm::u8vec4 texel) {
    return detail::bit_cast<float>(std::uint32_t(texel.x) | std::uint32_t(texel.y) << 8 | std::uint32_t(texel.z) << 16 |
                                   std::uint32_t(texel.w) << 24);
}

/// Values read from an 8-bit texture to float.
/// @param c       as sampled, k / 255, in any rounding; clamped to [0, 1], which no texture leaves; NaN counts as 1
/// @exactness     A
[[nodiscard]] inline float decode_float_bits(glm::vec4 c) {
    glm::u8vec4 texel(0);
    for (glm::length_t i = 0; i < 4; ++i) texel[i] = static_cast<std::uint8_t>(from_unorm(saturate(c[i])));
    return decode_float_bits(texel);
}

namespace glsl {

inline constexpr snippet encode_float_bits{
    .name = "encode_float_bits",
    .summary = "any float's bit pattern to four channels, R least significant",
    .exactness = tier::a,
    .lowest = version::v300_es,
    .source = R"GLSL(
// umbrage_encode_float_bits: bit pattern of v as four channels, R least significant, whole numbers 0..255
UMBRAGE_HIGHP vec4 umbrage_encode_float_bits(UMBRAGE_HIGHP float v) {
    UMBRAGE_HIGHP uint bits = floatBitsToUint(v);
    return vec4(float(bits & 255u), float((bits >> 8) & 255u), float((bits >> 16) & 255u), float(bits >> 24));
}
)GLSL",
};

inline constexpr snippet decode_float_bits{
    .name = "decode_float_bits",
    .summary = "four channels, R least significant, to the float they are",
    .exactness = tier::a,
    .lowest = version::v300_es,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_decode_float_bits: four channels of a bit pattern, as sampled, R least significant, to the float
UMBRAGE_HIGHP float umbrage_decode_float_bits(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_HIGHP uint r = uint(umbrage_saturate(c.x) * 255.0 + 0.5);
    UMBRAGE_HIGHP uint g = uint(umbrage_saturate(c.y) * 255.0 + 0.5);
    UMBRAGE_HIGHP uint b = uint(umbrage_saturate(c.z) * 255.0 + 0.5);
    UMBRAGE_HIGHP uint a = uint(umbrage_saturate(c.w) * 255.0 + 0.5);
    return uintBitsToFloat(r | (g << 8) | (b << 16) | (a << 24));
}
)GLSL",
};

}  // namespace glsl

/// The encoding as a value.
struct float_bits {
    using texel = glm::u8vec4;
    static constexpr std::string_view name = "float_bits";
    static constexpr std::string_view summary = "The bit pattern of the float itself, R least significant.";
    static constexpr const glsl::snippet* writer = &glsl::encode_float_bits;
    static constexpr const glsl::snippet* reader = &glsl::decode_float_bits;
    static constexpr written writes = written::bytes;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 32;

    depth_direction direction = depth_direction::forward;

    [[nodiscard]] texel encode(float depth) const { return encode_float_bits(depth); }
    [[nodiscard]] constexpr float decode(texel t) const { return decode_float_bits(t); }
    [[nodiscard]] constexpr decoding_error error(unorm_store = {}) const { return {}; }
    [[nodiscard]] texel cleared() const { return encode(cleared_depth(direction)); }
};

}  // namespace umbrage

// ---- umbrage/depth/foreign/base255.hpp
// The RGBA format of Aras Pranckevicius, base 255, as Cesium, Babylon.js and bgfx use it, to read and write such maps.
//
//     float stored = umbrage::decode_base255(umbrage::load_unorm8(texel));
//
// Below 1.0 the worst error is 2^-23. Faults of the format: 1.0 decodes to 0, and where the store truncates the error
// is up to 2^-7.98 and nearby depths change places. The repaired writer has neither, for the same reader; what is left
// is the reader's rounding: depths k / 2^24 keep their order, two pairs of other neighbouring floats decode 1 ulp out
// of it.
//

namespace umbrage {

/// @param depth   clamped to [0, 1], NaN counts as far: 1, or 0 where depth is reversed; 1 decodes to 0, a fault
/// @return        UNORM values
/// @formula       e_i = fract(255^i depth), each less 1/255 of the next
/// @exactness     B
/// @cite          Pranckevicius: Encoding floats to RGBA - the final?, 2009 (format)
template <real T>
[[nodiscard]] glm::vec<4, T> write_base255(T depth, T far = T(1)) {
    const T v = saturate(depth, far);
    const T x = v - std::floor(v);
    const T y = v * T(255) - std::floor(v * T(255));
    const T z = v * T(65025) - std::floor(v * T(65025));
    const T w = v * T(16581375) - std::floor(v * T(16581375));
    constexpr T step = T(1.0 / 255.0);
    return {x - y * step, y - z * step, z - w * step, w};
}

/// @param c      as sampled
/// @formula      R + G/255 + B/255^2 + A/255^3
/// @exactness    B
template <real T>
[[nodiscard]] constexpr T decode_base255(glm::vec<4, T> c) {
    return c.x + c.y * T(1.0 / 255.0) + c.z * T(1.0 / 65025.0) + c.w * T(1.0 / 16581375.0);
}

/// A writer without the faults, for decode_base255 on the other side: the digits of depth in base 255.
/// @return        integer channels 0..255 (to_unorm writes them); 1 gives (255, 0, 0, 0)
/// @exactness     B
template <real T>
[[nodiscard]] glm::u8vec4 encode_base255_repaired(T depth, T far = T(1)) {
    T rest = saturate(depth, far) * T(255);
    glm::u8vec4 digits(0);
    for (glm::length_t i = 0; i < 4; ++i) {
        const T digit = std::floor(rest);
        digits[i] = static_cast<std::uint8_t>(digit);
        rest = (rest - digit) * T(255);
    }
    return digits;
}

namespace glsl {

inline constexpr snippet write_base255{
    .name = "write_base255",
    .summary = "depth to the base-255 RGBA format of Cesium, Babylon.js, bgfx",
    .exactness = tier::b,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_write_base255: depth to base-255 RGBA, values to write as they are; 1.0 reads back as 0.0, and the store must
//   round: umbrage_encode_base255_repaired has neither fault
UMBRAGE_HIGHP vec4 umbrage_write_base255(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 e = vec4(v, v * 255.0, v * 65025.0, v * 16581375.0);
    e = e - floor(e);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 c =
        vec4(e.x - e.y * 0.00392156886, e.y - e.z * 0.00392156886, e.z - e.w * 0.00392156886, e.w);
    return c;
}
)GLSL",
};

inline constexpr snippet decode_base255{
    .name = "decode_base255",
    .summary = "base-255 RGBA to depth",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_decode_base255: base-255 RGBA, as sampled, to depth
UMBRAGE_HIGHP float umbrage_decode_base255(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth =
        c.x + c.y * 0.00392156886 + c.z * 0.0000153787005 + c.w * 0.0000000603086294;
    return depth;
}
)GLSL",
};

inline constexpr snippet encode_base255_repaired{
    .name = "encode_base255_repaired",
    .summary = "depth for readers of base-255 RGBA, 1.0 and truncation repaired",
    .exactness = tier::b,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_encode_base255_repaired: depth to channels that readers of base-255 RGBA decode, 1.0 to 1.0;
//   whole numbers 0..255 (umbrage_to_unorm writes them)
UMBRAGE_HIGHP vec4 umbrage_encode_base255_repaired(UMBRAGE_HIGHP float depth) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = umbrage_saturate(depth) * 255.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = (x - floor(x)) * 255.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = (y - floor(y)) * 255.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float w = (z - floor(z)) * 255.0;
    return vec4(floor(x), floor(y), floor(z), floor(w));
}
)GLSL",
};

}  // namespace glsl

/// The format as a value, faults and all; the store rounds. An empty map is cleared to what decodes to 1.
struct base255 {
    using texel = glm::u8vec4;
    static constexpr std::string_view name = "base255";
    static constexpr std::string_view summary =
        "Base 255, as in Cesium, Babylon.js and bgfx, its fault included: 1 reads back as 0.";
    static constexpr const glsl::snippet* writer = &glsl::write_base255;
    static constexpr const glsl::snippet* reader = &glsl::decode_base255;
    static constexpr written writes = written::values;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 32;

    depth_direction direction = depth_direction::forward;

    /// The writer's values.
    [[nodiscard]] auto write(float depth) const { return write_base255(depth, cleared_depth(direction)); }
    [[nodiscard]] texel encode(float depth) const { return store_unorm8(write(depth)); }
    [[nodiscard]] float decode(texel t) const { return decode_base255(load_unorm8(t)); }
    [[nodiscard]] constexpr decoding_error error(unorm_store store = unorm_store::rounds) const {
        const double either = store == unorm_store::rounds ? 0x1p-23 : 0x1.021p-8;
        return {.below = either, .above = either};
    }
    [[nodiscard]] texel cleared() const {
        return direction == depth_direction::forward ? texel(255, 0, 0, 0) : texel(0);
    }
};

/// The same, written without the faults.
struct base255_repaired {
    using texel = glm::u8vec4;
    static constexpr std::string_view name = "base255_repaired";
    static constexpr std::string_view summary = "For readers of base 255, written without the fault.";
    static constexpr const glsl::snippet* writer = &glsl::encode_base255_repaired;
    static constexpr const glsl::snippet* reader = &glsl::decode_base255;
    static constexpr written writes = written::bytes;
    static constexpr std::uint64_t codes = std::uint64_t(255) * 255 * 255 * 255 + 1;

    depth_direction direction = depth_direction::forward;

    [[nodiscard]] texel encode(float depth) const { return encode_base255_repaired(depth, cleared_depth(direction)); }
    [[nodiscard]] float decode(texel t) const { return decode_base255(load_unorm8(t)); }
    [[nodiscard]] constexpr decoding_error error(unorm_store = {}) const {
        return {.below = 0x1p-23, .above = 0x1p-23};
    }
    [[nodiscard]] texel cleared() const { return encode(cleared_depth(direction)); }
};

}  // namespace umbrage

// ---- umbrage/depth/foreign/threejs.hpp
// The depth formats of three.js, r167 and later, to read and write its maps: RGBA, RGB and RG. Writers give UNORM
// values as three.js does; what the 8-bit store makes of the channel that holds a fraction is part of the format.
//
//     glm::u8vec4 texel = umbrage::store_unorm8(umbrage::write_threejs_rgba(depth));
//     float stored = umbrage::decode_threejs_rgba(umbrage::load_unorm8(texel));
//
// Worst error of any binary32 depth, as measured by the tests:
//
//     format   store rounds   store truncates
//     rgba     2^-32          2^-31.99
//     rgb      2^-24          2^-23.99
//     rg       2^-16.99       2^-15.99
//

namespace umbrage {

/// Three whole bytes, R most significant, and the fraction that is left in A.
/// @param depth   clamped to [0, 1]; NaN counts as far: 1, or 0 where depth is reversed; 1 gives all ones
/// @return        UNORM values
/// @exactness     B
/// @cite          three.js r167 and later, packing chunk (format)
template <real T>
[[nodiscard]] glm::vec<4, T> write_threejs_rgba(T depth, T far = T(1)) {
    const T v = saturate(depth, far);
    if (!(v < T(1))) return glm::vec<4, T>(1);
    const T x = v * T(16777216);
    const T whole = std::floor(x);
    const T high = std::floor(whole * T(1.0 / 65536.0));
    const T rest = whole - high * T(65536);
    const T middle = std::floor(rest * T(1.0 / 256.0));
    return {high * T(1.0 / 255.0), middle * T(1.0 / 255.0), (rest - middle * T(256)) * T(1.0 / 255.0), x - whole};
}

/// @param c      as sampled
/// @formula      255/256 (R + G/2^8 + B/2^16) + A/2^24
/// @exactness    B
template <real T>
[[nodiscard]] constexpr T decode_threejs_rgba(glm::vec<4, T> c) {
    return c.x * T(255.0 / 256.0) + c.y * T(255.0 / 65536.0) + c.z * T(255.0 / 16777216.0) + c.w * T(1.0 / 16777216.0);
}

/// Two whole bytes and the fraction that is left in B.  @exactness B  @cite three.js r167 and later (format)
template <real T>
[[nodiscard]] glm::vec<3, T> write_threejs_rgb(T depth, T far = T(1)) {
    const T v = saturate(depth, far);
    if (!(v < T(1))) return glm::vec<3, T>(1);
    const T x = v * T(65536);
    const T whole = std::floor(x);
    const T high = std::floor(whole * T(1.0 / 256.0));
    return {high * T(1.0 / 255.0), (whole - high * T(256)) * T(1.0 / 255.0), x - whole};
}

/// @formula      255/256 (R + G/2^8) + B/2^16       @exactness B
template <real T>
[[nodiscard]] constexpr T decode_threejs_rgb(glm::vec<3, T> c) {
    return c.x * T(255.0 / 256.0) + c.y * T(255.0 / 65536.0) + c.z * T(1.0 / 65536.0);
}

/// One whole byte and the fraction that is left in G.  @exactness B  @cite three.js r167 and later (format)
template <real T>
[[nodiscard]] glm::vec<2, T> write_threejs_rg(T depth, T far = T(1)) {
    const T v = saturate(depth, far);
    if (!(v < T(1))) return glm::vec<2, T>(1);
    const T x = v * T(256);
    const T whole = std::floor(x);
    return {whole * T(1.0 / 255.0), x - whole};
}

/// @formula      255/256 R + G/2^8                  @exactness B
template <real T>
[[nodiscard]] constexpr T decode_threejs_rg(glm::vec<2, T> c) {
    return c.x * T(255.0 / 256.0) + c.y * T(1.0 / 256.0);
}

namespace glsl {

inline constexpr snippet write_threejs_rgba{
    .name = "write_threejs_rgba",
    .summary = "depth to three.js RGBA, r167 and later",
    .exactness = tier::b,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_write_threejs_rgba: depth to the RGBA format of three.js r167 and later, values to write as they are
UMBRAGE_HIGHP vec4 umbrage_write_threejs_rgba(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_HIGHP float x = v * 16777216.0;
    UMBRAGE_HIGHP float whole = floor(x);
    UMBRAGE_HIGHP float high = floor(whole * (1.0 / 65536.0));
    UMBRAGE_HIGHP float rest = whole - high * 65536.0;
    UMBRAGE_HIGHP float middle = floor(rest * (1.0 / 256.0));
    UMBRAGE_HIGHP float low = rest - middle * 256.0;
    UMBRAGE_HIGHP vec4 c = vec4(high * 0.00392156886, middle * 0.00392156886, low * 0.00392156886, x - whole);
    return v < 1.0 ? c : vec4(1.0, 1.0, 1.0, 1.0);
}
)GLSL",
};

inline constexpr snippet decode_threejs_rgba{
    .name = "decode_threejs_rgba",
    .summary = "three.js RGBA, r167 and later, to depth",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_decode_threejs_rgba: the RGBA format of three.js r167 and later, as sampled, to depth
UMBRAGE_HIGHP float umbrage_decode_threejs_rgba(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) +
                                                c.z * (255.0 / 16777216.0) + c.w * (1.0 / 16777216.0);
    return depth;
}
)GLSL",
};

inline constexpr snippet write_threejs_rgb{
    .name = "write_threejs_rgb",
    .summary = "depth to three.js RGB, r167 and later",
    .exactness = tier::b,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_write_threejs_rgb: depth to the RGB format of three.js r167 and later, values to write as they are
UMBRAGE_HIGHP vec3 umbrage_write_threejs_rgb(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_HIGHP float x = v * 65536.0;
    UMBRAGE_HIGHP float whole = floor(x);
    UMBRAGE_HIGHP float high = floor(whole * (1.0 / 256.0));
    UMBRAGE_HIGHP vec3 c = vec3(high * 0.00392156886, (whole - high * 256.0) * 0.00392156886, x - whole);
    return v < 1.0 ? c : vec3(1.0, 1.0, 1.0);
}
)GLSL",
};

inline constexpr snippet decode_threejs_rgb{
    .name = "decode_threejs_rgb",
    .summary = "three.js RGB, r167 and later, to depth",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_decode_threejs_rgb: the RGB format of three.js r167 and later, as sampled, to depth
UMBRAGE_HIGHP float umbrage_decode_threejs_rgb(UMBRAGE_HIGHP vec3 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth =
        c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (1.0 / 65536.0);
    return depth;
}
)GLSL",
};

inline constexpr snippet write_threejs_rg{
    .name = "write_threejs_rg",
    .summary = "depth to three.js RG, r167 and later",
    .exactness = tier::b,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_write_threejs_rg: depth to the RG format of three.js r167 and later, values to write as they are
UMBRAGE_HIGHP vec2 umbrage_write_threejs_rg(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_HIGHP float x = v * 256.0;
    UMBRAGE_HIGHP float whole = floor(x);
    return v < 1.0 ? vec2(whole * 0.00392156886, x - whole) : vec2(1.0, 1.0);
}
)GLSL",
};

inline constexpr snippet decode_threejs_rg{
    .name = "decode_threejs_rg",
    .summary = "three.js RG, r167 and later, to depth",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_decode_threejs_rg: the RG format of three.js r167 and later, as sampled, to depth
UMBRAGE_HIGHP float umbrage_decode_threejs_rg(UMBRAGE_HIGHP vec2 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = c.x * (255.0 / 256.0) + c.y * (1.0 / 256.0);
    return depth;
}
)GLSL",
};

}  // namespace glsl

// The formats as values; the store rounds.

/// RGBA, r167 and later.
struct threejs_rgba {
    using texel = glm::u8vec4;
    static constexpr std::string_view name = "threejs_rgba";
    static constexpr std::string_view summary = "RGBA of three.js since r167: three whole bytes and the rest.";
    static constexpr const glsl::snippet* writer = &glsl::write_threejs_rgba;
    static constexpr const glsl::snippet* reader = &glsl::decode_threejs_rgba;
    static constexpr written writes = written::values;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 32;

    depth_direction direction = depth_direction::forward;

    /// The writer's values.
    [[nodiscard]] auto write(float depth) const { return write_threejs_rgba(depth, cleared_depth(direction)); }
    [[nodiscard]] texel encode(float depth) const { return store_unorm8(write(depth)); }
    [[nodiscard]] float decode(texel t) const { return decode_threejs_rgba(load_unorm8(t)); }
    [[nodiscard]] constexpr decoding_error error(unorm_store store = unorm_store::rounds) const {
        const double either = store == unorm_store::rounds ? 0x1p-32 : 0x1p-32 * 256 / 255;
        return {.below = either, .above = either};
    }
    [[nodiscard]] texel cleared() const { return encode(cleared_depth(direction)); }
};

/// RGB, r167 and later.
struct threejs_rgb {
    using texel = glm::u8vec3;
    static constexpr std::string_view name = "threejs_rgb";
    static constexpr std::string_view summary = "RGB of three.js since r167: two whole bytes and the rest.";
    static constexpr const glsl::snippet* writer = &glsl::write_threejs_rgb;
    static constexpr const glsl::snippet* reader = &glsl::decode_threejs_rgb;
    static constexpr written writes = written::values;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 24;

    depth_direction direction = depth_direction::forward;

    /// The writer's values.
    [[nodiscard]] auto write(float depth) const { return write_threejs_rgb(depth, cleared_depth(direction)); }
    [[nodiscard]] texel encode(float depth) const { return store_unorm8(write(depth)); }
    [[nodiscard]] float decode(texel t) const { return decode_threejs_rgb(load_unorm8(t)); }
    [[nodiscard]] constexpr decoding_error error(unorm_store store = unorm_store::rounds) const {
        const double either = store == unorm_store::rounds ? 0x1p-24 : 0x1p-24 * 256 / 255;
        return {.below = either, .above = either};
    }
    [[nodiscard]] texel cleared() const { return encode(cleared_depth(direction)); }
};

/// RG, r167 and later.
struct threejs_rg {
    using texel = glm::u8vec2;
    static constexpr std::string_view name = "threejs_rg";
    static constexpr std::string_view summary = "RG of three.js since r167: one whole byte and the rest.";
    static constexpr const glsl::snippet* writer = &glsl::write_threejs_rg;
    static constexpr const glsl::snippet* reader = &glsl::decode_threejs_rg;
    static constexpr written writes = written::values;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 16;

    depth_direction direction = depth_direction::forward;

    /// The writer's values.
    [[nodiscard]] auto write(float depth) const { return write_threejs_rg(depth, cleared_depth(direction)); }
    [[nodiscard]] texel encode(float depth) const { return store_unorm8(write(depth)); }
    [[nodiscard]] float decode(texel t) const { return decode_threejs_rg(load_unorm8(t)); }
    [[nodiscard]] constexpr decoding_error error(unorm_store store = unorm_store::rounds) const {
        const double either = store == unorm_store::rounds ? 0x1.02p-17 : 0x1p-16 * 256 / 255;
        return {.below = either, .above = either};
    }
    [[nodiscard]] texel cleared() const { return encode(cleared_depth(direction)); }
};

}  // namespace umbrage

// ---- umbrage/depth/foreign/threejs_legacy.hpp
// The RGBA depth format of three.js r73 to r166, to read and write its maps, and a writer without its fault. What the
// 8-bit store makes of the channel that holds a fraction is part of the format.
//
//     glm::u8vec4 texel = umbrage::store_unorm8(umbrage::write_threejs_legacy(depth));
//     float stored = umbrage::decode_threejs_legacy(umbrage::load_unorm8(texel));
//
// Worst error of any binary32 depth, and the faults, as measured by the tests:
//
//     format             store rounds     store truncates   faults
//     legacy             2^-32, below 1   2^-32, below 1    1.0 decodes to 255/256, below depths that come before it
//     legacy, repaired   2^-24            2^-24             none
//

namespace umbrage {

/// The layout of r73 to r166: A most significant, channels scaled by 256/255.
/// @return        UNORM values; A exceeds 1 for depth > 255/256, and the store clamps it: the fault of the format
/// @exactness     B
/// @cite          three.js r73 to r166, packing chunk (format)
template <real T>
[[nodiscard]] glm::vec<4, T> write_threejs_legacy(T depth, T far = T(1)) {
    const T v = saturate(depth, far);
    const T x = v * T(16777216) - std::floor(v * T(16777216));
    const T y = v * T(65536) - std::floor(v * T(65536));
    const T z = v * T(256) - std::floor(v * T(256));
    return {x * T(256.0 / 255.0), (y - x * T(1.0 / 256.0)) * T(256.0 / 255.0),
            (z - y * T(1.0 / 256.0)) * T(256.0 / 255.0), (v - z * T(1.0 / 256.0)) * T(256.0 / 255.0)};
}

/// @formula      255/256 (A + B/2^8 + G/2^16 + R/2^24)   @exactness B
template <real T>
[[nodiscard]] constexpr T decode_threejs_legacy(glm::vec<4, T> c) {
    return c.x * T(255.0 / 4294967296.0) + c.y * T(255.0 / 16777216.0) + c.z * T(255.0 / 65536.0) +
           c.w * T(255.0 / 256.0);
}

/// A writer without the fault, for decode_threejs_legacy on the other side: 24 bits, and 1 decodes to 1.
/// @return        integer channels 0..255 (to_unorm writes them), A most significant
/// @exactness     A
template <real T>
[[nodiscard]] constexpr glm::u8vec4 encode_threejs_legacy_repaired(T depth, T far = T(1)) {
    const T v = saturate(depth, far);
    if (!(v < T(1))) return glm::u8vec4(255);
    const std::uint32_t x = to_code<24>(v);
    return {0, static_cast<std::uint8_t>(x & 0xFF), static_cast<std::uint8_t>(x >> 8 & 0xFF),
            static_cast<std::uint8_t>(x >> 16)};
}

namespace glsl {

inline constexpr snippet write_threejs_legacy{
    .name = "write_threejs_legacy",
    .summary = "depth to three.js RGBA, r73 to r166",
    .exactness = tier::b,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_write_threejs_legacy: depth to the RGBA format of three.js r73 to r166, values to write as they are;
//   1.0 reads back as 255/256: umbrage_encode_threejs_legacy_repaired does not
UMBRAGE_HIGHP vec4 umbrage_write_threejs_legacy(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_HIGHP float x = v * 16777216.0 - floor(v * 16777216.0);
    UMBRAGE_HIGHP float y = v * 65536.0 - floor(v * 65536.0);
    UMBRAGE_HIGHP float z = v * 256.0 - floor(v * 256.0);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 c = vec4(x, y - x * (1.0 / 256.0), z - y * (1.0 / 256.0), v - z * (1.0 / 256.0));
    return c * 1.00392163;
}
)GLSL",
};

inline constexpr snippet decode_threejs_legacy{
    .name = "decode_threejs_legacy",
    .summary = "three.js RGBA, r73 to r166, to depth",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_decode_threejs_legacy: the RGBA format of three.js r73 to r166, as sampled, to depth
UMBRAGE_HIGHP float umbrage_decode_threejs_legacy(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = c.x * (255.0 / 4294967296.0) + c.y * (255.0 / 16777216.0) +
                                                c.z * (255.0 / 65536.0) + c.w * (255.0 / 256.0);
    return depth;
}
)GLSL",
};

inline constexpr snippet encode_threejs_legacy_repaired{
    .name = "encode_threejs_legacy_repaired",
    .summary = "depth for readers of three.js RGBA, r73 to r166, 1.0 repaired",
    .exactness = tier::a,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_encode_threejs_legacy_repaired: depth to channels that readers of three.js r73 to r166 decode, 1.0 to 1.0;
//   whole numbers 0..255 (umbrage_to_unorm writes them)
UMBRAGE_HIGHP vec4 umbrage_encode_threejs_legacy_repaired(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_HIGHP float x = floor(v * 16777216.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 65536.0));
    UMBRAGE_HIGHP float rest = x - high * 65536.0;
    UMBRAGE_HIGHP float middle = floor(rest * (1.0 / 256.0));
    return v < 1.0 ? vec4(0.0, rest - middle * 256.0, middle, high) : vec4(255.0, 255.0, 255.0, 255.0);
}
)GLSL",
};

}  // namespace glsl

// The formats as values; the store rounds.

/// RGBA, r73 to r166, fault and all: 1 decodes to 255/256. An empty map is cleared to what decodes to 1.
struct threejs_legacy {
    using texel = glm::u8vec4;
    static constexpr std::string_view name = "threejs_legacy";
    static constexpr std::string_view summary =
        "RGBA of three.js r73 to r166, its fault included: 1 reads back as 255/256.";
    static constexpr const glsl::snippet* writer = &glsl::write_threejs_legacy;
    static constexpr const glsl::snippet* reader = &glsl::decode_threejs_legacy;
    static constexpr written writes = written::values;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 32;

    depth_direction direction = depth_direction::forward;

    /// The writer's values.
    [[nodiscard]] auto write(float depth) const { return write_threejs_legacy(depth, cleared_depth(direction)); }
    [[nodiscard]] texel encode(float depth) const { return store_unorm8(write(depth)); }
    [[nodiscard]] float decode(texel t) const { return decode_threejs_legacy(load_unorm8(t)); }
    [[nodiscard]] constexpr decoding_error error(unorm_store = {}) const {
        return {.below = 0x1p-32, .above = 0x1p-32};
    }
    [[nodiscard]] texel cleared() const { return direction == depth_direction::forward ? texel(255) : texel(0); }
};

/// RGBA for readers of r73 to r166, written without the fault.
struct threejs_legacy_repaired {
    using texel = glm::u8vec4;
    static constexpr std::string_view name = "threejs_legacy_repaired";
    static constexpr std::string_view summary = "For readers of three.js r73 to r166, written without the fault.";
    static constexpr const glsl::snippet* writer = &glsl::encode_threejs_legacy_repaired;
    static constexpr const glsl::snippet* reader = &glsl::decode_threejs_legacy;
    static constexpr written writes = written::bytes;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 24;

    depth_direction direction = depth_direction::forward;

    [[nodiscard]] texel encode(float depth) const {
        return encode_threejs_legacy_repaired(depth, cleared_depth(direction));
    }
    [[nodiscard]] float decode(texel t) const { return decode_threejs_legacy(load_unorm8(t)); }
    [[nodiscard]] constexpr decoding_error error(unorm_store = {}) const {
        return {.below = 0x1p-24, .above = 0x1p-24};
    }
    [[nodiscard]] texel cleared() const { return encode(cleared_depth(direction)); }
};

}  // namespace umbrage

// ---- umbrage/image.hpp
// Images: a view over anybody's pixels, an owner, and the two ways to fetch a texel.
//
//     umbrage::image<float> map({1024, 1024}, 1.0f);
//     umbrage::image_view<const float> foreign(pixels, {width, height}, bytes_per_row);
//     float depth = umbrage::clamped(foreign)(glm::ivec2(-1, 5));  // the texel at (0, 5)
//

namespace umbrage {

/// Pixels that somebody else owns: rows of `size.x` elements, `stride` bytes from one row to the next.
/// Row 0 is at `data`; with a negative stride the others come before it, as in a bottom-up image. An empty view has a
/// zero in its size.
template <class T>
struct image_view {
    T* data = nullptr;
    glm::ivec2 size{0, 0};
    std::ptrdiff_t stride = 0;  ///< in bytes

    constexpr image_view() = default;

    /// Rows that follow each other without a gap.
    constexpr image_view(T* pixels, glm::ivec2 extent)
        : image_view(pixels, extent, extent.x * static_cast<std::ptrdiff_t>(sizeof(T))) {}

    /// @throws std::invalid_argument  negative size; pixels missing; stride shorter than a row
    ///                                or not a multiple of the alignment of T
    constexpr image_view(T* pixels, glm::ivec2 extent, std::ptrdiff_t stride_bytes)
        : data(pixels), size(extent), stride(stride_bytes) {
        if (extent.x < 0 || extent.y < 0) detail::fail("umbrage::image_view: negative size");
        if (empty()) return;
        const auto row_bytes = extent.x * static_cast<std::ptrdiff_t>(sizeof(T));
        const auto distance = stride_bytes < 0 ? -stride_bytes : stride_bytes;
        if (!pixels) detail::fail("umbrage::image_view: no pixels");
        if (extent.y > 1 && distance < row_bytes) detail::fail("umbrage::image_view: stride shorter than a row");
        if (distance % static_cast<std::ptrdiff_t>(alignof(T)) != 0)
            detail::fail("umbrage::image_view: stride breaks the alignment of a texel");
    }

    /// A view that may write is also a view that may read.
    constexpr operator image_view<const T>() const requires(!std::is_const_v<T>) { return {data, size, stride}; }

    [[nodiscard]] constexpr bool empty() const { return size.x == 0 || size.y == 0; }

    /// First texel of row y, 0 <= y < size.y.
    [[nodiscard]] T* row(int y) const {
        assert(y >= 0 && y < size.y);
        using byte = std::conditional_t<std::is_const_v<T>, const std::byte, std::byte>;
        return reinterpret_cast<T*>(reinterpret_cast<byte*>(data) + y * stride);
    }

    /// Texel inside the image.
    [[nodiscard]] T& operator[](glm::ivec2 texel) const {
        assert(texel.x >= 0 && texel.x < size.x);
        return row(texel.y)[texel.x];
    }

    /// The texels from `first` on, `extent` of them, as a map of their own: a tile of an atlas, with edges of its own.
    /// @throws std::invalid_argument  not inside the image
    [[nodiscard]] image_view region(glm::ivec2 first, glm::ivec2 extent) const {
        const bool inside = first.x >= 0 && first.y >= 0 && extent.x >= 0 && extent.y >= 0 &&
                            extent.x <= size.x - first.x && extent.y <= size.y - first.y;
        if (!inside) detail::fail("umbrage::image_view: region is not inside the image");
        const bool none = extent.x == 0 || extent.y == 0;
        return {none ? data : row(first.y) + first.x, extent, stride};
    }

    /// Rows first <= y < last as a view of their own: the unit of work for a thread.
    [[nodiscard]] image_view rows(int first, int last) const {
        assert(0 <= first && first <= last && last <= size.y);
        return {first < last ? row(first) : data, {size.x, last - first}, stride};
    }
};

namespace detail {

/// Aligns memory to cache lines, so that no block of pixels straddles two without need.
template <class T>
struct line_allocator {
    using value_type = T;
    static constexpr std::align_val_t line{64};

    line_allocator() = default;
    template <class Other>
    line_allocator(const line_allocator<Other>&) {}
    [[nodiscard]] T* allocate(std::size_t count) { return static_cast<T*>(::operator new(count * sizeof(T), line)); }
    void deallocate(T* pixels, std::size_t) { ::operator delete(pixels, line); }
    bool operator==(const line_allocator&) const = default;
};

}  // namespace detail

/// Pixels of our own, without gaps between rows.
template <class T>
class image {
public:
    image() = default;

    /// @throws std::invalid_argument  negative size
    explicit image(glm::ivec2 size, const T& value = T{}) : size_(size) {
        if (size.x < 0 || size.y < 0) detail::fail("umbrage::image: negative size");
        texels_.assign(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), value);
    }

    [[nodiscard]] glm::ivec2 size() const { return size_; }
    [[nodiscard]] bool empty() const { return texels_.empty(); }
    [[nodiscard]] std::span<T> texels() & { return texels_; }
    [[nodiscard]] std::span<const T> texels() const& { return texels_; }
    void texels() && = delete;  ///< of a temporary: they would dangle

    [[nodiscard]] T& operator[](glm::ivec2 texel) { return view()[texel]; }
    [[nodiscard]] const T& operator[](glm::ivec2 texel) const { return view()[texel]; }

    [[nodiscard]] image_view<T> view() { return {texels_.data(), size_}; }
    [[nodiscard]] image_view<const T> view() const { return {texels_.data(), size_}; }
    operator image_view<T>() { return view(); }
    operator image_view<const T>() const { return view(); }

private:
    static_assert(!std::is_same_v<T, bool>, "std::vector<bool> has no pixels to view: use std::uint8_t");
    glm::ivec2 size_{0, 0};
    std::vector<T, detail::line_allocator<T>> texels_;
};

namespace detail {

/// What functions over images take: an image, or a view of one.
template <class T>
[[nodiscard]] image_view<T> view_of(image_view<T> view) {
    return view;
}
template <class T>
[[nodiscard]] image_view<T> view_of(image<T>& of) {
    return of;
}
template <class T>
[[nodiscard]] image_view<const T> view_of(const image<T>& of) {
    return of;
}
template <class T>
inline constexpr bool is_image = false;
template <class T>
inline constexpr bool is_image<image<T>> = true;
template <class... Any>
concept some_image = (is_image<std::remove_cvref_t<Any>> || ...);

}  // namespace detail

/// Texel inside the map.
/// @exactness   A
template <class T>
[[nodiscard]] std::remove_const_t<T> texel(image_view<T> map, glm::ivec2 at) {
    return map[at];
}

/// @param size    of a map, in texels
/// @exactness     A
[[nodiscard]] constexpr bool inside_map(glm::ivec2 size, glm::ivec2 at) {
    return at.x >= 0 && at.y >= 0 && at.x < size.x && at.y < size.y;
}

/// Texel of the map, coordinates outside moved to the nearest one inside. The map must not be empty.
/// @exactness   A
template <class T>
[[nodiscard]] std::remove_const_t<T> fetch_clamped(image_view<T> map, glm::ivec2 texel) {
    assert(!map.empty());
    const int x = texel.x < 0 ? 0 : (texel.x < map.size.x ? texel.x : map.size.x - 1);
    const int y = texel.y < 0 ? 0 : (texel.y < map.size.y ? texel.y : map.size.y - 1);
    return map.row(y)[x];
}

/// Texel of the map, or `border` outside of it. An empty map is all border.
/// @exactness   A
template <class T>
[[nodiscard]] std::remove_const_t<T> fetch_bordered(image_view<T> map, glm::ivec2 texel,
                                                    std::remove_const_t<T> border) {
    return inside_map(map.size, texel) ? map.row(texel.y)[texel.x] : border;
}

/// fetch_clamped as the callable that filters take.
/// @throws std::invalid_argument  empty map
template <class T>
[[nodiscard]] auto clamped(image_view<T> map) {
    if (map.empty()) detail::fail("umbrage::clamped: empty map");
    return [map](glm::ivec2 texel) { return fetch_clamped(map, texel); };
}
template <class T>
[[nodiscard]] auto clamped(const image<T>& map) {
    return clamped(map.view());
}

/// fetch_bordered as the callable that filters take; with `border` the cleared depth, everything outside the map is
/// lit.
template <class T>
[[nodiscard]] auto bordered(image_view<T> map, std::remove_const_t<T> border) {
    return [map, border](glm::ivec2 texel) { return fetch_bordered(map, texel, border); };
}
template <class T>
[[nodiscard]] auto bordered(const image<T>& map, std::type_identity_t<T> border) {
    return bordered(map.view(), border);
}

namespace glsl {

inline constexpr snippet texel{
    .name = "texel",
    .summary = "texel inside a map",
    .exactness = tier::a,
    .role = hook::texel,
    .source = R"GLSL(
// umbrage_texel: value of a texel inside the map
//   map    2D sampler; before GLSL 1.30 its filter must be nearest
//   size   of the map in texels;   texel  whole numbers, (0, 0) is the first
#ifndef UMBRAGE_MAP
#define UMBRAGE_MAP UMBRAGE_HIGHP sampler2D
#endif
UMBRAGE_HIGHP vec4 umbrage_texel(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
#if __VERSION__ >= 130
    return texelFetch(map, ivec2(texel), 0);
#else
    return texture2D(map, (texel + 0.5) / size);
#endif
}
)GLSL",
};

inline constexpr snippet inside_map{
    .name = "inside_map",
    .summary = "whether a texel is one of the map's",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_inside_map: whether a texel is one of a map's of size texels
bool umbrage_inside_map(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    return texel.x >= 0.0 && texel.y >= 0.0 && texel.x < size.x && texel.y < size.y;
}
)GLSL",
};

inline constexpr snippet fetch_clamped{
    .name = "fetch_clamped",
    .summary = "texel of a map, outside the nearest one inside",
    .exactness = tier::a,
    .needs = list<&texel>,
    .source = R"GLSL(
// umbrage_fetch_clamped: texel of a map; coordinates outside move to the nearest texel inside
UMBRAGE_HIGHP vec4 umbrage_fetch_clamped(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    return umbrage_texel(map, size, clamp(texel, vec2(0.0, 0.0), size - 1.0));
}
)GLSL",
};

inline constexpr snippet fetch_bordered{
    .name = "fetch_bordered",
    .summary = "texel of a map, outside a border value",
    .exactness = tier::a,
    .needs = list<&fetch_clamped, &inside_map>,
    .source = R"GLSL(
// umbrage_fetch_bordered: texel of a map, or border outside of it
UMBRAGE_HIGHP vec4 umbrage_fetch_bordered(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                          UMBRAGE_HIGHP vec4 border) {
    UMBRAGE_HIGHP vec4 value = umbrage_fetch_clamped(map, size, texel);
    return umbrage_inside_map(size, texel) ? value : border;
}
)GLSL",
};

inline constexpr auto image_snippets = list<&texel, &inside_map, &fetch_clamped, &fetch_bordered>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/depth/rg.hpp
// Depth in two 8-bit channels, 9 to 16 bits: the layout of the Radeon 8500 shadow map sample and its family.
// x has Bits = 8 + M bits:  R = low byte,  G = high bits, moved to the top of their byte,  value = R / 2^M + G.
// Bits = 11 is the sample's own; Bits = 16 is plain two-byte depth.
//
//     glm::u8vec2 texel = umbrage::encode_rg<11>(depth);
//     float stored = umbrage::decode_rg<11>(texel, umbrage::upper_edge<float>);
//

namespace umbrage {

/// Depth to channels.
///
/// @param depth   clamped to [0, 1]; NaN counts as far: 1, or 0 where depth is reversed
/// @return        integer channels 0..255; to_unorm makes them what a shader writes
/// @formula       x = min(floor(depth 2^Bits), 2^Bits - 1);  R = x mod 256, G = floor(x / 256) 2^(16 - Bits)
/// @exactness     A
/// @cite          ATI Radeon SDK, ShadowMap sample, 2002: R = x & 0xFF, G = (x & 0xFF00) >> 3
template <int Bits, real T>
[[nodiscard]] constexpr glm::u8vec2 encode_rg(T depth, T far = T(1)) {
    static_assert(Bits >= 9 && Bits <= 16);
    const std::uint32_t x = to_code<Bits>(depth, far);
    return {static_cast<std::uint8_t>(x & 0xFF), static_cast<std::uint8_t>((x >> 8) << (16 - Bits))};
}

/// Values read from an 8-bit texture to depth.
///
/// @param c       as sampled, k / 255; any rounding of that quotient gives the same depth
/// @param edge    lower_edge, centre or upper_edge of the code's interval
/// @return        depth; channels that no encoder wrote give the formula's value all the same, below 3/2
/// @formula       (R + 2^(Bits - 8) G + edge) 2^-Bits, with R, G = floor(255 c + 1/2)
/// @exactness     A;  |depth - decoded| <= 2^-Bits at an edge, 2^-(Bits + 1) at the centre
template <int Bits, real T>
[[nodiscard]] T decode_rg(glm::vec<2, T> c, T edge) {
    static_assert(Bits >= 9 && Bits <= 16);
    const glm::vec<2, T> k = from_unorm(c);
    return from_code<Bits>(k.x + k.y * T(1 << (Bits - 8)), edge);
}

/// Bytes to depth.
template <int Bits, real T>
[[nodiscard]] constexpr T decode_rg(glm::u8vec2 texel, T edge) {
    static_assert(Bits >= 9 && Bits <= 16);
    return from_code<Bits>(T(texel.x + (texel.y << (Bits - 8))), edge);
}

namespace glsl {

template <int Bits>
inline constexpr detail::short_name encode_rg_name("encode_rg$b", {{'b', Bits}});
template <int Bits>
[[nodiscard]] std::string encode_rg_text() {
    return detail::filled(R"GLSL(
// umbrage_encode_rg$b: depth to the two channels of a $b-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg$b(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * $n.0), $l.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 256.0));
    return vec2(x - high * 256.0, high * $s.0);
}
)GLSL",
                          {{'b', Bits}, {'n', 1 << Bits}, {'l', (1 << Bits) - 1}, {'s', 1 << (16 - Bits)}});
}
template <int Bits>
inline constexpr snippet encode_rg{.name = encode_rg_name<Bits>.view(),
                                   .summary = "depth to two channels, R the low byte",
                                   .exactness = tier::a,
                                   .needs = list<&saturate>,
                                   .source = encode_rg_text<Bits>};

template <int Bits>
inline constexpr detail::short_name decode_rg_name("decode_rg$b", {{'b', Bits}});
template <int Bits>
[[nodiscard]] std::string decode_rg_text() {
    return detail::filled(R"GLSL(
// umbrage_decode_rg$b: two channels of a $b-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, centre, upper edge of the code's interval
UMBRAGE_HIGHP float umbrage_decode_rg$b(UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP float edge) {
    UMBRAGE_HIGHP vec2 k = umbrage_from_unorm(c);
    return (k.x + k.y * $g.0 + edge) * (1.0 / $n.0);
}
)GLSL",
                          {{'b', Bits}, {'n', 1 << Bits}, {'g', 1 << (Bits - 8)}});
}
template <int Bits>
inline constexpr snippet decode_rg{.name = decode_rg_name<Bits>.view(),
                                   .summary = "two channels, R the low byte, to depth",
                                   .exactness = tier::a,
                                   .needs = list<&from_unorm>,
                                   .source = decode_rg_text<Bits>};

}  // namespace glsl

/// The encoding as a value.
template <int Bits>
struct rg {
    using texel = glm::u8vec2;
    static constexpr glsl::detail::short_name name_text{"rg$b", {{'b', Bits}}};
    static constexpr std::string_view name = name_text.view();
    static constexpr std::string_view summary = "Two channels: R the low byte, G the rest in its high bits.";
    static constexpr const glsl::snippet* writer = &glsl::encode_rg<Bits>;
    static constexpr const glsl::snippet* reader = &glsl::decode_rg<Bits>;
    static constexpr written writes = written::bytes;
    static constexpr int bits = Bits;
    static constexpr std::uint32_t codes = std::uint32_t(1) << Bits;

    depth_direction direction = depth_direction::forward;
    float edge = detail::safe_edge(direction);  ///< that decoding answers

    [[nodiscard]] constexpr texel encode(float depth) const { return encode_rg<Bits>(depth, cleared_depth(direction)); }
    [[nodiscard]] constexpr float decode(texel t) const { return decode_rg<Bits>(t, edge); }
    [[nodiscard]] constexpr decoding_error error(unorm_store = {}) const { return edge_error(Bits, edge); }
    [[nodiscard]] constexpr texel cleared() const { return encode(cleared_depth(direction)); }
};

}  // namespace umbrage

// ---- umbrage/depth/rgb24.hpp
// Depth in three 8-bit channels, 24 bits, R most significant.
//
//     glm::u8vec3 texel = umbrage::encode_rgb24(depth);
//     float stored = umbrage::decode_rgb24(texel, umbrage::upper_edge<float>);
//

namespace umbrage {

/// Depth to channels.
///
/// @param depth   clamped to [0, 1]; NaN counts as far: 1, or 0 where depth is reversed
/// @return        integer channels 0..255, R most significant
/// @formula       the bytes of min(floor(depth 2^24), 2^24 - 1)
/// @exactness     A
template <real T>
[[nodiscard]] constexpr glm::u8vec3 encode_rgb24(T depth, T far = T(1)) {
    const std::uint32_t x = to_code<24>(depth, far);
    return {static_cast<std::uint8_t>(x >> 16), static_cast<std::uint8_t>(x >> 8 & 0xFF),
            static_cast<std::uint8_t>(x & 0xFF)};
}

/// Values read from an 8-bit texture to depth.
///
/// @param c       as sampled, k / 255; any rounding of that quotient gives the same depth
/// @param edge    lower_edge or upper_edge; the centre is exact in double only
/// @formula       (65536 R + 256 G + B + edge) 2^-24, with R, G, B = floor(255 c + 1/2)
/// @exactness     A;  |depth - decoded| <= 2^-24
template <real T>
[[nodiscard]] T decode_rgb24(glm::vec<3, T> c, T edge) {
    const glm::vec<3, T> k = from_unorm(c);
    return from_code<24>((k.x * T(256) + k.y) * T(256) + k.z, edge);
}

/// Bytes to depth.
template <real T>
[[nodiscard]] constexpr T decode_rgb24(glm::u8vec3 texel, T edge) {
    return from_code<24>(T((texel.x << 16) + (texel.y << 8) + texel.z), edge);
}

namespace glsl {

inline constexpr snippet encode_rgb24{
    .name = "encode_rgb24",
    .summary = "depth to three channels, R most significant",
    .exactness = tier::a,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_encode_rgb24: depth to three channels, R most significant, whole numbers 0..255 for umbrage_to_unorm
//   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec3 umbrage_encode_rgb24(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 65536.0));
    UMBRAGE_HIGHP float rest = x - high * 65536.0;
    UMBRAGE_HIGHP float middle = floor(rest * (1.0 / 256.0));
    return vec3(high, middle, rest - middle * 256.0);
}
)GLSL",
};

inline constexpr snippet decode_rgb24{
    .name = "decode_rgb24",
    .summary = "three channels, R most significant, to depth",
    .exactness = tier::a,
    .needs = list<&from_unorm>,
    .source = R"GLSL(
// umbrage_decode_rgb24: three channels, as sampled, to depth
//   edge   0.0 or 1.0: lower or upper edge of the code's interval
UMBRAGE_HIGHP float umbrage_decode_rgb24(UMBRAGE_HIGHP vec3 c, UMBRAGE_HIGHP float edge) {
    UMBRAGE_HIGHP vec3 k = umbrage_from_unorm(c);
    return ((k.x * 256.0 + k.y) * 256.0 + k.z + edge) * (1.0 / 16777216.0);
}
)GLSL",
};

}  // namespace glsl

/// The encoding as a value.
struct rgb24 {
    using texel = glm::u8vec3;
    static constexpr std::string_view name = "rgb24";
    static constexpr std::string_view summary = "Three channels, R most significant.";
    static constexpr const glsl::snippet* writer = &glsl::encode_rgb24;
    static constexpr const glsl::snippet* reader = &glsl::decode_rgb24;
    static constexpr written writes = written::bytes;
    static constexpr int bits = 24;
    static constexpr std::uint32_t codes = std::uint32_t(1) << 24;

    depth_direction direction = depth_direction::forward;
    float edge = detail::safe_edge(direction);  ///< that decoding answers; the centre rounds from code 2^23 on

    [[nodiscard]] constexpr texel encode(float depth) const { return encode_rgb24(depth, cleared_depth(direction)); }
    [[nodiscard]] constexpr float decode(texel t) const { return decode_rgb24(t, edge); }
    [[nodiscard]] constexpr decoding_error error(unorm_store = {}) const { return edge_error(bits, edge); }
    [[nodiscard]] constexpr texel cleared() const { return encode(cleared_depth(direction)); }
};

}  // namespace umbrage

// ---- umbrage/list.hpp
// A list of types whose values know their names: what tools, tables and tests walk.
//
//     using encodings = umbrage::list_of<depth32f, rg<9>>;
//     encodings::for_each([](auto encoding) { std::puts(encoding.name.data()); });
//

namespace umbrage {

/// std::tuple's cheap sister: it is never made, so that a file that does not walk it pays nothing.
template <class... Values>
struct list_of {
    static constexpr std::size_t size = sizeof...(Values);

    /// Calls use(value) with a value of each, or with each of its `values`, one after the other.
    template <class Use>
    static constexpr void for_each(Use&& use) {
        (each<Values>(use), ...);
    }

    /// Calls use(value) with the one of that name.
    /// @return   false where none is called so
    template <class Use>
    static constexpr bool with(std::string_view name, Use&& use) {
        bool found = false;
        for_each([&](const auto& value) {
            if (found || value.name != name) return;
            found = true;
            static_cast<void>(use(value));
        });
        return found;
    }

private:
    template <class Value, class Use>
    static constexpr void each(Use& use) {
        if constexpr (requires { Value::values; })
            for (const Value& value : Value::values) use(value);
        else use(Value{});
    }
};

}  // namespace umbrage

// ---- umbrage/depth/encodings.hpp
// Every encoding of the library, in one list: what tools, tables, proofs and examples walk.
//
//     umbrage::for_each_encoding([](auto encoding) { std::puts(encoding.name.data()); });
//     bool found = umbrage::with_encoding("rg11", [&](auto encoding) { umbrage::encode(depth, map, encoding); });
//

namespace umbrage {

using encodings =
    list_of<depth32f, rg<9>, rg<10>, rg<11>, rg<12>, rg<13>, rg<14>, rg<15>, rg<16>, rgb24, float_bits, threejs_rgba,
            threejs_rgb, threejs_rg, threejs_legacy, threejs_legacy_repaired, base255, base255_repaired>;

/// Calls use(encoding) for one after the other.
template <class Use>
constexpr void for_each_encoding(Use&& use) {
    encodings::for_each(use);
}

/// Calls use(encoding) with the one of that name.
/// @return   false where none is called so
template <class Use>
constexpr bool with_encoding(std::string_view name, Use&& use) {
    return encodings::with(name, use);
}

}  // namespace umbrage

// ---- umbrage/depth/foreign/ps14.hpp
// The Radeon 8500's own way to unpack 11 bits: r / 8 + g on the channels as sampled. Its values are x / 2040, not
// x / 2048, so the receiver it is compared with must be scaled by 256 / 255 too.
//
//     bool lit = umbrage::receiver_ps14(depth) <= umbrage::decode_ps14(sampled);
//

namespace umbrage {

/// @param c      the two channels of encode_rg<11> as sampled, k / 255
/// @return       x / 2040, in [0, 2047 / 2040]
/// @formula      r / 8 + g
/// @exactness    B: one rounded addition
/// @cite         ATI Radeon SDK, ShadowMap sample, 2002: mov_d8 and add in pixel shader 1.4
template <real T>
[[nodiscard]] constexpr T decode_ps14(glm::vec<2, T> c) {
    return c.x * T(0.125) + c.y;
}

/// A depth on the scale of decode_ps14, for less_equal_scaled.
/// @param depth   not clamped; beyond the far plane: -1, which every texel lights
/// @formula       depth > 1 ? -1 : depth * 256 / 255
/// @exactness     B: one product with the rounded quotient
template <real T>
[[nodiscard]] constexpr T receiver_ps14(T depth) {
    return less_equal::beyond_far(depth) ? T(-1) : depth * T(256.0 / 255.0);
}

namespace glsl {

inline constexpr snippet decode_ps14{
    .name = "decode_ps14",
    .summary = "r / 8 + g as the Radeon 8500 computed it",
    .exactness = tier::b,
    .scaled = true,
    .source = R"GLSL(
// umbrage_decode_ps14: the channels of an 11-bit code, as sampled, to x / 2040; compare with umbrage_receiver_ps14;
//   1.0 is not the far plane on this scale
UMBRAGE_HIGHP float umbrage_decode_ps14(UMBRAGE_HIGHP vec2 c) {
    return c.x * 0.125 + c.y;  // an exact product: fused or not, it rounds once
}
)GLSL",
};

inline constexpr snippet receiver_ps14{
    .name = "receiver_ps14",
    .summary = "receiver on the scale of decode_ps14",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_receiver_ps14: depth * 256 / 255, the scale of umbrage_decode_ps14; beyond the far plane what every texel
//   lights
UMBRAGE_HIGHP float umbrage_receiver_ps14(UMBRAGE_HIGHP float depth) {
    return depth > 1.0 ? -1.0 : depth * 1.00392163;
}
)GLSL",
};

inline constexpr auto ps14_snippets = list<&decode_ps14, &receiver_ps14>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/depth/kinds.hpp
// Kinds of depth, and the way from one to another.
//   z/w               what the rasterizer interpolates: project_depth
//   linear depth      view-space distance along the light's axis over z_far: linear_depth
//   radial distance   from the light to the point over its range: distance_depth
//   reversed          1 - depth; what comes from it directly keeps the digits that 1 - depth drops
//
//     float d = umbrage::linear_depth(-view_position.z, 1.0f / z_far);
//

namespace umbrage {

/// @param z_view      distance along the light's axis, positive in front of it
/// @param inv_z_far   1 / z_far
/// @return            0 at the light, 1 at the far plane; not clamped
/// @formula           z_view * inv_z_far
/// @exactness         B: one product
template <real T>
[[nodiscard]] constexpr T linear_depth(T z_view, T inv_z_far) {
    return z_view * inv_z_far;
}

/// @param z, w    clip coordinates
/// @param cleared cleared_depth of the clip space: 1, or 0 when reversed
/// @return        z / w; cleared, which is far, for w <= 0 (not in front of the light) and NaN in w
/// @exactness     C: one division, of which GLSL allows 2.5 ulp; 0 seen
template <real T>
[[nodiscard]] constexpr T project_depth(T z, T w, T cleared) {
    return w > T(0) && !is_nan(w) ? z / w : cleared;
}

/// @param to_point    from the light to the point
/// @param inv_range   1 / range of the light
/// @return            0 at the light, 1 at its range; not clamped
/// @formula           |to_point| * inv_range
/// @exactness         C: a square root, of which GLSL allows a few ulp; 0 seen
template <real T>
[[nodiscard]] T distance_depth(glm::vec<3, T> to_point, T inv_range) {
    return std::sqrt(to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z) * inv_range;
}

/// Forward depth from reversed, or reversed from forward.
/// @formula       1 - depth
/// @exactness     B: one subtraction, exact for depth in [1/2, 2] and for multiples of 2^-24 in [0, 1]
template <real T>
[[nodiscard]] constexpr T reverse_depth(T depth) {
    return T(1) - depth;
}

/// Depth in [0, 1] from z/w in [-1, 1], the OpenGL convention.
/// @formula       ndc / 2 + 1/2
/// @exactness     B: one sum
template <real T>
[[nodiscard]] constexpr T depth_from_ndc(T ndc) {
    return ndc * T(0.5) + T(0.5);
}

/// Perspective depth to distance along the light's axis.
///
/// @param depth           z/w in [0, 1], 0 at the near plane
/// @param z_near, z_far   0 < z_near < z_far; z_far may be infinite
/// @return                z_near .. z_far; not clamped
/// @formula               n / (1 - depth (1 - n / f))
/// @exactness             C: two divisions, of each of which GLSL allows 2.5 ulp; 0 seen;
///                        the distance at depth near 1 hangs on the last bits of depth
template <real T>
[[nodiscard]] constexpr T view_z_from_depth(T depth, T z_near, T z_far) {
    return z_near / (T(1) - depth * (T(1) - z_near / z_far));
}

/// Distance along the light's axis to perspective depth.
///
/// @param z_view          > 0
/// @param z_near, z_far   0 < z_near < z_far; z_far may be infinite
/// @return                z/w in [0, 1], 0 at the near plane; not clamped
/// @formula               (1 - n / z) / (1 - n / f)
/// @exactness             C: three divisions, of each of which GLSL allows 2.5 ulp; 0 seen
template <real T>
[[nodiscard]] constexpr T depth_from_view_z(T z_view, T z_near, T z_far) {
    return (T(1) - z_near / z_view) / (T(1) - z_near / z_far);
}

/// Reversed perspective depth to distance along the light's axis.
///
/// @param depth           z/w in [0, 1], 1 at the near plane
/// @param z_near, z_far   0 < z_near < z_far; z_far may be infinite
/// @return                z_near .. z_far; not clamped
/// @formula               n / (n / f + depth (1 - n / f)): within 3 ulp of the distance for depth in [0, 1], as nothing
///                        cancels; by way of 1 - depth thousands of ulp are lost far out
/// @exactness             C: two divisions, of each of which GLSL allows 2.5 ulp; 0 seen
template <real T>
[[nodiscard]] constexpr T view_z_from_reversed_depth(T depth, T z_near, T z_far) {
    return z_near / (z_near / z_far + depth * (T(1) - z_near / z_far));
}

/// Distance along the light's axis to reversed perspective depth.
///
/// @param z_view          > 0, finite
/// @param z_near, z_far   0 < z_near < z_far; z_far may be infinite
/// @return                z/w in [0, 1], 1 at the near plane; not clamped
/// @formula               n / z (1 - z / f) / (1 - n / f)
/// @exactness             C: four divisions, of each of which GLSL allows 2.5 ulp; 0 seen
template <real T>
[[nodiscard]] constexpr T reversed_depth_from_view_z(T z_view, T z_near, T z_far) {
    return z_near / z_view * (T(1) - z_view / z_far) / (T(1) - z_near / z_far);
}

/// Orthographic depth, a directional light's, to distance along the light's axis.
///
/// @param depth           z/w in [0, 1], 0 at the near plane
/// @param z_near, z_far   z_near < z_far; when reversed, exchange the two: digits are kept, without 1 - depth
/// @return                z_near .. z_far; not clamped
/// @formula               n + depth (f - n)
/// @exactness             B: sums and a product
template <real T>
[[nodiscard]] constexpr T view_z_from_orthographic_depth(T depth, T z_near, T z_far) {
    return z_near + depth * (z_far - z_near);
}

/// Distance along the light's axis to orthographic depth, a directional light's.
///
/// @param z_near, z_far   z_near < z_far; when reversed, exchange the two
/// @return                z/w in [0, 1], 0 at the near plane; not clamped
/// @formula               (z - n) / (f - n)
/// @exactness             C: one division, of which GLSL allows 2.5 ulp; 0 seen
template <real T>
[[nodiscard]] constexpr T orthographic_depth_from_view_z(T z_view, T z_near, T z_far) {
    return (z_view - z_near) / (z_far - z_near);
}

namespace glsl {

inline constexpr snippet linear_depth{
    .name = "linear_depth",
    .summary = "view-space z over z_far",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_linear_depth: distance along the light's axis, positive in front of it, times 1 / z_far
UMBRAGE_HIGHP float umbrage_linear_depth(UMBRAGE_HIGHP float z_view, UMBRAGE_HIGHP float inv_z_far) {
    return z_view * inv_z_far;
}
)GLSL",
};

inline constexpr snippet project_depth{
    .name = "project_depth",
    .summary = "z / w, far behind the light",
    .exactness = tier::c,
    .ulp = 1,
    .source = R"GLSL(
// umbrage_project_depth: z / w; for w <= 0.0 cleared, which is 1.0, or 0.0 when reversed
UMBRAGE_HIGHP float umbrage_project_depth(UMBRAGE_HIGHP float z, UMBRAGE_HIGHP float w, UMBRAGE_HIGHP float cleared) {
    return w > 0.0 ? z / w : cleared;
}
)GLSL",
};

inline constexpr snippet distance_depth{
    .name = "distance_depth",
    .summary = "distance to the light over its range",
    .exactness = tier::c,
    .ulp = 1,
    .source = R"GLSL(
// umbrage_distance_depth: length of to_point, from the light, times 1 / range
UMBRAGE_HIGHP float umbrage_distance_depth(UMBRAGE_HIGHP vec3 to_point, UMBRAGE_HIGHP float inv_range) {
    return sqrt(to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z) * inv_range;
}
)GLSL",
};

inline constexpr snippet reverse_depth{
    .name = "reverse_depth",
    .summary = "1 - depth",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_reverse_depth: forward depth from reversed, or reversed from forward
UMBRAGE_HIGHP float umbrage_reverse_depth(UMBRAGE_HIGHP float depth) {
    return 1.0 - depth;
}
)GLSL",
};

inline constexpr snippet depth_from_ndc{
    .name = "depth_from_ndc",
    .summary = "z/w in [-1, 1] to depth in [0, 1]",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_depth_from_ndc: depth in [0, 1] from z/w in [-1, 1]
UMBRAGE_HIGHP float umbrage_depth_from_ndc(UMBRAGE_HIGHP float ndc) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = ndc * 0.5 + 0.5;
    return depth;
}
)GLSL",
};

inline constexpr snippet view_z_from_depth{
    .name = "view_z_from_depth",
    .summary = "perspective depth to view-space z",
    .exactness = tier::c,
    .ulp = 1,
    .source = R"GLSL(
// umbrage_view_z_from_depth: perspective depth in [0, 1], 0.0 at z_near, to distance along the light's axis
UMBRAGE_HIGHP float umbrage_view_z_from_depth(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float z_near,
                                              UMBRAGE_HIGHP float z_far) {
    return z_near / (1.0 - depth * (1.0 - z_near / z_far));
}
)GLSL",
};

inline constexpr snippet depth_from_view_z{
    .name = "depth_from_view_z",
    .summary = "view-space z to perspective depth",
    .exactness = tier::c,
    .ulp = 1,
    .source = R"GLSL(
// umbrage_depth_from_view_z: distance along the light's axis to perspective depth in [0, 1], 0.0 at z_near
UMBRAGE_HIGHP float umbrage_depth_from_view_z(UMBRAGE_HIGHP float z_view, UMBRAGE_HIGHP float z_near,
                                              UMBRAGE_HIGHP float z_far) {
    return (1.0 - z_near / z_view) / (1.0 - z_near / z_far);
}
)GLSL",
};

inline constexpr snippet view_z_from_reversed_depth{
    .name = "view_z_from_reversed_depth",
    .summary = "reversed perspective depth to view-space z",
    .exactness = tier::c,
    .ulp = 1,
    .source = R"GLSL(
// umbrage_view_z_from_reversed_depth: perspective depth in [0, 1], 1.0 at z_near, to distance along the light's axis
UMBRAGE_HIGHP float umbrage_view_z_from_reversed_depth(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float z_near,
                                                       UMBRAGE_HIGHP float z_far) {
    return z_near / (z_near / z_far + depth * (1.0 - z_near / z_far));
}
)GLSL",
};

inline constexpr snippet reversed_depth_from_view_z{
    .name = "reversed_depth_from_view_z",
    .summary = "view-space z to reversed perspective depth",
    .exactness = tier::c,
    .ulp = 1,
    .source = R"GLSL(
// umbrage_reversed_depth_from_view_z: distance along the light's axis to perspective depth in [0, 1], 1.0 at z_near
UMBRAGE_HIGHP float umbrage_reversed_depth_from_view_z(UMBRAGE_HIGHP float z_view, UMBRAGE_HIGHP float z_near,
                                                       UMBRAGE_HIGHP float z_far) {
    return z_near / z_view * (1.0 - z_view / z_far) / (1.0 - z_near / z_far);
}
)GLSL",
};

inline constexpr snippet view_z_from_orthographic_depth{
    .name = "view_z_from_orthographic_depth",
    .summary = "orthographic depth to view-space z",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_view_z_from_orthographic_depth: orthographic depth in [0, 1], 0.0 at z_near, to distance along the light's
// axis; when reversed, exchange z_near and z_far
UMBRAGE_HIGHP float umbrage_view_z_from_orthographic_depth(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float z_near,
                                                           UMBRAGE_HIGHP float z_far) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z_view = z_near + depth * (z_far - z_near);
    return z_view;
}
)GLSL",
};

inline constexpr snippet orthographic_depth_from_view_z{
    .name = "orthographic_depth_from_view_z",
    .summary = "view-space z to orthographic depth",
    .exactness = tier::c,
    .ulp = 1,
    .source = R"GLSL(
// umbrage_orthographic_depth_from_view_z: distance along the light's axis to orthographic depth in [0, 1], 0.0 at
// z_near; when reversed, exchange z_near and z_far
UMBRAGE_HIGHP float umbrage_orthographic_depth_from_view_z(UMBRAGE_HIGHP float z_view, UMBRAGE_HIGHP float z_near,
                                                           UMBRAGE_HIGHP float z_far) {
    return (z_view - z_near) / (z_far - z_near);
}
)GLSL",
};

inline constexpr auto kinds_snippets =
    list<&linear_depth, &project_depth, &distance_depth, &reverse_depth, &depth_from_ndc, &view_z_from_depth,
         &depth_from_view_z, &view_z_from_reversed_depth, &reversed_depth_from_view_z, &view_z_from_orthographic_depth,
         &orthographic_depth_from_view_z>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/depth/rg_level.hpp
// The shadow test on maps of encode_rg without decoding them: one multiply-add a texel. The receiver is brought to the
// scale of the channels' sum once, halfway between two codes, so that no rounding of a texel's read can tip the test.
//
//     bool lit = umbrage::receiver_rg<11>(depth, umbrage::upper_edge<float>) <= umbrage::level_rg<11>(sampled);
//
// In a filter: #define UMBRAGE_FETCH(map, size, texel) umbrage_level_rg11(umbrage_fetch_clamped(map, size, texel).xy)
// and umbrage_receiver_rg11(depth, 1.0) for the receiver; the filter's visibility is that of decode_rg, to the bit.

namespace umbrage {

/// @param c       the two channels of encode_rg<Bits> as sampled, k / 255
/// @return        x / 255, x the code; with Bits = 11, eight times decode_ps14
/// @formula       r + 2^(Bits - 8) g
/// @exactness     B: one rounded addition, of an exact product
template <int Bits, real T>
[[nodiscard]] constexpr T level_rg(glm::vec<2, T> c) {
    static_assert(Bits >= 9 && Bits <= 16);
    return c.x + c.y * T(1 << (Bits - 8));
}

/// @param depth   of the receiver, biased; beyond the far plane: -1, which every texel lights; NaN is in shadow, for no
///                comparison with it holds
/// @param edge    the one decode_rg would be given
/// @return        receiver_rg(depth, edge) <= level_rg(c) exactly when depth <= decode_rg(c, edge), for texels c within
///                2^-18 of k / 255. For less_equal_scaled only, not for reversed Z.
/// @formula       depth > 1 ? -1 : (ceil(depth 2^Bits - edge) - 1/2) / 255
/// @exactness     B: products and sums round once each; the test that it is made for is exact
template <int Bits, real T>
[[nodiscard]] T receiver_rg(T depth, T edge) {
    static_assert(Bits >= 9 && Bits <= 16);
    if (less_equal::beyond_far(depth)) return T(-1);
    return (std::ceil(depth * T(1 << Bits) - edge) - T(0.5)) * T(1.0 / 255.0);
}

namespace glsl {

template <int Bits>
inline constexpr detail::short_name level_rg_name("level_rg$b", {{'b', Bits}});
template <int Bits>
[[nodiscard]] std::string level_rg_text() {
    return detail::filled(R"GLSL(
// umbrage_level_rg$b: two channels of a $b-bit code, as sampled, to the scale of umbrage_receiver_rg$b, on which 1.0 is
//   not the far plane
UMBRAGE_HIGHP float umbrage_level_rg$b(UMBRAGE_HIGHP vec2 c) {
    return c.x + c.y * $g.0;  // an exact product: fused or not, it rounds once
}
)GLSL",
                          {{'b', Bits}, {'g', 1 << (Bits - 8)}});
}
template <int Bits>
inline constexpr snippet level_rg{.name = level_rg_name<Bits>.view(),
                                  .summary = "two channels to a level to compare with",
                                  .exactness = tier::b,
                                  .scaled = true,
                                  .source = level_rg_text<Bits>};

template <int Bits>
inline constexpr detail::short_name receiver_rg_name("receiver_rg$b", {{'b', Bits}});
template <int Bits>
[[nodiscard]] std::string receiver_rg_text() {
    return detail::filled(R"GLSL(
// umbrage_receiver_rg$b: receiver on the scale of umbrage_level_rg$b: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg$b(texel, edge), or beyond the far plane
UMBRAGE_HIGHP float umbrage_receiver_rg$b(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float edge) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float level = (ceil(depth * $n.0 - edge) - 0.5) * 0.00392156886;
    return depth > 1.0 ? -1.0 : level;
}
)GLSL",
                          {{'b', Bits}, {'n', 1 << Bits}});
}
template <int Bits>
inline constexpr snippet receiver_rg{.name = receiver_rg_name<Bits>.view(),
                                     .summary = "receiver to a level, for maps that are not decoded",
                                     .exactness = tier::b,
                                     .source = receiver_rg_text<Bits>};

/// Of the members named: texts are filled in where they are asked for.
template <int... Bits>
inline constexpr auto rg_level_snippets = list<&level_rg<Bits>..., &receiver_rg<Bits>...>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/depth/rg_table.hpp
// encode_rg through a look-up table, as hardware without enough arithmetic did it: a texture fetched with the depth as
// coordinate. Up to 11 bits it is one row of 2^Bits texels; from 12 bits on, rows of 2048, the widest texture of 2002.
//
//     constexpr auto table = umbrage::make_rg_table<11, glm::u8vec4>();  // 2048 x 1 RGBA8, B = A = 0
//     glm::u8vec2 texel = umbrage::encode_rg_table<11>([&](int x) { return table[x]; }, depth);
//

namespace umbrage {

/// The table's texels, in the order of rg_table_size's rows. Compile-time up to 12 bits with every compiler's default
/// limits.
/// @tparam Texel   glm::u8vec2 (RG8) or glm::u8vec4 (RGBA8; blue and alpha are 0)
/// @cite           the article on self-shadowing with pixel shader 1.x gives texel 256 as (255, 32, 0, 0);
///                 by its own formula, and here, it is (0, 32, 0, 0)
template <int Bits, class Texel = glm::u8vec2>
[[nodiscard]] constexpr std::array<Texel, std::size_t(1) << Bits> make_rg_table() {
    static_assert(Bits >= 9 && Bits <= 16);
    std::array<Texel, std::size_t(1) << Bits> table{};
    for (std::uint32_t x = 0; x < table.size(); ++x) {
        table[x][0] = static_cast<std::uint8_t>(x & 0xFF);
        table[x][1] = static_cast<std::uint8_t>((x >> 8) << (16 - Bits));
    }
    return table;
}

/// Width and height of the table as a texture.
template <int Bits>
inline constexpr int rg_table_width = Bits <= 11 ? 1 << Bits : 2048;
template <int Bits>
inline const glm::ivec2 rg_table_size{rg_table_width<Bits>, (1 << Bits) / rg_table_width<Bits>};

/// Depth to channels by one nearest fetch from the table: the texel encode_rg<Bits> computes.
///
/// @param fetch   int 0 .. 2^Bits - 1 -> texel of the table
/// @param depth   clamped to [0, 1]; NaN counts as far: 1, or 0 where depth is reversed
/// @exactness     A
template <int Bits, real T, class Fetch>
[[nodiscard]] constexpr glm::u8vec2 encode_rg_table(Fetch&& fetch, T depth, T far = T(1)) {
    const auto texel = fetch(static_cast<int>(to_code<Bits>(depth, far)));
    return {texel[0], texel[1]};
}

namespace glsl {

template <int Bits>
inline constexpr detail::short_name encode_rg_table_name("encode_rg$b_table", {{'b', Bits}});
template <int Bits>
[[nodiscard]] std::string encode_rg_table_text() {
    return detail::filled(R"GLSL(
// umbrage_encode_rg$b_table: depth to the two channels of a $b-bit code through a look-up table, whole numbers 0..255
//   table   $w x $h texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_rg$b_table(UMBRAGE_MAP table, UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * $n.0), $l.0);
    UMBRAGE_HIGHP float row = floor(x * (1.0 / $w.0));
    UMBRAGE_HIGHP vec2 texel = vec2(x - row * $w.0, row);
    UMBRAGE_HIGHP vec4 k = umbrage_from_unorm(umbrage_fetch_clamped(table, vec2($w.0, $h.0), texel));
    return vec2(k.x, k.y);
}
)GLSL",
                          {{'b', Bits},
                           {'n', 1 << Bits},
                           {'l', (1 << Bits) - 1},
                           {'w', rg_table_width<Bits>},
                           {'h', (1 << Bits) / rg_table_width<Bits>}});
}
template <int Bits>
inline constexpr snippet encode_rg_table{.name = encode_rg_table_name<Bits>.view(),
                                         .summary = "depth to two channels through a look-up texture",
                                         .exactness = tier::a,
                                         .needs = list<&saturate, &from_unorm, &fetch_clamped>,
                                         .source = encode_rg_table_text<Bits>};

/// Of the members named: texts are filled in where they are asked for.
template <int... Bits>
inline constexpr auto rg_table_snippets = list<&encode_rg_table<Bits>...>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/texel_space.hpp
// What every filter over a map shares: the range of its coordinates, and the comparison with a texel.
//
//     if (!umbrage::inside_texel_space(coord)) return 1;  // NaN, infinite or absurd: lit
//

namespace umbrage {

/// True when |coord| < 2^15 in both directions, so that texel numbers and 1/256 of them stay exact.
/// Filters take everything else, NaN included, as lit.
/// @exactness     A
template <real T>
[[nodiscard]] constexpr bool inside_texel_space(glm::vec<2, T> coord) {
    const auto inside = [](T v) { return !is_nan(v) && v < T(32768) && v > T(-32768); };
    return inside(coord.x) && inside(coord.y);
}

/// Whether a filter compares a receiver at all. Two kinds are lit without: coordinates outside texel space, and depths
/// beyond the far plane.
/// @param is_lit   the comparison; one without beyond_far has no far plane
/// @exactness      A
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr bool is_compared(glm::vec<2, T> coord, T receiver, const Compare& is_lit = {}) {
    return inside_texel_space(coord) && !beyond_far(receiver, is_lit);
}

/// Stored depth of a texel: the fetch callable of every filter, by name.
/// @param fetch   ivec2 texel -> depth, e.g. clamped(map), or decoded(map, rg<11>{}) for packed maps
template <class Fetch>
[[nodiscard]] constexpr auto fetch_depth(Fetch&& fetch, glm::ivec2 texel) {
    return fetch(texel);
}

/// Stored depth of the texel at a point of the map.
/// @param fetch   ivec2 texel -> stored depth
/// @param size    of the map, in texels
/// @param uv      from (0, 0) to (1, 1) over the map, no NaN
/// @exactness     C, the fetched depth, but at borders between texels: a sampler takes the nearest to what it rounds
///                its coordinates to, 2^-10 texel off in a map of 8192
template <real T, class Fetch>
[[nodiscard]] T depth_at(Fetch&& fetch, glm::vec<2, T> size, glm::vec<2, T> uv) {
    return T(fetch(glm::ivec2(glm::floor(uv * size))));
}

/// Visibility of one comparison with a texel.
/// @param fetch   ivec2 texel -> stored depth
/// @return        1 when lit, 0 in shadow
/// @exactness     A
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] constexpr T lit(Fetch&& fetch, glm::ivec2 texel, T receiver, Compare is_lit = {}) {
    return compare(receiver, T(fetch(texel)), is_lit);
}

/// Visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1): what one gather gives.
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] constexpr glm::vec<4, T> lit_2x2(Fetch&& fetch, glm::ivec2 texel, T receiver, Compare is_lit = {}) {
    const T a = lit(fetch, texel, receiver, is_lit), b = lit(fetch, texel + glm::ivec2(1, 0), receiver, is_lit);
    const T c = lit(fetch, texel + glm::ivec2(0, 1), receiver, is_lit);
    return {a, b, c, lit(fetch, texel + glm::ivec2(1, 1), receiver, is_lit)};
}

/// A packed map as the fetch callable that filters take.
/// @param fetch      ivec2 -> texel, e.g. bordered(map, encoding.cleared()); a map stands for clamped(map)
/// @param encoding   one of encodings.hpp
/// @throws std::invalid_argument  empty map
template <std::invocable<glm::ivec2> Fetch, class Encoding>
[[nodiscard]] auto decoded(Fetch fetch, Encoding encoding) {
    return [fetch, encoding](glm::ivec2 texel) { return encoding.decode(fetch(texel)); };
}
template <class Texel, class Encoding>
[[nodiscard]] auto decoded(image_view<Texel> map, Encoding encoding) {
    return decoded(clamped(map), encoding);
}
template <class Texel, class Encoding>
[[nodiscard]] auto decoded(const image<Texel>& map, Encoding encoding) {
    return decoded(map.view(), encoding);
}

namespace glsl {

inline constexpr snippet inside_texel_space{
    .name = "inside_texel_space",
    .summary = "coordinates a filter can take",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_inside_texel_space: coordinates in texels that a filter can take; it takes all others, NaN included, as lit
bool umbrage_inside_texel_space(UMBRAGE_HIGHP vec2 coord) {
    // two limits on purpose: Mesa makes max(x, y) < limit of one, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) * 2.0 < 65536.0;
}
)GLSL",
};

inline constexpr snippet is_compared{
    .name = "is_compared",
    .summary = "receivers that a filter compares; it takes the others as lit",
    .exactness = tier::a,
    .needs = list<&inside_texel_space, &beyond_far>,
    .source = R"GLSL(
// umbrage_is_compared: whether a filter compares a receiver; outside texel space and beyond the far plane all is lit
bool umbrage_is_compared(UMBRAGE_HIGHP vec2 coord, UMBRAGE_HIGHP float receiver) {
    // a choice, not a && !b: of !(receiver > 1.0) FXC makes receiver <= 1.0, which loses a NaN
    return umbrage_beyond_far(receiver) ? false : umbrage_inside_texel_space(coord);
}
)GLSL",
};

/// UMBRAGE_FETCH, the depth behind a texel: define it beforehand for packed maps. UMBRAGE_OUTSIDE_LIT, defined
/// beforehand, makes it bordered(map, cleared_depth(clip)) instead of clamped(map).
inline constexpr snippet fetch_depth{
    .name = "fetch_depth",
    .summary = "stored depth of a texel",
    .exactness = tier::a,
    .needs = list<&fetch_clamped, &fetch_bordered, &cleared_depth>,
    .role = hook::fetch_depth,
    .source = R"GLSL(
// UMBRAGE_FETCH: stored depth of a texel; define it beforehand for packed maps
// UMBRAGE_OUTSIDE_LIT: define it and all outside the map is lit, where it is else as the nearest texel inside
#ifndef UMBRAGE_FETCH
#ifndef UMBRAGE_OUTSIDE_LIT
#define UMBRAGE_FETCH(map, size, texel) umbrage_fetch_clamped(map, size, texel).x
#else
#define UMBRAGE_FETCH(map, size, texel) umbrage_fetch_bordered(map, size, texel, vec4(umbrage_cleared_depth())).x
#endif
#endif
// umbrage_fetch_depth: stored depth of a texel
UMBRAGE_HIGHP float umbrage_fetch_depth(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    return UMBRAGE_FETCH(map, size, texel);
}
)GLSL",
};

inline constexpr snippet lit{
    .name = "lit",
    .summary = "one comparison with a texel",
    .exactness = tier::a,
    .needs = list<&compare, &fetch_depth>,
    .role = hook::lit,
    .source = R"GLSL(
// umbrage_lit: visibility of one comparison with a texel
UMBRAGE_HIGHP float umbrage_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                UMBRAGE_HIGHP float receiver) {
    return umbrage_compare(receiver, umbrage_fetch_depth(map, size, texel));
}
)GLSL",
};

inline constexpr snippet lit_2x2{
    .name = "lit_2x2",
    .summary = "comparisons with the 2x2 texels from one on",
    .exactness = tier::a,
    .needs = list<&lit>,
    .role = hook::lit_2x2,
    .source = R"GLSL(
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
UMBRAGE_HIGHP vec4 umbrage_lit_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float a = umbrage_lit(map, size, texel, receiver);
    UMBRAGE_HIGHP float b = umbrage_lit(map, size, texel + vec2(1.0, 0.0), receiver);
    UMBRAGE_HIGHP float c = umbrage_lit(map, size, texel + vec2(0.0, 1.0), receiver);
    UMBRAGE_HIGHP float d = umbrage_lit(map, size, texel + vec2(1.0, 1.0), receiver);
    return vec4(a, b, c, d);
}
)GLSL",
};

/// Of a map with a sampler, which is all of its texture, the sample as it is; of others fetch_depth.
inline constexpr snippet depth_at{
    .name = "depth_at",
    .summary = "stored depth at a point of the map",
    .exactness = tier::c,
    .ulp = 1,
    .needs = list<&fetch_depth>,
    .role = hook::depth_at,
    .source = R"GLSL(
// umbrage_depth_at: stored depth of the texel at a point; on a border it may be the texel beside
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
UMBRAGE_HIGHP float umbrage_depth_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv) {
    return umbrage_fetch_depth(map, size, floor(uv * size));
}
)GLSL",
};

inline constexpr auto texel_space_snippets =
    list<&fetch_depth, &depth_at, &inside_texel_space, &is_compared, &lit, &lit_2x2>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/pcf/disc.hpp
// Percentage-closer filtering over a disc: 8, 16 or 32 points, turned from pixel to pixel so that no pattern shows.
//
//     float visibility =
//         umbrage::disc<16>(umbrage::clamped(map), coord, depth - bias, 3.0f, umbrage::disc_turn(pixel));
//
// Points, turns and radii are whole numbers, so that taps fall on the same texels everywhere. The points were annealed
// for the least error on edges of any direction, alone and over four quarter turns.

namespace umbrage {

inline constexpr float max_disc_radius = 4095.0f / 16.0f;

struct disc_point {
    int x, y;
    [[nodiscard]] operator glm::ivec2() const { return {x, y}; }
};

/// A disc's points, in 1/16 of its radius.
template <int Points>
inline constexpr std::array<disc_point, Points> disc_points = [] {
    static_assert(Points == 8 || Points == 16 || Points == 32);
    if constexpr (Points == 8)
        return std::array<disc_point, 8>{{{3, -1}, {-4, 5}, {1, -11}, {-9, -8}, {-12, 3}, {11, 6}, {0, 13}, {11, -7}}};
    else if constexpr (Points == 16)
        return std::array<disc_point, 16>{{{1, -3},
                                           {5, 2},
                                           {-5, 2},
                                           {0, 7},
                                           {-6, -5},
                                           {8, -5},
                                           {0, -11},
                                           {11, 5},
                                           {-12, 4},
                                           {-1, 13},
                                           {7, 11},
                                           {-9, 10},
                                           {-13, -4},
                                           {7, -12},
                                           {-7, -12},
                                           {14, -2}}};
    else
        return std::array<disc_point, 32>{{{-2, -1},  {3, 2},   {1, -4},   {-4, 3},  {0, 6},   {-5, -5},  {7, -2},
                                           {-8, -1},  {8, 3},   {5, 7},    {1, -9},  {6, -7},  {-8, 5},   {0, 10},
                                           {-3, -10}, {-6, 10}, {-9, -8},  {11, -5}, {5, -12}, {-13, -1}, {7, 11},
                                           {13, 3},   {-13, 4}, {10, -10}, {14, -2}, {-11, 9}, {3, 14},   {-13, -6},
                                           {12, 8},   {-4, 14}, {-7, -13}, {0, -15}}};
}();

/// One of 16 turns for a pixel, each once in every 4 x 4 of them.
/// @param pixel      whole numbers or positions in pixels; of 2^15 and more, and NaN, all have the first
/// @return           (cos, sin) in 1/64, whole numbers, of length 63.6 to 64
/// @formula          v = 4x + y mod 16: a quarter turn floor(v / 4) times, after v mod 4 times 22.5 degrees
/// @exactness        A
template <real T>
[[nodiscard]] glm::vec<2, T> disc_turn(glm::vec<2, T> pixel) {
    if (!inside_texel_space(pixel)) return {T(64), T(0)};
    const glm::vec<2, T> whole = glm::floor(pixel);
    const T sum = whole.x * T(4) + whole.y;
    const auto v = static_cast<int>(sum - glm::floor(sum * T(1.0 / 16.0)) * T(16));
    constexpr int base[4][2]{{64, 0}, {59, 24}, {45, 45}, {24, 59}};
    const T c = T(base[v % 4][0]), s = T(base[v % 4][1]);
    switch (v / 4) {
        case 0: return {c, s};
        case 1: return {T(0) - s, c};
        case 2: return {T(0) - c, T(0) - s};
        default: return {s, T(0) - c};
    }
}

/// The texel that a point of a disc falls on.
/// @param position   floor(256 coord) of the receiver
/// @param p          one of disc_points;   turn  as disc_turn gives it
/// @param radius     in 1/16 texel, a whole number, 0 .. 4095
/// @formula          floor((position + turned point * radius / 64) / 256), of point (x, y) turned by (c, s):
///                   (c x - s y, s x + c y)
/// @exactness        A: the position's whole texels apart, all else are multiples of 2^-14 below 2^9, in any order
template <real T>
[[nodiscard]] glm::vec<2, T> disc_tap(glm::vec<2, T> position, glm::vec<2, T> p, glm::vec<2, T> turn, T radius) {
    const glm::vec<2, T> at = position * T(1.0 / 256.0), texel = glm::floor(at), within = at - texel;
    const glm::vec<2, T> scaled = turn * (radius * T(1.0 / 16384.0));
    return texel +
           glm::floor(within + glm::vec<2, T>(scaled.x * p.x - scaled.y * p.y, scaled.y * p.x + scaled.x * p.y));
}

/// A disc's radius in 1/16 texel: floor(16 radius), at most 4095; 0 for what is negative, and for NaN.
/// @exactness        A
template <real T>
[[nodiscard]] constexpr T disc_radius(T radius) {
    if (is_nan(radius) || !(radius > T(0))) return T(0);
    return radius < T(255.9375) ? T(static_cast<int>(radius * T(16))) : T(4095);
}

/// Lit share of a disc's points.
/// @tparam Points    8, 16 or 32
/// @param fetch      ivec2 texel -> stored depth; called Points times, texels may lie a radius outside the map
/// @param coord      receiver in texels, the first texel's centre is (0.5, 0.5); outside texel space, or NaN: lit
/// @param receiver   depth, biased; beyond the far plane: lit; NaN is in shadow
/// @param radius     in texels, taken down to 1/16; clamped to 0 .. 255.9375, NaN is 0
/// @param turn       as disc_turn gives it
/// @return           visibility, a multiple of 1 / Points: 0 in shadow, 1 lit
/// @formula          mean of [receiver <= fetch(disc_tap)] over disc_points
/// @exactness        A
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T disc(Fetch&& fetch, glm::vec<2, T> coord, T receiver, T radius, glm::vec<2, T> turn,
                     Compare is_lit = {}) {
    if (!is_compared(coord, receiver, is_lit)) return T(1);
    const glm::vec<2, T> position = glm::floor(coord * T(256));
    const T rho = disc_radius(radius);
    int lit = 0;
    for (const glm::ivec2 point : disc_points<Points>) {
        const glm::ivec2 texel(disc_tap(position, glm::vec<2, T>(point), turn, rho));
        lit += is_lit(receiver, T(fetch(texel))) ? 1 : 0;
    }
    return static_cast<T>(lit) * T(1.0 / Points);
}

namespace glsl {

inline constexpr snippet disc_turn{
    .name = "disc_turn",
    .summary = "one of 16 turns for a pixel",
    .exactness = tier::a,
    .needs = list<&inside_texel_space>,
    .source = R"GLSL(
// umbrage_disc_turn: (cos, sin) in 1/64 of one of 16 turns for a pixel, such as gl_FragCoord.xy: each once in 4 x 4
UMBRAGE_HIGHP vec2 umbrage_disc_turn(UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_HIGHP vec2 whole = umbrage_inside_texel_space(pixel) ? floor(pixel) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float v = whole.x * 4.0 + whole.y;
    v = v - floor(v * (1.0 / 16.0)) * 16.0;
    UMBRAGE_HIGHP float quarter = floor(v * 0.25);
    UMBRAGE_HIGHP float base = v - quarter * 4.0;
    UMBRAGE_HIGHP vec2 low = base < 0.5 ? vec2(64.0, 0.0) : vec2(59.0, 24.0);
    UMBRAGE_HIGHP vec2 high = base < 2.5 ? vec2(45.0, 45.0) : vec2(24.0, 59.0);
    UMBRAGE_HIGHP vec2 turn = base < 1.5 ? low : high;
    UMBRAGE_HIGHP vec2 once = quarter < 0.5 ? turn : vec2(0.0 - turn.y, turn.x);
    UMBRAGE_HIGHP vec2 twice = quarter < 2.5 ? vec2(0.0 - turn.x, 0.0 - turn.y) : vec2(turn.y, 0.0 - turn.x);
    return quarter < 1.5 ? once : twice;
}
)GLSL",
};

inline constexpr snippet disc_tap{
    .name = "disc_tap",
    .summary = "the texel that a point of a disc falls on",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_disc_tap: the texel that a point of a disc falls on
//   position  floor(256 coord) of the receiver;   p  point, in 1/16 of the radius;   turn  of umbrage_disc_turn
//   radius    in 1/16 texel, a whole number from 0 to 4095
UMBRAGE_HIGHP vec2 umbrage_disc_tap(UMBRAGE_HIGHP vec2 position, UMBRAGE_HIGHP vec2 p, UMBRAGE_HIGHP vec2 turn,
                                    UMBRAGE_HIGHP float radius) {
    UMBRAGE_HIGHP vec2 at = position * (1.0 / 256.0);
    UMBRAGE_HIGHP vec2 texel = floor(at);
    UMBRAGE_HIGHP vec2 within = at - texel;
    UMBRAGE_HIGHP vec2 scaled = turn * (radius * (1.0 / 16384.0));
    UMBRAGE_HIGHP float x = scaled.x * p.x + within.x - scaled.y * p.y;
    UMBRAGE_HIGHP float y = scaled.y * p.x + within.y + scaled.x * p.y;
    return texel + floor(vec2(x, y));
}
)GLSL",
};

inline constexpr snippet disc_radius{
    .name = "disc_radius",
    .summary = "radius of a disc, down to 1/16 texel",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_disc_radius: a disc's radius in 1/16 texel, from one in texels: a whole number from 0 to 4095, of a NaN 0
UMBRAGE_HIGHP float umbrage_disc_radius(UMBRAGE_HIGHP float radius) {
    UMBRAGE_HIGHP float inside = radius > 0.0 ? floor(radius * 16.0) : 0.0;
    return radius >= 255.9375 ? 4095.0 : inside;
}
)GLSL",
};

namespace detail {

/// A disc's text, its points a line each.
template <int Points>
[[nodiscard]] std::string disc_text() {
    std::string text = filled(R"GLSL(
// umbrage_disc$n: lit share of $n points of a disc; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   turn  umbrage_disc_turn of the pixel
UMBRAGE_HIGHP float umbrage_disc$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                   UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius, UMBRAGE_HIGHP vec2 turn) {
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);  // no branch: fetches overlap
    UMBRAGE_HIGHP float rho = umbrage_disc_radius(radius);
    UMBRAGE_HIGHP float n = 0.0;
)GLSL",
                              {{'n', Points}});
    for (const disc_point p : disc_points<Points>)
        append(text, "    n += umbrage_lit(map, size, umbrage_disc_tap(at, vec2($x.0, $y.0), turn, rho), receiver);\n",
               {{'x', p.x}, {'y', p.y}});
    append(text, "    return compared ? n * (1.0 / $n.0) : 1.0;\n}\n", {{'n', Points}});
    return text;
}

}  // namespace detail

template <int Points>
inline constexpr snippet disc{.name = Points == 8 ? "disc8" : (Points == 16 ? "disc16" : "disc32"),
                              .summary = Points == 8    ? "disc of 8 points, turned by the pixel"
                                         : Points == 16 ? "disc of 16 points, turned by the pixel"
                                                        : "disc of 32 points, turned by the pixel",
                              .exactness = tier::a,
                              .needs = list<&is_compared, &disc_radius, &disc_tap, &lit>,
                              .source = detail::disc_text<Points>};

inline constexpr auto disc_snippets = list<&disc_turn, &disc_tap, &disc_radius, &disc<8>, &disc<16>, &disc<32>>;

}  // namespace glsl

namespace filters {

/// A disc as a value; functions over images turn it from pixel to pixel.
struct rotated_disc {
    int points = 16;  ///< 8, 16 or 32
    float radius_texels = 2.0f;
    comparison is_lit{};
    std::string_view name = "disc16";
    const glsl::snippet* snippet = &glsl::disc<16>;

    static const std::array<rotated_disc, 3> values;

    /// From a receiver to the farthest point, in texels.
    [[nodiscard]] constexpr float farthest_point() const {
        const float sixteenths = points == 8 ? 13.0385f : (points == 16 ? 14.1422f : 15.0f);
        return disc_radius(radius_texels) * sixteenths * (1.0f / 256.0f);
    }
    [[nodiscard]] constexpr float reach() const {
        const float sixteenths = points == 8 ? 13.0f : (points == 16 ? 14.0f : 15.0f);  // along an axis, in any turn
        return disc_radius(radius_texels) * sixteenths * (1.0f / 256.0f) + (0.5f + 1.0f / 128.0f);
    }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver, glm::ivec2 pixel = {}) const {
        const glm::vec2 turn = disc_turn(glm::vec2(pixel));
        if (points == 8) return umbrage::disc<8>(fetch, coord, receiver, radius_texels, turn, is_lit);
        if (points == 16) return umbrage::disc<16>(fetch, coord, receiver, radius_texels, turn, is_lit);
        return umbrage::disc<32>(fetch, coord, receiver, radius_texels, turn, is_lit);
    }
};

/// The same result; for images of receivers it first asks, for all texels within reach, whether they are all lit or all
/// in shadow. Pays off for large radii, and where shadows have more inside than border.
///
///     umbrage::filters::hierarchical_disc filter{umbrage::filters::disc<32>};
struct hierarchical_disc : rotated_disc {};

template <int Points>
inline constexpr rotated_disc disc{Points, 2.0f, {}, glsl::disc<Points>.name, &glsl::disc<Points>};

inline constexpr std::array<rotated_disc, 3> rotated_disc::values{disc<8>, disc<16>, disc<32>};

}  // namespace filters
}  // namespace umbrage

// ---- umbrage/floor_divide.hpp
// Whole numbers over whole numbers, rounded down: exact in floats, however far off the machine's division is.
//
//     float mean = umbrage::floor_divide(sum, count);
//
// GLSL allows a quotient to be 2.5 ulp off, older dialects anything. Its floor is then one off where the true quotient
// is whole or nearly so; a product tells, and products of whole numbers are exact.

namespace umbrage {

/// The quotient that a guess is at most one away from.
/// @param q     whole, floor(a / b) - 1 .. floor(a / b) + 1
/// @param a     whole, 0 <= a < 2^24;   b  whole, 1 <= b <= 2^24
/// @return      floor(a / b)
/// @formula     q - [q b > a], then one more where that leaves b or more of a
/// @exactness   A: a product of 2^24 or more is beyond a, however it rounds
template <real T>
[[nodiscard]] constexpr T mend_quotient(T q, T a, T b) {
    const T low = q * b > a ? q - T(1) : q;
    return (low + T(1)) * b <= a ? low + T(1) : low;
}

/// @param a     whole, 0 <= a < 2^24;   b  whole, 1 <= b <= 2^24;   their quotient at most 2^18
/// @return      floor(a / b)
/// @exactness   A: with a quotient up to 8 ulp off, less than 1 in so small a one, mend_quotient has all it needs
template <real T>
[[nodiscard]] T floor_divide(T a, T b) {
    return mend_quotient(std::floor(a / b), a, b);
}

namespace glsl {

inline constexpr snippet mend_quotient{
    .name = "mend_quotient",
    .summary = "a quotient of whole numbers, from one at most one off",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_mend_quotient: floor(a / b) from q, at most one off;  whole numbers, a below 2^24, b from 1 to 2^24
UMBRAGE_HIGHP float umbrage_mend_quotient(UMBRAGE_HIGHP float q, UMBRAGE_HIGHP float a, UMBRAGE_HIGHP float b) {
    UMBRAGE_HIGHP float low = q * b > a ? q - 1.0 : q;
    return (low + 1.0) * b <= a ? low + 1.0 : low;
}
)GLSL",
};

inline constexpr snippet floor_divide{
    .name = "floor_divide",
    .summary = "whole numbers divided and rounded down, whatever the division's error",
    .exactness = tier::a,
    .needs = list<&mend_quotient>,
    .source = R"GLSL(
// umbrage_floor_divide: floor(a / b) of whole numbers, a below 2^24, b from 1 to 2^24, the quotient at most 2^18
UMBRAGE_HIGHP float umbrage_floor_divide(UMBRAGE_HIGHP float a, UMBRAGE_HIGHP float b) {
    return umbrage_mend_quotient(floor(a / b), a, b);
}
)GLSL",
};

inline constexpr auto floor_divide_snippets = list<&mend_quotient, &floor_divide>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/blocker/penumbra.hpp
// How wide a penumbra is, from what lies between a receiver and the light: of suns and of spots, by one formula.
//
//     umbrage::light_softness soft = umbrage::make_softness(umbrage::make_light_units(light, map.size()), lamp_radius);
//     glm::vec2 found = umbrage::blockers<16>(fetch, position, receiver, radius, turn);
//     float mean = umbrage::floor_divide(found.y, found.x);  // of codes, 0 at the light
//     float radius = umbrage::penumbra(umbrage::distance_code(receiver) - mean, glm::vec3(soft));
//
// A spot's z/w is linear in 1 / distance, and so is the width of its penumbrae in texels, which grow with the distance:
// radius (1 / d_blocker - 1 / d_receiver) texels a unit at distance 1. Both sides of a division cancel, and no depth is
// made linear. The mean of several blockers' z/w is that of their 1 / distance, whose distance is the harmonic mean:
// penumbrae are never smaller than the mean distance would make them.

namespace umbrage {

/// What a light's size makes of distances: whole numbers, or nearly so, that keep all below exact.
struct light_softness {
    float per_code = 0.0625f;  ///< penumbra's radius in 1/16 texel, a code between blocker and receiver; 8 bits
    float least = 16.0f;       ///< radius of the filter where blockers touch receivers, 1/16 texel, whole
    float widest = 96.0f;      ///< of filter and search, 1/16 texel, whole, at most 4095

    [[nodiscard]] explicit operator glm::vec3() const { return {per_code, least, widest}; }
};

/// @param units          make_light_units of the light and the map
/// @param light_size     radius of a spot's lamp in world units; of a directional light the tangent of half the angle
///                       that it is seen under, of the sun 0.00465
/// @param least_texels   the filter's radius where a blocker touches the receiver: 1 hides the map's steps, 0 is hard
/// @param widest_texels  wider penumbrae are cut to that, and blockers farther off are not found; with 16 points beyond
///                       16 texels or so noise shows
/// @return               per_code rounded to 8 bits, by 1/256 of it at most; 0 for lights of no size: all is `least`
/// @throws std::invalid_argument  units or size that are not finite or below 0, radii that are not
///                                0 <= least <= widest <= 255.9375
/// @formula              per_code = 16 light_size / (65536 units.x units.y)
template <real T>
[[nodiscard]] light_softness make_softness(glm::vec<2, T> units, T light_size, T least_texels = T(1),
                                           T widest_texels = T(16)) {
    constexpr auto function = "make_softness";
    detail::require(is_finite(light_size) && light_size >= T(0), function, "light_size", "must be finite, not below 0");
    detail::require(detail::all_finite(units) && units.x > T(0) && units.y > T(0), function, "units",
                    "must be finite and above 0");
    detail::require(least_texels >= T(0) && least_texels <= widest_texels && widest_texels <= T(max_disc_radius),
                    function, "least_texels and widest_texels", "must be in order, from 0 to 255.9375");
    const auto exact = double(light_size) / (4096.0 * double(units.x) * double(units.y));
    int exponent = 0;
    const double digits = std::round(std::frexp(exact < 4096.0 ? exact : 4096.0, &exponent) * 256.0);
    const bool counts = exponent > -24;  // else no penumbra has a 256th of a texel
    return {counts ? static_cast<float>(std::ldexp(digits, exponent - 8)) : 0.0f,
            static_cast<float>(disc_radius(least_texels)), static_cast<float>(disc_radius(widest_texels))};
}

/// A depth as its distance from the near plane.
/// @param depth   clamped to [0, 1]; NaN counts as far
/// @return        whole, 0 .. 65535, 0 at the near plane in either direction of depth
/// @formula       x = min(floor(65536 depth), 65535); 65535 - x where depth is reversed
/// @exactness     A
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr T distance_code(T depth, Compare is_lit = {}) {
    const bool forward = is_lit(T(0), T(1));
    const T v = saturate(depth, forward ? T(1) : T(0)) * T(65536);
    const T code = v < T(65535) ? T(static_cast<int>(v)) : T(65535);
    return forward ? code : T(65535) - code;
}

/// Radius of a penumbra.
/// @param apart      codes from the blocker to the receiver; whole, below 2^16, below 0 as 0
/// @param softness   of make_softness: (per_code, least, widest)
/// @return           in 1/16 texel, whole, from least to widest
/// @formula          min(max(floor(apart per_code), least), widest)
/// @exactness        A: a product of 24 bits
template <real T>
[[nodiscard]] T penumbra(T apart, glm::vec<3, T> softness) {
    const T radius = std::floor(apart * softness.x);
    return glm::min(glm::max(radius, softness.y), softness.z);
}

/// A texel's part in the search for blockers.
/// @return       (1, its distance_code) where it is before the receiver, else (0, 0)
/// @exactness    A
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] glm::vec<2, T> blocker(Fetch&& fetch, glm::ivec2 texel, T receiver, Compare is_lit = {}) {
    const auto stored = T(fetch(texel));
    return is_lit(receiver, stored) ? glm::vec<2, T>(T(0), T(0)) : glm::vec<2, T>(T(1), distance_code(stored, is_lit));
}

/// The texels under a disc's points that lie before a receiver.
/// @tparam Points    8, 16 or 32
/// @param fetch      ivec2 texel -> stored depth; called Points times, texels may lie a radius outside the map
/// @param position   floor(256 coord) of the receiver
/// @param receiver   depth, biased as for the filter; NaN has all texels before it
/// @param radius     in 1/16 texel, whole, 0 .. 4095
/// @param turn       as disc_turn gives it
/// @return           (how many, the sum of their distance_codes): whole, a NaN among texels counts as a blocker at the
///                   far plane
/// @exactness        A: a sum below 2^21
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] glm::vec<2, T> blockers(Fetch&& fetch, glm::vec<2, T> position, T receiver, T radius, glm::vec<2, T> turn,
                                      Compare is_lit = {}) {
    glm::vec<2, T> found(T(0), T(0));
    for (const glm::ivec2 point : disc_points<Points>)
        found += blocker(fetch, glm::ivec2(disc_tap(position, glm::vec<2, T>(point), turn, radius)), receiver, is_lit);
    return found;
}

namespace glsl {

inline constexpr snippet distance_code{
    .name = "distance_code",
    .summary = "a depth as 16 bits of distance from the near plane",
    .exactness = tier::a,
    .needs = list<&cleared_depth>,
    .source = R"GLSL(
// umbrage_distance_code: a depth as whole number from 0.0 at the near plane to 65535.0, also where depth is reversed
UMBRAGE_HIGHP float umbrage_distance_code(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = depth * 65536.0;
    UMBRAGE_HIGHP float forward = v < 65535.0 ? floor(max(v, 0.0)) : 65535.0;
    UMBRAGE_HIGHP float reversed = v > 0.0 ? floor(min(v, 65535.0)) : 0.0;
    return umbrage_cleared_depth() > 0.5 ? forward : 65535.0 - reversed;
}
)GLSL",
};

inline constexpr snippet penumbra{
    .name = "penumbra",
    .summary = "radius of a penumbra from the distance between blocker and receiver",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_penumbra: radius in 1/16 texel, a whole number
//   apart     umbrage_distance_code of the receiver less that of the blocker
//   softness  (1/16 texel a code, least, widest), of make_softness
UMBRAGE_HIGHP float umbrage_penumbra(UMBRAGE_HIGHP float apart, UMBRAGE_HIGHP vec3 softness) {
    return min(max(floor(apart * softness.x), softness.y), softness.z);
}
)GLSL",
};

inline constexpr snippet blocker{
    .name = "blocker",
    .summary = "whether a texel lies before a receiver, and how far from the light",
    .exactness = tier::a,
    .needs = list<&fetch_depth, &compare, &distance_code>,
    .source = R"GLSL(
// umbrage_blocker: (1.0, umbrage_distance_code) of a texel before the receiver, of any other (0.0, 0.0)
UMBRAGE_HIGHP vec2 umbrage_blocker(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float stored = umbrage_fetch_depth(map, size, texel);
    UMBRAGE_HIGHP float code = umbrage_distance_code(stored);
    return umbrage_compare(receiver, stored) > 0.5 ? vec2(0.0, 0.0) : vec2(1.0, code);
}
)GLSL",
};

namespace detail {

/// The search's text, its points a line each.
template <int Points>
[[nodiscard]] std::string blockers_text() {
    std::string text = filled(R"GLSL(
// umbrage_blockers$n: how many of a disc's $n points fall on texels before the receiver, and the sum of their codes
//   map, size  shadow map and its size in texels;   position  floor(256 coord) of the receiver;   receiver  biased
//   radius     in 1/16 texel, a whole number from 0 to 4095;   turn  umbrage_disc_turn of the pixel
UMBRAGE_HIGHP vec2 umbrage_blockers$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 position,
                                      UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                      UMBRAGE_HIGHP vec2 turn) {
    UMBRAGE_HIGHP vec2 n = vec2(0.0, 0.0);
)GLSL",
                              {{'n', Points}});
    for (const disc_point p : disc_points<Points>)
        append(text,
               "    n += umbrage_blocker(map, size, umbrage_disc_tap(position, vec2($x.0, $y.0), turn, radius), "
               "receiver);\n",
               {{'x', p.x}, {'y', p.y}});
    text += "    return n;\n}\n";
    return text;
}

}  // namespace detail

template <int Points>
inline constexpr snippet blockers{.name = Points == 8 ? "blockers8" : (Points == 16 ? "blockers16" : "blockers32"),
                                  .summary = "texels under a disc's points that lie before a receiver",
                                  .exactness = tier::a,
                                  .needs = list<&disc_tap, &blocker>,
                                  .source = detail::blockers_text<Points>};

inline constexpr auto penumbra_snippets =
    list<&distance_code, &penumbra, &blocker, &blockers<8>, &blockers<16>, &blockers<32>>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/blocker/dpcf.hpp
// Contact hardening without a second look: one disc counts the blockers, and its share is steepened to the penumbra's
// width. Half the texels of pcss, and softer than it where a penumbra is much narrower than the light.
//
//     float visibility = umbrage::dpcf<16>(umbrage::clamped(map), coord, depth - bias, glm::vec3(soft),
//                                          umbrage::disc_turn(pixel));
//

namespace umbrage {

/// The share of a disc in shadow, steepened.
/// @tparam Points    8, 16 or 32
/// @param blocked    whole, 0 .. Points
/// @param ratio      of the penumbra to the disc, in 1/256, whole, 0 .. 256: 256 leaves the share as it is
/// @return           0 lit .. 1; 0, 1/2 and 1 stay what they are, and more blocked is never less dark
/// @formula          x = blocked / Points, s the sign of 2 x - 1: 1/2 + s/2 (1 - (1 - |2 x - 1|)^3), which ratio mixes
///                   with x
/// @exactness        A: whole numbers up to 2^24, over 512 Points^3
/// @cite             Google Filament: surface_shadowing.fs
template <int Points, real T>
[[nodiscard]] constexpr T hardened(T blocked, T ratio) {
    constexpr T n = T(Points), cube = n * n * n;
    const T u = blocked * T(2) - n, d = n - (u < T(0) ? -u : u), steep = cube - d * d * d;
    const T hard = u < T(0) ? cube - steep : cube + steep;
    return (hard * (T(256) - ratio) + blocked * ratio * (T(2) * n * n)) * (T(1) / (T(512) * cube));
}

/// @tparam Points    8, 16 or 32
/// @param fetch      ivec2 texel -> stored depth; called Points times, texels may lie the widest radius outside the map
/// @param coord      receiver in texels, the first texel's centre is (0.5, 0.5); outside texel space, or NaN: lit
/// @param receiver   depth, biased; beyond the far plane: lit; NaN is in shadow
/// @param softness   of make_softness: (per_code, least, widest)
/// @param turn       as disc_turn gives it
/// @return           visibility, 1 where nothing blocks, 0 where all does
/// @formula          z = distance_code(receiver); m blockers with the sum s within w = penumbra(z);
///                   1 - hardened(m, floor(256 penumbra(z - floor(s / m)) / w))
/// @exactness        A
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T dpcf(Fetch&& fetch, glm::vec<2, T> coord, T receiver, glm::vec<3, T> softness, glm::vec<2, T> turn,
                     Compare is_lit = {}) {
    if (!is_compared(coord, receiver, is_lit)) return T(1);
    const T z = distance_code(receiver, is_lit), widest = penumbra(z, softness);
    const glm::vec<2, T> found = blockers<Points>(fetch, glm::floor(coord * T(256)), receiver, widest, turn, is_lit);
    const T mean = floor_divide(found.y, glm::max(found.x, T(1)));
    const T ratio = floor_divide(penumbra(z - mean, softness) * T(256), glm::max(widest, T(1)));
    return T(1) - hardened<Points>(found.x, ratio);
}

namespace glsl {
namespace detail {

template <int Points>
[[nodiscard]] std::string hardened_text() {
    constexpr int n = Points;
    return filled(R"GLSL(
// umbrage_hardened$n: the share of $n points in shadow, steepened
//   blocked  how many;   ratio  of the penumbra to the disc in 1/256, a whole number: 256.0 leaves the share as it is
UMBRAGE_HIGHP float umbrage_hardened$n(UMBRAGE_HIGHP float blocked, UMBRAGE_HIGHP float ratio) {
    UMBRAGE_HIGHP float u = blocked * 2.0 - $n.0;
    UMBRAGE_HIGHP float d = $n.0 - abs(u);
    UMBRAGE_HIGHP float steep = $c.0 - d * d * d;
    UMBRAGE_HIGHP float hard = u < 0.0 ? $c.0 - steep : $c.0 + steep;
    return (hard * (256.0 - ratio) + blocked * ratio * $s.0) * (1.0 / $w.0);
}
)GLSL",
                  {{'n', n}, {'c', n * n * n}, {'s', 2 * n * n}, {'w', 512 * n * n * n}});
}

template <int Points>
[[nodiscard]] std::string dpcf_text() {
    return filled(R"GLSL(
// umbrage_dpcf$n: contact hardening by $n points; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_softness;   turn  umbrage_disc_turn of the pixel
UMBRAGE_HIGHP float umbrage_dpcf$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                   UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec3 softness,
                                   UMBRAGE_HIGHP vec2 turn) {
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float z = umbrage_distance_code(receiver);
    UMBRAGE_HIGHP float widest = umbrage_penumbra(z, softness);
    UMBRAGE_HIGHP vec2 found = umbrage_blockers$n(map, size, at, receiver, widest, turn);
    UMBRAGE_HIGHP float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    UMBRAGE_HIGHP float radius = umbrage_penumbra(z - mean, softness);
    UMBRAGE_HIGHP float ratio = umbrage_floor_divide(radius * 256.0, max(widest, 1.0));
    UMBRAGE_HIGHP float dark = umbrage_hardened$n(found.x, ratio);
    return compared ? 1.0 - dark : 1.0;
}
)GLSL",
                  {{'n', Points}});
}

}  // namespace detail

template <int Points>
inline constexpr snippet hardened{.name = Points == 8 ? "hardened8" : (Points == 16 ? "hardened16" : "hardened32"),
                                  .summary = "a disc's share in shadow, steepened",
                                  .exactness = tier::a,
                                  .source = detail::hardened_text<Points>};

template <int Points>
inline constexpr snippet dpcf{
    .name = Points == 8 ? "dpcf8" : (Points == 16 ? "dpcf16" : "dpcf32"),
    .summary = Points == 8    ? "contact hardening by 8 points"
               : Points == 16 ? "contact hardening by 16 points"
                              : "contact hardening by 32 points",
    .exactness = tier::a,
    .needs = list<&is_compared, &distance_code, &penumbra, &blockers<Points>, &floor_divide, &hardened<Points>>,
    .source = detail::dpcf_text<Points>};

inline constexpr auto dpcf_snippets = list<&hardened<8>, &hardened<16>, &hardened<32>, &dpcf<8>, &dpcf<16>, &dpcf<32>>;

}  // namespace glsl

namespace filters {

/// The filter as a value; functions over images turn it from pixel to pixel.
struct dpcf {
    int points = 16;  ///< 8, 16 or 32
    light_softness softness{};
    comparison is_lit{};
    std::string_view name = "dpcf16";
    const glsl::snippet* snippet = &glsl::dpcf<16>;

    static const std::array<dpcf, 3> values;

    /// The disc of the widest radius.
    [[nodiscard]] constexpr rotated_disc widest() const { return {points, softness.widest * 0.0625f, is_lit}; }
    /// From a receiver to the farthest point, in texels.
    [[nodiscard]] constexpr float farthest_point() const { return widest().farthest_point(); }
    [[nodiscard]] constexpr float reach() const { return widest().reach(); }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver, glm::ivec2 pixel = {}) const {
        const glm::vec2 turn = disc_turn(glm::vec2(pixel));
        const glm::vec3 soft(softness);
        if (points == 8) return umbrage::dpcf<8>(fetch, coord, receiver, soft, turn, is_lit);
        if (points == 16) return umbrage::dpcf<16>(fetch, coord, receiver, soft, turn, is_lit);
        return umbrage::dpcf<32>(fetch, coord, receiver, soft, turn, is_lit);
    }
};

inline constexpr std::array<dpcf, 3> dpcf::values{{{8, {}, {}, "dpcf8", &glsl::dpcf<8>},
                                                   {16, {}, {}, "dpcf16", &glsl::dpcf<16>},
                                                   {32, {}, {}, "dpcf32", &glsl::dpcf<32>}}};

}  // namespace filters
}  // namespace umbrage

// ---- umbrage/filter/blocker/pcss.hpp
// Percentage-closer soft shadows: hard where a caster touches what it shadows, softer the farther it is.
//
//     umbrage::light_softness soft = umbrage::make_softness(umbrage::make_light_units(light, map.size()), lamp_radius);
//     float visibility = umbrage::pcss<16>(umbrage::clamped(map), coord, depth - bias, glm::vec3(soft),
//                                          umbrage::disc_turn(pixel));
//
// A disc as wide as the light, seen from the receiver, is searched for blockers; their mean distance gives the
// penumbra, and the penumbra's radius the disc that is filtered over. Search and filter share points, turn and bias:
// one that is acne-free for the widest radius is so for all.

namespace umbrage {

/// @tparam Points    8, 16 or 32, of the search and of the filter
/// @param fetch      ivec2 texel -> stored depth; called twice Points times, texels may lie the widest radius outside
/// @param coord      receiver in texels, the first texel's centre is (0.5, 0.5); outside texel space, or NaN: lit
/// @param receiver   depth, biased; beyond the far plane: lit; NaN is in shadow
/// @param softness   of make_softness: (per_code, least, widest)
/// @param turn       as disc_turn gives it
/// @return           visibility, a multiple of 1 / Points; 1 where the search finds no blocker, as for a receiver at
///                   the near plane; where all it finds blocks, the filter decides all the same
/// @formula          z = distance_code(receiver); m blockers with the sum s within penumbra(z);
///                   disc(penumbra(z - floor(s / m)) / 16)
/// @error            against real numbers the radius is off by (-1 - c, 2 c) sixteenths of a texel, c = per_code, for
///                   depths that are rounded down to 16 bits, and by 1/256 of itself for per_code
/// @exactness        A
/// @cite             Fernando: Percentage-closer soft shadows, SIGGRAPH 2005 sketches
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T pcss(Fetch&& fetch, glm::vec<2, T> coord, T receiver, glm::vec<3, T> softness, glm::vec<2, T> turn,
                     Compare is_lit = {}) {
    if (!is_compared(coord, receiver, is_lit)) return T(1);
    const T z = distance_code(receiver, is_lit);
    const glm::vec<2, T> found =
        blockers<Points>(fetch, glm::floor(coord * T(256)), receiver, penumbra(z, softness), turn, is_lit);
    if (!(found.x > T(0))) return T(1);
    const T radius = penumbra(z - floor_divide(found.y, found.x), softness);
    return disc<Points>(fetch, coord, receiver, radius * T(0.0625), turn, is_lit);
}

namespace glsl {
namespace detail {

template <int Points>
[[nodiscard]] std::string pcss_text() {
    return filled(R"GLSL(
// umbrage_pcss$n: percentage-closer soft shadows, $n points twice; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased;   softness  of make_softness;   turn  umbrage_disc_turn of the pixel
UMBRAGE_HIGHP float umbrage_pcss$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                   UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec3 softness,
                                   UMBRAGE_HIGHP vec2 turn) {
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float z = umbrage_distance_code(receiver);
    UMBRAGE_HIGHP float widest = umbrage_penumbra(z, softness);
    UMBRAGE_HIGHP vec2 found = umbrage_blockers$n(map, size, at, receiver, widest, turn);
    UMBRAGE_HIGHP float mean = umbrage_floor_divide(found.y, max(found.x, 1.0));
    UMBRAGE_HIGHP float radius = umbrage_penumbra(z - mean, softness);
    // without a blocker the radius is the search's, whose points are all lit
    return umbrage_disc$n(map, size, coord, receiver, radius * (1.0 / 16.0), turn);
}
)GLSL",
                  {{'n', Points}});
}

}  // namespace detail

template <int Points>
inline constexpr snippet pcss{
    .name = Points == 8 ? "pcss8" : (Points == 16 ? "pcss16" : "pcss32"),
    .summary = Points == 8    ? "percentage-closer soft shadows, 8 points twice"
               : Points == 16 ? "percentage-closer soft shadows, 16 points twice"
                              : "percentage-closer soft shadows, 32 points twice",
    .exactness = tier::a,
    .needs = list<&is_compared, &distance_code, &penumbra, &blockers<Points>, &floor_divide, &disc<Points>>,
    .source = detail::pcss_text<Points>};

inline constexpr auto pcss_snippets = list<&pcss<8>, &pcss<16>, &pcss<32>>;

}  // namespace glsl

namespace filters {

/// The filter as a value; functions over images turn it from pixel to pixel.
struct pcss {
    int points = 16;  ///< 8, 16 or 32
    light_softness softness{};
    comparison is_lit{};
    std::string_view name = "pcss16";
    const glsl::snippet* snippet = &glsl::pcss<16>;

    static const std::array<pcss, 3> values;

    /// The disc of the widest radius.
    [[nodiscard]] constexpr rotated_disc widest() const { return {points, softness.widest * 0.0625f, is_lit}; }
    /// From a receiver to the farthest point, in texels.
    [[nodiscard]] constexpr float farthest_point() const { return widest().farthest_point(); }
    [[nodiscard]] constexpr float reach() const { return widest().reach(); }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver, glm::ivec2 pixel = {}) const {
        const glm::vec2 turn = disc_turn(glm::vec2(pixel));
        const glm::vec3 soft(softness);
        if (points == 8) return umbrage::pcss<8>(fetch, coord, receiver, soft, turn, is_lit);
        if (points == 16) return umbrage::pcss<16>(fetch, coord, receiver, soft, turn, is_lit);
        return umbrage::pcss<32>(fetch, coord, receiver, soft, turn, is_lit);
    }
};

inline constexpr std::array<pcss, 3> pcss::values{{{8, {}, {}, "pcss8", &glsl::pcss<8>},
                                                   {16, {}, {}, "pcss16", &glsl::pcss<16>},
                                                   {32, {}, {}, "pcss32", &glsl::pcss<32>}}};

}  // namespace filters
}  // namespace umbrage

// ---- umbrage/filter/pcf/pcf_2x2.hpp
// Bilinear percentage-closer filtering over 2x2 texels.
//
//     float visibility = umbrage::pcf_2x2(umbrage::clamped(map), coord, depth - bias);
//
// pcf_2x2 quantises the weights to 1/256, as texture hardware does, and is exact everywhere; pcf_2x2_dx_sdk is the
// DirectX SDK sample's form in plain floats.

namespace umbrage {

/// Share of a receiver that is lit, from the four nearest texels, each compared and then weighted.
///
/// @param fetch      ivec2 texel -> stored depth; called four times, texels may lie one outside the map
/// @param coord      receiver in texels, the first texel's centre is (0.5, 0.5); outside texel space, or NaN: lit
/// @param receiver   depth, biased; beyond the far plane: lit; NaN is in shadow
/// @return           visibility, a multiple of 2^-16: 0 in shadow, 1 lit
/// @formula          sum of w_i [receiver <= fetch(texel_i)], w the bilinear weights in steps of 1/256
/// @exactness        A: integers below 2^24 times a power of two
/// @cite             Reeves, Salesin, Cook: Rendering antialiased shadows with depth maps, SIGGRAPH 1987
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T pcf_2x2(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    if (!is_compared(coord, receiver, is_lit)) return T(1);
    const glm::vec<2, T> x = glm::floor(coord * T(256)) - T(128);  // position between texel centres, in 1/256 texel
    const glm::vec<2, T> texel = glm::floor(x * T(1.0 / 256.0));
    const glm::vec<2, T> hi = x - texel * T(256);  // weight of the farther texel, 0..255
    const glm::vec<2, T> lo = T(256) - hi;
    const glm::vec<4, T> lit = lit_2x2(fetch, glm::ivec2(texel), receiver, is_lit);
    return (lo.y * (lo.x * lit.x + hi.x * lit.y) + hi.y * (lo.x * lit.z + hi.x * lit.w)) * T(1.0 / 65536.0);
}

/// The DirectX SDK's form: weights in full floats, linear interpolation, the epsilon inside. The sample relies on
/// Direct3D 9 putting pixel centres at whole numbers; here coord is as everywhere else, and the half texel is taken
/// off.
///
/// @param fetch      ivec2 texel -> stored depth; called four times
/// @param coord      receiver in texels, the first texel's centre is (0.5, 0.5); outside texel space, or NaN: lit
/// @param receiver   depth, not biased; beyond 1: lit
/// @param epsilon    in depth, added to the stored side of each comparison
/// @return           visibility, 0 in shadow, 1 lit
/// @formula          lerp of compare_dx_sdk over x, then y, at coord - 1/2
/// @exactness        B
/// @cite             Microsoft DirectX SDK, ShadowMap sample
template <real T, class Fetch>
[[nodiscard]] T pcf_2x2_dx_sdk(Fetch&& fetch, glm::vec<2, T> coord, T receiver, T epsilon) {
    if (!is_compared(coord, receiver)) return T(1);
    const glm::vec<2, T> x = coord - T(0.5);
    const glm::vec<2, T> texel = glm::floor(x);
    const glm::vec<2, T> weight = x - texel;
    const auto lit = [&](int i, int j) {
        return compare_dx_sdk(receiver, T(fetch(glm::ivec2(texel) + glm::ivec2(i, j))), epsilon);
    };
    const T a = lit(0, 0), b = lit(1, 0), c = lit(0, 1), d = lit(1, 1);
    const T low = a + weight.x * (b - a);
    const T high = c + weight.x * (d - c);
    return low + weight.y * (high - low);
}

namespace glsl {

inline constexpr snippet pcf_2x2{
    .name = "pcf_2x2",
    .summary = "bilinear 2x2, weights in steps of 1/256",
    .exactness = tier::a,
    .needs = list<&is_compared, &lit_2x2>,
    .source = R"GLSL(
// umbrage_pcf_2x2: bilinear percentage-closer filtering; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_pcf_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                    UMBRAGE_HIGHP float receiver) {
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0) - 128.0 : vec2(0.0, 0.0);  // no branch: fetches overlap
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    UMBRAGE_HIGHP vec2 hi = x - texel * 256.0;
    UMBRAGE_HIGHP vec2 lo = 256.0 - hi;
    UMBRAGE_HIGHP vec4 lit = umbrage_lit_2x2(map, size, texel, receiver);
    UMBRAGE_HIGHP float sum = lo.y * (lo.x * lit.x + hi.x * lit.y) + hi.y * (lo.x * lit.z + hi.x * lit.w);
    UMBRAGE_HIGHP float visibility = sum * (1.0 / 65536.0);
    return compared ? visibility : 1.0;
}
)GLSL",
};

inline constexpr snippet pcf_2x2_dx_sdk{
    .name = "pcf_2x2_dx_sdk",
    .summary = "bilinear 2x2 as the DirectX SDK sample, plain floats",
    .exactness = tier::b,
    .needs = list<&compare_dx_sdk, &is_compared, &fetch_depth>,
    .source = R"GLSL(
// umbrage_pcf_2x2_dx_sdk: the DirectX SDK sample's 2x2 filter; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, not biased;   epsilon  in depth, added to the stored side
UMBRAGE_HIGHP float umbrage_pcf_2x2_dx_sdk(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                           UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float epsilon) {
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 x = compared ? coord - 0.5 : vec2(0.0, 0.0);  // no branch: fetches overlap
    UMBRAGE_HIGHP vec2 texel = floor(x);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 weight = x - texel;
    UMBRAGE_HIGHP float a = umbrage_compare_dx_sdk(receiver, umbrage_fetch_depth(map, size, texel), epsilon);
    UMBRAGE_HIGHP float right = umbrage_fetch_depth(map, size, texel + vec2(1.0, 0.0));
    UMBRAGE_HIGHP float above = umbrage_fetch_depth(map, size, texel + vec2(0.0, 1.0));
    UMBRAGE_HIGHP float beyond = umbrage_fetch_depth(map, size, texel + vec2(1.0, 1.0));
    UMBRAGE_HIGHP float b = umbrage_compare_dx_sdk(receiver, right, epsilon);
    UMBRAGE_HIGHP float c = umbrage_compare_dx_sdk(receiver, above, epsilon);
    UMBRAGE_HIGHP float d = umbrage_compare_dx_sdk(receiver, beyond, epsilon);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float low = a + weight.x * (b - a);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float high = c + weight.x * (d - c);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float visibility = low + weight.y * (high - low);
    return compared ? visibility : 1.0;
}
)GLSL",
};

}  // namespace glsl

namespace filters {

/// The filter as a value.
struct pcf_2x2 {
    static constexpr std::string_view name = "pcf_2x2";
    static constexpr const glsl::snippet* snippet = &glsl::pcf_2x2;

    comparison is_lit{};

    [[nodiscard]] constexpr float reach() const { return 1.0f; }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::pcf_2x2(fetch, coord, receiver, is_lit);
    }
};

/// The DirectX SDK's form as a value; its comparison is compare_dx_sdk.
struct pcf_2x2_dx_sdk {
    static constexpr std::string_view name = "pcf_2x2_dx_sdk";
    static constexpr const glsl::snippet* snippet = &glsl::pcf_2x2_dx_sdk;

    float epsilon = 0.0f;  ///< in depth
    less_equal is_lit{};   ///< depth runs forward; the epsilon comes on top

    [[nodiscard]] constexpr float reach() const { return 1.0f; }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::pcf_2x2_dx_sdk(fetch, coord, receiver, epsilon);
    }
};

}  // namespace filters
}  // namespace umbrage

// ---- umbrage/filter/pcf/pcf_2x2_hardware.hpp
// pcf_2x2 by the sampler: one look-up that compares four texels and weighs them.
//
//     float visibility = umbrage::pcf_2x2_hardware(umbrage::clamped(map), coord, depth - bias);
//
// In a shader bind it to a texture::shadow or texture::shadow_array whose sampler filters linearly; for any other map
// it is pcf_2x2. The bound holds for samplers that weigh in steps of 1/256, as Direct3D has them, or finer. OpenGL
// leaves what a linear filter does to comparisons to the implementation: Mesa's softpipe compares a filtered depth.
//

namespace umbrage {

/// What filters ask of a map whose sampler weighs comparisons, and what other maps give in its place: pcf_2x2.
/// @param coord   no NaN; what is outside texel space counts as its border
/// @formula       pcf_2x2 at clamp(coord, -32767, 32767)
/// @exactness     C, within 1/128 in a shader: either axis' weight is the hardware's, within 1/256 of ours
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T lit_filtered(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    return pcf_2x2(fetch, glm::clamp(coord, T(-32767), T(32767)), receiver, is_lit);
}

/// lit_filtered at a point in shares of the map's size: what a sampler takes, where the map is all of its texture.
/// @param size   of the map, in texels
/// @param uv     from (0, 0) to (1, 1) over the map, no NaN
/// @exactness    C, within 1/128 in a shader, as lit_filtered
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T lit_at(Fetch&& fetch, glm::vec<2, T> size, glm::vec<2, T> uv, T receiver, Compare is_lit = {}) {
    return lit_filtered(fetch, uv * size, receiver, is_lit);
}

/// What the sampler gives, but for the rounding of its weights: pcf_2x2.
/// @return        visibility, 0 in shadow, 1 lit
/// @exactness     C, within 1/128 in a shader, as lit_filtered
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T pcf_2x2_hardware(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    return pcf_2x2(fetch, coord, receiver, is_lit);
}

namespace glsl {

inline constexpr snippet lit_filtered{
    .name = "lit_filtered",
    .summary = "comparisons around a point, weighted",
    .exactness = tier::c,
    .within = 1.0f / 128.0f,
    .needs = list<&pcf_2x2>,
    .role = hook::lit_filtered,
    .source = R"GLSL(
// umbrage_lit_filtered: 2x2 comparisons around a point; this map has no sampler to weigh them; visibility, 1.0 is lit
//   coord  in texels, no NaN; what is outside texel space counts as its border
UMBRAGE_HIGHP float umbrage_lit_filtered(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                         UMBRAGE_HIGHP float receiver) {
    return umbrage_pcf_2x2(map, size, clamp(coord, vec2(-32767.0, -32767.0), vec2(32767.0, 32767.0)), receiver);
}
)GLSL",
};

/// Of a comparison sampler that a map has for itself the look-up as it is; where a map is a region, or lit outside, or
/// has no such sampler, lit_filtered.
inline constexpr snippet lit_at{
    .name = "lit_at",
    .summary = "comparisons around a point of the map, weighted",
    .exactness = tier::c,
    .within = 1.0f / 128.0f,
    .needs = list<&lit_filtered>,
    .role = hook::lit_at,
    .source = R"GLSL(
// umbrage_lit_at: 2x2 comparisons around a point, weighted; visibility, 1.0 is lit
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
UMBRAGE_HIGHP float umbrage_lit_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                   UMBRAGE_HIGHP float receiver) {
    return umbrage_lit_filtered(map, size, uv * size, receiver);
}
)GLSL",
};

inline constexpr snippet pcf_2x2_hardware{
    .name = "pcf_2x2_hardware",
    .summary = "2x2 by a comparison sampler with a linear filter",
    .exactness = tier::c,
    .within = 1.0f / 128.0f,
    .needs = list<&is_compared, &before_far, &lit_at>,
    .source = R"GLSL(
// umbrage_pcf_2x2_hardware: 2x2 comparisons, weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_pcf_2x2_hardware(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                             UMBRAGE_HIGHP float receiver) {
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec2 at = compared ? coord : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float lit = umbrage_lit_at(map, size, at / size, receiver);
    UMBRAGE_HIGHP float visibility = umbrage_before_far(receiver) ? lit : 0.0;
    return compared ? visibility : 1.0;
}
)GLSL",
};

inline constexpr auto pcf_2x2_hardware_snippets = list<&lit_filtered, &lit_at, &pcf_2x2_hardware>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/pcf/disc_hardware.hpp
// A disc by the sampler: each point is a look-up that compares four texels and weighs them.
//
//     float visibility = umbrage::disc_hardware<16>(umbrage::clamped(map), coord, depth - bias, 3.0f,
//                                                   umbrage::disc_turn(pixel));
//
// Maps and samplers are as for pcf_2x2_hardware.hpp. Points lie where they fall, between texels, as the sampler weighs
// them anyway: nothing is rounded, so that a point costs little more than its look-up.

namespace umbrage {

/// A disc's radius as hardware forms take it: clamped to [0, 255.9375], 0 for NaN.
template <real T>
[[nodiscard]] constexpr T clamped_disc_radius(T radius) {
    return radius > T(0) ? glm::min(radius, T(max_disc_radius)) : T(0);
}

/// Where a point of a disc lies.
/// @param coord    the disc's middle, in texels
/// @param p        one of disc_points;   turn  as disc_turn gives it
/// @param radius   in texels
/// @formula        coord + turned point * radius / 1024, of point (x, y) turned by (c, s): (c x - s y, s x + c y)
template <real T>
[[nodiscard]] glm::vec<2, T> disc_position(glm::vec<2, T> coord, glm::vec<2, T> p, glm::vec<2, T> turn, T radius) {
    const glm::vec<2, T> scaled = turn * (radius * T(1.0 / 1024.0));
    return coord + glm::vec<2, T>(scaled.x * p.x - scaled.y * p.y, scaled.y * p.x + scaled.x * p.y);
}

/// Mean of pcf_2x2 over a disc's points.
/// @tparam Points    8, 16 or 32
/// @param fetch      ivec2 texel -> stored depth; called 4 Points times, texels may lie a radius and one outside
/// @param coord      receiver in texels, the first texel's centre is (0.5, 0.5); outside texel space, or NaN: lit
/// @param receiver   depth, biased; beyond the far plane: lit; NaN is in shadow
/// @param radius     in texels; clamped to 0 .. 255.9375, NaN is 0
/// @param turn       as disc_turn gives it
/// @return           visibility, 0 in shadow, 1 lit
/// @formula          mean of pcf_2x2(disc_position) over disc_points
/// @exactness        C, within 1/128 in a shader as pcf_2x2_hardware: the mean is off by no more than each of its parts
/// @cite             Reeves, Salesin, Cook: Rendering antialiased shadows with depth maps, SIGGRAPH 1987
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T disc_hardware(Fetch&& fetch, glm::vec<2, T> coord, T receiver, T radius, glm::vec<2, T> turn,
                              Compare is_lit = {}) {
    if (!is_compared(coord, receiver, is_lit)) return T(1);
    const T rho = clamped_disc_radius(radius);
    T sum = T(0);
    for (const glm::ivec2 point : disc_points<Points>)
        sum += lit_filtered(fetch, disc_position(coord, glm::vec<2, T>(point), turn, rho), receiver, is_lit);
    return sum * T(1.0 / Points);
}

namespace glsl {

namespace detail {

/// What every text over a disc's points in uv begins with, from its head's closing brace on.
inline constexpr std::string_view disc_in_uv = R"GLSL(
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec2 centre = (compared ? coord : vec2(0.0, 0.0)) / size;
    UMBRAGE_HIGHP vec2 scaled = turn * ((radius > 0.0 ? min(radius, 255.9375) : 0.0) * (1.0 / 1024.0));
    UMBRAGE_HIGHP vec2 x = scaled / size;
    UMBRAGE_HIGHP vec2 y = vec2(0.0 - scaled.y, scaled.x) / size;
)GLSL";

/// `text` with the point's place in uv: centre + x $x + y $y.
inline void append_point(std::string& text, disc_point p, std::string_view before, std::string_view after) {
    const auto sign = [](int v) { return v < 0 ? std::string_view("-") : std::string_view("+"); };
    const auto size = [](int v) { return v < 0 ? -v : v; };
    text += before;
    append(text, "centre $s x * $x.0 $t y * $y.0",
           {{'s', 0, sign(p.x)}, {'x', size(p.x)}, {'t', 0, sign(p.y)}, {'y', size(p.y)}});
    text += after;
}

template <int Points>
[[nodiscard]] std::string disc_hardware_text() {
    std::string text = filled(R"GLSL(
// umbrage_disc_hardware$n: $n points of a disc, each compared and weighted by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   turn  umbrage_disc_turn of the pixel
UMBRAGE_HIGHP float umbrage_disc_hardware$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                            UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                            UMBRAGE_HIGHP vec2 turn) {)GLSL",
                              {{'n', Points}});
    text += disc_in_uv;
    text += "    UMBRAGE_HIGHP float n = 0.0;\n";
    for (const disc_point p : disc_points<Points>)
        append_point(text, p, "    n += umbrage_lit_at(map, size, ", ", receiver);\n");
    append(text, R"GLSL(    UMBRAGE_HIGHP float visibility = umbrage_before_far(receiver) ? n * (1.0 / $n.0) : 0.0;
    return compared ? visibility : 1.0;
}
)GLSL",
           {{'n', Points}});
    return text;
}

}  // namespace detail

template <int Points>
inline constexpr snippet disc_hardware{
    .name = Points == 8 ? "disc_hardware8" : (Points == 16 ? "disc_hardware16" : "disc_hardware32"),
    .summary = Points == 8    ? "disc of 8 points by a comparison sampler with a linear filter"
               : Points == 16 ? "disc of 16 points by one"
                              : "disc of 32 points by one",
    .exactness = tier::c,
    .within = 1.0f / 128.0f,
    .needs = list<&is_compared, &before_far, &lit_at>,
    .source = detail::disc_hardware_text<Points>};

inline constexpr auto disc_hardware_snippets = list<&lit_at, &disc_hardware<8>, &disc_hardware<16>, &disc_hardware<32>>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/blocker/pcss_hardware.hpp
// Percentage-closer soft shadows as the textbook has them, in floats and by samplers: for half the instructions of
// pcss.hpp, which has the same bits everywhere.
//
//     float visibility = umbrage::pcss_hardware<16>(umbrage::clamped(map), coord, depth - bias, glm::vec3(soft),
//                                                   umbrage::disc_turn(pixel));
//
// A shader binds one texture twice: to a sampler of the nearest texel, from which the search reads depths
// (texture::depth with gather set, which says that there is one), and to one that compares and filters:
//
//     vec2 turn = umbrage_disc_turn(gl_FragCoord.xy);
//     float search = umbrage_pcss_radius(vec2(0.0, 0.0), receiver, soft);
//     vec2 found = umbrage_blockers_hardware16_depths(depths, size, coord, receiver, search, turn);
//     float radius = umbrage_pcss_radius(found, receiver, soft);
//     float visibility = found.x > 0.5 ? umbrage_disc_hardware16_sun(sun, size, coord, receiver, radius, turn) : 1.0;
//
// Points of the search within a rounding of a texel's border may read the texel beside it.

namespace umbrage {

/// What of a point of the map lies before a receiver.
/// @return        (1, depth_at) where that is before the receiver, else (0, 0)
/// @exactness     C, as depth_at
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] glm::vec<2, T> blocker_at(Fetch&& fetch, glm::vec<2, T> size, glm::vec<2, T> uv, T receiver,
                                        Compare is_lit = {}) {
    const T stored = depth_at(fetch, size, uv);
    return is_lit(receiver, stored) ? glm::vec<2, T>(T(0), T(0)) : glm::vec<2, T>(T(1), stored);
}

/// The texels under a disc's points that lie before a receiver, the points where they fall.
/// @tparam Points    8, 16 or 32
/// @param fetch      ivec2 texel -> stored depth; called Points times, texels may lie a radius outside the map
/// @param coord      receiver in texels; outside texel space, or NaN: none found
/// @param receiver   depth, biased as for the filter; beyond the far plane: none found; NaN has all before it
/// @param radius     in texels; clamped to 0 .. 255.9375, NaN is 0
/// @param turn       as disc_turn gives it
/// @return           (how many, the sum of their depths); not finite where depths are not
/// @formula          sum of (1, stored) over the texels under disc_position with stored < receiver
/// @exactness        C, within an ulp in a shader, but at borders between texels, as depth_at
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] glm::vec<2, T> blockers_hardware(Fetch&& fetch, glm::vec<2, T> coord, T receiver, T radius,
                                               glm::vec<2, T> turn, Compare is_lit = {}) {
    glm::vec<2, T> found(T(0), T(0));
    if (!is_compared(coord, receiver, is_lit)) return found;
    const T rho = clamped_disc_radius(radius);
    for (const glm::ivec2 point : disc_points<Points>) {
        const glm::ivec2 texel(glm::floor(disc_position(coord, glm::vec<2, T>(point), turn, rho)));
        const auto stored = T(fetch(texel));
        if (!is_lit(receiver, stored)) found += glm::vec<2, T>(T(1), stored);
    }
    return found;
}

/// Radius of the penumbra that blockers leave at a receiver; without a blocker, (0, 0), that of one at the near plane,
/// beyond which no search needs to look.
/// @param found      (how many, the sum of their depths)
/// @param softness   of make_softness: (per_code, least, widest)
/// @return           in texels, from least / 16 to widest / 16; the former for what is NaN
/// @formula          |receiver - mean| 4096 per_code, clamped
/// @exactness        C: a mean off by 4 ulp moves it by 2^-9 per_code, 1/1024 up to a per_code of 1/2
/// @cite             Fernando: Percentage-closer soft shadows, SIGGRAPH 2005 sketches
template <real T, class Compare = less_equal>
[[nodiscard]] constexpr T pcss_radius(glm::vec<2, T> found, T receiver, glm::vec<3, T> softness, Compare is_lit = {}) {
    const bool forward = is_lit(T(0), T(1));
    const T mean = found.x > T(0.5) ? found.y / found.x : (forward ? T(0) : T(1));
    const T radius = (forward ? receiver - mean : mean - receiver) * (softness.x * T(4096));
    const T least = softness.y * T(0.0625);
    return radius > least ? glm::min(radius, softness.z * T(0.0625)) : least;
}

/// @tparam Points    8, 16 or 32, of the search and of the filter
/// @param fetch      ivec2 texel -> stored depth; called up to 5 Points times
/// @param coord      receiver in texels, the first texel's centre is (0.5, 0.5); outside texel space, or NaN: lit
/// @param receiver   depth, biased; beyond the far plane: lit; NaN is in shadow
/// @param softness   of make_softness: (per_code, least, widest)
/// @param turn       as disc_turn gives it
/// @return           visibility, 0 in shadow, 1 lit; 1 where the search finds no blocker
/// @formula          disc_hardware(pcss_radius(blockers_hardware(pcss_radius(none))))
/// @exactness        C, where blockers' texels are the same: 1/128 and what the radius is off by
/// @cite             Fernando: Percentage-closer soft shadows, SIGGRAPH 2005 sketches
template <int Points, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T pcss_hardware(Fetch&& fetch, glm::vec<2, T> coord, T receiver, glm::vec<3, T> softness,
                              glm::vec<2, T> turn, Compare is_lit = {}) {
    const T search = pcss_radius(glm::vec<2, T>(T(0), T(0)), receiver, softness, is_lit);
    const auto found = blockers_hardware<Points>(fetch, coord, receiver, search, turn, is_lit);
    if (!(found.x > T(0))) return T(1);
    const T radius = pcss_radius(found, receiver, softness, is_lit);
    return disc_hardware<Points>(fetch, coord, receiver, radius, turn, is_lit);
}

namespace glsl {

inline constexpr snippet blocker_at{
    .name = "blocker_at",
    .summary = "whether what a point of the map holds lies before a receiver, and its depth",
    .exactness = tier::c,
    .ulp = 1,
    .needs = list<&depth_at, &compare>,
    .source = R"GLSL(
// umbrage_blocker_at: (1.0, depth) of the texel at a point where it is before the receiver, else (0.0, 0.0)
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0), no NaN
UMBRAGE_HIGHP vec2 umbrage_blocker_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float stored = umbrage_depth_at(map, size, uv);
    return umbrage_compare(receiver, stored) > 0.5 ? vec2(0.0, 0.0) : vec2(1.0, stored);
}
)GLSL",
};

inline constexpr snippet pcss_radius{
    .name = "pcss_radius",
    .summary = "radius of a penumbra from the mean depth of blockers",
    .exactness = tier::c,
    .within = 1.0f / 1024.0f,
    .needs = list<&cleared_depth>,
    .source = R"GLSL(
// umbrage_pcss_radius: radius of a penumbra in texels; without a blocker that of one at the near plane
//   found     (how many blockers, the sum of their depths);   receiver  depth, biased
//   softness  (1/16 texel a code, least, widest), of make_softness
UMBRAGE_HIGHP float umbrage_pcss_radius(UMBRAGE_HIGHP vec2 found, UMBRAGE_HIGHP float receiver,
                                        UMBRAGE_HIGHP vec3 softness) {
    bool forward = umbrage_cleared_depth() > 0.5;
    UMBRAGE_HIGHP float mean = found.x > 0.5 ? found.y / found.x : (forward ? 0.0 : 1.0);
    UMBRAGE_HIGHP float radius = (forward ? receiver - mean : mean - receiver) * (softness.x * 4096.0);
    UMBRAGE_HIGHP float least = softness.y * 0.0625;
    return radius > least ? min(radius, softness.z * 0.0625) : least;
}
)GLSL",
};

namespace detail {

template <int Points>
[[nodiscard]] std::string blockers_hardware_text() {
    std::string text = filled(R"GLSL(
// umbrage_blockers_hardware$n: of the texels at $n points of a disc those before the receiver: (how many, depths' sum)
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased;   radius  in texels, at most 255.9375;   turn  umbrage_disc_turn of the pixel
UMBRAGE_HIGHP vec2 umbrage_blockers_hardware$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                               UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                               UMBRAGE_HIGHP vec2 turn) {)GLSL",
                              {{'n', Points}});
    text += disc_in_uv;
    text += "    UMBRAGE_HIGHP vec2 n = vec2(0.0, 0.0);\n";
    for (const disc_point p : disc_points<Points>)
        append_point(text, p, "    n += umbrage_blocker_at(map, size, ", ", receiver);\n");
    text += "    return compared ? n : vec2(0.0, 0.0);\n}\n";
    return text;
}

}  // namespace detail

template <int Points>
inline constexpr snippet blockers_hardware{
    .name = Points == 8 ? "blockers_hardware8" : (Points == 16 ? "blockers_hardware16" : "blockers_hardware32"),
    .summary = Points == 8    ? "what lies before a receiver at 8 points of a disc, by a sampler of the nearest texel"
               : Points == 16 ? "the same at 16 points"
                              : "the same at 32 points",
    .exactness = tier::c,
    .ulp = 1,
    .needs = list<&is_compared, &blocker_at>,
    .source = detail::blockers_hardware_text<Points>};

inline constexpr auto pcss_hardware_snippets =
    list<&blocker_at, &pcss_radius, &blockers_hardware<8>, &blockers_hardware<16>, &blockers_hardware<32>>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/bounds_lit.hpp
// Whether a filter has to be asked at all: where all texels that it may touch are lit, or none is, one look-up into
// their bounds says so, and what it says are the filter's bits. In shaders, with bounds of make_filter_bounds as a map:
//
//     float lit = umbrage_bounds_lit_sun_bounds(bounds, bounds_size, coord, receiver, place);
//     if (lit < 0.0) lit = umbrage_binomial7_sun(map, size, coord, receiver);
//
// Pays off for filters of many texels, and where shadows have more inside than border.

namespace umbrage {

/// What every filter of a reach gives where bounds suffice.
/// @param bounds     ivec2 -> vec2, least and greatest depth of the texels that it may touch; the least is a NaN where
///                   one of them is
/// @param coord      receiver in texels of the map, as the filter takes it
/// @param receiver   depth, as the filter takes it
/// @param place      which bounds are a receiver's, see make_filter_bounds
/// @return           1 where all are lit, 0 where none is, else -1: ask the filter
/// @formula          [receiver <= least] where that is [receiver <= greatest], else -1; both of the bounds
///                   at floor((floor(256 coord) + place.x) place.y)
/// @exactness        A
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T bounds_lit(Fetch&& bounds, glm::vec<2, T> coord, T receiver, glm::vec<2, T> place,
                           Compare is_lit = {}) {
    if (!is_compared(coord, receiver, is_lit)) return T(1);
    const glm::vec<2, T> b(bounds(glm::ivec2(glm::floor((glm::floor(coord * T(256)) + place.x) * place.y))));
    const T all = compare(receiver, b.x, is_lit), some = compare(receiver, b.y, is_lit);
    return all == some && !is_nan(b.x) && !is_nan(b.y) && b.x <= b.y ? all : T(-1);
}

namespace glsl {

inline constexpr snippet bounds_lit{
    .name = "bounds_lit",
    .summary = "visibility where bounds of a filter's texels suffice",
    .exactness = tier::a,
    .needs = list<&is_compared, &compare, &fetch_clamped>,
    .source = R"GLSL(
// umbrage_bounds_lit: 1.0 where all texels of a filter are lit, 0.0 where none is, else -1.0: ask the filter
//   bounds, size  a map of the texels' least and greatest depths, and its size in texels;   place  what goes with it
//   coord, receiver  as the filter takes them
UMBRAGE_HIGHP float umbrage_bounds_lit(UMBRAGE_MAP bounds, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                       UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 place) {
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec4 b = umbrage_fetch_clamped(bounds, size, floor((x + place.x) * place.y));
    UMBRAGE_HIGHP float all = umbrage_compare(receiver, b.x);
    UMBRAGE_HIGHP float some = umbrage_compare(receiver, b.y);
    UMBRAGE_HIGHP float known = b.x <= b.y && all == some ? all : -1.0;  // not of a NaN
    return compared ? known : 1.0;
}
)GLSL",
};

inline constexpr auto bounds_lit_snippets = list<&bounds_lit>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/pcf/box.hpp
// Percentage-closer filtering with a (2r+1) x (2r+1) box of equal weights.
//
//     float visibility = umbrage::box(umbrage::clamped(map), coord, depth - bias, 2);  // 5 x 5
//

namespace umbrage {

inline constexpr int max_box_radius = 8;

/// Number of lit texels in the box around the receiver's own.
///
/// @param fetch      ivec2 texel -> stored depth; called (2r+1)^2 times, texels may lie r outside the map
/// @param coord      receiver in texels, the first texel's centre is (0.5, 0.5); outside texel space, or NaN: all lit
/// @param receiver   depth, biased; beyond the far plane: lit; NaN is in shadow
/// @param radius     r, clamped to 0..8
/// @return           0 .. (2r+1)^2
/// @formula          sum over |i|, |j| <= r of [receiver <= fetch(floor(coord) + (i, j))]
/// @exactness        A: counts
/// @cite             Reeves, Salesin, Cook: Rendering antialiased shadows with depth maps, SIGGRAPH 1987
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T box_count(Fetch&& fetch, glm::vec<2, T> coord, T receiver, int radius, Compare is_lit = {}) {
    const int r = radius < 0 ? 0 : (radius < max_box_radius ? radius : max_box_radius);
    if (!is_compared(coord, receiver, is_lit)) return T((2 * r + 1) * (2 * r + 1));
    const glm::ivec2 texel(glm::floor(coord));
    int count = 0;
    for (int j = -r; j <= r; ++j)
        for (int i = -r; i <= r; ++i) count += is_lit(receiver, T(fetch(texel + glm::ivec2(i, j)))) ? 1 : 0;
    return T(count);
}

namespace detail {
template <real T>  // quotients of the compiler's: a run-time division would follow the rounding mode and -ffast-math
inline constexpr std::array<T, max_box_radius + 1> box_scales{T(1),          T(1) / T(9),   T(1) / T(25),
                                                              T(1) / T(49),  T(1) / T(81),  T(1) / T(121),
                                                              T(1) / T(169), T(1) / T(225), T(1) / T(289)};
}  // namespace detail

/// 1 / (2r+1)^2, rounded to nearest.
/// @param radius     r, clamped to 0..8
/// @exactness        A: a table
template <real T>
[[nodiscard]] constexpr T box_scale(int radius) {
    const int r = radius < 0 ? 0 : (radius < max_box_radius ? radius : max_box_radius);
    return detail::box_scales<T>[static_cast<std::size_t>(r)];
}

/// Share of the box that is lit; arguments as for box_count.
/// @return           visibility: 0 in shadow, 1 lit, exactly
/// @formula          box_count / (2r+1)^2
/// @exactness        B: the count is exact, its product with box_scale rounds once
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T box(Fetch&& fetch, glm::vec<2, T> coord, T receiver, int radius, Compare is_lit = {}) {
    const T visibility = box_count(fetch, coord, receiver, radius, is_lit) * box_scale<T>(radius);
    return visibility < T(0.999) ? visibility : T(1);  // 121 times the rounded 1/121 is not 1
}

namespace glsl {

inline constexpr snippet box_count{
    .name = "box_count",
    .summary = "lit texels in a box of radius 0..8",
    .exactness = tier::a,
    .needs = list<&is_compared, &lit>,
    .source = R"GLSL(
// umbrage_box_count: lit texels in the (2r+1) x (2r+1) box around the receiver's own, a whole number
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased;   radius  r, clamped to 0..8, best a constant
UMBRAGE_HIGHP float umbrage_box_count(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                      UMBRAGE_HIGHP float receiver, int radius) {
    int r = radius < 0 ? 0 : (radius < 8 ? radius : 8);
    int width = 2 * r + 1;
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec2 first = compared ? floor(coord) - float(r) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP float count = 0.0;
    for (int j = 0; j < 17; j++) {
        if (j >= width) break;
        for (int i = 0; i < 17; i++) {
            if (i >= width) break;
            count += umbrage_lit(map, size, first + vec2(float(i), float(j)), receiver);
        }
    }
    return compared ? count : float(width * width);
}
)GLSL",
};

inline constexpr snippet box_scale{
    .name = "box_scale",
    .summary = "1 / (2r+1)^2",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_box_scale: 1 / (2r+1)^2, rounded to nearest
UMBRAGE_HIGHP float umbrage_box_scale(int radius) {
    UMBRAGE_HIGHP float scale = 0.00346020772;  // not returned as a literal: that would have the host's precision
    if (radius < 8) scale = 0.00444444455;
    if (radius < 7) scale = 0.00591715984;
    if (radius < 6) scale = 0.00826446246;
    if (radius < 5) scale = 0.0123456791;
    if (radius < 4) scale = 0.0204081628;
    if (radius < 3) scale = 0.0399999991;
    if (radius < 2) scale = 0.111111112;
    if (radius < 1) scale = 1.0;
    return scale;
}
)GLSL",
};

inline constexpr snippet box{
    .name = "box",
    .summary = "lit share of a box of radius 0..8",
    .exactness = tier::b,
    .needs = list<&box_count, &box_scale>,
    .source = R"GLSL(
// umbrage_box: lit share of a (2r+1) x (2r+1) box; visibility, 1.0 is lit; arguments as for umbrage_box_count
UMBRAGE_HIGHP float umbrage_box(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                UMBRAGE_HIGHP float receiver, int radius) {
    UMBRAGE_HIGHP float visibility = umbrage_box_count(map, size, coord, receiver, radius) * umbrage_box_scale(radius);
    return visibility < 0.999 ? visibility : 1.0;  // 121 times the rounded 1/121 is not 1
}
)GLSL",
};

}  // namespace glsl

namespace filters {

/// The filter as a value.
struct box {
    static constexpr std::string_view name = "box";
    static constexpr const glsl::snippet* snippet = &glsl::box;

    int radius = 1;  ///< clamped to 0..8
    comparison is_lit{};

    [[nodiscard]] constexpr float reach() const {
        return static_cast<float>(radius < 0 ? 0 : (radius < max_box_radius ? radius : max_box_radius)) + 0.5f;
    }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::box(fetch, coord, receiver, radius, is_lit);
    }
};

/// The same result; for images of receivers it first asks, for the whole box, whether all of it is lit or in shadow.
/// Pays off for large radii, and where shadows have more inside than border.
struct hierarchical_box {
    static constexpr std::string_view name = "hierarchical_box";
    static constexpr const glsl::snippet* snippet = &glsl::box;

    int radius = 1;  ///< clamped to 0..8
    comparison is_lit{};

    [[nodiscard]] constexpr float reach() const { return box{radius}.reach(); }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::box(fetch, coord, receiver, radius, is_lit);
    }
};

}  // namespace filters
}  // namespace umbrage

// ---- umbrage/filter/pcf/four_tap.hpp
// Percentage-closer filtering over four taps with coordinates of their own, as the Radeon 8500 did it: one texture
// matrix per tap (tap_matrices), four nearest fetches, four tests, the mean.
//
//     float visibility = umbrage::four_tap(umbrage::clamped(map), a, b, c, d, depth - bias);
//

namespace umbrage {

/// @param fetch        ivec2 texel -> stored depth; called up to four times
/// @param a, b, c, d   the taps in texels; all are lit where the mean magnitude of their texels' numbers is 2^15 or
///                     more in a direction, and for NaN
/// @param receiver     depth, biased; beyond the far plane: lit; NaN is in shadow
/// @return             visibility: 0, 1/4, 1/2, 3/4 or 1
/// @formula            mean of [receiver <= fetch(floor(tap))]
/// @exactness          A
/// @cite               Reeves, Salesin, Cook 1987; ATI Radeon SDK, ShadowMap sample, 2002
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T four_tap(Fetch&& fetch, glm::vec<2, T> a, glm::vec<2, T> b, glm::vec<2, T> c, glm::vec<2, T> d,
                         T receiver, Compare is_lit = {}) {
    const std::array<glm::vec<2, T>, 4> texels{glm::floor(a), glm::floor(b), glm::floor(c), glm::floor(d)};
    const glm::vec<2, T> sum = glm::abs(texels[0]) + glm::abs(texels[1]) + glm::abs(texels[2]) + glm::abs(texels[3]);
    const auto inside = [](T v) { return !is_nan(v) && v < T(1 << 17); };
    if (!inside(sum.x) || !inside(sum.y) || beyond_far(receiver, is_lit)) return T(1);
    T count(0);
    for (const glm::vec<2, T>& texel : texels) count += lit(fetch, glm::ivec2(texel), receiver, is_lit);
    return count * T(0.25);
}

namespace glsl {

inline constexpr snippet four_tap{
    .name = "four_tap",
    .summary = "mean of four taps with coordinates of their own",
    .exactness = tier::a,
    .needs = list<&lit, &beyond_far>,
    .source = R"GLSL(
// umbrage_four_tap: mean of the shadow test at four taps; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   a, b, c, d  taps in texels, all lit where their mean is 2^15
//   or more in a direction;   receiver  depth, biased
UMBRAGE_HIGHP float umbrage_four_tap(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 a,
                                     UMBRAGE_HIGHP vec2 b, UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP vec2 d,
                                     UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 a_texel = floor(a);
    UMBRAGE_HIGHP vec2 b_texel = floor(b);
    UMBRAGE_HIGHP vec2 c_texel = floor(c);
    UMBRAGE_HIGHP vec2 d_texel = floor(d);
    UMBRAGE_HIGHP vec2 sum = abs(a_texel) + abs(b_texel) + abs(c_texel) + abs(d_texel);
    // two limits on purpose: Mesa makes max(x, y) < limit of one, which loses a NaN
    bool compared = umbrage_beyond_far(receiver) ? false : sum.x < 131072.0 && sum.y * 2.0 < 262144.0;
    UMBRAGE_HIGHP float count = umbrage_lit(map, size, a_texel, receiver) + umbrage_lit(map, size, b_texel, receiver) +
                                umbrage_lit(map, size, c_texel, receiver) + umbrage_lit(map, size, d_texel, receiver);
    return compared ? count * 0.25 : 1.0;
}
)GLSL",
};

}  // namespace glsl

namespace filters {

/// The filter as a value.
struct four_tap {
    static constexpr std::string_view name = "four_tap";
    static constexpr const glsl::snippet* snippet = &glsl::four_tap;

    std::array<glm::vec2, 4> offsets = default_taps<float>;  ///< in texels
    comparison is_lit{};

    [[nodiscard]] constexpr float reach() const {
        float farthest = 0.0f;
        for (glm::vec2 offset : offsets)
            for (float along : {offset.x, -offset.x, offset.y, -offset.y})
                farthest = along > farthest ? along : farthest;
        return farthest + 0.5f;
    }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::four_tap(fetch, coord + offsets[0], coord + offsets[1], coord + offsets[2], coord + offsets[3],
                                 receiver, is_lit);
    }
};

}  // namespace filters
}  // namespace umbrage

// ---- umbrage/filter/pcf/four_tap_hardware.hpp
// four_tap by the sampler, as the Radeon 8500 had it: coordinates that four texture matrices give are the sampler's as
// they are, and its nearest texel is the tap's.
//
//     float visibility = umbrage::four_tap_hardware(umbrage::clamped(map), size, a, b, c, d, depth - bias);
//
// In a shader bind it to a map with `gather` set, which says that there is a sampler of the nearest texel. Taps within
// a rounding of a texel's border may read the texel beside it.

namespace umbrage {

/// @param fetch        ivec2 texel -> stored depth; called four times
/// @param size         of the map, in texels
/// @param a, b, c, d   the taps, from (0, 0) to (1, 1) over the map; all are lit where the mean of |x| + |y| in texels
///                     is 2^15 or more, and for NaN
/// @param receiver     depth, biased; beyond the far plane: lit; NaN is in shadow
/// @return             visibility: 0, 1/4, 1/2, 3/4 or 1
/// @formula            mean of [receiver <= depth_at(tap)]
/// @exactness          C, four_tap but at borders between texels, as depth_at
/// @cite               ATI Radeon SDK, ShadowMap sample, 2002
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T four_tap_hardware(Fetch&& fetch, glm::vec<2, T> size, glm::vec<2, T> a, glm::vec<2, T> b,
                                  glm::vec<2, T> c, glm::vec<2, T> d, T receiver, Compare is_lit = {}) {
    const glm::vec<2, T> sum = (glm::abs(a) + glm::abs(b) + glm::abs(c) + glm::abs(d)) * size;
    const T far = sum.x + sum.y;
    if (is_nan(far) || far >= T(1 << 17) || beyond_far(receiver, is_lit)) return T(1);
    T count(0);
    for (const glm::vec<2, T>& uv : {a, b, c, d}) count += compare(receiver, depth_at(fetch, size, uv), is_lit);
    return count * T(0.25);
}

namespace glsl {

inline constexpr snippet four_tap_hardware{
    .name = "four_tap_hardware",
    .summary = "mean of four taps that a sampler of the nearest texel takes",
    .exactness = tier::c,
    .ulp = 1,
    .needs = list<&beyond_far, &compare, &depth_at>,
    .source = R"GLSL(
// umbrage_four_tap_hardware: mean of the shadow test at four taps of the sampler's; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   a, b, c, d  taps, (0.0, 0.0) to (1.0, 1.0) over the map, all lit
//   where the mean of |x| + |y| is 2^15 texels or more;   receiver  depth, biased
UMBRAGE_HIGHP float umbrage_four_tap_hardware(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 a,
                                              UMBRAGE_HIGHP vec2 b, UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP vec2 d,
                                              UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 sum = (abs(a) + abs(b) + abs(c) + abs(d)) * size;
    bool compared = umbrage_beyond_far(receiver) ? false : sum.x + sum.y < 131072.0;
    UMBRAGE_HIGHP float count = umbrage_compare(receiver, umbrage_depth_at(map, size, a)) +
                                umbrage_compare(receiver, umbrage_depth_at(map, size, b)) +
                                umbrage_compare(receiver, umbrage_depth_at(map, size, c)) +
                                umbrage_compare(receiver, umbrage_depth_at(map, size, d));
    return compared ? count * 0.25 : 1.0;
}
)GLSL",
};

inline constexpr auto four_tap_hardware_snippets = list<&four_tap_hardware>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/pcf/hard.hpp
// The unfiltered shadow test: one texel, one comparison.
//
//     float visibility = umbrage::hard(umbrage::clamped(map), coord, depth - bias);
//

namespace umbrage {

/// @param fetch      ivec2 texel -> stored depth; called once
/// @param coord      receiver in texels, the first texel's centre is (0.5, 0.5); outside texel space, or NaN: lit
/// @param receiver   depth, biased; beyond the far plane: lit; NaN is in shadow
/// @return           1 lit, 0 in shadow
/// @formula          [receiver <= fetch(floor(coord))]
/// @exactness        A
/// @cite             Williams: Casting curved shadows on curved surfaces, SIGGRAPH 1978
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T hard(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    if (!is_compared(coord, receiver, is_lit)) return T(1);
    return lit(fetch, glm::ivec2(glm::floor(coord)), receiver, is_lit);
}

namespace glsl {

inline constexpr snippet hard{
    .name = "hard",
    .summary = "nearest texel, one test",
    .exactness = tier::a,
    .needs = list<&is_compared, &lit>,
    .source = R"GLSL(
// umbrage_hard: unfiltered shadow test; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_hard(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                 UMBRAGE_HIGHP float receiver) {
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec2 texel = compared ? floor(coord) : vec2(0.0, 0.0);  // no branch: fetches of several taps overlap
    UMBRAGE_HIGHP float lit = umbrage_lit(map, size, texel, receiver);
    return compared ? lit : 1.0;
}
)GLSL",
};

}  // namespace glsl

namespace filters {

/// The filter as a value.
struct hard {
    static constexpr std::string_view name = "hard";
    static constexpr const glsl::snippet* snippet = &glsl::hard;

    comparison is_lit{};

    [[nodiscard]] constexpr float reach() const { return 0.5f; }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::hard(fetch, coord, receiver, is_lit);
    }
};

}  // namespace filters
}  // namespace umbrage

// ---- umbrage/light/cube_map.hpp
// Six square maps around a point light: which of them a direction meets and where, as textures of cubes have it, or as
// six tiles of an atlas.
//
//     glm::vec3 at = umbrage::cube_coordinate(world - light);                      // (s, t, face)
//     auto face = atlas.view().region(umbrage::cube_tile(int(at.z), size), {size, size});
//     float visibility = umbrage::pcf_2x2(umbrage::clamped(face), glm::vec2(at) * float(size), depth);
//

namespace umbrage {

/// Which way a face's camera looks and what is up for it, NDC y = -1 in its first row.
struct cube_axes {
    glm::ivec3 forward, up;
};

/// Faces in the order of their numbers: +x, -x, +y, -y, +z, -z. A right-handed view along them with 90 degrees each way
/// has its NDC x and y where cube_coordinate has 2 s - 1 and 2 t - 1.
/// @cite   OpenGL 4.6 specification, table 8.19: selection of cube map images
inline const std::array<cube_axes, 6> cube_faces{{{{1, 0, 0}, {0, -1, 0}},
                                                  {{-1, 0, 0}, {0, -1, 0}},
                                                  {{0, 1, 0}, {0, 0, 1}},
                                                  {{0, -1, 0}, {0, 0, -1}},
                                                  {{0, 0, 1}, {0, -1, 0}},
                                                  {{0, 0, -1}, {0, -1, 0}}}};

/// The face that a direction from the cube's middle meets.
/// @param direction   of any length; where two faces meet, x goes before y and y before z
/// @return            0 .. 5; where a NaN leaves no greatest component, 4 or 5
/// @exactness         A: comparisons
template <real T>
[[nodiscard]] constexpr int cube_face(glm::vec<3, T> direction) {
    const auto magnitude = [](T v) { return v < T(0) ? -v : v; };
    const auto at_least = [](T a, T b) { return !is_nan(a) && !is_nan(b) && a >= b; };
    const T x = magnitude(direction.x), y = magnitude(direction.y), z = magnitude(direction.z);
    const int axis = at_least(x, y) ? (at_least(x, z) ? 0 : 2) : (at_least(y, z) ? 1 : 2);
    const T along = direction[static_cast<glm::length_t>(axis)];
    return 2 * axis + (!is_nan(along) && along < T(0) ? 1 : 0);
}

/// Distance to a direction's end along the axis of the face that it meets: what per-face depths are made of.
/// @return            the greatest component's magnitude
/// @exactness         A: selects
template <real T>
[[nodiscard]] constexpr T cube_view_z(glm::vec<3, T> direction) {
    const int face = cube_face(direction);
    const T m = direction[static_cast<glm::length_t>(face / 2)];
    return face % 2 ? -m : m;
}

/// A direction in its face's axes.
/// @return            (sc, tc, face): to the sides of cube_view_z
/// @exactness         A: selects
/// @cite              OpenGL 4.6 specification, table 8.19
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> cube_plane(glm::vec<3, T> direction) {
    const int face = cube_face(direction), axis = face / 2;
    const T flip = face % 2 == 0 ? T(1) : T(-1);
    const T sc = axis == 0 ? direction.z * -flip : axis == 1 ? direction.x : direction.x * flip;
    return {sc, axis == 1 ? direction.z * flip : -direction.y, T(face)};
}

/// A point from a face's axes: cube_plane's inverse.
/// @param face   0 .. 5;   p  (sc, tc, cube_view_z)
/// @exactness    A: selects
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> cube_point(T face, glm::vec<3, T> p) {
    if (face < T(0.5)) return {p.z, -p.y, -p.x};
    if (face < T(1.5)) return {-p.z, -p.y, p.x};
    if (face < T(2.5)) return {p.x, p.z, p.y};
    if (face < T(3.5)) return {p.x, -p.z, -p.y};
    if (face < T(4.5)) return {p.x, -p.y, p.z};
    return {-p.x, -p.y, -p.z};
}

/// Where on its face a direction meets the cube.
/// @param direction   of any length; zero and NaN give coordinates that are NaN, which every filter takes as lit
/// @return            (s, t, face): s and t from 0 to 1 over the face, times its size a filter's coordinate
/// @formula           s = (sc + m) / 2m, t = (tc + m) / 2m, of cube_plane and m = cube_view_z
/// @exactness         C: divisions, of each of which GLSL allows 2.5 ulp; 0 seen
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> cube_coordinate(glm::vec<3, T> direction) {
    const glm::vec<3, T> p = cube_plane(direction);
    const T m = cube_view_z(direction);
    return {(p.x + m) / (m + m), (p.y + m) / (m + m), p.z};
}

/// The direction to a point of a face: cube_coordinate's inverse.
/// @param face   0 .. 5;   st  from 0 to 1 over the face
/// @return       its greatest component is 1 or -1
/// @exactness    B: 2 s - 1 rounds once
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> cube_direction(T face, glm::vec<2, T> st) {
    return cube_point(face, glm::vec<3, T>(st.x * T(2) - T(1), st.y * T(2) - T(1), T(1)));
}

/// The texel beyond a face's edge, which is the next face's in its first or last row or column.
/// @param texel   (s, t, face), whole numbers: inside a face, or beyond one of its edges
/// @param size    of a face, in texels, below 2^15
/// @return        (s, t, face) of a texel inside; itself where it is; face -1 beyond a corner, where there is none
/// @formula       beyond an edge the point (sc, tc, size), in half texels, moves to (sc, tc, size - 1), where |sc| or
///                |tc| is the greatest: along the next face's axis
/// @exactness     A: whole numbers
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> cube_neighbour(glm::vec<3, T> texel, T size) {
    const T u = texel.x * T(2) + T(1) - size, v = texel.y * T(2) + T(1) - size;
    const bool beyond_u = (u > size) || (u < -size);
    const bool beyond_v = (v > size) || (v < -size);
    if (beyond_u && beyond_v) return {T(0), T(0), T(-1)};
    const T m = beyond_u || beyond_v ? size - T(1) : size;
    const glm::vec<3, T> p = cube_plane(cube_point(texel.z, glm::vec<3, T>(u, v, m)));
    return {(p.x + size - T(1)) * T(0.5), (p.y + size - T(1)) * T(0.5), p.z};
}

/// First texel of a face in an atlas of 3 x 2 tiles: +x, -x, +y in the first row.
/// @param face   0 .. 5;   size  of a tile, in texels
/// @exactness    A
[[nodiscard]] inline glm::ivec2 cube_tile(int face, int size) { return {face % 3 * size, face / 3 * size}; }

namespace glsl {

inline constexpr snippet cube_face{
    .name = "cube_face",
    .summary = "face of a cube that a direction meets",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_cube_face: the face that a direction meets, 0.0 to 5.0: +x, -x, +y, -y, +z, -z
UMBRAGE_HIGHP float umbrage_cube_face(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP vec3 m = abs(direction);
    UMBRAGE_HIGHP float x = direction.x < 0.0 ? 1.0 : 0.0;
    UMBRAGE_HIGHP float y = direction.y < 0.0 ? 3.0 : 2.0;
    UMBRAGE_HIGHP float z = direction.z < 0.0 ? 5.0 : 4.0;
    // not m.x >= m.y && m.x >= m.z, of which Mesa makes one with max(m.y, m.z), which loses a NaN
    return m.x >= m.y ? (m.x >= m.z ? x : z) : (m.y >= m.z ? y : z);
}
)GLSL",
};

inline constexpr snippet cube_view_z{
    .name = "cube_view_z",
    .summary = "distance along the axis of the face that a direction meets",
    .exactness = tier::a,
    .needs = list<&cube_face>,
    .source = R"GLSL(
// umbrage_cube_view_z: the greatest component's magnitude, of which per-face depths are made
UMBRAGE_HIGHP float umbrage_cube_view_z(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP float face = umbrage_cube_face(direction);
    UMBRAGE_HIGHP float side = face < 1.5 ? direction.x : direction.y;
    return abs(face > 3.5 ? direction.z : side);
}
)GLSL",
};

inline constexpr snippet cube_plane{
    .name = "cube_plane",
    .summary = "a direction in its face's axes",
    .exactness = tier::a,
    .needs = list<&cube_face>,
    .source = R"GLSL(
// umbrage_cube_plane: (sc, tc, face) of a direction: its components to the sides of the face that it meets
UMBRAGE_HIGHP vec3 umbrage_cube_plane(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP float face = umbrage_cube_face(direction);
    UMBRAGE_HIGHP vec3 x = vec3(face < 0.5 ? -direction.z : direction.z, -direction.y, face);
    UMBRAGE_HIGHP vec3 y = vec3(direction.x, face < 2.5 ? direction.z : -direction.z, face);
    UMBRAGE_HIGHP vec3 z = vec3(face < 4.5 ? direction.x : -direction.x, -direction.y, face);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
)GLSL",
};

inline constexpr snippet cube_point{
    .name = "cube_point",
    .summary = "a point from a face's axes",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_cube_point: from (sc, tc, distance along its axis) of a face, 0.0 to 5.0
UMBRAGE_HIGHP vec3 umbrage_cube_point(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP vec3 p) {
    UMBRAGE_HIGHP vec3 x = face < 0.5 ? vec3(p.z, -p.y, -p.x) : vec3(-p.z, -p.y, p.x);
    UMBRAGE_HIGHP vec3 y = face < 2.5 ? vec3(p.x, p.z, p.y) : vec3(p.x, -p.z, -p.y);
    UMBRAGE_HIGHP vec3 z = face < 4.5 ? vec3(p.x, -p.y, p.z) : vec3(-p.x, -p.y, -p.z);
    return face < 1.5 ? x : (face < 3.5 ? y : z);
}
)GLSL",
};

inline constexpr snippet cube_coordinate{
    .name = "cube_coordinate",
    .summary = "face, and where on it, that a direction meets",
    .exactness = tier::c,
    .ulp = 1,
    .needs = list<&cube_view_z, &cube_plane>,
    .source = R"GLSL(
// umbrage_cube_coordinate: (s, t, face) of a direction; s and t go from 0.0 to 1.0 over the face
UMBRAGE_HIGHP vec3 umbrage_cube_coordinate(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP vec3 p = umbrage_cube_plane(direction);
    UMBRAGE_HIGHP float m = umbrage_cube_view_z(direction);
    return vec3((p.x + m) / (m + m), (p.y + m) / (m + m), p.z);
}
)GLSL",
};

inline constexpr snippet cube_direction{
    .name = "cube_direction",
    .summary = "direction to a point of a cube's face",
    .exactness = tier::b,
    .needs = list<&cube_point>,
    .source = R"GLSL(
// umbrage_cube_direction: from a cube's middle to a point of a face, 0.0 to 5.0; st goes from 0.0 to 1.0 over the face
UMBRAGE_HIGHP vec3 umbrage_cube_direction(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP vec2 st) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 uv = st * 2.0 - 1.0;  // an exact product: fused or not, it rounds once
    return umbrage_cube_point(face, vec3(uv, 1.0));
}
)GLSL",
};

inline constexpr snippet cube_neighbour{
    .name = "cube_neighbour",
    .summary = "texel beyond an edge of a cube's face",
    .exactness = tier::a,
    .needs = list<&cube_plane, &cube_point>,
    .source = R"GLSL(
// umbrage_cube_neighbour: (s, t, face) of a texel that may lie beyond an edge of its face; face -1.0 beyond a corner
//   texel  (s, t, face), whole numbers;   size  of a face, in texels
UMBRAGE_HIGHP vec3 umbrage_cube_neighbour(UMBRAGE_HIGHP vec3 texel, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP vec2 uv = vec2(texel.x, texel.y) * 2.0 + (1.0 - size);
    bool beyond_u = abs(uv.x) > size;
    bool beyond_v = abs(uv.y) > size;
    UMBRAGE_HIGHP float m = beyond_u || beyond_v ? size - 1.0 : size;
    UMBRAGE_HIGHP vec3 p = umbrage_cube_plane(umbrage_cube_point(texel.z, vec3(uv, m)));
    UMBRAGE_HIGHP vec2 inside = (vec2(p.x, p.y) + (size - 1.0)) * 0.5;
    return beyond_u && beyond_v ? vec3(0.0, 0.0, -1.0) : vec3(inside, p.z);
}
)GLSL",
};

inline constexpr snippet cube_tile{
    .name = "cube_tile",
    .summary = "first texel of a face in an atlas",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_cube_tile: first texel of a face, 0.0 to 5.0, in an atlas of 3 x 2 tiles of size texels
UMBRAGE_HIGHP vec2 umbrage_cube_tile(UMBRAGE_HIGHP float face, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP float row = face < 2.5 ? 0.0 : 1.0;
    return vec2((face - row * 3.0) * size, row * size);
}
)GLSL",
};

inline constexpr auto cube_map_snippets = list<&cube_face, &cube_view_z, &cube_plane, &cube_point, &cube_coordinate,
                                               &cube_direction, &cube_neighbour, &cube_tile>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/pcf/pcf_2x2_cube.hpp
// Bilinear percentage-closer filtering over 2 x 2 texels of a cube, whose faces are tiles of an atlas: taps go on over
// the edges, so that no seam shows.
//
//     glm::vec3 at = umbrage::cube_coordinate(world - light) * glm::vec3(size, size, 1);
//     float visibility = umbrage::pcf_2x2_cube(umbrage::clamped(atlas), float(size), at, depth);
//
// A shader binds it to an atlas as it is, or to a texture of a cube:
//
//     glsl::source(glsl::version::v330, {glsl::cube_coordinate,
//                                        bind(glsl::pcf_2x2_cube, "lamp", {.texture = texture::cube_faces})});
//     // vec2 atlas = vec2(3.0, 2.0) * float(size); umbrage_pcf_2x2_cube_lamp(lamp, atlas, at, depth)
//
// Depths must not depend on the face that they lie on: distances from the light, as distance_depth gives them.

namespace umbrage {

/// Visibility of one comparison with a texel of a cube, which may lie beyond an edge of its face.
/// @param fetch   ivec2 -> stored depth, of an atlas with tiles as cube_tile has them
/// @param size    of a face, in texels;   texel  (s, t, face), whole numbers
/// @return        (1 when lit or 0 in shadow, 1); (0, 0) beyond a corner, where there is no texel
/// @exactness     A
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] glm::vec<2, T> cube_lit(Fetch&& fetch, T size, glm::vec<3, T> texel, T receiver, Compare is_lit = {}) {
    const glm::vec<3, T> n = cube_neighbour(texel, size);
    if (n.z < T(0)) return {T(0), T(0)};
    const glm::ivec2 first = cube_tile(static_cast<int>(n.z), static_cast<int>(size));
    return {lit(fetch, first + glm::ivec2(n), receiver, is_lit), T(1)};
}

/// Share of a receiver that is lit, from the four nearest texels, each compared and then weighted, on whatever face
/// they lie; at a corner three, with their weights' sum made 1.
/// @param fetch      ivec2 -> stored depth, of an atlas with tiles as cube_tile has them; called up to four times
/// @param size       of a face, in texels
/// @param at         (s, t, face): s and t in texels, from 0 to size; NaN is lit
/// @param receiver   depth, biased; beyond the far plane: lit; NaN is in shadow
/// @return           visibility, the same on either side of an edge
/// @formula          sum of w_i [receiver <= fetch(texel_i)] over sum of w_i, w the bilinear weights in steps of 1/256,
///                   to the nearest step, which is the same one from either side
/// @exactness        C: a division, by 65536 but at corners, of which GLSL allows 2.5 ulp; 0 seen
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T pcf_2x2_cube(Fetch&& fetch, T size, glm::vec<3, T> at, T receiver, Compare is_lit = {}) {
    const glm::vec<2, T> coord(at);
    if (!is_compared(coord, receiver, is_lit)) return T(1);
    const glm::vec<2, T> x = glm::floor(coord * T(256) + T(0.5)) - T(128);
    const glm::vec<2, T> texel = glm::floor(x * T(1.0 / 256.0)), hi = x - texel * T(256), lo = T(256) - hi;
    const auto tap = [&](T i, T j) {
        return cube_lit(fetch, size, glm::vec<3, T>(texel.x + i, texel.y + j, at.z), receiver, is_lit);
    };
    glm::vec<2, T> sum = tap(T(0), T(0)) * (lo.x * lo.y);
    sum += tap(T(1), T(0)) * (hi.x * lo.y);
    sum += tap(T(0), T(1)) * (lo.x * hi.y);
    sum += tap(T(1), T(1)) * (hi.x * hi.y);
    return sum.y > T(0) ? sum.x / sum.y : T(1);
}

namespace glsl {

inline constexpr snippet cube_lit{
    .name = "cube_lit",
    .summary = "one comparison with a texel of a cube",
    .exactness = tier::a,
    .needs = list<&cube_neighbour, &cube_tile, &lit>,
    .source = R"GLSL(
// umbrage_cube_lit: (visibility of one comparison, 1.0) with a texel of a cube, (0.0, 0.0) beyond a corner
//   map, size  atlas of 3 x 2 faces and its size in texels;   texel  (s, t, face), whole numbers
UMBRAGE_HIGHP vec2 umbrage_cube_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec3 texel,
                                    UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float side = size.y * 0.5;
    UMBRAGE_HIGHP vec3 n = umbrage_cube_neighbour(texel, side);
    UMBRAGE_HIGHP vec2 at = umbrage_cube_tile(n.z, side) + vec2(n.x, n.y);
    UMBRAGE_HIGHP float lit = umbrage_lit(map, size, at, receiver);
    return n.z < 0.0 ? vec2(0.0, 0.0) : vec2(lit, 1.0);
}
)GLSL",
};

inline constexpr snippet pcf_2x2_cube{
    .name = "pcf_2x2_cube",
    .summary = "2 x 2 comparisons of a cube, over its edges too, bilinear weights",
    .exactness = tier::c,
    .ulp = 1,
    .needs = list<&is_compared, &cube_lit>,
    .source = R"GLSL(
// umbrage_pcf_2x2_cube: bilinear percentage-closer filtering over a cube's edges; visibility, 1.0 is lit
//   map, size  atlas of 3 x 2 faces and its size in texels;   at  (s, t, face): texels of the face, from 0.0 on
//   receiver   distance from the light, biased
UMBRAGE_HIGHP float umbrage_pcf_2x2_cube(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec3 at,
                                         UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 coord = vec2(at.x, at.y);
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0 + 0.5) - 128.0 : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    UMBRAGE_HIGHP vec2 hi = x - texel * 256.0;
    UMBRAGE_HIGHP vec2 lo = 256.0 - hi;
    UMBRAGE_HIGHP vec2 sum = umbrage_cube_lit(map, size, vec3(texel, at.z), receiver) * (lo.x * lo.y);
    sum += umbrage_cube_lit(map, size, vec3(texel + vec2(1.0, 0.0), at.z), receiver) * (hi.x * lo.y);
    sum += umbrage_cube_lit(map, size, vec3(texel + vec2(0.0, 1.0), at.z), receiver) * (lo.x * hi.y);
    sum += umbrage_cube_lit(map, size, vec3(texel + vec2(1.0, 1.0), at.z), receiver) * (hi.x * hi.y);
    return compared && sum.y > 0.0 ? sum.x / sum.y : 1.0;
}
)GLSL",
};

inline constexpr auto pcf_2x2_cube_snippets = list<&cube_lit, &pcf_2x2_cube>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/pcf/window.hpp
// Percentage-closer filtering under a window of weights that slides over the map in steps of 1/256 texel, so that
// edges of shadows move as smoothly as receivers do.
//
//     float visibility = umbrage::tent<3>(umbrage::clamped(map), coord, depth - bias);  // 1 2 1, 4 x 4 texels
//     constexpr umbrage::window_row row = umbrage::make_window_row(5, {1, 3, 8});
//     float softer = umbrage::window(umbrage::clamped(map), coord, depth - bias, row);  // 1 3 8 3 1, 6 x 6
//
// In a shader a window asks for 2 x 2 texels at a time: bound to a map with `gather`, one of 3 x 3 weights takes 4
// gathers, one of 5 x 5 takes 9, one of 7 x 7 takes 16.
//
// A window of n x n weights touches n + 1 texels an axis: each texel has its own weight and that of its neighbour, as
// much of either as the window has moved. The library's rows of weights are in windows.hpp.

namespace umbrage {

inline constexpr int max_window = 15;

/// A row of weights, the same along both axes, as make_window_row makes it.
struct window_row {
    int size;                   ///< how many weights
    std::array<float, 8> half;  ///< from the edge to the middle one; the others mirror them
    int steps;                  ///< of a texel
    float whole;                ///< what the touched texels' weights along an axis add up to: steps times their sum
    float scale;                ///< 1 / whole^2
    double scale_of_doubles;    ///< the same
    bool quadratic = false;     ///< of two weights, but those of the quadratic B-spline

    /// From one edge to the other, 0 beside the row.
    [[nodiscard]] constexpr float weight(int i) const {
        const int mirrored = i < size - 1 - i ? i : size - 1 - i;
        return mirrored < 0 ? 0.0f : half[static_cast<std::size_t>(mirrored)];
    }
    [[nodiscard]] constexpr int touched() const { return size + 1; }  ///< texels along an axis
    /// From a receiver to the farthest point of its texels, in texels; never attained.
    [[nodiscard]] constexpr float reach() const { return static_cast<float>(size + 1) * 0.5f; }
};

/// A row of weights from what is to be told of it.
/// @param size    weights, 1 .. 15
/// @param half    from the edge to the middle one: size / 2 of them, rounded up; none is negative
/// @param steps   of a texel, a power of two up to 256; times the sum of all weights it is a whole number up to 4096
/// @throws std::invalid_argument  anything else
[[nodiscard]] constexpr window_row make_window_row(int size, std::array<float, 8> half, int steps = 256) {
    if (size < 1 || size > max_window) detail::fail("umbrage::make_window_row: size");
    if (steps < 1 || steps > 256 || (steps & (steps - 1)) != 0) detail::fail("umbrage::make_window_row: steps");
    float sum = 0.0f;
    for (int i = 0; i < size; ++i) {
        const float weight = half[static_cast<std::size_t>(i < size - 1 - i ? i : size - 1 - i)];
        if (!(weight >= 0.0f)) detail::fail("umbrage::make_window_row: weights");
        sum += weight;
    }
    const float whole = sum * static_cast<float>(steps);
    if (!(whole >= 1.0f && whole <= 4096.0f) || whole != static_cast<float>(static_cast<int>(whole)))
        detail::fail("umbrage::make_window_row: sum of the weights");
    return {size, half, steps, whole, 1.0f / (whole * whole), 1.0 / (double(whole) * double(whole))};
}

/// Weights of the texels that a window touches along an axis, whole numbers that add up to row.whole.
/// @param moved     by how much the window has moved, in 1/256 texel, 0 .. 255
/// @param weights   row.touched() of them
/// @formula         w_i = floor(K_i r + K_(i-1) s), s = moved, in steps of the row, r = steps - s; the middle one has
///                  what is left. Quadratic: floor((256 - s)^2 / 32), what is left, floor(s^2 / 32)
template <real T>
constexpr void window_weights(const window_row& row, int moved, T* weights) {
    const int steps = row.steps, s = moved * steps / 256, middle = row.size / 2, ahead = 256 - moved;
    int left = static_cast<int>(row.whole);
    for (int i = 0; i <= row.size; ++i) {
        if (i == middle) continue;
        int weight =
            static_cast<int>(row.weight(i) * static_cast<float>(steps - s) + row.weight(i - 1) * static_cast<float>(s));
        if (row.quadratic) weight = i == 0 ? ahead * ahead / 32 : moved * moved / 32;
        weights[i] = static_cast<T>(weight);
        left -= weight;
    }
    weights[middle] = static_cast<T>(left);
}

/// Weighted count of the lit texels under a window.
///
/// @param fetch      ivec2 texel -> stored depth; called row.touched()^2 times, texels may lie as far outside the map
///                   as half of them
/// @param coord      receiver in texels, the first texel's centre is (0.5, 0.5); outside texel space, or NaN: all lit
/// @param receiver   depth, biased; beyond the far plane: lit; NaN is in shadow
/// @param row        as make_window_row makes it
/// @return           0 .. row.whole^2
/// @formula          sum of w_i w_j [receiver <= fetch(first + (i, j))], w by window_weights; first = texel - size / 2,
///                   where 256 texel + moved = floor(256 coord), less 128 for an odd size
/// @exactness        A: whole numbers up to 2^24
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T window_sum(Fetch&& fetch, glm::vec<2, T> coord, T receiver, const window_row& row,
                           Compare is_lit = {}) {
    const T whole = static_cast<T>(row.whole);
    if (!is_compared(coord, receiver, is_lit)) return whole * whole;
    const glm::vec<2, T> x = glm::floor(coord * T(256)) - T(row.size % 2 ? 128 : 0);
    const glm::vec<2, T> texel = glm::floor(x * T(1.0 / 256.0)), moved = x - texel * T(256);
    const glm::ivec2 first = glm::ivec2(texel) - row.size / 2;
    T columns[max_window + 1], rows[max_window + 1];
    window_weights(row, static_cast<int>(moved.x), columns);
    window_weights(row, static_cast<int>(moved.y), rows);
    T sum(0);
    for (int j = 0; j <= row.size; ++j) {
        T in_row(0);
        for (int i = 0; i <= row.size; ++i)
            in_row += columns[i] * lit(fetch, first + glm::ivec2(i, j), receiver, is_lit);
        sum += rows[j] * in_row;
    }
    return sum;
}

/// Lit share of a window; arguments as for window_sum.
/// @return        visibility: 0 in shadow, 1 lit
/// @formula       window_sum / row.whole^2
/// @exactness     A where row.whole is a power of two; else B: the sum is exact, its product with row.scale rounds once
/// @cite          Reeves, Salesin, Cook: Rendering antialiased shadows with depth maps, SIGGRAPH 1987
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T window(Fetch&& fetch, glm::vec<2, T> coord, T receiver, const window_row& row, Compare is_lit = {}) {
    const T sum = window_sum(fetch, coord, receiver, row, is_lit), whole = static_cast<T>(row.whole);
    if (!(sum < whole * whole)) return T(1);  // what a product of a rounded scale is only to nearest
    if constexpr (std::same_as<T, double>) return sum * row.scale_of_doubles;
    else return sum * row.scale;
}

namespace glsl {
namespace detail {

/// The parameter of a window's i-th weight.
constexpr int window_parameter(int size, int i) { return i < size - 1 - i ? i : size - 1 - i; }

/// What the i-th of the touched texels weighs, floors left aside.
[[nodiscard]] inline std::string window_weight(int size, int i) {
    const constant ahead{'a', window_parameter(size, i)}, behind{'b', window_parameter(size, i - 1)};
    return filled(i == 0 ? "r * k$a" : (i == size ? "s * k$b" : "r * k$a + s * k$b"), {ahead, behind});
}

template <int Size>
[[nodiscard]] std::string window_sum_text() {
    constexpr int size = Size, middle = size / 2;
    std::string text = filled(R"GLSL(
// umbrage_window_sum$n: weighted count of the lit texels under weights that slide over the map, whole
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased;   steps  of a texel, a power of two up to 256
//   k0 .. k$m   weights from the edge to the middle one; the others mirror them. Steps times their sum, a whole number
//              up to 4096, squared is what is wholly lit
UMBRAGE_HIGHP float umbrage_window_sum$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                        UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float steps, UMBRAGE_HIGHP float k0,
                                        UMBRAGE_HIGHP float k1)GLSL",
                              {{'n', size}, {'m', middle}});
    for (int i = 2; i <= middle; ++i) append(text, ", UMBRAGE_HIGHP float k$i", {{'i', i}});
    text += R"GLSL() {
    bool compared = umbrage_is_compared(coord, receiver);  // no branch: fetches overlap
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0) - 128.0 : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    UMBRAGE_HIGHP vec2 s = floor((x - texel * 256.0) * (1.0 / 256.0) * steps);
    UMBRAGE_HIGHP vec2 r = steps - s;
    UMBRAGE_HIGHP float whole = steps * (k0)GLSL";
    for (int i = 1; i < size; ++i) append(text, " + k$i", {{'i', window_parameter(size, i)}});
    text += ");\n";
    for (int i = 0; i <= size; ++i)
        if (i != middle)
            append(text, "    UMBRAGE_HIGHP vec2 w$i = floor($w);\n", {{'i', i}, {'w', 0, window_weight(size, i)}});
    append(text, "    UMBRAGE_HIGHP vec2 w$m = whole - (w0", {{'m', middle}});
    for (int i = 1; i <= size; ++i)
        if (i != middle) append(text, " + w$i", {{'i', i}});
    append(text, ");\n    UMBRAGE_HIGHP vec2 first = texel - $m.0;\n    UMBRAGE_HIGHP float n = 0.0;\n",
           {{'m', middle}});
    for (int j = 0; j <= size; j += 2) {
        for (int i = 0; i <= size; i += 2)
            append(text, "    $t$a = umbrage_lit_2x2(map, size, first + vec2($i.0, $j.0), receiver);\n",
                   {{'t', 0, j == 0 ? "UMBRAGE_HIGHP vec4 " : ""}, {'a', 0, {&"abcd"[i / 2], 1}}, {'i', i}, {'j', j}});
        for (int row : {0, 1}) {
            append(text, "    n += w$j.y * (w0.x * a.$c", {{'j', j + row}, {'c', 0, {&"xz"[row], 1}}});
            for (int i = 1; i <= size; ++i)
                append(text, " + w$i.x * $a.$c",
                       {{'i', i}, {'a', 0, {&"abcd"[i / 2], 1}}, {'c', 0, {&"xyzw"[2 * row + i % 2], 1}}});
            text += ");\n";
        }
    }
    text += "    return compared ? n : whole * whole;\n}\n";
    return text;
}

}  // namespace detail

template <int Size>
inline constexpr snippet window_sum{.name = Size == 3 ? "window_sum3" : (Size == 5 ? "window_sum5" : "window_sum7"),
                                    .summary = Size == 3   ? "weighted count of lit texels under a window of 3 x 3"
                                               : Size == 5 ? "weighted count of lit texels under a window of 5 x 5"
                                                           : "weighted count of lit texels under a window of 7 x 7",
                                    .exactness = tier::a,
                                    .needs = list<&is_compared, &lit_2x2>,
                                    .source = detail::window_sum_text<Size>};

inline constexpr auto window_snippets = list<&window_sum<3>, &window_sum<5>, &window_sum<7>>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/pcf/window_hardware.hpp
// Windows by the sampler: a look-up between two texels weighs both, and where it lies says how much of either. So a
// window of 3 x 3 weights takes 4 look-ups, one of 5 x 5 takes 9, one of 7 x 7 takes 16.
//
//     constexpr umbrage::window_row row = umbrage::castano_row<5>;
//     float visibility = umbrage::window_hardware(umbrage::clamped(map), coord, depth - bias, row);
//     // in a shader umbrage_window_hardware5(map, size, coord, receiver, 1.0, 3.0, 4.0)
//
// Maps and samplers are as for pcf_2x2_hardware.hpp.
//

namespace umbrage {

/// Window of weights that slides over the map, in floats: by so much of a texel as the receiver lies beyond it.
///
/// The two texels of a look-up divide between them what it weighs. A sampler whose fractions are off by up to e moves
/// no more than e of that from one to the other: of all weights of an axis e, of both axes 2 e.
///
/// @param fetch      ivec2 texel -> stored depth; called row.touched()^2 times, texels may lie as far outside the map
///                   as half of them
/// @param coord      receiver in texels, the first texel's centre is (0.5, 0.5); outside texel space, or NaN: lit
/// @param receiver   depth, biased; beyond the far plane: lit; NaN is in shadow
/// @param row        of weights above zero, 3, 5 or 7 in a shader; its steps, and that it is quadratic, do not count
/// @return           visibility, 0 in shadow, 1 lit
/// @formula          sum of w_i w_j [receiver <= fetch(texel + (i, j) - size / 2)] / (sum of the weights)^2,
///                   w_i = K_i + s (K_(i-1) - K_i), texel + s = coord - 1/2 for an odd size, coord for an even
/// @exactness        C, within 1/128 in a shader: e is 1/256 of a sampler that rounds or truncates to it; on top its
///                   coordinates round, by 2^-10 texel in a map of 8192
/// @cite             Castano: Shadow mapping summary, part 1, 2013
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T window_hardware(Fetch&& fetch, glm::vec<2, T> coord, T receiver, const window_row& row,
                                Compare is_lit = {}) {
    if (!is_compared(coord, receiver, is_lit)) return T(1);
    const glm::vec<2, T> x = coord - T(row.size % 2 ? 0.5 : 0.0), texel = glm::floor(x), s = x - texel;
    const glm::ivec2 first = glm::ivec2(texel) - row.size / 2;
    const auto weight = [&](int i, T moved) {
        const T here(row.weight(i)), before(row.weight(i - 1));
        return here + moved * (before - here);
    };
    T sum(0), whole(0);
    for (int i = 0; i < row.size; ++i) whole += T(row.weight(i));
    for (int j = 0; j <= row.size; ++j)
        for (int i = 0; i <= row.size; ++i)
            sum += weight(i, s.x) * weight(j, s.y) * lit(fetch, first + glm::ivec2(i, j), receiver, is_lit);
    return glm::min(sum / (whole * whole), T(1));  // weights round
}

namespace glsl {
namespace detail {

/// What an axis' texels 2 k and 2 k + 1 weigh together (w), and the latter alone (b).
[[nodiscard]] inline std::string pair_weights(int size, int k) {
    const constant number{'k', k}, before{'a', window_parameter(size, 2 * k - 1)},
        here{'b', window_parameter(size, 2 * k)}, after{'c', window_parameter(size, 2 * k + 1)};
    if (k == 0)
        return filled(
            "    UMBRAGE_HIGHP vec2 b$k = k$c + s * (k$b - k$c);\n"
            "    UMBRAGE_HIGHP vec2 w$k = k$b + k$c - s * k$c;\n",
            {number, here, after});
    if (2 * k + 1 == size)
        return filled(
            "    UMBRAGE_HIGHP vec2 b$k = s * k$b;\n"
            "    UMBRAGE_HIGHP vec2 w$k = k$b + s * k$a;\n",
            {number, before, here});
    if (2 * k == size / 2)  // the middle two of all, wherever the window is
        return filled(
            "    UMBRAGE_HIGHP vec2 b$k = k$c + s * (k$b - k$c);\n"
            "    UMBRAGE_HIGHP vec2 w$k = vec2(k$b + k$c, k$b + k$c);\n",
            {number, here, after});
    return filled(
        "    UMBRAGE_HIGHP vec2 b$k = k$c + s * (k$b - k$c);\n"
        "    UMBRAGE_HIGHP vec2 w$k = k$b + k$c + s * (k$a - k$c);\n",
        {number, before, here, after});
}

/// For each look-up along an axis: what the farther of its texels weighs, what both do, and where it lies.
template <int Size>
[[nodiscard]] std::string window_hardware_text() {
    constexpr int size = Size;
    std::string text = filled(R"GLSL(
// umbrage_window_hardware$n: lit share under weights that slide over the map, by the sampler; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased;   k0 .. k$m  weights from the edge to the middle one; the others mirror them
UMBRAGE_HIGHP float umbrage_window_hardware$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                             UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float k0,
                                             UMBRAGE_HIGHP float k1)GLSL",
                              {{'n', size}, {'m', size / 2}});
    for (int i = 2; i <= size / 2; ++i) append(text, ", UMBRAGE_HIGHP float k$i", {{'i', i}});
    text += R"GLSL() {
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? coord - 0.5 : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 texel = floor(x);
    UMBRAGE_HIGHP vec2 s = x - texel;
    UMBRAGE_HIGHP float whole = k0)GLSL";
    for (int i = 1; i < size; ++i) append(text, " + k$i", {{'i', window_parameter(size, i)}});
    text += ";\n";
    for (int k = 0; 2 * k <= size; ++k) {
        const int texel = 2 * k - size / 2;
        text += pair_weights(size, k);
        append(text, "    UMBRAGE_HIGHP vec2 p$k = (texel $s $t.5 + b$k / w$k) / size;\n",
               {{'k', k}, {'s', 0, texel < 0 ? "-" : "+"}, {'t', texel < 0 ? -texel - 1 : texel}});
    }
    text += "    UMBRAGE_HIGHP float n = 0.0;\n";
    for (int j = 0; 2 * j <= size; ++j) {
        append(text, "    $trow = 0.0;\n", {{'t', 0, j == 0 ? "UMBRAGE_HIGHP float " : ""}});
        for (int i = 0; 2 * i <= size; ++i)
            append(text, "    row += w$i.x * umbrage_lit_at(map, size, vec2(p$i.x, p$j.y), receiver);\n",
                   {{'i', i}, {'j', j}});
        append(text, "    n += w$j.y * row;\n", {{'j', j}});
    }
    text += R"GLSL(    UMBRAGE_HIGHP float share = clamp(n / (whole * whole), 0.0, 1.0);
    UMBRAGE_HIGHP float visibility = umbrage_before_far(receiver) ? share : 0.0;
    return compared ? visibility : 1.0;
}
)GLSL";
    return text;
}

}  // namespace detail

template <int Size>
inline constexpr snippet window_hardware{
    .name = Size == 3 ? "window_hardware3" : (Size == 5 ? "window_hardware5" : "window_hardware7"),
    .summary = Size == 3   ? "window of 3 x 3 by 4 look-ups of a comparison sampler with a linear filter"
               : Size == 5 ? "window of 5 x 5 by 9 of them"
                           : "window of 7 x 7 by 16 of them",
    .exactness = tier::c,
    .within = 1.0f / 128.0f,
    .needs = list<&is_compared, &before_far, &lit_at>,
    .source = detail::window_hardware_text<Size>};

inline constexpr auto window_hardware_snippets = list<&window_hardware<3>, &window_hardware<5>, &window_hardware<7>>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/pcf/windows.hpp
// The library's sliding windows, as functions and as values of one filter:
//
//     float visibility = umbrage::binomial<5>(umbrage::clamped(map), coord, depth - bias);
//     umbrage::visibility(map, encoding, receivers, umbrage::filters::binomial<5>, out);
//
//     tent<2>, tent<3>, tent<7>    1 1; 1 2 1; 1 2 3 4 3 2 1
//     binomial<5>, binomial<7>     1 4 6 4 1; 1 6 15 20 15 6 1: near a Gaussian of 1.1 and 1.3 texels
//     castano<5>, castano<7>       1 3 4 3 1; 1 5 12 16 12 5 1: what shaders merge into 9 and 16 filtered comparisons
//     castano_dyadic<5>            5 16 22 16 5: within 1.7 % of castano<5>, and exact, as binomial<7> is to castano<7>
//     quadratic_b_spline           of 3 x 3 texels: edges without a kink

namespace umbrage {

/// Rows with weights in sixteenths, so that what they add up to is a power of two. tent_row: each weight one step from
/// its neighbours.
template <int Size>
inline constexpr window_row tent_row = [] {
    static_assert(Size == 2 || Size == 3 || Size == 7, "of other sizes the weights add up to no power of two");
    constexpr float step = Size == 2 ? 8.0f : (Size == 3 ? 4.0f : 1.0f);
    return make_window_row(Size, {step, 2 * step, 3 * step, 4 * step});
}();

/// Binomial coefficients.
template <int Size>
inline constexpr window_row binomial_row = [] {
    static_assert(Size == 5 || Size == 7);
    return Size == 5 ? make_window_row(5, {1, 4, 6}) : make_window_row(7, {0.25f, 1.5f, 3.75f, 5});
}();

/// Castano's, whose sums are 12 and 52.
template <int Size>
inline constexpr window_row castano_row = [] {
    static_assert(Size == 5 || Size == 7);
    return Size == 5 ? make_window_row(5, {1, 3, 4}) : make_window_row(7, {1, 5, 12, 16}, 64);
}();

/// 5 16 22 16 5.
template <int Size>
inline constexpr window_row castano_dyadic_row = [] {
    static_assert(Size == 5);
    return make_window_row(5, {1.25f, 4, 5.5f});
}();

/// Weights (1 - f)^2 / 2, 3/4 - (f - 1/2)^2 and f^2 / 2 within 3.9e-4.
inline constexpr window_row quadratic_b_spline_row = [] {
    window_row row = make_window_row(2, {8});
    row.quadratic = true;
    return row;
}();

/// window() of the rows of that name; its arguments without the row.
/// @exactness   A
template <int Size, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T tent(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    return window(fetch, coord, receiver, tent_row<Size>, is_lit);
}
/// @exactness   A
template <int Size, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T binomial(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    return window(fetch, coord, receiver, binomial_row<Size>, is_lit);
}
/// @exactness   B: window_sum is exact, its product with 1 / 144 or 1 / 2704 rounds once
/// @cite        Castano: Shadow mapping summary, part 1, 2013
template <int Size, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T castano(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    return window(fetch, coord, receiver, castano_row<Size>, is_lit);
}
/// @exactness   A
template <int Size, real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T castano_dyadic(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    return window(fetch, coord, receiver, castano_dyadic_row<Size>, is_lit);
}
/// @exactness   A
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T quadratic_b_spline(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    return window(fetch, coord, receiver, quadratic_b_spline_row, is_lit);
}

namespace glsl {
namespace detail {

/// A row's text: window_sum with its numbers, and what becomes of it.
[[nodiscard]] inline std::string window_text(std::string_view name, int size, std::string_view weights,
                                             std::string_view numbers,
                                             std::string_view share = "n * (1.0 / 16777216.0)") {
    return filled(R"GLSL(
// umbrage_$f$n: lit share under $n x $n weights, $w, that slide over the map; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_$f$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                 UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float n = umbrage_window_sum$n(map, size, coord, receiver, $k);
    return $s;
}
)GLSL",
                  {{'f', 0, name}, {'n', size}, {'w', 0, weights}, {'k', 0, numbers}, {'s', 0, share}});
}

/// Of the windows of 3 x 3 texels: what the neighbours before and behind weigh, in 1/4096.
[[nodiscard]] inline std::string text_3x3(std::string_view name, std::string_view what, std::string_view before,
                                          std::string_view behind) {
    return filled(R"GLSL(
// umbrage_$f: lit share of 3 x 3 texels, $w; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_$f(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                               UMBRAGE_HIGHP float receiver) {
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec2 x = compared ? floor(coord * 256.0) : vec2(0.0, 0.0);  // no branch: fetches overlap
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    UMBRAGE_HIGHP vec2 s = x - texel * 256.0;
    UMBRAGE_HIGHP vec2 r = 256.0 - s;
    UMBRAGE_HIGHP vec2 w0 = $b;
    UMBRAGE_HIGHP vec2 w2 = $e;
    UMBRAGE_HIGHP vec2 w1 = 4096.0 - w0 - w2;
    UMBRAGE_HIGHP vec4 a = umbrage_lit_2x2(map, size, texel - 1.0, receiver);
    UMBRAGE_HIGHP vec4 b = umbrage_lit_2x2(map, size, texel + vec2(1.0, -1.0), receiver);
    UMBRAGE_HIGHP vec4 c = umbrage_lit_2x2(map, size, texel + vec2(-1.0, 1.0), receiver);
    UMBRAGE_HIGHP vec4 d = umbrage_lit_2x2(map, size, texel + vec2(1.0, 1.0), receiver);
    UMBRAGE_HIGHP float n = w0.y * (w0.x * a.x + w1.x * a.y + w2.x * b.x);
    n += w1.y * (w0.x * a.z + w1.x * a.w + w2.x * b.z);
    n += w2.y * (w0.x * c.x + w1.x * c.y + w2.x * d.x);
    return compared ? n * (1.0 / 16777216.0) : 1.0;
}
)GLSL",
                  {{'f', 0, name}, {'w', 0, what}, {'b', 0, before}, {'e', 0, behind}});
}

/// What a family's texts need, by the size of their window.
template <int Size>
inline constexpr auto window_needs = list<&window_sum<Size>>;
template <>
inline constexpr auto window_needs<2> = list<&is_compared, &lit_2x2>;

}  // namespace detail

template <int Size>
[[nodiscard]] std::string tent_text() {
    if constexpr (Size == 2) return detail::text_3x3("tent2", "the window 1 1", "r * 8.0", "s * 8.0");
    else if constexpr (Size == 3) return detail::window_text("tent", 3, "1 2 1", "256.0, 4.0, 8.0");
    else return detail::window_text("tent", 7, "1 2 3 4 3 2 1", "256.0, 1.0, 2.0, 3.0, 4.0");
}
template <int Size>
inline constexpr snippet tent{
    .name = Size == 2 ? "tent2" : (Size == 3 ? "tent3" : "tent7"),
    .summary = Size == 2 ? "sliding window 1 1" : (Size == 3 ? "sliding window 1 2 1" : "sliding window 1 2 3 4 3 2 1"),
    .exactness = tier::a,
    .needs = detail::window_needs<Size>,
    .source = tent_text<Size>};

template <int Size>
[[nodiscard]] std::string binomial_text() {
    return Size == 5 ? detail::window_text("binomial", 5, "1 4 6 4 1", "256.0, 1.0, 4.0, 6.0")
                     : detail::window_text("binomial", 7, "1 6 15 20 15 6 1", "256.0, 0.25, 1.5, 3.75, 5.0");
}
template <int Size>
inline constexpr snippet binomial{.name = Size == 5 ? "binomial5" : "binomial7",
                                  .summary = Size == 5 ? "sliding window 1 4 6 4 1" : "sliding window 1 6 15 20 15 6 1",
                                  .exactness = tier::a,
                                  .needs = detail::window_needs<Size>,
                                  .source = binomial_text<Size>};

template <int Size>
[[nodiscard]] std::string castano_text() {
    return Size == 5 ? detail::window_text("castano", 5, "1 3 4 3 1", "256.0, 1.0, 3.0, 4.0",
                                           "n < 9437184.0 ? n * (1.0 / 65536.0) * 0.00694444450 : 1.0")
                     : detail::window_text("castano", 7, "1 5 12 16 12 5 1", "64.0, 1.0, 5.0, 12.0, 16.0",
                                           "n < 11075584.0 ? n * (1.0 / 4096.0) * 0.000369822490 : 1.0");
}
template <int Size>
inline constexpr snippet castano{.name = Size == 5 ? "castano5" : "castano7",
                                 .summary = Size == 5 ? "sliding window 1 3 4 3 1" : "sliding window 1 5 12 16 12 5 1",
                                 .exactness = tier::b,
                                 .needs = detail::window_needs<Size>,
                                 .source = castano_text<Size>};

template <int Size>
[[nodiscard]] std::string castano_dyadic_text() {
    return detail::window_text("castano_dyadic", 5, "5 16 22 16 5", "256.0, 1.25, 4.0, 5.5");
}
template <int Size>
inline constexpr snippet castano_dyadic{.name = "castano_dyadic5",
                                        .summary = "sliding window 5 16 22 16 5",
                                        .exactness = tier::a,
                                        .needs = detail::window_needs<Size>,
                                        .source = castano_dyadic_text<Size>};

[[nodiscard]] inline std::string quadratic_b_spline_text() {
    return detail::text_3x3("quadratic_b_spline", "weighed by the quadratic B-spline", "floor(r * r * (1.0 / 32.0))",
                            "floor(s * s * (1.0 / 32.0))");
}
inline constexpr snippet quadratic_b_spline{.name = "quadratic_b_spline",
                                            .summary = "quadratic B-spline of 3 x 3 texels",
                                            .exactness = tier::a,
                                            .needs = detail::window_needs<2>,
                                            .source = quadratic_b_spline_text};

}  // namespace glsl

namespace filters {

/// A sliding window as a value: the library's by name below, or with a row of one's own.
struct window {
    window_row row = tent_row<3>;
    comparison is_lit{};
    std::string_view name = "window";
    const glsl::snippet* snippet = nullptr;  ///< of the same result; none for rows of one's own

    static const std::array<window, 9> values;  ///< the library's

    [[nodiscard]] constexpr float reach() const { return row.reach(); }
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::window(fetch, coord, receiver, row, is_lit);
    }
};

/// The same result; for images of receivers it first asks, for all texels of the window, whether they are all lit or
/// all in shadow. Pays off for large windows, and where shadows have more inside than border.
///
///     umbrage::filters::hierarchical_window filter{umbrage::filters::binomial<7>};
struct hierarchical_window : window {};

template <int Size>
inline constexpr window tent{tent_row<Size>, {}, glsl::tent<Size>.name, &glsl::tent<Size>};
template <int Size>
inline constexpr window binomial{binomial_row<Size>, {}, glsl::binomial<Size>.name, &glsl::binomial<Size>};
template <int Size>
inline constexpr window castano{castano_row<Size>, {}, glsl::castano<Size>.name, &glsl::castano<Size>};
template <int Size>
inline constexpr window castano_dyadic{
    castano_dyadic_row<Size>, {}, glsl::castano_dyadic<Size>.name, &glsl::castano_dyadic<Size>};
inline constexpr window quadratic_b_spline{
    quadratic_b_spline_row, {}, glsl::quadratic_b_spline.name, &glsl::quadratic_b_spline};

inline constexpr std::array<window, 9> window::values{
    tent<2>, tent<3>, quadratic_b_spline, binomial<5>, castano_dyadic<5>, castano<5>, binomial<7>, tent<7>, castano<7>};

}  // namespace filters
}  // namespace umbrage

// ---- umbrage/filter/prefiltered/exp2.hpp
// 2^y alike everywhere, which no language promises of its own exp2: what exponential shadow maps warp depth with.
//
//     float warped = umbrage::exp2_polynomial(40.0f * depth);  // as fine as the float
//     float coarse = umbrage::exp2_steps(40.0f * depth);       // 12 bits, the same bits on every implementation
//
// Neither falls where y grows; both give powers of two at whole numbers. The square of a coarse one is exact, from
// 2^-63 on.

namespace umbrage {

/// @param n       whole number, -64 to 63
/// @return        2^n
/// @exactness     A
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T power_of_two(T n) {
    if constexpr (sizeof(T) == 4) return detail::bit_cast<T>((static_cast<std::int32_t>(n) + 127) << 23);
    else return detail::bit_cast<T>((static_cast<std::int64_t>(n) + 1023) << 52);
}

namespace detail {

/// c ? a : b on the bits, which compilers vectorise where they do not vectorise that.
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T pick(bool c, T a, T b) {
    using bits = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
    const bits mask = -bits(c);
    return detail::bit_cast<T>((detail::bit_cast<bits>(a) & mask) | (detail::bit_cast<bits>(b) & ~mask));
}

/// What the powers are taken of: NaN counts as -64.
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T clamp_exponent(T y) {
    const T below = pick(y < T(63), y, T(63));
    return pick(bool(int(below > T(-64)) & int(!is_nan(y))), below, T(-64));
}

/// floor of |v| < 2^31.
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T floor_small(T v) {
    const auto toward_zero = static_cast<std::int32_t>(v);
    return static_cast<T>(toward_zero - std::int32_t(static_cast<T>(toward_zero) > v));
}

}  // namespace detail

/// @param y       outside of -64 to 63 the nearer end counts, of NaN -64
/// @return        2^y: never falls where y grows; 2^y itself of whole numbers
/// @formula       2^n (1 + c1 f + c2 f^2 + .. + c5 f^5) by Horner's scheme, n = floor(y), f = y - n; the polynomial is
///                2 at f = 1
/// @exactness     B;  off by at most 1.8e-7 of the power, over all f = k / 2^24
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T exp2_polynomial(T y) {
    const T x = detail::clamp_exponent(y), n = detail::floor_small(x), f = x - n;
    T p = T(16143224 * 0x1p-33) * f + T(9654007 * 0x1p-30);
    p = p * f + T(14983712 * 0x1p-28);
    p = p * f + T(16116816 * 0x1p-26);
    p = p * f + T(11629156 * 0x1p-24);
    p = p * f + T(1);
    return p * power_of_two(n);
}

/// @param y       outside of -64 to 63 the nearer end counts, of NaN -64
/// @return        2^y in steps: never falls where y grows; 2^y itself of whole numbers; a whole number below 2^12
///                times a power of two
/// @formula       m 2^(n - 11), x = floor(2048 y), n = floor(x / 2048), f = x - 2048 n, g = floor(f (2048 - f) / 256),
///                r = 1251 + floor(314 f / 2048), m = 2048 + f - floor((g r + 2^14) / 2^15)
/// @exactness     A;  off by at most 3.1e-4 of the power at the steps, over all of them; between two it stays with the
///                lower one
template <real T>
[[nodiscard]] T exp2_steps(T y) {
    const T x = std::floor(detail::clamp_exponent(y) * T(2048));
    const T n = std::floor(x * T(0x1p-11)), f = x - n * T(2048);
    const T g = std::floor(f * (T(2048) - f) * T(0x1p-8)), r = T(1251) + std::floor(f * T(314) * T(0x1p-11));
    const T m = T(2048) + f - std::floor((g * r + T(16384)) * T(0x1p-15));
    return m * T(0x1p-11) * power_of_two(n);
}

namespace glsl {

inline constexpr snippet power_of_two{
    .name = "power_of_two",
    .summary = "2^n of whole numbers -64 to 63",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_power_of_two: 2^n of a whole number n, -64.0 to 63.0
UMBRAGE_HIGHP float umbrage_power_of_two(UMBRAGE_HIGHP float n) {
#if __VERSION__ >= 300
    UMBRAGE_HIGHP uint exponent = uint(n + 127.0);
    return uintBitsToFloat(exponent << 23);
#else
    UMBRAGE_HIGHP float x = n < 0.0 ? n + 64.0 : n;
    UMBRAGE_HIGHP float p = 1.0;
    p = n < 0.0 ? p * (1.0 / 4294967296.0) * (1.0 / 4294967296.0) : p;
    p = x >= 32.0 ? p * 4294967296.0 : p;
    x = x >= 32.0 ? x - 32.0 : x;
    p = x >= 16.0 ? p * 65536.0 : p;
    x = x >= 16.0 ? x - 16.0 : x;
    p = x >= 8.0 ? p * 256.0 : p;
    x = x >= 8.0 ? x - 8.0 : x;
    p = x >= 4.0 ? p * 16.0 : p;
    x = x >= 4.0 ? x - 4.0 : x;
    p = x >= 2.0 ? p * 4.0 : p;
    x = x >= 2.0 ? x - 2.0 : x;
    return x >= 1.0 ? p * 2.0 : p;
#endif
}
)GLSL",
};

inline constexpr snippet exp2_polynomial{
    .name = "exp2_polynomial",
    .summary = "2^y to 1.8e-7 of it",
    .exactness = tier::b,
    .needs = list<&power_of_two>,
    .source = R"GLSL(
// umbrage_exp2_polynomial: 2^y, off by at most 1.8e-7 of it
//   y  outside of -64.0 to 63.0 the nearer end counts, of NaN -64.0
UMBRAGE_HIGHP float umbrage_exp2_polynomial(UMBRAGE_HIGHP float y) {
    UMBRAGE_HIGHP float x = y > -64.0 ? min(y, 63.0) : -64.0;
    UMBRAGE_HIGHP float n = floor(x);
    UMBRAGE_HIGHP float f = x - n;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float p = 0.00187931862 * f + 0.00899099465;
    p = p * f + 0.0558186769;
    p = p * f + 0.240159273;
    p = p * f + 0.693151712;
    p = p * f + 1.0;
    return p * umbrage_power_of_two(n);
}
)GLSL",
};

inline constexpr snippet exp2_steps{
    .name = "exp2_steps",
    .summary = "2^y in steps of 12 bits",
    .exactness = tier::a,
    .needs = list<&power_of_two>,
    .source = R"GLSL(
// umbrage_exp2_steps: 2^y, a whole number below 2^12 times a power of two, y rounded down to 1/2048
//   y  outside of -64.0 to 63.0 the nearer end counts, of NaN -64.0
UMBRAGE_HIGHP float umbrage_exp2_steps(UMBRAGE_HIGHP float y) {
    UMBRAGE_HIGHP float x = floor((y > -64.0 ? min(y, 63.0) : -64.0) * 2048.0);
    UMBRAGE_HIGHP float n = floor(x * (1.0 / 2048.0));
    UMBRAGE_HIGHP float f = x - n * 2048.0;
    UMBRAGE_HIGHP float g = floor(f * (2048.0 - f) * (1.0 / 256.0));
    UMBRAGE_HIGHP float r = 1251.0 + floor(f * 314.0 * (1.0 / 2048.0));
    UMBRAGE_HIGHP float m = 2048.0 + f - floor((g * r + 16384.0) * (1.0 / 32768.0));
    return m * (1.0 / 2048.0) * umbrage_power_of_two(n);
}
)GLSL",
};

inline constexpr auto exp2_snippets = list<&power_of_two, &exp2_polynomial, &exp2_steps>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/prefiltered/chebyshev.hpp
// What mean and variance of depths say of how many of them are lit: the one-sided inequality of Chebyshev, and how to
// cut off the light that it lets through.
//
//     float lit = umbrage::chebyshev(moments, receiver, 1e-6f);
//     lit = umbrage::bleed_cut(lit, 0.2f);
//
// Before the cut no receiver is darker than the share of depths that light it. Behind casters that lie behind each
// other it is lighter: at a distance b behind the farther of two that are a apart by up to (a / (a + 2 b))^2.

namespace umbrage {

/// Depth that grows with the distance from the light, whichever way the map's does: prefiltered maps hold it.
/// @param far       1, or 0 where depth is reversed
/// @formula         1 - depth where depth is reversed, else depth
/// @exactness       B
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T forward_depth(T depth, T far = T(1)) {
    return detail::pick(far < T(0.5), T(1) - depth, depth);
}

/// Share of depths that may be as far as the receiver or farther, at most.
///
/// @param m              mean of the depths, mean of their squares
/// @param receiver       on the same scale
/// @param min_variance   >= 0, no NaN; what rounding leaves of the variance of equal depths must stay below it
/// @return               visibility, 0 to 1; 0 where something is NaN, or where depths without variance lie before the
///                       receiver and min_variance is 0
/// @formula              receiver <= m.x ? 1 : v / (v + (receiver - m.x)^2), v = max(m.y - m.x^2, min_variance)
/// @exactness            C, 1 ulp: a division; of depths up to 1 within (1 / (4 min_variance) + 4) 2^-24 of the formula
///                       in reals
/// @cite                 Donnelly, Lauritzen: Variance shadow maps, I3D 2006
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T chebyshev(glm::vec<2, T> m, T receiver, T min_variance) {
    const T difference = m.y - m.x * m.x;
    const T variance = detail::pick(difference > min_variance, difference, min_variance);
    const T distance = receiver - m.x;
    const T p = variance / (variance + distance * distance);
    const T dark = detail::pick(bool(int(p > T(0)) & int(!is_nan(p))), detail::pick(p < T(1), p, T(1)), T(0));
    return detail::pick(bool(int(receiver <= m.x) & int(!is_nan(receiver)) & int(!is_nan(m.x))), T(1), dark);
}

/// Visibility without its least values, stretched to 0 to 1: light that bleeds through is gone, shadows' edges are
/// darker and harder.
/// @param amount      what becomes 0, 0 to 1; 0.2 is usual
/// @formula           visibility > amount ? (visibility - amount) / (1 - amount) : 0
/// @exactness         C, 1 ulp: a division
template <real T>
[[nodiscard]] constexpr T bleed_cut(T visibility, T amount) {
    const bool above = !is_nan(visibility) && !is_nan(amount) && visibility > amount;
    return above ? (visibility - amount) / (T(1) - amount) : T(0);
}

namespace glsl {

inline constexpr snippet forward_depth{
    .name = "forward_depth",
    .summary = "depth that grows with distance",
    .exactness = tier::b,
    .needs = list<&cleared_depth>,
    .source = R"GLSL(
// umbrage_forward_depth: depth that grows with distance, 1.0 - depth where the map's is reversed
UMBRAGE_HIGHP float umbrage_forward_depth(UMBRAGE_HIGHP float depth) {
    return umbrage_cleared_depth() < 0.5 ? 1.0 - depth : depth;
}
)GLSL",
};

inline constexpr snippet chebyshev{
    .name = "chebyshev",
    .summary = "most that mean and variance let be lit",
    .exactness = tier::c,
    .ulp = 1,
    .source = R"GLSL(
// umbrage_chebyshev: share of depths that may be as far as the receiver or farther, at most; 0.0 where something is NaN
//   m  mean of the depths, mean of their squares;   receiver  on the same scale;   min_variance  0.0 or more
UMBRAGE_HIGHP float umbrage_chebyshev(UMBRAGE_HIGHP vec2 m, UMBRAGE_HIGHP float receiver,
                                      UMBRAGE_HIGHP float min_variance) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float difference = m.y - m.x * m.x;
    UMBRAGE_HIGHP float variance = difference > min_variance ? difference : min_variance;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float distance = receiver - m.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float sum = variance + distance * distance;
    UMBRAGE_HIGHP float p = variance / sum;
    return receiver <= m.x ? 1.0 : (p > 0.0 ? min(p, 1.0) : 0.0);  // a GPU's v / v may be more than 1.0
}
)GLSL",
};

inline constexpr snippet bleed_cut{
    .name = "bleed_cut",
    .summary = "visibility without its least values",
    .exactness = tier::c,
    .ulp = 1,
    .source = R"GLSL(
// umbrage_bleed_cut: visibility from amount to 1.0 stretched to 0.0 to 1.0, so that less light bleeds through
UMBRAGE_HIGHP float umbrage_bleed_cut(UMBRAGE_HIGHP float visibility, UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float stretched = (visibility - amount) / (1.0 - amount);
    return visibility > amount ? stretched : 0.0;
}
)GLSL",
};

inline constexpr auto chebyshev_snippets = list<&forward_depth, &chebyshev, &bleed_cut>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/prefiltered/esm.hpp
// Exponential shadow maps: a texel holds a power of depth, which may be blurred, halved and filtered by the sampler.
//
//     const auto esm = umbrage::make_esm({.exponent = 40.0f});  // throws where floats would overflow
//     float texel = umbrage::encode_esm(depth, esm.exponent);
//     float visibility = umbrage::decode_esm(blurred, receiver, esm.exponent);
//
// A receiver is as light as the mean of what its texels let through, 2^(2 exponent (depth - receiver)) each, at most 1:
// a caster lets 1/100 through that is 3.3 / exponent nearer. One lit texel far behind the receiver outweighs all its
// casters.

namespace umbrage {

/// What a prefiltered map's texels are stored in.
enum class float_store { half, single };

/// Depth on the scale of exponential shadow maps.
/// @param depth      in [0, 1], growing with distance
/// @param exponent   -63 to 63
/// @return           2^-exponent to 2^exponent
/// @formula          exp2_polynomial(exponent (2 depth - 1))
/// @exactness        B
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T warp_depth(T depth, T exponent) {
    return exp2_polynomial(exponent * (depth * T(2) - T(1)));
}

/// @param depth     clamped to [0, 1]; NaN counts as far, as a cleared texel does: 2^exponent
/// @param exponent  0 to 63
/// @formula         warp_depth(forward_depth)
/// @exactness       B
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T encode_esm(T depth, T exponent, T far = T(1)) {
    return warp_depth(forward_depth(saturate(depth, far), far), exponent);
}

/// @param m         mean of texels; NaN is in shadow
/// @param receiver  depth, biased; nearer than 0 is lit as 0 is; NaN is in shadow
/// @return          visibility, 0 to 1, before bleed_cut: at least the lit share, less 2^-20
/// @formula         min(m 2^(-exponent (2 d - 1)), 1), d = forward_depth(receiver)
/// @exactness       B;  within 2^-20 of exact means of exact powers of the same rounded exponents: two powers, each off
///                  by 1.8e-7 of it, and their product
/// @cite            Annen et al.: Exponential shadow maps, Graphics Interface 2008
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T decode_esm(T m, T receiver, T exponent, T far = T(1)) {
    const T d = forward_depth(receiver, far);
    const T p = m * warp_depth(d, -exponent);
    const T lit = detail::pick(p < T(1), p, T(1));
    return detail::pick(bool(int(p > T(0)) & int(!is_nan(p)) & int(!is_nan(d))), lit, T(0));
}

/// Set-up of exponential shadow maps.
struct esm_settings {
    float exponent = 40.0f;  ///< of 2, at the far plane; twice that is the C of 2^(C depth)
    float_store store = float_store::single;
};

/// @return   the settings
/// @throws std::invalid_argument   exponent not above 0, or beyond what keeps the texels and their inverses normal
///                                 numbers: 63 in 32 bits, 14 in 16
[[nodiscard]] inline esm_settings make_esm(const esm_settings& settings) {
    const float most = settings.store == float_store::single ? 63.0f : 14.0f;
    if (!(settings.exponent > 0.0f && settings.exponent <= most))
        detail::fail("umbrage::make_esm: exponent not above 0, or above 63, 14 in 16 bits");
    return settings;
}

namespace glsl {

inline constexpr snippet warp_depth{
    .name = "warp_depth",
    .summary = "depth on the scale of exponential shadow maps",
    .exactness = tier::b,
    .needs = list<&exp2_polynomial>,
    .source = R"GLSL(
// umbrage_warp_depth: 2^(exponent * (2.0 * depth - 1.0)) of a depth that grows with distance
UMBRAGE_HIGHP float umbrage_warp_depth(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float exponent) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = exponent * (depth * 2.0 - 1.0);
    return umbrage_exp2_polynomial(y);
}
)GLSL",
};

inline constexpr snippet encode_esm{
    .name = "encode_esm",
    .summary = "depth to a texel of an exponential shadow map",
    .exactness = tier::b,
    .needs = list<&saturate, &forward_depth, &warp_depth>,
    .source = R"GLSL(
// umbrage_encode_esm: depth's power, of depth that grows with distance; NaN counts as far
UMBRAGE_HIGHP float umbrage_encode_esm(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float exponent) {
    return umbrage_warp_depth(umbrage_forward_depth(umbrage_saturate(depth)), exponent);
}
)GLSL",
};

inline constexpr snippet decode_esm{
    .name = "decode_esm",
    .summary = "mean of texels of an exponential shadow map to visibility",
    .exactness = tier::b,
    .needs = list<&forward_depth, &warp_depth>,
    .source = R"GLSL(
// umbrage_decode_esm: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponent  as of the texels
UMBRAGE_HIGHP float umbrage_decode_esm(UMBRAGE_HIGHP float m, UMBRAGE_HIGHP float receiver,
                                       UMBRAGE_HIGHP float exponent) {
    UMBRAGE_HIGHP float d = umbrage_forward_depth(receiver);
    UMBRAGE_HIGHP float p = m * umbrage_warp_depth(d, -exponent);
    UMBRAGE_HIGHP float lit = p > 0.0 && p < 1.0 ? p : (p >= 1.0 ? 1.0 : 0.0);
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
)GLSL",
};

inline constexpr auto esm_snippets = list<&warp_depth, &encode_esm, &decode_esm>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/prefiltered/evsm.hpp
// Exponential variance shadow maps: a texel holds a power of depth and its square, and with four components a negative
// one besides. They let less light through than depth's own moments, which is where both powers let it.
//
//     const auto evsm = umbrage::make_evsm({.exponent = 40.0f});  // throws where floats would overflow
//     glm::vec4 texel = umbrage::encode_evsm4(depth, evsm.exponents);
//     float visibility = umbrage::decode_evsm4(blurred, receiver, evsm.exponents, evsm.deviations);
//

namespace umbrage {

/// @param depth     clamped to [0, 1]; NaN counts as far, as a cleared texel does
/// @param exponent  0 to 55
/// @formula         (w, w^2), w = warp_depth(forward_depth)
/// @exactness       B
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr glm::vec<2, T> encode_evsm2(T depth, T exponent, T far = T(1)) {
    const T w = warp_depth(forward_depth(saturate(depth, far), far), exponent);
    return {w, w * w};
}

/// @param depth      clamped to [0, 1]; NaN counts as far, as a cleared texel does
/// @param exponents  of the growing power and of the falling one, 0 to 55
/// @formula          (w, w^2, n, n^2), w = warp_depth(d, exponents.x), n = -warp_depth(d, -exponents.y)
/// @exactness        B
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr glm::vec<4, T> encode_evsm4(T depth, glm::vec<2, T> exponents, T far = T(1)) {
    const T d = forward_depth(saturate(depth, far), far);
    const T w = warp_depth(d, exponents.x), n = -warp_depth(d, -exponents.y);
    return {w, w * w, n, n * n};
}

namespace detail {

/// chebyshev of powers, whose least deviation is a part of the receiver's.
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T warped_chebyshev(glm::vec<2, T> m, T w, T deviation) {
    const T least = deviation * w;
    return chebyshev(m, w, least * least);
}

}  // namespace detail

/// @param m          mean of texels
/// @param receiver   depth, biased; outside [0, 1] the nearer end counts; NaN is in shadow
/// @param deviation  least standard deviation, as a part of the receiver's power: a least deviation of depth times
///                   2 ln(2) exponent, as make_evsm has it
/// @return           visibility before bleed_cut: at least the lit share, less chebyshev's error
/// @formula          chebyshev(m, w, (deviation w)^2), w = warp_depth(forward_depth(saturate(receiver)))
/// @exactness        C, 1 ulp: a division; within 2^-24 / deviation^2 + 2^-21 of the formula in reals of the same
///                   powers
/// @cite             Lauritzen, McCool: Layered variance shadow maps, Graphics Interface 2008
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T decode_evsm2(glm::vec<2, T> m, T receiver, T exponent, T deviation,
                                                      T far = T(1)) {
    const T d = forward_depth(saturate(receiver, far), far);
    const T lit = detail::warped_chebyshev(m, warp_depth(d, exponent), deviation);
    return detail::pick(is_nan(receiver), T(0), lit);
}

/// @param m           mean of texels
/// @param receiver    depth, biased; outside [0, 1] the nearer end counts; NaN is in shadow
/// @param exponents   as of the texels
/// @param deviations  least standard deviations, as parts of the receiver's powers
/// @return            visibility before bleed_cut: at least the lit share, less chebyshev's error
/// @formula           the lesser of decode_evsm2's for either power
/// @exactness         C, 1 ulp: a division
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T decode_evsm4(glm::vec<4, T> m, T receiver, glm::vec<2, T> exponents,
                                                      glm::vec<2, T> deviations, T far = T(1)) {
    const T d = forward_depth(saturate(receiver, far), far);
    const T a = detail::warped_chebyshev(glm::vec<2, T>(m.x, m.y), warp_depth(d, exponents.x), deviations.x);
    const T b = detail::warped_chebyshev(glm::vec<2, T>(m.z, m.w), -warp_depth(d, -exponents.y), deviations.y);
    return detail::pick(is_nan(receiver), T(0), detail::pick(a < b, a, b));
}

/// Set-up of exponential variance shadow maps.
struct evsm_settings {
    float exponent = 40.0f;        ///< of 2, at the far plane: of the growing power
    float falling = 8.0f;          ///< of 2, at the near plane: of the falling power
    float least_deviation = 0.0f;  ///< of depth, what counts as a surface's own; 0: 1e-4, in 16 bits 1e-2
    float_store store = float_store::single;
};

/// What shaders and functions are called with.
struct evsm_parameters {
    glm::vec2 exponents{};   ///< of the growing and of the falling power; of two components only the first counts
    glm::vec2 deviations{};  ///< least deviations, as parts of the receiver's powers
};

/// @throws std::invalid_argument   an exponent not above 0, or beyond what keeps powers and squares finite and normal,
///                                 55 in 32 bits, 7.99 in 16; a least deviation below 0, or one beside whose least
///                                 variance squares of distances count that are no normal numbers, which hardware
///                                 takes for 0: the usual one is large enough up to a falling exponent of 43
/// @formula   deviations = 2 ln(2) exponents least_deviation, the derivative of the power over the power
[[nodiscard]] inline evsm_parameters make_evsm(const evsm_settings& settings) {
    const bool single = settings.store == float_store::single;
    const float most = single ? 55.0f : 7.99f, usual = single ? 1e-4f : 1e-2f;
    if (!(settings.least_deviation >= 0.0f)) detail::fail("umbrage::make_evsm: least deviation below 0");
    const float least = settings.least_deviation > 0.0f ? settings.least_deviation : usual;
    const auto deviation = [&](float exponent, bool falls) {
        if (!(exponent > 0.0f && exponent <= most))
            detail::fail("umbrage::make_evsm: exponent not above 0, or above 55, 7.99 in 16 bits");
        const float part = exponent * (1.38629436f * least);
        const float least_power = falls ? exp2_polynomial(-exponent) : 1.0f;
        if (part * least_power < 0x1p-51f)  // squares that count beside its square may be below 2^-126
            detail::fail("umbrage::make_evsm: least deviation too small for the exponent");
        return part;
    };
    return {{settings.exponent, settings.falling},
            {deviation(settings.exponent, false), deviation(settings.falling, true)}};
}

namespace glsl {

inline constexpr snippet encode_evsm2{
    .name = "encode_evsm2",
    .summary = "depth to a texel of two components",
    .exactness = tier::b,
    .needs = list<&saturate, &forward_depth, &warp_depth>,
    .source = R"GLSL(
// umbrage_encode_evsm2: depth's power and its square, of depth that grows with distance; NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_evsm2(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float exponent) {
    UMBRAGE_HIGHP float w = umbrage_warp_depth(umbrage_forward_depth(umbrage_saturate(depth)), exponent);
    return vec2(w, w * w);
}
)GLSL",
};

inline constexpr snippet encode_evsm4{
    .name = "encode_evsm4",
    .summary = "depth to a texel of four components",
    .exactness = tier::b,
    .needs = list<&saturate, &forward_depth, &warp_depth>,
    .source = R"GLSL(
// umbrage_encode_evsm4: depth's growing power, its square, the negative falling one, its square; NaN counts as far
UMBRAGE_HIGHP vec4 umbrage_encode_evsm4(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP vec2 exponents) {
    UMBRAGE_HIGHP float d = umbrage_forward_depth(umbrage_saturate(depth));
    UMBRAGE_HIGHP float w = umbrage_warp_depth(d, exponents.x);
    UMBRAGE_HIGHP float n = -umbrage_warp_depth(d, -exponents.y);
    return vec4(w, w * w, n, n * n);
}
)GLSL",
};

inline constexpr snippet decode_evsm2{
    .name = "decode_evsm2",
    .summary = "mean of texels of two components to visibility",
    .exactness = tier::c,
    .ulp = 1,
    .needs = list<&chebyshev, &forward_depth, &saturate, &warp_depth>,
    .source = R"GLSL(
// umbrage_decode_evsm2: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponent  as of the texels
//   deviation  least standard deviation, as a part of the receiver's power
UMBRAGE_HIGHP float umbrage_decode_evsm2(UMBRAGE_HIGHP vec2 m, UMBRAGE_HIGHP float receiver,
                                         UMBRAGE_HIGHP float exponent, UMBRAGE_HIGHP float deviation) {
    UMBRAGE_HIGHP float d = umbrage_forward_depth(umbrage_saturate(receiver));
    UMBRAGE_HIGHP float w = umbrage_warp_depth(d, exponent);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float least = deviation * w;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float least_variance = least * least;
    UMBRAGE_HIGHP float lit = umbrage_chebyshev(m, w, least_variance);
    return receiver > 0.0 ? lit : (receiver <= 0.0 ? lit : 0.0);
}
)GLSL",
};

inline constexpr snippet decode_evsm4{
    .name = "decode_evsm4",
    .summary = "mean of texels of four components to visibility",
    .exactness = tier::c,
    .ulp = 1,
    .needs = list<&chebyshev, &forward_depth, &saturate, &warp_depth>,
    .source = R"GLSL(
// umbrage_decode_evsm4: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponents  as of the texels
//   deviations  least standard deviations, as parts of the receiver's powers
UMBRAGE_HIGHP float umbrage_decode_evsm4(UMBRAGE_HIGHP vec4 m, UMBRAGE_HIGHP float receiver,
                                         UMBRAGE_HIGHP vec2 exponents, UMBRAGE_HIGHP vec2 deviations) {
    UMBRAGE_HIGHP float d = umbrage_forward_depth(umbrage_saturate(receiver));
    UMBRAGE_HIGHP float w = umbrage_warp_depth(d, exponents.x);
    UMBRAGE_HIGHP float n = -umbrage_warp_depth(d, -exponents.y);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 least = deviations * vec2(w, n);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 least_variance = least * least;
    UMBRAGE_HIGHP float a = umbrage_chebyshev(vec2(m.x, m.y), w, least_variance.x);
    UMBRAGE_HIGHP float b = umbrage_chebyshev(vec2(m.z, m.w), n, least_variance.y);
    UMBRAGE_HIGHP float lit = a < b ? a : b;
    return receiver > 0.0 ? lit : (receiver <= 0.0 ? lit : 0.0);
}
)GLSL",
};

inline constexpr auto evsm_snippets = list<&encode_evsm2, &encode_evsm4, &decode_evsm2, &decode_evsm4>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/prefiltered/vsm.hpp
// Variance shadow maps: a texel holds depth and its square, which may be blurred, halved and filtered by the sampler.
//
//     glm::vec2 texel = umbrage::encode_vsm(depth);  // blur and so on are means of texels
//     float visibility = umbrage::decode_vsm(blurred, receiver, 1e-6f);
//
// Needs floats of 32 bits. For targets of 16 bits, or of four times 8, hold mean and deviation instead: of depth and
// its square too little is left there to take a variance from.
//
//     glm::vec2 held = umbrage::encode_deviation(blurred);  // each 0 to 1: two channels of 16 bits, or encode_rg<16>
//     glm::vec2 moments = umbrage::decode_deviation(held);
//
// A mean of held values is no mean of depths: decode, blur, encode.

namespace umbrage {

/// @param depth     clamped to [0, 1]; NaN counts as far, as a cleared texel does: (1, 1)
/// @param far       1, or 0 where depth is reversed
/// @formula         (d, d^2), d = forward_depth
/// @exactness       B
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr glm::vec<2, T> encode_vsm(T depth, T far = T(1)) {
    const T d = forward_depth(saturate(depth, far), far);
    return {d, d * d};
}

/// @param m              mean of texels
/// @param receiver       depth, biased; NaN is in shadow
/// @param min_variance   >= 0; 1e-6 for floats of 32 bits: variance that a slope or rounding brings, without which
///                       surfaces shadow themselves
/// @return               visibility before bleed_cut: at least the lit share, less chebyshev's error
/// @formula              chebyshev(m, forward_depth(receiver), min_variance)
/// @exactness            C, 1 ulp: a division
/// @cite                 Donnelly, Lauritzen: Variance shadow maps, I3D 2006
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr T decode_vsm(glm::vec<2, T> m, T receiver, T min_variance, T far = T(1)) {
    return chebyshev(m, forward_depth(receiver, far), min_variance);
}

/// @param m         mean of the depths, mean of their squares
/// @return          mean and twice the standard deviation, for depths in [0, 1] each 0 to 1; the latter 0 for NaN
/// @formula         (m.x, 2 sqrt(max(m.y - m.x^2, 0)))
/// @exactness       C, 1 ulp: a root
template <real T>
[[nodiscard]] glm::vec<2, T> encode_deviation(glm::vec<2, T> m) {
    const T variance = m.y - m.x * m.x;
    return {m.x, T(2) * std::sqrt(!is_nan(variance) && variance > T(0) ? variance : T(0))};
}

/// @param held      mean and twice the standard deviation, as stored
/// @return          mean of the depths, mean of their squares
/// @formula         (mean, mean^2 + (deviation / 2)^2)
/// @exactness       B
template <real T>
[[nodiscard]] constexpr glm::vec<2, T> decode_deviation(glm::vec<2, T> held) {
    const T half = held.y * T(0.5);
    return {held.x, held.x * held.x + half * half};
}

/// Mean and deviation of four channels of 8 bits, each as encode_rg<16> has it.
/// @param c         as sampled, k / 255
/// @return          the mean of the depths, the mean of their squares: mean and deviation of the upper edges of their
///                  codes, so that nothing gets darker by being stored
/// @formula         decode_deviation(decode_rg<16>(c.xy), decode_rg<16>(c.zw))
/// @exactness       B
template <real T>
[[nodiscard]] glm::vec<2, T> decode_deviation_rgba8(glm::vec<4, T> c) {
    return decode_deviation(
        glm::vec<2, T>(decode_rg<16>(glm::vec<2, T>(c.x, c.y), T(1)), decode_rg<16>(glm::vec<2, T>(c.z, c.w), T(1))));
}

namespace glsl {

inline constexpr snippet encode_vsm{
    .name = "encode_vsm",
    .summary = "depth to a texel of a variance shadow map",
    .exactness = tier::b,
    .needs = list<&saturate, &forward_depth>,
    .source = R"GLSL(
// umbrage_encode_vsm: depth and its square, of depth that grows with distance; NaN counts as far
UMBRAGE_HIGHP vec2 umbrage_encode_vsm(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float d = umbrage_forward_depth(umbrage_saturate(depth));
    return vec2(d, d * d);
}
)GLSL",
};

inline constexpr snippet decode_vsm{
    .name = "decode_vsm",
    .summary = "mean of texels of a variance shadow map to visibility",
    .exactness = tier::c,
    .ulp = 1,
    .needs = list<&chebyshev, &forward_depth>,
    .source = R"GLSL(
// umbrage_decode_vsm: visibility of a receiver, at least its lit share; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   min_variance  0.0 or more
UMBRAGE_HIGHP float umbrage_decode_vsm(UMBRAGE_HIGHP vec2 m, UMBRAGE_HIGHP float receiver,
                                       UMBRAGE_HIGHP float min_variance) {
    return umbrage_chebyshev(m, umbrage_forward_depth(receiver), min_variance);
}
)GLSL",
};

inline constexpr snippet encode_deviation{
    .name = "encode_deviation",
    .summary = "depth's two moments to mean and deviation",
    .exactness = tier::c,
    .ulp = 1,
    .source = R"GLSL(
// umbrage_encode_deviation: mean and mean square of depths to mean and twice the standard deviation, each 0.0 to 1.0
UMBRAGE_HIGHP vec2 umbrage_encode_deviation(UMBRAGE_HIGHP vec2 m) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float variance = m.y - m.x * m.x;
    return vec2(m.x, 2.0 * sqrt(variance > 0.0 ? variance : 0.0));
}
)GLSL",
};

inline constexpr snippet decode_deviation{
    .name = "decode_deviation",
    .summary = "mean and deviation to depth's two moments",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_decode_deviation: mean and twice the standard deviation to mean and mean square of depths
UMBRAGE_HIGHP vec2 umbrage_decode_deviation(UMBRAGE_HIGHP vec2 held) {
    UMBRAGE_HIGHP float half_of_it = held.y * 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = held.x * held.x + half_of_it * half_of_it;
    return vec2(held.x, square);
}
)GLSL",
};

inline constexpr snippet decode_deviation_rgba8{
    .name = "decode_deviation_rgba8",
    .summary = "mean and deviation in four channels to depth's two moments",
    .exactness = tier::b,
    .needs = list<&decode_deviation, &decode_rg<16>>,
    .source = R"GLSL(
// umbrage_decode_deviation_rgba8: mean and deviation, two channels each, as sampled, to mean and mean square of depths
UMBRAGE_HIGHP vec2 umbrage_decode_deviation_rgba8(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_HIGHP float mean = umbrage_decode_rg16(vec2(c.x, c.y), 1.0);
    UMBRAGE_HIGHP float deviation = umbrage_decode_rg16(vec2(c.z, c.w), 1.0);
    return umbrage_decode_deviation(vec2(mean, deviation));
}
)GLSL",
};

inline constexpr auto vsm_snippets =
    list<&encode_vsm, &decode_vsm, &encode_deviation, &decode_deviation, &decode_deviation_rgba8>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/prefiltered/decode_hardware.hpp
// Variance shadow maps as GPUs have them cheapest: what the sampler filtered, the GPU's own exp2 and division, sums
// fused as it likes, and the cut of bleeding light taken along. Within a bound of the same formula, not of its bits.
//
//     float lit = umbrage::decode_vsm_hardware(held, receiver, 1e-6f, 0.2f);  // held: of encode_deviation
//     lit = umbrage::decode_evsm2_hardware(moments, receiver, exponent, deviation, 0.2f);
//
// Mean and deviation are filtered as they are: there is no difference of squares that rounding could take away.

namespace umbrage {

namespace detail {

/// Below 2^20 in size, as all depths are; what is not is in shadow.
template <real T>
[[nodiscard]] constexpr bool is_depth(T receiver) {
    return !is_nan(receiver) && receiver < T(1048576) && receiver > T(-1048576);
}

}  // namespace detail

/// chebyshev and bleed_cut in one.
/// @param variance   above 0 by a normal number
/// @param distance   from the mean to the receiver, no NaN; what is not above 0 is lit
/// @param amount     as of bleed_cut, 0 to 1/2
/// @formula          clamp((p - amount) / (1 - amount), 0, 1), p = variance / (variance + max(distance, 0)^2)
/// @exactness        C, within 2^-19 in a shader: sum and product half an ulp each, of divisions GPUs promise 2.5, and
///                   the cut doubles that
template <real T>
[[nodiscard]] constexpr T chebyshev_hardware(T variance, T distance, T amount) {
    const T beyond = distance > T(0) ? distance : T(0);
    const T p = variance / (variance + beyond * beyond);
    return glm::clamp((p - amount) / (T(1) - amount), T(0), T(1));
}

/// @param held           mean and twice the standard deviation, as encode_deviation has them, filtered; no NaN
/// @param receiver       depth, biased; NaN, and from 2^20 on on either side: in shadow
/// @param min_variance   1e-7 or more
/// @param amount         as of bleed_cut, 0 to 1/2
/// @formula              chebyshev_hardware(max((held.y / 2)^2, min_variance), d - held.x, amount),
///                       d = forward_depth(receiver)
/// @exactness            C, within 2^-10 in a shader: a distance off by 2^-23 moves p by at most 0.65 2^-23 /
///                       sqrt(min_variance), which the cut doubles; and chebyshev_hardware
/// @cite                 Donnelly, Lauritzen: Variance shadow maps, I3D 2006
template <real T>
[[nodiscard]] constexpr T decode_vsm_hardware(glm::vec<2, T> held, T receiver, T min_variance, T amount, T far = T(1)) {
    if (!detail::is_depth(receiver)) return T(0);
    const T variance = glm::max(held.y * held.y * T(0.25), min_variance);
    return chebyshev_hardware(variance, forward_depth(receiver, far) - held.x, amount);
}

/// @param m           mean of encode_evsm2's texels; no NaN
/// @param receiver    depth, biased; outside [0, 1] the nearer end counts; NaN, and from 2^20 on on either side: in
///                    shadow
/// @param exponent    as of the texels, at most 55
/// @param deviation   as of decode_evsm2, 0.005 or more
/// @param amount      as of bleed_cut, 0 to 0.3
/// @formula           chebyshev_hardware(max(m.y - m.x^2, (deviation w)^2), w - m.x, amount),
///                    w = warp_depth(forward_depth(clamp(receiver, 0, 1)), exponent)
/// @exactness         C, within 1/64 in a shader. exp2 of y is promised to 3 + 2 |y| ulp; with y's own rounding on
///                    either side w is off by e = (5 + 4 exponent) 2^-23 of itself, and p by 0.65 e / deviation + e.
///                    Moments fused or not: 2 (2^-24 / deviation^2 + 2^-21). The cut divides both by 1 - amount
/// @cite              Lauritzen, McCool: Layered variance shadow maps, Graphics Interface 2008
template <real T>
[[nodiscard]] constexpr T decode_evsm2_hardware(glm::vec<2, T> m, T receiver, T exponent, T deviation, T amount,
                                                T far = T(1)) {
    if (!detail::is_depth(receiver)) return T(0);
    const T w = warp_depth(forward_depth(glm::clamp(receiver, T(0), T(1)), far), exponent), least = deviation * w;
    return chebyshev_hardware(glm::max(m.y - m.x * m.x, least * least), w - m.x, amount);
}

/// @param m           mean of encode_evsm4's texels; no NaN
/// @param receiver    as of decode_evsm2_hardware, and so are exponents, deviations and amount
/// @formula           the lesser of decode_evsm2_hardware's for either power
/// @exactness         C, within 1/64 in a shader, as decode_evsm2_hardware
template <real T>
[[nodiscard]] constexpr T decode_evsm4_hardware(glm::vec<4, T> m, T receiver, glm::vec<2, T> exponents,
                                                glm::vec<2, T> deviations, T amount, T far = T(1)) {
    if (!detail::is_depth(receiver)) return T(0);
    const T d = forward_depth(glm::clamp(receiver, T(0), T(1)), far);
    const T w = warp_depth(d, exponents.x), n = T(0) - warp_depth(d, T(0) - exponents.y);
    const T least_w = deviations.x * w, least_n = deviations.y * n;
    const T a = chebyshev_hardware(glm::max(m.y - m.x * m.x, least_w * least_w), w - m.x, amount);
    const T b = chebyshev_hardware(glm::max(m.w - m.z * m.z, least_n * least_n), n - m.z, amount);
    return glm::min(a, b);
}

namespace glsl {

inline constexpr snippet chebyshev_hardware{
    .name = "chebyshev_hardware",
    .summary = "most that a variance lets be lit, less the light that bleeds",
    .exactness = tier::c,
    .within = 1.0f / 524288.0f,
    .source = R"GLSL(
// umbrage_chebyshev_hardware: share of depths that may be as far as the receiver or farther, its least part cut
//   variance  above 0.0;   distance  from mean to receiver, no NaN;   amount  that is cut, 0.0 to 0.5
UMBRAGE_HIGHP float umbrage_chebyshev_hardware(UMBRAGE_HIGHP float variance, UMBRAGE_HIGHP float distance,
                                               UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float beyond = max(distance, 0.0);
    UMBRAGE_HIGHP float p = variance / (variance + beyond * beyond);
    return clamp((p - amount) / (1.0 - amount), 0.0, 1.0);
}
)GLSL",
};

inline constexpr snippet decode_vsm_hardware{
    .name = "decode_vsm_hardware",
    .summary = "mean and deviation to visibility, the cheapest way",
    .exactness = tier::c,
    .within = 1.0f / 1024.0f,
    .needs = list<&chebyshev_hardware, &forward_depth>,
    .source = R"GLSL(
// umbrage_decode_vsm_hardware: visibility of a receiver, less the light that bleeds; 1.0 is lit
//   held  mean and twice the standard deviation of depths, filtered;   receiver  depth, biased
//   min_variance  1e-7 or more;   amount  that is cut, 0.0 to 0.5
UMBRAGE_HIGHP float umbrage_decode_vsm_hardware(UMBRAGE_HIGHP vec2 held, UMBRAGE_HIGHP float receiver,
                                                UMBRAGE_HIGHP float min_variance, UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float variance = max(held.y * held.y * 0.25, min_variance);
    UMBRAGE_HIGHP float distance = umbrage_forward_depth(receiver) - held.x;
    UMBRAGE_HIGHP float lit = umbrage_chebyshev_hardware(variance, distance, amount);
    return abs(receiver) < 1048576.0 ? lit : 0.0;
}
)GLSL",
};

inline constexpr snippet decode_evsm2_hardware{
    .name = "decode_evsm2_hardware",
    .summary = "mean of texels of two components to visibility, by the GPU's own exp2",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .needs = list<&chebyshev_hardware, &forward_depth>,
    .source = R"GLSL(
// umbrage_decode_evsm2_hardware: visibility of a receiver, less the light that bleeds; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponent  as of the texels
//   deviation  least standard deviation, as a part of the receiver's power;   amount  that is cut, 0.0 to 0.3
UMBRAGE_HIGHP float umbrage_decode_evsm2_hardware(UMBRAGE_HIGHP vec2 m, UMBRAGE_HIGHP float receiver,
                                                  UMBRAGE_HIGHP float exponent, UMBRAGE_HIGHP float deviation,
                                                  UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float d = umbrage_forward_depth(clamp(receiver, 0.0, 1.0));
    UMBRAGE_HIGHP float w = exp2(exponent * (d * 2.0 - 1.0));
    UMBRAGE_HIGHP float least = deviation * w;
    UMBRAGE_HIGHP float variance = max(m.y - m.x * m.x, least * least);
    UMBRAGE_HIGHP float lit = umbrage_chebyshev_hardware(variance, w - m.x, amount);
    return abs(receiver) < 1048576.0 ? lit : 0.0;
}
)GLSL",
};

inline constexpr snippet decode_evsm4_hardware{
    .name = "decode_evsm4_hardware",
    .summary = "mean of texels of four components to visibility, by the GPU's own exp2",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .needs = list<&chebyshev_hardware, &forward_depth>,
    .source = R"GLSL(
// umbrage_decode_evsm4_hardware: visibility of a receiver, less the light that bleeds; 1.0 is lit
//   m  mean of texels;   receiver  depth, biased;   exponents  as of the texels
//   deviations  least standard deviations, as parts of the receiver's powers;   amount  that is cut, 0.0 to 0.3
UMBRAGE_HIGHP float umbrage_decode_evsm4_hardware(UMBRAGE_HIGHP vec4 m, UMBRAGE_HIGHP float receiver,
                                                  UMBRAGE_HIGHP vec2 exponents, UMBRAGE_HIGHP vec2 deviations,
                                                  UMBRAGE_HIGHP float amount) {
    UMBRAGE_HIGHP float d = umbrage_forward_depth(clamp(receiver, 0.0, 1.0)) * 2.0 - 1.0;
    UMBRAGE_HIGHP float w = exp2(exponents.x * d);
    UMBRAGE_HIGHP float n = 0.0 - exp2((0.0 - exponents.y) * d);
    UMBRAGE_HIGHP vec2 least = deviations * vec2(w, n);
    UMBRAGE_HIGHP float growing = max(m.y - m.x * m.x, least.x * least.x);
    UMBRAGE_HIGHP float falling = max(m.w - m.z * m.z, least.y * least.y);
    UMBRAGE_HIGHP float a = umbrage_chebyshev_hardware(growing, w - m.x, amount);
    UMBRAGE_HIGHP float b = umbrage_chebyshev_hardware(falling, n - m.z, amount);
    return abs(receiver) < 1048576.0 ? min(a, b) : 0.0;
}
)GLSL",
};

inline constexpr auto decode_hardware_snippets =
    list<&chebyshev_hardware, &decode_vsm_hardware, &decode_evsm2_hardware, &decode_evsm4_hardware>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/prefiltered/msm.hpp
// Moment shadow maps: a texel holds the first four powers of depth on [-1, 1], of which means may be taken.
//
//     glm::vec4 texel = umbrage::encode_msm(depth);
//     float visibility = umbrage::decode_msm(blurred, receiver, umbrage::msm_bias_32);
//
// Four channels of 16 bits hold them turned, so that each has its whole range:
//
//     glm::vec4 held = umbrage::turn_moments(texel);
//     float visibility = umbrage::decode_msm(umbrage::turn_moments_back(held), receiver, umbrage::msm_bias_16);
//
// Of all distributions with the same moments the one that shadows the receiver least has three depths, one of which is
// the receiver's: what of the other two lies before it is shadow.

namespace umbrage {

/// How far moments are moved, and towards which: (0, y, 0, y), so that rounding does not take them out of what any
/// depths have. x is the share; shadows get lighter by up to it, and by the square root of it near their casters.
inline const glm::vec2 msm_bias_32{3e-6f, 0.375f};  ///< of floats of 32 bits
inline const glm::vec2 msm_bias_16{6e-5f, 0.628f};  ///< of four channels of 16 bits, turned

/// @param depth     clamped to [0, 1]; NaN counts as far, as a cleared texel does: (1, 1, 1, 1)
/// @param far       1, or 0 where depth is reversed
/// @formula         (z, z^2, z^3, z^4), z = 2 forward_depth - 1
/// @exactness       B
/// @cite            Peters, Klein: Moment shadow mapping, I3D 2015; on [-1, 1]: Peters et al.: Improved moment shadow
///                  maps for translucent occluders, soft shadows and single scattering, JCGT 2017
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr glm::vec<4, T> encode_msm(T depth, T far = T(1)) {
    const T z = forward_depth(saturate(depth, far), far) * T(2) - T(1);
    const T square = z * z;
    return {z, square, square * z, square * square};
}

/// Moments for four channels of 16 bits: each takes [0, 1] wholly. A mean of turned moments is the mean, turned.
/// @formula         (1.5 b1 - 2 b3 + 1/2, 4 b2 - 4 b4, sqrt(3)/2 b1 - 2 sqrt(3)/9 b3 + 1/2, (b2 + b4) / 2)
/// @exactness       B
/// @cite            Peters et al., JCGT 2017
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr glm::vec<4, T> turn_moments(glm::vec<4, T> b) {
    return {(b.x * T(0.75) - b.z) * T(2) + T(0.5), (b.y - b.w) * T(4), (b.x * T(2.25) - b.z) * T(0.384900182f) + T(0.5),
            (b.y + b.w) * T(0.5)};
}

/// @formula         the inverse of turn_moments
/// @exactness       B;  off by at most 2^-22 of what was turned, of rounding on both ways
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr glm::vec<4, T> turn_moments_back(glm::vec<4, T> o) {
    const T x = o.x - T(0.5), z = o.z - T(0.5), eighth = o.y * T(0.125);
    return {z * T(1.73205078f) - x * T(0.333333343f), o.w + eighth, z * T(1.29903817f) - x * T(0.75), o.w - eighth};
}

namespace detail {

/// moment_atoms up to the root of `square`, and from there on.
template <real T>
struct atom_equation {
    T D, E, h, a, B, c, square;

    UMBRAGE_INLINE atom_equation(glm::vec<4, T> b, T x) : D(b.y - b.x * b.x) {
        const T L = b.z - b.x * b.y, l = L / D;
        E = (b.w - b.y * b.y) - L * l, h = b.x * T(2) - l;
        a = D * at(x), B = x * E + h * a, c = D * (E - a);
        const T under = B * B - T(4) * a * c;
        square = pick(under > T(0), under, T(0));
    }
    UMBRAGE_INLINE atom_equation() = default;

    [[nodiscard]] UMBRAGE_INLINE T at(T t) const { return (t + h) * t - D; }
    [[nodiscard]] UMBRAGE_INLINE glm::vec<4, T> atoms(T root) const {
        const T w = pick(B < T(0), root - B, -(B + root)) * T(0.5), s = w / a, t = c / w;
        return {s, t, share(s), share(t)};
    }
    [[nodiscard]] UMBRAGE_INLINE T share(T t) const {
        const T height = at(t), least = D * E;
        return least / (least + (t * t * E + height * height * D));
    }
};

/// Whether moment_atoms found any.
template <real T>
[[nodiscard]] UMBRAGE_INLINE inline bool are_shares(const glm::vec<4, T>& atoms) {
    const T sum = atoms.z + atoms.w;
    return bool(int(!is_nan(sum)) & int(std::abs(sum) <= T(4294967296)));
}

/// decode_msm of moment_atoms.
/// @param d   the receiver's depth, growing with distance
template <real T>
[[nodiscard]] UMBRAGE_INLINE inline T lit_by_atoms(const glm::vec<4, T>& atoms, T x, T d) {
    const T lit = T(1) - (pick(atoms.x < x, atoms.z, T(0)) + pick(atoms.y < x, atoms.w, T(0)));
    const T within = pick(lit > T(0), pick(lit < T(1), lit, T(1)), T(0));
    const T known = pick(are_shares(atoms), within, pick(x <= T(0), T(1), T(0)));
    return pick(bool(int(is_nan(d)) | int(is_nan(x))), T(0), known);
}

/// Depth on [-1, 1]; NaN is near.
template <real T>
[[nodiscard]] UMBRAGE_INLINE inline T moment_depth(T d) {
    return pick(d > T(0), pick(d < T(1), d, T(1)), T(0)) * T(2) - T(1);
}

}  // namespace detail

/// The two depths that, beside the receiver's, make the distribution with the same moments.
///
/// @param b         moments, biased
/// @param x         the receiver's depth on [-1, 1] less b.x
/// @return          the depths less b.x, their shares; NaN where moments are those of fewer than three depths
/// @formula         D = b2 - b1^2, L = b3 - b1 b2, E = b4 - b2^2 - L l, l = L / D, h = 2 b1 - l, q(t) = (t + h) t - D;
///                  t the roots of a t^2 + B t + c, a = D q(x), B = x E + h a, c = D (E - a); the share at t is
///                  D E / (D E + t^2 E + q(t)^2 D)
/// @exactness       C: five divisions and a root
template <real T>
[[nodiscard]] glm::vec<4, T> moment_atoms(glm::vec<4, T> b, T x) {
    const detail::atom_equation<T> equation(b, x);
    return equation.atoms(std::sqrt(equation.square));
}

/// Moments as moment_atoms takes them.
/// @param bias      msm_bias_32, msm_bias_16
/// @exactness       B
template <real T>
[[nodiscard]] UMBRAGE_INLINE constexpr glm::vec<4, T> bias_moments(glm::vec<4, T> b, glm::vec<2, T> bias) {
    return {b.x - b.x * bias.x, b.y + (bias.y - b.y) * bias.x, b.z - b.z * bias.x, b.w + (bias.y - b.w) * bias.x};
}

/// @param b         mean of texels
/// @param receiver  depth, biased; outside [0, 1] the nearer end counts; NaN is in shadow
/// @param bias      msm_bias_32, msm_bias_16
/// @return          visibility, 0 to 1: at least the lit share, less bias.x and the error below. Where moments are
///                  those of fewer than three depths, and of NaN: 1 where the receiver is no farther than their mean,
///                  else 0. Of numbers that are no depths' moments: 0 to 1, and beside poles rounding decides which
/// @formula         1 - sum of the shares of moment_atoms before the receiver
/// @exactness       C: within 1/64 in a shader. Rounding in binary32 does to first order as much as moments do that are
///                  off by (0, 1, 3, 7) 2^-24, which is at most 9 2^-24 / (bias.x e), e the least eigenvalue of the
///                  matrix of (0, y, 0, y), 0.199 of 0.375 and 0.159 of 0.628: 0.057 with msm_bias_16, 0.027 with a
///                  share of 1e-4 towards 0.375, 0.9 with msm_bias_32, of which it says little
/// @cite            Peters, Klein: Moment shadow mapping, I3D 2015
template <real T>
[[nodiscard]] T decode_msm(glm::vec<4, T> b, T receiver, glm::vec<2, T> bias, T far = T(1)) {
    const T d = forward_depth(receiver, far);
    const glm::vec<4, T> m = bias_moments(b, bias);
    const T x = detail::moment_depth(d) - m.x;
    return detail::lit_by_atoms(moment_atoms(m, x), x, d);
}

namespace glsl {

inline constexpr snippet encode_msm{
    .name = "encode_msm",
    .summary = "depth to its first four powers on [-1, 1]",
    .exactness = tier::b,
    .needs = list<&saturate, &forward_depth>,
    .source = R"GLSL(
// umbrage_encode_msm: first four powers of depth on -1.0 to 1.0, of depth that grows with distance; NaN counts as far
UMBRAGE_HIGHP vec4 umbrage_encode_msm(UMBRAGE_HIGHP float depth) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = umbrage_forward_depth(umbrage_saturate(depth)) * 2.0 - 1.0;
    UMBRAGE_HIGHP float square = z * z;
    return vec4(z, square, square * z, square * square);
}
)GLSL",
};

inline constexpr snippet turn_moments{
    .name = "turn_moments",
    .summary = "four moments to four channels of 16 bits",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_turn_moments: four moments so that each takes 0.0 to 1.0 wholly, for four channels of 16 bits
UMBRAGE_HIGHP vec4 umbrage_turn_moments(UMBRAGE_HIGHP vec4 b) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = (b.x * 0.75 - b.z) * 2.0 + 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = (b.y - b.w) * 4.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = (b.x * 2.25 - b.z) * 0.384900182 + 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float w = (b.y + b.w) * 0.5;
    return vec4(x, y, z, w);
}
)GLSL",
};

inline constexpr snippet turn_moments_back{
    .name = "turn_moments_back",
    .summary = "four channels of 16 bits to four moments",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_turn_moments_back: four moments of what umbrage_turn_moments made of them
UMBRAGE_HIGHP vec4 umbrage_turn_moments_back(UMBRAGE_HIGHP vec4 o) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = o.x - 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = o.z - 0.5;
    UMBRAGE_HIGHP float eighth = o.y * 0.125;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float b1 = z * 1.73205078 - x * 0.333333343;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float b2 = o.w + eighth;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float b3 = z * 1.29903817 - x * 0.75;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float b4 = o.w - eighth;
    return vec4(b1, b2, b3, b4);
}
)GLSL",
};

inline constexpr snippet moment_atoms{
    .name = "moment_atoms",
    .summary = "the two depths that make four moments beside a receiver's",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .source = R"GLSL(
// umbrage_moment_atoms: the two depths that beside the receiver's have the same moments, less b.x, and their shares
//   b  moments, biased;   x  the receiver's depth on -1.0 to 1.0 less b.x
UMBRAGE_HIGHP vec4 umbrage_moment_atoms(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP float x) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d = b.y - b.x * b.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float third = b.z - b.x * b.y;
    UMBRAGE_HIGHP float l = third / d;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float e = (b.w - b.y * b.y) - third * l;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float h = b.x * 2.0 - l;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float a = d * ((x + h) * x - d);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float m = x * e + h * a;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float c = d * (e - a);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square = m * m - 4.0 * a * c;
    UMBRAGE_HIGHP float root = sqrt(square > 0.0 ? square : 0.0);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float w = (m < 0.0 ? root - m : -(m + root)) * 0.5;
    UMBRAGE_HIGHP vec2 t = vec2(w / a, c / w);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 q = (t + h) * t - d;
    UMBRAGE_HIGHP float least = d * e;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 sum = least + (t * t * e + q * q * d);
    return vec4(t.x, t.y, least / sum.x, least / sum.y);
}
)GLSL",
};

inline constexpr snippet bias_moments{
    .name = "bias_moments",
    .summary = "four moments, moved a little towards those of spread depths",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_bias_moments: moments moved by a share bias.x towards (0.0, bias.y, 0.0, bias.y)
UMBRAGE_HIGHP vec4 umbrage_bias_moments(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP vec2 bias) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = b.x - b.x * bias.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = b.y + (bias.y - b.y) * bias.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = b.z - b.z * bias.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float w = b.w + (bias.y - b.w) * bias.x;
    return vec4(x, y, z, w);
}
)GLSL",
};

inline constexpr snippet decode_msm{
    .name = "decode_msm",
    .summary = "mean of four moments to visibility",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .needs = list<&bias_moments, &forward_depth, &moment_atoms>,
    .source = R"GLSL(
// umbrage_decode_msm: visibility of a receiver, at least its lit share less bias.x; 1.0 is lit
//   b  mean of texels;   receiver  depth, biased
//   bias  (3e-6, 0.375) of floats of 32 bits, (6e-5, 0.628) of channels of 16
UMBRAGE_HIGHP float umbrage_decode_msm(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 bias) {
    UMBRAGE_HIGHP float d = umbrage_forward_depth(receiver);
    UMBRAGE_HIGHP vec4 m = umbrage_bias_moments(b, bias);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = ((d > 0.0 ? (d < 1.0 ? d : 1.0) : 0.0) * 2.0 - 1.0) - m.x;
    UMBRAGE_HIGHP vec4 atoms = umbrage_moment_atoms(m, x);
    UMBRAGE_HIGHP float first = atoms.x < x ? atoms.z : 0.0;
    UMBRAGE_HIGHP float second = atoms.y < x ? atoms.w : 0.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float lit = 1.0 - (first + second);
    bool known = abs(atoms.z + atoms.w) <= 4294967296.0;  // what is no NaN
    lit = known ? (lit > 0.0 ? (lit < 1.0 ? lit : 1.0) : 0.0) : (x <= 0.0 ? 1.0 : 0.0);
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
)GLSL",
};

inline constexpr auto msm_snippets =
    list<&encode_msm, &turn_moments, &turn_moments_back, &moment_atoms, &bias_moments, &decode_msm>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/prefiltered/hausdorff.hpp
// Four moments of depths that are known to lie in [-1, 1]: what decode_msm takes for outside of it goes to its end, and
// less light bleeds through. For floats of 32 bits.
//
//     float visibility = umbrage::decode_msm_hausdorff(blurred, receiver, umbrage::msm_bias_32);
//
// A floor that falls away from the light darkens a little where it ends before cleared texels: the blur holds its
// nearer side alone there, depths before the receiver. decode_msm misses them, as it takes the cleared ones for spread
// about a mean. A bias for the blur's radius takes that away.

namespace umbrage {

/// Share of depths before the receiver's, where four make the distribution that shadows it least: the near end, the far
/// end, the receiver's depth z and one more, f. So it is where one of moment_atoms lies outside [-1, 1].
///
/// @param b         moments, biased
/// @param z         the receiver's depth on [-1, 1]
/// @return          the share, 0 to 1; 0 at the near end; negative where no four such depths have these moments
/// @formula         D = b2 - b1^2, L = b3 - b1 b2, F = b4 - b2^2, w = 1 - b2, x = z - b1, d = L + w x,
///                  g = F - D w - (z + b1) L, f = b1 + g / d, p = d (1 + f), q = d (1 - f), k = w g + L d; the share at
///                  -1 is ((1 + z) (d D + g (1 - b1)) - k) / (2 (1 + z) p), that at 1 has the sign of
///                  ((1 - z) (d D - g (1 + b1)) + k) q, that at f, which lies before the receiver where d > 0, is
///                  d^4 / (p q (x d - g)): interpolation's weights, of central moments, where few digits cancel
/// @exactness       C: two divisions; which depths there are is decided without one. In binary32 off, to first order,
///                  by at most 24 2^-24 (s + 1 / ((1 + z) (1 - f^2)) + 1 / |z - f|), s the sum of the absolute
///                  coefficients of the polynomial of degree 4 whose mean is the share: 1 at -1, twice 0 at f, 0 at z
///                  and 1, or where f < z one less such: twice 0 at f, 0 at -1, 1 at z and 1. Rounding up to d and g
///                  does as much as moments do that are off by (1, 1, 8, 23) 2^-24, and the share does not change with
///                  f to first order; what follows is off by 8 2^-24 of 1 / (1 + f), 1 / (1 - f), 1 / |z - f| or of
///                  1 / ((1 + z) (1 + f)) at a step. Nothing holds s down for all moments: a bias of (0, y, 0, y) is
///                  one of depths -1, 0 and 1, no help where f is 0
template <real T>
[[nodiscard]] UMBRAGE_INLINE inline T hausdorff_share(glm::vec<4, T> b, T z) {
    const T variance = b.y - b.x * b.x, third = b.z - b.x * b.y, fourth = b.w - b.y * b.y, rest = T(1) - b.y;
    const T x = z - b.x, d = third + rest * x, g = (fourth - variance * rest) - (z + b.x) * third;
    const T p = d * (T(1) + b.x) + g, q = d * (T(1) - b.x) - g, k = rest * g + third * d, square = d * d;
    const T first = (T(1) + z) * (d * variance + g * (T(1) - b.x)) - k;
    const T last = (T(1) - z) * (d * variance - g * (T(1) + b.x)) + k;
    const T end = first / (T(2) * ((T(1) + z) * p)), other = (square * square) / (p * (q * (x * d - g)));
    const T share = end + detail::pick(d > T(0), other, T(0));
    const auto four = int(first * p > T(0)) & int(last * q > T(0)) & int(p * q > T(0)) & int(share >= T(0));
    const T known = detail::pick(bool(four), detail::pick(share < T(1), share, T(1)), T(-1));
    return detail::pick(z <= T(-1), T(0), known);
}

namespace detail {

/// decode_msm_hausdorff from what decode_msm gives, of biased moments and a depth that grows with distance.
template <real T>
[[nodiscard]] UMBRAGE_INLINE inline T lit_within(T plain, glm::vec<4, T> b, T d) {
    const T share = hausdorff_share(b, moment_depth(d));
    return pick(bool(int(!is_nan(d)) & int(share >= T(0))), T(1) - share, plain);
}

}  // namespace detail

/// @param b         mean of texels
/// @param receiver  depth, biased; outside [0, 1] the nearer end counts, the near end is lit; NaN is in shadow
/// @param bias      msm_bias_32
/// @return          visibility, 0 to 1, no more than decode_msm's but for rounding: at least the lit share, less bias.x
///                  and rounding. Where moments are those of fewer than three depths, and of NaN: as decode_msm
/// @formula         1 - hausdorff_share where that is not negative, else decode_msm
/// @exactness       C: within 1/64 in a shader
/// @cite            Peters, Klein: Moment shadow mapping, I3D 2015
template <real T>
[[nodiscard]] T decode_msm_hausdorff(glm::vec<4, T> b, T receiver, glm::vec<2, T> bias, T far = T(1)) {
    return detail::lit_within(decode_msm(b, receiver, bias, far), bias_moments(b, bias), forward_depth(receiver, far));
}

namespace glsl {

inline constexpr snippet hausdorff_share{
    .name = "hausdorff_share",
    .summary = "least share of depths before a receiver, of depths on [-1, 1]",
    .exactness = tier::c,
    .within = 1.0f / 1048576.0f,
    .source = R"GLSL(
// umbrage_hausdorff_share: least share of depths on -1.0 to 1.0 before the receiver's, of four moments
//   b  moments, biased;   z  the receiver's depth on -1.0 to 1.0
//   negative where the share is that of umbrage_moment_atoms
UMBRAGE_HIGHP float umbrage_hausdorff_share(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP float z) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float variance = b.y - b.x * b.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float third = b.z - b.x * b.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float fourth = b.w - b.y * b.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float rest = 1.0 - b.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = z - b.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d = third + rest * x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float g = (fourth - variance * rest) - (z + b.x) * third;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float p = d * (1.0 + b.x) + g;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float q = d * (1.0 - b.x) - g;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float k = rest * g + third * d;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float first = (1.0 + z) * (d * variance + g * (1.0 - b.x)) - k;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float last = (1.0 - z) * (d * variance - g * (1.0 + b.x)) + k;
    UMBRAGE_HIGHP float square = d * d;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float between = p * (q * (x * d - g));
    UMBRAGE_HIGHP float end = first / (2.0 * ((1.0 + z) * p));
    UMBRAGE_HIGHP float other = square * square / between;
    UMBRAGE_HIGHP float share = end + (d > 0.0 ? other : 0.0);
    bool four = first * p > 0.0 && last * q > 0.0 && p * q > 0.0 && share >= 0.0;
    return z <= -1.0 ? 0.0 : (four ? (share < 1.0 ? share : 1.0) : -1.0);
}
)GLSL",
};

inline constexpr snippet decode_msm_hausdorff{
    .name = "decode_msm_hausdorff",
    .summary = "mean of four moments of depths on [-1, 1] to visibility",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .needs = list<&bias_moments, &decode_msm, &forward_depth, &hausdorff_share>,
    .source = R"GLSL(
// umbrage_decode_msm_hausdorff: visibility of a receiver, at least its lit share less bias.x; 1.0 is lit
//   b  mean of texels;   receiver  depth, biased;   bias  (3e-6, 0.375)
UMBRAGE_HIGHP float umbrage_decode_msm_hausdorff(UMBRAGE_HIGHP vec4 b, UMBRAGE_HIGHP float receiver,
                                                 UMBRAGE_HIGHP vec2 bias) {
    UMBRAGE_HIGHP float plain = umbrage_decode_msm(b, receiver, bias);
    UMBRAGE_HIGHP float d = umbrage_forward_depth(receiver);
    UMBRAGE_HIGHP float z = (d > 0.0 ? (d < 1.0 ? d : 1.0) : 0.0) * 2.0 - 1.0;
    UMBRAGE_HIGHP float share = umbrage_hausdorff_share(umbrage_bias_moments(b, bias), z);
    UMBRAGE_HIGHP float lit = share >= 0.0 ? 1.0 - share : plain;
    return d > 0.0 ? lit : (d <= 0.0 ? lit : 0.0);
}
)GLSL",
};

inline constexpr auto hausdorff_snippets = list<&hausdorff_share, &decode_msm_hausdorff>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/prefiltered/look_up.hpp
// Prefiltered maps from a shader or for one receiver: four texels, weighed, and what they say of visibility.
//
//     float visibility = umbrage::vsm(umbrage::clamped(moments), coord, depth - bias, 1e-6f);
//
// In a shader bind the snippet to the map of moments; texels are read one by one and weighed in steps of 1/256, so that
// any texture of floats will do. Where the sampler filters such a texture, or takes a level of its mip chain, ask it
// and call the decoder: umbrage_decode_vsm(texture(map, uv).xy, receiver, 1e-6); its weights are the hardware's.

namespace umbrage {

/// Mean of the four texels around a point.
/// @param fetch     ivec2 texel -> float or vector; called four times, texels may lie one outside the map
/// @param coord     in texels, the first texel's centre is (0.5, 0.5); inside texel space
/// @return          as fetch
/// @formula         ((a (256 - s) + b s) (256 - t) + (c (256 - s) + d s) t) / 65536, s and t whole numbers below 256;
///                  of texels below 2^111
/// @exactness       B;  A where texels are multiples of 2^-8 below 1
template <real T, class Fetch>
[[nodiscard]] auto fetch_bilinear(Fetch&& fetch, glm::vec<2, T> coord) {
    const glm::vec<2, T> x = glm::floor(coord * T(256)) - T(128);
    const glm::vec<2, T> texel = glm::floor(x * T(1.0 / 256.0));
    const glm::vec<2, T> hi = x - texel * T(256), lo = T(256) - hi;
    const glm::ivec2 at(texel);
    const auto a = fetch(at), b = fetch(at + glm::ivec2(1, 0));
    const auto c = fetch(at + glm::ivec2(0, 1)), d = fetch(at + glm::ivec2(1, 1));
    const auto low = a * lo.x + b * hi.x, high = c * lo.x + d * hi.x;
    return (low * lo.y + high * hi.y) * T(1.0 / 65536.0);
}

namespace detail {

/// What look-ups share: who is not compared is lit.
template <real T, class Fetch, class Decode>
[[nodiscard]] T look_up(Fetch&& fetch, glm::vec<2, T> coord, T receiver, T far, const Decode& decode) {
    const comparison is_lit{far < T(0.5) ? depth_direction::reversed : depth_direction::forward};
    return is_compared(coord, receiver, is_lit) ? decode(fetch_bilinear(fetch, coord)) : T(1);
}

}  // namespace detail

/// @param fetch      ivec2 texel -> texel of encode_vsm, blurred
/// @param coord      receiver in texels, the first texel's centre is (0.5, 0.5); outside texel space, or NaN: lit
/// @param receiver   depth, biased; beyond the far plane: lit; NaN is in shadow
/// @formula          decode_vsm of fetch_bilinear
/// @exactness        C, 1 ulp: a division
template <real T, class Fetch>
[[nodiscard]] T vsm(Fetch&& fetch, glm::vec<2, T> coord, T receiver, T min_variance, T far = T(1)) {
    return detail::look_up(fetch, coord, receiver, far,
                           [&](glm::vec<2, T> m) { return decode_vsm(m, receiver, min_variance, far); });
}

/// As vsm, of texels of encode_esm.
/// @exactness        B
template <real T, class Fetch>
[[nodiscard]] T esm(Fetch&& fetch, glm::vec<2, T> coord, T receiver, T exponent, T far = T(1)) {
    return detail::look_up(fetch, coord, receiver, far, [&](T m) { return decode_esm(m, receiver, exponent, far); });
}

/// As vsm, of texels of encode_evsm2.
/// @exactness        C, 1 ulp: a division
template <real T, class Fetch>
[[nodiscard]] T evsm2(Fetch&& fetch, glm::vec<2, T> coord, T receiver, T exponent, T deviation, T far = T(1)) {
    return detail::look_up(fetch, coord, receiver, far,
                           [&](glm::vec<2, T> m) { return decode_evsm2(m, receiver, exponent, deviation, far); });
}

/// As vsm, of texels of encode_evsm4.
/// @exactness        C, 1 ulp: a division
template <real T, class Fetch>
[[nodiscard]] T evsm4(Fetch&& fetch, glm::vec<2, T> coord, T receiver, glm::vec<2, T> exponents,
                      glm::vec<2, T> deviations, T far = T(1)) {
    return detail::look_up(fetch, coord, receiver, far,
                           [&](glm::vec<4, T> m) { return decode_evsm4(m, receiver, exponents, deviations, far); });
}

/// As vsm, of texels of encode_msm.
/// @exactness        C: within 1/64 in a shader
template <real T, class Fetch>
[[nodiscard]] T msm(Fetch&& fetch, glm::vec<2, T> coord, T receiver, glm::vec<2, T> bias, T far = T(1)) {
    return detail::look_up(fetch, coord, receiver, far,
                           [&](glm::vec<4, T> b) { return decode_msm(b, receiver, bias, far); });
}

/// As vsm, of texels of turn_moments(encode_msm).
/// @exactness        C: within 1/64 in a shader
template <real T, class Fetch>
[[nodiscard]] T msm_turned(Fetch&& fetch, glm::vec<2, T> coord, T receiver, glm::vec<2, T> bias, T far = T(1)) {
    return detail::look_up(fetch, coord, receiver, far,
                           [&](glm::vec<4, T> o) { return decode_msm(turn_moments_back(o), receiver, bias, far); });
}

/// As vsm, of texels of encode_msm, by decode_msm_hausdorff.
/// @exactness        C: as decode_msm_hausdorff
template <real T, class Fetch>
[[nodiscard]] T msm_hausdorff(Fetch&& fetch, glm::vec<2, T> coord, T receiver, glm::vec<2, T> bias, T far = T(1)) {
    return detail::look_up(fetch, coord, receiver, far,
                           [&](glm::vec<4, T> b) { return decode_msm_hausdorff(b, receiver, bias, far); });
}

namespace glsl {

inline constexpr snippet fetch_bilinear{
    .name = "fetch_bilinear",
    .summary = "mean of the four texels around a point",
    .exactness = tier::b,
    .needs = list<&fetch_clamped>,
    .source = R"GLSL(
// umbrage_fetch_bilinear: mean of the four texels around a point, weights in steps of 1/256
//   coord  in texels, first centre at (0.5, 0.5)
UMBRAGE_HIGHP vec4 umbrage_fetch_bilinear(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord) {
    UMBRAGE_HIGHP vec2 x = floor(coord * 256.0) - 128.0;
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    UMBRAGE_HIGHP vec2 hi = x - texel * 256.0;
    UMBRAGE_HIGHP vec2 lo = 256.0 - hi;
    UMBRAGE_HIGHP vec4 a = umbrage_fetch_clamped(map, size, texel);
    UMBRAGE_HIGHP vec4 b = umbrage_fetch_clamped(map, size, texel + vec2(1.0, 0.0));
    UMBRAGE_HIGHP vec4 c = umbrage_fetch_clamped(map, size, texel + vec2(0.0, 1.0));
    UMBRAGE_HIGHP vec4 d = umbrage_fetch_clamped(map, size, texel + vec2(1.0, 1.0));
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 low = a * lo.x + b * hi.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 high = c * lo.x + d * hi.x;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 sum = low * lo.y + high * hi.y;
    return sum * (1.0 / 65536.0);
}
)GLSL",
};

inline constexpr snippet vsm{
    .name = "vsm",
    .summary = "visibility from a map of encode_vsm's texels",
    .exactness = tier::c,
    .ulp = 1,
    .needs = list<&is_compared, &fetch_bilinear, &decode_vsm>,
    .source = R"GLSL(
// umbrage_vsm: visibility from a map of encode_vsm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased;   min_variance  0.0 or more
UMBRAGE_HIGHP float umbrage_vsm(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float min_variance) {
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_vsm(vec2(m.x, m.y), receiver, min_variance);
    return compared ? lit : 1.0;
}
)GLSL",
};

inline constexpr snippet esm{
    .name = "esm",
    .summary = "visibility from a map of encode_esm's texels",
    .exactness = tier::b,
    .needs = list<&is_compared, &fetch_bilinear, &decode_esm>,
    .source = R"GLSL(
// umbrage_esm: visibility from a map of encode_esm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased;   exponent  as of the texels
UMBRAGE_HIGHP float umbrage_esm(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float exponent) {
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_esm(m.x, receiver, exponent);
    return compared ? lit : 1.0;
}
)GLSL",
};

inline constexpr snippet evsm2{
    .name = "evsm2",
    .summary = "visibility from a map of encode_evsm2's texels",
    .exactness = tier::c,
    .ulp = 1,
    .needs = list<&is_compared, &fetch_bilinear, &decode_evsm2>,
    .source = R"GLSL(
// umbrage_evsm2: visibility from a map of encode_evsm2's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased;   exponent, deviation  as of decode_evsm2
UMBRAGE_HIGHP float umbrage_evsm2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                  UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float exponent,
                                  UMBRAGE_HIGHP float deviation) {
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_evsm2(vec2(m.x, m.y), receiver, exponent, deviation);
    return compared ? lit : 1.0;
}
)GLSL",
};

inline constexpr snippet evsm4{
    .name = "evsm4",
    .summary = "visibility from a map of encode_evsm4's texels",
    .exactness = tier::c,
    .ulp = 1,
    .needs = list<&is_compared, &fetch_bilinear, &decode_evsm4>,
    .source = R"GLSL(
// umbrage_evsm4: visibility from a map of encode_evsm4's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased;   exponents, deviations  as of decode_evsm4
UMBRAGE_HIGHP float umbrage_evsm4(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                  UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 exponents,
                                  UMBRAGE_HIGHP vec2 deviations) {
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_evsm4(m, receiver, exponents, deviations);
    return compared ? lit : 1.0;
}
)GLSL",
};

inline constexpr snippet msm{
    .name = "msm",
    .summary = "visibility from a map of encode_msm's texels",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .needs = list<&is_compared, &fetch_bilinear, &decode_msm>,
    .source = R"GLSL(
// umbrage_msm: visibility from a map of encode_msm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased;   bias  as of decode_msm
UMBRAGE_HIGHP float umbrage_msm(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 bias) {
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_msm(m, receiver, bias);
    return compared ? lit : 1.0;
}
)GLSL",
};

inline constexpr snippet msm_turned{
    .name = "msm_turned",
    .summary = "visibility from a map of turned moments",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .needs = list<&is_compared, &fetch_bilinear, &decode_msm, &turn_moments_back>,
    .source = R"GLSL(
// umbrage_msm_turned: visibility from a map of turned moments, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased;   bias  as of decode_msm
UMBRAGE_HIGHP float umbrage_msm_turned(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                       UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 bias) {
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_msm(umbrage_turn_moments_back(m), receiver, bias);
    return compared ? lit : 1.0;
}
)GLSL",
};

inline constexpr snippet msm_hausdorff{
    .name = "msm_hausdorff",
    .summary = "visibility from a map of encode_msm's texels",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .needs = list<&is_compared, &fetch_bilinear, &decode_msm_hausdorff>,
    .source = R"GLSL(
// umbrage_msm_hausdorff: visibility from a map of encode_msm's texels, blurred; 1.0 is lit
//   map, size  prefiltered map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased;   bias  as of decode_msm
UMBRAGE_HIGHP float umbrage_msm_hausdorff(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                          UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP vec2 bias) {
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec4 m = umbrage_fetch_bilinear(map, size, compared ? coord : vec2(0.0, 0.0));
    UMBRAGE_HIGHP float lit = umbrage_decode_msm_hausdorff(m, receiver, bias);
    return compared ? lit : 1.0;
}
)GLSL",
};

inline constexpr auto look_up_snippets =
    list<&fetch_bilinear, &vsm, &esm, &evsm2, &evsm4, &msm, &msm_turned, &msm_hausdorff>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/prefiltered/prefilters.hpp
// Prefiltered maps as values: what a texel is, how depth becomes one, what a mean of texels says. One list, which
// functions over images, tools and tables walk.
//
//     umbrage::prefilters::evsm4 filter{umbrage::make_evsm({.exponent = 30.0f})};
//     glm::vec4 texel = filter.encode(depth);
//     float visibility = filter.decode(blurred, receiver);
//

namespace umbrage::prefilters {

/// Depth and its square: two floats of 32 bits. Light bleeds through behind casters that lie behind each other.
struct vsm {
    using texel = glm::vec2;
    static constexpr std::string_view name = "vsm";
    static constexpr const glsl::snippet *writer = &glsl::encode_vsm, *snippet = &glsl::vsm;

    float min_variance = 1e-6f;
    depth_direction direction = depth_direction::forward;

    [[nodiscard]] UMBRAGE_INLINE texel encode(float depth) const { return encode_vsm(depth, cleared_depth(direction)); }
    [[nodiscard]] UMBRAGE_INLINE float decode(texel m, float receiver) const {
        return decode_vsm(m, receiver, min_variance, cleared_depth(direction));
    }
};

/// One power of depth. Light bleeds through where a lit surface lies behind the receiver in the same window.
struct esm {
    using texel = float;
    static constexpr std::string_view name = "esm";
    static constexpr const glsl::snippet *writer = &glsl::encode_esm, *snippet = &glsl::esm;

    esm_settings settings{};
    depth_direction direction = depth_direction::forward;

    [[nodiscard]] UMBRAGE_INLINE texel encode(float depth) const {
        return encode_esm(depth, settings.exponent, cleared_depth(direction));
    }
    [[nodiscard]] UMBRAGE_INLINE float decode(texel m, float receiver) const {
        return decode_esm(m, receiver, settings.exponent, cleared_depth(direction));
    }
};

/// A power of depth and its square.
struct evsm2 {
    using texel = glm::vec2;
    static constexpr std::string_view name = "evsm2";
    static constexpr const glsl::snippet *writer = &glsl::encode_evsm2, *snippet = &glsl::evsm2;

    evsm_parameters parameters = make_evsm({});
    depth_direction direction = depth_direction::forward;

    [[nodiscard]] UMBRAGE_INLINE texel encode(float depth) const {
        return encode_evsm2(depth, parameters.exponents.x, cleared_depth(direction));
    }
    [[nodiscard]] UMBRAGE_INLINE float decode(texel m, float receiver) const {
        return decode_evsm2(m, receiver, parameters.exponents.x, parameters.deviations.x, cleared_depth(direction));
    }
};

/// A growing and a falling power, and their squares: the least light of those with moments of two depths.
struct evsm4 {
    using texel = glm::vec4;
    static constexpr std::string_view name = "evsm4";
    static constexpr const glsl::snippet *writer = &glsl::encode_evsm4, *snippet = &glsl::evsm4;

    evsm_parameters parameters = make_evsm({});
    depth_direction direction = depth_direction::forward;

    [[nodiscard]] UMBRAGE_INLINE texel encode(float depth) const {
        return encode_evsm4(depth, parameters.exponents, cleared_depth(direction));
    }
    [[nodiscard]] UMBRAGE_INLINE float decode(texel m, float receiver) const {
        return decode_evsm4(m, receiver, parameters.exponents, parameters.deviations, cleared_depth(direction));
    }
};

/// Four moments in floats of 32 bits.
struct msm {
    using texel = glm::vec4;
    static constexpr std::string_view name = "msm";
    static constexpr const glsl::snippet *writer = &glsl::encode_msm, *snippet = &glsl::msm;

    glm::vec2 bias = msm_bias_32;
    depth_direction direction = depth_direction::forward;

    [[nodiscard]] UMBRAGE_INLINE texel encode(float depth) const { return encode_msm(depth, cleared_depth(direction)); }
    [[nodiscard]] UMBRAGE_INLINE float decode(texel b, float receiver) const {
        return decode_msm(b, receiver, bias, cleared_depth(direction));
    }
    [[nodiscard]] UMBRAGE_INLINE glm::vec4 moments(texel b) const { return bias_moments(b, bias); }
};

/// Four moments for channels of 16 bits.
struct msm_turned {
    using texel = glm::vec4;
    static constexpr std::string_view name = "msm_turned";
    static constexpr const glsl::snippet *writer = &glsl::turn_moments, *snippet = &glsl::msm_turned;

    glm::vec2 bias = msm_bias_16;
    depth_direction direction = depth_direction::forward;

    [[nodiscard]] UMBRAGE_INLINE texel encode(float depth) const {
        return turn_moments(encode_msm(depth, cleared_depth(direction)));
    }
    [[nodiscard]] UMBRAGE_INLINE float decode(texel o, float receiver) const {
        return decode_msm(turn_moments_back(o), receiver, bias, cleared_depth(direction));
    }
    [[nodiscard]] UMBRAGE_INLINE glm::vec4 moments(texel o) const { return bias_moments(turn_moments_back(o), bias); }
};

/// Four moments in floats of 32 bits, of depths known to lie in [0, 1].
struct msm_hausdorff {
    using texel = glm::vec4;
    static constexpr std::string_view name = "msm_hausdorff";
    static constexpr const glsl::snippet *writer = &glsl::encode_msm, *snippet = &glsl::msm_hausdorff;

    glm::vec2 bias = msm_bias_32;
    depth_direction direction = depth_direction::forward;

    [[nodiscard]] UMBRAGE_INLINE texel encode(float depth) const { return encode_msm(depth, cleared_depth(direction)); }
    [[nodiscard]] UMBRAGE_INLINE float decode(texel b, float receiver) const {
        return decode_msm_hausdorff(b, receiver, bias, cleared_depth(direction));
    }
    [[nodiscard]] UMBRAGE_INLINE glm::vec4 moments(texel b) const { return bias_moments(b, bias); }
    /// Visibility from decode_msm's.
    [[nodiscard]] UMBRAGE_INLINE static float within(float plain, const glm::vec4& moments, float forward) {
        return detail::lit_within(plain, moments, forward);
    }
};

using all = list_of<vsm, esm, evsm2, evsm4, msm, msm_turned, msm_hausdorff>;

}  // namespace umbrage::prefilters

// ---- umbrage/filter/prefiltered/reduce.hpp
// Blur and mip chain of prefiltered maps, for passes of shaders: texels of the map that a pass reads make one of the
// map that it writes. Over images: blur() and make_mip_chain(), which give the same bits.
//
//     out_texel = umbrage_blur_row5(map, size, texel, vec2(0.0, 1.0));  // first along y into a map of its own,
//     out_texel = umbrage_blur_row5(map, size, texel, vec2(1.0, 0.0));  // then that along x
//

namespace umbrage {
namespace detail {

/// Row Taps - 1 of Pascal's triangle, from the middle on.
template <int Taps>
[[nodiscard]] constexpr int binomial_weight(int distance) {
    int weight = 1;
    for (int i = 0; i < Taps / 2 - distance; ++i) weight = weight * (Taps - 1 - i) / (i + 1);
    return weight;
}

}  // namespace detail

/// Mean of texels in a row, weighed by a row of Pascal's triangle.
/// @param fetch     ivec2 texel -> float or vector; called Taps times, texels may lie outside the map
/// @param step      (1, 0) along x, (0, 1) along y
/// @formula         w0 c + w1 (before1 + after1) + ..., in this order,
///                  w_i = C(Taps - 1, (Taps - 1) / 2 + i) / 2^(Taps - 1)
/// @exactness       B;  A for 5 taps both ways over multiples of 2^-16 below 1
template <int Taps, class Fetch>
[[nodiscard]] auto blur_row(Fetch&& fetch, glm::ivec2 texel, glm::ivec2 step) {
    static_assert(Taps == 3 || Taps == 5 || Taps == 7);
    const auto weight = [](int i) {
        return static_cast<float>(detail::binomial_weight<Taps>(i)) / static_cast<float>(1 << (Taps - 1));
    };
    auto sum = fetch(texel) * weight(0);
    for (int i = 1; i <= Taps / 2; ++i) sum = sum + (fetch(texel - step * i) + fetch(texel + step * i)) * weight(i);
    return sum;
}

/// Mean of the 2x2 texels that one of the next level of a mip chain is made of.
/// @param texel     of the next level; where a level's size is odd, its last column or row counts twice
/// @formula         ((a + b) + (c + d)) / 4
/// @exactness       B;  A for multiples of 2^-22 below 1
template <class Fetch>
[[nodiscard]] auto halve_texels(Fetch&& fetch, glm::ivec2 texel) {
    const glm::ivec2 at = texel * 2;
    const auto a = fetch(at), b = fetch(at + glm::ivec2(1, 0));
    const auto c = fetch(at + glm::ivec2(0, 1)), d = fetch(at + glm::ivec2(1, 1));
    return ((a + b) + (c + d)) * 0.25f;
}

namespace glsl {

template <int Taps>
inline constexpr detail::short_name blur_row_name("blur_row$n", {{'n', Taps}});
template <int Taps>
[[nodiscard]] std::string blur_row_text() {
    std::string out =
        detail::filled(R"GLSL(
// umbrage_blur_row$n: mean of $n texels in a row, weighed by a row of Pascal's triangle
//   map, size  read from, and its size in texels;   texel  whole numbers, (0, 0) is the first
//   along      (1.0, 0.0) or (0.0, 1.0)
UMBRAGE_HIGHP vec4 umbrage_blur_row$n(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                     UMBRAGE_HIGHP vec2 along) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 sum = umbrage_fetch_clamped(map, size, texel) * ($w.0 / $d.0);
)GLSL",
                       {{'n', Taps}, {'w', umbrage::detail::binomial_weight<Taps>(0)}, {'d', 1 << (Taps - 1)}});
    for (int i = 1; i <= Taps / 2; ++i)
        detail::append(out,
                       R"GLSL(    UMBRAGE_HIGHP vec4 before$i = umbrage_fetch_clamped(map, size, texel - along * $i.0);
    UMBRAGE_HIGHP vec4 after$i = umbrage_fetch_clamped(map, size, texel + along * $i.0);
    sum = sum + (before$i + after$i) * ($w.0 / $d.0);
)GLSL",
                       {{'i', i}, {'w', umbrage::detail::binomial_weight<Taps>(i)}, {'d', 1 << (Taps - 1)}});
    out += "    return sum;\n}\n";
    return out;
}
template <int Taps>
inline constexpr snippet blur_row{.name = blur_row_name<Taps>.view(),
                                  .summary = "mean of texels in a row",
                                  .exactness = tier::b,
                                  .needs = list<&fetch_clamped>,
                                  .source = blur_row_text<Taps>};

inline constexpr snippet halve_texels{
    .name = "halve_texels",
    .summary = "mean of 2x2 texels",
    .exactness = tier::b,
    .needs = list<&fetch_clamped>,
    .source = R"GLSL(
// umbrage_halve_texels: mean of the 2x2 texels that a texel of the next level of a mip chain is made of
//   map, size  read from, and its size in texels;   texel  of the next level, whole numbers
UMBRAGE_HIGHP vec4 umbrage_halve_texels(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP vec2 at = texel * 2.0;
    UMBRAGE_HIGHP vec4 a = umbrage_fetch_clamped(map, size, at);
    UMBRAGE_HIGHP vec4 b = umbrage_fetch_clamped(map, size, at + vec2(1.0, 0.0));
    UMBRAGE_HIGHP vec4 c = umbrage_fetch_clamped(map, size, at + vec2(0.0, 1.0));
    UMBRAGE_HIGHP vec4 d = umbrage_fetch_clamped(map, size, at + vec2(1.0, 1.0));
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 sum = (a + b) + (c + d);
    return sum * 0.25;
}
)GLSL",
};

inline constexpr auto reduce_snippets = list<&blur_row<3>, &blur_row<5>, &blur_row<7>, &halve_texels>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/table/summed_moments.hpp
// Moment shadows from a summed-area table: a box of any size from its four corners.
//
//     umbrage::image<glm::u16vec4> table = umbrage::make_moment_table(map, {.radius = 16});
//     float visibility = umbrage::summed_moments(umbrage::clamped(table), table.size(), coord, depth - bias, 16.0f,
//                                                umbrage::msm_bias_16);
//
// The table holds turned moments as whole numbers of 16 bits, so that their sums over a box are exact: its left half
// has the sums modulo 2^16, its right half what they are over 2^16. That is one texture of RGBA16UI.

namespace umbrage {

/// Mean of four whole numbers below 2^16 over a box.
/// @param table        ivec2 -> four whole numbers below 2^16: in the left half sums modulo 2^16 of all texels before
///                     a column and a row, in the right half the same sums over 2^16, modulo 2^16
/// @param half_width   columns of either half
/// @param first        of the box: lowest column and row;   end  highest and one, first < end
/// @formula            (a - b - c + d) mod 2^32 over the number of texels
/// @exactness          C, 1 ulp: a division; its dividend is the sum to half an ulp, while that is below 2^32, however
///                     often the table has wrapped
template <real T, class Fetch>
[[nodiscard]] glm::vec<4, T> box_mean(Fetch&& table, int half_width, glm::ivec2 first, glm::ivec2 end) {
    const auto part = [&](int right) {
        const glm::ivec2 half(right, 0);
        const glm::vec<4, T> a(table(half + end)), b(table(half + glm::ivec2(first.x, end.y)));
        const glm::vec<4, T> c(table(half + glm::ivec2(end.x, first.y))), d(table(half + first));
        return (a - b) - (c - d);
    };
    const glm::vec<4, T> low = part(0), carry = glm::floor(low * T(1.0 / 65536.0)), above = part(half_width) + carry;
    const glm::vec<4, T> high = above - glm::floor(above * T(1.0 / 65536.0)) * T(65536);
    const glm::vec<2, T> sides(end - first);
    return (high * T(65536) + (low - carry * T(65536))) / (sides.x * sides.y);
}

/// Share of the texels in a box that can be lit, from their four moments.
/// @param table      as make_moment_table makes it
/// @param size       of the table in texels: (2 (w + 1), h + 1) of a map of w x h
/// @param coord      receiver in texels of the map, the first texel's centre is (0.5, 0.5); outside texel space, or
///                   NaN: lit; what of the box lies outside the map does not count
/// @param receiver   depth, biased; beyond the far plane: lit; NaN is in shadow
/// @param radius     whole, >= 0: the box has 2 radius + 1 texels a side; at most the table's
/// @param bias       msm_bias_16
/// @return           visibility: at least the lit share of the box, less bias.x and decode_msm's error
/// @formula          decode_msm of box_mean / 65535, turned back
/// @exactness        C: within 1/64 in a shader
/// @cite             Peters, Klein: Moment shadow mapping, I3D 2015; Crow: Summed-area tables for texture mapping,
///                   SIGGRAPH 1984
template <real T, class Fetch>
[[nodiscard]] T summed_moments(Fetch&& table, glm::ivec2 size, glm::vec<2, T> coord, T receiver, T radius,
                               glm::vec<2, T> bias, T far = T(1)) {
    const comparison is_lit{far < T(0.5) ? depth_direction::reversed : depth_direction::forward};
    if (!is_compared(coord, receiver, is_lit)) return T(1);
    const glm::ivec2 map(size.x / 2 - 1, size.y - 1);
    const glm::ivec2 texel = glm::clamp(glm::ivec2(glm::floor(coord)), glm::ivec2(0), map - 1);
    const int reach = static_cast<int>(radius);
    const glm::ivec2 first = glm::max(texel - reach, glm::ivec2(0)), end = glm::min(texel + reach + 1, map);
    const glm::vec<4, T> turned = box_mean<T>(table, size.x / 2, first, end) * T(1.0 / 65535.0);
    return decode_msm(turn_moments_back(turned), receiver, bias, far);
}

namespace glsl {

inline constexpr snippet box_mean{
    .name = "box_mean",
    .summary = "mean of four whole numbers over a box, from a summed-area table in two halves",
    .exactness = tier::c,
    .ulp = 1,
    .needs = list<&texel>,
    .source = R"GLSL(
// umbrage_box_mean: mean of four whole numbers below 65536.0 over a box
//   map, size  a table of make_moment_table and its size;   first, end  of the box, first < end
UMBRAGE_HIGHP vec4 umbrage_box_mean(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 first,
                                    UMBRAGE_HIGHP vec2 end) {
    UMBRAGE_HIGHP float right = size.x * 0.5;
    UMBRAGE_HIGHP vec4 a = umbrage_texel(map, size, end);
    UMBRAGE_HIGHP vec4 b = umbrage_texel(map, size, vec2(first.x, end.y));
    UMBRAGE_HIGHP vec4 c = umbrage_texel(map, size, vec2(end.x, first.y));
    UMBRAGE_HIGHP vec4 d = umbrage_texel(map, size, first);
    UMBRAGE_HIGHP vec4 low = (a - b) - (c - d);
    UMBRAGE_HIGHP vec4 carry = floor(low * (1.0 / 65536.0));
    a = umbrage_texel(map, size, vec2(right + end.x, end.y));
    b = umbrage_texel(map, size, vec2(right + first.x, end.y));
    c = umbrage_texel(map, size, vec2(right + end.x, first.y));
    d = umbrage_texel(map, size, vec2(right + first.x, first.y));
    UMBRAGE_HIGHP vec4 above = (a - b) - (c - d) + carry;
    UMBRAGE_HIGHP vec4 high = above - floor(above * (1.0 / 65536.0)) * 65536.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 sum = high * 65536.0 + (low - carry * 65536.0);
    UMBRAGE_HIGHP vec2 sides = end - first;
    return sum / (sides.x * sides.y);
}
)GLSL",
};

inline constexpr snippet summed_moments{
    .name = "summed_moments",
    .summary = "moment shadow over a box of any size, from a summed-area table",
    .exactness = tier::c,
    .within = 1.0f / 64.0f,
    .needs = list<&is_compared, &box_mean, &turn_moments_back, &decode_msm>,
    .source = R"GLSL(
// umbrage_summed_moments: moment shadow from a summed-area table; visibility, 1.0 is lit
//   map, size  the table, of make_moment_table, and its size: twice the shadow map's width and two, its height and one
//   coord, receiver  in texels of the shadow map, first centre at (0.5, 0.5), and depth, biased
//   radius     whole: the box has 2 radius + 1 texels a side;   bias  (6e-5, 0.628)
UMBRAGE_HIGHP float umbrage_summed_moments(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                           UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                           UMBRAGE_HIGHP vec2 bias) {
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec2 last = vec2(size.x * 0.5, size.y) - 1.0;
    UMBRAGE_HIGHP vec2 texel = compared ? clamp(floor(coord), vec2(0.0, 0.0), last - 1.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 first = max(texel - radius, vec2(0.0, 0.0));
    UMBRAGE_HIGHP vec2 end = min(texel + radius + 1.0, last);
    UMBRAGE_HIGHP vec4 turned = umbrage_box_mean(map, size, first, end) * (1.0 / 65535.0);
    UMBRAGE_HIGHP float lit = umbrage_decode_msm(umbrage_turn_moments_back(turned), receiver, bias);
    return compared ? lit : 1.0;
}
)GLSL",
};

inline constexpr auto summed_moments_snippets = list<&box_mean, &summed_moments>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/table/summed_variance.hpp
// Variance shadows from a summed-area table: a box of any size from four texels.
//
//     umbrage::image<glm::u16vec4> table = umbrage::make_variance_table(map, {.bits = 11, .radius = 16});
//     float visibility =
//         umbrage::summed_variance(umbrage::clamped(table), map.size(), coord, depth - bias, 16.0f, 2048.0f);
//
// The table's sums are whole numbers modulo 2^32, and so are their differences: exact while what they say of a box is
// below 2^32. Squares are taken about the box's mean, rounded down, and never leave whole numbers: nothing cancels but
// what is exact, as n S2 - S1^2 would in floats.

namespace umbrage {

/// What a table says of the codes in a box of n texels.
/// @param table   ivec2 -> four whole numbers below 2^16: sums of codes modulo 2^16 and over 2^16, and of their
///                squares; of all texels before a column and a row
/// @param first   of the box: lowest column and row;   end  highest and one, first < end
/// @return        (mean, rest, high, low): the codes' sum is n mean + rest, rest < n, and the sum of their squared
///                distances from mean is 4096 high + low, low < 4096
/// @formula       with T = sum + rest: squares - mean T, in digits of 12 bits
/// @exactness     A while codes are below 2^12, n times the codes that there are at most 2^24 and the squared
///                distances' sum < 2^32, which make_variance_table sees to, however often the table has wrapped
template <real T, class Fetch>
[[nodiscard]] glm::vec<4, T> box_moments(Fetch&& table, glm::ivec2 first, glm::ivec2 end) {
    using four = glm::vec<4, T>;
    const four a(table(end)), b(table(glm::ivec2(first.x, end.y)));
    const four c(table(glm::ivec2(end.x, first.y))), d(table(first));
    const four part = (a - b) - (c - d);
    const T carry_1 = glm::floor(part.x * T(1.0 / 65536.0)), carry_2 = glm::floor(part.z * T(1.0 / 65536.0));
    const T above_1 = part.y + carry_1, above_2 = part.w + carry_2;
    const T low_1 = part.x - carry_1 * T(65536), low_2 = part.z - carry_2 * T(65536);
    const T high_1 =
        glm::max(above_1 - glm::floor(above_1 * T(1.0 / 65536.0)) * T(65536), T(0));  // or a compiler distributes
    const T sum = high_1 * T(65536) + low_1;
    const T high_2 = above_2 - glm::floor(above_2 * T(1.0 / 65536.0)) * T(65536);
    const glm::vec<2, T> sides(end - first);
    const T n = sides.x * sides.y, mean = floor_divide(sum, n), rest = sum - mean * n, factor = sum + rest;
    const T factor_high = glm::floor(factor * T(1.0 / 4096.0)), factor_low = factor - factor_high * T(4096);
    const T square_high = glm::floor(low_2 * T(1.0 / 4096.0)), square_low = low_2 - square_high * T(4096);
    const T below = square_low - mean * factor_low, borrow = glm::floor(below * T(1.0 / 4096.0));
    const T wide = high_2 * T(16) + square_high - mean * factor_high + borrow;
    const T high = wide - glm::floor(wide * T(1.0 / 1048576.0)) * T(1048576);
    return {mean, rest, high, below - borrow * T(4096)};
}

/// Share of the texels in a box that can be lit: Chebyshev's bound, from its mean and variance.
/// @param table      as make_variance_table makes it
/// @param size       of the map in texels; the table has one more column and row
/// @param coord      receiver in texels, the first texel's centre is (0.5, 0.5); outside texel space, or NaN: lit; what
///                   of the box lies outside the map does not count
/// @param receiver   depth, biased; beyond the far plane: lit; NaN is in shadow
/// @param radius     whole, >= 0: the box has 2 radius + 1 texels a side; at most the table's
/// @param codes      2^bits of the table
/// @return           visibility: 1 where the receiver is no farther than the mean, else an upper bound on the lit share
/// @formula          m, v mean and variance of the codes + 1: d = codes receiver - m; d <= 0 ? 1 : v / (v + d^2)
/// @exactness        C: two divisions, on numbers that do not cancel; within 2^-16, as d is off by 2^-23 where v is at
///                   least 1/64^2
/// @cite             Lauritzen: Summed-area variance shadow maps, GPU Gems 3, 2007; Donnelly, Lauritzen: Variance
///                   shadow maps, I3D 2006
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T summed_variance(Fetch&& table, glm::ivec2 size, glm::vec<2, T> coord, T receiver, T radius, T codes,
                                Compare is_lit = {}) {
    if (!is_compared(coord, receiver, is_lit)) return T(1);
    const glm::ivec2 texel = glm::clamp(glm::ivec2(glm::floor(coord)), glm::ivec2(0), size - 1);
    const int reach = static_cast<int>(radius);
    const glm::ivec2 first = glm::max(texel - reach, glm::ivec2(0)), end = glm::min(texel + reach + 1, size);
    const glm::vec<4, T> m = box_moments<T>(table, first, end);
    const T n = T((end.x - first.x) * (end.y - first.y)), share = m.y / n;
    const T variance = (m.z * T(4096) + (m.w - m.y)) / n + share * (T(1) - share);
    const T scaled = receiver * codes, t = is_lit(T(0), T(1)) ? scaled : codes - scaled;
    const T d = (t - T(1) - m.x) - share;
    if (is_nan(d)) return T(0);
    return d <= T(0) ? T(1) : variance / (variance + d * d);
}

namespace glsl {
inline constexpr snippet box_moments{
    .name = "box_moments",
    .summary = "mean and squared distances from it over a box, from a summed-area table",
    .exactness = tier::a,
    .needs = list<&texel, &floor_divide>,
    .source = R"GLSL(
// umbrage_box_moments: (mean, rest, high, low) of the codes in a box of n texels: their sum is n mean + rest, and
//   that of their squared distances from mean 4096 high + low;  whole numbers
//   map, size  a table of make_variance_table and its size;   first, end  of the box, first < end
UMBRAGE_HIGHP vec4 umbrage_box_moments(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 first,
                                       UMBRAGE_HIGHP vec2 end) {
    UMBRAGE_HIGHP vec4 a = umbrage_texel(map, size, end);
    UMBRAGE_HIGHP vec4 b = umbrage_texel(map, size, vec2(first.x, end.y));
    UMBRAGE_HIGHP vec4 c = umbrage_texel(map, size, vec2(end.x, first.y));
    UMBRAGE_HIGHP vec4 d = umbrage_texel(map, size, first);
    UMBRAGE_HIGHP vec4 part = (a - b) - (c - d);
    UMBRAGE_HIGHP vec2 low = vec2(part.x, part.z);
    UMBRAGE_HIGHP vec2 carry = floor(low * (1.0 / 65536.0));
    UMBRAGE_HIGHP vec2 above = vec2(part.y, part.w) + carry;
    low = low - carry * 65536.0;
    above = max(above - floor(above * (1.0 / 65536.0)) * 65536.0, vec2(0.0, 0.0));  // or a compiler distributes
    UMBRAGE_HIGHP float sum = above.x * 65536.0 + low.x;
    UMBRAGE_HIGHP vec2 sides = end - first;
    UMBRAGE_HIGHP float n = sides.x * sides.y;
    UMBRAGE_HIGHP float mean = umbrage_floor_divide(sum, n);
    UMBRAGE_HIGHP float rest = sum - mean * n;
    UMBRAGE_HIGHP vec2 digits = vec2(sum + rest, low.y);
    UMBRAGE_HIGHP vec2 high = floor(digits * (1.0 / 4096.0));
    digits = digits - high * 4096.0;
    UMBRAGE_HIGHP float below = digits.y - mean * digits.x;
    UMBRAGE_HIGHP float borrow = floor(below * (1.0 / 4096.0));
    UMBRAGE_HIGHP float wide = above.y * 16.0 + high.y - mean * high.x + borrow;
    wide = wide - floor(wide * (1.0 / 1048576.0)) * 1048576.0;
    return vec4(mean, rest, wide, below - borrow * 4096.0);
}
)GLSL",
};

inline constexpr snippet summed_variance{
    .name = "summed_variance",
    .summary = "variance shadow over a box of any size, from a summed-area table",
    .exactness = tier::c,
    .within = 1.0f / 65536.0f,
    .needs = list<&is_compared, &cleared_depth, &box_moments>,
    .source = R"GLSL(
// umbrage_summed_variance: variance shadow from a summed-area table; visibility, 1.0 is lit
//   map, size  the table, of make_variance_table, and its size: one more than the shadow map's
//   coord, receiver  in texels of the shadow map, first centre at (0.5, 0.5), and depth, biased
//   radius     whole: the box has 2 radius + 1 texels a side;   codes  2^bits of the table
UMBRAGE_HIGHP float umbrage_summed_variance(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                            UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float radius,
                                            UMBRAGE_HIGHP float codes) {
    bool compared = umbrage_is_compared(coord, receiver);
    UMBRAGE_HIGHP vec2 last = size - 1.0;
    UMBRAGE_HIGHP vec2 texel = compared ? clamp(floor(coord), vec2(0.0, 0.0), last - 1.0) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 first = max(texel - radius, vec2(0.0, 0.0));
    UMBRAGE_HIGHP vec2 end = min(texel + radius + 1.0, last);
    UMBRAGE_HIGHP vec4 m = umbrage_box_moments(map, size, first, end);
    UMBRAGE_HIGHP vec2 sides = end - first;
    UMBRAGE_HIGHP float n = sides.x * sides.y;
    UMBRAGE_HIGHP float share = m.y / n;
    UMBRAGE_HIGHP float variance = (m.z * 4096.0 + (m.w - m.y)) / n + share * (1.0 - share);
    UMBRAGE_HIGHP float scaled = receiver * codes;
    UMBRAGE_HIGHP float t = umbrage_cleared_depth() > 0.5 ? scaled : codes - scaled;
    UMBRAGE_HIGHP float d = (t - 1.0 - m.x) - share;
    UMBRAGE_HIGHP float behind = d > 0.0 ? variance / (variance + d * d) : 0.0;
    return compared ? (d <= 0.0 ? 1.0 : behind) : 1.0;
}
)GLSL",
};

inline constexpr auto summed_variance_snippets = list<&box_moments, &summed_variance>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/light/adaptive/page_table.hpp
// Where in an atlas of pages a receiver's shadow lies: one fetch from a small table, a texel of which stands for each
// of the finest cells of a square, the root, that the light looks at, and for what lies around it.
//
//     glm::vec3 p(umbrage::shadow_coordinate(to_root, world));  // x and y from 1 to 2 across the root
//     glm::vec4 at = umbrage::page_coordinate(umbrage::clamped(table), 1026.0f, glm::vec2(p), 128.0f, 4.0f);
//     const auto page = atlas.view().region(glm::ivec2(at.z, at.w), glm::ivec2(136));
//     float visibility = umbrage::pcf_2x2(umbrage::clamped(page), glm::vec2(at), p.z - bias);
//
// A shader binds the filter to the atlas, a region of which each page is:
//
//     glsl::source(glsl::version::v330, {glsl::page_coordinate,
//                                        bind(glsl::pcf_2x2, "page", {.texture = texture::atlas})});
//     // vec4 at = umbrage_page_coordinate(table, vec2(1026.0), p.xy, 128.0, 4.0);
//     // umbrage_pcf_2x2_page(atlas, at.zw, vec2(136.0), at.xy, p.z)
//
// The root goes from 1 to 2, not from 0: all its coordinates then have 23 bits behind the point, so that a place in a
// page has a gutter added without rounding.

namespace umbrage {

/// Most times that the root may be halved: its side then holds 2^15 pages.
inline constexpr int deepest_page_level = 15;

/// A texel of a page table: RGBA8, read with the nearest filter. How many pages of its level the root is wide stands
/// there as a number, low byte first, in place of its logarithm, from which shaders would have to make it in steps. A
/// power of two has a single bit: one of the bytes is 0, and both together round once.
/// @param slot    of the page in the atlas, each 0 .. 255;   level  0 .. 15: its side is the root's over 2^level
/// @return        all zero, which no page gives, stands for no page
[[nodiscard]] inline glm::u8vec4 page_entry(glm::ivec2 slot, int level) {
    const auto byte = [](int v) { return static_cast<std::uint8_t>(v & 0xFF); };
    return {byte(slot.x), byte(slot.y), byte(1 << level), byte((1 << level) >> 8)};
}

/// A receiver in the page that holds it.
///
/// @param table    ivec2 -> page_entry, of size x size texels, the outermost all zero; called once, with a texel inside
/// @param size     of the table: a power of two up to 2^15, the root's side in its finest cells, and 2
/// @param coord    receiver, 1 .. 2 across the root
/// @param page     side of a page, texels: a power of two;   gutter  texels around each page, whole, at most page / 2
/// @return         (x, y) in texels of the page with its gutter, (page + 2 gutter)^2 of the atlas from the texel (z, w)
///                 on. Beside the root and without a page (32768, 32768, 0, 0), which every filter takes as lit; a
///                 coordinate that is NaN or infinite gives more than that or NaN
/// @formula        origin = slot (page + 2 gutter); (coord 2^level - floor(coord 2^level)) page + gutter
/// @exactness      A, for bytes read within 2^-(level + 2) of themselves
/// @cite           Fernando, Fernandez, Bala, Greenberg: Adaptive Shadow Maps, SIGGRAPH 2001
template <real T, class Table>
[[nodiscard]] glm::vec<4, T> page_coordinate(Table&& table, T size, glm::vec<2, T> coord, T page, T gutter) {
    const auto inside = [size](T v) { return is_nan(v) || !(v > T(0)) ? T(0) : (v < size ? v : size - T(1)); };
    const glm::vec<2, T> cell = coord * (size - T(2)) - (size - T(3));  // of the table
    const glm::u8vec4 entry = table(glm::ivec2(static_cast<int>(inside(cell.x)), static_cast<int>(inside(cell.y))));
    const T across = T(entry.z) + T(entry.w) * T(256);
    const glm::vec<2, T> place = coord * across;
    const glm::vec<2, T> at = (place - glm::floor(place)) * page + (across > T(0) ? gutter : T(32768));
    return {at.x, at.y, T(entry.x) * (page + gutter * T(2)), T(entry.y) * (page + gutter * T(2))};
}

namespace glsl {

inline constexpr snippet page_coordinate{
    .name = "page_coordinate",
    .summary = "a receiver in the page of an atlas that holds it",
    .exactness = tier::a,
    .needs = list<&texel, &from_unorm>,
    .source = R"GLSL(
// umbrage_page_coordinate: a receiver in a page of an atlas: texels of the page with its gutter, the page's first texel
//   table, size   page table, RGBA8, nearest filter;   coord   receiver, from 1.0 to 2.0 across all but its border
//   page, gutter  side of a page and what it has around it, texels
UMBRAGE_HIGHP vec4 umbrage_page_coordinate(UMBRAGE_MAP table, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                           UMBRAGE_HIGHP float page, UMBRAGE_HIGHP float gutter) {
    UMBRAGE_HIGHP vec2 cell = min(max(vec2(0.0, 0.0), coord * (size - 2.0) - (size - 3.0)), size - 1.0);
    UMBRAGE_HIGHP ivec2 texel = ivec2(cell);  // of a NaN the first
    UMBRAGE_HIGHP vec4 entry = umbrage_texel(table, size, vec2(texel));
    UMBRAGE_HIGHP vec2 slot = umbrage_from_unorm(vec2(entry.x, entry.y));
    UMBRAGE_HIGHP float across = floor(entry.z * 255.0 + entry.w * 65280.0 + 0.5);  // one of the two is 0.0
    UMBRAGE_HIGHP vec2 at = fract(coord * across) * page + (across > 0.0 ? gutter : 32768.0);
    return vec4(at, slot * (page + gutter * 2.0));
}
)GLSL",
};

inline constexpr auto page_table_snippets = list<&page_coordinate>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/light/cascades/blend.hpp
// From one cascade to the next without a line: both looked up and mixed, or one of them, chosen from pixel to pixel.
//
//     float weight = umbrage::cascade_fade(view_depth, scale.w, offset.w);        // of the next cascade
//     visibility = umbrage::blend_cascades(visibility, visibility_of_next, weight);
//     number = umbrage::dithered_cascade(number, weight, umbrage::dither_threshold(pixel));  // or this, looked up once
//
// Weights are multiples of 1/256, so that mixing visibilities of pcf_2x2, multiples of 2^-16, rounds nothing.

namespace umbrage {

/// A weight in steps of 1/256.
/// @param v       any; from 1 up 1, from 0 down and NaN 0
/// @exactness     A
template <real T>
[[nodiscard]] constexpr T cascade_weight(T v) {
    if (is_nan(v) || !(v > T(0))) return T(0);
    return v < T(1) ? T(static_cast<int>(v * T(256))) * T(1.0 / 256.0) : T(1);
}

/// Weight of the next cascade, growing towards the end of one.
/// @param depth           along the camera's axis
/// @param scale, offset   of the weight, the w of a cascade's own
/// @return                0 .. 1 in steps of 1/256; NaN gives 0
/// @formula               depth scale + offset
/// @exactness             B: a product and a sum
template <real T>
[[nodiscard]] constexpr T cascade_fade(T depth, T scale, T offset) {
    return cascade_weight(depth * scale + offset);
}

/// Weight of the next cascade, growing towards the border of one's map: for selection by projection.
/// @param coordinate   in texels;   size  of the map, in texels
/// @param reach        of the filter, in texels: where the weight is 1
/// @param per_texel    weight a texel: 1 / width of the band along the border
/// @return             0 .. 1 in steps of 1/256; NaN gives 0
/// @formula            1 - (distance from the border - reach) per_texel, where the border is nearest
/// @exactness          B
template <real T>
[[nodiscard]] T cascade_border_fade(glm::vec<2, T> coordinate, glm::vec<2, T> size, T reach, T per_texel) {
    const glm::vec<2, T> half = size * T(0.5);
    const auto weight = [&](T c, T h) {
        const T beyond = glm::abs(c - h) - (h - reach);
        return cascade_weight(beyond * per_texel + T(1));
    };
    return glm::max(weight(coordinate.x, half.x), weight(coordinate.y, half.y));
}

/// Two cascades' visibilities, mixed.
/// @param weight    of the farther cascade's, 0 .. 1
/// @formula         nearer + (farther - nearer) weight, from weight 1 on farther alone
/// @exactness       B; nothing rounds where visibilities are multiples of 2^-16 and weights of 1/256
template <real T>
[[nodiscard]] constexpr T blend_cascades(T nearer, T farther, T weight) {
    return weight < T(1) ? nearer + (farther - nearer) * weight : farther;
}

/// A pixel's threshold, each of 16 once in every 4 x 4 of them, spread as evenly as can be.
/// @param pixel     whole numbers or positions in pixels; of 2^15 and more, and NaN, all have the first
/// @return          1/32, 3/32 .. 31/32
/// @formula         (m + 1/2) / 16, m's bits from the highest: x0 xor y0, y0, x1 xor y1, y1, of x and y modulo 4
/// @exactness       A
/// @cite            Bayer: An optimum method for two-level rendition of continuous-tone pictures, ICC 1973
template <real T>
[[nodiscard]] T dither_threshold(glm::vec<2, T> pixel) {
    if (!inside_texel_space(pixel)) return T(1.0 / 32.0);
    const glm::vec<2, T> whole = glm::floor(pixel);
    const glm::vec<2, T> high = glm::floor(whole * T(0.5)), above = glm::floor(whole * T(0.25));
    const glm::vec<2, T> b0 = whole - high * T(2), b1 = high - above * T(2);
    const T m = glm::abs(b0.x - b0.y) * T(8) + b0.y * T(4) + glm::abs(b1.x - b1.y) * T(2) + b1.y;
    return (m + T(0.5)) * T(1.0 / 16.0);
}

/// The cascade that a pixel looks its shadow up in.
/// @param number      of the cascade;   weight  of the next one, in steps of 1/256
/// @param threshold   dither_threshold
/// @return            number, or the next one where weight is above threshold: after the last cascade one that is not
///                    there, where all is lit
/// @exactness         A
template <real T>
[[nodiscard]] constexpr T dithered_cascade(T number, T weight, T threshold) {
    return number + (weight > threshold ? T(1) : T(0));
}

namespace glsl {

inline constexpr snippet cascade_weight{
    .name = "cascade_weight",
    .summary = "a weight in steps of 1/256",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_cascade_weight: v taken down to steps of 1/256, from 0.0 to 1.0; NaN is 0.0
UMBRAGE_HIGHP float umbrage_cascade_weight(UMBRAGE_HIGHP float v) {
    UMBRAGE_HIGHP float steps = v > 0.0 && v < 1.0 ? floor(v * 256.0) : (v >= 1.0 ? 256.0 : 0.0);
    return steps * (1.0 / 256.0);
}
)GLSL",
};

inline constexpr snippet cascade_fade{
    .name = "cascade_fade",
    .summary = "weight of the next cascade, by view depth",
    .exactness = tier::b,
    .needs = list<&cascade_weight>,
    .source = R"GLSL(
// umbrage_cascade_fade: weight of the next cascade at a distance along the camera's axis; depth * scale + offset
UMBRAGE_HIGHP float umbrage_cascade_fade(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float scale,
                                         UMBRAGE_HIGHP float offset) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float v = depth * scale + offset;
    return umbrage_cascade_weight(v);
}
)GLSL",
};

inline constexpr snippet cascade_border_fade{
    .name = "cascade_border_fade",
    .summary = "weight of the next cascade, by distance from the border",
    .exactness = tier::b,
    .needs = list<&cascade_weight>,
    .source = R"GLSL(
// umbrage_cascade_border_fade: weight of the next cascade, 1.0 from reach texels off the border of a map on
//   coordinate, size  in texels;   per_texel  weight a texel, 1.0 / width of the band along the border
UMBRAGE_HIGHP float umbrage_cascade_border_fade(UMBRAGE_HIGHP vec2 coordinate, UMBRAGE_HIGHP vec2 size,
                                                UMBRAGE_HIGHP float reach, UMBRAGE_HIGHP float per_texel) {
    UMBRAGE_HIGHP vec2 half_size = size * 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 beyond = abs(coordinate - half_size) - (half_size - reach);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 v = beyond * per_texel + 1.0;
    UMBRAGE_HIGHP float x = umbrage_cascade_weight(v.x);
    UMBRAGE_HIGHP float y = umbrage_cascade_weight(v.y);
    return x > y ? x : y;
}
)GLSL",
};

inline constexpr snippet blend_cascades{
    .name = "blend_cascades",
    .summary = "two cascades' visibilities, mixed",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_blend_cascades: visibilities of a cascade and of the next one, which counts by weight, mixed
UMBRAGE_HIGHP float umbrage_blend_cascades(UMBRAGE_HIGHP float nearer, UMBRAGE_HIGHP float farther,
                                           UMBRAGE_HIGHP float weight) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float sum = nearer + (farther - nearer) * weight;
    return weight < 1.0 ? sum : farther;
}
)GLSL",
};

inline constexpr snippet dither_threshold{
    .name = "dither_threshold",
    .summary = "one of 16 thresholds for a pixel",
    .exactness = tier::a,
    .needs = list<&inside_texel_space>,
    .source = R"GLSL(
// umbrage_dither_threshold: one of 16 thresholds, 1/32 to 31/32, for a position in pixels; each once in 4 x 4 pixels
UMBRAGE_HIGHP float umbrage_dither_threshold(UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_HIGHP vec2 whole = umbrage_inside_texel_space(pixel) ? floor(pixel) : vec2(0.0, 0.0);
    UMBRAGE_HIGHP vec2 high = floor(whole * 0.5);
    UMBRAGE_HIGHP vec2 above = floor(whole * 0.25);
    UMBRAGE_HIGHP vec2 b0 = whole - high * 2.0;
    UMBRAGE_HIGHP vec2 b1 = high - above * 2.0;
    UMBRAGE_HIGHP float m = abs(b0.x - b0.y) * 8.0 + b0.y * 4.0 + abs(b1.x - b1.y) * 2.0 + b1.y;
    return (m + 0.5) * (1.0 / 16.0);
}
)GLSL",
};

inline constexpr snippet dithered_cascade{
    .name = "dithered_cascade",
    .summary = "a cascade, or by its weight the next one",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_dithered_cascade: number of a cascade, or of the next one where its weight is above the pixel's threshold
UMBRAGE_HIGHP float umbrage_dithered_cascade(UMBRAGE_HIGHP float number, UMBRAGE_HIGHP float weight,
                                             UMBRAGE_HIGHP float threshold) {
    return number + (weight > threshold ? 1.0 : 0.0);
}
)GLSL",
};

inline constexpr auto blend_snippets =
    list<&cascade_weight, &cascade_fade, &cascade_border_fade, &blend_cascades, &dither_threshold, &dithered_cascade>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/light/cascades/select.hpp
// Which of a directional light's cascades a receiver looks its shadow up in, and where in it: one rotation for all, a
// scale and an offset for each.
//
//     glm::vec3 light(umbrage::shadow_coordinate(u.rotation, world));
//     float number = umbrage::cascade_by_depth(view_depth, u.ends);
//     glm::vec3 at = umbrage::cascade_coordinate(light, umbrage::cascade_column(u.scales, number),
//                                                umbrage::cascade_column(u.offsets, number));
//     float visibility = umbrage::pcf_2x2(umbrage::clamped(maps[int(number)]), glm::vec2(at), at.z - bias);
//
// In shaders the number is an array's layer, or chooses a tile of an atlas. Where arrays of uniforms take an index that
// differs from pixel to pixel, they do for cascade_column. What costs a shader least there is a texture matrix for each
// cascade in place of rotation, scale and offset, rounded from double so that stable cascades stay where they are, and
// stored by row: three are then loaded, not four columns.
//
//     layout(std140, row_major) uniform cascades { mat4 to_texels[4]; vec3 ends; };
//     vec3 at = umbrage_shadow_coordinate(to_texels[int(number)], world).xyz;

namespace umbrage {

/// The cascade that a distance from the camera falls into.
/// @param depth   along the camera's axis, or whatever else grows with it, as ends do: gl_FragCoord.z costs a shader
///                nothing; NaN gives 0
/// @param ends    of the first cascades but not of the last, ascending; infinity for one that is not there
/// @return        0 .. 3. Ends of more cascades: the sum over them, three at a time
/// @exactness     A: comparisons
template <real T>
[[nodiscard]] constexpr T cascade_by_depth(T depth, glm::vec<3, T> ends) {
    const auto reaches = [depth](T end) { return !is_nan(depth) && depth >= end; };
    return T(int(reaches(ends.x)) + int(reaches(ends.y)) + int(reaches(ends.z)));
}

/// One of four columns.
/// @param number   0 .. 3; above 3 the last
/// @exactness      A
template <real T>
[[nodiscard]] constexpr glm::vec<4, T> cascade_column(const glm::mat<4, 4, T>& columns, T number) {
    return number < T(1.5) ? (number < T(0.5) ? columns[0] : columns[1]) : (number < T(2.5) ? columns[2] : columns[3]);
}

/// A point in the map of one cascade.
/// @param light           the point, rotated into the light's directions
/// @param scale, offset   of the cascade, see cascade; their w is not used
/// @return                (x, y) in texels, depth: what filters take, without a division
/// @formula               light scale + offset
/// @exactness             B: a product and a sum each
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> cascade_coordinate(glm::vec<3, T> light, glm::vec<4, T> scale,
                                                          glm::vec<4, T> offset) {
    return {light.x * scale.x + offset.x, light.y * scale.y + offset.y, light.z * scale.z + offset.z};
}

/// True for a coordinate whose filter stays inside the map, between the near and the far plane.
/// @param size    of the map, in texels;   reach  of the filter, in texels
/// @exactness     B: differences, exact where size and reach are multiples of 1/16
template <real T>
[[nodiscard]] constexpr bool inside_cascade(glm::vec<3, T> coordinate, glm::vec<2, T> size, T reach) {
    const auto within = [](T low, T v, T high) { return !is_nan(v) && v >= low && v <= high; };
    return within(reach, coordinate.x, size.x - reach) && within(reach, coordinate.y, size.y - reach) &&
           within(T(0), coordinate.z, T(1));
}

/// The first cascade that holds a point and its filter, which is the finest, and where in it.
/// @param light            the point, rotated into the light's directions
/// @param scales, offsets  of four cascades, as cascade_coordinate takes them; see make_cascade_uniforms for fewer
/// @param size             of each map, in texels;   reach  of the filter, in texels
/// @return                 (x, y) in texels, depth, number; (65536, 65536, 0, 4), which every filter takes as lit,
///                         where none holds it: shaders read a texel all the same, so that the layer must be one that
///                         is there, min(number, 3)
/// @exactness              B
template <real T>
[[nodiscard]] constexpr glm::vec<4, T> cascade_by_projection(glm::vec<3, T> light, const glm::mat<4, 4, T>& scales,
                                                             const glm::mat<4, 4, T>& offsets, glm::vec<2, T> size,
                                                             T reach) {
    for (glm::length_t i = 0; i < 4; ++i) {
        const glm::vec<3, T> at = cascade_coordinate(light, scales[i], offsets[i]);
        if (inside_cascade(at, size, reach)) return {at.x, at.y, at.z, T(i)};
    }
    return {T(65536), T(65536), T(0), T(4)};
}

/// First texel of a cascade in an atlas of 2 x 2 tiles.
/// @param number   0 .. 3;   size  of a tile, in texels
/// @exactness      A
[[nodiscard]] inline glm::ivec2 cascade_tile(int number, int size) { return {number % 2 * size, number / 2 * size}; }

namespace glsl {

inline constexpr snippet cascade_by_depth{
    .name = "cascade_by_depth",
    .summary = "cascade that a view depth falls into",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_cascade_by_depth: the cascade that a distance along the camera's axis falls into, 0.0 to 3.0
//   ends  of the first three cascades, ascending
UMBRAGE_HIGHP float umbrage_cascade_by_depth(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP vec3 ends) {
    UMBRAGE_HIGHP int reached = int(depth >= ends.x) + int(depth >= ends.y) + int(depth >= ends.z);
    return float(reached);
}
)GLSL",
};

inline constexpr snippet cascade_column{
    .name = "cascade_column",
    .summary = "one of four columns, without an index",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_cascade_column: a column of a matrix by its number, 0.0 to 3.0, for languages without dynamic indices
UMBRAGE_HIGHP vec4 umbrage_cascade_column(UMBRAGE_HIGHP mat4 columns, UMBRAGE_HIGHP float number) {
    UMBRAGE_HIGHP vec4 low = number < 0.5 ? columns[0] : columns[1];
    UMBRAGE_HIGHP vec4 high = number < 2.5 ? columns[2] : columns[3];
    return number < 1.5 ? low : high;
}
)GLSL",
};

inline constexpr snippet cascade_coordinate{
    .name = "cascade_coordinate",
    .summary = "a point in the map of one cascade",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_cascade_coordinate: a point, rotated into the light's directions, in a cascade's map: texels and depth
UMBRAGE_HIGHP vec3 umbrage_cascade_coordinate(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP vec4 scale,
                                              UMBRAGE_HIGHP vec4 offset) {
    UMBRAGE_HIGHP vec3 start = vec3(offset.x, offset.y, offset.z);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 at = light * vec3(scale.x, scale.y, scale.z) + start;
    return at;
}
)GLSL",
};

inline constexpr snippet inside_cascade{
    .name = "inside_cascade",
    .summary = "coordinates whose filter stays inside a cascade",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_inside_cascade: whether a filter of some reach around a coordinate stays inside a map of size texels
bool umbrage_inside_cascade(UMBRAGE_HIGHP vec3 coordinate, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP float reach) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 end = size - reach;
    // y doubled on purpose: Mesa makes min(x, y) >= reach of two comparisons with one limit, which loses a NaN
    bool in_x = coordinate.x >= reach && coordinate.x <= end.x;
    bool in_y = coordinate.y * 2.0 >= reach * 2.0 && coordinate.y * 2.0 <= end.y * 2.0;
    return in_x && in_y && coordinate.z >= 0.0 && coordinate.z <= 1.0;
}
)GLSL",
};

inline constexpr snippet cascade_by_projection{
    .name = "cascade_by_projection",
    .summary = "first cascade that holds a point and its filter",
    .exactness = tier::b,
    .needs = list<&cascade_coordinate, &inside_cascade>,
    .source = R"GLSL(
// umbrage_cascade_by_projection: (texels, texels, depth, number) in the first of four cascades that holds a point and
//   its filter; where none does, number 4.0 and a coordinate that every filter takes as lit
//   light            the point, rotated into the light's directions
//   scales, offsets  of the cascades;   size  of each map;   reach  of the filter, in texels
UMBRAGE_HIGHP vec4 umbrage_cascade_by_projection(UMBRAGE_HIGHP vec3 light, UMBRAGE_HIGHP mat4 scales,
                                                 UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP vec2 size,
                                                 UMBRAGE_HIGHP float reach) {
    UMBRAGE_HIGHP vec3 a = umbrage_cascade_coordinate(light, scales[0], offsets[0]);
    UMBRAGE_HIGHP vec3 b = umbrage_cascade_coordinate(light, scales[1], offsets[1]);
    UMBRAGE_HIGHP vec3 c = umbrage_cascade_coordinate(light, scales[2], offsets[2]);
    UMBRAGE_HIGHP vec3 d = umbrage_cascade_coordinate(light, scales[3], offsets[3]);
    UMBRAGE_HIGHP vec4 found = vec4(65536.0, 65536.0, 0.0, 4.0);
    found = umbrage_inside_cascade(d, size, reach) ? vec4(d, 3.0) : found;
    found = umbrage_inside_cascade(c, size, reach) ? vec4(c, 2.0) : found;
    found = umbrage_inside_cascade(b, size, reach) ? vec4(b, 1.0) : found;
    return umbrage_inside_cascade(a, size, reach) ? vec4(a, 0.0) : found;
}
)GLSL",
};

inline constexpr snippet cascade_tile{
    .name = "cascade_tile",
    .summary = "first texel of a cascade in an atlas",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_cascade_tile: first texel of a cascade, 0.0 to 3.0, in an atlas of 2 x 2 tiles of size texels
UMBRAGE_HIGHP vec2 umbrage_cascade_tile(UMBRAGE_HIGHP float number, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP float row = number < 1.5 ? 0.0 : 1.0;
    return vec2((number - row * 2.0) * size, row * size);
}
)GLSL",
};

inline constexpr auto select_snippets = list<&cascade_by_depth, &cascade_column, &cascade_coordinate, &inside_cascade,
                                             &cascade_by_projection, &cascade_tile>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/light/cascades/splits.hpp
// Where a camera's range is cut into cascades.
//
//     auto splits = umbrage::practical_splits<4>(0.5f, 300.0f, 0.9f);  // five distances, from 0.5 to 300
//
// Any other ascending distances do as well: these of one's own, or these with another first one, so that what is right
// in front of the camera does not claim cascades.

namespace umbrage {

/// Between even splits and those by which distances grow by one factor.
///
/// @tparam Count           cascades
/// @param z_near, z_far    distances along the camera's axis, 0 < z_near < z_far
/// @param lambda           0 even, 1 by one factor
/// @return                 Count + 1 distances, strictly ascending; the first and the last are z_near and z_far
/// @throws std::invalid_argument  anything else, and a range too short to be cut
/// @formula                lambda n (f / n)^(i / Count) + (1 - lambda) (n + (f - n) i / Count)
/// @cite                   Zhang, Sun, Xu, Lun: Parallel-split shadow maps for large-scale virtual environments, 2006
template <std::size_t Count, real T>
[[nodiscard]] std::array<T, Count + 1> practical_splits(T z_near, T z_far, T lambda) {
    static_assert(Count > 0);
    constexpr auto function = "practical_splits";
    detail::require(is_finite(z_near) && z_near > T(0), function, "z_near", "must be finite and above 0");
    detail::require(is_finite(z_far) && z_far > z_near, function, "z_far", "must be finite and above z_near");
    detail::require(is_finite(lambda) && lambda >= T(0) && lambda <= T(1), function, "lambda",
                    "must lie between 0 and 1");
    const double n = static_cast<double>(z_near), f = static_cast<double>(z_far), log_n = std::log(n);
    const double share = static_cast<double>(lambda), log_range = std::log(f) - log_n;  // f / n may overflow
    std::array<T, Count + 1> splits;
    splits[0] = z_near;
    for (std::size_t i = 1; i < Count; ++i) {
        const double at = static_cast<double>(i) / static_cast<double>(Count);
        splits[i] = static_cast<T>(share * std::exp(log_n + log_range * at) + (1 - share) * (n + (f - n) * at));
    }
    splits[Count] = z_far;
    for (std::size_t i = 0; i < Count; ++i)
        detail::require(splits[i] < splits[i + 1], function, "z_near and z_far", "are too close together");
    return splits;
}

/// Even splits.
template <std::size_t Count, real T>
[[nodiscard]] std::array<T, Count + 1> uniform_splits(T z_near, T z_far) {
    return practical_splits<Count>(z_near, z_far, T(0));
}

/// Splits that grow by one factor, so that a texel covers as many pixels in every cascade.
template <std::size_t Count, real T>
[[nodiscard]] std::array<T, Count + 1> logarithmic_splits(T z_near, T z_far) {
    return practical_splits<Count>(z_near, z_far, T(1));
}

/// Splits as shares of the range, which some engines take.
/// @return   (split - n) / (f - n): 0 .. 1
template <real T, std::size_t Size>
[[nodiscard]] std::array<T, Size> split_shares(const std::array<T, Size>& splits) {
    std::array<T, Size> shares;
    for (std::size_t i = 0; i < Size; ++i) shares[i] = (splits[i] - splits.front()) / (splits.back() - splits.front());
    return shares;
}

}  // namespace umbrage

// ---- umbrage/light/cube_atlas.hpp
// A texture of a cube in the place of an atlas of its faces: which texel of which face an atlas' texel is, and the
// direction that reads it. What filters over an atlas are bound to cubes with, see texture::cube_faces of bind.hpp.
//
//     glm::vec3 direction = umbrage::cube_atlas_direction(texel, size);  // what a samplerCube takes
//

namespace umbrage {

/// The face that a texel of an atlas belongs to, and where on it.
/// @param texel   of 3 x 2 tiles as cube_tile has them, whole numbers;   size  of a tile, in texels, below 2^15
/// @return        (s, t, face), whole numbers
/// @exactness     A: whole numbers
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> cube_atlas_texel(glm::vec<2, T> texel, T size) {
    const T column = texel.x < size ? T(0) : (texel.x < size * T(2) ? T(1) : T(2)), row = T(texel.y < size ? 0 : 1);
    return {texel.x - column * size, texel.y - row * size, column + row * T(3)};
}

/// The direction from a cube's middle to the middle of that texel.
/// @param texel, size   as for cube_atlas_texel
/// @return              in half texels: its greatest component is size or -size
/// @exactness           A: whole numbers; fast mathematics may change a zero's sign
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> cube_atlas_direction(glm::vec<2, T> texel, T size) {
    const glm::vec<3, T> part = cube_atlas_texel(texel, size);
    return cube_point(part.z, glm::vec<3, T>(part.x * T(2) + T(1) - size, part.y * T(2) + T(1) - size, size));
}

namespace glsl {

inline constexpr snippet cube_atlas_texel{
    .name = "cube_atlas_texel",
    .summary = "face that a texel of an atlas belongs to, and where on it",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_cube_atlas_texel: (s, t, face) of a texel of an atlas of 3 x 2 tiles of size texels; whole numbers
UMBRAGE_HIGHP vec3 umbrage_cube_atlas_texel(UMBRAGE_HIGHP vec2 texel, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP float column = texel.x < size ? 0.0 : (texel.x < size * 2.0 ? 1.0 : 2.0);
    UMBRAGE_HIGHP float row = texel.y < size ? 0.0 : 1.0;
    return vec3(texel - vec2(column, row) * size, column + row * 3.0);
}
)GLSL",
};

inline constexpr snippet cube_atlas_direction{
    .name = "cube_atlas_direction",
    .summary = "direction that reads an atlas' texel from a texture of a cube",
    .exactness = tier::a,
    .needs = list<&cube_atlas_texel, &cube_point>,
    .source = R"GLSL(
// umbrage_cube_atlas_direction: from a cube's middle to that of a texel of an atlas of 3 x 2 tiles of size texels
UMBRAGE_HIGHP vec3 umbrage_cube_atlas_direction(UMBRAGE_HIGHP vec2 texel, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP vec3 part = umbrage_cube_atlas_texel(texel, size);
    UMBRAGE_HIGHP vec2 uv = vec2(part.x, part.y) * 2.0 + (1.0 - size);
    return umbrage_cube_point(part.z, vec3(uv, size));
}
)GLSL",
};

inline constexpr auto cube_atlas_snippets = list<&cube_atlas_texel, &cube_atlas_direction>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/light/directional_light.hpp
// A directional light's space as the classic course exercise sets it up.
//
//     auto light = umbrage::make_directional_light({.direction = d, .map_size = 1024});
//

namespace umbrage {

template <real T = float>
struct directional_light {
    glm::vec<3, T> direction{T(0), T(-1), T(0)};  ///< any length > 0
    glm::vec<3, T> target{T(0)};                  ///< what it looks at
    glm::vec<3, T> up{T(0), T(1), T(0)};          ///< hint; may be parallel to direction
    T offset = T(10);                             ///< from target back to the light, world units
    int map_size = 1024;                          ///< texels, >= 1
    T texels_per_unit = T(10);                    ///< across the light, world units; > 0
    T z_near = T(0.1);                            ///< world units from the light
    T z_far = T(100);
    clip_space clip{};
};

/// The exercise's set-up: position = target - unit direction * offset, width = height = map_size / texels_per_unit.
/// @throws std::invalid_argument  zero or non-finite direction, map_size or texels_per_unit not above 0, planes out of
///                                order, and what gives matrices that are not finite
template <real T = float>
[[nodiscard]] light_space<T> make_directional_light(const directional_light<T>& light) {
    constexpr auto function = "make_directional_light";
    detail::require(light.map_size >= 1, function, "map_size", "must be above 0");
    detail::require(is_finite(light.texels_per_unit) && light.texels_per_unit > T(0), function, "texels_per_unit",
                    "must be finite and above 0");
    detail::require(is_finite(light.offset), function, "offset", "must be finite");
    // along the normalised direction, moved by the offset: the view's last row holds the light's distance
    light_space<T> space{
        detail::look_along(light.target, light.direction, light.up, light.clip.hand, function, "target"),
        {},
        light.clip};
    space.view[3][2] += light.clip.hand == handedness::right ? -light.offset : light.offset;
    const glm::vec<2, T> half(T(light.map_size) / light.texels_per_unit / T(2));
    space.projection = detail::orthographic(-half, half, light.z_near, light.z_far, light.clip, function,
                                            "map_size and texels_per_unit", "z_near and z_far");
    return detail::checked(space, function, "target, offset, texels_per_unit, z_near and z_far");
}

}  // namespace umbrage

// ---- umbrage/light/dual_paraboloid.hpp
// Two square maps around a point light, a paraboloid's image of either half of all directions in each. Shadows go by
// distance, and straight edges become arcs: draw a mesh that tessellate has cut.
//
//     auto light = umbrage::make_dual_paraboloid_light<float>({.position = p, .range = 30, .border = 2});
//     auto cut = umbrage::tessellate(mesh, {p, umbrage::paraboloid_edge_angle(512, 2), 30});
//     for (int map : {0, 1}) umbrage::rasterize_dual_paraboloid(maps[map].view(), cut.view(), light, map);
//
//     glm::vec3 at = umbrage::dual_paraboloid_coordinate(world - p);  // (s, t, map)
//     glm::vec2 texel = glm::vec2(at) * float(512 - 2 * 2) + 2.0f;    // in maps[int(at.z)]
//     float depth = umbrage::distance_depth(world - p, 1.0f / 30.0f);
//
// A vertex shader's gl_Position is projection * umbrage_dual_paraboloid_position(world - p, map), of the mesh as it is
// cut. What is behind the map needs a clip distance: position.w - 0.1 * distance, say.
//
// A border of texels sees past the half: filters then need no other map, as in point_light.hpp.

namespace umbrage {

template <real T = float>
struct dual_paraboloid_light {
    glm::vec<3, T> position{T(0)};
    T range = T(100);    ///< > 0, world units: distances from the light that have a depth
    int map_size = 512;  ///< of either map, in texels, >= 16
    int border = 0;      ///< texels around the half's circle, within map_size, at most an eighth of it
    clip_space clip{};
};

/// Where in its map a direction is seen: the first holds +z, the other -z, each the way round that a right-handed view
/// along it with y up shows. Beyond its circle a map goes on in the other one, at 1 - s and the same t.
/// @param direction   of any length of 1e-18 to 1e18; zero and NaN give coordinates that are NaN, which every filter
///                    takes as lit
/// @return            (s, t, map): s and t from 0 to 1 over the map's square, within its circle; map 0 or 1
/// @formula           s = 1/2 + -x / 2 (|p| + |z|), for z < 0 with x, t = 1/2 + y / 2 (|p| + |z|): a texel is as wide
///                    as it is high, 2 (1 + |z| / |p|) / map_size radians, in the middle twice of what it is at the rim
/// @exactness         C: a square root and divisions, of each of which GLSL allows 2.5 ulp and more; 0 seen
/// @cite              Brabec, Annen, Seidel: Shadow Mapping for Hemispherical and Omnidirectional Light Sources, 2002
template <real T>
[[nodiscard]] glm::vec<3, T> dual_paraboloid_coordinate(glm::vec<3, T> direction) {
    const T square = direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    const bool behind = direction.z < T(0);
    const T m = std::sqrt(square) + (behind ? -direction.z : direction.z);
    return {((behind ? direction.x : -direction.x) + m) / (m + m), (direction.y + m) / (m + m), T(behind ? 1 : 0)};
}

/// A vertex of the depth pass, before the projection of make_dual_paraboloid_light.
/// @param direction   from the light to the vertex
/// @param map         0 or 1
/// @return            (x w, y w, distance w, w): x and y from -1 to 1 in the map's half, farther out beyond it; w is 0
///                    in the middle of the other half, and never below
/// @formula           w = |p| + z, of map 1 |p| - z
/// @exactness         C: a square root; 0 seen
template <real T>
[[nodiscard]] glm::vec<4, T> dual_paraboloid_position(glm::vec<3, T> direction, T map) {
    const bool behind = map > T(0.5);
    const T length = std::sqrt(direction.x * direction.x + direction.y * direction.y + direction.z * direction.z);
    const T w = length + (behind ? -direction.z : direction.z);
    return {behind ? direction.x : -direction.x, direction.y, length * w, w};
}

/// What both maps' depth passes share: a translation to the light, and the projection for dual_paraboloid_position,
/// with the first texel at (0, 0) of dual_paraboloid_coordinate in every convention and depths that are distance_depth,
/// or 1 less it. Where clip is left-handed or has its first row on top, one of them, the projection is a mirror.
/// @throws std::invalid_argument  too few texels, too wide a border, and what gives matrices that are not finite
template <real T = float>
[[nodiscard]] light_space<T> make_dual_paraboloid_light(const dual_paraboloid_light<T>& light) {
    constexpr auto function = "make_dual_paraboloid_light";
    detail::require(light.map_size >= 16, function, "map_size", "must be at least 16");
    detail::require(light.border >= 0 && light.border <= light.map_size / 8, function, "border",
                    "must be at least 0 and at most an eighth of map_size");
    detail::require(detail::all_finite(light.position), function, "position", "must be finite");
    const bool in_range = light.range > T(0) && detail::is_normal(light.range) && detail::is_normal(T(1) / light.range);
    detail::require(in_range, function, "range", "must be above 0, and it and 1 / range finite");
    const auto [at_light, at_range] = detail::ends<T>(light.clip);
    light_space<T> space{.clip = light.clip};
    space.view[3] = glm::vec<4, T>(-light.position, T(1));
    space.projection = glm::mat<4, 4, T>(T(0));
    space.projection[0][0] = T(light.map_size - 2 * light.border) / T(light.map_size);
    space.projection[1][1] =
        light.clip.origin == texture_origin::bottom ? space.projection[0][0] : -space.projection[0][0];
    space.projection[2][2] = (at_range - at_light) / light.range;
    space.projection[3][2] = at_light;
    space.projection[3][3] = T(1);
    return detail::checked<T>(space, function, "position and range");
}

/// The angle from end to end, seen from the light, up to which a straight edge is drawn within half a texel of where it
/// is seen, within the circle and the border.
/// @param map_size, border   of the light
/// @return                   radians
/// @formula                  2 sqrt(2 / n) 2 / (1 + r^2), n = map_size - 2 border, r = map_size / n: over the chord of
///                           an angle a arcs are up to n / 16 (a (1 + r^2) / 2)^2 texels high, r circles out
template <real T = float>
[[nodiscard]] T paraboloid_edge_angle(int map_size, int border = 0) {
    const T inner = T(map_size - 2 * border), rim = T(map_size) / inner;
    return T(2) * std::sqrt(T(2) / inner) * (T(2) / (T(1) + rim * rim));
}

namespace glsl {

inline constexpr snippet dual_paraboloid_coordinate{
    .name = "dual_paraboloid_coordinate",
    .summary = "paraboloid map, and where in it, that sees a direction",
    .exactness = tier::c,
    .ulp = 1,
    .source = R"GLSL(
// umbrage_dual_paraboloid_coordinate: (s, t, map) of a direction: 0.0 to 1.0 over the map's square, map 0.0 or 1.0
UMBRAGE_HIGHP vec3 umbrage_dual_paraboloid_coordinate(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square =
        direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    bool behind = direction.z < 0.0;
    UMBRAGE_HIGHP float m = sqrt(square) + (behind ? -direction.z : direction.z);
    UMBRAGE_HIGHP float x = behind ? direction.x : -direction.x;
    return vec3((x + m) / (m + m), (direction.y + m) / (m + m), behind ? 1.0 : 0.0);
}
)GLSL",
};

inline constexpr snippet dual_paraboloid_position{
    .name = "dual_paraboloid_position",
    .summary = "a vertex of a paraboloid map's depth pass",
    .exactness = tier::c,
    .ulp = 1,
    .source = R"GLSL(
// umbrage_dual_paraboloid_position: (x w, y w, distance w, w) of a vertex, for the depth pass' projection
//   direction  from the light to the vertex;   map  0.0 or 1.0
UMBRAGE_HIGHP vec4 umbrage_dual_paraboloid_position(UMBRAGE_HIGHP vec3 direction, UMBRAGE_HIGHP float map) {
    bool behind = map > 0.5;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float square =
        direction.x * direction.x + direction.y * direction.y + direction.z * direction.z;
    UMBRAGE_HIGHP float distance_to = sqrt(square);
    UMBRAGE_HIGHP float w = distance_to + (behind ? -direction.z : direction.z);
    return vec4(behind ? direction.x : -direction.x, direction.y, distance_to * w, w);
}
)GLSL",
};

inline constexpr auto dual_paraboloid_snippets = list<&dual_paraboloid_coordinate, &dual_paraboloid_position>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/light/pancake.hpp
// Casters before the near plane, pressed onto it by the vertex shader where the rasterizer cannot clamp depth.
//
//     gl_Position = umbrage_pancaked(clip_from_world * position, 0.0);  // umbrage::near_depth(clip)
//

namespace umbrage {

/// z/w of the near plane: 0 or -1, and 1 where depth is reversed.
[[nodiscard]] constexpr float near_depth(clip_space clip) {
    if (clip.direction == depth_direction::reversed) return 1.0f;
    return clip.range == depth_range::zero_to_one ? 0.0f : -1.0f;
}

/// A vertex before the near plane, moved onto it along z: for directional lights, where w is 1. Right for triangles
/// wholly before the plane or behind it. One that crosses it is bent, and its part behind comes out too far: prefer a
/// rasterizer that clamps.
/// @param position   in clip space
/// @param at_near    z/w of the near plane, near_depth: 0, -1 or 1, where 1 says that depth is reversed
/// @return           z = max(z, at_near w), or min for reversed depth; a NaN in z stays
/// @exactness        B: selects; where denormals compare as zeros, those before the plane stay
template <real T>
[[nodiscard]] constexpr glm::vec<4, T> pancaked(glm::vec<4, T> position, T at_near) {
    const T plane = at_near * position.w;
    const bool before = at_near > T(0.5) ? position.z > plane : position.z < plane;
    return {position.x, position.y, before ? plane : position.z, position.w};
}

namespace glsl {

inline constexpr snippet pancaked{
    .name = "pancaked",
    .summary = "casters before the near plane, onto it",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_pancaked: a clip space position, moved onto the near plane where it lies before it
//   at_near  z/w of the near plane: 0.0 or -1.0, or 1.0 for reversed depth
UMBRAGE_HIGHP vec4 umbrage_pancaked(UMBRAGE_HIGHP vec4 position, UMBRAGE_HIGHP float at_near) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float plane = at_near * position.w;
    bool before = at_near > 0.5 ? position.z > plane : position.z < plane;
    return vec4(position.x, position.y, before ? plane : position.z, position.w);
}
)GLSL",
};

inline constexpr auto pancake_snippets = list<&pancaked>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/light/point_light.hpp
// A point light's six spaces, for a cube texture's faces or an atlas's tiles.
//
//     auto faces = umbrage::make_point_light<float>({.position = p, .map_size = 512, .border = 2});
//     glm::vec3 at = umbrage::cube_coordinate(world - p);
//     glm::vec2 texel = glm::vec2(at) * float(512 - 2 * 2) + 2.0f;  // in the map of faces[int(at.z)]
//
// A border of texels sees past the face's edges: filters then need no other face, and where a shadow passes from one
// face to the next its edge moves by a texel at most. As many as std::ceil(filter.reach() + 1) will do. Depths are per
// face, those of a perspective projection at cube_view_z; distances, distance_depth, a depth pass must write.

namespace umbrage {

template <real T = float>
struct point_light {
    glm::vec<3, T> position{T(0)};
    T z_near = T(0.1);   ///< > 0, world units along each face's axis
    T z_far = T(100);    ///< > z_near; infinite: no far plane
    int map_size = 512;  ///< of a face, in texels, > 2 border
    int border = 0;      ///< texels beyond each edge of the face, within map_size
    clip_space clip{};
};

/// Views along cube_faces and perspective projections of 90 degrees and the border, whose first texel is (0, 0) of
/// cube_coordinate in every convention. Where clip is left-handed or has its first row on top, one of them, the
/// projection is a mirror: front faces go the other way round.
/// @throws std::invalid_argument  no texels within the border, planes out of order, and what gives matrices that are
///                                not finite
template <real T = float>
[[nodiscard]] std::array<light_space<T>, 6> make_point_light(const point_light<T>& light) {
    constexpr auto function = "make_point_light";
    detail::require(light.border >= 0, function, "border", "must not be below 0");
    detail::require(light.map_size / 2 >= light.border && light.map_size > 2 * light.border, function, "map_size",
                    "must be above twice the border");
    const T extent = T(light.map_size) / T(light.map_size - 2 * light.border);
    glm::mat<4, 4, T> projection = detail::perspective(extent, extent, light.z_near, light.z_far, light.clip, function);
    if (light.clip.hand == handedness::left) projection[0][0] = -projection[0][0];
    if (light.clip.origin == texture_origin::top) projection[1][1] = -projection[1][1];
    std::array<light_space<T>, 6> faces;
    for (std::size_t i = 0; i < 6; ++i) {
        const auto view = detail::look_along(light.position, glm::vec<3, T>(cube_faces[i].forward),
                                             glm::vec<3, T>(cube_faces[i].up), light.clip.hand, function, "position");
        faces[i] = detail::checked<T>({view, projection, light.clip}, function, "position, z_near and z_far");
    }
    return faces;
}

}  // namespace umbrage

// ---- umbrage/light/spot_light.hpp
// A spot light's space.
//
//     auto light = umbrage::make_spot_light({.position = p, .direction = d, .outer_angle_radians = 0.6f});
//

namespace umbrage {

template <real T = float>
struct spot_light {
    glm::vec<3, T> position{T(0)};
    glm::vec<3, T> direction{T(0), T(-1), T(0)};        ///< any length > 0
    glm::vec<3, T> up{T(0), T(1), T(0)};                ///< hint; may be parallel to direction
    T outer_angle_radians = std::numbers::pi_v<T> / 6;  ///< between axis and edge of the cone, above 0, below pi / 2
    T z_near = T(0.1);                                  ///< > 0, world units
    T z_far = T(100);                                   ///< > z_near; infinite: no far plane
    clip_space clip{};
};

/// View and perspective projection around the light's cone, which the square map holds whole.
/// @throws std::invalid_argument  zero or non-finite direction, angle outside (0, pi / 2), planes out of order, and
///                                what gives matrices that are not finite
template <real T = float>
[[nodiscard]] light_space<T> make_spot_light(const spot_light<T>& light) {
    constexpr auto function = "make_spot_light";
    const T angle = light.outer_angle_radians;
    detail::require(is_finite(angle) && angle > T(0) && angle < std::numbers::pi_v<T> / 2, function,
                    "outer_angle_radians", "must lie between 0 and pi / 2");
    const T extent = std::tan(angle);
    detail::require(detail::is_normal(T(1) / extent), function, "outer_angle_radians", "must have a finite cotangent");
    return detail::checked<T>(
        {detail::look_along(light.position, light.direction, light.up, light.clip.hand, function, "position"),
         detail::perspective(extent, extent, light.z_near, light.z_far, light.clip, function), light.clip},
        function, "position, outer_angle_radians, z_near and z_far");
}

}  // namespace umbrage

// ---- umbrage/light/tetrahedron.hpp
// Four triangular maps around a point light, the sides of a square that its diagonals cut: which of them a direction
// meets, and where. Straight edges stay straight.
//
//     glm::vec3 at = umbrage::tetrahedron_coordinate(world - light);  // (s, t, face)
//     glm::vec2 texel = umbrage::tetrahedron_texel(at, 1024.0f, 2.0f);
//     float depth = umbrage::depth_from_view_z(umbrage::tetrahedron_view_z(world - light), z_near, z_far);
//

namespace umbrage {

/// Which way a face looks: (0, -h, k), (0, -h, -k), (k, h, 0), (-k, h, 0), h = sqrt(1/3), k = sqrt(2/3). Its corners
/// are where the other three look away from.
/// @param face   0 .. 3
template <real T>
[[nodiscard]] glm::vec<3, T> tetrahedron_normal(int face) {
    const T h = std::sqrt(T(1) / T(3)), k = std::sqrt(T(2) / T(3)), side = face % 2 == 0 ? k : -k;
    return face < 2 ? glm::vec<3, T>(T(0), -h, side) : glm::vec<3, T>(side, h, T(0));
}

/// The face that a direction meets: the one that looks that way most.
/// @param direction   of any length
/// @return            0 .. 3; some for NaN
/// @formula           of the first two where |z| - |x| >= sqrt(2) y, of either two by the sign of z or x
/// @exactness         B
/// @cite              Liao: Shadow Mapping for Omnidirectional Light Using Tetrahedron Mapping, GPU Pro, 2010
template <real T>
[[nodiscard]] constexpr int tetrahedron_face(glm::vec<3, T> direction) {
    const T x = direction.x < T(0) ? -direction.x : direction.x, z = direction.z < T(0) ? -direction.z : direction.z;
    const T beside = z - x, up = direction.y * T(1.41421356237309504880);
    const bool below = !is_nan(beside) && !is_nan(up) && beside >= up;
    return below ? (direction.z < T(0) ? 1 : 0) : (direction.x < T(0) ? 3 : 2);
}

/// A direction in its face's own axes.
/// @return        (aside, up, away): along the face's base, to the right for who looks along the face with its apex
///                above; up in the world, of faces 2 and 3 down; away from the other face of the same two, >= 0
/// @exactness     B: tetrahedron_face, then selects
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> tetrahedron_plane(glm::vec<3, T> direction) {
    const int face = tetrahedron_face(direction);
    const glm::vec<3, T> d = direction;
    if (face < 2) return face == 0 ? glm::vec<3, T>(-d.x, d.y, d.z) : glm::vec<3, T>(d.x, d.y, -d.z);
    return face == 2 ? glm::vec<3, T>(-d.z, -d.y, d.x) : glm::vec<3, T>(d.z, -d.y, -d.x);
}

/// Distance to a direction's end along the normal of the face that it meets: what per-face depths are made of.
/// @formula       sqrt(2/3) away - sqrt(1/3) up
/// @exactness     B
template <real T>
[[nodiscard]] constexpr T tetrahedron_view_z(glm::vec<3, T> direction) {
    const glm::vec<3, T> p = tetrahedron_plane(direction);
    return p.z * T(0.81649658092772603273) + p.y * T(-0.57735026918962576451);
}

/// Where on its face a direction meets the tetrahedron.
/// @param direction   of any length; zero and NaN give coordinates that are NaN, which every filter takes as lit
/// @return            (s, t, face): t from 0 at the base to 1 at the apex, |s| <= 1 - t
/// @formula           s = aside / d, t = away / d, d = 2 away - sqrt(2) up
/// @exactness         C: divisions, of each of which GLSL allows 2.5 ulp; 0 seen
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> tetrahedron_coordinate(glm::vec<3, T> direction) {
    const glm::vec<3, T> p = tetrahedron_plane(direction);
    const T d = p.z * T(2) + p.y * T(-1.41421356237309504880);
    return {p.x / d, p.z / d, T(tetrahedron_face(direction))};
}

/// Where in a square map that is.
/// @param at       tetrahedron_coordinate;   size  of the map, in texels;   border  as make_tetrahedron_light's
/// @return         texels; face 0's base is the first row, 1's the last, 2's the last column, 3's the first
/// @formula        of face 0 (h + (h - 3 b) s, b + (h - 3 b) t), h = size / 2: b texels aside in x and in y are 3 b on
///                 a base from its corners and 2 b at the apex; the other faces' turned by quarters
/// @exactness      B
template <real T>
[[nodiscard]] constexpr glm::vec<2, T> tetrahedron_texel(glm::vec<3, T> at, T size, T border) {
    const T half = size * T(0.5), scale = half - border * T(3);
    const T x = at.x * scale, y = at.y * scale + (border - half);
    if (at.z < T(1.5)) return at.z < T(0.5) ? glm::vec<2, T>(half + x, half + y) : glm::vec<2, T>(half - x, half - y);
    return at.z < T(2.5) ? glm::vec<2, T>(half - y, half + x) : glm::vec<2, T>(half + y, half - x);
}

/// The face whose triangle a texel lies in: what a depth pass of another face must leave alone.
/// @param texel   whole numbers;   size  of the map, in texels, below 2^22
/// @return        0 .. 3; texels on a diagonal are faces 0's and 1's
/// @exactness     A: whole numbers
template <real T>
[[nodiscard]] constexpr int tetrahedron_face_of(glm::vec<2, T> texel, T size) {
    const T u = texel.x * T(2) + T(1) - size, v = texel.y * T(2) + T(1) - size;
    const bool in_column = (v < T(0) ? -v : v) >= (u < T(0) ? -u : u);
    return in_column ? (v < T(0) ? 0 : 1) : (u < T(0) ? 3 : 2);
}

namespace glsl {

inline constexpr snippet tetrahedron_face{
    .name = "tetrahedron_face",
    .summary = "face of a tetrahedron that a direction meets",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_tetrahedron_face: the face that a direction meets, 0.0 to 3.0: down and +z, down and -z, up and +x, up and -x
UMBRAGE_HIGHP float umbrage_tetrahedron_face(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float beside = abs(direction.z) - abs(direction.x);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float up = direction.y * 1.414213562;
    UMBRAGE_HIGHP float z = direction.z < 0.0 ? 1.0 : 0.0;
    UMBRAGE_HIGHP float x = direction.x < 0.0 ? 3.0 : 2.0;
    return beside >= up ? z : x;
}
)GLSL",
};

inline constexpr snippet tetrahedron_plane{
    .name = "tetrahedron_plane",
    .summary = "a direction in its tetrahedron face's axes",
    .exactness = tier::b,
    .needs = list<&tetrahedron_face>,
    .source = R"GLSL(
// umbrage_tetrahedron_plane: (along the base, up, away) of a direction in the axes of the face that it meets
UMBRAGE_HIGHP vec3 umbrage_tetrahedron_plane(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP float face = umbrage_tetrahedron_face(direction);
    UMBRAGE_HIGHP vec3 d = direction;
    UMBRAGE_HIGHP vec3 z = face < 0.5 ? vec3(-d.x, d.y, d.z) : vec3(d.x, d.y, -d.z);
    UMBRAGE_HIGHP vec3 x = face < 2.5 ? vec3(-d.z, -d.y, d.x) : vec3(d.z, -d.y, -d.x);
    return face < 1.5 ? z : x;
}
)GLSL",
};

inline constexpr snippet tetrahedron_view_z{
    .name = "tetrahedron_view_z",
    .summary = "distance along the normal of the tetrahedron's face that a direction meets",
    .exactness = tier::b,
    .needs = list<&tetrahedron_plane>,
    .source = R"GLSL(
// umbrage_tetrahedron_view_z: distance along the face's normal, of which per-face depths are made
UMBRAGE_HIGHP float umbrage_tetrahedron_view_z(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP vec3 p = umbrage_tetrahedron_plane(direction);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = p.z * 0.816496581 + p.y * -0.577350269;
    return z;
}
)GLSL",
};

inline constexpr snippet tetrahedron_coordinate{
    .name = "tetrahedron_coordinate",
    .summary = "face of a tetrahedron, and where on it, that a direction meets",
    .exactness = tier::c,
    .ulp = 1,
    .needs = list<&tetrahedron_face, &tetrahedron_plane>,
    .source = R"GLSL(
// umbrage_tetrahedron_coordinate: (s, t, face) of a direction: -1.0 to 1.0 along the base, 0.0 at it to 1.0 at the apex
UMBRAGE_HIGHP vec3 umbrage_tetrahedron_coordinate(UMBRAGE_HIGHP vec3 direction) {
    UMBRAGE_HIGHP vec3 p = umbrage_tetrahedron_plane(direction);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d = p.z * 2.0 + p.y * -1.414213562;
    return vec3(p.x / d, p.z / d, umbrage_tetrahedron_face(direction));
}
)GLSL",
};

inline constexpr snippet tetrahedron_texel{
    .name = "tetrahedron_texel",
    .summary = "a point of a tetrahedron's face in the map",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_tetrahedron_texel: texels of a square map, from (s, t, face) on a tetrahedron
//   size  of the map, in texels;   border  along the sides of each triangle, in texels
UMBRAGE_HIGHP vec2 umbrage_tetrahedron_texel(UMBRAGE_HIGHP vec3 at, UMBRAGE_HIGHP float size,
                                             UMBRAGE_HIGHP float border) {
    UMBRAGE_HIGHP float half_size = size * 0.5;
    UMBRAGE_HIGHP float scale = half_size - border * 3.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = at.x * scale;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = at.y * scale + (border - half_size);
    UMBRAGE_HIGHP vec2 off = at.z < 1.5 ? vec2(x, y) : vec2(-y, x);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 texel = half_size + (at.z < 0.5 || (at.z > 1.5 && at.z < 2.5) ? off : -off);
    return texel;
}
)GLSL",
};

inline constexpr snippet tetrahedron_face_of{
    .name = "tetrahedron_face_of",
    .summary = "face of a tetrahedron that a texel belongs to",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_tetrahedron_face_of: the face, 0.0 to 3.0, whose triangle in a map of size texels a texel lies in
UMBRAGE_HIGHP float umbrage_tetrahedron_face_of(UMBRAGE_HIGHP vec2 texel, UMBRAGE_HIGHP float size) {
    UMBRAGE_HIGHP vec2 off = texel * 2.0 + (1.0 - size);
    UMBRAGE_HIGHP float column = off.y < 0.0 ? 0.0 : 1.0;
    UMBRAGE_HIGHP float row = off.x < 0.0 ? 3.0 : 2.0;
    return abs(off.y) >= abs(off.x) ? column : row;
}
)GLSL",
};

inline constexpr auto tetrahedron_snippets = list<&tetrahedron_face, &tetrahedron_plane, &tetrahedron_view_z,
                                                  &tetrahedron_coordinate, &tetrahedron_texel, &tetrahedron_face_of>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/light/tetrahedron_light.hpp
// A point light's four spaces, a tetrahedron's faces, for triangles of one map.
//
//     auto faces = umbrage::make_tetrahedron_light<float>({.position = p, .map_size = 1024, .border = 2});
//     umbrage::rasterize_tetrahedron(map.view(), mesh, faces);  // images/tetrahedron_pass.hpp
//     glm::vec2 texel = umbrage::tetrahedron_texel(umbrage::tetrahedron_coordinate(world - p), 1024.0f, 2.0f);
//
// Triangles share rectangles, so that a face's depth pass must leave the others' texels alone. A fragment shader does
//
//     if (umbrage_tetrahedron_face_of(floor(gl_FragCoord.xy), 1024.0) != face) discard;
//
// or a vertex shader clips: face 0's distances are -y - x and -y + x of gl_Position, where the first row is at NDC
// y = -1; the others' are the same, turned by quarters. A border of texels along a triangle's sides sees past the face:
// filters then need no other one, as in point_light.hpp.

namespace umbrage {

template <real T = float>
struct tetrahedron_light {
    glm::vec<3, T> position{T(0)};
    T z_near = T(0.1);    ///< > 0, world units along each face's normal: at its corners three times as far away
    T z_far = T(100);     ///< > z_near; infinite: no far plane
    int map_size = 1024;  ///< of the square, in texels, > 6 border
    int border = 0;       ///< texels along each side of a triangle, within it
    clip_space clip{};
};

/// A face's corners, in the order of the three other faces, which look away from them.
template <real T>
using tetrahedron_tile = std::array<glm::vec<2, T>, 3>;

/// The triangles that tetrahedron_texel has without a border: a square's four sides and its middle.
template <real T = float>
[[nodiscard]] std::array<tetrahedron_tile<T>, 4> tetrahedron_tiles(T size) {
    const glm::vec<2, T> low(0), high(size), middle(size / T(2)), right(size, T(0)), left(T(0), size);
    return {{{middle, right, low}, {middle, high, left}, {high, right, middle}, {left, low, middle}}};
}

/// A triangle without a border of texels, in x and in y, along each of its sides.
/// @return        turned inside out where nothing is left of it
template <real T>
[[nodiscard]] tetrahedron_tile<T> without_border(const tetrahedron_tile<T>& t, T border) {
    const auto cross = [](glm::vec<2, T> a, glm::vec<2, T> b) { return a.x * b.y - a.y * b.x; };
    const T turn = cross(t[1] - t[0], t[2] - t[0]) < T(0) ? T(-1) : T(1);
    std::array<glm::vec<3, T>, 3> sides;  // points p on them have (p, 1) . side = 0
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec<2, T> along = (t[(i + 1) % 3] - t[i]) * turn, normal(-along.y, along.x);
        sides[i] = {normal, -glm::dot(normal, t[i]) - border * (glm::abs(normal.x) + glm::abs(normal.y))};
    }
    tetrahedron_tile<T> inner;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::vec<3, T> corner = glm::cross(sides[(i + 2) % 3], sides[i]);
        inner[i] = glm::vec<2, T>(corner) / corner.z;
    }
    return inner;
}

/// A view along each face's normal, and a projection of the face onto its triangle less the border, the first texel at
/// (0, 0) in every convention. Where clip is left-handed or has its first row on top, one of them, it is a mirror.
/// @param tiles   in texels; any four triangles: look-ups are then texture_matrix of faces[tetrahedron_face(...)]
/// @throws std::invalid_argument  no texels within the border, planes out of order, and what gives matrices that are
///                                not finite
/// @formula       a direction p is at sum of b_j T_j / sum of b_j, b_j = 3/4 (n_i - n_j) . p
template <real T = float>
[[nodiscard]] std::array<light_space<T>, 4> make_tetrahedron_light(const tetrahedron_light<T>& light,
                                                                   const std::array<tetrahedron_tile<T>, 4>& tiles) {
    constexpr auto function = "make_tetrahedron_light";
    detail::require(light.map_size >= 1, function, "map_size", "must be above 0");
    detail::require(light.border >= 0, function, "border", "must not be below 0");
    const glm::mat<4, 4, T> depths = detail::perspective(T(1), T(1), light.z_near, light.z_far, light.clip, function);
    std::array<light_space<T>, 4> faces;
    for (int i = 0; i < 4; ++i) {
        const tetrahedron_tile<T>& whole = tiles[static_cast<std::size_t>(i)];
        const tetrahedron_tile<T> tile = without_border(whole, T(light.border));
        detail::require(glm::dot(tile[1] - tile[0], whole[1] - whole[0]) > T(0), function, "border",
                        "must leave something of each triangle");
        const glm::vec<3, T> normal = tetrahedron_normal<T>(i);
        glm::mat<2, 3, T> rows(T(0));  // of x w and y w, w = normal . p
        for (int j = 0, corner = 0; j < 4; ++j) {
            if (j == i) continue;
            glm::vec<2, T> ndc = tile[static_cast<std::size_t>(corner++)] * (T(2) / T(light.map_size)) - T(1);
            if (light.clip.origin == texture_origin::top) ndc.y = -ndc.y;
            for (glm::length_t k = 0; k < 2; ++k) rows[k] += (normal - tetrahedron_normal<T>(j)) * (ndc[k] / T(4));
        }
        const auto view = detail::look_along(light.position, normal, -tetrahedron_normal<T>(i ^ 1), light.clip.hand,
                                             function, "position");
        glm::mat<4, 4, T> projection = depths;
        for (glm::length_t k = 0; k < 2; ++k) {
            const glm::vec<3, T> row = glm::mat<3, 3, T>(view) * rows[k];
            for (glm::length_t c = 0; c < 3; ++c) projection[c][k] = row[c];
        }
        faces[static_cast<std::size_t>(i)] =
            detail::checked<T>({view, projection, light.clip}, function, "position, z_near and z_far");
    }
    return faces;
}

/// The same on tetrahedron_texel's triangles.
template <real T = float>
[[nodiscard]] std::array<light_space<T>, 4> make_tetrahedron_light(const tetrahedron_light<T>& light) {
    return make_tetrahedron_light(light, tetrahedron_tiles(T(light.map_size)));
}

}  // namespace umbrage

// ---- umbrage/shade/lighting.hpp
// The lighting of the DirectX SDK's ShadowMap sample: a spot cone, diffuse plus ambient. Enough for whole pictures.
//
//     float cone = umbrage::spot_cone(light_direction, point - light_position, cos_outer_angle);
//     glm::vec3 colour = umbrage::diffuse_ambient(albedo, 0.2f, glm::dot(normal, to_light), visibility * cone);
//

namespace umbrage {

/// Whether a point lies inside a spot light's cone.
///
/// @param direction   of the light, unit length
/// @param to_point    from the light to the point, of any length whose square neither overflows nor underflows
/// @param cos_outer   cosine of the angle between axis and edge of the cone, in [0, 1)
/// @return            1 inside the cone, 0 outside, at its apex, or for NaN
/// @formula           d > 0 and d^2 > cos_outer^2 |to_point|^2, d = direction . to_point: the sample's test,
///                    unnormalised
/// @exactness         B
/// @cite              Microsoft DirectX SDK, ShadowMap sample
template <real T>
[[nodiscard]] constexpr T spot_cone(glm::vec<3, T> direction, glm::vec<3, T> to_point, T cos_outer) {
    const T d = direction.x * to_point.x + direction.y * to_point.y + direction.z * to_point.z;
    const T length2 = to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z;
    const T edge2 = cos_outer * cos_outer * length2;
    const bool defined = !is_nan(d) && !is_nan(edge2);
    return defined && d > T(0) && d * d > edge2 ? T(1) : T(0);
}

/// Light that a diffuse surface sends to the eye.
///
/// @param albedo       of the surface
/// @param ambient      share of light that reaches shadows, in [0, 1]
/// @param n_dot_l      cosine between normal and direction to the light; from 0 down, and NaN: ambient light alone
/// @param visibility   of the light, 1 lit
/// @formula            albedo (visibility n_dot_l (1 - ambient) + ambient) for n_dot_l > 0, else albedo ambient
/// @exactness          B
/// @cite               Microsoft DirectX SDK, ShadowMap sample
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> diffuse_ambient(glm::vec<3, T> albedo, T ambient, T n_dot_l, T visibility) {
    const bool faces = !is_nan(n_dot_l) && n_dot_l > T(0);
    return albedo * (faces ? visibility * n_dot_l * (T(1) - ambient) + ambient : ambient);
}

namespace glsl {

inline constexpr snippet spot_cone{
    .name = "spot_cone",
    .summary = "1 inside a spot light's cone",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_spot_cone: 1.0 inside the cone of a spot light, else 0.0
//   direction  of the light, unit length;   to_point  from the light, any length;   cos_outer  in [0, 1)
UMBRAGE_HIGHP float umbrage_spot_cone(UMBRAGE_HIGHP vec3 direction, UMBRAGE_HIGHP vec3 to_point,
                                      UMBRAGE_HIGHP float cos_outer) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d =
        direction.x * to_point.x + direction.y * to_point.y + direction.z * to_point.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float length2 =
        to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float edge2 = cos_outer * cos_outer * length2;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d2 = d * d;
    return d > 0.0 && d2 > edge2 ? 1.0 : 0.0;
}
)GLSL",
};

inline constexpr snippet diffuse_ambient{
    .name = "diffuse_ambient",
    .summary = "diffuse plus ambient light of a surface",
    .exactness = tier::b,
    .source = R"GLSL(
// umbrage_diffuse_ambient: albedo * (visibility * n_dot_l * (1 - ambient) + ambient); for n_dot_l <= 0, NaN: ambient
UMBRAGE_HIGHP vec3 umbrage_diffuse_ambient(UMBRAGE_HIGHP vec3 albedo, UMBRAGE_HIGHP float ambient,
                                           UMBRAGE_HIGHP float n_dot_l, UMBRAGE_HIGHP float visibility) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float light = visibility * n_dot_l * (1.0 - ambient) + ambient;
    return albedo * (n_dot_l > 0.0 ? light : ambient);  // a max of n_dot_l and 0.0 is NaN for a signalling one on Mesa
}
)GLSL",
};

inline constexpr auto lighting_snippets = list<&spot_cone, &diffuse_ambient>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/version.hpp
// The version of umbrage. CMake reads it from here.

#define UMBRAGE_VERSION_MAJOR 0
#define UMBRAGE_VERSION_MINOR 1
#define UMBRAGE_VERSION_PATCH 0

// ---- umbrage/view/false_colour.hpp
// Depth as colour, so that people can see it: blue near, through cyan, green and yellow, to red far.
//
//     glm::vec3 colour = umbrage::false_colour(depth);
//

namespace umbrage {

/// @param v       clamped to [0, 1]; NaN counts as far
/// @return        RGB in [0, 1]; brightness ramps up at both ends: 0 is dark blue, 1 dark red
/// @formula       3/2 - |4 v - c|, clamped, with c = 3, 2, 1 for red, green, blue
/// @exactness     B: one rounded difference a channel
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> false_colour(T v, T far = T(1)) {
    const T x = saturate(v, far) * T(4);
    const auto ramp = [x](T peak) {
        const T distance = x < peak ? peak - x : x - peak;
        return saturate(T(1.5) - distance);
    };
    return {ramp(T(3)), ramp(T(2)), ramp(T(1))};
}

namespace glsl {

inline constexpr snippet false_colour{
    .name = "false_colour",
    .summary = "0..1 to blue, green, red",
    .exactness = tier::b,
    .needs = list<&saturate>,
    .source = R"GLSL(
// umbrage_false_colour: blue for 0.0, through green, to red for 1.0
UMBRAGE_HIGHP vec3 umbrage_false_colour(UMBRAGE_HIGHP float v) {
    UMBRAGE_HIGHP float x = umbrage_saturate(v) * 4.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 ramp = 1.5 - abs(vec3(x - 3.0, x - 2.0, x - 1.0));
    return vec3(umbrage_saturate(ramp.x), umbrage_saturate(ramp.y), umbrage_saturate(ramp.z));
}
)GLSL",
};

inline constexpr auto false_colour_snippets = list<&false_colour>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/view/overlay_texel.hpp
// A map stretched over the picture's corner: which of its texels a pixel shows, along x and along y.
//
//     float column = umbrage::overlay_texel(x + 0.5f, 256.0f, 1024.0f, 1024.0f / 256.0f);  // -1: beside the overlay
//

namespace umbrage {

/// The texel that lies under a pixel's centre.
///
/// @param coord             centre of the pixel, counted from the corner: 0.5, 1.5, ...
/// @param size              of the overlay in pixels, whole
/// @param map_size          of the map in texels, whole, at most 65536 in float; size map_size at most 2^23 in float,
///                          2^52 in double
/// @param texels_per_pixel  map_size / size, up to 16 ulp off
/// @return                  whole, from 0 to map_size - 1; -1 outside the overlay, and for NaN
/// @formula                 floor(coord map_size / size)
/// @exactness               A: the quotient is rounded, so its floor less 0 or 1 is taken, and products of whole
///                          numbers tell which
template <real T>
[[nodiscard]] T overlay_texel(T coord, T size, T map_size, T texels_per_pixel) {
    if (is_nan(coord) || !(coord >= T(0) && coord < size)) return T(-1);
    const T texel = std::floor(coord * texels_per_pixel - T(0.5));
    return (texel + T(1)) * size <= coord * map_size ? texel + T(1) : texel;
}

namespace glsl {

inline constexpr snippet overlay_texel{
    .name = "overlay_texel",
    .summary = "which texel of a map stretched over the picture's corner a pixel shows, along one side",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_overlay_texel: texel under a pixel of a map stretched over the picture's corner; -1.0 outside the overlay
//   coord     centre of the pixel, counted from the corner: 0.5, 1.5, ...;   size  of the overlay in pixels, whole
//   map_size  in texels, whole, at most 65536.0; times size at most 2^23;   texels_per_pixel  map_size / size
UMBRAGE_HIGHP float umbrage_overlay_texel(UMBRAGE_HIGHP float coord, UMBRAGE_HIGHP float size,
                                          UMBRAGE_HIGHP float map_size, UMBRAGE_HIGHP float texels_per_pixel) {
    UMBRAGE_HIGHP float texel = floor(coord * texels_per_pixel - 0.5);
    texel += (texel + 1.0) * size <= coord * map_size ? 1.0 : 0.0;
    return coord >= 0.0 && coord < size ? texel : -1.0;
}
)GLSL",
};

inline constexpr auto overlay_texel_snippets = list<&overlay_texel>;

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/primitives.hpp
// The primitives of umbrage alone, for short compile times. Functions over whole images, the depth pass among them,
// lights that are fitted to a scene (directional_fit, spot_fit, cascades, warp, adaptive) and the texts of snippets
// come with <umbrage/umbrage.hpp> or in headers of their own. Made by single_include/amalgamate.cmake.


// ---- umbrage/simd/blocks/form.hpp
// The form of a filter for blocks of 64 receivers: what visibility() runs where a filter has one. A filter that has
// none is called receiver by receiver.
//
// A form says what it needs of a map, the least side of a map that it can take, and makes its blocks, for a map of
// floats or of rg and a direction. Blocks work in two steps, some blocks apart, so that texels have come from memory
// when they are needed: place() says where to look and prefetches it; the second step loads it, compares and weighs.
// A place() with a third argument gets the row of pixels that the block lies in; its column is a multiple of 64.
//
//     template <>
//     struct block_form<filters::pcf_2x2> {
//         static constexpr map_need need = map_need::texels;
//         static constexpr int least = 2;
//         template <depth_direction Direction, class Map, class ParallelFor, class Use>
//         static void with_blocks(const Map& map, const filters::pcf_2x2&, ParallelFor&&, const Use& use) {
//             use(pcf_2x2_blocks<Direction, Map>{map});
//         }
//     };
//

namespace umbrage::detail {

/// What the blocks of a filter read.
enum class map_need {
    texels,  ///< a few texels a receiver: as they are stored, where that has a fast form, or floats
    floats,  ///< many: decoding each for each receiver would cost more than decoding the map once
};

template <class Filter>
struct block_form;

template <class Filter>
concept has_block_form = requires {
    block_form<Filter>::need;
};

}  // namespace umbrage::detail

// ---- umbrage/images/receivers.hpp
// The receivers of a whole image, in the forms that visibility() takes: an image of vec3s (x and y in texels of the
// map, z depth, biased), three images of floats, or the depth image that a camera saw.
//
//     umbrage::depth_receivers seen{depth, umbrage::receiver_matrix(clip_to_world, to_texels, size, clip), bias};
//

namespace umbrage {

/// Receivers as three images of the same size: x and y in texels of the map, depth, biased.
struct receiver_planes {
    image_view<const float> x, y, depth;
};

/// Receivers as a camera's depth image.
struct depth_receivers {
    image_view<const float> depth;  ///< as the depth pass leaves it, in [0, 1]
    glm::mat4 matrix;               ///< receiver_matrix
    float bias = 0.0f;              ///< in the map's depth, taken off each receiver's
};

/// The way from a camera's depth image to the shadow map.
///
/// @param clip_to_world    inverse of the camera's projection * view
/// @param texture_matrix   world to texels of the map
/// @param size             of the depth image in texels, each >= 1
/// @param clip             the camera's convention
/// @return                 (texel + 1/2, depth) -> what shadow_coordinate gives, times a positive number in front of
///                         the camera; the product is taken in double
/// @throws std::invalid_argument  size below 1, or a matrix that is not finite
[[nodiscard]] inline glm::mat4 receiver_matrix(const glm::mat4& clip_to_world, const glm::mat4& texture_matrix,
                                               glm::ivec2 size, clip_space clip) {
    detail::require(size.x >= 1 && size.y >= 1, "receiver_matrix", "size", "must be above 0");
    const double up = clip.origin == texture_origin::bottom ? 1.0 : -1.0;
    glm::dmat4 to_clip(1.0);
    to_clip[0][0] = 2.0 / size.x;
    to_clip[1][1] = up * 2.0 / size.y;
    to_clip[3] = {-1.0, -up, 0.0, 1.0};
    if (clip.range == depth_range::minus_one_to_one) {
        to_clip[2][2] = 2.0;
        to_clip[3][2] = -1.0;
    }
    const glm::mat4 m(glm::dmat4(texture_matrix) * glm::dmat4(clip_to_world) * to_clip);
    detail::require(detail::all_finite(m), "receiver_matrix", "clip_to_world and texture_matrix",
                    "give a matrix that is not finite");
    return m;
}

/// One receiver of a camera's depth image.
/// @formula       project_coordinate(shadow_coordinate(matrix, (texel + 1/2, depth))), bias taken off its depth
/// @exactness     C, as project_coordinate
[[nodiscard]] inline glm::vec3 receiver_at(const depth_receivers& seen, glm::ivec2 texel) {
    const glm::vec3 at(static_cast<float>(texel.x) + 0.5f, static_cast<float>(texel.y) + 0.5f, seen.depth[texel]);
    const glm::vec3 p = project_coordinate(shadow_coordinate(seen.matrix, at));
    return {p.x, p.y, p.z - seen.bias};
}

namespace detail {

[[nodiscard]] inline glm::ivec2 size_of(const image_view<const glm::vec3>& receivers) { return receivers.size; }
[[nodiscard]] inline glm::ivec2 size_of(const depth_receivers& receivers) { return receivers.depth.size; }
[[nodiscard]] inline glm::ivec2 size_of(const receiver_planes& receivers) {
    if (receivers.x.size != receivers.depth.size || receivers.y.size != receivers.depth.size)
        fail("umbrage::visibility: sizes differ");
    return receivers.depth.size;
}

}  // namespace detail
}  // namespace umbrage

// ---- umbrage/simd/strict_math.hpp
// Keeps -ffast-math out of code whose bits are promised:
//
//     UMBRAGE_STRICT_MATH
//     namespace umbrage { ... }  // sums stay in their order, quotients stay quotients, -0 stays -0
//     UMBRAGE_END_STRICT_MATH
//
// Comparisons with NaN are not kept: under -ffinite-math-only GCC shortens them even here, so that code which may meet
// a NaN tests its bits. Denormals may be flushed, which is a mode of the processor. Without the flag these macros are
// empty, as they are for clang where it has no such pragma (version 14: all but x86).

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__)
#if defined(__clang__) && (defined(__x86_64__) || __clang_major__ > 14)
#define UMBRAGE_STRICT_MATH _Pragma("float_control(precise, on, push)")
#define UMBRAGE_END_STRICT_MATH _Pragma("float_control(pop)")
#elif defined(__GNUC__) && !defined(__clang__)
#define UMBRAGE_STRICT_MATH _Pragma("GCC push_options") _Pragma("GCC optimize(\"no-fast-math\")")
#define UMBRAGE_END_STRICT_MATH _Pragma("GCC pop_options")
#endif
#endif

#ifndef UMBRAGE_STRICT_MATH
#define UMBRAGE_STRICT_MATH
#define UMBRAGE_END_STRICT_MATH
#endif

namespace umbrage::detail {

/// Whether the compiler takes it that no float is a NaN. Without external linkage: files may differ.
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
constexpr bool finite_math_only = true;
#else
constexpr bool finite_math_only = false;
#endif

}  // namespace umbrage::detail

// ---- umbrage/simd/bits.hpp
// Comparisons, selections and conversions of floats as operations on their bits: without a branch, so that loops over
// blocks vectorise, and with NaN where -ffast-math forgets it. Masks are all bits of a number, or none.
//
//     visibility[i] = select(texel_space_mask(x, y), sum, 1.0f);
//

namespace umbrage::detail {

/// Mask of the floats that are not NaN.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t number_mask(float v) {
    return -std::int32_t((detail::bit_cast<std::int32_t>(v) & 0x7FFFFFFF) <= 0x7F800000);
}

/// Mask of the floats that are neither NaN nor infinite.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t finite_mask(float v) {
    return -std::int32_t((detail::bit_cast<std::int32_t>(v) & 0x7FFFFFFF) < 0x7F800000);
}

/// inside_texel_space as a mask.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t texel_space_mask(float x, float y) {
    constexpr auto limit = detail::bit_cast<std::int32_t>(32768.0f);
    return -(std::int32_t((detail::bit_cast<std::int32_t>(x) & 0x7FFFFFFF) < limit) &
             std::int32_t((detail::bit_cast<std::int32_t>(y) & 0x7FFFFFFF) < limit));
}

/// beyond_far of a comparison as a mask.
template <bool Forward>
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t beyond_far_mask(float depth) {
    constexpr std::int32_t one = 0x3F800000, infinity = 0x7F800000;
    const auto bits = detail::bit_cast<std::int32_t>(depth);
    if constexpr (Forward) return -(std::int32_t(bits > one) & std::int32_t(bits <= infinity));
    const std::int32_t magnitude = bits & 0x7FFFFFFF;
    return -(std::int32_t(bits < 0) & std::int32_t(magnitude > 0) & std::int32_t(magnitude <= infinity));
}

[[nodiscard]] UMBRAGE_INLINE inline float masked(float v, std::int32_t mask) {
    return detail::bit_cast<float>(detail::bit_cast<std::int32_t>(v) & mask);
}
[[nodiscard]] UMBRAGE_INLINE inline double masked(double v, std::int64_t mask) {
    return detail::bit_cast<double>(detail::bit_cast<std::int64_t>(v) & mask);
}
[[nodiscard]] UMBRAGE_INLINE inline float select(std::int32_t mask, float a, float b) {
    return detail::bit_cast<float>((detail::bit_cast<std::int32_t>(a) & mask) |
                                   (detail::bit_cast<std::int32_t>(b) & ~mask));
}

/// less_equal as 0 or 1, NaN 0 whatever the compiler believes.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t is_lit(float receiver, float stored) {
    if constexpr (finite_math_only)
        return std::int32_t(receiver <= stored) & number_mask(receiver) & number_mask(stored);
    else return std::int32_t(receiver <= stored);
}

/// saturate: the magnitude up to `highest`, or 0 for what is negative and not a NaN.
[[nodiscard]] UMBRAGE_INLINE inline float saturate_bits(float v, float highest = 1.0f) {
    constexpr auto minus_infinity = static_cast<std::int32_t>(0xFF800000u);
    const auto bits = detail::bit_cast<std::int32_t>(v), top = detail::bit_cast<std::int32_t>(highest);
    const std::int32_t magnitude = bits & 0x7FFFFFFF, kept = -std::int32_t(bits > minus_infinity);
    return detail::bit_cast<float>((magnitude < top ? magnitude : top) & kept);
}

/// floor; |v| < 2^31.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t floor_int(float v) {
    const auto toward_zero = static_cast<std::int32_t>(v);
    return toward_zero - std::int32_t(static_cast<float>(toward_zero) > v);
}

/// v clamped to 0 .. highest.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t clamp_int(std::int32_t v, std::int32_t highest) {
    v = v > 0 ? v : 0;
    return v < highest ? v : highest;
}

/// floor of v clamped to 0 .. highest <= 2^24; NaN gives one of the ends. A float that is not negative truncates to its
/// floor, and is ordered as its bits are.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t floor_within(float v, float highest) {
    const auto bits = detail::bit_cast<std::int32_t>(v), top = detail::bit_cast<std::int32_t>(highest);
    const std::int32_t positive = bits > 0 ? bits : 0;
    return static_cast<std::int32_t>(detail::bit_cast<float>(positive < top ? positive : top));
}

/// Magnitude of floor(v), at most `limit`, a whole number below 2^24; NaN counts as it.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t floor_magnitude(float v, float limit) {
    const auto bits = detail::bit_cast<std::int32_t>(v), top = detail::bit_cast<std::int32_t>(limit);
    const std::int32_t magnitude = bits & 0x7FFFFFFF;
    const auto within = detail::bit_cast<float>(magnitude < top ? magnitude : top);
    const auto whole = static_cast<std::int32_t>(within);
    return whole + (bits < 0 && static_cast<float>(whole) < within ? 1 : 0);
}

/// Floats as integers in the same order, -0 below +0, NaN below everything; and back.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t order_key(float v) {
    const auto bits = detail::bit_cast<std::int32_t>(v);
    const std::int32_t number = number_mask(v);
    return ((bits ^ (bits >> 31 & 0x7FFFFFFF)) & number) | (INT32_MIN & ~number);
}
[[nodiscard]] UMBRAGE_INLINE inline float from_order_key(std::int32_t key) {
    return detail::bit_cast<float>(key ^ (key >> 31 & 0x7FFFFFFF));
}
struct least_of {
    UMBRAGE_INLINE std::int32_t operator()(std::int32_t a, std::int32_t b) const { return a < b ? a : b; }
};
struct greatest_of {
    UMBRAGE_INLINE std::int32_t operator()(std::int32_t a, std::int32_t b) const { return a > b ? a : b; }
};

}  // namespace umbrage::detail

// ---- umbrage/simd/dispatch.hpp
// One loop, compiled for each instruction set, the machine's best chosen when the program runs. No flags, no
// intrinsics.
//
//     umbrage::detail::on_best_isa([&](auto) UMBRAGE_INLINE { for (...) block(...); });
//
// A body is inlined into thin functions that carry the target; what it calls must be UMBRAGE_INLINE too, or it is
// compiled for the base set. GCC vectorises at -O2 only loops whose count it knows, and no `c ? x : y` on floats: so
// loops run over blocks of 64, and select on the bits.
//
// UMBRAGE_FORCE_ISA=base, =avx2 or =avx512 sets the choice, and nothing wider is compiled; a machine that lacks it
// takes the next lower one. No choice changes a bit of a result of tier A. It has to be the same in all files of a
// program.

// Before a loop that writes memory which nothing it reads lies in: GCC does not check that at run time at -O2.
#if defined(__GNUC__) && !defined(__clang__)
#define UMBRAGE_NO_OVERLAP _Pragma("GCC ivdep")
#else
#define UMBRAGE_NO_OVERLAP
#endif

namespace umbrage::detail {

enum class isa { base, avx2, avx512 };

template <isa Set>
using isa_constant = std::integral_constant<isa, Set>;

#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
inline constexpr bool has_dispatch = true;

/// The best instruction set of this machine, of those that get a path of their own.
[[nodiscard]] inline isa best_isa() {
    __builtin_cpu_init();
    if (!__builtin_cpu_supports("avx2")) return isa::base;
    const bool wide = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
    return wide ? isa::avx512 : isa::avx2;
}

template <class Body>
__attribute__((target("avx2"), noinline)) void on_avx2(const Body& body) {
    body(isa_constant<isa::avx2>{});
}
template <class Body>
__attribute__((target("avx512f,avx512bw,avx512dq,avx512vl"), noinline)) void on_avx512(const Body& body) {
    body(isa_constant<isa::avx512>{});
}
#else
inline constexpr bool has_dispatch = false;
[[nodiscard]] inline isa best_isa() { return isa::base; }
#endif

/// The widest set that anything is compiled for.
#if defined(UMBRAGE_FORCE_ISA)
inline constexpr isa widest_isa = has_dispatch ? isa::UMBRAGE_FORCE_ISA : isa::base;
#else
inline constexpr isa widest_isa = has_dispatch ? isa::avx512 : isa::base;
#endif

/// What image functions use; tests set it to see every path.
inline isa isa_in_use = best_isa() < widest_isa ? best_isa() : widest_isa;

/// Runs the body, compiled for the instruction set in use, which it gets as a constant. Only for results that no
/// contraction to FMA can change.
template <class Body>
void on_best_isa(const Body& body) {
    if constexpr (widest_isa >= isa::avx512)
        if (isa_in_use >= isa::avx512) return on_avx512(body);
    if constexpr (widest_isa >= isa::avx2)
        if (isa_in_use >= isa::avx2) return on_avx2(body);
    body(isa_constant<isa::base>{});
}

/// The same for sums of products that round: AVX-512 brings FMA along, with which compilers change the result.
template <class Body>
void on_best_isa_without_fma(const Body& body) {
    if constexpr (widest_isa >= isa::avx2)
        if (isa_in_use != isa::base) return on_avx2(body);
    body(isa_constant<isa::base>{});
}

/// Runs the body in a function of its own, of the instruction set that its caller is compiled for: large bodies with
/// several callers are then compiled once.
template <class Body>
void out_of_line(isa_constant<isa::base> set, const Body& body) {
    body(set);
}
template <isa Set, class Body>
void out_of_line(isa_constant<Set>, const Body& body) {
    if constexpr (Set == isa::avx512) on_avx512(body);
    else on_avx2(body);
}

/// Elements of a loop whose count the compiler knows. Arrays of as many start at a cache line: where they do not, which
/// on a stack is chance, a loop over them can take several times as long.
inline constexpr int block = 64;

}  // namespace umbrage::detail

// ---- umbrage/simd/plain_lanes.hpp
// What lanes.hpp does, for any compiler: arrays instead of registers, and loops.
//

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

template <class T, int Count>
struct plain_lanes {
    T at[std::size_t(Count)];

    T& operator[](int i) { return at[i]; }
    const T& operator[](int i) const { return at[i]; }

    plain_lanes& operator+=(const plain_lanes& b) {
        for (int i = 0; i < Count; ++i) at[i] += b.at[i];
        return *this;
    }
    plain_lanes& operator-=(const plain_lanes& b) {
        for (int i = 0; i < Count; ++i) at[i] -= b.at[i];
        return *this;
    }
    plain_lanes& operator*=(const plain_lanes& b) {
        for (int i = 0; i < Count; ++i) at[i] *= b.at[i];
        return *this;
    }
    plain_lanes& operator&=(const plain_lanes& b) {
        for (int i = 0; i < Count; ++i) at[i] &= b.at[i];
        return *this;
    }
    friend plain_lanes operator+(plain_lanes a, const plain_lanes& b) { return a += b; }
    friend plain_lanes operator-(plain_lanes a, const plain_lanes& b) { return a -= b; }
    friend plain_lanes operator*(plain_lanes a, const plain_lanes& b) { return a *= b; }
    friend plain_lanes operator&(plain_lanes a, const plain_lanes& b) { return a &= b; }
};

/// Lane i of the result is lane From[i] of a, then b, counted through; lanes of 32 bits.
template <int... From, class T, int Count>
inline void shuffle(const plain_lanes<T, Count>& a, const plain_lanes<T, Count>& b,
                    plain_lanes<T, int(sizeof...(From))>& result) {
    result = {{(From < Count ? a[From % Count] : b[From % Count])...}};
}

/// is_lit, or is_lit the other way round, as a mask for each lane; the receiver is not NaN.
template <int Count, bool Forward>
inline void lit_lanes(float receiver, const plain_lanes<float, Count>& stored, plain_lanes<std::int32_t, Count>& lit) {
    for (int i = 0; i < Count; ++i) lit[i] = -(Forward ? is_lit(receiver, stored[i]) : is_lit(stored[i], receiver));
}

/// The sum of each of two registers of 4 or 8 numbers between 0 and 127.
template <int Count>
inline void sum_two_lanes(const plain_lanes<std::int32_t, Count>& first, const plain_lanes<std::int32_t, Count>& second,
                          std::int32_t* sums) {
    sums[0] = sums[1] = 0;
    for (int i = 0; i < Count; ++i) {
        sums[0] += first[i];
        sums[1] += second[i];
    }
}

/// Four masks of eight lanes as bits: bit 4 i + k is lane k of mask i, bit 16 + 4 i + k its lane 4 + k.
inline std::uint32_t mask_bits(const plain_lanes<std::int32_t, 8>* masks) {
    std::uint32_t bits = 0;
    for (int i = 0; i < 32; ++i) bits |= static_cast<std::uint32_t>(masks[i / 4 % 4][i / 16 * 4 + i % 4] & 1) << i;
    return bits;
}

/// Adds the weight to the lanes of a mask.
template <int Count>
inline void add_where(const plain_lanes<std::int32_t, Count>& mask, float weight, plain_lanes<float, Count>& sum) {
    for (int i = 0; i < Count; ++i) sum[i] += masked(weight, mask[i]);
}

/// Zero in the lanes that a mask leaves out.
template <int Count>
inline void keep_where(const plain_lanes<std::int32_t, Count>& mask, plain_lanes<float, Count>& v) {
    for (int i = 0; i < Count; ++i) v[i] = masked(v[i], mask[i]);
}

/// Adds products to a register of four, lane by lane and round about; none rounds.
template <int Count>
inline void add_products(const plain_lanes<float, Count>& a, const plain_lanes<float, Count>& b,
                         plain_lanes<float, 4>& sums) {
    for (int i = 0; i < Count; ++i) sums[i % 4] += a[i] * b[i];
}

/// The sum of the lanes of each of four registers.
template <class T>
inline void sum_four_lanes(const plain_lanes<T, 4>& a, const plain_lanes<T, 4>& b, const plain_lanes<T, 4>& c,
                           const plain_lanes<T, 4>& d, plain_lanes<T, 4>& sums) {
    for (int k = 0; const auto* v : {&a, &b, &c, &d}) sums[k++] = (*v)[0] + (*v)[1] + (*v)[2] + (*v)[3];
}

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH

// ---- umbrage/simd/lanes.hpp
// Registers: several values side by side, an operation on all of them at once.
//
//     lanes_of<float, 8> depths;
//     load_lanes(texels, depths);  // with + - & and [] of the language
//
// The compiler's own vectors: they need no header and know no machine. Where it has none, or for a test,
// plain_lanes.hpp gives the same bits, and says what each function does. Vectors go by reference: by value, the calling
// convention depends on the instruction set.

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

#if defined(__GNUC__) || defined(__clang__)
/// Whether the compiler has vectors of its own, with all operators of the language.
inline constexpr bool has_lanes = true;

template <class T, int Count>
struct compiler_lanes {
    typedef T type __attribute__((vector_size(Count * sizeof(T))));
};
template <class T, int Count>
using lanes_of = typename compiler_lanes<T, Count>::type;
#else
inline constexpr bool has_lanes = false;
template <class T, int Count>
using lanes_of = plain_lanes<T, Count>;
#endif

/// From memory of any alignment, and back.
template <class Lanes>
UMBRAGE_INLINE inline void load_lanes(const void* from, Lanes& v) {
    std::memcpy(&v, from, sizeof v);
}
template <class Lanes>
UMBRAGE_INLINE inline void store_lanes(const Lanes& v, void* to) {
    std::memcpy(to, &v, sizeof v);
}

#if defined(__GNUC__) || defined(__clang__)
template <int... From, class Lanes, class Result>
UMBRAGE_INLINE inline void shuffle(const Lanes& a, const Lanes& b, Result& result) {
    result = __builtin_shufflevector(a, b, From...);
}

/// 0, 1, 2 ...
template <class T, int Count>
UMBRAGE_INLINE inline void count_lanes(lanes_of<T, Count>& v) {
    [&]<int... I>(std::integer_sequence<int, I...>) UMBRAGE_INLINE { v = lanes_of<T, Count>{T(I)...}; }
    (std::make_integer_sequence<int, Count>{});
}

/// The lanes of `low`, then those of `high`, each converted to half as many bits.
template <class T, int Count, class Half>
UMBRAGE_INLINE inline void narrow_lanes(const Half& low, const Half& high, lanes_of<T, Count>& v) {
    using half = lanes_of<T, Count / 2>;
    [&]<int... I>(std::integer_sequence<int, I...>) UMBRAGE_INLINE {
        v = __builtin_shufflevector(__builtin_convertvector(low, half), __builtin_convertvector(high, half), I...);
    }
    (std::make_integer_sequence<int, Count>{});
}

template <int Count, bool Forward>
UMBRAGE_INLINE inline void lit_lanes(float receiver, const lanes_of<float, Count>& stored,
                                     lanes_of<std::int32_t, Count>& lit) {
    if constexpr (Forward) lit = receiver <= stored;
    else lit = receiver >= stored;
    if constexpr (finite_math_only)
        lit &= (reinterpret_cast<lanes_of<std::int32_t, Count>>(stored) & 0x7FFFFFFF) <= 0x7F800000;
}

template <int Count>
UMBRAGE_INLINE inline void add_where(const lanes_of<std::int32_t, Count>& mask, float weight,
                                     lanes_of<float, Count>& sum) {
    const lanes_of<std::int32_t, Count> weights = mask & detail::bit_cast<std::int32_t>(weight);
    sum += reinterpret_cast<lanes_of<float, Count>>(weights);
}

template <int Count>
UMBRAGE_INLINE inline void keep_where(const lanes_of<std::int32_t, Count>& mask, lanes_of<float, Count>& v) {
    v = reinterpret_cast<lanes_of<float, Count>>(mask & reinterpret_cast<lanes_of<std::int32_t, Count>>(v));
}

template <int Count>
UMBRAGE_INLINE inline void add_products(const lanes_of<float, Count>& a, const lanes_of<float, Count>& b,
                                        lanes_of<float, 4>& sums) {
    const lanes_of<float, Count> products = a * b;
    lanes_of<float, 4> part;
    std::memcpy(&part, &products, sizeof part);
    sums += part;
    if constexpr (Count == 8) {
        std::memcpy(&part, reinterpret_cast<const char*>(&products) + sizeof part, sizeof part);
        sums += part;
    }
}

template <class Four>
UMBRAGE_INLINE inline void sum_four_lanes(const Four& a, const Four& b, const Four& c, const Four& d, Four& sums) {
    Four even, odd, first, second;
    shuffle<0, 4, 1, 5>(a, b, even);
    shuffle<2, 6, 3, 7>(a, b, odd);
    first = even + odd;
    shuffle<0, 4, 1, 5>(c, d, even);
    shuffle<2, 6, 3, 7>(c, d, odd);
    second = even + odd;
    shuffle<0, 1, 4, 5>(first, second, even);
    shuffle<2, 3, 6, 7>(first, second, odd);
    sums = even + odd;
}

#if defined(__x86_64__) && !defined(__clang__)
// Inlined into what is compiled for AVX2; dispatch.hpp has made its builtins known.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"
UMBRAGE_INLINE inline std::uint32_t mask_bits(const lanes_of<std::int32_t, 8>* masks) {
    const auto first = __builtin_ia32_packssdw256(masks[0], masks[1]);  // the halves of registers stay apart
    const auto second = __builtin_ia32_packssdw256(masks[2], masks[3]);
    return static_cast<std::uint32_t>(__builtin_ia32_pmovmskb256(__builtin_ia32_packsswb256(first, second)));
}
#pragma GCC diagnostic pop
#elif defined(__GNUC__) || defined(__clang__)
UMBRAGE_INLINE inline std::uint32_t mask_bits(const lanes_of<std::int32_t, 8>* masks) {
    using bits = lanes_of<std::int32_t, 8>;
    const bits rows = (masks[0] & 1) + (masks[1] & 16) + (masks[2] & 256) + (masks[3] & 4096);
    const bits placed = rows << bits{0, 1, 2, 3, 16, 17, 18, 19};
    lanes_of<std::int32_t, 4> halves[2];
    std::memcpy(halves, &placed, sizeof halves);
    const auto all = halves[0] | halves[1];
    return static_cast<std::uint32_t>(all[0] | all[1] | all[2] | all[3]);
}
#endif

template <int Count>
UMBRAGE_INLINE inline void sum_two_lanes(const lanes_of<std::int32_t, Count>& first,
                                         const lanes_of<std::int32_t, Count>& second, std::int32_t* sums) {
    using four = lanes_of<std::int32_t, 4>;
    const auto to_four = [](const auto& numbers) UMBRAGE_INLINE {
        four parts[std::size_t(Count) / 4], sum{};
        std::memcpy(parts, &numbers, sizeof parts);
        for (const four& part : parts) sum += part;
        return sum;
    };
    const four a = to_four(first), b = to_four(second);
#if defined(__x86_64__)
    using bytes = compiler_lanes<char, 16>::type;
    const auto halves = reinterpret_cast<bytes>(__builtin_ia32_packssdw128(a, b));
    const auto wide = reinterpret_cast<four>(__builtin_ia32_psadbw128(halves, bytes{}));  // adds bytes, eight at a time
    const auto both = __builtin_ia32_packssdw128(wide, wide);
    std::memcpy(sums, &both, 2 * sizeof *sums);
#else
    sums[0] = a[0] + a[1] + a[2] + a[3];
    sums[1] = b[0] + b[1] + b[2] + b[3];
#endif
}
#endif

/// Each lane plus those before it: of four as v0, v0+v1, (v1+v2)+v0, (v2+v3)+(v0+v1).
template <int Count, class Lanes>
UMBRAGE_INLINE inline void running_sum(Lanes& v) {
    const auto add_moved = [&]<int... From>() UMBRAGE_INLINE {
        Lanes moved;
        shuffle<From...>(Lanes{}, v, moved);
        v = v + moved;
    };
    static_assert(Count == 4 || Count == 8);
    if constexpr (Count == 8) {
        add_moved.template operator()<0, 8, 9, 10, 11, 12, 13, 14>();
        add_moved.template operator()<0, 1, 8, 9, 10, 11, 12, 13>();
        add_moved.template operator()<0, 1, 2, 3, 8, 9, 10, 11>();
    } else {
        add_moved.template operator()<0, 4, 5, 6>();
        add_moved.template operator()<0, 1, 4, 5>();
    }
}

/// Running sums of bytes, eight by eight: they fit 16 bits, of which registers hold twice as many.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
inline constexpr bool sums_bytes = true;
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpsabi"
UMBRAGE_INLINE inline void running_sums_of_bytes(const std::uint8_t* from, lanes_of<std::uint32_t, 8>& first,
                                                 lanes_of<std::uint32_t, 8>& second) {
    using halves = compiler_lanes<long long, 4>::type;
    using numbers = compiler_lanes<short, 16>::type;
    compiler_lanes<char, 16>::type bytes;
    load_lanes(from, bytes);
    numbers v = __builtin_ia32_pmovzxbw256(bytes);
    v += reinterpret_cast<numbers>(__builtin_ia32_pslldqi256(reinterpret_cast<halves>(v), 16));
    v += reinterpret_cast<numbers>(__builtin_ia32_pslldqi256(reinterpret_cast<halves>(v), 32));
    v += reinterpret_cast<numbers>(__builtin_ia32_pslldqi256(reinterpret_cast<halves>(v), 64));
    compiler_lanes<short, 8>::type half[2];
    std::memcpy(half, &v, sizeof half);
    first = reinterpret_cast<lanes_of<std::uint32_t, 8>>(__builtin_ia32_pmovzxwd256(half[0]));
    second = reinterpret_cast<lanes_of<std::uint32_t, 8>>(__builtin_ia32_pmovzxwd256(half[1]));
}
#pragma GCC diagnostic pop
#else
inline constexpr bool sums_bytes = false;
#endif

/// The last lane in all of them.
template <int Count, class Lanes>
UMBRAGE_INLINE inline void all_last(Lanes& v) {
    Lanes last;
    if constexpr (Count == 8) shuffle<7, 7, 7, 7, 7, 7, 7, 7>(v, v, last);
    else shuffle<3, 3, 3, 3>(v, v, last);
    v = last;
}

/// Lanes of a running sum where registers have eight: clang 14 is slower with them than with four.
#if defined(__GNUC__) && !defined(__clang__)
inline constexpr int running_sum_lanes = 8;
#else
inline constexpr int running_sum_lanes = 4;
#endif

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH

// ---- umbrage/simd/memory.hpp
// How large images get to memory: with non-temporal stores, and prefetched.
//
//     const bool large = umbrage::detail::past_cache(out);
//     if (large) umbrage::detail::stream_block(to, from);
//     if (large) umbrage::detail::finish_streaming();
//

namespace umbrage::detail {

/// Whether an image is so large that non-temporal stores pay: others would read each cache line before it is
/// overwritten, and evict what is read meanwhile.
template <class T>
[[nodiscard]] inline bool past_cache(const image_view<T>& image) {
    constexpr double large = 4.0 * (1 << 20);  // bytes
    return static_cast<double>(sizeof(T)) * image.size.x * image.size.y >= large;
}

/// Whether stream() can store there.
[[nodiscard]] UMBRAGE_INLINE inline bool streams_to(const void* to) {
    return reinterpret_cast<std::uintptr_t>(to) % 16 == 0;
}

/// Non-temporal stores of a multiple of 16 bytes. Other threads see them after finish_streaming().
template <std::size_t Bytes>
UMBRAGE_INLINE inline void stream(void* to, const void* from) {
#if (defined(__GNUC__) && defined(__x86_64__)) || defined(__clang__)
    typedef lanes_of<float, 4> four __attribute__((may_alias));
    static_assert(Bytes % sizeof(four) == 0);
#pragma GCC unroll 16
    for (std::size_t i = 0; i < Bytes; i += sizeof(four)) {
        four part;
        load_lanes(static_cast<const std::byte*>(from) + i, part);
#if defined(__clang__)
        __builtin_nontemporal_store(part, reinterpret_cast<four*>(static_cast<std::byte*>(to) + i));
#else
        __builtin_ia32_movntps(reinterpret_cast<float*>(static_cast<std::byte*>(to) + i), part);
#endif
    }
#else
    std::memcpy(to, from, Bytes);
#endif
}

inline void finish_streaming() {
#if defined(__GNUC__) && defined(__x86_64__)
    __builtin_ia32_sfence();
#endif
}

/// A block of texels by non-temporal stores, where stream() can.
template <class T>
UMBRAGE_INLINE inline void stream_block(T* to, const T* from) {
    if (streams_to(to)) stream<block * sizeof(T)>(to, from);
    else std::memcpy(static_cast<void*>(to), from, block * sizeof(T));
}

/// Up to a block of floats; most are whole, and then the compiler knows how much there is to copy.
UMBRAGE_INLINE inline void copy_floats(float* to, const float* from, int count) {
    if (count == block) std::memcpy(to, from, block * sizeof(float));
    else std::memcpy(to, from, static_cast<std::size_t>(count) * sizeof(float));
}

/// Prefetches a cache line. Callers must be UMBRAGE_INLINE or do more than that: for GCC a function that only
/// prefetches has no effect, and a call of it is left out.
UMBRAGE_INLINE inline void prefetch_line([[maybe_unused]] const void* at) {
#if defined(__GNUC__) || defined(__clang__)
    __builtin_prefetch(at);
#endif
}

/// Prefetches `count` bytes, `ahead` bytes from there; they may lie behind the end of an array.
UMBRAGE_INLINE inline void prefetch_bytes(const void* from, std::ptrdiff_t ahead, int count) {
    const std::uintptr_t first = reinterpret_cast<std::uintptr_t>(from) + static_cast<std::uintptr_t>(ahead);
#pragma GCC unroll 16
    for (int line = 0; line < count; line += 64)
        prefetch_line(reinterpret_cast<const void*>(first + static_cast<std::uintptr_t>(line)));
}

/// Prefetches what a row holds behind its last whole step, before non-temporal stores to the row: the rest is stored
/// plainly, stores take their turn, and those of the next rows would wait for its cache lines. Tables of 2032
/// columns were five to seven times as slow.
template <class T>
UMBRAGE_INLINE inline void prefetch_rest(const T* row, int count, int step = block) {
    for (int x = count / step * step; x < count; x += static_cast<int>(64 / sizeof(T))) prefetch_line(row + x);
    if (count % step != 0) prefetch_line(row + count - 1);
}

}  // namespace umbrage::detail

// ---- umbrage/simd/blocks/receivers.hpp
// Blocks of 64 receivers, wherever they come from: x(i), y(i) in texels, z(i) depth.
//
//     use_receivers(receivers, walk, set, [&](const auto& of_block) { blocks.place(of_block, placed); });
//

namespace umbrage::detail {

/// A block of receivers in an image, read where they are. Element by element: GCC does not vectorise whole vec3s.
struct receiver_texels {
    const glm::vec3* first;
    [[nodiscard]] UMBRAGE_INLINE float x(int i) const { return first[i].x; }
    [[nodiscard]] UMBRAGE_INLINE float y(int i) const { return first[i].y; }
    [[nodiscard]] UMBRAGE_INLINE float z(int i) const { return first[i].z; }
};

/// The same in three planes.
struct receiver_rows {
    const float *first_x, *first_y, *first_z;
    [[nodiscard]] UMBRAGE_INLINE float x(int i) const { return first_x[i]; }
    [[nodiscard]] UMBRAGE_INLINE float y(int i) const { return first_y[i]; }
    [[nodiscard]] UMBRAGE_INLINE float z(int i) const { return first_z[i]; }
};

/// The same in memory of its own; what lies behind the last receiver of a row is not read into any result.
struct receiver_block {
    alignas(64) float xs[block]{}, ys[block]{}, zs[block]{};
    [[nodiscard]] UMBRAGE_INLINE float x(int i) const { return xs[i]; }
    [[nodiscard]] UMBRAGE_INLINE float y(int i) const { return ys[i]; }
    [[nodiscard]] UMBRAGE_INLINE float z(int i) const { return zs[i]; }
    UMBRAGE_INLINE void set(int i, float x_at, float y_at, float depth) {
        xs[i] = x_at;
        ys[i] = y_at;
        zs[i] = depth;
    }
    template <class Receivers>
    UMBRAGE_INLINE void copy(const Receivers& from) {
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) set(i, from.x(i), from.y(i), from.z(i));
    }
};

/// A walk over the blocks of some rows.
struct block_walk {
    int x, y, width;

    [[nodiscard]] UMBRAGE_INLINE int count() const { return width - x < block ? width - x : block; }
    UMBRAGE_INLINE void step() {
        x += block;
        if (x < width) return;
        x = 0;
        ++y;
    }
};

/// Hands a block of receivers on: whole ones where they are, others as a copy.
template <class Receivers, class Use>
UMBRAGE_INLINE inline void use_block(const Receivers& receivers, int count, const Use& use) {
    if (count == block) return use(receivers);
    receiver_block copy;
    for (int i = 0; i < count; ++i) copy.set(i, receivers.x(i), receivers.y(i), receivers.z(i));
    use(copy);
}
template <class Isa, class Use>
UMBRAGE_INLINE inline void use_receivers(const image_view<const glm::vec3>& from, const block_walk& at, Isa,
                                         const Use& use) {
    const receiver_texels receivers{from.row(at.y) + at.x};
    if (Isa::value != isa::base || at.count() != block) return use_block(receivers, at.count(), use);
    receiver_block copy;  // GCC takes vec3s apart for SSE only in a loop that does nothing else
    copy.copy(receivers);
    use(copy);
}
template <class Isa, class Use>
UMBRAGE_INLINE inline void use_receivers(const receiver_planes& from, const block_walk& at, Isa, const Use& use) {
    use_block(receiver_rows{from.x.row(at.y) + at.x, from.y.row(at.y) + at.x, from.depth.row(at.y) + at.x}, at.count(),
              use);
}

/// receiver_at for a block.
inline void load(const depth_receivers& seen, const block_walk& at, receiver_block& r) {
    copy_floats(r.zs, seen.depth.row(at.y) + at.x, at.count());
    on_best_isa_without_fma([&](auto) UMBRAGE_INLINE {
        const glm::mat4 m = seen.matrix;
        const float bias = seen.bias;
        const float y = static_cast<float>(at.y) + 0.5f;
        for (int i = 0; i < block; ++i) {
            const float x = static_cast<float>(at.x + i) + 0.5f, depth = r.zs[i];
            const auto sum = [&](glm::length_t k)
                                 UMBRAGE_INLINE { return m[3][k] + m[0][k] * x + m[1][k] * y + m[2][k] * depth; };
            const float w = sum(3);
            const auto bits = detail::bit_cast<std::int32_t>(w);
            const std::int32_t in_front = -(std::int32_t(bits > 0) & std::int32_t(bits <= 0x7F800000));
            r.xs[i] = select(in_front, sum(0) / w, 65536.0f);
            r.ys[i] = select(in_front, sum(1) / w, 65536.0f);
            r.zs[i] = masked(sum(2) / w, in_front) - bias;
        }
    });
}
template <class Isa, class Use>
UMBRAGE_INLINE inline void use_receivers(const depth_receivers& seen, const block_walk& at, Isa, const Use& use) {
    receiver_block r;
    load(seen, at, r);
    use(r);
}

/// Starts to fetch the receivers some blocks ahead. Hardware prefetching stops at the end of a page.
template <class T>
UMBRAGE_INLINE inline void prefetch(const image_view<const T>& from, const block_walk& at) {
    constexpr int bytes = block * static_cast<int>(sizeof(T)), blocks = 4;
    prefetch_bytes(from.row(at.y) + at.x, blocks * bytes, bytes);
}
UMBRAGE_INLINE inline void prefetch(const receiver_planes& from, const block_walk& at) {
    for (const auto* plane : {&from.x, &from.y, &from.depth}) prefetch(*plane, at);
}
UMBRAGE_INLINE inline void prefetch(const depth_receivers& from, const block_walk& at) { prefetch(from.depth, at); }

}  // namespace umbrage::detail

// ---- umbrage/simd/blocks/texels.hpp
// Maps as blocks of receivers see them: floats, and the two channels of rg with any number of bits. What else there is
// is decoded to floats first. A block's texels are loaded word by word, and compared in loops that vectorise.
//
//     umbrage::detail::loaded_texels<float_texels> texels(map);
//     texels.load_one([&](int i) { return memory.at(offsets[i]); });
//     lit += test::lit(texels.receiver(depth), texels.one(i));
//

namespace umbrage::detail {

/// The comparison of a direction, in numbers and masks.
template <depth_direction Direction>
struct block_test {
    static constexpr bool forward = Direction == depth_direction::forward;

    /// 1 when lit. A NaN is not.
    [[nodiscard]] static UMBRAGE_INLINE std::int32_t lit(float receiver, float stored) {
        return forward ? is_lit(receiver, stored) : is_lit(stored, receiver);
    }
    /// Of texels whose depths lie between bounds, the lower a NaN where one is: whether all are lit; whether none is.
    [[nodiscard]] static UMBRAGE_INLINE std::int32_t all_lit(float receiver, float least, float greatest) {
        return forward ? is_lit(receiver, least) : is_lit(greatest, receiver) & is_lit(least, greatest);
    }
    [[nodiscard]] static UMBRAGE_INLINE std::int32_t none_lit(float receiver, float least, float greatest) {
        return forward ? std::int32_t(receiver > greatest) : std::int32_t(receiver < least) & number_mask(least);
    }
    /// is_compared as a mask.
    [[nodiscard]] static UMBRAGE_INLINE std::int32_t compared(float x, float y, float z) {
        return texel_space_mask(x, y) & ~beyond_far_mask<forward>(z);
    }
};

/// A map of floats.
struct float_texels {
    using texel = float;
    image_view<const float> map;
};

/// A map of rg.
struct rg_texels {
    using texel = glm::u8vec2;
    image_view<const glm::u8vec2> map;
    int bits;
    float edge;
};

/// Where a block of words comes from, at(i), and where it goes.
template <class At>
struct gathered {
    void* to;
    At at;
};
template <class At>
gathered(void*, At) -> gathered<At>;

/// Blocks of words, in turns. As many as fill a small register make one store: left alone, compilers want more at once
/// than they can hold.
template <class Word, class... At>
UMBRAGE_INLINE inline void gather(const gathered<At>&... blocks) {
    const auto word = [](const void* from) UMBRAGE_INLINE {
        Word w;
        std::memcpy(&w, from, sizeof w);
        return w;
    };
    using words = lanes_of<Word, 16 / sizeof(Word)>;
    constexpr std::size_t some = sizeof(words) / sizeof(Word);
    const auto load = [&]<std::size_t... I>(int i, const auto& from, std::index_sequence<I...>) UMBRAGE_INLINE {
        const words together{word(from.at(i + static_cast<int>(I)))...};
        std::memcpy(static_cast<std::byte*>(from.to) + static_cast<std::size_t>(i) * sizeof(Word), &together,
                    sizeof together);
    };
    for (int i = 0; i < block; i += static_cast<int>(some)) (load(i, blocks, std::make_index_sequence<some>{}), ...);
}

/// What is loaded for a block of receivers, from where at(i) points to: a texel each, or two neighbours of two rows.
template <class Map>
struct loaded_texels;

/// Floats need no decoding, and two of them are one word.
template <>
struct loaded_texels<float_texels> {
    alignas(64) float depths[2 * block];
    explicit loaded_texels(const float_texels&) {}
    template <class At>
    UMBRAGE_INLINE void load_one(const At& at) {
        gather<std::uint32_t>(gathered{depths, at});
    }
    template <class At, class Below>
    static UMBRAGE_INLINE void load_two(loaded_texels& low, const At& at, loaded_texels& high, const Below& below) {
        gather<std::uint64_t>(gathered{low.depths, at}, gathered{high.depths, below});
    }
    UMBRAGE_INLINE float receiver(float depth) const { return depth; }
    UMBRAGE_INLINE float one(int i) const { return depths[i]; }
    UMBRAGE_INLINE float first(int i) const { return depths[2 * i]; }
    UMBRAGE_INLINE float second(int i) const { return depths[2 * i + 1]; }
};

/// Byte pairs, two of them to a word. Both sides of the comparison stay 2^bits times the depth, which changes no
/// result.
template <>
struct loaded_texels<rg_texels> {
    static constexpr bool little = std::endian::native == std::endian::little;
    static constexpr std::uint32_t low_bytes = 0x00FF00FF;
    alignas(64) std::uint32_t words[block];
    float edge, scale;
    int up;  ///< bits - 8: the code is R + 2^up G
    std::uint32_t high_bytes;

    explicit UMBRAGE_INLINE loaded_texels(const rg_texels& map)
        : edge(map.edge), scale(static_cast<float>(1 << map.bits)), up(map.bits - 8), high_bytes(low_bytes << up) {}
    template <class At>
    UMBRAGE_INLINE void load_one(const At& at) {
        for (int i = 0; i < block; ++i) {
            std::uint16_t word;
            std::memcpy(&word, at(i), sizeof word);
            words[i] = word;
        }
    }
    template <class At, class Below>
    static UMBRAGE_INLINE void load_two(loaded_texels& low, const At& at, loaded_texels& high, const Below& below) {
        gather<std::uint32_t>(gathered{low.words, at}, gathered{high.words, below});
    }
    UMBRAGE_INLINE float receiver(float depth) const { return depth * scale; }
    UMBRAGE_INLINE float one(int i) const { return number(codes(i) & 0xFFFF); }
    UMBRAGE_INLINE float first(int i) const { return number(little ? codes(i) & 0xFFFF : codes(i) >> 16); }
    UMBRAGE_INLINE float second(int i) const { return number(little ? codes(i) >> 16 : codes(i) & 0xFFFF); }
    /// R + 2^(bits - 8) G of both texels at once, in the two halves of a word.
    UMBRAGE_INLINE std::uint32_t codes(int i) const {
        const std::uint32_t w = words[i];
        return little ? (w & low_bytes) + (w >> (8 - up) & high_bytes) : (w >> 8 & low_bytes) + ((w & low_bytes) << up);
    }
    UMBRAGE_INLINE float number(std::uint32_t code) const {
        return static_cast<float>(static_cast<std::int32_t>(code)) + edge;
    }
};

/// Texels of a map by their distance from the first in bytes, which fits 32 bits so that it vectorises.
template <class T>
struct texel_bytes {
    const std::byte* data;
    std::int32_t stride;

    explicit texel_bytes(const image_view<T>& map)
        : data(reinterpret_cast<const std::byte*>(map.data)), stride(static_cast<std::int32_t>(map.stride)) {}
    static bool fits(const image_view<T>& map) {
        constexpr std::ptrdiff_t highest = 0x7FFFFFFF;
        return map.size.x <= highest / std::ptrdiff_t(sizeof(T)) && map.size.y <= highest / 2 &&
               (map.stride < 0 ? -map.stride : map.stride) <= highest / (map.size.y + 1);
    }
    UMBRAGE_INLINE std::int32_t offset(std::int32_t x, std::int32_t y) const {
        return y * stride + x * static_cast<std::int32_t>(sizeof(T));
    }
    UMBRAGE_INLINE T* at(std::int32_t offset) const { return reinterpret_cast<T*>(data + offset); }
    UMBRAGE_INLINE T* below(std::int32_t offset) const { return reinterpret_cast<T*>(data + stride + offset); }
};

/// Texel inside the map, without the assertion of image_view.
template <class T>
[[nodiscard]] UMBRAGE_INLINE inline T* texel_at(const image_view<T>& map, std::int32_t x, std::int32_t y) {
    return reinterpret_cast<T*>(reinterpret_cast<const std::byte*>(map.data) + y * map.stride) + x;
}

/// The last texel of a map that a receiver can ask for whose texels number less than `space`.
[[nodiscard]] UMBRAGE_INLINE inline int last_in_space(int size, int space) { return (size < space ? size : space) - 1; }

/// Starts to fetch the texels of a block, of which neighbours mostly share a cache line. Where a block starts on
/// another row of the map than the one before, the machine cannot guess them; and the rows above and below are where
/// receivers come to that lie askew to the map.
template <class T>
UMBRAGE_INLINE inline void prefetch(const texel_bytes<T>& memory, const std::int32_t* offsets, int rows) {
    for (int row = -1; row <= rows; ++row)
#pragma GCC unroll 4
        for (int i = 0; i < block; i += 16)
            prefetch_bytes(memory.data, offsets[i] + std::ptrdiff_t(row) * memory.stride, 1);
}

}  // namespace umbrage::detail

// ---- umbrage/simd/blocks/box.hpp
// The box filter over maps of floats: whole rows of the box are loaded at once, never one texel after the other.
//
//     const box_rows<depth_direction::forward, 8, 0> rows(map.stride, 5);
//     std::int32_t lit = rows.count(row, 0, receiver);
//

namespace umbrage::detail {

/// Lit texels of boxes that lie inside a map at least as wide as a register.
/// @tparam Lanes   of a register
/// @tparam Whole   registers that a row of the box fills
/// @tparam Width   of the box, 0 if not known here
template <depth_direction Direction, int Lanes, int Whole, int Width = 0>
struct box_rows {
    using ints = lanes_of<std::int32_t, Lanes>;
    static constexpr int reach = (Whole + 1) * Lanes;  ///< texels that are loaded of a row
    std::ptrdiff_t stride;
    int width;
    std::int32_t
        window[3 * std::size_t(Lanes)]{};  ///< lanes that the rest of a row has in a register, slid to where they are

    UMBRAGE_INLINE box_rows(std::ptrdiff_t bytes, int box_width) : stride(bytes), width(Width ? Width : box_width) {
        for (int i = 0; i < width - Whole * Lanes; ++i) window[Lanes + i] = -1;
    }

    /// @param row     first texel of the box
    /// @param moved   by how much the last register of a row is moved back, so that it ends inside the map
    [[nodiscard]] UMBRAGE_INLINE std::int32_t count(const std::byte* row, std::ptrdiff_t moved, float receiver) const {
        ints lit;
        std::int32_t sums[2];
        count_lanes(row, moved, receiver, lit);
        sum_two_lanes<Lanes>(lit, lit, sums);
        return sums[0];
    }

    /// Of two boxes, which costs less than of each alone.
    UMBRAGE_INLINE void count_two(const std::byte* const rows[2], const float* receivers, std::int32_t* counts) const {
        ints first, second;
        count_lanes(rows[0], 0, receivers[0], first);
        count_lanes(rows[1], 0, receivers[1], second);
        sum_two_lanes<Lanes>(first, second, counts);
    }

private:
    UMBRAGE_INLINE void count_lanes(const std::byte* row, std::ptrdiff_t moved, float receiver, ints& lit) const {
        lit = ints{};
        ints rest{};
        const auto add_row = [&]() UMBRAGE_INLINE {
            const float* texels = reinterpret_cast<const float*>(row);
            lanes_of<float, Lanes> stored;
            ints lanes;
            for (int i = 0; i < Whole; ++i) {
                load_lanes(texels + i * Lanes, stored);
                lit_lanes<Lanes, block_test<Direction>::forward>(receiver, stored, lanes);
                lit -= lanes;
            }
            load_lanes(texels + Whole * Lanes - moved, stored);
            lit_lanes<Lanes, block_test<Direction>::forward>(receiver, stored, lanes);
            rest -= lanes;
            row += stride;
        };
        if constexpr (Width > 0) {
#pragma GCC unroll 8
            for (int j = 0; j < Width; ++j) add_row();
        } else
            for (int j = 0; j < width; ++j) add_row();
        ints wanted;
        std::memcpy(&wanted, window + Lanes - moved, sizeof wanted);
        lit += rest & wanted;
    }
};

/// The part of a map that a block's boxes lie in. Rows of a map that lie a multiple of 2048 bytes apart share their
/// places in a first-level cache, which has few for each: high boxes push their own rows out of it. Here they do not.
struct map_tile {
    static constexpr int columns = 100, rows = 96;
    float texels[rows][columns];

    [[nodiscard]] static bool helps(std::ptrdiff_t stride, int width) { return width > 8 && stride % 2048 == 0; }

    /// @param last   texel of the map, within columns and rows of the first; at least eight columns
    UMBRAGE_INLINE void copy(const image_view<const float>& map, glm::ivec2 first, glm::ivec2 last) {
        const int count = last.x - first.x + 1;
        const auto eight = [](const float* from, float* to)
                               UMBRAGE_INLINE { std::memcpy(to, from, 8 * sizeof(float)); };
        for (int y = first.y; y <= last.y; ++y) {
            const float* from = texel_at(map, first.x, y);
            float* to = texels[y - first.y];
            for (int i = 0; i + 8 < count; i += 8) eight(from + i, to + i);
            eight(from + count - 8, to + count - 8);
        }
    }
};

/// A map of floats: others are decoded first, which costs less than decoding each texel for each of its boxes.
template <depth_direction Direction>
struct box_blocks {
    using test = block_test<Direction>;
    template <int Lanes, int Whole, int Width = 0>
    using rows = box_rows<Direction, Lanes, Whole, Width>;
    struct placed {
        alignas(64) std::int32_t x[block], y[block], offsets[block];  ///< first texel of the box
        alignas(64) std::int32_t inside[block], compared[block];
        alignas(64) float z[block];
        std::int32_t
            all_plain;  ///< all bits if all boxes and what is loaded beside them are inside, and no depth is NaN
    };
    image_view<const float> map;
    int radius;  ///< 0 .. max_box_radius

    /// Of the texels that a receiver there asks for, along an axis.
    [[nodiscard]] UMBRAGE_INLINE std::int32_t first(float coord) const { return floor_int(coord) - radius; }

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at) const {
        const texel_bytes memory(map);
        const int before = radius, width = 2 * radius + 1, last_x = map.size.x - width, last_y = map.size.y - width;
        const int last_load = last_x - 7;  // where registers of eight lanes still end inside
        std::int32_t plain = -1;
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            at.compared[i] = test::compared(receivers.x(i), receivers.y(i), receivers.z(i));
            const std::int32_t x = floor_int(masked(receivers.x(i), at.compared[i])) - before;
            const std::int32_t y = floor_int(masked(receivers.y(i), at.compared[i])) - before;
            at.inside[i] = ~((x | y | (last_x - x) | (last_y - y)) >> 31);
            at.offsets[i] = memory.offset(x & at.inside[i], y & at.inside[i]);
            at.x[i] = x;
            at.y[i] = y;
            at.z[i] = receivers.z(i);
            const std::int32_t magnitude = detail::bit_cast<std::int32_t>(receivers.z(i)) & 0x7FFFFFFF;
            const auto loads_inside = std::int32_t(x <= last_load), number = std::int32_t(magnitude <= 0x7F800000);
            plain &= at.inside[i] & at.compared[i] & -(loads_inside & number);
        }
        at.all_plain = plain;
        prefetch(memory, at.offsets, last_y < 0 ? 1 : width);
    }

    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int count, float* visibility, Isa set) const {
        out_of_line(set,
                    [&](auto) UMBRAGE_INLINE { count_all<Isa::value == isa::base ? 4 : 8>(at, count, visibility); });
    }

private:
    template <int Lanes>
    UMBRAGE_INLINE void count_all(const placed& at, int count, float* visibility) const {
        const int width = 2 * radius + 1;
        if constexpr (Lanes == 8) {
            if (width == 3) return count_with<rows<8, 0, 3>>(at, count, visibility);
            if (width == 5) return count_with<rows<8, 0, 5>>(at, count, visibility);
            if (width == 7) return count_with<rows<8, 0, 7>>(at, count, visibility);
        }
        if (width / Lanes == 0) return count_with<rows<Lanes, 0>>(at, count, visibility);
        if (width / Lanes == 1) return count_with<rows<Lanes, 1>>(at, count, visibility);
        if (width / Lanes == 2) return count_with<rows<Lanes, 2>>(at, count, visibility);
        if constexpr (Lanes == 4) {
            if (width / Lanes == 3) return count_with<rows<4, 3>>(at, count, visibility);
            count_with<rows<4, 4>>(at, count, visibility);
        }
    }

    template <class Boxes>
    UMBRAGE_INLINE void count_with(const placed& at, int count, float* visibility) const {
        const int width = 2 * radius + 1, last_load = map.size.x - Boxes::reach;
        const Boxes boxes(map.stride, width);
        const texel_bytes memory(map);
        alignas(64) std::int32_t lit[block]{};
        if (at.all_plain)  // as nearly always
            count_inside(boxes, at, count, lit);
        else
            for (int i = 0; i < count; ++i) {
                if (is_nan(at.z[i]) || !at.compared[i]) continue;
                const int moved = at.x[i] > last_load ? at.x[i] - last_load : 0;
                lit[i] = at.inside[i] && last_load >= 0 ? boxes.count(memory.data + at.offsets[i], moved, at.z[i])
                                                        : count_at_border<Boxes>({at.x[i], at.y[i]}, width, at.z[i]);
            }
        const float scale = box_scale<float>(radius);
        for (int i = 0; i < block; ++i)
            visibility[i] = select(-std::int32_t(lit[i] == width * width) | ~at.compared[i], 1.0f,
                                   static_cast<float>(lit[i]) * scale);
    }

    /// All 64 boxes lie inside the map, with what is loaded beside them.
    template <class Boxes>
    UMBRAGE_INLINE void count_inside(const Boxes& boxes, const placed& at, int count, std::int32_t* lit) const {
        const auto count_all = [&](const Boxes& of, const auto& row) UMBRAGE_INLINE {
            for (int i = 0; i < count; i += 2) {  // a block is even
                const std::byte* const starts[]{row(i), row(i + 1)};
                of.count_two(starts, at.z + i, lit + i);
            }
        };
        if (map_tile::helps(map.stride, 2 * radius + 1)) {
            glm::ivec2 first(at.x[0], at.y[0]), last = first;
            for (int i = 0; i < block; ++i) {
                first.x = at.x[i] < first.x ? at.x[i] : first.x;
                first.y = at.y[i] < first.y ? at.y[i] : first.y;
                last.x = at.x[i] > last.x ? at.x[i] : last.x;
                last.y = at.y[i] > last.y ? at.y[i] : last.y;
            }
            last += glm::ivec2(Boxes::reach - 1, 2 * radius);
            if (last.x - first.x < map_tile::columns && last.y - first.y < map_tile::rows) {
                map_tile tile;
                tile.copy(map, first, last);
                return count_all(Boxes(sizeof tile.texels[0], 2 * radius + 1), [&](int i) UMBRAGE_INLINE {
                    return reinterpret_cast<const std::byte*>(&tile.texels[at.y[i] - first.y][at.x[i] - first.x]);
                });
            }
        }
        const texel_bytes memory(map);
        count_all(boxes, [&](int i) UMBRAGE_INLINE { return memory.data + at.offsets[i]; });
    }

    /// The same from a copy of the box, the map's border texels repeated.
    template <class Boxes>
    std::int32_t count_at_border(glm::ivec2 first, int width, float receiver) const {
        constexpr int widest = 2 * max_box_radius + 1;
        float texels[widest][Boxes::reach > widest ? Boxes::reach : widest]{};
        for (int j = 0; j < width; ++j) {
            const float* row = texel_at(map, 0, clamp_int(first.y + j, map.size.y - 1));
            for (int i = 0; i < width; ++i) texels[j][i] = row[clamp_int(first.x + i, map.size.x - 1)];
        }
        return Boxes(sizeof texels[0], width).count(reinterpret_cast<const std::byte*>(texels), 0, receiver);
    }
};

template <>
struct block_form<filters::box> {
    static constexpr map_need need = map_need::floats;
    static constexpr int least = 1;
    template <depth_direction Direction, class ParallelFor, class Use>
    static void with_blocks(const float_texels& map, const filters::box& filter, ParallelFor&&, const Use& use) {
        use(box_blocks<Direction>{map.map, clamp_int(filter.radius, max_box_radius)});
    }
};

}  // namespace umbrage::detail

// ---- umbrage/simd/blocks/disc.hpp
// Discs over blocks of receivers: the turned points of a row of pixels are looked up, not turned again. All texels near
// a receiver are compared at once, a row of them in a register, where that is less work than point after point.

namespace umbrage::detail {

/// Taps of a disc in 1/256 texel from the receiver, for each row of 4 x 4 pixels' turns and each pixel of a block.
struct disc_table {
    struct tap {
        alignas(64) std::int32_t x[block], y[block];
        alignas(64) std::uint32_t packed[block];
    };
    std::vector<std::array<tap, 32>> of;
    int farthest = 0;  ///< along an axis

    /// Both in one word, sums of them from 0 to 2047: x is at the top, where what it borrows and carries is lost.
    static UMBRAGE_INLINE std::uint32_t pack(std::int32_t x, std::int32_t y) {
        return (static_cast<std::uint32_t>(x) << 21) + static_cast<std::uint32_t>(y);
    }

    disc_table(const disc_point* points, int count, float radius) : of(16) {
        const auto rho = static_cast<int>(disc_radius(radius));
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 4; ++x) {
                const glm::ivec2 turn(disc_turn(glm::vec2(static_cast<float>(x), static_cast<float>(y))));
                for (int p = 0; p < count; ++p) {
                    const disc_point point = points[p];
                    tap& taps = of[static_cast<std::size_t>(y)][static_cast<std::size_t>(p)];
                    const int right = (turn.x * point.x - turn.y * point.y) * rho >> 6;
                    const int up = (turn.y * point.x + turn.x * point.y) * rho >> 6;
                    for (const int way : {right, -right, up, -up}) farthest = way > farthest ? way : farthest;
                    for (int i = x; i < block; i += 4) {
                        taps.x[i] = right;
                        taps.y[i] = up;
                        taps.packed[i] = pack(right, up);
                    }
                }
            }
    }
};

template <depth_direction Direction>
struct disc_blocks {
    using test = block_test<Direction>;
    struct placed {
        alignas(64) std::int32_t x[block], y[block], compared[block];  ///< in 1/256 texel
        alignas(64) float z[block];
        int row;  ///< of the table
    };
    image_view<const float> map;
    const disc_table& taps;
    int points, rows;  ///< of the map, before and behind a receiver's

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at, int pixel_y) const {
        const texel_bytes memory(map);
        const int last_x = map.size.x - 1, last_y = map.size.y - 1 - rows;
        alignas(64) std::int32_t offsets[block];
        locate(receivers, at, pixel_y);
        for (int i = 0; i < block; ++i)
            offsets[i] = memory.offset(clamp_int(at.x[i] >> 8, last_x), clamp_int((at.y[i] >> 8) - rows, last_y));
        prefetch(memory, offsets, 2 * rows);
    }
    template <class Receivers>
    UMBRAGE_INLINE void locate(const Receivers& receivers, placed& at, int pixel_y) const {
        at.row = pixel_y & 15;
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            at.compared[i] = test::compared(receivers.x(i), receivers.y(i), receivers.z(i));
            at.x[i] = floor_int(masked(receivers.x(i), at.compared[i]) * 256.0f);
            at.y[i] = floor_int(masked(receivers.y(i), at.compared[i]) * 256.0f);
            at.z[i] = receivers.z(i);
        }
    }

    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int, float* visibility, Isa set) const {
        if constexpr (Isa::value != isa::base) {
            near_texels texels;
            if (points >= 2 * near_rows && find_near(at, texels))
                return out_of_line(set, [&](auto) UMBRAGE_INLINE {
                    count_near<Isa::value == isa::avx512 ? 16 : 8>(at, texels, visibility);
                });
        }
        out_of_line(set, [&](auto) UMBRAGE_INLINE { count_all(at, visibility); });
    }

private:
    static constexpr int near_before = 3, near_rows = 7, near_columns = 8;
    struct near_texels {
        alignas(64) std::int32_t offsets[block];                           ///< of the first
        alignas(64) std::uint32_t from[block];                             ///< there to the receiver, packed
        alignas(64) std::uint32_t upper[block], lower[block], lit[block];  ///< bits of four rows each
    };

    /// @return   whether all points fall on them, and all of them lie in the map
    UMBRAGE_INLINE bool find_near(const placed& at, near_texels& texels) const {
        const texel_bytes memory(map);
        const int last_x = map.size.x - near_columns, last_y = map.size.y - near_rows;
        if (last_x < 0 || last_y < 0 || taps.farthest > near_before * 256) return false;
        std::int32_t all = -1;
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            const std::int32_t x = (at.x[i] >> 8) - near_before, y = (at.y[i] >> 8) - near_before;
            const std::int32_t inside = ~((x | y | (last_x - x) | (last_y - y)) >> 31);
            texels.offsets[i] = memory.offset(x & inside, y & inside);
            texels.from[i] = disc_table::pack((at.x[i] & 255) + near_before * 256, (at.y[i] & 255) + near_before * 256);
            all &= inside | ~at.compared[i];
        }
        return all != 0;
    }

    template <int Lanes>
    UMBRAGE_INLINE void count_near(const placed& at, near_texels& texels, float* visibility) const {
        for (int i = 0; i < block; ++i) compare_near(at.z[i], texels.offsets[i], texels.upper[i], texels.lower[i]);
        const auto& row = taps.of[static_cast<std::size_t>(at.row)];
        for (int i = 0; i < block; i += Lanes) {
            lanes_of<std::uint32_t, Lanes> from, upper, lower, tap, lit{};
            load_lanes(texels.from + i, from);
            load_lanes(texels.upper + i, upper);
            load_lanes(texels.lower + i, lower);
            // Bit 4 y + x of columns 0 to 3, and of 4 to 7: there are seven rows, none is lost.
            const auto left = (upper & 0xFFFF) | lower << 16;
            const auto right = (upper >> 16 | (lower & 0xFFFF0000)) << 4;
            for (int p = 0; p < points; ++p) {
                load_lanes(row[static_cast<std::size_t>(p)].packed + i, tap);
                tap += from;
                const auto on_right = reinterpret_cast<lanes_of<std::int32_t, Lanes>>(tap) < 0;
                lit += (on_right ? right : left) >> ((tap >> 6 & 28) + (tap >> 29)) & 1;
            }
            store_lanes(lit, texels.lit + i);
        }
        take_share(at, texels.lit, visibility);
    }

    /// Which texels are lit, as mask_bits of rows 0 to 3 and of 4 to 6.
    UMBRAGE_INLINE void compare_near(float receiver, std::int32_t offset, std::uint32_t& upper,
                                     std::uint32_t& lower) const {
        const texel_bytes memory(map);
        const std::byte* from = memory.data + offset;
        lanes_of<std::int32_t, near_columns> lit[8]{};
        lanes_of<float, near_columns> texels;
#pragma GCC unroll 7
        for (int y = 0; y < near_rows; ++y, from += memory.stride) {
            load_lanes(from, texels);
            lit_lanes<near_columns, test::forward>(receiver, texels, lit[y]);
        }
        upper = mask_bits(lit);
        lower = mask_bits(lit + 4);
    }

    UMBRAGE_INLINE void count_all(const placed& at, float* visibility) const {
        const float_texels of_map{map};
        const texel_bytes memory(map);
        const int last_x = map.size.x - 1, last_y = map.size.y - 1;
        loaded_texels<float_texels> texels(of_map);
        alignas(64) std::int32_t offsets[block];
        alignas(64) std::uint32_t lit[block]{};
        for (int p = 0; p < points; ++p) {
            const disc_table::tap& tap = taps.of[static_cast<std::size_t>(at.row)][static_cast<std::size_t>(p)];
            for (int i = 0; i < block; ++i)
                offsets[i] = memory.offset(clamp_int((at.x[i] + tap.x[i]) >> 8, last_x),
                                           clamp_int((at.y[i] + tap.y[i]) >> 8, last_y));
            texels.load_one([&](int i) UMBRAGE_INLINE { return memory.at(offsets[i]); });
            for (int i = 0; i < block; ++i) lit[i] += static_cast<std::uint32_t>(test::lit(at.z[i], texels.one(i)));
        }
        take_share(at, lit, visibility);
    }

    UMBRAGE_INLINE void take_share(const placed& at, const std::uint32_t* lit, float* visibility) const {
        const float share = points == 8 ? 1.0f / 8.0f : (points == 16 ? 1.0f / 16.0f : 1.0f / 32.0f);
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            const std::int32_t count = static_cast<std::int32_t>(lit[i]) & number_mask(at.z[i]);
            visibility[i] = select(at.compared[i], static_cast<float>(count) * share, 1.0f);
        }
    }
};

template <>
struct block_form<filters::rotated_disc> {
    static constexpr map_need need = map_need::floats;
    static constexpr int least = 1;
    template <depth_direction Direction, class ParallelFor, class Use>
    static void with_blocks(const float_texels& map, const filters::rotated_disc& filter, ParallelFor&&,
                            const Use& use) {
        const disc_point* points = filter.points == 8    ? disc_points<8>.data()
                                   : filter.points == 16 ? disc_points<16>.data()
                                                         : disc_points<32>.data();
        const disc_table taps(points, filter.points, filter.radius_texels);
        use(disc_blocks<Direction>{map.map, taps, filter.points, static_cast<int>(filter.reach())});
    }
};

}  // namespace umbrage::detail

// ---- umbrage/simd/blocks/hard.hpp
// The unfiltered test over blocks of receivers, and the tap that it shares with other filters.

namespace umbrage::detail {

/// Taps that are receivers' own texels, clamped to the map.
struct placed_tap {
    alignas(64) std::int32_t offsets[block];

    /// @param space   texels that a receiver can ask for, in each direction
    template <class T>
    UMBRAGE_INLINE void place(const image_view<T>& map, const receiver_block& receivers, glm::vec2 offset, int space) {
        const texel_bytes memory(map);
        const auto last_x = static_cast<float>(last_in_space(map.size.x, space)),
                   last_y = static_cast<float>(last_in_space(map.size.y, space));
        for (int i = 0; i < block; ++i)
            offsets[i] = memory.offset(floor_within(receivers.x(i) + offset.x, last_x),
                                       floor_within(receivers.y(i) + offset.y, last_y));
        prefetch(memory, offsets, 1);
    }

    /// Adds 1 for each receiver that is lit.
    template <class Test, class Map>
    UMBRAGE_INLINE void count(const Map& map, const float* z, std::int32_t* lit) const {
        const texel_bytes memory(map.map);
        loaded_texels<Map> texels(map);
        texels.load_one([&](int i) UMBRAGE_INLINE { return memory.at(offsets[i]); });
        for (int i = 0; i < block; ++i) lit[i] += Test::lit(texels.receiver(z[i]), texels.one(i));
    }
};

template <depth_direction Direction, class Map>
struct hard_blocks {
    using test = block_test<Direction>;
    struct placed {
        receiver_block r;
        placed_tap tap;
        alignas(64) std::int32_t compared[block];
    };
    Map map;

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at) const {
        at.r.copy(receivers);
        at.tap.place(map.map, at.r, glm::vec2(0.0f), 1 << 15);
        for (int i = 0; i < block; ++i) at.compared[i] = test::compared(at.r.x(i), at.r.y(i), at.r.z(i));
    }
    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int, float* visibility, Isa) const {
        alignas(64) std::int32_t lit[block]{};
        at.tap.template count<test>(map, at.r.zs, lit);
        for (int i = 0; i < block; ++i)
            visibility[i] = static_cast<float>((lit[i] & at.compared[i]) | (1 & ~at.compared[i]));
    }
};

template <>
struct block_form<filters::hard> {
    static constexpr map_need need = map_need::texels;
    static constexpr int least = 1;
    template <depth_direction Direction, class Map, class ParallelFor, class Use>
    static void with_blocks(const Map& map, const filters::hard&, ParallelFor&&, const Use& use) {
        use(hard_blocks<Direction, Map>{map});
    }
};

}  // namespace umbrage::detail

// ---- umbrage/simd/blocks/four_tap.hpp
// Four taps over blocks of receivers.

namespace umbrage::detail {

template <depth_direction Direction, class Map>
struct four_tap_blocks {
    using test = block_test<Direction>;
    struct placed {
        receiver_block r;
        placed_tap taps[4];
        alignas(64) std::int32_t compared[block];
    };
    static constexpr int space = 1 << 17;  // of the four taps' sum
    Map map;
    std::array<glm::vec2, 4> offsets;

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at) const {
        at.r.copy(receivers);
        for (std::size_t tap = 0; tap < 4; ++tap) at.taps[tap].place(map.map, at.r, offsets[tap], space);
        for (int i = 0; i < block; ++i) {
            std::int32_t x = 0, y = 0;
            for (const glm::vec2& offset : offsets) {
                x += floor_magnitude(at.r.x(i) + offset.x, float(space));
                y += floor_magnitude(at.r.y(i) + offset.y, float(space));
            }
            at.compared[i] = x < space && y < space ? ~beyond_far_mask<test::forward>(at.r.z(i)) : 0;
        }
    }
    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int, float* visibility, Isa) const {
        alignas(64) std::int32_t lit[block]{};
        for (const placed_tap& tap : at.taps) tap.template count<test>(map, at.r.zs, lit);
        for (int i = 0; i < block; ++i)
            visibility[i] = static_cast<float>((lit[i] & at.compared[i]) | (4 & ~at.compared[i])) * 0.25f;
    }
};

template <>
struct block_form<filters::four_tap> {
    static constexpr map_need need = map_need::texels;
    static constexpr int least = 1;
    template <depth_direction Direction, class Map, class ParallelFor, class Use>
    static void with_blocks(const Map& map, const filters::four_tap& filter, ParallelFor&&, const Use& use) {
        use(four_tap_blocks<Direction, Map>{map, filter.offsets});
    }
};

}  // namespace umbrage::detail

// ---- umbrage/images/parallel.hpp
// How image functions use threads: they have none, and ask the caller's scheduler.
//
//     auto parallel_for = [&](int count, auto&& piece) {
//         tbb::parallel_for(tbb::blocked_range<int>(0, count),
//                           [&](const auto& range) { piece(range.begin(), range.end()); });
//     };
//     umbrage::encode(depth.view(), packed.view(), umbrage::rg<11>{}, parallel_for);
//
// parallel_for(count, piece) calls piece(first, last) so that the pieces cover 0 .. count once, in any order, on any
// threads, and returns when all are done. Pieces are bands of rows; no way to cut them changes a bit.

namespace umbrage {

/// The default: everything in one piece, on the caller's thread.
struct serial {
    template <class Piece>
    void operator()(int count, Piece&& piece) const {
        if (count > 0) piece(0, count);
    }
};

}  // namespace umbrage

// ---- umbrage/simd/blocks/box_bounds.hpp
// Least and greatest depth under boxes of texels, one number each for every place of a box.

namespace umbrage::detail {

/// For every place where a box may start, the bounds of the squares of texels that the box touches: at most `cells`
/// squares of 2^level texels in a row.
struct box_bounds {
    int level, cells;
    glm::ivec2 last;          ///< of the starts, which begin cells - 1 squares in front of the map
    image<glm::vec2> bounds;  ///< least and greatest; rows are filled up to whole blocks

    /// @param width   of the box
    template <class ParallelFor>
    box_bounds(image_view<const float> map, int width, ParallelFor&& parallel)
        : level(width < 9 ? 1 : 2), cells(((1 << level) + width - 2) / (1 << level) + 1) {
        const glm::ivec2 squares = (map.size + ((1 << level) - 1)) >> level;
        last = squares + (cells - 2);
        bounds = image<glm::vec2>({(last.x + block) / block * block, last.y + 1});
        image<std::int32_t> least({bounds.size().x, squares.y}), greatest(least.size());
        parallel(squares.y, [&](int from, int to) {
            const int blocks = (squares.x + block - 1) / block;
            const auto columns = static_cast<std::size_t>(blocks * block) << level;
            std::vector<std::int32_t> low(columns), high(columns),
                padded(static_cast<std::size_t>(bounds.size().x + cells));
            on_best_isa([&](auto) UMBRAGE_INLINE {
                for (int y = from; y < to; ++y) {
                    bounds_of_columns(map, y << level, low, high);
                    along_row(low, squares.x, padded, least_of{}, least.view().row(y));
                    along_row(high, squares.x, padded, greatest_of{}, greatest.view().row(y));
                }
            });
        });
        parallel(bounds.size().y, [&](int from, int to) {
            const auto row = [&](const image<std::int32_t>& of, int y) {
                return of.view().row(clamp_int(y - (cells - 1), squares.y - 1));
            };
            on_best_isa([&](auto) UMBRAGE_INLINE {
                for (int y = from; y < to; ++y)
                    for (int x = 0; x < bounds.size().x; x += block) {
                        alignas(64) std::int32_t lows[block], highs[block];
                        widen(least_of{}, lows, [&](int k) UMBRAGE_INLINE { return row(least, y + k) + x; });
                        widen(greatest_of{}, highs, [&](int k) UMBRAGE_INLINE { return row(greatest, y + k) + x; });
                        glm::vec2* out = bounds.view().row(y) + x;
                        for (int i = 0; i < block; ++i) out[i] = {from_order_key(lows[i]), from_order_key(highs[i])};
                    }
            });
        });
    }

private:
    /// Over 2^level rows; the last row and column are repeated.
    UMBRAGE_INLINE void bounds_of_columns(const image_view<const float>& map, int y, std::vector<std::int32_t>& low,
                                          std::vector<std::int32_t>& high) const {
        for (int x = 0; x < static_cast<int>(low.size()); x += block) {
            alignas(64) std::int32_t lows[block], highs[block], keys[block];
            for (int k = 0; k < 1 << level; ++k) {
                const float* depths = map.row(clamp_int(y + k, map.size.y - 1)) + x;
                alignas(64) float repeated[block];
                if (x + block > map.size.x) {
                    for (int i = 0; i < block; ++i) repeated[i] = depths[clamp_int(x + i, map.size.x - 1) - x];
                    depths = repeated;
                }
                for (int i = 0; i < block; ++i) {
                    keys[i] = order_key(depths[i]);
                    lows[i] = k ? least_of{}(lows[i], keys[i]) : keys[i];
                    highs[i] = k ? greatest_of{}(highs[i], keys[i]) : keys[i];
                }
            }
            std::memcpy(&low[std::size_t(x)], lows, sizeof lows);
            std::memcpy(&high[std::size_t(x)], highs, sizeof highs);
        }
    }

    /// to[x] = pick over the `cells` squares from x - (cells - 1) on, those at the border repeated.
    template <class Pick>
    UMBRAGE_INLINE void along_row(std::vector<std::int32_t>& columns, int squares, std::vector<std::int32_t>& padded,
                                  Pick pick, std::int32_t* to) const {
        auto count = static_cast<int>(columns.size());
        for (int halving = 0; halving < level; ++halving) {
            count /= 2;
            for (int x = 0; x < count; x += block) {
                alignas(64) std::int32_t halves[block];
                const std::int32_t* pairs = &columns[std::size_t(2 * x)];
                for (int i = 0; i < block; ++i) halves[i] = pick(pairs[2 * i], pairs[2 * i + 1]);
                std::memcpy(&columns[std::size_t(x)], halves, sizeof halves);
            }
        }
        const auto before = padded.begin() + (cells - 1);
        std::fill(padded.begin(), before, columns.front());
        std::copy_n(columns.begin(), squares, before);
        std::fill(before + squares, padded.end(), columns[std::size_t(squares - 1)]);
        for (int x = 0; x < bounds.size().x; x += block)
            widen(pick, to + x, [&](int k) UMBRAGE_INLINE { return padded.data() + k + x; });
    }

    /// to[i] = pick of from(k)[i] over k < cells, for a block.
    template <class Pick, class From>
    UMBRAGE_INLINE void widen(Pick pick, std::int32_t* to, const From& from) const {
        alignas(64) std::int32_t best[block];
        std::memcpy(best, from(0), sizeof best);
        for (int k = 1; k < cells; ++k) {
            const std::int32_t* other = from(k);
            for (int i = 0; i < block; ++i) best[i] = pick(best[i], other[i]);
        }
        std::memcpy(to, best, sizeof best);
    }
};

/// Of filters that are known by their reach alone: texels whose centres lie so far from a receiver, an axis, and how
/// many they can be.
struct reached_texels {
    int reach;  ///< in 1/256 texel
    explicit reached_texels(float texels) : reach(-floor_int(-texels * 256.0f)) {}

    [[nodiscard]] int count() const { return (2 * reach + 1) / 256 + 1; }
    /// What is added to floor(256 coord), so that a 256th of it is the first of them.
    [[nodiscard]] int before() const { return 127 - reach; }
};

}  // namespace umbrage::detail

// ---- umbrage/simd/blocks/window.hpp
// Sliding windows over blocks of receivers, for any row of weights: a register holds a row of the window's texels, each
// row adds its weight to the lanes that are lit, and the columns' weights are taken last.

namespace umbrage::detail {

/// window_weights for all that a window can have moved; 0 beside it.
struct window_table {
    alignas(64) float of[256][16]{};

    explicit window_table(const window_row& row) {
        for (int moved = 0; moved < 256; ++moved) window_weights(row, moved, of[moved]);
    }
};

template <depth_direction Direction>
struct window_blocks {
    using test = block_test<Direction>;
    struct placed {
        alignas(64) std::int32_t x[block], y[block], offsets[block];  ///< first texel of the window
        alignas(64) std::int32_t moved_x[block], moved_y[block], inside[block], compared[block];
        alignas(64) float z[block];
        std::int32_t all_inside;  ///< all bits if registers can be loaded for every window
    };
    image_view<const float> map;
    const window_row& row;
    const window_table& weights;

    [[nodiscard]] UMBRAGE_INLINE int loaded() const {  ///< of a row of texels
        return row.touched() > 8 ? 16 : (row.touched() > 4 ? 8 : 4);
    }

    /// Of the texels that a receiver there asks for, along an axis.
    [[nodiscard]] UMBRAGE_INLINE std::int32_t first(float coord) const {
        return ((floor_int(coord * 256.0f) - (row.size % 2 ? 128 : 0)) >> 8) - row.size / 2;
    }

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at) const {
        const texel_bytes memory(map);
        const int before = row.size / 2, half = row.size % 2 ? 128 : 0;
        const int last_x = map.size.x - loaded(), last_y = map.size.y - row.touched();
        std::int32_t all = -1;
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            at.compared[i] = test::compared(receivers.x(i), receivers.y(i), receivers.z(i));
            const std::int32_t right = floor_int(masked(receivers.x(i), at.compared[i]) * 256.0f) - half;
            const std::int32_t up = floor_int(masked(receivers.y(i), at.compared[i]) * 256.0f) - half;
            const std::int32_t x = (right >> 8) - before, y = (up >> 8) - before;
            at.moved_x[i] = right & 255;
            at.moved_y[i] = up & 255;
            at.inside[i] = ~((x | y | (last_x - x) | (last_y - y)) >> 31);
            at.offsets[i] = memory.offset(x & at.inside[i], y & at.inside[i]);
            at.x[i] = x;
            at.y[i] = y;
            at.z[i] = receivers.z(i);
            all &= at.inside[i];
        }
        at.all_inside = all;
        prefetch(memory, at.offsets, last_y < 0 ? 1 : row.touched());
    }

    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int count, float* visibility, Isa set) const {
        out_of_line(set,
                    [&](auto) UMBRAGE_INLINE { weigh_all<Isa::value == isa::base ? 4 : 8>(at, count, visibility); });
    }

private:
    template <int Lanes>
    UMBRAGE_INLINE void weigh_all(const placed& at, int count, float* visibility) const {
        alignas(64) float sums[block]{};
        if (map.size.x >= loaded() && map.size.y >= row.touched()) {
            if (Lanes == 8 && row.touched() == 4) weigh_inside<4, 1, 4>(at, count, sums);
            else if (row.touched() <= 4) weigh_inside<4, 1>(at, count, sums);
            else if (row.touched() <= 8) weigh_inside<Lanes, 8 / Lanes>(at, count, sums);
            else weigh_inside<Lanes, 16 / Lanes>(at, count, sums);
        }
        if (!at.all_inside)
            for (int i = 0; i < count; ++i)
                if (at.compared[i] & ~at.inside[i]) sums[i] = weigh_at_border(at, i);
        const float whole = row.whole * row.whole, scale = row.scale;
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            const float sum = masked(sums[i], number_mask(at.z[i]));
            visibility[i] = select(~at.compared[i] | -std::int32_t(sum == whole), 1.0f, sum * scale);
        }
    }

    /// Four rows of four texels, two in a register.
    UMBRAGE_INLINE void weigh_four_rows(const std::byte* texels, std::ptrdiff_t stride, float receiver,
                                        const float* rows, const float* columns, lanes_of<float, 4>& sum) const {
        lanes_of<float, 4> upper, lower, weights_of_rows;
        lanes_of<float, 8> two_rows, first, second;
        lanes_of<std::int32_t, 8> mask;
        const auto keep_lit = [&](const std::byte* from, lanes_of<float, 8>& weight) UMBRAGE_INLINE {
            load_lanes(from, upper);
            load_lanes(from + stride, lower);
            shuffle<0, 1, 2, 3, 4, 5, 6, 7>(upper, lower, two_rows);
            lit_lanes<8, test::forward>(receiver, two_rows, mask);
            keep_where<8>(mask, weight);
        };
        load_lanes(rows, weights_of_rows);
        shuffle<0, 0, 0, 0, 1, 1, 1, 1>(weights_of_rows, weights_of_rows, first);
        shuffle<2, 2, 2, 2, 3, 3, 3, 3>(weights_of_rows, weights_of_rows, second);
        keep_lit(texels, first);
        keep_lit(texels + 2 * stride, second);
        first += second;
        shuffle<0, 1, 2, 3>(first, first, upper);
        shuffle<4, 5, 6, 7>(first, first, lower);
        load_lanes(columns, sum);
        sum = (upper + lower) * sum;
    }

    /// All of them: those that are not inside weigh the map's first texels.
    template <int Lanes, int Registers, int Rows = 0>
    UMBRAGE_INLINE void weigh_inside(const placed& at, int count, float* sums) const {
        const texel_bytes memory(map);
        const int touched = row.touched();
        const auto weigh = [&](int i, lanes_of<float, 4>& sum) UMBRAGE_INLINE {
            const float *rows = weights.of[at.moved_y[i]], *columns = weights.of[at.moved_x[i]];
            if constexpr (Rows == 4)
                return weigh_four_rows(memory.data + at.offsets[i], memory.stride, at.z[i], rows, columns, sum);
            sum = lanes_of<float, 4>{};
#pragma GCC unroll 4
            for (int r = 0; r < Registers; ++r) {
                const std::byte* from = memory.data + at.offsets[i] + std::size_t(r) * Lanes * sizeof(float);
                lanes_of<float, Lanes> lit{}, texels;
                lanes_of<std::int32_t, Lanes> mask;
                for (int j = 0; j < touched; ++j) {
                    load_lanes(from, texels);
                    lit_lanes<Lanes, test::forward>(at.z[i], texels, mask);
                    add_where<Lanes>(mask, rows[j], lit);
                    from += memory.stride;
                }
                load_lanes(columns + r * Lanes, texels);
                add_products<Lanes>(lit, texels, sum);
            }
        };
        for (int i = 0; i < count; i += 4) {  // a block is a multiple of four
            lanes_of<float, 4> a, b, c, d, four;
            weigh(i, a);
            weigh(i + 1, b);
            weigh(i + 2, c);
            weigh(i + 3, d);
            sum_four_lanes(a, b, c, d, four);
            store_lanes(four, sums + i);
        }
    }

    [[nodiscard]] float weigh_at_border(const placed& at, int i) const {
        const float *columns = weights.of[at.moved_x[i]], *rows = weights.of[at.moved_y[i]];
        float sum = 0.0f;
        for (int j = 0; j < row.touched(); ++j) {
            const float* texels = texel_at(map, 0, clamp_int(at.y[i] + j, map.size.y - 1));
            for (int k = 0; k < row.touched(); ++k)
                if (test::lit(at.z[i], texels[clamp_int(at.x[i] + k, map.size.x - 1)])) sum += rows[j] * columns[k];
        }
        return sum;
    }
};

template <>
struct block_form<filters::window> {
    static constexpr map_need need = map_need::floats;
    static constexpr int least = 1;
    template <depth_direction Direction, class ParallelFor, class Use>
    static void with_blocks(const float_texels& map, const filters::window& filter, ParallelFor&&, const Use& use) {
        const window_table weights(filter.row);
        use(window_blocks<Direction>{map.map, filter.row, weights});
    }
};

}  // namespace umbrage::detail

// ---- umbrage/simd/blocks/hierarchical.hpp
// Filters over many texels for receivers most of which are wholly lit or wholly in shadow: those ask one number for all
// of them. visibility() does it for filters::hierarchical_box, hierarchical_window and hierarchical_disc, which give
// bit for bit what filters::box, window and rotated_disc do.
//
//     umbrage::visibility(map, umbrage::depth32f{}, receivers, umbrage::filters::hierarchical_box{8}, out);
//

namespace umbrage::detail {

/// What bounds say of a block: lit or dark, and which receivers are open, as their texels differ.
/// @return   whether any is open: not 0
template <class Test>
UMBRAGE_INLINE inline std::int32_t ask_bounds(const box_bounds& tree, const std::int32_t* offsets,
                                              const std::int32_t* compared, const float* depths, float* visibility,
                                              std::int32_t* open) {
    const texel_bytes memory(tree.bounds.view());
    alignas(64) glm::vec2 bounds[block];
    std::int32_t any = 0;
    gather<std::uint64_t>(gathered{bounds, [&](int i) UMBRAGE_INLINE { return memory.at(offsets[i]); }});
    for (int i = 0; i < block; ++i) {
        const std::int32_t lit = Test::all_lit(depths[i], bounds[i].x, bounds[i].y);
        const std::int32_t dark = Test::none_lit(depths[i], bounds[i].x, bounds[i].y);
        visibility[i] = select(-lit | ~compared[i], 1.0f, 0.0f);
        open[i] = compared[i] & ~-(lit | dark);
        any |= open[i];
    }
    return any;
}

/// @tparam Blocks   of the filter that reads every texel of its box
template <class Blocks>
struct hierarchical_blocks {
    using test = typename Blocks::test;
    struct placed {
        receiver_block r;
        alignas(64) std::int32_t offsets[block], compared[block];
    };
    const box_bounds& tree;
    Blocks every_texel;

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at) const {
        const texel_bytes memory(tree.bounds.view());
        const int before = tree.cells - 1, level = tree.level;
        const glm::ivec2 last = tree.last;
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            const std::int32_t compared = test::compared(receivers.x(i), receivers.y(i), receivers.z(i));
            const std::int32_t x = every_texel.first(masked(receivers.x(i), compared));
            const std::int32_t y = every_texel.first(masked(receivers.y(i), compared));
            at.r.set(i, receivers.x(i), receivers.y(i), receivers.z(i));
            at.offsets[i] =
                memory.offset(clamp_int((x >> level) + before, last.x), clamp_int((y >> level) + before, last.y));
            at.compared[i] = compared;
        }
        prefetch(memory, at.offsets, 1);
    }

    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int count, float* visibility, Isa set) const {
        alignas(64) std::int32_t open[block];
        if (ask_bounds<test>(tree, at.offsets, at.compared, at.r.zs, visibility, open))
            out_of_line(set, [&](auto) UMBRAGE_INLINE { count_open(at.r, open, count, visibility, set); });
    }

private:
    /// Those that need the box.
    template <class Isa>
    UMBRAGE_INLINE void count_open(const receiver_block& r, const std::int32_t* open, int count, float* visibility,
                                   Isa set) const {
        receiver_block rest;
        alignas(64) float shares[block];
        int indices[block], found = 0;
        for (int i = 0; i < count; ++i) {
            indices[found] = i;
            rest.set(found, r.x(i), r.y(i), r.z(i));
            found -= open[i];
        }
        // Copies behind them: if all 64 boxes are in the map, none needs care.
        for (int i = found; i < block; ++i) rest.set(i, rest.xs[0], rest.ys[0], rest.zs[0]);
        typename Blocks::placed boxes;
        every_texel.place(rest, boxes);
        every_texel(boxes, found, shares, set);
        for (int i = 0; i < found; ++i) visibility[indices[i]] = shares[i];
    }
};

/// Turns go by the place in a block: one that has an open receiver is looked up whole.
template <depth_direction Direction>
struct hierarchical_disc_blocks {
    using test = block_test<Direction>;
    struct placed {
        typename disc_blocks<Direction>::placed points;
        alignas(64) std::int32_t offsets[block];
    };
    const box_bounds& tree;
    const disc_blocks<Direction>& every_point;
    reached_texels reached;

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at, int pixel_y) const {
        const texel_bytes memory(tree.bounds.view());
        const int before = tree.cells - 1, shift = 8 + tree.level, ahead = reached.before();
        const glm::ivec2 last = tree.last;
        every_point.locate(receivers, at.points, pixel_y);
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i)
            at.offsets[i] = memory.offset(clamp_int(((at.points.x[i] + ahead) >> shift) + before, last.x),
                                          clamp_int(((at.points.y[i] + ahead) >> shift) + before, last.y));
        prefetch(memory, at.offsets, 1);
    }

    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int count, float* visibility, Isa set) const {
        alignas(64) std::int32_t open[block];
        if (ask_bounds<test>(tree, at.offsets, at.points.compared, at.points.z, visibility, open))
            every_point(at.points, count, visibility, set);
    }
};

template <>
struct block_form<filters::hierarchical_box> {
    static constexpr map_need need = map_need::floats;
    static constexpr int least = 1;
    template <depth_direction Direction, class ParallelFor, class Use>
    static void with_blocks(const float_texels& map, const filters::hierarchical_box& filter, ParallelFor&& parallel,
                            const Use& use) {
        const box_blocks<Direction> every_texel{map.map, clamp_int(filter.radius, max_box_radius)};
        if (map.map.size.x < block) return use(every_texel);  // bounds come in whole blocks: they would outgrow the map
        const box_bounds tree(map.map, 2 * every_texel.radius + 1, parallel);
        use(hierarchical_blocks<box_blocks<Direction>>{tree, every_texel});
    }
};

template <>
struct block_form<filters::hierarchical_window> {
    static constexpr map_need need = map_need::floats;
    static constexpr int least = 1;
    template <depth_direction Direction, class ParallelFor, class Use>
    static void with_blocks(const float_texels& map, const filters::hierarchical_window& filter, ParallelFor&& parallel,
                            const Use& use) {
        const window_table weights(filter.row);
        const window_blocks<Direction> every_texel{map.map, filter.row, weights};
        if (map.map.size.x < block) return use(every_texel);
        const box_bounds tree(map.map, filter.row.touched(), parallel);
        use(hierarchical_blocks<window_blocks<Direction>>{tree, every_texel});
    }
};

template <>
struct block_form<filters::hierarchical_disc> {
    static constexpr map_need need = map_need::floats;
    static constexpr int least = 1;
    template <depth_direction Direction, class ParallelFor, class Use>
    static void with_blocks(const float_texels& map, const filters::hierarchical_disc& filter, ParallelFor&& parallel,
                            const Use& use) {
        using plain = block_form<filters::rotated_disc>;
        plain::with_blocks<Direction>(map, filter, parallel, [&](const disc_blocks<Direction>& every_point) {
            if (map.map.size.x < block) return use(every_point);
            const reached_texels reached(filter.reach());
            const box_bounds tree(map.map, reached.count(), parallel);
            use(hierarchical_disc_blocks<Direction>{tree, every_point, reached});
        });
    }
};

}  // namespace umbrage::detail

// ---- umbrage/simd/blocks/pcf_2x2.hpp
// Bilinear 2x2 percentage-closer filtering over blocks of receivers.

namespace umbrage::detail {

/// A position clamped to the middles of the map's border texels has the same neighbours and weights that add up to the
/// same, so that both neighbours are in the map and one load gets them.
template <depth_direction Direction, class Map>
struct pcf_2x2_blocks {
    using test = block_test<Direction>;
    struct placed {
        alignas(64) std::int32_t offsets[block], compared[block];
        alignas(64) float hi_x[block], hi_y[block], z[block];
    };
    Map map;

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& receivers, placed& at) const {
        const texel_bytes memory(map.map);
        constexpr int space = (1 << 15) + 1;  // a receiver in it may ask for the texel beyond
        const int last_x = last_in_space(map.map.size.x, space), last_y = last_in_space(map.map.size.y, space);
        const auto axis = [](float coord, int last, float& hi) UMBRAGE_INLINE {
            const std::int32_t position = floor_within(coord * 256.0f - 128.0f, static_cast<float>(last * 256));
            const std::int32_t here = position >> 8, last_pair = last - 1;
            const std::int32_t texel = here < last_pair ? here : last_pair;
            hi = static_cast<float>(position - texel * 256);
            return texel;
        };
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            const float x = receivers.x(i), y = receivers.y(i), z = receivers.z(i);
            at.compared[i] = test::compared(x, y, z);
            at.offsets[i] = memory.offset(axis(x, last_x, at.hi_x[i]), axis(y, last_y, at.hi_y[i]));
            at.z[i] = z;
        }
        prefetch(memory, at.offsets, 2);
    }
    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int, float* visibility, Isa) const {
        const texel_bytes memory(map.map);
        loaded_texels<Map> low(map), high(map);
        loaded_texels<Map>::load_two(
            low, [&](int i) UMBRAGE_INLINE { return memory.at(at.offsets[i]); }, high,
            [&](int i) UMBRAGE_INLINE { return memory.below(at.offsets[i]); });
        for (int i = 0; i < block; ++i) {
            const float z = low.receiver(at.z[i]), lo_x = 256.0f - at.hi_x[i], lo_y = 256.0f - at.hi_y[i];
            const auto weigh = [&](const auto& row) UMBRAGE_INLINE {
                return masked(lo_x, -test::lit(z, row.first(i))) + masked(at.hi_x[i], -test::lit(z, row.second(i)));
            };
            const float sum = lo_y * weigh(low) + at.hi_y[i] * weigh(high);
            visibility[i] = select(at.compared[i], sum * (1.0f / 65536.0f), 1.0f);
        }
    }
};

template <>
struct block_form<filters::pcf_2x2> {
    static constexpr map_need need = map_need::texels;
    static constexpr int least = 2;
    template <depth_direction Direction, class Map, class ParallelFor, class Use>
    static void with_blocks(const Map& map, const filters::pcf_2x2&, ParallelFor&&, const Use& use) {
        use(pcf_2x2_blocks<Direction, Map>{map});
    }
};

}  // namespace umbrage::detail

// ---- umbrage/simd/blocks/soft.hpp
// Contact hardening over blocks of receivers: discs as in disc.hpp, with a radius for each receiver.

namespace umbrage::detail {

/// floor(a / b); 0 <= a < 2^24, 1 <= b, as floor_divide.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t divide_int(std::int32_t a, std::int32_t b) {
    auto q = static_cast<std::int32_t>(static_cast<float>(a) / static_cast<float>(b));
    q -= std::int32_t(q * b > a);
    return q + std::int32_t((q + 1) * b <= a);
}

/// @tparam Filter   filters::pcss or filters::dpcf
template <depth_direction Direction, class Filter>
struct soft_blocks : disc_blocks<Direction> {
    using discs = disc_blocks<Direction>;
    using test = typename discs::test;
    using placed = typename discs::placed;
    static constexpr std::int32_t far_code = 65535;
    static constexpr bool filters_again = std::is_same_v<Filter, filters::pcss>;

    float per_code;
    std::int32_t least, widest;

    /// Turned points in 1/16 of 1/64 of a radius: a radius of 4 texels divides by nothing.
    static disc_table turned_points(const Filter& filter) {
        return {filter.points == 8 ? disc_points<8>.data()
                                   : (filter.points == 16 ? disc_points<16>.data() : disc_points<32>.data()),
                filter.points, 4.0f};
    }
    soft_blocks(image_view<const float> of_map, const disc_table& turned, const Filter& filter)
        : discs{of_map, turned, filter.points, clamp_int(static_cast<int>(filter.reach()), 8)},
          per_code(filter.softness.per_code),
          least(static_cast<std::int32_t>(filter.softness.least)),
          widest(static_cast<std::int32_t>(filter.softness.widest)) {}

    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int, float* visibility, Isa set) const {
        out_of_line(set, [&](auto) UMBRAGE_INLINE { soften(at, visibility); });
    }

private:
    [[nodiscard]] static UMBRAGE_INLINE std::int32_t distance_code_of(float depth) {
        const std::int32_t number = number_mask(depth), x = floor_within(depth * 65536.0f, 65535.0f);
        return ((test::forward ? x : far_code - x) & number) | (far_code & ~number);
    }
    [[nodiscard]] UMBRAGE_INLINE std::int32_t radius(std::int32_t apart) const {
        const std::int32_t r = floor_int(static_cast<float>(apart) * per_code);
        const std::int32_t above = r > least ? r : least;
        return above < widest ? above : widest;
    }

    /// Calls use(texels) point by point, with the texels below that point of each receiver's disc.
    template <class Use>
    UMBRAGE_INLINE void for_each_tap(const placed& at, const std::int32_t* radii, const Use& use) const {
        const float_texels of_map{this->map};
        const texel_bytes memory(this->map);
        const int last_x = this->map.size.x - 1, last_y = this->map.size.y - 1;
        loaded_texels<float_texels> texels(of_map);
        alignas(64) std::int32_t offsets[block];
        for (int p = 0; p < this->points; ++p) {
            const disc_table::tap& tap = this->taps.of[static_cast<std::size_t>(at.row)][static_cast<std::size_t>(p)];
            for (int i = 0; i < block; ++i)
                offsets[i] = memory.offset(clamp_int((at.x[i] + (tap.x[i] * radii[i] >> 6)) >> 8, last_x),
                                           clamp_int((at.y[i] + (tap.y[i] * radii[i] >> 6)) >> 8, last_y));
            texels.load_one([&](int i) UMBRAGE_INLINE { return memory.at(offsets[i]); });
            use(texels);
        }
    }

    UMBRAGE_INLINE void soften(const placed& at, float* visibility) const {
        alignas(64) std::int32_t codes[block], searched[block], radii[block], blocked[block]{}, sums[block]{};
        for (int i = 0; i < block; ++i) {
            codes[i] = distance_code_of(at.z[i]);
            searched[i] = radius(codes[i]);
        }
        for_each_tap(at, searched, [&](const auto& texels) UMBRAGE_INLINE {
            std::int32_t found = 0;
            for (int i = 0; i < block; ++i) {
                const std::int32_t before = 1 - test::lit(at.z[i], texels.one(i));
                blocked[i] += before;
                found |= before;
            }
            if (found == 0) return;  // most blocks of a picture are lit
            for (int i = 0; i < block; ++i)
                sums[i] += distance_code_of(texels.one(i)) & -(1 - test::lit(at.z[i], texels.one(i)));
        });
        std::int32_t any = 0;
        for (int i = 0; i < block; ++i) {
            any |= blocked[i] & at.compared[i];
            radii[i] = radius(codes[i] - divide_int(sums[i], blocked[i] > 1 ? blocked[i] : 1));
        }
        if (any == 0) {
            for (int i = 0; i < block; ++i) visibility[i] = 1.0f;
        } else if constexpr (filters_again) {
            alignas(64) std::int32_t lit[block]{};
            for_each_tap(at, radii, [&](const auto& texels) UMBRAGE_INLINE {
                for (int i = 0; i < block; ++i) lit[i] += test::lit(at.z[i], texels.one(i));
            });
            const float share = 1.0f / static_cast<float>(this->points);
            UMBRAGE_NO_OVERLAP
            for (int i = 0; i < block; ++i)
                visibility[i] =
                    select(at.compared[i] & -std::int32_t(blocked[i] > 0), static_cast<float>(lit[i]) * share, 1.0f);
        } else {
            const std::int32_t n = this->points, cube = n * n * n;
            const float share = 1.0f / (512.0f * static_cast<float>(cube));
            UMBRAGE_NO_OVERLAP
            for (int i = 0; i < block; ++i) {
                const std::int32_t ratio = divide_int(radii[i] * 256, searched[i] > 1 ? searched[i] : 1);
                const std::int32_t u = blocked[i] * 2 - n, d = n - (u < 0 ? -u : u), steep = cube - d * d * d;
                const std::int32_t hard = u < 0 ? cube - steep : cube + steep;
                const std::int32_t dark = hard * (256 - ratio) + blocked[i] * ratio * (2 * n * n);
                visibility[i] = select(at.compared[i], 1.0f - static_cast<float>(dark) * share, 1.0f);
            }
        }
    }
};

template <class Filter>
struct soft_form {
    static constexpr map_need need = map_need::floats;
    static constexpr int least = 1;
    template <depth_direction Direction, class ParallelFor, class Use>
    static void with_blocks(const float_texels& map, const Filter& filter, ParallelFor&&, const Use& use) {
        using blocks = soft_blocks<Direction, Filter>;
        const disc_table turned = blocks::turned_points(filter);
        use(blocks(map.map, turned, filter));
    }
};
template <>
struct block_form<filters::pcss> : soft_form<filters::pcss> {};
template <>
struct block_form<filters::dpcf> : soft_form<filters::dpcf> {};

}  // namespace umbrage::detail

// ---- umbrage/filter/filters.hpp
// Every filter of the library, in one list: what tools, tables, proofs and examples walk. Each comes with its form for
// blocks of receivers.
//
//     umbrage::visibility(map, umbrage::rg<11>{}, receivers, umbrage::filters::box{.radius = 2}, out);
//

namespace umbrage::filters {

using all = list_of<hard, four_tap, pcf_2x2, pcf_2x2_dx_sdk, box, hierarchical_box, window, rotated_disc>;

/// Beside them those that know the light's size: their maps hold z/w.
using soft = list_of<pcss, dpcf>;

}  // namespace umbrage::filters

namespace umbrage {

/// Calls use(filter) for one after the other.
template <class Use>
void for_each_filter(Use&& use) {
    filters::all::for_each(use);
}

/// Calls use(filter) with the one of that name.
/// @return   false where none is called so
template <class Use>
bool with_filter(std::string_view name, Use&& use) {
    return filters::all::with(name, use);
}

}  // namespace umbrage

// ---- umbrage/images/blur.hpp
// Separable blur of images of one to four floats a texel, such as moments.
//
//     umbrage::blur(moments, blurred, umbrage::make_gaussian_kernel(7, 1.5f));
//

namespace umbrage {

/// A symmetric row of weights. Taps are odd: 2 * weights.size() - 1.
struct blur_kernel {
    std::vector<float> weights;  ///< that of the centre, then those at distance 1, 2, ... on both sides
};

/// Row Taps - 1 of Pascal's triangle, divided by its sum: weights are exact.
/// @formula       weights[i] = C(Taps - 1, (Taps - 1) / 2 + i) / 2^(Taps - 1)
/// @exactness     A
template <int Taps>
[[nodiscard]] blur_kernel make_binomial_kernel() {
    static_assert(Taps >= 1 && Taps <= 25 && Taps % 2 == 1,
                  "an odd number up to 25: beyond, floats do not hold the weights");
    blur_kernel kernel{std::vector<float>(Taps / 2 + 1)};
    double weight = std::ldexp(1.0, 1 - Taps);  // that of the outermost tap
    for (int i = 0; i <= Taps / 2; ++i) {
        kernel.weights[static_cast<std::size_t>(Taps / 2 - i)] = static_cast<float>(weight);
        weight = weight * (Taps - 1 - i) / (i + 1);
    }
    return kernel;
}

/// A Gaussian bell, sampled at the texels and divided by its sum.
/// @param taps    odd, >= 1
/// @param sigma   standard deviation in texels, > 0; infinity gives equal weights
/// @throws std::invalid_argument  otherwise
/// @formula       weights[i] = exp(-i^2 / (2 sigma^2)) / sum, in double
/// @exactness     C: exp
[[nodiscard]] inline blur_kernel make_gaussian_kernel(int taps, float sigma) {
    if (taps < 1 || taps % 2 == 0 || !(sigma > 0.0f))
        detail::fail("umbrage::make_gaussian_kernel: taps even or below 1, or sigma not above 0");
    const auto bell = [s = static_cast<double>(sigma)](int i) { return std::exp(-0.5 * (i / s) * (i / s)); };
    double sum = 1.0;
    for (int i = 1; i <= taps / 2; ++i) sum += 2.0 * bell(i);
    blur_kernel kernel;
    for (int i = 0; i <= taps / 2; ++i) kernel.weights.push_back(static_cast<float>(bell(i) / sum));
    return kernel;
}

namespace detail {

template <class T>
inline constexpr int float_channels = static_cast<int>(sizeof(T) / sizeof(float));

/// 64 sums of taps; tap(i) is where those at distance i begin, i from -radius to radius.
template <class Tap, std::size_t... I>
UMBRAGE_INLINE inline void blur_block(const float* weights, const Tap& tap, float* __restrict to,
                                      std::index_sequence<I...>) {
    // Pointers and weights are locals, which stay in registers: one loop holds all taps.
    const float* const centre = tap(0);
    const std::array<const float*, sizeof...(I)> before{tap(-static_cast<int>(I) - 1)...},
        after{tap(static_cast<int>(I) + 1)...};
    const std::array<float, sizeof...(I)> w{weights[I + 1]...};
    const float w0 = weights[0];
    for (int x = 0; x < block; ++x) {
        float sum = w0 * centre[x];
        ((sum = sum + w[I] * (before[I][x] + after[I][x])), ...);
        to[x] = sum;
    }
}

/// The same for any number of sums.
template <class Tap>
UMBRAGE_INLINE inline void blur_some(const float* weights, int radius, const Tap& tap, float* to, int count) {
    const float* const centre = tap(0);
    for (int x = 0; x < count; ++x) to[x] = weights[0] * centre[x];
    for (int i = 1; i <= radius; ++i) {
        const float *before = tap(-i), *after = tap(i), w = weights[i];
        for (int x = 0; x < count; ++x) to[x] = to[x] + w * (before[x] + after[x]);
    }
}

/// A row; tap(i) is where the row at distance i begins, and `next` a row that will be needed after it.
template <class Tap>
UMBRAGE_INLINE inline void blur_row(const float* weights, int radius, const Tap& tap, float* to, int width,
                                    const float* next = nullptr) {
    if (width < block) return blur_some(weights, radius, tap, to, width);
    const auto each = [&](auto&& blur_at) UMBRAGE_INLINE {
        for (int x = 0; x + block <= width; x += block)
            blur_at([&](int i) UMBRAGE_INLINE { return tap(i) + x; }, to + x);
        if (const int x = width - block; width % block)
            blur_at([&](int i) UMBRAGE_INLINE { return tap(i) + x; }, to + x);
    };
    const auto with_radius = [&](auto taps) UMBRAGE_INLINE {
        each([&](const auto& at, float* result) UMBRAGE_INLINE {
            if (next) prefetch_bytes(next + (result - to), 0, block * static_cast<int>(sizeof(float)));
            blur_block(weights, at, result, taps);
        });
    };
    switch (radius) {
        case 1: return with_radius(std::make_index_sequence<1>{});
        case 2: return with_radius(std::make_index_sequence<2>{});
        case 3: return with_radius(std::make_index_sequence<3>{});
        case 4: return with_radius(std::make_index_sequence<4>{});
        case 5: return with_radius(std::make_index_sequence<5>{});
    }
    each([&](const auto& at, float* result) UMBRAGE_INLINE {
        alignas(64) float sums[block];
        blur_some(weights, radius, at, sums, block);
        std::memcpy(result, sums, sizeof sums);
    });
}

/// Rows first <= y < last: each along y into a line, and that along x; one body for texels of any channels.
inline void blur_rows(image_view<const float> from, image_view<float> to, const blur_kernel& kernel, int channels,
                      int first, int last) {
    const int radius = static_cast<int>(kernel.weights.size()) - 1, width = from.size.x, height = from.size.y;
    const int border = radius * channels;
    std::vector<float> padded(static_cast<std::size_t>(width + 2 * border));
    std::vector<const float*> rows(2 * kernel.weights.size() - 1);
    on_best_isa_without_fma([&](auto) UMBRAGE_INLINE {
        const float* const weights = kernel.weights.data();
        const float** const around = rows.data() + radius;
        float* const line = padded.data() + border;
        const auto row = [&](int y) { return from.row(y < 0 ? 0 : (y < height ? y : height - 1)); };
        for (int y = first; y < last; ++y) {
            for (int i = -radius; i <= radius; ++i) around[i] = row(y + i);
            blur_row(
                weights, radius, [=](int i) UMBRAGE_INLINE { return around[i]; }, line, width, row(y + radius + 1));
            for (int i = 0; i < border; ++i) {
                line[i - border] = line[i % channels];
                line[width + i] = line[width - channels + i % channels];
            }
            const float* const centre = line;
            blur_row(
                weights, radius, [=](int i) UMBRAGE_INLINE { return centre + i * channels; }, to.row(y), width);
        }
    });
}

}  // namespace detail

/// Blurs along y, then along x. Outside the image, its border goes on.
///
/// @param from      texels of float, vec2, vec3 or vec4
/// @param to        same size and type, other pixels
/// @param kernel    1 weight at least
/// @param parallel  cuts the rows into pieces, see parallel.hpp
/// @throws std::invalid_argument  sizes differ, same pixels, or no weights
/// @formula         w0 c + w1 (before1 + after1) + w2 (before2 + after2) + ..., in this order, along y and then along x
/// @exactness       B: every instruction set and any pieces give the bits of the written order, as long as the compiler
///                  is not told that it may fuse a multiplication and an addition (-march with FMA without
///                  -ffp-contract=off)
template <class From, class T, class ParallelFor = serial>
void blur(image_view<From> from, image_view<T> to, const blur_kernel& kernel, ParallelFor&& parallel = {}) {
    constexpr int channels = detail::float_channels<T>;
    static_assert(std::is_same_v<std::remove_const_t<From>, T>);
    static_assert(std::is_same_v<T, float> || std::is_same_v<T, glm::vec2> || std::is_same_v<T, glm::vec3> ||
                  std::is_same_v<T, glm::vec4>);
    static_assert(sizeof(T) == channels * sizeof(float) && alignof(T) == alignof(float));
    if (from.size != to.size) detail::fail("umbrage::blur: sizes differ");
    if (kernel.weights.empty()) detail::fail("umbrage::blur: no weights");
    if (from.empty()) return;
    if (from.data == to.data) detail::fail("umbrage::blur: same pixels");
    const glm::ivec2 size(from.size.x * channels, from.size.y);
    const image_view<const float> floats_from(reinterpret_cast<const float*>(from.data), size, from.stride);
    const image_view<float> floats_to(reinterpret_cast<float*>(to.data), size, to.stride);
    parallel(size.y,
             [&](int first, int last) { detail::blur_rows(floats_from, floats_to, kernel, channels, first, last); });
}

/// The same where one of the two is an image.
template <class From, class To, class ParallelFor = serial>
requires detail::some_image<From, To>
void blur(const From& from, To&& to, const blur_kernel& kernel, ParallelFor&& parallel = {}) {
    blur(detail::view_of(from), detail::view_of(to), kernel, parallel);
}

}  // namespace umbrage

// ---- umbrage/images/depth_span.hpp
// Between which distances a camera sees anything, so that cascades cover no more than that.
//
//     const auto seen = umbrage::measure_depths(camera_depths.view(), umbrage::cleared_depth(clip));
//     const glm::vec2 range = umbrage::seen_range(seen, z_near, z_far, clip.direction);
//     auto splits = umbrage::logarithmic_splits<4>(range.x, range.y);
//

namespace umbrage {

/// Least and greatest of some depths.
struct depth_span {
    float least = std::numeric_limits<float>::max(), greatest = std::numeric_limits<float>::lowest();
    [[nodiscard]] bool empty() const { return least > greatest; }
};

/// @param depths     any values; NaN and texels of the cleared depth, where nothing was drawn, do not count
/// @param parallel   cuts the rows into pieces, see parallel.hpp
/// @exactness        A: selects, never computes
/// @cite             Lauritzen, Salvi, Lefohn: Sample distribution shadow maps, I3D 2011
template <class ParallelFor = serial>
[[nodiscard]] depth_span measure_depths(image_view<const float> depths, float cleared, ParallelFor&& parallel = {}) {
    constexpr auto lowest = std::numeric_limits<std::int32_t>::min(),
                   highest = std::numeric_limits<std::int32_t>::max();
    struct ends {
        std::int32_t least = highest, greatest = lowest;
    };
    std::vector<ends> rows(depths.empty() ? 0 : static_cast<std::size_t>(depths.size.y));
    const std::int32_t empty = detail::order_key(cleared);
    parallel(static_cast<int>(rows.size()), [&](int first, int last) {
        detail::on_best_isa([&](auto) UMBRAGE_INLINE {
            for (int y = first; y < last; ++y) {
                const float* row = depths.row(y);
                ends found;
                for (int x = 0; x < depths.size.x; ++x) {
                    const std::int32_t key = detail::order_key(row[x]);
                    const std::int32_t kept = detail::number_mask(row[x]) & -std::int32_t(key != empty);
                    const std::int32_t low = (key & kept) | (highest & ~kept), high = (key & kept) | (lowest & ~kept);
                    found.least = low < found.least ? low : found.least;
                    found.greatest = high > found.greatest ? high : found.greatest;
                }
                rows[static_cast<std::size_t>(y)] = found;
            }
        });
    });
    ends all;
    for (const ends& row : rows) {
        all.least = row.least < all.least ? row.least : all.least;
        all.greatest = row.greatest > all.greatest ? row.greatest : all.greatest;
    }
    if (all.least > all.greatest) return {};
    return {detail::from_order_key(all.least), detail::from_order_key(all.greatest)};
}

/// Distances along a camera's axis between which its depths lie, and a thousandth more, which they may have lost to
/// rounding.
/// @param seen             depths in [0, 1] of a perspective camera
/// @param z_near, z_far    the camera's, 0 < z_near < z_far; z_far may be infinite
/// @return                 x < y within z_near .. z_far: all of it where nothing is seen
template <real T>
[[nodiscard]] glm::vec<2, T> seen_range(const depth_span& seen, T z_near, T z_far, depth_direction direction) {
    if (seen.empty()) return {z_near, z_far};
    const bool forward = direction == depth_direction::forward;
    const T nearest = static_cast<T>(forward ? seen.least : seen.greatest);
    const T farthest = static_cast<T>(forward ? seen.greatest : seen.least);
    const auto distance = [&](T depth) {
        return forward ? view_z_from_depth(depth, z_near, z_far) : view_z_from_reversed_depth(depth, z_near, z_far);
    };
    return {glm::max(distance(nearest) * T(1.0 - 1.0 / 1024), z_near),
            glm::min(distance(farthest) * T(1.0 + 1.0 / 1024), z_far)};
}

}  // namespace umbrage

// ---- umbrage/images/mesh.hpp
// What the depth pass draws: triangles, once or as instances, each under its matrix.
//
//     umbrage::mesh_view mesh{positions, triangles};
//

UMBRAGE_STRICT_MATH
namespace umbrage {

/// Triangles that somebody else owns: three indices into the positions each.
struct mesh_view {
    std::span<const glm::vec3> positions;
    std::span<const glm::uvec3> triangles;
};

/// Which faces to leave out. The front goes counter-clockwise in NDC, x to the right and y up, as in most right-handed
/// worlds; where it goes clockwise, as in most left-handed ones, front and back change places.
enum class cull_mode { none, front, back };

/// What becomes of what lies before the near plane: it is clipped off, or drawn with that plane's depth, so that
/// casters between the light and a near plane at the receivers still cast. GPUs' depth clamp, but that the far plane
/// still clips.
enum class near_plane { clips, clamps };

/// The matrix that an instance of a mesh is drawn with.
/// @param model       model to world
/// @exactness         the product in double, rounded once: far from the world's origin a float product would lose what
///                    subtracting the camera's or the light's place leaves
[[nodiscard]] inline glm::mat4 model_to_clip(const glm::mat4& world_to_clip, const glm::mat4& model) {
    return glm::mat4(glm::dmat4(world_to_clip) * glm::dmat4(model));
}

}  // namespace umbrage
UMBRAGE_END_STRICT_MATH

// ---- umbrage/simd/raster/projection.hpp
// From world positions to vertices on the 1/256 texel grid: projected and snapped, one at a time or in blocks.
//
//     projection project(world_to_clip, clip, {1024, 1024});
//     snapped_vertex vertex = project.snap(project.homogeneous(position));
//
// Texels are counted from the bottom in here (NDC y = -1), whatever the clip space says: the texture origin only
// mirrors rows when texels are written, so that both origins give the same picture.
//

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// Steps of the vertex grid in a texel.
inline constexpr int subtexels = 256;

/// Largest side of an image in texels, and how far from texel 0 a vertex may lie before it is clipped:
/// differences of vertices then stay below 2^23 steps, edge functions below 2^47.
inline constexpr int guard_band = 1 << 14;

/// A vertex on the grid. The order makes results independent of the order in which a mesh lists vertices.
struct snapped_vertex {
    std::int32_t x, y;  ///< in 1/256 texel, within +-guard_band
    double depth;       ///< z/w moved to [0, 1]; outside only beyond the far plane

    friend auto operator<=>(const snapped_vertex&, const snapped_vertex&) = default;
};

/// @throws std::invalid_argument  a side is negative or above guard_band
inline void require_drawable(glm::ivec2 size) {
    if (size.x < 0 || size.y < 0) detail::fail("umbrage::rasterize: negative size");
    if (size.x > guard_band || size.y > guard_band) detail::fail("umbrage::rasterize: image side above 16384 texels");
}

/// What stands for a vertex outside of planes: off the grid, with their bits.
[[nodiscard]] inline snapped_vertex outside_vertex(unsigned planes) {
    return {std::numeric_limits<std::int32_t>::min(), static_cast<std::int32_t>(planes), 0.0};
}
/// A bit for each plane that a vertex is outside of.
[[nodiscard]] inline unsigned planes_outside(const snapped_vertex& v) {
    return v.x == std::numeric_limits<std::int32_t>::min() ? static_cast<unsigned>(v.y) : 0u;
}

/// World positions to homogeneous texels (x/w and y/w in texels, z/w the depth in [0, 1]) and on to the grid.
/// Products of two floats are exact in double, so contraction to FMA changes no bit here.
class projection {
public:
    static constexpr int planes = 6, z_near = 1;       ///< w > 0, the near plane, four sides of the guard band
    static constexpr unsigned nowhere = 1u << planes;  ///< stands for a position that is not finite

    /// @param world_to_clip  projection * view; its elements must be finite
    /// @throws std::invalid_argument  see require_drawable
    projection(const glm::mat4& world_to_clip, clip_space clip, glm::ivec2 size)
        : matrix_(world_to_clip), clip_(clip), half_size_(glm::dvec2(size) * 0.5) {
        require_drawable(size);
    }

    [[nodiscard]] glm::dvec4 homogeneous(glm::vec3 p) const {
        const double x = row(0, p), y = row(1, p), z = row(2, p), w = row(3, p);
        return {(x + w) * half_size_.x, (y + w) * half_size_.y,
                clip_.range == depth_range::minus_one_to_one ? (z + w) * 0.5 : z, w};
    }

    /// How far inside a plane a point is; outside when negative.
    [[nodiscard]] double distance(int plane, const glm::dvec4& h) const {
        switch (plane) {
            case 0: return h.w - smallest_w;
            case 1: return clip_.direction == depth_direction::forward ? h.z : h.w - h.z;
            case 2: return guard_band * h.w + h.x;
            case 3: return guard_band * h.w - h.x;
            case 4: return guard_band * h.w + h.y;
            default: return guard_band * h.w - h.y;
        }
    }

    /// One bit for each plane that the point is outside of.
    [[nodiscard]] unsigned outside(const glm::dvec4& h) const {
        unsigned bits = 0;
        for (int plane = 0; plane < planes; ++plane) bits |= (distance(plane, h) < 0.0 ? 1u : 0u) << plane;
        return bits;
    }

    /// Where the way from a point inside a plane to one outside meets it. The callers always go this way, so that
    /// triangles on both sides of an edge cut it at the same point.
    [[nodiscard]] glm::dvec4 cut(int plane, const glm::dvec4& in, const glm::dvec4& out) const {
        const double d = distance(plane, in);
        glm::dvec4 h = in + (out - in) * (d / (d - distance(plane, out)));
        if (!(h.w > smallest_w)) h.w = smallest_w;  // rounding
        switch (plane) {                            // what lies on the plane by definition does so to the bit
            case 0: h.w = smallest_w; break;
            case 1: h.z = clip_.direction == depth_direction::forward ? 0.0 : h.w; break;
            case 2: h.x = -guard_band * h.w; break;
            case 3: h.x = guard_band * h.w; break;
            case 4: h.y = -guard_band * h.w; break;
            default: h.y = guard_band * h.w; break;
        }
        return h;
    }

    /// To the grid, halves upwards. The point must be inside all planes; clamps only catch the rounding of cut().
    [[nodiscard]] snapped_vertex snap(const glm::dvec4& h) const {
        constexpr double limit = double(guard_band) * subtexels;
        const auto grid = [&](double v) {
            const double steps = v / h.w * subtexels + 0.5;
            const double inside = steps > -limit ? (steps < limit ? steps : limit) : -limit;
            const auto whole = static_cast<std::int32_t>(inside);
            return whole - (inside < whole ? 1 : 0);
        };
        const double depth = h.z / h.w;
        if (clip_.direction == depth_direction::forward) return {grid(h.x), grid(h.y), depth > 0.0 ? depth : 0.0};
        return {grid(h.x), grid(h.y), depth < 1.0 ? depth : 1.0};
    }

    /// 64 positions at once, to where homogeneous() and snap() put them; those outside of planes, and those that are
    /// not finite, become `outside_vertex`.
    /// @exactness  the bits of one by one
    void snap(const glm::vec3 (&positions)[block], snapped_vertex* vertices) const {
        using bits = std::int64_t;
        constexpr bits minus_zero = std::numeric_limits<bits>::min();
        const bool forward = clip_.direction == depth_direction::forward;
        const double z_share = clip_.range == depth_range::minus_one_to_one ? 0.5 : 1.0, w_share = 1.0 - z_share;
        const double near_z = forward ? 1.0 : -1.0, near_w = forward ? 0.0 : 1.0;
        const bits lowest = forward ? 0 : minus_zero;
        const bits highest = forward ? std::numeric_limits<bits>::max() : bit_cast<bits>(1.0);
        on_best_isa_without_fma([&](auto) UMBRAGE_INLINE {
            alignas(64) float x[block], y[block], z[block];
            alignas(64) double column[block], row[block], depth[block];
            alignas(64) bits outside[block];
            alignas(64) std::int32_t finite[block];  // masks
            for (int i = 0; i < block; ++i) x[i] = positions[i].x, y[i] = positions[i].y, z[i] = positions[i].z;
            for (int i = 0; i < block; ++i) {
                finite[i] = finite_mask(x[i]) & finite_mask(y[i]) & finite_mask(z[i]);
                x[i] = masked(x[i], finite[i]), y[i] = masked(y[i], finite[i]), z[i] = masked(z[i], finite[i]);
            }
            const glm::dmat4 m = matrix_;
            const glm::dvec2 half_size = half_size_;
            for (int i = 0; i < block; ++i) {
                const auto clip_row = [&](glm::length_t r) UMBRAGE_INLINE {
                    return m[0][r] * double(x[i]) + m[1][r] * double(y[i]) + m[2][r] * double(z[i]) + m[3][r];
                };
                const double w = clip_row(3), band = guard_band * w;
                const double hx = (clip_row(0) + w) * half_size.x, hy = (clip_row(1) + w) * half_size.y;
                const double hz = z_share * clip_row(2) + w_share * w;
                const auto bit = [](double distance, int plane) UMBRAGE_INLINE {
                    const bits d = bit_cast<bits>(distance);
                    return bits((d < 0) & (d != minus_zero)) << plane;
                };
                outside[i] = bit(w - smallest_w, 0) | bit(near_z * hz + near_w * w, 1) | bit(band + hx, 2) |
                             bit(band - hx, 3) | bit(band + hy, 4) | bit(band - hy, 5) |
                             (~bits(finite[i]) & bits(nowhere));
                const bits inside = -bits(outside[i] == 0);
                column[i] = bit_cast<double>(bit_cast<bits>(hx / w * subtexels + 0.5) & inside);
                row[i] = bit_cast<double>(bit_cast<bits>(hy / w * subtexels + 0.5) & inside);
                bits d = bit_cast<bits>(hz / w);
                d = d < lowest ? lowest : d;
                d = d > highest ? highest : d;
                depth[i] = bit_cast<double>(d & inside);
            }
            alignas(64) std::int32_t columns[block], rows[block];
            const auto floors = [](const double* from, std::int32_t* to) UMBRAGE_INLINE {
                for (int i = 0; i < block; ++i) {
                    const auto whole = static_cast<std::int32_t>(from[i]);
                    to[i] = whole - std::int32_t(from[i] < whole);
                }
            };
            floors(column, columns);
            floors(row, rows);
            for (int i = 0; i < block; ++i) vertices[i] = {columns[i], rows[i], depth[i]};
            for (int i = 0; i < block; ++i)
                if (outside[i]) vertices[i] = outside_vertex(static_cast<unsigned>(outside[i]));
        });
    }

private:
    static constexpr double smallest_w = 0x1p-126;

    [[nodiscard]] double row(glm::length_t r, glm::vec3 p) const {
        return matrix_[0][r] * double(p.x) + matrix_[1][r] * double(p.y) + matrix_[2][r] * double(p.z) + matrix_[3][r];
    }

    glm::dmat4 matrix_;
    clip_space clip_;
    glm::dvec2 half_size_;
};

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH

// ---- umbrage/images/barycentrics.hpp
// Where on a triangle a texel looks, for what interpolates after a camera pass.
//
//     glm::vec3 weights = umbrage::barycentrics(size, mesh, world_to_clip, clip, texel, triangle);
//
// The same for many texels of a triangle, with what they share computed once:
//
//     const umbrage::triangle_weights weights(size, mesh, world_to_clip, clip, triangle);
//     for (int x = first; x < last; ++x) use(weights({x, y}));
//

UMBRAGE_STRICT_MATH
namespace umbrage {

/// Perspective-correct weights of a triangle's vertices at the centres of texels.
class triangle_weights {
public:
    /// @param triangle  index into mesh.triangles; its vertices may be behind the camera
    triangle_weights(glm::ivec2 size, const mesh_view& mesh, const glm::mat4& world_to_clip, clip_space clip,
                     unsigned triangle)
        : top_(clip.origin == texture_origin::top ? size.y : 0),
          down_(clip.origin == texture_origin::top ? -1.0 : 1.0) {
        assert(triangle < mesh.triangles.size());
        const detail::projection project(world_to_clip, clip, size);
        for (glm::length_t i = 0; i < 3; ++i)
            vertices_[static_cast<std::size_t>(i)] = project.homogeneous(mesh.positions[mesh.triangles[triangle][i]]);
        const bool finite = std::all_of(vertices_.begin(), vertices_.end(), [](const glm::dvec4& v) {
            return is_finite(v.x) && is_finite(v.y) && is_finite(v.w);
        });
        if (!finite) vertices_.fill(glm::dvec4(0));
    }

    /// @return      weights that are not negative and sum to 1: a texel that snapping moved out of the triangle gets
    ///              the weights of the nearest edge; (1, 0, 0) for a triangle seen edge-on or not finite
    /// @formula     b_i ~ (x_j - X w_j)(y_k - Y w_k) - (y_j - Y w_j)(x_k - X w_k), homogeneous texels; no division by w
    /// @cite        Olano, Greer: Triangle Scan Conversion using 2D Homogeneous Coordinates, Graphics Hardware 1997
    [[nodiscard]] UMBRAGE_INLINE glm::vec3 operator()(glm::ivec2 texel) const {
        const double x = texel.x + 0.5, y = top_ + down_ * (texel.y + 0.5);
        const glm::dvec4 &p = vertices_[0], &q = vertices_[1], &r = vertices_[2];
        const double px = p.x - x * p.w, qx = q.x - x * q.w, rx = r.x - x * r.w;  // the centre to each vertex, times w
        const double py = p.y - y * p.w, qy = q.y - y * q.w, ry = r.y - y * r.w;
        const double a = qx * ry - qy * rx, b = rx * py - ry * px, c = px * qy - py * qx, sum = a + b + c;
        const double side = sum < 0.0 ? -1.0 : 1.0;
        const auto inside = [&](double weight) UMBRAGE_INLINE { return side * weight > 0.0 ? side * weight : 0.0; };
        const double total = inside(a) + inside(b) + inside(c);
        const double over = total > 0.0 ? total : 1.0, first = total > 0.0 ? inside(a) : 1.0;
        return {static_cast<float>(first / over), static_cast<float>(inside(b) / over),
                static_cast<float>(inside(c) / over)};
    }

private:
    double top_, down_;
    std::array<glm::dvec4, 3> vertices_;
};

/// triangle_weights for a single texel.
[[nodiscard]] inline glm::vec3 barycentrics(glm::ivec2 size, const mesh_view& mesh, const glm::mat4& world_to_clip,
                                            clip_space clip, glm::ivec2 texel, unsigned triangle) {
    return triangle_weights(size, mesh, world_to_clip, clip, triangle)(texel);
}

}  // namespace umbrage
UMBRAGE_END_STRICT_MATH

// ---- umbrage/simd/raster/triangles.hpp
// Triangles on the vertex grid, 64 at a time: which way round, edges and depth planes in loops that vectorise.
//
//     triangles batch;
//     batch.add(p, q, r, id);  // and more, until it is full()
//     batch.set_up({{0, 0}, size}, cull_mode::none);
//     for (int i = 0; i < batch.count; ++i)
//         batch.for_each_row(i, [&](int y, int first, int last) { ... });
//
// A sample is inside an edge from a to b where E = (b.x - a.x)(y - a.y) - (b.y - a.y)(x - a.x) >= 0, or > 0 where the
// edge is neither a top nor a left one, which is E - 1 >= 0. From texel to texel E grows by multiples of 256, so that
// the sign is that of floor(E / 256), or of floor((E - 1) / 256): 32 bits for triangles up to 2048 texels.
//

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// Texels first <= t < last; y counts from the bottom.
struct texel_bounds {
    glm::ivec2 first, last;
};

/// Depth over a triangle, exact on its grid: z + dx * x + dy * y for texels x, y counted from `first`.
struct depth_plane {
    glm::ivec2 first;        ///< a texel within the triangle's bounds
    double z, dx, dy;        ///< multiples of one power of two, so that no sum of theirs within the bounds is rounded
    double lowest, highest;  ///< of the vertices; samples never leave it

    [[nodiscard]] UMBRAGE_INLINE double operator()(int x, int y) const {
        const double depth = z + dx * (x - first.x) + dy * (y - first.y);
        return depth > lowest ? (depth < highest ? depth : highest) : lowest;
    }
};

/// Up to 64 triangles, each coordinate an array of its own.
class triangles {
public:
    int count = 0;
    alignas(64) unsigned id[block];
    // After set_up():
    alignas(64) std::int32_t first_x[block], first_y[block], columns[block];  ///< texels that may be covered
    alignas(64) std::int32_t rows[block];                                     ///< 0: none is
    alignas(64) std::int32_t right[3][block], up[3][block];  ///< steps of edges / 256 from texel to texel
    alignas(64) std::int32_t edge[3][block];                 ///< edges / 256 at the first texel, if is_small
    alignas(64) float per_row[3][block];                     ///< -1 / up, anything where that is 0

    triangles() {  // every lane is set up, used or not
        for (int i = 0; i < block; ++i) {
            id[i] = 0;
            for (int k = 0; k < 3; ++k) x_[k][i] = y_[k][i] = 0, z_[k][i] = 0.0;
        }
    }

    /// Rows first <= y < second whose centres are above the lowest corner, the highest included: a bottom edge and
    /// a corner cover no centre that they meet.
    [[nodiscard]] static UMBRAGE_INLINE glm::ivec2 rows_between(std::int32_t lowest, std::int32_t highest) {
        return {(lowest + subtexels - centre) >> 8, ((highest - centre) >> 8) + 1};
    }

    [[nodiscard]] bool full() const { return count == block; }

    /// There must be room.
    UMBRAGE_INLINE void add(const snapped_vertex& a, const snapped_vertex& b, const snapped_vertex& c,
                            unsigned triangle) {
        const snapped_vertex* const corners[] = {&a, &b, &c};
        for (int k = 0; k < 3; ++k)
            x_[k][count] = corners[k]->x, y_[k][count] = corners[k]->y, z_[k][count] = corners[k]->depth;
        id[count++] = triangle;
    }

    /// All triangles; those that face away, have no area or no texel within `bounds` get no rows.
    ///
    /// @exactness  edges A: integers. Planes B: the same bits with and without FMA. With n the bounds' larger side in
    ///             1/256 texel and m the sum of the depth's and the two slopes' magnitudes over the bounds, a sample is
    ///             within 2^-48 n m of the plane through the snapped vertices
    void set_up(const texel_bounds& bounds, cull_mode cull) {
        on_best_isa([&](auto) UMBRAGE_INLINE {
            set_up_bounds(bounds);
            set_up_areas(cull);
            set_up_planes();
            for (int k = 0; k < 3; ++k) set_up_edge(k);
        });
    }

    [[nodiscard]] UMBRAGE_INLINE depth_plane plane(int i) const {
        const double a = z_[0][i], b = z_[1][i], c = z_[2][i];
        const double low = a < b ? a : b, high = a < b ? b : a;
        return {{first_x[i], first_y[i]}, depth_[i], dx_[i], dy_[i], low < c ? low : c, high < c ? c : high};
    }

    /// Whether 32 bits hold the edges over the triangle's bounds, and some texels beyond.
    [[nodiscard]] UMBRAGE_INLINE bool is_small(int i) const { return side_[i] < 2048 * subtexels; }

    /// An edge / 256 at a texel; inside where that is not negative.
    [[nodiscard]] UMBRAGE_INLINE std::int64_t edge_at(int k, int i, int x, int y) const {
        const std::int64_t step_x = right[k][i], step_y = up[k][i];
        const std::int64_t e =
            step_y * (y * subtexels + centre - y_[k][i]) + step_x * (x * subtexels + centre - x_[k][i]);
        return (e - is_open(step_x, step_y)) >> 8;
    }

    /// @param row   (int y, int first, int last): texels first <= x < last of row y are covered; there is at least one
    template <class Row>
    UMBRAGE_INLINE void for_each_row(int i, const Row& row) const {
        // Of an edge's value its sign: from texel `at` on, the first of the row where it is not negative, the
        // triangle begins or has ended. From row to row it moves as far as the edge does, so that no row is searched.
        struct side {
            bool begins;
            std::int64_t value, step, step_up;
            int at = 0;
        } sides[3];
        for (int k = 0; k < 3; ++k) {
            const std::int64_t value = edge_at(k, i, first_x[i], first_y[i]), r = right[k][i], u = up[k][i];
            if (r > 0) sides[k] = {true, value, r, u};
            else sides[k] = {false, -1 - value, -r, -u};
        }
        const int width = columns[i];
        for (int y = 0; y < rows[i]; ++y) {
            int first = 0, last = width;
            for (side& s : sides) {
                for (; s.at > 0 && s.value >= s.step; s.value -= s.step) --s.at;
                for (; s.at < width && s.value < 0; s.value += s.step) ++s.at;
                if (s.begins) first = std::max(first, s.at);
                else last = std::min(last, s.at);
                s.value += s.step_up;
            }
            if (first < last) row(first_y[i] + y, first_x[i] + first, first_x[i] + last);
        }
    }

private:
    using bits = std::int64_t;
    static constexpr int centre = subtexels / 2;

    /// Right edges, and bottom ones.
    template <class Int>
    [[nodiscard]] static UMBRAGE_INLINE Int is_open(Int right_step, Int up_step) {
        return Int(right_step < 0) | (Int(right_step == 0) & Int(up_step > 0));
    }

    /// The smallest vertex first, so that results do not depend on the order in the mesh; texels within the bounds.
    UMBRAGE_INLINE void set_up_bounds(const texel_bounds& bounds) {
        const int min_x = bounds.first.x, min_y = bounds.first.y, max_x = bounds.last.x - 1, max_y = bounds.last.y - 1;
        for (int i = 0; i < block; ++i) {
            const std::int32_t ax = x_[0][i], bx = x_[1][i], cx = x_[2][i], ay = y_[0][i], by = y_[1][i], cy = y_[2][i];
            const std::int32_t b_first = -std::int32_t((bx < ax) | ((bx == ax) & (by < ay)));
            const std::int32_t x = b_first ? bx : ax, y = b_first ? by : ay;
            const std::int32_t c_first = -std::int32_t((cx < x) | ((cx == x) & (cy < y)));
            const auto pick = [=](std::int32_t p, std::int32_t q, std::int32_t r) UMBRAGE_INLINE {
                const std::int32_t of_two = b_first ? q : p;
                return c_first ? r : of_two;
            };
            second_is_first_[i] = b_first & ~c_first;
            third_is_first_[i] = c_first;
            x_[0][i] = pick(ax, bx, cx), x_[1][i] = pick(bx, cx, ax), x_[2][i] = pick(cx, ax, bx);
            y_[0][i] = pick(ay, by, cy), y_[1][i] = pick(by, cy, ay), y_[2][i] = pick(cy, ay, by);

            const std::int32_t left = std::min(std::min(ax, bx), cx), end = std::max(std::max(ax, bx), cx);
            const std::int32_t bottom = std::min(std::min(ay, by), cy), top = std::max(std::max(ay, by), cy);
            width_[i] = end - left, height_[i] = top - bottom;
            side_[i] = std::max(end - left, top - bottom);
            const std::int32_t from_x = std::max((left + subtexels - 1 - centre) >> 8, min_x);
            const std::int32_t from_y = std::max((bottom + subtexels - centre) >> 8, min_y);
            const std::int32_t to_x = std::min((end - centre) >> 8, max_x), to_y = std::min((top - centre) >> 8, max_y);
            first_x[i] = from_x, first_y[i] = from_y;
            columns[i] = to_x - from_x + 1;
            rows[i] = (to_y - from_y + 1) & -std::int32_t((to_x >= from_x) & (to_y >= from_y));
        }
        for (int i = 0; i < block; ++i) {
            const bits second = second_is_first_[i], third = third_is_first_[i];
            const bits a = bit_cast<bits>(z_[0][i]), b = bit_cast<bits>(z_[1][i]), c = bit_cast<bits>(z_[2][i]);
            const auto pick = [=](bits p, bits q, bits r) UMBRAGE_INLINE {
                return bit_cast<double>((p & ~(second | third)) | (q & second) | (r & third));
            };
            z_[0][i] = pick(a, b, c), z_[1][i] = pick(b, c, a), z_[2][i] = pick(c, a, b);
        }
    }

    UMBRAGE_INLINE void set_up_areas(cull_mode cull) {
        const bits keep_front = -bits(cull != cull_mode::front), keep_back = -bits(cull != cull_mode::back);
        for (int i = 0; i < block; ++i) {
            const double x1 = x_[1][i] - x_[0][i], y1 = y_[1][i] - y_[0][i];
            const double x2 = x_[2][i] - x_[0][i], y2 = y_[2][i] - y_[0][i];
            area_[i] = x1 * y2 - x2 * y1;
        }
        for (int i = 0; i < block; ++i) {
            const bits area = bit_cast<bits>(area_[i]), clockwise = -bits(area < 0);
            const bits kept = -bits(area != 0) & ((keep_back & clockwise) | (keep_front & ~clockwise));
            clockwise_[i] = static_cast<std::int32_t>(clockwise);
            rows[i] &= static_cast<std::int32_t>(kept);
        }
    }

    UMBRAGE_INLINE void set_up_edge(int k) {
        const auto &ax = x_[k], &ay = y_[k], &bx = x_[k == 2 ? 0 : k + 1], &by = y_[k == 2 ? 0 : k + 1];
        for (int i = 0; i < block; ++i) {
            const std::int32_t turn = clockwise_[i];  // the other way round all signs change
            const std::int32_t step_x = ((ay[i] - by[i]) ^ turn) - turn, step_y = ((bx[i] - ax[i]) ^ turn) - turn;
            right[k][i] = step_x, up[k][i] = step_y;
            per_row[k][i] = -1.0f / static_cast<float>(step_y | std::int32_t(step_y == 0));
            const double e = double(step_y) * (first_y[i] * subtexels + centre - ay[i]) +
                             double(step_x) * (first_x[i] * subtexels + centre - ax[i]) - is_open(step_x, step_y);
            // As an integer, of which the lower 51 bits are kept, without its last 8.
            edge[k][i] = static_cast<std::int32_t>(bit_cast<std::uint64_t>(e + 0x1.8p52) >> 8);
        }
    }

    UMBRAGE_INLINE void set_up_planes() {
        constexpr bits exponent = 0x7FF0000000000000, magnitude = 0x7FFFFFFFFFFFFFFF, short_digits = ~bits(0x3FFFFFF);
        constexpr bits tiny = bit_cast<bits>(0x1p-200);
        const auto power_of_two = [](double a, double b, double c) UMBRAGE_INLINE {  // the largest's, rounded down
            const bits p = bit_cast<bits>(a) & exponent, q = bit_cast<bits>(b) & exponent;
            const bits r = bit_cast<bits>(c) & exponent;
            const bits largest = p < q ? q : p, other = r < tiny ? tiny : r;
            return bit_cast<double>(largest < other ? other : largest);
        };
        const auto one_over = [](double power) UMBRAGE_INLINE {
            return bit_cast<double>((bits(2046) << 52) - bit_cast<bits>(power));
        };
        const auto truncate = [](double v) UMBRAGE_INLINE {  // |v| < 2^52; GCC has no vectors of trunc() for AVX2
            const double size = masked(v, magnitude), near = (size + 0x1p52) - 0x1p52;
            const double whole = near - masked(1.0, -bits(near > size));
            return bit_cast<double>(bit_cast<bits>(whole) | (bit_cast<bits>(v) & ~magnitude));
        };
        for (int i = 0; i < block; ++i) {
            const double x1 = x_[1][i] - x_[0][i], y1 = y_[1][i] - y_[0][i];
            const double x2 = x_[2][i] - x_[0][i], y2 = y_[2][i] - y_[0][i];
            const double per_area = 1.0 / area_[i];

            // Depths with so few digits that the products with x1 .. y2 and their differences need no rounding.
            double unit = power_of_two(z_[0][i], z_[1][i], z_[2][i]) * masked(double(side_[i]), exponent) * 0x1p-49;
            double units = one_over(unit);
            const double z0 = truncate(z_[0][i] * units) * unit;
            const double z1 = truncate(z_[1][i] * units) * unit;
            const double z2 = truncate(z_[2][i] * units) * unit;
            const double slope_x = ((z1 - z0) * y2 + (z2 - z0) * -y1) * per_area;
            const double slope_y = ((z2 - z0) * x1 + (z1 - z0) * -x2) * per_area;

            // Slopes with so few digits that the same holds for every sample; here for the products.
            const double reach = masked(z0, magnitude) + masked(slope_x, magnitude & short_digits) * double(width_[i]) +
                                 masked(slope_y, magnitude & short_digits) * double(height_[i]);
            unit = power_of_two(reach, 0.0, 0.0) * 0x1p-51;
            units = one_over(unit);
            const double dx = truncate(slope_x * units) * unit;
            const double dy = truncate(slope_y * units) * unit;
            depth_[i] = truncate(z0 * units) * unit + dx * (first_x[i] * subtexels + centre - x_[0][i]) +
                        dy * (first_y[i] * subtexels + centre - y_[0][i]);
            dx_[i] = dx * subtexels;
            dy_[i] = dy * subtexels;
            z_[0][i] = z0, z_[1][i] = z1, z_[2][i] = z2;
        }
    }

    alignas(64) std::int32_t x_[3][block], y_[3][block];
    alignas(64) double z_[3][block];
    alignas(64) std::int32_t second_is_first_[block], third_is_first_[block], clockwise_[block];  // masks
    alignas(64) std::int32_t width_[block], height_[block], side_[block];  // in 1/256 texel; the larger of both
    alignas(64) double area_[block], depth_[block], dx_[block], dy_[block];
};

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH

// ---- umbrage/simd/raster/depth_writer.hpp
// Triangles into a depth image: the nearer of what is there and the plane's depth, in columns of some texels' width.
//
//     draw<true>(depth, flipped, batch);
//

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// @tparam Lanes  texels side by side, two registers of doubles
template <bool Forward, int Lanes>
class depth_writer {
public:
    UMBRAGE_INLINE depth_writer(image_view<float> depth, bool flipped)
        : bottom_(reinterpret_cast<std::byte*>(depth.row(flipped ? depth.size.y - 1 : 0))),
          up_(flipped ? -depth.stride : depth.stride),
          width_(depth.size.x),
          skew_(static_cast<int>(reinterpret_cast<std::uintptr_t>(bottom_) / sizeof(float) % Lanes)) {}

    /// Prefetches the texels of a triangle: their latency is about the time that it takes to draw another small one.
    UMBRAGE_INLINE void expect(const triangles& batch, int i) const {
        const int last = batch.first_y[i] + std::min(batch.rows[i], 16);
        for (int y = batch.first_y[i]; y < last; ++y) prefetch_line(row(y) + batch.first_x[i]);
    }

    UMBRAGE_INLINE void draw(const triangles& batch, int i) const {
        if (batch.rows[i] == 0) return;
        const depth_plane plane = batch.plane(i);
        if (Forward ? plane.lowest > 1.0 : plane.highest < 0.0) return;
        if constexpr (has_lanes)  // depths of one sign, and none that is flushed: their bits are in their order
            if (width_ >= Lanes && plane.lowest >= 0x1p-126 && plane.highest <= 1.0)
                return draw_columns(batch, i, plane);
        draw_rows(batch, i, plane);
    }

private:
    using ints = lanes_of<std::int32_t, Lanes>;
    using floats = lanes_of<float, Lanes>;
    using doubles = lanes_of<double, Lanes / 2>;

    static constexpr int tile_columns = 64, tile_rows = 32, few_rows = 16;

    /// The nearer depth of each lane, but what is there where it is a NaN, or where `outside` is negative.
    /// @param depth   no NaN, not 0
    UMBRAGE_INLINE static void take_nearer(const floats& depth, const ints& outside, floats& there) {
        const ints bits = reinterpret_cast<ints>(depth), mask = outside >> 31;
        if constexpr (finite_math_only) {
            const ints old = reinterpret_cast<ints>(there);
            const ints kept = mask | ((old & 0x7FFFFFFF) > 0x7F800000) | (Forward ? depth > there : depth < there);
            there = reinterpret_cast<floats>((bits & ~kept) | (old & kept));
        } else {
            const auto seen = reinterpret_cast<floats>(bits | mask);  // or a NaN, which is not nearer
            there = (Forward ? seen < there : seen > there) ? seen : there;
        }
    }

    /// Texel by texel.
    void draw_rows(const triangles& batch, int i, const depth_plane& plane) const {
        batch.for_each_row(i, [&](int y, int first, int last) {
            float* const texels = row(y);
            for (int x = first; x < last; ++x) {
                const double z = plane(x, y);
                if (!(z >= 0.0 && z <= 1.0)) continue;
                const float stored = z > 0.0 ? static_cast<float>(z) : 0.0f;
                if (!is_nan(texels[x]) && (Forward ? stored <= texels[x] : stored >= texels[x])) texels[x] = stored;
            }
        });
    }

    /// Column by column, in rows of a block each; the depths are within (0, 1] and normal numbers.
    UMBRAGE_INLINE void draw_columns(const triangles& batch, int i, const depth_plane& plane) const {
        // Columns begin where blocks do in memory: what two triangles share is then whole blocks, which the processor
        // hands from a store to the next load.
        const int first_x = batch.first_x[i], first_y = batch.first_y[i], rows = batch.rows[i];
        const int from = ((first_x + skew_) & -Lanes) - skew_, end = first_x + batch.columns[i];
        const std::int32_t right[] = {batch.right[0][i], batch.right[1][i], batch.right[2][i]};
        const std::int32_t up[] = {batch.up[0][i], batch.up[1][i], batch.up[2][i]};
        const ints lowest = bit_cast<std::int32_t>(static_cast<float>(plane.lowest)) + ints{};
        const ints highest = bit_cast<std::int32_t>(static_cast<float>(plane.highest)) + ints{};
        ints ramp;
        count_lanes<std::int32_t, Lanes>(ramp);
        doubles ramp_low;
        count_lanes<double, Lanes / 2>(ramp_low);

        // Texels x .. x_end - 1 of `height` rows; e: the edges at x and y.
        const double dx = plane.dx, dy = plane.dy, corner = plane.z;
        const std::int32_t up0 = up[0], up1 = up[1], up2 = up[2];
        const std::ptrdiff_t stride = up_;
        const auto draw_tile = [&](int x, int y, int x_end, int height, const std::int32_t(&e)[3]) UMBRAGE_INLINE {
            ints e0 = right[0] * ramp + e[0], e1 = right[1] * ramp + e[1], e2 = right[2] * ramp + e[2];
            for (; x < x_end; x += Lanes, e0 += right[0] * Lanes, e1 += right[1] * Lanes, e2 += right[2] * Lanes) {
                int first = 0, last = height;
                if (height > few_rows) {
                    // Rows in which a texel of the column can be inside all edges, or one more on either side.
                    float low = 0.0f, high = static_cast<float>(height);
                    const std::int32_t start[] = {e0[0], e1[0], e2[0]};
                    for (int k = 0; k < 3; ++k) {
                        const std::int32_t best = start[k] + std::max(0, right[k] * (Lanes - 1));
                        const float crossed = static_cast<float>(best) * batch.per_row[k][i];
                        low = up[k] > 0 && crossed > low ? crossed : low;
                        high = up[k] < 0 && crossed < high ? crossed : high;
                    }
                    first = static_cast<int>(low + 0.99f), last = std::min(static_cast<int>(high + 1.01f), height);
                    if (first >= last) continue;  // and no step to a first row far beyond the tile
                }
                // At the image's borders other texels, as many, which get the same bits again.
                const int within = std::min(std::max(x, 0), width_ - Lanes), moved = within - x;
                ints f0 = e0, f1 = e1, f2 = e2;
                const double z = corner + dy * (y + first - first_y);
                if ((moved | first) != 0) {
                    f0 += right[0] * moved + up[0] * first;
                    f1 += right[1] * moved + up[1] * first;
                    f2 += right[2] * moved + up[2] * first;
                }
                doubles z_low = z + dx * (ramp_low + double(within - first_x));
                doubles z_high = z + dx * (ramp_low + double(within - first_x + Lanes / 2));
                std::byte* at = reinterpret_cast<std::byte*>(row(y + first) + within);
                for (int rest = last - first; rest > 0; --rest, at += stride) {
                    floats rounded, there;
                    narrow_lanes<float, Lanes>(z_low, z_high, rounded);
                    ints here = reinterpret_cast<ints>(rounded);
                    here = here < lowest ? lowest : here;
                    here = here > highest ? highest : here;
                    load_lanes(at, there);
                    take_nearer(reinterpret_cast<floats>(here), f0 | f1 | f2, there);
                    store_lanes(there, at);
                    f0 += up0, f1 += up1, f2 += up2;
                    z_low += dy, z_high += dy;
                }
            }
        };
        std::int32_t e[3];
        if (batch.is_small(i)) {
            for (int k = 0; k < 3; ++k) e[k] = batch.edge[k][i] + right[k] * (from - first_x);
            return draw_tile(from, first_y, end, rows, e);
        }
        for (int y = first_y; y < first_y + rows; y += tile_rows)
            for (int x = from; x < end; x += tile_columns) {
                for (int k = 0; k < 3; ++k) {  // as near to 0 as a tile's steps leave the sign
                    constexpr std::int64_t limit = 1 << 30;
                    e[k] = static_cast<std::int32_t>(std::clamp(batch.edge_at(k, i, x, y), -limit, limit));
                }
                draw_tile(x, y, std::min(x + tile_columns, end), std::min(first_y + rows - y, tile_rows), e);
            }
    }

    [[nodiscard]] UMBRAGE_INLINE float* row(int y) const { return reinterpret_cast<float*>(bottom_ + y * up_); }

    std::byte* bottom_;
    std::ptrdiff_t up_;
    int width_, skew_;
};

template <bool Forward>
void draw(image_view<float> depth, bool flipped, const triangles& batch) {
    on_best_isa([&](auto set) UMBRAGE_INLINE {
        constexpr isa in_use = decltype(set)::value;
        constexpr int lanes = in_use == isa::base ? 4 : in_use == isa::avx2 ? 8 : 16;
        const depth_writer<Forward, lanes> writer(depth, flipped);
        for (int i = 0; i < batch.count; ++i) {
            if (i + 1 < batch.count) writer.expect(batch, i + 1);
            writer.draw(batch, i);
        }
    });
}

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH

// ---- umbrage/simd/raster/clip.hpp
// The part of a triangle that can be drawn: in front of the near plane, within the guard band.
//
//     clipped_polygon polygon = clip_triangle(project, a, b, c);
//

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// A convex polygon on the grid, its smallest vertex first: a fan around that vertex is the same whichever vertex
/// of the triangle came first, and whichever way round they went.
struct clipped_polygon {
    std::array<snapped_vertex, 3 + projection::planes> vertices;
    int count = 0;  ///< 0 or 3..9
};

/// On which side of the near plane a polygon is to be. Both sides cut an edge at the same point.
enum class near_side { behind, before };

/// The part of a triangle inside all planes, or of the near plane outside, where snap() gives it that plane's depth.
/// @param a,b,c   homogeneous texels
/// @param planes  a bit for each plane to clip against; those that all three points are inside of may be left out
[[nodiscard]] inline clipped_polygon clip_triangle(const projection& project, const glm::dvec4& a, const glm::dvec4& b,
                                                   const glm::dvec4& c, unsigned planes = ~0u,
                                                   near_side side = near_side::behind) {
    std::array<glm::dvec4, 3 + projection::planes> points{a, b, c};
    int count = 3;
    for (int plane = 0; plane < projection::planes; ++plane) {
        if (!(planes >> plane & 1u)) continue;
        const auto before = points;
        const int count_before = count;
        count = 0;
        for (int i = 0; i < count_before; ++i) {
            const auto& p = before[std::size_t(i)];
            const auto& q = before[std::size_t(i + 1 < count_before ? i + 1 : 0)];
            const bool p_inside = !(project.distance(plane, p) < 0.0), q_inside = !(project.distance(plane, q) < 0.0);
            const bool keeps_inside = plane != projection::z_near || side == near_side::behind;
            if (p_inside == keeps_inside) points[std::size_t(count++)] = p;
            if (p_inside != q_inside && count < int(points.size()))
                points[std::size_t(count++)] = p_inside ? project.cut(plane, p, q) : project.cut(plane, q, p);
        }
    }
    clipped_polygon polygon;
    if (count < 3) return polygon;
    polygon.count = count;
    for (int i = 0; i < count; ++i) polygon.vertices[std::size_t(i)] = project.snap(points[std::size_t(i)]);
    const auto last = polygon.vertices.begin() + count;
    std::rotate(polygon.vertices.begin(), std::min_element(polygon.vertices.begin(), last), last);
    return polygon;
}

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH

// ---- umbrage/simd/raster/snapped_chunk.hpp
// Some triangles of a mesh in some instances, their vertices projected and snapped: what fits a cache at a time.
//
//     snapped_chunk chunk(mesh, projections);
//     chunk.take(first_triangle, first_instance, 1 << 16);
//     chunk.snap(serial{});
//     for (unsigned i = 0; i < chunk.count(); ++i) use(chunk.vertex(chunk.place_of(i), 0));
//
// Triangles are counted on from one instance to the next, and so are vertices.
//

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// Room for vertices, each written before it is read: a vector would write them twice. (<memory>, which has a class
/// for this, brings the streams along.)
class unwritten_vertices {
public:
    unwritten_vertices() = default;
    unwritten_vertices(const unwritten_vertices&) = delete;
    unwritten_vertices& operator=(const unwritten_vertices&) = delete;
    ~unwritten_vertices() { delete[] data_; }

    /// Of which nothing is kept.
    void make(std::size_t count) {
        if (count <= count_) return;
        delete[] data_;
        data_ = nullptr;
        data_ = new snapped_vertex[count];
        count_ = count;
    }
    [[nodiscard]] snapped_vertex* data() { return data_; }
    [[nodiscard]] const snapped_vertex& operator[](std::size_t i) const { return data_[i]; }

private:
    snapped_vertex* data_ = nullptr;
    std::size_t count_ = 0;
};

struct index_range {
    unsigned lowest, highest;
};

[[nodiscard]] inline index_range indices_of(std::span<const glm::uvec3> triangles) {
    index_range range{~0u, 0u};
    on_best_isa([&](auto) UMBRAGE_INLINE {
        const glm::uvec3* t = triangles.data();
        const glm::uvec3* const last = t + triangles.size();
        unsigned low = ~0u, high = 0;
        for (; last - t >= block; t += block)
            for (int i = 0; i < block; ++i)
                for (glm::length_t k = 0; k < 3; ++k) {
                    low = low < t[i][k] ? low : t[i][k];
                    high = high < t[i][k] ? t[i][k] : high;
                }
        for (; t < last; ++t)
            for (glm::length_t k = 0; k < 3; ++k) low = std::min(low, (*t)[k]), high = std::max(high, (*t)[k]);
        range = {low, high};
    });
    return range;
}

/// Of a chunk: which instance of those in it, and which triangle of the mesh.
struct drawn_triangle {
    std::size_t instance, triangle;
};

class snapped_chunk {
public:
    explicit snapped_chunk(const mesh_view& mesh) : mesh_(mesh) {}

    /// From a triangle and an instance on: the rest of the mesh, and as many instances more as `most` has room for, or
    /// `most` triangles.
    /// @param instances   those from that instance on, at least one
    void take(std::size_t first, std::span<const projection> instances, std::size_t most) {
        first_ = first;
        triangles_ = std::min(most, mesh_.triangles.size() - first);
        const auto [lowest, highest] = indices_of(mesh_.triangles.subspan(first_, triangles_));
        const std::size_t corners = 3 * triangles_, range = std::size_t(highest) - lowest + 1;
        by_corner_ = corners < range;
        lowest_ = lowest;
        used_ = std::min(corners, range);
        stride_ = (used_ + block - 1) / block * block;
        const bool whole = triangles_ == mesh_.triangles.size();
        const std::size_t room = whole ? std::max(most / std::max(triangles_, stride_), std::size_t(1)) : 1;
        instances_ = instances.first(std::min(room, instances.size()));
    }

    [[nodiscard]] std::size_t instances() const { return instances_.size(); }
    [[nodiscard]] unsigned count() const { return static_cast<unsigned>(triangles_ * instances_.size()); }

    template <class ParallelFor>
    void snap(ParallelFor&& parallel) {
        const std::size_t blocks = stride_ / block * instances_.size();
        vertices_.make(blocks * block);
        constexpr std::size_t piece = 64;  // that a thread takes at a time
        parallel(static_cast<int>((blocks + piece - 1) / piece), [&](int begin, int end) {
            for (std::size_t i = std::size_t(begin) * piece; i < std::min(std::size_t(end) * piece, blocks); ++i) {
                const std::size_t instance = i * block / stride_, vertex = i * block - instance * stride_;
                alignas(64) glm::vec3 positions[block];
                for (std::size_t k = 0; k < block; ++k) positions[k] = position(std::min(vertex + k, used_ - 1));
                instances_[instance].snap(positions, vertices_.data() + i * block);
            }
        });
    }

    /// @param i   below count()
    [[nodiscard]] UMBRAGE_INLINE drawn_triangle place_of(unsigned i) const {
        if (instances_.size() == 1) return {0, first_ + i};
        const unsigned triangles = static_cast<unsigned>(triangles_), instance = i / triangles;
        return {instance, first_ + (i - instance * triangles)};
    }

    [[nodiscard]] UMBRAGE_INLINE const snapped_vertex& vertex(const drawn_triangle& at, glm::length_t corner) const {
        const std::size_t vertex = by_corner_ ? 3 * (at.triangle - first_) + std::size_t(corner)
                                              : std::size_t(mesh_.triangles[at.triangle][corner] - lowest_);
        return vertices_[at.instance * stride_ + vertex];
    }

    /// A corner before it was snapped.
    [[nodiscard]] glm::dvec4 homogeneous(const drawn_triangle& at, glm::length_t corner) const {
        return instances_[at.instance].homogeneous(mesh_.positions[mesh_.triangles[at.triangle][corner]]);
    }
    [[nodiscard]] const projection& projection_of(const drawn_triangle& at) const { return instances_[at.instance]; }

private:
    [[nodiscard]] const glm::vec3& position(std::size_t i) const {
        if (!by_corner_) return mesh_.positions[lowest_ + i];
        return mesh_.positions[mesh_.triangles[first_ + i / 3][glm::length_t(i % 3)]];
    }

    mesh_view mesh_;
    std::span<const projection> instances_;
    std::size_t first_ = 0, triangles_ = 0;
    std::size_t used_ = 0, stride_ = 0;  // vertices of an instance, and in whole blocks
    unsigned lowest_ = 0;                // index
    bool by_corner_ = false;             // three vertices a triangle, rather than a range of the mesh's
    unwritten_vertices vertices_;
};

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH

// ---- umbrage/simd/raster/snapped_mesh.hpp
// Instances of a mesh on the grid of an image, some ten thousand triangles at a time: their vertices projected and
// snapped, they themselves clipped and handed out in batches, in the mesh's order or band by band of the image's rows.
//
//     snapped_mesh snapped(size, mesh, {&world_to_clip, 1}, clip, cull_mode::none, near_plane::clips);
//     snapped.for_each_chunk(serial{}, [&] {
//         snapped.for_each_batch([&](const triangles& batch) { ... });
//     });
//

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// The triangles of a mesh, once for each of some matrices, chunk by chunk.
class snapped_mesh {
public:
    /// @param to_clip   of each instance; those that are not finite draw nothing
    /// @throws std::invalid_argument  an index is out of range; a side of the image is above guard_band
    snapped_mesh(glm::ivec2 size, const mesh_view& mesh, std::span<const glm::mat4> to_clip, clip_space clip,
                 cull_mode cull, near_plane at_near)
        : mesh_(mesh), size_(size), cull_(cull), at_near_(at_near), chunk_(mesh) {
        require_drawable(size);
        if (mesh.triangles.empty()) return;
        if (indices_of(mesh.triangles).highest >= mesh.positions.size())
            detail::fail("umbrage::rasterize: a triangle's index is out of range");
        if (size.x == 0 || size.y == 0) return;
        for (const glm::mat4& matrix : to_clip)
            if (all_finite(matrix)) instances_.emplace_back(matrix, clip, size);
    }
    snapped_mesh(const snapped_mesh&) = delete;
    snapped_mesh& operator=(const snapped_mesh&) = delete;

    /// @param use   (), which draws the chunk
    template <class ParallelFor, class Use>
    void for_each_chunk(ParallelFor&& parallel, const Use& use) {
        // As many vertices as a cache holds; with threads more, which are then started less often.
        constexpr std::size_t step = is_serial<ParallelFor> ? 1 << 16 : 1 << 20;
        for (std::size_t instance = 0; instance < instances_.size(); instance += chunk_.instances())
            for (std::size_t first = 0; first < mesh_.triangles.size(); first += step) {
                chunk_.take(first, std::span<const projection>(instances_).subspan(instance), step);
                chunk_.snap(parallel);
                use();
            }
    }

    /// The chunk in the mesh's order, all over the image.
    /// @param draw   (const triangles&)
    template <class Draw>
    void for_each_batch(const Draw& draw) const {
        for_each_batch(
            {{0, 0}, size_}, chunk_.count(), [](std::size_t k) { return unsigned(k); }, draw);
    }

    /// The chunk band by band, where that keeps texels in the cache or lets threads draw side by side; else as above.
    template <class ParallelFor, class Draw>
    void for_each_batch_in_bands(ParallelFor&& parallel, const Draw& draw) {
        const int rows = std::clamp(band_texels / size_.x, 1, band_rows), bands = (size_.y + rows - 1) / rows;
        if (is_serial<ParallelFor> && (bands == 1 || is_coherent(rows))) return for_each_batch(draw);
        sort_into_bands(rows, bands, parallel);
        parallel(bands, [&](int first, int last) {
            for (int band = first; band < last; ++band) {
                const texel_bounds bounds{{0, band * rows}, {size_.x, std::min((band + 1) * rows, size_.y)}};
                for (std::size_t i = std::size_t(band); i < lists_.size(); i += std::size_t(bands)) {
                    const std::vector<unsigned>& list = lists_[i];
                    const auto next = [&](std::size_t k) {
                        expect(list, k);
                        return list[k];
                    };
                    for_each_batch(bounds, list.size(), next, draw);
                }
            }
        });
    }

private:
    template <class ParallelFor>
    static constexpr bool is_serial = std::is_same_v<std::remove_cvref_t<ParallelFor>, serial>;
    static constexpr int band_texels = 1 << 16, band_rows = 64;
    static constexpr unsigned piece = 1 << 16;  // triangles that one thread sorts at a time

    [[nodiscard]] static unsigned planes_crossed(const snapped_vertex& a, const snapped_vertex& b,
                                                 const snapped_vertex& c) {
        return planes_outside(a) | planes_outside(b) | planes_outside(c);
    }

    /// What is drawn of a triangle that crosses planes: the part behind the near plane, and where that clamps the part
    /// before it; nothing where it is outside of another plane, or not finite.
    /// @param use   (const clipped_polygon&), of three vertices or more
    template <class Use>
    void for_each_part(const drawn_triangle& at, const snapped_vertex& a, const snapped_vertex& b,
                       const snapped_vertex& c, unsigned crossed, const Use& use) const {
        constexpr unsigned before = 1u << projection::z_near;
        const unsigned beyond = planes_outside(a) & planes_outside(b) & planes_outside(c);
        if ((beyond & ~before) || (crossed & projection::nowhere)) return;
        const auto h = [&](glm::length_t corner) { return chunk_.homogeneous(at, corner); };
        const auto part = [&](near_side side) {
            const clipped_polygon polygon = clip_triangle(chunk_.projection_of(at), h(0), h(1), h(2), crossed, side);
            if (polygon.count > 0) use(polygon);
        };
        if (!beyond) part(near_side::behind);
        if (at_near_ == near_plane::clamps && (crossed & before)) part(near_side::before);
    }

    /// @param next   (std::size_t k) -> the k-th triangle
    template <class Next, class Draw>
    void for_each_batch(const texel_bounds& bounds, std::size_t count, const Next& next, const Draw& draw) const {
        triangles batch;
        const auto add = [&](const snapped_vertex& a, const snapped_vertex& b, const snapped_vertex& c, unsigned i) {
            batch.add(a, b, c, i);
            if (!batch.full()) return;
            batch.set_up(bounds, cull_);
            draw(batch);
            batch.count = 0;
        };
        for (std::size_t k = 0; k < count; ++k) {
            const drawn_triangle at = chunk_.place_of(next(k));
            const unsigned id = static_cast<unsigned>(at.triangle);
            const snapped_vertex &a = chunk_.vertex(at, 0), &b = chunk_.vertex(at, 1), &c = chunk_.vertex(at, 2);
            if (const unsigned crossed = planes_crossed(a, b, c)) {
                for_each_part(at, a, b, c, crossed, [&](const clipped_polygon& polygon) {
                    for (std::size_t v = 1; int(v) + 1 < polygon.count; ++v)
                        add(polygon.vertices[0], polygon.vertices[v], polygon.vertices[v + 1], id);
                });
            } else {
                add(a, b, c, id);
            }
        }
        if (batch.count == 0) return;
        batch.set_up(bounds, cull_);
        draw(batch);
    }

    /// Whether triangles that follow each other lie in a band's rows, by a look at some.
    [[nodiscard]] bool is_coherent(int rows) const {
        constexpr unsigned looks = 64;
        const unsigned step = std::max(1u, chunk_.count() / looks);
        unsigned near = 0, all = 0;
        for (unsigned i = 0; i + 1 < chunk_.count(); i += step, ++all) {
            const int here = chunk_.vertex(chunk_.place_of(i), 0).y >> 8,
                      next = chunk_.vertex(chunk_.place_of(i + 1), 0).y >> 8;
            near += next - here < rows && here - next < rows;
        }
        return 4 * near >= 3 * all;
    }

    /// Rows that a triangle may cover, from the bottom: first <= y < last, of which there may be none.
    [[nodiscard]] glm::ivec2 rows(unsigned triangle) const {
        const drawn_triangle at = chunk_.place_of(triangle);
        const snapped_vertex &a = chunk_.vertex(at, 0), &b = chunk_.vertex(at, 1), &c = chunk_.vertex(at, 2);
        std::int32_t lowest = std::min({a.y, b.y, c.y}), highest = std::max({a.y, b.y, c.y});
        if (const unsigned crossed = planes_crossed(a, b, c)) {
            lowest = std::numeric_limits<std::int32_t>::max(), highest = std::numeric_limits<std::int32_t>::min();
            for_each_part(at, a, b, c, crossed, [&](const clipped_polygon& polygon) {
                for (std::size_t i = 0; int(i) < polygon.count; ++i) {
                    lowest = std::min(lowest, polygon.vertices[i].y);
                    highest = std::max(highest, polygon.vertices[i].y);
                }
            });
            if (lowest > highest) return {0, 0};
        }
        const auto between = triangles::rows_between(lowest, highest);
        return {std::max(between.x, 0), std::min(between.y, size_.y)};
    }

    template <class ParallelFor>
    void sort_into_bands(int rows_a_band, int bands, ParallelFor&& parallel) {
        const unsigned pieces = (chunk_.count() + piece - 1) / piece;
        for (auto& list : lists_) list.clear();
        lists_.resize(std::size_t(pieces) * std::size_t(bands));
        parallel(static_cast<int>(pieces), [&](int from, int to) {
            for (unsigned i = unsigned(from) * piece; i < std::min(unsigned(to) * piece, chunk_.count()); ++i) {
                auto* const lists = lists_.data() + std::size_t(i / piece) * std::size_t(bands);
                const glm::ivec2 covered = rows(i);
                for (int band = covered.x / rows_a_band; band * rows_a_band < covered.y; ++band)
                    lists[band].push_back(i);
            }
        });
    }

    /// Prefetches what comes after the k-th triangle of a list, whose triangles lie anywhere in the chunk. Inlined for
    /// the reason that prefetch_line() gives.
    UMBRAGE_INLINE void expect(const std::vector<unsigned>& list, std::size_t k) const {
        constexpr std::size_t soon = 16, later = 32;
        if (k + later < list.size()) prefetch_line(&mesh_.triangles[chunk_.place_of(list[k + later]).triangle]);
        if (k + soon >= list.size()) return;
        const drawn_triangle at = chunk_.place_of(list[k + soon]);
        for (glm::length_t corner = 0; corner < 3; ++corner) prefetch_line(&chunk_.vertex(at, corner));
    }

    mesh_view mesh_;
    glm::ivec2 size_;
    cull_mode cull_;
    near_plane at_near_;
    std::vector<projection> instances_;
    snapped_chunk chunk_;
    std::vector<std::vector<unsigned>> lists_;  // of a piece, band by band
};

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH

// ---- umbrage/images/rasterize.hpp
// The depth pass on the CPU: triangles into a depth image, each sample on a shared edge covered exactly once.
//
//     umbrage::image<float> map({1024, 1024}, umbrage::cleared_depth(clip));
//     umbrage::rasterize_depth(map, {positions, triangles}, world_to_clip, clip);
//     umbrage::rasterize_depth(map, tree, model_matrices, world_to_clip, clip);  // a forest; culled: see instances.hpp
//
// A camera pass keeps the nearest triangle of each texel and interpolates afterwards:
//
//     umbrage::rasterize(size, mesh, world_to_clip, clip, [&](glm::ivec2 texel, float z, unsigned triangle) {
//         if (z <= depth[texel]) depth[texel] = z, visible[texel] = triangle;
//     });
//     glm::vec3 weights = umbrage::barycentrics(size, mesh, world_to_clip, clip, texel, visible[texel]);
//
// Vertices are snapped to 1/256 texel, edges are evaluated in integers at texel centres, and ties go by the top-left
// rule (top and left as NDC has them, for either texture origin). Depth is a plane whose coefficients are rounded to a
// grid on which every sample is then computed exactly. So no order of triangles or vertices, no threads and no
// instruction set changes a bit, nor does contraction to FMA, but that it may move a clipped triangle's cut by 1/256
// texel.
//

UMBRAGE_STRICT_MATH
namespace umbrage {
namespace detail {

template <class ParallelFor>
void rasterize_depth(image_view<float> depth, const mesh_view& mesh, std::span<const glm::mat4> to_clip,
                     clip_space clip, cull_mode cull, ParallelFor&& parallel, near_plane at_near) {
    snapped_mesh snapped(depth.size, mesh, to_clip, clip, cull, at_near);
    const bool flipped = clip.origin == texture_origin::top, forward = clip.direction == depth_direction::forward;
    snapped.for_each_chunk(parallel, [&] {
        snapped.for_each_batch_in_bands(parallel, [&](const triangles& batch) {
            if (forward) draw<true>(depth, flipped, batch);
            else draw<false>(depth, flipped, batch);
        });
    });
}

}  // namespace detail

/// Renders triangles into a depth image that holds the cleared depth or an earlier pass.
///
/// @param depth          greatest side 16384; row 0 is where clip.origin says; empty: nothing happens
/// @param mesh           triangles with a NaN or infinite position are left out, as all are if the matrix has one;
///                       those of no area on the 1/256 texel grid cover nothing
/// @param world_to_clip  projection * view
/// @param clip           reversed: greater depths win
/// @param cull           which faces to leave out
/// @param parallel       cuts the work into pieces, see parallel.hpp: vertices, triangles, bands of rows
/// @param at_near        what becomes of what lies before the near plane
/// @throws std::invalid_argument  an index is out of range; a side of the image is above 16384
/// @formula     the nearer of what is there and the plane's depth, ties to the newcomer (the same bits); nothing beyond
///              the far plane; never -0
/// @exactness   coverage A from the snapped vertices on; depth B, see simd/raster/triangles.hpp: set_up
template <class ParallelFor = serial>
void rasterize_depth(image_view<float> depth, const mesh_view& mesh, const glm::mat4& world_to_clip, clip_space clip,
                     cull_mode cull = cull_mode::none, ParallelFor&& parallel = {},
                     near_plane at_near = near_plane::clips) {
    detail::rasterize_depth(depth, mesh, {&world_to_clip, 1}, clip, cull, parallel, at_near);
}

/// The same for many instances of a mesh, whose vertices are not copied.
///
/// @param instances   model to world, a matrix each; those that give a model_to_clip that is not finite draw nothing
/// @exactness         the bits of a pass of the mesh under model_to_clip(world_to_clip, instance) for each, whatever
///                    their order
/// The rest as above.
template <class ParallelFor = serial>
void rasterize_depth(image_view<float> depth, const mesh_view& mesh, std::span<const glm::mat4> instances,
                     const glm::mat4& world_to_clip, clip_space clip, cull_mode cull = cull_mode::none,
                     ParallelFor&& parallel = {}, near_plane at_near = near_plane::clips) {
    std::vector<glm::mat4> to_clip(instances.begin(), instances.end());
    for (glm::mat4& matrix : to_clip) matrix = model_to_clip(world_to_clip, matrix);
    detail::rasterize_depth(depth, mesh, to_clip, clip, cull, parallel, at_near);
}

/// The general form: one call for each covered sample between the near and the far plane, triangle by triangle.
///
/// @param size    of the image in texels, each at most 16384
/// @param sample  (glm::ivec2 texel, float depth, unsigned triangle); does the depth test. Where depths tie, a callee
///                that wants results free of the triangles' order compares the triangles too
/// The rest as for rasterize_depth.
template <class Sample>
void rasterize(glm::ivec2 size, const mesh_view& mesh, const glm::mat4& world_to_clip, clip_space clip, Sample&& sample,
               cull_mode cull = cull_mode::none, near_plane at_near = near_plane::clips) {
    const bool flipped = clip.origin == texture_origin::top;
    detail::snapped_mesh snapped(size, mesh, {&world_to_clip, 1}, clip, cull, at_near);
    snapped.for_each_chunk(serial{}, [&] {
        snapped.for_each_batch([&](const detail::triangles& batch) {
            for (int i = 0; i < batch.count; ++i) {
                const auto plane = batch.plane(i);
                batch.for_each_row(i, [&](int y, int first, int last) {
                    for (int x = first; x < last; ++x)
                        if (const double z = plane(x, y); z >= 0.0 && z <= 1.0)
                            sample(glm::ivec2(x, flipped ? size.y - 1 - y : y), z > 0.0 ? static_cast<float>(z) : 0.0f,
                                   batch.id[i]);
                });
            }
        });
    });
}

}  // namespace umbrage
UMBRAGE_END_STRICT_MATH

// ---- umbrage/images/dual_paraboloid_pass.hpp
// The depth pass of a dual paraboloid map on the CPU.
//
//     for (int map : {0, 1}) umbrage::rasterize_dual_paraboloid(maps[map].view(), cut.view(), light, map);
//

namespace umbrage {

/// Renders distances from the light into one of its two maps.
///
/// @param depth      of light.map_size^2 texels, cleared or of an earlier pass
/// @param mesh       as tessellate cuts it: between its vertices places and distances are straight lines' here
/// @param light      make_dual_paraboloid_light's
/// @param map        0 or 1
/// @throws std::invalid_argument  as rasterize_depth
/// @exactness        of vertices C, square roots in double; then as rasterize_depth
template <class ParallelFor = serial>
void rasterize_dual_paraboloid(image_view<float> depth, const mesh_view& mesh, const light_space<float>& light, int map,
                               ParallelFor&& parallel = {}) {
    const glm::dvec3 position = -glm::dvec3(light.view[3]);
    const glm::dmat4 projection(light.projection);
    std::vector<glm::vec3> placed;
    std::vector<bool> within;  // the map's square, out to whose edges its circle and border go
    placed.reserve(mesh.positions.size());
    within.reserve(mesh.positions.size());
    for (const glm::vec3& p : mesh.positions) {
        const glm::dvec4 h = projection * dual_paraboloid_position(glm::dvec3(p) - position, double(map));
        placed.emplace_back(glm::dvec3(h) / h.w);
        within.push_back(h.w > 0 && glm::length(glm::dvec2(h)) <= h.w);
    }
    std::vector<glm::uvec3> drawn;
    for (const glm::uvec3& t : mesh.triangles) {
        bool is_drawn = false;  // not so with all vertices beyond the circle: directions there are a convex cone's
        for (glm::length_t i = 0; i < 3; ++i) is_drawn = is_drawn || t[i] >= within.size() || within[t[i]];
        if (is_drawn) drawn.push_back(t);
    }
    rasterize_depth(depth, {placed, drawn}, glm::mat4(1), light.clip, cull_mode::none,
                    std::forward<ParallelFor>(parallel));
}

}  // namespace umbrage

// ---- umbrage/simd/blocks/codec.hpp
// Encodings over blocks of 64 depths, in loops that vectorise: bit for bit what their own encode and decode give.
//
//     const auto codec = umbrage::detail::codec_of(umbrage::rg<11>{});
//     codec.encode(depths, texels);
//

namespace umbrage::detail {

/// saturate() as saturate_bits has it, NaN to `highest` or, reversed, to 0.
struct saturated {
    std::int32_t last_kept;  ///< greatest magnitude, as bits, that is not taken for 0

    explicit saturated(depth_direction direction)
        : last_kept(direction == depth_direction::forward ? 0x7FFFFFFF : 0x7F800000) {}
    [[nodiscard]] UMBRAGE_INLINE float operator()(float v, float highest) const {
        const auto bits = bit_cast<std::int32_t>(v);
        return bit_cast<float>(bit_cast<std::int32_t>(saturate_bits(v, highest)) &
                               -std::int32_t((bits & 0x7FFFFFFF) <= last_kept));
    }
    /// to_code: what is 1 or more has the code of the last float below 1.
    [[nodiscard]] UMBRAGE_INLINE std::int32_t code(float depth, float codes) const {
        return static_cast<std::int32_t>((*this)(depth, 0x1.fffffep-1f) * codes);
    }
};

/// Any encoding, texel by texel.
template <class Encoding>
struct codec {
    using texel = typename Encoding::texel;
    Encoding encoding;

    UMBRAGE_INLINE void encode(const float* depth, texel* texels) const {
        for (int i = 0; i < block; ++i) texels[i] = encoding.encode(depth[i]);
    }
    UMBRAGE_INLINE void decode(const texel* texels, float* depth) const {
        for (int i = 0; i < block; ++i) depth[i] = encoding.decode(texels[i]);
    }
};
template <class Encoding>
[[nodiscard]] codec<Encoding> codec_of(const Encoding& encoding) {
    return {encoding};
}

/// rg of any number of bits. Texels are 16-bit words, so that twice as many fit a register.
struct rg_codec {
    using texel = glm::u8vec2;
    int bits;
    float edge;
    saturated saturate_depth;

    /// R | G << 8 to what this machine has in memory, and back.
    static UMBRAGE_INLINE std::uint16_t in_memory(std::uint16_t word) {
        if constexpr (std::endian::native == std::endian::little) return word;
        else return static_cast<std::uint16_t>(word << 8 | word >> 8);
    }
    UMBRAGE_INLINE void encode(const float* depth, texel* texels) const {
        const saturated s = saturate_depth;  // copies: as far as a compiler knows, texels may overwrite the others
        const auto codes = static_cast<float>(1 << bits);
        const auto up = static_cast<std::uint16_t>(1 << (16 - bits));
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            const auto x = static_cast<std::uint16_t>(s.code(depth[i], codes));
            const std::uint16_t word = in_memory(static_cast<std::uint16_t>((x & 0xFF) | (x & 0xFF00) * up));
            std::memcpy(static_cast<void*>(texels + i), &word, sizeof word);
        }
    }
    UMBRAGE_INLINE void decode(const texel* texels, float* depth) const {
        const float from = edge, step = 1.0f / static_cast<float>(1 << bits);
        const auto up = static_cast<std::uint16_t>(1 << (bits - 8));
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            std::uint16_t word;
            std::memcpy(&word, texels + i, sizeof word);
            word = in_memory(word);
            const auto x = static_cast<std::uint16_t>((word & 0xFF) + (word >> 8) * up);
            depth[i] = (static_cast<float>(x) + from) * step;
        }
    }
};
template <int Bits>
[[nodiscard]] rg_codec codec_of(const rg<Bits>& encoding) {
    return {Bits, encoding.edge, saturated(encoding.direction)};
}

template <>
struct codec<rgb24> {
    using texel = glm::u8vec3;
    rgb24 encoding;

    UMBRAGE_INLINE void encode(const float* depth, texel* texels) const {
        const saturated s(encoding.direction);
        alignas(64) std::int32_t x[block];
        for (int i = 0; i < block; ++i) x[i] = s.code(depth[i], 0x1p24f);
        for (int i = 0; i < block; ++i)
            texels[i] = {static_cast<std::uint8_t>(x[i] >> 16), static_cast<std::uint8_t>(x[i] >> 8 & 0xFF),
                         static_cast<std::uint8_t>(x[i] & 0xFF)};
    }
    UMBRAGE_INLINE void decode(const texel* texels, float* depth) const {
        const float edge = encoding.edge;
        for (int i = 0; i < block; ++i) {
            const std::int32_t x = (texels[i].x << 16) + (texels[i].y << 8) + texels[i].z;
            depth[i] = from_code<24>(static_cast<float>(x), edge);
        }
    }
};

template <>
struct codec<float_bits> {
    static_assert(sizeof(glm::u8vec4) == sizeof(float));
    using texel = glm::u8vec4;
    float_bits encoding;

    UMBRAGE_INLINE void encode(const float* depth, texel* texels) const {
        if constexpr (std::endian::native == std::endian::little)
            std::memcpy(static_cast<void*>(texels), depth, block * sizeof(float));
        else
            for (int i = 0; i < block; ++i) texels[i] = encoding.encode(depth[i]);
    }
    UMBRAGE_INLINE void decode(const texel* texels, float* depth) const {
        if constexpr (std::endian::native == std::endian::little) std::memcpy(depth, texels, block * sizeof(float));
        else
            for (int i = 0; i < block; ++i) depth[i] = encoding.decode(texels[i]);
    }
};

template <>
struct codec<depth32f> {
    using texel = float;
    depth32f encoding;

    UMBRAGE_INLINE void encode(const float* depth, texel* texels) const {
        const saturated s(encoding.direction);
        for (int i = 0; i < block; ++i) texels[i] = s(depth[i], 1.0f);
    }
    UMBRAGE_INLINE void decode(const texel* texels, float* depth) const {
        std::memcpy(depth, texels, block * sizeof(float));
    }
};

}  // namespace umbrage::detail

// ---- umbrage/images/encode.hpp
// Whole depth images into texels of an encoding, and back, about as fast as memory can be copied.
//
//     umbrage::image<glm::u8vec2> packed(depth.size());
//     umbrage::encode(depth, packed, umbrage::rg<11>{});
//
// Bit for bit what the encoding's own encode and decode give. The encodings of this library have loops of their own
// that compilers can vectorise; any other type like them works as well.

namespace umbrage {
namespace detail {

/// A row in blocks; what is left goes through copies as long as a block, by a conversion that may be another.
template <class From, class To, class Convert, class ConvertRest>
UMBRAGE_INLINE inline void convert_row(const From* from, To* to, int count, const Convert& convert,
                                       const ConvertRest& convert_rest) {
    int x = 0;
    for (; x + block <= count; x += block) convert(from + x, to + x);
    if (x == count) return;
    From padded[block]{};
    To result[block];
    std::copy_n(from + x, count - x, padded);
    convert_rest(padded, result);
    std::copy_n(result, count - x, to + x);
}
template <class From, class To, class Convert>
UMBRAGE_INLINE inline void convert_row(const From* from, To* to, int count, const Convert& convert) {
    convert_row(from, to, count, convert, convert);
}

template <class Codec, class ParallelFor>
void encode_rows(image_view<const float> depth, image_view<typename Codec::texel> texels, const Codec& codec,
                 ParallelFor&& parallel) {
    using texel = typename Codec::texel;
    if (depth.size != texels.size) fail("umbrage::encode: sizes differ");
    if (depth.empty()) return;
    const bool large = past_cache(texels);
    parallel(depth.size.y, [&](int first, int last) {
        on_best_isa([&](auto) UMBRAGE_INLINE {
            const auto in_place = [&](const float* from, texel* to) UMBRAGE_INLINE { codec.encode(from, to); };
            const auto past_caches = [&](const float* from, texel* to) UMBRAGE_INLINE {
                alignas(64) texel texels_of_block[block];
                codec.encode(from, texels_of_block);
                stream_block(to, texels_of_block);
            };
            // What is left of a row is copied from where it is put: not past the cache.
            for (int y = first; y < last; ++y) {
                if (large) prefetch_rest(texels.row(y), depth.size.x);
                if (large) convert_row(depth.row(y), texels.row(y), depth.size.x, past_caches, in_place);
                else convert_row(depth.row(y), texels.row(y), depth.size.x, in_place);
            }
        });
        if (large) finish_streaming();
    });
}

template <class Codec, class ParallelFor>
void decode_rows(image_view<const typename Codec::texel> texels, image_view<float> depth, const Codec& codec,
                 ParallelFor&& parallel) {
    if (depth.size != texels.size) fail("umbrage::decode: sizes differ");
    if (depth.empty()) return;
    parallel(depth.size.y, [&](int first, int last) {
        on_best_isa([&](auto) UMBRAGE_INLINE {
            for (int y = first; y < last; ++y)
                convert_row(texels.row(y), depth.row(y), depth.size.x,
                            [&](const auto* from, auto* to) UMBRAGE_INLINE { codec.decode(from, to); });
        });
    });
}

}  // namespace detail

/// @param depth      any values; what the encoding makes of them
/// @param texels     same size, in memory of its own
/// @param encoding   one of the library's (encodings.hpp), or a type like them: texel, encode, decode
/// @param parallel   cuts the rows into pieces, see parallel.hpp
/// @throws std::invalid_argument  sizes differ
template <class Encoding, class ParallelFor = serial>
void encode(image_view<const float> depth, image_view<typename Encoding::texel> texels, const Encoding& encoding,
            ParallelFor&& parallel = {}) {
    static_assert(detail::is_encoding<Encoding>());
    detail::encode_rows(depth, texels, detail::codec_of(encoding), parallel);
}

/// @param texels     any texels of the encoding
/// @param depth      same size, in memory of its own
/// @param parallel   cuts the rows into pieces, see parallel.hpp
/// @throws std::invalid_argument  sizes differ
template <class Encoding, class ParallelFor = serial>
void decode(image_view<const typename Encoding::texel> texels, image_view<float> depth, const Encoding& encoding,
            ParallelFor&& parallel = {}) {
    static_assert(detail::is_encoding<Encoding>());
    detail::decode_rows(texels, depth, detail::codec_of(encoding), parallel);
}

}  // namespace umbrage

// ---- umbrage/images/filter_bounds.hpp
// Bounds of the texels that a filter may touch, for bounds_lit: made once a map, a texture with a fourth of its texels,
// a sixteenth for filters that reach far.
//
//     const auto [bounds, place] = umbrage::make_filter_bounds(map.view(), filter.reach());
//     float lit = umbrage::bounds_lit(umbrage::clamped(bounds), coord, depth - bias, place);
//     if (lit < 0) lit = filter(umbrage::clamped(map), coord, depth - bias);
//

namespace umbrage {

struct filter_bounds {
    image<glm::vec2> bounds;  ///< least and greatest; the least is a NaN where a texel is, the greatest where all are
    glm::vec2 place;          ///< bounds_lit's
};

/// @param map       depths, any values
/// @param reach     of the filter, in texels, 0 .. 256
/// @param border    what counts outside the map, as cleared_depth(direction); none: the nearest texel inside
/// @param parallel  cuts the rows into pieces, see parallel.hpp
/// @throws std::invalid_argument  empty map, another reach
/// @exactness       A: selects, never computes
template <class ParallelFor = serial>
[[nodiscard]] filter_bounds make_filter_bounds(image_view<const float> map, float reach,
                                               std::optional<float> border = {}, ParallelFor&& parallel = {}) {
    if (map.empty() || !(reach >= 0.0f && reach <= 256.0f))
        detail::fail("umbrage::make_filter_bounds: empty map, or reach");
    image<float> ringed;
    if (border) {
        ringed = image<float>(map.size + 2, *border);
        for (int y = 0; y < map.size.y; ++y) std::copy_n(map.row(y), map.size.x, ringed.view().row(y + 1) + 1);
        map = ringed.view();
    }
    const detail::reached_texels reached(reach);
    detail::box_bounds tree(map, reached.count(), parallel);
    const int steps = 256 << tree.level;
    image<glm::vec2> bounds(tree.last + 1);
    for (int y = 0; y <= tree.last.y; ++y)
        std::copy_n(tree.bounds.view().row(y), bounds.size().x, bounds.view().row(y));
    const int first = reached.before() + (tree.cells - 1) * steps + (border ? 256 : 0);
    return {std::move(bounds), {static_cast<float>(first), 1.0f / static_cast<float>(steps)}};
}

}  // namespace umbrage

// ---- umbrage/light/bounds.hpp
// What lights are fitted to: boxes, spheres, a camera's frustum and slices of it, points; and what a frustum has in
// common with a scene.
//
//     umbrage::frustum<float> slice{.position = eye, .direction = ahead, .tan_half_x = 0.8f, .tan_half_y = 0.5f,
//                                   .z_near = 1, .z_far = 20};
//     umbrage::polyhedron seen = umbrage::intersection(slice, umbrage::bounding_box<float>{scene_low, scene_high});
//
// Corners are computed in double, whatever the numbers come in.
//

namespace umbrage {

template <real T>
struct bounding_box {
    glm::vec<3, T> low{T(-1)}, high{T(1)};  ///< low <= high; flat ones are as good
};

template <real T>
struct bounding_sphere {
    glm::vec<3, T> centre{T(0)};
    T radius = T(1);  ///< >= 0
};

/// What a perspective camera sees between two distances: all of it, or a cascade's slice.
template <real T>
struct frustum {
    glm::vec<3, T> position{T(0)};
    glm::vec<3, T> direction{T(0), T(0), T(-1)};  ///< any length > 0
    glm::vec<3, T> up{T(0), T(1), T(0)};          ///< hint; may be parallel to direction
    T tan_half_x = T(1), tan_half_y = T(1);       ///< tangent of half the opening angle, > 0: below 180 degrees
    T z_near = T(0.1), z_far = T(100);            ///< 0 <= z_near < z_far, along direction, finite
};

using eight_corners = std::array<glm::dvec3, 8>;

/// Corners in the order of their numbers' bits: x, y, z high.
/// @throws std::invalid_argument  bounds not finite or empty, which is low above high
template <real T>
[[nodiscard]] eight_corners corners(const bounding_box<T>& box) {
    detail::require(detail::all_finite(box.low) && detail::all_finite(box.high), "bounding_box", "low and high",
                    "must be finite");
    detail::require(!glm::any(glm::greaterThan(box.low, box.high)), "bounding_box", "low", "must not be above high");
    const glm::dvec3 low(box.low), high(box.high);
    eight_corners all;
    for (std::size_t i = 0; i < 8; ++i)
        all[i] = {(i & 1 ? high : low).x, (i & 2 ? high : low).y, (i & 4 ? high : low).z};
    return all;
}

namespace detail {

/// A frustum's directions as columns: to the side, up, along.
template <real T>
[[nodiscard]] glm::dmat3 axes(const frustum<T>& f) {
    constexpr auto function = "frustum";
    require(is_finite(f.tan_half_x) && f.tan_half_x > T(0), function, "tan_half_x", "must be finite and above 0");
    require(is_finite(f.tan_half_y) && f.tan_half_y > T(0), function, "tan_half_y", "must be finite and above 0");
    require(f.z_near >= T(0), function, "z_near", "must not be below 0");
    require(is_finite(f.z_far) && f.z_near < f.z_far, function, "z_far", "must be finite and above z_near");
    const auto view = look_along(glm::dvec3(f.position), glm::dvec3(f.direction), glm::dvec3(f.up), handedness::right,
                                 function, "position");
    return {{view[0][0], view[1][0], view[2][0]},
            {view[0][1], view[1][1], view[2][1]},
            {-view[0][2], -view[1][2], -view[2][2]}};
}

}  // namespace detail

/// Corners in the order of their numbers' bits: right, up, far.
/// @throws std::invalid_argument  a frustum that is none: see its members
template <real T>
[[nodiscard]] eight_corners corners(const frustum<T>& f) {
    const glm::dmat3 axes = detail::axes(f);
    eight_corners all;
    for (std::size_t i = 0; i < 8; ++i) {
        const double z(i & 4 ? f.z_far : f.z_near), x = (i & 1 ? z : -z) * double(f.tan_half_x);
        all[i] = glm::dvec3(f.position) + axes * glm::dvec3(x, (i & 2 ? z : -z) * double(f.tan_half_y), z);
    }
    return all;
}

/// The smallest sphere around a frustum. Its radius comes of planes and angles alone: it keeps its bits however the
/// camera turns and moves.
/// @formula   zc = min(f, (n + f) (1 + t) / 2), r^2 = (f - zc)^2 + f^2 t, t = tan_half_x^2 + tan_half_y^2
/// @throws std::invalid_argument  a frustum that is none
template <real T>
[[nodiscard]] bounding_sphere<double> sphere_around(const frustum<T>& f) {
    const glm::dmat3 axes = detail::axes(f);
    const double x(f.tan_half_x), y(f.tan_half_y), n(f.z_near), z_far(f.z_far), t = x * x + y * y;
    const double centre = glm::min(z_far, (n + z_far) * (1.0 + t) / 2.0), beyond = z_far - centre;
    return {glm::dvec3(f.position) + axes[2] * centre, std::sqrt(beyond * beyond + z_far * z_far * t)};
}

/// A convex body, by its faces.
class polyhedron {
public:
    struct face {
        glm::dvec4 plane;                 ///< dot(plane, (p, 1)) >= 0 inside
        std::vector<glm::dvec3> corners;  ///< none where the body does not reach the plane
    };

    polyhedron() = default;

    template <real T>
    polyhedron(const bounding_box<T>& box) {
        const glm::dvec3 low(box.low), high(box.high);
        add_faces(umbrage::corners(box), {{{1, 0, 0, -low.x},
                                           {-1, 0, 0, high.x},
                                           {0, 1, 0, -low.y},
                                           {0, -1, 0, high.y},
                                           {0, 0, 1, -low.z},
                                           {0, 0, -1, high.z}}});
    }

    template <real T>
    polyhedron(const frustum<T>& f) {
        const glm::dmat3 axes = detail::axes(f);
        const double x(f.tan_half_x), y(f.tan_half_y);
        const auto plane = [&](glm::dvec3 normal, double offset) {
            const glm::dvec3 n = axes * normal;
            return glm::dvec4(n, offset - glm::dot(n, glm::dvec3(f.position)));
        };
        add_faces(umbrage::corners(f),
                  {plane({1, 0, x}, 0), plane({-1, 0, x}, 0), plane({0, 1, y}, 0), plane({0, -1, y}, 0),
                   plane({0, 0, 1}, -double(f.z_near)), plane({0, 0, -1}, double(f.z_far))});
    }

    [[nodiscard]] const std::vector<face>& faces() const { return faces_; }
    [[nodiscard]] bool empty() const { return faces_.empty(); }

    friend polyhedron intersection(const polyhedron& a, const polyhedron& b);

private:
    void add_faces(const eight_corners& c, const std::array<glm::dvec4, 6>& planes) {
        constexpr std::size_t order[6][4]{{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                          {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}};
        for (std::size_t i = 0; i < 6; ++i)
            faces_.push_back({planes[i], {c[order[i][0]], c[order[i][1]], c[order[i][2]], c[order[i][3]]}});
    }

    std::vector<face> faces_;
};

namespace detail {

/// The part of a convex polygon that is inside of a plane.
[[nodiscard]] inline std::vector<glm::dvec3> clipped(const std::vector<glm::dvec3>& polygon, const glm::dvec4& plane) {
    const auto inside = [&](const glm::dvec3& p) { return glm::dot(glm::dvec3(plane), p) + plane.w; };
    std::vector<glm::dvec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 &p = polygon[i], &q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        const double at_p = inside(p), at_q = inside(q);
        if (!(at_p < 0.0)) kept.push_back(p);
        if ((at_p < 0.0) != (at_q < 0.0)) kept.push_back(p + (q - p) * (at_p / (at_p - at_q)));
    }
    return kept;
}

}  // namespace detail

/// What two bodies have in common; empty where that is nothing.
[[nodiscard]] inline polyhedron intersection(const polyhedron& a, const polyhedron& b) {
    polyhedron common;
    bool touch = false;
    const auto add = [&](const polyhedron& of, const polyhedron& within) {
        for (polyhedron::face face : of.faces_) {
            for (const polyhedron::face& other : within.faces_)
                face.corners = detail::clipped(face.corners, other.plane);
            touch = touch || !face.corners.empty();
            common.faces_.push_back(
                std::move(face));  // one without corners too: rounding may take them of a flat body's
        }
    };
    add(a, b);
    add(b, a);
    return touch && !a.empty() && !b.empty() ? common : polyhedron();
}

/// Points, what lies between them, and a ball around each: what a directional light is fitted to.
struct hull {
    std::vector<glm::dvec3> points;
    double radius = 0.0;  ///< of the ball

    hull() = default;
    template <real T>
    hull(std::span<const glm::vec<3, T>> p) : points(p.begin(), p.end()) {}
    template <real T>
    hull(const std::vector<glm::vec<3, T>>& p) : points(p.begin(), p.end()) {}
    template <real T>
    hull(const bounding_sphere<T>& s) : points{glm::dvec3(s.centre)}, radius(s.radius) {}
    template <real T>
    hull(const bounding_box<T>& box) : hull(umbrage::corners(box)) {}
    template <real T>
    hull(const frustum<T>& f) : hull(umbrage::corners(f)) {}
    hull(const eight_corners& c) : points(c.begin(), c.end()) {}
    hull(const polyhedron& p) {
        for (const polyhedron::face& face : p.faces())
            points.insert(points.end(), face.corners.begin(), face.corners.end());
    }
};

}  // namespace umbrage

// ---- umbrage/images/instances.hpp
// Which instances of a mesh a map has to draw: a cascade's holds a small part of the world, and most casters lie beside
// it.
//
//     const umbrage::bounding_box<float> box = umbrage::bounds_of(tree);  // once
//     for (const auto& c : cascades) {
//         const glm::mat4 world_to_clip = c.light.projection * c.light.view;
//         umbrage::rasterize_depth(map, tree, umbrage::instances_in_map(box, trees, world_to_clip, clip),
//                                  world_to_clip, clip);
//     }
//

namespace umbrage {

/// The box around a mesh's positions.
/// @param mesh   positions that are not finite do not count, as the depth pass leaves their triangles out
/// @return       low above high where there is none: nothing is then drawn, and corners() refuses it
[[nodiscard]] inline bounding_box<float> bounds_of(const mesh_view& mesh) {
    bounding_box<float> box{glm::vec3(std::numeric_limits<float>::max()),
                            glm::vec3(std::numeric_limits<float>::lowest())};
    for (const glm::vec3& p : mesh.positions)
        if (detail::all_finite(p)) box.low = glm::min(box.low, p), box.high = glm::max(box.high, p);
    return box;
}

namespace detail {

/// Whether a body, within a box around its middle, may mark a texel; the rest as for umbrage::may_mark.
/// @param reach   dvec3 normal -> how far the body goes from its middle along it, times its length
template <class Reach>
[[nodiscard]] bool may_mark(const glm::dvec3& middle, const glm::dvec3& half, const Reach& reach,
                            const glm::mat4& to_clip, clip_space clip, near_plane at_near) {
    if (!all_finite(to_clip)) return false;
    if (!all_finite(middle) || !all_finite(half)) return true;
    const glm::dmat4 rows = glm::transpose(glm::dmat4(to_clip));
    const auto magnitude = [&](const glm::dvec4& row) {
        return glm::dot(glm::abs(glm::dvec3(row)), glm::abs(middle) + half) + glm::abs(row.w);
    };
    const double of_w = magnitude(rows[3]);
    // All of it where a multiple of w and another of a row sum to less than 0.
    const auto beyond = [&](double w, glm::length_t row, double sign) {
        const glm::dvec4 plane = rows[3] * w + rows[row] * sign;
        const double farthest = glm::dot(glm::dvec3(plane), middle) + plane.w + reach(glm::dvec3(plane));
        return farthest < -0x1p-20 * (of_w + magnitude(rows[row]));
    };
    const bool forward = clip.direction == depth_direction::forward, clips = at_near == near_plane::clips;
    const double low = clip.range == depth_range::zero_to_one ? 0.0 : 1.0;  // z >= 0, or w + z >= 0
    return !(beyond(1, 0, 1) || beyond(1, 0, -1) || beyond(1, 1, 1) || beyond(1, 1, -1) || beyond(1, 3, 0) ||
             ((clips || !forward) && beyond(low, 2, 1)) || ((clips || forward) && beyond(1, 2, -1)));
}

}  // namespace detail

/// Whether a mesh within bounds may mark a texel of a map: false only where all of it lies beyond one side, beyond the
/// far plane, behind the eye, or, if that clips, before the near plane. Where the near plane clamps, casters between
/// it and the light stay.
///
/// @param bounds    in the mesh's own space; low above high, or a radius below 0: there is nothing, false; not finite:
///                  anything may be there, true
/// @param to_clip   model_to_clip, or any matrix that the mesh is drawn with; not finite: nothing is drawn, false
/// @param at_near   as the depth pass has it
/// @exactness       conservative: with 2^-20 to spare of the sums that a shader's floats round
[[nodiscard]] inline bool may_mark(const bounding_box<float>& bounds, const glm::mat4& to_clip, clip_space clip,
                                   near_plane at_near = near_plane::clips) {
    if (glm::any(glm::greaterThan(bounds.low, bounds.high))) return false;
    const glm::dvec3 low(bounds.low), high(bounds.high), half = (high - low) * 0.5;
    const auto reach = [&](const glm::dvec3& normal) { return glm::dot(glm::abs(normal), half); };
    return detail::may_mark((low + high) * 0.5, half, reach, to_clip, clip, at_near);
}
[[nodiscard]] inline bool may_mark(const bounding_sphere<float>& bounds, const glm::mat4& to_clip, clip_space clip,
                                   near_plane at_near = near_plane::clips) {
    if (bounds.radius < 0.0f) return false;
    const auto radius = static_cast<double>(bounds.radius);
    const auto reach = [&](const glm::dvec3& normal) { return glm::length(normal) * radius; };
    return detail::may_mark(glm::dvec3(bounds.centre), glm::dvec3(radius), reach, to_clip, clip, at_near);
}

/// The instances that may mark a map, in their order: the depth pass of these has the bits of that of all.
/// @param bounds          of the mesh: box or sphere
/// @param instances       model to world, a matrix each
/// @param world_to_clip   projection * view
/// The rest as for may_mark.
template <class Bounds>
[[nodiscard]] std::vector<glm::mat4> instances_in_map(const Bounds& bounds, std::span<const glm::mat4> instances,
                                                      const glm::mat4& world_to_clip, clip_space clip,
                                                      near_plane at_near = near_plane::clips) {
    std::vector<glm::mat4> kept;
    for (const glm::mat4& model : instances)
        if (may_mark(bounds, model_to_clip(world_to_clip, model), clip, at_near)) kept.push_back(model);
    return kept;
}

}  // namespace umbrage

// ---- umbrage/images/quality.hpp
// How good a light's set-up is for a view: pixels that a texel's longer axis covers, 1 or less where the map resolves
// what the screen does. As an image, and in five numbers.
//
//     auto report = umbrage::measure_quality({.screen = size, .map_size = {2048, 2048}}, [&](glm::ivec2 pixel) {
//         return umbrage::pixels_per_texel(to_texels, to_pixels, position[pixel], normal[pixel]);
//     });
//     std::printf("mean %.2f, 95 of 100 below %.2f, greatest %.2f\n", report.mean, report.p95, report.greatest);
//

namespace umbrage {

/// How far on the screen a texel's step goes.
///
/// @param texture_matrix   world to texels: the light's
/// @param to_pixels        world to pixels: texture_matrix of the camera
/// @param world, normal    a point before both, and its surface's normal there, of any length > 0
/// @return                 columns: the pixels of a step of one texel in x and in y; not finite where the surface is
///                         parallel to the light
/// @formula                d(pixel) / d(texel) on the plane through the point
template <real T>
[[nodiscard]] glm::mat<2, 2, T> pixels_per_texel(const glm::mat<4, 4, T>& texture_matrix,
                                                 const glm::mat<4, 4, T>& to_pixels, glm::vec<3, T> world,
                                                 glm::vec<3, T> normal) {
    const auto along = detail::across(detail::unit(normal));
    const auto steps = [&](const glm::mat<4, 4, T>& m) {
        return glm::mat<2, 2, T>(detail::step(m, world, along[0]), detail::step(m, world, along[1]));
    };
    const glm::mat<2, 2, T> texels = steps(texture_matrix);
    const T det = glm::determinant(texels);
    const glm::mat<2, 2, T> back(texels[1][1] / det, -texels[0][1] / det, -texels[1][0] / det, texels[0][0] / det);
    return steps(to_pixels) * back;
}

/// The longer axis of a texel's image on the screen, an ellipse's.
/// @param pixels   pixels_per_texel
/// @return         its greatest singular value
/// @formula        s^2 = (t + sqrt(t^2 - 4 det^2)) / 2, t the sum of the squares
template <real T>
[[nodiscard]] T longest_extent(const glm::mat<2, 2, T>& pixels) {
    const T a = pixels[0][0], b = pixels[1][0], c = pixels[0][1], d = pixels[1][1];
    // t +- 2 det as sums of squares, of which no difference loses digits
    return (std::hypot(a + d, b - c) + std::hypot(a - d, b + c)) / T(2);
}

/// A set-up in numbers, over all pixels that were measured.
struct quality_report {
    double mean = 0, p95 = 0, greatest = 0;  ///< of longest_extent, pixels
    double storage_factor = 0;               ///< texels over pixels, of maps that would resolve all of the screen
    std::size_t measured = 0, skipped = 0;   ///< pixels; skipped: of surfaces parallel to the light
};

/// What a set-up is measured over.
struct measured_view {
    glm::ivec2 screen{1};    ///< pixels, each >= 1
    glm::ivec2 map_size{1};  ///< texels of a map, each >= 1
    int maps = 1;            ///< how many of them there are: cascades
    int step = 1;            ///< from pixel to pixel, >= 1
};

/// Measures a set-up over a view.
///
/// @param at        (glm::ivec2 pixel) -> pixels_per_texel of the map that the pixel looks into, float or double; of
///                  zeros where there is nothing to see
/// @param extents   gets longest_extent of each pixel measured, 0 where there was nothing to measure; empty, or of the
///                  screen's size over the step, rounded up
/// @throws std::invalid_argument  sizes and counts below 1, extents of another size
/// @formula         storage_factor = maps (width max |dp/dx|) (height max |dp/dy|) / pixels, dp/dx and dp/dy columns
/// @cite            Lloyd, Govindaraju, Quammen, Molnar, Manocha: Practical Logarithmic Rasterization for Low-Error
///                  Shadow Maps, Graphics Hardware 2007
template <class At>
[[nodiscard]] quality_report measure_quality(const measured_view& view, At&& at, image_view<float> extents = {}) {
    constexpr auto function = "measure_quality";
    const auto [screen, map_size, maps, step] = view;
    detail::require(screen.x >= 1 && screen.y >= 1, function, "screen", "must be above 0");
    detail::require(map_size.x >= 1 && map_size.y >= 1, function, "map_size", "must be above 0");
    detail::require(maps >= 1, function, "maps", "must be above 0");
    detail::require(step >= 1, function, "step", "must be above 0");
    const glm::ivec2 size((screen.x - 1) / step + 1, (screen.y - 1) / step + 1);
    const bool draws = extents.size != glm::ivec2(0);
    detail::require(!draws || extents.size == size, function, "extents", "must have the screen's size over the step");
    quality_report report;
    std::vector<double> all;
    glm::dvec2 longest(0);
    double sum = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const glm::dmat2 pixels(at(glm::ivec2(x, y) * step));
            if (draws) extents[{x, y}] = 0.0f;
            if (pixels == glm::dmat2(0)) continue;
            const double extent = longest_extent(pixels);
            if (!is_finite(extent)) {
                ++report.skipped;
                continue;
            }
            if (draws) extents[{x, y}] = static_cast<float>(extent);
            all.push_back(extent);
            sum += extent;
            longest = glm::max(longest, glm::dvec2(glm::length(pixels[0]), glm::length(pixels[1])));
        }
    report.measured = all.size();
    if (all.empty()) return report;
    report.mean = sum / double(all.size());
    report.greatest = *std::max_element(all.begin(), all.end());
    const auto nth = all.begin() + static_cast<std::ptrdiff_t>(double(all.size() - 1) * 0.95);
    std::nth_element(all.begin(), nth, all.end());
    report.p95 = *nth;
    report.storage_factor = maps * (map_size.x * longest.x) * (map_size.y * longest.y) / (double(screen.x) * screen.y);
    return report;
}

}  // namespace umbrage

// ---- umbrage/images/light_choice.hpp
// Which of several maps serves a view best: a warp where it pays, a uniform map where it does not, and no flicker
// between them.
//
//     // a receiver from each 64 pixels squared or so: what the camera saw a frame ago will do
//     std::vector<umbrage::seen_point> seen = ...;
//     const std::array lights{umbrage::fit_directional_light(tight), umbrage::fit_light_space_perspective(fit).light};
//     choice = umbrage::choose_light<float>(lights, seen, {.to_pixels = pixels, .map_size = map.size()}, choice.kept);
//     draw_depths(lights[choice.kept]);
//

namespace umbrage {

/// A point of a surface that the camera sees, world.
struct seen_point {
    glm::dvec3 position{0};
    glm::dvec3 normal{0, 1, 0};  ///< any length > 0
};

struct choice_terms {
    glm::dmat4 to_pixels{1};  ///< world to pixels: texture_matrix of the camera
    glm::ivec2 map_size{1};   ///< texels, each >= 1
    double better = 0.1;      ///< share by which another light has to be better before it takes over, 0 .. 1
};

struct light_choice {
    std::size_t kept = 0;     ///< which of the lights to take
    std::vector<double> p95;  ///< of each: pixels that a texel's longer axis covers, at most, for 95 of 100 points;
                              ///< infinite where a map does not hold as many, 0 without points
};

/// Measures each light over the points, and keeps the one that it had unless another is better by a margin.
///
/// @param lights   one or more, of any kinds
/// @param seen     a coarse grid over the screen: some hundred points tell; those of surfaces parallel to the light
///                 count for nothing
/// @param before   which of the lights was taken last, light_choice::kept
/// @throws std::invalid_argument  no lights, before beyond them, sizes below 1, better out of range, and matrices that
///                                are not finite
template <real T>
[[nodiscard]] light_choice choose_light(std::span<const light_space<T>> lights, std::span<const seen_point> seen,
                                        const choice_terms& terms, std::size_t before = 0) {
    constexpr auto function = "choose_light";
    detail::require(!lights.empty(), function, "lights", "must not be empty");
    detail::require(before < lights.size(), function, "before", "must be one of the lights");
    detail::require(terms.better >= 0 && terms.better <= 1, function, "better", "must lie between 0 and 1");
    detail::require(detail::all_finite(terms.to_pixels), function, "to_pixels", "must be finite");
    light_choice choice{before, {}};
    for (const light_space<T>& light : lights) {
        const glm::dmat4 to_texels =
            texture_matrix<double>({glm::dmat4(light.view), glm::dmat4(light.projection), light.clip}, terms.map_size);
        std::vector<double> extents;
        for (const seen_point& p : seen) {
            const glm::dvec4 h = shadow_coordinate(to_texels, p.position);
            const glm::dvec2 at = glm::dvec2(h) / h.w;
            const bool held = h.w > 0 && at.x >= 0 && at.y >= 0 && at.x <= terms.map_size.x && at.y <= terms.map_size.y;
            const double extent = longest_extent(pixels_per_texel(to_texels, terms.to_pixels, p.position, p.normal));
            if (!held) extents.push_back(std::numeric_limits<double>::infinity());
            else if (is_finite(extent)) extents.push_back(extent);
        }
        choice.p95.push_back(0);
        if (extents.empty()) continue;
        const auto nth = extents.begin() + static_cast<std::ptrdiff_t>(double(extents.size() - 1) * 0.95);
        std::nth_element(extents.begin(), nth, extents.end());
        choice.p95.back() = *nth;
    }
    const auto best = std::min_element(choice.p95.begin(), choice.p95.end());
    if (*best < choice.p95[before] * (1 - terms.better)) choice.kept = std::size_t(best - choice.p95.begin());
    return choice;
}

}  // namespace umbrage

// ---- umbrage/images/min_max.hpp
// Least and greatest depth of every square of 2 x 2, 4 x 4, ... texels of a map.
//
//     const auto levels = umbrage::make_min_max_pyramid(map.view(), 3);
//     float nearest = levels[1].least[texel / 4];  // of the 4 x 4 texels that `texel` is one of
//

namespace umbrage {

/// One level: an element for each square, those at the far borders cut off by them.
struct depth_bounds {
    image<float> least;     ///< NaN where a texel is NaN
    image<float> greatest;  ///< of the texels that are numbers; NaN where none is
};

namespace detail {

/// Each element from 2 x 2, in blocks of 64; what is beyond a border repeats it. The two images may be one.
template <class ParallelFor>
void halve(image_view<const float> least, image_view<const float> greatest, depth_bounds& to, ParallelFor&& parallel) {
    const glm::ivec2 size = to.least.size();
    parallel(size.y, [&](int first, int last) {
        on_best_isa([&](auto) UMBRAGE_INLINE {
            const bool both = least.data != greatest.data;
            alignas(64) std::int32_t keys[4][block];
            alignas(64) float ends[2][2 * block];
            for (int y = first; y < last; ++y)
                for (int x = 0; x < size.x; x += block) {
                    const int count = size.x - x < block ? size.x - x : block;
                    const auto load = [&](const image_view<const float>& from) UMBRAGE_INLINE {
                        const float* low = from.row(2 * y) + 2 * x;
                        const float* high = from.row(2 * y + 1 < from.size.y ? 2 * y + 1 : 2 * y) + 2 * x;
                        if (const int there = from.size.x - 2 * x; there < 2 * block) {
                            for (int i = 0; i < 2 * block; ++i) {
                                const int k = i < there ? i : there - 1;
                                ends[0][i] = low[k];
                                ends[1][i] = high[k];
                            }
                            low = ends[0];
                            high = ends[1];
                        }
                        for (int i = 0; i < block; ++i) {
                            keys[0][i] = order_key(low[2 * i]);
                            keys[1][i] = order_key(low[2 * i + 1]);
                            keys[2][i] = order_key(high[2 * i]);
                            keys[3][i] = order_key(high[2 * i + 1]);
                        }
                    };
                    const auto store = [&](auto pick, float* result) UMBRAGE_INLINE {
                        alignas(64) float depths[block];
                        for (int i = 0; i < block; ++i)
                            depths[i] =
                                from_order_key(pick(pick(keys[0][i], keys[1][i]), pick(keys[2][i], keys[3][i])));
                        copy_floats(result + x, depths, count);
                    };
                    load(least);
                    store(least_of{}, to.least.view().row(y));
                    if (both) load(greatest);
                    store(greatest_of{}, to.greatest.view().row(y));
                }
        });
    });
}

}  // namespace detail

/// @param map       depths, any values
/// @param levels    how many: the first has squares of 2 x 2 texels, each next one of twice the side
/// @param parallel  cuts the rows into pieces, see parallel.hpp
/// @return          as many levels; a level of a single element is followed by more of them
/// @throws std::invalid_argument  empty map, or negative levels
/// @exactness       A: selects, never computes
template <class ParallelFor = serial>
[[nodiscard]] std::vector<depth_bounds> make_min_max_pyramid(image_view<const float> map, int levels,
                                                             ParallelFor&& parallel = {}) {
    if (map.empty() || levels < 0) detail::fail("umbrage::make_min_max_pyramid: empty map or negative levels");
    std::vector<depth_bounds> pyramid;
    for (int level = 0; level < levels; ++level) {
        const image_view<const float> least = level ? pyramid.back().least.view() : map;
        const image_view<const float> greatest = level ? pyramid.back().greatest.view() : map;
        const glm::ivec2 size((least.size.x + 1) / 2, (least.size.y + 1) / 2);
        depth_bounds next{image<float>(size), image<float>(size)};
        detail::halve(least, greatest, next, parallel);
        pyramid.push_back(std::move(next));
    }
    return pyramid;
}

}  // namespace umbrage

// ---- umbrage/images/summed_area.hpp
// Summed-area tables: the sum over any rectangle of an image from four texels.
//
//     umbrage::image<std::uint32_t> sums(values.size());
//     umbrage::summed_area(values, sums);
//     std::uint32_t sum = umbrage::box_sum(sums, {3, 5}, {10, 9});  // columns 3 .. 10, rows 5 .. 9
//
// Prefer integers: quantise depths or moments first. Their tables are exact, whatever the order; a table of floats
// loses bits as it grows, and its differences lose more.

UMBRAGE_STRICT_MATH
namespace umbrage {
namespace detail {

/// Floats are always added in fours, in the order that summed_area states; integers in any.
template <class T, isa Set>
inline constexpr int sum_lanes = std::is_integral_v<T>&& Set != isa::base ? running_sum_lanes : 4;

/// The running sums of a band, and those of the bands before it. A load waits for an earlier store whose address has
/// the same last twelve bits (4K aliasing): so both lie, modulo 4096, away from the rows of the image and of the table.
/// The worst placement was measured to be five times as slow.
template <class Sum>
class band_sums {
public:
    band_sums(std::size_t length, const void* from, const void* to) : memory_(2 * length + 2 * page / sizeof(Sum)) {
        const std::size_t a = last_bits(from), b = last_bits(to), ahead = (b - a) % page, behind = page - ahead;
        base = place(memory_.data(), ahead > behind ? a + ahead / 3 : b + behind / 3);
        line = place(base + length, ahead > behind ? a + 2 * ahead / 3 : b + 2 * behind / 3);
    }
    band_sums(const band_sums&) = delete;
    band_sums& operator=(const band_sums&) = delete;

private:
    static constexpr std::size_t page = 4096;
    static std::size_t last_bits(const void* p) { return reinterpret_cast<std::uintptr_t>(p) % page; }
    static Sum* place(Sum* from, std::size_t wanted) {
        return from + (wanted / 64 * 64 - last_bits(from)) % page / sizeof(Sum);
    }

    std::vector<Sum> memory_;

public:
    Sum *base, *line;
};

enum class table_store { none, plain, streaming };

/// Adds the running sums of a row of the image to `line`, and stores a row of the table: that plus `base`, or of
/// integers `line` itself, which then holds all that is above.
template <table_store Store, int Lanes, class From, class Sum>
UMBRAGE_INLINE inline void sum_row(const From* from, const Sum* base, Sum* line, Sum* to, int count) {
    using few = lanes_of<Sum, Lanes>;
    constexpr bool by_bytes = sums_bytes && sizeof(From) == 1 && Lanes == 8;
    constexpr int step = by_bytes ? 2 * Lanes : Lanes;
    few carry{};
    const auto add_few = [&](auto store, few& together, const Sum* under, Sum* lines, Sum* out) UMBRAGE_INLINE {
        constexpr table_store how = decltype(store)::value;
        few sums, there;
        load_lanes(lines, there);
        sums = (carry + together) + there;
        all_last<Lanes>(together);
        carry = carry + together;
        store_lanes(sums, lines);
        if constexpr (how == table_store::none) return;
        if constexpr (!std::is_integral_v<Sum>) {
            load_lanes(under, there);
            sums = sums + there;
        }
        if constexpr (how == table_store::plain) store_lanes(sums, out);
        if constexpr (how == table_store::streaming) stream<sizeof sums>(out, &sums);
    };
    const auto sum_some = [&](auto store, const auto* values, const Sum* under, Sum* lines, Sum* out) UMBRAGE_INLINE {
        few together;
        if constexpr (by_bytes) {
            few next;
            running_sums_of_bytes(values, together, next);
            add_few(store, together, under, lines, out);
            add_few(store, next, under + Lanes, lines + Lanes, out + Lanes);
        } else {
            load_lanes(values, together);
            running_sum<Lanes>(together);
            add_few(store, together, under, lines, out);
        }
    };
    constexpr std::integral_constant<table_store, Store> as_asked{};
    // Of the row's last few, which are copied from where they are put: not past the cache.
    constexpr std::integral_constant<table_store, Store == table_store::none ? Store : table_store::plain> to_copy{};
    if constexpr (Store == table_store::streaming) prefetch_rest(to, count, step);
    // Measured: the hardware prefetcher comes too late.
    const auto prefetch = [&](int first) UMBRAGE_INLINE {
        prefetch_bytes(from + first, 1536, block * static_cast<int>(sizeof(From)));
    };
    int x = 0;
    if constexpr (by_bytes) {
        for (; x + step <= count; x += step) {
            if (x % block == 0) prefetch(x);
            sum_some(as_asked, from + x, base + x, line + x, to + x);
        }
    } else {
        // This block and the next, which is loaded before the stores that its loads could alias with.
        alignas(64) Sum values[2][block];
        const auto load = [&](int first) UMBRAGE_INLINE {
            prefetch(first);
            for (int i = 0; i < block; ++i) values[first / block % 2][i] = from[first + i];
        };
        if (block <= count) load(0);
        for (; x + block <= count; x += block) {
            if (x + 2 * block <= count) load(x + block);
            const Sum* const now = values[x / block % 2];
            for (int i = 0; i < block; i += step) sum_some(as_asked, now + i, base + x + i, line + x + i, to + x + i);
        }
    }
    for (; x < count; x += step) {  // base and line are padded
        const int there = count - x < step ? count - x : step;
        std::conditional_t<by_bytes, From, Sum> rest[std::size_t(step)]{};
        alignas(Lanes * sizeof(Sum)) Sum result[std::size_t(step)];
        for (int i = 0; i < there; ++i) rest[i] = from[x + i];
        if (there == step) {
            sum_some(as_asked, rest, base + x, line + x, to + x);
        } else {
            sum_some(to_copy, rest, base + x, line + x, result);
            if constexpr (Store != table_store::none) std::copy_n(result, there, to + x);
        }
    }
}

inline constexpr int band_rows =
    64;  ///< rows of a table that are summed from zero, then put on top of what is before them

/// Rows first <= y < last of one band into the table; `line` becomes the sums of the band down to there.
template <class From, class Sum>
void sum_rows(image_view<const From> values, image_view<Sum> sums, int first, int last, const Sum* base, Sum* line) {
    const int width = sums.size.x;
    const bool is_large = past_cache(sums);
    on_best_isa([&](auto set) UMBRAGE_INLINE {
        constexpr int lanes = sum_lanes<Sum, decltype(set)::value>;
        for (int y = first; y < last; ++y) {
            const From* from = values.row(y);
            Sum* to = sums.row(y);
            if (is_large && streams_to(to)) sum_row<table_store::streaming, lanes>(from, base, line, to, width);
            else sum_row<table_store::plain, lanes>(from, base, line, to, width);
        }
    });
    if (is_large) finish_streaming();
}

/// What those rows put under all that follow; `line` starts as zeros.
template <class From, class Sum>
void total_of_rows(image_view<const From> values, int first, int last, Sum* line) {
    const int width = values.size.x;
    on_best_isa([&](auto set) UMBRAGE_INLINE {
        if constexpr (std::is_integral_v<Sum>) {  // in any order: down the columns, then along one row
            for (int y = first; y < last; ++y) {
                const From* from = values.row(y);
                int x = 0;
                for (; x + block <= width; x += block) {
                    UMBRAGE_NO_OVERLAP
                    for (int i = 0; i < block; ++i) line[x + i] += from[x + i];
                }
                for (; x < width; ++x) line[x] += from[x];
            }
            for (int x = 1; x < width; ++x) line[x] += line[x - 1];
        } else {
            for (int y = first; y < last; ++y)
                sum_row<table_store::none, sum_lanes<Sum, decltype(set)::value>>(values.row(y), line, line, line,
                                                                                 width);
        }
    });
}

}  // namespace detail

/// Each texel: the sum of all in its row and the rows before, up to and including its column.
///
/// @param values    uint8_t, uint16_t or uint32_t for a table of uint32_t; float for one of floats
/// @param sums      same size, other pixels
/// @param parallel  cuts bands of 64 rows into pieces, see parallel.hpp; the image is then read twice
/// @throws std::invalid_argument  sizes differ
/// @exactness   uint32_t A: modulo 2^32. float B. In a row, groups g of four from its start, each summed as g0, g0+g1,
///              (g1+g2)+g0, (g2+g3)+(g0+g1); to them the last sums of the groups before, added up from left to right;
///              to that the texel above, in bands of 64 rows; to that the last row of the bands before, added up
///              downwards
template <class From, class Sum, class ParallelFor = serial>
void summed_area(image_view<From> values, image_view<Sum> sums, ParallelFor&& parallel = {}) {
    using value = std::remove_const_t<From>;
    static_assert(std::is_same_v<Sum, float> ? std::is_same_v<value, float>
                                             : std::is_same_v<Sum, std::uint32_t> && std::is_unsigned_v<value> &&
                                                   sizeof(value) <= sizeof(Sum));
    if (values.size != sums.size) detail::fail("umbrage::summed_area: sizes differ");
    if (values.empty()) return;
    const int height = sums.size.y, bands = (height + detail::band_rows - 1) / detail::band_rows;
    const auto length = (static_cast<std::size_t>(sums.size.x) + 15) / 16 * 16;
    const auto end_of = [=](int b) { return b + 1 < bands ? (b + 1) * detail::band_rows : height; };
    const auto add = [=](const Sum* from, Sum* to) {
        for (std::size_t i = 0; i < length; ++i) to[i] = from[i] + to[i];
    };
    if constexpr (std::is_same_v<std::remove_cvref_t<ParallelFor>, serial>) {
        detail::band_sums<Sum> band(length, values.data, sums.data);
        for (int b = 0; b < bands; ++b) {
            detail::sum_rows<value, Sum>(values, sums, b * detail::band_rows, end_of(b), band.base, band.line);
            if constexpr (std::is_integral_v<Sum>) continue;
            add(band.line, band.base);
            std::fill(band.line, band.line + length, Sum(0));
        }
    } else {
        // What each band puts under the next one, by itself and then with all before it; then the bands, in any order.
        std::vector<Sum> bases(length * static_cast<std::size_t>(bands));
        const auto base = [&](int b) { return bases.data() + length * static_cast<std::size_t>(b); };
        if (bands > 1)
            parallel(bands - 1, [&](int first, int last) {
                for (int b = first; b < last; ++b)
                    detail::total_of_rows<value, Sum>(values, b * detail::band_rows, end_of(b), base(b + 1));
            });
        for (int b = 1; b < bands; ++b) add(base(b - 1), base(b));
        parallel(bands, [&](int first, int last) {
            for (int b = first; b < last; ++b) {
                detail::band_sums<Sum> band(length, values.data, sums.data);
                std::copy(base(b), base(b) + length, std::is_integral_v<Sum> ? band.line : band.base);
                detail::sum_rows<value, Sum>(values, sums, b * detail::band_rows, end_of(b), band.base, band.line);
            }
        });
    }
}

/// The same where one of the two is an image.
template <class From, class Sums, class ParallelFor = serial>
requires detail::some_image<From, Sums>
void summed_area(const From& values, Sums&& sums, ParallelFor&& parallel = {}) {
    summed_area(detail::view_of(values), detail::view_of(sums), parallel);
}

/// Sum over a rectangle of the image that a table was made of.
///
/// @param sums     a table from summed_area
/// @param first    lowest column and row
/// @param last     highest column and row, they count too
/// @return         what lies outside the image counts as 0, as does a rectangle with last < first
/// @formula        S(last) - S(first.x - 1, last.y) - S(last.x, first.y - 1) + S(first - 1)
/// @exactness      uint32_t A: exact while the rectangle's area times the greatest value < 2^32, even where sums of the
///                 table have wrapped around. float B
template <class T>
[[nodiscard]] std::remove_const_t<T> box_sum(image_view<T> sums, glm::ivec2 first, glm::ivec2 last) {
    const int left = first.x > 0 ? first.x : 0, right = last.x < sums.size.x ? last.x : sums.size.x - 1;
    const int low = first.y > 0 ? first.y : 0, high = last.y < sums.size.y ? last.y : sums.size.y - 1;
    if (left > right || low > high) return 0;
    const auto at = [&](int x, int y) { return x < 0 || y < 0 ? std::remove_const_t<T>(0) : sums.row(y)[x]; };
    return ((at(right, high) - at(left - 1, high)) - at(right, low - 1)) + at(left - 1, low - 1);
}
template <class T>
[[nodiscard]] T box_sum(const image<T>& sums, glm::ivec2 first, glm::ivec2 last) {
    return box_sum(sums.view(), first, last);
}

}  // namespace umbrage
UMBRAGE_END_STRICT_MATH

// ---- umbrage/images/moment_table.hpp
// Summed-area tables of a shadow map's four moments, and visibility of whole images from them.
//
//     umbrage::moment_table of{.radius = 16};
//     umbrage::image<glm::u16vec4> table = umbrage::make_moment_table(map, of);
//     umbrage::summed_visibility(table, of, receivers, 16, out);
//
// A box of 33 x 33 texels costs what one of 3 x 3 does, and bleeds less light than variance.

namespace umbrage {

/// What a table is made for.
struct moment_table {
    int radius = 16;  ///< of the largest box: 2 radius + 1 texels a side
    glm::vec2 bias = msm_bias_16;
    depth_direction direction = depth_direction::forward;
};

/// Sums of a map's moments for summed_moments.
///
/// @param map         depths; NaN counts as far
/// @param of          the largest box, n texels of it within the map
/// @return            two halves, each with one column and row more than the map: sums of 65535
///                    turn_moments(encode_msm), rounded, of what lies before a column and row; modulo 2^16, and over
///                    2^16
/// @throws std::invalid_argument  empty map, radius out of range, or 65535 n >= 2^32: what a box may then hold wraps
template <class ParallelFor = serial>
[[nodiscard]] image<glm::u16vec4> make_moment_table(image_view<const float> map, const moment_table& of,
                                                    ParallelFor&& parallel = {}) {
    if (map.empty()) detail::fail("umbrage::make_moment_table: empty map");
    if (of.radius < 0 || of.radius > 32767) detail::fail("umbrage::make_moment_table: radius out of range");
    const std::int64_t side = 2 * std::int64_t(of.radius) + 1;
    const std::int64_t n = std::min<std::int64_t>(side, map.size.x) * std::min<std::int64_t>(side, map.size.y);
    if (n > 65537) detail::fail("umbrage::make_moment_table: sums in a box of that radius may reach 2^32");

    image<glm::u16vec4> codes(map.size), table({2 * (map.size.x + 1), map.size.y + 1}, glm::u16vec4(0));
    const float far = cleared_depth(of.direction);
    parallel(map.size.y, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < map.size.x; ++x)
                codes[{x, y}] = glm::u16vec4(turn_moments(encode_msm(map.row(y)[x], far)) * 65535.0f + 0.5f);
    });
    image<std::uint32_t> channel(map.size), sums(map.size);
    for (glm::length_t c = 0; c < 4; ++c) {
        std::transform(codes.texels().begin(), codes.texels().end(), channel.texels().begin(),
                       [c](const glm::u16vec4& t) { return std::uint32_t(t[c]); });
        summed_area(channel, sums, parallel);
        for (int y = 0; y < map.size.y; ++y)
            for (int x = 0; x < map.size.x; ++x) {
                const std::uint32_t sum = sums[{x, y}];
                table[{x + 1, y + 1}][c] = static_cast<std::uint16_t>(sum & 0xFFFF);
                table[{map.size.x + x + 2, y + 1}][c] = static_cast<std::uint16_t>(sum >> 16);
            }
    }
    return table;
}

/// summed_moments of each receiver.
/// @param table, of   from make_moment_table
/// @param receivers   (x, y) in texels of the map, z depth, biased
/// @param radius      of the box, at most the table's
/// @param out         visibility, 1 lit; same size as receivers
/// @throws std::invalid_argument  sizes differ, no table of two halves, or a radius below 0 or above the table's
template <class ParallelFor = serial>
void summed_visibility(image_view<const glm::u16vec4> table, const moment_table& of,
                       image_view<const glm::vec3> receivers, int radius, image_view<float> out,
                       ParallelFor&& parallel = {}) {
    if (receivers.size != out.size) detail::fail("umbrage::summed_visibility: sizes differ");
    if (table.size.x < 4 || table.size.x % 2 || table.size.y < 2)
        detail::fail("umbrage::summed_visibility: the table is not one of make_moment_table");
    if (radius < 0 || radius > of.radius) detail::fail("umbrage::summed_visibility: the table is of another radius");
    const auto fetch = [table](glm::ivec2 at) { return glm::vec4(table.row(at.y)[at.x]); };
    const auto reach = static_cast<float>(radius), far = cleared_depth(of.direction);
    parallel(out.size.y, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < out.size.x; ++x) {
                const glm::vec3 r = receivers.row(y)[x];
                out.row(y)[x] = summed_moments(fetch, table.size, glm::vec2(r), r.z, reach, of.bias, far);
            }
    });
}

}  // namespace umbrage

// ---- umbrage/images/overlay.hpp
// A shadow map in the corner of the picture it shadowed, stretched in contrast so that people see something.
//
//     umbrage::overlay(picture, map, {.size = {256, 256}}, umbrage::stretch(map));
//     umbrage::overlay(picture, map, {.size = {256, 256}}, [s = umbrage::stretch(map)](float depth) {
//         return umbrage::false_colour(s(depth));
//     });
//

namespace umbrage {

/// Maps low..high to 0..1; values outside clamp, NaN becomes 1.
struct contrast_stretch {
    float low = 0.0f, high = 1.0f;

    [[nodiscard]] float operator()(float v) const {
        if (is_nan(v) || v >= high) return 1.0f;
        return v > low ? static_cast<float>((double(v) - double(low)) / (double(high) - double(low))) : 0.0f;
    }
};

/// The range that a map's depths fill, without the texels that nothing was drawn to.
///
/// @param cleared   texels of this value are left out, as are NaN and the infinities
/// @param outliers  share of the depths to give up at either end, 0 <= outliers < 1/2
/// @return      0..1 when no texel is left
/// @throws std::invalid_argument  outliers out of range
[[nodiscard]] inline contrast_stretch stretch(image_view<const float> map, float cleared = 1.0f,
                                              double outliers = 0.01) {
    if (!(outliers >= 0.0 && outliers < 0.5)) detail::fail("umbrage::stretch: outliers not in [0, 1/2)");
    std::vector<float> depths;
    for (int y = 0; y < map.size.y && !map.empty(); ++y)
        for (int x = 0; x < map.size.x; ++x)
            if (const float depth = map.row(y)[x]; is_finite(depth) && depth != cleared) depths.push_back(depth);
    if (depths.empty()) return {};
    const auto given_up = static_cast<std::ptrdiff_t>(outliers * static_cast<double>(depths.size()));
    const auto ranked = [&](std::ptrdiff_t rank) {
        std::nth_element(depths.begin(), depths.begin() + rank, depths.end());
        return depths[static_cast<std::size_t>(rank)];
    };
    return {ranked(given_up), ranked(std::ssize(depths) - 1 - given_up)};
}

/// Where an overlay goes: the top left corner, as people see it.
struct overlay_placement {
    glm::ivec2 size{0, 0};                                ///< in texels of the picture; a zero takes the map's own side
    texture_origin map_origin = texture_origin::bottom;   ///< where row 0 of the map is
    texture_origin picture_origin = texture_origin::top;  ///< where row 0 of the picture is; image files: at the top
};

/// Draws a map into the top left corner of a picture, scaled to the nearest texel, the one that `overlay_texel` says.
/// What does not fit is cut off.
///
/// @param colour  float -> colour, given the map's texels as they are: a float is a grey, a vec3 red, green and blue,
///                all in [0, 1]
/// @throws std::invalid_argument  negative size
template <class Colour>
void overlay(image_view<glm::u8vec3> picture, image_view<const float> map, const overlay_placement& place,
             Colour&& colour) {
    if (place.size.x < 0 || place.size.y < 0) detail::fail("umbrage::overlay: negative size");
    if (map.empty()) return;
    const glm::ivec2 size{place.size.x ? place.size.x : map.size.x, place.size.y ? place.size.y : map.size.y};
    const auto nearest = [](int i, double count, double from) {
        return static_cast<int>(overlay_texel(i + 0.5, count, from, from / count));
    };
    const auto row_from_top = [](int y, int count, texture_origin origin) {
        return origin == texture_origin::top ? y : count - 1 - y;
    };
    for (int y = 0; y < std::min(size.y, picture.size.y); ++y) {
        const float* depths = map.row(row_from_top(nearest(y, size.y, map.size.y), map.size.y, place.map_origin));
        glm::u8vec3* out = picture.row(row_from_top(y, picture.size.y, place.picture_origin));
        for (int x = 0; x < std::min(size.x, picture.size.x); ++x)
            out[x] = store_unorm8(glm::vec3(colour(depths[nearest(x, size.x, map.size.x)])));
    }
}

}  // namespace umbrage

// ---- umbrage/images/visibility.hpp
// A whole image of receivers against a shadow map, with any filter and any encoding.
//
//     umbrage::visibility(map, umbrage::rg<11>{}, receivers, umbrage::filters::pcf_2x2{}, out);
//
// Straight from what a camera saw, with no image of receivers in between:
//
//     umbrage::depth_receivers seen{depth, umbrage::receiver_matrix(inverse, to_texels, size, clip), bias};
//     umbrage::visibility(map, umbrage::rg<11>{}, seen, umbrage::filters::pcf_2x2{}, out);
//
// Bit for bit what the filter gives for each receiver alone.

namespace umbrage {

/// What receivers see whose texels lie outside the map.
enum class outside_map {
    clamped,  ///< the nearest texel inside: what clamped(map) fetches
    lit,      ///< the far plane: what bordered(map, cleared_depth(clip)) fetches
};

namespace detail {

/// The receivers of some rows through a filter's blocks.
template <class Receivers, class Blocks>
void filter_rows(const Receivers& receivers, const Blocks& blocks, image_view<float> out, int first, int last) {
    const bool large = past_cache(out);
    on_best_isa([&](auto set) UMBRAGE_INLINE {
        constexpr unsigned ring = 4;  // blocks on their way
        typename Blocks::placed placed[ring];
        alignas(64) float visibility[block];
        block_walk ahead{0, first, out.size.x}, at = ahead;
        for (unsigned n = 0; at.y < last; ++n) {
            if (ahead.y < last) {
                prefetch(receivers, ahead);
                use_receivers(receivers, ahead, set, [&](const auto& of_block) UMBRAGE_INLINE {
                    if constexpr (requires { blocks.place(of_block, placed[0], 0); })
                        blocks.place(of_block, placed[n % ring], ahead.y);
                    else blocks.place(of_block, placed[n % ring]);
                });
                ahead.step();
            }
            if (n + 1 < ring) continue;
            blocks(placed[(n + 1) % ring], at.count(), visibility, set);
            float* const to = out.row(at.y) + at.x;
            if (large && at.x == 0) prefetch_rest(to, out.size.x);
            if (large && at.count() == block) stream_block(to, visibility);
            else copy_floats(to, visibility, at.count());
            at.step();
        }
    });
    if (large) finish_streaming();
}

/// Visibility of a receiver, by a filter that may want to know its pixel, too.
template <class Filter, class Fetch>
[[nodiscard]] float filtered(const Filter& filter, const Fetch& fetch, glm::vec2 coord, float receiver,
                             [[maybe_unused]] glm::ivec2 pixel) {
    if constexpr (requires { filter(fetch, coord, receiver, pixel); })
        return static_cast<float>(filter(fetch, coord, receiver, pixel));
    else return static_cast<float>(filter(fetch, coord, receiver));
}

/// Calls use(visibility, coord, receiver, pixel) for one receiver after the other.
template <class Receivers, class ParallelFor, class Use>
void for_each_receiver(const Receivers& receivers, image_view<float> out, ParallelFor&& parallel, const Use& use) {
    parallel(out.size.y, [&](int first, int last) {
        for (block_walk at{0, first, out.size.x}; at.y < last; at.step())
            use_receivers(receivers, at, isa_constant<isa::base>{}, [&](const auto& r) {
                float* const to = out.row(at.y) + at.x;
                for (int i = 0; i < at.count(); ++i)
                    use(to[i], glm::vec2(r.x(i), r.y(i)), r.z(i), glm::ivec2(at.x + i, at.y));
            });
    });
}

/// Any filter, receiver by receiver.
template <class Receivers, class Filter, class Fetch, class ParallelFor>
void filter_each(const Receivers& receivers, const Filter& filter, const Fetch& fetch, image_view<float> out,
                 ParallelFor&& parallel) {
    for_each_receiver(receivers, out, parallel,
                      [&](float& visibility, glm::vec2 coord, float receiver, glm::ivec2 pixel) {
                          visibility = filtered(filter, fetch, coord, receiver, pixel);
                      });
}

/// Once more the receivers whose texels may lie outside the map, now with a border that lights them.
template <class Receivers, class Filter, class Fetch, class ParallelFor>
void light_outside(const Receivers& receivers, glm::vec2 map_size, const Filter& filter, const Fetch& bordered_map,
                   image_view<float> out, ParallelFor&& parallel) {
    const float margin = filter.reach() + 0.5f;  // weights are in steps of 1/256
    const glm::vec2 last = map_size - margin, beyond = map_size + margin;
    for_each_receiver(receivers, out, parallel, [&](float& visibility, glm::vec2 c, float receiver, glm::ivec2 pixel) {
        if (c.x >= margin && c.y >= margin && c.x <= last.x && c.y <= last.y) return;
        const bool apart = c.x < -margin || c.y < -margin || c.x > beyond.x || c.y > beyond.y;
        visibility = apart && !is_nan(receiver) ? 1.0f : filtered(filter, bordered_map, c, receiver, pixel);
    });
}

/// A map's texels, decoded, as one type for all encodings: what is seldom used need not be compiled for each.
struct erased_fetch {
    const void* fetch;
    float (*call)(const void*, glm::ivec2);
    float operator()(glm::ivec2 texel) const { return call(fetch, texel); }
};
template <class Fetch>
[[nodiscard]] erased_fetch erase(const Fetch& fetch) {
    return {&fetch, [](const void* of, glm::ivec2 texel) { return (*static_cast<const Fetch*>(of))(texel); }};
}

/// The far plane's depth, as the filter or else the encoding knows it.
template <class Encoding, class Filter>
[[nodiscard]] float far_depth(const Encoding& encoding, const Filter& filter) {
    if constexpr (requires { filter.is_lit.direction; }) return cleared_depth(filter.is_lit.direction);
    else if constexpr (requires { encoding.direction; }) return cleared_depth(encoding.direction);
    else return 1.0f;
}

/// How blocks read maps of an encoding that has a fast form for single texels; others are decoded first.
[[nodiscard]] inline float_texels texels_of(image_view<const float> map, const depth32f&) { return {map}; }
template <int Bits>
[[nodiscard]] rg_texels texels_of(image_view<const glm::u8vec2> map, const rg<Bits>& encoding) {
    return {map, Bits, encoding.edge};
}
template <class Encoding>
concept has_texels_form = requires(image_view<const typename Encoding::texel> map, const Encoding& e) {
    texels_of(map, e);
};

/// Memory for a map, which an image would fill with zeros first.
struct unset_floats {
    explicit unset_floats(std::size_t count) : texels(new float[count]) {}
    ~unset_floats() { delete[] texels; }
    unset_floats(const unset_floats&) = delete;
    unset_floats& operator=(const unset_floats&) = delete;

    float* const texels;
};

/// Calls use(map) with the map as a form wants it. The map is decoded where that is less work than the receivers.
/// @return   false where it is not, or where the form cannot take such a map
template <class Form, class Encoding, class ParallelFor, class Use>
bool with_map(image_view<const typename Encoding::texel> map, const Encoding& encoding, glm::ivec2 receivers,
              ParallelFor&& parallel, const Use& use) {
    using texel = typename Encoding::texel;
    constexpr bool floats = std::is_same_v<Encoding, depth32f>;
    if (map.size.x < Form::least || map.size.y < Form::least) return false;
    if constexpr (floats || (Form::need == map_need::texels && has_texels_form<Encoding>)) {
        if (!texel_bytes<const texel>::fits(map)) return false;
        use(texels_of(map, encoding));
    } else {
        const auto area = [](glm::ivec2 size) { return static_cast<double>(size.x) * size.y; };
        if (area(map.size) >= 16.0 * area(receivers)) return false;
        const auto texels = static_cast<std::size_t>(map.size.x) * static_cast<std::size_t>(map.size.y);
        const unset_floats memory(texels);
        const image_view<float> depths(memory.texels, map.size);
        if (!texel_bytes<const float>::fits(depths)) return false;
        decode(map, depths, encoding, parallel);
        use(float_texels{depths});
    }
    return true;
}

template <class Encoding, class Receivers, class Filter, class ParallelFor>
void filter_image(image_view<const typename Encoding::texel> map, const Encoding& encoding, const Receivers& receivers,
                  const Filter& filter, image_view<float> out, ParallelFor&& parallel, outside_map outside) {
    static_assert(is_encoding<Encoding>() && is_filter<Filter>());
    if (size_of(receivers) != out.size) fail("umbrage::visibility: sizes differ");
    if (map.empty()) fail("umbrage::visibility: empty map");
    if (out.empty()) return;
    const auto rows = [&](const auto& blocks) {
        parallel(out.size.y, [&](int first, int last) { filter_rows(receivers, blocks, out, first, last); });
    };
    const auto clamped_map = decoded(map, encoding);
    const auto bordered_map = [&, far = far_depth(encoding, filter)](glm::ivec2 texel) {
        const bool inside = texel.x >= 0 && texel.y >= 0 && texel.x < map.size.x && texel.y < map.size.y;
        return inside ? encoding.decode(map.row(texel.y)[texel.x]) : far;
    };
    if constexpr (has_block_form<Filter>) {
        using form = block_form<Filter>;
        const bool done = with_map<form>(map, encoding, out.size, parallel, [&](const auto& texels) {
            if (filter.is_lit.direction == depth_direction::forward)
                form::template with_blocks<depth_direction::forward>(texels, filter, parallel, rows);
            else form::template with_blocks<depth_direction::reversed>(texels, filter, parallel, rows);
        });
        if (!done) filter_each(receivers, filter, erase(clamped_map), out, parallel);
        if (outside == outside_map::lit) light_outside(receivers, map.size, filter, erase(bordered_map), out, parallel);
    } else if (outside == outside_map::lit) {
        filter_each(receivers, filter, bordered_map, out, parallel);
    } else {
        filter_each(receivers, filter, clamped_map, out, parallel);
    }
}

}  // namespace detail

/// @param map         shadow map, texels of the encoding
/// @param encoding    how the map's texels hold depth; its edge decides ties
/// @param receivers   (x, y) in texels of the map, z depth, biased
/// @param filter      one of filters::, the direction of the map's depth in its is_lit, or any callable
///                    (fetch, coord, receiver) -> visibility, or one that takes the receiver's pixel besides, an ivec2
/// @param out         visibility, 1 lit; same size as receivers
/// @param parallel    cuts the rows into pieces, see parallel.hpp; the filter is then called from all of them
/// @param outside     what counts outside the map
/// @throws std::invalid_argument  sizes differ, or the map is empty
template <class Encoding, class Filter, class ParallelFor = serial>
void visibility(image_view<const typename Encoding::texel> map, const Encoding& encoding,
                image_view<const glm::vec3> receivers, const Filter& filter, image_view<float> out,
                ParallelFor&& parallel = {}, outside_map outside = outside_map::clamped) {
    detail::filter_image(map, encoding, receivers, filter, out, parallel, outside);
}

/// Receivers as a structure of arrays.
template <class Encoding, class Filter, class ParallelFor = serial>
void visibility(image_view<const typename Encoding::texel> map, const Encoding& encoding,
                const receiver_planes& receivers, const Filter& filter, image_view<float> out,
                ParallelFor&& parallel = {}, outside_map outside = outside_map::clamped) {
    detail::filter_image(map, encoding, receivers, filter, out, parallel, outside);
}

/// Receivers from a camera's depth image: visibility of receiver_at for each of its texels.
template <class Encoding, class Filter, class ParallelFor = serial>
void visibility(image_view<const typename Encoding::texel> map, const Encoding& encoding,
                const depth_receivers& receivers, const Filter& filter, image_view<float> out,
                ParallelFor&& parallel = {}, outside_map outside = outside_map::clamped) {
    detail::filter_image(map, encoding, receivers, filter, out, parallel, outside);
}

}  // namespace umbrage

// ---- umbrage/light/adaptive/pages.hpp
// Which pages of a light's root square a view needs, so that shadows are as fine as the screen, and which of an
// atlas' slots hold them: pages stay where they are from frame to frame, those least recently needed are given up.
//
//     umbrage::page_cache cache({.slots = {16, 16}, .deepest_level = 10});
//     for (;;) {  // receivers: umbrage::page_receiver{coordinate in the root, longest_extent in a map of one page}
//         const umbrage::page_update update = cache.update(receivers);
//         umbrage::draw_pages(atlas, layout, root, update.drawn, draw);  // see images/page_atlas.hpp
//     }
//

namespace umbrage {

/// A square of the root, whose side is the root's over 2^level: the x-th from the left, the y-th from the first row.
struct page {
    int level = 0, x = 0, y = 0;

    friend auto operator<=>(const page&, const page&) = default;  ///< coarse ones first
};

/// The page of a level that holds a point.
/// @param coord   1 .. 2 across the root, 2 not included
[[nodiscard]] inline page page_at(glm::dvec2 coord, int level) {
    const double across = std::ldexp(1.0, level);
    return {level, static_cast<int>((coord.x - 1.0) * across), static_cast<int>((coord.y - 1.0) * across)};
}

/// A point that the view sees.
struct page_receiver {
    glm::vec2 coord{1};   ///< 1 .. 2 across the root
    float extent = 0.0f;  ///< longest_extent of a texel of the coarsest page, pixels
};

namespace detail {

/// The least level in which no texel's longer axis covers more pixels than wanted; -1 of receivers that want none.
[[nodiscard]] inline int wanted_level(const page_receiver& r, double target, int deepest) {
    const auto in_root = [](float v) { return v >= 1.0f && v < 2.0f; };
    if (!in_root(r.coord.x) || !in_root(r.coord.y) || !is_finite(r.extent) || !(r.extent > 0.0f)) return -1;
    return static_cast<int>(std::clamp(std::ceil(std::log2(double(r.extent) / target)), 0.0, double(deepest)));
}

}  // namespace detail

/// The pages of the least level in which no texel's longer axis covers more pixels than wanted.
/// @param receivers       those beside the root, and of an extent that is not finite or not above 0, want none
/// @param target          pixels, > 0
/// @param deepest_level   0 .. 15, whatever that leaves
/// @return                each once, coarse ones first
/// @formula               level = ceil(log2(extent / target))
/// @throws std::invalid_argument  target or deepest_level out of range
[[nodiscard]] inline std::vector<page> wanted_pages(std::span<const page_receiver> receivers, double target,
                                                    int deepest_level) {
    constexpr auto function = "wanted_pages";
    detail::require(is_finite(target) && target > 0.0, function, "target", "must be finite and above 0");
    detail::require(deepest_level >= 0 && deepest_level <= deepest_page_level, function, "deepest_level",
                    "must lie between 0 and 15");
    std::vector<page> pages;
    for (const page_receiver& r : receivers) {
        const int level = detail::wanted_level(r, target, deepest_level);
        if (level < 0) continue;
        const page p = page_at(r.coord, level);
        if (pages.empty() || p != pages.back()) pages.push_back(p);
    }
    std::sort(pages.begin(), pages.end());
    pages.erase(std::unique(pages.begin(), pages.end()), pages.end());
    return pages;
}

/// What a cache is made for.
struct page_budget {
    glm::ivec2 slots{16};    ///< columns and rows of pages that the atlas has, each 1 .. 256
    int deepest_level = 10;  ///< 0 .. 15: of the finest pages; a table has 2^deepest_level texels a side
    double target = 1.0;     ///< pixels that a texel may cover, > 0
};

/// A page and where the atlas holds it.
struct placed_page {
    umbrage::page page;
    glm::ivec2 slot;
};

/// What has changed from one view to the next.
struct page_update {
    std::vector<placed_page> drawn{};  ///< pages that are to be drawn, coarse ones first
    double target = 0.0;               ///< pixels that a texel covers at most: the budget's target, or more
    std::size_t kept = 0;              ///< pages needed that were there
    std::size_t given_up = 0;          ///< pages that others took the place of,
    std::size_t forced = 0;            ///< and of these such as the view needs for the budget's target: shadows pop
};

/// Pages that stay in their slots as long as nothing finer, nearer or newer wants these.
///
/// The root's own page is always there, so that there is shadow everywhere in it; where the view needs no finer pages
/// any more, those that are left serve until others need their slots. Where the wanted pages are more than the slots,
/// the target is raised by steps of a sixteenth of an octave until they fit; it comes down again when as many as seven
/// eighths of the slots suffice, so that it does not swing.
/// @cite   Fernando, Fernandez, Bala, Greenberg: Adaptive Shadow Maps, SIGGRAPH 2001
class page_cache {
public:
    /// @throws std::invalid_argument  slots, deepest_level or target out of range
    explicit page_cache(const page_budget& budget) : budget_(budget), target_(budget.target) {
        constexpr auto function = "page_cache";
        const auto fits = [](int n) { return n >= 1 && n <= 256; };
        detail::require(fits(budget.slots.x) && fits(budget.slots.y), function, "slots", "must be 1 to 256 each");
        detail::require(budget.deepest_level >= 0 && budget.deepest_level <= deepest_page_level, function,
                        "deepest_level", "must lie between 0 and 15");
        detail::require(is_finite(budget.target) && budget.target > 0.0, function, "target",
                        "must be finite and above 0");
        for (glm::ivec2 slot{0}; slot.y < budget.slots.y; ++slot.y)
            for (slot.x = 0; slot.x < budget.slots.x; ++slot.x) free_.push_back(slot);
        std::reverse(free_.begin(), free_.end());
    }

    /// Takes in what a view sees.
    page_update update(std::span<const page_receiver> receivers) {
        ++now_;
        page_update result;
        std::vector<page> missing;
        for (const page& p : fitting(receivers))
            if (const auto found = resident_.find(p); found != resident_.end())
                found->second.needed = now_, ++result.kept;
            else missing.push_back(p);
        const std::vector<page> given_up =
            give_up(missing.size() > free_.size() ? missing.size() - free_.size() : std::size_t(0));
        for (const page& p : missing) {
            result.drawn.push_back({p, free_.back()});
            resident_[p] = {free_.back(), now_};
            free_.pop_back();
        }
        result.target = target_;
        result.given_up = given_up.size();
        if (target_ > budget_.target && !given_up.empty()) result.forced = popped(receivers, given_up);
        return result;
    }

    /// All that must be drawn anew: casters or the light have moved.
    void forget() {
        for (const auto& [p, in] : resident_) free_.push_back(in.slot);
        resident_.clear();
    }

    [[nodiscard]] const page_budget& budget() const { return budget_; }
    [[nodiscard]] std::size_t size() const { return resident_.size(); }

    /// Calls use(page, slot) for every page that is there, coarse ones first.
    template <class Use>
    void for_each(Use&& use) const {
        for (const auto& [p, in] : resident_) use(p, in.slot);
    }

    /// The level of the finest page that holds a point; -1 where there is none.
    /// @param coord   1 .. 2 across the root, 2 not included
    [[nodiscard]] int level_at(glm::dvec2 coord) const {
        int level = budget_.deepest_level;
        while (level >= 0 && !resident_.contains(page_at(coord, level))) --level;
        return level;
    }

private:
    struct held {
        glm::ivec2 slot;
        std::uint64_t needed;  ///< in which update last
    };

    [[nodiscard]] std::size_t slots() const {
        return static_cast<std::size_t>(budget_.slots.x) * static_cast<std::size_t>(budget_.slots.y);
    }

    /// The root and what is wanted besides, with the target moved until it fits.
    [[nodiscard]] std::vector<page> fitting(std::span<const page_receiver> receivers) {
        const double step = std::exp2(1.0 / 16.0);
        const auto wanted = [&](double target) {
            std::vector<page> pages = wanted_pages(receivers, target, budget_.deepest_level);
            if (pages.empty() || pages.front() != page{}) pages.insert(pages.begin(), page{});
            return pages;
        };
        std::vector<page> pages = wanted(target_);
        while (pages.size() > slots()) pages = wanted(target_ *= step);
        while (target_ > budget_.target) {
            const double finer = std::max(target_ / step, budget_.target);
            std::vector<page> more = wanted(finer);
            if (more.size() * 8 > slots() * 7) break;
            target_ = finer;
            pages.swap(more);
        }
        return pages;
    }

    /// Frees slots: of the pages not needed now the least recently needed, of these the finest.
    /// @return   the pages, in their order
    std::vector<page> give_up(std::size_t count) {
        std::vector<std::pair<std::uint64_t, page>> others;
        for (const auto& [p, in] : resident_)
            if (in.needed < now_) others.emplace_back(in.needed, p);
        std::sort(others.begin(), others.end(), [](const auto& a, const auto& b) {
            return a.first != b.first ? a.first < b.first : b.second < a.second;
        });
        std::vector<page> pages;
        for (std::size_t i = 0; i < count; ++i) {
            const page p = pages.emplace_back(others[i].second);
            free_.push_back(resident_[p].slot);
            resident_.erase(p);
        }
        std::sort(pages.begin(), pages.end());
        return pages;
    }

    /// How many of the pages given up some receiver looked into that the budget's target would have it look into still.
    [[nodiscard]] std::size_t popped(std::span<const page_receiver> receivers,
                                     const std::vector<page>& given_up) const {
        std::vector<bool> pops(given_up.size());
        for (const page_receiver& r : receivers) {
            const int asked = detail::wanted_level(r, budget_.target, budget_.deepest_level);
            const int found = asked < 0 ? asked : level_at(r.coord);
            if (found >= asked) continue;
            for (int level = budget_.deepest_level; level > found; --level) {
                const auto at = std::lower_bound(given_up.begin(), given_up.end(), page_at(r.coord, level));
                if (at == given_up.end() || *at != page_at(r.coord, level)) continue;
                pops[static_cast<std::size_t>(at - given_up.begin())] = true;
                break;
            }
        }
        return static_cast<std::size_t>(std::count(pops.begin(), pops.end(), true));
    }

    page_budget budget_;
    double target_;
    std::uint64_t now_ = 0;
    std::map<page, held> resident_;
    std::vector<glm::ivec2> free_;
};

}  // namespace umbrage

// ---- umbrage/light/sweep.hpp
// What receivers sweep on their way to the light, as casters have to lie in it: the hull of what the light sees of
// them, and how near to the light a box of casters comes within it. What fits share.
//

namespace umbrage {
namespace detail {

/// In the name of a function whose argument they are.
inline void require_receivers(const hull& receivers, const char* function) {
    const auto finite = [](const glm::dvec3& p) { return all_finite(p); };
    require(!receivers.points.empty(), function, "receivers", "must not be empty");
    require(std::all_of(receivers.points.begin(), receivers.points.end(), finite) && is_finite(receivers.radius) &&
                receivers.radius >= 0.0,
            function, "receivers", "must be finite");
}

/// Points whose hull holds all receivers: in place of a ball the corners of its box.
[[nodiscard]] inline std::vector<glm::dvec3> corners_of(const hull& receivers) {
    if (!(receivers.radius > 0.0)) return receivers.points;
    std::vector<glm::dvec3> all;
    for (const glm::dvec3& p : receivers.points)
        for (const glm::dvec3& c : corners(bounding_box<double>{p - receivers.radius, p + receivers.radius}))
            all.push_back(c);
    return all;
}

/// World to x, y and the distance along the light.
template <real T>
[[nodiscard]] glm::dmat4 light_frame(const glm::mat<4, 4, T>& view, handedness hand) {
    glm::dmat4 frame(view);
    if (hand == handedness::right)
        for (glm::length_t i = 0; i < 4; ++i) frame[i][2] = -frame[i][2];
    return frame;
}

[[nodiscard]] inline std::vector<glm::dvec3> seen(const glm::dmat4& frame, const std::vector<glm::dvec3>& points) {
    std::vector<glm::dvec3> moved;
    moved.reserve(points.size());
    for (const glm::dvec3& p : points) moved.emplace_back(frame * glm::dvec4(p, 1.0));
    return moved;
}

struct extent {
    glm::dvec3 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
};
[[nodiscard]] inline extent extent_of(const std::vector<glm::dvec3>& points) {
    extent e;
    for (const glm::dvec3& p : points) e.low = glm::min(e.low, p), e.high = glm::max(e.high, p);
    return e;
}

/// Counter-clockwise, without what lies on an edge.
/// @cite   Andrew: Another efficient algorithm for convex hulls in two dimensions, 1979
[[nodiscard]] inline std::vector<glm::dvec2> convex_hull(const std::vector<glm::dvec3>& seen) {
    std::vector<glm::dvec2> points(seen.begin(), seen.end()), hull;
    const auto before = [](glm::dvec2 a, glm::dvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
    std::sort(points.begin(), points.end(), before);
    const auto turns_right = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
        return (b.x - a.x) * (c.y - a.y) <= (b.y - a.y) * (c.x - a.x);
    };
    for (int side = 0; side < 2; ++side, std::reverse(points.begin(), points.end())) {
        const std::size_t first = hull.size();
        for (const glm::dvec2& p : points) {
            while (hull.size() >= first + 2 && turns_right(hull[hull.size() - 2], hull.back(), p)) hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();  // the other side begins with it
    }
    return hull;
}

/// What the hull of points has in common with a half-space, as points around it: those inside, and of where the lines
/// between them and the others cross the plane the outermost.
[[nodiscard]] inline std::vector<glm::dvec3> clipped_hull(const std::vector<glm::dvec3>& points,
                                                          const glm::dvec4& plane) {
    const glm::dvec3 normal(plane), steep = glm::abs(normal);
    const glm::length_t z = steep.x > steep.y ? (steep.x > steep.z ? 0 : 2) : (steep.y > steep.z ? 1 : 2);
    const glm::length_t x = (z + 1) % 3, y = (z + 2) % 3;
    const auto inside = [&](const glm::dvec3& p) { return glm::dot(normal, p) + plane.w; };
    std::vector<glm::dvec3> kept, beyond, crossed;
    for (const glm::dvec3& p : points) (inside(p) < 0.0 ? beyond : kept).push_back(p);
    const auto keep_outermost = [&] {
        if (crossed.size() < 3) return;
        const std::vector<glm::dvec2> corners = convex_hull(crossed);
        crossed.clear();
        for (const glm::dvec2& c : corners) crossed.emplace_back(c, 0.0);
    };
    std::size_t enough = 1024;
    for (const glm::dvec3& a : kept) {
        for (const glm::dvec3& b : beyond) {
            const glm::dvec3 p = a + (b - a) * (inside(a) / (inside(a) - inside(b)));
            crossed.emplace_back(p[x], p[y], 0.0);
        }
        if (crossed.size() < enough) continue;
        keep_outermost();
        enough = 2 * crossed.size() + 1024;
    }
    keep_outermost();
    for (const glm::dvec3& c : crossed) {
        glm::dvec3 p;
        p[x] = c.x, p[y] = c.y, p[z] = -(normal[x] * c.x + normal[y] * c.y + plane.w) / normal[z];
        kept.push_back(p);
    }
    return kept;
}

/// A plane (a, b, 0, c) through each edge of a hull, moved outwards; none through edges between points that only
/// rounding tells apart: their direction says nothing.
[[nodiscard]] inline std::vector<glm::dvec4> sides(const std::vector<glm::dvec2>& hull, double outwards) {
    std::vector<glm::dvec4> planes;
    const auto end_of = [&](std::size_t i) { return hull[i + 1 < hull.size() ? i + 1 : 0]; };
    double longest = 0.0;
    for (std::size_t i = 0; i < hull.size(); ++i) longest = glm::max(longest, glm::distance(hull[i], end_of(i)));
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const glm::dvec2 a = hull[i], b = end_of(i), inwards(a.y - b.y, b.x - a.x);
        if (glm::length(inwards) <= longest * 0x1p-32) continue;
        planes.emplace_back(inwards, 0.0, outwards * glm::length(inwards) - glm::dot(inwards, a));
    }
    return planes;
}

/// Planes of the same kind around what points sweep, moved outwards: their hull's, within their rectangle's.
[[nodiscard]] inline std::vector<glm::dvec4> sweep(const std::vector<glm::dvec3>& seen, double outwards) {
    std::vector<glm::dvec4> planes = sides(convex_hull(seen), outwards);
    const auto [least, greatest] = extent_of(seen);
    const glm::dvec3 low = least - outwards, high = greatest + outwards;
    planes.insert(planes.end(), {{1, 0, 0, -low.x}, {-1, 0, 0, high.x}, {0, 1, 0, -low.y}, {0, -1, 0, high.y}});
    return planes;
}

/// The least distance along the light of a box's faces within planes; infinite where none is.
[[nodiscard]] inline double nearest(const glm::dmat4& frame, const polyhedron& box,
                                    const std::vector<glm::dvec4>& planes) {
    double least = std::numeric_limits<double>::infinity();
    for (const polyhedron::face& face : box.faces()) {
        std::vector<glm::dvec3> polygon = seen(frame, face.corners);
        for (const glm::dvec4& plane : planes) polygon = clipped(polygon, plane);
        for (const glm::dvec3& p : polygon) least = std::min(least, p.z);
    }
    return least;
}

}  // namespace detail
}  // namespace umbrage

// ---- umbrage/light/adaptive/root.hpp
// The square of the world that the pages of an adaptive map lie in, as a directional light sees it: it stays where it
// is while the camera moves, and so does every page in it.
//
//     auto root = umbrage::make_page_root<double>({.direction = d, .centre = {0, 0, 0}, .side = 2400, .scene = box});
//     auto light = umbrage::page_light(root, {.level = 5, .x = 12, .y = 9}, {});  // for the depth pass of that page
//     glm::mat4 to_root(umbrage::page_matrix(root));                              // for page_coordinate
//

namespace umbrage {

template <real T = float>
struct page_root {
    glm::vec<3, T> direction{T(0), T(-1), T(0)};  ///< of the light, any length > 0
    glm::vec<3, T> up{T(0), T(1), T(0)};          ///< hint; of the world, as pages turn with it
    glm::vec<3, T> centre{T(0)};                  ///< of the square, world
    T side = T(1000);                             ///< world units, > 0
    bounding_box<T> scene{};                      ///< all casters and receivers: what depth spans
    clip_space clip{};
};

/// Side of pages in an atlas.
struct page_size {
    int texels = 128;  ///< a power of two
    int gutter = 4;    ///< around them, 0 .. texels / 2: the filter's reach and half a texel, or more

    [[nodiscard]] constexpr int pitch() const { return texels + 2 * gutter; }
};

/// @throws std::invalid_argument  zero or non-finite direction, centre or scene that are not finite, a side not above
///                                0, and what gives matrices that are not finite
template <real T = float>
[[nodiscard]] light_space<T> make_page_root(const page_root<T>& root) {
    constexpr auto function = "make_page_root";
    detail::require(detail::all_finite(root.centre), function, "centre", "must be finite");
    detail::require(is_finite(root.side) && root.side > T(0), function, "side", "must be finite and above 0");
    light_space<double> light{detail::look_along(glm::dvec3(0), glm::dvec3(root.direction), glm::dvec3(root.up),
                                                 root.clip.hand, function, ""),
                              {},
                              root.clip};
    const glm::dmat4 frame = detail::light_frame(light.view, root.clip.hand);
    const auto depths = detail::extent_of(detail::seen(frame, hull(root.scene).points));
    const glm::dvec2 middle(frame * glm::dvec4(glm::dvec3(root.centre), 1)), half(double(root.side) / 2);
    const double spare =
        (depths.high.z - depths.low.z) / 1024 + double(root.side) / 1048576;  // nothing lies on a plane
    light.projection = detail::orthographic(middle - half, middle + half, depths.low.z - spare, depths.high.z + spare,
                                            root.clip, function, "centre and side", "scene");
    const light_space<T> cast{glm::mat<4, 4, T>(light.view), glm::mat<4, 4, T>(light.projection), root.clip};
    return detail::checked(cast, function, "centre, side and scene");
}

/// World to the root's coordinates, 1 .. 2, and depth.
/// @formula   texture_matrix of a map of one texel, moved by 1
template <real T>
[[nodiscard]] glm::mat<4, 4, T> page_matrix(const light_space<T>& root) {
    glm::mat<4, 4, T> m = texture_matrix(root, glm::ivec2(1));
    m[3][0] += T(1), m[3][1] += T(1);
    return m;
}

/// One page of it, with its gutter: what a depth pass of pitch() x pitch() texels is drawn with.
/// @throws std::invalid_argument  a page that is not in the root, texels no power of two, gutter out of range
template <real T>
[[nodiscard]] light_space<T> page_light(const light_space<T>& root, const page& p, const page_size& size) {
    constexpr auto function = "page_light";
    detail::require(p.level >= 0 && p.level <= deepest_page_level, function, "level", "must lie between 0 and 15");
    const int across = 1 << p.level;
    detail::require(p.x >= 0 && p.y >= 0 && p.x < across && p.y < across, function, "x and y", "must lie in the root");
    detail::require(size.texels >= 1 && (size.texels & (size.texels - 1)) == 0, function, "texels",
                    "must be a power of two");
    detail::require(size.gutter >= 0 && size.gutter <= size.texels / 2, function, "gutter",
                    "must lie between 0 and half the texels");
    const double scale = double(across) * size.texels / size.pitch();
    const double up = root.clip.origin == texture_origin::bottom ? 1.0 : -1.0;
    const glm::dvec2 middle((2 * p.x + 1.0) / across - 1.0, up * ((2 * p.y + 1.0) / across - 1.0));
    glm::dmat4 projection(root.projection);
    for (glm::length_t axis = 0; axis < 2; ++axis)
        for (glm::length_t column = 0; column < 4; ++column)
            projection[column][axis] = (projection[column][axis] - projection[column][3] * middle[axis]) * scale;
    return detail::checked<T>({root.view, glm::mat<4, 4, T>(projection), root.clip}, function, "root");
}

}  // namespace umbrage

// ---- umbrage/images/page_atlas.hpp
// Adaptive shadow maps over images: the depth pass of pages into an atlas, the table that finds them, and a whole image
// of receivers against both.
//
//     umbrage::image<float> atlas(umbrage::page_atlas_size(cache, size), umbrage::cleared_depth(clip));
//     umbrage::draw_pages(atlas, size, root, cache.update(receivers).drawn, [&](auto map, const glm::mat4& to_clip) {
//         umbrage::rasterize_depth(map, tree, umbrage::instances_in_map(box, trees, to_clip, clip), to_clip, clip);
//     });
//     umbrage::image<glm::u8vec4> table(umbrage::page_table_size(cache));
//     umbrage::write_page_table(cache, table);
//     umbrage::page_visibility({atlas, table, size}, umbrage::depth32f{}, seen, umbrage::filters::pcf_2x2{}, out);
//

namespace umbrage {

/// Texels of an atlas with a slot for every page that a cache may hold.
[[nodiscard]] inline glm::ivec2 page_atlas_size(const page_cache& cache, const page_size& size) {
    return cache.budget().slots * size.pitch();
}

/// Texels of a table with one for each of a cache's finest cells, and one around them.
[[nodiscard]] inline glm::ivec2 page_table_size(const page_cache& cache) {
    return glm::ivec2((1 << cache.budget().deepest_level) + 2);
}

/// Clears pages and draws them.
///
/// @param root    in double, from which matrices of pages are made and rounded once
/// @param pages   what page_cache::update gives
/// @param draw    (image_view<float> map, const glm::mat4& world_to_clip): a depth pass under root.clip; called once
///                for each page, with its gutter
/// @throws std::invalid_argument  a slot beyond the atlas, and what page_light complains of
template <class Draw>
void draw_pages(image_view<float> atlas, const page_size& size, const light_space<double>& root,
                std::span<const placed_page> pages, Draw&& draw) {
    for (const auto& [page, slot] : pages) {
        const light_space<double> light = page_light(root, page, size);
        const image_view<float> map = atlas.region(slot * size.pitch(), glm::ivec2(size.pitch()));
        for (int y = 0; y < map.size.y; ++y) std::fill_n(map.row(y), map.size.x, cleared_depth(root.clip));
        draw(map, glm::mat4(light.projection * light.view));
    }
}

/// The finest page of each cell.
/// @param table   of page_table_size, gets a page_entry for each of the cache's finest cells, row 1 the root's first;
///                no page, and around the root: zeros
/// @throws std::invalid_argument  a table of another size
inline void write_page_table(const page_cache& cache, image_view<glm::u8vec4> table) {
    detail::require(table.size == page_table_size(cache), "write_page_table", "table",
                    "must have 2^deepest_level + 2 a side");
    for (int y = 0; y < table.size.y; ++y) std::fill_n(table.row(y), table.size.x, glm::u8vec4(0));
    cache.for_each([&](const page& p, glm::ivec2 slot) {
        const int cells = (table.size.x - 2) >> p.level;
        for (int y = p.y * cells; y < (p.y + 1) * cells; ++y)
            std::fill_n(table.row(1 + y) + 1 + p.x * cells, cells, page_entry(slot, p.level));
    });
}

/// What a receiver's page is found in.
template <class Texel>
struct page_map {
    image_view<const Texel> atlas;
    image_view<const glm::u8vec4> table;  ///< of page_entry, a power of two and 2 a side
    page_size size{};
};

namespace detail {

template <class Encoding, class Receivers, class Filter, class ParallelFor>
void filter_pages(const page_map<typename Encoding::texel>& map, const Encoding& encoding, const Receivers& receivers,
                  const Filter& filter, image_view<float> out, ParallelFor&& parallel) {
    constexpr auto function = "page_visibility";
    const int side = map.table.size.x, pitch = map.size.pitch();
    require(size_of(receivers) == out.size, function, "out", "must have the receivers' size");
    require(side >= 3 && map.table.size.y == side && ((side - 2) & (side - 3)) == 0, function, "table",
            "must be a square of a power of two and 2");
    require(map.size.texels >= 1 && map.size.gutter >= 0, function, "size", "must be a page's");
    if constexpr (requires { filter.reach(); })
        require(float(map.size.gutter) >= filter.reach(), function, "gutter", "must be the filter's reach or more");
    for (int y = 0; y < side; ++y)
        for (const glm::u8vec4& entry : std::span(map.table.row(y), static_cast<std::size_t>(side)))
            require(glm::all(glm::lessThanEqual((glm::ivec2(entry) + 1) * pitch, map.atlas.size)), function, "table",
                    "has slots beyond the atlas");
    const auto table = [&](glm::ivec2 cell) { return map.table[cell]; };
    const auto page = static_cast<float>(map.size.texels), gutter = static_cast<float>(map.size.gutter);
    for_each_receiver(receivers, out, parallel, [&](float& visibility, glm::vec2 coord, float depth, glm::ivec2 pixel) {
        const glm::vec4 at = page_coordinate(table, static_cast<float>(side), coord, page, gutter);
        const auto texels = map.atlas.region(glm::ivec2(at.z, at.w), glm::ivec2(pitch));
        visibility = filtered(filter, decoded(texels, encoding), glm::vec2(at), depth, pixel);
    });
}

}  // namespace detail

/// @param map         atlas, table and the pages' size, which draw_pages and write_page_table were given
/// @param encoding    how the atlas' texels hold depth; its edge decides ties
/// @param receivers   (x, y) from 1 to 2 across the root, z depth, biased; what has no page, and what lies beside the
///                    root, is lit
/// @param filter      one of filters::, the direction of the map's depth in its is_lit, or any callable as for
///                    visibility; it does not read beyond a page and its gutter
/// @param out         visibility, 1 lit; same size as receivers
/// @param parallel    cuts the rows into pieces, see parallel.hpp
/// @throws std::invalid_argument  sizes differ, a table that is no square of a power of two and 2 or has slots
///                                beyond the atlas, a gutter below the filter's reach
/// @exactness         the bits of the filter alone over each receiver's page
template <class Encoding, class Filter, class ParallelFor = serial>
void page_visibility(const page_map<typename Encoding::texel>& map, const Encoding& encoding,
                     image_view<const glm::vec3> receivers, const Filter& filter, image_view<float> out,
                     ParallelFor&& parallel = {}) {
    detail::filter_pages(map, encoding, receivers, filter, out, parallel);
}
template <class Encoding, class Filter, class ParallelFor = serial>
void page_visibility(const page_map<typename Encoding::texel>& map, const Encoding& encoding,
                     const receiver_planes& receivers, const Filter& filter, image_view<float> out,
                     ParallelFor&& parallel = {}) {
    detail::filter_pages(map, encoding, receivers, filter, out, parallel);
}
template <class Encoding, class Filter, class ParallelFor = serial>
void page_visibility(const page_map<typename Encoding::texel>& map, const Encoding& encoding,
                     const depth_receivers& receivers, const Filter& filter, image_view<float> out,
                     ParallelFor&& parallel = {}) {
    detail::filter_pages(map, encoding, receivers, filter, out, parallel);
}

}  // namespace umbrage

// ---- umbrage/images/prefilter.hpp
// Whole prefiltered maps: depth to moments, their mip chain, and what an image of receivers sees of them.
//
//     const umbrage::prefilters::vsm filter{.min_variance = 1e-5f};
//     umbrage::image<glm::vec2> moments(depth.size()), blurred(depth.size());
//     umbrage::encode_moments(depth, moments, filter);
//     umbrage::blur(moments, blurred, umbrage::make_gaussian_kernel(7, 1.5f));
//     umbrage::look_up(blurred, receivers, filter, visibility);
//

namespace umbrage {
namespace detail {

/// A block of texels, channel after channel: only so do loops over them vectorise.
template <class Texel>
struct texel_planes {
    static constexpr int channels = static_cast<int>(sizeof(Texel) / sizeof(float));

    alignas(64) float values[channels * block];

    UMBRAGE_INLINE void set(int i, const Texel& t) {
        if constexpr (channels == 1) values[i] = t;
        else values[i] = t.x, values[block + i] = t.y;
        if constexpr (channels == 4) values[2 * block + i] = t.z, values[3 * block + i] = t.w;
    }
    [[nodiscard]] UMBRAGE_INLINE Texel operator[](int i) const {
        if constexpr (channels == 1) return values[i];
        else if constexpr (channels == 2) return {values[i], values[block + i]};
        else return {values[i], values[block + i], values[2 * block + i], values[3 * block + i]};
    }
    UMBRAGE_INLINE void copy_to(Texel* to) const {
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) to[i] = (*this)[i];
    }
};

/// fetch_bilinear for a block of receivers, channel after channel; those that are not compared get some texel.
template <class Texel>
struct bilinear_block {
    static constexpr int channels = texel_planes<Texel>::channels;

    texel_planes<Texel> means;
    alignas(64) std::int32_t compared[block], left[block], right[block], low[block], high[block];
    alignas(64) float hi_x[block], hi_y[block];

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& r, glm::ivec2 size, bool forward) {
        const auto axis = [](float coord, int highest, float& hi, std::int32_t& here, std::int32_t& next)
                              UMBRAGE_INLINE {
                                  const std::int32_t x = floor_int(coord * 256.0f) - 128;
                                  here = clamp_int(x >> 8, highest);
                                  next = clamp_int((x >> 8) + 1, highest);
                                  hi = static_cast<float>(x & 255);
                              };
        const std::int32_t towards_far = forward ? -1 : 0;
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            const float x = r.x(i), y = r.y(i);
            const std::int32_t beyond =
                (beyond_far_mask<true>(r.z(i)) & towards_far) | (beyond_far_mask<false>(r.z(i)) & ~towards_far);
            const std::int32_t inside = texel_space_mask(x, y);
            compared[i] = inside & ~beyond;
            axis(masked(x, inside), size.x - 1, hi_x[i], left[i], right[i]);
            axis(masked(y, inside), size.y - 1, hi_y[i], low[i], high[i]);
        }
    }
    UMBRAGE_INLINE void fetch(const image_view<const Texel>& texels) {
        for (int i = 0; i < block; ++i) {
            const auto row = [&](int y) UMBRAGE_INLINE {
                return reinterpret_cast<const float*>(reinterpret_cast<const std::byte*>(texels.data) +
                                                      y * texels.stride);
            };
            const float *const below = row(low[i]), *const above = row(high[i]);
            const int l = left[i] * channels, h = right[i] * channels;
            const float hx = hi_x[i], hy = hi_y[i], lx = 256.0f - hx, ly = 256.0f - hy;
            float mean[channels];
            for (int c = 0; c < channels; ++c) {
                const float first = below[l + c] * lx + below[h + c] * hx;
                const float second = above[l + c] * lx + above[h + c] * hx;
                mean[c] = (first * ly + second * hy) * (1.0f / 65536.0f);
            }
            for (int c = 0; c < channels; ++c) means.values[c * block + i] = mean[c];
        }
    }
};

template <class Prefilter>
UMBRAGE_INLINE inline void decode_block(const Prefilter& filter, const texel_planes<typename Prefilter::texel>& means,
                                        const float* depths, float* visibility) {
    UMBRAGE_NO_OVERLAP
    for (int i = 0; i < block; ++i) visibility[i] = filter.decode(means[i], depths[i]);
}

/// decode_msm in three loops: compilers vectorise none that takes a root, as it may set errno. What knows more of the
/// depths goes on from there in one of its own.
template <class Prefilter>
requires requires(const Prefilter& f, typename Prefilter::texel t) { f.moments(t); }
UMBRAGE_INLINE inline void decode_block(const Prefilter& filter, const texel_planes<typename Prefilter::texel>& means,
                                        const float* depths, float* visibility) {
    alignas(64) float x[block], d[block], D[block], E[block], h[block], a[block], B[block], c[block], roots[block];
    const float far = cleared_depth(filter.direction);
    for (int i = 0; i < block; ++i) {
        const glm::vec4 m = filter.moments(means[i]);
        d[i] = forward_depth(depths[i], far);
        x[i] = moment_depth(d[i]) - m.x;
        const atom_equation<float> e(m, x[i]);
        D[i] = e.D, E[i] = e.E, h[i] = e.h, a[i] = e.a, B[i] = e.B, c[i] = e.c, roots[i] = e.square;
    }
    for (float& root : roots) root = std::sqrt(root);
    UMBRAGE_NO_OVERLAP
    for (int i = 0; i < block; ++i) {
        atom_equation<float> e;
        e.D = D[i], e.E = E[i], e.h = h[i], e.a = a[i], e.B = B[i], e.c = c[i];
        visibility[i] = lit_by_atoms(e.atoms(roots[i]), x[i], d[i]);
    }
    if constexpr (requires { filter.within(0.0f, glm::vec4(), 0.0f); }) {
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) visibility[i] = filter.within(visibility[i], filter.moments(means[i]), d[i]);
    }
}

}  // namespace detail

/// @param depth      any values; clamped to [0, 1], NaN counts as far
/// @param texels     same size
/// @param filter     one of prefilters::, or a type like them: texel, encode
/// @param parallel   cuts the rows into pieces, see parallel.hpp
/// @throws std::invalid_argument  sizes differ
/// @exactness        the filter's encode, bit for bit
template <class Prefilter, class ParallelFor = serial>
void encode_moments(image_view<const float> depth, image_view<typename Prefilter::texel> texels,
                    const Prefilter& filter, ParallelFor&& parallel = {}) {
    using texel = typename Prefilter::texel;
    if (depth.size != texels.size) detail::fail("umbrage::encode_moments: sizes differ");
    if (depth.empty()) return;
    parallel(depth.size.y, [&](int first, int last) {
        detail::on_best_isa_without_fma([&](auto) UMBRAGE_INLINE {
            const Prefilter own = filter;  // in registers
            for (int y = first; y < last; ++y) {
                detail::convert_row(depth.row(y), texels.row(y), depth.size.x,
                                    [&](const float* from, texel* to) UMBRAGE_INLINE {
                                        detail::texel_planes<texel> planes;
                                        for (int i = 0; i < detail::block; ++i) planes.set(i, own.encode(from[i]));
                                        planes.copy_to(to);
                                    });
            }
        });
    });
}

/// @param texels     of a prefiltered map: float, vec2, vec4
/// @param levels     how many: the first has half the size, rounded up, each next one half of that
/// @param parallel   cuts the rows into pieces, see parallel.hpp
/// @return           as many levels; a level of a single texel is followed by more of them
/// @throws std::invalid_argument  empty map, or negative levels
/// @exactness        halve_texels, bit for bit
template <class Texel, class ParallelFor = serial>
[[nodiscard]] std::vector<image<std::remove_const_t<Texel>>> make_mip_chain(image_view<Texel> texels, int levels,
                                                                            ParallelFor&& parallel = {}) {
    using texel = std::remove_const_t<Texel>;
    if (texels.empty() || levels < 0) detail::fail("umbrage::make_mip_chain: empty map or negative levels");
    std::vector<image<texel>> chain;
    for (int level = 0; level < levels; ++level) {
        const image_view<const texel> from =
            level ? std::as_const(chain.back()).view() : image_view<const texel>(texels);
        image<texel> next({(from.size.x + 1) / 2, (from.size.y + 1) / 2});
        parallel(next.size().y, [&, to = next.view()](int first, int last) {
            for (int y = first; y < last; ++y)
                for (int x = 0; x < to.size.x; ++x) to.row(y)[x] = halve_texels(clamped(from), glm::ivec2(x, y));
        });
        chain.push_back(std::move(next));
    }
    return chain;
}
template <class Texel, class ParallelFor = serial>
[[nodiscard]] std::vector<image<Texel>> make_mip_chain(const image<Texel>& texels, int levels,
                                                       ParallelFor&& parallel = {}) {
    return make_mip_chain(texels.view(), levels, parallel);
}

/// @param texels     a prefiltered map, blurred
/// @param receivers  (x, y) in texels of the map, z depth, biased: an image of vec3, receiver_planes, depth_receivers
/// @param filter     as encode_moments had it
/// @param out        visibility, 1 lit; same size as receivers
/// @param parallel   cuts the rows into pieces, see parallel.hpp
/// @throws std::invalid_argument  sizes differ, or the map is empty
/// @exactness        the filter's decode of fetch_bilinear, bit for bit; who is not compared is lit
template <class Prefilter, class Receivers, class ParallelFor = serial>
void look_up(image_view<const typename Prefilter::texel> texels, const Receivers& receivers, const Prefilter& filter,
             image_view<float> out, ParallelFor&& parallel = {}) {
    if (detail::size_of(receivers) != out.size) detail::fail("umbrage::look_up: sizes differ");
    if (texels.empty()) detail::fail("umbrage::look_up: empty map");
    if (out.empty()) return;
    const bool forward = filter.direction == depth_direction::forward;
    parallel(out.size.y, [&](int first, int last) {
        detail::on_best_isa_without_fma([&](auto set) UMBRAGE_INLINE {
            detail::bilinear_block<typename Prefilter::texel> of_block;
            alignas(64) float depths[detail::block], visibility[detail::block];
            const Prefilter own = filter;  // in registers
            for (detail::block_walk at{0, first, out.size.x}; at.y < last; at.step()) {
                detail::use_receivers(receivers, at, set, [&](const auto& r) UMBRAGE_INLINE {
                    of_block.place(r, texels.size, forward);
                    for (int i = 0; i < detail::block; ++i) depths[i] = r.z(i);
                });
                of_block.fetch(texels);
                detail::decode_block(own, of_block.means, depths, visibility);
                for (int i = 0; i < detail::block; ++i)
                    visibility[i] = detail::select(of_block.compared[i], visibility[i], 1.0f);
                detail::copy_floats(out.row(at.y) + at.x, visibility, at.count());
            }
        });
    });
}

}  // namespace umbrage

// ---- umbrage/images/stability.hpp
// How still a light's maps stand while the camera moves: whether points of the world keep their places between texels,
// and their light.
//
//     auto report = umbrage::measure_stability(frames, points.size(), [&](int frame) {
//         const auto maps = draw_maps(camera_at(frame));
//         return [&, maps](std::size_t i) {
//             return umbrage::placed_point{0, maps.texel(points[i]), maps.lit(points[i])};
//         };
//     });
//     std::printf("drift %g texels, %g %% flicker\n", report.drift, 100 * report.share());
//

namespace umbrage {

/// A point of the world in a frame's maps.
struct placed_point {
    int map = -1;          ///< number of the map or cascade that it is looked up in; below 0: in none
    glm::dvec2 texel{0};   ///< where in it, finite
    double visibility{0};  ///< of the filter
};

/// Over all points and frames.
struct stability_report {
    double change = 0;  ///< greatest, of a point's visibility in one map
    double drift = 0;   ///< of the grid against the world, texels: 0 where maps move by whole texels, at most 1/2
    std::size_t compared = 0;  ///< points that a map held in two frames or more
    std::size_t changed = 0;   ///< those of them whose visibility changed in one map

    /// Of points whose visibility changed.
    [[nodiscard]] double share() const { return compared ? double(changed) / double(compared) : 0; }
};

/// Measures a set-up over the frames of a moving camera, each point against the first frame in which the same map holds
/// it: what passes from one map to another is not compared.
///
/// @param frame   (int) -> what places points in that frame: (std::size_t point) -> placed_point
/// @throws std::invalid_argument  frames below 1
/// @formula       drift = max |m - nearest whole number to m|, m what a point has moved by through a map, in x or in y
template <class Frame>
[[nodiscard]] stability_report measure_stability(int frames, std::size_t points, Frame&& frame) {
    detail::require(frames >= 1, "measure_stability", "frames", "must be above 0");
    std::vector<std::vector<placed_point>> first;  // by map, then by point
    std::vector<char> compared(points), changed(points);
    stability_report report;
    for (int i = 0; i < frames; ++i) {
        auto&& place = frame(i);
        for (std::size_t k = 0; k < points; ++k) {
            const placed_point now = place(k);
            if (now.map < 0) continue;
            const auto map = static_cast<std::size_t>(now.map);
            if (map >= first.size()) first.resize(map + 1, std::vector<placed_point>(points));
            placed_point& then = first[map][k];
            if (then.map < 0) {
                then = now;
                continue;
            }
            const glm::dvec2 moved = now.texel - then.texel, off = glm::abs(moved - glm::round(moved));
            report.drift = glm::max(report.drift, glm::max(off.x, off.y));
            compared[k] = 1;
            const double change = glm::abs(now.visibility - then.visibility);
            report.change = glm::max(report.change, change);
            if (change != 0.0) changed[k] = 1;
        }
    }
    for (std::size_t k = 0; k < points; ++k) report.compared += compared[k] != 0, report.changed += changed[k] != 0;
    return report;
}

}  // namespace umbrage

// ---- umbrage/images/tessellate.hpp
// A mesh cut for maps in which straight edges are curves: until between vertices places and distances from the light
// are as good as straight lines between them.
//
//     auto cut = umbrage::tessellate(mesh, {light, umbrage::paraboloid_edge_angle(map_size, border), range});
//     umbrage::rasterize_dual_paraboloid(map.view(), cut.view(), space, 0);
//

namespace umbrage {

struct tessellated_mesh {
    std::vector<glm::vec3> positions;  ///< the mesh's own, then new ones; world
    std::vector<glm::uvec3> triangles;

    [[nodiscard]] mesh_view view() const { return {positions, triangles}; }
};

/// How finely a mesh is to be cut.
struct tessellation {
    glm::vec3 position{0};               ///< of the light, world
    float angle = 0.1f;                  ///< radians, > 0, of the greatest edge as the light sees it
    float range = 100;                   ///< of the light, > 0; edges wholly beyond it need not keep their distances
    float depth_error = 1.0f / 4096.0f;  ///< above 0, below 1: of distances between an edge's ends, over range
};

namespace detail {

class tessellator {
public:
    tessellator(const mesh_view& mesh, const tessellation& to)
        : light_(to.position),
          range_(double(to.range)),
          sag_(0.75 * double(to.depth_error) * range_),
          least_cosine_(std::cos(std::min(double(to.angle), 3.0))),
          greatest_cosine_(1 - std::pow(double(to.angle), 4.0) / 128),
          cut_{{}, {}} {
        for (const glm::vec3& p : mesh.positions) add(p);
        for (const glm::uvec3& t : mesh.triangles) cut(t);
    }

    [[nodiscard]] tessellated_mesh take() { return std::move(cut_); }

private:
    unsigned add(glm::vec3 p) {
        cut_.positions.push_back(p);
        distances_.push_back(glm::length(glm::dvec3(p) - light_));
        return static_cast<unsigned>(cut_.positions.size() - 1);
    }

    /// By how much an edge is too long: what its angle's cosine lacks to 1, or else its error; zeros where it is not.
    /// Its ends alone decide, so that a neighbour's decides alike.
    [[nodiscard]] std::pair<double, double> excess(unsigned a, unsigned b) const {
        const double p = distances_[a], q = distances_[b];
        if (std::max(p, q) < sag_) return {0, 0};
        const glm::dvec3 to_a = glm::dvec3(cut_.positions[a]) - light_, to_b = glm::dvec3(cut_.positions[b]) - light_;
        const double cosine = glm::dot(to_a, to_b) / (p * q);
        if (cosine < least_cosine_) return {1 - cosine, 0};
        if (cosine > greatest_cosine_ || std::min(p, q) * cosine > range_) return {0, 0};
        // the mean of both ends' distances against the distance to where the angle's bisector meets the edge
        const double sag = (p + q) / 2 - 2 * p * q * std::sqrt((1 + cosine) / 2) / (p + q);
        return {0, sag > sag_ ? sag : 0};
    }

    /// Where the angle's bisector meets the edge, from the same end whichever comes first.
    [[nodiscard]] glm::vec3 middle(unsigned a, unsigned b) const {
        const auto order = [](const glm::vec3& p) { return std::tuple(p.x, p.y, p.z); };
        if (order(cut_.positions[b]) < order(cut_.positions[a])) std::swap(a, b);
        const double share = distances_[a] / (distances_[a] + distances_[b]);
        return glm::vec3(glm::mix(glm::dvec3(cut_.positions[a]), glm::dvec3(cut_.positions[b]), share));
    }

    /// Cuts a triangle in two at its edge that is longest above what it may be, until none is.
    void cut(const glm::uvec3& whole) {
        std::vector<glm::uvec3> left{whole};
        while (!left.empty()) {
            const glm::uvec3 t = left.back();
            left.pop_back();
            glm::length_t longest = 3;
            std::pair<double, double> most{0, 0};
            for (glm::length_t i = 0; i < 3; ++i) {
                const unsigned a = t[i], b = t[(i + 1) % 3];
                const auto by = excess(a, b);
                if (!(by > most)) continue;
                const glm::vec3 m = middle(a, b);
                if (m != cut_.positions[a] && m != cut_.positions[b]) longest = i, most = by;
            }
            if (longest == 3) {
                cut_.triangles.push_back(t);
                continue;
            }
            const unsigned a = t[longest], b = t[(longest + 1) % 3], c = t[(longest + 2) % 3], m = between(a, b);
            left.emplace_back(a, m, c);
            left.emplace_back(m, b, c);
        }
    }

    unsigned between(unsigned a, unsigned b) {
        const auto [found, is_new] = middles_.try_emplace(std::uint64_t(std::min(a, b)) << 32 | std::max(a, b), 0u);
        if (is_new) found->second = add(middle(a, b));
        return found->second;
    }

    glm::dvec3 light_;
    double range_, sag_, least_cosine_, greatest_cosine_;
    tessellated_mesh cut_;
    std::vector<double> distances_;
    std::unordered_map<std::uint64_t, unsigned> middles_;
};

}  // namespace detail

/// Cuts a mesh's triangles at edges that are too long for a light, each at the angle's bisector.
///
/// @param mesh   triangles with a position that is not finite stay as they are
/// @param to     how finely
/// @return       the same surface: what shares an edge still does, without gaps, also where neighbours have positions
///               of their own that are equal; of the same winding
/// @throws std::invalid_argument  an angle, a range or an error out of bounds, an index out of range
/// @formula      an edge with ends a and b from the light, g between them, is cut where g > angle, or where
///               (|a| + |b|) / 2 - 2 |a| |b| cos(g / 2) / (|a| + |b|) > 3/4 depth_error range: inside of a triangle a
///               parabola is up to 4/3 as far from its plane as on the edges. Edges nearer to the light than that error
///               stay, and those of half a texel, angle^2 / 8, stay whatever their error: or else triangles that hold
///               the light, or are seen edge-on, had no end
[[nodiscard]] inline tessellated_mesh tessellate(const mesh_view& mesh, const tessellation& to) {
    constexpr auto function = "tessellate";
    detail::require(detail::all_finite(to.position), function, "position", "must be finite");
    detail::require(is_finite(to.angle) && to.angle > 0, function, "angle", "must be above 0");
    detail::require(is_finite(to.range) && to.range > 0, function, "range", "must be above 0");
    detail::require(to.depth_error > 0 && to.depth_error < 1, function, "depth_error", "must be above 0 and below 1");
    for (const glm::uvec3& t : mesh.triangles)
        detail::require(std::max({t.x, t.y, t.z}) < mesh.positions.size(), function, "mesh.triangles",
                        "must be indices of positions");
    return detail::tessellator(mesh, to).take();
}

}  // namespace umbrage

// ---- umbrage/images/tetrahedron_pass.hpp
// The depth pass of a tetrahedron's map on the CPU.
//
//     umbrage::rasterize_tetrahedron(map.view(), mesh, umbrage::make_tetrahedron_light(light));
//

namespace umbrage {

/// Renders each face's depths into its triangle of the map, as tetrahedron_face_of has it, and nowhere else.
///
/// @param depth      of light.map_size^2 texels, cleared or of an earlier pass
/// @param faces      make_tetrahedron_light's, on its own triangles
/// @throws std::invalid_argument  as rasterize_depth, and where depth is not square
/// @exactness        the bits of rasterize_depth
/// The rest as for rasterize_depth.
template <class ParallelFor = serial>
void rasterize_tetrahedron(image_view<float> depth, const mesh_view& mesh,
                           const std::array<light_space<float>, 4>& faces, cull_mode cull = cull_mode::none,
                           ParallelFor&& parallel = {}) {
    detail::require(depth.size.x == depth.size.y, "rasterize_tetrahedron", "depth", "must be square");
    const auto side = static_cast<float>(depth.size.x);
    image<float> drawn(depth.size);
    for (int i = 0; i < 4; ++i) {
        const light_space<float>& face = faces[static_cast<std::size_t>(i)];
        for (int y = 0; y < depth.size.y; ++y) std::copy_n(depth.row(y), depth.size.x, drawn.view().row(y));
        rasterize_depth(drawn.view(), mesh, face.projection * face.view, face.clip, cull, parallel);
        for (glm::ivec2 texel{0}; texel.y < depth.size.y; ++texel.y)
            for (texel.x = 0; texel.x < depth.size.x; ++texel.x)
                if (tetrahedron_face_of(glm::vec2(texel), side) == i) depth[texel] = drawn[texel];
    }
}

}  // namespace umbrage

// ---- umbrage/images/variance_table.hpp
// Summed-area tables of a shadow map's depths and their squares, and visibility of whole images from them.
//
//     umbrage::variance_table of{.bits = 11, .radius = 16};
//     umbrage::image<glm::u16vec4> table = umbrage::make_variance_table(map, of);
//     umbrage::summed_visibility(table, of, receivers, 16, out);
//
// A box of 33 x 33 texels costs what one of 3 x 3 does.

namespace umbrage {

/// What a table is made for.
struct variance_table {
    int bits = 11;    ///< of a depth's code, 1 to 12
    int radius = 16;  ///< of the largest box: 2 radius + 1 texels a side
    comparison is_lit{};
};

/// Sums of a map's codes, of distance from the near plane, and of their squares, for summed_variance.
///
/// @param map         depths; NaN counts as far
/// @param of          the largest box, n texels of it within the map
/// @return            one column and row more than the map: what lies before that column and row; the sums modulo 2^16
///                    and over 2^16, those of the squares likewise
/// @throws std::invalid_argument  empty map, bits or radius out of range; n 2^bits > 2^24; or n (s^2 / 4 + 1) >= 2^32,
///                    s the difference of the map's greatest and least code: what a box may then hold wraps
template <class ParallelFor = serial>
[[nodiscard]] image<glm::u16vec4> make_variance_table(image_view<const float> map, const variance_table& of,
                                                      ParallelFor&& parallel = {}) {
    if (map.empty()) detail::fail("umbrage::make_variance_table: empty map");
    if (of.bits < 1 || of.bits > 12) detail::fail("umbrage::make_variance_table: bits must lie between 1 and 12");
    if (of.radius < 0 || of.radius > 32767) detail::fail("umbrage::make_variance_table: radius out of range");
    image<std::uint32_t> codes(map.size), sums(map.size);
    std::uint32_t least = 65535, greatest = 0;
    for (int y = 0; y < map.size.y; ++y)
        for (int x = 0; x < map.size.x; ++x) {
            const auto code = static_cast<std::uint32_t>(distance_code(map.row(y)[x], of.is_lit)) >> (16 - of.bits);
            codes[{x, y}] = code;
            least = std::min(least, code), greatest = std::max(greatest, code);
        }
    const std::int64_t side = 2 * std::int64_t(of.radius) + 1, spread = std::int64_t(greatest) - std::int64_t(least);
    const std::int64_t n = std::min<std::int64_t>(side, map.size.x) * std::min<std::int64_t>(side, map.size.y);
    if (n << of.bits > std::int64_t(1) << 24)
        detail::fail("umbrage::make_variance_table: sums of so large a box need more than 24 bits");
    if (n * (spread * spread + 4) >= std::int64_t(1) << 34)
        detail::fail("umbrage::make_variance_table: squared distances in so large a box may reach 2^32");

    image<glm::u16vec4> table(map.size + 1, glm::u16vec4(0));
    const auto store = [&](glm::length_t first_channel) {
        summed_area(codes, sums, parallel);
        for (int y = 0; y < map.size.y; ++y)
            for (int x = 0; x < map.size.x; ++x) {
                const std::uint32_t sum = sums[{x, y}];
                glm::u16vec4& texel = table[{x + 1, y + 1}];
                texel[first_channel] = static_cast<std::uint16_t>(sum & 0xFFFF);
                texel[first_channel + 1] = static_cast<std::uint16_t>(sum >> 16);
            }
    };
    store(0);
    for (std::uint32_t& code : codes.texels()) code *= code;
    store(2);
    return table;
}

/// summed_variance of each receiver.
/// @param table, of   from make_variance_table
/// @param receivers   (x, y) in texels of the map, z depth, biased
/// @param radius      of the box, at most the table's
/// @param out         visibility, 1 lit; same size as receivers
/// @throws std::invalid_argument  sizes differ, a table without texels, or a radius below 0 or above the table's
template <class ParallelFor = serial>
void summed_visibility(image_view<const glm::u16vec4> table, const variance_table& of,
                       image_view<const glm::vec3> receivers, int radius, image_view<float> out,
                       ParallelFor&& parallel = {}) {
    if (receivers.size != out.size) detail::fail("umbrage::summed_visibility: sizes differ");
    if (table.size.x < 2 || table.size.y < 2) detail::fail("umbrage::summed_visibility: empty table");
    if (radius < 0 || radius > of.radius) detail::fail("umbrage::summed_visibility: the table is of another radius");
    const auto fetch = [table](glm::ivec2 at) { return glm::vec4(table.row(at.y)[at.x]); };
    const auto codes = static_cast<float>(1 << of.bits), reach = static_cast<float>(radius);
    parallel(out.size.y, [&](int first, int last) {
        for (int y = first; y < last; ++y)
            for (int x = 0; x < out.size.x; ++x) {
                const glm::vec3 r = receivers.row(y)[x];
                out.row(y)[x] = summed_variance(fetch, table.size - 1, glm::vec2(r), r.z, reach, codes, of.is_lit);
            }
    });
}

}  // namespace umbrage

// ---- umbrage/light/directional_fit.hpp
// A directional light fitted to what receives its shadows, with the near plane pulled towards what casts them.
//
//     auto light = umbrage::fit_directional_light<float>({.direction = d, .receivers = scene});
//     auto tight = umbrage::fit_directional_light<float>(
//         {.direction = d, .receivers = umbrage::intersection(camera, scene), .casters = scene});
//     auto still = umbrage::fit_directional_light<float>(
//         {.direction = d, .receivers = umbrage::sphere_around(camera), .casters = scene, .snap_texels = 1024});
//

namespace umbrage {

template <real T = float>
struct directional_fit {
    glm::vec<3, T> direction{T(0), T(-1), T(0)};  ///< any length > 0
    glm::vec<3, T> up{T(0), T(1), T(0)};          ///< hint; may be parallel to direction
    hull receivers = bounding_box<T>{};           ///< box, sphere, frustum, polyhedron or points
    std::optional<bounding_box<T>> casters{};     ///< none: near plane at the receivers, for near_plane::clamps
    T margin = T(0.01);                           ///< added on every side, as a share of the receivers' diameter, >= 0
    int snap_texels = 0;                          ///< side of a map whose texels stay where they are; 0: not snapped
    clip_space clip{};
};

namespace detail {

/// A box in front of a light: its middle as a share of half its sides, so that these keep their bits wherever it is.
struct light_box {
    glm::dvec2 half, middle;
    double z_near, z_far;
};

/// The square of whole texels around a box, a texel wider, and depths in steps of its side.
[[nodiscard]] inline light_box snapped(const light_box& box, int texels) {
    const double n(texels), half_texel = glm::max(box.half.x, box.half.y) / (n - 1.0), side = 2.0 * half_texel * n;
    const glm::dvec2 first = glm::round((box.middle * box.half / half_texel - n) * 0.5);
    const double z_near = std::floor(box.z_near / side) * side;
    return {glm::dvec2(half_texel * n), first * (2.0 / n) + 1.0, z_near,
            z_near + (std::ceil((box.z_far - box.z_near) / side) + 1.0) * side};
}

}  // namespace detail

/// The smallest box along the light that holds the receivers and what of the casters' box they sweep towards the light,
/// with the margin all around. Casters beside the receivers leave the near plane where it is, as they throw no shadow
/// there; for a sphere's sweep stands that of its square.
///
/// With snap_texels the box is a square, a texel wider, whose texels lie on a grid of the world wherever the receivers
/// move, as long as their extent keeps its bits: a sphere's does. Its depths then span the casters' whole box, and go
/// beyond it in steps of the square's side. For a grid that keeps its place to a hundredth of a texel far from the
/// origin, compute the texture matrix in double and round that.
///
/// @throws std::invalid_argument  zero or non-finite direction, receivers empty or of no extent, casters that are no
///                                box, a negative margin, and what gives matrices that are not finite
/// @cite   Valient: Stable Rendering of Cascaded Shadow Maps, ShaderX6, 2008
template <real T = float>
[[nodiscard]] light_space<T> fit_directional_light(const directional_fit<T>& fit) {
    constexpr auto function = "fit_directional_light", sides = "receivers and margin";
    constexpr auto depths = "receivers, casters and margin";
    detail::require_receivers(fit.receivers, function);
    detail::require(is_finite(fit.margin) && fit.margin >= T(0), function, "margin", "must be finite and not below 0");
    detail::require(fit.snap_texels == 0 || fit.snap_texels > 1, function, "snap_texels", "must be 0 or above 1");
    const bool snaps = fit.snap_texels > 0;

    light_space<T> space{
        detail::look_along(glm::vec<3, T>(T(0)), fit.direction, fit.up, fit.clip.hand, function, ""), {}, fit.clip};
    const glm::dmat4 frame = detail::light_frame(space.view, fit.clip.hand);
    const auto points = detail::seen(frame, fit.receivers.points);
    const auto [low, high] = detail::extent_of(points);
    const auto [first, last] = detail::extent_of(fit.receivers.points);
    const double radius = fit.receivers.radius;
    const double margin = double(fit.margin) * (glm::length(last - first) + 2.0 * radius), around = radius + margin;
    const glm::dvec2 half = glm::dvec2(high - low) * 0.5 + around;
    detail::light_box box{half, glm::dvec2(high + low) * 0.5 / half, low.z - around, high.z + around};
    if (fit.casters && snaps) {
        const auto casters = detail::extent_of(detail::seen(frame, hull(*fit.casters).points));
        box.z_near = glm::min(box.z_near, casters.low.z), box.z_far = glm::max(box.z_far, casters.high.z);
    } else if (fit.casters) {
        const auto swept = detail::sweep(points, around);
        box.z_near = glm::min(box.z_near, detail::nearest(frame, *fit.casters, swept) - margin);
    }
    if (snaps) box = detail::snapped(box, fit.snap_texels);

    glm::dmat4 projection =
        detail::orthographic(-box.half, box.half, box.z_near, box.z_far, fit.clip, function, sides, depths);
    projection[3][0] = -box.middle.x, projection[3][1] = -box.middle.y;
    space.projection = glm::mat<4, 4, T>(projection);
    for (glm::length_t i = 0; i < 3; ++i)
        detail::require(detail::is_normal(space.projection[i][i]), function, i < 2 ? sides : depths,
                        "give too large or too small a box");
    return detail::checked(space, function, depths);
}

}  // namespace umbrage

// ---- umbrage/light/cascades/cascades.hpp
// Cascades of a directional light: a map for each part of the camera's range, all of one rotation.
//
//     const umbrage::cascade_fit<float> fit{
//         .camera = camera, .direction = d, .scene = {low, high}, .overlap = 0.1f};
//     const auto splits = umbrage::practical_splits<4>(0.5f, 300.0f, 0.9f);
//     const auto cascades = umbrage::make_stable_cascades<4>(fit, splits);
//     for (const auto& c : cascades) draw_depths(c.light);                   // a depth pass each
//     const auto uniforms = umbrage::make_cascade_uniforms(cascades, 0.1f);  // see select.hpp for what takes them
//

namespace umbrage {

/// One part of the camera's range and its map.
template <real T>
struct cascade {
    light_space<T> light;                      ///< for the depth pass; its view is a rotation, one for
                                               ///< all cascades
    glm::vec<4, T> scale{T(0)}, offset{T(0)};  ///< from rotated points to texels and depth; w: 0
    T begin = T(0), end = T(0);                ///< distances along the camera's axis
};

template <real T = float>
struct cascade_fit {
    frustum<T> camera{};                          ///< but for its planes, in place of which there are splits
    glm::vec<3, T> direction{T(0), T(-1), T(0)};  ///< of the light, any length > 0
    glm::vec<3, T> up{T(0), T(1), T(0)};          ///< hint; of the world, as maps turn with it
    bounding_box<T> scene{};                      ///< all casters and receivers
    int map_size = 1024;                          ///< of each cascade, texels
    T margin = T(2);                              ///< texels around: the filter's reach
    T overlap = T(0);                             ///< share of a cascade that the next one holds too, 0 .. 1
    clip_space clip{};
};

namespace detail {

/// A fitted light, whose view is a rotation, as a cascade.
template <real T>
[[nodiscard]] cascade<T> as_cascade(const light_space<double>& light, int map_size, const char* function) {
    const glm::dmat4 m = texture_matrix<double>({glm::dmat4(1), light.projection, light.clip}, glm::ivec2(map_size));
    const glm::dvec4 scale(m[0][0], m[1][1], m[2][2], 0.0), offset(glm::dvec3(m[3]), 0.0);
    const light_space<T> cast{glm::mat<4, 4, T>(light.view), glm::mat<4, 4, T>(light.projection), light.clip};
    const cascade<T> c{checked(cast, function, "camera, splits and scene"), glm::vec<4, T>(scale),
                       glm::vec<4, T>(offset)};
    const bool normal = is_normal(c.scale.x) && is_normal(c.scale.y) && is_normal(c.scale.z);
    require(normal && all_finite(c.scale) && all_finite(c.offset), function, "camera, splits and scene",
            "give too large or too small a cascade");
    return c;
}

/// The camera's parts between splits, with what they overlap.
template <std::size_t Count, real T>
[[nodiscard]] std::array<frustum<double>, Count> camera_parts(const cascade_fit<T>& fit,
                                                              const std::array<T, Count + 1>& splits,
                                                              const char* function) {
    require(is_finite(splits[0]) && splits[0] >= T(0), function, "splits", "must not begin below 0");
    for (std::size_t i = 0; i < Count; ++i)
        require(is_finite(splits[i + 1]) && splits[i] < splits[i + 1], function, "splits", "must be in order");
    require(is_finite(fit.margin) && fit.margin >= T(0), function, "margin", "must be finite and not below 0");
    require(double(fit.map_size) - 2 * double(fit.margin) > 1, function, "map_size", "must be above 2 margin + 1");
    require(fit.overlap >= T(0) && fit.overlap <= T(1), function, "overlap", "must lie between 0 and 1");
    std::array<frustum<double>, Count> parts;
    for (std::size_t i = 0; i < Count; ++i) {
        const double before = i > 0 ? double(splits[i]) - double(splits[i - 1]) : 0;
        parts[i] = {glm::dvec3(fit.camera.position),
                    glm::dvec3(fit.camera.direction),
                    glm::dvec3(fit.camera.up),
                    double(fit.camera.tan_half_x),
                    double(fit.camera.tan_half_y),
                    double(splits[i]) - double(fit.overlap) * before,
                    double(splits[i + 1])};
    }
    return parts;
}

/// What a part sees of a scene; where that is nothing, all of the part.
[[nodiscard]] inline hull receivers_of(const frustum<double>& part, const bounding_box<double>& scene) {
    const polyhedron seen = intersection(part, scene);
    return seen.empty() ? hull(part) : hull(seen);
}

/// A margin in texels as a share of what a map holds within it.
template <real T>
[[nodiscard]] double margin_share(const cascade_fit<T>& fit) {
    return double(fit.margin) / (fit.map_size - 2 * double(fit.margin));
}

/// A cascade for each part, of light(frustum) in double.
template <std::size_t Count, real T, class Light>
[[nodiscard]] std::array<cascade<T>, Count> make_cascades(const cascade_fit<T>& fit,
                                                          const std::array<T, Count + 1>& splits, const char* function,
                                                          Light&& light) {
    const auto parts = camera_parts<Count>(fit, splits, function);
    std::array<cascade<T>, Count> all;
    for (std::size_t i = 0; i < Count; ++i) {
        all[i] = as_cascade<T>(light(parts[i]), fit.map_size, function);
        all[i].begin = splits[i];
        all[i].end = splits[i + 1];
    }
    return all;
}

}  // namespace detail

/// Cascades that neither flicker nor swim while the camera moves: each map holds the sphere around its part of the
/// camera's frustum, which does not change as the camera turns, and moves by whole texels.
///
/// Offsets are whole numbers, up to 2^23 texels from the world's origin, so that a world point moves through a map by
/// as much, but for the rounding of its coordinate: none where it lies farther from the origin than the map is wide,
/// else in float 2^-14 of a texel on maps of 1024, which may move a filter's weights by a step of 1/256. Draw depths
/// from rotated points by the projection alone. In float, one matrix for both may move points by a hundredth of a
/// texel.
///
/// @param splits   Count + 1 distances along the camera's axis, ascending, the first 0 or above: see splits.hpp
/// @return         the nearest first, from split to split
/// @throws std::invalid_argument  splits out of order, map_size, margin or overlap out of range; what sphere_around and
///                                fit_directional_light complain of; and what gives matrices that are not finite
template <std::size_t Count, real T>
[[nodiscard]] std::array<cascade<T>, Count> make_stable_cascades(const cascade_fit<T>& fit,
                                                                 const std::array<T, Count + 1>& splits) {
    auto all = detail::make_cascades<Count>(fit, splits, "make_stable_cascades", [&](const frustum<double>& part) {
        const double around = double(fit.margin);
        return fit_directional_light<double>({.direction = glm::dvec3(fit.direction),
                                              .up = glm::dvec3(fit.up),
                                              .receivers = sphere_around(part),
                                              .casters = bounding_box<double>{fit.scene.low, fit.scene.high},
                                              .margin = around / (fit.map_size - 1 - 2 * around),
                                              .snap_texels = fit.map_size,
                                              .clip = fit.clip});
    });
    for (cascade<T>& c : all)
        for (glm::length_t i = 0; i < 2; ++i) c.offset[i] = std::nearbyint(c.offset[i]);
    return all;
}

/// Cascades of the greatest resolution: each map holds what its part of the camera's frustum has in common with the
/// scene, and no more; where that is nothing, its part of the frustum. Texels change their size and place as the camera
/// moves. The rest as for make_stable_cascades; the margin is that many texels or more.
template <std::size_t Count, real T>
[[nodiscard]] std::array<cascade<T>, Count> make_tight_cascades(const cascade_fit<T>& fit,
                                                                const std::array<T, Count + 1>& splits) {
    return detail::make_cascades<Count>(fit, splits, "make_tight_cascades", [&](const frustum<double>& part) {
        const bounding_box<double> scene{fit.scene.low, fit.scene.high};
        return fit_directional_light<double>({.direction = glm::dvec3(fit.direction),
                                              .up = glm::dvec3(fit.up),
                                              .receivers = detail::receivers_of(part, scene),
                                              .casters = scene,
                                              .margin = detail::margin_share(fit),
                                              .clip = fit.clip});
    });
}

/// What a shader of up to four cascades takes: see select.hpp and blend.hpp.
template <real T>
struct cascade_uniforms {
    glm::mat<4, 4, T> rotation{T(1)};               ///< world to the light's directions, for shadow_coordinate
    glm::mat<4, 4, T> scales{T(0)}, offsets{T(0)};  ///< columns: a cascade's each; w: of cascade_fade
    glm::vec<3, T> ends{T(0)};                      ///< of the cascades but the last, for cascade_by_depth
};

/// @param fade   share of each cascade over which the next one takes over, 0 .. 1; after the last, full light. As much
///               overlap must have been asked for
/// @return       where there are fewer than four, nothing falls into the others by depth or by projection
/// @throws std::invalid_argument  fade out of range
template <real T, std::size_t Count>
[[nodiscard]] cascade_uniforms<T> make_cascade_uniforms(const std::array<cascade<T>, Count>& cascades, T fade) {
    static_assert(Count >= 1 && Count <= 4);
    detail::require(fade >= T(0) && fade <= T(1), "make_cascade_uniforms", "fade", "must lie between 0 and 1");
    cascade_uniforms<T> u;
    u.rotation = cascades[0].light.view;
    u.ends = glm::vec<3, T>(std::numeric_limits<T>::max());
    for (glm::length_t i = 0; i < 4; ++i) {
        if (i >= static_cast<glm::length_t>(Count)) {
            u.offsets[i] = {T(65536), T(65536), T(0), T(0)};
            continue;
        }
        const cascade<T>& c = cascades[static_cast<std::size_t>(i)];
        u.scales[i] = c.scale;
        u.offsets[i] = c.offset;
        if (const T width = fade * (c.end - c.begin); width > T(0)) {
            u.scales[i].w = T(1) / width;
            u.offsets[i].w = T(1) - c.end / width;
        }
        if (i + 1 < static_cast<glm::length_t>(Count)) u.ends[i] = c.end;
    }
    return u;
}

}  // namespace umbrage

// ---- umbrage/light/warp/warp_fit.hpp
// What warps of a directional light's map share: what they are fitted to, what they give, and their last step, which
// lays any projective map of the world around the receivers.
//
//     umbrage::warp_fit<float> fit{.camera = camera, .direction = d,
//                                  .receivers = umbrage::intersection(camera, scene), .casters = scene};
//     umbrage::warped_light<float> warped = umbrage::fit_light_space_perspective(fit);
//     draw_depths(warped.light);
//
// A warp gives what the camera sees close by more texels, and what it sees from afar fewer. Look-ups are those of a
// spot light, by shadow_coordinate and project_coordinate; w is above 0 and depth grows along the light.
//
// What is strongly warped wants digits: a matrix of doubles, rounded once, places points to 1/1000 of a texel of maps
// of 2048 under a view of a kilometre. Its product with points in float loses more far from the origin, up to 1/28 of a
// texel at the corners of that view; points told from the camera lose least.

namespace umbrage {

template <real T = float>
struct warp_fit {
    frustum<T> camera{};                          ///< that the map is for
    glm::vec<3, T> direction{T(0), T(-1), T(0)};  ///< of the light, any length > 0
    hull receivers = bounding_box<T>{};           ///< what the camera sees of the scene
    std::optional<bounding_box<T>> casters{};     ///< none: near plane at the receivers, for near_plane::clamps
    T margin = T(0.01);                           ///< added on every side, as a share of the receivers' extent in the
                                                  ///< map, >= 0
    clip_space clip{};
};

template <real T>
struct warped_light {
    light_space<T> light;  ///< for depth pass and texture_matrix; w is 1 at the least receiver
    T strength = T(0);     ///< 1 - least w / greatest w of the receivers: 0 uniform, towards 1 ever more warped
};

namespace detail {

/// Complains of what fits of all warps need.
template <real T>
void require_warp_fit(const warp_fit<T>& fit, const char* function) {
    require_receivers(fit.receivers, function);
    require(is_finite(fit.margin) && fit.margin >= T(0), function, "margin", "must be finite and not below 0");
    if (fit.casters) (void)corners(*fit.casters);
}

/// The way y goes in a map: the way the camera looks, or up as it has it where it looks along the light.
template <real T>
[[nodiscard]] glm::dvec3 up_of(const warp_fit<T>& fit) {
    const glm::dmat3 camera = axes(fit.camera);
    const bool along = !(glm::length(glm::cross(camera[2], unit(glm::dvec3(fit.direction)))) > 1e-3);
    return camera[along ? 1 : 2];
}

/// The light's view that maps are drawn in.
template <real T>
[[nodiscard]] glm::dmat4 view_of(const warp_fit<T>& fit, const char* function) {
    return look_along(glm::dvec3(0), glm::dvec3(fit.direction), up_of(fit), fit.clip.hand, function, "");
}

/// What a map sees of a body within planes of the map's space.
/// @return   nothing where some of it does not lie before w = 0
[[nodiscard]] inline std::optional<extent> seen_within(const glm::dmat4& to_map, const polyhedron& body,
                                                       std::vector<glm::dvec4> planes) {
    for (glm::dvec4& plane : planes) plane = glm::transpose(to_map) * plane;
    extent all;
    for (const polyhedron::face& face : body.faces()) {
        std::vector<glm::dvec3> polygon = face.corners;
        for (const glm::dvec4& plane : planes) polygon = clipped(polygon, plane);
        for (const glm::dvec3& p : polygon) {
            const glm::dvec4 h = to_map * glm::dvec4(p, 1.0);
            if (!(h.w > 0.0)) return {};
            all.low = glm::min(all.low, glm::dvec3(h) / h.w), all.high = glm::max(all.high, glm::dvec3(h) / h.w);
        }
    }
    return all;
}

/// A projective map of which a box becomes the clip space's cube; turned over where it would mirror what it sees.
/// @param to_map           world to x, y, depth and w, in double; keeps x / w and y / w along the light, where depth
///                         z / w grows; of any scale
/// @param least, greatest  w of receivers
/// @return                 nothing where the box has no extent, and where the map overflows
template <real T>
[[nodiscard]] std::optional<warped_light<T>> laid(const glm::dmat4& to_map, const extent& box, double least,
                                                  double greatest, const warp_fit<T>& fit, const char* function) {
    const auto [at_near, at_far] = ends<double>(fit.clip);
    const bool mirrors = (glm::determinant(to_map) < 0.0) != (fit.clip.hand == handedness::right);
    const glm::dvec3 first(mirrors ? 1.0 : -1.0, -1.0, at_near), last(-first.x, 1.0, at_far);
    const glm::dvec3 scale = (last - first) / (box.high - box.low), offset = first - box.low * scale;
    glm::dmat4 placed(1.0);
    for (glm::length_t i = 0; i < 3; ++i) placed[i][i] = scale[i], placed[3][i] = offset[i];

    const glm::dmat4 view = view_of(fit, function);
    const glm::dmat4 projection = placed * to_map * glm::transpose(view) / least;
    const light_space<T> light{glm::mat<4, 4, T>(view), glm::mat<4, 4, T>(projection), fit.clip};
    if (!all_finite(light.projection) || !all_finite(light.projection * light.view)) return {};
    const glm::mat<4, 4, T> rows = glm::transpose(light.projection);
    const T bend = glm::length(glm::vec<3, T>(rows[3]));  // a row that says w alone is one too
    for (glm::length_t i = 0; i < 3; ++i)
        if (!is_normal(glm::length(glm::vec<3, T>(rows[i])) + bend)) return {};
    return warped_light<T>{light, T(1.0 - least / greatest)};
}

/// A map laid around the receivers in x and y, in depth around them and what of the casters they sweep towards the
/// light.
/// @param to_map   as for laid
/// @return         nothing where w <= 0 at a receiver or a caster, and as laid does
template <real T>
[[nodiscard]] std::optional<warped_light<T>> refit(const glm::dmat4& to_map, const warp_fit<T>& fit,
                                                   const polyhedron& casters, const char* function) {
    std::vector<glm::dvec3> receivers;
    double least_w = std::numeric_limits<double>::infinity(), greatest_w = 0.0;
    for (const glm::dvec3& p : corners_of(fit.receivers)) {
        const glm::dvec4 h = to_map * glm::dvec4(p, 1.0);
        if (!(h.w > 0.0 && all_finite(h))) return {};
        receivers.push_back(glm::dvec3(h) / h.w);
        least_w = glm::min(least_w, h.w), greatest_w = glm::max(greatest_w, h.w);
    }
    extent box = extent_of(receivers);
    const glm::dvec3 size = box.high - box.low;
    constexpr double flat = 0x1p-8;  // receivers seen edge on have some margin too
    const glm::dvec2 around = double(fit.margin) * glm::max(glm::dvec2(size), flat * glm::dvec2(size.y, size.x));
    // the hull's cone over the map, of which the other half, behind w = 0, is no part
    const auto swept = seen_within(to_map, casters, sweep(receivers, glm::max(around.x, around.y)));
    if (!swept) return {};
    box.low.z = glm::min(box.low.z, swept->low.z);
    const double deep = double(fit.margin) * glm::length(box.high - box.low);
    box.low -= glm::dvec3(around, deep), box.high += glm::dvec3(around, deep);
    return laid(to_map, box, least_w, greatest_w, fit, function);
}

template <real T>
[[nodiscard]] std::optional<warped_light<T>> refit(const glm::dmat4& to_map, const warp_fit<T>& fit,
                                                   const char* function) {
    return refit(to_map, fit, fit.casters ? polyhedron(*fit.casters) : polyhedron(), function);
}

/// No warp: the map as fit_directional_light lays it, but with the margin and the way up of warps.
template <real T>
[[nodiscard]] warped_light<T> unwarped(const warp_fit<T>& fit, const char* function) {
    const auto light = refit(light_frame(view_of(fit, function), fit.clip.hand), fit, function);
    require(light.has_value(), function, "receivers, casters and margin", "give too large or too small a box");
    return *light;
}

}  // namespace detail
}  // namespace umbrage

// ---- umbrage/light/cascades/warped.hpp
// Cascades each of which is warped: the parts of a camera's range share out what one warp cannot reach.
//
//     const auto cascades = umbrage::make_warped_cascades<4>(
//         fit, splits, [](const auto& part) { return umbrage::fit_light_space_perspective(part); });
//     draw_depths(cascades[i].light);
//     glm::mat4 to_texels = umbrage::texture_matrix(cascades[i].light, map_size);  // of each, for shaders
//
// A pixel takes the cascade that cascade_by_depth names: their maps are turned and bent each in its own way, so that
// there is no common rotation for cascade_by_projection.

namespace umbrage {

/// A warped map for each part of the camera's range, around what that has in common with the scene; where that is
/// nothing, around the part.
///
/// @param fit      but for up: warps take the camera's direction
/// @param splits   Count + 1 distances along the camera's axis, ascending, the first 0 or above: see splits.hpp
/// @param warp     (const warp_fit<double>& part) -> warped_light<double>, whose margin is as many texels as fit's
/// @return         the nearest first
/// @throws std::invalid_argument  splits out of order, map_size, margin or overlap out of range, what warp complains
///                                of, and what gives matrices that are not finite
template <std::size_t Count, real T, class Warp>
[[nodiscard]] std::array<warped_light<T>, Count> make_warped_cascades(const cascade_fit<T>& fit,
                                                                      const std::array<T, Count + 1>& splits,
                                                                      Warp&& warp) {
    constexpr auto function = "make_warped_cascades";
    const bounding_box<double> scene{fit.scene.low, fit.scene.high};
    const auto parts = detail::camera_parts<Count>(fit, splits, function);
    std::array<warped_light<T>, Count> all;
    for (std::size_t i = 0; i < Count; ++i) {
        const warped_light<double> own = warp(warp_fit<double>{.camera = parts[i],
                                                               .direction = glm::dvec3(fit.direction),
                                                               .receivers = detail::receivers_of(parts[i], scene),
                                                               .casters = scene,
                                                               .margin = detail::margin_share(fit),
                                                               .clip = fit.clip});
        const light_space<T> light{glm::mat<4, 4, T>(own.light.view), glm::mat<4, 4, T>(own.light.projection),
                                   own.light.clip};
        all[i] = {detail::checked(light, function, "camera, splits and scene"), T(own.strength)};
    }
    return all;
}

}  // namespace umbrage

// ---- umbrage/light/spot_fit.hpp
// A spot light fitted to what of its cone receives shadows, with the near plane pulled towards what casts them.
//
//     auto light = umbrage::fit_spot_light<float>(
//         {.position = p, .direction = d, .receivers = umbrage::intersection(camera, scene), .casters = scene});
//

namespace umbrage {

template <real T = float>
struct spot_fit {
    glm::vec<3, T> position{T(0)};
    glm::vec<3, T> direction{T(0), T(-1), T(0)};        ///< any length > 0
    glm::vec<3, T> up{T(0), T(1), T(0)};                ///< hint; may be parallel to direction
    T outer_angle_radians = std::numbers::pi_v<T> / 6;  ///< between axis and edge of the cone, above 0, below pi / 2
    T z_near = T(0.1);                         ///< the least that the near plane may be, > 0: a lamp's own size
    hull receivers = bounding_box<T>{};        ///< box, sphere, frustum, polyhedron or points
    std::optional<bounding_box<T>> casters{};  ///< none: near plane at the receivers, for near_plane::clamps
    T margin = T(0.01);         ///< added on every side, as a share of the map's and of distances, 0 to 1/2
    bool has_far_plane = true;  ///< false: depth nears the far depth with distance
    clip_space clip{};
};

namespace detail {

/// What a spot light sees of a hull beyond a distance, within tangents of its sides: points as tangents x / distance,
/// y / distance, and the distance.
[[nodiscard]] inline std::vector<glm::dvec3> tangents(std::vector<glm::dvec3> seen, double edge, double closest) {
    for (const glm::dvec4 plane : {glm::dvec4(0, 0, 1, -closest), glm::dvec4(1, 0, edge, 0), glm::dvec4(-1, 0, edge, 0),
                                   glm::dvec4(0, 1, edge, 0), glm::dvec4(0, -1, edge, 0)})
        seen = clipped_hull(seen, plane);
    for (glm::dvec3& p : seen) p = {p.x / p.z, p.y / p.z, p.z};
    return seen;
}

/// The nearest that a box of casters comes to a spot light within what receivers sweep towards it.
/// @param receivers  tangents;   outwards  the margin around them;   closest  where the sweep ends
[[nodiscard]] inline double nearest_to_spot(const glm::dmat4& frame, const polyhedron& casters,
                                            const std::vector<glm::dvec3>& receivers, double outwards, double closest) {
    std::vector<glm::dvec4> planes = sweep(receivers, outwards);
    for (glm::dvec4& plane : planes) plane = {plane.x, plane.y, plane.w, 0.0};  // through the light
    planes.emplace_back(0.0, 0.0, 1.0, -closest);
    // the sweep's end may lie within the casters, none of whose faces it then meets
    const glm::dvec4 end =
        glm::inverse(frame) * glm::dvec4(receivers.front().x * closest, receivers.front().y * closest, closest, 1.0);
    const bool within = std::all_of(casters.faces().begin(), casters.faces().end(),
                                    [&](const polyhedron::face& face) { return glm::dot(face.plane, end) >= 0.0; });
    return within ? closest : nearest(frame, casters, planes);
}

}  // namespace detail

/// The smallest part of the square pyramid around the cone that holds the receivers in it, and what of the casters' box
/// they sweep towards the light, with the margin: but nothing outside of the pyramid or nearer than z_near. The light
/// may stand within receivers and casters. For a sphere stands its box; of points counts all that lies between them, at
/// a cost that grows with the square of their number where some lie outside: for a mesh give its box.
/// @throws std::invalid_argument  zero or non-finite direction, angle outside (0, pi / 2), receivers empty, none in the
///                                pyramid beyond z_near, or none of some extent there, casters that are no box, and
///                                what gives matrices that are not finite
template <real T = float>
[[nodiscard]] light_space<T> fit_spot_light(const spot_fit<T>& fit) {
    constexpr auto function = "fit_spot_light";
    detail::require_receivers(fit.receivers, function);
    const T angle = fit.outer_angle_radians;
    detail::require(is_finite(angle) && angle > T(0) && angle < std::numbers::pi_v<T> / 2, function,
                    "outer_angle_radians", "must lie between 0 and pi / 2");
    detail::require(detail::is_normal(fit.z_near) && fit.z_near > T(0), function, "z_near",
                    "must be above 0, finite and no denormal");
    detail::require(fit.margin >= T(0) && fit.margin <= T(0.5), function, "margin", "must lie between 0 and 1/2");
    light_space<T> space{
        detail::look_along(fit.position, fit.direction, fit.up, fit.clip.hand, function, "position"), {}, fit.clip};
    const glm::dmat4 frame = detail::light_frame(space.view, fit.clip.hand);
    const double edge = std::tan(double(angle)), closest(fit.z_near);

    const auto before = detail::seen(frame, detail::corners_of(fit.receivers));
    const detail::extent around = detail::extent_of(before);
    const glm::dvec3 size = glm::max(glm::abs(around.low), glm::abs(around.high));
    detail::require(around.high.z > closest && is_finite(4.0 * (size.x + size.y + (1.0 + edge) * size.z)), function,
                    "receivers", "must lie before the light, beyond z_near");
    const auto receivers = detail::tangents(before, edge, closest);
    detail::require(!receivers.empty(), function, "receivers", "must lie in the cone");
    auto [low, high] = detail::extent_of(receivers);
    const double share(fit.margin), margin = share * glm::max(high.x - low.x, high.y - low.y);
    double z_near = low.z;
    if (fit.casters)
        z_near = glm::min(z_near, detail::nearest_to_spot(frame, *fit.casters, receivers, margin, closest));
    z_near = glm::max(z_near * (1.0 - share), closest);
    const double z_far = fit.has_far_plane ? high.z * (1.0 + share) : std::numeric_limits<double>::infinity();
    const glm::dvec2 first = glm::max(glm::dvec2(low) - margin, -edge),
                     last = glm::min(glm::dvec2(high) + margin, edge);
    const glm::dvec2 half = (last - first) * 0.5;
    detail::require(half.x > 0.0 && half.y > 0.0 && z_near < z_far, function, "receivers and margin",
                    "must have some extent in the cone");

    glm::dmat4 projection = detail::perspective(half.x, half.y, z_near, z_far, fit.clip, function);
    for (glm::length_t i = 0; i < 2; ++i) projection[2][i] = -projection[2][3] * (first + last)[i] * 0.5 / half[i];
    space.projection = glm::mat<4, 4, T>(projection);
    for (glm::length_t i = 0; i < 2; ++i)
        detail::require(detail::is_normal(space.projection[i][i]), function, "receivers and margin",
                        "give too large or too small a map");
    detail::require(detail::is_normal(space.projection[3][2]), function, "z_near and receivers",
                    "give planes too far apart or too close together");
    return detail::checked(space, function, "position, z_near and receivers");
}

}  // namespace umbrage

// ---- umbrage/light/warp/lamp.hpp
// Point lights for warps: warp_fit::direction is then the axis, which all receivers have to lie along.
//
//     auto warped = umbrage::fit_perspective(fit, {.position = p, .z_near = 0.05f});
//

namespace umbrage {

template <real T = float>
struct lamp {
    glm::vec<3, T> position{T(0)};
    T z_near = T(0.1);  ///< its own size, > 0: casters closer to it along the axis may be left out
};

namespace detail {

/// A lamp's own view of receivers, and of casters what may stand before them.
struct lamp_view {
    glm::dmat4 frame;        ///< world to x, y and the distance along the axis
    double least, farthest;  ///< distances of receivers
    polyhedron casters;
};

template <real T>
[[nodiscard]] lamp_view view_of(const lamp<T>& from, const warp_fit<T>& fit, const char* function) {
    require(is_normal(from.z_near) && from.z_near > T(0), function, "z_near",
            "must be above 0, finite and no denormal");
    const glm::dvec3 position(from.position), direction(fit.direction), up = up_of(fit);
    lamp_view v;
    v.frame = light_frame(look_along(position, direction, up, fit.clip.hand, function, "position"), fit.clip.hand);
    const std::vector<glm::dvec3> receivers = seen(v.frame, corners_of(fit.receivers));
    const auto [low, high] = extent_of(receivers);
    v.least = low.z, v.farthest = high.z;
    require(v.least > double(from.z_near) && is_finite(2.0 * v.farthest), function, "receivers",
            "must lie before the light, beyond z_near");
    if (!fit.casters) return v;
    double edge = 1.0;
    for (const glm::dvec3& p : receivers) edge = glm::max(edge, glm::max(glm::abs(p.x), glm::abs(p.y)) / p.z);
    const frustum<double> all{position, direction, up, 16.0 * edge, 16.0 * edge, double(from.z_near), 2.0 * v.farthest};
    v.casters = intersection(all, *fit.casters);
    return v;
}

/// What the lamp sees along its axis: x, y, depth and w, of no warp.
[[nodiscard]] inline glm::dmat4 map_along(const lamp_view& v) {
    glm::dmat4 inverse(1.0);  // of the distance: depth and w
    inverse[2] = {0, 0, 0, 1};
    inverse[3] = {0, 0, -0.5 * (v.least + v.farthest), 0};
    return inverse * v.frame;
}

template <real T>
[[nodiscard]] warped_light<T> unwarped(const lamp_view& v, const warp_fit<T>& fit, const char* function) {
    const auto light = refit(map_along(v), fit, v.casters, function);
    require(light.has_value(), function, "receivers, casters and margin", "give too large or too small a map");
    return *light;
}

}  // namespace detail
}  // namespace umbrage

// ---- umbrage/light/warp/light_space_perspective.hpp
// Light-space perspective: a directional light's map, warped by a perspective across the light, whose centre lies some
// way before what the camera sees. What lies side by side towards the light stays so: rays are texels.
//
//     umbrage::warp_fit<float> fit{.camera = camera, .direction = d,
//                                  .receivers = umbrage::intersection(camera, scene), .casters = scene};
//     auto warped = umbrage::fit_light_space_perspective(fit);
//     auto milder = umbrage::fit_light_space_perspective(fit, umbrage::optimal_distance(fit));
//

namespace umbrage {
namespace detail {

/// A camera's receivers as the light sees them, y along the camera's view.
struct along_view {
    glm::dmat4 frame;  ///< world to x, y and depth
    glm::dvec3 first;  ///< x of the camera, least y of the receivers, and the camera's depth or that of the receivers
                       ///< next to it: planes through the warp's zero of depth and its centre need no bias, and those
                       ///< near to them little
    double length;     ///< from their least y to the greatest
    double camera_y;
    double closest;  ///< least distance of receivers along the camera's view, no less than its near plane
    double sine;     ///< of the angle between view and light
};

template <real T>
[[nodiscard]] along_view make_along_view(const warp_fit<T>& fit, const char* function) {
    require_warp_fit(fit, function);
    along_view v;
    v.frame = light_frame(view_of(fit, function), fit.clip.hand);
    const glm::dvec3 eye(fit.camera.position), view = axes(fit.camera)[2];
    v.sine = glm::length(glm::cross(view, unit(glm::dvec3(fit.direction))));
    const std::vector<glm::dvec3> receivers = corners_of(fit.receivers);
    const auto [low, high] = extent_of(seen(v.frame, receivers));
    const glm::dvec3 own(v.frame * glm::dvec4(eye, 1.0));
    v.first = {own.x, low.y, glm::clamp(own.z, low.z, high.z)};
    v.length = high.y - low.y;
    v.camera_y = own.y;
    v.closest = std::numeric_limits<double>::infinity();
    for (const glm::dvec3& p : receivers) v.closest = glm::min(v.closest, glm::dot(p - eye, view));
    v.closest = glm::max(v.closest, double(fit.camera.z_near));
    return v;
}

/// The wider the angle between view and light, the more of a warp there is: none below 0.02, all of it from 0.2 on.
[[nodiscard]] inline double share_of_warp(double sine) { return glm::clamp((sine - 0.02) / 0.18, 0.0, 1.0); }

/// @return   infinite where camera and light look one way
[[nodiscard]] inline double optimal_distance(const along_view& v) {
    const double n = (v.closest + std::sqrt(v.closest * (v.closest + v.length * v.sine))) / v.sine;
    return v.sine > 0.0 ? n : std::numeric_limits<double>::infinity();
}

/// Near the best on a ground.
[[nodiscard]] inline double default_distance(const along_view& v) { return std::sqrt(v.closest * optimal_distance(v)); }

/// A perspective along y whose centre lies n before the first receivers; in front of them it changes no length.
/// @return    world to x, y, depth and w
/// @formula   (x, y, z) / (1 + y / n) about `first`
[[nodiscard]] inline glm::dmat4 map_along(const along_view& v, double n) {
    const double nearest = v.length * 0x1p-14;  // float holds no more
    const double bend = share_of_warp(v.sine) / glm::max(n, nearest);
    if (!(bend > 0.0 && is_finite(bend))) return v.frame;
    glm::dmat4 warp(1.0);
    warp[3] = glm::dvec4(-v.first, 1.0 - bend * v.first.y);
    warp[1][3] = bend;
    return warp * v.frame;
}

template <real T>
[[nodiscard]] warped_light<T> warped_along(const along_view& v, double n, const warp_fit<T>& fit,
                                           const char* function) {
    const auto warped = refit(map_along(v, n), fit, function);
    return warped ? *warped : unwarped(fit, function);
}

}  // namespace detail

/// How far before the receivers the centre of a light-space perspective has to lie so that the greatest error over the
/// camera's frustum is least: the mildest warp that is of use.
/// @return      world units along the camera's view, across the light; infinite where camera and light look one way
/// @formula     (z0 + sqrt(z0 z1)) / sin t, z1 = z0 + d sin t: z0 the receivers' least distance along the camera's
///              view, d their extent along it across the light, t the angle between view and light
/// @throws std::invalid_argument  as fit_light_space_perspective does
/// @cite        Wimmer, Scherzer, Purgathofer: Light Space Perspective Shadow Maps, EGSR 2004
template <real T = float>
[[nodiscard]] T optimal_distance(const warp_fit<T>& fit) {
    return T(detail::optimal_distance(detail::make_along_view(fit, "optimal_distance")));
}

/// The map of a directional light, warped along the camera's view.
///
/// @param distance   n, from the warp's centre to the receivers next to it, world units along the camera's view across
///                   the light, > 0, infinite for no warp; the smaller, the more texels go to what is close, down to
///                   2^-14 of the receivers' extent, which stands for what is less. By default
///                   sqrt(z0 optimal_distance), z0 the receivers' least distance along the camera's view: near the best
///                   on a ground, whose depth on the screen is foreshortened, if it is seen from there on; too small
///                   where nothing is for long: see seen_range
/// @return           strength 0, which is no warp, where the sine of the angle between view and light is 0.02 or less;
///                   from there to 0.2 the warp grows, without a jump
/// @throws std::invalid_argument  zero or non-finite direction, a camera that is none, receivers empty or of no extent,
///                                casters that are no box, a negative margin, distance not above 0, and what gives
///                                matrices that are not finite
/// @formula          (x, y, depth) / (1 + y / n) about the camera's x and depth and the receivers' least y, y along the
///                   view; then around the receivers
/// @cite             Wimmer, Scherzer, Purgathofer: Light Space Perspective Shadow Maps, EGSR 2004
template <real T = float>
[[nodiscard]] warped_light<T> fit_light_space_perspective(const warp_fit<T>& fit, std::optional<T> distance = {}) {
    constexpr auto function = "fit_light_space_perspective";
    const detail::along_view v = detail::make_along_view(fit, function);
    detail::require(!distance || *distance > T(0), function, "distance", "must be above 0");
    return detail::warped_along(v, distance ? double(*distance) : detail::default_distance(v), fit, function);
}

}  // namespace umbrage

// ---- umbrage/light/warp/perspective.hpp
// Perspective shadow maps: a light's map of the world as the camera's own perspective shrinks it, so that what is small
// on the screen is small in the map. Whatever stands where, rays are texels: the light itself goes through the camera's
// perspective, from which it comes out as a point that shines, as one that swallows the light, or infinitely far away.
//
//     umbrage::warp_fit<float> fit{.camera = camera, .direction = d,
//                                  .receivers = umbrage::intersection(camera, scene), .casters = scene};
//     umbrage::perspective_light<float> warped = umbrage::fit_perspective(fit);
//     if (warped.seen_as == umbrage::light_image::none) report("light-space perspective in its place");
//

namespace umbrage {

/// What becomes of a light in the camera's perspective.
enum class light_image {
    source,    ///< a light before the camera: rays leave a point
    sink,      ///< one behind it: they end in a point
    parallel,  ///< one abreast of it: they stay parallel, or nearly
    none       ///< a point amid the receivers, or too close to them: not warped so
};

template <real T>
struct perspective_light : warped_light<T> {
    light_image seen_as = light_image::none;  ///< none: what stands in its place
};

namespace detail {

/// World to a camera's NDC, in double: the camera moved back, its planes around points.
template <real T>
[[nodiscard]] glm::dmat4 slid_back(const frustum<T>& camera, const std::vector<glm::dvec3>& points, double slide,
                                   const char* function) {
    const glm::dvec3 eye(camera.position), ahead = axes(camera)[2];
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (const glm::dvec3& p : points) {
        const double z = glm::dot(p - eye, ahead);
        least = glm::min(least, z), greatest = glm::max(greatest, z);
    }
    const double back = slide - glm::min(least, 0.0), z_near = least + back;
    const double z_far = glm::max(greatest + back, z_near * (1.0 + 0x1p-8));
    require(is_finite(z_far), function, "receivers", "lie too far from the camera");
    const glm::dmat4 view =
        look_along(eye - back * ahead, ahead, glm::dvec3(camera.up), handedness::right, function, "camera");
    return perspective(double(camera.tan_half_x), double(camera.tan_half_y), z_near, z_far, opengl_clip_space,
                       function) *
           view;
}

/// The least and the greatest of angles under which points lie, in x and in y, z ahead.
struct angles {
    glm::dvec2 low{std::numeric_limits<double>::infinity()}, high{-std::numeric_limits<double>::infinity()};
};
/// @return   nothing where one of them does not lie ahead
[[nodiscard]] inline std::optional<angles> angles_of(const std::vector<glm::dvec3>& points) {
    angles a;
    for (const glm::dvec3& p : points) {
        if (!(p.z > 0.0)) return {};
        const glm::dvec2 angle(std::atan2(p.x, p.z), std::atan2(p.y, p.z));
        a.low = glm::min(a.low, angle), a.high = glm::max(a.high, angle);
    }
    return a;
}

/// Where in NDC the map's axis goes through: halfway between the angles at which the light's image sees receivers.
/// @return   nothing where the image stands amid them
[[nodiscard]] inline std::optional<glm::dvec3> aim(const glm::dvec3& image, const std::vector<glm::dvec3>& receivers,
                                                   const char* function) {
    const auto [low, high] = extent_of(receivers);
    const glm::dvec3 middle = (low + high) * 0.5;
    // seen from beyond the far plane all of NDC lies the same way
    const glm::dvec3 ahead = image.z > 1.0 ? glm::dvec3(0, 0, -1) : middle - image;
    const glm::dmat4 first = light_frame(
        look_along(image, ahead, glm::dvec3(0, 1, 0), handedness::right, function, "camera"), handedness::right);
    const auto around = angles_of(seen(first, receivers));
    if (!around) return {};
    const glm::dvec2 halfway = glm::tan((around->low + around->high) * 0.5);
    const glm::dvec3 axis = unit(glm::transpose(glm::dmat3(first)) * glm::dvec3(halfway, 1.0));
    return image + axis * glm::dot(middle - image, axis);
}

/// A map in which rays are texels, and the angle by which its light's image sees receivers, pi and more: amid them.
struct ray_map {
    glm::dmat4 to_map;  ///< to x, y, depth and w
    double opening;
};

/// Of sources and sinks alike, and of what is between them: the light goes through the aim along u, curved by k, which
/// is above 0 for sources.
/// @param light       in NDC, homogeneous
/// @param up          of the map, in NDC at the aim
/// @param receivers   in NDC
/// @formula           u = -(l.xyz - l.w aim) / r, k = l.w / r, r its length; depth = u.(p - aim), w = 1 + k depth
[[nodiscard]] inline ray_map along_rays(const glm::dvec4& light, const glm::dvec3& aim, const glm::dvec3& up,
                                        const std::vector<glm::dvec3>& receivers, const char* function) {
    const glm::dvec3 back = glm::dvec3(light) - aim * light.w;
    const double bend = light.w / glm::length(back);
    glm::dmat4 rays = light_frame(look_along(aim, -back, up, handedness::right, function, "camera"), handedness::right);
    for (glm::length_t i = 0; i < 4; ++i) rays[i][3] += bend * rays[i][2];

    std::vector<glm::dvec3> ahead;
    for (const glm::dvec3& p : receivers) {
        const glm::dvec4 h = rays * glm::dvec4(p, 1.0);
        ahead.emplace_back(h.x * glm::abs(bend), h.y * glm::abs(bend), h.w);
    }
    const auto seen = angles_of(ahead);
    if (!seen) return {rays, std::numbers::pi};
    const glm::dvec2 opening = seen->high - seen->low;
    return {rays, glm::max(opening.x, opening.y)};
}

/// How much of a map stands in for one that opens so wide: all of it from 150 degrees on, none up to 120.
[[nodiscard]] inline double share_of_stand_in(double opening) {
    constexpr double degree = std::numbers::pi / 180.0;
    return glm::clamp((opening - 120.0 * degree) / (30.0 * degree), 0.0, 1.0);
}

/// A map whose receivers fill -1 to 1, w 1 at the least of them, and that mirrors nothing: maps of one light that are
/// laid so can be mixed, as rays are texels in each.
[[nodiscard]] inline glm::dmat4 filled(const glm::dmat4& to_map, const hull& receivers) {
    extent box;
    double least = std::numeric_limits<double>::infinity();
    for (const glm::dvec3& p : corners_of(receivers)) {
        const glm::dvec4 h = to_map * glm::dvec4(p, 1.0);
        box.low = glm::min(box.low, glm::dvec3(h) / h.w), box.high = glm::max(box.high, glm::dvec3(h) / h.w);
        least = glm::min(least, h.w);
    }
    const glm::dvec3 size = box.high - box.low;
    glm::dvec3 scale = 2.0 / glm::max(size, 0x1p-8 * glm::max(glm::max(size.x, size.y), size.z));
    if (glm::determinant(to_map) < 0.0) scale.x = -scale.x;
    glm::dmat4 placed(1.0);
    for (glm::length_t i = 0; i < 3; ++i)
        placed[i][i] = scale[i], placed[3][i] = -0.5 * scale[i] * (box.low[i] + box.high[i]);
    return placed * to_map / least;
}

/// The map of a light, homogeneous: the way towards it and 0, or its position and 1.
/// @param stand_in   the light's map where it has no other: world to x, y, depth and w
/// @param instead    () -> warped_light<T>, that map
/// @param frame      the light's own, whose y is the map's
template <real T, class Instead>
[[nodiscard]] perspective_light<T> perspective_of(const glm::dvec4& light, const warp_fit<T>& fit,
                                                  const polyhedron& casters, T slide, const char* function,
                                                  const glm::dmat4& frame, const glm::dmat4& stand_in,
                                                  Instead&& instead) {
    require(is_normal(slide) && slide > T(0), function, "slide", "must be above 0 and finite");
    const std::vector<glm::dvec3> receivers = corners_of(fit.receivers);
    const glm::dmat4 to_ndc = slid_back(fit.camera, receivers, double(slide), function);
    const glm::dvec4 image = to_ndc * light;
    std::vector<glm::dvec3> in_ndc;
    for (const glm::dvec3& p : receivers) {
        const glm::dvec4 h = to_ndc * glm::dvec4(p, 1.0);
        in_ndc.push_back(glm::dvec3(h) / h.w);
    }
    const bool far = !(glm::abs(image.w) >= 1e-4 * glm::length(glm::dvec3(image)));
    const auto middle = far ? glm::dvec3(0) : aim(glm::dvec3(image) / image.w, in_ndc, function);
    if (middle) {
        const auto [low, high] = extent_of(in_ndc);
        const glm::dvec4 y = to_ndc * glm::dvec4(frame[0][1], frame[1][1], frame[2][1], 0.0);
        // as the stand-in has it on the camera's axis, of a lamp amid the receivers: both turn alike
        const glm::dvec3 up = glm::dvec3(y) - light.w * 0.5 * (low + high) * y.w;
        const auto [rays, opening] = along_rays(image, *middle, up, in_ndc, function);
        const double share = share_of_stand_in(opening);
        glm::dmat4 to_map = rays * to_ndc;
        if (share > 0.0 && share < 1.0)
            to_map = (1.0 - share) * filled(to_map, fit.receivers) + share * filled(stand_in, fit.receivers);
        const auto warped = share < 1.0 ? refit(to_map, fit, casters, function) : std::nullopt;
        if (warped)
            return {*warped, far ? light_image::parallel : image.w > 0 ? light_image::source : light_image::sink};
    }
    return {instead(), light_image::none};
}

}  // namespace detail

/// The map of a directional light through the camera's perspective. Casters behind the camera need no more of a slide:
/// w is the same all along a ray, and depth runs on.
///
/// While camera and light move the map changes without a jump, from image to image of the light too, and to
/// fit_light_space_perspective, which it turns into while what the camera sees fills 120 to 150 degrees around the
/// light's image.
///
/// @param slide   how far behind its place the camera is taken for the warp, world units, > 0: the least distance to
///                receivers. Less gives more of the map to what is close
/// @return        light_image::none and fit_light_space_perspective where the light, or the point opposite, stands amid
///                what the camera sees, which fills 150 degrees around it or more
/// @throws std::invalid_argument  as fit_light_space_perspective does, and slide not above 0
/// @cite          Stamminger, Drettakis: Perspective Shadow Maps, SIGGRAPH 2002
template <real T = float>
[[nodiscard]] perspective_light<T> fit_perspective(const warp_fit<T>& fit, T slide = T(1)) {
    constexpr auto function = "fit_perspective";
    const detail::along_view v = detail::make_along_view(fit, function);
    const glm::dvec4 light(-v.frame[0][2], -v.frame[1][2], -v.frame[2][2], 0.0);
    const polyhedron casters = fit.casters ? polyhedron(*fit.casters) : polyhedron();
    const double n = detail::default_distance(v);
    return detail::perspective_of(light, fit, casters, slide, function, v.frame, detail::map_along(v, n),
                                  [&] { return detail::warped_along(v, n, fit, function); });
}

/// The same of a point light, such as a spot: a source where it is before the camera, a sink where it is behind.
///
/// @param fit    whose direction is the light's axis
/// @return       light_image::none and what the light sees along its axis, without a warp, where the light stands amid
///               what the camera sees
/// @throws std::invalid_argument  receivers that do not all lie along the axis beyond z_near, z_near not above 0; and
///                                what fit_perspective complains of
template <real T>
[[nodiscard]] perspective_light<T> fit_perspective(const warp_fit<T>& fit, const lamp<T>& from, T slide = T(1)) {
    constexpr auto function = "fit_perspective";
    detail::require_warp_fit(fit, function);
    const detail::lamp_view own = detail::view_of(from, fit, function);
    return detail::perspective_of(glm::dvec4(glm::dvec3(from.position), 1.0), fit, own.casters, slide, function,
                                  own.frame, detail::map_along(own),
                                  [&] { return detail::unwarped(own, fit, function); });
}

}  // namespace umbrage

// ---- umbrage/light/warp/plane_optimal.hpp
// Plane-optimal: a map that on one plane is the screen itself, pixel for pixel in proportion: the best that can be had
// for a ground, and for nothing else.
//
//     umbrage::warp_fit<float> fit{.camera = camera, .direction = d,
//                                  .receivers = umbrage::intersection(camera, scene), .casters = scene};
//     auto ground = umbrage::fit_plane_optimal(fit, glm::vec4(0, 1, 0, 0));  // y = 0
//

namespace umbrage {

/// What matrices in float leave of the plane's own depth, which is the same all over the map, under lights of 3 degrees
/// and more above it: acne_free_bias, that sees no slope, is to be given this much more.
template <real T>
inline constexpr T plane_optimal_rounding = T(0x1p-20);

namespace detail {

/// Where a plane cuts a body's edges: the corners of what they have in common.
[[nodiscard]] inline std::vector<glm::dvec3> crossings(const polyhedron& body, const glm::dvec4& plane) {
    std::vector<glm::dvec3> all;
    for (const polyhedron::face& face : body.faces())
        for (std::size_t i = 0; i < face.corners.size(); ++i) {
            const glm::dvec3 &p = face.corners[i], &q = face.corners[i + 1 < face.corners.size() ? i + 1 : 0];
            const double at_p = glm::dot(plane, glm::dvec4(p, 1.0)), at_q = glm::dot(plane, glm::dvec4(q, 1.0));
            if ((at_p < 0.0) != (at_q < 0.0)) all.push_back(p + (q - p) * (at_p / (at_p - at_q)));
        }
    return all;
}

/// The map of a light, homogeneous: the way towards it and 0, or its position and 1.
/// @param casters   that lie before w = 0
template <real T>
[[nodiscard]] warped_light<T> plane_optimal_of(const glm::dvec4& light, const warp_fit<T>& fit,
                                               const polyhedron& casters, const glm::vec<4, T>& plane,
                                               const char* function) {
    glm::dvec4 ground(plane);
    require(all_finite(plane) && is_normal(glm::length(glm::dvec3(ground))), function, "plane",
            "must be finite and have a normal");
    ground /= glm::length(glm::dvec3(ground)) * (glm::dot(ground, light) < 0.0 ? -1.0 : 1.0);
    const double height = glm::dot(ground, light);
    require(height > 1e-6 * glm::length(light), function, "plane", "must not be seen edge on by the light");
    const std::vector<glm::dvec3> seen = crossings(fit.camera, ground);
    require(!seen.empty(), function, "plane", "must lie before the camera");

    // along the light onto the plane, and from there onto the screen; heights over the plane are depth
    const glm::dmat4 cast = glm::dmat4(1.0) - glm::outerProduct(light, ground) / height;
    const glm::dmat3 camera = axes(fit.camera);
    glm::dmat4 rows;
    const auto row = [&](const glm::dvec3& a) {
        return glm::dvec4(a, -glm::dot(a, glm::dvec3(fit.camera.position))) * cast;
    };
    rows[0] = row(camera[0] / double(fit.camera.tan_half_x));
    rows[1] = row(camera[1] / double(fit.camera.tan_half_y));
    rows[2] = -ground;
    rows[3] = row(camera[2]);
    const glm::dmat4 to_map = glm::transpose(rows);

    double least = std::numeric_limits<double>::infinity(), greatest = 0.0;
    for (const glm::dvec3& p : seen) {
        const double w = (to_map * glm::dvec4(p, 1.0)).w;
        least = glm::min(least, w), greatest = glm::max(greatest, w);
    }
    const double eye = glm::dot(ground, glm::dvec4(glm::dvec3(fit.camera.position), 1.0));
    require(least > 0.0 && glm::abs(eye) > 1e-6 * greatest, function, "plane",
            "must not be seen edge on by the camera");
    const double edge = 1.0 + 2.0 * double(fit.margin);
    // w is a plane's point's, by a share that a point light takes away on the way towards it
    const glm::dvec4 share = (glm::dvec4(0, 0, 0, 1) - ground * (light.w / height)) * glm::inverse(to_map);
    const auto swept = seen_within(to_map, casters,
                                   {{1, 0, 0, edge},
                                    {-1, 0, 0, edge},
                                    {0, 1, 0, edge},
                                    {0, -1, 0, edge},
                                    glm::dvec4(0, 0, 0, 1) - share * least,
                                    share * greatest - glm::dvec4(0, 0, 0, 1)});
    extent box{glm::dvec3(-edge, -edge, 0.0), glm::dvec3(edge, edge, 0.0)};
    if (swept) box.low.z = glm::min(box.low.z, swept->low.z), box.high.z = glm::max(box.high.z, swept->high.z);
    const double deep = glm::max(double(fit.margin), 0x1p-8) * glm::max(box.high.z - box.low.z, 1.0);
    box.low.z -= deep, box.high.z += deep;
    const auto warped = swept ? laid(to_map, box, least, greatest, fit, function) : std::nullopt;
    require(warped.has_value(), function, "plane and camera", "give too large or too small a map");
    return *warped;
}

}  // namespace detail

/// The map of a directional light in which a plane lies as the camera sees it: where the map has k texels for a pixel
/// across the screen, it has them everywhere on the plane, whatever the light. It holds what shades that part of the
/// plane which the screen shows. Receivers apart from the plane are in it where their shadow on the plane is, and with
/// fewer texels; the others, and what they are to be taken as, are the caller's: project_coordinate tells w <= 0, and
/// inside_cascade the rest.
///
/// @param fit     but for its receivers, for which the plane stands
/// @param plane   dot(plane, (p, 1)) = 0, a normal of any length > 0; the light may come from either side
/// @return        of no use for what the light hardly touches: depth grows along the light by its height over the
///                plane, over w
/// @throws std::invalid_argument  zero or non-finite direction, a camera that is none, a plane that is none, that the
///                                camera does not see, or that holds the light's direction (1e-6), casters that are no
///                                box, a negative margin, and what gives matrices that are not finite
/// @formula       x, y and w of the camera after (N.L) I - L N^T, depth - N.p
template <real T = float>
[[nodiscard]] warped_light<T> fit_plane_optimal(const warp_fit<T>& fit, const glm::vec<4, T>& plane) {
    constexpr auto function = "fit_plane_optimal";
    detail::require_warp_fit(fit, function);
    const glm::dmat4 view = detail::light_frame(detail::view_of(fit, function), fit.clip.hand);
    const glm::dvec4 light(-view[0][2], -view[1][2], -view[2][2], 0.0);
    return detail::plane_optimal_of(light, fit, fit.casters ? polyhedron(*fit.casters) : polyhedron(), plane, function);
}

/// The same of a point light.
/// @param fit   whose direction is the light's axis
/// @throws std::invalid_argument  receivers that do not all lie along the axis beyond z_near, z_near not above 0; and
///                                what fit_plane_optimal complains of
template <real T>
[[nodiscard]] warped_light<T> fit_plane_optimal(const warp_fit<T>& fit, const glm::vec<4, T>& plane,
                                                const lamp<T>& from) {
    constexpr auto function = "fit_plane_optimal";
    detail::require_warp_fit(fit, function);
    const detail::lamp_view own = detail::view_of(from, fit, function);
    return detail::plane_optimal_of(glm::dvec4(glm::dvec3(from.position), 1.0), fit, own.casters, plane, function);
}

}  // namespace umbrage

// ---- umbrage/light/warp/trapezoidal.hpp
// Trapezoidal shadow maps: a directional light's map from the trapezoid around what the camera sees, which is warped so
// that up to a chosen distance the camera gets four fifths of the map.
//
//     umbrage::warp_fit<float> fit{.camera = camera, .direction = d,
//                                  .receivers = umbrage::intersection(camera, scene), .casters = scene};
//     auto warped = umbrage::fit_trapezoidal(fit, 20.0f);
//

namespace umbrage {

/// The map of a directional light, warped along the camera's view with the focus on what is close.
///
/// @param focus   distance along the camera's view up to which four fifths of the map are for, world units, >= 0;
///                receivers that begin behind it get the strongest warp there is; none where four fifths of the
///                receivers lie before it
/// @return        strength 0, which is no warp, where the sine of the angle between view and light is 0.02 or less;
///                from there to 0.2 the warp grows, without a jump
/// @throws std::invalid_argument  zero or non-finite direction, a camera that is none, receivers empty or of no extent,
///                                casters that are no box, a negative margin, focus negative or not finite, and what
///                                gives matrices that are not finite
/// @formula       the trapezoid's top and base cross the light's image of the camera's axis at the receivers' ends,
///                l apart; with the focus f behind the top the legs meet 0.4 l f / (1.6 l - 2 f) before it
/// @cite          Martin, Tan: Anti-aliasing and Continuity with Trapezoidal Shadow Maps, EGSR 2004
template <real T = float>
[[nodiscard]] warped_light<T> fit_trapezoidal(const warp_fit<T>& fit, T focus) {
    constexpr auto function = "fit_trapezoidal";
    const detail::along_view v = detail::make_along_view(fit, function);
    detail::require(is_finite(focus) && focus >= T(0), function, "focus", "must be finite and not below 0");
    const double f = glm::max(v.camera_y + double(focus) * v.sine - v.first.y, 0.0), rest = 1.6 * v.length - 2.0 * f;
    if (!(rest > 0.0)) return detail::unwarped(fit, function);
    return detail::warped_along(v, 0.4 * v.length * f / rest, fit, function);
}

}  // namespace umbrage

// ---- umbrage/shader/bind.hpp
// Snippets bound to maps, so that one shader holds maps of several kinds: functions under a suffix of each map's own.
//
//     using namespace umbrage::glsl;
//     std::string shader = source(version::v330, {bind(pcf_2x2, "sun", {.texture = texture::array}),
//                                                 bind(box, "lamp", stored_as(umbrage::rg<11>{}))});
//     // umbrage_pcf_2x2_sun(sampler2DArray map, float layer, vec2 size, ...), umbrage_box_lamp(sampler2D map, ...)
//

namespace umbrage::glsl {

namespace detail {

[[nodiscard]] constexpr bool is_word(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

}  // namespace detail

/// What a map's texels lie in, and so what functions that take a map are called with first; here in GLSL's words:
///   texture_2d             sampler2D map: depths, or values that `depth` makes depths of
///   atlas                  sampler2D map, vec2 origin: a region, whose first texel the caller gives
///   array                  sampler2DArray map, float layer
///   cube                   samplerCube map, float face: one face of cube_map.hpp, filtered within itself
///   cube_faces             samplerCube map: its faces as the tiles of an atlas, for pcf_2x2_cube, to which the size is
///                          that of the atlas then, (3, 2) times a face's
///   integer                usampler2D map: the value is the whole number, exact up to 2^24
///   depth, depth_array     depth textures that are read as they are; in GLSL texture_2d and array
///   shadow, shadow_array   comparison samplers, sampler2DShadow map: they compare themselves, in the direction that
///                          they were set to; a filter that needs depths cannot be bound to them
/// Samplers clamp to the edge and take the nearest texel, but for pcf_2x2_hardware and window_hardware. A depth texture
/// of floats gives the plain form's bits. Where its depths are whole numbers, a sampler compares with the receiver as
/// one from 0 to 1: filters give the same all the same, as they light what is beyond the far plane; lit() alone does
/// not.
enum class texture { texture_2d, atlas, array, cube, cube_faces, integer, depth, depth_array, shadow, shadow_array };

/// A map for shaders: where its texels are, and how they compare. Texts in it are in the shader's own language.
struct binding {
    glsl::texture texture = glsl::texture::texture_2d;
    depth_direction direction = depth_direction::forward;
    bool outside_lit = false;      ///< outside the map all is lit; else the nearest texel inside counts
    bool gather = false;           ///< 2x2 texels at once, and depths at points, by a sampler; it must clamp to the
                                   ///< edge, but for regions
    std::string depth{};           ///< of vec4 `value`, as "umbrage_decode_rg11(value.xy, 1.0)"; empty: value.x
    int channels = 1;              ///< how many of `value` it reads
    std::string origin{};          ///< vec2: the map's first texel in the texture; empty: (0, 0)
    std::string texture_size{};    ///< vec2: for regions of textures that are read by coordinates
    std::string parameters{};      ///< in place of the kind's: what stands for the map in declarations,
    std::string arguments{};       ///< in calls,
    std::string texel{};           ///< and as value, a vec4, of the texture at `at`, a vec2 of whole numbers
    std::vector<snippet> needs{};  ///< what these texts call

    friend bool operator==(const binding&, const binding&) = default;
};

/// The map that an encoding's texels make, in place of `map`'s depth and direction.
template <known_encoding Encoding>
[[nodiscard]] binding stored_as(const Encoding& encoding, binding map = {}) {
    map.direction = encoding.direction;
    if constexpr (Encoding::writes != written::depth) {
        map.channels = static_cast<int>(Encoding::texel::length());
        map.depth = "umbrage_" + std::string(Encoding::reader->name) + "(value." +
                    std::string("xyzw").substr(0, static_cast<std::size_t>(map.channels));
        if constexpr (has_edge<Encoding>) {
            std::string edge = std::to_string(encoding.edge);
            edge.resize(std::max(edge.find_last_not_of('0') + 1, edge.find('.') + 2));
            map.depth += ", " + edge;
        }
        map.depth += ')';
        map.needs.push_back(*Encoding::reader);
    }
    return map;
}

/// A snippet and the map that it is for; a snippet alone is for the shader's one map.
struct bound {
    snippet what;
    std::string suffix{};
    binding map{};
    bool by_macros = true;  ///< in GLSL the hooks are macros of the shader's

    bound(const snippet& s) : what(s) {}
    bound(const snippet& s, std::string_view name, binding b)
        : what(s), suffix(name.empty() ? "" : "_" + std::string(name)), map(std::move(b)), by_macros(false) {}
};

/// The snippet as functions for one map: umbrage_<what>_<name>, or without a suffix when the name is empty.
/// @param name   letters, digits, single underscores between them
/// @throws std::invalid_argument  another name
[[nodiscard]] inline bound bind(const snippet& what, std::string_view name, binding map = {}) {
    char before = '_';
    for (const char c : name) {
        if (!detail::is_word(c) || (c == '_' && before == '_'))
            umbrage::detail::fail("umbrage::glsl::bind: name is not a part of an identifier: " + std::string(name));
        before = c;
    }
    if (!name.empty() && before == '_')
        umbrage::detail::fail("umbrage::glsl::bind: name ends in _: " + std::string(name));
    return {what, name, std::move(map)};
}

}  // namespace umbrage::glsl

// ---- umbrage/shader/texel_hooks.hpp
// The hooks of hooks.hpp that say what a map's depths mean, and those that take its texels as they are, one or four.
//

namespace umbrage::glsl::hooks {

inline constexpr snippet forward_cleared_depth{
    .name = "cleared_depth", .summary = "cleared_depth, forward", .role = hook::chosen, .source = R"GLSL(
// umbrage_cleared_depth: depth of the far plane
UMBRAGE_HIGHP float umbrage_cleared_depth() {
    return 1.0;
}
)GLSL"};

inline constexpr snippet reversed_cleared_depth{
    .name = "cleared_depth", .summary = "cleared_depth, reversed", .role = hook::chosen, .source = R"GLSL(
// umbrage_cleared_depth: depth of the far plane
UMBRAGE_HIGHP float umbrage_cleared_depth() {
    return 0.0;
}
)GLSL"};

inline constexpr snippet forward_beyond_far{
    .name = "beyond_far", .summary = "beyond_far, forward", .role = hook::chosen, .source = R"GLSL(
// umbrage_beyond_far: whether a receiver is behind the far plane
bool umbrage_beyond_far(UMBRAGE_HIGHP float receiver) {
    return receiver > 1.0;
}
)GLSL"};

inline constexpr snippet reversed_beyond_far{
    .name = "beyond_far", .summary = "beyond_far, reversed", .role = hook::chosen, .source = R"GLSL(
// umbrage_beyond_far: whether a receiver is behind the far plane
bool umbrage_beyond_far(UMBRAGE_HIGHP float receiver) {
    return receiver < 0.0;
}
)GLSL"};

inline constexpr snippet scaled_beyond_far{
    .name = "beyond_far", .summary = "beyond_far, scaled", .role = hook::chosen, .source = R"GLSL(
// umbrage_beyond_far: never on this scale; receivers behind the far plane come in as what every texel lights
bool umbrage_beyond_far(UMBRAGE_HIGHP float receiver) {
    return false;
}
)GLSL"};

inline constexpr snippet forward_before_far{
    .name = "before_far", .summary = "before_far, forward", .role = hook::chosen, .source = R"GLSL(
// umbrage_before_far: whether a receiver is a number, and not behind the far plane
bool umbrage_before_far(UMBRAGE_HIGHP float receiver) {
    return receiver <= 1.0;
}
)GLSL"};

inline constexpr snippet reversed_before_far{
    .name = "before_far", .summary = "before_far, reversed", .role = hook::chosen, .source = R"GLSL(
// umbrage_before_far: whether a receiver is a number, and not behind the far plane
bool umbrage_before_far(UMBRAGE_HIGHP float receiver) {
    return receiver >= 0.0;
}
)GLSL"};

inline constexpr snippet forward_compare{
    .name = "compare", .summary = "compare, forward", .role = hook::chosen, .source = R"GLSL(
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth
UMBRAGE_HIGHP float umbrage_compare(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return receiver <= stored ? 1.0 : 0.0;
}
)GLSL"};

inline constexpr snippet reversed_compare{
    .name = "compare", .summary = "compare, reversed", .role = hook::chosen, .source = R"GLSL(
// umbrage_compare: 1.0 when the receiver is no farther than the stored depth, near is 1.0
UMBRAGE_HIGHP float umbrage_compare(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return receiver >= stored ? 1.0 : 0.0;
}
)GLSL"};

inline constexpr snippet texel{.name = "texel", .summary = "texel", .role = hook::chosen, .source = R"GLSL(
// umbrage_texel: value of a texel inside the map; whole numbers, (0, 0) is the first
UMBRAGE_HIGHP vec4 umbrage_texel(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    return UMBRAGE_TEXEL;
}
)GLSL"};

inline constexpr snippet decode{.name = "decode", .summary = "decode", .role = hook::chosen, .source = R"GLSL(
// umbrage_decode: depth of a texel's value
UMBRAGE_HIGHP float umbrage_decode(UMBRAGE_HIGHP vec4 value) {
    return UMBRAGE_DEPTH;
}
)GLSL"};

inline constexpr snippet clamped_depth{.name = "fetch_depth",
                                       .summary = "fetch_depth, clamped",
                                       .needs = list<&fetch_clamped, &decode>,
                                       .role = hook::chosen,
                                       .source = R"GLSL(
// umbrage_fetch_depth: stored depth of a texel, outside the map of the nearest one inside
UMBRAGE_HIGHP float umbrage_fetch_depth(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    return umbrage_decode(umbrage_fetch_clamped(map, size, texel));
}
)GLSL"};

inline constexpr snippet bordered_depth{.name = "fetch_depth",
                                        .summary = "fetch_depth, bordered",
                                        .needs = list<&fetch_clamped, &decode, &inside_map, &cleared_depth>,
                                        .role = hook::chosen,
                                        .source = R"GLSL(
// umbrage_fetch_depth: stored depth of a texel, outside the map that of the far plane
UMBRAGE_HIGHP float umbrage_fetch_depth(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP float depth = umbrage_decode(umbrage_fetch_clamped(map, size, texel));
    return umbrage_inside_map(size, texel) ? depth : umbrage_cleared_depth();
}
)GLSL"};

inline constexpr snippet lit_texel{.name = "lit_texel", .summary = "lit_texel", .role = hook::chosen, .source = R"GLSL(
// umbrage_lit_texel: the sampler's comparison with a texel inside the map; a NaN is in shadow
UMBRAGE_HIGHP float umbrage_lit_texel(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP float lit = UMBRAGE_LIT_TEXEL;
    return (receiver > 0.0 ? lit : 0.0) + (receiver <= 0.0 ? lit : 0.0);
}
)GLSL"};

inline constexpr snippet clamped_lit{
    .name = "lit", .summary = "lit, clamped", .needs = list<&lit_texel>, .role = hook::chosen, .source = R"GLSL(
// umbrage_lit: visibility of one comparison with a texel, outside the map with the nearest one inside
UMBRAGE_HIGHP float umbrage_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                UMBRAGE_HIGHP float receiver) {
    return umbrage_lit_texel(map, size, clamp(texel, vec2(0.0, 0.0), size - 1.0), receiver);
}
)GLSL"};

inline constexpr snippet bordered_lit{.name = "lit",
                                      .summary = "lit, bordered",
                                      .needs = list<&lit_texel, &inside_map, &compare, &cleared_depth>,
                                      .role = hook::chosen,
                                      .source = R"GLSL(
// umbrage_lit: visibility of one comparison with a texel, outside the map with the far plane
UMBRAGE_HIGHP float umbrage_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP float lit = umbrage_lit_texel(map, size, clamp(texel, vec2(0.0, 0.0), size - 1.0), receiver);
    return umbrage_inside_map(size, texel) ? lit : umbrage_compare(receiver, umbrage_cleared_depth());
}
)GLSL"};

// Four texels at once: a gather gives those at (0, 1), (1, 1), (1, 0) and (0, 0), in this order.

inline constexpr snippet gather_compared{
    .name = "gather_lit", .summary = "gather_lit, compared", .role = hook::gather_lit, .source = R"GLSL(
// umbrage_gather_lit: the sampler's comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1); a NaN is in shadow
UMBRAGE_HIGHP vec4 umbrage_gather_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec4 lit = UMBRAGE_GATHER_LIT;
    UMBRAGE_HIGHP float number = (receiver > 0.0 ? 1.0 : 0.0) + (receiver <= 0.0 ? 1.0 : 0.0);
    return vec4(lit.w, lit.z, lit.x, lit.y) * number;
}
)GLSL"};

inline constexpr snippet gather_one_channel{.name = "gather_lit",
                                            .summary = "gather_lit, one channel",
                                            .needs = list<&decode, &compare>,
                                            .role = hook::chosen,
                                            .source = R"GLSL(
// umbrage_gather_lit: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
UMBRAGE_HIGHP vec4 umbrage_gather_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec4 r = UMBRAGE_GATHER_RED;
    UMBRAGE_HIGHP float a = umbrage_compare(receiver, umbrage_decode(vec4(r.w, 0.0, 0.0, 0.0)));
    UMBRAGE_HIGHP float b = umbrage_compare(receiver, umbrage_decode(vec4(r.z, 0.0, 0.0, 0.0)));
    UMBRAGE_HIGHP float c = umbrage_compare(receiver, umbrage_decode(vec4(r.x, 0.0, 0.0, 0.0)));
    UMBRAGE_HIGHP float d = umbrage_compare(receiver, umbrage_decode(vec4(r.y, 0.0, 0.0, 0.0)));
    return vec4(a, b, c, d);
}
)GLSL"};

inline constexpr snippet gather_two_channels{.name = "gather_lit",
                                             .summary = "gather_lit, two channels",
                                             .needs = list<&decode, &compare>,
                                             .role = hook::chosen,
                                             .source = R"GLSL(
// umbrage_gather_lit: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1)
UMBRAGE_HIGHP vec4 umbrage_gather_lit(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                      UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec4 r = UMBRAGE_GATHER_RED;
    UMBRAGE_HIGHP vec4 g = UMBRAGE_GATHER_GREEN;
    UMBRAGE_HIGHP float a = umbrage_compare(receiver, umbrage_decode(vec4(r.w, g.w, 0.0, 0.0)));
    UMBRAGE_HIGHP float b = umbrage_compare(receiver, umbrage_decode(vec4(r.z, g.z, 0.0, 0.0)));
    UMBRAGE_HIGHP float c = umbrage_compare(receiver, umbrage_decode(vec4(r.x, g.x, 0.0, 0.0)));
    UMBRAGE_HIGHP float d = umbrage_compare(receiver, umbrage_decode(vec4(r.y, g.y, 0.0, 0.0)));
    return vec4(a, b, c, d);
}
)GLSL"};

inline constexpr snippet gathered{.name = "lit_2x2",
                                  .summary = "lit_2x2, gathered",
                                  .needs = list<&gather_compared>,
                                  .role = hook::chosen,
                                  .source = R"GLSL(
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1); the sampler clamps
UMBRAGE_HIGHP vec4 umbrage_lit_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    return umbrage_gather_lit(map, size, texel, receiver);
}
)GLSL"};

inline constexpr snippet gathered_region{.name = "lit_2x2",
                                         .summary = "lit_2x2, gathered in a region",
                                         .needs = list<&gather_compared>,
                                         .role = hook::chosen,
                                         .source = R"GLSL(
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1), outside the map with
//   the nearest texel inside: the gather stays inside, and each comparison is taken from its row and column
UMBRAGE_HIGHP vec4 umbrage_lit_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 first = clamp(texel, vec2(0.0, 0.0), max(size - 2.0, vec2(0.0, 0.0)));
    UMBRAGE_HIGHP vec2 low = clamp(texel, vec2(0.0, 0.0), size - 1.0) - first;
    UMBRAGE_HIGHP vec2 high = clamp(texel + 1.0, vec2(0.0, 0.0), size - 1.0) - first;
    UMBRAGE_HIGHP vec4 lit = umbrage_gather_lit(map, size, first, receiver);
    UMBRAGE_HIGHP vec2 left = low.x > 0.5 ? vec2(lit.y, lit.w) : vec2(lit.x, lit.z);
    UMBRAGE_HIGHP vec2 right = high.x > 0.5 ? vec2(lit.y, lit.w) : vec2(lit.x, lit.z);
    UMBRAGE_HIGHP vec2 bottom = low.y > 0.5 ? vec2(left.y, right.y) : vec2(left.x, right.x);
    UMBRAGE_HIGHP vec2 top = high.y > 0.5 ? vec2(left.y, right.y) : vec2(left.x, right.x);
    return vec4(bottom.x, bottom.y, top.x, top.y);
}
)GLSL"};

inline constexpr snippet gathered_bordered{.name = "lit_2x2",
                                           .summary = "lit_2x2, gathered and bordered",
                                           .needs = list<&gather_compared, &inside_map, &compare, &cleared_depth>,
                                           .role = hook::chosen,
                                           .source = R"GLSL(
// umbrage_lit_2x2: visibility of the comparisons with texel + (0, 0), (1, 0), (0, 1) and (1, 1), outside the map with
//   the far plane: the gather stays inside
UMBRAGE_HIGHP vec4 umbrage_lit_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                   UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 first = clamp(texel, vec2(0.0, 0.0), max(size - 2.0, vec2(0.0, 0.0)));
    UMBRAGE_HIGHP vec2 low = texel - first;
    UMBRAGE_HIGHP vec4 lit = umbrage_gather_lit(map, size, first, receiver);
    UMBRAGE_HIGHP vec2 left = low.x > 0.5 ? vec2(lit.y, lit.w) : vec2(lit.x, lit.z);
    UMBRAGE_HIGHP vec2 right = low.x < -0.5 ? vec2(lit.x, lit.z) : vec2(lit.y, lit.w);
    UMBRAGE_HIGHP vec2 bottom = low.y > 0.5 ? vec2(left.y, right.y) : vec2(left.x, right.x);
    UMBRAGE_HIGHP vec2 top = low.y < -0.5 ? vec2(left.x, right.x) : vec2(left.y, right.y);
    UMBRAGE_HIGHP float outside = umbrage_compare(receiver, umbrage_cleared_depth());
    UMBRAGE_HIGHP float a = umbrage_inside_map(size, texel) ? bottom.x : outside;
    UMBRAGE_HIGHP float b = umbrage_inside_map(size, texel + vec2(1.0, 0.0)) ? bottom.y : outside;
    UMBRAGE_HIGHP float c = umbrage_inside_map(size, texel + vec2(0.0, 1.0)) ? top.x : outside;
    UMBRAGE_HIGHP float d = umbrage_inside_map(size, texel + vec2(1.0, 1.0)) ? top.y : outside;
    return vec4(a, b, c, d);
}
)GLSL"};

}  // namespace umbrage::glsl::hooks

// ---- umbrage/shader/hooks.hpp
// What a map can be, as functions: bind() puts these in place of the hooks' texts for a shader's one map. Words that a
// map fills in: UMBRAGE_MAP map, what it is called with; UMBRAGE_ORIGIN, its first texel in the texture; UMBRAGE_DEPTH,
// the depth of a `value`; UMBRAGE_UV, what the sampler takes for `at`; and those that read the texture at `at` or `uv`.
//

namespace umbrage::glsl::hooks {

// The sampler weighs: coordinates stay half a texel inside, so that what is beside the map has no weight.

inline constexpr snippet clamped_lit_filtered{.name = "lit_filtered",
                                              .summary = "lit_filtered, clamped",
                                              .needs = list<&before_far>,
                                              .role = hook::chosen,
                                              .source = R"GLSL(
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted by the sampler; a NaN is in shadow
//   coord  in texels, no NaN
UMBRAGE_HIGHP float umbrage_lit_filtered(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                         UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 texel = clamp(coord, vec2(0.5, 0.5), size - 0.5);
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec2 uv = UMBRAGE_UV;
    UMBRAGE_HIGHP float lit = UMBRAGE_LIT_FILTERED;
    return umbrage_before_far(receiver) ? lit : 0.0;
}
)GLSL"};

inline constexpr snippet bordered_lit_filtered{.name = "lit_filtered",
                                               .summary = "lit_filtered, bordered",
                                               .needs = list<&before_far, &compare, &cleared_depth>,
                                               .role = hook::chosen,
                                               .source = R"GLSL(
// umbrage_lit_filtered: 2x2 comparisons around a point, weighted by the sampler, outside the map with the far plane; a
//   NaN is in shadow
//   coord  in texels, no NaN
UMBRAGE_HIGHP float umbrage_lit_filtered(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                         UMBRAGE_HIGHP float receiver) {
    UMBRAGE_HIGHP vec2 texel = clamp(coord, vec2(0.5, 0.5), size - 0.5);
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    UMBRAGE_HIGHP vec2 uv = UMBRAGE_UV;
    UMBRAGE_HIGHP float lit = UMBRAGE_LIT_FILTERED;
    UMBRAGE_HIGHP vec2 inside = clamp(min(coord, size - coord) + 0.5, vec2(0.0, 0.0), vec2(1.0, 1.0));
    UMBRAGE_HIGHP float outside = umbrage_compare(receiver, umbrage_cleared_depth());
    return umbrage_before_far(receiver) ? outside + inside.x * inside.y * (lit - outside) : 0.0;
}
)GLSL"};

// Where a map is all of its texture, uv over the map is what the sampler takes, and the sampler clamps to the edge.

inline constexpr snippet sampled_lit{
    .name = "lit_at", .summary = "lit_at, sampled", .role = hook::chosen, .source = R"GLSL(
// umbrage_lit_at: 2x2 comparisons around a point, weighted by the sampler
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0);   receiver  no NaN
UMBRAGE_HIGHP float umbrage_lit_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv,
                                   UMBRAGE_HIGHP float receiver) {
    return UMBRAGE_LIT_FILTERED;
}
)GLSL"};

inline constexpr snippet sampled_depth{
    .name = "depth_at", .summary = "depth_at, sampled", .needs = list<&decode>, .role = hook::chosen, .source = R"GLSL(
// umbrage_depth_at: stored depth of the texel at a point, by the sampler
//   uv  over the map, (0.0, 0.0) to (1.0, 1.0)
UMBRAGE_HIGHP float umbrage_depth_at(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 uv) {
    return umbrage_decode(UMBRAGE_SAMPLED);
}
)GLSL"};

/// Every one of them, for printers and packages.
inline constexpr auto all =
    list<&forward_cleared_depth, &reversed_cleared_depth, &forward_beyond_far, &reversed_beyond_far, &scaled_beyond_far,
         &forward_before_far, &reversed_before_far, &forward_compare, &reversed_compare, &texel, &decode,
         &clamped_depth, &bordered_depth, &lit_texel, &clamped_lit, &bordered_lit, &gather_compared,
         &gather_one_channel, &gather_two_channels, &gathered, &gathered_region, &gathered_bordered,
         &clamped_lit_filtered, &bordered_lit_filtered, &sampled_lit, &sampled_depth>;

}  // namespace umbrage::glsl::hooks

// ---- umbrage/shader/translate/layout.hpp
// Where lines end, once words of another length stand in them.
//

namespace umbrage::glsl::detail {

/// One statement, or a function's head, in lines of at most 120 columns. Lines end behind a comma or an operator, as
/// far out of brackets as may be; what goes on stands below the bracket that it is in, or four columns in.
[[nodiscard]] inline std::string broken(std::string statement) {
    const std::size_t margin = statement.find_first_not_of(' ');
    std::string out;
    std::vector<std::size_t> brackets;  // columns behind those that are open where the line at work begins
    for (std::size_t begin = margin; statement.size() > 120;) {
        std::vector<std::size_t> open = brackets, open_at_end;
        std::size_t end = 0;
        for (std::size_t i = begin; i <= 120; ++i) {
            const char c = statement[i];
            if (c == '(' || c == '[') open.push_back(i + 1);
            if ((c == ')' || c == ']') && !open.empty()) open.pop_back();
            const bool can_end =
                c == ' ' && i > begin && std::string_view(",=+*/&|").find(statement[i - 1]) != std::string_view::npos;
            if (!can_end || (end > 0 && open.size() > open_at_end.size())) continue;
            end = i;
            open_at_end = open;
        }
        if (end == 0) break;
        brackets = open_at_end;
        begin = brackets.empty() ? margin + 4 : brackets.back();
        out += statement.substr(0, end) + '\n';
        statement.replace(0, end + 1, begin, ' ');
    }
    return out + statement;
}

/// The text with the lines of each statement joined and broken again; a comment or a directive stays as it is.
[[nodiscard]] inline std::string laid_out(std::string_view text) {
    const auto next_line = [&] {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(line.size() < text.size() ? line.size() + 1 : line.size());
        return line;
    };
    const auto is_code = [](std::string_view line) {
        const std::size_t begin = line.find_first_not_of(' ');
        return begin != line.npos && line[begin] != '#' && line.substr(begin, 2) != "//";
    };
    const auto ends_statement = [](std::string_view line) {
        return line.find("//") != line.npos || std::string_view(";{}").find(line.back()) != std::string_view::npos;
    };
    std::string out;
    while (!text.empty()) {
        std::string_view line = next_line();
        if (is_code(line)) {
            std::string statement(line.substr(0, line.find("//")));
            while (!ends_statement(line) && is_code(text.substr(0, text.find('\n')))) {
                line = next_line();
                std::string_view code = line.substr(0, line.find("//"));
                code.remove_prefix(code.find_first_not_of(' '));
                statement += (statement.back() == '(' ? "" : " ") + std::string(code);
            }
            out += broken(std::move(statement));
            if (line.find("//") != line.npos) out += line.substr(line.find("//"));
        } else {
            out += line;
        }
        out += '\n';
    }
    return out;
}

}  // namespace umbrage::glsl::detail

// ---- umbrage/shader/compose.hpp
// How bound snippets become one text, in any language: the hooks that a map chooses in place of the snippets' own, the
// words that it fills in, everything once and after what it needs.
//

namespace umbrage::glsl::detail {

/// A language's words for a kind of texture. Expressions read it at `at`, vec2 of whole numbers, or at `uv`, vec2 from
/// 0 to 1.
struct texture_words {
    std::string_view parameters, arguments;
    std::string_view texel{};                        ///< vec4; lines that begin with # stand for the whole statement
    std::string_view sampled{};                      ///< vec4 at `uv`
    std::string_view lit{};                          ///< the sampler's comparison with `receiver`: float
    std::string_view gather_red{}, gather_green{};   ///< vec4
    std::string_view gather_lit{};                   ///< the sampler's comparisons with `receiver`: vec4
    std::string_view lit_filtered{};                 ///< those around `uv`, weighted by the sampler: float
    std::string_view size{};                         ///< of the texture: vec2
    std::string_view sampler{}, sampler_argument{};  ///< what gathers take behind the first parameter: ", sampler s"
    snippet_span needs{};                            ///< what these words call
};

/// What there is to know of a language.
struct language {
    std::string_view prelude;  ///< what every text begins with
    texture_words (*texture)(glsl::texture kind);
    std::string (*translate)(const snippet& s);  ///< its text in the language, with the words that a map fills in
    bool preprocessor = true;                    ///< keeps what is pasted twice from clashing
    bool macros = false;                         ///< the hooks of a shader's one map are the snippets' own
    std::string_view scaled_macro{};             ///< for those of depths on a scale of their own
};

/// The text with each word replaced by replacement(word, in_comment).
template <class Replacement>
[[nodiscard]] std::string replace_words(std::string_view text, const Replacement& replacement) {
    std::string out;
    bool comment = false;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i;
        while (end < text.size() && is_word(text[end])) ++end;
        if (end > i) {
            out += replacement(text.substr(i, end - i), comment);
            i = end;
            continue;
        }
        comment = text[i] == '\n' ? false : comment || text.substr(i, 2) == "//";
        out += text[i++];
    }
    return out;
}

[[nodiscard]] inline bool has_region(const binding& b) { return b.texture == texture::atlas || !b.origin.empty(); }
/// Whether a map is all of its texture, edges and all.
[[nodiscard]] inline bool is_whole(const binding& b) { return !has_region(b) && !b.outside_lit; }
[[nodiscard]] constexpr bool is_cube(texture kind) { return kind == texture::cube || kind == texture::cube_faces; }
[[nodiscard]] constexpr bool gathers(texture kind) { return !is_cube(kind) && kind != texture::integer; }
[[nodiscard]] inline bool compares(texture kind) { return kind == texture::shadow || kind == texture::shadow_array; }

/// The function that a map has in place of a hook's own text; other snippets as they are.
/// @throws std::invalid_argument  the map cannot have what is asked of it
[[nodiscard]] inline const snippet& chosen(const snippet& s, const binding& b) {
    const bool forward = b.direction == depth_direction::forward;
    const bool scaled = std::any_of(b.needs.begin(), b.needs.end(), [](const snippet& n) { return n.scaled; });
    switch (s.role) {
        case hook::none:
        case hook::chosen: return s;
        case hook::cleared_depth: return forward ? hooks::forward_cleared_depth : hooks::reversed_cleared_depth;
        case hook::beyond_far:
            return scaled ? hooks::scaled_beyond_far : forward ? hooks::forward_beyond_far : hooks::reversed_beyond_far;
        case hook::before_far: return scaled ? s : forward ? hooks::forward_before_far : hooks::reversed_before_far;
        case hook::compare: return forward ? hooks::forward_compare : hooks::reversed_compare;
        case hook::texel:
        case hook::fetch_depth:
            if (compares(b.texture))
                umbrage::detail::fail("umbrage::glsl::bind: a comparison sampler compares, it gives no depths");
            if (s.role == hook::texel) return hooks::texel;
            return b.outside_lit ? hooks::bordered_depth : hooks::clamped_depth;
        case hook::lit:
            if (!compares(b.texture)) return s;
            return b.outside_lit ? hooks::bordered_lit : hooks::clamped_lit;
        case hook::lit_2x2:
            if (!b.gather) return s;
            if (b.outside_lit) return hooks::gathered_bordered;
            return has_region(b) ? hooks::gathered_region : hooks::gathered;
        case hook::gather_lit:
            if (!gathers(b.texture))
                umbrage::detail::fail("umbrage::glsl::bind: no gather from a cube or from whole numbers");
            if (compares(b.texture)) return hooks::gather_compared;
            if (b.channels > 2) umbrage::detail::fail("umbrage::glsl::bind: a gather of more than two channels");
            return b.channels == 2 ? hooks::gather_two_channels : hooks::gather_one_channel;
        case hook::lit_filtered:
            if (!compares(b.texture)) return s;
            return b.outside_lit ? hooks::bordered_lit_filtered : hooks::clamped_lit_filtered;
        case hook::lit_at: return compares(b.texture) && is_whole(b) ? hooks::sampled_lit : s;
        case hook::depth_at:
            return b.gather && gathers(b.texture) && !compares(b.texture) && is_whole(b) ? hooks::sampled_depth : s;
    }
    return s;
}

/// Whether a snippet's functions are a map's own: they are hooks, or call some.
[[nodiscard]] inline bool is_of_map(const snippet& s) {
    return s.role != hook::none ||
           std::any_of(s.needs.begin(), s.needs.end(), [](const snippet* need) { return is_of_map(*need); });
}

/// What a text calls its map: `map`, or `table`.
[[nodiscard]] inline std::string name_of_map(std::string_view text) {
    const std::string_view type = "UMBRAGE_MAP ";
    const auto at = text.find(type);
    if (at == text.npos) return "map";
    text.remove_prefix(at + type.size());
    return std::string(text.substr(0, text.find_first_of(",)")));
}

/// A snippet's text with what a map fills in.
[[nodiscard]] inline std::string for_map(std::string text, const snippet& s, const bound& item,
                                         const texture_words& words) {
    const binding& map = item.map;
    const auto one_of = [](const std::string& own, std::string_view ordinary) {
        return own.empty() ? std::string(ordinary) : own;
    };
    const std::string origin = map.texture == texture::atlas ? one_of(map.origin, "origin") : map.origin;
    const std::string texture_size = one_of(map.texture_size, origin.empty() ? "size" : words.size);
    const auto replace = [&](std::string_view what, std::string_view with) {
        for (auto at = text.find(what); at != text.npos; at = text.find(what, at + with.size()))
            text.replace(at, what.size(), with);
    };
    const std::string texel = one_of(map.texel, words.texel);
    if (texel.starts_with('#')) replace("    return UMBRAGE_TEXEL;\n", "UMBRAGE_TEXEL");
    if (const auto at = text.find("UMBRAGE_ORIGIN"); at != text.npos && origin.empty()) {
        const auto begin = text.rfind('\n', at);
        text.erase(begin, text.find('\n', at) - begin);
    }
    const std::string own_map = name_of_map(text);
    replace("UMBRAGE_MAP " + own_map, "UMBRAGE_PARAMETERS");
    const auto list = [&](const std::string& own, std::string_view ordinary, std::string_view sampler) {
        std::string all = one_of(own, ordinary);
        if (own.empty() && map.gather) all.insert(std::min(all.find(','), all.size()), sampler);
        return replace_words(all,
                             [&](std::string_view word, bool) { return word == "map" ? own_map : std::string(word); });
    };

    const auto suffixed = [&](std::string_view word) {
        const auto is_it = [name = word.substr(8)](const snippet& own) { return own.name == name && is_of_map(own); };
        const bool own = word.substr(8) == s.name || std::any_of(map.needs.begin(), map.needs.end(), is_it) ||
                         std::any_of(s.needs.begin(), s.needs.end(), [&](const snippet* n) { return is_it(*n); });
        return std::string(word) + (own ? item.suffix : std::string());
    };
    const auto of_texture = [&](std::string_view expression) {
        return replace_words(expression, [&](std::string_view word, bool) -> std::string {
            if (word.starts_with("umbrage_")) return suffixed(word);
            if (word == "at" && origin.empty()) return "texel";
            if (word != "UMBRAGE_TEXTURE_SIZE") return std::string(word);
            if (texture_size.empty()) umbrage::detail::fail("umbrage::glsl::bind: this language needs texture_size");
            return texture_size;
        });
    };
    return replace_words(text, [&](std::string_view word, bool comment) -> std::string {
        if (word.starts_with("umbrage_")) return suffixed(word);
        if (word == own_map && !comment) return list(map.arguments, words.arguments, words.sampler_argument);
        if (word == "UMBRAGE_PARAMETERS") return list(map.parameters, words.parameters, words.sampler);
        if (word == "UMBRAGE_DEPTH") return of_texture(one_of(map.depth, "value.x"));
        if (word == "UMBRAGE_ORIGIN") return origin;
        if (word == "UMBRAGE_TEXEL") return of_texture(texel);
        if (word == "UMBRAGE_LIT_TEXEL") return of_texture(words.lit);
        if (word == "UMBRAGE_UV") return of_texture("at / UMBRAGE_TEXTURE_SIZE");
        if (word == "UMBRAGE_SAMPLED") return of_texture(words.sampled);
        if (word == "UMBRAGE_LIT_FILTERED") return of_texture(words.lit_filtered);
        if (word == "UMBRAGE_GATHER_RED") return of_texture(words.gather_red);
        if (word == "UMBRAGE_GATHER_GREEN") return of_texture(words.gather_green);
        if (word == "UMBRAGE_GATHER_LIT") return of_texture(words.gather_lit);
        return std::string(word);
    });
}

/// One text in the making.
class composition {
public:
    composition(const language& l, std::span<const bound> items) : language_(l), items_(items.begin(), items.end()) {
        binding one;  // the shader's one map compares on a scale of its own if anything here makes such depths
        for (const bound& item : items_)
            if (item.by_macros && item.what.scaled) one.needs.push_back(item.what);
        for (bound& item : items_) {
            if (item.by_macros) item.map = one;
            for (const bound& other : items)
                if (!item.by_macros && item.suffix == other.suffix && !(item.map == other.map) &&
                    (!other.by_macros || is_of_map(other.what)))
                    umbrage::detail::fail("umbrage::glsl::text: two maps have one name:" + item.suffix);
        }
        if (language_.macros && !one.needs.empty()) text_ += language_.scaled_macro;
    }

    /// What belongs to no map comes first: hooks may call it, whatever the order of the items.
    [[nodiscard]] std::string text() && {
        for (const bool of_map : {false, true})
            for (const bound& item : items_) {
                for (const snippet& need : item.map.needs) add(need, item, of_map);
                for (const snippet* need : language_.texture(item.map.texture).needs) add(*need, item, of_map);
                add(item.what, item, of_map);
            }
        return std::move(text_);
    }

private:
    void add(const snippet& asked, const bound& item, bool of_map) {
        const bool by_macros = language_.macros && item.by_macros;
        const snippet& s = by_macros ? asked : chosen(asked, item.map);
        for (const snippet* need : s.needs) add(*need, item, of_map);
        if (is_of_map(s) != of_map) return;
        std::string guard = "UMBRAGE_HAS_" + std::string(s.name) + (of_map ? item.suffix : std::string());
        for (char& c : guard) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        if (std::find(done_.begin(), done_.end(), guard) != done_.end()) return;
        const std::string body = language_.translate(s);
        if (language_.preprocessor) text_ += "\n#ifndef " + guard + "\n#define " + guard;
        text_ += of_map && !by_macros ? laid_out(for_map(body, s, item, language_.texture(item.map.texture))) : body;
        if (language_.preprocessor) text_ += "#endif\n";
        done_.push_back(std::move(guard));
    }

    const language& language_;
    std::vector<bound> items_;
    std::string text_;
    std::vector<std::string> done_;
};

/// A line that names what follows, then it.
[[nodiscard]] inline std::string compose(const language& l, std::span<const bound> items) {
    std::string title = "// umbrage " + std::to_string(UMBRAGE_VERSION_MAJOR) + '.' +
                        std::to_string(UMBRAGE_VERSION_MINOR) + '.' + std::to_string(UMBRAGE_VERSION_PATCH) +
                        ", MIT License";
    std::vector<std::string> names;
    for (const bound& item : items) {
        std::string name = std::string(item.what.name) + item.suffix;
        if (std::find(names.begin(), names.end(), name) != names.end()) continue;
        title += (names.empty() ? ": " : ", ") + name;
        names.push_back(std::move(name));
    }
    return title + '\n' + std::string(l.prelude) + composition(l, items).text();
}

}  // namespace umbrage::glsl::detail

// ---- umbrage/shader/glsl.hpp
// Snippets as GLSL: text to paste, or the beginning of a shader.
//
//     std::string shader = umbrage::glsl::source(umbrage::glsl::version::v330, {umbrage::glsl::pcf_2x2}) + my_main;
//

namespace umbrage::glsl {

/// Macros that every text relies on; each can be defined beforehand to something else.
inline constexpr std::string_view prelude = R"GLSL(
#ifndef UMBRAGE_HIGHP
#ifdef GL_ES
#define UMBRAGE_HIGHP highp
#else
#define UMBRAGE_HIGHP
#endif
#endif
#ifndef UMBRAGE_PRECISE
#if (defined(GL_ES) && __VERSION__ >= 320) || (!defined(GL_ES) && __VERSION__ >= 400)
#define UMBRAGE_PRECISE precise
#else
#define UMBRAGE_PRECISE
#endif
#endif
)GLSL";

namespace detail {

inline constexpr std::string_view scaled_macro = R"GLSL(
// depths here are on a scale of their own, on which 1.0 is not the far plane
#ifndef UMBRAGE_BEYOND_FAR
#define UMBRAGE_BEYOND_FAR(receiver) false
#endif
)GLSL";

[[nodiscard]] constexpr texture_words glsl_reads(texture kind) {
    switch (kind) {
        case texture::texture_2d:
        case texture::depth:
        case texture::atlas:
            return {.parameters = kind == texture::atlas ? "UMBRAGE_HIGHP sampler2D map, UMBRAGE_HIGHP vec2 origin"
                                                         : "UMBRAGE_HIGHP sampler2D map",
                    .arguments = kind == texture::atlas ? "map, origin" : "map",
                    .texel = R"GLSL(#if __VERSION__ >= 130
    return texelFetch(map, ivec2(at), 0);
#else
    return texture2D(map, (at + 0.5) / UMBRAGE_TEXTURE_SIZE);
#endif
)GLSL",
                    .sampled = "textureLod(map, uv, 0.0)",
                    .gather_red = "textureGather(map, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, 0)",
                    .gather_green = "textureGather(map, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, 1)"};
        case texture::array:
        case texture::depth_array:
            return {.parameters = "UMBRAGE_HIGHP sampler2DArray map, UMBRAGE_HIGHP float layer",
                    .arguments = "map, layer",
                    .texel = "texelFetch(map, ivec3(ivec2(at), int(layer)), 0)",
                    .sampled = "textureLod(map, vec3(uv, layer), 0.0)",
                    .gather_red = "textureGather(map, vec3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer), 0)",
                    .gather_green = "textureGather(map, vec3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer), 1)"};
        case texture::cube:
            return {.parameters = "UMBRAGE_HIGHP samplerCube map, UMBRAGE_HIGHP float face",
                    .arguments = "map, face",
                    .texel = R"GLSL(#if __VERSION__ >= 130
    return textureLod(map, umbrage_cube_direction(face, (at + 0.5) / UMBRAGE_TEXTURE_SIZE), 0.0);
#else
    return textureCube(map, umbrage_cube_direction(face, (at + 0.5) / UMBRAGE_TEXTURE_SIZE));
#endif
)GLSL",
                    .needs = list<&cube_direction>};
        case texture::cube_faces:
            return {.parameters = "UMBRAGE_HIGHP samplerCube map",
                    .arguments = "map",
                    .texel = R"GLSL(#if __VERSION__ >= 130
    return textureLod(map, umbrage_cube_atlas_direction(at, size.y * 0.5), 0.0);
#else
    return textureCube(map, umbrage_cube_atlas_direction(at, size.y * 0.5));
#endif
)GLSL",
                    .needs = list<&cube_atlas_direction>};
        case texture::integer:
            return {.parameters = "UMBRAGE_HIGHP usampler2D map",
                    .arguments = "map",
                    .texel = "vec4(texelFetch(map, ivec2(at), 0))"};
        case texture::shadow:
            return {.parameters = "UMBRAGE_HIGHP sampler2DShadow map",
                    .arguments = "map",
                    .lit = "textureLod(map, vec3((at + 0.5) / UMBRAGE_TEXTURE_SIZE, receiver), 0.0)",
                    .gather_lit = "textureGather(map, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, receiver)",
                    .lit_filtered = "textureLod(map, vec3(uv, receiver), 0.0)"};
        case texture::shadow_array:
            return {.parameters = "UMBRAGE_HIGHP sampler2DArrayShadow map, UMBRAGE_HIGHP float layer",
                    .arguments = "map, layer",
                    .lit =
                        "textureGrad(map, vec4((at + 0.5) / UMBRAGE_TEXTURE_SIZE, layer, receiver), vec2(0.0, 0.0), "
                        "vec2(0.0, 0.0))",
                    .gather_lit = "textureGather(map, vec3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer), receiver)",
                    .lit_filtered = "textureGrad(map, vec4(uv, layer, receiver), vec2(0.0, 0.0), vec2(0.0, 0.0))"};
    }
    return {};
}

[[nodiscard]] constexpr texture_words glsl_texture(texture kind) {
    texture_words words = glsl_reads(kind);
    words.size = "vec2(textureSize(map, 0))";
    return words;
}

inline constexpr language glsl_language{.prelude = prelude,
                                        .texture = glsl_texture,
                                        .translate = [](const snippet& s) { return s.source.str(); },
                                        .macros = true,
                                        .scaled_macro = scaled_macro};

[[nodiscard]] inline std::vector<bound> unbound(std::span<const snippet> snippets) {
    return {snippets.begin(), snippets.end()};
}

}  // namespace detail

/// True when the snippet bound to its map compiles in dialect `v`.
[[nodiscard]] inline bool supports(const bound& item, version v) {
    if (!supports(item.what, v)) return false;
    if (item.by_macros) return true;
    for (const snippet& need : item.map.needs)
        if (!supports(need, v)) return false;
    const bool gathers = v == version::v310_es || v == version::v320_es || v >= version::v430;
    if (item.map.gather) return gathers;
    const texture kind = item.map.texture;
    if (detail::has_region(item.map) && item.map.texture_size.empty() && v < version::v130) return false;
    return kind == texture::texture_2d || kind == texture::depth || kind == texture::atlas || detail::is_cube(kind) ||
           v >= version::v300_es;
}

/// The snippets and all they need, each once and guarded, without a `#version` line: text to paste into any shader.
/// @throws std::invalid_argument   a map that cannot have what is asked of it; two maps of one name
[[nodiscard]] inline std::string text(std::span<const bound> items) {
    return detail::compose(detail::glsl_language, items);
}
[[nodiscard]] inline std::string text(std::span<const snippet> snippets) { return text(detail::unbound(snippets)); }
[[nodiscard]] inline std::string text(std::initializer_list<bound> items) {
    return text(std::span(items.begin(), items.size()));
}

/// The beginning of a shader: `#version`, `preamble` (extensions, macros, precision), the snippets and all they need.
/// @throws std::invalid_argument   as text; when the dialect has not what a snippet or a map needs
[[nodiscard]] inline std::string source(version v, std::span<const bound> items, std::string_view preamble = {}) {
    for (const bound& item : items)
        if (!supports(item, v))
            umbrage::detail::fail("umbrage::glsl::source: GLSL " + std::string(directive(v)) + " is too old for " +
                                  std::string(item.what.name) + item.suffix);
    std::string out = "#version ";
    out += directive(v);
    out += '\n';
    out += preamble;
    if (!preamble.empty() && preamble.back() != '\n') out += '\n';
    return out + text(items);
}
[[nodiscard]] inline std::string source(version v, std::span<const snippet> snippets, std::string_view preamble = {}) {
    return source(v, detail::unbound(snippets), preamble);
}
[[nodiscard]] inline std::string source(version v, std::initializer_list<bound> items, std::string_view preamble = {}) {
    return source(v, std::span(items.begin(), items.size()), preamble);
}

}  // namespace umbrage::glsl

// ---- umbrage/shader/translate/tokens.hpp
// GLSL text in pieces, for what prints it in other languages. Nothing is lost: space and text of all, in a row, are the
// text that went in.
//

namespace umbrage::glsl::detail {

enum class piece { word, number, sign, comment, directive, end };

struct token {
    piece kind = piece::end;
    std::string_view space;  ///< white space before it
    std::string_view text;   ///< a comment's or a directive's is the rest of the line, without its end

    [[nodiscard]] bool operator==(std::string_view other) const { return text == other; }
};

[[nodiscard]] constexpr bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
[[nodiscard]] constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The longest sign that `text` begins with; empty where it begins with none.
[[nodiscard]] inline std::string_view sign_at(std::string_view text) {
    static constexpr std::array<std::string_view, 16> two{"++", "--", "<=", ">=", "==", "!=", "&&", "||",
                                                          "<<", ">>", "+=", "-=", "*=", "/=", "|=", "&="};
    for (std::string_view sign : two)
        if (text.starts_with(sign)) return text.substr(0, 2);
    static constexpr std::string_view one = "+-*/%<>=!&|^~?:;,.()[]{}";
    return one.find(text.front()) == one.npos ? std::string_view() : text.substr(0, 1);
}

/// Where a number that begins at text[i] ends.
[[nodiscard]] inline std::size_t end_of_number(std::string_view text, std::size_t i) {
    const bool hexadecimal = text.substr(i, 2) == "0x";
    for (char last = '0'; i < text.size(); last = text[i++]) {
        const bool of_exponent = !hexadecimal && (last == 'e' || last == 'E') && (text[i] == '+' || text[i] == '-');
        if (!is_letter(text[i]) && !is_digit(text[i]) && text[i] != '.' && !of_exponent) break;
    }
    return i;
}

/// The pieces of `text`, which must outlive them; the last is an end, whose space is what is left.
/// @throws std::invalid_argument   for a character that is none of GLSL's
[[nodiscard]] inline std::vector<token> tokens(std::string_view text) {
    std::vector<token> all;
    for (std::size_t i = 0;;) {
        const std::size_t from = i;
        while (i < text.size() && (text[i] == ' ' || text[i] == '\n')) ++i;
        const std::size_t at = i;
        token t{piece::end, text.substr(from, at - from), {}};
        if (at < text.size()) {
            const std::string_view rest = text.substr(at);
            if (rest.starts_with("//") || rest[0] == '#') {
                t.kind = rest[0] == '#' ? piece::directive : piece::comment;
                i = text.find('\n', at) == text.npos ? text.size() : text.find('\n', at);
            } else if (is_letter(rest[0])) {
                t.kind = piece::word;
                while (i < text.size() && (is_letter(text[i]) || is_digit(text[i]))) ++i;
            } else if (is_digit(rest[0]) || (rest[0] == '.' && rest.size() > 1 && is_digit(rest[1]))) {
                t.kind = piece::number;
                i = end_of_number(text, at);
            } else {
                t.kind = piece::sign;
                i += sign_at(rest).size();
                if (i == at)
                    umbrage::detail::fail("umbrage: not a character of GLSL: " + std::string(rest.substr(0, 1)));
            }
            t.text = text.substr(at, i - at);
        }
        all.push_back(t);
        if (t.kind == piece::end) return all;
    }
}

/// Of "#if __VERSION__ >= ..." what stands before its #else: what languages take that have all of the newest GLSL.
[[nodiscard]] inline std::vector<token> newest(std::vector<token> all) {
    enum { outside, before, behind } place = outside;  // of #else
    std::erase_if(all, [&](const token& t) {
        if (t.kind != piece::directive) return place == behind;
        if (t.text.starts_with("#if __VERSION__ >= ")) place = before;
        else if (place == outside) return false;
        else place = t == "#else" ? behind : outside;
        return true;
    });
    return all;
}

/// The bracket that closes the one at all[i].
/// @throws std::invalid_argument   where none does
[[nodiscard]] inline std::size_t closing(std::span<const token> all, std::size_t i) {
    std::size_t depth = 0;
    for (std::size_t k = i; k < all.size(); ++k) {
        if (all[k].kind != piece::sign) continue;
        const char c = all[k].text[0];
        if (c == '(' || c == '[' || c == '{') ++depth;
        if ((c == ')' || c == ']' || c == '}') && --depth == 0) return k;
    }
    umbrage::detail::fail("umbrage: a bracket is not closed");
}

}  // namespace umbrage::glsl::detail

// ---- umbrage/shader/translate/words.hpp
// The part of GLSL that snippets are written in, and its words in the other languages. A word that is not here is the
// text's own, or an error.
//

namespace umbrage::glsl::detail {

enum class word_kind { type, function, keyword };

struct word {
    word_kind kind;
    std::string_view glsl, hlsl, msl, wgsl;
};

// clang-format off
inline constexpr word vocabulary[]{
    {word_kind::type, "float", "float", "float", "f32"},
    {word_kind::type, "int", "int", "int", "i32"},
    {word_kind::type, "uint", "uint", "uint", "u32"},
    {word_kind::type, "bool", "bool", "bool", "bool"},
    {word_kind::type, "vec2", "float2", "float2", "vec2f"},
    {word_kind::type, "vec3", "float3", "float3", "vec3f"},
    {word_kind::type, "vec4", "float4", "float4", "vec4f"},
    {word_kind::type, "ivec2", "int2", "int2", "vec2i"},
    {word_kind::type, "ivec3", "int3", "int3", "vec3i"},
    {word_kind::type, "ivec4", "int4", "int4", "vec4i"},
    {word_kind::type, "uvec2", "uint2", "uint2", "vec2u"},
    {word_kind::type, "uvec3", "uint3", "uint3", "vec3u"},
    {word_kind::type, "uvec4", "uint4", "uint4", "vec4u"},
    {word_kind::type, "mat3", "float3x3", "metal::float3x3", "mat3x3f"},
    {word_kind::type, "mat4", "float4x4", "metal::float4x4", "mat4x4f"},

    {word_kind::function, "abs", "abs", "metal::abs", "abs"},
    {word_kind::function, "ceil", "ceil", "metal::ceil", "ceil"},
    {word_kind::function, "clamp", "clamp", "metal::clamp", "clamp"},
    {word_kind::function, "cos", "cos", "metal::cos", "cos"},
    {word_kind::function, "cross", "cross", "metal::cross", "cross"},
    {word_kind::function, "dot", "dot", "metal::dot", "dot"},
    {word_kind::function, "exp", "exp", "metal::exp", "exp"},
    {word_kind::function, "exp2", "exp2", "metal::exp2", "exp2"},
    {word_kind::function, "floatBitsToInt", "asint", "as_type<int>", "bitcast<i32>"},
    {word_kind::function, "floatBitsToUint", "asuint", "as_type<uint>", "bitcast<u32>"},
    {word_kind::function, "floor", "floor", "metal::floor", "floor"},
    {word_kind::function, "fract", "frac", "metal::fract", "fract"},
    {word_kind::function, "intBitsToFloat", "asfloat", "as_type<float>", "bitcast<f32>"},
    {word_kind::function, "inversesqrt", "rsqrt", "metal::rsqrt", "inverseSqrt"},
    {word_kind::function, "length", "length", "metal::length", "length"},
    {word_kind::function, "log", "log", "metal::log", "log"},
    {word_kind::function, "log2", "log2", "metal::log2", "log2"},
    {word_kind::function, "max", "max", "metal::max", "max"},
    {word_kind::function, "min", "min", "metal::min", "min"},
    {word_kind::function, "mix", "lerp", "metal::mix", "mix"},
    {word_kind::function, "normalize", "normalize", "metal::normalize", "normalize"},
    {word_kind::function, "pow", "pow", "metal::pow", "pow"},
    {word_kind::function, "sign", "sign", "metal::sign", "sign"},
    {word_kind::function, "sin", "sin", "metal::sin", "sin"},
    {word_kind::function, "sqrt", "sqrt", "metal::sqrt", "sqrt"},
    {word_kind::function, "step", "step", "metal::step", "step"},
    {word_kind::function, "tan", "tan", "metal::tan", "tan"},
    {word_kind::function, "uintBitsToFloat", "asfloat", "as_type<float>", "bitcast<f32>"},

    {word_kind::keyword, "break", "break", "break", "break"},
    {word_kind::keyword, "continue", "continue", "continue", "continue"},
    {word_kind::keyword, "else", "else", "else", "else"},
    {word_kind::keyword, "false", "false", "false", "false"},
    {word_kind::keyword, "for", "for", "for", "for"},
    {word_kind::keyword, "if", "if", "if", "if"},
    {word_kind::keyword, "return", "return", "return", "return"},
    {word_kind::keyword, "true", "true", "true", "true"},
};
// clang-format on

/// The row of a word of GLSL; nullptr: it is not one, or none that snippets may use.
[[nodiscard]] inline const word* find_word(std::string_view glsl) {
    for (const word& w : vocabulary)
        if (w.glsl == glsl) return &w;
    return nullptr;
}

[[nodiscard]] inline bool is_type(std::string_view glsl) {
    const word* w = find_word(glsl);
    return w && w->kind == word_kind::type;
}

/// Qualifiers of the snippets; a printer keeps or drops them.
[[nodiscard]] constexpr bool is_qualifier(std::string_view glsl) {
    return glsl == "UMBRAGE_HIGHP" || glsl == "UMBRAGE_PRECISE";
}

/// @throws std::invalid_argument, naming the word
[[noreturn]] inline void unknown(std::string_view language, std::string_view word) {
    umbrage::detail::fail("umbrage::" + std::string(language) + "::text: no word for " + std::string(word));
}

}  // namespace umbrage::glsl::detail

// ---- umbrage/shader/translate/word_by_word.hpp
// Languages so close to GLSL that each word has its like in its place: HLSL and MSL.
//

namespace umbrage::glsl::detail {

/// Where such a language differs.
struct near_language {
    std::string_view name;
    std::string_view word::*own;
    std::string_view precise;                    ///< for UMBRAGE_PRECISE; empty: nothing
    std::string_view function;                   ///< before each function's type,
    std::string_view condition;                  ///< and before that of one that tells true from false
    bool matrices_have_rows;                     ///< m[i] is a row of m, its constructor takes rows
    bool vectors_of_one_are_cast;                ///< vec4(x) is (float4)x
    std::span<const std::string_view> reserved;  ///< what GLSL may call a variable, and this language may not
};

/// Prints functions in a near language.
class word_by_word {
public:
    word_by_word(const near_language& language, std::string_view text)
        : language_(language), all_(newest(tokens(text))) {}

    [[nodiscard]] std::string print() {
        std::string out = print(0, all_.size() - 1);
        return out += all_.back().space;
    }

private:
    [[nodiscard]] std::string print(std::size_t from, std::size_t to) {
        std::string out;
        for (std::size_t i = from; i < to;) {
            const token& t = all_[i];
            if (t == "{") ++depth_;
            if (t == "}") --depth_;
            if (t == "*") refuse_matrix(i);
            out += t.space;
            switch (t.kind) {
                case piece::word: i = print_word(out, i); break;
                case piece::directive: unknown(language_.name, t.text);
                default: out += t.text, ++i;
            }
        }
        return out;
    }

    /// @return   where what follows begins
    std::size_t print_word(std::string& out, std::size_t i) {
        const std::string_view text = all_[i].text;
        if (is_qualifier(text)) {
            const std::string_view kept = text == "UMBRAGE_PRECISE" ? language_.precise : "";
            out += kept;
            if (kept.empty()) all_[i + 1].space = {};
            return i + 1;
        }
        const word* w = find_word(text);
        if (w && w->kind == word_kind::type) return print_type(out, i, w->*language_.own);
        if (w) {
            if (w->kind == word_kind::function && !(all_[i + 1] == "(")) unknown(language_.name, text);
            out += w->*language_.own;
            return i + 1;
        }
        if (i > 0 && all_[i - 1] == ".") {
            if (text.find_first_not_of("xyzw") != text.npos) unknown(language_.name, text);
            out += text;
            return i + 1;
        }
        if (all_[i + 1] == "(" && text.starts_with("umbrage_")) {
            out += text;
            return i + 1;
        }
        if (text == "UMBRAGE_MAP") return print_type(out, i, text);
        const std::string_view type = type_of(text);
        if (type.empty() && !is_of_a_map(text)) unknown(language_.name, text);
        const bool column = all_[i + 1] == "[" && is_matrix(type) && language_.matrices_have_rows;
        out += column ? "transpose(" + std::string(text) + ")" : std::string(text);
        return i + 1;
    }

    /// A function's, a variable's, or a constructor.
    std::size_t print_type(std::string& out, std::size_t i, std::string_view own) {
        if (all_[i + 1] == "(") return print_constructor(out, i, own);
        if (all_[i + 1].kind != piece::word) unknown(language_.name, all_[i + 1].text);
        const std::string_view name = all_[i + 1].text;
        const bool function = all_[i + 2] == "(";
        if (function && depth_ == 0) {
            variables_.clear();
            out += language_.function;
            if (all_[i] == "bool") out += language_.condition;
        } else {
            for (std::string_view reserved : language_.reserved)
                if (name == reserved) unknown(language_.name, name);
            variables_.push_back({name, all_[i].text});
        }
        out += own;
        out += all_[i + 1].space;
        out += name;
        return i + 2;
    }

    std::size_t print_constructor(std::string& out, std::size_t i, std::string_view own) {
        const std::string_view type = all_[i].text;
        const std::size_t end = closing(all_, i + 1);
        const std::string arguments = print(i + 2, end);
        const std::size_t count = arguments_in(i + 1, end);
        if (is_matrix(type) && count == 1) unknown(language_.name, std::string(type) + " of one");
        std::string made = std::string(own) + "(" + arguments + ")";
        if (is_matrix(type) && language_.matrices_have_rows) made = "transpose(" + made + ")";
        if (is_vector(type) && count == 1 && language_.vectors_of_one_are_cast) {
            made = "(" + std::string(own) + ")" + (is_operand(i + 2, end) ? arguments : "(" + arguments + ")");
            if (all_[end + 1] == "." || all_[end + 1] == "[") made = "(" + made + ")";
        }
        out += made;
        return end + 1;
    }

    [[nodiscard]] std::size_t arguments_in(std::size_t open, std::size_t end) const {
        std::size_t count = 1;
        for (std::size_t i = open + 1; i < end; ++i) {
            if (all_[i] == "(" || all_[i] == "[") i = closing(all_, i);
            if (all_[i] == ",") ++count;
        }
        return count;
    }

    /// A name, a number, a call or a component of those: nothing that a cast would have to be kept from.
    [[nodiscard]] bool is_operand(std::size_t from, std::size_t to) const {
        for (std::size_t i = from; i < to; ++i) {
            if (all_[i] == "(" || all_[i] == "[") i = closing(all_, i);
            else if (all_[i].kind == piece::sign && !(all_[i] == ".")) return false;
        }
        return true;
    }

    /// What a matrix times something is hangs on its rows and columns; snippets write the columns out.
    void refuse_matrix(std::size_t i) const {
        for (const token* t : {&all_[i > 0 ? i - 1 : 0], &all_[i + 1]})
            if (is_matrix(type_of(t->text)) && !(all_[i + 2] == "["))
                unknown(language_.name, "a matrix times something");
    }

    [[nodiscard]] std::string_view type_of(std::string_view name) const {
        for (const variable& v : variables_)
            if (v.name == name) return v.type;
        return {};
    }
    /// A word that a map fills in.
    [[nodiscard]] static bool is_of_a_map(std::string_view word) {
        static constexpr std::string_view all[]{"UMBRAGE_DEPTH",      "UMBRAGE_GATHER_GREEN", "UMBRAGE_GATHER_LIT",
                                                "UMBRAGE_GATHER_RED", "UMBRAGE_LIT_TEXEL",    "UMBRAGE_LIT_FILTERED",
                                                "UMBRAGE_ORIGIN",     "UMBRAGE_SAMPLED",      "UMBRAGE_TEXEL",
                                                "UMBRAGE_UV"};
        for (std::string_view w : all)
            if (word == w) return true;
        return false;
    }
    [[nodiscard]] static bool is_matrix(std::string_view type) { return type.starts_with("mat"); }
    [[nodiscard]] static bool is_vector(std::string_view type) {
        return type.find("vec") != type.npos;  // ivec2 too
    }

    struct variable {
        std::string_view name, type;  ///< in GLSL
    };

    const near_language& language_;
    std::vector<token> all_;
    std::vector<variable> variables_;
    std::size_t depth_ = 0;
};

}  // namespace umbrage::glsl::detail

// ---- umbrage/shader/hlsl.hpp
// Snippets in HLSL, printed from their GLSL.
//
//     std::string shader = umbrage::hlsl::text({umbrage::glsl::pcf_2x2}) + my_main;
//     // float umbrage_pcf_2x2(Texture2D<float4> map, float2 size, float2 coord, float receiver)
//

namespace umbrage::hlsl {

namespace detail {

inline constexpr std::array<std::string_view, 8> reserved{"line",  "linear", "matrix",   "pass",
                                                          "point", "sample", "triangle", "vector"};

inline constexpr glsl::detail::near_language near{.name = "hlsl",
                                                  .own = &glsl::detail::word::hlsl,
                                                  .precise = "precise",
                                                  .function = "",
                                                  .condition = "precise ",  // FXC makes !(a > b) of a <= b elsewhere
                                                  .matrices_have_rows = true,
                                                  .vectors_of_one_are_cast = true,
                                                  .reserved = reserved};

[[nodiscard]] constexpr glsl::detail::texture_words reads(glsl::texture kind) {
    using enum glsl::texture;
    switch (kind) {
        case texture_2d:
            return {.parameters = "Texture2D<float4> map",
                    .arguments = "map",
                    .texel = "map.Load(int3(int2(at), 0))",
                    .sampled = "map.SampleLevel(map_sampler, uv, 0.0)",
                    .gather_red = "map.GatherRed(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)",
                    .gather_green = "map.GatherGreen(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)"};
        case depth:
            return {.parameters = "Texture2D<float> map",
                    .arguments = "map",
                    .texel = "(float4)map.Load(int3(int2(at), 0))",
                    .sampled = "(float4)map.SampleLevel(map_sampler, uv, 0.0)",
                    .gather_red = "map.Gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)"};
        case atlas:
            return {.parameters = "Texture2D<float4> map, float2 origin",
                    .arguments = "map, origin",
                    .texel = "map.Load(int3(int2(at), 0))",
                    .sampled = "map.SampleLevel(map_sampler, uv, 0.0)",
                    .gather_red = "map.GatherRed(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)",
                    .gather_green = "map.GatherGreen(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)"};
        case array:
            return {.parameters = "Texture2DArray<float4> map, float layer",
                    .arguments = "map, layer",
                    .texel = "map.Load(int4(int2(at), int(layer), 0))",
                    .sampled = "map.SampleLevel(map_sampler, float3(uv, layer), 0.0)",
                    .gather_red = "map.GatherRed(map_sampler, float3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer))",
                    .gather_green = "map.GatherGreen(map_sampler, float3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer))"};
        case depth_array:
            return {.parameters = "Texture2DArray<float> map, float layer",
                    .arguments = "map, layer",
                    .texel = "(float4)map.Load(int4(int2(at), int(layer), 0))",
                    .sampled = "(float4)map.SampleLevel(map_sampler, float3(uv, layer), 0.0)",
                    .gather_red = "map.Gather(map_sampler, float3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer))"};
        case cube:
            return {.parameters = "TextureCube<float4> map, SamplerState map_sampler, float face",
                    .arguments = "map, map_sampler, face",
                    .texel =
                        "map.SampleLevel(map_sampler, umbrage_cube_direction(face, (at + 0.5) / "
                        "UMBRAGE_TEXTURE_SIZE), 0.0)",
                    .needs = glsl::list<&glsl::cube_direction>};
        case cube_faces:
            return {.parameters = "TextureCube<float4> map, SamplerState map_sampler",
                    .arguments = "map, map_sampler",
                    .texel = "map.SampleLevel(map_sampler, umbrage_cube_atlas_direction(at, size.y * 0.5), 0.0)",
                    .needs = glsl::list<&glsl::cube_atlas_direction>};
        case integer:
            return {.parameters = "Texture2D<uint4> map",
                    .arguments = "map",
                    .texel = "float4(map.Load(int3(int2(at), 0)))"};
        case shadow:
            return {.parameters = "Texture2D<float> map, SamplerComparisonState map_sampler",
                    .arguments = "map, map_sampler",
                    .lit = "map.SampleCmpLevelZero(map_sampler, (at + 0.5) / UMBRAGE_TEXTURE_SIZE, receiver)",
                    .gather_lit = "map.GatherCmp(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, receiver)",
                    .lit_filtered = "map.SampleCmpLevelZero(map_sampler, uv, receiver)"};
        case shadow_array:
            return {
                .parameters = "Texture2DArray<float> map, SamplerComparisonState map_sampler, float layer",
                .arguments = "map, map_sampler, layer",
                .lit =
                    "map.SampleCmpLevelZero(map_sampler, float3((at + 0.5) / UMBRAGE_TEXTURE_SIZE, layer), "
                    "receiver)",
                .gather_lit = "map.GatherCmp(map_sampler, float3((at + 1.0) / UMBRAGE_TEXTURE_SIZE, layer), receiver)",
                .lit_filtered = "map.SampleCmpLevelZero(map_sampler, float3(uv, layer), receiver)"};
    }
    return {};
}

[[nodiscard]] constexpr glsl::detail::texture_words texture(glsl::texture kind) {
    glsl::detail::texture_words words = reads(kind);
    if (words.gather_red.empty()) return words;
    words.sampler = ", SamplerState map_sampler";
    words.sampler_argument = ", map_sampler";
    return words;
}

inline constexpr glsl::detail::language language{
    .prelude = "", .texture = texture, .translate = [](const glsl::snippet& s) {
        return glsl::detail::laid_out(glsl::detail::word_by_word(near, s.source.str()).print());
    }};

}  // namespace detail

/// The snippets, or what bind() gives for a map, and all they need, each once and guarded: text to paste into any
/// shader.
///
/// Nothing in HLSL says how large a texture is within an expression: a map that is a region of one, and is gathered
/// from or compared by its sampler, needs the binding's texture_size.
///
/// @throws std::invalid_argument   for what HLSL has no word for
[[nodiscard]] inline std::string text(std::span<const glsl::bound> items) {
    return glsl::detail::compose(detail::language, items);
}

[[nodiscard]] inline std::string text(std::initializer_list<glsl::bound> items) {
    return hlsl::text(std::span(items.begin(), items.size()));
}

}  // namespace umbrage::hlsl

// ---- umbrage/shader/msl.hpp
// Snippets in the Metal Shading Language, printed from their GLSL.
//
//     std::string shader = umbrage::msl::text({umbrage::glsl::pcf_2x2}) + my_main;
//     // inline float umbrage_pcf_2x2(metal::texture2d<float> map, float2 size, float2 coord, float receiver)
//

namespace umbrage::msl {

/// What every text begins with. Metal computes with fast mathematics unless it is told not to; from here to the end of
/// the file it is told.
inline constexpr std::string_view prelude =
    "\n#include <metal_stdlib>\n"  // no line of its own, which the single header would take for C++'s
    "#pragma METAL fp math_mode(safe)\n"
    "#pragma METAL fp contract(off)\n";

namespace detail {

inline constexpr std::array<std::string_view, 16> reserved{
    "as_type", "char",   "constant", "device", "fragment", "half",  "kernel", "long",
    "metal",   "object", "sampler",  "short",  "thread",   "uchar", "ushort", "vertex"};

inline constexpr glsl::detail::near_language near{.name = "msl",
                                                  .own = &glsl::detail::word::msl,
                                                  .precise = "",
                                                  .function = "inline ",
                                                  .condition = "",
                                                  .matrices_have_rows = false,
                                                  .vectors_of_one_are_cast = false,
                                                  .reserved = reserved};

[[nodiscard]] constexpr glsl::detail::texture_words reads(glsl::texture kind) {
    using enum glsl::texture;
    switch (kind) {
        case texture_2d:
            return {.parameters = "metal::texture2d<float> map",
                    .arguments = "map",
                    .texel = "map.read(uint2(at))",
                    .sampled = "map.sample(map_sampler, uv, metal::level(0.0))",
                    .gather_red = "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)",
                    .gather_green =
                        "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, int2(0), metal::component::y)"};
        case depth:
            return {.parameters = "metal::depth2d<float> map",
                    .arguments = "map",
                    .texel = "float4(map.read(uint2(at)))",
                    .sampled = "float4(map.sample(map_sampler, uv, metal::level(0.0)))",
                    .gather_red = "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)"};
        case atlas:
            return {.parameters = "metal::texture2d<float> map, float2 origin",
                    .arguments = "map, origin",
                    .texel = "map.read(uint2(at))",
                    .sampled = "map.sample(map_sampler, uv, metal::level(0.0))",
                    .gather_red = "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)",
                    .gather_green =
                        "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, int2(0), metal::component::y)"};
        case array:
            return {.parameters = "metal::texture2d_array<float> map, float layer",
                    .arguments = "map, layer",
                    .texel = "map.read(uint2(at), uint(layer))",
                    .sampled = "map.sample(map_sampler, uv, uint(layer), metal::level(0.0))",
                    .gather_red = "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, uint(layer))",
                    .gather_green =
                        "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, uint(layer), int2(0), "
                        "metal::component::y)"};
        case depth_array:
            return {.parameters = "metal::depth2d_array<float> map, float layer",
                    .arguments = "map, layer",
                    .texel = "float4(map.read(uint2(at), uint(layer)))",
                    .sampled = "float4(map.sample(map_sampler, uv, uint(layer), metal::level(0.0)))",
                    .gather_red = "map.gather(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, uint(layer))"};
        case cube:
            return {.parameters = "metal::texturecube<float> map, float face",
                    .arguments = "map, face",
                    .texel = "map.read(uint2(at), uint(face))"};
        case cube_faces:
            return {.parameters = "metal::texturecube<float> map",
                    .arguments = "map",
                    .texel =
                        "map.read(uint2(umbrage_cube_atlas_texel(at, size.y * 0.5).x, "
                        "umbrage_cube_atlas_texel(at, size.y * 0.5).y), "
                        "uint(umbrage_cube_atlas_texel(at, size.y * 0.5).z))",
                    .needs = glsl::list<&glsl::cube_atlas_texel>};
        case integer:
            return {
                .parameters = "metal::texture2d<uint> map", .arguments = "map", .texel = "float4(map.read(uint2(at)))"};
        case shadow:
            return {
                .parameters = "metal::depth2d<float> map, metal::sampler map_sampler",
                .arguments = "map, map_sampler",
                .lit =
                    "map.sample_compare(map_sampler, (at + 0.5) / UMBRAGE_TEXTURE_SIZE, receiver, metal::level(0.0))",
                .gather_lit = "map.gather_compare(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, receiver)",
                .lit_filtered = "map.sample_compare(map_sampler, uv, receiver, metal::level(0.0))"};
        case shadow_array:
            return {.parameters = "metal::depth2d_array<float> map, metal::sampler map_sampler, float layer",
                    .arguments = "map, map_sampler, layer",
                    .lit =
                        "map.sample_compare(map_sampler, (at + 0.5) / UMBRAGE_TEXTURE_SIZE, uint(layer), receiver, "
                        "metal::level(0.0))",
                    .gather_lit =
                        "map.gather_compare(map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, uint(layer), receiver)",
                    .lit_filtered = "map.sample_compare(map_sampler, uv, uint(layer), receiver, metal::level(0.0))"};
    }
    return {};
}

[[nodiscard]] constexpr glsl::detail::texture_words texture(glsl::texture kind) {
    glsl::detail::texture_words words = reads(kind);
    words.size = "float2(map.get_width(), map.get_height())";
    if (words.gather_red.empty()) return words;
    words.sampler = ", metal::sampler map_sampler";
    words.sampler_argument = ", map_sampler";
    return words;
}

inline constexpr glsl::detail::language language{
    .prelude = prelude, .texture = texture, .translate = [](const glsl::snippet& s) {
        return glsl::detail::laid_out(glsl::detail::word_by_word(near, s.source.str()).print());
    }};

}  // namespace detail

/// The snippets, or what bind() gives for a map, and all they need, each once and guarded: text to paste into any
/// shader.
/// @throws std::invalid_argument   for what Metal has no word for
[[nodiscard]] inline std::string text(std::span<const glsl::bound> items) {
    return glsl::detail::compose(detail::language, items);
}

[[nodiscard]] inline std::string text(std::initializer_list<glsl::bound> items) {
    return msl::text(std::span(items.begin(), items.size()));
}

}  // namespace umbrage::msl

// ---- umbrage/shader/registry.hpp
// Every snippet there is, in the order of the data's way: what tests, tables and tools walk through.
//
//     for (const umbrage::glsl::snippet* s : umbrage::glsl::registry()) std::puts(umbrage::glsl::text({*s}).c_str());
//

namespace umbrage::glsl {

namespace detail {

/// Snippets in order, each once, what it needs before it.
class collection {
public:
    collection& add(const snippet* s) {
        // By name: a program and a library that it loads may each have a copy.
        if (!names_.insert(s->name).second) return *this;
        for (const snippet* need : s->needs) add(need);
        members_.push_back(s);
        return *this;
    }
    template <class... Lists>
    collection& add_all(const Lists&... lists) {
        const auto each = [&](const auto& some) {
            for (const snippet* s : some) add(s);
        };
        (each(lists), ...);
        return *this;
    }
    template <class... Encodings>
    collection& add_writers(const list_of<Encodings...>*) {
        return add_all(std::array{Encodings::writer...});
    }
    template <class... Encodings>
    collection& add_readers(const list_of<Encodings...>*) {
        return add_all(std::array{(Encodings::writes == written::depth ? Encodings::writer : Encodings::reader)...});
    }
    template <class... Filters>
    collection& add_filters(const list_of<Filters...>*) {
        return (add_filter<Filters>(), ..., *this);
    }

    [[nodiscard]] const std::vector<const snippet*>& members() const { return members_; }

private:
    /// One for each of the filter's values.
    template <class Filter>
    void add_filter() {
        if constexpr (requires { Filter::values; }) {
            for (const Filter& value : Filter::values) add(value.snippet);
        } else add(Filter::snippet);
    }

    std::set<std::string_view> names_;
    std::vector<const snippet*> members_;
};

}  // namespace detail

/// All of them. Made when it is first asked for: a program that does not ask carries no snippet for it.
[[nodiscard]] inline std::span<const snippet* const> registry() {
    static const std::vector<const snippet*> all = [] {
        const encodings* const every_encoding = nullptr;
        const umbrage::filters::all* const every_filter = nullptr;
        return detail::collection()
            // light
            .add_all(texture_matrix_snippets, select_snippets, blend_snippets, cube_map_snippets, cube_atlas_snippets,
                     dual_paraboloid_snippets, tetrahedron_snippets, pancake_snippets, page_table_snippets)
            // depth
            .add_all(kinds_snippets, scalar_snippets, floor_divide_snippets, unorm_snippets)
            .add_writers(every_encoding)
            .add_all(rg_table_snippets<9, 10, 11, 12, 13, 14, 15, 16>)
            .add_readers(every_encoding)
            .add_all(rg_level_snippets<9, 10, 11, 12, 13, 14, 15, 16>, ps14_snippets)
            // filter
            .add_all(clip_space_snippets, image_snippets, texel_space_snippets, compare_snippets, window_snippets,
                     disc_snippets)
            .add_filters(every_filter)
            .add_all(pcf_2x2_cube_snippets, four_tap_hardware_snippets, pcf_2x2_hardware_snippets,
                     window_hardware_snippets, disc_hardware_snippets, bounds_lit_snippets, penumbra_snippets,
                     pcss_snippets, pcss_hardware_snippets, dpcf_snippets, summed_variance_snippets,
                     summed_moments_snippets)
            .add_all(exp2_snippets, chebyshev_snippets, vsm_snippets, esm_snippets, evsm_snippets, msm_snippets,
                     hausdorff_snippets, look_up_snippets, decode_hardware_snippets, reduce_snippets)
            // bias, shade, view
            .add_all(light_units_snippets, constant_snippets, slope_snippets, normal_offset_snippets, kernel_snippets,
                     receiver_plane_snippets, acne_free_snippets)
            .add_all(lighting_snippets, false_colour_snippets, overlay_texel_snippets)
            .members();
    }();
    return all;
}

}  // namespace umbrage::glsl

// ---- umbrage/shader/translate/types.hpp
// Types of GLSL expressions, by GLSL's names: "vec3", "uint", "mat4"; "float[4]" is an array.
//

namespace umbrage::glsl::detail {

/// Components of a vector, or of a matrix's column; 1 for scalars.
[[nodiscard]] constexpr int width_of(std::string_view type) {
    const char last = type.back();
    return last >= '2' && last <= '4' ? last - '0' : 1;
}

[[nodiscard]] constexpr bool is_matrix(std::string_view type) { return type.starts_with("mat"); }

[[nodiscard]] constexpr std::string_view component_of(std::string_view type) {
    if (width_of(type) == 1) return type;
    return type[0] == 'i' ? "int" : type[0] == 'u' ? "uint" : "float";
}

[[nodiscard]] inline std::string vector_of(std::string_view component, int width) {
    if (width == 1) return std::string(component);
    const std::string prefix = component == "int" ? "i" : component == "uint" ? "u" : "";
    return prefix + "vec" + std::to_string(width);
}

/// Type of `all[i]`: an array's element, a matrix's column, a vector's component.
[[nodiscard]] inline std::string element_of(std::string_view type) {
    if (type.ends_with(']')) return std::string(type.substr(0, type.find('[')));
    if (is_matrix(type)) return vector_of("float", width_of(type));
    return std::string(component_of(type));
}

/// Type of `a op b` with an arithmetic or bitwise sign; empty where GLSL has none, or only by a conversion unsaid.
[[nodiscard]] inline std::string type_of_product(std::string_view a, std::string_view op, std::string_view b) {
    if (op == "<<" || op == ">>") return std::string(a);
    if (op == "*" && is_matrix(a) && !is_matrix(b) && width_of(a) == width_of(b)) return std::string(b);
    if (op == "*" && is_matrix(b) && !is_matrix(a) && width_of(a) == width_of(b)) return std::string(a);
    if (a == b) return std::string(a);
    if (b == element_of(a) && !is_matrix(a)) return std::string(a);
    if (a == element_of(b) && !is_matrix(b)) return std::string(b);
    if (op == "*" && is_matrix(a) && b == "float") return std::string(a);
    if (op == "*" && is_matrix(b) && a == "float") return std::string(b);
    return {};
}

[[nodiscard]] inline std::string type_of_number(std::string_view digits) {
    const bool hexadecimal = digits.starts_with("0x");
    if (digits.ends_with('u')) return "uint";
    return !hexadecimal && digits.find_first_of(".eEf") != digits.npos ? "float" : "int";
}

}  // namespace umbrage::glsl::detail

// ---- umbrage/shader/translate/wgsl_expression.hpp
// Expressions of GLSL in WGSL, where all types agree: what is converted, and which of a function's overloads is meant,
// is written out.
//

namespace umbrage::wgsl::detail {

using glsl::detail::piece;
using glsl::detail::token;

/// A function of the text: one overload.
struct signature {
    std::string name;  ///< in WGSL, which has no overloads
    std::vector<std::string> parameters;
    std::string gives;
};
using signatures = std::multimap<std::string, signature, std::less<>>;

struct value {
    std::string text, type;
    int level;             ///< of its outermost operator; the highest for what needs no brackets
    bool literal = false;  ///< a number, which takes its type from where it stands
    bool select = false;
};

[[noreturn]] inline void reject(const std::string& what) { umbrage::detail::fail("umbrage::wgsl::text: " + what); }

/// A type's name in WGSL.
[[nodiscard]] inline std::string name_of(std::string_view type) {
    if (!glsl::detail::is_type(type)) glsl::detail::unknown("wgsl", type);
    return std::string(glsl::detail::find_word(type)->wgsl);
}

/// What a map fills in, and its type in GLSL. Printed as it is.
inline constexpr std::pair<std::string_view, std::string_view> words_of_maps[]{
    {"UMBRAGE_TEXEL", "vec4"},      {"UMBRAGE_LIT_TEXEL", "float"},   {"UMBRAGE_LIT_FILTERED", "float"},
    {"UMBRAGE_GATHER_RED", "vec4"}, {"UMBRAGE_GATHER_GREEN", "vec4"}, {"UMBRAGE_GATHER_LIT", "vec4"},
    {"UMBRAGE_ORIGIN", "vec2"},     {"UMBRAGE_DEPTH", "float"},       {"UMBRAGE_UV", "vec2"},
    {"UMBRAGE_SAMPLED", "vec4"}};

[[nodiscard]] inline bool is_map(std::string_view type) { return type == "UMBRAGE_MAP"; }

/// Reads a text from the beginning on and gives its expressions in WGSL.
class expressions {
public:
    expressions(std::string_view text, const signatures& functions)
        : all_(glsl::detail::newest(glsl::detail::tokens(text))), functions_(functions) {}

    std::size_t at = 0;                                     ///< the next token
    std::map<std::string, std::string, std::less<>> types;  ///< of variables in scope

    /// The last, an end, is never taken.
    [[nodiscard]] const token& next() const { return all_[at]; }
    const token& take() { return all_[at + 1 < all_.size() ? at++ : at]; }

    /// The sign `text` with its space.
    std::string expect(std::string_view text) {
        if (!(next() == text)) reject("expected " + std::string(text) + " before " + std::string(next().text));
        const token& t = take();
        return std::string(t.space) + std::string(text);
    }

    /// From the next token on; the space before it is left out.
    value expression() {
        value condition = binary(1);
        if (!(next() == "?")) return condition;
        take();
        const value yes = expression();
        expect(":");
        const value no = expression();
        if (condition.type != "bool" || yes.type != no.type)
            reject(condition.type + " ? " + yes.type + " : " + no.type);
        return {"select(" + argument(no) + ", " + argument(yes) + ", " + condition.text + ")", yes.type, primary_level,
                false, true};
    }

    /// The same with the space before it.
    value spaced_expression() {
        const std::string space(next().space);
        value v = expression();
        v.text = space + v.text;
        return v;
    }

protected:
    const std::vector<token> all_;

private:
    const signatures& functions_;

    static constexpr int equality_level = 6, relation_level = 7, shift_level = 8, unary_level = 11, primary_level = 12;

    static int level_of(std::string_view sign) {
        static constexpr std::pair<std::string_view, int> levels[]{
            {"||", 1}, {"&&", 2}, {"|", 3},  {"^", 4},  {"&", 5}, {"==", 6}, {"!=", 6}, {"<", 7},  {">", 7},
            {"<=", 7}, {">=", 7}, {"<<", 8}, {">>", 8}, {"+", 9}, {"-", 9},  {"*", 10}, {"/", 10}, {"%", 10}};
        for (const auto& [text, level] : levels)
            if (text == sign) return level;
        return 0;
    }

    /// WGSL's operators that are of no higher level than GLSL's take no unbracketed operators at all, or not these.
    static std::string operand(const value& v, int level, bool chained) {
        const bool bitwise = level >= 3 && level <= 5, comparing = level == equality_level || level == relation_level;
        const bool bracket = (bitwise && v.level < unary_level && !(chained && v.level == level)) ||
                             (level == shift_level && v.level < unary_level) || (comparing && v.level < shift_level) ||
                             (level == 1 && v.level == 2);
        return bracket ? "(" + v.text + ")" : v.text;
    }

    /// f(a < b, c > d) would be a template in WGSL.
    static std::string argument(const value& v) { return v.level == relation_level ? "(" + v.text + ")" : v.text; }

    value binary(int lowest) {
        value left = unary();
        for (int level = level_of(next().text); next().kind == piece::sign && level >= lowest;
             level = level_of(next().text)) {
            const token& sign = take();
            const std::string space(next().space);
            value right = binary(level + 1);
            const bool shift = level == shift_level, logic = level <= 2;
            if (shift && right.type == "int" && !right.literal)
                right = {"u32(" + right.text + ")", "uint", primary_level};
            const bool compared = level == equality_level || level == relation_level;
            std::string type =
                compared || logic ? "bool" : glsl::detail::type_of_product(left.type, sign.text, right.type);
            const bool agree = logic ? left.type == "bool" && right.type == "bool"
                                     : !compared || (left.type == right.type && glsl::detail::width_of(left.type) == 1);
            if (type.empty() || !agree)
                reject(left.type + " " + std::string(sign.text) + " " + right.type + " in " + left.text);
            left = {operand(left, level, true) + std::string(sign.space) + std::string(sign.text) + space +
                        operand(right, level, false),
                    std::move(type), level};
        }
        return left;
    }

    value unary() {
        if (next() == "-" || next() == "!" || next() == "~" || next() == "+") {
            const token& sign = take();
            const std::string space(next().space);
            value v = unary();
            v.text = (sign == "+" ? "" : std::string(sign.text)) + space + v.text;
            v.level = unary_level;
            return v;
        }
        value v = primary();
        for (;;) {
            if (next() == ".") {
                const std::string dot = expect(".");
                const std::string_view fields = take().text;
                if (fields.size() > 4 || (fields.find_first_not_of("xyzw") != fields.npos &&
                                          fields.find_first_not_of("rgba") != fields.npos))
                    reject("no component " + std::string(fields) + " of " + v.text);
                v = {v.text + dot + std::string(fields),
                     glsl::detail::vector_of(glsl::detail::component_of(v.type), static_cast<int>(fields.size())),
                     primary_level};
            } else if (next() == "[") {
                const std::string open = expect("["), index = spaced_expression().text;
                v = {v.text + open + index + expect("]"), glsl::detail::element_of(v.type), primary_level};
            } else {
                return v;
            }
        }
    }

    value primary() {
        const token& t = take();
        const std::string text(t.text);
        if (t.kind == piece::number) return {text, glsl::detail::type_of_number(text), primary_level, true};
        if (t == "(") {
            value inner = spaced_expression();
            const std::string close = expect(")");
            if (inner.select) return inner;
            return {"(" + inner.text + close, inner.type, primary_level, inner.literal};
        }
        if (t.kind != piece::word) reject("unexpected " + text);
        if (t == "true" || t == "false") return {text, "bool", primary_level};
        if (next() == "(") return call(text);
        if (const auto variable = types.find(text); variable != types.end())
            return {text, variable->second, primary_level};
        for (const auto& [word, type] : words_of_maps)
            if (word == text) return {text, std::string(type), primary_level};
        glsl::detail::unknown("wgsl", text);
    }

    value call(const std::string& function) {
        expect("(");
        std::vector<value> arguments;
        while (!(next() == ")")) {
            if (!arguments.empty()) expect(",");
            arguments.push_back(spaced_expression());
        }
        const std::string close = expect(")");
        if (glsl::detail::is_type(function)) return constructed(function, arguments, close);
        const auto [first, last] = functions_.equal_range(function);
        if (first == last) return built_in(function, arguments, close);
        for (auto f = first; f != last; ++f) {
            const auto same = [](const std::string& type, const value& v) { return type == v.type; };
            const auto& wanted = f->second.parameters;
            if (std::equal(wanted.begin(), wanted.end(), arguments.begin(), arguments.end(), same))
                return {f->second.name + listed(arguments) + close, f->second.gives, primary_level};
        }
        reject("no overload of " + function + " takes what it is given");
    }

    static std::string listed(const std::vector<value>& arguments) {
        std::string list = "(";
        for (const value& v : arguments) {
            const std::size_t space = v.text.find_first_not_of(" \n");
            const bool last = &v == &arguments.back();
            const value bare{v.text.substr(space), v.type, v.level};
            list += v.text.substr(0, space) + (last ? bare.text : argument(bare) + ",");
        }
        return list;
    }

    /// Each in the function's component type.
    static value constructed(const std::string& type, std::vector<value> arguments, const std::string& close) {
        const std::string component(glsl::detail::component_of(glsl::detail::is_matrix(type) ? "float" : type));
        const bool scalar = glsl::detail::width_of(type) == 1;
        const bool whole =
            arguments.size() == 1 && glsl::detail::width_of(arguments[0].type) == glsl::detail::width_of(type);
        for (value& v : arguments) {
            if (scalar || whole || v.literal || glsl::detail::component_of(v.type) == component) continue;
            const std::size_t space = v.text.find_first_not_of(" \n");
            v.text.insert(space, name_of(glsl::detail::vector_of(component, glsl::detail::width_of(v.type))) + "(");
            v.text += ")";
            v.level = primary_level;
        }
        return {name_of(type) + listed(arguments) + close, type, primary_level};
    }

    static value built_in(const std::string& function, std::vector<value> arguments, const std::string& close) {
        const glsl::detail::word* w = glsl::detail::find_word(function);
        if (!w || w->kind != glsl::detail::word_kind::function || arguments.empty())
            glsl::detail::unknown("wgsl", function);
        std::string type = arguments[0].type;
        for (const value& v : arguments)
            if (glsl::detail::width_of(v.type) > glsl::detail::width_of(type)) type = v.type;
        for (value& v : arguments) {  // all are of one type in WGSL
            if (v.type == type) continue;
            if (v.type != glsl::detail::component_of(type)) reject(function + " of " + type + " and " + v.type);
            const std::size_t space = v.text.find_first_not_of(" \n");
            v.text.insert(space, name_of(type) + "(");
            v.text += ")";
        }
        if (w->wgsl.starts_with("bitcast")) {
            if (glsl::detail::width_of(type) > 1) reject(function + " of " + type);
            type = w->wgsl == "bitcast<f32>" ? "float" : w->wgsl == "bitcast<u32>" ? "uint" : "int";
        }
        if (function == "dot" || function == "length") type = "float";
        return {std::string(w->wgsl) + listed(arguments) + close, type, primary_level};
    }
};

}  // namespace umbrage::wgsl::detail

// ---- umbrage/shader/translate/wgsl_function.hpp
// Functions of GLSL in WGSL, with their names, comments and layout.
//

namespace umbrage::wgsl::detail {

/// Prints a snippet's text, GLSL whose only lines of the preprocessor are about its version.
class printer : expressions {
    struct parameter {
        std::string type, name;
    };
    struct head {
        std::string_view space;
        std::string gives, name;
        std::vector<parameter> parameters;
    };

public:
    /// @param functions   those that the text may call; its own are added
    printer(std::string_view text, signatures& functions) : expressions(text, functions), functions_(functions) {}

    /// Adds the signatures of the text's functions. Where several share a name, their first type is a part of it.
    void declare() {
        std::vector<head> all;
        while (next().kind != piece::end) {
            if (next().kind == piece::comment || next().kind == piece::directive) {
                take();
                continue;
            }
            all.push_back(read_head());
            at = glsl::detail::closing(all_, at) + 1;
        }
        for (const head& h : all) {
            const bool alone =
                std::count_if(all.begin(), all.end(), [&](const head& other) { return other.name == h.name; }) == 1;
            const bool plain = alone || h.parameters.empty() || h.parameters[0].type == "float";
            signature s{h.name + (plain ? "" : "_" + name_of(h.parameters[0].type)), {}, h.gives};
            for (const parameter& p : h.parameters) s.parameters.push_back(p.type);
            functions_.emplace(h.name, std::move(s));
        }
    }

    /// @throws std::invalid_argument   for what is not in the part of GLSL that snippets are written in
    [[nodiscard]] std::string print() {
        at = 0;
        while (next().kind != piece::end) {
            if (next().kind == piece::comment) comment();
            else function();
        }
        return out_ + std::string(next().space);
    }

private:
    void skip_qualifiers() {
        while (glsl::detail::is_qualifier(next().text)) take();
    }

    std::string read_type() {
        skip_qualifiers();
        const std::string type(take().text);
        if (!is_map(type)) std::ignore = name_of(type);
        return type;
    }

    std::string read_name() {
        if (next().kind != piece::word || glsl::detail::find_word(next().text))
            reject("no name: " + std::string(next().text));
        return std::string(take().text);
    }

    /// `float f(float a, ...)`; what comes next is the body.
    head read_head() {
        head h{next().space, read_type(), read_name(), {}};
        expect("(");
        while (!(next() == ")")) {
            if (!h.parameters.empty()) expect(",");
            std::string type = read_type();
            h.parameters.push_back({std::move(type), read_name()});
        }
        expect(")");
        return h;
    }

    void comment() {
        const token& t = take();
        out_ += std::string(t.space) + std::string(t.text);
    }

    /// The indentation of the line being written.
    [[nodiscard]] std::size_t indentation() const {
        const std::size_t line = out_.rfind('\n') + 1, text = out_.find_first_not_of(' ', line);
        return (text == out_.npos ? out_.size() : text) - line;
    }

    void write(std::string_view space, std::string_view text) {
        out_ += space;
        out_ += text;
    }

    void function() {
        const head h = read_head();
        note_assignments();
        types.clear();
        std::string parameters, copies, name;
        std::vector<std::string> given;
        for (const parameter& p : h.parameters) {
            types[p.name] = p.type;
            given.push_back(p.type);
            if (!parameters.empty()) parameters += ", ";
            if (is_map(p.type)) {
                parameters += p.type + " " + p.name;
            } else {
                const bool copied = assigned_.contains(p.name);
                const std::string type = ": " + name_of(p.type), outer = p.name + (copied ? "_in" : "");
                parameters += outer + type;
                if (copied) copies += "\n    var " + p.name + type + " = " + outer + ";";
            }
        }
        const auto [first, last] = functions_.equal_range(h.name);
        for (auto f = first; f != last; ++f)
            if (f->second.parameters == given) name = f->second.name;
        write(h.space, "fn " + name + "(" + parameters + ") -> " + name_of(h.gives) + expect("{"));
        out_ += copies;
        block();
    }

    /// Finds which names the body that comes next writes to.
    void note_assignments() {
        static constexpr std::string_view signs[]{"=", "+=", "-=", "*=", "/=", "|=", "&=", "++", "--"};
        assigned_.clear();
        const std::size_t end = glsl::detail::closing(all_, at);
        for (std::size_t i = at + 1; i < end; ++i) {
            if (all_[i].kind != piece::word || glsl::detail::is_type(all_[i - 1].text)) continue;
            std::size_t behind = i + 1;
            while (all_[behind] == "." || all_[behind] == "[")
                behind = all_[behind] == "." ? behind + 2 : glsl::detail::closing(all_, behind) + 1;
            const bool before = all_[i - 1] == "++" || all_[i - 1] == "--";
            if (before || std::find(std::begin(signs), std::end(signs), all_[behind].text) != std::end(signs))
                assigned_.emplace(all_[i].text);
        }
    }

    /// What is behind an opening brace, and the closing one.
    void block() {
        while (!(next() == "}")) {
            if (next().kind == piece::end) reject("a brace is not closed");
            statement();
        }
        out_ += expect("}");
    }

    void statement() {
        const std::string_view space = next().space;
        if (next().kind == piece::comment) return comment();
        if (next() == "{") {
            out_ += expect("{");
            return block();
        }
        if (next() == "if" || next() == "for") {
            const std::string word(take().text);
            write(space, word + " " + (word == "if" ? condition() : loop()));
            body();
            if (word == "if" && next() == "else") alternative();
            return;
        }
        write(space, simple_statement());
        out_ += expect(";");
    }

    /// A declaration, an assignment, or a jump, up to its semicolon.
    std::string simple_statement() {
        skip_qualifiers();
        const std::string word(next().text);
        if (word == "return") {
            take();
            return word + spaced_expression().text;
        }
        if (word == "break" || word == "continue") {
            take();
            return word;
        }
        const bool constant = word == "const";
        if (constant) {
            take();
            skip_qualifiers();
        }
        if (glsl::detail::is_type(next().text)) return declaration(constant);
        if (next() == "++" || next() == "--") {  // behind its variable, in WGSL
            const std::string sign(take().text);
            return expression().text + sign;
        }
        const value target = expression();
        const std::string sign = std::string(next().space) + std::string(next().text);
        if (next() == "++" || next() == "--") {
            take();
            return target.text + sign;
        }
        if (next().text.size() > 2 || !next().text.ends_with('=') || next() == "==")
            reject("not a statement: " + target.text + sign);
        take();
        return target.text + sign + spaced_expression().text;
    }

    std::string declaration(bool constant) {
        const std::string type = read_type();
        const std::string name = read_name();
        if (next() == "[") {
            expect("[");
            const std::string size = expression().text;
            expect("]");
            types[name] = type + "[" + size + "]";
            return "var " + name + ": array<" + name_of(type) + ", " + size + ">";
        }
        const bool initialised = next() == "=";
        const bool changes = assigned_.contains(name) || !initialised;
        std::string text = std::string(constant ? "const " : changes ? "var " : "let ") + name + ": " + name_of(type);
        if (initialised) {
            text += expect("=");
            const value v = spaced_expression();
            if (v.type != type && !v.literal) reject(type + " " + name + " of " + v.type);
            text += v.text;
        }
        types[name] = type;
        return text;
    }

    std::string condition() {
        expect("(");
        const value v = spaced_expression();
        if (v.type != "bool") reject("if (" + v.text + ")");
        return "(" + v.text + expect(")");
    }

    std::string loop() {
        expect("(");
        std::string text = "(" + simple_statement();
        text += expect(";");
        text += spaced_expression().text;
        text += expect(";");
        text += next().space;
        text += simple_statement();
        return text += expect(")");
    }

    /// Of `if`, `else` or `for`: WGSL wants braces.
    void body() {
        if (next() == "{") return statement();
        const std::size_t margin = indentation();
        const bool own_line = next().space.find('\n') != std::string_view::npos;
        out_ += " {";
        statement();
        out_ += own_line ? "\n" + std::string(margin, ' ') + "}" : " }";
    }

    void alternative() {
        out_ += expect("else");
        if (next() == "if") statement();
        else body();
    }

    signatures& functions_;
    std::string out_;
    std::set<std::string, std::less<>> assigned_;
};

}  // namespace umbrage::wgsl::detail

// ---- umbrage/shader/wgsl.hpp
// Snippets in WGSL, printed from their GLSL.
//
//     std::string shader = umbrage::wgsl::text({umbrage::glsl::pcf_2x2}) + my_main;
//     // fn umbrage_pcf_2x2(map: texture_2d<f32>, size: vec2f, coord: vec2f, receiver: f32) -> f32
//
// Of functions that GLSL overloads, all but the float's have a type in their name: umbrage_to_unorm_vec2f.
//

namespace umbrage::wgsl {

namespace detail {

[[nodiscard]] constexpr glsl::detail::texture_words reads(glsl::texture kind) {
    using glsl::texture;
    switch (kind) {
        case texture::texture_2d:
            return {.parameters = "map: texture_2d<f32>",
                    .arguments = "map",
                    .texel = "textureLoad(map, vec2i(at), 0)",
                    .sampled = "textureSampleLevel(map, map_sampler, uv, 0.0)",
                    .gather_red = "textureGather(0, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)",
                    .gather_green = "textureGather(1, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)"};
        case texture::depth:
            return {.parameters = "map: texture_depth_2d",
                    .arguments = "map",
                    .texel = "vec4f(textureLoad(map, vec2i(at), 0))",
                    .sampled = "vec4f(textureSampleLevel(map, map_sampler, uv, 0))",
                    .gather_red = "textureGather(map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)"};
        case texture::atlas:
            return {.parameters = "map: texture_2d<f32>, origin: vec2f",
                    .arguments = "map, origin",
                    .texel = "textureLoad(map, vec2i(at), 0)",
                    .sampled = "textureSampleLevel(map, map_sampler, uv, 0.0)",
                    .gather_red = "textureGather(0, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)",
                    .gather_green = "textureGather(1, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE)"};
        case texture::array:
            return {
                .parameters = "map: texture_2d_array<f32>, layer: f32",
                .arguments = "map, layer",
                .texel = "textureLoad(map, vec2i(at), i32(layer), 0)",
                .sampled = "textureSampleLevel(map, map_sampler, uv, i32(layer), 0.0)",
                .gather_red = "textureGather(0, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, i32(layer))",
                .gather_green = "textureGather(1, map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, i32(layer))"};
        case texture::depth_array:
            return {.parameters = "map: texture_depth_2d_array, layer: f32",
                    .arguments = "map, layer",
                    .texel = "vec4f(textureLoad(map, vec2i(at), i32(layer), 0))",
                    .sampled = "vec4f(textureSampleLevel(map, map_sampler, uv, i32(layer), 0))",
                    .gather_red = "textureGather(map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, i32(layer))"};
        case texture::cube:
            return {.parameters = "map: texture_cube<f32>, map_sampler: sampler, face: f32",
                    .arguments = "map, map_sampler, face",
                    .texel =
                        "textureSampleLevel(map, map_sampler, umbrage_cube_direction(face, (at + 0.5) / "
                        "UMBRAGE_TEXTURE_SIZE), 0.0)",
                    .needs = glsl::list<&glsl::cube_direction>};
        case texture::cube_faces:
            return {
                .parameters = "map: texture_cube<f32>, map_sampler: sampler",
                .arguments = "map, map_sampler",
                .texel = "textureSampleLevel(map, map_sampler, umbrage_cube_atlas_direction(at, size.y * 0.5), 0.0)",
                .needs = glsl::list<&glsl::cube_atlas_direction>};
        case texture::integer:
            return {.parameters = "map: texture_2d<u32>",
                    .arguments = "map",
                    .texel = "vec4f(textureLoad(map, vec2i(at), 0))"};
        case texture::shadow:
            return {.parameters = "map: texture_depth_2d, map_sampler: sampler_comparison",
                    .arguments = "map, map_sampler",
                    .lit = "textureSampleCompareLevel(map, map_sampler, (at + 0.5) / UMBRAGE_TEXTURE_SIZE, receiver)",
                    .gather_lit = "textureGatherCompare(map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, receiver)",
                    .lit_filtered = "textureSampleCompareLevel(map, map_sampler, uv, receiver)"};
        case texture::shadow_array:
            return {.parameters = "map: texture_depth_2d_array, map_sampler: sampler_comparison, layer: f32",
                    .arguments = "map, map_sampler, layer",
                    .lit =
                        "textureSampleCompareLevel(map, map_sampler, (at + 0.5) / UMBRAGE_TEXTURE_SIZE, i32(layer), "
                        "receiver)",
                    .gather_lit =
                        "textureGatherCompare(map, map_sampler, (at + 1.0) / UMBRAGE_TEXTURE_SIZE, i32(layer), "
                        "receiver)",
                    .lit_filtered = "textureSampleCompareLevel(map, map_sampler, uv, i32(layer), receiver)"};
    }
    return {};
}

[[nodiscard]] constexpr glsl::detail::texture_words textures(glsl::texture kind) {
    glsl::detail::texture_words words = reads(kind);
    words.size = "vec2f(textureDimensions(map))";
    if (words.gather_red.empty()) return words;
    words.sampler = ", map_sampler: sampler";
    words.sampler_argument = ", map_sampler";
    return words;
}

inline void declare(const glsl::snippet& s, signatures& functions) {
    for (const glsl::snippet* need : s.needs) declare(*need, functions);
    printer(s.source.str(), functions).declare();
}

[[nodiscard]] inline std::string translate(const glsl::snippet& s) {
    signatures functions;
    declare(s, functions);
    return glsl::detail::laid_out(printer(s.source.str(), functions).print());
}

inline constexpr glsl::detail::language language{
    .prelude = "", .texture = textures, .translate = translate, .preprocessor = false};

}  // namespace detail

/// The snippets, or what bind() gives for a map, and all they need, each function once: text to paste into any shader.
/// @throws std::invalid_argument   for what WGSL has no word for
[[nodiscard]] inline std::string text(std::span<const glsl::bound> items) {
    return glsl::detail::compose(detail::language, items);
}

[[nodiscard]] inline std::string text(std::initializer_list<glsl::bound> items) {
    return wgsl::text(std::span(items.begin(), items.size()));
}

}  // namespace umbrage::wgsl

// ---- umbrage/umbrage.hpp
// All of umbrage: the primitives, functions over whole images, the texts of snippets. Includes only.

