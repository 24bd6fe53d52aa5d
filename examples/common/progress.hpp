// SPDX-License-Identifier: MIT
//
// What a program says while it works: a bar on a terminal, and how long each stage took.
//
//     example::progress progress(rows, quiet);
//     progress.stage("depth pass", [&] { ...; progress.step(); });
//
#pragma once

#include <chrono>
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
    /// @param total   steps in all; a bar appears when standard error is a terminal
    progress(unsigned long total, bool quiet) {
        if (!quiet && isatty(fileno(stderr))) bar_.emplace(total, std::cerr, "", "", "");
    }

    void step(unsigned long steps = 1) {
        if (bar_) *bar_ += steps;
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
    std::optional<boost::timer::progress_display> bar_;
    std::vector<std::pair<std::string, double>> times_;
};

}  // namespace example
