// SPDX-License-Identifier: MIT
//
// Rows of the table: one piece of work done by us and by somebody else.
//
//     const bench::registration encode([] {
//         bench::add({.work = "encode 11 bits, 2048 x 2048", .peer = "memcpy", .at_least = 0.9, .items = 2048 * 2048,
//                     .ours = [=] { ... }, .theirs = [=] { ... }, .agree = [=] { return true; }});
//     });
#pragma once

#include <functional>
#include <string>

namespace bench {

enum class clock { processor, wall };  ///< wall for what runs on several threads

struct row {
    std::string work, peer;
    double at_least = 0;  ///< the speed-up that we mean to have; 0: none stated
    double items = 1;     ///< texels, receivers, triangles: times are printed per item
    std::function<void()> ours, theirs;
    std::function<bool()> agree;  ///< after both have run once: are the results the same?
    clock measured = clock::processor;
};

void add(row r);

/// Runs its function when the program starts, after the command line is read.
struct registration {
    explicit registration(std::function<void()> rows);
};

}  // namespace bench
