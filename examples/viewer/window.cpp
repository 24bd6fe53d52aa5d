// SPDX-License-Identifier: MIT
#include "window.hpp"

#include <cctype>
#include <stdexcept>
#include <string>
#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace viewer {
namespace {

std::string last_error;

window& of(GLFWwindow* w) { return *static_cast<window*>(glfwGetWindowUserPointer(w)); }

}  // namespace

window::window(session& s, glm::ivec2 size) : session_(s) {
    glfwSetErrorCallback([](int, const char* text) { last_error = text; });
    if (!glfwInit()) throw std::runtime_error("no window: " + last_error + " (--headless needs none)");
    if (s.es2) {
        glfwWindowHint(GLFW_CLIENT_API, GLFW_OPENGL_ES_API);
        glfwWindowHint(GLFW_CONTEXT_CREATION_API, GLFW_EGL_CONTEXT_API);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 2);
    } else {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
        glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    }
    handle_ = glfwCreateWindow(size.x, size.y, "umbrage viewer", nullptr, nullptr);
    if (!handle_) {
        glfwTerminate();
        throw std::runtime_error(std::string("no OpenGL ") + (s.es2 ? "ES 2" : "3.3") + " window: " + last_error);
    }
    glfwMakeContextCurrent(handle_);
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(handle_, this);
    glfwSetKeyCallback(handle_, [](GLFWwindow* w, int code, int, int action, int modifiers) {
        if (action != GLFW_RELEASE) of(w).key_pressed(code, modifiers);
    });
    glfwSetCursorPosCallback(handle_, [](GLFWwindow* w, double x, double y) { of(w).dragged({x, y}); });
    glfwSetScrollCallback(handle_, [](GLFWwindow* w, double, double y) { of(w).session_.zoom(static_cast<float>(y)); });
}

window::~window() {
    glfwDestroyWindow(handle_);
    glfwTerminate();
}

bool window::open() const { return !glfwWindowShouldClose(handle_); }

glm::ivec2 window::size() const {
    glm::ivec2 pixels;
    glfwGetFramebufferSize(handle_, &pixels.x, &pixels.y);
    return pixels;
}

bool window::wants_screenshot() { return std::exchange(screenshot_, false); }

void window::show() {
    glfwSwapBuffers(handle_);
    glfwPollEvents();
}

void window::key_pressed(int code, int modifiers) {
    switch (code) {
        case GLFW_KEY_ESCAPE: glfwSetWindowShouldClose(handle_, GLFW_TRUE); return;
        case GLFW_KEY_P: screenshot_ = true; return;
        case GLFW_KEY_LEFT: session_.press(key::left); return;
        case GLFW_KEY_RIGHT: session_.press(key::right); return;
        case GLFW_KEY_UP: session_.press(key::up); return;
        case GLFW_KEY_DOWN: session_.press(key::down); return;
        case GLFW_KEY_KP_ADD: session_.press('+'); return;
        case GLFW_KEY_KP_SUBTRACT: session_.press('-'); return;
        default: break;
    }
    // By what is printed on the key, whatever the keyboard's layout.
    const char* name = glfwGetKeyName(code, 0);
    if (!name || name[1] != '\0' || (modifiers & (GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER))) return;
    const char printed = name[0] == '=' ? '+' : name[0];  // the same key, unshifted, where '+' needs shift
    session_.press(std::toupper(static_cast<unsigned char>(printed)));
}

void window::dragged(glm::dvec2 to) {
    constexpr double degrees_per_pixel = 0.4;
    const glm::vec2 by((to - cursor_) * degrees_per_pixel);
    cursor_ = to;
    const auto held = [&](int button) { return glfwGetMouseButton(handle_, button) == GLFW_PRESS; };
    if (held(GLFW_MOUSE_BUTTON_LEFT)) session_.turn_camera(-by.x, by.y);
    if (held(GLFW_MOUSE_BUTTON_RIGHT)) session_.turn_light(by.x, -by.y);
}

}  // namespace viewer
