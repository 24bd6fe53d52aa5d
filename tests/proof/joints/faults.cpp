// SPDX-License-Identifier: MIT
//
// The list of faults, and the run that plants them.
#include "faults.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <exception>
#include <functional>
#include <string_view>
#include <thread>
#include <vector>

#include "draw.hpp"
#include "tweaks.hpp"

namespace joints {

namespace {

/// A fault, and the draws that have the parts between which it lies.
struct fault {
    std::string_view name;
    std::function<void(tweaks&)> plant;
    std::function<bool(const choices&)> applies = [](const choices&) { return true; };
};

bool is_reversed(const choices& c) { return c.is_reversed(); }
bool is_forward(const choices& c) { return !c.is_reversed(); }
bool is_sun(const choices& c) { return c.is_sun(); }
bool is_far(const choices& c) { return c.away > 20 && !c.with_origin && c.facing; }
bool is_near(const choices& c) { return c.away < 1; }
bool has_origin(const choices& c) { return c.with_origin && c.away > 1; }
bool has_boxes(const choices& c) { return c.mirrored; }
bool is_oblong(const choices& c) { return c.size.x != c.size.y; }
bool is_depth16(const choices& c) { return c.encoding == 1; }
bool has_cascades(const choices& c) {
    return c.setup == setup_kind::eight_cascades ||
           (c.cascades > 1 && (c.setup == setup_kind::stable_cascades || c.setup == setup_kind::tight_cascades));
}
bool hardens(const choices& c) { return c.filter.hardens(); }
bool is_pcss(const choices& c) { return c.filter.is_pcss(); }
bool has_softnesses(const choices& c) {
    return hardens(c) && (has_cascades(c) || c.setup == setup_kind::pages ||
                          (c.cascades > 1 && c.setup == setup_kind::warped_cascades));
}
bool has_shapes(const choices& c) { return hardens(c) && (c.is_warped() || c.setup == setup_kind::tetrahedron); }
bool has_long_texels(const choices& c) { return hardens(c) && c.is_spot() && is_oblong(c); }
bool has_maps(const choices& c) {
    return has_cascades(c) || c.setup == setup_kind::pages || c.setup == setup_kind::cube ||
           c.setup == setup_kind::paraboloids || (c.cascades > 1 && c.setup == setup_kind::warped_cascades);
}

const std::vector<fault> faults{
    {"size: uniforms made for half the map", [](tweaks& t) { t.other_size = true; }},
    {"size: drawn with width and height exchanged", [](tweaks& t) { t.exchanges_sides = true; }, is_oblong},
    {"maps: drawn with the next map's view", [](tweaks& t) { t.other_view = 1; }, has_maps},
    {"maps: looked up in the next tile", [](tweaks& t) { t.other_tile = 1; }, has_maps},
    {"maps: the next cascade's columns", [](tweaks& t) { t.other_column = true; }, has_cascades},
    {"bias: half the reach", [](tweaks& t) { t.reach = 0.5; }},
    {"plane: half the slope", [](tweaks& t) { t.slope = 0.5f; }},
    {"bias: none, as the normal is zero", [](tweaks& t) { t.drops_normal = true; }},
    {"bias: towards the caster", [](tweaks& t) { t.turns_bias = true; }},
    {"bias: error of the encoding dropped", [](tweaks& t) { t.drops_error = true; }, is_depth16},
    {"bias: slack dropped, far away", [](tweaks& t) { t.drops_slack = true; }, is_far},
    {"bias: slack dropped, near the origin", [](tweaks& t) { t.drops_slack = true; }, is_near},
    {"bias: planes transformed as points", [](tweaks& t) { t.drops_slope = true; }},

    {"bias: the rasterizer moves casters to the light", [](tweaks& t) { t.moves_casters = 0.01; }},
    {"normal: of another space", [](tweaks& t) { t.other_normal = true; }},
    {"normal: of instances, as the mesh has it", [](tweaks& t) { t.normal_of_mesh = true; }, has_boxes},
    {"filter: another than the uniforms'", [](tweaks& t) { t.wider_filter = true; }},
    {"place: half a texel off",
     [](tweaks& t) {
         t.moves_texels = {-0.5f, -0.5f};
     }},

    {"anchor: not subtracted in the depth pass", [](tweaks& t) { t.drops_anchor = true; }},
    {"anchor: share of depth left out in the depth pass", [](tweaks& t) { t.drops_depth_share = true; }},
    {"anchor: not in the uniforms", [](tweaks& t) { t.uniforms_drop_anchor = true; }},
    {"anchor: depth not in the uniforms", [](tweaks& t) { t.uniforms_drop_added = true; }},
    {"anchor: one float matrix of the world", [](tweaks& t) { t.in_float = true; }, is_far},
    {"origin: not in the depth pass", [](tweaks& t) { t.drops_origin = true; }, has_origin},
    {"origin: not in the uniforms", [](tweaks& t) { t.uniforms_drop_origin = true; }, has_origin},
    {"origin: the last frame's in the depth pass", [](tweaks& t) { t.stale_origin = true; }},
    {"origin: the last frame's in the uniforms", [](tweaks& t) { t.uniforms_stale_origin = true; }},
    {"light: the map is that of a frame ago", [](tweaks& t) { t.light_turned = 3; }},
    {"near plane: clips where it clamps", [](tweaks& t) { t.flips_near = true; }, is_sun},
    {"near plane: clamps where it clips", [](tweaks& t) { t.flips_near = true; },
     [](const choices& c) { return !c.is_sun(); }},
    {"cull: back faces", [](tweaks& t) { t.cull = umbrage::cull_mode::back; }},

    {"instances: left out", [](tweaks& t) { t.skips_instances = true; }, has_boxes},

    {"instances: not turned", [](tweaks& t) { t.drops_instances_turn = true; }, has_boxes},
    {"direction: the farthest depth stays", [](tweaks& t) { t.turns_direction = true; }, is_reversed},
    {"direction: cleared to the near plane", [](tweaks& t) { t.clears_near = true; }},
    {"direction: compared the other way", [](tweaks& t) { t.turns_comparison = true; }, is_forward},
    {"clip space: another range of depth", [](tweaks& t) { t.other_range = true; }},
    {"clip space: first row at the other end", [](tweaks& t) { t.other_origin = true; }},
    {"encoding: 8 bits stored", [](tweaks& t) { t.depth_bits = 8; }},
    {"encoding: a gamma", [](tweaks& t) { t.stores_linear = true; }},
    {"border: none in the uniforms", [](tweaks& t) { t.drops_border = true; }},

    {"softness: a light 1.3 times as large", [](tweaks& t) { t.softness = 1.3f; }, hardens},
    {"softness: a light's diameter for its radius", [](tweaks& t) { t.softness = 2; }, hardens},
    {"softness: a light 1.3 times too small", [](tweaks& t) { t.softness = 1 / 1.3f; }, hardens},
    {"softness: the default, not of the light's size", [](tweaks& t) { t.default_softness = true; }, hardens},
    {"softness: of a texel's longer edge alone", [](tweaks& t) { t.one_softness = true; }, has_long_texels},
    {"softness: of the first texel of a warped map", [](tweaks& t) { t.drops_shape = true; }, has_shapes},
    {"softness: of the next map", [](tweaks& t) { t.other_softness = 1; }, has_softnesses},
    {"blockers: searched within the smallest radius", [](tweaks& t) { t.searches_least = true; }, is_pcss},
    {"blockers: a mean over all points", [](tweaks& t) { t.counts_all_points = true; }, is_pcss},
    {"blockers: penumbra of the receiver's depth alone", [](tweaks& t) { t.drops_blockers = true; }, is_pcss},
};

/// How a fault shows, over draws.
struct shown {
    std::uint64_t tried = 0, seed = 0;
    tally found{};
};

shown look_for(const fault& f, std::uint64_t draws) {
    shown s;
    tweaks t;
    f.plant(t);
    for (std::uint64_t seed = 0; s.tried < draws && seed < 100 * draws; ++seed) {
        choices c = draw_choices(seed);
        if (!f.applies(c)) continue;
        if (c.encoding > 1) c.encoding = 0;  // what hosts get wrong
        try {
            drawn d(c);
            const bool has_steps = d.has_steps();
            const std::optional<tally> found = d.wrong(t);
            if (!found) continue;
            ++s.tried, s.seed = seed;
            s.found = *found;
            if (!has_steps) {
                std::printf("the steps of a program have other bits without a fault: %s\n", described(c).c_str());
                s.found = {};
                return s;
            }
            if (found->wrong() > 0) return s;
        } catch (const std::invalid_argument&) {}
    }
    s.found = {};
    return s;
}

}  // namespace

bool plant_faults(std::uint64_t draws) {
    std::vector<shown> all(faults.size());
    std::atomic<std::size_t> next = 0;
    std::vector<std::jthread> threads(std::max(1u, std::thread::hardware_concurrency()));
    for (std::jthread& thread : threads)
        thread = std::jthread([&] {
            for (std::size_t i; (i = next++) < faults.size();) all[i] = look_for(faults[i], draws);
        });
    threads.clear();  // joins
    std::size_t seen = 0;
    std::printf("%-52s %6s %8s %10s %10s\n", "fault", "draws", "seed", "false dark", "false lit");
    for (std::size_t i = 0; i < faults.size(); ++i) {
        const shown& s = all[i];
        const bool is_seen = s.found.wrong() > 0;
        seen += is_seen;
        std::printf("%-52.*s %6llu %8llu %10llu %10llu%s\n", static_cast<int>(faults[i].name.size()),
                    faults[i].name.data(), static_cast<unsigned long long>(s.tried),
                    static_cast<unsigned long long>(s.seed), static_cast<unsigned long long>(s.found.falsely_dark),
                    static_cast<unsigned long long>(s.found.falsely_lit), is_seen ? "" : "   NOT SEEN");
    }
    std::printf("%zu of %zu faults seen\n", seen, faults.size());
    return seen == faults.size();
}

}  // namespace joints
