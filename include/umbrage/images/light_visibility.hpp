// SPDX-License-Identifier: MIT
//
// A whole image of points in the world against a light of several maps: cascades, a cube, a tetrahedron or two
// paraboloids. Each point chooses its map and its place in it.
//
//     umbrage::light_map map{atlas, umbrage::make_cascade_uniforms(cascades, 0.1f)};  // 2 x 2 tiles: cascade_tile
//     umbrage::visibility(map, umbrage::depth32f{}, points, umbrage::filters::pcf_2x2{}, out);
//
//     umbrage::point_light<float> lamp{.position = p, .map_size = 512, .border = 2, .clip = clip};
//     umbrage::light_map of_lamp{faces, lamp};  // 3 x 2 tiles: cube_tile
//
// Points are biased as points: moved towards the light, or off the surface (normal_offset).
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/clip_space.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/depth/conversions.hpp>
#include <umbrage/images/visibility.hpp>
#include <umbrage/light/cascades/cascades.hpp>
#include <umbrage/light/cascades/select.hpp>
#include <umbrage/light/point/cube_map.hpp>
#include <umbrage/light/point/dual_paraboloid.hpp>
#include <umbrage/light/point/point_light.hpp>
#include <umbrage/light/point/tetrahedron_light.hpp>
#include <umbrage/light/texture_matrix.hpp>

namespace umbrage {

/// The maps of a light in one image.
/// @tparam Light   cascade_uniforms<float>: 2 x 2 tiles, those of no cascade unused; grouped_cascade_uniforms<float, N>:
///                 two tiles a row; point_light<float>: 3 x 2 tiles, cube_tile; tetrahedron_light<float>: one square;
///                 dual_paraboloid_light<float>: 2 x 1 tiles
template <class Texel, class Light>
struct light_map {
    image_view<const Texel> texels;
    Light light;
};
template <class Texel, class Light>
light_map(const image<Texel>&, Light) -> light_map<Texel, Light>;
template <class Texel, class Light>
light_map(image_view<Texel>, Light) -> light_map<std::remove_const_t<Texel>, Light>;

namespace detail {

/// Where a point is looked up.
struct placed_receiver {
    glm::ivec2 tile;  ///< its first texel
    glm::vec3 at;     ///< in texels of the tile, depth
};

/// The first cascade that holds a point and its filter, of groups of four; none: lit.
template <std::size_t Count>
struct cascade_placing {
    static constexpr int columns = 2, rows = static_cast<int>(Count + 1) / 2;  // of tiles
    glm::mat4 rotation;
    std::array<glm::mat4, (Count + 3) / 4> scales, offsets;
    glm::ivec2 size;
    float reach;

    template <class Uniforms>
    cascade_placing(const Uniforms& u, glm::ivec2 texels, float filter_reach)
        : rotation(u.rotation),
          scales{u.scales},
          offsets{u.offsets},
          size(texels / glm::ivec2(columns, rows)),
          reach(filter_reach) {}
    [[nodiscard]] placed_receiver operator()(glm::vec3 world) const {
        const glm::vec3 light(shadow_coordinate(rotation, world));
        glm::vec4 at(0.0f);
        int number = 0;
        for (std::size_t i = 0; i < scales.size() && number == static_cast<int>(4 * i); ++i) {
            at = cascade_by_projection(light, scales[i], offsets[i], glm::vec2(size), reach);
            number += static_cast<int>(at.w);
        }
        constexpr int last = static_cast<int>(Count) - 1;
        return {cascade_tile(number < last ? number : last, size), glm::vec3(at)};
    }
};

/// Faces with a projection each, of which a direction chooses one.
template <std::size_t Faces>
struct face_placing {
    glm::vec3 position;
    int size;
    std::array<glm::mat4, Faces> to_texels;

    face_placing(const std::array<light_space<float>, Faces>& faces, glm::vec3 from, int map_size)
        : position(from), size(map_size) {
        for (std::size_t i = 0; i < Faces; ++i) to_texels[i] = texture_matrix(faces[i], glm::ivec2(size));
    }
    [[nodiscard]] glm::vec3 on_face(int face, glm::vec3 world) const {
        return project_coordinate(shadow_coordinate(to_texels[static_cast<std::size_t>(face)], world));
    }
};
struct cube_placing : face_placing<6> {
    static constexpr int columns = 3, rows = 2;  // of tiles
    cube_placing(const point_light<float>& l, glm::ivec2, float)
        : face_placing<6>(make_point_light(l), l.position, l.map_size) {}
    [[nodiscard]] placed_receiver operator()(glm::vec3 world) const {
        const int face = cube_face(world - position);
        return {cube_tile(face, size), on_face(face, world)};
    }
};
struct tetrahedron_placing : face_placing<4> {
    static constexpr int columns = 1, rows = 1;  // of tiles
    tetrahedron_placing(const tetrahedron_light<float>& l, glm::ivec2, float)
        : face_placing<4>(make_tetrahedron_light(l), l.position, l.map_size) {}
    [[nodiscard]] placed_receiver operator()(glm::vec3 world) const {
        return {glm::ivec2(0), on_face(tetrahedron_face(world - position), world)};
    }
};
struct paraboloid_placing {
    static constexpr int columns = 2, rows = 1;  // of tiles
    dual_paraboloid_light<float> light;
    int size;

    paraboloid_placing(const dual_paraboloid_light<float>& l, glm::ivec2, float) : light(l), size(l.map_size) {
        static_cast<void>(make_dual_paraboloid_light(l));  // complains of what cannot be
    }
    [[nodiscard]] placed_receiver operator()(glm::vec3 world) const {
        const glm::vec3 way = world - light.position, at = dual_paraboloid_coordinate(way);
        const auto border = static_cast<float>(light.border), inner = static_cast<float>(size) - 2.0f * border;
        const float depth = distance_depth(way, 1.0f / light.range);
        return {{at.z > 0.5f ? size : 0, 0},
                {at.x * inner + border, at.y * inner + border,
                 light.clip.direction == depth_direction::forward ? depth : reverse_depth(depth)}};
    }
};

template <class Light>
struct placing_of;
template <std::size_t Count>
struct placing_of<grouped_cascade_uniforms<float, Count>> {
    using type = cascade_placing<Count>;
};
template <>
struct placing_of<cascade_uniforms<float>> {
    using type = cascade_placing<4>;
};
template <>
struct placing_of<point_light<float>> {
    using type = cube_placing;
};
template <>
struct placing_of<tetrahedron_light<float>> {
    using type = tetrahedron_placing;
};
template <>
struct placing_of<dual_paraboloid_light<float>> {
    using type = paraboloid_placing;
};

}  // namespace detail

/// Visibility of points from a light of several maps.
///
/// @param map         its texels, and the light that they were drawn for
/// @param encoding    how the texels hold depth, and which way it runs; its edge decides ties
/// @param points      in the world, biased; what no cascade holds is lit, NaN too
/// @param filter      as for visibility of a single map. Texels beyond a tile are clamped to it: take the filter's
///                    reach as the light's border
/// @param out         visibility, 1 lit; same size as points
/// @param parallel    cuts the rows into pieces, see parallel.hpp
/// @throws std::invalid_argument  sizes differ, texels of another size than the light's tiles, and what the light's
///                                make_ function complains of
/// @exactness         the bits of the filter over each point's map: cascade_by_projection; cube_face or
///                    tetrahedron_face and that face's texture_matrix; dual_paraboloid_coordinate and distance_depth
template <class Encoding, class Light, class Filter, class ParallelFor = serial>
void visibility(const light_map<typename Encoding::texel, Light>& map, const Encoding& encoding,
                image_view<const glm::vec3> points, const Filter& filter, image_view<float> out,
                ParallelFor&& parallel = {}) {
    static_assert(detail::is_encoding<Encoding>() && detail::is_filter<Filter>());
    constexpr auto function = "visibility";
    detail::require_size(out.size, points.size, function, "out.size", "the size of points");
    float reach = 0.0f;
    if constexpr (requires { filter.reach(); }) reach = filter.reach();
    using placing = typename detail::placing_of<Light>::type;
    const placing place(map.light, map.texels.size, reach);
    const glm::ivec2 tile_size(place.size), tiles(placing::columns, placing::rows);
    detail::require(tile_size.x >= 1 && tile_size.y >= 1, function, "map.texels.size", "that of the light's tiles",
                    map.texels.size);
    detail::require_size(map.texels.size, tiles * tile_size, function, "map.texels.size", "that of the light's tiles");
    const auto& directed = detail::in_direction(filter, detail::direction_of(encoding, filter));
    parallel(out.size.y, [&](int first, int last) {
        for (glm::ivec2 p{0, first}; p.y < last; ++p.y)
            for (p.x = 0; p.x < out.size.x; ++p.x) {
                const detail::placed_receiver r = place(points[p]);
                const auto tile = map.texels.region(r.tile, tile_size);
                out[p] = detail::filtered(directed, decoded(clamped(tile), encoding), glm::vec2(r.at), r.at.z, p);
            }
    });
}

}  // namespace umbrage
