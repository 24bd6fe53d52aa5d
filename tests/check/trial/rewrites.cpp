// SPDX-License-Identifier: MIT
//
// Other ways to write the same function: none is accused of a slip.
#include <iterator>

#include "../numbers.hpp"
#include "on_software.hpp"
#include "filter_texts.hpp"

using namespace check;

namespace {

constexpr std::string_view lits[]{"r <= d ? 1.0 : 0.0", "d >= r ? 1.0 : 0.0", "step(r, d)",
                                  "r > d ? 0.0 : 1.0",  "float(r <= d)",      "1.0 - step(d, r) * float(d != r)"};
constexpr std::string_view uvs[]{"uv", "vec2(uv.x, uv.y)", "(1.0 * uv)", "uv.yx.yx"};
constexpr std::string_view sizes[]{"size", "vec2(size.x, size.y)", "size.yx.yx"};
constexpr std::string_view added[]{"vec2(0.0)", "vec2(0.25) - vec2(0.25)", "0.0 * uv"};
constexpr std::string_view receivers[]{"z", "(z + 0.0)", "0.5 * (z + z)", "min(z, 8.0)"};
constexpr std::string_view results[]{"v", "(v)", "1.0 * v", "0.5 * v + 0.5 * v"};

/// Bodies for the filters of written_filters, by name: unrolled, inlined, in another order.
constexpr written_filter others[]{
    {"hard", "ivec2 k = ivec2(floor(at)); float answer = lit(k, r); v = answer;"},
    {"hard", "v = 1.0 - (1.0 - lit(ivec2(floor(at)), r));"},
    {"box(1)", R"(ivec2 k = ivec2(floor(at));
    float a = lit(k + ivec2(-1, -1), r) + lit(k + ivec2(0, -1), r) + lit(k + ivec2(1, -1), r);
    float b = lit(k + ivec2(-1, 0), r) + lit(k, r) + lit(k + ivec2(1, 0), r);
    v = (lit(k + ivec2(1, 1), r) + lit(k + ivec2(0, 1), r) + lit(k + ivec2(-1, 1), r) + a + b) / 9.0;)"},
    {"pcf_2x2", R"(vec2 p = floor(at * 256.0) - 128.0, t = floor(p / 256.0), f = p / 256.0 - t; ivec2 k = ivec2(t);
    for (int j = 1; j >= 0; --j) for (int i = 0; i < 2; ++i)
        v += (i == 0 ? 1.0 - f.x : f.x) * (j == 0 ? 1.0 - f.y : f.y) * lit(k + ivec2(i, j), r);)"},
};

template <class List>
std::string one_of(const List& list, dice& random) {
    return std::string(list[random.below(static_cast<std::uint32_t>(std::size(list)))]);
}

}  // namespace

TEST_CASE("rewrites: none of a hundred is accused") {
    if (!llvmpipe()) return;
    dice random(100);
    for (int i = 0; i < 100; ++i) {
        const std::size_t known = std::size(written_filters), which = std::size_t(i) % (known + std::size(others));
        const written_filter& filter = which < known ? written_filters[which] : others[which - known];
        const std::string text =
            filter_text(glsl, filter,
                        {one_of(uvs, random), one_of(sizes, random), one_of(added, random), one_of(receivers, random),
                         one_of(lits, random), one_of(results, random)});
        const verdict v = of_glsl(text, "shadow(uv, z)");
        CAPTURE(text);
        CAPTURE(check::text(v));
        const bool agrees = v.how == agreement::same_bits || v.how == agreement::same_but;
        CHECK(agrees);
        CHECK(v.function == filter.name);
        CHECK(v.slips.empty());
    }
}
