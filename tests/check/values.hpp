// SPDX-License-Identifier: MIT
//
// Any function of up to four floats against a table or a C++ function, in units in the last place (ulp).
//
//     check::value_check question(my_table, 2);
//     while (std::optional<check::batch> b = question.next()) question.answer(run_on_gpu(*b));
//
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec4.hpp>

#include "investigation.hpp"

namespace check {

/// Arguments in the components from x on, and what each call should give.
struct value_table {
    int arguments = 1;
    std::vector<glm::vec4> inputs{};
    std::vector<float> expected{};
};

/// Rows of numbers, the last of each what is expected: CSV lines, or JSON's arrays in an array. 0x and eight digits are
/// a float's bits. A first CSV line without numbers is a header.
/// @return   an empty table, and why in `error`, where rows differ in length or have none or over four arguments
[[nodiscard]] value_table read_table(std::string_view text, std::string& error);

/// Floats between two, -0 and 0 being one. NaN and NaN: 0; NaN and a number: 2^32.
[[nodiscard]] std::uint64_t ulps_between(float a, float b);

struct value_verdict {
    std::size_t inputs = 0;
    std::size_t within = 0;             ///< of these, within the allowed ulp
    std::uint64_t worst = 0;            ///< ulp
    std::optional<difference> first{};  ///< with the roundest arguments that were found
};
[[nodiscard]] std::string text(const value_verdict&, std::uint64_t allowed);
[[nodiscard]] std::string json(const value_verdict&, std::uint64_t allowed);

class value_check {
public:
    explicit value_check(value_table, std::uint64_t allowed = 0);
    /// Inputs are random between two corners, and round ones. A difference is reduced to rounder arguments.
    value_check(std::function<float(glm::vec4)> expected, int arguments, glm::vec4 from, glm::vec4 to,
                std::uint64_t allowed = 0, std::uint32_t seed = 1);

    [[nodiscard]] std::optional<batch> next();
    void answer(std::span<const glm::vec4> outputs);
    [[nodiscard]] const value_verdict& result() const { return found_; }

private:
    std::function<float(glm::vec4)> function_{};  ///< none: of a table
    value_table table_;
    std::uint64_t allowed_;
    value_verdict found_{};
    std::vector<glm::vec4> trials_{};  ///< rounder arguments
    bool started_ = false;

    void make_trials();
};

}  // namespace check
