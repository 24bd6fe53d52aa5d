// SPDX-License-Identifier: MIT
//
// Two sets of runs, told apart row by row. A set's ratio is the median over its runs. Its spread is the range over its
// runs over that median, or where there is but one run, that run's own spread. A row is kept when its ratio has changed
// by no more than 5 % or the larger of both spreads.
#pragma once

#include <algorithm>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "report.hpp"
#include "statistics.hpp"

namespace bench {

enum class verdict { kept, slower, faster };

struct set_of_runs {
    double ratio, spread;
    double ours;  ///< nanoseconds an item
};

struct change {
    std::string work, peer;
    set_of_runs before, after;

    [[nodiscard]] double relative() const { return after.ratio / before.ratio - 1; }
    [[nodiscard]] double tolerance() const { return std::max({0.05, before.spread, after.spread}); }
    [[nodiscard]] verdict judged() const {
        if (relative() < -tolerance()) return verdict::slower;
        return relative() > tolerance() ? verdict::faster : verdict::kept;
    }
};

using row_name = std::pair<std::string, std::string>;  ///< work, peer

struct comparison {
    std::vector<change> changes;
    std::vector<row_name> only_before, only_after;

    [[nodiscard]] bool any_slower() const {
        return std::ranges::any_of(changes, [](const change& c) { return c.judged() == verdict::slower; });
    }
};

[[nodiscard]] inline set_of_runs summarize(const std::vector<result>& runs) {
    std::vector<double> ratios, ours;
    for (const result& r : runs) {
        ratios.push_back(r.ratio);
        ours.push_back(r.ours);
    }
    std::ranges::sort(ratios);
    const double middle = median_of_sorted(ratios);
    const double range = (ratios.back() - ratios.front()) / middle;
    return {middle, runs.size() == 1 ? runs.front().spread : range, median(std::move(ours))};
}

[[nodiscard]] inline comparison compare(std::span<const report> before, std::span<const report> after) {
    std::vector<row_name> order;  // as the table of the first run that has the row
    std::map<row_name, std::vector<result>> old_runs, new_runs;
    const auto collect = [&order](std::span<const report> set, auto& runs, const auto& others) {
        for (const report& r : set) {
            for (const result& row : r.rows) {
                const row_name name{row.work, row.peer};
                if (!runs.contains(name) && !others.contains(name)) order.push_back(name);
                runs[name].push_back(row);
            }
        }
    };
    collect(before, old_runs, new_runs);
    collect(after, new_runs, old_runs);

    comparison all;
    for (const row_name& name : order) {
        if (!new_runs.contains(name)) all.only_before.push_back(name);
        else if (!old_runs.contains(name)) all.only_after.push_back(name);
        else all.changes.push_back({name.first, name.second, summarize(old_runs[name]), summarize(new_runs[name])});
    }
    return all;
}

}  // namespace bench
