// SPDX-License-Identifier: MIT
//
// Results of a run of entries: a row for each entry in each dialect.
#pragma once

#include <array>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "verdict.hpp"

namespace parity {

struct row {
    std::string primitive;  ///< the entry's name
    std::string exactness;  ///< the tier's letter, and its bound
    std::string implementation, language;
    std::string obstacle{};  ///< why the entry cannot run here
    tally t{};
    std::string broken{};   ///< what it threw
    std::string example{};  ///< the first result that differs

    [[nodiscard]] bool ran() const { return obstacle.empty() && broken.empty(); }
    /// Keeps the first of the differences that compare() has printed, unless there is one.
    void take_example(const std::string& log) {
        if (example.empty()) example = log.substr(0, log.find("  differs:", 1));
    }
};

/// Promise of an entry's primitive, or only the tier if the entry's text contains a weaker one.
[[nodiscard]] std::string promised(const entry& e);

/// Entries of a tier, each in the worst dialect.
struct tier_sum {
    std::array<int, 3> entries{};  ///< by verdict
    int not_run = 0;
    std::uint64_t inputs = 0;
    std::int64_t worst_ulp = 0;
    float worst_distance = 0.0f;
};

/// Rows of an entry stand together.
[[nodiscard]] std::array<tier_sum, 3> by_tier(const std::vector<row>& rows);

/// As a table in Markdown.
void print(std::ostream& out, const std::array<tier_sum, 3>& tiers);

/// A line for each run of rows that agree on all but the dialect.
void print(std::ostream& out, const std::vector<row>& rows);

/// Every row, its values parted by tabs.
/// @throws std::runtime_error   the file cannot be written
void write(const std::vector<row>& rows, const std::string& path);

}  // namespace parity
