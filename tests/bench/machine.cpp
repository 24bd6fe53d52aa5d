// SPDX-License-Identifier: MIT
#include <fstream>
#include <map>
#include <string>
#include <thread>

#include <umbrage/simd/dispatch.hpp>

#include "report.hpp"

namespace bench {
namespace {

using namespace umbrage;
using namespace umbrage::detail;

/// Virtual machines call different processors by the same name: family and model tell them apart.
std::string processor() {
    std::map<std::string, std::string> fields;  // of the first processor
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line) && !line.empty();) {
        const std::size_t colon = line.find(':');
        if (colon == std::string::npos) continue;
        const std::size_t end = line.find_last_not_of(" \t", colon - 1) + 1,
                          value = line.find_first_not_of(' ', colon + 1);
        fields[line.substr(0, end)] = value == std::string::npos ? "" : line.substr(value);
    }
    if (fields.contains("model name")) {
        return fields["model name"] + ", family " + fields["cpu family"] + ", model " + fields["model"];
    }
    if (fields.contains("CPU part"))
        return "ARM implementer " + fields["CPU implementer"] + ", part " + fields["CPU part"];
    return "unknown";
}

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
    return {processor(), std::thread::hardware_concurrency(), name(isa_in_use), name(best_isa()), compiler};
}

}  // namespace bench
