// SPDX-License-Identifier: MIT
#include <umbrage/filter/pcf/disc_hardware.hpp>

#include "../turned.hpp"

namespace parity {
namespace {

using namespace umbrage;

template <int Points>
constexpr auto disc_twin = [](auto fetch, const sample& s, auto is_lit) {
    return disc_hardware<Points>(fetch, at(s), s.x[0].z, turned_radius(s), turned_by(s), is_lit);
};

template <int Points>
constexpr auto ellipse_twin = [](auto fetch, const sample& s, auto is_lit) {
    return ellipse_hardware<Points>(fetch, at(s), s.x[0].z, turned_radii(s), turned_by(s), is_lit);
};

template <int Points>
void add(std::vector<entry>& all) {
    const auto add_one = [&](const snippet& one, const std::string& arguments, const auto& twin) {
        all.push_back(
            filter(one, arguments, [twin](const sample& s) { return vec4(twin(s.depth(), s, less_equal{})); }));
        all.back().also = {&glsl::disc_rotation};
        all.back().share = Points;
        all.back().alike = Points != 16;
    };
    add_one(glsl::ellipse_hardware<Points>, turned_ellipse, ellipse_twin<Points>);
    add_one(glsl::disc_hardware<Points>, turned_arguments, disc_twin<Points>);
}

/// By the sampler of a kind of map.
template <int Points>
void add(std::vector<entry>& all, const std::string& name, const umbrage::glsl::binding& as) {
    all.push_back(sampled_filter(glsl::ellipse_hardware<Points>, turned_ellipse, name, as, ellipse_twin<Points>));
    all.back().also = {&glsl::disc_rotation};
    all.push_back(sampled_filter(glsl::disc_hardware<Points>, turned_arguments, name, as, disc_twin<Points>));
    all.back().also = {&glsl::disc_rotation};
}

}  // namespace

void add_filter_pcf_disc_hardware(std::vector<entry>& all) {
    using glsl::texture;
    add<8>(all);
    add<16>(all);
    add<32>(all);
    add<16>(all, "shadow", {.texture = texture::shadow, .outside = outside_map::clamped});
    add<16>(all, "shadow, lit outside", {.texture = texture::shadow});
    add<16>(all, "shadow region, lit outside",
            {.texture = texture::shadow, .outside = outside_map::bordered, .origin = "vec2(5.0, 3.0)"});
    add<8>(all, "shadow array, reversed",
           {.texture = texture::shadow_array, .direction = depth_direction::reversed, .outside = outside_map::clamped});
}

}  // namespace parity
