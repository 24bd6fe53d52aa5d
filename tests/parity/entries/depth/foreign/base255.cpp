// SPDX-License-Identifier: MIT
#include <umbrage/depth/foreign/base255.hpp>

#include "formats.hpp"

namespace parity {

void add_depth_foreign_base255(std::vector<entry>& all) {
    namespace glsl = umbrage::glsl;
    using namespace umbrage;

    all.push_back(writer(glsl::write_base255, "umbrage_write_base255(x0.x)", [](float d) { return write_base255(d); }));
    const entry repaired = writer(glsl::encode_base255_repaired, "umbrage_encode_base255_repaired(x0.x)",
                                  [](float d) { return vec4(encode_base255_repaired(d)); });
    all.push_back(repaired);
    all.push_back(stored(repaired));
    all.push_back(
        reader(glsl::decode_base255, "vec4(umbrage_decode_base255(x0))", [](vec4 c) { return decode_base255(c); }));
}

}  // namespace parity
