// SPDX-License-Identifier: MIT
//
// Keeps Prism from highlighting the page by itself. Imported before it.
(globalThis as unknown as { Prism: object }).Prism = { manual: true };
