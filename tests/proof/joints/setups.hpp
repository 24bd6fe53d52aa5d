// SPDX-License-Identifier: MIT
//
// The light's setup of a draw, as a program makes it of a scene: in float, or in double.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <variant>
#include <vector>

#include <umbrage/light/cascades/splits.hpp>
#include <umbrage/light/directional_light.hpp>
#include <umbrage/light/spot_fit.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/warp/light_position.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/perspective.hpp>
#include <umbrage/light/warp/plane_optimal.hpp>
#include <umbrage/light/warp/trapezoidal.hpp>
#include <umbrage/shadow/adaptive_maps.hpp>
#include <umbrage/shadow/cascaded_maps.hpp>
#include <umbrage/shadow/cube_maps.hpp>
#include <umbrage/shadow/paraboloid_maps.hpp>
#include <umbrage/shadow/single_map.hpp>
#include <umbrage/shadow/tetrahedron_map.hpp>
#include <umbrage/shadow/warped_maps.hpp>

#include "../traced_map.hpp"
#include "scene.hpp"

namespace joints {

using any_setup =
    std::variant<umbrage::single_map, umbrage::cascaded_maps<1>, umbrage::cascaded_maps<2>, umbrage::warped_maps,
                 umbrage::adaptive_maps, umbrage::cube_maps, umbrage::tetrahedron_map, umbrage::paraboloid_maps>;

/// A setup, the size of its maps, and its light as rays have it.
struct lit_scene {
    any_setup setup;
    glm::ivec2 map_size;
    proof::ray_light light;
    bool clips;  ///< casters before the near plane are left out
};

/// A light that no receiver needs: its draw counts as refused, by this reason.
struct nothing_seen : std::invalid_argument {
    nothing_seen() : std::invalid_argument("joints: the light sees no receiver") {}
};

template <class T>
class setup_maker {
public:
    /// @param reach   of the filter, texels
    setup_maker(const choices& c, const scene& s, float reach) : c_(c), s_(s), reach_(reach) {}

    [[nodiscard]] lit_scene make() const {
        using enum setup_kind;
        switch (c_.setup) {
            case spot:
            case fitted_spot: return single(spot_light(), spot_rays(), true);
            case warped_lamp: return single(warped_lamp_light(), spot_rays(), true);
            case stable_cascades: return cascades(c_.cascades, true);
            case tight_cascades: return cascades(c_.cascades, false);
            case eight_cascades: return {umbrage::cascaded_maps(stable<6>()), c_.size, sun_rays(), false};
            case warped_cascades: return warped(c_.cascades);
            case pages: return paged();
            case cube:
            case tetrahedron:
            case paraboloids: return around();
            default: return single(sun_light(), sun_rays(), false);
        }
    }

private:
    using vec = glm::vec<3, T>;

    [[nodiscard]] vec position(glm::dvec3 own) const { return vec(s_.placed(own) + s_.origin); }
    [[nodiscard]] vec direction(glm::dvec3 own) const { return vec(s_.turned(own)); }
    [[nodiscard]] T length(double own) const { return T(own * c_.scale); }
    [[nodiscard]] umbrage::bounding_box<T> cast(const umbrage::bounding_box<double>& b) const {
        return {vec(b.low), vec(b.high)};
    }
    [[nodiscard]] proof::ray_light sun_rays() const { return {false, -glm::dvec3(direction(-s_.sun))}; }
    [[nodiscard]] proof::ray_light spot_rays() const { return {true, glm::dvec3(position(s_.lamp)) - s_.origin}; }
    [[nodiscard]] lit_scene single(const umbrage::light_space<T>& light, proof::ray_light rays, bool clips) const {
        return {umbrage::single_map(light), c_.size, rays, clips};
    }

    [[nodiscard]] umbrage::light_space<T> spot_light() const {
        const T angle = T(s_.angle);
        if (c_.setup == setup_kind::spot)
            return umbrage::make_spot_light<T>({.position = position(s_.lamp),
                                                .direction = direction(s_.aim),
                                                .outer_angle_radians = angle,
                                                .z_near = length(s_.z_near),
                                                .z_far = length(30),
                                                .clip = c_.clip});
        const auto light = umbrage::fit_spot_light<T>({.position = position(s_.lamp),
                                                       .direction = direction(s_.aim),
                                                       .outer_angle_radians = angle,
                                                       .z_near = length(s_.z_near),
                                                       .receivers = cast(s_.near_box()),
                                                       .clip = c_.clip});
        if (!light) throw nothing_seen();
        return *light;
    }
    [[nodiscard]] umbrage::warp_fit<T> seen_along(vec along, const umbrage::bounding_box<T>& received) const {
        return {.camera = s_.camera<T>(),
                .direction = along,
                .receivers = umbrage::intersection(s_.camera<T>(), received),
                .margin = T(0.02),
                .clip = c_.clip};
    }
    /// Plane of the ground: 0 on it.
    [[nodiscard]] glm::vec<4, T> ground() const {
        const glm::dvec3 up = s_.turned({0, 1, 0});
        return glm::vec<4, T>(glm::dvec4(up, -glm::dot(up, s_.placed(glm::dvec3(0)) + s_.origin)));
    }
    [[nodiscard]] static umbrage::light_space<T> on_ground(const std::optional<umbrage::warped_light<T>>& found) {
        if (!found) throw nothing_seen();
        return found->light;
    }
    [[nodiscard]] umbrage::light_space<T> warped_lamp_light() const {
        umbrage::warp_fit<T> warp = seen_along(direction(s_.aim), cast(s_.low_box()));
        if (c_.mirrored) warp.casters = cast(s_.box());
        const umbrage::light_position<T> from{position(s_.lamp), length(s_.z_near)};
        if (c_.warps_for_ground()) return on_ground(umbrage::fit_plane_optimal(warp, ground(), from));
        return umbrage::fit_perspective(warp, from).light;
    }
    [[nodiscard]] umbrage::light_space<T> sun_light() const {
        using namespace umbrage;
        using enum setup_kind;
        const bounding_box<T> all = cast(s_.box()), received = cast(s_.near_box());
        const vec along = direction(-s_.sun);
        if (c_.setup == sun_by_hand)
            return make_directional_light<T>({.direction = along,
                                              .target = position(glm::dvec3(0)),
                                              .offset = length(25),
                                              .map_size = c_.size,
                                              .texels_per_unit = T(c_.size.x) / length(12),
                                              .z_near = length(0.1),
                                              .z_far = length(45),
                                              .clip = c_.clip});
        directional_fit<T> fit{.direction = along, .receivers = received, .clip = c_.clip};
        if (c_.setup != sun_alone) fit.casters = all;
        if (c_.setup == snapped_sun) fit.snap_texels = c_.size;
        if (!c_.has_camera()) return fit_directional_light(fit);
        warp_fit<T> warp = seen_along(along, received);
        if (c_.mirrored || c_.filter.hardens()) warp.casters = all;
        if (c_.setup == trapezoidal) return fit_trapezoidal(warp, length(2)).light;
        if (c_.setup == setup_kind::perspective) return fit_perspective(warp).light;
        if (c_.setup == plane_optimal) return on_ground(fit_plane_optimal(warp, ground()));
        return fit_light_space_perspective(warp).light;
    }

    [[nodiscard]] umbrage::cascade_fit<T> fit() const {
        return {.camera = s_.camera<T>(),
                .direction = direction(-s_.sun),
                .scene = cast(s_.box()),
                .map_size = c_.size,
                .margin = T(std::ceil(reach_ + 1)),
                .overlap = T(0.1),
                .clip = c_.clip};
    }
    template <std::size_t Count>
    [[nodiscard]] std::array<T, Count + 1> splits() const {
        return umbrage::practical_splits<Count>(length(0.5), length(9), T(0.6));
    }
    template <std::size_t Count>
    [[nodiscard]] auto stable() const {
        return umbrage::make_stable_cascades<Count>(fit(), splits<Count>());
    }
    /// Calls make with a number of one to four, as a constant.
    template <class Make>
    [[nodiscard]] static auto with_count(int count, const Make& make) {
        if (count == 1) return make(std::integral_constant<std::size_t, 1>());
        if (count == 2) return make(std::integral_constant<std::size_t, 2>());
        if (count == 3) return make(std::integral_constant<std::size_t, 3>());
        return make(std::integral_constant<std::size_t, 4>());
    }
    [[nodiscard]] lit_scene cascades(int count, bool are_stable) const {
        const float blend = c_.mirrored ? 16.0f : 0.0f;
        return with_count(count, [&]<std::size_t Count>(std::integral_constant<std::size_t, Count>) {
            const auto all = are_stable ? stable<Count>() : umbrage::make_tight_cascades<Count>(fit(), splits<Count>());
            return lit_scene{umbrage::cascaded_maps(all, blend), c_.size, sun_rays(), false};
        });
    }
    [[nodiscard]] lit_scene warped(int count) const {
        return with_count(count, [&]<std::size_t Count>(std::integral_constant<std::size_t, Count>) {
            const auto all = umbrage::make_warped_cascades<Count>(
                fit(), splits<Count>(), [&](const umbrage::warp_fit<T>& part) -> umbrage::warped_light<T> {
                    if (c_.image.x % 3 == 0) return umbrage::fit_light_space_perspective(part);
                    if (c_.image.x % 3 == 1) return umbrage::fit_trapezoidal(part, T(2 * c_.scale));
                    return umbrage::fit_perspective(part);
                });
            return lit_scene{umbrage::warped_maps(all, s_.camera<T>(), fit().overlap), c_.size, sun_rays(), false};
        });
    }
    [[nodiscard]] lit_scene paged() const {
        using namespace umbrage;
        const auto root = make_page_root<T>({.direction = direction(-s_.sun),
                                             .center = position(glm::dvec3(0)),
                                             .side = length(20),
                                             .scene = cast(s_.box()),
                                             .clip = c_.clip});
        const glm::dmat4 to_root = glm::dmat4(page_matrix(root));
        std::vector<page_receiver> seen;
        for (int i = 0; i < 1600; ++i) {
            const glm::dvec3 own(i % 40 * 0.25 - 5, i % 7 * 0.5, i / 40 * 0.25 - 5);
            const double away = glm::length(own - s_.eye);
            seen.push_back(
                {glm::vec2(shadow_coordinate(to_root, s_.placed(own) + s_.origin)), float(100 / (away * away))});
        }
        page_cache cache({.slots = {8, 8}, .deepest_level = 4});
        static_cast<void>(cache.update(seen));
        const auto gutter = static_cast<unsigned>(std::ceil(reach_));
        const auto texels = std::max(16u << (c_.size.x % 3), std::bit_ceil(2 * gutter));
        const page_size size{.texels = int(texels), .gutter = int(gutter)};
        return {adaptive_maps(root, cache, size), glm::ivec2(size.pitch()), sun_rays(), false};
    }
    [[nodiscard]] lit_scene around() const {
        using namespace umbrage;
        const int border = int(std::ceil(reach_)), side = std::max(c_.size.x, 64);
        const vec at = position(s_.lamp);
        const T z_near = length(s_.z_near), z_far = length(c_.mirrored ? 30 : 100);
        if (c_.setup == setup_kind::cube)
            return {cube_maps(point_light<T>{at, z_near, z_far, side, border, c_.clip}), glm::ivec2(side), spot_rays(),
                    true};
        if (c_.setup == setup_kind::tetrahedron)
            return {tetrahedron_map(tetrahedron_light<T>{at, z_near, z_far, side, border, c_.clip}), glm::ivec2(side),
                    spot_rays(), true};
        return {paraboloid_maps(dual_paraboloid_light<T>{at, length(25), side, border, c_.clip}), glm::ivec2(side),
                spot_rays(), false};
    }

    const choices& c_;
    const scene& s_;
    float reach_;
};

[[nodiscard]] inline lit_scene make_setup(const choices& c, const scene& s, float reach) {
    return c.in_double ? setup_maker<double>(c, s, reach).make() : setup_maker<float>(c, s, reach).make();
}

}  // namespace joints
