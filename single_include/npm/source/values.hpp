// SPDX-License-Identifier: MIT
//
// Values of a shadow's block and its maps' matrices, from numbers alone: what WebAssembly gives the npm package.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include <umbrage/depth/encodings.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/filter/prefiltered/prefilters.hpp>
#include <umbrage/light/adaptive/pages.hpp>
#include <umbrage/light/adaptive/root.hpp>
#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/splits.hpp>
#include <umbrage/light/cascades/warped.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/pixels_per_texel.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/shadow/adaptive_maps.hpp>
#include <umbrage/shadow/cascaded_maps.hpp>
#include <umbrage/shadow/cube_maps.hpp>
#include <umbrage/shadow/paraboloid_maps.hpp>
#include <umbrage/shadow/shadow.hpp>
#include <umbrage/shadow/tetrahedron_map.hpp>
#include <umbrage/shadow/warped_maps.hpp>

namespace package {

/// Input, in the order in which values.mjs writes it. All are doubles.
struct asked {
    double hand, range, direction, origin_row,
        subpixel_bits;  ///< clip space: 1 is left, minus_one_to_one, reversed, top
    glm::dvec2 map_size;
    glm::dvec3 origin;               ///< where the frame's world begins
    glm::dvec3 position, ahead, up;  ///< position and axes of the light
    double outer_angle, aspect, z_near,
        z_far;             ///< of a spot; its planes, and those of point lights, whose range is z_far
    double border;         ///< border of point lights, gutter of pages
    glm::dvec3 low, high;  ///< the scene's box, or the receivers'
    double has_casters;
    glm::dvec3 caster_low, caster_high;
    double margin;                   ///< margin of a directional light
    double stable;                   ///< 1: its texels stay where they are
    glm::dmat4 view, projection;     ///< matrices of the camera
    double camera_near, camera_far;  ///< splits between them: as many as cascades
    double cascades, lambda, overlap, blend_texels;
    glm::dvec2 picture;  ///< size of the camera's picture, pixels
    double target;       ///< pixels that a texel of a page may cover
    double has_splits;
    std::array<double, 9> splits;     ///< in place of practical ones: one more than cascades
    std::array<double, 4> arguments;  ///< arguments of the filter, without a rotation
};
static_assert(sizeof(asked) % sizeof(double) == 0);

/// A point that the camera sees, for pages.
struct seen_point {
    glm::vec4 position;  ///< fourth number: 0 for no point
    glm::vec4 normal;    ///< on the camera's side, of length one
};

/// Output: floats of the block, then a matrix for each map's depth pass, from the world to clip coordinates, and what
/// vertex passes take. Last the empty texel of a map of moments; none of depths.
struct answered {
    std::vector<float> block, matrices, views, cleared;
};

namespace detail {

using namespace umbrage;

inline clip_space clip_of(const asked& a) {
    clip_space clip;
    clip.hand = a.hand > 0.5 ? handedness::left : handedness::right;
    clip.range = a.range > 0.5 ? depth_range::minus_one_to_one : depth_range::zero_to_one;
    clip.direction = a.direction > 0.5 ? depth_direction::reversed : depth_direction::forward;
    clip.origin = a.origin_row > 0.5 ? texture_origin::top : texture_origin::bottom;
    clip.subpixel_bits = static_cast<int>(a.subpixel_bits);
    return clip;
}

inline cascade_fit<double> fit_of(const asked& a, const clip_space& clip, glm::ivec2 map_size, double reach) {
    return {
        .camera = make_frustum<double>(
            {.view = a.view, .projection = a.projection, .z_near = a.camera_near, .z_far = a.camera_far, .clip = clip}),
        .direction = a.ahead,
        .up = a.up,
        .scene = {a.low, a.high},
        .map_size = map_size,
        .margin = reach,
        .overlap = a.overlap,
        .clip = clip};
}
template <std::size_t Count>
std::array<double, Count + 1> splits_of(const asked& a) {
    if (!(a.has_splits > 0.5)) return practical_splits<Count>(a.camera_near, a.camera_far, a.lambda);
    std::array<double, Count + 1> splits;
    std::copy_n(a.splits.begin(), Count + 1, splits.begin());
    return splits;
}
template <std::size_t Count>
auto cascades_of(const asked& a, const cascade_fit<double>& fit) {
    return cascaded_maps(make_stable_cascades<Count>(fit, splits_of<Count>(a)), static_cast<float>(a.blend_texels));
}
template <std::size_t Count>
auto warped_of(const asked& a, const cascade_fit<double>& fit) {
    const auto warp = [](const warp_fit<double>& part) { return fit_light_space_perspective(part); };
    return warped_maps(make_warped_cascades<Count>(fit, splits_of<Count>(a), warp), fit.camera, fit.overlap);
}

/// Pages that the camera needs to see the points, finer where their texels cover more pixels.
[[nodiscard]] inline adaptive_maps pages_of(const asked& a, std::span<const seen_point> seen, const clip_space& clip,
                                            const page_size& size) {
    const auto root = make_page_root<double>({.direction = a.ahead,
                                              .up = a.up,
                                              .center = (a.low + a.high) / 2.0,
                                              .side = 1.01 * glm::distance(a.low, a.high),
                                              .scene = {a.low, a.high},
                                              .clip = clip});
    const light_space<double> camera{a.view, a.projection, clip};
    const auto to_root = page_matrix(root), coarsest = texture_matrix(root, glm::ivec2(size.texels)),
               to_pixels = texture_matrix(camera, glm::ivec2(a.picture));
    std::vector<page_receiver> receivers;
    for (const auto& [at, towards_camera] : seen) {
        // Surfaces that the light grazes are hardly lit, and would take all pages: below a quarter of its strength they
        // need fewer.
        const glm::dvec3 position(at), normal(towards_camera);
        const double facing = glm::dot(normal, -glm::normalize(a.ahead));
        if (at.w == 0 || !(facing > 0)) continue;
        const double extent = longest_extent(pixels_per_texel(coarsest, to_pixels, position, normal));
        receivers.push_back(
            {glm::vec2(shadow_coordinate(to_root, position)), static_cast<float>(std::min(1.0, 4 * facing) * extent)});
    }
    page_cache cache({.slots = {8, 8}, .deepest_level = adaptive_maps::deepest_level, .target = a.target});
    cache.update(receivers);
    return {root, cache, size};
}

/// Calls use(setup) with the one of a kind's number, as `kinds` counts them.
template <class Use>
void with_setup(int kind, const asked& a, std::span<const seen_point> seen, glm::ivec2 map_size, double reach,
                const Use& use) {
    const clip_space clip = clip_of(a);
    const int size = map_size.x, border = static_cast<int>(a.border);
    const auto count = static_cast<int>(a.cascades);
    const int fewest = kind == 3 ? 5 : 1;
    if (kind == 2 || kind == 3 || kind == 7)
        umbrage::detail::require(count >= fewest && count <= fewest + 3, "values", "cascades",
                                 kind == 3 ? "5 to 8" : "1 to 4", count);
    const auto fit = [&] { return fit_of(a, clip, map_size, reach); };
    if (kind == 0)
        use(single_map(make_spot_light<double>({.position = a.position,
                                                .direction = a.ahead,
                                                .up = a.up,
                                                .outer_angle_radians = a.outer_angle,
                                                .aspect = a.aspect,
                                                .z_near = a.z_near,
                                                .z_far = a.z_far,
                                                .clip = clip})));
    if (kind == 1) {
        directional_fit<double> box{.direction = a.ahead,
                                    .up = a.up,
                                    .receivers = bounding_box<double>{a.low, a.high},
                                    .margin = a.margin,
                                    .snap_texels = a.stable > 0.5 ? map_size : glm::ivec2(0),
                                    .clip = clip};
        if (a.has_casters > 0.5) box.casters = bounding_box<double>{a.caster_low, a.caster_high};
        use(single_map(fit_directional_light<double>(box)));
    }
    if (kind == 2 && count == 1) use(cascades_of<1>(a, fit()));
    if (kind == 2 && count == 2) use(cascades_of<2>(a, fit()));
    if (kind == 2 && count == 3) use(cascades_of<3>(a, fit()));
    if (kind == 2 && count == 4) use(cascades_of<4>(a, fit()));
    if (kind == 3 && count == 5) use(cascades_of<5>(a, fit()));
    if (kind == 3 && count == 6) use(cascades_of<6>(a, fit()));
    if (kind == 3 && count == 7) use(cascades_of<7>(a, fit()));
    if (kind == 3 && count == 8) use(cascades_of<8>(a, fit()));
    if (kind == 4) use(cube_maps(point_light<double>{a.position, a.z_near, a.z_far, size, border, clip}));
    if (kind == 5) use(tetrahedron_map(tetrahedron_light<double>{a.position, a.z_near, a.z_far, size, border, clip}));
    if (kind == 7 && count == 1) use(warped_of<1>(a, fit()));
    if (kind == 7 && count == 2) use(warped_of<2>(a, fit()));
    if (kind == 7 && count == 3) use(warped_of<3>(a, fit()));
    if (kind == 7 && count == 4) use(warped_of<4>(a, fit()));
    if (kind == 6) use(paraboloid_maps(dual_paraboloid_light<double>{a.position, a.z_far, size, border, clip}));
    if (kind == 8) use(pages_of(a, seen, clip, {size - 2 * border, border}));
}

/// A filter of these arguments.
template <class Filter>
[[nodiscard]] Filter with_arguments(Filter f, const std::array<double, 4>& a) {
    auto next = a.begin();
    const auto number = [&] { return static_cast<float>(*next++); };
    umbrage::detail::for_each_number(f, [&]<class Number>(Number& n) {
        if constexpr (std::is_same_v<Number, int>) n = static_cast<int>(number());
        else if constexpr (std::is_same_v<Number, penumbra_params>) {
            const float size = number(), low = number();
            n = make_penumbra_params(size, low, number());
        } else if constexpr (std::is_same_v<Number, float>) n = number();
        else
            for (glm::length_t i = 0; i < Number::length(); ++i) n[i] = number();
    });
    return f;
}

/// Calls use(filter) with the one of a number, in the order of the lists.
template <class Use>
void with_filter_of(int number, const std::array<double, 4>& arguments, const Use& use) {
    int n = 0;
    const auto one = [&](const auto& f) {
        using type = std::decay_t<decltype(f)>;
        if constexpr (shadow_filter<type>)
            if (n++ == number) use(with_arguments(f, arguments));
    };
    filters::all::for_each(one);
    filters::soft::for_each(one);
    prefilters::all::for_each(one);
}

/// By how much an encoding's depths may be off; those of moments are not.
[[nodiscard]] inline decoding_error error_of(int number, depth_direction direction) {
    decoding_error off;
    int n = 0;
    for_each_encoding([&](auto encoding) {
        encoding = {.direction = direction};
        if (n++ == number) off = encoding.error();
    });
    return off;
}

}  // namespace detail

/// The block of a shadow, as umbrage::shadow::uniforms gives it, its maps' matrices and depth_views.
/// @param kind, filter, encoding   numbers in the order of their lists; -1: no encoding, as of moments
/// @param seen                     points that the camera sees, for pages
/// @throws std::invalid_argument   as the setups and umbrage::shadow
inline answered values(int kind, int filter, int encoding, const asked& a, std::span<const seen_point> seen) {
    using namespace umbrage;
    const glm::ivec2 map_size(a.map_size);
    const clip_space clip = detail::clip_of(a);
    answered out;
    float reach = 0, light_size = 0;
    glm::vec2 per_code(0);
    bent_lines bends;
    detail::with_filter_of(filter, a.arguments, [&]<class Filter>(const Filter& f) {
        if constexpr (umbrage::detail::contact_hardening<Filter>) {
            light_size = umbrage::detail::softness_of(f).light_size;
            umbrage::detail::require_shadow(clip, map_size, umbrage::detail::with_per_code(f, per_code));
        } else umbrage::detail::require_shadow(clip, map_size, f);
        reach = umbrage::detail::reach_of(f);
    });
    const auto append = [](std::vector<float>& all, const auto& values) {
        const std::size_t begin = all.size();
        all.resize(begin + sizeof values / sizeof(float));
        std::memcpy(all.data() + begin, &values, sizeof values);
    };
    detail::with_setup(kind, a, seen, map_size, reach, [&](const auto& setup) {
        umbrage::detail::require_maps(setup, reach);
        using setup_type = std::decay_t<decltype(setup)>;
        append(out.block, setup.make_uniforms(map_size, a.origin));
        bends = umbrage::bends_of<setup_type>;
        if (light_size > 0) {
            const auto softness = umbrage::detail::softness_of_maps(setup, map_size, light_size);
            per_code = softness.front();
            constexpr int matrices = umbrage::detail::matrices_of_maps<setup_type>;
            const std::size_t begin = out.block.size();
            out.block.resize(begin + 16 * std::size_t(matrices));
            if (matrices > 0) std::memcpy(&out.block[begin], softness.data(), softness.size() * sizeof(glm::vec2));
            if (has_warps<setup_type>) append(out.block, umbrage::detail::warps_of(setup, map_size));
        }
        for (const light_space<double>& light : setup.lights()) {
            const auto placed = umbrage::detail::relative_to(a.origin, light);
            append(out.matrices, glm::mat4(placed.projection * placed.view));
        }
        for (const depth_view& view : umbrage::detail::depth_views_of(setup, a.origin)) append(out.views, view);
    });
    const decoding_error off = detail::error_of(encoding, clip.direction);
    detail::with_filter_of(filter, a.arguments, [&]<class Filter>(const Filter& f) {
        shadow_terms terms = umbrage::detail::make_shadow_terms(map_size, f, off, clip, bends);
        if (light_size > 0) terms.filter_terms.x = per_code.x, terms.filter_terms.y = per_code.y;
        append(out.block, terms);
        if constexpr (prefilter<Filter>) {
            Filter of_map = f;
            of_map.direction = clip.direction;
            append(out.cleared, of_map.encode(cleared_depth(clip.direction)));
        }
    });
    umbrage::detail::require_finite_uniforms(out.block);
    return out;
}

}  // namespace package
