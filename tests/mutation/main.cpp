// SPDX-License-Identifier: MIT
//
// Every small change to every snippet must be seen by the parity suite's entries on llvmpipe.
//
//     mutation --equivalent FILE --out FILE.tsv [--full] [--every N] [--filter TEXT] [--list]
//
// A mutant is caught when the compiler refuses it or one result differs from C++ as the comparison of the parity suite
// has it. Those that pass a few inputs get more, up to 2^20 of each entry, and must then be in FILE with the reason
// why they are equivalent; there they are given few inputs only, unless --full. A line of FILE whose mutant is caught
// or does not exist is stale. --every takes one mutant in N, by a hash of its name: the same ones whatever is added.
//
// Exit status: 0 all caught or explained, 1 not, 77 nothing here to run on.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>

#include <umbrage/registry.hpp>

#include "compare.hpp"
#include "mutants.hpp"

namespace mutation {
namespace {

using namespace parity;

struct options {
    std::string equivalent, out, filter;
    std::size_t every = 1;
    bool full = false, list = false;
};

options parse(int argc, char** argv) {
    options o;
    for (int i = 1; i < argc; ++i) {
        const std::string name = argv[i];
        if (name == "--full") o.full = true;
        else if (name == "--list") o.list = true;
        else if (i + 1 == argc) throw std::invalid_argument(name + " is unknown or needs a value");
        else if (name == "--equivalent") o.equivalent = argv[++i];
        else if (name == "--out") o.out = argv[++i];
        else if (name == "--filter") o.filter = argv[++i];
        else if (name == "--every") o.every = std::stoul(argv[++i]);
        else throw std::invalid_argument("unknown option " + name);
    }
    return o;
}

/// Mutants that compute the same, as "primitive: operator: site", and shapes of such, which need not occur. In the file
/// a reason stands above both, after "= "; a shape is a regular expression for the whole of it, after "~ ".
struct equivalents {
    std::set<std::string> names;
    std::vector<std::regex> shapes;

    explicit equivalents(const std::string& path) {
        std::ifstream file(path);
        if (!file) throw std::runtime_error("cannot read " + path);
        bool reason = false;
        for (std::string line; std::getline(file, line);) {
            if (line.empty() || line[0] == '#') continue;
            if (line.starts_with("= ")) reason = true;
            else if (!reason) throw std::runtime_error(path + ": no reason above: " + line);
            else if (line.starts_with("~ ")) shapes.emplace_back(line.substr(2));
            else if (!names.insert(line).second) throw std::runtime_error(path + ": twice: " + line);
        }
    }
    [[nodiscard]] bool contains(const std::string& name) const {
        return names.contains(name) || std::any_of(shapes.begin(), shapes.end(), [&](const std::regex& shape) {
                   return std::regex_match(name, shape);
               });
    }
};

enum class fate { alive, refused, caught };

struct candidate {
    mutant m;
    std::string name;
    fate end = fate::alive;
    std::size_t inputs = 0;  ///< the stage that caught it
};

constexpr std::array dialects{version::v450, version::v120};  // with and without texelFetch
constexpr std::array<std::size_t, 3> stages{1 << 12, 1 << 16, 1 << 20};

/// Runs the mutants that are alive over `count` inputs of one entry.
void run(const entry& e, std::vector<candidate*>& mutants, std::size_t count, backend& b) {
    static std::uint64_t serial = 0;
    std::array<entry, 2> changed{e, e};  // in turn: a back end keeps the programs of the entry it had last
    std::array<snippet, 2> primitives{*e.primitive, *e.primitive};
    for (std::size_t k = 0; k < 2; ++k) changed[k].primitive = &primitives[k];
    std::size_t turn = 0;
    const std::size_t maps = std::max<std::size_t>(e.maps.size(), 1);
    for (std::size_t m = 0; m < maps; ++m) {
        const texels* map = e.maps.empty() ? nullptr : &e.maps[m];
        const texels flat = map ? flush(*map) : texels();
        job j = make_job(e, map, 0, count / maps, serial++);
        expectation expected{{}, map ? &flat : nullptr};
        for (std::size_t i = 0; i < j.count; ++i) expected.plain.push_back(e.twin(j.at(i)));
        for (const version v : dialects) {
            if (!e.runs_in(v)) continue;
            std::ostringstream log;
            const auto differs = [&](const entry& what) {
                j.what = &what;
                tally t;
                compare(j, expected, b.run(v, j, j.count), t, log);
                return t.different != 0;
            };
            if (differs(e)) throw std::runtime_error("before any change\n" + log.str());
            for (candidate* c : mutants) {
                if (c->end != fate::alive) continue;
                turn = 1 - turn;
                primitives[turn].source = c->m.source.c_str();
                log.str("");
                try {
                    if (differs(changed[turn])) c->end = fate::caught;
                } catch (const std::runtime_error&) { c->end = fate::refused; }
                c->inputs = count;
            }
        }
    }
}

int run_all(int argc, char** argv) {
    const options o = parse(argc, argv);
    const auto start = std::chrono::steady_clock::now();
    const equivalents equivalent(o.equivalent);

    std::vector<std::pair<const snippet*, std::vector<candidate>>> all;
    std::size_t total = 0;
    std::set<std::string> left_out;
    for (const snippet* s : umbrage::glsl::registry()) {
        if (s->name.find(o.filter) == std::string::npos) continue;
        all.push_back({s, {}});
        for (mutant& m : mutants(s->source.str())) {
            std::string name = std::string(s->name) + ": " + std::string(m.kind) + ": " + m.site;
            if (sampled(name, o.every)) all.back().second.push_back({std::move(m), std::move(name)});
            else left_out.insert(std::move(name));
        }
        total += all.back().second.size();
    }
    if (o.list) {
        for (const auto& [s, some] : all)
            for (const candidate& c : some) std::cout << c.name << '\n';
        return 0;
    }

    const backends found = egl_backends("llvmpipe");
    if (found.empty()) {
        std::cout << "SKIPPED: no llvmpipe through EGL here\n";
        return 77;
    }
    const bool terminal = isatty(STDERR_FILENO);
    std::size_t done = 0;
    for (auto& [s, some] : all) {
        std::size_t with = 0;
        for (const std::size_t count : stages) {
            std::vector<candidate*> alive;
            for (candidate& c : some)
                if (c.end == fate::alive && (o.full || count == stages[0] || !equivalent.contains(c.name)))
                    alive.push_back(&c);
            for (const entry& e : entries()) {
                if (e.primitive != s) continue;
                ++with;
                if (!alive.empty()) run(e, alive, count, *found.front());
            }
        }
        if (with == 0) throw std::runtime_error(std::string(s->name) + " has no entry");
        done += some.size();
        if (terminal) std::cerr << '\r' << std::setw(5) << done << " of " << total << " mutants" << std::flush;
    }
    if (terminal) std::cerr << '\n';

    struct row {
        std::size_t mutants = 0, refused = 0, caught = 0, explained = 0, left = 0;
    };
    std::vector<std::pair<std::string, row>> table;
    row sum;
    std::map<std::size_t, std::size_t> by_stage;
    std::vector<std::string> left, stale;
    std::set<std::string> met;
    for (const auto& [s, some] : all)
        for (const candidate& c : some) {
            auto at = std::find_if(table.begin(), table.end(), [&](const auto& r) { return r.first == c.m.kind; });
            if (at == table.end()) at = table.insert(at, {std::string(c.m.kind), {}});
            const bool listed = equivalent.contains(c.name);
            for (row* r : {&at->second, &sum}) {
                ++r->mutants;
                ++(c.end == fate::refused  ? r->refused
                   : c.end == fate::caught ? r->caught
                   : listed                ? r->explained
                                           : r->left);
            }
            if (c.end == fate::caught) ++by_stage[c.inputs];
            if (c.end == fate::alive && !listed) left.push_back(c.name);
            if (listed && c.end == fate::alive) met.insert(c.name);
        }
    for (const std::string& name : equivalent.names) {
        const bool wanted = name.substr(0, name.find(':')).find(o.filter) != std::string::npos;
        if (wanted && !met.contains(name) && !left_out.contains(name)) stale.push_back(name);
    }

    table.emplace_back("all", sum);
    std::ofstream file(o.out);
    file << "operator\tmutants\trefused\tcaught\tequivalent\tleft\n";
    std::cout << "\nMutants of " << all.size() << " snippets on " << found.front()->name() << '\n'
              << "operator     mutants  refused   caught  equivalent  left\n";
    for (const auto& [kind, r] : table) {
        file << kind;
        for (const std::size_t n : {r.mutants, r.refused, r.caught, r.explained, r.left}) file << '\t' << n;
        file << '\n';
        std::cout << std::left << std::setw(11) << kind << std::right << std::setw(9) << r.mutants << std::setw(9)
                  << r.refused << std::setw(9) << r.caught << std::setw(12) << r.explained << std::setw(6) << r.left
                  << '\n';
    }
    if (!file) throw std::runtime_error("cannot write " + o.out);
    for (const std::string& name : left) std::cout << "LEFT, not explained: " << name << '\n';
    for (const std::string& name : stale) std::cout << "STALE, caught or gone: " << name << '\n';
    std::cout << std::fixed << std::setprecision(2);
    for (const auto& [count, n] : by_stage) std::cout << n << " caught by " << count << " inputs an entry; ";
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const auto share = [&](std::size_t of) {
        return 100.0 * static_cast<double>(sum.refused + sum.caught) / static_cast<double>(of);
    };
    std::cout << seconds.count() << " s\n"
              << "mutation: " << share(sum.mutants) << " % of " << sum.mutants << " mutants caught, "
              << share(sum.mutants - sum.explained) << " % of those that are not equivalent\n";
    return left.empty() && stale.empty() ? 0 : 1;
}

}  // namespace
}  // namespace mutation

int main(int argc, char** argv) try { return mutation::run_all(argc, argv); } catch (const std::exception& error) {
    std::cerr << "mutation: " << error.what() << '\n';
    return 2;
}
