// SPDX-License-Identifier: MIT
//
// Random numbers of a draw, all from its seed and alike in every standard library: distributions are not.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace joints {

class dice {
public:
    explicit dice(std::uint64_t seed) : random_(seed * 0x9E3779B97F4A7C15u + 1) {}

    [[nodiscard]] double real(double low, double high) {
        return low + (high - low) * (double(random_() >> 11) * 0x1p-53);
    }
    /// An integer from low to high, both included.
    [[nodiscard]] int whole(int low, int high) { return low + int(random_() % std::uint64_t(high - low + 1)); }
    [[nodiscard]] bool one_in(int n) { return whole(1, n) == 1; }
    /// A number whose logarithm is even.
    [[nodiscard]] double spread(double low, double high) { return std::exp(real(std::log(low), std::log(high))); }
    [[nodiscard]] glm::dvec3 between(glm::dvec3 low, glm::dvec3 high) {
        const double x = real(low.x, high.x), y = real(low.y, high.y), z = real(low.z, high.z);
        return {x, y, z};
    }
    [[nodiscard]] glm::dvec3 direction() {
        for (;;) {
            const glm::dvec3 v = between(glm::dvec3(-1), glm::dvec3(1));
            if (const double l = glm::length(v); l > 0.1 && l < 1) return v / l;
        }
    }
    /// A direction some way above the ground.
    [[nodiscard]] glm::dvec3 upwards(double least) {
        for (;;)
            if (const glm::dvec3 d = direction(); d.y > least) return d;
    }
    [[nodiscard]] glm::dmat3 rotation() {
        const glm::dvec3 x = direction(), y = glm::normalize(glm::cross(x, any_across(x)));
        return {x, y, glm::cross(x, y)};
    }

private:
    [[nodiscard]] glm::dvec3 any_across(glm::dvec3 axis) {
        for (;;)
            if (const glm::dvec3 d = direction(); glm::length(glm::cross(d, axis)) > 0.1) return d;
    }

    std::mt19937_64 random_;
};

}  // namespace joints
