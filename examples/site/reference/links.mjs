// SPDX-License-Identifier: MIT
//
// Addresses of the repository's files in the site, and links between pages.
import { existsSync, statSync } from 'node:fs';
import { dirname, join, posix } from 'node:path';

import { way_up } from '../page.mjs';

const named = {
    'INDEX.md': 'index-by-name.html',
    'include/umbrage/README.md': 'reference/index.html',
    'include/umbrage': 'reference/index.html',
};
const shown = /\.(cpp|hpp|h|cmake|mjs|js|html|py|glsl|hlsl|wgsl|metal|vert|frag|txt|json)$|^LICENSE$|^Makefile$/;

/// Addresses of a repository's files. Those that are shown as source are kept in `sources`.
export class Addresses {
    constructor(root, headers) {
        Object.assign(this, { root, headers, sources: new Set() });
    }

    /// Address of a file or folder in the site, or null where the site shows none.
    of(path) {
        path = path.replace(/\/$/, '');
        if (path in named) return named[path];
        if (path.startsWith('.github/')) return null;
        if (path.endsWith('.md')) return page_of(path);
        if (/^single_include\/shaders(\/\w+)?$/.test(path)) return 'snippets/index.html';
        const place = /^include\/umbrage\/(.*\.hpp)$/.exec(path)?.[1];
        if (this.headers.has(place)) return header_page(place);
        const file = join(this.root, path);
        if (!existsSync(file)) return null;
        if (statSync(file).isDirectory()) {
            if (existsSync(join(file, 'README.md'))) return page_of(`${path}/README.md`);
            return null;
        }
        if (path.startsWith('.media/')) return `pictures/${posix.basename(path)}`;
        if (!shown.test(path)) return null;
        this.sources.add(path);
        return `source/${path}.html`;
    }
}

/// Address of the page that a Markdown file becomes.
export function page_of(path) {
    if (path in named) return named[path];
    const folder = dirname(path).replace(/^include\/umbrage/, 'reference');
    if (posix.basename(path) === 'README.md') return folder === '.' ? 'readme.html' : `${folder}/index.html`;
    return posix.join(folder, `${posix.basename(path, '.md').toLowerCase()}.html`);
}

export const header_page = place => `reference/${place.replace(/\.hpp$/, '.html')}`;

/// A link from one page of the site to another, relative.
export const link = (from, to) =>
    (way_up(from) + to.replace(/(^|\/)index\.html(?=#|$)/, '$1')).replace(/^\.\/(?=.)/, '') || './';
