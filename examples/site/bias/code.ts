// SPDX-License-Identifier: MIT
//
// Settings as a line of code for the engine.
import type { Engine, LightKind } from '../../../single_include/npm/engines.mjs';

type Settings = { readonly [name: string]: number };

const assigned = (settings: Settings, before: string, after: string): string =>
    Object.entries(settings).map(([name, value]) => `${before}${name} = ${value}${after}`).join('\n');

/** Numbers of floats in Rust have a point, and before an f in C++. */
const with_point = (value: number): string => (Number.isInteger(value) ? value.toFixed(1) : String(value));

const rust_lights = { directional: 'DirectionalLight', spot: 'SpotLight', point: 'PointLight' };

export const code_of: Record<Engine, (settings: Settings, light: LightKind) => string> = {
    three: settings => assigned(settings, 'light.shadow.', ';'),
    godot: settings => assigned(settings, 'light.', ''),
    unity_urp: ({ depthBias, normalBias }) =>
        `light.GetUniversalAdditionalLightData().usePipelineSettings = false;\nlight.shadowBias = ${depthBias}f;`
        + (normalBias === undefined ? '' : `\nlight.shadowNormalBias = ${normalBias}f;`),
    bevy: (settings, light) => `${rust_lights[light]} {\n${Object.entries(settings).map(([name, value]) => `    ${name}: ${with_point(value)},\n`).join('')}    ..default()\n}`,
    filament: settings => Object.entries(settings).map(([name, value]) => `options.${name} = ${with_point(value)}f;`).join('\n'),
};
