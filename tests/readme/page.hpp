// SPDX-License-Identifier: MIT
//
// Context of the pages' code: the functions that its tests call. Its names are the page's own.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include <umbrage/umbrage.hpp>

/// For pages whose code goes on from another's.
namespace of_a_scene {

namespace glsl = umbrage::glsl;

// The scene of README.md: a floor and a square above it.
inline const std::vector<glm::vec3> vertices{{-4, 0, -4}, {4, 0, -4}, {4, 0, 4}, {-4, 0, 4},
                                             {-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}};
inline const std::vector<glm::uvec3> triangles{{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}};
inline const umbrage::mesh_view mesh{vertices, triangles};
inline const umbrage::bounding_box<float> scene{{-4, 0, -4}, {4, 1, 4}};
inline const umbrage::frustum<float> camera{.position = {0, 2, 8},
                                            .direction = {0, -1, -4},
                                            .tan_half_x = 0.8f,
                                            .tan_half_y = 0.5f,
                                            .z_near = 0.5f,
                                            .z_far = 30};

// A point of the floor below the square, and one beside it.
inline const glm::vec3 below{-0.7f, 0, -1}, beside{2, 0, 2}, up{0, 1, 0};

inline const auto light = umbrage::make_spot_light(
    {.position = {2, 6, 3}, .direction = {-2, -6, -3}, .z_near = 1, .z_far = 20, .clip = umbrage::opengl_clip_space});
inline const umbrage::shadow spot(light, {1024, 1024}, umbrage::filters::tent<3>);

/// A map of that light, drawn.
inline umbrage::image<float> drawn_map() {
    umbrage::image<float> depths({1024, 1024}, umbrage::cleared_depth(light.clip));
    umbrage::rasterize_depth(depths, mesh, light.projection * light.view, light.clip);
    return depths;
}
inline const umbrage::image<float> map = drawn_map();

}  // namespace of_a_scene

using page_code = void (*)();

/// Code of every page, by the page's name.
inline std::map<std::string, page_code>& pages() {
    static std::map<std::string, page_code> all;
    return all;
}
inline bool add(const char* page, page_code run) { return pages().emplace(page, run).second; }

inline std::filesystem::path shaders;  ///< where shaders go
inline int wrong = 0;

inline void expect(bool met, const char* what) {
    if (!met && wrong++ == 0) std::cerr << "not so: " << what << '\n';
}

inline void shader(const std::string& name, const std::string& text) {
    std::filesystem::create_directories(shaders);
    const bool vertex = text.find("gl_Position") != text.npos;
    std::ofstream(shaders / (name + (vertex ? ".vert" : ".frag"))) << text;
}

/// A text that a reader pastes below the snippets which it calls.
inline void pasted(const std::string& name, const std::string& text) {
    std::vector<umbrage::glsl::bound> called;
    for (const umbrage::glsl::snippet* s : umbrage::glsl::registry())
        if (std::regex_search(text, std::regex("umbrage_" + std::string(s->name) + "\\("))) called.push_back(*s);
    expect(!called.empty(), "a page's GLSL calls a snippet");
    const bool whole = text.find("void main()") != text.npos;
    shader(name,
           umbrage::glsl::source(umbrage::glsl::version::v330, called) + text + (whole ? "" : "void main() {}\n"));
}
