// SPDX-License-Identifier: MIT
//
// One whole-image function, for neon.cmake to look at what it is compiled to.
#include <umbrage/images/encode.hpp>
#include <umbrage/images/visibility.hpp>

using namespace umbrage;

#if defined(ENCODE)
void run(image_view<const float> depth, image_view<glm::u8vec2> texels) { encode(depth, texels, rg<11>{}); }
#elif defined(DECODE)
void run(image_view<const glm::u8vec2> texels, image_view<float> depth) { decode(texels, depth, rg<11>{}); }
#elif defined(PCF_2X2)
void run(image_view<const glm::u8vec2> map, const receiver_planes& receivers, image_view<float> out) {
    visibility(map, rg<11>{}, receivers, filters::pcf_2x2{}, out);
}
#elif defined(BOX)
void run(image_view<const float> map, const receiver_planes& receivers, image_view<float> out) {
    visibility(map, depth32f{}, receivers, filters::box{2}, out);
}
#endif
