// SPDX-License-Identifier: MIT
//
// Images: a view of any pixels, an owner of pixels, and two ways to fetch a texel, clamped and bordered.
//
//     umbrage::image<float> map({1024, 1024}, 1.0f);
//     umbrage::image_view<const float> view(pixels, {width, height}, bytes_per_row);
//     float depth = umbrage::bordered(view)(glm::ivec2(-1, 5));  // 1: the far plane
#pragma once

#include <cassert>
#include <cstddef>
#include <new>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/snippet.hpp>

namespace umbrage {

/// View of pixels that other code owns: rows of `size.x` elements, `stride` bytes from one row to the next.
/// Row 0 is at `data`. With a negative stride the other rows precede it, as in a bottom-up image.
/// An empty view has a zero in its size.
template <class T>
struct image_view {
    T* data = nullptr;
    glm::ivec2 size{0, 0};
    std::ptrdiff_t stride = 0;  ///< bytes from one row to the next

    constexpr image_view() = default;

    /// View of rows without gaps between them.
    constexpr image_view(T* pixels, glm::ivec2 extent)
        : image_view(pixels, extent, extent.x * static_cast<std::ptrdiff_t>(sizeof(T))) {}

    /// @throws std::invalid_argument  negative size; no pixels; stride shorter than a row, not a multiple of the
    ///                                alignment of T, or such that no memory holds the rows
    constexpr image_view(T* pixels, glm::ivec2 extent, std::ptrdiff_t stride_bytes)
        : data(pixels), size(extent), stride(stride_bytes) {
        detail::require(extent.x >= 0 && extent.y >= 0, "image_view", "extent", "0 or more", extent);
        if (empty()) return;
        const auto row_bytes = static_cast<std::size_t>(extent.x) * sizeof(T);
        auto distance = static_cast<std::size_t>(stride_bytes);
        if (stride_bytes < 0) distance = 0 - distance;
        detail::require(pixels != nullptr, "image_view", "pixels", "given", "nullptr");
        detail::require(extent.y <= 1 || distance >= row_bytes, "image_view", "stride_bytes", "a row's bytes or more",
                        stride_bytes);
        detail::require(distance % alignof(T) == 0, "image_view", "stride_bytes", "a multiple of a texel's alignment",
                        stride_bytes);
        detail::require(distance <= (static_cast<std::size_t>(-1) >> 1) / static_cast<std::size_t>(extent.y),
                        "image_view", "stride_bytes", "small enough for memory to hold the rows", stride_bytes);
    }

    struct known_to_fit {};  ///< tag: no checks, which in debug builds take longer than reading a texel
    constexpr image_view(known_to_fit, T* pixels, glm::ivec2 extent, std::ptrdiff_t stride_bytes)
        : data(pixels), size(extent), stride(stride_bytes) {}

    /// Conversion from a writable view to a read-only one.
    constexpr operator image_view<const T>() const requires(!std::is_const_v<T>) { return {{}, data, size, stride}; }

    [[nodiscard]] constexpr bool empty() const { return size.x == 0 || size.y == 0; }

    /// First texel of row y, 0 <= y < size.y.
    [[nodiscard]] T* row(int y) const {
        assert(y >= 0 && y < size.y);
        using byte = std::conditional_t<std::is_const_v<T>, const std::byte, std::byte>;
        return reinterpret_cast<T*>(reinterpret_cast<byte*>(data) + y * stride);
    }

    /// Texel at `texel`, which must lie inside the image.
    [[nodiscard]] T& operator[](glm::ivec2 texel) const {
        assert(texel.x >= 0 && texel.x < size.x);
        return row(texel.y)[texel.x];
    }

    /// Part of the image as a map of its own, such as a tile of an atlas: `extent` texels from `first` on.
    /// @throws std::invalid_argument  the region leaves the image
    [[nodiscard]] image_view region(glm::ivec2 first, glm::ivec2 extent) const {
        detail::require(first.x >= 0 && first.y >= 0, "image_view::region", "first", "0 or more", first);
        const glm::ivec2 rest = size - first;
        if (extent.x < 0 || extent.y < 0 || extent.x > rest.x || extent.y > rest.y)
            detail::refuse("image_view::region", "extent",
                           std::string("inside the image, at most ").append(detail::printed(rest)), extent);
        const bool none = extent.x == 0 || extent.y == 0;
        return {{}, none ? data : row(first.y) + first.x, extent, stride};
    }

    /// Rows first <= y < last as a view of their own: the work of one thread.
    [[nodiscard]] image_view rows(int first, int last) const {
        assert(0 <= first && first <= last && last <= size.y);
        return {{}, first < last ? row(first) : data, {size.x, last - first}, stride};
    }
};

namespace detail {

/// Allocator that aligns memory to cache lines, so that blocks of pixels do not straddle two lines needlessly.
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

/// Owner of pixels, without gaps between rows. Moved from, it is empty.
template <class T>
class image {
public:
    image() = default;
    image(const image&) = default;
    image& operator=(const image&) = default;
    image(image&& from) noexcept
        : size_(std::exchange(from.size_, glm::ivec2(0))), texels_(std::exchange(from.texels_, {})) {}
    image& operator=(image&& from) noexcept {
        texels_ = std::exchange(from.texels_, {});
        size_ = std::exchange(from.size_, glm::ivec2(0));
        return *this;
    }

    /// @throws std::invalid_argument  negative size
    /// @throws std::length_error      more texels than a std::vector holds; std::bad_alloc: more than memory has
    explicit image(glm::ivec2 size, const T& value = T{}) : size_(size) {
        detail::require(size.x >= 0 && size.y >= 0, "image", "size", "0 or more", size);
        texels_.assign(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y), value);
    }

    [[nodiscard]] glm::ivec2 size() const { return size_; }
    [[nodiscard]] bool empty() const { return texels_.empty(); }
    [[nodiscard]] std::span<T> texels() & { return texels_; }
    [[nodiscard]] std::span<const T> texels() const& { return texels_; }
    void texels() && = delete;  ///< deleted for temporaries: the span would dangle

    [[nodiscard]] T& operator[](glm::ivec2 texel) { return view()[texel]; }
    [[nodiscard]] const T& operator[](glm::ivec2 texel) const { return view()[texel]; }

    [[nodiscard]] image_view<T> view() { return {{}, texels_.data(), size_, stride()}; }
    [[nodiscard]] image_view<const T> view() const { return {{}, texels_.data(), size_, stride()}; }
    operator image_view<T>() { return view(); }
    operator image_view<const T>() const { return view(); }

private:
    [[nodiscard]] std::ptrdiff_t stride() const { return size_.x * static_cast<std::ptrdiff_t>(sizeof(T)); }
    static_assert(!std::is_same_v<T, bool>, "std::vector<bool> has no pixels to view: use std::uint8_t");
    glm::ivec2 size_{0, 0};
    std::vector<T, detail::line_allocator<T>> texels_;
};

namespace detail {

template <class T>
inline constexpr bool is_image = false;
template <class T>
inline constexpr bool is_image<image<T>> = true;

/// View of an image. Views pass unchanged, so that functions accept both.
template <class Map>
[[nodiscard]] auto view_of(Map& map) {
    if constexpr (is_image<std::remove_const_t<Map>>) return map.view();
    else return map;
}
template <class Map>
using texel_of = std::remove_const_t<std::remove_pointer_t<decltype(view_of(std::declval<const Map&>()).data)>>;
template <class... Any>
concept some_image = (is_image<std::remove_cvref_t<Any>> || ...);

}  // namespace detail

/// Texel at `at`, which must lie inside the map.
/// @exactness   A
template <class T>
[[nodiscard]] std::remove_const_t<T> texel(image_view<T> map, glm::ivec2 at) {
    return map[at];
}

/// True if a texel lies inside the map.
/// @param size    size of the map, in texels
/// @param at      texel index, integers
/// @exactness     A
[[nodiscard]] constexpr bool inside_map(glm::ivec2 size, glm::ivec2 at) {
    return at.x >= 0 && at.y >= 0 && at.x < size.x && at.y < size.y;
}

/// Texel at which shaders read a map with a border: the texel itself if the map has it. Outside it is any other one of
/// the map, whose value does not count. That takes one operation less an axis than the nearest.
/// @param size    size of the map, in texels
/// @param at      texel index, integers above -2^31
/// @formula       min(|at|, size - 1)
/// @exactness     A
[[nodiscard]] inline glm::ivec2 texel_inside(glm::ivec2 size, glm::ivec2 at) {
    const auto inside = [](int v, int length) { return (v < 0 ? -v : v) < length ? (v < 0 ? -v : v) : length - 1; };
    return {inside(at.x, size.x), inside(at.y, size.y)};
}

/// Texel of the map, or the nearest one inside for coordinates outside. The map must not be empty.
/// @exactness   A
template <class T>
[[nodiscard]] std::remove_const_t<T> fetch_clamped(image_view<T> map, glm::ivec2 texel) {
    assert(!map.empty());
    const int x = texel.x < 0 ? 0 : (texel.x < map.size.x ? texel.x : map.size.x - 1);
    const int y = texel.y < 0 ? 0 : (texel.y < map.size.y ? texel.y : map.size.y - 1);
    return map.row(y)[x];
}

/// Texel of the map, or `border` outside it. An empty map is all border.
/// @exactness   A
template <class T>
[[nodiscard]] std::remove_const_t<T> fetch_bordered(image_view<T> map, glm::ivec2 texel,
                                                    std::remove_const_t<T> border) {
    return inside_map(map.size, texel) ? map.row(texel.y)[texel.x] : border;
}

/// Fetch callable for filters. Clamps coordinates as fetch_clamped does.
/// @throws std::invalid_argument  empty map
template <class Map, class = detail::texel_of<Map>>
[[nodiscard]] auto clamped(const Map& map) {
    const auto view = detail::view_of(map);
    detail::require(!view.empty(), "clamped", "map.size", "above 0", view.size);
    return [view](glm::ivec2 texel) { return fetch_clamped(view, texel); };
}

/// Fetch callable for filters. Returns the border outside the map, as fetch_bordered does.
template <class T>
struct bordered_map {
    image_view<const T> map{};
    T border{};
    [[nodiscard]] T operator()(glm::ivec2 texel) const { return fetch_bordered(map, texel, border); }
};
/// Map without a border value: decoded() and lookups into prefiltered maps fill in the far plane's value.
template <class T>
struct bordered_texels {
    image_view<const T> map{};
};

/// Fetch of a map with a border value.
/// @param map      image or view
/// @param border   value of texels outside the map; the far plane's, cleared_depth(clip), lights the outside
template <class Map, class Texel = detail::texel_of<Map>>
[[nodiscard]] bordered_map<Texel> bordered(const Map& map, std::type_identity_t<Texel> border) {
    return {detail::view_of(map), border};
}
/// Fetch of a map of forward depth. Texels outside are 1, the far plane. Maps of other texels give bordered_texels.
template <class Map, class Texel = detail::texel_of<Map>>
[[nodiscard]] auto bordered(const Map& map) {
    if constexpr (std::is_floating_point_v<Texel>) return bordered(map, Texel(1));
    else return bordered_texels<Texel>{detail::view_of(map)};
}

namespace glsl {

inline constexpr snippet texel{
    .name = "texel",
    .summary = "texel inside a map",
    .exactness = tier::a,
    .role = hook::texel,
    .source = R"GLSL(
// umbrage_texel: value of a texel inside the map
//   map    texture with the texels; a sampler that reads them must filter by nearest
//   size   size of the map, in texels
//   texel  integers, (0, 0) is the first
UMBRAGE_HIGHP vec4 umbrage_texel(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    UMBRAGE_HIGHP vec2 at = texel + UMBRAGE_ORIGIN;
    return UMBRAGE_TEXEL;
}
)GLSL",
};

inline constexpr snippet inside_map{
    .name = "inside_map",
    .summary = "true if a texel lies inside the map",
    .exactness = tier::a,
    .source = R"GLSL(
// umbrage_inside_map: true if a texel lies inside a map of size texels
bool umbrage_inside_map(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    return texel.x >= 0.0 && texel.y >= 0.0 && texel.x < size.x && texel.y < size.y;
}
)GLSL",
};

/// Text for a bordered map. For other maps bind() replaces it.
inline constexpr snippet texel_inside{
    .name = "texel_inside",
    .summary = "texel of the map, itself if the map has it",
    .exactness = tier::a,
    .role = hook::texel_inside,
    .source = R"GLSL(
// umbrage_texel_inside: texel of the map, itself if the map has it; otherwise any, whose value does not count
UMBRAGE_HIGHP vec2 umbrage_texel_inside(UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    return min(abs(texel), size - 1.0);
}
)GLSL",
};

inline constexpr snippet fetch_clamped{
    .name = "fetch_clamped",
    .summary = "texel of a map, clamped to the nearest one inside",
    .exactness = tier::a,
    .needs = list<&texel>,
    .source = R"GLSL(
// umbrage_fetch_clamped: texel of a map, or the nearest one inside for coordinates outside
UMBRAGE_HIGHP vec4 umbrage_fetch_clamped(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel) {
    return umbrage_texel(map, size, clamp(texel, vec2(0.0, 0.0), size - 1.0));
}
)GLSL",
};

inline constexpr snippet fetch_bordered{
    .name = "fetch_bordered",
    .summary = "texel of a map, or a border value outside it",
    .exactness = tier::a,
    .needs = list<&texel, &texel_inside>,
    .source = R"GLSL(
// umbrage_fetch_bordered: texel of a map, or border outside it
UMBRAGE_HIGHP vec4 umbrage_fetch_bordered(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec2 texel,
                                          UMBRAGE_HIGHP vec4 border) {
    UMBRAGE_HIGHP vec2 at = umbrage_texel_inside(size, texel);
    UMBRAGE_HIGHP vec4 value = umbrage_texel(map, size, at);
    return at.x == texel.x && at.y == texel.y ? value : border;
}
)GLSL",
};

inline constexpr const snippet* image_snippets[]{&texel, &inside_map, &texel_inside, &fetch_clamped, &fetch_bordered};

}  // namespace glsl
}  // namespace umbrage
