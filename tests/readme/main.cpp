// SPDX-License-Identifier: MIT
//
// Keeps the generated sections of README.md true.
//
//     readme README.md --check       exit status 1 and a word on what to run when a section is out of date
//     readme README.md --write       writes them anew
//
#include <cstdio>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <string_view>

#include <umbrage/registry.hpp>

namespace {

namespace glsl = umbrage::glsl;

std::string tier_of(const glsl::snippet& s) {
    if (s.exactness == glsl::tier::a) return "A";
    if (s.exactness == glsl::tier::b) return "B";
    return "C, " + std::to_string(s.ulp) + " ulp";
}

/// One row a primitive; neighbours that share a summary are one family and one row.
std::string primitives() {
    std::string table = "| primitive | what it does | tier | lowest GLSL |\n|---|---|---|---|\n";
    const auto& all = glsl::registry;
    for (std::size_t i = 0; i < all.size();) {
        std::size_t last = i;
        while (last + 1 < all.size() && all[last + 1]->summary == all[i]->summary) ++last;
        const auto& s = *all[i];
        table += "| `" + std::string(s.name) + "`";
        if (last > i) table += " to `" + std::string(all[last]->name) + "`";
        table += " | " + std::string(s.summary) + " | " + tier_of(s);
        table += s.lowest == glsl::version::v100 ? " | 100 |\n" : " | 330, 300 es |\n";
        i = last + 1;
    }
    return table;
}

/// Puts `text` between the section's marks.
std::string replaced(const std::string& page, std::string_view section, const std::string& text) {
    const std::string begin = "<!-- begin: " + std::string(section) + " -->\n", end = "<!-- end: " + std::string(section) + " -->";
    const auto from = page.find(begin), to = page.find(end);
    if (from == page.npos || to == page.npos || to < from) {
        std::cerr << "no section '" << section << "' in the page\n";
        std::exit(2);
    }
    return page.substr(0, from + begin.size()) + text + page.substr(to);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3 || (argv[2] != std::string_view("--check") && argv[2] != std::string_view("--write"))) {
        std::cerr << "usage: readme README.md --check|--write\n";
        return 2;
    }
    std::stringstream old;
    old << std::ifstream(argv[1]).rdbuf();
    const std::string page = replaced(old.str(), "primitives", primitives());
    if (page == old.str()) return 0;
    if (argv[2] == std::string_view("--check")) {
        std::cerr << argv[1] << " is out of date: run `make readme`\n";
        return 1;
    }
    std::ofstream(argv[1]) << page;
}
