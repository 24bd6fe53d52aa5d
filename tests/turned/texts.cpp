// SPDX-License-Identifier: MIT
#include "texts.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <sys/wait.h>
#include <unistd.h>

#include "judge.hpp"
#include "number.hpp"

namespace turned {

namespace {

/// Precisions that a user's shader declares in OpenGL ES.
std::string precisions(umbrage::glsl::version v) {
    using enum umbrage::glsl::version;
    if (v == v100) return "precision highp float;\n";
    if (v != v300_es && v != v310_es && v != v320_es) return "";
    return "precision highp float;\nprecision highp sampler2DArray;\nprecision highp sampler2DShadow;\n"
           "precision highp sampler2DArrayShadow;\nprecision highp usampler2D;\n";
}

}  // namespace

void judge_text(const std::string& text, umbrage::glsl::version v) {
    const std::string_view compiler = UMBRAGE_GLSLANG;
    const bool is_cheap = chosen.what == turn::none || chosen.what == turn::value || chosen.what == turn::rebuilt;
    if (compiler.empty() || !is_cheap) return;  // numbers are in few texts
    const auto file = std::filesystem::temp_directory_path() / ("turned_" + std::to_string(getpid()) + ".frag");
    const std::size_t line = text.find('\n') + 1;
    std::ofstream(file) << text.substr(0, line) << precisions(v) << text.substr(line) << "\nvoid main() {}\n";
    const char* const target = v == umbrage::glsl::version::vulkan ? " -V -o /dev/null " : " ";
    const std::string said = file.string() + ".txt";
    const int status = std::system((std::string(compiler) + target + file.string() + " > " + said).c_str());
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) {
        std::ifstream in(said);
        std::string first;
        for (std::string l; first.empty() && std::getline(in, l);)
            if (l.starts_with("ERROR")) first = l;
        add_wrong("a text that does not compile: " + first);
    }
    std::filesystem::remove(file);
    std::filesystem::remove(said);
}

}  // namespace turned
