// SPDX-License-Identifier: MIT
//
// Keeps Prism from coloring the whole page when it is loaded.
Object.assign(globalThis, { Prism: { manual: true } });
