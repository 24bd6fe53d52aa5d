const { language } = require('./language.cjs');
const snippets = require('./snippets.cjs');

const one_map = {
    name: "one_map", grid: [1, 1], outside: "bordered", bends: false,
    fields: [{ name: "to_texels", matrix: true }, { name: "planes", matrix: true }],
    needs: [snippets.project_coordinate, snippets.shadow_coordinate, snippets.receiver_slope],
    text: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
float umbrage_shadow(UMBRAGE_MAP map, float4x4 to_texels, float4x4 planes, float4 terms, float4 filter_terms,
                     float3 world, float3 normal, float2 pixel) {
    float3 at = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world));
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
float umbrage_shadow(UMBRAGE_MAP map, float4x4 rotation, float4x4 scales, float4x4 offsets, float4 blending,
                     float4 terms, float4 filter_terms, float3 world, float3 normal, float2 pixel) {
    float4 turned = umbrage_shadow_coordinate(rotation, world);
    float4 across = umbrage_shadow_coordinate(rotation, normal);
    float3 light = float3(turned.x, turned.y, turned.z);
    float3 normal_there = float3(across.x, across.y, across.z);
    float2 size = float2(terms.x, terms.y);
    float4 found = umbrage_cascade_by_projection(light, scales, offsets, size, terms.z);
    float number = min(found.w, blending.y);
    float4 scale = umbrage_cascade_column(scales, number);
    float2 origin = umbrage_cascade_tile(number, float2(terms.x, terms.y));
    float2 slope = umbrage_cascade_slope(normal_there, scale);
    float nearer = umbrage_look(map, terms, filter_terms, float3(found.x, found.y, found.z), slope, pixel);
    float border = umbrage_cascade_border_fade(float2(found.x, found.y), size, terms.z, blending.x);
    float weight = blending.x > 0.0 && found.w <= blending.y ? border : 0.0;
    bool last = number >= blending.y;
    float next = min(number + 1.0, blending.y);
    float4 next_scale = umbrage_cascade_column(scales, next);
    float3 at = umbrage_cascade_coordinate(light, next_scale, umbrage_cascade_column(offsets, next));
    origin = umbrage_cascade_tile(next, float2(terms.x, terms.y));

    float fade = umbrage_cascade_border_fade(float2(at.x, at.y), size, terms.z, blending.x);
    float held = umbrage_inside_cascade(at, size, terms.z) ? 1.0 - fade : 0.0;
    weight = last ? weight : min(weight, held);
    float farther = 1.0;
    if (weight > 0.0 && !last) {
        farther = umbrage_look(map, terms, filter_terms, at, umbrage_cascade_slope(normal_there, next_scale), pixel);
    }
    return weight > 0.0 ? umbrage_blend_cascades(nearer, farther, weight) : nearer;
}
`,
    of_layers: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
float umbrage_shadow(UMBRAGE_MAP map, float4x4 rotation, float4x4 scales, float4x4 offsets, float4 blending,
                     float4 terms, float4 filter_terms, float3 world, float3 normal, float2 pixel) {
    float4 turned = umbrage_shadow_coordinate(rotation, world);
    float4 across = umbrage_shadow_coordinate(rotation, normal);
    float3 light = float3(turned.x, turned.y, turned.z);
    float3 normal_there = float3(across.x, across.y, across.z);
    float2 size = float2(terms.x, terms.y);
    float4 found = umbrage_cascade_by_projection(light, scales, offsets, size, terms.z);
    float number = min(found.w, blending.y);
    float4 scale = umbrage_cascade_column(scales, number);
    float layer = number;
    float2 slope = umbrage_cascade_slope(normal_there, scale);
    float nearer = umbrage_look(map, terms, filter_terms, float3(found.x, found.y, found.z), slope, pixel);
    float border = umbrage_cascade_border_fade(float2(found.x, found.y), size, terms.z, blending.x);
    float weight = blending.x > 0.0 && found.w <= blending.y ? border : 0.0;
    bool last = number >= blending.y;
    float next = min(number + 1.0, blending.y);
    float4 next_scale = umbrage_cascade_column(scales, next);
    float3 at = umbrage_cascade_coordinate(light, next_scale, umbrage_cascade_column(offsets, next));
    layer = next;

    float fade = umbrage_cascade_border_fade(float2(at.x, at.y), size, terms.z, blending.x);
    float held = umbrage_inside_cascade(at, size, terms.z) ? 1.0 - fade : 0.0;
    weight = last ? weight : min(weight, held);
    float farther = 1.0;
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
float umbrage_shadow(UMBRAGE_MAP map, float4x4 rotation, float4x4 scales, float4x4 offsets, float4x4 farther_scales,
                     float4x4 farther_offsets, float4 blending, float4 terms, float4 filter_terms, float3 world,
                     float3 normal, float2 pixel) {
    float4 turned = umbrage_shadow_coordinate(rotation, world);
    float4 across = umbrage_shadow_coordinate(rotation, normal);
    float3 light = float3(turned.x, turned.y, turned.z);
    float3 normal_there = float3(across.x, across.y, across.z);
    float2 size = float2(terms.x, terms.y);
    float4 found =
        umbrage_cascade_by_projection_8(light, scales, offsets, farther_scales, farther_offsets, size, terms.z);
    float number = min(found.w, blending.y);
    float4 scale = umbrage_cascade_column_8(scales, farther_scales, number);
    float2 origin = umbrage_cascade_tile(number, float2(terms.x, terms.y));
    float2 slope = umbrage_cascade_slope(normal_there, scale);
    float nearer = umbrage_look(map, terms, filter_terms, float3(found.x, found.y, found.z), slope, pixel);
    float border = umbrage_cascade_border_fade(float2(found.x, found.y), size, terms.z, blending.x);
    float weight = blending.x > 0.0 && found.w <= blending.y ? border : 0.0;
    bool last = number >= blending.y;
    float next = min(number + 1.0, blending.y);
    float4 next_scale = umbrage_cascade_column_8(scales, farther_scales, next);
    float3 at = umbrage_cascade_coordinate(light, next_scale, umbrage_cascade_column_8(offsets, farther_offsets, next));
    origin = umbrage_cascade_tile(next, float2(terms.x, terms.y));

    float fade = umbrage_cascade_border_fade(float2(at.x, at.y), size, terms.z, blending.x);
    float held = umbrage_inside_cascade(at, size, terms.z) ? 1.0 - fade : 0.0;
    weight = last ? weight : min(weight, held);
    float farther = 1.0;
    if (weight > 0.0 && !last) {
        farther = umbrage_look(map, terms, filter_terms, at, umbrage_cascade_slope(normal_there, next_scale), pixel);
    }
    return weight > 0.0 ? umbrage_blend_cascades(nearer, farther, weight) : nearer;
}
`,
    of_layers: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
float umbrage_shadow(UMBRAGE_MAP map, float4x4 rotation, float4x4 scales, float4x4 offsets, float4x4 farther_scales,
                     float4x4 farther_offsets, float4 blending, float4 terms, float4 filter_terms, float3 world,
                     float3 normal, float2 pixel) {
    float4 turned = umbrage_shadow_coordinate(rotation, world);
    float4 across = umbrage_shadow_coordinate(rotation, normal);
    float3 light = float3(turned.x, turned.y, turned.z);
    float3 normal_there = float3(across.x, across.y, across.z);
    float2 size = float2(terms.x, terms.y);
    float4 found =
        umbrage_cascade_by_projection_8(light, scales, offsets, farther_scales, farther_offsets, size, terms.z);
    float number = min(found.w, blending.y);
    float4 scale = umbrage_cascade_column_8(scales, farther_scales, number);
    float layer = number;
    float2 slope = umbrage_cascade_slope(normal_there, scale);
    float nearer = umbrage_look(map, terms, filter_terms, float3(found.x, found.y, found.z), slope, pixel);
    float border = umbrage_cascade_border_fade(float2(found.x, found.y), size, terms.z, blending.x);
    float weight = blending.x > 0.0 && found.w <= blending.y ? border : 0.0;
    bool last = number >= blending.y;
    float next = min(number + 1.0, blending.y);
    float4 next_scale = umbrage_cascade_column_8(scales, farther_scales, next);
    float3 at = umbrage_cascade_coordinate(light, next_scale, umbrage_cascade_column_8(offsets, farther_offsets, next));
    layer = next;

    float fade = umbrage_cascade_border_fade(float2(at.x, at.y), size, terms.z, blending.x);
    float held = umbrage_inside_cascade(at, size, terms.z) ? 1.0 - fade : 0.0;
    weight = last ? weight : min(weight, held);
    float farther = 1.0;
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
float umbrage_shadow(UMBRAGE_MAP map, float4x4 to_texels_0, float4x4 to_texels_1, float4x4 to_texels_2,
                     float4x4 to_texels_3, float4x4 planes_0, float4x4 planes_1, float4x4 planes_2, float4x4 planes_3,
                     float4x4 fades, float4 ahead, float4 ends, float4 terms, float4 filter_terms, float3 world,
                     float3 normal, float2 pixel) {
    precise float depth = ahead.x * world.x + ahead.y * world.y + ahead.z * world.z + ahead.w;
    float number = umbrage_cascade_by_depth(depth, float3(ends.x, ends.y, ends.z));
    float4 own = umbrage_cascade_column(fades, number);
    float weight = umbrage_cascade_fade(depth, own.x, own.y);
    float4x4 to_texels = to_texels_0;
    float4x4 planes = planes_0;
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
    float2 origin = umbrage_cascade_tile(number, float2(terms.x, terms.y));
    float nearer =
        umbrage_look(map, terms, filter_terms, umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world)),
                     umbrage_receiver_slope(planes, normal, world), pixel);
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
    origin = umbrage_cascade_tile(number, float2(terms.x, terms.y));
    float farther = 1.0;
    if (weight > 0.0 && !last) {
        farther =
            umbrage_look(map, terms, filter_terms,
                         umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world)),
                         umbrage_receiver_slope(planes, normal, world), pixel);
    }
    return weight > 0.0 ? umbrage_blend_cascades(nearer, farther, weight) : nearer;
}
`,
    of_layers: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
float umbrage_shadow(UMBRAGE_MAP map, float4x4 to_texels_0, float4x4 to_texels_1, float4x4 to_texels_2,
                     float4x4 to_texels_3, float4x4 planes_0, float4x4 planes_1, float4x4 planes_2, float4x4 planes_3,
                     float4x4 fades, float4 ahead, float4 ends, float4 terms, float4 filter_terms, float3 world,
                     float3 normal, float2 pixel) {
    precise float depth = ahead.x * world.x + ahead.y * world.y + ahead.z * world.z + ahead.w;
    float number = umbrage_cascade_by_depth(depth, float3(ends.x, ends.y, ends.z));
    float4 own = umbrage_cascade_column(fades, number);
    float weight = umbrage_cascade_fade(depth, own.x, own.y);
    float4x4 to_texels = to_texels_0;
    float4x4 planes = planes_0;
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
    float layer = number;
    float nearer =
        umbrage_look(map, terms, filter_terms, umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world)),
                     umbrage_receiver_slope(planes, normal, world), pixel);
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
    float farther = 1.0;
    if (weight > 0.0 && !last) {
        farther =
            umbrage_look(map, terms, filter_terms,
                         umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world)),
                         umbrage_receiver_slope(planes, normal, world), pixel);
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
float umbrage_shadow(UMBRAGE_MAP map, float4x4 to_root, float4x4 planes, float4x4 cells_0, float4x4 cells_1,
                     float4x4 cells_2, float4x4 cells_3, float4x4 cells_4, float4x4 cells_5, float4x4 cells_6,
                     float4x4 cells_7, float4 pages, float4 terms, float4 filter_terms, float3 world, float3 normal,
                     float2 pixel) {
    float4 in_root = umbrage_shadow_coordinate(to_root, world);
    bool inside = in_root.x >= 1.0 && in_root.x < 2.0 && in_root.y >= 1.0 && in_root.y < 2.0;
    float2 coord = inside ? float2(in_root.x, in_root.y) : float2(1.0, 1.0);
    float2 cell = floor(coord * 16.0 - 16.0);
    float right = floor(cell.x * 0.125);
    float column = cell.y * 2.0 + right;
    float4 a = umbrage_cascade_column_8(cells_0, cells_1, column);
    float4 b = umbrage_cascade_column_8(cells_2, cells_3, column - 8.0);
    float4 c = umbrage_cascade_column_8(cells_4, cells_5, column - 16.0);
    float4 d = umbrage_cascade_column_8(cells_6, cells_7, column - 24.0);
    float4 low = column < 7.5 ? a : b;
    float4 high = column < 23.5 ? c : d;
    float4 eight = column < 15.5 ? low : high;
    float along = cell.x - right * 8.0;
    float pair = floor(along * 0.5);
    float left_two = pair < 0.5 ? eight.x : eight.y;
    float right_two = pair < 2.5 ? eight.z : eight.w;
    float two = pair < 1.5 ? left_two : right_two;
    float second = floor(two * (1.0 / 1024.0));
    float code = along - pair * 2.0 < 0.5 ? two - second * 1024.0 : second;
    float before = floor(code * (1.0 / 64.0));
    float number = code - before * 64.0;
    float across = before + 1.0;
    float2 place = coord * across;
    float2 within = (place - floor(place)) * pages.x + pages.y;
    float2 at = inside ? within : float2(32768.0, 32768.0);
    float2 steep = umbrage_receiver_slope(planes, normal, world) * (16.0 / across);
    float2 slope = float2(umbrage_clamp_slope(steep.x), umbrage_clamp_slope(steep.y));
    float2 origin = umbrage_page_tile(number, terms.x);
    return umbrage_look(map, terms, filter_terms, float3(at.x, at.y, in_root.z), slope, pixel);
}
`,
    of_layers: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
float umbrage_shadow(UMBRAGE_MAP map, float4x4 to_root, float4x4 planes, float4x4 cells_0, float4x4 cells_1,
                     float4x4 cells_2, float4x4 cells_3, float4x4 cells_4, float4x4 cells_5, float4x4 cells_6,
                     float4x4 cells_7, float4 pages, float4 terms, float4 filter_terms, float3 world, float3 normal,
                     float2 pixel) {
    float4 in_root = umbrage_shadow_coordinate(to_root, world);
    bool inside = in_root.x >= 1.0 && in_root.x < 2.0 && in_root.y >= 1.0 && in_root.y < 2.0;
    float2 coord = inside ? float2(in_root.x, in_root.y) : float2(1.0, 1.0);
    float2 cell = floor(coord * 16.0 - 16.0);
    float right = floor(cell.x * 0.125);
    float column = cell.y * 2.0 + right;
    float4 a = umbrage_cascade_column_8(cells_0, cells_1, column);
    float4 b = umbrage_cascade_column_8(cells_2, cells_3, column - 8.0);
    float4 c = umbrage_cascade_column_8(cells_4, cells_5, column - 16.0);
    float4 d = umbrage_cascade_column_8(cells_6, cells_7, column - 24.0);
    float4 low = column < 7.5 ? a : b;
    float4 high = column < 23.5 ? c : d;
    float4 eight = column < 15.5 ? low : high;
    float along = cell.x - right * 8.0;
    float pair = floor(along * 0.5);
    float left_two = pair < 0.5 ? eight.x : eight.y;
    float right_two = pair < 2.5 ? eight.z : eight.w;
    float two = pair < 1.5 ? left_two : right_two;
    float second = floor(two * (1.0 / 1024.0));
    float code = along - pair * 2.0 < 0.5 ? two - second * 1024.0 : second;
    float before = floor(code * (1.0 / 64.0));
    float number = code - before * 64.0;
    float across = before + 1.0;
    float2 place = coord * across;
    float2 within = (place - floor(place)) * pages.x + pages.y;
    float2 at = inside ? within : float2(32768.0, 32768.0);
    float2 steep = umbrage_receiver_slope(planes, normal, world) * (16.0 / across);
    float2 slope = float2(umbrage_clamp_slope(steep.x), umbrage_clamp_slope(steep.y));
    float layer = number;
    return umbrage_look(map, terms, filter_terms, float3(at.x, at.y, in_root.z), slope, pixel);
}
`,
};
const cube_maps = {
    name: "cube_maps", grid: [3, 2], outside: "clamped", bends: false,
    fields: [{ name: "position", matrix: false }, { name: "to_texels", matrix: true }, { name: "planes", matrix: true }],
    needs: [snippets.cube_face, snippets.cube_face_point, snippets.project_coordinate, snippets.shadow_coordinate, snippets.receiver_slope, snippets.cube_tile],
    text: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
float umbrage_shadow(UMBRAGE_MAP map, float4 position, float4x4 to_texels, float4x4 planes, float4 terms,
                     float4 filter_terms, float3 world, float3 normal, float2 pixel) {
    precise float3 way = world - float3(position.x, position.y, position.z);
    float face = umbrage_cube_face(way);
    float3 there = umbrage_cube_face_point(face, way);
    float3 across = umbrage_cube_face_point(face, normal);
    float3 at = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, there));
    float2 origin = umbrage_cube_tile(face, terms.x);
    return umbrage_look(map, terms, filter_terms, at, umbrage_receiver_slope(planes, across, there), pixel);
}
`,
    of_layers: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
float umbrage_shadow(UMBRAGE_MAP map, float4 position, float4x4 to_texels, float4x4 planes, float4 terms,
                     float4 filter_terms, float3 world, float3 normal, float2 pixel) {
    precise float3 way = world - float3(position.x, position.y, position.z);
    float face = umbrage_cube_face(way);
    float3 there = umbrage_cube_face_point(face, way);
    float3 across = umbrage_cube_face_point(face, normal);
    float3 at = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, there));
    float layer = face;
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
float umbrage_shadow(UMBRAGE_MAP map, float4 position, float4x4 to_texels, float4x4 planes, float4 terms,
                     float4 filter_terms, float3 world, float3 normal, float2 pixel) {
    precise float3 way = world - float3(position.x, position.y, position.z);
    float face = umbrage_tetrahedron_face(way);
    float3 there = umbrage_tetrahedron_face_point(face, way);
    float3 across = umbrage_tetrahedron_face_point(face, normal);
    float3 on_first = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, there));
    float2 at = umbrage_tetrahedron_turned(face, float2(on_first.x, on_first.y)) + position.w;
    float2 slope = umbrage_tetrahedron_turned(face, umbrage_receiver_slope(planes, across, there));
    return umbrage_look(map, terms, filter_terms, float3(at.x, at.y, on_first.z), slope, pixel);
}
`,
};
const paraboloid_maps = {
    name: "paraboloid_maps", grid: [2, 1], outside: "clamped", bends: true,
    fields: [{ name: "position", matrix: false }, { name: "halves", matrix: false }],
    needs: [snippets.dual_paraboloid_coordinate, snippets.distance_depth, snippets.dual_paraboloid_slope, snippets.cascade_tile],
    text: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
float umbrage_shadow(UMBRAGE_MAP map, float4 position, float4 halves, float4 terms, float4 filter_terms, float3 world,
                     float3 normal, float2 pixel) {
    precise float3 way = world - float3(position.x, position.y, position.z);
    float3 found = umbrage_dual_paraboloid_coordinate(way);
    precise float2 at = float2(found.x, found.y) * halves.x + halves.y;
    precise float depth = umbrage_distance_depth(way, position.w) + halves.w;
    float2 slope = umbrage_dual_paraboloid_slope(way, normal, halves.z);
    float2 origin = umbrage_cascade_tile(found.z, float2(terms.x, terms.y));
    return umbrage_look(map, terms, filter_terms, float3(at.x, at.y, depth), slope, pixel);
}
`,
    of_layers: `
// umbrage_shadow: visibility of a point of the world, 1.0 is lit
float umbrage_shadow(UMBRAGE_MAP map, float4 position, float4 halves, float4 terms, float4 filter_terms, float3 world,
                     float3 normal, float2 pixel) {
    precise float3 way = world - float3(position.x, position.y, position.z);
    float3 found = umbrage_dual_paraboloid_coordinate(way);
    precise float2 at = float2(found.x, found.y) * halves.x + halves.y;
    precise float depth = umbrage_distance_depth(way, position.w) + halves.w;
    float2 slope = umbrage_dual_paraboloid_slope(way, normal, halves.z);
    float layer = found.z;
    return umbrage_look(map, terms, filter_terms, float3(at.x, at.y, depth), slope, pixel);
}
`,
};

const projected = { needs: [snippets.shadow_coordinate, snippets.pancake, snippets.cleared_depth], text: `
// umbrage_vertex: clip space position of a vertex of the depth pass
float4 umbrage_vertex(float4x4 to_clip, float3 world) {
    return umbrage_shadow_coordinate(to_clip, world);
}
` };
const pancaked = { needs: [snippets.shadow_coordinate, snippets.pancake, snippets.cleared_depth], text: `
// umbrage_vertex: clip space position of a vertex of the depth pass
float4 umbrage_vertex(float4x4 to_clip, float3 world) {
    return umbrage_pancake(umbrage_shadow_coordinate(to_clip, world), NEAR);
}
` };
const bent = { needs: [snippets.dual_paraboloid_position, snippets.cleared_depth], text: `
// umbrage_vertex: clip space position of a vertex of the depth pass
float4 umbrage_vertex(float4x4 to_clip, float3 world, float3 position, float number) {
    float4 p = umbrage_dual_paraboloid_position(world - position, number);
    precise float4 place = transpose(to_clip)[3] * p.w + transpose(to_clip)[0] * p.x + transpose(to_clip)[1] * p.y +
        transpose(to_clip)[2] * p.z;
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
