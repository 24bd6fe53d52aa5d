// SPDX-License-Identifier: MIT
//
// Inputs of decoders: means of what a few depths are encoded as, and a receiver at one of them, close to an end,
// elsewhere or beyond.
#pragma once

#include <cmath>

#include "../../entries.hpp"

namespace parity {

/// In x0 the mean of `encode` of one to four depths, in x1.x a receiver; the rest of x1 and x2 from `others`.
template <class Encode>
[[nodiscard]] input_class windows(const Encode& encode, const std::vector<range>& others) {
    return {
        "windows", [encode, others](std::uint64_t i, random& r, sample& s) {
            const int count = 1 + r.below(4);
            for (std::size_t k = 0; k < others.size(); ++k)
                s.x[1 + (k + 1) / 4][static_cast<int>((k + 1) % 4)] = r.between(others[k].low, others[k].high);
            vec4 sum(0);
            float depth = r.unit();
            for (int k = 0; k < count; ++k) {
                depth = i % 2 ? r.unit() : depth + r.unit() * 0.01f;
                sum += encode(depth, s);
            }
            s.x[0] = sum / static_cast<float>(count);
            const float part = r.unit(), near_end = std::ldexp(part, -r.below(24));
            s.x[1].x = i % 3 == 0 ? depth : i % 3 == 1 ? r.between(-0.25f, 1.25f) : i % 2 ? near_end : 1.0f - near_end;
        }};
}

/// Moments in x0 and a receiver in x1.x of all kinds, with settings in what follows, which are ordinary.
[[nodiscard]] inline std::vector<input_class> all_kinds(const std::vector<range>& of_data,
                                                        const std::vector<value_class>& kinds,
                                                        const std::vector<range>& settings) {
    std::vector<input_class> classes = spread(of_data, kinds);
    for (input_class& c : classes)
        c.fill = [fill = c.fill, settings](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            for (std::size_t k = 0; k < settings.size(); ++k)
                s.x[1 + (k + 1) / 4][static_cast<int>((k + 1) % 4)] = r.between(settings[k].low, settings[k].high);
        };
    return classes;
}

/// NaN and infinities. Numbers that are no depths' moments have shares with poles, beside which rounding decides
/// between 0 and 1: of 2^20 of them softpipe, whose division rounds otherwise, differed in one or two.
[[nodiscard]] inline std::vector<value_class> values_of_moments() {
    auto kinds = special_values();
    std::erase_if(kinds, [](const value_class& k) { return k.name != "NaN" && k.name != "infinity"; });
    return kinds;
}

/// An entry in both directions of depth.
inline void add_both(std::vector<entry>& all, entry e, std::function<vec4(const sample&, float far)> twin) {
    e.twin = [twin](const sample& s) { return twin(s, 1.0f); };
    all.push_back(e);
    e.variant = "reversed";
    e.map_kind.direction = umbrage::depth_direction::reversed;
    e.twin = [twin](const sample& s) { return twin(s, 0.0f); };
    all.push_back(std::move(e));
}

}  // namespace parity
