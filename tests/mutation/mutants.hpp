// SPDX-License-Identifier: MIT
//
// One small change at a time to GLSL text, at every place where it applies. The operators, fixed in advance:
//
//   ulp          a float constant becomes the next float; 0.0 becomes 2^-126, for a denormal may act as zero
//   unit         a constant becomes one more (the next float, where that is further)
//   boundary     <  to <=,  <= to <,  > to >=,  >= to >,  == to !=
//   direction    <  to >,   <= to >=  and back
//   sign         + to - and back, += to -= and back, the sign of a value; a ! dropped
//   arithmetic   * to / and back, << to >> and back, & to | and back, && to || and back
//   order        two neighbors of a vector's constructor change places: the offset (1, 0) becomes (0, 1)
//   channel      .x becomes .y, .z and .w, and so on
//   call         floor, min, max, clamp, abs, sqrt, umbrage_saturate or umbrage_from_unorm becomes its first argument
//   branches     c ? a : b becomes c ? b : a
//   statement    an if without braces dropped, with its statement
//
// A loop's own ++ stays: a loop that does not end shows nothing. Comments are no sites; macros' bodies and #if are.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace mutation {

struct mutant {
    std::string_view kind;  ///< the operator
    std::string site;       ///< its line, as `before [old -> new] after`, without qualifiers; #2: the second such
    std::string source;     ///< the whole text, changed
};

[[nodiscard]] std::vector<mutant> mutants(std::string_view source);

}  // namespace mutation
