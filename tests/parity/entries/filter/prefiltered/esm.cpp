// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/esm.hpp>

#include "windows.hpp"

namespace parity {

void add_filter_prefiltered_esm(std::vector<entry>& all) {
    using namespace umbrage;
    const range unit{}, exponent{1.0f, 63.0f};
    all.push_back({.primitive = &glsl::exponential_warp,
                   .classes = spread({unit, {-63.0f, 63.0f}}, special_values()),
                   .twin = [](const sample& s) { return vec4(exponential_warp(s.x[0].x, s.x[0].y)); },
                   .call = "vec4(umbrage_exponential_warp(x0.x, x0.y))"});
    add_both(all,
             {.primitive = &glsl::encode_esm,
              .classes = spread({unit, exponent}, special_values()),
              .call = "vec4(umbrage_encode_esm(x0.x, x0.y))"},
             [](const sample& s, float far) { return vec4(encode_esm(s.x[0].x, s.x[0].y, far)); });
    auto classes = spread({unit, unit, unit, unit, unit, exponent}, special_values());
    classes.push_back(windows([](float d, sample& s) { return vec4(encode_esm(d, s.x[1].y)); }, {exponent}));
    add_both(all,
             {.primitive = &glsl::decode_esm, .classes = classes, .call = "vec4(umbrage_decode_esm(x0.x, x1.x, x1.y))"},
             [](const sample& s, float far) { return vec4(decode_esm(s.x[0].x, s.x[1].x, s.x[1].y, far)); });
}

}  // namespace parity
