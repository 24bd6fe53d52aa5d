// SPDX-License-Identifier: MIT
//
// What a function of a shader returns on this machine's GPU, by OpenGL 3.3 without a window.
#pragma once

#include <epoxy/gl.h>

#include <stdexcept>
#include <string>
#include <vector>

#include <umbrage/core/image.hpp>

#include "../viewer/headless.hpp"

namespace detail {

/// A texture of floats under the texture unit of its number.
inline GLuint texture(GLuint unit, GLint format, glm::ivec2 size, GLenum channels, const void* texels) {
    GLuint name = 0;
    glGenTextures(1, &name), glActiveTexture(GL_TEXTURE0 + unit), glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, format, size.x, size.y, 0, channels, GL_FLOAT, texels);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);  // the default would need mipmaps
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return name;
}

inline void attach(GLuint program, GLenum stage, const std::string& text) {
    const GLuint shader = glCreateShader(stage);
    const char* source = text.c_str();
    glShaderSource(shader, 1, &source, nullptr), glCompileShader(shader), glAttachShader(program, shader);
    char words[4096] = "";
    glGetShaderInfoLog(shader, sizeof words, nullptr, words);
    GLint compiles = 0;
    glGetShaderiv(shader, GL_COMPILE_STATUS, &compiles);
    if (!compiles) throw std::runtime_error("your function does not compile:\n" + std::string(words));
}

}  // namespace detail

/// @param function   GLSL 330. The compiler's messages count its lines
/// @param call       of `map`, a sampler2D, and `point`, a vec3
/// @param map        depths, sampled at the nearest texel
/// @return           one float for each input
/// @throws std::runtime_error   the compiler's words; or why there is no OpenGL here
inline std::vector<float> on_gpu(const std::string& function, const std::string& call, const umbrage::image<float>& map,
                                 const std::vector<glm::vec3>& inputs) {
    const viewer::headless context(false);
    constexpr int width = 256;  // of the textures of inputs and results
    std::vector<glm::vec3> padded = inputs;
    const glm::ivec2 size(width, (static_cast<int>(inputs.size()) + width - 1) / width);
    padded.resize(static_cast<std::size_t>(size.x * size.y));

    const GLuint program = glCreateProgram();
    detail::attach(program, GL_VERTEX_SHADER, R"(#version 330
        void main() { gl_Position = vec4(gl_VertexID % 2 * 4 - 1, gl_VertexID / 2 * 4 - 1, 0, 1); })");
    detail::attach(program, GL_FRAGMENT_SHADER,
                   "#version 330\n#line 1\n" + function + R"(
        uniform sampler2D map, inputs;
        out float result;
        void main() { vec3 point = texelFetch(inputs, ivec2(gl_FragCoord), 0).xyz; result = )" +
                       call + "; }");
    glLinkProgram(program), glUseProgram(program);
    glUniform1i(glGetUniformLocation(program, "inputs"), 1);
    detail::texture(0, GL_R32F, map.size(), GL_RED, map.texels().data());
    detail::texture(1, GL_RGB32F, size, GL_RGB, padded.data());

    GLuint vertices = 0, target = 0;
    glGenVertexArrays(1, &vertices), glBindVertexArray(vertices);
    glGenFramebuffers(1, &target), glBindFramebuffer(GL_FRAMEBUFFER, target);
    glFramebufferTexture(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, detail::texture(2, GL_R32F, size, GL_RED, nullptr), 0);
    glViewport(0, 0, size.x, size.y);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    std::vector<float> results(padded.size());
    glReadPixels(0, 0, size.x, size.y, GL_RED, GL_FLOAT, results.data());
    results.resize(inputs.size());
    return results;
}
