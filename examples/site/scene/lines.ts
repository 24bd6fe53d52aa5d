// SPDX-License-Identifier: MIT
//
// The picture's shadow as a whole shader, in each language: the library's text, and a main() that calls it.
import { with_copyright } from '../copyright';
import type { Language } from '../highlight';
import type { Asked } from './light';

/** Shaders that show the visibility. Each takes the triangle's own normal; `pixel` is the last argument, if there is one. */
const mains: Record<Language, (pixel: boolean) => string> = {
    glsl: pixel => `in vec3 world;
out vec4 color;

void main() {
    vec3 normal = normalize(cross(dFdx(world), dFdy(world)));  // of the triangle, not interpolated
    float visibility = umbrage_sun(world, normal${pixel ? ', gl_FragCoord.xy' : ''});  // 1.0 is lit
    color = vec4(vec3(visibility), 1.0);
}
`,
    hlsl: pixel => `float4 main(float4 position : SV_Position, float3 world : WORLD) : SV_Target {
    float3 normal = normalize(cross(ddx(world), ddy(world)));  // of the triangle, not interpolated
    float visibility = umbrage_sun(world, normal${pixel ? ', position.xy' : ''});  // 1.0 is lit
    return float4(visibility, visibility, visibility, 1.0);
}
`,
    wgsl: pixel => `@fragment
fn main(@builtin(position) position: vec4f, @location(0) world: vec3f) -> @location(0) vec4f {
    let normal = normalize(cross(dpdx(world), dpdy(world)));  // of the triangle, not interpolated
    let visibility = umbrage_sun(world, normal${pixel ? ', position.xy' : ''});  // 1.0 is lit
    return vec4f(vec3f(visibility), 1.0);
}
`,
    msl: pixel => `struct varyings {
    float4 position [[position]];
    float3 world;
};

fragment float4 shade(varyings in [[stage_in]], constant umbrage_sun_block& block [[buffer(0)]],
                      metal::texture2d<float> map [[texture(0)]]) {
    float3 normal = metal::normalize(metal::cross(metal::dfdx(in.world), metal::dfdy(in.world)));  // of the triangle
    float visibility = umbrage_sun(block, map, in.world, normal${pixel ? ', in.position.xy' : ''});  // 1.0 is lit
    return float4(float3(visibility), 1.0);
}
`,
};

/** @return  the library's text, and what follows it */
export async function lines_of(asked: Asked, language: Language, pixel: boolean): Promise<{ library: string; main: string }> {
    const umbrage = await {
        glsl: () => import('umbrage'), hlsl: () => import('umbrage/hlsl'), wgsl: () => import('umbrage/wgsl'), msl: () => import('umbrage/msl'),
    }[language]() as typeof import('umbrage');  // the four have the same exports
    const { kind, filter, encoding, map_size, direction } = asked;
    const sun = umbrage.shadow('sun', { kind: umbrage[kind], filter: umbrage.snippets[filter], encoding: umbrage.encodings[encoding],
        map_size, direction });
    const text = language === 'glsl' ? umbrage.source('300 es', [sun], 'precision highp float;') : umbrage.text([sun]);
    return { library: `${with_copyright(text).trim()}\n`, main: mains[language](pixel) };
}
