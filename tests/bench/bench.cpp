// SPDX-License-Identifier: MIT
//
//     bench bench.json
//     bench --filter 'PCF 5x5|Embree' bench.json
//     bench --isa avx2 bench.json   ours as on a machine without AVX-512; the others as they are
#include "bench.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <deque>
#include <exception>
#include <map>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include <umbrage/simd/dispatch.hpp>

#include "measure.hpp"
#include "report.hpp"

namespace bench {
namespace {

std::regex filter;
int disagreements = 0;

std::deque<row>& rows() {
    static std::deque<row> all;
    return all;
}
std::vector<std::function<void()>>& registrations() {
    static std::vector<std::function<void()>> all;
    return all;
}

double wall_seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Processor time of this thread. Other threads on its processor do not count.
double processor_seconds() {
    std::timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec) * 1e-9;
}

result run(const row& r, const limits& within) {
    const bool wall = r.measured == clock::wall;
    const measurement m = measure(r.ours, r.theirs, wall ? wall_seconds : processor_seconds, wall_seconds, within);
    return {.work = r.work,
            .peer = r.peer,
            .ours = m.ours / r.items * 1e9,
            .theirs = m.theirs / r.items * 1e9,
            .ratio = m.ratio.median,
            .spread = m.ratio.spread(),
            .converged = m.ratio.spread() < within.spread,
            .rounds = m.rounds,
            .clock = wall ? "wall" : "processor",
            .wanted = r.at_least};
}

void print_heading(const machine& on) {
    std::printf("%s, %u processors; instruction set %s", on.processor.c_str(), on.processors,
                on.instruction_set.c_str());
    if (on.instruction_set != on.best_instruction_set) std::printf(" (it has %s)", on.best_instruction_set.c_str());
    std::printf("; %s\n\n%-58s %-22s %10s %10s %8s %8s %8s verdict\n", on.compiler.c_str(), "work", "against",
                "ours, ns", "theirs, ns", "ratio", "spread", "wanted");
}

void print(const result& r) {
    std::printf("%-58s %-22s %10.3f %10.3f %8.2f %6.1f %% ", r.work.c_str(), r.peer.c_str(), r.ours, r.theirs, r.ratio,
                r.spread * 100);
    if (r.wanted > 0) std::printf("%8.2f %s", r.wanted, r.ratio < r.wanted ? "missed" : "met");
    else std::printf("%8s", "");
    std::printf("%s\n", r.converged ? "" : " not settled");
    std::fflush(stdout);
}

}  // namespace

void add(row r) {
    if (!std::regex_search(r.work + ", " + r.peer, filter)) return;
    r.ours();
    r.theirs();
    if (r.agree && !r.agree()) {
        std::fprintf(stderr, "bench: %s: ours and that of %s differ, so there is nothing to time\n", r.work.c_str(),
                     r.peer.c_str());
        ++disagreements;
        return;
    }
    rows().push_back(std::move(r));
}

registration::registration(std::function<void()> rows) { registrations().push_back(std::move(rows)); }

}  // namespace bench

int main(int argc, char** argv) try {
    using namespace bench;
    CLI::App app("Image functions and depth pass against what a user could take instead");
    app.option_defaults()->always_capture_default();
    std::string output = "bench.json", pattern;
    limits within;
    app.add_option("output", output, "the results, as JSON");
    app.add_option("--filter", pattern, "only rows with this regular expression in \"work, peer\"");
    app.add_option("--spread", within.spread, "repeat until the ratio's spread is below");
    app.add_option("--at-least", within.at_least, "seconds a row");
    app.add_option("--at-most", within.at_most, "seconds a row, settled or not");
    using umbrage::detail::isa;
    isa& set = umbrage::detail::isa_in_use;
    const std::map<std::string, isa> sets{{"base", isa::base}, {"avx2", isa::avx2}, {"avx512", isa::avx512}};
    app.add_option("--isa", set, "the best instruction set that ours may use")
        ->transform(CLI::CheckedTransformer(sets));
    CLI11_PARSE(app, argc, argv);
    set = std::min(set, umbrage::detail::best_isa());
    filter = pattern;

    for (const auto& make : registrations()) make();
    report all{this_machine(), {}};
    print_heading(all.on);
    for (const row& r : rows()) {
        all.rows.push_back(run(r, within));
        print(all.rows.back());
    }
    write(all, output);
    return disagreements ? 1 : 0;
} catch (const std::exception& e) {
    std::fprintf(stderr, "bench: %s\n", e.what());
    return 2;
}
