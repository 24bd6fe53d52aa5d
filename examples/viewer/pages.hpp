// SPDX-License-Identifier: MIT
//
// Pages of a sun's adaptive map for what a camera sees, as many as an atlas of some texels holds. Knows nothing of
// OpenGL.
//
//     viewer::sun_pages pages(2048, reach);
//     pages.shine(direction, up, scene);
//     for (const umbrage::placed_page& p : pages.update(seen, eye, to_pixels).drawn) draw(pages.light(p.page), p.slot);
//
#pragma once

#include <optional>
#include <span>
#include <string>

#include <glm/gtc/type_precision.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/light/adaptive/pages.hpp>
#include <umbrage/light/adaptive/root.hpp>
#include <umbrage/light/bounds.hpp>
#include <umbrage/light/light_choice.hpp>

namespace viewer {

class sun_pages {
public:
    /// @param texels   along an edge of the atlas, of which whole pages may need a few less
    /// @param reach    reach of the filter, texels
    sun_pages(int texels, float reach);

    /// Pages that another sun drew are forgotten.
    void shine(glm::dvec3 direction, glm::dvec3 up, const umbrage::bounding_box<double>& scene);

    /// @param eye         on whose side surfaces face
    /// @param to_pixels   world to the picture
    [[nodiscard]] umbrage::page_update update(std::span<const umbrage::seen_point> seen, glm::dvec3 eye,
                                              const glm::dmat4& to_pixels);

    [[nodiscard]] umbrage::light_space<double> light(const umbrage::page& p) const;
    [[nodiscard]] glm::dmat4 to_root() const { return umbrage::page_matrix(root_); }
    [[nodiscard]] const umbrage::page_size& size() const { return size_; }
    [[nodiscard]] int texels() const { return cache_.budget().slots.x * size_.pitch(); }  ///< along the atlas' edge
    [[nodiscard]] umbrage::image<glm::u8vec4> table() const;
    [[nodiscard]] std::string describe(const umbrage::page_update& u) const;  ///< for people

private:
    umbrage::page_size size_;
    umbrage::page_cache cache_;
    std::optional<glm::dvec3> direction_{};
    umbrage::light_space<double> root_{};
};

}  // namespace viewer
