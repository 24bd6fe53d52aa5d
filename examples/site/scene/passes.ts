// SPDX-License-Identifier: MIT
//
// Shaders of the picture. The one of the lookup is umbrage's text and a main() of two lines.
import { encodings, shadow, snippets, source, type Shadow, type Light } from 'umbrage';
import * as umbrage from 'umbrage';

import type { Asked } from './light';

/** The shadow of a state in GLSL. */
export function shadow_of({ kind, filter, encoding, map_size, direction }: Asked): Shadow {
    return shadow('sun', { kind: umbrage[kind] as Light, filter: snippets[filter], encoding: encodings[encoding], map_size, direction });
}

/** True for filters whose discs turn from pixel to pixel. */
export const turns = (filter: Asked['filter']) =>
    snippets[filter].filter!.arguments.some(argument => argument.name === 'rotation');

const in_place = `
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 color;
layout(location = 3) in mat4 place;`;

/** One triangle over everything. */
export const everywhere = `#version 300 es
void main() {
    gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0);
}`;

/** The depth pass of a map. */
export const depth_pass = (sun: Shadow, clip: Parameters<Shadow['vertex_pass']>[0]) => ({
    vertex: `${source('300 es', [sun.vertex_pass(clip)], 'precision highp float;')}${in_place}
uniform mat4 to_clip;
uniform vec4 anchor;
void main() { gl_Position = umbrage_vertex_sun(to_clip, vec3(place * vec4(position, 1.0)), anchor); }`,
    fragment: `${source('300 es', [sun.depth_pass], 'precision highp float;')}
out vec4 texel;
void main() { texel = umbrage_write_sun(gl_FragCoord.z); }`,
});

/** What the camera sees: position and normal of each pixel's triangle, then what shading wants. */
export const receivers_pass = {
    vertex: `#version 300 es
precision highp float;${in_place}
uniform mat4 to_clip;
out vec3 world, smooth_normal, paint;
void main() {
    world = vec3(place * vec4(position, 1.0));
    smooth_normal = mat3(place) * normal;
    paint = color;
    gl_Position = to_clip * vec4(world, 1.0);
}`,
    fragment: `#version 300 es
precision highp float;
in vec3 world, smooth_normal, paint;
uniform vec3 eye;
layout(location = 0) out vec4 at;
layout(location = 1) out vec4 face;
layout(location = 2) out vec4 shading_normal;
layout(location = 3) out vec4 albedo;
void main() {
    vec3 normal = normalize(cross(dFdx(world), dFdy(world)));
    bool seen_from_behind = dot(smooth_normal, eye - world) < 0.0;
    at = vec4(world, 1.0);
    face = vec4(normal, 0.0);
    shading_normal = vec4(normalize(seen_from_behind ? -smooth_normal : smooth_normal) * 0.5 + 0.5, 1.0);
    albedo = vec4(paint, 1.0);
}`,
};

/** The lookup: the visibility of every pixel. */
export const lookup_pass = (sun: Shadow, turning: boolean) => `${source('300 es', [sun], 'precision highp float;')}
uniform highp sampler2D at, face;
uniform float normals;  // 0.0: a lookup without the smallest bias
out vec4 visibility;
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec4 world = texelFetch(at, pixel, 0);
    vec3 normal = normals > 0.5 ? texelFetch(face, pixel, 0).xyz : vec3(0.0);  // some are NaN: a product would be, too
    visibility = vec4(world.w > 0.0 ? umbrage_sun(world.xyz, normal${turning ? ', vec2(pixel)' : ''}) : 1.0, 0.0, 0.0, 1.0);
}`;

/** Colors of maps by their number. */
const tints = `
const vec3 tints[6] = vec3[](vec3(1.0, 0.42, 0.36), vec3(0.45, 0.85, 0.42), vec3(0.42, 0.58, 1.0), vec3(1.0, 0.82, 0.35),
                             vec3(0.80, 0.50, 0.95), vec3(0.40, 0.85, 0.85));`;

/** The picture: light, shadow and sky; the GPU's visibility left of the divider, C++'s right of it. */
export const picture_pass = `#version 300 es
precision highp float;
uniform highp sampler2D at, shading_normal, albedo, gpu, cpu, places;
uniform vec3 light;       // where it stands, or the direction to it
uniform float is_sun, divider, map_size, gutter;
uniform int view;         // 0 both, 1 what differs, 2 texels and maps
out vec4 color;${tints}
vec3 shoulder(vec3 tone) {
    vec3 over = 2.0 * tone - 1.0;
    return mix(tone, 0.5 + 0.5 * over / (1.0 + over), greaterThan(tone, vec3(0.5)));
}
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec2 size = vec2(textureSize(at, 0));
    vec4 world = texelFetch(at, pixel, 0);
    float by_gpu = texelFetch(gpu, pixel, 0).x, by_cpu = texelFetch(cpu, pixel, 0).x;
    float visibility = gl_FragCoord.x < divider * size.x ? by_gpu : by_cpu;
    if (view == 1) visibility = by_gpu;

    vec3 paint = texelFetch(albedo, pixel, 0).rgb, normal = texelFetch(shading_normal, pixel, 0).xyz * 2.0 - 1.0;
    vec3 to_light = normalize(is_sun > 0.5 ? light : light - world.xyz);
    float lit = max(dot(normal, to_light), 0.0) * visibility;
    vec3 around = mix(vec3(0.24, 0.21, 0.18), vec3(0.36, 0.44, 0.58), 0.5 + 0.5 * normal.y);
    vec3 sum = paint * paint * (lit * vec3(1.75, 1.60, 1.38) + around);
    if (world.w == 0.0) sum = mix(vec3(1.0, 0.95, 0.88), vec3(0.13, 0.28, 0.52), gl_FragCoord.y / size.y);
    vec4 place = texelFetch(places, pixel, 0);
    if (view == 2 && world.w > 0.0) {
        ivec2 texel = ivec2(floor(place.xy));
        vec3 tint = place.w > 0.0 ? tints[int(place.z) % 6] : vec3(0.5);
        sum = mix(vec3(dot(sum, vec3(0.3, 0.6, 0.1))), tint, 0.55) * (((texel.x ^ texel.y) & 1) == 0 ? 1.0 : 0.8);
        bool at_edge = min(place.x, place.y) < gutter + 1.0 || max(place.x, place.y) >= map_size - gutter - 1.0;
        if (gutter > 0.0 && at_edge) sum *= 0.4;
    }
    color = vec4(pow(shoulder(sum), vec3(1.0 / 2.2)), 1.0);
    if (view == 1) color.rgb = by_gpu != by_cpu ? vec3(1.0, 0.1, 0.05) : color.rgb * 0.35;
}`;

/** The map as a picture: what is stored, dark near the light. */
export const map_pass = (sun: Shadow, { encoding, direction }: Asked) => {
    const stored = direction === 'reversed' ? encodings[encoding].reversed : encodings[encoding];
    return `${source('300 es', [...stored.needs ?? []], 'precision highp float;')}
uniform highp sampler2D map;
uniform vec2 range, picture_size, map_size;
uniform int map_count;
out vec4 color;${tints}
void main() {
    vec2 size = vec2(textureSize(map, 0));
    float texels_a_pixel = max(size.x / picture_size.x, size.y / picture_size.y);
    vec2 place = (gl_FragCoord.xy - 0.5 * picture_size) * texels_a_pixel + 0.5 * size;
    bool inside = place.x >= 0.0 && place.y >= 0.0 && place.x < size.x && place.y < size.y;
    vec4 value = texelFetch(map, ivec2(place), 0);
    vec2 texel = floor(place);
    float depth = ${stored.depth || 'value.x'};
    float shade = clamp((depth - range.x) / (range.y - range.x), 0.0, 1.0);
    color = vec4(mix(vec3(0.08, 0.08, 0.13), vec3(0.98, 0.94, 0.84), shade), 1.0);
    ivec2 tile = ivec2(place / map_size);
    int number = tile.y * int(size.x / map_size.x) + tile.x;
    vec2 within = mod(place, map_size), from_edge = min(within, map_size - within) / texels_a_pixel;
    if (map_count > 1) color.rgb = mix(color.rgb, tints[number % 6], min(from_edge.x, from_edge.y) < 2.0 ? 1.0 : 0.25);
    if (!inside || number >= map_count) color = vec4(0.09, 0.1, 0.11, 1.0);
}`;
};
