// SPDX-License-Identifier: MIT
#include <umbrage/filter/blocker/dpcf.hpp>

#include "soft.hpp"

namespace parity {
namespace {

using namespace umbrage;

template <int Points>
void add_dpcf(std::vector<entry>& all, std::size_t share) {
    add_soft_filter(all, glsl::dpcf<Points>, share, true,
                    [](const sample& s, vec4 softness, vec4 rotation, auto is_lit) {
                        return dpcf<Points>(s.depth(), at(s), s.x[0].z, softness, rotation, is_lit);
                    });
}

/// Number of blockers in x0.x, the ratio in x0.y.
template <int Points>
void add_hardened(std::vector<entry>& all) {
    all.push_back({.primitive = &glsl::hardened_kernel<Points>,
                   .classes = {{"random",
                                [](auto, random& r, sample& s) {
                                    const auto blocked = static_cast<float>(r.below(Points + 1));
                                    s.x[0] = {blocked, static_cast<float>(r.below(257)), 0.0f, 0.0f};
                                }}},
                   .twin = [](const sample& s) { return vec4(hardened_kernel<Points>(s.x[0].x, s.x[0].y)); },
                   .call = "vec4(umbrage_" + std::string(glsl::hardened_kernel<Points>.name) + "(x0.x, x0.y))",
                   .alike = Points != 16});
}

}  // namespace

void add_filter_blocker_dpcf(std::vector<entry>& all) {
    add_hardened<8>(all);
    add_hardened<16>(all);
    add_hardened<32>(all);
    add_dpcf<8>(all, 8);
    add_dpcf<16>(all, 8);
    add_dpcf<32>(all, 16);
}

}  // namespace parity
