// SPDX-License-Identifier: MIT
//
// An entry's text in an arithmetic, held against what its tier promises.
#pragma once

#include <array>
#include <string>

#include "../backend.hpp"
#include "../shader.hpp"
#include "../texture.hpp"
#include "arithmetics.hpp"

namespace parity::arithmetic {

/// One call: what came out, and what is known of it.
struct call {
    std::array<knowledge, 4> results{};
    std::array<bool, 4> passed_on{};  ///< an argument or texel, as it came
    outcome what{};

    [[nodiscard]] float value(int c) const { return results[std::size_t(c)].value; }
};

/// Calls an entry's text with the inputs of a job.
class caller {
public:
    explicit caller(const job& j);
    [[nodiscard]] const job& inputs() const { return job_; }
    [[nodiscard]] call operator()(std::size_t input, const rules& by, std::uint64_t seed) const;

private:
    const job& job_;
    std::vector<filled_texture> textures_;
    std::array<const filled_texture*, max_textures> by_unit_{};
};

/// True when the tier of a call's entry allows this result. Some order, fusing and rounding gives it, or it lies within
/// the bound after the same decisions. A visibility without a bound must still be in [0, 1], except for NaN.
[[nodiscard]] bool allows(const caller& run, std::size_t input, const vec4& result);

/// True when the entry's result is a visibility.
[[nodiscard]] bool is_visibility(const entry& e);

/// A promise to hold an entry to; by default its own.
struct promise {
    tier exactness = tier::a;
    bool as_written = false;  ///< `within` holds in the written order, rounded to nearest, alone
    double within = 0.0;      ///< tier C: greatest difference; 0: the bound n 2^-23 S
    int operations = 0;       ///< n, where the primitive alone is called
    double share = 1.0;       ///< allowed share of the bound; below 1 it makes a fault
};
[[nodiscard]] promise promise_of(const entry& e, const rules& by);

struct count {
    std::uint64_t inputs = 0, identical = 0;
    std::uint64_t broken = 0;  ///< the promise is
    // Neither identical nor broken, for a reason that the promise names:
    std::uint64_t in_bound = 0, denormal = 0, not_finite = 0, out_of_range = 0, unbounded = 0;
    std::uint64_t either_side =
        0;  ///< of those with another result: a comparison or floor within its bound went otherwise
    std::uint64_t unproven = 0;       ///< tier A: inputs for which the exactness is not shown
    std::uint64_t no_visibility = 0;  ///< farther outside [0, 1] than the bound
    std::uint64_t groupings = 0, rewrites = 0;
    double operations = 0.0;        ///< greatest n
    double worst_share = 0.0;       ///< greatest error, as a share of the bound
    double worst_difference = 0.0;  ///< from C++
    double least_margin =
        std::numeric_limits<double>::infinity();  ///< of a floor or comparison, as a multiple of its error
    double margin = 0.0, error = 0.0;             ///< of that one
    std::string example{};                        ///< example of a broken promise

    void add(const count& other);
};

/// Tries `inputs` inputs of an entry.
[[nodiscard]] count try_entry(const entry& e, const rules& by, std::size_t inputs, const promise& p);

}  // namespace parity::arithmetic
