// SPDX-License-Identifier: MIT
//
// Big inputs: maps of up to 2^30 texels, 10^8 triangles, 2^30 receivers. Results are compared with closed forms and
// with the primitives, memory with its bound. The table has the cost per element.
//
//     big                  a sample in seconds: maps of 2^16 and 2^18 texels
//     big OUT.tsv [NAME]   all, or the works with NAME in their name: the points of curves, for plots.gp
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <optional>
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

constexpr int least_power = 20;

/// Seconds per element of a run.
double cost_of(const prepared& ready) {
    stopwatch watch;
    ready.run(watch);
    return watch.seconds() / ready.elements;
}

/// A work of 2^least_power elements, to compare larger ones with. It has copies of its arguments, which take turns:
/// each has left the caches by its next turn.
class small_work {
public:
    explicit small_work(const work& of) {
        stopwatch finds_memory;
        for (int i = 0; i < 16; ++i) copies_.push_back(of.prepare(least_power)), copies_.back().run(finds_memory);
    }
    [[nodiscard]] double cost() const {
        double sum = 0;
        for (const prepared& copy : copies_) sum += cost_of(copy);
        return sum / double(copies_.size());
    }

private:
    std::vector<prepared> copies_;
};

double median_of(std::vector<double> values) {
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

struct point {
    double elements, bytes;
    double ns = 0, ratio = 0;  ///< cost per element, and over that of the small work
};

/// Runs a work once: for its results and memory.
/// @return   number of failures
int run_once(const work& of, const prepared& ready, int power, point& at) {
    stopwatch first;
    const std::size_t peak = heap::peak_of([&] { ready.run(first); });
    const bool is_right = ready.is_right(), is_bounded = peak <= ready.most_bytes;
    at = {ready.elements, double(peak)};
    if (!is_right) std::printf("%s, 2^%d: results are wrong\n", of.name.c_str(), power);
    if (!is_bounded)
        std::printf("%s, 2^%d: %zu bytes, of at most %zu\n", of.name.c_str(), power, peak, ready.most_bytes);
    return !is_right + !is_bounded;
}

/// Runs a work for its cost, in turns with the small one: other programs slow the memory down for seconds at a time.
void compare(const small_work& small, const prepared& ready, point& at) {
    std::vector<double> ns, ratios;
    double spent = 0;
    for (int times = 0; times < 3 || (times < 20 && spent < 1); ++times) {
        const double before = small.cost();
        const double cost = cost_of(ready), after = small.cost();
        ns.push_back(1e9 * cost);
        ratios.push_back(2 * cost / (before + after));
        spent += cost * ready.elements;
    }
    at.ns = median_of(ns);
    at.ratio = median_of(ratios);
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
    out << "# plot\twork\tby\telements\tcost per element over that of 2^20\tns per element\tbytes\n";
    int failures = 0;
    keep_memory();
    for (const work& of : works()) {
        if (of.name.find(wanted) == std::string::npos) continue;
        const bool is_timed = !sample && !of.plot.empty();
        std::optional<small_work> small;
        if (is_timed) small.emplace(of);
        double most = 0;
        const int lowest = is_timed ? least_power : std::min(of.highest, 16);
        const int highest = sample ? std::min(of.highest, 18) : of.highest;
        for (int power = lowest; power <= highest; power += power + 1 == highest ? 1 : 2) {
            malloc_trim(0);  // what the last work has kept
            const double gib = std::ldexp(of.gib_at_once, power - of.highest);
            if (!sample && gib > 1 && available_gib() < gib + 2) {
                std::printf("%-42s 2^%d: skipped, needs %.1f GiB and 2 to spare\n", of.name.c_str(), power, gib);
                continue;
            }
            const prepared ready = of.prepare(power);
            point at{};
            failures += run_once(of, ready, power, at);
            if (sample) continue;
            std::printf("%-42s %12.0f  %8.3f B each", of.name.c_str(), at.elements, at.bytes / at.elements);
            if (is_timed) {
                compare(*small, ready, at);
                most = std::max(most, at.ratio);
                std::printf("  %9.3f ns  %5.2f", at.ns, at.ratio);
                out << of.plot << '\t' << of.name << "\tumbrage\t" << at.elements << '\t' << at.ratio << '\t' << at.ns
                    << '\t' << at.bytes << std::endl;
            }
            std::puts("");
            std::fflush(stdout);
        }
        if (is_timed) std::printf("%-42s at most %.2f of the cost of 2^20\n", of.name.c_str(), most);
    }
    std::printf("%d failures\n", failures);
    return failures != 0;
}
