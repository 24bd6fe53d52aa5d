// SPDX-License-Identifier: MIT
#include "bench.hpp"

#include <cstdio>
#include <deque>
#include <fstream>
#include <map>
#include <vector>

#include <benchmark/benchmark.h>

namespace bench {
namespace {

int disagreements = 0;

std::deque<row>& rows() {
    static std::deque<row> all;
    return all;
}
std::vector<std::function<void()>>& registrations() {
    static std::vector<std::function<void()>> all;
    return all;
}

/// Keeps the medians.
class collector : public benchmark::ConsoleReporter {
public:
    std::map<std::string, double> medians;  ///< seconds
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.aggregate_name != "median") continue;
            const bool wall = run.run_name.time_type == "real_time";
            medians[run.run_name.function_name] =
                (wall ? run.real_accumulated_time : run.cpu_accumulated_time) / double(run.iterations);
        }
        ConsoleReporter::ReportRuns(runs);
    }
};

void register_side(const row& r, const std::string& name, const std::function<void()>& work) {
    auto* b = benchmark::RegisterBenchmark(name.c_str(), [&work](benchmark::State& state) {
        for (auto _ : state) work();
    });
    b->Repetitions(15)->ReportAggregatesOnly()->MinTime(0.02)->Unit(benchmark::kMillisecond);
    if (r.measured == clock::wall) b->UseRealTime();
}

std::string side_name(std::size_t i, const char* side) { return std::to_string(i) + " " + rows()[i].work + ", " + side; }

}  // namespace

void add(row r) {
    r.ours();
    r.theirs();
    if (r.agree && !r.agree()) {
        std::fprintf(stderr, "bench: %s: ours and that of %s differ, so there is nothing to time\n", r.work.c_str(), r.peer.c_str());
        ++disagreements;
        return;
    }
    rows().push_back(std::move(r));
}

registration::registration(std::function<void()> rows) { registrations().push_back(std::move(rows)); }

}  // namespace bench

int main(int argc, char** argv) {
    using namespace bench;
    std::vector<char*> arguments(argv, argv + argc);
    std::string interleave = "--benchmark_enable_random_interleaving=true", output = "bench.json";
    arguments.push_back(interleave.data());
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (count > 1) output = arguments[1];

    for (const auto& make : registrations()) make();
    for (std::size_t i = 0; i < rows().size(); ++i) {
        register_side(rows()[i], side_name(i, "umbrage"), rows()[i].ours);
        register_side(rows()[i], side_name(i, rows()[i].peer.c_str()), rows()[i].theirs);
    }
    collector seen;
    benchmark::RunSpecifiedBenchmarks(&seen);

    std::ofstream json(output);
    std::printf("\n%-58s %-22s %10s %10s %8s %8s\n", "work", "against", "ours, ns", "theirs, ns", "ratio", "wanted");
    for (std::size_t i = 0; i < rows().size(); ++i) {
        const row& r = rows()[i];
        const auto ours = seen.medians.find(side_name(i, "umbrage")), theirs = seen.medians.find(side_name(i, r.peer.c_str()));
        if (ours == seen.medians.end() || theirs == seen.medians.end()) continue;  // filtered out
        const double a = ours->second / r.items * 1e9, b = theirs->second / r.items * 1e9;
        std::printf("%-58s %-22s %10.3f %10.3f %8.2f", r.work.c_str(), r.peer.c_str(), a, b, b / a);
        std::printf(r.at_least > 0 ? " %8.2f %s\n" : "\n", r.at_least, b / a < r.at_least ? "missed" : "");
        json << "{\"name\": \"" << r.work << "\", \"ours\": " << a << ", \"peer\": " << b << ", \"peer_name\": \"" << r.peer
             << "\", \"unit\": \"ns per item\", \"ratio\": " << b / a << "}\n";
    }
    return disagreements ? 1 : 0;
}
