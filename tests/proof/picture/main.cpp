// SPDX-License-Identifier: MIT
//
// Picture table: acne, leaks, lost contact and RMS error of the default shadow, of other biases and of engines'
// formulas, against rays in double, over scenes from fixed seeds. Prints markdown, and returns 1 where the default
// breaks a bound.
//
//     picture             240 x 135 receivers of each scene and light
//     picture --sample    60 x 34 of them, in fewer scenes
//     picture --scenes    also each scene by itself
//
// Receivers face the light (cosine above 0.02) and lie 8 texels or more inside their map. 17 rays of each leave its own
// plane at 0, 1.5 and 3.2 texels in the map.
//   acne           all 17 rays reach the light, visibility below 0.9
//   leak           none does, visibility above 0.1
//   lost contact   the receiver's own ray is blocked less than 10 texels away, visibility above 0.5
//   RMS            of visibility against the receiver's own ray
#include <array>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/filter/pcf/windows.hpp>
#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/splits.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/shadow/cascaded_maps.hpp>
#include <umbrage/shadow/cube_maps.hpp>
#include <umbrage/shadow/shadow.hpp>

#include "engines.hpp"
#include "light_maps.hpp"
#include "receivers.hpp"
#include "rows.hpp"
#include "scenes.hpp"
#include "table.hpp"

namespace proof::picture {
namespace {

// What the default must keep under every light near the origin. Shares are of one bias for the whole kernel. What leaks
// is mostly in grazing light, where half a texel of slope is as deep as the caster is near, under either bias. A sample
// has only a few leaks in all.
constexpr double most_acne_percent = 0.01, most_acne_by_derivatives_percent = 0.01;
constexpr double most_lost_contact = 0.20, most_rms = 0.75;
constexpr double most_leak = 0.80, most_point_leak = 0.80, most_leak_of_sample = 1.0;
constexpr int map_size = 1024, point_map_size = 512, all_step = 2, sample_step = 8;
constexpr std::uint32_t seeds[]{1, 2, 3};  // each kind of scene is made from each, in a sample from the first two

constexpr const char *default_row = "**default: tent<3>**", *constant_row = "one bias for the whole kernel",
                     *screen_normals_row = "default, with normals from screen derivatives";

/// One scene under one light.
/// @param setup_of   clip space -> the light's setup
template <class SetupOf>
[[nodiscard]] table measure(const scene& s, const ray_tree& tree, light_kind kind, const ray_light& rays, double range,
                            int size, int step, const SetupOf& setup_of) {
    using namespace umbrage;
    const auto of = [&](const auto& filter, int subpixel_bits) {
        clip_space clip = cpu_clip_space;
        clip.subpixel_bits = subpixel_bits;
        return shadow(setup_of(clip), glm::ivec2(size), filter);
    };
    const auto usual = of(default_filter, 8), coarse = of(default_filter, 4);
    const light_maps maps(kind, usual, rays, range);
    const auto own_mesh = [&](int) -> const ray_mesh& { return s.mesh; };
    const auto drawn = std::make_shared<const image<float>>(maps.draw(own_mesh, cull_mode::none));
    const auto coarsely_drawn = std::make_shared<const image<float>>(
        maps.draw([&](int map) { return maps.on_coarse_grid(map, s.mesh); }, cull_mode::none));

    const auto place_of = [&usual](glm::vec3 p, glm::vec3 n) {
        const auto& u = usual.uniforms();
        return std::remove_cvref_t<decltype(usual.setup())>::places(u.maps, u.terms, p, n)[0];
    };
    std::vector<row> rows{
        shadow_row(default_row, usual, drawn), shadow_row("default, 4 sub-pixel bits", coarse, coarsely_drawn),
        screen_row(screen_normals_row, usual, drawn), shadow_row("pcf_2x2", of(filters::pcf_2x2{}, 8), drawn),
        shadow_row("castano<7>", of(filters::castano<7>, 8), drawn)};
    for (row& r : smooth_rows(maps, usual, drawn)) rows.push_back(std::move(r));
    const auto plain = [&](glm::vec3 p) { return usual(*drawn, p, glm::vec3(0)); };
    for (row& r : bias_rows(maps, drawn, plain)) rows.push_back(std::move(r));
    rows.push_back(threejs(maps, s));
    rows.push_back(godot(maps, drawn));
    rows.push_back(unity_urp(maps, s));
    for (row& r : mjp(maps, drawn)) rows.push_back(std::move(r));

    const std::vector<receiver> receivers = visible_receivers(s, tree, maps, place_of, step);
    table found;
    for (const row& each : rows) {
        tally sums;
        for (const receiver& r : receivers)
            if (!each.smooth_alone || r.smooth_normal != glm::vec3(0)) sums.add(r, each.visibility(r));
        if (sums.all > 0) found.add(each.name, sums);
    }
    return found;
}

[[nodiscard]] table measure(const scene& s, const ray_tree& tree, light_kind kind, int step) {
    using namespace umbrage;
    const double range = s.reach;
    if (kind == light_kind::sun) {
        const bounding_box<double> box = box_of(s.mesh);
        return measure(s, tree, kind, {false, -s.sun}, 0.0, map_size, step, [&](clip_space clip) {
            const cascade_fit<double> fit{.camera = camera_of(s),
                                          .direction = s.sun,
                                          .scene = box,
                                          .map_size = glm::ivec2(map_size),
                                          .margin = 4,
                                          .overlap = 0.1,
                                          .clip = clip};
            // Without blending: the measures are in texels of one map.
            return cascaded_maps(make_stable_cascades<4>(fit, practical_splits<4>(0.5, 60.0, 0.9)), 0.0f);
        });
    }
    if (kind == light_kind::spot)
        return measure(s, tree, kind, {true, s.spot + s.at}, range, map_size, step, [&](clip_space clip) {
            return single_map(make_spot_light<double>({.position = s.spot + s.at,
                                                       .direction = s.spot_target - s.spot,
                                                       .up = {0, 0, 1},
                                                       .outer_angle_radians = s.spot_angle,
                                                       .z_near = 0.5,
                                                       .z_far = range,
                                                       .clip = clip}));
        });
    return measure(s, tree, kind, {true, s.lamp + s.at}, range, point_map_size, step, [&](clip_space clip) {
        return cube_maps(point_light<double>{.position = s.lamp + s.at,
                                             .z_near = 0.1,
                                             .z_far = range,
                                             .map_size = point_map_size,
                                             .border = 8,
                                             .clip = clip});
    });
}

struct named_light {
    light_kind kind;
    const char* name;
};
constexpr named_light all_lights[]{{light_kind::sun, "sun, 4 stable cascades of 1024"},
                                   {light_kind::spot, "spot light, 1024"},
                                   {light_kind::point, "point light, 512"}};

/// Prints what the default breaks.
[[nodiscard]] bool keeps_bounds(const named_light& light, const table& found, bool is_sample) {
    const double leak = light.kind == light_kind::point ? most_point_leak : most_leak;
    const tally own = found.of(default_row), constant = found.of(constant_row);
    bool keeps = true;
    const auto expect = [&](const char* what, double is, double most) {
        std::printf("%s, %s: %.3f, at most %.3f%s\n", light.name, what, is, most, is <= most ? "" : " BROKEN");
        keeps = keeps && is <= most;  // false for NaN
    };
    expect("acne of the default, %", own.acne_percent(), most_acne_percent);
    expect("acne with normals from derivatives, %", found.of(screen_normals_row).acne_percent(),
           most_acne_by_derivatives_percent);
    expect("lost contact, share of one bias'", own.lost_percent() / constant.lost_percent(), most_lost_contact);
    expect("leak, share of one bias'", own.leak_percent() / constant.leak_percent(),
           is_sample ? most_leak_of_sample : leak);
    expect("RMS, share of one bias'", own.rms_percent() / constant.rms_percent(), most_rms);
    return keeps;
}

int run(bool is_sample, bool by_scene) {
    const int step = is_sample ? sample_step : all_step;
    constexpr std::array scenes{boxes_with_eaves, thin_fence, hills, room, rings_and_boxes};
    std::array<table, std::size(all_lights)> near;
    for (const auto& make : scenes) {
        std::array<table, std::size(all_lights)> own;
        std::string name;
        for (const std::uint32_t seed : std::span(seeds).first(is_sample ? 2 : 3)) {
            const scene s = make(seed, glm::dvec3(0));
            const ray_tree tree(s.mesh);
            name = s.name;
            for (std::size_t i = 0; i < own.size(); ++i)
                if (s.has_sun || all_lights[i].kind != light_kind::sun)
                    own[i] += measure(s, tree, all_lights[i].kind, step);
        }
        for (std::size_t i = 0; i < own.size(); ++i) {
            if (by_scene) own[i].print(name + ", " + all_lights[i].name);
            near[i] += own[i];
        }
    }
    for (std::size_t i = 0; i < near.size(); ++i) near[i].print(all_lights[i].name);

    table distances;
    for (const double away : {0.0, 1e4}) {
        const scene s = boxes_with_eaves(seeds[0], glm::dvec3(away, 0, 0));
        const ray_tree tree(s.mesh);
        for (const auto& [kind, name] : all_lights)
            distances.add(std::string(name) + (away > 0 ? ", 10 km out" : ""),
                          measure(s, tree, kind, step).of(default_row));
    }
    distances.print("default: boxes with eaves");

    std::printf("\n");
    bool keeps = true;
    for (std::size_t i = 0; i < near.size(); ++i) keeps = keeps_bounds(all_lights[i], near[i], is_sample) && keeps;
    return keeps ? 0 : 1;
}

}  // namespace
}  // namespace proof::picture

int main(int count, char** arguments) {
    bool is_sample = false, by_scene = false;
    for (int i = 1; i < count; ++i) {
        const std::string_view argument = arguments[i];
        if (argument == "--sample") is_sample = true;
        else if (argument == "--scenes") by_scene = true;
        else return std::fprintf(stderr, "usage: picture [--sample] [--scenes]\n"), 2;
    }
    return proof::picture::run(is_sample, by_scene);
}
