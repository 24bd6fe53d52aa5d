// SPDX-License-Identifier: MIT
//
// A page about one implementation, to keep or to send.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "probe.hpp"
#include "table.hpp"

namespace parity {

/// Results in the dialects of one API.
struct report {
    identity of{};
    std::vector<std::string> dialects{};
    std::string probed_in{};                      ///< the dialect of the probe
    std::optional<observed_arithmetic> probed{};  ///< empty: `unprobed` says why
    std::string unprobed{};
    std::vector<row> rows{};
    std::string system{};  ///< empty: this one
};

/// A report for each API, still without rows. The probe runs in the newest dialect of GLSL, or else the last dialect.
[[nodiscard]] std::vector<report> probe_all(backend& b);

/// @param command   the command line
void print(std::ostream& out, const report& r, const std::string& command);

/// Writes report-<api>-<device>.md into the folder, which it makes.
/// @return   the path of the file
/// @throws std::runtime_error   the file cannot be written
std::string write(const report& r, const std::string& command, const std::string& folder);

}  // namespace parity
