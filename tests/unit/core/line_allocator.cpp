// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include <cstdint>
#include <vector>

#include <umbrage/core/line_allocator.hpp>

TEST_CASE("line_allocator: memory starts at a cache line") {
    for (const std::size_t count : {1u, 3u, 63u, 64u, 1000u}) {
        const std::vector<std::uint8_t, umbrage::detail::line_allocator<std::uint8_t>> bytes(count, 7);
        CHECK(reinterpret_cast<std::uintptr_t>(bytes.data()) % 64 == 0);
        CHECK(bytes.back() == 7);
    }
}
