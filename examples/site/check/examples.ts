// SPDX-License-Identifier: MIT
//
// Texts to try the page with.
import type { State } from './state';

type Example = { name: string } & Pick<State, 'text' | 'language' | 'is'>;

export const examples: Record<string, Example> = {
    half_texel: {
        name: 'GLSL: a 2x2 filter, half a texel off',
        language: '',
        is: '',
        text: `// Bilinear filter of four comparisons.
float compared(sampler2D map, ivec2 texel, float z) {
    ivec2 last = textureSize(map, 0) - 1;
    float stored = texelFetch(map, clamp(texel, ivec2(0), last), 0).r;
    return z <= stored ? 1.0 : 0.0;
}

float shadow(sampler2D map, vec2 uv, float z) {
    vec2 at = uv * vec2(textureSize(map, 0)), weight = fract(at);
    ivec2 texel = ivec2(floor(at));
    float low = mix(compared(map, texel, z),
                    compared(map, texel + ivec2(1, 0), z), weight.x);
    float high = mix(compared(map, texel + ivec2(0, 1), z),
                     compared(map, texel + ivec2(1, 1), z), weight.x);
    return mix(low, high, weight.y);
}
`,
    },
    hardware: {
        name: 'GLSL: one tap of a comparison sampler',
        language: '',
        is: 'pcf_2x2',
        text: `uniform sampler2DShadow shadowMap;
uniform float bias;

float visibility(vec3 shadowCoord) {
    return texture(shadowMap, vec3(shadowCoord.xy, shadowCoord.z - bias));
}
`,
    },
    loop: {
        name: 'GLSL: a loop over 3x3 texels, 1 in shadow',
        language: '',
        is: '',
        text: `uniform sampler2D shadowMap;

float shadow(vec4 lightSpace) {
    vec3 at = lightSpace.xyz / lightSpace.w * 0.5 + 0.5;
    vec2 texel = 1.0 / vec2(textureSize(shadowMap, 0));
    float dark = 0.0;
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
            dark += at.z > texture(shadowMap, at.xy + vec2(x, y) * texel).r ? 1.0 : 0.0;
    return dark / 9.0;
}
`,
    },
    packing: {
        name: 'WebGL 1: depth packed in four channels',
        language: 'glsl100',
        is: '',
        text: `precision highp float;

vec4 pack(float depth) {
    vec4 shifted = fract(depth * vec4(1.0, 255.0, 65025.0, 16581375.0));
    return shifted - shifted.yzww / vec4(255.0, 255.0, 255.0, 255.0);
}
`,
    },
    wgsl: {
        name: 'WGSL: textureSampleCompareLevel',
        language: '',
        is: 'pcf_2x2',
        text: `@group(0) @binding(0) var shadow_map: texture_depth_2d;
@group(0) @binding(1) var shadow_sampler: sampler_comparison;

fn shadow(uv: vec2f, depth: f32) -> f32 {
    return textureSampleCompareLevel(shadow_map, shadow_sampler, uv, depth);
}
`,
    },
};
