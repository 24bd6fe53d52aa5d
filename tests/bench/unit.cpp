// SPDX-License-Identifier: MIT
//
// The scale weighed: what the benchmarks measure, on a clock that only the work itself moves on.
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include "compare.hpp"
#include "measure.hpp"
#include "report.hpp"
#include "statistics.hpp"

namespace {

using doctest::Approx;

/// In (0, 1).
double random(std::mt19937& engine) { return (static_cast<double>(engine()) + 0.5) / 4294967296.0; }

struct machine_model {
    double time = 0;
    std::string calls;
    [[nodiscard]] bench::work taking(char name, std::function<double()> seconds) {
        return [this, name, seconds = std::move(seconds)] {
            calls += name;
            time += seconds();
        };
    }
    [[nodiscard]] bench::measurement measure(const bench::work& ours, const bench::work& theirs,
                                             const bench::limits& within = {}) {
        const auto now = [this] { return time; };
        return bench::measure(ours, theirs, now, now, within);
    }
};

bench::report run(double ratio, double spread, const std::string& work = "encode", double ours = 1) {
    bench::report r;
    r.rows.push_back(
        {.work = work, .peer = "memcpy", .ours = ours, .theirs = ours * ratio, .ratio = ratio, .spread = spread});
    return r;
}

bench::change only_change(const std::vector<bench::report>& before, const std::vector<bench::report>& after) {
    const bench::comparison all = bench::compare(before, after);
    REQUIRE(all.changes.size() == 1);
    return all.changes.front();
}

}  // namespace

TEST_CASE("statistics: the median of an even count lies between the two in the middle") {
    CHECK(bench::median({3, 1, 2}) == 2);
    CHECK(bench::median({4, 1, 3, 2}) == 2.5);
    CHECK(bench::median({7}) == 7);
}

TEST_CASE("statistics: ranks of the 95 % interval are those of the tables for the sign test") {
    const std::vector<std::pair<std::size_t, std::size_t>> table{{1, 0},  {6, 0},  {8, 0},   {9, 1},
                                                                 {12, 2}, {20, 5}, {50, 17}, {100, 39}};
    for (const auto& entry : table) {
        CAPTURE(entry.first);
        CHECK(bench::interval_rank(entry.first) == entry.second);
    }
    CHECK(bench::interval_rank(100000) == 49689);  // 50000 - 1.96 * sqrt(100000) / 2, less one
}

TEST_CASE("statistics: the interval holds the true median 19 times of 20, of skewed values too") {
    std::mt19937 engine(1);
    int held = 0;
    const int trials = 4000;
    for (int t = 0; t < trials; ++t) {
        std::vector<double> values;
        for (int i = 0; i < 25; ++i) values.push_back(-std::log(random(engine)));
        const bench::estimate e = bench::estimate_median(values);
        held += e.low <= std::log(2.0) && std::log(2.0) <= e.high;
    }
    CHECK(held > trials * 0.95);
    CHECK(held < trials * 0.97);  // and is no wider than it need be: 25 values give 0.957
}

TEST_CASE("statistics: one wild value moves neither median nor interval") {
    std::vector<double> values{1.00, 1.01, 1.02, 1.03, 1.04, 1.05, 1.06, 1.07, 1.08};
    const bench::estimate quiet = bench::estimate_median(values);
    values.back() = 1000;
    const bench::estimate e = bench::estimate_median(values);
    CHECK(e.median == quiet.median);
    CHECK(e.spread() == Approx((1.07 - 1.01) / 1.04));
}

TEST_CASE("measure: steady work has its ratio and no spread, and stops as soon as it may") {
    machine_model m;
    const auto ours = m.taking('a', [] { return 0.002; }), theirs = m.taking('b', [] { return 0.006; });
    const bench::measurement got = m.measure(ours, theirs);
    CHECK(got.ours == Approx(0.002));
    CHECK(got.theirs == Approx(0.006));
    CHECK(got.ratio.median == Approx(3));
    CHECK(got.ratio.spread() == Approx(0));
    CHECK(m.time < 1.1);
}

TEST_CASE("measure: who begins a round alternates") {
    machine_model m;
    const auto ours = m.taking('a', [] { return 0.5; }), theirs = m.taking('b', [] { return 0.5; });
    CHECK(m.measure(ours, theirs, {.rounds = 4}).rounds == 4);
    CHECK(m.calls ==
          "aabb"
          "abba"
          "abba");  // two calls each find out how many make a burst
}

TEST_CASE("measure: a machine that slows down all the time slows both") {
    machine_model m;
    const auto slowing = [&m](double seconds) { return [&m, seconds] { return seconds * (1 + m.time); }; };
    const auto ours = m.taking('a', slowing(0.004)), theirs = m.taking('b', slowing(0.008));
    const bench::measurement got = m.measure(ours, theirs, {.at_least = 4});
    CHECK(got.ratio.median == Approx(2).epsilon(0.01));
    CHECK(got.ratio.spread() < 0.05);
}

TEST_CASE("measure: noise is repeated until the median is known, or time is up") {
    std::mt19937 engine(2);
    const auto noisy = [&engine](double amplitude) {
        return [&engine, amplitude] { return 0.02 * (1 + amplitude * random(engine)); };
    };
    SUBCASE("some noise takes more rounds than none") {
        machine_model m;
        const auto ours = m.taking('a', noisy(0.5)), theirs = m.taking('b', noisy(0.5));
        const bench::measurement got = m.measure(ours, theirs, {.at_least = 0});
        CHECK(got.rounds > 9);
        CHECK(got.ratio.spread() < 0.05);
        CHECK(m.time < 10);
    }
    SUBCASE("too much is left at the limit, and said") {
        machine_model m;
        const auto ours = m.taking('a', noisy(50)), theirs = m.taking('b', noisy(50));
        const bench::measurement got = m.measure(ours, theirs);
        CHECK(got.ratio.spread() >= 0.05);
        CHECK(m.time >= 10);
        CHECK(m.time < 20);
    }
    SUBCASE("one round longer than the limit is not all there is") {
        machine_model m;
        const auto ours = m.taking('a', [] { return 15.0; }), theirs = m.taking('b', [] { return 15.0; });
        CHECK(m.measure(ours, theirs).rounds == 9);
    }
}

TEST_CASE("compare: within 5 % a row is kept") {
    const bench::change c = only_change({run(2.00, 0.01)}, {run(1.91, 0.01)});
    CHECK(c.relative() == Approx(-0.045));
    CHECK(c.judged() == bench::verdict::kept);
    CHECK(only_change({run(2.00, 0.01)}, {run(1.89, 0.01)}).judged() == bench::verdict::slower);
    CHECK(only_change({run(2.00, 0.01)}, {run(2.11, 0.01)}).judged() == bench::verdict::faster);
}

TEST_CASE("compare: a row's own spread, of either run, allows more") {
    CHECK(only_change({run(2.0, 0.12)}, {run(1.8, 0.01)}).judged() == bench::verdict::kept);
    CHECK(only_change({run(2.0, 0.01)}, {run(1.8, 0.12)}).judged() == bench::verdict::kept);
    CHECK(only_change({run(2.0, 0.08)}, {run(1.8, 0.08)}).judged() == bench::verdict::slower);
}

TEST_CASE("compare: several runs have the median, and the range over them as spread") {
    const std::vector<bench::report> before{run(2.0, 0.5), run(1.9, 0.5), run(2.1, 0.5), run(2.02, 0.5),
                                            run(1.98, 0.5)};
    const bench::change c = only_change(before, {run(1.75, 0.01)});
    CHECK(c.before.ratio == 2.0);
    CHECK(c.before.spread == Approx(0.1));  // what each run says of itself does not count
    CHECK(c.judged() == bench::verdict::slower);
    CHECK(only_change(before, {run(1.85, 0.01)}).judged() == bench::verdict::kept);
}

TEST_CASE("compare: one slower row is enough; rows on one side only are named") {
    std::vector<bench::report> before{run(2, 0), run(3, 0, "gone")}, after{run(1, 0), run(3, 0, "new")};
    const bench::comparison all = bench::compare(before, after);
    CHECK(all.any_slower());
    CHECK(all.only_before == std::vector<bench::row_name>{{"gone", "memcpy"}});
    CHECK(all.only_after == std::vector<bench::row_name>{{"new", "memcpy"}});
    CHECK_FALSE(bench::compare(after, after).any_slower());
}
