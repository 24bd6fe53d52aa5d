// SPDX-License-Identifier: MIT
//
// tier_a.cpp's inputs for what takes integers to soft shadows: quotients, searches for blockers, boxes of tables.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>

#include <umbrage/core/floor_divide.hpp>
#include <umbrage/filter/blocker/dpcf.hpp>
#include <umbrage/filter/blocker/pcss.hpp>
#include <umbrage/filter/table/summed_variance.hpp>

#include "hostile.hpp"

namespace hostile {

/// A box of n texels, some of one code and the rest of half of it, in a table that has wrapped before it.
struct two_codes {
    int width, height;
    std::uint32_t code, wrapped;

    [[nodiscard]] glm::vec4 operator()(glm::ivec2 at) const {
        const std::uint32_t n = at.x > 0 && at.y > 0 ? static_cast<std::uint32_t>(width * height) : 0;
        const std::uint32_t some = n / 3, other = code / 2;
        const std::uint32_t sum = wrapped + some * code + (n - some) * other;
        const std::uint32_t squares = wrapped + some * code * code + (n - some) * other * other;
        return {float(sum & 0xFFFF), float(sum >> 16), float(squares & 0xFFFF), float(squares >> 16)};
    }
};

/// Runs of the filters that read many texels each.
template <int Points, class Run, class Fetch>
void each_with_points(const Run& run, const Fetch& fetch) {
    using namespace umbrage;
    const std::string n = std::to_string(Points);
    const auto draw = [](source& s) {
        const glm::vec2 coord = s.coords();
        const float x = float(s.below(4)), y = float(s.below(4));
        return std::array{glm::vec3(coord, s.level()), glm::vec3(x, y, 0.0f)};
    };
    run(("blockers" + n).c_str(), 16, draw, [&](const auto& in) {
        const glm::vec2 coord(in[0]);
        const glm::vec4 turn = disc_rotation(glm::vec2(in[1]));
        const glm::vec2 at = inside_texel_space(coord) ? glm::floor(coord * 256.0f) : glm::vec2(0.0f);
        return glm::vec4(blockers<Points>(fetch, at, in[0].z, glm::vec2(77.0f, 31.0f), turn),
                         blockers<Points>(fetch, at, in[0].z, glm::vec2(9.0f), turn, greater_equal{}));
    });
    const auto both = [&](const std::string& name, auto use) {
        run((name + n).c_str(), 16, draw, [&](const auto& in) {
            const glm::vec2 coord(in[0]);
            const glm::vec4 turn = disc_rotation(glm::vec2(in[1]));
            return glm::vec2(use(coord, in[0].z, turn, less_equal{}), use(coord, in[0].z, turn, greater_equal{}));
        });
    };
    both("ellipse", [&](glm::vec2 coord, float receiver, glm::vec4 turn, auto is_lit) {
        return ellipse<Points>(fetch, coord, receiver, glm::vec2(23.0f, 71.0f), turn, is_lit);
    });
    const glm::vec4 soft(0.0234375f, 0.046875f, 5.0f, 100.0f);
    both("pcss", [&](glm::vec2 coord, float receiver, glm::vec4 turn, auto is_lit) {
        return pcss<Points>(fetch, coord, receiver, soft, turn, is_lit);
    });
    both("dpcf", [&](glm::vec2 coord, float receiver, glm::vec4 turn, auto is_lit) {
        return dpcf<Points>(fetch, coord, receiver, soft, turn, is_lit);
    });
    run(("hardened_kernel" + n).c_str(), 1,
        [](source& s) {
            const float blocked = float(s.below(Points + 1));
            return glm::vec2(blocked, float(s.below(257)));
        },
        [](glm::vec2 v) { return hardened_kernel<Points>(v.x, v.y); });
}

/// Calls run(name, one input of so many, draw, op).
template <class Run, class Fetch>
void each_soft_shadow(const Run& run, const Fetch& fetch) {
    using namespace umbrage;
    const auto fraction = [](source& s) {
        const std::uint32_t a = s.below(1u << 24), b = 64 + (s.below(1u << 24) >> s.below(24));
        return glm::vec2(float(s.one_in(2) ? a : a / b * b), float(b));
    };
    run("floor_divide", 1, fraction, [](glm::vec2 v) { return floor_divide(v.x, v.y); });
    run("correct_quotient", 1, fraction, [](glm::vec2 v) {
        const auto a = std::uint32_t(v.x), b = std::uint32_t(v.y);
        return correct_quotient(float(a / b) + float(a % 3) - 1.0f, v.x, v.y);
    });
    run(
        "distance_code", 1, [](source& s) { return s.depth(); },
        [](float v) { return glm::vec2(distance_code(v), distance_code(v, greater_equal{})); });
    run(
        "penumbra", 1,
        [](source& s) {
            const float apart = float(s.below(1 << 17)) - 65536.0f, digits = float(s.below(256));
            const float parts = float(1 << s.below(16)), least = float(s.below(64));
            return glm::vec4(apart, digits / parts, least, 64.0f + float(s.below(4032)));
        },
        [](glm::vec4 v) { return glm::uvec2(penumbra(v.x, glm::vec4(v.y, v.y * 0.5f, v.z, v.w))); });
    run(
        "blocker", 1,
        [](source& s) {
            const glm::ivec2 t = s.texel();
            return std::pair{t, s.level()};
        },
        [&](const auto& in) { return blocker(fetch, in.first, in.second); });
    run(
        "box_moments", 1,
        [](source& s) {
            const int width = 1 + int(s.below(64)), height = 1 + int(s.below(64));
            const std::uint32_t code = s.below(4096);
            return two_codes{width, height, code, s.next()};
        },
        [](const two_codes& table) {
            return box_moments<float>(table, glm::ivec2(0), glm::ivec2(table.width, table.height));
        });
    each_with_points<8>(run, fetch);
    each_with_points<16>(run, fetch);
    each_with_points<32>(run, fetch);
}

}  // namespace hostile
