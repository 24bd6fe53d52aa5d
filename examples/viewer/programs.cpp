// SPDX-License-Identifier: MIT
#include "programs.hpp"

#include <initializer_list>
#include <string_view>
#include <vector>

#include <umbrage/bias/constant.hpp>
#include <umbrage/bias/light_units.hpp>
#include <umbrage/bias/normal_offset.hpp>
#include <umbrage/compare.hpp>
#include <umbrage/depth/kinds.hpp>
#include <umbrage/depth/foreign/ps14.hpp>
#include <umbrage/depth/rg_table.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shade/lighting.hpp>

#include "stored_as.hpp"

namespace viewer {
namespace {

using example::shadow_system;
using glsl::version;
using snippets = std::vector<glsl::snippet>;

/// All of them, for a shader's one map.
std::vector<glsl::bound> joined(std::initializer_list<snippets> lists, const glsl::binding& map = {}) {
    std::vector<glsl::bound> all;
    for (const snippets& list : lists)
        for (const glsl::snippet& s : list) all.push_back(bind(s, "", map));
    return all;
}

// One text for GLSL 100 and 330: written in the words of 100.
std::string vertex(version v, const snippets& uses, std::string_view rest) {
    return glsl::source(v, uses, v == version::v100 ? "" : "#define attribute in\n#define varying out\n").append(rest);
}
std::string fragment(version v, const std::vector<glsl::bound>& uses, std::string_view rest) {
    const std::string words =
        v == version::v100
            ? "precision highp float;\nprecision highp sampler2D;\n#define fragment_colour gl_FragColor\n"
            : "#define varying in\nout vec4 fragment_colour;\n";
    return glsl::source(v, uses, words).append(rest);
}

/// How a system writes the map, an expression of `depth`, and reads it: as its encoding does, or through the look-up
/// texture of 2048 x 1 texels and pixel shader 1.4's r / 8 + g.
struct storage {
    snippets writers;
    std::string write;
    glsl::binding map;
};
storage storage_of(const shadow_system& s) {
    if (s.receiver != example::receiver_kind::plain)
        return {{glsl::encode_rg_table<11>, glsl::to_unorm},
                "vec4(umbrage_to_unorm(umbrage_encode_rg11_table(table, depth)), 0.0, 0.0)",
                {.depth = "umbrage_decode_ps14(value.xy)", .channels = 2, .needs = {glsl::decode_ps14}}};
    const stored_as e = encoding_called(s.encoding);
    return {e.writers(), e.write("depth"), e.map};
}

/// map_depth(z): the system's kind of depth from z/w in [0, 1]; planes are z_near, z_far, 1 / z_far.
const snippets depth_snippets{glsl::linear_depth, glsl::view_z_from_depth, glsl::view_z_from_orthographic_depth};
std::string map_depth(const shadow_system& s) {
    std::string depth = "umbrage_linear_depth(umbrage_view_z_from_orthographic_depth(z, planes.x, planes.y), planes.z)";
    if (s.light == example::light_kind::spot)
        depth = "umbrage_linear_depth(umbrage_view_z_from_depth(z, planes.x, planes.y), planes.z)";
    if (s.depth == example::depth_kind::projected) depth = "z";
    return "uniform vec3 planes;\nfloat map_depth(float z) { return " + depth + "; }\n";
}

struct filter {
    snippets uses;
    std::string visibility;  ///< expression of p, depth, biased, receiver and bias
};
filter filter_of(const shadow_system& s) {
    if (s.test == example::test_kind::exercise && s.filter == "hard" && s.receiver == example::receiver_kind::plain)
        return {{glsl::compare_exercise, glsl::fetch_depth},
                "umbrage_compare_exercise(depth, umbrage_fetch_depth(map, map_size, floor(p.xy)), bias)"};
    const glsl::snippet* snippet = nullptr;
    std::string arguments = "p.xy, receiver";
    snippets uses;
    umbrage::with_filter(s.filter, [&](const auto& of) {
        snippet = of.snippet;
        if constexpr (requires { of.radius_texels; }) {
            arguments += ", " + std::to_string(of.radius_texels) + ", umbrage_disc_turn(gl_FragCoord.xy)";
            uses.push_back(glsl::disc_turn);
        }
    });
    uses.push_back(*snippet);
    if (snippet == &glsl::four_tap) arguments = "tap(0), tap(1), tap(2), tap(3), receiver";
    if (snippet == &glsl::box) arguments += ", 1";
    if (snippet == &glsl::pcf_2x2_dx_sdk) arguments = "p.xy, depth, bias";
    return {uses, "umbrage_" + std::string(snippet->name) + "(map, map_size, " + arguments + ")"};
}

/// The side that is compared with the map, an expression of `depth`, biased.
std::string receiver_of(const shadow_system& s) {
    switch (s.receiver) {
        case example::receiver_kind::plain: break;
        case example::receiver_kind::scaled: return "umbrage_receiver_ps14(biased)";
        case example::receiver_kind::encoded:
            return "umbrage_decode_ps14(umbrage_encode_rg11_table(table, biased) / 255.0)";
    }
    return "biased";
}

/// A triangle over the target, or a rectangle of it.
constexpr std::string_view rectangle_vertex = R"GLSL(
attribute vec2 corner;  // 0 to 1, from the top left
uniform vec4 place;     // left, top, width, height in NDC
varying vec2 at;
void main() {
    at = corner;
    gl_Position = vec4(place.x + corner.x * place.z, place.y - corner.y * place.w, 0.0, 1.0);
}
)GLSL";

/// depth_here(): the map's depth at a corner's place, nearest texel.
std::string overlay_head(const shadow_system& s, version v, const snippets& more) {
    const glsl::binding map = encoding_called(s.encoding).map;  // whatever way the system itself reads it
    return fragment(v, joined({{glsl::fetch_depth, glsl::saturate}, more}, map), R"GLSL(
uniform sampler2D map;
uniform vec2 map_size;
varying vec2 at;
float depth_here() { return umbrage_fetch_depth(map, map_size, floor(vec2(at.x, 1.0 - at.y) * map_size)); }
)GLSL");
}

}  // namespace

stages depth_stages(const shadow_system& s, version v) {
    const storage how = storage_of(s);
    return {vertex(v, {glsl::shadow_coordinate}, R"GLSL(
attribute vec3 position;
uniform mat4 light_to_clip, world_to_texels;
varying vec4 coordinate;
void main() {
    coordinate = umbrage_shadow_coordinate(world_to_texels, position);
    gl_Position = light_to_clip * vec4(position, 1.0);
}
)GLSL"),
            fragment(v, joined({how.writers, depth_snippets, {glsl::project_coordinate}}),
                     "uniform sampler2D table;\nvarying vec4 coordinate;\n" + map_depth(s) + R"GLSL(
void main() {
    float depth = map_depth(umbrage_project_coordinate(coordinate).z);
    fragment_colour = )GLSL" +
                         how.write + ";\n}\n")};
}

stages camera_stages(const shadow_system& s, version v, bool mask) {
    const storage how = storage_of(s);
    const filter filter = filter_of(s);
    const std::string lit = s.shading == example::shading_kind::diffuse_ambient
                                ? "umbrage_diffuse_ambient(albedo, ambient, n_dot_l, visibility)"
                                : "umbrage_diffuse_ambient(albedo, ambient, n_dot_l, 1.0) * "
                                  "(ambient + (1.0 - ambient) * clamp(4.0 * n_dot_l, 0.0, 1.0) * visibility)";

    stages out;
    out.vertex = vertex(v, {}, R"GLSL(
attribute vec3 position, normal, face_normal;
attribute vec4 colour;
uniform mat4 world_to_clip;
varying vec3 world, world_normal, world_face;
varying vec4 surface_colour;
void main() {
    world = position;
    world_normal = normal;
    world_face = face_normal;
    surface_colour = colour;
    gl_Position = world_to_clip * vec4(position, 1.0);
}
)GLSL");
    out.fragment = fragment(v,
                            joined({how.writers,
                                    filter.uses,
                                    depth_snippets,
                                    {glsl::receiver_ps14, glsl::shadow_coordinate, glsl::project_coordinate,
                                     glsl::texels_to_world, glsl::normal_offset, glsl::biased, glsl::spot_cone,
                                     glsl::diffuse_ambient}},
                                   how.map),
                            R"GLSL(
varying vec3 world, world_normal, world_face;
varying vec4 surface_colour;  // alpha: 1 on the floor
uniform vec3 eye, light_direction;
uniform vec4 light_position;  // w: 1 for a spot, 0 for a directional light
uniform float cos_outer, lift, bias, ambient;
uniform mat4 world_to_texels, taps[4];
uniform sampler2D map, table;
uniform vec2 map_size, units;
)GLSL" + map_depth(s) + R"GLSL(
vec3 unit(vec3 a, vec3 otherwise) { return length(a) > 0.0 ? a / length(a) : otherwise; }
vec3 towards(vec3 a, vec3 side) { return dot(a, side) < 0.0 ? -a : a; }

// Off the surface by so many texels that it cannot shadow itself.
vec3 lifted(vec3 point, vec3 normal) {
    float w = umbrage_shadow_coordinate(world_to_texels, point).w;
    vec3 way = light_position.w > 0.0 ? (point - light_position.xyz) / w : light_direction;
    float width = umbrage_texels_to_world(lift, units, w);
    return point + umbrage_normal_offset(normal, light_direction, way, width, 0.0);
}

vec3 floor_colour(vec3 point) {
    vec2 cell = floor(point.xz * 2.0), inside = point.xz * 2.0 - cell;
    vec2 joint = min(inside, 1.0 - inside);
    return vec3(min(joint.x, joint.y) < 0.02 ? 0.30 : mod(cell.x + cell.y, 2.0) != 0.0 ? 0.52 : 0.64);
}

float solid_texture(vec3 point) {
    vec3 cell = floor(point * 4.0 + 0.37);
    return mod(abs(cell.x + cell.y + cell.z), 2.0) == 0.0 ? 1.0 : 0.6;
}

float srgb(float v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1.0 / 2.4) - 0.055; }

vec3 looked_up;
vec2 tap(int i) { return umbrage_project_coordinate(umbrage_shadow_coordinate(taps[i], looked_up)).xy; }

void main() {
    vec3 face = towards(unit(world_face, vec3(0.0, 1.0, 0.0)), eye - world);
    vec3 normal = towards(unit(world_normal, face), face);

    // Light, and where in its map the surface lies.
    looked_up = lifted(world, face);
    vec3 p = umbrage_project_coordinate(umbrage_shadow_coordinate(world_to_texels, looked_up));
    float depth = map_depth(p.z);

    // Fetch, decode, compare, filter.
    float biased = umbrage_biased(depth, bias);
    float receiver = )GLSL" + receiver_of(s) +
                                R"GLSL(;
    float visibility = )GLSL" + filter.visibility +
                                R"GLSL(;
    if (light_position.w > 0.0)
        visibility *= umbrage_spot_cone(light_direction, world - light_position.xyz, cos_outer);
)GLSL");
    if (mask) {
        out.fragment += "    fragment_colour = vec4(vec3(visibility), 1.0);\n}\n";
        return out;
    }
    out.fragment += R"GLSL(
    // Shade.
    vec3 albedo = surface_colour.a > 0.5 ? floor_colour(world) : surface_colour.rgb;
)GLSL" + std::string(s.textured ? "    albedo *= solid_texture(world);\n" : "") +
                    R"GLSL(
    vec3 to_light = light_position.w > 0.0 ? normalize(light_position.xyz - world) : -light_direction;
    float n_dot_l = dot(normal, to_light);
    vec3 seen = )GLSL" +
                    lit + R"GLSL(;
    fragment_colour = vec4(srgb(seen.r), srgb(seen.g), srgb(seen.b), 1.0);
}
)GLSL";
    return out;
}

stages overlay_stages(const shadow_system& s, version v) {
    return {vertex(v, {}, rectangle_vertex), overlay_head(s, v, {}) + R"GLSL(
uniform float low, high;
void main() { fragment_colour = vec4(vec3(umbrage_saturate((depth_here() - low) / (high - low))), 1.0); }
)GLSL"};
}

stages read_back_stages(const shadow_system& s, version v) {
    return {vertex(v, {}, rectangle_vertex), overlay_head(s, v, {glsl::encode_rgb24, glsl::to_unorm}) + R"GLSL(
void main() { fragment_colour = vec4(umbrage_to_unorm(umbrage_encode_rgb24(depth_here())), 1.0); }
)GLSL"};
}

stages text_stages(version v) {
    return {vertex(v, {}, R"GLSL(
attribute vec2 corner;       // pixels, from the top left
uniform vec2 offset, pixel;  // pixels; size of one in NDC
void main() {
    vec2 at = (corner + offset) * pixel;
    gl_Position = vec4(at.x - 1.0, 1.0 - at.y, 0.0, 1.0);
}
)GLSL"),
            fragment(v, {}, "uniform vec4 ink;\nvoid main() { fragment_colour = ink; }\n")};
}

}  // namespace viewer
