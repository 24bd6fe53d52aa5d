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

/// A filter over stored depths that a receiver's plane moves.
template <class Filter>
struct on_planes {
    const Filter& filter;
    const umbrage::image<glm::vec2>& slope;

    float operator()(const std::function<float(glm::ivec2)>& fetch, glm::vec2 coord, float receiver,
                     glm::ivec2 pixel = {}) const {
        const std::function<float(glm::ivec2)> moved =
            umbrage::on_receiver_plane(std::cref(fetch), slope[pixel], coord);
        if constexpr (requires { filter(moved, coord, receiver, pixel); }) return filter(moved, coord, receiver, pixel);
        else return filter(moved, coord, receiver);
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
        filter_by(projected, on_planes<std::remove_cvref_t<decltype(filter)>>{filter, receivers.slope});
    });
    return visibility;
}

}  // namespace shadow_render
