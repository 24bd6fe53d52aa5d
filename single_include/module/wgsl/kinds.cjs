const { language } = require('./language.cjs');
const snippets = require('./snippets.cjs');

const one_map = {
    name: "one_map", grid: [1, 1], outside: "bordered", bends: false,
    fields: [{ name: "to_texels", matrix: true }, { name: "planes", matrix: true }],
    needs: [snippets.project_coordinate, snippets.shadow_coordinate, snippets.receiver_slope],
    text: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
fn umbrage_shadow(UMBRAGE_MAP map, to_texels: mat4x4f, planes: mat4x4f, terms: vec4f, filter_terms: vec4f, world: vec3f,
                  normal: vec3f, pixel: vec2f) -> f32 {
    let at: vec3f = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world));
    return umbrage_look(map, terms, filter_terms, at, umbrage_receiver_slope(planes, normal, world), pixel);
}
`,
};
const cascaded_maps = {
    name: "cascaded_maps", grid: [2, 2], outside: "bordered", bends: false,
    fields: [{ name: "rotation", matrix: true }, { name: "scales", matrix: true }, { name: "offsets", matrix: true }, { name: "blending", matrix: false }],
    needs: [snippets.shadow_coordinate, snippets.cascade_by_projection, snippets.cascade_column, snippets.cascade_slope, snippets.cascade_coordinate, snippets.inside_cascade, snippets.cascade_border_fade, snippets.blend_cascades, snippets.cascade_tile],
    text: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
fn umbrage_shadow(UMBRAGE_MAP map, rotation: mat4x4f, scales: mat4x4f, offsets: mat4x4f, blending: vec4f, terms: vec4f,
                  filter_terms: vec4f, world: vec3f, normal: vec3f, pixel: vec2f) -> f32 {
    let turned: vec4f = umbrage_shadow_coordinate(rotation, world);
    let across: vec4f = umbrage_shadow_coordinate(rotation, normal);
    let light: vec3f = vec3f(turned.x, turned.y, turned.z);
    let normal_there: vec3f = vec3f(across.x, across.y, across.z);
    let size: vec2f = vec2f(terms.x, terms.y);
    let found: vec4f = umbrage_cascade_by_projection(light, scales, offsets, size, terms.z);
    let number: f32 = min(found.w, blending.y);
    let scale: vec4f = umbrage_cascade_column(scales, number);
    var origin: vec2f = umbrage_cascade_tile(number, vec2f(terms.x, terms.y));
    let slope: vec2f = umbrage_cascade_slope(normal_there, scale);
    let nearer: f32 = umbrage_look(map, terms, filter_terms, vec3f(found.x, found.y, found.z), slope, pixel);
    let border: f32 = umbrage_cascade_border_fade(vec2f(found.x, found.y), size, terms.z, blending.x);
    var weight: f32 = select(0.0, border, blending.x > 0.0 && found.w <= blending.y);
    let last: bool = number >= blending.y;
    let next: f32 = min(number + 1.0, blending.y);
    let next_scale: vec4f = umbrage_cascade_column(scales, next);
    let at: vec3f = umbrage_cascade_coordinate(light, next_scale, umbrage_cascade_column(offsets, next));
    origin = umbrage_cascade_tile(next, vec2f(terms.x, terms.y));

    let fade: f32 = umbrage_cascade_border_fade(vec2f(at.x, at.y), size, terms.z, blending.x);
    let held: f32 = select(0.0, 1.0 - fade, umbrage_inside_cascade(at, size, terms.z));
    weight = select(min(weight, held), weight, last);
    var farther: f32 = 1.0;
    if (weight > 0.0 && !last) {
        farther = umbrage_look(map, terms, filter_terms, at, umbrage_cascade_slope(normal_there, next_scale), pixel);
    }
    return select(nearer, umbrage_blend_cascades(nearer, farther, weight), weight > 0.0);
}
`,
    of_layers: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
fn umbrage_shadow(UMBRAGE_MAP map, rotation: mat4x4f, scales: mat4x4f, offsets: mat4x4f, blending: vec4f, terms: vec4f,
                  filter_terms: vec4f, world: vec3f, normal: vec3f, pixel: vec2f) -> f32 {
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
    let nearer: f32 = umbrage_look(map, terms, filter_terms, vec3f(found.x, found.y, found.z), slope, pixel);
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
        farther = umbrage_look(map, terms, filter_terms, at, umbrage_cascade_slope(normal_there, next_scale), pixel);
    }
    return select(nearer, umbrage_blend_cascades(nearer, farther, weight), weight > 0.0);
}
`,
};
const cascaded_maps_8 = {
    name: "cascaded_maps_8", grid: [2, 4], outside: "bordered", bends: false,
    fields: [{ name: "rotation", matrix: true }, { name: "scales", matrix: true }, { name: "offsets", matrix: true }, { name: "farther_scales", matrix: true }, { name: "farther_offsets", matrix: true }, { name: "blending", matrix: false }],
    needs: [snippets.shadow_coordinate, snippets.cascade_by_projection_8, snippets.cascade_column_8, snippets.cascade_slope, snippets.cascade_coordinate, snippets.inside_cascade, snippets.cascade_border_fade, snippets.blend_cascades, snippets.cascade_tile],
    text: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
fn umbrage_shadow(UMBRAGE_MAP map, rotation: mat4x4f, scales: mat4x4f, offsets: mat4x4f, farther_scales: mat4x4f,
                  farther_offsets: mat4x4f, blending: vec4f, terms: vec4f, filter_terms: vec4f, world: vec3f,
                  normal: vec3f, pixel: vec2f) -> f32 {
    let turned: vec4f = umbrage_shadow_coordinate(rotation, world);
    let across: vec4f = umbrage_shadow_coordinate(rotation, normal);
    let light: vec3f = vec3f(turned.x, turned.y, turned.z);
    let normal_there: vec3f = vec3f(across.x, across.y, across.z);
    let size: vec2f = vec2f(terms.x, terms.y);
    let found: vec4f =
        umbrage_cascade_by_projection_8(light, scales, offsets, farther_scales, farther_offsets, size, terms.z);
    let number: f32 = min(found.w, blending.y);
    let scale: vec4f = umbrage_cascade_column_8(scales, farther_scales, number);
    var origin: vec2f = umbrage_cascade_tile(number, vec2f(terms.x, terms.y));
    let slope: vec2f = umbrage_cascade_slope(normal_there, scale);
    let nearer: f32 = umbrage_look(map, terms, filter_terms, vec3f(found.x, found.y, found.z), slope, pixel);
    let border: f32 = umbrage_cascade_border_fade(vec2f(found.x, found.y), size, terms.z, blending.x);
    var weight: f32 = select(0.0, border, blending.x > 0.0 && found.w <= blending.y);
    let last: bool = number >= blending.y;
    let next: f32 = min(number + 1.0, blending.y);
    let next_scale: vec4f = umbrage_cascade_column_8(scales, farther_scales, next);
    let at: vec3f =
        umbrage_cascade_coordinate(light, next_scale, umbrage_cascade_column_8(offsets, farther_offsets, next));
    origin = umbrage_cascade_tile(next, vec2f(terms.x, terms.y));

    let fade: f32 = umbrage_cascade_border_fade(vec2f(at.x, at.y), size, terms.z, blending.x);
    let held: f32 = select(0.0, 1.0 - fade, umbrage_inside_cascade(at, size, terms.z));
    weight = select(min(weight, held), weight, last);
    var farther: f32 = 1.0;
    if (weight > 0.0 && !last) {
        farther = umbrage_look(map, terms, filter_terms, at, umbrage_cascade_slope(normal_there, next_scale), pixel);
    }
    return select(nearer, umbrage_blend_cascades(nearer, farther, weight), weight > 0.0);
}
`,
    of_layers: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
fn umbrage_shadow(UMBRAGE_MAP map, rotation: mat4x4f, scales: mat4x4f, offsets: mat4x4f, farther_scales: mat4x4f,
                  farther_offsets: mat4x4f, blending: vec4f, terms: vec4f, filter_terms: vec4f, world: vec3f,
                  normal: vec3f, pixel: vec2f) -> f32 {
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
    let nearer: f32 = umbrage_look(map, terms, filter_terms, vec3f(found.x, found.y, found.z), slope, pixel);
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
        farther = umbrage_look(map, terms, filter_terms, at, umbrage_cascade_slope(normal_there, next_scale), pixel);
    }
    return select(nearer, umbrage_blend_cascades(nearer, farther, weight), weight > 0.0);
}
`,
};
const warped_maps = {
    name: "warped_maps", grid: [2, 2], outside: "bordered", bends: false,
    fields: [{ name: "to_texels_0", matrix: true }, { name: "to_texels_1", matrix: true }, { name: "to_texels_2", matrix: true }, { name: "to_texels_3", matrix: true }, { name: "planes_0", matrix: true }, { name: "planes_1", matrix: true }, { name: "planes_2", matrix: true }, { name: "planes_3", matrix: true }, { name: "fades", matrix: true }, { name: "ahead", matrix: false }, { name: "ends", matrix: false }],
    needs: [snippets.shadow_coordinate, snippets.project_coordinate, snippets.receiver_slope, snippets.cascade_by_depth, snippets.cascade_column, snippets.cascade_fade, snippets.blend_cascades, snippets.cascade_tile],
    text: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
fn umbrage_shadow(UMBRAGE_MAP map, to_texels_0: mat4x4f, to_texels_1: mat4x4f, to_texels_2: mat4x4f,
                  to_texels_3: mat4x4f, planes_0: mat4x4f, planes_1: mat4x4f, planes_2: mat4x4f, planes_3: mat4x4f,
                  fades: mat4x4f, ahead: vec4f, ends: vec4f, terms: vec4f, filter_terms: vec4f, world: vec3f,
                  normal: vec3f, pixel: vec2f) -> f32 {
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
    var origin: vec2f = umbrage_cascade_tile(number, vec2f(terms.x, terms.y));
    let nearer: f32 =
        umbrage_look(map, terms, filter_terms, umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world)),
                     umbrage_receiver_slope(planes, normal, world), pixel);
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
    origin = umbrage_cascade_tile(number, vec2f(terms.x, terms.y));
    var farther: f32 = 1.0;
    if (weight > 0.0 && !last) {
        farther =
            umbrage_look(map, terms, filter_terms,
                         umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world)),
                         umbrage_receiver_slope(planes, normal, world), pixel);
    }
    return select(nearer, umbrage_blend_cascades(nearer, farther, weight), weight > 0.0);
}
`,
    of_layers: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
fn umbrage_shadow(UMBRAGE_MAP map, to_texels_0: mat4x4f, to_texels_1: mat4x4f, to_texels_2: mat4x4f,
                  to_texels_3: mat4x4f, planes_0: mat4x4f, planes_1: mat4x4f, planes_2: mat4x4f, planes_3: mat4x4f,
                  fades: mat4x4f, ahead: vec4f, ends: vec4f, terms: vec4f, filter_terms: vec4f, world: vec3f,
                  normal: vec3f, pixel: vec2f) -> f32 {
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
        umbrage_look(map, terms, filter_terms, umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world)),
                     umbrage_receiver_slope(planes, normal, world), pixel);
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
            umbrage_look(map, terms, filter_terms,
                         umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world)),
                         umbrage_receiver_slope(planes, normal, world), pixel);
    }
    return select(nearer, umbrage_blend_cascades(nearer, farther, weight), weight > 0.0);
}
`,
};
const adaptive_maps = {
    name: "adaptive_maps", grid: [8, 8], outside: "clamped", bends: false,
    fields: [{ name: "to_root", matrix: true }, { name: "planes", matrix: true }, { name: "cells_0", matrix: true }, { name: "cells_1", matrix: true }, { name: "cells_2", matrix: true }, { name: "cells_3", matrix: true }, { name: "cells_4", matrix: true }, { name: "cells_5", matrix: true }, { name: "cells_6", matrix: true }, { name: "cells_7", matrix: true }, { name: "pages", matrix: false }],
    needs: [snippets.shadow_coordinate, snippets.cascade_column_8, snippets.receiver_slope, snippets.clamp_slope, snippets.page_tile],
    text: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
fn umbrage_shadow(UMBRAGE_MAP map, to_root: mat4x4f, planes: mat4x4f, cells_0: mat4x4f, cells_1: mat4x4f,
                  cells_2: mat4x4f, cells_3: mat4x4f, cells_4: mat4x4f, cells_5: mat4x4f, cells_6: mat4x4f,
                  cells_7: mat4x4f, pages: vec4f, terms: vec4f, filter_terms: vec4f, world: vec3f, normal: vec3f,
                  pixel: vec2f) -> f32 {
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
    let origin: vec2f = umbrage_page_tile(number, terms.x);
    return umbrage_look(map, terms, filter_terms, vec3f(at.x, at.y, in_root.z), slope, pixel);
}
`,
    of_layers: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
fn umbrage_shadow(UMBRAGE_MAP map, to_root: mat4x4f, planes: mat4x4f, cells_0: mat4x4f, cells_1: mat4x4f,
                  cells_2: mat4x4f, cells_3: mat4x4f, cells_4: mat4x4f, cells_5: mat4x4f, cells_6: mat4x4f,
                  cells_7: mat4x4f, pages: vec4f, terms: vec4f, filter_terms: vec4f, world: vec3f, normal: vec3f,
                  pixel: vec2f) -> f32 {
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
    return umbrage_look(map, terms, filter_terms, vec3f(at.x, at.y, in_root.z), slope, pixel);
}
`,
};
const cube_maps = {
    name: "cube_maps", grid: [3, 2], outside: "clamped", bends: false,
    fields: [{ name: "position", matrix: false }, { name: "to_texels", matrix: true }, { name: "planes", matrix: true }],
    needs: [snippets.cube_face, snippets.cube_face_point, snippets.project_coordinate, snippets.shadow_coordinate, snippets.receiver_slope, snippets.cube_tile],
    text: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
fn umbrage_shadow(UMBRAGE_MAP map, position: vec4f, to_texels: mat4x4f, planes: mat4x4f, terms: vec4f,
                  filter_terms: vec4f, world: vec3f, normal: vec3f, pixel: vec2f) -> f32 {
    let way: vec3f = world - vec3f(position.x, position.y, position.z);
    let face: f32 = umbrage_cube_face(way);
    let there: vec3f = umbrage_cube_face_point(face, way);
    let across: vec3f = umbrage_cube_face_point(face, normal);
    let at: vec3f = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, there));
    let origin: vec2f = umbrage_cube_tile(face, terms.x);
    return umbrage_look(map, terms, filter_terms, at, umbrage_receiver_slope(planes, across, there), pixel);
}
`,
    of_layers: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
fn umbrage_shadow(UMBRAGE_MAP map, position: vec4f, to_texels: mat4x4f, planes: mat4x4f, terms: vec4f,
                  filter_terms: vec4f, world: vec3f, normal: vec3f, pixel: vec2f) -> f32 {
    let way: vec3f = world - vec3f(position.x, position.y, position.z);
    let face: f32 = umbrage_cube_face(way);
    let there: vec3f = umbrage_cube_face_point(face, way);
    let across: vec3f = umbrage_cube_face_point(face, normal);
    let at: vec3f = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, there));
    let layer: f32 = face;
    return umbrage_look(map, terms, filter_terms, at, umbrage_receiver_slope(planes, across, there), pixel);
}
`,
};
const tetrahedron_map = {
    name: "tetrahedron_map", grid: [1, 1], outside: "clamped", bends: false,
    fields: [{ name: "position", matrix: false }, { name: "to_texels", matrix: true }, { name: "planes", matrix: true }],
    needs: [snippets.tetrahedron_face, snippets.tetrahedron_face_point, snippets.tetrahedron_turned, snippets.project_coordinate, snippets.shadow_coordinate, snippets.receiver_slope],
    text: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
fn umbrage_shadow(UMBRAGE_MAP map, position: vec4f, to_texels: mat4x4f, planes: mat4x4f, terms: vec4f,
                  filter_terms: vec4f, world: vec3f, normal: vec3f, pixel: vec2f) -> f32 {
    let way: vec3f = world - vec3f(position.x, position.y, position.z);
    let face: f32 = umbrage_tetrahedron_face(way);
    let there: vec3f = umbrage_tetrahedron_face_point(face, way);
    let across: vec3f = umbrage_tetrahedron_face_point(face, normal);
    let on_first: vec3f = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, there));
    let at: vec2f = umbrage_tetrahedron_turned(face, vec2f(on_first.x, on_first.y)) + position.w;
    let slope: vec2f = umbrage_tetrahedron_turned(face, umbrage_receiver_slope(planes, across, there));
    return umbrage_look(map, terms, filter_terms, vec3f(at.x, at.y, on_first.z), slope, pixel);
}
`,
};
const paraboloid_maps = {
    name: "paraboloid_maps", grid: [2, 1], outside: "clamped", bends: true,
    fields: [{ name: "position", matrix: false }, { name: "halves", matrix: false }],
    needs: [snippets.dual_paraboloid_coordinate, snippets.distance_depth, snippets.dual_paraboloid_slope, snippets.cascade_tile],
    text: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
fn umbrage_shadow(UMBRAGE_MAP map, position: vec4f, halves: vec4f, terms: vec4f, filter_terms: vec4f, world: vec3f,
                  normal: vec3f, pixel: vec2f) -> f32 {
    let way: vec3f = world - vec3f(position.x, position.y, position.z);
    let found: vec3f = umbrage_dual_paraboloid_coordinate(way);
    let at: vec2f = vec2f(found.x, found.y) * halves.x + halves.y;
    let depth: f32 = umbrage_distance_depth(way, position.w) + halves.w;
    let slope: vec2f = umbrage_dual_paraboloid_slope(way, normal, halves.z);
    let origin: vec2f = umbrage_cascade_tile(found.z, vec2f(terms.x, terms.y));
    return umbrage_look(map, terms, filter_terms, vec3f(at.x, at.y, depth), slope, pixel);
}
`,
    of_layers: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
fn umbrage_shadow(UMBRAGE_MAP map, position: vec4f, halves: vec4f, terms: vec4f, filter_terms: vec4f, world: vec3f,
                  normal: vec3f, pixel: vec2f) -> f32 {
    let way: vec3f = world - vec3f(position.x, position.y, position.z);
    let found: vec3f = umbrage_dual_paraboloid_coordinate(way);
    let at: vec2f = vec2f(found.x, found.y) * halves.x + halves.y;
    let depth: f32 = umbrage_distance_depth(way, position.w) + halves.w;
    let slope: vec2f = umbrage_dual_paraboloid_slope(way, normal, halves.z);
    let layer: f32 = found.z;
    return umbrage_look(map, terms, filter_terms, vec3f(at.x, at.y, depth), slope, pixel);
}
`,
};

const projected = { needs: [snippets.shadow_coordinate, snippets.pancake, snippets.cleared_depth], text: `
// umbrage_vertex: clip space position of a vertex of the depth pass
fn umbrage_vertex(to_clip: mat4x4f, world: vec3f) -> vec4f {
    return umbrage_shadow_coordinate(to_clip, world);
}
` };
const pancaked = { needs: [snippets.shadow_coordinate, snippets.pancake, snippets.cleared_depth], text: `
// umbrage_vertex: clip space position of a vertex of the depth pass
fn umbrage_vertex(to_clip: mat4x4f, world: vec3f) -> vec4f {
    return umbrage_pancake(umbrage_shadow_coordinate(to_clip, world), NEAR);
}
` };
const bent = { needs: [snippets.dual_paraboloid_position, snippets.cleared_depth], text: `
// umbrage_vertex: clip space position of a vertex of the depth pass
fn umbrage_vertex(to_clip: mat4x4f, world: vec3f, position: vec3f, number: f32) -> vec4f {
    let p: vec4f = umbrage_dual_paraboloid_position(world - position, number);
    let place: vec4f = to_clip[3] * p.w + to_clip[0] * p.x + to_clip[1] * p.y + to_clip[2] * p.z;
    return place;
}
` };

const spot_light = { language, name: "spot_light", maps: one_map, vertex: projected };
const directional_light = { language, name: "directional_light", maps: one_map, vertex: pancaked };
const cascades = { language, name: "cascades", maps: cascaded_maps, vertex: pancaked };
const cascades_8 = { language, name: "cascades_8", maps: cascaded_maps_8, vertex: pancaked };
const point_light = { language, name: "point_light", maps: cube_maps, vertex: projected };
const tetrahedron_light = { language, name: "tetrahedron_light", maps: tetrahedron_map, vertex: projected };
const dual_paraboloid_light = { language, name: "dual_paraboloid_light", maps: paraboloid_maps, vertex: bent };
const warped_cascades = { language, name: "warped_cascades", maps: warped_maps, vertex: pancaked };
const adaptive_pages = { language, name: "adaptive_pages", maps: adaptive_maps, vertex: pancaked };

module.exports = {
    spot_light,
    directional_light,
    cascades,
    cascades_8,
    point_light,
    tetrahedron_light,
    dual_paraboloid_light,
    warped_cascades,
    adaptive_pages,
};
