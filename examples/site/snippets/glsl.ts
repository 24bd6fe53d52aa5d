// SPDX-License-Identifier: MIT
//
// The npm package's texts in this language, loaded when it is chosen.
export { bind, encodings, exactness, snippets, source, text } from 'umbrage';
