// SPDX-License-Identifier: MIT
#include "judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <random>
#include <utility>

#include <umbrage/core/scalar.hpp>

namespace turned {

namespace {

constexpr int receivers_of_surfaces = 32, receivers_behind = 96, receivers_at_seams = 48;

std::string printed(glm::vec3 v) {
    char text[96];
    std::snprintf(text, sizeof text, "(%.9g, %.9g, %.9g)", double(v.x), double(v.y), double(v.z));
    return text;
}

/// Random numbers that are the same in each run.
class dice {
public:
    double real(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
    std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }
    glm::dvec3 point_of(const joints::surface& s) {
        double u = real(0, 1), v = real(0, 1);
        if (u + v > 1) u = 1 - u, v = 1 - v;
        return s.corners[0] + u * (s.corners[1] - s.corners[0]) + v * (s.corners[2] - s.corners[0]);
    }

private:
    std::mt19937 random_{57};
};

/// The map that a shadow reads first at a point; null: none.
const proof::traced_map* first_map(const proof::shadow_facts& facts, glm::dvec3 p, glm::dvec3 normal) {
    const proof::traced_map* first = nullptr;
    static_cast<void>(facts.places(glm::vec3(p), glm::vec3(normal), [&](const umbrage::map_place& place) {
        if (!first) first = &facts.map_of(place, glm::vec3(p));
    }));
    return first;
}

/// Two points of a surface, close together, on either side of a seam: the second is read in another map.
std::optional<std::array<glm::dvec3, 2>> seam_of(const proof::shadow_facts& facts, const joints::surface& s,
                                                 dice& random) {
    glm::dvec3 here = random.point_of(s), there = random.point_of(s);
    const auto* const map = first_map(facts, here, s.normal);
    if (map == first_map(facts, there, s.normal)) return std::nullopt;
    for (int halving = 0; halving < 24; ++halving) {
        const glm::dvec3 middle = (here + there) / 2.0;
        (first_map(facts, middle, s.normal) == map ? here : there) = middle;
    }
    return std::array{here, there};
}

}  // namespace

std::vector<glm::vec3> tilted_around(glm::dvec3 light) {
    const glm::dvec3 up = glm::normalize(glm::dvec3(0.5, 0.8, 0.15)), right = glm::normalize(glm::cross(up, {0, 0, 1}));
    const auto corner = [&](double x, double height, double z) {
        return glm::vec3(light + x * right + (height - 1) * up + z * glm::cross(up, right));
    };
    std::vector<glm::vec3> all;
    for (const auto& [x, z] : {std::pair(-8, -8), {8, -8}, {8, 8}, {-8, 8}}) all.push_back(corner(x, 0, z));
    for (const auto& [x, z] : {std::pair(-1, 0), {0, 0}, {0, 1}, {-1, 1}}) all.push_back(corner(x, 0.5, z));
    return all;
}

void add_wrong(const std::string& what) {
    if (seen.wrong++ == 0) seen.first = what;
}

void add_visibility(const char* name, float value) {
    if (!(value >= 0 && value <= 1)) add_wrong(std::string(name) + " is " + std::to_string(value) + ", no visibility");
}

void drawn_shadow::add(const std::vector<glm::vec3>& positions, const std::vector<glm::uvec3>& triangles) {
    for (const glm::uvec3& t : triangles) {
        if (std::max({t.x, t.y, t.z}) >= positions.size()) continue;
        joints::surface s;
        for (const unsigned i : {t.x, t.y, t.z}) s.corners.emplace_back(positions[i]);
        const glm::dvec3 normal = glm::cross(s.corners[1] - s.corners[0], s.corners[2] - s.corners[0]);
        const double area = glm::length(normal), side = glm::length(s.corners[1] - s.corners[0]);
        if (!(area > 1e-6 * side * side) || !std::isfinite(area)) continue;  // draws nothing, or a line
        s.normal = normal / area;
        surfaces.push_back(s);
    }
}

drawn_shadow::ruling drawn_shadow::rule(const joints::receiver& r) const {
    using joints::verdict;
    const double stated = double(facts.detaches(r.point, r.normal));
    verdict all;
    bool is_first = true, is_in = true;
    const float beyond = facts.places(r.point, r.normal, [&](const umbrage::map_place& place) {
        const proof::traced_map& map = facts.map_of(place, r.point);
        const double reach = double(facts.terms.reach) + 1.0 / 16,
                     off = double(place.slack - facts.spare(place)) + 0x1p-22;
        const glm::dvec4 h = map.placed(glm::dvec3(r.point));
        const auto is_held = [&](double least, double spare) {
            const auto within = [&](double v, float size) { return v >= least && v <= double(size) - least; };
            return h.w > 0 && h.z >= -spare * h.w && h.z <= h.w * (1 + spare) &&
                   within(h.x / h.w, facts.terms.map_size.x) && within(h.y / h.w, facts.terms.map_size.y);
        };
        verdict here = joints::verdict_of(map, light.rays, surfaces, r, reach, stated, light.clips);
        is_in = is_in && is_held(-1.0 / 16, off);
        if (std::abs(map.depth(glm::dvec3(r.point)) - 1) <= off) here = {};  // on the far plane
        if (here.is_dark() && !is_held(facts.bordered ? reach + 1 : 0, 0)) here = {};
        all = is_first || all == here ? here : verdict{};
        is_first = false;
    });
    const bool is_unheld = !is_in && light.promises && light.promises(glm::dvec3(r.point) + origin);
    if (beyond > 0 && all.is_dark()) return {{}, is_unheld};
    return {all, is_unheld};
}

void drawn_shadow::count(const joints::receiver& r, float v) const {
    if (!(v >= 0 && v <= 1)) return add_wrong("visibility " + std::to_string(v) + " at " + printed(r.point));
    const ruling ruled = rule(r);
    if (ruled.is_unheld) return add_wrong("no map holds " + printed(r.point));
    if (ruled.is.is_open()) return void(++seen.undecided);
    const bool is_lit = ruled.is.is_lit();
    ++(is_lit ? seen.lit : seen.dark);
    const bool is_right = is_soft ? (v > 0.5f) == is_lit : v == (is_lit ? 1.0f : 0.0f);
    if (!is_right)
        add_wrong(printed(r.point) + " with normal " + printed(r.normal) + " is " + std::to_string(v) +
                  ", but rays say " + (is_lit ? "lit" : "dark"));
}

void drawn_shadow::judge_surfaces() const {
    if (surfaces.empty()) return;
    dice random;
    ++seen.shadows;
    const auto look = [&](std::size_t own, glm::dvec3 p) {
        const joints::receiver r{own, glm::vec3(p), glm::vec3(surfaces[own].normal)};
        count(r, visibility(r.point, r.normal));
    };
    for (int i = 0; i < receivers_of_surfaces; ++i) {
        const std::size_t own = random.below(surfaces.size());
        look(own, random.point_of(surfaces[own]));
    }
    for (int i = 0, found = 0; i < 2000 && found < receivers_behind; ++i) {  // a caster, or an edge of it
        const joints::surface& caster = surfaces[random.below(surfaces.size())];
        const std::size_t side = random.below(3), own = random.below(surfaces.size());
        const glm::dvec3 a = caster.corners[side], b = caster.corners[(side + 1) % 3];
        const bool is_edge = i % 2 == 0;
        const glm::dvec3 from = is_edge ? a + random.real(0, 1) * (b - a) : random.point_of(caster);
        const glm::dvec3 way = light.rays.way(from);
        const joints::surface& s = surfaces[own];
        const double t = glm::dot(s.normal, s.corners[0] - from) / glm::dot(s.normal, way);
        if (!(t < -1e-6) || !std::isfinite(t)) continue;  // this surface is nearer to the light
        const glm::dvec3 foot = from + t * way, away = random.point_of(s) - foot;
        const glm::dvec3 p = is_edge ? foot + away * std::pow(10.0, random.real(-3.5, -1)) : foot;
        bool is_inside = true;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec3 corner = s.corners[k];
            is_inside = is_inside && glm::dot(glm::cross(s.corners[(k + 1) % 3] - corner, p - corner), s.normal) > 0;
        }
        if (is_inside) look(own, p), ++found;
    }
    for (int i = 0, found = 0; i < 400 && found < receivers_at_seams; ++i) {  // within a filter's reach of another map
        const std::size_t own = random.below(surfaces.size());
        const auto seam = seam_of(facts, surfaces[own], random);
        if (!seam) continue;
        for (const glm::dvec3& side : *seam) {
            const glm::dvec3 away = random.point_of(surfaces[own]) - side;
            look(own, side + away * std::pow(10.0, random.real(-4, -2))), ++found;
        }
    }
}

void drawn_shadow::judge(glm::vec3 point, glm::vec3 normal, float v) const {
    static int lookups = 0;
    if (++lookups > 200 && lookups % 97 != 0) return add_visibility("visibility", v);  // a picture's pixels: a sample
    const double length = double(glm::length(normal));
    const bool is_position = umbrage::is_finite(point.x) && umbrage::is_finite(point.y) && umbrage::is_finite(point.z);
    if (!(length > 0) || !std::isfinite(length) || !is_position) return add_visibility("visibility", v);
    // The receiver is on a surface of its own, which casts nothing. Its plane hides the triangle that it lies on.
    drawn_shadow with_own = *this;
    const glm::dvec3 n = glm::normalize(glm::dvec3(normal)), p(point);
    const glm::dvec3 u = glm::normalize(glm::cross(n, std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
    const glm::dvec3 w = glm::cross(n, u);
    with_own.surfaces.push_back({{p + u, p - 0.5 * u + w, p - 0.5 * u - w}, n, {}});
    with_own.count({with_own.surfaces.size() - 1, point, normal}, v);
}

}  // namespace turned
