// SPDX-License-Identifier: MIT
#pragma once

/// Long tests take one round in so many: all, but an eighth in make asan. The sanitizers look for faults on the way,
/// which few rounds go as well. make fuzz takes many more under the same sanitizers.
#ifdef UMBRAGE_FEWER_ROUNDS
constexpr int one_round_in = 8;
#else
constexpr int one_round_in = 1;
#endif

/// Rounds that a long test takes of so many.
constexpr int rounds(int all) { return (all + one_round_in - 1) / one_round_in; }
