// SPDX-License-Identifier: MIT
//
// Prefiltered shadow maps as a user would write them with GLM from the cited formulas, one texel after the other.
#pragma once

#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/image.hpp>

namespace peers::glm_code {

inline float chebyshev(glm::vec2 m, float receiver, float min_variance) {
    if (receiver <= m.x) return 1.0f;
    const float variance = glm::max(m.y - m.x * m.x, min_variance), d = receiver - m.x;
    return variance / (variance + d * d);
}

struct vsm {
    using texel = glm::vec2;
    float min_variance;
    [[nodiscard]] texel encode(float depth) const { return {depth, depth * depth}; }
    [[nodiscard]] float decode(texel m, float receiver) const { return chebyshev(m, receiver, min_variance); }
};

struct evsm4 {
    using texel = glm::vec4;
    glm::vec2 exponents, deviations;
    [[nodiscard]] texel encode(float depth) const {
        const glm::vec2 w = warp(depth);
        return {w.x, w.x * w.x, w.y, w.y * w.y};
    }
    [[nodiscard]] float decode(texel m, float receiver) const {
        const glm::vec2 w = warp(receiver), least = deviations * w;
        return glm::min(chebyshev({m.x, m.y}, w.x, least.x * least.x), chebyshev({m.z, m.w}, w.y, least.y * least.y));
    }
    [[nodiscard]] glm::vec2 warp(float depth) const {
        const float z = depth * 2.0f - 1.0f;
        return {std::exp2(exponents.x * z), -std::exp2(-exponents.y * z)};
    }
};

/// Four moments by Hamburger's bound, its steps in the order of Peters and Klein.
struct msm {
    using texel = glm::vec4;
    glm::vec2 bias;
    [[nodiscard]] texel encode(float depth) const {
        const float z = depth * 2.0f - 1.0f, square = z * z;
        return {z, square, square * z, square * square};
    }
    [[nodiscard]] float decode(texel moments, float receiver) const {
        const glm::vec4 b = glm::mix(moments, glm::vec4(0.0f, bias.y, 0.0f, bias.y), bias.x);
        const float z0 = receiver * 2.0f - 1.0f, L = b.z - b.x * b.y, D = b.y - b.x * b.x, V = b.w - b.y * b.y;
        const float E = V * D - L * L, l = L / D;
        glm::vec3 c(1.0f, z0 - b.x, z0 * z0 - b.y);
        c.z -= l * c.y;
        c.y /= D;
        c.z *= D / E;
        c.y -= l * c.z;
        c.x -= glm::dot(glm::vec2(c.y, c.z), glm::vec2(b.x, b.y));
        const float p = c.y / c.z, q = c.x / c.z, r = std::sqrt(glm::max(p * p * 0.25f - q, 0.0f));
        const float z1 = -p * 0.5f - r, z2 = -p * 0.5f + r;
        const glm::vec4 s = z2 < z0   ? glm::vec4(z1, z0, 1.0f, 1.0f)
                            : z1 < z0 ? glm::vec4(z0, z1, 0.0f, 1.0f)
                                      : glm::vec4(0.0f);
        const float share = (s.x * z2 - b.x * (s.x + z2) + b.y) / ((z2 - s.y) * (z0 - z1));
        return 1.0f - glm::clamp(s.z + s.w * share, 0.0f, 1.0f);
    }
};

template <class Texel>
Texel clamped_texel(const umbrage::image<Texel>& map, glm::ivec2 at) {
    at = glm::clamp(at, glm::ivec2(0), map.size() - 1);
    return map.texels()[static_cast<std::size_t>(at.y * map.size().x + at.x)];
}

template <class Filter>
void encode(const Filter& filter, const umbrage::image<float>& depth, umbrage::image<typename Filter::texel>& to) {
    for (std::size_t i = 0; i < depth.texels().size(); ++i)
        to.texels()[i] = filter.encode(glm::clamp(depth.texels()[i], 0.0f, 1.0f));
}

/// Along one axis.
template <class Texel>
void blur(const umbrage::image<Texel>& from, umbrage::image<Texel>& to, const std::vector<float>& weights,
          glm::ivec2 step) {
    for (int y = 0; y < from.size().y; ++y)
        for (int x = 0; x < from.size().x; ++x) {
            const glm::ivec2 at(x, y);
            Texel sum = clamped_texel(from, at) * weights[0];
            for (int i = 1; i < static_cast<int>(weights.size()); ++i)
                sum += (clamped_texel(from, at - step * i) + clamped_texel(from, at + step * i)) *
                       weights[static_cast<std::size_t>(i)];
            to[at] = sum;
        }
}

template <class Filter>
void look_up(const Filter& filter, const umbrage::image<typename Filter::texel>& map,
             const umbrage::image<glm::vec3>& receivers, umbrage::image<float>& visibility) {
    for (std::size_t i = 0; i < receivers.texels().size(); ++i) {
        const glm::vec3 r = receivers.texels()[i];
        const glm::vec2 x = glm::vec2(r) - 0.5f, texel = glm::floor(x), weight = x - texel;
        const auto at = [&](int dx, int dy) { return clamped_texel(map, glm::ivec2(texel) + glm::ivec2(dx, dy)); };
        const auto low = glm::mix(at(0, 0), at(1, 0), weight.x), high = glm::mix(at(0, 1), at(1, 1), weight.x);
        visibility.texels()[i] = r.z > 1.0f ? 1.0f : filter.decode(glm::mix(low, high, weight.y), r.z);
    }
}

}  // namespace peers::glm_code
