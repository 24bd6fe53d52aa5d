// SPDX-License-Identifier: MIT
//
// The library's makers of lights as a program calls them. Each remembers the arguments, for rays.
#pragma once

#include <span>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "fault.hpp"
#include "judge.hpp"

namespace turned {

/// A light that a program made, by the matrices that it has from there on.
struct made_light {
    umbrage::light_space<double> space;
    glm::dmat4 to_clip;  ///< as the program multiplies it
    given_light given;
    bool is_used = false;  ///< in a shadow, or in a depth pass
};
inline std::vector<made_light> lights;

/// The light of some matrices. A shadow's depth passes may have other projections than the light, and the same view.
[[nodiscard]] given_light light_of(const glm::dmat4& view, const glm::dmat4& projection);

/// Judges a map that a program drew by hand, by lookups of the judge's own.
void judge_depth_pass(umbrage::image_view<const float> depths, const umbrage::mesh_view& mesh,
                      std::span<const glm::mat4> instances, const glm::dmat4& to_clip);

/// Judges what a program made and did not use, over a scene of the judge's own.
void judge_unused_lights();

/// True within the hull of some points, a part of its extent from the hull at least.
[[nodiscard]] bool is_within(const std::vector<glm::dvec3>& points, glm::dvec3 p);

template <class T>
void remember(const umbrage::light_space<T>& light, const given_light& given) {
    lights.push_back({{glm::dmat4(light.view), glm::dmat4(light.projection), light.clip},
                      glm::dmat4(light.projection * light.view),
                      given});
}

template <class T>
[[nodiscard]] given_light sun_of(glm::vec<3, T> direction, const std::optional<umbrage::hull>& receivers) {
    given_light sun{{false, -glm::dvec3(direction)}};
    if (receivers && receivers->radius == 0.0)
        sun.promises = [points = receivers->points](glm::dvec3 p) { return is_within(points, p); };
    return sun;
}

/// Between the planes of a light around a point, along the axes of its maps: what any of them sees.
template <class T>
[[nodiscard]] given_light bulb_of(glm::vec<3, T> position, double z_near, double z_far) {
    const glm::dvec3 from(position);
    return {{true, from},
            true,
            [=](glm::dvec3 p) {
                const double nearest = glm::length(p - from);
                return nearest > 3.01 * z_near && nearest < 0.99 * z_far;
            },
            true};
}

template <class T>
[[nodiscard]] given_light cascades_of(const umbrage::cascade_fit<T>& fit, T begin, T end) {
    given_light sun{{false, -glm::dvec3(fit.direction)}};
    umbrage::frustum<T> camera = fit.camera;
    camera.z_near = begin, camera.z_far = begin + T(0.8) * (end - begin);  // the last cascade fades
    const umbrage::polyhedron body = intersection(camera, fit.scene);
    sun.promises = [body](glm::dvec3 p) {
        for (const auto& face : body.faces())
            if (!(glm::dot(face.plane, glm::dvec4(p, 1)) > 1e-3 * (1 + glm::length(p)))) return false;
        return !body.empty();
    };
    return sun;
}

}  // namespace turned

/// What a program calls: its `umbrage` is this namespace.
namespace watched {

using namespace ::umbrage;

template <real T = float>
[[nodiscard]] light_space<T> make_spot_light(const spot_light<T>& given) {
    const auto light = ::umbrage::make_spot_light(turned::planted(given));
    const glm::dvec3 from(given.position), axis = glm::normalize(glm::dvec3(given.direction));
    const double cosine = std::cos(0.98 * double(given.outer_angle_radians));
    turned::remember(light, {{true, from}, true, [=](glm::dvec3 p) {
                                 const double along = glm::dot(p - from, axis);
                                 return along > 1.01 * double(given.z_near) && along < 0.99 * double(given.z_far) &&
                                        along > cosine * glm::length(p - from);
                             }});
    return light;
}

template <real T = float>
[[nodiscard]] light_space<T> fit_directional_light(const directional_fit<T>& fit) {
    const auto light = ::umbrage::fit_directional_light(turned::planted(fit));
    return turned::remember(light, turned::sun_of(fit.direction, fit.receivers)), light;
}

template <real T = float>
[[nodiscard]] light_space<T> make_directional_light(const directional_light<T>& given) {
    const auto light = ::umbrage::make_directional_light(turned::planted(given));
    return turned::remember(light, {{false, -glm::dvec3(given.direction)}}), light;
}

template <real T = float>
[[nodiscard]] warped_light<T> fit_light_space_perspective(const warp_fit<T>& fit) {
    const auto warped = ::umbrage::fit_light_space_perspective(turned::planted(fit));
    return turned::remember(warped.light, turned::sun_of(fit.direction, fit.receivers)), warped;
}

template <std::size_t Count, real T>
[[nodiscard]] auto make_stable_cascades(const cascade_fit<T>& fit, const std::array<T, Count + 1>& splits) {
    const auto cascades = ::umbrage::make_stable_cascades<Count>(turned::planted(fit), splits);
    turned::remember(cascades[0].light, turned::cascades_of(fit, splits.front(), splits.back()));
    return cascades;
}

template <std::size_t Count, real T, class Warp>
[[nodiscard]] auto make_warped_cascades(const cascade_fit<T>& fit, const std::array<T, Count + 1>& splits,
                                        Warp&& warp) {
    const auto cascades = ::umbrage::make_warped_cascades<Count>(turned::planted(fit), splits, warp);
    turned::remember(cascades[0].light, turned::cascades_of(fit, splits.front(), splits.back()));
    return cascades;
}

template <real T = float>
[[nodiscard]] light_space<T> make_page_root(const page_root<T>& given) {
    const auto root = ::umbrage::make_page_root(turned::planted(given));
    return turned::remember(root, {{false, -glm::dvec3(given.direction)}}), root;
}

template <class Matrix>
void rasterize_depth(image_view<float> depth, const mesh_view& mesh, const Matrix& world_to_clip, clip_space clip,
                     cull_mode cull = cull_mode::none) {
    ::umbrage::rasterize_depth(depth, mesh, world_to_clip, clip, cull);
    const glm::mat4 in_place(1);
    if (cull == cull_mode::none)
        turned::judge_depth_pass(depth, mesh, std::span(&in_place, 1), glm::dmat4(world_to_clip));
}
template <class Matrix>
void rasterize_depth(image_view<float> depth, const mesh_view& mesh, std::span<const glm::mat4> instances,
                     const Matrix& world_to_clip, clip_space clip, cull_mode cull = cull_mode::none) {
    ::umbrage::rasterize_depth(depth, mesh, instances, world_to_clip, clip, cull);
    if (cull == cull_mode::none) turned::judge_depth_pass(depth, mesh, instances, glm::dmat4(world_to_clip));
}

}  // namespace watched
