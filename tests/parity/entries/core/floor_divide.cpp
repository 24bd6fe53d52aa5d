// SPDX-License-Identifier: MIT
#include <umbrage/core/floor_divide.hpp>

#include "../entries.hpp"

namespace parity {
namespace {

/// a in x0.x, b in x0.y, a quotient at most one off in x0.z; integers.
void draw_fraction(std::uint32_t a, std::uint32_t b, random& r, sample& s) {
    const float off = static_cast<float>(r.below(3)) - 1.0f;
    s.x[0] = {static_cast<float>(a), static_cast<float>(b), static_cast<float>(a / b) + off, 0.0f};
}
std::uint32_t some_divisor(random& r) { return 64 + (r.bits() >> 8 >> r.below(24)); }

std::vector<input_class> fractions() {
    return {{"random",
             [](auto, random& r, sample& s) {
                 const std::uint32_t b = some_divisor(r);
                 draw_fraction(r.bits() >> 8, b, r, s);
             }},
            {"whole quotients",
             [](std::uint64_t i, random& r, sample& s) {
                 const std::uint32_t b = some_divisor(r), a = (r.bits() >> 8) / b * b;
                 draw_fraction(i % 2 && a > 0 ? a - 1 : a, b, r, s);
             }},
            {"small divisors", [](std::uint64_t i, random& r, sample& s) {
                 const std::uint32_t b = 1 + static_cast<std::uint32_t>(i % 64);
                 const std::uint32_t a = (r.bits() >> 14) * b;
                 draw_fraction(a + static_cast<std::uint32_t>(r.below(static_cast<int>(b))), b, r, s);
             }}};
}

}  // namespace

void add_core_floor_divide(std::vector<entry>& all) {
    using namespace umbrage;
    all.push_back({.primitive = &glsl::correct_quotient,
                   .classes = fractions(),
                   .twin = [](const sample& s) { return vec4(correct_quotient(s.x[0].z, s.x[0].x, s.x[0].y)); },
                   .call = "vec4(umbrage_correct_quotient(x0.z, x0.x, x0.y))"});
    all.push_back({.primitive = &glsl::floor_divide,
                   .classes = fractions(),
                   .twin = [](const sample& s) { return vec4(floor_divide(s.x[0].x, s.x[0].y)); },
                   .call = "vec4(umbrage_floor_divide(x0.x, x0.y))"});
}

}  // namespace parity
