// SPDX-License-Identifier: MIT
//
// Pages of a virtual shadow map: a cache keeps to its slots and draws what a view needs. The table says where a page
// is, a page's light shows the root's texels, and a receiver has the bits of its page's map alone.
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include <umbrage/images/page_atlas.hpp>
#include <umbrage/shadow/adaptive_maps.hpp>
#include <umbrage/shadow/shadow.hpp>

#include "input.hpp"

namespace {

using namespace umbrage;

using place = std::array<int, 3>;  // of a page: level, x, y
place of(const page& p) { return {p.level, p.x, p.y}; }

std::vector<page_receiver> receivers_in(fuzz::input& in) {
    std::vector<page_receiver> all(static_cast<std::size_t>(in.within(0, 12)));
    for (page_receiver& r : all) r = {{in.number(0.9f, 2.1f), in.number(0.9f, 2.1f)}, in.number(0, 40)};
    return all;
}

/// Pages of a cache by place, each in a slot of its own.
std::map<place, glm::ivec2> pages_of(const page_cache& cache) {
    std::map<place, glm::ivec2> pages;
    std::set<std::array<int, 2>> slots;
    cache.for_each([&](const page& p, glm::ivec2 slot) {
        fuzz::must(inside_map(cache.budget().slots, slot), "a page lies within the atlas");
        fuzz::must(slots.insert({slot.x, slot.y}).second, "no two pages have one slot");
        fuzz::must(pages.emplace(of(p), slot).second, "a page is there once");
    });
    fuzz::must(pages.size() == cache.size(), "a cache counts its pages");
    return pages;
}

page_cache filled(fuzz::input& in, const page_budget& budget) {
    page_cache cache(budget);
    for (int frames = in.within(1, 4); frames > 0; --frames) {
        if (in.chance(8)) cache.forget();
        const auto before = pages_of(cache);
        const std::vector<page_receiver> seen = receivers_in(in);
        const page_update change = cache.update(seen);
        const auto after = pages_of(cache);
        fuzz::must(after.contains({0, 0, 0}), "the root's page is there");
        for (const placed_page& drawn : change.drawn) {
            fuzz::must(after.contains(of(drawn.page)) && !before.contains(of(drawn.page)), "new pages are drawn");
            fuzz::must(after.at(of(drawn.page)) == drawn.slot, "a new page is drawn where it stays");
        }
        std::size_t kept = 0;
        for (const auto& [at, slot] : before) {
            const auto now = after.find(at);
            if (now == after.end()) continue;
            ++kept;
            fuzz::must(now->second == slot, "a page keeps its slot");
        }
        fuzz::must(kept + change.drawn.size() == after.size(), "a page is kept, or drawn");
        for (const page& p : wanted_pages(seen, change.target, budget.deepest_level))
            fuzz::must(after.contains(of(p)), "the pages that a view needs are there");
    }
    return cache;
}

void images(fuzz::input& in, const page_cache& cache) {
    image<glm::u8vec4> table(page_table_size(cache));
    write_page_table(cache, table);
    const page_size size{.texels = 1 << in.within(0, 4), .gutter = in.within(0, 4)};
    image<float> atlas(page_atlas_size(cache, size));
    for (float& d : atlas.texels()) d = static_cast<float>(&d - atlas.texels().data()) * 0.37f;
    for (float& d : atlas.texels()) d -= std::floor(d);
    image<glm::vec3> receivers({in.within(1, 40), 2});
    for (glm::vec3& r : receivers.texels()) r = {in.number(0.9f, 2.1f), in.number(0.9f, 2.1f), in.number(-0.1f, 1.1f)};
    image<float> out(receivers.size());
    const filters::pcf_2x2 filter{};
    visibility({atlas, table, size}, depth32f{}, receivers, filter, out, fuzz::pieces(in));
    const auto pages = pages_of(cache);
    for (glm::ivec2 p(0); p.y < out.size().y; ++p.y)
        for (p.x = 0; p.x < out.size().x; ++p.x) {
            const glm::vec3 r = receivers[p];
            float wanted = 1;
            if (r.x >= 1 && r.x < 2 && r.y >= 1 && r.y < 2) {
                const int level = cache.level_at(glm::dvec2(glm::vec2(r)));
                const page finest = page_at(glm::dvec2(glm::vec2(r)), level);
                const glm::vec2 across = glm::vec2(r) * static_cast<float>(1 << level);
                const glm::vec2 at =
                    (across - glm::floor(across)) * static_cast<float>(size.texels) + static_cast<float>(size.gutter);
                const auto map = atlas.view().region(pages.at(of(finest)) * size.pitch(), glm::ivec2(size.pitch()));
                wanted = filter(clamped(map), at, r.z);
            }
            fuzz::must(out[p] == wanted, "a receiver has the bits of the finest page's map");
        }
}

void lights(fuzz::input& in, const page_cache& cache) {
    const clip_space clip = in.clip();
    const page_root<double> square{.direction = glm::dvec3(in.vec3(-1, 1)),
                                   .up = glm::dvec3(in.vec3(-1, 1)),
                                   .center = glm::dvec3(in.vec3(-50, 50)),
                                   .side = in.number(1, 500),
                                   .scene = {glm::dvec3(in.vec3(-60, 0)), glm::dvec3(in.vec3(0, 60))},
                                   .clip = clip};
    const auto root = make_page_root(square);
    const page_size size{.texels = 1 << in.within(0, 5), .gutter = in.within(0, 6)};
    const glm::dvec3 point(in.tame(-60, 60), in.tame(-60, 60), in.tame(-60, 60));
    cache.for_each([&](const page& p, glm::ivec2) {
        const auto light = page_light(root, p, size);
        const glm::dmat4 to_texels = texture_matrix(light, glm::ivec2(size.pitch()));
        const glm::dvec4 here = to_texels * glm::dvec4(point, 1), there = page_matrix(root) * glm::dvec4(point, 1);
        const double across = 1 << p.level;
        const glm::dvec2 wanted =
            (glm::dvec2(there) * across - across - glm::dvec2(p.x, p.y)) * double(size.texels) + double(size.gutter);
        const double rounded = 1e-15 * (glm::length(point) + glm::length(square.center)) / square.side;
        const double room = (1e-9 + rounded) * across * size.texels + 1e-9 * glm::length(wanted);
        fuzz::must(glm::distance(glm::dvec2(here), wanted) <= room, "a page shows the root's texels");
    });
    const adaptive_maps setup(root, cache, size);
    const shadow of(setup, glm::ivec2(size.pitch()), filters::hard{});
    const image<float> empty(of.size(), of.cleared());
    const float lit = of(empty, glm::vec3(point), in.vec3(-1, 1));
    fuzz::must(lit == 1, "an empty map casts no shadow");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzz::input in(bytes, size);
    fuzz::answered([&] {
        const page_cache cache = filled(in, {.slots = {in.within(0, 9), in.within(1, 4)},
                                             .deepest_level = in.within(0, 5),
                                             .target = double(in.number(0.5f, 4))});
        fuzz::answered([&] { images(in, cache); });
        fuzz::answered([&] { lights(in, cache); });
    });
    return 0;
}
