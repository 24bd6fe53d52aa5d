// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/exp2.hpp>

#include <cmath>

#include "../../entries.hpp"

namespace parity {

void add_filter_prefiltered_exp2(std::vector<entry>& all) {
    using namespace umbrage;
    all.push_back({.primitive = &glsl::power_of_two,
                   .classes = {{"whole", [](std::uint64_t i, random&,
                                            sample& s) { s.x[0].x = static_cast<float>(i % 128) - 64.0f; }}},
                   .twin = [](const sample& s) { return vec4(power_of_two(s.x[0].x)); },
                   .call = "vec4(umbrage_power_of_two(x0.x))"});
    auto classes = spread({{-66.0f, 65.0f}}, special_values());
    classes.push_back({"whole", [](std::uint64_t i, random& r, sample& s) {
                           const float n = static_cast<float>(r.below(130) - 65);
                           s.x[0].x = i % 3 == 0 ? n : std::nextafter(n, i % 3 == 1 ? -1e9f : 1e9f);
                       }});
    classes.push_back({"steps", [](std::uint64_t i, random& r, sample& s) {
                           const float y = static_cast<float>(r.below(4096) - 2048) / 2048.0f;
                           s.x[0].x = i % 3 == 0 ? y : std::nextafter(y, i % 3 == 1 ? -1e9f : 1e9f);
                       }});
    all.push_back({.primitive = &glsl::exp2_polynomial,
                   .classes = classes,
                   .twin = [](const sample& s) { return vec4(exp2_polynomial(s.x[0].x)); },
                   .call = "vec4(umbrage_exp2_polynomial(x0.x))"});
    all.push_back({.primitive = &glsl::exp2_steps,
                   .classes = classes,
                   .twin = [](const sample& s) { return vec4(exp2_steps(s.x[0].x)); },
                   .call = "vec4(umbrage_exp2_steps(x0.x))"});
}

}  // namespace parity
