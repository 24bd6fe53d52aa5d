// SPDX-License-Identifier: MIT
//
// Image functions against the primitives they stand for, bit by bit: every instruction set of this machine, every
// rounding mode, sizes that are no multiple of anything, rows with gaps, bands.
#include <doctest/doctest.h>

#include <bit>
#include <cfenv>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include <umbrage/images/encode.hpp>
#include <umbrage/images/visibility.hpp>

namespace {

using umbrage::image;
using umbrage::detail::isa;

template <class Use>
void for_each_path(Use&& use) {
    const isa best = umbrage::detail::isa_in_use;
    for (isa set : {isa::base, isa::avx2, isa::avx512}) {
        if (umbrage::detail::best_isa() < set) continue;
        for (int rounding : {FE_TONEAREST, FE_TOWARDZERO, FE_UPWARD, FE_DOWNWARD}) {
            CAPTURE(static_cast<int>(set));
            CAPTURE(rounding);
            umbrage::detail::isa_in_use = set;
            std::fesetround(rounding);
            use();
            std::fesetround(FE_TONEAREST);
        }
    }
    umbrage::detail::isa_in_use = best;
}

/// As many pieces, the last first.
struct bands {
    int pieces;
    template <class Piece>
    void operator()(int count, Piece&& piece) const {
        for (int i = pieces - 1; i >= 0; --i)
            if (count * i / pieces < count * (i + 1) / pieces) piece(count * i / pieces, count * (i + 1) / pieces);
    }
};

std::uint32_t bits(float v) { return std::bit_cast<std::uint32_t>(v); }

/// Rounding down makes x - x of the primitives -0, which is the same visibility.
std::uint32_t visibility_bits(float v) { return v == 0.0f ? 0 : bits(v); }

struct values {
    std::mt19937 engine{20021};
    std::uint32_t word() { return static_cast<std::uint32_t>(engine()); }
    float unit() { return static_cast<float>(word() >> 8) * 0x1p-24f; }
    /// What breaks conversions: NaN of either sign, infinities, borders of codes, any pattern of bits.
    float depth() {
        constexpr float infinity = std::numeric_limits<float>::infinity();
        switch (word() % 12) {
            case 0: return std::bit_cast<float>(word());
            case 1: return std::bit_cast<float>(0x7FC00000u | (word() & 0x803FFFFFu));
            case 2: return word() % 2 ? infinity : -infinity;
            case 3: return word() % 2 ? -0.0f : 1.0f;
            case 4: return std::nextafter(static_cast<float>(word() % 2049) / 2048.0f, word() % 2 ? 2.0f : -1.0f);
            case 5: return static_cast<float>(word() % 65537) / 65536.0f;
            default: return unit();
        }
    }
    float coord(int size) {
        const float v = unit() * static_cast<float>(size + 24) - 12.0f;
        switch (word() % 12) {
            case 0: return std::bit_cast<float>(word());
            case 1: return std::floor(v);
            case 2: return std::floor(v * 256.0f) / 256.0f;
            case 3: return std::nextafter(std::floor(v), -1e9f);
            case 4: return word() % 2 ? 32768.0f : std::nextafter(-32768.0f, 0.0f);
            default: return v;
        }
    }
};

/// Rows with a gap behind each, which nobody may touch.
template <class T>
struct gapped {
    glm::ivec2 size;
    std::vector<T> memory;
    explicit gapped(glm::ivec2 s) : size(s), memory(static_cast<std::size_t>((s.x + 5) * s.y), T(7)) {}
    umbrage::image_view<T> view() { return {memory.data(), size, (size.x + 5) * static_cast<std::ptrdiff_t>(sizeof(T))}; }
    bool gaps_untouched() {
        for (int y = 0; y < size.y; ++y)
            for (int x = size.x; x < size.x + 5; ++x)
                if (memory[static_cast<std::size_t>(y * (size.x + 5) + x)] != T(7)) return false;
        return true;
    }
};

template <class Encoding>
void check_codec(Encoding encoding) {
    using texel = typename Encoding::texel;
    values v;
    for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(63, 3), glm::ivec2(64, 2), glm::ivec2(65, 40), glm::ivec2(389, 31)}) {
        gapped<float> depth(size), back(size);
        gapped<texel> texels(size);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) depth.view()[{x, y}] = v.depth();
        for_each_path([&] {
            umbrage::encode(depth.view(), texels.view(), encoding, bands{3});
            umbrage::decode(texels.view(), back.view(), encoding, bands{2});
            int different = 0;
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) {
                    const texel wanted = encoding.encode(depth.view()[{x, y}]);
                    const float decoded = encoding.decode(wanted);
                    different += std::memcmp(&wanted, &texels.view()[{x, y}], sizeof wanted) != 0;
                    different += bits(decoded) != bits(back.view()[{x, y}]);
                }
            CHECK(different == 0);
            CHECK(texels.gaps_untouched());
            CHECK(back.gaps_untouched());
        });
    }
}

template <class Encoding, class Filter>
void check_filter(Encoding encoding, Filter filter, glm::ivec2 map_size) {
    CAPTURE(map_size.x);
    CAPTURE(map_size.y);
    values v;
    const glm::ivec2 size(131, 29);
    gapped<typename Encoding::texel> map(map_size);
    for (int y = 0; y < map_size.y; ++y)
        for (int x = 0; x < map_size.x; ++x) {
            const float d = v.depth();
            if constexpr (std::is_same_v<typename Encoding::texel, float>)
                map.view()[{x, y}] = d;  // a map of floats may hold anything
            else
                map.view()[{x, y}] = encoding.encode(d);
        }
    image<glm::vec3> receivers(size);
    image<float> x_plane(size), y_plane(size), depth(size);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            const glm::ivec2 t(x, y);
            const float z = v.word() % 3 ? v.depth() : encoding.decode(encoding.encode(v.unit()));  // ties
            receivers[t] = {v.coord(map_size.x), v.coord(map_size.y), z};
            x_plane[t] = receivers[t].x;
            y_plane[t] = receivers[t].y;
            depth[t] = receivers[t].z;
        }
    const umbrage::receiver_planes planes{x_plane, y_plane, depth};
    glm::mat4 matrix(0.4f);
    matrix[0][3] = 0.004f;
    matrix[1][3] = -0.03f;  // some receivers are behind the light
    matrix[3] = {-2.0f, 1.0f, 0.2f, 0.6f};
    const umbrage::depth_receivers seen{depth, matrix, 0.01f};
    const auto fetch = umbrage::decoded(umbrage::image_view<const typename Encoding::texel>(map.view()), encoding);

    for_each_path([&] {
        image<float> from_image(size), from_planes(size), from_depth(size);
        umbrage::visibility(map.view(), encoding, receivers, filter, from_image, bands{7});
        umbrage::visibility(map.view(), encoding, planes, filter, from_planes, bands{2});
        umbrage::visibility(map.view(), encoding, seen, filter, from_depth);
        int different = 0, different_from_depth = 0;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const glm::ivec2 t(x, y);
                const float wanted = filter(fetch, glm::vec2(receivers[t]), receivers[t].z);
                different += visibility_bits(wanted) != visibility_bits(from_image[t]);
                different += visibility_bits(wanted) != visibility_bits(from_planes[t]);
                const glm::vec3 receiver = umbrage::receiver_at(seen, t);
                different_from_depth += visibility_bits(filter(fetch, glm::vec2(receiver), receiver.z)) != visibility_bits(from_depth[t]);
            }
        CHECK(different == 0);
        CHECK(different_from_depth == 0);  // receiver_at is of tier C: wants -ffp-contract=off
    });
}

/// Receivers that follow each other through a map, most of them well inside: whole blocks that need no care.
/// Rows of 512 and 1024 floats push each other out of the cache, and large boxes then go through a copy.
template <class Encoding, class Filter>
void check_coherent(Encoding encoding, Filter filter, glm::ivec2 map_size, glm::vec2 start = {12.0f, 9.0f},
                    glm::vec2 step = {1.03f, 1.7f}) {
    CAPTURE(map_size.x);
    CAPTURE(start.x);
    values v;
    image<typename Encoding::texel> map(map_size);
    for (auto& texel : map.texels()) texel = encoding.encode(0.3f + 0.4f * v.unit());
    const glm::ivec2 size(192, 24);
    image<glm::vec3> receivers(size);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x)
            receivers[{x, y}] = glm::vec3(start + step * glm::vec2(x, y), 0.3f + 0.02f * static_cast<float>(y));
    receivers[{5, 3}].z = std::numeric_limits<float>::quiet_NaN();
    receivers[{70, 4}].x = -3.0f;
    receivers[{130, 5}].x = static_cast<float>(map_size.x) - 0.5f;
    const auto fetch = umbrage::decoded(std::as_const(map).view(), encoding);
    for_each_path([&] {
        image<float> out(size);
        umbrage::visibility(map, encoding, receivers, filter, out, bands{3});
        int different = 0;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                const glm::vec3 r = receivers[{x, y}];
                different += visibility_bits(filter(fetch, glm::vec2(r), r.z)) != visibility_bits(out[{x, y}]);
            }
        CHECK(different == 0);
    });
}

template <class Encoding>
void check_filters(Encoding encoding) {
    for (const glm::ivec2 map_size : {glm::ivec2(1, 1), glm::ivec2(1, 9), glm::ivec2(2, 2), glm::ivec2(9, 4), glm::ivec2(67, 45)}) {
        check_filter(encoding, umbrage::filters::hard{}, map_size);
        check_filter(encoding, umbrage::filters::four_tap{}, map_size);
        check_filter(encoding, umbrage::filters::pcf_2x2{}, map_size);
        for (int radius : {-1, 0, 1, 2, 3, 4, 7, 8, 9}) {
            check_filter(encoding, umbrage::filters::box{radius}, map_size);
            check_filter(encoding, umbrage::filters::hierarchical_box{radius}, map_size);
        }
    }
}

}  // namespace

TEST_CASE("encode, decode: every path gives the primitive's bits") {
    check_codec(umbrage::rg<9>{});
    check_codec(umbrage::rg<11>{});
    check_codec(umbrage::rg<16>{});
    check_codec(umbrage::rg<11>{.edge = umbrage::lower_edge<float>});
    check_codec(umbrage::rgb24{});
    check_codec(umbrage::float_bits{});
    check_codec(umbrage::depth32f{});
}

TEST_CASE("visibility: every path gives the filter's bits, float map") { check_filters(umbrage::depth32f{}); }
TEST_CASE("visibility: every path gives the filter's bits, 11-bit map") { check_filters(umbrage::rg<11>{}); }
TEST_CASE("visibility: every path gives the filter's bits, 16-bit map") {
    check_filters(umbrage::rg<16>{.edge = umbrage::centre<float>});
}
TEST_CASE("visibility: every path gives the filter's bits, 24-bit map") { check_filters(umbrage::rgb24{}); }

TEST_CASE("visibility: whole blocks inside the map, and rows that collide in the cache") {
    for (const glm::ivec2 map_size : {glm::ivec2(512, 61), glm::ivec2(600, 61), glm::ivec2(1024, 61)}) {
        check_coherent(umbrage::depth32f{}, umbrage::filters::pcf_2x2{}, map_size);
        check_coherent(umbrage::rg<11>{}, umbrage::filters::pcf_2x2{}, map_size);
        for (int radius : {0, 1, 2, 3, 4, 6, 8}) {
            check_coherent(umbrage::depth32f{}, umbrage::filters::box{radius}, map_size);
            check_coherent(umbrage::depth32f{}, umbrage::filters::hierarchical_box{radius}, map_size);
            check_coherent(umbrage::rg<16>{}, umbrage::filters::box{radius}, map_size);
            // From the far corner of the map on: as near to it as eight lanes can be loaded for every row, and one texel on.
            for (const float beyond : {7.5f, 6.5f}) {
                const auto corner = glm::vec2(map_size - radius) - glm::vec2(beyond, 0.5f);
                check_coherent(umbrage::depth32f{}, umbrage::filters::box{radius}, map_size, corner, {-1.03f, -1.7f});
            }
        }
    }
}

TEST_CASE("encode, visibility: large images, which bypass the cache, rows on and off multiples of 16 bytes") {
    const glm::ivec2 size(1057, 1001), map_size(67, 45);
    values v;
    gapped<float> depth(size), visibility(size);
    gapped<glm::u8vec4> texels(size);
    image<glm::u8vec2> map(map_size);
    image<glm::vec3> receivers(size);
    const umbrage::rg<11> rg;
    const umbrage::float_bits float_bits;
    for (auto& texel : map.texels()) texel = rg.encode(v.unit());
    for (auto& receiver : receivers.texels()) receiver = {v.coord(map_size.x), v.coord(map_size.y), v.unit()};
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) depth.view()[{x, y}] = v.depth();
    REQUIRE(umbrage::detail::past_cache(visibility.view()));
    REQUIRE(umbrage::detail::past_cache(texels.view()));
    const auto fetch = umbrage::decoded(std::as_const(map).view(), rg);
    const umbrage::filters::pcf_2x2 filter;
    image<float> wanted(size);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) wanted[{x, y}] = filter(fetch, glm::vec2(receivers[{x, y}]), receivers[{x, y}].z);
    for_each_path([&] {
        umbrage::encode(depth.view(), texels.view(), float_bits, bands{3});
        umbrage::visibility(map, rg, receivers, filter, visibility.view(), bands{3});
        int different = 0;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                different += texels.view()[{x, y}] != float_bits.encode(depth.view()[{x, y}]);
                different += visibility_bits(wanted[{x, y}]) != visibility_bits(visibility.view()[{x, y}]);
            }
        CHECK(different == 0);
        CHECK(texels.gaps_untouched());
        CHECK(visibility.gaps_untouched());
    });
}
