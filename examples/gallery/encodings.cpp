// SPDX-License-Identifier: MIT
#include <algorithm>
#include <concepts>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

#include <umbrage/depth/encodings.hpp>
#include <umbrage/depth/rg_table.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/registry.hpp>

#include "sections.hpp"

namespace gallery {
namespace {

using namespace example;
namespace glsl = umbrage::glsl;

/// Snippets that write and read an encoding.
template <class Encoding>
std::vector<glsl::snippet> snippets_of(const Encoding& encoding) {
    if (encoding.writes == umbrage::store_format::depth) return {glsl::fetch_clamped, glsl::fetch_depth};
    std::vector<glsl::snippet> all{*encoding.writer};
    if constexpr (requires { Encoding::bits; })
        if constexpr (std::same_as<Encoding, umbrage::rg<Encoding::bits>>)
            all.push_back(glsl::encode_rg_table<Encoding::bits>);
    if (encoding.writes == umbrage::store_format::integers) all.push_back(*Encoding::target::to_unorm);
    all.push_back(*encoding.reader);
    all.push_back(glsl::fetch_depth);
    return all;
}

}  // namespace

void add_encodings(page& page, const settings& o, const std::filesystem::path& folder) {
    shadow_system system = radeon_8500;
    system.receiver = receiver_kind::plain;
    system.filter = "hard";
    constexpr float reach = 1000, rounding = 0x1p-18f;
    const stage stage(system, {.output = folder, .size = o.size * 3 / 4});
    light light = make_light(system, stage.scene);
    light.z_far = reach;
    light.space = umbrage::make_spot_light<float>({.position = light.position,
                                                   .direction = light.direction,
                                                   .up = direction_at(system.azimuth, system.elevation + 90),
                                                   .outer_angle_radians = glm::radians(system.outer_angle),
                                                   .z_near = light.z_near,
                                                   .z_far = reach,
                                                   .clip = picture_clip});
    auto depth = depth_pass(system, stage.scene, light);
    const float cleared = light.depth(system, umbrage::cleared_depth(light.space.clip));
    for (float& d : depth.texels())
        if (d == cleared) d = 1;  // as a target holds it where nothing was drawn
    system.epsilon = rounding;
    const auto exact = visibility_of(system, stage, light, depth);

    page.section(
        "encodings", "Encodings",
        text("The same shadow from the same depths, in every encoding. The light reaches %g world units, a hundred "
             "times farther than the scene, so that bits are scarce. Quantized depths decode to their upper edge. "
             "Pixels that differ from those of exact depth are red.",
             double(reach)));
    umbrage::for_each_encoding([&](const auto& encoding) {
        const std::string name(encoding.name);
        const stored_depth map = stored(depth, name, 1.0f);
        const double bound = std::max(encoding.error().below, encoding.error().above);
        if (map.error > bound) throw std::logic_error("the encoding " + name + " is worse than stated");
        system.epsilon = rounding + static_cast<float>(encoding.error().below);
        const auto visibility = visibility_of(system, stage, light, map.depth);
        picture shaded = stage.shade(system, light, visibility);
        std::size_t other = 0;
        for (std::size_t i = 0; i < shaded.texels().size(); ++i)
            if (visibility.texels()[i] != exact.texels()[i]) {
                ++other;
                shaded.texels()[i] = {230, 20, 40};
            }
        const int edge = std::max(1, shaded.size().y / 2);
        page.entry(
            name, name, encoding.summary,
            {{page.picture(shaded), "Red: differs from exact depth"},
             {page.picture(packed(map, depth, edge)),
              map.channels.empty() ? "The map, stretched"
                                   : text("The map's channels: %.*s", int(3 * map.channels.size()) - 2, "R, G, B, A")}},
            {{"error, stated", text("≤ %s", depth_error(bound).c_str())},
             {"error, worst in this map", depth_error(map.error)},
             {"codes", std::to_string(encoding.codes)},
             {"codes in this map", std::to_string(map.codes)},
             {"pixels that differ from exact depth", std::to_string(other)},
             {text("encode %s, best of 5", sides(system.map_size).c_str()), text("%.2f ms", map.encode_ms)},
             {"decode, best of 5", text("%.2f ms", map.decode_ms)}},
            together_and_alone(snippets_of(encoding), glsl::stored_as(encoding)));
    });
}

}  // namespace gallery
