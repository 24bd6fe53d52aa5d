// SPDX-License-Identifier: MIT
//
// Self-shadowing with pixel shader 1.x, a Direct3D 8 article. The shader could not compute a depth of more than 8 bits,
// but it could fetch one: a look-up texture lies along the light's axis, its texels numbered in two channels. The depth
// pass stores what each point fetches; the camera's pass fetches the same for its point, and compares.
//
//     light -> depth pass -> encode -> [map] -> fetch -> decode -> compare -> visibility -> shade
//
// Texel 256 of that texture is (0, 32, 0, 0) by the article's own formula, not (255, 32, 0, 0) as its text has it.
#include <algorithm>

#include <umbrage/bias/constant.hpp>
#include <umbrage/depth/foreign/ps14.hpp>
#include <umbrage/depth/rg_table.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "rays.hpp"
#include "stage.hpp"

namespace {

using namespace example;

void run(const options& o) {
    const shadow_system system = o.of(self_shadowing);
    const stage stage(system, o);

    // Light: orthographic, so that depth grows evenly and the look-up texture can lie along it.
    const light light = make_light(system, stage.scene);
    const glm::mat4 world_to_texels = umbrage::texture_matrix(light.space, system.map_size);

    // Depth pass.
    const umbrage::image<float> depth = depth_pass(system, stage.scene, light);

    // Encode, for the map and for the receivers alike.
    static constexpr auto table = umbrage::make_rg_table<11, glm::u8vec4>();
    static_assert(table[256] == glm::u8vec4(0, 32, 0, 0));
    const auto look_up = [](float z) {
        return umbrage::encode_rg_table<11>([](int x) { return table[static_cast<std::size_t>(x)]; }, z);
    };
    umbrage::image<glm::u8vec2> map(depth.size());
    std::ranges::transform(depth.texels(), map.texels().begin(), look_up);

    // Fetch and decode: shift red right by three, add green.
    const auto decode = [](glm::u8vec2 texel) { return umbrage::decode_ps14(umbrage::load_unorm(texel)); };
    const auto looked_up = [&, texel = umbrage::clamped(map)](glm::ivec2 t) { return decode(texel(t)); };

    // Visibility: one texel, one comparison.
    // fetch: texel -> what the map holds, decoded;  scale: a depth, decoded likewise
    const auto visibility_with = [&](auto fetch, auto scale) {
        return stage.visibility([&](const surface& s) {
            const glm::vec3 point = lifted(system, light, s.position, s.face_normal);
            const glm::vec3 p = umbrage::project_coordinate(umbrage::shadow_coordinate(world_to_texels, point));
            return filtered(system, fetch, glm::vec2(p), scale(umbrage::biased(p.z, system.epsilon)));
        });
    };
    const bool own = system.encoding == self_shadowing.encoding;
    const umbrage::image<float> other = stored(system, light, depth);
    const umbrage::image<float> visibility =
        own ? visibility_with(looked_up, [&](float z) { return decode(look_up(z)); })
            : visibility_with(umbrage::clamped(other), [](float z) { return z; });

    // Shade: the lit picture, darkened.
    picture shaded = stage.shade(system, light, visibility);
    show_map(shaded, depth);
    write(o, shaded, visibility, depth);
    picture channels(map.size());
    std::ranges::transform(map.texels(), channels.texels().begin(), [](glm::u8vec2 t) { return glm::u8vec3(t, 0); });
    write(o, "map.png", channels);
    if (o.rays) compare_with_rays(stage, light, visibility, system.map_size, 4);
}

}  // namespace

int main(int argc, char** argv) { return example::run_original(example::self_shadowing, argc, argv, run); }
