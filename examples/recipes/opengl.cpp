// SPDX-License-Identifier: MIT
//
// OpenGL 3.3: a spot light's map in a depth texture, a sun's cascades in an array under a comparison sampler, a fence
// with holes.    opengl PICTURE.png [SPOT_MAP.floats]
#include <epoxy/gl.h>

#include <cstdio>
#include <string>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "scene.hpp"
#include "window.hpp"

namespace {

namespace glsl = umbrage::glsl;
constexpr int side = 1024;  // side of a map, texels

GLuint made(void (*make)(GLsizei, GLuint*)) {
    GLuint name = 0;
    make(1, &name);
    return name;
}

GLuint depth_texture(GLenum kind, int layers, GLenum compares) {
    const GLuint map = made(glGenTextures);
    glBindTexture(kind, map);
    if (layers == 1) glTexImage2D(kind, 0, GL_DEPTH_COMPONENT32F, side, side, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    else glTexImage3D(kind, 0, GL_DEPTH_COMPONENT32F, side, side, layers, 0, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    glTexParameteri(kind, GL_TEXTURE_MIN_FILTER, GL_NEAREST);  // the default would need mipmaps
    glTexParameteri(kind, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(kind, GL_TEXTURE_COMPARE_MODE, GLint(compares));
    return map;
}

GLuint program(const std::string& fragment) {
    const std::string vertex = R"(#version 330
        layout(location = 0) in vec3 position;
        layout(location = 1) in vec3 vertex_normal;  layout(location = 2) in vec2 vertex_uv;
        uniform mat4 to_clip;
        out vec3 world, normal;  out vec2 uv;
        void main() {
            gl_Position = to_clip * vec4(position, 1.0), world = position, normal = vertex_normal, uv = vertex_uv;
        })";
    const GLuint id = glCreateProgram();
    for (const auto& [stage, text] : {std::pair(GL_VERTEX_SHADER, &vertex), std::pair(GL_FRAGMENT_SHADER, &fragment)}) {
        const GLuint shader = glCreateShader(GLenum(stage));
        const char* source = text->c_str();
        glShaderSource(shader, 1, &source, nullptr), glCompileShader(shader), glAttachShader(id, shader);
    }
    glLinkProgram(id), glUseProgram(id);
    GLchar log[4096] = "";
    glGetProgramInfoLog(id, sizeof log, nullptr, log);
    std::fputs(log, stderr);
    return id;
}

void draw(GLuint with, const glm::mat4& to_clip, GLsizei vertices) {
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUniformMatrix4fv(glGetUniformLocation(with, "to_clip"), 1, GL_FALSE, &to_clip[0][0]);
    glDrawArrays(GL_TRIANGLES, 0, vertices);
}

/// Gives a program the block of a shadow; its map is bound to the texture unit of the same number.
void give(GLuint to, const std::string& shadow, const auto& block, GLuint number) {
    glBindBufferBase(GL_UNIFORM_BUFFER, number, made(glGenBuffers));
    glBufferData(GL_UNIFORM_BUFFER, sizeof block, &block, GL_DYNAMIC_DRAW);
    glUniformBlockBinding(to, glGetUniformBlockIndex(to, (shadow + "_block").c_str()), number);
    glUniform1i(glGetUniformLocation(to, (shadow + "_map").c_str()), GLint(number));
}

}  // namespace

int main(int argc, char** argv) {
    const window window(false);
    glEnable(GL_DEPTH_TEST);

    constexpr auto clip = umbrage::opengl_clip_space;
    const umbrage::shadow spot(scene::make_spot(clip), {side, side}, umbrage::filters::tent<3>);
    const umbrage::shadow sun(scene::make_cascades(clip), {side, side}, umbrage::filters::tent<3>);
    glActiveTexture(GL_TEXTURE1);
    const GLuint sun_maps = depth_texture(GL_TEXTURE_2D_ARRAY, 3, GL_COMPARE_REF_TO_TEXTURE);
    glActiveTexture(GL_TEXTURE0);
    const GLuint spot_map = depth_texture(GL_TEXTURE_2D, 1, GL_NONE);

    const GLuint depth_pass =
        program("#version 330\nin vec2 uv;\n" + scene::shading + "void main() { if (is_hole(uv)) discard; }");
    glBindFramebuffer(GL_FRAMEBUFFER, made(glGenFramebuffers));
    glDrawBuffer(GL_NONE), glReadBuffer(GL_NONE), glViewport(0, 0, side, side);
    glFramebufferTexture(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, spot_map, 0);
    const auto light = spot.setup().lights()[0];
    draw(depth_pass, glm::mat4(light.projection * light.view), window.vertices());
    GLint layer = 0;
    for (const auto& cascade : sun.setup().lights()) {
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, sun_maps, 0, layer++);
        draw(depth_pass, glm::mat4(cascade.projection * cascade.view), window.vertices());
    }

    const GLuint view =
        program(glsl::source(glsl::version::v330, {glsl::bind(spot, "spot", {.map = glsl::texture::depth}),
                                                   glsl::bind(sun, "sun", {.map = glsl::texture::shadow_array})}) +
                scene::shading + R"(
        in vec3 world, normal;  in vec2 uv;
        out vec4 color;
        void main() {
            if (is_hole(uv)) discard;
            color = vec4(shade(world, normal, umbrage_spot(world, normal), umbrage_sun(world, normal)), 1.0);
        })");
    give(view, "umbrage_spot", spot.uniforms(), 0), give(view, "umbrage_sun", sun.uniforms(), 1);
    window.bind();
    draw(view, scene::camera_matrix(clip), window.vertices());

    window.write_picture(argv[1]);
    if (argc < 3) return 0;
    std::vector<float> map(side * side);  // the spot light's, to compare
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, map.data());
    scene::write_floats(argv[2], map);
}
