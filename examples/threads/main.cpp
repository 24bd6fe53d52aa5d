// SPDX-License-Identifier: MIT
//
// Visibility of an image of receivers on one and on two threads, by each scheduler that was there when this was built.
// Fails when a bit differs from what a single thread gives.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>

#include <umbrage/images/visibility.hpp>

#include "schedulers.hpp"

namespace {

constexpr glm::ivec2 map_size(1024, 1024), size(1920, 1080);

struct program {
    umbrage::image<float> depth{map_size}, alone{size}, shared{size};
    umbrage::image<glm::u8vec2> map{map_size};
    umbrage::image<glm::vec3> receivers{size};
    int failures = 0;

    program() {
        for (int y = 0; y < map_size.y; ++y)
            for (int x = 0; x < map_size.x; ++x) depth[{x, y}] = (x / 64 + y / 64) % 3 == 0 ? 0.25f : 0.75f;
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                receivers[{x, y}] = {0.5f * static_cast<float>(x) + 0.1f * static_cast<float>(y),
                                     0.9f * static_cast<float>(y), 0.5f};
        umbrage::encode(depth.view(), map.view(), umbrage::rg<11>{});
    }

    /// Milliseconds, the best of several runs.
    template <class ParallelFor>
    double time(umbrage::image<float>& visibility, const ParallelFor& parallel_for) {
        double best = 1e9;
        for (int run = 0; run < 3; ++run) {
            const auto start = std::chrono::steady_clock::now();
            umbrage::visibility(map.view(), umbrage::rg<11>{}, receivers.view(), umbrage::filters::box{2},
                                visibility.view(), parallel_for);
            best = std::min(
                best, std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
        }
        return best;
    }

    template <class Scheduler>
    void compare(const char* name) {
        for (int threads : {1, 2}) {
            std::ranges::fill(shared.texels(), -1.0f);
            const double milliseconds = time(shared, Scheduler{threads});
            const bool same =
                std::memcmp(shared.texels().data(), alone.texels().data(), alone.texels().size_bytes()) == 0;
            std::printf("%-12s %d thread%s %8.2f ms   %s\n", name, threads, threads > 1 ? "s" : " ", milliseconds,
                        same ? "same bits" : "OTHER BITS");
            failures += !same;
        }
    }
};

}  // namespace

int main() {
    program p;
    std::printf("%-12s            %8.2f ms\n", "no scheduler", p.time(p.alone, umbrage::serial{}));
    p.compare<std_threads>("std::thread");
#ifdef _OPENMP
    p.compare<openmp>("OpenMP");
#endif
#ifdef THREADS_HAVE_TBB
    p.compare<one_tbb>("oneTBB");
#endif
    return p.failures != 0;
}
