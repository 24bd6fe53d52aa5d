// SPDX-License-Identifier: MIT
#include <umbrage/shadow/penumbra_shape.hpp>

#include "../entries.hpp"

namespace parity {

void add_shadow_penumbra_shape(std::vector<entry>& all) {
    const auto warps = [](std::uint64_t i, random& r, sample& s) {
        s.x[0] = {4096.0f * r.unit(), 4096.0f * r.unit(), static_cast<float>(i % 4), 0.0f};
        for (std::size_t column = 1; column < 5; ++column)
            s.x[column] = {(r.unit() - 0.5f) / 8192.0f, (1.5f * r.unit() - 1.0f) / 8192.0f, 3.0f * r.unit() - 1.5f,
                           0.5f + r.unit()};
    };
    all.push_back({.primitive = &umbrage::glsl::warp_shape,
                   .classes = {{"warps", warps}},
                   .twin =
                       [](const sample& s) {
                           const glm::mat4 all_warps(s.x[1], s.x[2], s.x[3], s.x[4]);
                           return vec4(umbrage::warp_shape(all_warps, s.x[0].z, vec2(s.x[0])), 1.0f);
                       },
                   .call = "vec4(umbrage_warp_shape(mat4(x1, x2, x3, x4), x0.z, vec2(x0.x, x0.y)), 1.0)"});
    const auto softness = [](auto, random& r, sample& s) {
        s.x[0] = {r.unit(), r.unit(), 16.0f * r.unit(), 16.0f + 512.0f * r.unit()};
        s.x[1] = {2.0f * r.unit(), 2.0f * r.unit(), 16.0f * r.unit() - 8.0f, 0.0f};
    };
    all.push_back({.primitive = &umbrage::glsl::shaped_softness,
                   .classes = {{"softness", softness}},
                   .twin = [](const sample& s) { return umbrage::shaped_softness(s.x[0], vec3(s.x[1])); },
                   .call = "umbrage_shaped_softness(x0, vec3(x1.x, x1.y, x1.z))"});
}

}  // namespace parity
