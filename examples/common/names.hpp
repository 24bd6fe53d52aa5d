// SPDX-License-Identifier: MIT
//
// Names of the library's encodings, filters and biases, in the order of its lists.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace example {

[[nodiscard]] const std::vector<std::string>& encoding_names();
[[nodiscard]] const std::vector<std::string>& filter_names();
[[nodiscard]] const std::vector<std::string>& bias_names();

/// Bytes a texel of an encoding by its name.
[[nodiscard]] int encoding_bytes(std::string_view encoding);

/// Reach of a filter by its name; of a box or a disc of its own radius, or of another.
[[nodiscard]] float reach_of(std::string_view filter, std::optional<float> radius = {});

/// Name of a filter in shaders. Filters of soft.hpp keep their own names.
[[nodiscard]] std::string_view snippet_of(std::string_view filter);

/// The bias of a filter, by its name, where the user chooses none: receiver_plane for contact hardening, whose radius
/// differs from receiver to receiver, acne_free for all others.
[[nodiscard]] std::string_view usual_bias(std::string_view filter);

/// True when the bias of this name compares along the receiver's plane.
[[nodiscard]] bool compares_along_plane(std::string_view bias);

}  // namespace example
