// SPDX-License-Identifier: MIT
//
// The pages of the project: their generated sections, their links and their prose; and the table of what the parity
// tests tried.
//
//     readme --check ROOT             exit status 1 when a section is out of date: what differs, and what to run
//     readme --write ROOT             generates the sections again
//     readme --links ROOT             exit status 1 when a link leads nowhere, or a page is far from README.md
//     readme --names ROOT LIST        exit status 1 when a public name stands on no page and not in the list
//     readme --public ROOT            prints each public name behind its header's place
//     readme --questions ROOT LIST    exit status 1 when a question's answer is more than two clicks from README.md
//     readme --sample ROOT SEED       a hundred sentences of headers and pages, for a reader to judge
//     readme --prose ROOT             exit status 1 when a sentence is long, or a word is one of those to avoid
//     readme --proof REPORTS PROOF.md prints a line for each implementation; all of it goes to PROOF.md
//
// A section stands between `<!-- begin: primitives bias -->` and `<!-- end -->`. Its name may be primitives, names or
// index, of the folders of include/umbrage that follow, encodings, filters or paths.
#include <algorithm>
#include <cstdint>
#include <exception>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "headers.hpp"
#include "names.hpp"
#include "pages.hpp"
#include "proof.hpp"
#include "questions.hpp"
#include "sample.hpp"
#include "tables.hpp"

namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
    if (!(std::ofstream(path) << text).flush()) throw std::runtime_error("cannot write " + path.string());
}

std::string section(const std::vector<readme::page>& pages, const fs::path& page, const fs::path& root,
                    const std::string& name, const std::vector<std::string>& folders) {
    const fs::path include = root / "include/umbrage";
    if (name == "primitives") return readme::primitives(include, folders);
    if (name == "names") return readme::names(page, include, folders);
    if (name == "index") return readme::index(pages, include, folders);
    if (name == "encodings") return readme::encodings();
    if (name == "filters") return readme::filters();
    if (name == "paths") return readme::paths(root / "tests/paths/paths.txt");
    throw std::runtime_error("no section has the name '" + name + "'");
}

std::string with_sections(const readme::page& p, const std::vector<readme::page>& pages, const fs::path& root) {
    const std::string& page = p.text;
    const std::string begin = "<!-- begin: ", end = "<!-- end -->";
    std::string out;
    std::size_t copied = 0;
    for (auto at = page.find(begin); at != page.npos; at = page.find(begin, copied)) {
        const auto line_end = page.find('\n', at), close = page.find(end, at);
        if (close == page.npos) throw std::runtime_error("a section has no end: " + page.substr(at, line_end - at));
        std::istringstream words(page.substr(at + begin.size(), line_end - 4 - at - begin.size()));
        std::vector<std::string> folders{std::istream_iterator<std::string>(words), {}};
        const std::string name = folders.at(0);
        folders.erase(folders.begin());
        out += page.substr(copied, line_end + 1 - copied) + section(pages, root / p.path, root, name, folders);
        copied = close;
    }
    return out + page.substr(copied);
}

/// Every primitive stands on some page.
int check_all_listed(const std::string& all) {
    int missing = 0;
    for (const readme::family& f : readme::families())
        if (all.find("| " + f.label() + " | " + std::string(f.first->summary)) == all.npos)
            std::cerr << "no page lists " << f.label() << '\n', ++missing;
    return missing;
}

int check(const fs::path& root) {
    int wrong = 0;
    std::string all;
    const auto pages = readme::pages(root);
    for (const readme::page& p : pages) {
        const std::string current = with_sections(p, pages, root);
        all += current;
        if (current == p.text) continue;
        ++wrong;
        std::istringstream old(p.text), now(current);
        for (std::string was, is; std::getline(old, was), std::getline(now, is);)
            if (was != is) {
                std::cerr << "- " << was << "\n+ " << is << '\n';
                break;
            }
        std::cerr << p.path << " is out of date: run `cmake --build --preset dev --target pages`\n";
    }
    return wrong + check_all_listed(all) ? 1 : 0;
}

void write(const fs::path& root) {
    const auto pages = readme::pages(root);
    for (const readme::page& p : pages) {
        const std::string current = with_sections(p, pages, root);
        if (current != p.text) write(root / p.path, current);
    }
}

void prove(const std::string& reports, const std::string& path) {
    const auto [implementations, primitives] = readme::read_proof(reports);
    write(path, "# What the parity tests tried\n\n" + implementations +
                    "\nEach primitive, all implementations together, by class of input:\n\n" + primitives);
    std::cout << implementations << "Each primitive by class of input: " << path << '\n';
}

/// Prints what is wrong.
int report(const std::vector<std::string>& wrong) {
    for (const std::string& each : wrong) std::cerr << each << '\n';
    return wrong.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) try {
    const std::vector<std::string> args(argv + 1, argv + argc);
    const std::string what = args.size() == 2 || args.size() == 3 ? args[0] : "";
    if (what == "--check") return check(args[1]);
    if (what == "--links") return report(readme::wrong_links(readme::pages(args[1]), args[1]));
    if (what == "--prose") return report(readme::wrong_prose(readme::pages(args[1])));
    if (what == "--public") {
        for (const auto& [place, header] : readme::headers(fs::path(args[1]) / "include/umbrage"))
            for (const std::string& name : readme::names_in(header)) std::cout << place << ' ' << name << '\n';
        return 0;
    }
    if (what == "--names" && args.size() == 3)
        return report(readme::wrong_names(readme::pages(args[1]), fs::path(args[1]) / "include/umbrage", args[2]));
    if (what == "--questions" && args.size() == 3)
        return report(readme::wrong_questions(readme::pages(args[1]), args[2]));
    if (what == "--sample" && args.size() == 3) {
        for (const auto& each :
             readme::sample_of(readme::pages(args[1]), args[1], std::uint32_t(std::stoul(args[2])), 100))
            std::cout << each << '\n';
        return 0;
    }
    if (what == "--write") write(fs::path(args[1]));
    else if (what == "--proof" && args.size() == 3) prove(args[1], args[2]);
    else
        throw std::runtime_error(
            "--check, --write, --links, --public or --prose ROOT, --names or --questions ROOT LIST, --sample ROOT "
            "SEED, or "
            "--proof REPORTS "
            "PROOF.md");
    return 0;
} catch (const std::exception& error) {
    std::cerr << "readme: " << error.what() << '\n';
    return 2;
}
