// SPDX-License-Identifier: MIT
//
// Fragment shaders through Vulkan: what a compiler makes of them, and what they take.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace bench {

using spirv = std::vector<std::uint32_t>;

/// Bindings of every fragment shader that is drawn: 0 `map`, 1 `table`, both RGBA8; 2 `depth_map`, sampler2DShadow; 3
/// sampler2DArray; 4 sampler2DArrayShadow; 5 samplerCube; 6 samplerCubeShadow; 7 uniforms, all 0.
/// Inputs: vec4 x0 to x5 at locations 0 to 5. Push constants: vec2 map_size. Output: location 0, RGBA8.
inline constexpr int map_size = 2048;

/// Statistic of the compiler for a shader, by its own name. RADV has "Instructions", "Inverse Throughput", "VGPRs" ...
struct statistic {
    std::string name;
    std::uint64_t value;
};

/// A device's compiler and, for those that can draw, its clock. Lives until the process ends.
class device {
public:
    virtual ~device() = default;
    [[nodiscard]] virtual std::string name() const = 0;
    [[nodiscard]] virtual std::vector<statistic> statistics(const spirv& vertex, const spirv& fragment) = 0;

    /// Least milliseconds of a few passes over `width` x `height` pixels.
    [[nodiscard]] virtual double milliseconds(const spirv& vertex, const spirv& fragment, std::uint32_t width,
                                              std::uint32_t height) = 0;
};

/// RDNA2, compiled for without having it: RADV's null device. Null when Mesa has no such driver here.
[[nodiscard]] device* rdna2();

/// The GPUs of this machine; with `software`, what computes on the CPU too.
[[nodiscard]] std::vector<device*> gpus(bool software);

}  // namespace bench
