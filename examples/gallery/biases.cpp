// SPDX-License-Identifier: MIT
//
// Acne against detachment: the exercise's shadow, by several biases, where rays to the light have another opinion.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/trigonometric.hpp>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/constant.hpp>
#include <umbrage/bias/slope.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include <rays.hpp>

#include "sections.hpp"

namespace gallery {
namespace {

using namespace example;
namespace glsl = umbrage::glsl;

struct scene_of_biases {
    example::stage stage;
    shadow_system system;
    example::light light = make_light(system, stage.scene, system.azimuth, system.elevation, system.map_size);
    umbrage::image<float> map = depth_pass(system, stage.scene, light, system.map_size);
    glm::mat4 to_texels = umbrage::texture_matrix(light.space, map.size());
    umbrage::image<by_rays> expected = traced(stage, light, system.map_size, 1);

    /// Visibility of what is looked up at point(surface), with bias(surface) in z/w.
    template <class Point, class Bias>
    [[nodiscard]] umbrage::image<float> visibility(Point&& point, Bias&& bias) const {
        const auto fetch = umbrage::bordered(map, 1.0f);
        return stage.visibility([&](const example::surface& s) {
            const glm::vec3 p = umbrage::project_coordinate(umbrage::shadow_coordinate(to_texels, point(s)));
            return umbrage::hard(fetch, glm::vec2(p), umbrage::biased(p.z, bias(s)));
        });
    }
};

void add_bias(page& page, const scene_of_biases& on, std::string_view id, std::string_view title,
              std::string_view about, const umbrage::image<float>& visibility, std::vector<glsl::snippet> snippets) {
    picture shaded = on.stage.shade(on.system, on.light, visibility);
    int lit = 0, shadow = 0, acne = 0, leaks = 0;
    for (std::size_t i = 0; i < shaded.texels().size(); ++i) {
        const by_rays expected = on.expected.texels()[i];
        const bool is_lit = visibility.texels()[i] > 0.5f;
        lit += expected == by_rays::lit;
        shadow += expected == by_rays::shadow;
        if (expected == by_rays::lit && !is_lit) ++acne, shaded.texels()[i] = {230, 20, 40};
        if (expected == by_rays::shadow && is_lit) ++leaks, shaded.texels()[i] = {30, 90, 255};
    }
    page.entry(id, title, about,
               {{page.picture(shaded), "Red: acne. Blue: shadow that is lost"},
                {page.picture(grey(visibility)), "Visibility, white is lit"}},
               {{"dark where rays find light", text("%d of %d pixels", acne, lit)},
                {"lit where rays find none", text("%d of %d pixels", leaks, shadow)}},
               together_and_alone(std::move(snippets)));
}

}  // namespace

void add_biases(page& page, const settings& o, const std::filesystem::path& folder) {
    shadow_system system = exercise;
    system.depth = depth_kind::projected;
    const scene_of_biases on{.stage{system, {.output = folder, .size = o.size}}, .system = system};
    const float epsilon = exercise.bias * exercise.z_far / (exercise.z_far - exercise.z_near);  // of its linear depth
    const glm::mat4 planes = umbrage::plane_matrix(on.to_texels);
    const float reach = umbrage::filters::hard{}.reach() + umbrage::snapping_reach<float>, rounding = 0x1p-20f;
    const auto slope_of = [&](const surface& s) { return umbrage::plane_slope(planes, s.face_normal, s.position); };
    const auto itself = [](const surface& s) { return s.position; };
    const auto constant = [](float bias) { return [bias](const surface&) { return bias; }; };

    float steepest = 0;  // bias of what the light meets at up to 87 degrees
    on.stage.for_each_surface([&](glm::ivec2, const surface& s) {
        if (glm::dot(s.face_normal, -on.light.direction) > std::cos(glm::radians(87.0f)))
            steepest = std::max(steepest, umbrage::acne_free_bias(slope_of(s), reach, rounding));
    });

    page.section(
        "biases", "Biases",
        text("The exercise's scene, of which its map has %d × %d texels, with one comparison. Too little bias "
             "and surfaces shadow themselves; too much, and shadows come off what casts them. Where rays to the "
             "light are of another opinion, edges aside, is coloured.",
             system.map_size, system.map_size));
    add_bias(page, on, "epsilon", "The exercise's epsilon",
             "0.0005 of the far plane's distance, whatever the slope: too little for all but what faces the light.",
             on.visibility(itself, constant(epsilon)), {glsl::biased});
    add_bias(page, on, "constant", "A constant that suffices",
             text("%.3f in depth, which the steepest surface needs up to 87 degrees from the light: shadows of what is "
                  "nearer are lost.",
                  double(steepest)),
             on.visibility(itself, constant(steepest)), {glsl::biased});
    add_bias(
        page, on, "acne_free", "The smallest bias",
        "By the slope of each surface, the filter's reach and the map's error: no plane shadows itself, and none is "
        "biased by more than that takes.",
        on.visibility(itself, [&](const surface& s) { return umbrage::acne_free_bias(slope_of(s), reach, rounding); }),
        {glsl::plane_slope, glsl::acne_free_bias, glsl::biased});
    add_bias(page, on, "normal_offset", "Normal offset",
             "Looked up off the surface, by what its tilt asks for: nothing where light falls straight on it.",
             on.visibility(
                 [&](const surface& s) { return lifted(system, on.light, s.position, s.face_normal, system.map_size); },
                 constant(rounding)),
             {glsl::texels_to_world, glsl::normal_offset, glsl::biased});
}

}  // namespace gallery
