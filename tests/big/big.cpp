// SPDX-License-Identifier: MIT
//
// Big inputs: maps of up to 2^30 texels, 10^8 triangles, 2^30 receivers. Results are compared with closed forms and
// with the primitives, memory with its bound. The table has the cost per element.
//
//     big                  a sample in seconds: maps of 2^16 and 2^18 texels
//     big OUT.tsv [NAME]   all, or the works with NAME in their name: the points of curves, for plots.gp
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include <malloc.h>

#include "heap.hpp"
#include "works.hpp"

namespace {

/// Bytes of memory that programs may still take.
double available_gib() {
    std::ifstream file("/proc/meminfo");
    for (std::string word; file >> word;)
        if (double kib = 0; word == "MemAvailable:" && file >> kib) return kib / (1 << 20);
    return 0;
}

/// Lets a work's runs keep what they give back: only the first one takes time to find fresh memory.
void keep_memory() {
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, -1);
}

/// Fills the caches with other memory: small maps would be in them, large ones never are.
void empty_caches() {
    static std::vector<unsigned char> other(std::size_t(128) << 20);
    for (std::size_t line = 0; line < other.size(); line += 64) ++other[line];
}

struct point {
    double elements, ns, bytes;
};

/// Runs a work of 2^power elements: once for its results and memory, then up to most_times for its least cost.
/// @return   number of failures
int run(const work& of, int power, int most_times, point& at) {
    const prepared ready = of.prepare(power);
    stopwatch first;
    const std::size_t peak = heap::peak_of([&] { ready.run(first); });
    const bool is_right = ready.is_right(), is_bounded = peak <= ready.most_bytes;
    at = {ready.elements, 1e9 * first.seconds() / ready.elements, double(peak)};
    if (!is_right) std::printf("%s, 2^%d: results are wrong\n", of.name.c_str(), power);
    if (!is_bounded)
        std::printf("%s, 2^%d: %zu bytes, of at most %zu\n", of.name.c_str(), power, peak, ready.most_bytes);
    double spent = 0;
    for (int times = 0; times < most_times && (times < 3 || spent < 0.5); ++times) {
        stopwatch again;
        empty_caches();
        ready.run(again);
        at.ns = std::min(at.ns, 1e9 * again.seconds() / ready.elements);
        spent += again.seconds();
    }
    return !is_right + !is_bounded;
}

}  // namespace

std::vector<work>& works() {
    static std::vector<work> all;
    return all;
}

int main(int argc, char** argv) {
    const bool sample = argc < 2;
    const std::string wanted = argc > 2 ? argv[2] : "";
    std::ofstream out(sample ? "/dev/null" : argv[1]);
    out << "# plot\twork\tby\telements\tns per element\tbytes\n";
    int failures = 0;
    keep_memory();
    for (const work& of : works()) {
        if (of.name.find(wanted) == std::string::npos) continue;
        std::vector<double> ns;
        const int lowest = sample || of.highest < 20 ? std::min(of.highest, 16) : 20;
        const int highest = sample ? std::min(of.highest, 18) : of.highest;
        for (int power = lowest; power <= highest; power += power + 1 == highest ? 1 : 2) {
            malloc_trim(0);  // what the last work has kept
            const double gib = std::ldexp(of.gib_at_once, power - of.highest);
            if (!sample && gib > 1 && available_gib() < gib + 2) {
                std::printf("%-42s 2^%d: skipped, needs %.1f GiB and 2 to spare\n", of.name.c_str(), power, gib);
                continue;
            }
            point at{};
            failures += run(of, power, sample || of.plot.empty() ? 0 : 20, at);
            if (sample) continue;
            ns.push_back(at.ns);
            std::printf("%-42s %12.0f  %9.3f ns  %8.3f B each\n", of.name.c_str(), at.elements, at.ns,
                        at.bytes / at.elements);
            std::fflush(stdout);
            if (!of.plot.empty())
                out << of.plot << '\t' << of.name << "\tumbrage\t" << at.elements << '\t' << at.ns << '\t' << at.bytes
                    << std::endl;
        }
        if (ns.size() > 1)
            std::printf("%-42s cost of the most over that of 2^20: %.2f\n", of.name.c_str(), ns.back() / ns[0]);
    }
    std::printf("%d failures\n", failures);
    return failures != 0;
}
