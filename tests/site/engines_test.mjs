// SPDX-License-Identifier: MIT
//
// The bias page's emulation of engines against the one in C++, which rays judge: with the engines' defaults, and under spot
// lights and point lights with half of what is needed too, alike shares of lone planes are falsely dark.
//     node engines_test.mjs ROOT NODE_MODULES SHARES CONE_SHARES
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [root, node_modules, shares, cone_shares] = process.argv.slice(2).map(path => resolve(path));
if (!existsSync(join(node_modules, 'esbuild'))) {
    console.log(`SKIPPED: no esbuild in ${node_modules}`);
    process.exit(77);
}
const esbuild = createRequire(join(node_modules, 'x.js'))('esbuild');
async function load(name) {
    const { outputFiles } = await esbuild.build({ entryPoints: [join(root, 'examples/site/bias', name)], bundle: true, format: 'esm', write: false });
    return import(`data:text/javascript,${encodeURIComponent(outputFiles[0].text)}`);
}
const { falsely_dark } = await load('parallel.ts'), { any_receiver, cube_frames, falsely_dark_in_cone, spot_frame } = await load('cone.ts');
const { engine_bias, engines, formula_of, light_of } = await import(pathToFileURL(join(root, 'single_include/npm/engines.mjs')).href);
const rows = path => readFileSync(path, 'utf8').trim().split('\n').map(line => line.split('\t'));

let failed = 0;
/// @param most   of a difference: about three standard deviations
function compare(what, lines, share_of, most) {
    let worst = 0, dark = 0;
    for (const line of lines) {
        const share = share_of(line), wanted = Number(line.at(-1)), off = Math.abs(share - wanted);
        worst = Math.max(worst, off);
        if (wanted > 0.05) ++dark;
        if (off <= most) continue;
        ++failed;
        console.log(`FAILED: ${line.join(', ')}: here ${share}`);
    }
    console.log(`${what}: ${lines.length} shares, ${dark} above 5 %, ${worst.toFixed(4)} off at most`);
    if (lines.length < 40 || dark < 10) ++failed;
}

// Of 8,000 receivers there and 4,000 here, a standard deviation is 0.01 at most.
compare('directional lights', rows(shares), ([engine, filter, inner, width, range]) => {
    const { border = 0 } = engines[engine];
    const map = { engine, filter, map_size: Number(inner) + 2 * border, width: Number(width), range: Number(range) };
    return falsely_dark(engines[engine], light_of(map), engine_bias(map).defaults.settings, at => at * 89 * Math.PI / 180, 4000);
}, 0.03);

// Of 2,000 receivers there and 1,000 here, 0.018 for a share of 0.3.
const to_light = [0, 0, 1];
compare('spot lights and point lights', rows(cone_shares), ([light, engine, filter, inner, angle, range, ...numbers]) => {
    const { border = 0 } = engines[engine];
    const map = { engine, light, filter, map_size: Number(inner) + 2 * border, range: Number(range), ...light === 'spot' && { angle: Number(angle) } };
    const facts = formula_of(engine, light), settings = Object.fromEntries(Object.keys(facts.initial[light]).map((name, i) => [name, Number(numbers[i])]));
    const cone = light_of(map), frames = light === 'spot' ? [spot_frame(to_light)] : cube_frames;
    return falsely_dark_in_cone(engines[engine], facts, cone, settings, frames, any_receiver(cone, frames[0]), 1000);
}, 0.05);
process.exitCode = failed ? 1 : 0;
