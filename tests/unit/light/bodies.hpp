// SPDX-License-Identifier: MIT
//
// Random cameras and boxes, and linear programmes solved by trying every vertex: slow, and without a clipped polygon.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include <umbrage/light/bounds.hpp>

namespace bodies {

using real = std::uniform_real_distribution<double>;

inline glm::dvec3 random_vector(std::mt19937& random, double low, double high) {
    const double x = real(low, high)(random), y = real(low, high)(random), z = real(low, high)(random);
    return {x, y, z};
}

/// A point of the corners' hull, mostly close to one of them.
inline glm::dvec3 point_between(const std::vector<glm::dvec3>& corners, std::mt19937& random) {
    glm::dvec3 sum(0);
    double weights = 0;
    for (const glm::dvec3& corner : corners) {
        const double weight = std::pow(real(0, 1)(random), 8);
        sum += weight * corner, weights += weight;
    }
    return sum / weights;
}

inline umbrage::bounding_box<double> random_box(std::mt19937& random, bool flat = false) {
    umbrage::bounding_box<double> box{random_vector(random, -8, 4)};
    box.high = box.low + random_vector(random, 1, 9);
    if (flat) box.high.y = box.low.y;
    return box;
}

inline umbrage::frustum<double> random_frustum(std::mt19937& random) {
    umbrage::frustum<double> f{.position = random_vector(random, -6, 6),
                               .direction = random_vector(random, -1, 1),
                               .up = random_vector(random, -1, 1)};
    f.tan_half_x = real(0.2, 2)(random), f.tan_half_y = real(0.2, 2)(random);
    f.z_near = real(0.01, 2)(random), f.z_far = f.z_near + real(1, 15)(random);
    return f;
}

/// The least cost . x over a . x + b >= 0 of all constraints (a, b), all of whose vertices are tried; nothing where no
/// point meets them. Bounded by the caller's constraints.
template <std::size_t N>
struct programme {
    struct constraint {
        std::array<double, N> a;
        double b;
    };
    std::vector<constraint> constraints;

    [[nodiscard]] std::optional<double> least(const std::array<double, N>& cost) const {
        std::optional<double> best;
        std::array<std::size_t, N> chosen{};
        const auto choose = [&](const auto& self, std::size_t depth, std::size_t from) -> void {
            if (depth < N) {
                for (std::size_t i = from; i < constraints.size(); ++i) chosen[depth] = i, self(self, depth + 1, i + 1);
                return;
            }
            const std::optional<std::array<double, N>> x = meet(chosen);
            if (!x) return;
            for (const constraint& c : constraints)
                if (at(c.a, *x) + c.b < -1e-9) return;
            best = std::min(best.value_or(1e300), at(cost, *x));
        };
        choose(choose, 0, 0);
        return best;
    }

private:
    static double at(const std::array<double, N>& a, const std::array<double, N>& x) {
        double sum = 0;
        for (std::size_t i = 0; i < N; ++i) sum += a[i] * x[i];
        return sum;
    }

    /// Gauss's elimination.
    std::optional<std::array<double, N>> meet(const std::array<std::size_t, N>& chosen) const {
        std::array<std::array<double, N + 1>, N> m;
        for (std::size_t i = 0; i < N; ++i) {
            std::copy_n(constraints[chosen[i]].a.begin(), N, m[i].begin());
            m[i][N] = -constraints[chosen[i]].b;
        }
        for (std::size_t k = 0; k < N; ++k) {
            const auto pivot =
                std::max_element(m.begin() + std::ptrdiff_t(k), m.end(),
                                 [&](const auto& p, const auto& q) { return std::abs(p[k]) < std::abs(q[k]); });
            if (std::abs((*pivot)[k]) < 1e-9) return {};
            std::swap(*pivot, m[k]);
            for (std::size_t i = 0; i < N; ++i) {
                if (i == k) continue;
                const double share = m[i][k] / m[k][k];
                for (std::size_t j = k; j <= N; ++j) m[i][j] -= share * m[k][j];
            }
        }
        std::array<double, N> x;
        for (std::size_t i = 0; i < N; ++i) x[i] = m[i][N] / m[i][i];
        return x;
    }
};

/// A body's planes on the unknowns first .. first + 2, each of which may have a share of another unknown's vector.
template <std::size_t N>
void inside(programme<N>& p, const umbrage::polyhedron& body, const glm::dvec3& along = glm::dvec3(0)) {
    for (const auto& face : body.faces()) {
        const glm::dvec3 normal(face.plane);
        const double length = glm::length(normal);
        typename programme<N>::constraint c{{}, face.plane.w / length};
        for (glm::length_t i = 0; i < 3; ++i) c.a[std::size_t(i)] = normal[i] / length;
        if constexpr (N > 3) c.a[3] = glm::dot(normal, along) / length;
        p.constraints.push_back(c);
    }
}

}  // namespace bodies
