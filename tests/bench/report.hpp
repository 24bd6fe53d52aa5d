// SPDX-License-Identifier: MIT
//
// Report of a run of the benchmarks: one JSON document.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace bench {

struct machine {
    std::string processor;
    unsigned processors = 0;
    std::string instruction_set;       ///< that image functions used
    std::string best_instruction_set;  ///< that the processor has and the library knows
    std::string compiler;
};

struct result {
    std::string work, peer;
    double ours = 0, theirs = 0;  ///< nanoseconds an item
    double ratio = 0;             ///< theirs / ours, median of rounds
    double spread = 0;            ///< width of the ratio's confidence interval over the ratio
    bool converged = false;       ///< the spread is below what was asked for
    std::size_t rounds = 0;
    std::string clock = "processor";
    double wanted = 0;  ///< the ratio that we mean to have; 0: none stated
};

struct report {
    machine on;
    std::vector<result> rows;
};

[[nodiscard]] machine this_machine();
void write(const report& r, const std::string& path);
[[nodiscard]] report read(const std::string& path);

}  // namespace bench
