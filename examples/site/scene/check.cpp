// SPDX-License-Identifier: MIT
//
// The picture's shadow once more, in C++: from the uniform block, the map and the receivers that the GPU had.
//
// JavaScript asks for room, fills it, and calls site_map and site_visibility; check_worker.ts does.
#include <cstddef>
#include <cstring>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <umbrage/core/image.hpp>
#include <umbrage/depth/encodings.hpp>
#include <umbrage/filter/filters.hpp>
#include <umbrage/shadow/adaptive_maps.hpp>
#include <umbrage/shadow/cascaded_maps.hpp>
#include <umbrage/shadow/cube_maps.hpp>
#include <umbrage/shadow/lookup.hpp>
#include <umbrage/shadow/shadow.hpp>
#include <umbrage/shadow/single_map.hpp>
#include <umbrage/shadow/warped_maps.hpp>

namespace {

using umbrage::map_place;
using umbrage::shadow_terms;

/// What was read back of the GPU, row 0 at the bottom, and what is made of it.
std::vector<glm::vec4> points;   ///< position of each receiver, and 1; 0 where the sky is
std::vector<glm::vec4> normals;  ///< its normal; zero for a lookup without the smallest bias
std::vector<glm::u8vec4> bytes;  ///< texels of a packed map
std::vector<glm::vec4> floats;   ///< texels of a map of floats
std::vector<float> visibility;
std::vector<glm::vec4> places;  ///< texel in the map, x and y, the map's number, and 1 where a map was read
umbrage::image<float> depths;   ///< the map, decoded
float block[320];

/// Any texel of at most four channels from the GPU's four.
template <class Texel>
Texel texel_of(const glm::u8vec4& read) {
    Texel texel{};
    std::memcpy(&texel, &read, sizeof texel < sizeof read ? sizeof texel : sizeof read);
    return texel;
}

umbrage::depth_direction direction_of(int reversed) {
    return reversed ? umbrage::depth_direction::reversed : umbrage::depth_direction::forward;
}

/// Calls use(filter) with the one of that number, in the order of the package's list.
template <class Use>
void with_filter(int number, const Use& use) {
    int n = 0;
    const auto one = [&](const auto& filter) {
        if constexpr (umbrage::shadow_filter<std::decay_t<decltype(filter)>>)
            if (n++ == number) use(filter);
    };
    umbrage::filters::all::for_each(one);
    umbrage::filters::soft::for_each(one);
}

template <class Setup, class Filter>
void look_up_all(Filter filter, umbrage::depth_direction direction, int width) {
    umbrage::shadow_uniforms<Setup, umbrage::detail::softness_matrices<Setup, Filter>> uniforms;
    std::memcpy(&uniforms, block, sizeof uniforms);
    const auto& maps = uniforms.maps;
    const shadow_terms& terms = uniforms.terms;
    filter = umbrage::detail::with_packed_numbers(filter, terms.filter_terms);
    filter.direction = direction;
    const umbrage::depth32f stored{.direction = direction};
    const glm::ivec2 map_size(terms.map_size);
    for (std::size_t i = 0; i < points.size(); ++i) {
        visibility[i] = 1.0f;
        places[i] = glm::vec4(0.0f);
        if (points[i].w == 0.0f) continue;
        const glm::ivec2 pixel(static_cast<int>(i) % width, static_cast<int>(i) / width);
        const auto look = [&](const map_place& place) {
            if (place.at.x == umbrage::outside_all_maps) return 1.0f;
            const auto own = umbrage::image_view<const float>(depths).region(
                umbrage::detail::first_texel(place.number, Setup::grid, map_size), map_size);
            const glm::vec3 receiver = umbrage::detail::receiver_of<Setup, Filter>(terms, place, direction);
            places[i] = glm::vec4(place.at.x, place.at.y, static_cast<float>(place.number), 1.0f);
            const Filter in_map = umbrage::detail::filter_of_map<Setup>(filter, uniforms, place.number);
            const auto by = [&](const auto& f) {
                return umbrage::detail::look<Setup, Filter>(own, f, stored, receiver, place.slope, pixel);
            };
            if constexpr (umbrage::detail::has_shapes<Setup, Filter> && !std::is_same_v<Setup, umbrage::single_map>)
                return by(umbrage::detail::shaped<Setup>(in_map, uniforms, place.number));
            else return by(in_map);
        };
        const auto of_point = Setup::places(maps, terms, glm::vec3(points[i]), glm::vec3(normals[i]));
        visibility[i] = umbrage::detail::blended(of_point, look);
    }
}

}  // namespace

extern "C" {

/// Memory for `count` values: 0 points, 1 normals, 2 texels of bytes, 3 texels of floats, 4 visibility, 5 places.
void* site_room(int what, int count) {
    const auto room = [count](auto& all) -> void* {
        all.resize(static_cast<std::size_t>(count));
        return all.data();
    };
    switch (what) {
        case 0: return room(points);
        case 1: return room(normals);
        case 2: return room(bytes);
        case 3: return room(floats);
        case 4: return room(visibility);
        default: return room(places);
    }
}

/// The uniform block: at most 320 floats.
float* site_block() { return block; }

/// Decodes the texels in the encoding of a number, in the order of the package's list.
void site_map(int encoding, int reversed, int width, int height) {
    depths = umbrage::image<float>({width, height});
    int n = 0;
    umbrage::for_each_encoding([&](auto e) {
        if (n++ != encoding) return;
        umbrage::detail::set_direction(e, direction_of(reversed));
        using texel = typename std::decay_t<decltype(e)>::texel;
        const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        for (std::size_t i = 0; i < count; ++i) {
            float& depth = depths.view().data[i];
            if constexpr (std::is_same_v<texel, float>) depth = floats[i].x;
            else depth = e.decode(texel_of<texel>(bytes[i]));
        }
    });
}

/// Visibility and place of every receiver, in a picture of that width. Kinds and filters are counted as in the
/// package's lists.
void site_visibility(int kind, int filter, int reversed, int width) {
    const auto direction = direction_of(reversed);
    with_filter(filter, [&](const auto& f) {
        if (kind <= 1) look_up_all<umbrage::single_map>(f, direction, width);
        if (kind == 2) look_up_all<umbrage::cascaded_maps<>>(f, direction, width);
        if (kind == 4) look_up_all<umbrage::cube_maps>(f, direction, width);
        if (kind == 7) look_up_all<umbrage::warped_maps>(f, direction, width);
        if (kind == 8) look_up_all<umbrage::adaptive_maps>(f, direction, width);
    });
}
}
