// SPDX-License-Identifier: MIT
#include "heap.hpp"

#include <atomic>
#include <cstdlib>
#include <limits>
#include <new>

#include <malloc.h>

namespace {

std::atomic<std::size_t> live_bytes = 0, peak_bytes = 0;
std::atomic<long> until_failure = std::numeric_limits<long>::max();
std::atomic<bool> fails_on = false, has_failed = false;

[[nodiscard]] void* take(std::size_t size, std::size_t alignment) {
    const long left = --until_failure;
    if (left == 0 || (left < 0 && fails_on)) {
        has_failed = true;
        throw std::bad_alloc();
    }
    void* const memory = std::aligned_alloc(alignment, (size + alignment) / alignment * alignment);
    if (memory == nullptr) throw std::bad_alloc();
    const std::size_t now = live_bytes += malloc_usable_size(memory);
    for (std::size_t highest = peak_bytes; now > highest && !peak_bytes.compare_exchange_weak(highest, now);) {}
    return memory;
}

void give_back(void* memory) noexcept {
    if (memory != nullptr) live_bytes -= malloc_usable_size(memory);
    std::free(memory);
}

}  // namespace

namespace heap {

std::size_t live() { return live_bytes; }
std::size_t peak() { return peak_bytes; }
void restart_peak() { peak_bytes = live_bytes.load(); }

void fail(long nth, lack of) {
    has_failed = false;
    fails_on = of == lack::all;
    until_failure = nth;
}
bool stop_failing() {
    until_failure = std::numeric_limits<long>::max();
    return has_failed;
}

}  // namespace heap

void* operator new(std::size_t size) { return take(size, __STDCPP_DEFAULT_NEW_ALIGNMENT__); }
void* operator new(std::size_t size, std::align_val_t to) { return take(size, static_cast<std::size_t>(to)); }
void operator delete(void* memory) noexcept { give_back(memory); }
void operator delete(void* memory, std::size_t) noexcept { give_back(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { give_back(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { give_back(memory); }
