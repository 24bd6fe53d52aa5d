// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/vsm.hpp>

#include "windows.hpp"

namespace parity {

void add_filter_prefiltered_vsm(std::vector<entry>& all) {
    using namespace umbrage;
    const range unit{}, small{0.0f, 0.01f};
    const auto texel = [](float d, sample&) { return vec4(encode_vsm(d), 0.0f, 0.0f); };
    add_both(all,
             {.primitive = &glsl::encode_vsm,
              .classes = spread({unit}, depth_values()),
              .call = "vec4(umbrage_encode_vsm(x0.x), 0.0, 0.0)"},
             [](const sample& s, float far) { return vec4(encode_vsm(s.x[0].x, far), 0.0f, 0.0f); });
    auto classes = all_kinds({unit, unit, unit, unit, unit}, special_values(), {small});
    classes.push_back(windows(texel, {small}));
    add_both(all,
             {.primitive = &glsl::decode_vsm,
              .classes = classes,
              .call = "vec4(umbrage_decode_vsm(vec2(x0.x, x0.y), x1.x, x1.y))"},
             [](const sample& s, float far) { return vec4(decode_vsm(vec2(s.x[0]), s.x[1].x, s.x[1].y, far)); });
    auto moments = spread({unit, unit}, large_values());
    moments.push_back(windows(texel, {}));
    all.push_back({.primitive = &glsl::encode_deviation,
                   .classes = moments,
                   .twin = [](const sample& s) { return vec4(encode_deviation(vec2(s.x[0])), 0.0f, 0.0f); },
                   .call = "vec4(umbrage_encode_deviation(vec2(x0.x, x0.y)), 0.0, 0.0)"});
    all.push_back({.primitive = &glsl::decode_deviation,
                   .classes = spread({unit, unit}, special_values()),
                   .twin = [](const sample& s) { return vec4(decode_deviation(vec2(s.x[0])), 0.0f, 0.0f); },
                   .call = "vec4(umbrage_decode_deviation(vec2(x0.x, x0.y)), 0.0, 0.0)"});
    all.push_back({.primitive = &glsl::decode_deviation_rgba8,
                   .classes = channels(),
                   .twin = [](const sample& s) { return vec4(decode_deviation_rgba8(s.x[0]), 0.0f, 0.0f); },
                   .call = "vec4(umbrage_decode_deviation_rgba8(x0), 0.0, 0.0)"});
}

}  // namespace parity
