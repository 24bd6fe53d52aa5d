// SPDX-License-Identifier: MIT
//
// Every entry's text in the arithmetic that graphics processors may have, held against what its tier promises.
#include <algorithm>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string_view>

#include "arithmetic/trial.hpp"

namespace parity::arithmetic {
namespace {

constexpr const char* usage = R"(Every entry's text in the arithmetic that graphics processors may have.

    parity_arithmetic [--count N] [--every N] [--filter TEXT] [--in ARITHMETIC] [--out FOLDER] [--faults SEED]

  --count    inputs of an entry, 4096
  --every    one in N pairs of entry and arithmetic, by a hash of both names; 1
  --filter   only entries whose names have this in them
  --in       one arithmetic; without it each, then all together
  --out      where arithmetic.md, the table, and arithmetic.tsv go
  --faults   plants a wrong promise for each arithmetic and tier, and visibilities beyond [0, 1]; all have to be noticed

Exit status: 0 all promises hold, 1 one does not, 2 called wrongly.
)";

struct options {
    std::string filter, in, out;
    std::size_t count = 4096, every = 1;
    std::uint64_t faults = 0;
};

options parse(int argc, char** argv) {
    options o;
    for (int i = 1; i < argc; i += 2) {
        const std::string name = argv[i];
        if (i + 1 >= argc) throw std::invalid_argument(name + " needs a value; see the head of arithmetic.cpp");
        const std::string value = argv[i + 1];
        if (name == "--count") o.count = std::stoull(value);
        else if (name == "--every") o.every = std::stoull(value);
        else if (name == "--filter") o.filter = value;
        else if (name == "--in") o.in = value;
        else if (name == "--out") o.out = value;
        else if (name == "--faults") o.faults = std::stoull(value);
        else throw std::invalid_argument("unknown option " + name);
    }
    return o;
}

struct row {
    std::string entry;
    tier exactness;
    const setting* in;
    count n;
};

const char* letter(tier t) { return t == tier::a ? "A" : t == tier::b ? "B" : "C"; }

void write_rows(const std::vector<row>& rows, const std::string& path) {
    std::ofstream file(path);
    file << "entry\ttier\tarithmetic\tinputs\tidentical\tbroken\tin bound\teither side\tdenormal\tnot finite\tout of "
            "range\t"
            "unbounded\tn\tworst share of bound\tworst difference\tleast margin\tmargin\terror\trewrites\n";
    for (const row& r : rows)
        file << r.entry << '\t' << letter(r.exactness) << '\t' << r.in->name << '\t' << r.n.inputs << '\t'
             << r.n.identical << '\t' << r.n.broken << '\t' << r.n.in_bound << '\t' << r.n.either_side << '\t'
             << r.n.denormal << '\t' << r.n.not_finite << '\t' << r.n.out_of_range << '\t' << r.n.unbounded << '\t'
             << r.n.operations << '\t' << r.n.worst_share << '\t' << r.n.worst_difference << '\t' << r.n.least_margin
             << '\t' << r.n.margin << '\t' << r.n.error << '\t' << r.n.rewrites << '\n';
    if (!file) throw std::runtime_error("cannot write " + path);
}

/// Entries and inputs of each arithmetic and tier: how many differ from C++, and how many break their promise.
void write_table(const std::vector<row>& rows, std::ostream& out) {
    out << "| arithmetic | tier | entries | of which differ | inputs | of which differ | outside the promise | on the "
           "other "
           "side | denormal, NaN, range | worst share of the bound |\n|---|---|---|---|---|---|---|---|---|---|\n";
    for (const setting& in : arithmetics)
        for (const tier t : {tier::a, tier::b, tier::c}) {
            count sum;
            std::size_t entries = 0, differ = 0;
            for (const row& r : rows)
                if (r.in == &in && r.exactness == t) ++entries, differ += r.n.identical < r.n.inputs, sum.add(r.n);
            if (entries == 0) continue;
            out << "| " << in.name << " | " << letter(t) << " | " << entries << " | " << differ << " | " << sum.inputs
                << " | " << sum.inputs - sum.identical << " | " << sum.broken << " | " << sum.either_side << " | "
                << sum.denormal + sum.not_finite + sum.out_of_range + sum.unbounded << " | ";
            if (t != tier::a) out << std::setprecision(2) << sum.worst_share;
            out << " |\n";
        }
}

/// Floors and comparisons of tier A that decide about a value with an error: how far it stays from the decision.
void write_margins(const std::vector<row>& rows, std::ostream& out) {
    std::map<std::string, const row*> least;
    for (const row& r : rows)
        if (r.exactness == tier::a && r.n.error > 0.0) {
            const row*& so_far = least[r.entry];
            if (!so_far || r.n.least_margin < so_far->n.least_margin) so_far = &r;
        }
    out << "\nFloors and comparisons of tier A that follow a value with an error:\n\n| entry | margin | error admitted "
           "|\n|---|---|---|\n";
    for (const auto& [name, r] : least)
        out << "| " << name << " | " << std::setprecision(3) << r->n.margin << " | " << r->n.error << " |\n";
}

/// A wrong promise for an entry that differs in this arithmetic: a B or C that claims to be A, a bound below its worst.
/// And results that no arithmetic gives, where no bound tells them.
int plant(const std::vector<row>& rows, const options& o) {
    int missed = 0, planted = 0;
    for (const setting& in : arithmetics)
        for (const tier t : {tier::b, tier::c}) {
            std::vector<const row*> differing, erring;
            for (const row& r : rows)
                if (r.in == &in && r.exactness == t && r.n.in_bound > 0) {
                    differing.push_back(&r);
                    if (r.n.worst_share > 0.0) erring.push_back(&r);
                }
            const auto plant_in = [&](const std::vector<const row*>& some, const char* what, auto change) {
                if (some.empty()) return;
                const row& chosen =
                    *some[std::size_t(random(o.faults + std::uint64_t(planted)).below(int(some.size())))];
                const entry& e =
                    *std::ranges::find_if(entries(), [&](const entry& one) { return one.name() == chosen.entry; });
                promise wrong = promise_of(e, in.by);
                change(wrong, chosen);
                const bool noticed = try_entry(e, in.by, o.count, wrong).broken > 0;
                ++planted, missed += !noticed;
                std::cout << (noticed ? "noticed: " : "MISSED: ") << what << ", " << chosen.entry << ", " << in.name
                          << '\n';
            };
            plant_in(differing, "said to be A", [](promise& p, const row&) { p.exactness = tier::a; });
            plant_in(erring, "a bound below the worst",
                     [](promise& p, const row& r) { p.share = 0.99 * r.n.worst_share; });
        }
    for (const entry& e : entries()) {
        if (!promise_of(e, {}).as_written || !is_visibility(e) || e.name().find(o.filter) == std::string::npos)
            continue;
        const job j = make_job(e, e.maps.empty() ? nullptr : &e.maps[0], 0, 16, 0);
        const caller run(j);
        for (std::size_t i = 0; i < j.count; ++i) {
            if (run(i, {}, 0).what.not_finite) continue;
            for (const float wrong : {-0.001f, 1.001f, std::numeric_limits<float>::quiet_NaN()}) {
                const bool noticed = !allows(run, i, vec4(wrong)) && allows(run, i, vec4(0.5f));
                ++planted, missed += !noticed;
                if (!noticed) std::cout << "MISSED: a visibility of " << wrong << ", " << e.name() << '\n';
            }
        }
    }
    std::cout << planted << " wrong promises and results planted, " << missed << " missed\n";
    return missed || planted == 0 ? 1 : 0;
}

int run(int argc, char** argv) {
    if (argc == 2 && std::string_view(argv[1]) == "--help") {
        std::cout << usage;
        return 0;
    }
    const options o = parse(argc, argv);
    std::vector<row> rows;
    std::uint64_t wrong = 0;
    const auto complain = [&](const row& r, const std::string& what) {
        ++wrong;
        std::cout << letter(r.exactness) << ' ' << r.entry << ", " << r.in->name << ": " << what << '\n';
    };
    for (const entry& e : entries()) {
        if (e.name().find(o.filter) == std::string::npos) continue;
        for (const setting& in : arithmetics) {
            if ((!o.in.empty() && o.in != in.name) || !sampled(e.name() + in.name, o.every)) continue;
            const promise p = promise_of(e, in.by);
            rows.push_back({e.name(), p.exactness, &in, try_entry(e, in.by, o.count, p)});
            const row& r = rows.back();
            if (r.n.broken && !in.by.stores_either)
                complain(r, std::to_string(r.n.broken) + " of " + std::to_string(r.n.inputs) +
                                " break the promise\n    " + r.n.example);
            if (r.n.unproven && in.by.sub_texel_bits == 0)
                complain(r, "exactness is not shown for " + std::to_string(r.n.unproven) + " inputs");
            if (p.operations > 0 && r.n.operations > p.operations)
                complain(r, "n is " + std::to_string(r.n.operations) + ", stated is " + std::to_string(p.operations));
            if (r.n.no_visibility) complain(r, std::to_string(r.n.no_visibility) + " visibilities outside [0, 1]");
            if (r.n.groupings && !r.n.rewrites && in.by.reorders) complain(r, "has other groupings, none was tried");
        }
    }
    if (rows.empty()) throw std::invalid_argument("nothing has these names");
    write_table(rows, std::cout);
    if (!o.out.empty()) {
        write_rows(rows, o.out + "/arithmetic.tsv");
        std::ofstream page(o.out + "/arithmetic.md");
        write_table(rows, page);
        write_margins(rows, page);
        if (!page) throw std::runtime_error("cannot write " + o.out + "/arithmetic.md");
    }
    std::cout << wrong << " broken promises\n";
    const int faults = o.faults ? plant(rows, o) : 0;
    return wrong ? 1 : faults;
}

}  // namespace
}  // namespace parity::arithmetic

int main(int argc, char** argv) try {
    return parity::arithmetic::run(argc, argv);
} catch (const std::exception& error) {
    std::cerr << "parity_arithmetic: " << error.what() << '\n';
    return 2;
}
