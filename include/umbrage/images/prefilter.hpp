// SPDX-License-Identifier: MIT
//
// Prefiltered shadow maps (VSM, ESM, EVSM, MSM) over images: depth to moments, mip chain, and visibility of receivers.
//
//     const umbrage::prefilters::vsm filter{.min_variance = 1e-5f};
//     umbrage::image<glm::vec2> moments(depth.size()), blurred(depth.size());
//     umbrage::encode_moments(depth, moments, filter);
//     umbrage::blur(moments, blurred, umbrage::make_gaussian_kernel(7, 1.5f));
//     umbrage::visibility(blurred, filter, receivers, out);
//
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/core/parallel.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/filter/prefiltered/prefilters.hpp>
#include <umbrage/filter/prefiltered/reduce.hpp>
#include <umbrage/images/blocks/receivers.hpp>
#include <umbrage/images/encode.hpp>
#include <umbrage/images/receivers.hpp>
#include <umbrage/simd/bits.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/memory.hpp>

namespace umbrage {
namespace detail {

/// Block of texels, channel after channel. Only in this layout do loops over them vectorize.
template <class Texel>
struct texel_planes {
    static constexpr int channels = static_cast<int>(sizeof(Texel) / sizeof(float));

    alignas(64) float values[std::size_t(channels) * block];

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

/// fetch_bilinear for a block of receivers, channel after channel. Receivers outside the filter domain get any texel.
template <class Texel>
struct bilinear_block {
    static constexpr int channels = texel_planes<Texel>::channels;

    texel_planes<Texel> means;
    alignas(64) std::int32_t compared[block], left[block], right[block], low[block], high[block];
    alignas(64) float hi_x[block], hi_y[block];

    template <class Receivers>
    UMBRAGE_INLINE void place(const Receivers& r, glm::ivec2 size, bool forward, outside_map outside) {
        const auto axis = [](float coord, int highest, float& hi, std::int32_t& here, std::int32_t& next)
                              UMBRAGE_INLINE {
                                  const std::int32_t x = floor_int(coord * 256.0f) - 128;
                                  here = clamp_int(x >> 8, highest);
                                  next = clamp_int((x >> 8) + 1, highest);
                                  hi = static_cast<float>(x & 255);
                              };
        const std::int32_t towards_far = forward ? -1 : 0, anywhere = outside == outside_map::clamped ? -1 : 0;
        const auto width = static_cast<float>(size.x), height = static_cast<float>(size.y);
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) {
            const float x = r.x(i), y = r.y(i);
            const std::int32_t beyond = (beyond_far_plane_mask<true>(r.z(i)) & towards_far) |
                                        (beyond_far_plane_mask<false>(r.z(i)) & ~towards_far);
            const std::int32_t inside = texel_space_mask(x, y);
            const std::int32_t covered = -(std::int32_t(x >= 0.0f) & std::int32_t(y >= 0.0f) & std::int32_t(x < width) &
                                           std::int32_t(y < height));
            compared[i] = inside & ~beyond & (covered | anywhere);
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
            float mean[std::size_t(channels)];
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

/// decode_msm in three loops. Compilers do not vectorize a loop with a root, which may set errno. Filters that know
/// more of the depths continue in a loop of their own.
template <class Prefilter>
requires requires(const Prefilter& f, typename Prefilter::texel t) { f.moments(t); }
UMBRAGE_INLINE inline void decode_block(const Prefilter& filter, const texel_planes<typename Prefilter::texel>& means,
                                        const float* depths, float* visibility) {
    alignas(64) float x[block], d[block], D[block], E[block], h[block], a[block], B[block], c[block], roots[block];
    const float cleared = cleared_depth(filter.direction);
    for (int i = 0; i < block; ++i) {
        const glm::vec4 m = filter.moments(means[i]);
        d[i] = to_forward_depth(depths[i], cleared);
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

template <class Prefilter, class Receivers, class ParallelFor>
void decode_image(image_view<const typename Prefilter::texel> map, const Prefilter& filter, const Receivers& receivers,
                  image_view<float> out, ParallelFor&& parallel, outside_map outside) {
    static_assert(is_prefilter<Prefilter>());
    require_size(out.size, size_of(receivers, "visibility"), "visibility", "out.size", "the receivers' size");
    require(!map.empty(), "visibility", "map.size", "above 0", map.size);
    require_filter("visibility", filter);
    if (out.empty()) return;
    const bool forward = filter.direction == depth_direction::forward;
    parallel(out.size.y, [&](int first, int last) {
        on_best_isa_without_fma([&](auto set) UMBRAGE_INLINE {
            bilinear_block<typename Prefilter::texel> of_block;
            alignas(64) float depths[block], visibility[block];
            receiver_room room;
            const Prefilter own = filter;  // in registers
            for (block_walk at{0, first, out.size.x}; at.y < last; at.step()) {
                const auto r = block_at(receivers, at, room, set);
                of_block.place(r, map.size, forward, outside);
                for (int i = 0; i < block; ++i) depths[i] = r.z(i);
                of_block.fetch(map);
                decode_block(own, of_block.means, depths, visibility);
                for (int i = 0; i < block; ++i) visibility[i] = select(of_block.compared[i], visibility[i], 1.0f);
                copy_floats(out.row(at.y) + at.x, visibility, at.count());
            }
        });
    });
}

}  // namespace detail

/// Moments of an image of depths.
/// @param depth      in [0, 1]; clamped, NaN counts as far
/// @param texels     receives the moments; same size, other memory
/// @param filter     one of prefilters::, or any type with texel and encode
/// @param parallel   cuts the rows into pieces, see parallel.hpp
/// @throws std::invalid_argument  sizes differ; a filter's number out of range
/// @exactness        the bits of the filter's encode
template <class Prefilter, class ParallelFor = serial>
void encode_moments(image_view<const float> depth, image_view<typename Prefilter::texel> texels,
                    const Prefilter& filter, ParallelFor&& parallel = {}) {
    using texel = typename Prefilter::texel;
    detail::require_size(texels.size, depth.size, "encode_moments", "texels.size", "depth's size");
    detail::require_filter("encode_moments", filter);
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

/// Mip chain of a prefiltered map.
/// @param texels     texels of the map: float, vec2, vec4
/// @param levels     number of levels: the first has half the size, rounded up, each next one half of that
/// @param parallel   cuts the rows into pieces, see parallel.hpp
/// @return           the levels; a level of a single texel is followed by others of a single texel
/// @throws std::invalid_argument  empty map; negative levels
/// @exactness        the bits of halve_texels
template <class Texel, class ParallelFor = serial>
[[nodiscard]] std::vector<image<std::remove_const_t<Texel>>> make_mip_chain(image_view<Texel> texels, int levels,
                                                                            ParallelFor&& parallel = {}) {
    using texel = std::remove_const_t<Texel>;
    detail::require(!texels.empty(), "make_mip_chain", "texels.size", "above 0", texels.size);
    detail::require(levels >= 0, "make_mip_chain", "levels", "0 or more", levels);
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

/// Visibility from a prefiltered map.
///
/// @param map        the filter's texels, blurred
/// @param filter     same as for encode_moments
/// @param receivers  as for visibility of a map of depths
/// @param out        receives visibility, 1 lit; same size as receivers, other memory than these and the map
/// @param parallel   cuts the rows into pieces, see parallel.hpp
/// @param outside    bordered: everything outside the map is lit. clamped: the map's edge continues
/// @throws std::invalid_argument  sizes differ; an empty map; a filter's number out of range
/// @exactness        the bits of the filter's decode of fetch_bilinear; receivers outside the filter domain are lit
template <class Prefilter, receiver_image Receivers = receiver_planes, class ParallelFor = serial>
void visibility(image_view<const typename Prefilter::texel> map, const Prefilter& filter, const Receivers& receivers,
                image_view<float> out, ParallelFor&& parallel = {}, outside_map outside = outside_map::bordered) {
    detail::decode_image(map, filter, detail::viewed(receivers), out, parallel, outside);
}

}  // namespace umbrage
