// SPDX-License-Identifier: MIT
#include "filter.hpp"

#include <algorithm>
#include <functional>
#include <utility>

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

umbrage::image<float> visibility_of(const options& o, umbrage::image_view<const float> map, const light& lamp,
                                    const receivers& receivers, example::progress& progress) {
    umbrage::image<float> visibility(receivers.depth.size());
    const auto filter_by = [&](umbrage::image_view<const float> depths, const auto& filter) {
        umbrage::visibility(depths, umbrage::depth32f{}, receivers.planes(), filter, visibility.view(),
                            progress.bands());
    };
    example::with_filter(o.filter, o.radius, [&](const auto& filter) {
        if (receivers.slope.empty()) return filter_by(map, filter);
        umbrage::image<float> projected(map.size);
        for (int y = 0; y < map.size.y; ++y)
            std::transform(map.row(y), map.row(y) + map.size.x, projected.view().row(y),
                           [&](float depth) { return lamp.projected_depth(depth); });
        filter_by(std::as_const(projected).view(), on_planes{erased(filter), receivers.slope});
    });
    return visibility;
}

}  // namespace shadow_render
