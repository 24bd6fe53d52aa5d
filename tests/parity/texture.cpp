// SPDX-License-Identifier: MIT
#include "texture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <umbrage/light/point/cube_map.hpp>

#include "shader.hpp"

namespace parity {
namespace {

template <class Value>
void append(std::string& bytes, const Value& v) {
    bytes.append(reinterpret_cast<const char*>(&v), sizeof v);
}

/// An entry's map as one of its bindings has it. What lies around it, on other layers and faces, is 1 less the map: a
/// comparison with that gives another answer.
filled_texture bound_texture(const bound_map& b, int number, const texels& map) {
    using umbrage::glsl::texture;
    const texture kind = b.as.texture;
    filled_texture t;
    const bool compared = kind == texture::shadow || kind == texture::shadow_array;
    if (kind == texture::array || kind == texture::depth_array || kind == texture::shadow_array)
        t.image.shape = texture_image::array, t.image.layers = 2;
    if (umbrage::glsl::detail::is_cube(kind)) t.image.shape = texture_image::cube, t.image.layers = 6;
    if (kind == texture::integer) t.image.format = texture_image::whole_numbers;
    if (b.bytes) t.image.format = texture_image::bytes;
    if (b.has_depths()) t.image.format = b.short_depths ? texture_image::short_depths : texture_image::depths;
    if (compared)
        t.image.compare = b.as.direction == umbrage::depth_direction::forward ? texture_image::less_equal
                                                                              : texture_image::greater_equal;
    t.image.linear = b.linear;
    const ivec2 first = b.is_region() ? bound_map::origin : ivec2(0);
    t.image.size = map.size() + (b.is_region() ? bound_map::margin : ivec2(0));
    if (kind == texture::cube_faces) {
        t.image.size = ivec2(map.size().y / 2);
        for (int face = 0; face < 6; ++face)
            for (int y = 0; y < t.image.size.y; ++y)
                for (int x = 0; x < t.image.size.x; ++x)
                    t.texels.push_back(map[umbrage::cube_tile(face, t.image.size.x) + ivec2(x, y)]);
        return t;
    }
    const int layer = t.image.layers == 1 ? 0 : t.image.layers / 2;
    for (int l = 0; l < t.image.layers; ++l)
        for (int y = 0; y < t.image.size.y; ++y)
            for (int x = 0; x < t.image.size.x; ++x) {
                const ivec2 texel = ivec2(x, y) - first;
                const vec4 v = fetch_clamped(map.view(), texel);
                const bool own = l == layer && umbrage::inside_map(map.size(), texel);
                const vec4 turned(v[number % 4], v[(number + 1) % 4], v[(number + 2) % 4], v[(number + 3) % 4]);
                t.texels.push_back(own ? turned : 1.0f - turned);
            }
    return t;
}

}  // namespace

std::string filled_texture::bytes() const {
    if (image.format == texture_image::floats)
        return {reinterpret_cast<const char*>(texels.data()), texels.size() * sizeof(vec4)};
    std::string all;
    for (const vec4& t : texels) {
        if (image.format == texture_image::depths) append(all, t.x);
        else if (image.format == texture_image::short_depths)
            append(all, static_cast<std::uint16_t>(std::round(t.x * bound_map::most_short)));
        else if (image.format == texture_image::bytes) append(all, glm::vec<4, std::uint8_t>(glm::round(t * 255.0f)));
        else append(all, glm::uvec4(t * bound_map::whole));
    }
    return all;
}

namespace {

bool holds_bytes(const filled_texture& t) {
    return std::all_of(t.texels.begin(), t.texels.end(), [](const vec4& v) {
        const vec4 codes = glm::round(v * 255.0f);
        return glm::length(codes / 255.0f - v) < 1e-6f && glm::clamp(codes, 0.0f, 255.0f) == codes;  // never of a NaN
    });
}

}  // namespace

std::vector<filled_texture> textures(const job& j) {
    std::vector<filled_texture> all;
    const auto plain = [&](std::size_t unit, const auto& values, ivec2 size) {
        all.push_back({unit, {.size = size}, {values.begin(), values.end()}});
        all.back().texels.resize(static_cast<std::size_t>(size.x * size.y));
    };
    for (std::size_t k = 0; k < max_inputs; ++k)
        if (!j.x[k].empty()) plain(k, j.x[k], {width, rows(j.count)});
    const entry& e = *j.what;
    if (j.map && e.bound.empty()) plain(map_unit(0), j.map->texels(), j.map->size());
    for (std::size_t k = 0; k < e.bound.size(); ++k) {
        all.push_back(bound_texture(e.bound[k], static_cast<int>(k), *j.map));
        all.back().unit = map_unit(k);
    }
    if (!e.table.empty()) plain(table_unit, e.table.texels(), e.table.size());
    for (filled_texture& t : all)
        if (t.unit >= max_inputs)
            t.unorm_bits = t.image.format == texture_image::short_depths ? 16 : holds_bytes(t) ? 8 : 0;
    return all;
}

}  // namespace parity
