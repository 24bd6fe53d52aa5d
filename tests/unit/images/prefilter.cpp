// SPDX-License-Identifier: MIT
#include <umbrage/images/prefilter.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <stdexcept>

#include <umbrage/images/blur.hpp>

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

}  // namespace

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
            look_up(std::as_const(blurred).view(), std::as_const(receivers).view(), filter, lit.view());
            look_up(std::as_const(blurred).view(), std::as_const(receivers).view(), filter, at_edge.view(), serial{},
                    outside_map::clamped);
            look_up(std::as_const(blurred).view(), std::as_const(receivers).view(), filter, again.view(),
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
        const auto visibility = [&](const image<float>& depth, float receiver) {
            image<texel> moments({8, 8}), blurred({8, 8});
            encode_moments(depth.view(), moments.view(), filter);
            blur(moments, blurred, make_gaussian_kernel(7, 1.5f));
            image<glm::vec3> receivers({1, 1}, glm::vec3(4.3f, 3.9f, receiver));
            image<float> lit({1, 1});
            look_up(std::as_const(blurred).view(), std::as_const(receivers).view(), filter, lit.view());
            return lit[{0, 0}];
        };
        CAPTURE(filter.name);
        CHECK(visibility(cleared, 0.9f) > 0.999f);
        CHECK(visibility(caster, 0.2f) > 0.999f);
        CHECK(visibility(caster, 0.75f) < 0.001f);
    });
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
    CHECK_THROWS_AS(look_up(small.view(), receivers.view(), filter, large.view()), std::invalid_argument);
    CHECK_THROWS_AS(look_up(none.view(), receivers.view(), filter, small.view()), std::invalid_argument);
    CHECK_NOTHROW(encode_moments(none.view(), none.view(), filter));
}
