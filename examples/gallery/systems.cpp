// SPDX-License-Identifier: MIT
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <umbrage/registry.hpp>

#include <depth_color.hpp>

#include "opengl.hpp"
#include "sections.hpp"

namespace gallery {
namespace {

using namespace example;
namespace glsl = umbrage::glsl;

/// A map as people see it: nearest texels.
picture colored(const umbrage::image<float>& depth, float empty, int height) {
    picture out{{height * depth.size().x / depth.size().y, height}};
    const auto stretch = umbrage::stretch(depth, empty);
    umbrage::overlay(out, depth, {.size = out.size(), .map_origin = picture_clip.origin},
                     [&](float d) { return d == empty ? no_depth_color : depth_color(stretch(d)); });
    return out;
}

struct description {
    std::string text;
    std::vector<glsl::snippet> snippets;
    glsl::binding map{};
};

const glsl::binding as_ps14{.outside = umbrage::outside_map::clamped,
                            .depth = "umbrage_decode_ps14(value.xy)",
                            .channels = 2,
                            .needs = {glsl::decode_ps14}};

const std::map<std::string_view, description> descriptions{
    {"radeon_8500",
     {"The card of 2001 had 8 bits per channel. A lookup texture of 2048 texels spread 11 bits of depth over two "
      "channels. Pixel shader 1.4 joined them again and compared, at four taps with a texture matrix each.",
      {glsl::shadow_coordinate, glsl::tap_coordinate, glsl::project_coordinate, glsl::linear_depth,
       glsl::encode_rg_table<11>, glsl::decode_ps14, glsl::receiver_ps14, glsl::four_tap_hardware, glsl::spot_cone,
       glsl::diffuse_ambient},
      as_ps14}},
    {"dx_sdk",
     {"Microsoft's sample has a spot light with a cone, z/w in a float texture, and an epsilon. It takes the bilinear "
      "mean of four comparisons. A pane of glass receives shadows and casts none.",
      {glsl::shadow_coordinate, glsl::project_coordinate, glsl::project_depth, glsl::pcf_2x2_dx_sdk, glsl::spot_cone,
       glsl::diffuse_ambient}}},
    {"exercise",
     {"The exercise of graphics courses has a directional light with ten texels per world unit. Depth is distance over "
      "the far plane, with one comparison and an epsilon.",
      {glsl::shadow_coordinate, glsl::project_coordinate, glsl::linear_depth, glsl::fetch_bordered,
       glsl::compare_exercise, glsl::diffuse_ambient}}},
    {"self_shadowing",
     {"In this Direct3D 8 article a lookup texture lies along an orthographic light's axis. Depth pass and camera pass "
      "both fetch from it, and equal texels mean light. Shadow darkens the lit picture.",
      {glsl::shadow_coordinate, glsl::project_coordinate, glsl::encode_rg_table<11>, glsl::decode_ps14, glsl::hard,
       glsl::diffuse_ambient},
      as_ps14}}};

void add_system(page& page, const settings& o, const std::filesystem::path& folder, const shadow_system& system) {
    const options with{.output = folder,
                       .azimuth = system.azimuth,
                       .elevation = system.elevation,
                       .size = o.size,
                       .map_size = system.map_size,
                       .reach = system.reach,
                       .epsilon = system.epsilon,
                       .encoding = std::string(system.encoding),
                       .filter = std::string(system.filter)};
    double depth_ms = 0, camera_ms = 0, visibility_ms = 0, shade_ms = 0;
    const stage stage = timed(camera_ms, [&] { return example::stage(system, with); });
    const light light = make_light(system, stage.scene);
    const auto depth = timed(depth_ms, [&] { return depth_pass(system, stage.scene, light); });
    const float empty = light.depth(system, umbrage::cleared_depth(light.space.clip));
    const stored_depth map = stored(depth, system.encoding, empty);
    const bool ps14 = system.receiver != receiver_kind::plain;
    const auto& decoded = ps14 ? decoded_ps14(map) : map.depth;
    const auto visibility = timed(visibility_ms, [&] { return visibility_of(system, stage, light, decoded); });
    picture shaded = timed(shade_ms, [&] { return stage.shade(system, light, visibility); });
    draw_pane(shaded, system, stage, light,
              [&](const example::stage& pane) { return visibility_of(system, pane, light, decoded); });
    show_map(shaded, depth);

    double surface = 0, shadow = 0;
    stage.for_each_surface([&](glm::ivec2 pixel, const example::surface&) {
        surface += 1;
        shadow += 1.0 - double(visibility[pixel]);
    });

    const int edge = shaded.size().y;
    std::vector<figure> figures{{page.picture(shaded), "On the CPU, the map in the corner"},
                                {page.picture(gray(visibility)), "Visibility, white is lit"}};
    std::vector<number> numbers{{"shadow map", sides(system.map_size)},
                                {"bits of depth", map.channels.empty() ? "32, float"
                                                  : ps14               ? "11 in two channels"
                                                                       : std::string(system.encoding)},
                                {"depth pass", milliseconds(depth_ms)},
                                {"encode, best of 5", milliseconds(map.encode_ms)},
                                {"camera pass", milliseconds(camera_ms)},
                                {"fetch, compare, filter", milliseconds(visibility_ms)},
                                {"shade", milliseconds(shade_ms)},
                                {"in shadow", text("%.1f %% of visible surfaces", 100 * shadow / surface)}};

    if (const auto gl = run_viewer(o.viewer, system.name, shaded.size(), folder)) {
        std::size_t other = 0;
        for (std::size_t i = 0; i < visibility.texels().size(); ++i)
            other +=
                std::abs(int(gl->visibility.texels()[i].r) - int(umbrage::store_unorm(visibility.texels()[i]))) > 64;
        figures.push_back({page::file(gl->picture), "On OpenGL, with the snippets below"});
        figures.push_back({page::file(gl->mask), "Visibility on OpenGL"});
        numbers.push_back({"OpenGL", gl->frame});
        numbers.push_back(
            {"OpenGL's visibility differs by more than 1/4",
             text("in %.2f %% of the pixels", 100.0 * double(other) / double(visibility.texels().size()))});
    }
    if (system.receiver == receiver_kind::scaled) {  // beside 8 bits and beside exact depth
        shadow_system plain = system;
        plain.receiver = receiver_kind::plain;
        const auto exact = visibility_of(plain, stage, light, depth);
        const auto coarse = visibility_of(plain, stage, light, stored(depth, "8_bits", empty).depth);
        const auto others = [&](const umbrage::image<float>& v) {
            std::size_t n = 0;
            for (std::size_t i = 0; i < v.texels().size(); ++i) n += v.texels()[i] != exact.texels()[i];
            return text("%.3f %% of the pixels", 100.0 * double(n) / double(v.texels().size()));
        };
        figures.push_back({page.picture(gray(coarse)), "Visibility with 8 bits, without the trick"});
        figures.push_back({page.picture(gray(exact)), "Visibility with exact depth"});
        numbers.push_back({"11 bits differ from exact depth in", others(visibility)});
        numbers.push_back({"8 bits differ in", others(coarse)});
    }
    figures.push_back({page.picture(colored(depth, empty, edge)), "The map: near is dark, far is pale, empty is gray"});
    if (!map.channels.empty())
        figures.push_back({page.picture(packed(map, depth, edge / 2)), "The map as stored: R, G"});
    const description& d = descriptions.at(system.name);
    page.entry(system.name, system.title, d.text, figures, numbers, together_and_alone(d.snippets, d.map));
}

}  // namespace

void add_systems(page& page, const settings& o, const std::filesystem::path& folder) {
    page.section("systems", "Systems",
                 "The four origins of this library, each with its own light, encoding, bias and filter.");
    for (const shadow_system& system : systems) add_system(page, o, folder, system);
}

}  // namespace gallery
