// SPDX-License-Identifier: MIT
//
// Fits of lights: a directional fit holds its receivers, cascades are finite, and a spot fit answers or refuses.
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/splits.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/spot_fit.hpp>

#include "input.hpp"

namespace {

using namespace umbrage;

std::array<glm::dvec3, 8> corners_of(const bounding_box<double>& box) {
    std::array<glm::dvec3, 8> all;
    for (unsigned i = 0; i < 8; ++i)
        all[i] = {i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y, i & 4 ? box.high.z : box.low.z};
    return all;
}

/// A box as a user has one: its sides are ordinary, or its numbers are anything.
bounding_box<double> box_of(fuzz::input& in) {
    const glm::dvec3 a(in.vec3(-50, 50)), b(in.vec3(-50, 50));
    if (in.chance(4)) return {a, b};
    return {glm::min(a, b), glm::max(a, b)};
}

/// Every corner in front of the light lies within clip space, with room for rounding of the world's numbers.
void must_hold(const light_space<double>& light, const bounding_box<double>& box, const char* model) {
    const double nearest = light.clip.range == depth_range::zero_to_one ? 0.0 : -1.0;
    const glm::dmat4 to_clip = light.projection * light.view, rows = glm::transpose(to_clip);
    for (const glm::dvec3& corner : corners_of(box)) {
        const glm::dvec4 at = to_clip * glm::dvec4(corner, 1.0);
        const auto room = [&](glm::length_t axis) {
            return 1e-6 * at.w + 1e-13 * (glm::length(corner) + 1.0) * glm::length(glm::dvec3(rows[axis]));
        };
        fuzz::must(at.w > 0.0 && std::abs(at.x) <= at.w + room(0) && std::abs(at.y) <= at.w + room(1), model);
        fuzz::must(at.z <= at.w + room(2) && at.z >= nearest * at.w - room(2), model);
    }
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
        must_hold(fit_directional_light(fit), box, "a directional fit holds its receivers");
    });
    fuzz::answered([&] {
        const frustum<double> camera{.position = glm::dvec3(in.vec3(-50, 50)),
                                     .direction = glm::dvec3(in.vec3(-1, 1)),
                                     .tan_half_x = in.number(0.1f, 2),
                                     .tan_half_y = in.number(0.1f, 2),
                                     .z_near = in.number(0.01f, 1),
                                     .z_far = in.number(2, 500)};
        const cascade_fit<double> fit{.camera = camera,
                                      .direction = direction,
                                      .up = up,
                                      .scene = box,
                                      .map_size = {in.within(0, 4096), in.within(0, 4096)},
                                      .margin = in.number(0, 8),
                                      .overlap = in.number(0, 0.5f),
                                      .clip = clip};
        const auto splits = practical_splits<4>(camera.z_near, camera.z_far, double(in.number(0, 1)));
        for (const auto& c : make_stable_cascades<4>(fit, splits))
            fuzz::must(detail::all_finite(glm::dvec3(c.scale)), "a cascade's numbers are finite");
        static_cast<void>(make_tight_cascades<4>(fit, splits));
    });
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
        static_cast<void>(fit_spot_light(fit));
    });
    return 0;
}
