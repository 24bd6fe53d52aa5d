// SPDX-License-Identifier: MIT
//
// Fits of lights: each holds its receivers. Cascades hold the part of the camera's view that is theirs, warps what the
// camera sees of a scene. All are finite, or refused.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/splits.hpp>
#include <umbrage/light/cascades/warped.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/spot_fit.hpp>
#include <umbrage/light/sweep.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/perspective.hpp>
#include <umbrage/light/warp/plane_optimal.hpp>
#include <umbrage/light/warp/trapezoidal.hpp>

#include "input.hpp"

namespace {

using namespace umbrage;

/// A box as a user has one: its sides are ordinary, or its numbers are anything.
bounding_box<double> box_of(fuzz::input& in) {
    const glm::dvec3 a(in.vec3(-50, 50)), b(in.vec3(-50, 50));
    if (in.chance(4)) return {a, b};
    return {glm::min(a, b), glm::max(a, b)};
}

glm::dmat4 absolute(glm::dmat4 m) {
    for (glm::length_t i = 0; i < 4; ++i) m[i] = glm::abs(m[i]);
    return m;
}

struct holding {
    bool depths = true;    ///< false: the near and the far plane do not count
    double share = 1e-6;   ///< room as a share of the map
    bool corners = false;  ///< points are corners of an intersection: all numbers of one are as far off as its largest
};

/// Every point in front of the light lies within clip space, with room for rounding in its matrices' products.
void must_hold(const light_space<double>& light, const std::vector<glm::dvec3>& points, const char* model,
               const holding& how = {}) {
    const double nearest = light.clip.range == depth_range::zero_to_one ? 0.0 : -1.0;
    const glm::dmat4 to_clip = light.projection * light.view, sizes = absolute(light.projection) * absolute(light.view);
    for (const glm::dvec3& point : points) {
        const glm::dvec4 at = to_clip * glm::dvec4(point, 1.0);
        const glm::dvec3 own = glm::abs(point), off = how.corners ? glm::dvec3(std::max({own.x, own.y, own.z})) : own;
        const glm::dvec4 rounded = 1e-14 * (sizes * glm::dvec4(off, 1.0));
        const auto room = [&](glm::length_t axis) { return how.share * at.w + rounded[axis] + rounded.w; };
        fuzz::must(at.w > 0.0 && std::abs(at.x) <= at.w + room(0) && std::abs(at.y) <= at.w + room(1), model);
        if (how.depths) fuzz::must(at.z <= at.w + room(2) && at.z >= nearest * at.w - room(2), model);
    }
}

frustum<double> camera_of(fuzz::input& in, bool off_axis) {
    frustum<double> camera{.position = glm::dvec3(in.vec3(-50, 50)),
                           .direction = glm::dvec3(in.vec3(-1, 1)),
                           .tan_half_x = in.number(0.1f, 2),
                           .tan_half_y = in.number(0.1f, 2),
                           .z_near = in.number(0.01f, 1),
                           .z_far = in.number(2, 500)};
    if (!off_axis) return camera;
    camera.shift = {in.number(-1, 1), in.number(-1, 1)}, camera.half_size = {in.number(0, 5), in.number(0, 5)};
    if (in.chance(4)) camera.tan_half_x = camera.tan_half_y = 0.0;
    return camera;
}

void cascades(fuzz::input& in, const cascade_fit<double>& fit) {
    const auto splits = practical_splits<3>(fit.camera.z_near, fit.camera.z_far, double(in.number(0, 1)));
    const auto part = [&](std::size_t i) {
        frustum<double> slice = fit.camera;
        slice.z_near = splits[i], slice.z_far = splits[i + 1];
        return slice;
    };
    const auto stable = make_stable_cascades<3>(fit, splits);
    for (std::size_t i = 0; i < stable.size(); ++i)
        must_hold(stable[i].light, hull(part(i)).points, "a stable cascade holds its slice", {.depths = false});
    const auto tight = make_tight_cascades<3>(fit, splits);
    for (std::size_t i = 0; i < tight.size(); ++i)
        must_hold(tight[i].light, hull(intersection(part(i), fit.scene)).points, "a tight cascade holds what is seen",
                  {.corners = true});
    const auto warp = [](const warp_fit<double>& of_slice) { return fit_light_space_perspective(of_slice); };
    const auto warped = make_warped_cascades<3>(fit, splits, warp);
    for (std::size_t i = 0; i < warped.size(); ++i)
        must_hold(warped[i].light, hull(intersection(part(i), fit.scene)).points, "a warped cascade holds what is seen",
                  {.corners = true});
}

void warps(fuzz::input& in, const warp_fit<double>& fit) {
    const auto holds = [&](const warped_light<double>& warped, const char* model, double share = 1e-6) {
        fuzz::must(warped.strength >= 0.0 && warped.strength <= 1.0, "a warp's strength lies within 0 and 1");
        must_hold(warped.light, fit.receivers->points, model, {.share = share, .corners = true});
    };
    fuzz::answered([&] { holds(fit_light_space_perspective(fit), "a light-space perspective holds what is seen"); });
    fuzz::answered([&] { holds(fit_light_space_perspective(fit, double(in.number(0, 50))), "at any distance"); });
    fuzz::answered([&] { holds(fit_trapezoidal(fit, double(in.number(0, 50))), "a trapezoid holds what is seen"); });
    fuzz::answered([&] { holds(fit_perspective(fit, double(in.number(0, 20))), "a perspective holds what is seen"); });
    const glm::dvec4 plane(glm::dvec3(in.vec3(-1, 1)), in.number(-20, 20));
    fuzz::answered([&] {
        if (const auto warped = fit_plane_optimal(fit, plane))
            fuzz::must(detail::all_finite(warped->light.projection * warped->light.view), "a plane's map is finite");
    });
    const light_position<double> from{.position = glm::dvec3(in.vec3(-50, 50)), .z_near = in.number(0.05f, 1)};
    fuzz::answered([&] {  // the light may be so far away that its map has few digits, see warp_fit.hpp
        holds(fit_perspective(fit, from, double(in.number(0, 20))), "a point light's holds what is seen", 1.0 / 16.0);
    });
    fuzz::answered([&] { static_cast<void>(fit_plane_optimal(fit, plane, from)); });
}

/// Corners of the receivers within a spot light's pyramid, a little inside its sides, where doubles tell them from the
/// light.
std::vector<glm::dvec3> lit_by(const spot_fit<double>& fit) {
    const glm::dmat4 view = look_along(fit.position, fit.direction, fit.up, handedness::right);
    const double edge = 0.999 * std::tan(fit.outer_angle_radians),
                 closest = 1.001 * fit.z_near + 1e-13 * glm::length(fit.position);
    std::vector<glm::dvec3> lit;
    for (const glm::dvec3& p : fit.receivers->points) {
        const glm::dvec3 at(view * glm::dvec4(p, 1.0));
        if (-at.z > closest && std::abs(at.x) < -at.z * edge && std::abs(at.y) < -at.z * edge) lit.push_back(p);
    }
    return lit;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzz::input in(bytes, size);
    const clip_space clip = in.clip();
    const bounding_box<double> box = box_of(in), casters = box_of(in);
    const glm::dvec3 direction(in.vec3(-1, 1)), up(in.vec3(-1, 1));
    fuzz::answered([&] {
        directional_fit<double> fit{
            .direction = direction, .up = up, .receivers = box, .margin = in.number(0, 0.5f), .clip = clip};
        if (in.chance(2)) fit.casters = casters;
        if (in.chance(2)) fit.snap_texels = {in.within(-1, 2048), in.within(-1, 2048)};
        must_hold(fit_directional_light(fit), hull(box).points, "a directional fit holds its receivers");
    });
    const auto of_camera = [&](bool off_axis) {
        fuzz::answered([&] {
            cascades(in, {.camera = camera_of(in, off_axis),
                          .direction = direction,
                          .up = up,
                          .scene = box,
                          .map_size = {in.within(0, 4096), in.within(0, 4096)},
                          .margin = in.number(0, 8),
                          .overlap = in.number(0, 0.5f),
                          .clip = clip});
        });
        fuzz::answered([&] {
            const frustum<double> camera = camera_of(in, off_axis);
            warp_fit<double> fit{.camera = camera, .direction = direction, .margin = in.number(0, 0.5f), .clip = clip};
            fit.receivers = intersection(camera, box);
            if (in.chance(2)) fit.casters = casters;
            if (fit.receivers->points.empty()) fit.receivers = camera;
            warps(in, fit);
        });
    };
    of_camera(false);
    fuzz::answered([&] {
        const spot_fit<double> fit{.position = glm::dvec3(in.vec3(-50, 50)),
                                   .direction = direction,
                                   .up = up,
                                   .outer_angle_radians = in.number(0.01f, 1.5f),
                                   .z_near = in.number(0.01f, 1),
                                   .receivers = box,
                                   .margin = in.number(0, 0.5f),
                                   .has_far_plane = in.chance(2),
                                   .clip = clip};
        if (const auto light = fit_spot_light(fit))
            must_hold(*light, lit_by(fit), "a spot light holds the receivers in its pyramid");
    });
    of_camera(true);
    return 0;
}
