// SPDX-License-Identifier: MIT
#include "values.hpp"

#include <cmath>
#include <limits>

#include <glm/common.hpp>

namespace parity {
namespace {

float any_bits(random& r) { return umbrage::detail::bit_cast<float>(r.bits()); }
float signed_by(std::uint64_t i, float v) { return i % 2 ? -v : v; }
float denormal(std::uint64_t i, random& r) {
    return signed_by(i, umbrage::detail::bit_cast<float>(1 + (r.bits() & 0x7FFFFE)));
}
/// Quiet or signalling.
float not_a_number(std::uint64_t i, random& r) {
    return umbrage::detail::bit_cast<float>((i % 2 ? 0xFF800000u : 0x7F800000u) | 1u | (r.bits() & 0x7FFFFF));
}
float infinity(std::uint64_t i) { return signed_by(i, std::numeric_limits<float>::infinity()); }

/// In double: the bits of a float's exp2 depend on the C library.
float power_of_two(float exponent) { return static_cast<float>(std::exp2(static_cast<double>(exponent))); }

/// v, the float before it, the float after it, in turn.
float beside(std::uint64_t i, float v) { return i % 3 == 0 ? v : std::nextafter(v, i % 3 == 1 ? -1e30f : 1e30f); }

}  // namespace

std::vector<value_class> special_values() {
    return {
        {"zero", [](auto i, random&) { return signed_by(i, 0.0f); }},
        {"one", [](auto i, random&) { return beside(i, 1.0f); }},
        {"out of range", [](auto i, random& r) { return signed_by(i, 1.0f + power_of_two(r.between(-20.0f, 40.0f))); }},
        {"denormal", denormal},
        {"smallest normal", [](auto i, random&) { return signed_by(i, std::numeric_limits<float>::min()); }},
        {"NaN", not_a_number},
        {"infinity", [](auto i, random&) { return infinity(i); }}};
}

std::vector<value_class> large_values() {
    auto kinds = special_values();
    std::erase_if(kinds, [](const value_class& k) { return k.name == "denormal" || k.name == "smallest normal"; });
    return kinds;
}

std::vector<value_class> finite_values() {
    auto kinds = large_values();
    std::erase_if(kinds, [](const value_class& k) { return k.name == "NaN" || k.name == "infinity"; });
    return kinds;
}

std::vector<value_class> depth_values(int bits) {
    auto kinds = special_values();
    kinds.push_back({"any bits", [](auto, random& r) { return any_bits(r); }});
    kinds.push_back({"codes", [bits](std::uint64_t i, random&) {
                         const std::uint64_t code = (i / 3 * 0x9E3779B1u) & ((std::uint64_t(1) << bits) - 1);
                         return beside(i, std::ldexp(static_cast<float>(code), -bits));
                     }});
    return kinds;
}

std::vector<input_class> spread(std::vector<range> arguments, const std::vector<value_class>& kinds) {
    const auto ordinary = [arguments](random& r, sample& s) {
        for (std::size_t a = 0; a < arguments.size(); ++a)
            s.x[a / 4][static_cast<int>(a % 4)] = r.between(arguments[a].low, arguments[a].high);
    };
    std::vector<input_class> classes{{"random", [ordinary](auto, random& r, sample& s) { ordinary(r, s); }}};
    for (const value_class& kind : kinds)
        classes.push_back({kind.name, [ordinary, kind, n = arguments.size()](std::uint64_t i, random& r, sample& s) {
                               ordinary(r, s);
                               const std::uint64_t turn = i % (n + 1), round = i / (n + 1);
                               for (std::size_t a = 0; a < n; ++a)
                                   if (turn == n || turn == a)
                                       s.x[a / 4][static_cast<int>(a % 4)] = kind.make(round + (turn == n ? a : 0), r);
                           }});
    return classes;
}

std::vector<input_class> channels(bool edges, int bits) {
    const int most = (1 << bits) - 1;
    const auto scale = static_cast<float>(most);
    const auto each = [edges](auto value) {
        return [edges, value](std::uint64_t i, random& r, sample& s) {
            for (int c = 0; c < 4; ++c) s.x[0][c] = value(i, c, r);
            if (edges) s.x[1].x = static_cast<float>(r.below(3)) * 0.5f;
        };
    };
    const auto code = [most](std::uint64_t i, int c) {
        return static_cast<float>(i * 0x9E3779B1u >> (8 * c) & static_cast<std::uint64_t>(most));
    };
    std::vector<input_class> classes{
        {"codes", each([=](auto i, int c, random&) { return code(i, c) / scale; })},
        {"codes off by an ulp", each([=](auto i, int c, random& r) { return beside(r.bits(), code(i, c) / scale); })},
        {"codes off by 0.4",
         each([=](auto i, int c, random& r) { return (code(i, c) + r.between(-0.4f, 0.4f)) / scale; })},
        {"out of range",
         each([=](auto, int, random& r) { return static_cast<float>(r.below(4 * most + 4) - 2 * most - 2) / scale; })}};
    for (const value_class& kind : special_values()) {
        if (kind.name == "out of range" || kind.name == "smallest normal") continue;  // own; sums of it with denormals
        classes.push_back({kind.name, each([=](std::uint64_t i, int c, random& r) {
                               const auto lane = i % 5;
                               return lane == 4 || lane == static_cast<std::uint64_t>(c) ? kind.make(i / 5, r)
                                                                                         : code(i, c) / scale;
                           })});
    }
    return classes;
}

enumeration all_depths() {
    return {{"all k/2^24", [](std::uint64_t i, random&, sample& s) { s.x[0].x = static_cast<float>(i) * 0x1p-24f; }},
            1 << 24};
}

enumeration all_codes() {
    return {{"all codes",
             [](std::uint64_t i, random& r, sample& s) {
                 for (int c = 0; c < 3; ++c) s.x[0][c] = static_cast<float>(i >> (8 * c) & 0xFF) / 255.0f;
                 s.x[0].w = static_cast<float>(r.below(256)) / 255.0f;
                 s.x[1].x = static_cast<float>((i >> 16) % 3) * 0.5f;
             }},
            1 << 24};
}

std::vector<input_class> receivers() {
    const auto ordinary = [](random& r, sample& s) {
        const vec2 size(s.map.size);
        s.x[0] = {r.between(-3.0f, size.x + 3.0f), r.between(-3.0f, size.y + 3.0f), r.unit(),
                  static_cast<float>(r.below(11) - 1)};
    };
    const auto then = [ordinary](auto change) {
        return [ordinary, change](std::uint64_t i, random& r, sample& s) {
            ordinary(r, s);
            change(i, r, s.x[0], s.map);
        };
    };
    const auto one_of_three = [then](auto value) {
        return then(
            [value](std::uint64_t i, random& r, vec4& x, auto&) { x[static_cast<int>(i % 3)] = value(i / 3, r); });
    };
    return {{"random", [ordinary](auto, random& r, sample& s) { ordinary(r, s); }},
            {"texel edges", then([](std::uint64_t i, random& r, vec4& x, auto&) {
                 const float step = std::array{1.0f, 0.5f, 1.0f / 256.0f, 1.0f / 512.0f}[i % 4];
                 for (int c = 0; c < 2; ++c) x[c] = beside(r.bits(), std::floor(x[c] / step) * step);
             })},
            {"ties", then([](auto, random& r, vec4& x, auto& map) {
                 const ivec2 texel = ivec2(glm::floor(vec2(x))) + ivec2{r.below(3) - 1, r.below(3) - 1};
                 x.z = beside(static_cast<std::uint64_t>(r.below(4)) * 2 % 3, umbrage::fetch_clamped(map, texel).x);
             })},
            {"zero", one_of_three([](std::uint64_t i, random&) { return signed_by(i, 0.0f); })},
            {"one", one_of_three([](std::uint64_t i, random&) { return beside(i, 1.0f); })},
            {"out of range", one_of_three([](std::uint64_t i, random& r) {
                 return i % 4 == 0 ? beside(i / 4, i % 8 ? 32768.0f : -32768.0f)
                                   : signed_by(i, power_of_two(r.between(0.0f, 60.0f)));
             })},
            {"denormal", one_of_three(denormal)},
            {"NaN", one_of_three(not_a_number)},
            {"infinity", one_of_three([](std::uint64_t i, random&) { return infinity(i); })}};
}

std::vector<input_class> whole_texels() {
    return {{"random",
             [](auto, random& r, sample& s) {
                 for (int c = 0; c < 2; ++c) s.x[0][c] = static_cast<float>(r.below(s.map.size[c]));
             }},
            {"texel edges",
             [](std::uint64_t i, random& r, sample& s) {
                 for (int c = 0; c < 2; ++c)
                     s.x[0][c] = static_cast<float>(((i >> c & 1) ? s.map.size[c] : 0) + r.below(5) - 2);
             }},
            {"out of range", [](auto, random& r, sample& s) {
                 for (int c = 0; c < 2; ++c) s.x[0][c] = std::floor(r.between(-32768.0f, 32768.0f));
             }}};
}

namespace {

std::vector<texels> maps(float (*value)(random&),
                         std::initializer_list<ivec2> sizes = {ivec2(64, 64), ivec2(37, 21), ivec2(3, 2)}) {
    random r(2002);
    std::vector<texels> all;
    for (const ivec2 size : sizes) {
        all.emplace_back(size);
        for (vec4& t : all.back().texels())
            for (int c = 0; c < 4; ++c) t[c] = value(r);
    }
    return all;
}

}  // namespace

std::vector<texels> depth_maps() {
    return maps([](random& r) {
        switch (r.below(64)) {
            case 0: return 0.0f;
            case 1: return 1.0f;
            case 2: return std::numeric_limits<float>::quiet_NaN();
            case 3: return 1e-40f;
            default: return static_cast<float>(r.below(17)) / 16.0f;
        }
    });
}

std::vector<texels> plain_maps(std::initializer_list<ivec2> sizes) {
    return maps([](random& r) { return static_cast<float>(r.below(17)) / 16.0f; }, sizes);
}

std::vector<texels> packed_maps() {
    return maps([](random& r) { return static_cast<float>(r.below(256)) / 255.0f; });
}

}  // namespace parity
