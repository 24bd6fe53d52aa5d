// SPDX-License-Identifier: MIT
//
// A frame: the light's pass into the map, the camera's pass, the map in the corner.
//
//     viewer::renderer renderer;                       // a context is current
//     renderer.draw(session, framebuffer, {960, 640});
//
#pragma once

#include <optional>
#include <string>

#include <umbrage/debug/overlay.hpp>

#include "gl.hpp"
#include "outdoor.hpp"
#include "session.hpp"

namespace viewer {

class renderer {
public:
    renderer();
    void draw(const session& s, GLuint framebuffer, glm::ivec2 size);

    /// A line for people on how the last picture's map was placed; empty where that is always the same.
    [[nodiscard]] std::string note(const session& s) const {
        return s.outdoor() && outdoor_ && !outdoor_->note().empty() ? outdoor_->note() + '\n' : "";
    }

private:
    void upload(const example::scene& scene, const example::scene& pane);
    void draw_mesh(GLint first, GLsizei count) const;
    void draw_rectangle(const program& p, glm::vec4 place, glm::ivec2 pixels) const;
    void depth_pass(const session& s, const example::light& l);
    void filter_ahead(const session& s, const example::light& l);
    void camera_pass(const session& s, const example::light& l, glm::ivec2 size);
    void draw_map(const session& s, const program& p, glm::vec4 place, glm::ivec2 pixels) const;
    void overlay(const session& s, GLuint framebuffer, glm::ivec2 size);
    [[nodiscard]] umbrage::contrast_stretch stretch(const session& s);

    handle<buffer_kind> mesh_, corners_;
    handle<texture_kind> table_;  ///< 11 bits of depth in two channels, 2048 x 1
    GLsizei vertices_ = 0, pane_vertices_ = 0;
    int scene_ = 0;  ///< the one in mesh_
    std::optional<target> map_, moments_, blurred_;
    handle<texture_kind> sums_;  ///< a summed-area table in place of moments_
    glm::ivec2 moments_size_{};  ///< size of the moments that are looked up
    target small_;               ///< for reading the map back
    std::optional<program> depth_, write_moments_, blur_, camera_, overlay_, read_back_;
    std::optional<outdoor> outdoor_;
};

}  // namespace viewer
