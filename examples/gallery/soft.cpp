// SPDX-License-Identifier: MIT
//
// Soft shadows: what hardens where casters touch, and what is blurred ahead.
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <umbrage/bias/constant.hpp>
#include <umbrage/filter/blocker/dpcf.hpp>
#include <umbrage/filter/blocker/pcss.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/filter/prefiltered/prefilters.hpp>
#include <umbrage/filter/table/summed_moments.hpp>
#include <umbrage/filter/table/summed_variance.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include <biases.hpp>
#include <names.hpp>
#include <soft.hpp>

#include "sections.hpp"

namespace gallery {
namespace {

using namespace example;
namespace glsl = umbrage::glsl;

constexpr float light_radius = 0.3f, max_radius = 12;  // world units, texels
constexpr int blur = 3;

/// A ball on a pillar, whose shadow begins where it stands.
struct scene_of_soft {
    example::stage stage;
    shadow_system system;
    example::light light = make_light(system, stage.scene);
    umbrage::image<float> map = depth_pass(system, stage.scene, light);

    [[nodiscard]] umbrage::penumbra_params softness() const {
        return umbrage::make_penumbra_params(light.space, map.size(), light_radius, 1.0f, max_radius);
    }
};

scene_of_soft make_scene_of(depth_kind depth, float reach, const settings& o, const std::filesystem::path& folder) {
    shadow_system system = radeon_8500;
    system.depth = depth;
    system.reach = covered(reach);
    scene_of_soft out{.stage{system, {.output = folder, .size = 3}}, .system = system};
    out.stage.camera =
        make_camera({.target = {0.25f, 0.3f, -0.5f}, .elevation = 40, .distance = 7.5f, .fov = 20, .aspect = 1});
    out.stage.seen = camera_pass(out.stage.scene.geometry, out.stage.camera, glm::ivec2(o.size * 2 / 3));
    return out;
}

/// @param made   map, where progress is told -> lookup
template <class Make>
void add_soft(page& page, const scene_of_soft& on, std::string_view name, const std::string& about, int bytes,
              const std::vector<glsl::snippet>& snippets, const Make& made) {
    const glm::ivec2 size = on.stage.seen.size();
    const glm::mat4 to_texels = umbrage::texture_matrix(on.light.space, on.map.size());
    const glm::vec3 nothing = umbrage::project_coordinate(glm::vec4(0));
    umbrage::image<float> x(size, nothing.x), y(size, nothing.y), depth(size, nothing.z), visibility(size);
    const std::string_view bias_name = usual_bias(name);
    const bool in_planes = compares_along_plane(bias_name);
    umbrage::image<float> slope_x(in_planes ? size : glm::ivec2(0)), slope_y(slope_x.size());
    const bias_light by = make_bias_light(on.light.space, on.light.direction, on.map.size(), on.system.reach,
                                          on.light.w(on.stage.scene.target));
    on.stage.for_each_surface([&](glm::ivec2 pixel, const surface& s) {
        receiver_bias bias;
        with_bias(bias_name, [&](const auto& of) {
            bias = of(by, {s.position, s.face_normal, on.light.direction, on.light.w(s.position)});
        });
        if (in_planes) slope_x[pixel] = bias.slope.x, slope_y[pixel] = bias.slope.y;
        const glm::vec3 p = umbrage::project_coordinate(umbrage::shadow_coordinate(to_texels, s.position));
        x[pixel] = p.x, y[pixel] = p.y;
        const float even = on.light.depth(on.system, umbrage::biased(p.z, bias.depth));
        depth[pixel] = umbrage::biased(even, in_planes ? 0x1p-17f : 0x1p-18f);  // floats, rounded twice
    });
    progress quiet(1, true);
    look_up filter;
    const double map_ms = best_of_5([&] { filter = made(on.map.view(), quiet); });
    const double ms = best_of_5([&] { filter({{x, y, depth}, slope_x, slope_y}, visibility.view()); });
    page.entry(name, name, about,
               {{page.picture(on.stage.shade(on.system, on.light, visibility)), "Shaded"},
                {page.picture(gray(visibility)), "Visibility"}},
               {{"bias", std::string(bias_name)},
                {"a texel", std::to_string(bytes) + " bytes"},
                {text("map of %s", sides(on.system.map_size).c_str()), milliseconds(map_ms)},
                {text("%d receivers, best of 5", size.x * size.y), milliseconds(ms)}},
               together_and_alone(snippets));
}

}  // namespace

void add_soft_shadows(page& page, const settings& o, const std::filesystem::path& folder) {
    page.section(
        "soft", "Soft shadows",
        text("A pillar with a ball, lit by a disc %g across. Contact hardening uses that size: shadows are sharp "
             "at the pillar's foot and soft below the ball. Prefiltered maps have one softness, a blur of %d texels. "
             "Their shadows cost a single lookup.",
             2 * double(light_radius), 2 * blur + 1));
    const scene_of_soft projected = make_scene_of(depth_kind::projected, *soft_reach("pcss16", max_radius), o, folder);
    umbrage::filters::soft::for_each([&](const auto& filter) {
        add_soft(page, projected, filter.name, sentence(filter.snippet->summary), sizeof(float),
                 {glsl::disc_rotation, *filter.snippet}, [&](auto map, progress& quiet) {
                     return contact_hardening(filter.name, map, projected.softness(), quiet);
                 });
    });
    const scene_of_soft linear =
        make_scene_of(depth_kind::linear, *soft_reach("summed_variance", max_radius), o, folder);
    const auto add_prefiltered = [&](std::string_view name, const std::string& about,
                                     const std::vector<glsl::snippet>& snippets) {
        add_soft(page, linear, name, about, prefilter_bytes(name), snippets,
                 [&](auto map, progress& quiet) { return prefiltered(name, map, blur, quiet); });
    };
    umbrage::prefilters::all::for_each([&](const auto& filter) {
        add_prefiltered(filter.name, sentence(filter.writer->summary) + ' ' + sentence(filter.snippet->summary),
                        {*filter.writer, *filter.snippet});
    });
    for (const auto* table : {&glsl::summed_variance, &glsl::summed_moments})
        add_prefiltered(table->name, sentence(table->summary), {*table});
}

}  // namespace gallery
