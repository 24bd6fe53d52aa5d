// SPDX-License-Identifier: MIT
#include "trial.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <umbrage/core/snippet.hpp>

#include "../backends/cpp_text.hpp"

namespace parity::arithmetic {
namespace {

using umbrage::glsl::snippet;

template <class Use>
void each_snippet(const snippet& s, const Use& use) {
    use(s);
    for (const snippet* needed : s.needs) each_snippet(*needed, use);
}

/// True for results that are corrected after a floor on either side. Their exactness does not need a margin.
bool corrects_its_floors(const entry& e) {
    bool found = false;
    for (const snippet& s : e.snippets())
        each_snippet(
            s, [&](const snippet& one) { found = found || one.name == "floor_divide" || one.name == "overlay_texel"; });
    return found;
}

/// True when a result keeps the entry's promise in any arithmetic: a visibility is in [0, 1], or off by its bound.
bool is_in_range(const entry& e, float v, const call& got, const promise& p) {
    if (!e.bound.empty() || !is_visibility(e)) return true;
    const outcome& o = got.what;
    const double off = p.within > 0.0 || o.unbounded || o.out_of_range ? 0.0 : got.results[0].bound();
    return v >= -off && v <= 1.0 + off;
}

bool is_same(float a, float b) { return a == b || (std::isnan(a) && std::isnan(b)); }

std::string described(const job& j, std::size_t i, const call& got, const vec4& twin) {
    std::ostringstream text;
    text << "input " << i << " of class " << j.classes[i % j.classes.size()]->name << std::hexfloat;
    const sample s = j.at(i);
    for (int k = 0; k < max_inputs; ++k)
        if (j.what->uses(k)) {
            text << "\n      x" << k << ' ';
            for (int c = 0; c < 4; ++c) text << ' ' << s.x[std::size_t(k)][c];
        }
    for (int c = 0; c < 4; ++c) {
        const knowledge& r = got.results[std::size_t(c)];
        text << std::hexfloat << "\n      " << r.value << ", C++ " << twin[c] << std::defaultfloat << ", real "
             << r.real << ", n " << r.operations << ", S " << r.magnitude << (r.exact ? ", exact" : "");
    }
    return text.str();
}

}  // namespace

bool is_visibility(const entry& e) {
    const std::string text = e.primitive->source.str();
    const std::size_t head = text.find("// umbrage_" + std::string(e.primitive->name) + ":");
    if (head == std::string::npos) return false;
    const std::string line = text.substr(head, text.find('\n', head) - head);
    return line.find("1.0 is lit") != std::string::npos || line.find("visibility of") != std::string::npos;
}

promise promise_of(const entry& e, const rules& by) {
    promise p{.exactness = e.exactness()};
    for (const snippet& s : e.snippets())
        each_snippet(s, [&](const snippet& one) {
            p.within = std::max(p.within, double(one.within));
            p.as_written = p.as_written || one.as_written;
        });
    if (e.snippets().size() == 1 && e.exactness() == e.primitive->exactness && !by.reads_halves)
        p.operations = e.primitive->operations;
    if (by.sub_texel_bits > 0 && e.primitive->within == 1.0f / 128.0f)
        p.within = std::ldexp(1.0, 1 - by.sub_texel_bits);
    return p;
}

caller::caller(const job& j) : job_(j), textures_(textures(j)) {
    for (const filled_texture& t : textures_) by_unit_[t.unit] = &t;
}

call caller::operator()(std::size_t input, const rules& by, std::uint64_t seed) const {
    const entry& e = *job_.what;
    begin(by, seed);
    auto result =
        glsl_as_numbers::functions.at(static_cast<std::size_t>(&e - entries().data()))(job_.at(input), by_unit_.data());
    call all;
    for (int c = 0; c < 4; ++c) {
        if (e.output == target::rgba8)
            result[c] = stored(result[c], input % 2 ? unorm_store::truncates : unorm_store::rounds);
        all.results[std::size_t(c)] = known(result[c]);
        all.passed_on[std::size_t(c)] = is_argument(result[c]);
    }
    all.what = parity::arithmetic::result();
    return all;
}

void count::add(const count& o) {
    for (auto member : {&count::inputs, &count::identical, &count::broken, &count::in_bound, &count::denormal,
                        &count::not_finite, &count::out_of_range, &count::unbounded, &count::either_side,
                        &count::unproven, &count::no_visibility, &count::groupings, &count::rewrites})
        this->*member += o.*member;
    for (auto member : {&count::operations, &count::worst_share, &count::worst_difference})
        this->*member = std::max(this->*member, o.*member);
}

bool allows(const caller& run, std::size_t input, const vec4& result) {
    const entry& e = *run.inputs().what;
    if (e.exactness() == tier::a) return false;
    const promise p = promise_of(e, {});
    constexpr int seeds = 32;  // enough for what is decided within its bound to be decided both ways
    for (const setting& in : {arithmetics[0], fused_and_rounded})
        for (int seed = 0; seed < (in.by.fuses ? seeds : 1); ++seed) {
            const call got = run(input, in.by, std::uint64_t(seed));
            const outcome& o = got.what;
            if (o.not_finite) return true;
            if (!is_in_range(e, result.x, got, p)) continue;
            if (p.as_written || o.unbounded || o.out_of_range) return true;
            bool near = true;
            for (int c = 0; c < 4; ++c) {
                const knowledge& r = got.results[std::size_t(c)];
                near = near && std::abs(double(result[c]) - r.real) <=
                                   std::max(r.bound(), p.within * std::max(1.0, std::abs(r.real)));
            }
            if (near) return true;
        }
    return false;
}

count try_entry(const entry& e, const rules& by, std::size_t inputs, const promise& p) {
    count all;
    const bool corrects = corrects_its_floors(e);
    const std::size_t maps = std::max<std::size_t>(1, e.maps.size());
    for (std::size_t m = 0; m < maps; ++m) {
        const job j = make_job(e, e.maps.empty() ? nullptr : &e.maps[m], 0, std::max<std::size_t>(inputs / maps, 1), m);
        const caller run(j);
        for (std::size_t i = 0; i < j.count; ++i) {
            const call got = run(i, by, all.inputs++);
            const outcome& o = got.what;
            const vec4 twin = e.twin(j.at(i));
            all.groupings += o.groupings, all.rewrites += o.rewrites;
            const bool may_be_nan = o.not_finite && by.assumes_finite && p.exactness != tier::a;
            all.no_visibility += !may_be_nan && !is_in_range(e, got.value(0), got, p);
            const bool flushes = by.flushes_inputs || by.flushes_results;
            bool same = true, in_bound = true, exact = true;
            double share = 0.0;  // share of the bound
            for (int c = 0; c < 4; ++c) {
                const knowledge& r = got.results[std::size_t(c)];
                const double difference = std::abs(double(r.value) - double(twin[c])),
                             off = std::abs(double(r.value) - r.real);
                const bool as_it_came = got.passed_on[std::size_t(c)] && difference <= r.bound();
                same = same && (is_same(r.value, twin[c]) || as_it_came);
                exact = exact && (r.exact || !std::isfinite(r.real) || got.passed_on[std::size_t(c)]);
                if (!std::isfinite(r.real)) continue;
                const bool follows = p.within > 0.0 && o.either_side == 0;  // C++'s decisions
                const double within = p.within * std::max(1.0, std::abs(r.real));
                in_bound = in_bound && (p.within > 0.0 ? (follows ? difference : off) <= within * p.share
                                                       : off <= r.bound() * p.share);
                if (o.denormal || o.not_finite || o.out_of_range || (o.unbounded && p.within == 0.0)) continue;
                all.operations = std::max(all.operations, r.exact ? 0.0 : r.operations);
                if (o.either_side == 0) all.worst_difference = std::max(all.worst_difference, difference);
                if (p.within > 0.0) share = std::max(share, (follows ? difference : off) / within);
                else if (r.bound() > 0.0) share = std::max(share, off / r.bound());
            }
            const bool plain = !o.denormal && !o.not_finite;
            if (plain && !o.out_of_range && !o.unbounded) all.operations = std::max(all.operations, o.operations);
            if (plain && p.exactness == tier::a) {
                if (!exact || (o.unproven > 0 && !corrects)) ++all.unproven;
                if (o.least_margin < all.least_margin && !corrects)
                    all.least_margin = o.least_margin, all.margin = o.margin, all.error = o.error;
            }
            const bool keeps_no_order = by.fuses || by.reorders || by.rounding != rules::nearest;
            const bool in_written_order = !keeps_no_order && !flushes && !by.is_inaccurate && !by.assumes_finite &&
                                          !by.reads_beside && !by.reads_halves && !by.stores_either &&
                                          by.sub_texel_bits == 0;
            bool broken = false;
            if (same) {
                ++all.identical;
                continue;
            }
            if (!p.as_written || !keeps_no_order) all.worst_share = std::max(all.worst_share, share);
            if (o.not_finite && by.assumes_finite) ++all.not_finite;
            else if (o.denormal && flushes) ++all.denormal;
            else if (p.exactness == tier::a && o.reads_decided > 0) ++all.either_side;
            else if (p.exactness == tier::a) broken = true;
            else if (p.exactness == tier::b && in_written_order) broken = true;
            else if (o.not_finite) ++all.not_finite;
            else if (o.out_of_range) ++all.out_of_range;
            else if ((o.unbounded && p.within == 0.0) || (p.as_written && keeps_no_order)) ++all.unbounded;
            else if (!in_bound || (p.within == 0.0 && o.out_of_bound > 0)) broken = true;
            else ++(o.either_side ? all.either_side : all.in_bound);
            if (!broken) continue;
            if (all.broken++ == 0) all.example = described(j, i, got, twin);
        }
    }
    return all;
}

}  // namespace parity::arithmetic
