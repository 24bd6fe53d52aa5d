// SPDX-License-Identifier: MIT
//
// Somebody's shader text and a call of a function in it, as an entry that the parity suite's back ends run.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "../investigation.hpp"
#include "entry.hpp"

namespace check {

struct guest_text {
    std::string file{};  ///< for messages
    std::string text{};
    std::string call{};    ///< an expression of map, linear_map, shadow_map, size, coord, uv, z and c
    std::string before{};  ///< ahead of the text: macros that an engine would define
    /// The text's own uniforms that are to be the nearest, the filtered and the comparing map; empty: none.
    std::array<std::string, 3> uniforms{};
    subject is = subject::filter;
    parity::dialect in = parity::version::v330;
};

/// Language by the file's ending, and GLSL's version by the text.
[[nodiscard]] parity::dialect dialect_of(const std::string& file, const std::string& text);

/// A call that uses a map is a filter's, one that uses c a reader's, any other a writer's.
[[nodiscard]] subject subject_of(const std::string& call);

/// What to say where neither the call nor an option names the map; empty: one does, or none is read.
[[nodiscard]] std::string unread_map(const guest_text&);

[[nodiscard]] parity::entry make_entry(const guest_text&);

/// A compiler's message with lines of the file, and what may help.
[[nodiscard]] std::string explained(const guest_text&, const parity::entry&, const std::string& message);

}  // namespace check
