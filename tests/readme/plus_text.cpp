// SPDX-License-Identifier: MIT
//
// Checks that CONTRIBUTING.md's filter is one of the library's, and writes its text for a compiler of GLSL.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>

#include <umbrage/filter/pcf/plus.hpp>
#include <umbrage/shader/glsl.hpp>

static_assert(umbrage::known_filter<umbrage::filters::plus>);

TEST_CASE("plus: its text, for readme/shaders") {
    namespace glsl = umbrage::glsl;
    std::filesystem::create_directories(UMBRAGE_SHADERS);
    std::ofstream file(UMBRAGE_SHADERS "/plus.frag");
    file << glsl::source(glsl::version::v100, {glsl::plus}, "precision mediump float;") << "void main() {}\n";
    CHECK(file.flush().good());
}
