// SPDX-License-Identifier: MIT
#include <umbrage/filter/pcf/disc.hpp>

#include "../../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// Forward and reversed.
/// @param lit   (sample, is_lit) -> visibility
void add(std::vector<entry>& all, const snippet& s, const std::string& radius, std::size_t share, const auto& lit) {
    const std::string arguments = radius + ", umbrage_disc_rotation(vec2(x0.x, x0.y))";
    all.push_back(filter(s, arguments, [lit](const sample& x) { return vec4(lit(x, less_equal{})); }));
    all.push_back(reversed_filter(s, arguments, [lit](const sample& x) { return vec4(lit(x, greater_equal{})); }));
    for (entry* e : {&all.back() - 1, &all.back()}) {
        e->also = {&umbrage::glsl::disc_rotation};
        e->share = share;
    }
    all.back().alike = true;
}

template <int Points>
void add(std::vector<entry>& all, std::size_t share) {
    add(all, umbrage::glsl::ellipse<Points>, ", vec2(floor(x0.w * 6.0), floor(x0.w * 15.0))", share,
        [](const sample& s, auto is_lit) {
            const vec2 radius = glm::floor(s.x[0].w * vec2(6.0f, 15.0f));
            return ellipse<Points>(s.depth(), at(s), s.x[0].z, radius, disc_rotation(at(s)), is_lit);
        });
    add(all, umbrage::glsl::disc<Points>, ", x0.w * 0.375", share, [](const sample& s, auto is_lit) {
        return disc<Points>(s.depth(), at(s), s.x[0].z, s.x[0].w * 0.375f, disc_rotation(at(s)), is_lit);
    });
}

}  // namespace

void add_filter_pcf_disc(std::vector<entry>& all) {
    add<8>(all, 2);
    add<16>(all, 4);
    add<32>(all, 8);
}

}  // namespace parity
