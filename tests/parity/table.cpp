// SPDX-License-Identifier: MIT
#include "table.hpp"

#include <algorithm>
#include <fstream>
#include <iomanip>
#include <stdexcept>

#include <umbrage/core/snippet.hpp>

namespace parity {
namespace {

std::string per_class(const tally& t) {
    std::string all;
    for (const auto& [name, n] : t.inputs) all += (all.empty() ? "" : "; ") + name + "=" + std::to_string(n);
    return all;
}

}  // namespace

std::string promised(const entry& e) {
    if (e.exactness() == e.primitive->exactness) return umbrage::glsl::promise(*e.primitive);
    return std::string(1, "ABC"[static_cast<int>(e.exactness())]);
}

void write(const std::vector<row>& rows, const std::string& path) {
    std::ofstream file(path);
    file << "primitive\ttier\timplementation\tdialect\tinputs\tdiffering\tworst_ulp\tflushed\tclasses\tobstacle\n";
    for (const row& r : rows)
        file << r.primitive << '\t' << r.exactness << '\t' << r.implementation << '\t' << r.language << '\t'
             << r.t.total << '\t' << r.t.different << '\t' << r.t.worst_ulp << '\t' << r.t.flushed << '\t'
             << per_class(r.t) << '\t' << r.obstacle << '\n';
    if (!file) throw std::runtime_error("cannot write " + path);
}

void print(std::ostream& out, const std::vector<row>& rows) {
    out << std::left << std::setw(34) << "primitive" << std::setw(9) << "tier" << std::right << std::setw(11)
        << "inputs" << std::setw(10) << "differ" << std::setw(9) << "max ulp" << std::setw(9) << "flushed"
        << "   dialects\n";
    for (std::size_t i = 0; i < rows.size();) {
        tally sum;
        std::string dialects;
        std::size_t k = i;
        for (; k < rows.size() && rows[k].primitive == rows[i].primitive &&
               rows[k].implementation == rows[i].implementation;
             ++k) {
            sum.total += rows[k].t.total;
            sum.different += rows[k].t.different;
            sum.flushed += rows[k].t.flushed;
            sum.worst_ulp = std::max(sum.worst_ulp, rows[k].t.worst_ulp);
            sum.worst_distance = std::max(sum.worst_distance, rows[k].t.worst_distance);
            for (const auto& [name, n] : rows[k].t.inputs) sum.inputs[name] += n;
            dialects += (dialects.empty() ? "" : ", ") + rows[k].language;
        }
        out << std::left << std::setw(34) << rows[i].primitive << std::setw(9) << rows[i].exactness << std::right
            << std::setw(11) << sum.total << std::setw(10) << sum.different << std::setw(9) << sum.worst_ulp
            << std::setw(9) << sum.flushed << "   " << dialects << '\n';
        if (sum.worst_distance > 0.0f) out << "    greatest difference " << sum.worst_distance << '\n';
        if (!rows[i].obstacle.empty()) out << "    NOT RUN: " << rows[i].obstacle << '\n';
        else out << "    " << per_class(sum) << '\n';
        i = k;
    }
}

std::array<tier_sum, 3> by_tier(const std::vector<row>& rows) {
    std::array<tier_sum, 3> tiers;
    for (std::size_t i = 0; i < rows.size();) {
        tier_sum& sum = tiers[static_cast<std::size_t>(rows[i].exactness.front() - 'A')];
        std::optional<verdict> worst;
        const std::size_t first = i;
        for (; i < rows.size() && rows[i].primitive == rows[first].primitive; ++i) {
            const row& r = rows[i];
            if (!r.ran()) continue;
            worst = std::max(worst, std::optional(verdict_of(r.t)));
            sum.inputs += r.t.total;
            sum.worst_ulp = std::max(sum.worst_ulp, r.t.worst_ulp);
            sum.worst_distance = std::max(sum.worst_distance, r.t.worst_distance);
        }
        if (worst) ++sum.entries[static_cast<std::size_t>(*worst)];
        else ++sum.not_run;
    }
    return tiers;
}

void print(std::ostream& out, const std::array<tier_sum, 3>& tiers) {
    out << "| tier |";
    for (const std::string_view name : verdict_names) out << ' ' << name << " |";
    out << " not run | inputs | worst ulp | worst distance |\n|---|--:|--:|--:|--:|--:|--:|--:|\n";
    for (std::size_t i = 0; i < tiers.size(); ++i) {
        const tier_sum& t = tiers[i];
        out << "| "
            << "ABC"[i] << " |";
        for (const int n : t.entries) out << ' ' << n << " |";
        out << ' ' << t.not_run << " | " << t.inputs << " | " << t.worst_ulp << " | " << t.worst_distance << " |\n";
    }
}

}  // namespace parity
