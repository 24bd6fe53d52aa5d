// SPDX-License-Identifier: MIT
//
// Sums of the picture table by light and row, and their print in markdown.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "receivers.hpp"

namespace proof::picture {

/// Sums of rows, in the order in which they came.
class table {
public:
    void add(const std::string& row, const tally& sums) {
        for (auto& [name, all] : rows_)
            if (name == row) {
                all += sums;
                return;
            }
        rows_.emplace_back(row, sums);
    }
    table& operator+=(const table& other) {
        for (const auto& [name, sums] : other.rows_) add(name, sums);
        return *this;
    }
    [[nodiscard]] tally of(std::string_view row) const {
        for (const auto& [name, sums] : rows_)
            if (name == row) return sums;
        return {};
    }
    void print(std::string_view title) const {
        if (rows_.empty()) return;
        std::printf("\n| %.*s | acne %% | leak %% | lost contact %% | RMS %% |\n|---|--:|--:|--:|--:|\n",
                    int(title.size()), title.data());
        for (const auto& [name, t] : rows_)
            std::printf("| %s | %.3f | %.2f | %.1f | %.2f |\n", name.c_str(), t.acne_percent(), t.leak_percent(),
                        t.lost_percent(), t.rms_percent());
        const tally& t = rows_.front().second;
        std::printf("\n%.0f receivers: %.0f lit, %.0f dark, %.0f in contact.\n", t.all, t.lit, t.dark, t.contact);
    }

private:
    std::vector<std::pair<std::string, tally>> rows_{};
};

}  // namespace proof::picture
