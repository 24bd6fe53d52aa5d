// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

#include "statistics.hpp"

namespace bench {

using work = std::function<void()>;
using clock_in_seconds = std::function<double()>;

struct limits {
    double spread = 0.05;               ///< stop when the ratio's spread is below
    double burst = 0.01;                ///< seconds that calls of one side run before it is the other's turn
    double at_least = 1, at_most = 10;  ///< seconds for the pair
    std::size_t rounds = 9;             ///< at least, whatever they take
};

struct measurement {
    double ours, theirs;  ///< seconds a call, medians
    estimate ratio;       ///< theirs / ours: above 1, ours is faster
    std::size_t rounds;
};

/// Ours and theirs in turns, in short bursts, until the ratio is known well enough or its time is up. Who begins a
/// round alternates: neither always finds the caches as the other left them after a pause.
/// @param now    the clock that is measured
/// @param wall   the clock that the limits are in
[[nodiscard]] inline measurement measure(const work& ours, const work& theirs, const clock_in_seconds& now,
                                         const clock_in_seconds& wall, const limits& within) {
    const auto seconds_a_call = [&](const work& side, int calls) {
        const double start = now();
        for (int i = 0; i < calls; ++i) side();
        return (now() - start) / calls;
    };
    const auto calls_a_burst = [&](const work& side) {
        side();
        return 1 + static_cast<int>(within.burst / std::max(seconds_a_call(side, 1), 1e-6));
    };
    const int our_calls = calls_a_burst(ours), their_calls = calls_a_burst(theirs);

    std::vector<double> our_seconds, their_seconds, ratios;
    const double start = wall();
    for (;;) {
        const bool we_begin = ratios.size() % 2 == 0;
        if (we_begin) our_seconds.push_back(seconds_a_call(ours, our_calls));
        their_seconds.push_back(seconds_a_call(theirs, their_calls));
        if (!we_begin) our_seconds.push_back(seconds_a_call(ours, our_calls));
        ratios.push_back(their_seconds.back() / our_seconds.back());

        const double passed = wall() - start;
        if (ratios.size() < within.rounds || passed < within.at_least) continue;
        const estimate ratio = estimate_median(ratios);
        if (ratio.spread() < within.spread || passed >= within.at_most) {
            return {median(our_seconds), median(their_seconds), ratio, ratios.size()};
        }
    }
}

}  // namespace bench
