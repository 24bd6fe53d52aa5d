// umbrage 0.1.0, MIT License. Shadow mapping functions as texts in GLSL; umbrage/wgsl, umbrage/hlsl and umbrage/msl
// have the same names in the other languages.
//
//     import { bind, pcf_2x2, source } from 'umbrage';
//     const fragment = source('300 es', [bind(pcf_2x2, 'sun', { texture: 'array' })]) + my_main;
//
// Written by the C++ library's build, with which every text agrees to the character.
import { bind_in } from './npm/compose/bind.mjs';
import { exactness_in } from './npm/compose/compose.mjs';
import { declare_in_glsl } from './npm/compose/declare.mjs';
import { depth32f } from './module/glsl/encodings.mjs';
import { calls, hooks } from './module/glsl/shadows.mjs';
import { glsl as language } from './module/languages.mjs';
import { shadow_in } from './npm/compose/shadow.mjs';
import { words_of_glsl } from './npm/compose/words.mjs';

/** The snippet as functions for one map: umbrage_<what>_<name>, or without a suffix when the name is empty. */
export const bind = /*#__PURE__*/ bind_in(hooks);
/** A light's shadow as functions of a shader: umbrage_<name>(world, normal), and what it declares. */
export const shadow = /*#__PURE__*/ shadow_in(hooks, calls, words_of_glsl, depth32f, declare_in_glsl);
/** The worst tier of a text: of the snippets, of all they need, and of the hooks of the maps they are bound to. */
export const exactness = items => exactness_in(language, items);
export { source, supports, text, versions } from './npm/compose/versions.mjs';
export { debug, spot_light, directional_light, cascades, cascades_8, point_light, tetrahedron_light, dual_paraboloid_light, warped_cascades, adaptive_pages } from './module/glsl/shadows.mjs';
export * from './module/glsl/encodings.mjs';
export * from './module/glsl/snippets.mjs';
export * as encodings from './module/glsl/encodings.mjs';
export * as snippets from './module/glsl/snippets.mjs';
