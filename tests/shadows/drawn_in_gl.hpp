// SPDX-License-Identifier: MIT
//
// Up to four numbers of one shader's shadows: OpenGL draws what each says of the same receivers, from blocks that hold
// the bytes of uniforms(), and C++ says it too.
#pragma once

#include <epoxy/gl.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "receivers.hpp"

namespace shadows_in_gl {

using namespace umbrage;
using glsl::version;

inline constexpr glm::ivec2 target_size(512, 64);

/// A texture's texels and how OpenGL takes them.
struct texture_data {
    GLenum kind = GL_TEXTURE_2D;
    GLint internal = GL_R32F;
    GLenum format = GL_RED, type = GL_FLOAT;
    glm::ivec3 size{0, 0, 1};
    const void* texels = nullptr;
    GLenum compares = 0;  ///< the sampler's function
    GLint filter = GL_NEAREST;
};

using shadow_twin = std::function<float(glm::vec3 world, glm::vec3 normal, glm::ivec2 pixel)>;

/// A shadow, its map, and what shaders and C++ say of it.
struct tried {
    std::string name;
    glsl::bound item;
    std::vector<float> block;
    texture_data map;
    shadow_twin twin;
    std::string call;                                ///< call with world, normal and gl_FragCoord
    std::function<float(glm::vec3 world)> within{};  ///< largest error; empty: bit for bit
};

template <class Shadow>
tried make(std::string name, const Shadow& s, glsl::bound item, texture_data map, std::string call, shadow_twin twin) {
    const auto uniforms = s.uniforms();
    std::vector<float> block(sizeof uniforms / sizeof(float));
    std::memcpy(block.data(), &uniforms, sizeof uniforms);
    return {std::move(name), std::move(item), std::move(block), map, std::move(twin), std::move(call)};
}

/// Its visibility.
template <class Shadow>
tried make(std::string name, const Shadow& s, glsl::bound item, texture_data map,
           const image<typename Shadow::texel>& texels) {
    std::string call = "umbrage_" + name + "(world, normal" +
                       (item.declared->functions[0].arguments.size() > 2 ? ", gl_FragCoord.xy)" : ")");
    return make(
        std::move(name), s, std::move(item), map, std::move(call),
        [&s, &texels](glm::vec3 world, glm::vec3 normal, glm::ivec2 pixel) { return s(texels, world, normal, pixel); });
}

/// The maps of an atlas one below the other, as an array's layers lie.
template <class Shadow>
image<float> layers_of(const Shadow& s, const image<float>& atlas) {
    const map_grid grid = std::remove_cvref_t<decltype(s.setup())>::grid;
    const glm::ivec2 size = s.map_size();
    image<float> layers({size.x, size.y * grid.columns * grid.rows});
    for (glm::ivec2 p(0); p.y < layers.size().y; ++p.y)
        for (p.x = 0; p.x < size.x; ++p.x)
            layers[p] = atlas[detail::first_texel(p.y / size.y, grid, size) + glm::ivec2(p.x, p.y % size.y)];
    return layers;
}

inline GLuint upload(const texture_data& t) {
    GLuint id = 0;
    glGenTextures(1, &id);
    glBindTexture(t.kind, id);
    for (const auto filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(t.kind, GLenum(filter), t.filter);
    for (const auto wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        glTexParameteri(t.kind, GLenum(wrap), GL_CLAMP_TO_EDGE);
    if (t.compares != 0) {
        glTexParameteri(t.kind, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        glTexParameteri(t.kind, GL_TEXTURE_COMPARE_FUNC, GLint(t.compares));
    }
    if (t.kind == GL_TEXTURE_2D_ARRAY)
        glTexImage3D(t.kind, 0, t.internal, t.size.x, t.size.y, t.size.z, 0, t.format, t.type, t.texels);
    else glTexImage2D(t.kind, 0, t.internal, t.size.x, t.size.y, 0, t.format, t.type, t.texels);
    return id;
}

inline GLuint compiled(GLenum stage, const std::string& text) {
    const GLuint id = glCreateShader(stage);
    const char* source = text.c_str();
    glShaderSource(id, 1, &source, nullptr);
    glCompileShader(id);
    GLint good = 0;
    glGetShaderiv(id, GL_COMPILE_STATUS, &good);
    char log[4096] = "";
    if (!good) glGetShaderInfoLog(id, sizeof log, nullptr, log), throw std::runtime_error(log);
    return id;
}

/// A program that draws what is said of the receivers in two textures, each in a channel; neighbors may share a shadow.
inline GLuint linked(version v, const std::vector<tried>& all) {
    const bool old = v == version::v100;
    std::vector<glsl::bound> items;
    std::string calls;
    for (const tried& t : all) {
        if (items.empty() || items.back().declared->name != t.name) items.push_back(t.item);
        calls += (calls.empty() ? "" : ", ") + t.call;
    }
    for (std::size_t i = all.size(); i < 4; ++i) calls += ", 0.0";
    const std::string read = old ? "texture2D(" : "texture(";
    const std::string main_text = std::string(old ? "" : "out vec4 color;\n") +
                                  "uniform sampler2D points, normals;\n"
                                  "void main() {\n"
                                  "    vec2 at = gl_FragCoord.xy / vec2(512.0, 64.0);\n"
                                  "    vec3 world = " +
                                  read + "points, at).xyz, normal = " + read + "normals, at).xyz;\n" +
                                  (old ? "    gl_FragColor" : "    color") + " = vec4(" + calls + ");\n}\n";
    const GLuint program = glCreateProgram();
    const std::string corner = old ? "attribute vec2 corner;" : "in vec2 corner;";
    glAttachShader(program, compiled(GL_VERTEX_SHADER, "#version " + std::string(directive(v)) + "\n" + corner +
                                                           "void main() { gl_Position = vec4(corner, 0.0, 1.0); }"));
    glAttachShader(program,
                   compiled(GL_FRAGMENT_SHADER,
                            glsl::source(v, items, old ? "precision highp float;\nprecision highp sampler2D;\n" : "") +
                                main_text));
    glBindAttribLocation(program, 0, "corner");
    glLinkProgram(program);
    GLint good = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &good);
    char log[4096] = "";
    if (!good) glGetProgramInfoLog(program, sizeof log, nullptr, log), throw std::runtime_error(log);
    glUseProgram(program);
    return program;
}

inline void give_uniforms(GLuint program, version v, const std::vector<tried>& all) {
    for (std::size_t i = 0; i < all.size(); ++i) {
        const tried& t = all[i];
        const auto unit = static_cast<GLint>(i + 2);
        const std::string block = "umbrage_" + t.name + "_block", map = "umbrage_" + t.name + "_map";
        glUniform1i(glGetUniformLocation(program, map.c_str()), unit);
        if (v == version::v100) {
            glUniform4fv(glGetUniformLocation(program, block.c_str()), static_cast<GLsizei>(t.block.size() / 4),
                         t.block.data());
            continue;
        }
        const GLuint index = glGetUniformBlockIndex(program, block.c_str());
        GLint size = 0;
        glGetActiveUniformBlockiv(program, index, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
        if (static_cast<std::size_t>(size) != t.block.size() * sizeof(float))
            throw std::runtime_error(block + ": OpenGL has another size than C++");
        GLuint buffer = 0;
        glGenBuffers(1, &buffer);
        glBindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(i), buffer);
        glBufferData(GL_UNIFORM_BUFFER, size, t.block.data(), GL_STATIC_DRAW);
        glUniformBlockBinding(program, index, static_cast<GLuint>(i));
    }
    glUniform1i(glGetUniformLocation(program, "points"), 0);
    glUniform1i(glGetUniformLocation(program, "normals"), 1);
}

/// Draws in one dialect and compares.
/// @return   receivers that differ, of each shadow
inline std::vector<int> compare(version v, const std::vector<tried>& all, const image<glm::vec4>& points,
                                const image<glm::vec4>& normals) {
    const bool bytes = v == version::v100;  // OpenGL ES 2 has no targets of floats
    const glm::ivec3 size(target_size, 1);
    GLuint frame = 0, unit = 0;
    const GLint internal = bytes ? GLint(GL_RGBA) : GL_RGBA32F;
    const auto receivers = [&](const image<glm::vec4>& of) {
        glActiveTexture(GL_TEXTURE0 + unit++);
        upload({GL_TEXTURE_2D, internal, GL_RGBA, GL_FLOAT, size, of.texels().data()});
    };
    receivers(points);
    receivers(normals);
    for (const tried& t : all) glActiveTexture(GL_TEXTURE0 + unit++), upload(t.map);
    glActiveTexture(GL_TEXTURE0 + unit);
    const GLuint color =
        upload({GL_TEXTURE_2D, internal, GL_RGBA, GLenum(bytes ? GL_UNSIGNED_BYTE : GL_FLOAT), size, nullptr});
    glGenFramebuffers(1, &frame);
    glBindFramebuffer(GL_FRAMEBUFFER, frame);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
    give_uniforms(linked(v, all), v, all);
    const float corners[] = {-1, -1, 3, -1, -1, 3};
    GLuint buffer = 0, array = 0;
    if (!bytes) glGenVertexArrays(1, &array), glBindVertexArray(array);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 2, GL_FLOAT, GL_FALSE, 0, nullptr);
    glViewport(0, 0, target_size.x, target_size.y);
    glDisable(GL_DITHER);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    image<glm::vec4> drawn(target_size);
    image<glm::u8vec4> in_bytes(target_size);
    if (bytes) glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, in_bytes.texels().data());
    else glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_FLOAT, drawn.texels().data());
    if (const GLenum error = glGetError()) throw std::runtime_error("OpenGL error " + std::to_string(error));

    std::vector<int> wrong(all.size());
    for (glm::ivec2 p(0); p.y < target_size.y; ++p.y)
        for (p.x = 0; p.x < target_size.x; ++p.x)
            for (std::size_t i = 0; i < all.size(); ++i) {
                const float expected = all[i].twin(glm::vec3(points[p]), glm::vec3(normals[p]), p);
                const auto k = static_cast<glm::length_t>(i);
                if (all[i].within) {
                    wrong[i] += !(std::abs(expected - drawn[p][k]) <= all[i].within(glm::vec3(points[p])));
                    continue;
                }
                wrong[i] += bytes ? std::abs(expected * 255.0f - float(in_bytes[p][k])) > 0.5001f
                                  : std::bit_cast<std::uint32_t>(drawn[p][k]) != std::bit_cast<std::uint32_t>(expected);
            }
    return wrong;
}

}  // namespace shadows_in_gl
