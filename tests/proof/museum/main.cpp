// SPDX-License-Identifier: MIT
//
//     museum                   the tests: every old formula fails, ours do not, and MUSEUM.md says so
//     museum --page MUSEUM.md  writes the page anew
//     museum --draw FOLDER     draws each test, FOLDER/1_then.pgm, FOLDER/1_ours.pgm ..., and writes FOLDER/encodings.tsv
//
// A pixel of a drawing is 0 where all inputs are right, else 1 to 255: brighter for larger errors, up to the worst of the
// old formula.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "curves.hpp"
#include "museum.hpp"

namespace {

struct hung {
    const exhibit* what;
    score old_way, our_way;
};

const std::vector<hung>& exhibits() {
    static const std::vector<hung> all = [] {
        std::vector<hung> list;
        for (const auto room : {encodings(), filters(), spaces()})
            for (const exhibit& e : room) list.push_back({&e, e.old_way(), e.our_way()});
        return list;
    }();
    return all;
}

std::string number(double v) {
    char text[32];
    std::snprintf(text, sizeof text, "%.3g", v);
    return text;
}
std::string share(const score& s) { return std::to_string(s.wrong) + " of " + std::to_string(s.tried); }

std::string page() {
    std::string out =
        "# A museum of bugs\n\n"
        "Public bugs in packing depth, in filtering it and in getting there. Each old formula was written anew from "
        "its\n"
        "description and run beside umbrage on the same inputs; `tests/proof/museum` is that program, its test demands "
        "that\n"
        "the old formula fails and ours does not, and this page is what it prints: after a change of it run\n"
        "`build/dev/tests/proof/museum/museum --page MUSEUM.md`.\n\n"
        "| # | exhibit | wrong, then | worst, then | wrong, umbrage | worst, umbrage | unit |\n"
        "|--:|---|--:|--:|--:|--:|---|\n";
    int n = 0;
    for (const hung& e : exhibits())
        out += "| " + std::to_string(++n) + " | " + e.what->title + " | " + share(e.old_way) + " | " +
               number(e.old_way.worst) + " | " + std::to_string(e.our_way.wrong) + " | " + number(e.our_way.worst) +
               " | " + e.what->unit + " |\n";
    n = 0;
    for (const hung& e : exhibits()) {
        out += "\n## " + std::to_string(++n) + ". " + e.what->title + "\n\n" + e.what->trouble + "\n\n";
        out += std::string("- Seen: ") + e.what->seen + "\n- Formula: `" + e.what->formula +
               "`\n- Tried: " + e.what->counted + ": " + share(e.old_way) + ", worst " + number(e.old_way.worst) +
               "\n- Here: " + e.what->ours + "; worst " + number(e.our_way.worst) + "\n";
    }
    return out;
}

/// Draws a score: at most 128 rows, 256 columns, and no more cells than inputs.
bool draw(score (*way)(), long inputs, double worst, const std::string& path) {
    const long columns = std::min({256L, inputs, static_cast<long>(std::ceil(std::sqrt(2.0 * double(inputs))))});
    const long rows = std::clamp(inputs / columns, 1L, 128L);
    drawing all{inputs, columns, rows, std::vector<double>(static_cast<std::size_t>(columns * rows))};
    score::drawn = &all;
    static_cast<void>(way());
    score::drawn = nullptr;
    std::ofstream file(path, std::ios::binary);
    file << "P5\n" << columns << ' ' << rows << "\n255\n";
    for (const double error : all.errors) {
        const double share = std::isinf(error) ? 1.0 : error / (std::isinf(worst) ? 1.0 : worst);
        file << static_cast<char>(error > 0 ? 1 + static_cast<int>(254 * std::min(share, 1.0)) : 0);
    }
    return bool(file);
}
bool draw_all(const std::string& folder) {
    int n = 0;
    bool drawn = true;
    for (const hung& e : exhibits()) {
        const std::string path = folder + "/" + std::to_string(++n);
        drawn = drawn && draw(e.what->old_way, e.old_way.tried, e.old_way.worst, path + "_then.pgm") &&
                draw(e.what->our_way, e.our_way.tried, e.old_way.worst, path + "_ours.pgm");
    }
    std::ofstream curves(folder + "/encodings.tsv");
    write_curves(curves);
    return drawn && curves;
}

}  // namespace

TEST_CASE("museum: every old formula fails, and ours does not") {
    CHECK(exhibits().size() >= 20);
    for (const hung& e : exhibits()) {
        CAPTURE(e.what->title);
        CAPTURE(e.old_way.worst);
        CAPTURE(e.our_way.worst);
        CHECK(e.old_way.wrong > 0);
        CHECK(e.our_way.wrong == 0);
        CHECK(e.old_way.tried == e.our_way.tried);
    }
}

TEST_CASE("museum: MUSEUM.md is what the museum prints") {
    std::ifstream file(UMBRAGE_ROOT "/MUSEUM.md");
    const std::string committed{std::istreambuf_iterator<char>(file), {}};
    CHECK_MESSAGE(committed == page(), "run: build/dev/tests/proof/museum/museum --page MUSEUM.md");
}

int main(int argc, char** argv) {
    if (argc == 3 && std::string_view(argv[1]) == "--page") return (std::ofstream(argv[2]) << page()) ? 0 : 1;
    if (argc == 3 && std::string_view(argv[1]) == "--draw") return draw_all(argv[2]) ? 0 : 1;
    return doctest::Context(argc, argv).run();
}
