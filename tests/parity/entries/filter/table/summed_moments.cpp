// SPDX-License-Identifier: MIT
#include <umbrage/filter/table/summed_moments.hpp>
#include <umbrage/images/moment_table.hpp>

#include "../../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// Tables of random depths, some of them alike; of the largest some sums pass 2^24.
std::vector<texels> moment_tables(const moment_table& of) {
    random r(7);
    std::vector<texels> all;
    for (const ivec2 size : {ivec2(126, 90), ivec2(36, 20), ivec2(2, 1)}) {
        image<float> map(size);
        for (float& d : map.texels()) d = static_cast<float>(r.below(4) ? r.below(1025) : 700) / 1024.0f;
        const auto table = make_moment_table(map.view(), of);
        all.emplace_back(table.size());
        for (std::size_t i = 0; i < table.texels().size(); ++i) all.back().texels()[i] = vec4(table.texels()[i]);
    }
    return all;
}

/// As if the map went on to the left: something more in each row, modulo 2^32, which the sums over boxes do not see.
std::vector<texels> wrapped(std::vector<texels> tables) {
    random r(8);
    for (texels& table : tables)
        for (int y = 0; y < table.size().y; ++y)
            for (int c = 0; c < 4; ++c) {
                const int close = 65535 - r.below(4), any = r.below(65536);
                const auto more = static_cast<std::uint32_t>(r.below(2) ? close : any) * 65537u;
                const int half = table.size().x / 2;
                for (int x = 0; x < half; ++x) {
                    float &low = table[{x, y}][c], &high = table[{half + x, y}][c];
                    const std::uint32_t sum =
                        static_cast<std::uint32_t>(high) * 65536u + static_cast<std::uint32_t>(low) + more;
                    low = static_cast<float>(sum & 0xFFFF), high = static_cast<float>(sum >> 16);
                }
            }
    return tables;
}

/// x0.xy first, x0.zw the end of a box in the table.
input_class boxes() {
    return {"random", [](auto, random& r, sample& s) {
                const ivec2 size(s.map.size.x / 2 - 1, s.map.size.y - 1);
                for (int axis = 0; axis < 2; ++axis) {
                    const int first = r.below(size[axis]);
                    s.x[0][axis] = static_cast<float>(first);
                    s.x[0][axis + 2] = static_cast<float>(first + 1 + r.below(size[axis] - first));
                }
            }};
}

auto texels_of_table(const sample& s) {
    return [view = s.map](ivec2 at) { return texel(view, at); };
}

void add_summed_moments(std::vector<entry>& all, depth_direction direction, outside_map outside) {
    const float far = cleared_depth(direction);
    all.push_back({.primitive = &glsl::summed_moments,
                   .variant = std::string(outside == outside_map::clamped ? "" : "lit outside") +
                              (direction == depth_direction::forward ? ""
                               : outside == outside_map::clamped     ? "reversed"
                                                                     : ", reversed"),
                   .classes = receivers(),
                   .twin =
                       [far, outside](const sample& s) {
                           const vec4 x = s.x[0];
                           return vec4(summed_moments(texels_of_table(s), s.map.size, at(s), x.z,
                                                      x.w < 0.0f ? 0.0f : x.w, msm_bias_16, far, outside));
                       },
                   .call =
                       "vec4(umbrage_summed_moments(map, map_size, vec2(x0.x, x0.y), x0.z, x0.w < 0.0 ? 0.0 : x0.w, "
                       "vec2(0.00006, 0.628)))",
                   .maps = moment_tables({.radius = 9, .direction = direction}),
                   .map_kind = {.direction = direction, .outside = outside},
                   .alike = direction == depth_direction::reversed});
}

}  // namespace

void add_filter_table_summed_moments(std::vector<entry>& all) {
    all.push_back({.primitive = &glsl::box_mean,
                   .classes = {boxes()},
                   .twin =
                       [](const sample& s) {
                           const vec4 x = s.x[0];
                           return box_mean<float>(texels_of_table(s), s.map.size.x / 2, ivec2(x.x, x.y),
                                                  ivec2(x.z, x.w));
                       },
                   .call = "umbrage_box_mean(map, map_size, vec2(x0.x, x0.y), vec2(x0.z, x0.w))",
                   .maps = wrapped(moment_tables({.radius = 63}))});
    for (const auto outside : {outside_map::clamped, outside_map::bordered}) {
        add_summed_moments(all, depth_direction::forward, outside);
        add_summed_moments(all, depth_direction::reversed, outside);
    }
}

}  // namespace parity
