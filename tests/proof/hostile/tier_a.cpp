// SPDX-License-Identifier: MIT
//
// Every tier A primitive over adversarial and random inputs, in every rounding mode: one digest a line,
//
//     primitive  class-of-inputs  mode  inputs  digest  digest-without-the-sign-of-zeros
//
// Compiled once for each compiler and set of flags; table.cpp compares what the builds print. Inputs are made from
// integers and bit patterns alone, so that the flags cannot change them.
#include <array>
#include <bit>
#include <cfenv>
#include <cinttypes>
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <xmmintrin.h>

#include <umbrage/depth/float_bits.hpp>
#include <umbrage/depth/rg_table.hpp>
#include <umbrage/depth/rgb24.hpp>
#include <umbrage/depth/three.hpp>
#include <umbrage/filter/box.hpp>
#include <umbrage/filter/four_tap.hpp>
#include <umbrage/filter/pcf_2x2.hpp>

namespace {

constexpr int block = 64;
constexpr int inputs = 1 << 15;      // of each primitive, for each class and mode
constexpr int few_inputs = 1 << 11;  // of those that take hundreds of texels each

float from_bits(std::uint32_t bits) { return std::bit_cast<float>(bits); }

// k / 255 rounded to nearest, by integers.
std::uint32_t unorm_bits(std::uint32_t k) {
    if (k == 0) return 0;
    std::uint32_t shift = 23, q = 0;
    for (; q < 1u << 23; ++shift) q = static_cast<std::uint32_t>((2 * (std::uint64_t(k) << shift) + 255) / 510);
    return ((150u - (shift - 1)) << 23) + (q - (1u << 23));
}

// FNV-1a over 32-bit words; rounding downwards, x - x is -0, so once more with every -0 taken for 0.
struct digest {
    static constexpr std::uint64_t basis = 14695981039346656037ull, prime = 1099511628211ull;
    std::uint64_t hash = basis, unsigned_zeros = basis;

    void word(std::uint32_t v) { word(v, v); }
    void word(std::uint32_t v, std::uint32_t w) {
        hash = (hash ^ v) * prime;
        unsigned_zeros = (unsigned_zeros ^ w) * prime;
    }
    void operator()(float v) {
        const auto bits = std::bit_cast<std::uint32_t>(v);
        word(bits, bits == 0x80000000u ? 0 : bits);
    }
    void operator()(bool v) { word(v); }
    void operator()(std::uint8_t v) { word(v); }
    template <int L, class T>
    void operator()(const glm::vec<L, T>& v) {
        for (int i = 0; i < L; ++i) (*this)(v[i]);
    }
};

enum class kind { ordinary, not_a_number, denormal };

struct source {
    kind what;
    bool flush;  // hand denormals over as zero: what a flushing machine makes of them
    std::uint64_t state = 0x9E3779B97F4A7C15ull;

    std::uint32_t next() {
        state = state * 6364136223846793005ull + 1442695040888963407ull;
        return static_cast<std::uint32_t>(state >> 32);
    }
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>((std::uint64_t(next()) * n) >> 32); }
    bool one_in(std::uint32_t n) { return below(n) == 0; }

    // The class's own kind of value in one draw of two, else what was asked for, without denormals.
    float classed(std::uint32_t bits) {
        const std::uint32_t sign = next() & 0x80000000u;
        if (what == kind::not_a_number && one_in(2))
            return from_bits(sign | (one_in(8) ? 0x7F800000u : 0x7F800001u + below(0x7FFFFF)));
        if (what == kind::denormal && one_in(2)) {
            const std::uint32_t tiny = 1 + below(0x7FFFFF);
            return from_bits(flush ? sign : sign | tiny);
        }
        return from_bits((bits & 0x7F800000u) == 0 ? bits & 0x80000000u : bits);
    }
    // Within a few ulp of `bits`, which is not near zero.
    std::uint32_t near(std::uint32_t bits) { return bits + below(5) - 2; }

    float any() {
        const std::uint32_t bits = next();
        return classed((bits & 0x7F800000u) == 0x7F800000u ? 0x3F800000u : bits);
    }
    // A depth: on or around a boundary between codes, around 0 and 1, or anything.
    float depth() {
        switch (below(4)) {
            case 0: return any();
            case 1: return classed(near(0x3F800000u));
            case 2: return classed(std::bit_cast<std::uint32_t>(float(below((1u << 24) + 1)) * 0x1p-24f));
            default: return classed(near(std::bit_cast<std::uint32_t>(float(1 + below(65536)) * 0x1p-16f)));
        }
    }
    // A stored depth or a receiver: few values, so that they often meet exactly or one ulp apart.
    float level() { return one_in(8) ? depth() : classed(near(std::bit_cast<std::uint32_t>(float(1 + below(4)) * 0.25f))); }
    // A texel coordinate: inside or beside an 8 x 8 map, on multiples of 1/256 and an ulp off, at the end of texel space.
    float coord() {
        switch (below(8)) {
            case 0: return any();
            case 1: return classed(near((next() & 0x80000000u) | 0x47000000u));
            case 2: return classed(std::bit_cast<std::uint32_t>(float(int(below(4096)) - 1024) * (1.0f / 256.0f)));
            case 3: return classed(std::bit_cast<std::uint32_t>(float(int(below(16)) - 4)));
            default: {
                const float v = float(int(below(12 * 65536)) - 2 * 65536) * 0x1p-16f;
                return classed(near(std::bit_cast<std::uint32_t>(v)));
            }
        }
    }
    glm::vec2 coords() {
        const float x = coord();
        return {x, coord()};
    }
    // What a texture gives for a byte: k / 255, one ulp off (as k times the rounded 1 / 255 is for 126 bytes) or up to 4096.
    // Values that no byte gives are not tried: rounding decides where between two bytes they fall.
    float read(std::uint32_t k) {
        const std::uint32_t bits = unorm_bits(k);
        if (k == 0) return 0.0f;
        return from_bits(one_in(2) ? bits + below(3) - 1 : bits + below(8193) - 4096);
    }
    float read() { return read(below(256)); }
    glm::ivec2 texel() {
        const int x = int(below(16)) - 4;
        return {x, int(below(16)) - 4};
    }
    float edge() { return float(below(3)) * 0.5f; }
    template <int L>
    glm::vec<L, std::uint8_t> bytes() {
        glm::vec<L, std::uint8_t> v(0);
        for (int i = 0; i < L; ++i) v[i] = static_cast<std::uint8_t>(below(256));
        return v;
    }
    template <int L>
    glm::vec<L, float> reads() {
        glm::vec<L, float> v(0.0f);
        for (int i = 0; i < L; ++i) v[i] = read();
        return v;
    }
};

struct look_up {  // what a filter is called with
    glm::vec2 a, b, c, d;
    float receiver;
    int radius;
};

struct suite {
    kind what;
    bool flush;
    std::string_view mode;

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
        constexpr std::array names{"ordinary", "nan", "denormal"};
        std::printf("%s %s %s %d %016" PRIx64 " %016" PRIx64 "\n", name, flush ? "flushed" : names[std::size_t(what)],
                    mode.data(), count, sum.hash, sum.unsigned_zeros);
    }

    template <int Bits>
    void rg() const {
        using namespace umbrage;
        static const auto table = [] {
            std::vector<glm::u8vec2> t(std::size_t(1) << Bits);
            for (std::uint32_t x = 0; x < t.size(); ++x)
                t[x] = {static_cast<std::uint8_t>(x & 0xFF), static_cast<std::uint8_t>((x >> 8) << (16 - Bits))};
            return t;
        }();
        const auto name = [](std::string_view pattern) {
            std::string s(pattern);
            return s.replace(s.find('$'), 1, std::to_string(Bits));
        };
        run(name("encode_rg$").c_str(), inputs, [](source& s) { return s.depth(); }, encode_rg<Bits, float>);
        run(name("encode_rg$_table").c_str(), inputs, [](source& s) { return s.depth(); }, [&](float d) {
            return encode_rg_table<Bits>([&](int x) { return table[std::size_t(x)]; }, d);
        });
        run(name("decode_rg$").c_str(), inputs,
            [](source& s) { return std::pair{s.reads<2>(), s.edge()}; },
            [](const auto& in) { return decode_rg<Bits>(in.first, in.second); });
    }

    void all() const;
};

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
    run("saturate", inputs, depth, saturate<float>);
    run("to_unorm", inputs, [](source& s) { return float(s.below(256)); }, [](float k) { return to_unorm(k); });
    run("from_unorm", inputs, [](source& s) { return s.read(); }, [](float c) { return from_unorm(c); });

    rg<9>(), rg<10>(), rg<11>(), rg<12>(), rg<13>(), rg<14>(), rg<15>(), rg<16>();

    run("encode_rgb24", inputs, depth, encode_rgb24<float>);
    run("decode_rgb24", inputs,
        [](source& s) { return std::pair{s.reads<3>(), float(s.below(2))}; },
        [](const auto& in) { return decode_rgb24(in.first, in.second); });
    run("encode_float_bits", inputs, any, encode_float_bits);
    run("decode_float_bits", inputs, [](source& s) { return s.reads<4>(); },
        [](glm::vec4 c) { return decode_float_bits(c); });
    run("encode_three_legacy_repaired", inputs, depth, encode_three_legacy_repaired<float>);

    image<float> map({8, 8});
    source levels{what, flush, 1};
    for (float& texel : map.texels()) texel = levels.level();
    const auto fetch = clamped(map);
    const auto texel = [](source& s) { return s.texel(); };
    run("fetch_clamped", inputs, texel, [&](glm::ivec2 t) { return fetch_clamped(std::as_const(map).view(), t); });
    run("fetch_bordered", inputs, texel, [&](glm::ivec2 t) { return fetch_bordered(std::as_const(map).view(), t, 1.0f); });
    run("fetch_depth", inputs, texel, [&](glm::ivec2 t) { return fetch_depth(fetch, t); });

    run("inside_texel_space", inputs, [](source& s) { return s.coords(); },
        [](glm::vec2 c) { return inside_texel_space(c); });
    run("compare", inputs, pair, [](glm::vec2 v) { return compare(v.x, v.y); });
    run("compare_greater_equal", inputs, pair, [](glm::vec2 v) { return compare(v.x, v.y, greater_equal{}); });

    const auto draw = [](source& s) {
        look_up l;
        l.a = s.coords(), l.b = s.coords(), l.c = s.coords(), l.d = s.coords();
        l.receiver = s.level();
        l.radius = int(s.below(11)) - 1;
        return l;
    };
    run("hard", inputs, draw, [&](const look_up& l) { return hard(fetch, l.a, l.receiver); });
    run("four_tap", inputs, draw, [&](const look_up& l) { return four_tap(fetch, l.a, l.b, l.c, l.d, l.receiver); });
    run("pcf_2x2", inputs, draw, [&](const look_up& l) { return pcf_2x2(fetch, l.a, l.receiver); });
    run("box_count", few_inputs, draw, [&](const look_up& l) { return box_count(fetch, l.a, l.receiver, l.radius); });
    run("box_scale", few_inputs, draw, [](const look_up& l) { return box_scale<float>(l.radius); });

    // Written, stored, read back: the byte must come through a store that rounds or truncates.
    for (const auto store : {unorm_store::rounds, unorm_store::truncates})
        run(store == unorm_store::rounds ? "stored_by_rounding" : "stored_by_truncating", inputs,
            [](source& s) { return s.bytes<2>(); },
            [store](glm::u8vec2 k) { return store_unorm8(to_unorm(glm::vec2(k)), store); });
}

// What the docstrings say of NaN, said to this build alone: is_nan tests bits, so that -ffast-math must leave it.
bool nan_promises_hold() {
    using namespace umbrage;
    const auto lit = [](glm::ivec2) { return 1.0f; };
    source from{kind::ordinary, false};
    for (int i = 0; i < 4096; ++i) {
        const float nan = from_bits((from.next() & 0x80000000u) | (0x7F800001u + from.below(0x7FFFFF)));
        const auto nowhere = [nan](glm::ivec2) { return nan; };
        const glm::vec2 middle(4.0f, 4.0f), astray = from.one_in(2) ? glm::vec2(nan, 4.0f) : glm::vec2(4.0f, nan);
        const bool hold =
            is_nan(nan) && !is_finite(nan) && saturate(nan) == 1.0f && encode_rg<11>(nan) == encode_rg<11>(1.0f) &&
            encode_rgb24(nan) == encode_rgb24(1.0f) && !less_equal{}(nan, 1.0f) && !less_equal{}(0.0f, nan) &&
            !greater_equal{}(nan, 0.0f) && !greater_equal{}(1.0f, nan) && !inside_texel_space(astray) &&
            hard(nowhere, astray, nan) == 1.0f && hard(lit, middle, nan) == 0.0f && hard(nowhere, middle, 0.0f) == 0.0f &&
            pcf_2x2(nowhere, astray, nan) == 1.0f && pcf_2x2(lit, middle, nan) == 0.0f &&
            pcf_2x2(nowhere, middle, 0.0f) == 0.0f && box_count(nowhere, astray, nan, 1) == 9.0f &&
            box_count(lit, middle, nan, 1) == 0.0f && box_count(nowhere, middle, 0.0f, 1) == 0.0f &&
            four_tap(lit, astray, middle, middle, middle, nan) == 0.25f;
        if (!hold) return false;
    }
    return true;
}

}  // namespace

int main() {
    constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040;
    const struct {
        const char* name;
        int rounding;
        bool flushes;
    } modes[] = {{"nearest", FE_TONEAREST, false}, {"upward", FE_UPWARD, false},     {"downward", FE_DOWNWARD, false},
                 {"to-zero", FE_TOWARDZERO, false}, {"flushing", FE_TONEAREST, true}};
    for (const auto& mode : modes) {
        std::fesetround(mode.rounding);
        const unsigned rest = _mm_getcsr() & ~(flush_to_zero | denormals_are_zero);
        _mm_setcsr(mode.flushes ? rest | flush_to_zero | denormals_are_zero : rest);
        for (const kind what : {kind::ordinary, kind::not_a_number, kind::denormal}) suite{what, false, mode.name}.all();
        if (!nan_promises_hold()) return 1;
    }
    std::fesetround(FE_TONEAREST);
    _mm_setcsr(_mm_getcsr() & ~(flush_to_zero | denormals_are_zero));
    suite{kind::denormal, true, "nearest"}.all();
}
