// SPDX-License-Identifier: MIT
//
// A program with one kind of shadow. Each filter's hosts are a file, which compiles alone.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <type_traits>
#include <utility>
#include <variant>

#include <umbrage/depth/encodings.hpp>
#include <umbrage/shadow/shadow.hpp>

#include "host.hpp"
#include "host_of_filter.hpp"
#include "wrong_steps.hpp"

namespace joints {

template <class Setup, class Filter, class Encoding>
class host final : public any_host {
public:
    using shadow = umbrage::shadow<Setup, Filter, Encoding>;
    using texel = typename Encoding::texel;

    host(shadow s, glm::dvec3 origin)
        : any_host(proof::shadow_facts(s, origin)), shadow_(std::move(s)), origin_(origin), map_(shadow_.size()) {}

    void draw(const scene& of) override {
        umbrage::image<float> depths(shadow_.size(), umbrage::cleared_depth(shadow_.setup().clip()));
        shadow_.draw(depths, of.mesh());
        if (!of.instances.empty()) shadow_.draw(depths, scene::cube(), of.instances);
        shadow_.store(depths, map_);
    }
    float visibility(const looked_up& r) const override { return shadow_(map_, r.point, r.normal, r.pixel); }
    void visibility(umbrage::image_view<const glm::vec3> points, umbrage::image_view<const glm::vec3> normals,
                    umbrage::image_view<float> out) const override {
        shadow_.visibility(map_, points, normals, out);
    }
    bool draw_wrong(const scene& of, const tweaks& t) override {
        if constexpr (!gets_wrong) return false;
        else {
            wrong_.emplace(shadow_, origin_, t);
            return wrong_->draw(of, map_);
        }
    }
    float wrong_visibility(const looked_up& r) const override {
        if constexpr (gets_wrong) return wrong_->visibility(map_, r);
        else return visibility(r);
    }

private:
    /// Two encodings show every fault; more would only cost compile time.
    static constexpr bool gets_wrong =
        std::is_same_v<Encoding, umbrage::depth32f> || std::is_same_v<Encoding, umbrage::depth16>;

    shadow shadow_;
    glm::dvec3 origin_;
    umbrage::image<texel> map_;
    std::optional<std::conditional_t<gets_wrong, wrong_steps<shadow>, int>> wrong_{};
};

/// The host of a filter's shadow.
template <class Filter>
[[nodiscard]] std::unique_ptr<any_host> host_of(const choices& c, const lit_scene& lit, glm::dvec3 origin,
                                                const Filter& filter) {
    using namespace umbrage;
    return std::visit(
        [&]<class Setup>(const Setup& setup) -> std::unique_ptr<any_host> {
            if constexpr (has_bent_lines<Setup> && detail::contact_hardening<Filter>)
                throw std::logic_error("joints: a paraboloid that hardens contacts was drawn");
            else {
                const auto with = [&]<class Encoding>(const Encoding& encoding) -> std::unique_ptr<any_host> {
                    return std::make_unique<host<Setup, Filter, Encoding>>(
                        shadow(setup, lit.map_size, filter, encoding, origin), origin);
                };
                switch (c.encoding) {
                    case 0: return with(depth32f{});
                    case 1: return with(depth16{});
                    case 2: return with(rg<11>{});
                    default: return with(fourth_encoding<Filter>{});
                }
            }
        },
        lit.setup);
}

}  // namespace joints
