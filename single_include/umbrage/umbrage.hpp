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
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <initializer_list>
#include <limits>
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
///   c  within snippet::ulp units in the last place: division, square root, trigonometry
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
    int ulp = 0;                           ///< tier c: greatest distance from the C++ twin
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
    std::array<char, Capacity> data{};
    std::size_t size = 0;
    [[nodiscard]] constexpr std::string_view view() const { return {data.data(), size}; }
};

struct constant {
    char key;  ///< `$key` in the text
    unsigned value;
};

/// Replaces each `$key` by the decimal digits of its value.
template <std::size_t Capacity>
constexpr filled_text<Capacity> fill(std::string_view text, std::initializer_list<constant> constants) {
    filled_text<Capacity> out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '$') {
            out.data[out.size++] = text[i];
            continue;
        }
        ++i;
        for (const constant& c : constants) {
            if (c.key != text[i]) continue;
            unsigned unit = 1;
            while (c.value / unit >= 10) unit *= 10;
            for (; unit > 0; unit /= 10) out.data[out.size++] = static_cast<char>('0' + c.value / unit % 10);
        }
    }
    return out;
}

}  // namespace detail
}  // namespace umbrage::glsl

// ---- umbrage/image.hpp
// Images: a view over anybody's pixels, an owner, and the two ways to fetch a texel.
//
//     umbrage::image<float> map({1024, 1024}, 1.0f);
//     umbrage::image_view<const float> foreign(pixels, {width, height}, bytes_per_row);
//     float depth = umbrage::clamped(foreign)(glm::ivec2(-1, 5));  // the texel at (0, 5)
//

namespace umbrage {

/// Pixels that somebody else owns: rows of `size.x` elements, `stride` bytes from one row to the next.
/// Row 0 is the first in memory. A negative stride walks a bottom-up image; an empty view has a zero in its size.
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
    [[nodiscard]] std::span<T> texels() { return texels_; }
    [[nodiscard]] std::span<const T> texels() const { return texels_; }

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
/// @exactness   A: selects, never computes
template <real T>
[[nodiscard]] constexpr T saturate(T v) {
    if (is_nan(v)) return T(1);
    return v < T(1) ? (v > T(0) ? v : T(0)) : T(1);
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
/// @formula     (k + (k + 64) / 256) / 256
/// @exactness   A: 17 significant bits
template <real T>
[[nodiscard]] constexpr T to_unorm(T k) {
    return (k + (k + T(64)) * T(1.0 / 256.0)) * T(1.0 / 256.0);
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
/// @exactness   A for any value that lies nearer to k / 255 than to its neighbours' midpoints by 2^-15
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
    return (k + (k + 64.0) * (1.0 / 256.0)) * (1.0 / 256.0);
}
UMBRAGE_HIGHP vec2 umbrage_to_unorm(UMBRAGE_HIGHP vec2 k) {
    return (k + (k + 64.0) * (1.0 / 256.0)) * (1.0 / 256.0);
}
UMBRAGE_HIGHP vec3 umbrage_to_unorm(UMBRAGE_HIGHP vec3 k) {
    return (k + (k + 64.0) * (1.0 / 256.0)) * (1.0 / 256.0);
}
UMBRAGE_HIGHP vec4 umbrage_to_unorm(UMBRAGE_HIGHP vec4 k) {
    return (k + (k + 64.0) * (1.0 / 256.0)) * (1.0 / 256.0);
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

// ---- umbrage/version.hpp
// The version of umbrage. CMake reads it from here.

#define UMBRAGE_VERSION_MAJOR 0
#define UMBRAGE_VERSION_MINOR 1
#define UMBRAGE_VERSION_PATCH 0

// ---- umbrage/image_ops/clip.hpp
// From world positions to vertices on the 1/256 texel grid: projection, clipping, snapping. The rasterizer's first half.
//
//     umbrage::projection project(world_to_clip, clip, {1024, 1024});
//     umbrage::clipped_polygon polygon = umbrage::clip_triangle(project, a, b, c);
//
// Texels are counted from the bottom in here (NDC y = -1), whatever the clip space says: the texture origin only mirrors
// rows when texels are written, so that both origins give the same picture.
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
    double depth;       ///< z/w moved to [0, 1]; above 1 or below 0 beyond the far plane

    friend auto operator<=>(const snapped_vertex&, const snapped_vertex&) = default;
};

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
        switch (plane) {  // what lies on the plane by definition does so to the bit
            case 0: h.w = smallest_w; break;
            case 1: h.z = clip_.direction == depth_direction::forward ? 0.0 : h.w; break;
            case 2: h.x = -guard_band * h.w; break;
            case 3: h.x = guard_band * h.w; break;
            case 4: h.y = -guard_band * h.w; break;
            default: h.y = guard_band * h.w; break;
        }
        return h;
    }

    /// To the grid, halves upwards. The point must be inside all planes; the clamp only catches the rounding of cut().
    [[nodiscard]] snapped_vertex snap(const glm::dvec4& h) const {
        constexpr double limit = double(guard_band) * subtexels;
        const auto grid = [&](double v) {
            const double steps = v / h.w * subtexels + 0.5;
            const double inside = steps > -limit ? (steps < limit ? steps : limit) : -limit;
            const auto whole = static_cast<std::int32_t>(inside);
            return whole - (inside < whole ? 1 : 0);
        };
        return {grid(h.x), grid(h.y), h.z / h.w};
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
// Vertices are snapped to 1/256 texel, edges are evaluated in integers at texel centres, and ties go by the top-left rule
// (top and left as NDC has them, for either texture origin). Depth is a plane whose coefficients are rounded to a grid on
// which every sample is then computed exactly. So no order of triangles or vertices, no tiling, no instruction set and no
// contraction to FMA changes a bit.
//

namespace umbrage {

/// Triangles that somebody else owns: three indices into the positions each.
struct mesh_view {
    std::span<const glm::vec3> positions;
    std::span<const glm::uvec3> triangles;
};

/// Which faces to leave out. The front goes counter-clockwise in NDC, x to the right and y up.
enum class cull_mode { none, front, back };

/// Depth over a triangle, exact on its grid: z + dx * x + dy * y for texels x, y counted from `first`.
struct depth_plane {
    glm::ivec2 first;        ///< a texel within the triangle's bounds
    double z, dx, dy;        ///< multiples of one power of two, so that no sum of theirs within the bounds is rounded
    double lowest, highest;  ///< of the vertices; samples never leave it

    [[nodiscard]] double operator()(int x, int y) const {
        const double depth = z + dx * (x - first.x) + dy * (y - first.y);
        return depth > lowest ? (depth < highest ? depth : highest) : lowest;
    }
};

/// The plane through three vertices, anchored at the first, which must be the smallest of them.
///
/// @param area   twice the signed area in squares of the vertex grid, not 0
/// @exactness    B: the same bits with and without FMA. With n the bounds' larger side in 1/256 texel and m the sum of
///               the depth's and the two slopes' magnitudes over the bounds, a sample is within 2^-48 n m of the plane
///               through the snapped vertices
[[nodiscard]] inline depth_plane make_depth_plane(const std::array<snapped_vertex, 3>& v, double area, glm::ivec2 first) {
    const auto magnitude = [](double a) { return a < 0.0 ? -a : a; };
    const auto largest = [](double a, double b) { return a < b ? b : a; };
    const auto round_down = [](double a) {  // to a power of two
        return std::bit_cast<double>(std::bit_cast<std::uint64_t>(a) & 0x7FF0000000000000u);
    };
    const auto on_grid = [](double a, double unit) {
        return static_cast<double>(static_cast<std::int64_t>(a / unit)) * unit;
    };
    const double x1 = v[1].x - v[0].x, y1 = v[1].y - v[0].y, x2 = v[2].x - v[0].x, y2 = v[2].y - v[0].y;
    const double width = largest(magnitude(x1), largest(magnitude(x2), magnitude(x1 - x2)));
    const double height = largest(magnitude(y1), largest(magnitude(y2), magnitude(y1 - y2)));

    // Depths with so few digits that the products with x1 .. y2 and their differences need no rounding.
    constexpr double tiny = 0x1p-200;
    double unit = largest(tiny, largest(magnitude(v[0].depth), largest(magnitude(v[1].depth), magnitude(v[2].depth))));
    unit = round_down(unit) * round_down(largest(width, height)) * 0x1p-49;
    const double z0 = on_grid(v[0].depth, unit), z1 = on_grid(v[1].depth, unit), z2 = on_grid(v[2].depth, unit);
    const double slope_x = ((z1 - z0) * y2 + (z2 - z0) * -y1) / area;
    const double slope_y = ((z2 - z0) * x1 + (z1 - z0) * -x2) / area;

    // Slopes with so few digits that the same holds for every sample.
    unit = round_down(largest(tiny, magnitude(z0) + magnitude(slope_x) * width + magnitude(slope_y) * height)) * 0x1p-51;
    const double dx = on_grid(slope_x, unit), dy = on_grid(slope_y, unit);
    constexpr int centre = subtexels / 2;
    return {.first = first,
            .z = on_grid(z0, unit) + dx * (first.x * subtexels + centre - v[0].x) + dy * (first.y * subtexels + centre - v[0].y),
            .dx = dx * subtexels,
            .dy = dy * subtexels,
            .lowest = z0 < z1 ? (z0 < z2 ? z0 : z2) : (z1 < z2 ? z1 : z2),
            .highest = largest(z0, largest(z1, z2))};
}

/// One triangle on the grid, row by row.
///
/// @param v     vertices within the guard band, the smallest first
/// @param size  of the image in texels
/// @param row   (int y, int x_first, int x_last, const depth_plane&): texels x_first <= x < x_last of row y are covered;
///              y counts from the bottom
/// @formula     covered: for each edge, E >= 0, or E > 0 where the edge is neither a top nor a left one
/// @exactness   A: 64-bit integers
template <class Row>
void rasterize_snapped(std::array<snapped_vertex, 3> v, glm::ivec2 size, cull_mode cull, Row&& row) {
    const auto area_of = [&] {
        return std::int64_t(v[1].x - v[0].x) * (v[2].y - v[0].y) - std::int64_t(v[2].x - v[0].x) * (v[1].y - v[0].y);
    };
    const std::int64_t area = area_of();
    if (area == 0 || cull == (area > 0 ? cull_mode::front : cull_mode::back)) return;
    if (area < 0) std::swap(v[1], v[2]);

    // texels whose centres are within the bounds
    constexpr int centre = subtexels / 2;
    const auto first_from = [](int low) { return low <= centre ? 0 : (low - centre + subtexels - 1) / subtexels; };
    const auto last_to = [](int high, int count) {
        return high < centre ? -1 : std::min((high - centre) / subtexels, count - 1);
    };
    const glm::ivec2 first{first_from(std::min({v[0].x, v[1].x, v[2].x})), first_from(std::min({v[0].y, v[1].y, v[2].y}))};
    const glm::ivec2 last{last_to(std::max({v[0].x, v[1].x, v[2].x}), size.x), last_to(std::max({v[0].y, v[1].y, v[2].y}), size.y)};
    if (first.x > last.x || first.y > last.y) return;

    struct edge {
        std::int64_t value, step_x, step_y;  // at the first texel of the row; per texel
    };
    std::array<edge, 3> edges;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& a = v[i];
        const auto& b = v[i < 2 ? i + 1 : 0];
        const std::int64_t dx = b.x - a.x, dy = b.y - a.y;
        const bool top_left = dy < 0 || (dy == 0 && dx < 0);
        edges[i] = {dx * (first.y * subtexels + centre - a.y) - dy * (first.x * subtexels + centre - a.x) - (top_left ? 0 : 1),
                    -dy * subtexels, dx * subtexels};
    }

    const auto plane = make_depth_plane(v, static_cast<double>(area_of()), first);
    for (int y = first.y; y <= last.y; ++y) {
        std::int64_t low = 0, high = last.x - first.x;  // steps from first.x for which no edge is negative
        for (auto& e : edges) {
            if (e.step_x > 0 && e.value < 0) low = std::max(low, (-e.value + e.step_x - 1) / e.step_x);
            if (e.step_x < 0) high = e.value < 0 ? -1 : std::min(high, e.value / -e.step_x);
            if (e.step_x == 0 && e.value < 0) high = -1;
            e.value += e.step_y;
        }
        if (low <= high) row(y, first.x + int(low), first.x + int(high) + 1, plane);
    }
}

/// All triangles of a mesh, row by row; what rasterize and rasterize_depth share.
///
/// @param row   (int y, int x_first, int x_last, const depth_plane&, unsigned triangle), y counting from the bottom
/// @throws std::invalid_argument  an index is out of range; a side of the image is above guard_band
template <class Row>
void rasterize_rows(glm::ivec2 size, const mesh_view& mesh, const glm::mat4& world_to_clip, clip_space clip,
                    cull_mode cull, Row&& row) {
    for (const auto& t : mesh.triangles)
        if (t.x >= mesh.positions.size() || t.y >= mesh.positions.size() || t.z >= mesh.positions.size())
            throw std::invalid_argument("umbrage::rasterize: a triangle's index is out of range");
    const projection project(world_to_clip, clip, size);
    if (size.x == 0 || size.y == 0 || mesh.triangles.empty() || !is_finite(world_to_clip)) return;

    constexpr unsigned nowhere = 1u << projection::planes;
    struct vertex {
        snapped_vertex snapped;
        unsigned outside;
    };
    std::vector<vertex> vertices;
    vertices.reserve(mesh.positions.size());
    for (const auto& p : mesh.positions) {
        const auto h = is_finite(p) ? project.homogeneous(p) : glm::dvec4(0.0);
        const unsigned outside = is_finite(p) ? project.outside(h) : nowhere;
        vertices.push_back({outside ? snapped_vertex{0, 0, 0.0} : project.snap(h), outside});
    }

    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& t = mesh.triangles[i];
        const vertex &a = vertices[t.x], &b = vertices[t.y], &c = vertices[t.z];
        const unsigned crossed = a.outside | b.outside | c.outside;
        if ((a.outside & b.outside & c.outside) || (crossed & nowhere)) continue;
        const auto emit = [&](const snapped_vertex& p, const snapped_vertex& q, const snapped_vertex& r) {
            rasterize_snapped({p, q, r}, size, cull, [&](int y, int x_first, int x_last, const depth_plane& plane) {
                row(y, x_first, x_last, plane, static_cast<unsigned>(i));
            });
        };
        if (crossed) {
            const auto at = [&](unsigned index) { return project.homogeneous(mesh.positions[index]); };
            const auto polygon = clip_triangle(project, at(t.x), at(t.y), at(t.z), crossed);
            for (std::size_t k = 1; int(k) + 1 < polygon.count; ++k)
                emit(polygon.vertices[0], polygon.vertices[k], polygon.vertices[k + 1]);
        } else if (a.snapped < b.snapped && a.snapped < c.snapped) {
            emit(a.snapped, b.snapped, c.snapped);
        } else if (b.snapped < c.snapped) {
            emit(b.snapped, c.snapped, a.snapped);
        } else {
            emit(c.snapped, a.snapped, b.snapped);
        }
    }
}

/// Renders triangles into a depth image that holds the cleared depth or an earlier pass.
///
/// @param depth          greatest side 16384; row 0 is where clip.origin says; empty: nothing happens
/// @param mesh           triangles with a NaN or infinite position are left out, as all are if the matrix has one;
///                       those of no area on the 1/256 texel grid cover nothing
/// @param world_to_clip  projection * view
/// @param clip           reversed: greater depths win
/// @param cull           which faces to leave out
/// @throws std::invalid_argument  an index is out of range; a side of the image is above 16384
/// @formula     the nearer of what is there and the plane's depth, ties to the newcomer (the same bits); nothing beyond
///              the far plane; never -0
/// @exactness   coverage A from the snapped vertices on; depth B, see depth_plane
inline void rasterize_depth(image_view<float> depth, const mesh_view& mesh, const glm::mat4& world_to_clip, clip_space clip,
                            cull_mode cull = cull_mode::none) {
    const bool flipped = clip.origin == texture_origin::top, forward = clip.direction == depth_direction::forward;
    rasterize_rows(depth.size, mesh, world_to_clip, clip, cull,
                   [&](int y, int x_first, int x_last, const depth_plane& plane, unsigned) {
        float* texels = depth.row(flipped ? depth.size.y - 1 - y : y);
        for (int x = x_first; x < x_last; ++x) {
            const double z = plane(x, y);
            if (!(z >= 0.0 && z <= 1.0)) continue;
            const float stored = z > 0.0 ? static_cast<float>(z) : 0.0f;
            if (forward ? stored <= texels[x] : stored >= texels[x]) texels[x] = stored;
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
    rasterize_rows(size, mesh, world_to_clip, clip, cull,
                   [&](int y, int x_first, int x_last, const depth_plane& plane, unsigned triangle) {
        for (int x = x_first; x < x_last; ++x)
            if (const double z = plane(x, y); z >= 0.0 && z <= 1.0)
                sample(glm::ivec2(x, flipped ? size.y - 1 - y : y), z > 0.0 ? static_cast<float>(z) : 0.0f, triangle);
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
    const double sign = weights[0] + weights[1] + weights[2] < 0.0 ? -1.0 : 1.0;
    double sum = 0.0;
    for (auto& w : weights) sum += w = w * sign > 0.0 ? w * sign : 0.0;
    if (!is_finite(sum) || sum == 0.0) return {1.0f, 0.0f, 0.0f};
    return {weights[0] / sum, weights[1] / sum, weights[2] / sum};
}

}  // namespace umbrage

// ---- umbrage/umbrage.hpp
// All of umbrage. Includes only; each header also stands alone.

