// SPDX-License-Identifier: MIT
//
// tier_a.cpp's inputs for debug views.
#pragma once

#include <array>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/debug/overlay_texel.hpp>
#include <umbrage/debug/probe_color.hpp>

#include "hostile.hpp"

namespace hostile {

/// @param run   (name, draw, op)
template <class Run>
void each_of_debug(const Run& run) {
    using namespace umbrage;
    run(
        "overlay_texel",
        [](source& s) {
            const auto size = 1 + s.below(2048), map_size = 1 + s.below(4096);
            return glm::vec3(float(s.below(size)) + 0.5f, float(size), float(map_size));
        },
        [](glm::vec3 v) { return overlay_texel(v.x, v.y, v.z, v.z / v.y); });
    run(
        "probe_color",
        [](source& s) {
            const auto x = s.below(640), y = s.below(640), z = s.below(9), number = s.below(64), bias = s.below(9);
            return std::array{float(x) / 16.0f - 4.0f, float(y) / 16.0f - 4.0f, float(z) / 4.0f - 0.5f,
                              float(bias) / 8.0f, float(number)};
        },
        [](const std::array<float, 5>& v) {
            return probe_color(glm::vec3(v[0], v[1], v[2]), glm::vec2(32.0f), v[3], v[4]);
        });
    run(
        "probe_inputs",
        [](source& s) {
            const auto zero = s.below(2), way = s.below(3);
            glm::vec3 normal(0);
            normal[glm::length_t(way)] = float(zero);
            return normal;
        },
        [](glm::vec3 v) { return probe_inputs(glm::vec3(0.5f), glm::vec3(1.0f), v); });
}

}  // namespace hostile
