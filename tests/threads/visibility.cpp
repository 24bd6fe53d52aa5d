// SPDX-License-Identifier: MIT
#include <array>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/images/page_atlas.hpp>
#include <umbrage/images/plane_visibility.hpp>
#include <umbrage/images/visibility.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/shadow/shadow.hpp>

#include "functions.hpp"

namespace {

using namespace umbrage;

const image<float> map = random_depths({128, 64});
constexpr glm::ivec2 size(128, 40);

struct planes {
    image<float> x{size}, y{size}, depth{size}, slope{size, 0.001f};
    planes() {
        numbers random;
        for (float& v : x.texels()) v = random(-2, 130);
        for (float& v : y.texels()) v = random(-2, 66);
        for (float& v : depth.texels()) v = random(0, 1);
    }
    [[nodiscard]] receiver_planes view() const { return {x, y, depth}; }
};
const planes seen;

template <class Filter, class Receivers>
blob filtered(const Filter& filter, const Receivers& receivers, const hook& parallel) {
    image<float> out(size);
    visibility(map, depth32f{}, receivers, filter, out, parallel);
    return blob_of(out);
}

blob paged(const hook& parallel) {
    page_cache cache({.slots = {2, 2}, .deepest_level = 1});
    const std::array<page_receiver, 2> wanted{{{{1.1f, 1.1f}, 0.5f}, {{1.9f, 1.2f}, 0.5f}}};
    cache.update(wanted);
    image<glm::u8vec4> table(page_table_size(cache));
    write_page_table(cache, table);
    const page_size of{.texels = 16, .gutter = 2};
    const image<float> atlas = random_depths(page_atlas_size(cache, of));
    numbers random;
    image<glm::vec3> receivers(size);
    for (glm::vec3& r : receivers.texels()) r = {random(1, 2), random(1, 2), random(0, 1)};
    image<float> out(size);
    visibility({atlas, table, of}, depth32f{}, receivers, filters::pcf_2x2{}, out, parallel);
    return blob_of(out);
}

blob shadow_of_a_light(const hook& parallel) {
    const shadow of(make_spot_light<float>({.position = {0, 0, 4}, .direction = {0, 0, -1}, .clip = cpu_clip_space}),
                    {64, 64}, filters::hard{}, rg<11>{});
    const std::array<glm::vec3, 3> positions{{{-1, -1, 1}, {1, -1, 1}, {0, 1, 1.5f}}};
    const std::array<glm::uvec3, 1> triangles{{{0, 1, 2}}};
    image<float> depths(of.size(), cleared_depth(cpu_clip_space));
    of.draw(depths, {positions, triangles}, parallel);
    image<glm::u8vec2> texels(of.size());
    of.store(depths, texels, parallel);
    numbers random;
    image<glm::vec3> points(size), normals(size, glm::vec3(0, 0, 1));
    for (glm::vec3& p : points.texels()) p = {random(-2, 2), random(-2, 2), random(-1, 1)};
    image<float> out(size);
    of.visibility(texels, points, normals, out, parallel);
    return blob_of(out);
}

}  // namespace

std::vector<function> visibilities() {
    return {{"visibility by blocks", [](const hook& h) { return filtered(filters::hard{}, seen.view(), h); }},
            {"visibility by bounds", [](const hook& h) { return filtered(filters::box{3}, seen.view(), h); }},
            {"visibility by any callable",
             [](const hook& h) {
                 const auto nearest = [](const auto& fetch, glm::vec2 coord, float receiver) {
                     return receiver <= fetch(glm::ivec2(glm::floor(coord))) ? 1.0f : 0.0f;
                 };
                 return filtered(nearest, seen.view(), h);
             }},
            {"visibility along planes",
             [](const hook& h) {
                 const sloped_receivers receivers{seen.view(), seen.slope, seen.slope};
                 return filtered(filters::hard{}, receivers, h);
             }},
            {"visibility of pages", paged},
            {"shadow: draw, store, visibility", shadow_of_a_light}};
}
