// SPDX-License-Identifier: MIT
//
// Exhibits: where filters sample, what they weigh, how they compare.
#include "museum.hpp"

#include <array>
#include <cstdint>

#include <umbrage/depth/conversions.hpp>
#include <glm/geometric.hpp>

#include <umbrage/filter/pcf/disc.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/filter/prefiltered/look_up.hpp>

namespace {

using namespace umbrage;
using glm::ivec2;
using glm::vec2;

constexpr float receiver = 0.5f;

// An endless map whose texels are nearer or farther than the receiver, by a hash.
float stored_depth(ivec2 t) {
    std::uint32_t h = std::uint32_t(t.x) * 0x9E3779B1u ^ std::uint32_t(t.y) * 0x85EBCA77u;
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    return (h >> 16) & 1 ? 0.9f : 0.2f;
}
float stored_value(float x, float y) { return stored_depth({int(x), int(y)}); }
double lit(double x, double y) { return compare(receiver, stored_depth({int(x), int(y)})); }

// Four values around a point between texel centers, mixed: the same formula for depths and for tests of them.
template <class T, class Value>
T bilinear(T x, T y, T fx, T fy, Value value) {
    return (value(x, y) * (T(1) - fx) + value(x + T(1), y) * fx) * (T(1) - fy) +
           (value(x, y + T(1)) * (T(1) - fx) + value(x + T(1), y + T(1)) * fx) * fy;
}
// The visibility at a point in texels, in double.
double truth(double x, double y) {
    const double i = std::floor(x - 0.5), j = std::floor(y - 0.5);
    return bilinear(i, j, x - 0.5 - i, y - 0.5 - j, lit);
}

// Receivers all over an 8 x 8 piece, on multiples of 1/64 texel.
template <class Filter>
score visibilities(Filter filter) {
    score s;
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; ++x) {
            const vec2 coord = vec2(x, y) / 64.0f;
            s.add(double(filter(coord)) - truth(coord.x, coord.y), 1.0 / 256.0);
        }
    return s;
}
float compare_filtered_depth(vec2 coord) {
    const vec2 i = glm::floor(coord - 0.5f), f = coord - 0.5f - i;
    return compare(receiver, bilinear(i.x, i.y, f.x, f.y, stored_value));
}
float without_half_texel(vec2 coord) {
    const vec2 i = glm::floor(coord), f = coord - i;
    return bilinear(i.x, i.y, f.x, f.y, [](float x, float y) { return float(lit(x, y)); });
}
float next_texel(vec2 coord) {
    const vec2 corner = glm::floor(coord + 0.5f),
               f = coord + 0.5f - corner;  // a nearest sampler reads that texel there
    return bilinear(corner.x, corner.y, f.x, f.y, [](float x, float y) { return float(lit(x, y)); });
}
float ours(vec2 coord) { return pcf_2x2(stored_depth, coord, receiver); }

// Means of four stored values, for a map that the sampler does not filter.
template <class Mean>
score means(Mean mean) {
    score s;
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 512; ++x) {
            const vec2 coord = vec2(x, y) / 64.0f, at = coord - 0.5f, i = glm::floor(at), f = at - i;
            s.add(double(mean(coord)) - double(bilinear(i.x, i.y, f.x, f.y, stored_value)), 1.0 / 256.0);
        }
    return s;
}
float mean_a_whole_texel_back(vec2 coord) {
    const vec2 i = glm::floor(coord - 1.0f), f = coord - 1.0f - i;
    return bilinear(i.x, i.y, f.x, f.y, stored_value);
}

// Receivers beyond the far plane, before a map of floats that nothing was drawn to.
template <class Filter>
score beyond_the_far_plane(Filter filter) {
    score s;
    for (int k = 1; k <= 65536; ++k) s.add(double(filter(1.0f + float(k) / 65536.0f)) - 1.0, 0.0);
    return s;
}

// Pixels of a close-up, 128 in a texel: by how many turns the rotations of neighbors are closer than an eighth.
template <class Rotation>
score neighbors(Rotation rotation) {
    score s;
    for (int y = 0; y < 256; ++y)
        for (int x = 0; x < 256; ++x) {
            const vec2 a = rotation(vec2(x, y)), b = rotation(vec2(x + 1, y));
            const double apart = std::acos(double(glm::dot(a, b)) / double(glm::length(a) * glm::length(b)));
            s.add(std::fmax(0.125 - apart / 6.283185307179586, 0.0), 0.0);
        }
    return s;
}
vec2 noise_of_the_texel(vec2 pixel) {
    const vec2 texel = pixel / 128.0f;
    const auto fraction = [](float v) { return v - std::floor(v); };
    const float turn = fraction(52.9829189f * fraction(0.06711056f * texel.x + 0.00583715f * texel.y));
    return {std::cos(6.2831853f * turn), std::sin(6.2831853f * turn)};
}

// Every texel center of maps of 1 to 512 texels: does an ulp less fetch another texel?
template <class Coordinate>
score an_ulp_less(Coordinate coordinate, bool normalized) {
    score s;
    for (int size = 1; size <= 512; ++size)
        for (int i = 0; i < size; ++i) {
            const float at = coordinate((float(i) + 0.5f) / float(size), float(size));
            const auto texel = [&](float c) {
                float taken = 0.0f;
                (void)hard([&](ivec2 t) { return taken = float(t.x); }, vec2(normalized ? c * float(size) : c, 0.5f),
                           receiver);
                return taken;
            };
            s.add(texel(at) - texel(std::nextafter(at, 0.0f)), 0.0);
        }
    return s;
}

// One row of a map of `size` texels, coordinates in [0, 1] within 8 ulp of every texel center.
template <class Filter>
score beside_centers(Filter filter) {
    score s;
    for (const int size : {640, 1000, 1023, 2047})
        for (int i = 1; i < size - 1; ++i)
            for (int ulp = -8; ulp <= 8; ++ulp) {
                float uv = (float(i) + 0.5f) / float(size);
                for (int n = 0; n < std::abs(ulp); ++n) uv = std::nextafter(uv, ulp < 0 ? 0.0f : 1.0f);
                s.add(double(filter(uv, float(size))) - truth(double(uv) * size, 0.5), 1.0 / 16.0);
            }
    return s;
}

// Pairs of distances to an occluder and a receiver, as reversed depths.
constexpr int distances = 512;
float reversed(int distance) { return 1.0f - float(distance) / float(distances); }
template <class Test>
score reversed_pairs(Test test) {
    score s;
    for (int occluder = 0; occluder < distances; ++occluder)
        for (int distance = 0; distance < distances; ++distance)
            s.add(double(test(reversed(distance), reversed(occluder))) - (distance <= occluder ? 1.0 : 0.0), 0.0);
    return s;
}
// A surface against the depth that the map holds of itself, off by up to 3 steps of 16 bits, with a bias of 4.
constexpr float bias = 4.0f / 65536.0f;
template <class Test>
score reversed_surface(Test test) {
    score s;
    for (int k = 64; k < 65536 - 64; ++k)
        for (int off = -3; off <= 3; ++off)
            s.add(double(test(float(k) / 65536.0f, float(k + off) / 65536.0f)) - 1.0, 0.0);
    return s;
}

const exhibit all[] = {
    {"Shadow edges move, and stay hard",
     "samplers with linear filter on a depth map. Reeves, Salesin and Cook warned of it in 1987",
     "The mean of an occluder and a background is a depth without a surface. Edges move, and stay hard.",
     "receiver <= bilinear(depths)", "2^18 receivers, visibility more than 1/256 off", "visibility",
     "`pcf_2x2` compares four depths and mixes the answers", [] { return visibilities(compare_filtered_depth); },
     [] { return visibilities(ours); }},
    {"The shadow is half a texel off", "ports of Direct3D 9 filters, whose pixel centers were integers",
     "Weights and taps belong to the next texel, up and right. The shadow moves by half a texel.",
     "i = floor(uv N), f = fract(uv N)", "2^18 receivers, visibility more than 1/256 off", "visibility",
     "`pcf_2x2` subtracts the half texel, as its first texel center is (0.5, 0.5)",
     [] { return visibilities(without_half_texel); }, [] { return visibilities(ours); }},
    {"The shadow is a texel off",
     "lygia 1.4.1, sample/shadowLerp.glsl, and three.js' texture2DShadowLerp, as printed in mrdoob/three.js#13526",
     "The four taps begin at the nearest corner, with the weights of the texels before it. The shadow moves by a "
     "texel.",
     "i = floor(uv N + 1/2), f = fract(uv N + 1/2)", "2^18 receivers, visibility more than 1/256 off", "visibility",
     "`pcf_2x2` begins at floor(coord - 1/2)", [] { return visibilities(next_texel); },
     [] { return visibilities(ours); }},
    {"The blurred shadow is half a texel off", "PlayCanvas 2.23.3, shadowEVSM.js, where float textures do not filter",
     "A whole texel is subtracted where half of one puts the weights between centers.", "uv - 1 / N; f = fract(uv N)",
     "2^18 lookups, stored value more than 1/256 off", "depth",
     "`fetch_bilinear` subtracts half a texel, in the steps of its weights",
     [] { return means(mean_a_whole_texel_back); },
     [] { return means([](vec2 coord) { return fetch_bilinear(stored_depth, coord); }); }},
    {"The last bit decides which texel is read", "lygia's bilinear shadow filter",
     "floor(uv N + 1/2) / N is a corner between texels. The last bit decides which texel a nearest filter reads.",
     "texture2D(map, floor(uv * N + 0.5) / N)",
     "texel centers of maps of 1 to 512 texels, an ulp less fetches another texel", "texels",
     "coordinates are in texels. One `floor` gives integer texel numbers",
     [] { return an_ulp_less([](float uv, float size) { return std::floor(uv * size + 0.5f) / size; }, true); },
     [] { return an_ulp_less([](float uv, float size) { return uv * size; }, false); }},
    {"Single texels flip along an edge",
     "manual 2x2 filters that sample at uv and weight by fract(uv N - 1/2): mrdoob/three.js#33534",
     "The sampler is at the next texel, but the weight is not. A whole texel flips.",
     "taps at floor((uv - .5/N) N), weights fract(uv N - .5)",
     "coordinates within 8 ulp of texel centers, visibility more than 1/16 off", "visibility",
     "`pcf_2x2` takes texel and weight from the same integer",
     [] {
         return beside_centers([](float uv, float size) {
             const float i = std::floor((uv - 0.5f / size) * size), x = uv * size - 0.5f, f = x - std::floor(x);
             return bilinear(i, 0.0f, f, 0.0f, [](float u, float v) { return float(lit(u, v)); });
         });
     },
     [] { return beside_centers([](float uv, float size) { return ours(vec2(uv * size, 0.5f)); }); }},
    {"Light and shadow are swapped: reversed Z",
     "mrdoob/three.js#29770 and seven threads after it, BabylonJS/Babylon.js#17315",
     "The near plane now has depth 1. Receivers behind the occluder are lit. Those in front of it are dark.",
     "receiver <= stored", "2^18 pairs of reversed depths, the wrong answer", "visibility",
     "every filter takes `greater_equal`, and every binding a `direction`",
     [] { return reversed_pairs([](float d, float s) { return compare(d, s); }); },
     [] { return reversed_pairs([](float d, float s) { return compare(d, s, greater_equal{}); }); }},
    {"Every surface shadows itself: reversed Z", "mrdoob/three.js#29770, BabylonJS/Babylon.js#17315",
     "A bias that moved the receiver towards the light moves it away. Every surface shadows itself.",
     "receiver - bias >= stored", "surfaces against themselves, 3 steps of 16 bits off, bias 4 steps: in shadow",
     "visibility", "after `reverse_depth` every sign is that of forward depth",
     [] { return reversed_surface([](float d, float s) { return compare(d - bias, s, greater_equal{}); }); },
     [] {
         return reversed_surface([](float d, float s) { return compare(reverse_depth(d) - bias, reverse_depth(s)); });
     }},
    {"The ground beyond the far plane is dark", "mrdoob/three.js#32547: a depth texture of floats clamps no reference",
     "A receiver slightly beyond 1 is compared with the cleared depth 1.", "receiver <= stored",
     "receivers beyond the far plane, an empty map, in shadow", "visibility", "`hard`, as every filter, lights them",
     [] { return beyond_the_far_plane([](float d) { return compare(d, 1.0f); }); },
     [] { return beyond_the_far_plane([](float d) { return hard([](ivec2) { return 1.0f; }, vec2(0.5f), d); }); }},
    {"Close to it, a noisy edge turns into stripes", "bevyengine/bevy#22400",
     "Noise of a position in the map changes slowly from pixel to pixel. So neighbors rotate their taps alike.",
     "turn = interleaved gradient noise(uv N)", "pixels, rotated by less than an eighth of a turn from their neighbor",
     "turns", "`disc_rotation` takes the pixel, so neighbors in a row are a quarter turn apart",
     [] { return neighbors(noise_of_the_texel); },
     [] {
         return neighbors([](vec2 p) {
             const glm::vec4 turned = umbrage::disc_rotation(p);
             return vec2(turned.x, turned.z);
         });
     }},
};

}  // namespace

std::span<const exhibit> filters() { return all; }
