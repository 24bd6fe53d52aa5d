// SPDX-License-Identifier: MIT
//
// Every way that the library has of placing a light's maps, by name, and how good each is for a view.
//
//     const example::lit_view view = example::make_lit_view(scene, camera, size, light, 1024);
//     for (const example::setup& s : example::setups()) print(s.name, example::measure(s, view).mean);
//
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <glm/gtc/type_precision.hpp>

#include "camera.hpp"
#include "quality.hpp"
#include "scene.hpp"

namespace example {

/// Stands somewhere as a spot, and shines the same way from afar as a directional light.
struct placed_light {
    glm::dvec3 position, direction, up;
    double outer_angle_radians;
};

/// View of a camera into a light that has map_size^2 texels.
struct lit_view {
    const example::scene& scene;
    const example::camera& camera;
    placed_light light;
    int map_size;
    umbrage::image<std::uint32_t> seen;       ///< camera_pass
    umbrage::frustum<double> planes, depths;  ///< the camera's, and between what depths it sees anything
};
[[nodiscard]] lit_view make_lit_view(const scene& s, const camera& c, glm::ivec2 size, const placed_light& light,
                                     int map_size);

/// A light's maps: one, cascades, faces, pages.
struct placed_maps {
    glm::ivec2 size;              ///< size of each map, texels
    int count;                    ///< number of maps
    glm::dvec4 light;             ///< position and 1, or the way towards it and 0
    std::vector<glm::dmat4> all;  ///< texture_matrix of each; of pages the root's, none of maps that have no matrix
    std::function<glm::dmat4(glm::dvec3)> at;  ///< the matrix of a point's surroundings; zeros where no map holds it
    std::string chosen{};                      ///< name of the chosen one, if there was a choice
};

/// Maps with a matrix each.
/// @param which   (point) -> index of the map that a point is looked up in
[[nodiscard]] placed_maps with_matrices(glm::ivec2 size, const glm::dvec4& light, const std::vector<glm::dmat4>& all,
                                        const std::function<int(glm::dvec3)>& which);

struct setup {
    std::string name;
    std::function<placed_maps(const lit_view&)> place;
};
[[nodiscard]] const std::vector<setup>& setups();

/// Over surfaces that face the light and lie in a map; see measure_quality.
[[nodiscard]] quality_report measure(const setup& s, const lit_view& v, int step,
                                     umbrage::image_view<float> extents = {});

/// The picture of it: from an eighth of a pixel, dark blue, to eight, dark red; gray where nothing was measured; darker
/// on surfaces that turn away.
/// @param extents   as measure gives them
[[nodiscard]] umbrage::image<glm::u8vec3> false_colors(const lit_view& v, const umbrage::image<float>& extents,
                                                       int step);

}  // namespace example
