// SPDX-License-Identifier: MIT
//
// What the bias page shows of settings: the picture's shadow, and the shares of planes that are falsely dark.
import { engines, formula_of, light_of, type AnyMap, type DirectionalMap, type PointMap, type SpotMap } from '../../../single_include/npm/engines.mjs';
import { any_receiver, ConeShadow, cube_frames, falsely_dark_in_cone, remembered, spot_frame } from './cone';
import type { Settings, Shadow } from './emulate';
import { falsely_dark, ParallelShadow } from './parallel';
import { faces_at, on_floor, units_across, type Place } from './picture';
import { normalized, scaled, type Vector } from './vector';

export interface Shown {
    place: Place;
    /** World units of a texel, where the picture is. */
    texel: number;
    shadow(settings: Settings): Shadow;
    /** Falsely dark shares: of planes of all tilts, and of the picture's floor. */
    all(settings: Settings): number;
    floor(settings: Settings): number;
}

/** Share of a spot or point light's range at which the picture is, and the largest that it covers. */
const away = 0.8, covered = 0.25;

function under_directional(map: DirectionalMap, to_light: Vector): Shown {
    const engine = engines[map.engine], light = light_of(map), place = { unit: light.texel, middle: [0, 0, 0] as const };
    return {
        place, texel: light.texel,
        shadow: settings => new ParallelShadow(engine, light, settings, to_light, faces_at(place), 256),
        all: settings => falsely_dark(engine, light, settings, at => (at * 89 * Math.PI) / 180),
        floor: settings => falsely_dark(engine, light, settings, () => Math.acos(to_light[1])),
    };
}

function under_cone(map: SpotMap | PointMap, to_light: Vector): Shown {
    const engine = engines[map.engine], facts = formula_of(map.engine, map.light), light = light_of(map);
    const distance = away * light.range, texel = light.unit * distance, frames = light.kind === 'spot' ? [spot_frame(to_light)] : cube_frames;
    const place = { unit: Math.min(texel, (covered * light.range) / units_across), middle: scaled(to_light, -distance) };
    const dark = (settings: Settings, receiver: ReturnType<typeof any_receiver>) => falsely_dark_in_cone(engine, facts, light, settings, frames, receiver);
    return {
        place, texel,
        shadow: settings => new ConeShadow(engine, facts, light, settings, frames, faces_at(place), remembered),
        all: settings => dark(settings, any_receiver(light, frames[0]!)),
        floor: settings => dark(settings, (_, random) => on_floor(place, random)),
    };
}

/** @param sun   degrees of the light over the floor */
export function shown(map: AnyMap, sun: number): Shown {
    const rise = (sun * Math.PI) / 180, to_light = normalized([-0.96 * Math.cos(rise), Math.sin(rise), 0.28 * Math.cos(rise)]);
    return map.light === 'spot' || map.light === 'point' ? under_cone(map, to_light) : under_directional(map, to_light);
}
