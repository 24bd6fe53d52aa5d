// SPDX-License-Identifier: MIT
//
// The outdoor scene on OpenGL 3.3: instances, drawn into a layer of depth for each of a sun's cascades or into
// the one map in their place, and the camera's pass, which looks them up. Each pass draws what its matrix can see.
//
//     viewer::outdoor outdoor(session.scene);          // a context is current
//     outdoor.draw(session, framebuffer, {960, 640});
//
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <umbrage/light/bounds.hpp>
#include <umbrage/light/light_choice.hpp>

#include <camera.hpp>
#include <scene.hpp>

#include "gl.hpp"
#include "pages.hpp"
#include "placement.hpp"
#include "session.hpp"

namespace viewer {

class outdoor {
public:
    explicit outdoor(const example::scene& scene);
    void draw(const session& s, GLuint framebuffer, glm::ivec2 size);

    // Maps of the last picture, left bound as layers, and a description of their placement for people.
    [[nodiscard]] int map_size() const { return map_size_; }
    /// Layers side by side and above each other, in a picture of all.
    [[nodiscard]] glm::vec2 tiles() const {
        const float across = std::ceil(std::sqrt(static_cast<float>(layers_)));
        return {across, static_cast<float>(layers_) / across};
    }
    [[nodiscard]] const std::string& note() const { return note_; }

private:
    /// Position of a shape in the buffers.
    struct shape {
        umbrage::bounding_box<float> bounds;
        std::size_t first_index, indices;
        GLint first_vertex;
    };
    /// Points that a camera sees, and their range of distances along its axis.
    struct view {
        std::vector<umbrage::seen_point> points;  ///< points of some of the pixels
        double least, greatest;
    };
    void draw_instances(const example::scene& scene, const glm::mat4& world_to_clip, umbrage::clip_space clip) const;
    /// Square of a map's texels.
    struct square {
        glm::ivec2 corner;
        int edge;
    };
    void clear_layer(int layer, const square& where);
    void draw_depths(const example::scene& scene, glm::vec3 eye, const umbrage::light_space<double>& light) const;
    void draw_layer(const example::scene& scene, int layer, const square& where, glm::vec3 eye,
                    const umbrage::light_space<double>& light);
    void make_layers(int edge, int count);
    [[nodiscard]] view look(const example::scene& scene, const example::camera& c, glm::ivec2 size, int step);
    void place_cascades(const session& s, const example::camera& c);
    void place_one(const session& s, const example::camera& c, glm::ivec2 size);
    void place_pages(const session& s, const example::camera& c, glm::ivec2 size);
    void place_lamp(const session& s, const example::camera& c);

    /// The scene, cut for a lamp's paraboloids.
    struct cut_scene {
        glm::vec4 of;  ///< the lamp's position; texels
        handle<buffer_kind> vertices{}, indices{};
        GLsizei count = 0;
    };
    void cut(const example::scene& scene, glm::vec3 position, float range, const lamp_maps& maps);
    void draw_cut(glm::vec3 position, const umbrage::light_space<double>& light) const;

    handle<buffer_kind> vertices_, indices_, places_;
    handle<texture_kind> maps_, table_;
    handle<framebuffer_kind> layer_;
    int map_size_ = 0, layers_ = 0;
    std::string note_;
    std::size_t kept_ = 0;  ///< see place_map
    std::optional<sun_pages> pages_;
    glm::vec2 pages_for_{0};  ///< texels, reach
    std::vector<shape> shapes_;
    program look_;
    std::optional<program> depth_, camera_;
    std::optional<cut_scene> cut_;
    std::optional<target> seen_;
};

}  // namespace viewer
