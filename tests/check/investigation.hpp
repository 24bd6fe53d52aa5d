// SPDX-License-Identifier: MIT
//
// Finds out which function of umbrage a shader's function is, by calling it: which one, with which slips, on which
// inputs it differs.
//
//     check::investigation question(check::subject::filter, {.is = "pcf_2x2"});
//     while (std::optional<check::batch> b = question.next()) question.answer(run_on_gpu(*b));
//     std::puts(check::text(question.result()).c_str());
//
// Calls nothing itself: whoever runs shaders takes a batch of inputs and gives the outputs back. It needs no GPU, file,
// thread or exception, so that it is compiled to WebAssembly too.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "verdict.hpp"

namespace check {

/// Kind of function, which decides what its inputs and outputs are.
enum class subject {
    filter,  ///< x, y: coord in texels; z: receiver depth; the map's texels are depths. Result in x: visibility
    pack,    ///< x: depth in [0, 1]. Result: the values of up to four channels, as a shader writes them
    unpack,  ///< x .. w: channels as sampled, k / 255. Result in x: depth
    bound,   ///< as filter, but texels are moments of depths: their mean, and the mean of their squares
};

/// Inputs for one run over one map. Each input makes one call.
struct batch {
    glm::ivec2 size{0, 0};     ///< of the map, in texels, powers of two: coord / size is exact. 0 for codecs
    std::vector<float> map{};  ///< depths, row by row; texel (0, 0) has its center at coord (0.5, 0.5)
    std::vector<glm::vec4> inputs{};
    std::vector<float> second{};  ///< the texels' second channel; empty: the same as the first
};

/// What the function should be. All empty: tell me.
struct expectation {
    std::string is{};  ///< a name of names(subject)
};

/// Names of all functions that a function can be found to be, such as "pcf_2x2", "box(2)", "rg<11>".
[[nodiscard]] std::vector<std::string> names(subject);

/// Questions about one function until there is a verdict.
class investigation {
public:
    /// @param seed   the same for the same questions
    explicit investigation(subject, expectation = {}, std::uint32_t seed = 1);
    investigation(investigation&&) noexcept;
    investigation& operator=(investigation&&) noexcept;
    ~investigation();

    /// The next inputs, or nothing when the verdict is known. Call answer() with their outputs before the next call.
    [[nodiscard]] std::optional<batch> next();
    /// @param outputs   one for each input of the last batch; components that the function does not have are 0
    void answer(std::span<const glm::vec4> outputs);
    [[nodiscard]] verdict result() const;

private:
    struct state;
    std::unique_ptr<state> state_;
};

}  // namespace check
