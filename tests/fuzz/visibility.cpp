// SPDX-License-Identifier: MIT
//
// Visibility of whole images: each receiver has the bits that the filter gives it alone, and lies within 0 and 1.
#include <type_traits>

#include <umbrage/core/image.hpp>
#include <umbrage/depth/encodings.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/images/encode.hpp>
#include <umbrage/images/visibility.hpp>
#include <umbrage/shadow/look.hpp>

#include "input.hpp"

namespace {

using namespace umbrage;

template <class Filter, class Encoding>
void compare(fuzz::input& in, const Filter& filter, const Encoding& encoding, image_view<const float> depths) {
    image<typename Encoding::texel> map(depths.size);
    encode(depths, map, encoding);
    const glm::ivec2 size(in.within(1, 40), in.within(1, 3));
    image<glm::vec3> receivers(size);
    const glm::vec2 reach(depths.size);
    for (glm::vec3& r : receivers.texels())
        r = {in.number(-3, reach.x + 3), in.number(-3, reach.y + 3), in.number(-0.1f, 1.1f)};
    const auto outside = in.chance(2) ? outside_map::bordered : outside_map::clamped;
    image<float> out(size);
    visibility(map, encoding, receivers, filter, out, serial{}, outside);
    for (glm::ivec2 p(0); p.y < size.y; ++p.y)
        for (p.x = 0; p.x < size.x; ++p.x) {
            const glm::vec3 r = receivers[p];
            const auto alone = [&](const auto& map_texels) {
                return detail::filtered(filter, decoded(map_texels, encoding), glm::vec2(r), r.z, p);
            };
            const float one =
                outside == outside_map::bordered ? alone(bordered(map, encoding.cleared())) : alone(clamped(map));
            fuzz::must(out[p] == one, "an image's receiver has the bits of the filter alone");
            fuzz::must(one >= 0.0f && one <= 1.0f, "a visibility lies within 0 and 1");
        }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzz::input in(bytes, size);
    const glm::ivec2 map_size(in.within(1, 20), in.within(1, 20));
    image<float> depths(map_size);
    for (float& d : depths.texels()) d = in.tame(0, 1);
    const auto direction = in.chance(2) ? depth_direction::forward : depth_direction::reversed;
    const auto for_each_filter = [](const auto& use) {
        filters::all::for_each([&](const auto& filter) {
            if constexpr (detail::point_filter<std::decay_t<decltype(filter)>>) use(filter);
        });
    };
    int count = 0;
    for_each_filter([&](const auto&) { ++count; });
    int chosen = in.within(0, count - 1);
    for_each_filter([&](auto filter) {
        if (chosen-- == 0) {
            filter.is_lit.direction = direction;
            fuzz::answered([&] { compare(in, filter, depth32f{.direction = direction}, depths); });
            fuzz::answered([&] { compare(in, filter, rg<11>{.direction = direction}, depths); });
        }
    });
    return 0;
}
