// SPDX-License-Identifier: MIT
//
// Error of every encoding over depth, for a plot.
#pragma once

#include <iosfwd>

/// Writes a table: a row an encoding, with its bytes a texel and its largest error in each of 128 pieces of [0, 1].
void write_curves(std::ostream& out);
