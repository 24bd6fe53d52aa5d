// umbrage 0.1.0, MIT License. Shadow mapping functions as texts in WGSL.
//
//     import * as wgsl from 'umbrage/wgsl';
//     const shader = wgsl.text([wgsl.bind(wgsl.pcf_2x2, 'sun', { texture: 'array' })]) + my_main;
//
// Written by the C++ library's build, with which every text agrees to the character.
const { bind_in } = require('./module/bind.cjs');
const { compose, exactness_in } = require('./module/compose.cjs');
const { hooks } = require('./module/wgsl/hooks.cjs');
const { language } = require('./module/wgsl/language.cjs');

/** The snippet as functions for one map: umbrage_<what>_<name>, or without a suffix when the name is empty. */
const bind = /*#__PURE__*/ bind_in(hooks);
/** The worst tier of a text: of the snippets, of all they need, and of the hooks of the maps they are bound to. */
const exactness = items => exactness_in(language, items);
/** The snippets, bound or not, and all they need, each once: text to paste into any shader. */
const text = items => compose(language, items);
const { functions } = require('./module/functions.cjs');





module.exports = {
    bind,
    exactness,
    text,
    functions,
    ...require('./module/wgsl/encodings.cjs'),
    ...require('./module/wgsl/snippets.cjs'),
    encodings: require('./module/wgsl/encodings.cjs'),
    snippets: require('./module/wgsl/snippets.cjs'),
};
