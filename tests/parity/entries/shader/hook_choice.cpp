// SPDX-License-Identifier: MIT
//
// Filters bound to maps of every kind: what they give is what they give for a plain map.
#include <umbrage/shader/hook_choice.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include <umbrage/depth/rg.hpp>
#include <umbrage/depth/rg_level.hpp>
#include <umbrage/filter/pcf/box.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>

#include "../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;
using glsl::binding;
using glsl::texture;

/// receivers(), and a whole texel in x1.xy: inside, around the border, far off.
std::vector<input_class> receivers_and_texels() {
    auto classes = receivers();
    const auto texels = whole_texels();
    for (input_class& c : classes)
        c.fill = [receiver = c.fill, texels](std::uint64_t i, random& r, sample& s) {
            texels[i % texels.size()].fill(r.bits(), r, s);
            s.x[1] = s.x[0];
            receiver(i, r, s);
        };
    return classes;
}

/// Not with every kind: compiling its loops takes long.
bool has_box(const binding& as) {
    const bool kind = as.texture == texture::array || as.texture == texture::cube || as.texture == texture::shadow;
    return kind && !as.gather && as.direction == depth_direction::reversed;
}

/// Calls of a shader of the map, and the same in C++: pcf_2x2, box or hard, the bits of lit_2x2, fetch_depth or lit.
std::string calls(const binding& as, const std::string& depth = "x0.z") {
    const std::string receiver = "(map, map_size, vec2(x0.x, x0.y), " + depth,
                      texel = "(map, map_size, vec2(x1.x, x1.y)";
    return "vec4(umbrage_pcf_2x2" + receiver + "), " +
           (has_box(as) ? "umbrage_box" + receiver + ", 2)" : "umbrage_hard" + receiver + ")") +
           ", dot(umbrage_lit_2x2" + texel + ", " + depth + "), vec4(1.0, 2.0, 4.0, 8.0)), " +
           (glsl::detail::compares(as.texture) ? "umbrage_lit" + texel + ", " + depth + ")"
                                               : "umbrage_fetch_depth" + texel + ")") +
           ")";
}
template <class Fetch, class Compare>
vec4 twins(const binding& as, const Fetch& fetch, const sample& s, float receiver, Compare is_lit) {
    const ivec2 texel(vec2(s.x[1]));
    const vec4 lit = lit_2x2(fetch, texel, receiver, is_lit);
    return {
        pcf_2x2(fetch, at(s), receiver, is_lit),
        has_box(as) ? box(fetch, at(s), receiver, 2, is_lit) : hard(fetch, at(s), receiver, is_lit),
        lit.x + lit.y * 2.0f + lit.z * 4.0f + lit.w * 8.0f,
        glsl::detail::compares(as.texture) ? umbrage::lit(fetch, texel, receiver, is_lit) : fetch_depth(fetch, texel)};
}

/// Fetches as the map's binding has them, of decode(texel).
template <class Decode>
auto fetch_as(const binding& as, const sample& s, Decode decode) {
    const bool border = glsl::detail::is_bordered(as), scaled = !as.needs.empty() && as.needs[0].scaled;
    const float far = scaled ? 65536.0f : cleared_depth(as.direction);
    return [border, far, map = s.map, decode](ivec2 texel) {
        return border && !inside_map(map.size, texel) ? far : decode(fetch_clamped(map, texel));
    };
}

std::string described(const std::string& kind, const binding& as) {
    return kind + (as.direction == depth_direction::forward ? "" : ", reversed") +
           (glsl::detail::is_bordered(as) ? ", lit outside" : "") + (as.gather ? ", gathered" : "");
}

template <class Decode>
entry bound(const std::string& kind, const binding& as, std::vector<texels> maps, Decode decode) {
    const bound_map m{.name = "map", .as = as};
    return {.primitive = &glsl::pcf_2x2,
            .variant = described(kind, as),
            .classes = receivers_and_texels(),
            .twin =
                [as, decode](const sample& s) {
                    return twins(as, fetch_as(as, s, decode), s, s.x[0].z, comparison{as.direction});
                },
            .call = calls(as),
            .maps = std::move(maps),
            .bound = {m},
            .also = {has_box(as) ? &glsl::box : &glsl::hard, &glsl::lit_2x2,
                     glsl::detail::compares(as.texture) ? &glsl::lit : &glsl::fetch_depth},
            .share = 16};
}

/// Each kind with two of the four ways to compare, gathered with the other two.
void add_kinds(std::vector<entry>& all) {
    const std::pair<const char*, binding> kinds[]{
        {"2D", {}},
        {"region",
         {.origin = "vec2(5.0, 3.0)", .texture_size = "(size + vec2(9.0, 7.0))"}},  // bound_map's origin and margin
        {"atlas", {.texture = texture::atlas}},
        {"array", {.texture = texture::array}},
        {"cube", {.texture = texture::cube}},
        {"integer", {.texture = texture::integer, .depth = "value.x * (1.0 / 65536.0)"}},
        {"depth", {.texture = texture::depth}},
        {"depth array", {.texture = texture::depth_array}},
        {"shadow", {.texture = texture::shadow}},
        {"shadow array", {.texture = texture::shadow_array}},
        {"shadow region", {.texture = texture::shadow, .origin = "vec2(5.0, 3.0)"}}};
    bool bordered = false;
    for (const auto& [name, kind] : kinds) {
        for (const auto direction : {depth_direction::forward, depth_direction::reversed})
            for (const bool gather : {false, true}) {
                if (gather && !glsl::detail::gathers(kind.texture)) continue;
                binding as = kind;
                as.direction = direction;
                as.gather = gather;
                const bool border = (bordered != gather) != (direction == depth_direction::reversed);
                as.outside = border ? outside_map::bordered : outside_map::clamped;
                const auto maps = kind.texture == texture::cube
                                      ? plain_maps({{64, 64}, {21, 21}, {1, 1}})
                                      : plain_maps({{64, 64}, {37, 21}, {3, 2}, {1, 1}, {1, 5}});
                all.push_back(bound(name, as, maps, [](vec4 value) { return value.x; }));
            }
        bordered = !bordered;
    }
}

void add_packed(std::vector<entry>& all) {
    for (const bool gather : {false, true})
        for (const auto direction : {depth_direction::forward, depth_direction::reversed}) {
            const rg<11> encoding{.direction = direction};
            const binding as = glsl::stored_as(
                encoding, {.outside = gather ? outside_map::clamped : outside_map::bordered, .gather = gather});
            all.push_back(bound("rg11", as, packed_maps(),
                                [encoding](vec4 value) { return decode_rg<11>(vec2(value), encoding.edge); }));
        }
}

/// Strictly less, in place of less_equal; it has no far plane.
struct less {
    bool operator()(float receiver, float stored) const { return receiver < stored; }
};

/// Depths of a texel's number too, as on a receiver's plane, and a comparison of one's own.
void add_own(std::vector<entry>& all) {
    for (const auto outside : {outside_map::clamped, outside_map::bordered}) {
        const binding as{
            .outside = outside, .depth = "value.x + texel.x * 0.015625", .compare = "float(receiver < stored)"};
        entry e =
            bound("own depth and comparison", as, plain_maps({{64, 64}, {37, 21}, {1, 1}}), [](vec4) { return 0.0f; });
        e.twin = [as](const sample& s) {
            const bool border = glsl::detail::is_bordered(as);
            const auto depth = [border, map = s.map](ivec2 texel) {
                const float moved = fetch_clamped(map, texel).x + static_cast<float>(texel.x) * 0.015625f;
                return border && !inside_map(map.size, texel) ? 1.0f : moved;
            };
            return twins(as, depth, s, s.x[0].z, less{});
        };
        all.push_back(std::move(e));
    }
}

/// Packed maps that are compared without decoding.
void add_levels(std::vector<entry>& all) {
    for (const bool gather : {false, true})
        for (const auto outside : {outside_map::clamped, outside_map::bordered}) {
            const binding as{.outside = outside,
                             .gather = gather,
                             .depth = "umbrage_level_rg11(value.xy)",
                             .channels = 2,
                             .needs = {glsl::level_rg<11>}};
            const auto level = [](vec4 value) { return level_rg<11>(vec2(value)); };
            entry e = bound("levels", as, packed_maps(), level);
            e.twin = [as, level](const sample& s) {
                return twins(as, fetch_as(as, s, level), s, receiver_rg<11>(s.x[0].z, center<float>),
                             less_equal_scaled{});
            };
            e.call = calls(as, "umbrage_receiver_rg11(x0.z, 0.5)");
            e.also.push_back(&glsl::receiver_rg<11>);
            all.push_back(std::move(e));
        }
}

/// Depths of 16 bits, and receivers between two of them: implementations may compare floats or integers. Filters
/// alone, which light what is beyond the far plane before any sampler compares.
void add_short_depths(std::vector<entry>& all) {
    constexpr float most = bound_map::most_short;
    auto maps = plain_maps({{64, 64}, {37, 21}, {1, 1}});
    for (texels& map : maps)
        for (vec4& t : map.texels()) t = glm::round(t * most) / most;
    auto classes = receivers();
    for (input_class& c : classes)
        c.fill = [fill = c.fill](std::uint64_t i, random& r, sample& s) {
            fill(i, r, s);
            float& depth = s.x[0].z;
            if (depth > 0.0f && depth < 1.0f) depth = (std::floor(depth * most) + 0.5f) / most;
        };
    for (const auto direction : {depth_direction::forward, depth_direction::reversed})
        for (const bool gather : {false, true}) {
            const binding as{.texture = texture::shadow,
                             .direction = direction,
                             .outside = gather ? outside_map::bordered : outside_map::clamped,
                             .gather = gather};
            entry e = bound("shadow of 16 bits", as, maps, [](vec4 value) { return value.x; });
            e.bound.front().short_depths = true;
            e.classes = classes;
            e.also = {&glsl::hard};
            const std::string arguments = "(map, map_size, vec2(x0.x, x0.y), x0.z)";
            e.call = "vec4(umbrage_pcf_2x2" + arguments + ", umbrage_hard" + arguments + ", 0.0, 1.0)";
            e.twin = [as](const sample& s) {
                const auto fetch = fetch_as(as, s, [](vec4 value) { return value.x; });
                const comparison is_lit{as.direction};
                return vec4(pcf_2x2(fetch, at(s), s.x[0].z, is_lit), hard(fetch, at(s), s.x[0].z, is_lit), 0.0f, 1.0f);
            };
            all.push_back(std::move(e));
        }
}

/// An 11-bit packed spot map, a cascade with reversed depth, a tile of an atlas, a cube: one shader.
void add_four_maps(std::vector<entry>& all) {
    const rg<11> packed{};
    entry e{.primitive = &glsl::pcf_2x2,
            .variant = "four maps",
            .classes = receivers(),
            .call = "umbrage_pcf_2x2(map, map_size, vec2(x0.x, x0.y), x0.z)",
            .maps = packed_maps(),
            .bound =
                {{"spot", glsl::stored_as(packed, {.outside = outside_map::clamped})},
                 {"cascade",
                  {.texture = texture::array, .direction = depth_direction::reversed, .outside = outside_map::clamped}},
                 {"tile", {.texture = texture::atlas, .outside = outside_map::bordered}},
                 {"lamp", {.texture = texture::cube, .outside = outside_map::bordered}}},
            .share = 16};
    e.maps = {e.maps.front()};  // faces of cubes are square
    e.twin = [packed](const sample& s) {
        const auto channel = [map = s.map](int c) {
            return [map, c](ivec2 texel) { return fetch_clamped(map, texel)[c]; };
        };
        const auto lit_outside = [map = s.map](int c) {
            return [map, c](ivec2 texel) { return fetch_bordered(map, texel, vec4(1.0f))[c]; };
        };
        const auto spot = [map = s.map, packed](ivec2 texel) {
            return decode_rg<11>(vec2(fetch_clamped(map, texel)), packed.edge);
        };
        return vec4(pcf_2x2(spot, at(s), s.x[0].z), pcf_2x2(channel(1), at(s), s.x[0].z, greater_equal{}),
                    pcf_2x2(lit_outside(2), at(s), s.x[0].z), pcf_2x2(lit_outside(3), at(s), s.x[0].z));
    };
    all.push_back(std::move(e));
}

/// Hooks along a plane take its slope, which no entry gives them: tests in shadows/in_gl.cpp draw them.
const std::set<const snippet*> along_planes{&glsl::hooks::planed_lit,          &glsl::hooks::planed_lit_texel,
                                            &glsl::hooks::planed_compared_lit, &glsl::hooks::planed_compare,
                                            &glsl::hooks::planed_gathered_lit, &glsl::hooks::planed_lit_sampled,
                                            &glsl::hooks::planed_lit_between};

/// Every other snippet of hooks::all is in some text.
void expect_all(const std::vector<entry>& all) {
    std::set<const snippet*> found;
    const auto look = [&](const auto& self, const snippet& asked, const binding& as) -> void {
        const snippet& s = glsl::detail::chosen(asked, as);
        found.insert(&s);
        for (const snippet* need : s.needs) self(self, *need, as);
    };
    for (const entry& e : all)
        for (const glsl::bound& item : e.items()) look(look, item.what, item.map);
    for (const snippet* s : glsl::hooks::all)
        if (!found.contains(s) && !along_planes.contains(s))
            throw std::logic_error("no parity entry has " + s->source.str());
}

}  // namespace

void add_shader_hook_choice(std::vector<entry>& all) {
    add_kinds(all);
    add_packed(all);
    add_own(all);
    add_levels(all);
    add_short_depths(all);
    add_four_maps(all);
    expect_all(all);
}

}  // namespace parity
