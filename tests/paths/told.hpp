// SPDX-License-Identifier: MIT
//
// What a program is told of a shadow named sun, whatever its setup, filter and encoding are.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/shader/bind.hpp>
#include <umbrage/shadow/anchored_map.hpp>
#include <umbrage/shadow/in_shader.hpp>

#include "job.hpp"

namespace paths {

struct told {
    umbrage::glsl::bound lookup, vertex, write;
    std::vector<std::byte> block;
    std::vector<umbrage::depth_view> views;
    glm::vec4 cleared{0};
    glm::ivec2 map_size{0};
    int columns = 1, rows = 1;  ///< of the maps in an atlas
    int channels = 1;           ///< of a texel in a color target
    bool floats = false;        ///< the channels are floats, not bytes
};

/// @param clip   without a direction of depth, which is the job's
[[nodiscard]] told tell(const job& of, umbrage::clip_space clip, umbrage::glsl::shadow_slots slots = {});

/// True for maps in a depth texture.
[[nodiscard]] inline bool is_depth(const job& of) {
    return of.text("map").starts_with("depth") || of.text("map").starts_with("shadow");
}
[[nodiscard]] inline bool compares(const job& of) { return of.text("map").starts_with("shadow"); }
[[nodiscard]] inline bool is_layered(const job& of) { return of.text("map").ends_with("array"); }
[[nodiscard]] inline bool is_reversed(const job& of) { return of.text("direction") == "reversed"; }

}  // namespace paths
