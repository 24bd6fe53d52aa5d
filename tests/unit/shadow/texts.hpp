// SPDX-License-Identifier: MIT
//
// Questions that tests put to the texts that a shadow prints.
#pragma once

#include <stdexcept>
#include <string>

namespace shadow_texts {

inline bool has(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

/// Message of a refused call.
template <class Make>
std::string refusal(const Make& make) {
    try {
        make();
    } catch (const std::invalid_argument& e) { return e.what(); }
    return "accepted";
}

}  // namespace shadow_texts
