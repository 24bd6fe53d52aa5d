// SPDX-License-Identifier: MIT
//
// A whole image of receivers against a shadow map, with any filter and any encoding.
//
//     umbrage::visibility(map.view(), umbrage::rg<11>{}, receivers.view(), umbrage::filters::pcf_2x2{}, out.view());
//
#pragma once

#include <array>
#include <stdexcept>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/filter/box.hpp>
#include <umbrage/filter/four_tap.hpp>
#include <umbrage/filter/hard.hpp>
#include <umbrage/filter/pcf_2x2.hpp>
#include <umbrage/image.hpp>
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

}  // namespace filters

/// @param map         shadow map, texels of the encoding; outside, the nearest texel inside counts
/// @param encoding    how the map's texels hold depth; its edge decides ties
/// @param receivers   (x, y) in texels of the map, z depth, biased
/// @param filter      one of filters::, or any callable (fetch, coord, receiver) -> visibility
/// @param out         visibility, 1 lit; same size as receivers
/// @throws std::invalid_argument  sizes differ, or the map is empty
template <class Encoding, class Filter>
void visibility(image_view<const typename Encoding::texel> map, Encoding encoding,
                image_view<const glm::vec3> receivers, Filter filter, image_view<float> out) {
    if (receivers.size != out.size) throw std::invalid_argument("umbrage::visibility: sizes differ");
    const auto fetch = decoded(map, encoding);
    if (receivers.empty()) return;
    for (int y = 0; y < receivers.size.y; ++y) {
        const glm::vec3* from = receivers.row(y);
        float* to = out.row(y);
        for (int x = 0; x < receivers.size.x; ++x) to[x] = filter(fetch, glm::vec2(from[x]), from[x].z);
    }
}

}  // namespace umbrage
