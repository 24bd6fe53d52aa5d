// SPDX-License-Identifier: MIT
//
// The entries compiled in the written order of operations, whatever the build's flags: a library that a program loads
// when it runs, so that neither takes the other's functions.
#pragma once

#include "backend.hpp"

namespace parity {

struct written_order {
    decltype(&parity::entries) entries;
    decltype(&parity::make_job) make_job;
    decltype(&parity::make_whole_job) make_whole_job;
};

}  // namespace parity
