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

#include <umbrage/shadow/paraboloid_maps.hpp>
#include <umbrage/shadow/shadow.hpp>
#include <umbrage/shadow/tetrahedron_map.hpp>

#include "point_rays.hpp"
#include "projected.hpp"

namespace proof {

/// Triangles that rays meet.
struct ray_mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;

    [[nodiscard]] umbrage::mesh_view view() const { return {positions, triangles}; }
    [[nodiscard]] std::array<glm::dvec3, 3> corners(std::size_t k) const {
        const glm::uvec3 t = triangles[k];
        return {positions[t.x], positions[t.y], positions[t.z]};
    }
    [[nodiscard]] glm::vec3 normal(std::size_t k) const {
        const auto [a, b, c] = corners(k);
        return glm::vec3(glm::cross(b - a, c - a));
    }
    /// Distance at which a ray meets a triangle, in lengths of the way; NaN if it does not.
    /// @cite   Moeller, Trumbore: Fast, minimum storage ray/triangle intersection, 1997
    [[nodiscard]] double meets(std::size_t k, glm::dvec3 from, glm::dvec3 way) const {
        const auto [a, b, c] = corners(k);
        const glm::dvec3 ab = b - a, ac = c - a, p = glm::cross(way, ac), s = from - a, q = glm::cross(s, ab);
        const double det = glm::dot(ab, p), u = glm::dot(s, p) / det, v = glm::dot(way, q) / det;
        return u >= 0 && v >= 0 && u + v <= 1 ? glm::dot(ac, q) / det : std::nan("");
    }
};

/// Light for rays.
struct ray_light {
    bool is_point = false;
    glm::dvec3 from{0};  ///< the point, or a direction

    [[nodiscard]] glm::dvec3 way(glm::dvec3 p) const { return is_point ? from - p : from; }
};

/// One map of a shadow, in double.
class traced_map {
public:
    traced_map(const umbrage::light_space<double>& light, glm::ivec2 size)
        : reversed_(light.clip.direction == umbrage::depth_direction::reversed),
          to_texels_(umbrage::texture_matrix(light, size)),
          planes_(umbrage::plane_matrix(to_texels_)) {}
    traced_map(const umbrage::dual_paraboloid_light<double>& light, int number)
        : traced_map({.projection = make_dual_paraboloid_light(light).projection, .clip = light.clip},
                     glm::ivec2(light.map_size)) {
        bent_ = light, number_ = number;
    }

    /// (x, y) in texels and depth, before the division; forward, whatever the clip space.
    [[nodiscard]] glm::dvec4 placed(glm::dvec3 p) const {
        glm::dvec4 h = to_texels_ * (bent_ ? umbrage::dual_paraboloid_position(p - bent_->position, double(number_))
                                           : glm::dvec4(p, 1.0));
        if (reversed_) h.z = h.w - h.z;
        return h;
    }
    [[nodiscard]] double depth(glm::dvec3 p) const { return placed(p).z / placed(p).w; }
    [[nodiscard]] glm::vec2 slope(glm::vec3 normal, glm::dvec3 p) const {
        if (!bent_) return umbrage::plane_slope(planes_, normal, glm::vec3(p));
        const double inner = bent_->map_size - 2 * bent_->border;
        return umbrage::dual_paraboloid_slope(glm::vec3(p - bent_->position), normal,
                                              float(2 / (bent_->range * inner)));
    }
    /// True when an edge of any triangle lies within some texels.
    [[nodiscard]] bool is_near_edge(const ray_mesh& mesh, glm::dvec3 p, double texels) const {
        const glm::dvec4 h = placed(p);
        for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
            auto corner = mesh.corners(k);
            if (bent_) {
                const glm::dvec3 way = p - bent_->position;
                for (glm::dvec3& c : corner) c -= bent_->position;
                const double inner = bent_->map_size - 2 * bent_->border;
                const double texel = (1.05 + std::abs(way.z) / glm::length(way)) * 2 / inner;
                if (angle_to_edge(glm::normalize(way), corner) < texels * texel) return true;
            } else if (sees_edge(to_texels_, reversed_, corner, glm::dvec2(h) / h.w, texels)) return true;
        }
        return false;
    }

private:
    bool reversed_;
    glm::dmat4 to_texels_;
    glm::mat4 planes_;
    std::optional<umbrage::dual_paraboloid_light<double>> bent_{};
    int number_ = 0;
};

/// A shadow, whichever: what holds it against rays is compiled once.
struct any_shadow {
    std::function<void(const umbrage::mesh_view&)> draw;
    std::function<float(glm::vec3, glm::vec3)> visibility, detaches;
    /// Calls use(place) for each look at a map; what it returns is light beyond the last cascade's shadows.
    std::function<float(glm::vec3, glm::vec3, const std::function<void(const umbrage::map_place&)>&)> places;
    std::function<const traced_map&(const umbrage::map_place&, glm::vec3)> map_of;
    umbrage::shadow_terms terms;
    double reach;             ///< reach of the filter alone, texels
    bool bordered, reversed;  ///< bordered: beside its maps all is lit

    template <class Shadow>
    explicit any_shadow(const Shadow& s)
        : terms(s.uniforms().terms),
          reach(double(s.filter().reach())),
          bordered(set_up_of<Shadow>::outside == umbrage::outside_map::bordered),
          reversed(s.set_up().clip().direction == umbrage::depth_direction::reversed) {
        using set_up = set_up_of<Shadow>;
        const auto drawn = std::make_shared<umbrage::image<float>>(s.size());
        draw = [s, drawn](const umbrage::mesh_view& mesh) {
            std::ranges::fill(drawn->texels(), s.cleared());
            s.draw(*drawn, mesh);
        };
        visibility = [s, drawn](glm::vec3 p, glm::vec3 n) { return s(*drawn, p, n); };
        detaches = [s](glm::vec3 p, glm::vec3 n) { return s.peter_panning_distance(p, n); };
        places = [u = s.uniforms()](glm::vec3 p, glm::vec3 n, const auto& use) {
            return set_up::visibility(u.maps, u.terms, p, n, [&](const umbrage::map_place& place) {
                use(place);
                return 0.0f;
            });
        };
        std::vector<traced_map> maps;
        for (const auto& light : s.set_up().lights()) {
            if constexpr (std::is_same_v<set_up, umbrage::paraboloid_maps>)
                maps.emplace_back(s.set_up().light, static_cast<int>(maps.size()));
            else maps.emplace_back(light, s.map_size());
        }
        if constexpr (std::is_same_v<set_up, umbrage::tetrahedron_map>)
            map_of = [ maps, from = glm::vec3(s.set_up().light.position) ](const auto&, glm::vec3 p) -> const auto& {
                return maps[std::size_t(umbrage::tetrahedron_face(p - from))];
            };
        else map_of = [maps](const auto& place, glm::vec3) -> const auto& {
                return maps[std::size_t(place.number)];
            };
    }

private:
    template <class Shadow>
    using set_up_of = std::remove_cvref_t<decltype(std::declval<Shadow>().set_up())>;
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
                           !(std::abs(depth - h.z / h.w) < 0x1p-20);
        is_told = is_told && !map.is_near_edge(mesh, p, 1.5 * (s.reach + 1));
        const float bias = umbrage::acne_free_bias(place.slope, s.terms.reach, s.terms.error);
        for (std::size_t k = 0; k < mesh.triangles.size() && is_told; ++k) {
            const double t = k == own ? std::nan("") : mesh.meets(k, p, way);
            if (std::isnan(t) || (light.is_point && t >= 1)) continue;
            const glm::dvec3 caster = glm::dvec3(p) + t * way;
            const double before = h.z / h.w - map.depth(caster);
            const float margin =
                umbrage::peter_panning_distance(bias + s.terms.error, map.slope(mesh.normal(k), caster), s.terms.reach);
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
    for (int i = 0; i < 4096; ++i) {
        const double x = nearby(random), y = nearby(random);
        receivers.push_back(on_plane({x, y}));
    }
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
    const float bias = umbrage::acne_free_bias(map->slope(normal, here), s.terms.reach, s.terms.error);
    const float bound =
        umbrage::peter_panning_distance(bias + s.terms.error, map->slope(normal, caster), s.terms.reach);
    return detached{world * double(s.detaches(*last, normal)) / depth, world * double(bound) / depth, world};
}

}  // namespace proof
