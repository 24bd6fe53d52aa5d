// SPDX-License-Identifier: MIT
//
// Shadow of a light as one value: light setup, map size, filter and encoding. It computes the bias, the border, the
// direction of depth and the error of its texels.
//
//     const umbrage::shadow sun(light, {1024, 1024}, umbrage::filters::tent<3>);
//     umbrage::image<float> map(sun.size(), sun.cleared());  // on the CPU; a GPU has its own texture
//     sun.draw(map, {positions, triangles});
//     float visibility = sun(map, world, normal);            // 1 lit
//
// in_shader.hpp writes the same shadow as a shader function, which gives the same bits where its parts do.
// These functions are its steps: texture_matrix, shadow_coordinate, project_coordinate, receiver_slope, acne_free_bias,
// biased, and the filter on bordered(map).
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/bias/constant.hpp>
#include <umbrage/core/check.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/core/lesser.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/images/encode.hpp>
#include <umbrage/images/parallel.hpp>
#include <umbrage/images/plane_visibility.hpp>
#include <umbrage/images/prefilter.hpp>
#include <umbrage/images/rasterize.hpp>
#include <umbrage/images/visibility.hpp>
#include <umbrage/shadow/look.hpp>
#include <umbrage/shadow/set_up.hpp>
#include <umbrage/shadow/single_map.hpp>

namespace umbrage {

/// Origin of a frame in the world. A shader gets positions relative to it.
struct frame_origin {
    glm::dvec3 origin{0};
};

/// Uniform block of a shadow's shader: copy its bytes into the buffer.
template <shadow_set_up SetUp>
struct shadow_uniforms {
    typename SetUp::uniforms maps;
    shadow_terms terms;
};

namespace detail {

/// Checks the clip space, the map size and the filter of a shadow.
template <class Filter>
void require_shadow(const clip_space& clip, glm::ivec2 map_size, const Filter& filter) {
    require_given(clip, "shadow", "light.clip");
    require(map_size.x >= 1 && map_size.y >= 1, "shadow", "map_size", "above 0", map_size);
    require_filter("shadow", filter);
    const float reach = reach_of(filter);
    require(2.0f * reach <= static_cast<float>(lesser(map_size.x, map_size.y)), "shadow", "map_size",
            "twice the filter's reach or more", map_size,
            "The filter reaches " + printed(reach) + " texels to each side.");
}

/// Checks that the size of all maps together is an int, and that each continues as far as the filter reaches.
template <shadow_set_up SetUp>
void require_maps(const SetUp& set_up, glm::ivec2 map_size, float reach) {
    constexpr map_grid grid = SetUp::grid;
    require(map_size.x <= highest<int> / grid.columns && map_size.y <= highest<int> / grid.rows, "shadow", "map_size",
            "such that all maps together have less than 2^31 texels a side", map_size);
    if constexpr (requires { set_up.require_reach(reach); }) set_up.require_reach(reach);
}

/// Refuses uniforms that are infinite or NaN in float.
inline void require_finite_uniforms(std::span<const float> uniforms) {
    for (const float number : uniforms)
        require(is_finite(number), "shadow", "light, filter and origin", "such that all uniforms are finite in float",
                number, "Tiny near planes and huge coordinates overflow.");
}

/// Gives an encoding the light's direction. An edge at its default changes with it; any other edge stays.
void set_direction(auto& encoding, depth_direction direction) {
    if constexpr (requires { encoding.edge; })
        if (encoding.edge == safe_edge(encoding.direction)) encoding.edge = safe_edge(direction);
    encoding.direction = direction;
}

/// Terms at the end of a uniform block, from a filter and the error of its map's depths.
template <class Filter>
[[nodiscard]] shadow_terms make_shadow_terms(glm::ivec2 map_size, const Filter& filter, decoding_error off,
                                             depth_direction direction, bent_lines bends) {
    const float size = static_cast<float>(greater(map_size.x, map_size.y));
    const float more = rasterizer_snap<float> + 0x1p-24f * size + bends.reach;  // 2^-24 size: a coordinate's rounding
    const double error = direction == depth_direction::forward ? off.below : off.above;
    return {glm::vec2(map_size), reach_of(filter) + more, static_cast<float>(error) + 0x1p-22f + bends.error,
            terms_of(filter, more)};
}

}  // namespace detail

/// Shadow of a light: draws its maps, and returns the visibility of receivers.
///
/// @tparam SetUp      setup of the light's maps, deduced from the light
/// @tparam Filter     filter of the lookup
/// @tparam Encoding   encoding of depths in the map
template <shadow_set_up SetUp, class Filter, class Encoding = typename detail::encoding_for<Filter>::type>
class shadow {
    static_assert(detail::shadow_takes<Filter, Encoding>());

public:
    using texel = typename Encoding::texel;
    using uniforms_type = shadow_uniforms<SetUp>;
    static_assert(!detail::contact_hardening<Filter> || detail::bends_of<SetUp>().reach == 0.0f,
                  "contact hardening compares along planes, which paraboloids bend: take another set-up, or a disc");
    static_assert(detail::has_fields<SetUp>(), "a set-up's `fields` name its `uniforms`, in their order");

    /// @param light      a light_space, an array of cascades, a point_light, or a setup of your own
    /// @param map_size   size of one map, texels, each >= 1
    /// @param filter     one of filters:: or prefilters::. It gets the light's direction of depth
    /// @param encoding   encoding of depths in the map. It gets the light's direction. A prefilter's map holds moments
    /// @throws std::invalid_argument  a light whose clip space is unset, or that has no maps. A map_size below 1, less
    ///                                than twice the filter's reach, too large for size(), or refused by the setup. A
    ///                                filter's number out of range
    template <class Light>
    shadow(const Light& light, glm::ivec2 map_size, const Filter& filter = {}, const Encoding& encoding = {})
        : set_up_(light), map_size_(map_size), filter_(filter), encoding_(encoding) {
        detail::set_direction(encoding_, set_up_.clip().direction);
        if constexpr (prefilter<Filter>) filter_.direction = encoding_.direction;
        else filter_.is_lit.direction = encoding_.direction;
        detail::require_shadow(set_up_.clip(), map_size, filter_);
        detail::require_maps(set_up_, map_size, detail::reach_of(filter_));
        uniforms_ = uniforms();
    }

    [[nodiscard]] const SetUp& set_up() const { return set_up_; }
    [[nodiscard]] const Filter& filter() const { return filter_; }
    [[nodiscard]] const Encoding& encoding() const { return encoding_; }

    /// Size of the image or texture that holds all maps, texels.
    [[nodiscard]] glm::ivec2 size() const { return map_size_ * glm::ivec2(SetUp::grid.columns, SetUp::grid.rows); }
    /// Size of one map, and of a texture array, texels.
    [[nodiscard]] glm::ivec2 map_size() const { return map_size_; }
    /// Texel of an empty map: the far plane's.
    [[nodiscard]] texel cleared() const {
        if constexpr (prefilter<Filter>) return filter_.encode(cleared_depth(encoding_.direction));
        else return encoding_.cleared();
    }

    /// Draws a mesh into the depths of all maps, each with its own view. The depth nearest to the light stays.
    /// @param depths   image of size(), cleared to cleared_depth of the light's clip space, or from an earlier draw
    /// @param mesh     casters, world units
    /// @param parallel cuts the rows into pieces, see parallel.hpp
    /// @throws std::invalid_argument  depths of another size; arguments that rasterize_depth refuses
    template <class ParallelFor = serial>
    void draw(image_view<float> depths, const mesh_view& mesh, ParallelFor&& parallel = {}) const {
        detail::require_size(depths.size, size(), "shadow::draw", "depths.size", "the shadow's size()");
        if constexpr (requires { set_up_.draw(depths, mesh, parallel); }) set_up_.draw(depths, mesh, parallel);
        else {
            const auto lights = set_up_.lights();
            for (std::size_t i = 0; i < lights.size(); ++i)
                rasterize_depth(depths.region(detail::first_texel(int(i), SetUp::grid, map_size_), map_size_), mesh,
                                glm::mat4(lights[i].projection * lights[i].view), lights[i].clip, cull_mode::none,
                                parallel);
        }
    }

    /// Encodes drawn depths as texels of the map. Then blur a prefilter's map, one map at a time (blur.hpp).
    /// @throws std::invalid_argument  depths or a map of another size
    template <class ParallelFor = serial>
    void store(image_view<const float> depths, image_view<texel> map, ParallelFor&& parallel = {}) const {
        detail::require_size(map.size, size(), "shadow::store", "map.size", "the shadow's size()");
        if constexpr (prefilter<Filter>) encode_moments(depths, map, filter_, parallel);
        else encode(depths, map, encoding_, parallel);
    }

    /// Visibility of a receiver.
    /// @param map      image of size(), texels of the encoding, drawn for this light
    /// @param world    world position of the receiver
    /// @param normal   surface normal, any length, for the smallest bias on its plane. Zero: a slope of 0, for maps
    ///                 whose depth pass was biased (make_polygon_offset)
    /// @param pixel    pixel that decides the rotation of discs and contact hardening
    /// @return         visibility in [0, 1]: 0 in shadow, 1 lit
    /// @edge           outside all maps, behind the light, beyond the far plane, or a NaN position: 1
    /// @throws std::invalid_argument  a map of another size
    /// @exactness      that of its weakest part: C, as project_coordinate; cascades B
    [[nodiscard]] float operator()(image_view<const texel> map, glm::vec3 world, glm::vec3 normal,
                                   glm::ivec2 pixel = {}) const {
        detail::require_size(map.size, size(), "shadow", "map.size", "the shadow's size()");
        return SetUp::visibility(uniforms_.maps, uniforms_.terms, world, normal, [&](const map_place& place) {
            const auto own = map.region(detail::first_texel(place.number, SetUp::grid, map_size_), map_size_);
            return detail::look<SetUp::outside>(own, filter_, encoding_, receiver(place), place.slope, pixel);
        });
    }

    /// Visibility of an image of receivers.
    /// @param points            image with world of operator() in each pixel
    /// @param normals           image of the same size, with normal of operator()
    /// @param map               image of size(), texels of the encoding
    /// @param out               receives visibility, 1 lit; same size as points, other memory than the map
    /// @param parallel          cuts the rows into pieces, see parallel.hpp
    /// @throws std::invalid_argument  images of different sizes; a map of another size
    template <class ParallelFor = serial>
    void visibility(image_view<const texel> map, image_view<const glm::vec3> points,
                    image_view<const glm::vec3> normals, image_view<float> out, ParallelFor&& parallel = {}) const;

    /// Largest difference of depth between a caster and a point at which the bias may detach the shadow
    /// (peter-panning). A caster nearer to the light, if as steep as the surface, darkens the point fully.
    /// light_units_at converts it to world units.
    /// @return   difference of depth from 0 to 1, in the point's map. The larger one if two maps blend
    [[nodiscard]] float peter_panning_distance(glm::vec3 world, glm::vec3 normal) const
        requires(!prefilter<Filter> && !detail::contact_hardening<Filter>) {
        float distance = 0.0f;
        static_cast<void>(
            SetUp::visibility(uniforms_.maps, uniforms_.terms, world, normal, [&](const map_place& place) {
                shadow_terms terms = uniforms_.terms;
                terms.error += detail::bias_of<Filter>(terms, place.slope);
                distance = detail::greater(distance, detail::bias_of<Filter>(terms, place.slope));
                return 0.0f;
            }));
        return distance;
    }

    /// Uniform block for the shader of in_shader.hpp.
    /// @param frame   origin of the shader's positions. Far from the world's origin pass the camera's position, and
    ///                make the light in double
    /// @throws std::invalid_argument  uniforms that would be infinite or NaN in float
    [[nodiscard]] uniforms_type uniforms(frame_origin frame = {}) const {
        const uniforms_type all{set_up_.make_uniforms(map_size_, frame.origin),
                                detail::make_shadow_terms(map_size_, filter_, encoding_.error(), encoding_.direction,
                                                          detail::bends_of<SetUp>())};
        std::array<float, sizeof all / sizeof(float)> numbers;
        std::memcpy(numbers.data(), &all, sizeof all);
        detail::require_finite_uniforms(numbers);
        return all;
    }

private:
    /// Coordinate of a place, in texels, and its depth with the bias applied.
    [[nodiscard]] glm::vec3 receiver(const map_place& place) const {
        const comparison is_lit{encoding_.direction};
        const float bias = detail::bias_of<Filter>(uniforms_.terms, place.slope);
        return {place.at.x, place.at.y, biased(place.at.z, bias, is_lit)};
    }

    SetUp set_up_;
    glm::ivec2 map_size_;
    Filter filter_;
    Encoding encoding_;
    uniforms_type uniforms_{};
};

template <class Light, class Filter, class Encoding = typename detail::encoding_for<Filter>::type>
shadow(const Light&, glm::ivec2, const Filter&, const Encoding& = {})
    -> shadow<typename set_up_for<Light>::type, Filter, Encoding>;

template <shadow_set_up SetUp, class Filter, class Encoding>
template <class ParallelFor>
void shadow<SetUp, Filter, Encoding>::visibility(image_view<const texel> map, image_view<const glm::vec3> points,
                                                 image_view<const glm::vec3> normals, image_view<float> out,
                                                 ParallelFor&& parallel) const {
    constexpr auto function = "shadow::visibility";
    detail::require_size(map.size, size(), function, "map.size", "the shadow's size()");
    detail::require_size(normals.size, points.size, function, "normals.size", "the size of points");
    detail::require_size(out.size, points.size, function, "out.size", "the size of points");
    if constexpr (requires { SetUp::place(uniforms_.maps, glm::vec3(), glm::vec3()); }) {
        // One lookup per receiver: finds all places first, then filters them by the filter's fast form.
        const auto for_each_place = [&](const auto& use) {
            parallel(out.size.y, [&](int first, int last) {
                for (glm::ivec2 p{0, first}; p.y < last; ++p.y)
                    for (p.x = 0; p.x < out.size.x; ++p.x) use(p, SetUp::place(uniforms_.maps, points[p], normals[p]));
            });
        };
        if constexpr (detail::contact_hardening<Filter>) {
            image<float> x(points.size), y(points.size), depth(points.size), slope_x(points.size), slope_y(points.size);
            for_each_place([&](glm::ivec2 p, const map_place& place) {
                const glm::vec3 r = receiver(place);
                x[p] = r.x, y[p] = r.y, depth[p] = r.z, slope_x[p] = place.slope.x, slope_y[p] = place.slope.y;
            });
            umbrage::visibility(map, encoding_, sloped_receivers{{x, y, depth}, slope_x, slope_y}, filter_, out,
                                parallel, SetUp::outside);
        } else {
            image<glm::vec3> receivers(points.size);
            for_each_place([&](glm::ivec2 p, const map_place& place) { receivers[p] = receiver(place); });
            if constexpr (prefilter<Filter>)
                umbrage::visibility(map, filter_, receivers, out, parallel, SetUp::outside);
            else umbrage::visibility(map, encoding_, receivers, filter_, out, parallel, SetUp::outside);
        }
    } else {
        parallel(out.size.y, [&](int first, int last) {
            for (glm::ivec2 p{0, first}; p.y < last; ++p.y)
                for (p.x = 0; p.x < out.size.x; ++p.x) out[p] = (*this)(map, points[p], normals[p], p);
        });
    }
}

}  // namespace umbrage
