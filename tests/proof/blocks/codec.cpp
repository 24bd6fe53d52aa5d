// SPDX-License-Identifier: MIT
//
// encode and decode over images against the encodings' own, bit by bit.
#include "../../unit/images/paths.hpp"

#include <umbrage/depth/encodings.hpp>
#include <umbrage/images/encode.hpp>

namespace {

using namespace paths;

template <class Texel>
Texel any_texel(values& v) {
    if constexpr (std::is_same_v<Texel, float>) return v.depth();
    else if constexpr (std::is_integral_v<Texel>) return static_cast<Texel>(v.word() >> (32 - 8 * sizeof(Texel)));
    else {
        Texel t;
        for (int i = 0; i < Texel::length(); ++i) t[i] = static_cast<std::uint8_t>(v.word() >> 24);
        return t;
    }
}

template <class Encoding>
void check_codec(Encoding encoding) {
    using texel = typename Encoding::texel;
    values v;
    for (const glm::ivec2 size :
         {glm::ivec2(1, 1), glm::ivec2(63, 3), glm::ivec2(64, 2), glm::ivec2(65, 40), glm::ivec2(389, 31)}) {
        gapped<float> depth(size), back(size);
        gapped<texel> texels(size), any(size);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                depth.view()[{x, y}] = v.depth();
                any.view()[{x, y}] = any_texel<texel>(v);
            }
        for_each_path([&] {
            umbrage::encode(depth.view(), texels.view(), encoding, bands{3});
            umbrage::decode(any.view(), back.view(), encoding, bands{2});
            int different = 0;
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) {
                    const texel wanted = encoding.encode(depth.view()[{x, y}]);
                    const texel& stored = texels.view()[{x, y}];  // of constants, compilers round sums to nearest
                    const float decoded = encoding.decode(any.view()[{x, y}]);
                    different += std::memcmp(&wanted, &stored, sizeof wanted) != 0;
                    different += bits(decoded) != bits(back.view()[{x, y}]);
                }
            CHECK(different == 0);
            CHECK(texels.gaps_untouched());
            CHECK(back.gaps_untouched());
        });
    }
}

}  // namespace

TEST_CASE("encode, decode: every path gives the primitive's bits, in either direction and at every edge") {
    umbrage::for_each_encoding([]<class Encoding>(Encoding encoding) {
        CAPTURE(Encoding::name);
        check_codec(encoding);
        encoding.direction = umbrage::depth_direction::reversed;
        if constexpr (umbrage::has_edge<Encoding>) encoding.edge = umbrage::lower_edge<float>;
        check_codec(encoding);
    });
}
