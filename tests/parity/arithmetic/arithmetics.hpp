// SPDX-License-Identifier: MIT
//
// The arithmetics that entries are tried in: one licence of the specifications at a time, then all together.
#pragma once

#include "number.hpp"

namespace parity::arithmetic {

struct setting {
    const char* name;
    rules by;
};

inline constexpr setting arithmetics[]{
    {"as written", {}},
    {"fused", {.fuses = true}},
    {"regrouped", {.reorders = true}},
    {"fused and regrouped", {.fuses = true, .reorders = true}},
    {"rounded up", {.rounding = rules::up}},
    {"rounded down", {.rounding = rules::down}},
    {"rounded toward zero", {.rounding = rules::toward_zero}},
    {"rounded either way", {.rounding = rules::either}},
    {"denormal operands flushed", {.flushes_inputs = true}},
    {"denormal results flushed", {.flushes_results = true}},
    {"NaN and infinity absent", {.assumes_finite = true}},
    {"functions off", {.is_inaccurate = true}},
    {"UNORM reads off", {.reads_beside = true}},
    {"UNORM reads in 16 bits", {.reads_halves = true}},
    {"UNORM stores either code", {.stores_either = true}},
    {"8 sub-texel bits", {.sub_texel_bits = 8}},
    {"6 sub-texel bits", {.sub_texel_bits = 6}},
    {"4 sub-texel bits", {.sub_texel_bits = 4}},
    {"all together",
     {.fuses = true,
      .reorders = true,
      .rounding = rules::either,
      .flushes_inputs = true,
      .flushes_results = true,
      .assumes_finite = true,
      .is_inaccurate = true,
      .reads_beside = true,
      .sub_texel_bits = 8}},
};

/// Arithmetic of a compiler that fuses, and sometimes rounds to the other neighbor.
inline constexpr setting fused_and_rounded{"fused and rounded either way", {.fuses = true, .rounding = rules::either}};

}  // namespace parity::arithmetic
