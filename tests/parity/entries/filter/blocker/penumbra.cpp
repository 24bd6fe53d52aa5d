// SPDX-License-Identifier: MIT
#include <umbrage/filter/blocker/penumbra.hpp>

#include "soft.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// Codes apart in x0.x; in x1 a softness: up to 8 bits over a power of two twice, and whole radii.
std::vector<input_class> sizes_of_lights() {
    const auto draw = [](random& r, sample& s, int most) {
        s.x[0].x = static_cast<float>(r.below(most) - 1024);
        const auto per_code = [&] {
            const auto digits = static_cast<float>(r.below(256));
            return digits / static_cast<float>(1 << r.below(16));
        };
        s.x[1].x = per_code(), s.x[1].y = per_code();
        s.x[1].z = static_cast<float>(r.below(64)), s.x[1].w = s.x[1].z + static_cast<float>(r.below(4032));
    };
    return {{"random", [draw](auto, random& r, sample& s) { draw(r, s, 66560); }},
            {"near", [draw](auto, random& r, sample& s) { draw(r, s, 2048); }}};
}

entry code_entry(const std::string& variant, depth_direction direction, std::function<vec4(const sample&)> twin) {
    return {.primitive = &glsl::distance_code,
            .variant = variant,
            .classes = spread({{0.0f, 1.0f}}, depth_values(16)),
            .twin = std::move(twin),
            .call = "vec4(umbrage_distance_code(x0.x))",
            .map_kind = {.direction = direction, .outside = outside_map::clamped}};
}

/// The texel below a receiver, and whether it is before it.
template <class Compare>
entry one_texel(entry (*of)(const snippet&, const std::string&, std::function<vec4(const sample&)>), Compare is_lit) {
    entry e = of(glsl::blocker, "", [is_lit](const sample& s) {
        const vec2 found = blocker(s.depth(), texel_of(s), s.x[0].z, is_lit);
        return vec4(found.x, found.y, 0.0f, 0.0f);
    });
    e.classes = whole_texels();
    for (input_class& c : e.classes)
        c.fill = [fill = c.fill](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            const float near = fetch_clamped(s.map, texel_of(s)).x;
            s.x[0].z = i % 3 == 0 ? near : static_cast<float>(r.below(33)) / 32.0f;
        };
    e.call = "vec4(umbrage_blocker(map, map_size, vec2(x0.x, x0.y), x0.z), 0.0, 0.0)";
    return e;
}

template <int Points>
void add_blockers(std::vector<entry>& all, std::size_t share) {
    all.push_back(filter(glsl::blockers<Points>, "", [](const sample& s) {
        const vec2 position = inside_texel_space(at(s)) ? glm::floor(at(s) * 256.0f) : vec2(0.0f);
        const vec2 radius(s.x[0].w * 13.0f + 13.0f, s.x[0].w * 9.0f);
        const vec2 found = blockers<Points>(s.depth(), position, s.x[0].z, radius, disc_rotation(at(s)));
        return vec4(found.x, found.y, 0.0f, 0.0f);
    }));
    all.back().call =
        "vec4(umbrage_" + std::string(glsl::blockers<Points>.name) +
        "(map, map_size, umbrage_inside_texel_space(vec2(x0.x, x0.y)) ? floor(vec2(x0.x, x0.y) * 256.0) : "
        "vec2(0.0, 0.0), x0.z, vec2(x0.w * 13.0 + 13.0, x0.w * 9.0), umbrage_disc_rotation(vec2(x0.x, x0.y))), 0.0, "
        "0.0)";
    all.back().also = {&umbrage::glsl::disc_rotation};
    all.back().share = share;
    all.back().alike = Points != 16;
}

entry of_filter(const snippet& s, const std::string& arguments, std::function<vec4(const sample&)> twin) {
    return filter(s, arguments, std::move(twin));
}

}  // namespace

void add_filter_blocker_penumbra(std::vector<entry>& all) {
    all.push_back(
        code_entry("", depth_direction::forward, [](const sample& s) { return vec4(distance_code(s.x[0].x)); }));
    all.push_back(code_entry("reversed", depth_direction::reversed,
                             [](const sample& s) { return vec4(distance_code(s.x[0].x, greater_equal{})); }));
    all.push_back({.primitive = &glsl::penumbra,
                   .classes = sizes_of_lights(),
                   .twin =
                       [](const sample& s) {
                           const vec2 radius = penumbra(s.x[0].x, s.x[1]);
                           return vec4(radius.x, radius.y, 0.0f, 0.0f);
                       },
                   .call = "vec4(umbrage_penumbra(x0.x, x1), 0.0, 0.0)"});
    all.push_back(one_texel(of_filter, less_equal{}));
    all.push_back(one_texel(reversed_filter, greater_equal{}));
    add_blockers<8>(all, 4);
    add_blockers<16>(all, 4);
    add_blockers<32>(all, 8);
}

}  // namespace parity
