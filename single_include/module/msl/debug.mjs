import { language } from './language.mjs';
import * as snippets from './snippets.mjs';

export const debug = {
    language,
    needs: { place: snippets.probe_color, point: [snippets.cleared_depth, snippets.probe_inputs] },
    place_color: {
        plain: { bias: snippets.acne_free_bias, text: `
// umbrage_place_color: one channel of a receiver's debug color in one map
inline float umbrage_place_color(float number, float4 terms, float4 filter_terms, float3 at, float2 slope,
                                 float channel) {
    float bias = umbrage_acne_free_bias(slope, terms.z, terms.w);
    float3 color = umbrage_probe_color(at, float2(terms.x, terms.y), bias, number);
    float later = channel < 1.5 ? color.y : color.z;
    return channel < 0.5 ? color.x : later;
}
` },
        disc: { bias: snippets.acne_free_disc_bias, text: `
// umbrage_place_color: one channel of a receiver's debug color in one map
inline float umbrage_place_color(float number, float4 terms, float4 filter_terms, float3 at, float2 slope,
                                 float channel) {
    float bias = umbrage_acne_free_disc_bias(slope, filter_terms.y, terms.w);
    float3 color = umbrage_probe_color(at, float2(terms.x, terms.y), bias, number);
    float later = channel < 1.5 ? color.y : color.z;
    return channel < 0.5 ? color.x : later;
}
` },
        hardens: { bias: snippets.acne_free_bias, text: `
// umbrage_place_color: one channel of a receiver's debug color in one map
inline float umbrage_place_color(float number, float4 terms, float4 filter_terms, float3 at, float2 slope,
                                 float channel) {
    float bias = umbrage_acne_free_bias(slope, 0.5, terms.w);
    float3 color = umbrage_probe_color(at, float2(terms.x, terms.y), bias, number);
    float later = channel < 1.5 ? color.y : color.z;
    return channel < 0.5 ? color.x : later;
}
` },
    },
    lit_at: `
// umbrage_lit_at: 1.0 where a receiver at a distance from the near plane, 0.0 to 1.0, is lit
inline float umbrage_lit_at(UMBRAGE_MAP map, float4 terms, float4 filter_terms, float2 coord, float distance) {
    float depth = umbrage_cleared_depth() > 0.5 ? distance : 1.0 - distance;
    float3 at = float3(coord.x, coord.y, depth);
    return umbrage_look(map, terms, filter_terms, at, float2(0.0, 0.0)) > 0.5 ? 1.0 : 0.0;
}
`,
    lit_at_turned: `
// umbrage_lit_at: 1.0 where a receiver at a distance from the near plane, 0.0 to 1.0, is lit
inline float umbrage_lit_at(UMBRAGE_MAP map, float4 terms, float4 filter_terms, float2 coord, float distance) {
    float depth = umbrage_cleared_depth() > 0.5 ? distance : 1.0 - distance;
    float3 at = float3(coord.x, coord.y, depth);
    return umbrage_look(map, terms, filter_terms, at, float2(0.0, 0.0), float2(0.5, 0.5)) > 0.5 ? 1.0 : 0.0;
}
`,
    reading: `
// umbrage_reading: what a map of known depths is read as, a map_reading's number; 0.0 is right
inline float umbrage_reading(UMBRAGE_MAP map, float4 terms, float4 filter_terms, float number) {
    float tolerance = 1.0 / PARTS.0;
    float coarse = 1.0 / 72.0;
    float own = number - 8.0 * metal::floor(number * 0.125) + 1.0;
    float4 met = float4(0.0, 0.0, 0.0, 0.0);
    float3 seen = float3(0.0, 0.0, 0.0);
    for (int block = 0; block < 4; ++block) {
        float row = block < 2 ? 0.0 : 1.0;
        float column = float(block) - 2.0 * row;
        float2 coord = float2(terms.x * (0.25 + 0.5 * column), terms.y * (0.25 + 0.5 * row));
        float found = 0.0;
        float step_size = 0.5;
        for (int i = 0; i < 20; ++i) {
            found += umbrage_lit_at(map, terms, filter_terms, coord, found + step_size) * step_size;
            step_size *= 0.5;
        }
        float first = 8.0 * float(block);
        float turned = 8.0 * (column + 2.0 - 2.0 * row);
        float here = metal::abs(found - (first + own) * (1.0 / 34.0));
        float there = metal::abs(found - (turned + own) * (1.0 / 34.0));
        float nearest = metal::clamp(metal::floor(found * 34.0 + 0.5), first + 1.0, first + 8.0);
        float other = metal::abs(found - nearest * (1.0 / 34.0));
        met +=
            float4(here <= tolerance ? 1.0 : 0.0, here <= coarse ? 1.0 : 0.0, there <= coarse ? 1.0 : 0.0, other <=
                   coarse ? 1.0 : 0.0);
        float front = umbrage_lit_at(map, terms, filter_terms, coord, 0.0);
        float back = umbrage_lit_at(map, terms, filter_terms, coord, 1.0);
        seen += float3(found > 0.9999 ? 1.0 : 0.0, found < 0.0001 ? 1.0 : 0.0, (1.0 - front) * back);
    }
    float reading = 7.0;
    reading = met.w > 3.5 ? 4.0 : reading;
    reading = met.z > 3.5 ? 3.0 : reading;
    reading = met.y > 3.5 ? 6.0 : reading;
    reading = seen.y > 3.5 ? 2.0 : reading;
    reading = seen.x > 3.5 ? 1.0 : reading;
    reading = seen.z > 3.5 ? 5.0 : reading;
    return met.x > 3.5 ? 0.0 : reading;
}
`,
    layer: `    float layer = number;
`,
    parts: { moments: 72, depth32f: 262144, rg9: 128, rg10: 256, rg11: 512, rg12: 1024, rg13: 2048, rg14: 4096, rg15: 8192, rg16: 16384, rgb24: 262144, rgb10: 262144, r16: 16384, float_bits: 262144, threejs_rgba: 262144, threejs_rgb: 262144, threejs_rg: 16384, threejs_legacy: 262144, threejs_legacy_repaired: 262144, base255: 262144, base255_repaired: 262144 },
    parts_of_bent: { moments: 72, depth32f: 1024, rg9: 128, rg10: 256, rg11: 512, rg12: 512, rg13: 1024, rg14: 1024, rg15: 1024, rg16: 1024, rgb24: 1024, rgb10: 1024, r16: 1024, float_bits: 1024, threejs_rgba: 1024, threejs_rgb: 1024, threejs_rg: 1024, threejs_legacy: 1024, threejs_legacy_repaired: 1024, base255: 1024, base255_repaired: 1024 },
    maps: {
        one_map: {
            choice: ``,
            channel_color: `
// umbrage_channel_color: one channel of a point's debug color
inline float umbrage_channel_color(metal::float4x4 to_texels, metal::float4x4 planes, float4 terms, float4 filter_terms,
                                   float3 world, float3 normal, float channel) {
    float3 at = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world));
    return umbrage_place_color(0.0, terms, filter_terms, at, umbrage_receiver_slope(planes, normal, world), channel);
}
`,
            point_color: `
// umbrage_point_color: debug color of a point of the world
inline float3 umbrage_point_color(metal::float4x4 to_texels, metal::float4x4 planes, float4 terms, float4 filter_terms,
                                  float3 world, float3 normal) {
    float3 color =
        float3(umbrage_channel_color(to_texels, planes, terms, filter_terms, world, normal, 0.0),
               umbrage_channel_color(to_texels, planes, terms, filter_terms, world, normal, 1.0),
               umbrage_channel_color(to_texels, planes, terms, filter_terms, world, normal, 2.0));
    return umbrage_probe_inputs(color, world, normal);
}
`,
        },
        cascaded_maps: {
            choice: `    float2 origin = umbrage_cascade_tile(number, float2(terms.x, terms.y));
`,
            channel_color: `
// umbrage_channel_color: one channel of a point's debug color
inline float umbrage_channel_color(metal::float4x4 rotation, metal::float4x4 scales, metal::float4x4 offsets,
                                   float4 blending, float4 terms, float4 filter_terms, float3 world, float3 normal,
                                   float channel) {
    float4 turned = umbrage_shadow_coordinate(rotation, world);
    float4 across = umbrage_shadow_coordinate(rotation, normal);
    float3 light = float3(turned.x, turned.y, turned.z);
    float3 normal_there = float3(across.x, across.y, across.z);
    float2 size = float2(terms.x, terms.y);
    float4 found = umbrage_cascade_by_projection(light, scales, offsets, size, terms.z);
    float number = metal::min(found.w, blending.y);
    float4 scale = umbrage_cascade_column(scales, number);
    float layer = number;
    float2 slope = umbrage_cascade_slope(normal_there, scale);
    float nearer = umbrage_place_color(layer, terms, filter_terms, float3(found.x, found.y, found.z), slope, channel);
    float border = umbrage_cascade_border_fade(float2(found.x, found.y), size, terms.z, blending.x);
    float weight = blending.x > 0.0 && found.w <= blending.y ? border : 0.0;
    bool last = number >= blending.y;
    float next = metal::min(number + 1.0, blending.y);
    float4 next_scale = umbrage_cascade_column(scales, next);
    float3 at = umbrage_cascade_coordinate(light, next_scale, umbrage_cascade_column(offsets, next));
    layer = next;

    float fade = umbrage_cascade_border_fade(float2(at.x, at.y), size, terms.z, blending.x);
    float held = umbrage_inside_cascade(at, size, terms.z) ? 1.0 - fade : 0.0;
    weight = last ? weight : metal::min(weight, held);
    float farther = 1.0;
    if (weight > 0.0 && !last) {
        farther =
            umbrage_place_color(layer, terms, filter_terms, at, umbrage_cascade_slope(normal_there, next_scale),
                                channel);
    }
    return weight > 0.0 ? umbrage_blend_cascades(nearer, farther, weight) : nearer;
}
`,
            point_color: `
// umbrage_point_color: debug color of a point of the world
inline float3 umbrage_point_color(metal::float4x4 rotation, metal::float4x4 scales, metal::float4x4 offsets,
                                  float4 blending, float4 terms, float4 filter_terms, float3 world, float3 normal) {
    float3 color =
        float3(umbrage_channel_color(rotation, scales, offsets, blending, terms, filter_terms, world, normal, 0.0),
               umbrage_channel_color(rotation, scales, offsets, blending, terms, filter_terms, world, normal, 1.0),
               umbrage_channel_color(rotation, scales, offsets, blending, terms, filter_terms, world, normal, 2.0));
    return umbrage_probe_inputs(color, world, normal);
}
`,
        },
        cascaded_maps_8: {
            choice: `    float2 origin = umbrage_cascade_tile(number, float2(terms.x, terms.y));
`,
            channel_color: `
// umbrage_channel_color: one channel of a point's debug color
inline float umbrage_channel_color(metal::float4x4 rotation, metal::float4x4 scales, metal::float4x4 offsets,
                                   metal::float4x4 farther_scales, metal::float4x4 farther_offsets, float4 blending,
                                   float4 terms, float4 filter_terms, float3 world, float3 normal, float channel) {
    float4 turned = umbrage_shadow_coordinate(rotation, world);
    float4 across = umbrage_shadow_coordinate(rotation, normal);
    float3 light = float3(turned.x, turned.y, turned.z);
    float3 normal_there = float3(across.x, across.y, across.z);
    float2 size = float2(terms.x, terms.y);
    float4 found =
        umbrage_cascade_by_projection_8(light, scales, offsets, farther_scales, farther_offsets, size, terms.z);
    float number = metal::min(found.w, blending.y);
    float4 scale = umbrage_cascade_column_8(scales, farther_scales, number);
    float layer = number;
    float2 slope = umbrage_cascade_slope(normal_there, scale);
    float nearer = umbrage_place_color(layer, terms, filter_terms, float3(found.x, found.y, found.z), slope, channel);
    float border = umbrage_cascade_border_fade(float2(found.x, found.y), size, terms.z, blending.x);
    float weight = blending.x > 0.0 && found.w <= blending.y ? border : 0.0;
    bool last = number >= blending.y;
    float next = metal::min(number + 1.0, blending.y);
    float4 next_scale = umbrage_cascade_column_8(scales, farther_scales, next);
    float3 at = umbrage_cascade_coordinate(light, next_scale, umbrage_cascade_column_8(offsets, farther_offsets, next));
    layer = next;

    float fade = umbrage_cascade_border_fade(float2(at.x, at.y), size, terms.z, blending.x);
    float held = umbrage_inside_cascade(at, size, terms.z) ? 1.0 - fade : 0.0;
    weight = last ? weight : metal::min(weight, held);
    float farther = 1.0;
    if (weight > 0.0 && !last) {
        farther =
            umbrage_place_color(layer, terms, filter_terms, at, umbrage_cascade_slope(normal_there, next_scale),
                                channel);
    }
    return weight > 0.0 ? umbrage_blend_cascades(nearer, farther, weight) : nearer;
}
`,
            point_color: `
// umbrage_point_color: debug color of a point of the world
inline float3 umbrage_point_color(metal::float4x4 rotation, metal::float4x4 scales, metal::float4x4 offsets,
                                  metal::float4x4 farther_scales, metal::float4x4 farther_offsets, float4 blending,
                                  float4 terms, float4 filter_terms, float3 world, float3 normal) {
    float3 color =
        float3(umbrage_channel_color(rotation, scales, offsets, farther_scales, farther_offsets, blending, terms,
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
            choice: `    float2 origin = umbrage_cascade_tile(number, float2(terms.x, terms.y));
`,
            channel_color: `
// umbrage_channel_color: one channel of a point's debug color
inline float umbrage_channel_color(metal::float4x4 to_texels_0, metal::float4x4 to_texels_1,
                                   metal::float4x4 to_texels_2, metal::float4x4 to_texels_3, metal::float4x4 planes_0,
                                   metal::float4x4 planes_1, metal::float4x4 planes_2, metal::float4x4 planes_3,
                                   metal::float4x4 fades, float4 ahead, float4 ends, float4 terms, float4 filter_terms,
                                   float3 world, float3 normal, float channel) {
    float depth = ahead.x * world.x + ahead.y * world.y + ahead.z * world.z + ahead.w;
    float number = umbrage_cascade_by_depth(depth, float3(ends.x, ends.y, ends.z));
    float4 own = umbrage_cascade_column(fades, number);
    float weight = umbrage_cascade_fade(depth, own.x, own.y);
    metal::float4x4 to_texels = to_texels_0;
    metal::float4x4 planes = planes_0;
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
        umbrage_place_color(layer, terms, filter_terms,
                            umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world)),
                            umbrage_receiver_slope(planes, normal, world), channel);
    bool last = number >= ends.w;
    number = metal::min(number + 1.0, ends.w);
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
            umbrage_place_color(layer, terms, filter_terms,
                                umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, world)),
                                umbrage_receiver_slope(planes, normal, world), channel);
    }
    return weight > 0.0 ? umbrage_blend_cascades(nearer, farther, weight) : nearer;
}
`,
            point_color: `
// umbrage_point_color: debug color of a point of the world
inline float3 umbrage_point_color(metal::float4x4 to_texels_0, metal::float4x4 to_texels_1, metal::float4x4 to_texels_2,
                                  metal::float4x4 to_texels_3, metal::float4x4 planes_0, metal::float4x4 planes_1,
                                  metal::float4x4 planes_2, metal::float4x4 planes_3, metal::float4x4 fades,
                                  float4 ahead, float4 ends, float4 terms, float4 filter_terms, float3 world,
                                  float3 normal) {
    float3 color =
        float3(umbrage_channel_color(to_texels_0, to_texels_1, to_texels_2, to_texels_3, planes_0, planes_1, planes_2,
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
            choice: `    float2 origin = umbrage_page_tile(number, terms.x);
`,
            channel_color: `
// umbrage_channel_color: one channel of a point's debug color
inline float umbrage_channel_color(metal::float4x4 to_root, metal::float4x4 planes, metal::float4x4 cells_0,
                                   metal::float4x4 cells_1, metal::float4x4 cells_2, metal::float4x4 cells_3,
                                   metal::float4x4 cells_4, metal::float4x4 cells_5, metal::float4x4 cells_6,
                                   metal::float4x4 cells_7, float4 pages, float4 terms, float4 filter_terms,
                                   float3 world, float3 normal, float channel) {
    float4 in_root = umbrage_shadow_coordinate(to_root, world);
    bool inside = in_root.x >= 1.0 && in_root.x < 2.0 && in_root.y >= 1.0 && in_root.y < 2.0;
    float2 coord = inside ? float2(in_root.x, in_root.y) : float2(1.0, 1.0);
    float2 cell = metal::floor(coord * 16.0 - 16.0);
    float right = metal::floor(cell.x * 0.125);
    float column = cell.y * 2.0 + right;
    float4 a = umbrage_cascade_column_8(cells_0, cells_1, column);
    float4 b = umbrage_cascade_column_8(cells_2, cells_3, column - 8.0);
    float4 c = umbrage_cascade_column_8(cells_4, cells_5, column - 16.0);
    float4 d = umbrage_cascade_column_8(cells_6, cells_7, column - 24.0);
    float4 low = column < 7.5 ? a : b;
    float4 high = column < 23.5 ? c : d;
    float4 eight = column < 15.5 ? low : high;
    float along = cell.x - right * 8.0;
    float pair = metal::floor(along * 0.5);
    float left_two = pair < 0.5 ? eight.x : eight.y;
    float right_two = pair < 2.5 ? eight.z : eight.w;
    float two = pair < 1.5 ? left_two : right_two;
    float second = metal::floor(two * (1.0 / 1024.0));
    float code = along - pair * 2.0 < 0.5 ? two - second * 1024.0 : second;
    float before = metal::floor(code * (1.0 / 64.0));
    float number = code - before * 64.0;
    float across = before + 1.0;
    float2 place = coord * across;
    float2 within = (place - metal::floor(place)) * pages.x + pages.y;
    float2 at = inside ? within : float2(32768.0, 32768.0);
    float2 steep = umbrage_receiver_slope(planes, normal, world) * (16.0 / across);
    float2 slope = float2(umbrage_clamp_slope(steep.x), umbrage_clamp_slope(steep.y));
    float layer = number;
    return umbrage_place_color(layer, terms, filter_terms, float3(at.x, at.y, in_root.z), slope, channel);
}
`,
            point_color: `
// umbrage_point_color: debug color of a point of the world
inline float3 umbrage_point_color(metal::float4x4 to_root, metal::float4x4 planes, metal::float4x4 cells_0,
                                  metal::float4x4 cells_1, metal::float4x4 cells_2, metal::float4x4 cells_3,
                                  metal::float4x4 cells_4, metal::float4x4 cells_5, metal::float4x4 cells_6,
                                  metal::float4x4 cells_7, float4 pages, float4 terms, float4 filter_terms,
                                  float3 world, float3 normal) {
    float3 color =
        float3(umbrage_channel_color(to_root, planes, cells_0, cells_1, cells_2, cells_3, cells_4, cells_5, cells_6,
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
            choice: `    float2 origin = umbrage_cube_tile(number, terms.x);
`,
            channel_color: `
// umbrage_channel_color: one channel of a point's debug color
inline float umbrage_channel_color(float4 position, metal::float4x4 to_texels, metal::float4x4 planes, float4 terms,
                                   float4 filter_terms, float3 world, float3 normal, float channel) {
    float3 way = world - float3(position.x, position.y, position.z);
    float face = umbrage_cube_face(way);
    float3 there = umbrage_cube_face_point(face, way);
    float3 across = umbrage_cube_face_point(face, normal);
    float3 at = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, there));
    float layer = face;
    return umbrage_place_color(layer, terms, filter_terms, at, umbrage_receiver_slope(planes, across, there), channel);
}
`,
            point_color: `
// umbrage_point_color: debug color of a point of the world
inline float3 umbrage_point_color(float4 position, metal::float4x4 to_texels, metal::float4x4 planes, float4 terms,
                                  float4 filter_terms, float3 world, float3 normal) {
    float3 color =
        float3(umbrage_channel_color(position, to_texels, planes, terms, filter_terms, world, normal, 0.0),
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
inline float umbrage_channel_color(float4 position, metal::float4x4 to_texels, metal::float4x4 planes, float4 terms,
                                   float4 filter_terms, float3 world, float3 normal, float channel) {
    float3 way = world - float3(position.x, position.y, position.z);
    float face = umbrage_tetrahedron_face(way);
    float3 there = umbrage_tetrahedron_face_point(face, way);
    float3 across = umbrage_tetrahedron_face_point(face, normal);
    float3 on_first = umbrage_project_coordinate(umbrage_shadow_coordinate(to_texels, there));
    float2 at = umbrage_tetrahedron_turned(face, float2(on_first.x, on_first.y)) + position.w;
    float2 slope = umbrage_tetrahedron_turned(face, umbrage_receiver_slope(planes, across, there));
    return umbrage_place_color(0.0, terms, filter_terms, float3(at.x, at.y, on_first.z), slope, channel);
}
`,
            point_color: `
// umbrage_point_color: debug color of a point of the world
inline float3 umbrage_point_color(float4 position, metal::float4x4 to_texels, metal::float4x4 planes, float4 terms,
                                  float4 filter_terms, float3 world, float3 normal) {
    float3 color =
        float3(umbrage_channel_color(position, to_texels, planes, terms, filter_terms, world, normal, 0.0),
               umbrage_channel_color(position, to_texels, planes, terms, filter_terms, world, normal, 1.0),
               umbrage_channel_color(position, to_texels, planes, terms, filter_terms, world, normal, 2.0));
    return umbrage_probe_inputs(color, world, normal);
}
`,
        },
        paraboloid_maps: {
            choice: `    float2 origin = umbrage_cascade_tile(number, float2(terms.x, terms.y));
`,
            channel_color: `
// umbrage_channel_color: one channel of a point's debug color
inline float umbrage_channel_color(float4 position, float4 halves, float4 terms, float4 filter_terms, float3 world,
                                   float3 normal, float channel) {
    float3 way = world - float3(position.x, position.y, position.z);
    float3 found = umbrage_dual_paraboloid_coordinate(way);
    float2 at = float2(found.x, found.y) * halves.x + halves.y;
    float depth = umbrage_distance_depth(way, position.w) + halves.w;
    float2 slope = umbrage_dual_paraboloid_slope(way, normal, halves.z);
    float layer = found.z;
    return umbrage_place_color(layer, terms, filter_terms, float3(at.x, at.y, depth), slope, channel);
}
`,
            point_color: `
// umbrage_point_color: debug color of a point of the world
inline float3 umbrage_point_color(float4 position, float4 halves, float4 terms, float4 filter_terms, float3 world,
                                  float3 normal) {
    float3 color =
        float3(umbrage_channel_color(position, halves, terms, filter_terms, world, normal, 0.0),
               umbrage_channel_color(position, halves, terms, filter_terms, world, normal, 1.0),
               umbrage_channel_color(position, halves, terms, filter_terms, world, normal, 2.0));
    return umbrage_probe_inputs(color, world, normal);
}
`,
        },
    },
};
