// SPDX-License-Identifier: MIT
#include "values.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>

#include <glm/common.hpp>

#include "numbers.hpp"

namespace check {
namespace {

/// Bits of the significand that are not 0 at the end: what is left of a number's digits.
int digits_of(float v) {
    const std::uint32_t bits = glm::floatBitsToUint(v) & 0x7FFFFFu;
    return bits == 0 ? 0 : 23 - std::countr_zero(bits);
}

int digits_of(const glm::vec4& v) { return digits_of(v.x) + digits_of(v.y) + digits_of(v.z) + digits_of(v.w); }

float rounded(float v, int digits) {
    int exponent = 0;
    const float part = std::frexp(v, &exponent);
    return std::ldexp(std::floor(std::ldexp(part, digits) + 0.5f), exponent - digits);
}

float number(const std::string& word) {
    if (word.starts_with("0x") && word.size() == 10)
        return glm::uintBitsToFloat(static_cast<std::uint32_t>(std::strtoul(word.c_str(), nullptr, 16)));
    return std::strtof(word.c_str(), nullptr);
}

}  // namespace

value_table read_table(std::string_view text, std::string& error) {
    value_table table;
    std::vector<float> row;
    std::string word;
    std::size_t width = 0, rows = 0;
    bool header = false;
    const auto end_word = [&] {
        if (word.empty()) return;
        const char c = word.front();
        header |= !(c == '-' || c == '+' || c == '.' || (c >= '0' && c <= '9') || word == "nan" || word == "inf" ||
                    word == "NaN" || word == "Infinity");
        row.push_back(number(word));
        word.clear();
    };
    const auto end_row = [&] {
        end_word();
        if (row.empty()) return;
        const bool skip = header && rows == 0;
        header = false;
        ++rows;
        if (!skip) {
            if (width == 0) width = row.size();
            if (row.size() != width || width < 2 || width > 5) {
                if (error.empty())
                    error = "row " + std::to_string(rows) + " has " + std::to_string(row.size()) +
                            " numbers; each needs one to four arguments and what is expected";
            } else {
                glm::vec4 input(0);
                for (std::size_t k = 0; k + 1 < width; ++k) input[static_cast<int>(k)] = row[k];
                table.inputs.push_back(input);
                table.expected.push_back(row.back());
            }
        }
        row.clear();
    };
    const bool is_json = text.find('[') != text.npos;
    for (char c : text) {
        if (c == ',' || c == ';' || c == ' ' || c == '\t' || c == '\r' || c == '[' || c == '"') end_word();
        else if (c == ']' || (c == '\n' && !is_json)) end_row();
        else if (c == '\n') end_word();
        else word += c;
    }
    end_row();
    if (error.empty() && table.inputs.empty()) error = "there are no rows of numbers";
    if (!error.empty()) return {};
    table.arguments = static_cast<int>(width) - 1;
    return table;
}

std::uint64_t ulps_between(float a, float b) {
    if (umbrage::is_nan(a) || umbrage::is_nan(b))
        return umbrage::is_nan(a) && umbrage::is_nan(b) ? 0 : std::uint64_t(1) << 32;
    const auto place = [](float v) {
        const auto bits = glm::floatBitsToUint(v);
        const auto magnitude = static_cast<std::int64_t>(bits & 0x7FFFFFFFu);
        return bits >> 31 ? -magnitude : magnitude;
    };
    const std::int64_t apart = place(a) - place(b);
    return static_cast<std::uint64_t>(apart < 0 ? -apart : apart);
}

value_check::value_check(value_table table, std::uint64_t allowed) : table_(std::move(table)), allowed_(allowed) {}

value_check::value_check(std::function<float(glm::vec4)> expected, int arguments, glm::vec4 from, glm::vec4 to,
                         std::uint64_t allowed, std::uint32_t seed)
    : function_(std::move(expected)), allowed_(allowed) {
    table_.arguments = arguments;
    dice random(seed);
    for (int i = 0; i < 16384; ++i) {
        glm::vec4 input(0);
        for (int k = 0; k < arguments; ++k) {
            const float share = i < 256 ? float(random.below(5)) / 4 : random.unit();
            input[k] = from[k] + (to[k] - from[k]) * share;
        }
        table_.inputs.push_back(input);
        table_.expected.push_back(function_(input));
    }
}

std::optional<batch> value_check::next() {
    if (!started_) return batch{{0, 0}, {}, table_.inputs};
    if (trials_.empty()) return std::nullopt;
    return batch{{0, 0}, {}, trials_};
}

void value_check::answer(std::span<const glm::vec4> outputs) {
    const bool first_answer = !started_;
    started_ = true;
    const std::vector<glm::vec4> inputs = first_answer ? table_.inputs : trials_;
    bool better = false;
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const float expected = first_answer ? table_.expected[i] : function_(inputs[i]), got = outputs[i].x;
        const std::uint64_t apart = ulps_between(expected, got);
        if (first_answer) {
            ++found_.inputs;
            found_.within += apart <= allowed_;
            found_.worst = (std::max)(found_.worst, apart);
        }
        if (apart <= allowed_ || (found_.first && digits_of(inputs[i]) >= digits_of(found_.first->input))) continue;
        found_.first = {{}, {}, inputs[i], {got, 0, 0, 0}, {expected, 0, 0, 0}};
        better = true;
    }
    trials_.clear();
    if (better && function_) make_trials();
}

/// The arguments of the difference, each with fewer digits.
void value_check::make_trials() {
    for (int k = 0; k < table_.arguments; ++k)
        for (int digits = 0; digits < 24; ++digits) {
            glm::vec4 trial = found_.first->input;
            trial[k] = rounded(trial[k], digits);
            if (digits_of(trial) < digits_of(found_.first->input)) trials_.push_back(trial);
        }
}

std::string text(const value_verdict& v, std::uint64_t allowed) {
    std::string all = std::to_string(v.within) + " of " + std::to_string(v.inputs) + " results are within " +
                      std::to_string(allowed) + " ulp; the worst is off by " + std::to_string(v.worst) + '\n';
    if (v.first) {
        const glm::vec4& x = v.first->input;
        all += "  roundest input that differs: " + exact(x.x) + ", " + exact(x.y) + ", " + exact(x.z) + ", " +
               exact(x.w) + "\n    yours gives " + exact(v.first->got.x) + ", expected is " +
               exact(v.first->expected.x) + '\n';
    }
    return all;
}

std::string json(const value_verdict& v, std::uint64_t allowed) {
    const auto quoted_if_needed = [](float f) { return umbrage::is_finite(f) ? exact(f) : '"' + exact(f) + '"'; };
    std::string all = "{\"inputs\": " + std::to_string(v.inputs) + ", \"within\": " + std::to_string(v.within) +
                      ", \"allowed\": " + std::to_string(allowed) + ", \"worst\": " + std::to_string(v.worst);
    if (v.first) {
        const glm::vec4& x = v.first->input;
        all += ", \"first\": {\"input\": [" + quoted_if_needed(x.x) + ", " + quoted_if_needed(x.y) + ", " +
               quoted_if_needed(x.z) + ", " + quoted_if_needed(x.w) +
               "], \"got\": " + quoted_if_needed(v.first->got.x) +
               ", \"expected\": " + quoted_if_needed(v.first->expected.x) + '}';
    }
    return all + '}';
}

}  // namespace check
