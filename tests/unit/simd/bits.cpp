// SPDX-License-Identifier: MIT
//
// Operations on bits against the same in floats, over numbers of every size, both zeros, infinities and NaNs.
//
#include <umbrage/simd/bits.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <umbrage/core/compare.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/core/texel_space.hpp>

using namespace umbrage::detail;

namespace {

std::vector<float> hostile_floats() {
    std::vector<float> values{0.0f,
                              std::numeric_limits<float>::infinity(),
                              std::numeric_limits<float>::quiet_NaN(),
                              std::numeric_limits<float>::denorm_min(),
                              std::numeric_limits<float>::max(),
                              32767.998f};
    for (float v = 0x1p-30f; v < 0x1p40f; v *= 2.0f)
        for (float w : {std::nextafter(v, 0.0f), v, std::nextafter(v, 0x1p60f), v * 1.25f}) values.push_back(w);
    for (std::size_t i = 0, count = values.size(); i < count; ++i) values.push_back(-values[i]);
    return values;
}

}  // namespace

TEST_CASE("bits: masks are those of the scalar functions") {
    for (float v : hostile_floats()) {
        CAPTURE(v);
        CHECK(number_mask(v) == (umbrage::is_nan(v) ? 0 : -1));
        CHECK(texel_space_mask(v, 0.0f) == (umbrage::inside_texel_space(glm::vec2(v, 0.0f)) ? -1 : 0));
        CHECK(texel_space_mask(0.0f, v) == (umbrage::inside_texel_space(glm::vec2(0.0f, v)) ? -1 : 0));
    }
}

TEST_CASE("bits: comparison, NaN on either side in shadow") {
    const auto values = hostile_floats();
    for (float receiver : values)
        for (float stored : values) {
            CAPTURE(receiver);
            CAPTURE(stored);
            CHECK((is_lit(receiver, stored) == 1) == umbrage::less_equal{}(receiver, stored));
        }
}

TEST_CASE("bits: floors") {
    for (float v : hostile_floats()) {
        CAPTURE(v);
        if (std::abs(v) < 0x1p31f) CHECK(floor_int(v) == static_cast<std::int32_t>(std::floor(v)));
        const std::int32_t within = floor_within(v, 1023.0f);
        if (umbrage::is_nan(v)) CHECK((within == 0 || within == 1023));
        else CHECK(static_cast<float>(within) == std::floor(std::fmin(std::fmax(v, 0.0f), 1023.0f)));
    }
    CHECK(clamp_int(-5, 7) == 0);
    CHECK(clamp_int(5, 7) == 5);
    CHECK(clamp_int(9, 7) == 7);
}

TEST_CASE("bits: order keys are in the order of the floats, NaN first, and lead back") {
    const auto values = hostile_floats();
    for (float a : values) {
        const std::int32_t key = order_key(a);
        if (umbrage::is_nan(a)) {
            CHECK(key == std::numeric_limits<std::int32_t>::min());
            CHECK(umbrage::is_nan(from_order_key(key)));
            continue;
        }
        CHECK(bit_cast<std::uint32_t>(from_order_key(key)) == bit_cast<std::uint32_t>(a));
        for (float b : values)
            if (a < b) CHECK(key < order_key(b));
    }
    CHECK(order_key(-0.0f) < order_key(0.0f));
}

TEST_CASE("bits: selection") {
    const float nan = std::numeric_limits<float>::quiet_NaN();
    CHECK(select(-1, 0.25f, nan) == 0.25f);
    CHECK(select(0, nan, 0.5f) == 0.5f);
    CHECK(masked(0.75f, -1) == 0.75f);
    CHECK(masked(nan, 0) == 0.0f);
}
