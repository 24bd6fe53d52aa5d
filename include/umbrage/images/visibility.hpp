// SPDX-License-Identifier: MIT
//
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
#pragma once

#include <cstring>
#include <type_traits>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/clip_space.hpp>
#include <umbrage/image.hpp>
#include <umbrage/simd/blocks/box.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/simd/blocks/hierarchical_box.hpp>
#include <umbrage/images/parallel.hpp>
#include <umbrage/simd/blocks/texels.hpp>
#include <umbrage/light/texture_matrix.hpp>

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
UMBRAGE_INLINE inline void use_receivers(const image_view<const glm::vec3>& from, const block_walk& at, Isa, const Use& use) {
    const receiver_texels receivers{from.row(at.y) + at.x};
    if (Isa::value != isa::base || at.count() != block) return use_block(receivers, at.count(), use);
    receiver_block copy;  // GCC takes vec3s apart for SSE only in a loop that does nothing else
    copy.copy(receivers);
    use(copy);
}
template <class Isa, class Use>
UMBRAGE_INLINE inline void use_receivers(const receiver_planes& from, const block_walk& at, Isa, const Use& use) {
    use_block(receiver_rows{from.x.row(at.y) + at.x, from.y.row(at.y) + at.x, from.depth.row(at.y) + at.x}, at.count(), use);
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
            const auto sum = [&](int k) UMBRAGE_INLINE { return m[3][k] + m[0][k] * x + m[1][k] * y + m[2][k] * depth; };
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

/// Starts to fetch the receivers some blocks ahead. A machine that guesses them stops at the end of a page, which is soon.
template <class T>
UMBRAGE_INLINE inline void prefetch(const image_view<const T>& from, const block_walk& at) {
    constexpr int bytes = block * static_cast<int>(sizeof(T)), blocks = 4;
    prefetch_bytes(from.row(at.y) + at.x, blocks * bytes, bytes);
}
UMBRAGE_INLINE inline void prefetch(const receiver_planes& from, const block_walk& at) {
    for (const auto* plane : {&from.x, &from.y, &from.depth}) prefetch(*plane, at);
}
UMBRAGE_INLINE inline void prefetch(const depth_receivers& from, const block_walk& at) { prefetch(from.depth, at); }

[[nodiscard]] inline glm::ivec2 size_of(const image_view<const glm::vec3>& receivers) { return receivers.size; }
[[nodiscard]] inline glm::ivec2 size_of(const depth_receivers& receivers) { return receivers.depth.size; }
[[nodiscard]] inline glm::ivec2 size_of(const receiver_planes& receivers) {
    if (receivers.x.size != receivers.depth.size || receivers.y.size != receivers.depth.size)
        detail::fail("umbrage::visibility: sizes differ");
    return receivers.depth.size;
}

/// Every receiver through a filter in either form.
template <class Receivers, class Filter, class ParallelFor>
void filter_rows(const Receivers& receivers, const Filter& filter, image_view<float> out, ParallelFor&& parallel) {
    parallel(out.size.y, [&](int first, int last) {
        const bool large = past_cache(out);
        on_best_isa([&](auto set) UMBRAGE_INLINE {
            constexpr unsigned ring = 4;  // blocks on their way
            typename Filter::placed placed[ring];
            alignas(64) float visibility[block];
            block_walk ahead{0, first, out.size.x}, at = ahead;
            for (unsigned n = 0; at.y < last; ++n) {
                if (ahead.y < last) {
                    prefetch(receivers, ahead);
                    use_receivers(receivers, ahead, set, [&](const auto& of_block) UMBRAGE_INLINE {
                        filter.place(of_block, placed[n % ring]);
                    });
                    ahead.step();
                }
                if (n + 1 < ring) continue;
                filter(placed[(n + 1) % ring], at.count(), visibility, set);
                float* const to = out.row(at.y) + at.x;
                if (large && at.count() == block) stream_block(to, visibility);
                else copy_floats(to, visibility, at.count());
                at.step();
            }
        });
        if (large) finish_streaming();
    });
}

template <class Encoding, class Receivers, class Filter, class ParallelFor>
void filter_image(image_view<const typename Encoding::texel> map, const Encoding& encoding, const Receivers& receivers,
                  const Filter& filter, image_view<float> out, ParallelFor&& parallel) {
    if (size_of(receivers) != out.size) detail::fail("umbrage::visibility: sizes differ");
    if (map.empty()) detail::fail("umbrage::visibility: empty map");
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
