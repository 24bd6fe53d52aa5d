// SPDX-License-Identifier: MIT
//
// The maps of one light in double, whichever its kind: where a point lies in them, how large a texel is there, and
// depth passes of casters that differ from map to map.
#pragma once

#include <array>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/bias/light_units.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/draw/rasterize.hpp>
#include <umbrage/light/bounds.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/setup.hpp>

#include "../ray_mesh.hpp"

namespace proof::picture {

enum class light_kind { sun, spot, point };

/// Smallest box around a mesh.
[[nodiscard]] inline umbrage::bounding_box<double> box_of(const ray_mesh& mesh) {
    umbrage::bounding_box<double> box{glm::dvec3(mesh.positions.front()), glm::dvec3(mesh.positions.front())};
    for (const glm::vec3& p : mesh.positions)
        box = {glm::min(box.low, glm::dvec3(p)), glm::max(box.high, glm::dvec3(p))};
    return box;
}

/// Position in a map: texels and depth.
using map_point = glm::dvec3;

class light_maps {
public:
    template <class Shadow>
    light_maps(light_kind of, const Shadow& s, const ray_light& light, double light_range)
        : kind(of), rays(light), range(light_range), lights_(s.setup().lights()), size_(s.map_size()) {
        grid_ = std::remove_cvref_t<decltype(s.setup())>::grid;
        for (const auto& l : lights_) {
            to_texels_.push_back(umbrage::texture_matrix(l, size_));
            to_world_.push_back(glm::inverse(to_texels_.back()));
            units_.push_back(umbrage::make_light_units(l, size_));
        }
    }

    light_kind kind;
    ray_light rays;
    double range;  ///< distance that a spot light or point light reaches, world units

    /// Size of one map, texels.
    [[nodiscard]] glm::ivec2 size() const { return size_; }
    [[nodiscard]] const umbrage::light_space<double>& light(int map) const { return lights_[std::size_t(map)]; }
    [[nodiscard]] glm::dvec2 units(int map) const { return units_[std::size_t(map)]; }
    [[nodiscard]] double w(int map, glm::dvec3 p) const { return placed(map, p).w; }
    [[nodiscard]] map_point at(int map, glm::dvec3 p) const {
        const glm::dvec4 h = placed(map, p);
        return glm::dvec3(h) / h.w;
    }
    /// Direction of a directional light, or of the axis of a map.
    [[nodiscard]] glm::dvec3 axis(int map) const {
        const glm::dmat4& view = light(map).view;
        return -glm::dvec3(view[0][2], view[1][2], view[2][2]);
    }
    /// A texel's width along the light, in depth.
    [[nodiscard]] double width_in_depth(int map, glm::dvec3 p) const { return units(map).x * units(map).y / w(map, p); }
    /// Bound of rounding in the slack of a place.
    [[nodiscard]] float rounding(const umbrage::map_place& place, glm::dvec3 p) const {
        const double steep = std::abs(place.slope.x) + std::abs(place.slope.y);
        const double beside = umbrage::detail::texels_beside_plane(light(place.number).clip, size_);
        return float((std::max)(0.0, place.slack - width_in_depth(place.number, p) - beside * steep));
    }
    /// Edge of a texel across the light, world units.
    [[nodiscard]] double texel(int map, glm::dvec3 p) const { return units(map).x * w(map, p); }
    [[nodiscard]] bool holds(map_point at, double border) const {
        const glm::dvec2 beyond = glm::dvec2(size_) - border;
        return at.x >= border && at.y >= border && at.x <= beyond.x && at.y <= beyond.y && at.z >= 0 && at.z <= 1;
    }
    /// Point of a plane that the light sees at a texel; nothing where the plane turns away from the light.
    [[nodiscard]] std::optional<glm::dvec3> on_plane(int map, glm::dvec2 texel, glm::dvec3 p, glm::dvec3 normal) const {
        const auto back = [&](double depth) {
            const glm::dvec4 h = to_world_[std::size_t(map)] * glm::dvec4(texel, depth, 1.0);
            return glm::dvec3(h) / h.w;
        };
        const glm::dvec3 from = back(0.0), way = back(1.0) - from;
        const double against = glm::dot(normal, way);
        if (!(against < 0)) return std::nullopt;
        const glm::dvec3 found = from + way * (glm::dot(normal, p - from) / against);
        return w(map, found) > 0 ? std::optional(found) : std::nullopt;
    }

    /// Draws all maps, each with its own casters.
    /// @param casters_of   map number -> mesh
    template <class CastersOf>
    [[nodiscard]] umbrage::image<float> draw(const CastersOf& casters_of, umbrage::cull_mode cull) const {
        umbrage::image<float> depths(size_ * glm::ivec2(grid_.columns, grid_.rows), 1.0f);
        for (int map = 0; map < int(lights_.size()); ++map) {
            const ray_mesh& mesh = casters_of(map);
            const auto own = depths.view().region(umbrage::detail::first_texel(map, grid_, size_), size_);
            umbrage::rasterize_depth(own, mesh.view(), light(map).projection * light(map).view, light(map).clip, cull,
                                     umbrage::serial{},
                                     rays.is_point ? umbrage::near_plane::clips : umbrage::near_plane::clamps);
        }
        return depths;
    }
    /// Casters with their vertices on a grid of 1/16 texel, as rasterizers with 4 sub-pixel bits have them. Triangles
    /// that reach behind the light stay, since rasterizers cut them first.
    [[nodiscard]] ray_mesh on_coarse_grid(int map, const ray_mesh& mesh) const {
        return moved_in_map(map, mesh, [](std::array<glm::dvec4, 3>& corners) {
            for (const glm::dvec4& c : corners)
                if (!(c.w > 0.1 && c.z > 0)) return;
            for (glm::dvec4& c : corners) c = {glm::round(glm::dvec2(c) * 16.0) / 16.0, c.z, c.w};
        });
    }
    /// Casters as a rasterizer's slope-scaled depth bias has them: farther by a number of texels, times the larger of
    /// the slopes of their depth along the map's axes. None is moved beyond infinity, where it would come back.
    [[nodiscard]] ray_mesh with_slope_bias(int map, const ray_mesh& mesh, double texels) const {
        const glm::dvec4 infinity = to_texels_[std::size_t(map)] * glm::dvec4(axis(map), 0.0);
        const double most = infinity.w > 0 ? infinity.z / infinity.w : std::numeric_limits<double>::max();
        return moved_in_map(map, mesh, [=](std::array<glm::dvec4, 3>& corners) {
            const auto side = [&](std::size_t i) { return glm::dvec3(corners[i]) - glm::dvec3(corners[0]); };
            const glm::dvec3 n = glm::cross(side(1), side(2));
            const double bias = texels * (glm::max)(std::abs(n.x / n.z), std::abs(n.y / n.z));
            if (!(bias >= 0)) return;  // the triangle is a line in the map
            for (glm::dvec4& c : corners) c.z = c.w > 0 ? (glm::min)(c.z + bias, (c.z + most) / 2) : c.z + bias;
        });
    }
    /// One map of an image of all.
    [[nodiscard]] umbrage::image_view<const float> map_of(const umbrage::image<float>& all, int map) const {
        return all.view().region(umbrage::detail::first_texel(map, grid_, size_), size_);
    }

private:
    /// Triangles with their corners moved as places in a map: texels, depth, w.
    template <class Move>
    [[nodiscard]] ray_mesh moved_in_map(int map, const ray_mesh& mesh, const Move& move) const {
        ray_mesh moved;
        for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
            std::array<glm::dvec4, 3> places{};
            for (std::size_t i = 0; i < 3; ++i) {
                const glm::dvec4 h = placed(map, glm::dvec3(mesh.corners(k)[i]));
                places[i] = {glm::dvec3(h) / h.w, h.w};
            }
            const auto before = places;
            move(places);
            for (std::size_t i = 0; i < 3; ++i) {
                const glm::dvec4 h = to_world_[std::size_t(map)] * glm::dvec4(glm::dvec3(places[i]), 1.0);
                moved.positions.emplace_back(places[i] == before[i] ? glm::dvec3(mesh.corners(k)[i])
                                                                    : glm::dvec3(h) / h.w);
            }
            const auto first = static_cast<unsigned>(3 * k);
            moved.triangles.emplace_back(first, first + 1, first + 2);
        }
        return moved;
    }

    [[nodiscard]] glm::dvec4 placed(int map, glm::dvec3 p) const {
        return to_texels_[std::size_t(map)] * glm::dvec4(p, 1.0);
    }

    std::vector<umbrage::light_space<double>> lights_;
    std::vector<glm::dmat4> to_texels_{}, to_world_{};
    std::vector<glm::dvec2> units_{};
    glm::ivec2 size_;
    umbrage::map_grid grid_{};
};

}  // namespace proof::picture
