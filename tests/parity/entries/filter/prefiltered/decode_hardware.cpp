// SPDX-License-Identifier: MIT
#include <umbrage/filter/prefiltered/decode_hardware.hpp>

#include "windows.hpp"

namespace parity {
namespace {

using namespace umbrage;

/// Receivers of any kind over moments of depths.
input_class any_receiver(const input_class& of) {
    return {"any receiver", [fill = of.fill](std::uint64_t i, random& r, sample& s) {
                fill(i, r, s);
                const float inf = std::numeric_limits<float>::infinity();
                const float kinds[]{inf, -inf, std::numeric_limits<float>::quiet_NaN(), 0.0f, 1.0f, -1.0f, 1e5f, -1e9f};
                s.x[1].x = kinds[i % std::size(kinds)];
            }};
}

}  // namespace

void add_filter_prefiltered_decode_hardware(std::vector<entry>& all) {
    const range exponent{1.0f, 54.0f}, deviation{0.005f, 0.02f}, least{1e-7f, 0.01f};
    all.push_back({.primitive = &glsl::chebyshev_hardware,
                   .classes = {{"random",
                                [](auto i, random& r, sample& s) {
                                    const float part = r.unit(), variance = std::ldexp(part + 1.0f, -r.below(24));
                                    const float steps = i % 8 == 0 ? 0.0f : r.between(-1.0f, 4.0f);
                                    s.x[0] = {variance, steps * std::sqrt(variance), r.unit() * 0.5f, 0.0f};
                                }}},
                   .twin = [](const sample& s) { return vec4(chebyshev_hardware(s.x[0].x, s.x[0].y, s.x[0].z)); },
                   .call = "vec4(umbrage_chebyshev_hardware(x0.x, x0.y, x0.z))"});
    const input_class held = windows([](float d, sample&) { return vec4(d, d * d, 0.0f, 0.0f); }, {least});
    const input_class deviations{"windows", [held](std::uint64_t i, random& r, sample& s) {
                                     held.fill(i, r, s);
                                     const vec2 stored = encode_deviation(vec2(s.x[0]));
                                     s.x[0] = {stored.x, stored.y, r.unit() * 0.5f, 0.0f};
                                     if (i % 2 == 0) s.x[1].y = std::ldexp(1.0f, -r.below(24));
                                 }};
    add_both(all,
             {.primitive = &glsl::decode_vsm_hardware,
              .classes = {deviations, any_receiver(deviations)},
              .call = "vec4(umbrage_decode_vsm_hardware(vec2(x0.x, x0.y), x1.x, x1.y, x0.z))"},
             [](const sample& s, float far) {
                 return vec4(decode_vsm_hardware(vec2(s.x[0]), s.x[1].x, s.x[1].y, s.x[0].z, far));
             });
    const auto exponents = [](const sample& s) { return vec2(s.x[1].y, s.x[1].z); };
    const input_class powers = windows([exponents](float d, sample& s) { return encode_evsm4(d, exponents(s)); },
                                       {exponent, exponent, deviation, deviation, {0.0f, 0.3f}});
    add_both(all,
             {.primitive = &glsl::decode_evsm2_hardware,
              .classes = {powers, any_receiver(powers)},
              .call = "vec4(umbrage_decode_evsm2_hardware(vec2(x0.x, x0.y), x1.x, x1.y, x1.w, x2.y))"},
             [](const sample& s, float far) {
                 return vec4(decode_evsm2_hardware(vec2(s.x[0]), s.x[1].x, s.x[1].y, s.x[1].w, s.x[2].y, far));
             });
    add_both(all,
             {.primitive = &glsl::decode_evsm4_hardware,
              .classes = {powers, any_receiver(powers)},
              .call = "vec4(umbrage_decode_evsm4_hardware(x0, x1.x, vec2(x1.y, x1.z), vec2(x1.w, x2.x), x2.y))"},
             [exponents](const sample& s, float far) {
                 const vec2 least_of_both(s.x[1].w, s.x[2].x);
                 return vec4(decode_evsm4_hardware(s.x[0], s.x[1].x, exponents(s), least_of_both, s.x[2].y, far));
             });
}

}  // namespace parity
