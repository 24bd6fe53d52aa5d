// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <algorithm>
#include <ctime>
#include <thread>
#include <vector>

#ifdef __linux__
#include <sched.h>
#endif

#include <umbrage/draw/raster/snapped_mesh.hpp>

using namespace umbrage;

TEST_CASE("row_locks: what two threads do to the same rows is done one after the other") {
    constexpr int height = 100, rounds = 20000;
    std::vector<int> counts(height, 0);  // not atomic
    detail::row_locks<> locks(height);
    const auto count_all = [&](bool upwards) {
        for (int i = 0; i < rounds; ++i) {
            const int first = (upwards ? i : rounds - 1 - i) % 50;
            locks.hold({first, height - first}, [&] {
                for (int y = first; y < height - first; ++y) ++counts[std::size_t(y)];
            });
        }
    };
    {
        std::jthread other(count_all, true);
        count_all(false);
    }
    for (int y = 0; y < height; ++y)
        CHECK(counts[std::size_t(y)] == 2 * rounds / 50 * (std::min(y, height - 1 - y) + 1));
    int last_row = 0;
    locks.hold({height - 1, height}, [&] { ++last_row; });
    CHECK(last_row == 1);
}

#ifdef __linux__
TEST_CASE("row_locks: a thread that waits leaves its processor to the one that holds the rows") {
    detail::row_locks<> locks(16);
    double waited = 0;
    std::jthread both([&] {  // both threads on one processor
        cpu_set_t all, one;
        CPU_ZERO(&one);
        REQUIRE(sched_getaffinity(0, sizeof all, &all) == 0);
        for (int i = 0; i < CPU_SETSIZE && CPU_COUNT(&one) == 0; ++i)
            if (CPU_ISSET(i, &all)) CPU_SET(i, &one);
        REQUIRE(sched_setaffinity(0, sizeof one, &one) == 0);
        std::jthread other;
        locks.hold({0, 16}, [&] {
            other = std::jthread([&] {
                locks.hold({0, 16}, [] {});
                timespec spent{};
                clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
                waited = double(spent.tv_sec) + 1e-9 * double(spent.tv_nsec);
            });
            for (int i = 0; i < 300; ++i) std::this_thread::yield();
        });
    });
    both.join();
    CHECK(waited < 0.05);  // seconds of the processor
}
#endif
