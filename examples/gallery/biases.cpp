// SPDX-License-Identifier: MIT
//
// Acne against detachment: the exercise's shadow, by several biases, where rays to the light have another opinion.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/trigonometric.hpp>

#include <umbrage/bias/constant.hpp>
#include <umbrage/bias/receiver_plane.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include <biases.hpp>
#include <rays.hpp>

#include "sections.hpp"

namespace gallery {
namespace {

using namespace example;
namespace glsl = umbrage::glsl;

struct scene_of_biases {
    example::stage stage;
    shadow_system system;
    example::light light = make_light(system, stage.scene);
    umbrage::image<float> map = depth_pass(system, stage.scene, light);
    glm::mat4 to_texels = umbrage::texture_matrix(light.space, map.size());
    umbrage::image<by_rays> expected = traced(stage, light, system.map_size, 1);

    bias_light seen_by = make_bias_light(light.space, light.direction, map.size(),
                                         covered(umbrage::filters::hard{}.reach()), light.w(stage.scene.target));

    /// Visibility under by(surface), a receiver_bias.
    template <class By>
    [[nodiscard]] umbrage::image<float> visibility(By&& by) const {
        const auto fetch = umbrage::bordered(map, 1.0f);
        return stage.visibility([&](const example::surface& s) {
            const receiver_bias moved = by(s);
            const glm::vec3 p =
                umbrage::project_coordinate(umbrage::shadow_coordinate(to_texels, s.position + moved.offset));
            const glm::vec3 at(p.x, p.y, umbrage::biased(p.z, moved.depth + 0x1p-20f));
            return umbrage::hard(umbrage::apply_receiver_plane(fetch, moved.slope, at), glm::vec2(at), at.z);
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
                {page.picture(gray(visibility)), "Visibility, white is lit"}},
               {{"dark where rays find light", text("%d of %d pixels", acne, lit)},
                {"lit where rays find none", text("%d of %d pixels", leaks, shadow)}},
               together_and_alone(std::move(snippets)));
}

/// A name as a title.
std::string titled(std::string_view name) {
    std::string out(name);
    std::ranges::replace(out, '_', ' ');
    out[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(out[0])));
    return out;
}

}  // namespace

void add_biases(page& page, const settings& o, const std::filesystem::path& folder) {
    shadow_system system = exercise;
    system.depth = depth_kind::projected;
    const scene_of_biases on{.stage{system, {.output = folder, .size = o.size}}, .system = system};
    const float epsilon =
        exercise.epsilon * exercise.z_far / (exercise.z_far - exercise.z_near);  // of its linear depth
    const auto point_of = [&](const surface& s) {
        return bias_point{s.position, s.face_normal, on.light.direction, on.light.w(s.position)};
    };
    const auto constant = [](float bias) { return [bias](const surface&) { return receiver_bias{.depth = bias}; }; };

    float steepest = 0;  // bias of what the light meets at up to 87 degrees
    on.stage.for_each_surface([&](glm::ivec2, const surface& s) {
        if (glm::dot(s.face_normal, -on.light.direction) > std::cos(glm::radians(87.0f)))
            steepest = std::max(steepest, biases::acne_free{}(on.seen_by, point_of(s)).depth);
    });

    page.section(
        "biases", "Biases",
        text("The exercise's scene under one comparison, with a map of %d × %d texels. With too little bias surfaces "
             "shadow themselves (acne). With too much, shadows leave their casters (peter-panning). Colored pixels "
             "differ from rays to the light, except at edges.",
             system.map_size.x, system.map_size.y));
    add_bias(page, on, "epsilon", "The exercise's epsilon",
             "0.0005 of the far plane's distance, at every slope. It suffices only for surfaces that face the light.",
             on.visibility(constant(epsilon)), {glsl::biased});
    add_bias(page, on, "steepest", "A constant that suffices",
             text("%.3f in depth, as the steepest surface needs, up to 87 degrees from the light. Casters nearer than "
                  "that lose their shadows.",
                  double(steepest)),
             on.visibility(constant(steepest)), {glsl::biased});
    biases::all::for_each([&](const auto& bias) {
        add_bias(page, on, bias.name, titled(bias.name), bias.about,
                 on.visibility([&](const surface& s) { return bias(on.seen_by, point_of(s)); }), bias.snippets());
    });
}

}  // namespace gallery
