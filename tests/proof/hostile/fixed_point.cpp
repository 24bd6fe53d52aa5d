// SPDX-License-Identifier: MIT
//
// The literal r / 2^M + g in the Radeon 8500's fixed point, for 9 to 14 bits: where codes stay distinct, where they
// merge, and what the shadow test makes of it, so that the sample's choice of 11 bits can be judged.
//
// The machine: pixel shader 1.4 on numbers with 12 fractional bits in [-8, 8). An 8-bit channel k becomes the nearest
// multiple of 2^-12 to k / 255; the _d2, _d4, _d8 modifiers (further ones here by going on) shift right; an addition
// is exact. Whether the shift drops bits or rounds is not known here, so both are tabled.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <tuple>
#include <vector>

namespace {

constexpr int one = 4096;

int from_unorm8(int k) { return (k * one * 2 + 255) / 510; }

// r / 2^m + g for code x of 8 + m bits.
int unpacked(int x, int m, bool rounds) {
    const int r = from_unorm8(x & 0xFF), g = from_unorm8((x >> 8) << (8 - m));
    return ((r + (rounds ? (1 << m) >> 1 : 0)) >> m) + g;
}

struct row {
    int bits = 0;
    bool rounds = false;
    int distinct = 0;         // values that the codes unpack to
    int first_merge = -1;     // least code that unpacks to its predecessor's value
    int falls = 0;            // codes that unpack below their predecessor
    int wrong_codes = 0;      // pairs (receiver, stored) of codes, both unpacked, for which <= comes out wrong
    int reach = 0;            // greatest number of codes that such a receiver lies behind the stored one
    int wrong_receivers = 0;  // receivers in the middle of a code, interpolated as depth 256 / 255, wrong against the
                              // code after or before theirs
    double worst = 0.0;       // greatest distance from x / (255 * 2^M), in codes

    bool operator==(const row& other) const {  // the counts; worst is for people
        const auto counts = [](const row& r) {
            return std::tuple(r.bits, r.rounds, r.distinct, r.first_merge, r.falls, r.wrong_codes, r.reach,
                              r.wrong_receivers);
        };
        return counts(*this) == counts(other);
    }
};

row measure(int m, bool rounds) {
    const int codes = 1 << (8 + m);
    row r{.bits = 8 + m, .rounds = rounds};
    std::vector<int> u(static_cast<std::size_t>(codes));
    for (int x = 0; x < codes; ++x) u[std::size_t(x)] = unpacked(x, m, rounds);

    std::vector<int> sorted = u;
    std::sort(sorted.begin(), sorted.end());
    r.distinct = int(std::unique(sorted.begin(), sorted.end()) - sorted.begin());

    const double step = double(one) / (255 << m);  // of a code, in units of 2^-12
    std::vector<int> seen(std::size_t(3 * one));
    int latest = 0;
    for (int x = 0; x < codes; ++x) {
        const int v = u[std::size_t(x)];
        if (x > 0) {
            r.falls += v < u[std::size_t(x - 1)];
            if (v == u[std::size_t(x - 1)] && r.first_merge < 0) r.first_merge = x;
        }
        r.worst = std::max(r.worst, std::abs(v - x * step) / step);
        // receiver x behind stored y < x: lit all the same if v <= u[y]; and in front of y > x: dark if v > u[y]
        for (int w = v; w <= latest; ++w) r.wrong_codes += seen[std::size_t(w)];
        for (int y = std::max(0, x - 64); y < x; ++y)
            if (v <= u[std::size_t(y)]) {
                r.reach = std::max(r.reach, x - y);
                r.wrong_codes += v < u[std::size_t(y)];  // the pair the other way round is wrong too
            }
        ++seen[std::size_t(v)];
        latest = std::max(latest, v);
        // a receiver of its own in the middle of code x: lit against x + 1, dark against x - 1; quantized to 2^-12
        const int receiver = int((x + 0.5) * step + 0.5);
        if (x + 1 < codes) r.wrong_receivers += !(receiver <= u[std::size_t(x + 1)]);
        if (x > 0) r.wrong_receivers += receiver <= u[std::size_t(x - 1)];
    }
    return r;
}

}  // namespace

TEST_CASE("decode_ps14: in s3.12 up to 12 bits stay distinct, 11 are the most that leave half a code to spare") {
    const row expected[] = {
        {9, false, 512, -1, 0, 0, 0, 0},         {9, true, 512, -1, 0, 0, 0, 0},
        {10, false, 1024, -1, 0, 0, 0, 0},       {10, true, 1024, -1, 0, 0, 0, 0},
        {11, false, 2048, -1, 0, 0, 0, 0},       {11, true, 2048, -1, 0, 0, 0, 0},
        {12, false, 4096, -1, 0, 0, 0, 28},      {12, true, 4096, -1, 0, 0, 0, 0},
        {13, false, 4113, 1, 0, 4094, 2, 2031},  {13, true, 4113, 2, 0, 4094, 2, 3951},
        {14, false, 4113, 1, 0, 24572, 4, 9199}, {14, true, 4113, 1, 0, 24538, 4, 12079},
    };
    std::printf("s3.12                          first         worst  wrong tests,  reach,  wrong tests,\n");
    std::printf("bits  shift      distinct      merge  falls  codes  both unpacked  codes  receiver interpolated\n");
    for (const row& known : expected) {
        const row r = measure(known.bits - 8, known.rounds);
        std::printf("%4d  %-7s %6d of %-6d %5d %6d %6.2f %14d %6d %13d\n", r.bits, r.rounds ? "rounds" : "drops",
                    r.distinct, 1 << r.bits, r.first_merge, r.falls, r.worst, r.wrong_codes, r.reach,
                    r.wrong_receivers);
        CHECK(r == known);
        CHECK((r.worst < 0.5) == (r.bits <= 11));
    }
}
