// SPDX-License-Identifier: MIT
//
// Soft table: contact hardening against rays to lights that have a size, over the scenes of the picture table. Prints
// markdown, and returns 1 where pcss breaks a bound.
//
//     soft             480 x 270 pixels, every fifth along each axis
//     soft --sample    every ninth, two lights
//     soft --scenes    also each scene by itself
//
// The maps have 1024 texels: a spot light's, and one fitted to the middle of the scene under the sun. 64 rays of each
// receiver reach for points of the light.
//   RMS                of visibility against the share of rays that reach the light
//   in penumbras       the same where some rays reach it
//   lit but dark       all rays reach it, visibility below 0.9
//   light in contact   mean visibility where no ray reaches it and the caster is less than 10 texels away
//   creases            the lit sides of a concave edge, up to two texels from it: visibility below 0.9
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <memory>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/receiver_plane.hpp>
#include <umbrage/filter/blocker/dpcf.hpp>
#include <umbrage/filter/blocker/pcss.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/filter/pcf/windows.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/shadow/shadow.hpp>

#include "engines.hpp"
#include "light_maps.hpp"
#include "receivers.hpp"
#include "scenes.hpp"
#include "soft.hpp"

namespace proof::picture {
namespace {

// What pcss must keep. Filament's form is the best of engines. Its bilinear comparisons are smoother where penumbras
// are as narrow as a texel. A sample has few receivers. Scenes with meshes are hills and rings.
constexpr double most_share_of_filament = 0.9, most_share_in_penumbras = 1.05, most_share_of_sample = 1.2;
constexpr double most_contact_on_smooth_percent = 7.0;
constexpr double most_share_of_pcf_creases = 0.6;
constexpr int map_size = 1024, all_step = 5, sample_step = 9;
constexpr std::uint32_t seeds[]{1, 2, 3};

constexpr const char *pcss_row = "**pcss16**", *filament_row = "Filament's form", *pcf_row = "tent<3>";

struct soft_row {
    std::string name;
    std::function<float(const soft_receiver&)> visibility;
};
using drawn_map = std::shared_ptr<const umbrage::image<float>>;

/// PCSS as in Google's Filament: 16 points of search and 16 bilinear comparisons, along the receiver's plane, with a
/// texel of its slope as bias. Points are a Vogel spiral's. They are better spread than the first 16 of its table.
/// @param per_code   softness in this map
/// @cite             Google Filament: surface_shadowing.fs
[[nodiscard]] soft_row filament(const light_maps& maps, const drawn_map& drawn, float per_code) {
    return {filament_row, [&maps, drawn, per_code](const soft_receiver& r) {
                const auto fetch = umbrage::bordered(maps.map_of(*drawn, 0));
                const glm::vec2 coord(r.place.at), slope = r.place.slope;
                const float receiver =
                    r.place.at.z - umbrage::acne_free_bias(slope, 1.0f, maps.rounding(r.place, r.position));
                const float radius_of_depth = per_code * 4096.0f, least = 1.0f, most = 16.0f;
                const auto point = [&](int i, float radius) {
                    const double away = double(radius) * std::sqrt((i + 0.5) / 16);
                    const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0)) + noise_rotation(r.pixel);
                    return glm::vec2(away * std::cos(angle), away * std::sin(angle));
                };
                float blockers = 0, apart = 0;
                for (int i = 0; i < 16; ++i) {
                    const glm::vec2 p = point(i, std::clamp(receiver * radius_of_depth, least, most));
                    const float nearer = receiver + glm::dot(slope, p) - fetch(glm::ivec2(glm::floor(coord + p)));
                    if (nearer > 0) blockers += 1, apart += nearer;
                }
                if (blockers == 0) return 1.0f;
                float sum = 0;
                for (int i = 0; i < 16; ++i) {
                    const glm::vec2 p = point(i, std::clamp(apart / blockers * radius_of_depth, least, most));
                    sum += umbrage::filters::pcf_2x2{}(fetch, coord + p, std::min(receiver + glm::dot(slope, p), 1.0f));
                }
                return sum / 16;
            }};
}

/// Rows of one light, whose map is drawn.
template <class Shadow>
[[nodiscard]] std::vector<soft_row> rows_of(const light_maps& maps, const drawn_map& drawn, const Shadow& plain,
                                            float size) {
    using namespace umbrage;
    std::vector<soft_row> rows;
    const auto add = [&]<class Filter>(std::string name, Filter filter, float max_radius) {
        filter.softness = make_penumbra_params(size, 1.0f, max_radius);
        const shadow s(plain.setup(), plain.map_size(), filter);
        rows.push_back(
            {std::move(name), [s, drawn](const soft_receiver& r) { return s(*drawn, r.position, r.normal, r.pixel); }});
        return s.filter_of(0);
    };
    const filters::pcss in_map = add(pcss_row, filters::pcss{}, 16);
    add("pcss32", filters::pcss{.points = 32}, 16);
    add("pcss16, max_radius 48", filters::pcss{}, 48);
    add("dpcf16", filters::dpcf{}, 16);
    rows.push_back({pcf_row, [plain, drawn](const soft_receiver& r) { return plain(*drawn, r.position, r.normal); }});
    rows.push_back(filament(maps, drawn, in_map.softness.per_code_x));
    const auto by_slope = [&](std::string name, const auto& filter) {
        rows.push_back({std::move(name), [&maps, drawn, filter](const soft_receiver& r) {
                            const float bias = acne_free_bias(r.place.slope, 0.5f, maps.rounding(r.place, r.position));
                            const glm::vec3 at = r.place.at - glm::vec3(0, 0, bias);
                            const auto fetch = bordered(maps.map_of(*drawn, 0));
                            const auto along = apply_receiver_plane(fetch, r.place.slope, at);
                            return detail::filtered(filter, along, glm::vec2(at), at.z, r.pixel);
                        }});
    };
    by_slope("tried: pcss16, half a texel of slope in place of a texel's width", in_map);
    by_slope("tried: tent<3>, the same", filters::tent<3>);
    return rows;
}

struct sized_light {
    bool is_sun = false;
    double size = 0;
    std::string_view name;
    bool in_sample = false;
};
constexpr sized_light all_lights[]{
    {false, 0.05, "spot light of radius 0.05"}, {false, 0.2, "spot light of radius 0.2", true},
    {false, 0.5, "spot light of radius 0.5"},   {true, 0.00465, "sun of tangent 0.00465"},
    {true, 0.02, "sun of tangent 0.02", true},  {true, 0.06, "sun of tangent 0.06"}};

[[nodiscard]] umbrage::light_space<double> light_of(const scene& s, bool is_sun) {
    using namespace umbrage;
    clip_space clip = cpu_clip_space;
    clip.subpixel_bits = 8;
    if (is_sun)
        return fit_directional_light<double>({.direction = s.sun,
                                              .receivers = bounding_box<double>{{-8, -1, -8}, {8, 4, 8}},
                                              .casters = box_of(s.mesh),
                                              .clip = clip});
    return make_spot_light<double>({.position = s.spot,
                                    .direction = s.spot_target - s.spot,
                                    .up = {0, 0, 1},
                                    .outer_angle_radians = s.spot_angle,
                                    .z_near = 0.5,
                                    .z_far = s.reach,
                                    .clip = clip});
}

[[nodiscard]] soft_table measure(const scene& s, const ray_tree& tree, const sized_light& light, int step) {
    using namespace umbrage;
    const shadow plain(light_of(s, light.is_sun), glm::ivec2(map_size), filters::tent<3>);
    const ray_light rays = light.is_sun ? ray_light{false, -glm::normalize(s.sun)} : ray_light{true, s.spot};
    const light_maps maps(light.is_sun ? light_kind::sun : light_kind::spot, plain, rays, s.reach);
    const auto drawn = std::make_shared<image<float>>(plain.size(), 1.0f);
    plain.draw(*drawn, s.mesh.view());
    const auto place_of = [&plain](glm::vec3 p, glm::vec3 n) {
        return single_map::places(plain.uniforms().maps, plain.uniforms().terms, p, n)[0];
    };
    const std::vector<soft_receiver> receivers = soft_receivers(s, tree, maps, place_of, light.size, step);
    soft_table found;
    for (const soft_row& row : rows_of(maps, drawn, plain, float(light.size))) {
        soft_tally sums;
        for (const soft_receiver& r : receivers) sums.add(r, row.visibility(r));
        found.add(row.name, sums);
    }
    return found;
}

/// Two lit planes that meet in a concave edge of a number of degrees, in 40 places and lights.
[[nodiscard]] soft_table creases(const sized_light& light, double degrees) {
    using namespace umbrage;
    std::mt19937 random(5);
    const auto any = [&] { return 0x1p-31 * double(random()) - 1; };
    const auto way = [&] { return glm::normalize(glm::dvec3{any(), any(), any()}); };
    soft_table found;
    for (int i = 0; i < 40; ++i) {
        const glm::dvec3 along = way(), first = glm::normalize(glm::cross(along, way())),
                         away = glm::cross(along, first);
        const double c = std::cos(degrees * std::numbers::pi / 180), sine = std::sin(degrees * std::numbers::pi / 180);
        const glm::dvec3 second = c * first - sine * away, rises = c * away + sine * first;
        ray_mesh mesh;
        for (const glm::dvec3 side : {glm::dvec3(0), -4.0 * away, 4.0 * rises})
            for (const double end : {-4.0, 4.0}) mesh.positions.emplace_back(end * along + side);
        mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}};
        glm::dvec3 to_light = glm::normalize(first + second);
        for (int tries = 0; tries < 100; ++tries) {
            const glm::dvec3 other = glm::normalize(first + second + 1.5 * way());
            if (glm::dot(other, first) > 0.25 && glm::dot(other, second) > 0.25) to_light = other;
        }
        const scene s{
            .name = "", .mesh = mesh, .spot = 9.0 * to_light, .sun = -to_light, .spot_angle = 0.5, .reach = 16};
        const shadow plain(light_of(s, light.is_sun), glm::ivec2(map_size / 2), filters::tent<3>);
        const ray_light rays = light.is_sun ? ray_light{false, to_light} : ray_light{true, s.spot};
        const light_maps maps(light.is_sun ? light_kind::sun : light_kind::spot, plain, rays, s.reach);
        const auto drawn = std::make_shared<image<float>>(plain.size(), 1.0f);
        plain.draw(*drawn, mesh.view());
        std::vector<soft_receiver> receivers;
        for (int k = 0; k < 1000; ++k) {
            const glm::dvec3 edge = 3.0 * any() * along;
            const double from = (any() + 1) * maps.texel(0, edge);
            const glm::vec3 p(edge + from * (k % 2 == 0 ? -away : rises)), n(k % 2 == 0 ? first : second);
            receivers.push_back({p, n, {k / 2 % 4, k / 8 % 4}, {}, 1.0f});
            receivers.back().place = single_map::places(plain.uniforms().maps, plain.uniforms().terms, p, n)[0];
        }
        for (const soft_row& row : rows_of(maps, drawn, plain, float(light.size))) {
            soft_tally sums;
            for (const soft_receiver& r : receivers) sums.add(r, row.visibility(r));
            found.add(row.name, sums);
        }
    }
    return found;
}

[[nodiscard]] bool is_at_most(std::string_view light, const char* what, double is, double most) {
    const bool keeps = is <= most;  // false for NaN
    std::printf("%.*s, %s: %.3f, at most %.3f%s\n", int(light.size()), light.data(), what, is, most,
                keeps ? "" : " BROKEN");
    return keeps;
}

int run(bool is_sample, bool by_scene) {
    const int step = is_sample ? sample_step : all_step;
    bool keeps = true;
    for (const sized_light& light : all_lights) {
        if (is_sample && !light.in_sample) continue;
        soft_table all, smooth;
        for (const auto& make : {boxes_with_eaves, thin_fence, hills, room, rings_and_boxes}) {
            soft_table own;
            std::string name;
            for (const std::uint32_t seed : std::span(seeds).first(is_sample ? 1 : 3)) {
                scene s = make(seed, glm::dvec3(0));
                if (light.is_sun && !s.has_sun) continue;
                if (!s.has_sun) s.spot = {-2.5, 2.2, 1.5};  // clear of the ceiling by more than its radius
                name = s.name;
                const soft_table found = measure(s, ray_tree(s.mesh), light, step);
                own += found;
                if (s.smooth > 0) smooth += found;
            }
            all += own;
            if (by_scene && !name.empty()) own.print(name + ", " + std::string(light.name));
        }
        all.print(light.name);
        soft_table edges;
        for (const double degrees : {6.0, 20.0, 45.0, 90.0, 120.0}) edges += creases(light, degrees);
        edges.print_creases(light.name);
        std::printf("\n");
        const soft_tally own = all.of(pcss_row), filament = all.of(filament_row);
        const auto expect = [&](const char* what, double is, double most) {
            keeps = is_at_most(light.name, what, is, most) && keeps;
        };
        expect("RMS, share of Filament's", own.rms_percent() / filament.rms_percent(),
               is_sample ? most_share_of_sample : most_share_of_filament);
        expect("RMS in penumbras, share of Filament's", own.penumbra_percent() / filament.penumbra_percent(),
               is_sample ? most_share_of_sample : most_share_in_penumbras);
        expect("creases, share of tent<3>", edges.of(pcss_row).dark_percent() / edges.of(pcf_row).dark_percent(),
               most_share_of_pcf_creases);
        if (light.is_sun)
            expect("light in contact on scenes with meshes, %", smooth.of(pcss_row).contact_percent(),
                   most_contact_on_smooth_percent);
    }
    return keeps ? 0 : 1;
}

}  // namespace
}  // namespace proof::picture

int main(int count, char** arguments) {
    bool is_sample = false, by_scene = false;
    for (int i = 1; i < count; ++i) {
        const std::string_view argument = arguments[i];
        if (argument == "--sample") is_sample = true;
        else if (argument == "--scenes") by_scene = true;
        else return std::fprintf(stderr, "usage: soft [--sample] [--scenes]\n"), 2;
    }
    return proof::picture::run(is_sample, by_scene);
}
