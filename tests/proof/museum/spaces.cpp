// SPDX-License-Identifier: MIT
//
// Exhibits: matrices, projections, conventions.
#include "museum.hpp"

#include <array>
#include <cmath>

#include <glm/ext/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <umbrage/bias/acne_free.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

namespace {

using namespace umbrage;
using glm::mat4;
using glm::vec2;
using glm::vec3;
using glm::vec4;

constexpr glm::ivec2 map_size{1024, 1024};
const vec3 position(2.0f, 9.0f, 4.0f);
const vec3 direction(-2.0f, -9.0f, -4.0f);

light_space<float> spot(clip_space clip) {
    return make_spot_light<float>({.position = position,
                                   .direction = direction,
                                   .outer_angle_radians = 0.5f,
                                   .z_near = 1.0f,
                                   .z_far = 20.0f,
                                   .clip = clip});
}

// Points of a grid around the light's target; `side` 1 in front of the light, -1 mirrored behind it.
template <class Visit>
void points(Visit visit, float side = 1.0f) {
    for (int i = 0; i < 24 * 24 * 24; ++i) {
        const vec3 p = vec3(i % 24, i / 24 % 24, i / 576) / 12.0f - 1.0f;
        visit(side > 0.0f ? p : 2.0f * position - p);
    }
}
double distance(vec3 a, vec3 b) { return glm::length(glm::dvec3(a) - glm::dvec3(b)); }

// Texels and depth of a point, from the projection in double, conventions spelled out once more.
vec3 truth(const light_space<float>& light, vec3 p) {
    const glm::dvec4 c = glm::dmat4(light.projection) * (glm::dmat4(light.view) * glm::dvec4(p, 1.0));
    const glm::dvec3 ndc = glm::dvec3(c) / c.w;
    const double y = light.clip.origin == texture_origin::top ? -ndc.y : ndc.y;
    const double z = light.clip.range == depth_range::minus_one_to_one ? ndc.z * 0.5 + 0.5 : ndc.z;
    return vec3((ndc.x * 0.5 + 0.5) * map_size.x, (y * 0.5 + 0.5) * map_size.y, z);
}
// Errors of projected points, in texels. The map stores clamped depth, and `depth` counts it in units of 1/1024.
template <class Land>
score landings(clip_space clip, Land land) {
    const light_space<float> light = spot(clip);
    score s;
    points([&](vec3 p) {
        vec3 here = land(light, p), there = truth(light, p);
        here.z = saturate(here.z) * 1024.0f;
        there.z *= 1024.0f;
        s.add(distance(here, there), 0.01);
    });
    return s;
}
vec3 ours(const light_space<float>& light, vec3 p) {
    return project_coordinate(shadow_coordinate(texture_matrix(light, map_size), p));
}
vec3 transposed(const light_space<float>& light, vec3 p) {
    const vec4 c = glm::transpose(texture_matrix(light, map_size)) * vec4(p, 1.0f);
    return vec3(c.x / c.w, c.y / c.w, c.z / c.w);
}
// x and y to [0, 1], and z left as the projection gave it.
vec3 z_as_it_is(const light_space<float>& light, vec3 p) {
    const vec4 c = light.projection * light.view * vec4(p, 1.0f);
    const vec3 ndc(c.x / c.w, c.y / c.w, c.z / c.w);
    return vec3((ndc.x * 0.5f + 0.5f) * 1024.0f, (ndc.y * 0.5f + 0.5f) * 1024.0f, ndc.z);
}
// A [0, 1] projection, and z halved and raised all the same.
vec3 z_halved_twice(const light_space<float>& light, vec3 p) {
    const vec3 c = z_as_it_is(light, p);
    return vec3(c.x, c.y, c.z * 0.5f + 0.5f);
}

// Four taps half a texel around every point.
template <class Tap>
score taps(Tap tap) {
    const light_space<float> light = spot(vulkan_clip_space);
    const mat4 m = texture_matrix(light, map_size);
    score s;
    points([&](vec3 p) {
        const vec4 c = shadow_coordinate(m, p);
        for (const vec2 offset : default_taps<float>)
            s.add(distance(tap(c, offset), truth(light, p) + vec3(offset, 0.0f)), 0.01);
    });
    return s;
}

// Lights along the axes and close to them, up = +y: how far the view is from a rotation.
template <class View>
score directions(View view) {
    score s;
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {1.0f, -1.0f})
            for (const float tilt : {0.0f, 1e-3f, 0.1f}) {
                vec3 d(0.0f);
                d[axis] = sign;
                d[(axis + 1) % 3] = tilt;
                const glm::mat3 r(view(d));
                const glm::mat3 should_be_one = r * glm::transpose(r);
                double error = 0.0;
                for (int i = 0; i < 9; ++i) {
                    const double e = std::abs(double(should_be_one[i / 3][i % 3]) - (i % 4 == 0 ? 1.0 : 0.0));
                    error = std::isnan(e) || e > error ? e : error;
                    if (std::isnan(error)) break;
                }
                s.add(error, 1e-5);
            }
    return s;
}

// Points behind a spot light over a map that nothing was drawn to: all lit.
template <class Project, class Compare = less_equal>
score behind(Project project, Compare is_lit = {}) {
    const mat4 m = texture_matrix(spot(vulkan_clip_space), map_size);
    score s;
    points(
        [&](vec3 p) {
            const vec3 c = project(shadow_coordinate(m, p));
            s.add(double(hard([](glm::ivec2) { return 1.0f; }, vec2(c.x, c.y), c.z, is_lit)) - 1.0, 0.0);
        },
        -1.0f);
    return s;
}

// Ground under a sun of 52 degrees, in four cascades: how far casters stand above it along the light, 0.5 to 2 m.
struct slice {
    float range, texel;  // of depths, and of a texel, in meters
};
template <class Bias>
score casters(Bias bias) {
    score s;
    for (const slice cascade : {slice{404, 0.01f}, slice{448, 0.03f}, slice{665, 0.1f}, slice{1300, 0.3f}})
        for (int k = 50; k <= 200; ++k) {
            const float stored = 0.5f - float(k) / 100.0f / cascade.range;
            s.add(double(compare(0.5f - bias(cascade), stored)), 0.0);
        }
    return s;
}
float one_for_all(slice) { return 0.005f; }
float of_the_slope(slice cascade) {
    const float slope = 0.78f * cascade.texel / cascade.range;  // depth per texel
    return acne_free_bias(vec2(slope, 0.0f), filters::pcf_2x2{}.reach(), 0.0f);
}

// Planes at 10 to 80 degrees to the light, turned to all sides, under texels of 0.8 by 0.1 m: how many times the least
// bias for the nearest texel is taken. Below once is acne.
template <class Bias>
score long_texels(Bias bias) {
    constexpr float range = 100.0f;
    const vec2 texel(0.8f, 0.1f);
    score s;
    for (int degrees = 10; degrees <= 80; ++degrees)
        for (int turn = 0; turn < 360; ++turn) {
            const float tilt = glm::radians(float(degrees)), side = glm::radians(float(turn));
            const vec2 slope = vec2(std::cos(side), std::sin(side)) * std::tan(tilt);  // meters per meter
            const double smallest = 0.5 * (std::abs(slope.x * texel.x) + std::abs(slope.y * texel.y)) / range;
            const double times = double(bias(tilt, slope * texel / range, texel, range)) / smallest;
            s.add(times < 1.0 ? double(HUGE_VAL) : times, 4.0);
        }
    return s;
}
float along_the_normal(float tilt, vec2, vec2 texel, float range) {
    return std::sin(tilt) * std::fmax(texel.x, texel.y) / std::cos(tilt) / range;
}
float along_the_slope(float, vec2 slope, vec2, float) { return acne_free_bias(slope, 0.5f, 0.0f); }

const exhibit all[] = {
    {"The shadow lands anywhere: row or column",
     "every port between Direct3D's row vectors and OpenGL's column vectors",
     "The shader gets the transposed matrix. Every point lands in a wrong place.", "transpose(M) * vec4(world, 1)",
     "13824 points, more than 1/100 texel (or 1/100 of 1/1024 depth) off", "texels",
     "all matrices have GLM's columns. Only `shadow_coordinate` multiplies",
     [] { return landings(vulkan_clip_space, transposed); }, [] { return landings(vulkan_clip_space, ours); }},
    {"Too little is dark: z of [-1, 1] as it is",
     "programs mixing GLM_FORCE_DEPTH_ZERO_TO_ONE with OpenGL's default clip space",
     "Receivers and occluders have different scales. The nearer part of the range, below 0, is stored as 0.",
     "xy / 2 + 1 / 2, z as it is",
     "13824 points under an OpenGL projection, more than 1/100 texel (or 1/100 of 1/1024 depth) off", "1/1024 depth",
     "`clip_space` is an argument and a member. `texture_matrix` reads it",
     [] { return landings(opengl_clip_space, z_as_it_is); }, [] { return landings(opengl_clip_space, ours); }},
    {"Too much is dark: z of [0, 1] halved again", "the same programs, with the opposite mistake",
     "Half of the range is gone. Receivers and occluders have different scales.", "xyz / 2 + 1 / 2",
     "13824 points under a Vulkan projection, more than 1/100 texel (or 1/100 of 1/1024 depth) off", "1/1024 depth",
     "`clip_space` says which range z has", [] { return landings(vulkan_clip_space, z_halved_twice); },
     [] { return landings(vulkan_clip_space, ours); }},
    {"The shadow is upside down",
     "maps of Direct3D, Metal and WebGPU read with OpenGL's texture matrix: TrussC-org/TrussC#198",
     "The first row is at the top, so the shadow is mirrored.", "y / 2 + 1 / 2",
     "13824 points under a Direct3D projection, more than 1/100 texel off", "texels",
     "`texture_origin` is part of `clip_space`", [] { return landings(direct3d_clip_space, z_as_it_is); },
     [] { return landings(direct3d_clip_space, ours); }},
    {"Taps close up as the light moves away", "four-tap filters that move projective coordinates",
     "The division by w also divides an offset that was added before. Taps move closer as the light moves away.",
     "(x + offset.x, y + offset.y, z, w), then divide", "13824 points, 4 taps each, more than 1/100 texel off",
     "texels", "`tap_coordinate` and `tap_matrices` scale the offset by w",
     [] { return taps([](vec4 c, vec2 o) { return project_coordinate(vec4(c.x + o.x, c.y + o.y, c.z, c.w)); }); },
     [] { return taps([](vec4 c, vec2 o) { return project_coordinate(tap_coordinate(c, o)); }); }},
    {"A light straight down shows nothing",
     "look-at with a fixed up vector, such as filament's cube faces at +y and -y",
     "direction x up is zero. Its normal is NaN, so the view is NaN too.",
     "lookAt(position, position + direction, (0, 1, 0))",
     "18 directions on and near the axes, view more than 1e-5 from a rotation", "matrix elements",
     "`look_along` takes another axis if the hint is parallel or nearly so",
     [] { return directions([](vec3 d) { return glm::lookAtRH(position, position + d, vec3(0.0f, 1.0f, 0.0f)); }); },
     [] {
         return directions([](vec3 d) { return look_along(position, d, vec3(0.0f, 1.0f, 0.0f), handedness::right); });
     }},
    {"Points behind the light are dark", "projective texturing without a test of w",
     "Points behind a spot light divide by a negative w. They land on the map upside down, beyond its far plane.",
     "(x, y, z) / w", "13824 points behind the light, an empty map, in shadow", "visibility",
     "`project_coordinate` moves points with w <= 0 out of texel space, where every filter returns lit",
     [] {  // compared as it comes: our filters light what is beyond the far plane
         return behind([](vec4 c) { return vec3(c.x / c.w, c.y / c.w, c.z / c.w); }, less_equal_scaled{});
     },
     [] { return behind(project_coordinate<float>); }},
    {"The shadow begins meters beside its caster",
     "drsnuggles8/OloEngineBase#1119 and drsnuggles8/OloEngineBase#1137, red1oon/bim-ootb#1302",
     "A bias in depth has the length of its share of the range: 2 m of 404 m, and 6.5 m of 1300 m.",
     "receiver - 0.005 <= stored", "casters 0.5 to 2 m above the ground in four cascades, the ground under them lit",
     "visibility", "`acne_free_bias` follows slope, texel and range. It is at most 0.24 m in these",
     [] { return casters(one_for_all); }, [] { return casters(of_the_slope); }},
    {"The shadow detaches where texels are long", "google/filament#9734",
     "The offset along the normal takes the longer side of a texel, whichever way the surface faces.",
     "n sin(theta) max(width, height)", "planes of all directions, a bias above 4 times the smallest", "times",
     "`acne_free_bias` adds the slopes along both sides", [] { return long_texels(along_the_normal); },
     [] { return long_texels(along_the_slope); }},
};

}  // namespace

std::span<const exhibit> spaces() { return all; }
