// SPDX-License-Identifier: MIT
//
// Functions of moments of depth, in C++: their numbers are measured, and each slip is named.
#include <doctest/doctest.h>

#include <algorithm>
#include <functional>

#include <umbrage/filter/prefiltered/vsm.hpp>

#include "../moments/bound_model.hpp"
#include "investigation.hpp"

using namespace check;
using glm::vec2;

namespace {

verdict of_bound(const std::function<float(vec2 moments, float receiver)>& f) {
    investigation question(subject::bound);
    while (const auto b = question.next()) {
        std::vector<glm::vec4> outputs;
        for (std::size_t i = 0; i < b->inputs.size(); ++i)
            outputs.push_back({f({b->map[i], b->second[i]}, b->inputs[i].z), 0, 0, 0});
        question.answer(outputs);
    }
    return question.result();
}

}  // namespace

TEST_CASE("bounds: the library's own has its bits, and its numbers") {
    const verdict plain = of_bound([](vec2 m, float z) { return umbrage::decode_vsm(m, z, 1e-6f); });
    CHECK(plain.how == agreement::same_bits);
    CHECK(plain.function == "chebyshev(1e-06)");
    const verdict reduced = of_bound(
        [](vec2 m, float z) { return umbrage::reduce_light_bleeding(umbrage::decode_vsm(m, z, 3e-5f), 0.2f); });
    CHECK(reduced.how == agreement::same_bits);
    CHECK(reduced.function == "chebyshev(3e-05), reduce_light_bleeding(0.2)");
}

TEST_CASE("bounds: slips, up to four at once") {
    for (second_channel second : second_channels)
        for (int bits = 0; bits < 16; ++bits) {
            bound_model planted{second, (bits & 1) != 0,     (bits & 2) != 0, (bits & 4) == 0, 2e-5,
                                0.1,    (bits & 8) ? 0.9 : 1};
            if (planted.reversed && !planted.one_sided) continue;  // without a comparison nothing is reversed
            const verdict v = of_bound([&](vec2 m, float z) { return static_cast<float>(planted(m, z)); });
            CAPTURE(text(v));
            CHECK(v.function == planted.name());
            const auto expected = planted.slips();
            CHECK(std::ranges::equal(v.slips, expected, {}, &finding::says, &finding::says));
        }
}

TEST_CASE("bounds: none where a function is none") {
    const verdict v = of_bound([](vec2 m, float z) { return z <= m.x ? 1.0f : m.y; });
    CHECK(v.how == agreement::unknown);
    CHECK(text(v).find("no bound of Chebyshev's") != std::string::npos);
}
