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
#include <glm/vec2.hpp>

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

/// A width and a height, both from low to high: "480x320", or one number for both.
inline CLI::Option* add_size(CLI::App& app, const std::string& name, glm::ivec2& size, const std::string& about,
                             int low, int high) {
    const auto shown = [](glm::ivec2 s) { return std::to_string(s.x) + "x" + std::to_string(s.y); };
    const auto read = [&size, low, high, name](const std::string& text) {
        const auto cross = text.find('x');
        const std::string sides[]{text.substr(0, cross), cross == text.npos ? text : text.substr(cross + 1)};
        for (int i = 0; i < 2; ++i)
            if (!CLI::detail::lexical_cast(sides[i], size[i]) || size[i] < low || size[i] > high)
                throw CLI::ValidationError(name, "must be " + std::to_string(low) + " to " + std::to_string(high) +
                                                     ", or two such as 480x320, is " + text);
    };
    return app.add_option_function<std::string>(name, read, about)->type_name("SIZE")->default_str(shown(size));
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
