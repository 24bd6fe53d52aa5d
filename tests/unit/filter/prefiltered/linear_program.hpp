// SPDX-License-Identifier: MIT
//
// Lower bound over all distributions of depths with given moments, found without knowing their shape. It is a linear
// program over the masses of many depths, solved by the simplex method.
#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "windows.hpp"

/// Depths on [-1, 1] and up to `beyond` outside of it in steps of 1/64, and those of a window, which return its
/// moments.
inline std::vector<double> depth_grid(const depth_window& window, int beyond) {
    std::vector<double> depths;
    for (int k = -64 * (1 + beyond); k <= 64 * (1 + beyond); ++k) depths.push_back(k / 64.0);
    for (const float d : window.depths) depths.push_back(2 * double(d) - 1);
    return depths;
}

/// Least share of depths before a receiver, of all masses at `depths` whose first four moments are given.
class moment_program {
public:
    static constexpr std::size_t rows = 5;
    using column = std::array<double, rows>;

    moment_program(std::vector<double> depths, double receiver, const column& moments) : depths_(std::move(depths)) {
        for (std::size_t r = 0; r < rows; ++r) basis_[r] = depths_.size() + r, inverse_[r][r] = 1;
        masses_ = moments;
        for (std::size_t r = 0; r < rows; ++r)
            if (masses_[r] < 0) masses_[r] = -masses_[r], inverse_[r][r] = -1;
        const auto none = [&](std::size_t i) { return i < depths_.size() ? 0.0 : 1.0; };  // makes up for no depth
        const auto before = [&](std::size_t i) { return none(i) > 0 ? 1e6 : (depths_[i] < receiver ? 1.0 : 0.0); };
        minimize(none);
        minimize(before);
        least_ = total(before);
        for (std::size_t c = 0; c < rows; ++c) {
            double off = -moments[c];
            for (std::size_t r = 0; r < rows; ++r)
                if (basis_[r] < depths_.size()) off += masses_[r] * powers(depths_[basis_[r]])[c];
            unmet_ = std::fmax(unmet_, std::abs(off));
        }
    }

    [[nodiscard]] double least() const { return least_; }
    /// Error of the moments of the masses found.
    [[nodiscard]] double unmet() const { return unmet_; }

private:
    [[nodiscard]] static column powers(double t) { return {1, t, t * t, t * t * t, t * t * t * t}; }
    template <class Cost>
    [[nodiscard]] double total(const Cost& cost) const {
        double sum = 0;
        for (std::size_t r = 0; r < rows; ++r) sum += cost(basis_[r]) * masses_[r];
        return sum;
    }
    /// Exchanges one depth of the basis at a time, for the one that lowers the cost most a mass.
    template <class Cost>
    void minimize(const Cost& cost) {
        for (int exchange = 0; exchange < 1000; ++exchange) {
            column price{};
            for (std::size_t c = 0; c < rows; ++c)
                for (std::size_t r = 0; r < rows; ++r) price[c] += cost(basis_[r]) * inverse_[r][c];
            std::size_t entering = depths_.size();
            double lowest = -1e-11;
            for (std::size_t i = 0; i < depths_.size(); ++i) {
                double reduced = cost(i), power = 1;
                for (std::size_t r = 0; r < rows; ++r, power *= depths_[i]) reduced -= price[r] * power;
                if (reduced < lowest) lowest = reduced, entering = i;
            }
            if (entering == depths_.size()) return;
            exchange_for(entering);
        }
    }
    void exchange_for(std::size_t entering) {
        const column of = powers(depths_[entering]);
        column step{};
        std::size_t leaving = rows;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t r = 0; r < rows; ++r) {
            for (std::size_t c = 0; c < rows; ++c) step[r] += inverse_[r][c] * of[c];
            if (step[r] > 1e-7 && masses_[r] / step[r] < least) least = masses_[r] / step[r], leaving = r;
        }
        if (leaving == rows) return;
        for (double& v : inverse_[leaving]) v /= step[leaving];
        masses_[leaving] = least;
        for (std::size_t r = 0; r < rows; ++r) {
            if (r == leaving) continue;
            for (std::size_t c = 0; c < rows; ++c) inverse_[r][c] -= step[r] * inverse_[leaving][c];
            masses_[r] = std::fmax(masses_[r] - step[r] * least, 0.0);
        }
        basis_[leaving] = entering;
    }

    std::vector<double> depths_;
    std::array<std::size_t, rows> basis_{};
    std::array<column, rows> inverse_{};
    column masses_{};
    double least_ = 0, unmet_ = 0;
};
