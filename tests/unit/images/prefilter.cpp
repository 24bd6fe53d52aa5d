// SPDX-License-Identifier: MIT
#include <umbrage/images/prefilter.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>

#include <umbrage/images/blur.hpp>
#include <umbrage/images/moment_table.hpp>
#include <umbrage/images/plane_visibility.hpp>
#include <umbrage/images/variance_table.hpp>
#include <umbrage/images/visibility.hpp>

#include "../fusing.hpp"

using namespace umbrage;

namespace {

struct rows_from_last {
    template <class Piece>
    void operator()(int count, Piece&& piece) const {
        for (int i = count; i > 0; --i) piece(i - 1, i);
    }
};

image<float> random_depths(std::mt19937& random, glm::ivec2 size) {
    image<float> depth(size);
    for (float& d : depth.texels()) d = static_cast<float>(random() % 1025) / 1024.0f;
    return depth;
}

template <class Texel>
bool same(const image<Texel>& a, const image<Texel>& b) {
    return std::equal(a.texels().begin(), a.texels().end(), b.texels().begin());
}

/// True when visibility takes these arguments.
template <class... Args>
constexpr bool takes = requires(Args... args) {
    visibility(args...);
};

}  // namespace

TEST_CASE("visibility: each kind of map has one overload; calls that mix two kinds do not compile") {
    using receivers = image<glm::vec3>&;
    using out = image<float>&;
    using moments = image<glm::vec2>&;
    using table = image<glm::u16vec4>&;
    CHECK(takes<out, depth32f, receivers, filters::hard, out>);
    CHECK(takes<moments, prefilters::vsm, receivers, out>);
    CHECK(takes<moments, prefilters::vsm, receiver_planes, out, serial, outside_map>);
    CHECK(takes<table, moment_table, receivers, int, out>);
    CHECK(takes<table, variance_table, receivers, int, out>);
    CHECK_FALSE(takes<table, moment_table, receivers, out>);  // no radius
    CHECK_FALSE(takes<moments, prefilters::vsm, sloped_receivers, out>);
    CHECK_FALSE(takes<moments, moment_table, receivers, int, out>);
    CHECK_FALSE(takes<moments, prefilters::evsm4, receivers, out>);
    CHECK_FALSE(takes<out, receivers, filters::hard, out>);  // no encoding
    CHECK_FALSE(takes<out, rg<11>, receivers, filters::hard, out>);
    prefilters::all::for_each([](auto filter) {
        CHECK(prefilter<decltype(filter)>);
        CHECK_FALSE(encoding<decltype(filter)>);
    });
    CHECK_FALSE(prefilter<depth32f>);
}

TEST_CASE("prefilter: encoded, blurred, looked up, bit for bit as texel by texel, in any pieces") {
    std::mt19937 random(23);
    const image<float> depth = random_depths(random, {37, 21});
    image<glm::vec3> receivers({70, 9});
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (glm::vec3& r : receivers.texels()) {
        const float x = static_cast<float>(random() % 10240) / 256.0f - 1.5f;
        const float y = static_cast<float>(random() % 6144) / 256.0f - 1.5f;
        r = {x, y, static_cast<float>(random() % 1200) / 1100.0f - 0.02f};
    }
    receivers[{3, 3}].z = nan, receivers[{4, 3}].x = nan, receivers[{5, 3}].y = 1e9f;
    prefilters::all::for_each([&](auto filter) {
        using texel = typename decltype(filter)::texel;
        for (const auto direction : {depth_direction::forward, depth_direction::reversed}) {
            CAPTURE(filter.name);
            filter.direction = direction;
            image<texel> moments(depth.size()), other(depth.size()), blurred(depth.size());
            encode_moments(depth.view(), moments.view(), filter);
            encode_moments(depth.view(), other.view(), filter, rows_from_last{});
            CHECK(same(moments, other));
            int wrong = 0;
            for (std::size_t i = 0; i < depth.texels().size(); ++i)
                wrong += moments.texels()[i] != filter.encode(depth.texels()[i]);
            blur(moments, blurred, make_binomial_kernel<5>());
            image<float> lit(receivers.size()), again(receivers.size()), at_edge(receivers.size());
            visibility(std::as_const(blurred).view(), filter, std::as_const(receivers).view(), lit.view());
            visibility(std::as_const(blurred).view(), filter, std::as_const(receivers).view(), at_edge.view(), serial{},
                       outside_map::clamped);
            visibility(std::as_const(blurred).view(), filter, std::as_const(receivers).view(), again.view(),
                       rows_from_last{});
            CHECK(same(lit, again));
            for (std::size_t i = 0; i < lit.texels().size(); ++i) {
                const glm::vec3 r = receivers.texels()[i];
                const bool compared = in_filter_domain(glm::vec2(r), r.z, comparison{direction});
                const float there =
                    compared ? filter.decode(fetch_bilinear(clamped(blurred), glm::vec2(r)), r.z) : 1.0f;
                wrong += at_edge.texels()[i] != there;
                wrong += lit.texels()[i] != (map_covers(glm::vec2(depth.size()), glm::vec2(r)) ? there : 1.0f);
            }
            if (!may_fuse) CHECK(wrong == 0);  // fused, tier B has only its bounds: tests of each filter hold those
        }
    });
}

TEST_CASE("prefilter: a map that is cleared lights all, one caster shadows what is behind it and nothing before") {
    prefilters::all::for_each([&](auto filter) {
        using texel = typename decltype(filter)::texel;
        const image<float> cleared({8, 8}, 1.0f), caster({8, 8}, 0.25f);
        const auto lit_at = [&](const image<float>& depth, float receiver) {
            image<texel> moments({8, 8}), blurred({8, 8});
            encode_moments(depth.view(), moments.view(), filter);
            blur(moments, blurred, make_gaussian_kernel(7, 1.5f));
            image<glm::vec3> receivers({1, 1}, glm::vec3(4.3f, 3.9f, receiver));
            image<float> lit({1, 1});
            visibility(std::as_const(blurred).view(), filter, std::as_const(receivers).view(), lit.view());
            return lit[{0, 0}];
        };
        CAPTURE(filter.name);
        CHECK(lit_at(cleared, 0.9f) > 0.999f);
        CHECK(lit_at(caster, 0.2f) > 0.999f);
        CHECK(lit_at(caster, 0.75f) < 0.001f);
    });
}

TEST_CASE("visibility from a prefiltered map: receivers in planes and from a depth image, as in an image of vec3s") {
    std::mt19937 random(24);
    const image<float> depth = random_depths(random, {37, 21}), seen = random_depths(random, {70, 9});
    const prefilters::vsm filter;
    image<glm::vec2> moments(depth.size());
    encode_moments(depth, moments, filter);
    const depth_receivers from_depth{seen.view(), glm::mat4(0.5f), 0.01f};
    image<glm::vec3> receivers(seen.size());
    image<float> x(seen.size()), y(seen.size()), z(seen.size());
    for (glm::ivec2 p{0}; p.y < seen.size().y; ++p.y)
        for (p.x = 0; p.x < seen.size().x; ++p.x) {
            receivers[p] = receiver_at(from_depth, p);
            x[p] = receivers[p].x, y[p] = receivers[p].y, z[p] = receivers[p].z;
        }
    image<float> wanted(seen.size()), of_planes(seen.size()), of_depth(seen.size());
    visibility(moments, filter, receivers, wanted);
    visibility(moments, filter, receiver_planes{x, y, z}, of_planes);
    visibility(moments, filter, from_depth, of_depth);
    CHECK(std::ranges::count_if(wanted.texels(), [](float lit) { return lit < 1.0f; }) > 50);
    CHECK(same(of_planes, wanted));
    if (!may_fuse) CHECK(same(of_depth, wanted));
}

TEST_CASE("make_mip_chain: means of fours, down to one") {
    image<float> map({5, 3});
    for (int i = 0; i < 15; ++i) map[{i % 5, i / 5}] = static_cast<float>(i);
    const auto chain = make_mip_chain(map, 4);
    REQUIRE(chain.size() == 4);
    CHECK(chain[0].size() == glm::ivec2(3, 2));
    CHECK(chain[0][{0, 0}] == 3.0f);
    CHECK(chain[0][{2, 1}] == 14.0f);
    CHECK(chain[2].size() == glm::ivec2(1, 1));
    CHECK(chain[3][{0, 0}] == chain[2][{0, 0}]);
    CHECK(same(chain[1], make_mip_chain(map, 2, rows_from_last{})[1]));
    CHECK_THROWS_AS((void)make_mip_chain(image<float>(), 1), std::invalid_argument);
    CHECK_THROWS_AS((void)make_mip_chain(map, -1), std::invalid_argument);
}

TEST_CASE("prefilter: sizes that differ, empty maps") {
    const prefilters::esm filter;
    image<float> small({2, 2}), large({3, 2}), none;
    const image<glm::vec3> receivers({2, 2});
    CHECK_THROWS_AS(encode_moments(small.view(), large.view(), filter), std::invalid_argument);
    CHECK_THROWS_AS(visibility(small.view(), filter, receivers.view(), large.view()), std::invalid_argument);
    CHECK_THROWS_AS(visibility(none.view(), filter, receivers.view(), small.view()), std::invalid_argument);
    CHECK_NOTHROW(encode_moments(none.view(), none.view(), filter));
}

TEST_CASE("prefilter: an exponent that overflows is refused before a texel is written") {
    const prefilters::esm filter{.settings = {.exponent = 80.0f}};
    const image<float> depth({2, 2}, 0.5f);
    const image<glm::vec3> receivers({2, 2});
    image<float> out({2, 2}, -1.0f);
    CHECK_THROWS_WITH_AS(encode_moments(depth, out, filter),
                         "umbrage::encode_moments: filter.settings.exponent must be above 0 and at most 63; got 80. "
                         "Beyond that the warped depth overflows.",
                         std::invalid_argument);
    CHECK_THROWS_AS(visibility(depth, filter, receivers, out), std::invalid_argument);
    for (const float v : out.texels()) CHECK(v == -1.0f);
}
