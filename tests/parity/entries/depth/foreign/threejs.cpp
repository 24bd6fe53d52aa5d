// SPDX-License-Identifier: MIT
#include <umbrage/depth/foreign/threejs.hpp>

#include "formats.hpp"

namespace parity {

void add_depth_foreign_threejs(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    all.push_back(writer(glsl::write_threejs_rgba, "umbrage_write_threejs_rgba(x0.x)",
                         [](float d) { return write_threejs_rgba(d); }));
    all.push_back(writer(glsl::write_threejs_rgb, "vec4(umbrage_write_threejs_rgb(x0.x), 1.0)",
                         [](float d) { return vec4(write_threejs_rgb(d), 1.0f); }));
    all.push_back(writer(glsl::write_threejs_rg, "vec4(umbrage_write_threejs_rg(x0.x), 0.0, 1.0)",
                         [](float d) { return vec4(write_threejs_rg(d), 0.0f, 1.0f); }));

    all.push_back(reader(glsl::decode_threejs_rgba, "vec4(umbrage_decode_threejs_rgba(x0))",
                         [](vec4 c) { return decode_threejs_rgba(c); }));
    all.push_back(reader(glsl::decode_threejs_rgb, "vec4(umbrage_decode_threejs_rgb(vec3(x0.x, x0.y, x0.z)))",
                         [](vec4 c) { return decode_threejs_rgb(vec3(c)); }));
    all.push_back(reader(glsl::decode_threejs_rg, "vec4(umbrage_decode_threejs_rg(vec2(x0.x, x0.y)))",
                         [](vec4 c) { return decode_threejs_rg(vec2(c)); }));
}

}  // namespace parity
