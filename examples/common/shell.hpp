// SPDX-License-Identifier: MIT
//
// Programs run as a person would, by a line of the shell: for the examples' checks.
//
//     const example::finished viewer = example::run_line(example::quoted(program) + "--help");
//
#pragma once

#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <sys/wait.h>

namespace example {

struct finished {
    int code;          ///< -1: ended by a signal
    std::string said;  ///< on either stream
};

/// @throws std::runtime_error  there is no shell
[[nodiscard]] inline finished run_line(const std::string& line) {
    FILE* pipe = popen((line + " 2>&1").c_str(), "r");
    if (!pipe) throw std::runtime_error("cannot run " + line);
    finished out{0, {}};
    for (int c; (c = std::fgetc(pipe)) != EOF;) out.said += static_cast<char>(c);
    const int status = pclose(pipe);
    out.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return out;
}

/// As one word of the line, and a space.
[[nodiscard]] inline std::string quoted(const std::filesystem::path& path) {
    return std::string("'").append(path.string()).append("' ");
}

}  // namespace example
