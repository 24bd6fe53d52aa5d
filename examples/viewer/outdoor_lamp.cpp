// SPDX-License-Identifier: MIT
#include <array>
#include <cstddef>
#include <string>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <umbrage/bias/slope.hpp>
#include <umbrage/draw/tessellate.hpp>
#include <umbrage/light/point/dual_paraboloid.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "outdoor.hpp"

namespace viewer {
namespace {

constexpr float distance_error = 1.0f / 16384;  ///< error of distances in a cut mesh, over the range

}  // namespace

void outdoor::cut(const example::scene& scene, glm::vec3 position, float range, const lamp_maps& maps) {
    const glm::vec4 of(position, maps.size);
    if (cut_ && cut_->of == of) return;
    const auto mesh = umbrage::tessellate(view_of(scene.geometry),
                                          {.position = position,
                                           .angle = umbrage::paraboloid_edge_angle<float>(maps.size, maps.border),
                                           .range = range,
                                           .depth_error = distance_error});
    cut_.emplace(cut_scene{of});
    cut_->count = static_cast<GLsizei>(3 * mesh.triangles.size());
    const auto fill = [](GLenum kind, GLuint buffer, const auto& all) {
        glBindBuffer(kind, buffer);
        glBufferData(kind, static_cast<GLsizeiptr>(all.size() * sizeof all[0]), all.data(), GL_STATIC_DRAW);
    };
    fill(GL_ARRAY_BUFFER, cut_->vertices, mesh.positions);
    fill(GL_ELEMENT_ARRAY_BUFFER, cut_->indices, mesh.triangles);
}

void outdoor::draw_cut(glm::vec3 position, const umbrage::light_space<double>& light) const {
    depth_->use().set("eye", position).set("world_to_clip", glm::mat4(light.projection));
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, cut_->indices);
    glBindBuffer(GL_ARRAY_BUFFER, cut_->vertices);
    attribute_at(viewer::position, 3, sizeof(glm::vec3), 0);
    for (const GLuint unused : {normal, color, face_normal, corner}) glDisableVertexAttribArray(unused);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_CLIP_DISTANCE0);  // behind its map a paraboloid has no picture
    glDrawElements(GL_TRIANGLES, cut_->count, GL_UNSIGNED_INT, nullptr);
    glDisable(GL_CLIP_DISTANCE0);
}

void outdoor::place_lamp(const session& s, const example::camera& c) {
    const glm::vec3 at = s.lamp_position();
    const float range = glm::length(glm::max(glm::abs(s.scene.low - at), glm::abs(s.scene.high - at)));
    const lamp_maps maps = viewer::place_lamp(s.placement, at, range, 2 * s.system.map_size.x, s.system.reach);
    make_layers(maps.size, maps.layers);
    if (s.placement == in_paraboloids) cut(s.scene, at, range, maps);
    depth_->use().set("map_size", glm::vec2(static_cast<float>(map_size_)));
    std::array<glm::mat4, 6> to_texels, planes;
    for (std::size_t i = 0; i < maps.passes.size(); ++i) {
        const auto& pass = maps.passes[i];
        if (static_cast<int>(i) < layers_) clear_layer(static_cast<int>(i), {{}, map_size_});
        depth_->use().set("face", static_cast<float>(i));
        s.placement == in_paraboloids ? draw_cut(at, pass) : draw_depths(s.scene, at, pass);
        const glm::dmat4 from_eye =
            glm::translate(umbrage::texture_matrix(pass, glm::ivec2(map_size_)), glm::dvec3(c.position));
        to_texels[i] = glm::mat4(from_eye);
        planes[i] = glm::mat4(umbrage::plane_matrix(from_eye));
    }
    const auto count = static_cast<int>(maps.passes.size());
    camera_->use()
        .set("eye_to_texels", to_texels.front(), count)
        .set("plane_matrix", planes.front(), count)
        .set("map_size", glm::vec2(static_cast<float>(map_size_)))
        .set("border", static_cast<float>(maps.border))
        .set("range", range)
        .set("error", distance_error)
        .set("reach", s.system.reach)
        .set("epsilon", range * s.system.epsilon);
    const std::string edge = std::to_string(map_size_);
    note_ = s.placement + ": " + edge + " x " + edge + (layers_ > 1 ? " texels each" : " texels");
}

}  // namespace viewer
