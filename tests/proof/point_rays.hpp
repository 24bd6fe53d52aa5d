// SPDX-License-Identifier: MIT
//
// Point lights' maps from end to end against rays: triangles all around a light, a depth pass of each kind of map, and
// filters' lookups, at points where a ray to the light tells what they must find.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/slope.hpp>
#include <umbrage/depth/conversions.hpp>
#include <umbrage/depth/depth32f.hpp>
#include <umbrage/draw/dual_paraboloid_pass.hpp>
#include <umbrage/draw/tessellate.hpp>
#include <umbrage/draw/tetrahedron_pass.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/light/point/dual_paraboloid.hpp>
#include <umbrage/light/point/tetrahedron_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "rays.hpp"

namespace proof {

/// The least angle between a direction and an edge of a triangle, as the world's middle sees them.
[[nodiscard]] inline double angle_to_edge(glm::dvec3 direction, const std::array<glm::dvec3, 3>& corner) {
    const auto angle = [](glm::dvec3 a, glm::dvec3 b) {
        return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    };
    double least = 4;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec3 a = corner[i], b = corner[(i + 1) % 3], across = glm::normalize(glm::cross(a, b));
        const glm::dvec3 nearest = direction - across * glm::dot(across, direction);
        const bool within =
            glm::dot(glm::cross(a, nearest), across) > 0 && glm::dot(glm::cross(nearest, b), across) > 0;
        least = std::min({least, within ? angle(direction, nearest) : 4.0, angle(direction, a), angle(direction, b)});
    }
    return least;
}

/// Triangles around a light in the world's middle.
struct surroundings {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;

    explicit surroundings(std::mt19937& random) {
        const auto real = [&](float low, float high) { return std::uniform_real_distribution(low, high)(random); };
        const auto vector = [&](float low, float high) {
            const float x = real(low, high), y = real(low, high), z = real(low, high);
            return glm::vec3(x, y, z);
        };
        while (triangles.size() < 14) {
            const glm::vec3 way = vector(-1, 1);
            if (glm::length(way) < 0.1f) continue;
            const float distance = real(1, 8);
            std::array<glm::vec3, 3> corner;
            for (glm::vec3& c : corner) c = glm::normalize(way) * distance + vector(-1, 1) * distance;
            const glm::vec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
            // not edge-on: the light is some way before its plane
            if (glm::length(normal) < 1.0f || std::abs(glm::dot(glm::normalize(normal), corner[0])) < 0.3f) continue;
            const auto first = static_cast<unsigned>(positions.size());
            positions.insert(positions.end(), corner.begin(), corner.end());
            triangles.emplace_back(first, first + 1, first + 2);
        }
    }

    [[nodiscard]] std::array<glm::dvec3, 3> corners(std::size_t k) const {
        const glm::uvec3 t = triangles[k];
        return {positions[t.x], positions[t.y], positions[t.z]};
    }
    [[nodiscard]] glm::dvec3 normal(std::size_t k) const {
        const auto [a, b, c] = corners(k);
        return glm::normalize(glm::cross(b - a, c - a));
    }
    /// Distance of a triangle along a direction from the light; NaN if the ray misses it.
    [[nodiscard]] double distance(std::size_t k, glm::dvec3 direction) const {
        const auto corner = corners(k);
        const glm::dvec3 n = normal(k);
        const double along = glm::dot(n, corner[0]) / glm::dot(n, direction);
        bool inside = along > 0;
        for (std::size_t i = 0; i < 3; ++i)
            inside =
                inside && glm::dot(glm::cross(corner[i], corner[(i + 1) % 3]), direction) * glm::dot(n, corner[0]) > 0;
        return inside ? along : std::numeric_limits<double>::quiet_NaN();
    }
    /// The least angle between a direction and an edge of any triangle, as the light sees them.
    [[nodiscard]] double to_edge(glm::dvec3 direction) const {
        double least = 4;
        for (std::size_t k = 0; k < triangles.size(); ++k)
            least = std::min(least, angle_to_edge(direction, corners(k)));
        return least;
    }
};

/// A lookup: a square of the map, where in it, and depths that the map's which kind has.
struct placed_point {
    umbrage::image_view<const float> map;
    glm::vec2 texel;
    float depth;
};

/// Two paraboloid maps, of distances. A margin is in depth and grows with the angle that the filter reaches.
class paraboloid_maps {
public:
    static constexpr const char* name = "dual paraboloid";
    static constexpr int size = 256;
    static constexpr float range = 20, error = 1.0f / 4096;

    paraboloid_maps(const surroundings& scene, int border, umbrage::clip_space clip) : border_(border), clip_(clip) {
        using namespace umbrage;
        const auto light =
            make_dual_paraboloid_light<float>({.range = range, .map_size = size, .border = border, .clip = clip});
        const tessellated_mesh cut =
            tessellate({scene.positions, scene.triangles},
                       {.angle = paraboloid_edge_angle(size, border), .range = range, .depth_error = error});
        for (int map : {0, 1}) {
            maps_[std::size_t(map)] = image<float>(glm::ivec2(size), cleared_depth(clip));
            rasterize_dual_paraboloid(maps_[std::size_t(map)].view(), cut.view(), light, map);
        }
    }

    [[nodiscard]] placed_point place(glm::vec3 p) const {
        const glm::vec3 at = umbrage::dual_paraboloid_coordinate(p);
        const float distance = umbrage::distance_depth(p, 1.0f / range);
        return {maps_[std::size_t(at.z)].view(), glm::vec2(at) * float(size - 2 * border_) + float(border_),
                clip_.direction == umbrage::depth_direction::forward ? distance : umbrage::reverse_depth(distance)};
    }
    /// Radians that a texel takes at most.
    [[nodiscard]] double texel(glm::dvec3 direction) const {
        return (1 + std::abs(glm::normalize(direction).z) + 0.05) * 2 / (size - 2 * border_);
    }
    /// Depth by which a triangle's plane may be stored nearer in the texels that the filter reads around a point.
    /// tessellate leaves errors of 2/3 texel in positions, and of 1/2 texel along edges that it does not cut.
    [[nodiscard]] double margin(glm::dvec3 normal, glm::dvec3 p, double reach) const {
        const double cosine = std::abs(glm::dot(normal, glm::normalize(p)));
        const double tangent = std::sqrt(1 - cosine * cosine) / cosine;
        const double away = std::tan((reach * std::sqrt(2.0) + 7.0 / 6) * texel(p));
        return glm::length(p) / range * tangent * away / std::max(1 - tangent * away, 0.1) + error + 0x1p-22;
    }

private:
    int border_;
    umbrage::clip_space clip_;
    std::array<umbrage::image<float>, 2> maps_;
};

/// A tetrahedron's map, of depths along its faces' normals.
class tetrahedron_map {
public:
    static constexpr const char* name = "tetrahedron";
    static constexpr int size = 512;
    static constexpr float z_near = 0.05f, z_far = 20;

    tetrahedron_map(const surroundings& scene, int border, umbrage::clip_space clip)
        : border_(border),
          clip_(clip),
          faces_(umbrage::make_tetrahedron_light<float>(
              {.z_near = z_near, .z_far = z_far, .map_size = size, .border = border, .clip = clip})),
          map_(glm::ivec2(size), umbrage::cleared_depth(clip)) {
        umbrage::rasterize_tetrahedron(map_.view(), {scene.positions, scene.triangles}, faces_);
    }

    [[nodiscard]] placed_point place(glm::vec3 p) const {
        using namespace umbrage;
        const float z = tetrahedron_view_z(p);
        return {map_.view(), tetrahedron_texel(tetrahedron_coordinate(p), float(size), float(border_)),
                clip_.direction == depth_direction::forward ? depth_from_view_z(z, z_near, z_far)
                                                            : reversed_depth_from_view_z(z, z_near, z_far)};
    }
    [[nodiscard]] double texel(glm::dvec3 direction) const {  // of a face's height, 3 / sqrt(1/2) from the light's side
        const double away = umbrage::tetrahedron_view_z(glm::normalize(direction));
        return 3 * std::sqrt(2.0) * away / (size / 2.0 - 3 * border_);
    }
    [[nodiscard]] double margin(glm::dvec3 normal, glm::dvec3 p, double reach) const {
        const auto face = static_cast<std::size_t>(umbrage::tetrahedron_face(p));
        const auto planes = umbrage::plane_matrix(umbrage::texture_matrix(faces_[face], glm::ivec2(size)));
        const glm::vec2 slope = umbrage::plane_slope(planes, glm::vec3(normal), glm::vec3(p));
        return double(
            umbrage::acne_free_bias(slope, float(reach) + umbrage::rasterizer_snap<float> + 0x1p-10f, 0x1p-22f));
    }

private:
    int border_;
    umbrage::clip_space clip_;
    std::array<umbrage::light_space<float>, 4> faces_;
    umbrage::image<float> map_;
};

/// A filter at random points of triangles, in one kind of map, all from one number.
template <class Maps, class Filter>
[[nodiscard]] verdicts compare_with_rays(std::uint64_t n, Filter filter, int points) {
    using namespace umbrage;
    clip_space clip;
    clip.range = n & 1 ? depth_range::minus_one_to_one : depth_range::zero_to_one;
    clip.direction = n & 2 ? depth_direction::reversed : depth_direction::forward;
    clip.origin = n & 4 ? texture_origin::top : texture_origin::bottom;
    clip.hand = n & 8 ? handedness::left : handedness::right;
    filter.direction = clip.direction;
    std::mt19937 random(static_cast<std::uint32_t>(n));
    const surroundings scene(random);
    const double reach = filter.reach();
    const Maps maps(scene, static_cast<int>(std::ceil(reach + 1)), clip);
    const auto forward = [&](glm::dvec3 p) {
        const double depth = maps.place(glm::vec3(p)).depth;
        return clip.direction == depth_direction::forward ? depth : 1 - depth;
    };
    std::normal_distribution<double> normal;
    verdicts found;
    for (int i = 0; i < points; ++i) {
        const double x = normal(random), y = normal(random), z = normal(random);
        const auto which = std::uniform_int_distribution<std::size_t>(0, scene.triangles.size() - 1)(random);
        const auto [a, b, c] = scene.corners(which);
        const glm::dvec3 weights = glm::dvec3(x * x, y * y, z * z) / (x * x + y * y + z * z);
        const glm::vec3 p(weights.x * a + weights.y * b + weights.z * c);
        const glm::dvec3 direction = glm::normalize(glm::dvec3(p));
        if (scene.to_edge(direction) < (reach + 1.5) * std::sqrt(2.0) * maps.texel(direction)) continue;
        const double margin = maps.margin(scene.normal(which), p, reach);
        bool is_lit = true, is_told = margin < 0.1;
        for (std::size_t k = 0; k < scene.triangles.size(); ++k) {
            const double at = k == which ? std::nan("") : scene.distance(k, direction);
            if (std::isnan(at)) continue;
            const double before = forward(p) - forward(at * direction);
            is_told = is_told && std::abs(before) > margin + maps.margin(scene.normal(k), at * direction, reach);
            is_lit = is_lit && before <= 0;
        }
        if (!is_told) continue;
        const placed_point at = maps.place(p);
        ++(is_lit ? found.lit : found.shadowed);
        found.wrong += filter(clamped(at.map), at.texel, biased(at.depth, float(margin), filter.direction)) !=
                       (is_lit ? 1.0f : 0.0f);
    }
    return found;
}

}  // namespace proof
