// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/rasterizer.hpp>

#include "../light/clip_spaces.hpp"
#include "../special_values.hpp"

using namespace umbrage;

namespace {

/// The bias as Vulkan's specification has it, which OpenGL and Direct3D follow.
/// @param greatest_z   of the primitive, for buffers of floats
double rasterized(vulkan_depth_bias b, depth_format format, glm::vec2 slope, double greatest_z) {
    const double m = std::max(std::abs(double(slope.x)), std::abs(double(slope.y)));
    const double r = format == depth_format::unorm16   ? 0x1p-16
                     : format == depth_format::unorm24 ? 0x1p-24
                                                       : std::exp2(std::floor(std::log2(greatest_z)) - 23);
    const double sum = m * double(b.slope_factor) + r * double(b.constant_factor);
    return b.clamp > 0 ? std::min(sum, double(b.clamp)) : b.clamp < 0 ? std::max(sum, double(b.clamp)) : sum;
}

}  // namespace

TEST_CASE("make_polygon_offset, make_vulkan_depth_bias, make_direct3d_depth_bias: by hand") {
    const auto gl = make_polygon_offset({.reach = 1.5f, .constant = 0x1p-20f, .greatest = 0.25f});
    CHECK(gl.factor == 3);
    CHECK(gl.units == 16);
    CHECK(gl.clamp == 0.25f);
    const auto vulkan =
        make_vulkan_depth_bias({.reach = 1.5f, .constant = 0x1.8p-16f, .format = depth_format::unorm16});
    CHECK(vulkan.constant_factor == 2);  // rounded up
    CHECK(vulkan.clamp == 0);
    CHECK(vulkan.slope_factor == 3);
    const auto d3d = make_direct3d_depth_bias(
        {.reach = 2, .constant = 0x1p-20f, .format = depth_format::float32, .direction = depth_direction::reversed});
    CHECK(d3d.depth_bias == -16);  // a step of depths in [1/2, 1)
    CHECK(d3d.depth_bias_clamp == 0);
    CHECK(d3d.slope_scaled_depth_bias == -4);
    CHECK(make_direct3d_depth_bias({.constant = 0x1p-20f, .least_depth = 0.2f, .format = depth_format::float32})
              .depth_bias == 64);
}

TEST_CASE("rasterizers' biases: as specified, they are at least acne_free_bias") {
    std::mt19937 random(8);
    std::uniform_real_distribution<float> steep(-0.01f, 0.01f), depth(0.25f, 1.0f);
    for (const auto format : {depth_format::unorm16, depth_format::unorm24, depth_format::float32})
        for (const auto direction : {depth_direction::forward, depth_direction::reversed})
            for (const float reach : {0.5f, 1.0f, 3.5f}) {
                const float error = 0x1p-11f;
                const raster_bias what{.reach = reach,
                                       .constant = error + 0x1p-23f,
                                       .least_depth = 0.25f,
                                       .format = format,
                                       .direction = direction};
                const auto vulkan = make_vulkan_depth_bias(what);
                const auto gl = make_polygon_offset(what);
                const auto d3d = make_direct3d_depth_bias(what);
                CHECK(gl.factor == vulkan.slope_factor);
                CHECK(gl.units == vulkan.constant_factor);
                CHECK(static_cast<float>(d3d.depth_bias) == vulkan.constant_factor);
                CHECK(d3d.slope_scaled_depth_bias == vulkan.slope_factor);
                const double away = direction == depth_direction::forward ? 1 : -1;
                double least = 1, greatest = 0;
                for (int i = 0; i < 5000; ++i) {
                    const glm::vec2 slope(steep(random), steep(random));
                    const double over = away * rasterized(vulkan, format, slope, double(depth(random))) -
                                        double(acne_free_bias(slope, reach, error));
                    least = std::min(least, over);
                    greatest = std::max(greatest, over);
                }
                CHECK(least > -0x1p-26);
                CHECK(greatest < 0.0101 * double(reach) + 4 * 0x1p-11);
            }
}

TEST_CASE("rasterizers' biases: what is refused") {
    const auto said = [](const raster_bias& bias) {
        return complaint([&] { static_cast<void>(make_polygon_offset(bias)); });
    };
    CHECK(said({}).empty());
    CHECK(said({.reach = 0, .constant = 0}).empty());
    for (float bad : {-1.0f, nan32, inf32}) {
        const std::string got = umbrage::detail::printed(bad);
        CHECK(said({.reach = bad}) == "umbrage::make_polygon_offset: reach must be finite, 0 or more; got " + got);
        CHECK(said({.constant = bad}) ==
              "umbrage::make_polygon_offset: constant must be finite, 0 or more; got " + got);
        CHECK(said({.greatest = bad}) ==
              "umbrage::make_polygon_offset: greatest must be finite, 0 or more; got " + got);
        CHECK(said({.least_depth = bad}) ==
              "umbrage::make_polygon_offset: least_depth must be above 0, no denormal, and at most 1; got " + got);
    }
    CHECK(!said({.least_depth = 0}).empty());
    CHECK(!said({.least_depth = 1e-40f}).empty());
    CHECK(!said({.reach = 3e38f}).empty());
    CHECK(!said({.constant = 1, .least_depth = 1e-37f, .format = depth_format::float32}).empty());
    CHECK(complaint([] { static_cast<void>(make_vulkan_depth_bias({.reach = -1})); }) ==
          "umbrage::make_vulkan_depth_bias: reach must be finite, 0 or more; got -1");
    CHECK(
        complaint([] { static_cast<void>(make_direct3d_depth_bias({.constant = 200})); }) ==
        "umbrage::make_direct3d_depth_bias: constant and least_depth must be below 2^31 steps of the depth buffer; got "
        "3.35544e+09");
}
