// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <vector>

#include <umbrage/draw/raster/band_buffer.hpp>

using namespace umbrage;

namespace {

constexpr glm::ivec2 band_size(1000, 20);

/// Texels of any bits, NaNs among them.
std::vector<float> floats_of_any_bits(int count) {
    std::vector<float> floats;
    for (int i = 0; i < count; ++i) floats.push_back(std::bit_cast<float>(0x7FFFF000u + unsigned(i)));
    return floats;
}

bool same_floats(const std::vector<float>& a, const std::vector<float>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](float x, float y) { return std::bit_cast<unsigned>(x) == std::bit_cast<unsigned>(y); });
}

/// Bounds of two triangles, of which one covers nothing.
detail::triangles bounds_of(int columns, int rows) {
    detail::triangles batch;
    batch.count = 2;
    batch.columns[0] = columns, batch.rows[0] = rows;
    batch.columns[1] = -5, batch.rows[1] = 0;
    return batch;
}

}  // namespace

TEST_CASE("band_buffer: rows that contend move when enough is drawn, and come back with what was drawn") {
    for (const int stride : {1024, 1536}) {
        std::vector<float> memory = floats_of_any_bits(stride * band_size.y), expected = memory;
        const image_view<float> image(memory.data(), band_size, stride * 4);
        const int times = stride == 1024 ? 2 : 8;
        const detail::triangles most = bounds_of(band_size.x, band_size.y * times - 1),
                                last = bounds_of(band_size.x, 1);
        detail::band_buffer<> buffer;
        const auto move = [&](const image_view<float>& rows) {
            buffer.begin(rows);
            buffer.expect(most);
            buffer.expect(last);
            return buffer.rows();
        };
        for (const float drawn : {0.25f, 0.5f}) {
            buffer.begin(image);
            buffer.expect(most);
            CHECK(buffer.rows().data == image.data);
            buffer.expect(last);
            const image_view<float> rows = buffer.rows();
            CHECK(rows.data != image.data);
            CHECK(rows.size == band_size);
            CHECK(rows.stride % 128 == 64);
            buffer.expect(most);
            CHECK(buffer.rows().data == rows.data);
            rows[{3, 7}] = rows[{999, 19}] = drawn;
            CHECK(same_floats(memory, expected));
            const std::size_t beside = std::size_t(7 * stride + band_size.x);  // somebody else's, who goes on with it
            memory[beside] = expected[beside] = drawn;
            buffer.finish();
            expected[std::size_t(7 * stride + 3)] = expected[std::size_t(19 * stride + 999)] = drawn;
            CHECK(same_floats(memory, expected));
        }
        const image_view<float> fewer = move(image.rows(4, 19));
        CHECK(fewer.size.y == 15);
        CHECK(fewer.data != image.row(4));
        CHECK(fewer[{3, 3}] == 0.5f);
        buffer.finish();
        CHECK(same_floats(memory, expected));

        const image_view<float> bottom_up = move({image.row(19), band_size, -image.stride});
        CHECK(bottom_up.data != image.row(19));
        CHECK(bottom_up[{3, 12}] == 0.5f);
        buffer.finish();
        CHECK(same_floats(memory, expected));
    }
}

TEST_CASE("band_buffer: rows that do not contend stay where they are") {
    std::vector<float> memory(1040 * 20);
    detail::band_buffer<> buffer;
    for (const auto& rows : {image_view<float>(memory.data(), band_size),
                             {memory.data(), band_size, 1040 * 4},
                             {memory.data(), {1024, 8}}}) {  // no more than a set of the cache has lines
        buffer.begin(rows);
        buffer.expect(bounds_of(16384, 16384));
        CHECK(buffer.rows().data == memory.data());
        buffer.finish();
    }
}
