// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/vsm.hpp>

#include "windows.hpp"

namespace parity {

void add_filter_prefiltered_chebyshev(std::vector<entry>& all) {
    using namespace umbrage;
    const range unit{}, small{0.0f, 0.01f};
    add_both(all,
             {.primitive = &glsl::to_forward_depth,
              .classes = spread({unit}, special_values()),
              .call = "vec4(umbrage_to_forward_depth(x0.x))"},
             [](const sample& s, float far) { return vec4(to_forward_depth(s.x[0].x, far)); });
    auto classes = all_kinds({unit, unit, unit, unit, unit}, special_values(), {small});
    classes.push_back(windows([](float d, sample&) { return vec4(encode_vsm(d), 0.0f, 0.0f); }, {small}));
    all.push_back({.primitive = &glsl::chebyshev,
                   .classes = classes,
                   .twin = [](const sample& s) { return vec4(chebyshev(vec2(s.x[0]), s.x[1].x, s.x[1].y)); },
                   .call = "vec4(umbrage_chebyshev(vec2(x0.x, x0.y), x1.x, x1.y))"});
    all.push_back({.primitive = &glsl::reduce_light_bleeding,
                   .classes = spread({unit, unit}, special_values()),
                   .twin = [](const sample& s) { return vec4(reduce_light_bleeding(s.x[0].x, s.x[0].y)); },
                   .call = "vec4(umbrage_reduce_light_bleeding(x0.x, x0.y))"});
}

}  // namespace parity
