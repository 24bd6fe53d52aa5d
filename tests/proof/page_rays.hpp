// SPDX-License-Identifier: MIT
//
// Adaptive maps from end to end against rays: a root around a random scene, the pages that a camera wants within a
// budget, their depth passes, the table, and filters' lookups with the acne-free bias of each page's texels.
#pragma once

#include <umbrage/draw/instances.hpp>
#include <umbrage/images/page_atlas.hpp>

#include "rays.hpp"

namespace proof {

/// A scene of rays.hpp under a directional light, in each convention in turn.
class page_scene : public ray_scene {
public:
    explicit page_scene(std::uint64_t n)
        : ray_scene(n * light_kinds.size()),
          root_(umbrage::make_page_root<double>({.direction = glm::dvec3(direction_),
                                                 .side = 20,
                                                 .scene = {glm::dvec3(box_.low), glm::dvec3(box_.high)},
                                                 .clip = clip_})),
          to_root_(umbrage::page_matrix(root_)) {
        using namespace umbrage;
        std::vector<page_receiver> seen;
        for (int i = 0; i < 2000; ++i) {
            const glm::vec3 p = point_of(std::size_t(i) % triangles_.size()), way = p - camera_.position;
            seen.push_back({glm::vec2(shadow_coordinate(to_root_, p)), 300 / glm::dot(way, way)});
        }
        atlas_ = image<float>(page_atlas_size(cache_, size_));
        const mesh_view mesh{positions_, triangles_};
        draw_pages(atlas_, size_, root_, cache_.update(seen).drawn, [&](auto map, const glm::mat4& to_clip) {
            if (may_mark(bounds_of(mesh), to_clip, clip_)) rasterize_depth(map, mesh, to_clip, clip_);
        });
        write_page_table(cache_, table_);
    }

    /// A filter at random points of triangles, in whatever pages hold them.
    /// @param at_level   counts the lookups in pages of each level
    template <class Filter>
    [[nodiscard]] verdicts compare(Filter filter, int points, std::array<int, 16>& at_level) {
        using namespace umbrage;
        filter.direction = clip_.direction;
        const depth32f encoding{.direction = clip_.direction};
        const auto table = [&](glm::ivec2 cell) { return table_[cell]; };
        verdicts found;
        for (int i = 0; i < points; ++i) {
            const auto own = std::uniform_int_distribution<std::size_t>(0, triangles_.size() - 1)(random_);
            const glm::vec3 p = point_of(own), in_root(shadow_coordinate(to_root_, p));
            if (!(in_root.x >= 1 && in_root.x < 2 && in_root.y >= 1 && in_root.y < 2)) {
                ++found.outside;
                continue;
            }
            const int level = cache_.level_at(glm::dvec2(in_root));
            matrix_ =
                glm::mat4(texture_matrix(page_light(root_, page_at(in_root, level), size_), glm::ivec2(size_.pitch())));
            planes_ = plane_matrix(matrix_);
            const glm::vec4 at = page_coordinate(table, 66.0f, glm::vec2(in_root), float(size_.texels), 4.0f);
            const float reach = filter.reach() + 1.0f;
            if (is_near_edge(glm::vec3(at.x, at.y, in_root.z), reach)) continue;
            const float rounding = std::ldexp(float(size_.texels), level - 20);  // of coordinates
            const float bias = acne_free_bias(slope(own), filter, encoding, rasterizer_snap<float> + rounding);
            const std::optional<bool> is_lit = told_by_rays(p, own, bias, filter.reach());
            if (!is_lit) continue;
            ++at_level[std::size_t(level)];
            ++(*is_lit ? found.lit : found.shadowed);
            const auto map = atlas_.view().region(glm::ivec2(at.z, at.w), glm::ivec2(size_.pitch()));
            const float seen = filter(clamped(map), glm::vec2(at), biased(in_root.z, bias, filter.direction));
            found.wrong += seen != (*is_lit ? 1.0f : 0.0f);
        }
        return found;
    }

private:
    umbrage::light_space<double> root_;
    glm::mat4 to_root_;
    umbrage::page_size size_{.texels = 32, .gutter = 4};
    umbrage::page_cache cache_{{.slots = {14, 14}, .deepest_level = 6}};
    umbrage::image<glm::u8vec4> table_{page_table_size(cache_)};
    umbrage::image<float> atlas_;
};

}  // namespace proof
