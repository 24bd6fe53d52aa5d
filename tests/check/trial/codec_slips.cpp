// SPDX-License-Identifier: MIT
//
// Slips of packing and unpacking functions: constants, offsets and the order of channels.
#include <algorithm>

#include "on_software.hpp"

using namespace check;

namespace {

struct planted {
    const char *text, *call, *function, *kinds;  ///< kinds of slips, with a comma behind each
};

const planted all[]{
    {"vec3 pack(float z) { float k = min(floor(z * 16777216.0), 16777215.0), h = floor(k / 256.0), t = floor(h / "
     "256.0);"
     " return vec3(t, h - t * 256.0, k - h * 256.0) / 255.0; }",
     "vec4(pack(z).bgr, 0.0)", "rgb24", "channels,"},
    {"vec3 pack(float z) { float k = min(floor(z * 16777216.0), 16777215.0), h = floor(k / 256.0), t = floor(h / "
     "256.0);"
     " return vec3(t, h - t * 256.0, k - h * 256.0) / 255.0; }",
     "vec4(pack(z * 0.5 + 0.5), 0.0)", "rgb24", "z_range,"},
    {"vec3 pack(float z) { float k = min(floor(z * 16777216.0), 16777215.0), h = floor(k / 256.0), t = floor(h / "
     "256.0);"
     " return vec3(t, h - t * 256.0, k - h * 256.0) / 255.0; }",
     "vec4(pack(1.0 - z).bgr, 0.0)", "rgb24", "direction,channels,"},
    {"vec2 pack(float z) { float k = min(floor(z * 2048.0), 2047.0), h = floor(k / 256.0);"
     " return vec2(k - h * 256.0, h * 32.0) / 255.0; }",
     "vec4(pack(z).yx, 0.0, 0.0)", "rg11", "channels,"},
    {"vec2 pack(float z) { float k = min(floor(z * 2048.0), 2047.0), h = floor(k / 256.0);"
     " return vec2(k - h * 256.0, h * 32.0) / 255.0; }",
     "vec4(pack(z * (255.0 / 256.0)), 0.0, 0.0)", "rg11", "base,"},
    {"vec4 pack(float z) { vec4 e = fract(vec4(1.0, 255.0, 65025.0, 16581375.0) * z);"
     " return e - vec4(e.yzw, 0.0) * (1.0 / 255.0); }",
     "pack(z).abgr", "base255", "channels,"},
    {"float unpack(vec4 c) { return dot(c, vec4(1.0, 1.0 / 255.0, 1.0 / 65025.0, 1.0 / 16581375.0)); }",
     "unpack(c.abgr)", "base255", "channels,"},
    {"float unpack(vec4 c) { return dot(c, vec4(1.0, 1.0 / 255.0, 1.0 / 65025.0, 1.0 / 16581375.0)); }",
     "unpack(c) * 2.0 - 1.0", "base255", "z_range,"},
    {"float unpack(vec4 c) { return dot(c, vec4(1.0, 1.0 / 255.0, 1.0 / 65025.0, 1.0 / 16581375.0)); }",
     "1.0 - unpack(c.gbar)", "base255", "direction,channels,"},
    {"float unpack(vec4 c) { return dot(c, vec4(1.0, 1.0 / 255.0, 1.0 / 65025.0, 1.0 / 16581375.0)); }",
     "unpack(c) * (256.0 / 255.0)", "base255", "base,"},
};

}  // namespace

TEST_CASE("slips of codecs: each is named") {
    if (!llvmpipe()) return;
    for (const planted& p : all) {
        const verdict v = of_glsl(p.text, p.call);
        std::string kinds;
        for (const finding& f : v.slips) kinds += f.kind + ',';
        CAPTURE(p.text);
        CAPTURE(p.call);
        CAPTURE(check::text(v));
        CHECK(v.function == p.function);
        CHECK(kinds == p.kinds);
        CHECK(v.first.has_value());
    }
}

TEST_CASE("codecs that are none of ours: no name, and what they depend on") {
    if (!llvmpipe()) return;
    const verdict v = of_glsl("float unpack(vec4 c) { return dot(c.rg, vec2(1.0, 1.0 / 250.0)); }", "unpack(c)");
    CHECK(v.how == agreement::unknown);
    CHECK(check::text(v).find("add 1, 0.004, 0, 0") != std::string::npos);
    CHECK(of_glsl("vec4 pack(float z) { return vec4(z * z); }", "pack(z)").how == agreement::unknown);
}
