// SPDX-License-Identifier: MIT
#include "expected.hpp"

#include <memory>

#include "arithmetic/trial.hpp"

namespace parity {

expectation expect(const job& j, const texels* flushed_map, bool may_reorder) {
    expectation all{{}, flushed_map};
    all.plain.reserve(j.count);
    for (std::size_t i = 0; i < j.count; ++i) all.plain.push_back(j.what->twin(j.at(i)));
    if (may_reorder)
        all.allows = [run = std::make_shared<arithmetic::caller>(j)](std::size_t i, const vec4& result) {
            return allows(*run, i, result);
        };
    return all;
}

}  // namespace parity
