// SPDX-License-Identifier: MIT
//
// Target for batches of triangles: a depth image, or bands of it, each drawn by one thread.
//
//     const depth_target<true> target(depth);
//     target(batch);
//     depth_target<true> own = target;  // one per thread
//     own.in_band({first, last}, [&](const auto& draw) { draw(batch); });
//
#pragma once

#include <glm/vec2.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/draw/raster/band_buffer.hpp>
#include <umbrage/draw/raster/depth_writer.hpp>
#include <umbrage/draw/raster/triangles.hpp>

namespace umbrage::detail {

template <bool Forward>
class depth_target {
public:
    /// @param image   row 0 at the bottom
    explicit depth_target(image_view<float> image) : image_(image) {}

    void operator()(const triangles& batch) const { draw<Forward>(image_, 0, batch); }

    /// Draws batches into a band of rows.
    /// @param rows   first <= y < second, at least one row, to which nobody else draws meanwhile
    /// @param use    (draw), which calls draw(const triangles&) for batches within these rows
    template <class Use>
    void in_band(const glm::ivec2& rows, const Use& use) {
        buffer_.begin(image_.rows(rows.x, rows.y));
        use([&](const triangles& batch) {
            buffer_.expect(batch);
            draw<Forward>(buffer_.rows(), rows.x, batch);
        });
        buffer_.finish();
    }

private:
    image_view<float> image_;
    band_buffer<> buffer_;
};

}  // namespace umbrage::detail
