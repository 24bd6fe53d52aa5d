// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <umbrage/filter/pcf/pcf_2x2_hardware.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <umbrage/shader/glsl.hpp>

using namespace umbrage;

TEST_CASE_TEMPLATE("pcf_2x2_hardware: by hand", T, float, double) {
    image<T> map({2, 1}, T(0.25));
    map[{1, 0}] = T(0.75);
    CHECK(pcf_2x2_hardware(clamped(map), glm::vec<2, T>(1.25, 0.5), T(0.5)) == T(0.75));
    CHECK(pcf_2x2_hardware(clamped(map), glm::vec<2, T>(1.25, 0.5), T(0.5), greater_equal{}) == T(0.25));
    CHECK(lit_at(clamped(map), glm::vec<2, T>(2, 1), glm::vec<2, T>(0.625, 0.5), T(0.5)) == T(0.75));
    CHECK(pcf_2x2_hardware(clamped(map), glm::vec<2, T>(1), T(2)) == 1);  // beyond the far plane
    CHECK(pcf_2x2_hardware(clamped(map), glm::vec<2, T>(1), std::numeric_limits<T>::quiet_NaN()) == 0);
}

// The four comparisons and two fractions are all that counts; along an axis a sampler's weight lies in [0, 1].
TEST_CASE("pcf_2x2_hardware: its bound holds for weights rounded to 1/256, and is reached") {
    double worst = 0;
    for (int mask = 0; mask < 16; ++mask) {
        const auto lit = [mask](glm::ivec2 t) { return (mask >> ((t.x & 1) + 2 * (t.y & 1)) & 1) != 0 ? 1.0 : 0.0; };
        for (int y = 0; y < 1024; y += 7)
            for (int x = 0; x < 1024; ++x) {
                const glm::dvec2 fraction(x / 1024.0, y / 1024.0), w = glm::floor(fraction * 256.0 + 0.5) / 256.0;
                const double low = lit({0, 0}) + w.x * (lit({1, 0}) - lit({0, 0}));
                const double high = lit({0, 1}) + w.x * (lit({1, 1}) - lit({0, 1}));
                const double ours = pcf_2x2_hardware(lit, fraction + 0.5, 0.5);
                worst = std::max(worst, std::abs(low + w.y * (high - low) - ours));
            }
    }
    CHECK(worst <= glsl::pcf_2x2_hardware.within);
    CHECK(worst > 0.99 * glsl::pcf_2x2_hardware.within);
}

TEST_CASE("pcf_2x2_hardware: the sampler weighs where there is one, else we do") {
    using namespace umbrage::glsl;
    const auto text = [](const binding& map) { return glsl::text({bind(glsl::pcf_2x2_hardware, "sun", map)}); };
    CHECK(text({.texture = texture::shadow}).find("textureLod(map, vec3(uv, receiver), 0.0)") != std::string::npos);
    CHECK(text({.texture = texture::shadow}).find("umbrage_pcf_2x2_sun(") == std::string::npos);
    CHECK(text({.texture = texture::array}).find("return umbrage_pcf_2x2_sun(map, layer, size, ") != std::string::npos);
    const binding whole{.texture = texture::shadow_array},
        clamped{.texture = texture::shadow_array, .outside = outside_map::clamped};
    CHECK(text(whole).find("abs(uv - 0.5) * size") != std::string::npos);  // the share of the map in what is fetched
    CHECK(text(clamped).find("abs(uv - 0.5) * size") == std::string::npos);
}
