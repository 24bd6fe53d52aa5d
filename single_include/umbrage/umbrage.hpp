// SPDX-License-Identifier: MIT
//
// All primitives of umbrage in one file, made by single_include/amalgamate.cmake: do not edit.
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
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_precision.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>
#include <initializer_list>
#include <limits>
#include <new>
#include <numbers>
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

namespace detail {

/// Starts memory where a line of the cache starts, so that no block of pixels straddles two without need.
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
    std::vector<T, detail::line_allocator<T>> texels_;
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
    .exactness = tier::a, .lowest = version::v300_es, .needs = {&saturate}, .source = R"GLSL(
// umbrage_decode_float_bits: four channels of a bit pattern, as sampled, R least significant, to the float
UMBRAGE_HIGHP float umbrage_decode_float_bits(UMBRAGE_HIGHP vec4 c) {
    UMBRAGE_HIGHP uint r = uint(umbrage_saturate(c.x) * 255.0 + 0.5);
    UMBRAGE_HIGHP uint g = uint(umbrage_saturate(c.y) * 255.0 + 0.5);
    UMBRAGE_HIGHP uint b = uint(umbrage_saturate(c.z) * 255.0 + 0.5);
    UMBRAGE_HIGHP uint a = uint(umbrage_saturate(c.w) * 255.0 + 0.5);
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

/// @param depth   of the receiver, biased; not clamped; NaN is in shadow, for no comparison with it holds
/// @param edge    the one decode_rg would be given
/// @return        receiver_rg(depth, edge) <= level_rg(c) exactly when depth <= decode_rg(c, edge), for texels c within
///                2^-18 of k / 255. For this comparison only, not for reversed Z.
/// @formula       (ceil(depth 2^Bits - edge) - 1/2) / 255
/// @exactness     B: products and sums round once each; the test that it is made for is exact
template <int Bits, real T>
[[nodiscard]] T receiver_rg(T depth, T edge) {
    static_assert(Bits >= 9 && Bits <= 16);
    return (std::ceil(depth * T(1 << Bits) - edge) - T(0.5)) * T(1.0 / 255.0);
}

namespace glsl {

template <int Bits>
inline constexpr auto level_rg_name = detail::fill<16>("level_rg$b", {{'b', Bits}});
template <int Bits>
inline constexpr auto level_rg_text = detail::fill<512>(R"GLSL(
// umbrage_level_rg$b: two channels of a $b-bit code, as sampled, to the scale of umbrage_receiver_rg$b
UMBRAGE_HIGHP float umbrage_level_rg$b(UMBRAGE_HIGHP vec2 c) {
    return c.x + c.y * $g.0;  // an exact product: fused or not, it rounds once
}
)GLSL",
                                                        {{'b', Bits}, {'g', 1 << (Bits - 8)}});
template <int Bits>
inline constexpr snippet level_rg{.name = level_rg_name<Bits>.view(),
                                  .summary = "two channels to a level to compare with",
                                  .exactness = tier::b,
                                  .source = level_rg_text<Bits>.view()};

template <int Bits>
inline constexpr auto receiver_rg_name = detail::fill<16>("receiver_rg$b", {{'b', Bits}});
template <int Bits>
inline constexpr auto receiver_rg_text = detail::fill<768>(R"GLSL(
// umbrage_receiver_rg$b: receiver on the scale of umbrage_level_rg$b: it is <= a texel's level exactly when
//   depth <= umbrage_decode_rg$b(texel, edge)
UMBRAGE_HIGHP float umbrage_receiver_rg$b(UMBRAGE_HIGHP float depth, UMBRAGE_HIGHP float edge) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float level = (ceil(depth * $n.0 - edge) - 0.5) * 0.00392156886;
    return level;
}
)GLSL",
                                                           {{'b', Bits}, {'n', 1 << Bits}});
template <int Bits>
inline constexpr snippet receiver_rg{.name = receiver_rg_name<Bits>.view(),
                                     .summary = "receiver to a level, for maps that are not decoded",
                                     .exactness = tier::b,
                                     .source = receiver_rg_text<Bits>.view()};

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

// ---- umbrage/umbrage.hpp
// All primitives of umbrage. Includes only; each header also stands alone. Functions over whole images, the depth pass
// among them, and the registry of snippets are in <umbrage/images.hpp>: who needs none of them does not compile them.

