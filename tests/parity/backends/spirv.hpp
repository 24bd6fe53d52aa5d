// SPDX-License-Identifier: MIT
//
// SPIR-V from the reference compiler, in this process: it reads its built-in functions once.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace parity {

class spirv_compiler {
public:
    spirv_compiler();
    ~spirv_compiler();
    spirv_compiler(const spirv_compiler&) = delete;
    spirv_compiler& operator=(const spirv_compiler&) = delete;

    enum language { glsl, hlsl };

    /// False where the compiler was not at hand when this was built.
    [[nodiscard]] static bool is_here();

    /// Code for Vulkan 1.0; that of GLSL is validated.
    /// @param stage   "vert", "frag" or "comp"; the function is main
    /// @throws std::runtime_error   with the compiler's words, or the validator's
    [[nodiscard]] std::vector<std::uint32_t> compile(const std::string& stage, const std::string& text,
                                                     language in = glsl) const;
};

}  // namespace parity
