// umbrage 0.1.0, MIT License. Shadow mapping functions as texts in HLSL.
//
//     import * as hlsl from 'umbrage/hlsl';
//     const shader = hlsl.text([hlsl.bind(hlsl.pcf_2x2, 'sun', { texture: 'array' })]) + my_main;
//
// Written by the C++ library's build, with which every text agrees to the character.
import { bind_in } from './npm/compose/bind.mjs';
import { compose, exactness_in } from './npm/compose/compose.mjs';
import { declare_in_hlsl } from './npm/compose/declare.mjs';
import { depth32f } from './module/hlsl/encodings.mjs';
import { calls, hooks } from './module/hlsl/shadows.mjs';
import { hlsl as language } from './module/languages.mjs';
import { shadow_in } from './npm/compose/shadow.mjs';
import { words_of_hlsl } from './npm/compose/words.mjs';

/** The snippet as functions for one map: umbrage_<what>_<name>, or without a suffix when the name is empty. */
export const bind = /*#__PURE__*/ bind_in(hooks);
/** A light's shadow as functions of a shader: umbrage_<name>(world, normal), and what it declares. */
export const shadow = /*#__PURE__*/ shadow_in(hooks, calls, words_of_hlsl, depth32f, declare_in_hlsl);
/** The worst tier of a text: of the snippets, of all they need, and of the hooks of the maps they are bound to. */
export const exactness = items => exactness_in(language, items);
/** The snippets, bound or not, and all they need, each once: text to paste into any shader. */
export const text = items => compose(language, items);
export { debug, spot_light, directional_light, cascades, cascades_8, point_light, tetrahedron_light, dual_paraboloid_light, warped_cascades, adaptive_pages } from './module/hlsl/shadows.mjs';
export * from './module/hlsl/encodings.mjs';
export * from './module/hlsl/snippets.mjs';
export * as encodings from './module/hlsl/encodings.mjs';
export * as snippets from './module/hlsl/snippets.mjs';
