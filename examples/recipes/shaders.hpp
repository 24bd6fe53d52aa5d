// SPDX-License-Identifier: MIT
//
// Shaders of the recipes for Direct3D 12 and Metal, whose compilers take them; nothing here runs them.
#pragma once

#include <string>

#include <umbrage/umbrage.hpp>

#include "scene.hpp"

namespace shaders {

namespace glsl = umbrage::glsl;
using glsl::texture;

// Right-handed, as the scene is, under both APIs.
inline const umbrage::shadow spot(scene::make_spot(umbrage::metal_clip_space), {1024, 1024}, umbrage::filters::tent<3>);
inline const umbrage::shadow sun(scene::make_cascades(umbrage::metal_clip_space), {1024, 1024},
                                 umbrage::filters::tent<3>);

/// Entry points: place, depth, color. Registers: b0, t0 and s0 of the spot light, b1, t1 and s1 of the sun, b2.
inline std::string direct3d12() {
    return umbrage::hlsl::text({glsl::bind(spot, "spot", {0, 0, 0, 0, texture::shadow}),
                                glsl::bind(sun, "sun", {1, 1, 1, 0, texture::shadow_array})}) +
           "#define vec2 float2\n#define vec3 float3\n#define fract frac\n" + scene::shading + R"(
cbuffer pass : register(b2) {
    column_major float4x4 to_clip;
};
struct corner {
    float4 position : SV_Position;
    float3 world : WORLD;
    float3 normal : NORMAL;
    float2 uv : UV;
};
corner place(float3 world : POSITION, float3 normal : NORMAL, float2 uv : TEXCOORD) {
    corner c = { mul(to_clip, float4(world, 1.0)), world, normal, uv };
    return c;
}
void depth(corner c) {
    if (is_hole(c.uv)) discard;
}
float4 color(corner c) : SV_Target {
    if (is_hole(c.uv)) discard;
    return float4(shade(c.world, c.normal, umbrage_spot(c.world, c.normal), umbrage_sun(c.world, c.normal)), 1.0);
}
)";
}

/// Entry points: place, depth, color. Buffers 0 and 1, textures 0 and 1 and sampler 0 belong to spot light and sun.
inline std::string metal() {
    return umbrage::msl::text({glsl::bind(spot, "spot", {.map = texture::shadow}),
                               glsl::bind(sun, "sun", {.map = texture::shadow_array})}) +
           "using namespace metal;\n#define vec2 float2\n#define vec3 float3\n" + scene::shading + R"(
struct vertex_in {
    float3 world [[attribute(0)]];
    float3 normal [[attribute(1)]];
    float2 uv [[attribute(2)]];
};
struct corner {
    float4 position [[position]];
    float3 world;
    float3 normal;
    float2 uv;
};
vertex corner place(vertex_in v [[stage_in]], constant float4x4& to_clip [[buffer(0)]]) {
    return {to_clip * float4(v.world, 1.0), v.world, v.normal, v.uv};
}
fragment void depth(corner c [[stage_in]]) {
    if (is_hole(c.uv)) discard_fragment();
}
fragment float4 color(corner c [[stage_in]], constant umbrage_spot_block& spot_block [[buffer(0)]],
                      constant umbrage_sun_block& sun_block [[buffer(1)]], depth2d<float> spot_map [[texture(0)]],
                      depth2d_array<float> sun_maps [[texture(1)]], sampler compares [[sampler(0)]]) {
    if (is_hole(c.uv)) discard_fragment();
    float spot = umbrage_spot(spot_block, spot_map, compares, c.world, c.normal);
    float sun = umbrage_sun(sun_block, sun_maps, compares, c.world, c.normal);
    return float4(shade(c.world, c.normal, spot, sun), 1.0);
}
)";
}

}  // namespace shaders
