// SPDX-License-Identifier: MIT
//
// The parts of a system as GLSL: how its map is written and read, which filter and which bias it has.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <glm/gtc/type_precision.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/shader/bind.hpp>
#include <umbrage/shader/glsl.hpp>

#include <systems.hpp>

namespace viewer {

namespace glsl = umbrage::glsl;
using snippets = std::vector<glsl::snippet>;

/// Storage of a system's map: expressions that write a `depth` and read it. They are the encoding's, or the table
/// texture of 2048 x 1 texels and pixel shader 1.4's r / 8 + g.
struct storage {
    snippets writers;
    std::string write;
    glsl::binding map;
};
[[nodiscard]] storage storage_of(const example::shadow_system& s);

/// float map_depth(float z), the system's kind of depth from z/w in [0, 1], and what it calls; `planes`, declared
/// ahead, are z_near, z_far, 1 / z_far.
[[nodiscard]] std::string map_depth(const example::shadow_system& s);
[[nodiscard]] const snippets& depth_snippets();
inline constexpr const char* planes = "uniform vec3 planes;\n";

/// The way back, of an expression; and the depth that a map holds which is filtered ahead: it grows evenly.
[[nodiscard]] std::string projected(const example::shadow_system& s, const std::string& depth);
[[nodiscard]] std::string even(const example::shadow_system& s, const std::string& depth);

/// True when stored depths and receivers become z/w for the comparison.
[[nodiscard]] bool compares_projected(const example::shadow_system& s);

/// Whether the vertex shader applies four texture matrices, one a tap.
[[nodiscard]] inline bool has_tap_matrices(const example::shadow_system& s) { return s.filter == "four_tap"; }

/// What a bias does to a receiver, and what it declares ahead of the snippets.
struct bias {
    snippets uses;
    std::string statement, ahead;
};
[[nodiscard]] bias bias_of(const example::shadow_system& s);

/// The map whose depths a filter compares: as it is stored, and what projection and bias make of that.
[[nodiscard]] glsl::binding compared_map(const example::shadow_system& s, glsl::binding map);

struct filter {
    snippets uses;
    std::string visibility;  ///< expression of p, depth, biased, receiver and epsilon
};
[[nodiscard]] filter filter_of(const example::shadow_system& s);

/// A map that is filtered ahead: its texel, an expression of even `depth`, and how wide a pass blurs it each way.
struct prefilter {
    snippets writers;
    std::string texel;
    int taps;  ///< taps of the blur: 1, 3, 5 or 7
};
[[nodiscard]] std::optional<prefilter> prefilter_of(const example::shadow_system& s);

/// A map as a summed-area table, of even depths: how it is made, and looked up by a snippet that is called with
/// `arguments` after the receiver.
struct summed_table {
    std::function<umbrage::image<glm::u16vec4>(umbrage::image_view<const float>)> make;
    const glsl::snippet* look_up;
    std::string arguments;
};
[[nodiscard]] std::optional<summed_table> summed_table_of(const example::shadow_system& s);

/// The side that is compared with the map, an expression of `depth`, biased.
[[nodiscard]] std::string receiver_of(const example::shadow_system& s);

}  // namespace viewer
