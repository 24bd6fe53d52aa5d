// SPDX-License-Identifier: MIT
//
// What the text of a rewritten program needs: its numbers and enumerators, the watched library, and the list of
// programs.
#pragma once

#include <cstdio>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "number.hpp"
#include "texts.hpp"
#include "watched.hpp"

namespace turned {

/// A number or enumerator of a program's text.
struct place {
    int line, column, size;
    const char* why;   ///< "turned", or why it keeps its value. Of a rebuilt program: what became of it
    const char* text;  ///< of the line
    std::vector<std::string_view> others{};  ///< names of an enumerator's other values; a number has none
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

/// Programs without a field, or with another constant, which is their one place. Each has the whole program's name.
inline std::vector<program>& programs_rebuilt() {
    static std::vector<program> all;
    return all;
}
inline bool add_rebuilt(program p) { return programs_rebuilt().push_back(std::move(p)), true; }

}  // namespace turned

/// Pictures are no result here.
inline void write_picture(const char*, const umbrage::image<float>&) {}
