// SPDX-License-Identifier: MIT
#include "compare.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>

namespace parity {
namespace {

bool same_bits(float a, float b) {
    return umbrage::detail::bit_cast<std::uint32_t>(a) == umbrage::detail::bit_cast<std::uint32_t>(b) ||
           (std::isnan(a) && std::isnan(b));
}

bool zeros(float a, float b) { return a == 0.0f && b == 0.0f; }

std::int64_t ordered(float v) {
    const auto bits = umbrage::detail::bit_cast<std::int32_t>(v);
    return bits < 0 ? -static_cast<std::int64_t>(bits & 0x7FFFFFFF) : bits;
}

void print(std::ostream& log, const char* name, vec4 v) {
    log << "    " << name << std::hexfloat;
    for (int c = 0; c < 4; ++c) log << "  " << v[c];
    log << std::defaultfloat << std::setprecision(9) << "   (" << v.x << ", " << v.y << ", " << v.z << ", " << v.w
        << ")\n";
}

}  // namespace

std::int64_t ulp_distance(float a, float b) {
    if (std::isnan(a) || std::isnan(b))
        return std::isnan(a) && std::isnan(b) ? 0 : std::numeric_limits<std::int64_t>::max();
    return std::abs(ordered(a) - ordered(b));
}

float flush(float v) { return std::fpclassify(v) == FP_SUBNORMAL ? std::copysign(0.0f, v) : v; }
vec4 flush(vec4 v) { return {flush(v.x), flush(v.y), flush(v.z), flush(v.w)}; }
texels flush(texels map) {
    for (vec4& t : map.texels()) t = flush(t);
    return map;
}

void compare(const job& j, const expectation& expected, const std::vector<vec4>& got, tally& t, std::ostream& log) {
    const entry& e = *j.what;
    const bool near = e.primitive->exactness == tier::c;
    for (std::size_t i = 0; i < got.size(); ++i) {
        const vec4 want = expected.plain[i], is = got[i];
        bool same = true;
        for (int c = 0; c < 4; ++c) same = same && same_bits(want[c], is[c]);
        if (same) {
            ++t.identical;
            continue;
        }

        sample s = j.at(i);
        std::array<vec4, 4> accepted{want, want, want, want};
        if (!e.bits) {
            for (vec4& x : s.x) x = flush(x);
            if (expected.flushed_map) s.map = expected.flushed_map->view();
            accepted[1] = flush(want);
            accepted[2] = e.twin(s);
            accepted[3] = flush(accepted[2]);
        }
        bool good = true;
        for (int c = 0; c < 4; ++c) {
            bool bits = false;
            auto ulp = std::numeric_limits<std::int64_t>::max();
            float distance = std::numeric_limits<float>::infinity();
            for (const vec4& a : accepted) {
                bits = bits || same_bits(a[c], is[c]) || (!e.bits && zeros(a[c], is[c]));
                ulp = std::min(ulp, ulp_distance(a[c], is[c]));
                distance = std::fmin(distance, std::abs(a[c] - is[c]));
            }
            const float within = e.primitive->within;
            if (within > 0.0f) t.worst_distance = std::max(t.worst_distance, bits ? 0.0f : distance);
            else if (near) t.worst_ulp = std::max(t.worst_ulp, ulp);
            good = good && (within > 0.0f ? bits || distance <= within : near ? ulp <= 1 : bits);
        }
        if (good) {
            if (!near) ++t.flushed;
            continue;
        }
        if (expected.allows && expected.allows(i, is)) {
            ++t.bounded;
            continue;
        }
        if (t.different++ >= 3) continue;
        s = j.at(i);
        log << "  differs: " << e.name() << ", input " << i << " of class " << j.classes[i % j.classes.size()]->name
            << '\n';
        for (int k = 0; k < max_inputs; ++k)
            if (e.uses(k)) print(log, ("x" + std::to_string(k) + "   ").c_str(), s.x[static_cast<std::size_t>(k)]);
        if (j.map) log << "    map   " << j.map->size().x << " x " << j.map->size().y << '\n';
        print(log, "C++   ", want);
        print(log, "shader ", is);
    }
    const std::size_t kinds = j.classes.size();
    for (std::size_t k = 0; k < kinds; ++k)
        t.inputs[j.classes[k]->name] += got.size() / kinds + (k < got.size() % kinds ? 1 : 0);
    t.total += got.size();
}

}  // namespace parity
