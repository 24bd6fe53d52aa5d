// SPDX-License-Identifier: MIT
//
// Colors of code in the browser, by the library that colors it when the site is built.
import './by_hand';  // first
import prism from 'prismjs/components/prism-core';
import 'prismjs/components/prism-clike';
import 'prismjs/components/prism-c';
import 'prismjs/components/prism-cpp';
import 'prismjs/components/prism-glsl';
import 'prismjs/components/prism-hlsl';
import 'prismjs/components/prism-wgsl';

export type Language = 'glsl' | 'hlsl' | 'wgsl' | 'msl';

/** The code as HTML. */
export const highlight = (code: string, language: Language): string => {
    const name = language === 'msl' ? 'cpp' : language;
    return prism.highlight(code, prism.languages[name]!, name);
};
