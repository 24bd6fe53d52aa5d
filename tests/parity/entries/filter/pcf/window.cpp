// SPDX-License-Identifier: MIT
#include <umbrage/filter/pcf/window.hpp>

#include "../../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

// Weights and steps of a texel whose products are not whole.
constexpr window_row three = make_window_row(3, {3.25f, 9.5f}, 128),
                     five = make_window_row(5, {2.5f, 8.25f, 10.5f}, 128),
                     seven = make_window_row(7, {0.75f, 5.25f, 12, 15.5f}, 64);

}  // namespace

void add_filter_pcf_window(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    const auto add = [&](const snippet& one, const std::string& numbers, const window_row& row, std::size_t share) {
        all.push_back(filter(one, numbers,
                             [&row](const sample& s) { return vec4(window_sum(s.depth(), at(s), s.x[0].z, row)); }));
        all.back().share = share;
    };
    add(glsl::window_sum<3>, ", 128.0, 3.25, 9.5", three, 2);
    add(glsl::window_sum<5>, ", 128.0, 2.5, 8.25, 10.5", five, 4);
    add(glsl::window_sum<7>, ", 64.0, 0.75, 5.25, 12.0, 15.5", seven, 8);
}

}  // namespace parity
