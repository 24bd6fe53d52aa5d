// SPDX-License-Identifier: MIT
#include "backend.hpp"

namespace parity {

job make_job(const entry& e, const texels* map, std::size_t first, std::size_t count, std::uint64_t serial) {
    job j;
    j.what = &e;
    j.map = map;
    j.count = count;
    j.serial = serial;
    for (int k = 0; k < max_inputs; ++k)
        if (e.uses(k)) j.x[static_cast<std::size_t>(k)].resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        sample s = j.at(i);
        s.x = {};
        random r((serial << 32) + i);
        e.classes[i % e.classes.size()].fill((first + i) / e.classes.size(), r, s);
        for (std::size_t k = 0; k < max_inputs; ++k)
            if (!j.x[k].empty()) j.x[k][i] = s.x[k];
    }
    return j;
}

}  // namespace parity
