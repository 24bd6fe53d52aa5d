// SPDX-License-Identifier: MIT
#include <set>
#include <type_traits>

#include <umbrage/filter/filters.hpp>

#include "../numbers.hpp"
#include "../stage.hpp"
#include "model.hpp"

namespace check {
namespace {

using umbrage::detail::for_each_number;

/// The filter with its scalar numbers at a multiple of their defaults, which are the smallest or close to it.
template <class Filter>
Filter scaled(Filter filter, int multiple) {
    for_each_number(filter, [&]<class Number>(Number& n) {
        if constexpr (std::is_same_v<Number, int>) n *= multiple;
        if constexpr (std::is_same_v<Number, float>) n *= static_cast<float>(multiple) / 2;
    });
    return filter;
}

template <class Filter>
std::string name_of(const Filter& filter) {
    std::string numbers;
    for_each_number(filter, [&]<class Number>(const Number& n) {
        if constexpr (std::is_arithmetic_v<Number>)
            if (n != 0) numbers += (numbers.empty() ? "" : ", ") + shortened(double(n));
    });
    return std::string(filter.name) + (numbers.empty() ? "" : "(" + numbers + ")");
}

std::vector<reference> make_references() {
    std::vector<reference> all;
    std::set<std::string> known;
    const auto add = [&](const std::string& name, const auto& filter) {
        if (known.insert(name).second)
            all.push_back({name, [filter](const fetched_map& map, glm::vec2 coord, float receiver) {
                               return float(filter(map, coord, receiver));
                           }});
    };
    umbrage::for_each_filter([&](const auto& filter) {
        for (int multiple : {1, 2, 3, 4}) {
            const auto one = scaled(filter, multiple);
            add(name_of(one), one);
        }
    });
    // N x N filtered comparisons, equally weighted: engines' most usual loop.
    const auto equal = [&](const char* name, umbrage::window_row row) { add(name, umbrage::filters::window{row}); };
    equal("window(1 1 1)", umbrage::make_window_row(3, {1, 1}));
    equal("window(1 1 1 1 1)", umbrage::make_window_row(5, {1, 1, 1}));
    equal("window(1 1 1 1 1 1 1)", umbrage::make_window_row(7, {1, 1, 1, 1}));
    return all;
}

}  // namespace

const std::vector<reference>& references() {
    static const std::vector<reference> all = make_references();
    return all;
}

std::vector<std::string> filter_names() {
    std::vector<std::string> all;
    for (const reference& r : references()) all.push_back(r.name);
    return all;
}

}  // namespace check
