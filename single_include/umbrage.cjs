// umbrage 0.1.0, MIT License. Shadow mapping functions as texts in GLSL; umbrage/wgsl, umbrage/hlsl and umbrage/msl
// have the same names in the other languages.
//
//     import { bind, pcf_2x2, source } from 'umbrage';
//     const fragment = source('300 es', [bind(pcf_2x2, 'sun', { texture: 'array' })]) + my_main;
//
// Written by the C++ library's build, with which every text agrees to the character.
const { bind_in } = require('./module/bind.cjs');
const { exactness_in } = require('./module/compose.cjs');
const { declare_in_glsl } = require('./module/declare.cjs');
const { depth32f } = require('./module/glsl/encodings.cjs');
const { hooks } = require('./module/glsl/hooks.cjs');
const { language } = require('./module/glsl/language.cjs');
const { looks } = require('./module/glsl/looks.cjs');
const { shadow_in } = require('./module/shadow.cjs');

/** The snippet as functions for one map: umbrage_<what>_<name>, or without a suffix when the name is empty. */
const bind = /*#__PURE__*/ bind_in(hooks);
/** A light's shadow as functions of a shader: umbrage_<name>(world, normal), and what it declares. */
const shadow = /*#__PURE__*/ shadow_in(hooks, looks, depth32f, declare_in_glsl);
/** The worst tier of a text: of the snippets, of all they need, and of the hooks of the maps they are bound to. */
const exactness = items => exactness_in(language, items);
const { source, supports, text, versions } = require('./module/versions.cjs');
const { debug } = require('./module/glsl/debug.cjs');






module.exports = {
    bind,
    shadow,
    exactness,
    source, supports, text, versions,
    debug,
    ...require('./module/glsl/encodings.cjs'),
    ...require('./module/glsl/kinds.cjs'),
    ...require('./module/glsl/snippets.cjs'),
    encodings: require('./module/glsl/encodings.cjs'),
    snippets: require('./module/glsl/snippets.cjs'),
};
