// SPDX-License-Identifier: MIT
#include "model.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <glm/common.hpp>
#include <glm/mat2x2.hpp>

#include "../numbers.hpp"

namespace check {
namespace {

using glm::ivec2;
using glm::vec2;
using glm::vec4;

/// The next float towards -infinity. std::nextafter sets flags that WebAssembly lacks.
float below(float v) {
    const auto bits = glm::floatBitsToInt(v);
    if (v == 0.0f) return -0x1p-126f;  // a denormal may act as zero
    return glm::intBitsToFloat(v > 0 ? bits - 1 : bits + 1);
}

int wrapped(int i, int size) { return (i % size + size) % size; }

std::string pair(vec2 v) { return "(" + shortened(v.x) + ", " + shortened(v.y) + ")"; }

}  // namespace

std::string_view name(outside mode) {
    constexpr std::string_view names[]{"clamped to the edge", "lit, texel by texel", "repeated", "in shadow",
                                       "lit wherever the coordinate is outside"};
    return names[static_cast<std::size_t>(mode)];
}

float compare_model::result(float visibility) const {
    if (lit == 1.0f && shadow == 0.0f) return visibility;
    if (lit == 0.0f && shadow == 1.0f) return 1.0f - visibility;
    return shadow + (lit - shadow) * visibility;
}

vec2 geometry_model::operator()(vec2 coord, ivec2 size) const {
    if (plain()) return coord;
    vec2 uv = coord / vec2(size);
    if (swap_uv) std::swap(uv.x, uv.y);
    if (flip_x) uv.x = 1.0f - uv.x;
    if (flip_y) uv.y = 1.0f - uv.y;
    if (zoom == 2.0f) uv = uv * 2.0f - 1.0f;
    if (zoom == 0.5f) uv = uv * 0.5f + 0.5f;
    vec2 at = uv * vec2(size);
    if (swap_texel) std::swap(at.x, at.y);
    return at + shift;
}

vec2 geometry_model::source(vec2 place, ivec2 size) const {
    const vec2 zero = (*this)(vec2(0), size);
    const glm::mat2 axes((*this)(vec2(1, 0), size) - zero, (*this)(vec2(0, 1), size) - zero);
    return glm::inverse(axes) * (place - zero);
}

float fetched_map::operator()(ivec2 texel) const {
    const ivec2 size = map->size;
    float depth = 0;
    const bool in = texel.x >= 0 && texel.y >= 0 && texel.x < size.x && texel.y < size.y;
    if (in || mode == outside::clamped || mode == outside::repeated) {
        if (mode == outside::repeated) texel = {wrapped(texel.x, size.x), wrapped(texel.y, size.y)};
        texel = glm::clamp(texel, ivec2(0), size - 1);
        depth = map->map[static_cast<std::size_t>(texel.y * size.x + texel.x)];
    } else {
        depth = (mode == outside::dark) == reversed ? 2.0f : -1.0f;
    }
    if (reversed) depth = -depth;
    return strict ? below(depth) : depth;
}

float filter_model::operator()(const batch& b, const vec4& input) const {
    const vec2 coord(input.x, input.y), at = geometry(coord, b.size);
    const bool out = !(coord.x >= 0 && coord.y >= 0 && coord.x <= float(b.size.x) && coord.y <= float(b.size.y));
    if (mode == outside::lit_at_once && out) return compare.lit;
    const float receiver = compare.plain() ? input.z : compare.scale * input.z + compare.offset;
    const fetched_map map{&b, mode, compare.strict, compare.reversed};
    return compare.result(filter->call(map, at, compare.reversed ? -receiver : receiver));
}

bool filter_model::inside(const batch& b, const vec4& input) const {
    const vec2 at = geometry(vec2(input.x, input.y), b.size);
    const auto far_from_edges = [](float v, int size) { return v > largest_reach && v < float(size) - largest_reach; };
    return far_from_edges(at.x, b.size.x) && far_from_edges(at.y, b.size.y) && input.x >= 0 && input.y >= 0 &&
           input.x <= float(b.size.x) && input.y <= float(b.size.y);
}

std::vector<finding> filter_model::slips() const {
    std::vector<finding> all;
    const auto add = [&](bool is, const char* kind, std::string says) {
        if (is) all.push_back({kind, std::move(says)});
    };
    add(geometry.swap_uv, "swap", "x and y of the coordinate exchanged");
    add(geometry.swap_texel, "swap", "row and column of the texel exchanged");
    add(geometry.flip_x, "flip", "left and right exchanged");
    add(geometry.flip_y, "flip", "upside down");
    add(geometry.zoom == 2.0f, "uv_range", "UV in [0, 1] taken to [-1, 1]");
    add(geometry.zoom == 0.5f, "uv_range", "UV in [0, 1] taken to [0.5, 1]");
    add(geometry.shift != vec2(0), "shift", "shifted by " + pair(geometry.shift) + " texel");
    float bias = compare.offset;
    const auto range = [&](float scale, float offset, const char* kind, const char* says) {
        if (compare.scale != scale || std::abs(compare.offset - offset) > 0.2f) return;
        add(true, kind, says);
        bias = compare.offset - offset;
    };
    range(2, -1, "z_range", "receiver in [0, 1] taken to [-1, 1]");
    range(0.5f, 0.5f, "z_range", "receiver in [0, 1] taken to [0.5, 1]");
    range(-1, 1, "direction", "receiver reversed: 1 - depth");
    const bool known = compare.scale == 1 || compare.scale == 2 || compare.scale == 0.5f || compare.scale == -1;
    add(!known, "z_range", "receiver times " + shortened(compare.scale));
    add(compare.reversed, "direction", "compared as reversed depth");
    add(compare.strict, "strict",
        compare.reversed ? "> in place of >=" : "lit only if strictly nearer, < in place of <=");
    const bool wrong_sign = (bias > 0) != compare.reversed;
    add(std::abs(bias) > 0x1p-20f, "bias",
        wrong_sign ? "bias of " + shortened(std::abs(bias)) + " with the wrong sign: surfaces shadow themselves"
                   : "bias of " + shortened(std::abs(bias)));
    if (compare.lit == 0.0f && compare.shadow == 1.0f) add(true, "in_shadow", "1 in shadow, 0 lit");
    else
        add(compare.lit != 1.0f || compare.shadow != 0.0f, "levels",
            shortened(compare.lit) + " lit, " + shortened(compare.shadow) + " in shadow");
    return all;
}

bool beside(const filter_model& f, const batch& b, const vec4& input, float result) {
    constexpr float step = 1.0f / 256, level = 1.0f / 512;  // a sampler's weights have 8 bits
    float low = f(b, input), high = low;
    for (float dz : {0.0f, -0x1p-22f, 0x1p-22f}) {
        if (dz != 0 && f.compare.plain()) break;
        for (float dy : {0.0f, -step, step})
            for (float dx : {0.0f, -step, step}) {
                const float v = f(b, input + vec4(dx, dy, dz, 0));
                low = (std::min)(low, v), high = (std::max)(high, v);
            }
    }
    const float room = low == high && (low == f.compare.lit || low == f.compare.shadow) ? 2e-6f : level;
    return result >= low - room && result <= high + room;
}

}  // namespace check
