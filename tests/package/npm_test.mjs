// SPDX-License-Identifier: MIT
//
// The npm package as a stranger has it: packed, installed into an empty folder, and drawn with.
//     node npm_test.mjs ROOT NPM CHROMIUM NODE_MODULES
import { execFileSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const [root, npm, chromium_path, node_modules] = process.argv.slice(2);
if (!existsSync(join(node_modules, 'playwright-core'))) {
    console.log('SKIPPED: no playwright-core here');
    process.exit(77);
}

// In the empty folder: a shader for a map of two channels that is 0.25 on the left and 0.75 on the right.
const program = `
import { bind, hard, pcf_2x2, rg11, source, text } from 'umbrage';
import * as hlsl from 'umbrage/hlsl';
import * as msl from 'umbrage/msl';
import * as wgsl from 'umbrage/wgsl';
for (const all of [text([pcf_2x2]), ...[hlsl, msl, wgsl].map(l => l.text([l.pcf_2x2]))])
    if (!all.includes('umbrage_pcf_2x2')) process.exit(1);
const map = rg11, clamped = { ...map, outside: 'clamped' };
console.log(source('300 es', [bind(hard, 'sun', map), bind(pcf_2x2, 'sun', map), bind(pcf_2x2, 'tile', clamped)], 'precision highp float;') + \`
uniform highp sampler2D map;
out vec4 color;
void main() {
    vec2 coord = gl_FragCoord.xy * 0.5;
    float tile = umbrage_pcf_2x2_tile(map, vec2(4.0), coord, 0.5);
    color = vec4(umbrage_hard_sun(map, vec2(4.0), coord, 0.5), umbrage_pcf_2x2_sun(map, vec2(4.0), coord, 0.5), tile, 1.0);
}\`);
`;

// In the page: 8 x 8 pixels over the 4 x 4 map, their first row, half a texel from the map's edge.
function draw(fragment) {
    const gl = document.createElement('canvas').getContext('webgl2');
    const link = gl.createProgram();
    const vertex = `#version 300 es
        void main() { gl_Position = vec4(vec2(gl_VertexID % 2, gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0); }`;
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]]) {
        const stage = gl.createShader(kind);
        gl.shaderSource(stage, text);
        gl.compileShader(stage);
        if (!gl.getShaderParameter(stage, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(stage));
        gl.attachShader(link, stage);
    }
    gl.linkProgram(link);
    gl.useProgram(link);
    const picture = (unit, size, pixels) => {
        const texture = gl.createTexture();
        gl.activeTexture(gl.TEXTURE0 + unit);
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, size, size, 0, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
        return texture;
    };
    const codes = Array.from({ length: 16 }, (_, i) => i % 4 < 2 ? 512 : 1536);  // of 2048
    picture(0, 4, new Uint8Array(codes.flatMap(code => [code % 8, code / 8, 0, 255])));
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, picture(1, 8, null), 0);
    gl.viewport(0, 0, 8, 8);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const pixels = new Uint8Array(8 * 8 * 4);
    gl.readPixels(0, 0, 8, 8, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return { first: Array.from(pixels.slice(0, 32)), error: gl.getError() };
}

const folder = mkdtempSync(join(tmpdir(), 'umbrage-'));
let failed = false;
const check = (what, good) => {
    console.log(`${good ? 'ok' : 'FAILED'}: ${what}`);
    failed ||= !good;
};
try {
    const version = /define UMBRAGE_VERSION_MAJOR (\d+)[^]*MINOR (\d+)[^]*PATCH (\d+)/
        .exec(readFileSync(join(root, 'include/umbrage/version.hpp'), 'utf8')).slice(1).join('.');
    const wanted = JSON.parse(readFileSync(join(root, 'single_include/package.json'), 'utf8'));
    check(`package.json is of version ${version}`, wanted.version === version);
    const run = (...command) => execFileSync(command[0], command.slice(1), { cwd: folder, encoding: 'utf8' });
    run(npm, 'pack', join(root, 'single_include'), '--silent');
    const tarball = `umbrage-${version}.tgz`, size = statSync(join(folder, tarball)).size;
    check(`${tarball} has ${size} bytes, at most 800000`, size <= 800000);
    run(npm, 'install', `./${tarball}`, '--silent', '--offline', '--no-audit', '--no-fund');
    const installed = join(folder, 'node_modules/umbrage'), { exports } = wanted;
    const targets = target => typeof target === 'string' ? [target] : Object.values(target).flatMap(targets);
    for (const path of targets(exports).filter(path => !path.includes('*')))
        check(`${path} is in it`, existsSync(join(installed, path)));
    const files = readdirSync(installed, { recursive: true, withFileTypes: true }).filter(entry => entry.isFile())
        .map(entry => join(entry.parentPath ?? entry.path, entry.name).slice(installed.length + 1));
    const known = /^((LICENSE|README\.md|package\.json|wasm\/umbrage\.mjs)|(npm\/|npm\/compose\/|module\/(\w+\/)?)?\w+\.(d\.mts|mjs)|npm\/(README|engines|fit)\.md|shaders\/(umbrage\.(hlsl|metal)|(glsl|wgsl)\/\w+\.(glsl|wgsl)))$/;
    check(`${files.length} files, none of them a stranger: ${files.filter(file => !known.test(file))}`, files.length > 600 && files.every(file => known.test(file)));
    check('LICENSE is in it', readFileSync(join(installed, 'LICENSE'), 'utf8') === readFileSync(join(root, 'LICENSE'), 'utf8'));
    const page = readFileSync(join(installed, 'README.md'), 'utf8').replace(/^```[^]*?^```/gm, '');
    for (const [, to] of page.matchAll(/\]\((?!https?:|#)([^)#]+)/g))
        check(`its page links ${to}, which is in it`, !to.startsWith('..') && existsSync(join(installed, to)));
    writeFileSync(join(folder, 'shader.mjs'), program);
    const fragment = run(process.execPath, 'shader.mjs');

    const { chromium } = createRequire(join(node_modules, 'x.js'))('playwright-core');
    const browser = await chromium.launch({
        executablePath: chromium_path, args: ['--no-sandbox', '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
    });
    const { first, error } = await (await browser.newPage()).evaluate(draw, fragment);
    await browser.close();
    const channel = c => first.filter((_, i) => i % 4 === c).join(' ');
    check('drawn without an error', error === 0);
    check(`hard: ${channel(0)}`, channel(0) === '0 0 0 0 255 255 255 255');
    check(`pcf_2x2: ${channel(1)}`, channel(1) === '112 64 64 112 207 255 255 255');
    check(`pcf_2x2, clamped: ${channel(2)}`, channel(2) === '0 0 0 64 191 255 255 255');
} finally {
    rmSync(folder, { recursive: true });
}
process.exitCode = failed ? 1 : 0;
