// SPDX-License-Identifier: MIT
//
// One part of an investigation: it asks until it knows what the next part needs.
#pragma once

#include <optional>
#include <span>

#include "investigation.hpp"

namespace check {

class stage {
public:
    virtual ~stage() = default;
    /// The next inputs, or nothing when this stage is done.
    [[nodiscard]] virtual std::optional<batch> ask() = 0;
    virtual void learn(const batch&, std::span<const glm::vec4> outputs) = 0;
};

/// The whole investigation of a subject. It writes into the verdict, which outlives it.
[[nodiscard]] std::unique_ptr<stage> investigate_filter(const expectation&, std::uint32_t seed, verdict&);
[[nodiscard]] std::unique_ptr<stage> investigate_pack(const expectation&, std::uint32_t seed, verdict&);
[[nodiscard]] std::unique_ptr<stage> investigate_unpack(const expectation&, std::uint32_t seed, verdict&);
[[nodiscard]] std::unique_ptr<stage> investigate_bound(const expectation&, std::uint32_t seed, verdict&);

[[nodiscard]] std::vector<std::string> filter_names();
[[nodiscard]] std::vector<std::string> encoding_names();

}  // namespace check
