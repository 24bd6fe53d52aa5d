// SPDX-License-Identifier: MIT
//
// One page on an implementation, to keep or to send.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "probe.hpp"
#include "table.hpp"

namespace parity {

/// One API of an implementation.
struct report {
    identity of{};
    std::vector<std::string> dialects{};  ///< that it speaks
    std::optional<arithmetic> probed{};
    std::string probed_in{};  ///< the dialect
    std::vector<row> rows{};
};

/// The dialects' APIs, each with what its newest dialect of GLSL, or else its last, says of arithmetic.
[[nodiscard]] std::vector<report> probe_all(backend& b);

/// As report-<api>-<device>.md, in Markdown. The folder is made.
/// @param command   what was run
/// @return          the file's path
/// @throws std::runtime_error   the file cannot be written
std::string write(const report& r, const std::string& command, const std::string& folder);

}  // namespace parity
