// SPDX-License-Identifier: MIT
#include <umbrage/filter/pcf/four_tap_hardware.hpp>

#include "../off_borders.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// A tap in x0.xy and three beside it in x1 and x2.xy, all off borders; far outside texel space, one or all of them, or
/// NaN, as they come.
std::vector<input_class> taps_off_borders() {
    auto classes = receivers_with([](const sample& s) { return off_borders(at(s)); });
    for (input_class& of : classes)
        of.fill = [one = of.fill](std::uint64_t i, random& r, sample& s) {
            one(i, r, s);
            const bool looked_up = inside_texel_space(at(s));
            if (!looked_up) s.x[0].x *= 4.0f, s.x[0].y *= 4.0f;  // where a rounding of the sum changes nothing
            const auto beside = [&] {
                vec2 tap;
                do tap = at(s) + vec2{r.between(-1.5f, 1.5f), r.between(-1.5f, 1.5f)};
                while (looked_up && !off_borders(tap));
                return tap;
            };
            const vec2 b = beside(), c = beside(), d = beside();
            s.x[1] = {b.x, b.y, c.x, c.y};
            s.x[2] = {d.x, d.y, 0.0f, 0.0f};
            const auto lane = static_cast<int>(r.below(8));  // of one of the taps
            const std::size_t input[] = {0, 0, 1, 1, 1, 1, 2, 2};
            const int within[] = {0, 1, 0, 1, 2, 3, 0, 1};
            if (looked_up && i % 4 == 3) s.x[input[lane]][within[lane]] = i % 8 == 3 ? 3e5f : -3e5f;
        };
    return classes;
}

constexpr auto twin = [](auto fetch, const sample& s, auto is_lit) {
    const vec2 size(s.map.size);
    const vec4 x = s.x[1];
    return vec4(four_tap_hardware(fetch, size, at(s) / size, vec2(x.x, x.y) / size, vec2(x.z, x.w) / size,
                                  vec2(s.x[2]) / size, s.x[0].z, is_lit));
};

void add(std::vector<entry>& all, entry e) {
    e.classes = taps_off_borders();
    e.call =
        "vec4(umbrage_four_tap_hardware(map, map_size, vec2(x0.x, x0.y) / map_size, vec2(x1.x, x1.y) / map_size, "
        "vec2(x1.z, x1.w) / map_size, vec2(x2.x, x2.y) / map_size, x0.z))";
    e.share = 4;
    all.push_back(std::move(e));
}

}  // namespace

void add_filter_pcf_four_tap_hardware(std::vector<entry>& all) {
    using glsl::texture;
    add(all, filter(glsl::four_tap_hardware, "", [](const sample& s) { return twin(s.depth(), s, less_equal{}); }));
    const auto bound = [&](const char* name, const umbrage::glsl::binding& as) {
        add(all, bound_filter(glsl::four_tap_hardware, "", name, as, twin));
    };
    bound("sampler", {.outside = outside_map::clamped, .gather = true});
    bound("depth, reversed, sampler", {.texture = texture::depth,
                                       .direction = depth_direction::reversed,
                                       .outside = outside_map::clamped,
                                       .gather = true});
    bound("region", {.gather = true, .origin = "vec2(5.0, 3.0)"});
}

}  // namespace parity
