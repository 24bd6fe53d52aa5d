// SPDX-License-Identifier: MIT
//
// The page's sections, and what they share.
#pragma once

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/debug/overlay.hpp>

#include <text.hpp>

#include "page.hpp"
#include "render.hpp"

namespace gallery {

struct settings {
    std::filesystem::path output = "gallery/index.html", viewer{};
    int size = 564;
};

/// @param folder  for pictures on their way into the page
void add_systems(page& page, const settings& o, const std::filesystem::path& folder);
void add_encodings(page& page, const settings& o, const std::filesystem::path& folder);
void add_biases(page& page, const settings& o, const std::filesystem::path& folder);
void add_lights(page& page, const settings& o);
void add_filters(page& page, const settings& o, const std::filesystem::path& folder);
void add_soft_shadows(page& page, const settings& o, const std::filesystem::path& folder);

using example::text;

/// A snippet's summary.
[[nodiscard]] inline std::string sentence(std::string_view summary) {
    std::string out(summary);
    out[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(out[0])));
    return out + '.';
}
[[nodiscard]] inline std::string milliseconds(double ms) { return text("%.1f ms", ms); }
[[nodiscard]] inline std::string sides(glm::ivec2 size) { return text("%d × %d", size.x, size.y); }
[[nodiscard]] inline std::string depth_error(double error) {
    return error > 0 ? text("%.2e = 2^%.4g", error, std::log2(error)) : "0";
}

/// A map as it is stored: its channels from left to right. Of a float the depth, stretched.
[[nodiscard]] inline example::picture packed(const stored_depth& map, const umbrage::image<float>& depth, int edge) {
    using namespace example;
    std::vector<picture> channels;
    const auto add = [&](const umbrage::image<float>& from, auto&& color) {
        umbrage::overlay(channels.emplace_back(glm::ivec2(edge)), from,
                         {.size = glm::ivec2(edge), .map_origin = picture_clip.origin}, color);
    };
    for (const auto& channel : map.channels) {
        umbrage::image<float> values(channel.size());
        std::ranges::transform(channel.texels(), values.texels().begin(),
                               [](std::uint8_t v) { return static_cast<float>(v) / 255.0f; });
        add(values, [](float v) { return v; });
    }
    if (channels.empty()) add(depth, umbrage::stretch(depth));
    return side_by_side(channels);
}

}  // namespace gallery
