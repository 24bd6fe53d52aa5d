// SPDX-License-Identifier: MIT
//
// Blocks of 64 receivers, from any source: x(i), y(i) in texels, z(i) depth.
//
//     receiver_room room;
//     blocks.place(block_at(receivers, walk, room, set), placed);
//
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/config.hpp>
#include <umbrage/images/receivers.hpp>
#include <umbrage/simd/bits.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/memory.hpp>

namespace umbrage::detail {

/// Block of receivers as in an image, one after the other. Read by element: GCC does not vectorize whole vec3s.
struct receiver_texels {
    const glm::vec3* first;
    [[nodiscard]] UMBRAGE_INLINE float x(int i) const { return first[i].x; }
    [[nodiscard]] UMBRAGE_INLINE float y(int i) const { return first[i].y; }
    [[nodiscard]] UMBRAGE_INLINE float z(int i) const { return first[i].z; }
};

/// Block of receivers in three planes.
struct receiver_rows {
    const float *first_x, *first_y, *first_z;
    [[nodiscard]] UMBRAGE_INLINE float x(int i) const { return first_x[i]; }
    [[nodiscard]] UMBRAGE_INLINE float y(int i) const { return first_y[i]; }
    [[nodiscard]] UMBRAGE_INLINE float z(int i) const { return first_z[i]; }
};

/// Block of receivers with their planes.
struct sloped_rows : receiver_rows {
    const float *first_slope_x, *first_slope_y;
    [[nodiscard]] UMBRAGE_INLINE float slope_x(int i) const { return first_slope_x[i]; }
    [[nodiscard]] UMBRAGE_INLINE float slope_y(int i) const { return first_slope_y[i]; }
};

/// Block of receivers in its own memory.
struct receiver_block {
    alignas(64) float xs[block]{}, ys[block]{}, zs[block]{};
    [[nodiscard]] UMBRAGE_INLINE float x(int i) const { return xs[i]; }
    [[nodiscard]] UMBRAGE_INLINE float y(int i) const { return ys[i]; }
    [[nodiscard]] UMBRAGE_INLINE float z(int i) const { return zs[i]; }
    UMBRAGE_INLINE void set(int i, float x_at, float y_at, float depth) {
        xs[i] = x_at;
        ys[i] = y_at;
        zs[i] = depth;
    }
    template <class Receivers>
    UMBRAGE_INLINE void copy(const Receivers& from) {
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i) set(i, from.x(i), from.y(i), from.z(i));
    }
};

/// Test for blocks whose receivers are all in a rectangle of the map.
class receiver_rectangle {
public:
    receiver_rectangle(glm::vec2 low, glm::vec2 high) {
        constexpr float greatest = (std::numeric_limits<float>::max)();
        for (int i = 0; i < period; ++i) {
            low_[i] = i % 3 == 0 ? low.x : i % 3 == 1 ? low.y : -greatest;
            high_[i] = i % 3 == 0 ? high.x : i % 3 == 1 ? high.y : greatest;
        }
    }

    template <class Receivers>
    [[nodiscard]] UMBRAGE_INLINE bool holds(const Receivers& r) const {
        std::int32_t inside = 1;
        for (int i = 0; i < block; ++i)
            inside &= std::int32_t(r.x(i) >= low_[0]) & std::int32_t(r.x(i) <= high_[0]) &
                      std::int32_t(r.y(i) >= low_[1]) & std::int32_t(r.y(i) <= high_[1]);
        return inside != 0;
    }
    /// Tests values in memory order, depths included: separating them costs as much as a whole hard test. The result
    /// may be false where a depth is not finite.
    [[nodiscard]] UMBRAGE_INLINE bool holds(const receiver_texels& r) const {
        const auto* const values = reinterpret_cast<const float*>(r.first);
        std::int32_t inside = 1;
        for (int first = 0; first < 3 * block; first += period)
            for (int i = 0; i < period; ++i)
                inside &= std::int32_t(values[first + i] >= low_[i]) & std::int32_t(values[first + i] <= high_[i]);
        return inside != 0;
    }

private:
    static constexpr int period = 48;  // a multiple of three values and of sixteen lanes
    alignas(64) float low_[period], high_[period];
};

/// Walk over the blocks of some rows: tile by tile, each of `rows` rows, from the first row up to `last`.
struct block_walk {
    int x, y, width;
    int rows = 1, last = 0;  ///< not needed by a walk of one row of blocks after the other
    int first = y;           ///< first row of the tile

    [[nodiscard]] UMBRAGE_INLINE int count() const { return width - x < block ? width - x : block; }
    [[nodiscard]] UMBRAGE_INLINE bool ends_tile() const { return y + 1 == first + rows || y + 1 == last; }
    UMBRAGE_INLINE void step() {
        if (!ends_tile()) ++y;
        else if (x += block; x < width) y = first;
        else x = 0, first = ++y;
    }
};

/// Memory for a block of receivers that cannot be read in place.
struct receiver_room {
    alignas(64) float rows[5][block];  ///< x, y, depth, and for planes their slopes
    alignas(64) glm::vec3 texels[block];
};

/// Block of `count` values: a full one in place, a shorter one copied to `room`. Zeros fill the copy, and reach no
/// result.
template <class T>
[[nodiscard]] UMBRAGE_INLINE inline const T* whole_block(const T* from, int count, T* room) {
    if (count == block) return from;
    std::fill(std::copy_n(from, count, room), room + block, T(0));
    return room;
}

/// Block of receivers as values that are valid as long as `room` is.
template <isa Set>
[[nodiscard]] UMBRAGE_INLINE inline auto block_at(const image_view<const glm::vec3>& from, const block_walk& at,
                                                  receiver_room& room, isa_constant<Set>) {
    const receiver_texels texels{whole_block(from.row(at.y) + at.x, at.count(), room.texels)};
    if constexpr (Set == isa::base) {  // for SSE, GCC separates vec3s only in a loop that does nothing else
        UMBRAGE_NO_OVERLAP
        for (int i = 0; i < block; ++i)
            room.rows[0][i] = texels.x(i), room.rows[1][i] = texels.y(i), room.rows[2][i] = texels.z(i);
        return receiver_rows{room.rows[0], room.rows[1], room.rows[2]};
    } else return texels;
}
template <isa Set>
[[nodiscard]] UMBRAGE_INLINE inline receiver_rows block_at(const receiver_planes& from, const block_walk& at,
                                                           receiver_room& room, isa_constant<Set>) {
    return {whole_block(from.x.row(at.y) + at.x, at.count(), room.rows[0]),
            whole_block(from.y.row(at.y) + at.x, at.count(), room.rows[1]),
            whole_block(from.depth.row(at.y) + at.x, at.count(), room.rows[2])};
}
template <isa Set>
[[nodiscard]] UMBRAGE_INLINE inline sloped_rows block_at(const sloped_receivers& from, const block_walk& at,
                                                         receiver_room& room, isa_constant<Set> set) {
    return {block_at(from.at, at, room, set), whole_block(from.slope_x.row(at.y) + at.x, at.count(), room.rows[3]),
            whole_block(from.slope_y.row(at.y) + at.x, at.count(), room.rows[4])};
}

/// receiver_at for a block.
template <class = on_use>
inline void load(const depth_receivers& seen, const block_walk& at, receiver_room& room) {
    if (at.count() < block) std::memset(room.rows[2], 0, sizeof room.rows[2]);
    copy_floats(room.rows[2], seen.depth.row(at.y) + at.x, at.count());
    on_best_isa_without_fma([&](auto) UMBRAGE_INLINE {
        const glm::mat4 m = seen.matrix;
        const float bias = seen.bias;
        const float y = static_cast<float>(at.y) + 0.5f;
        for (int i = 0; i < block; ++i) {
            const float x = static_cast<float>(at.x + i) + 0.5f, depth = room.rows[2][i];
            const auto sum = [&](glm::length_t k)
                                 UMBRAGE_INLINE { return m[3][k] + m[0][k] * x + m[1][k] * y + m[2][k] * depth; };
            const float w = sum(3);
            const auto bits = detail::bit_cast<std::int32_t>(w);
            const std::int32_t in_front = -(std::int32_t(bits > 0) & std::int32_t(bits <= 0x7F800000));
            room.rows[0][i] = select(in_front, sum(0) / w, 65536.0f);
            room.rows[1][i] = select(in_front, sum(1) / w, 65536.0f);
            room.rows[2][i] = masked(sum(2) / w, in_front) - bias;
        }
    });
}
template <isa Set>
[[nodiscard]] UMBRAGE_INLINE inline receiver_rows block_at(const depth_receivers& seen, const block_walk& at,
                                                           receiver_room& room, isa_constant<Set>) {
    load(seen, at, room);
    return {room.rows[0], room.rows[1], room.rows[2]};
}

/// Prefetches the receivers some blocks ahead, or of the next tile. Hardware prefetching stops at the end of a memory
/// page.
template <class T>
UMBRAGE_INLINE inline void prefetch(const image_view<const T>& from, const block_walk& at) {
    const int bytes = block * static_cast<int>(sizeof(T)), blocks = at.rows == 1 ? 4 : 1;
    prefetch_bytes(from.row(at.y) + at.x, blocks * bytes, bytes);
}
UMBRAGE_INLINE inline void prefetch(const receiver_planes& from, const block_walk& at) {
    for (const auto* plane : {&from.x, &from.y, &from.depth}) prefetch(*plane, at);
}
UMBRAGE_INLINE inline void prefetch(const sloped_receivers& from, const block_walk& at) {
    prefetch(from.at, at);
    for (const auto* slope : {&from.slope_x, &from.slope_y}) prefetch(*slope, at);
}
UMBRAGE_INLINE inline void prefetch(const depth_receivers& from, const block_walk& at) { prefetch(from.depth, at); }

}  // namespace umbrage::detail
