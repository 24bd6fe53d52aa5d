// SPDX-License-Identifier: MIT
//
// The table of what the parity tests tried, from the parity-*.tsv that they leave behind.
#pragma once

#include <filesystem>
#include <string>

namespace readme {

struct proof {
    std::string implementations;  ///< a line for each and each language it runs
    std::string primitives;       ///< all implementations together, by class of input
};

/// @throws std::runtime_error  no reports, or one that lacks a primitive: what would be written would be less than was
///                             proven
[[nodiscard]] proof read_proof(const std::filesystem::path& reports);

}  // namespace readme
