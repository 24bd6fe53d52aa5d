// SPDX-License-Identifier: MIT
//
// The directional-light exercise of graphics courses: a light that looks from -direction * 10 to the origin, through a
// box as wide as the map's texels / 10, its distance over z_far as depth, one comparison with an epsilon. The light
// moves: frames.png shows it going round.
//
//     light -> depth pass -> [map] -> fetch -> compare -> visibility -> shade
#include <vector>

#include <umbrage/bias/constant.hpp>
#include <umbrage/core/compare.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include <command_line.hpp>

#include "rays.hpp"
#include "stage.hpp"

namespace {

using namespace example;

struct frame {
    example::light light;
    umbrage::image<float> map, visibility;
    picture shaded;
};

frame render(const shadow_system& system, const stage& stage) {
    // Light, and the way from the world to texels of its map.
    const light light = make_light(system, stage.scene);
    const glm::mat4 world_to_texels = umbrage::texture_matrix(light.space, system.map_size);

    // Depth pass: keeps what is nearer or equally near.
    umbrage::image<float> map = stored(system, light, depth_pass(system, stage.scene, light));
    const auto fetch = umbrage::bordered(map, 1.0f);  // what the map does not reach is lit

    // Visibility: one texel, one comparison.
    umbrage::image<float> visibility = stage.visibility([&](const surface& s) {
        const glm::vec3 point = lifted(system, light, s.position, s.face_normal);
        const glm::vec3 p = umbrage::project_coordinate(umbrage::shadow_coordinate(world_to_texels, point));
        const float current = light.depth(system, p.z);
        if (system.filter != exercise.filter)
            return filtered(system, fetch, glm::vec2(p), umbrage::biased(current, system.epsilon));
        return umbrage::compare_exercise(current, fetch(glm::ivec2(glm::floor(glm::vec2(p)))), system.epsilon);
    });

    // Shade.
    picture shaded = stage.shade(system, light, visibility);
    show_map(shaded, map);
    return {light, std::move(map), std::move(visibility), std::move(shaded)};
}

void run(const options& o, shadow_system system, int frames) {
    const stage stage(system, o);
    std::vector<picture> moving;
    for (int i = 0; i < frames; ++i) {
        system.azimuth = o.azimuth + 360.0f * static_cast<float>(i) / static_cast<float>(frames);
        frame f = render(system, stage);
        if (i == 0) write(o, f.shaded, f.visibility, f.map);
        if (o.rays) compare_with_rays(stage, f.light, f.visibility, system.map_size, 3);
        moving.push_back(std::move(f.shaded));
    }
    write(o, "frames.png", side_by_side(moving));
}

}  // namespace

int main(int argc, char** argv) {
    return example::run("exercise", [&] {
        int frames = 8;
        shadow_system system = exercise;
        const auto more = [&](CLI::App& app) {
            app.add_option("--frames", frames, "of the light's way round")->check(within(1, 64));
            app.add_option("--texels-per-unit", system.texels_per_unit, "of the map, per world unit")
                ->check(within(0.1, 1000));
            app.add_option("--offset", system.offset, "of the light from the origin, world units")
                ->check(within(-1000, 1000));
            app.add_option("--near", system.z_near, "plane, world units from the light")->check(within(-1000, 1000));
            app.add_option("--far", system.z_far, "plane, world units from the light")->check(within(-1000, 1000));
        };
        if (const auto options = read_options(exercise, argc, argv, more)) {
            if (!(system.z_near < system.z_far)) throw usage_error("--near must be less than --far");
            run(*options, options->of(system), frames);
        }
    });
}
