// SPDX-License-Identifier: MIT
//
// Rows of the picture table: the default shadow, other filters, and other biases under the default's filter.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/constant.hpp>
#include <umbrage/bias/kernel.hpp>
#include <umbrage/bias/light_units.hpp>
#include <umbrage/bias/normal_offset.hpp>
#include <umbrage/bias/receiver_plane.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/filter/pcf/windows.hpp>
#include <umbrage/shadow/shadow.hpp>

#include "light_maps.hpp"
#include "receivers.hpp"

namespace proof::picture {

/// One way to look a receiver up.
struct row {
    std::string name;
    std::function<float(const receiver&)> visibility;
    bool smooth_alone = false;  ///< only on surfaces with interpolated normals
};

/// An image of all maps, which rows share.
using drawn_maps = std::shared_ptr<const umbrage::image<float>>;

/// Visibility by a filter in one map, of a receiver at a place in texels and depth.
template <class Filter>
[[nodiscard]] float look(const light_maps& maps, const drawn_maps& drawn, const Filter& filter, int map, glm::vec3 at) {
    return filter(umbrage::bordered(maps.map_of(*drawn, map)), glm::vec2(at), at.z);
}

/// The default's filter, under every bias of the table.
inline const auto default_filter = umbrage::filters::tent<3>;
inline const float snap = umbrage::rasterizer_snap<float>, default_reach = default_filter.reach() + snap;

/// Vector from a point light over w, or the direction of a directional light, as normal_offset and kernel_bias take it.
[[nodiscard]] inline glm::vec3 way_of(const light_maps& maps, const receiver& r) {
    if (!maps.rays.is_point) return glm::vec3(maps.axis(r.place.number));
    return glm::vec3(-maps.rays.way(r.exact) / maps.w(r.place.number, r.exact));
}

/// The default with another bias on the receiver's plane: texels of its slope, and texels' widths along the light.
[[nodiscard]] inline std::function<float(const receiver&, const umbrage::map_place&)> by_width(const light_maps& maps,
                                                                                               const drawn_maps& drawn,
                                                                                               float texels_of_slope,
                                                                                               double widths) {
    return [&maps, drawn, texels_of_slope, widths](const receiver& r, const umbrage::map_place& place) {
        using namespace umbrage;
        const auto width = float(widths * maps.width_in_depth(place.number, r.exact));
        const float bias = acne_free_bias(place.slope, texels_of_slope, maps.rounding(place, r.exact) + width);
        const glm::vec3 at = place.at - glm::vec3(0, 0, bias);
        const auto fetch = bordered(maps.map_of(*drawn, place.number));
        return default_filter(apply_receiver_plane(fetch, place.slope, at), glm::vec2(at), at.z);
    };
}

/// Biases that the default could have instead.
/// @param plain   the default shadow's lookup at a position without a slope
[[nodiscard]] inline std::vector<row> bias_rows(const light_maps& maps, const drawn_maps& drawn,
                                                const std::function<float(glm::vec3)>& plain) {
    using namespace umbrage;
    const auto biased_look = [&maps, drawn](const receiver& r, float bias) {
        return look(maps, drawn, default_filter, r.place.number, r.place.at - glm::vec3(0, 0, bias));
    };
    const auto width_of = [](const receiver& r) { return offset_width(default_reach, float(r.texel)); };
    const auto half = by_width(maps, drawn, 0.5f, 0.0);
    return {{"tried: half a texel of slope in place of a texel's width",
             [half](const receiver& r) { return half(r, r.place); }},
            {"one bias for the whole kernel",
             [&maps, biased_look](const receiver& r) {
                 const float rounding = maps.rounding(r.place, r.exact);
                 return biased_look(r, acne_free_bias(r.place.slope, default_reach, rounding));
             }},
            {"normal_offset",
             [&maps, plain, width_of](const receiver& r) {
                 const glm::vec3 axis(maps.axis(r.place.number));
                 return plain(r.position + normal_offset(r.normal, axis, way_of(maps, r), width_of(r), 0.0f));
             }},
            {"kernel_bias",
             [&maps, biased_look, width_of](const receiver& r) {
                 const glm::vec3 axis(maps.axis(r.place.number));
                 const float world = kernel_bias(r.normal, axis, way_of(maps, r), width_of(r), 20.0f);
                 const glm::vec2 units(maps.units(r.place.number));
                 const float w = float(maps.w(r.place.number, r.exact));
                 return biased_look(r, world_to_depth(world, units, w) + maps.rounding(r.place, r.exact) + 0x1p-23f);
             }},
            {"a constant of 0.0005", [=](const receiver& r) { return biased_look(r, 0.0005f); }}};
}

/// A shadow with its own maps.
template <class Shadow>
[[nodiscard]] row shadow_row(std::string name, const Shadow& s, const drawn_maps& drawn) {
    return {std::move(name), [s, drawn](const receiver& r) { return s(*drawn, r.position, r.normal, r.pixel); }, false};
}

/// A shadow whose normals are cross products of derivatives on the screen.
template <class Shadow>
[[nodiscard]] row screen_row(std::string name, const Shadow& s, const drawn_maps& drawn) {
    return {std::move(name), [s, drawn](const receiver& r) { return s(*drawn, r.position, r.screen_normal, r.pixel); },
            false};
}

/// Rows of smooth surfaces, by the triangles' normals and by interpolated ones.
template <class Shadow>
[[nodiscard]] std::vector<row> smooth_rows(const light_maps& maps, const Shadow& s, const drawn_maps& drawn) {
    const auto steep = by_width(maps, drawn, 1.5f, 0.0), widths = by_width(maps, drawn, 0.5f, 1.5);
    return {{"default, smooth surfaces alone",
             [s, drawn](const receiver& r) { return s(*drawn, r.position, r.normal, r.pixel); }, true},
            {"default, with interpolated normals",
             [s, drawn](const receiver& r) { return s(*drawn, r.position, r.smooth_normal, r.pixel); }, true},
            {"tried: 1.5 texels of slope, with interpolated normals",
             [steep](const receiver& r) { return steep(r, r.smooth_place); }, true},
            {"tried: half a texel of slope and 1.5 texels' width, with interpolated normals",
             [widths](const receiver& r) { return widths(r, r.smooth_place); }, true},
            {"one bias, with interpolated normals",
             [&maps, drawn](const receiver& r) {
                 const umbrage::map_place& p = r.smooth_place;
                 const float bias = umbrage::acne_free_bias(p.slope, default_reach, maps.rounding(p, r.exact));
                 return look(maps, drawn, default_filter, p.number, p.at - glm::vec3(0, 0, bias));
             },
             true}};
}

}  // namespace proof::picture
