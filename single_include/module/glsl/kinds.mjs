import { language } from './language.mjs';
import * as snippets from './snippets.mjs';

const one_map = {
    name: "one_map", grid: [1, 1], outside: "bordered", bends: false,
    fields: [{ name: "to_texels", matrix: true }, { name: "planes", matrix: true }],
    needs: [snippets.project_coordinate, snippets.shadow_coordinate, snippets.receiver_slope],
    text: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
UMBRAGE_HIGHP float umbrage_shadow(UMBRAGE_MAP map, UMBRAGE_HIGHP mat4 to_texels, UMBRAGE_HIGHP mat4 planes, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_HIGHP vec3 at = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world));
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
UMBRAGE_HIGHP float umbrage_shadow(UMBRAGE_MAP map, UMBRAGE_HIGHP mat4 rotation, UMBRAGE_HIGHP mat4 scales, UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP vec4 blending, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_HIGHP vec4 turned = umbrage_shadow_coordinate(rotation, world);
    UMBRAGE_HIGHP vec4 across = umbrage_shadow_coordinate(rotation, normal);
    UMBRAGE_HIGHP vec3 light = vec3(turned.x, turned.y, turned.z);
    UMBRAGE_HIGHP vec3 normal_there = vec3(across.x, across.y, across.z);
    UMBRAGE_HIGHP vec2 size = vec2(terms.x, terms.y);
    UMBRAGE_HIGHP vec4 found = umbrage_cascade_by_projection(light, scales, offsets, size, terms.z);
    UMBRAGE_HIGHP float number = min(found.w, blending.y);
    UMBRAGE_HIGHP vec4 scale = umbrage_cascade_column(scales, number);
    UMBRAGE_HIGHP vec2 origin = umbrage_cascade_tile(number, vec2(terms.x, terms.y));
    UMBRAGE_HIGHP vec2 slope = umbrage_cascade_slope(normal_there, scale);
    UMBRAGE_HIGHP float nearer = umbrage_look(map, terms, filter_terms, vec3(found.x, found.y, found.z), slope, pixel);
    UMBRAGE_HIGHP float border = umbrage_cascade_border_fade(vec2(found.x, found.y), size, terms.z, blending.x);
    UMBRAGE_HIGHP float weight = blending.x > 0.0 && found.w <= blending.y ? border : 0.0;
    bool last = number >= blending.y;
    UMBRAGE_HIGHP float next = min(number + 1.0, blending.y);
    UMBRAGE_HIGHP vec4 next_scale = umbrage_cascade_column(scales, next);
    UMBRAGE_HIGHP vec3 at = umbrage_cascade_coordinate(light, next_scale, umbrage_cascade_column(offsets, next));
    origin = umbrage_cascade_tile(next, vec2(terms.x, terms.y));

    UMBRAGE_HIGHP float fade = umbrage_cascade_border_fade(vec2(at.x, at.y), size, terms.z, blending.x);
    UMBRAGE_HIGHP float held = umbrage_inside_cascade(at, size, terms.z) ? 1.0 - fade : 0.0;
    weight = last ? weight : min(weight, held);
    UMBRAGE_HIGHP float farther = 1.0;
    if (weight > 0.0 && !last) {
        farther = umbrage_look(map, terms, filter_terms, at, umbrage_cascade_slope(normal_there, next_scale), pixel);
    }
    return weight > 0.0 ? umbrage_blend_cascades(nearer, farther, weight) : nearer;
}
`,
    of_layers: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
UMBRAGE_HIGHP float umbrage_shadow(UMBRAGE_MAP map, UMBRAGE_HIGHP mat4 rotation, UMBRAGE_HIGHP mat4 scales, UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP vec4 blending, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_HIGHP vec4 turned = umbrage_shadow_coordinate(rotation, world);
    UMBRAGE_HIGHP vec4 across = umbrage_shadow_coordinate(rotation, normal);
    UMBRAGE_HIGHP vec3 light = vec3(turned.x, turned.y, turned.z);
    UMBRAGE_HIGHP vec3 normal_there = vec3(across.x, across.y, across.z);
    UMBRAGE_HIGHP vec2 size = vec2(terms.x, terms.y);
    UMBRAGE_HIGHP vec4 found = umbrage_cascade_by_projection(light, scales, offsets, size, terms.z);
    UMBRAGE_HIGHP float number = min(found.w, blending.y);
    UMBRAGE_HIGHP vec4 scale = umbrage_cascade_column(scales, number);
    UMBRAGE_HIGHP float layer = number;
    UMBRAGE_HIGHP vec2 slope = umbrage_cascade_slope(normal_there, scale);
    UMBRAGE_HIGHP float nearer = umbrage_look(map, terms, filter_terms, vec3(found.x, found.y, found.z), slope, pixel);
    UMBRAGE_HIGHP float border = umbrage_cascade_border_fade(vec2(found.x, found.y), size, terms.z, blending.x);
    UMBRAGE_HIGHP float weight = blending.x > 0.0 && found.w <= blending.y ? border : 0.0;
    bool last = number >= blending.y;
    UMBRAGE_HIGHP float next = min(number + 1.0, blending.y);
    UMBRAGE_HIGHP vec4 next_scale = umbrage_cascade_column(scales, next);
    UMBRAGE_HIGHP vec3 at = umbrage_cascade_coordinate(light, next_scale, umbrage_cascade_column(offsets, next));
    layer = next;

    UMBRAGE_HIGHP float fade = umbrage_cascade_border_fade(vec2(at.x, at.y), size, terms.z, blending.x);
    UMBRAGE_HIGHP float held = umbrage_inside_cascade(at, size, terms.z) ? 1.0 - fade : 0.0;
    weight = last ? weight : min(weight, held);
    UMBRAGE_HIGHP float farther = 1.0;
    if (weight > 0.0 && !last) {
        farther = umbrage_look(map, terms, filter_terms, at, umbrage_cascade_slope(normal_there, next_scale), pixel);
    }
    return weight > 0.0 ? umbrage_blend_cascades(nearer, farther, weight) : nearer;
}
`,
};
const cascaded_maps_8 = {
    name: "cascaded_maps_8", grid: [2, 4], outside: "bordered", bends: false,
    fields: [{ name: "rotation", matrix: true }, { name: "scales", matrix: true }, { name: "offsets", matrix: true }, { name: "farther_scales", matrix: true }, { name: "farther_offsets", matrix: true }, { name: "blending", matrix: false }],
    needs: [snippets.shadow_coordinate, snippets.cascade_by_projection_8, snippets.cascade_column_8, snippets.cascade_slope, snippets.cascade_coordinate, snippets.inside_cascade, snippets.cascade_border_fade, snippets.blend_cascades, snippets.cascade_tile],
    text: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
UMBRAGE_HIGHP float umbrage_shadow(UMBRAGE_MAP map, UMBRAGE_HIGHP mat4 rotation, UMBRAGE_HIGHP mat4 scales, UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP mat4 farther_scales, UMBRAGE_HIGHP mat4 farther_offsets, UMBRAGE_HIGHP vec4 blending, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_HIGHP vec4 turned = umbrage_shadow_coordinate(rotation, world);
    UMBRAGE_HIGHP vec4 across = umbrage_shadow_coordinate(rotation, normal);
    UMBRAGE_HIGHP vec3 light = vec3(turned.x, turned.y, turned.z);
    UMBRAGE_HIGHP vec3 normal_there = vec3(across.x, across.y, across.z);
    UMBRAGE_HIGHP vec2 size = vec2(terms.x, terms.y);
    UMBRAGE_HIGHP vec4 found = umbrage_cascade_by_projection_8(light, scales, offsets, farther_scales, farther_offsets, size, terms.z);
    UMBRAGE_HIGHP float number = min(found.w, blending.y);
    UMBRAGE_HIGHP vec4 scale = umbrage_cascade_column_8(scales, farther_scales, number);
    UMBRAGE_HIGHP vec2 origin = umbrage_cascade_tile(number, vec2(terms.x, terms.y));
    UMBRAGE_HIGHP vec2 slope = umbrage_cascade_slope(normal_there, scale);
    UMBRAGE_HIGHP float nearer = umbrage_look(map, terms, filter_terms, vec3(found.x, found.y, found.z), slope, pixel);
    UMBRAGE_HIGHP float border = umbrage_cascade_border_fade(vec2(found.x, found.y), size, terms.z, blending.x);
    UMBRAGE_HIGHP float weight = blending.x > 0.0 && found.w <= blending.y ? border : 0.0;
    bool last = number >= blending.y;
    UMBRAGE_HIGHP float next = min(number + 1.0, blending.y);
    UMBRAGE_HIGHP vec4 next_scale = umbrage_cascade_column_8(scales, farther_scales, next);
    UMBRAGE_HIGHP vec3 at = umbrage_cascade_coordinate(light, next_scale, umbrage_cascade_column_8(offsets, farther_offsets, next));
    origin = umbrage_cascade_tile(next, vec2(terms.x, terms.y));

    UMBRAGE_HIGHP float fade = umbrage_cascade_border_fade(vec2(at.x, at.y), size, terms.z, blending.x);
    UMBRAGE_HIGHP float held = umbrage_inside_cascade(at, size, terms.z) ? 1.0 - fade : 0.0;
    weight = last ? weight : min(weight, held);
    UMBRAGE_HIGHP float farther = 1.0;
    if (weight > 0.0 && !last) {
        farther = umbrage_look(map, terms, filter_terms, at, umbrage_cascade_slope(normal_there, next_scale), pixel);
    }
    return weight > 0.0 ? umbrage_blend_cascades(nearer, farther, weight) : nearer;
}
`,
    of_layers: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
UMBRAGE_HIGHP float umbrage_shadow(UMBRAGE_MAP map, UMBRAGE_HIGHP mat4 rotation, UMBRAGE_HIGHP mat4 scales, UMBRAGE_HIGHP mat4 offsets, UMBRAGE_HIGHP mat4 farther_scales, UMBRAGE_HIGHP mat4 farther_offsets, UMBRAGE_HIGHP vec4 blending, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_HIGHP vec4 turned = umbrage_shadow_coordinate(rotation, world);
    UMBRAGE_HIGHP vec4 across = umbrage_shadow_coordinate(rotation, normal);
    UMBRAGE_HIGHP vec3 light = vec3(turned.x, turned.y, turned.z);
    UMBRAGE_HIGHP vec3 normal_there = vec3(across.x, across.y, across.z);
    UMBRAGE_HIGHP vec2 size = vec2(terms.x, terms.y);
    UMBRAGE_HIGHP vec4 found = umbrage_cascade_by_projection_8(light, scales, offsets, farther_scales, farther_offsets, size, terms.z);
    UMBRAGE_HIGHP float number = min(found.w, blending.y);
    UMBRAGE_HIGHP vec4 scale = umbrage_cascade_column_8(scales, farther_scales, number);
    UMBRAGE_HIGHP float layer = number;
    UMBRAGE_HIGHP vec2 slope = umbrage_cascade_slope(normal_there, scale);
    UMBRAGE_HIGHP float nearer = umbrage_look(map, terms, filter_terms, vec3(found.x, found.y, found.z), slope, pixel);
    UMBRAGE_HIGHP float border = umbrage_cascade_border_fade(vec2(found.x, found.y), size, terms.z, blending.x);
    UMBRAGE_HIGHP float weight = blending.x > 0.0 && found.w <= blending.y ? border : 0.0;
    bool last = number >= blending.y;
    UMBRAGE_HIGHP float next = min(number + 1.0, blending.y);
    UMBRAGE_HIGHP vec4 next_scale = umbrage_cascade_column_8(scales, farther_scales, next);
    UMBRAGE_HIGHP vec3 at = umbrage_cascade_coordinate(light, next_scale, umbrage_cascade_column_8(offsets, farther_offsets, next));
    layer = next;

    UMBRAGE_HIGHP float fade = umbrage_cascade_border_fade(vec2(at.x, at.y), size, terms.z, blending.x);
    UMBRAGE_HIGHP float held = umbrage_inside_cascade(at, size, terms.z) ? 1.0 - fade : 0.0;
    weight = last ? weight : min(weight, held);
    UMBRAGE_HIGHP float farther = 1.0;
    if (weight > 0.0 && !last) {
        farther = umbrage_look(map, terms, filter_terms, at, umbrage_cascade_slope(normal_there, next_scale), pixel);
    }
    return weight > 0.0 ? umbrage_blend_cascades(nearer, farther, weight) : nearer;
}
`,
};
const warped_maps = {
    name: "warped_maps", grid: [2, 2], outside: "bordered", bends: false,
    fields: [{ name: "to_texels_0", matrix: true }, { name: "to_texels_1", matrix: true }, { name: "to_texels_2", matrix: true }, { name: "to_texels_3", matrix: true }, { name: "planes_0", matrix: true }, { name: "planes_1", matrix: true }, { name: "planes_2", matrix: true }, { name: "planes_3", matrix: true }, { name: "fades", matrix: true }, { name: "ahead", matrix: false }, { name: "ends", matrix: false }],
    needs: [snippets.shadow_coordinate, snippets.project_coordinate, snippets.receiver_slope, snippets.cascade_by_depth, snippets.cascade_column, snippets.cascade_fade, snippets.blend_cascades, snippets.cascade_tile],
    text: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
UMBRAGE_HIGHP float umbrage_shadow(UMBRAGE_MAP map, UMBRAGE_HIGHP mat4 to_texels_0, UMBRAGE_HIGHP mat4 to_texels_1, UMBRAGE_HIGHP mat4 to_texels_2, UMBRAGE_HIGHP mat4 to_texels_3, UMBRAGE_HIGHP mat4 planes_0, UMBRAGE_HIGHP mat4 planes_1, UMBRAGE_HIGHP mat4 planes_2, UMBRAGE_HIGHP mat4 planes_3, UMBRAGE_HIGHP mat4 fades, UMBRAGE_HIGHP vec4 ahead, UMBRAGE_HIGHP vec4 ends, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = ahead.x * world.x + ahead.y * world.y + ahead.z * world.z + ahead.w;
    UMBRAGE_HIGHP float number = umbrage_cascade_by_depth(depth, vec3(ends.x, ends.y, ends.z));
    UMBRAGE_HIGHP vec4 own = umbrage_cascade_column(fades, number);
    UMBRAGE_HIGHP float weight = umbrage_cascade_fade(depth, own.x, own.y);
    UMBRAGE_HIGHP mat4 to_texels = to_texels_0;
    UMBRAGE_HIGHP mat4 planes = planes_0;
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
    UMBRAGE_HIGHP vec2 origin = umbrage_cascade_tile(number, vec2(terms.x, terms.y));
    UMBRAGE_HIGHP float nearer = umbrage_look(map, terms, filter_terms, umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world)), umbrage_receiver_slope(planes, normal, world), pixel);
    bool last = number >= ends.w;
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
    origin = umbrage_cascade_tile(number, vec2(terms.x, terms.y));
    UMBRAGE_HIGHP float farther = 1.0;
    if (weight > 0.0 && !last) {
        farther = umbrage_look(map, terms, filter_terms, umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world)), umbrage_receiver_slope(planes, normal, world), pixel);
    }
    return weight > 0.0 ? umbrage_blend_cascades(nearer, farther, weight) : nearer;
}
`,
    of_layers: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
UMBRAGE_HIGHP float umbrage_shadow(UMBRAGE_MAP map, UMBRAGE_HIGHP mat4 to_texels_0, UMBRAGE_HIGHP mat4 to_texels_1, UMBRAGE_HIGHP mat4 to_texels_2, UMBRAGE_HIGHP mat4 to_texels_3, UMBRAGE_HIGHP mat4 planes_0, UMBRAGE_HIGHP mat4 planes_1, UMBRAGE_HIGHP mat4 planes_2, UMBRAGE_HIGHP mat4 planes_3, UMBRAGE_HIGHP mat4 fades, UMBRAGE_HIGHP vec4 ahead, UMBRAGE_HIGHP vec4 ends, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = ahead.x * world.x + ahead.y * world.y + ahead.z * world.z + ahead.w;
    UMBRAGE_HIGHP float number = umbrage_cascade_by_depth(depth, vec3(ends.x, ends.y, ends.z));
    UMBRAGE_HIGHP vec4 own = umbrage_cascade_column(fades, number);
    UMBRAGE_HIGHP float weight = umbrage_cascade_fade(depth, own.x, own.y);
    UMBRAGE_HIGHP mat4 to_texels = to_texels_0;
    UMBRAGE_HIGHP mat4 planes = planes_0;
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
    UMBRAGE_HIGHP float layer = number;
    UMBRAGE_HIGHP float nearer = umbrage_look(map, terms, filter_terms, umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world)), umbrage_receiver_slope(planes, normal, world), pixel);
    bool last = number >= ends.w;
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
    UMBRAGE_HIGHP float farther = 1.0;
    if (weight > 0.0 && !last) {
        farther = umbrage_look(map, terms, filter_terms, umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world)), umbrage_receiver_slope(planes, normal, world), pixel);
    }
    return weight > 0.0 ? umbrage_blend_cascades(nearer, farther, weight) : nearer;
}
`,
};
const adaptive_maps = {
    name: "adaptive_maps", grid: [8, 8], outside: "clamped", bends: false,
    fields: [{ name: "to_root", matrix: true }, { name: "planes", matrix: true }, { name: "cells_0", matrix: true }, { name: "cells_1", matrix: true }, { name: "cells_2", matrix: true }, { name: "cells_3", matrix: true }, { name: "cells_4", matrix: true }, { name: "cells_5", matrix: true }, { name: "cells_6", matrix: true }, { name: "cells_7", matrix: true }, { name: "pages", matrix: false }],
    needs: [snippets.shadow_coordinate, snippets.cascade_column_8, snippets.receiver_slope, snippets.clamp_slope, snippets.page_tile],
    text: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
UMBRAGE_HIGHP float umbrage_shadow(UMBRAGE_MAP map, UMBRAGE_HIGHP mat4 to_root, UMBRAGE_HIGHP mat4 planes, UMBRAGE_HIGHP mat4 cells_0, UMBRAGE_HIGHP mat4 cells_1, UMBRAGE_HIGHP mat4 cells_2, UMBRAGE_HIGHP mat4 cells_3, UMBRAGE_HIGHP mat4 cells_4, UMBRAGE_HIGHP mat4 cells_5, UMBRAGE_HIGHP mat4 cells_6, UMBRAGE_HIGHP mat4 cells_7, UMBRAGE_HIGHP vec4 pages, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_HIGHP vec4 in_root = umbrage_shadow_coordinate(to_root, world);
    bool inside = in_root.x >= 1.0 && in_root.x < 2.0 && in_root.y >= 1.0 && in_root.y < 2.0;
    UMBRAGE_HIGHP vec2 coord = inside ? vec2(in_root.x, in_root.y) : vec2(1.0, 1.0);
    UMBRAGE_HIGHP vec2 cell = floor(coord * 16.0 - 16.0);
    UMBRAGE_HIGHP float right = floor(cell.x * 0.125);
    UMBRAGE_HIGHP float column = cell.y * 2.0 + right;
    UMBRAGE_HIGHP vec4 a = umbrage_cascade_column_8(cells_0, cells_1, column);
    UMBRAGE_HIGHP vec4 b = umbrage_cascade_column_8(cells_2, cells_3, column - 8.0);
    UMBRAGE_HIGHP vec4 c = umbrage_cascade_column_8(cells_4, cells_5, column - 16.0);
    UMBRAGE_HIGHP vec4 d = umbrage_cascade_column_8(cells_6, cells_7, column - 24.0);
    UMBRAGE_HIGHP vec4 low = column < 7.5 ? a : b;
    UMBRAGE_HIGHP vec4 high = column < 23.5 ? c : d;
    UMBRAGE_HIGHP vec4 eight = column < 15.5 ? low : high;
    UMBRAGE_HIGHP float along = cell.x - right * 8.0;
    UMBRAGE_HIGHP float pair = floor(along * 0.5);
    UMBRAGE_HIGHP float left_two = pair < 0.5 ? eight.x : eight.y;
    UMBRAGE_HIGHP float right_two = pair < 2.5 ? eight.z : eight.w;
    UMBRAGE_HIGHP float two = pair < 1.5 ? left_two : right_two;
    UMBRAGE_HIGHP float second = floor(two * (1.0 / 1024.0));
    UMBRAGE_HIGHP float code = along - pair * 2.0 < 0.5 ? two - second * 1024.0 : second;
    UMBRAGE_HIGHP float before = floor(code * (1.0 / 64.0));
    UMBRAGE_HIGHP float number = code - before * 64.0;
    UMBRAGE_HIGHP float across = before + 1.0;
    UMBRAGE_HIGHP vec2 place = coord * across;
    UMBRAGE_HIGHP vec2 within = (place - floor(place)) * pages.x + pages.y;
    UMBRAGE_HIGHP vec2 at = inside ? within : vec2(32768.0, 32768.0);
    UMBRAGE_HIGHP vec2 steep = umbrage_receiver_slope(planes, normal, world) * (16.0 / across);
    UMBRAGE_HIGHP vec2 slope = vec2(umbrage_clamp_slope(steep.x), umbrage_clamp_slope(steep.y));
    UMBRAGE_HIGHP vec2 origin = umbrage_page_tile(number, terms.x);
    return umbrage_look(map, terms, filter_terms, vec3(at.x, at.y, in_root.z), slope, pixel);
}
`,
    of_layers: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
UMBRAGE_HIGHP float umbrage_shadow(UMBRAGE_MAP map, UMBRAGE_HIGHP mat4 to_root, UMBRAGE_HIGHP mat4 planes, UMBRAGE_HIGHP mat4 cells_0, UMBRAGE_HIGHP mat4 cells_1, UMBRAGE_HIGHP mat4 cells_2, UMBRAGE_HIGHP mat4 cells_3, UMBRAGE_HIGHP mat4 cells_4, UMBRAGE_HIGHP mat4 cells_5, UMBRAGE_HIGHP mat4 cells_6, UMBRAGE_HIGHP mat4 cells_7, UMBRAGE_HIGHP vec4 pages, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_HIGHP vec4 in_root = umbrage_shadow_coordinate(to_root, world);
    bool inside = in_root.x >= 1.0 && in_root.x < 2.0 && in_root.y >= 1.0 && in_root.y < 2.0;
    UMBRAGE_HIGHP vec2 coord = inside ? vec2(in_root.x, in_root.y) : vec2(1.0, 1.0);
    UMBRAGE_HIGHP vec2 cell = floor(coord * 16.0 - 16.0);
    UMBRAGE_HIGHP float right = floor(cell.x * 0.125);
    UMBRAGE_HIGHP float column = cell.y * 2.0 + right;
    UMBRAGE_HIGHP vec4 a = umbrage_cascade_column_8(cells_0, cells_1, column);
    UMBRAGE_HIGHP vec4 b = umbrage_cascade_column_8(cells_2, cells_3, column - 8.0);
    UMBRAGE_HIGHP vec4 c = umbrage_cascade_column_8(cells_4, cells_5, column - 16.0);
    UMBRAGE_HIGHP vec4 d = umbrage_cascade_column_8(cells_6, cells_7, column - 24.0);
    UMBRAGE_HIGHP vec4 low = column < 7.5 ? a : b;
    UMBRAGE_HIGHP vec4 high = column < 23.5 ? c : d;
    UMBRAGE_HIGHP vec4 eight = column < 15.5 ? low : high;
    UMBRAGE_HIGHP float along = cell.x - right * 8.0;
    UMBRAGE_HIGHP float pair = floor(along * 0.5);
    UMBRAGE_HIGHP float left_two = pair < 0.5 ? eight.x : eight.y;
    UMBRAGE_HIGHP float right_two = pair < 2.5 ? eight.z : eight.w;
    UMBRAGE_HIGHP float two = pair < 1.5 ? left_two : right_two;
    UMBRAGE_HIGHP float second = floor(two * (1.0 / 1024.0));
    UMBRAGE_HIGHP float code = along - pair * 2.0 < 0.5 ? two - second * 1024.0 : second;
    UMBRAGE_HIGHP float before = floor(code * (1.0 / 64.0));
    UMBRAGE_HIGHP float number = code - before * 64.0;
    UMBRAGE_HIGHP float across = before + 1.0;
    UMBRAGE_HIGHP vec2 place = coord * across;
    UMBRAGE_HIGHP vec2 within = (place - floor(place)) * pages.x + pages.y;
    UMBRAGE_HIGHP vec2 at = inside ? within : vec2(32768.0, 32768.0);
    UMBRAGE_HIGHP vec2 steep = umbrage_receiver_slope(planes, normal, world) * (16.0 / across);
    UMBRAGE_HIGHP vec2 slope = vec2(umbrage_clamp_slope(steep.x), umbrage_clamp_slope(steep.y));
    UMBRAGE_HIGHP float layer = number;
    return umbrage_look(map, terms, filter_terms, vec3(at.x, at.y, in_root.z), slope, pixel);
}
`,
};
const cube_maps = {
    name: "cube_maps", grid: [3, 2], outside: "clamped", bends: false,
    fields: [{ name: "position", matrix: false }, { name: "to_texels", matrix: true }, { name: "planes", matrix: true }],
    needs: [snippets.cube_face, snippets.cube_face_point, snippets.project_coordinate, snippets.shadow_coordinate, snippets.receiver_slope, snippets.cube_tile],
    text: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
UMBRAGE_HIGHP float umbrage_shadow(UMBRAGE_MAP map, UMBRAGE_HIGHP vec4 position, UMBRAGE_HIGHP mat4 to_texels, UMBRAGE_HIGHP mat4 planes, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(position.x, position.y, position.z);
    UMBRAGE_HIGHP float face = umbrage_cube_face(way);
    UMBRAGE_HIGHP vec3 there = umbrage_cube_face_point(face, way);
    UMBRAGE_HIGHP vec3 across = umbrage_cube_face_point(face, normal);
    UMBRAGE_HIGHP vec3 at = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, there));
    UMBRAGE_HIGHP vec2 origin = umbrage_cube_tile(face, terms.x);
    return umbrage_look(map, terms, filter_terms, at, umbrage_receiver_slope(planes, across, there), pixel);
}
`,
    of_layers: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
UMBRAGE_HIGHP float umbrage_shadow(UMBRAGE_MAP map, UMBRAGE_HIGHP vec4 position, UMBRAGE_HIGHP mat4 to_texels, UMBRAGE_HIGHP mat4 planes, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(position.x, position.y, position.z);
    UMBRAGE_HIGHP float face = umbrage_cube_face(way);
    UMBRAGE_HIGHP vec3 there = umbrage_cube_face_point(face, way);
    UMBRAGE_HIGHP vec3 across = umbrage_cube_face_point(face, normal);
    UMBRAGE_HIGHP vec3 at = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, there));
    UMBRAGE_HIGHP float layer = face;
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
UMBRAGE_HIGHP float umbrage_shadow(UMBRAGE_MAP map, UMBRAGE_HIGHP vec4 position, UMBRAGE_HIGHP mat4 to_texels, UMBRAGE_HIGHP mat4 planes, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(position.x, position.y, position.z);
    UMBRAGE_HIGHP float face = umbrage_tetrahedron_face(way);
    UMBRAGE_HIGHP vec3 there = umbrage_tetrahedron_face_point(face, way);
    UMBRAGE_HIGHP vec3 across = umbrage_tetrahedron_face_point(face, normal);
    UMBRAGE_HIGHP vec3 on_first = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, there));
    UMBRAGE_HIGHP vec2 at = umbrage_tetrahedron_turned(face, vec2(on_first.x, on_first.y)) + position.w;
    UMBRAGE_HIGHP vec2 slope = umbrage_tetrahedron_turned(face, umbrage_receiver_slope(planes, across, there));
    return umbrage_look(map, terms, filter_terms, vec3(at.x, at.y, on_first.z), slope, pixel);
}
`,
};
const paraboloid_maps = {
    name: "paraboloid_maps", grid: [2, 1], outside: "clamped", bends: true,
    fields: [{ name: "position", matrix: false }, { name: "halves", matrix: false }],
    needs: [snippets.dual_paraboloid_coordinate, snippets.distance_depth, snippets.dual_paraboloid_slope, snippets.cascade_tile],
    text: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
UMBRAGE_HIGHP float umbrage_shadow(UMBRAGE_MAP map, UMBRAGE_HIGHP vec4 position, UMBRAGE_HIGHP vec4 halves, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(position.x, position.y, position.z);
    UMBRAGE_HIGHP vec3 found = umbrage_dual_paraboloid_coordinate(way);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 at = vec2(found.x, found.y) * halves.x + halves.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = umbrage_distance_depth(way, position.w) + halves.w;
    UMBRAGE_HIGHP vec2 slope = umbrage_dual_paraboloid_slope(way, normal, halves.z);
    UMBRAGE_HIGHP vec2 origin = umbrage_cascade_tile(found.z, vec2(terms.x, terms.y));
    return umbrage_look(map, terms, filter_terms, vec3(at.x, at.y, depth), slope, pixel);
}
`,
    of_layers: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
UMBRAGE_HIGHP float umbrage_shadow(UMBRAGE_MAP map, UMBRAGE_HIGHP vec4 position, UMBRAGE_HIGHP vec4 halves, UMBRAGE_HIGHP vec4 terms, UMBRAGE_HIGHP vec4 filter_terms, UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 normal, UMBRAGE_HIGHP vec2 pixel) {
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec3 way = world - vec3(position.x, position.y, position.z);
    UMBRAGE_HIGHP vec3 found = umbrage_dual_paraboloid_coordinate(way);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec2 at = vec2(found.x, found.y) * halves.x + halves.y;
    UMBRAGE_PRECISE UMBRAGE_HIGHP float depth = umbrage_distance_depth(way, position.w) + halves.w;
    UMBRAGE_HIGHP vec2 slope = umbrage_dual_paraboloid_slope(way, normal, halves.z);
    UMBRAGE_HIGHP float layer = found.z;
    return umbrage_look(map, terms, filter_terms, vec3(at.x, at.y, depth), slope, pixel);
}
`,
};

const projected = { needs: [snippets.shadow_coordinate, snippets.pancake, snippets.cleared_depth], text: `
// umbrage_vertex: clip space position of a vertex of the depth pass
UMBRAGE_HIGHP vec4 umbrage_vertex(UMBRAGE_HIGHP mat4 to_clip, UMBRAGE_HIGHP vec3 world) {
    return umbrage_shadow_coordinate(to_clip, world);
}
` };
const pancaked = { needs: [snippets.shadow_coordinate, snippets.pancake, snippets.cleared_depth], text: `
// umbrage_vertex: clip space position of a vertex of the depth pass
UMBRAGE_HIGHP vec4 umbrage_vertex(UMBRAGE_HIGHP mat4 to_clip, UMBRAGE_HIGHP vec3 world) {
    return umbrage_pancake(umbrage_shadow_coordinate(to_clip, world), NEAR);
}
` };
const bent = { needs: [snippets.dual_paraboloid_position, snippets.cleared_depth], text: `
// umbrage_vertex: clip space position of a vertex of the depth pass
UMBRAGE_HIGHP vec4 umbrage_vertex(UMBRAGE_HIGHP mat4 to_clip, UMBRAGE_HIGHP vec3 world, UMBRAGE_HIGHP vec3 position, UMBRAGE_HIGHP float number) {
    UMBRAGE_HIGHP vec4 p = umbrage_dual_paraboloid_position(world - position, number);
    UMBRAGE_PRECISE UMBRAGE_HIGHP vec4 place =
        to_clip[3] * p.w + to_clip[0] * p.x + to_clip[1] * p.y + to_clip[2] * p.z;
    return place;
}
` };

export const spot_light = { language, name: "spot_light", maps: one_map, vertex: projected };
export const directional_light = { language, name: "directional_light", maps: one_map, vertex: pancaked };
export const cascades = { language, name: "cascades", maps: cascaded_maps, vertex: pancaked };
export const cascades_8 = { language, name: "cascades_8", maps: cascaded_maps_8, vertex: pancaked };
export const point_light = { language, name: "point_light", maps: cube_maps, vertex: projected };
export const tetrahedron_light = { language, name: "tetrahedron_light", maps: tetrahedron_map, vertex: projected };
export const dual_paraboloid_light = { language, name: "dual_paraboloid_light", maps: paraboloid_maps, vertex: bent };
export const warped_cascades = { language, name: "warped_cascades", maps: warped_maps, vertex: pancaked };
export const adaptive_pages = { language, name: "adaptive_pages", maps: adaptive_maps, vertex: pancaked };
