// SPDX-License-Identifier: MIT
//
// Keeps the generated sections of README.md true: the primitives, from the registry, and what the parity tests of this
// build tried, from the parity-*.tsv that they leave behind.
//
//     readme --check README.md REPORTS   exit status 1 and a word on what to run when a section is out of date;
//                                        77 when this machine lacks an implementation that the page reports
//     readme --write README.md REPORTS   writes them anew
//     readme --print REPORTS             the report alone
//
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <umbrage/shader/registry.hpp>

namespace {

namespace glsl = umbrage::glsl;

std::string tier_of(const glsl::snippet& s) {
    if (s.exactness == glsl::tier::a) return "A";
    if (s.exactness == glsl::tier::b) return "B";
    return "C, " + std::to_string(s.ulp) + " ulp";
}

/// The registry in order; neighbours that share a summary are one family.
struct family {
    std::string label;
    std::vector<std::string_view> names;
    const glsl::snippet* first;
};
std::vector<family> families() {
    std::vector<family> all;
    for (const glsl::snippet* s : glsl::registry) {
        if (all.empty() || all.back().first->summary != s->summary) all.push_back({{}, {}, s});
        all.back().names.push_back(s->name);
    }
    for (family& f : all) {
        f.label = "`" + std::string(f.names.front()) + "`";
        if (f.names.size() > 1) f.label += " to `" + std::string(f.names.back()) + "`";
    }
    return all;
}

std::string primitives() {
    std::string table = "| primitive | what it does | tier | lowest GLSL |\n|---|---|---|---|\n";
    for (const family& f : families())
        table += "| " + f.label + " | " + std::string(f.first->summary) + " | " + tier_of(*f.first) +
                 (f.first->lowest == glsl::version::v100 ? " | 100 |\n" : " | 330, 300 es |\n");
    return table;
}

/// What was tried: inputs in all, of each class, and what differed.
struct tally {
    std::uint64_t inputs = 0, differing = 0;
    double worst_ulp = 0;
    std::map<std::string, std::uint64_t> classes;
    std::set<std::string> dialects, primitives;

    void add(const std::vector<std::string>& row) {  // primitive tier implementation dialect inputs differing ulp ...
        inputs += std::stoull(row[4]);
        differing += std::stoull(row[5]);
        worst_ulp = std::max(worst_ulp, std::stod(row[6]));
        dialects.insert(row[3]);
        primitives.insert(row[0].substr(0, row[0].find(' ')));  // less the variant
        std::stringstream list(row[8]);
        for (std::string item; std::getline(list, item, ';');) {
            item.erase(0, item.find_first_not_of(' '));
            const auto equals = item.find('=');
            if (equals != item.npos) classes[item.substr(0, equals)] += std::stoull(item.substr(equals + 1));
        }
    }
};

struct report {
    std::map<std::string, tally> by_implementation, by_primitive;
};

report read_reports(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    if (std::filesystem::is_directory(folder))
        for (const auto& file : std::filesystem::directory_iterator(folder))
            if (file.path().extension() == ".tsv" && file.path().filename().string().starts_with("parity-"))
                files.push_back(file.path());
    report all;
    for (const auto& file : files) {
        std::ifstream in(file);
        std::string line;
        for (std::getline(in, line); std::getline(in, line);) {
            std::vector<std::string> row;
            std::stringstream cells(line);
            for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
            if (row.size() < 9 || row[4] == "0") continue;
            const std::string implementation = row[2].substr(0, row[2].find(" ("));  // less the build
            all.by_implementation[implementation].add(row);
            all.by_primitive[row[0].substr(0, row[0].find(' '))].add(row);
        }
    }
    return all;
}

std::string grouped(std::uint64_t n) {
    std::string digits = std::to_string(n);
    for (std::size_t i = digits.size(); i > 3;) digits.insert(i -= 3, ",");
    return digits;
}

std::string proof(const report& tried) {
    std::string text =
        "| implementation | dialects | primitives | inputs | differing bits, A and B | worst, C "
        "|\n|---|--:|--:|--:|--:|--:|\n";
    for (const auto& [name, t] : tried.by_implementation) {
        text += "| " + name + " | " + std::to_string(t.dialects.size()) + " | " + std::to_string(t.primitives.size()) +
                " | " + grouped(t.inputs) + " | " + grouped(t.differing) + " | " +
                std::to_string(static_cast<long>(t.worst_ulp)) + " ulp |\n";
    }
    text +=
        "\n<details><summary>Each primitive, all implementations together, by class of input</summary>\n\n"
        "| primitive | tier | inputs | of each class | differing |\n|---|---|--:|---|--:|\n";
    for (const family& f : families()) {
        tally t;
        for (std::string_view name : f.names) {
            const auto found = tried.by_primitive.find(std::string(name));
            if (found == tried.by_primitive.end()) continue;
            t.inputs += found->second.inputs;
            t.differing += found->second.differing;
            for (const auto& [what, count] : found->second.classes) t.classes[what] += count;
        }
        text += "| " + f.label + " | " + tier_of(*f.first) + " | " + grouped(t.inputs) + " | ";
        std::string separator;
        for (const auto& [what, count] : t.classes) {
            text += separator + what + " " + grouped(count);
            separator = "; ";
        }
        text += " | " + grouped(t.differing) + " |\n";
    }
    return text + "\n</details>\n";
}

/// Puts `text` between the section's marks.
std::string replaced(const std::string& page, std::string_view section, const std::string& text) {
    const std::string begin = "<!-- begin: " + std::string(section) + " -->\n",
                      end = "<!-- end: " + std::string(section) + " -->";
    const auto from = page.find(begin), to = page.find(end);
    if (from == page.npos || to == page.npos || to < from) {
        std::cerr << "no section '" << section << "' in the page\n";
        std::exit(2);
    }
    return page.substr(0, from + begin.size()) + text + page.substr(to);
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> args(argv + 1, argv + argc);
    if (args.size() == 2 && args[0] == "--print") {
        std::cout << proof(read_reports(args[1]));
        return 0;
    }
    if (args.size() != 3 || (args[0] != "--check" && args[0] != "--write")) {
        std::cerr << "usage: readme --check|--write README.md REPORTS, or readme --print REPORTS\n";
        return 2;
    }
    std::stringstream old;
    old << std::ifstream(args[1]).rdbuf();
    const report tried = read_reports(args[2]);
    const std::string page = replaced(replaced(old.str(), "primitives", primitives()), "proof", proof(tried));
    if (page == old.str()) return 0;
    if (args[0] == "--write") {
        std::ofstream(args[1]) << page;
        return 0;
    }
    const std::string without_proof = replaced(old.str(), "primitives", primitives());
    if (without_proof == old.str())
        for (std::string_view name : {"llvmpipe", "softpipe", "lavapipe", "SwiftShader", "text as C++"})
            if (old.str().find("| " + std::string(name)) != std::string::npos &&
                std::none_of(tried.by_implementation.begin(), tried.by_implementation.end(),
                             [&](const auto& i) { return i.first.starts_with(name); })) {
                std::cerr << "no report of " << name << " in this build: the page's proof cannot be checked here\n";
                return 77;
            }
    std::cerr << args[1] << " is out of date: run `make readme`\n";
    return 1;
}
