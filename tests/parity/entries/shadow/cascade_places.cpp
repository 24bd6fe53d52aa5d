// SPDX-License-Identifier: MIT
#include <umbrage/shadow/cascade_places.hpp>

#include <array>
#include <string>

#include "cascade_inputs.hpp"

namespace parity {

void add_shadow_cascade_places(std::vector<entry>& all) {
    using namespace umbrage;
    using namespace cascades;
    namespace glsl = umbrage::glsl;

    const auto add_place = [&](const glsl::snippet& s, std::uint32_t count, const std::string& call, const auto& twin) {
        add_places(all, s, numbered(count), call, [twin](const sample& x) { return std::array{twin(x)}; });
    };
    add_place(
        glsl::cascade_place, 4,
        "umbrage_cascade_place(vec3(x0.x, x0.y, x0.z), vec3(x2.w, x3.w, x4.w), vec4(x1.x, x1.y, 1.0, x1.y * 0.5), x3, "
        "x5.w, x0.w)",
        [](const sample& s) {
            return cascade_place(vec3(s.x[0]), normal_of(s), scales(s)[0], s.x[3], s.x[5].w, s.x[0].w);
        });
    add_place(glsl::cascaded_maps_place, 4,
              std::string("umbrage_cascaded_maps_place(") + turned + ", " + all_scales + ", " + all_offsets + ", " +
                  rest + ", vec3(x2.w, x3.w, x4.w), x5.w)",
              [](const sample& s) {
                  return cascaded_maps_place(axes, scales(s), offsets(s), anchor, blending_of(s), in_64(s),
                                             vec3(s.x[0]), normal_of(s), s.x[5].w);
              });
    add_place(glsl::cascaded_maps_place_8, 8,
              std::string("umbrage_cascaded_maps_place_8(") + turned + ", " + all_scales + ", " + all_offsets + ", " +
                  all_farther + ", " + other_offsets + ", " + rest + ", vec3(x2.w, x3.w, x4.w), x5.w)",
              [](const sample& s) {
                  return cascaded_maps_place_8(axes, scales(s), offsets(s), farther_scales(s), farther_offsets(s),
                                               anchor, blending_of(s), in_64(s), vec3(s.x[0]), normal_of(s), s.x[5].w);
              });
}

}  // namespace parity
