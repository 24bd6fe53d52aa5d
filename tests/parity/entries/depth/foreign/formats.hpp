// SPDX-License-Identifier: MIT
//
// Entries of the formats of others: a depth x0.x in, four channels out, and the way back.
#pragma once

#include <cmath>
#include <utility>

#include <umbrage/core/unorm.hpp>

#include "../../entries.hpp"

namespace parity {

[[nodiscard]] inline std::vector<input_class> format_depths() {
    auto depths = spread({{0.0f, 1.0f}}, depth_values(24));
    depths.push_back(
        {"base-255 edges", [](std::uint64_t i, random& r, sample& s) {  // where a channel of base 255 goes up
             const double step = std::pow(255.0, -1.0 - static_cast<double>(i % 4));
             const auto edge = static_cast<float>(step * r.below(256));
             s.x[0].x = std::nextafter(edge, std::array{0.0f, edge, 1.0f}[i / 4 % 3]);
         }});
    return depths;
}

[[nodiscard]] inline entry writer(const snippet& s, std::string call, vec4 (*twin)(float)) {
    return {.primitive = &s,
            .classes = format_depths(),
            .whole = all_depths(),
            .twin = [twin](const sample& x) { return twin(x.x[0].x); },
            .call = std::move(call)};
}

/// The writer's whole channels, in a real target of 8 bits.
[[nodiscard]] inline entry stored(entry writer) {
    writer.variant = "8-bit target";
    writer.call = "umbrage_to_unorm(" + writer.call + ")";
    writer.also = {&umbrage::glsl::to_unorm};
    writer.output = target::rgba8;
    writer.bits = true;
    return writer;
}

[[nodiscard]] inline entry reader(const snippet& s, std::string call, float (*twin)(vec4)) {
    return {.primitive = &s,
            .classes = channels(),
            .whole = all_codes(),
            .twin = [twin](const sample& x) { return vec4(twin(x.x[0])); },
            .call = std::move(call)};
}

}  // namespace parity
