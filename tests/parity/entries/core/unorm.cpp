// SPDX-License-Identifier: MIT
#include <umbrage/core/unorm.hpp>

#include "../entries.hpp"

namespace parity {
namespace {

using namespace umbrage;

template <int Bits>
void add(std::vector<entry>& all, const glsl::snippet& to, const glsl::snippet& from) {
    const std::string write = "umbrage_" + std::string(to.name), read = "umbrage_" + std::string(from.name);
    const std::vector<input_class> codes{{"codes", [](std::uint64_t i, random& r, sample& s) {
                                              for (int c = 0; c < 4; ++c)
                                                  s.x[0][c] = static_cast<float>(r.below(1 << Bits));
                                              s.x[0].x = static_cast<float>(i % (1u << Bits));
                                          }}};
    const auto overloads = [](const std::string& f) {
        return "vec4(" + f + "(vec2(x0.x, x0.y)), " + f + "(vec3(x0.y, x0.z, x0.w)).z, " + f + "(x0.x))";
    };
    all.push_back({.primitive = &to,
                   .classes = codes,
                   .twin = [](const sample& s) { return to_unorm<Bits>(s.x[0]); },
                   .call = write + "(x0)"});
    all.push_back({.primitive = &to,
                   .variant = "overloads",
                   .classes = codes,
                   .twin =
                       [](const sample& s) {
                           const vec4 v = s.x[0];
                           return vec4(to_unorm<Bits>(vec2(v.x, v.y)), to_unorm<Bits>(vec3(v.y, v.z, v.w)).z,
                                       to_unorm<Bits>(v.x));
                       },
                   .call = overloads(write)});
    if constexpr (Bits == 8)
        all.push_back({.primitive = &to,
                       .variant = "8-bit target",
                       .classes = codes,
                       .twin = [](const sample& s) { return s.x[0]; },
                       .call = write + "(x0)",
                       .output = target::rgba8,
                       .bits = true});
    all.push_back({.primitive = &from,
                   .classes = channels(false, Bits),
                   .twin = [](const sample& s) { return from_unorm<Bits>(s.x[0]); },
                   .call = read + "(x0)"});
    all.push_back({.primitive = &from,
                   .variant = "overloads",
                   .classes = channels(false, Bits),
                   .twin =
                       [](const sample& s) {
                           const vec4 v = s.x[0];
                           return vec4(from_unorm<Bits>(vec2(v.x, v.y)), from_unorm<Bits>(vec3(v.y, v.z, v.w)).z,
                                       from_unorm<Bits>(v.x));
                       },
                   .call = overloads(read)});
}

}  // namespace

void add_core_unorm(std::vector<entry>& all) {
    add<8>(all, glsl::to_unorm, glsl::from_unorm);
    add<10>(all, glsl::to_unorm10, glsl::from_unorm10);
    add<16>(all, glsl::to_unorm16, glsl::from_unorm16);
}

}  // namespace parity
