// SPDX-License-Identifier: MIT
//
// What receivers sweep on their way to the light, as casters have to lie in it: the hull of what the light sees of
// them, and how near to the light a box of casters comes within it. What fits share.
//
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/core/lesser.hpp>
#include <umbrage/light/bounds.hpp>
#include <umbrage/light/light_space.hpp>

namespace umbrage {
namespace detail {

/// Receivers, or a complaint in the name of a function whose argument they are.
template <class Use = on_use>
[[nodiscard]] const rounded_hull<Use>& given(const std::optional<rounded_hull<Use>>& receivers, const char* function) {
    require(receivers.has_value(), function, "receivers", "given", "none");
    require(is_finite(receivers->radius) && receivers->radius >= 0.0, function, "receivers",
            "of a finite radius, 0 or more", receivers->radius);
    for (const glm::dvec3& p : receivers->points) require(all_finite(p), function, "receivers", "finite", p);

    return *receivers;
}

/// Points whose hull holds all receivers: in place of a ball the corners of its box.
template <class = on_use>
[[nodiscard]] std::vector<glm::dvec3> corners_of(const hull& receivers) {
    if (!(receivers.radius > 0.0)) return receivers.points;
    std::vector<glm::dvec3> all;
    for (const glm::dvec3& p : receivers.points)
        for (const glm::dvec3& c : corners(bounding_box<double>{p - receivers.radius, p + receivers.radius}))
            all.push_back(c);
    return all;
}

/// World to x, y and the distance along the light.
template <real T>
[[nodiscard]] glm::dmat4 light_frame(const glm::mat<4, 4, T>& view, handedness hand) {
    glm::dmat4 frame(view);
    if (hand == handedness::right)
        for (glm::length_t i = 0; i < 4; ++i) frame[i][2] = -frame[i][2];
    return frame;
}

template <class = on_use>
[[nodiscard]] std::vector<glm::dvec3> seen(const glm::dmat4& frame, const std::vector<glm::dvec3>& points) {
    std::vector<glm::dvec3> moved;
    moved.reserve(points.size());
    for (const glm::dvec3& p : points) moved.emplace_back(frame * glm::dvec4(p, 1.0));
    return moved;
}

struct extent {
    glm::dvec3 low{highest<double>}, high{-highest<double>};
};
template <class = on_use>
[[nodiscard]] extent extent_of(const std::vector<glm::dvec3>& points) {
    extent e;
    for (const glm::dvec3& p : points) e.low = lesser(e.low, p), e.high = greater(e.high, p);
    return e;
}

/// Counter-clockwise, without what lies on an edge.
/// @cite   Andrew: Another efficient algorithm for convex hulls in two dimensions, 1979
template <class = on_use>
[[nodiscard]] std::vector<glm::dvec2> convex_hull(const std::vector<glm::dvec3>& seen) {
    std::vector<glm::dvec2> points(seen.begin(), seen.end()), hull;
    for (glm::dvec2& p : points) p += 0.0;  // zeros are all positive: what is equal has equal bits
    std::sort(points.begin(), points.end(),
              [](glm::dvec2 a, glm::dvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    // from b on: a and b may be one corner but for rounding, and (c - a) would then have lost their turn
    const auto turns_right = [](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) {
        return (b.x - a.x) * (c.y - b.y) <= (b.y - a.y) * (c.x - b.x);
    };
    for (const bool back : {false, true}) {
        const std::size_t first = hull.size();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const glm::dvec2& p = points[back ? points.size() - 1 - i : i];
            while (hull.size() >= first + 2 && turns_right(hull[hull.size() - 2], hull.back(), p)) hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();  // the other side begins with it
    }
    return hull;
}

/// What the hull of points has in common with a half-space, as points around it: those inside, and of where the lines
/// between them and the others cross the plane the outermost.
template <class = on_use>
[[nodiscard]] std::vector<glm::dvec3> clipped_hull(const std::vector<glm::dvec3>& points, const glm::dvec4& plane) {
    const glm::dvec3 normal(plane), steep = glm::abs(normal);
    const glm::length_t z = steep.x > steep.y ? (steep.x > steep.z ? 0 : 2) : (steep.y > steep.z ? 1 : 2);
    const glm::length_t x = (z + 1) % 3, y = (z + 2) % 3;
    const auto inside = [&](const glm::dvec3& p) { return glm::dot(normal, p) + plane.w; };
    std::vector<glm::dvec3> kept, beyond, crossed;
    for (const glm::dvec3& p : points) (inside(p) < 0.0 ? beyond : kept).push_back(p);
    const auto keep_outermost = [&] {
        if (crossed.size() < 3) return;
        const std::vector<glm::dvec2> corners = convex_hull(crossed);
        crossed.clear();
        for (const glm::dvec2& c : corners) crossed.emplace_back(c, 0.0);
    };
    std::size_t enough = 1024;
    for (const glm::dvec3& a : kept) {
        for (const glm::dvec3& b : beyond) {
            const glm::dvec3 p = a + (b - a) * (inside(a) / (inside(a) - inside(b)));
            crossed.emplace_back(p[x], p[y], 0.0);
        }
        if (crossed.size() < enough) continue;
        keep_outermost();
        enough = 2 * crossed.size() + 1024;
    }
    keep_outermost();
    for (const glm::dvec3& c : crossed) {
        glm::dvec3 p;
        p[x] = c.x, p[y] = c.y, p[z] = -(normal[x] * c.x + normal[y] * c.y + plane.w) / normal[z];
        kept.push_back(p);
    }
    return kept;
}

/// A plane (a, b, 0, c) through each edge of a hull; none through edges between points that differ by rounding only, as
/// their direction is arbitrary.
template <class = on_use>
[[nodiscard]] std::vector<glm::dvec4> sides(const std::vector<glm::dvec2>& hull) {
    std::vector<glm::dvec4> planes;
    const auto end_of = [&](std::size_t i) { return hull[i + 1 < hull.size() ? i + 1 : 0]; };
    double longest = 0.0;
    for (std::size_t i = 0; i < hull.size(); ++i) longest = greater(longest, glm::distance(hull[i], end_of(i)));
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const glm::dvec2 a = hull[i], b = end_of(i), inwards(a.y - b.y, b.x - a.x);
        if (glm::length(inwards) <= longest * 0x1p-32) continue;
        planes.emplace_back(inwards, 0.0, -glm::dot(inwards, a));
    }
    return planes;
}

/// Planes around what points sweep, each point with the square of `outwards` around it. Squares keep the planes
/// continuous while points move: sides moved outwards would jump where a corner of the hull splits in two.
template <class = on_use>
[[nodiscard]] std::vector<glm::dvec4> sweep(const std::vector<glm::dvec3>& seen, double outwards) {
    const auto [low, high] = extent_of(seen);
    // casters that touch a side are within it, whichever way it was rounded
    const double around = detail::greater(outwards, 0x1p-32 * detail::greater(high.x - low.x, high.y - low.y));
    std::vector<glm::dvec3> corners;
    corners.reserve(4 * seen.size());
    for (const glm::dvec3& p : seen)
        for (const double x : {p.x - around, p.x + around})
            for (const double y : {p.y - around, p.y + around}) corners.emplace_back(x, y, p.z);
    return sides(convex_hull(corners));
}

/// The least distance along the light of a box's faces within planes; highest<double> where none is.
template <class = on_use>
[[nodiscard]] double nearest(const glm::dmat4& frame, const polyhedron& box, const std::vector<glm::dvec4>& planes) {
    double least = highest<double>;
    for (const polyhedron::face& face : box.faces()) {
        std::vector<glm::dvec3> polygon = seen(frame, face.corners);
        for (const glm::dvec4& plane : planes) polygon = clipped(polygon, plane);
        for (const glm::dvec3& p : polygon) least = lesser(least, p.z);
    }
    return least;
}

}  // namespace detail
}  // namespace umbrage
