// SPDX-License-Identifier: MIT
#include "setups.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <umbrage/core/unorm.hpp>
#include <umbrage/debug/false_color.hpp>
#include <umbrage/images/depth_span.hpp>
#include <umbrage/light/adaptive/pages.hpp>
#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/cascades/splits.hpp>
#include <umbrage/light/cascades/warped.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/light_choice.hpp>
#include <umbrage/light/spot_fit.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/light/warp/light_position.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/perspective.hpp>
#include <umbrage/light/warp/plane_optimal.hpp>
#include <umbrage/light/warp/trapezoidal.hpp>
#include <umbrage/light/warp/warp_fit.hpp>

#include "point_maps.hpp"
#include "sun_pages.hpp"
#include "surface.hpp"

namespace example {
namespace {

using frustum = umbrage::frustum<double>;
constexpr auto clip = umbrage::cpu_clip_space;

umbrage::bounding_box<double> whole(const scene& s) { return {s.low, s.high}; }
umbrage::polyhedron seen(const lit_view& v, const frustum& range) { return intersection(range, whole(v.scene)); }

glm::dmat4 to_pixels(const lit_view& v) {
    return umbrage::texture_matrix<double>({glm::dmat4(1), glm::dmat4(v.camera.world_to_clip), picture_clip},
                                           v.seen.size());
}

placed_maps one_map(const lit_view& v, const glm::dvec4& light, const umbrage::light_space<double>& space) {
    const glm::ivec2 size(v.map_size);
    return with_matrices(size, light, {umbrage::texture_matrix(space, size)}, [](glm::dvec3) { return 0; });
}

placed_maps directional(const lit_view& v, const umbrage::hull& receivers, glm::dvec3 up, glm::ivec2 snap_texels = {}) {
    return one_map(v, {-v.light.direction, 0},
                   umbrage::fit_directional_light<double>({.direction = v.light.direction,
                                                           .up = up,
                                                           .receivers = receivers,
                                                           .casters = whole(v.scene),
                                                           .snap_texels = snap_texels,
                                                           .clip = clip}));
}

/// Around what receives shadows in the cone; where that is nothing, around the scene.
placed_maps spot(const lit_view& v, const umbrage::polyhedron& receivers) {
    umbrage::spot_fit<double> fit{.position = v.light.position,
                                  .direction = v.light.direction,
                                  .up = v.light.up,
                                  .outer_angle_radians = v.light.outer_angle_radians,
                                  .receivers = receivers,
                                  .casters = whole(v.scene),
                                  .clip = clip};
    const auto light = umbrage::fit_spot_light(fit);
    fit.receivers = whole(v.scene);
    return one_map(v, {v.light.position, 1}, light ? *light : umbrage::fit_spot_light(fit).value());
}

umbrage::warp_fit<double> warp_fit(const lit_view& v, const frustum& range) {
    return {.camera = range,
            .direction = v.light.direction,
            .receivers = seen(v, range),
            .casters = whole(v.scene),
            .clip = clip};
}

/// A perspective shadow map of the spot, around what is seen in its cone.
placed_maps perspective_spot(const lit_view& v) {
    const umbrage::light_position<double> lamp{.position = v.light.position};
    const double edge = std::tan(v.light.outer_angle_radians);
    const frustum cone{.position = lamp.position,
                       .direction = v.light.direction,
                       .tan_half_x = edge,
                       .tan_half_y = edge,
                       .z_near = 2 * lamp.z_near,
                       .z_far = 2 * v.planes.z_far};
    umbrage::warp_fit<double> fit = warp_fit(v, v.planes);
    fit.receivers = intersection(seen(v, v.planes), cone);
    return one_map(v, {v.light.position, 1}, umbrage::fit_perspective(fit, lamp).light);
}

template <class Cascades>
placed_maps of_cascades(const lit_view& v, const Cascades& all, const std::array<double, 5>& splits) {
    const glm::ivec2 size(v.map_size / 2);
    std::vector<glm::dmat4> matrices;
    for (const auto& c : all) matrices.push_back(umbrage::texture_matrix(c.light, size));
    const glm::dvec3 ends(splits[1], splits[2], splits[3]);
    return with_matrices(size, {-v.light.direction, 0}, matrices,
                         [ends, eye = v.planes.position, ahead = v.planes.direction](glm::dvec3 p) {
                             return static_cast<int>(umbrage::cascade_by_depth(glm::dot(p - eye, ahead), ends));
                         });
}

umbrage::cascade_fit<double> cascade_fit(const lit_view& v, const frustum& range, glm::dvec3 up) {
    return {.camera = range,
            .direction = v.light.direction,
            .up = up,
            .scene = whole(v.scene),
            .map_size = glm::ivec2(v.map_size / 2),
            .clip = clip};
}

placed_maps cascades(const lit_view& v, const frustum& range, double lambda, bool stable) {
    const auto fit = cascade_fit(v, range, stable ? v.light.up : range.direction);
    const auto splits = umbrage::practical_splits<4>(range.z_near, range.z_far, lambda);
    return of_cascades(
        v, stable ? umbrage::make_stable_cascades<4>(fit, splits) : umbrage::make_tight_cascades<4>(fit, splits),
        splits);
}

placed_maps warped(const lit_view& v, const umbrage::warped_light<double>& warp) {
    return one_map(v, {-v.light.direction, 0}, warp.light);
}
using fit = umbrage::warp_fit<double>;
using warp = umbrage::warped_light<double>;

warp light_space(const fit& f) { return umbrage::fit_light_space_perspective(f); }
warp mild_light_space(const fit& f) {
    return umbrage::fit_light_space_perspective<double>(f, umbrage::optimal_distance(f));
}
warp trapezoidal(const fit& f) { return umbrage::fit_trapezoidal(f, std::sqrt(f.camera.z_near * f.camera.z_far)); }

/// The best single map for one in 16 x 16 of the pixels that are seen.
placed_maps best_of(const lit_view& v, const frustum& range) {
    const fit f = warp_fit(v, range);
    const std::array names{"tight", "light-space", "light-space, mild", "trapezoidal", "perspective"};
    const umbrage::directional_fit<double> plain{
        .direction = f.direction, .up = range.direction, .receivers = f.receivers, .casters = f.casters, .clip = clip};
    const std::array lights{umbrage::fit_directional_light(plain), light_space(f).light, mild_light_space(f).light,
                            trapezoidal(f).light, umbrage::fit_perspective(f).light};
    std::vector<umbrage::seen_point> points;
    for (glm::ivec2 p{0}; p.y < v.seen.size().y; p.y += 16)
        for (p.x = 0; p.x < v.seen.size().x; p.x += 16) {
            if (v.seen[p] == nothing) continue;
            const surface at = surface_at(v.scene, v.camera, v.seen, p);
            if (glm::dot(glm::dvec3(at.face_normal), v.light.direction) < 0)
                points.push_back({glm::dvec3(at.position), glm::dvec3(at.face_normal)});
        }
    const glm::ivec2 size(v.map_size);
    const std::size_t best =
        umbrage::choose_light<double>(lights, points, {.to_pixels = to_pixels(v), .map_size = size}).kept;
    placed_maps maps = one_map(v, {-v.light.direction, 0}, lights[best]);
    maps.chosen = names[best];
    return maps;
}

placed_maps warped_cascades(const lit_view& v, const frustum& range) {
    const auto f = cascade_fit(v, range, v.light.up);
    const auto splits = umbrage::practical_splits<4>(range.z_near, range.z_far, 0.9);
    return of_cascades(v, umbrage::make_warped_cascades<4>(f, splits, mild_light_space), splits);
}

/// As many texels in 256 pages around the scene, of which one in 2 x 2 of the pixels wants some.
placed_maps adaptive(const lit_view& v) {
    constexpr int deepest = 15;
    const auto root = page_root_around(v.scene.low, v.scene.high, v.light.direction, v.light.up);
    const glm::dmat4 to_root = umbrage::page_matrix(root);
    const glm::ivec2 size(v.map_size / 16);
    std::vector<glm::dmat4> levels;
    for (int level = 0; level <= deepest; ++level) levels.push_back(umbrage::texture_matrix(root, size << level));
    page_wishes wishes(root, v.light.direction, size.x, to_pixels(v));
    for (glm::ivec2 p{0}; p.y < v.seen.size().y; p.y += 2)
        for (p.x = 0; p.x < v.seen.size().x; p.x += 2) {
            if (v.seen[p] == nothing) continue;
            const surface at = surface_at(v.scene, v.camera, v.seen, p);
            wishes.add(glm::dvec3(at.position), glm::dvec3(at.face_normal));
        }
    umbrage::page_cache cache({.slots = {16, 16}, .deepest_level = deepest});
    const std::size_t drawn = cache.update(wishes.all()).drawn.size();
    const auto at = [=](glm::dvec3 p) {
        const int level = cache.level_at(glm::dvec2(umbrage::shadow_coordinate(to_root, p)));
        return level < 0 ? glm::dmat4(0) : levels[static_cast<std::size_t>(level)];
    };
    return {size, 256, {-v.light.direction, 0}, {levels[0]}, at, std::to_string(drawn) + " of them"};
}

std::vector<setup> all_setups() {
    std::vector<setup> all{
        {"whole scene", [](const lit_view& v) { return directional(v, whole(v.scene), v.light.up); }},
        {"spot", [](const lit_view& v) { return spot(v, whole(v.scene)); }},
        {"spot, tight", [](const lit_view& v) { return spot(v, seen(v, v.planes)); }},
        {"spot, perspective", &perspective_spot}};
    for (const auto& [range, where] : {std::pair(&lit_view::planes, ""), {&lit_view::depths, ", measured"}}) {
        const auto add = [&all, where = where](const std::string& name, auto place) {
            all.push_back({name + where, place});
        };
        add("tight",
            [=, range = range](const lit_view& v) { return directional(v, seen(v, v.*range), v.planes.direction); });
        add("sphere", [=, range = range](const lit_view& v) {
            return directional(v, umbrage::sphere_around(v.*range), v.light.up, glm::ivec2(v.map_size));
        });
        add("perspective", [=, range = range](const lit_view& v) {
            return warped(v, umbrage::fit_perspective(warp_fit(v, v.*range)));
        });
        for (const auto& [name, place] : {std::pair("light-space", &light_space),
                                          {"light-space, mild", &mild_light_space},
                                          {"trapezoidal", &trapezoidal}})
            add(name, [=, range = range, place = place](const lit_view& v) {
                return warped(v, place(warp_fit(v, v.*range)));
            });
        add("best of these", [=, range = range](const lit_view& v) { return best_of(v, v.*range); });
        add("4 light-space, mild", [=, range = range](const lit_view& v) { return warped_cascades(v, v.*range); });
        for (const bool stable : {true, false})
            for (const auto& [name, lambda] : {std::pair("uniform", 0.0), {"practical", 0.9}, {"logarithmic", 1.0}})
                add(std::string("4 ") + name + (stable ? " spheres" : " tight"),
                    [=, range = range, lambda = lambda](const lit_view& v) {
                        return cascades(v, v.*range, lambda, stable);
                    });
    }
    all.push_back({"plane-optimal on the ground", [](const lit_view& v) {
                       const glm::dvec4 ground(0, 1, 0, -v.scene.low.y);
                       const fit f = warp_fit(v, v.planes);
                       return warped(v, umbrage::fit_plane_optimal(f, ground).value_or(light_space(f)));
                   }});
    all.push_back({"256 pages", &adaptive});
    for (setup& s : point_setups()) all.push_back(std::move(s));
    return all;
}

}  // namespace

lit_view make_lit_view(const scene& s, const camera& c, glm::ivec2 size, const placed_light& light, int map_size) {
    const float cleared = umbrage::cleared_depth(picture_clip);
    umbrage::image<float> depth(size, cleared);
    draw_depths(depth, view_of(s.geometry), once, c.world_to_clip);
    const glm::dvec2 range = umbrage::seen_range(umbrage::measure_depths(std::as_const(depth).view(), cleared),
                                                 c.frustum.z_near, c.frustum.z_far, picture_clip.direction);
    lit_view v{s, c, light, map_size, camera_pass(s.geometry, c, size), c.frustum, c.frustum};
    v.depths.z_near = range.x, v.depths.z_far = range.y;
    return v;
}

placed_maps with_matrices(glm::ivec2 size, const glm::dvec4& light, const std::vector<glm::dmat4>& all,
                          const std::function<int(glm::dvec3)>& which) {
    const auto at = [=](glm::dvec3 p) {
        const glm::dmat4& to_texels = all[static_cast<std::size_t>(which(p))];
        const glm::dvec2 texel(umbrage::project_coordinate(umbrage::shadow_coordinate(to_texels, p)));
        const bool inside =
            glm::all(glm::greaterThanEqual(texel, glm::dvec2(0))) && glm::all(glm::lessThan(texel, glm::dvec2(size)));
        return inside ? to_texels : glm::dmat4(0);
    };
    return {size, static_cast<int>(all.size()), light, all, at};
}

const std::vector<setup>& setups() {
    static const std::vector<setup> all = all_setups();
    return all;
}

quality_report measure(const setup& s, const lit_view& v, int step, umbrage::image_view<float> extents) {
    const placed_maps maps = s.place(v);
    const glm::dmat4 pixels = to_pixels(v);
    return measure_quality(
        {.screen = v.seen.size(), .map_size = maps.size, .maps = maps.count, .step = step},
        [&](glm::ivec2 pixel) {
            if (v.seen[pixel] == nothing) return glm::dmat2(0);
            const surface at = surface_at(v.scene, v.camera, v.seen, pixel);
            const glm::dvec3 p(at.position), normal(at.face_normal);
            if (!(glm::dot(normal, glm::dvec3(maps.light) - p * maps.light.w) > 0)) return glm::dmat2(0);
            const glm::dmat4 to_texels = maps.at(p);
            return to_texels == glm::dmat4(0) ? glm::dmat2(0) : umbrage::pixels_per_texel(to_texels, pixels, p, normal);
        },
        extents);
}

umbrage::image<glm::u8vec3> false_colors(const lit_view& v, const umbrage::image<float>& extents, int step) {
    umbrage::image<glm::u8vec3> out(extents.size(), glm::u8vec3(0));
    for (glm::ivec2 p{0}; p.y < out.size().y; ++p.y)
        for (p.x = 0; p.x < out.size().x; ++p.x) {
            if (v.seen[p * step] == nothing) continue;
            const surface at = surface_at(v.scene, v.camera, v.seen, p * step);
            const float shade = 0.6f + 0.4f * glm::dot(at.face_normal, glm::normalize(v.camera.position - at.position));
            const float level = 0.5f + std::log2(extents[p]) / 6;
            out[p] = umbrage::store_unorm(shade * (extents[p] > 0 ? umbrage::false_color(level) : glm::vec3(0.2f)));
        }
    return out;
}

}  // namespace example
