// SPDX-License-Identifier: MIT
//
// A shadow whose normal is the cross product of the position's derivatives on the screen, for shaders that have none.
// OpenGL draws hills and boxes by it and by the triangles' normals, and C++ takes the triangles' normals: on triangles
// wider than two pixels they have to agree.
//
//     shadows_derivatives_in_gl   prints how many pixels differ, in GLSL 330 and 100; 1 when more than a few do
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "../../examples/viewer/headless.hpp"
#include "drawn_in_gl.hpp"

namespace {

using namespace shadows_in_gl;

// Pixels whose visibility may differ by more than 1/10: a comparison turns where two slopes round apart.
constexpr double most_that_differ = 0.001;
constexpr glm::ivec2 picture(256, 256);

/// Triangles of a scene, each with corners and a normal of its own.
struct scene {
    std::vector<glm::vec3> positions{}, normals{};
    std::vector<glm::uvec3> triangles{};

    void add(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        const auto first = static_cast<unsigned>(positions.size());
        for (const glm::vec3& p : {a, b, c}) positions.push_back(p), normals.push_back(glm::cross(b - a, c - a));
        triangles.emplace_back(first, first + 1, first + 2);
    }
    void add(glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d) { add(a, b, c), add(a, c, d); }

    scene() {
        const auto hill = [](int i, int j) {
            const float x = float(i) - 8, z = float(j) - 8;
            return glm::vec3(x, 0.5f * std::sin(0.9f * x) + 0.7f * std::sin(0.7f * z + 0.3f * x), z);
        };
        for (int i = 0; i < 16; ++i)
            for (int j = 0; j < 16; ++j) add(hill(i, j), hill(i, j + 1), hill(i + 1, j + 1), hill(i + 1, j));
        for (const glm::vec3& low : {glm::vec3(-3, 0, -2), glm::vec3(2, 0, 1), glm::vec3(-1, 0, 4)}) {
            const glm::vec3 x(1.2f, 0, 0.3f), y(0, 2.5f, 0), z(-0.3f, 0, 1.2f);
            for (const glm::vec3& from : {low, low + y}) add(from, from + z, from + z + x, from + x);
            add(low, low + x, low + x + y, low + y), add(low + z, low + z + y, low + z + x + y, low + z + x);
            add(low, low + y, low + y + z, low + z), add(low + x, low + x + z, low + x + y + z, low + x + y);
        }
    }
};

/// Draws the scene, its result in the fragment's color.
/// @param main_text   statements that give `color` from `world`, `normal` and `number`, the triangle's
image<glm::vec4> draw(version v, const scene& of, const glm::mat4& to_clip, const tried& shadowed,
                      const std::string& main_text) {
    const bool old = v == version::v100;
    const std::string head = "#version " + std::string(directive(v)) + "\n", in = old ? "attribute " : "in ",
                      out = old ? "varying highp " : "out ", back = old ? "varying highp " : "in ";
    const GLuint program = glCreateProgram();
    glAttachShader(
        program, compiled(GL_VERTEX_SHADER, head + "uniform mat4 to_clip;\n" + in + "vec4 corner;\n" + in +
                                                "vec3 given;\n" + out + "vec3 world;\n" + out + "vec3 normal;\n" + out +
                                                "float number;\nvoid main() {\n    world = corner.xyz;\n"
                                                "    normal = given;\n    number = corner.w;\n"
                                                "    gl_Position = to_clip * vec4(world, 1.0);\n}\n"));
    std::string text = glsl::source(v, {shadowed.item}, old ? "precision highp float;\n" : "");
    if (old) text.insert(text.find('\n') + 1, "#extension GL_OES_standard_derivatives : require\n");
    text += back + "vec3 world;\n" + back + "vec3 normal;\n" + back + "float number;\n" +
            (old ? "" : "out vec4 color;\n") + "void main() {\n" + (old ? "    vec4 color;\n" : "") + main_text +
            (old ? "    gl_FragColor = color;\n" : "") + "}\n";
    glAttachShader(program, compiled(GL_FRAGMENT_SHADER, text));
    glBindAttribLocation(program, 0, "corner"), glBindAttribLocation(program, 1, "given");
    glLinkProgram(program);
    GLint good = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &good);
    if (!good) throw std::runtime_error("the program does not link");
    glUseProgram(program);
    glActiveTexture(GL_TEXTURE2);
    upload(shadowed.map);
    give_uniforms(program, v, {shadowed});
    glUniformMatrix4fv(glGetUniformLocation(program, "to_clip"), 1, GL_FALSE, &to_clip[0][0]);

    GLuint frame = 0, depth = 0, array = 0, buffers[2]{};
    glActiveTexture(GL_TEXTURE0);
    const GLuint color = upload({GL_TEXTURE_2D, old ? GLint(GL_RGBA) : GL_RGBA32F, GL_RGBA,
                                 GLenum(old ? GL_UNSIGNED_BYTE : GL_FLOAT), glm::ivec3(picture, 1), nullptr});
    glGenFramebuffers(1, &frame), glBindFramebuffer(GL_FRAMEBUFFER, frame);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
    glGenRenderbuffers(1, &depth), glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT16, picture.x, picture.y);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    std::vector<glm::vec4> corners;
    for (std::size_t i = 0; i < of.positions.size(); ++i) corners.emplace_back(of.positions[i], float(i / 3));
    if (!old) glGenVertexArrays(1, &array), glBindVertexArray(array);
    glGenBuffers(2, buffers);
    const auto attribute = [&](GLuint i, const void* data, std::size_t bytes, int components) {
        glBindBuffer(GL_ARRAY_BUFFER, buffers[i]);
        glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(bytes), data, GL_STATIC_DRAW);
        glEnableVertexAttribArray(i), glVertexAttribPointer(i, components, GL_FLOAT, GL_FALSE, 0, nullptr);
    };
    attribute(0, corners.data(), corners.size() * sizeof(glm::vec4), 4);
    attribute(1, of.normals.data(), of.normals.size() * sizeof(glm::vec3), 3);
    glViewport(0, 0, picture.x, picture.y);
    glDisable(GL_DITHER), glEnable(GL_DEPTH_TEST);
    glClearColor(-1, -1, -1, 0), glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawArrays(GL_TRIANGLES, 0, GLsizei(corners.size()));
    image<glm::vec4> drawn(picture);
    image<glm::u8vec4> in_bytes(picture);
    if (old) {
        glReadPixels(0, 0, picture.x, picture.y, GL_RGBA, GL_UNSIGNED_BYTE, in_bytes.texels().data());
        for (std::size_t i = 0; i < drawn.texels().size(); ++i)
            drawn.texels()[i] = glm::vec4(in_bytes.texels()[i]) / 255.0f;
    } else glReadPixels(0, 0, picture.x, picture.y, GL_RGBA, GL_FLOAT, drawn.texels().data());
    if (const GLenum error = glGetError()) throw std::runtime_error("OpenGL error " + std::to_string(error));
    return drawn;
}

/// Draws in one dialect and compares.
/// @return   false where more pixels differ than may
template <class Shadow>
bool agree(version v, const scene& of, const Shadow& sun, const image<float>& map) {
    const bool old = v == version::v100;
    const viewer::headless context(old);
    const texture_data texels{.internal = old ? GLint(GL_LUMINANCE) : GL_R32F,
                              .format = GLenum(old ? GL_LUMINANCE : GL_RED),
                              .size = glm::ivec3(map.size(), 1),
                              .texels = map.texels().data()};
    const tried shadowed = make("sun", sun, glsl::bind(sun, "sun"), texels, map);
    const glm::mat4 to_clip = [] {
        const auto eye = make_spot_light<float>({.position = {6, 7, 11},
                                                 .direction = {-6, -7, -11},
                                                 .outer_angle_radians = 0.6f,
                                                 .z_near = 1,
                                                 .z_far = 40,
                                                 .clip = opengl_clip_space});
        return eye.projection * eye.view;
    }();
    const auto seen = draw(v, of, to_clip, shadowed, "    color = vec4(umbrage_sun(world, normal), 0.0, 1.0, 1.0);\n");
    const tried derived = make("sun", sun, glsl::bind(sun, "sun", {.derivatives = true}), texels, map);
    const auto without = draw(v, of, to_clip, derived, "    color = vec4(umbrage_sun(world), 0.0, 1.0, 1.0);\n");
    image<glm::vec4> places(picture);
    if (!old) places = draw(v, of, to_clip, shadowed, "    color = vec4(world, number);\n");
    int drawn = 0, in_shader = 0, from_cpp = 0, partly = 0;
    for (std::size_t i = 0; i < seen.texels().size(); ++i) {
        const glm::vec4 given = seen.texels()[i], at = places.texels()[i];
        const glm::vec2 is(given.x, without.texels()[i].x);
        if (!(given.z > 0.5f)) continue;
        ++drawn, partly += is.x < 1;
        in_shader += std::abs(is.x - is.y) > 0.1f;
        if (old) continue;
        const glm::vec3 normal = of.normals[3 * static_cast<std::size_t>(std::lround(at.w))];
        from_cpp += std::abs(sun(map, glm::vec3(at), normal) - is.y) > 0.1f;
    }
    std::printf("GLSL %s, %s: %d pixels, %d not lit; differing from face normals %d, from C++ %d\n",
                std::string(directive(v)).c_str(), glGetString(GL_RENDERER), drawn, partly, in_shader, from_cpp);
    return drawn > 10000 && partly > 1000 && std::max(in_shader, from_cpp) <= int(most_that_differ * drawn);
}

}  // namespace

int main() try {
    const scene of;
    const auto light = fit_directional_light<double>({.direction = {0.6, -1, 0.4},
                                                      .receivers = bounding_box<double>{{-8, -1.3, -8}, {8, 3.7, 8}},
                                                      .clip = opengl_clip_space});
    const shadow sun(light, {512, 512}, filters::tent<3>);
    image<float> map(sun.size(), sun.cleared());
    sun.draw(map, {of.positions, of.triangles});
    bool good = true;
    for (const version v : {version::v330, version::v100}) good = agree(v, of, sun, map) && good;
    return good ? 0 : 1;
} catch (const std::exception& e) { return std::fprintf(stderr, "%s\n", e.what()), 1; }
