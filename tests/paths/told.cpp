// SPDX-License-Identifier: MIT
#include "told.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>

#include <umbrage/umbrage.hpp>

namespace paths {
namespace {

using namespace umbrage;

bounding_box<double> scene_of(const job& j) { return {j.point("low"), j.point("high")}; }

frustum<double> camera_of(const job& j, const clip_space& clip) {
    return make_frustum<double>({.view = j.matrix("view"),
                                 .projection = j.matrix("projection"),
                                 .z_near = j.number("camera_near"),
                                 .z_far = j.number("camera_far"),
                                 .clip = clip});
}

template <std::size_t Count>
auto splits_of(const job& j) {
    return practical_splits<Count>(j.number("camera_near"), j.number("camera_far"), 0.9);
}

adaptive_maps pages_of(const job& j, const clip_space& clip, int size, int gutter) {
    const bounding_box<double> scene = scene_of(j);
    const auto root = make_page_root<double>({.direction = j.point("along"),
                                              .center = (scene.low + scene.high) / 2.0,
                                              .side = 1.01 * glm::distance(scene.low, scene.high),
                                              .scene = scene,
                                              .clip = clip});
    const light_space<double> camera{j.matrix("view"), j.matrix("projection"), clip};
    const auto to_root = page_matrix(root), coarsest = texture_matrix(root, glm::ivec2(size - 2 * gutter)),
               to_pixels = texture_matrix(camera, glm::ivec2(j.numbers("picture")[0], j.numbers("picture")[1]));
    std::vector<page_receiver> receivers;
    const std::vector<glm::vec3> seen = j.vertices("seen");
    for (std::size_t i = 0; i < seen.size(); i += 2) {
        const glm::dvec3 position = j.point("origin") + glm::dvec3(seen[i]), normal(seen[i + 1]);
        const double facing = glm::dot(normal, -glm::normalize(j.point("along")));
        if (!(facing > 0)) continue;
        const double extent = longest_extent(pixels_per_texel(coarsest, to_pixels, position, normal));
        receivers.push_back(
            {glm::vec2(shadow_coordinate(to_root, position)), float(std::min(1.0, 4 * facing) * extent)});
    }
    page_cache cache({.slots = {8, 8}, .deepest_level = adaptive_maps::deepest_level});
    static_cast<void>(cache.update(receivers));
    return {root, cache, {.texels = size - 2 * gutter, .gutter = gutter}};
}

/// Calls use(light) with the light of a job.
template <class Use>
void with_light(const job& j, const clip_space& clip, int size, float reach, const Use& use) {
    const std::string& setup = j.text("setup");
    const int border = int(std::ceil(reach)) + 2;
    const auto fit = [&] {
        return cascade_fit<double>{.camera = camera_of(j, clip),
                                   .direction = j.point("along"),
                                   .scene = scene_of(j),
                                   .map_size = glm::ivec2(size),
                                   .margin = std::ceil(reach) + 1,
                                   .overlap = 0.1,
                                   .clip = clip};
    };
    const auto warp = [](const auto& part) { return fit_light_space_perspective(part); };
    if (setup == "spot_light")
        use(make_spot_light<double>({.position = j.point("position"),
                                     .direction = j.point("along"),
                                     .outer_angle_radians = j.number("outer_angle_radians"),
                                     .z_near = j.number("z_near"),
                                     .z_far = j.number("z_far"),
                                     .clip = clip}));
    else if (setup == "directional_light")
        use(fit_directional_light<double>(
            {.direction = j.point("along"), .receivers = scene_of(j), .casters = scene_of(j), .clip = clip}));
    else if (setup == "warped_light")
        use(fit_light_space_perspective<double>({.camera = camera_of(j, clip),
                                                 .direction = j.point("along"),
                                                 .receivers = intersection(camera_of(j, clip), scene_of(j)),
                                                 .casters = scene_of(j),
                                                 .margin = 0.02,
                                                 .clip = clip})
                .light);
    else if (setup == "cascades") use(make_stable_cascades<4>(fit(), splits_of<4>(j)));
    else if (setup == "tight_cascades") use(make_tight_cascades<3>(fit(), splits_of<3>(j)));
    else if (setup == "cascades_8") use(make_stable_cascades<6>(fit(), splits_of<6>(j)));
    else if (setup == "warped_cascades")
        use(warped_maps(make_warped_cascades<3>(fit(), splits_of<3>(j), warp), fit().camera, fit().overlap));
    else if (setup == "adaptive_pages") use(pages_of(j, clip, size, border));
    else if (setup == "point_light")
        use(point_light<double>{j.point("position"), j.number("z_near"), j.number("z_far"), size, border, clip});
    else if (setup == "tetrahedron_light")
        use(tetrahedron_light<double>{j.point("position"), j.number("z_near"), j.number("z_far"), size, border, clip});
    else if (setup == "dual_paraboloid_light")
        use(dual_paraboloid_light<double>{j.point("position"), j.number("range"), size, border, clip});
    else throw std::runtime_error("no light is a " + setup);
}

/// Calls use(filter, encoding) with those of a job.
template <class Use>
void with_reader(const job& j, const Use& use) {
    const std::string &filter = j.text("filter"), &encoding = j.text("encoding");
    if (filter == "tent3" && encoding == "depth24") return use(filters::tent<3>, depth24{});
    if (filter == "tent3" && encoding == "depth16") return use(filters::tent<3>, depth16{});
    if (filter == "tent3" && encoding == "rg11") return use(filters::tent<3>, rg<11>{});
    if (filter == "tent3" && encoding == "rg16") return use(filters::tent<3>, rg<16>{});
    if (filter == "tent3" && encoding == "rgb24") return use(filters::tent<3>, rgb24{});
    if (encoding != "depth32f") throw std::runtime_error("no path has " + filter + " with " + encoding);
    if (filter == "tent3") return use(filters::tent<3>, depth32f{});
    if (filter == "tent7") return use(filters::tent<7>, depth32f{});
    if (filter == "castano5") return use(filters::castano<5>, depth32f{});
    if (filter == "pcf_2x2") return use(filters::pcf_2x2{}, depth32f{});
    if (filter == "hard") return use(filters::hard{}, depth32f{});
    if (filter == "disc16") return use(filters::disc{}, depth32f{});
    throw std::runtime_error("no path has the filter " + filter);
}

glsl::texture texture_of(const std::string& map) {
    using enum glsl::texture;
    for (const auto& [name, kind] : {std::pair("texture_2d", texture_2d),
                                     {"depth", depth},
                                     {"shadow", glsl::texture::shadow},
                                     {"atlas", atlas},
                                     {"array", array},
                                     {"depth_array", depth_array},
                                     {"shadow_array", shadow_array}})
        if (map == name) return kind;
    throw std::runtime_error("no map lies in a " + map);
}

/// Channels of an empty texel, as a color target is cleared to.
glm::vec4 color_of(float depth) { return {depth, 0, 0, 0}; }
template <glm::length_t N>
glm::vec4 color_of(glm::vec<N, glm::u8> texel) {
    glm::vec4 color(0);
    for (glm::length_t i = 0; i < N; ++i) color[i] = float(texel[i]) / 255.0f;
    return color;
}
glm::vec4 color_of(glm::u16 code) { return {float(code) / 65535.0f, 0, 0, 0}; }
glm::vec4 color_of(glm::u32) { return {1, 0, 0, 0}; }  // of 24 bits, in a depth texture alone

}  // namespace

told tell(const job& j, clip_space clip, glsl::shadow_slots slots) {
    std::optional<told> all;
    if (is_reversed(j)) clip.direction = depth_direction::reversed;
    slots.map = texture_of(j.text("map"));
    const int size = int(j.number("map_size"));
    with_reader(j, [&]<class Filter, class Encoding>(const Filter& filter, const Encoding& encoding) {
        with_light(j, clip, size, filter.reach(), [&](const auto& light) {
            const umbrage::shadow sun(light, glm::ivec2(size), filter, encoding, j.point("origin"));
            const auto uniforms = sun.uniforms();
            const auto* first = reinterpret_cast<const std::byte*>(&uniforms);
            const map_grid grid = std::remove_cvref_t<decltype(sun.setup())>::grid;
            all = told{.lookup = glsl::bind(sun, "sun", slots),
                       .vertex = glsl::bind_vertex_pass(sun, "sun"),
                       .write = glsl::bind_depth_pass(sun, "sun"),
                       .block = {first, first + sizeof uniforms},
                       .views = sun.depth_views(),
                       .cleared = color_of(sun.cleared()),
                       .map_size = sun.map_size(),
                       .columns = grid.columns,
                       .rows = grid.rows,
                       .channels = Encoding::target::channels,
                       .floats = std::is_same_v<decltype(sun.cleared()), float>};
        });
    });
    return *all;
}

}  // namespace paths
