// SPDX-License-Identifier: MIT
//
// A film's depth passes: of what a map, or the part of it that is looked up, may see.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>

#include <umbrage/draw/instances.hpp>
#include <umbrage/draw/rasterize.hpp>
#include <umbrage/light/texture_matrix.hpp>

#include <scene.hpp>

namespace shadow_render {

/// A part of a map, in texels.
struct rectangle {
    glm::dvec2 low{std::numeric_limits<double>::max()}, high{std::numeric_limits<double>::lowest()};

    void add(glm::dvec2 texel) { low = glm::min(low, texel), high = glm::max(high, texel); }
};
[[nodiscard]] inline rectangle all_of(const umbrage::image<float>& map) { return {{0, 0}, glm::dvec2(map.size())}; }

/// What a scene is made of, each thing with its box. A scene's vertices are its parts', place by place.
struct instance {
    umbrage::mesh_view mesh;
    umbrage::bounding_box<float> box;
};
/// @param positions   of the scene's vertices, in whatever space it is to be drawn from
[[nodiscard]] inline std::vector<instance> instances_of(const example::scene& scene,
                                                        std::span<const glm::vec3> positions) {
    std::vector<instance> all;
    const auto add = [&](const umbrage::mesh_view& mesh) { all.push_back({mesh, umbrage::bounds_of(mesh)}); };
    for (const example::copies& part : scene.parts)
        for (std::size_t i = 0; i < part.places.size(); ++i) {
            add({positions.first(part.shape.positions.size()), part.shape.triangles});
            positions = positions.subspan(part.shape.positions.size());
        }
    if (scene.parts.empty()) add({positions, scene.geometry.triangles});
    return all;
}

/// The depth pass of the instances that a part of a map, and two texels around it, may see: of none where nothing has
/// been added to the part.
inline void draw_seen(umbrage::image<float>& map, const rectangle& part, const std::vector<instance>& instances,
                      const glm::mat4& to_clip, umbrage::clip_space clip) {
    if (part.low.x > part.high.x) return;
    const glm::dvec2 middle = (part.low + part.high) * 0.5, half = (part.high - part.low) * 0.5 + 2.0;
    const glm::dmat4 to_texels = umbrage::texture_matrix<double>({glm::dmat4(1), glm::dmat4(1), clip}, map.size());
    glm::dmat4 to_part(1);  // its sides at -1 and 1
    for (glm::length_t i = 0; i < 2; ++i)
        to_part[i][i] = to_texels[i][i] / half[i], to_part[3][i] = (to_texels[3][i] - middle[i]) / half[i];
    const glm::mat4 to_its_clip(to_part * glm::dmat4(to_clip));
    for (const instance& i : instances)
        if (umbrage::may_mark(i.box, to_its_clip, clip)) umbrage::rasterize_depth(map, i.mesh, to_clip, clip);
}

}  // namespace shadow_render
