// SPDX-License-Identifier: MIT
//
// Quality of every setup of a light for two views.
#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/trigonometric.hpp>

#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/point/cube_map.hpp>
#include <umbrage/light/point/dual_paraboloid.hpp>
#include <umbrage/light/point/tetrahedron.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include <camera.hpp>
#include <map_overlay.hpp>
#include <scene.hpp>
#include <setups.hpp>

#include "sections.hpp"

namespace gallery {
namespace {

namespace glsl = umbrage::glsl;

struct view {
    std::string_view id, title;
    example::scene scene;
    example::camera_setup camera;
    float light_elevation, light_distance;
    int map_size;
};

void add_view(page& page, const settings& o, const view& v) {
    constexpr int step = 4;
    const glm::ivec2 screen(2 * o.size, 4 * o.size / 3);
    constexpr float azimuth = 60;
    const glm::dvec3 towards(example::direction_at(azimuth, v.light_elevation));
    example::camera_setup from = v.camera;
    from.target = v.scene.target, from.z_near = v.scene.z_near, from.z_far = v.scene.z_far;
    from.aspect = static_cast<float>(screen.x) / static_cast<float>(screen.y);
    const example::camera camera = example::make_camera(from);
    const auto lit =
        example::make_lit_view(v.scene, camera, screen,
                               {glm::dvec3(v.scene.target) + towards * double(v.light_distance), -towards,
                                glm::dvec3(example::direction_at(azimuth, v.light_elevation + 90)), glm::radians(30.0)},
                               v.map_size);
    std::vector<std::pair<double, figure>> placed;  // by the mean
    for (const example::setup& s : example::setups()) {
        umbrage::image<float> extents((screen - 1) / step + 1);
        const example::quality_report r = example::measure(s, lit, step, extents.view());
        umbrage::image<glm::u8vec3> colors = example::false_colors(lit, extents, step);
        const example::placed_maps maps = s.place(lit);
        example::overlay_maps(colors, lit, maps);
        const std::string name = maps.chosen.empty() ? s.name : s.name + ": " + maps.chosen;
        placed.emplace_back(r.mean, figure{page.picture(colors), name + text(": mean %.3g, p95 %.3g", r.mean, r.p95)});
    }
    std::ranges::stable_sort(placed, {}, [](const auto& p) { return p.first; });
    std::vector<figure> figures;
    for (auto& [mean, f] : placed) figures.push_back(std::move(f));
    page.entry(v.id, v.title,
               text("%d × %d pixels. One map of %d × %d texels, or four of %d × %d. Six, two or one for a point light, "
                    "with as many texels in all.",
                    screen.x, screen.y, v.map_size, v.map_size, v.map_size / 2, v.map_size / 2),
               figures, {},
               together_and_alone({glsl::shadow_coordinate, glsl::cascade_by_depth, glsl::cascade_coordinate,
                                   glsl::cube_coordinate, glsl::dual_paraboloid_coordinate,
                                   glsl::tetrahedron_coordinate, glsl::tetrahedron_texel}));
}

}  // namespace

void add_lights(page& page, const settings& o) {
    page.section(
        "lights", "Lights",
        "Pixels that a texel's longer axis covers on surfaces that face the light, for every setup, best first. "
        "Dark blue is an eighth of a pixel or less, green is one, dark red is eight or more. Gray surfaces are "
        "outside the map, or turned away. p95 is the number of pixels that 95 % stay below. Measured setups fit "
        "the range of visible surfaces. The corner shows the maps.");
    add_view(page, o,
             {.id = "indoor",
              .title = "A few things on a floor",
              .scene = example::solids_scene(),
              .camera = {.elevation = 30},
              .light_elevation = 40,
              .light_distance = 8,
              .map_size = 1024});
    add_view(page, o,
             {.id = "outdoor",
              .title = "A kilometer of hills",
              .scene = example::outdoor_scene(),
              .camera = {.elevation = 4, .distance = 64, .fov = 50},
              .light_elevation = 30,
              .light_distance = 100,
              .map_size = 4096});
    add_view(page, o,
             {.id = "plain",
              .title = "A kilometer of plain",
              .scene = example::plain_scene(),
              .camera = {.elevation = 0, .distance = 100, .fov = 60},
              .light_elevation = 45,
              .light_distance = 100,
              .map_size = 2048});
}

}  // namespace gallery
