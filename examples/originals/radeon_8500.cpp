// SPDX-License-Identifier: MIT
//
// ShadowMap of the ATI Radeon 8500 SDK, 2002. The card had no depth textures and 8 bits a channel, so a look-up texture
// spread 11 bits of depth over two of them, and pixel shader 1.4 put them together again and compared, four times.
//
//     light -> depth pass -> encode -> [map] -> fetch -> decode -> compare -> filter -> visibility -> shade
//
// The same pixels once more with 8 bits, with exact depth, and in the card's own fixed point show what that bought.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <umbrage/bias/constant.hpp>
#include <umbrage/depth/foreign/ps14.hpp>
#include <umbrage/depth/rg_table.hpp>
#include <umbrage/filter/pcf/four_tap.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "rays.hpp"
#include "stage.hpp"

namespace {

using namespace example;

void run(const options& o) {
    const shadow_system system = o.of(radeon_8500);
    const stage stage(system, o);

    // Light: a texture matrix, and from it one for each of four taps, as the application set them up.
    const light light = make_light(system, stage.scene);
    const glm::mat4 world_to_texels = umbrage::texture_matrix(light.space, system.map_size);
    const auto taps = umbrage::tap_matrices(world_to_texels);

    // Depth pass.
    const umbrage::image<float> depth = depth_pass(system, stage.scene, light);

    // Encode: a nearest fetch from 2048 x 1 texels, with the depth as coordinate.
    static constexpr auto table = umbrage::make_rg_table<11, glm::u8vec4>();
    umbrage::image<glm::u8vec2> map(depth.size());
    std::ranges::transform(depth.texels(), map.texels().begin(), [](float z) {
        return umbrage::encode_rg_table<11>([](int x) { return table[static_cast<std::size_t>(x)]; }, z);
    });
    umbrage::image<std::uint8_t> map_8(depth.size());  // what a single channel would have held
    std::ranges::transform(depth.texels(), map_8.texels().begin(), [](float z) { return umbrage::store_unorm(z); });

    // Four taps in the map for a point, and its depth.
    // fetch: texel -> what the map holds, decoded;  scale: the depth on decode's scale
    const auto visibility_with = [&](auto fetch, auto scale) {
        return stage.visibility([&](const surface& s) {
            const glm::vec3 point = lifted(system, light, s.position, s.face_normal);
            const auto project = [&](const glm::mat4& m) {
                return umbrage::project_coordinate(umbrage::shadow_coordinate(m, point));
            };
            std::array<glm::vec3, 4> at;
            for (std::size_t tap = 0; tap < 4; ++tap) at[tap] = project(taps[tap]);
            const float receiver = scale(umbrage::biased(light.depth(system, at[0].z), system.epsilon));
            const auto xy = [](glm::vec3 p) { return glm::vec2(p.x, p.y); };
            const float lit = system.filter == radeon_8500.filter
                                  ? umbrage::four_tap(fetch, xy(at[0]), xy(at[1]), xy(at[2]), xy(at[3]), receiver)
                                  : filtered(system, fetch, xy(project(world_to_texels)), receiver);
            return light.cone(s.position) * lit;
        });
    };
    const auto sampled = [&, fetch = umbrage::clamped(map)](glm::ivec2 t) { return umbrage::load_unorm(fetch(t)); };
    const auto as_it_is = [](float z) { return z; };

    // Fetch and decode, in four ways.
    struct way {
        std::string name;
        umbrage::image<float> visibility;
    };
    std::vector<way> ways{
        way{"8 bits", visibility_with([&, fetch = umbrage::clamped(map_8)](glm::ivec2 t) { return fetch(t) / 255.0f; },
                                      as_it_is)},
        way{"11 bits", visibility_with([&](glm::ivec2 t) { return umbrage::decode_ps14(sampled(t)); },
                                       [](float z) { return umbrage::receiver_ps14(z); })},
        way{"11 bits in s3.12",
            visibility_with([&](glm::ivec2 t) { return umbrage::decode_fixed_ps14(sampled(t)); },
                            [](float z) { return umbrage::fixed_ps14(umbrage::receiver_ps14(z)); })},
        way{"exact", visibility_with(umbrage::clamped(depth), as_it_is)}};
    std::vector<std::size_t> shown{1, 2};
    if (system.encoding != radeon_8500.encoding) {
        const umbrage::image<float> other = stored(system, light, depth);
        ways.insert(ways.begin(), {o.encoding, visibility_with(umbrage::clamped(other), as_it_is)});
        shown = {0};
    }

    // Shade, with the map in the corner.
    std::vector<picture> pictures, masks;
    for (const way& w : ways) {
        pictures.push_back(stage.shade(system, light, w.visibility));
        show_map(pictures.back(), depth);
        masks.push_back(gray(w.visibility));
        std::size_t other = 0;
        for (std::size_t i = 0; i < w.visibility.texels().size(); ++i)
            other += w.visibility.texels()[i] != ways.back().visibility.texels()[i];
        std::printf("%-16s %6zu of %zu pixels are not what exact depth gives\n", w.name.c_str(), other,
                    w.visibility.texels().size());
    }
    write(o, pictures[shown[0]], ways[shown[0]].visibility, depth);
    write(o, "comparison.png", side_by_side(pictures));
    write(o, "comparison_visibility.png", side_by_side(masks));
    picture channels(map.size());
    std::ranges::transform(map.texels(), channels.texels().begin(), [](glm::u8vec2 t) { return glm::u8vec3(t, 0); });
    write(o, "map.png", channels);
    if (o.rays)
        for (std::size_t i : shown) compare_with_rays(stage, light, ways[i].visibility, system.map_size, 5);
}

}  // namespace

int main(int argc, char** argv) { return example::run_original(example::radeon_8500, argc, argv, run); }
