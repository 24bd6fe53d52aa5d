// SPDX-License-Identifier: MIT
#include "stability_report.hpp"

#include <array>
#include <cstddef>
#include <cstdio>
#include <future>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/cascades/splits.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include <camera.hpp>
#include <png.hpp>
#include <progress.hpp>
#include <stability.hpp>

#include "depth_pass.hpp"
#include "film.hpp"
#include "page_film.hpp"
#include "sheet.hpp"
#include "sun_film.hpp"

namespace shadow_render {
namespace {

/// Where what the scene's middle shades lies, from above.
example::camera camera_above(const options& o, const example::scene& scene) {
    const glm::vec3 way = -example::direction_at(o.azimuth, o.elevation);
    return example::make_camera({.target = scene.target - way * ((scene.target.y - scene.low.y) / way.y),
                                 .elevation = 90,
                                 .distance = o.camera_distance,
                                 .fov = 9,
                                 .aspect = static_cast<float>(o.width) / static_cast<float>(o.height),
                                 .z_near = scene.z_near,
                                 .z_far = scene.z_far});
}

/// How cascades are made, and how depths are drawn and looked up.
struct way {
    const char* name;
    bool stable;
    bool in_double = false;
    bool one_matrix = false;  ///< from world to texels, in place of a rotation, a scale and an offset
};

/// Four cascades of a frame, drawn: all of them, or what some points see.
template <umbrage::real T>
class frame {
public:
    frame(const options& o, const example::scene& scene, const example::camera& c, const way& w,
          std::span<const example::surface> points)
        : way_(w),
          size_(o.map_size / 2),
          position_(c.frustum.position),
          direction_(c.frustum.direction),
          to_light_(example::direction_at(o.azimuth, o.elevation)) {
        using vector = glm::vec<3, T>;
        const auto& f = c.frustum;
        const auto tangent = [](double t) { return static_cast<T>(t); };
        const umbrage::cascade_fit<T> fit{
            .camera = {vector(f.position), vector(f.direction), vector(f.up), tangent(f.tan_half_x),
                       tangent(f.tan_half_y)},
            .direction = -vector(to_light_),
            .up = vector(w.stable ? example::direction_at(o.azimuth, o.elevation + 90) : glm::vec3(f.direction)),
            .scene = {vector(scene.low), vector(scene.high)},
            .map_size = glm::ivec2(o.map_size / 2),
            .clip = example::picture_clip};
        const auto splits = umbrage::practical_splits<4>(T(f.z_near), T(f.z_far), T(0.9));
        cascades_ =
            w.stable ? umbrage::make_stable_cascades<4>(fit, splits) : umbrage::make_tight_cascades<4>(fit, splits);
        uniforms_ = umbrage::make_cascade_uniforms(cascades_, T(0));
        std::vector<glm::vec3> rotated;
        if (!w.one_matrix)
            for (const glm::vec3& p : scene.geometry.positions)
                rotated.emplace_back(umbrage::shadow_coordinate(uniforms_.rotation, vector(p)));
        for (const umbrage::cascade<T>& of : cascades_)
            to_texels_.push_back(umbrage::texture_matrix(of.light, glm::ivec2(size_)));
        const auto instances = instances_of(scene, w.one_matrix ? scene.geometry.positions : rotated);
        std::array<rectangle, 4> parts;
        for (const example::surface& s : points) {
            const auto [number, at] = place(s);
            parts[number].add(glm::dvec2(at));
        }
        for (std::size_t i = 0; i < cascades_.size(); ++i) {
            const umbrage::cascade<T>& of = cascades_[i];
            maps_.emplace_back(glm::ivec2(size_), umbrage::cleared_depth(fit.clip));
            draw_seen(maps_.back(), points.empty() ? all_of(maps_.back()) : parts[i], instances,
                      glm::mat4(w.one_matrix ? of.light.projection * of.light.view : of.light.projection), fit.clip);
        }
    }

    [[nodiscard]] example::placed_point operator()(const example::surface& s) const {
        const auto [number, at] = place(s);
        if (!umbrage::inside_cascade(at, glm::vec<2, T>(T(size_)), T(1.5))) return {};
        return {static_cast<int>(number), glm::dvec2(at),
                static_cast<double>(umbrage::pcf_2x2(umbrage::clamped(maps_[number]), glm::vec<2, T>(at), at.z))};
    }

private:
    struct place_in {
        std::size_t number;
        glm::vec<3, T> at;
    };
    [[nodiscard]] place_in place(const example::surface& s) const {
        const double depth = glm::dot(glm::dvec3(s.position) - position_, direction_);
        const auto number = static_cast<glm::length_t>(umbrage::cascade_by_depth(T(depth), uniforms_.ends));
        const auto i = static_cast<std::size_t>(number);
        const glm::vec<3, T> p = biased(to_texels_[i], to_light_, s);
        if (way_.one_matrix) return {i, glm::vec<3, T>(umbrage::shadow_coordinate(to_texels_[i], p))};
        return {i, umbrage::cascade_coordinate(glm::vec<3, T>(umbrage::shadow_coordinate(uniforms_.rotation, p)),
                                               uniforms_.scales[number], uniforms_.offsets[number])};
    }

    way way_;
    int size_;
    glm::dvec3 position_, direction_;
    glm::vec3 to_light_;
    std::array<umbrage::cascade<T>, 4> cascades_;
    umbrage::cascade_uniforms<T> uniforms_;
    std::vector<glm::mat<4, 4, T>> to_texels_;
    std::vector<umbrage::image<float>> maps_;
};

film_look_up draw(const options& o, const example::scene& scene, int number, const way& w,
                  std::span<const example::surface> points = {}) {
    const example::camera camera = camera_at(o, scene, number);
    if (w.in_double) return frame<double>(o, scene, camera, w, points);
    return frame<float>(o, scene, camera, w, points);
}

/// What the first frame's camera sees that faces the light.
std::vector<example::surface> points_of(const options& o, const example::scene& scene) {
    const glm::vec3 to_light = example::direction_at(o.azimuth, o.elevation);
    std::vector<example::surface> points;
    for_each_surface(o, scene, camera_at(o, scene, 0), [&](glm::ivec2 p, const example::surface& at) {
        if (p.x % 3 == 0 && p.y % 3 == 0 && glm::dot(at.face_normal, to_light) > 0.1f) points.push_back(at);
    });
    return points;
}

example::scene moved(example::scene scene, glm::vec3 by) {
    for (glm::vec3& p : scene.geometry.positions) p += by;
    scene.low += by, scene.high += by, scene.target += by;
    return scene;
}

/// Visibility from above. Red: where it is another than in the first frame, whose look-up `first` is.
picture from_above(const options& o, const example::scene& scene, const film_look_up& lit, const film_look_up& first) {
    picture out({o.width, o.height});
    for_each_surface(o, scene, camera_above(o, scene), [&](glm::ivec2 p, const example::surface& at) {
        const example::placed_point now = lit(at), then = first(at);
        const bool same = now.map != then.map || now.visibility == then.visibility;
        const glm::vec3 gray(static_cast<float>(0.15 + 0.7 * now.visibility));
        out[p] = umbrage::store_unorm(same ? gray : mark);
    });
    return out;
}

}  // namespace

void stability_report(const options& o, const example::scene& scene) {
    const int frames = frames_of(scene);
    constexpr way stable{"4 practical spheres, double", true, true}, tight{"4 practical tight, float", false};
    constexpr std::array ways{stable, way{"4 practical spheres, float", true},
                              way{"4 practical spheres, float, one matrix", true, false, true}, tight};
    example::progress progress(ways.size() + 4, o.quiet);
    const auto points = progress.stage("points", [&] { return points_of(o, scene); });
    const std::string title = text("%s: four cascades of %d x %d texels, %d frames of a camera that moves and turns",
                                   title_of(o).c_str(), o.map_size / 2, o.map_size / 2, frames);
    if (!o.quiet)
        std::printf(
            "%s\n%zu points of surfaces, each against the first frame in which the same cascade held it\n\n"
            "%-52s %14s %9s %9s %7s %9s\n",
            title.c_str(), points.size(), "setup", "drift, texels", "points", "changed", "%", "by up to");
    const struct {
        const char* name;
        glm::vec3 at;
    } places[]{{"", glm::vec3(0)}, {", 3 km out", glm::vec3(2300, 40, 1900)}};
    for (const way& w : ways)
        progress.stage(w.name, [&] {
            std::vector<std::pair<const char*, std::future<example::stability_report>>> found;
            for (const auto& place : places)
                found.emplace_back(place.name, std::async(std::launch::async, [&] {
                                       const example::scene there = moved(scene, place.at);
                                       std::vector<example::surface> seen = points;
                                       for (example::surface& s : seen) s.position += place.at;
                                       return example::measure_stability(frames, seen.size(), [&](int i) {
                                           return [&, lit = draw(o, there, i, w, seen)](std::size_t k) {
                                               return lit(seen[k]);
                                           };
                                       });
                                   }));
            for (auto& [where, measured] : found) {
                const example::stability_report r = measured.get();
                if (!o.quiet)
                    std::printf("%-52s %14.6f %9zu %9zu %7.2f %9.4f\n", (std::string(w.name) + where).c_str(), r.drift,
                                r.compared, r.changed, 100 * r.share(), r.change);
            }
        });
    auto strip = std::async(std::launch::async, [&] {
        const glm::vec3 to_light = example::direction_at(o.azimuth, o.elevation);
        sheet film({o.width, o.height}, 4 * sheet::columns,
                   {title, "Below each row what the scene shades in the same frames, from above, white where lit",
                    "Red: in another light than in the first frame, by the same cascade"});
        for (const way& w : {stable, tight}) {
            const film_look_up first = draw(o, scene, 0, w);
            std::vector<picture> below;
            for (int i = 0; i < sheet::columns; ++i) {
                const int number = i * (frames - 1) / (sheet::columns - 1);
                const film_look_up lit = draw(o, scene, number, w);
                film.add(photograph(o, scene, camera_at(o, scene, number), to_light, lit),
                         {w.name, text("frame %d", number)});
                below.push_back(from_above(o, scene, lit, first));
            }
            for (const picture& p : below) film.add(p, {});
        }
        example::write_png(o.output / "film.png", film.pixels().view());
    });
    progress.stage("sun", [&] { sun_film(o, scene); });
    progress.stage("film", [&] { strip.get(); });
    progress.stage("pages", [&] { page_film(o, scene); });
}

}  // namespace shadow_render
