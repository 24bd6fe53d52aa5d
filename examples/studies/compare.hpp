// SPDX-License-Identifier: MIT
//
// studies filters: every filter on one scene, against rays to an area light, on one sheet: filters.png.
#pragma once

#include <filesystem>

#include <scene.hpp>

#include "options.hpp"

namespace shadow_render {

/// @param shaders   shaders.tsv of `tests/bench/shaders/run`; empty: the one in build/bench-shaders, if any
/// @throws std::runtime_error  the table of costs cannot be read, or the sheet not written
void compare(const options& o, const example::scene& scene, const std::filesystem::path& shaders);

}  // namespace shadow_render
