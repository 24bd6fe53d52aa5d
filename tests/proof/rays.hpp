// SPDX-License-Identifier: MIT
//
// Shadow maps from end to end against rays: a light fitted to a random scene, its depth pass, and filters' lookups
// with the acne-free bias, at points where a ray to the light tells what they must find. A sample in the tests, more in
// `make prove`.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <umbrage/bias/acne_free.hpp>
#include <umbrage/bias/slope.hpp>
#include <umbrage/depth/depth32f.hpp>
#include <umbrage/draw/rasterize.hpp>
#include <umbrage/filter/pcf/hard.hpp>
#include <umbrage/filter/pcf/pcf_2x2.hpp>
#include <umbrage/light/cascades/splits.hpp>
#include <umbrage/light/cascades/warped.hpp>
#include <umbrage/light/directional_fit.hpp>
#include <umbrage/light/spot_fit.hpp>
#include <umbrage/light/spot_light.hpp>
#include <umbrage/light/texture_matrix.hpp>
#include <umbrage/light/warp/light_space_perspective.hpp>
#include <umbrage/light/warp/perspective.hpp>
#include <umbrage/light/warp/plane_optimal.hpp>
#include <umbrage/light/warp/trapezoidal.hpp>
#include <umbrage/shadow/shadow.hpp>

#include "few_triangles.hpp"
#include "light_kinds.hpp"
#include "projected.hpp"

namespace proof {

/// Results of lookups for the receivers that rays decide.
struct verdicts {
    std::uint64_t lit = 0, shadowed = 0, wrong = 0;
    std::uint64_t outside = 0;    ///< receivers that the fit left out
    std::uint64_t by_shadow = 0;  ///< wrong, of umbrage::shadow with its own bias

    verdicts& operator+=(const verdicts& o) {
        lit += o.lit, shadowed += o.shadowed, wrong += o.wrong, outside += o.outside, by_shadow += o.by_shadow;
        return *this;
    }
};

/// A ground and few triangles, a camera and a light, all from one number.
class ray_scene : public few_triangles {
public:
    explicit ray_scene(std::uint64_t n)
        : few_triangles(static_cast<std::uint32_t>(n)), kind_(light_kinds[n % light_kinds.size()]) {
        const std::uint64_t c = n / light_kinds.size();
        clip_.range = c & 1 ? umbrage::depth_range::minus_one_to_one : umbrage::depth_range::zero_to_one;
        clip_.direction = c & 2 ? umbrage::depth_direction::reversed : umbrage::depth_direction::forward;
        clip_.origin = c & 4 ? umbrage::texture_origin::top : umbrage::texture_origin::bottom;
        clip_.hand = c & 8 ? umbrage::handedness::left : umbrage::handedness::right;
        const glm::vec3 eye = around(real(2, 6));
        camera_ = {.position = eye,
                   .direction = vector(-1, 1) - eye,
                   .tan_half_x = 0.5f,
                   .tan_half_y = 0.4f,
                   .z_near = 0.5f,
                   .z_far = 7};
        make_light();
    }

    [[nodiscard]] const char* kind() const { return kind_.name; }

    /// A filter at random points of triangles.
    template <class Filter>
    [[nodiscard]] verdicts compare(Filter filter, int points) {
        using namespace umbrage;
        filter.direction = clip_.direction;
        image<float> map({map_size, map_size}, cleared_depth(clip_));
        rasterize_depth(map, {positions_, triangles_}, light_.projection * light_.view, clip_, cull_mode::none,
                        serial{}, kind_.at_near);
        const depth32f encoding{.direction = clip_.direction};
        const auto fetch = clamped(map);
        const shadow joined(light_, {map_size, map_size}, filter);
        verdicts found;
        for (int i = 0; i < points; ++i) {
            const auto own = std::uniform_int_distribution<std::size_t>(0, triangles_.size() - 1)(random_);
            const glm::vec3 p = point_of(own);
            if (!is_received(p)) continue;
            const glm::vec3 at = project_coordinate(shadow_coordinate(matrix_, p));
            const float reach = filter.reach() + 1.0f;
            const auto within = [&](float v, float least) { return v >= least && v <= map_size - least; };
            if (!within(at.x, 0) || !within(at.y, 0) || !(at.z >= 0 && at.z <= 1)) {
                found.outside += is_held(p);
                continue;
            }
            if (!within(at.x, reach) || !within(at.y, reach) || is_near_edge(at, reach)) continue;
            const auto uniforms = joined.uniforms();
            const map_place place = single_map::places(uniforms.maps, uniforms.terms, p, normal(own))[0];
            const float by_shadow =
                acne_free_bias(slope(own), uniforms.terms.reach, uniforms.terms.error + place.slack);
            const float bias =
                acne_free_bias(slope(own), filter, encoding, rasterizer_snap<float> + 0x1p-10f) + rounding(p);
            const std::optional<bool> is_lit = told_by_rays(p, own, std::max(bias, by_shadow), filter.reach());
            if (!is_lit) continue;
            ++(*is_lit ? found.lit : found.shadowed);
            found.wrong +=
                filter(fetch, glm::vec2(at), biased(at.z, bias, filter.direction)) != (*is_lit ? 1.0f : 0.0f);
            found.by_shadow += joined(map, p, normal(own)) != (*is_lit ? 1.0f : 0.0f);
        }
        return found;
    }

protected:
    static constexpr int map_size = 256;
    static constexpr float z_near = 0.05f;

    void make_light() {
        using namespace umbrage;
        using fitted_to = light_kind::fitted_to;
        const polyhedron seen = intersection(camera_, box_);
        do {
            position_ = random_() % 4 ? around(real(6, 9)) : between({-1, 1, -1}, {1, 3, 1});
            direction_ = kind_.is_spot ? vector(-1, 1) - position_ : vector(-1, 1);
        } while (kind_.is_spot && intersection(seen, cone()).empty());  // of use for nothing that is seen
        if (kind_.receivers == fitted_to::ground && std::abs(direction_.y) < 0.1f)
            direction_.y = std::copysign(0.1f, direction_.y);  // no lower than plane_optimal_rounding holds for
        std::optional<bounding_box<float>> casters;
        if (kind_.at_near == near_plane::clips) casters = box_;
        if (kind_.receivers == fitted_to::cascade) {
            make_warped_cascade();
        } else if (kind_.receivers >= fitted_to::light_space) {
            const polyhedron held = kind_.is_spot ? intersection(seen, cone()) : seen;
            const warp_fit<float> fit{camera_, direction_, held, casters, 0.01f, clip_};
            const auto warped = [&]() -> warped_light<float> {
                if (kind_.is_spot) return fit_perspective(fit, {.position = position_, .z_near = 0.9f * z_near});
                if (kind_.receivers == fitted_to::trapezoid) return fit_trapezoidal(fit, real(0.5f, 4));
                if (kind_.receivers == fitted_to::perspective) return fit_perspective(fit);
                if (kind_.receivers == fitted_to::ground) return fit_plane_optimal(fit, glm::vec4(0, 1, 0, 0)).value();
                return fit_light_space_perspective(fit);
            };
            light_ = warped().light;
        } else if (!kind_.is_spot) {
            directional_fit<float> fit{.direction = direction_, .receivers = seen, .casters = casters, .clip = clip_};
            if (kind_.receivers == fitted_to::box) fit.receivers = box_;
            if (kind_.receivers == fitted_to::points) fit.receivers = positions_;
            if (kind_.receivers == fitted_to::sphere)
                fit.receivers = sphere_around(camera_), fit.snap_texels = {map_size, map_size};
            light_ = fit_directional_light(fit);
        } else if (kind_.receivers == fitted_to::cone) {
            light_ = make_spot_light<float>({.position = position_,
                                             .direction = direction_,
                                             .outer_angle_radians = 0.52f,  // C libraries agree on its tangent
                                             .z_near = z_near,
                                             .z_far = 30,
                                             .clip = clip_});
        } else {
            light_ = fit_spot_light<float>({.position = position_,
                                            .direction = direction_,
                                            .z_near = z_near,
                                            .receivers = seen,
                                            .casters = casters,
                                            .has_far_plane = kind_.has_far_plane,
                                            .clip = clip_})
                         .value();
        }
        matrix_ = texture_matrix(light_, {map_size, map_size});
        planes_ = plane_matrix(matrix_);
    }

    /// One of two, for what of the camera's range selection by depth leaves to it.
    void make_warped_cascade() {
        using namespace umbrage;
        const auto splits = practical_splits<2>(camera_.z_near, camera_.z_far, 0.4f);
        const auto all = make_warped_cascades<2>(cascade_fit<float>{.camera = camera_,
                                                                    .direction = direction_,
                                                                    .scene = box_,
                                                                    .map_size = {map_size, map_size},
                                                                    .clip = clip_},
                                                 splits, [this](const warp_fit<float>& part) -> warped_light<float> {
                                                     if (random_() % 2) return fit_perspective(part);
                                                     return fit_light_space_perspective(part);
                                                 });
        const std::size_t i = random_() % 2;
        light_ = all[i].light, camera_.z_near = splits[i], camera_.z_far = splits[i + 1];
    }

    [[nodiscard]] glm::vec3 normal(std::size_t k) const {
        const auto [a, b, c] = corners(k);
        return glm::vec3(glm::cross(b - a, c - a));
    }
    [[nodiscard]] glm::vec2 slope(std::size_t k) const {
        return umbrage::plane_slope(planes_, normal(k), glm::vec3(corners(k)[0]));
    }

    [[nodiscard]] umbrage::frustum<float> cone() const {
        return {.position = position_,
                .direction = direction_,
                .tan_half_x = 0.572f,
                .tan_half_y = 0.572f,
                .z_near = z_near,
                .z_far = 29};
    }

    /// True when the light must hold this point.
    [[nodiscard]] bool is_received(glm::vec3 p) const {
        const glm::dvec4 point(p, 1.0);
        const auto holds = [&](const umbrage::polyhedron& body) {
            return std::all_of(body.faces().begin(), body.faces().end(),
                               [&](const auto& face) { return glm::dot(face.plane, point) > 1e-4; });
        };
        if (kind_.sees_camera_only() && !holds(camera_)) return false;
        return !kind_.is_spot || holds(cone());
    }

    /// True when the map must hold this receiver.
    [[nodiscard]] bool is_held(glm::vec3 p) const {
        return kind_.receivers != light_kind::fitted_to::ground || p.y == 0.0f;
    }
    /// Rounding of a point's depth in floats. On a plane without slope in the map, the matrix' rounding counts too.
    [[nodiscard]] float rounding(glm::vec3 p) const {
        const bool flat = kind_.receivers == light_kind::fitted_to::ground;
        return depth_rounding(matrix_, p) + (flat ? umbrage::plane_optimal_rounding<float> : 0.0f);
    }

    /// Depth between a receiver and a triangle on the line to the light, below 0 behind the receiver. NaN if there is
    /// no such point, or if the light does not see it.
    /// @cite   Moeller, Trumbore: Fast, minimum storage ray/triangle intersection, 1997
    [[nodiscard]] double blocked_by(std::size_t k, glm::vec3 receiver) const {
        const double none = std::numeric_limits<double>::quiet_NaN();
        const auto [a, b, c] = corners(k);
        const glm::dvec3 from(receiver), way = kind_.is_spot ? glm::dvec3(position_) - from : -glm::dvec3(direction_);
        const glm::dvec3 ab = b - a, ac = c - a, p = glm::cross(way, ac), s = from - a;
        const double det = glm::dot(ab, p);
        if (det == 0) return none;
        const glm::dvec3 q = glm::cross(s, ab);
        const double u = glm::dot(s, p) / det, v = glm::dot(way, q) / det, t = glm::dot(ac, q) / det;
        if (u < 0 || v < 0 || u + v > 1) return none;
        const auto placed = [&](glm::dvec3 world) { return glm::dmat4(matrix_) * glm::dvec4(world, 1.0); };
        const glm::dvec4 caster = placed(from + t * way), here = placed(from);
        if (caster.w <= 0.0) return none;
        const double along = glm::dot(from + t * way - glm::dvec3(position_), glm::normalize(glm::dvec3(direction_)));
        if (kind_.is_spot && kind_.at_near == umbrage::near_plane::clips && along <= double(z_near))
            return kind_.receivers == light_kind::fitted_to::perspective ? 0.0 : none;  // held or not, who knows
        const auto depth = [&](const glm::dvec4& h) {
            const double d = clip_.direction == umbrage::depth_direction::forward ? h.z / h.w : 1.0 - h.z / h.w;
            return kind_.at_near == umbrage::near_plane::clamps ? std::max(d, 0.0) : d;
        };
        return depth(here) - depth(caster);
    }

    /// True when a point of a triangle is lit; empty where a bias may decide.
    [[nodiscard]] std::optional<bool> told_by_rays(glm::vec3 p, std::size_t own, float bias, float reach) const {
        bool is_lit = true;
        for (std::size_t k = 0; k < triangles_.size(); ++k) {
            if (k == own) continue;
            const double before = blocked_by(k, p);
            if (std::isnan(before)) continue;
            if (!(std::abs(before) >
                  double(umbrage::peter_panning_distance(bias, slope(k), reach + umbrage::rasterizer_snap<float>))))
                return std::nullopt;
            is_lit = is_lit && before <= 0.0;
        }
        return is_lit;
    }

    /// True when an edge of a triangle lies within some texels in the map, or an edge along the near plane's cut.
    [[nodiscard]] bool is_near_edge(glm::vec3 at, float texels) const {
        const bool reversed = clip_.direction == umbrage::depth_direction::reversed;
        for (std::size_t k = 0; k < triangles_.size(); ++k)
            if (sees_edge(glm::dmat4(matrix_), reversed, corners(k), glm::dvec2(at), 1.5 * double(texels))) return true;
        return false;
    }

    light_kind kind_;
    umbrage::clip_space clip_;
    umbrage::frustum<float> camera_;
    glm::vec3 position_{0}, direction_{0};
    umbrage::light_space<float> light_;
    glm::mat4 matrix_{1}, planes_{1};
};

}  // namespace proof
