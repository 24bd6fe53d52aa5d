// SPDX-License-Identifier: MIT
//
// The outdoor scene: the same on every machine, as its random numbers are hashes of places.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "random.hpp"
#include "scene.hpp"
#include "shapes.hpp"

namespace example {
namespace {

constexpr float half_side = 500;  ///< metres, from the middle
constexpr glm::vec3 grass{0.20f, 0.30f, 0.09f}, stone{0.36f, 0.34f, 0.31f}, bark{0.24f, 0.16f, 0.10f},
    needles{0.07f, 0.17f, 0.08f}, leaves{0.16f, 0.30f, 0.07f}, plaster{0.72f, 0.67f, 0.57f}, tiles{0.45f, 0.16f, 0.10f},
    wood{0.35f, 0.25f, 0.16f};

/// Random values on integers and smooth between them.
float noise(glm::vec2 p, std::uint32_t which) {
    const glm::vec2 first = glm::floor(p), t = p - first, s = t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
    const glm::ivec2 at(first);
    const auto row = [&](int y) {
        return glm::mix(random_of({at.x, at.y + y}, which), random_of({at.x + 1, at.y + y}, which), s.x);
    };
    return glm::mix(row(0), row(1), s.y);
}

/// Sums of ever smaller and lower noise, about 0 to 1.
float hills(glm::vec2 p, int octaves) {
    float sum = 0, share = 0.5f;
    for (int i = 0; i < octaves; ++i, share *= 0.5f, p = p * 2.03f + 17.0f)
        sum += share * noise(p, static_cast<std::uint32_t>(i));
    return sum;
}

struct village {
    glm::vec2 at;
    int houses;
};
constexpr std::array villages{village{{0, 0}, 16}, village{{-130, -260}, 12}, village{{240, -150}, 9}};

/// Hills, higher towards the edges and away from the camera; even ground below villages.
float height(glm::vec2 p) {
    const auto open = [](glm::vec2 q) {
        const float rise = glm::smoothstep(120.0f, 620.0f, glm::length(q * glm::vec2(1, 0.8f) - glm::vec2(0, 60)));
        return 46.0f * hills(q / 190.0f + 3.0f, 6) + 150.0f * rise * hills(q / 300.0f + 40.0f, 6);
    };
    float h = open(p);
    for (const village& v : villages) {
        static const std::array grounds{open(villages[0].at), open(villages[1].at), open(villages[2].at)};
        const float ground = grounds[static_cast<std::size_t>(&v - villages.data())];
        h = glm::mix(ground + 0.25f * (h - ground), h, glm::smoothstep(25.0f, 95.0f, glm::distance(p, v.at)));
    }
    return h;
}

glm::vec3 normal_at(glm::vec2 p) {
    constexpr float d = 1;
    return glm::normalize(glm::vec3(height(p - glm::vec2(d, 0)) - height(p + glm::vec2(d, 0)), 2 * d,
                                    height(p - glm::vec2(0, d)) - height(p + glm::vec2(0, d))));
}

/// The ground, in tiles.
void add_ground(std::vector<copies>& parts) {
    constexpr int tiles_a_side = 8;
    constexpr unsigned cells = 32;  // cells per side of a tile: 3.9 meters each
    constexpr float side = 2 * half_side / tiles_a_side;
    for (int j = 0; j < tiles_a_side; ++j)
        for (int i = 0; i < tiles_a_side; ++i) {
            mesh tile;
            const glm::vec2 corner = glm::vec2(i, j) * side - half_side;
            add_surface(tile, {cells, cells}, glm::mat4(1), grass, [&](float u, float v) {
                const glm::vec2 p = corner + side * glm::vec2(u, 1 - v);
                return vertex{{p.x, height(p), p.y}, normal_at(p)};
            });
            for (std::size_t k = 0; k < tile.positions.size(); ++k) {
                const glm::vec3 p = tile.positions[k];
                const float steep = glm::smoothstep(0.90f, 0.75f, tile.normals[k].y);
                const float dry = noise(glm::vec2(p.x, p.z) / 23.0f, 50) * 0.35f + 0.8f;
                tile.colors[k] = glm::mix(grass * glm::vec3(dry, 1, 1), stone, steep);
            }
            parts.push_back({std::move(tile), {glm::mat4(1)}});
        }
}

/// A cone on its foot, or with `top` a part of one.
void add_cone(mesh& out, glm::vec3 foot, float radius, float tall, glm::vec3 color, unsigned sides, float top = 0) {
    const glm::mat4 place = glm::translate(glm::mat4(1), foot);
    add_surface(out, {sides, 1}, place, color, [&](float u, float v) {
        const glm::vec2 at = on_circle(u);
        const float r = glm::mix(radius, top, v);
        const glm::vec3 around(at.y, 0, at.x);
        return vertex{r * around + glm::vec3(0, v * tall, 0),
                      glm::normalize(tall * around + glm::vec3(0, radius - top, 0))};
    });
}

/// A ball with dents.
void add_lump(mesh& out, glm::vec3 center, glm::vec3 radius, glm::vec3 color, float dents, std::uint32_t which) {
    add_surface(out, {9, 5}, glm::translate(glm::mat4(1), center), color, [&](float u, float v) {
        const glm::vec3 n = on_sphere(u, v);
        const float out_by = 1 - dents * noise(glm::vec2(n) * 2.0f + n.z * 3.1f, which);
        return vertex{radius * n * out_by, glm::normalize(n / radius)};
    });
}

mesh conifer() {
    mesh m;
    add_cone(m, {0, -0.5f, 0}, 0.28f, 3, bark, 6, 0.2f);
    for (int i = 0; i < 4; ++i) {
        const auto at = static_cast<float>(i);
        add_cone(m, {0, 1.6f + 2.1f * at, 0}, 2.5f - 0.5f * at, 3.6f - 0.2f * at, needles * (0.85f + 0.12f * at), 10);
    }
    return m;
}

mesh broadleaf() {
    mesh m;
    add_cone(m, {0, -0.5f, 0}, 0.35f, 4.5f, bark, 7, 0.22f);
    add_lump(m, {0, 5.6f, 0}, {2.6f, 2.3f, 2.6f}, leaves, 0.25f, 60);
    add_lump(m, {1.5f, 4.6f, 0.6f}, {1.7f, 1.4f, 1.8f}, leaves * 0.9f, 0.25f, 61);
    add_lump(m, {-1.2f, 4.7f, -0.9f}, {1.8f, 1.5f, 1.6f}, leaves * 1.1f, 0.25f, 62);
    return m;
}

mesh rock() {
    mesh m;
    add_lump(m, {0, 0.2f, 0}, {1.1f, 0.8f, 0.9f}, stone, 0.45f, 63);
    return m;
}

/// Eight metres long, with eaves and a chimney.
mesh house() {
    mesh m;
    const auto wall = [&](glm::vec3 out, float half) {
        add_surface(m, {1, 1}, glm::mat4(1), plaster, [&](float u, float v) {
            return vertex{out + glm::vec3(0, 4 * v - 1, 0) + half * (2 * u - 1) * glm::vec3(out.z != 0, 0, out.x != 0),
                          glm::normalize(out)};
        });
    };
    wall({4, 0, 0}, 3), wall({-4, 0, 0}, 3), wall({0, 0, 3}, 4), wall({0, 0, -3}, 4);
    const auto slope = [&](float side) {
        for (const float below : {0.0f, 0.2f})
            add_surface(m, {1, 1}, glm::mat4(1), tiles, [&](float u, float v) {
                const float out = glm::mix(3.6f, 0.0f, v);
                return vertex{{(2 * u - 1) * side * 4.5f, 2.6f + 3.6f - out - below, side * out},
                              glm::normalize(glm::vec3(0, 1, side))};
            });
    };
    slope(1), slope(-1);
    for (const float end : {-4.0f, 4.0f})
        add_surface(m, {1, 1}, glm::mat4(1), plaster, [&](float u, float v) {
            return vertex{{end, 3 + 3 * v, (2 * u - 1) * 3 * (1 - v)}, {end / 4, 0, 0}};
        });
    add_box(m, glm::translate(glm::mat4(1), {2, 5.5f, 1}), {0.35f, 1.2f, 0.35f}, stone);
    return m;
}

/// Two posts and two rails, three metres.
mesh fence() {
    mesh m;
    for (const float x : {-1.5f, 0.0f})
        add_box(m, glm::translate(glm::mat4(1), {x, 0.4f, 0}), {0.06f, 0.8f, 0.06f}, wood);
    for (const float y : {0.5f, 0.95f})
        add_box(m, glm::translate(glm::mat4(1), {0, y, 0}), {1.5f, 0.06f, 0.025f}, wood);
    return m;
}

glm::mat4 standing(glm::vec2 at, float turn, float size, float sunk = 0) {
    const glm::mat4 place = glm::translate(glm::mat4(1), {at.x, height(at) - sunk, at.y});
    return glm::scale(place * rotation_about(1, turn), glm::vec3(size));
}

/// Houses around each middle, a fence about every other.
void add_villages(copies& houses, copies& fences) {
    for (const village& v : villages)
        for (int i = 0; i < v.houses; ++i) {
            const glm::ivec2 number(i, static_cast<int>(v.at.x));
            const float angle = (static_cast<float>(i) + 0.5f * random_of(number, 70)) / static_cast<float>(v.houses);
            const float out = (i % 2 == 0 ? 22.0f : 40.0f) + 8.0f * random_of(number, 71);
            const glm::vec2 way = on_circle(angle), at = v.at + out * glm::vec2(way.y, way.x);
            const float turn = angle + 0.15915494f * random_of(number, 72);
            houses.places.push_back(standing(at, turn, 1));
            if (i % 2 == 0) continue;
            for (int k = 0; k < 12; ++k) {
                const auto along = static_cast<float>(k % 4) * 3 - 4.5f;
                const float quarter = turn + 0.25f * static_cast<float>(k / 4);
                const glm::vec2 to = on_circle(quarter), ahead(to.y, to.x), aside(ahead.y, -ahead.x);
                fences.places.push_back(standing(at + 7.5f * ahead + along * aside, quarter, 1));
            }
        }
}

/// Woods and single trees, rocks where it is steep.
void add_plants(copies& conifers, copies& broadleaves, copies& rocks) {
    constexpr int cells = 120;
    constexpr float side = 2 * half_side / cells;
    for (glm::ivec2 c{0}; c.y < cells; ++c.y)
        for (c.x = 0; c.x < cells; ++c.x) {
            const glm::vec2 at = (glm::vec2(c) + glm::vec2(random_of(c, 80), random_of(c, 81))) * side - half_side;
            float space = 1;  // away from villages
            for (const village& v : villages)
                space = std::min(space, glm::smoothstep(45.0f, 110.0f, glm::distance(at, v.at)));
            const float wood_here = glm::smoothstep(0.45f, 0.6f, noise(at / 85.0f, 90)) * space;
            const float chance = random_of(c, 82), turn = random_of(c, 83), size = 0.7f + 0.7f * random_of(c, 84);
            const float steep = 1 - normal_at(at).y;
            if (steep < 0.22f && chance < 0.02f + 0.8f * wood_here) {
                const bool high = height(at) > 55 + 40 * noise(at / 40.0f, 91);
                (high ? conifers : broadleaves).places.push_back(standing(at, turn, size));
            } else if (chance > (steep > 0.12f ? 0.6f : 0.97f)) {
                rocks.places.push_back(standing(at, turn, size * (0.6f + 1.6f * random_of(c, 85)), 0.2f));
            }
        }
}

}  // namespace

scene outdoor_scene() {
    scene s;
    s.target = {0, height(glm::vec2(0)) + 3, 0};
    s.z_near = 1, s.z_far = 1600;
    copies houses{house(), {}}, fences{fence(), {}}, conifers{conifer(), {}}, broadleaves{broadleaf(), {}},
        rocks{rock(), {}};
    add_ground(s.parts);
    add_villages(houses, fences);
    add_plants(conifers, broadleaves, rocks);
    for (copies* part : {&houses, &fences, &conifers, &broadleaves, &rocks}) s.parts.push_back(std::move(*part));
    for (const copies& part : s.parts)
        for (const glm::mat4& place : part.places) append(s.geometry, part.shape, place);
    find_bounds(s);
    return s;
}

}  // namespace example
