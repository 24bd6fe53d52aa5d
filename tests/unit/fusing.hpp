// SPDX-License-Identifier: MIT
//
// Whether compilers may fuse multiplications and additions in this build, as they do in users' builds with
// -march=native. Then what rounds, tier B, keeps its bounds in place of its bits. Tier A keeps its bits.
#pragma once

#if defined(UMBRAGE_TESTS_MAY_FUSE) && (defined(__FMA__) || defined(__aarch64__))
inline constexpr bool may_fuse = true;
#else
inline constexpr bool may_fuse = false;
#endif
