// SPDX-License-Identifier: MIT
//
// Mistakes planted between a program and the library: a dropped argument, a wrong default, a border one texel off. The
// judge knows the program's own arguments, and so it must see each.
#pragma once

#include <array>
#include <string_view>

#include <umbrage/umbrage.hpp>

namespace turned {

enum class fault {
    none,
    position_dropped,
    direction_axis_dropped,
    cone_narrowed,
    far_plane_nearer,
    receivers_shrunk,
    border_dropped,
    bulb_far_plane_nearer,
    triangle_dropped,
    index_off_by_one,
    normal_dropped,
    map_one_texel_off,
    bias_of_wrong_sign,
    origin_dropped,
    brace_dropped
};
inline constexpr std::array<std::string_view, 15> fault_names{"none",
                                                              "a light's position: one axis is dropped",
                                                              "a light's direction: one axis is dropped",
                                                              "a spot's cone: a sixth of it",
                                                              "a spot's far plane: a third of it",
                                                              "a fit's receivers: the half of them",
                                                              "a point light's border is dropped",
                                                              "a point light's far plane: a tenth of it",
                                                              "a mesh: its last triangle is dropped",
                                                              "a mesh: each index is one more",
                                                              "a lookup: the normal is dropped",
                                                              "a drawn map: one texel off",
                                                              "a lookup: a bias of the wrong sign",
                                                              "a shadow's origin is dropped",
                                                              "a shader's text: its last brace is dropped"};
inline fault planted_fault = fault::none;
[[nodiscard]] inline bool is_planted(fault f) { return planted_fault == f; }

template <class T>
[[nodiscard]] umbrage::spot_light<T> planted(umbrage::spot_light<T> light) {
    if (is_planted(fault::position_dropped)) light.position.x = 0;
    if (is_planted(fault::direction_axis_dropped)) light.direction.z = 0;
    if (is_planted(fault::cone_narrowed)) light.outer_angle_radians /= 6;
    if (is_planted(fault::far_plane_nearer)) light.z_far /= 3;
    return light;
}
template <class T>
[[nodiscard]] umbrage::directional_fit<T> planted(umbrage::directional_fit<T> fit) {
    if (is_planted(fault::direction_axis_dropped)) fit.direction.z = 0;
    if (is_planted(fault::receivers_shrunk) && fit.receivers)
        for (glm::dvec3& p : fit.receivers->points) p *= 0.5;
    return fit;
}
template <class T>
[[nodiscard]] umbrage::directional_light<T> planted(umbrage::directional_light<T> light) {
    if (is_planted(fault::direction_axis_dropped)) light.direction.x = 0;
    return light;
}
template <class T>
[[nodiscard]] umbrage::warp_fit<T> planted(umbrage::warp_fit<T> fit) {
    if (is_planted(fault::direction_axis_dropped)) fit.direction.z = 0;
    return fit;
}
template <class T>
[[nodiscard]] umbrage::cascade_fit<T> planted(umbrage::cascade_fit<T> fit) {
    if (is_planted(fault::direction_axis_dropped)) fit.direction.z = 0;
    return fit;
}
template <class T>
[[nodiscard]] umbrage::page_root<T> planted(umbrage::page_root<T> root) {
    if (is_planted(fault::direction_axis_dropped)) root.direction.z = 0;
    return root;
}
template <class T>
[[nodiscard]] umbrage::point_light<T> planted(umbrage::point_light<T> light) {
    if (is_planted(fault::position_dropped)) light.position.y = 0;
    if (is_planted(fault::border_dropped)) light.border = 0;
    if (is_planted(fault::bulb_far_plane_nearer)) light.z_far /= 10;
    return light;
}
template <class Other>
[[nodiscard]] const Other& planted(const Other& other) {
    return other;
}

}  // namespace turned
