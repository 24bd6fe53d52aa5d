// SPDX-License-Identifier: MIT
//
// The probe of an implementation that answers later. Its jobs do not depend on its results.
#pragma once

#include <string>
#include <vector>

#include "backends/block.hpp"

namespace page {

/// Notes the jobs of a first run, whose results are zeros. A second run gets what was drawn of them.
class probe_jobs final : public parity::backend {
public:
    explicit probe_jobs(parity::dialect d) : dialect_(d) {}

    [[nodiscard]] std::string name() const override { return "page"; }
    [[nodiscard]] std::vector<parity::dialect> dialects() const override { return {dialect_}; }
    [[nodiscard]] std::vector<parity::vec4> run(parity::dialect d, const parity::job& j, std::size_t count) override {
        if (next_ < drawn.size()) return parity::results_of(j, count, drawn[next_++].data());
        blocks.push_back(parity::block_of(d, j, count, true));
        return std::vector<parity::vec4>(count);
    }

    std::vector<std::string> blocks;
    std::vector<std::string> drawn;  ///< pixels of each block

private:
    parity::dialect dialect_;
    std::size_t next_ = 0;
};

}  // namespace page
