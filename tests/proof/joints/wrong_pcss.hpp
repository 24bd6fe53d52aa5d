// SPDX-License-Identifier: MIT
//
// Contact hardening with a program's mistakes in its search and in the width of its penumbras.
#pragma once

#include <cmath>
#include <type_traits>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/filter/blocker/pcss.hpp>

#include "tweaks.hpp"

namespace joints {

/// The library's filter, step by step.
struct wrong_pcss : umbrage::filters::pcss {
    tweaks t{};

    wrong_pcss(const umbrage::filters::pcss& right, const tweaks& wrong) : pcss(right), t(wrong) {}

    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver, glm::ivec2 pixel = {}) const {
        const glm::vec4 rotation = umbrage::disc_rotation(glm::vec2(pixel));
        return rotated(fetch, coord, receiver, rotation);
    }
    template <class Fetch>
    [[nodiscard]] float rotated(Fetch&& fetch, glm::vec2 coord, float receiver, glm::vec4 rotation) const {
        if (points == 8) return of<8>(fetch, coord, receiver, rotation);
        if (points == 16) return of<16>(fetch, coord, receiver, rotation);
        return of<32>(fetch, coord, receiver, rotation);
    }

private:
    template <int Points, class Fetch>
    [[nodiscard]] float of(Fetch&& fetch, glm::vec2 coord, float receiver, glm::vec4 rotation) const {
        const umbrage::comparison is_lit{direction};
        const glm::vec4 soft(softness);
        if (!umbrage::in_filter_domain(coord, receiver, is_lit)) return 1;
        const float z = umbrage::distance_code(receiver, is_lit);
        const glm::vec2 search = t.searches_least ? glm::vec2(soft.z) : umbrage::penumbra(z, soft);
        const glm::vec2 found =
            umbrage::blockers<Points>(fetch, glm::floor(coord * 256.0f), receiver, search, rotation, is_lit);
        if (!(found.x > 0)) return 1;
        const float mean = t.counts_all_points ? std::floor(found.y / Points) : umbrage::floor_divide(found.y, found.x);
        const float apart = t.drops_blockers ? z : z - mean;
        return umbrage::ellipse<Points>(fetch, coord, receiver, umbrage::penumbra(apart, soft), rotation, is_lit);
    }
};

/// The filter that a program with mistakes has in place of another.
template <class Filter>
using wrong_filter = std::conditional_t<std::is_same_v<Filter, umbrage::filters::pcss>, wrong_pcss, Filter>;

}  // namespace joints
