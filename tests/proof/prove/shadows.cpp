// SPDX-License-Identifier: MIT
//
// Shadows of every setup against rays, over many random scenes in every convention, on all cores. Prints a table,
// writes it as TSV into the file that the argument names, and fails when anything in it does.
//
//     prove_shadows shadows.tsv        or fewer scenes than 512: prove_shadows shadows.tsv 32
#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "../shadow_rays.hpp"

namespace {

/// Result of a setup with a filter, over all scenes.
struct line {
    proof::traced found{};
    std::uint64_t planes = 0, beyond = 0;  ///< tried; whose shadow is lost farther or less far than stated
    double stated = 0, measured = 0;       ///< sums over planes, world units
    double least = 1, greatest = 0;        ///< measured, as a share of the bound
    [[nodiscard]] std::uint64_t failures() const { return found.wrong() + beyond; }

    void add(const proof::detached& d, double least_share) {
        const double share = d.measured / d.bound;
        ++planes, beyond += share > 1 || share < least_share;
        stated += d.stated, measured += d.measured;
        least = std::min(least, share), greatest = std::max(greatest, share);
    }
    line& operator+=(const line& o) {
        found += o.found, planes += o.planes, beyond += o.beyond, stated += o.stated, measured += o.measured;
        least = std::min(least, o.least), greatest = std::max(greatest, o.greatest);
        return *this;
    }
};
using table = std::map<std::pair<std::string, std::string>, line>;

void trace_scene(std::uint64_t n, table& all) {
    proof::shadowed_scene scene(n);
    proof::for_each_traced(
        scene, [&](std::string_view name, std::string_view filter, const auto& s, const auto& light, const auto& mesh) {
            line& l = all[{std::string(name), std::string(filter)}];
            l.found += proof::trace_receivers(scene, name, s, light, mesh, 2000);
            for (int plane = 0; plane < 2; ++plane) {
                const auto [point, normal] = scene.plane_of(name, light);
                if (const auto d = proof::detach(s, light, point, normal, scene.random()))
                    l.add(*d, proof::least_share(name));
            }
        });
}

}  // namespace

int main(int argc, char** argv) {
    const std::uint64_t scenes = argc == 3 ? std::strtoull(argv[2], nullptr, 10) : 512;
    std::ofstream tsv(argc >= 2 ? argv[1] : "");
    if (!tsv || scenes == 0) return std::cerr << "usage: prove_shadows TABLE.tsv [SCENES]\n", 2;

    table all;
    std::mutex adding;
    std::atomic<std::uint64_t> next = 0;
    std::vector<std::jthread> threads(std::max(1u, std::thread::hardware_concurrency()));
    for (std::jthread& thread : threads)
        thread = std::jthread([&] {
            table own;
            for (std::uint64_t n; (n = next++) < scenes;) trace_scene(n, own);
            const std::lock_guard lock(adding);
            for (const auto& [key, l] : own) all[key] += l;
        });
    threads.clear();  // joins

    tsv << "setup\tfilter\treceivers\tin shadow\tfading\twrong\tacne\tplanes\tstated\tmeasured\tleast share\t"
           "greatest share\tbeyond\n";
    std::printf("%-20s %-8s %10s %9s %7s %6s %5s  %6s %8s %8s  %s\n", "setup", "filter", "receivers", "in shadow",
                "fading", "wrong", "acne", "planes", "stated", "measured", "of the bound");
    std::uint64_t failures = 0, receivers = 0;
    for (const auto& [key, l] : all) {
        const std::uint64_t told = l.found.lit + l.found.shadowed;
        const double planes = double(std::max<std::uint64_t>(l.planes, 1));
        std::printf("%-20s %-8s %10llu %9llu %7llu %6llu %5llu  %6llu %8.4f %8.4f  %.3f .. %.3f\n", key.first.c_str(),
                    key.second.c_str(), static_cast<unsigned long long>(told),
                    static_cast<unsigned long long>(l.found.shadowed), static_cast<unsigned long long>(l.found.faded),
                    static_cast<unsigned long long>(l.found.wrong()), static_cast<unsigned long long>(l.found.acne),
                    static_cast<unsigned long long>(l.planes), l.stated / planes, l.measured / planes, l.least,
                    l.greatest);
        tsv << key.first << '\t' << key.second << '\t' << told << '\t' << l.found.shadowed << '\t' << l.found.faded
            << '\t' << l.found.wrong() << '\t' << l.found.acne << '\t' << l.planes << '\t' << l.stated / planes << '\t'
            << l.measured / planes << '\t' << l.least << '\t' << l.greatest << '\t' << l.beyond << '\n';
        failures += l.failures(), receivers += told;
    }
    std::printf("%llu receivers, %llu failures\n", static_cast<unsigned long long>(receivers),
                static_cast<unsigned long long>(failures));
    return receivers > 0 && failures == 0 ? 0 : 1;
}
