// SPDX-License-Identifier: MIT
//
// The steps of a program with a GPU, in C++: a depth pass a view, the uniforms, and the shader's places, bias and
// filter. Tweaks get them wrong; without any the bits are those of the shadow.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include <umbrage/draw/rasterize.hpp>
#include <umbrage/shadow/shadow.hpp>

#include "host.hpp"
#include "tweaks.hpp"
#include "wrong_pcss.hpp"
#include "wrong_uniforms.hpp"

namespace joints {

/// Instances as a program with a fault places them.
[[nodiscard]] inline std::vector<glm::mat4> wrong_instances(std::vector<glm::mat4> all, const tweaks& t) {
    for (glm::mat4& m : all)
        for (glm::length_t axis = 0; axis < 3 && t.drops_instances_turn; ++axis) {
            const float length = glm::length(m[axis]);
            m[axis] = glm::vec4(0), m[axis][axis] = length;
        }
    return all;
}

template <class Shadow>
class wrong_steps {
    using setup = std::remove_cvref_t<decltype(std::declval<Shadow>().setup())>;
    using filter_type = std::remove_cvref_t<decltype(std::declval<Shadow>().filter())>;
    using encoding_type = std::remove_cvref_t<decltype(std::declval<Shadow>().encoding())>;
    using texel = typename Shadow::texel;
    static constexpr bool draws_itself =
        umbrage::has_bent_lines<setup> || std::is_same_v<setup, umbrage::tetrahedron_map>;

public:
    wrong_steps(const Shadow& s, glm::dvec3 origin, const tweaks& t)
        : shadow_(s), origin_(origin), t_(t), uniforms_(s.uniforms()), filter_(s.filter()), encoding_(s.encoding()) {}

    bool draw(const scene& of, umbrage::image_view<texel> map) {
        if (!change_uniforms() || !change_look() || (draws_itself && t_.draws())) return false;
        umbrage::image<float> depths(shadow_.size(), umbrage::cleared_depth(clip()));
        if (t_.clears_near) std::ranges::fill(depths.texels(), 1.0f - umbrage::cleared_depth(clip()));
        if (!t_.draws()) {
            shadow_.draw(depths, of.mesh());
            if (!of.instances.empty()) shadow_.draw(depths, scene::cube(), of.instances);
        } else {
            const auto instances = wrong_instances(of.instances, t_);
            const glm::mat4 in_place(1);
            if (!t_.skips_mesh && !draw_all(depths, of.mesh(), std::span(&in_place, 1))) return false;
            if (!t_.skips_instances && !instances.empty() && !draw_all(depths, scene::cube(), instances)) return false;
        }
        if (t_.exchanges_sides && !exchange(depths)) return false;
        for (float& z : depths.texels()) {
            if (t_.depth_bits != 0) z = std::floor(z * float(1 << t_.depth_bits)) / float(1 << t_.depth_bits);
            if (t_.stores_linear) z = z * z;
            z = std::clamp(z + float(t_.moves_casters) * (is_reversed() ? 1.0f : -1.0f), 0.0f, 1.0f);
        }
        shadow_.store(depths, map);
        return true;
    }

    [[nodiscard]] float visibility(umbrage::image_view<const texel> map, const looked_up& r) const {
        using namespace umbrage;
        glm::vec3 normal = r.normal;
        if (t_.drops_normal) normal = glm::vec3(0);
        if (t_.other_normal) normal = {normal.y, normal.z, normal.x};
        if (t_.normal_of_mesh && r.own && r.own->model) normal = glm::transpose(*r.own->model) * normal;
        const auto all = setup::places(uniforms_.maps, uniforms_.terms, r.point, normal);
        return detail::blended(all, [&](map_place place) {
            place.slope *= t_.slope;
            const int maps = setup::grid.columns * setup::grid.rows;
            const int number = (place.number + t_.other_tile) % maps;
            const auto own =
                map.region(detail::first_texel(number, setup::grid, shadow_.map_size()), shadow_.map_size());
            const float bias =
                detail::bias_of<setup, filter_type>(uniforms_.terms, place) * (t_.turns_bias ? -1.0f : 1.0f);
            const bool beyond = comparison{encoding_.direction}.beyond_far_plane(place.at.z);
            const float z = place.at.z;
            const glm::vec3 at(glm::vec2(place.at) + t_.moves_texels,
                               beyond ? z : biased(z, bias, encoding_.direction));
            const auto look = [&](const auto& filter) {
                return detail::look<setup, filter_type>(own, filter, encoding_, at, place.slope, r.pixel);
            };
            if constexpr (detail::has_shapes<setup, filter_type>)
                if (detail::changes_shape(shadow_.setup()) && !t_.drops_shape)
                    return look(detail::shaped<setup>(filter_of(place.number), uniforms_, place.number));
            return look(filter_of(place.number));
        });
    }

private:
    [[nodiscard]] wrong_filter<filter_type> filter_of(int number) const {
        if constexpr (!umbrage::detail::contact_hardening<filter_type>) return filter_;
        else {
            if (t_.other_softness != 0) number = (number + t_.other_softness) % maps_;
            filter_type own = umbrage::detail::filter_of_map<setup>(filter_, uniforms_, number);
            umbrage::penumbra_params& soft = own.softness;
            if (t_.default_softness) soft.per_code_x = soft.per_code_y = umbrage::penumbra_params{}.per_code_x;
            if (t_.one_softness) soft.per_code_x = soft.per_code_y = std::min(soft.per_code_x, soft.per_code_y);
            soft.per_code_x *= t_.softness, soft.per_code_y *= t_.softness;
            if constexpr (std::is_same_v<filter_type, umbrage::filters::pcss>) return {own, t_};
            else return own;
        }
    }
    [[nodiscard]] umbrage::clip_space clip() const { return shadow_.setup().clip(); }
    [[nodiscard]] bool is_reversed() const { return clip().direction == umbrage::depth_direction::reversed; }

    /// Every map by its light, with what the tweaks change.
    bool draw_all(umbrage::image_view<float> depths, const umbrage::mesh_view& mesh, std::span<const glm::mat4> all) {
        using namespace umbrage;
        const auto lights = shadow_.setup().lights();
        if (t_.other_view != 0 && lights.size() < 2) return false;
        clip_space c = clip();
        if (t_.turns_direction) c.direction = is_reversed() ? depth_direction::forward : depth_direction::reversed;
        if (t_.other_range)
            c.range = c.range == depth_range::zero_to_one ? depth_range::minus_one_to_one : depth_range::zero_to_one;
        if (t_.other_origin) c.origin = c.origin == texture_origin::top ? texture_origin::bottom : texture_origin::top;
        for (std::size_t i = 0; i < lights.size(); ++i) {
            const auto of_world = lights[(i + std::size_t(t_.other_view)) % lights.size()];
            glm::dvec3 origin = t_.drops_origin ? glm::dvec3(0) : origin_;
            if (t_.stale_origin) origin += step_of(of_world, origin);
            const light_space<double> light = detail::relative_to(origin, of_world);
            const bool clamps = detail::has_parallel_rays(light) != t_.flips_near;
            const auto own =
                depths.region(detail::first_texel(int(i), setup::grid, shadow_.map_size()), shadow_.map_size());
            glm::dmat4 m = light.projection * light.view;
            if (t_.in_float) m = glm::dmat4(glm::mat4(light.projection) * glm::mat4(light.view));
            const depth_view view = make_depth_view(of_world, origin);
            if (t_.drops_anchor) {
                m = glm::dmat4(view.to_clip);
                for (glm::length_t k = 0; k < 4; ++k) m[k].z += double(view.anchor.w) * m[k].w;
            }
            if (t_.drops_depth_share) {
                if (view.anchor.w == 0.0f) return false;
                for (glm::length_t k = 0; k < 4; ++k) m[k].z -= double(view.anchor.w) * m[k].w;
            }
            for (glm::length_t k = 0; k < 4 && t_.light_turned != 0; ++k)
                m[k].x += m[k].w * t_.light_turned * 2 / shadow_.map_size().x;
            rasterize_depth(own, mesh, all, m, c, t_.cull.value_or(cull_mode::none), serial{},
                            clamps ? near_plane::clamps : near_plane::clips);
        }
        return true;
    }
    /// The image's memory as that of an image whose sides are exchanged.
    bool exchange(umbrage::image<float>& depths) const {
        const glm::ivec2 size = depths.size();
        if (size.x == size.y) return false;
        const umbrage::image<float> right = depths;
        for (int i = 0; i < size.x * size.y; ++i)  // drawn into size.y x size.x, read by rows of size.x
            depths[{i % size.x, i / size.x}] = right[{(i % size.y) * size.x / size.y, (i / size.y) * size.y / size.x}];
        return true;
    }

    bool change_uniforms() {
        wrong_uniforms<setup> maps(shadow_.setup(), shadow_.map_size(), origin_, uniforms_.maps);
        if (!maps.change(t_, filter_.reach())) return false;
        auto& terms = uniforms_.terms;
        terms.reach *= float(t_.reach);
        if (umbrage::detail::disc_filter<filter_type>) terms.filter_terms *= float(t_.reach);
        if (t_.drops_error) terms.error = 0.0f;
        return true;
    }
    bool change_look() {
        using umbrage::depth_direction;
        if (t_.turns_comparison)
            filter_.direction = is_reversed() ? depth_direction::forward : depth_direction::reversed;
        if (t_.lower_edge) {
            if constexpr (requires { encoding_.edge; }) encoding_.edge = 1.0f - encoding_.edge;
            else return false;
        }
        if (t_.wider_filter) {
            if constexpr (std::is_same_v<filter_type, umbrage::filters::box>) filter_.radius += 2;
            else if constexpr (std::is_same_v<filter_type, umbrage::filters::disc>) filter_.radius_texels += 2.0f;
            else if constexpr (std::is_same_v<filter_type, umbrage::filters::window>) {
                if (filter_.reach() > 3.0f) return false;
                const auto direction = filter_.direction;
                filter_ = umbrage::filters::castano<7>;
                filter_.direction = direction;
            } else return false;
        }
        return true;
    }

    Shadow shadow_;
    glm::dvec3 origin_;
    tweaks t_;
    typename Shadow::uniforms_type uniforms_;
    filter_type filter_;
    encoding_type encoding_;
    int maps_ = static_cast<int>(shadow_.setup().lights().size());
};

}  // namespace joints
