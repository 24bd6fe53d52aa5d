// SPDX-License-Identifier: MIT
#include <umbrage/filter/pcf/hard.hpp>

#include "../../entries.hpp"

namespace parity {

void add_filter_pcf_hard(std::vector<entry>& all) {
    using namespace umbrage;
    all.push_back(
        filter(umbrage::glsl::hard, "", [](const sample& s) { return vec4(hard(s.depth(), at(s), s.x[0].z)); }));
    all.push_back(reversed_filter(umbrage::glsl::hard, "", [](const sample& s) {
        return vec4(hard(s.depth(), at(s), s.x[0].z, greater_equal{}));
    }));
}

}  // namespace parity
