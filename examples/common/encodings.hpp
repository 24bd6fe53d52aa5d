// SPDX-License-Identifier: MIT
//
// The library's encodings by name, with the edge that a program was asked for.
//
//     example::with_encoding("rg11", umbrage::upper_edge<float>, [&](auto encoding, float below) { ... });
//
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <umbrage/depth/encodings.hpp>

namespace example {

inline const std::vector<std::string> encoding_names = [] {
    std::vector<std::string> names;
    umbrage::for_each_encoding([&](const auto& encoding) { names.emplace_back(encoding.name); });
    return names;
}();

/// Calls use(encoding, below); `below` is how far decode may answer below the depth that was encoded, which a receiver's
/// bias has to cover.
/// @throws std::invalid_argument  no such name
template <class Use>
auto with_encoding(std::string_view name, float edge, Use&& use) {
    using result = decltype(use(umbrage::depth32f{}, 0.0f));
    constexpr bool nothing = std::is_void_v<result>;
    std::optional<std::conditional_t<nothing, bool, result>> out;
    umbrage::with_encoding(name, [&](auto encoding) {
        if constexpr (umbrage::has_edge<decltype(encoding)>) encoding.edge = edge;
        const auto below = static_cast<float>(encoding.error().below);
        if constexpr (nothing) use(encoding, below), out = true;
        else out.emplace(use(encoding, below));
    });
    if (!out) throw std::invalid_argument("no encoding is called " + std::string(name));
    if constexpr (!nothing) return *std::move(out);
}

}  // namespace example
