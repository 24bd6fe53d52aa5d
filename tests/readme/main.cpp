// SPDX-License-Identifier: MIT
//
// The generated sections of README.md, from what the library knows of itself, and the table of what the parity tests
// tried.
//
//     readme --check README.md INCLUDE       exit status 1, what differs and what to run when a section is out of date
//     readme --write README.md INCLUDE       writes the sections anew
//     readme --proof REPORTS PROOF.md        prints a line for each implementation; all of it goes to PROOF.md
//
// INCLUDE is the folder include/umbrage.
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "proof.hpp"
#include "tables.hpp"

namespace {

std::string read(const std::string& path) {
    std::ifstream in(path);
    if (!in) throw std::runtime_error("cannot read " + path);
    return {std::istreambuf_iterator<char>(in), {}};
}

void write(const std::string& path, const std::string& text) {
    if (!(std::ofstream(path) << text).flush()) throw std::runtime_error("cannot write " + path);
}

/// Puts `text` between the section's marks.
void replace(std::string& page, const std::string& section, const std::string& text) {
    const std::string begin = "<!-- begin: " + section + " -->\n", end = "<!-- end: " + section + " -->";
    const auto from = page.find(begin), to = page.find(end);
    if (from == page.npos || to == page.npos || to < from)
        throw std::runtime_error("no section '" + section + "' in the page");
    page.replace(from + begin.size(), to - from - begin.size(), text);
}

std::string with_sections(std::string page, const std::string& include) {
    replace(page, "primitives", readme::primitives());
    replace(page, "encodings", readme::encodings());
    replace(page, "filters", readme::filters());
    replace(page, "lights", readme::functions(include + "/light"));
    replace(page, "biases", readme::functions(include + "/bias"));
    replace(page, "images", readme::functions(include + "/images"));
    return page;
}

int check(const std::string& path, const std::string& include) {
    const std::string committed = read(path), current = with_sections(committed, include);
    if (committed == current) return 0;
    std::istringstream old(committed), now(current);
    for (std::string was, is; std::getline(old, was), std::getline(now, is);)
        if (was != is) {
            std::cerr << "- " << was << "\n+ " << is << '\n';
            break;
        }
    std::cerr << path << " is out of date: run `make readme`\n";
    return 1;
}

void prove(const std::string& reports, const std::string& path) {
    const auto [implementations, primitives] = readme::read_proof(reports);
    write(path, "# What the parity tests tried\n\n" + implementations +
                    "\nEach primitive, all implementations together, by class of input:\n\n" + primitives);
    std::cout << implementations << "Each primitive by class of input: " << path << '\n';
}

}  // namespace

int main(int argc, char** argv) try {
    const std::vector<std::string> args(argv + 1, argv + argc);
    const std::string what = args.size() == 3 ? args[0] : "";
    if (what == "--check") return check(args[1], args[2]);
    if (what == "--write") write(args[1], with_sections(read(args[1]), args[2]));
    else if (what == "--proof") prove(args[1], args[2]);
    else throw std::runtime_error("--check README.md INCLUDE, --write README.md INCLUDE, or --proof REPORTS PROOF.md");
    return 0;
} catch (const std::exception& error) {
    std::cerr << "readme: " << error.what() << '\n';
    return 2;
}
