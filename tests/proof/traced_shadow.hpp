// SPDX-License-Identifier: MIT
//
// A shadow of any setup against rays: at points of triangles where rays tell what it must say, and under a caster that
// comes nearer until its shadow is lost.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <random>
#include <type_traits>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <umbrage/shadow/shadow.hpp>

#include "traced_map.hpp"

namespace proof {

/// A shadow, whichever: what holds it against rays is compiled once.
struct any_shadow : shadow_facts {
    std::function<void(const umbrage::mesh_view&)> draw;
    std::function<float(glm::vec3, glm::vec3)> visibility;

    template <class Shadow>
    explicit any_shadow(const Shadow& s) : shadow_facts(s) {
        const auto drawn = std::make_shared<umbrage::image<float>>(s.size());
        draw = [s, drawn](const umbrage::mesh_view& mesh) {
            std::ranges::fill(drawn->texels(), s.cleared());
            s.draw(*drawn, mesh);
        };
        visibility = [s, drawn](glm::vec3 p, glm::vec3 n) { return s(*drawn, p, n); };
    }
};

/// Answers of a shadow at receivers that rays decide.
struct traced {
    std::uint64_t lit = 0, shadowed = 0;
    std::uint64_t acne = 0, leaks = 0;  ///< wrong: dark where it is lit, and the other way round
    std::uint64_t faded = 0;            ///< not told: the last cascade's shadows fade to light
    std::uint64_t outside = 0;          ///< looks of receivers in view at maps that do not hold them
    std::uint64_t misplaced = 0;        ///< looked up elsewhere than the depth pass draws them

    [[nodiscard]] std::uint64_t wrong() const { return acne + leaks + outside + misplaced; }
    traced& operator+=(const traced& o) {
        lit += o.lit, shadowed += o.shadowed, acne += o.acne, leaks += o.leaks;
        faded += o.faded, outside += o.outside, misplaced += o.misplaced;
        return *this;
    }
};

/// A point of a triangle: counted, where no edge lies within the filter's reach and a texel, and no caster within what
/// the bias and its own slope hide.
inline void trace(const any_shadow& s, const ray_light& light, const ray_mesh& mesh, std::size_t own, glm::vec3 p,
                  traced& found) {
    const glm::vec3 normal = mesh.normal(own);
    const glm::dvec3 way = light.way(p);
    bool is_lit = true, is_told = true;
    const float light_beyond = s.places(p, normal, [&](const umbrage::map_place& place) {
        const traced_map& map = s.map_of(place, p);
        const glm::dvec4 h = map.placed(p);
        const auto within = [&](double v, float size, double least) { return v >= least && v <= double(size) - least; };
        const auto held = [&](double least) {
            return h.w > 0 && h.z >= 0 && h.z <= h.w && within(h.x / h.w, s.terms.map_size.x, least) &&
                   within(h.y / h.w, s.terms.map_size.y, least);
        };
        if (!held(s.bordered ? s.reach + 1 : 0)) {
            found.outside += !held(0);
            is_told = false;
            return;
        }
        const double depth = s.reversed ? 1 - double(place.at.z) : double(place.at.z);
        found.misplaced += !(glm::length(glm::dvec2(place.at) - glm::dvec2(h) / h.w) < 1.0 / 64) ||
                           !(std::abs(depth - h.z / h.w) < 0x1p-20 + double(place.slack - s.spare(place)));
        is_told = is_told && !map.is_near_edge(mesh, p, 1.5 * (s.reach + 1));
        for (std::size_t k = 0; k < mesh.triangles.size() && is_told; ++k) {
            const double t = k == own ? std::nan("") : mesh.meets(k, p, way);
            if (std::isnan(t) || (light.is_point && t >= 1)) continue;
            const glm::dvec3 caster = glm::dvec3(p) + t * way;
            const double before = h.z / h.w - map.depth(caster);
            const float margin = s.lost_before(place, map.slope(mesh.normal(k), caster));
            is_told = std::abs(before) > double(margin);
            is_lit = is_lit && before <= 0;
        }
    });
    found.faded += light_beyond > 0.0f;
    if (!is_told || light_beyond > 0.0f) return;
    ++(is_lit ? found.lit : found.shadowed);
    const float seen = s.visibility(p, normal);
    found.acne += is_lit && seen < 1.0f;
    found.leaks += !is_lit && seen > 0.0f;
}

/// Up to where a caster's shadow is lost, in world units along the light.
struct detached {
    double stated;    ///< by the shadow, of a caster as steep in the map as the surface
    double bound;     ///< by peter_panning_distance, of the caster's own slope
    double measured;  ///< by rays
};

/// A plane through a point and a caster parallel to it: the least gap at which 4096 receivers in three by three texels
/// are wholly dark, as rays have them at any gap. That of the last one to be lit is measured.
/// @return   nothing for a plane near a map's border, in two maps, or whose shadow is lost for more than a unit
[[nodiscard]] inline std::optional<detached> detach(const any_shadow& s, const ray_light& light, glm::vec3 middle,
                                                    glm::vec3 normal, std::mt19937& random) {
    const traced_map* map = nullptr;
    bool is_held = true;
    const auto hold = [&](glm::vec3 p) {
        const auto look = [&](const umbrage::map_place& place) {
            const traced_map& own = s.map_of(place, p);
            is_held = is_held && (map == nullptr || map == &own);
            map = &own;
        };
        is_held = s.places(p, normal, look) == 0.0f && is_held;
    };
    hold(middle);
    const auto across = [&](glm::dvec3 p) {
        const glm::dvec4 h = map->placed(p);
        return glm::dvec2(h) / h.w;
    };
    const glm::dvec3 n = glm::normalize(glm::dvec3(normal)), center(middle), way = light.way(center);
    const glm::dvec3 u = glm::normalize(glm::cross(n, std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 v = glm::cross(n, u);
    const double step = 1e-4;
    const glm::dmat2 to_plane = glm::inverse(glm::dmat2((across(center + step * u) - across(center)) / step,
                                                        (across(center + step * v) - across(center)) / step));
    const auto on_plane = [&](glm::dvec2 texel) {
        const glm::dvec2 w = to_plane * texel;
        return glm::vec3(center + w.x * u + w.y * v);
    };
    std::vector<glm::vec3> receivers;
    std::uniform_real_distribution<double> nearby(-1.5, 1.5);
    for (int i = 0; i < 4096; ++i) receivers.push_back(on_plane(glm::dvec2{nearby(random), nearby(random)}));
    ray_mesh mesh{{}, {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}};
    for (int i = 0; i < 2; ++i)
        for (const glm::dvec2 corner : {glm::dvec2(-9, -9), {9, -9}, {9, 9}, {-9, 9}})
            mesh.positions.push_back(on_plane(corner));
    for (const glm::vec3& p : mesh.positions) hold(p);
    for (const glm::vec3& p : receivers) hold(p);
    if (!is_held) return std::nullopt;

    const auto lit_at = [&](double gap) {
        for (std::size_t i = 4; i < 8; ++i)
            mesh.positions[i] = glm::vec3(glm::dvec3(mesh.positions[i - 4]) + gap * way);
        s.draw(mesh.view());
        return std::ranges::find_if(receivers, [&](glm::vec3 p) { return s.visibility(p, normal) > 0.0f; });
    };
    double low = 0, high = 1 / glm::length(way);
    auto last = lit_at(low);
    if (last == receivers.end() || lit_at(high) != receivers.end()) return std::nullopt;
    for (int i = 0; i < 24; ++i) {
        const double gap = 0.5 * (low + high);
        const auto lit = lit_at(gap);
        if (lit != receivers.end()) low = gap, last = lit;
        else high = gap;
    }
    const glm::dvec3 here(*last), own = light.way(here);
    const double t = high * glm::dot(n, way) / glm::dot(n, own), world = t * glm::length(own);
    const glm::dvec3 caster = here + t * own;
    const double depth = map->depth(here) - map->depth(caster);
    float bound = 0;
    static_cast<void>(s.places(*last, normal, [&](const umbrage::map_place& place) {
        bound = s.lost_before(place, map->slope(normal, caster));
    }));
    return detached{world * double(s.detaches(*last, normal)) / depth, world * double(bound) / depth, world};
}

}  // namespace proof
