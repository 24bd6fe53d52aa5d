// SPDX-License-Identifier: MIT
//
// Jobs to measure: snippets, and the shaders of three.js, Babylon.js and PlayCanvas for the same job.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <umbrage/shader/glsl.hpp>

namespace bench {

/// A text file, whole.
/// @throws std::runtime_error   it is empty, or not there
[[nodiscard]] std::string read(const std::string& path);

struct shader {
    std::string owner, name;
    std::string preamble;  ///< macros, functions of peers
    std::vector<umbrage::glsl::bound> snippets;
    std::string result;  ///< vec4 expression of x0 .. x5, map, table, depth_map, map_size
};

/// Shaders for one job; the first is ours.
struct job {
    std::string name;
    std::vector<shader> shaders;
    bool apart = false;  ///< inputs are unrelated, as a point and its normal are; else x1 to x5 are the same
};

/// @param folder   from packing/peers.mjs
[[nodiscard]] std::vector<job> jobs(const std::string& folder);

/// The job of jobs() that looks up cascades.
[[nodiscard]] job cascades();

/// Jobs of soft shadows.
/// @param folder   as of jobs()
[[nodiscard]] std::vector<job> soft(const std::string& folder);

/// Cost of a border for each filter.
[[nodiscard]] job outside();

/// Shadows as bind() prints them, against their parts.
[[nodiscard]] std::vector<job> shadows();

/// Whole shadows, one job for each setup and filter.
/// @param folder   as of jobs()
[[nodiscard]] std::vector<job> whole(const std::string& folder);

/// Shaders by setup and filter.
using whole_shaders = std::multimap<std::string, shader>;
/// Whole shadows of three.js, Babylon.js and PlayCanvas.
[[nodiscard]] whole_shaders engines(const std::string& folder);

/// Every snippet of the registry, called as the parity tests call it.
[[nodiscard]] job registry();

}  // namespace bench
