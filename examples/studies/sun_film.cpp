// SPDX-License-Identifier: MIT
#include "sun_film.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/light/bounds.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/light_choice.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/perspective.hpp>
#include <umbrage/light/warp/trapezoidal.hpp>

#include <camera.hpp>
#include <png.hpp>
#include <ray_tracer.hpp>
#include <surface.hpp>

#include "depth_pass.hpp"
#include "film.hpp"
#include "sheet.hpp"
#include "view.hpp"

namespace shadow_render {
namespace {

/// A map, and which kind of map it is.
struct kind_of_map {
    umbrage::light_space<float> light;
    std::size_t which;
};

class sun_walk {
public:
    sun_walk(const options& o, const example::scene& scene)
        : o_(o),
          scene_(scene),
          camera_(make_camera(o, scene)),
          instances_(instances_of(scene, scene.geometry.positions)),
          rays_(scene.geometry) {
        for_each_surface(o, scene, camera_, [&](glm::ivec2 p, const example::surface& at) {
            if (p.x % 4 || p.y % 4) return;
            points_.push_back(at);
            if (p.x % 16 == 0 && p.y % 16 == 0)
                coarse_.push_back({glm::dvec3(at.position), glm::dvec3(at.face_normal)});
        });
    }

    /// From abreast of the camera to right behind it.
    [[nodiscard]] glm::vec3 to_sun(double frame) const {
        const double angle = 90 - 90 * frame / (frames_of(scene_) - 1);
        return example::direction_at(o_.camera_azimuth, o_.camera_elevation + static_cast<float>(angle));
    }

    [[nodiscard]] umbrage::warp_fit<float> fit(double frame) const {
        const auto& f = camera_.frustum;
        const umbrage::frustum<float> seen{.position = f.position,
                                           .direction = f.direction,
                                           .up = f.up,
                                           .tan_half_x = static_cast<float>(f.tan_half_x),
                                           .tan_half_y = static_cast<float>(f.tan_half_y),
                                           .z_near = static_cast<float>(f.z_near),
                                           .z_far = static_cast<float>(f.z_far)};
        const umbrage::bounding_box<float> box{scene_.low, scene_.high};
        return {.camera = seen,
                .direction = -to_sun(frame),
                .receivers = intersection(seen, box),
                .casters = box,
                .clip = example::picture_clip};
    }

    /// Up to what the camera looks at.
    [[nodiscard]] float focus() const { return o_.camera_distance; }

    /// The better of a warp and of none, for what the camera sees.
    [[nodiscard]] kind_of_map choose(double frame, std::size_t before) const {
        const auto f = fit(frame);
        const std::array lights{umbrage::fit_directional_light<float>({.direction = f.direction,
                                                                       .up = f.camera.direction,
                                                                       .receivers = f.receivers,
                                                                       .casters = f.casters,
                                                                       .clip = f.clip}),
                                umbrage::fit_light_space_perspective(f).light};
        const glm::dmat4 to_pixels = umbrage::texture_matrix<double>(
            {glm::dmat4(1), glm::dmat4(camera_.world_to_clip), example::picture_clip}, {o_.width, o_.height});
        const std::size_t kept =
            umbrage::choose_light<float>(lights, coarse_, {.to_pixels = to_pixels, .map_size = glm::ivec2(o_.map_size)},
                                         before)
                .kept;
        return {lights[kept], kept};
    }

    [[nodiscard]] film_look_up draw(double frame, const umbrage::light_space<float>& light) const {
        umbrage::image<float> map(glm::ivec2(o_.map_size), umbrage::cleared_depth(light.clip));
        draw_seen(map, all_of(map), instances_, light.projection * light.view, light.clip);
        const glm::mat4 to_texels = umbrage::texture_matrix(light, map.size());
        return [map = std::move(map), to_texels, way = to_sun(frame)](const example::surface& s) {
            const glm::vec3 at =
                umbrage::project_coordinate(umbrage::shadow_coordinate(to_texels, biased(to_texels, way, s)));
            return example::placed_point{
                0, glm::dvec2(at), static_cast<double>(umbrage::pcf_2x2(umbrage::clamped(map), glm::vec2(at), at.z))};
        };
    }

    /// Share of the points that face the sun, whose light differs by a quarter or more from then(number, surface).
    template <class Then>
    [[nodiscard]] double changed(double frame, const film_look_up& now, Then&& then) const {
        const glm::vec3 way = to_sun(frame);
        std::size_t count = 0, all = 0;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (glm::dot(points_[i].face_normal, way) < 0.1f) continue;
            ++all;
            count += std::abs(now(points_[i]).visibility - then(i, points_[i])) >= 0.25;
        }
        return 100.0 * static_cast<double>(count) / static_cast<double>(all);
    }
    /// Light that rays find at each point.
    [[nodiscard]] std::vector<double> by_rays(double frame) const {
        const float far = 2 * glm::length(scene_.high - scene_.low);
        std::vector<double> lit;
        for (const example::surface& p : points_)
            lit.push_back(rays_.blocked(p.position + 0.01f * p.face_normal, to_sun(frame), far) ? 0 : 1);
        return lit;
    }
    [[nodiscard]] picture photo(double frame, const film_look_up& lit, const film_look_up& then = {}) const {
        return photograph(o_, scene_, camera_, to_sun(frame), lit, then);
    }

private:
    const options& o_;
    const example::scene& scene_;
    example::camera camera_;
    std::vector<instance> instances_;
    example::ray_tracer rays_;
    std::vector<example::surface> points_;
    std::vector<umbrage::seen_point> coarse_;
};

struct sun_map {
    const char* name;
    kind_of_map (*at)(const sun_walk&, double frame, std::size_t before);
};
constexpr std::array sun_maps{
    sun_map{"light-space perspective",
            [](const sun_walk& w, double frame, std::size_t) -> kind_of_map {
                const auto warped = umbrage::fit_light_space_perspective(w.fit(frame));
                return {warped.light, warped.strength > 0 ? std::size_t(1) : 0};
            }},
    sun_map{"perspective",
            [](const sun_walk& w, double frame, std::size_t) -> kind_of_map {
                const auto warped = umbrage::fit_perspective(w.fit(frame));
                return {warped.light, warped.seen_as == umbrage::light_image::none ? std::size_t(1) : 0};
            }},
    sun_map{"trapezoidal",
            [](const sun_walk& w, double frame, std::size_t) -> kind_of_map {
                const auto warped = umbrage::fit_trapezoidal(w.fit(frame), w.focus());
                return {warped.light, warped.strength > 0 ? std::size_t(1) : 0};
            }},
    sun_map{"light-space perspective or none, by quality",
            [](const sun_walk& w, double frame, std::size_t before) { return w.choose(frame, before); }}};

}  // namespace

void sun_film(const options& o, const example::scene& scene) {
    const sun_walk walk(o, scene);
    const int frames = frames_of(scene);
    const std::string title =
        text("%s: one map of %d x %d texels, %d frames of a sun from abreast of the camera to behind it",
             title_of(o).c_str(), o.map_size, o.map_size, frames);
    sheet film(
        {o.width, o.height}, static_cast<int>(sun_maps.size()) * sheet::columns,
        {title, "Red: where the light changes as one kind of map hands over to another, while the sun stands still"});
    if (!o.quiet)
        std::printf("\n%s\n\n%-46s %10s %12s %12s %12s\n", title.c_str(), "setup", "hand-overs", "% there, up",
                    "% off rays", "up to");
    std::vector<std::vector<double>> lit;
    for (int i = 0; i < frames; ++i) lit.push_back(walk.by_rays(i));
    std::vector<std::vector<std::pair<glm::mat4, double>>> known(lit.size());  // several setups come to one map
    const auto off_rays = [&](int i, const umbrage::light_space<float>& light) {
        const auto number = static_cast<std::size_t>(i);
        const glm::mat4 to_clip = light.projection * light.view;
        for (const auto& [of, share] : known[number])
            if (of == to_clip) return share;
        const double share = walk.changed(i, walk.draw(i, light),
                                          [&](std::size_t k, const example::surface&) { return lit[number][k]; });
        known[number].emplace_back(to_clip, share);
        return share;
    };
    for (const sun_map& w : sun_maps) {
        kind_of_map before = w.at(walk, 0, 0);
        double at = -1, jump = 0, off = 0, most_off = 0;
        int count = 0;
        film_look_up old, young;
        for (int i = 0; i < frames; ++i) {
            const kind_of_map now = w.at(walk, i, before.which);
            const double wrong = off_rays(i, now.light);
            off += wrong / frames, most_off = std::max(most_off, wrong);
            if (now.which != before.which) {
                double first = i - 1, last = i;
                for (int halvings = 0; halvings < 20; ++halvings) {
                    const double middle = (first + last) / 2;
                    (w.at(walk, middle, before.which).which == before.which ? first : last) = middle;
                }
                const film_look_up then = walk.draw(first, w.at(walk, first, before.which).light),
                                   next = walk.draw(last, w.at(walk, last, before.which).light);
                const double here = walk.changed(
                    last, next, [&](std::size_t, const example::surface& s) { return then(s).visibility; });
                ++count;
                if (here >= jump) jump = here, at = last, old = then, young = next;
            }
            before = now;
        }
        if (!o.quiet) std::printf("%-46s %10d %12.3f %12.3f %12.3f\n", w.name, count, jump, off, most_off);
        const auto alone = [&](double frame) {
            film.add(walk.photo(frame, walk.draw(frame, w.at(walk, frame, 0).light)),
                     {w.name, text("frame %.0f", frame)});
        };
        alone(0);
        if (at < 0) {
            alone(frames / 2);
            alone(frames * 3 / 4);
        } else {
            film.add(walk.photo(at, old), {w.name, text("frame %.2f, before a hand-over", at)});
            film.add(walk.photo(at, young, old), {w.name, text("frame %.2f, after it", at)});
        }
        alone(frames - 1);
    }
    example::write_png(o.output / "sun.png", film.pixels().view());
}

}  // namespace shadow_render
