// SPDX-License-Identifier: MIT
#include "filter.hpp"

#include <algorithm>
#include <functional>

#include <umbrage/bias/receiver_plane.hpp>
#include <umbrage/depth/depth32f.hpp>
#include <umbrage/images/visibility.hpp>

#include <filters.hpp>

namespace shadow_render {
namespace {

using any_fetch = std::function<float(glm::ivec2)>;
using any_filter = std::function<float(const any_fetch&, glm::vec2, float, glm::ivec2)>;

template <class Filter>
any_filter erased(const Filter& filter) {
    return [&filter](const any_fetch& fetch, glm::vec2 coord, float receiver, glm::ivec2 pixel) {
        if constexpr (requires { filter(fetch, coord, receiver, pixel); }) return filter(fetch, coord, receiver, pixel);
        else return filter(fetch, coord, receiver);
    };
}

/// A filter over stored depths that a receiver's plane moves; compiled once for all filters.
struct on_planes {
    any_filter filter;
    const umbrage::image<glm::vec2>& slope;

    float operator()(const any_fetch& fetch, glm::vec2 coord, float receiver, glm::ivec2 pixel = {}) const {
        return filter(umbrage::on_receiver_plane(std::cref(fetch), slope[pixel], coord), coord, receiver, pixel);
    }
};

}  // namespace

umbrage::image<float> visibility_of(const options& o, const umbrage::image<float>& map, const light& lamp,
                                    const receivers& receivers, example::progress& progress) {
    umbrage::image<float> visibility(receivers.depth.size());
    const auto filter_by = [&](const umbrage::image<float>& depths, const auto& filter) {
        umbrage::visibility(depths.view(), umbrage::depth32f{}, receivers.planes(), filter, visibility.view(),
                            progress.bands());
    };
    example::with_filter(o.filter, o.radius, [&](const auto& filter) {
        if (receivers.slope.empty()) return filter_by(map, filter);
        umbrage::image<float> projected(map.size());
        std::ranges::transform(map.texels(), projected.texels().begin(),
                               [&](float depth) { return lamp.projected_depth(depth); });
        filter_by(projected, on_planes{erased(filter), receivers.slope});
    });
    return visibility;
}

}  // namespace shadow_render
