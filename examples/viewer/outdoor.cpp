// SPDX-License-Identifier: MIT
#include "outdoor.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <umbrage/bias/kernel.hpp>
#include <umbrage/bias/normal_offset.hpp>
#include <umbrage/images/instances.hpp>
#include <umbrage/light/cascades/blend.hpp>
#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/cascades/splits.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shade/lighting.hpp>
#include <umbrage/shader/bind.hpp>

#include <camera.hpp>
#include <srgb.hpp>

#include "parts.hpp"

namespace viewer {
namespace {

constexpr float fade = 0.1f;                  ///< share of a cascade over which the next one takes over
constexpr GLuint place_columns = corner + 1;  ///< attribute of an instance's matrix, and the three after it

struct shape_vertex {
    glm::vec3 position, normal, colour;
};

constexpr const char* place_attribute = R"GLSL(
in vec3 position, normal, colour;
layout(location = 5) in mat4 place;
uniform mat4 world_to_clip;
)GLSL";

stages depth_text() {
    return {glsl::source(glsl::version::v330, {}) + place_attribute + R"GLSL(
void main() { gl_Position = world_to_clip * (place * vec4(position, 1.0)); }
)GLSL",
            glsl::source(glsl::version::v330, {}) + "void main() {}\n"};
}

/// @param mask, tint   visibility alone; cascades in colours
stages camera_text(const example::shadow_system& s, bool mask, bool tint) {
    const filter filter = filter_of(s);
    std::vector<glsl::bound> uses{glsl::shadow_coordinate,  glsl::cascade_by_depth, glsl::cascade_column,
                                  glsl::cascade_coordinate, glsl::cascade_fade,     glsl::blend_cascades,
                                  glsl::normal_offset,      glsl::diffuse_ambient};
    for (const glsl::snippet& f : filter.uses)
        uses.push_back(bind(f, "", {.texture = glsl::texture::array, .outside_lit = true}));
    std::string visibility = filter.visibility;  // of a map alone; here of a layer
    visibility.replace(visibility.find("(map,"), 5, "(maps, number,");
    stages out;
    out.vertex = glsl::source(glsl::version::v330, {}) + place_attribute + R"GLSL(
uniform vec3 eye, ahead;
out vec3 from_eye, world_normal, surface_colour;
out float distance_ahead;
void main() {
    from_eye = (place * vec4(position, 1.0)).xyz - eye;
    world_normal = mat3(place) * normal;
    surface_colour = colour;
    distance_ahead = dot(from_eye, ahead);
    gl_Position = world_to_clip * (place * vec4(position, 1.0));
}
)GLSL";
    out.fragment = glsl::source(glsl::version::v330, uses) + R"GLSL(
in vec3 from_eye, world_normal, surface_colour;
in float distance_ahead;
out vec4 fragment_colour;
uniform vec3 eye, light_direction, ends;
uniform mat4 rotation, scales, offsets;
uniform vec4 widths;  // that a normal offset has to cover, of each cascade
uniform vec2 map_size;
uniform float epsilon, ambient;
uniform sampler2DArray maps;

vec3 towards(vec3 a, vec3 side) { return dot(a, side) < 0.0 ? -a : a; }
float srgb(float v) { return v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1.0 / 2.4) - 0.055; }

float visibility_in(float number, vec3 face) {
    vec3 offset = umbrage_normal_offset(face, light_direction, light_direction, widths[int(number)], 0.0);
    vec3 turned = umbrage_shadow_coordinate(rotation, eye + from_eye + offset).xyz;
    vec3 p = umbrage_cascade_coordinate(turned, umbrage_cascade_column(scales, number),
                                        umbrage_cascade_column(offsets, number));
    float receiver = p.z - epsilon;
    return )GLSL" + visibility +
                   R"GLSL(;
}

void main() {
    vec3 face = towards(normalize(cross(dFdx(from_eye), dFdy(from_eye))), -from_eye);
    float number = umbrage_cascade_by_depth(distance_ahead, ends);
    float weight = umbrage_cascade_fade(distance_ahead, umbrage_cascade_column(scales, number).w,
                                        umbrage_cascade_column(offsets, number).w);
    float next = number < 2.5 ? visibility_in(min(number + 1.0, 3.0), face) : 1.0;
    float visibility = umbrage_blend_cascades(visibility_in(number, face), next, weight);
)GLSL";
    if (mask) {
        out.fragment += "    fragment_colour = vec4(vec3(visibility), 1.0);\n}\n";
        return out;
    }
    out.fragment += R"GLSL(
    vec3 seen = umbrage_diffuse_ambient(surface_colour, ambient, dot(towards(normalize(world_normal), face),
                                        -light_direction), visibility);
    fragment_colour = vec4(srgb(seen.r), srgb(seen.g), srgb(seen.b), 1.0);
)GLSL";
    if (tint)
        out.fragment += R"GLSL(
    const vec3 tints[5] = vec3[5](vec3(1.0, 0.45, 0.4), vec3(0.5, 1.0, 0.4), vec3(0.45, 0.6, 1.0),
                                  vec3(1.0, 0.9, 0.35), vec3(1.0));
    fragment_colour.rgb *= mix(tints[int(number)], tints[int(number) + 1], weight);
)GLSL";
    out.fragment += "}\n";
    return out;
}

umbrage::cascade_fit<float> fit_of(const session& s, const example::camera& c) {
    const auto& f = c.frustum;
    return {.camera{c.position, f.direction, f.up, float(f.tan_half_x), float(f.tan_half_y), 1, 2},
            .direction = -example::direction_at(s.system.azimuth, s.system.elevation),
            .up = example::direction_at(s.system.azimuth, s.system.elevation + 90),
            .scene{s.scene.low, s.scene.high},
            .map_size = s.system.map_size,
            .margin = 2 * s.system.reach,
            .overlap = fade,
            .clip = umbrage::opengl_clip_space};
}

}  // namespace

outdoor::outdoor(const example::scene& scene) : depth_(depth_text()) {
    std::vector<shape_vertex> vertices;
    std::vector<glm::uvec3> triangles;
    for (const example::copies& part : scene.parts) {
        const example::mesh& m = part.shape;
        shapes_.push_back({umbrage::bounds_of(view_of(m)), 3 * triangles.size(), 3 * m.triangles.size(),
                           static_cast<GLint>(vertices.size())});
        for (std::size_t i = 0; i < m.positions.size(); ++i)
            vertices.push_back({m.positions[i], m.normals[i], m.colours[i]});
        triangles.insert(triangles.end(), m.triangles.begin(), m.triangles.end());
    }
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size() * sizeof(shape_vertex)), vertices.data(),
                 GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(triangles.size() * sizeof(glm::uvec3)),
                 triangles.data(), GL_STATIC_DRAW);
}

void outdoor::draw_instances(const example::scene& scene, const glm::mat4& world_to_clip,
                             umbrage::clip_space clip) const {
    std::vector<glm::mat4> places;
    std::vector<std::size_t> first;  // of each shape
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
        first.push_back(places.size());
        const auto kept = umbrage::instances_in_map(shapes_[i].bounds, scene.parts[i].places, world_to_clip, clip);
        places.insert(places.end(), kept.begin(), kept.end());
    }
    first.push_back(places.size());

    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_);
    glBindBuffer(GL_ARRAY_BUFFER, vertices_);
    attribute_at(position, 3, sizeof(shape_vertex), offsetof(shape_vertex, position));
    attribute_at(normal, 3, sizeof(shape_vertex), offsetof(shape_vertex, normal));
    attribute_at(colour, 3, sizeof(shape_vertex), offsetof(shape_vertex, colour));
    for (const GLuint unused : {face_normal, corner}) glDisableVertexAttribArray(unused);
    glBindBuffer(GL_ARRAY_BUFFER, places_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(places.size() * sizeof(glm::mat4)), places.data(),
                 GL_STREAM_DRAW);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    for (std::size_t i = 0; i < shapes_.size(); ++i) {
        if (first[i] == first[i + 1]) continue;
        for (GLuint column = 0; column < 4; ++column) {
            attribute_at(place_columns + column, 4, sizeof(glm::mat4),
                         first[i] * sizeof(glm::mat4) + column * sizeof(glm::vec4));
            glVertexAttribDivisor(place_columns + column, 1);
        }
        glDrawElementsInstancedBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(shapes_[i].indices), GL_UNSIGNED_INT,
                                          reinterpret_cast<const void*>(shapes_[i].first_index * sizeof(unsigned)),
                                          static_cast<GLsizei>(first[i + 1] - first[i]), shapes_[i].first_vertex);
    }
    for (GLuint column = 0; column < 4; ++column) glDisableVertexAttribArray(place_columns + column);
}

void outdoor::draw(const session& s, GLuint framebuffer, glm::ivec2 size) {
    const int edge = s.system.map_size;
    const example::camera camera = example::make_camera(s.camera);
    const umbrage::cascade_fit<float> fit = fit_of(s, camera);
    const float nearest = 0.2f * s.camera.distance;  // what is closer does not claim a cascade
    double farthest = 2 * nearest;
    for (const glm::dvec3& corner : umbrage::corners(fit.scene))
        farthest = std::max(farthest, glm::dot(corner - glm::dvec3(camera.position), camera.frustum.direction));
    auto splits = umbrage::practical_splits<4>(nearest, static_cast<float>(farthest), 0.9f);
    splits[0] = s.camera.z_near;
    const auto cascades = umbrage::make_stable_cascades<4>(fit, splits);
    const auto uniforms = umbrage::make_cascade_uniforms(cascades, fade);

    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, maps_);
    if (map_size_ != edge) {
        glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT32F, edge, edge, 4, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                     nullptr);
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        map_size_ = edge;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, layer_);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    glViewport(0, 0, edge, edge);
    glm::vec4 widths;
    depth_.use();
    for (int i = 0; i < 4; ++i) {
        const auto& c = cascades[static_cast<std::size_t>(i)];
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, maps_, 0, i);
        glClear(GL_DEPTH_BUFFER_BIT);
        const glm::mat4 world_to_clip = c.light.projection * c.light.view;
        depth_.set("world_to_clip", world_to_clip);
        draw_instances(s.scene, world_to_clip, c.light.clip);
        widths[i] = umbrage::offset_width(s.system.reach, 1 / c.scale.x);
    }

    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, size.x, size.y);
    const glm::vec3 sky = s.mask ? glm::vec3(1) : glm::vec3(example::to_srgb(example::sky)) / 255.0f;
    glClearColor(sky.x, sky.y, sky.z, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (stages text = camera_text(s.system, s.mask, s.tint); !camera_ || camera_->text() != text)
        camera_.emplace(std::move(text));
    glm::mat4 world_to_clip = camera.world_to_clip;  // whose z/w runs from 0 to 1
    for (int column = 0; column < 4; ++column)
        world_to_clip[column][2] = 2 * world_to_clip[column][2] - world_to_clip[column][3];
    camera_->use()
        .set("world_to_clip", world_to_clip)
        .set("eye", camera.position)
        .set("ahead", glm::vec3(camera.frustum.direction))
        .set("light_direction", fit.direction)
        .set("ends", uniforms.ends)
        .set("rotation", uniforms.rotation)
        .set("scales", uniforms.scales)
        .set("offsets", uniforms.offsets)
        .set("widths", widths)
        .set("map_size", glm::vec2(static_cast<float>(edge)))
        .set("epsilon", s.system.epsilon)
        .set("ambient", s.system.ambient)
        .set("maps", 0);
    draw_instances(s.scene, world_to_clip, umbrage::opengl_clip_space);
    check_errors("a frame");
}

}  // namespace viewer
