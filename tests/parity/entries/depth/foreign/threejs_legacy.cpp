// SPDX-License-Identifier: MIT
#include <umbrage/depth/foreign/threejs_legacy.hpp>

#include "formats.hpp"

namespace parity {

void add_depth_foreign_threejs_legacy(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    all.push_back(writer(glsl::write_threejs_legacy, "umbrage_write_threejs_legacy(x0.x)",
                         [](float d) { return write_threejs_legacy(d); }));
    const entry repaired = writer(glsl::encode_threejs_legacy_repaired, "umbrage_encode_threejs_legacy_repaired(x0.x)",
                                  [](float d) { return vec4(encode_threejs_legacy_repaired(d)); });
    all.push_back(repaired);
    all.push_back(stored(repaired));

    all.push_back(reader(glsl::decode_threejs_legacy, "vec4(umbrage_decode_threejs_legacy(x0))",
                         [](vec4 c) { return decode_threejs_legacy(c); }));
}

}  // namespace parity
