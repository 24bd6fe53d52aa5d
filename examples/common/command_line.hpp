// SPDX-License-Identifier: MIT
//
// Command lines: checks that CLI11's own let through, and one way to end.
//
//     app.add_option("--fov", options.fov)->check(example::within(1, 120));
//     int main(int argc, char** argv) { return example::run("name", [&] { ... }); }
//
#pragma once

#include <exception>
#include <iostream>
#include <stdexcept>
#include <sstream>
#include <string>

#include <CLI/CLI.hpp>

namespace example {

/// Thrown for options that cannot be met: ends the program with 2, everything else thrown with 1.
struct usage_error : std::runtime_error {
    using runtime_error::runtime_error;
};

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

/// Runs the program; what it throws becomes one line and an exit code: 2 for options, 1 for the rest.
template <class Program>
int run(const char* name, Program&& program) {
    try {
        program();
        return 0;
    } catch (const usage_error& error) {
        std::cerr << name << ": " << error.what() << '\n';
        return 2;
    } catch (const std::exception& error) {
        std::cerr << name << ": " << error.what() << '\n';
        return 1;
    }
}

}  // namespace example
