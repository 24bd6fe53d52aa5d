// SPDX-License-Identifier: MIT
//
//     hostile PROGRAM REFERENCE BUILD...
//
// Runs the builds of a program, tier_a, images or fits, and compares their digests with the reference's, computed by
// strict arithmetic rounding to nearest. Every line must agree, in every rounding mode, but for two things IEEE 754 and
// flushing machines leave no choice in: rounding downwards, the sign of a zero is not looked at; where denormals are
// flushed, inputs that are denormal may count as zero. A machine without a mode, as WebAssembly, prints no line of it.
#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>

#include <umbrage/registry.hpp>

namespace {

struct line {
    int inputs = 0;
    std::string exact, unsigned_zeros;
};
using key = std::array<std::string, 3>;  // function, class of inputs, mode
using digests = std::map<key, line>;

digests run(const std::string& program) {
    std::FILE* pipe = ::popen(("'" + program + "'").c_str(), "r");
    if (!pipe) throw std::runtime_error("cannot run " + program);
    std::string text;
    std::array<char, 65536> buffer{};
    for (std::size_t n; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) text.append(buffer.data(), n);
    if (::pclose(pipe) != 0) throw std::runtime_error(program + " failed");
    digests found;
    std::istringstream in(text);
    line l;
    for (key k; in >> k[0] >> k[1] >> k[2] >> l.inputs >> l.exact >> l.unsigned_zeros;) found[k] = l;
    if (found.empty()) throw std::runtime_error(program + " printed nothing");
    return found;
}

bool agrees(const digests& reference, const key& k, const line& found) {
    const auto& [function, inputs, mode] = k;
    const line& expected = reference.at({function, inputs, mode.starts_with("itself") ? mode : "nearest"});
    if (found.exact == expected.exact) return true;
    if (mode.ends_with("downward") && found.unsigned_zeros == expected.unsigned_zeros) return true;
    return mode == "flushing" && inputs == "denormal" &&
           found.exact == reference.at({function, "flushed", "nearest"}).exact;
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc < 3) throw std::runtime_error("usage: hostile PROGRAM REFERENCE BUILD...");
    const digests reference = run(argv[2]);

    std::map<std::string, std::map<std::string, long>> tried;  // function, class -> inputs over builds and modes
    std::map<std::string, std::set<std::string>> differ;       // function -> where
    std::cout << "compiler and flags                                                    lines   differ\n";
    for (int i = 2; i < argc; ++i) {
        const std::string label = std::filesystem::path(argv[i]).filename();
        const digests found = run(argv[i]);
        std::set<std::string> modes{"nearest"};
        for (const auto& [k, ignored] : found) modes.insert(k[2]);
        long wrong = 0;
        std::size_t lines = 0;
        for (const auto& [k, expected] : reference) {
            if (!modes.contains(k[2])) continue;
            ++lines;
            const auto at = found.find(k);
            if (at == found.end() || !agrees(reference, k, at->second)) {
                ++wrong;
                differ[k[0]].insert(label + ", " + k[1] + ", " + k[2]);
            }
            tried[k[0]][k[1]] += expected.inputs;
        }
        std::printf("%-66s %8zu %8ld\n", label.c_str(), lines, wrong);
    }

    std::printf("\n%-30s %10s %10s %10s %8s\n", "function", "ordinary", "NaN, inf", "denormal", "differ");
    for (auto& [function, inputs] : tried)
        std::printf("%-30s %10ld %10ld %10ld %8zu\n", function.c_str(), inputs["ordinary"], inputs["nan"],
                    inputs["denormal"] + inputs["flushed"], differ[function].size());

    bool good = true;
    for (const auto& [function, places] : differ)
        for (const std::string& place : places) {
            std::cout << "differs: " << function << ": " << place << '\n';
            good = false;
        }
    if (argv[1] == std::string("tier_a"))
        for (const umbrage::glsl::snippet* s : umbrage::glsl::registry())
            if (s->exactness == umbrage::glsl::tier::a && !tried.count(std::string(s->name))) {
                std::cout << "missing: add run(\"" << s->name
                          << "\", ...) to suite::all in tests/proof/hostile/tier_a.cpp\n";
                good = false;
            }
    return good ? 0 : 1;
} catch (const std::exception& error) {
    std::cerr << "hostile: " << error.what() << '\n';
    return 1;
}
