// SPDX-License-Identifier: MIT
//
// The triangles of a mesh sorted into bands of rows, which threads draw side by side.
//
//     const banded_triangles banded(projected, size, parallel);
//     banded.for_each(band, [&](unsigned triangle) { ... });
//
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

#include <umbrage/simd/raster/projected_mesh.hpp>
#include <umbrage/simd/strict_math.hpp>

UMBRAGE_STRICT_MATH
namespace umbrage::detail {

/// Which triangles may touch which band of rows, so that a band stays in the cache while it is drawn.
class banded_triangles {
public:
    template <class ParallelFor>
    banded_triangles(const projected_mesh& mesh, glm::ivec2 size, ParallelFor&& parallel)
        : mesh_(mesh),
          rows_(std::clamp(band_texels / std::max(size.x, 1), 1, band_rows)),
          bands_((size.y + rows_ - 1) / rows_) {
        const unsigned triangles = mesh.triangle_count(), pieces = (triangles + piece - 1) / piece;
        lists_.resize(std::size_t(pieces) * std::size_t(bands_));
        parallel(static_cast<int>(pieces), [&](int first, int last) {
            for (unsigned i = unsigned(first) * piece; i < std::min(unsigned(last) * piece, triangles); ++i) {
                const auto [low, high] = mesh.rows(i, size.y);
                for (int band = low / rows_; band * rows_ < high; ++band)
                    lists_[std::size_t(i / piece) * std::size_t(bands_) + std::size_t(band)].push_back(i);
            }
        });
    }

    [[nodiscard]] int bands() const { return bands_; }
    [[nodiscard]] int rows() const { return rows_; }

    /// In the mesh's order.
    template <class Use>
    void for_each(int band, const Use& use) const {
        for (std::size_t i = std::size_t(band); i < lists_.size(); i += std::size_t(bands_))
            for (std::size_t k = 0; k < lists_[i].size(); ++k) {
                mesh_.expect(lists_[i], k);
                use(lists_[i][k]);
            }
    }

private:
    static constexpr int band_texels = 1 << 16, band_rows = 64;
    static constexpr unsigned piece = 1 << 16;  // triangles that one thread sorts at a time

    const projected_mesh& mesh_;
    int rows_, bands_;
    std::vector<std::vector<unsigned>> lists_;  // of a piece, band by band
};

}  // namespace umbrage::detail
UMBRAGE_END_STRICT_MATH
