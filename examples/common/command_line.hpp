// SPDX-License-Identifier: MIT
//
// Command lines: checks that CLI11's own let through.
//
//     app.add_option("--fov", options.fov)->check(example::within(1, 120));
//
#pragma once

#include <iostream>
#include <sstream>
#include <string>

#include <CLI/CLI.hpp>

#include "run.hpp"

namespace example {

/// low <= value <= high; CLI::Range takes NaN for a number.
inline CLI::Validator within(double low, double high) {
    const auto text = [](double v) {
        std::ostringstream out;
        out << v;
        return out.str();
    };
    const std::string range = text(low) + " to " + text(high);
    return {[=](std::string& input) {
                double value = 0;
                const bool number = CLI::detail::lexical_cast(input, value);
                return number && value >= low && value <= high ? std::string() : "must be " + range + ", is " + input;
            },
            range};
}

/// The file of a mesh: an option, or an argument, that may be left out but not left empty.
template <class Path>
CLI::Option* add_mesh(CLI::App& app, const std::string& name, Path& file) {
    return app.add_option(name, file, "OBJ, glTF or PLY file; without one, the built-in scene")
        ->check(CLI::Validator(
            [](std::string& value) { return value.empty() ? std::string("is empty") : std::string(); }, ""));
}

/// Parses; prints the help and returns false when it was asked for.
/// @throws usage_error  in one line
inline bool parse(CLI::App& app, int argc, const char* const* argv) {
    try {
        app.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        std::cout << app.help();
        return false;
    } catch (const CLI::ParseError& error) {
        throw usage_error(std::string(error.what()) + " (--help lists the options)");
    }
    return true;
}

}  // namespace example
