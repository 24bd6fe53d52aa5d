// SPDX-License-Identifier: MIT
//
// Inputs at the ends of a code's interval: the center of one of 24 bits is no float.
#pragma once

#include <utility>

#include "../entries.hpp"

namespace parity {

[[nodiscard]] inline input_class at_ends(input_class kind) {
    return {kind.name, [fill = std::move(kind.fill)](std::uint64_t i, random& r, sample& s) {
                fill(i, r, s);
                s.x[1].x = s.x[1].x > 0.0f ? 1.0f : 0.0f;
            }};
}

}  // namespace parity
