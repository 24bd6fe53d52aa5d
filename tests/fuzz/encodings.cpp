// SPDX-License-Identifier: MIT
//
// Encodings: a depth comes back within its stated error, a cleared texel as the far plane.
#include <limits>

#include <umbrage/depth/encodings.hpp>

#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace umbrage;
    fuzz::input in(bytes, size);
    const auto direction = in.chance(2) ? depth_direction::forward : depth_direction::reversed;
    const float a = in.number(-0.5f, 1.5f), nothing = std::numeric_limits<float>::quiet_NaN();
    for_each_encoding([&](auto encoding) {
        encoding = {.direction = direction};
        const auto texel = encoding.encode(a);
        const float back = encoding.decode(texel);
        const float far_away = direction == depth_direction::forward ? 1.0f : 0.0f;
        fuzz::must(encoding.decode(encoding.cleared()) == far_away, "a cleared texel is the far plane");
        if (a >= 0.0f && a < 1.0f) {  // floats store other numbers as they are
            fuzz::must(back >= 0.0f && back <= 1.0f, "a decoded depth lies within 0 and 1");
            const decoding_error off = encoding.error();
            const double above = double(back) - double(a);
            fuzz::must(above <= off.above && -above <= off.below, "a depth comes back within its stated error");
        }
        const float of_nothing = encoding.decode(encoding.encode(nothing));
        const bool keeps_faults = encoding.name == "threejs_legacy" || encoding.name == "base255";
        fuzz::must(keeps_faults || is_nan(of_nothing) || of_nothing == far_away, "NaN stays, or is the far plane");
    });
    return 0;
}
