// SPDX-License-Identifier: MIT
//
// Prism in the browser, with the four languages' grammars.
import './manual';
import Prism from 'prismjs/components/prism-core';
import 'prismjs/components/prism-clike';
import 'prismjs/components/prism-c';
import 'prismjs/components/prism-cpp';
import 'prismjs/components/prism-glsl';
import 'prismjs/components/prism-hlsl';
import 'prismjs/components/prism-wgsl';
import type { Language } from './state';

/// A text as HTML with Prism's classes.
export function highlight(text: string, language: Language): string {
    const name = language === 'msl' ? 'cpp' : language;
    return Prism.highlight(text, Prism.languages[name]!, name);
}
