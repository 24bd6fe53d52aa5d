// SPDX-License-Identifier: MIT
//
// Implementations in programs of their own: jobs go there, pixels come back.
#pragma once

#include "../backend.hpp"
#include "child.hpp"

namespace parity {

class remote : public backend {
public:
    explicit remote(std::vector<std::string> words) : program_(std::move(words)) {}

    [[nodiscard]] std::vector<vec4> run(dialect d, const job& j, std::size_t count) override;

protected:
    /// Name that the implementation gives itself.
    [[nodiscard]] std::string hello(dialect d);

private:
    child program_;
    std::uint64_t serial_ = ~std::uint64_t(0);
};

}  // namespace parity
