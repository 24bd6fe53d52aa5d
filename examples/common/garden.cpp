// SPDX-License-Identifier: MIT
//
// The default scene: things whose shadows are hard to draw, side by side. A mast's shadow is sharp at its foot and soft
// where the ball's falls on the wall, a fence is thinner than texels, leaves are many, and a knot shadows itself.
// Objects on the ground reach below it, so that no light leaks in where they meet.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "circle.hpp"
#include "random.hpp"
#include "scene.hpp"
#include "shapes.hpp"

namespace example {
namespace garden {
namespace {

constexpr glm::vec3 paving{0.36f, 0.33f, 0.30f}, joint{0.17f, 0.15f, 0.14f}, plaster{0.58f, 0.46f, 0.33f},
    stone{0.30f, 0.31f, 0.33f}, wood{0.74f, 0.71f, 0.64f}, steel{0.50f, 0.53f, 0.57f}, orange{0.80f, 0.20f, 0.04f},
    bark{0.16f, 0.11f, 0.08f}, leaves{0.11f, 0.24f, 0.05f}, clay{0.50f, 0.17f, 0.09f};
constexpr float wall_z = -1.75f, half_width = 5.2f, front = 4.0f;  ///< extent of the ground before the wall
constexpr float sunk = 0.1f;                                       ///< depth to which objects reach into the ground

glm::mat4 at(glm::vec3 p) { return glm::translate(glm::mat4(1), p); }

/// A box by two opposite corners.
void add_block(mesh& out, glm::vec3 low, glm::vec3 high, glm::vec3 color) {
    add_box(out, at(0.5f * (low + high)), 0.5f * (high - low), color);
}

void add_flat(mesh& out, glm::vec2 low, glm::vec2 high, glm::vec3 color) {
    add_surface(out, {1, 1}, glm::mat4(1), color, [&](float u, float v) {
        return vertex{{glm::mix(low.x, high.x, u), 0, glm::mix(high.y, low.y, v)}, {0, 1, 0}};
    });
}

/// Slabs, in rows that are offset by half a slab, and joints between them.
void add_ground(mesh& out) {
    constexpr float slab = 0.5f, gap = 0.012f, first = -half_width, back = wall_z - 0.3f;
    constexpr int rows = 13, columns = 22;
    for (int j = 0; j < rows; ++j) {
        const float low = back + static_cast<float>(j) * slab, high = std::min(low + slab, front) - gap;
        add_flat(out, {first, high}, {-first, high + gap}, joint);
        for (int i = 0; i < columns; ++i) {
            const float from = first + (static_cast<float>(i) - 0.5f * static_cast<float>(j % 2)) * slab,
                        to = std::min(from + slab, -first) - gap, begin = std::max(from, first);
            if (begin >= to) continue;
            add_flat(out, {begin, low}, {to, high}, paving * (0.90f + 0.16f * random_of({i, j}, 0)));
            add_flat(out, {to, low}, {to + gap, high}, joint);
        }
    }
}

/// A wall with a coping, and three steps before it.
void add_wall(mesh& out) {
    add_block(out, {-half_width, -sunk, wall_z - 0.2f}, {half_width, 1.5f, wall_z}, plaster);
    add_block(out, {-half_width, 1.46f, wall_z - 0.25f}, {half_width, 1.56f, wall_z + 0.05f}, stone);
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<float>(i);
        add_block(out, {1.05f, -sunk, wall_z - 0.1f}, {2.55f, 0.22f * (k + 1), wall_z + 0.3f * (3 - k)}, stone);
    }
}

/// A picket with a point.
void add_picket(mesh& out, const glm::mat4& place) {
    constexpr float half = 0.032f, depth = 0.012f, shoulder = 0.66f, tip = 0.74f;
    constexpr glm::vec2 outline[]{{-half, -sunk}, {half, -sunk}, {half, shoulder}, {0, tip}, {-half, shoulder}};
    for (const float side : {-1.0f, 1.0f}) {
        add_surface(out, {1, 1}, place, wood, [&](float u, float v) {
            return vertex{{side * half * (2 * u - 1), glm::mix(-sunk, shoulder, v), side * depth}, {0, 0, side}};
        });
        add_surface(out, {1, 1}, place, wood, [&](float u, float v) {
            const float x = side * half * (2 * u - 1) * (1 - v);
            return vertex{{x, glm::mix(shoulder, tip, v), side * depth}, {0, 0, side}};
        });
    }
    for (std::size_t i = 0; i < std::size(outline); ++i) {
        const glm::vec2 from = outline[i], to = outline[(i + 1) % std::size(outline)],
                        along = glm::normalize(to - from);
        add_surface(out, {1, 1}, place, wood, [&](float u, float v) {
            return vertex{glm::vec3(glm::mix(from, to, v), depth * (2 * u - 1)), {along.y, -along.x, 0}};
        });
    }
}

void add_fence(mesh& out, glm::vec3 middle, double turns, int pickets) {
    constexpr float apart = 0.17f;
    const glm::mat4 place = at(middle) * rotation_about(1, turns);
    for (int i = 0; i < pickets; ++i)
        add_picket(out, place * at({(static_cast<float>(i) - 0.5f * static_cast<float>(pickets - 1)) * apart, 0, 0}));
    for (const float y : {0.2f, 0.52f})
        add_box(out, place * at({0, y, -0.02f}), {0.5f * static_cast<float>(pickets) * apart, 0.025f, 0.014f}, wood);
}

/// A mast with a ball on its top.
void add_mast(mesh& out, glm::vec3 foot) {
    constexpr float height = 2.3f, ball = 0.17f;
    add_pillar(out, foot - glm::vec3(0, sunk, 0), 0.035f, height + sunk, steel);
    add_surface(out, {64, 32}, at(foot + glm::vec3(0, height + 0.8f * ball, 0)), orange, [&](float u, float v) {
        const glm::vec3 n = on_sphere(u, v);
        return vertex{ball * n, n};
    });
}

glm::vec3 random_direction(int i, std::uint32_t which) {
    const float up = 2 * random_of({i, 0}, which) - 1;
    return {std::sqrt(1 - up * up) * on_circle(random_of({i, 1}, which)), up};
}

/// A trunk, and a crown of leaves, each a quad, in five clouds.
void add_tree(mesh& out, glm::vec3 foot) {
    add_pillar(out, foot - glm::vec3(0, sunk, 0), 0.06f, 1.3f + sunk, bark);
    struct cloud {
        glm::vec3 center;
        float radius;
    };
    constexpr cloud crown[]{{{0, 1.85f, 0}, 0.46f},
                            {{-0.42f, 1.45f, 0.1f}, 0.36f},
                            {{0.44f, 1.5f, 0.05f}, 0.38f},
                            {{0.05f, 1.4f, 0.4f}, 0.34f},
                            {{0, 1.5f, -0.38f}, 0.38f}};
    constexpr int count = 1500;
    for (int i = 0; i < count; ++i) {
        const cloud& c = crown[i % 5];
        const float far = std::max({random_of({i, 0}, 1), random_of({i, 1}, 1), random_of({i, 2}, 1)});
        const glm::vec3 outwards = random_direction(i, 2), center = foot + c.center + c.radius * far * outwards;
        const glm::vec3 along = random_direction(i, 3),
                        across = glm::normalize(glm::cross(along, random_direction(i, 4)));
        const float size = 0.026f + 0.02f * random_of({i, 3}, 1);
        const glm::vec3 normal = glm::normalize(outwards + 0.6f * glm::cross(along, across));
        const glm::vec3 color =
            leaves * glm::vec3(0.8f + 0.7f * random_of({i, 4}, 1), 0.85f + 0.4f * random_of({i, 5}, 1), 1);
        add_surface(out, {1, 1}, glm::mat4(1), color, [&](float u, float v) {  // corners at the ends of a cross
            return vertex{center + size * ((u + v - 1) * 1.3f * along + (u - v) * 0.8f * across), normal};
        });
    }
}

/// A trefoil knot, which winds around a torus, on a plinth.
void add_knot(mesh& out, glm::vec3 foot) {
    constexpr float tall = 0.34f, ring = 2, winding = 0.95f, tube = 0.56f, size = 0.135f;
    add_block(out, foot + glm::vec3(-0.3f, -sunk, -0.3f), foot + glm::vec3(0.3f, tall, 0.3f), stone);
    const glm::mat4 place =
        at(foot + glm::vec3(0, tall + size * (ring + winding + 0.5f * tube), 0)) * rotation_about(1, 0.11);
    add_surface(out, {288, 40}, place, clay, [&](float u, float v) {
        const glm::vec2 around = on_circle(2 * double(u) + 0.25), over = on_circle(3 * double(u)),
                        of = on_circle(-double(v));
        const glm::vec3 radial(around, 0), axis(0, 0, 1), ahead(-around.y, around.x, 0);
        const glm::vec3 outwards = over.x * radial + over.y * axis;
        const glm::vec3 along =
            glm::normalize(2 * (ring + winding * over.x) * ahead + 3 * winding * (over.x * axis - over.y * radial));
        const glm::vec3 n = of.x * outwards + of.y * glm::cross(along, outwards);
        return vertex{size * (ring * radial + winding * outwards + tube * n), n};
    });
}

}  // namespace
}  // namespace garden

scene default_scene() {
    using namespace garden;
    scene s;
    add_ground(s.geometry);
    add_wall(s.geometry);
    add_fence(s.geometry, {-1.5f, 0, 0.3f}, 0.195, 14);
    add_mast(s.geometry, {0.5f, 0, -0.35f});
    add_tree(s.geometry, {-2.15f, 0, -0.8f});
    add_knot(s.geometry, {2.2f, 0, 0.8f});
    find_bounds(s);
    s.target = {0.4f, 0.8f, -0.4f};
    return s;
}

}  // namespace example
