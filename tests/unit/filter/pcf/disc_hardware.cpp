// SPDX-License-Identifier: MIT
#include <umbrage/filter/pcf/disc_hardware.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include <umbrage/shader/glsl.hpp>

#include "../../special_values.hpp"
#include "../real_discs.hpp"

using namespace umbrage;

namespace {

template <int Points>
void check_against_real_numbers() {
    std::mt19937 random(11);
    image<float> map({24, 20}, 0.0f);
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 24; ++x) map[{x, y}] = static_cast<float>(random() % 17) / 16.0f;
    double worst = 0;
    for (int i = 0; i < 4000; ++i) {
        const glm::vec2 coord(static_cast<float>(random() % 8192) / 256.0f - 4.0f,
                              static_cast<float>(random() % 8192) / 256.0f - 6.0f);
        const float wide = static_cast<float>(random() % 256) / 32.0f,
                    high = static_cast<float>(random() % 256) / 32.0f,
                    receiver = static_cast<float>(random() % 33) / 32.0f;
        const glm::vec4 rotation = disc_rotation(glm::vec2(float(i % 4), float(i / 4 % 4)));
        const auto try_one = [&](float ours, glm::dvec2 radius) {
            const double share = in_reals::lit_share<Points>(map, coord, double(receiver), radius, rotation);
            worst = std::max(worst, std::abs(double(ours) - share));
        };
        try_one(disc_hardware<Points>(clamped(map), coord, receiver, wide, rotation), glm::dvec2(double(wide)));
        const glm::vec2 both(wide, high);
        try_one(ellipse_hardware<Points>(clamped(map), coord, receiver, both, rotation), both);
    }
    MESSAGE(Points << " points: off by " << worst << " of the bound of " << glsl::disc_hardware<Points>.within);
    CHECK(worst <= double(glsl::disc_hardware<Points>.within));
}

}  // namespace

TEST_CASE("disc_hardware: the mean of bilinear comparisons, in real numbers") {
    check_against_real_numbers<8>();
    check_against_real_numbers<16>();
    check_against_real_numbers<32>();
}

TEST_CASE_TEMPLATE("disc_hardware: of no radius it is pcf_2x2; outside, beyond and NaN", T, float, double) {
    image<T> map({4, 4}, T(0.25));
    for (int y = 0; y < 4; ++y) map[{2, y}] = map[{3, y}] = T(0.75);
    const glm::vec<2, T> coord(1.75, 2.5);
    const glm::vec<4, T> rotation(64, 0, 0, 64);
    const T nan = std::numeric_limits<T>::quiet_NaN();
    for (const T none : {T(0), T(-3), nan}) {
        CHECK(disc_hardware<8>(clamped(map), coord, T(0.5), none, rotation) == T(0.25));
        CHECK(disc_hardware<16>(clamped(map), coord, T(0.5), none, rotation, greater_equal{}) == T(0.75));
    }
    CHECK(disc_hardware<32>(clamped(map), coord, T(0.5), std::numeric_limits<T>::infinity(), rotation) ==
          disc_hardware<32>(clamped(map), coord, T(0.5), T(max_disc_radius), rotation));
    CHECK(disc_hardware<16>(clamped(map), coord, nan, T(1), rotation) == 0);
    CHECK(disc_hardware<16>(clamped(map), coord, T(2), T(1), rotation) == 1);
    CHECK(disc_hardware<16>(clamped(map), {nan, T(1)}, T(0.5), T(1), rotation) == 1);
    CHECK(disc_hardware<16>(clamped(map), {T(40000), T(1)}, T(0.5), T(1), rotation) == 1);
}

TEST_CASE("disc_hardware: a look-up a point, straight from a map that has its sampler to itself") {
    using namespace umbrage::glsl;
    const auto text = [](const binding& map) { return glsl::text({bind(glsl::disc_hardware<16>, "sun", map)}); };
    const std::string direct = text({.texture = texture::shadow, .outside = outside_map::clamped});
    int found = 0;
    for (auto at = direct.find("n += umbrage_lit_at_sun(map, "); at != std::string::npos;
         at = direct.find("n += umbrage_lit_at_sun(map, ", at + 1))
        ++found;
    CHECK(found == 16);
    CHECK(direct.find("return textureLod(map, vec3(uv, receiver), 0.0);") != std::string::npos);
    CHECK(direct.find("umbrage_lit_filtered") == std::string::npos);
    CHECK(text({.texture = texture::shadow}).find("umbrage_lit_filtered") == std::string::npos);  // nor with a border
    for (const binding& map :
         {binding{}, binding{.texture = texture::shadow, .outside = outside_map::bordered, .origin = "vec2(8.0, 0.0)"},
          binding{.texture = texture::shadow, .origin = "vec2(8.0, 0.0)"}, binding{.gather = true}})
        CHECK(text(map).find("return umbrage_lit_filtered_sun(map, size, uv * size, receiver);") != std::string::npos);
}
