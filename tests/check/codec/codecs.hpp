// SPDX-License-Identifier: MIT
//
// The library's encodings, each as two functions of channels. Their channels are integers: what a store keeps.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <glm/vec4.hpp>

namespace check {

struct codec {
    std::string name;
    int bits, channels;
    std::function<glm::vec4(float depth)> encode;
    /// The same where values are truncated before the store. None: its writer gives integers, which nothing truncates.
    std::function<glm::vec4(float depth)> truncated;
    std::function<float(glm::vec4 channels)> decode;
};

/// All encodings of umbrage::encodings that have channels, in their order. Those with a choice of edge come three
/// times.
[[nodiscard]] const std::vector<codec>& codecs();

/// Bits of a channel, in the order in which they are tried.
inline constexpr int channel_bits[]{8, 16, 10};
[[nodiscard]] inline float largest_channel(int bits) { return static_cast<float>((1 << bits) - 1); }

/// Channels in another order: the k-th is taken from order[k].
struct channel_order {
    int from[4]{0, 1, 2, 3};
    [[nodiscard]] glm::vec4 operator()(const glm::vec4& v) const {
        return {v[from[0]], v[from[1]], v[from[2]], v[from[3]]};
    }
    [[nodiscard]] bool plain(int channels) const {
        for (int k = 0; k < channels; ++k)
            if (from[k] != k) return false;
        return true;
    }
    /// As a swizzle: "abgr".
    [[nodiscard]] std::string name(int channels) const {
        std::string all;
        for (int k = 0; k < channels; ++k) all += "rgba"[from[k]];
        return all;
    }
};

}  // namespace check
