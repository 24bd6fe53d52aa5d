// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/hausdorff.hpp>

#include "windows.hpp"

namespace parity {

void add_filter_prefiltered_hausdorff(std::vector<entry>& all) {
    using namespace umbrage;
    const range unit{}, both{-1.0f, 1.0f}, share{1e-6f, 1e-3f}, target{0.375f, 0.628f};
    const auto biased = [](float d, sample& s) { return bias_moments(encode_msm(d), vec2(s.x[1].y, s.x[1].z)); };
    input_class on_both = windows(biased, {share, target});
    on_both.fill = [fill = on_both.fill](std::uint64_t i, random& r, sample& s) {
        fill(i, r, s);
        s.x[1].x = s.x[1].x * 2.0f - 1.0f;
    };
    const input_class of_no_depths{"of no depths", [](auto, random& r, sample& s) {
                                       for (int c = 0; c < 4; ++c) s.x[0][c] = r.between(-1.0f, 1.0f);
                                       s.x[1].x = static_cast<float>(r.below(257)) / 128.0f - 1.0f;
                                   }};
    all.push_back({.primitive = &glsl::hausdorff_share,
                   .classes = {on_both, of_no_depths},
                   .twin = [](const sample& s) { return vec4(hausdorff_share(s.x[0], s.x[1].x)); },
                   .call = "vec4(umbrage_hausdorff_share(x0, x1.x))"});
    auto classes = all_kinds({both, unit, both, unit, unit}, values_of_moments(), {share, target});
    classes.push_back(windows([](float d, sample&) { return encode_msm(d); }, {share, target}));
    add_both(all,
             {.primitive = &glsl::decode_msm_hausdorff,
              .classes = classes,
              .call = "vec4(umbrage_decode_msm_hausdorff(x0, x1.x, vec2(x1.y, x1.z)))"},
             [](const sample& s, float far) {
                 return vec4(decode_msm_hausdorff(s.x[0], s.x[1].x, vec2(s.x[1].y, s.x[1].z), far));
             });
}

}  // namespace parity
