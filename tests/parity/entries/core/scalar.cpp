// SPDX-License-Identifier: MIT
#include <umbrage/core/scalar.hpp>

#include "../entries.hpp"

namespace parity {

void add_core_scalar(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    for (const float far : {1.0f, 0.0f})
        all.push_back(
            {.primitive = &glsl::saturate,
             .variant = far == 1.0f ? "" : "reversed",
             .classes = spread({{-1.0f, 2.0f}, {-1.0f, 2.0f}, {0.0f, 1.0f}, {0.0f, 1.0f}}, depth_values()),
             .twin =
                 [far](const sample& s) {
                     const vec4 v = s.x[0];
                     return vec4(saturate(v.x, far), saturate(v.y, far), saturate(v.z, far), saturate(v.w, far));
                 },
             .call =
                 "vec4(umbrage_saturate(x0.x), umbrage_saturate(x0.y), umbrage_saturate(x0.z), umbrage_saturate(x0.w))",
             .map_kind = {.direction = far == 1.0f ? depth_direction::forward : depth_direction::reversed}});
}

}  // namespace parity
