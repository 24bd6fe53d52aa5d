// SPDX-License-Identifier: MIT
//
// A function over a whole image against its primitive: odd sizes, rows with gaps and upside down, every instruction set
// of the machine, any cut into pieces.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <string>
#include <vector>

#include <umbrage/core/image.hpp>
#include <umbrage/simd/dispatch.hpp>

#include "hostile.hpp"

namespace hostile {

using namespace umbrage;
using detail::best_isa;
using detail::isa;

inline constexpr glm::ivec2 sizes[] = {{1, 1}, {63, 3}, {64, 2}, {65, 5}, {130, 4}, {3, 131}};
inline constexpr glm::ivec2 map_sizes[] = {{1, 1},   {2, 2},   {8, 8},
                                           {40, 24}, {17, 33}, {9, 1}};  // one for each of the above

inline bool all_equal = true;

/// As many pieces, the last first.
struct pieces {
    int count;
    template <class Piece>
    void operator()(int n, Piece&& piece) const {
        for (int i = count - 1; i >= 0; --i)
            if (n * i / count < n * (i + 1) / count) piece(n * i / count, n * (i + 1) / count);
    }
};

template <class T>
void copy(const image<T>& from, image_view<T> to) {
    for (int y = 0; y < to.size.y; ++y) std::copy_n(from.view().row(y), to.size.x, to.row(y));
}

/// Texels without gaps between the rows, with gaps, or with gaps and the last row first.
template <class T>
class laid_out {
public:
    laid_out(glm::ivec2 size, int layout)
        : gap_(layout ? 3 : 0), row_(std::size_t(size.x + gap_)), texels_(row_ * std::size_t(size.y)) {
        std::memset(static_cast<void*>(texels_.data()), 0xA5, texels_.size() * sizeof(T));
        const auto stride = static_cast<std::ptrdiff_t>(row_ * sizeof(T));
        view_ = layout == 2 ? image_view<T>(texels_.data() + row_ * std::size_t(size.y - 1), size, -stride)
                            : image_view<T>(texels_.data(), size, stride);
    }
    laid_out(const image<T>& from, int layout) : laid_out(from.size(), layout) { copy(from, view_); }

    [[nodiscard]] image_view<T> view() const { return view_; }
    [[nodiscard]] bool gaps_are_untouched() const {
        const std::vector<unsigned char> untouched(std::size_t(gap_) * sizeof(T), 0xA5);
        for (std::size_t end = row_; end <= texels_.size(); end += row_)
            if (gap_ && std::memcmp(&texels_[end] - gap_, untouched.data(), untouched.size()) != 0) return false;
        return true;
    }

private:
    int gap_;
    std::size_t row_;
    std::vector<T> texels_;
    image_view<T> view_;
};

template <class T>
digest digest_of(const T& texel) {
    digest d;
    d(texel);
    return d;
}

/// Builds that agree on a result: all in every mode, all in the same rounding mode, or none, as compilers may fuse.
enum class agree { everywhere, in_a_mode, in_a_build };

struct image_suite : setting {
    /// @param one    (int case, glm::ivec2 texel) -> T, by the primitive
    /// @param whole  (int case, image_view<T> out, pieces), by the function under test
    /// @param where  what the digest is compared with; without one, the primitive of the same build alone
    template <class T, class One, class Whole>
    void run(const std::string& name, One one, Whole whole, agree where = agree::everywhere) const {
        const isa best = best_isa();
        digest sum;
        int count = 0, differ = 0;
        for (int s = 0; s < int(std::size(sizes)); ++s) {
            const glm::ivec2 size = sizes[s];
            std::vector<digest> expected;
            for (int y = 0; y < size.y; ++y)
                for (int x = 0; x < size.x; ++x) expected.push_back(digest_of(one(s, glm::ivec2(x, y))));
            count += size.x * size.y;
            for (const isa set : {isa::base, isa::avx2, isa::avx512})
                for (const int n : {1, 2, 3, 7}) {
                    if (best < set) continue;
                    detail::isa_in_use = set;
                    const laid_out<T> out(size, (n + int(set)) % 3);
                    whole(s, out.view(), pieces{n});
                    differ += !out.gaps_are_untouched();
                    for (int y = 0, i = 0; y < size.y; ++y)
                        for (int x = 0; x < size.x; ++x, ++i) {
                            const T& texel = out.view()[{x, y}];
                            if (set == isa::base && n == 1) sum(texel);
                            const digest got = digest_of(texel), wanted = expected[std::size_t(i)];
                            // rounding down, x - x is -0: then the sign of a zero is not looked at
                            const bool same = mode == "downward" ? got.unsigned_zeros == wanted.unsigned_zeros
                                                                 : got.hash == wanted.hash;
                            differ += !same;
                        }
                }
        }
        detail::isa_in_use = best;
        if (differ) {
            std::fprintf(stderr, "%s %s %s: %d texels differ from the primitive's\n", name.c_str(),
                         std::to_string(int(what)).c_str(), mode.c_str(), differ);
            all_equal = false;
        }
        if (where == agree::in_a_build) return;
        const bool own = where == agree::in_a_mode && (mode == "upward" || mode == "downward" || mode == "to-zero");
        setting{what, flush, own ? "itself-" + mode : mode}.print(name, count, sum);
    }

    template <class T, class Draw>
    std::vector<image<T>> images(const glm::ivec2 (&extents)[std::size(sizes)], Draw draw) const {
        source from{what, flush};
        std::vector<image<T>> drawn;
        for (const glm::ivec2 size : extents) {
            drawn.emplace_back(size);
            for (T& texel : drawn.back().texels()) texel = draw(from, drawn.size() - 1);
        }
        return drawn;
    }
};

}  // namespace hostile
