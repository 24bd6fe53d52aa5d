// SPDX-License-Identifier: MIT
//
// An expression's value: as it is written, or as sums and products of its terms in an order that is drawn.
#include <algorithm>

#include "expressions.hpp"

namespace parity::arithmetic {

float expressions::written(std::uint32_t id) {
    const node n = nodes_[id];
    if (n.operation == times) return round().product(evaluate(n.a), evaluate(n.b));
    if (by_.fuses) {
        const std::uint32_t sides[] = {n.a, n.b};
        bool is_product[2];
        for (int k : {0, 1}) is_product[k] = nodes_[without_minus(sides[k])].operation == times;
        if (is_product[0] || is_product[1]) {
            ++out_.groupings;
            const int k = is_product[0] && is_product[1] ? draw_.below(2) : is_product[1];
            if (draw_.below(4) != 0) {
                ++out_.rewrites;
                bool negative = false;
                for (std::uint32_t at = sides[k]; nodes_[at].operation == minus; at = nodes_[at].a)
                    negative = !negative;
                const node p = nodes_[without_minus(sides[k])];
                const float a = evaluate(p.a), b = evaluate(p.b);
                return round().fused(negative ? -a : a, b, evaluate(sides[1 - k]));
            }
        }
    }
    return round().sum(evaluate(n.a), evaluate(n.b));
}
float expressions::regrouped(std::uint32_t id) {
    parts p;
    collect(id, false, p);
    const auto has_products = [](const term& t) { return t.factors.size() > 1; };
    const bool another = p.another || p.terms.size() > 2 || p.terms.front().factors.size() > 2 ||
                         (by_.fuses && p.terms.size() > 1 && std::any_of(p.terms.begin(), p.terms.end(), has_products));
    const float v = sum_of(p);
    out_.groupings += another;
    out_.rewrites += p.rewritten;
    return v;
}
void expressions::collect(std::uint32_t id, bool negative, parts& p) {
    const node n = nodes_[id];
    if (n.operation == minus) return collect(n.a, !negative, p);
    const bool kept = n.done && (n.operation == leaf || draw_.below(2));  // a variable's value, used again
    if (n.operation == plus && !kept && p.terms.size() < most_terms) {
        p.written.push_back({without_minus(n.a), without_minus(n.b), id});
        collect(n.a, negative, p);
        return collect(n.b, negative, p);
    }
    std::vector<std::uint32_t> ids;
    if (kept) ids.push_back(id);
    else factors(id, negative, ids, p);
    for (std::size_t i = 0; i < ids.size() && ids.size() > 1; ++i) {
        if (nodes_[ids[i]].operation != plus) continue;
        p.another = true;
        if (p.terms.size() >= most_terms || draw_.below(2)) continue;
        parts inner;  // a * (b + c) multiplied out
        collect(ids[i], negative, inner);
        ids.erase(ids.begin() + static_cast<std::ptrdiff_t>(i));
        for (term& t : inner.terms) {
            for (const std::uint32_t other : ids) t.factors.push_back({other, evaluate(other)});
            t.id = of_no_node;
            p.terms.push_back(std::move(t));
        }
        p.rewritten = true;
        return;
    }
    term t{{}, negative, id};
    for (const std::uint32_t f : ids) t.factors.push_back({f, evaluate(f)});
    p.terms.push_back(std::move(t));
}
void expressions::factors(std::uint32_t id, bool& negative, std::vector<std::uint32_t>& ids, parts& p) {
    const node n = nodes_[id];
    if (n.operation == minus) {
        negative = !negative;
        return factors(n.a, negative, ids, p);
    }
    if (n.operation != times || ids.size() > 8) return ids.push_back(id);
    p.written.push_back({without_minus(n.a), without_minus(n.b), id});
    factors(n.a, negative, ids, p);
    factors(n.b, negative, ids, p);
}
std::uint32_t expressions::joined(std::uint32_t a, std::uint32_t b, parts& p) const {
    for (const parts::pair& w : p.written)
        if ((w.a == a && w.b == b) || (w.a == b && w.b == a)) return w.whole;
    p.rewritten = true;
    return of_no_node;
}
float expressions::sum_of(parts& p) {
    std::vector<term>& terms = p.terms;
    if (terms.size() > 1 && draw_.below(2)) take_common_factor_out(p);
    while (terms.size() > 1) {
        std::swap(terms[drawn(terms)], terms.back());
        term last = std::move(terms.back());
        terms.pop_back();
        term& other = terms[drawn(terms)];
        const std::uint32_t whole = joined(last.id, other.id, p);
        if (by_.fuses && (last.factors.size() > 1 || other.factors.size() > 1) && draw_.below(4) != 0) {
            if (last.factors.size() == 1 || (other.factors.size() > 1 && draw_.below(2))) std::swap(last, other);
            p.rewritten = true;
            const float c = product_of(other, p);
            reduce(last, 2, p);
            const float a = last.factors[0].value, b = last.factors[1].value;
            other = evaluated(round().fused(last.negative ? -a : a, b, c), whole);
        } else {
            const float b = product_of(last, p), a = product_of(other, p);
            other = evaluated(round().sum(a, b), whole);
        }
    }
    return product_of(terms.front(), p);
}
void expressions::take_common_factor_out(parts& p) {
    for (std::size_t i = 0; i < p.terms.size(); ++i)
        for (std::size_t j = i + 1; j < p.terms.size(); ++j)
            for (const factor common : p.terms[i].factors) {
                if (common.id == of_no_node) continue;
                const auto is_common = [&](const factor& f) { return f.id != of_no_node && is_same(f.id, common.id); };
                parts inner{{p.terms[i], p.terms[j]}, {}};
                if (inner.terms[0].factors.size() < 2 || inner.terms[1].factors.size() < 2) continue;
                const auto find_common = [&](term& t) {
                    return std::find_if(t.factors.begin(), t.factors.end(), is_common);
                };
                if (find_common(inner.terms[1]) == inner.terms[1].factors.end()) continue;
                for (term& t : inner.terms) t.factors.erase(find_common(t));
                const float rest = sum_of(inner);
                p.terms[i] = {{common, {of_no_node, rest}}};
                p.terms.erase(p.terms.begin() + static_cast<std::ptrdiff_t>(j));
                p.rewritten = p.another = true;
                return;
            }
}
float expressions::product_of(term& t, parts& p) {
    reduce(t, 1, p);
    return t.negative ? -t.factors[0].value : t.factors[0].value;
}
void expressions::reduce(term& t, std::size_t left, parts& p) {
    while (t.factors.size() > left) {
        std::swap(t.factors[drawn(t.factors)], t.factors.back());
        const factor last = t.factors.back();
        t.factors.pop_back();
        factor& other = t.factors[drawn(t.factors)];
        other = {joined(last.id, other.id, p), round().product(last.value, other.value)};
    }
}

}  // namespace parity::arithmetic
