// SPDX-License-Identifier: MIT
//
// Draws paths by their APIs, and judges their pictures by rays:
//     node drive.mjs sample|all|PART-OF-A-NAME ROOT NODE_MODULES FOLDER [API=PROGRAM ...]
//
// Writes the pictures to FOLDER. Exit status 1 when a pixel is falsely dark or lit; 77 without anything to draw with.
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import * as glsl from '../../single_include/umbrage.mjs';
import { load_values, opengl_clip_space, vulkan_clip_space } from '../../single_include/values.mjs';
import { browsers } from './in_browser.mjs';
import { in_program } from './in_program.mjs';
import { judged, seen_by_camera } from './judge.mjs';
import { light_values, shadow_options } from './light.mjs';
import { picture } from './scene.mjs';
import { read_paths } from './table.mjs';

const [which, root, node_modules, folder, ...given] = process.argv.slice(2);
const programs = Object.fromEntries(given.map(text => text.split('=')));
const commands = { opengl: [programs.gl, '330'], glsl110: [programs.gl, '110'], vulkan: [programs.vulkan, 'glsl'], hlsl: [programs.vulkan, 'hlsl'] };
const has_browser = existsSync(join(node_modules, 'playwright-core')) && existsSync(process.env.UMBRAGE_CHROMIUM ?? '');
const can_draw = ({ api }) => (commands[api] ? commands[api][0] : has_browser);
const wanted = read_paths(join(root, 'tests/paths/paths.txt')).filter(path =>
    (which === 'sample' ? path.in_sample : which === 'all' || path.name.includes(which)));
const paths = wanted.filter(can_draw), left_out = new Set(wanted.filter(path => !can_draw(path)).map(path => path.api));
if (left_out.size) console.log(`left out: ${[...left_out].join(', ')}`);
if (!paths.length) console.log('SKIPPED: nothing to draw with'), process.exit(77);

const values = await load_values(), seen = seen_by_camera();
const pages = has_browser && await browsers.open(root, node_modules, process.env.UMBRAGE_CHROMIUM);
mkdirSync(folder, { recursive: true });
let wrong = 0, pixels = 0;
for (const path of paths) {
    const start = performance.now();
    const told = path.frames.map(frame => {
        const shadow = glsl.shadow('sun', shadow_options(glsl, frame));
        const clip = { ...path.api in commands && path.api !== 'opengl' && path.api !== 'glsl110' ? vulkan_clip_space : opengl_clip_space, direction: frame.direction };
        const light = light_values(frame, shadow, clip, seen), of = values(shadow, light);
        return { shadow, clip, seen, values: of, border: light.border, edge_angle: of.edge_angle };
    });
    let drawn = [];
    try {
        drawn = await (commands[path.api] ? in_program(commands[path.api], path, told, folder) : pages.draw(path, seen));
    } catch (error) { console.log(`${path.name}: ${error.stderr || error.message}`), ++wrong; }
    for (const [i, visibility] of drawn.entries()) {
        const count = judged(path.frames[i], told[i].shadow, told[i].values, told[i].border, visibility);
        const good = !count.falsely_dark && !count.falsely_lit && count.lit > 1000 && count.dark > 100;
        wrong += !good, pixels += count.lit + count.dark;
        console.log(`${path.name}${drawn.length > 1 ? `, frame ${i + 1}` : ''}: ${count.lit} lit, ${count.falsely_dark} falsely dark, `
            + `${count.dark} dark, ${count.falsely_lit} falsely lit${good ? '' : ': WRONG'}; ${(performance.now() - start).toFixed()} ms`);
        writeFileSync(join(folder, `${path.name.replaceAll(' ', '-')}-${i + 1}.pgm`),
            Buffer.concat([Buffer.from(`P5 ${picture.join(' ')} 255\n`), Buffer.from(visibility)]));
    }
}
if (pages) await pages.close();
console.log(`${paths.length} paths, ${pixels} pixels judged, ${wrong} pictures wrong`);
process.exit(wrong ? 1 : 0);
