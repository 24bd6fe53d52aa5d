// SPDX-License-Identifier: MIT
#include "programs.hpp"

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/bias/constant.hpp>
#include <umbrage/debug/overlay_texel.hpp>
#include <umbrage/depth/foreign/ps14.hpp>
#include <umbrage/filter/prefiltered/reduce.hpp>
#include <umbrage/light/lighting.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include <names.hpp>
#include <soft.hpp>

#include "parts.hpp"
#include "stored_as.hpp"

namespace viewer {
namespace {

using example::shadow_system;
using glsl::version;

/// All of them, for one map.
std::vector<glsl::bound> joined(std::initializer_list<snippets> lists, const glsl::binding& map) {
    std::vector<glsl::bound> all;
    for (const snippets& list : lists)
        for (const glsl::snippet& s : list) all.push_back(bind(s, "", map));
    return all;
}

// One text for GLSL 100 and 330: written in the words of 100.
std::string vertex_text(version v, const std::vector<glsl::bound>& uses, std::string_view rest) {
    return glsl::source(v, uses, v == version::v100 ? "" : "#define attribute in\n#define varying out\n").append(rest);
}
std::string fragment_text(version v, const std::vector<glsl::bound>& uses, std::string_view rest,
                          const std::string& ahead = {}) {
    const std::string words =
        v == version::v100 ? "precision highp float;\nprecision highp sampler2D;\n#define fragment_color gl_FragColor\n"
                           : "#define varying in\nout vec4 fragment_color;\n";
    return glsl::source(v, uses, words + ahead).append(rest);
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

/// depth_here(): the map's depth under a pixel of a rectangle of `overlay_size` pixels.
std::string overlay_head(const shadow_system& s, version v, const snippets& more, bool layers) {
    const glsl::binding map = layers ? glsl::binding{.texture = glsl::texture::array}
                                     : encoding_called(s.encoding).map;  // whatever way the system itself reads it
    return fragment_text(v, joined({{glsl::fetch_depth, glsl::overlay_texel, glsl::saturate}, more}, map), R"GLSL(
uniform vec2 map_size, overlay_size;
varying vec2 at;

/// Texel of the whole, its first at the bottom left.
vec2 texel_of(vec2 whole) {
    vec2 pixel = floor(at * overlay_size) + 0.5, rate = whole / overlay_size;
    return vec2(umbrage_overlay_texel(pixel.x, overlay_size.x, whole.x, rate.x),
                whole.y - 1.0 - umbrage_overlay_texel(pixel.y, overlay_size.y, whole.y, rate.y));
}
)GLSL") + (layers ? R"GLSL(
uniform sampler2DArray map;
uniform vec2 tiles;  // layers side by side, and below each other
float depth_here() {
    vec2 texel = texel_of(tiles * map_size), tile = floor(texel / map_size);
    return umbrage_fetch_depth(map, (tiles.y - 1.0 - tile.y) * tiles.x + tile.x, map_size, texel - tile * map_size);
}
)GLSL"
                  : R"GLSL(
uniform sampler2D map;
float depth_here() { return umbrage_fetch_depth(map, map_size, texel_of(map_size)); }
)GLSL");
}

}  // namespace

stages depth_stages(const shadow_system& s, version v) {
    const storage how = storage_of(s);
    return {vertex_text(v, {glsl::shadow_coordinate}, R"GLSL(
attribute vec3 position;
uniform mat4 light_to_clip, world_to_texels;
varying vec4 coordinate;
void main() {
    coordinate = umbrage_shadow_coordinate(world_to_texels, position);
    gl_Position = light_to_clip * vec4(position, 1.0);
}
)GLSL"),
            fragment_text(v, joined({how.writers, depth_snippets(), {glsl::project_coordinate}}, glsl::binding{}),
                          "uniform sampler2D table;\nvarying vec4 coordinate;\n" + map_depth(s) + R"GLSL(
void main() {
    float depth = map_depth(umbrage_project_coordinate(coordinate).z);
    fragment_color = )GLSL" + how.write +
                              ";\n}\n",
                          planes)};
}

stages camera_stages(const shadow_system& s, version v, bool mask) {
    const storage how = storage_of(s);
    const filter filter = filter_of(s);
    const bias bias = bias_of(s);
    const bool projects = compares_projected(s), four = has_tap_matrices(s), ahead = example::filters_ahead(s.filter);
    const bool sums = summed_table_of(s).has_value();
    const glsl::binding map = !ahead ? compared_map(s, how.map)
                              : sums ? glsl::binding{.texture = glsl::texture::integer}
                                     : glsl::binding{};
    const auto compared = [&](const char* depth) { return ahead ? even(s, depth) : projected(s, depth); };
    const std::string lit = s.shading == example::shading_kind::diffuse_ambient
                                ? "umbrage_diffuse_ambient(albedo, ambient, n_dot_l, visibility)"
                                : "umbrage_diffuse_ambient(albedo, ambient, n_dot_l, 1.0) * "
                                  "(ambient + (1.0 - ambient) * clamp(4.0 * n_dot_l, 0.0, 1.0) * visibility)";

    stages out;
    out.vertex = vertex_text(v, {glsl::shadow_coordinate},
                             R"GLSL(
attribute vec3 position, normal, face_normal;
attribute vec4 color;
uniform mat4 world_to_clip, taps[4];
varying vec3 world, world_normal, world_face;
varying vec4 surface_color;
)GLSL" + std::string(four ? "varying vec4 tap_0, tap_1, tap_2, tap_3;\n" : "") +
                                 "void main() {\n" +
                                 (four ? R"GLSL(    tap_0 = umbrage_shadow_coordinate(taps[0], position);
    tap_1 = umbrage_shadow_coordinate(taps[1], position);
    tap_2 = umbrage_shadow_coordinate(taps[2], position);
    tap_3 = umbrage_shadow_coordinate(taps[3], position);
)GLSL"
                                       : "") +
                                 R"GLSL(    world = position;
    world_normal = normal;
    world_face = face_normal;
    surface_color = color;
    gl_Position = world_to_clip * vec4(position, 1.0);
}
)GLSL");
    out.fragment = fragment_text(
        v,
        joined({how.writers,
                depth_snippets(),
                bias.uses,
                filter.uses,
                {glsl::receiver_ps14, glsl::shadow_coordinate, glsl::project_coordinate, glsl::texels_to_world,
                 glsl::biased, glsl::spot_cone, glsl::diffuse_ambient}},
               map),
        R"GLSL(
varying vec3 world, world_normal, world_face;
varying vec4 surface_color;   // alpha: 1 on the floor
uniform vec3 eye, light_direction;
uniform vec4 light_position;  // w: 1 for a spot, 0 for a directional light
uniform float cos_outer, reach, constant, epsilon, alpha;
uniform mat4 world_to_texels, plane_matrix;
uniform sampler2D map, table;
uniform vec2 map_size, moments_size, units;
uniform vec4 softness;
uniform vec3 ambient;
uniform )GLSL" +
            std::string(sums ? "usampler2D" : "sampler2D") + " moments;\n" + map_depth(s) + R"GLSL(
vec3 unit(vec3 a, vec3 otherwise) { return length(a) > 0.0 ? a / length(a) : otherwise; }
vec3 towards(vec3 a, vec3 side) { return dot(a, side) < 0.0 ? -a : a; }

vec3 floor_color(vec3 point) {
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
)GLSL" +
            std::string(four ? R"GLSL(varying vec4 tap_0, tap_1, tap_2, tap_3;  // over the map from 0 to 1
vec2 tap(vec4 coordinate) {
    vec4 moved = world_to_texels * vec4(looked_up - world, 0.0);  // by the bias
    return umbrage_project_coordinate(coordinate + vec4(moved.xy / map_size, moved.zw)).xy;
}
)GLSL"
                             : "") +
            R"GLSL(
void main() {
    vec3 face = towards(unit(world_face, vec3(0.0, 1.0, 0.0)), eye - world);
    vec3 normal = towards(unit(world_normal, face), face);

    // Bias: so much that the surface cannot shadow itself.
    float w = umbrage_shadow_coordinate(world_to_texels, world).w;
    vec3 way = light_position.w > 0.0 ? (world - light_position.xyz) / w : light_direction;
    float width = umbrage_texels_to_world(1.4142137 * reach, units, w);
    vec3 offset = vec3(0.0, 0.0, 0.0);
    float by = 0.0;
    )GLSL" + bias.statement +
            R"GLSL(

    // Light, and where in its map the surface lies.
    looked_up = world + offset;
    vec3 p = umbrage_project_coordinate(umbrage_shadow_coordinate(world_to_texels, looked_up));
    float depth = map_depth(umbrage_biased(p.z, by));

    // Fetch, decode, compare, filter.
    float biased = umbrage_biased(depth, epsilon);
)GLSL" +
            (projects || ahead ? "    depth = " + compared("depth") + ";\n    biased = " + compared("biased") + ";\n"
                               : std::string()) +
            R"GLSL(
    float receiver = )GLSL" +
            receiver_of(s) + ";\n" +
            (example::compares_along_plane(s.bias) ? "    plane_at = vec3(p.xy, receiver);\n" : "") +
            R"GLSL(    float visibility = )GLSL" + filter.visibility +
            R"GLSL(;
    if (light_position.w > 0.0)
        visibility *= umbrage_spot_cone(light_direction, world - light_position.xyz, cos_outer);
)GLSL",
        bias.ahead);
    if (mask) {
        out.fragment += "    fragment_color = vec4(vec3(visibility), 1.0);\n}\n";
        return out;
    }
    out.fragment += R"GLSL(
    // Shade.
    vec3 albedo = surface_color.a > 0.5 ? floor_color(world) : surface_color.rgb;
)GLSL" + std::string(s.textured ? "    if (alpha == 1.0) albedo *= solid_texture(world);\n" : "") +
                    R"GLSL(
    vec3 to_light = light_position.w > 0.0 ? normalize(light_position.xyz - world) : -light_direction;
    float n_dot_l = dot(normal, to_light);
    vec3 seen = )GLSL" +
                    lit + R"GLSL(;
    fragment_color = vec4(srgb(seen.r), srgb(seen.g), srgb(seen.b), alpha);
}
)GLSL";
    return out;
}

stages moments_stages(const shadow_system& s, version v) {
    const prefilter of = *prefilter_of(s);
    snippets uses = depth_snippets();
    uses.insert(uses.end(), of.writers.begin(), of.writers.end());
    return {vertex_text(v, {}, rectangle_vertex), overlay_head(s, v, uses, false) + planes +
                                                      "void main() {\n    float depth = " + even(s, "depth_here()") +
                                                      ";\n    fragment_color = " + of.texel + ";\n}\n"};
}

stages blur_stages(version v, int taps) {
    const glsl::snippet& row = taps == 3 ? glsl::blur_row<3> : taps == 5 ? glsl::blur_row<5> : glsl::blur_row<7>;
    return {vertex_text(v, {}, rectangle_vertex), fragment_text(v, {row}, R"GLSL(
uniform sampler2D map;
uniform vec2 map_size, along;
varying vec2 at;
void main() {
    vec2 texel = floor(vec2(at.x, 1.0 - at.y) * map_size);
    fragment_color = umbrage_)GLSL" + std::string(row.name) + "(map, map_size, texel, along);\n}\n")};
}

stages overlay_stages(const shadow_system& s, version v, bool layers) {
    return {vertex_text(v, {}, rectangle_vertex), overlay_head(s, v, {}, layers) + R"GLSL(
uniform float low, high;
void main() { fragment_color = vec4(vec3(umbrage_saturate((depth_here() - low) / (high - low))), 1.0); }
)GLSL"};
}

stages read_back_stages(const shadow_system& s, version v, bool layers) {
    return {vertex_text(v, {}, rectangle_vertex),
            overlay_head(s, v, {glsl::encode_rgb24, glsl::to_unorm}, layers) + R"GLSL(
void main() { fragment_color = vec4(umbrage_to_unorm(umbrage_encode_rgb24(depth_here())), 1.0); }
)GLSL"};
}

stages text_stages(version v) {
    return {vertex_text(v, {}, R"GLSL(
attribute vec2 corner;       // pixels, from the top left
uniform vec2 offset, pixel;  // pixels; size of one in NDC
void main() {
    vec2 at = (corner + offset) * pixel;
    gl_Position = vec4(at.x - 1.0, 1.0 - at.y, 0.0, 1.0);
}
)GLSL"),
            fragment_text(v, {}, "uniform vec4 ink;\nvoid main() { fragment_color = ink; }\n")};
}

}  // namespace viewer
