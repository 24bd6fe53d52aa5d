// SPDX-License-Identifier: MIT
//
// Builds the WebAssembly of umbrage/values by Debian's emscripten, as a module of base64: a bundler needs no loader for it.
//     node wasm.mjs ROOT GLM WORK PACKAGE           writes PACKAGE/wasm
//     node wasm.mjs ROOT GLM WORK PACKAGE --check   fails where that is another
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';

const [root, glm, work, folder] = process.argv.slice(2, 6).map(path => resolve(path)), check = process.argv[6] === '--check';
const known = '3.1.6';  // another one makes other code
// Debian's emcc looks for acorn where Debian's Node has it.
const env = { ...process.env, NODE_PATH: '/usr/share/nodejs' };
let version = 'none';
try { version = execFileSync('emcc', ['--version'], { encoding: 'utf8', env, stdio: ['ignore', 'pipe', 'ignore'] }).match(/ (\d+\.\d+\.\d+)/)?.[1]; } catch {}
if (version !== known) {
    console.log(`SKIPPED: emcc here is ${version}; umbrage/values is built by emscripten ${known}, of Debian 12`);
    process.exit(check ? 77 : 0);
}

rmSync(work, { recursive: true, force: true });
mkdirSync(work, { recursive: true });
symlinkSync(join(glm, 'glm'), join(work, 'glm'));  // alone: other headers of this machine are none of WebAssembly's
const out = join(work, 'umbrage.wasm');
execFileSync('emcc', ['-Oz', '-std=c++20', '-fno-exceptions', '-fno-rtti', '-ffp-contract=off', '-DNDEBUG', `-I${join(root, 'include')}`,
    '-isystem', work, join(root, 'single_include/npm/source/values.cpp'), '-o', out, '--no-entry', '-sSTANDALONE_WASM=1',
    '-sERROR_ON_UNDEFINED_SYMBOLS=0', '-sWARN_ON_UNDEFINED_SYMBOLS=0', '-sALLOW_MEMORY_GROWTH=1',
    '-sINITIAL_MEMORY=1048576', '-sTOTAL_STACK=262144',
    '-sEXPORTED_FUNCTIONS=_umbrage_input,_umbrage_seen,_umbrage_output,_umbrage_values,_umbrage_maps,_umbrage_moments'], { env, stdio: 'inherit' });
const lines = readFileSync(out).toString('base64').match(/.{1,120}/g).join('\n');
const text = `// WebAssembly of single_include/npm/source/values.cpp, in base64, by emscripten ${known}.\nexport const wasm = \`\n${lines}\n\`;\n`;
const path = join(folder, 'wasm/umbrage.mjs');
if (!check) {
    mkdirSync(join(folder, 'wasm'), { recursive: true });
    writeFileSync(path, text);
} else if (!existsSync(path) || readFileSync(path, 'utf8') !== text) {
    console.log(`FAILED: ${path} is stale; write it anew: cmake --build --preset dev --target single_include`);
    process.exitCode = 1;
}
console.log(`${readFileSync(out).length} bytes of WebAssembly`);
