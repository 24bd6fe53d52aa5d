// SPDX-License-Identifier: MIT
//
// Lower bound of a kernel's cost: finds and loads its texels, one row of a receiver at a time. It compares and weights
// nothing. It sums the texels, as compilers would otherwise remove the loads.
#pragma once

#include <umbrage/images/visibility.hpp>

namespace bench {

struct window_loads : umbrage::detail::window_blocks<umbrage::depth_direction::forward> {
    template <class Isa>
    UMBRAGE_INLINE void operator()(const placed& at, int count, float* sums, Isa) const {
        if (row.touched() <= 4) load_rows<4>(at, count, sums);
        else load_rows<Isa::value == umbrage::detail::isa::base ? 4 : 8>(at, count, sums);
    }

private:
    template <int Lanes>
    UMBRAGE_INLINE void load_rows(const placed& at, int count, float* sums) const {
        const umbrage::detail::texel_bytes memory(map);
        const int touched = row.touched();
        for (int i = 0; i < count; ++i) {
            umbrage::detail::lanes_of<float, Lanes> sum{}, texels;
            for (int first = 0; first < loaded(); first += Lanes) {
                const std::byte* from = memory.data + at.offsets[i] + std::size_t(first) * sizeof(float);
                for (int j = 0; j < touched; ++j, from += memory.stride) {
                    umbrage::detail::load_lanes(from, texels);
                    sum += texels;
                }
            }
            sums[i] = sum[0];
        }
    }
};

/// @param map   at least as large as the window
inline void load_windows(umbrage::image_view<const float> map, umbrage::image_view<const glm::vec3> receivers,
                         const umbrage::window_row& row, umbrage::image_view<float> sums) {
    const umbrage::detail::window_table weights(row);
    const auto never = [](glm::vec2, float, glm::ivec2) { return 0.0f; };
    const umbrage::detail::map_edge edge(never, 0.0f, map.size, false, false);
    umbrage::detail::filter_rows(receivers, window_loads{{map, row, weights}}, edge, sums, 0, sums.size.y);
}

}  // namespace bench
