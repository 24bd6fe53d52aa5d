// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/msm.hpp>

#include "windows.hpp"

namespace parity {

void add_filter_prefiltered_msm(std::vector<entry>& all) {
    using namespace umbrage;
    const range unit{}, both{-1.0f, 1.0f}, share{1e-6f, 1e-3f}, target{0.375f, 0.628f};
    const auto texel = [](float d, sample&) { return encode_msm(d); };
    add_both(all,
             {.primitive = &glsl::encode_msm,
              .classes = spread({unit}, special_values()),
              .call = "umbrage_encode_msm(x0.x)"},
             [](const sample& s, float far) { return encode_msm(s.x[0].x, far); });
    auto moments = spread({both, unit, both, unit}, large_values());
    moments.push_back(windows(texel, {}));
    all.push_back({.primitive = &glsl::to_optimized_moments,
                   .classes = moments,
                   .twin = [](const sample& s) { return to_optimized_moments(s.x[0]); },
                   .call = "umbrage_to_optimized_moments(x0)"});
    all.push_back({.primitive = &glsl::from_optimized_moments,
                   .classes = spread({unit, unit, unit, unit}, large_values()),
                   .twin = [](const sample& s) { return from_optimized_moments(s.x[0]); },
                   .call = "umbrage_from_optimized_moments(x0)"});
    auto classes = all_kinds({both, unit, both, unit, unit}, values_of_moments(), {share, target});
    classes.push_back(windows(texel, {share, target}));
    all.push_back({.primitive = &glsl::bias_moments,
                   .classes = classes,
                   .twin = [](const sample& s) { return bias_moments(s.x[0], vec2(s.x[1].y, s.x[1].z)); },
                   .call = "umbrage_bias_moments(x0, vec2(x1.y, x1.z))"});
    const auto biased = [](float d, sample& s) { return bias_moments(encode_msm(d), vec2(s.x[1].y, s.x[1].z)); };
    all.push_back({.primitive = &glsl::moment_atoms,
                   .classes = {windows(biased, {share, target})},
                   .twin = [](const sample& s) { return moment_atoms(s.x[0], s.x[1].x * 2.0f - 1.0f - s.x[0].x); },
                   .call = "umbrage_moment_atoms(x0, x1.x * 2.0 - 1.0 - x0.x)"});
    add_both(
        all,
        {.primitive = &glsl::decode_msm,
         .classes = classes,
         .call = "vec4(umbrage_decode_msm(x0, x1.x, vec2(x1.y, x1.z)))"},
        [](const sample& s, float far) { return vec4(decode_msm(s.x[0], s.x[1].x, vec2(s.x[1].y, s.x[1].z), far)); });
}

}  // namespace parity
