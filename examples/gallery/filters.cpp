// SPDX-License-Identifier: MIT
#include <algorithm>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/bias/constant.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/images/visibility.hpp>
#include <umbrage/registry.hpp>

#include <biases.hpp>

#include "sections.hpp"

namespace gallery {
namespace {

using namespace example;
namespace glsl = umbrage::glsl;

/// Functions of any filter that the page needs. The rest is compiled once.
struct any_filter {
    float reach;
    std::function<void(const umbrage::image<float>& map, const umbrage::image<glm::vec3>& receivers,
                       umbrage::image<float>& out)>
        visibility;
    std::function<int(const umbrage::image<float>& map, glm::vec3 receiver)> fetches;
};

template <class Filter>
any_filter erased(const Filter& filter) {
    return {filter.reach(),
            [=](const auto& map, const auto& receivers, auto& out) {
                umbrage::visibility(map, umbrage::depth32f{}, receivers, filter, out);
            },
            [=](const auto& map, glm::vec3 receiver) {
                int taps = 0;
                const auto fetch = [&, texel = umbrage::bordered(map)](glm::ivec2 t) { return ++taps, texel(t); };
                static_cast<void>(filter(fetch, glm::vec2(receiver), receiver.z));
                return taps;
            }};
}

void add_filter(page& page, const settings& o, const std::filesystem::path& folder, std::string_view id,
                std::string_view title, std::string_view about, const any_filter& filter,
                const std::vector<glsl::snippet>& snippets) {
    shadow_system system = radeon_8500;
    system.map_size = glm::ivec2(256);
    system.reach = covered(filter.reach);
    system.epsilon = 0x1p-18f;  // floats, rounded twice
    stage stage(system, {.output = folder, .size = 3});
    const glm::ivec2 size(o.size * 2 / 3);
    stage.camera = make_camera({.target = {-1.75f, 0, 0.35f}, .elevation = 55, .distance = 7.5f, .fov = 10});
    stage.seen = camera_pass(stage.scene.geometry, stage.camera, size);

    const light light = make_light(system, stage.scene);
    const auto map = depth_pass(system, stage.scene, light);
    const glm::mat4 to_texels = umbrage::texture_matrix(light.space, map.size());
    const bias_light by =
        make_bias_light(light.space, light.direction, map.size(), system.reach, light.w(stage.scene.target));
    umbrage::image<glm::vec3> receivers(size, umbrage::project_coordinate(glm::vec4(0)));
    stage.for_each_surface([&](glm::ivec2 pixel, const surface& s) {
        const receiver_bias bias =
            biases::acne_free{}(by, {s.position, s.face_normal, light.direction, light.w(s.position)});
        const glm::vec3 p = umbrage::project_coordinate(umbrage::shadow_coordinate(to_texels, s.position));
        const float even = light.depth(system, umbrage::biased(p.z, bias.depth));
        receivers[pixel] = {p.x, p.y, umbrage::biased(even, system.epsilon)};
    });

    umbrage::image<float> visibility(size);
    const double ms = best_of_5([&] { filter.visibility(map, receivers, visibility); });
    int most_taps = 0;
    for (glm::vec3 r : receivers.texels()) most_taps = std::max(most_taps, filter.fetches(map, r));
    std::vector<float> levels(visibility.texels().begin(), visibility.texels().end());
    std::ranges::sort(levels);
    const auto different = std::ranges::unique(levels).begin() - levels.begin();
    const double count = double(receivers.texels().size());
    page.entry(id, title, about,
               {{page.picture(stage.shade(system, light, visibility)), "Shaded"},
                {page.picture(gray(visibility)), "Visibility"}},
               {{"fetches", std::to_string(most_taps)},
                {"bias", std::string(biases::acne_free::name)},
                {"levels in this picture", std::to_string(different)},
                {text("%.0f receivers, best of 5", count), text("%.3f ms", ms)},
                {"each", text("%.1f ns", ms * 1e6 / count)}},
               together_and_alone(snippets));
}

}  // namespace

void add_filters(page& page, const settings& o, const std::filesystem::path& folder) {
    page.section("filters", "Filters",
                 "One edge of a shadow, from a map of 256 × 256 texels, seen from near. Smoother edges read "
                 "more texels.");
    umbrage::for_each_filter([&]<class Filter>(Filter filter) {
        const std::string name(filter.name), about = sentence(filter.snippet->summary);
        std::vector<glsl::snippet> snippets{*filter.snippet};
        if constexpr (requires { filter.offsets; }) snippets.push_back(glsl::tap_coordinate);
        if constexpr (requires { filter.radius; })
            for (const int radius : {1, 2, 4, 8}) {
                filter.radius = radius;
                const std::string each = name + "_" + std::to_string(radius);
                add_filter(page, o, folder, each, each,
                           about + text(" %d × %d texels.", 2 * radius + 1, 2 * radius + 1), erased(filter), snippets);
            }
        else add_filter(page, o, folder, name, name, about, erased(filter), snippets);
    });
}

}  // namespace gallery
