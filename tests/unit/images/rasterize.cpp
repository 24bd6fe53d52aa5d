// SPDX-License-Identifier: MIT
//
// The rasterizer against an oracle that knows neither edge functions with a bias nor floating point: positions, planes
// and depths are fractions of integers, and a sample on an edge is decided by moving it an infinitesimal step to the
// right and a yet smaller one down, which is what the top-left rule means.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

#include <umbrage/images/rasterize.hpp>

using namespace umbrage;
using detail::best_isa;
using detail::isa;

namespace {

__extension__ typedef __int128 wide;

constexpr float nan_value = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

struct mesh {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;
    operator mesh_view() const { return {positions, triangles}; }

    void add(glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        const auto first = static_cast<unsigned>(positions.size());
        positions.insert(positions.end(), {a, b, c});
        triangles.emplace_back(first, first + 1, first + 2);
    }
};

struct generator {
    std::mt19937 engine{20021};
    int operator()(int low, int high) {  // the same on every platform, unlike the standard's distributions
        return low + int(engine() % unsigned(high - low + 1));
    }
    float real(float low, float high) { return low + (high - low) * float(engine() >> 8) * 0x1p-24f; }
};

// x and y in 1/256 texel from the bottom left corner
glm::vec3 at(int x, int y, glm::ivec2 size, float z = 0.5f) {
    return {float(2 * x - 256 * size.x) / float(256 * size.x), float(2 * y - 256 * size.y) / float(256 * size.y), z};
}

image<int> count_samples(glm::ivec2 size, const mesh_view& m, const glm::mat4& matrix = glm::mat4(1.0f)) {
    image<int> count(size);
    rasterize(size, m, matrix, {}, [&](glm::ivec2 texel, float, unsigned) { ++count[texel]; });
    return count;
}

image<float> render(glm::ivec2 size, const mesh_view& m, const glm::mat4& matrix = glm::mat4(1.0f),
                    clip_space clip = {}, cull_mode cull = cull_mode::none) {
    image<float> depth(size, cleared_depth(clip));
    rasterize_depth(depth, m, matrix, clip, cull);
    return depth;
}

bool same_bits(const image<float>& a, const image<float>& b) {
    return std::equal(a.texels().begin(), a.texels().end(), b.texels().begin(), b.texels().end(), [](float p, float q) {
        return std::bit_cast<std::uint32_t>(p) == std::bit_cast<std::uint32_t>(q);
    });
}

bool all(const image<float>& a, float value) { return same_bits(a, image<float>(a.size(), value)); }

// The oracle's vertex: clip coordinates x/d, y/d, z/d, w/d with integers x, y, z, w, so that d cancels.
struct exact_vertex {
    std::int64_t x, y, z, w;
    std::int64_t column = 0, row = 0;  // on the vertex grid

    void snap(glm::ivec2 size) {
        const auto nearest = [](std::int64_t numerator, std::int64_t denominator) {  // floor(n / d + 1/2)
            const std::int64_t n = 2 * numerator + denominator, d = 2 * denominator;
            return n / d - (n % d < 0);
        };
        column = nearest((x + w) * size.x * 128, w);
        row = nearest((y + w) * size.y * 128, w);
    }
};

struct exact_triangle {
    std::array<exact_vertex, 3> v;

    static std::int64_t cross(std::int64_t ax, std::int64_t ay, std::int64_t bx, std::int64_t by) {
        return ax * by - ay * bx;
    }
    static int sign(std::int64_t a) { return (a > 0) - (a < 0); }

    std::int64_t area() const {
        return cross(v[1].column - v[0].column, v[1].row - v[0].row, v[2].column - v[0].column, v[2].row - v[0].row);
    }
    // twice the area that edge i and the texel's centre span
    std::int64_t part(std::size_t i, glm::ivec2 texel) const {
        const auto &a = v[i], &b = v[(i + 1) % 3];
        return cross(b.column - a.column, b.row - a.row, texel.x * 256 + 128 - a.column, texel.y * 256 + 128 - a.row);
    }
    bool covers(glm::ivec2 texel) const {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto &a = v[i], &b = v[(i + 1) % 3];
            int side = sign(part(i, texel));
            if (side == 0) side = -sign(b.row - a.row);        // the step to the right
            if (side == 0) side = -sign(b.column - a.column);  // the step down
            if (side == 0 || side != sign(area())) return false;
        }
        return true;
    }
    // sum of part * z / w over area; numbers here keep it below 2^120
    long double depth(glm::ivec2 texel) const {
        wide numerator = 0, denominator = area();
        for (std::size_t i = 0; i < 3; ++i) {
            const auto &a = v[i], &b = v[(i + 1) % 3], &c = v[(i + 2) % 3];
            numerator += wide(part((i + 1) % 3, texel)) * a.z * b.w * c.w;
            denominator *= a.w;
        }
        return static_cast<long double>(numerator) / static_cast<long double>(denominator);
    }
};

// world_to_clip for positions (x, y, w) / 64 with z = plane . (x, y, w) / 64: rows in small integers
struct exact_scene {
    glm::mat4 matrix{0.0f};
    std::array<int, 4> plane;

    explicit exact_scene(std::array<int, 4> z) : plane(z) {
        matrix[0][0] = matrix[1][1] = matrix[2][3] = 1.0f;
        for (int i = 0; i < 4; ++i) matrix[i][2] = float(plane[std::size_t(i)]) / 4096.0f;
    }
    // x, y, w in 1/64; z in 1/(64 * 4096)
    exact_vertex vertex(int x, int y, int w) const {
        return {std::int64_t(x) * 4096, std::int64_t(y) * 4096,
                std::int64_t(plane[0]) * x + std::int64_t(plane[1]) * y + std::int64_t(plane[2]) * w + plane[3] * 64,
                std::int64_t(w) * 4096};
    }
    static glm::vec3 position(int x, int y, int w) { return {float(x) / 64.0f, float(y) / 64.0f, float(w) / 64.0f}; }
};

// triangles of all sorts: near ones and ones across the camera, beyond the far plane and the guard band
mesh soup(generator& random, int count) {
    mesh m;
    for (int i = 0; i < count; ++i) {
        const glm::vec3 centre(random.real(-2, 2), random.real(-2, 2), random.real(-6, 1));
        std::array<glm::vec3, 3> corner;
        for (auto& c : corner) {
            const float size = i % 7 == 0 ? 100.0f : 0.7f;
            c = centre + glm::vec3(random.real(-size, size), random.real(-size, size), random.real(-size, size));
        }
        m.add(corner[0], corner[1], corner[2]);
    }
    return m;
}

// right-handed perspective, near 1/4, far 8, depth in [0, 1]
glm::mat4 perspective() {
    glm::mat4 m(0.0f);
    m[0][0] = m[1][1] = 1.0f;
    m[2][2] = -8.0f / 7.75f, m[3][2] = -2.0f / 7.75f;
    m[2][3] = -1.0f;
    return m;
}

}  // namespace

TEST_CASE("rasterize: coverage is the oracle's, for corners and edges on texel centres too, in perspective too") {
    generator random;
    const glm::ivec2 size(40, 24);
    int on_centre = 0, samples = 0, wrong = 0;
    for (int round = 0; round < 20000; ++round) {
        const exact_scene scene({0, 0, 2048, 0});
        exact_triangle oracle;
        mesh m;
        std::array<glm::vec3, 3> p;
        for (std::size_t i = 0; i < 3; ++i) {
            const int w = round % 2 ? random(16, 200) : 64;
            int x = random(-3 * w / 2, 3 * w / 2), y = random(-3 * w / 2, 3 * w / 2);
            if (round % 4 == 0) x = y = random(-70, 70);  // corners on a diagonal, many shared or collinear
            oracle.v[i] = scene.vertex(x, y, w);
            oracle.v[i].snap(size);
            on_centre += oracle.v[i].column % 256 == 128 && oracle.v[i].row % 256 == 128;
            p[i] = scene.position(x, y, w);
        }
        m.add(p[0], p[1], p[2]);
        const auto count = count_samples(size, m, scene.matrix);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                wrong += count[{x, y}] != (oracle.covers({x, y}) ? 1 : 0);
                samples += count[{x, y}];
            }
    }
    CHECK(wrong == 0);
    CHECK(on_centre > 100);
    CHECK(samples > 1000000);

    // corners on a quarter-texel grid, so that most edges meet centres
    int ties = 0;
    for (int round = 0; round < 20000; ++round) {
        const glm::ivec2 small(16, 8);
        exact_triangle oracle;
        std::array<glm::vec3, 3> p;
        for (std::size_t i = 0; i < 3; ++i) {
            const int step = round % 3 == 0 ? 128 : 64;
            const int x = step * random(-8, 16 * 256 / step + 8), y = step * random(-8, 8 * 256 / step + 8);
            oracle.v[i] = {0, 0, 0, 1, x, y};
            p[i] = at(x, y, small);
        }
        mesh m;
        m.add(p[0], p[1], p[2]);
        const auto count = count_samples(small, m);
        for (int y = 0; y < small.y; ++y)
            for (int x = 0; x < small.x; ++x) {
                wrong += count[{x, y}] != (oracle.covers({x, y}) ? 1 : 0);
                for (std::size_t i = 0; i < 3; ++i) ties += count[{x, y}] && oracle.part(i, {x, y}) == 0;
            }
    }
    CHECK(wrong == 0);
    CHECK(ties > 5000);
}

TEST_CASE("rasterize: each sample on a shared edge or corner is covered exactly once") {
    generator random;
    const glm::ivec2 size(24, 20);
    for (int round = 0; round < 600; ++round) {
        mesh m;
        if (round % 2) {  // a grid over the image; its inner corners moved, a third of them onto texel centres
            const int columns = 7, rows = 6;
            const auto coordinate = [&](int i, int last, int texels) {
                if (i == 0) return -256;
                if (i == last) return (texels + 1) * 256;
                const int regular = 256 * texels * i / last, moved = regular + random(-200, 200);
                return round % 3 ? moved : (moved & ~255) + 128;
            };
            for (int y = 0; y <= rows; ++y)
                for (int x = 0; x <= columns; ++x)
                    m.positions.push_back(at(coordinate(x, columns, size.x), coordinate(y, rows, size.y), size));
            for (unsigned y = 0; y < rows; ++y)
                for (unsigned x = 0; x < columns; ++x) {
                    const unsigned i = y * (columns + 1) + x, above = i + columns + 1;
                    const bool rising = random(0, 1) == 1;
                    m.triangles.emplace_back(i, i + 1, rising ? above + 1 : above);
                    m.triangles.emplace_back(above + 1, above, rising ? i : i + 1);
                }
        } else {  // a fan around a texel's centre, its rim on centres outside of the image
            const int column = 256 * random(0, 23) + 128, row = 256 * random(0, 19) + 128;
            const int left = -640, right = 26 * 256 + 128, bottom = -640, top = 22 * 256 + 128;
            m.positions.push_back(at(column, row, size));
            std::vector<glm::ivec2> rim{{left, bottom}, {right, bottom}, {left, top}, {right, top}};
            for (int i = 0; i < 40; ++i) {
                const int along_x = 256 * random(-2, 25) + 128, along_y = 256 * random(-2, 21) + 128;
                rim.insert(rim.end(), {{along_x, bottom}, {along_x, top}, {left, along_y}, {right, along_y}});
            }
            const auto angle = [](glm::ivec2 p) { return std::atan2(double(p.y - 2560), double(p.x - 3072)); };
            std::sort(rim.begin(), rim.end(), [&](auto a, auto b) { return angle(a) < angle(b); });
            for (auto p : rim) m.positions.push_back(at(p.x, p.y, size));
            for (unsigned i = 1; i <= rim.size(); ++i) m.triangles.emplace_back(0, i, i % rim.size() + 1);
        }
        for (auto& t : m.triangles)
            if (random(0, 1)) std::swap(t.x, t.y);
        const auto count = count_samples(size, m);
        CHECK(std::all_of(count.texels().begin(), count.texels().end(), [](int n) { return n == 1; }));
    }
}

TEST_CASE("rasterize: depth is the exact plane's, rounded once, but for the stated error") {
    generator random;
    const glm::ivec2 size(64, 48);
    long double worst_ulp = 0, worst_share = 0;
    int samples = 0;
    for (int round = 0; round < 4000; ++round) {
        exact_triangle oracle;
        mesh m;
        std::array<glm::vec3, 3> p;
        const exact_scene scene({random(-100, 100), random(-100, 100), random(1500, 2500), random(-100, 100)});
        const int reach = round % 4 == 0 ? 6 : 200;  // small triangles, and slivers among them, as well as large ones
        const glm::ivec2 centre(random(-60, 60), random(-60, 60));
        for (std::size_t i = 0; i < 3; ++i) {
            const int w = random(50, 90), x = centre.x + random(-reach, reach), y = centre.y + random(-reach, reach);
            oracle.v[i] = scene.vertex(x, y, w);
            oracle.v[i].snap(size);
            p[i] = scene.position(x, y, w);
        }
        m.add(p[0], p[1], p[2]);

        // what the documentation calls n and m
        const auto& v = oracle.v;
        const auto [left, right] = std::minmax({v[0].column, v[1].column, v[2].column});
        const auto [bottom, top] = std::minmax({v[0].row, v[1].row, v[2].row});
        const auto real = [](std::int64_t i) { return static_cast<long double>(i); };
        const auto z = [&](std::size_t i) { return real(v[i].z) / real(v[i].w); };
        const auto slope = [&](auto coordinate) {
            return std::abs(((z(1) - z(0)) * real(coordinate(v[2]) - coordinate(v[0])) -
                             (z(2) - z(0)) * real(coordinate(v[1]) - coordinate(v[0]))) /
                            real(oracle.area()));
        };
        if (oracle.area() == 0) continue;
        const auto largest = std::max({std::abs(z(0)), std::abs(z(1)), std::abs(z(2))});
        const auto magnitude = largest + slope([](auto& c) { return c.row; }) * real(right - left) +
                               slope([](auto& c) { return c.column; }) * real(top - bottom);
        const auto stated = 0x1p-48L * real(std::max(right - left, top - bottom)) * magnitude;

        rasterize(size, m, scene.matrix, {}, [&](glm::ivec2 texel, float depth, unsigned) {
            const auto exact = oracle.depth(texel);
            const auto error = std::abs(static_cast<long double>(depth) - exact);
            const auto ulp = static_cast<long double>(std::nextafter(depth, 2.0f)) - static_cast<long double>(depth);
            worst_share = std::max(worst_share, (error - ulp / 2) / stated);
            if (magnitude < 4 * largest) worst_ulp = std::max(worst_ulp, error / ulp);
            ++samples;
        });
    }
    CHECK(samples > 500000);
    CHECK(worst_share <= 1.0L);
    CHECK(worst_ulp < 0.501L);
    MESSAGE("worst error " << double(worst_ulp) << " ulp, slivers left out; beyond rounding " << double(worst_share)
                           << " of what is stated, slivers and all; " << samples << " samples");
}

TEST_CASE("rasterize_depth: permuted triangles and vertices, and a split into meshes, give the same bits") {
    generator random;
    const glm::ivec2 size(320, 240);
    for (clip_space clip : {clip_space{}, clip_space{.direction = depth_direction::reversed}}) {
        mesh m = soup(random, 400);
        const auto reference = render(size, m, perspective(), clip);
        CHECK(std::count_if(reference.texels().begin(), reference.texels().end(),
                            [&](float z) { return z != cleared_depth(clip); }) > 40000);
        for (int round = 0; round < 20; ++round) {
            std::shuffle(m.triangles.begin(), m.triangles.end(), random.engine);
            for (auto& t : m.triangles)
                for (int swaps = random(0, 3); swaps > 0; --swaps) std::swap(t[random(0, 2)], t[random(0, 2)]);
            CHECK(same_bits(render(size, m, perspective(), clip), reference));
        }
        image<float> split(size, cleared_depth(clip));
        for (std::size_t i = 0; i < m.triangles.size(); i += 100)
            rasterize_depth(split, {m.positions, std::span(m.triangles).subspan(i, 100)}, perspective(), clip);
        CHECK(same_bits(split, reference));
    }
}

TEST_CASE("rasterize_depth: compilers, flags and machines give the same bits for what is not clipped") {
    generator random;
    const glm::ivec2 size(128, 128);
    mesh m;
    for (int i = 0; i < 2000; ++i) {
        const glm::ivec2 centre{random(-110, 110), random(-110, 110)};  // braces: in this order
        std::array<glm::vec3, 3> p;
        for (auto& c : p)
            c = glm::vec3{centre.x + random(-20, 20), centre.y + random(-20, 20), random(90, 150)} / 64.0f;
        m.add(p[0], p[1], p[2]);
    }
    const auto matrix = exact_scene({123, -77, 1999, 1000}).matrix;
    const auto in_use = detail::isa_in_use;
    for (isa set : {isa::base, isa::avx2, isa::avx512}) {
        detail::isa_in_use = std::min(set, best_isa());
        std::uint64_t hash = 14695981039346656037u;  // FNV-1a
        rasterize(size, m, matrix, {}, [&](glm::ivec2 texel, float depth, unsigned triangle) {
            for (unsigned word : {unsigned(texel.x), unsigned(texel.y), std::bit_cast<unsigned>(depth), triangle})
                hash = (hash ^ word) * 1099511628211u;
        });
        CHECK(hash == 3075832276352545962u);
    }
    detail::isa_in_use = in_use;
}

TEST_CASE("rasterize_depth: every instruction set and every cut into pieces gives the bits of sample by sample") {
    generator random;
    const auto in_use = detail::isa_in_use;
    int covered = 0, kept = 0;
    for (const glm::ivec2 size : {glm::ivec2(517, 300), glm::ivec2(5, 700), glm::ivec2(2100, 40), glm::ivec2(8, 1)})
        for (auto direction : {depth_direction::forward, depth_direction::reversed})
            for (auto origin : {texture_origin::bottom, texture_origin::top}) {
                const clip_space clip{.direction = direction, .origin = origin};
                const mesh m = soup(random, 2000);

                // whatever can be in an image: numbers, both zeros, denormals, infinities, NaNs of both signs
                image<float> before(size, cleared_depth(clip));
                for (float& z : before.texels())
                    if (random(0, 3) == 0) z = std::bit_cast<float>(unsigned(random.engine()));
                    else if (random(0, 3) == 0) z = random(0, 1) ? -0.0f : 0.0f;
                image<float> reference = before;
                detail::isa_in_use = isa::base;
                rasterize(size, m, perspective(), clip, [&](glm::ivec2 texel, float z, unsigned) {
                    float& there = reference[texel];
                    ++covered;
                    if (is_nan(there) || (direction == depth_direction::forward ? z > there : z < there)) ++kept;
                    else there = z;
                });
                for (isa set : {isa::base, isa::avx2, isa::avx512})
                    for (int pieces : {1, 2, 3, 7}) {
                        detail::isa_in_use = std::min(set, best_isa());
                        image<float> depth = before;
                        rasterize_depth(depth, m, perspective(), clip, cull_mode::none, [&](int count, auto&& piece) {
                            for (int i = pieces - 1; i >= 0; --i)
                                piece(count * i / pieces, count * (i + 1) / pieces);
                        });
                        CHECK(same_bits(depth, reference));
                    }
            }
    CHECK(covered > 1000000);
    CHECK(kept > 100000);

    // coverage, planes and the order of calls as well
    mesh large = soup(random, 3000);
    std::vector<std::uint64_t> calls;
    for (isa set : {isa::base, isa::avx2, isa::avx512}) {
        detail::isa_in_use = std::min(set, best_isa());
        std::uint64_t hash = 14695981039346656037u;
        rasterize({96, 64}, large, perspective(), {}, [&](glm::ivec2 texel, float z, unsigned triangle) {
            for (unsigned word : {unsigned(texel.x), unsigned(texel.y), std::bit_cast<unsigned>(z), triangle})
                hash = (hash ^ word) * 1099511628211u;
        });
        calls.push_back(hash);
    }
    CHECK(calls[0] == calls[1]);
    CHECK(calls[0] == calls[2]);
    detail::isa_in_use = in_use;
}

TEST_CASE("rasterize_depth: all sixteen clip spaces show the same scene") {
    generator random;
    const glm::ivec2 size(80, 56);
    const mesh m = soup(random, 60);
    const auto reference = render(size, m, perspective());
    int covered = 0;
    for (float z : reference.texels()) covered += z < 1.0f;
    CHECK(covered > 1000);
    CHECK(covered < size.x * size.y);
    for (auto hand : {handedness::right, handedness::left})
        for (auto range : {depth_range::zero_to_one, depth_range::minus_one_to_one})
            for (auto direction : {depth_direction::forward, depth_direction::reversed})
                for (auto origin : {texture_origin::bottom, texture_origin::top}) {
                    const clip_space clip{hand, range, direction, origin};
                    mesh world = m;
                    glm::mat4 matrix = perspective();
                    for (int i = 0; i < 4; ++i) {
                        if (direction == depth_direction::reversed) matrix[i][2] = matrix[i][3] - matrix[i][2];
                        if (range == depth_range::minus_one_to_one) matrix[i][2] = 2.0f * matrix[i][2] - matrix[i][3];
                    }
                    if (hand == handedness::left) {
                        for (auto& p : world.positions) p.z = -p.z;
                        matrix[2] = -matrix[2];
                    }
                    const auto depth = render(size, world, matrix, clip);
                    int coverage_differs = 0;
                    float largest = 0.0f;
                    for (int y = 0; y < size.y; ++y)
                        for (int x = 0; x < size.x; ++x) {
                            float z = depth[{x, origin == texture_origin::top ? size.y - 1 - y : y}];
                            if (direction == depth_direction::reversed) z = 1.0f - z;
                            const float expected = reference[{x, y}];
                            coverage_differs += (z != 1.0f) != (expected != 1.0f);
                            largest = std::max(largest, std::abs(z - expected));
                        }
                    CHECK(coverage_differs == 0);
                    CHECK(largest <= 0x1p-22f);  // the matrices are rounded
                    const bool same_depths = range == depth_range::zero_to_one && direction == depth_direction::forward;
                    CHECK((largest == 0.0f || !same_depths));
                }
}

TEST_CASE("rasterize_depth: cut at the near plane, with corners behind the camera") {
    // near 2, far 64, a floor one unit below the camera from far in front to far behind: 2 <= -z, so y/w >= -1/2
    glm::mat4 matrix(0.0f);
    matrix[0][0] = matrix[1][1] = 1.0f;
    matrix[2][2] = -64.0f / 62.0f, matrix[3][2] = -128.0f / 62.0f, matrix[2][3] = -1.0f;
    mesh floor_below;
    floor_below.positions = {{-4000, -1, 50}, {4000, -1, 50}, {4000, -1, -4000}, {-4000, -1, -4000}};
    floor_below.triangles = {{0, 1, 2}, {0, 2, 3}};
    const glm::ivec2 size(64, 64);
    const auto depth = render(size, floor_below, matrix);
    const auto count = count_samples(size, floor_below, matrix);
    for (int y = 0; y < size.y; ++y) {
        const double up = (y + 0.5) / 32.0 - 1.0, distance = -1.0 / up;
        const bool seen = up < 0.0 && distance >= 2.0 && distance <= 64.0;
        for (int x = 0; x < size.x; ++x) {
            CHECK(count[{x, y}] == (seen ? 1 : 0));
            const double expected = seen ? (64.0 - 128.0 / distance) / 62.0 : 1.0;
            CHECK(std::abs(depth[{x, y}] - expected) < 128.0 / 62.0 / 32.0 / 512.0 + 1e-6);  // snapping: 1/512 texel
        }
    }

    const auto samples = [&](glm::vec3 a, glm::vec3 b, glm::vec3 c) {
        mesh m;
        m.add(a, b, c);
        const auto image = count_samples(size, m, matrix);
        return std::accumulate(image.texels().begin(), image.texels().end(), 0);
    };
    CHECK(samples({-9, -9, -2}, {9, -9, -2}, {0, 18, -2}) == 64 * 64);  // in the near plane: inside
    CHECK(samples({-9, -9, -1.99f}, {9, -9, -1.99f}, {0, 18, -1.99f}) == 0);
    CHECK(samples({-9, -9, 5}, {9, -9, 5}, {0, 18, 5}) == 0);    // behind
    CHECK(samples({-9, -9, 0}, {9, -9, 0}, {0, 18, 0}) == 0);    // through the eye: w = 0
    CHECK(samples({0, 0, 0}, {0, 0, 0}, {0, 0, 0}) == 0);
    CHECK(samples({0, 0, -2}, {-9, -9, 5}, {9, -9, 5}) == 0);    // touches the near plane with a corner
    CHECK(samples({-1, 0, -2}, {1, 0, -2}, {0, 9, 5}) == 0);     // with an edge
    CHECK(samples({-2, -2, -2}, {2, -2, -2}, {0, 0, -4}) > 100); // in front of it, on it with an edge

    glm::mat4 no_near(0.0f);  // z = 1/4, w = z: only w bounds it, and a corner has none
    no_near[0][0] = no_near[1][1] = no_near[2][3] = 1.0f, no_near[3][2] = 0.25f;
    mesh at_eye;
    at_eye.add({0, 0, 0}, {-1, -1, 1}, {1, -1, 1});  // edge-on
    CHECK(all(render(size, at_eye, no_near), 1.0f));

    mesh on_plane;
    on_plane.add({-9, -9, -2}, {9, -9, -2}, {0, 18, -2});
    CHECK(all(render(size, on_plane, matrix), 0.0f));
}

TEST_CASE("rasterize: huge triangles are cut at the guard band, along shared edges at the same points") {
    const glm::ivec2 size(64, 48);
    generator random;
    for (float far_out : {300.0f, 1e4f, 1e6f, 1e18f, 1e37f}) {
        for (int round = 0; round < 50; ++round) {
            mesh m;  // a fan around a corner in sight
            m.positions = {{random.real(-1, 1), random.real(-1, 1), 0.25f}};
            for (auto [x, y] : {std::pair(-1, -1), {1, -1}, {1, 1}, {-1, 1}})
                m.positions.emplace_back(float(x) * far_out, float(y) * far_out, 0.25f);
            m.triangles = {{0, 1, 2}, {2, 0, 3}, {4, 3, 0}, {0, 4, 1}};
            const auto count = count_samples(size, m);
            CHECK(std::all_of(count.texels().begin(), count.texels().end(), [](int n) { return n == 1; }));
            CHECK(all(render(size, m), 0.25f));
        }
        mesh slope;  // depth 0.25 on the left, 0.75 on the right
        slope.positions = {{-2, -far_out, 0}, {2, -far_out, 1}, {2, far_out, 1}, {-2, far_out, 0}};
        slope.triangles = {{0, 1, 2}, {0, 2, 3}};
        const auto depth = render(size, slope);
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) CHECK(std::abs(depth[{x, y}] - (0.25 + (x + 0.5) / 128.0)) < 1e-4);
    }
    mesh whole_band;  // the largest image, one texel high: the right border is the band's
    whole_band.positions = {{-3, -3, 0.5f}, {9, -3, 0.5f}, {-3, 9, 0.5f}};
    whole_band.triangles = {{0, 1, 2}};
    CHECK(all(render({guard_band, 1}, whole_band), 0.5f));
}

TEST_CASE("rasterize_depth: nearer or as near wins, nothing beyond the far plane, never a negative zero") {
    const auto screen = [](float z) {
        mesh m;
        m.add({-1, -1, z}, {3, -1, z}, {-1, 3, z});
        return m;
    };
    const clip_space forward{}, reversed{.direction = depth_direction::reversed};
    const auto after = [&](float there, float z, clip_space clip) {
        image<float> depth({3, 3}, there);
        rasterize_depth(depth, screen(z), glm::mat4(1.0f), clip);
        CHECK(all(depth, depth[{1, 1}]));
        return depth[{1, 1}];
    };
    CHECK(after(0.5f, 0.25f, forward) == 0.25f);
    CHECK(after(0.5f, 0.75f, forward) == 0.5f);
    CHECK(after(0.5f, 0.25f, reversed) == 0.5f);
    CHECK(after(0.5f, 0.75f, reversed) == 0.75f);
    CHECK(after(2.0f, 1.0f, forward) == 1.0f);
    CHECK(after(2.0f, 1.5f, forward) == 2.0f);
    CHECK(after(-1.0f, -0.5f, reversed) == -1.0f);
    CHECK(after(2.0f, -0.5f, forward) == 2.0f);   // before the near plane
    CHECK(after(-1.0f, 1.5f, reversed) == -1.0f);
    CHECK(is_nan(after(nan_value, 0.5f, forward)));
    CHECK(std::bit_cast<unsigned>(after(1.0f, -0.0f, forward)) == 0u);
    CHECK(std::bit_cast<unsigned>(after(-0.0f, -0.0f, forward)) == 0u);  // a tie goes to the newcomer
    CHECK(std::bit_cast<unsigned>(after(-1.0f, -0.0f, reversed)) == 0u);

    mesh across;  // from depth -1 to 3 over the width: only the middle half is between the planes
    across.positions = {{-2, -1, -3}, {2, -1, 5}, {2, 1, 5}, {-2, 1, -3}};
    across.triangles = {{0, 1, 2}, {0, 2, 3}};
    for (clip_space clip : {forward, reversed}) {
        const auto depth = render({64, 8}, across, glm::mat4(1.0f), clip);
        for (int x = 0; x < 64; ++x) {
            const double expected = (x + 0.5) / 16.0 - 1.0;
            const bool seen = expected > 0.0 && expected < 1.0;
            CHECK(std::abs(depth[{x, 3}] - (seen ? expected : cleared_depth(clip))) < 1e-6);
        }
    }
}

TEST_CASE("rasterize_depth: faces left out") {
    mesh m;
    m.add({-1, -1, 0.5f}, {0, -1, 0.5f}, {-1, 1, 0.5f});  // counter-clockwise on the left, clockwise on the right
    m.add({0, 1, 0.5f}, {1, 1, 0.5f}, {1, -1, 0.5f});
    m.add({-50, -1, 0.5f}, {0, -1, -0.5f}, {-1, 900, 0.5f});  // the same way round when it is cut
    for (auto origin : {texture_origin::bottom, texture_origin::top})
        for (auto cull : {cull_mode::none, cull_mode::front, cull_mode::back}) {
            const clip_space clip{.origin = origin};
            const auto depth = render({16, 16}, m, glm::mat4(1.0f), clip, cull);
            CHECK((depth[{1, 8}] == 0.5f) == (cull != cull_mode::front));
            CHECK((depth[{14, 8}] == 0.5f) == (cull != cull_mode::back));
            int called = 0;
            rasterize({16, 16}, m, glm::mat4(1.0f), clip, [&](glm::ivec2 texel, float, unsigned triangle) {
                ++called;
                CHECK((triangle == 1) == (texel.x >= 8));
                CHECK(cull != (triangle == 1 ? cull_mode::back : cull_mode::front));
            }, cull);
            CHECK(called > 0);
        }
}

TEST_CASE("rasterize_depth: bad input") {
    const glm::ivec2 size(8, 8);
    mesh m;
    m.add({-1, -1, 0.5f}, {3, -1, 0.5f}, {-1, 3, 0.5f});

    SUBCASE("an index out of range throws before anything is drawn") {
        for (int corner = 0; corner < 3; ++corner)
            for (unsigned index : {3u, ~0u}) {
                mesh broken = m;
                broken.triangles.emplace_back(0, 1, 2);
                broken.triangles.back()[corner] = index;
                image<float> depth(size, 1.0f);
                CHECK_THROWS_AS(rasterize_depth(depth, broken, glm::mat4(1.0f), {}), std::invalid_argument);
                CHECK(all(depth, 1.0f));
            }
    }
    SUBCASE("a triangle with NaN or infinity is left out, the others are drawn") {
        for (float bad : {nan_value, -nan_value, infinity, -infinity})
            for (int corner = 0; corner < 3; ++corner)
                for (int component = 0; component < 3; ++component) {
                    mesh broken;
                    broken.add({-1, -1, 0.25f}, {3, -1, 0.25f}, {-1, 3, 0.25f});
                    broken.positions[std::size_t(corner)][component] = bad;
                    CHECK(all(render(size, broken), 1.0f));
                    broken.add(m.positions[0], m.positions[1], m.positions[2]);
                    CHECK(all(render(size, broken), 0.5f));
                }
    }
    SUBCASE("a matrix with NaN or infinity draws nothing, wild ones do no harm") {
        for (float bad : {nan_value, infinity, -infinity})
            for (int i = 0; i < 16; ++i) {
                glm::mat4 matrix(1.0f);
                matrix[i / 4][i % 4] = bad;
                CHECK(all(render(size, m, matrix), 1.0f));
            }
        generator random;
        constexpr float largest = std::numeric_limits<float>::max();
        constexpr float smallest = std::numeric_limits<float>::denorm_min();
        const std::array<float, 9> wild{0.0f, -0.0f, 1.0f, -1.0f, largest, -largest, smallest, -smallest, 1e-30f};
        const auto pick = [&] { return wild[std::size_t(random(0, 8))]; };
        int samples = 0;
        for (int round = 0; round < 20000; ++round) {
            glm::mat4 matrix;
            for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = pick();
            mesh any;
            any.add({pick(), pick(), pick()}, {pick(), pick(), pick()}, {pick(), pick(), pick()});
            const auto range = round % 2 ? depth_range::zero_to_one : depth_range::minus_one_to_one;
            rasterize(size, any, matrix, {.range = range}, [&](glm::ivec2 texel, float z, unsigned) {
                samples += texel.x >= 0 && texel.y >= 0 && texel.x < 8 && texel.y < 8 && z >= 0.0f && z <= 1.0f;
                samples -= std::signbit(z) ? 1000000 : 0;
            });
        }
        CHECK(samples > 0);
    }
    SUBCASE("nothing to draw, or nowhere") {
        CHECK(all(render(size, mesh{}), 1.0f));
        mesh degenerate;
        degenerate.add({-1, -1, 0.5f}, {1, 1, 0.5f}, {0, 0, 0.5f});
        degenerate.add({0, 0, 0.5f}, {0, 0, 0.5f}, {1, 0, 0.5f});
        degenerate.add({0.0625f, 0.0625f, 0.5f}, {0.0626f, 0.0625f, 0.5f}, {0.0625f, 0.0626f, 0.5f});  // snap together
        CHECK(all(render(size, degenerate), 1.0f));
        for (glm::ivec2 none : {glm::ivec2(0, 0), glm::ivec2(0, 8), glm::ivec2(8, 0)}) {
            image<float> empty(none);
            rasterize_depth(empty, m, glm::mat4(1.0f), {});
        }
        rasterize_depth({}, m, glm::mat4(1.0f), {});
    }
    SUBCASE("sizes that the grid has no room for") {
        image<float> wide_image({guard_band + 1, 1}), tall_image({1, guard_band + 1});
        CHECK_THROWS_AS(rasterize_depth(wide_image, m, glm::mat4(1.0f), {}), std::invalid_argument);
        CHECK_THROWS_AS(rasterize_depth(tall_image, m, glm::mat4(1.0f), {}), std::invalid_argument);
        const auto ignore = [](glm::ivec2, float, unsigned) {};
        CHECK_THROWS_AS(rasterize({-1, 4}, m, glm::mat4(1.0f), {}, ignore), std::invalid_argument);
    }
    SUBCASE("a stride leaves the texels between rows alone") {
        std::vector<float> pixels(10 * 8, 7.0f);
        image_view<float> view(pixels.data(), size, 10 * sizeof(float));
        rasterize_depth(view, m, glm::mat4(1.0f), {});
        for (std::size_t i = 0; i < pixels.size() - 2; ++i) CHECK(pixels[i] == (i % 10 < 8 ? 0.5f : 7.0f));
        image_view<float> upside_down(pixels.data() + 70, size, -10 * std::ptrdiff_t(sizeof(float)));
        mesh lower_half;
        lower_half.add({-9, 0, 0.25f}, {9, 0, 0.25f}, {0, -9, 0.25f});
        rasterize_depth(upside_down, lower_half, glm::mat4(1.0f), {});
        CHECK(pixels[74] == 0.25f);
        CHECK(pixels[4] == 0.5f);
    }
}

TEST_CASE("rasterize: a visibility buffer and its depths agree with rasterize_depth") {
    generator random;
    const glm::ivec2 size(96, 64);
    const mesh m = soup(random, 300);
    image<float> depth(size, 1.0f);
    image<unsigned> visible(size, ~0u);
    rasterize(size, m, perspective(), {}, [&](glm::ivec2 texel, float z, unsigned triangle) {
        if (z <= depth[texel]) depth[texel] = z, visible[texel] = triangle;
    });
    CHECK(same_bits(depth, render(size, m, perspective())));
}

TEST_CASE("barycentrics: the weighted corners project to the texel's centre") {
    generator random;
    const glm::ivec2 size(96, 64);
    const mesh m = soup(random, 300);
    for (auto origin : {texture_origin::bottom, texture_origin::top}) {
        const clip_space clip{.origin = origin};
        int seen = 0;
        double off = 0.0;
        rasterize(size, m, perspective(), clip, [&](glm::ivec2 texel, float, unsigned triangle) {
            const auto b = barycentrics(size, m, perspective(), clip, texel, triangle);
            CHECK(std::min({b.x, b.y, b.z}) >= 0.0f);
            CHECK(std::abs(b.x + b.y + b.z - 1.0f) < 1e-6f);
            const auto t = m.triangles[triangle];
            const auto p = glm::dvec3(m.positions[t.x]) * double(b.x) + glm::dvec3(m.positions[t.y]) * double(b.y) +
                           glm::dvec3(m.positions[t.z]) * double(b.z);
            const double x = (p.x / -p.z + 1.0) * 48.0, y = (p.y / -p.z + 1.0) * 32.0;
            off = std::max({off, std::abs(x - texel.x - 0.5),
                            std::abs((origin == texture_origin::top ? 64.0 - y : y) - texel.y - 0.5)});
            ++seen;
        });
        CHECK(seen > 3000);
        CHECK(off < 0.01);  // snapping moves edges by 1/512 texel a coordinate
    }
    mesh hand;  // w of 1, 1 and 3 along x: the middle of the screen is three quarters of the way to the near end
    hand.positions = {{-1, -1, -1}, {-1, 1, -1}, {3, 0, -3}};
    hand.triangles = {{0, 1, 2}};
    const auto b = barycentrics({2, 2}, hand, perspective(), {}, {0, 0}, 0);  // ndc (-1/2, -1/2)
    CHECK(std::abs(b.z - 0.1f) < 1e-6f);  // x / w = (-(1 - c) + 3 c) / (1 + 2 c) = -1/2
    CHECK(std::abs(b.x - b.y - 0.6f) < 1e-6f);

    mesh edge_on;
    edge_on.add({0, 0, -1}, {0, 1, -2}, {0, 2, -3});
    CHECK(barycentrics(size, edge_on, perspective(), {}, {48, 32}, 0).x <= 1.0f);
    edge_on.positions[1].x = nan_value;
    CHECK(barycentrics(size, edge_on, perspective(), {}, {48, 32}, 0) == glm::vec3(1, 0, 0));
    const mesh nothing{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{0, 1, 2}}};
    CHECK(barycentrics(size, nothing, perspective(), {}, {48, 32}, 0) == glm::vec3(1, 0, 0));
}
