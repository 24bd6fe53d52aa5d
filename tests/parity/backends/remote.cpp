// SPDX-License-Identifier: MIT
#include "remote.hpp"

#include "block.hpp"

namespace parity {

std::vector<vec4> remote::run(dialect d, const job& j, std::size_t count) {
    const std::string block = block_of(d, j, count, serial_ != j.serial);
    serial_ = j.serial;
    return results_of(j, count, program_.answer(block).data());
}

std::string remote::hello(dialect d) {
    return program_.answer(joined_parts({"{\"hello\": true, \"version\": " + web_version(d) + "}"}));
}

}  // namespace parity
