// SPDX-License-Identifier: MIT
#include "number.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "rounding.hpp"

namespace parity::arithmetic {

namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();
}

/// The numbers of one call, as nodes of their expressions.
class expressions {
public:
    void begin(const rules& by, std::uint64_t seed) {
        by_ = by;
        draw_ = random(seed);
        nodes_.clear();
        nodes_.reserve(1024);
        out_ = {};
    }
    [[nodiscard]] const rules& by() const { return by_; }
    [[nodiscard]] const outcome& out() const { return out_; }
    [[nodiscard]] outcome& out() { return out_; }
    [[nodiscard]] random& draw() { return draw_; }
    [[nodiscard]] rounding round() { return {by_, draw_}; }

    /// A literal of the text, or a value that is exact.
    enum origins : std::uint8_t { computed, literal, argument };
    [[nodiscard]] number exact(float v, origins from = computed) {
        node n{.value = v, .done = true, .known = {v, v, magnitude(v), 0.0, std::isfinite(v), true}};
        n.quanta = std::abs(double(v));
        n.quantum = quantum_of(v);
        n.term[0] = v;
        n.least = v == 0.0f ? 1.0 : std::min(1.0, std::abs(double(v)));
        n.from = from;
        return add(n);
    }
    [[nodiscard]] bool is_argument(number v) const { return at(v).from == argument; }
    [[nodiscard]] bool is_literal(number v) const { return at(v).from == literal; }
    [[nodiscard]] number inexact(knowledge of, origins from = computed) {
        node n{.value = of.value, .done = true, .from = from, .known = of};
        return add(n);
    }
    [[nodiscard]] number negated(number a) {
        node n = at(a);
        n.operation = minus, n.a = a.node_, n.done = false, n.from = computed;
        n.known.real = -n.known.real;
        for (double& t : n.term) t = -t;
        return add(n);
    }
    [[nodiscard]] number sum(number a, number b) {
        const node &x = at(a), &y = at(b);
        node n{.operation = plus, .a = a.node_, .b = b.node_};
        n.terms = x.terms && y.terms && x.terms + y.terms <= most_listed ? x.terms + y.terms : 0;
        if (n.terms) std::copy_n(y.term.begin(), y.terms, std::copy_n(x.term.begin(), x.terms, n.term.begin()));
        n.known = {0.0f, x.known.real + y.known.real, x.known.magnitude + y.known.magnitude,
                   x.known.operations + y.known.operations + 1.0};
        n.least = std::min(x.least, y.least), n.factors = std::max(x.factors, y.factors);
        n.quanta = x.quanta + y.quanta;
        n.quantum = std::min(x.quantum, y.quantum);
        n.known.keeps_sign = x.known.keeps_sign && y.known.keeps_sign && x.known.real * y.known.real >= 0.0;
        return add(checked(n, x, y));
    }
    [[nodiscard]] number product(number a, number b) {
        const node &x = at(a), &y = at(b);
        node n{.operation = times, .a = a.node_, .b = b.node_};
        n.known = {0.0f, x.known.real * y.known.real, std::max(x.known.magnitude * y.known.magnitude, least_magnitude),
                   x.known.operations + y.known.operations + 1.0};
        n.terms = x.terms * y.terms <= most_listed ? x.terms * y.terms : 0;
        for (int i = 0; i < n.terms; ++i)
            n.term[std::size_t(i)] = x.term[std::size_t(i % x.terms)] * y.term[std::size_t(i / x.terms)];
        n.least = x.least * y.least, n.factors = x.factors + y.factors;
        n.quanta = x.quanta * y.quanta;
        n.quantum = x.quantum + y.quantum;
        n.known.keeps_sign = x.known.keeps_sign && y.known.keeps_sign;
        return add(checked(n, x, y));
    }

    /// By the rules; what is beyond its bound is counted.
    float evaluate(std::uint32_t id) {
        if (nodes_[id].from == argument) {
            const float v = nodes_[id].value;
            if (!std::isfinite(v)) out_.not_finite = true;
            if (std::fpclassify(v) == FP_SUBNORMAL) out_.denormal = true;
        } else if (!nodes_[id].done) {
            const float v = nodes_[id].operation == minus ? -evaluate(nodes_[id].a)
                            : by_.reorders                ? regrouped(id)
                                                          : written(id);
            node& n = nodes_[id];
            n.value = n.known.value = v, n.done = true;
            if (n.known.magnitude == infinity) out_.unbounded = true;
            else if (!std::isfinite(v) || n.known.magnitude > double(std::numeric_limits<float>::max()))
                out_.out_of_range = true;
            else if (!(std::abs(double(v) - n.known.real) <= n.known.bound())) ++out_.out_of_bound;
        }
        return nodes_[id].value;
    }
    [[nodiscard]] float value(number v) { return round().operand(evaluate(v.node_)); }
    [[nodiscard]] const knowledge& knowledge_of(number v) {
        evaluate(v.node_);
        return at(v).known;
    }

    /// Something is decided about a number; `margin` from it, it would be decided otherwise.
    void decide(double margin, double bound, double operations, bool as_in_reals) {
        if (!as_in_reals) ++out_.either_side;
        if (bound == 0.0) return;
        out_.operations = std::max(out_.operations, operations);
        if (margin <= bound) ++out_.unproven;
        if (margin / bound >= out_.least_margin) return;
        out_.least_margin = margin / bound, out_.margin = margin, out_.error = bound;
    }

private:
    enum kinds : std::uint8_t { leaf, minus, plus, times };
    static constexpr int most_listed = 5;
    struct node {
        kinds operation = leaf;
        std::uint32_t a = 0, b = 0;
        float value = 0.0f;
        bool done = false;
        origins from = computed;
        knowledge known{};
        double quanta = 0.0;  ///< S without a least magnitude
        int quantum = 0;      ///< exponent of what every value of the expression is a multiple of
        int terms = 1;        ///< multiplied out; 0: more than most_listed
        std::array<double, most_listed> term{};
        double least = 1.0;  ///< no partial product of a term is below
        int factors = 1;
    };
    static constexpr std::uint32_t of_no_node = ~0u;
    struct factor {
        std::uint32_t id;
        float value;
    };
    /// A product of an expression, and the node that it is.
    struct term {
        std::vector<factor> factors;
        bool negative = false;
        std::uint32_t id = of_no_node;
    };
    /// An expression taken apart, with what it joined.
    struct parts {
        struct pair {
            std::uint32_t a, b, whole;
        };
        std::vector<term> terms;
        std::vector<pair> written;
        bool another = false, rewritten = false;  ///< has, and was evaluated in, another grouping
    };
    static constexpr int no_quantum = 1 << 20;  // zero's, a multiple of anything
    static constexpr std::size_t most_terms = 24;

    [[nodiscard]] static double magnitude(double v) { return std::max(std::abs(v), least_magnitude); }
    [[nodiscard]] static int quantum_of(float v) {
        if (v == 0.0f || !std::isfinite(v)) return no_quantum;
        int exponent = 0;
        const auto digits = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::abs(v), &exponent), 24));
        return exponent - 24 + std::countr_zero(digits);
    }
    /// With `exact`: all partial results are multiples of the quantum, and none is above 2^24 of it. Of a few terms,
    /// each that any grouping can have is looked at.
    [[nodiscard]] static node checked(node n, const node& x, const node& y) {
        n.quantum = std::min(n.quantum, no_quantum);
        n.known.exact =
            x.known.exact && y.known.exact && (n.factors <= 2 || n.least >= 0x1p-126) &&
            (n.quanta == 0.0 || (n.quantum >= -126 && n.quanta <= std::ldexp(1.0, std::min(n.quantum + 24, 127))) ||
             has_exact_parts(n));
        return n;
    }
    [[nodiscard]] static bool has_exact_parts(const node& n) {
        if (n.terms == 0 || n.quanta > 0x1p127 || n.quanta > std::ldexp(1.0, n.quantum + 60)) return false;
        for (int chosen = 1; chosen < 1 << n.terms; ++chosen) {
            std::int64_t sum = 0;
            for (int i = 0; i < n.terms; ++i)
                if (chosen >> i & 1) sum += static_cast<std::int64_t>(std::ldexp(n.term[std::size_t(i)], -n.quantum));
            const auto digits = static_cast<std::uint64_t>(std::abs(sum));
            if (digits == 0) continue;
            if (digits >> std::countr_zero(digits) >= std::uint64_t(1) << 24) return false;
            if (static_cast<int>(std::bit_width(digits)) + n.quantum <= -126) return false;  // a denormal
        }
        return true;
    }
    [[nodiscard]] bool is_same(std::uint32_t a, std::uint32_t b) const {
        const node &x = nodes_[a], &y = nodes_[b];
        return a == b || (x.from == literal && y.from == literal && x.value == y.value);
    }
    [[nodiscard]] const node& at(number v) const { return nodes_[v.node_]; }
    [[nodiscard]] number add(const node& n) {
        number v;
        v.node_ = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back(n);
        return v;
    }
    [[nodiscard]] std::uint32_t without_minus(std::uint32_t id) const {
        while (nodes_[id].operation == minus) id = nodes_[id].a;
        return id;
    }

    /// As it is written; a product may be fused into the sum it is in.
    float written(std::uint32_t id) {
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

    /// As sums and products in an order that is drawn.
    float regrouped(std::uint32_t id) {
        parts p;
        collect(id, false, p);
        const auto has_products = [](const term& t) { return t.factors.size() > 1; };
        const bool another = p.another || p.terms.size() > 2 || p.terms.front().factors.size() > 2 ||
                             (by_.fuses && p.terms.size() > 1 && std::ranges::any_of(p.terms, has_products));
        const float v = sum_of(p);
        out_.groupings += another;
        out_.rewrites += p.rewritten;
        return v;
    }
    void collect(std::uint32_t id, bool negative, parts& p) {
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
    void factors(std::uint32_t id, bool& negative, std::vector<std::uint32_t>& ids, parts& p) {
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
    /// The node that two nodes make where the text joins them.
    [[nodiscard]] std::uint32_t joined(std::uint32_t a, std::uint32_t b, parts& p) const {
        for (const parts::pair& w : p.written)
            if ((w.a == a && w.b == b) || (w.a == b && w.b == a)) return w.whole;
        p.rewritten = true;
        return of_no_node;
    }

    float sum_of(parts& p) {
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
    /// a * b + a * c becomes a * (b + c).
    void take_common_factor_out(parts& p) {
        for (std::size_t i = 0; i < p.terms.size(); ++i)
            for (std::size_t j = i + 1; j < p.terms.size(); ++j)
                for (const factor common : p.terms[i].factors) {
                    if (common.id == of_no_node) continue;
                    const auto is_common = [&](const factor& f) {
                        return f.id != of_no_node && is_same(f.id, common.id);
                    };
                    parts inner{{p.terms[i], p.terms[j]}, {}};
                    if (inner.terms[0].factors.size() < 2 || inner.terms[1].factors.size() < 2) continue;
                    if (std::ranges::none_of(inner.terms[1].factors, is_common)) continue;
                    for (term& t : inner.terms) t.factors.erase(std::ranges::find_if(t.factors, is_common));
                    const float rest = sum_of(inner);
                    p.terms[i] = {{common, {of_no_node, rest}}};
                    p.terms.erase(p.terms.begin() + static_cast<std::ptrdiff_t>(j));
                    p.rewritten = p.another = true;
                    return;
                }
    }
    float product_of(term& t, parts& p) {
        reduce(t, 1, p);
        return t.negative ? -t.factors[0].value : t.factors[0].value;
    }
    /// Multiplies factors until so many are left.
    void reduce(term& t, std::size_t left, parts& p) {
        while (t.factors.size() > left) {
            std::swap(t.factors[drawn(t.factors)], t.factors.back());
            const factor last = t.factors.back();
            t.factors.pop_back();
            factor& other = t.factors[drawn(t.factors)];
            other = {joined(last.id, other.id, p), round().product(last.value, other.value)};
        }
    }
    [[nodiscard]] static term evaluated(float v, std::uint32_t id) { return {{{id, v}}, false, id}; }
    template <class All>
    [[nodiscard]] std::size_t drawn(const All& all) {
        return static_cast<std::size_t>(draw_.below(static_cast<int>(all.size())));
    }

    rules by_{};
    random draw_{0};
    std::vector<node> nodes_;
    outcome out_{};
};

namespace {

expressions all;

/// A function's result: its value, its real value, and its error as n and S.
number inexact(float value, double real, double magnitude, double operations) {
    if (!std::isfinite(real) || !std::isfinite(value)) all.out().out_of_range = true;
    if (!std::isfinite(magnitude)) all.out().unbounded = true;
    return all.inexact({value, real, std::max(magnitude, least_magnitude), operations});
}

template <class Whole>
number whole(number v, Whole to) {
    const auto value = static_cast<float>(to(double(v.value())));
    const knowledge k = known(v);
    const double real = k.real, next = std::round(real);
    // no rounding makes a positive number negative: it stays on its side of zero
    const double margin =
        next == 0.0 && k.keeps_sign && to(0.5 * real) == to(0.0) ? 1.0 - std::abs(real) : std::abs(real - next);
    all.decide(margin, k.bound(), k.operations, double(value) == to(real) || !std::isfinite(value));
    return all.exact(value);
}

template <class Order>
bool decide(number a, number b, Order order) {
    const float x = a.value(), y = b.value();
    if (std::isnan(x) || std::isnan(y))
        return all.by().assumes_finite ? all.draw().below(2) : order(double(x), double(y));
    const knowledge i = known(a), j = known(b);
    const bool is = order(double(x), double(y));
    const bool of_read = (all.is_argument(a) && !i.exact) || (all.is_argument(b) && !j.exact);
    if (of_read && is != order(i.real, j.real)) ++all.out().reads_decided;  // no arithmetic, no proof
    if (std::isfinite(i.real) && std::isfinite(j.real) && !of_read)
        all.decide(std::abs(i.real - j.real), i.bound() + j.bound(), std::max(i.operations, j.operations),
                   is == order(i.real, j.real));
    return is;
}

/// One of two numbers, chosen by their values; closer to each other than their errors, either is the real choice.
number chosen(number a, number b, bool takes_b, const double& (*of_reals)(const double&, const double&)) {
    if (all.by().assumes_finite && (std::isnan(a.value()) || std::isnan(b.value()))) takes_b = all.draw().below(2);
    const knowledge i = known(a), j = known(b), &taken = takes_b ? j : i;
    const bool is_clear = std::abs(i.real - j.real) > i.bound() + j.bound();
    if (taken.exact && (i.exact == j.exact || is_clear || std::isnan(i.real) || std::isnan(j.real)))
        return all.exact(taken.value);
    return inexact(taken.value, of_reals(i.real, j.real), std::max(i.magnitude, j.magnitude),
                   std::max(i.operations, j.operations));
}

}  // namespace

number::number(float v) : node_(all.exact(v, expressions::literal).node_) {}
float number::value() const { return all.value(*this); }
number::operator int() const {
    const float v = whole(*this, [](double x) { return std::trunc(x); }).value();
    return std::abs(v) < 0x1p31f ? static_cast<int>(v) : 0;
}
number::operator std::uint32_t() const {
    const float v = whole(*this, [](double x) { return std::trunc(x); }).value();
    return v >= 0.0f && v < 0x1p32f ? static_cast<std::uint32_t>(v) : 0;
}

number operator+(number a, number b) { return all.sum(a, b); }
number operator-(number a, number b) { return all.sum(a, all.negated(b)); }
number operator*(number a, number b) { return all.product(a, b); }
number operator-(number a) { return all.negated(a); }
number operator/(number a, number b) {
    const float x = a.value(), y = b.value();
    if (all.is_literal(a) && all.is_literal(b)) return number(x / y);  // a compiler does that
    const knowledge i = known(a), j = known(b);
    if (all.by().is_inaccurate && !(std::abs(y) >= 0x1p-126f && std::abs(y) <= 0x1p126f)) all.out().out_of_range = true;
    const bool bounded = j.bound() * 2.0 < std::abs(j.real);
    return inexact(all.round().function(double(x) / double(y), division.worst()), i.real / j.real,
                   bounded ? i.magnitude * j.magnitude / (j.real * j.real) : infinity,
                   i.operations + j.operations + division.worst());
}
bool operator<(number a, number b) {
    return decide(a, b, [](double x, double y) { return x < y; });
}
bool operator<=(number a, number b) {
    return decide(a, b, [](double x, double y) { return x <= y; });
}
bool operator==(number a, number b) {
    return decide(a, b, [](double x, double y) { return x == y; });
}
bool operator!=(number a, number b) {
    return decide(a, b, [](double x, double y) { return x != y; });
}

number floor(number v) {
    return whole(v, [](double x) { return std::floor(x); });
}
number ceil(number v) {
    return whole(v, [](double x) { return std::ceil(x); });
}
number fract(number v) { return v - floor(v); }
number abs(number v) {
    const float value = std::abs(v.value());
    const knowledge k = known(v);
    return k.exact ? all.exact(value) : inexact(value, std::abs(k.real), k.magnitude, k.operations);
}
number sqrt(number v) {
    const float x = v.value();
    const knowledge k = known(v);
    const auto value = all.round().function(std::sqrt(double(x)), square_root.worst());
    if (all.by().is_inaccurate && x < 0x1p-126f && x != 0.0f) all.out().out_of_range = true;
    const double real = std::sqrt(std::max(k.real, 0.0)), bound = k.bound(), accuracy = square_root.worst();
    if (2.0 * bound < k.real) return inexact(value, real, k.magnitude / real, 0.7 * k.operations + accuracy);
    return inexact(value, real, std::sqrt(k.real + bound) / unit, 1.0 + accuracy * unit);  // by the root of the error
}
number exp2(number v) {
    const float x = v.value();
    const knowledge k = known(v);
    if (all.by().is_inaccurate && !(x >= -126.0f && x < 128.0f)) all.out().out_of_range = true;
    const double real = std::exp2(k.real), accuracy = power_of_two.worst() + 2.0 * std::abs(double(x));
    return inexact(all.round().function(std::exp2(double(x)), accuracy), real, real * std::max(1.0, k.magnitude),
                   k.operations + accuracy);
}
number min(number a, number b) { return chosen(a, b, b.value() < a.value(), std::min<double>); }
number max(number a, number b) { return chosen(a, b, a.value() < b.value(), std::max<double>); }
number uintBitsToFloat(std::uint32_t bits) { return all.exact(std::bit_cast<float>(bits)); }
std::uint32_t floatBitsToUint(number v) { return std::bit_cast<std::uint32_t>(v.value()); }

number given(float v) { return all.exact(v, expressions::argument); }
number read(float v, int unorm_bits) {
    const rules& by = all.by();
    if (unorm_bits == 0 || v == 0.0f || v == 1.0f || !(by.reads_beside || by.reads_halves)) return given(v);
    if (by.reads_halves && unorm_bits == 8) {
        const float half = std::ldexp(std::nearbyint(std::ldexp(v, 10 - std::ilogb(v))), std::ilogb(v) - 10);
        return all.inexact({half, v, v, 4096.0}, expressions::argument);
    }
    const float beside[] = {v, std::nextafter(v, 0.0f), std::nextafter(v, 2.0f)};
    return all.inexact({beside[all.draw().below(3)], v, v, 1.0}, expressions::argument);
}
number stored(number v, unorm_store by) {
    const double scaled = double(v.value()) * 255.0, low = std::floor(std::clamp(scaled, 0.0, 255.0));
    const knowledge k = known(v);
    const auto code = [by](double x) {
        x = x > 0.0 ? std::min(x, 255.0) : 0.0;  // of a NaN 0
        return by == unorm_store::rounds ? std::floor(x + 0.5) : std::floor(x);
    };
    if (all.by().stores_either) return scaled > low && all.draw().below(2) ? float(low + 1.0) : float(low);
    const double real = k.real * 255.0 + (by == unorm_store::rounds ? 0.5 : 0.0);
    all.decide(std::abs(real - std::round(real)), 255.0 * k.bound(), k.operations,
               code(scaled) == code(k.real * 255.0));
    return static_cast<float>(code(scaled));
}
number made(float v, double real, double error) { return inexact(v, real, error / unit, 1.0); }
int drawn(int n) { return all.draw().below(n); }
bool is_literal(number v) { return all.is_literal(v); }
bool is_nan(number v) { return std::isnan(v.value()); }
bool is_argument(number v) { return all.is_argument(v); }
knowledge known(number v) { return all.knowledge_of(v); }

void begin(const rules& by, std::uint64_t seed) { all.begin(by, seed); }
const outcome& result() { return all.out(); }
const rules& rules_in_use() { return all.by(); }

}  // namespace parity::arithmetic
