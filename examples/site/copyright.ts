// SPDX-License-Identifier: MIT
//
// Whose a text is that leaves the site: copied, or as a file.

declare const COPYRIGHT: string;  // that of LICENSE: build.mjs

/** The text, with the copyright line below the line that names the license. */
export const with_copyright = (text: string): string =>
    text.replace(/^.*, MIT License.*$/m, line => `${line}\n// ${COPYRIGHT}. License text: LICENSE in the umbrage repository.`);
