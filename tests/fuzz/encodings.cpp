// SPDX-License-Identifier: MIT
//
// Encodings: a depth comes back within its stated error, a cleared texel as the far plane, and images have the bits of
// texels alone, written and read.
#include <limits>
#include <utility>

#include <umbrage/core/image.hpp>
#include <umbrage/depth/encodings.hpp>
#include <umbrage/images/encode.hpp>

#include "input.hpp"

namespace {

void images(fuzz::input& in, const umbrage::image<float>& depths, const auto& encoding) {
    using texel = typename std::decay_t<decltype(encoding)>::texel;
    umbrage::image<texel> texels(depths.size());
    umbrage::image<float> back(depths.size());
    umbrage::encode(depths.view(), texels.view(), encoding, fuzz::pieces(in));
    umbrage::decode(std::as_const(texels).view(), back.view(), encoding, fuzz::pieces(in));
    for (std::size_t i = 0; i < depths.texels().size(); ++i) {
        const texel alone = encoding.encode(depths.texels()[i]);
        fuzz::must(std::memcmp(&alone, &texels.texels()[i], sizeof alone) == 0,
                   "an image's texel is the depth's alone");
        fuzz::must(fuzz::same(back.texels()[i], encoding.decode(alone)), "an image's depth is the texel's alone");
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    using namespace umbrage;
    fuzz::input in(bytes, size);
    const auto direction = in.chance(2) ? depth_direction::forward : depth_direction::reversed;
    const float a = in.number(-0.5f, 1.5f), nothing = std::numeric_limits<float>::quiet_NaN();
    umbrage::image<float> depths({in.within(0, 140), in.within(0, 3)}, a);
    for (std::size_t i = 0; i < depths.texels().size(); i += std::size_t(in.within(1, 40)))
        depths.texels()[i] = in.number(-0.5f, 1.5f);
    const int tried = in.within(0, int(encodings::size) - 1);
    int count = 0;
    for_each_encoding([&](auto encoding) {
        encoding = {.direction = direction};
        if (count++ == tried) images(in, depths, encoding);
        const auto texel = encoding.encode(a);
        const float back = encoding.decode(texel);
        const float far_away = direction == depth_direction::forward ? 1.0f : 0.0f;
        fuzz::must(encoding.decode(encoding.cleared()) == far_away, "a cleared texel is the far plane");
        if (a >= 0.0f && a < 1.0f) {  // floats store other numbers as they are
            fuzz::must(back >= 0.0f && back <= 1.0f, "a decoded depth lies within 0 and 1");
            const decoding_error off = encoding.error();
            const double above = double(back) - double(a);
            fuzz::must(above <= off.above && -above <= off.below, "a depth comes back within its stated error");
        }
        const float of_nothing = encoding.decode(encoding.encode(nothing));
        const bool keeps_faults = encoding.name == "threejs_legacy" || encoding.name == "base255";
        fuzz::must(keeps_faults || is_nan(of_nothing) || of_nothing == far_away, "NaN stays, or is the far plane");
    });
    return 0;
}
