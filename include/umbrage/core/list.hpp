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

    /// Calls use(value) with a value of each, or with each of its `values`, one after the other.
    template <class Use>
    static constexpr void for_each(Use&& use) {
        (each<Values>(use), ...);
    }

    /// Calls use(value) with the one of that name.
    /// @return   false where none is called so
    template <class Use>
    static constexpr bool with(std::string_view name, Use&& use) {
        bool found = false;
        for_each([&](const auto& value) {
            if (found || value.name != name) return;
            found = true;
            static_cast<void>(use(value));
        });
        return found;
    }

private:
    template <class Value, class Use>
    static constexpr void each(Use& use) {
        if constexpr (requires { Value::values; })
            for (const Value& value : Value::values) use(value);
        else use(Value{});
    }
};

}  // namespace umbrage
