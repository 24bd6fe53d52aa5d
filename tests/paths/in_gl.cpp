// SPDX-License-Identifier: MIT
//
// Draws paths in OpenGL:  paths_in_gl 330|110 PICTURE JOB...
//
// Each job is a frame. PICTURE then holds the visibility of each frame's pixels from above, a byte each.
#include <epoxy/gl.h>

#include <cstdio>
#include <exception>
#include <string_view>
#include <utility>

#include <umbrage/shader/glsl.hpp>
#include <umbrage/light/point/tetrahedron.hpp>

#include "../../examples/viewer/headless.hpp"
#include "told.hpp"

namespace {

namespace glsl = umbrage::glsl;
using namespace paths;

/// Makes a context current that has GLSL 110, on the display of the one that is.
void use_old_context() {
    const EGLint wish[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLDisplay display = eglGetCurrentDisplay();
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglChooseConfig(display, wish, &config, 1, &count);
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, nullptr);
    if (context == EGL_NO_CONTEXT || !eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context))
        throw viewer::no_context("no OpenGL of a compatibility profile here");
}

GLuint made(void (*make)(GLsizei, GLuint*)) {
    GLuint name = 0;
    make(1, &name);
    return name;
}

/// Draws frames in one context.
class program {
public:
    program(bool old, std::string picture) : old_(old), picture_(std::move(picture)) {
        if (old_) use_old_context();
        else glBindVertexArray(made(glGenVertexArrays));
        glEnable(GL_DEPTH_TEST);
        glDisable(GL_DITHER);
    }

    void frame(const job& j) {
        const told sun = tell(j, umbrage::opengl_clip_space);
        draw_maps(j, sun);
        draw_view(j, sun);
        if (const GLenum error = glGetError()) throw std::runtime_error("OpenGL error " + std::to_string(error));
    }

private:
    /// @param vertex, fragment   statements of main
    [[nodiscard]] GLuint linked(const std::vector<glsl::bound>& vertex_items, const std::string& vertex,
                                const std::vector<glsl::bound>& fragment_items, const std::string& fragment,
                                const std::string& declared = "") const {
        const auto version = old_ ? glsl::version::v110 : glsl::version::v330;
        const auto text = [&](const std::vector<glsl::bound>& items) {
            return items.empty() ? "#version " + std::string(glsl::directive(version)) + "\n"
                                 : glsl::source(version, items);
        };
        const std::string in = old_ ? "attribute" : "in", out = old_ ? "varying" : "out",
                          from = old_ ? "varying" : "in";
        const std::string texts[] = {
            text(vertex_items) + in + " vec3 position, vertex_normal;\n" + out +
                " vec3 world, normal;\nuniform mat4 to_clip;\nuniform vec4 anchor;\nuniform float number;\n" +
                "void main() { " + vertex + " world = position; normal = vertex_normal; }",
            text(fragment_items) + declared + from + " vec3 world, normal;\nuniform float number;\n" +
                (old_ ? "#define color gl_FragColor\n" : "out vec4 color;\n") + "void main() { " + fragment + " }"};
        const GLuint id = glCreateProgram();
        for (const int stage : {0, 1}) {
            const GLuint shader = glCreateShader(stage == 0 ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
            const char* source = texts[stage].c_str();
            glShaderSource(shader, 1, &source, nullptr), glCompileShader(shader), glAttachShader(id, shader);
            char log[4096] = "";
            glGetShaderInfoLog(shader, sizeof log, nullptr, log);
            if (*log) throw std::runtime_error(log);
        }
        glBindAttribLocation(id, 0, "position"), glBindAttribLocation(id, 1, "vertex_normal");
        glLinkProgram(id), glUseProgram(id);
        GLint good = 0;
        glGetProgramiv(id, GL_LINK_STATUS, &good);
        char log[4096] = "";
        if (!good) glGetProgramInfoLog(id, sizeof log, nullptr, log), throw std::runtime_error(log);
        return id;
    }
    [[nodiscard]] static GLsizei give_vertices(const std::vector<glm::vec3>& all) {
        glBindBuffer(GL_ARRAY_BUFFER, made(glGenBuffers));
        glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(all.size() * sizeof all[0]), all.data(), GL_STATIC_DRAW);
        for (const GLuint i : {0u, 1u}) {
            glEnableVertexAttribArray(i);
            glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 24, reinterpret_cast<const void*>(12 * std::size_t(i)));
        }
        return GLsizei(all.size() / 2);
    }
    /// A texture for maps or pictures, of nothing.
    [[nodiscard]] static GLuint texture(GLenum kind, GLint internal, glm::ivec2 size, int layers, bool depths) {
        const GLenum format = depths ? GL_DEPTH_COMPONENT : GL_RGBA;
        const GLuint id = made(glGenTextures);
        glBindTexture(kind, id);
        if (kind == GL_TEXTURE_2D) glTexImage2D(kind, 0, internal, size.x, size.y, 0, format, GL_FLOAT, nullptr);
        else glTexImage3D(kind, 0, internal, size.x, size.y, layers, 0, format, GL_FLOAT, nullptr);
        for (const auto filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            glTexParameteri(kind, GLenum(filter), GL_NEAREST);
        for (const auto wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
            glTexParameteri(kind, GLenum(wrap), GL_CLAMP_TO_EDGE);
        return id;
    }
    static void clear(bool reversed, glm::vec4 color) {
        glDepthFunc(reversed ? GL_GREATER : GL_LESS);
        glClearDepth(reversed ? 0 : 1);
        glClearColor(color.r, color.g, color.b, color.a);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    }
    static void attach(GLenum to, GLuint which, bool layered, GLint layer) {
        if (layered) glFramebufferTextureLayer(GL_FRAMEBUFFER, to, which, 0, layer);
        else glFramebufferTexture2D(GL_FRAMEBUFFER, to, GL_TEXTURE_2D, which, 0);
    }

    void draw_maps(const job& j, const told& sun) {
        const bool depth = is_depth(j), layered = is_layered(j), four = j.text("setup") == "tetrahedron_light";
        const bool bends = j.text("setup") == "dual_paraboloid_light";
        const glm::ivec2 grid = layered ? glm::ivec2(1) : glm::ivec2(sun.columns, sun.rows), size = sun.map_size * grid;
        kind_ = layered ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
        const GLint depths = j.text("encoding") == "depth16"   ? GL_DEPTH_COMPONENT16
                             : j.text("encoding") == "depth24" ? GL_DEPTH_COMPONENT24
                                                               : GL_DEPTH_COMPONENT32F;
        const GLint stored = depth ? depths : sun.floats ? GL_R32F : sun.channels == 2 ? GL_RG8 : GL_RGBA8;
        glActiveTexture(GL_TEXTURE0);
        const GLuint nearest = depth ? 0 : texture(GL_TEXTURE_2D, GL_DEPTH_COMPONENT32F, size, 1, true);
        maps_ = texture(kind_, stored, size, sun.columns * sun.rows, depth);
        if (compares(j)) {
            glTexParameteri(kind_, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
            glTexParameteri(kind_, GL_TEXTURE_COMPARE_FUNC, is_reversed(j) ? GL_GEQUAL : GL_LEQUAL);
        }
        glBindFramebuffer(GL_FRAMEBUFFER, made(glGenFramebuffers));
        if (depth) glDrawBuffer(GL_NONE), glReadBuffer(GL_NONE);
        else attach(GL_DEPTH_ATTACHMENT, nearest, false, 0);

        std::vector<glsl::bound> items;
        std::string fragment;
        if (four) {
            items.emplace_back(glsl::tetrahedron_face_of);
            fragment = "if (umbrage_tetrahedron_face_of(floor(gl_FragCoord.xy), " + std::to_string(sun.map_size.x) +
                       ".0) != number) discard;";
        }
        if (!depth) items.push_back(sun.write), fragment += " color = umbrage_write_sun(gl_FragCoord.z);";
        const GLuint pass = linked(
            {sun.vertex},
            std::string("gl_Position = umbrage_vertex_sun(to_clip, position, anchor") + (bends ? ", number);" : ");"),
            items, fragment);
        const GLsizei count = give_vertices(j.vertices("casters"));
        GLint number = 0;
        for (const umbrage::depth_view& view : sun.views) {
            if (number == 0 || layered) {
                attach(depth ? GL_DEPTH_ATTACHMENT : GL_COLOR_ATTACHMENT0, maps_, layered, number);
                glViewport(0, 0, size.x, size.y);
                clear(is_reversed(j), sun.cleared);
            }
            const int tile = layered || four ? 0 : number;
            const glm::ivec2 corner = glm::ivec2(tile % grid.x, tile / grid.x) * sun.map_size;
            glViewport(corner.x, corner.y, sun.map_size.x, sun.map_size.y);
            glUniformMatrix4fv(glGetUniformLocation(pass, "to_clip"), 1, GL_FALSE, &view.to_clip[0][0]);
            glUniform4fv(glGetUniformLocation(pass, "anchor"), 1, &view.anchor[0]);
            glUniform1f(glGetUniformLocation(pass, "number"), GLfloat(number++));
            glDrawArrays(GL_TRIANGLES, 0, count);
        }
    }

    void draw_view(const job& j, const told& sun) {
        const glm::ivec2 size(int(j.numbers("picture").at(0)), int(j.numbers("picture").at(1)));
        const bool turns = sun.lookup.declared->functions[0].arguments.size() > 2;
        const std::string pixel = turns ? ", gl_FragCoord.xy" : "";
        const GLuint view = linked({}, "gl_Position = to_clip * vec4(position, 1.0);", {sun.lookup},
                                   "color = vec4(vec3(umbrage_sun(world, normal" + pixel + ")), 1.0);");
        const glm::mat4 to_clip(j.matrix("to_clip"));
        glUniformMatrix4fv(glGetUniformLocation(view, "to_clip"), 1, GL_FALSE, &to_clip[0][0]);
        glUniform1i(glGetUniformLocation(view, "umbrage_sun_map"), 0);
        if (old_)
            glUniform4fv(glGetUniformLocation(view, "umbrage_sun_block"), GLsizei(sun.block.size() / 16),
                         reinterpret_cast<const GLfloat*>(sun.block.data()));
        else {
            glBindBufferBase(GL_UNIFORM_BUFFER, 0, made(glGenBuffers));
            glBufferData(GL_UNIFORM_BUFFER, GLsizeiptr(sun.block.size()), sun.block.data(), GL_DYNAMIC_DRAW);
            glUniformBlockBinding(view, glGetUniformBlockIndex(view, "umbrage_sun_block"), 0);
        }
        glActiveTexture(GL_TEXTURE1);
        const GLuint colors = texture(GL_TEXTURE_2D, GL_RGBA8, size, 1, false),
                     depths = texture(GL_TEXTURE_2D, GL_DEPTH_COMPONENT32F, size, 1, true);
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(kind_, maps_);
        glBindFramebuffer(GL_FRAMEBUFFER, made(glGenFramebuffers));
        attach(GL_COLOR_ATTACHMENT0, colors, false, 0), attach(GL_DEPTH_ATTACHMENT, depths, false, 0);
        glViewport(0, 0, size.x, size.y);
        clear(false, {0, 0, 1, 1});
        glDrawArrays(GL_TRIANGLES, 0, give_vertices(j.vertices("receivers")));
        std::vector<unsigned char> pixels(std::size_t(size.x * size.y));
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, size.x, size.y, GL_RED, GL_UNSIGNED_BYTE, pixels.data());
        std::ofstream file(picture_, std::ios::binary | std::ios::app);
        for (int y = size.y - 1; y >= 0; --y)
            file.write(reinterpret_cast<const char*>(pixels.data()) + y * size.x, size.x);
        if (!file) throw std::runtime_error("cannot write " + picture_);
    }

    bool old_;
    std::string picture_;
    GLenum kind_ = GL_TEXTURE_2D;
    GLuint maps_ = 0;
};

}  // namespace

int main(int argc, char** argv) try {
    const viewer::headless context(false);
    program draws(std::string_view(argv[1]) == "110", argv[2]);
    for (int i = 3; i < argc; ++i) draws.frame(job(argv[i]));
} catch (const viewer::no_context& none) {
    std::fprintf(stderr, "SKIPPED: %s\n", none.what());
    return 77;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
