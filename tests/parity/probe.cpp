// SPDX-License-Identifier: MIT
#include "probe.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <umbrage/filter/pcf/pcf_2x2_hardware.hpp>

#include "compare.hpp"

namespace parity {
namespace {

constexpr std::size_t trials = 4096;

constexpr snippet nothing{.name = "nothing", .summary = {}, .source = "\n"};

/// Each operation has its own variable, since `precise` qualifies variables.
std::string expressions(int precise) {
    return umbrage::glsl::detail::filled(R"(
UMBRAGE_HIGHP vec4 umbrage_products(UMBRAGE_HIGHP vec4 v) {
    $pUMBRAGE_HIGHP float before = v.x * v.y + v.z;
    $pUMBRAGE_HIGHP float behind = v.z + v.x * v.y;
    $pUMBRAGE_HIGHP float less = v.x * v.y - v.w;
    $pUMBRAGE_HIGHP float behind_less = v.w - v.x * v.y;
    return vec4(before, behind, less, behind_less);
}
UMBRAGE_HIGHP vec4 umbrage_groups(UMBRAGE_HIGHP vec4 v, UMBRAGE_HIGHP vec4 w) {
    $pUMBRAGE_HIGHP float cancelled = (v.x + v.y) - v.x;
    $pUMBRAGE_HIGHP float late = (v.x + v.y) + v.z;
    $pUMBRAGE_HIGHP float scaled = (w.x * w.y) * w.z;
    return vec4(cancelled, late, scaled, 0.0);
}
)",
                                         {{'p', 0, precise ? "UMBRAGE_PRECISE " : ""}});
}
constexpr snippet plain{.name = "plain", .summary = {}, .source = {expressions, 0}};
constexpr snippet precise{.name = "precise", .summary = {}, .source = {expressions, 1}};
constexpr snippet in_mediump{.name = "low", .summary = {}, .source = R"(
mediump float umbrage_low(mediump float step) {
    return step + 1.0;
}
)"};

bool any(const std::vector<vec4>& results, vec4 expected) {
    return std::any_of(results.begin(), results.end(), [&](vec4 r) { return r != expected; });
}

/// Runs a call. Values come from textures, so that no compiler folds them.
struct asker {
    backend& b;
    dialect d;

    [[nodiscard]] std::vector<vec4> operator()(const snippet& s, std::string call, std::vector<vec4> x0,
                                               std::vector<vec4> x1 = {}, target output = target::rgba32f) const {
        return run_once(b, d, {.primitive = &s, .call = std::move(call), .output = output},
                        {std::move(x0), std::move(x1)});
    }
    [[nodiscard]] vec4 one(std::string call, vec4 x0) const { return (*this)(nothing, std::move(call), {x0}).front(); }
    /// Results of an entry with a bound map; empty where it cannot run.
    [[nodiscard]] std::vector<vec4> bound(entry e, std::vector<vec4> x0) const {
        if (!e.runs_in(d) || !b.obstacle(e).empty()) return {};
        return run_once(b, d, std::move(e), {std::move(x0)});
    }
};

/// With c = -(a * b) rounded, a * b + c is zero. Fused, it is the rounding error.
bool fuses(const asker& ask, const snippet& s) {
    random r(1);
    std::vector<vec4> v(trials);
    for (vec4& one : v) {
        const float a = r.between(1.0f, 2.0f), b = r.between(1.0f, 2.0f);
        one = {a, b, -(a * b), a * b};
    }
    return any(ask(s, "umbrage_products(x0)", std::move(v)), vec4(0.0f));
}

bool reassociates(const asker& ask, const snippet& s) {
    const vec4 v(0x1p24f, 1.0f, 1.0f, 0.0f), w(0x1p100f, 0x1p100f, 0x1p-100f, 0.0f);
    const vec4 got = ask(s, "umbrage_groups(x0, x1)", {v}, {w}).front();
    return got.x != 0.0f || got.y != 0x1p24f || !std::isinf(got.z);
}

std::vector<vec4> random_values(float lowest_exponent, float highest_exponent, float low, float high) {
    random r(2);
    std::vector<vec4> all(trials);
    const auto positive = [&] { return std::exp2(r.between(lowest_exponent, highest_exponent)); };
    for (vec4& v : all) v = {positive(), positive(), r.between(low, high), 0.0f};
    return all;
}

/// Largest error in ulp; `exact` gives the result in double.
std::int64_t worst(const std::vector<vec4>& in, const std::vector<vec4>& got, int channel, auto exact) {
    std::int64_t ulp = 0;
    for (std::size_t i = 0; i < got.size(); ++i)
        ulp = std::max(ulp, ulp_distance(static_cast<float>(exact(double(in[i].x), double(in[i].y), double(in[i].z))),
                                         got[i][channel]));
    return ulp;
}

void ask_errors(const asker& ask, observed_arithmetic& a) {
    const auto near = random_values(-4.0f, 4.0f, -64.0f, 64.0f), far = random_values(-60.0f, 60.0f, -120.0f, 120.0f);
    const auto sums = ask(nothing, "vec4(x0.x + x0.z, x0.x * x0.z, x0.x - x0.y, 0.0)", near);
    a.sum_ulp = std::max(worst(near, sums, 0, [](double x, double, double z) { return x + z; }),
                         worst(near, sums, 2, [](double x, double y, double) { return x - y; }));
    a.product_ulp = worst(near, sums, 1, [](double x, double, double z) { return x * z; });
    const auto rest = ask(nothing, "vec4(x0.x / x0.y, sqrt(x0.x), inversesqrt(x0.x), exp2(x0.z))", far);
    a.quotient_ulp = worst(far, rest, 0, [](double x, double y, double) { return x / y; });
    a.root_ulp = worst(far, rest, 1, [](double x, double, double) { return std::sqrt(x); });
    a.inverse_root_ulp = worst(far, rest, 2, [](double x, double, double) { return 1.0 / std::sqrt(x); });
    a.exp2_ulp = worst(far, rest, 3, [](double, double, double z) { return std::exp2(z); });
}

void ask_special_values(const asker& ask, observed_arithmetic& a) {
    constexpr float infinite = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
    const vec4 in = ask.one("vec4(x0.x * x0.y, x0.x + x0.z, 0.0, 0.0)", {0x1p-130f, 0x1p24f, 0x1p-126f, 0.0f});
    a.flushes_inputs = in.x != 0x1p-106f || in.y != 0x1.1p-126f;
    const vec4 out = ask.one("vec4(x0.x * x0.y, x0.z - x0.x, 0.0, 0.0)", {0x1p-126f, 0.5f, 0x1.8p-126f, 0.0f});
    a.flushes_results = out.x != 0x1p-127f || out.y != 0x1p-127f;
    const vec4 zero = ask.one("vec4(-x0.x, x0.y * x0.z, x0.y + x0.y, x0.y)", {0.0f, -0.0f, 1.0f, 0.0f});
    a.keeps_minus_zero = std::signbit(zero.x) && std::signbit(zero.y) && std::signbit(zero.z) && std::signbit(zero.w);
    const vec4 huge = ask.one("vec4(x0.x * x0.y, -x0.x * x0.y, x0.z + x0.x, x0.z)", {3e38f, 10.0f, infinite, 0.0f});
    a.keeps_infinity = huge == vec4(infinite, -infinite, infinite, infinite);
    const vec4 seen =
        ask.one("vec4(x0.x != x0.x ? 1.0 : 0.0, !(x0.x < x0.y) ? 1.0 : 0.0, 0.0, 0.0)", {nan, 1.0f, 0.0f, 0.0f});
    a.sees_nan_unequal = seen.x == 1.0f;
    a.sees_nan_not_less = seen.y == 1.0f;
    if (ask.d.in == dialect::glsl && ask.d.of_glsl >= version::v130)
        a.sees_nan_isnan = ask.one("vec4(isnan(x0.x) ? 1.0 : 0.0)", vec4(nan)).x == 1.0f;
}

/// Counts the exact sums of 1 + 1/2, 1 + 1/4, .., and the leading 1.
int significand(const std::vector<vec4>& sums) {
    int bits = 1;
    while (bits <= static_cast<int>(sums.size()) &&
           sums[static_cast<std::size_t>(bits - 1)].x == 1.0f + std::ldexp(1.0f, -bits))
        ++bits;
    return bits;
}

void ask_bits(const asker& ask, observed_arithmetic& a) {
    std::vector<vec4> steps;
    for (int k = 1; k <= 23; ++k) steps.push_back({1.0f, std::ldexp(1.0f, -k), 0.0f, 0.0f});
    a.highp_bits = significand(ask(nothing, "vec4(x0.x + x0.y)", steps));
    const std::string_view of_glsl = directive(ask.d.of_glsl);
    const bool has_mediump = of_glsl == "100" || of_glsl.ends_with("es") || ask.d.of_glsl == version::vulkan;
    if (ask.d.in == dialect::glsl && has_mediump)
        a.mediump_bits = significand(ask(in_mediump, "vec4(umbrage_low(x0.y))", steps));
}

void ask_bytes(const asker& ask, observed_arithmetic& a) {
    std::vector<vec4> between, codes;
    for (int k = 0; k < 255; ++k)
        for (const float part : {0.4f, 0.6f}) between.emplace_back((static_cast<float>(k) + part) / 255.0f);
    const auto stored = ask(nothing, "x0", between, {}, target::rgba8);
    const auto all = [&](bool up) {
        for (std::size_t i = 0; i < stored.size(); ++i)
            if (stored[i] != vec4(static_cast<float>(i / 2 + (up ? i % 2 : 0)))) return false;
        return true;
    };
    using enum observed_arithmetic::store;
    a.unorm8_store = all(true) ? rounds : all(false) ? truncates : neither;

    entry e{.primitive = &umbrage::glsl::fetch_clamped,
            .call = "umbrage_fetch_clamped(map, map_size, vec2(x0.x, x0.y))",
            .maps = {texels({256, 1})},
            .bound = {{.name = "map", .bytes = true}}};
    for (int k = 0; k < 256; ++k) {
        e.maps.front()[{k, 0}] = vec4(static_cast<float>(k) / 255.0f);
        codes.emplace_back(static_cast<float>(k), 0.0f, 0.0f, 0.0f);
    }
    const auto read = ask.bound(std::move(e), codes);
    for (std::size_t k = 0; k < read.size(); ++k) {
        const float exact = static_cast<float>(static_cast<double>(k) / 255.0);
        a.unorm8_read_ulp = std::max(a.unorm8_read_ulp.value_or(0), ulp_distance(exact, read[k].x));
    }
}

/// Counts the weights between the center of a texel in shadow and that of a lit one: 2^bits.
void ask_weights(const asker& ask, observed_arithmetic& a) {
    constexpr int bits = 14;
    entry e{.primitive = &umbrage::glsl::lit_between,
            .call = "vec4(umbrage_lit_between(map, map_size, vec2(x0.x, 0.5), vec2(0.0, 0.0), 0.5))",
            .maps = {texels({2, 1})},
            .bound = {{.name = "map",
                       .as = {.texture = umbrage::glsl::texture::shadow, .outside = umbrage::outside_map::clamped},
                       .linear = true}}};
    e.maps.front()[{1, 0}] = vec4(1.0f);
    std::vector<vec4> at;
    for (int i = 0; i < 1 << bits; ++i) at.emplace_back(0.25f + std::ldexp(static_cast<float>(i), -bits - 1));
    std::set<float> weights;
    for (const vec4 w : ask.bound(std::move(e), std::move(at))) weights.insert(w.x);
    if (!weights.empty()) a.weight_bits = static_cast<int>(std::lround(std::log2(static_cast<double>(weights.size()))));
}

std::string text_of(observed_arithmetic::liberty l, const std::string& taken, const std::string& not_taken) {
    if (!l.plain && !l.precise) return not_taken;
    return taken + (l.precise ? "" : ", but not where it is precise");
}

std::string either(bool yes, const char* one, const char* other) { return yes ? one : other; }

}  // namespace

observed_arithmetic probe(backend& b, dialect d) {
    const asker ask{b, d};
    observed_arithmetic a;
    a.fuses = {fuses(ask, plain), fuses(ask, precise)};
    a.reassociates = {reassociates(ask, plain), reassociates(ask, precise)};
    ask_errors(ask, a);
    ask_special_values(ask, a);
    ask_bits(ask, a);
    ask_bytes(ask, a);
    ask_weights(ask, a);
    return a;
}

std::vector<std::string> described(const observed_arithmetic& a) {
    const auto ulp = [](std::int64_t n) {
        return n == std::numeric_limits<std::int64_t>::max() ? "NaN" : std::to_string(n) + " ulp";
    };
    const auto bits = [](std::optional<int> n) { return n ? std::to_string(*n) + " bits" : "not probed"; };
    const std::string flushed[] = {"kept", "flushed as inputs", "flushed as results", "flushed as inputs and results"};
    const std::string stores[] = {"round", "truncate", "neither round nor truncate"};
    const auto nan_by = [](const char* how, bool sees) { return std::string(how) + (sees ? " yes" : " no"); };
    return {
        "a * b + c: " + text_of(a.fuses, "fused", "not fused"),
        "(a + b) - a: " + text_of(a.reassociates, "reassociated", "as written"),
        "errors: sum " + ulp(a.sum_ulp) + ", product " + ulp(a.product_ulp) + ", division " + ulp(a.quotient_ulp) +
            ", sqrt " + ulp(a.root_ulp) + ", inversesqrt " + ulp(a.inverse_root_ulp) + ", exp2 " + ulp(a.exp2_ulp),
        "denormals: " + flushed[(a.flushes_inputs ? 1 : 0) + (a.flushes_results ? 2 : 0)],
        "-0: " + either(a.keeps_minus_zero, "kept", "lost"),
        "infinity: " + either(a.keeps_infinity, "kept", "lost"),
        "NaN seen by: " + nan_by("a != a", a.sees_nan_unequal) + ", " + nan_by("!(a < b)", a.sees_nan_not_less) +
            ", isnan " + (a.sees_nan_isnan ? either(*a.sees_nan_isnan, "yes", "no") : "not probed"),
        "UNORM8: reads " + (a.unorm8_read_ulp ? ulp(*a.unorm8_read_ulp) + " from k / 255" : "not probed") +
            ", stores " + stores[static_cast<int>(a.unorm8_store)],
        "significands: highp " + bits(a.highp_bits) + ", mediump " + bits(a.mediump_bits),
        "comparison sampler: weights " +
            (a.weight_bits ? (*a.weight_bits >= 14 ? "at least " : "") + bits(a.weight_bits) : "not probed"),
    };
}

}  // namespace parity
