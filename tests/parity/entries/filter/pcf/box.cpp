// SPDX-License-Identifier: MIT
#include <umbrage/filter/pcf/box.hpp>

#include "../../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

int radius_of(const sample& s) { return static_cast<int>(s.x[0].w); }

}  // namespace

void add_filter_pcf_box(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;

    all.push_back(filter(glsl::box_count, ", int(x0.w)",
                         [](const sample& s) { return vec4(box_count(s.depth(), at(s), s.x[0].z, radius_of(s))); }));
    all.push_back(reversed_filter(glsl::box_count, ", int(x0.w)", [](const sample& s) {
        return vec4(box_count(s.depth(), at(s), s.x[0].z, radius_of(s), greater_equal{}));
    }));
    all.push_back(filter(glsl::box, ", int(x0.w)",
                         [](const sample& s) { return vec4(box(s.depth(), at(s), s.x[0].z, radius_of(s))); }));
    all.push_back({.primitive = &glsl::box_scale,
                   .classes = receivers(),
                   .twin = [](const sample& s) { return vec4(box_scale<float>(radius_of(s))); },
                   .call = "vec4(umbrage_box_scale(int(x0.w)))",
                   .maps = depth_maps()});
}

}  // namespace parity
