// SPDX-License-Identifier: MIT
//
// Oracle of contact hardening: its steps in 64-bit integers, and its texels by brute force.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include <umbrage/filter/blocker/penumbra.hpp>

#include "../maps.hpp"

namespace whole {

using umbrage::image;

inline std::int64_t floor_divide(std::int64_t a, std::int64_t b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }

/// Radii of an ellipse along x and y, in 1/16 texel.
struct ellipse {
    std::int64_t x, y;
};

/// A light's size as L / 2^j sixteenths of a texel a code, along x and y.
struct softness {
    std::int64_t digits_x, digits_y, shift, min_radius, max_radius;

    [[nodiscard]] ellipse radius(std::int64_t apart) const {
        const auto along = [&](std::int64_t digits) {
            return std::clamp(floor_divide(apart * digits, std::int64_t(1) << shift), min_radius, max_radius);
        };
        return {along(digits_x), along(digits_y)};
    }
    [[nodiscard]] glm::vec4 values() const {
        const auto scaled = [&](std::int64_t digits) {
            return std::ldexp(static_cast<float>(digits), -static_cast<int>(shift));
        };
        return {scaled(digits_x), scaled(digits_y), static_cast<float>(min_radius), static_cast<float>(max_radius)};
    }
};

struct receiver {
    glm::vec2 coord;
    float depth;
    glm::ivec4 rotation;
};

struct search {
    std::int64_t count = 0, sum = 0;
};

/// 16 bits of distance from the near plane, of numbers in [0, 1].
inline std::int64_t code(double depth, bool forward) {
    const auto x = std::min<std::int64_t>(static_cast<std::int64_t>(std::floor(depth * 65536)), 65535);
    return forward ? x : 65535 - x;
}

/// Calls use(stored depth) for the texel under each point.
template <int Points, class Use>
void for_each_tap(const image<float>& map, const receiver& r, ellipse radius, Use use) {
    const auto x = static_cast<std::int64_t>(std::floor(double(r.coord.x) * 256));
    const auto y = static_cast<std::int64_t>(std::floor(double(r.coord.y) * 256));
    for (const glm::ivec2 p : umbrage::disc_points<Points>) {
        const std::int64_t turned_x = r.rotation.x * p.x + r.rotation.y * p.y,
                           turned_y = r.rotation.z * p.x + r.rotation.w * p.y;
        use(texel_at(map, floor_divide(x + floor_divide(turned_x * radius.x, 64), 256),
                     floor_divide(y + floor_divide(turned_y * radius.y, 64), 256)));
    }
}

template <int Points>
search blockers(const image<float>& map, const receiver& r, ellipse radius, bool forward) {
    search found;
    for_each_tap<Points>(map, r, radius, [&](double stored) {
        if (forward ? double(r.depth) <= stored : double(r.depth) >= stored) return;
        ++found.count;
        found.sum += code(stored, forward);
    });
    return found;
}

/// Depths from a map, receivers before, on and behind them, turns of all 16 pixels.
struct cases {
    std::mt19937 random{7};
    image<float> map{{23, 17}};
    std::vector<float> xs = awkward_coordinates(random, 23), ys = awkward_coordinates(random, 17);

    cases() {
        for (float& d : map.texels()) d = static_cast<float>(random() % 33) / 32.0f;
    }
    [[nodiscard]] receiver draw() {
        const float x = xs[random() % xs.size()], y = ys[random() % ys.size()];
        const float depth = static_cast<float>(random() % 65) / 64.0f;
        const auto pixel_x = static_cast<float>(random() % 4), pixel_y = static_cast<float>(random() % 4);
        return {{x, y}, depth, glm::ivec4(umbrage::disc_rotation(glm::vec2(pixel_x, pixel_y)))};
    }
    [[nodiscard]] softness light() {
        const auto digits_x = static_cast<std::int64_t>(random() % 256),
                   digits_y = random() % 2 ? digits_x : static_cast<std::int64_t>(random() % 256),
                   shift = static_cast<std::int64_t>(random() % 16);
        const auto min_radius = static_cast<std::int64_t>(random() % 32),
                   more = static_cast<std::int64_t>(random() % 200);
        return {digits_x, digits_y, shift, min_radius, random() % 8 ? min_radius + more : 4095};
    }
};

}  // namespace whole
