// SPDX-License-Identifier: MIT
#include "report.hpp"

#include <fstream>
#include <stdexcept>

#include <nlohmann/json.hpp>

namespace bench {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(machine, processor, processors, instruction_set, best_instruction_set, compiler)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(result, work, peer, ours, theirs, ratio, spread, converged, rounds, clock, wanted)

void write(const report& r, const std::string& path) {
    const nlohmann::json document{{"machine", r.on}, {"unit", "ns an item"}, {"rows", r.rows}};
    std::ofstream file(path);
    file << document.dump(2) << '\n';
    if (!file.flush()) throw std::runtime_error(path + ": cannot be written");
}

report read(const std::string& path) {
    try {
        const nlohmann::json document = nlohmann::json::parse(std::ifstream(path));
        return {document.at("machine").get<machine>(), document.at("rows").get<std::vector<result>>()};
    } catch (const nlohmann::json::exception& e) { throw std::runtime_error(path + ": " + e.what()); }
}

}  // namespace bench
