// SPDX-License-Identifier: MIT
//
// Sweep of the receivers towards the light, which holds all their casters. The light fits share it.
// It gives the convex hull of the receivers as the light sees them, and the nearest casters within the sweep.
//
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/light/bounds.hpp>
#include <umbrage/light/light_space.hpp>

namespace umbrage {
namespace detail {

/// Receivers of a fit. Reports missing or invalid ones in the name of `function`.
template <class Use = on_use>
[[nodiscard]] const rounded_hull<Use>& given(const std::optional<rounded_hull<Use>>& receivers, const char* function) {
    require(receivers.has_value(), function, "receivers", "given", "none");
    const first_fault& fault = receivers->fault;
    if (!fault.condition.empty())
        refuse(function, "receivers." + fault.member, fault.condition, fault.got.c_str(),
               fault.condition == "nowhere above high" ? "A mesh without finite positions has such an empty box." : "");
    require(is_finite(receivers->radius) && receivers->radius >= 0.0, function, "receivers",
            "of a finite radius, 0 or more", receivers->radius);
    for (const glm::dvec3& p : receivers->points) require(all_finite(p), function, "receivers", "finite", p);

    return *receivers;
}

/// Points whose convex hull holds all receivers. The corners of a box replace each ball.
template <class = on_use>
[[nodiscard]] std::vector<glm::dvec3> corners_of(const hull& receivers) {
    if (!(receivers.radius > 0.0)) return receivers.points;
    std::vector<glm::dvec3> all;
    for (const glm::dvec3& p : receivers.points)
        for (const glm::dvec3& c : corners(bounding_box<double>{p - receivers.radius, p + receivers.radius}))
            all.push_back(c);
    return all;
}

/// Matrix from the world to x, y and the distance along the light.
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

    [[nodiscard]] double diagonal() const { return glm::length(high - low); }
};
template <class = on_use>
[[nodiscard]] extent extent_of(const std::vector<glm::dvec3>& points) {
    extent e;
    for (const glm::dvec3& p : points) e.low = (glm::min)(e.low, p), e.high = (glm::max)(e.high, p);
    return e;
}

/// Convex hull in counter-clockwise order, without points on its edges.
/// @cite   Andrew: Another efficient algorithm for convex hulls in two dimensions, 1979
template <class = on_use>
[[nodiscard]] std::vector<glm::dvec2> convex_hull(const std::vector<glm::dvec3>& seen) {
    std::vector<glm::dvec2> points(seen.begin(), seen.end()), hull;
    for (glm::dvec2& p : points) p += 0.0;  // makes all zeros positive: equal points have equal bits
    std::sort(points.begin(), points.end(),
              [](glm::dvec2 a, glm::dvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    // measured from b: rounding may split one corner into a and b, and (c - a) would then lose the turn
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
        hull.pop_back();  // the other side begins with this point
    }
    return hull;
}

/// Intersection of the hull of points and a half-space, as points around it. These are the points inside, and the
/// outermost points where lines from inner to outer points cross the plane.
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
            const glm::dvec3 p = crossing(a, inside(a), b, inside(b));
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

/// Planes (a, b, 0, c) through the edges of a hull. Edges between points that differ only by rounding give no plane,
/// since their direction is arbitrary.
template <class = on_use>
[[nodiscard]] std::vector<glm::dvec4> sides(const std::vector<glm::dvec2>& hull) {
    std::vector<glm::dvec4> planes;
    const auto end_of = [&](std::size_t i) { return hull[i + 1 < hull.size() ? i + 1 : 0]; };
    double longest = 0.0;
    for (std::size_t i = 0; i < hull.size(); ++i) longest = (glm::max)(longest, glm::distance(hull[i], end_of(i)));
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const glm::dvec2 a = hull[i], b = end_of(i), inwards(a.y - b.y, b.x - a.x);
        if (glm::length(inwards) <= longest * 0x1p-32) continue;
        planes.emplace_back(inwards, 0.0, -glm::dot(inwards, a));
    }
    return planes;
}

/// Planes around the sweep of points, each with a square of half side `outwards` around it.
/// Squares keep the planes continuous while points move. Sides moved outwards would jump where a hull corner splits.
template <class = on_use>
[[nodiscard]] std::vector<glm::dvec4> sweep(const std::vector<glm::dvec3>& seen, double outwards) {
    const auto [low, high] = extent_of(seen);
    // casters that touch a side count as inside, however the side was rounded
    const double around = (glm::max)(outwards, 0x1p-32 * (glm::max)(high.x - low.x, high.y - low.y));
    std::vector<glm::dvec3> corners;
    corners.reserve(4 * seen.size());
    for (const glm::dvec3& p : seen)
        for (const double x : {p.x - around, p.x + around})
            for (const double y : {p.y - around, p.y + around}) corners.emplace_back(x, y, p.z);
    return sides(convex_hull(corners));
}

/// Smallest distance along the light to a box's faces within planes; highest<double> if there is none.
template <class = on_use>
[[nodiscard]] double nearest(const glm::dmat4& frame, const polyhedron& box, const std::vector<glm::dvec4>& planes) {
    double least = highest<double>;
    for (const polyhedron::face& face : box.faces()) {
        std::vector<glm::dvec3> polygon = seen(frame, face.corners);
        for (const glm::dvec4& plane : planes) polygon = clipped(polygon, plane);
        for (const glm::dvec3& p : polygon) least = (glm::min)(least, p.z);
    }
    return least;
}

}  // namespace detail
}  // namespace umbrage
