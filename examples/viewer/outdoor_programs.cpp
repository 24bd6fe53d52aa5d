// SPDX-License-Identifier: MIT
#include "outdoor_programs.hpp"

#include <cmath>
#include <string>
#include <vector>

#include <glm/common.hpp>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/slope.hpp>
#include <umbrage/depth/conversions.hpp>
#include <umbrage/light/adaptive/page_table.hpp>
#include <umbrage/light/cascades/blend.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/lighting.hpp>
#include <umbrage/light/point/cube_map.hpp>
#include <umbrage/light/point/dual_paraboloid.hpp>
#include <umbrage/light/point/tetrahedron.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shader/bind.hpp>

#include "parts.hpp"

namespace viewer {
namespace {

std::string shader(const std::vector<glsl::bound>& uses, std::string_view ahead = {}) {
    return glsl::source(glsl::version::v330, uses, ahead);
}

std::string instances() {
    return shader({}) + R"GLSL(
in vec3 position, normal, color;
layout(location = 5) in mat4 place;
uniform mat4 world_to_clip;
uniform vec3 eye;
)GLSL";
}

constexpr const char* faces = R"GLSL(
in vec3 from_eye;
vec3 towards(vec3 a, vec3 side) { return dot(a, side) < 0.0 ? -a : a; }
vec3 face_here() { return towards(normalize(cross(dFdx(from_eye), dFdy(from_eye))), -from_eye); }
)GLSL";

/// float visibility_here(vec3 face)
constexpr const char* in_four_layers = R"GLSL(
uniform vec3 ends;
uniform mat4 rotation, scales, offsets;
uniform mat4 plane_matrix[4];
uniform float reach;
float number, weight;

float visibility_in(float number, vec3 face) {
    vec3 turned = umbrage_shadow_coordinate(rotation, eye + from_eye).xyz;
    vec3 p = umbrage_cascade_coordinate(turned, umbrage_cascade_column(scales, number),
                                        umbrage_cascade_column(offsets, number));
    vec2 slope = umbrage_plane_slope(plane_matrix[int(number)], face, from_eye);
    return filtered(number, p, p.z - epsilon - umbrage_acne_free_bias(slope, reach, 0.0));
}

float visibility_here(vec3 face) {
    number = umbrage_cascade_by_depth(distance_ahead, ends);
    weight = umbrage_cascade_fade(distance_ahead, umbrage_cascade_column(scales, number).w,
                                  umbrage_cascade_column(offsets, number).w);
    float next = number < 2.5 ? visibility_in(min(number + 1.0, 3.0), face) : 1.0;
    return umbrage_blend_cascades(visibility_in(number, face), next, weight);
}
)GLSL";

/// Face of a lamp for the way there: number of matrices, index of the matrix, and layer.
constexpr const char* one_face = R"GLSL(
const int faces = 1;
float face_of(vec3 way) { return 0.0; }
float layer_of(float face) { return 0.0; }
)GLSL";
constexpr const char* cube_faces = R"GLSL(
const int faces = 6;
float face_of(vec3 way) { return umbrage_cube_face(way); }
float layer_of(float face) { return face; }
)GLSL";
constexpr const char* tetrahedron_faces = R"GLSL(
const int faces = 4;
float face_of(vec3 way) { return umbrage_tetrahedron_face(way); }
float layer_of(float face) { return 0.0; }
)GLSL";

/// A warp's depths differ from place to place: epsilon is a length there, and the rest is the plane's own slope.
constexpr const char* in_a_face = R"GLSL(
uniform mat4 eye_to_texels[faces], plane_matrix[faces];
uniform float reach;
float number, weight = 0.0;

float visibility_here(vec3 face) {
    vec3 looked_up = from_eye - epsilon * light_direction;
    number = face_of(looked_up - light.xyz);
    vec3 p = umbrage_project_coordinate(umbrage_shadow_coordinate(eye_to_texels[int(number)], looked_up));
    vec2 slope = umbrage_plane_slope(plane_matrix[int(number)], face, from_eye);
    return filtered(layer_of(number), p, p.z - umbrage_acne_free_bias(slope, reach, 0.0));
}
)GLSL";

/// Distances change by their tangent's share of the angle that a filter reaches, and of what tessellation leaves of
/// places, 7/6 of a texel.
constexpr const char* in_a_paraboloid = R"GLSL(
uniform float reach, border, range, error;
float number, weight = 0.0;

float visibility_here(vec3 face) {
    vec3 way = from_eye - light.xyz - epsilon * light_direction;
    vec3 at = umbrage_dual_paraboloid_coordinate(way);
    number = at.z;
    vec2 inner = map_size - 2.0 * border;
    float depth = umbrage_distance_depth(way, 1.0 / range);
    float cosine = abs(dot(face, light_direction));
    float radians_a_texel = 2.0 * (1.0 + abs(light_direction.z)) / inner.x;
    float slope = depth * radians_a_texel * sqrt(1.0 - cosine * cosine) / cosine;
    float bias = umbrage_acne_free_bias(vec2(slope * sqrt(0.5)), reach + 0.825, error);
    return filtered(number, vec3(at.xy * inner + border, depth), depth - bias);
}
)GLSL";

/// A texel's slope is that of the finest pages' texels, as many times as theirs a page's are wide.
constexpr const char* in_a_page = R"GLSL(
uniform sampler2D table;
uniform mat4 eye_to_root, plane_matrix;
uniform vec2 table_size, page;  // texels of a page, and around it
uniform float reach;
float number, weight = 0.0;

float visibility_here(vec3 face) {
    vec3 looked_up = from_eye - epsilon * light_direction;
    vec3 p = umbrage_shadow_coordinate(eye_to_root, looked_up).xyz;
    vec4 at = umbrage_page_coordinate_table(table, table_size, p.xy, page.x, page.y);
    vec2 cell = clamp(p.xy * (table_size - 2.0) - (table_size - 3.0), vec2(0.0), table_size - 1.0);
    vec2 bytes = umbrage_from_unorm(texelFetch(table, ivec2(cell), 0).zw);
    float across = max(bytes.x + bytes.y * 256.0, 1.0);
    number = mod(floor(log2(across) + 0.5), 4.0);
    vec2 slope = umbrage_plane_slope(plane_matrix, face, from_eye) * ((table_size.x - 2.0) / across);
    page_origin = at.zw;
    return filtered(0.0, vec3(at.xy, p.z), p.z - umbrage_acne_free_bias(slope, reach, 0.0));
}
)GLSL";

constexpr const char* tints = R"GLSL(
    const vec3 tints[7] = vec3[7](vec3(1.0, 0.45, 0.4), vec3(0.5, 1.0, 0.4), vec3(0.45, 0.6, 1.0),
                                  vec3(1.0, 0.9, 0.35), vec3(1.0), vec3(0.5, 1.0, 1.0), vec3(1.0));
    fragment_color.rgb *= mix(tints[int(number)], tints[int(number) + 1], weight);
)GLSL";

}  // namespace

stages outdoor_depth_stages(std::string_view placement) {
    if (placement == in_paraboloids)
        return {shader({glsl::dual_paraboloid_position}) + R"GLSL(
in vec3 position;
uniform mat4 world_to_clip;
uniform vec3 eye;
uniform float face;
void main() {
    vec4 at = umbrage_dual_paraboloid_position(position - eye, face);
    gl_ClipDistance[0] = at.w - 0.1 * length(position - eye);
    gl_Position = world_to_clip * at;
}
)GLSL",
                shader({}) + "void main() {}\n"};
    stages out{instances() + R"GLSL(
void main() { gl_Position = world_to_clip * vec4((place * vec4(position, 1.0)).xyz - eye, 1.0); }
)GLSL",
               shader({}) + "void main() {}\n"};
    if (placement == in_tetrahedron)
        out.fragment = shader({glsl::tetrahedron_face_of}) + R"GLSL(
uniform vec2 map_size;
uniform float face;
void main() {
    if (umbrage_tetrahedron_face_of(floor(gl_FragCoord.xy), map_size.x) != face) discard;
}
)GLSL";
    return out;
}

stages outdoor_look_stages() {
    return {instances() + R"GLSL(
out vec3 from_eye;
void main() {
    from_eye = (place * vec4(position, 1.0)).xyz - eye;
    gl_Position = world_to_clip * (place * vec4(position, 1.0));
}
)GLSL",
            shader({}) + faces + R"GLSL(
out vec4 fragment_color;
void main() {
    vec3 face = towards(face_here(), vec3(0.0, 0.0, 1.0));
    vec2 bits = floor((face.xy * 0.5 + 0.5) * 4095.0 + 0.5);
    fragment_color = vec4(from_eye, bits.x * 4096.0 + bits.y);
}
)GLSL"};
}

glm::vec3 normal_of(float bits) {
    const float high = std::floor(bits / 4096);
    const glm::vec2 side = glm::vec2(high, bits - 4096 * high) / 2047.5f - 1.0f;
    return {side, std::sqrt(glm::max(1 - glm::dot(side, side), 0.0f))};
}

stages outdoor_camera_stages(const session& s) {
    const filter filter = filter_of(s.system);
    std::vector<glsl::bound> uses{glsl::shadow_coordinate, glsl::diffuse_ambient};
    std::vector<glsl::bound> more{glsl::project_coordinate, glsl::plane_slope, glsl::acne_free_bias};
    glsl::binding map{.texture = glsl::texture::array};
    std::string ahead, visibility_here = std::string(one_face) + in_a_face;
    if (s.cascaded()) {
        visibility_here = in_four_layers;
        more = {glsl::cascade_by_depth, glsl::cascade_column, glsl::cascade_coordinate, glsl::cascade_fade,
                glsl::blend_cascades,   glsl::plane_slope,    glsl::acne_free_bias};
    }
    if (s.paged()) {
        visibility_here = in_a_page;
        more.push_back(bind(glsl::page_coordinate, "table"));
        more.push_back(glsl::from_unorm);
        map = {.texture = glsl::texture::array, .origin = "page_origin"};
        ahead = "vec2 page_origin;\n";
    }
    if (s.placement == in_cube) {
        visibility_here = std::string(cube_faces) + in_a_face;
        more.push_back(glsl::cube_face);
    }
    if (s.placement == in_tetrahedron) {
        visibility_here = std::string(tetrahedron_faces) + in_a_face;
        more.push_back(glsl::tetrahedron_face);
    }
    if (s.placement == in_paraboloids) {
        visibility_here = in_a_paraboloid;
        more = {glsl::dual_paraboloid_coordinate, glsl::distance_depth, glsl::acne_free_bias};
    }
    uses.insert(uses.end(), more.begin(), more.end());
    for (const glsl::snippet& f : filter.uses) uses.push_back(bind(f, "", map));
    std::string visibility = filter.visibility;  // made for a map alone, here changed for a layer
    visibility.replace(visibility.find("(map,"), 5, "(maps, layer,");
    stages out;
    out.vertex = instances() + R"GLSL(
uniform vec3 ahead;
out vec3 from_eye, world_normal, surface_color;
out float distance_ahead;
void main() {
    from_eye = (place * vec4(position, 1.0)).xyz - eye;
    world_normal = mat3(place) * normal;
    surface_color = color;
    distance_ahead = dot(from_eye, ahead);
    gl_Position = world_to_clip * (place * vec4(position, 1.0));
}
)GLSL";
    out.fragment = shader(uses, ahead) + faces + R"GLSL(
in vec3 world_normal, surface_color;
in float distance_ahead;
out vec4 fragment_color;
uniform vec3 eye;
uniform vec4 light;  // towards it and 0, or where it is from the eye and 1
vec3 light_direction;
uniform vec2 map_size;
uniform float epsilon;
uniform vec3 ambient;
uniform sampler2DArray maps;

float srgb(float v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1.0 / 2.4) - 0.055; }
float filtered(float layer, vec3 p, float receiver) { return )GLSL" +
                   visibility + "; }\n" + visibility_here + R"GLSL(
void main() {
    light_direction = normalize(from_eye * light.w - light.xyz);
    vec3 face = face_here();
    float visibility = visibility_here(face);
)GLSL";
    if (s.mask) {
        out.fragment += "    fragment_color = vec4(vec3(visibility), 1.0);\n}\n";
        return out;
    }
    out.fragment += R"GLSL(
    vec3 seen = umbrage_diffuse_ambient(surface_color, ambient, dot(towards(normalize(world_normal), face),
                                        -light_direction), visibility);
    fragment_color = vec4(srgb(seen.r), srgb(seen.g), srgb(seen.b), 1.0);
)GLSL";
    if (s.tint && has_parts(s.placement)) out.fragment += tints;
    out.fragment += "}\n";
    return out;
}

}  // namespace viewer
