// SPDX-License-Identifier: MIT
#include "report.hpp"

#include <algorithm>
#include <cctype>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <stdexcept>

#include <sys/utsname.h>

#include <umbrage/version.hpp>

namespace parity {
namespace {

constexpr const char* compiler =
#ifdef __clang__
    "clang " __clang_version__;
#elif defined(__GNUC__)
    "g++ " __VERSION__;
#else
    "unknown";
#endif

std::string machine() {
    utsname of{};
    if (uname(&of) != 0) return "unknown";
    return std::string(of.sysname) + ' ' + of.release + ' ' + of.machine;
}

/// Letters and digits, with single hyphens between them.
std::string file_name(const identity& of) {
    std::string name;
    for (const char c : "report " + of.api + ' ' + of.device.substr(0, of.device.find('('))) {
        if (std::isalnum(static_cast<unsigned char>(c))) name += static_cast<char>(std::tolower(c));
        else if (name.back() != '-') name += '-';
    }
    if (name.back() == '-') name.pop_back();
    return name + ".md";
}

std::string joined(const std::vector<std::string>& words) {
    std::string all;
    for (const std::string& w : words) all += (all.empty() ? "" : ", ") + w;
    return all;
}

void print_system(std::ostream& out, const report& r, const std::string& command) {
    const std::time_t now = std::time(nullptr);
    const auto line = [&](const char* what, const std::string& value) {
        out << "| " << what << " | " << (value.empty() ? "unknown" : value) << " |\n";
    };
    out << "| | |\n|---|---|\n";
    line("device", r.of.device);
    line("driver", r.of.driver);
    line("version", r.of.version);
    line("dialects", joined(r.dialects));
    line("umbrage", std::to_string(UMBRAGE_VERSION_MAJOR) + '.' + std::to_string(UMBRAGE_VERSION_MINOR) + '.' +
                        std::to_string(UMBRAGE_VERSION_PATCH));
    line("compiler", compiler);
    line("system", r.system.empty() ? machine() : r.system);
    line("command", '`' + command + '`');
    out << "| date | " << std::put_time(std::gmtime(&now), "%Y-%m-%d") << " |\n";
}

/// As a block of code in a list.
std::string code(const std::string& text) {
    std::string all = "\n\n    ";
    for (const char c : text.substr(0, text.find_last_not_of('\n') + 1))
        all += c == '\n' ? "\n    " : std::string(1, c);
    return all;
}

/// Entries of which some row is as asked: each with those rows' dialects, and its first row's text.
void list(std::ostream& out, const std::vector<row>& rows, auto wanted, auto text) {
    for (std::size_t i = 0; i < rows.size();) {
        const row* first = nullptr;
        std::vector<std::string> dialects;
        const std::size_t start = i;
        for (; i < rows.size() && rows[i].primitive == rows[start].primitive; ++i) {
            if (!wanted(rows[i])) continue;
            if (!first) first = &rows[i];
            dialects.push_back(rows[i].language);
        }
        if (first) out << "\n- **" << first->primitive << "** (" << joined(dialects) << ") " << text(*first) << '\n';
    }
}

void add_probe(report& r, backend& b, dialect d) {
    try {
        if (b.has_compiler()) r.probed = probe(b, d);
        else r.unprobed = "its shaders were compiled with this program";
    } catch (const std::exception& error) { r.unprobed = error.what(); }
}

}  // namespace

std::vector<report> probe_all(backend& b) {
    std::vector<report> all;
    const std::vector<dialect> dialects = b.dialects();
    for (const dialect d : dialects) {
        const identity of = b.about(d);
        const auto same = [&](const report& r) { return r.of.api == of.api; };
        auto found = std::find_if(all.begin(), all.end(), same);
        if (found == all.end()) found = all.insert(found, {.of = of});
        found->dialects.push_back(b.label(d));
        if (d.in == dialect::glsl || found->probed_in.empty()) found->of = of, found->probed_in = b.label(d);
    }
    for (report& r : all)
        for (const dialect d : dialects)
            if (b.label(d) == r.probed_in && b.about(d).api == r.of.api) add_probe(r, b, d);
    return all;
}

void print(std::ostream& out, const report& r, const std::string& command) {
    out << "# umbrage on " << r.of.api << (r.of.device.empty() ? "" : ", " + r.of.device) << "\n\n";
    print_system(out, r, command);

    out << "\n## Arithmetic\n\n";
    if (!r.probed) out << "Not probed: " << r.unprobed << ".\n";
    else {
        for (const std::string& line : described(*r.probed)) out << "- " << line << '\n';
        out << "\nIn " << r.probed_in << ".\n";
    }

    out << "\n## Entries\n\nAn entry is a primitive with one kind of map and parameters. It counts by its worst "
           "result.\n"
           "A sample of the "
        << entries().size() << " entries and their dialects ran, unless the command asks for all.\n\n";
    print(out, by_tier(r.rows));
    out << "\n- identical: the bits of C++; NaN equals NaN\n"
           "- as promised: within the tier's bound; a denormal may be zero, and -0 may be 0\n"
           "- different: anything else\n"
           "- worst ulp, worst distance: of results in tier C, from C++; each entry has one of them\n";

    out << "\n## Different\n";
    const auto differs = [](const row& x) { return x.t.different > 0; };
    if (std::none_of(r.rows.begin(), r.rows.end(), differs)) out << "\nNone.\n";
    list(out, r.rows, differs, [](const row& x) {
        return std::to_string(x.t.different) + " of " + std::to_string(x.t.total) + " results, tier " + x.exactness +
               code(x.example);
    });

    out << "\n## Not run\n";
    const auto missing = [](const row& x) { return !x.ran(); };
    if (std::none_of(r.rows.begin(), r.rows.end(), missing)) out << "\nNone.\n";
    list(out, r.rows, missing, [](const row& x) { return x.obstacle.empty() ? code("  " + x.broken) : x.obstacle; });

    out << "\n## Where to send it\n\nOpen an issue with this file. If nothing differs, it is welcome too: the device "
           "is then "
           "known to work.\n";
}

std::string write(const report& r, const std::string& command, const std::string& folder) {
    std::filesystem::create_directories(folder);
    const std::string path = folder + '/' + file_name(r.of);
    std::ofstream out(path);
    print(out, r, command);
    if (!out) throw std::runtime_error("cannot write " + path);
    return path;
}

}  // namespace parity
