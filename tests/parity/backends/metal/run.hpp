// SPDX-License-Identifier: MIT
//
// Program around somebody's Metal that was compiled as C++. A block of its standard input is three textures and inputs;
// it writes their results to its standard output. child.hpp is its other end.
#pragma once

#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "memory.hpp"

namespace parity::metal_text {

inline constexpr int guest_maps = 3;

/// A texture in a block, before its texels; of 0 texels where there is none.
struct map_header {
    std::uint32_t width = 0, height = 0, compare = 0, linear = 0, bytes = 0;
};

/// Moves all bytes, by read or write; false at the end.
template <class Move, class Bytes>
bool move_all(Move move, int end, Bytes bytes, std::size_t count) {
    for (std::size_t done = 0; done < count;) {
        const ssize_t n = move(end, bytes + done, count - done);
        if (n <= 0) return false;
        done += static_cast<std::size_t>(n);
    }
    return true;
}

/// Answer to a block: 0 and results, or 1 and what is wrong.
inline void answer(char status, const char* bytes, std::size_t count) {
    const auto length = static_cast<std::uint32_t>(count + 1);
    move_all(::write, STDOUT_FILENO, reinterpret_cast<const char*>(&length), sizeof length);
    move_all(::write, STDOUT_FILENO, &status, 1);
    move_all(::write, STDOUT_FILENO, bytes, count);
}

inline void stopped(int by) {
    const char* why = by == SIGVTALRM ? "the function runs for too long. Does each of its loops end?"
                      : by == SIGFPE  ? "the function divides an integer by 0"
                                      : "the function reads or writes memory that is not its own: is a subscript too "
                                        "large, or does it call itself?";
    answer(1, why, std::strlen(why));
    _exit(1);
}

/// @param seconds   processor time that one block may take
/// @param call      float[4] of an input, memory[guest_maps], float[4] of its result
template <class Call>
void serve(int seconds, Call call) {
    static char space[1 << 16];  // for the handler, as the program's own stack may be what is full
    stack_t stack{};
    stack.ss_sp = space, stack.ss_size = sizeof space;
    sigaltstack(&stack, nullptr);
    struct sigaction action {};
    action.sa_handler = stopped, action.sa_flags = SA_ONSTACK;
    for (int signal : {SIGVTALRM, SIGFPE, SIGSEGV, SIGBUS, SIGILL}) sigaction(signal, &action, nullptr);

    std::vector<char> block;
    std::vector<float> results;
    for (std::uint32_t length; move_all(::read, STDIN_FILENO, reinterpret_cast<char*>(&length), sizeof length);) {
        block.resize(length);
        if (!move_all(::read, STDIN_FILENO, block.data(), block.size())) return;
        const char* at = block.data();
        memory maps[guest_maps];
        for (memory& m : maps) {
            map_header h;
            std::memcpy(&h, at, sizeof h);
            at += sizeof h;
            m = {at, h.width, h.height, int(h.compare), h.linear != 0};
            at += h.bytes;
        }
        const auto* inputs = reinterpret_cast<const float*>(at);
        const auto floats = static_cast<std::size_t>(block.data() + block.size() - at) / sizeof(float);
        results.resize(floats);
        const itimerval limit{{}, {seconds, 0}}, none{};
        setitimer(ITIMER_VIRTUAL, &limit, nullptr);
        for (std::size_t i = 0; i < floats; i += 4) call(inputs + i, maps, results.data() + i);
        setitimer(ITIMER_VIRTUAL, &none, nullptr);
        answer(0, reinterpret_cast<const char*>(results.data()), floats * sizeof(float));
    }
}

}  // namespace parity::metal_text
