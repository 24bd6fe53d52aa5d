// SPDX-License-Identifier: MIT
//
// The functions over whole images, as tier_a.cpp has the primitives: odd sizes, rows with gaps and upside down, every
// instruction set of the machine, any cut into pieces. What comes out is compared with the primitive called one by one,
// here, and its digest with that of the other builds, by table.cpp.
//
// Left out: receivers from a camera's depth image are tier C, and blur and tables of floats tier B, of whose sums
// compilers may fuse or reorder the terms; values whose sums need no rounding stand for those. A box's share and the
// planes of depth are tier B too and round as the machine is told to, but to the same bits in every build.
#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <umbrage/depth/rgb24.hpp>
#include <umbrage/depth/foreign/threejs.hpp>
#include <umbrage/images/blur.hpp>
#include <umbrage/images/encode.hpp>
#include <umbrage/images/min_max.hpp>
#include <umbrage/images/rasterize.hpp>
#include <umbrage/images/summed_area.hpp>
#include <umbrage/images/visibility.hpp>

#include "hostile.hpp"

namespace {

using namespace hostile;
using namespace umbrage;
using detail::best_isa;
using detail::isa;
using detail::outside_vertex;
using detail::projection;
using detail::snapped_vertex;

constexpr glm::ivec2 sizes[] = {{1, 1}, {63, 3}, {64, 2}, {65, 5}, {130, 4}, {3, 131}};
constexpr glm::ivec2 map_sizes[] = {{1, 1}, {2, 2}, {8, 8}, {40, 24}, {17, 33}, {9, 1}};  // one for each of the above

bool all_equal = true;

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
    laid_out(const image<T>& from, int layout) : laid_out(from.size(), layout) {
        copy(from, view_);
    }

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

struct suite : setting {
    /// @param one    (int case, glm::ivec2 texel) -> T, by the primitive
    /// @param whole  (int case, image_view<T> out, pieces), by the function under test
    /// @param rounds the result is this rounding mode's own
    template <class T, class One, class Whole>
    void run(const std::string& name, One one, Whole whole, bool rounds = false) const {
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
        const bool own = rounds && (mode == "upward" || mode == "downward" || mode == "to-zero");
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

    template <class Encoding>
    void codec(const std::string& name, Encoding encoding) const {
        using texel = typename Encoding::texel;
        const auto depths = images<float>(sizes, [](source& s, std::size_t) { return s.depth(); });
        run<texel>("encode_" + name, [&](int s, glm::ivec2 t) { return encoding.encode(depths[std::size_t(s)][t]); },
                   [&](int s, image_view<texel> out, pieces parallel) {
                       const laid_out<float> in(depths[std::size_t(s)], parallel.count % 3);
                       encode(in.view(), out, encoding, parallel);
                   });
        const auto texels = images<texel>(sizes, [](source& s, std::size_t) {
            if constexpr (std::is_same_v<texel, float>) return s.any();
            else return s.bytes<texel::length()>();
        });
        run<float>("decode_" + name, [&](int s, glm::ivec2 t) { return encoding.decode(texels[std::size_t(s)][t]); },
                   [&](int s, image_view<float> out, pieces parallel) {
                       const laid_out<texel> in(texels[std::size_t(s)], parallel.count % 3);
                       decode(in.view(), out, encoding, parallel);
                   });
    }

    /// Receivers all over the map and around it, on edges, on weights' steps, and wherever coord() goes.
    std::vector<image<glm::vec3>> receivers(bool short_digits) const {
        return images<glm::vec3>(sizes, [&](source& s, std::size_t i) {
            glm::vec3 r;
            for (int k = 0; k < 2; ++k) {
                const auto steps = static_cast<std::uint32_t>(map_sizes[i][k] * 256 + 2048);
                const float on_step = float(int(s.below(steps)) - 1024) * (1.0f / 256.0f);
                std::uint32_t coord = std::bit_cast<std::uint32_t>(s.one_in(2) ? on_step : s.coord());
                if (short_digits) coord &= 0xFFFFFE00u;  // so that a tap's offset is added exactly
                r[k] = from_bits(coord);
            }
            r.z = s.level();
            return r;
        });
    }

    template <class Encoding>
    std::vector<image<typename Encoding::texel>> maps(Encoding encoding) const {
        return images<typename Encoding::texel>(map_sizes, [&](source& s, std::size_t) {
            if constexpr (std::is_same_v<Encoding, depth32f>) return s.level();
            else return encoding.encode(s.level());
        });
    }

    template <class Encoding, class Filter>
    void visibility_of(const std::string& name, Encoding encoding, Filter filter) const {
        constexpr bool adds = std::is_same_v<Filter, filters::four_tap>;
        constexpr bool box = std::is_same_v<Filter, filters::box>;
        constexpr bool hierarchical = std::is_same_v<Filter, filters::hierarchical_box>;
        const auto map_of = maps(encoding);
        const auto receivers_of = receivers(adds);
        run<float>("visibility_" + name,
                   [&](int s, glm::ivec2 t) {
                       const auto& map = map_of[std::size_t(s)];
                       const glm::vec3 r = receivers_of[std::size_t(s)][t];
                       const auto fetch = [&](glm::ivec2 at) { return encoding.decode(fetch_clamped(map.view(), at)); };
                       return filter(fetch, glm::vec2(r.x, r.y), r.z);
                   },
                   [&](int s, image_view<float> out, pieces parallel) {
                       const laid_out map(map_of[std::size_t(s)], (parallel.count + 1) % 3);
                       const auto& from = receivers_of[std::size_t(s)];
                       if constexpr (std::is_same_v<Filter, filters::pcf_2x2> && std::is_same_v<Encoding, depth32f>)
                           if (parallel.count == 3) {  // as a structure of arrays
                               const laid_out<float> x(from.size(), 0), y(from.size(), 1), depth(from.size(), 2);
                               for (int row = 0; row < out.size.y; ++row)
                                   for (int column = 0; column < out.size.x; ++column) {
                                       const glm::ivec2 t(column, row);
                                       x.view()[t] = from[t].x, y.view()[t] = from[t].y, depth.view()[t] = from[t].z;
                                   }
                               const receiver_planes planes{x.view(), y.view(), depth.view()};
                               return visibility(map.view(), encoding, planes, filter, out, parallel);
                           }
                       const laid_out<glm::vec3> in(from, parallel.count % 3);
                       visibility(map.view(), encoding, in.view(), filter, out, parallel);
                   },
                   box || hierarchical);
    }

    void pyramid() const {
        const auto maps = images<float>(sizes, [](source& s, std::size_t) { return s.any(); });
        constexpr int levels = 3;
        // by the definition: least with -0 below 0, NaN if any is; greatest of the numbers
        const auto extreme = [&](int s, glm::ivec2 t, bool least) {
            const auto& map = maps[std::size_t(s)];
            std::int64_t best = 0;
            bool none = true, nan = false;
            for (int y = t.y; y < std::min(t.y + (1 << levels), map.size().y); ++y)
                for (int x = t.x; x < std::min(t.x + (1 << levels), map.size().x); ++x) {
                    const auto bits = std::bit_cast<std::uint32_t>(map[{x, y}]);
                    if (is_nan(map[{x, y}])) {
                        nan = true;
                        continue;
                    }
                    const std::int64_t magnitude = bits & 0x7FFFFFFFu, key = bits >> 31 ? -magnitude - 1 : magnitude;
                    best = none ? key : least ? std::min(best, key) : std::max(best, key);
                    none = false;
                }
            if (none || (nan && least)) return 0xFFFFFFFFu;
            return static_cast<std::uint32_t>(best < 0 ? (-best - 1) | 0x80000000 : best);
        };
        for (const bool least : {true, false})
            run<std::uint32_t>(least ? "pyramid_least" : "pyramid_greatest",
                               [&](int s, glm::ivec2 t) { return extreme(s, t >> levels << levels, least); },
                               [&](int s, image_view<std::uint32_t> out, pieces parallel) {
                                   const laid_out<float> in(maps[std::size_t(s)], parallel.count % 3);
                                   const auto top = make_min_max_pyramid(in.view(), levels, parallel).back();
                                   const image<float>& bounds = least ? top.least : top.greatest;
                                   for (int y = 0; y < out.size.y; ++y)
                                       for (int x = 0; x < out.size.x; ++x) {
                                           const float v = bounds[{x >> levels, y >> levels}];
                                           out[{x, y}] = is_nan(v) ? 0xFFFFFFFFu : std::bit_cast<std::uint32_t>(v);
                                       }
                               });
    }

    template <class From, class Sum>
    void sums(const std::string& name) const {
        const auto values = images<From>(sizes, [](source& s, std::size_t) {
            return static_cast<From>(std::is_same_v<From, std::uint32_t> ? s.next() : s.below(256));
        });
        std::vector<image<Sum>> tables;
        for (const auto& image_of : values) {
            tables.emplace_back(image_of.size());
            for (int y = 0; y < image_of.size().y; ++y) {
                Sum row{};
                for (int x = 0; x < image_of.size().x; ++x) {
                    row += image_of[{x, y}];
                    tables.back()[{x, y}] = row + (y ? tables.back()[{x, y - 1}] : Sum{});
                }
            }
        }
        run<Sum>("summed_area_" + name, [&](int s, glm::ivec2 t) { return tables[std::size_t(s)][t]; },
                 [&](int s, image_view<Sum> out, pieces parallel) {
                     const laid_out<From> in(values[std::size_t(s)], parallel.count % 3);
                     if (parallel.count == 1) summed_area(in.view(), out);
                     else summed_area(in.view(), out, parallel);
                 });
    }

    /// @param kernel  weights of few digits
    template <class T>
    void blur_of(const std::string& name, const blur_kernel& kernel) const {
        constexpr int channels = detail::float_channels<T>;
        const auto values = images<T>(sizes, [](source& s, std::size_t) {
            std::array<float, channels> v;
            for (float& channel : v) channel = float(int(s.below(512)) - 256);
            return std::bit_cast<T>(v);
        });
        const int radius = int(kernel.weights.size()) - 1;
        run<T>("blur_" + name,
               [&](int s, glm::ivec2 t) {
                   const auto& from = values[std::size_t(s)];
                   const auto weight = [&](int i) { return kernel.weights[std::size_t(i < 0 ? -i : i)]; };
                   T sum(0.0f);
                   for (int j = -radius; j <= radius; ++j)
                       for (int i = -radius; i <= radius; ++i)
                           sum += fetch_clamped(from.view(), t + glm::ivec2(i, j)) * (weight(i) * weight(j));
                   return sum;
               },
               [&](int s, image_view<T> out, pieces parallel) {
                   const laid_out<T> in(values[std::size_t(s)], parallel.count % 3);
                   blur(in.view(), out, kernel, parallel);
               });
    }

    /// Positions to the grid of vertices, inside and outside of the planes.
    void snapping() const {
        const auto positions = images<glm::vec3>(sizes, [](source& s, std::size_t) {
            glm::vec3 p;
            for (int k = 0; k < 3; ++k)
                p[k] = s.one_in(8) ? s.any() : float(int(s.below(1 << 20)) - (1 << 19)) * 0x1p-18f;
            return p;
        });
        source from{what, flush};
        glm::mat4 matrix;
        for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = float(int(from.below(1 << 24)) - (1 << 23)) * 0x1p-23f;
        matrix[3][3] = 1.5f;
        const auto project_for = [&](int s) {
            const auto range = s % 2 ? depth_range::minus_one_to_one : depth_range::zero_to_one;
            const auto direction = s < 3 ? depth_direction::forward : depth_direction::reversed;
            return projection(matrix, {.range = range, .direction = direction}, {1000 + s, 600 - s});
        };
        const auto words = [](const snapped_vertex& v) {
            const auto depth = std::bit_cast<std::uint64_t>(v.depth);
            return glm::uvec4(std::uint32_t(v.x), std::uint32_t(v.y), std::uint32_t(depth), std::uint32_t(depth >> 32));
        };
        run<glm::uvec4>("snap",
                        [&](int s, glm::ivec2 t) {
                            const projection project = project_for(s);
                            const glm::dvec4 h = project.homogeneous(positions[std::size_t(s)][t]);
                            const unsigned planes = project.outside(h);
                            return words(planes ? outside_vertex(planes) : project.snap(h));
                        },
                        [&](int s, image_view<glm::uvec4> out, pieces) {
                            const auto all = positions[std::size_t(s)].texels();
                            for (std::size_t first = 0; first < all.size(); first += detail::block) {
                                glm::vec3 some[detail::block]{};
                                snapped_vertex vertices[detail::block];
                                const std::size_t count = std::min(all.size() - first, std::size_t(detail::block));
                                std::copy_n(all.begin() + std::ptrdiff_t(first), count, some);
                                project_for(s).snap(some, vertices);
                                for (std::size_t i = 0; i < count; ++i) {
                                    const int texel = int(first + i);
                                    out[{texel % out.size.x, texel / out.size.x}] = words(vertices[i]);
                                }
                            }
                        },
                        true);
    }

    /// Triangles whose corners are on the grid of vertices, over the image and its surroundings.
    void coverage() const {
        source from{what, flush};
        std::vector<glm::vec3> positions;
        std::vector<glm::uvec3> triangles;
        const auto coordinate = [&] { return float(int(from.below(1024)) - 512) / 256.0f; };
        for (unsigned i = 0; i < 40; ++i) {
            for (int corner = 0; corner < 3; ++corner) {
                const float x = coordinate();
                positions.emplace_back(x, coordinate(), 0.5f);
            }
            triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
        }
        const auto covered = [&](glm::ivec2 size) {
            image<std::uint32_t> ids(size);
            rasterize(size, {positions, triangles}, glm::mat4(1.0f), {},
                      [&](glm::ivec2 t, float, unsigned id) { ids[t] += 1u + id * id; });
            return ids;
        };
        // by the definition: on the inner side of each edge, or on a top or a left edge, all in integers
        const auto inside = [&](glm::ivec2 size, glm::ivec2 t, unsigned id) {
            std::array<glm::ivec2, 3> v;
            for (int k = 0; k < 3; ++k) {
                const glm::vec3 p = positions[triangles[id][k]];
                const glm::ivec2 steps(int(p.x * 256.0f), int(p.y * 256.0f));
                // (p / 256 + 1) / 2 * size * 256, halves upwards
                for (int c = 0; c < 2; ++c) v[std::size_t(k)][c] = ((steps[c] + 256) * size[c] + 1) >> 1;
            }
            const auto cross = [](glm::ivec2 a, glm::ivec2 b) {
                return std::int64_t(a.x) * b.y - std::int64_t(a.y) * b.x;
            };
            const std::int64_t area = cross(v[1] - v[0], v[2] - v[0]);
            if (area == 0) return false;
            if (area < 0) std::swap(v[1], v[2]);
            for (std::size_t k = 0; k < 3; ++k) {
                const glm::ivec2 a = v[k], edge = v[(k + 1) % 3] - a;
                const std::int64_t side = cross(edge, t * 256 + 128 - a);
                if (side < 0 || (side == 0 && !(edge.y < 0 || (edge.y == 0 && edge.x < 0)))) return false;
            }
            return true;
        };
        run<std::uint32_t>("rasterize_coverage",
                           [&](int s, glm::ivec2 t) {
                               std::uint32_t ids = 0;
                               for (unsigned id = 0; id < triangles.size(); ++id)
                                   if (inside(sizes[s], t, id)) ids += 1u + id * id;
                               return ids;
                           },
                           [&](int s, image_view<std::uint32_t> out, pieces) {
                               const auto ids = covered(sizes[s]);
                               copy(ids, out);
                           });
    }

    /// Triangles in perspective, none of them clipped, into an image that already holds any bits.
    void depth_pass() const {
        source from{what, flush};
        std::vector<glm::vec3> positions;
        std::vector<glm::uvec3> triangles;
        const auto within = [&](int low, int high) { return low + int(from.below(unsigned(high - low + 1))); };
        for (unsigned i = 0; i < 200; ++i) {
            const int x = within(-110, 110), y = within(-110, 110);
            for (int corner = 0; corner < 3; ++corner) {
                glm::vec3 p;
                p.x = float(x + within(-20, 20)) / 64.0f;
                p.y = float(y + within(-20, 20)) / 64.0f;
                p.z = float(within(90, 150)) / 64.0f;
                positions.push_back(p);
            }
            triangles.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
        }
        glm::mat4 matrix(0.0f);
        matrix[0][0] = matrix[1][1] = matrix[2][3] = 1.0f;
        const glm::vec4 depth_row = glm::vec4(123.0f, -77.0f, 1999.0f, 1000.0f) / 4096.0f;
        for (int i = 0; i < 4; ++i) matrix[i][2] = depth_row[i];
        const auto before = images<float>(sizes, [](source& s, std::size_t) { return s.one_in(2) ? 1.0f : s.any(); });
        std::vector<image<float>> expected = before;
        detail::isa_in_use = isa::base;
        for (auto& depth : expected)
            rasterize(depth.size(), {positions, triangles}, matrix, {}, [&](glm::ivec2 t, float z, unsigned) {
                if (less_equal{}(z, depth[t])) depth[t] = z;
            });
        run<float>("rasterize_depth", [&](int s, glm::ivec2 t) { return expected[std::size_t(s)][t]; },
                   [&](int s, image_view<float> out, pieces parallel) {
                       copy(before[std::size_t(s)], out);
                       rasterize_depth(out, {positions, triangles}, matrix, {}, cull_mode::none, parallel);
                   },
                   true);
    }

    void all() const;
};

// One encoding for each filter and one filter for each encoding: what a filter does with them is one text.
void suite::all() const {
    codec("rg11", rg<11>{});
    codec("rg16", rg<16>{.edge = 0.5f});
    codec("rgb24", rgb24{});
    codec("float_bits", float_bits{});
    codec("depth32f", depth32f{});

    visibility_of("hard_rg16", rg<16>{.edge = 0.5f}, filters::hard{});
    visibility_of("four_tap_rg11", rg<11>{}, filters::four_tap{});
    visibility_of("pcf_2x2_depth32f", depth32f{}, filters::pcf_2x2{});
    visibility_of("pcf_2x2_rg11", rg<11>{}, filters::pcf_2x2{});
    visibility_of("pcf_2x2_rgb24", rgb24{}, filters::pcf_2x2{});
    for (const int radius : {0, 1, 2, 3, 5, 8})
        visibility_of("box" + std::to_string(radius) + "_depth32f", depth32f{}, filters::box{radius});
    visibility_of("box2_rg11", rg<11>{}, filters::box{2});
    for (const int radius : {1, 8})
        visibility_of("hierarchical" + std::to_string(radius), depth32f{}, filters::hierarchical_box{radius});

    pyramid();
    if (what != kind::ordinary) return;  // the rest takes numbers alone
    sums<std::uint8_t, std::uint32_t>("u8");
    sums<std::uint32_t, std::uint32_t>("u32");
    sums<float, float>("float");
    blur_of<glm::vec2>("binomial5", make_binomial_kernel<5>());
    blur_of<glm::vec2>("radius6", {{0.25f, 0.125f, 0.0f, 0.0f, 0.125f, 0.0f, 0.125f}});
    snapping();
    coverage();
    depth_pass();
}

}  // namespace

int main() {
    for_each_setting([](const setting& s) { suite{s}.all(); });
    return all_equal ? 0 : 1;
}
