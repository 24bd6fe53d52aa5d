// SPDX-License-Identifier: MIT
#include <metal_stdlib>

float shadow(metal::depth2d<float> map, float2 uv, float z) {
    constexpr metal::sampler compared(metal::filter::linear, metal::compare_func::less_equal);
    return map.sample_compare(compared, uv, z BIAS);
}
