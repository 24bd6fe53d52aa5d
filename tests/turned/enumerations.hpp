// SPDX-License-Identifier: MIT
//
// Enumerations whose values a program writes by name, as `depth_direction::reversed`, and the clip spaces.
#pragma once

#include <iterator>
#include <string_view>
#include <vector>

#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/snippet.hpp>
#include <umbrage/draw/mesh.hpp>
#include <umbrage/shader/binding.hpp>

namespace turned {

template <class T>
struct named_value {
    std::string_view name;
    T value;
};

/// Values of the argument's enumeration, which alone counts.
inline std::vector<named_value<umbrage::depth_direction>> named_values(umbrage::depth_direction) {
    using enum umbrage::depth_direction;
    return {{"forward", forward}, {"reversed", reversed}};
}
inline std::vector<named_value<umbrage::depth_range>> named_values(umbrage::depth_range) {
    using enum umbrage::depth_range;
    return {{"unset", unset}, {"zero_to_one", zero_to_one}, {"minus_one_to_one", minus_one_to_one}};
}
inline std::vector<named_value<umbrage::handedness>> named_values(umbrage::handedness) {
    using enum umbrage::handedness;
    return {{"right", right}, {"left", left}};
}
inline std::vector<named_value<umbrage::texture_origin>> named_values(umbrage::texture_origin) {
    using enum umbrage::texture_origin;
    return {{"bottom", bottom}, {"top", top}};
}
inline std::vector<named_value<umbrage::outside_map>> named_values(umbrage::outside_map) {
    using enum umbrage::outside_map;
    return {{"bordered", bordered}, {"clamped", clamped}};
}
inline std::vector<named_value<umbrage::near_plane>> named_values(umbrage::near_plane) {
    using enum umbrage::near_plane;
    return {{"clips", clips}, {"clamps", clamps}};
}
inline std::vector<named_value<umbrage::cull_mode>> named_values(umbrage::cull_mode) {
    using enum umbrage::cull_mode;
    return {{"none", none}, {"front", front}, {"back", back}};
}
inline std::vector<named_value<umbrage::glsl::version>> named_values(umbrage::glsl::version) {
    using enum umbrage::glsl::version;
    static_assert(umbrage::glsl::versions.size() == 13);
    return {{"v100", v100},       {"v110", v110},       {"v120", v120},       {"v130", v130}, {"v150", v150},
            {"v300_es", v300_es}, {"v310_es", v310_es}, {"v320_es", v320_es}, {"v330", v330}, {"v430", v430},
            {"v450", v450},       {"v460", v460},       {"vulkan", vulkan}};
}
inline std::vector<named_value<umbrage::glsl::texture>> named_values(umbrage::glsl::texture) {
    std::vector<named_value<umbrage::glsl::texture>> all;
    for (int k = int(umbrage::glsl::texture::texture_2d); k <= int(umbrage::glsl::texture::shadow_array); ++k)
        all.push_back({umbrage::glsl::detail::name_of(umbrage::glsl::texture(k)), umbrage::glsl::texture(k)});
    return all;
}
inline std::vector<named_value<umbrage::clip_space>> named_values(const umbrage::clip_space&) {
    std::vector<named_value<umbrage::clip_space>> all{{"cpu_clip_space", umbrage::cpu_clip_space}};
    for (const umbrage::named_clip_space& each : umbrage::clip_spaces) all.push_back({each.name, each.value});
    return all;
}

/// Names of all values of the enumeration that a program calls `enumeration::value`; none: it is another name.
[[nodiscard]] inline std::vector<std::string_view> names_of_values(std::string_view enumeration,
                                                                   std::string_view value) {
    std::vector<std::string_view> names;
    const auto take_if = [&](bool is_this, const auto& values) {
        for (const auto& each : values)
            if (is_this) names.push_back(each.name);
    };
    take_if(enumeration == "depth_direction", named_values(umbrage::depth_direction()));
    take_if(enumeration == "depth_range", named_values(umbrage::depth_range()));
    take_if(enumeration == "handedness", named_values(umbrage::handedness()));
    take_if(enumeration == "texture_origin", named_values(umbrage::texture_origin()));
    take_if(enumeration == "outside_map", named_values(umbrage::outside_map()));
    take_if(enumeration == "near_plane", named_values(umbrage::near_plane()));
    take_if(enumeration == "cull_mode", named_values(umbrage::cull_mode()));
    take_if(enumeration == "version", named_values(umbrage::glsl::version()));
    take_if(enumeration == "texture", named_values(umbrage::glsl::texture()));
    take_if(value.ends_with("_clip_space"), named_values(umbrage::clip_space()));
    return names;
}

}  // namespace turned
