//@ glsl
// umbrage @version@, MIT License. Shadow mapping functions as texts in GLSL; umbrage/wgsl, umbrage/hlsl and umbrage/msl
// have the same names in the other languages.
//
//     import { bind, pcf_2x2, source } from 'umbrage';
//     const fragment = source('300 es', [bind(pcf_2x2, 'sun', { texture: 'array' })]) + my_main;
//
// Written by the C++ library's build, with which every text agrees to the character.
//@ hlsl msl wgsl
// umbrage @version@, MIT License. Shadow mapping functions as texts in @Language@.
//
//     import * as @language@ from 'umbrage/@language@';
//     const shader = @language@.text([@language@.bind(@language@.pcf_2x2, 'sun', { texture: 'array' })]) + my_main;
//
// Written by the C++ library's build, with which every text agrees to the character.
//@
import { bind_in } from './npm/compose/bind.mjs';
//@ glsl
import { exactness_in } from './npm/compose/compose.mjs';
//@ hlsl msl
import { compose, exactness_in } from './npm/compose/compose.mjs';
//@ wgsl
import { compose, exactness_in, functions_in } from './npm/compose/compose.mjs';
//@
import { declare_in_@language@ } from './npm/compose/declare.mjs';
import { depth32f } from './module/@language@/encodings.mjs';
import { calls, hooks } from './module/@language@/shadows.mjs';
import { @language@ as language } from './module/languages.mjs';
import { shadow_in } from './npm/compose/shadow.mjs';
import { words_of_@language@ } from './npm/compose/words.mjs';

/** The snippet as functions for one map: umbrage_<what>_<name>, or without a suffix when the name is empty. */
export const bind = /*#__PURE__*/ bind_in(hooks);
/** A light's shadow as functions of a shader: umbrage_<name>(world, normal), and what it declares. */
export const shadow = /*#__PURE__*/ shadow_in(hooks, calls, words_of_@language@, depth32f, declare_in_@language@);
/** The worst tier of a text: of the snippets, of all they need, and of the hooks of the maps they are bound to. */
export const exactness = items => exactness_in(language, items);
//@ glsl
export { source, supports, text, versions } from './npm/compose/versions.mjs';
//@ hlsl msl wgsl
/** The snippets, bound or not, and all they need, each once: text to paste into any shader. */
export const text = items => compose(language, items);
//@ wgsl
export const functions = items => functions_in(language, items);
//@
export { debug, @lights@ } from './module/@language@/shadows.mjs';
export * from './module/@language@/encodings.mjs';
export * from './module/@language@/snippets.mjs';
export * as encodings from './module/@language@/encodings.mjs';
export * as snippets from './module/@language@/snippets.mjs';
