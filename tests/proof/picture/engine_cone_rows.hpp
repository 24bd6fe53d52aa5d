// SPDX-License-Identifier: MIT
//
// Engines with spot lights and point lights and given settings: the map of one light, or of one face of its cube, and
// what each engine's shaders do with a receiver in it. The formulas are written from the engines' own files, which
// single_include/npm/engine_cones.mjs names. A map's axis is z here, away from the light.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "discs.hpp"
#include "engine_rows.hpp"

namespace proof::picture {

/// Settings of an engine in one spot light or point light; width is the cone's angle in degrees.
struct cone_row : engine_row {
    std::string light;

    [[nodiscard]] double tangent() const { return std::tan(width * std::numbers::pi / 360); }
    [[nodiscard]] double near_plane() const {
        return engine == "godot" ? 0.025 : engine == "unity_urp" ? 0.2 : engine == "bevy" ? 0.1 : 0.01;
    }
};

/// Lines whose first field is the light, before those of engine_row.
[[nodiscard]] inline std::vector<cone_row> read_cone_rows(const std::string& path) {
    std::ifstream file(path);
    std::vector<cone_row> rows;
    for (std::string line; std::getline(file, line);) {
        const std::size_t tab = line.find('\t');
        if (tab == std::string::npos) throw std::runtime_error(path + " has a line that is none: " + line);
        rows.push_back({parse_row(line.substr(tab + 1), path), line.substr(0, tab)});
    }
    if (rows.empty()) throw std::runtime_error(path + " has no lines");
    return rows;
}

/// A receiver on a plane, seen from the light.
struct lone_plane {
    glm::dvec3 receiver, normal;
};

class cone_map {
public:
    cone_map(const cone_row& row, const glm::dmat3& to_world, glm::dvec3 origin)
        : r_(&row), to_world_(to_world), origin_(origin), near_(row.near_plane()), far_(row.range) {
        const glm::dmat4 view = glm::inverse(glm::dmat4(glm::dvec4(to_world[0], 0), glm::dvec4(to_world[1], 0),
                                                        glm::dvec4(to_world[2], 0), glm::dvec4(origin, 1)));
        const double across = row.map_size / (2 * row.tangent()), middle = row.map_size / 2.0;
        const double scale = near_ * far_ / (far_ - near_), whole = far_ / (far_ - near_);
        // texels, depth in [0, 1] of which 0 is at the near plane, and the depth in the world
        const glm::dmat4 forward(across, 0, 0, 0, 0, across, 0, 0, middle, middle, whole, 1, 0, 0, -scale, 0);
        const glm::dmat4 reversed(across, 0, 0, 0, 0, across, 0, 0, middle, middle, 1 - whole, 1, 0, 0, scale, 0);
        to_map_ = glm::mat4((row.engine == "godot" ? reversed : forward) * view);
    }

    /// Visibility by the engine, of a plane that casts on itself alone.
    /// @param snapped    how far the rasterizer moves vertices, texels
    /// @param rotation   of the filter's disc, radians
    [[nodiscard]] float visibility(const lone_plane& p, glm::dvec2 snapped, double rotation) const {
        if (r_->engine == "bevy" && r_->light == "point") return in_cube_of_bevy(p, snapped, rotation);
        const caster c = caster_of(p);
        const auto fetch = [&](glm::ivec2 texel) { return stored(c, ray_at(glm::dvec2(texel) + 0.5 + snapped)); };
        return filtered(*r_, fetch, place_of(p), rotation);
    }

private:
    /// A plane as the engine draws it: dot(normal, p) = offset, and what the rasterizer adds to its depths.
    struct caster {
        glm::dvec3 normal;
        double offset = 0, depth_bias = 0;
    };

    [[nodiscard]] glm::dvec3 ray_at(glm::dvec2 texel) const {
        return {(texel * 2.0 / double(r_->map_size) - 1.0) * r_->tangent(), 1};
    }
    [[nodiscard]] glm::vec3 world(glm::dvec3 p) const { return glm::vec3(to_world_ * p + origin_); }

    [[nodiscard]] caster caster_of(const lone_plane& p) const {
        const glm::dvec3 light = -glm::normalize(p.receiver);
        glm::dvec3 move(0);
        caster c{p.normal};
        if (r_->engine == "filament") move = glm::dvec3(0, 0, r_->second);
        if (r_->engine == "unity_urp") {  // a texel is that of half the range
            const double texel = r_->tangent() * far_ / r_->map_size, kernel = unity_kernel(*r_);
            const double tilt = 1 - glm::clamp(glm::dot(light, p.normal), 0.0, 1.0);
            move = -(r_->first * light + r_->second * tilt * p.normal) * kernel * texel;
        }
        c.offset = glm::dot(p.normal, p.receiver + move);
        const double slopes = r_->engine == "unity_urp" ? 2.5 : r_->engine == "filament" ? r_->third : 0.0;
        if (slopes > 0)  // depth is whole - scale / z, and 1 / z is linear in texels
            c.depth_bias = slopes * (glm::max)(std::abs(p.normal.x), std::abs(p.normal.y)) * 2 * r_->tangent() /
                           r_->map_size / std::abs(c.offset) * near_ * far_ / (far_ - near_);
        if (r_->engine == "filament") c.depth_bias += r_->fourth / 65536;
        return c;
    }

    /// Depth in the map along a ray of length 1 along the axis.
    [[nodiscard]] float stored(const caster& c, glm::dvec3 ray) const {
        const double over = glm::dot(c.normal, ray) / c.offset;  // 1 / depth; the plane ends where that is 0
        if (r_->engine == "bevy") return over > 0 ? -float(near_ * over) : 0.0f;  // reversed, as a negative number
        if (!(over > 1 / far_)) return 1;
        return stored_depth(*r_, far_ / (far_ - near_) * (1 - near_ * over) + c.depth_bias);
    }

    /// Where the engine looks a receiver up: texels and depth, as its shader has them.
    [[nodiscard]] glm::dvec3 place_of(const lone_plane& p) const {
        const glm::vec3 position = world(p.receiver), normal(to_world_ * p.normal),
                        to_light = glm::vec3(origin_) - position;
        const float distance = glm::length(to_light), cosine = glm::dot(normal, to_light) / distance;
        const float depth = glm::dot(glm::vec3(to_world_[2]), -to_light), first = float(r_->first);
        const float texel = float(2 * r_->tangent() / r_->map_size);
        if (r_->engine == "bevy") {
            const glm::vec3 from_light = -to_light + float(r_->second) * to_light / distance +
                                         normal * (first * texel * std::sqrt(2.0f) * depth);
            const glm::vec3 at = from_light * glm::mat3(to_world_);
            const glm::dvec2 texels = (glm::dvec2(at) / double(at.z) / r_->tangent() + 1.0) * (r_->map_size / 2.0);
            return {texels, -float(near_) / at.z};
        }
        glm::vec3 moved = position;
        if (r_->engine == "godot")
            moved += normal * (distance * first * 10.0f / float(r_->map_size) * (1 - std::abs(cosine)));
        if (r_->engine == "filament") moved += normal * (std::sqrt(1 - cosine * cosine) * first * 0.5f * texel * depth);
        glm::vec4 at = to_map_ * glm::vec4(moved, 1.0f);
        if (r_->engine != "godot") return glm::dvec3(at) / double(at.w);
        at.z += float(r_->second / 100 * (r_->radius > 0 ? r_->radius : 1.0));
        return {glm::dvec2(at) / double(at.w), 1 - double(at.z) / double(at.w)};
    }

    /// Bevy's comparisons around a direction, each on the face of the cube that holds it, all with one depth.
    [[nodiscard]] float in_cube_of_bevy(const lone_plane& p, glm::dvec2 snapped, double rotation) const {
        const caster c = caster_of(p);
        const double distance = major(p.receiver), texel = 2.0 / r_->map_size;
        const glm::dvec3 at = p.receiver + p.normal * (r_->first * texel * std::numbers::sqrt2 * distance) -
                              r_->second * glm::normalize(p.receiver);
        const glm::dvec3 z = glm::normalize(at), x = glm::normalize(glm::cross(z, glm::dvec3(0.3, 0.5, 0.8)));
        const glm::dvec3 y = glm::cross(z, x);
        float sum = 0;
        const std::vector<glm::dvec2> points = cube_points(rotation);
        for (const glm::dvec2& point : points) {
            const glm::dvec3 way = at + (point.x * x + point.y * y) * 0.003 * distance;
            int face = 0;  // the axis along which it is longest
            for (int i = 1; i < 3; ++i)
                if (std::abs(way[i]) > std::abs(way[face])) face = i;
            const int across = (face + 1) % 3, up = (face + 2) % 3;
            const double side = way[face] < 0 ? -1 : 1;
            const auto fetch = [&](glm::ivec2 index) {
                const glm::dvec2 on_face = (glm::dvec2(index) + 0.5 + snapped) * texel - 1.0;
                glm::dvec3 ray(0);
                ray[face] = side, ray[across] = on_face.x, ray[up] = on_face.y;
                return stored(c, ray);
            };
            const glm::dvec2 place = (glm::dvec2(way[across], way[up]) / std::abs(way[face]) + 1.0) / texel;
            sum += umbrage::filters::pcf_2x2{}(fetch, glm::vec2(place), -float(near_) / float(major(at)));
        }
        return sum / float(points.size());
    }
    [[nodiscard]] static double major(glm::dvec3 p) {
        return glm::max(std::abs(p.x), glm::max(std::abs(p.y), std::abs(p.z)));
    }

    [[nodiscard]] std::vector<glm::dvec2> cube_points(double rotation) const {
        if (r_->filter == "Hardware2x2") return {{0, 0}};
        if (r_->filter == "Temporal") return spiral_points(0.5, rotation);
        return {{0.125, -0.375}, {-0.125, 0.375},  {0.625, 0.125}, {-0.375, -0.625},
                {-0.625, 0.625}, {-0.875, -0.125}, {0.375, 0.875}, {0.875, -0.875}};  // of 8 samples in Direct3D
    }

    const cone_row* r_;
    glm::dmat3 to_world_;
    glm::dvec3 origin_;
    double near_, far_;
    glm::mat4 to_map_{};
};

}  // namespace proof::picture
