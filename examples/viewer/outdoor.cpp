// SPDX-License-Identifier: MIT
#include "outdoor.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <glm/gtc/matrix_transform.hpp>

#include <umbrage/bias/slope.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/draw/instances.hpp>
#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/splits.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include <srgb.hpp>

#include "outdoor_programs.hpp"

namespace viewer {
namespace {

constexpr GLuint place_columns = corner + 1;  ///< attribute of an instance's matrix, and the three after it

struct shape_vertex {
    glm::vec3 position, normal, color;
};

glm::vec3 sun(const session& s) { return -example::direction_at(s.system.azimuth, s.system.elevation); }

/// World units that something of the map's depth is, of a map that goes through all of the scene.
float along_light(const session& s, float depth) {
    return depth * glm::dot(s.scene.high - s.scene.low, glm::abs(sun(s)));
}

umbrage::cascade_fit<float> fit_of(const session& s, const example::camera& c) {
    const auto& f = c.frustum;
    return {.camera{c.position, f.direction, f.up, float(f.tan_half_x), float(f.tan_half_y), 1, 2},
            .direction = sun(s),
            .up = example::direction_at(s.system.azimuth, s.system.elevation + 90),
            .scene{s.scene.low, s.scene.high},
            .map_size = s.system.map_size,
            .margin = 2 * s.system.reach,
            .overlap = cascade_fade_share,
            .clip = umbrage::opengl_clip_space};
}

}  // namespace

outdoor::outdoor(const example::scene& scene) : look_(outdoor_look_stages()) {
    std::vector<shape_vertex> vertices;
    std::vector<glm::uvec3> triangles;
    for (const example::copies& part : scene.parts) {
        const example::mesh& m = part.shape;
        shapes_.push_back({umbrage::bounds_of(view_of(m)), 3 * triangles.size(), 3 * m.triangles.size(),
                           static_cast<GLint>(vertices.size())});
        for (std::size_t i = 0; i < m.positions.size(); ++i)
            vertices.push_back({m.positions[i], m.normals[i], m.colors[i]});
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
    std::vector<std::size_t> first;  // first index of each shape
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
    attribute_at(color, 3, sizeof(shape_vertex), offsetof(shape_vertex, color));
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

void outdoor::make_layers(int edge, int count) {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, maps_);
    if (map_size_ == edge && layers_ == count) return;
    map_size_ = edge, layers_ = count;
    glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_DEPTH_COMPONENT32F, edge, edge, count, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                 nullptr);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

void outdoor::clear_layer(int layer, const square& where) {
    glBindFramebuffer(GL_FRAMEBUFFER, layer_);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    glViewport(where.corner.x, where.corner.y, where.edge, where.edge);
    glScissor(where.corner.x, where.corner.y, where.edge, where.edge);
    glEnable(GL_SCISSOR_TEST);
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, maps_, 0, layer);
    glClear(GL_DEPTH_BUFFER_BIT);
    glDisable(GL_SCISSOR_TEST);
}

/// @param eye   close to which a warp's depths need all digits
void outdoor::draw_depths(const example::scene& scene, glm::vec3 eye, const umbrage::light_space<double>& light) const {
    const glm::dmat4 to_clip = light.projection * light.view;
    depth_->use().set("eye", eye).set("world_to_clip", glm::mat4(glm::translate(to_clip, glm::dvec3(eye))));
    draw_instances(scene, glm::mat4(to_clip), light.clip);
}

/// @param where   a square of the layer
void outdoor::draw_layer(const example::scene& scene, int layer, const square& where, glm::vec3 eye,
                         const umbrage::light_space<double>& light) {
    clear_layer(layer, where);
    draw_depths(scene, eye, light);
}

/// @param step   step between the pixels that become points, in x and y
outdoor::view outdoor::look(const example::scene& scene, const example::camera& c, glm::ivec2 size, int step) {
    if (!seen_ || seen_->size != size) seen_.emplace(size, texels_of::moments);
    glBindFramebuffer(GL_FRAMEBUFFER, seen_->framebuffer);
    glViewport(0, 0, size.x, size.y);
    glClearColor(0, 0, 0, -1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 world_to_clip = opengl(c.world_to_clip);
    look_.use().set("eye", c.position).set("world_to_clip", world_to_clip);
    draw_instances(scene, world_to_clip, umbrage::opengl_clip_space);
    umbrage::image<glm::vec4> seen(size);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, seen.texels().data());

    const glm::dvec3 eye(c.position);
    view v{{}, c.frustum.z_far, c.frustum.z_near};
    for (glm::ivec2 p{0}; p.y < size.y; ++p.y)
        for (p.x = 0; p.x < size.x; ++p.x) {
            const glm::vec4 at = seen[p];
            if (at.w < 0) continue;
            const double distance = glm::dot(glm::dvec3(at), c.frustum.direction);
            v.least = std::min(v.least, distance), v.greatest = std::max(v.greatest, distance);
            if (p.x % step == 0 && p.y % step == 0)
                v.points.push_back({eye + glm::dvec3(at), glm::dvec3(normal_of(at.w))});
        }
    // a thousandth more, as seen_range has it; the whole range where only sky is seen
    if (!(v.least < v.greatest)) return {{}, c.frustum.z_near, c.frustum.z_far};
    v.least = std::max(v.least * 0.999, c.frustum.z_near), v.greatest = std::min(v.greatest * 1.001, c.frustum.z_far);
    return v;
}

void outdoor::place_cascades(const session& s, const example::camera& camera) {
    const umbrage::cascade_fit<float> fit = fit_of(s, camera);
    const float nearest = 0.2f * s.camera.distance;  // what is closer does not claim a cascade
    double farthest = 2 * nearest;
    for (const glm::dvec3& corner : umbrage::corners(fit.scene))
        farthest = std::max(farthest, glm::dot(corner - glm::dvec3(camera.position), camera.frustum.direction));
    auto splits = umbrage::practical_splits<4>(nearest, static_cast<float>(farthest), 0.9f);
    splits[0] = s.camera.z_near;
    const auto cascades = umbrage::make_stable_cascades<4>(fit, splits);
    const auto uniforms = umbrage::make_cascade_uniforms(cascades, cascade_fade_share);
    std::array<glm::mat4, 4> planes;
    make_layers(s.system.map_size.x, 4);
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& of = cascades[i].light;
        const umbrage::light_space<double> light{glm::dmat4(of.view), glm::dmat4(of.projection), of.clip};
        draw_layer(s.scene, static_cast<int>(i), {{}, map_size_}, glm::vec3(0), light);
        const glm::dmat4 to_texels = umbrage::texture_matrix(light, glm::ivec2(map_size_));
        planes[i] = glm::mat4(umbrage::plane_matrix(glm::translate(to_texels, glm::dvec3(camera.position))));
    }
    camera_->use()
        .set("ends", uniforms.ends)
        .set("rotation", uniforms.rotation)
        .set("scales", uniforms.scales)
        .set("offsets", uniforms.offsets)
        .set("plane_matrix", planes.front(), 4)
        .set("reach", s.system.reach)
        .set("map_size", glm::vec2(static_cast<float>(map_size_)))
        .set("epsilon", s.system.epsilon);
    note_.clear();
}

void outdoor::place_one(const session& s, const example::camera& c, glm::ivec2 size) {
    const umbrage::bounding_box<double> scene{s.scene.low, s.scene.high};
    make_layers(2 * s.system.map_size.x, 1);
    const view seen = look(s.scene, c, size, 16);
    umbrage::frustum<double> range = c.frustum;
    range.z_near = seen.least, range.z_far = seen.greatest;
    const glm::ivec2 texels(map_size_);
    const sun_map map = place_map(s.placement,
                                  {.camera = range,
                                   .direction = glm::dvec3(sun(s)),
                                   .receivers = umbrage::intersection(range, scene),
                                   .casters = scene,
                                   .margin = std::max(0.01, 2.0 * double(s.system.reach) / map_size_),
                                   .clip = umbrage::opengl_clip_space},
                                  seen.points,
                                  {.to_pixels = umbrage::texture_matrix<double>(
                                       {glm::dmat4(1), glm::dmat4(c.world_to_clip), example::picture_clip}, size),
                                   .map_size = texels},
                                  kept_);
    draw_layer(s.scene, 0, {{}, map_size_}, c.position, map.light);
    const glm::dmat4 to_texels = glm::translate(umbrage::texture_matrix(map.light, texels), glm::dvec3(c.position));
    camera_->use()
        .set("eye_to_texels", glm::mat4(to_texels))
        .set("plane_matrix", glm::mat4(umbrage::plane_matrix(to_texels)))
        .set("map_size", glm::vec2(texels))
        .set("reach", s.system.reach)
        .set("epsilon", along_light(s, s.system.epsilon));
    note_ = map.note;
}

void outdoor::place_pages(const session& s, const example::camera& c, glm::ivec2 size) {
    const int edge = 2 * s.system.map_size.x;
    const glm::vec2 wanted(edge, s.system.reach);
    if (!pages_ || pages_for_ != wanted) {
        pages_.emplace(edge, s.system.reach);
        pages_for_ = wanted;
    }
    make_layers(pages_->texels(), 1);
    pages_->shine(glm::dvec3(sun(s)), glm::dvec3(fit_of(s, c).up), {s.scene.low, s.scene.high});
    const view seen = look(s.scene, c, size, 4);
    const auto update = pages_->update(
        seen.points, glm::dvec3(c.position),
        umbrage::texture_matrix<double>({glm::dmat4(1), glm::dmat4(c.world_to_clip), example::picture_clip}, size));
    const umbrage::page_size of = pages_->size();
    for (const auto& [page, slot] : update.drawn)
        draw_layer(s.scene, 0, {slot * of.pitch(), of.pitch()}, glm::vec3(0), pages_->light(page));
    glActiveTexture(GL_TEXTURE1);
    const umbrage::image<glm::u8vec4> table = pages_->table();
    if (!update.drawn.empty()) table_ = make_table(table.size(), table.texels().data());
    glBindTexture(GL_TEXTURE_2D, table_);
    glActiveTexture(GL_TEXTURE0);
    const glm::dmat4 to_root = glm::translate(pages_->to_root(), glm::dvec3(c.position));
    const double finest = (table.size().x - 2.0) * of.texels;
    const glm::dmat4 to_finest = glm::scale(glm::dmat4(1), {finest, finest, 1.0}) * to_root;
    camera_->use()
        .set("eye_to_root", glm::mat4(to_root))
        .set("plane_matrix", glm::mat4(umbrage::plane_matrix(to_finest)))
        .set("table", 1)
        .set("table_size", glm::vec2(table.size()))
        .set("page", glm::vec2(of.texels, of.gutter))
        .set("map_size", glm::vec2(static_cast<float>(of.pitch())))
        .set("reach", s.system.reach)
        .set("epsilon", along_light(s, s.system.epsilon));
    note_ = pages_->describe(update);
}

void outdoor::draw(const session& s, GLuint framebuffer, glm::ivec2 size) {
    const example::camera camera = example::make_camera(s.camera);
    const auto update = [](std::optional<program>& p, stages text) {
        if (!p || p->text() != text) p.emplace(std::move(text));
    };
    update(depth_, outdoor_depth_stages(s.placement));
    update(camera_, outdoor_camera_stages(s));
    if (!s.paged()) pages_.reset();
    if (s.paged()) place_pages(s, camera, size);
    else if (s.cascaded()) place_cascades(s, camera);
    else if (s.lamp()) place_lamp(s, camera);
    else place_one(s, camera, size);

    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, size.x, size.y);
    const glm::vec3 sky = s.mask ? glm::vec3(1) : glm::vec3(example::to_srgb(example::sky)) / 255.0f;
    glClearColor(sky.x, sky.y, sky.z, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    const glm::mat4 world_to_clip = opengl(camera.world_to_clip);
    camera_->use()
        .set("world_to_clip", world_to_clip)
        .set("eye", camera.position)
        .set("ahead", glm::vec3(camera.frustum.direction))
        .set("light", s.lamp() ? glm::vec4(s.lamp_position() - camera.position, 1) : glm::vec4(-sun(s), 0))
        .set("ambient", s.system.ambient)
        .set("maps", 0);
    draw_instances(s.scene, world_to_clip, umbrage::opengl_clip_space);
    check_errors("a frame");
}

}  // namespace viewer
