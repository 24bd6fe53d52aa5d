// SPDX-License-Identifier: MIT
#include "names.hpp"

#include <umbrage/depth/encodings.hpp>
#include <umbrage/filter/filters.hpp>

namespace example {

const std::vector<std::string>& encoding_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        umbrage::for_each_encoding([&](const auto& encoding) { all.emplace_back(encoding.name); });
        return all;
    }();
    return names;
}

const std::vector<std::string>& filter_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        umbrage::for_each_filter([&](const auto& filter) { all.emplace_back(filter.name); });
        return all;
    }();
    return names;
}

float reach_of(std::string_view filter) {
    float reach = 0;
    umbrage::with_filter(filter, [&](const auto& f) { reach = f.reach(); });
    return reach;
}

}  // namespace example
