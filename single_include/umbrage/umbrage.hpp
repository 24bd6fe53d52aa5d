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
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_precision.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <memory>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

// ---- umbrage/clip_space.hpp
// Conventions as values: which way the camera looks, what depth means, where the first texel is.
// Passed explicitly everywhere; GLM's configuration macros are neither read nor needed.
//
//     auto light = umbrage::make_spot_light({.position = p, .direction = d, .clip = umbrage::vulkan_clip_space});
//

namespace umbrage {

enum class handedness { right, left };                     ///< view space: looking down -z, or +z
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

/// Right-handed, z/w in [-1, 1], texels from the bottom.
inline constexpr clip_space opengl_clip_space{.range = depth_range::minus_one_to_one};

/// Right-handed, z/w in [0, 1]; the first texel is at NDC y = -1, which Vulkan draws at the top.
inline constexpr clip_space vulkan_clip_space{};

/// Left-handed, z/w in [0, 1], texels from the top. Metal and WebGPU agree but for the hand, which is the caller's.
inline constexpr clip_space direct3d_clip_space{.hand = handedness::left, .origin = texture_origin::top};

/// The depth of the far plane, to which a map is cleared.
[[nodiscard]] constexpr float cleared_depth(clip_space clip) {
    return clip.direction == depth_direction::forward ? 1.0f : 0.0f;
}

}  // namespace umbrage

// ---- umbrage/glsl.hpp
// GLSL twins: what a snippet is, and how to put snippets into a shader.
//
//     std::string shader = umbrage::glsl::source(umbrage::glsl::version::v330, {umbrage::glsl::pcf_2x2}) + my_main;
//

namespace umbrage::glsl {

/// How exactly a snippet and its C++ twin agree.
///   a  bit for bit on every implementation: every intermediate is representable, so nothing can round
///   b  bit for bit where + - * round to nearest in written order; a few ulp elsewhere
///   c  within snippet::ulp units in the last place on every implementation tried: division, square root
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

/// One GLSL function (with its overloads) and what is known of it.
struct snippet {
    std::string_view name;                 ///< of the C++ twin; the GLSL function is umbrage_<name>
    std::string_view summary;              ///< one line
    tier exactness = tier::a;
    int ulp = 0;                           ///< tier c: greatest distance from the C++ twin, twice the worst seen or 1
    version lowest = version::v100;        ///< v100: every dialect; v300_es: 300 es and 330 upwards
    std::array<const snippet*, 4> needs{};
    std::string_view source;
};

/// True when `s` compiles in dialect `v`.
[[nodiscard]] constexpr bool supports(const snippet& s, version v) {
    return s.lowest == version::v100 || v >= version::v300_es;
}

/// Macros every snippet relies on; each can be defined beforehand to something else.
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

inline void append(std::string& out, std::vector<std::string_view>& done, const snippet& s) {
    for (std::string_view name : done)
        if (name == s.name) return;
    done.push_back(s.name);
    for (const snippet* need : s.needs)
        if (need) append(out, done, *need);
    std::string guard = "UMBRAGE_HAS_";
    for (char c : s.name) guard += (c >= 'a' && c <= 'z') ? static_cast<char>(c - 'a' + 'A') : c;
    out += "\n#ifndef " + guard + "\n#define " + guard;
    out += s.source;
    out += "#endif\n";
}

}  // namespace detail

/// The snippets and all they need, each once and guarded, without a `#version` line: text to paste into any shader.
[[nodiscard]] inline std::string text(std::span<const snippet> snippets) {
    std::string out(prelude);
    std::vector<std::string_view> done;
    for (const snippet& s : snippets) detail::append(out, done, s);
    return out;
}

[[nodiscard]] inline std::string text(std::initializer_list<snippet> snippets) {
    return text(std::span(snippets.begin(), snippets.size()));
}

/// The beginning of a shader: `#version`, `preamble` (extensions, macros, precision), the snippets and all they need.
/// @throws std::invalid_argument when a snippet does not support the dialect
[[nodiscard]] inline std::string source(version v, std::span<const snippet> snippets, std::string_view preamble = {}) {
    for (const snippet& s : snippets)
        if (!supports(s, v))
            throw std::invalid_argument("umbrage::glsl::source: " + std::string(s.name) + " needs GLSL 330 or 300 es");
    std::string out = "#version ";
    out += directive(v);
    out += '\n';
    out += preamble;
    if (!preamble.empty() && preamble.back() != '\n') out += '\n';
    return out + text(snippets);
}

[[nodiscard]] inline std::string source(version v, std::initializer_list<snippet> snippets,
                                        std::string_view preamble = {}) {
    return source(v, std::span(snippets.begin(), snippets.size()), preamble);
}

namespace detail {

/// Text with the constants of one member of a family filled in, at compile time.
template <std::size_t Capacity>
struct filled_text {
    char data[Capacity]{};
    std::size_t size = 0;
    [[nodiscard]] constexpr std::string_view view() const { return {data, size}; }
};

struct constant {
    char key;  ///< `$key` in the text
    unsigned value;
};

/// Replaces each `$key` by the decimal digits of its value. Plain arrays, for the sake of every user's compile time.
template <std::size_t Capacity, std::size_t Length>
constexpr filled_text<Capacity> fill(const char (&text)[Length], std::initializer_list<constant> constants) {
    filled_text<Capacity> out;
    std::size_t size = 0;
    for (std::size_t i = 0; i + 1 < Length; ++i) {
        if (text[i] != '$') {
            out.data[size++] = text[i];
            continue;
        }
        ++i;
        for (const constant& c : constants) {
            if (c.key != text[i]) continue;
            unsigned unit = 1;
            while (c.value / unit >= 10) unit *= 10;
            for (; unit > 0; unit /= 10) out.data[size++] = static_cast<char>('0' + c.value / unit % 10);
        }
    }
    out.size = size;
    return out;
}

}  // namespace detail
}  // namespace umbrage::glsl

// ---- umbrage/scalar.hpp
// The scalar ground rules: which types are depths, what NaN means, what clamping does.
//
//     float d = umbrage::saturate(z);  // NaN and everything from 1 up: 1;  everything from 0 down: 0
//

namespace umbrage {

/// Scalars that primitives work on.
template <class T>
concept real = std::same_as<T, float> || std::same_as<T, double>;

/// Tests the bits, so that -ffast-math cannot remove it.
[[nodiscard]] constexpr bool is_nan(float v) {
    return (std::bit_cast<std::uint32_t>(v) & 0x7FFFFFFFu) > 0x7F800000u;
}
[[nodiscard]] constexpr bool is_nan(double v) {
    return (std::bit_cast<std::uint64_t>(v) & 0x7FFFFFFFFFFFFFFFull) > 0x7FF0000000000000ull;
}

/// True for everything but NaN and the infinities.
[[nodiscard]] constexpr bool is_finite(float v) {
    return (std::bit_cast<std::uint32_t>(v) & 0x7FFFFFFFu) < 0x7F800000u;
}
[[nodiscard]] constexpr bool is_finite(double v) {
    return (std::bit_cast<std::uint64_t>(v) & 0x7FFFFFFFFFFFFFFFull) < 0x7FF0000000000000ull;
}

/// Clamps to [0, 1]. NaN of either sign becomes 1, the cleared depth; -0 becomes +0.
/// @formula     !(v < 1) ? 1 : (v > 0 ? v : 0)
/// @exactness   A: selects, never computes; by the order of the bits, so that -ffast-math leaves no -0 and no
///              flushing mode takes a denormal
template <real T>
[[nodiscard]] constexpr T saturate(T v) {
    using bits = std::conditional_t<sizeof(T) == 4, std::int32_t, std::int64_t>;
    if (is_nan(v) || std::bit_cast<bits>(v) >= std::bit_cast<bits>(T(1))) return T(1);
    return std::bit_cast<bits>(v) > 0 ? v : T(0);
}

namespace glsl {

inline constexpr snippet saturate{
    .name = "saturate", .summary = "clamp to [0, 1], NaN to 1", .exactness = tier::a, .source = R"GLSL(
// umbrage_saturate: v clamped to [0, 1]; NaN becomes 1.0
UMBRAGE_HIGHP float umbrage_saturate(UMBRAGE_HIGHP float v) {
    return !(v < 1.0) ? 1.0 : (v > 0.0 ? v : 0.0);
}
)GLSL"};

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/compare.hpp
// The depth test of a shadow map, and the two classic samples' ways to write it.
//
//     bool lit = umbrage::less_equal{}(receiver - bias, stored);
//
// Filters compare once per texel with less_equal and no epsilon inside; for reversed Z pass greater_equal (in GLSL
// define UMBRAGE_LIT). A NaN on either side is in shadow.

namespace umbrage {

/// Lit when the receiver is no farther than the stored occluder.
/// @exactness     A
struct less_equal {
    template <real T>
    [[nodiscard]] constexpr bool operator()(T receiver, T stored) const {
        return !is_nan(receiver) && !is_nan(stored) && receiver <= stored;
    }
};

/// The same for reversed Z, where near is 1.
struct greater_equal {
    template <real T>
    [[nodiscard]] constexpr bool operator()(T receiver, T stored) const {
        return !is_nan(receiver) && !is_nan(stored) && receiver >= stored;
    }
};

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

inline constexpr snippet compare{
    .name = "compare", .summary = "one comparison, as a macro to redefine", .exactness = tier::a,
    .needs = {}, .source = R"GLSL(
// UMBRAGE_LIT: 1.0 when the receiver is no farther than the stored depth; define it with >= for reversed Z
#ifndef UMBRAGE_LIT
#define UMBRAGE_LIT(receiver, stored) ((receiver) <= (stored) ? 1.0 : 0.0)
#endif
// umbrage_compare: visibility of one comparison
UMBRAGE_HIGHP float umbrage_compare(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored) {
    return UMBRAGE_LIT(receiver, stored);
}
)GLSL"};

inline constexpr snippet compare_dx_sdk{
    .name = "compare_dx_sdk", .summary = "stored + epsilon < receiver is shadow", .exactness = tier::b,
    .source = R"GLSL(
// umbrage_compare_dx_sdk: 0.0 when stored + epsilon < receiver, else 1.0
UMBRAGE_HIGHP float umbrage_compare_dx_sdk(UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float stored,
                                           UMBRAGE_HIGHP float epsilon) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float limit = stored + epsilon;
    return limit < receiver ? 0.0 : 1.0;
}
)GLSL"};

inline constexpr snippet compare_exercise{
    .name = "compare_exercise", .summary = "current < stored + epsilon is lit", .exactness = tier::b,
    .source = R"GLSL(
// umbrage_compare_exercise: 1.0 when current < stored + epsilon, else 0.0
UMBRAGE_HIGHP float umbrage_compare_exercise(UMBRAGE_HIGHP float current, UMBRAGE_HIGHP float stored,
                                             UMBRAGE_HIGHP float epsilon) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float limit = stored + epsilon;
    return current < limit ? 1.0 : 0.0;
}
)GLSL"};

}  // namespace glsl
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
        if (extent.x < 0 || extent.y < 0) throw std::invalid_argument("umbrage::image_view: negative size");
        if (empty()) return;
        const auto row_bytes = extent.x * static_cast<std::ptrdiff_t>(sizeof(T));
        const auto distance = stride_bytes < 0 ? -stride_bytes : stride_bytes;
        if (!pixels) throw std::invalid_argument("umbrage::image_view: no pixels");
        if (extent.y > 1 && distance < row_bytes) throw std::invalid_argument("umbrage::image_view: stride shorter than a row");
        if (distance % static_cast<std::ptrdiff_t>(alignof(T)) != 0)
            throw std::invalid_argument("umbrage::image_view: stride breaks the alignment of a texel");
    }

    /// A view that may write is also a view that may read.
    constexpr operator image_view<const T>() const
        requires(!std::is_const_v<T>)
    {
        return {data, size, stride};
    }

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

    /// Rows first <= y < last as a view of their own: the unit of work for a thread.
    [[nodiscard]] image_view rows(int first, int last) const {
        assert(0 <= first && first <= last && last <= size.y);
        return {first < last ? row(first) : data, {size.x, last - first}, stride};
    }
};

/// Pixels of our own, without gaps between rows.
template <class T>
class image {
public:
    image() = default;

    /// @throws std::invalid_argument  negative size
    explicit image(glm::ivec2 size, const T& value = T{}) : size_(size) {
        if (size.x < 0 || size.y < 0) throw std::invalid_argument("umbrage::image: negative size");
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
    std::vector<T> texels_;
};

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
[[nodiscard]] std::remove_const_t<T> fetch_bordered(image_view<T> map, glm::ivec2 texel, std::remove_const_t<T> border) {
    const bool inside = texel.x >= 0 && texel.y >= 0 && texel.x < map.size.x && texel.y < map.size.y;
    return inside ? map.row(texel.y)[texel.x] : border;
}

/// fetch_clamped as the callable that filters take.
/// @throws std::invalid_argument  empty map
template <class T>
[[nodiscard]] auto clamped(image_view<T> map) {
    if (map.empty()) throw std::invalid_argument("umbrage::clamped: empty map");
    return [map](glm::ivec2 texel) { return fetch_clamped(map, texel); };
}
template <class T>
[[nodiscard]] auto clamped(const image<T>& map) {
    return clamped(map.view());
}

/// fetch_bordered as the callable that filters take; `border` = 1 makes everything outside the map lit.
template <class T>
[[nodiscard]] auto bordered(image_view<T> map, std::remove_const_t<T> border) {
    return [map, border](glm::ivec2 texel) { return fetch_bordered(map, texel, border); };
}
template <class T>
[[nodiscard]] auto bordered(const image<T>& map, T border) {
    return bordered(map.view(), border);
}

namespace glsl {

inline constexpr snippet fetch_clamped{
    .name = "fetch_clamped", .summary = "texel of a map, outside the nearest one inside", .exactness = tier::a,
    .source = R"GLSL(
// umbrage_fetch_clamped: texel of a map; coordinates outside move to the nearest texel inside
//   map    2D sampler; before GLSL 1.30 its filter must be nearest
//   size   of the map in texels;   texel  whole numbers, (0, 0) is the first
#ifndef UMBRAGE_MAP
#define UMBRAGE_MAP UMBRAGE_HIGHP sampler2D
#endif
UMBRAGE_HIGHP vec4 umbrage_fetch_clamped(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP vec2 inside = clamp(texel, vec2(0.0, 0.0), size - 1.0);
#if __VERSION__ >= 130
    return texelFetch(map, ivec2(inside), 0);
#else
    return texture2D(map, (inside + 0.5) / size);
#endif
}
)GLSL"};

inline constexpr snippet fetch_bordered{
    .name = "fetch_bordered", .summary = "texel of a map, outside a border value", .exactness = tier::a,
    .needs = {&fetch_clamped}, .source = R"GLSL(
// umbrage_fetch_bordered: texel of a map, or border outside of it
UMBRAGE_HIGHP vec4 umbrage_fetch_bordered(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                          UMBRAGE_HIGHP vec4 border) {
    UMBRAGE_HIGHP vec4 value = umbrage_fetch_clamped(map, size, texel);
    return texel.x >= 0.0 && texel.y >= 0.0 && texel.x < size.x && texel.y < size.y ? value : border;
}
)GLSL"};

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
template <int L, real T>
[[nodiscard]] constexpr glm::vec<L, T> to_unorm(glm::vec<L, T> k) {
    for (int i = 0; i < L; ++i) k[i] = to_unorm(k[i]);
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
template <int L, real T>
[[nodiscard]] glm::vec<L, T> from_unorm(glm::vec<L, T> c) {
    for (int i = 0; i < L; ++i) c[i] = from_unorm(c[i]);
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
template <int L, real T>
[[nodiscard]] constexpr glm::vec<L, std::uint8_t> store_unorm8(glm::vec<L, T> c, unorm_store mode = unorm_store::rounds) {
    glm::vec<L, std::uint8_t> bytes(0);
    for (int i = 0; i < L; ++i) bytes[i] = store_unorm8(c[i], mode);
    return bytes;
}

/// What sampling gives back of stored bytes.
template <real T = float, int L>
[[nodiscard]] constexpr glm::vec<L, T> load_unorm8(glm::vec<L, std::uint8_t> bytes) {
    glm::vec<L, T> c(0);
    for (int i = 0; i < L; ++i) c[i] = T(bytes[i]) / T(255);
    return c;
}

namespace glsl {

inline constexpr snippet to_unorm{
    .name = "to_unorm", .summary = "channel 0..255 to the value an 8-bit target stores as it", .exactness = tier::a,
    .source = R"GLSL(
// umbrage_to_unorm: what to write so that an 8-bit target stores channel k, whether it rounds or truncates
UMBRAGE_HIGHP float umbrage_to_unorm(UMBRAGE_HIGHP float k) {
    return k * (257.0 / 65536.0) + (64.0 / 65536.0);
}
UMBRAGE_HIGHP vec2 umbrage_to_unorm(UMBRAGE_HIGHP vec2 k) {
    return k * (257.0 / 65536.0) + (64.0 / 65536.0);
}
UMBRAGE_HIGHP vec3 umbrage_to_unorm(UMBRAGE_HIGHP vec3 k) {
    return k * (257.0 / 65536.0) + (64.0 / 65536.0);
}
UMBRAGE_HIGHP vec4 umbrage_to_unorm(UMBRAGE_HIGHP vec4 k) {
    return k * (257.0 / 65536.0) + (64.0 / 65536.0);
}
)GLSL"};

inline constexpr snippet from_unorm{
    .name = "from_unorm", .summary = "value read from an 8-bit texture to channel 0..255", .exactness = tier::a,
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
)GLSL"};

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/depth/aras.hpp
// The RGBA format of Aras Pranckevicius, base 255, as Cesium, Babylon.js and bgfx use it, to read and write such maps.
//
//     float stored = umbrage::decode_aras(umbrage::load_unorm8(texel));
//
// Below 1.0 the worst error is 2^-23. Faults of the format: 1.0 decodes to 0, and where the store truncates the error is
// up to 2^-7.98 and nearby depths change places. The repaired writer has neither, for the same reader; what is left is
// the reader's rounding: depths k / 2^24 keep their order, two pairs of other neighbouring floats decode 1 ulp out of it.
//

namespace umbrage {

/// @param depth   clamped to [0, 1]; NaN counts as 1, which decodes to 0: the fault of the format
/// @return        UNORM values
/// @formula       e_i = fract(255^i depth), each less 1/255 of the next
/// @exactness     B
/// @cite          Pranckevicius: Encoding floats to RGBA - the final?, 2009 (format)
template <real T>
[[nodiscard]] glm::vec<4, T> encode_aras(T depth) {
    const T v = saturate(depth);
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
[[nodiscard]] constexpr T decode_aras(glm::vec<4, T> c) {
    return c.x + c.y * T(1.0 / 255.0) + c.z * T(1.0 / 65025.0) + c.w * T(1.0 / 16581375.0);
}

/// A writer without the faults, for decode_aras on the other side: the digits of depth in base 255.
/// @return        integer channels 0..255 (to_unorm writes them); 1 gives (255, 0, 0, 0)
/// @exactness     B
template <real T>
[[nodiscard]] glm::u8vec4 encode_aras_repaired(T depth) {
    T rest = saturate(depth) * T(255);
    glm::u8vec4 digits(0);
    for (int i = 0; i < 4; ++i) {
        const T digit = std::floor(rest);
        digits[i] = static_cast<std::uint8_t>(digit);
        rest = (rest - digit) * T(255);
    }
    return digits;
}

/// The format as a value, for functions over images, faults and all; the store rounds.
struct aras {
    using texel = glm::u8vec4;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 32;
    static constexpr double max_error = 1.0;  ///< at 1.0; below it 2^-23, or 2^-7.98 where the store truncates

    [[nodiscard]] texel encode(float depth) const { return store_unorm8(encode_aras(depth)); }
    [[nodiscard]] float decode(texel t) const { return decode_aras(load_unorm8(t)); }
};

/// The same, written without the faults.
struct aras_repaired {
    using texel = glm::u8vec4;
    static constexpr std::uint64_t codes = std::uint64_t(255) * 255 * 255 * 255 + 1;
    static constexpr double max_error = 0x1p-23;  ///< whether the store rounds or truncates

    [[nodiscard]] texel encode(float depth) const { return encode_aras_repaired(depth); }
    [[nodiscard]] float decode(texel t) const { return decode_aras(load_unorm8(t)); }
};

namespace glsl {

inline constexpr snippet encode_aras{
    .name = "encode_aras", .summary = "depth to the base-255 RGBA format of Cesium, Babylon.js, bgfx",
    .exactness = tier::b, .needs = {&saturate}, .source = R"GLSL(
// umbrage_encode_aras: depth to base-255 RGBA, values to write as they are; 1.0 reads back as 0.0, and the store must
//   round: umbrage_encode_aras_repaired has neither fault
UMBRAGE_HIGHP vec4 umbrage_encode_aras(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 e = vec4(v, v * 255.0, v * 65025.0, v * 16581375.0);
    e = e - floor(e);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 c =
        vec4(e.x - e.y * 0.00392156886, e.y - e.z * 0.00392156886, e.z - e.w * 0.00392156886, e.w);
    return c;
}
)GLSL"};

inline constexpr snippet decode_aras{
    .name = "decode_aras", .summary = "base-255 RGBA to depth", .exactness = tier::b, .source = R"GLSL(
// umbrage_decode_aras: base-255 RGBA, as sampled, to depth
UMBRAGE_HIGHP float umbrage_decode_aras(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth =
        c.x + c.y * 0.00392156886 + c.z * 0.0000153787005 + c.w * 0.0000000603086294;
    return depth;
}
)GLSL"};

inline constexpr snippet encode_aras_repaired{
    .name = "encode_aras_repaired", .summary = "depth for readers of base-255 RGBA, 1.0 and truncation repaired",
    .exactness = tier::b, .needs = {&saturate}, .source = R"GLSL(
// umbrage_encode_aras_repaired: depth to channels that readers of base-255 RGBA decode, 1.0 to 1.0;
//   whole numbers 0..255 (umbrage_to_unorm writes them)
UMBRAGE_HIGHP vec4 umbrage_encode_aras_repaired(UMBRAGE_HIGHP float depth) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float x = umbrage_saturate(depth) * 255.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float y = (x - floor(x)) * 255.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float z = (y - floor(y)) * 255.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float w = (z - floor(z)) * 255.0;
    return vec4(floor(x), floor(y), floor(z), floor(w));
}
)GLSL"};

}  // namespace glsl
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
[[nodiscard]] constexpr glm::u8vec4 encode_float_bits(float v) {
    const auto bits = std::bit_cast<std::uint32_t>(v);
    return {static_cast<std::uint8_t>(bits & 0xFF), static_cast<std::uint8_t>(bits >> 8 & 0xFF),
            static_cast<std::uint8_t>(bits >> 16 & 0xFF), static_cast<std::uint8_t>(bits >> 24)};
}

/// Bytes to float.
[[nodiscard]] constexpr float decode_float_bits(glm::u8vec4 texel) {
    return std::bit_cast<float>(std::uint32_t(texel.x) | std::uint32_t(texel.y) << 8 | std::uint32_t(texel.z) << 16 |
                                std::uint32_t(texel.w) << 24);
}

/// Values read from an 8-bit texture to float.
/// @param c       as sampled, k / 255, in any rounding; outside [0, 1], which no texture gives, clamped; NaN counts as 1
/// @exactness     A
[[nodiscard]] inline float decode_float_bits(glm::vec4 c) {
    glm::u8vec4 texel(0);
    for (int i = 0; i < 4; ++i) texel[i] = static_cast<std::uint8_t>(from_unorm(saturate(c[i])));
    return decode_float_bits(texel);
}

/// The encoding as a value, for functions over images.
struct float_bits {
    using texel = glm::u8vec4;
    static constexpr int bits = 32;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 32;
    static constexpr double max_error = 0.0;

    [[nodiscard]] constexpr texel encode(float depth) const { return encode_float_bits(depth); }
    [[nodiscard]] constexpr float decode(texel t) const { return decode_float_bits(t); }
};

/// A map of plain floats, with the face of an encoding.
struct depth32f {
    using texel = float;
    static constexpr double max_error = 0.0;

    [[nodiscard]] constexpr texel encode(float depth) const { return saturate(depth); }
    [[nodiscard]] constexpr float decode(texel t) const { return t; }
};

namespace glsl {

inline constexpr snippet encode_float_bits{
    .name = "encode_float_bits", .summary = "any float's bit pattern to four channels, R least significant",
    .exactness = tier::a, .lowest = version::v300_es, .source = R"GLSL(
// umbrage_encode_float_bits: bit pattern of v as four channels, R least significant, whole numbers 0..255
UMBRAGE_HIGHP vec4 umbrage_encode_float_bits(UMBRAGE_HIGHP float v) {
    UMBRAGE_HIGHP uint bits = floatBitsToUint(v);
    return vec4(float(bits & 255u), float((bits >> 8) & 255u), float((bits >> 16) & 255u), float(bits >> 24));
}
)GLSL"};

inline constexpr snippet decode_float_bits{
    .name = "decode_float_bits", .summary = "four channels, R least significant, to the float they are",
    .exactness = tier::a, .lowest = version::v300_es, .needs = {&saturate, &from_unorm}, .source = R"GLSL(
// umbrage_decode_float_bits: four channels of a bit pattern, as sampled, R least significant, to the float
UMBRAGE_HIGHP float umbrage_decode_float_bits(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_HIGHP uint r = uint(umbrage_from_unorm(umbrage_saturate(c.x)));
    UMBRAGE_HIGHP uint g = uint(umbrage_from_unorm(umbrage_saturate(c.y)));
    UMBRAGE_HIGHP uint b = uint(umbrage_from_unorm(umbrage_saturate(c.z)));
    UMBRAGE_HIGHP uint a = uint(umbrage_from_unorm(umbrage_saturate(c.w)));
    return uintBitsToFloat(r | (g << 8) | (b << 16) | (a << 24));
}
)GLSL"};

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/depth/linear.hpp
// Kinds of depth, and the way from one to another.
//   z/w               what the rasterizer interpolates: project_depth
//   linear depth      view-space distance along the light's axis over z_far: linear_depth
//   radial distance   from the light to the point over its range: distance_depth
//   reversed          1 - depth
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
/// @return        z / w; 1, the cleared depth, for w <= 0 (not in front of the light) and NaN in w
/// @exactness     C: one division, of which GLSL allows 2.5 ulp; 0 seen
template <real T>
[[nodiscard]] constexpr T project_depth(T z, T w) {
    return w > T(0) && !is_nan(w) ? z / w : T(1);
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
/// @param depth           z/w in [0, 1], 0 at the near plane; reverse_depth first when reversed
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

namespace glsl {

inline constexpr snippet linear_depth{
    .name = "linear_depth", .summary = "view-space z over z_far", .exactness = tier::b, .source = R"GLSL(
// umbrage_linear_depth: distance along the light's axis, positive in front of it, times 1 / z_far
UMBRAGE_HIGHP float umbrage_linear_depth(UMBRAGE_HIGHP float z_view, UMBRAGE_HIGHP float inv_z_far) {
    return z_view * inv_z_far;
}
)GLSL"};

inline constexpr snippet project_depth{
    .name = "project_depth", .summary = "z / w, 1 behind the light", .exactness = tier::c, .ulp = 1,
    .source = R"GLSL(
// umbrage_project_depth: z / w; 1.0 for w <= 0.0
UMBRAGE_HIGHP float umbrage_project_depth(UMBRAGE_HIGHP float z, UMBRAGE_HIGHP float w) {
    return w > 0.0 ? z / w : 1.0;
}
)GLSL"};

inline constexpr snippet distance_depth{
    .name = "distance_depth", .summary = "distance to the light over its range", .exactness = tier::c, .ulp = 1,
    .source = R"GLSL(
// umbrage_distance_depth: length of to_point, from the light, times 1 / range
UMBRAGE_HIGHP float umbrage_distance_depth(UMBRAGE_HIGHP vec3 to_point, UMBRAGE_HIGHP float inv_range) {
    return sqrt(to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z) * inv_range;
}
)GLSL"};

inline constexpr snippet reverse_depth{
    .name = "reverse_depth", .summary = "1 - depth", .exactness = tier::b, .source = R"GLSL(
// umbrage_reverse_depth: forward depth from reversed, or reversed from forward
UMBRAGE_HIGHP float umbrage_reverse_depth(UMBRAGE_HIGHP float depth) {
    return 1.0 - depth;
}
)GLSL"};

inline constexpr snippet depth_from_ndc{
    .name = "depth_from_ndc", .summary = "z/w in [-1, 1] to depth in [0, 1]", .exactness = tier::b, .source = R"GLSL(
// umbrage_depth_from_ndc: depth in [0, 1] from z/w in [-1, 1]
UMBRAGE_HIGHP float umbrage_depth_from_ndc(UMBRAGE_HIGHP float ndc) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = ndc * 0.5 + 0.5;
    return depth;
}
)GLSL"};

inline constexpr snippet view_z_from_depth{
    .name = "view_z_from_depth", .summary = "perspective depth to view-space z", .exactness = tier::c, .ulp = 1,
    .source = R"GLSL(
// umbrage_view_z_from_depth: perspective depth in [0, 1], 0.0 at z_near, to distance along the light's axis
UMBRAGE_HIGHP float umbrage_view_z_from_depth(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float z_near,
                                              UMBRAGE_HIGHP float z_far) {
    return z_near / (1.0 - depth * (1.0 - z_near / z_far));
}
)GLSL"};

inline constexpr snippet depth_from_view_z{
    .name = "depth_from_view_z", .summary = "view-space z to perspective depth", .exactness = tier::c, .ulp = 1,
    .source = R"GLSL(
// umbrage_depth_from_view_z: distance along the light's axis to perspective depth in [0, 1], 0.0 at z_near
UMBRAGE_HIGHP float umbrage_depth_from_view_z(UMBRAGE_HIGHP float z_view, UMBRAGE_HIGHP float z_near,
                                              UMBRAGE_HIGHP float z_far) {
    return (1.0 - z_near / z_view) / (1.0 - z_near / z_far);
}
)GLSL"};

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/depth/ps14.hpp
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

/// A depth on the scale of decode_ps14.
/// @param depth   in [0, 1], not clamped
/// @formula       depth * 256 / 255
/// @exactness     B: one product with the rounded quotient
template <real T>
[[nodiscard]] constexpr T receiver_ps14(T depth) {
    return depth * T(256.0 / 255.0);
}

namespace glsl {

inline constexpr snippet decode_ps14{
    .name = "decode_ps14", .summary = "r / 8 + g as the Radeon 8500 computed it", .exactness = tier::b,
    .source = R"GLSL(
// umbrage_decode_ps14: the channels of an 11-bit code, as sampled, to x / 2040; compare with umbrage_receiver_ps14
UMBRAGE_HIGHP float umbrage_decode_ps14(UMBRAGE_HIGHP vec2 c) {
    return c.x * 0.125 + c.y;  // an exact product: fused or not, it rounds once
}
)GLSL"};

inline constexpr snippet receiver_ps14{
    .name = "receiver_ps14", .summary = "receiver on the scale of decode_ps14", .exactness = tier::b,
    .source = R"GLSL(
// umbrage_receiver_ps14: depth * 256 / 255, the scale of umbrage_decode_ps14
UMBRAGE_HIGHP float umbrage_receiver_ps14(UMBRAGE_HIGHP float depth) {
    return depth * 1.00392163;
}
)GLSL"};

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/depth/code.hpp
// A depth as a whole number of 2^Bits steps, and back: what every encoding of ours is made of.
//
//     std::uint32_t x = umbrage::depth_code<11>(0.5f);                         // 1024
//     float d = umbrage::code_depth<11>(float(x), umbrage::upper_edge<float>);  // 1025 / 2048
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

/// @param depth   clamped to [0, 1]; NaN counts as 1
/// @return        0 .. 2^Bits - 1
/// @formula       min(floor(depth 2^Bits), 2^Bits - 1)
/// @exactness     A: scaling by a power of two, floor, min
template <int Bits, real T>
[[nodiscard]] constexpr std::uint32_t depth_code(T depth) {
    static_assert(Bits >= 1 && Bits <= 24, "a binary32 significand has 24 bits");
    constexpr std::uint32_t codes = std::uint32_t(1) << Bits;
    const auto x = static_cast<std::uint32_t>(saturate(depth) * T(codes));
    return x < codes ? x : codes - 1;
}

/// @param code    0 .. 2^Bits - 1
/// @param edge    lower_edge, centre or upper_edge
/// @return        (code + edge) 2^-Bits
/// @exactness     A, but for the centre of 24 bits in binary32, which needs a 25th bit from code 2^23 on (then B)
template <int Bits, real T>
[[nodiscard]] constexpr T code_depth(T code, T edge) {
    return (code + edge) * (T(1) / T(std::uint32_t(1) << Bits));
}

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
/// @param depth   clamped to [0, 1]; NaN counts as 1
/// @return        integer channels 0..255; to_unorm makes them what a shader writes
/// @formula       x = min(floor(depth 2^Bits), 2^Bits - 1);  R = x mod 256, G = floor(x / 256) 2^(16 - Bits)
/// @exactness     A
/// @cite          ATI Radeon SDK, ShadowMap sample, 2002: R = x & 0xFF, G = (x & 0xFF00) >> 3
template <int Bits, real T>
[[nodiscard]] constexpr glm::u8vec2 encode_rg(T depth) {
    static_assert(Bits >= 9 && Bits <= 16);
    const std::uint32_t x = depth_code<Bits>(depth);
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
    return code_depth<Bits>(k.x + k.y * T(1 << (Bits - 8)), edge);
}

/// Bytes to depth.
template <int Bits, real T>
[[nodiscard]] constexpr T decode_rg(glm::u8vec2 texel, T edge) {
    static_assert(Bits >= 9 && Bits <= 16);
    return code_depth<Bits>(T(texel.x + (texel.y << (Bits - 8))), edge);
}

/// The encoding as a value, for functions over images.
template <int Bits>
struct rg {
    using texel = glm::u8vec2;
    static constexpr int bits = Bits;
    static constexpr std::uint32_t codes = std::uint32_t(1) << Bits;
    static constexpr double max_error = 1.0 / codes;  ///< at an edge; half of it at the centre

    float edge = upper_edge<float>;

    [[nodiscard]] constexpr texel encode(float depth) const { return encode_rg<Bits>(depth); }
    [[nodiscard]] constexpr float decode(texel t) const { return decode_rg<Bits>(t, edge); }
};

namespace glsl {

template <int Bits>
inline constexpr auto encode_rg_name = detail::fill<16>("encode_rg$b", {{'b', Bits}});
template <int Bits>
inline constexpr auto encode_rg_text = detail::fill<1024>(R"GLSL(
// umbrage_encode_rg$b: depth to the two channels of a $b-bit code, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as 1
UMBRAGE_HIGHP vec2 umbrage_encode_rg$b(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * $n.0), $l.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 256.0));
    return vec2(x - high * 256.0, high * $s.0);
}
)GLSL",
                                                                 {{'b', Bits}, {'n', 1 << Bits}, {'l', (1 << Bits) - 1}, {'s', 1 << (16 - Bits)}});
template <int Bits>
inline constexpr snippet encode_rg{.name = encode_rg_name<Bits>.view(),
                                   .summary = "depth to two channels, R the low byte",
                                   .exactness = tier::a,
                                   .needs = {&saturate},
                                   .source = encode_rg_text<Bits>.view()};

template <int Bits>
inline constexpr auto decode_rg_name = detail::fill<16>("decode_rg$b", {{'b', Bits}});
template <int Bits>
inline constexpr auto decode_rg_text = detail::fill<1024>(R"GLSL(
// umbrage_decode_rg$b: two channels of a $b-bit code, as sampled, to depth
//   edge   0.0, 0.5, 1.0: lower edge, centre, upper edge of the code's interval
UMBRAGE_HIGHP float umbrage_decode_rg$b(UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP float edge) {
    UMBRAGE_HIGHP vec2 k = umbrage_from_unorm(c);
    return (k.x + k.y * $g.0 + edge) * (1.0 / $n.0);
}
)GLSL",
                                                                 {{'b', Bits}, {'n', 1 << Bits}, {'g', 1 << (Bits - 8)}});
template <int Bits>
inline constexpr snippet decode_rg{.name = decode_rg_name<Bits>.view(),
                                   .summary = "two channels, R the low byte, to depth",
                                   .exactness = tier::a,
                                   .needs = {&from_unorm},
                                   .source = decode_rg_text<Bits>.view()};

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
inline constexpr glm::ivec2 rg_table_size = Bits <= 11 ? glm::ivec2(1 << Bits, 1) : glm::ivec2(2048, 1 << (Bits - 11));

/// Depth to channels by one nearest fetch from the table: the texel encode_rg<Bits> computes.
///
/// @param fetch   int 0 .. 2^Bits - 1 -> texel of the table
/// @param depth   clamped to [0, 1]; NaN counts as 1
/// @exactness     A
template <int Bits, real T, class Fetch>
[[nodiscard]] constexpr glm::u8vec2 encode_rg_table(Fetch&& fetch, T depth) {
    const auto texel = fetch(static_cast<int>(depth_code<Bits>(depth)));
    return {texel[0], texel[1]};
}

namespace glsl {

template <int Bits>
inline constexpr auto encode_rg_table_name = detail::fill<24>("encode_rg$b_table", {{'b', Bits}});
template <int Bits>
inline constexpr auto encode_rg_table_text = detail::fill<1024>(R"GLSL(
// umbrage_encode_rg$b_table: depth to the two channels of a $b-bit code through a look-up table, whole numbers 0..255
//   table   $w x $h texels, row after row, nearest filter;   depth   clamped to [0, 1], NaN counts as 1
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
                                                                 {'w', unsigned(rg_table_size<Bits>.x)},
                                                                 {'h', unsigned(rg_table_size<Bits>.y)}});
template <int Bits>
inline constexpr snippet encode_rg_table{.name = encode_rg_table_name<Bits>.view(),
                                         .summary = "depth to two channels through a look-up texture",
                                         .exactness = tier::a,
                                         .needs = {&saturate, &from_unorm, &fetch_clamped},
                                         .source = encode_rg_table_text<Bits>.view()};

}  // namespace glsl
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
/// @param depth   clamped to [0, 1]; NaN counts as 1
/// @return        integer channels 0..255, R most significant
/// @formula       the bytes of min(floor(depth 2^24), 2^24 - 1)
/// @exactness     A
template <real T>
[[nodiscard]] constexpr glm::u8vec3 encode_rgb24(T depth) {
    const std::uint32_t x = depth_code<24>(depth);
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
    return code_depth<24>((k.x * T(256) + k.y) * T(256) + k.z, edge);
}

/// Bytes to depth.
template <real T>
[[nodiscard]] constexpr T decode_rgb24(glm::u8vec3 texel, T edge) {
    return code_depth<24>(T((texel.x << 16) + (texel.y << 8) + texel.z), edge);
}

/// The encoding as a value, for functions over images.
struct rgb24 {
    using texel = glm::u8vec3;
    static constexpr int bits = 24;
    static constexpr std::uint32_t codes = std::uint32_t(1) << 24;
    static constexpr double max_error = 1.0 / codes;

    float edge = upper_edge<float>;

    [[nodiscard]] constexpr texel encode(float depth) const { return encode_rgb24(depth); }
    [[nodiscard]] constexpr float decode(texel t) const { return decode_rgb24(t, edge); }
};

namespace glsl {

inline constexpr snippet encode_rgb24{
    .name = "encode_rgb24", .summary = "depth to three channels, R most significant", .exactness = tier::a,
    .needs = {&saturate}, .source = R"GLSL(
// umbrage_encode_rgb24: depth to three channels, R most significant, whole numbers 0..255 (umbrage_to_unorm writes them)
//   depth   clamped to [0, 1], NaN counts as 1
UMBRAGE_HIGHP vec3 umbrage_encode_rgb24(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float x = min(floor(umbrage_saturate(depth) * 16777216.0), 16777215.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 65536.0));
    UMBRAGE_HIGHP float rest = x - high * 65536.0;
    UMBRAGE_HIGHP float middle = floor(rest * (1.0 / 256.0));
    return vec3(high, middle, rest - middle * 256.0);
}
)GLSL"};

inline constexpr snippet decode_rgb24{
    .name = "decode_rgb24", .summary = "three channels, R most significant, to depth", .exactness = tier::a,
    .needs = {&from_unorm}, .source = R"GLSL(
// umbrage_decode_rgb24: three channels, as sampled, to depth
//   edge   0.0 or 1.0: lower or upper edge of the code's interval
UMBRAGE_HIGHP float umbrage_decode_rgb24(UMBRAGE_HIGHP vec3 c, UMBRAGE_HIGHP float edge) {
    UMBRAGE_HIGHP vec3 k = umbrage_from_unorm(c);
    return ((k.x * 256.0 + k.y) * 256.0 + k.z + edge) * (1.0 / 16777216.0);
}
)GLSL"};

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/depth/three.hpp
// The depth formats of three.js, to read and write its maps: RGBA, RGB and RG of r167 and later, and the RGBA layout
// of r73 to r166. Writers give UNORM values as three.js does; what the 8-bit store makes of the channels that hold a
// fraction is part of the format.
//
//     glm::u8vec4 texel = umbrage::store_unorm8(umbrage::encode_three_rgba(depth));
//     float stored = umbrage::decode_three_rgba(umbrage::load_unorm8(texel));
//
// Worst error of any binary32 depth, and the faults, as measured by the tests:
//
//     format             store rounds     store truncates   faults
//     rgba               2^-32            2^-31.99          none
//     rgb                2^-24            2^-23.99          none
//     rg                 2^-16.99         2^-15.99          none
//     legacy             2^-32, below 1   2^-32, below 1    1.0 decodes to 255/256, below depths that come before it
//     legacy, repaired   2^-24            2^-24             none
//

namespace umbrage {

/// Three whole bytes, R most significant, and the fraction that is left in A.
/// @param depth   clamped to [0, 1]; NaN counts as 1; 1 gives all ones
/// @return        UNORM values
/// @exactness     B
/// @cite          three.js r167 and later, packing chunk (format)
template <real T>
[[nodiscard]] glm::vec<4, T> encode_three_rgba(T depth) {
    const T v = saturate(depth);
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
[[nodiscard]] constexpr T decode_three_rgba(glm::vec<4, T> c) {
    return c.x * T(255.0 / 256.0) + c.y * T(255.0 / 65536.0) + c.z * T(255.0 / 16777216.0) + c.w * T(1.0 / 16777216.0);
}

/// Two whole bytes and the fraction that is left in B.  @exactness B  @cite three.js r167 and later (format)
template <real T>
[[nodiscard]] glm::vec<3, T> encode_three_rgb(T depth) {
    const T v = saturate(depth);
    if (!(v < T(1))) return glm::vec<3, T>(1);
    const T x = v * T(65536);
    const T whole = std::floor(x);
    const T high = std::floor(whole * T(1.0 / 256.0));
    return {high * T(1.0 / 255.0), (whole - high * T(256)) * T(1.0 / 255.0), x - whole};
}

/// @formula      255/256 (R + G/2^8) + B/2^16       @exactness B
template <real T>
[[nodiscard]] constexpr T decode_three_rgb(glm::vec<3, T> c) {
    return c.x * T(255.0 / 256.0) + c.y * T(255.0 / 65536.0) + c.z * T(1.0 / 65536.0);
}

/// One whole byte and the fraction that is left in G.  @exactness B  @cite three.js r167 and later (format)
template <real T>
[[nodiscard]] glm::vec<2, T> encode_three_rg(T depth) {
    const T v = saturate(depth);
    if (!(v < T(1))) return glm::vec<2, T>(1);
    const T x = v * T(256);
    const T whole = std::floor(x);
    return {whole * T(1.0 / 255.0), x - whole};
}

/// @formula      255/256 R + G/2^8                  @exactness B
template <real T>
[[nodiscard]] constexpr T decode_three_rg(glm::vec<2, T> c) {
    return c.x * T(255.0 / 256.0) + c.y * T(1.0 / 256.0);
}

/// The layout of r73 to r166: A most significant, channels scaled by 256/255.
/// @return        UNORM values; A exceeds 1 for depth > 255/256, and the store clamps it: the fault of the format
/// @exactness     B
/// @cite          three.js r73 to r166, packing chunk (format)
template <real T>
[[nodiscard]] glm::vec<4, T> encode_three_legacy(T depth) {
    const T v = saturate(depth);
    const T x = v * T(16777216) - std::floor(v * T(16777216));
    const T y = v * T(65536) - std::floor(v * T(65536));
    const T z = v * T(256) - std::floor(v * T(256));
    return {x * T(256.0 / 255.0), (y - x * T(1.0 / 256.0)) * T(256.0 / 255.0), (z - y * T(1.0 / 256.0)) * T(256.0 / 255.0),
            (v - z * T(1.0 / 256.0)) * T(256.0 / 255.0)};
}

/// @formula      255/256 (A + B/2^8 + G/2^16 + R/2^24)   @exactness B
template <real T>
[[nodiscard]] constexpr T decode_three_legacy(glm::vec<4, T> c) {
    return c.x * T(255.0 / 4294967296.0) + c.y * T(255.0 / 16777216.0) + c.z * T(255.0 / 65536.0) + c.w * T(255.0 / 256.0);
}

/// A writer without the fault, for decode_three_legacy on the other side: 24 bits, and 1 decodes to 1.
/// @return        integer channels 0..255 (to_unorm writes them), A most significant
/// @exactness     A
template <real T>
[[nodiscard]] constexpr glm::u8vec4 encode_three_legacy_repaired(T depth) {
    const T v = saturate(depth);
    if (!(v < T(1))) return glm::u8vec4(255);
    const std::uint32_t x = depth_code<24>(v);
    return {0, static_cast<std::uint8_t>(x & 0xFF), static_cast<std::uint8_t>(x >> 8 & 0xFF),
            static_cast<std::uint8_t>(x >> 16)};
}

// The formats as values, for functions over images; the store rounds.

/// RGBA, r167 and later.
struct three_rgba {
    using texel = glm::u8vec4;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 32;
    static constexpr double max_error = 0x1p-32;  ///< where the store truncates, 256/255 of it

    [[nodiscard]] texel encode(float depth) const { return store_unorm8(encode_three_rgba(depth)); }
    [[nodiscard]] float decode(texel t) const { return decode_three_rgba(load_unorm8(t)); }
};

/// RGB, r167 and later.
struct three_rgb {
    using texel = glm::u8vec3;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 24;
    static constexpr double max_error = 0x1p-24;  ///< where the store truncates, 256/255 of it

    [[nodiscard]] texel encode(float depth) const { return store_unorm8(encode_three_rgb(depth)); }
    [[nodiscard]] float decode(texel t) const { return decode_three_rgb(load_unorm8(t)); }
};

/// RG, r167 and later.
struct three_rg {
    using texel = glm::u8vec2;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 16;
    static constexpr double max_error = 0x1.02p-17;  ///< 2^-16 * 256/255 where the store truncates

    [[nodiscard]] texel encode(float depth) const { return store_unorm8(encode_three_rg(depth)); }
    [[nodiscard]] float decode(texel t) const { return decode_three_rg(load_unorm8(t)); }
};

/// RGBA, r73 to r166, fault and all.
struct three_legacy {
    using texel = glm::u8vec4;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 32;
    static constexpr double max_error = 1.0 / 256.0;  ///< at 1.0; below it 2^-32

    [[nodiscard]] texel encode(float depth) const { return store_unorm8(encode_three_legacy(depth)); }
    [[nodiscard]] float decode(texel t) const { return decode_three_legacy(load_unorm8(t)); }
};

/// RGBA for readers of r73 to r166, written without the fault.
struct three_legacy_repaired {
    using texel = glm::u8vec4;
    static constexpr std::uint64_t codes = std::uint64_t(1) << 24;
    static constexpr double max_error = 0x1p-24;  ///< whether the store rounds or truncates

    [[nodiscard]] texel encode(float depth) const { return encode_three_legacy_repaired(depth); }
    [[nodiscard]] float decode(texel t) const { return decode_three_legacy(load_unorm8(t)); }
};

namespace glsl {

inline constexpr snippet encode_three_rgba{
    .name = "encode_three_rgba", .summary = "depth to three.js RGBA, r167 and later", .exactness = tier::b,
    .needs = {&saturate}, .source = R"GLSL(
// umbrage_encode_three_rgba: depth to the RGBA format of three.js r167 and later, values to write as they are
UMBRAGE_HIGHP vec4 umbrage_encode_three_rgba(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    if (!(v < 1.0)) return vec4(1.0, 1.0, 1.0, 1.0);
    UMBRAGE_HIGHP float x = v * 16777216.0;
    UMBRAGE_HIGHP float whole = floor(x);
    UMBRAGE_HIGHP float high = floor(whole * (1.0 / 65536.0));
    UMBRAGE_HIGHP float rest = whole - high * 65536.0;
    UMBRAGE_HIGHP float middle = floor(rest * (1.0 / 256.0));
    UMBRAGE_HIGHP float low = rest - middle * 256.0;
    return vec4(high * 0.00392156886, middle * 0.00392156886, low * 0.00392156886, x - whole);
}
)GLSL"};

inline constexpr snippet decode_three_rgba{
    .name = "decode_three_rgba", .summary = "three.js RGBA, r167 and later, to depth", .exactness = tier::b,
    .source = R"GLSL(
// umbrage_decode_three_rgba: the RGBA format of three.js r167 and later, as sampled, to depth
UMBRAGE_HIGHP float umbrage_decode_three_rgba(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) +
                                                c.z * (255.0 / 16777216.0) + c.w * (1.0 / 16777216.0);
    return depth;
}
)GLSL"};

inline constexpr snippet encode_three_rgb{
    .name = "encode_three_rgb", .summary = "depth to three.js RGB, r167 and later", .exactness = tier::b,
    .needs = {&saturate}, .source = R"GLSL(
// umbrage_encode_three_rgb: depth to the RGB format of three.js r167 and later, values to write as they are
UMBRAGE_HIGHP vec3 umbrage_encode_three_rgb(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    if (!(v < 1.0)) return vec3(1.0, 1.0, 1.0);
    UMBRAGE_HIGHP float x = v * 65536.0;
    UMBRAGE_HIGHP float whole = floor(x);
    UMBRAGE_HIGHP float high = floor(whole * (1.0 / 256.0));
    return vec3(high * 0.00392156886, (whole - high * 256.0) * 0.00392156886, x - whole);
}
)GLSL"};

inline constexpr snippet decode_three_rgb{
    .name = "decode_three_rgb", .summary = "three.js RGB, r167 and later, to depth", .exactness = tier::b,
    .source = R"GLSL(
// umbrage_decode_three_rgb: the RGB format of three.js r167 and later, as sampled, to depth
UMBRAGE_HIGHP float umbrage_decode_three_rgb(UMBRAGE_HIGHP vec3 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth =
        c.x * (255.0 / 256.0) + c.y * (255.0 / 65536.0) + c.z * (1.0 / 65536.0);
    return depth;
}
)GLSL"};

inline constexpr snippet encode_three_rg{
    .name = "encode_three_rg", .summary = "depth to three.js RG, r167 and later", .exactness = tier::b,
    .needs = {&saturate}, .source = R"GLSL(
// umbrage_encode_three_rg: depth to the RG format of three.js r167 and later, values to write as they are
UMBRAGE_HIGHP vec2 umbrage_encode_three_rg(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    if (!(v < 1.0)) return vec2(1.0, 1.0);
    UMBRAGE_HIGHP float x = v * 256.0;
    UMBRAGE_HIGHP float whole = floor(x);
    return vec2(whole * 0.00392156886, x - whole);
}
)GLSL"};

inline constexpr snippet decode_three_rg{
    .name = "decode_three_rg", .summary = "three.js RG, r167 and later, to depth", .exactness = tier::b,
    .source = R"GLSL(
// umbrage_decode_three_rg: the RG format of three.js r167 and later, as sampled, to depth
UMBRAGE_HIGHP float umbrage_decode_three_rg(UMBRAGE_HIGHP vec2 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = c.x * (255.0 / 256.0) + c.y * (1.0 / 256.0);
    return depth;
}
)GLSL"};

inline constexpr snippet encode_three_legacy{
    .name = "encode_three_legacy", .summary = "depth to three.js RGBA, r73 to r166", .exactness = tier::b,
    .needs = {&saturate}, .source = R"GLSL(
// umbrage_encode_three_legacy: depth to the RGBA format of three.js r73 to r166, values to write as they are;
//   1.0 reads back as 255/256: umbrage_encode_three_legacy_repaired does not
UMBRAGE_HIGHP vec4 umbrage_encode_three_legacy(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    UMBRAGE_HIGHP float x = v * 16777216.0 - floor(v * 16777216.0);
    UMBRAGE_HIGHP float y = v * 65536.0 - floor(v * 65536.0);
    UMBRAGE_HIGHP float z = v * 256.0 - floor(v * 256.0);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 c = vec4(x, y - x * (1.0 / 256.0), z - y * (1.0 / 256.0), v - z * (1.0 / 256.0));
    return c * 1.00392163;
}
)GLSL"};

inline constexpr snippet decode_three_legacy{
    .name = "decode_three_legacy", .summary = "three.js RGBA, r73 to r166, to depth", .exactness = tier::b,
    .source = R"GLSL(
// umbrage_decode_three_legacy: the RGBA format of three.js r73 to r166, as sampled, to depth
UMBRAGE_HIGHP float umbrage_decode_three_legacy(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = c.x * (255.0 / 4294967296.0) + c.y * (255.0 / 16777216.0) +
                                                c.z * (255.0 / 65536.0) + c.w * (255.0 / 256.0);
    return depth;
}
)GLSL"};

inline constexpr snippet encode_three_legacy_repaired{
    .name = "encode_three_legacy_repaired", .summary = "depth for readers of three.js RGBA, r73 to r166, 1.0 repaired",
    .exactness = tier::a, .needs = {&saturate}, .source = R"GLSL(
// umbrage_encode_three_legacy_repaired: depth to channels that readers of three.js r73 to r166 decode, 1.0 to 1.0;
//   whole numbers 0..255 (umbrage_to_unorm writes them)
UMBRAGE_HIGHP vec4 umbrage_encode_three_legacy_repaired(UMBRAGE_HIGHP float depth) {
    UMBRAGE_HIGHP float v = umbrage_saturate(depth);
    if (!(v < 1.0)) return vec4(255.0, 255.0, 255.0, 255.0);
    UMBRAGE_HIGHP float x = floor(v * 16777216.0);
    UMBRAGE_HIGHP float high = floor(x * (1.0 / 65536.0));
    UMBRAGE_HIGHP float rest = x - high * 65536.0;
    UMBRAGE_HIGHP float middle = floor(rest * (1.0 / 256.0));
    return vec4(0.0, rest - middle * 256.0, middle, high);
}
)GLSL"};

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/texel_space.hpp
// What every filter over a map shares: the range of its coordinates and its macros in GLSL.
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

/// Stored depth of a texel: the fetch callable of every filter, by name.
/// @param fetch   ivec2 texel -> depth, e.g. clamped(map), or decoded(map, rg<11>{}) for packed maps
template <class Fetch>
[[nodiscard]] constexpr auto fetch_depth(Fetch&& fetch, glm::ivec2 texel) {
    return fetch(texel);
}

/// A packed map as the fetch callable that filters take.
/// @param encoding   rg<Bits>, rgb24, float_bits, depth32f
/// @throws std::invalid_argument  empty map
template <class Texel, class Encoding>
[[nodiscard]] auto decoded(image_view<Texel> map, Encoding encoding) {
    return [fetch = clamped(map), encoding](glm::ivec2 texel) { return encoding.decode(fetch(texel)); };
}
template <class Texel, class Encoding>
[[nodiscard]] auto decoded(const image<Texel>& map, Encoding encoding) {
    return decoded(map.view(), encoding);
}

namespace glsl {

inline constexpr snippet inside_texel_space{
    .name = "inside_texel_space", .summary = "coordinates a filter can take", .exactness = tier::a,
    .source = R"GLSL(
// umbrage_inside_texel_space: coordinates in texels that a filter can take; it takes all others, NaN included, as lit
bool umbrage_inside_texel_space(UMBRAGE_HIGHP vec2 coord) {
    // two limits on purpose: Mesa makes max(x, y) < limit of one, which loses a NaN
    return abs(coord.x) < 32768.0 && abs(coord.y) * 2.0 < 65536.0;
}
)GLSL"};

/// UMBRAGE_FETCH, the depth behind a texel: define it beforehand for packed maps, arrays, borders.
inline constexpr snippet fetch_depth{
    .name = "fetch_depth", .summary = "stored depth of a texel, as a macro to redefine", .exactness = tier::a,
    .needs = {&fetch_clamped}, .source = R"GLSL(
// UMBRAGE_FETCH: stored depth of a texel; define it beforehand for packed maps, arrays, borders
#ifndef UMBRAGE_FETCH
#define UMBRAGE_FETCH(map, size, texel) umbrage_fetch_clamped(map, size, texel).x
#endif
// umbrage_fetch_depth: stored depth of a texel
UMBRAGE_HIGHP float umbrage_fetch_depth(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    return UMBRAGE_FETCH(map, size, texel);
}
)GLSL"};

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/box.hpp
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
/// @param receiver   depth, biased; NaN is in shadow
/// @param radius     r, clamped to 0..8
/// @return           0 .. (2r+1)^2
/// @formula          sum over |i|, |j| <= r of [receiver <= fetch(floor(coord) + (i, j))]
/// @exactness        A: counts
/// @cite             Reeves, Salesin, Cook: Rendering antialiased shadows with depth maps, SIGGRAPH 1987
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T box_count(Fetch&& fetch, glm::vec<2, T> coord, T receiver, int radius, Compare is_lit = {}) {
    const int r = radius < 0 ? 0 : (radius < max_box_radius ? radius : max_box_radius);
    if (!inside_texel_space(coord)) return T((2 * r + 1) * (2 * r + 1));
    const glm::ivec2 texel(glm::floor(coord));
    int count = 0;
    for (int j = -r; j <= r; ++j)
        for (int i = -r; i <= r; ++i) count += is_lit(receiver, T(fetch(texel + glm::ivec2(i, j)))) ? 1 : 0;
    return T(count);
}

namespace detail {
template <real T>  // quotients of the compiler's: a run-time division would follow the rounding mode and -ffast-math
inline constexpr std::array<T, max_box_radius + 1> box_scales{
    T(1), T(1) / T(9), T(1) / T(25), T(1) / T(49), T(1) / T(81), T(1) / T(121), T(1) / T(169), T(1) / T(225), T(1) / T(289)};
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
    .name = "box_count", .summary = "lit texels in a box of radius 0..8", .exactness = tier::a,
    .needs = {&compare, &inside_texel_space, &fetch_depth}, .source = R"GLSL(
// umbrage_box_count: lit texels in the (2r+1) x (2r+1) box around the receiver's own, a whole number
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased;   radius  r, clamped to 0..8, best a constant
UMBRAGE_HIGHP float umbrage_box_count(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                      UMBRAGE_HIGHP float receiver, int radius) {
    int r = radius < 0 ? 0 : (radius < 8 ? radius : 8);
    int width = 2 * r + 1;
    if (!umbrage_inside_texel_space(coord)) return float(width * width);
    UMBRAGE_HIGHP vec2 first = floor(coord) - float(r);
    UMBRAGE_HIGHP float count = 0.0;
    for (int j = 0; j < 17; j++) {
        if (j >= width) break;
        for (int i = 0; i < 17; i++) {
            if (i >= width) break;
            count += UMBRAGE_LIT(receiver, UMBRAGE_FETCH(map, size, first + vec2(float(i), float(j))));
        }
    }
    return count;
}
)GLSL"};

inline constexpr snippet box_scale{
    .name = "box_scale", .summary = "1 / (2r+1)^2", .exactness = tier::a, .source = R"GLSL(
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
)GLSL"};

inline constexpr snippet box{
    .name = "box", .summary = "lit share of a box of radius 0..8", .exactness = tier::b,
    .needs = {&box_count, &box_scale}, .source = R"GLSL(
// umbrage_box: lit share of a (2r+1) x (2r+1) box; visibility, 1.0 is lit; arguments as for umbrage_box_count
UMBRAGE_HIGHP float umbrage_box(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                UMBRAGE_HIGHP float receiver, int radius) {
    UMBRAGE_HIGHP float visibility = umbrage_box_count(map, size, coord, receiver, radius) * umbrage_box_scale(radius);
    return visibility < 0.999 ? visibility : 1.0;  // 121 times the rounded 1/121 is not 1
}
)GLSL"};

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/hard.hpp
// The unfiltered shadow test: one texel, one comparison.
//
//     float visibility = umbrage::hard(umbrage::clamped(map), coord, depth - bias);
//

namespace umbrage {

/// @param fetch      ivec2 texel -> stored depth; called once
/// @param coord      receiver in texels, the first texel's centre is (0.5, 0.5); outside texel space, or NaN: lit
/// @param receiver   depth, biased; NaN is in shadow
/// @return           1 lit, 0 in shadow
/// @formula          [receiver <= fetch(floor(coord))]
/// @exactness        A
/// @cite             Williams: Casting curved shadows on curved surfaces, SIGGRAPH 1978
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T hard(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    if (!inside_texel_space(coord)) return T(1);
    return compare(receiver, T(fetch(glm::ivec2(glm::floor(coord)))), is_lit);
}

namespace glsl {

inline constexpr snippet hard{
    .name = "hard", .summary = "nearest texel, one test", .exactness = tier::a,
    .needs = {&compare, &inside_texel_space, &fetch_depth}, .source = R"GLSL(
// umbrage_hard: unfiltered shadow test; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_hard(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                 UMBRAGE_HIGHP float receiver) {
    bool inside = umbrage_inside_texel_space(coord);
    UMBRAGE_HIGHP vec2 texel = inside ? floor(coord) : vec2(0.0, 0.0);  // no branch: fetches of several taps overlap
    UMBRAGE_HIGHP float lit = UMBRAGE_LIT(receiver, UMBRAGE_FETCH(map, size, texel));
    return inside ? lit : 1.0;
}
)GLSL"};

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/four_tap.hpp
// Percentage-closer filtering over four taps with coordinates of their own, as the Radeon 8500 did it: one texture
// matrix per tap (tap_matrices), four nearest fetches, four tests, the mean.
//
//     float visibility = umbrage::four_tap(umbrage::clamped(map), a, b, c, d, depth - bias);
//

namespace umbrage {

/// @param fetch        ivec2 texel -> stored depth; called up to four times
/// @param a, b, c, d   the taps in texels; a tap outside texel space, or NaN, is lit
/// @param receiver     depth, biased; NaN is in shadow
/// @return             visibility: 0, 1/4, 1/2, 3/4 or 1
/// @formula            mean of hard() at the four taps
/// @exactness          A
/// @cite               Reeves, Salesin, Cook 1987; ATI Radeon SDK, ShadowMap sample, 2002
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T four_tap(Fetch&& fetch, glm::vec<2, T> a, glm::vec<2, T> b, glm::vec<2, T> c, glm::vec<2, T> d,
                         T receiver, Compare is_lit = {}) {
    return (hard(fetch, a, receiver, is_lit) + hard(fetch, b, receiver, is_lit) + hard(fetch, c, receiver, is_lit) +
            hard(fetch, d, receiver, is_lit)) *
           T(0.25);
}

namespace glsl {

inline constexpr snippet four_tap{
    .name = "four_tap", .summary = "mean of four taps with coordinates of their own", .exactness = tier::a,
    .needs = {&hard}, .source = R"GLSL(
// umbrage_four_tap: mean of the shadow test at four taps; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   a, b, c, d  taps in texels;   receiver  depth, biased
UMBRAGE_HIGHP float umbrage_four_tap(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 a,
                                     UMBRAGE_HIGHP vec2 b, UMBRAGE_HIGHP vec2 c, UMBRAGE_HIGHP vec2 d,
                                     UMBRAGE_HIGHP float receiver) {
    return (umbrage_hard(map, size, a, receiver) + umbrage_hard(map, size, b, receiver) +
            umbrage_hard(map, size, c, receiver) + umbrage_hard(map, size, d, receiver)) * 0.25;
}
)GLSL"};

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/filter/pcf_2x2.hpp
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
/// @param receiver   depth, biased; NaN is in shadow
/// @return           visibility, a multiple of 2^-16: 0 in shadow, 1 lit
/// @formula          sum of w_i [receiver <= fetch(texel_i)], w the bilinear weights in steps of 1/256
/// @exactness        A: integers below 2^24 times a power of two
/// @cite             Reeves, Salesin, Cook: Rendering antialiased shadows with depth maps, SIGGRAPH 1987
template <real T, class Fetch, class Compare = less_equal>
[[nodiscard]] T pcf_2x2(Fetch&& fetch, glm::vec<2, T> coord, T receiver, Compare is_lit = {}) {
    if (!inside_texel_space(coord)) return T(1);
    const glm::vec<2, T> x = glm::floor(coord * T(256)) - T(128);  // position between texel centres, in 1/256 texel
    const glm::vec<2, T> texel = glm::floor(x * T(1.0 / 256.0));
    const glm::vec<2, T> hi = x - texel * T(256);                  // weight of the farther texel, 0..255
    const glm::vec<2, T> lo = T(256) - hi;
    const auto lit = [&](int i, int j) {
        return compare(receiver, T(fetch(glm::ivec2(texel) + glm::ivec2(i, j))), is_lit);
    };
    return (lo.y * (lo.x * lit(0, 0) + hi.x * lit(1, 0)) + hi.y * (lo.x * lit(0, 1) + hi.x * lit(1, 1))) *
           T(1.0 / 65536.0);
}

/// The DirectX SDK's form: weights in full floats, linear interpolation, the epsilon inside. The sample relies on
/// Direct3D 9 putting pixel centres at whole numbers; here coord is as everywhere else, and the half texel is taken off.
///
/// @param fetch      ivec2 texel -> stored depth; called four times
/// @param coord      receiver in texels, the first texel's centre is (0.5, 0.5); outside texel space, or NaN: lit
/// @param receiver   depth, not biased
/// @param epsilon    in depth, added to the stored side of each comparison
/// @return           visibility, 0 in shadow, 1 lit
/// @formula          lerp of compare_dx_sdk over x, then y, at coord - 1/2
/// @exactness        B
/// @cite             Microsoft DirectX SDK, ShadowMap sample
template <real T, class Fetch>
[[nodiscard]] T pcf_2x2_dx_sdk(Fetch&& fetch, glm::vec<2, T> coord, T receiver, T epsilon) {
    if (!inside_texel_space(coord)) return T(1);
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
    .name = "pcf_2x2", .summary = "bilinear 2x2, weights in steps of 1/256", .exactness = tier::a,
    .needs = {&compare, &inside_texel_space, &fetch_depth}, .source = R"GLSL(
// umbrage_pcf_2x2: bilinear percentage-closer filtering; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, biased
UMBRAGE_HIGHP float umbrage_pcf_2x2(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                    UMBRAGE_HIGHP float receiver) {
    if (!umbrage_inside_texel_space(coord)) return 1.0;
    UMBRAGE_HIGHP vec2 x = floor(coord * 256.0) - 128.0;
    UMBRAGE_HIGHP vec2 texel = floor(x * (1.0 / 256.0));
    UMBRAGE_HIGHP vec2 hi = x - texel * 256.0;
    UMBRAGE_HIGHP vec2 lo = 256.0 - hi;
    UMBRAGE_HIGHP float a = UMBRAGE_LIT(receiver, UMBRAGE_FETCH(map, size, texel));
    UMBRAGE_HIGHP float b = UMBRAGE_LIT(receiver, UMBRAGE_FETCH(map, size, texel + vec2(1.0, 0.0)));
    UMBRAGE_HIGHP float c = UMBRAGE_LIT(receiver, UMBRAGE_FETCH(map, size, texel + vec2(0.0, 1.0)));
    UMBRAGE_HIGHP float d = UMBRAGE_LIT(receiver, UMBRAGE_FETCH(map, size, texel + vec2(1.0, 1.0)));
    return (lo.y * (lo.x * a + hi.x * b) + hi.y * (lo.x * c + hi.x * d)) * (1.0 / 65536.0);
}
)GLSL"};

inline constexpr snippet pcf_2x2_dx_sdk{
    .name = "pcf_2x2_dx_sdk", .summary = "bilinear 2x2 as the DirectX SDK sample, plain floats", .exactness = tier::b,
    .needs = {&compare_dx_sdk, &inside_texel_space, &fetch_depth}, .source = R"GLSL(
// umbrage_pcf_2x2_dx_sdk: the DirectX SDK sample's 2x2 filter; visibility, 1.0 is lit
//   map, size  shadow map and its size in texels;   coord  receiver in texels, first centre at (0.5, 0.5)
//   receiver   depth, not biased;   epsilon  in depth, added to the stored side
UMBRAGE_HIGHP float umbrage_pcf_2x2_dx_sdk(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 coord,
                                           UMBRAGE_HIGHP float receiver, UMBRAGE_HIGHP float epsilon) {
    if (!umbrage_inside_texel_space(coord)) return 1.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 x = coord - 0.5;
    UMBRAGE_HIGHP vec2 texel = floor(x);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 weight = x - texel;
    UMBRAGE_HIGHP float a = umbrage_compare_dx_sdk(receiver, UMBRAGE_FETCH(map, size, texel), epsilon);
    UMBRAGE_HIGHP float b = umbrage_compare_dx_sdk(receiver, UMBRAGE_FETCH(map, size, texel + vec2(1.0, 0.0)), epsilon);
    UMBRAGE_HIGHP float c = umbrage_compare_dx_sdk(receiver, UMBRAGE_FETCH(map, size, texel + vec2(0.0, 1.0)), epsilon);
    UMBRAGE_HIGHP float d = umbrage_compare_dx_sdk(receiver, UMBRAGE_FETCH(map, size, texel + vec2(1.0, 1.0)), epsilon);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float low = a + weight.x * (b - a);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float high = c + weight.x * (d - c);
    UMBRAGE_PRECISE UMBRAGE_HIGHP float visibility = low + weight.y * (high - low);
    return visibility;
}
)GLSL"};

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/light/light_space.hpp
// A light's view of the world: two matrices and the convention they follow.
//
//     auto light = umbrage::make_spot_light({.position = {0, 5, 0}, .direction = {0, -1, 0}});
//     glm::mat4 clip_from_world = light.projection * light.view;
//

namespace umbrage {

template <real T>
struct light_space {
    glm::mat<4, 4, T> view{T(1)};        ///< world -> light's view space, looking down -z (right) or +z (left)
    glm::mat<4, 4, T> projection{T(1)};  ///< view space -> clip space
    clip_space clip;
};

namespace detail {

/// Unit vector; scaled first, so that nothing overflows or underflows. Zero stays zero.
template <real T>
[[nodiscard]] glm::vec<3, T> unit(glm::vec<3, T> v) {
    const T scale = glm::max(glm::max(glm::abs(v.x), glm::abs(v.y)), glm::abs(v.z));
    return scale > T(0) ? glm::normalize(v / scale) : v;
}

}  // namespace detail

/// World to light's view space: x to the right, y up, whichever hand, so that a mesh keeps its winding.
///
/// @param position    of the light, world
/// @param direction   it looks along, any length > 0
/// @param up          hint; where it is parallel to direction, or nearly (1e-3), the world axis least along direction
///                    takes its place, so that any direction works
/// @param hand        right: looks down -z, left: down +z
/// @throws std::invalid_argument  zero or non-finite direction or position
template <real T>
[[nodiscard]] glm::mat<4, 4, T> look_along(glm::vec<3, T> position, glm::vec<3, T> direction, glm::vec<3, T> up,
                                           handedness hand) {
    for (int i = 0; i < 3; ++i)
        if (!is_finite(position[i]) || !is_finite(direction[i]) || !is_finite(up[i]))
            throw std::invalid_argument("umbrage: a light's position, direction and up must be finite");
    const glm::vec<3, T> forward = detail::unit(direction);
    if (forward == glm::vec<3, T>(0)) throw std::invalid_argument("umbrage: a light's direction must not be zero");

    glm::vec<3, T> side = glm::cross(forward, detail::unit(up));
    if (!(glm::length(side) > T(1e-3))) {
        const glm::vec<3, T> along = glm::abs(forward);
        const int least = along.x <= along.y && along.x <= along.z ? 0 : (along.z <= along.y ? 2 : 1);
        glm::vec<3, T> axis(0);
        axis[least] = T(1);
        side = glm::cross(forward, axis);
    }
    const glm::vec<3, T> above = glm::normalize(glm::cross(side, forward));
    side = glm::cross(forward, above);  // again: up nearly parallel to forward leaves the first a hundred ulp askew
    const glm::vec<3, T> depth = hand == handedness::right ? -forward : forward;

    glm::mat<4, 4, T> view(T(1));
    for (int i = 0; i < 3; ++i) {
        view[i][0] = side[i];
        view[i][1] = above[i];
        view[i][2] = depth[i];
    }
    view[3][0] = -glm::dot(side, position);
    view[3][1] = -glm::dot(above, position);
    view[3][2] = -glm::dot(depth, position);
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

template <real T>
void check_planes(T z_near, T z_far) {
    if (!is_finite(z_near) || !is_finite(z_far) || !(z_near < z_far))
        throw std::invalid_argument("umbrage: a light needs finite z_near < z_far");
}

}  // namespace detail

/// Perspective projection.
///
/// @param tan_half_x, tan_half_y   tangent of half the opening angle, > 0
/// @param z_near, z_far            0 < z_near < z_far, world units
/// @throws std::invalid_argument   anything else
/// @formula       z/w = A + B / distance through (z_near, near depth), (z_far, far depth)
template <real T>
[[nodiscard]] glm::mat<4, 4, T> perspective(T tan_half_x, T tan_half_y, T z_near, T z_far, clip_space clip) {
    detail::check_planes(z_near, z_far);
    if (!(z_near > T(0))) throw std::invalid_argument("umbrage: a perspective light needs z_near > 0");
    if (!is_finite(tan_half_x) || !is_finite(tan_half_y) || !(tan_half_x > T(0)) || !(tan_half_y > T(0)))
        throw std::invalid_argument(
            "umbrage: a perspective light needs an opening angle above 0 and below 180 degrees");
    const auto [at_near, at_far] = detail::ends<T>(clip);
    const T forward = clip.hand == handedness::right ? T(-1) : T(1);
    glm::mat<4, 4, T> m(T(0));
    m[0][0] = T(1) / tan_half_x;
    m[1][1] = T(1) / tan_half_y;
    m[2][2] = forward * (z_far * at_far - z_near * at_near) / (z_far - z_near);
    m[3][2] = z_near * z_far * (at_near - at_far) / (z_far - z_near);
    m[2][3] = forward;
    return m;
}

/// Orthographic projection of the box between two corners of view space, z given as distances in front of the light.
///
/// @param low, high        x and y of the corners, low < high
/// @param z_near, z_far    z_near < z_far, world units, may be negative (behind the light's position)
/// @throws std::invalid_argument   an empty or non-finite box
template <real T>
[[nodiscard]] glm::mat<4, 4, T> orthographic(glm::vec<2, T> low, glm::vec<2, T> high, T z_near, T z_far,
                                             clip_space clip) {
    detail::check_planes(z_near, z_far);
    for (int i = 0; i < 2; ++i)
        if (!is_finite(low[i]) || !is_finite(high[i]) || !(low[i] < high[i]))
            throw std::invalid_argument("umbrage: an orthographic light needs a box with some width and height");
    const auto [at_near, at_far] = detail::ends<T>(clip);
    const T forward = clip.hand == handedness::right ? T(-1) : T(1);
    glm::mat<4, 4, T> m(T(1));
    for (int i = 0; i < 2; ++i) {
        m[i][i] = T(2) / (high[i] - low[i]);
        m[3][i] = -(high[i] + low[i]) / (high[i] - low[i]);
    }
    m[2][2] = forward * (at_far - at_near) / (z_far - z_near);
    m[3][2] = (z_far * at_near - z_near * at_far) / (z_far - z_near);
    return m;
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
/// @throws std::invalid_argument  map_size below 1
template <real T>
[[nodiscard]] glm::mat<4, 4, T> texture_matrix(const light_space<T>& light, glm::ivec2 map_size) {
    if (map_size.x < 1 || map_size.y < 1) throw std::invalid_argument("umbrage::texture_matrix: map_size below 1");
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
    return scale_bias * light.projection * light.view;
}

/// The same to [0, 1]: what texture look-ups with normalised coordinates take.
template <real T>
[[nodiscard]] glm::mat<4, 4, T> texture_matrix_uv(const light_space<T>& light) {
    return texture_matrix(light, {1, 1});
}

/// The taps of the 2002 sample: half a texel off in both directions.
template <real T>
inline constexpr std::array<glm::vec<2, T>, 4> default_taps{
    {{T(-0.5), T(-0.5)}, {T(0.5), T(-0.5)}, {T(-0.5), T(0.5)}, {T(0.5), T(0.5)}}};

/// One texture matrix per tap, for hardware and shaders that cannot move a projective coordinate afterwards.
///
/// @param texture_matrix   world to texels
/// @param offsets          of the taps, in texels
/// @return                 matrices with the offset applied before the division by w: equal in exact arithmetic to
///                         adding it afterwards; in binary32 within 6 ulp of (|m0 x| + |m1 y| + |m2 z| + |m3|) / w,
///                         the magnitudes that add up to a coordinate (worst seen 4.5; tap_coordinate stays closer)
/// @formula                translate(offset) * texture_matrix
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
    for (int row = 0; row < 4; ++row)
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
    .name = "shadow_coordinate", .summary = "world to texels and depth, before the division", .exactness = tier::b,
    .source = R"GLSL(
// umbrage_shadow_coordinate: texture matrix times world position; (x w, y w, depth w, w), x and y in texels
UMBRAGE_HIGHP vec4 umbrage_shadow_coordinate(UMBRAGE_HIGHP mat4 m, UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 c = m[3] + m[0] * world.x + m[1] * world.y + m[2] * world.z;
    return c;
}
)GLSL"};

inline constexpr snippet tap_coordinate{
    .name = "tap_coordinate", .summary = "a tap's coordinate from the middle's, before the division",
    .exactness = tier::b, .source = R"GLSL(
// umbrage_tap_coordinate: coordinate, before the division by w, moved by offset texels
UMBRAGE_HIGHP vec4 umbrage_tap_coordinate(UMBRAGE_HIGHP vec4 coordinate, UMBRAGE_HIGHP vec2 offset) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 moved = vec2(coordinate.x, coordinate.y) + offset * coordinate.w;
    return vec4(moved.x, moved.y, coordinate.z, coordinate.w);
}
)GLSL"};

inline constexpr snippet project_coordinate{
    .name = "project_coordinate", .summary = "the division by w, lit behind the light", .exactness = tier::c, .ulp = 1,
    .source = R"GLSL(
// umbrage_project_coordinate: (x, y) in texels and depth; for w <= 0.0 a coordinate that every filter takes as lit
UMBRAGE_HIGHP vec3 umbrage_project_coordinate(UMBRAGE_HIGHP vec4 coordinate) {
    if (!(coordinate.w > 0.0)) return vec3(65536.0, 65536.0, 0.0);
    return vec3(coordinate.x / coordinate.w, coordinate.y / coordinate.w, coordinate.z / coordinate.w);
}
)GLSL"};

}  // namespace glsl
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
/// @formula           d > 0 and d^2 > cos_outer^2 |to_point|^2, d = direction . to_point: the sample's test, unnormalised
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
/// @param n_dot_l      cosine between normal and direction to the light; from 0 down, and NaN: unlit
/// @param visibility   of the light, 1 lit
/// @formula            albedo (visibility max(n_dot_l, 0) (1 - ambient) + ambient)
/// @exactness          B
/// @cite               Microsoft DirectX SDK, ShadowMap sample
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> diffuse_ambient(glm::vec<3, T> albedo, T ambient, T n_dot_l, T visibility) {
    const T facing = !is_nan(n_dot_l) && n_dot_l > T(0) ? n_dot_l : T(0);
    const T light = visibility * facing * (T(1) - ambient) + ambient;
    return albedo * light;
}

namespace glsl {

inline constexpr snippet spot_cone{
    .name = "spot_cone", .summary = "1 inside a spot light's cone", .exactness = tier::b, .source = R"GLSL(
// umbrage_spot_cone: 1.0 inside the cone of a spot light, else 0.0
//   direction  of the light, unit length;   to_point  from the light, any length;   cos_outer  in [0, 1)
UMBRAGE_HIGHP float umbrage_spot_cone(UMBRAGE_HIGHP vec3 direction, UMBRAGE_HIGHP vec3 to_point,
                                      UMBRAGE_HIGHP float cos_outer) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d = direction.x * to_point.x + direction.y * to_point.y + direction.z * to_point.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float length2 =
        to_point.x * to_point.x + to_point.y * to_point.y + to_point.z * to_point.z;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float edge2 = cos_outer * cos_outer * length2;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float d2 = d * d;
    return d > 0.0 && d2 > edge2 ? 1.0 : 0.0;
}
)GLSL"};

inline constexpr snippet diffuse_ambient{
    .name = "diffuse_ambient", .summary = "diffuse plus ambient light of a surface", .exactness = tier::b,
    .source = R"GLSL(
// umbrage_diffuse_ambient: albedo * (visibility * max(n_dot_l, 0) * (1 - ambient) + ambient)
UMBRAGE_HIGHP vec3 umbrage_diffuse_ambient(UMBRAGE_HIGHP vec3 albedo, UMBRAGE_HIGHP float ambient,
                                           UMBRAGE_HIGHP float n_dot_l, UMBRAGE_HIGHP float visibility) {
    UMBRAGE_HIGHP float facing = n_dot_l > 0.0 ? n_dot_l : 0.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float light = visibility * facing * (1.0 - ambient) + ambient;
    return albedo * light;
}
)GLSL"};

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/view/false_colour.hpp
// Depth as colour, so that people can see it: blue near, through cyan, green and yellow, to red far.
//
//     glm::vec3 colour = umbrage::false_colour(depth);
//

namespace umbrage {

/// @param v       clamped to [0, 1]; NaN counts as 1
/// @return        RGB in [0, 1]; brightness ramps up at both ends: 0 is dark blue, 1 dark red
/// @formula       3/2 - |4 v - c|, clamped, with c = 3, 2, 1 for red, green, blue
/// @exactness     B: one rounded difference a channel
template <real T>
[[nodiscard]] constexpr glm::vec<3, T> false_colour(T v) {
    const T x = saturate(v) * T(4);
    const auto ramp = [x](T peak) {
        const T distance = x < peak ? peak - x : x - peak;
        return saturate(T(1.5) - distance);
    };
    return {ramp(T(3)), ramp(T(2)), ramp(T(1))};
}

namespace glsl {

inline constexpr snippet false_colour{
    .name = "false_colour", .summary = "0..1 to blue, green, red", .exactness = tier::b, .needs = {&saturate},
    .source = R"GLSL(
// umbrage_false_colour: blue for 0.0, through green, to red for 1.0
UMBRAGE_HIGHP vec3 umbrage_false_colour(UMBRAGE_HIGHP float v) {
    UMBRAGE_HIGHP float x = umbrage_saturate(v) * 4.0;
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 ramp = 1.5 - abs(vec3(x - 3.0, x - 2.0, x - 1.0));
    return vec3(umbrage_saturate(ramp.x), umbrage_saturate(ramp.y), umbrage_saturate(ramp.z));
}
)GLSL"};

}  // namespace glsl
}  // namespace umbrage

// ---- umbrage/registry.hpp
// Every snippet there is, in the order of the data's way: what tests, tables and tools walk through.
//
//     for (const umbrage::glsl::snippet* s : umbrage::glsl::registry) std::puts(umbrage::glsl::text({*s}).c_str());
//

namespace umbrage::glsl {

inline constexpr std::array registry{
    // vertex side
    &shadow_coordinate, &tap_coordinate, &project_coordinate,
    // kinds of depth
    &linear_depth, &project_depth, &distance_depth, &reverse_depth, &depth_from_ndc, &view_z_from_depth,
    &depth_from_view_z,
    // encodings
    &saturate, &to_unorm, &from_unorm,
    &encode_rg<9>, &encode_rg<10>, &encode_rg<11>, &encode_rg<12>, &encode_rg<13>, &encode_rg<14>, &encode_rg<15>,
    &encode_rg<16>,
    &encode_rg_table<9>, &encode_rg_table<10>, &encode_rg_table<11>, &encode_rg_table<12>, &encode_rg_table<13>,
    &encode_rg_table<14>, &encode_rg_table<15>, &encode_rg_table<16>,
    &decode_rg<9>, &decode_rg<10>, &decode_rg<11>, &decode_rg<12>, &decode_rg<13>, &decode_rg<14>, &decode_rg<15>,
    &decode_rg<16>,
    &decode_ps14, &receiver_ps14,
    &encode_rgb24, &decode_rgb24,
    &encode_float_bits, &decode_float_bits,
    &encode_three_rgba, &decode_three_rgba, &encode_three_rgb, &decode_three_rgb, &encode_three_rg, &decode_three_rg,
    &encode_three_legacy, &encode_three_legacy_repaired, &decode_three_legacy,
    &encode_aras, &encode_aras_repaired, &decode_aras,
    // fetch, compare, filter
    &fetch_clamped, &fetch_bordered, &fetch_depth, &inside_texel_space, &compare, &compare_dx_sdk, &compare_exercise,
    &hard, &four_tap, &pcf_2x2, &pcf_2x2_dx_sdk, &box_count, &box_scale, &box,
    // shade, view
    &spot_cone, &diffuse_ambient, &false_colour};

}  // namespace umbrage::glsl

// ---- umbrage/version.hpp
// The version of umbrage. CMake reads it from here.

#define UMBRAGE_VERSION_MAJOR 0
#define UMBRAGE_VERSION_MINOR 1
#define UMBRAGE_VERSION_PATCH 0

// ---- umbrage/image_ops/isa.hpp
// One loop, compiled for each instruction set, the machine's best chosen when the program runs. No flags, no intrinsics.
//
//     umbrage::detail::on_best_isa([&](auto) UMBRAGE_INLINE { for (...) block(...); });
//
// A body is inlined into thin functions that carry the target; what it calls must be UMBRAGE_INLINE too, or it is
// compiled for the base set. GCC vectorises at -O2 only loops whose count it knows, and no `c ? x : y` on floats: so
// loops run over blocks of 64, and select on the bits.
//
// UMBRAGE_FORCE_ISA=base, =avx2 or =avx512 sets the choice; a machine that lacks it takes the next lower one. No choice
// changes a bit of a result of tier A. It has to be the same in all files of a program.

#if defined(__GNUC__) || defined(__clang__)
#define UMBRAGE_INLINE __attribute__((always_inline))
#define UMBRAGE_PREFETCH(address) __builtin_prefetch(address)
#else
#define UMBRAGE_INLINE
#define UMBRAGE_PREFETCH(address) static_cast<void>(address)
#endif

#if defined(__x86_64__) && (defined(__GNUC__) || defined(__clang__))
#define UMBRAGE_HAS_DISPATCH 1
#define UMBRAGE_AVX2 __attribute__((target("avx2"), noinline))
#define UMBRAGE_AVX512 __attribute__((target("avx512f,avx512bw,avx512dq,avx512vl"), noinline))
#else
#define UMBRAGE_HAS_DISPATCH 0
#endif

#ifndef UMBRAGE_FORCE_ISA
#define UMBRAGE_FORCE_ISA avx512
#endif

namespace umbrage {

enum class isa { base, avx2, avx512 };

/// The best instruction set of this machine, of those that get a path of their own.
[[nodiscard]] inline isa best_isa() {
#if UMBRAGE_HAS_DISPATCH
    __builtin_cpu_init();
    if (!__builtin_cpu_supports("avx2")) return isa::base;
    const bool wide = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl");
    return wide ? isa::avx512 : isa::avx2;
#else
    return isa::base;
#endif
}

namespace detail {

/// What image functions use; tests set it to see every path.
inline isa isa_in_use = best_isa() < isa::UMBRAGE_FORCE_ISA ? best_isa() : isa::UMBRAGE_FORCE_ISA;

template <isa Set>
using isa_constant = std::integral_constant<isa, Set>;

#if UMBRAGE_HAS_DISPATCH
template <class Body>
UMBRAGE_AVX2 void on_avx2(const Body& body) {
    body(isa_constant<isa::avx2>{});
}
template <class Body>
UMBRAGE_AVX512 void on_avx512(const Body& body) {
    body(isa_constant<isa::avx512>{});
}
#endif

/// Runs the body, compiled for the instruction set in use, which it gets as a constant. Only for results that no
/// contraction to FMA can change.
template <class Body>
void on_best_isa(const Body& body) {
#if UMBRAGE_HAS_DISPATCH
    if (isa_in_use == isa::avx512) return on_avx512(body);
    if (isa_in_use == isa::avx2) return on_avx2(body);
#endif
    body(isa_constant<isa::base>{});
}

/// The same for sums of products that round: AVX-512 brings FMA along, with which compilers change the result.
template <class Body>
void on_best_isa_without_fma(const Body& body) {
#if UMBRAGE_HAS_DISPATCH
    if (isa_in_use != isa::base) return on_avx2(body);
#endif
    body(isa_constant<isa::base>{});
}

inline constexpr int block = 64;  ///< elements of a loop whose count the compiler knows

/// saturate() on the bits: the magnitude up to 1, or 0 for what is negative and not a NaN.
[[nodiscard]] UMBRAGE_INLINE inline float saturate_bits(float v) {
    constexpr auto one = std::bit_cast<std::int32_t>(1.0f), minus_infinity = static_cast<std::int32_t>(0xFF800000u);
    const auto bits = std::bit_cast<std::int32_t>(v);
    const std::int32_t magnitude = bits & 0x7FFFFFFF, kept = -std::int32_t(bits > minus_infinity);
    return std::bit_cast<float>((magnitude < one ? magnitude : one) & kept);
}

}  // namespace detail
}  // namespace umbrage

// ---- umbrage/image_ops/clip.hpp
// From world positions to vertices on the 1/256 texel grid: projection, clipping, snapping.
//
//     umbrage::projection project(world_to_clip, clip, {1024, 1024});
//     umbrage::clipped_polygon polygon = umbrage::clip_triangle(project, a, b, c);
//
// Texels are counted from the bottom in here (NDC y = -1), whatever the clip space says: the texture origin only
// mirrors rows when texels are written, so that both origins give the same picture.
//

namespace umbrage {

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
    static constexpr int planes = 6;  ///< w > 0, the near plane, four sides of the guard band

    /// @param world_to_clip  projection * view; its elements must be finite
    /// @throws std::invalid_argument  a side of `size` is negative or above guard_band
    projection(const glm::mat4& world_to_clip, clip_space clip, glm::ivec2 size)
        : matrix_(world_to_clip), clip_(clip), half_size_(glm::dvec2(size) * 0.5) {
        if (size.x < 0 || size.y < 0) throw std::invalid_argument("umbrage::projection: negative size");
        if (size.x > guard_band || size.y > guard_band)
            throw std::invalid_argument("umbrage::projection: image side above 16384 texels");
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

    /// 64 positions at once, to where homogeneous() and snap() put them; those outside of planes become `outside_vertex`.
    /// @exactness  the bits of one by one
    void snap(const glm::vec3 (&positions)[detail::block], snapped_vertex (&vertices)[detail::block]) const {
        using bits = std::int64_t;
        constexpr bits minus_zero = std::numeric_limits<bits>::min();
        const bool forward = clip_.direction == depth_direction::forward;
        const double z_share = clip_.range == depth_range::minus_one_to_one ? 0.5 : 1.0, w_share = 1.0 - z_share;
        const double near_z = forward ? 1.0 : -1.0, near_w = forward ? 0.0 : 1.0;
        const bits lowest = forward ? 0 : minus_zero;
        const bits highest = forward ? std::numeric_limits<bits>::max() : std::bit_cast<bits>(1.0);
        detail::on_best_isa_without_fma([&](auto) UMBRAGE_INLINE {
            float x[detail::block], y[detail::block], z[detail::block];
            double column[detail::block], row[detail::block], depth[detail::block];
            bits outside[detail::block];
            for (int i = 0; i < detail::block; ++i)
                x[i] = positions[i].x, y[i] = positions[i].y, z[i] = positions[i].z;
            const glm::dmat4 m = matrix_;
            const glm::dvec2 half_size = half_size_;
            for (int i = 0; i < detail::block; ++i) {
                const auto clip_row = [&](int r) UMBRAGE_INLINE {
                    return m[0][r] * double(x[i]) + m[1][r] * double(y[i]) + m[2][r] * double(z[i]) + m[3][r];
                };
                const double w = clip_row(3), band = guard_band * w;
                const double hx = (clip_row(0) + w) * half_size.x, hy = (clip_row(1) + w) * half_size.y;
                const double hz = z_share * clip_row(2) + w_share * w;
                const auto bit = [](double distance, int plane) UMBRAGE_INLINE {
                    const bits d = std::bit_cast<bits>(distance);
                    return bits((d < 0) & (d != minus_zero)) << plane;
                };
                outside[i] = bit(w - smallest_w, 0) | bit(near_z * hz + near_w * w, 1) | bit(band + hx, 2) |
                             bit(band - hx, 3) | bit(band + hy, 4) | bit(band - hy, 5);
                const bits inside = -bits(outside[i] == 0);
                column[i] = std::bit_cast<double>(std::bit_cast<bits>(hx / w * subtexels + 0.5) & inside);
                row[i] = std::bit_cast<double>(std::bit_cast<bits>(hy / w * subtexels + 0.5) & inside);
                bits d = std::bit_cast<bits>(hz / w);
                d = d < lowest ? lowest : d;
                d = d > highest ? highest : d;
                depth[i] = std::bit_cast<double>(d & inside);
            }
            std::int32_t columns[detail::block], rows[detail::block];
            const auto floors = [](const double* from, std::int32_t* to) UMBRAGE_INLINE {
                for (int i = 0; i < detail::block; ++i) {
                    const auto whole = static_cast<std::int32_t>(from[i]);
                    to[i] = whole - std::int32_t(from[i] < whole);
                }
            };
            floors(column, columns);
            floors(row, rows);
            for (int i = 0; i < detail::block; ++i) vertices[i] = {columns[i], rows[i], depth[i]};
            for (int i = 0; i < detail::block; ++i)
                if (outside[i]) vertices[i] = outside_vertex(static_cast<unsigned>(outside[i]));
        });
    }

private:
    static constexpr double smallest_w = 0x1p-126;

    [[nodiscard]] double row(int r, glm::vec3 p) const {
        return matrix_[0][r] * double(p.x) + matrix_[1][r] * double(p.y) + matrix_[2][r] * double(p.z) + matrix_[3][r];
    }

    glm::dmat4 matrix_;
    clip_space clip_;
    glm::dvec2 half_size_;
};

/// True when no element is NaN or infinite.
[[nodiscard]] inline bool is_finite(glm::vec3 p) { return is_finite(p.x) && is_finite(p.y) && is_finite(p.z); }
[[nodiscard]] inline bool is_finite(const glm::mat4& m) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!is_finite(m[column][row])) return false;
    return true;
}

/// A convex polygon on the grid, its smallest vertex first: a fan around that vertex is the same whichever vertex
/// of the triangle came first, and whichever way round they went.
struct clipped_polygon {
    std::array<snapped_vertex, 3 + projection::planes> vertices;
    int count = 0;  ///< 0 or 3..9
};

/// The part of a triangle inside all planes.
/// @param a,b,c   homogeneous texels
/// @param planes  a bit for each plane to clip against; those that all three points are inside of may be left out
[[nodiscard]] inline clipped_polygon clip_triangle(const projection& project, const glm::dvec4& a, const glm::dvec4& b,
                                                   const glm::dvec4& c, unsigned planes = ~0u) {
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
            if (p_inside) points[std::size_t(count++)] = p;
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

}  // namespace umbrage

// ---- umbrage/image_ops/parallel.hpp
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

// ---- umbrage/image_ops/encode.hpp
// Whole depth images into texels of an encoding, and back, about as fast as memory can be copied.
//
//     umbrage::image<glm::u8vec2> packed(depth.size());
//     umbrage::encode(depth.view(), packed.view(), umbrage::rg<11>{});
//
// Bit for bit what the encoding's own encode and decode give. The encodings of this library have loops of their own that
// compilers can vectorise; any other type like them works as well.

namespace umbrage {
namespace detail {

/// depth_code() in a form that vectorises.
template <int Bits>
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t depth_code_bits(float depth) {
    constexpr std::int32_t codes = std::int32_t(1) << Bits;
    const auto x = static_cast<std::int32_t>(saturate_bits(depth) * float(codes));
    return x < codes ? x : codes - 1;
}

/// A block of 64 depths to texels and back; this general one leaves the work to the encoding.
template <class Encoding>
struct block_codec {
    using texel = typename Encoding::texel;
    static UMBRAGE_INLINE void encode(const float* depth, texel* texels, const Encoding& encoding) {
        for (int i = 0; i < block; ++i) texels[i] = encoding.encode(depth[i]);
    }
    static UMBRAGE_INLINE void decode(const texel* texels, float* depth, const Encoding& encoding) {
        for (int i = 0; i < block; ++i) depth[i] = encoding.decode(texels[i]);
    }
};

/// Texels as 16-bit words: R is where this machine has the first byte.
template <int Bits>
struct block_codec<rg<Bits>> {
    static constexpr int r = std::endian::native == std::endian::little ? 0 : 8, g = 8 - r;
    static UMBRAGE_INLINE void encode(const float* depth, glm::u8vec2* texels, const rg<Bits>&) {
        std::uint16_t words[block];
        for (int i = 0; i < block; ++i) {
            const std::int32_t x = depth_code_bits<Bits>(depth[i]);
            words[i] = static_cast<std::uint16_t>((x & 0xFF) << r | (x >> 8) << (16 - Bits) << g);
        }
        std::memcpy(static_cast<void*>(texels), words, sizeof words);
    }
    static UMBRAGE_INLINE void decode(const glm::u8vec2* texels, float* depth, const rg<Bits>& encoding) {
        std::uint16_t words[block];
        std::memcpy(words, texels, sizeof words);
        const float edge = encoding.edge;  // a copy: as far as a compiler knows, depth may overwrite the other
        for (int i = 0; i < block; ++i) depth[i] = decode(words[i], edge);
    }
    static UMBRAGE_INLINE float decode(std::int32_t word, float edge) {
        return code_depth<Bits>(float((word >> r & 0xFF) + ((word >> g & 0xFF) << (Bits - 8))), edge);
    }
};

template <>
struct block_codec<rgb24> {
    static UMBRAGE_INLINE void encode(const float* depth, glm::u8vec3* texels, const rgb24&) {
        std::int32_t x[block];
        for (int i = 0; i < block; ++i) x[i] = depth_code_bits<24>(depth[i]);
        for (int i = 0; i < block; ++i)
            texels[i] = {static_cast<std::uint8_t>(x[i] >> 16), static_cast<std::uint8_t>(x[i] >> 8 & 0xFF),
                         static_cast<std::uint8_t>(x[i] & 0xFF)};
    }
    static UMBRAGE_INLINE void decode(const glm::u8vec3* texels, float* depth, const rgb24& encoding) {
        const float edge = encoding.edge;
        for (int i = 0; i < block; ++i) {
            const std::int32_t x = (texels[i].x << 16) + (texels[i].y << 8) + texels[i].z;
            depth[i] = code_depth<24>(float(x), edge);
        }
    }
};

template <>
struct block_codec<float_bits> {
    static_assert(sizeof(glm::u8vec4) == sizeof(float));
    static UMBRAGE_INLINE void encode(const float* depth, glm::u8vec4* texels, const float_bits& encoding) {
        if constexpr (std::endian::native == std::endian::little)
            std::memcpy(static_cast<void*>(texels), depth, block * sizeof(float));
        else
            for (int i = 0; i < block; ++i) texels[i] = encoding.encode(depth[i]);
    }
    static UMBRAGE_INLINE void decode(const glm::u8vec4* texels, float* depth, const float_bits& encoding) {
        if constexpr (std::endian::native == std::endian::little)
            std::memcpy(depth, texels, block * sizeof(float));
        else
            for (int i = 0; i < block; ++i) depth[i] = encoding.decode(texels[i]);
    }
};

template <>
struct block_codec<depth32f> {
    static UMBRAGE_INLINE void encode(const float* depth, float* texels, const depth32f&) {
        for (int i = 0; i < block; ++i) texels[i] = saturate_bits(depth[i]);
    }
    static UMBRAGE_INLINE void decode(const float* texels, float* depth, const depth32f&) {
        std::memcpy(depth, texels, block * sizeof(float));
    }
};

/// A row in blocks; the last one goes through copies as long as a block.
template <class From, class To, class Convert>
UMBRAGE_INLINE inline void convert_row(const From* from, To* to, int count, const Convert& convert) {
    int x = 0;
    for (; x + block <= count; x += block) convert(from + x, to + x);
    if (x == count) return;
    From padded[block]{};
    To result[block];
    for (int i = 0; i < count - x; ++i) padded[i] = from[x + i];
    convert(padded, result);
    for (int i = 0; i < count - x; ++i) to[x + i] = result[i];
}

}  // namespace detail

/// @param depth      any values; what the encoding makes of them
/// @param texels     same size
/// @param encoding   rg<Bits>, rgb24, float_bits, depth32f, or a type like them
/// @param parallel   cuts the rows into pieces, see parallel.hpp
/// @throws std::invalid_argument  sizes differ
template <class Encoding, class ParallelFor = serial>
void encode(image_view<const float> depth, image_view<typename Encoding::texel> texels, Encoding encoding,
            ParallelFor&& parallel = {}) {
    if (depth.size != texels.size) throw std::invalid_argument("umbrage::encode: sizes differ");
    if (depth.empty()) return;
    parallel(depth.size.y, [&](int first, int last) {
        detail::on_best_isa([&](auto) UMBRAGE_INLINE {
            for (int y = first; y < last; ++y)
                detail::convert_row(depth.row(y), texels.row(y), depth.size.x,
                                    [&](const auto* from, auto* to) UMBRAGE_INLINE {
                                        detail::block_codec<Encoding>::encode(from, to, encoding);
                                    });
        });
    });
}

/// @param texels     any texels of the encoding
/// @param depth      same size
/// @param parallel   cuts the rows into pieces, see parallel.hpp
/// @throws std::invalid_argument  sizes differ
template <class Encoding, class ParallelFor = serial>
void decode(image_view<const typename Encoding::texel> texels, image_view<float> depth, Encoding encoding,
            ParallelFor&& parallel = {}) {
    if (depth.size != texels.size) throw std::invalid_argument("umbrage::decode: sizes differ");
    if (depth.empty()) return;
    parallel(depth.size.y, [&](int first, int last) {
        detail::on_best_isa([&](auto) UMBRAGE_INLINE {
            for (int y = first; y < last; ++y)
                detail::convert_row(texels.row(y), depth.row(y), depth.size.x,
                                    [&](const auto* from, auto* to) UMBRAGE_INLINE {
                                        detail::block_codec<Encoding>::decode(from, to, encoding);
                                    });
        });
    });
}

}  // namespace umbrage

// ---- umbrage/image_ops/triangle_batch.hpp
// Triangles on the vertex grid, 64 at a time: edges and depth planes set up in loops that vectorise, then spans row by
// row without a division.
//
//     umbrage::triangle_batch batch;
//     batch.add(p, q, r, id, {{0, 0}, size}, umbrage::cull_mode::none);  // and more, until it is full()
//     batch.set_up();
//     for (int i = 0; i < batch.count; ++i)
//         batch.for_each_row(i, [&](int y, int first, int last) { ... });
//
// A sample is inside an edge from a to b where E = (b.x - a.x)(y - a.y) - (b.y - a.y)(x - a.x) >= 0, or > 0 where the
// edge is neither a top nor a left one. In a row the last such sample is a quotient of integers; from row to row the
// quotient and its remainder grow by constants, so that it stays exact.

namespace umbrage {

/// Which faces to leave out. The front goes counter-clockwise in NDC, x to the right and y up.
enum class cull_mode { none, front, back };

/// Depth over a triangle, exact on its grid: z + dx * x + dy * y for texels x, y counted from `first`.
struct depth_plane {
    glm::ivec2 first;        ///< a texel within the triangle's bounds
    double z, dx, dy;        ///< multiples of one power of two, so that no sum of theirs within the bounds is rounded
    double lowest, highest;  ///< of the vertices; samples never leave it

    [[nodiscard]] UMBRAGE_INLINE double unclamped(int x, int y) const {
        return z + dx * (x - first.x) + dy * (y - first.y);
    }
    [[nodiscard]] UMBRAGE_INLINE double operator()(int x, int y) const {
        const double depth = unclamped(x, y);
        return depth > lowest ? (depth < highest ? depth : highest) : lowest;
    }
};

/// Texels first <= t < last; y counts from the bottom.
struct texel_bounds {
    glm::ivec2 first, last;
};

namespace detail {

/// A whole number to an integer, anything else to one of its neighbours; |v| < 2^51. AVX2 has no conversion.
[[nodiscard]] UMBRAGE_INLINE inline std::int64_t to_integer(double v) {
    constexpr double magic = 0x1.8p52;
    return std::bit_cast<std::int64_t>(v + magic) - std::bit_cast<std::int64_t>(magic);
}

/// Towards zero; |v| < 2^63.
template <isa Set>
[[nodiscard]] UMBRAGE_INLINE inline double truncate(double v) {
#if UMBRAGE_HAS_DISPATCH
    if constexpr (Set == isa::avx2) return __builtin_trunc(v);
#endif
    return static_cast<double>(static_cast<std::int64_t>(v));
}

}  // namespace detail

/// Up to 64 triangles, each coordinate an array of its own.
class triangle_batch {
public:
    int count = 0;
    unsigned id[detail::block];

    triangle_batch() {  // every lane is set up, used or not
        for (int i = 0; i < detail::block; ++i) {
            id[i] = 0;
            first_[0][i] = first_[1][i] = last_[0][i] = last_[1][i] = 0;
            for (auto& depth : z_) depth[i] = 0.0;
            for (int k = 0; k < 3; ++k) x_[k][i] = k == 1, y_[k][i] = k == 2;
        }
    }

    /// Rows first <= y < second whose centres are above the lowest corner, the highest included: a bottom edge and
    /// a corner cover no centre that they meet.
    [[nodiscard]] static UMBRAGE_INLINE std::pair<int, int> rows(std::int32_t lowest, std::int32_t highest) {
        return {(lowest + subtexels - centre) >> 8, ((highest - centre) >> 8) + 1};
    }

    [[nodiscard]] bool full() const { return count == detail::block; }

    /// Takes a triangle unless it faces away, has no area or no sample in its bounds can be within `bounds`.
    /// There must be room.
    UMBRAGE_INLINE void add(const snapped_vertex& a, const snapped_vertex& b, const snapped_vertex& c,
                            unsigned triangle, const texel_bounds& bounds, cull_mode cull) {
        const auto [lowest, highest] = rows(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}));
        const int first_y = std::max(lowest, bounds.first.y), last_y = std::min(highest, bounds.last.y) - 1;
        const int left = std::min({a.x, b.x, c.x}) + subtexels - 1 - centre, right = std::max({a.x, b.x, c.x}) - centre;
        const int first_x = std::max(left >> 8, bounds.first.x), last_x = std::min(right >> 8, bounds.last.x - 1);
        if (first_x > last_x || first_y > last_y) return;

        const std::int64_t area =
            std::int64_t(b.x - a.x) * (c.y - a.y) - std::int64_t(c.x - a.x) * (b.y - a.y);
        if (area == 0 || cull == (area > 0 ? cull_mode::front : cull_mode::back)) return;

        // Counter-clockwise, the smallest vertex first, whatever the order in the mesh was.
        const snapped_vertex* const around[] = {&a, area > 0 ? &b : &c, area > 0 ? &c : &b, &a, area > 0 ? &b : &c};
        const auto key = [](const snapped_vertex& v) { return std::int64_t(v.x) * (std::int64_t(1) << 32) + v.y; };
        const std::int64_t keys[] = {key(*around[0]), key(*around[1]), key(*around[2])};
        const int second_or_third = keys[1] < keys[2] ? 1 : 2;
        const int smallest = keys[0] < keys[second_or_third] ? 0 : second_or_third;
        for (int k = 0; k < 3; ++k) {
            const snapped_vertex& v = *around[smallest + k];
            x_[k][count] = v.x, y_[k][count] = v.y, z_[k][count] = v.depth;
        }
        first_[0][count] = first_x, first_[1][count] = first_y;
        last_[0][count] = last_x, last_[1][count] = last_y;
        id[count++] = triangle;
    }

    /// Edges and planes of all triangles.
    ///
    /// @exactness  edges A: integers. Planes B: the same bits with and without FMA. With n the bounds' larger side in
    ///             1/256 texel and m the sum of the depth's and the two slopes' magnitudes over the bounds, a sample is
    ///             within 2^-48 n m of the plane through the snapped vertices
    void set_up() {
        detail::on_best_isa([this](auto set) UMBRAGE_INLINE {
            for (int k = 0; k < 3; ++k) set_up_edges(k);
            set_up_planes<decltype(set)::value>();
        });
    }

    [[nodiscard]] UMBRAGE_INLINE depth_plane plane(int i) const {
        const double a = z_[0][i], b = z_[1][i], c = z_[2][i];
        const auto smaller = [](double p, double q) { return p < q ? p : q; };
        const auto larger = [](double p, double q) { return p < q ? q : p; };
        return {{first_[0][i], first_[1][i]}, depth_[i], dx_[i], dy_[i], smaller(smaller(a, b), c),
                larger(larger(a, b), c)};
    }

    [[nodiscard]] UMBRAGE_INLINE texel_bounds bounds(int i) const {
        return {{first_[0][i], first_[1][i]}, {last_[0][i] + 1, last_[1][i] + 1}};
    }

    /// @param row   (int y, int first, int last): texels first <= x < last of row y are covered; there is at least one
    template <class Row>
    UMBRAGE_INLINE void for_each_row(int i, const Row& row) const {
        // One edge bounds the rows on its side alone, the others on theirs.
        const bool left[] = {is_left(0, i), is_left(1, i), is_left(2, i)};
        const bool lone_is_left = left[0] + left[1] + left[2] == 1;
        const int lone = left[0] == lone_is_left ? 0 : left[1] == lone_is_left ? 1 : 2;
        auto p = edge_at(lone, i), q = edge_at(lone == 2 ? 0 : lone + 1, i), r = edge_at(lone == 0 ? 2 : lone - 1, i);
        const int x = first_[0][i], last_y = last_[1][i];
        const std::int64_t width = last_[0][i] - x;
        for (int y = first_[1][i]; y <= last_y; ++y) {
            const std::int64_t single = p.quotient, pair = q.quotient < r.quotient ? q.quotient : r.quotient;
            const std::int64_t before = lone_is_left ? single : pair, behind = lone_is_left ? pair : single;
            const std::int64_t low = before < 0 ? -before : 0, high = behind < width ? behind : width;
            if (low <= high) row(y, x + int(low), x + int(high) + 1);
            p.step(), q.step(), r.step();
        }
    }

private:
    static constexpr int centre = subtexels / 2;

    /// E divided by the magnitude of its step from texel to texel: how many texels further E still is not negative.
    struct edge {
        std::int64_t quotient, remainder, quotient_step, remainder_step, divisor;

        UMBRAGE_INLINE void step() {
            quotient += quotient_step;
            remainder += remainder_step;
            const bool carry = remainder >= divisor;
            quotient += carry;
            remainder -= carry ? divisor : 0;
        }
    };
    struct edges {
        std::int64_t quotient[detail::block], remainder[detail::block], quotient_step[detail::block],
            remainder_step[detail::block], divisor[detail::block];
    };

    [[nodiscard]] UMBRAGE_INLINE edge edge_at(int k, int i) const {
        const edges& e = edges_[k];
        return {e.quotient[i], e.remainder[i], e.quotient_step[i], e.remainder_step[i], e.divisor[i]};
    }
    [[nodiscard]] UMBRAGE_INLINE bool is_left(int k, int i) const { return y_[k == 2 ? 0 : k + 1][i] < y_[k][i]; }

    UMBRAGE_INLINE void set_up_edges(int k) {
        edges& e = edges_[k];
        const auto &ax = x_[k], &ay = y_[k], &bx = x_[k == 2 ? 0 : k + 1], &by = y_[k == 2 ? 0 : k + 1];
        for (int i = 0; i < detail::block; ++i) {
            const std::int32_t up = by[i] - ay[i], level = up == 0, right = (bx[i] - ax[i]) & (level - 1);
            const std::int32_t from_a_x = first_[0][i] * subtexels + centre - ax[i];
            const std::int32_t from_a_y = first_[1][i] * subtexels + centre - ay[i];
            const double value = double(right) * from_a_y + double(-up) * from_a_x - double(up > 0);
            const double divisor = double((up < 0 ? -up : up) + level) * subtexels, step = double(right) * subtexels;
            const std::int64_t d = detail::to_integer(divisor);
            const auto divide = [&](double dividend, std::int64_t& quotient, std::int64_t& remainder) UMBRAGE_INLINE {
                const std::int64_t q = detail::to_integer(dividend / divisor);  // or one off
                const std::int64_t rest = detail::to_integer(dividend) - q * d;
                const std::int64_t below = -std::int64_t(rest < 0), above = -std::int64_t(rest >= d);
                quotient = q + below - above;
                remainder = rest + (d & below) - (d & above);
            };
            std::int64_t quotient;
            divide(value, quotient, e.remainder[i]);
            divide(step, e.quotient_step[i], e.remainder_step[i]);
            e.quotient[i] = quotient | std::int64_t(level) << 40;  // a level edge bounds no row from the side
            e.divisor[i] = d;
        }
    }

    template <isa Set>
    UMBRAGE_INLINE void set_up_planes() {
        using bits = std::int64_t;
        constexpr bits exponent = 0x7FF0000000000000, magnitude = 0x7FFFFFFFFFFFFFFF, short_digits = ~bits(0x3FFFFFF);
        constexpr bits tiny = std::bit_cast<bits>(0x1p-200);
        const auto masked = [](double v, bits mask) UMBRAGE_INLINE {
            return std::bit_cast<double>(std::bit_cast<bits>(v) & mask);
        };
        const auto power_of_two = [](double a, double b, double c) UMBRAGE_INLINE {  // the largest's, rounded down
            const bits p = std::bit_cast<bits>(a) & exponent, q = std::bit_cast<bits>(b) & exponent;
            const bits r = std::bit_cast<bits>(c) & exponent;
            const bits largest = p < q ? q : p, other = r < tiny ? tiny : r;
            return std::bit_cast<double>(largest < other ? other : largest);
        };
        for (int i = 0; i < detail::block; ++i) {
            const double x1 = x_[1][i] - x_[0][i], y1 = y_[1][i] - y_[0][i];
            const double x2 = x_[2][i] - x_[0][i], y2 = y_[2][i] - y_[0][i];
            const std::int32_t left = std::min(std::min(x_[0][i], x_[1][i]), x_[2][i]);
            const std::int32_t right = std::max(std::max(x_[0][i], x_[1][i]), x_[2][i]);
            const std::int32_t bottom = std::min(std::min(y_[0][i], y_[1][i]), y_[2][i]);
            const std::int32_t top = std::max(std::max(y_[0][i], y_[1][i]), y_[2][i]);
            const double width = right - left, height = top - bottom;
            const double per_area = 1.0 / (x1 * y2 + x2 * -y1);

            // Depths with so few digits that the products with x1 .. y2 and their differences need no rounding.
            const double side = std::max(right - left, top - bottom);
            double unit = power_of_two(z_[0][i], z_[1][i], z_[2][i]) * masked(side, exponent) * 0x1p-49;
            double units = 1.0 / unit;
            const double z0 = detail::truncate<Set>(z_[0][i] * units) * unit;
            const double z1 = detail::truncate<Set>(z_[1][i] * units) * unit;
            const double z2 = detail::truncate<Set>(z_[2][i] * units) * unit;
            const double slope_x = ((z1 - z0) * y2 + (z2 - z0) * -y1) * per_area;
            const double slope_y = ((z2 - z0) * x1 + (z1 - z0) * -x2) * per_area;

            // Slopes with so few digits that the same holds for every sample; here for the products.
            const double reach = masked(z0, magnitude) + masked(slope_x, magnitude & short_digits) * width +
                                 masked(slope_y, magnitude & short_digits) * height;
            unit = power_of_two(reach, 0.0, 0.0) * 0x1p-51;
            units = 1.0 / unit;
            const double dx = detail::truncate<Set>(slope_x * units) * unit;
            const double dy = detail::truncate<Set>(slope_y * units) * unit;
            depth_[i] = detail::truncate<Set>(z0 * units) * unit +
                        dx * (first_[0][i] * subtexels + centre - x_[0][i]) +
                        dy * (first_[1][i] * subtexels + centre - y_[0][i]);
            dx_[i] = dx * subtexels;
            dy_[i] = dy * subtexels;
            z_[0][i] = z0, z_[1][i] = z1, z_[2][i] = z2;
        }
    }

    std::int32_t x_[3][detail::block], y_[3][detail::block];  // counter-clockwise from the smallest
    double z_[3][detail::block];
    std::int32_t first_[2][detail::block], last_[2][detail::block];  // texels whose centres are within the bounds
    edges edges_[3];
    double depth_[detail::block], dx_[detail::block], dy_[detail::block];
};

}  // namespace umbrage

// ---- umbrage/image_ops/rasterize.hpp
// The depth pass on the CPU: triangles into a depth image, each sample on a shared edge covered exactly once.
//
//     umbrage::image<float> map({1024, 1024}, umbrage::cleared_depth(clip));
//     umbrage::rasterize_depth(map, {positions, triangles}, world_to_clip, clip);
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
// grid on which every sample is then computed exactly. So no order of triangles or vertices, no threads, no instruction
// set and no contraction to FMA changes a bit; of clipped triangles the last may move a cut by 1/256 texel.
//

namespace umbrage {

/// Triangles that somebody else owns: three indices into the positions each.
struct mesh_view {
    std::span<const glm::vec3> positions;
    std::span<const glm::uvec3> triangles;
};

namespace detail {

/// The vertices of a mesh on the grid of an image, and its triangles batch by batch.
class projected_mesh {
public:
    /// @throws std::invalid_argument  an index is out of range; a side of the image is above guard_band
    template <class ParallelFor>
    projected_mesh(glm::ivec2 size, const mesh_view& mesh, const glm::mat4& world_to_clip, clip_space clip,
                   ParallelFor&& parallel)
        : mesh_(mesh), project_(world_to_clip, clip, size) {
        for (const auto& t : mesh.triangles)
            if (t.x >= mesh.positions.size() || t.y >= mesh.positions.size() || t.z >= mesh.positions.size())
                throw std::invalid_argument("umbrage::rasterize: a triangle's index is out of range");
        if (size.x == 0 || size.y == 0 || !is_finite(world_to_clip)) mesh_.triangles = {};
        if (mesh_.triangles.empty()) return;
        const std::size_t count = mesh.positions.size();
        vertices_ = std::make_unique_for_overwrite<snapped_vertex[]>((count + block - 1) / block * block);
        constexpr std::size_t piece = 64 * block;
        parallel(static_cast<int>((count + piece - 1) / piece), [&](int first, int last) {
            for (std::size_t i = std::size_t(first) * piece; i < std::min(std::size_t(last) * piece, count); i += block)
                project_block(i);
        });
    }

    /// Starts to fetch what comes after the k-th triangle of a list, whose triangles lie anywhere in the mesh.
    void expect(std::span<const unsigned> list, std::size_t k) const {
        constexpr std::size_t soon = 16, later = 32;
        if (k + later < list.size()) UMBRAGE_PREFETCH(&mesh_.triangles[list[k + later]]);
        if (k + soon < list.size())
            for (int corner = 0; corner < 3; ++corner)
                UMBRAGE_PREFETCH(&vertices_[mesh_.triangles[list[k + soon]][corner]]);
    }

    [[nodiscard]] unsigned triangle_count() const { return static_cast<unsigned>(mesh_.triangles.size()); }

    /// Rows that a triangle may cover, from the bottom: first <= y < last, of which there may be none.
    [[nodiscard]] std::pair<int, int> rows(unsigned triangle, int height) const {
        const auto& t = mesh_.triangles[triangle];
        const snapped_vertex &a = vertices_[t.x], &b = vertices_[t.y], &c = vertices_[t.z];
        if (planes_outside(a) | planes_outside(b) | planes_outside(c)) return {0, height};
        const auto [lowest, highest] = std::minmax({a.y, b.y, c.y});
        const auto rows = triangle_batch::rows(lowest, highest);
        return {std::max(rows.first, 0), std::min(rows.second, height)};
    }

    /// @param triangles  (f): calls f(unsigned triangle) for each
    /// @param draw       (const triangle_batch&), with the triangles in that order
    template <class Triangles, class Draw>
    void for_each_batch(const Triangles& triangles, const texel_bounds& bounds, cull_mode cull,
                        const Draw& draw) const {
        triangle_batch batch;
        const auto flush = [&] {
            batch.set_up();
            draw(batch);
            batch.count = 0;
        };
        triangles([&](unsigned i) {
            const auto& t = mesh_.triangles[i];
            const snapped_vertex &a = vertices_[t.x], &b = vertices_[t.y], &c = vertices_[t.z];
            const unsigned crossed = planes_outside(a) | planes_outside(b) | planes_outside(c);
            if (crossed == 0) {
                batch.add(a, b, c, i, bounds, cull);
                if (batch.full()) flush();
            } else if (!(planes_outside(a) & planes_outside(b) & planes_outside(c)) && !(crossed & nowhere)) {
                const auto h = [&](unsigned index) { return project_.homogeneous(mesh_.positions[index]); };
                const auto polygon = clip_triangle(project_, h(t.x), h(t.y), h(t.z), crossed);
                for (std::size_t k = 1; int(k) + 1 < polygon.count; ++k) {
                    batch.add(polygon.vertices[0], polygon.vertices[k], polygon.vertices[k + 1], i, bounds, cull);
                    if (batch.full()) flush();
                }
            }
        });
        if (batch.count) flush();
    }

private:
    static constexpr unsigned nowhere = 1u << projection::planes;

    void project_block(std::size_t first) {
        glm::vec3 positions[block];
        for (std::size_t i = 0; i < block; ++i)
            positions[i] = mesh_.positions[std::min(first + i, mesh_.positions.size() - 1)];
        bool finite[block];
        for (std::size_t i = 0; i < block; ++i) {
            finite[i] = is_finite(positions[i]);
            if (!finite[i]) positions[i] = glm::vec3(0.0f);
        }
        snapped_vertex vertices[block];
        project_.snap(positions, vertices);
        for (std::size_t i = 0; i < block; ++i) vertices_[first + i] = finite[i] ? vertices[i] : outside_vertex(nowhere);
    }

    mesh_view mesh_;
    projection project_;
    std::unique_ptr<snapped_vertex[]> vertices_;
};

/// Which triangles may touch which band of rows, so that a band stays in the cache while it is drawn.
class banded_triangles {
public:
    template <class ParallelFor>
    banded_triangles(const projected_mesh& mesh, glm::ivec2 size, ParallelFor&& parallel)
        : mesh_(mesh), rows_(std::clamp(band_texels / std::max(size.x, 1), 1, band_rows)), bands_((size.y + rows_ - 1) / rows_) {
        const unsigned triangles = mesh.triangle_count(), pieces = (triangles + piece - 1) / piece;
        lists_.resize(std::size_t(pieces) * std::size_t(bands_));
        parallel(static_cast<int>(pieces), [&](int first, int last) {
            for (unsigned i = unsigned(first) * piece; i < std::min(unsigned(last) * piece, triangles); ++i) {
                const auto [low, high] = mesh.rows(i, size.y);
                for (int band = low / rows_; band * rows_ < high; ++band)
                    lists_[std::size_t(i / piece) * std::size_t(bands_) + std::size_t(band)].push_back(i);
            }
        });
    }

    [[nodiscard]] int bands() const { return bands_; }
    [[nodiscard]] int rows() const { return rows_; }

    /// In the mesh's order.
    template <class Use>
    void for_each(int band, const Use& use) const {
        for (std::size_t i = std::size_t(band); i < lists_.size(); i += std::size_t(bands_))
            for (std::size_t k = 0; k < lists_[i].size(); ++k) {
                mesh_.expect(lists_[i], k);
                use(lists_[i][k]);
            }
    }

private:
    static constexpr int band_texels = 1 << 16, band_rows = 64;
    static constexpr unsigned piece = 1 << 16;  // triangles that one thread sorts at a time

    const projected_mesh& mesh_;
    int rows_, bands_;
    std::vector<std::vector<unsigned>> lists_;  // of a piece, band by band
};

/// A triangle's depths into an image.
template <bool Forward>
class span_writer {
public:
    UMBRAGE_INLINE span_writer(image_view<float> depth, bool flipped)
        : bottom_(reinterpret_cast<std::byte*>(depth.row(flipped ? depth.size.y - 1 : 0))),
          up_(flipped ? -depth.stride : depth.stride),
          width_(depth.size.x) {}

    /// Starts to fetch the texels of a triangle, which for a small one takes as long as to draw another.
    UMBRAGE_INLINE void expect(const triangle_batch& batch, int i) const {
        const auto bounds = batch.bounds(i);
        for (int y = bounds.first.y; y < std::min(bounds.last.y, bounds.first.y + 16); ++y)
            UMBRAGE_PREFETCH(row(y) + bounds.first.x);
    }

    UMBRAGE_INLINE void draw(const triangle_batch& batch, int i) const {
        const auto plane = batch.plane(i);
        // Depths of one sign, and none that is flushed: their bits are in their order.
        if (plane.lowest >= 0x1p-126 && plane.highest <= 1.0) {
            const block_writer write(plane);
            batch.for_each_row(i, [&](int y, int first, int last) UMBRAGE_INLINE {
                float* const texels = row(y);
                double z = plane.unclamped(first, y);
                for (; first < last && first + lanes <= width_; first += lanes, z += plane.dx * lanes)
                    write(texels + first, z, last - first);
                if (first >= last) return;
                float copy[lanes]{};
                for (int x = first; x < last; ++x) copy[x - first] = texels[x];
                write(copy, z, last - first);
                for (int x = first; x < last; ++x) texels[x] = copy[x - first];
            });
        } else {
            batch.for_each_row(i, [&](int y, int first, int last) UMBRAGE_INLINE {
                float* const texels = row(y);
                for (int x = first; x < last; ++x) {
                    const double z = plane(x, y);
                    if (!(z >= 0.0 && z <= 1.0)) continue;
                    const float stored = z > 0.0 ? static_cast<float>(z) : 0.0f;
                    if (Forward ? stored <= texels[x] : stored >= texels[x]) texels[x] = stored;
                }
            });
        }
    }

private:
    static constexpr int lanes = 8;

    struct block_writer {
        double ramp[lanes];
        std::int32_t lowest, highest;

        UMBRAGE_INLINE explicit block_writer(const depth_plane& plane)
            : lowest(std::bit_cast<std::int32_t>(static_cast<float>(plane.lowest))),
              highest(std::bit_cast<std::int32_t>(static_cast<float>(plane.highest))) {
            for (int i = 0; i < lanes; ++i) ramp[i] = plane.dx * i;
        }

        /// The first `count` of eight texels; what is there can be anything.
        UMBRAGE_INLINE void operator()(float* texels, double z, int count) const {
            constexpr std::int32_t infinity = 0x7F800000, sign = std::numeric_limits<std::int32_t>::min();
            std::int32_t there[lanes], here[lanes];
            float rounded[lanes];
            for (int i = 0; i < lanes; ++i) rounded[i] = static_cast<float>(z + ramp[i]);
            std::memcpy(here, rounded, sizeof here);
            std::memcpy(there, texels, sizeof there);
            for (int i = 0; i < lanes; ++i) {
                const std::int32_t above = here[i] < lowest ? lowest : here[i];
                const std::int32_t depth = above > highest ? highest : above;
                const bool nearer = Forward ? depth <= there[i] : depth >= there[i];
                const bool number = (Forward ? there[i] : there[i] ^ sign) <= infinity;  // or a NaN of the other sign
                const std::int32_t mask = -std::int32_t(nearer & number & (i < count));
                there[i] = (depth & mask) | (there[i] & ~mask);
            }
            std::memcpy(texels, there, sizeof there);
        }
    };

    [[nodiscard]] UMBRAGE_INLINE float* row(int y) const { return reinterpret_cast<float*>(bottom_ + y * up_); }

    std::byte* bottom_;
    std::ptrdiff_t up_;
    int width_;
};

template <bool Forward>
void draw_batch(image_view<float> depth, bool flipped, const triangle_batch& batch) {
    on_best_isa([&](auto) UMBRAGE_INLINE {
        const span_writer<Forward> writer(depth, flipped);
        for (int i = 0; i < batch.count; ++i) {
            if (i + 1 < batch.count) writer.expect(batch, i + 1);
            writer.draw(batch, i);
        }
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
/// @throws std::invalid_argument  an index is out of range; a side of the image is above 16384
/// @formula     the nearer of what is there and the plane's depth, ties to the newcomer (the same bits); nothing beyond
///              the far plane; never -0
/// @exactness   coverage A from the snapped vertices on; depth B, see triangle_batch::set_up
template <class ParallelFor = serial>
void rasterize_depth(image_view<float> depth, const mesh_view& mesh, const glm::mat4& world_to_clip, clip_space clip,
                     cull_mode cull = cull_mode::none, ParallelFor&& parallel = {}) {
    const detail::projected_mesh projected(depth.size, mesh, world_to_clip, clip, parallel);
    const bool flipped = clip.origin == texture_origin::top, forward = clip.direction == depth_direction::forward;
    const detail::banded_triangles banded(projected, depth.size, parallel);
    parallel(banded.bands(), [&](int first, int last) {
        for (int band = first; band < last; ++band) {
            const texel_bounds bounds{{0, band * banded.rows()},
                                      {depth.size.x, std::min((band + 1) * banded.rows(), depth.size.y)}};
            const auto triangles = [&](const auto& use) { banded.for_each(band, use); };
            projected.for_each_batch(triangles, bounds, cull, [&](const triangle_batch& batch) {
                if (forward) detail::draw_batch<true>(depth, flipped, batch);
                else detail::draw_batch<false>(depth, flipped, batch);
            });
        }
    });
}

/// The general form: one call for each covered sample between the near and the far plane, triangle by triangle.
///
/// @param size    of the image in texels, each at most 16384
/// @param sample  (glm::ivec2 texel, float depth, unsigned triangle); does the depth test. Where depths tie, a callee
///                that wants results free of the triangles' order compares the triangles too
/// The rest as for rasterize_depth.
template <class Sample>
void rasterize(glm::ivec2 size, const mesh_view& mesh, const glm::mat4& world_to_clip, clip_space clip, Sample&& sample,
               cull_mode cull = cull_mode::none) {
    const bool flipped = clip.origin == texture_origin::top;
    const detail::projected_mesh projected(size, mesh, world_to_clip, clip, serial{});
    const auto triangles = [&](const auto& use) {
        for (unsigned i = 0; i < projected.triangle_count(); ++i) use(i);
    };
    projected.for_each_batch(triangles, {{0, 0}, size}, cull, [&](const triangle_batch& batch) {
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
}

/// Perspective-correct weights of a triangle's vertices at the centre of a texel.
///
/// @param triangle  index into mesh.triangles; its vertices may be behind the camera
/// @return      weights that are not negative and sum to 1: a texel that snapping moved out of the triangle gets the
///              weights of the nearest edge; (1, 0, 0) for a triangle seen edge-on or not finite
/// @formula     b_i ~ (x_j - X w_j)(y_k - Y w_k) - (y_j - Y w_j)(x_k - X w_k), homogeneous texels; no division by w
/// @cite        Olano, Greer: Triangle Scan Conversion using 2D Homogeneous Coordinates, Graphics Hardware 1997
[[nodiscard]] inline glm::vec3 barycentrics(glm::ivec2 size, const mesh_view& mesh, const glm::mat4& world_to_clip,
                                            clip_space clip, glm::ivec2 texel, unsigned triangle) {
    assert(triangle < mesh.triangles.size());
    const projection project(world_to_clip, clip, size);
    const double centre_x = texel.x + 0.5;
    const double centre_y = clip.origin == texture_origin::top ? size.y - texel.y - 0.5 : texel.y + 0.5;
    std::array<glm::dvec2, 3> from;  // the centre to each vertex, times w
    for (int i = 0; i < 3; ++i) {
        const auto h = project.homogeneous(mesh.positions[mesh.triangles[triangle][i]]);
        from[std::size_t(i)] = {h.x - centre_x * h.w, h.y - centre_y * h.w};
    }
    const auto cross = [](glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; };
    std::array<double, 3> weights{cross(from[1], from[2]), cross(from[2], from[0]), cross(from[0], from[1])};
    const double signed_sum = weights[0] + weights[1] + weights[2];
    double sum = 0.0;
    for (auto& w : weights) {
        if (signed_sum < 0.0) w = -w;
        sum += w = w > 0.0 ? w : 0.0;
    }
    if (!is_finite(signed_sum) || sum == 0.0) return {1.0f, 0.0f, 0.0f};
    return {weights[0] / sum, weights[1] / sum, weights[2] / sum};
}

}  // namespace umbrage

// ---- umbrage/image_ops/filters.hpp
// The filters as values, for functions over images.
//
//     umbrage::visibility(map.view(), umbrage::rg<11>{}, receivers.view(), umbrage::filters::box{.radius = 2}, out.view());
//

namespace umbrage {

/// The filters as values: what they need beyond map, coordinate and receiver.
namespace filters {

struct hard {
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::hard(fetch, coord, receiver);
    }
};

struct four_tap {
    std::array<glm::vec2, 4> offsets = default_taps<float>;  ///< in texels

    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::four_tap(fetch, coord + offsets[0], coord + offsets[1], coord + offsets[2], coord + offsets[3],
                                 receiver);
    }
};

struct pcf_2x2 {
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::pcf_2x2(fetch, coord, receiver);
    }
};

struct pcf_2x2_dx_sdk {
    float epsilon = 0.0f;  ///< in depth

    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::pcf_2x2_dx_sdk(fetch, coord, receiver, epsilon);
    }
};

struct box {
    int radius = 1;  ///< clamped to 0..8

    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::box(fetch, coord, receiver, radius);
    }
};

/// The same result; for images of receivers it first asks, for the whole box, whether all of it is lit or in shadow.
/// Pays off for large radii, and where shadows have more inside than border.
struct hierarchical_box {
    int radius = 1;  ///< clamped to 0..8

    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::box(fetch, coord, receiver, radius);
    }
};

}  // namespace filters

}  // namespace umbrage

// ---- umbrage/image_ops/visibility_blocks.hpp
// The filters over blocks of 64 receivers: what visibility() is made of. Each does a filter in three loops: where to
// look (vectorised), the loads (one for two neighbours), and compare and weigh (vectorised).
//
//     umbrage::detail::receiver_block r;
//     umbrage::detail::block_filter<umbrage::filters::pcf_2x2, umbrage::rg<11>>{map, {}, {}}(r, visibility, isa);
//

namespace umbrage::detail {

/// Texels, texels, depth; what lies behind the last receiver of a row is not read into any result.
struct receiver_block {
    alignas(64) float x[block]{}, y[block]{}, z[block]{};
};

/// less_equal as a number. -ffast-math makes compilers forget what NaN does to <=; then the bits say it.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t is_lit(float receiver, float stored) {
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
    const auto number = [](float v) UMBRAGE_INLINE { return std::int32_t((std::bit_cast<std::int32_t>(v) & 0x7FFFFFFF) <= 0x7F800000); };
    return std::int32_t(receiver <= stored) & number(receiver) & number(stored);
#else
    return std::int32_t(receiver <= stored);
#endif
}

/// inside_texel_space as a mask: all bits, or none.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t texel_space_mask(float x, float y) {
    constexpr auto limit = std::bit_cast<std::int32_t>(32768.0f);
    return -(std::int32_t((std::bit_cast<std::int32_t>(x) & 0x7FFFFFFF) < limit) &
             std::int32_t((std::bit_cast<std::int32_t>(y) & 0x7FFFFFFF) < limit));
}
[[nodiscard]] UMBRAGE_INLINE inline float masked(float v, std::int32_t mask) {
    return std::bit_cast<float>(std::bit_cast<std::int32_t>(v) & mask);
}
[[nodiscard]] UMBRAGE_INLINE inline float select(std::int32_t mask, float a, float b) {
    return std::bit_cast<float>((std::bit_cast<std::int32_t>(a) & mask) | (std::bit_cast<std::int32_t>(b) & ~mask));
}
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t floor_int(float v) {  // |v| < 2^31
    const auto toward_zero = static_cast<std::int32_t>(v);
    return toward_zero - std::int32_t(static_cast<float>(toward_zero) > v);
}
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t clamp_int(std::int32_t v, std::int32_t highest) {
    v = v > 0 ? v : 0;
    return v < highest ? v : highest;
}

/// What is loaded for a block of receivers: a texel each, or two neighbours. The depths in them and the
/// receiver's are asked for in loops that vectorise; this general form decodes while it loads.
template <class Encoding>
struct loaded_texels {
    const Encoding& encoding;
    float depths[2 * block];
    explicit loaded_texels(const Encoding& e) : encoding(e) {}
    UMBRAGE_INLINE void load_one(int i, const typename Encoding::texel* t) { depths[i] = encoding.decode(*t); }
    UMBRAGE_INLINE void load_two(int i, const typename Encoding::texel* t) {
        depths[2 * i] = encoding.decode(t[0]);
        depths[2 * i + 1] = encoding.decode(t[1]);
    }
    static UMBRAGE_INLINE float receiver(float depth) { return depth; }
    UMBRAGE_INLINE float one(int i) const { return depths[i]; }
    UMBRAGE_INLINE float first(int i) const { return depths[2 * i]; }
    UMBRAGE_INLINE float second(int i) const { return depths[2 * i + 1]; }
};

/// Floats need no decoding, but two of them are one load.
template <>
struct loaded_texels<depth32f> {
    float depths[2 * block];
    explicit loaded_texels(const depth32f&) {}
    UMBRAGE_INLINE void load_one(int i, const float* t) { depths[i] = *t; }
    UMBRAGE_INLINE void load_two(int i, const float* t) { std::memcpy(depths + 2 * i, t, 2 * sizeof(float)); }
    static UMBRAGE_INLINE float receiver(float depth) { return depth; }
    UMBRAGE_INLINE float one(int i) const { return depths[i]; }
    UMBRAGE_INLINE float first(int i) const { return depths[2 * i]; }
    UMBRAGE_INLINE float second(int i) const { return depths[2 * i + 1]; }
};

/// Byte pairs, two of them to a word. Both sides of the comparison stay 2^Bits times the depth, which changes no result.
template <int Bits>
struct loaded_texels<rg<Bits>> {
    static constexpr bool little = std::endian::native == std::endian::little;
    float edge;
    std::uint32_t words[block];
    explicit loaded_texels(const rg<Bits>& encoding) : edge(encoding.edge) {}
    UMBRAGE_INLINE void load_one(int i, const glm::u8vec2* t) {
        std::uint16_t word;
        std::memcpy(&word, t, sizeof word);
        words[i] = word;
    }
    UMBRAGE_INLINE void load_two(int i, const glm::u8vec2* t) { std::memcpy(words + i, t, sizeof *words); }
    static UMBRAGE_INLINE float receiver(float depth) { return depth * float(1 << Bits); }
    UMBRAGE_INLINE float one(int i) const { return number(codes(i) & 0xFFFF); }
    UMBRAGE_INLINE float first(int i) const { return number(little ? codes(i) & 0xFFFF : codes(i) >> 16); }
    UMBRAGE_INLINE float second(int i) const { return number(little ? codes(i) >> 16 : codes(i) & 0xFFFF); }
    /// R + 2^(Bits - 8) G of both texels at once, in the two halves of a word.
    UMBRAGE_INLINE std::uint32_t codes(int i) const {
        constexpr std::uint32_t low = 0x00FF00FF, high = low << (Bits - 8);
        const std::uint32_t w = words[i];
        return little ? (w & low) + (w >> (16 - Bits) & high) : (w >> 8 & low) + ((w & low) << (Bits - 8));
    }
    UMBRAGE_INLINE float number(std::uint32_t code) const { return static_cast<float>(static_cast<std::int32_t>(code)) + edge; }
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

/// Asks for the texels around some of a block's receivers. Where a block starts on another row of the map than the one
/// before, the machine cannot guess them, and would wait for memory at every block.
template <class T>
UMBRAGE_INLINE inline void prefetch_texels([[maybe_unused]] const image_view<T>& map, [[maybe_unused]] const receiver_block& r) {
#if defined(__GNUC__) || defined(__clang__)
    std::int32_t x[block / 16], y[block / 16];
    for (int i = 0; i < block / 16; ++i) {
        const float u = r.x[i * 16], v = r.y[i * 16];
        const std::int32_t inside = texel_space_mask(u, v);
        x[i] = clamp_int(floor_int(masked(u, inside)), map.size.x - 1);
        y[i] = clamp_int(floor_int(masked(v, inside)), map.size.y - 1);
    }
    for (int i = 0; i < block / 16; ++i) {
        __builtin_prefetch(texel_at(map, x[i], y[i]));
        __builtin_prefetch(texel_at(map, x[i], y[i] < map.size.y - 1 ? y[i] + 1 : y[i]));
    }
#endif
}

/// Any filter, one receiver after the other.
template <class Filter, class Encoding>
struct one_by_one {
    image_view<const typename Encoding::texel> map;
    const Encoding& encoding;
    const Filter& filter;

    UMBRAGE_INLINE void prefetch(const receiver_block&) const {}
    template <class Isa>
    UMBRAGE_INLINE void operator()(const receiver_block& r, int count, float* visibility, Isa) const {
        const auto fetch = decoded(map, encoding);
        for (int i = 0; i < count; ++i) visibility[i] = filter(fetch, glm::vec2(r.x[i], r.y[i]), r.z[i]);
    }
};

/// A receiver's own texel, clamped to the map, and the test against it, added to `count`.
template <class Encoding>
UMBRAGE_INLINE inline void add_hard(image_view<const typename Encoding::texel> map, const Encoding& encoding,
                                    const receiver_block& r, glm::vec2 offset, std::int32_t* count) {
    const texel_bytes memory(map);
    const int last_x = map.size.x - 1, last_y = map.size.y - 1;
    std::int32_t offsets[block], inside[block];
    loaded_texels<Encoding> texels(encoding);
    for (int i = 0; i < block; ++i) {
        const float x = r.x[i] + offset.x, y = r.y[i] + offset.y;
        inside[i] = texel_space_mask(x, y);
        offsets[i] = memory.offset(clamp_int(floor_int(masked(x, inside[i])), last_x),
                                   clamp_int(floor_int(masked(y, inside[i])), last_y));
    }
    for (int i = 0; i < block; ++i) texels.load_one(i, memory.at(offsets[i]));
    for (int i = 0; i < block; ++i) count[i] += (is_lit(texels.receiver(r.z[i]), texels.one(i)) & inside[i]) | (1 & ~inside[i]);
}

/// The filters that have a form for blocks; `least` is the side of the smallest map that it can take.
template <class Filter, class Encoding>
struct block_filter {
    static constexpr int least = 0;  ///< none
};

template <class Encoding>
struct block_filter<filters::hard, Encoding> {
    static constexpr int least = 1;
    image_view<const typename Encoding::texel> map;
    const Encoding& encoding;
    const filters::hard& filter;

    UMBRAGE_INLINE void prefetch(const receiver_block& r) const { prefetch_texels(map, r); }
    template <class Isa>
    UMBRAGE_INLINE void operator()(const receiver_block& r, int, float* visibility, Isa) const {
        std::int32_t lit[block]{};
        add_hard(map, encoding, r, glm::vec2(0.0f), lit);
        for (int i = 0; i < block; ++i) visibility[i] = static_cast<float>(lit[i]);
    }
};

template <class Encoding>
struct block_filter<filters::four_tap, Encoding> {
    static constexpr int least = 1;
    image_view<const typename Encoding::texel> map;
    const Encoding& encoding;
    const filters::four_tap& filter;

    UMBRAGE_INLINE void prefetch(const receiver_block& r) const { prefetch_texels(map, r); }
    template <class Isa>
    UMBRAGE_INLINE void operator()(const receiver_block& r, int, float* visibility, Isa) const {
        std::int32_t lit[block]{};
        for (const glm::vec2 offset : filter.offsets) add_hard(map, encoding, r, offset, lit);
        for (int i = 0; i < block; ++i) visibility[i] = static_cast<float>(lit[i]) * 0.25f;
    }
};

/// A position clamped to the middles of the map's border texels has the same neighbours and weights that add up to the
/// same, so that both neighbours are in the map and one load gets them.
template <class Encoding>
struct block_filter<filters::pcf_2x2, Encoding> {
    static constexpr int least = 2;
    image_view<const typename Encoding::texel> map;
    const Encoding& encoding;
    const filters::pcf_2x2& filter;

    UMBRAGE_INLINE void prefetch(const receiver_block& r) const { prefetch_texels(map, r); }
    template <class Isa>
    UMBRAGE_INLINE void operator()(const receiver_block& r, int, float* visibility, Isa) const {
        const texel_bytes memory(map);
        constexpr int far = 1 << 15;  // no position is farther
        const int last_x = (map.size.x < far ? map.size.x : far) - 1, last_y = (map.size.y < far ? map.size.y : far) - 1;
        std::int32_t offsets[block], inside[block];
        float hi_x[block], hi_y[block];
        loaded_texels<Encoding> low(encoding), high(encoding);
        const auto place = [](float coord, int last, float& hi) UMBRAGE_INLINE {
            const std::int32_t position = clamp_int(floor_int(coord * 256.0f) - 128, last * 256);
            const std::int32_t texel = (position >> 8) < last ? position >> 8 : last - 1;
            hi = static_cast<float>(position - texel * 256);
            return texel;
        };
        for (int i = 0; i < block; ++i) {
            inside[i] = texel_space_mask(r.x[i], r.y[i]);
            offsets[i] = memory.offset(place(masked(r.x[i], inside[i]), last_x, hi_x[i]),
                                       place(masked(r.y[i], inside[i]), last_y, hi_y[i]));
        }
        for (int i = 0; i < block; ++i) {
            low.load_two(i, memory.at(offsets[i]));
            high.load_two(i, memory.below(offsets[i]));
        }
        for (int i = 0; i < block; ++i) {
            const float z = low.receiver(r.z[i]), lo_x = 256.0f - hi_x[i], lo_y = 256.0f - hi_y[i];
            const auto weigh = [&](const auto& row) UMBRAGE_INLINE {
                return masked(lo_x, -is_lit(z, row.first(i))) + masked(hi_x[i], -is_lit(z, row.second(i)));
            };
            const float sum = lo_y * weigh(low) + hi_y[i] * weigh(high);
            visibility[i] = select(inside[i], sum * (1.0f / 65536.0f), 1.0f);
        }
    }
};

}  // namespace umbrage::detail

// ---- umbrage/image_ops/box_blocks.hpp
// The box filter over maps of floats: whole rows of the box are loaded at once, never one texel after the other.
//
//     std::int32_t lit = umbrage::detail::box_rows<8, 0>(map.stride, 5).count(row, 0, receiver);
//

namespace umbrage::detail {

#if defined(__GNUC__) || defined(__clang__)
#define UMBRAGE_HAS_VECTORS 1

/// Floats and numbers as wide as a register. The compiler's own vectors: they need no header and know no machine.
template <int Lanes>
struct vectors;
template <>
struct vectors<4> {
    typedef float floats __attribute__((vector_size(16)));
    typedef float unaligned __attribute__((vector_size(16), aligned(4), may_alias));
    typedef std::int32_t ints __attribute__((vector_size(16)));
};
template <>
struct vectors<8> {
    typedef float floats __attribute__((vector_size(32)));
    typedef float unaligned __attribute__((vector_size(32), aligned(4), may_alias));
    typedef std::int32_t ints __attribute__((vector_size(32)));
};

/// Lit texels of boxes that lie inside a map at least as wide as a register.
/// @tparam Lanes   of a register;   Whole  registers that a row of the box fills
template <int Lanes, int Whole>
struct box_rows {
    using floats = typename vectors<Lanes>::floats;
    using unaligned = typename vectors<Lanes>::unaligned;
    using ints = typename vectors<Lanes>::ints;
    std::ptrdiff_t stride;
    int width;
    std::int32_t window[3 * Lanes]{};  ///< lanes that the rest of a row has in a register, slid to where they are

    UMBRAGE_INLINE box_rows(std::ptrdiff_t bytes, int box_width) : stride(bytes), width(box_width) {
        for (int i = 0; i < width - Whole * Lanes; ++i) window[Lanes + i] = -1;
    }

    /// @param row     first texel of the box
    /// @param moved   by how much the last register of a row is moved back, so that it ends inside the map
    [[nodiscard]] UMBRAGE_INLINE std::int32_t count(const std::byte* row, std::ptrdiff_t moved, float receiver) const {
        ints lit{}, rest{};
        for (int j = 0; j < width; ++j, row += stride) {
            const float* texels = reinterpret_cast<const float*>(row);
            for (int i = 0; i < Whole; ++i) add(texels + i * Lanes, receiver, lit);
            add(texels + Whole * Lanes - moved, receiver, rest);
        }
        ints wanted;
        std::memcpy(&wanted, window + Lanes - moved, sizeof wanted);
        lit += rest & wanted;
        std::int32_t sum = 0;
        for (int i = 0; i < Lanes; ++i) sum += lit[i];
        return sum;
    }

    static UMBRAGE_INLINE void add(const float* texels, float receiver, ints& lit) {
        const floats stored = *reinterpret_cast<const unaligned*>(texels);
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
        lit -= (receiver <= stored) & (((ints)stored & 0x7FFFFFFF) <= 0x7F800000);
#else
        lit -= receiver <= stored;
#endif
    }
};
#else
#define UMBRAGE_HAS_VECTORS 0
#endif

/// Only maps of floats: others are decoded first, which costs less than decoding each texel for each of its boxes.
template <>
struct block_filter<filters::box, depth32f> {
    static constexpr int least = 1;
    image_view<const float> map;
    const depth32f& encoding;
    const filters::box& filter;

    UMBRAGE_INLINE void prefetch(const receiver_block& r) const { prefetch_texels(map, r); }
    template <class Isa>
    UMBRAGE_INLINE void operator()(const receiver_block& r, int count, float* visibility, Isa set) const {
#if UMBRAGE_HAS_VECTORS
        constexpr int lanes = Isa::value == isa::base ? 4 : 8;
        const int whole = (2 * clamp_int(filter.radius, max_box_radius) + 1) / lanes;
        if (map.size.x >= lanes * (whole + 1)) {
            if (whole == 0) return rows<lanes, 0>(r, count, visibility);
            if (whole == 1) return rows<lanes, 1>(r, count, visibility);
            if (whole == 2) return rows<lanes, 2>(r, count, visibility);
            if (lanes == 4 && whole == 3) return rows<4, 3>(r, count, visibility);
            if (lanes == 4) return rows<4, 4>(r, count, visibility);
        }
#endif
        one_by_one<filters::box, depth32f>{map, encoding, filter}(r, count, visibility, set);
    }

#if UMBRAGE_HAS_VECTORS
    template <int Lanes, int Whole>
    UMBRAGE_INLINE void rows(const receiver_block& r, int count, float* visibility) const {
        const int radius = clamp_int(filter.radius, max_box_radius), width = 2 * radius + 1;
        const box_rows<Lanes, Whole> box(map.stride, width);
        const texel_bytes memory(map);
        const int last_x = map.size.x - width, last_y = map.size.y - width, last_load = map.size.x - Lanes * (Whole + 1);
        std::int32_t xs[block], ys[block], offsets[block], moved[block], inside[block], in_space[block], lit[block]{};
        for (int i = 0; i < block; ++i) {
            in_space[i] = texel_space_mask(r.x[i], r.y[i]);
            const std::int32_t x = floor_int(masked(r.x[i], in_space[i])) - radius;
            const std::int32_t y = floor_int(masked(r.y[i], in_space[i])) - radius;
            inside[i] = std::int32_t(x >= 0) & std::int32_t(x <= last_x) & std::int32_t(y >= 0) & std::int32_t(y <= last_y);
            offsets[i] = memory.offset(x, y);
            moved[i] = x > last_load ? x - last_load : 0;
            xs[i] = x;
            ys[i] = y;
        }
        for (int i = 0; i < count; ++i) {
            if (is_nan(r.z[i]) || !in_space[i]) continue;
            lit[i] = inside[i] ? box.count(memory.data + offsets[i], moved[i], r.z[i])
                               : count_at_border<Lanes, Whole>({xs[i], ys[i]}, width, r.z[i]);
        }
        const float scale = box_scale<float>(radius);
        for (int i = 0; i < block; ++i)
            visibility[i] = select(-std::int32_t(lit[i] == width * width) | ~in_space[i], 1.0f, static_cast<float>(lit[i]) * scale);
    }

    /// The same from a copy of the box, the map's border texels repeated.
    template <int Lanes, int Whole>
    std::int32_t count_at_border(glm::ivec2 first, int width, float receiver) const {
        float texels[2 * max_box_radius + 1][(Whole + 1) * Lanes]{};
        for (int j = 0; j < width; ++j) {
            const float* row = texel_at(map, 0, clamp_int(first.y + j, map.size.y - 1));
            for (int i = 0; i < width; ++i) texels[j][i] = row[clamp_int(first.x + i, map.size.x - 1)];
        }
        return box_rows<Lanes, Whole>(sizeof texels[0], width).count(reinterpret_cast<const std::byte*>(texels), 0, receiver);
    }
#endif
};

}  // namespace umbrage::detail

// ---- umbrage/image_ops/pyramid.hpp
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

/// Floats as integers in the same order, -0 below +0, NaN below everything; and back.
[[nodiscard]] UMBRAGE_INLINE inline std::int32_t order_key(float v) {
    const auto bits = std::bit_cast<std::int32_t>(v);
    const std::int32_t number = -std::int32_t((bits & 0x7FFFFFFF) <= 0x7F800000);
    return ((bits ^ (bits >> 31 & 0x7FFFFFFF)) & number) | (INT32_MIN & ~number);
}
[[nodiscard]] UMBRAGE_INLINE inline float from_order_key(std::int32_t key) {
    return std::bit_cast<float>(key ^ (key >> 31 & 0x7FFFFFFF));
}
struct least_of {
    UMBRAGE_INLINE std::int32_t operator()(std::int32_t a, std::int32_t b) const { return a < b ? a : b; }
};
struct greatest_of {
    UMBRAGE_INLINE std::int32_t operator()(std::int32_t a, std::int32_t b) const { return a > b ? a : b; }
};

/// Each element from 2 x 2, in blocks of 64; what is beyond a border repeats it.
template <class Pick, class ParallelFor>
void halve(image_view<const float> from, image_view<float> to, Pick pick, ParallelFor&& parallel) {
    parallel(to.size.y, [&](int first, int last) {
        on_best_isa([&](auto) UMBRAGE_INLINE {
            std::int32_t keys[block];
            float ends[2][2 * block];
            for (int y = first; y < last; ++y) {
                const float* rows[2] = {from.row(2 * y), from.row(2 * y + 1 < from.size.y ? 2 * y + 1 : 2 * y)};
                for (int x = 0; x < to.size.x; x += block) {
                    const float *low = rows[0] + 2 * x, *high = rows[1] + 2 * x;
                    if (const int there = from.size.x - 2 * x; there < 2 * block) {
                        for (int i = 0; i < 2 * block; ++i) {
                            const int k = i < there ? i : there - 1;
                            ends[0][i] = low[k];
                            ends[1][i] = high[k];
                        }
                        low = ends[0];
                        high = ends[1];
                    }
                    for (int i = 0; i < block; ++i)
                        keys[i] = pick(pick(order_key(low[2 * i]), order_key(low[2 * i + 1])),
                                       pick(order_key(high[2 * i]), order_key(high[2 * i + 1])));
                    float* result = to.row(y) + x;
                    const int count = to.size.x - x < block ? to.size.x - x : block;
                    for (int i = 0; i < count; ++i) result[i] = from_order_key(keys[i]);
                }
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
[[nodiscard]] std::vector<depth_bounds> make_min_max_pyramid(image_view<const float> map, int levels, ParallelFor&& parallel = {}) {
    if (map.empty() || levels < 0) throw std::invalid_argument("umbrage::make_min_max_pyramid: empty map or negative levels");
    std::vector<depth_bounds> pyramid;
    for (int level = 0; level < levels; ++level) {
        const image_view<const float> least = level ? pyramid.back().least.view() : map;
        const image_view<const float> greatest = level ? pyramid.back().greatest.view() : map;
        const glm::ivec2 size((least.size.x + 1) / 2, (least.size.y + 1) / 2);
        depth_bounds next{image<float>(size), image<float>(size)};
        detail::halve(least, next.least.view(), detail::least_of{}, parallel);
        detail::halve(greatest, next.greatest.view(), detail::greatest_of{}, parallel);
        pyramid.push_back(std::move(next));
    }
    return pyramid;
}

}  // namespace umbrage

// ---- umbrage/image_ops/hierarchical.hpp
// The box filter for receivers most of which are wholly lit or wholly in shadow: those ask one number for the whole box.
// visibility() does it for filters::hierarchical_box; bit for bit what filters::box gives.
//
//     umbrage::visibility(map.view(), umbrage::depth32f{}, receivers, umbrage::filters::hierarchical_box{8}, out.view());
//

namespace umbrage::detail {

/// For every place where a box may start, the bounds of the squares of the pyramid that the box touches. A box of
/// 2r + 1 texels touches at most `cells` squares of 2^level texels in a row.
struct box_bounds {
    int level, cells;
    glm::ivec2 squares;       ///< of the level; a box starts at square -(cells - 1) .. squares - 1
    image<glm::vec2> bounds;  ///< least and greatest

    template <class ParallelFor>
    box_bounds(image_view<const float> map, int radius, ParallelFor&& parallel)
        : level(radius < 4 ? 1 : 2), cells(((1 << level) - 1 + 2 * radius) / (1 << level) + 1) {
        const std::vector<depth_bounds> pyramid = make_min_max_pyramid(map, level, parallel);
        squares = pyramid.back().least.size();
        const image<float> least = widened(pyramid.back().least, least_of{}, parallel);
        const image<float> greatest = widened(pyramid.back().greatest, greatest_of{}, parallel);
        bounds = image<glm::vec2>(squares + (cells - 1));
        for (int y = 0; y < bounds.size().y; ++y) {
            const float *a = least.view().row(y), *b = greatest.view().row(y);
            glm::vec2* to = bounds.view().row(y);
            for (int x = 0; x < bounds.size().x; ++x) to[x] = {a[x], b[x]};
        }
    }

    /// Pick over cells x cells elements, first along rows, then along columns. Rows are filled up to whole blocks.
    template <class Pick, class ParallelFor>
    [[nodiscard]] image<float> widened(const image<float>& from, Pick pick, ParallelFor&& parallel) const {
        const int width = (squares.x + cells - 1 + block - 1) / block * block;
        image<std::int32_t> rows({width, squares.y});
        image<float> out({width, squares.y + cells - 1});
        parallel(squares.y, [&](int first, int last) {
            std::vector<std::int32_t> keys(static_cast<std::size_t>(width + cells));
            for (int y = first; y < last; ++y) {
                const float* row = from.view().row(y);
                for (int x = 0; x < width + cells; ++x)
                    keys[static_cast<std::size_t>(x)] = order_key(row[clamp_int(x - (cells - 1), squares.x - 1)]);
                widen(pick, rows.view().row(y), width, [&](int k) { return keys.data() + k; });
            }
        });
        parallel(out.size().y, [&](int first, int last) {
            std::vector<std::int32_t> keys(static_cast<std::size_t>(width));
            for (int y = first; y < last; ++y) {
                widen(pick, keys.data(), width, [&](int k) {
                    return std::as_const(rows).view().row(clamp_int(y - (cells - 1) + k, squares.y - 1));
                });
                float* row = out.view().row(y);
                for (int x = 0; x < width; ++x) row[x] = from_order_key(keys[static_cast<std::size_t>(x)]);
            }
        });
        return out;
    }

    /// to[x] = pick of from(k)[x] over k < cells.
    template <class Pick, class From>
    void widen(Pick pick, std::int32_t* to, int width, From&& from) const {
        on_best_isa([&](auto) UMBRAGE_INLINE {
            for (int x = 0; x < width; x += block) {
                std::int32_t best[block];
                const std::int32_t* first = from(0) + x;
                for (int i = 0; i < block; ++i) best[i] = first[i];
                for (int k = 1; k < cells; ++k) {
                    const std::int32_t* other = from(k) + x;
                    for (int i = 0; i < block; ++i) best[i] = pick(best[i], other[i]);
                }
                for (int i = 0; i < block; ++i) to[x + i] = best[i];
            }
        });
    }
};

struct hierarchical_blocks {
    const box_bounds& tree;
    block_filter<filters::box, depth32f> brute_force;

    UMBRAGE_INLINE void prefetch(const receiver_block&) const {}

    template <class Isa>
    UMBRAGE_INLINE void operator()(const receiver_block& r, int count, float* visibility, Isa set) const {
        const int radius = clamp_int(brute_force.filter.radius, max_box_radius);
        const texel_bytes<const glm::vec2> memory(tree.bounds.view());
        const int before = tree.cells - 1, level = tree.level;
        const glm::ivec2 last = tree.bounds.size() - 1;
        std::int32_t offsets[block], open[block];
        glm::vec2 bounds[block];
        for (int i = 0; i < block; ++i) {
            const std::int32_t in_space = texel_space_mask(r.x[i], r.y[i]);
            const std::int32_t x = floor_int(masked(r.x[i], in_space)) - radius, y = floor_int(masked(r.y[i], in_space)) - radius;
            offsets[i] = memory.offset(clamp_int((x >> level) + before, last.x), clamp_int((y >> level) + before, last.y));
            open[i] = in_space;
        }
        for (int i = 0; i < block; ++i) bounds[i] = *memory.at(offsets[i]);
        for (int i = 0; i < block; ++i) {
            const std::int32_t lit = is_lit(r.z[i], bounds[i].x), dark = std::int32_t(r.z[i] > bounds[i].y);
            visibility[i] = select(-lit | ~open[i], 1.0f, 0.0f);
            open[i] &= ~-(lit | dark);
        }

        receiver_block rest;  // those that need the box
        float shares[block];
        int indices[block], found = 0;
        for (int i = 0; i < count; ++i) {
            indices[found] = i;
            rest.x[found] = r.x[i];
            rest.y[found] = r.y[i];
            rest.z[found] = r.z[i];
            found -= open[i];
        }
        if (found == 0) return;
        brute_force(rest, found, shares, set);
        for (int i = 0; i < found; ++i) visibility[indices[i]] = shares[i];
    }
};

}  // namespace umbrage::detail

// ---- umbrage/image_ops/visibility.hpp
// A whole image of receivers against a shadow map, with any filter and any encoding.
//
//     umbrage::visibility(map.view(), umbrage::rg<11>{}, receivers.view(), umbrage::filters::pcf_2x2{}, out.view());
//
// Straight from what a camera saw, with no image of receivers in between:
//
//     umbrage::depth_receivers seen{depth.view(), umbrage::receiver_matrix(inverse, to_texels, size, clip), bias};
//     umbrage::visibility(map.view(), umbrage::rg<11>{}, seen, umbrage::filters::pcf_2x2{}, out.view());
//
// Bit for bit what the filter gives for each receiver alone.

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
/// @throws std::invalid_argument  size below 1
[[nodiscard]] inline glm::mat4 receiver_matrix(const glm::mat4& clip_to_world, const glm::mat4& texture_matrix,
                                               glm::ivec2 size, clip_space clip) {
    if (size.x < 1 || size.y < 1) throw std::invalid_argument("umbrage::receiver_matrix: size below 1");
    const double up = clip.origin == texture_origin::bottom ? 1.0 : -1.0;
    glm::dmat4 to_clip(1.0);
    to_clip[0][0] = 2.0 / size.x;
    to_clip[1][1] = up * 2.0 / size.y;
    to_clip[3] = {-1.0, -up, 0.0, 1.0};
    if (clip.range == depth_range::minus_one_to_one) {
        to_clip[2][2] = 2.0;
        to_clip[3][2] = -1.0;
    }
    return glm::mat4(glm::dmat4(texture_matrix) * glm::dmat4(clip_to_world) * to_clip);
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

/// Most blocks are whole, and then the compiler knows how much there is to copy.
UMBRAGE_INLINE inline void copy_floats(float* to, const float* from, int count) {
    if (count == block)
        std::memcpy(to, from, block * sizeof(float));
    else
        std::memcpy(to, from, static_cast<std::size_t>(count) * sizeof(float));
}

/// Receivers x .. x + count of row y.
UMBRAGE_INLINE inline void load(const image_view<const glm::vec3>& receivers, int x, int y, int count, receiver_block& r) {
    const glm::vec3* from = receivers.row(y) + x;
    const auto copy = [&](int n) UMBRAGE_INLINE {
        for (int i = 0; i < n; ++i) {
            r.x[i] = from[i].x;
            r.y[i] = from[i].y;
            r.z[i] = from[i].z;
        }
    };
    count == block ? copy(block) : copy(count);
}
UMBRAGE_INLINE inline void load(const receiver_planes& receivers, int x, int y, int count, receiver_block& r) {
    copy_floats(r.x, receivers.x.row(y) + x, count);
    copy_floats(r.y, receivers.y.row(y) + x, count);
    copy_floats(r.z, receivers.depth.row(y) + x, count);
}

/// receiver_at for a block.
inline void load(const depth_receivers& seen, int first, int row, int count, receiver_block& r) {
    copy_floats(r.z, seen.depth.row(row) + first, count);
    on_best_isa_without_fma([&](auto) UMBRAGE_INLINE {
        const glm::mat4 m = seen.matrix;
        const float bias = seen.bias;
        const float y = static_cast<float>(row) + 0.5f;
        for (int i = 0; i < block; ++i) {
            const float x = static_cast<float>(first + i) + 0.5f, depth = r.z[i];
            const auto sum = [&](int k) UMBRAGE_INLINE { return m[3][k] + m[0][k] * x + m[1][k] * y + m[2][k] * depth; };
            const float w = sum(3);
            const auto bits = std::bit_cast<std::int32_t>(w);
            const std::int32_t in_front = -(std::int32_t(bits > 0) & std::int32_t(bits <= 0x7F800000));
            r.x[i] = select(in_front, sum(0) / w, 65536.0f);
            r.y[i] = select(in_front, sum(1) / w, 65536.0f);
            r.z[i] = masked(sum(2) / w, in_front) - bias;
        }
    });
}

[[nodiscard]] inline glm::ivec2 size_of(const image_view<const glm::vec3>& receivers) { return receivers.size; }
[[nodiscard]] inline glm::ivec2 size_of(const depth_receivers& receivers) { return receivers.depth.size; }
[[nodiscard]] inline glm::ivec2 size_of(const receiver_planes& receivers) {
    if (receivers.x.size != receivers.depth.size || receivers.y.size != receivers.depth.size)
        throw std::invalid_argument("umbrage::visibility: sizes differ");
    return receivers.depth.size;
}

/// Every receiver through a filter in either form.
template <class Receivers, class Filter, class ParallelFor>
void filter_rows(const Receivers& receivers, const Filter& filter, image_view<float> out, ParallelFor&& parallel) {
    const int per_row = (out.size.x + block - 1) / block;
    parallel(out.size.y, [&](int first, int last) {
        on_best_isa([&](auto set) UMBRAGE_INLINE {
            receiver_block receivers_of[2];  // of this block and the next, whose texels are on their way meanwhile
            float visibility[block];
            const auto start = [&](int row, int n) UMBRAGE_INLINE {
                const int x = n * block, count = out.size.x - x < block ? out.size.x - x : block;
                load(receivers, x, row, count, receivers_of[n & 1]);
                filter.prefetch(receivers_of[n & 1]);
                return count;
            };
            for (int y = first; y < last; ++y) {
                int count = start(y, 0);
                for (int n = 0; n < per_row; ++n) {
                    const int next = n + 1 < per_row ? start(y, n + 1) : 0;
                    filter(receivers_of[n & 1], count, visibility, set);
                    copy_floats(out.row(y) + n * block, visibility, count);
                    count = next;
                }
            }
        });
    });
}

template <class Encoding, class Receivers, class Filter, class ParallelFor>
void filter_image(image_view<const typename Encoding::texel> map, const Encoding& encoding, const Receivers& receivers,
                  const Filter& filter, image_view<float> out, ParallelFor&& parallel) {
    if (size_of(receivers) != out.size) throw std::invalid_argument("umbrage::visibility: sizes differ");
    if (map.empty()) throw std::invalid_argument("umbrage::visibility: empty map");
    if (out.empty()) return;
    constexpr bool hierarchical = std::is_same_v<Filter, filters::hierarchical_box>;
    if constexpr ((hierarchical || std::is_same_v<Filter, filters::box>) && !std::is_same_v<Encoding, depth32f>) {
        // As floats, unless that is more work than the boxes.
        const auto texels = [](glm::ivec2 size) { return static_cast<double>(size.x) * size.y; };
        if (texels(map.size) < 16.0 * texels(out.size)) {
            image<float> depth(map.size);
            decode(map, depth.view(), encoding, parallel);
            return filter_image(image_view<const float>(depth), depth32f{}, receivers, filter, out, parallel);
        }
    }
    if constexpr (hierarchical && std::is_same_v<Encoding, depth32f>)
        if (texel_bytes<const float>::fits(map)) {
            const filters::box box{filter.radius};
            const box_bounds tree(map, clamp_int(box.radius, max_box_radius), parallel);
            return filter_rows(receivers, hierarchical_blocks{tree, {map, encoding, box}}, out, parallel);
        }
    using blocks = block_filter<Filter, Encoding>;
    if constexpr (blocks::least > 0)
        if (map.size.x >= blocks::least && map.size.y >= blocks::least &&
            texel_bytes<const typename Encoding::texel>::fits(map))
            return filter_rows(receivers, blocks{map, encoding, filter}, out, parallel);
    filter_rows(receivers, one_by_one<Filter, Encoding>{map, encoding, filter}, out, parallel);
}

}  // namespace detail

/// @param map         shadow map, texels of the encoding; outside, the nearest texel inside counts
/// @param encoding    how the map's texels hold depth; its edge decides ties
/// @param receivers   (x, y) in texels of the map, z depth, biased
/// @param filter      one of filters::, or any callable (fetch, coord, receiver) -> visibility
/// @param out         visibility, 1 lit; same size as receivers
/// @param parallel    cuts the rows into pieces, see parallel.hpp; the filter is then called from all of them
/// @throws std::invalid_argument  sizes differ, or the map is empty
template <class Encoding, class Filter, class ParallelFor = serial>
void visibility(image_view<const typename Encoding::texel> map, Encoding encoding,
                image_view<const glm::vec3> receivers, Filter filter, image_view<float> out,
                ParallelFor&& parallel = {}) {
    detail::filter_image(map, encoding, receivers, filter, out, parallel);
}

/// Receivers as a structure of arrays.
template <class Encoding, class Filter, class ParallelFor = serial>
void visibility(image_view<const typename Encoding::texel> map, Encoding encoding, const receiver_planes& receivers,
                Filter filter, image_view<float> out, ParallelFor&& parallel = {}) {
    detail::filter_image(map, encoding, receivers, filter, out, parallel);
}

/// Receivers from a camera's depth image: visibility of receiver_at for each of its texels.
template <class Encoding, class Filter, class ParallelFor = serial>
void visibility(image_view<const typename Encoding::texel> map, Encoding encoding, const depth_receivers& receivers,
                Filter filter, image_view<float> out, ParallelFor&& parallel = {}) {
    detail::filter_image(map, encoding, receivers, filter, out, parallel);
}

}  // namespace umbrage

// ---- umbrage/light/directional_light.hpp
// A directional light's space: the classic course exercise's set-up, and the tight fit to bounds.
//
//     auto light = umbrage::make_directional_light({.direction = d, .map_size = 1024});
//     auto tight = umbrage::fit_directional_light({.direction = d, .low = scene_low, .high = scene_high});
//

namespace umbrage {

template <real T = float>
struct directional_light {
    glm::vec<3, T> direction{T(0), T(-1), T(0)};  ///< any length > 0
    glm::vec<3, T> target{T(0)};                  ///< what it looks at
    glm::vec<3, T> up{T(0), T(1), T(0)};          ///< hint; may be parallel to direction
    T offset = T(10);                             ///< from target back to the light, world units
    int map_size = 1024;                          ///< texels, >= 1
    T divisor = T(10);                            ///< texels per world unit, > 0
    T z_near = T(0.1);                            ///< world units from the light
    T z_far = T(100);
    clip_space clip{};
};

/// The exercise's set-up: position = target - unit direction * offset, width = height = map_size / divisor.
/// @throws std::invalid_argument  zero or non-finite direction, map_size or divisor not above 0, planes out of order
template <real T = float>
[[nodiscard]] light_space<T> make_directional_light(const directional_light<T>& light) {
    if (light.map_size < 1 || !is_finite(light.divisor) || !(light.divisor > T(0)))
        throw std::invalid_argument("umbrage::make_directional_light: map_size and divisor must be above 0");
    // along the normalised direction, moved by the offset: the view's last row holds the light's distance
    light_space<T> space{look_along(light.target, light.direction, light.up, light.clip.hand), {}, light.clip};
    space.view[3][2] += light.clip.hand == handedness::right ? -light.offset : light.offset;
    if (!is_finite(space.view[3][2]))
        throw std::invalid_argument("umbrage::make_directional_light: offset must be finite");
    const T half = T(light.map_size) / light.divisor / T(2);
    space.projection = orthographic(glm::vec<2, T>(-half), glm::vec<2, T>(half), light.z_near, light.z_far, light.clip);
    return space;
}

template <real T = float>
struct directional_fit {
    glm::vec<3, T> direction{T(0), T(-1), T(0)};  ///< any length > 0
    glm::vec<3, T> up{T(0), T(1), T(0)};          ///< hint; may be parallel to direction
    glm::vec<3, T> low{T(-1)}, high{T(1)};        ///< bounds of all casters and receivers, low <= high
    T margin = T(0.01);                           ///< added on every side, as a share of the bounds' diagonal, > 0
    clip_space clip{};
};

/// The smallest box along the light that holds the bounds, and the margin.
/// @throws std::invalid_argument  zero or non-finite direction, bounds empty, inverted or of no extent
template <real T = float>
[[nodiscard]] light_space<T> fit_directional_light(const directional_fit<T>& fit) {
    const T diagonal = glm::length(fit.high - fit.low);
    if (!is_finite(diagonal) || !(diagonal > T(0)) || glm::any(glm::greaterThan(fit.low, fit.high)))
        throw std::invalid_argument("umbrage::fit_directional_light: bounds must be finite, in order, of some extent");
    if (!is_finite(fit.margin) || !(fit.margin > T(0)))
        throw std::invalid_argument("umbrage::fit_directional_light: margin must be above 0");
    light_space<T> space{look_along((fit.low + fit.high) * T(0.5), fit.direction, fit.up, fit.clip.hand), {}, fit.clip};
    // the box is centred on the bounds' centre, so it is enough to know how far it reaches
    const glm::vec<3, T> half = (fit.high - fit.low) * T(0.5);
    glm::vec<3, T> reach(fit.margin * diagonal);
    for (int row = 0; row < 3; ++row)
        for (int i = 0; i < 3; ++i) reach[row] += glm::abs(space.view[i][row]) * half[i];
    space.projection = orthographic(glm::vec<2, T>(-reach.x, -reach.y), glm::vec<2, T>(reach.x, reach.y), -reach.z,
                                    reach.z, fit.clip);
    return space;
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
    glm::vec<3, T> direction{T(0), T(-1), T(0)};      ///< any length > 0
    glm::vec<3, T> up{T(0), T(1), T(0)};              ///< hint; may be parallel to direction
    T outer_angle_radians = std::numbers::pi_v<T> / 6; ///< between axis and edge of the cone, above 0, below pi / 2
    T z_near = T(0.1);                                ///< > 0, world units
    T z_far = T(100);                                 ///< > z_near
    clip_space clip{};
};

/// View and perspective projection around the light's cone, which the square map holds whole.
/// @throws std::invalid_argument  zero or non-finite direction, angle outside (0, pi / 2), planes out of order
template <real T = float>
[[nodiscard]] light_space<T> make_spot_light(const spot_light<T>& light) {
    if (!is_finite(light.outer_angle_radians) || !(light.outer_angle_radians > T(0)) ||
        !(light.outer_angle_radians < std::numbers::pi_v<T> / 2))
        throw std::invalid_argument("umbrage::make_spot_light: outer_angle_radians must lie between 0 and pi / 2");
    const T extent = std::tan(light.outer_angle_radians);
    return {look_along(light.position, light.direction, light.up, light.clip.hand),
            perspective(extent, extent, light.z_near, light.z_far, light.clip), light.clip};
}

}  // namespace umbrage

// ---- umbrage/view/overlay.hpp
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
        return v > low ? static_cast<float>((double(v) - low) / (double(high) - low)) : 0.0f;
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
    if (!(outliers >= 0.0 && outliers < 0.5)) throw std::invalid_argument("umbrage::stretch: outliers not in [0, 1/2)");
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
    glm::ivec2 size{0, 0};  ///< in texels of the picture; a zero takes the map's own side
    texture_origin map_origin = texture_origin::bottom;   ///< where row 0 of the map is
    texture_origin picture_origin = texture_origin::top;  ///< where row 0 of the picture is; image files: at the top
};

/// Draws a map into the top left corner of a picture, scaled to the nearest texel. What does not fit is cut off.
///
/// @param colour  float -> colour, given the map's texels as they are: a float is a grey, a vec3 red, green and blue,
///                all in [0, 1]
/// @throws std::invalid_argument  negative size
template <class Colour>
void overlay(image_view<glm::u8vec3> picture, image_view<const float> map, const overlay_placement& place,
             Colour&& colour) {
    if (place.size.x < 0 || place.size.y < 0) throw std::invalid_argument("umbrage::overlay: negative size");
    if (map.empty()) return;
    const glm::ivec2 size{place.size.x ? place.size.x : map.size.x, place.size.y ? place.size.y : map.size.y};
    const auto nearest = [](int i, int count, int from) {
        return static_cast<int>((2 * std::int64_t{i} + 1) * from / (2 * std::int64_t{count}));
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

// ---- umbrage/umbrage.hpp
// All of umbrage. Includes only; each header also stands alone.

