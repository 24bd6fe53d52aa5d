// SPDX-License-Identifier: MIT
//
// Visibility of whole images: each receiver has the bits that the filter gives it alone, and lies within 0 and 1. Every
// filter over floats, every encoding, every kind of receiver.
#include <type_traits>

#include <umbrage/core/image.hpp>
#include <umbrage/depth/encodings.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/images/encode.hpp>
#include <umbrage/images/plane_visibility.hpp>
#include <umbrage/images/visibility.hpp>
#include <umbrage/shadow/lookup.hpp>

#include "input.hpp"

namespace {

using namespace umbrage;

/// Receivers of an image in all four forms: x, y and depth, with slopes of their planes.
struct receiver_images {
    image<float> x, y, depth, slope_x, slope_y;

    receiver_images(fuzz::input& in, glm::ivec2 size, glm::vec2 reach)
        : x(size), y(size), depth(size), slope_x(size), slope_y(size) {
        for (float& v : x.texels()) v = in.number(-3, reach.x + 3);
        for (float& v : y.texels()) v = in.number(-3, reach.y + 3);
        for (float& v : depth.texels()) v = in.number(-0.1f, 1.1f);
        for (float& v : slope_x.texels()) v = in.number(-0.1f, 0.1f);
        for (float& v : slope_y.texels()) v = in.number(-0.1f, 0.1f);
    }
    [[nodiscard]] glm::vec3 operator[](glm::ivec2 p) const { return {x[p], y[p], depth[p]}; }
};

/// Runs a filter over an image, and over each receiver alone.
/// @param at       (pixel) -> receiver
/// @param slope    (pixel) -> slope of its plane, or nullptr
template <class Encoding, class Filter, class Receivers, class At, class Slope>
void compare(fuzz::input& in, image_view<const float> depths, const Encoding& encoding, const Receivers& receivers,
             glm::ivec2 size, const Filter& filter, const At& at, const Slope& slope) {
    image<typename Encoding::texel> map(depths.size);
    encode(depths, map, encoding);
    const auto outside = in.chance(2) ? outside_map::bordered : outside_map::clamped;
    image<float> out(size);
    visibility(map, encoding, receivers, filter, out, fuzz::pieces(in), outside);
    for (glm::ivec2 p(0); p.y < size.y; ++p.y)
        for (p.x = 0; p.x < size.x; ++p.x) {
            const glm::vec3 r = at(p);
            const auto alone = [&](const auto& map_texels) {
                const auto texels = decoded(map_texels, encoding);
                if constexpr (std::is_null_pointer_v<Slope>)
                    return detail::filtered(filter, texels, glm::vec2(r), r.z, p);
                else
                    return detail::filtered(filter, apply_receiver_plane(texels, slope(p), r, encoding.direction),
                                            glm::vec2(r), r.z, p);
            };
            const float one =
                outside == outside_map::bordered ? alone(bordered(map, encoding.cleared())) : alone(clamped(map));
            fuzz::must(fuzz::same(out[p], one), "an image's receiver has the bits of the filter alone");
            fuzz::must(one >= 0.0f && one <= 1.0f, "a visibility lies within 0 and 1");
        }
}

template <class Encoding, class Filter>
void by_points(fuzz::input& in, image_view<const float> depths, const receiver_images& all, const Encoding& encoding,
               const Filter& filter) {
    image<glm::vec3> points(all.x.size());
    for (std::size_t i = 0; i < points.texels().size(); ++i)
        points.texels()[i] = {all.x.texels()[i], all.y.texels()[i], all.depth.texels()[i]};
    compare(
        in, depths, encoding, points.view(), points.size(), filter, [&](glm::ivec2 p) { return all[p]; }, nullptr);
}

void by_planes(fuzz::input& in, image_view<const float> depths, const receiver_images& all, const depth32f& encoding) {
    const receiver_planes planes{all.x, all.y, all.depth};
    compare(
        in, depths, encoding, planes, all.x.size(), filters::box{in.within(0, 6), encoding.direction},
        [&](glm::ivec2 p) { return all[p]; }, nullptr);
}

void by_depths(fuzz::input& in, image_view<const float> depths, const receiver_images& all, const depth32f& encoding) {
    depth_receivers seen{all.depth, glm::mat4(1), in.number(0, 0.1f)};
    for (glm::length_t i = 0; i < 16; ++i)
        if (in.chance(3)) seen.matrix[i / 4][i % 4] = in.number(-1, 1);
    compare(
        in, depths, encoding, seen, all.depth.size(), filters::hard{.direction = encoding.direction},
        [&](glm::ivec2 p) { return receiver_at(seen, p); }, nullptr);
}

template <class Filter>
void along_planes(fuzz::input& in, image_view<const float> depths, const receiver_images& all, const depth32f& encoding,
                  const Filter& filter) {
    const sloped_receivers sloped{{all.x, all.y, all.depth}, all.slope_x, all.slope_y};
    compare(
        in, depths, encoding, sloped, all.x.size(), filter, [&](glm::ivec2 p) { return all[p]; },
        [&](glm::ivec2 p) { return glm::vec2(all.slope_x[p], all.slope_y[p]); });
}

/// Calls a filter alone, which takes any numbers.
template <class Filter>
Filter alone_first(fuzz::input& in, const Filter& filter) {
    const auto map = [](glm::ivec2 t) { return static_cast<float>((t.x ^ t.y) & 15) / 15.0f; };
    const float one =
        detail::filtered(filter, map, {in.number(-9, 9), in.number(-9, 9)}, in.number(0, 1), glm::ivec2(3));
    fuzz::must(one >= 0.0f && one <= 1.0f, "a visibility of any numbers lies within 0 and 1");
    return filter;
}

template <class Filter>
constexpr bool is_soft = std::is_same_v<Filter, filters::pcss> || std::is_same_v<Filter, filters::dpcf>;

/// Gives a filter settings such as functions over images refuse.
template <class Filter>
void spoil(fuzz::input& in, Filter& filter) {
    if constexpr (is_soft<Filter>) {
        filter.points = 8 * in.within(-1, 5);
        filter.softness = {in.number(-1, 4096), in.number(-1, 4096), in.number(-9, 99), in.number(-9, 99)};
    } else if constexpr (std::is_same_v<Filter, filters::disc>) {
        filter.points = 8 * in.within(-1, 5);
        filter.radius_texels = in.number(-1, 6);
    } else if constexpr (std::is_same_v<Filter, filters::window>)
        filter.row.size = in.chance(2) ? in.within(-9, 0) : in.within(16, 99);  // others are undefined alone
}

/// A filter with settings of its own, now and then such as functions over images refuse.
template <class Filter>
Filter varied(fuzz::input& in, Filter filter) {
    if (in.chance(8)) {
        spoil(in, filter);
        return alone_first(in, filter);
    }
    if constexpr (is_soft<Filter>)
        filter.softness = {in.tame(0, 1), in.tame(0, 1), static_cast<float>(in.within(0, 32)),
                           static_cast<float>(in.within(32, 128))};
    else if constexpr (std::is_same_v<Filter, filters::disc>) filter.radius_texels = in.tame(0, 6);
    else if constexpr (std::is_same_v<Filter, filters::box>) filter.radius = in.within(0, 6);
    return filter;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    fuzz::input in(bytes, size);
    image<float> depths({in.within(1, 80), in.within(1, 20)});
    const int coarse = in.within(1, 100);
    std::uint32_t state = in.bits();
    for (float& d : depths.texels()) {
        state = state * 1664525u + 1013904223u;
        d = static_cast<float>(static_cast<int>(state >> 8) % (coarse + 1)) / static_cast<float>(coarse);
    }
    const auto direction = in.chance(2) ? depth_direction::forward : depth_direction::reversed;
    const receiver_images receivers(in, {in.within(1, 70), in.within(1, 3)}, glm::vec2(depths.size()));
    const depth32f floats{.direction = direction};
    const auto one_of = [&](const auto& use_each, const auto& use) {
        int count = 0;
        use_each([&](const auto&) { ++count; });
        int left = in.within(0, count - 1);
        use_each([&](const auto& value) {
            if (left-- == 0) fuzz::answered([&] { use(value); });
        });
    };
    switch (in.within(0, 5)) {
        case 0:
            one_of([](const auto& use) { for_each_encoding(use); },
                   [&](auto encoding) {
                       encoding = {.direction = direction};
                       by_points(in, depths, receivers, encoding, filters::hard{.direction = direction});
                   });
            break;
        case 1: fuzz::answered([&] { by_planes(in, depths, receivers, floats); }); break;
        case 2: fuzz::answered([&] { by_depths(in, depths, receivers, floats); }); break;
        case 3:
            one_of([](const auto& use) { filters::soft::for_each(use); },
                   [&](const auto& of_list) {
                       auto filter = varied(in, of_list);
                       filter.direction = direction;
                       along_planes(in, depths, receivers, floats, filter);
                   });
            break;
        default:
            one_of([](const auto& use) { filters::all::for_each(use), filters::soft::for_each(use); },
                   [&](const auto& of_list) {
                       auto filter = varied(in, of_list);
                       if constexpr (requires { filter.direction = direction; }) filter.direction = direction;
                       else if (direction == depth_direction::reversed) return;  // compares forward depth alone
                       by_points(in, depths, receivers, floats, filter);
                   });
    }
    return 0;
}
