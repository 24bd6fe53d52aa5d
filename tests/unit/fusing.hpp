// SPDX-License-Identifier: MIT
//
// Fusing of multiplications and additions in this build, as compilers do in users' builds with -march=native. With it
// tier B keeps its bounds but not its bits. Tier A keeps its bits.
#pragma once

#if defined(UMBRAGE_TESTS_MAY_FUSE) && (defined(__FMA__) || defined(__aarch64__))
inline constexpr bool may_fuse = true;
#else
inline constexpr bool may_fuse = false;
#endif
