// SPDX-License-Identifier: MIT
#include "processor.hpp"

#include <fstream>
#include <map>

namespace example {

std::string processor() {
    std::map<std::string, std::string> fields;  // fields of the first processor
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line) && !line.empty();) {
        const std::size_t colon = line.find(':');
        if (colon == std::string::npos) continue;
        const std::size_t end = line.find_last_not_of(" \t", colon - 1) + 1,
                          value = line.find_first_not_of(' ', colon + 1);
        fields[line.substr(0, end)] = value == std::string::npos ? "" : line.substr(value);
    }
    if (fields.contains("model name"))
        return fields["model name"] + ", family " + fields["cpu family"] + ", model " + fields["model"];
    if (fields.contains("CPU part"))
        return "ARM implementer " + fields["CPU implementer"] + ", part " + fields["CPU part"];
    return "an unknown processor";
}

}  // namespace example
