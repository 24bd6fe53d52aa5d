// SPDX-License-Identifier: MIT
//
// The numbers of one call, as nodes of their expressions: what is known of each, and its value once it is used.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "rounding.hpp"

namespace parity::arithmetic {

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
        n.greatest = std::max(1.0, std::abs(double(v)));
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
        n.least = std::min(x.least, y.least), n.greatest = std::max(x.greatest, y.greatest),
        n.factors = std::max(x.factors, y.factors);
        n.quanta = x.quanta + y.quanta;
        n.quantum = std::min(x.quantum, y.quantum);
        n.known.keeps_sign = x.known.keeps_sign && y.known.keeps_sign && x.known.real * y.known.real >= 0.0;
        return add(checked(n, x, y));
    }
    [[nodiscard]] number product(number a, number b) {
        const node &x = at(a), &y = at(b);
        node n{.operation = times, .a = a.node_, .b = b.node_};
        n.known = {0.0f, x.known.real * y.known.real,
                   std::max(x.known.magnitude * y.known.magnitude, least_magnitude * x.greatest * y.greatest),
                   x.known.operations + y.known.operations + 1.0};
        n.terms = x.terms * y.terms <= most_listed ? x.terms * y.terms : 0;
        for (int i = 0; i < n.terms; ++i)
            n.term[std::size_t(i)] = x.term[std::size_t(i % x.terms)] * y.term[std::size_t(i / x.terms)];
        n.least = x.least * y.least, n.greatest = x.greatest * y.greatest, n.factors = x.factors + y.factors;
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
            if (n.known.magnitude == std::numeric_limits<double>::infinity()) out_.unbounded = true;
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
        double least = 1.0;     ///< no partial product of a term is below
        double greatest = 1.0;  ///< nor above
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
    float written(std::uint32_t id);
    /// As sums and products in an order that is drawn.
    float regrouped(std::uint32_t id);
    void collect(std::uint32_t id, bool negative, parts& p);
    void factors(std::uint32_t id, bool& negative, std::vector<std::uint32_t>& ids, parts& p);
    /// The node that two nodes make where the text joins them.
    [[nodiscard]] std::uint32_t joined(std::uint32_t a, std::uint32_t b, parts& p) const;
    float sum_of(parts& p);
    /// a * b + a * c becomes a * (b + c).
    void take_common_factor_out(parts& p);
    float product_of(term& t, parts& p);
    /// Multiplies factors until so many are left.
    void reduce(term& t, std::size_t left, parts& p);

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

}  // namespace parity::arithmetic
