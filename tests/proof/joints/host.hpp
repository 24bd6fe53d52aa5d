// SPDX-License-Identifier: MIT
//
// A program with a shadow, whichever: it draws a scene, stores the depths and looks receivers up, as the library's
// pages say. With tweaks it does so by the steps that a program with a GPU takes, and gets some of them wrong.
#pragma once

#include <memory>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/image.hpp>

#include "../traced_map.hpp"
#include "scene.hpp"
#include "setups.hpp"
#include "tweaks.hpp"

namespace joints {

/// A receiver as a look takes it.
struct looked_up {
    glm::vec3 point, normal;
    glm::ivec2 pixel;
    const surface* own = nullptr;
};

class any_host {
public:
    explicit any_host(proof::shadow_facts f) : facts(std::move(f)) {}
    virtual ~any_host() = default;
    any_host(const any_host&) = delete;
    any_host& operator=(const any_host&) = delete;

    proof::shadow_facts facts;

    virtual void draw(const scene&) = 0;
    [[nodiscard]] virtual float visibility(const looked_up&) const = 0;
    virtual void visibility(umbrage::image_view<const glm::vec3> points, umbrage::image_view<const glm::vec3> normals,
                            umbrage::image_view<float> out) const = 0;
    /// Takes the wrong steps from here on, and draws by them.
    /// @return   false where the draw has no such step
    virtual bool draw_wrong(const scene&, const tweaks&) = 0;
    [[nodiscard]] virtual float wrong_visibility(const looked_up&) const = 0;
};

/// @throws std::invalid_argument   as the shadow
[[nodiscard]] std::unique_ptr<any_host> make_host(const choices& c, const lit_scene& lit, glm::dvec3 origin);
/// Reach of a draw's filter, texels.
[[nodiscard]] float reach_of(const filter_choice& f);

}  // namespace joints
