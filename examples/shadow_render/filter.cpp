// SPDX-License-Identifier: MIT
#include "filter.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include <umbrage/depth/depth32f.hpp>
#include <umbrage/filter/blocker/penumbra.hpp>
#include <umbrage/images/plane_visibility.hpp>
#include <umbrage/images/visibility.hpp>

#include <biases.hpp>
#include <filters.hpp>
#include <names.hpp>
#include <soft.hpp>

namespace shadow_render {
namespace {

umbrage::penumbra_params softness_of(const options& o, const light& lamp, glm::ivec2 map_size) {
    const float radius = 0.5f * o.light_size;
    return umbrage::make_penumbra_params(lamp.space, map_size, lamp.spot() ? radius : radius / o.distance,
                                         std::min(1.0f, o.max_radius), o.max_radius);
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
    return example::hardens(o.filter) ||
           (example::compares_along_plane(bias_of(o)) && !example::filters_ahead(o.filter));
}
int bytes_read(const options& o) {
    return example::filters_ahead(o.filter) ? example::prefilter_bytes(o.filter) : example::encoding_bytes(o.encoding);
}

look_up prepare(const options& o, umbrage::image_view<const float> map, const light& lamp,
                example::progress& progress) {
    const auto made = [](example::look_up by) {
        return [by = std::move(by)](const receivers& to) {
            umbrage::image<float> visibility(to.depth.size());
            by(to.sloped(), visibility.view());
            return visibility;
        };
    };
    if (example::filters_ahead(o.filter))
        return made(example::prefiltered(o.filter, map, static_cast<int>(o.radius), progress));

    look_up out;
    if (!compares_projected(o)) {
        example::with_filter(o.filter, o.radius, [&](const auto& filter) {
            out = made([=, &progress](const umbrage::sloped_receivers& to, umbrage::image_view<float> visibility) {
                umbrage::visibility(map, umbrage::depth32f{}, to.at, filter, visibility, progress.bands());
            });
        });
        return out;
    }
    const auto projected = std::make_shared<umbrage::image<float>>(map.size);
    for (int y = 0; y < map.size.y; ++y)
        std::transform(map.row(y), map.row(y) + map.size.x, projected->view().row(y),
                       [&](float depth) { return lamp.projected_depth(depth); });
    if (example::hardens(o.filter))
        out = made(example::contact_hardening(o.filter, projected->view(), softness_of(o, lamp, map.size), progress));
    else
        example::with_filter(o.filter, o.radius, [&](const auto& filter) {
            out = made([=, &progress, map = std::as_const(*projected).view()](const umbrage::sloped_receivers& to,
                                                                              umbrage::image_view<float> visibility) {
                umbrage::visibility(map, umbrage::depth32f{}, to, filter, visibility, progress.bands());
            });
        });
    return [projected, out](const receivers& to) { return out(to); };
}

}  // namespace shadow_render
