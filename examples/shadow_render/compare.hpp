// SPDX-License-Identifier: MIT
//
// --compare: every filter on one scene, against rays to an area light, on one sheet: compare.png.
#pragma once

#include <shadow_map.hpp>

#include <progress.hpp>

#include "options.hpp"
#include "view.hpp"

namespace shadow_render {

/// @throws std::runtime_error  the table of costs cannot be read, or the sheet not written
void compare(const options& o, const view& v, const example::shadow_map& map, example::progress& progress);

}  // namespace shadow_render
