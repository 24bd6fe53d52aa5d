// SPDX-License-Identifier: MIT
#include "soft.hpp"

#include <algorithm>
#include <stdexcept>

#include <umbrage/depth/depth32f.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/images/visibility.hpp>

namespace example {

const std::vector<std::string>& hardening_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        umbrage::filters::soft::for_each([&](const auto& filter) { all.emplace_back(filter.name); });
        return all;
    }();
    return names;
}

bool hardens(std::string_view filter) {
    return std::ranges::find(hardening_names(), filter) != hardening_names().end();
}

look_up contact_hardening(std::string_view name, umbrage::image_view<const float> map,
                          const umbrage::penumbra_params& softness, progress& progress) {
    look_up out;
    umbrage::filters::soft::with(name, [&](auto filter) {
        filter.softness = softness;
        out = [=, &progress](const umbrage::sloped_receivers& receivers, umbrage::image_view<float> visibility) {
            if (receivers.slope_x.empty())
                umbrage::visibility(map, umbrage::depth32f{}, receivers.at, filter, visibility, progress.bands());
            else umbrage::visibility(map, umbrage::depth32f{}, receivers, filter, visibility, progress.bands());
        };
    });
    if (!out) throw std::invalid_argument("no contact hardening is called " + std::string(name));
    return out;
}

}  // namespace example
