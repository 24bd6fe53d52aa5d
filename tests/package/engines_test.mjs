// SPDX-License-Identifier: MIT
//
// engine_bias without an engine: what it gives is enough at every tilt and little more, three.js' numbers are those of
// fit_shadow, sliders that end too early are told, and bad input is refused by a name. Writes the numbers that
// tests/proof/picture/engine_bias tries against rays, and engine_cones those of spot lights and point lights.
//     node engines_test.mjs PACKAGE NUMBERS CONES
import { writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';

const [umbrage, numbers, cones] = process.argv.slice(2).map(path => resolve(path));
const load = file => import(pathToFileURL(join(umbrage, 'npm', file)).href);
const { engine_bias, engines, light_of, lights_of } = await load('engines.mjs');
const { parallel_offset } = await load('fit.mjs');

let failed = 0;
const check = (what, good) => {
    if (!good) ++failed;
    console.log(`${good ? 'ok' : 'FAILED'}: ${what}`);
};

/** Settings in the order of the package, filled up with zeros. */
const four = (settings, scale) => [...Object.values(settings), 0, 0, 0].slice(0, 4).map(value => value * scale);

const maps = [[1024, 30, 60], [512, 10, 500], [2048, 100, 300]], lines = [];
for (const [engine, { title, filters, border = 0 }] of Object.entries(engines)) {
    let enough = true, close = true;
    for (const filter of Object.keys(filters))
        for (const [map_size, width, range] of maps) {
            const light = { engine, filter, map_size, width, range }, bias = engine_bias(light), { reach, texel } = bias;
            enough &&= bias.lacking === 0 && bias.striped === undefined;
            const surplus = bias.detachment / texel - reach;
            close &&= surplus < (engine === 'unity_urp' ? 2.6 : 0.7);  // its rasterizer adds 2.5 texels of slope
            const filter_radius = light_of(light).filter.radius ?? 0, too_little = engine === 'unity_urp' ? 0.5 : 0.75;  // its planes have more
            for (const [kind, { settings, lacking, edges }, scale] of [['ours', bias, 1], ['too_little', bias, too_little],
                ['defaults', bias.defaults, 1]]) {
                lines.push([engine, filter, kind, map_size - 2 * border, width, range, filter_radius, reach, ...four(settings, scale), lacking, edges]);
            }
        }
    check(`${title}: the settings are enough`, enough);
    check(`${title}: nothing is detached by much more than the filter's reach`, close);
}
writeFileSync(numbers, lines.map(line => `${line.join('\t')}\n`).join(''));
console.log(`${lines.length} lines in ${numbers}`);

const of_cones = [];
for (const [engine, { title, filters, border = 0 }] of Object.entries(engines))
    for (const light of lights_of(engine).slice(1)) {
        let enough = true, close = true;
        for (const filter of Object.keys(filters))
            for (const [map_size, angle, range] of [[1024, 60, 10], [512, 110, 4], [2048, 40, 30]]) {
                const asked = { engine, light, filter, map_size, range, ...light === 'spot' && { angle } }, bias = engine_bias(asked);
                const { reach, texel, detachment } = bias, { error, secant, filter: { radius = 0 } } = light_of(asked);
                const ends = Object.values(bias.settings).includes(10), has_no_normal_bias = engine === 'unity_urp' && light === 'point';
                enough &&= bias.lacking === 0 ? !bias.striped
                    : (ends || has_no_normal_bias) && bias.striped[0] > (ends ? -1 : 30);
                close &&= detachment <= (reach + 3.5) * texel * secant + 2 * error * secant ** 3;  // with the slope of Unity's rasterizer
                for (const [kind, { settings, lacking, edges }, scale] of [['ours', bias, 1], ['too_little', bias, 0.5], ['defaults', bias.defaults, 1]]) {
                    of_cones.push([light, engine, filter, kind, map_size - 2 * border, light === 'spot' ? angle : 90, range, radius, reach, ...four(settings, scale), lacking, edges]);
                }
            }
        check(`${title}, ${light}: the settings are enough, but where Unity's end or lack a normal bias`, enough);
        check(`${title}, ${light}: nothing is detached by much more than the filter's reach and the depths' steps`, close);
    }
writeFileSync(cones, of_cones.map(line => `${line.join('\t')}\n`).join(''));
console.log(`${of_cones.length} lines in ${cones}`);

const given = { engine: 'three', map_size: 1024, width: 40, range: 100 }, { normalBias } = engine_bias(given).settings;
const fitted = parallel_offset(Math.sqrt(0.9) + Math.SQRT2, 40 / 1024, 100, [[40, 0, 0]]);
check(`three.js: ${normalBias} is the ${fitted} of fit_shadow, in four digits`, normalBias >= fitted && normalBias < fitted * 1.001);
const wide = engine_bias({ ...given, radius: 4 });
check(`a wider filter: ${wide.settings.normalBias}`, wide.settings.normalBias > 2 * normalBias && wide.detachment > 2 * normalBias);

const sharp = engine_bias({ ...given, engine: 'godot', radius: 0 });
check(`Godot without blur has no bias along the light: lacks ${sharp.lacking} texels`, sharp.lacking > 0.1 && sharp.striped[0] < 5);
const ultra = engine_bias({ ...given, engine: 'godot', filter: 'Soft Ultra', radius: 4 });
check(`Godot's slider ends: ${JSON.stringify(ultra.settings)}`, ultra.settings.shadow_normal_bias === 10 && ultra.lacking > 5);
const unity = engine_bias({ ...given, engine: 'unity_urp' });
check(`Unity: free beside edges up to ${unity.edges} degrees, three.js up to 90`, Math.abs(unity.edges - 45) < 0.1 && wide.edges === 90);
const filament = engine_bias({ ...given, engine: 'filament' });
check(`filament has a border: ${filament.texel}`, filament.texel === 40 / 1022);

for (const [what, options, said] of [
    ['nothing', undefined, 'engine must be one of three, godot, unity_urp, bevy, filament; engines.md says how to measure any other; got undefined'],
    ['null', null, 'options must be an object; got null'],
    ['Unreal', { ...given, engine: 'unreal' }, 'engine must be one of three, godot, unity_urp, bevy, filament; engines.md says'],
    ['a name of objects', { ...given, engine: 'toString' }, 'engine must be one of'],
    ['no width', { ...given, width: undefined }, 'width must be a finite number above 0; got undefined'],
    ['half a texel', { ...given, map_size: 0.5 }, 'map_size must be an integer from 16 to 65536; got 0.5'],
    ['no range', { ...given, range: 0 }, 'range must be a finite number above 0; got 0'],
    ['NaN', { ...given, width: NaN }, 'width must be a finite number above 0; got NaN'],
    ['a filter', { ...given, filter: 'Soft Low' }, 'filter must be one of PCFShadowMap, BasicShadowMap; got Soft Low'],
    ['a radius', { ...given, radius: -1 }, 'radius must be a finite number, 0 or more; got -1'],
    ['a radius of none', { ...given, engine: 'bevy', radius: 2 }, 'radius must not be given for Bevy, whose filters have none; got 2'],
    ['an extent', { ...given, extent: Infinity }, 'extent must be a finite number, 0 or more; got Infinity'],
    ['a light', { ...given, light: 'area' }, 'light must be directional, spot or point; got area'],
    ['no angle', { engine: 'bevy', light: 'spot', map_size: 512, range: 9 }, 'angle must be degrees above 0 and below 175; got undefined'],
    ['an angle of a point light', { engine: 'bevy', light: 'point', map_size: 512, range: 9, angle: 90 }, 'angle must not be given for a point light; got 90'],
    ['a width of a spot light', { ...given, engine: 'bevy', light: 'spot', angle: 60 }, 'width must not be given for a spot light; got 40'],
    ['an angle of a directional light', { ...given, angle: 60 }, 'angle must not be given for a directional light; got 60'],
    ["Godot's point lights", { engine: 'godot', light: 'point', map_size: 512, range: 9 }, 'light must be directional or spot for Godot 4; got point'],
    ["three.js' spot lights", { engine: 'three', light: 'spot', angle: 60, map_size: 512, range: 9 }, 'light must be directional for three.js; got spot'],
    ['a near plane beyond', { engine: 'bevy', light: 'point', map_size: 512, range: 9, near: 9 }, 'near must be below the distance; got 9'],
    ['a range below the near plane', { engine: 'filament', light: 'point', map_size: 512, range: 0.01 }, 'range must be above the near plane, 0.01; got 0.01'],
    ['too few texels', { engine: 'bevy', light: 'spot', angle: 170, map_size: 64, range: 9 }, 'map_size must be larger for this filter; got 64'],
    ['a misspelled option', { ...given, size: 1024 }, 'options must have no properties but engine, map_size, '],
]) {
    let message = 'accepted';
    try { engine_bias(options); } catch (error) { message = error.message; }
    check(`${what}: ${message}`, message.startsWith('umbrage/engines: engine_bias: ') && message.includes(said));
}
process.exitCode = failed ? 1 : 0;
