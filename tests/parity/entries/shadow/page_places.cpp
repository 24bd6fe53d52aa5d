// SPDX-License-Identifier: MIT
#include <umbrage/shadow/page_places.hpp>

#include <cmath>

#include "places.hpp"

namespace parity {
namespace {

/// A point around the root page in x0.xyz, at cells' borders too; its normal in x1.xyz; pages of every level in x2 to
/// x5, two cells a number.
std::vector<input_class> around_the_root() {
    auto kinds = large_values();
    kinds.push_back({"at a border", [](std::uint64_t i, random& r) {
                         const float border = 1.0f + static_cast<float>(r.below(17)) / 16.0f;
                         return i % 3 == 0 ? border : std::nextafter(border, i % 3 == 1 ? 0.0f : 9.0f);
                     }});
    auto classes = spread({{0.9375f, 2.0625f},
                           {0.9375f, 2.0625f},
                           {0.0f, 1.0f},
                           {0.0f, 1.0f},
                           {-1.0f, 1.0f},
                           {-1.0f, 1.0f},
                           {-1.0f, 1.0f}},
                          kinds);
    for (input_class& c : classes)
        c.fill = [fill = c.fill](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            const auto cell = [&] { return r.below(64) + 64 * ((1u << r.below(5)) - 1); };
            for (std::size_t k = 2; k < 6; ++k)
                for (glm::length_t j = 0; j < 4; ++j) {
                    const auto first = cell();
                    s.x[k][j] = static_cast<float>(first + 1024 * cell());
                }
        };
    return classes;
}

}  // namespace

void add_shadow_page_places(std::vector<entry>& all) {
    const std::string a = "mat4(x2, x3, x4, x5)", b = "mat4(x3, x4, x5, x2)", c = "mat4(x4, x5, x2, x3)",
                      d = "mat4(x5, x2, x3, x4)";
    std::string cells;
    for (const std::string& eight : {a, b, c, d, b, c, d, a}) cells += eight + ", ";
    // No component is 0, of which a compiler makes 0 whatever it is multiplied with.
    const std::string matrix =
        "mat4(vec4(1.0, 0.015625, 0.0625, 1.0), vec4(0.015625, 1.0, 0.0625, 1.0), "
        "vec4(0.03125, 0.03125, 1.0, 1.0), vec4(-0.03125, -0.03125, 0.125, 1.0))";
    const std::string planes =
        "mat4(vec4(x1.x, x1.y, x0.z, x1.z), vec4(x0.w, x1.z, x1.x, x0.z), "
        "vec4(x1.y, x0.w, x1.z, x1.x), vec4(x0.z, x1.x, x0.w, x1.y))";
    add_places(all, umbrage::glsl::adaptive_maps_places, around_the_root(),
               "umbrage_adaptive_maps_places(" + matrix + ", " + planes + ", " + cells +
                   "vec4(0.03125, -0.0625, 0.015625, 0.0), vec4(64.0, 8.0, 0.0, 0.0), vec4(0.5, 0.25, 0.125, 0.0625), "
                   "vec4(80.0, 80.0, 2.0, 0.0), "
                   "vec3(x0.x, x0.y, x0.z), "
                   "vec3(x1.x, x1.y, x1.z))",
               [](const sample& s) {
                   std::array<glm::mat4, 8> eight;
                   for (std::size_t i = 0; i < 8; ++i)
                       for (std::size_t k = 0; k < 4; ++k)
                           eight[i][static_cast<glm::length_t>(k)] = s.x[2 + (i + k + (i < 4 ? 0 : 1)) % 4];
                   const glm::mat4 m(vec4(1, 0.015625f, 0.0625f, 1), vec4(0.015625f, 1, 0.0625f, 1),
                                     vec4(0.03125f, 0.03125f, 1, 1), vec4(-0.03125f, -0.03125f, 0.125f, 1));
                   const vec4 &x0 = s.x[0], &x1 = s.x[1];
                   const glm::mat4 of_planes(vec4(x1.x, x1.y, x0.z, x1.z), vec4(x0.w, x1.z, x1.x, x0.z),
                                             vec4(x1.y, x0.w, x1.z, x1.x), vec4(x0.z, x1.x, x0.w, x1.y));
                   return umbrage::adaptive_maps_places(
                       m, of_planes, eight, vec4(0.03125f, -0.0625f, 0.015625f, 0.0f), vec4(64.0f, 8.0f, 0.0f, 0.0f),
                       vec4(0.5f, 0.25f, 0.125f, 0.0625f), {}, vec3(s.x[0]), vec3(s.x[1]));
               });
}

}  // namespace parity
