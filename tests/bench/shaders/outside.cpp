// SPDX-License-Identifier: MIT
//
// Cost of counting texels outside the map as the far plane: each filter clamped, and bordered.
#include "jobs.hpp"

#include <utility>

#include <umbrage/filter/blocker/pcss.hpp>
#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/filter/pcf/disc_hardware.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/filter/pcf/pcf_2x2_hardware.hpp>
#include <umbrage/filter/pcf/windows.hpp>
#include <umbrage/filter/prefiltered/look_up.hpp>

namespace bench {

job outside() {
    namespace glsl = umbrage::glsl;
    job all{"outside the map", {}};
    // Written out tap by tap.
    const std::string unrolled = "#extension GL_EXT_control_flow_attributes : require\n#define for [[unroll]] for\n";
    const auto add = [&](const glsl::snippet& of, const std::string& arguments = "", glsl::binding map = {}) {
        for (const auto& [outside, name] : {std::pair(umbrage::outside_map::clamped, ", clamped"),
                                            std::pair(umbrage::outside_map::bordered, ", bordered")}) {
            map.outside = outside;
            const bool compares = map.texture == glsl::texture::shadow;
            const std::string kind =
                std::string(compares ? ", comparison sampler" : "") + (map.gather ? ", gathered" : "");
            all.shaders.push_back({"umbrage",
                                   std::string(of.name) + kind + name,
                                   unrolled,
                                   {bind(of, "bound", map), glsl::disc_rotation},
                                   "vec4(umbrage_" + std::string(of.name) + "_bound(" +
                                       (compares ? "depth_map" : "map") + ", map_size, x1.xy, x1.z" + arguments +
                                       "))"});
        }
    };
    const std::string turn = ", umbrage_disc_rotation(gl_FragCoord.xy)";
    add(glsl::hard);
    add(glsl::pcf_2x2);
    add(glsl::tent<3>);
    add(glsl::castano<5>);
    add(glsl::box, ", 2");
    add(glsl::disc<16>, ", 3.0" + turn);
    add(glsl::pcss<16>, ", vec4(0.0625, 0.0625, 16.0, 96.0)" + turn);
    add(glsl::vsm, ", 0.000001");
    add(glsl::pcf_2x2, "", {.gather = true});
    add(glsl::castano<5>, "", {.gather = true});
    add(glsl::pcf_2x2, "", {.texture = glsl::texture::shadow, .gather = true});
    add(glsl::pcf_2x2_hardware, "", {.texture = glsl::texture::shadow});
    add(glsl::disc_hardware<16>, ", 3.0" + turn, {.texture = glsl::texture::shadow});
    return all;
}

}  // namespace bench
