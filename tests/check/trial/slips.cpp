// SPDX-License-Identifier: MIT
//
// Slips that a generator plants are named, in each language, and nobody else is accused.
#include <algorithm>
#include <iterator>

#include "../numbers.hpp"
#include "filter_texts.hpp"
#include "on_software.hpp"

using namespace check;

namespace {

constexpr int texts = 60;

template <class List>
auto& one_of(List& list, dice& random) {
    return list[random.below(static_cast<std::uint32_t>(std::size(list)))];
}

/// The i-th text's slips: one, and in every fifth text that can have it a second.
std::vector<const planted_slip*> planted(int i, dice& random) {
    std::vector<const planted_slip*> all{&filter_slips[std::size_t(i) % std::size(filter_slips)]};
    // reversed depth beside 1 in shadow is the other comparison alone
    while (i % 5 == 0 && all[0]->kind != "direction" && all.size() == 1) {
        const planted_slip& second = one_of(filter_slips, random);
        if (second.where != all[0]->where && second.kind != "direction") all.push_back(&second);
    }
    return all;
}

std::vector<std::string> sorted(std::vector<std::string> kinds) {
    std::ranges::sort(kinds);
    return kinds;
}

void each_is_named(const language& in) {
    if (!software(in.in)) return;
    dice random(58);
    const int every = in.is_msl() && !all_rounds() ? 13 : 1;
    int right = 0, tried = 0, twice = 0;
    for (int i = 0; i < texts; ++i) {
        const written_filter& filter = one_of(written_filters, random);
        filter_parts parts = plain_parts(in);
        std::vector<std::string> expected, found;
        for (const planted_slip* slip : planted(i, random)) {
            slip->plant(in, parts);
            expected.emplace_back(slip->kind);
        }
        if (i % every != 0) continue;
        const std::string text = filter_text(in, filter, parts);
        const verdict v = of_text(in.file, text, filter_call(in));
        for (const finding& f : v.slips) found.push_back(f.kind);
        CAPTURE(text);
        CAPTURE(check::text(v));
        CHECK(v.how == agreement::other);
        CHECK(v.function == filter.name);
        CHECK(sorted(found) == sorted(expected));
        CHECK(v.first.has_value());
        right += v.function == filter.name && sorted(found) == sorted(expected);
        ++tried, twice += expected.size() == 2;
    }
    CHECK(tried == (texts + every - 1) / every);
    CHECK(twice >= 10 / every);
    MESSAGE(right, " of ", tried, " named rightly, ", twice, " of them with two slips");
}

}  // namespace

TEST_CASE("slips of filters: each is named, two at once too") {
    SUBCASE("GLSL") { each_is_named(glsl); }
    SUBCASE("HLSL") { each_is_named(hlsl); }
    SUBCASE("WGSL") { each_is_named(wgsl); }
    SUBCASE("Metal") { each_is_named(msl); }
}
