// SPDX-License-Identifier: MIT
//
// The systems on OpenGL, live.
//
//     session   what is looked at, and what keys change of it
//     parts     a system's map, bias and filter as GLSL: change a filter there, in filter_of()
//     programs  shaders put together from them and the library's snippets
//     renderer  light's pass, camera's pass, map in the corner
//     outdoor   cascades and instances; placement of one map in the cascades' place; lamp, maps all around
//     window, headless   where OpenGL comes from
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>

#include <umbrage/core/image.hpp>

#include <command_line.hpp>
#include <png.hpp>

#include "headless.hpp"
#include "hud.hpp"
#include "options.hpp"
#include "renderer.hpp"
#include "session.hpp"
#include "window.hpp"

namespace {

using namespace viewer;

/// Runs the drawing to its very end.
/// @return   milliseconds
template <class Draw>
double timed(Draw&& draw) {
    const auto start = std::chrono::steady_clock::now();
    draw();
    glFinish();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// Mean over all frames but the first, which compiles shaders.
class frame_times {
public:
    void add(double ms) {
        if (frames_++ > 0) sum_ += ms;
        recent_ = frames_ < 3 ? ms : 0.9 * recent_ + 0.1 * ms;
    }
    [[nodiscard]] int frames() const { return frames_; }
    [[nodiscard]] double recent() const { return recent_; }
    void print() const {
        if (frames_ > 1)
            std::printf("%.1f ms a frame, mean of %d, on %s\n", sum_ / (frames_ - 1), frames_ - 1,
                        reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    }

private:
    int frames_ = 0;
    double sum_ = 0, recent_ = 0;
};

/// The framebuffer that was drawn to.
void save(const std::filesystem::path& file, glm::ivec2 size) {
    umbrage::image<glm::u8vec4> pixels(size);
    glReadPixels(0, 0, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels.texels().data());
    check_errors("reading the picture");
    umbrage::image<glm::u8vec3> picture(size);  // OpenGL's first row is the lowest
    for (glm::ivec2 p{0}; p.y < size.y; ++p.y)
        for (p.x = 0; p.x < size.x; ++p.x) picture[{p.x, size.y - 1 - p.y}] = glm::u8vec3(pixels[p]);
    example::write_png(file, picture.view());
    std::printf("wrote %s\n", file.string().c_str());
}

void run_headless(const options& o) {
    session session(o);
    const headless context(o.es2);
    prepare_context();
    const glm::ivec2 size(o.width, o.height);
    renderer renderer;
    const target target(size, texels_of::bytes);
    frame_times times;
    while (times.frames() < o.frames) times.add(timed([&] { renderer.draw(session, target.framebuffer, size); }));
    if (!o.screenshot.empty()) save(o.screenshot, size);
    std::printf("%s", renderer.note(session).c_str());
    times.print();
}

void run_window(const options& o) {
    session session(o);
    window window(session, {o.width, o.height});
    prepare_context();
    renderer renderer;
    const hud hud;
    frame_times times;
    const std::filesystem::path file = o.screenshot.empty() ? "viewer.png" : o.screenshot;
    while (window.open() && (o.frames == 0 || times.frames() < o.frames)) {
        const glm::ivec2 size = window.size();
        if (size.x > 0 && size.y > 0) {
            session.resize(size);
            if (session.turning) session.turn_light(0.02f * static_cast<float>(times.recent()), 0);
            times.add(timed([&] { renderer.draw(session, 0, size); }));
            if (session.text) {
                char ms[40];
                std::snprintf(ms, sizeof ms, "%.1f ms a frame\n\n", times.recent());
                hud.draw(session.describe() + renderer.note(session) + ms + std::string(keys),
                         {12, size.y * 3 / 10 + 12}, size);
            }
            if (window.wants_screenshot() || (times.frames() == o.frames && !o.screenshot.empty())) save(file, size);
        }
        window.show();
    }
    times.print();
}

}  // namespace

int main(int argc, char** argv) {
    return example::run("viewer", [&] {
        if (const auto options = viewer::parse_options(argc, argv))
            options->headless ? run_headless(*options) : run_window(*options);
    });
}
