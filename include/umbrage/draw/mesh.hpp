// SPDX-License-Identifier: MIT
//
// Meshes for the depth pass: triangles, drawn once or as instances, each with its matrix.
//
//     umbrage::mesh_view mesh{positions, triangles};
//     umbrage::mesh_view same{{&vertices[0].position.x, vertices.size(), sizeof(vertex)}, indices};  // interleaved
//
// Also called: depth clamp, GL_DEPTH_CLAMP, depthClipEnable (near_plane); negative scale, mirrored instances, flipped
// winding, glFrontFace (is_mirrored); interleaved vertices, byteStride (position_view); 16-bit indices, index buffer,
// UNSIGNED_SHORT (triangle_view).
//
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include <umbrage/core/check.hpp>
#include <umbrage/core/config.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage {
namespace detail {

/// Element of a view by its index, for loops over all.
template <class View>
struct element_of {
    const View* view;
    std::size_t i;

    [[nodiscard]] auto operator*() const { return (*view)[i]; }
    element_of& operator++() { return ++i, *this; }
    [[nodiscard]] bool operator==(const element_of&) const = default;
};

}  // namespace detail

/// Positions of a mesh: packed, or a part of larger vertices, as in interleaved buffers. The view does not own them.
class position_view {
public:
    position_view() = default;

    /// @param all   glm::vec3 one after the other: a span, a vector, an array
    template <std::convertible_to<std::span<const glm::vec3>> All>
    position_view(const All& all) {
        const std::span<const glm::vec3> packed(all);
        first_ = reinterpret_cast<const float*>(packed.data()), count_ = packed.size();
    }

    /// @param first    x of the first position; y and z follow it
    /// @param count    number of positions
    /// @param stride   bytes from one position to the next, at least 12 and a multiple of 4: the size of a vertex, or
    ///                 glTF's byteStride. Packed positions without one have 12
    /// @throws std::invalid_argument  another stride; no first position of some
    position_view(const float* first, std::size_t count, std::size_t stride)
        : first_(first), count_(count), stride_(stride / sizeof(float)) {
        constexpr auto function = "position_view";
        detail::require(stride >= 3 * sizeof(float) && stride % sizeof(float) == 0, function, "stride",
                        "a multiple of 4 bytes, 12 or more", stride);
        detail::require(first || count == 0, function, "count", "0 where first is null", count);
    }

    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] bool empty() const { return count_ == 0; }
    [[nodiscard]] UMBRAGE_INLINE glm::vec3 operator[](std::size_t i) const {
        const float* const p = first_ + i * stride_;
        return {p[0], p[1], p[2]};
    }
    [[nodiscard]] detail::element_of<position_view> begin() const { return {this, 0}; }
    [[nodiscard]] detail::element_of<position_view> end() const { return {this, count_}; }

private:
    const float* first_ = nullptr;
    std::size_t count_ = 0, stride_ = sizeof(glm::vec3) / sizeof(float);  // floats
};

/// Triangles of a mesh: three indices each, of 32 or 16 bits. The view does not own them.
class triangle_view {
public:
    triangle_view() = default;

    /// @param all   glm::uvec3 for each triangle: a span, a vector, an array
    template <std::convertible_to<std::span<const glm::uvec3>> All>
    triangle_view(const All& all) : step_(sizeof(glm::uvec3) / sizeof(std::uint32_t)) {
        const std::span<const glm::uvec3> triangles(all);
        words_ = reinterpret_cast<const std::uint32_t*>(triangles.data()), count_ = triangles.size();
    }

    /// @param all   three indices for each triangle
    /// @throws std::invalid_argument  a number of indices that is no multiple of 3
    template <std::convertible_to<std::span<const std::uint32_t>> All>
    triangle_view(const All& all) {
        const std::span<const std::uint32_t> indices(all);
        words_ = indices.data(), count_ = triangles_of(indices.size());
    }
    template <std::convertible_to<std::span<const std::uint16_t>> All>
    triangle_view(const All& all) {
        const std::span<const std::uint16_t> indices(all);
        shorts_ = indices.data(), count_ = triangles_of(indices.size());
    }

    [[nodiscard]] std::size_t size() const { return count_; }
    [[nodiscard]] bool empty() const { return count_ == 0; }
    [[nodiscard]] UMBRAGE_INLINE std::uint32_t index(std::size_t triangle, glm::length_t corner) const {
        const std::size_t i = triangle * step_ + std::size_t(corner);
        return shorts_ ? shorts_[i] : words_[i];
    }
    [[nodiscard]] glm::uvec3 operator[](std::size_t i) const { return {index(i, 0), index(i, 1), index(i, 2)}; }
    [[nodiscard]] detail::element_of<triangle_view> begin() const { return {this, 0}; }
    [[nodiscard]] detail::element_of<triangle_view> end() const { return {this, count_}; }

    /// Calls use(indices, step) with the indices from a triangle on, as they are in memory. `step` is the number from
    /// one triangle to the next: 3, or 4 for a glm::uvec3 that is aligned as four.
    template <class Use>
    UMBRAGE_INLINE void stored_from(std::size_t triangle, const Use& use) const {
        if (shorts_) use(shorts_ + triangle * step_, step_);
        else use(words_ + triangle * step_, step_);
    }

private:
    [[nodiscard]] static std::size_t triangles_of(std::size_t indices) {
        detail::require(indices % 3 == 0, "triangle_view", "indices.size()", "a multiple of 3", indices);
        return indices / 3;
    }

    const std::uint32_t* words_ = nullptr;   // these
    const std::uint16_t* shorts_ = nullptr;  // or those
    std::size_t count_ = 0, step_ = 3;       // indices from one triangle to the next
};

/// Triangles with three indices into the positions each. The view does not own them.
struct mesh_view {
    position_view positions;
    triangle_view triangles;
};

/// Faces to leave out. Front faces are counter-clockwise in NDC with x to the right and y up, as in most right-handed
/// worlds. In most left-handed worlds they are clockwise: exchange front and back there. An instance that mirrors its
/// mesh keeps its faces: front faces are those of the mesh.
enum class cull_mode { none, front, back };

/// Treatment of casters in front of the near plane: clipped, or clamped to the near plane (pancaking).
///
/// Clamped casters between the light and a near plane at the receivers still cast shadows. GPUs call it depth clamp,
/// but here the far plane still clips. A clamped caster has the near plane's depth. A receiver nearer to that plane
/// than its bias is lit behind any such caster. Fits without casters need a margin above the largest bias.
enum class near_plane { clips, clamps };

/// Matrix with which an instance of a mesh is drawn.
/// @param world_to_clip   projection * view
/// @param model           model to world
/// @exactness             the product in double, rounded once. Far from the world's origin a float product would lose
///                        the precision that remains after the camera's or the light's position is subtracted
template <class = detail::on_use>
[[nodiscard]] glm::mat4 model_to_clip(const glm::mat4& world_to_clip, const glm::mat4& model) {
    return glm::mat4(glm::dmat4(world_to_clip) * glm::dmat4(model));
}

/// True when an instance mirrors its mesh, as a negative scale along one or three axes does. Such an instance turns
/// front faces clockwise, so a GPU needs the other glFrontFace for it. The depth pass of instances takes care of it.
/// @param model   model to world
/// @formula       determinant of the upper left 3 x 3 < 0
/// @edge          a model that is flat or not finite: false, or as its rounded determinant has it
template <class = detail::on_use>
[[nodiscard]] bool is_mirrored(const glm::mat4& model) {
    const glm::dmat4 m(model);
    return glm::dot(glm::cross(glm::dvec3(m[0]), glm::dvec3(m[1])), glm::dvec3(m[2])) < 0.0;
}

namespace detail {

/// Faces to leave out of a mesh whose matrix mirrors it.
[[nodiscard]] constexpr cull_mode mirrored(cull_mode cull) {
    if (cull == cull_mode::none) return cull;
    return cull == cull_mode::front ? cull_mode::back : cull_mode::front;
}

}  // namespace detail

}  // namespace umbrage
UMBRAGE_END_STRICT_MATH
