// SPDX-License-Identifier: MIT
#include <umbrage/filter/blocker/pcss_hardware.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <umbrage/bias/constant.hpp>
#include <umbrage/shader/glsl.hpp>

#include "../../rounds.hpp"
#include "../../special_values.hpp"
#include "../real_discs.hpp"
#include "penumbra_width.hpp"
#include "whole_numbers.hpp"

using namespace umbrage;

namespace {

const glm::vec4 one_turn = disc_rotation(glm::vec2(2, 1));
const glm::vec2 one_place(8.3f, 9.1f);

/// The texels under a disc's points, in real numbers; nothing where one is too near a border to tell.
template <int Points>
std::vector<double> depths_under(const image<float>& map, glm::dvec2 coord, glm::dvec4 rotation, glm::dvec2 radius) {
    std::vector<double> found;
    bool told = true;
    in_reals::for_each_point<Points>(coord, rotation, radius, [&](glm::dvec2 at) {
        const glm::dvec2 within = at - glm::floor(at);
        told &= std::min(within.x, within.y) > 1e-4 && std::max(within.x, within.y) < 1 - 1e-4;
        found.push_back(double(texel_at(map, std::int64_t(std::floor(at.x)), std::int64_t(std::floor(at.y)))));
    });
    if (!told) found.clear();
    return found;
}

template <int Points>
void check_sampled_search(bool forward) {
    whole::cases all;
    const comparison is_lit{forward ? depth_direction::forward : depth_direction::reversed};
    int checked = 0, several = 0, wrong = 0;
    for (int i = 0; i < rounds(4000); ++i) {
        const whole::receiver r = all.draw();
        const glm::vec2 radius(static_cast<float>(i % 97) / 8.0f, static_cast<float>(i % 41) / 4.0f);
        const auto under = depths_under<Points>(all.map, r.coord, r.rotation, radius);
        if (under.empty()) continue;
        double count = 0, sum = 0;
        for (const double stored : under)
            if (forward ? stored < double(r.depth) : stored > double(r.depth)) count += 1, sum += stored;
        const auto found =
            blockers_hardware<Points>(clamped(all.map), r.coord, r.depth, radius, glm::vec4(r.rotation), is_lit);
        wrong += double(found.x) != count || !(std::abs(double(found.y) - sum) <= 1e-6 * Points);
        ++checked, several += count > 1 && count < Points;
    }
    CHECK(wrong == 0);
    CHECK(checked > rounds(3000));
    CHECK(several > rounds(500));
}

}  // namespace

TEST_CASE("blockers_hardware: count and sum over texels in real numbers, forward and reversed") {
    for (const bool forward : {true, false}) {
        check_sampled_search<8>(forward);
        check_sampled_search<16>(forward);
        check_sampled_search<32>(forward);
    }
}

TEST_CASE_TEMPLATE("blocker_at: the texel's depth where it is before the receiver", T, float, double) {
    using vec2 = glm::vec<2, T>;
    image<T> map({4, 2}, T(0.25));
    map[{3, 1}] = T(0.75);
    const vec2 size(4, 2);
    CHECK(blocker_at(clamped(map), size, vec2(0.875, 0.75), T(0.5)) == vec2(0, 0));
    CHECK(blocker_at(clamped(map), size, vec2(0.875, 0.25), T(0.5)) == vec2(1, 0.25));
    CHECK(blocker_at(clamped(map), size, vec2(0.875, 0.75), T(0.5), greater_equal{}) == vec2(1, 0.75));
}

TEST_CASE_TEMPLATE("pcss_radius: by hand, finite whatever comes", T, float, double) {
    using vec2 = glm::vec<2, T>;
    const glm::vec<4, T> soft(T(0.0625), T(0.125), T(16), T(96));  // 256 and 512 texels of depth 1, 1 to 6
    CHECK(pcss_radius(vec2(2, 1), T(0.515625), soft) == vec2(4, 6));
    CHECK(pcss_radius(vec2(2, 1), T(0.484375), soft, greater_equal{}) == vec2(4, 6));
    CHECK(pcss_radius(vec2(2, 1), T(0.5), soft) == vec2(1));
    CHECK(pcss_radius(vec2(2, 1), T(0.75), soft) == vec2(6));
    CHECK(pcss_radius(vec2(0, 0), T(0.0078125), soft) == vec2(2, 4));  // as if a blocker were at the near plane
    CHECK(pcss_radius(vec2(0, 0), T(0.9921875), soft, greater_equal{}) == vec2(2, 4));
    const T nan = std::numeric_limits<T>::quiet_NaN(), inf = std::numeric_limits<T>::infinity();
    CHECK(pcss_radius(vec2(1, nan), T(0.5), soft) == vec2(1));
    CHECK(pcss_radius(vec2(1, 0), nan, soft) == vec2(1));
    CHECK(pcss_radius(vec2(1, -inf), T(0.5), soft) == vec2(6));
    CHECK(pcss_radius(vec2(1, inf), T(0.5), soft) == vec2(1));
}

TEST_CASE("pcss_radius: its bound is that of a mean off by 4 ulp") {
    const float per_code = 0.5f, mean = 0.75f;
    const glm::vec4 soft(per_code, per_code, 0.0f, 4095.0f);
    for (const int ulps : {-4, 4}) {
        const float off = mean + static_cast<float>(ulps) * 0x1p-24f;
        const double moved = double(pcss_radius(glm::vec2(1.0f, off), 0.8f, soft).x) -
                             double(pcss_radius(glm::vec2(1.0f, mean), 0.8f, soft).x);
        CHECK(std::abs(moved) <= double(per_code) * 0x1p-9);
        CHECK(std::abs(moved) <= double(glsl::pcss_radius.within));
        CHECK(moved != 0);
    }
}

TEST_CASE("pcss_hardware: a straight edge's penumbra is as wide as rays to an area light see it") {
    check_widths([](const image<float>& map, glm::vec3 at, glm::vec4 soft, glm::vec4 rotation, comparison is_lit) {
        const float biased = umbrage::biased(at.z, 0x1p-15f, is_lit.direction);
        return pcss_hardware<16>(clamped(map), glm::vec2(at), biased, soft, rotation, is_lit);
    });
}

TEST_CASE("pcss_hardware: no blocker is lit, all blocked is dark; what is no number, or outside, is finite") {
    const glm::vec4 soft(0.25f, 0.25f, 0.0f, 200.0f);
    const auto roof = [](glm::ivec2) { return 0.25f; };
    CHECK(pcss_hardware<16>([](glm::ivec2) { return 1.0f; }, one_place, 0.9f, soft, one_turn) == 1.0f);
    CHECK(pcss_hardware<16>(roof, one_place, 0.9f, soft, one_turn) == 0.0f);
    CHECK(pcss_hardware<16>(roof, one_place, nan32, soft, one_turn) == 0.0f);
    CHECK(pcss_hardware<16>(roof, one_place, 1.5f, soft, one_turn) == 1.0f);
    CHECK(pcss_hardware<16>(roof, one_place, -0.5f, soft, one_turn, greater_equal{}) == 1.0f);
    for (const float at_light : {0.0f, -1.0f, -inf32})
        CHECK(pcss_hardware<16>(roof, one_place, at_light, soft, one_turn) == 1.0f);
    for (const glm::vec2 outside : coordinates_outside_texel_space())
        CHECK(pcss_hardware<16>(roof, outside, 0.9f, soft, one_turn) == 1.0f);
    for (const float odd : {nan32, -nan32, inf32, -inf32}) {
        const auto mixed = [odd](glm::ivec2 t) { return t.x % 2 ? odd : 0.5f; };
        const float share = pcss_hardware<16>(mixed, one_place, 0.9f, soft, one_turn);
        CHECK(share >= 0.0f);
        CHECK(share <= 1.0f);
        CHECK(pcss_hardware<16>(roof, one_place, 0.9f, glm::vec4(0.0f), glm::vec4(odd)) >= 0.0f);
    }
}

// Off by 2^-14 texel at most, the radius moves a point's weights by that much along either axis.
TEST_CASE("pcss_hardware: search, mean, radius and filter in real numbers, within the filter's bound") {
    whole::cases all;
    const glm::vec4 soft(0.03125f, 0.015625f, 16.0f, 96.0f);
    const auto radius_of = [](double apart) { return glm::clamp(apart * glm::dvec2(128, 64), 1.0, 6.0); };
    double worst = 0;
    int partly = 0;
    for (int i = 0; i < rounds(4000); ++i) {
        const whole::receiver r = all.draw();
        if (!in_filter_domain(r.coord, r.depth)) continue;
        const double depth = double(r.depth);
        const auto under = depths_under<16>(all.map, r.coord, r.rotation, radius_of(depth));
        double count = 0, sum = 0;
        for (const double stored : under)
            if (stored < depth) count += 1, sum += stored;
        if (count == 0) continue;
        const double share =
            in_reals::lit_share<16>(all.map, r.coord, depth, radius_of(depth - sum / count), r.rotation);
        const float ours = pcss_hardware<16>(clamped(all.map), r.coord, r.depth, soft, glm::vec4(r.rotation));
        worst = std::max(worst, std::abs(double(ours) - share));
        partly += share > 0 && share < 1;
    }
    MESSAGE("off by " << worst);
    CHECK(worst <= double(glsl::disc_hardware<16>.within) + 0x1p-13);
    CHECK(partly > rounds(500));
}

TEST_CASE("blockers_hardware: the sampler reads where a map has one to itself, else we do") {
    using namespace umbrage::glsl;
    const auto text = [](const binding& map) { return glsl::text({bind(glsl::blockers_hardware<16>, "sun", map)}); };
    CHECK(text({.texture = texture::depth, .outside = outside_map::clamped, .gather = true})
              .find("textureLod(map, uv, 0.0)") != std::string::npos);
    CHECK(text({.texture = texture::array, .outside = outside_map::clamped, .gather = true})
              .find("textureLod(map, vec3(uv, layer), 0.0)") != std::string::npos);
    const std::string bordered = text({.gather = true});
    CHECK(bordered.find("textureLod(map, uv, 0.0)") < bordered.find("? depth : 1.0;"));
    CHECK(bordered.find("? depth : 1.0;") != std::string::npos);
    for (const binding& map : {binding{}, binding{.texture = texture::atlas, .gather = true},
                               binding{.texture = texture::integer, .gather = true}})
        CHECK(text(map).find("umbrage_fetch_depth_sun(map, ") != std::string::npos);
    CHECK_THROWS_AS(text({.texture = texture::shadow}), std::invalid_argument);
}
