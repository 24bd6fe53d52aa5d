// SPDX-License-Identifier: MIT
//
// Every setup function of lights, by its name, from one set of arguments.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include <glm/geometric.hpp>

#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/warped.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/point/dual_paraboloid.hpp>
#include <umbrage/light/point/point_light.hpp>
#include <umbrage/light/point/tetrahedron_light.hpp>
#include <umbrage/light/spot_fit.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/perspective.hpp>
#include <umbrage/light/warp/plane_optimal.hpp>
#include <umbrage/light/warp/trapezoidal.hpp>

namespace setup_functions {

using namespace umbrage;

/// Arguments of all light setups: a spot light and a camera, both inside a scene.
template <class T>
struct arguments {
    using vec = glm::vec<3, T>;
    vec direction{T(0.3), T(-1), T(0.2)}, up{T(0), T(1), T(0)}, position{T(1), T(4), T(2)};
    T angle = T(0.5), z_near = T(0.5), z_far = T(30);
    bounding_box<T> scene{vec(-10, -3, -10), vec(10, 8, 10)};
    vec eye{T(-2), T(1), T(6)}, ahead{T(0.1), T(-0.2), T(-1)};
    T tangent = T(0.8);
    clip_space clip = cpu_clip_space;

    [[nodiscard]] frustum<T> camera() const { return {eye, ahead, up, tangent, T(0.5), z_near, z_far}; }
};

template <class Cascades>
auto spaces(const Cascades& cascades) -> std::vector<std::decay_t<decltype(cascades[0].light)>> {
    return {cascades[0].light, cascades[1].light};
}

template <class T>
warp_fit<T> warp_of(const arguments<T>& a) {
    return {.camera = a.camera(),
            .direction = a.direction,
            .receivers = intersection(a.camera(), a.scene),
            .casters = a.scene,
            .clip = a.clip};
}

template <class T, std::size_t N>
std::vector<light_space<T>> vector_of(const std::array<light_space<T>, N>& faces) {
    return {faces.begin(), faces.end()};
}

/// Every setup function, by its name. Without a light where it gives none.
template <class T>
const std::map<std::string, std::function<std::vector<light_space<T>>(const arguments<T>&)>> functions{
    {"make_directional_light",
     [](const arguments<T>& a) -> std::vector<light_space<T>> {
         return {make_directional_light<T>({.direction = a.direction,
                                            .target = a.position,
                                            .up = a.up,
                                            .z_near = a.z_near,
                                            .z_far = a.z_far,
                                            .clip = a.clip})};
     }},
    {"make_spot_light",
     [](const arguments<T>& a) -> std::vector<light_space<T>> {
         return {make_spot_light<T>({.position = a.position,
                                     .direction = a.direction,
                                     .up = a.up,
                                     .outer_angle_radians = a.angle,
                                     .z_near = a.z_near,
                                     .z_far = a.z_far,
                                     .clip = a.clip})};
     }},
    {"make_point_light",
     [](const arguments<T>& a) {
         return vector_of(make_point_light<T>({a.position, a.z_near, a.z_far, 512, 2, a.clip}));
     }},
    {"make_tetrahedron_light",
     [](const arguments<T>& a) {
         return vector_of(make_tetrahedron_light<T>({a.position, a.z_near, a.z_far, 512, 2, a.clip}));
     }},
    {"make_dual_paraboloid_light",
     [](const arguments<T>& a) {
         return std::vector{make_dual_paraboloid_light<T>({a.position, a.z_far, 512, 2, a.clip})};
     }},
    {"fit_directional_light",
     [](const arguments<T>& a) -> std::vector<light_space<T>> {
         return {fit_directional_light<T>({.direction = a.direction,
                                           .up = a.up,
                                           .receivers = intersection(a.camera(), a.scene),
                                           .casters = a.scene,
                                           .clip = a.clip})};
     }},
    {"fit_spot_light",
     [](const arguments<T>& a) -> std::vector<light_space<T>> {
         const auto light = fit_spot_light<T>({.position = a.position,
                                               .direction = a.direction,
                                               .up = a.up,
                                               .outer_angle_radians = a.angle,
                                               .z_near = a.z_near,
                                               .receivers = a.scene,
                                               .casters = a.scene,
                                               .clip = a.clip});
         return light ? std::vector{*light} : std::vector<light_space<T>>{};
     }},
    {"make_stable_cascades",
     [](const arguments<T>& a) {
         return spaces(make_stable_cascades<2>(
             cascade_fit<T>{
                 .camera = a.camera(), .direction = a.direction, .up = a.up, .scene = a.scene, .clip = a.clip},
             {a.z_near, (a.z_near + a.z_far) / T(2), a.z_far}));
     }},
    {"make_tight_cascades",
     [](const arguments<T>& a) {
         return spaces(make_tight_cascades<2>(
             cascade_fit<T>{
                 .camera = a.camera(), .direction = a.direction, .up = a.up, .scene = a.scene, .clip = a.clip},
             {a.z_near, (a.z_near + a.z_far) / T(2), a.z_far}));
     }},
    {"fit_light_space_perspective",
     [](const arguments<T>& a) -> std::vector<light_space<T>> {
         return {fit_light_space_perspective(warp_of(a)).light};
     }},
    {"fit_trapezoidal",
     [](const arguments<T>& a) -> std::vector<light_space<T>> { return {fit_trapezoidal(warp_of(a), T(2)).light}; }},
    {"fit_perspective",
     [](const arguments<T>& a) -> std::vector<light_space<T>> { return {fit_perspective(warp_of(a)).light}; }},
    {"fit_plane_optimal",
     [](const arguments<T>& a) -> std::vector<light_space<T>> {
         const glm::vec<4, T> across(a.ahead, -glm::dot(a.ahead, a.eye + T(5) * a.ahead));
         return {fit_plane_optimal(warp_of(a), across).value().light};
     }},
    {"make_warped_cascades", [](const arguments<T>& a) {
         return spaces(make_warped_cascades<2>(
             cascade_fit<T>{
                 .camera = a.camera(), .direction = a.direction, .up = a.up, .scene = a.scene, .clip = a.clip},
             {a.z_near, (a.z_near + a.z_far) / T(2), a.z_far},
             [](const auto& part) { return fit_light_space_perspective(part); }));
     }}};

inline const std::vector<std::string> setups{
    "make_directional_light", "make_spot_light",           "make_point_light",    "fit_directional_light",
    "fit_spot_light",         "make_stable_cascades",      "make_tight_cascades", "fit_light_space_perspective",
    "fit_trapezoidal",        "make_warped_cascades",      "fit_perspective",     "fit_plane_optimal",
    "make_tetrahedron_light", "make_dual_paraboloid_light"};
inline const std::vector<std::string> around_points{"make_point_light", "make_tetrahedron_light",
                                                    "make_dual_paraboloid_light"};
inline const std::vector<std::string> of_camera{
    "fit_directional_light", "make_stable_cascades", "make_tight_cascades", "fit_light_space_perspective",
    "fit_trapezoidal",       "make_warped_cascades", "fit_perspective"};
inline const std::vector<std::string> of_spots{"make_spot_light", "fit_spot_light"};

}  // namespace setup_functions
