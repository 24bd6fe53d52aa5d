// SPDX-License-Identifier: MIT
//
// The library's encodings, filters and biases on a command line, by their own names.
//
//     example::add_encoding(app, options.encoding);
//
#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "names.hpp"

namespace example {

/// --encoding, --filter and --bias; Text is a std::string, or an optional one.
template <class Text>
CLI::Option* add_choice(CLI::App& app, const char* option, Text& value, const std::vector<std::string>& names,
                        const char* about) {
    return app.add_option(option, value, about)
        ->check(CLI::IsMember(names).description(""))
        ->type_name(CLI::detail::join(names, "|"));
}
template <class Text>
CLI::Option* add_encoding(CLI::App& app, Text& value) {
    return add_choice(app, "--encoding", value, encoding_names(), "how a depth is stored");
}
template <class Text>
CLI::Option* add_filter(CLI::App& app, Text& value, const std::vector<std::string>& names = filter_names()) {
    return add_choice(app, "--filter", value, names, "how texels become visibility");
}
template <class Text>
CLI::Option* add_bias(CLI::App& app, Text& value) {
    return add_choice(
        app, "--bias", value, bias_names(),
        "what keeps surfaces from shadowing themselves; default: acne_free, of pcss and dpcf receiver_plane");
}

}  // namespace example
