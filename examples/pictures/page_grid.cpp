// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/slope.hpp>
#include <umbrage/core/unorm.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/images/page_atlas.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include <biases.hpp>
#include <progress.hpp>
#include <scene.hpp>
#include <sun_pages.hpp>
#include <surface.hpp>

#include <cascades.hpp>
#include <render.hpp>
#include <shade.hpp>

#include "pages.hpp"
#include "spread.hpp"

namespace pictures {
namespace {

using shadow_render::options, shadow_render::view;

/// Pages of a virtual shadow map that a view needs, and how it looks under them.
class paged {
public:
    paged(const options& o, const view& v)
        : root_(example::page_root_around(
              glm::dvec3(v.scene.low), glm::dvec3(v.scene.high), glm::dvec3(v.lamp.direction),
              glm::dvec3(example::direction_at(o.azimuth, o.elevation + 90)), example::picture_clip)),
          places_(v.seen.size(), glm::vec3(0)) {
        const glm::ivec2 pixels(o.width, o.height);
        example::page_wishes wishes(
            root_, glm::dvec3(v.lamp.direction), size.texels,
            umbrage::texture_matrix<double>({glm::dmat4(1), v.camera.world_to_clip, example::picture_clip}, pixels));
        for (glm::ivec2 p{0}; p.y < v.seen.size().y; p.y += o.samples)
            for (p.x = 0; p.x < v.seen.size().x; p.x += o.samples) {
                if (v.seen[p] == example::nothing) continue;
                const example::surface at = example::surface_at(v.scene, v.camera, v.seen, p);
                wishes.add(glm::dvec3(at.position), glm::dvec3(at.face_normal));
            }
        drawn_ = cache_.update(wishes.all()).drawn;
        for (const auto& [page, slot] : drawn_)
            if (levels_.empty() || levels_.back() != page.level) levels_.push_back(page.level);
        locate(v);
    }

    /// Visibility of each sample.
    [[nodiscard]] umbrage::image<float> visibility(const example::scene& scene) const {
        umbrage::image<float> atlas(umbrage::page_atlas_size(cache_, size), 1.0f), out(places_.size());
        umbrage::draw_pages(atlas, size, root_, drawn_, [&](auto map, const glm::mat4& to_clip) {
            shadow_render::draw_instances(map, scene, to_clip, false);
        });
        umbrage::image<glm::u8vec4> table(umbrage::page_table_size(cache_));
        umbrage::write_page_table(cache_, table);
        umbrage::visibility<umbrage::depth32f>({atlas, table, size}, {}, places_.view(), filter, out);
        return out;
    }

    /// The picture in the colors of its pages' levels, with the pages' borders.
    [[nodiscard]] picture tinted(picture shaded, int samples) const {
        return with_pages(std::move(shaded), samples, [&](glm::ivec2 sample) { return glm::vec2(places_[sample]); });
    }

    /// The part of the root that has finer pages, in the same way, as the light sees it.
    [[nodiscard]] picture root(const example::scene& scene, int side) const {
        glm::vec2 low(2), high(1);
        for (const auto& [page, slot] : drawn_)
            if (page.level > 0) {
                const float across = 1.0f / static_cast<float>(1 << page.level);
                const glm::vec2 corner = 1.0f + glm::vec2(page.x, page.y) * across;
                low = glm::min(low, corner), high = glm::max(high, corner + across);
            }
        const float part = std::max(high.x - low.x, high.y - low.y);
        low = glm::clamp((low + high - part) * 0.5f, 1.0f, 2.0f - part);
        umbrage::image<float> map(glm::ivec2(4096), 1.0f);
        shadow_render::draw_instances(map, scene, glm::mat4(root_.projection * root_.view), false);
        const auto texels = [&](glm::vec2 from_root) { return glm::ivec2(from_root * glm::vec2(map.size())); };
        constexpr int samples = 3;
        return with_pages(depths_of(map.view().region(texels(low - 1.0f), texels(glm::vec2(part))), side), samples,
                          [&](glm::ivec2 sample) {
                              return low + part * (glm::vec2(sample) + 0.5f) / static_cast<float>(side * samples);
                          });
    }

    [[nodiscard]] std::vector<line> key() const {
        std::vector<line> all;
        const double texel = 2 / root_.projection[0][0] / size.texels;
        for (const int level : levels_) {
            const auto count = std::ranges::count(drawn_, level, [](const auto& p) { return p.page.level; });
            all.push_back({umbrage::store_unorm(tint(level)),
                           {std::to_string(level), std::to_string(count), length(texel / (1 << level))}});
        }
        return all;
    }

    static constexpr umbrage::page_size size{.texels = 128, .gutter = 4};
    static constexpr umbrage::filters::pcf_2x2 filter{};

private:
    /// Where each sample is looked up, with its bias.
    void locate(const view& v) {
        const float reach = example::covered(filter.reach());
        const glm::dmat4 to_root = umbrage::page_matrix(root_);
        std::vector<glm::mat4> planes;
        for (int level = 0; level <= levels_.back(); ++level)
            planes.push_back(
                umbrage::plane_matrix(glm::mat4(umbrage::texture_matrix(root_, glm::ivec2(size.texels << level)))));
        for (int y = 0; y < v.seen.size().y; ++y)
            example::for_each_run(v.seen, y, [&](int first, int last, std::uint32_t triangle) {
                const example::seen_triangle on = v.triangle(triangle);
                for (int x = first; x < last; ++x) {
                    const glm::vec3 world = on.position(on.weights({x, y}));
                    const glm::dvec3 p = umbrage::shadow_coordinate(to_root, glm::dvec3(world));
                    const int level = cache_.level_at(glm::dvec2(p));
                    if (level < 0) continue;
                    const glm::vec2 slope =
                        umbrage::plane_slope(planes[std::size_t(level)], on.face_normal(world), world);
                    const float bias = umbrage::acne_free_bias(slope, reach, 0x1p-18f);
                    places_[{x, y}] = {p.x, p.y, umbrage::biased(static_cast<float>(p.z), bias)};
                }
            });
    }

    /// From blue, coarse, to red, fine.
    [[nodiscard]] glm::vec3 tint(int level) const {
        constexpr std::array<glm::vec3, 7> tints{{{0.62f, 0.6f, 1},
                                                  {0.45f, 0.75f, 1},
                                                  {0.4f, 0.95f, 0.9f},
                                                  {0.5f, 0.95f, 0.5f},
                                                  {0.85f, 0.95f, 0.4f},
                                                  {1, 0.75f, 0.35f},
                                                  {1, 0.5f, 0.45f}}};
        const float at = static_cast<float>(std::ranges::find(levels_, level) - levels_.begin()) *
                         static_cast<float>(tints.size() - 1) /
                         static_cast<float>(std::max(levels_.size(), std::size_t(2)) - 1);
        const auto first = std::min(static_cast<std::size_t>(at), tints.size() - 2);
        return glm::mix(tints[first], tints[first + 1], at - static_cast<float>(first));
    }

    /// @param place   place of a sample in the root; 0: none
    template <class Place>
    [[nodiscard]] picture with_pages(picture colors, int samples, const Place& place) const {
        umbrage::image<umbrage::page> pages(colors.size() * samples, {-1, 0, 0});
        umbrage::image<glm::vec3> tints(pages.size(), glm::vec3(1));
        for (glm::ivec2 p{0}; p.y < pages.size().y; ++p.y)
            for (p.x = 0; p.x < pages.size().x; ++p.x)
                if (const glm::dvec2 at(place(p)); at.x > 0) pages[p] = umbrage::page_at(at, cache_.level_at(at));
        const auto borders = [&](glm::ivec2 p, glm::ivec2 q) {  // and is no edge of a thing before another
            const float apart = glm::distance(glm::vec2(place(p)), glm::vec2(place(q)));
            return pages[p] != pages[q] && apart * static_cast<float>(8 << pages[p].level) < 1;
        };
        for (glm::ivec2 p{0}; p.y < pages.size().y; ++p.y)
            for (p.x = 0; p.x < pages.size().x; ++p.x) {
                if (pages[p].level < 0) continue;
                const glm::ivec2 next = glm::min(p + samples, pages.size() - 1);
                const bool border = borders(p, {next.x, p.y}) || borders(p, {p.x, next.y});
                tints[p] = (border ? 0.3f : 1.0f) * tint(pages[p].level);
            }
        for (glm::ivec2 p{0}; p.y < colors.size().y; ++p.y)
            for (p.x = 0; p.x < colors.size().x; ++p.x)
                colors[p] = times(colors[p], shadow_render::mean<glm::vec3>(p.x, samples, [&](int x, int row) {
                                      return tints[{x, p.y * samples + row}];
                                  }));
        return colors;
    }

    umbrage::light_space<double> root_;
    umbrage::page_cache cache_{{.slots = {16, 16}, .deepest_level = 11}};
    std::vector<umbrage::placed_page> drawn_;
    std::vector<int> levels_;  ///< of these, each once
    umbrage::image<glm::vec3> places_;
};

}  // namespace

picture page_grid(int width) {
    const spread page(width, 8);
    const options o = outdoors(page.view);
    const example::scene scene = example::outdoor_scene();
    example::progress progress(20, true);
    const view v = make_view(o, scene, progress);
    const paged by(o, v);
    const picture gray = without_color(shade(v, by.visibility(scene), o.samples, progress.bands()));
    return page.of(by.tinted(gray, o.samples), by.root(scene, page.side), {"level", "pages", "texel"}, by.key());
}

}  // namespace pictures
