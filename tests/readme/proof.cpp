// SPDX-License-Identifier: MIT
#include "proof.hpp"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <umbrage/registry.hpp>

#include "tables.hpp"

namespace readme {
namespace {

/// Inputs tried, in all and of each class, and the inputs that differed.
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

/// Language of a dialect: GLSL in any dialect, or a language that it is printed in.
std::string language_of(const std::string& dialect) {
    if (dialect == "MSL") return "Metal";
    return dialect == "HLSL" || dialect == "WGSL" ? dialect : "GLSL";
}

struct report {
    struct implementation {
        std::string name, language;
        bool is_gpu = false;
        auto operator<=>(const implementation&) const = default;
    };
    std::map<implementation, tally> by_implementation;
    std::map<std::string, tally> by_primitive;

    void add(const std::filesystem::path& file) {
        std::ifstream in(file);
        const bool is_gpu = file.stem() == "parity-hardware";  // every other report is of software
        std::string line;
        std::set<std::string> names;
        for (std::getline(in, line); std::getline(in, line);) {
            std::vector<std::string> row;
            std::stringstream cells(line);
            for (std::string cell; std::getline(cells, cell, '\t');) row.push_back(cell);
            if (row.size() < 9) throw std::runtime_error(file.string() + " is cut short");
            const std::string name = row[0].substr(0, row[0].find(' '));
            names.insert(name);  // tried, or the report says why not
            if (row[4] == "0") continue;
            by_implementation[{row[2].substr(0, row[2].find(" (")), language_of(row[3]), is_gpu}].add(row);  // no build
            by_primitive[name].add(row);
        }
        for (const umbrage::glsl::snippet* s : umbrage::glsl::registry())
            if (!names.contains(std::string(s->name)))
                throw std::runtime_error(file.string() + " lacks " + std::string(s->name) +
                                         " and perhaps more: run its parity test whole");
    }
};

std::string grouped(std::uint64_t n) {
    std::string digits = std::to_string(n);
    for (std::size_t i = digits.size(); i > 3;) digits.insert(i -= 3, ",");
    return digits;
}

}  // namespace

proof read_proof(const std::filesystem::path& reports) {
    report tried;
    if (std::filesystem::is_directory(reports))
        for (const auto& file : std::filesystem::directory_iterator(reports))
            if (file.path().extension() == ".tsv" && file.path().filename().string().starts_with("parity-"))
                tried.add(file.path());
    if (tried.by_implementation.empty()) throw std::runtime_error("no parity-*.tsv in " + reports.string());

    proof text;
    text.implementations =
        "| implementation | runs on | language | dialects | primitives | inputs | differing bits, A and B | worst, C "
        "|\n"
        "|---|---|---|--:|--:|--:|--:|--:|\n";
    bool any_gpu = false;
    std::set<std::string> not_run{"GLSL", "HLSL", "Metal", "WGSL"};
    for (const auto& [of, t] : tried.by_implementation) {
        text.implementations += "| " + of.name + " | " + (of.is_gpu ? "GPU" : "CPU") + " | " + of.language + " | " +
                                std::to_string(t.dialects.size()) + " | " + std::to_string(t.primitives.size()) +
                                " | " + grouped(t.inputs) + " | " + grouped(t.differing) + " | " +
                                std::to_string(static_cast<long>(t.worst_ulp)) + " ulp |\n";
        any_gpu = any_gpu || of.is_gpu;
        not_run.erase(of.language);
    }
    for (const std::string& language : not_run) text.implementations += "\n" + language + " was not run.\n";
    if (!any_gpu) text.implementations += "\nEvery implementation above is software: none of this ran on a GPU.\n";

    for (const char* page : {"arithmetic.md", "end_to_end.md"})
        if (std::ifstream more(reports / page); more)
            text.implementations += "\n" + std::string(std::istreambuf_iterator<char>(more), {});

    text.primitives = "| primitive | tier | inputs | of each class | differing |\n|---|---|--:|---|--:|\n";
    for (const family& f : families()) {
        tally t;
        for (std::string_view name : f.names) {
            const tally& one = tried.by_primitive[std::string(name)];
            if (one.inputs == 0)
                throw std::runtime_error("no implementation in " + reports.string() + " tried " + std::string(name));
            t.inputs += one.inputs;
            t.differing += one.differing;
            for (const auto& [what, count] : one.classes) t.classes[what] += count;
        }
        text.primitives +=
            "| " + f.label() + " | " + umbrage::glsl::promise(*f.first) + " | " + grouped(t.inputs) + " | ";
        std::string separator;
        for (const auto& [what, count] : t.classes) {
            text.primitives += separator + what + " " + grouped(count);
            separator = "; ";
        }
        text.primitives += " | " + grouped(t.differing) + " |\n";
    }
    return text;
}

}  // namespace readme
