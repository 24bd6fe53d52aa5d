// SPDX-License-Identifier: MIT
//
// Rows of an image to draw into. They are a copy where rows in place would contend for the cache.
//
//     band_buffer<> buffer;  // one per thread, for one band after the other
//     buffer.begin(image.rows(first, last));
//     for (const triangles& batch : ...) {
//         buffer.expect(batch);
//         draw<true>(buffer.rows(), first, batch);
//     }
//     buffer.finish();
//
// A column of texels takes one cache line per row. The usual L1 cache has 64 sets of 8 lines. All lines of the column
// belong to one set if rows start a multiple of 4096 bytes apart. Stores then wait for lines that the loads of later
// rows have evicted, and tall triangles take two to four times as long.
//
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include <umbrage/core/config.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/draw/raster/triangles.hpp>

namespace umbrage::detail {

template <class = on_use>
class band_buffer {
public:
    /// @param rows   rows that nobody else uses until finish()
    void begin(const image_view<float>& rows) {
        in_place_ = rows_ = rows;
        left_ = bounds_a_texel(rows) * rows.size.x * rows.size.y;
    }

    /// Rows at their present place.
    [[nodiscard]] const image_view<float>& rows() const { return rows_; }

    /// Prepares to draw a batch, after its set_up(). Copies the rows once the triangles so far make that worth the
    /// time.
    void expect(const triangles& batch) {
        if (left_ <= 0) return;
        for (int i = 0; i < batch.count; ++i) left_ -= std::int64_t(batch.rows[i]) * batch.columns[i];
        if (left_ > 0) return;
        constexpr std::size_t line = 64;
        const std::size_t lines =
            ((row_bytes() + line - 1) / line) | 1;  // odd, so 64 rows begin in 64 sets of the cache
        buffer_.resize(lines * line / sizeof(float) * std::size_t(rows_.size.y));
        rows_ = {buffer_.data(), in_place_.size, static_cast<std::ptrdiff_t>(lines * line)};
        copy(in_place_, rows_);
    }

    void finish() {
        if (rows_.data != in_place_.data) copy(rows_, in_place_);
    }

private:
    /// Break-even of copying: the mean number of triangles' bounds per texel at which contention costs as much time. It
    /// applies to rows in one set of the cache and, at less cost, in two. So the choice costs at most twice the best
    /// one. 0: rows do not contend. 8 rows never do.
    [[nodiscard]] static std::int64_t bounds_a_texel(const image_view<float>& rows) {
        if (rows.size.y <= 8) return 0;
        return rows.stride % 4096 == 0 ? 2 : rows.stride % 2048 == 0 ? 8 : 0;
    }

    [[nodiscard]] std::size_t row_bytes() const { return std::size_t(in_place_.size.x) * sizeof(float); }

    void copy(const image_view<float>& from, const image_view<float>& to) const {
        for (int y = 0; y < from.size.y; ++y) std::memcpy(to.row(y), from.row(y), row_bytes());
    }

    image_view<float> in_place_, rows_;
    std::int64_t left_ = 0;  // texels in bounds until the rows are copied
    std::vector<float, line_allocator<float>> buffer_;
};

}  // namespace umbrage::detail
