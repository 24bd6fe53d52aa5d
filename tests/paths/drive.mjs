// SPDX-License-Identifier: MIT
//
// Draws paths by their APIs, and judges their pictures by rays:
//     node drive.mjs sample|all|faults=COUNT|PART-OF-A-NAME ROOT NODE_MODULES FOLDER [gl=PROGRAM] [vulkan=PROGRAM]
//
// Writes the pictures to FOLDER. Exit status 1 when a pixel is falsely dark or lit; 77 without anything to draw with.
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import * as glsl from '../../single_include/umbrage.mjs';
import { load_values, opengl_clip_space, vulkan_clip_space } from '../../single_include/values.mjs';
import { faults } from './faults.mjs';
import { browsers } from './in_browser.mjs';
import { in_program } from './in_program.mjs';
import { judged, seen_by_camera } from './judge.mjs';
import { light_values, shadow_options } from './light.mjs';
import { picture } from './scene.mjs';
import { dice, read_paths } from './table.mjs';

const [which, root, node_modules, folder, ...given] = process.argv.slice(2);
const programs = Object.fromEntries(given.map(text => text.split('=')));
const commands = { opengl: [programs.gl, '330'], glsl110: [programs.gl, '110'],
    vulkan: [programs.vulkan, 'glsl'], hlsl: [programs.vulkan, 'hlsl'] };
const chromium = process.env.UMBRAGE_CHROMIUM ?? '';
const has_browser = existsSync(join(node_modules, 'playwright-core')) && existsSync(chromium);
const listed = read_paths(join(root, 'tests/paths/paths.txt'));
const all = listed.filter(({ api }) => (commands[api] ? commands[api][0] : has_browser));
const missing = new Set(listed.filter(path => !all.includes(path)).map(({ api }) => api));
if (missing.size) console.log(`left out, as nothing here draws them: ${[...missing].join(', ')}`);
const of_faults = which.match(/^faults=([0-9]+)$/);
const paths = of_faults ? all.filter(({ api }) => api === 'webgl2')
    : all.filter(path => (which === 'sample' ? path.in_sample : which === 'all' || path.name.includes(which)));
if (!paths.length) console.log('SKIPPED: needs Chromium, or a program that draws'), process.exit(77);

const values = await load_values(), seen = seen_by_camera();
const pages = has_browser && await browsers.open(root, node_modules, chromium);
mkdirSync(folder, { recursive: true });

/** What edges may be off by along their normals, in texels. Right pictures have 0.15 at most, maps one texel aside 0.7. */
const edge_limit = 0.2;

/** What the package says of a frame. */
function told_of(frame, api) {
    const shadow = glsl.shadow('sun', shadow_options(glsl, frame)), is_vulkan = ['vulkan', 'hlsl'].includes(api);
    const clip = { ...is_vulkan ? vulkan_clip_space : opengl_clip_space, direction: frame.direction };
    const light = light_values(frame, shadow, clip, seen), of_light = values(shadow, light);
    return { shadow, clip, seen, border: light.border, values: of_light, edge_angle: of_light.edge_angle };
}

/** Draws a path's frames; what rays say of each, with whether it is right. */
async function verdicts(path, fault) {
    const told = path.frames.map(frame => told_of(frame, path.api)), command = commands[path.api];
    const drawn = await (command ? in_program(command, path, told, folder) : pages.draw(path, seen, fault));
    return drawn.map((visibility, i) => {
        const { shadow, border, values } = told[i], count = judged(path.frames[i], shadow, values, border, visibility);
        const file = `${path.name.replaceAll(' ', '-')}${fault ? `-${fault.replaceAll(' ', '-')}` : ''}-${i + 1}.pgm`;
        const head = `P5 ${picture.join(' ')} 255\n`;
        writeFileSync(join(folder, file), Buffer.concat([Buffer.from(head), Buffer.from(visibility)]));
        const right = !count.falsely_dark && !count.falsely_lit && count.lit > 1000 && count.dark > 100;
        return { ...count, right: right && count.at_edges.off < edge_limit && count.at_edges.pixels > 200 };
    });
}
const words = ({ lit, falsely_dark, dark, falsely_lit, at_edges }) =>
    `${lit} lit, ${falsely_dark} falsely dark, ${dark} dark, ${falsely_lit} falsely lit, edges off by `
    + at_edges.off.toFixed(3);

async function try_paths() {
    let wrong = 0, pixels = 0;
    for (const path of paths) {
        const start = performance.now();
        try {
            for (const [i, verdict] of (await verdicts(path)).entries()) {
                wrong += !verdict.right, pixels += verdict.lit + verdict.dark;
                const frame = path.frames.length > 1 ? `, frame ${i + 1}` : '';
                console.log(`${path.name}${frame}: ${words(verdict)}${verdict.right ? '' : ': WRONG'}`);
            }
        } catch (error) { console.log(`${path.name}: WRONG: ${error.stderr || error.message}`), ++wrong; }
        console.log(`    ${((performance.now() - start) / 1000).toFixed(1)} s`);
    }
    console.log(`${paths.length} paths, ${pixels} pixels judged, ${wrong} wrong`);
    return wrong === 0;
}

/** Each fault in turn, on a path that can have it. */
async function try_faults(count, seed = 57) {
    const random = dice(seed), names = Object.keys(faults);
    let unseen = 0;
    for (let i = 0; i < count; ++i) {
        const fault = names[i % names.length], fitting = paths.filter(({ frames }) => faults[fault].fits(frames[0]));
        const path = fitting[Math.floor(random.next().value * fitting.length)];
        const [found] = await verdicts({ ...path, frames: path.frames.slice(0, 1) }, fault).catch(error => {
            const refused = error.message.match(/umbrage::?[^\n]*/);  // by name, which is an answer too
            if (!refused) throw error;
            return [{ refused: refused[0] }];
        });
        unseen += found.right === true;
        console.log(`${fault}; ${path.name}: ${found.refused ?? words(found)}${found.right ? ': NOT SEEN' : ''}`);
    }
    console.log(`${count} faults, ${unseen} not seen`);
    return unseen === 0;
}

const good = await (of_faults ? try_faults(Number(of_faults[1])) : try_paths());
if (pages) await pages.close();
process.exit(good ? 0 : 1);
