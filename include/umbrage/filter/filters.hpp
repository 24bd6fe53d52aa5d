// SPDX-License-Identifier: MIT
//
// The filters as values, for functions over images.
//
//     umbrage::visibility(map.view(), umbrage::rg<11>{}, receivers.view(), umbrage::filters::box{.radius = 2}, out.view());
//
#pragma once

#include <array>

#include <glm/vec2.hpp>

#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/filter/pcf/four_tap.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/light/texture_matrix.hpp>

namespace umbrage {

/// The filters as values: what they need beyond map, coordinate and receiver.
namespace filters {

struct hard {
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::hard(fetch, coord, receiver);
    }
};

struct four_tap {
    std::array<glm::vec2, 4> offsets = default_taps<float>;  ///< in texels

    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::four_tap(fetch, coord + offsets[0], coord + offsets[1], coord + offsets[2], coord + offsets[3],
                                 receiver);
    }
};

struct pcf_2x2 {
    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::pcf_2x2(fetch, coord, receiver);
    }
};

struct pcf_2x2_dx_sdk {
    float epsilon = 0.0f;  ///< in depth

    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::pcf_2x2_dx_sdk(fetch, coord, receiver, epsilon);
    }
};

struct box {
    int radius = 1;  ///< clamped to 0..8

    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::box(fetch, coord, receiver, radius);
    }
};

/// The same result; for images of receivers it first asks, for the whole box, whether all of it is lit or in shadow.
/// Pays off for large radii, and where shadows have more inside than border.
struct hierarchical_box {
    int radius = 1;  ///< clamped to 0..8

    template <class Fetch>
    [[nodiscard]] float operator()(Fetch&& fetch, glm::vec2 coord, float receiver) const {
        return umbrage::box(fetch, coord, receiver, radius);
    }
};

}  // namespace filters

}  // namespace umbrage
