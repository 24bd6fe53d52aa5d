// SPDX-License-Identifier: MIT
//
// Depth passes: large triangles into large maps, and many triangles, chunk by chunk, into one map.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <umbrage/draw/rasterize.hpp>

#include "works.hpp"

namespace {

using namespace umbrage;

constexpr int largest_side = 16384;                        // of a depth pass
constexpr std::size_t of_a_piece = std::size_t(48) << 16;  // bytes: three vertices for each of 2^16 triangles
constexpr std::size_t of_a_band = std::size_t(320) << 10;  // bytes: a copy of 2^16 texels, with a line for each row

/// Part of a map as a map of its own, and the matrix that draws it.
struct tile {
    image_view<float> map;
    glm::mat4 to_clip;
};
tile tile_of(image<float>& map, glm::ivec2 first) {
    const glm::ivec2 extent = glm::min(map.size(), glm::ivec2(largest_side));
    const glm::vec2 scale = glm::vec2(map.size()) / glm::vec2(extent);
    const glm::vec2 middle = (glm::vec2(first) + glm::vec2(extent) * 0.5f) * 2.0f / glm::vec2(map.size()) - 1.0f;
    const glm::mat4 scaled = glm::scale(glm::mat4(1), glm::vec3(scale, 1));
    return {map.view().region(first, extent), glm::translate(scaled, glm::vec3(-middle, 0))};
}

/// A square of two triangles across the map, in tiles of the largest side.
prepared fills(int power) {
    const auto map = std::make_shared<image<float>>(size_of(power), 1.0f);
    static constexpr std::array<glm::vec3, 4> corners{{{-1, -1, 0}, {1, -1, 0.5f}, {-1, 1, 0.25f}, {1, 1, 0.75f}}};
    static constexpr std::array<glm::uvec3, 2> triangles{{{0, 1, 2}, {1, 3, 2}}};
    return {double(area(map->size())), of_a_band + small_change,
            [map](stopwatch& watch) {
                std::ranges::fill(map->texels(), 1.0f);
                watch.add([&] {
                    for (int y = 0; y < map->size().y; y += largest_side)
                        for (int x = 0; x < map->size().x; x += largest_side) {
                            const tile part = tile_of(*map, {x, y});
                            rasterize_depth(part.map, {corners, triangles}, part.to_clip, cpu_clip_space);
                        }
                });
            },
            [map] {
                return at_probes(map->size(), [&](glm::ivec2 at) {
                    const glm::vec2 place = (glm::vec2(at) + 0.5f) / glm::vec2(map->size());
                    return (*map)[at] == place.x * 0.5f + place.y * 0.25f;
                });
            }};
}

/// Layers of small triangles: two for each cell of 2 x 2 texels. The nearest layer at a texel is any of them.
struct layers {
    int side, rows, cells = side / 2;  ///< of the map; of cells in a chunk; of cells in such a row
    std::uint32_t count, a_chunk = 2u * unsigned(rows * cells), a_layer = a_chunk * unsigned(cells / rows);
    image<float> map{{side, side}};
    std::vector<glm::vec3> positions{std::size_t(cells + 1) * std::size_t(rows + 1)};
    std::vector<glm::uvec3> in_order{a_chunk}, drawn{a_chunk};

    layers(std::uint32_t triangles, int map_side, int chunk_rows, bool scattered)
        : side(map_side), rows(chunk_rows), count(triangles) {
        for (unsigned i = 0; i < a_chunk; ++i) {
            const unsigned x = i / 2 % unsigned(cells), y = i / 2 / unsigned(cells), a = y * unsigned(cells + 1) + x,
                           c = a + unsigned(cells) + 1;
            in_order[i] = i % 2 == 0 ? glm::uvec3(a, a + 1, c) : glm::uvec3(a + 1, c + 1, c);
        }
        for (unsigned i = 0; i < a_chunk; ++i) drawn[i] = in_order[scattered ? i * 0x9E3779B1u % a_chunk : i];
    }

    [[nodiscard]] static float height(int x, int y, std::uint32_t layer) {
        std::uint32_t hash = std::uint32_t(x) * 0x9E3779B1u ^ std::uint32_t(y) * 0x85EBCA77u ^ layer * 0xC2B2AE3Du;
        hash = (hash ^ hash >> 15) * 0x2C1B3C6Du;
        return float(256 + (hash >> 20) % 3584) / 4096;
    }

    void draw(stopwatch& watch) {
        std::ranges::fill(map.texels(), 1.0f);
        for (std::uint32_t first = 0; first < count; first += a_chunk) {
            const int row = int(first % a_layer / a_chunk) * rows;
            for (int y = 0; y <= rows; ++y)
                for (int x = 0; x <= cells; ++x)
                    positions[std::size_t(y * (cells + 1) + x)] = {float(2 * x) / float(cells) - 1,
                                                                   float(2 * (row + y)) / float(cells) - 1,
                                                                   height(x, row + y, first / a_layer)};
            const bool whole = count - first >= a_chunk;
            const std::span triangles(whole ? drawn : in_order);
            watch.add([&] {
                rasterize_depth(map, {positions, triangles.first(std::min(count - first, a_chunk))}, glm::mat4(1),
                                cpu_clip_space);
            });
        }
    }

    [[nodiscard]] float expected(glm::ivec2 at) const {
        float nearest = 1;
        const int x = at.x / 2, y = at.y / 2;
        const glm::vec2 place = glm::vec2(at - 2 * glm::ivec2(x, y)) * 0.5f + 0.25f;
        for (std::uint32_t layer = 0; layer * a_layer + 2 * std::uint32_t(y * cells + x) < count; ++layer) {
            const float b = height(x + 1, y, layer), c = height(x, y + 1, layer);
            const bool upper = place.x + place.y > 1;
            const float corner = upper ? height(x + 1, y + 1, layer) : height(x, y, layer);
            const glm::vec2 from = upper ? 1.0f - place : place;
            nearest =
                std::min(nearest, corner + from.x * ((upper ? c : b) - corner) + from.y * ((upper ? b : c) - corner));
        }
        return nearest;
    }
};

prepared drawn_layers(const std::shared_ptr<layers>& of, std::size_t most_bytes) {
    return {double(of->count), most_bytes, [of](stopwatch& watch) { of->draw(watch); },
            [of] { return at_probes(of->map.size(), [&](glm::ivec2 at) { return of->map[at] == of->expected(at); }); }};
}

/// Two or three layers, in chunks of 2^17 triangles.
prepared draws_triangles(int power, bool scattered) {
    const std::uint32_t count = power > 26 ? 100'000'000u : 1u << power;
    const int side = size_of(power).y, rows = std::min(side / 2, (1 << 17) / side);
    return drawn_layers(std::make_shared<layers>(count, side, rows, scattered), of_a_piece + small_change);
}

/// Half a layer in one call.
prepared draws_at_once(int power) {
    const int side = 2 << power / 2;
    return drawn_layers(std::make_shared<layers>(1u << power, side, side / 4, true),
                        of_a_piece + (std::size_t(16) << 20) + small_change);
}

/// Triangles as high as the map, which are in all of its bands, in any order. They are culled: only lists take time.
prepared sorts_tall_triangles(int power) {
    struct both {
        image<float> map{{64, largest_side}, 1.0f};
        std::vector<glm::vec3> positions;
        std::vector<glm::uvec3> triangles;
    };
    const auto of = std::make_shared<both>();
    for (unsigned i = 0; i < 1u << power; ++i) {
        const float x = float(i) / float(1 << power) * 2 - 1;
        of->positions.insert(of->positions.end(), {{x, -1, 0.5f}, {x, 1, 0.5f}, {x + 0.001f, 1, 0.5f}});
        of->triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
    }
    return {
        double(of->triangles.size()), of_a_piece + (std::size_t(16) << 20),
        [of](stopwatch& watch) {
            watch.add([&] {
                rasterize_depth(of->map, {of->positions, of->triangles}, glm::mat4(1), cpu_clip_space, cull_mode::back);
            });
        },
        [of] { return std::ranges::all_of(of->map.texels(), [](float depth) { return depth == 1.0f; }); }};
}

const registered here({{"big_passes", "rasterize_depth, two triangles", 30, 4, fills},
                       {"big_triangles", "in the mesh's order", 27, 0.4,
                        [](int power) { return draws_triangles(power, false); }},
                       {"big_triangles", "scattered", 27, 0.4, [](int power) { return draws_triangles(power, true); }},
                       {"", "scattered, in one call", 20, 0.1, draws_at_once},
                       {"", "triangles as high as the map", 16, 1.1, sorts_tall_triangles}});

}  // namespace
