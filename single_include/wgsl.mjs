// umbrage 0.1.0, MIT License. Shadow mapping functions as texts in WGSL.
//
//     import * as wgsl from 'umbrage/wgsl';
//     const shader = wgsl.text([wgsl.bind(wgsl.pcf_2x2, 'sun', { texture: 'array' })]) + my_main;
//
// Written by the C++ library's build, with which every text agrees to the character.
import { bind_in } from './module/bind.mjs';
import { compose, exactness_in } from './module/compose.mjs';
import { declare_in_wgsl } from './module/declare.mjs';
import { depth32f } from './module/wgsl/encodings.mjs';
import { hooks } from './module/wgsl/hooks.mjs';
import { language } from './module/wgsl/language.mjs';
import { looks } from './module/wgsl/looks.mjs';
import { shadow_in } from './module/shadow.mjs';

/** The snippet as functions for one map: umbrage_<what>_<name>, or without a suffix when the name is empty. */
export const bind = /*#__PURE__*/ bind_in(hooks);
/** A light's shadow as functions of a shader: umbrage_<name>(world, normal), and what it declares. */
export const shadow = /*#__PURE__*/ shadow_in(hooks, looks, depth32f, declare_in_wgsl);
/** The worst tier of a text: of the snippets, of all they need, and of the hooks of the maps they are bound to. */
export const exactness = items => exactness_in(language, items);
/** The snippets, bound or not, and all they need, each once: text to paste into any shader. */
export const text = items => compose(language, items);
export { functions } from './module/functions.mjs';
export { debug } from './module/wgsl/debug.mjs';
export * from './module/wgsl/encodings.mjs';
export * from './module/wgsl/kinds.mjs';
export * from './module/wgsl/snippets.mjs';
export * as encodings from './module/wgsl/encodings.mjs';
export * as snippets from './module/wgsl/snippets.mjs';
