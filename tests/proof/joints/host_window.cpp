// SPDX-License-Identifier: MIT
//
// Hosts of shadows with the filter `window`.
#include "host_of_filter.hpp"
#include "hosts.hpp"

namespace joints {

std::unique_ptr<any_host> host_of_filter(const choices& c, const lit_scene& lit, glm::dvec3 origin,
                                         const umbrage::filters::window& filter) {
    return host_of(c, lit, origin, filter);
}

}  // namespace joints
