// SPDX-License-Identifier: MIT
#include "filter.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include <umbrage/bias/receiver_plane.hpp>
#include <umbrage/depth/depth32f.hpp>
#include <umbrage/filter/blocker/penumbra.hpp>
#include <umbrage/images/visibility.hpp>

#include <biases.hpp>
#include <filters.hpp>
#include <names.hpp>
#include <soft.hpp>

namespace shadow_render {
namespace {

using any_fetch = std::function<float(glm::ivec2)>;
using any_filter = std::function<float(const any_fetch&, glm::vec2, float, glm::ivec2)>;

template <class Filter>
any_filter erased(const Filter& filter) {
    return [=](const any_fetch& fetch, glm::vec2 coord, float receiver, glm::ivec2 pixel) {
        if constexpr (requires { filter(fetch, coord, receiver, pixel); }) return filter(fetch, coord, receiver, pixel);
        else return filter(fetch, coord, receiver);
    };
}

/// A filter over stored depths that a receiver's plane moves; compiled once for all filters.
struct on_planes {
    any_filter filter;
    const umbrage::image<glm::vec2>& slope;

    float operator()(const any_fetch& fetch, glm::vec2 coord, float receiver, glm::ivec2 pixel = {}) const {
        return filter(umbrage::apply_receiver_plane(std::cref(fetch), slope[pixel], coord), coord, receiver, pixel);
    }
};

umbrage::penumbra_params softness_of(const options& o, const light& lamp) {
    const float radius = 0.5f * o.light_size;
    return umbrage::make_penumbra_params(lamp.units, lamp.spot() ? radius : radius / o.distance,
                                         std::min(1.0f, o.max_radius), o.max_radius);
}

/// Calls use(filter) with the one over depths that the options choose.
template <class Use>
void with_filter(const options& o, const light& lamp, Use&& use) {
    if (example::with_filter(o.filter, o.radius, use)) return;
    umbrage::filters::soft::with(o.filter, [&](auto filter) {
        filter.softness = softness_of(o, lamp);
        use(filter);
    });
}

}  // namespace

const std::vector<std::string>& filter_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all = example::filter_names();
        for (const auto* more : {&example::hardening_names(), &example::prefilter_names()})
            all.insert(all.end(), more->begin(), more->end());
        return all;
    }();
    return names;
}

float reach_of(const options& o) {
    const float reach = example::soft_reach(o.filter, o.max_radius).value_or(example::reach_of(o.filter, o.radius));
    return o.reach.value_or(example::covered(reach));
}

bool compares_projected(const options& o) {
    return example::hardens(o.filter) || (example::moves_stored_depths(o.bias) && !example::filters_ahead(o.filter));
}
int bytes_read(const options& o) {
    return example::filters_ahead(o.filter) ? example::prefilter_bytes(o.filter) : example::encoding_bytes(o.encoding);
}

look_up prepare(const options& o, umbrage::image_view<const float> map, const light& lamp,
                example::progress& progress) {
    const auto made = [](example::look_up by) {
        return [by = std::move(by)](const receivers& to) {
            umbrage::image<float> visibility(to.depth.size());
            by(to.planes(), visibility.view());
            return visibility;
        };
    };
    if (example::filters_ahead(o.filter))
        return made(example::prefiltered(o.filter, map, static_cast<int>(o.radius), progress));

    look_up out;
    if (!compares_projected(o)) {
        example::with_filter(o.filter, o.radius, [&](const auto& filter) {
            out = made([=, &progress](const umbrage::receiver_planes& to, umbrage::image_view<float> visibility) {
                umbrage::visibility(map, umbrage::depth32f{}, to, filter, visibility, progress.bands());
            });
        });
        return out;
    }
    const auto projected = std::make_shared<umbrage::image<float>>(map.size);
    for (int y = 0; y < map.size.y; ++y)
        std::transform(map.row(y), map.row(y) + map.size.x, projected->view().row(y),
                       [&](float depth) { return lamp.projected_depth(depth); });
    if (!example::moves_stored_depths(o.bias)) {
        out = made(example::contact_hardening(o.filter, projected->view(), softness_of(o, lamp), progress));
        return [projected, out](const receivers& to) { return out(to); };
    }
    with_filter(o, lamp, [&](const auto& filter) {
        out = [=, &progress, by = erased(filter)](const receivers& to) {
            umbrage::image<float> visibility(to.depth.size());
            umbrage::visibility(std::as_const(*projected).view(), umbrage::depth32f{}, to.planes(),
                                on_planes{by, to.slope}, visibility.view(), progress.bands());
            return visibility;
        };
    });
    return out;
}

}  // namespace shadow_render
