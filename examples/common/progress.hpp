// SPDX-License-Identifier: MIT
//
// Progress of a program: a bar on a terminal, and the time of each stage.
//
//     example::progress progress(stages, quiet);
//     progress.stage("visibility", [&] { umbrage::visibility(..., progress.bands()); });
//
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

#include <boost/timer/progress_display.hpp>

namespace example {

class progress {
public:
    /// @param stages   in all; a bar appears when standard error is a terminal
    progress(unsigned long stages, bool quiet) {
        if (!quiet && isatty(fileno(stderr))) bar_.emplace(stages * steps, std::cerr, "", "", "");
    }

    /// A parallel_for for the library's functions: bands of rows, one after the other, and the bar moves after each.
    [[nodiscard]] auto bands() {
        return [this](int count, auto&& piece) {
            constexpr int bands = 16;
            for (int band = 0; band < std::min(bands, count); ++band) {
                const auto row = [&](int of) {
                    return static_cast<int>(std::int64_t{count} * of / std::min(bands, count));
                };
                piece(row(band), row(band + 1));
                advance(std::min(done_ + steps / bands, steps));
            }
        };
    }

    /// Runs the work and remembers how long it took.
    template <class Work>
    auto stage(std::string name, Work&& work) {
        struct clock {
            progress& owner;
            std::string name;
            std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
            ~clock() {
                const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
                owner.times_.emplace_back(std::move(name), took.count());
                owner.advance(steps);
                owner.done_ = 0;
            }
        } running{*this, std::move(name)};
        return std::forward<Work>(work)();
    }

    void print_times() const {
        double sum = 0;
        for (const auto& [name, ms] : times_) {
            std::printf("%-14s %9.1f ms\n", name.c_str(), ms);
            sum += ms;
        }
        std::printf("%-14s %9.1f ms\n", "together", sum);
    }

private:
    static constexpr unsigned long steps = 64;  ///< steps of a stage

    void advance(unsigned long to) {
        if (bar_) *bar_ += to - done_;
        done_ = to;
    }

    std::optional<boost::timer::progress_display> bar_;
    unsigned long done_ = 0;  ///< finished steps of the running stage
    std::vector<std::pair<std::string, double>> times_;
};

}  // namespace example
