// SPDX-License-Identifier: MIT
//
// Cameras of every kind by their matrices, and the points that each of their eyes sees.
#pragma once

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include <umbrage/light/frustum.hpp>

#include "bodies.hpp"

namespace cameras {

/// Through lines from low to high at distance 1, x to the right: half_size 0 is perspective.
inline glm::dmat4 projection(glm::dvec2 low, glm::dvec2 high, bool perspective, umbrage::clip_space clip) {
    const double forward = clip.hand == umbrage::handedness::right ? -1 : 1;
    glm::dmat4 m(0);
    for (int i = 0; i < 2; ++i) {
        m[i][i] = 2 / (high[i] - low[i]);
        const double middle = -(high[i] + low[i]) / (high[i] - low[i]);
        (perspective ? m[2][i] : m[3][i]) = perspective ? forward * middle : middle;
    }
    m[2][2] = 0.25, m[3][2] = 0.5;  // of depth, whatever it is
    (perspective ? m[2][3] : m[3][3]) = perspective ? forward : 1;
    return m;
}

/// Half a turn about y by an angle, and a step aside: head to eye.
inline glm::dmat4 eye(double aside, double cant) {
    const glm::dmat4 moved{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {-aside, 0, 0, 1}};
    const double c = std::cos(cant), s = std::sin(cant);
    return glm::dmat4{{c, 0, s, 0}, {0, 1, 0, 0}, {-s, 0, c, 0}, {0, 0, 0, 1}} * moved;
}

enum class kind { perspective, off_axis, orthographic, oblique, two_eyes, turned_eyes };
inline constexpr kind all_kinds[]{kind::perspective, kind::off_axis, kind::orthographic,
                                  kind::oblique,     kind::two_eyes, kind::turned_eyes};
inline std::string to_string(kind k) {
    return std::vector<std::string>{
        "perspective", "off-axis", "orthographic", "oblique", "two eyes", "turned eyes"}[std::size_t(k)];
}

inline glm::dmat4 random_view(std::mt19937& random, double size, umbrage::clip_space clip) {
    return umbrage::look_along(bodies::random_vector(random, -size, size), bodies::random_vector(random, -1, 1),
                               bodies::random_vector(random, -1, 1), clip.hand);
}

/// A camera of a kind, the same sides each time.
inline umbrage::camera_matrices<double> of_kind(kind k, const glm::dmat4& view, umbrage::clip_space clip) {
    umbrage::camera_matrices<double> c{.view = view, .z_near = 0.5, .z_far = 60, .clip = clip};
    const glm::dvec2 low(-0.9, -0.5), high(0.6, 0.55);
    switch (k) {
        case kind::perspective: c.projection = projection({-0.9, -0.5}, {0.9, 0.5}, true, clip); break;
        case kind::off_axis: c.projection = projection(low, high, true, clip); break;
        case kind::orthographic: c.projection = projection(20.0 * low, 30.0 * high, false, clip); break;
        case kind::oblique:
            c.projection = projection(20.0 * low, 30.0 * high, false, clip);
            c.projection[2][0] = 0.02, c.projection[2][1] = -0.01;
            break;
        case kind::two_eyes:
        case kind::turned_eyes: {
            const double cant = k == kind::turned_eyes ? 0.17 : 0.0;
            c.projection = projection(low, high, true, clip) * eye(-0.032, cant);
            c.other_eye = projection({-high.x, low.y}, {-low.x, high.y}, true, clip) * eye(0.032, -cant);
        }
    }
    return c;
}

/// A random point at a distance along the view that an eye sees.
inline glm::dvec3 seen_by(const umbrage::camera_matrices<double>& c, const glm::dmat4& projection, double distance,
                          std::mt19937& random) {
    const double z = c.clip.hand == umbrage::handedness::right ? -distance : distance;
    const glm::dvec2 at(bodies::random_vector(random, -1, 1));
    const glm::dmat4 rows = glm::transpose(projection);
    const glm::dvec4 a = rows[0] - at.x * rows[3], b = rows[1] - at.y * rows[3];
    const glm::dvec2 xy = glm::inverse(glm::dmat2(a.x, b.x, a.y, b.y)) * -glm::dvec2(a.z * z + a.w, b.z * z + b.w);
    return glm::inverse(c.view) * glm::dvec4(xy, z, 1);
}

}  // namespace cameras
