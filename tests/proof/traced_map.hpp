// SPDX-License-Identifier: MIT
//
// What a shadow is held against: triangles that rays meet, a light for rays, and one map of a shadow in double.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <type_traits>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <umbrage/shadow/paraboloid_maps.hpp>
#include <umbrage/shadow/shadow.hpp>
#include <umbrage/shadow/tetrahedron_map.hpp>

#include "point_rays.hpp"
#include "projected.hpp"
#include "ray_mesh.hpp"

namespace proof {

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
    /// The point of a plane that the map shows at a place; none where the plane passes behind the light.
    /// @param plane   (normal, offset): 0 on the plane
    [[nodiscard]] std::optional<glm::dvec3> point_at(glm::dvec2 texel, const glm::dvec4& plane) const {
        if (bent_) {
            const double inner = bent_->map_size - 2 * bent_->border, turn = number_ ? 1 : -1;
            const glm::dvec2 at = (texel - double(bent_->border)) / inner * 2.0 - 1.0;
            const double square = glm::dot(at, at), z = (1 - square) / (1 + square);
            const glm::dvec3 way(turn * at.x * (1 + z), at.y * (1 + z), -turn * z), normal(plane);
            const double t = -(glm::dot(normal, bent_->position) + plane.w) / glm::dot(normal, way);
            if (!(t > 0)) return std::nullopt;
            return bent_->position + t * way;
        }
        const glm::dmat4 rows = glm::transpose(to_texels_);
        const glm::dmat4 met = glm::transpose(
            glm::dmat4(rows[0] - texel.x * rows[3], rows[1] - texel.y * rows[3], plane, glm::dvec4(0, 0, 0, 1)));
        const glm::dvec3 p = glm::inverse(glm::dmat3(met)) * -glm::dvec3(met[3]);
        if (!(placed(p).w > 0)) return std::nullopt;
        return p;
    }
    [[nodiscard]] bool bends() const { return bent_.has_value(); }
    [[nodiscard]] glm::vec2 slope(glm::vec3 normal, glm::dvec3 p) const {
        if (!bent_) return glm::vec2(umbrage::plane_slope(planes_, glm::dvec3(normal), p));
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
    glm::dmat4 planes_;
    std::optional<umbrage::dual_paraboloid_light<double>> bent_{};
    int number_ = 0;
};

/// Map that a place is in, of a point.
using map_finder = std::function<const traced_map&(const umbrage::map_place&, glm::vec3)>;

/// Finder of a setup's maps, for positions relative to an origin.
template <class Setup>
[[nodiscard]] map_finder traced_maps(const Setup& setup, glm::ivec2 map_size, glm::dvec3 origin) {
    std::vector<traced_map> maps;
    for (const auto& light : setup.lights()) {
        if constexpr (std::is_same_v<Setup, umbrage::paraboloid_maps>) {
            auto here = setup.light;
            here.position -= origin;
            maps.emplace_back(here, static_cast<int>(maps.size()));
        } else maps.emplace_back(umbrage::detail::relative_to(origin, light), map_size);
    }
    if constexpr (std::is_same_v<Setup, umbrage::tetrahedron_map>) {
        const glm::vec3 from(setup.light.position - origin);
        return [ maps, from ](const auto&, glm::vec3 p) -> const auto& {
            return maps[std::size_t(umbrage::tetrahedron_face(p - from))];
        };
    } else return [maps](const auto& place, glm::vec3) -> const auto& {
            return maps[std::size_t(place.number)];
        };
}

/// Calls use(place) for each look at a map; what it returns is light beyond the last cascade's shadows.
using place_list = std::function<float(glm::vec3, glm::vec3, const std::function<void(const umbrage::map_place&)>&)>;

template <class Setup, int Matrices>
[[nodiscard]] place_list places_of(const umbrage::shadow_uniforms<Setup, Matrices>& u) {
    return [u](glm::vec3 p, glm::vec3 n, const auto& use) {
        return umbrage::detail::blended(Setup::places(u.maps, u.terms, p, n), [&](const auto& place) {
            if (place.at.x == umbrage::outside_all_maps) return 1.0f;
            return use(place), 0.0f;
        });
    };
}

/// What is known of a shadow without a look at its map: where it looks, and by how much its bias detaches.
struct shadow_facts {
    place_list places;
    map_finder map_of;
    std::function<float(glm::vec3, glm::vec3)> detaches;
    std::function<float(const umbrage::map_place&)> spare;  ///< slack that is no error of a caster's texels
    umbrage::shadow_terms terms;
    double reach;             ///< reach of the filter alone, texels
    bool bordered, reversed;  ///< bordered: beside its maps all is lit
    bool along_plane;         ///< texels are compared along the receiver's plane
    double farther;           ///< depth by which a caster may be stored too far from the light

    /// Depth up to which a caster's shadow is lost, by the places of the receiver and the slope of the caster.
    [[nodiscard]] float lost_before(const umbrage::map_place& place, glm::vec2 caster) const {
        const glm::vec2 own = place.slope;
        const float error = terms.error + place.slack;
        const float bias = along_plane ? error : umbrage::acne_free_bias(own, terms.reach, error);
        const auto sum = [](glm::vec2 v) { return std::abs(v.x) + std::abs(v.y); };
        const bool turned = along_plane && sum(caster - own) > sum(caster);
        return umbrage::peter_panning_distance(bias + error - spare(place), turned ? caster - own : caster,
                                               terms.reach);
    }

    /// @param origin   of positions, as the shadow is told
    template <class Shadow>
    explicit shadow_facts(const Shadow& s, glm::dvec3 origin = glm::dvec3(0))
        : places(places_of(s.uniforms())),
          map_of(traced_maps(s.setup(), s.map_size(), origin)),
          detaches([s](glm::vec3 p, glm::vec3 n) { return s.peter_panning_distance(p, n); }),
          spare([s](const umbrage::map_place& place) {
              using setup = std::remove_cvref_t<decltype(s.setup())>;
              if constexpr (!umbrage::detail::along_plane<setup, std::remove_cvref_t<decltype(s.filter())>>)
                  return 0.0f;
              const umbrage::light_space<double> light = s.setup().lights()[std::size_t(place.number)];
              const glm::dmat4 m = umbrage::texture_matrix(light, s.map_size());
              return umbrage::detail::spare_slack(m, s.map_size(), place);
          }),
          terms(s.uniforms().terms),
          reach(double(s.filter().reach())),
          bordered(std::remove_cvref_t<decltype(s.setup())>::outside == umbrage::outside_map::bordered),
          reversed(s.setup().clip().direction == umbrage::depth_direction::reversed),
          along_plane(umbrage::detail::along_plane<std::remove_cvref_t<decltype(s.setup())>,
                                                   std::remove_cvref_t<decltype(s.filter())>>),
          farther(double(reversed ? s.encoding().error().below : s.encoding().error().above)) {}
};

}  // namespace proof
