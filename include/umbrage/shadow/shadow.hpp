// SPDX-License-Identifier: MIT
//
// Shadow of a light as one value: light setup, map size, filter and encoding. It computes the bias, the border, the
// direction of depth and the error of its texels.
//
//     const umbrage::shadow sun(light, {1024, 1024}, umbrage::filters::tent<3>);
//     umbrage::image<float> map(sun.size(), sun.cleared());  // on the CPU; a GPU has its own texture
//     sun.draw(map, {positions, triangles});
//     sun.draw(map, tree, model_matrices);                   // a forest
//     float visibility = sun(map, world, normal);            // 1 lit
//
// in_shader.hpp writes the same shadow as a shader function, which gives the same bits where its parts do.
// These functions are its steps: `make_anchored_map`, `anchored_place`, biased by the place's slack, and the filter on
// `apply_receiver_plane` of `bordered(map)`.
#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/bias/constant.hpp>
#include <umbrage/core/check.hpp>
#include <umbrage/core/image.hpp>
#include <umbrage/core/parallel.hpp>
#include <umbrage/core/scalar.hpp>
#include <umbrage/draw/rasterize.hpp>
#include <umbrage/filter/filter.hpp>
#include <umbrage/images/encode.hpp>
#include <umbrage/images/prefilter.hpp>
#include <umbrage/shadow/anchored_map.hpp>
#include <umbrage/shadow/clamped_casters.hpp>
#include <umbrage/shadow/frame.hpp>
#include <umbrage/shadow/lookup.hpp>
#include <umbrage/shadow/place_images.hpp>
#include <umbrage/shadow/setup.hpp>
#include <umbrage/shadow/single_map.hpp>
#include <umbrage/shadow/softness.hpp>
#include <umbrage/shadow/uniform_block.hpp>

namespace umbrage {

namespace detail {

/// Checks the clip space, the map size and the filter of a shadow.
template <class Filter>
void require_shadow(const clip_space& clip, glm::ivec2 map_size, const Filter& filter) {
    require_given(clip, "shadow", "light.clip");
    require(clip.subpixel_bits >= 3 && clip.subpixel_bits <= 16, "shadow", "light.clip.subpixel_bits", "from 3 to 16",
            clip.subpixel_bits);
    require(map_size.x >= 1 && map_size.y >= 1, "shadow", "map_size", "above 0", map_size);
    require(map_size.x <= 32768 && map_size.y <= 32768, "shadow", "map_size", "32768 or less", map_size,
            "Filters take coordinates of 32768 texels or more as outside the map.");
    require_filter("shadow", filter);
    const float reach = reach_of(filter);
    require(2.0f * reach <= static_cast<float>((glm::min)(map_size.x, map_size.y)), "shadow", "map_size",
            "twice the filter's reach or more", map_size,
            "The filter reaches " + printed(reach) + " texels to each side.");
}

/// True for a setup with its own depth pass, which may draw several lights into one map.
template <class Setup>
inline constexpr bool has_own_draw = requires(const Setup& s, image_view<float> depths, const mesh_view& mesh,
                                              std::span<const glm::mat4> instances, const serial& parallel) {
    s.draw(depths, mesh, instances, glm::dvec3(0), parallel);
};

/// Checks the grid and the maps. The grid has a map for each light, and each map continues as far as the filter
/// reaches.
template <shadow_setup Setup>
void require_maps(const Setup& setup, float reach) {
    constexpr map_grid grid = Setup::grid;
    const std::size_t lights = setup.lights().size(), maps = std::size_t(grid.columns) * std::size_t(grid.rows);
    require(has_own_draw<Setup> || lights <= maps, "shadow", "light.lights()",
            "as many as the setup's grid has maps, at most", lights);
    if constexpr (requires { setup.require_reach(reach); }) setup.require_reach(reach);
}

/// Views of a setup's depth passes.
template <shadow_setup Setup>
[[nodiscard]] std::vector<depth_view> depth_views_of(const Setup& setup, glm::dvec3 origin) {
    std::vector<depth_view> all;
    for (const light_space<double>& light : setup.lights())
        if constexpr (has_bent_lines<Setup>) all.push_back(make_bent_view(light, origin));
        else if constexpr (requires { setup.anchor(); })
            all.push_back(depth_view_at(in_binary32(setup.anchor() - origin), relative_to(origin, light)));
        else all.push_back(make_depth_view(light, origin));
    return all;
}

/// Gives an encoding the light's direction. An edge at its default changes with it; any other edge stays.
void set_direction(auto& encoding, depth_direction direction) {
    if constexpr (requires { encoding.edge; })
        if (encoding.edge == safe_edge(encoding.direction)) encoding.edge = safe_edge(direction);
    encoding.direction = direction;
}

}  // namespace detail

/// Shadow of a light: draws its maps, and returns the visibility of receivers.
///
/// @tparam Setup      setup of the light's maps, deduced from the light
/// @tparam Filter     filter of the lookup
/// @tparam Encoding   encoding of depths in the map
template <shadow_setup Setup, class Filter, class Encoding = typename detail::encoding_for<Filter>::type>
class shadow {
    static_assert(detail::shadow_takes<Filter, Encoding>());
    static constexpr bool hardens = detail::contact_hardening<Filter>;

public:
    using texel = typename Encoding::texel;
    using uniforms_type = shadow_uniforms<Setup, detail::softness_matrices<Setup, Filter>>;
    static_assert(!hardens || !has_bent_lines<Setup>,
                  "contact hardening compares along planes, which paraboloids bend: take another setup, or a disc");
    static_assert(detail::has_fields<Setup>(), "a setup's `fields` name its `uniforms`, in their order");

    /// @param light      a light_space, an array of cascades, a point_light, or a setup of your own
    /// @param map_size   size of one map, texels, each >= 1
    /// @param filter     one of filters:: or prefilters::. It gets the light's direction of depth. Contact hardening
    ///                   wants the size of the light: make_penumbra_params(light_size)
    /// @param encoding   encoding of depths in the map. It gets the light's direction. A prefilter's map holds moments
    /// @param origin     origin of all positions that the shadow gets, of casters, receivers and shaders, in world
    ///                   units. Take one near the camera where the world is a thousand times larger than what the
    ///                   light covers, with a light in double. It may change each frame: relative_to()
    /// @throws std::invalid_argument  an unset clip space, no maps, or more maps than the grid holds. A map_size
    ///                                below 1 or above 32768, less than twice the filter's reach, or refused by
    ///                                the setup. A border or gutter of the light's maps below the filter's reach. A
    ///                                filter's number out of range. A light so far from the origin, or a warp so deep,
    ///                                that floats have no digits left; uniforms infinite or NaN in float
    template <class Light>
    shadow(const Light& light, glm::ivec2 map_size, const Filter& filter = {}, const Encoding& encoding = {},
           glm::dvec3 origin = glm::dvec3(0))
        : setup_(light), map_size_(map_size), filter_(filter), encoding_(encoding), origin_(origin) {
        detail::set_direction(encoding_, setup_.clip().direction);
        filter_.direction = encoding_.direction;
        if constexpr (hardens) detail::require_light_size(filter_);
        detail::require_shadow(setup_.clip(), map_size, filter_of(0));
        detail::require_maps(setup_, detail::reach_of(filter_));
        uniforms_ = detail::make_shadow_uniforms(setup_, map_size_, filter_, encoding_.error(), origin_);
    }

    [[nodiscard]] const Setup& setup() const { return setup_; }
    [[nodiscard]] const Filter& filter() const { return filter_; }
    /// Filter of one map, as it is by itself. Contact hardening has another softness in each map: that of its first
    /// texel if it is warped, and that of face 0 in a tetrahedron's.
    /// @param number   number of the map, from 0
    [[nodiscard]] Filter filter_of(int number) const {
        return detail::filter_of_map<Setup>(filter_, uniforms_, number);
    }
    [[nodiscard]] const Encoding& encoding() const { return encoding_; }

    /// Size of the image or texture that holds all maps, texels.
    [[nodiscard]] glm::ivec2 size() const { return map_size_ * glm::ivec2(Setup::grid.columns, Setup::grid.rows); }
    /// Size of one map, and of a texture array, texels.
    [[nodiscard]] glm::ivec2 map_size() const { return map_size_; }
    /// Texel of an empty map: the far plane's.
    [[nodiscard]] texel cleared() const {
        if constexpr (prefilter<Filter>) return filter_.encode(cleared_depth(encoding_.direction));
        else return encoding_.cleared();
    }

    /// Draws a mesh into the depths of all maps, each with its own view. The depth nearest to the light stays. Parallel
    /// rays keep casters before the near plane, as the vertex function does.
    /// @param depths   image of size(), cleared to cleared_depth of the light's clip space, or from an earlier draw
    /// @param mesh     casters, world units
    /// @param parallel cuts the rows into pieces, see parallel.hpp
    /// @throws std::invalid_argument  depths of another size; arguments that rasterize_depth refuses; under contact
    ///                                hardening and parallel rays, casters before the near plane
    template <class ParallelFor = serial>
    void draw(image_view<float> depths, const mesh_view& mesh, ParallelFor&& parallel = {}) const
        requires(!std::is_convertible_v<ParallelFor, std::span<const glm::mat4>>) {
        const glm::mat4 in_place(1);
        draw(depths, mesh, std::span(&in_place, 1), parallel);
    }

    /// Draws many instances of a mesh. Faces on both sides cast shadows, so mirrored instances need no care.
    /// @param mesh        casters, in the units and axes that the instances place in the world
    /// @param instances   model to world, one matrix each; one that is not finite draws nothing
    /// Other parameters as for a single mesh.
    template <class ParallelFor = serial>
    void draw(image_view<float> depths, const mesh_view& mesh, std::span<const glm::mat4> instances,
              ParallelFor&& parallel = {}) const {
        detail::require_size(depths.size, size(), "shadow::draw", "depths.size", "the shadow's size()");
        if constexpr (detail::has_own_draw<Setup>) setup_.draw(depths, mesh, instances, origin_, parallel);
        else {
            int number = 0;
            for (const light_space<double>& of_world : setup_.lights()) {
                const auto own = depths.region(detail::first_texel(number++, Setup::grid, map_size_), map_size_);
                const light_space<double> light = detail::relative_to(origin_, of_world);
                const bool clamps = detail::has_parallel_rays(light);
                rasterize_depth(own, mesh, instances, light.projection * light.view, light.clip, cull_mode::none,
                                parallel, clamps ? near_plane::clamps : near_plane::clips);
                if constexpr (hardens)
                    detail::require(!clamps || !detail::has_clamped_casters(mesh, instances, light), "shadow::draw",
                                    "mesh", "behind the light's near plane, as contact hardening needs its distance",
                                    "casters before it", "Give the fit its casters, or move the near plane.");
            }
        }
    }

    /// Views of the depth pass on a GPU, one a map: what the vertex function of bind_vertex_pass takes.
    [[nodiscard]] std::vector<depth_view> depth_views() const { return detail::depth_views_of(setup_, origin_); }

    /// The same shadow for another origin of positions.
    /// @throws std::invalid_argument  as the constructor
    [[nodiscard]] shadow relative_to(glm::dvec3 origin) const {
        return shadow(setup_, map_size_, filter_, encoding_, origin);
    }

    /// Encodes drawn depths as texels of the map. Then blur a prefilter's map, one map at a time (blur.hpp).
    /// @throws std::invalid_argument  depths or a map of another size
    template <class ParallelFor = serial>
    void store(image_view<const float> depths, image_view<texel> map, ParallelFor&& parallel = {}) const {
        detail::require_size(depths.size, size(), "shadow::store", "depths.size", "the shadow's size()");
        detail::require_size(map.size, size(), "shadow::store", "map.size", "the shadow's size()");
        if constexpr (prefilter<Filter>) encode_moments(depths, map, filter_, parallel);
        else encode(depths, map, encoding_, parallel);
    }

    /// Visibility of a receiver.
    /// @param map      image of size(), texels of the encoding, drawn for this light
    /// @param world    world position of the receiver
    /// @param normal   surface normal, any length, for the plane along which texels are compared. That of the triangle:
    ///                 an interpolated one shadows smooth surfaces. Zero: a slope of 0, for maps whose depth pass was
    ///                 biased (make_polygon_offset)
    /// @param pixel    pixel that decides the rotation of discs and contact hardening
    /// @return         visibility in [0, 1]: 0 in shadow, 1 lit
    /// @edge           outside all maps, behind the light, beyond the far plane, or a NaN position: 1
    /// @throws std::invalid_argument  a map of another size
    /// @exactness      that of its weakest part: C, as project_coordinate; cascades B
    [[nodiscard]] float operator()(image_view<const texel> map, glm::vec3 world, glm::vec3 normal,
                                   glm::ivec2 pixel = {}) const {
        detail::require_size(map.size, size(), "shadow", "map.size", "the shadow's size()");
        return detail::blended(Setup::places(uniforms_.maps, uniforms_.terms, world, normal), [&](const auto& place) {
            const auto own = map.region(detail::first_texel(place.number, Setup::grid, map_size_), map_size_);
            const auto look = [&](const auto& filter) {
                return detail::look<Setup, Filter>(own, filter, encoding_, receiver(place), place.slope, pixel);
            };
            if constexpr (detail::has_shapes<Setup, Filter>)
                if (detail::changes_shape(setup_))
                    return look(detail::shaped<Setup>(filter_of(place.number), uniforms_, place.number));
            return look(filter_of(place.number));
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
    /// (peter-panning). A caster farther above the point, if it is parallel to the surface or faces the light, darkens
    /// it fully. light_units_at converts it to world units. A shader bound with `.linear` adds half a texel
    /// of slope to the bias. Contact hardening has the distance of its widest filter.
    /// @return   difference of depth from 0 to 1, in the point's map. The larger one if two maps blend
    /// @formula  bias + reach (|slope.x| + |slope.y|) + error + rounding. For a caster of slope c,
    ///           max(|c|, |c - slope|) takes the place of |slope|. Maps that bend planes add by how much a plane leaves
    ///           its slope's line
    [[nodiscard]] float peter_panning_distance(glm::vec3 world, glm::vec3 normal) const requires(!prefilter<Filter>) {
        float distance = 0.0f;
        const decoding_error off = encoding_.error();  // a caster may be stored too far from the light
        const double farther = encoding_.direction == depth_direction::forward ? off.above : off.below;
        for (const map_place& place : Setup::places(uniforms_.maps, uniforms_.terms, world, normal)) {
            shadow_terms terms = uniforms_.terms;
            terms.error += detail::bias_of<Setup, Filter>(terms, place) + static_cast<float>(farther);
            if constexpr (detail::along_plane<Setup, Filter>)  // acne_free_bias adds 2^-23, which slack has
                terms.error -= detail::spare_slack(matrix_of(place.number), map_size_, place) + 0x1p-23f;
            if constexpr (has_bent_lines<Setup>) terms.error += Setup::bend(uniforms_.maps, terms, world, normal);
            if (place.weight > 0.0f) distance = (glm::max)(distance, detail::kernel_bias_of<Filter>(terms, place));
        }
        return distance;
    }

    /// Widths of penumbras that contact hardening resolves at a receiver: those of a straight edge's shadow, from 10 to
    /// 90 % of the light, across the light's rays. Narrower ones get the filter's own softness, wider ones are cut.
    /// @return   narrowest and widest, world units. Outside all maps: 0
    /// @formula  2 texels of the longer edge, and 1.374 max_radius of the shorter one: an edge darkens a disc from 10
    ///           to 90 % over 1.374 of its radii. Where a warp slants texels, max_radius is that of shaped_softness
    [[nodiscard]] glm::vec2 penumbra_widths(glm::vec3 world,
                                            glm::vec3 normal) const requires detail::contact_hardening<Filter> {
        const map_place place = Setup::places(uniforms_.maps, uniforms_.terms, world, normal)[0];
        const glm::vec2 at(place.at), beyond = uniforms_.terms.map_size - at;
        if (!(at.x >= 0.0f && at.y >= 0.0f && beyond.x >= 0.0f && beyond.y >= 0.0f)) return glm::vec2(0);
        const glm::dvec3 p = glm::dvec3(world) + origin_;
        const glm::vec2 edges(detail::edges_at(detail::matrix_at(setup_, map_size_, place.number, p), p));
        glm::vec4 soft(detail::softness_of(filter_));
        if constexpr (detail::has_shapes<Setup, Filter>)
            if (detail::changes_shape(setup_))
                soft = shaped_softness(soft, detail::shaped<Setup>(filter_, uniforms_, place.number).shape(at));
        return {2.0f * (glm::max)(edges.x, edges.y), 1.374f / 16.0f * soft.w * (glm::min)(edges.x, edges.y)};
    }

    /// Uniform block for the shader of in_shader.hpp.
    [[nodiscard]] const uniforms_type& uniforms() const { return uniforms_; }

private:
    /// Texture matrix of a map.
    [[nodiscard]] glm::dmat4 matrix_of(int number) const {
        return texture_matrix(setup_.lights()[static_cast<std::size_t>(number)], map_size_);
    }
    [[nodiscard]] glm::vec3 receiver(const map_place& place) const {
        return detail::receiver_of<Setup, Filter>(uniforms_.terms, place, encoding_.direction);
    }

    Setup setup_;
    glm::ivec2 map_size_;
    Filter filter_;
    Encoding encoding_;
    glm::dvec3 origin_;
    uniforms_type uniforms_{};
};

template <class Light, class Filter, class Encoding = typename detail::encoding_for<Filter>::type>
shadow(const Light&, glm::ivec2, const Filter&, const Encoding& = {}, glm::dvec3 = glm::dvec3(0))
    -> shadow<typename setup_for<Light>::type, Filter, Encoding>;

template <shadow_setup Setup, class Filter, class Encoding>
template <class ParallelFor>
void shadow<Setup, Filter, Encoding>::visibility(image_view<const texel> map, image_view<const glm::vec3> points,
                                                 image_view<const glm::vec3> normals, image_view<float> out,
                                                 ParallelFor&& parallel) const {
    constexpr auto function = "shadow::visibility";
    detail::require_size(map.size, size(), function, "map.size", "the shadow's size()");
    detail::require_size(normals.size, points.size, function, "normals.size", "the size of points");
    detail::require_size(out.size, points.size, function, "out.size", "the size of points");
    const detail::world_receivers<Setup, Filter> receivers{uniforms_.maps, uniforms_.terms, encoding_.direction, points,
                                                           normals};
    const auto filters = [&](const auto& filter_of_map) {
        detail::visibility_of_places(map, map_size_, filter_of_map, encoding_, receivers, out, parallel);
    };
    if constexpr (detail::has_shapes<Setup, Filter>)
        if (detail::changes_shape(setup_))
            return filters([&](int number) { return detail::shaped<Setup>(filter_of(number), uniforms_, number); });
    filters([&](int number) { return filter_of(number); });
}

}  // namespace umbrage
