// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/look_up.hpp>

#include "windows.hpp"

namespace parity {
namespace {

/// Maps of what `encode` makes of depths, a few texels of them NaN.
template <class Encode>
std::vector<texels> maps_of(const Encode& encode) {
    std::vector<texels> maps = plain_maps({{16, 16}, {5, 3}, {1, 1}});
    for (texels& map : maps)
        for (vec4& t : map.texels()) t = encode(t.x);
    for (int c = 0; c < 4; ++c) maps[0][{c, 7}][c] = std::numeric_limits<float>::quiet_NaN();
    return maps;
}

}  // namespace

void add_filter_prefiltered_look_up(std::vector<entry>& all) {
    using namespace umbrage;
    const auto fetch = [](const sample& s) { return [view = s.map](ivec2 t) { return fetch_clamped(view, t); }; };
    const auto first = [](const sample& s) { return [view = s.map](ivec2 t) { return vec2(fetch_clamped(view, t)); }; };
    const auto add = [&all](const snippet& s, const std::string& arguments, std::vector<texels> maps,
                            std::function<vec4(const sample&, float far)> twin) {
        entry e = filter(s, arguments, {});
        e.maps = std::move(maps);
        e.share = 2;
        add_both(all, e, twin);
        e.variant = "lit outside";
        e.map_kind.outside = outside_map::bordered;
        e.share = 16;
        e.twin = [twin](const sample& one) {
            return map_covers(vec2(one.map.size), at(one)) ? twin(one, 1.0f) : vec4(1.0f);
        };
        all.push_back(std::move(e));
    };
    all.push_back({.primitive = &glsl::fetch_bilinear,
                   .classes = {{"inside",
                                [](auto, random& r, sample& s) {
                                    const vec2 size(s.map.size);
                                    s.x[0] = {r.between(-2.0f, size.x + 2.0f), r.between(-2.0f, size.y + 2.0f), 0, 0};
                                }}},
                   .twin = [fetch](const sample& s) { return fetch_bilinear(fetch(s), at(s)); },
                   .call = "umbrage_fetch_bilinear(map, map_size, vec2(x0.x, x0.y))",
                   .maps = maps_of([](float d) { return encode_evsm4(d, vec2(55.0f)); })});
    add(glsl::vsm, ", 0.0001", maps_of([](float d) { return vec4(encode_vsm(d), 0.0f, 0.0f); }),
        [first](const sample& s, float far) { return vec4(vsm(first(s), at(s), s.x[0].z, 0.0001f, far)); });
    add(glsl::esm, ", 40.0", maps_of([](float d) { return vec4(encode_esm(d, 40.0f)); }),
        [](const sample& s, float far) { return vec4(esm(s.depth(), at(s), s.x[0].z, 40.0f, far)); });
    add(glsl::evsm2, ", 40.0, 0.01", maps_of([](float d) { return vec4(encode_evsm2(d, 40.0f), 0.0f, 0.0f); }),
        [first](const sample& s, float far) { return vec4(evsm2(first(s), at(s), s.x[0].z, 40.0f, 0.01f, far)); });
    add(glsl::evsm4, ", vec2(40.0, 8.0), vec2(0.01, 0.002)",
        maps_of([](float d) { return encode_evsm4(d, vec2(40.0f, 8.0f)); }), [fetch](const sample& s, float far) {
            return vec4(evsm4(fetch(s), at(s), s.x[0].z, vec2(40.0f, 8.0f), vec2(0.01f, 0.002f), far));
        });
    const std::vector<texels> moments = maps_of([](float d) { return encode_msm(d); });
    add(glsl::msm, ", vec2(0.000003, 0.375)", moments,
        [fetch](const sample& s, float far) { return vec4(msm(fetch(s), at(s), s.x[0].z, msm_bias_32, far)); });
    add(glsl::msm_unorm16, ", vec2(0.00006, 0.628)",
        maps_of([](float d) { return to_optimized_moments(encode_msm(d)); }),
        [fetch](const sample& s, float far) { return vec4(msm_unorm16(fetch(s), at(s), s.x[0].z, msm_bias_16, far)); });
    add(glsl::msm_hausdorff, ", vec2(0.000003, 0.375)", moments, [fetch](const sample& s, float far) {
        return vec4(msm_hausdorff(fetch(s), at(s), s.x[0].z, msm_bias_32, far));
    });
    // one of them in an array, by its hooks
    all.push_back(bound_filter(
        glsl::esm, ", 8.0", "bound to an array", {.texture = glsl::texture::array, .outside = outside_map::clamped},
        [](const auto& depth, const sample& s, comparison) { return esm(depth, at(s), s.x[0].z, 8.0f); }));
    all.push_back(bound_filter(glsl::esm, ", 8.0", "bound to an array, lit outside", {.texture = glsl::texture::array},
                               [](const auto&, const sample& s, comparison) {
                                   return map_covers(vec2(s.map.size), at(s)) ? esm(s.depth(), at(s), s.x[0].z, 8.0f)
                                                                              : 1.0f;
                               }));
}

}  // namespace parity
