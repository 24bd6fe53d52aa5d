// SPDX-License-Identifier: MIT
//
// The proof's scenes of triangles and rays, as inputs for a shader: a light's matrix, its map, receivers on triangles.
#pragma once

#include <optional>
#include <vector>

#include "../../proof/rays.hpp"
#include "../entry.hpp"

namespace parity {

enum class ray_kind { spot, directional, cascade };

/// A random scene, a light fitted to it and its shadow map. Depth runs forward.
class ray_light : proof::ray_scene {
public:
    static constexpr float widest_reach = 5.0f;  ///< texels around each receiver that are in the map

    ray_light(ray_kind kind, std::uint64_t n);

    struct receiver {
        vec3 world{0.0f};
        std::size_t triangle = 0;
        vec2 share{0.0f};  ///< shares of the triangle's second and third corner
    };
    /// A point of a triangle that camera and light hold. Only of a light that has_receivers.
    [[nodiscard]] receiver draw(random& r) const;
    /// True when one in 32 points or more is such a receiver.
    [[nodiscard]] bool has_receivers() const;
    [[nodiscard]] std::array<vec3, 3> corners_of(const receiver& p) const;

    /// Moves a receiver along an edge of its triangle until x, in texels, is a multiple of 1 / steps.
    void move_to_border(receiver& p, int steps) const;

    /// Writes what the shader takes of a receiver.
    /// @param reach   reach of its filter, texels
    void fill(const receiver& p, float reach, sample& s) const;

    /// Raises the bias of such inputs until the receiver's depth is what its texel stores, where it is farther away.
    /// @param result   visibility, coordinate and receiver of the inputs
    void move_to_depth(sample& s, vec4 result) const;

    /// True when rays decide that a receiver is lit or in shadow: no edge is near, and no bias decides.
    [[nodiscard]] bool is_told(const receiver& p, float reach) const;

    [[nodiscard]] const texels& map() const { return map_; }

private:
    void make_cascade(std::uint64_t n);
    [[nodiscard]] std::optional<receiver> try_to_draw(random& r) const;
    [[nodiscard]] bool is_cascade() const { return cascade_.end > cascade_.begin; }
    [[nodiscard]] vec3 coordinate(vec3 world) const {
        return umbrage::project_coordinate(umbrage::shadow_coordinate(matrix_, world));
    }

    umbrage::cascade<float> cascade_{};  ///< cascade, for lights that are one
    texels map_{{1, 1}};
};

/// Reach that the proof allows for a filter, with rounded coordinates and vertices moved by a rasterizer.
[[nodiscard]] constexpr float allowed_reach(float reach) { return reach + umbrage::rasterizer_snap<float> + 0x1p-10f; }

/// The first `count` lights of a kind that have receivers.
[[nodiscard]] std::vector<ray_light> ray_lights(ray_kind kind, std::size_t count);

}  // namespace parity
