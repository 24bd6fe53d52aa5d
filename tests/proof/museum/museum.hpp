// SPDX-License-Identifier: MIT
//
// Museum of public bugs. Each exhibit runs the old formula, written again from its description, and that of umbrage on
// the same inputs. The test demands that the old one fails and that of umbrage does not. main.cpp writes MUSEUM.md.
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <glm/gtc/type_precision.hpp>
#include <umbrage/core/unorm.hpp>

/// Drawing of a score: a cell for each run of inputs, in the order in which they are tried, or for each square of them
/// where they are n x n. It holds the worst wrong error there, or 0.
struct drawing {
    long inputs = 0, columns = 0, rows = 0;
    std::vector<double> errors;

    void add(long input, double error) {
        const long side = std::lround(std::sqrt(double(inputs)));
        const long at = side * side == inputs && side >= columns
                            ? input / side * rows / side * columns + input % side * columns / side
                            : input * columns * rows / inputs;
        double& cell = errors[static_cast<std::size_t>(at)];
        cell = error > cell ? error : cell;
    }
};

struct score {
    long wrong = 0, tried = 0;
    double worst = 0.0;
    inline static drawing* drawn = nullptr;  ///< drawing that the next score also fills, if any

    /// One input: its error, and what is still allowed. NaN is wrong, and infinitely so.
    void add(double error, double allowed) {
        error = std::isnan(error) ? HUGE_VAL : std::abs(error);
        if (drawn && error > allowed) drawn->add(tried, error);
        ++tried;
        wrong += error > allowed;
        worst = error > worst ? error : worst;
    }
};

struct exhibit {
    const char* title;
    const char* seen;     ///< where: public systems and threads
    const char* trouble;  ///< symptom
    const char* formula;  ///< the old one
    const char* counted;  ///< inputs tried, and the condition for a wrong one
    const char* unit;     ///< unit of the worst error
    const char* ours;     ///< answer of umbrage
    score (*old_way)();
    score (*our_way)();
};

std::span<const exhibit> encodings();
std::span<const exhibit> filters();
std::span<const exhibit> moments();
std::span<const exhibit> spaces();

/// Through an 8-bit target: what is read back of written values, or of integer channels, which go through to_unorm.
template <int L>
glm::vec<L, float> stored(glm::vec<L, float> written, umbrage::unorm_store store = umbrage::unorm_store::rounds) {
    return umbrage::load_unorm(umbrage::store_unorm(written, store));
}
template <int L>
glm::vec<L, float> stored(glm::vec<L, std::uint8_t> channels,
                          umbrage::unorm_store store = umbrage::unorm_store::rounds) {
    return stored(umbrage::to_unorm(glm::vec<L, float>(channels)), store);
}
