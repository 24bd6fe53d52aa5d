// SPDX-License-Identifier: MIT
//
// Functions over images, one of each kind, for the report of what the compiler made of their loops.
#include <umbrage/depth/encodings.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/images/encode.hpp>
#include <umbrage/images/min_max.hpp>
#include <umbrage/images/rasterize.hpp>
#include <umbrage/images/summed_area.hpp>
#include <umbrage/images/visibility.hpp>

using namespace umbrage;

struct in_bands {
    template <class Piece>
    void operator()(int count, Piece&& piece) const {
        piece(0, count);
    }
};

void use_all(const image<float>& depth, const depth_receivers& receivers, const receiver_planes& planes,
             const image<glm::u8vec2>& packed, const image<std::uint8_t>& bytes, const mesh_view& mesh,
             image<float>& out, image<std::uint32_t>& sums, image<glm::u8vec2>& texels) {
    encode(depth, texels, rg<11>{});
    decode(packed, out, rg<11>{});
    encode(depth, out, depth32f{});
    visibility(depth, depth32f{}, receivers, filters::hard{}, out);
    visibility(packed, rg<11>{}, planes, filters::hard{}, out);
    visibility(depth, depth32f{}, planes, filters::pcf_2x2{}, out);
    rasterize_depth(out, mesh, glm::mat4(1.0f), {});
    summed_area(bytes, sums, in_bands{});
    static_cast<void>(make_min_max_pyramid(depth, 3));
}
