// SPDX-License-Identifier: MIT
//
// The library's texts of shaders as a program composes them. Each must compile in its dialect.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/umbrage.hpp>

#include "fault.hpp"

namespace turned {

/// Counts a text that glslang refuses as wrong. A program's own shader, which may follow it, is not in here.
void judge_text(const std::string& text, umbrage::glsl::version v);

}  // namespace turned

namespace watched::glsl {

using namespace ::umbrage::glsl;

[[nodiscard]] inline std::string source(version v, const std::vector<bound>& items, std::string_view preamble = {}) {
    std::string all = ::umbrage::glsl::source(v, items, preamble);
    if (turned::is_planted(turned::fault::brace_dropped)) all.erase(all.rfind('}'), 1);
    return turned::judge_text(all, v), all;
}

[[nodiscard]] inline std::string text(const std::vector<bound>& items, std::optional<version> v = {}) {
    std::string all = ::umbrage::glsl::text(items, v);
    if (v) turned::judge_text("#version " + std::string(directive(*v)) + '\n' + all, *v);
    return all;
}

}  // namespace watched::glsl
