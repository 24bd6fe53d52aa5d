// SPDX-License-Identifier: MIT
//
// OpenGL ES 2, without depth textures and arrays: depths in three bytes, a sun's cascades in an atlas, a fence with
// holes.    opengl_es2 PICTURE.png
#include <epoxy/gl.h>

#include <cstdio>
#include <string>

#include <umbrage/umbrage.hpp>

#include "scene.hpp"
#include "window.hpp"

namespace {

namespace glsl = umbrage::glsl;
constexpr auto es2 = glsl::version::v100;
constexpr auto precision = "precision highp float;\n";

GLuint made(void (*make)(GLsizei, GLuint*)) {
    GLuint name = 0;
    make(1, &name);
    return name;
}

/// @param place   call of a vertex function, of to_clip, position, and anchor
GLuint program(const std::string& head, const std::string& place, const std::string& fragment) {
    const std::string vertex = head + R"(
        attribute vec3 position, vertex_normal;
        attribute vec2 vertex_uv;
        uniform mat4 to_clip;
        uniform vec4 anchor;
        varying highp vec3 world, normal;  varying highp vec2 uv, clip_depth;
        void main() {
            gl_Position = )" + place +
                               R"(, clip_depth = gl_Position.zw;
            world = position, normal = vertex_normal, uv = vertex_uv;
        })";
    const GLuint id = glCreateProgram();
    for (const auto& [stage, text] : {std::pair(GL_VERTEX_SHADER, &vertex), std::pair(GL_FRAGMENT_SHADER, &fragment)}) {
        const GLuint shader = glCreateShader(GLenum(stage));
        const char* source = text->c_str();
        glShaderSource(shader, 1, &source, nullptr), glCompileShader(shader), glAttachShader(id, shader);
    }
    GLuint attribute = 0;
    for (const char* name : {"position", "vertex_normal", "vertex_uv"}) glBindAttribLocation(id, attribute++, name);
    glLinkProgram(id), glUseProgram(id);
    GLchar log[4096] = "";
    glGetProgramInfoLog(id, sizeof log, nullptr, log);
    std::fputs(log, stderr);
    return id;
}

void draw(GLuint with, const glm::mat4& to_clip, GLsizei vertices) {
    glUniformMatrix4fv(glGetUniformLocation(with, "to_clip"), 1, GL_FALSE, &to_clip[0][0]);
    glDrawArrays(GL_TRIANGLES, 0, vertices);
}

/// Draws all maps of a shadow, each into its tile of a texture, which is bound to a texture unit from here on.
void draw_maps(const auto& shadow, GLuint unit, GLsizei vertices) {
    const GLuint depth_pass = program(
        glsl::source(es2, {glsl::bind_vertex_pass(shadow, "map")}), "umbrage_vertex_map(to_clip, position, anchor)",
        glsl::source(es2, {glsl::bind_depth_pass(shadow, "map")}, precision) + scene::shading + R"(
        varying vec2 uv, clip_depth;  // in place of gl_FragCoord.z, which is mediump
        void main() {
            if (is_hole(uv)) discard;
            gl_FragColor = umbrage_write_map(clip_depth.x / clip_depth.y * 0.5 + 0.5);
        })");
    const glm::ivec2 size = shadow.size(), tile = shadow.map_size();
    const GLuint map = made(glGenTextures);
    glActiveTexture(GL_TEXTURE0 + unit), glBindTexture(GL_TEXTURE_2D, map);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, size.x, size.y, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, made(glGenFramebuffers));
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, map, 0);
    const GLuint depths = made(glGenRenderbuffers);
    glBindRenderbuffer(GL_RENDERBUFFER, depths);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT16, size.x, size.y);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depths);
    const glm::vec3 far_plane = glm::vec3(shadow.cleared()) / 255.0f;
    glClearColor(far_plane.r, far_plane.g, far_plane.b, 1), glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    int number = 0;
    for (const auto& view : shadow.depth_views()) {
        glViewport(number % 2 * tile.x, number / 2 * tile.y, tile.x, tile.y), ++number;  // an atlas with two columns
        glUniform4fv(glGetUniformLocation(depth_pass, "anchor"), 1, &view.anchor[0]);
        draw(depth_pass, view.to_clip, vertices);
    }
}

/// Gives a program the block of a shadow, an array of vec4 here, and the texture unit of its maps.
void give(GLuint to, const std::string& shadow, const auto& block, GLint unit) {
    const auto* floats = reinterpret_cast<const GLfloat*>(&block);
    glUniform4fv(glGetUniformLocation(to, (shadow + "_block").c_str()), sizeof block / 16, floats);
    glUniform1i(glGetUniformLocation(to, (shadow + "_map").c_str()), unit);
}

}  // namespace

int main(int, char** argv) {
    const window window(true);
    constexpr auto clip = umbrage::opengl_clip_space;
    const umbrage::shadow spot(scene::make_spot(clip), {1024, 1024}, umbrage::filters::tent<3>, umbrage::rgb24{});
    const umbrage::shadow sun(scene::make_cascades(clip), {1024, 1024}, umbrage::filters::tent<3>, umbrage::rgb24{});
    glEnable(GL_DEPTH_TEST), glDisable(GL_DITHER);
    draw_maps(spot, 0, window.vertices()), draw_maps(sun, 1, window.vertices());
    const GLuint view =
        program(glsl::source(es2, {glsl::shadow_coordinate}), "umbrage_shadow_coordinate(to_clip, position)",
                glsl::source(es2, {glsl::bind(spot, "spot"), glsl::bind(sun, "sun")}, precision) + scene::shading + R"(
        varying vec3 world, normal;  varying vec2 uv;
        void main() {
            if (is_hole(uv)) discard;
            gl_FragColor = vec4(shade(world, normal, umbrage_spot(world, normal), umbrage_sun(world, normal)), 1.0);
        })");
    give(view, "umbrage_spot", spot.uniforms(), 0), give(view, "umbrage_sun", sun.uniforms(), 1);
    window.bind(), glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    draw(view, scene::camera_matrix(clip), window.vertices());
    window.write_picture(argv[1]);
}
