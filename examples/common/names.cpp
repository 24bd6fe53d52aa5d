// SPDX-License-Identifier: MIT
#include "names.hpp"

#include <umbrage/depth/encodings.hpp>

#include "biases.hpp"
#include "filters.hpp"
#include "soft.hpp"

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

const std::vector<std::string>& bias_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        biases::all::for_each([&](const auto& bias) { all.emplace_back(bias.name); });
        return all;
    }();
    return names;
}

int encoding_bytes(std::string_view encoding) {
    int bytes = 0;
    umbrage::with_encoding(encoding,
                           [&]<class Encoding>(const Encoding&) { bytes = sizeof(typename Encoding::texel); });
    return bytes;
}

float reach_of(std::string_view filter, std::optional<float> radius) {
    float reach = 0;
    with_filter(filter, radius, [&](const auto& f) { reach = f.reach(); });
    return reach;
}

std::string_view snippet_of(std::string_view filter) {
    std::string_view name = filter;
    umbrage::with_filter(filter, [&](const auto& f) { name = f.snippet->name; });
    return name;
}

std::string_view usual_bias(std::string_view filter) {
    return hardens(filter) ? biases::receiver_plane::name : biases::acne_free::name;
}

bool compares_along_plane(std::string_view bias) {
    bool along = false;
    with_bias(bias, [&](const auto& b) {
        along = requires { b.compares_along_plane; };
    });
    return along;
}

}  // namespace example
