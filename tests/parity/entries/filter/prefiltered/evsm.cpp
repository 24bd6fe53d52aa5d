// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/evsm.hpp>

#include "windows.hpp"

namespace parity {

void add_filter_prefiltered_evsm(std::vector<entry>& all) {
    using namespace umbrage;
    const range unit{}, exponent{1.0f, 54.0f}, falling{1.0f, 43.0f}, deviation{0.005f, 0.02f};  // of make_evsm
    const auto exponents = [](const sample& s) { return vec2(s.x[1].y, s.x[1].z); };
    add_both(all,
             {.primitive = &glsl::encode_evsm2,
              .classes = spread({unit, exponent}, special_values()),
              .call = "vec4(umbrage_encode_evsm2(x0.x, x0.y), 0.0, 0.0)"},
             [](const sample& s, float far) { return vec4(encode_evsm2(s.x[0].x, s.x[0].y, far), 0.0f, 0.0f); });
    add_both(all,
             {.primitive = &glsl::encode_evsm4,
              .classes = spread({unit, exponent, exponent}, special_values()),
              .call = "umbrage_encode_evsm4(x0.x, vec2(x0.y, x0.z))"},
             [](const sample& s, float far) { return encode_evsm4(s.x[0].x, vec2(s.x[0].y, s.x[0].z), far); });
    auto classes = all_kinds({unit, unit, unit, unit, unit}, large_values(), {exponent, falling, deviation, deviation});
    classes.push_back(windows([exponents](float d, sample& s) { return encode_evsm4(d, exponents(s)); },
                              {exponent, falling, deviation, deviation}));
    add_both(
        all,
        {.primitive = &glsl::decode_evsm2,
         .classes = classes,
         .call = "vec4(umbrage_decode_evsm2(vec2(x0.x, x0.y), x1.x, x1.y, x1.w))"},
        [](const sample& s, float far) { return vec4(decode_evsm2(vec2(s.x[0]), s.x[1].x, s.x[1].y, s.x[1].w, far)); });
    add_both(all,
             {.primitive = &glsl::decode_evsm4,
              .classes = classes,
              .call = "vec4(umbrage_decode_evsm4(x0, x1.x, vec2(x1.y, x1.z), vec2(x1.w, x2.x)))"},
             [exponents](const sample& s, float far) {
                 return vec4(decode_evsm4(s.x[0], s.x[1].x, exponents(s), vec2(s.x[1].w, s.x[2].x), far));
             });
}

}  // namespace parity
