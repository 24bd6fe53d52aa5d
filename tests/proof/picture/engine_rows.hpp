// SPDX-License-Identifier: MIT
//
// Engines with directional lights and given settings: where each moves receivers and casters, and its filters. The
// settings come from the npm package's engine_bias, as lines of a file; the formulas here are written from the engines'
// own files, which single_include/npm/engines.mjs names.
#pragma once

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/filter/pcf/windows.hpp>

#include "discs.hpp"

namespace proof::picture {

/// Settings of an engine in one light.
struct engine_row {
    std::string engine, filter, kind;  ///< kind: ours, too_little or defaults
    int map_size = 0;                  ///< texels that cover the width
    double width = 0, range = 0;       ///< of the map, world units
    double radius = 0;                 ///< of the filter, texels; 0 where it has none
    double reach = 0;                  ///< texels
    double first = 0, second = 0;      ///< settings, in the order of the package
    double third = 0, fourth = 0;
    double lacking = 0;  ///< what the package says that they lack, texels
    double edges = 90;   ///< and up to which tilt faces are free of acne beside their edges, degrees

    [[nodiscard]] double texel() const { return width / map_size; }
    [[nodiscard]] bool has_16_bits() const { return engine != "three" && engine != "bevy"; }
};

[[nodiscard]] inline engine_row parse_row(const std::string& line, const std::string& path) {
    std::istringstream fields(line);
    engine_row r;
    std::getline(fields, r.engine, '\t'), std::getline(fields, r.filter, '\t'), std::getline(fields, r.kind, '\t');
    fields >> r.map_size >> r.width >> r.range >> r.radius >> r.reach >> r.first >> r.second >> r.third >> r.fourth >>
        r.lacking >> r.edges;
    if (!fields) throw std::runtime_error(path + " has a line that is none: " + line);
    return r;
}

[[nodiscard]] inline std::vector<engine_row> read_rows(const std::string& path) {
    std::ifstream file(path);
    std::vector<engine_row> rows;
    for (std::string line; std::getline(file, line);) rows.push_back(parse_row(line, path));
    if (rows.empty()) throw std::runtime_error(path + " has no lines");
    return rows;
}

/// A map's axes in the world, of length one: along its rows, along its columns, and to the light.
struct map_axes {
    glm::dvec3 x, y, to_light;
};

/// What Unity's settings are multiplied by, beside the texel.
[[nodiscard]] inline double unity_kernel(const engine_row& r) {
    return r.filter == "Hard" ? 1.0 : r.filter == "Soft Low" ? 1.5 : r.filter == "Soft Medium" ? 2.5 : 3.5;
}

/// Vectors in the world by which an engine moves a receiver, and a triangle that casts.
struct engine_moves {
    glm::dvec3 receiver{0}, caster{0};
};

[[nodiscard]] inline engine_moves moves_of(const engine_row& r, const map_axes& axes, glm::dvec3 normal) {
    const glm::dvec3 light = axes.to_light;
    const double cosine = glm::clamp(glm::dot(normal, light), 0.0, 1.0);
    if (r.engine == "three") return {.receiver = r.first * normal};
    if (r.engine == "godot") {
        const double blur = r.radius > 0 ? r.radius : 1.0;  // its hard filter has a radius of 1
        const glm::dvec3 sideways = normal - light * glm::dot(light, normal);
        return {.receiver = r.first * r.texel() * sideways + r.second / 100 * r.range * blur * light};
    }
    if (r.engine == "bevy") return {.receiver = r.first * std::numbers::sqrt2 * r.texel() * normal + r.second * light};
    if (r.engine == "filament") {
        const double sine = std::sqrt(1 - cosine * cosine), steps = r.fourth * r.range / 65536;
        const double slope = (glm::max)(std::abs(glm::dot(normal, axes.x)), std::abs(glm::dot(normal, axes.y))) /
                             (glm::max)(cosine, 1e-6);
        return {.receiver = r.first * 0.5 * r.texel() * sine * normal,
                .caster = -(r.second + r.third * slope * r.texel() + steps) * light};
    }
    if (r.engine != "unity_urp") throw std::runtime_error("no engine is called " + r.engine);
    const double kernel = unity_kernel(r);
    const double slope = (glm::max)(std::abs(glm::dot(normal, axes.x)), std::abs(glm::dot(normal, axes.y))) /
                         (glm::max)(cosine, 1e-6);  // of depth, by which the rasterizer moves the triangle
    return {.caster = -(r.first * light + r.second * (1 - cosine) * normal) * kernel * r.texel() -
                      2.5 * r.texel() * slope * light};
}

/// Mean of bilinear comparisons at points around a coordinate.
template <class Fetch>
[[nodiscard]] float mean_of(const Fetch& fetch, glm::dvec3 at, const std::vector<glm::dvec2>& points) {
    float sum = 0;
    for (const glm::dvec2& p : points)
        sum += umbrage::filters::pcf_2x2{}(fetch, glm::vec2(glm::dvec2(at) + p), float(at.z));
    return sum / float(points.size());
}

/// Visibility by an engine's filter at a place in texels and depth.
/// @param rotation   of its disc at this pixel, radians
template <class Fetch>
[[nodiscard]] float filtered(const engine_row& r, const Fetch& fetch, glm::dvec3 at, double rotation) {
    using namespace umbrage;
    const auto by = [&](const auto& filter) { return filter(fetch, glm::vec2(at), float(at.z)); };
    const auto disc = [&](int points) { return mean_of(fetch, at, vogel_points(points, r.radius, rotation)); };
    if (r.filter == "BasicShadowMap") return by(filters::hard{});
    if (r.filter == "Hard" || r.filter == "Hardware2x2") return by(filters::pcf_2x2{});
    if (r.filter == "PCFShadowMap") return disc(5);
    if (r.filter == "Soft Very Low") return disc(1);
    if (r.filter == "Temporal") return mean_of(fetch, at, spiral_points(r.radius, rotation));
    if (r.engine == "godot" && r.filter == "Soft Medium") return disc(8);
    if (r.filter == "Soft Ultra") return disc(32);
    if (r.engine == "godot") return disc(r.filter == "Soft Low" ? 4 : 16);
    if (r.filter == "Soft Low") return mean_of(fetch, at, {{-0.5, -0.5}, {0.5, -0.5}, {-0.5, 0.5}, {0.5, 0.5}});
    if (r.filter == "PCF") return by(filters::tent<3>);  // Castano's 3 x 3 in four comparisons
    if (r.filter == "Gaussian" || r.filter == "Soft Medium") return by(filters::castano<5>);
    if (r.filter == "Soft High") return by(filters::castano<7>);
    throw std::runtime_error("no filter is called " + r.filter);
}

/// Depth as the engine's map holds it.
[[nodiscard]] inline float stored_depth(const engine_row& r, double depth) {
    return r.has_16_bits() ? float(std::floor(glm::clamp(depth, 0.0, 1.0) * 65535 + 0.5) / 65535) : float(depth);
}

}  // namespace proof::picture
