// SPDX-License-Identifier: MIT
#include <umbrage/filter/blocker/pcss.hpp>

#include "soft.hpp"

namespace parity {
namespace {

using namespace umbrage;

template <int Points>
void add_pcss(std::vector<entry>& all, std::size_t share) {
    add_soft_filter(all, glsl::pcss<Points>, share, Points != 16,
                    [](const sample& s, vec4 softness, vec4 rotation, auto is_lit) {
                        return pcss<Points>(s.depth(), at(s), s.x[0].z, softness, rotation, is_lit);
                    });
}

}  // namespace

void add_filter_blocker_pcss(std::vector<entry>& all) {
    add_pcss<8>(all, 8);
    add_pcss<16>(all, 8);
    add_pcss<32>(all, 16);
}

}  // namespace parity
