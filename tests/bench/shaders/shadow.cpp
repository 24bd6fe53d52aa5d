// SPDX-License-Identifier: MIT
//
// A shadow as one function, as bind() prints it, against its parts called by hand.
#include "jobs.hpp"

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/constant.hpp>
#include <umbrage/bias/slope.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/light/point/cube_map.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/cube_maps.hpp>
#include <umbrage/shadow/in_shader.hpp>
#include <umbrage/shadow/single_map.hpp>

namespace bench {

namespace glsl = umbrage::glsl;

namespace {

/// x0 is the point of the world, x2 its normal.
constexpr auto result = "vec4(umbrage_sun(x0.xyz, x2.xyz))", by_hand = "vec4(by_hand(x0.xyz, x2.xyz))";

/// A function of one's own, behind the snippets that it calls.
glsl::snippet own(const char* text) { return {.name = "by_hand", .role = glsl::hook::chosen, .source = text}; }

}  // namespace

std::vector<job> shadows() {
    const umbrage::clip_space clip = umbrage::vulkan_clip_space;
    const umbrage::shadow spot(
        umbrage::make_spot_light<float>(
            {.position = {1, 9, 2}, .direction = {0, -1, 0}, .z_near = 1, .z_far = 20, .clip = clip}),
        {1024, 1024}, umbrage::filters::tent<3>);
    const umbrage::shadow lamp(
        umbrage::point_light<float>{.z_near = 0.1f, .z_far = 20, .map_size = 512, .border = 4, .clip = clip},
        {512, 512}, umbrage::filters::pcf_2x2{});
    const glsl::shadow_slots slots{.block = 7, .texture = 0};
    const auto of_map = [](const glsl::snippet& s, glsl::texture kind, umbrage::outside_map outside) {
        return bind(s, "own", {.texture = kind, .outside = outside});
    };
    return {
        {"a spot light's shadow, 3x3",
         {{"umbrage", "bind()", "", {glsl::bind(spot, "sun", slots)}, result},
          {"umbrage",
           "its parts by hand",
           "layout(binding = 7) uniform lights { mat4 to_texels, planes; vec4 terms; };\n"
           "layout(binding = 0) uniform sampler2D sun;\n",
           {glsl::shadow_coordinate, glsl::project_coordinate, glsl::receiver_slope, glsl::acne_free_bias, glsl::biased,
            of_map(glsl::tent<3>, glsl::texture::texture_2d, umbrage::outside_map::bordered), own(R"GLSL(
float by_hand(vec3 world, vec3 normal) {
    vec3 at = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world));
    float bias = umbrage_acne_free_bias(umbrage_receiver_slope(planes, normal, world), terms.z, terms.w);
    return umbrage_tent3_own(sun, terms.xy, at.xy, umbrage_biased(at.z, bias));
}
)GLSL")},
           by_hand}}},
        {"a point light's shadow, 2x2",
         {{"umbrage", "bind()", "", {glsl::bind(lamp, "sun", slots)}, result},
          {"umbrage",
           "its parts by hand",
           "layout(binding = 7) uniform lights { vec4 position; mat4 to_texels, planes; vec4 terms; };\n"
           "layout(binding = 0) uniform sampler2D sun;\n",
           {glsl::cube_face, glsl::cube_face_point, glsl::cube_tile, glsl::shadow_coordinate, glsl::project_coordinate,
            glsl::receiver_slope, glsl::acne_free_bias, glsl::biased,
            of_map(glsl::pcf_2x2, glsl::texture::atlas, umbrage::outside_map::clamped), own(R"GLSL(
float by_hand(vec3 world, vec3 normal) {
    precise vec3 way = world - position.xyz;
    float face = umbrage_cube_face(way);
    vec3 there = umbrage_cube_face_point(face, way), across = umbrage_cube_face_point(face, normal);
    vec3 at = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, there));
    float bias = umbrage_acne_free_bias(umbrage_receiver_slope(planes, across, there), terms.z, terms.w);
    vec2 tile = umbrage_cube_tile(face, terms.x);
    return umbrage_pcf_2x2_own(sun, tile, terms.xy, at.xy, umbrage_biased(at.z, bias));
}
)GLSL")},
           by_hand}}},
    };
}

}  // namespace bench
