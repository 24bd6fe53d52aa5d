// SPDX-License-Identifier: MIT
//
// Measurements of whole scenes, each a table and a sheet of pictures or film strips:
//
//     studies filters      every filter against rays to an area light
//     studies lights       every setup of the light, in pixels per texel
//     studies stability    cascades, warps and pages while camera and sun move
//
#include <filesystem>
#include <optional>
#include <string>

#include <choices.hpp>
#include <command_line.hpp>

#include "compare.hpp"
#include "light_report.hpp"
#include "options.hpp"
#include "scenes.hpp"
#include "stability_report.hpp"

namespace {

using shadow_render::options;

struct study {
    std::string name{};
    std::filesystem::path shaders{};
    shadow_render::options options{};
};

std::optional<study> parse(int argc, const char* const* argv) {
    using example::within;
    study s;
    glm::ivec2 size(480, 320);
    options& o = s.options;
    CLI::App app{"Measures whole scenes: a table, and a sheet of pictures.", "studies"};
    app.option_defaults()->always_capture_default()->take_last();
    add_scene(app, o);
    app.add_option("study", s.name, "every filter against rays, every setup of a light, or what moves with the camera")
        ->check(CLI::IsMember({"filters", "lights", "stability"}).description(""))
        ->type_name("filters|lights|stability")
        ->required();
    app.add_option("-o,--output", o.output, "folder for the pictures, made when missing");
    example::add_size(app, "--size", size, "pixels of each picture: 480x320", 1, 8192);
    app.add_option("--map-size", o.map_size, "texels along an edge")->check(within(16, 8192));
    app.add_option("--light-size", o.light_size, "filters: its diameter, world units")->check(within(0, 4));
    example::add_bias(app, o.bias);
    app.add_option("--shaders", s.shaders,
                   "filters: shaders.tsv of tests/bench/shaders/run, for what they cost on RDNA2; "
                   "without it the one in build/bench-shaders, if any");
    app.add_flag("-q,--quiet", o.quiet, "the pictures alone");
    if (!example::parse(app, argc, argv)) return std::nullopt;
    o.width = size.x, o.height = size.y;
    if (s.name == "filters" && o.light == shadow_render::light_kind::cascades)
        throw example::usage_error("filters are compared over one map: --scene garden or solids");
    require_drawable(o);
    return s;
}

void run(const study& s) {
    make_output(s.options);
    const example::scene scene = scene_of(s.options);
    if (s.name == "filters") shadow_render::compare(s.options, scene, s.shaders);
    if (s.name == "lights") shadow_render::light_report(s.options, scene);
    if (s.name == "stability") shadow_render::stability_report(s.options, scene);
}

}  // namespace

int main(int argc, char** argv) {
    return example::run("studies", [&] {
        if (const auto asked = parse(argc, argv)) run(*asked);
    });
}
