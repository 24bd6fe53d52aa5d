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

#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
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

// ---- umbrage/umbrage.hpp
// All of umbrage. Includes only; each header also stands alone.

