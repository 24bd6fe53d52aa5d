// SPDX-License-Identifier: MIT
//
// Functions that take a hook for threads, under every hook that the contract of core/parallel.hpp allows:
//     thread_hooks [ROUNDS]
// Built with the thread sanitizer, which ends the program at a data race.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "functions.hpp"

namespace {

int failures = 0;

void check(bool holds, const function& of, const char* what) {
    if (holds) return;
    ++failures;
    std::printf("%s: %s\n", of.name.c_str(), what);
}

/// Runs each index of each call once, and counts.
struct counting {
    const hook& inner;
    bool& once;
    void operator()(int count, const piece& run) const {
        std::vector<std::atomic<int>> runs(static_cast<std::size_t>(count));
        inner(count, [&](int first, int last) {
            for (int i = first; i < last; ++i) ++runs[static_cast<std::size_t>(i)];
            run(first, last);
        });
        for (const auto& n : runs) once = once && n == 1;
    }
};

void same_bits_under_every_hook(const function& of, const blob& expected) {
    const int processors = static_cast<int>(std::thread::hardware_concurrency());
    bool once = true;
    for (const hook& each : {hook(hooks::backwards), hook(hooks::pool{2}), hook(hooks::pool{8 * processors})})
        check(of.run(counting{each, once}) == expected, of, "other bits under another hook");
    check(once, of, "the test's hooks run each index once");
    check(of.run(hooks::twice) == expected, of, "other bits where pieces run again");
    int calls = 0;
    static_cast<void>(of.run([&](int count, const piece& run) { ++calls, hooks::backwards(count, run); }));
    check(calls > 0, of, "does not call its hook");
}

/// Fails at each of some pieces. The exception arrives, and the function works the next time.
void exceptions_leave(const function& of, const blob& expected) {
    for (const int at : {0, 1, 10}) {
        int left = at;
        try {
            static_cast<void>(of.run(hooks::failing{left}));
            check(left >= 0, of, "an exception of the hook is lost");
        } catch (const hooks::failure&) {}
        check(of.run(hooks::pool{2}) == expected, of, "other bits after an exception");
    }
}

/// Several threads with a pool each run all functions at once.
void several_pools(const std::vector<function>& all, const std::vector<blob>& expected) {
    std::atomic<int> differing = 0;
    {
        std::vector<std::jthread> callers;
        for (std::size_t caller = 0; caller < 3; ++caller)
            callers.emplace_back([&, caller] {
                for (std::size_t i = 0; i < all.size(); ++i) {
                    const std::size_t k = (i + caller * all.size() / 3) % all.size();
                    differing += all[k].run(hooks::pool{3}) != expected[k];
                }
            });
    }
    if (differing > 0) ++failures, std::printf("%d results differ with several pools at once\n", differing.load());
}

/// Names of functions in headers that take a hook, which none of the lists above calls.
std::set<std::string> left_out() {
    namespace fs = std::filesystem;
    const auto text_of = [](const fs::path& path) {
        std::ifstream file(path);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    const auto is_letter = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
    const fs::path root = UMBRAGE_SOURCE_DIR;
    std::string calls;
    for (const auto& file : fs::directory_iterator(root / "tests/threads")) calls += text_of(file.path());
    std::set<std::string> names;
    for (const auto& file : fs::recursive_directory_iterator(root / "include/umbrage")) {
        if (!file.is_regular_file()) continue;
        const std::string text = text_of(file.path());
        constexpr std::string_view mark = "class ParallelFor = serial>";
        for (auto at = text.find(mark); at != text.npos; at = text.find(mark, at + 1)) {
            const auto declared = text.find("ParallelFor&&", at);
            auto end = text.find('(', at);
            for (auto next = end; next < declared; next = text.find('(', next + 1))
                if (is_letter(text[next - 1])) end = next;
            auto first = end;
            while (is_letter(text[first - 1])) --first;
            const std::string name = text.substr(first, end - first);
            if (calls.find(name + "(") == calls.npos) names.insert(name);
        }
    }
    return names;
}

}  // namespace

int main(int argc, char** argv) {
    const int rounds = argc > 1 ? std::atoi(argv[1]) : 1;
    std::vector<function> all;
    for (const auto& list : {depth_passes(), visibilities(), tables()}) all.insert(all.end(), list.begin(), list.end());
    for (const std::string& name : left_out())
        ++failures, std::printf("%s takes a hook and is not tried\n", name.c_str());
    std::vector<blob> expected;
    for (const function& each : all) expected.push_back(each.run(hooks::all_in_one));
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t i = 0; i < all.size(); ++i) {
            same_bits_under_every_hook(all[i], expected[i]);
            exceptions_leave(all[i], expected[i]);
        }
        several_pools(all, expected);
    }
    std::printf("%zu functions, %d failures\n", all.size(), failures);
    return failures != 0;
}
