// SPDX-License-Identifier: MIT
//
// Exhibits: where filters sample, what they weigh, how they compare.
#include "museum.hpp"

#include <array>
#include <cstdint>

#include <umbrage/depth/conversions.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>

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
    return compare(receiver, bilinear(i.x, i.y, f.x, f.y, [](float x, float y) {
                       return stored_depth({int(x), int(y)});
                   }));
}
float without_half_texel(vec2 coord) {
    const vec2 i = glm::floor(coord), f = coord - i;
    return bilinear(i.x, i.y, f.x, f.y, [](float x, float y) { return float(lit(x, y)); });
}
float ours(vec2 coord) { return pcf_2x2(stored_depth, coord, receiver); }

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
    {"Depths filtered, then compared",
     "samplers with linear filter on a depth map; Reeves, Salesin and Cook warn of it in 1987",
     "The mean of an occluder and a background is a depth without a surface. Edges move, and stay hard.",
     "receiver <= bilinear(depths)", "2^18 receivers, visibility more than 1/256 off", "visibility",
     "`pcf_2x2` compares four depths and mixes the answers", [] { return visibilities(compare_filtered_depth); },
     [] { return visibilities(ours); }},
    {"The missing half texel", "ports of Direct3D 9 filters, whose pixel centers were integers",
     "Weights and taps belong to the next texel, up and right. The shadow moves by half a texel.",
     "i = floor(uv N), f = fract(uv N)", "2^18 receivers, visibility more than 1/256 off", "visibility",
     "`pcf_2x2` subtracts the half texel, as its first texel center is (0.5, 0.5)",
     [] { return visibilities(without_half_texel); }, [] { return visibilities(ours); }},
    {"Sampling at texel corners", "lygia's bilinear shadow filter",
     "floor(uv N + 1/2) / N is a corner between texels. The last bit decides which texel a nearest filter reads.",
     "texture2D(map, floor(uv * N + 0.5) / N)",
     "texel centers of maps of 1 to 512 texels, an ulp less fetches another texel", "texels",
     "coordinates in texels, one `floor`, integer texel numbers",
     [] { return an_ulp_less([](float uv, float size) { return std::floor(uv * size + 0.5f) / size; }, true); },
     [] { return an_ulp_less([](float uv, float size) { return uv * size; }, false); }},
    {"Taps and weights from two roundings",
     "manual 2x2 filters that sample at uv and weight by fract(uv N - 1/2); mrdoob/three.js#33534",
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
    {"Reversed Z, comparison kept", "mrdoob/three.js#29770 and seven threads after it, Babylon.js#17315",
     "Near is 1 now. Receivers behind the occluder are lit, and those in front of it are dark.", "receiver <= stored",
     "2^18 pairs of reversed depths, the wrong answer", "visibility",
     "`greater_equal` is an argument of every filter, `direction` of every binding",
     [] { return reversed_pairs([](float d, float s) { return compare(d, s); }); },
     [] { return reversed_pairs([](float d, float s) { return compare(d, s, greater_equal{}); }); }},
    {"Reversed Z, bias kept", "the same threads",
     "A bias that moved the receiver towards the light moves it away. Every surface shadows itself.",
     "receiver - bias >= stored", "surfaces against themselves, 3 steps of 16 bits off, bias 4 steps: in shadow",
     "visibility", "after `reverse_depth` every sign is that of forward depth",
     [] { return reversed_surface([](float d, float s) { return compare(d - bias, s, greater_equal{}); }); },
     [] {
         return reversed_surface([](float d, float s) { return compare(reverse_depth(d) - bias, reverse_depth(s)); });
     }},
};

}  // namespace

std::span<const exhibit> filters() { return all; }
