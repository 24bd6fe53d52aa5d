// SPDX-License-Identifier: MIT
#include <doctest/doctest.h>

#include "mutants.hpp"

TEST_CASE("mutants: every operator at every site, and nowhere else") {
    const auto all = mutation::mutants(R"(
// a comment: 1.0 < 2.0
#ifndef LIT
#define LIT(a, b) ((a) <= (b) ? 1.0 : 0.0)
#endif
HIGHP float floor(HIGHP float v, int n) {
    if (n < 8) return 1.5;  // 9
    vec2 o = vec2(1.0, v);
    return floor(o.x * 0.25) - (!(v > 0.0) ? v : -v);
}
)");
    std::string text;
    for (const auto& m : all) text += std::string(m.kind) + ": " + m.site + '\n';
    CHECK(text == R"(boundary: #define LIT(a, b) ((a) [<= -> <] (b) ? 1.0 : 0.0)
direction: #define LIT(a, b) ((a) [<= -> >=] (b) ? 1.0 : 0.0)
branches: #define LIT(a, b) ((a) <= (b) ? [1.0 : 0.0 -> 0.0 : 1.0])
ulp: #define LIT(a, b) ((a) <= (b) ? [1.0 -> 1.00000012] : 0.0)
unit: #define LIT(a, b) ((a) <= (b) ? [1.0 -> 2.0] : 0.0)
ulp: #define LIT(a, b) ((a) <= (b) ? 1.0 : [0.0 -> 1.17549435e-38])
unit: #define LIT(a, b) ((a) <= (b) ? 1.0 : [0.0 -> 1.0])
statement: [if (n < 8) return 1.5; -> ]
boundary: if (n [< -> <=] 8) return 1.5;
direction: if (n [< -> >] 8) return 1.5;
unit: if (n < [8 -> 9]) return 1.5;
ulp: if (n < 8) return [1.5 -> 1.50000012];
unit: if (n < 8) return [1.5 -> 2.5];
order: vec2 o = vec2([1.0, v -> v, 1.0]);
ulp: vec2 o = vec2([1.0 -> 1.00000012], v);
unit: vec2 o = vec2([1.0 -> 2.0], v);
call: return [floor(o.x * 0.25) -> (o.x * 0.25)] - (!(v > 0.0) ? v : -v);
channel: return floor(o.[x -> y] * 0.25) - (!(v > 0.0) ? v : -v);
channel: return floor(o.[x -> z] * 0.25) - (!(v > 0.0) ? v : -v);
channel: return floor(o.[x -> w] * 0.25) - (!(v > 0.0) ? v : -v);
arithmetic: return floor(o.x [* -> /] 0.25) - (!(v > 0.0) ? v : -v);
ulp: return floor(o.x * [0.25 -> 0.25000003]) - (!(v > 0.0) ? v : -v);
unit: return floor(o.x * [0.25 -> 1.25]) - (!(v > 0.0) ? v : -v);
sign: return floor(o.x * 0.25) [- -> +] (!(v > 0.0) ? v : -v);
sign: return floor(o.x * 0.25) - ([! -> ](v > 0.0) ? v : -v);
boundary: return floor(o.x * 0.25) - (!(v [> -> >=] 0.0) ? v : -v);
direction: return floor(o.x * 0.25) - (!(v [> -> <] 0.0) ? v : -v);
ulp: return floor(o.x * 0.25) - (!(v > [0.0 -> 1.17549435e-38]) ? v : -v);
unit: return floor(o.x * 0.25) - (!(v > [0.0 -> 1.0]) ? v : -v);
branches: return floor(o.x * 0.25) - (!(v > 0.0) ? [v : -v -> -v : v]);
sign: return floor(o.x * 0.25) - (!(v > 0.0) ? v : [- -> +]v);
)");
}
