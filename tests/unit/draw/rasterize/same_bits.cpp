// SPDX-License-Identifier: MIT
//
// No order, cut into pieces or instruction set changes a bit.
#include <umbrage/draw/rasterize.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "../../rounds.hpp"
#include "../../images/isas.hpp"
#include "exact.hpp"
#include "scene.hpp"

using namespace raster_scene;

TEST_CASE("rasterize_depth: permuted triangles and vertices, and a split into meshes, give the same bits") {
    generator random;
    const glm::ivec2 size(320, 240);
    for (clip_space clip :
         {cpu_clip_space, clip_space{.range = depth_range::zero_to_one, .direction = depth_direction::reversed}}) {
        mesh m = soup(random, 400);
        const auto reference = render(size, m, perspective(), clip);
        CHECK(std::count_if(reference.texels().begin(), reference.texels().end(),
                            [&](float z) { return z != cleared_depth(clip); }) > 40000);
        for (int round = 0; round < rounds(20); ++round) {
            std::shuffle(m.triangles.begin(), m.triangles.end(), random.engine);
            for (auto& t : m.triangles)
                for (int swaps = random(0, 3); swaps > 0; --swaps) std::swap(t[random(0, 2)], t[random(0, 2)]);
            CHECK(same_bits(render(size, m, perspective(), clip), reference));
        }
        image<float> split(size, cleared_depth(clip));
        for (std::size_t i = 0; i < m.triangles.size(); i += 100)
            rasterize_depth(split, {m.positions, std::span(m.triangles).subspan(i, 100)}, perspective(), clip);
        CHECK(same_bits(split, reference));
    }
}

TEST_CASE("rasterize_depth: compilers, flags and machines give the same bits for what is not clipped") {
    generator random;
    const glm::ivec2 size(128, 128);
    mesh m;
    for (int i = 0; i < 2000; ++i) {
        const glm::ivec2 center{random(-110, 110), random(-110, 110)};  // braces: in this order
        std::array<glm::vec3, 3> p;
        for (auto& c : p)
            c = glm::vec3{center.x + random(-20, 20), center.y + random(-20, 20), random(90, 150)} / 64.0f;
        m.add(p[0], p[1], p[2]);
    }
    const auto matrix = exact_scene({123, -77, 1999, 1000}).matrix;
    for_each_isa([&] {
        std::uint64_t hash = 14695981039346656037u;  // FNV-1a
        rasterize(size, m, matrix, cpu_clip_space, [&](glm::ivec2 texel, float depth, unsigned triangle) {
            for (unsigned word : {unsigned(texel.x), unsigned(texel.y), std::bit_cast<unsigned>(depth), triangle})
                hash = (hash ^ word) * 1099511628211u;
        });
        CHECK(hash == 3075832276352545962u);
    });
}

TEST_CASE("rasterize_depth: every instruction set and every cut into pieces gives the bits of sample by sample") {
    generator random;
    int covered = 0, kept = 0;
    for (const glm::ivec2 size : {glm::ivec2(517, 300), glm::ivec2(5, 700), glm::ivec2(2100, 40), glm::ivec2(8, 1)})
        for (auto direction : {depth_direction::forward, depth_direction::reversed})
            for (auto origin : {texture_origin::bottom, texture_origin::top}) {
                const clip_space clip{.range = depth_range::zero_to_one, .direction = direction, .origin = origin};
                const mesh m = soup(random, rounds(2000));

                // whatever can be in an image: numbers, both zeros, denormals, infinities, NaNs of both signs
                image<float> before(size, cleared_depth(clip));
                for (float& z : before.texels())
                    if (random(0, 3) == 0) z = std::bit_cast<float>(unsigned(random.engine()));
                    else if (random(0, 3) == 0) z = random(0, 1) ? -0.0f : 0.0f;
                image<float> reference = before;
                rasterize(size, m, perspective(), clip, [&](glm::ivec2 texel, float z, unsigned) {
                    float& there = reference[texel];
                    ++covered;
                    if (is_nan(there) || (direction == depth_direction::forward ? z > there : z < there)) ++kept;
                    else there = z;
                });
                for_each_isa([&] {
                    for (int pieces : {1, 2, 3, 7}) {
                        image<float> depth = before;
                        rasterize_depth(depth, m, perspective(), clip, cull_mode::none, [&](int count, auto&& piece) {
                            for (int i = pieces - 1; i >= 0; --i) piece(count * i / pieces, count * (i + 1) / pieces);
                        });
                        CHECK(same_bits(depth, reference));
                    }
                });
            }
    CHECK(covered > rounds(1000000));
    CHECK(kept > rounds(100000));

    // coverage, planes and the order of calls as well
    mesh large = soup(random, rounds(3000));
    std::vector<std::uint64_t> calls;
    for_each_isa([&] {
        std::uint64_t hash = 14695981039346656037u;
        rasterize({96, 64}, large, perspective(), cpu_clip_space, [&](glm::ivec2 texel, float z, unsigned triangle) {
            for (unsigned word : {unsigned(texel.x), unsigned(texel.y), std::bit_cast<unsigned>(z), triangle})
                hash = (hash ^ word) * 1099511628211u;
        });
        calls.push_back(hash);
    });
    for (const std::uint64_t hash : calls) CHECK(hash == calls.front());
}

TEST_CASE("rasterize_depth: triangles of a few texels, among others or not, are drawn like sample by sample") {
    generator random;
    const auto depth = [&] {  // some beyond the far plane, at both ends, or so small that they may be flushed
        const float special[] = {0.0f, 1.0f, 1e-40f, 1e-37f, 1.2f, -0.2f};
        return random(0, 9) == 0 ? special[random(0, 5)] : random.real(0.0f, 1.0f);
    };
    const auto texels = [&](int low, int high) { return 256 * random(low, high); };
    int covered = 0, kept = 0;
    const auto check = [&](glm::ivec2 size, clip_space clip, const mesh& m) {
        image<float> before(size, cleared_depth(clip));
        for (float& z : before.texels())
            if (random(0, 3) == 0) z = std::bit_cast<float>(unsigned(random.engine()));
        image<float> reference = before;
        rasterize(size, m, glm::mat4(1.0f), clip, [&](glm::ivec2 texel, float z, unsigned) {
            float& there = reference[texel];
            ++covered;
            if (is_nan(there) || (clip.direction == depth_direction::forward ? z > there : z < there)) ++kept;
            else there = z;
        });
        for_each_isa([&] {
            image<float> alone = before, in_bands = before;
            rasterize_depth(alone, m, glm::mat4(1.0f), clip);
            CHECK(same_bits(alone, reference));
            rasterize_depth(in_bands, m, glm::mat4(1.0f), clip, cull_mode::none,
                            [](int count, auto&& piece) { piece(0, count); });
            CHECK(same_bits(in_bands, reference));
        });
    };
    for (auto direction : {depth_direction::forward, depth_direction::reversed})
        for (auto origin : {texture_origin::bottom, texture_origin::top}) {
            const clip_space clip{.range = depth_range::zero_to_one, .direction = direction, .origin = origin};
            const glm::ivec2 size(203, 170), tiny(4, 3);
            for (const int large_of_eight : {0, 1, 4, 6, 7}) {
                mesh m;
                for (int i = 0; i < rounds(6000); ++i) {
                    const int reach = random(1, 8) <= large_of_eight ? texels(1, 20) : random(64, 700);
                    const glm::ivec2 center{random(-512, 256 * size.x + 512), random(-512, 256 * size.y + 512)};
                    const bool alike = random(0, 2) == 0;  // depths from a power of two to the next, or near to them
                    const float scale = std::ldexp(1.0f, random(0, 3) == 0 ? -125 : random(-3, 0));
                    std::array<glm::vec3, 3> corner;
                    for (auto& c : corner) {
                        const glm::ivec2 to{random(-reach, reach), random(-reach, reach)};
                        const float near[] = {0.5f, std::nextafter(0.5f, 0.0f), std::nextafter(1.0f, 0.0f), 1.0f};
                        const float z = random(0, 3) ? random.real(0.5f, 1.0f) : near[random(0, 3)];
                        c = at(center.x + to.x, center.y + to.y, size, alike ? scale * z : depth());
                    }
                    m.add(corner[0], corner[1], corner[2]);
                }
                check(size, clip, m);
            }
            // Slivers through a texel's center, so steep that planes there leave what lies between the corners' depths.
            mesh slivers;
            for (int i = 0; i < rounds(20000); ++i) {
                const int x = texels(0, size.x - 1) + 128, y = texels(0, size.y - 1) + 128;
                const glm::ivec2 step{random(-3, 3), random(-3, 3)};
                const int most = random(0, 1) ? 100 : 3000;
                const glm::ivec2 back = step * random(1, most), on = step * random(1, most);
                const float scale = std::ldexp(1.0f, -random(0, 20)), along = scale * depth(), aside = depth();
                slivers.add(at(x - back.x, y - back.y, size, along), at(x + on.x, y + on.y, size, along),
                            at(x + on.x + random(-1, 1), y + on.y + random(-1, 1), size, aside));
            }
            check(size, clip, slivers);
            // Few texels of triangles whose edges do not fit 32 bits.
            mesh large;
            for (int i = 0; i < rounds(2000); ++i) {
                std::array<glm::vec3, 3> corner;
                for (auto& c : corner) c = at(texels(-9000, 9000), texels(-9000, 9000), tiny, depth());
                large.add(corner[0], corner[1], corner[2]);
            }
            check(tiny, clip, large);
        }
    CHECK(covered > rounds(1000000));
    CHECK(kept > rounds(100000));
}

TEST_CASE("rasterize_depth: meshes of several chunks, coherent or not, are drawn like sample by sample") {
    generator random;
    const glm::ivec2 size(300, 260);
    constexpr unsigned side = 460;  // shuffled, the triangles of a chunk reach over more vertices than they use
    mesh m;
    for (unsigned y = 0; y <= side; ++y)
        for (unsigned x = 0; x <= side; ++x)
            m.positions.emplace_back(2.0f * float(x) / float(side) - 1.0f, 2.0f * float(y) / float(side) - 1.0f,
                                     random.real(0.25f, 0.75f));
    for (unsigned y = 0; y < side; ++y)
        for (unsigned x = 0; x < side; ++x) {
            const unsigned i = y * (side + 1) + x, above = i + side + 1;
            m.triangles.emplace_back(i, i + 1, above);
            m.triangles.emplace_back(i + 1, above + 1, above);
        }
    image<float> reference(size, 1.0f);
    rasterize(size, m, glm::mat4(1.0f), cpu_clip_space,
              [&](glm::ivec2 texel, float z, unsigned) { reference[texel] = std::min(reference[texel], z); });
    CHECK(std::count(reference.texels().begin(), reference.texels().end(), 1.0f) == 0);
    for (const bool scattered : {false, true}) {
        if (scattered) std::shuffle(m.triangles.begin(), m.triangles.end(), random.engine);
        CHECK(same_bits(render(size, m), reference));
        image<float> by_halves(size, 1.0f);
        rasterize_depth(by_halves, m, glm::mat4(1.0f), cpu_clip_space, cull_mode::none, [](int count, auto&& piece) {
            piece(count / 2, count);
            piece(0, count / 2);
        });
        CHECK(same_bits(by_halves, reference));
    }
}

TEST_CASE("rasterize_depth: ground around the camera, cut by every plane, is drawn in bands like sample by sample") {
    generator random;
    const glm::ivec2 size(300, 700);
    constexpr unsigned side = 150;  // rows of which many runs lie in few bands, and some have corners without a row
    mesh m;
    for (unsigned z = 0; z <= side; ++z)
        for (unsigned x = 0; x <= side; ++x)
            m.positions.emplace_back(0.1f * (float(x) - 75.0f), random.real(-1.1f, -0.9f), 0.1f * (75.0f - float(z)));
    m.positions[500].y = nan_value;
    m.positions[9000].x = infinity;
    m.positions[9500].x = -1e30f;  // beyond the guard band
    for (unsigned z = 0; z < side; ++z)
        for (unsigned x = 0; x < side; ++x) {
            const unsigned i = z * (side + 1) + x, above = i + side + 1;
            m.triangles.emplace_back(i, i + 1, above);
            m.triangles.emplace_back(i + 1, above + 1, above);
        }
    for (const near_plane at_near : {near_plane::clips, near_plane::clamps})
        for (const float turn : {0.0f, 0.5f, 2.0f}) {
            glm::mat4 turned(1.0f);
            turned[0][0] = turned[1][1] = std::cos(turn), turned[0][1] = std::sin(turn), turned[1][0] = -turned[0][1];
            const glm::mat4 matrix = perspective() * turned;
            image<float> reference(size, 1.0f), alone = reference, in_pieces = reference;
            rasterize(
                size, m, matrix, cpu_clip_space,
                [&](glm::ivec2 texel, float z, unsigned) { reference[texel] = std::min(reference[texel], z); },
                cull_mode::none, at_near);
            CHECK(std::count(reference.texels().begin(), reference.texels().end(), 1.0f) < 200000);
            rasterize_depth(alone, m, matrix, cpu_clip_space, cull_mode::none, serial{}, at_near);
            CHECK(same_bits(alone, reference));
            rasterize_depth(
                in_pieces, m, matrix, cpu_clip_space, cull_mode::none,
                [](int count, auto&& piece) {
                    for (int i = count; i-- > 0;) piece(i, i + 1);
                },
                at_near);
            CHECK(same_bits(in_pieces, reference));
        }
}

TEST_CASE("rasterize_depth: corners so far away that cuts are rounded off their edges are drawn in bands the same") {
    generator random;
    const glm::ivec2 size(64, 700);
    for (int round = 0; round < rounds(8); ++round) {
        mesh m;
        for (int i = 0; i < 3000; ++i) {
            std::array<glm::vec3, 3> corner;
            for (auto& c : corner)
                for (int k = 0; k < 3; ++k)
                    c[k] = float(random(0, 1) ? 1 : -1) * std::exp2(random.real(-6, random(0, 3) ? 2.0f : 54.0f));
            m.add(corner[0], corner[1], corner[2]);
        }
        image<float> reference(size, 1.0f), in_bands = reference;
        rasterize(size, m, perspective(), cpu_clip_space,
                  [&](glm::ivec2 texel, float z, unsigned) { reference[texel] = std::min(reference[texel], z); });
        rasterize_depth(in_bands, m, perspective(), cpu_clip_space, cull_mode::none,
                        [](int count, auto&& piece) { piece(0, count); });
        CHECK(same_bits(in_bands, reference));
    }
}
