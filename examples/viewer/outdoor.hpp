// SPDX-License-Identifier: MIT
//
// The outdoor scene on OpenGL 3.3: instances, drawn into a layer of depth for each of a sun's cascades, and the
// camera's pass, which chooses between them. Each pass draws what its matrix can see.
//
//     viewer::outdoor outdoor(session.scene);          // a context is current
//     outdoor.draw(session, framebuffer, {960, 640});
//
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <umbrage/light/bounds.hpp>

#include <scene.hpp>

#include "gl.hpp"
#include "session.hpp"

namespace viewer {

class outdoor {
public:
    explicit outdoor(const example::scene& scene);
    void draw(const session& s, GLuint framebuffer, glm::ivec2 size);

private:
    /// Where a shape lies in the buffers.
    struct shape {
        umbrage::bounding_box<float> bounds;
        std::size_t first_index, indices;
        GLint first_vertex;
    };
    void draw_instances(const example::scene& scene, const glm::mat4& world_to_clip, umbrage::clip_space clip) const;

    handle<buffer_kind> vertices_, indices_, places_;
    handle<texture_kind> maps_;
    handle<framebuffer_kind> layer_;
    int map_size_ = 0;
    std::vector<shape> shapes_;
    program depth_;
    std::optional<program> camera_;
};

}  // namespace viewer
