// SPDX-License-Identifier: MIT
#include "exceptions.hpp"

#include <algorithm>
#include <fstream>
#include <stdexcept>
#include <string_view>

namespace turned {

namespace {

std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> all;
    for (std::size_t at = 0; at <= line.size();) {
        const std::size_t end = std::min(line.find(" | ", at), line.size());
        all.push_back(line.substr(at, end - at));
        at = end + 3;
    }
    return all;
}

}  // namespace

exceptions::exceptions(const char* file) {
    std::ifstream in(file);
    if (!in) throw std::runtime_error(std::string("no file ") + file);
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line.starts_with('#')) continue;
        const auto fields = fields_of(line);
        if (fields.size() != 4 || fields[3].empty()) throw std::runtime_error("not `a | b | c | d`: " + line);
        all_.push_back({fields[0], fields[1], fields[2]});
    }
}

bool exceptions::has(const program& p, const place& at, std::string_view turn) const {
    const std::string_view line(at.text);
    return std::ranges::any_of(all_, [&](const entry& e) {
        if (e.program != "*" && e.program != p.name) return false;
        if (e.turns != "any" && (", " + e.turns + ",").find(", " + std::string(turn) + ",") == std::string::npos)
            return false;
        for (auto found = line.find(e.code); found != line.npos; found = line.find(e.code, found + 1))
            if (found <= std::size_t(at.column) && std::size_t(at.column + at.size) <= found + e.code.size())
                return true;
        return false;
    });
}

}  // namespace turned
