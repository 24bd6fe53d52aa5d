// SPDX-License-Identifier: MIT
#include "entries.hpp"

namespace parity {

const std::vector<entry>& entries() {
    static const std::vector<entry> all = [] {
        std::vector<entry> v;
        for (auto* add : {add_scalar, add_depth_kinds, add_depth_rg, add_depth_rgba, add_depth_foreign, add_light, add_fetch,
                          add_filter, add_shade})
            add(v);
        return v;
    }();
    return all;
}

}  // namespace parity
