import { language } from './language.mjs';
import * as snippets from './snippets.mjs';

export const debug = {
    language,
    needs: { place: snippets.probe_color, point: [snippets.cleared_depth, snippets.probe_inputs] },
    place_color: {
        plain: { bias: snippets.acne_free_bias, text: `
// umbrage_place_color: one channel of a receiver's debug color in one map
fn umbrage_place_color(number: f32, terms: vec4f, filter_terms: vec4f, at: vec3f, slope: vec2f, channel: f32) -> f32 {
    let bias: f32 = umbrage_acne_free_bias(slope, terms.z, terms.w);
    let color: vec3f = umbrage_probe_color(at, vec2f(terms.x, terms.y), bias, number);
    let later: f32 = select(color.z, color.y, channel < 1.5);
    return select(later, color.x, channel < 0.5);
}
` },
        disc: { bias: snippets.acne_free_disc_bias, text: `
// umbrage_place_color: one channel of a receiver's debug color in one map
fn umbrage_place_color(number: f32, terms: vec4f, filter_terms: vec4f, at: vec3f, slope: vec2f, channel: f32) -> f32 {
    let bias: f32 = umbrage_acne_free_disc_bias(slope, filter_terms.y, terms.w);
    let color: vec3f = umbrage_probe_color(at, vec2f(terms.x, terms.y), bias, number);
    let later: f32 = select(color.z, color.y, channel < 1.5);
    return select(later, color.x, channel < 0.5);
}
` },
        hardens: { bias: snippets.acne_free_bias, text: `
// umbrage_place_color: one channel of a receiver's debug color in one map
fn umbrage_place_color(number: f32, terms: vec4f, filter_terms: vec4f, at: vec3f, slope: vec2f, channel: f32) -> f32 {
    let bias: f32 = umbrage_acne_free_bias(slope, 0.5, terms.w);
    let color: vec3f = umbrage_probe_color(at, vec2f(terms.x, terms.y), bias, number);
    let later: f32 = select(color.z, color.y, channel < 1.5);
    return select(later, color.x, channel < 0.5);
}
` },
    },
    lit_at: `
// umbrage_lit_at: 1.0 where a receiver at a distance from the near plane, 0.0 to 1.0, is lit
fn umbrage_lit_at(UMBRAGE_MAP map, terms: vec4f, filter_terms: vec4f, coord: vec2f, distance: f32) -> f32 {
    let depth: f32 = select(1.0 - distance, distance, umbrage_cleared_depth() > 0.5);
    let at: vec3f = vec3f(coord.x, coord.y, depth);
    return select(0.0, 1.0, umbrage_look(map, terms, filter_terms, at, vec2f(0.0, 0.0)) > 0.5);
}
`,
    lit_at_turned: `
// umbrage_lit_at: 1.0 where a receiver at a distance from the near plane, 0.0 to 1.0, is lit
fn umbrage_lit_at(UMBRAGE_MAP map, terms: vec4f, filter_terms: vec4f, coord: vec2f, distance: f32) -> f32 {
    let depth: f32 = select(1.0 - distance, distance, umbrage_cleared_depth() > 0.5);
    let at: vec3f = vec3f(coord.x, coord.y, depth);
    return select(0.0, 1.0, umbrage_look(map, terms, filter_terms, at, vec2f(0.0, 0.0), vec2f(0.5, 0.5)) > 0.5);
}
`,
    reading: `
// umbrage_reading: what a map of known depths is read as, a map_reading's number; 0.0 is right
fn umbrage_reading(UMBRAGE_MAP map, terms: vec4f, filter_terms: vec4f, number: f32) -> f32 {
    let tolerance: f32 = 1.0 / PARTS.0;
    let coarse: f32 = 1.0 / 72.0;
    let own: f32 = number - 8.0 * floor(number * 0.125) + 1.0;
    var met: vec4f = vec4f(0.0, 0.0, 0.0, 0.0);
    var seen: vec3f = vec3f(0.0, 0.0, 0.0);
    for (var block: i32 = 0; block < 4; block++) {
        let row: f32 = select(1.0, 0.0, block < 2);
        let column: f32 = f32(block) - 2.0 * row;
        let coord: vec2f = vec2f(terms.x * (0.25 + 0.5 * column), terms.y * (0.25 + 0.5 * row));
        var found: f32 = 0.0;
        var step_size: f32 = 0.5;
        for (var i: i32 = 0; i < 20; i++) {
            found += umbrage_lit_at(map, terms, filter_terms, coord, found + step_size) * step_size;
            step_size *= 0.5;
        }
        let first: f32 = 8.0 * f32(block);
        let turned: f32 = 8.0 * (column + 2.0 - 2.0 * row);
        let here: f32 = abs(found - (first + own) * (1.0 / 34.0));
        let there: f32 = abs(found - (turned + own) * (1.0 / 34.0));
        let nearest: f32 = clamp(floor(found * 34.0 + 0.5), first + 1.0, first + 8.0);
        let other: f32 = abs(found - nearest * (1.0 / 34.0));
        met +=
            vec4f(select(0.0, 1.0, here <= tolerance), select(0.0, 1.0, here <= coarse),
                  select(0.0, 1.0, there <= coarse), select(0.0, 1.0, other <= coarse));
        let front: f32 = umbrage_lit_at(map, terms, filter_terms, coord, 0.0);
        let back: f32 = umbrage_lit_at(map, terms, filter_terms, coord, 1.0);
        seen += vec3f(select(0.0, 1.0, found > 0.9999), select(0.0, 1.0, found < 0.0001), (1.0 - front) * back);
    }
    var reading: f32 = 7.0;
    reading = select(reading, 4.0, met.w > 3.5);
    reading = select(reading, 3.0, met.z > 3.5);
    reading = select(reading, 6.0, met.y > 3.5);
    reading = select(reading, 2.0, seen.y > 3.5);
    reading = select(reading, 1.0, seen.x > 3.5);
    reading = select(reading, 5.0, seen.z > 3.5);
    return select(reading, 0.0, met.x > 3.5);
}
`,
    layer: `    let layer: f32 = number;
`,
    parts: { moments: 72, depth32f: 262144, rg9: 128, rg10: 256, rg11: 512, rg12: 1024, rg13: 2048, rg14: 4096, rg15: 8192, rg16: 16384, rgb24: 262144, rgb10: 262144, r16: 16384, float_bits: 262144, threejs_rgba: 262144, threejs_rgb: 262144, threejs_rg: 16384, threejs_legacy: 262144, threejs_legacy_repaired: 262144, base255: 262144, base255_repaired: 262144 },
    parts_of_bent: { moments: 72, depth32f: 1024, rg9: 128, rg10: 256, rg11: 512, rg12: 512, rg13: 1024, rg14: 1024, rg15: 1024, rg16: 1024, rgb24: 1024, rgb10: 1024, r16: 1024, float_bits: 1024, threejs_rgba: 1024, threejs_rgb: 1024, threejs_rg: 1024, threejs_legacy: 1024, threejs_legacy_repaired: 1024, base255: 1024, base255_repaired: 1024 },
    maps: {
        one_map: {
            choice: ``,
            channel_color: `
// umbrage_channel_color: one channel of a point's debug color
fn umbrage_channel_color(to_texels: mat4x4f, planes: mat4x4f, terms: vec4f, filter_terms: vec4f, world: vec3f,
                         normal: vec3f, channel: f32) -> f32 {
    let at: vec3f = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world));
    return umbrage_place_color(0.0, terms, filter_terms, at, umbrage_receiver_slope(planes, normal, world), channel);
}
`,
            point_color: `
// umbrage_point_color: debug color of a point of the world
fn umbrage_point_color(to_texels: mat4x4f, planes: mat4x4f, terms: vec4f, filter_terms: vec4f, world: vec3f,
                       normal: vec3f) -> vec3f {
    let color: vec3f =
        vec3f(umbrage_channel_color(to_texels, planes, terms, filter_terms, world, normal, 0.0),
              umbrage_channel_color(to_texels, planes, terms, filter_terms, world, normal, 1.0),
              umbrage_channel_color(to_texels, planes, terms, filter_terms, world, normal, 2.0));
    return umbrage_probe_inputs(color, world, normal);
}
`,
        },
        cascaded_maps: {
            choice: `    let origin: vec2f = umbrage_cascade_tile(number, vec2f(terms.x, terms.y));
`,
            channel_color: `
// umbrage_channel_color: one channel of a point's debug color
fn umbrage_channel_color(rotation: mat4x4f, scales: mat4x4f, offsets: mat4x4f, blending: vec4f, terms: vec4f,
                         filter_terms: vec4f, world: vec3f, normal: vec3f, channel: f32) -> f32 {
    let turned: vec4f = umbrage_shadow_coordinate(rotation, world);
    let across: vec4f = umbrage_shadow_coordinate(rotation, normal);
    let light: vec3f = vec3f(turned.x, turned.y, turned.z);
    let normal_there: vec3f = vec3f(across.x, across.y, across.z);
    let size: vec2f = vec2f(terms.x, terms.y);
    let found: vec4f = umbrage_cascade_by_projection(light, scales, offsets, size, terms.z);
    let number: f32 = min(found.w, blending.y);
    let scale: vec4f = umbrage_cascade_column(scales, number);
    var layer: f32 = number;
    let slope: vec2f = umbrage_cascade_slope(normal_there, scale);
    let nearer: f32 = umbrage_place_color(layer, terms, filter_terms, vec3f(found.x, found.y, found.z), slope, channel);
    let border: f32 = umbrage_cascade_border_fade(vec2f(found.x, found.y), size, terms.z, blending.x);
    var weight: f32 = select(0.0, border, blending.x > 0.0 && found.w <= blending.y);
    let last: bool = number >= blending.y;
    let next: f32 = min(number + 1.0, blending.y);
    let next_scale: vec4f = umbrage_cascade_column(scales, next);
    let at: vec3f = umbrage_cascade_coordinate(light, next_scale, umbrage_cascade_column(offsets, next));
    layer = next;

    let fade: f32 = umbrage_cascade_border_fade(vec2f(at.x, at.y), size, terms.z, blending.x);
    let held: f32 = select(0.0, 1.0 - fade, umbrage_inside_cascade(at, size, terms.z));
    weight = select(min(weight, held), weight, last);
    var farther: f32 = 1.0;
    if (weight > 0.0 && !last) {
        farther =
            umbrage_place_color(layer, terms, filter_terms, at, umbrage_cascade_slope(normal_there, next_scale),
                                channel);
    }
    return select(nearer, umbrage_blend_cascades(nearer, farther, weight), weight > 0.0);
}
`,
            point_color: `
// umbrage_point_color: debug color of a point of the world
fn umbrage_point_color(rotation: mat4x4f, scales: mat4x4f, offsets: mat4x4f, blending: vec4f, terms: vec4f,
                       filter_terms: vec4f, world: vec3f, normal: vec3f) -> vec3f {
    let color: vec3f =
        vec3f(umbrage_channel_color(rotation, scales, offsets, blending, terms, filter_terms, world, normal, 0.0),
              umbrage_channel_color(rotation, scales, offsets, blending, terms, filter_terms, world, normal, 1.0),
              umbrage_channel_color(rotation, scales, offsets, blending, terms, filter_terms, world, normal, 2.0));
    return umbrage_probe_inputs(color, world, normal);
}
`,
        },
        cascaded_maps_8: {
            choice: `    let origin: vec2f = umbrage_cascade_tile(number, vec2f(terms.x, terms.y));
`,
            channel_color: `
// umbrage_channel_color: one channel of a point's debug color
fn umbrage_channel_color(rotation: mat4x4f, scales: mat4x4f, offsets: mat4x4f, farther_scales: mat4x4f,
                         farther_offsets: mat4x4f, blending: vec4f, terms: vec4f, filter_terms: vec4f, world: vec3f,
                         normal: vec3f, channel: f32) -> f32 {
    let turned: vec4f = umbrage_shadow_coordinate(rotation, world);
    let across: vec4f = umbrage_shadow_coordinate(rotation, normal);
    let light: vec3f = vec3f(turned.x, turned.y, turned.z);
    let normal_there: vec3f = vec3f(across.x, across.y, across.z);
    let size: vec2f = vec2f(terms.x, terms.y);
    let found: vec4f =
        umbrage_cascade_by_projection_8(light, scales, offsets, farther_scales, farther_offsets, size, terms.z);
    let number: f32 = min(found.w, blending.y);
    let scale: vec4f = umbrage_cascade_column_8(scales, farther_scales, number);
    var layer: f32 = number;
    let slope: vec2f = umbrage_cascade_slope(normal_there, scale);
    let nearer: f32 = umbrage_place_color(layer, terms, filter_terms, vec3f(found.x, found.y, found.z), slope, channel);
    let border: f32 = umbrage_cascade_border_fade(vec2f(found.x, found.y), size, terms.z, blending.x);
    var weight: f32 = select(0.0, border, blending.x > 0.0 && found.w <= blending.y);
    let last: bool = number >= blending.y;
    let next: f32 = min(number + 1.0, blending.y);
    let next_scale: vec4f = umbrage_cascade_column_8(scales, farther_scales, next);
    let at: vec3f =
        umbrage_cascade_coordinate(light, next_scale, umbrage_cascade_column_8(offsets, farther_offsets, next));
    layer = next;

    let fade: f32 = umbrage_cascade_border_fade(vec2f(at.x, at.y), size, terms.z, blending.x);
    let held: f32 = select(0.0, 1.0 - fade, umbrage_inside_cascade(at, size, terms.z));
    weight = select(min(weight, held), weight, last);
    var farther: f32 = 1.0;
    if (weight > 0.0 && !last) {
        farther =
            umbrage_place_color(layer, terms, filter_terms, at, umbrage_cascade_slope(normal_there, next_scale),
                                channel);
    }
    return select(nearer, umbrage_blend_cascades(nearer, farther, weight), weight > 0.0);
}
`,
            point_color: `
// umbrage_point_color: debug color of a point of the world
fn umbrage_point_color(rotation: mat4x4f, scales: mat4x4f, offsets: mat4x4f, farther_scales: mat4x4f,
                       farther_offsets: mat4x4f, blending: vec4f, terms: vec4f, filter_terms: vec4f, world: vec3f,
                       normal: vec3f) -> vec3f {
    let color: vec3f =
        vec3f(umbrage_channel_color(rotation, scales, offsets, farther_scales, farther_offsets, blending, terms,
                                    filter_terms, world, normal, 0.0),
              umbrage_channel_color(rotation, scales, offsets, farther_scales, farther_offsets, blending, terms,
                                    filter_terms, world, normal, 1.0),
              umbrage_channel_color(rotation, scales, offsets, farther_scales, farther_offsets, blending, terms,
                                    filter_terms, world, normal, 2.0));
    return umbrage_probe_inputs(color, world, normal);
}
`,
        },
        warped_maps: {
            choice: `    let origin: vec2f = umbrage_cascade_tile(number, vec2f(terms.x, terms.y));
`,
            channel_color: `
// umbrage_channel_color: one channel of a point's debug color
fn umbrage_channel_color(to_texels_0: mat4x4f, to_texels_1: mat4x4f, to_texels_2: mat4x4f, to_texels_3: mat4x4f,
                         planes_0: mat4x4f, planes_1: mat4x4f, planes_2: mat4x4f, planes_3: mat4x4f, fades: mat4x4f,
                         ahead: vec4f, ends: vec4f, terms: vec4f, filter_terms: vec4f, world: vec3f, normal: vec3f,
                         channel: f32) -> f32 {
    let depth: f32 = ahead.x * world.x + ahead.y * world.y + ahead.z * world.z + ahead.w;
    var number: f32 = umbrage_cascade_by_depth(depth, vec3f(ends.x, ends.y, ends.z));
    let own: vec4f = umbrage_cascade_column(fades, number);
    let weight: f32 = umbrage_cascade_fade(depth, own.x, own.y);
    var to_texels: mat4x4f = to_texels_0;
    var planes: mat4x4f = planes_0;
    if (number > 0.5) {
        to_texels = to_texels_1;
        planes = planes_1;
    }
    if (number > 1.5) {
        to_texels = to_texels_2;
        planes = planes_2;
    }
    if (number > 2.5) {
        to_texels = to_texels_3;
        planes = planes_3;
    }
    var layer: f32 = number;
    let nearer: f32 =
        umbrage_place_color(layer, terms, filter_terms,
                            umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world)),
                            umbrage_receiver_slope(planes, normal, world), channel);
    let last: bool = number >= ends.w;
    number = min(number + 1.0, ends.w);
    if (number > 0.5) {
        to_texels = to_texels_1;
        planes = planes_1;
    }
    if (number > 1.5) {
        to_texels = to_texels_2;
        planes = planes_2;
    }
    if (number > 2.5) {
        to_texels = to_texels_3;
        planes = planes_3;
    }
    layer = number;
    var farther: f32 = 1.0;
    if (weight > 0.0 && !last) {
        farther =
            umbrage_place_color(layer, terms, filter_terms,
                                umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world)),
                                umbrage_receiver_slope(planes, normal, world), channel);
    }
    return select(nearer, umbrage_blend_cascades(nearer, farther, weight), weight > 0.0);
}
`,
            point_color: `
// umbrage_point_color: debug color of a point of the world
fn umbrage_point_color(to_texels_0: mat4x4f, to_texels_1: mat4x4f, to_texels_2: mat4x4f, to_texels_3: mat4x4f,
                       planes_0: mat4x4f, planes_1: mat4x4f, planes_2: mat4x4f, planes_3: mat4x4f, fades: mat4x4f,
                       ahead: vec4f, ends: vec4f, terms: vec4f, filter_terms: vec4f, world: vec3f,
                       normal: vec3f) -> vec3f {
    let color: vec3f =
        vec3f(umbrage_channel_color(to_texels_0, to_texels_1, to_texels_2, to_texels_3, planes_0, planes_1, planes_2,
                                    planes_3, fades, ahead, ends, terms, filter_terms, world, normal, 0.0),
              umbrage_channel_color(to_texels_0, to_texels_1, to_texels_2, to_texels_3, planes_0, planes_1, planes_2,
                                    planes_3, fades, ahead, ends, terms, filter_terms, world, normal, 1.0),
              umbrage_channel_color(to_texels_0, to_texels_1, to_texels_2, to_texels_3, planes_0, planes_1, planes_2,
                                    planes_3, fades, ahead, ends, terms, filter_terms, world, normal, 2.0));
    return umbrage_probe_inputs(color, world, normal);
}
`,
        },
        adaptive_maps: {
            choice: `    let origin: vec2f = umbrage_page_tile(number, terms.x);
`,
            channel_color: `
// umbrage_channel_color: one channel of a point's debug color
fn umbrage_channel_color(to_root: mat4x4f, planes: mat4x4f, cells_0: mat4x4f, cells_1: mat4x4f, cells_2: mat4x4f,
                         cells_3: mat4x4f, cells_4: mat4x4f, cells_5: mat4x4f, cells_6: mat4x4f, cells_7: mat4x4f,
                         pages: vec4f, terms: vec4f, filter_terms: vec4f, world: vec3f, normal: vec3f,
                         channel: f32) -> f32 {
    let in_root: vec4f = umbrage_shadow_coordinate(to_root, world);
    let inside: bool = in_root.x >= 1.0 && in_root.x < 2.0 && in_root.y >= 1.0 && in_root.y < 2.0;
    let coord: vec2f = select(vec2f(1.0, 1.0), vec2f(in_root.x, in_root.y), inside);
    let cell: vec2f = floor(coord * 16.0 - 16.0);
    let right: f32 = floor(cell.x * 0.125);
    let column: f32 = cell.y * 2.0 + right;
    let a: vec4f = umbrage_cascade_column_8(cells_0, cells_1, column);
    let b: vec4f = umbrage_cascade_column_8(cells_2, cells_3, column - 8.0);
    let c: vec4f = umbrage_cascade_column_8(cells_4, cells_5, column - 16.0);
    let d: vec4f = umbrage_cascade_column_8(cells_6, cells_7, column - 24.0);
    let low: vec4f = select(b, a, column < 7.5);
    let high: vec4f = select(d, c, column < 23.5);
    let eight: vec4f = select(high, low, column < 15.5);
    let along: f32 = cell.x - right * 8.0;
    let pair: f32 = floor(along * 0.5);
    let left_two: f32 = select(eight.y, eight.x, pair < 0.5);
    let right_two: f32 = select(eight.w, eight.z, pair < 2.5);
    let two: f32 = select(right_two, left_two, pair < 1.5);
    let second: f32 = floor(two * (1.0 / 1024.0));
    let code: f32 = select(second, two - second * 1024.0, along - pair * 2.0 < 0.5);
    let before: f32 = floor(code * (1.0 / 64.0));
    let number: f32 = code - before * 64.0;
    let across: f32 = before + 1.0;
    let place: vec2f = coord * across;
    let within: vec2f = (place - floor(place)) * pages.x + pages.y;
    let at: vec2f = select(vec2f(32768.0, 32768.0), within, inside);
    let steep: vec2f = umbrage_receiver_slope(planes, normal, world) * (16.0 / across);
    let slope: vec2f = vec2f(umbrage_clamp_slope(steep.x), umbrage_clamp_slope(steep.y));
    let layer: f32 = number;
    return umbrage_place_color(layer, terms, filter_terms, vec3f(at.x, at.y, in_root.z), slope, channel);
}
`,
            point_color: `
// umbrage_point_color: debug color of a point of the world
fn umbrage_point_color(to_root: mat4x4f, planes: mat4x4f, cells_0: mat4x4f, cells_1: mat4x4f, cells_2: mat4x4f,
                       cells_3: mat4x4f, cells_4: mat4x4f, cells_5: mat4x4f, cells_6: mat4x4f, cells_7: mat4x4f,
                       pages: vec4f, terms: vec4f, filter_terms: vec4f, world: vec3f, normal: vec3f) -> vec3f {
    let color: vec3f =
        vec3f(umbrage_channel_color(to_root, planes, cells_0, cells_1, cells_2, cells_3, cells_4, cells_5, cells_6,
                                    cells_7, pages, terms, filter_terms, world, normal, 0.0),
              umbrage_channel_color(to_root, planes, cells_0, cells_1, cells_2, cells_3, cells_4, cells_5, cells_6,
                                    cells_7, pages, terms, filter_terms, world, normal, 1.0),
              umbrage_channel_color(to_root, planes, cells_0, cells_1, cells_2, cells_3, cells_4, cells_5, cells_6,
                                    cells_7, pages, terms, filter_terms, world, normal, 2.0));
    return umbrage_probe_inputs(color, world, normal);
}
`,
        },
        cube_maps: {
            choice: `    let origin: vec2f = umbrage_cube_tile(number, terms.x);
`,
            channel_color: `
// umbrage_channel_color: one channel of a point's debug color
fn umbrage_channel_color(position: vec4f, to_texels: mat4x4f, planes: mat4x4f, terms: vec4f, filter_terms: vec4f,
                         world: vec3f, normal: vec3f, channel: f32) -> f32 {
    let way: vec3f = world - vec3f(position.x, position.y, position.z);
    let face: f32 = umbrage_cube_face(way);
    let there: vec3f = umbrage_cube_face_point(face, way);
    let across: vec3f = umbrage_cube_face_point(face, normal);
    let at: vec3f = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, there));
    let layer: f32 = face;
    return umbrage_place_color(layer, terms, filter_terms, at, umbrage_receiver_slope(planes, across, there), channel);
}
`,
            point_color: `
// umbrage_point_color: debug color of a point of the world
fn umbrage_point_color(position: vec4f, to_texels: mat4x4f, planes: mat4x4f, terms: vec4f, filter_terms: vec4f,
                       world: vec3f, normal: vec3f) -> vec3f {
    let color: vec3f =
        vec3f(umbrage_channel_color(position, to_texels, planes, terms, filter_terms, world, normal, 0.0),
              umbrage_channel_color(position, to_texels, planes, terms, filter_terms, world, normal, 1.0),
              umbrage_channel_color(position, to_texels, planes, terms, filter_terms, world, normal, 2.0));
    return umbrage_probe_inputs(color, world, normal);
}
`,
        },
        tetrahedron_map: {
            choice: ``,
            channel_color: `
// umbrage_channel_color: one channel of a point's debug color
fn umbrage_channel_color(position: vec4f, to_texels: mat4x4f, planes: mat4x4f, terms: vec4f, filter_terms: vec4f,
                         world: vec3f, normal: vec3f, channel: f32) -> f32 {
    let way: vec3f = world - vec3f(position.x, position.y, position.z);
    let face: f32 = umbrage_tetrahedron_face(way);
    let there: vec3f = umbrage_tetrahedron_face_point(face, way);
    let across: vec3f = umbrage_tetrahedron_face_point(face, normal);
    let on_first: vec3f = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, there));
    let at: vec2f = umbrage_tetrahedron_turned(face, vec2f(on_first.x, on_first.y)) + position.w;
    let slope: vec2f = umbrage_tetrahedron_turned(face, umbrage_receiver_slope(planes, across, there));
    return umbrage_place_color(0.0, terms, filter_terms, vec3f(at.x, at.y, on_first.z), slope, channel);
}
`,
            point_color: `
// umbrage_point_color: debug color of a point of the world
fn umbrage_point_color(position: vec4f, to_texels: mat4x4f, planes: mat4x4f, terms: vec4f, filter_terms: vec4f,
                       world: vec3f, normal: vec3f) -> vec3f {
    let color: vec3f =
        vec3f(umbrage_channel_color(position, to_texels, planes, terms, filter_terms, world, normal, 0.0),
              umbrage_channel_color(position, to_texels, planes, terms, filter_terms, world, normal, 1.0),
              umbrage_channel_color(position, to_texels, planes, terms, filter_terms, world, normal, 2.0));
    return umbrage_probe_inputs(color, world, normal);
}
`,
        },
        paraboloid_maps: {
            choice: `    let origin: vec2f = umbrage_cascade_tile(number, vec2f(terms.x, terms.y));
`,
            channel_color: `
// umbrage_channel_color: one channel of a point's debug color
fn umbrage_channel_color(position: vec4f, halves: vec4f, terms: vec4f, filter_terms: vec4f, world: vec3f, normal: vec3f,
                         channel: f32) -> f32 {
    let way: vec3f = world - vec3f(position.x, position.y, position.z);
    let found: vec3f = umbrage_dual_paraboloid_coordinate(way);
    let at: vec2f = vec2f(found.x, found.y) * halves.x + halves.y;
    let depth: f32 = umbrage_distance_depth(way, position.w) + halves.w;
    let slope: vec2f = umbrage_dual_paraboloid_slope(way, normal, halves.z);
    let layer: f32 = found.z;
    return umbrage_place_color(layer, terms, filter_terms, vec3f(at.x, at.y, depth), slope, channel);
}
`,
            point_color: `
// umbrage_point_color: debug color of a point of the world
fn umbrage_point_color(position: vec4f, halves: vec4f, terms: vec4f, filter_terms: vec4f, world: vec3f,
                       normal: vec3f) -> vec3f {
    let color: vec3f =
        vec3f(umbrage_channel_color(position, halves, terms, filter_terms, world, normal, 0.0),
              umbrage_channel_color(position, halves, terms, filter_terms, world, normal, 1.0),
              umbrage_channel_color(position, halves, terms, filter_terms, world, normal, 2.0));
    return umbrage_probe_inputs(color, world, normal);
}
`,
        },
    },
};
