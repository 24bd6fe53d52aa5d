// umbrage 0.1.0, MIT License. Shadow mapping functions as texts in WGSL.
//
//     import * as wgsl from 'umbrage/wgsl';
//     const shader = wgsl.text([wgsl.bind(wgsl.pcf_2x2, 'sun', { texture: 'array' })]) + my_main;
//
// Written by the C++ library's build, with which every text agrees to the character.
import { bind_in } from './npm/compose/bind.mjs';
import { compose, exactness_in, functions_in } from './npm/compose/compose.mjs';
import { declare_in_wgsl } from './npm/compose/declare.mjs';
import { depth32f } from './module/wgsl/encodings.mjs';
import { calls, hooks } from './module/wgsl/shadows.mjs';
import { wgsl as language } from './module/languages.mjs';
import { shadow_in } from './npm/compose/shadow.mjs';
import { words_of_wgsl } from './npm/compose/words.mjs';

/** The snippet as functions for one map: umbrage_<what>_<name>, or without a suffix when the name is empty. */
export const bind = /*#__PURE__*/ bind_in(hooks);
/** A light's shadow as functions of a shader: umbrage_<name>(world, normal), and what it declares. */
export const shadow = /*#__PURE__*/ shadow_in(hooks, calls, words_of_wgsl, depth32f, declare_in_wgsl);
/** The worst tier of a text: of the snippets, of all they need, and of the hooks of the maps they are bound to. */
export const exactness = items => exactness_in(language, items);
/** The snippets, bound or not, and all they need, each once: text to paste into any shader. */
export const text = items => compose(language, items);
export const functions = items => functions_in(language, items);
export { debug, spot_light, directional_light, cascades, cascades_8, point_light, tetrahedron_light, dual_paraboloid_light, warped_cascades, adaptive_pages } from './module/wgsl/shadows.mjs';
export * from './module/wgsl/encodings.mjs';
export * from './module/wgsl/snippets.mjs';
export * as encodings from './module/wgsl/encodings.mjs';
export * as snippets from './module/wgsl/snippets.mjs';
