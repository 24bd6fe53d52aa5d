// SPDX-License-Identifier: MIT
#include <cmath>

#include <umbrage/depth/foreign/base255.hpp>
#include <umbrage/depth/foreign/threejs.hpp>

#include "entries.hpp"

namespace parity {

void add_depth_foreign(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;
    auto depths = spread({{0.0f, 1.0f}}, depth_values(24));
    depths.push_back({"base-255 edges", [](std::uint64_t i, random& r, sample& s) {  // where a channel of base 255 goes up
                          const auto edge = static_cast<float>(std::pow(255.0, -1.0 - static_cast<double>(i % 4)) * r.below(256));
                          s.x[0].x = std::nextafter(edge, std::array{0.0f, edge, 1.0f}[i / 4 % 3]);
                      }});
    const auto writer = [&](const snippet& s, std::string call, vec4 (*twin)(float), std::vector<const snippet*> also = {},
                            target output = target::rgba32f) {
        all.push_back({.primitive = &s, .variant = output == target::rgba8 ? "8-bit target" : "",
                       .classes = depths, .whole = all_depths(),
                       .twin = [twin](const sample& x) { return twin(x.x[0].x); }, .call = std::move(call),
                       .also = std::move(also), .output = output, .bits = output == target::rgba8});
    };
    const auto reader = [&](const snippet& s, std::string call, float (*twin)(vec4)) {
        all.push_back({.primitive = &s, .classes = channels(), .whole = all_codes(), .twin = [twin](const sample& x) { return vec4(twin(x.x[0])); },
                       .call = std::move(call)});
    };

    writer(glsl::write_threejs_rgba, "umbrage_write_threejs_rgba(x0.x)", [](float d) { return write_threejs_rgba(d); });
    writer(glsl::write_threejs_rgb, "vec4(umbrage_write_threejs_rgb(x0.x), 1.0)",
           [](float d) { return vec4(write_threejs_rgb(d), 1.0f); });
    writer(glsl::write_threejs_rg, "vec4(umbrage_write_threejs_rg(x0.x), 0.0, 1.0)",
           [](float d) { return vec4(write_threejs_rg(d), 0.0f, 1.0f); });
    writer(glsl::write_threejs_legacy, "umbrage_write_threejs_legacy(x0.x)", [](float d) { return write_threejs_legacy(d); });
    writer(glsl::write_base255, "umbrage_write_base255(x0.x)", [](float d) { return write_base255(d); });
    for (const target output : {target::rgba32f, target::rgba8}) {
        const auto call = [output](const std::string& c) { return output == target::rgba8 ? "umbrage_to_unorm(" + c + ")" : c; };
        writer(glsl::encode_threejs_legacy_repaired, call("umbrage_encode_threejs_legacy_repaired(x0.x)"),
               [](float d) { return vec4(encode_threejs_legacy_repaired(d)); }, {&glsl::to_unorm}, output);
        writer(glsl::encode_base255_repaired, call("umbrage_encode_base255_repaired(x0.x)"),
               [](float d) { return vec4(encode_base255_repaired(d)); }, {&glsl::to_unorm}, output);
    }

    reader(glsl::decode_threejs_rgba, "vec4(umbrage_decode_threejs_rgba(x0))", [](vec4 c) { return decode_threejs_rgba(c); });
    reader(glsl::decode_threejs_rgb, "vec4(umbrage_decode_threejs_rgb(vec3(x0.x, x0.y, x0.z)))",
           [](vec4 c) { return decode_threejs_rgb(vec3(c)); });
    reader(glsl::decode_threejs_rg, "vec4(umbrage_decode_threejs_rg(vec2(x0.x, x0.y)))",
           [](vec4 c) { return decode_threejs_rg(vec2(c)); });
    reader(glsl::decode_threejs_legacy, "vec4(umbrage_decode_threejs_legacy(x0))", [](vec4 c) { return decode_threejs_legacy(c); });
    reader(glsl::decode_base255, "vec4(umbrage_decode_base255(x0))", [](vec4 c) { return decode_base255(c); });
}

}  // namespace parity
