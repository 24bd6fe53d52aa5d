// SPDX-License-Identifier: MIT
//
// Implementations in programs of their own: jobs go there, pixels come back.
#pragma once

#include "backend.hpp"
#include "child.hpp"

namespace parity {

class remote : public backend {
public:
    explicit remote(std::vector<std::string> words) : program_(std::move(words)) {}

    [[nodiscard]] std::vector<vec4> run(dialect d, const job& j, std::size_t count) override;

protected:
    /// Version of WebGL for a dialect.
    [[nodiscard]] static std::string number(dialect d) { return d == version::v100 ? "1" : "2"; }

    /// Name that the implementation gives itself.
    [[nodiscard]] std::string hello(dialect d) { return ask({"{\"hello\": true, \"version\": " + number(d) + "}"}); }

private:
    /// Sends parts as parts_of() in frames.js wants them.
    std::string ask(const std::vector<std::string>& parts);

    child program_;
    std::uint64_t serial_ = ~std::uint64_t(0);
};

}  // namespace parity
