// SPDX-License-Identifier: MIT
//
// From a mesh to a shadowed picture, every step a primitive:
//
//     light -> depth pass -> encode -> [map] -> fetch -> decode -> compare -> filter -> visibility -> shade
//
// Start reading at render(), whose steps are in render.cpp; with cascades it is render_cascades(), in cascades.cpp. The
// filter is chosen in filter.cpp; the bias is in receivers.cpp, the light on things in shade.hpp.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include <png.hpp>
#include <progress.hpp>
#include <run.hpp>
#include <scene.hpp>

#include "cascades.hpp"
#include "compare.hpp"
#include "filter.hpp"
#include "light_report.hpp"
#include "options.hpp"
#include "pictures.hpp"
#include "render.hpp"
#include "shade.hpp"
#include "stability_report.hpp"
#include "troubles.hpp"
#include "view.hpp"

namespace shadow_render {
namespace {

/// The whole way, in order.
void render(const options& o, const example::scene& scene) {
    example::progress progress(o.compare ? 5 + filter_names().size() : 8, o.quiet);
    const view view = make_view(o, scene, progress);
    const auto map = draw_map(o, view, progress);
    if (o.compare) return compare(o, view, map, progress);
    const auto visibility = look_up_map(o, view, map, progress);
    auto picture = progress.stage("shade", [&] { return shade(view, visibility, o.samples, progress.bands()); });
    progress.stage("write", [&] { write(o, map, visibility, std::move(picture)); });
    if (!o.quiet) progress.print_times();
}

example::scene scene_of(const options& o) {
    if (!o.mesh.empty()) return example::on_floor(example::load_mesh(o.mesh), o.up);
    if (o.scene == built_in::outdoor) return example::outdoor_scene();
    if (o.scene == built_in::solids) return example::solids_scene();
    return o.scene == built_in::plain ? example::plain_scene() : example::default_scene();
}

/// Draws a trouble by its name, and the same place without it.
void render_trouble(const options& o) {
    const trouble& t = *std::ranges::find(troubles(), o.trouble, &trouble::name);
    const example::scene scene = scene_of(t.cured(o));
    example::write_png(o.output / "wrong.png", photograph(t.wrong(o), scene).view());
    example::write_png(o.output / "cured.png", photograph(t.cured(o), scene).view());
    if (!o.quiet)
        std::printf("wrong.png: %s; cured.png: %s; in %s\n", std::string(t.cause).c_str(), std::string(t.cure).c_str(),
                    o.output.string().c_str());
}

void run(const options& o) {
    std::error_code error;
    std::filesystem::create_directories(o.output, error);
    if (!std::filesystem::is_directory(o.output))
        throw std::runtime_error("cannot make the folder " + o.output.string());
    if (!o.trouble.empty()) return render_trouble(o);
    const example::scene scene = scene_of(o);
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
