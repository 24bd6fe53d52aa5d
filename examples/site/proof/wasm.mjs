// SPDX-License-Identifier: MIT
//
// Builds the parity suite as WebAssembly, by Debian's emscripten; only what has changed, the second time.
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';

// Debian's emcc looks for acorn where Debian's Node has it.
const env = { ...process.env, NODE_PATH: '/usr/share/nodejs' };

function can_run(program, ...words) {
    try {
        execFileSync(program, words, { env, stdio: 'ignore' });
        return true;
    } catch {
        return false;
    }
}

/// True for a page that tries a sample of the functions, as tests build it: a quarter of the time.
export const is_sample = process.env.UMBRAGE_PROOF_SAMPLE === '1';

/// @return   path of proof.wasm; null where there is no emscripten
export function build_wasm({ root, work }) {
    if (!can_run('emcc', '--version')) return null;
    const build = join(work, 'proof'), launcher = can_run('ccache', '--version') ? ['-D', 'CMAKE_CXX_COMPILER_LAUNCHER=ccache'] : [];
    const run = (...words) => execFileSync(words[0], words.slice(1), { env, stdio: ['ignore', 'inherit', 'inherit'] });
    run('emcmake', 'cmake', '-G', 'Ninja', '-S', join(root, 'examples/site/proof/wasm'), '-B', build,
        '-D', `sample_of_entries=${is_sample ? 'ON' : 'OFF'}`, ...launcher);
    run('cmake', '--build', build, '--target', 'proof');
    return join(build, 'proof.wasm');
}
