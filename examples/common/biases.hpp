// SPDX-License-Identifier: MIT
//
// The library's biases as values, which know what they are called, what they do to a receiver and how a shader says it.
//
//     example::with_bias("acne_free", [&](const auto& bias) { example::receiver_bias by = bias(light, point); });
//
#pragma once

#include <string_view>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/kernel.hpp>
#include <umbrage/bias/light_units.hpp>
#include <umbrage/bias/normal_offset.hpp>
#include <umbrage/bias/receiver_plane.hpp>
#include <umbrage/bias/slope.hpp>
#include <umbrage/core/list.hpp>
#include <umbrage/light/light_space.hpp>
#include <umbrage/light/texture_matrix.hpp>

namespace example {

/// Texels that a bias has to cover, under a filter of that reach over a rasterizer's map.
[[nodiscard]] constexpr float covered(float reach) { return reach + umbrage::rasterizer_snap<float>; }

/// A light, its map and the filter over it, as biases see them.
struct bias_light {
    glm::vec3 direction;  ///< direction of the light or of a spot's axis, length 1
    glm::vec2 units;      ///< umbrage::make_light_units
    glm::mat4 planes;     ///< umbrage::plane_matrix
    float reach;          ///< reach of the filter that the bias covers, texels; 0: no bias
    float constant;       ///< depth that a plane at 45 degrees to the light asks for, in the scene's middle
};

/// A point of a surface that the light sees.
struct bias_point {
    glm::vec3 world, normal;  ///< position, and normal of the flat triangle with length 1
    glm::vec3 way;            ///< from the light over w; of a directional light its direction
    float w;                  ///< w of its shadow coordinate
};

/// Bias of a receiver's comparison.
struct receiver_bias {
    glm::vec3 offset{0};  ///< offset of the point that is looked up, world units
    float depth = 0;      ///< to take off its z/w
    glm::vec2 slope{0};   ///< slope of z/w per texel, along which stored depths move to the receiver
};

[[nodiscard]] inline bias_light make_bias_light(const umbrage::light_space<float>& space, glm::vec3 direction,
                                                glm::ivec2 map_size, float reach, float middle_w) {
    const glm::vec2 units = umbrage::make_light_units(space, map_size);
    const float width = umbrage::offset_width(reach, umbrage::texels_to_world(1.0f, units, middle_w));
    return {direction, units, umbrage::plane_matrix(umbrage::texture_matrix(space, map_size)), reach,
            umbrage::world_to_depth(width, units, middle_w)};
}

[[nodiscard]] inline float kernel_width(const bias_light& l, float w) {
    return umbrage::offset_width(l.reach, umbrage::texels_to_world(1.0f, l.units, w));
}

/// In the shaders' statements: inputs light_direction, units, plane_matrix, reach, constant, width (of the kernel),
/// world, face, way, w; results offset, by, plane as receiver_bias has them.
namespace biases {

namespace glsl = umbrage::glsl;

struct normal_offset {
    static constexpr std::string_view name = "normal_offset",
                                      about =
                                          "Looked up off the surface, by what its tilt asks for: nothing where "
                                          "light falls straight on it.",
                                      statement =
                                          "offset = umbrage_normal_offset(face, light_direction, way, width, 0.0);";
    static std::vector<glsl::snippet> snippets() { return {glsl::texels_to_world, glsl::normal_offset}; }
    [[nodiscard]] receiver_bias operator()(const bias_light& l, const bias_point& p) const {
        return {.offset = umbrage::normal_offset(p.normal, l.direction, p.way, kernel_width(l, p.w), 0.0f)};
    }
};

struct acne_free {
    static constexpr std::string_view name = "acne_free",
                                      about =
                                          "The smallest: by the slope of each surface, the filter's reach and the "
                                          "map's error no plane shadows itself, and none is biased by more.",
                                      statement =
                                          "by = umbrage_acne_free_bias(umbrage_plane_slope(plane_matrix, face, "
                                          "world), reach, 0.0);";
    static std::vector<glsl::snippet> snippets() { return {glsl::plane_slope, glsl::acne_free_bias, glsl::biased}; }
    [[nodiscard]] receiver_bias operator()(const bias_light& l, const bias_point& p) const {
        return {.depth = umbrage::acne_free_bias(umbrage::plane_slope(l.planes, p.normal, p.world), l.reach, 0.0f)};
    }
};

struct constant {
    static constexpr std::string_view name = "constant",
                                      about =
                                          "The same for all, as a plane at 45 degrees to the light asks for: acne "
                                          "on what is steeper, detachment on what is not.",
                                      statement = "by = constant;";
    static std::vector<glsl::snippet> snippets() { return {glsl::biased}; }
    [[nodiscard]] receiver_bias operator()(const bias_light& l, const bias_point&) const {
        return {.depth = l.constant};
    }
};

struct slope {
    static constexpr std::string_view name = "slope",
                                      about =
                                          "By the greater slope, as rasterizers scale it: up to twice the "
                                          "smallest.",
                                      statement =
                                          "by = umbrage_slope_bias(umbrage_plane_slope(plane_matrix, face, "
                                          "world), 2.0 * reach, 0.0);";
    static std::vector<glsl::snippet> snippets() { return {glsl::plane_slope, glsl::slope_bias, glsl::biased}; }
    [[nodiscard]] receiver_bias operator()(const bias_light& l, const bias_point& p) const {
        return {.depth = umbrage::slope_bias(umbrage::plane_slope(l.planes, p.normal, p.world), 2 * l.reach, 0.0f)};
    }
};

struct kernel {
    static constexpr float greatest = 20;  // the tangent of 87 degrees
    static constexpr std::string_view name = "kernel",
                                      about =
                                          "By the kernel's width and the angle of the light, from the normal "
                                          "alone.",
                                      statement =
                                          "by = umbrage_world_to_depth(umbrage_kernel_bias(face, "
                                          "light_direction, way, width, 20.0), units, w);";
    static std::vector<glsl::snippet> snippets() {
        return {glsl::texels_to_world, glsl::kernel_bias, glsl::world_to_depth, glsl::biased};
    }
    [[nodiscard]] receiver_bias operator()(const bias_light& l, const bias_point& p) const {
        const float along = umbrage::kernel_bias(p.normal, l.direction, p.way, kernel_width(l, p.w), greatest);
        return {.depth = umbrage::world_to_depth(along, l.units, p.w)};
    }
};

struct receiver_plane {
    static constexpr std::string_view name = "receiver_plane",
                                      about =
                                          "Each texel is compared with the receiver's own plane at the texel's "
                                          "center, so that no reach needs a bias; half a texel's for what bends.",
                                      statement =
                                          "plane = umbrage_plane_slope(plane_matrix, face, world); "
                                          "by = umbrage_acne_free_bias(plane, min(reach, 0.5), 0.0);";
    static std::vector<glsl::snippet> snippets() {
        return {glsl::plane_slope, glsl::acne_free_bias, glsl::apply_receiver_plane, glsl::biased};
    }
    static constexpr bool compares_along_plane = true;
    [[nodiscard]] receiver_bias operator()(const bias_light& l, const bias_point& p) const {
        const glm::vec2 plane = umbrage::plane_slope(l.planes, p.normal, p.world);
        return {.depth = umbrage::acne_free_bias(plane, l.reach < 0.5f ? l.reach : 0.5f, 0.0f), .slope = plane};
    }
};

using all = umbrage::list_of<normal_offset, acne_free, constant, slope, kernel, receiver_plane>;

}  // namespace biases

/// Calls use(bias) with the one of that name.
/// @return   false where none is called so
template <class Use>
bool with_bias(std::string_view name, Use&& use) {
    return biases::all::with(name, use);
}

}  // namespace example
