// SPDX-License-Identifier: MIT
//
//     bench_compare --before old.json --after new.json
//     bench_compare --before old1.json old2.json ... --after new1.json new2.json ...
//
// Exit status: 0 when no row is slower, 1 when one is, 2 when the two cannot be compared.
#include "compare.hpp"

#include <cstdio>
#include <exception>
#include <set>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace {

std::vector<bench::report> read_all(const std::vector<std::string>& paths) {
    std::vector<bench::report> all;
    for (const std::string& path : paths) all.push_back(bench::read(path));
    return all;
}

void warn_of_differences(const std::vector<bench::report>& before, const std::vector<bench::report>& after) {
    const auto check = [&](const char* what, std::string bench::machine::*fact) {
        std::set<std::string> seen;
        for (const bench::report& r : before) seen.insert(r.on.*fact);
        for (const bench::report& r : after) seen.insert(r.on.*fact);
        if (seen.size() == 1) return;
        std::fprintf(stderr, "bench_compare: warning: these runs differ in their %s:\n", what);
        for (const std::string& one : seen) std::fprintf(stderr, "    %s\n", one.c_str());
    };
    check("processor", &bench::machine::processor);
    check("instruction set", &bench::machine::instruction_set);
    check("compiler", &bench::machine::compiler);
}

void print(const bench::change& c) {
    const char* const verdicts[] = {"", "slower", "faster"};
    std::printf("%-58s %-22s %8.2f %8.2f %+7.1f %% %6.1f %% %+7.1f %%  %s\n", c.work.c_str(), c.peer.c_str(),
                c.before.ratio, c.after.ratio, c.relative() * 100, c.tolerance() * 100,
                (c.after.ours / c.before.ours - 1) * 100, verdicts[static_cast<int>(c.judged())]);
}

}  // namespace

int main(int argc, char** argv) try {
    CLI::App app("Ratios of two sets of benchmark runs");
    std::vector<std::string> old_files, new_files;
    app.add_option("--before", old_files, "JSON of one run or several")->required()->check(CLI::ExistingFile);
    app.add_option("--after", new_files, "JSON of one run or several")->required()->check(CLI::ExistingFile);
    CLI11_PARSE(app, argc, argv);

    const auto before = read_all(old_files), after = read_all(new_files);
    warn_of_differences(before, after);
    const bench::comparison all = bench::compare(before, after);
    for (const auto& [work, peer] : all.only_before) std::printf("only before: %s, %s\n", work.c_str(), peer.c_str());
    for (const auto& [work, peer] : all.only_after) std::printf("only after: %s, %s\n", work.c_str(), peer.c_str());
    if (all.changes.empty()) {
        std::fprintf(stderr, "bench_compare: no row is in both\n");
        return 2;
    }
    std::printf("%-58s %-22s %8s %8s %9s %8s %9s\n", "work", "against", "before", "after", "change", "allowed",
                "our time");
    for (const bench::change& c : all.changes) print(c);
    return all.any_slower() ? 1 : 0;
} catch (const std::exception& e) {
    std::fprintf(stderr, "bench_compare: %s\n", e.what());
    return 2;
}
