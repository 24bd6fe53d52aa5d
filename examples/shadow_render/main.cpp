// SPDX-License-Identifier: MIT
//
// From a mesh to a shadowed picture, every step a primitive:
//
//     light -> depth pass -> encode -> [map] -> fetch -> decode -> compare -> filter -> visibility -> shade
//
// Start reading at render(), whose steps are in render.cpp; with cascades it is render_cascades(), in cascades.cpp. The
// filter is chosen in filter.cpp; the bias is in receivers.cpp, the light on things in shade.hpp.
#include <cstdio>
#include <utility>

#include <progress.hpp>
#include <run.hpp>
#include <scene.hpp>

#include "cascades.hpp"
#include "options.hpp"
#include "pictures.hpp"
#include "render.hpp"
#include "scenes.hpp"
#include "shade.hpp"
#include "view.hpp"

namespace shadow_render {
namespace {

/// The whole way, in order.
void render(const options& o, const example::scene& scene) {
    example::progress progress(8, o.quiet);
    const view view = make_view(o, scene, progress);
    const auto map = draw_map(o, view, progress);
    const auto visibility = look_up_map(o, view, map, progress);
    auto picture = progress.stage("shade", [&] { return shade(view, visibility, o.samples, progress.bands()); });
    progress.stage("write", [&] { write(o, map, visibility, std::move(picture)); });
    if (o.quiet) return;
    progress.print_times();
    std::printf("%zu triangles, %d x %d texels of %s: picture.png, map.png, depth.png and visibility.png in %s\n",
                scene.geometry.triangles.size(), o.map_size, o.map_size, o.encoding.c_str(), o.output.string().c_str());
}

void run(const options& o) {
    make_output(o);
    const example::scene scene = scene_of(o);
    if (o.light == light_kind::cascades) render_cascades(o, scene);
    else render(o, scene);
}

}  // namespace
}  // namespace shadow_render

int main(int argc, char** argv) {
    return example::run("shadow_render", [&] {
        if (const auto options = shadow_render::parse_options(argc, argv)) shadow_render::run(*options);
    });
}
