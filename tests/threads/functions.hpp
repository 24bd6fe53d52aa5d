// SPDX-License-Identifier: MIT
//
// Each function that takes a hook for threads, with arguments that give it several pieces.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <umbrage/core/image.hpp>

#include "hooks.hpp"

/// Bytes of a result.
using blob = std::vector<std::byte>;

struct function {
    std::string name;
    std::function<blob(const hook&)> run;
};

template <class T>
[[nodiscard]] blob blob_of(std::span<const T> values) {
    const auto all = std::as_bytes(values);
    return {all.begin(), all.end()};
}
template <class T>
[[nodiscard]] blob blob_of(const umbrage::image<T>& image) {
    return blob_of(image.texels());
}

/// Numbers of a small generator, the same on every machine.
class numbers {
public:
    [[nodiscard]] float operator()(float low, float high) {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return low + (high - low) * (static_cast<float>(state_ >> 40) / 16777216.0f);
    }

private:
    std::uint64_t state_ = 1;
};

/// Image of random depths.
[[nodiscard]] inline umbrage::image<float> random_depths(glm::ivec2 size) {
    numbers random;
    umbrage::image<float> depths(size);
    for (float& depth : depths.texels()) depth = random(0, 1);
    return depths;
}

[[nodiscard]] std::vector<function> depth_passes();
[[nodiscard]] std::vector<function> visibilities();
[[nodiscard]] std::vector<function> tables();
