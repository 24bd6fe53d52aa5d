// SPDX-License-Identifier: MIT
#include <umbrage/filter/blocker/pcss_hardware.hpp>

#include "../off_borders.hpp"
#include "../turned.hpp"

namespace parity {
namespace {

using namespace umbrage;

template <int Points>
constexpr auto search_twin = [](auto fetch, const sample& s, auto is_lit) {
    const vec2 found = blockers_hardware<Points>(fetch, at(s), s.x[0].z, turned_radii(s), turned_by(s), is_lit);
    return vec4(found.x, found.y, 0.0f, 0.0f);
};

/// A search whose points all lie off borders.
template <int Points>
void add_search(std::vector<entry>& all, entry e) {
    e.call.insert(e.call.size() - 1, ", 0.0, 0.0");
    e.classes = receivers_with([](const sample& s) {
        for (const ivec2 point : disc_points<Points>)
            if (!off_borders(disc_position(at(s), vec2(point), turned_by(s), clamped_disc_radius(turned_radii(s)))))
                return false;
        return true;
    });
    e.also = {&glsl::disc_rotation};
    e.share = Points;
    all.push_back(std::move(e));
}
template <int Points>
void add_search(std::vector<entry>& all) {
    add_search<Points>(all, filter(glsl::blockers_hardware<Points>, turned_ellipse,
                                   [](const sample& s) { return search_twin<Points>(s.depth(), s, less_equal{}); }));
    all.back().alike = Points != 16;
}
template <int Points>
void add_search(std::vector<entry>& all, const std::string& name, const umbrage::glsl::binding& as) {
    add_search<Points>(all,
                       bound_filter(glsl::blockers_hardware<Points>, turned_ellipse, name, as, search_twin<Points>));
}

/// Number of blockers in x0.x, the sum of their depths in x0.y, the receiver in x0.z, and a softness in x1.
std::vector<input_class> found_blockers() {
    std::vector<input_class> all = spread({{0.0f, 32.0f}, {0.0f, 16.0f}, {0.0f, 1.0f}}, special_values());
    for (input_class& c : all)
        c.fill = [fill = c.fill](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            if (i % 8 != 0) s.x[0].x = static_cast<float>(r.below(33));
            if (i % 8 == 1) s.x[0].x = s.x[0].y = 0.0f;
            const auto least = static_cast<float>(r.below(64));
            const auto per_code = [&] { return static_cast<float>(r.below(256)) / 1024.0f; };
            s.x[1].x = per_code(), s.x[1].y = per_code();
            s.x[1].z = least, s.x[1].w = least + static_cast<float>(r.below(4032));
        };
    return all;
}

}  // namespace

void add_filter_blocker_pcss_hardware(std::vector<entry>& all) {
    using glsl::texture;
    for (const auto direction : {depth_direction::forward, depth_direction::reversed}) {
        const bool forward = direction == depth_direction::forward;
        all.push_back({.primitive = &glsl::pcss_radius,
                       .variant = forward ? "" : "reversed",
                       .classes = found_blockers(),
                       .twin =
                           [direction](const sample& s) {
                               const vec2 r = pcss_radius(vec2(s.x[0]), s.x[0].z, s.x[1], comparison{direction});
                               return vec4(r.x, r.y, 0.0f, 0.0f);
                           },
                       .call = "vec4(umbrage_pcss_radius(vec2(x0.x, x0.y), x0.z, x1), 0.0, 0.0)",
                       .map_kind = {.direction = direction}});
    }
    add_search<8>(all);
    add_search<16>(all);
    add_search<32>(all);
    add_search<16>(all, "sampler", {.outside = outside_map::clamped, .gather = true});
    add_search<16>(all, "depth, reversed, sampler",
                   {.texture = texture::depth,
                    .direction = depth_direction::reversed,
                    .outside = outside_map::clamped,
                    .gather = true});
    add_search<16>(all, "sampler, lit outside", {.gather = true});
    add_search<16>(all, "region", {.gather = true, .origin = "vec2(5.0, 3.0)"});
    add_search<32>(all, "array, sampler", {.texture = texture::array, .outside = outside_map::clamped, .gather = true});
    add_search<32>(all, "depth array, sampler",
                   {.texture = texture::depth_array, .outside = outside_map::clamped, .gather = true});

    all.push_back(filter(glsl::blocker_at, "", [](const sample& s) {
        const vec2 size(s.map.size), found = blocker_at(s.depth(), size, at(s) / size, s.x[0].z);
        return vec4(found.x, found.y, 0.0f, 0.0f);
    }));
    all.back().classes = points_of_texels();
    all.back().call = "vec4(umbrage_blocker_at(map, map_size, vec2(x0.x, x0.y) / map_size, x0.z), 0.0, 0.0)";
}

}  // namespace parity
