// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <array>
#include <limits>
#include <random>
#include <vector>

#include <umbrage/depth/rg.hpp>
#include <umbrage/draw/instances.hpp>
#include <umbrage/draw/rasterize.hpp>
#include <umbrage/images/page_atlas.hpp>

#include "../light/clip_spaces.hpp"
#include "last_piece_first.hpp"

namespace {

/// Leaves over a plain, a light above, and pages that get finer towards a point.
struct paged_scene {
    std::vector<glm::vec3> positions{{-2, 2, -1}, {2, 3, -1}, {0, 3, 2}};
    std::vector<glm::uvec3> triangles{{0, 1, 2}};
    std::vector<glm::mat4> places;
    umbrage::clip_space clip;
    umbrage::page_size size{.texels = 16, .gutter = 4};
    umbrage::light_space<double> root;
    umbrage::page_cache cache{{.slots = {5, 4}, .deepest_level = 4}};
    umbrage::image<glm::u8vec4> table{page_table_size(cache)};
    umbrage::image<float> atlas;

    explicit paged_scene(umbrage::clip_space c, bool culls = true) : clip(c) {
        std::mt19937 random(3);
        for (int i = 0; i < 60; ++i) {
            glm::mat4 place(1);
            place[3].x = std::uniform_real_distribution(-20.0f, 20.0f)(random);
            place[3].z = std::uniform_real_distribution(-20.0f, 20.0f)(random);
            places.push_back(place);
        }
        root = umbrage::make_page_root<double>(
            {.direction = {0.4, -1, 0.3}, .side = 50, .scene = {{-21, 0, -21}, {21, 3, 21}}, .clip = clip});
        std::vector<umbrage::page_receiver> seen;
        for (float x = 1.01f; x < 2; x += 0.06f)
            for (float y = 1.01f; y < 2; y += 0.06f)
                seen.push_back({{x, y}, 0.3f / ((x - 1.4f) * (x - 1.4f) + (y - 1.6f) * (y - 1.6f))});
        atlas = umbrage::image<float>(page_atlas_size(cache, size), -5.0f);
        const umbrage::mesh_view mesh{positions, triangles};
        umbrage::draw_pages(atlas, size, root, cache.update(seen).drawn, [&](auto map, const glm::mat4& to_clip) {
            const auto some = umbrage::instances_in_map(umbrage::bounds_of(mesh), places, to_clip, clip);
            umbrage::rasterize_depth(map, mesh, culls ? some : places, to_clip, clip);
        });
        umbrage::write_page_table(cache, table);
    }

    /// Points in and around the root.
    [[nodiscard]] umbrage::image<glm::vec3> receivers() const {
        umbrage::image<glm::vec3> all({37, 29});
        std::mt19937 random(4);
        for (glm::vec3& r : all.texels()) {
            const float x = std::uniform_real_distribution(0.95f, 2.05f)(random);
            const float y = std::uniform_real_distribution(0.95f, 2.05f)(random);
            r = {x, y, std::uniform_real_distribution(0.25f, 1.0f)(random)};
        }
        all.texels()[5].x = std::numeric_limits<float>::quiet_NaN();
        all.texels()[6].y = std::numeric_limits<float>::infinity();
        return all;
    }
};

}  // namespace

TEST_CASE("write_page_table: the finest page of each cell, none before the first") {
    const paged_scene scene(umbrage::cpu_clip_space);
    int levels[5]{};
    for (glm::ivec2 cell(0); cell.y < 16; ++cell.y)
        for (cell.x = 0; cell.x < 16; ++cell.x) {
            const int level = scene.cache.level_at(1.0 + (glm::dvec2(cell) + 0.5) / 16.0);
            scene.cache.for_each([&](const umbrage::page& p, glm::ivec2 slot) {
                if (p == umbrage::page_at(1.0 + (glm::dvec2(cell) + 0.5) / 16.0, level))
                    CHECK(scene.table[cell + 1] == umbrage::page_entry(slot, level));
            });
            ++levels[level];
        }
    CHECK(levels[1] > 0);
    CHECK(levels[4] > 0);
    for (int i = 0; i < 18; ++i)
        for (const glm::ivec2 beside : {glm::ivec2(i, 0), {i, 17}, {0, i}, {17, i}})
            CHECK(scene.table[beside] == glm::u8vec4(0));
    umbrage::image<glm::u8vec4> table({18, 18}, glm::u8vec4(7));
    umbrage::write_page_table(umbrage::page_cache({.deepest_level = 4}), table);
    CHECK(table[{9, 9}] == glm::u8vec4(0));
}

TEST_CASE("draw_pages: culled or not, the same bits; what page_light shows; other slots as they were") {
    const paged_scene scene(umbrage::cpu_clip_space), whole(umbrage::cpu_clip_space, false);
    for (int y = 0; y < scene.atlas.size().y; ++y)
        for (int x = 0; x < scene.atlas.size().x; ++x)
            if (scene.atlas[{x, y}] != whole.atlas[{x, y}]) FAIL_CHECK(x << ' ' << y);
    std::size_t drawn = 0, marked = 0;
    scene.cache.for_each([&](const umbrage::page& p, glm::ivec2 slot) {
        const auto light = umbrage::page_light(scene.root, p, scene.size);
        umbrage::image<float> map({24, 24}, 1.0f);
        umbrage::rasterize_depth(map, {scene.positions, scene.triangles}, scene.places,
                                 glm::mat4(light.projection * light.view), umbrage::cpu_clip_space);
        for (glm::ivec2 texel(0); texel.y < 24; ++texel.y)
            for (texel.x = 0; texel.x < 24; ++texel.x, ++drawn) {
                if (map[texel] != scene.atlas[slot * 24 + texel]) FAIL_CHECK(texel.x << ' ' << texel.y);
                marked += map[texel] < 1.0f;
            }
    });
    CHECK(marked > drawn / 50);
    std::size_t untouched = 0;
    for (const float texel : scene.atlas.texels()) untouched += texel == -5.0f;
    CHECK(untouched == scene.atlas.texels().size() - drawn);
}

TEST_CASE("visibility: the filter over each receiver's page, for every form of receivers, split or not") {
    for (const auto direction : {umbrage::depth_direction::forward, umbrage::depth_direction::reversed}) {
        const paged_scene scene({.range = umbrage::depth_range::zero_to_one, .direction = direction});
        const auto receivers = scene.receivers();
        const umbrage::filters::pcf_2x2 filter;
        const umbrage::depth32f encoding{.direction = direction};
        umbrage::image<float> out(receivers.size(), -1.0f), split(out), planes(out);
        const umbrage::page_map<float> map{scene.atlas, scene.table, scene.size};
        umbrage::visibility(map, encoding, receivers, filter, out);
        umbrage::visibility(map, encoding, receivers, filter, split, last_piece_first{7});
        umbrage::image<float> x(out), y(out), z(out);
        for (std::size_t i = 0; i < x.texels().size(); ++i) {
            const glm::vec3 r = receivers.texels()[i];
            x.texels()[i] = r.x, y.texels()[i] = r.y, z.texels()[i] = r.z;
        }
        umbrage::visibility(map, encoding, umbrage::receiver_planes{x, y, z}, filter, planes);
        int dark = 0, between = 0;
        for (std::size_t i = 0; i < x.texels().size(); ++i) {
            const glm::vec3 r = receivers.texels()[i];
            const auto in_table = [&](glm::ivec2 cell) { return scene.table[cell]; };
            const glm::vec4 at = umbrage::page_coordinate(in_table, 18.0f, glm::vec2(r), 16.0f, 4.0f);
            const auto page = std::as_const(scene.atlas).view().region(glm::ivec2(at.z, at.w), glm::ivec2(24));
            const float one =
                umbrage::pcf_2x2(umbrage::clamped(page), glm::vec2(at), r.z, umbrage::comparison{direction});
            const float found = out.texels()[i];
            if (found != one || split.texels()[i] != one || planes.texels()[i] != one) FAIL_CHECK(i);
            dark += one == 0.0f, between += one > 0.0f && one < 1.0f;
        }
        CHECK(out.texels()[5] == 1.0f);
        CHECK(out.texels()[6] == 1.0f);
        CHECK(dark > 5);
        CHECK(between > 20);
    }
}

TEST_CASE("visibility: an atlas of codes; cells without a page are lit") {
    const paged_scene scene(umbrage::cpu_clip_space);
    const umbrage::rg<16> encoding{};
    umbrage::image<glm::u8vec2> codes(scene.atlas.size());
    umbrage::encode(scene.atlas, codes.view(), encoding);
    const auto receivers = scene.receivers();
    umbrage::image<float> out(receivers.size()), plain(receivers.size());
    umbrage::visibility({codes, scene.table, scene.size}, encoding, receivers, umbrage::filters::hard{}, out);
    umbrage::visibility({scene.atlas, scene.table, scene.size}, umbrage::depth32f{}, receivers,
                        umbrage::filters::hard{}, plain);
    int differ = 0;
    for (std::size_t i = 0; i < out.texels().size(); ++i) differ += out.texels()[i] != plain.texels()[i];
    CHECK(differ <= 2);
    const umbrage::image<glm::u8vec4> none({18, 18});
    umbrage::visibility({scene.atlas, none, scene.size}, umbrage::depth32f{}, receivers, umbrage::filters::hard{}, out);
    for (const float visibility : out.texels())
        if (visibility != 1.0f) CHECK(visibility == 1.0f);
}

TEST_CASE("draw_pages, write_page_table, visibility: bad input") {
    paged_scene scene(umbrage::cpu_clip_space);
    const auto receivers = scene.receivers();
    umbrage::image<float> out(receivers.size()), small({3, 3});
    const auto seen = [&](umbrage::page_map<float> map, umbrage::image<float>& into) {
        return complaint([&] {
            umbrage::visibility(map, umbrage::depth32f{}, receivers, umbrage::filters::box{.radius = 3}, into);
        });
    };
    const std::string name = "umbrage::visibility: ";
    const umbrage::page_map<float> map{scene.atlas, scene.table, scene.size};
    CHECK(seen(map, out).empty());
    CHECK(seen(map, small).starts_with(name + "out.size "));
    CHECK(seen({scene.atlas, scene.table, {.texels = 18, .gutter = 3}}, out).starts_with(name + "size.gutter "));
    constexpr int greatest = std::numeric_limits<int>::max();
    for (const int texels : {0, 16385, 1 << 30, greatest})
        CHECK(seen({scene.atlas, scene.table, {texels, 4}}, out).starts_with(name + "size.texels "));
    for (const int gutter : {-1, 8193, greatest})
        CHECK(seen({scene.atlas, scene.table, {16, gutter}}, out).starts_with(name + "size.gutter "));
    const umbrage::page_cache wide({.slots = {256, 256}});
    const auto atlas_size = [&](const umbrage::page_size& size) {
        return complaint([&] { (void)page_atlas_size(wide, size); });
    };
    CHECK(page_atlas_size(wide, {16384, 8192}) == glm::ivec2(1 << 23));
    CHECK(atlas_size({1 << 25, 0}).starts_with("umbrage::page_atlas_size: size.texels "));
    CHECK(atlas_size({16, greatest}).starts_with("umbrage::page_atlas_size: size.gutter "));
    for (const glm::ivec2 slot : {glm::ivec2(greatest, 0), {0, -greatest}, {256, 0}, {0, -1}})
        CHECK(complaint([&] {
                  const umbrage::placed_page placed{{}, slot};
                  umbrage::draw_pages(scene.atlas, scene.size, scene.root, {&placed, 1}, [](auto, const glm::mat4&) {});
              }).starts_with("umbrage::draw_pages: slot "));
    CHECK(complaint([&] {
              umbrage::visibility(map, umbrage::depth32f{}, receivers, umbrage::filters::disc{.points = 12}, out);
          }) == name + "filter.points must be 8, 16 or 32; got 12");
    CHECK(seen({scene.atlas, {}, scene.size}, out).starts_with(name + "table.size "));
    CHECK(seen({scene.atlas, scene.table.view().rows(0, 10), scene.size}, out).starts_with(name + "table.size "));
    CHECK(seen({small, scene.table, scene.size}, out).starts_with(name + "table "));
    umbrage::image<glm::u8vec4> table({8, 8});
    CHECK(complaint([&] {
              umbrage::write_page_table(scene.cache, table);
          }).starts_with("umbrage::write_page_table: table.size must be page_table_size, "));
    const std::array beyond{umbrage::placed_page{{}, {5, 0}}};
    CHECK(complaint([&] {
              umbrage::draw_pages(scene.atlas, scene.size, scene.root, beyond, [](auto, const glm::mat4&) {});
          }).starts_with("umbrage::image_view::region: extent "));
}
