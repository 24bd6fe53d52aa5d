// SPDX-License-Identifier: MIT
//
// A limit of every shadow map: beside an inner corner, where two lit walls meet, a texel of one wall stands for both.
// A filter darkens such walls up to sqrt(2) times its reach from the corner, in texels of the map, and no farther.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <umbrage/filter/filters.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/shadow/shadow.hpp>

#include "../unit/rounds.hpp"

namespace {

using namespace umbrage;

/// A floor and a wall that meet in a line along x, rotated, under a sun that lights both.
class corner {
public:
    explicit corner(std::mt19937& random) {
        std::uniform_real_distribution<float> any(-1, 1);
        const auto way = [&] { return glm::vec3(any(random), any(random), any(random)); };
        const glm::vec3 a = glm::normalize(way()), b = glm::normalize(glm::cross(a, way()));
        turn_ = glm::mat3(a, b, glm::cross(a, b));
        for (const glm::vec3 p : {glm::vec3(-9, 0, 0), {9, 0, 0}, {9, 0, 9}, {-9, 0, 9}, {-9, 9, 0}, {9, 9, 0}})
            positions_.push_back(turn_ * p);
        light_ = fit_directional_light<float>(
            {.direction = turn_ * -glm::vec3(any(random), 1.05f + any(random), 1.05f + any(random)),
             .receivers = bounding_box<float>{glm::vec3(-4), glm::vec3(4)},
             .casters = bounding_box<float>{glm::vec3(-20), glm::vec3(20)},
             .clip = cpu_clip_space});
    }

    /// Distance from the corner to the farthest dark point of either wall, in texels of the map.
    template <class Filter>
    [[nodiscard]] double darkened(const Filter& filter, std::mt19937& random) const {
        const shadow s(light_, {512, 512}, filter);
        image<float> map(s.size(), s.cleared());
        s.draw(map, {positions_, triangles_});
        const glm::mat4 to_texels = texture_matrix(light_, {512, 512});
        const auto texel = [&](glm::vec3 p) { return glm::vec2(shadow_coordinate(to_texels, turn_ * p)); };
        std::uniform_real_distribution<float> along(-2, 2), away(0, 0.3f);
        double farthest = 0;
        for (int i = 0; i < 400; ++i) {
            const float x = along(random), q = away(random);
            const glm::vec3 p = i % 2 == 0 ? glm::vec3(x, 0, q) : glm::vec3(x, q, 0);
            const glm::vec3 normal = i % 2 == 0 ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, 1);
            if (s(map, turn_ * p, turn_ * normal) >= 1) continue;
            const glm::vec2 from = texel({x - 1, 0, 0}), line = glm::normalize(texel({x + 1, 0, 0}) - from);
            const glm::vec2 to = texel(p) - from;
            farthest = std::max(farthest, double(std::abs(to.x * line.y - to.y * line.x)));
        }
        return farthest;
    }

private:
    light_space<float> light_;
    glm::mat3 turn_{1};
    std::vector<glm::vec3> positions_;
    std::vector<glm::uvec3> triangles_{{0, 1, 2}, {0, 2, 3}, {0, 1, 5}, {0, 5, 4}};
};

template <class Filter>
void check(const Filter& filter, float reach) {
    std::mt19937 random(5);
    double farthest = 0;
    for (int i = 0; i < rounds(200); ++i) farthest = std::max(farthest, corner(random).darkened(filter, random));
    CAPTURE(filter.name);
    CHECK(farthest <= std::sqrt(2.0) * double(reach));
    CHECK(farthest > 0.5 * double(reach));  // it is seen
}

template <class Filter>
void check(const Filter& filter) {
    check(filter, filter.reach());
}

}  // namespace

TEST_CASE("inner corners: lit walls are darkened up to sqrt(2) times the filter's reach") {
    check(filters::hard{});
    check(filters::pcf_2x2{});
    check(filters::tent<3>);
    check(filters::castano<7>);
    check(filters::disc{});
    check(filters::box{.radius = 3});
}

TEST_CASE("inner corners: contact hardening under the real sun darkens them as a disc of its smallest radius does") {
    const auto softness = make_penumbra_params(0.00465f);
    check(filters::pcss{.softness = softness}, filters::disc{16, 1.0f}.reach());
    check(filters::pcss{.points = 32, .softness = softness}, filters::disc{32, 1.0f}.reach());
}
