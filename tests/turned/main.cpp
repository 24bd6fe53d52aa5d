// SPDX-License-Identifier: MIT
//
// Runs the programs of pages with each of their numbers and enumerators changed, and says what became of them:
//     turned --sample 500 LIST     so many changes of all programs, spread evenly
//     turned --all LIST [PROGRAM]  every change, of one program
//     turned --faults LIST [FAULT] each planted fault, of which all must be seen, or one by its number from 1
//     turned PROGRAM PLACE TURN    one change, with what is wrong in it. Turns: 0 (none) to 6 (NaN), `rebuilt`, or the
//                                  name of an enumerator's value
// A run is a process of its own, so that one that crashes or hangs is a result too.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "exceptions.hpp"
#include "program.hpp"
#include "run.hpp"

namespace {

using namespace turned;

constexpr std::array turns{turn::twice, turn::half, turn::thousandth, turn::zero, turn::negative, turn::nan};

struct job {
    const program* of;
    change to;

    [[nodiscard]] const place& at() const { return of->places[std::size_t(to.place)]; }
    [[nodiscard]] std::string_view turn_name() const {
        if (to.what == turn::rebuilt) return at().why;
        return to.what == turn::value ? to.value : turn_names[std::size_t(to.what)];
    }
};

std::vector<job> all_jobs() {
    std::vector<job> all;
    for (const program& p : programs())
        for (int i = 0; i < std::ssize(p.places); ++i) {
            const auto& [line, column, size, why, text, others] = p.places[std::size_t(i)];
            for (const std::string_view other : others)
                if (why == std::string_view("turned")) all.push_back({&p, {i, turn::value, other}});
            for (const turn t : turns)
                if (others.empty()) all.push_back({&p, {i, t}});
        }
    for (const program& p : programs_rebuilt()) all.push_back({&p, {0, turn::rebuilt}});
    return all;
}

std::string described(const job& j) {
    const place& at = j.at();
    std::string text(at.text);
    const auto column = std::size_t(at.column);
    text.insert(column + std::size_t(at.size), "]").insert(column, "[");
    text.erase(0, text.find_first_not_of(' '));
    // Rebuilt programs are numbered, as places are.
    int number = j.to.place;
    if (j.to.what == turn::rebuilt)
        for (const program* p = j.of; p != programs_rebuilt().data() && (p - 1)->name == j.of->name; --p) ++number;
    const std::string turned = j.to.what == turn::rebuilt ? "rebuilt"
                               : j.to.what == turn::value ? std::string(j.to.value)
                                                          : std::to_string(int(j.to.what));
    return j.of->name + ' ' + std::to_string(number) + ' ' + turned + " (line " + std::to_string(at.line) + ", " +
           std::string(j.turn_name()) + "): " + text;
}

/// What a change's outcome counts as.
std::string verdict_of(const job& j, const outcome& o, const exceptions& listed) {
    const bool may_be_refused = j.to.what != turn::twice && j.to.what != turn::half;
    switch (o.how) {
        case ending::no_change: return "no change";
        case ending::right: return o.decided > 0 ? "right by rays" : "ran, nothing to trace";
        case ending::refused:
            if (may_be_refused) return "refused by name";
            break;
        default: break;
    }
    return listed.has(*j.of, j.at(), j.turn_name()) ? "listed" : "WRONG";
}

bool prove(const std::vector<job>& jobs, const exceptions& listed) {
    std::map<std::string, std::size_t> counts;
    std::size_t lit = 0, dark = 0, kept_back = 0;
    for (const job& j : jobs) {
        const std::string_view why(j.at().why);
        if (j.to.what != turn::rebuilt && why != "turned") {
            ++counts["kept: " + std::string(why)], ++kept_back;
            continue;
        }
        const outcome o = run(*j.of, j.to);
        const std::string v = verdict_of(j, o, listed);
        ++counts[v], lit += o.lit, dark += o.dark;
        kept_back += v == "listed";
        if (v == "WRONG") std::printf("%s\n    %s\n", described(j).c_str(), o.message.c_str());
    }
    for (const auto& [what, count] : counts) std::printf("%-24s %6zu\n", what.c_str(), count);
    const double share = double(kept_back) / double(jobs.size());
    std::printf("%zu changes, %zu receivers lit and %zu dark by rays; %.1f %% are exceptions\n", jobs.size(), lit, dark,
                100 * share);
    return counts["WRONG"] == 0 && share <= 0.1;
}

/// The programs as their pages have them must be right, and the rays must have something to say.
bool prove_unchanged() {
    bool all_right = true;
    std::size_t lit = 0, dark = 0;
    for (const program& p : programs()) {
        const outcome o = run(p, {});
        lit += o.lit, dark += o.dark;
        if (o.how == ending::right) continue;
        std::printf("%s as it is: %s\n", p.name.c_str(), o.message.c_str());
        all_right = false;
    }
    std::printf("%zu programs as they are: %zu receivers lit and %zu dark by rays\n", programs().size(), lit, dark);
    return all_right && lit > 500 && dark > 500;
}

/// A fault is seen where a program as it is comes out wrong or is refused, or where a number is twice what it was and
/// no exception allows for it.
/// @param only   a fault's number; 0: all
bool plant_faults(const exceptions& listed, std::size_t only) {
    bool all_seen = true;
    for (std::size_t f = 1; f < fault_names.size(); ++f) {
        if (only != 0 && f != only) continue;
        planted_fault = fault(f);
        std::string found;
        for (const program& p : programs()) {
            const outcome o = run(p, {});
            if (o.how != ending::right && found.empty()) found = p.name + ": " + o.message;
        }
        for (const job& j : all_jobs()) {
            if (!found.empty()) break;
            if (j.to.what != turn::twice) continue;
            const outcome o = run(*j.of, j.to);
            if (verdict_of(j, o, listed) == "WRONG") found = described(j) + ": " + o.message;
        }
        std::printf("%-44.*s %s\n", int(fault_names[f].size()), fault_names[f].data(),
                    found.empty() ? "NOT SEEN" : found.c_str());
        all_seen = all_seen && !found.empty();
    }
    return all_seen;
}

std::vector<job> sample_of(std::vector<job> all, std::size_t count) {
    std::vector<job> some;
    for (std::size_t i = 0; i < count && i < all.size(); ++i) some.push_back(all[i * all.size() / count]);
    return some;
}

}  // namespace

int main(int argc, char** argv) {
    std::setvbuf(stdout, nullptr, _IOLBF, 1 << 12);
    std::ranges::sort(programs(), {}, &program::name);
    std::ranges::stable_sort(programs_rebuilt(), {}, &program::name);
    const std::string_view what = argc > 1 ? argv[1] : "";
    if (what == "--faults" && (argc == 3 || argc == 4))
        return plant_faults(exceptions(argv[2]), argc == 4 ? std::strtoul(argv[3], nullptr, 10) : 0) ? 0 : 1;
    if (argc == 4 && !what.starts_with("--")) {
        const int number = std::atoi(argv[2]);
        const std::string_view turned = argv[3];
        const bool is_rebuilt = turned == "rebuilt", is_number = turned.find_first_not_of("0123456") == turned.npos;
        const std::vector<program>& all = is_rebuilt ? programs_rebuilt() : programs();
        const auto own = std::ranges::equal_range(all, what, {}, &program::name);
        if (!own.empty() && number >= 0 && (!is_rebuilt || number < std::ssize(own))) {
            const change c = is_number ? change{number, turn(std::atoi(argv[3]))} : change{number, turn::value, turned};
            const outcome o = is_rebuilt ? run(own[number], {0, turn::rebuilt}) : run(own.front(), c);
            std::printf("%zu lit, %zu dark: %s\n", o.lit, o.dark, o.message.c_str());
            return o.how == ending::right || o.how == ending::refused ? 0 : 1;
        }
    }
    const bool is_sample = what == "--sample" && argc == 4;
    if (is_sample || (what == "--all" && (argc == 3 || argc == 4))) {
        const exceptions listed(argv[is_sample ? 3 : 2]);
        std::vector<job> all = all_jobs();
        if (!is_sample && argc == 4) {
            std::erase_if(all, [&](const job& j) { return j.of->name != argv[3]; });
            return prove(all, listed) ? 0 : 1;
        }
        const bool is_right = prove_unchanged();
        const bool is_proven = prove(is_sample ? sample_of(all, std::strtoul(argv[2], nullptr, 10)) : all, listed);
        return is_right && is_proven ? 0 : 1;
    }
    std::puts("usage: turned --sample N LIST | --all LIST [PROGRAM] | --faults LIST [FAULT] | PROGRAM PLACE TURN");
    return 2;
}
