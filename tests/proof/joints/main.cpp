// SPDX-License-Identifier: MIT
//
// Whole shadows of random parts against rays: setup x filter x encoding x clip space x map size x scale x place x
// scene. Prints a line a setup; fails when a receiver is wrong, and says which draw.
//
//     joints --draws 400 [1000]      draws of the seeds from 0 on, or from 1000, by as many threads as there are cores
//     joints --receivers 1e8 [1000]  as many draws as it takes
//     joints --seed 1234             one draw again, with its wrong receivers
//     joints --faults 200            plants each fault, and looks for a draw of so many that shows it
#include <atomic>
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "draw.hpp"
#include "faults.hpp"

namespace {

using namespace joints;

/// Draws of a setup.
struct line {
    tally found{};
    std::uint64_t draws = 0;
    std::map<std::string, std::uint64_t> refused{};  ///< by function and argument

    line& operator+=(const line& o) {
        found += o.found, draws += o.draws;
        for (const auto& [reason, count] : o.refused) refused[reason] += count;
        return *this;
    }
    [[nodiscard]] std::uint64_t refusals() const {
        std::uint64_t sum = 0;
        for (const auto& [reason, count] : refused) sum += count;
        return sum;
    }
};
using table = std::map<int, line>;

/// Function and argument of a message: what stands before its condition.
std::string reason_of(const std::invalid_argument& e) {
    const std::string text = e.what();
    return text.substr(0, text.find(" must "));
}

void add_draw(std::uint64_t seed, table& all, std::atomic<std::uint64_t>& receivers) {
    const choices c = draw_choices(seed);
    line& l = all[int(c.setup)];
    ++l.draws;
    try {
        drawn d(c);
        const tally found = d.right();
        l.found += found, receivers += found.lit + found.dark;
        if (found.wrong())
            std::printf("wrong: %" PRIu64 " dark, %" PRIu64 " lit, %" PRIu64 " not held, %" PRIu64 " differ of %" PRIu64
                        ": %s\n",
                        found.falsely_dark, found.falsely_lit, found.unheld, found.differs, found.lit + found.dark,
                        described(c).c_str());
    } catch (const std::invalid_argument& e) { ++l.refused[reason_of(e)]; }
}

/// @return   true when all is well
bool print(const table& all) {
    line sum;
    std::printf("%-18s %8s %11s %11s %9s %9s %9s %9s %9s %8s\n", "setup", "draws", "lit", "dark", "penumbra",
                "false dk", "false lit", "not held", "differ", "refused");
    const auto row = [](const char* name, const line& l) {
        std::printf("%-18s %8" PRIu64 " %11" PRIu64 " %11" PRIu64 " %9" PRIu64 " %9" PRIu64 " %9" PRIu64 " %9" PRIu64
                    " %9" PRIu64 " %8" PRIu64,
                    name, l.draws, l.found.lit, l.found.dark, l.found.penumbra, l.found.falsely_dark,
                    l.found.falsely_lit, l.found.unheld, l.found.differs, l.refusals());
        for (const auto& [reason, count] : l.refused) std::printf("  %s %" PRIu64 ";", reason.c_str(), count);
        std::printf("\n");
    };
    for (const auto& [setup, l] : all) row(std::string(setup_names[std::size_t(setup)]).c_str(), l), sum += l;
    row("all", sum);
    const double share = double(sum.refusals()) / double(std::max<std::uint64_t>(sum.draws, 1));
    std::printf("%" PRIu64 " receivers, %" PRIu64 " wrong, %.2f %% of the draws refused\n",
                sum.found.lit + sum.found.dark, sum.found.wrong(), 100 * share);
    return sum.found.wrong() == 0 && share <= 0.05 && sum.found.lit > 0 && sum.found.dark > 0;
}

bool prove(std::uint64_t draws, std::uint64_t receivers_wanted, std::uint64_t first_seed) {
    table all;
    std::mutex adding;
    std::atomic<std::uint64_t> next = first_seed, receivers = 0;
    std::vector<std::jthread> threads(std::max(1u, std::thread::hardware_concurrency()));
    for (std::jthread& thread : threads)
        thread = std::jthread([&] {
            table own;
            for (std::uint64_t seed; (seed = next++) - first_seed < draws && receivers < receivers_wanted;)
                add_draw(seed, own, receivers);
            const std::lock_guard lock(adding);
            for (const auto& [setup, l] : own) all[setup] += l;
        });
    threads.clear();  // joins
    return print(all);
}

bool repeat(std::uint64_t seed) {
    const choices c = draw_choices(seed);
    std::puts(described(c).c_str());
    try {
        drawn d(c);
        const tally found = d.right();
        std::printf("%" PRIu64 " lit, %" PRIu64 " dark, %" PRIu64 " in penumbras of %" PRIu64 ", %" PRIu64 " differ\n",
                    found.lit, found.dark, found.penumbra, found.receivers, found.differs);
        d.list([&](std::size_t i, verdict v, const looked_up& r, float seen) {
            std::printf("receiver %zu, (%.9g, %.9g, %.9g) with normal (%.6g, %.6g, %.6g), is %g; rays: %g to %g\n", i,
                        r.point.x, r.point.y, r.point.z, r.normal.x, r.normal.y, r.normal.z, seen, v.least, v.most);
            static_cast<void>(d.host().facts.places(r.point, r.normal, [&](const umbrage::map_place& p) {
                const glm::dvec4 h = d.host().facts.map_of(p, r.point).placed(r.point);
                std::printf(
                    "    map %d at (%.7g, %.7g, %.9g), slope (%.6g, %.6g), rounding %.4g; exactly at (%.7g, "
                    "%.7g), %.9g from the near plane\n",
                    p.number, p.at.x, p.at.y, p.at.z, p.slope.x, p.slope.y, p.slack, h.x / h.w, h.y / h.w, h.z / h.w);
            }));
        });
        return found.wrong() == 0;
    } catch (const std::invalid_argument& e) {
        std::puts(e.what());
        return true;
    }
}

}  // namespace

int main(int argc, char** argv) {
    std::setvbuf(stdout, nullptr, _IOLBF, 1 << 12);  // what was found of a run that is stopped
    const std::string_view what = argc > 2 ? argv[1] : "";
    const auto argument = [&](int i) {
        return i < argc ? static_cast<std::uint64_t>(std::strtod(argv[i], nullptr)) : std::uint64_t(0);
    };
    const std::uint64_t count = argument(2), first_seed = argument(3), all = ~std::uint64_t(0);
    if (what == "--draws" && count > 0) return prove(count, all, first_seed) ? 0 : 1;
    if (what == "--receivers" && count > 0) return prove(all, count, first_seed) ? 0 : 1;
    if (what == "--seed") return repeat(count) ? 0 : 1;
    if (what == "--faults" && count > 0) return plant_faults(count) ? 0 : 1;
    std::puts("usage: joints --draws N [first seed] | --receivers N [first seed] | --seed N | --faults N");
    return 2;
}
