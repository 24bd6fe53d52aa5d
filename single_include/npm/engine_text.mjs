// SPDX-License-Identifier: MIT
//
// Parts that the addons of engines share: both languages' words, and functions in an engine's text.
import * as glsl from '../umbrage.mjs';
import * as wgsl from '../wgsl.mjs';
import { check_filter, check_options, checked_arguments, checked_later, end_of_body, flag, must } from './options.mjs';

/** Each language's module, and its words. */
export const languages = {
    glsl: {
        bind: glsl.bind, text: items => glsl.text(items, '300 es'),
        rotation: glsl.disc_rotation, probe_color: glsl.probe_color,
        vec2: 'vec2', vec3: 'vec3', vec4: 'vec4', local: type => type,
        global: (type, name, value) => `highp ${type} ${name} = ${value};`,
        first_bits: value => `uintBitsToFloat(floatBitsToUint(${value}) & 0xffff0000u)`,
    },
    wgsl: {
        bind: wgsl.bind, text: wgsl.text, rotation: wgsl.disc_rotation, probe_color: wgsl.probe_color,
        vec2: 'vec2f', vec3: 'vec3f', vec4: 'vec4f', local: () => 'let',
        global: (type, name, value) => `var<private> ${name}: ${type}f = ${value};`,
        first_bits: value => `bitcast<f32>(bitcast<u32>(${value}) & 0xffff0000u)`,
    },
};

/** Checked options: a filter in the language that the engine compiles, and its arguments. The addon may have further options. */
export function checked_options(where, name, options, further) {
    check_options(where, options,
        { glsl: checked_later, wgsl: checked_later, arguments: checked_later, frame: flag, probe: flag, ...further });
    const filter = options[name];
    must(where, filter !== undefined, `${name} must be given, a filter of this package, for this engine`, filter);
    for (const language of Object.keys(languages))
        if (options[language] !== undefined) check_filter(where, language, options[language], language.toUpperCase());
    const { frame = false, probe = false } = options;
    return { filter, given: checked_arguments(where, filter, options.arguments), frame, probe };
}

/** A light's size in texels as the radius that scales a softness: 1.0 for 256 texels across all depths. The first eight bits,
 *  as make_penumbra_params rounds, so that penumbras have C++'s bits. */
export const light_radius = (language, texels) => language.first_bits(`(${texels}) / 256.0`);

/** Globals for a probe or a test: the last receiver, and its color. */
export function globals(language, probe) {
    const { vec3, vec4 } = language;
    return `${language.global('vec4', 'umbrage_receiver', `${vec4}(0.0)`)}  // texels, texels, depth, visibility\n`
        + (probe ? `${language.global('vec3', 'umbrage_color', `${vec3}(0.5)`)}\n` : '');
}

/** Calls of the filter and the probe. The visibility is in umbrage_receiver.w. */
export function filtered(language, { filter, probe }, { map, maps, size, at, z, layer, further }) {
    const layered = layer === undefined ? '' : `${layer}, `;
    return `umbrage_receiver = ${language.vec4}(${at}, ${z}, 0.0);
    umbrage_receiver.w = umbrage_${filter.name}_${map}(
        ${maps}, ${layered}${size}, umbrage_receiver.xy, umbrage_receiver.z${further});
${probe ? `    umbrage_color = umbrage_probe_color_${map}(umbrage_receiver.xyz, ${size}, 0.0, ${layer ?? '0.0'});\n` : ''}`;
}

/** The text with another body in a function, which is known by its head, up to its brace. */
export function with_body(where, text, head, body, known) {
    const at = text.indexOf(head), begin = at + head.length;
    must(where, at >= 0 && text.indexOf(head, begin) < 0, known, `another text of ${head.match(/\w+(?=\()/)}`);
    return `${text.slice(0, begin)}\n    ${body}${text.slice(end_of_body(text, begin) - 1)}`;
}
