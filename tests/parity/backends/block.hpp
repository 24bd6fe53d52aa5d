// SPDX-License-Identifier: MIT
//
// Jobs and results as bytes, for what draws in JavaScript: webgl_draw.mjs and webgpu_draw.mjs.
#pragma once

#include <string>
#include <vector>

#include "../backend.hpp"

namespace parity {

/// Parts as parts_of() in parts.mjs reads them: each with its length before it, and padded to four bytes.
[[nodiscard]] std::string joined_parts(const std::vector<std::string>& parts);

/// A job's size, shaders and textures, for the first `count` results.
/// @param with_textures   false: the textures are those of the block before
[[nodiscard]] std::string block_of(dialect d, const job& j, std::size_t count, bool with_textures);

/// Results of a job, of the pixels that were drawn.
[[nodiscard]] std::vector<vec4> results_of(const job& j, std::size_t count, const char* pixels);

/// Version of WebGL for a dialect.
[[nodiscard]] inline std::string web_version(dialect d) { return d == version::v100 ? "1" : "2"; }

}  // namespace parity
