// SPDX-License-Identifier: MIT
//
// What the text of a rewritten program needs: its numbers, the watched library, and the list of programs.
#pragma once

#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "number.hpp"
#include "watched.hpp"

namespace turned {

/// A number of a program's text.
struct place {
    int line, column, size;
    const char* why;   ///< "turned", or why it keeps its value
    const char* text;  ///< of the line
};

struct program {
    std::string name;
    std::vector<place> places;
    void (*run)();
};

inline std::vector<program>& programs() {
    static std::vector<program> all;
    return all;
}
inline bool add(program p) { return programs().push_back(std::move(p)), true; }

/// Programs without a field, which is their one place. Each has the name of the whole program.
inline std::vector<program>& programs_without() {
    static std::vector<program> all;
    return all;
}
inline bool add_without(program p) { return programs_without().push_back(std::move(p)), true; }

}  // namespace turned

/// Pictures are no result here.
inline void write_picture(const char*, const umbrage::image<float>&) {}
