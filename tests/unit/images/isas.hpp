// SPDX-License-Identifier: MIT
#pragma once

#include <doctest/doctest.h>

#include <umbrage/simd/dispatch.hpp>

/// Calls use() with each instruction set that this machine has, the least first.
template <class Use>
void for_each_isa(Use&& use) {
    using umbrage::detail::isa;
    const isa before = umbrage::detail::isa_in_use;
    for (const isa set : {isa::base, isa::avx2, isa::avx512}) {
        if (umbrage::detail::best_isa() < set) continue;
        CAPTURE(static_cast<int>(set));
        umbrage::detail::isa_in_use = set;
        use();
    }
    umbrage::detail::isa_in_use = before;
}
