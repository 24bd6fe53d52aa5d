// SPDX-License-Identifier: MIT
//
// Tools that every part of the site is built with: libraries from npm, and files into the site.
import { execFileSync, spawnSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { basename, dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

/// Root of the repository.
export const root = resolve(dirname(fileURLToPath(import.meta.url)), '../..');

/// Escapes text for HTML, attributes included.
export const escape = text => text.replace(/[&<>"]/g, c => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' })[c]);

/// Environment of Debian's emscripten, which looks for acorn where Debian's Node has it.
const emscripten = { ...process.env, NODE_PATH: '/usr/share/nodejs' };

/// What the site needs and this machine lacks, in words; nothing when all is here.
export function missing(node_modules) {
    for (const name of ['esbuild', 'marked', 'prismjs', '@xmldom/xmldom', 'gl-matrix', '@gltf-transform/core', 'pngjs'])
        if (!existsSync(join(node_modules, name))) return `no ${name} in ${node_modules}`;
    for (const [program, name] of [['cmake', 'CMake'], ['ninja', 'Ninja'], ['doxygen', 'Doxygen'], ['emcc', 'emscripten'], ['npm', 'npm']])
        if (spawnSync(program, ['--version'], { env: emscripten }).status !== 0) return `no ${name}`;
}

/// The npm package as it lies here.
const alias = Object.fromEntries(['', '/hlsl', '/msl', '/wgsl', '/values'].map(entry =>
    [`umbrage${entry}`, join(root, 'single_include', `${entry.slice(1) || 'umbrage'}.mjs`)]));

export async function make_context({ out, node_modules, work, museum }) {
    const load = createRequire(join(node_modules, 'x.js'));
    const what = missing(node_modules);
    if (what) throw new Error(`The site cannot be built: ${what}`);
    const prism = load('prismjs'), copyright = readFileSync(join(root, 'LICENSE'), 'utf8').match(/^Copyright.*/m)[0];
    for (const language of ['c', 'cpp', 'glsl', 'hlsl', 'wgsl', 'bash', 'cmake', 'typescript'])
        load(`prismjs/components/prism-${language}`);

    const written = [];
    const place = path => {
        const file = join(out, path);
        mkdirSync(dirname(file), { recursive: true });
        written.push(path);
        return file;
    };
    return {
        root, out, work, museum, node_modules, load, written,
        read: path => readFileSync(join(root, path), 'utf8'),
        write: (path, content) => writeFileSync(place(path), content),
        copy: (from, to) => copyFileSync(resolve(root, from), place(to)),

        /// Code as HTML, with the classes of Prism. Languages: cpp, glsl, hlsl, wgsl, msl, sh, cmake, ts, js.
        highlight(code, language) {
            const grammar = prism.languages[{ msl: 'cpp', sh: 'bash', ts: 'typescript', js: 'typescript' }[language] ?? language];
            return grammar ? prism.highlight(code, grammar, language) : escape(code);
        },

        /// Builds a CMake project of this folder by emscripten; only what has changed, the second time.
        /// @return  the folder of what was built
        wasm(source, ...settings) {
            const build = join(work, source.replace(/\//g, '_')), run = (program, ...given) =>
                execFileSync(program, given, { env: emscripten, stdio: ['ignore', 'ignore', 'inherit'] });
            if (spawnSync('ccache', ['--version']).status === 0) settings.push('CMAKE_CXX_COMPILER_LAUNCHER=ccache');
            run('emcmake', 'cmake', '-G', 'Ninja', '-S', join(root, 'examples/site', source), '-B', build, ...settings.map(setting => `-D${setting}`));
            run('cmake', '--build', build);
            return build;
        },

        /// Bundles a script, by its path from this folder, with what it imports, the npm package included.
        async bundle(entry, path) {
            await load('esbuild').build({
                entryPoints: [{ in: join(root, 'examples/site', entry), out: basename(path, '.js') }],
                outdir: dirname(place(path)),
                bundle: true,
                splitting: true,  // what is imported later is fetched later
                minify: true,
                format: 'esm',
                target: 'es2022',
                nodePaths: [node_modules],
                alias,
                define: { COPYRIGHT: JSON.stringify(copyright) },
                logLevel: 'warning',
            });
        },
    };
}
