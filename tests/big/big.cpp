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

struct cost {
    double ns, ratio;  ///< per element, and over that of the small work
};

/// The cost of a work, in turns with the small one: other programs slow the memory down for seconds at a time.
cost compare(const small_work& small, const prepared& ready) {
    std::vector<double> ns, ratios;
    double spent = 0;
    for (int times = 0; times < 3 || (times < 20 && spent < 1); ++times) {
        const double before = small.cost();
        const double here = cost_of(ready), after = small.cost();
        ns.push_back(1e9 * here);
        ratios.push_back(2 * here / (before + after));
        spent += here * ready.elements;
    }
    return {median_of(ns), median_of(ratios)};
}

struct outcome {
    std::size_t bytes;  ///< at most, at once
    int failures;
};

/// Runs a work once, for its results and memory.
outcome check(const work& of, const prepared& ready, int power) {
    stopwatch first;
    const std::size_t peak = heap::peak_of([&] { ready.run(first); });
    const bool is_right = ready.is_right(), is_bounded = peak <= ready.most_bytes;
    if (!is_right) std::printf("%s, 2^%d: results are wrong\n", of.name.c_str(), power);
    if (!is_bounded)
        std::printf("%s, 2^%d: %zu bytes, of at most %zu\n", of.name.c_str(), power, peak, ready.most_bytes);
    return {peak, !is_right + !is_bounded};
}

/// Whether the memory is there. Says so where it is not.
bool has_memory(const work& of, int power) {
    const double gib = std::ldexp(of.gib_at_once, power - of.highest);
    const bool fits = gib <= 1 || available_gib() >= gib + 2;
    if (!fits) std::printf("%-42s 2^%d: skipped, needs %.1f GiB and 2 to spare\n", of.name.c_str(), power, gib);
    return fits;
}

/// Every second power of two, and the highest.
std::vector<int> powers(int lowest, int highest) {
    std::vector<int> all;
    for (int power = lowest; power < highest; power += 2) all.push_back(power);
    all.push_back(highest);
    return all;
}

/// A work's small sizes alone, untimed.
/// @return   number of failures
int run_sample(const work& of) {
    int failures = 0;
    for (int power : powers(std::min(of.highest, 16), std::min(of.highest, 18)))
        failures += check(of, of.prepare(power), power).failures;
    return failures;
}

/// A work at all its sizes: a line for each, and a point of the table where it has a plot. Without one it is not timed.
/// @return   number of failures
int run_all(const work& of, std::ostream& table) {
    const bool is_timed = !of.plot.empty();
    std::optional<small_work> small;
    if (is_timed) small.emplace(of);
    int failures = 0;
    double most = 0;
    for (int power : powers(is_timed ? least_power : std::min(of.highest, 16), of.highest)) {
        malloc_trim(0);  // what the last work has kept
        if (!has_memory(of, power)) continue;
        const prepared ready = of.prepare(power);
        const outcome here = check(of, ready, power);
        failures += here.failures;
        std::printf("%-42s %12.0f  %8.3f B each", of.name.c_str(), ready.elements, double(here.bytes) / ready.elements);
        if (is_timed) {
            const auto [ns, ratio] = compare(*small, ready);
            most = std::max(most, ratio);
            std::printf("  %9.3f ns  %5.2f", ns, ratio);
            table << of.plot << '\t' << of.name << "\tumbrage\t" << ready.elements << '\t' << ratio << '\t' << ns
                  << '\t' << here.bytes << std::endl;
        }
        std::puts("");
        std::fflush(stdout);
    }
    if (is_timed) std::printf("%-42s at most %.2f of the cost of 2^20\n", of.name.c_str(), most);
    return failures;
}

}  // namespace

std::vector<work>& works() {
    static std::vector<work> all;
    return all;
}

int main(int argc, char** argv) {
    const bool sample = argc < 2;
    const std::string wanted = argc > 2 ? argv[2] : "";
    std::ofstream table(sample ? "/dev/null" : argv[1]);
    table << "# plot\twork\tby\telements\tcost per element over that of 2^20\tns per element\tbytes\n";
    keep_memory();
    int failures = 0;
    for (const work& of : works())
        if (of.name.find(wanted) != std::string::npos) failures += sample ? run_sample(of) : run_all(of, table);
    std::printf("%d failures\n", failures);
    return failures != 0;
}
