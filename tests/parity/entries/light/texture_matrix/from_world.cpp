// SPDX-License-Identifier: MIT
//
// Shaders from a world position to its visibility, in the scenes that the proof casts rays in.
#include "../../../end_to_end/from_world.hpp"

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/filter/pcf/windows.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "../../entries.hpp"

namespace parity {
namespace {

namespace glsl = umbrage::glsl;

constexpr snippet without_division{
    .name = "without_division", .exactness = tier::b, .needs = glsl::list<&glsl::shadow_coordinate>, .source = R"GLSL(
UMBRAGE_HIGHP vec3 umbrage_without_division(UMBRAGE_HIGHP mat4 m, UMBRAGE_HIGHP vec3 world) {
    UMBRAGE_HIGHP vec4 c = umbrage_shadow_coordinate(m, world);
    return vec3(c.x, c.y, c.z);
}
)GLSL"};

/// Returns visibility, and the coordinate and receiver that it follows from.
template <const snippet& Filter>
std::string receive_text() {
    return glsl::detail::filled(R"GLSL(
UMBRAGE_HIGHP vec4 umbrage_receive_$f(UMBRAGE_MAP map, UMBRAGE_HIGHP vec2 size, UMBRAGE_HIGHP vec3 at,
                                      UMBRAGE_HIGHP vec2 slope, UMBRAGE_HIGHP float reach, UMBRAGE_HIGHP float error) {
    UMBRAGE_HIGHP float receiver = umbrage_biased(at.z, umbrage_acne_free_bias(slope, reach, error));
    return vec4(umbrage_$f(map, size, vec2(at.x, at.y), receiver), at.x, at.y, receiver);
}
)GLSL",
                                {{'f', 0, Filter.name}});
}
template <const snippet& Filter>
constexpr glsl::detail::short_name receive_name{"receive_$f", {{'f', 0, Filter.name}}};
template <const snippet& Filter>
constexpr snippet receive{.name = receive_name<Filter>.view(),
                          .exactness = tier::b,
                          .needs = glsl::list<&glsl::biased, &glsl::acne_free_bias, &Filter>,
                          .source = receive_text<Filter>};

/// The way to a coordinate, which each kind of light has of its own, in GLSL and in C++.
struct first_part {
    const snippet* primitive;
    const snippet* before;
    std::string coordinate, slope, error;
    vec3 (*in_cpp)(const sample& s);
};

vec4 shadow_coordinate_of(const sample& s) {
    return umbrage::shadow_coordinate(glm::mat4(s.x[1], s.x[2], s.x[3], s.x[4]), vec3(s.x[0]));
}
vec3 cascade_coordinate_of(const sample& s) {
    const auto column = [&](std::size_t k) { return vec4(vec3(s.x[k]), 0.0f); };
    const glm::mat4 rotation(column(1), column(2), column(3), vec4(0, 0, 0, 1));
    return umbrage::cascade_coordinate(vec3(umbrage::shadow_coordinate(rotation, vec3(s.x[0]))), s.x[4], s.x[5]);
}

const first_part& first_part_of(ray_kind kind) {
    static const std::string world = "vec3(x0.x, x0.y, x0.z)", matrix = "mat4(x1, x2, x3, x4), " + world;
    static const std::string rotation =
        "mat4(vec4(x1.x, x1.y, x1.z, 0.0), vec4(x2.x, x2.y, x2.z, 0.0), vec4(x3.x, x3.y, x3.z, 0.0), "
        "vec4(0.0, 0.0, 0.0, 1.0)), " +
        world;
    static const std::array<first_part, 3> parts{
        {{&glsl::project_coordinate, &glsl::shadow_coordinate,
          "umbrage_project_coordinate(umbrage_shadow_coordinate(" + matrix + "))", "vec2(x5.x, x5.y)", "x5.z",
          [](const sample& s) { return umbrage::project_coordinate(shadow_coordinate_of(s)); }},
         {&glsl::shadow_coordinate, &without_division, "umbrage_without_division(" + matrix + ")", "vec2(x5.x, x5.y)",
          "x5.z", [](const sample& s) { return vec3(shadow_coordinate_of(s)); }},
         {&glsl::cascade_coordinate, &without_division,
          "umbrage_cascade_coordinate(umbrage_without_division(" + rotation + "), x4, x5)", "vec2(x1.w, x2.w)", "x3.w",
          cascade_coordinate_of}}};
    return parts[static_cast<std::size_t>(kind)];
}

vec2 slope_of(ray_kind kind, const sample& s) {
    return kind == ray_kind::cascade ? vec2(s.x[1].w, s.x[2].w) : vec2(s.x[5]);
}
float error_of(ray_kind kind, const sample& s) { return kind == ray_kind::cascade ? s.x[3].w : s.x[5].z; }

/// The lights whose maps the entries have; a map's second channel holds its number.
const std::vector<ray_light>& lights_of(ray_kind kind) {
    static const std::array all{ray_lights(ray_kind::spot, 2), ray_lights(ray_kind::directional, 2),
                                ray_lights(ray_kind::cascade, 2)};
    return all[static_cast<std::size_t>(kind)];
}
std::vector<texels> maps_of(ray_kind kind) {
    std::vector<texels> all;
    for (const ray_light& light : lights_of(kind)) {
        texels map = light.map();
        for (vec4& t : map.texels()) t.y = static_cast<float>(all.size());
        all.push_back(std::move(map));
    }
    return all;
}

template <const snippet& Filter>
void add_from_world(std::vector<entry>& all, ray_kind kind, auto filter) {
    const first_part& part = first_part_of(kind);
    const auto fill = [kind, reach = filter.reach()](auto, random& r, sample& s) {
        const ray_light& light = lights_of(kind)[static_cast<std::size_t>(s.map.data[0].y)];
        light.fill(light.draw(r), reach, s);
    };
    all.push_back({.primitive = part.primitive,
                   .variant = from_world(kind, Filter.name),
                   .classes = {{"points of triangles", fill}},
                   .twin =
                       [kind, filter, in_cpp = part.in_cpp](const sample& s) {
                           const vec3 at = in_cpp(s);
                           const float bias = umbrage::acne_free_bias(slope_of(kind, s), s.x[0].w, error_of(kind, s));
                           const float receiver = umbrage::biased(at.z, bias, filter.direction);
                           return vec4(filter(s.depth(), vec2(at), receiver), at.x, at.y, receiver);
                       },
                   .call = "umbrage_receive_" + std::string(Filter.name) + "(map, map_size, " + part.coordinate + ", " +
                           part.slope + ", x0.w, " + part.error + ")",
                   .maps = maps_of(kind),
                   .also = {part.before, &receive<Filter>},
                   .share = 16,
                   .alike = true});
}

}  // namespace

void add_light_texture_matrix_from_world(std::vector<entry>& all) {
    for (const ray_kind kind : ray_kinds) {
        add_from_world<glsl::hard>(all, kind, umbrage::filters::hard{});
        add_from_world<glsl::pcf_2x2>(all, kind, umbrage::filters::pcf_2x2{});
        add_from_world<glsl::binomial<5>>(all, kind, umbrage::filters::binomial<5>);
    }
}

}  // namespace parity
