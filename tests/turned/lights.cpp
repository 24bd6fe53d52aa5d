// SPDX-License-Identifier: MIT
#include "lights.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

namespace turned {

namespace {

/// What is drawn into each map, by the map's first texel.
struct hand_drawn {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
};
std::map<const float*, hand_drawn> maps;

void judge_map(const made_light& light, bool clips, umbrage::image_view<const float> depths, const hand_drawn& mesh) {
    const umbrage::shadow lookup(light.space, depths.size, umbrage::filters::pcf_2x2{});
    drawn_shadow drawn{proof::shadow_facts(lookup), light.given, glm::dvec3(0), false, {}};
    drawn.light.clips = clips;
    drawn.add(mesh.positions, mesh.triangles);
    drawn.visibility = [&](glm::vec3 p, glm::vec3 n) { return lookup(depths, p, n); };
    drawn.judge_surfaces();
}

}  // namespace

given_light light_of(const glm::dmat4& view, const glm::dmat4& projection) {
    for (auto l = lights.rbegin(); l != lights.rend(); ++l)
        if (l->space.view == view && l->space.projection == projection) return l->is_used = true, l->given;
    for (auto l = lights.rbegin(); l != lights.rend(); ++l)
        if (l->space.view == view) return l->is_used = true, l->given;
    throw std::logic_error("a shadow of a light that no watched function made");
}

void judge_depth_pass(umbrage::image_view<const float> depths, const umbrage::mesh_view& mesh,
                      std::span<const glm::mat4> instances, const glm::dmat4& to_clip) {
    const auto light = std::ranges::find(lights, to_clip, &made_light::to_clip);
    if (light == lights.end() || depths.empty()) return;
    hand_drawn& all = maps[&depths[{0, 0}]];
    for (const glm::mat4& model : instances) {
        const auto first = static_cast<unsigned>(all.positions.size());
        for (const glm::vec3 p : mesh.positions) all.positions.emplace_back(model * glm::vec4(p, 1));
        for (const glm::uvec3 t : mesh.triangles) all.triangles.push_back(t + first);
    }
    light->is_used = true;
    judge_map(*light, true, depths, all);
}

void judge_unused_lights() {
    for (const made_light& light : std::vector(lights)) {
        if (light.is_used) continue;
        umbrage::image<float> depths({512, 512}, umbrage::cleared_depth(light.space.clip));
        try {
            const umbrage::shadow own(light.space, depths.size(), umbrage::filters::pcf_2x2{});
            own.draw(depths, {own_vertices, own_triangles});
            judge_map(light, light.given.clips, depths, {own_vertices, own_triangles});
        } catch (const std::invalid_argument&) {
        }  // far from the origin, where the program takes positions from another
    }
}

/// @cite   Frank, Wolfe: An algorithm for quadratic programming, 1956: the point of a hull nearest to p
bool is_within(const std::vector<glm::dvec3>& points, glm::dvec3 p) {
    if (points.empty()) return false;
    glm::dvec3 low = points[0], high = points[0], nearest = points[0];
    for (const glm::dvec3& x : points) low = glm::min(low, x), high = glm::max(high, x);
    const double spare = 1e-3 * glm::length(high - low);
    for (int step = 0; step < 400; ++step) {
        const glm::dvec3 off = nearest - p;
        const auto least = std::ranges::min_element(points, {}, [&](const glm::dvec3& x) { return glm::dot(off, x); });
        const glm::dvec3 way = *least - nearest;
        if (glm::dot(off, *least - p) > 0) return false;  // a plane between p and the hull
        if (glm::length(off) < spare) return true;
        const double t = -glm::dot(off, way) / glm::dot(way, way);
        nearest += std::clamp(t, 0.0, 1.0) * way;
    }
    return false;
}

}  // namespace turned
