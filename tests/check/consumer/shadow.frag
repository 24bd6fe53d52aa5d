// SPDX-License-Identifier: MIT
#version 330
float shadow(sampler2D depths, vec2 uv, float z) {
    return z <= texture(depths, uv).r ? 1.0 : 0.0;
}
