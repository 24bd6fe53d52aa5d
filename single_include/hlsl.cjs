// umbrage 0.1.0, MIT License. Shadow mapping functions as texts in HLSL.
//
//     import * as hlsl from 'umbrage/hlsl';
//     const shader = hlsl.text([hlsl.bind(hlsl.pcf_2x2, 'sun', { texture: 'array' })]) + my_main;
//
// Written by the C++ library's build, with which every text agrees to the character.
const { bind_in } = require('./module/bind.cjs');
const { compose, exactness_in } = require('./module/compose.cjs');
const { declare_in_hlsl } = require('./module/declare.cjs');
const { depth32f } = require('./module/hlsl/encodings.cjs');
const { hooks } = require('./module/hlsl/hooks.cjs');
const { language } = require('./module/hlsl/language.cjs');
const { looks } = require('./module/hlsl/looks.cjs');
const { shadow_in } = require('./module/shadow.cjs');

/** The snippet as functions for one map: umbrage_<what>_<name>, or without a suffix when the name is empty. */
const bind = /*#__PURE__*/ bind_in(hooks);
/** A light's shadow as functions of a shader: umbrage_<name>(world, normal), and what it declares. */
const shadow = /*#__PURE__*/ shadow_in(hooks, looks, depth32f, declare_in_hlsl);
/** The worst tier of a text: of the snippets, of all they need, and of the hooks of the maps they are bound to. */
const exactness = items => exactness_in(language, items);
/** The snippets, bound or not, and all they need, each once: text to paste into any shader. */
const text = items => compose(language, items);
const { debug } = require('./module/hlsl/debug.cjs');






module.exports = {
    bind,
    shadow,
    exactness,
    text,
    debug,
    ...require('./module/hlsl/encodings.cjs'),
    ...require('./module/hlsl/kinds.cjs'),
    ...require('./module/hlsl/snippets.cjs'),
    encodings: require('./module/hlsl/encodings.cjs'),
    snippets: require('./module/hlsl/snippets.cjs'),
};
