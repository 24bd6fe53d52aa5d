// SPDX-License-Identifier: MIT
#include "light_report.hpp"

#include <cstdio>
#include <string>
#include <vector>

#include <glm/trigonometric.hpp>

#include <map_overlay.hpp>
#include <png.hpp>
#include <progress.hpp>
#include <setups.hpp>

#include "light.hpp"
#include "sheet.hpp"
#include "view.hpp"

namespace shadow_render {
namespace {

std::string chosen_of(const example::placed_maps& maps) { return maps.chosen.empty() ? "" : "  " + maps.chosen; }

}  // namespace

void light_report(const options& o, const example::scene& scene) {
    const auto& setups = example::setups();
    constexpr int step = 2;  // from one measured pixel to the next
    example::progress progress(setups.size() + 2, o.quiet);
    const light lamp = make_light(o, scene);
    const example::camera camera = make_camera(o, scene);
    const auto view = progress.stage("camera pass", [&] {
        return example::make_lit_view(scene, camera, {o.width, o.height},
                                      {lamp.position, lamp.direction,
                                       example::direction_at(o.azimuth, o.elevation + 90), glm::radians(o.cone / 2.0)},
                                      o.map_size);
    });
    const std::vector<std::string> title{
        text("%s: pixels that a texel's longer axis covers, over %d x %d pixels; one map of %d x %d texels, four of "
             "%d x %d, or as many in all",
             title_of(o).c_str(), o.width, o.height, o.map_size, o.map_size, o.map_size / 2, o.map_size / 2),
        text("Surfaces that face the light and lie in a map; the camera sees something from %.3g to %.3g",
             view.depths.z_near, view.depths.z_far),
        "Dark blue: 1/8 of a pixel or less; green: 1; dark red: 8 or more; gray: not measured. In the corner: the "
        "maps"};
    const glm::ivec2 size = (view.seen.size() - 1) / step + 1;
    sheet page(size, static_cast<int>(setups.size()), title);
    if (!o.quiet)
        std::printf("%s\n%s\n\n%-32s %9s %9s %9s %11s %8s\n", title[0].c_str(), title[1].c_str(), "setup", "mean",
                    "p95", "greatest", "storage", "pixels");
    for (const example::setup& s : setups)
        progress.stage(s.name, [&] {
            umbrage::image<float> extents(size);
            const example::quality_report r = example::measure(s, view, step, extents.view());
            const example::placed_maps maps = s.place(view);
            picture colors = example::false_colors(view, extents, step);
            example::overlay_maps(colors, view, maps);
            page.add(colors, {s.name, text("mean %.3g, p95 %.3g", r.mean, r.p95),
                              text("greatest %.3g, storage %.3g", r.greatest, r.storage_factor)});
            if (!o.quiet)
                std::printf("%-32s %9.3f %9.3f %9.2f %11.3g %8zu%s\n", s.name.c_str(), r.mean, r.p95, r.greatest,
                            r.storage_factor, r.measured, chosen_of(maps).c_str());
        });
    progress.stage("write", [&] { example::write_png(o.output / "lights.png", page.pixels().view()); });
}

}  // namespace shadow_render
