// SPDX-License-Identifier: MIT
//
// Somebody's Metal text, compiled as C++ when it is asked for. It runs in a process of its own.
#pragma once

#include <filesystem>
#include <memory>

#include "backend.hpp"

namespace check {

struct metal_files {
    std::filesystem::path compiler;  ///< clang++ or g++
    std::filesystem::path headers;   ///< folder of Metal's standard library as C++
    int seconds = 10;                ///< of processor time that one run may take
};

/// Runs entries that make_entry() made of Metal. run() throws std::runtime_error with the compiler's words or with what
/// stopped the function.
[[nodiscard]] std::unique_ptr<parity::backend> metal_as_cpp(const metal_files&);

}  // namespace check
