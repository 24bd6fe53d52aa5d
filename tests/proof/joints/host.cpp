// SPDX-License-Identifier: MIT
//
// The filter of a draw, and its host.
#include "host_of_filter.hpp"

namespace joints {

namespace {

/// Calls use(filter) with a draw's filter.
template <class Use>
auto with_filter(const filter_choice& f, const Use& use) {
    using namespace umbrage::filters;
    using umbrage::make_penumbra_params;
    switch (f.number) {
        case 0: return use(hard{});
        case 1: return use(pcf_2x2{});
        case 2: return use(box{.radius = int(f.radius * 4)});
        case 3: return use(window::values[std::size_t(f.radius * 9)]);
        case 4: return use(disc{.points = f.points, .radius_texels = float(0.5 + 3.5 * f.radius)});
    }
    const auto softness = make_penumbra_params(float(f.light_size), float(f.least_radius()), float(f.most_radius));
    return f.is_pcss() ? use(pcss{.points = f.points, .softness = softness})
                       : use(dpcf{.points = f.points, .softness = softness});
}

}  // namespace

float reach_of(const filter_choice& f) {
    return with_filter(f, [](const auto& filter) { return filter.reach(); });
}

std::unique_ptr<any_host> make_host(const choices& c, const lit_scene& lit, glm::dvec3 origin) {
    return with_filter(c.filter, [&](const auto& filter) { return host_of_filter(c, lit, origin, filter); });
}

}  // namespace joints
