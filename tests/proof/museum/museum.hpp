// SPDX-License-Identifier: MIT
//
// Museum of public bugs. Each exhibit runs the old formula, written again from its description, and that of umbrage on
// the same inputs. The test demands that the old one fails and that of umbrage does not. main.cpp writes MUSEUM.md.
#pragma once

#include <cmath>
#include <span>

#include <glm/gtc/type_precision.hpp>
#include <umbrage/core/unorm.hpp>

struct score {
    long wrong = 0, tried = 0;
    double worst = 0.0;

    /// One input: its error, and what is still allowed. NaN is wrong, and infinitely so.
    void add(double error, double allowed) {
        error = std::isnan(error) ? HUGE_VAL : std::abs(error);
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
