// SPDX-License-Identifier: MIT
#include "page_film.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <vector>

#include <glm/vector_relational.hpp>

#include <umbrage/draw/rasterize.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/images/page_atlas.hpp>
#include <umbrage/light/bounds.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include <camera.hpp>
#include <png.hpp>
#include <sun_pages.hpp>

#include "film.hpp"
#include "sheet.hpp"

namespace shadow_render {
namespace {

constexpr int deepest_level = 10;

/// A scene in the root of its sun's pages, and which square of it each triangle covers.
struct sunlit {
    const example::scene& scene;
    glm::dvec3 direction;
    umbrage::light_space<double> root;
    glm::mat4 to_root;
    std::vector<umbrage::bounding_box<float>> covered{};

    sunlit(const options& o, const example::scene& s)
        : scene(s),
          direction(-example::direction_at(o.azimuth, o.elevation)),
          root(example::page_root_around(s.low, s.high, direction, example::direction_at(o.azimuth, o.elevation + 90),
                                         example::picture_clip)),
          to_root(umbrage::page_matrix(root)) {
        for (const glm::uvec3 t : s.geometry.triangles) {
            const auto at = [&](unsigned i) {
                return glm::vec3(umbrage::shadow_coordinate(to_root, s.geometry.positions[i]));
            };
            const glm::vec3 a = at(t.x), b = at(t.y), c = at(t.z);
            covered.push_back({glm::min(glm::min(a, b), c), glm::max(glm::max(a, b), c)});
        }
    }

    /// Those that may mark a page, and a texel around it.
    [[nodiscard]] std::vector<glm::uvec3> triangles_in(const umbrage::page& p, const umbrage::page_size& size) const {
        const double side = std::ldexp(1.0, -p.level), around = side * (size.gutter + 1) / size.texels;
        const glm::dvec2 corner = 1.0 + side * glm::dvec2(p.x, p.y);
        const glm::vec2 low(corner - around), high(corner + side + around);
        std::vector<glm::uvec3> found;
        for (std::size_t i = 0; i < covered.size(); ++i)
            if (glm::all(glm::lessThan(glm::vec2(covered[i].low), high)) &&
                glm::all(glm::greaterThan(glm::vec2(covered[i].high), low)))
                found.push_back(scene.geometry.triangles[i]);
        return found;
    }
};

/// Pages of a frame, drawn.
class paged {
public:
    paged(const options& o, const sunlit& sun, int slots)
        : sun_(sun),
          size_{.texels = static_cast<int>(std::bit_floor(std::max(16u, static_cast<unsigned>(o.map_size) / 16))),
                .gutter = 2},
          cache_({.slots = glm::ivec2(slots), .deepest_level = deepest_level}),
          atlas_(umbrage::page_atlas_size(cache_, size_)),
          table_(umbrage::page_table_size(cache_)) {}

    /// What the camera sees, one in 3 x 3 pixels of it.
    [[nodiscard]] std::vector<umbrage::page_receiver> seen(const options& o, const example::camera& camera) const {
        const glm::dmat4 to_pixels = umbrage::texture_matrix<double>(
            {glm::dmat4(1), glm::dmat4(camera.world_to_clip), example::picture_clip}, {o.width, o.height});
        example::page_wishes wishes(sun_.root, sun_.direction, size_.texels, to_pixels);
        for_each_surface(o, sun_.scene, camera, [&](glm::ivec2 p, const example::surface& at) {
            if (p.x % 3 == 0 && p.y % 3 == 0) wishes.add(glm::dvec3(at.position), glm::dvec3(at.face_normal));
        });
        return wishes.all();
    }

    umbrage::page_update update(const std::vector<umbrage::page_receiver>& seen) {
        umbrage::page_update result = cache_.update(seen);
        for (const umbrage::placed_page& one : result.drawn) {
            const std::vector<glm::uvec3> triangles = sun_.triangles_in(one.page, size_);
            umbrage::draw_pages(atlas_, size_, sun_.root, {&one, 1}, [&](auto map, const glm::mat4& to_clip) {
                umbrage::rasterize_depth(map, {sun_.scene.geometry.positions, triangles}, to_clip, sun_.root.clip);
            });
        }
        umbrage::write_page_table(cache_, table_);
        return result;
    }

    /// @return   in place of a map's number the level of a page
    [[nodiscard]] example::placed_point operator()(const example::surface& s) const {
        const int level = cache_.level_at(glm::dvec2(umbrage::shadow_coordinate(sun_.to_root, s.position)));
        const glm::mat4 to_texels(umbrage::texture_matrix(sun_.root, glm::ivec2(size_.texels << std::max(level, 0))));
        const glm::vec3 p(umbrage::shadow_coordinate(sun_.to_root, biased(to_texels, glm::vec3(-sun_.direction), s)));
        const glm::vec4 at =
            umbrage::page_coordinate(umbrage::clamped(table_), static_cast<float>(table_.size().x), glm::vec2(p),
                                     static_cast<float>(size_.texels), static_cast<float>(size_.gutter));
        const auto page = atlas_.view().region(glm::ivec2(at.z, at.w), glm::ivec2(size_.pitch()));
        return {level, glm::dvec2(at),
                static_cast<double>(umbrage::pcf_2x2(umbrage::clamped(page), glm::vec2(at), p.z))};
    }

    /// Points that look into a coarser page than they did before and want.
    [[nodiscard]] std::size_t popped(const std::vector<umbrage::page_receiver>& seen, const paged& before) const {
        return static_cast<std::size_t>(std::ranges::count_if(seen, [&](const umbrage::page_receiver& r) {
            const int now = cache_.level_at(r.coord);
            if (now >= before.cache_.level_at(r.coord)) return false;
            const auto wanted = umbrage::wanted_pages({&r, 1}, cache_.budget().target, deepest_level);
            return !wanted.empty() && now < wanted.front().level;
        }));
    }

private:
    const sunlit& sun_;
    umbrage::page_size size_;
    umbrage::page_cache cache_;
    umbrage::image<float> atlas_;
    umbrage::image<glm::u8vec4> table_;
};

/// Of a part of the film the frame in which most points pop, or its first.
struct scene_of_film {
    picture photo;
    int frame = 0;
    std::size_t forced = 0, popped = 0;
};

}  // namespace

void page_film(const options& o, const example::scene& scene) {
    constexpr std::array budgets{16, 6};  // pages each way
    const int frames = frames_of(scene);
    const glm::vec3 to_light = example::direction_at(o.azimuth, o.elevation);
    const std::string title =
        text("%s: pages of an adaptive map, %d frames of a camera that moves and turns", title_of(o).c_str(), frames);
    sheet film({o.width, o.height}, static_cast<int>(budgets.size()) * sheet::columns,
               {title, "Red: where a coarser page than in the frame before gives another light"});
    if (!o.quiet)
        std::printf("\n%s\n\n%-24s %8s %9s %9s %14s %10s %12s\n", title.c_str(), "budget", "drawn", "given up",
                    "forced", "pixels a texel", "% popped", "% unforced");
    const sunlit sun(o, scene);
    for (const int slots : budgets) {
        const std::string name = text("%d pages", slots * slots);
        paged now(o, sun, slots);
        std::array<scene_of_film, sheet::columns> shown;
        std::size_t drawn = 0, given_up = 0, forced = 0, points = 0, popped = 0, unforced = 0;
        double target = 0;
        for (int i = 0; i < frames; ++i) {
            const example::camera camera = camera_at(o, scene, i);
            const auto seen = now.seen(o, camera);
            const paged before = now;
            const umbrage::page_update update = now.update(seen);
            const std::size_t pop = now.popped(seen, before);
            drawn += update.drawn.size(), given_up += update.given_up, forced += update.forced;
            points += seen.size(), popped += pop, unforced += update.forced > 0 ? 0 : pop;
            target = std::max(target, update.target);
            scene_of_film& part = shown[static_cast<std::size_t>(i * sheet::columns / frames)];
            if (!part.photo.texels().empty() && pop <= part.popped) continue;
            part = {photograph(
                        o, scene, camera, to_light, [&](const example::surface& s) { return now(s); },
                        [&](const example::surface& s) {
                            const example::placed_point was = before(s), is = now(s);
                            return is.map < was.map ? was : is;
                        }),
                    i, update.forced, pop};
        }
        for (const scene_of_film& s : shown)
            film.add(s.photo, {name, text("frame %d, %zu pages forced out", s.frame, s.forced)});
        const auto percent = [&](std::size_t count) {
            return 100.0 * static_cast<double>(count) / static_cast<double>(points);
        };
        if (!o.quiet)
            std::printf("%-24s %8zu %9zu %9zu %14.3f %10.3f %12.3f\n", name.c_str(), drawn, given_up, forced, target,
                        percent(popped), percent(unforced));
    }
    example::write_png(o.output / "pages.png", film.pixels().view());
}

}  // namespace shadow_render
