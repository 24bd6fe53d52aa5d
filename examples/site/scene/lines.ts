// SPDX-License-Identifier: MIT
//
// The text of the shadow that the picture runs, in each language.
import type { Asked } from './light';
import type { Language } from '../highlight';

export const languages = { glsl: 'GLSL', hlsl: 'HLSL', wgsl: 'WGSL', msl: 'Metal' } as const;

const main = 'float visibility = umbrage_sun(world, normal';
const how_to_call = {
    glsl: (pixel: boolean) => `${main}${pixel ? ', gl_FragCoord.xy' : ''});  // 1.0 is lit`,
    hlsl: (pixel: boolean) => `${main}${pixel ? ', position.xy' : ''});  // 1.0 is lit`,
    wgsl: (pixel: boolean) => `let visibility = umbrage_sun(world, normal${pixel ? ', position.xy' : ''});  // 1.0 is lit`,
    msl: (pixel: boolean) => `${main}${pixel ? ', position.xy' : ''}, ...);  // 1.0 is lit; the text says what else it takes`,
};

/** @return  the text, and the line that calls it */
export async function lines_of(asked: Asked, language: Language, pixel: boolean): Promise<{ text: string; call: string }> {
    const umbrage = await {
        glsl: () => import('umbrage'), hlsl: () => import('umbrage/hlsl'), wgsl: () => import('umbrage/wgsl'), msl: () => import('umbrage/msl'),
    }[language]() as typeof import('umbrage');  // the four have the same exports
    const { kind, filter, encoding, map_size, direction } = asked;
    const sun = umbrage.shadow('sun', { kind: umbrage[kind], filter: umbrage.snippets[filter], encoding: umbrage.encodings[encoding],
        map_size, direction });
    const text = language === 'glsl' ? umbrage.source('300 es', [sun]) : umbrage.text([sun]);
    return { text: text.trim() + '\n', call: how_to_call[language](pixel) };
}
