// SPDX-License-Identifier: MIT
#pragma once

#include <cstdlib>

/// Long tests take one round in so many: an eighth, and all with UMBRAGE_ALL_ROUNDS in the environment. The tests named
/// .../all_rounds set it, which make test-all runs.
inline const int one_round_in = std::getenv("UMBRAGE_ALL_ROUNDS") ? 1 : 8;

/// Rounds that a long test takes of so many.
inline int rounds(int all) { return (all + one_round_in - 1) / one_round_in; }
