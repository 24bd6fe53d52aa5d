// SPDX-License-Identifier: MIT
//
// Points of curves, measured in turns.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <fstream>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <benchmark/benchmark.h>

namespace bench {

struct curve {
    std::string plot, work, by;
    std::vector<std::pair<double, double>> points;
};

/// Measures the points that were added since it last did, in turns, and keeps the medians.
class measurements : public benchmark::BenchmarkReporter {
public:
    /// @param unit    how many nanoseconds or items one of y is: ns per item, or 1e6 for milliseconds
    /// @param agree   after one run: is the result the same as that of what ran before?
    void add(const curve& c, double x, double unit, const std::function<void()>& run, bool wall = false,
             const std::function<bool()>& agree = {}) {
        run();
        if (agree && !agree()) {
            std::fprintf(stderr, "bench_series: %s at %g: %s differs\n", c.work.c_str(), x, c.by.c_str());
            ++disagreements_;
            return;
        }
        const auto same = [&](const curve& other) {
            return c.plot == other.plot && c.work == other.work && c.by == other.by;
        };
        if (std::ranges::none_of(curves_, same)) curves_.push_back(c);
        const auto at = static_cast<std::size_t>(std::ranges::find_if(curves_, same) - curves_.begin());

        auto* b = benchmark::RegisterBenchmark(std::to_string(pending_.size()).c_str(), [run](benchmark::State& state) {
            for (auto _ : state) run();
        });
        b->Repetitions(5)->ReportAggregatesOnly()->MinTime(0.02);
        if (wall) b->UseRealTime();
        pending_.push_back({at, x, unit, wall});
    }

    void measure() {
        benchmark::RunSpecifiedBenchmarks(this);
        benchmark::ClearRegisteredBenchmarks();
        for (curve& c : curves_) std::ranges::sort(c.points);  // they ran in random order
        pending_.clear();
    }

    bool ReportContext(const Context&) override { return true; }
    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs) {
            if (run.aggregate_name != "median") continue;
            const pending& p = pending_[std::stoul(run.run_name.function_name)];
            const double y = (p.wall ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime()) / p.unit;
            curve& c = curves_[p.curve];
            c.points.emplace_back(p.x, y);
            std::printf("%-20s  %-30s  %-22s  %8g  %12.4g\n", c.plot.c_str(), c.work.c_str(), c.by.c_str(), p.x, y);
            std::fflush(stdout);
        }
    }

    /// The plot's curves, times turned into first time / time.
    void make_relative(const std::string& plot) {
        for (curve& c : curves_)
            if (c.plot == plot)
                for (const double first = c.points.front().second; auto& [x, y] : c.points) y = first / y;
    }

    [[nodiscard]] bool write(const std::string& path) const {
        std::ofstream out(path);
        out << "# plot\twork\tby\tx\ty\n";
        for (const curve& c : curves_)
            for (const auto& [x, y] : c.points)
                out << c.plot << '\t' << c.work << '\t' << c.by << '\t' << x << '\t' << y << '\n';
        return out.flush() && disagreements_ == 0;
    }

private:
    /// A point that is registered and not measured yet; its index is its name there.
    struct pending {
        std::size_t curve;
        double x, unit;
        bool wall;
    };
    std::vector<pending> pending_;
    std::vector<curve> curves_;
    int disagreements_ = 0;
};

}  // namespace bench
