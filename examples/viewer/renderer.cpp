// SPDX-License-Identifier: MIT
#include "renderer.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <umbrage/core/image.hpp>
#include <umbrage/depth/rg_table.hpp>
#include <umbrage/filter/blocker/penumbra.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include <biases.hpp>
#include <names.hpp>
#include <soft.hpp>
#include <srgb.hpp>

#include "parts.hpp"
#include "stored_as.hpp"

namespace viewer {
namespace {

/// Triangles share no vertices here: each has the face's normal, and ES 2 needs no large indices.
struct vertex {
    glm::vec3 position, normal;
    glm::vec3 face_normal;  ///< normal of any length
    glm::vec4 color;        ///< alpha: 1 on the floor
};

/// Compiles when the text is another than last time.
const program& updated(std::optional<program>& p, stages text) {
    if (!p || p->text() != text) p.emplace(std::move(text));
    return p->use();
}

/// The system's epsilon, and what a decoder of others may answer below the depth it was given; twice where depths
/// become z/w, of which texels nearer to the light than the receiver have more a world unit.
float epsilon_of(const example::shadow_system& s) {
    if (s.receiver != example::receiver_kind::plain) return s.epsilon;
    const float one = s.epsilon + encoding_called(s.encoding).below;
    return example::compares_along_plane(s.bias) ? 2 * one : one;
}

umbrage::penumbra_params softness_of(const example::shadow_system& s, const example::light& l, glm::ivec2 map_size) {
    const float radius = 0.5f * s.light_size * s.scene_scale;
    return umbrage::make_penumbra_params(l.space, map_size, l.spot ? radius : radius / (s.distance * s.scene_scale),
                                         1.0f, s.max_radius);
}

void bind(int unit, GLuint texture) {
    glActiveTexture(static_cast<GLenum>(GL_TEXTURE0 + unit));
    glBindTexture(GL_TEXTURE_2D, texture);
}

void clear(glm::vec4 c) {
    glClearColor(c.x, c.y, c.z, c.w);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

}  // namespace

renderer::renderer() : small_({64, 64}, texels_of::bytes) {
    static constexpr auto table = umbrage::make_rg_table<11, glm::u8vec4>();
    table_ = make_table({static_cast<int>(table.size()), 1}, table.data());
    constexpr float strip[] = {0, 0, 0, 1, 1, 0, 1, 1};
    glBindBuffer(GL_ARRAY_BUFFER, corners_);
    glBufferData(GL_ARRAY_BUFFER, sizeof strip, strip, GL_STATIC_DRAW);
}

void renderer::upload(const example::scene& scene, const example::scene& pane) {
    std::vector<vertex> all;
    const auto add = [&](const example::scene& of) {
        const example::mesh& m = of.geometry;
        for (std::size_t i = 0; i < m.triangles.size(); ++i) {
            const glm::uvec3 t = m.triangles[i];
            const glm::vec3 a = m.positions[t.x], b = m.positions[t.y], c = m.positions[t.z];
            const float on_floor = i < of.floor_triangles ? 1 : 0;
            for (int k = 0; k < 3; ++k)
                all.push_back(
                    {m.positions[t[k]], m.normals[t[k]], glm::cross(b - a, c - a), {m.colors[t[k]], on_floor}});
        }
    };
    add(scene);
    vertices_ = static_cast<GLsizei>(all.size());
    add(pane);
    pane_vertices_ = static_cast<GLsizei>(all.size()) - vertices_;
    glBindBuffer(GL_ARRAY_BUFFER, mesh_);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(all.size() * sizeof(vertex)), all.data(), GL_STATIC_DRAW);
}

void renderer::draw_mesh(GLint first, GLsizei count) const {
    glBindBuffer(GL_ARRAY_BUFFER, mesh_);
    attribute_at(position, 3, sizeof(vertex), offsetof(vertex, position));
    attribute_at(normal, 3, sizeof(vertex), offsetof(vertex, normal));
    attribute_at(face_normal, 3, sizeof(vertex), offsetof(vertex, face_normal));
    attribute_at(color, 4, sizeof(vertex), offsetof(vertex, color));
    glDisableVertexAttribArray(corner);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDrawArrays(GL_TRIANGLES, first, count);
}

/// @param pixels   of the rectangle
void renderer::draw_rectangle(const program& p, glm::vec4 place, glm::ivec2 pixels) const {
    p.set("place", place).set("overlay_size", glm::vec2(pixels));
    glBindBuffer(GL_ARRAY_BUFFER, corners_);
    for (GLuint i : {position, normal, face_normal, color}) glDisableVertexAttribArray(i);
    attribute_at(corner, 2, sizeof(glm::vec2), 0);
    glDisable(GL_DEPTH_TEST);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void renderer::draw(const session& s, GLuint framebuffer, glm::ivec2 size) {
    if (s.outdoor()) {
        if (!outdoor_) outdoor_.emplace(s.scene);
        outdoor_->draw(s, framebuffer, size);
        if (s.map && !s.mask) overlay(s, framebuffer, size);
        return;
    }
    if (scene_ != s.scenes) {
        upload(s.scene, example::make_pane(s.system));
        scene_ = s.scenes;
    }
    const glm::ivec2 map_size = s.system.map_size;
    const example::light light = example::make_light(s.system, s.scene, umbrage::opengl_clip_space);
    const texels_of kind = encoding_called(s.system.encoding).texels;
    bind(1, table_);
    bind(0, 0);
    if (!map_ || map_->size != map_size || map_->kind != kind) map_.emplace(map_size, kind);

    depth_pass(s, light);
    bind(0, map_->texels);
    if (example::filters_ahead(s.system.filter)) filter_ahead(s, light);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    camera_pass(s, light, size);
    if (s.map && !s.mask) overlay(s, framebuffer, size);
    check_errors("a frame");
}

void renderer::depth_pass(const session& s, const example::light& l) {
    bind(0, 0);  // the map is drawn to
    glBindFramebuffer(GL_FRAMEBUFFER, map_->framebuffer);
    glViewport(0, 0, map_->size.x, map_->size.y);
    clear(encoding_called(s.system.encoding).cleared);
    updated(depth_, depth_stages(s.system, dialect()))
        .set("light_to_clip", l.world_to_clip())
        .set("world_to_texels", umbrage::texture_matrix(l.space, map_->size))
        .set("planes", glm::vec3(l.z_near, l.z_far, 1 / l.z_far))
        .set("table", 1);
    draw_mesh(0, vertices_);
}

/// Leaves the map bound, and beside it the one of moments or sums.
void renderer::filter_ahead(const session& s, const example::light& l) {
    constexpr glm::vec4 everywhere{-1, 1, 2, 2};
    bind(2, 0);
    for (std::optional<target>* of : {&moments_, &blurred_})
        if (!*of || (*of)->size != map_->size) of->emplace(map_->size, texels_of::moments);
    bind(2, 0);
    glViewport(0, 0, map_->size.x, map_->size.y);
    const auto draw_into = [&](const target& to, const program& p) {
        glBindFramebuffer(GL_FRAMEBUFFER, to.framebuffer);
        p.set("map_size", glm::vec2(map_->size));
        draw_rectangle(p, everywhere, map_->size);
    };
    draw_into(*moments_, updated(write_moments_, moments_stages(s.system, dialect()))
                             .set("map", 0)
                             .set("planes", glm::vec3(l.z_near, l.z_far, 1 / l.z_far)));
    if (const int taps = prefilter_of(s.system)->taps; taps > 1) {
        const program& blur = updated(blur_, blur_stages(dialect(), taps)).set("map", 2);
        bind(2, moments_->texels);
        draw_into(*blurred_, blur.set("along", glm::vec2(0, 1)));
        bind(2, blurred_->texels);
        draw_into(*moments_, blur.set("along", glm::vec2(1, 0)));
    }
    bind(2, moments_->texels);
    moments_size_ = map_->size;
    if (const auto table = summed_table_of(s.system)) {  // by image functions, from the depths as they came out
        umbrage::image<float> depth(map_->size);
        glReadPixels(0, 0, map_->size.x, map_->size.y, GL_RED, GL_FLOAT, depth.texels().data());
        const umbrage::image<glm::u16vec4> sums = table->make(std::as_const(depth).view());
        bind(2, sums_);
        upload_integers(sums.size(), sums.texels().data());
        moments_size_ = sums.size();
    }
}

void renderer::camera_pass(const session& s, const example::light& l, glm::ivec2 size) {
    const example::camera camera = example::make_camera(s.camera);
    const glm::mat4 world_to_texels = umbrage::texture_matrix(l.space, map_->size);
    const example::bias_light bias =
        example::make_bias_light(l.space, l.direction, map_->size, s.system.reach, l.w(s.scene.target));
    glViewport(0, 0, size.x, size.y);
    clear(s.mask ? glm::vec4(1) : glm::vec4(glm::vec3(example::to_srgb(example::sky)) / 255.0f, 1));
    std::array<glm::vec2, 4> offsets = umbrage::default_taps<float>;
    for (glm::vec2& offset : offsets) offset /= glm::vec2(map_->size);
    const auto taps = umbrage::tap_matrices(umbrage::texture_matrix(l.space, {1, 1}), offsets);
    const program& p = updated(camera_, camera_stages(s.system, dialect(), s.mask));
    p.set("world_to_clip", opengl(camera.world_to_clip))
        .set("eye", camera.position)
        .set("light_direction", l.direction)
        .set("light_position", glm::vec4(l.position, l.spot ? 1 : 0))
        .set("cos_outer", l.cos_outer)
        .set("units", bias.units)
        .set("plane_matrix", bias.planes)
        .set("reach", bias.reach)
        .set("constant", bias.constant)
        .set("softness", glm::vec4(softness_of(s.system, l, map_->size)))
        .set("epsilon", epsilon_of(s.system))
        .set("ambient", s.system.ambient)
        .set("planes", glm::vec3(l.z_near, l.z_far, 1 / l.z_far))
        .set("world_to_texels", world_to_texels)
        .set("taps", taps.front(), 4)
        .set("map", 0)
        .set("moments", 2)
        .set("map_size", glm::vec2(map_->size))
        .set("moments_size", glm::vec2(moments_size_))
        .set("table", 1)
        .set("alpha", 1.0f);
    draw_mesh(0, vertices_);
    if (s.system.glass == 0 || s.mask) return;
    p.set("alpha", s.system.glass);  // a translucent receiver, last
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    draw_mesh(vertices_, pane_vertices_);
    glDisable(GL_BLEND);
}

/// The map, or the outdoor ones as tiles, as the program shows it.
void renderer::draw_map(const session& s, const program& p, glm::vec4 place, glm::ivec2 pixels) const {
    p.set("map", 0).set("map_size", glm::vec2(s.outdoor() ? glm::ivec2(outdoor_->map_size()) : map_->size));
    if (s.outdoor()) p.set("tiles", outdoor_->tiles());
    draw_rectangle(p, place, pixels);
}

umbrage::contrast_stretch renderer::stretch(const session& s) {
    glBindFramebuffer(GL_FRAMEBUFFER, small_.framebuffer);
    glViewport(0, 0, small_.size.x, small_.size.y);
    draw_map(s, updated(read_back_, read_back_stages(s.system, dialect(), s.outdoor())), {-1, 1, 2, 2}, small_.size);
    umbrage::image<glm::u8vec4> bytes(small_.size);
    glReadPixels(0, 0, small_.size.x, small_.size.y, GL_RGBA, GL_UNSIGNED_BYTE, bytes.texels().data());
    umbrage::image<float> depth(small_.size);
    for (std::size_t i = 0; i < depth.texels().size(); ++i)
        depth.texels()[i] = umbrage::decode_rgb24(glm::u8vec3(bytes.texels()[i]), umbrage::upper_edge<float>);
    return umbrage::stretch(depth);
}

void renderer::overlay(const session& s, GLuint framebuffer, glm::ivec2 size) {
    const auto [low, high] = stretch(s);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, size.x, size.y);
    const glm::vec2 tiles = s.outdoor() ? outdoor_->tiles() : glm::vec2(1);
    const glm::vec2 spread(std::sqrt(tiles.x / tiles.y), std::sqrt(tiles.y / tiles.x));
    const glm::ivec2 pixels(glm::vec2(example::overlay_size(s.system.map_size, size.y)) * spread);
    const program& p = updated(overlay_, overlay_stages(s.system, dialect(), s.outdoor()));
    p.set("low", low).set("high", high);
    draw_map(s, p, {-1, 1, 2.0f * glm::vec2(pixels) / glm::vec2(size)}, pixels);
    check_errors("the map's picture");
}

}  // namespace viewer
