// SPDX-License-Identifier: MIT
#include "entries.hpp"

namespace parity {

const std::vector<entry>& entries() {
    static const std::vector<entry> all = [] {
        std::vector<entry> v;
        for (auto* add : {add_scalar}) add(v);
        return v;
    }();
    return all;
}

}  // namespace parity
