// SPDX-License-Identifier: MIT
#pragma once

/// Rounds that a long test takes of so many: all, or an eighth in make asan. The sanitizers look for faults on the way,
/// which few rounds go as well. make fuzz takes many more under the same sanitizers.
constexpr int rounds(int all) {
#ifdef UMBRAGE_FEWER_ROUNDS
    return (all + 7) / 8;
#else
    return all;
#endif
}
