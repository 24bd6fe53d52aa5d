// SPDX-License-Identifier: MIT
//
// Chunk of a mesh's triangles in some instances, with vertices projected and snapped: as many as fit a cache.
//
//     snapped_chunk chunk(mesh, projections);
//     chunk.take(first_triangle, first_instance, 1 << 16);
//     chunk.snap(serial{});
//     for (unsigned i = 0; i < chunk.count(); ++i) use(chunk.vertex(chunk.place_of(i), 0));
//
// Triangles are counted on from one instance to the next, and so are vertices.
//
#pragma once

#include <cstddef>
#include <span>

#include <glm/vec3.hpp>

#include <umbrage/core/config.hpp>
#include <umbrage/core/parallel.hpp>
#include <umbrage/draw/mesh.hpp>
#include <umbrage/draw/raster/projection.hpp>
#include <umbrage/simd/dispatch.hpp>
#include <umbrage/simd/min_max.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// Memory for vertices, each written before it is read. A vector would write them twice. (<memory>, which has a class
/// for this, includes the streams.)
class unwritten_vertices {
public:
    unwritten_vertices() = default;
    unwritten_vertices(const unwritten_vertices&) = delete;
    unwritten_vertices& operator=(const unwritten_vertices&) = delete;
    ~unwritten_vertices() { delete[] data_; }

    /// Makes room for `count` vertices. Keeps nothing.
    void make(std::size_t count) {
        if (count <= count_) return;
        delete[] data_;
        data_ = nullptr;
        data_ = new snapped_vertex[count];
        count_ = count;
    }
    [[nodiscard]] snapped_vertex* data() const { return data_; }
    [[nodiscard]] const snapped_vertex& operator[](std::size_t i) const { return data_[i]; }

private:
    snapped_vertex* data_ = nullptr;
    std::size_t count_ = 0;
};

struct index_range {
    unsigned lowest = ~0u, highest = 0;

    void include(const index_range& other) {
        lowest = lesser(lowest, other.lowest), highest = greater(highest, other.highest);
    }
    [[nodiscard]] std::size_t count() const { return std::size_t(highest) - lowest + 1; }
};

/// Range of the indices of triangles first <= t < last.
template <class = on_use>
[[nodiscard]] index_range indices_of(const triangle_view& triangles, std::size_t first, std::size_t last) {
    index_range range;
    on_best_isa([&](auto) UMBRAGE_INLINE {
        triangles.stored_from(first, [&](const auto* indices, std::size_t step) UMBRAGE_INLINE {
            unsigned low = ~0u, high = 0;
            const auto include = [&](unsigned index) UMBRAGE_INLINE {
                low = low < index ? low : index;
                high = high < index ? index : high;
            };
            const std::size_t count = step * (last - first);
            std::size_t i = 0;
            if (step == 3)  // no gaps
                for (; count - i >= block; i += block)
                    for (std::size_t k = 0; k < block; ++k) include(indices[i + k]);
            for (; i < count; ++i)
                if (i % step < 3) include(indices[i]);
            range = {low, high};
        });
    });
    return range;
}

/// Instance of a chunk, and triangle of the mesh.
struct drawn_triangle {
    std::size_t instance, triangle;
};

template <class = on_use>
class snapped_chunk {
public:
    explicit snapped_chunk(const mesh_view& mesh) : mesh_(mesh) {}

    /// Takes triangles from a given one and a given instance on. These are the rest of the mesh and as many further
    /// instances as `most` has room for, or `most` triangles.
    /// @param instances   from that instance on, at least one
    /// @param indices     range of the vertex indices of these triangles
    void take(std::size_t first, std::span<const projection> instances, std::size_t most, const index_range& indices) {
        first_ = first;
        triangles_ = lesser(most, mesh_.triangles.size() - first);
        const std::size_t corners = 3 * triangles_, range = indices.count();
        by_corner_ = corners < range;
        lowest_ = indices.lowest;
        used_ = lesser(corners, range);
        stride_ = (used_ + block - 1) / block * block;
        const bool whole = triangles_ == mesh_.triangles.size();
        const std::size_t room = whole ? greater(most / greater(triangles_, stride_), std::size_t(1)) : 1;
        instances_ = instances.first(lesser(room, instances.size()));
    }

    [[nodiscard]] std::size_t instances() const { return instances_.size(); }
    [[nodiscard]] unsigned count() const { return static_cast<unsigned>(triangles_ * instances_.size()); }

    template <class ParallelFor>
    void snap(ParallelFor&& parallel) {
        const std::size_t blocks = stride_ / block * instances_.size();
        vertices_.make(blocks * block);
        constexpr std::size_t piece = 64;  // blocks that a thread takes at a time
        parallel(static_cast<int>((blocks + piece - 1) / piece), [&](int begin, int end) {
            for (std::size_t i = std::size_t(begin) * piece; i < lesser(std::size_t(end) * piece, blocks); ++i) {
                const std::size_t instance = i * block / stride_, vertex = i * block - instance * stride_;
                alignas(64) glm::vec3 positions[block];
                for (std::size_t k = 0; k < block; ++k) positions[k] = position(lesser(vertex + k, used_ - 1));
                instances_[instance].snap(positions, vertices_.data() + i * block);
            }
        });
    }

    /// Instance and triangle of the chunk's i-th triangle.
    /// @param i   below count()
    [[nodiscard]] UMBRAGE_INLINE drawn_triangle place_of(unsigned i) const {
        if (instances_.size() == 1) return {0, first_ + i};
        const unsigned triangles = static_cast<unsigned>(triangles_), instance = i / triangles;
        return {instance, first_ + (i - instance * triangles)};
    }

    [[nodiscard]] UMBRAGE_INLINE const snapped_vertex& vertex(const drawn_triangle& at, glm::length_t corner) const {
        const std::size_t vertex = by_corner_ ? 3 * (at.triangle - first_) + std::size_t(corner)
                                              : std::size_t(mesh_.triangles.index(at.triangle, corner) - lowest_);
        return vertices_[at.instance * stride_ + vertex];
    }

    /// Corner before it was snapped.
    [[nodiscard]] glm::dvec4 homogeneous(const drawn_triangle& at, glm::length_t corner) const {
        return instances_[at.instance].homogeneous(mesh_.positions[mesh_.triangles.index(at.triangle, corner)]);
    }
    [[nodiscard]] const projection& projection_of(const drawn_triangle& at) const { return instances_[at.instance]; }

private:
    [[nodiscard]] glm::vec3 position(std::size_t i) const {
        if (!by_corner_) return mesh_.positions[lowest_ + i];
        return mesh_.positions[mesh_.triangles.index(first_ + i / 3, glm::length_t(i % 3))];
    }

    mesh_view mesh_;
    std::span<const projection> instances_;
    std::size_t first_ = 0, triangles_ = 0;
    std::size_t used_ = 0, stride_ = 0;  // vertices of an instance, and the same rounded up to blocks
    unsigned lowest_ = 0;                // index
    bool by_corner_ = false;             // three vertices per triangle, instead of a range of the mesh's
    unwritten_vertices vertices_;
};

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH
