// SPDX-License-Identifier: MIT
//
// Triangles of a chunk by the bands of rows in which they may be visible: as many at a time as some memory holds.
//
//     band_lists<> lists;  // for one chunk after the other
//     lists.begin(chunk.count(), bands);
//     while (lists.fill(serial{}, [&](unsigned triangle, const auto& put) { put({first, last}, triangle); }))
//         for (int band = 0; band < bands; ++band) lists.for_each(band, [&](const auto& list) { ... });
//
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

#include <umbrage/core/config.hpp>
#include <umbrage/core/parallel.hpp>
#include <umbrage/draw/raster/projection.hpp>
#include <umbrage/simd/min_max.hpp>

namespace umbrage::detail {

template <class = on_use>
class band_lists {
public:
    static constexpr unsigned piece = 1 << 16;  ///< triangles that a thread reads at a time

    /// Part of a triangle that crosses planes.
    struct part {
        snapped_vertex a, b, c;
        unsigned triangle;
    };
    /// Triangles of a piece that may be visible in a band.
    struct list {
        std::vector<unsigned> whole;  ///< triangles of the chunk
        std::vector<part> parts;
        void add(unsigned triangle) { whole.push_back(triangle); }
        void add(const part& of) { parts.push_back(of); }
    };

    void begin(unsigned triangles, int bands) {
        count_ = triangles;
        bands_ = static_cast<std::size_t>(bands);
        read_.assign((triangles + piece - 1) / piece, 0);
        lists_.resize(read_.size() * bands_);
    }

    /// Replaces the lists by those of the next triangles, until the lists of each piece are full.
    /// @param read   (unsigned triangle, const auto& put): calls put(bands, what) for a triangle or its parts. `bands`
    ///               are first <= band < second
    /// @return       false if no triangle was left
    template <class ParallelFor, class Read>
    bool fill(ParallelFor&& parallel, const Read& read) {
        const std::size_t before = triangles_read();
        if (before == count_) return false;
        for (list& each : lists_) each.whole.clear(), each.parts.clear();
        in_pieces(static_cast<int>(read_.size()), parallel, [&](int from, int to) {
            for (std::size_t p = std::size_t(from); p < std::size_t(to); ++p) {
                const unsigned first = unsigned(p) * piece, count = lesser(piece, count_ - first);
                list* const lists = lists_.data() + p * bands_;
                std::size_t bytes = 0;
                const auto put = [&](const glm::ivec2& bands, const auto& what) {
                    for (int band = bands.x; band < bands.y; ++band) lists[band].add(what), bytes += sizeof(what);
                };
                unsigned i = read_[p];
                for (; i < count && bytes < full; ++i) read(first + i, put);
                read_[p] = i;
            }
        });
        return triangles_read() > before;
    }

    /// Calls use() with each list of a band.
    template <class Use>
    void for_each(int band, const Use& use) const {
        for (std::size_t i = std::size_t(band); i < lists_.size(); i += bands_) use(lists_[i]);
    }

private:
    static constexpr std::size_t full = 1 << 20;  // bytes of a piece's lists

    [[nodiscard]] std::size_t triangles_read() const {
        std::size_t sum = 0;
        for (const unsigned of_piece : read_) sum += of_piece;
        return sum;
    }

    unsigned count_ = 0;
    std::size_t bands_ = 1;
    std::vector<list> lists_;     // per piece, band by band
    std::vector<unsigned> read_;  // per piece, number of triangles that were read
};

}  // namespace umbrage::detail
