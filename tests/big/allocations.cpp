// SPDX-License-Identifier: MIT
//
// Allocation failures in each function over images: whichever allocation fails, std::bad_alloc reaches the caller. No
// input changes, nothing leaks, and the next call gives the right result.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <functional>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/umbrage.hpp>

#include "../threads/functions.hpp"
#include "heap.hpp"

namespace {

using namespace umbrage;

/// Triangles of any size anywhere. Some cross the near plane. They are drawn in bands.
struct soup {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    explicit soup(unsigned count = 80) {
        numbers random;
        for (unsigned i = 0; i < 3 * count; i += 3) {
            for (int corner = 0; corner < 3; ++corner)
                positions.emplace_back(random(-0.9f, 1), random(-0.9f, 1), random(-0.1f, 1));
            triangles.emplace_back(i, i + 1, i + 2);
        }
    }
    [[nodiscard]] mesh_view view() const { return {positions, triangles}; }
};

/// Triangles that follow each other: threads draw them under locks.
struct strip : soup {
    strip() : soup(0) {
        for (unsigned i = 0; i < 5000; ++i) {
            positions.emplace_back(float(i % 50) / 25 - 1, float(i / 50) / 50 - 1, 0.5f);
            if (i > 50) triangles.emplace_back(i, i - 1, i - 50);
        }
    }
};

/// Arguments of all functions. None of them may change.
struct arguments {
    image<float> depths = random_depths({190, 64});
    image<glm::u8vec2> packed{depths.size()};
    image<glm::vec2> moments{depths.size()};
    image<std::uint32_t> words{depths.size()};
    image<float> x{{128, 64}}, y{x.size()}, z{x.size()}, slopes{x.size(), 0.001f};
    image<glm::vec3> points{x.size()}, normals{x.size(), glm::vec3(0, 0, 1)};
    soup any, few{4};
    strip coherent;
    std::vector<glm::mat4> places{5, glm::mat4(0.5f)};
    blur_kernel kernel = make_gaussian_kernel(5, 1.0f);

    arguments() {
        numbers random;
        encode(depths, packed, rg<11>{});
        encode_moments(depths, moments, prefilters::vsm{});
        for (std::size_t i = 0; i < words.texels().size(); ++i)
            words.texels()[i] = static_cast<std::uint32_t>(depths.texels()[i] * 100);
        for (float& v : x.texels()) v = random(-2, 192);
        for (float& v : y.texels()) v = random(-2, 66);
        for (float& v : z.texels()) v = random(0, 1);
        for (glm::vec3& p : points.texels()) p = {random(-2, 2), random(-2, 2), random(-1, 1)};
        for (glm::mat4& m : places) m[3].w = 1;
    }

    [[nodiscard]] receiver_planes receivers() const { return {x, y, z}; }
    [[nodiscard]] std::vector<std::span<const std::byte>> parts() const {
        const auto of = [](const auto& values) { return std::as_bytes(std::span(values)); };
        return {of(depths.texels()), of(packed.texels()),  of(moments.texels()),   of(words.texels()),
                of(x.texels()),      of(y.texels()),       of(z.texels()),         of(slopes.texels()),
                of(points.texels()), of(normals.texels()), of(any.positions),      of(any.triangles),
                of(few.positions),   of(few.triangles),    of(coherent.positions), of(coherent.triangles),
                of(places),          of(kernel.weights)};
    }
};

/// True if all bytes are equal.
bool same_bytes(const arguments& a, const arguments& b) {
    return std::ranges::equal(a.parts(), b.parts(), [](const auto& p, const auto& q) {
        return p.size() == q.size() && std::memcmp(p.data(), q.data(), p.size()) == 0;
    });
}

const light_space<float> spot =
    make_spot_light<float>({.position = {0, 0, 4}, .direction = {0, 0, -1}, .clip = cpu_clip_space});

/// Functions over images. Each allocates, except where its name says so.
std::vector<function> functions(const arguments& a) {
    const auto drawn = [](const mesh_view& mesh, const hook& h, glm::ivec2 size) {
        image<float> depth(size, 1.0f);
        rasterize_depth(depth, mesh, glm::mat4(1), cpu_clip_space, cull_mode::none, h, near_plane::clamps);
        return blob_of(depth);
    };
    const auto seen = [&a](const auto& map, const auto& encoding, const auto& filter, const hook& h) {
        image<float> out(a.x.size());
        visibility(map, encoding, a.receivers(), filter, out, h);
        return blob_of(out);
    };
    const auto lit = [&a](const auto& filter, const hook& h) {
        const shadow of(spot, {64, 64}, filter, rg<11>{});
        image<float> depths(of.size(), cleared_depth(cpu_clip_space)), out(a.points.size());
        of.draw(depths, a.any.view(), h);
        image<glm::u8vec2> texels(of.size());
        of.store(depths, texels, h);
        of.visibility(texels, a.points, a.normals, out, h);
        return blob_of(out);
    };
    return {
        {"rasterize_depth in bands",
         [&a, drawn](const hook& h) {
             return drawn(a.any.view(), h, {96, 200});
         }},
        {"rasterize_depth in copied bands",
         [&a, drawn](const hook& h) {
             return drawn(a.any.view(), h, {1024, 128});
         }},
        {"rasterize_depth under locks",
         [&a, drawn](const hook& h) {
             return drawn(a.coherent.view(), h, {96, 200});
         }},
        {"rasterize_depth of instances",
         [&a](const hook& h) {
             image<float> depth({96, 200}, 1.0f);
             rasterize_depth(depth, a.any.view(), a.places, glm::mat4(1), cpu_clip_space, cull_mode::none, h);
             return blob_of(depth);
         }},
        {"rasterize",
         [&a](const hook&) {
             image<float> sum({96, 64});
             rasterize(sum.size(), a.any.view(), glm::mat4(1), cpu_clip_space,
                       [&](glm::ivec2 texel, float depth, unsigned) { sum[texel] += depth; });
             return blob_of(sum);
         }},
        {"rasterize_dual_paraboloid",
         [&a](const hook& h) {
             const auto light = make_dual_paraboloid_light<float>({.range = 3, .map_size = 96, .clip = cpu_clip_space});
             image<float> depth({96, 96}, 1.0f);
             rasterize_dual_paraboloid(depth, a.any.view(), light, 0, h);
             return blob_of(depth);
         }},
        {"rasterize_tetrahedron",
         [&a](const hook& h) {
             const auto faces = make_tetrahedron_light(
                 tetrahedron_light<float>{.z_near = 0.1f, .z_far = 3, .map_size = 96, .clip = cpu_clip_space});
             image<float> depth({96, 96}, 1.0f);
             rasterize_tetrahedron(depth, a.any.view(), faces, cull_mode::none, h);
             return blob_of(depth);
         }},
        {"tessellate",
         [&a](const hook&) {
             const auto cut = tessellate(a.few.view(), {.position = {0, 0, 0.5f}, .angle = 0.5f, .range = 3});
             return blob_of(std::span(cut.positions));
         }},
        {"instances_in_map",
         [&a](const hook&) {
             const auto kept = instances_in_map(bounds_of(a.any.view()), a.places, glm::mat4(1), cpu_clip_space);
             return blob_of(std::span(kept));
         }},
        {"encode, decode",
         [&a](const hook& h) {
             image<glm::u8vec2> texels(a.depths.size());
             encode(a.depths, texels, rg<11>{}, h);
             image<float> back(a.depths.size());
             decode(texels, back, rg<11>{}, h);
             return blob_of(back);
         }},
        {"encode_moments, blur",
         [&a](const hook& h) {
             image<glm::vec2> texels(a.depths.size()), blurred(a.depths.size());
             encode_moments(a.depths, texels, prefilters::vsm{}, h);
             blur(texels.view(), blurred.view(), a.kernel, h);
             return blob_of(blurred);
         }},
        {"make_mip_chain", [&a](const hook& h) { return blob_of(make_mip_chain(a.moments, 3, h).back()); }},
        {"make_min_max_pyramid",
         [&a](const hook& h) { return blob_of(make_min_max_pyramid(a.depths, 3, h).back().least); }},
        {"make_filter_bounds",
         [&a](const hook& h) { return blob_of(make_filter_bounds(a.depths, 3.5f, {}, h).bounds); }},
        {"measure_depths",
         [&a](const hook& h) {
             const depth_span span = measure_depths(a.depths, 1.0f, h);
             return blob_of(std::span<const float>(&span.least, 1));
         }},
        {"stretch",
         [&a](const hook&) {
             const contrast_stretch range = stretch(a.depths);
             return blob_of(std::span<const float>(&range.low, 1));
         }},
        {"summed_area",
         [&a](const hook& h) {
             image<std::uint32_t> sums(a.words.size());
             summed_area(a.words, sums, h);
             return blob_of(sums);
         }},
        {"make_variance_table",
         [&a](const hook& h) { return blob_of(make_variance_table(a.depths, {.radius = 4}, h)); }},
        {"make_moment_table", [&a](const hook& h) { return blob_of(make_moment_table(a.depths, {.radius = 4}, h)); }},
        {"visibility by box", [&a, seen](const hook& h) { return seen(a.depths, depth32f{}, filters::box{1}, h); }},
        {"visibility by bounds", [&a, seen](const hook& h) { return seen(a.depths, depth32f{}, filters::box{3}, h); }},
        {"visibility by bounds of a packed map",
         [&a, seen](const hook& h) { return seen(a.packed, rg<11>{}, filters::box{3}, h); }},
        {"visibility by disc", [&a, seen](const hook& h) { return seen(a.packed, rg<11>{}, filters::disc{}, h); }},
        {"visibility along planes",
         [&a](const hook& h) {
             image<float> out(a.x.size());
             const sloped_receivers receivers{a.receivers(), a.slopes, a.slopes};
             visibility(a.packed, rg<11>{}, receivers, filters::box{2}, out, h);
             return blob_of(out);
         }},
        {"visibility of a prefiltered map",
         [&a](const hook& h) {
             image<float> out(a.x.size());
             visibility(a.moments, prefilters::vsm{}, a.receivers(), out, h);
             return blob_of(out);
         }},
        {"shadow: draw, store, visibility", [lit](const hook& h) { return lit(filters::tent<3>, h); }},
        {"shadow along planes",
         [lit](const hook& h) { return lit(filters::pcss{.softness = make_penumbra_params(0.1f, 1.0f, 6.0f)}, h); }},
    };
}

/// Fails each allocation in turn, until the function succeeds.
/// @return   number of calls
long fail_each(const function& of, const hook& parallel, heap::lack lack, const blob& expected, const arguments& given,
               const arguments& untouched, int& failures) {
    const auto check = [&](bool holds, const char* what, long nth) {
        if (holds) return;
        ++failures;
        std::printf("%s, allocation %ld: %s\n", of.name.c_str(), nth, what);
    };
    for (long nth = 1;; ++nth) {
        const std::size_t before = heap::live();
        bool thrown = false, is_right = true;
        heap::fail(nth, lack);
        try {
            const blob result = of.run(parallel);
            heap::stop_failing();
            is_right = result == expected;
        } catch (const std::bad_alloc&) { thrown = true; }
        const bool has_failed = heap::stop_failing();
        check(thrown == has_failed, "std::bad_alloc does not reach the caller", nth);
        check(heap::live() == before, "memory leaks", nth);
        check(is_right, "other bits", nth);
        check(same_bytes(given, untouched), "an input changes", nth);
        if (!has_failed || failures > 0) return nth;
    }
}

}  // namespace

int main() {
    const arguments given, untouched;
    int failures = 0;
    long tried = 0;
    const std::vector<function> all = functions(given);
    for (const function& of : all) {
        const blob expected = of.run(hooks::all_in_one);
        for (const hook& parallel : {hook(hooks::all_in_one), hook(hooks::pool{3})})
            for (const heap::lack lack : {heap::lack::once, heap::lack::all}) {
                const long calls = fail_each(of, parallel, lack, expected, given, untouched, failures);
                if (calls < 2) ++failures, std::printf("%s: no allocation was tried\n", of.name.c_str());
                tried += calls - 1;
            }
    }
    std::printf("%zu functions, %ld failed allocations, %d failures\n", all.size(), tried, failures);
    return failures != 0;
}
