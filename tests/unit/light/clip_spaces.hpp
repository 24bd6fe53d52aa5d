// SPDX-License-Identifier: MIT
//
// Common parts of tests of lights: every convention, transformation in double, differences of matrices, and messages
// of errors.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/scalar.hpp>

inline std::vector<umbrage::clip_space> all_clip_spaces() {
    using namespace umbrage;
    std::vector<clip_space> all;
    for (auto hand : {handedness::right, handedness::left})
        for (auto range : {depth_range::zero_to_one, depth_range::minus_one_to_one})
            for (auto direction : {depth_direction::forward, depth_direction::reversed})
                for (auto origin : {texture_origin::bottom, texture_origin::top})
                    all.push_back({hand, range, direction, origin});
    return all;
}

inline std::string to_string(umbrage::clip_space clip) {
    using namespace umbrage;
    return std::string(clip.hand == handedness::right ? "right " : "left ") +
           (clip.range == depth_range::zero_to_one ? "[0,1] " : "[-1,1] ") +
           (clip.direction == depth_direction::forward ? "forward " : "reversed ") +
           (clip.origin == texture_origin::bottom ? "bottom" : "top");
}

/// A point or direction of a right-handed world in the convention's: left-handed ones are its mirror image.
inline glm::dvec3 in_world(glm::dvec3 p, umbrage::clip_space clip) {
    return clip.hand == umbrage::handedness::right ? p : glm::dvec3(p.x, p.y, -p.z);
}

/// Texels and depth of a map with its first row at the bottom and depth that runs forward, in the convention's.
inline glm::dvec3 in_convention(glm::dvec3 p, umbrage::clip_space clip, double height) {
    if (clip.origin == umbrage::texture_origin::top) p.y = height - p.y;
    if (clip.direction == umbrage::depth_direction::reversed) p.z = 1.0 - p.z;
    return p;
}

/// Message of a setup function's error; empty without an error.
template <class Call>
std::string complaint(Call call) {
    try {
        call();
    } catch (const std::invalid_argument& e) { return e.what(); }
    return {};
}

/// The greater of two errors; a NaN is the greatest there is.
inline double worse(double a, double b) {
    return std::isnan(a) || std::isnan(b) ? std::numeric_limits<double>::infinity() : (a > b ? a : b);
}

/// Through a 4x4 matrix and the division, in double.
template <class T>
glm::dvec3 through(const glm::mat<4, 4, T>& m, glm::dvec3 p) {
    const glm::dvec4 h = glm::dmat4(m) * glm::dvec4(p, 1.0);
    return glm::dvec3(h) / h.w;
}

/// Greatest difference between entries, as a share of the greatest entry.
template <class T>
double difference(const glm::mat<4, 4, T>& a, const glm::mat<4, 4, T>& b) {
    double gap = 0, greatest = 0;
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) {
            if (!(umbrage::is_finite(a[c][r]) && umbrage::is_finite(b[c][r])))
                return std::numeric_limits<double>::infinity();
            gap = std::max(gap, std::abs(double(a[c][r]) - double(b[c][r])));
            greatest = std::max(greatest, std::abs(double(a[c][r])));
        }
    return gap / greatest;
}
