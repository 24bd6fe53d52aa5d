// SPDX-License-Identifier: MIT
//
// From a mesh to a shadowed picture, every step a primitive:
//
//     light -> depth pass -> encode -> [map] -> fetch -> decode -> compare -> filter -> visibility -> shade
//
// Start reading at render(); with cascades it is render_cascades(), in cascades.cpp. The filter is chosen in
// filter.cpp; the bias is in receivers.cpp, the light on things in shade.hpp.
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <biases.hpp>
#include <camera.hpp>
#include <names.hpp>
#include <progress.hpp>
#include <run.hpp>
#include <scene.hpp>
#include <shadow_map.hpp>

#include "cascades.hpp"
#include "compare.hpp"
#include "filter.hpp"
#include "light_report.hpp"
#include "options.hpp"
#include "pictures.hpp"
#include "receivers.hpp"
#include "shade.hpp"
#include "stability_report.hpp"
#include "view.hpp"

namespace shadow_render {
namespace {

/// The whole way, in order.
void render(const options& o, const example::scene& scene) {
    const glm::ivec2 sample_size = glm::ivec2(o.width, o.height) * o.samples;
    example::progress progress(o.compare ? 5 + filter_names().size() : 8, o.quiet);

    // Light and camera: how they see the world.
    view view{.scene = scene, .lamp = make_light(o, scene), .camera = make_camera(o, scene), .seen{}};

    // Depth pass: the distance to what the light sees first.
    umbrage::image<float> depth(glm::ivec2(o.map_size), umbrage::cleared_depth(view.lamp.space.clip));
    progress.stage("depth pass", [&] {
        example::draw_depths(depth.view(), view_of(scene.geometry), example::once, view.lamp.world_to_clip());
        for (float& d : depth.texels()) d = view.lamp.even_depth(d);
    });

    // Encode: depths become the texels that a render target would hold. Decode: what a fetch gives back.
    const float empty = view.lamp.even_depth(umbrage::cleared_depth(view.lamp.space.clip));
    const auto map = progress.stage("encode", [&] { return example::store(o.encoding, o.edge, depth, empty); });

    // Camera pass: the triangle behind each sample, and where that looks into the map.
    progress.stage("camera pass", [&] { view.seen = example::camera_pass(scene.geometry, view.camera, sample_size); });
    if (o.compare) return compare(o, view, map, progress);
    const receivers receivers = progress.stage(
        "receivers", [&] { return receivers_of(view, o, reach_of(o), map.below, progress, compares_projected(o)); });

    // Visibility: fetch, compare, filter; some filter the map first.
    const look_up filter = progress.stage("filter", [&] { return prepare(o, map.depth, view.lamp, progress); });
    const auto visibility = progress.stage("visibility", [&] { return filter(receivers); });

    // Shade.
    auto picture = progress.stage("shade", [&] { return shade(view, visibility, o.samples, progress.bands()); });

    progress.stage("write", [&] { write(o, map, visibility, std::move(picture)); });
    if (!o.quiet) progress.print_times();
}

example::scene scene_of(const options& o) {
    if (!o.mesh.empty()) return example::on_floor(example::load_mesh(o.mesh), o.up);
    if (o.scene == built_in::outdoor) return example::outdoor_scene();
    return o.scene == built_in::plain ? example::plain_scene() : example::default_scene();
}

void run(const options& o) {
    const example::scene scene = scene_of(o);
    std::error_code error;
    std::filesystem::create_directories(o.output, error);
    if (!std::filesystem::is_directory(o.output))
        throw std::runtime_error("cannot make the folder " + o.output.string());
    if (o.light_report) return light_report(o, scene);
    if (o.stability_report) return stability_report(o, scene);
    if (o.light == light_kind::cascades) return render_cascades(o, scene);
    render(o, scene);
    if (!o.quiet && !o.compare)
        std::printf("%zu triangles, %d x %d texels of %s: picture.png, map.png, depth.png and visibility.png in %s\n",
                    scene.geometry.triangles.size(), o.map_size, o.map_size, o.encoding.c_str(),
                    o.output.string().c_str());
}

}  // namespace
}  // namespace shadow_render

int main(int argc, char** argv) {
    return example::run("shadow_render", [&] {
        if (const auto options = shadow_render::parse_options(argc, argv)) shadow_render::run(*options);
    });
}
