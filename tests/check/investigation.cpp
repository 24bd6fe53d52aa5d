// SPDX-License-Identifier: MIT
#include "investigation.hpp"

#include "stage.hpp"

namespace check {

struct investigation::state {
    verdict found{};
    std::unique_ptr<stage> whole{};
    batch asked{};
};

std::vector<std::string> names(subject s) {
    return s == subject::filter  ? filter_names()
           : s == subject::bound ? std::vector<std::string>{"chebyshev"}
                                 : encoding_names();
}

investigation::investigation(subject s, expectation e, std::uint32_t seed) : state_(std::make_unique<state>()) {
    const auto make = s == subject::filter  ? investigate_filter
                      : s == subject::pack  ? investigate_pack
                      : s == subject::bound ? investigate_bound
                                            : investigate_unpack;
    state_->found.expected = e.is;
    state_->whole = make(e, seed, state_->found);
}
investigation::investigation(investigation&&) noexcept = default;
investigation& investigation::operator=(investigation&&) noexcept = default;
investigation::~investigation() = default;

std::optional<batch> investigation::next() {
    std::optional<batch> b = state_->whole->ask();
    if (b) state_->asked = *b;
    return b;
}

void investigation::answer(std::span<const glm::vec4> outputs) { state_->whole->learn(state_->asked, outputs); }

verdict investigation::result() const { return state_->found; }

}  // namespace check
