// SPDX-License-Identifier: MIT
//
// Uses of a name: exhibits of the museum, and the example programs.
import { readFileSync } from 'node:fs';
import { join, relative } from 'node:path';

import { files_below } from './headers.mjs';
import { anchor } from './markdown.mjs';

/// Exhibits of MUSEUM.md by the names that they show the right formula with: [{title, to}] of each name.
export function exhibits(text) {
    const by_name = new Map();
    for (const section of text.split(/^## /m).slice(1)) {
        const title = section.split('\n')[0];
        const here = /^- Here: ([^]*?)(?=\n- |\n\n|$)/m.exec(section)?.[1] ?? '';
        for (const [, name] of here.matchAll(/`(\w+)/g))
            by_name.set(name, [...(by_name.get(name) ?? []), { title, to: `museum.html#${anchor(title)}` }]);
    }
    return by_name;
}

const folders = [
    'examples/small',
    'examples/recipes',
    'examples/originals',
    'examples/shadow_render',
    'examples/studies',
    'examples/threads',
    'examples/viewer',
    'examples/gallery',
];
const shown = 6;

/// Programs by the identifiers of the library that their text has: paths, the shortest programs first, at most six.
export function programs(root, names) {
    const by_name = new Map();
    for (const folder of folders)
        for (const file of files_below(join(root, folder), '.cpp')) {
            if (/check\w*\.cpp$/.test(file)) continue;
            const text = readFileSync(file, 'utf8');
            const found = new Set(
                Array.from(
                    text.matchAll(/(?:umbrage|glsl|filters|prefilters|hlsl|wgsl|msl)::(\w+)|\b(\w+_\w+)\b/g),
                    match => match[1] ?? match[2],
                ),
            );
            for (const name of found)
                if (names.has(name)) by_name.set(name, [...(by_name.get(name) ?? []), relative(root, file)]);
        }
    return new Map([...by_name].map(([name, files]) => [name, files.slice(0, shown)]));
}
