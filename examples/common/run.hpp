// SPDX-License-Identifier: MIT
//
// One way to end a program.
//
//     int main(int argc, char** argv) { return example::run("name", [&] { ... }); }
//
#pragma once

#include <exception>
#include <iostream>
#include <stdexcept>

namespace example {

/// Thrown for options that cannot be met: ends the program with 2, everything else thrown with 1.
struct usage_error : std::runtime_error {
    using runtime_error::runtime_error;
};

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
