// SPDX-License-Identifier: MIT
//
// Bounds that lights are fitted to: boxes, spheres, camera frustums and slices of them, and points.
// An intersection is the part of a scene that a camera sees.
//
//     umbrage::polyhedron seen = umbrage::intersection(camera, umbrage::bounding_box<float>{scene_low, scene_high});
//
// Corners are computed in double for float and double alike.
//
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <glm/vector_relational.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/light/frustum.hpp>

namespace umbrage {

/// Box with sides along the axes of the world.
template <real T>
struct bounding_box {
    glm::vec<3, T> low{T(-1)}, high{T(1)};  ///< low <= high; a flat box is allowed
};

/// Sphere in world space.
template <real T>
struct bounding_sphere {
    glm::vec<3, T> center{T(0)};
    T radius = T(1);  ///< >= 0
};

namespace detail {

/// Box that was not given, with its low above its high. Setup functions that need a box refuse it.
template <real T>
inline constexpr bounding_box<T> unset_box{glm::vec<3, T>(1), glm::vec<3, T>(-1)};

/// Calls must(met, member, condition, value) for each condition of a box.
template <real T, class Must>
void check(const bounding_box<T>& box, Must&& must) {
    must(all_finite(box.low), "low", "finite", box.low);
    must(all_finite(box.high), "high", "finite", box.high);
    must(!glm::any(glm::greaterThan(box.low, box.high)), "low", "nowhere above high",
         glm::mat<2, 3, T>(box.low, box.high));
}

/// Reports a box that is not finite, or whose low is above its high.
template <real T>
void require_box(const bounding_box<T>& box, const char* function, const char* argument) {
    check(box, member_check{function, argument});
}

/// Reports a box that was not given, or that require_box reports.
template <real T>
void require_given(const bounding_box<T>& box, const char* function, const char* argument) {
    require(!glm::all(glm::greaterThan(box.low, box.high)), function, argument, "given, with low not above high",
            "no box");
    require_box(box, function, argument);
}

/// corners, with errors in the name of `function`.
template <real T>
[[nodiscard]] eight_corners corners_for(const char* function, const bounding_box<T>& box) {
    require_box(box, function, "box");
    const glm::dvec3 low(box.low), high(box.high);
    eight_corners all;
    for (std::size_t i = 0; i < 8; ++i)
        all[i] = {(i & 1 ? high : low).x, (i & 2 ? high : low).y, (i & 4 ? high : low).z};
    return all;
}

}  // namespace detail

/// Corners of a box. The bits of an index select the high x, y and z.
/// @throws std::invalid_argument  bounds that are not finite; low above high
template <real T>
[[nodiscard]] eight_corners corners(const bounding_box<T>& box) {
    return detail::corners_for("corners", box);
}

/// Sphere around a frustum: the smallest one whose center lies on the frustum's central line.
///
/// The radius depends on distances and tangents alone, so its bits do not change as the camera turns and moves.
/// @formula   zc = min(f, (n + f) (1 + t) / 2), r^2 = (f - zc)^2 + f^2 t, t = tan_half_x^2 + tan_half_y^2; more terms
///            for a shift or a half_size
/// @throws std::invalid_argument  an invalid frustum: see its members
template <real T>
[[nodiscard]] bounding_sphere<double> sphere_around(const frustum<T>& f) {
    const glm::dmat3 axes = detail::axes(f, "sphere_around");
    const glm::dvec2 tangents(f.tan_half_x, f.tan_half_y), size(f.half_size), shift = glm::abs(glm::dvec2(f.shift));
    const auto n = double(f.z_near), z_far = double(f.z_far);
    const double t = tangents.x * tangents.x + tangents.y * tangents.y;
    const double s = glm::dot(shift, shift), leaning = glm::dot(size, tangents);
    const glm::dvec2 at_near = size + n * tangents, at_far = size + z_far * tangents;
    // the point equally far from near and far corners without a shift, then the shift's contribution
    const double upright = (n + z_far) * (1.0 + t) / 2.0 + leaning, lean = s * (z_far - n);
    const double turned = lean * (z_far + n) + 2.0 * (glm::dot(shift, at_far) * z_far + glm::dot(shift, at_near) * n) -
                          2.0 * upright * (lean + glm::dot(shift, at_far + at_near));
    const double center =
        (glm::min)(z_far, upright + turned / (2.0 * (z_far - n + lean + glm::dot(shift, at_far + at_near))));
    const double beyond = z_far - center;
    const double more =
        beyond * (s * beyond + 2.0 * glm::dot(shift, at_far)) + 2.0 * z_far * leaning + glm::dot(size, size);
    return {glm::dvec3(f.position) + axes * glm::dvec3(glm::dvec2(f.shift) * center, center),
            std::sqrt(beyond * beyond + z_far * z_far * t + more)};
}

namespace detail {

/// Point where the line through p and q crosses a plane, by their distances from it. It starts from the nearer one, to
/// keep its precision if the other is far away.
[[nodiscard]] inline glm::dvec3 crossing(const glm::dvec3& p, double at_p, const glm::dvec3& q, double at_q) {
    return glm::abs(at_q) < glm::abs(at_p) ? q + (p - q) * (at_q / (at_q - at_p))
                                           : p + (q - p) * (at_p / (at_p - at_q));
}

/// Part of a convex polygon on the inner side of a plane.
template <class = on_use>
[[nodiscard]] std::vector<glm::dvec3> clipped(const std::vector<glm::dvec3>& polygon, const glm::dvec4& plane) {
    const auto inside = [&](const glm::dvec3& p) { return glm::dot(glm::dvec3(plane), p) + plane.w; };
    std::vector<glm::dvec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 &p = polygon[i], &q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
        const double at_p = inside(p), at_q = inside(q);
        if (!(at_p < 0.0)) kept.push_back(p);
        if ((at_p < 0.0) != (at_q < 0.0)) kept.push_back(crossing(p, at_p, q, at_q));
    }
    return kept;
}

/// Implementation of polyhedron.
template <class = on_use>
class convex_body {
public:
    struct face {
        glm::dvec4 plane;                 ///< dot(plane, (p, 1)) >= 0 inside
        std::vector<glm::dvec3> corners;  ///< empty if the body does not reach the plane
    };

    convex_body() = default;

    template <real T>
    convex_body(const bounding_box<T>& box) {
        const glm::dvec3 low(box.low), high(box.high);
        add_faces(corners_for("polyhedron", box), {{{1, 0, 0, -low.x},
                                                    {-1, 0, 0, high.x},
                                                    {0, 1, 0, -low.y},
                                                    {0, -1, 0, high.y},
                                                    {0, 0, 1, -low.z},
                                                    {0, 0, -1, high.z}}});
    }

    template <real T>
    convex_body(const frustum<T>& f) {
        const glm::dmat3 axes = detail::axes(f, "polyhedron");
        const auto x = double(f.tan_half_x), y = double(f.tan_half_y);
        const glm::dvec2 shift(f.shift), size(f.half_size);
        const auto plane = [&](glm::dvec3 normal, double offset) {
            const glm::dvec3 n = axes * normal;
            return glm::dvec4(n, offset - glm::dot(n, glm::dvec3(f.position)));
        };
        add_faces(corners_for("polyhedron", f),
                  {plane({1, 0, x - shift.x}, size.x), plane({-1, 0, x + shift.x}, size.x),
                   plane({0, 1, y - shift.y}, size.y), plane({0, -1, y + shift.y}, size.y),
                   plane({0, 0, 1}, -double(f.z_near)), plane({0, 0, -1}, double(f.z_far))});
    }

    [[nodiscard]] const std::vector<face>& faces() const& { return faces_; }
    void faces() const&& = delete;  ///< deleted for temporaries: the reference would dangle
    [[nodiscard]] bool empty() const { return faces_.empty(); }

    [[nodiscard]] static convex_body common(const convex_body& a, const convex_body& b) {
        convex_body body;
        bool touch = false;
        const auto add = [&](const convex_body& of, const convex_body& within) {
            for (face f : of.faces_) {
                for (const face& other : within.faces_) f.corners = clipped(f.corners, other.plane);
                touch = touch || !f.corners.empty();
                body.faces_.push_back(
                    std::move(f));  // faces without corners too: rounding may remove corners of a flat body
            }
        };
        add(a, b);
        add(b, a);
        return touch && !a.empty() && !b.empty() ? body : convex_body();
    }

private:
    void add_faces(const eight_corners& c, const std::array<glm::dvec4, 6>& planes) {
        constexpr std::size_t order[6][4]{{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                          {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}};
        for (std::size_t i = 0; i < 6; ++i)
            faces_.push_back({planes[i], {c[order[i][0]], c[order[i][1]], c[order[i][2]], c[order[i][3]]}});
    }

    std::vector<face> faces_;
};

}  // namespace detail

/// Convex body, given by its faces.
using polyhedron = detail::convex_body<>;

/// Intersection of two bodies, empty if they do not meet.
template <class Use = detail::on_use>
[[nodiscard]] polyhedron intersection(const polyhedron& a, const polyhedron& b) {
    return detail::convex_body<Use>::common(a, b);
}

namespace detail {

/// First unmet condition of the bounds that a hull was made of. The fit that takes the hull reports it.
struct first_fault {
    std::string member, condition, got;  ///< empty without a fault

    template <class Value>
    void operator()(bool met, std::string_view checked, std::string_view wanted, const Value& value) {
        if (!met && condition.empty()) member = checked, condition = wanted, got = printed(value);
    }
};

/// Implementation of hull.
template <class Use = on_use>
struct rounded_hull {
    std::vector<glm::dvec3> points;
    double radius = 0.0;  ///< radius of the ball around each point, world units
    first_fault fault;    ///< of an invalid box or frustum, which gives no points

    rounded_hull() = default;
    template <real T>
    rounded_hull(std::span<const glm::vec<3, T>> p) : points(p.begin(), p.end()) {}
    template <real T>
    rounded_hull(const std::vector<glm::vec<3, T>>& p) : points(p.begin(), p.end()) {}
    template <real T>
    rounded_hull(const bounding_sphere<T>& s) : points{glm::dvec3(s.center)}, radius(double(s.radius)) {}
    template <real T>
    rounded_hull(const bounding_box<T>& box) {
        add_corners(box);
    }
    template <real T>
    rounded_hull(const frustum<T>& f) {
        add_corners(f);
    }
    rounded_hull(const eight_corners& c) : points(c.begin(), c.end()) {}
    rounded_hull(const convex_body<Use>& p) {
        for (const auto& face : p.faces()) points.insert(points.end(), face.corners.begin(), face.corners.end());
    }

private:
    void add_corners(const auto& bounds) {
        check(bounds, fault);
        if (!fault.condition.empty()) return;
        const eight_corners c = corners_for("hull", bounds);
        points.assign(c.begin(), c.end());
    }
};

}  // namespace detail

/// Convex hull of points with a ball around each: the shape that a directional light is fitted to.
/// A fit refuses the hull of an invalid box or frustum.
using hull = detail::rounded_hull<>;

}  // namespace umbrage
