// SPDX-License-Identifier: MIT
#include "scenes.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <system_error>

#include <run.hpp>

namespace shadow_render {

options usual(built_in scene) {
    options o{.scene = scene};
    if (scene == built_in::garden) return o;
    o.filter = "pcf_2x2", o.max_radius = 8, o.azimuth = 60;
    if (scene == built_in::solids) {
        o.light = light_kind::spot, o.elevation = 40, o.map_size = 1024;
        o.camera_elevation = 30, o.fov = 35;
        return o;
    }
    const bool plain = scene == built_in::plain;
    o.light = light_kind::cascades, o.map_size = plain ? 2048 : 4096, o.distance = 100;
    o.camera_elevation = plain ? 0.0f : 4.0f, o.camera_distance = plain ? 100.0f : 64.0f, o.fov = plain ? 60.0f : 50.0f;
    return o;
}

CLI::Option* add_scene(CLI::App& app, options& o) {
    static const std::map<std::string, built_in> scenes{{"garden", built_in::garden},
                                                        {"outdoor", built_in::outdoor},
                                                        {"plain", built_in::plain},
                                                        {"solids", built_in::solids}};
    return app
        .add_option_function<std::string>(
            "--scene", [&o](const std::string& name) { o = usual(scenes.at(name)); },
            "built-in scene: a garden, a kilometer of hills, one of plain, or a few solids on a floor")
        ->check(CLI::IsMember(scenes).description(""))
        ->type_name("garden|outdoor|plain|solids")
        ->default_str("garden")
        ->trigger_on_parse();  // ahead of the options that change it
}

example::scene scene_of(const options& o) {
    if (!o.mesh.empty()) return example::on_floor(example::load_mesh(o.mesh), example::up_axis::y);
    if (o.scene == built_in::outdoor) return example::outdoor_scene();
    if (o.scene == built_in::solids) return example::solids_scene();
    return o.scene == built_in::plain ? example::plain_scene() : example::default_scene();
}

void require_drawable(const options& o) {
    if (1.0 * o.width * o.height * o.samples * o.samples > 64e6 || std::max(o.width, o.height) * o.samples > 16384)
        throw example::usage_error("too large a picture: at most 64 million samples, 16384 along an edge");
}

void make_output(const options& o) {
    std::error_code error;
    std::filesystem::create_directories(o.output, error);
    if (!std::filesystem::is_directory(o.output))
        throw std::runtime_error("cannot make the folder " + o.output.string());
}

}  // namespace shadow_render
