// SPDX-License-Identifier: MIT
//
// A list of types whose values know their names: what tools, tables and tests walk.
//
//     using encodings = umbrage::list_of<depth32f, rg<9>>;
//     encodings::for_each([](auto encoding) { std::puts(encoding.name.data()); });
//
#pragma once

#include <cstddef>
#include <string_view>

namespace umbrage {

/// std::tuple's cheap sister: it is never made, so that a file that does not walk it pays nothing.
template <class... Values>
struct list_of {
    static constexpr std::size_t size = sizeof...(Values);

    /// Calls use(value) with a value of each, one after the other.
    template <class Use>
    static constexpr void for_each(Use&& use) {
        (use(Values{}), ...);
    }

    /// Calls use(value) with the one of that name.
    /// @return   false where none is called so
    template <class Use>
    static constexpr bool with(std::string_view name, Use&& use) {
        return ((Values::name == name ? (static_cast<void>(use(Values{})), true) : false) || ...);
    }
};

}  // namespace umbrage
