// SPDX-License-Identifier: MIT
#include "runs.hpp"

#include <algorithm>
#include <deque>

namespace check {
namespace {

/// Answers a question's batches until there are no more.
template <class Question>
void answer(Question& question, const guest_text& g, parity::backend& on) {
    static std::deque<parity::entry> kept;  // back ends know entries by their places, and inputs by their numbers
    static std::uint64_t serial = 0;
    if (const std::string why = unread_map(g); !why.empty()) throw cannot_run(why);
    const parity::entry& e = kept.emplace_back(make_entry(g));
    const auto dialects = on.dialects();
    if (std::ranges::find(dialects, g.in) == dialects.end())
        throw cannot_run(on.name() + " does not run " + parity::name(g.in));
    while (std::optional<batch> b = question.next()) {
        parity::texels map((glm::max)(b->size, glm::ivec2(1)));
        for (std::size_t i = 0; i < b->map.size(); ++i)
            map[{static_cast<int>(i) % b->size.x, static_cast<int>(i) / b->size.x}] =
                b->second.empty() ? glm::vec4(b->map[i]) : glm::vec4(b->map[i], b->second[i], 1, 1);
        parity::job j{.what = &e, .classes = {}, .x = {}, .count = b->inputs.size(), .serial = ++serial};
        if (!e.maps.empty()) j.map = &map;
        j.x[0] = b->inputs;
        try {
            question.answer(on.run(g.in, j, j.count));
        } catch (const std::runtime_error& error) { throw cannot_run(explained(g, e, error.what())); }
    }
}

}  // namespace

verdict investigate(const guest_text& g, const expectation& expected, parity::backend& on) {
    investigation question(g.is, expected);
    answer(question, g, on);
    return question.result();
}

value_verdict compare_values(const guest_text& g, const value_table& table, std::uint64_t allowed,
                             parity::backend& on) {
    value_check question(table, allowed);
    answer(question, g, on);
    return question.result();
}

}  // namespace check
