// SPDX-License-Identifier: MIT
#include <umbrage/filter/table/summed_variance.hpp>
#include <umbrage/images/variance_table.hpp>

#include "../../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// Tables of random depths from `near` on, some of them alike; the largest has wrapped.
std::vector<texels> variance_tables(const variance_table& of, float near) {
    random r(7);
    std::vector<texels> all;
    for (const ivec2 size : {ivec2(126, 90), ivec2(36, 20), ivec2(2, 1)}) {
        image<float> map(size);
        for (float& d : map.texels())
            d = near + (1.0f - near) * static_cast<float>(r.below(4) ? r.below(1025) : 700) / 1024.0f;
        const auto table = make_variance_table(map.view(), of);
        all.emplace_back(table.size());
        for (std::size_t i = 0; i < table.texels().size(); ++i) all.back().texels()[i] = vec4(table.texels()[i]);
    }
    return all;
}

/// x0.xy first, x0.zw the end of a box in the table, of up to 33 x 33 texels: the sums of many squares pass 2^32.
std::vector<input_class> boxes_in_tables() {
    return {{"random", [](auto, random& r, sample& s) {
                 for (int axis = 0; axis < 2; ++axis) {
                     const int size = s.map.size[axis] - 1, first = r.below(size), most = size - first;
                     s.x[0][axis] = static_cast<float>(first);
                     s.x[0][axis + 2] = static_cast<float>(first + 1 + r.below(most < 33 ? most : 33));
                 }
             }}};
}

auto table_of(const sample& s) {
    return [view = s.map](ivec2 at) { return texel(view, at); };
}

template <class Compare>
void add_summed_variance(std::vector<entry>& all, Compare is_lit, depth_direction direction, outside_map outside) {
    entry e{.primitive = &glsl::summed_variance,
            .variant = std::string(outside == outside_map::clamped ? "" : "lit outside") +
                       (direction == depth_direction::forward ? ""
                        : outside == outside_map::clamped     ? "reversed"
                                                              : ", reversed"),
            .classes = receivers(),
            .twin =
                [is_lit, outside](const sample& s) {
                    const vec4 x = s.x[0];
                    return vec4(summed_variance(table_of(s), s.map.size - 1, at(s), x.z, x.w < 0.0f ? 0.0f : x.w,
                                                1024.0f, is_lit, outside));
                },
            .call =
                "vec4(umbrage_summed_variance(map, map_size, vec2(x0.x, x0.y), x0.z, x0.w < 0.0 ? 0.0 : x0.w, "
                "1024.0))",
            .maps = variance_tables({.bits = 10, .radius = 9, .direction = direction}, 0.0f),
            .map_kind = {.direction = direction, .outside = outside},
            .alike = direction == depth_direction::reversed};
    all.push_back(std::move(e));
}

}  // namespace

void add_filter_table_summed_variance(std::vector<entry>& all) {
    all.push_back({.primitive = &glsl::box_moments,
                   .classes = boxes_in_tables(),
                   .twin =
                       [](const sample& s) {
                           const vec4 x = s.x[0];
                           return box_moments<float>(table_of(s), ivec2(x.x, x.y), ivec2(x.z, x.w));
                       },
                   .call = "umbrage_box_moments(map, map_size, vec2(x0.x, x0.y), vec2(x0.z, x0.w))",
                   .maps = variance_tables({.bits = 12, .radius = 16}, 0.75f)});
    for (const auto outside : {outside_map::clamped, outside_map::bordered}) {
        add_summed_variance(all, less_equal{}, depth_direction::forward, outside);
        add_summed_variance(all, greater_equal{}, depth_direction::reversed, outside);
    }
}

}  // namespace parity
