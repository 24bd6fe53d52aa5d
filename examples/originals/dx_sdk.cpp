// SPDX-License-Identifier: MIT
//
// ShadowMap of the Microsoft DirectX SDK: a spot light, z/w in a float texture, an epsilon, four comparisons and their
// bilinear mean, on diffuse light and a colored ambient one. A pane is a receiver that lets light through.
//
//     light -> depth pass -> [map] -> fetch -> compare -> filter -> visibility -> shade
#include <umbrage/bias/constant.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include "rays.hpp"
#include "stage.hpp"

namespace {

using namespace example;

void run(const options& o) {
    const shadow_system system = o.of(dx_sdk);
    const stage stage(system, o);

    // Light, and the way from the world to texels of its map.
    const light light = make_light(system, stage.scene);
    const glm::mat4 world_to_texels = umbrage::texture_matrix(light.space, system.map_size);

    // Depth pass: z/w, kept as floats unless --encoding says otherwise.
    const umbrage::image<float> map = stored(system, light, depth_pass(system, stage.scene, light));
    const auto fetch = umbrage::clamped(map);

    // Visibility: within the cone, compare and filter.
    const auto visibility_of = [&](const example::stage& seen) {
        return seen.visibility([&](const surface& s) {
            const glm::vec3 point = lifted(system, light, s.position, s.face_normal);
            const glm::vec3 p = umbrage::project_coordinate(umbrage::shadow_coordinate(world_to_texels, point));
            const float lit = system.filter == dx_sdk.filter
                                  ? umbrage::pcf_2x2_dx_sdk(fetch, glm::vec2(p), p.z, system.epsilon)
                                  : filtered(system, fetch, glm::vec2(p), umbrage::biased(p.z, system.epsilon));
            return light.cone(s.position) * lit;
        });
    };
    const umbrage::image<float> visibility = visibility_of(stage);

    // Shade, and over it what lets light through.
    picture shaded = stage.shade(system, light, visibility);
    draw_pane(shaded, system, stage, light, visibility_of);
    show_map(shaded, map);
    write(o, shaded, visibility, map);
    if (o.rays) compare_with_rays(stage, light, visibility, system.map_size, 5);
}

}  // namespace

int main(int argc, char** argv) { return example::run_original(example::dx_sdk, argc, argv, run); }
