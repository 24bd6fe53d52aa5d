// SPDX-License-Identifier: MIT
//
// Common parts of tests of prefiltered maps: windows of depths with a receiver, and their lit fraction.
#pragma once

#include <algorithm>
#include <random>
#include <vector>

/// Depths k / 1024, 16 of them, so that floats hold their first two moments; the same surface, or up to three.
struct depth_window {
    std::vector<float> depths;
    float receiver = 0;

    explicit depth_window(std::mt19937& random) {
        const auto surfaces = 1 + random() % 3, slope = 1 + random() % 9;
        int base[3];
        for (int& b : base) b = static_cast<int>(random() % 1025);
        for (int i = 0; i < 16; ++i)
            depths.push_back(depth(base[random() % surfaces] + static_cast<int>(random() % slope)));
        const int near = static_cast<int>(depths[random() % 16] * 1024) + static_cast<int>(random() % 5) - 2;
        receiver = depth(random() % 3 ? near : static_cast<int>(random() % 1025));
    }

    [[nodiscard]] static float depth(int k) { return static_cast<float>(std::clamp(k, 0, 1024)) / 1024.0f; }
    [[nodiscard]] double lit() const {
        const auto count = std::count_if(depths.begin(), depths.end(), [&](float d) { return receiver <= d; });
        return static_cast<double>(count) / 16;
    }
    /// Mean of what `of` makes of each depth.
    template <class Of>
    [[nodiscard]] auto mean(const Of& of) const {
        auto sum = of(depths[0]);
        for (std::size_t i = 1; i < depths.size(); ++i) sum = sum + of(depths[i]);
        return sum * (1.0 / 16);
    }
};
