// SPDX-License-Identifier: MIT
#include "jobs.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include <entry.hpp>
#include <umbrage/registry.hpp>

namespace bench {

namespace glsl = umbrage::glsl;
using glsl::snippet;

std::string read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    if (!file || text.str().empty()) throw std::runtime_error("cannot read " + path);
    return text.str();
}

std::vector<job> jobs(const std::string& folder) {
    const auto text = [&](const std::string& name) { return read(folder + '/' + name + ".glsl"); };
    const auto version = [&](const std::string& name) { return name + ' ' + read(folder + '/' + name + ".version"); };
    const std::string three = version("three"), babylon = version("babylon"), playcanvas = version("playcanvas");
    const std::string us = "umbrage";

    // Macros that the peers' engines put before these texts.
    const std::string old = "#define texture2D texture\n#define textureCube texture\n";
    const std::string three_shadow =
        old + "#define USE_SHADOWMAP\n#define PI2 6.283185307179586\n" + text("three_shadow");
    const std::string babylon_shadow = old +
                                       "#define SHADOWS\n#define WEBGL2\n#define texture2DLodEXT textureLod\n"
                                       "float getRand(vec2 seed) { return 0.5; }\n" +
                                       text("babylon_shadow");
    const std::string playcanvas_shadow =
        "#define SHADOWMAP_ACCEPT(name) sampler2DShadow name\n#define SHADOWMAP_PASS(name) name\n"
        "#define textureShadow(name, at) texture(name, at)\n#define saturate(v) clamp(v, 0.0, 1.0)\n" +
        text("playcanvas_shadow");

    // A packed map to a filter of ours. What a border costs is a job of its own.
    static constexpr auto clamped = umbrage::outside_map::clamped;
    const auto read_by = [](std::string depth, int channels, std::vector<snippet> needs = {}) {
        return glsl::binding{
            .outside = clamped, .depth = std::move(depth), .channels = channels, .needs = std::move(needs)};
    };
    const glsl::binding rg11 = glsl::stored_as(umbrage::rg<11>{}, {.outside = clamped});
    const glsl::binding level = read_by("umbrage_level_rg11(value.xy)", 2, {glsl::level_rg<11>});
    const glsl::binding ps14 = read_by("umbrage_decode_ps14(value.xy)", 2, {glsl::decode_ps14});
    const glsl::binding threejs_rg = read_by("unpackRGToDepth(value.xy)", 2);
    const glsl::binding threejs_rgba = read_by("unpackRGBAToDepth(value)", 4);
    const glsl::binding babylon_rgba = read_by("unpack(value)", 4);
    const glsl::binding playcanvas_rgba = read_by("uint2float(value)", 4);
    const auto filter = [](const snippet& of, const glsl::binding& map) { return bind(of, "", map); };
    const auto by_level = [&](const snippet& of) {
        return std::vector<glsl::bound>{glsl::receiver_rg<11>, filter(of, level)};
    };
    const std::string pcf = "vec4(umbrage_pcf_2x2(map, map_size, x1.xy, x1.z))";
    const glsl::binding plain{.outside = clamped}, depths_at_once{.outside = clamped, .gather = true},
        sampled{.texture = glsl::texture::shadow, .outside = clamped},
        comparisons_at_once{.texture = glsl::texture::shadow, .outside = clamped, .gather = true};
    // A filter bound to a map of some kind.
    const auto row = [&](const std::string& name, const snippet& of, const glsl::binding& map,
                         const std::string& numbers = "") {
        return shader{us,
                      name,
                      "",
                      {bind(of, "bound", map)},
                      "vec4(umbrage_" + std::string(of.name) + "_bound(" +
                          (map.texture == glsl::texture::shadow ? "depth_map" : "map") + ", map_size, x1.xy, x1.z" +
                          numbers + "))"};
    };
    // The same where the shader asks first and skips what is lit anyway, as Babylon.js' functions do; what is in such a
    // branch counts half.
    const auto early = [&](const std::string& name, const snippet& of, const glsl::binding& map,
                           const std::string& numbers = "") {
        shader asking = row(name + ", early", of, map, numbers);
        asking.result = "vec4(1.0); if (umbrage_in_filter_domain_bound(x1.xy, x1.z)) result = " + asking.result;
        return asking;
    };
    // A peer's that has no such tests, with ours about it.
    const auto tested = [&](const std::string& name, const std::string& functions, const std::string& call) {
        return shader{playcanvas,
                      name + ", with our tests",
                      functions,
                      {glsl::in_filter_domain, glsl::within_far_plane},
                      "vec4(" + call +
                          "); result = umbrage_within_far_plane(x1.z) ? result : vec4(0.0); "
                          "result = umbrage_in_filter_domain(x1.xy, x1.z) ? result : vec4(1.0)"};
    };
    const auto taps = [](const std::string& receiver) {
        return "vec4(umbrage_four_tap(map, map_size, x1.xy - 0.5, x1.xy + vec2(0.5, -0.5), "
               "x1.xy + vec2(-0.5, 0.5), x1.xy + 0.5, " +
               receiver + "))";
    };
    const std::string receiver = "umbrage_receiver_rg11(x1.z, 1.0)";

    glsl::binding gathered = level;
    gathered.gather = true;

    // Taps at Babylon.js' points of a Poisson disc, rounded.
    const std::vector<glsl::bound> by_sampler = {glsl::receiver_rg<11>, glsl::inside_texel_space,
                                                 filter(glsl::four_tap_hardware, gathered)};
    const std::string sampled_taps =
        "vec4(umbrage_four_tap_hardware(map, map_size, x0.xy + vec2(-0.942, -0.399) / map_size.x, "
        "x0.xy + vec2(0.946, -0.769) / map_size.x, x0.xy + vec2(-0.094, -0.929) / map_size.x, "
        "x0.xy + vec2(0.345, 0.294) / map_size.x, " +
        receiver + "))";

    return {
        {"nothing", {{us, "nothing", "", {}, "x0"}}},
        {"pack, 2 channels",
         {{us,
           "rg11",
           "",
           {glsl::encode_rg<11>, glsl::to_unorm},
           "vec4(umbrage_to_unorm(umbrage_encode_rg11(x0.x)), 0.0, 1.0)"},
          {us,
           "rg16",
           "",
           {glsl::encode_rg<16>, glsl::to_unorm},
           "vec4(umbrage_to_unorm(umbrage_encode_rg16(x0.x)), 0.0, 1.0)"},
          {three, "packDepthToRG", text("three"), {}, "vec4(packDepthToRG(x0.x), 0.0, 1.0)"}}},
        {"pack, 3 channels",
         {{us,
           "rgb24",
           "",
           {glsl::encode_rgb24, glsl::to_unorm},
           "vec4(umbrage_to_unorm(umbrage_encode_rgb24(x0.x)), 1.0)"},
          {three, "packDepthToRGB", text("three"), {}, "vec4(packDepthToRGB(x0.x), 1.0)"}}},
        {"pack, 4 channels",
         {{us, "three RGBA", "", {glsl::write_threejs_rgba}, "umbrage_write_threejs_rgba(x0.x)"},
          {us,
           "base 255, repaired",
           "",
           {glsl::encode_base255_repaired, glsl::to_unorm},
           "umbrage_to_unorm(umbrage_encode_base255_repaired(x0.x))"},
          {three, "packDepthToRGBA", text("three"), {}, "packDepthToRGBA(x0.x)"},
          {babylon, "pack", text("babylon"), {}, "pack(x0.x)"}}},
        {"pack, bits of a float",
         {{us,
           "float_bits",
           "",
           {glsl::encode_float_bits, glsl::to_unorm},
           "umbrage_to_unorm(umbrage_encode_float_bits(x0.x))"},
          {playcanvas, "float2uint", text("playcanvas"), {}, "float2uint(x0.x)"}}},
        {"unpack, 2 channels",
         {{us, "rg11", "", {glsl::decode_rg<11>}, "vec4(umbrage_decode_rg11(x0.xy, 1.0))"},
          {us, "rg16", "", {glsl::decode_rg<16>}, "vec4(umbrage_decode_rg16(x0.xy, 1.0))"},
          {us, "ps14", "", {glsl::decode_ps14}, "vec4(umbrage_decode_ps14(x0.xy))"},
          {three, "unpackRGToDepth", text("three"), {}, "vec4(unpackRGToDepth(x0.xy))"}}},
        {"unpack, 3 channels",
         {{us, "rgb24", "", {glsl::decode_rgb24}, "vec4(umbrage_decode_rgb24(x0.xyz, 1.0))"},
          {three, "unpackRGBToDepth", text("three"), {}, "vec4(unpackRGBToDepth(x0.xyz))"}}},
        {"unpack, 4 channels",
         {{us, "three RGBA", "", {glsl::decode_threejs_rgba}, "vec4(umbrage_decode_threejs_rgba(x0))"},
          {us, "base 255", "", {glsl::decode_base255}, "vec4(umbrage_decode_base255(x0))"},
          {three, "unpackRGBAToDepth", text("three"), {}, "vec4(unpackRGBAToDepth(x0))"},
          {babylon, "unpack", text("babylon"), {}, "vec4(unpack(x0))"}}},
        {"unpack, bits of a float",
         {{us, "float_bits", "", {glsl::decode_float_bits}, "vec4(umbrage_decode_float_bits(x0))"},
          {playcanvas, "uint2float", text("playcanvas"), {}, "vec4(uint2float(x0))"}}},
        {"hard, packed map",
         {{us, "rg11 by level", "", by_level(glsl::hard), "vec4(umbrage_hard(map, map_size, x1.xy, " + receiver + "))"},
          {us, "rg11", "", {filter(glsl::hard, rg11)}, "vec4(umbrage_hard(map, map_size, x1.xy, x1.z))"},
          {babylon,
           "computeShadow",
           babylon_shadow,
           {},
           "vec4(computeShadow(vec4(x0.xyz, 1.0), x0.z, map, 0.0, 0.0))"}}},
        {"hard, depth map",
         {{us, "hard", "", {glsl::hard}, "vec4(umbrage_hard(map, map_size, x1.xy, x1.z))"},
          {three,
           "getShadow, basic",
           three_shadow,
           {},
           "vec4(getShadow(map, map_size, 1.0, 0.0, 1.0, vec4(x0.xyz, 1.0)))"}}},
        {"four taps, packed map",
         {{us, "rg11 by level", "", by_level(glsl::four_tap), taps(receiver)},
          {us, "rg11", "", {filter(glsl::four_tap, rg11)}, taps("x1.z")},
          {us, "rg11 by level, by the sampler", "", by_sampler, sampled_taps},
          {us, "rg11 by level, by the sampler, early", "", by_sampler,
           "vec4(1.0); if (umbrage_inside_texel_space(x1.xy)) result = " + sampled_taps},
          {babylon,
           "computeShadowWithPoissonSampling",
           babylon_shadow,
           {},
           "vec4(computeShadowWithPoissonSampling(vec4(x0.xyz, 1.0), x0.z, map, 1.0 / map_size.x, 0.0, 0.0))"}}},
        {"2x2 PCF, packed map",
         {{us, "rg11 by level", "", by_level(glsl::pcf_2x2),
           "vec4(umbrage_pcf_2x2(map, map_size, x1.xy, " + receiver + "))"},
          {us, "rg11", "", {filter(glsl::pcf_2x2, rg11)}, pcf},
          {us,
           "rg11 by level, gathered",
           "",
           {glsl::receiver_rg<11>, filter(glsl::pcf_2x2, gathered)},
           "vec4(umbrage_pcf_2x2(map, map_size, x1.xy, " + receiver + "))"},
          {us,
           "ps14",
           "",
           {glsl::receiver_ps14, filter(glsl::pcf_2x2, ps14)},
           "vec4(umbrage_pcf_2x2(map, map_size, x1.xy, umbrage_receiver_ps14(x1.z)))"},
          {three, "unpackRGToDepth in the same filter", text("three"), {filter(glsl::pcf_2x2, threejs_rg)}, pcf},
          {three, "unpackRGBAToDepth in the same filter", text("three"), {filter(glsl::pcf_2x2, threejs_rgba)}, pcf},
          {babylon, "unpack in the same filter", text("babylon"), {filter(glsl::pcf_2x2, babylon_rgba)}, pcf},
          {playcanvas,
           "uint2float in the same filter",
           text("playcanvas"),
           {filter(glsl::pcf_2x2, playcanvas_rgba)},
           pcf}}},
        {"2x2 PCF, depth map",  // the peers leave the filter to the sampler, whose work no instruction shows
         {{us, "pcf_2x2", "", {glsl::pcf_2x2}, pcf},
          row("pcf_2x2, gathered", glsl::pcf_2x2, depths_at_once),
          row("pcf_2x2, four comparisons by the sampler", glsl::pcf_2x2, sampled),
          row("pcf_2x2, one gather of comparisons", glsl::pcf_2x2, comparisons_at_once),
          row("pcf_2x2_hardware, by the sampler", glsl::pcf_2x2_hardware, sampled),
          early("pcf_2x2_hardware", glsl::pcf_2x2_hardware, sampled),
          {babylon,
           "computeShadowWithPCF1, by the sampler",
           babylon_shadow,
           {},
           "vec4(computeShadowWithPCF1(vec4(x0.xyz, 1.0), x0.z, depth_map, 0.0, 0.0))"},
          {playcanvas,
           "getShadowPCF1x1, by the sampler",
           playcanvas_shadow,
           {},
           "vec4(getShadowPCF1x1(depth_map, x0.xyz, x1))"},
          tested("getShadowPCF1x1", playcanvas_shadow, "getShadowPCF1x1(depth_map, x0.xyz, x1)")}},
        cascades(),
        {"soft, 3x3 texels and about",
         {{us, "box, r = 1, rg11 by level", "", by_level(glsl::box),
           "vec4(umbrage_box(map, map_size, x1.xy, " + receiver + ", 1))"},
          {us, "box, r = 1, rg11", "", {filter(glsl::box, rg11)}, "vec4(umbrage_box(map, map_size, x1.xy, x1.z, 1))"},
          row("tent3", glsl::tent<3>, plain),
          row("tent3, 4 gathers", glsl::tent<3>, depths_at_once),
          row("tent3, 4 gathers of comparisons", glsl::tent<3>, comparisons_at_once),
          row("window_hardware3, 4 look-ups", glsl::window_hardware<3>, sampled, ", 1.0, 2.0"),
          early("window_hardware3", glsl::window_hardware<3>, sampled, ", 1.0, 2.0"),
          {three,
           "getShadow, 5 taps by the sampler",
           "#define SHADOWMAP_TYPE_PCF\n" + three_shadow,
           {},
           "vec4(getShadow(depth_map, map_size, 1.0, 0.0, 1.0, vec4(x0.xyz, 1.0)))"},
          {babylon,
           "computeShadowWithPCF3, by the sampler",
           babylon_shadow,
           {},
           "vec4(computeShadowWithPCF3(vec4(x0.xyz, 1.0), x0.z, depth_map, vec2(map_size.x, 1.0 / 2048.0), 0.0, 0.0))"},
          {playcanvas,
           "getShadowPCF3x3, by the sampler",
           playcanvas_shadow,
           {},
           "vec4(getShadowPCF3x3(depth_map, x0.xyz, vec4(map_size, 0.0, 0.0)))"},
          tested("getShadowPCF3x3", playcanvas_shadow,
                 "getShadowPCF3x3(depth_map, x0.xyz, vec4(map_size, 0.0, 0.0))")}},
        {"soft, 5x5 texels",
         {{us, "box, r = 2, rg11 by level", "", by_level(glsl::box),
           "vec4(umbrage_box(map, map_size, x1.xy, " + receiver + ", 2))"},
          {us, "box, r = 2, rg11", "", {filter(glsl::box, rg11)}, "vec4(umbrage_box(map, map_size, x1.xy, x1.z, 2))"},
          row("castano_dyadic5", glsl::castano_dyadic<5>, plain),
          row("castano_dyadic5, 9 gathers", glsl::castano_dyadic<5>, depths_at_once),
          row("castano_dyadic5, 9 gathers of comparisons", glsl::castano_dyadic<5>, comparisons_at_once),
          row("window_hardware5, 9 look-ups", glsl::window_hardware<5>, sampled, ", 1.0, 3.0, 4.0"),
          early("window_hardware5", glsl::window_hardware<5>, sampled, ", 1.0, 3.0, 4.0"),
          {babylon,
           "computeShadowWithPCF5, by the sampler",
           babylon_shadow,
           {},
           "vec4(computeShadowWithPCF5(vec4(x0.xyz, 1.0), x0.z, depth_map, vec2(map_size.x, 1.0 / 2048.0), 0.0, 0.0))"},
          {playcanvas,
           "getShadowPCF5x5, by the sampler",
           playcanvas_shadow,
           {},
           "vec4(getShadowPCF5x5(depth_map, x0.xyz, vec4(map_size, 0.0, 0.0)))"},
          tested("getShadowPCF5x5", playcanvas_shadow,
                 "getShadowPCF5x5(depth_map, x0.xyz, vec4(map_size, 0.0, 0.0))")}},
    };
}

job registry() {
    job all{"every snippet", {}};
    for (const snippet* s : glsl::registry()) {
        const parity::entry* of = nullptr;  // its plain one, else the first
        for (const parity::entry& e : parity::entries())
            if (e.primitive == s && (!of || (e.variant.empty() && !of->variant.empty()))) of = &e;
        if (!of) throw std::runtime_error(std::string(s->name) + " has no parity entry");
        const auto snippets = of->snippets();
        all.shaders.push_back(
            {"umbrage", std::string(s->name), of->preamble, {snippets.begin(), snippets.end()}, of->call});
    }
    return all;
}

}  // namespace bench
