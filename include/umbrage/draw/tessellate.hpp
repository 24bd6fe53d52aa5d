// SPDX-License-Identifier: MIT
//
// Tessellation of a mesh for maps in which straight edges are curves, as in dual paraboloid maps. Edges are cut until
// positions and distances from the light between vertices are close enough to straight lines.
//
//     auto cut = umbrage::tessellate(mesh, {light, umbrage::paraboloid_edge_angle(map_size, border), range});
//     umbrage::rasterize_dual_paraboloid(map.view(), cut.view(), space, 0);
//
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/draw/mesh.hpp>
#include <umbrage/light/light_space.hpp>

namespace umbrage {

/// Mesh whose edges are short as seen from a light.
struct tessellated_mesh {
    std::vector<glm::vec3> positions;  ///< the mesh's own, then new ones, world units
    std::vector<glm::uvec3> triangles;

    template <class View = mesh_view>  // only callers compile spans of vectors: 26 ms less to include
    [[nodiscard]] View view() const {
        return View{positions, triangles};
    }
};

/// Settings of a tessellation.
struct tessellation {
    glm::vec3 position{0};               ///< position of the light, world units
    float angle = 0.1f;                  ///< radians, > 0: largest angle of an edge as seen from the light
    float range = 100;                   ///< range of the light, > 0. Edges entirely beyond it may have wrong distances
    float depth_error = 1.0f / 4096.0f;  ///< error of distances between an edge's ends, over range; above 0, below 1
};

namespace detail {

template <class = on_use>
class tessellator {
public:
    tessellator(const mesh_view& mesh, const tessellation& to)
        : light_(to.position),
          range_(double(to.range)),
          sag_(0.75 * double(to.depth_error) * range_),
          least_cosine_(std::cos((glm::min)(double(to.angle), 3.0))),
          greatest_cosine_(1 - std::pow(double(to.angle), 4.0) / 128),
          cut_{{}, {}} {
        for (const glm::vec3& p : mesh.positions) add(p);
        for (const glm::uvec3& t : mesh.triangles) cut(t);
    }

    [[nodiscard]] tessellated_mesh take() { return std::move(cut_); }

private:
    unsigned add(glm::vec3 p) {
        cut_.positions.push_back(p);
        vertices_.push_back({glm::length(glm::dvec3(p) - light_)});
        return static_cast<unsigned>(cut_.positions.size() - 1);
    }

    /// Excess length of an edge: 1 minus its angle's cosine, or else its error. Zeros where it is short enough. It
    /// depends on the edge's ends only, so both triangles at the edge decide the same.
    [[nodiscard]] std::pair<double, double> excess(unsigned a, unsigned b) const {
        const double p = vertices_[a].distance, q = vertices_[b].distance;
        if ((glm::max)(p, q) < sag_) return {0, 0};
        const glm::dvec3 to_a = glm::dvec3(cut_.positions[a]) - light_, to_b = glm::dvec3(cut_.positions[b]) - light_;
        const double cosine = glm::dot(to_a, to_b) / (p * q);
        if (cosine < least_cosine_) return {1 - cosine, 0};
        if (cosine > greatest_cosine_ || (glm::min)(p, q) * cosine > range_) return {0, 0};
        // compares the ends' mean distance with the distance of the point where the viewing angle's bisector meets the
        // edge
        const double sag = (p + q) / 2 - 2 * p * q * std::sqrt((1 + cosine) / 2) / (p + q);
        return {0, sag > sag_ ? sag : 0};
    }

    /// An edge, ordered from near to far, and the fraction of its length at which the bisector of the viewing angle
    /// cuts it. The fraction is at most 1/2 and stays accurate for a very distant end. Swapping the ends changes
    /// nothing.
    struct divided_edge {
        glm::dvec3 close, distant;
        double share;

        [[nodiscard]] glm::vec3 middle() const { return glm::vec3(glm::mix(close, distant, share)); }

        /// False where rounding moves the middle by 1/8 of its way from the nearer end, or more.
        [[nodiscard]] bool has_middle() const {
            const glm::dvec3 way = share * (distant - close);
            return glm::distance(glm::dvec3(middle()) - close, way) < 0.125 * glm::length(way);
        }
    };
    [[nodiscard]] divided_edge edge(unsigned a, unsigned b) const {
        const double p = vertices_[a].distance, q = vertices_[b].distance;
        if (q < p) return edge(b, a);
        return {glm::dvec3(cut_.positions[a]), glm::dvec3(cut_.positions[b]), p / (p + q)};
    }

    /// Edge of a triangle with the largest excess, from corner 0, 1 or 2 to the next. 3 where none has any, or where
    /// rounding moves its middle: to cut again and again would not shorten it.
    [[nodiscard]] glm::length_t longest_edge(const glm::uvec3& t) const {
        glm::length_t longest = 3;
        std::pair<double, double> most{0, 0};
        for (glm::length_t i = 0; i < 3; ++i)
            if (const auto by = excess(t[i], t[(i + 1) % 3]); by > most) longest = i, most = by;
        if (longest == 3) return 3;
        return edge(t[longest], t[(longest + 1) % 3]).has_middle() ? longest : 3;
    }

    /// Cuts a triangle in two at its longest edge, until no edge is too long.
    void cut(const glm::uvec3& whole) {
        std::vector<glm::uvec3> left{whole};
        while (!left.empty()) {
            const glm::uvec3 t = left.back();
            left.pop_back();
            const glm::length_t longest = longest_edge(t);
            if (longest == 3) {
                cut_.triangles.push_back(t);
                continue;
            }
            const unsigned a = t[longest], b = t[(longest + 1) % 3], c = t[(longest + 2) % 3], m = between(a, b);
            left.push_back({a, m, c});
            left.push_back({m, b, c});
        }
    }

    /// Midpoint of an edge. Its newer end lists it, because a cut gives a vertex few edges to older ones. The older end
    /// may be a fan's center. Each cut would search its long list.
    unsigned between(unsigned a, unsigned b) {
        if (a < b) return between(b, a);
        for (unsigned m = vertices_[a].middle; m != none; m = vertices_[m].next)
            if (vertices_[m].end == b) return m;
        const unsigned m = add(edge(a, b).middle());
        vertices_[m].end = b;
        vertices_[m].next = vertices_[a].middle;
        return vertices_[a].middle = m;
    }

    static constexpr unsigned none = ~0u;
    struct vertex {
        double distance;         ///< distance from the light
        unsigned middle = none;  ///< midpoint of the last cut edge from here to an older end
        unsigned end = none;     ///< older end of the edge, for a midpoint
        unsigned next = none;    ///< midpoint of the edge cut before it, for a midpoint
    };

    glm::dvec3 light_;
    double range_, sag_, least_cosine_, greatest_cosine_;
    tessellated_mesh cut_;
    std::vector<vertex> vertices_;
};

}  // namespace detail

/// Cuts a mesh's triangles at edges that are too long for a light, each at the angle's bisector.
///
/// A tenth of the angle makes up to a hundred times as many triangles. An angle far below paraboloid_edge_angle may
/// make millions from a single one.
/// @param mesh   triangles with a position that is not finite stay as they are
/// @param to     settings
/// @return       the same surface, with the same winding. Triangles that share an edge still do, without gaps, even if
///               they have separate vertices of equal position
/// @throws std::invalid_argument  angle, range or depth_error out of range; an index out of range
/// @formula      an edge with ends a and b from the light, g between them, is cut where g > angle, or where
///               (|a| + |b|) / 2 - 2 |a| |b| cos(g / 2) / (|a| + |b|) > 3/4 depth_error range. Inside a triangle, a
///               parabola is up to 4/3 as far from its plane as on the edges. Edges nearer to the light than that error
///               are kept, and so are those of half a texel, angle^2 / 8, with any error. Otherwise triangles that
///               contain the light, or are seen edge-on, would be cut forever
/// @edge         where rounding moves the cut of a triangle's longest edge, far from the origin or with one end close
///               to the light, the triangle stays. Beside neighbors that are cut it may leave a gap
template <class = detail::on_use>
[[nodiscard]] tessellated_mesh tessellate(const mesh_view& mesh, const tessellation& to) {
    constexpr auto function = "tessellate";
    detail::require(detail::all_finite(to.position), function, "position", "finite", to.position);
    detail::require(is_finite(to.angle) && to.angle > 0, function, "angle", "finite and above 0", to.angle);
    detail::require(is_finite(to.range) && to.range > 0, function, "range", "finite and above 0", to.range);
    detail::require(to.depth_error > 0 && to.depth_error < 1, function, "depth_error", "above 0 and below 1",
                    to.depth_error);
    for (const glm::uvec3& t : mesh.triangles)
        detail::require((glm::max)((glm::max)(t.x, t.y), t.z) < mesh.positions.size(), function, "mesh.triangles",
                        "indices of positions", t);
    return detail::tessellator<>(mesh, to).take();
}

}  // namespace umbrage
