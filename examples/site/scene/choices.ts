// SPDX-License-Identifier: MIT
//
// Everything that a visitor can set, with its default first. The page's controls and its address are made from these.

/** A choice of one of several values. Each has the name that the address holds, and the words that the page shows. */
export interface Choice {
    readonly label: string;
    readonly options: readonly (readonly [value: string, words: string])[];
}

/** A number in a range. */
export interface Range {
    readonly label: string;
    readonly low: number;
    readonly high: number;
    readonly step: number;
    readonly usual: number;
    readonly unit: string;
}

export const choices = {
    scene: { label: 'Scene', options: [['garden', 'Garden'], ['outdoor', 'A kilometer of hills'], ['dropped', 'Your own file']] },
    light: { label: 'Light', options: [['directional_light', 'Sun, one map'], ['cascades', 'Sun, four cascades'],
        ['warped_cascades', 'Sun, four warped cascades'],
        ['adaptive_pages', 'Sun, virtual shadow map'], ['spot_light', 'Spot light'], ['point_light', 'Point light']] },
    filter: { label: 'Filter', options: [['tent3', 'Tent, 3 x 3'], ['hard', 'None: hard edges'], ['pcf_2x2', 'PCF, 2 x 2'],
        ['box', 'Box, 3 x 3'], ['castano_dyadic5', 'Castaño, 5 x 5'], ['disc16', 'Disc, 16 points'],
        ['pcss16', 'PCSS, 16 points'], ['pcss32', 'PCSS, 32 points'], ['dpcf16', 'DPCF, 16 points']] },
    encoding: { label: 'Depth in the map', options: [['depth32f', '32-bit float'], ['rgb24', '24 bits, packed in RGB'],
        ['rg16', '16 bits, packed in RG'], ['rg11', '11 bits, packed in RG: Radeon 8500'], ['rg9', '9 bits, packed in RG'],
        ['threejs_rgba', 'Packed as three.js does']] },
    size: { label: 'Map size', options: [['1024', '1024 x 1024'], ['256', '256 x 256'], ['512', '512 x 512'],
        ['2048', '2048 x 2048'], ['4096', '4096 x 4096']] },
    depth: { label: 'Direction of depth', options: [['forward', 'Forward'], ['reversed', 'Reversed']] },
    bias: { label: 'Bias', options: [['smallest', 'Computed: no acne'], ['none', 'None on slopes: acne']] },
    view: { label: 'View', options: [['both', 'GPU beside C++'], ['difference', 'Pixels that differ'], ['texels', 'Texels and maps'],
        ['map', 'The map, as the light sees it']] },
} as const satisfies Record<string, Choice>;

export const ranges = {
    azimuth: { label: 'Light around', low: -180, high: 180, step: 1, usual: -50, unit: '°' },
    elevation: { label: 'Light above', low: 3, high: 89, step: 1, usual: 30, unit: '°' },
    softness: { label: 'Size of the light', low: 0, high: 2, step: 0.05, usual: 0.5, unit: '×' },
    yaw: { label: 'Camera around', low: -180, high: 180, step: 0.1, usual: 0, unit: '°' },
    pitch: { label: 'Camera above', low: 1, high: 89, step: 0.1, usual: 20, unit: '°' },
    distance: { label: 'Camera distance', low: 0.3, high: 3, step: 0.01, usual: 1, unit: '' },
} as const satisfies Record<string, Range>;

/** Several settings at once, as shadows were made in a year. */
export const systems = [
    { words: 'A Radeon 8500 of 2002', set: { encoding: 'rg11', filter: 'pcf_2x2', size: '1024', light: 'spot_light' } },
    { words: 'One map, hard edges', set: { encoding: 'rgb24', filter: 'hard', size: '2048', light: 'directional_light' } },
    { words: 'Cascades of a game', set: { encoding: 'depth32f', filter: 'castano_dyadic5', size: '2048', light: 'cascades' } },
    { words: 'Virtual shadow map', set: { encoding: 'depth32f', filter: 'castano_dyadic5', size: '2048', light: 'adaptive_pages' } },
    { words: 'Soft shadows', set: { encoding: 'depth32f', filter: 'pcss32', size: '2048', light: 'directional_light' } },
] as const;
