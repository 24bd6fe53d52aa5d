// SPDX-License-Identifier: MIT
//
// A window, and its keys and mouse made into calls on the session.
//
//     viewer::window window(session, {960, 640});
//     while (window.open()) { ...; window.show(); }
//
#pragma once

#include <glm/vec2.hpp>

#include "session.hpp"

struct GLFWwindow;

namespace viewer {

class window {
public:
    /// OpenGL is current from here on: 3.3 core, or ES 2 where the session says so.
    /// @throws std::runtime_error  no display, no OpenGL: the reason
    window(session& s, glm::ivec2 size);
    ~window();
    window(const window&) = delete;
    window& operator=(const window&) = delete;

    [[nodiscard]] bool open() const;
    [[nodiscard]] glm::ivec2 size() const;  ///< in pixels; 0 when iconified
    [[nodiscard]] bool wants_screenshot();  ///< once for each press of P
    void show();                            ///< the frame, and whatever keys and mouse did meanwhile

private:
    void key_pressed(int key, int modifiers);
    void dragged(glm::dvec2 to);

    session& session_;
    GLFWwindow* handle_ = nullptr;
    glm::dvec2 cursor_{0};
    bool screenshot_ = false;
};

}  // namespace viewer
