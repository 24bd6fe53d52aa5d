// SPDX-License-Identifier: MIT
//
// Changes that a program may take badly, each with its reason: a list beside this file.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "program.hpp"

namespace turned {

/// Lines `program | code | turns | reason`. The code is a part of the program's line that holds the number. The turns
/// are names, which values of an enumeration have too, or `any`. The program may be `*`.
class exceptions {
public:
    /// @throws std::runtime_error   a file that is not there, or a line of another form
    explicit exceptions(const char* file);

    /// @param turn   what became of the place, by name
    [[nodiscard]] bool has(const program& p, const place& at, std::string_view turn) const;

private:
    struct entry {
        std::string program, code, turns;
    };
    std::vector<entry> all_;
};

}  // namespace turned
