// SPDX-License-Identifier: MIT
//
// Slips that a generator plants are named, and nobody else is accused.
#include <algorithm>
#include <iterator>

#include "../numbers.hpp"
#include "on_llvmpipe.hpp"
#include "texts.hpp"

using namespace check;

namespace {

std::vector<std::string> kinds(const verdict& v) {
    std::vector<std::string> all;
    for (const finding& f : v.slips) all.push_back(f.kind);
    return all;
}

template <class List>
auto& one_of(List& list, dice& random) {
    return list[random.below(static_cast<std::uint32_t>(std::size(list)))];
}

}  // namespace

TEST_CASE("slips of filters: each is named, two at once too") {
    if (!llvmpipe()) return;
    dice random(58);
    for (int i = 0; i < 40; ++i) {
        const written_filter& filter = one_of(written_filters, random);
        const planted_slip* planted[2]{&filter_slips[i % std::size(filter_slips)], nullptr};
        filter_parts parts;
        parts.*(planted[0]->where) = planted[0]->text;
        // reversed depth beside 1 in shadow is the other comparison alone
        while (i % 4 == 3 && planted[0]->kind != "direction" && !planted[1]) {
            const planted_slip& second = one_of(filter_slips, random);
            if (second.where == planted[0]->where || second.kind == "direction") continue;
            planted[1] = &second;
            parts.*(second.where) = second.text;
        }
        const std::string text = filter_text(filter.body, parts);
        const verdict v = of_glsl(text, "shadow(uv, z)");
        CAPTURE(text);
        CAPTURE(check::text(v));
        CHECK(v.how == agreement::other);
        CHECK(v.function == filter.name);
        const auto found = kinds(v);
        CHECK(found.size() == (planted[1] ? 2u : 1u));
        for (const planted_slip* p : planted)
            if (p) CHECK(std::ranges::find(found, p->kind) != found.end());
        CHECK(v.first.has_value());
    }
}
