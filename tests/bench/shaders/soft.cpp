// SPDX-License-Identifier: MIT
//
// Soft shadows: a mean of moments by the sampler and what it says, and contact hardening over as many taps.
#include "jobs.hpp"

#include <umbrage/filter/blocker/pcss.hpp>
#include <umbrage/filter/blocker/pcss_hardware.hpp>
#include <umbrage/filter/prefiltered/decode_hardware.hpp>
#include <umbrage/filter/prefiltered/look_up.hpp>

namespace bench {

namespace glsl = umbrage::glsl;

namespace {

/// Contact hardening by samplers, as pcss_hardware.hpp has it; like Babylon.js' it returns where no blocker is found.
constexpr glsl::snippet pcss_hardware{.name = "pcss_hardware", .role = glsl::hook::chosen, .source = R"GLSL(
float umbrage_pcss_hardware(sampler2D depths, sampler2DShadow sun, vec2 size, vec2 coord, float receiver, vec4 soft,
                            vec4 turn) {
    if (!umbrage_in_filter_domain_sun(coord, receiver)) return 1.0;
    vec2 search = umbrage_pcss_radius_sun(vec2(0.0, 0.0), receiver, soft);
    vec2 found = umbrage_blockers_hardware16_depths(depths, size, coord, receiver, search, turn);
    if (found.x < 0.5) return 1.0;
    vec2 radius = umbrage_pcss_radius_sun(found, receiver, soft);
    return umbrage_ellipse_hardware16_sun(sun, size, coord, receiver, radius, turn);
}
)GLSL"};

std::vector<glsl::bound> pcss_hardware_items() {
    const glsl::binding depths{
        .texture = glsl::texture::depth, .outside = umbrage::outside_map::clamped, .gather = true},
        sun{.texture = glsl::texture::shadow, .outside = umbrage::outside_map::clamped};
    return {bind(glsl::blockers_hardware<16>, "depths", depths),
            bind(glsl::ellipse_hardware<16>, "sun", sun),
            bind(glsl::in_filter_domain, "sun", sun),
            bind(glsl::pcss_radius, "sun", sun),
            glsl::disc_rotation,
            pcss_hardware};
}

}  // namespace

std::vector<job> soft(const std::string& folder) {
    const auto text = [&](const std::string& name) { return read(folder + '/' + name + ".glsl"); };
    const auto version = [&](const std::string& name) { return name + ' ' + read(folder + '/' + name + ".version"); };
    const std::string three = version("three"), babylon = version("babylon"), playcanvas = version("playcanvas");
    const std::string us = "umbrage";

    // Ours are written out tap by tap: the peers' loops are unrolled too.
    const std::string unrolled = "#extension GL_EXT_control_flow_attributes : require\n#define for [[unroll]] for\n";
    const std::string three_shadow =
        "#define texture2D texture\n#define USE_SHADOWMAP\n#define SHADOWMAP_TYPE_VSM\n" + text("three_shadow");
    const std::string playcanvas_words =
        unrolled +
        "#define TEXTURE_ACCEPT(name) sampler2D name\n#define TEXTURE_PASS(name) name\n"
        "#define texture2DLod textureLod\n#define saturate(v) clamp(v, 0.0, 1.0)\n";
    const std::string playcanvas_evsm =
        playcanvas_words + "#define CAPS_TEXTURE_FLOAT_FILTERABLE\n" + text("playcanvas_evsm");
    const std::string babylon_shadow =
        unrolled +
        "#define texture2D texture\n#define textureCube texture\n#define SHADOWS\n#define WEBGL2\n"
        "#define texture2DLodEXT textureLod\n" +
        text("babylon_helpers") + text("babylon_shadow");

    const auto looked_up = [](const std::string& decoded, const std::string& cut) {
        return "vec4(umbrage_in_filter_domain(x0.xy, x0.z) ? umbrage_reduce_light_bleeding(" + decoded + ", " + cut +
               ") : 1.0)";
    };
    const std::string texel = "textureLod(map, x0.xy, 0.0)";
    const auto pcss = [](const std::string& map) {
        return "vec4(umbrage_pcss16" + map +
               "(map, map_size, x1.xy, x1.z, vec4(0.0625, 0.0625, 16.0, 96.0), "
               "umbrage_disc_rotation(gl_FragCoord.xy)))";
    };
    return {
        {"VSM, one tap by the sampler",  // both hold mean and deviation
         {{us,
           "decode_vsm_hardware",
           "",
           {glsl::in_filter_domain, glsl::decode_vsm_hardware},
           "vec4(umbrage_in_filter_domain(x0.xy, x0.z) ? "
           "umbrage_decode_vsm_hardware(texture(map, x0.xy).xy, x0.z, 1e-7, 0.3) : 1.0)"},
          {us,
           "decode_vsm",
           "",
           {glsl::in_filter_domain, glsl::reduce_light_bleeding, glsl::decode_vsm},
           looked_up("umbrage_decode_vsm(texture(map, x0.xy).xy, x0.z, 1e-7)", "0.3")},
          {three,
           "getShadow, VSM",
           three_shadow,
           {},
           "vec4(getShadow(map, map_size, 1.0, 0.0, 1.0, vec4(x0.xyz, 1.0)))"}}},
        {"EVSM, one tap by the sampler",  // PlayCanvas' caller tests what is outside, and so does ours here
         {{us,
           "decode_evsm2_hardware",
           "",
           {glsl::decode_evsm2_hardware},
           "vec4(umbrage_decode_evsm2_hardware(" + texel + ".xy, x0.z, 21.64, 0.003, 0.1))"},
          {us,
           "decode_evsm2",
           "",
           {glsl::reduce_light_bleeding, glsl::decode_evsm2},
           "vec4(umbrage_reduce_light_bleeding(umbrage_decode_evsm2(" + texel + ".xy, x0.z, 21.64, 0.003), 0.1))"},
          {playcanvas,
           "getShadowVSM32",
           playcanvas_evsm,
           {},
           "vec4(getShadowVSM32(map, x0.xyz, vec4(2048.0, 0.0002, 0.0, 0.0), 15.0))"}}},
        {"PCSS, 16 + 16 taps",
         {{us, "pcss_hardware16", "", pcss_hardware_items(),
           "vec4(umbrage_pcss_hardware(map, depth_map, map_size, x1.xy, x1.z, vec4(0.0625, 0.0625, 16.0, 96.0), "
           "vec4(64.0, 0.0, 0.0, 64.0)))"},
          {us, "pcss_hardware16, turned", "", pcss_hardware_items(),
           "vec4(umbrage_pcss_hardware(map, depth_map, map_size, x1.xy, x1.z, vec4(0.0625, 0.0625, 16.0, 96.0), "
           "umbrage_disc_rotation(gl_FragCoord.xy)))"},
          {us, "pcss16", "", {glsl::pcss<16>, glsl::disc_rotation}, pcss("")},
          {babylon,
           "computeShadowWithPCSS16",
           babylon_shadow,
           {},
           "vec4(computeShadowWithPCSS16(vec4(x0.xyz, 1.0), x0.z, map, depth_map, 1.0 / 2048.0, 20.0, 0.0, 0.0))"},
          {playcanvas,
           "getShadowPCSS",
           playcanvas_words + text("playcanvas_pcss"),
           {},
           "vec4(getShadowPCSS(map, x0.xyz, vec4(0.0), vec4(10.0, 12.0, 1.0, 0.0), vec4(16.0, 16.0, 0.1, 2.0), "
           "vec3(0.0)))"}}},
    };
}

}  // namespace bench
