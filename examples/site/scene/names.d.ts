// SPDX-License-Identifier: MIT
//
// Types of the npm package's lists of names, by which C++ counts.
declare module '*/module/names.mjs' {
    export const kinds: string[];
    export const filters: string[];
    export const encodings: string[];
}
