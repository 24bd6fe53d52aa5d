// SPDX-License-Identifier: MIT
#include "filter.hpp"

#include <umbrage/depth/depth32f.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/images/visibility.hpp>

namespace shadow_render {
namespace {

/// The filter of the options. Change a line here to try another.
template <class Use>
void with_filter(const options& o, Use&& use) {
    umbrage::with_filter(o.filter, [&](auto filter) {
        if constexpr (requires { filter.radius; }) filter.radius = o.radius;
        if constexpr (requires { filter.radius_texels; }) filter.radius_texels = static_cast<float>(o.radius);
        use(filter);
    });
}

}  // namespace

float reach_of(const options& o) {
    float reach = 0;
    with_filter(o, [&](const auto& filter) { reach = filter.reach(); });
    return reach;
}

umbrage::image<float> visibility_of(const options& o, const umbrage::image<float>& map, const receivers& receivers,
                                    example::progress& progress) {
    umbrage::image<float> visibility(receivers.depth.size());
    with_filter(o, [&](const auto& filter) {
        umbrage::visibility(map.view(), umbrage::depth32f{}, receivers.planes(), filter, visibility.view(),
                            progress.bands());
    });
    return visibility;
}

}  // namespace shadow_render
