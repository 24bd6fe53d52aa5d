// SPDX-License-Identifier: MIT
#include <string>
#include <thread>

#include <umbrage/simd/dispatch.hpp>

#include <processor.hpp>

#include "report.hpp"

namespace bench {
namespace {

using namespace umbrage;
using namespace umbrage::detail;

std::string name(isa set) {
    switch (set) {
        case isa::avx512: return "AVX-512";
        case isa::avx2: return "AVX2";
        case isa::base: break;
    }
#if defined(__x86_64__)
    return "SSE2";
#else
    return "base";
#endif
}

}  // namespace

machine this_machine() {
#if defined(__clang__)
    const std::string compiler = "clang " __clang_version__;
#else
    const std::string compiler = "g++ " __VERSION__;
#endif
    return {example::processor(), std::thread::hardware_concurrency(), name(isa_in_use), name(best_isa()), compiler};
}

}  // namespace bench
