// SPDX-License-Identifier: MIT
//
// Meshes: a tessellation is the same surface with short edges, what culling drops draws nothing, a camera pass sees the
// depth pass' depths, and maps of points have depths in range.
#include <cmath>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <umbrage/draw/dual_paraboloid_pass.hpp>
#include <umbrage/draw/instances.hpp>
#include <umbrage/draw/rasterize.hpp>
#include <umbrage/draw/tessellate.hpp>
#include <umbrage/draw/tetrahedron_pass.hpp>
#include <umbrage/light/point/tetrahedron_light.hpp>
#include <umbrage/light/spot_light.hpp>

#include "../mesh.hpp"
#include "input.hpp"

namespace {

using namespace umbrage;

using tests::mesh;

/// World to clip space of a spot light over the origin.
glm::mat4 spot_above(const clip_space& clip) {
    const auto light = make_spot_light<float>(
        {.position = {0, 0, 10}, .direction = {0, 0, -1}, .z_near = 1, .z_far = 30, .clip = clip});
    return light.projection * light.view;
}

mesh mesh_of(fuzz::input& in, int most) {
    const bool any = in.chance(4);
    mesh m{std::vector<glm::vec3>(static_cast<std::size_t>(in.within(1, 12))),
           std::vector<glm::uvec3>(static_cast<std::size_t>(in.within(0, most)))};
    for (glm::vec3& p : m.positions)
        p = any ? in.vec3(-8, 8) : glm::vec3(in.tame(-8, 8), in.tame(-8, 8), in.tame(-8, 8));
    const int last = static_cast<int>(m.positions.size()) - (in.chance(32) ? 0 : 1);
    for (glm::uvec3& t : m.triangles)
        for (glm::length_t i = 0; i < 3; ++i) t[i] = static_cast<unsigned>(in.within(0, last));
    return m;
}

/// Twice the surface, as a vector and as a length, and room for the rounding of vertices that cut its edges.
struct surface {
    glm::dvec3 vector{0};
    double area = 0, room = 0;

    explicit surface(const mesh_view& of) {
        for (const glm::uvec3& t : of.triangles) {
            const glm::dvec3 a(of.positions[t.x]), b(of.positions[t.y]), c(of.positions[t.z]);
            const glm::dvec3 normal = glm::cross(b - a, c - a);
            const double distance = std::max({glm::length(a), glm::length(b), glm::length(c)});
            vector += normal, area += glm::length(normal), room += 1e-6 * distance * distance;
        }
    }
};

void tessellations(fuzz::input& in) {
    const mesh m = mesh_of(in, 3);
    const tessellation to{.position = in.vec3(-8, 8),
                          .angle = in.number(0.2f, 3),
                          .range = in.number(5, 30),
                          .depth_error = in.number(1.0f / 256, 0.5f)};
    const float error = to.depth_error * to.range;
    if ((to.angle > 0 && to.angle < 0.1f) || (error > 0 && error < 1.0f / 256)) return;  // cuts without number
    const tessellated_mesh cut = tessellate(m.view(), to);
    fuzz::must(std::memcmp(m.positions.data(), cut.positions.data(), m.positions.size() * sizeof(glm::vec3)) == 0,
               "a mesh keeps its own positions, before new ones");
    const surface before(m.view()), after(cut.view());
    const double room = 1e-4 * (before.area + 1) + before.room;
    if (!is_finite(before.area)) return;
    fuzz::must(std::abs(before.area - after.area) <= room && glm::length(before.vector - after.vector) <= room,
               "a tessellation is the same surface");
    const glm::dvec3 light(to.position);
    for (const glm::uvec3& t : cut.triangles) {
        double nearest = std::numeric_limits<double>::infinity();
        for (glm::length_t i = 0; i < 3; ++i)
            nearest = std::min(nearest, glm::distance(glm::dvec3(cut.positions[t[i]]), light));
        // closer to the light, rounding may move the cut of an edge by 1/8 of its way: the triangle stays
        if (nearest < 2e-5 * glm::length(light)) continue;
        for (glm::length_t i = 0; i < 3; ++i) {
            const glm::dvec3 a = glm::dvec3(cut.positions[t[i]]) - light,
                             b = glm::dvec3(cut.positions[t[(i + 1) % 3]]) - light;
            const double p = glm::length(a), q = glm::length(b);
            const double from_origin = glm::length(a + light) + glm::length(b + light);
            if (std::max(p, q) < double(to.depth_error) * double(to.range) ||
                glm::distance(a, b) < 1e-5 * (1 + p + q + from_origin))
                continue;
            fuzz::must(glm::dot(a, b) / (p * q) > std::cos(std::min(double(to.angle), 3.0)) - 1e-5,
                       "no edge is seen under a larger angle");
        }
    }
}

void culling(fuzz::input& in) {
    const mesh m = mesh_of(in, 8);
    const clip_space clip = in.clip();
    const glm::mat4 to_clip = spot_above(clip);
    std::vector<glm::mat4> places(static_cast<std::size_t>(in.within(0, 4)), glm::mat4(1));
    for (glm::mat4& place : places) place[3] = glm::vec4(in.vec3(-60, 60), 1), place[0][0] = in.number(-3, 3);
    const bounding_box<float> box = bounds_of(m.view());
    for (const glm::vec3& p : m.positions)
        if (detail::all_finite(p))
            for (glm::length_t i = 0; i < 3; ++i)
                fuzz::must(p[i] >= box.low[i] && p[i] <= box.high[i], "a mesh lies within its bounds");
    const auto at_near = in.chance(2) ? near_plane::clips : near_plane::clamps;
    const glm::ivec2 size(in.within(1, 60), in.within(1, 60));
    image<float> all(size, cleared_depth(clip)), kept = all, one_by_one = all;
    rasterize_depth(all, m.view(), places, to_clip, clip, cull_mode::none, fuzz::pieces(in), at_near);
    rasterize_depth(kept, m.view(), instances_in_map(box, places, to_clip, clip, at_near), to_clip, clip,
                    cull_mode::none, serial{}, at_near);
    fuzz::must(std::ranges::equal(all.texels(), kept.texels()), "an instance that is culled draws nothing");
    for (const glm::mat4& place : places)
        rasterize_depth(one_by_one, m.view(), model_to_clip(to_clip, place), clip, cull_mode::none, serial{}, at_near);
    fuzz::must(std::ranges::equal(all.texels(), one_by_one.texels()), "instances are passes of their own");
}

void camera_passes(fuzz::input& in) {
    const mesh m = mesh_of(in, 8);
    const clip_space clip = in.clip();
    const glm::mat4 to_clip = spot_above(clip);
    const glm::ivec2 size(in.within(1, 60), in.within(1, 60));
    const auto cull = static_cast<cull_mode>(in.within(0, 2));
    const bool forward = clip.direction == depth_direction::forward;
    image<float> depth(size, cleared_depth(clip)), seen = depth;
    image<unsigned> visible(size, ~0u);
    rasterize_depth(depth, m.view(), to_clip, clip, cull);
    rasterize(
        size, m.view(), to_clip, clip,
        [&](glm::ivec2 texel, float z, unsigned triangle) {
            fuzz::must(inside_map(size, texel) && triangle < m.triangles.size(), "a sample lies within the image");
            if (forward ? z <= seen[texel] : z >= seen[texel]) seen[texel] = z, visible[texel] = triangle;
        },
        cull);
    fuzz::must(std::ranges::equal(depth.texels(), seen.texels()), "a camera pass sees the depth pass' depths");
    for (glm::ivec2 p(0); p.y < size.y; ++p.y)
        for (p.x = 0; p.x < size.x; ++p.x) {
            if (visible[p] == ~0u) continue;
            const glm::vec3 weights = barycentrics(size, m.view(), to_clip, clip, p, visible[p]);
            fuzz::must(detail::all_finite(weights) && std::abs(weights.x + weights.y + weights.z - 1) < 1e-3f,
                       "a covered sample's weights sum to 1");
        }
}

void maps_of_points(fuzz::input& in) {
    const mesh m = mesh_of(in, 8);
    const clip_space clip = in.clip();
    const int side = in.within(0, 64);
    const auto in_range = [](const image<float>& depths) {
        for (const float d : depths.texels()) fuzz::must(d >= 0.0f && d <= 1.0f, "a depth lies within 0 and 1");
    };
    image<float> once(glm::ivec2(side), cleared_depth(clip)), again = once;
    if (in.chance(2)) {
        const auto light = make_dual_paraboloid_light<float>({.position = in.vec3(-8, 8),
                                                              .range = in.number(1, 30),
                                                              .map_size = side,
                                                              .border = in.within(0, 4),
                                                              .clip = clip});
        const int map = in.within(0, 1);
        rasterize_dual_paraboloid(once, m.view(), light, map);
        rasterize_dual_paraboloid(again, m.view(), light, map, fuzz::pieces(in));
    } else {
        const auto faces = make_tetrahedron_light(tetrahedron_light<float>{.position = in.vec3(-8, 8),
                                                                           .z_near = in.number(0.1f, 1),
                                                                           .z_far = in.number(2, 30),
                                                                           .map_size = side,
                                                                           .border = in.within(0, 4),
                                                                           .clip = clip});
        rasterize_tetrahedron(once, m.view(), faces);
        rasterize_tetrahedron(again, m.view(), faces, cull_mode::none, fuzz::pieces(in));
    }
    in_range(once);
    fuzz::must(std::ranges::equal(once.texels(), again.texels()), "no pieces change a depth");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzz::input in(bytes, size);
    static constexpr std::array all{tessellations, culling, camera_passes, maps_of_points};
    const auto& one = all[in.bits() % all.size()];
    fuzz::answered([&] { one(in); });
    return 0;
}
