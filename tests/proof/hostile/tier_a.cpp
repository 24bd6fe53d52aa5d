// SPDX-License-Identifier: MIT
//
// Every tier A primitive over adversarial and random inputs, in every rounding mode: one digest a line. Compiled once
// for each compiler and set of flags; table.cpp compares what the builds print.
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <umbrage/bias/slope.hpp>
#include <umbrage/depth/encodings.hpp>
#include <umbrage/depth/foreign/ps14.hpp>
#include <umbrage/depth/rg_table.hpp>
#include <umbrage/filter/bounds_lit.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/filter/pcf/four_tap.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/filter/prefiltered/exp2.hpp>

#include "light.hpp"
#include "soft_shadows.hpp"
#include "debug.hpp"

namespace {

using namespace hostile;

constexpr int block = 64;
#ifdef SAMPLE
constexpr int inputs = 1 << 12;  // inputs of each primitive, for each class and mode
#else
constexpr int inputs = 1 << 15;
#endif
constexpr int few_inputs = inputs / 16;  // inputs of primitives that read many texels each

struct look_up {  // arguments of a filter
    glm::vec2 a, b, c, d;
    float receiver;
    int radius;
};

struct suite : setting {
    // Inputs and outputs go through arrays, so that compilers may vectorise the primitive.
    template <class Draw, class Op>
    void run(const char* name, int count, Draw draw, Op op) const {
        source from{what, flush};
        std::array<decltype(draw(from)), block> in;
        std::array<decltype(op(in[0])), block> out;
        digest sum;
        for (int done = 0; done < count; done += block) {
            for (auto& x : in) x = draw(from);
            for (int i = 0; i < block; ++i) out[std::size_t(i)] = op(in[std::size_t(i)]);
            for (const auto& y : out) sum(y);
        }
        print(name, count, sum);
    }

    template <int Bits>
    void rg_table() const {
        using namespace umbrage;
        static const auto table = [] {
            std::vector<glm::u8vec2> t(std::size_t(1) << Bits);
            for (std::uint32_t x = 0; x < t.size(); ++x)
                t[x] = {static_cast<std::uint8_t>(x & 0xFF), static_cast<std::uint8_t>((x >> 8) << (16 - Bits))};
            return t;
        }();
        run(
            glsl::encode_rg_table<Bits>.name.data(), inputs, [](source& s) { return s.depth(); },
            [&](float d) { return encode_rg_table<Bits>([&](int x) { return table[std::size_t(x)]; }, d); });
    }

    void encodings() const;
    void all() const;
};

/// A channel as sampled. Of 8 bits the read may be thousands of ulp off, of 10 and 16 bits one at most, as hundreds
/// would be another channel.
float channel(source& s, int bits) {
    if (bits == 8) return s.read();
    const std::uint32_t most = (1u << bits) - 1, read = hostile::unorm_bits(s.below(most + 1), most);
    return from_bits(read > 0 ? read + s.below(3) - 1 : 0);
}

/// The encodings of the list that have a choice of edge, and channels of 10 and 16 bits.
void suite::encodings() const {
    using namespace umbrage;
    for_each_encoding([&](auto encoding) {
        using type = decltype(encoding);
        if constexpr (has_edge<type>) {
            run(
                std::string(type::writer->name).c_str(), inputs, [](source& s) { return s.depth(); },
                [](float d) { return type{}.encode(d); });
            run(
                std::string(type::reader->name).c_str(), inputs,
                [](source& s) {
                    glm::vec4 read(0);
                    for (int i = 0; i < type::target::channels; ++i) read[i] = channel(s, type::target::bits);
                    return std::pair{read, type::bits < 24 ? s.edge() : float(s.below(2))};
                },
                [](const auto& in) {
                    type at_edge;
                    at_edge.edge = in.second;
                    return at_edge.decode_sampled(in.first);
                });
        }
    });
    const auto tens = [](source& s) { return glm::vec3{channel(s, 10), channel(s, 10), channel(s, 10)}; };
    run(
        "to_unorm10", inputs, [](source& s) { return float(s.below(1024)); }, [](float k) { return to_unorm<10>(k); });
    run(
        "to_unorm16", inputs, [](source& s) { return float(s.below(65536)); }, [](float k) { return to_unorm<16>(k); });
    run("from_unorm10", inputs, tens, [](glm::vec3 c) { return from_unorm<10>(c); });
    run(
        "from_unorm16", inputs, [](source& s) { return channel(s, 16); }, [](float c) { return from_unorm<16>(c); });
}

void suite::all() const {
    using namespace umbrage;
    const auto depth = [](source& s) { return s.depth(); };
    const auto any = [](source& s) { return s.any(); };
    const auto pair = [](source& s) {
        const float receiver = s.level();
        return glm::vec2(receiver, s.level());
    };

    run("is_nan", inputs, any, [](float v) { return is_nan(v); });
    run("is_finite", inputs, any, [](float v) { return is_finite(v); });
    run("saturate", inputs, depth, [](float v) { return glm::vec2(saturate(v), saturate(v, 0.0f)); });
    run(
        "texel_inside", inputs,
        [](source& s) {
            return glm::ivec4{int(s.below(64)) + 1, int(s.below(64)) + 1, int(s.below(256)) - 128,
                              int(s.below(256)) - 128};
        },
        [](glm::ivec4 v) {
            return glm::vec2(texel_inside({v.x, v.y}, {v.z, v.w}));
        });
    run(
        "to_unorm", inputs, [](source& s) { return float(s.below(256)); }, [](float k) { return to_unorm(k); });
    run(
        "from_unorm", inputs, [](source& s) { return s.read(); }, [](float c) { return from_unorm(c); });

    encodings();
    rg_table<9>(), rg_table<10>(), rg_table<11>(), rg_table<12>(), rg_table<13>(), rg_table<14>(), rg_table<15>(),
        rg_table<16>();
    run(
        "power_of_two", inputs, [](source& s) { return float(s.below(128)) - 64.0f; },
        [](float n) { return power_of_two(n); });
    run("exp2_steps", inputs, any, [](float y) { return exp2_steps(y); });
    run("fixed_ps14", inputs, any, [](float v) { return fixed_ps14(v); });
    run(
        "decode_fixed_ps14", inputs, [](source& s) { return s.reads<2>(); },
        [](glm::vec2 c) { return decode_fixed_ps14(c); });
    run("encode_float_bits", inputs, any, [](float v) { return encode_float_bits(v); });
    run(
        "decode_float_bits", inputs, [](source& s) { return s.reads<4>(); },
        [](glm::vec4 c) { return decode_float_bits(c); });
    run("encode_threejs_legacy_repaired", inputs, depth, [](float d) { return encode_threejs_legacy_repaired(d); });

    image<float> map({8, 8});
    source levels{what, flush, 1};
    for (float& texel : map.texels()) texel = levels.level();
    const auto fetch = clamped(map);
    const auto texel = [](source& s) { return s.texel(); };
    run("fetch_clamped", inputs, texel, [&](glm::ivec2 t) { return fetch_clamped(std::as_const(map).view(), t); });
    run("fetch_bordered", inputs, texel,
        [&](glm::ivec2 t) { return fetch_bordered(std::as_const(map).view(), t, 1.0f); });
    run("fetch_depth", inputs, texel, [&](glm::ivec2 t) { return fetch_depth(fetch, t); });
    run("texel", inputs, texel, [&](glm::ivec2 t) { return umbrage::texel(std::as_const(map).view(), t & 7); });
    run("inside_map", inputs, texel, [](glm::ivec2 t) { return inside_map({8, 8}, t); });
    const auto compared_texel = [](source& s) {
        const glm::ivec2 t = s.texel();
        return std::pair{t, s.level()};
    };
    run("lit", inputs, compared_texel, [&](const auto& in) { return lit(fetch, in.first, in.second); });
    run("lit_2x2", inputs, compared_texel, [&](const auto& in) { return lit_2x2(fetch, in.first, in.second); });
    run(
        "beyond_far_plane", inputs, [](source& s) { return s.level(); },
        [](float v) { return glm::vec2(beyond_far_plane(v), beyond_far_plane(v, greater_equal{})); });
    run(
        "within_far_plane", inputs, [](source& s) { return s.level(); },
        [](float v) { return glm::vec2(within_far_plane(v), within_far_plane(v, greater_equal{})); });
    run(
        "cleared_depth", inputs, [](source& s) { return s.one_in(2); },
        [](bool back) { return cleared_depth(back ? depth_direction::reversed : depth_direction::forward); });
    each_of_light([&](const char* name, int of, auto draw_one, auto op) { run(name, inputs / of, draw_one, op); },
                  fetch);

    run(
        "inside_texel_space", inputs, [](source& s) { return s.coords(); },
        [](glm::vec2 c) { return inside_texel_space(c); });
    run(
        "map_covers", inputs, [](source& s) { return s.coords(); },
        [](glm::vec2 c) { return map_covers(glm::vec2(8), c); });
    run("compare", inputs, pair, [](glm::vec2 v) { return compare(v.x, v.y); });
    run("compare_greater_equal", inputs, pair, [](glm::vec2 v) { return compare(v.x, v.y, greater_equal{}); });

    const auto draw = [](source& s) {
        look_up l;
        l.a = s.coords(), l.b = s.coords(), l.c = s.coords(), l.d = s.coords();
        l.receiver = s.level();
        l.radius = int(s.below(11)) - 1;
        return l;
    };
    run("in_filter_domain", inputs, draw, [](const look_up& l) { return in_filter_domain(l.a, l.receiver); });
    for_each_filter([&](auto filter) {
        if constexpr (requires { filter.direction = umbrage::depth_direction::forward; }) {
            if (filter.snippet->exactness != glsl::tier::a) return;
            const std::string name(filter.name);
            const int count = filter.reach() > 1.0f ? few_inputs : inputs;
            const auto filtered = [&](const look_up& l) { return filter(fetch, l.a, l.receiver); };
            run(name.c_str(), count, draw, filtered);
            filter.direction = depth_direction::reversed;
            run((name + "_reversed").c_str(), count, draw, filtered);
        }
    });
    run("four_tap_apart", inputs, draw,
        [&](const look_up& l) { return four_tap(fetch, l.a, l.b, l.c, l.d, l.receiver); });
    const auto window = [&](const char* name, const window_row& row) {
        run(name, few_inputs, draw, [&](const look_up& l) { return window_sum(fetch, l.a, l.receiver, row); });
    };
    window("window_sum3", tent_row<3>);
    window("window_sum5", castano_row<5>);
    window("window_sum7", castano_row<7>);
    run("bounds_lit", inputs, draw, [&](const look_up& l) {
        const auto bounds = [&](glm::ivec2 at) { return glm::vec2(fetch(at), fetch(at + 1)); };
        return bounds_lit(bounds, l.a, l.receiver, glm::vec2(639.0f, 1.0f / 512.0f));
    });
    run(  // integers: a zero may have either sign
        "disc_rotation", inputs, [](source& s) { return s.coords(); },
        [](glm::vec2 pixel) { return glm::uvec4(glm::ivec4(disc_rotation(pixel))); });
    run(
        "disc_tap", inputs,
        [](source& s) {
            const int x = int(s.below(1 << 24)) - (1 << 23), y = int(s.below(1 << 24)) - (1 << 23);
            const float wide = float(s.below(4096)), high = float(s.below(4096));
            const glm::vec4 turn = disc_rotation(glm::vec2(float(s.below(16)), 0.0f));
            const glm::vec2 point(glm::ivec2(disc_points<32>[s.below(32)]));
            return std::array{glm::vec4(x, y, point), turn, glm::vec4(wide, high, 0, 0)};
        },
        [](const auto& in) {
            return disc_tap(glm::vec2(in[0]), glm::vec2(in[0].z, in[0].w), in[1], glm::vec2(in[2]));
        });
    run("disc_radius", inputs, any, [](float v) { return disc_radius(v); });
    each_soft_shadow([&](const char* name, int of, auto draw_one, auto op) { run(name, inputs / of, draw_one, op); },
                     fetch);
    run("clamp_bias", inputs, any, [](float v) { return clamp_bias(v); });
    run("clamp_slope", inputs, any, [](float v) { return clamp_slope(v); });
    run("box_count", few_inputs, draw, [&](const look_up& l) { return box_count(fetch, l.a, l.receiver, l.radius); });
    run("box_scale", few_inputs, draw, [](const look_up& l) { return box_scale<float>(l.radius); });
    each_of_debug([&](const char* name, auto draw_one, auto op) { run(name, inputs, draw_one, op); });

    // Written, stored, read back: the byte must come through a store that rounds or truncates.
    for (const auto store : {unorm_store::rounds, unorm_store::truncates})
        run(
            store == unorm_store::rounds ? "stored_by_rounding" : "stored_by_truncating", inputs,
            [](source& s) { return s.bytes<2>(); },
            [store](glm::u8vec2 k) { return store_unorm(to_unorm(glm::vec2(k)), store); });
}

// Promises of the docstrings for NaN, checked in this build alone. is_nan tests bits, so -ffast-math keeps it.
bool nan_promises_hold() {
    using namespace umbrage;
    const auto lit = [](glm::ivec2) { return 1.0f; };
    source from{kind::ordinary, false};
    for (int i = 0; i < 4096; ++i) {
        const float nan = from_bits((from.next() & 0x80000000u) | (0x7F800001u + from.below(0x7FFFFF)));
        const auto nowhere = [nan](glm::ivec2) { return nan; };
        const glm::vec2 middle(4.0f, 4.0f), astray = from.one_in(2) ? glm::vec2(nan, 4.0f) : glm::vec2(4.0f, nan);
        const bool hold = is_nan(nan) && !is_finite(nan) && saturate(nan) == 1.0f &&
                          encode_rg<11>(nan) == encode_rg<11>(1.0f) && encode_rgb24(nan) == encode_rgb24(1.0f) &&
                          !less_equal{}(nan, 1.0f) && !less_equal{}(0.0f, nan) && !greater_equal{}(nan, 0.0f) &&
                          !greater_equal{}(1.0f, nan) && !inside_texel_space(astray) &&
                          hard(nowhere, astray, nan) == 1.0f && hard(lit, middle, nan) == 0.0f &&
                          hard(nowhere, middle, 0.0f) == 0.0f && pcf_2x2(nowhere, astray, nan) == 1.0f &&
                          pcf_2x2(lit, middle, nan) == 0.0f && pcf_2x2(nowhere, middle, 0.0f) == 0.0f &&
                          box_count(nowhere, astray, nan, 1) == 9.0f && box_count(lit, middle, nan, 1) == 0.0f &&
                          box_count(nowhere, middle, 0.0f, 1) == 0.0f &&
                          four_tap(nowhere, astray, middle, middle, middle, nan) == 1.0f;
        if (!hold) return false;
    }
    return true;
}

}  // namespace

int main() {
    bool hold = true;
    for_each_setting([&](const setting& s) {
        suite{s}.all();
        hold = hold && nan_promises_hold();
    });
    return hold ? 0 : 1;
}
