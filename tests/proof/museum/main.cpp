// SPDX-License-Identifier: MIT
//
//     museum                   the tests: every old formula fails, those of umbrage do not, and MUSEUM.md says so
//     museum --page MUSEUM.md  writes the page again
//     museum --draw FOLDER     draws each test: 1_then.pgm, 1_ours.pgm ...; encodings.tsv has the errors of encodings
//
// A pixel of a drawing is 0 where all inputs are right, else 1 to 255: brighter for larger errors, up to the worst of
// the old formula.
#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <regex>
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
        for (const auto room : {encodings(), filters(), moments(), spaces()})
            for (const exhibit& e : room) list.push_back({&e, e.old_way(), e.our_way()});
        return list;
    }();
    return all;
}

std::string number(double v) {
    char text[32];
    std::snprintf(text, sizeof text, v < 1000 ? "%.3g" : "%.0f", v);
    return text;
}
std::string share(const score& s) { return std::to_string(s.wrong) + " of " + std::to_string(s.tried); }

std::string percent(const score& s) {
    const std::string text = number(100.0 * double(s.wrong) / double(s.tried));
    return s.wrong < s.tried && text == "100" ? "> 99.9 %" : text + " %";
}

/// GitHub's anchor of a heading.
std::string anchor(const std::string& heading) {
    std::string out;
    for (const char c : heading)
        if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_')
            out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        else if (c == ' ') out += '-';
    return out;
}

/// An error in words. Depths and visibilities have no unit.
std::string measured(double error, std::string_view unit) {
    if (std::isinf(error)) return "infinite";
    if (unit == "1/1024 depth") return number(error / 1024);
    if (unit == "depth" || unit == "visibility") return number(error);
    return number(error) + ' ' + std::string(unit.substr(0, unit.size() - (error == 1)));
}

/// A text whose threads, owner/name#number, are links.
std::string linked(const std::string& text) {
    static const std::regex thread(R"(([\w.-]+/[\w.-]+)#(\d+))");
    return std::regex_replace(text, thread, "[$&](https://github.com/$1/issues/$2)");
}

std::string page() {
    std::string out =
        "# A museum of bugs\n\n"
        "Each exhibit is a public bug in packing, filtering or placing depth, under the name of its symptom. The "
        "program\n"
        "`tests/proof/museum` runs the old formula and this library on the same inputs. Its test demands that the old "
        "formula fails,\n"
        "and that this library does not. This page is its output: `build/dev/tests/proof/museum/museum --page "
        "MUSEUM.md` writes it\n"
        "again.\n\n"
        "The table has the fraction of the old formula's results that are wrong, and its largest error. This library "
        "has no wrong result in any.\n"
        "Errors without a unit are depths or visibilities, in [0, 1].\n\n"
        "| exhibit | wrong | largest error |\n"
        "|---|--:|--:|\n";
    std::string rooms;
    int n = 0;
    for (const hung& e : exhibits()) {
        const std::string heading = std::to_string(++n) + ". " + e.what->title,
                          worst = measured(e.old_way.worst, e.what->unit);
        out += "| [" + heading + "](#" + anchor(heading) + ") | " + percent(e.old_way) + " | " + worst + " |\n";
        rooms += "\n## " + heading + "\n\n" + e.what->trouble + "\n\n";
        rooms += "- Seen: " + linked(e.what->seen) + "\n- Formula: `" + e.what->formula +
                 "`\n- Tried: " + e.what->counted + ".\n- Wrong: " + share(e.old_way) + ". Largest error: " + worst +
                 "\n- Here: " + e.what->ours + ". Largest error: " + number(e.our_way.worst) + "\n";
    }
    return out + rooms;
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

TEST_CASE("museum: every old formula fails, and that of umbrage does not") {
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
