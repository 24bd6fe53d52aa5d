// SPDX-License-Identifier: MIT
#include "check.hpp"

#include <fstream>

#include <png.hpp>
#include <progress.hpp>

#include "render.hpp"

namespace shadow_render_check {

example::finished run(const std::string& arguments) {
    std::filesystem::create_directories(folder);
    return example::run_line(quoted(PROGRAM) + arguments);
}

void fails(const std::string& arguments, int code, const std::string& why) {
    CAPTURE(arguments);
    const example::finished r = run(arguments);
    CHECK_MESSAGE(r.code == code, r.said);
    CHECK_MESSAGE(r.said.find(why) != std::string::npos, r.said);
    CHECK_MESSAGE(r.said.find('\n') == r.said.size() - 1, r.said);
}

umbrage::image<float> visibility(const shadow_render::options& o, const example::scene& scene) {
    example::progress progress(20, true);
    shadow_render::view v = make_view(o, scene, progress);
    return visibility_of(o, v, v.camera, progress);
}

std::string output(const std::string& name) { return std::string("--quiet --output ").append(quoted(folder / name)); }

umbrage::image<glm::u8vec4> picture(const std::string& name, const char* file) {
    return example::read_png<glm::u8vec4>(folder / name / file);
}

std::string file(const std::string& name, const std::string& content) {
    std::filesystem::create_directories(folder);
    std::ofstream(folder / name, std::ios::binary) << content;
    return quoted(folder / name);
}

}  // namespace shadow_render_check
