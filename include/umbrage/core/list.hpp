// SPDX-License-Identifier: MIT
//
// List of types whose values know their names, for tools, tables and tests to iterate over.
//
//     using encodings = umbrage::list_of<depth32f, rg<9>>;
//     encodings::for_each([](auto encoding) { std::puts(encoding.name.data()); });
//
#pragma once

#include <cstddef>
#include <string_view>

#include <umbrage/core/config.hpp>

namespace umbrage {

/// Cheap alternative to std::tuple: it is never constructed, so files that do not iterate over it pay nothing.
template <class... Values>
struct list_of {
    static constexpr std::size_t size = sizeof...(Values);

    /// Calls use(value) in order, with a value of each type or with each of its `values`.
    template <class Use>
    static constexpr void for_each(Use&& use) {
        (each<Values>(use), ...);
    }

    /// Calls use(value) with the value of that name.
    /// @return   false if no value has that name
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
