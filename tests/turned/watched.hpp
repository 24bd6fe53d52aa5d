// SPDX-License-Identifier: MIT
//
// The library's shadow as a program calls it. What is drawn with it is judged there, and so is each receiver that the
// program looks up.
#pragma once

#include <cstddef>
#include <optional>
#include <exception>
#include <memory>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "lights.hpp"

namespace turned {

template <class T>
[[nodiscard]] given_light given(const umbrage::point_light<T>& light) {
    return bulb_of(light.position, double(light.z_near), double(light.z_far));
}
template <class T>
[[nodiscard]] given_light given(const umbrage::tetrahedron_light<T>& light) {
    return bulb_of(light.position, double(light.z_near), double(light.z_far));
}
template <class T>
[[nodiscard]] given_light given(const umbrage::dual_paraboloid_light<T>& light) {
    given_light bulb = bulb_of(light.position, 0.01, double(light.range));
    bulb.clips = false;
    return bulb;
}
template <class Light>
[[nodiscard]] given_light given(const Light& light) {
    const auto all = typename umbrage::setup_for<Light>::type(light).lights();
    return light_of(all[0].view, all[0].projection);
}

/// A shadow's places and biases. Contact hardening and prefilters state no bias: those of a disc of their reach hold.
template <class Shadow>
[[nodiscard]] proof::shadow_facts facts_of(const Shadow& s, glm::dvec3 origin) {
    if constexpr (requires { s.peter_panning_distance(glm::vec3(), glm::vec3()); })
        return proof::shadow_facts(s, origin);
    else {
        const float reach = umbrage::detail::reach_of(s.filter());
        return proof::shadow_facts(
            umbrage::shadow(s.setup(), s.map_size(), umbrage::filters::disc{.radius_texels = reach}, {}, origin),
            origin);
    }
}

[[nodiscard]] inline umbrage::mesh_view planted_mesh(std::vector<glm::vec3>& positions,
                                                     std::vector<glm::uvec3>& triangles) {
    if (is_planted(fault::triangle_dropped) && !triangles.empty()) triangles.pop_back();
    if (is_planted(fault::index_off_by_one))
        for (glm::uvec3& t : triangles) t = (t + 1u) % unsigned(positions.size());
    return {positions, triangles};
}

}  // namespace turned

namespace watched {

template <shadow_setup Setup, class Filter, class Encoding = typename ::umbrage::detail::encoding_for<Filter>::type>
class shadow : public ::umbrage::shadow<Setup, Filter, Encoding> {
    using base = ::umbrage::shadow<Setup, Filter, Encoding>;

public:
    using typename base::texel;

    template <class Light>
    shadow(const Light& light, glm::ivec2 map_size, const Filter& filter = {}, const Encoding& encoding = {},
           glm::dvec3 origin = glm::dvec3(0))
        : base(turned::planted(light), map_size, filter, encoding, planted_origin(origin)),
          drawn_(std::make_shared<turned::drawn_shadow>(
              turned::drawn_shadow{turned::facts_of(static_cast<const base&>(*this), origin),
                                   turned::given(light),
                                   origin,
                                   prefilter<Filter>,
                                   {}})) {
        if (drawn_->light.rays.is_point) drawn_->light.rays.from -= origin;
    }

    shadow(const shadow&) = default;
    shadow& operator=(const shadow&) = default;
    /// One that a program only binds to shaders is judged over a scene of the judge's own, and so is each point light.
    ~shadow() {
        if (drawn_.use_count() != 1 || std::uncaught_exceptions() > 0) return;
        if (drawn_->surfaces.empty()) judge_own(turned::own_vertices);
        if (drawn_->light.surrounds) judge_own(turned::tilted_around(drawn_->light.rays.from));
    }

    template <class ParallelFor = serial>
    void draw(image_view<float> depths, const mesh_view& mesh, ParallelFor&& parallel = {}) const
        requires(!std::is_convertible_v<ParallelFor, std::span<const glm::mat4>>) {
        std::vector<glm::vec3> positions;
        std::vector<glm::uvec3> triangles;
        for (const glm::vec3 p : mesh.positions) positions.push_back(p);
        for (const glm::uvec3 t : mesh.triangles) triangles.push_back(t);
        drawn_->add(positions, triangles);
        base::draw(depths, turned::planted_mesh(positions, triangles), parallel);
        judge(depths);
    }

    [[nodiscard]] float operator()(image_view<const texel> map, glm::vec3 world, glm::vec3 normal,
                                   glm::ivec2 pixel = {}) const {
        const float v = look(map, world, normal, pixel);
        if (!drawn_->surfaces.empty()) drawn_->judge(world, normal, v);
        return v;
    }

    template <class ParallelFor = serial>
    void visibility(image_view<const texel> map, image_view<const glm::vec3> points,
                    image_view<const glm::vec3> normals, image_view<float> out, ParallelFor&& parallel = {}) const {
        base::visibility(map, points, normals, out, parallel);
        for (int i = 0; i < 64 && !out.empty(); ++i) {
            const glm::ivec2 p(i * 7919 % out.size.x, i * 104729 % out.size.y);
            drawn_->judge(points[p], normals[p], out[p]);
        }
    }

private:
    void judge_own(const std::vector<glm::vec3>& vertices) const try {
        drawn_->surfaces.clear();
        image<float> depths(this->size(), cleared_depth(this->setup().clip()));
        draw(depths, {vertices, turned::own_triangles});
    } catch (const std::invalid_argument& e) { turned::add_wrong(e.what()); }

    [[nodiscard]] static glm::dvec3 planted_origin(glm::dvec3 origin) {
        return turned::is_planted(turned::fault::origin_dropped) ? glm::dvec3(0) : origin;
    }
    [[nodiscard]] float look(image_view<const texel> map, glm::vec3 world, glm::vec3 normal, glm::ivec2 pixel) const {
        if (turned::is_planted(turned::fault::normal_dropped)) normal = glm::vec3(0);
        if (turned::is_planted(turned::fault::bias_of_wrong_sign))
            world -= 0.02f * glm::normalize(glm::vec3(drawn_->light.rays.way(glm::dvec3(world))));
        return base::operator()(map, world, normal, pixel);
    }
    void judge(image_view<float> depths) const {
        if (turned::is_planted(turned::fault::map_one_texel_off))
            for (int y = 0; y < depths.size.y; ++y)
                for (int x = 0; x + 1 < depths.size.x; ++x) depths[{x, y}] = depths[{x + 1, y}];
        image<texel> map(this->size(), this->cleared());
        this->store(depths, map);
        drawn_->visibility = [&](glm::vec3 p, glm::vec3 n) { return look(map, p, n, {}); };
        drawn_->judge_surfaces();
    }

    std::shared_ptr<turned::drawn_shadow> drawn_;
};

template <class Light, class Filter, class Encoding = typename ::umbrage::detail::encoding_for<Filter>::type>
shadow(const Light&, glm::ivec2, const Filter&, const Encoding& = {}, glm::dvec3 = glm::dvec3(0))
    -> shadow<typename ::umbrage::setup_for<Light>::type, Filter, Encoding>;

}  // namespace watched
