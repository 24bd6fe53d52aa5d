// SPDX-License-Identifier: MIT
//
// Errors that the specifications allow to the operations of snippets: a table with one row per operation.
#pragma once

namespace parity::arithmetic {

/// Error allowed to one operation, in ulp of the result. A negative number: the language states none.
struct accuracy {
    const char* operation;
    double glsl, vulkan, wgsl, direct3d, metal;
    const char* range;  ///< range of the operand, outside which no accuracy is promised

    [[nodiscard]] constexpr double worst() const {
        double most = 0.0;
        for (const double ulp : {glsl, vulkan, wgsl, direct3d, metal}) most = ulp > most ? ulp : most;
        return most;
    }
};

// Sources: GLSL 4.60.8 and GLSL ES 3.20, section 4.7.1; Vulkan 1.3, appendix "Precision and Operation of SPIR-V
// Instructions"; WGSL, section 15.7.4; Direct3D 11.3 functional specification, 3.1 and 22.10; Metal Shading Language
// 3.2, table 8.2 (fast math). A square root is "inherited from" 1 / inverseSqrt(x) in the first three: 2 + 2.5 ulp.
//
//                                      GLSL  Vulkan WGSL  D3D  Metal
inline constexpr accuracy division{"a / b", 2.5, 2.5, 2.5, 1.0, 2.5, "2^-126 <= |b| <= 2^126"};
inline constexpr accuracy square_root{"sqrt(x)", 4.5, 4.5, 4.5, 1.0, 4.5, "x >= 2^-126"};
/// and 2 |x| ulp more, but for Direct3D's 2^-21 of the result.
inline constexpr accuracy power_of_two{"exp2(x)", 3.0, 3.0, 3.0, 4.0, 3.0, "-126 <= x < 128"};
/// of a texel of an 8 or 16-bit UNORM format
inline constexpr accuracy unorm_read{"UNORM read", 1.0, 1.0, 1.0, 0.5, 1.0, "codes"};

}  // namespace parity::arithmetic
