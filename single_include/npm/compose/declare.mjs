// Declarations of a shadow in a shader: its uniform block, its map, and functions of world and normal alone.
//
// A block is mat4s and vec4s, which std140, cbuffers, WGSL and Metal lay out alike. GLSL 100 to 130 has no blocks:
// there it is an array of vec4, and glUniform4fv takes the same bytes.
import { must_in } from './check.mjs';
import { laid_out } from './map_words.mjs';

const must = /*#__PURE__*/ must_in('text');

const prefix = i => `umbrage_${i.name}`;
/** A declared parameter under another name: "sampler2D map" as "sampler2D umbrage_sun_map". */
const renamed = (declaration, from, to) => declaration.startsWith(`${from}:`) ? declaration.replace(from, to)
    : declaration.replace(` ${from}`, ` ${to}`);
/** Call of a function with all its arguments: the map, the block's members, and its own. `normal`: of the derivatives. */
const call = (i, f, map, sampler, members, normal) => `umbrage_${f.calls}_${i.name}(${[
    ...f.reads_map ? [map, ...sampler ? [sampler] : []] : [], ...f.reads_fields ? members : members.slice(-2),
    ...f.arguments.map(([name, , derived]) => derived ? normal : name)].join(', ')})`;
const with_head = (name, f, head, called) => `\n// ${name}: ${f.says}\n` + laid_out(`${head} {\n    return ${called};\n}\n`);
const name_of = (i, f) => f.name === '' ? prefix(i) : `umbrage_${f.name}_${i.name}`;
/** What a text declares, and what no other shadow of it may have: names, the functions' first, and slots. */
const declared = (i, names, slots, text) => ({ text, slots, names: [...i.functions.map(f => name_of(i, f)), ...names] });
const names_of_fields = i => i.fields.map(({ name }) => `${prefix(i)}_${name}`);
/** The shadow's functions: a head of type and parameters, and the call. */
const functions = (i, head, called) => i.functions.map(f => with_head(name_of(i, f), f, head(name_of(i, f), f), called(f))).join('');
const joined = (f, one) => f.arguments.filter(([, , derived]) => !derived).map(([name, components]) => one(name, components)).join(', ');
const float_type = components => components === 1 ? 'float' : `float${components}`;

export function declare_in_glsl(i, { map }, version) {
    must(version !== undefined, "version must be given for a shadow's uniforms", 'none');
    const number = parseInt(version), es = version === '100' || version.endsWith('es'), high = es ? 'highp ' : '';
    const has_blocks = number >= (es ? 300 : 150), binds = number >= (es ? 310 : 430);
    const block = `${prefix(i)}_block`, texture = `${prefix(i)}_map`;
    let vectors = 0;
    const members = i.fields.map(({ name, matrix }) => {
        if (has_blocks) return `${prefix(i)}_${name}`;
        const vector = () => `${block}[${vectors++}]`;
        return matrix ? `mat4(${vector()}, ${vector()}, ${vector()}, ${vector()})` : vector();
    });
    const type = components => high + (components === 1 ? 'float' : `vec${components}`);
    const head = `layout(std140${binds ? `, binding = ${i.block}` : ''}) uniform ${block} {\n`;
    const lines = i.fields.map(({ name, matrix }) => `    ${high}${matrix ? 'mat4' : 'vec4'} ${prefix(i)}_${name};\n`);
    const slots = binds ? [`binding ${i.block} of uniform blocks`, `binding ${i.texture} of textures`] : [];
    return declared(i, [block, texture, ...has_blocks ? names_of_fields(i) : []], slots,
        '\n' + (has_blocks ? `${head}${lines.join('')}};\n` : `uniform ${high}vec4 ${block}[${vectors}];\n`)
        + `${binds ? `layout(binding = ${i.texture}) ` : ''}uniform ${renamed(map, 'map', texture)};\n`
        + functions(i, (name, f) => `${type(f.components)} ${name}(${joined(f, (own, n) => `${type(n)} ${own}`)})`,
            f => call(i, f, texture, '', members, 'cross(dFdx(world), dFdy(world))')));
}

export function declare_in_hlsl(i, { map, sampler }) {
    const slot = (kind, number) => ` : register(${kind}${number}${i.set > 0 ? `, space${i.set}` : ''})`;
    const texture = `${prefix(i)}_map`, own_sampler = sampler && `${prefix(i)}_sampler`, block = `${prefix(i)}_block`;
    const slots = [`b${i.block}`, `t${i.texture}`, ...sampler ? [`s${i.sampler}`] : []].map(one => `register ${one} of space ${i.set}`);
    const lines = i.fields.map(({ name, matrix }) =>
        `    ${matrix ? 'column_major float4x4' : 'float4'} ${prefix(i)}_${name};\n`);
    return declared(i, [block, texture, own_sampler, ...names_of_fields(i)], slots, `\ncbuffer ${block}${slot('b', i.block)} {\n${lines.join('')}};\n`
        + `${renamed(map, 'map', texture)}${slot('t', i.texture)};\n`
        + (sampler && `${renamed(sampler, 'map_sampler', own_sampler)}${slot('s', i.sampler)};\n`)
        + functions(i, (name, f) => `${float_type(f.components)} ${name}(${joined(f, (own, n) => `${float_type(n)} ${own}`)})`,
            f => call(i, f, texture, own_sampler, names_of_fields(i), 'cross(ddx(world), ddy(world))')));
}

export function declare_in_wgsl(i, { map, sampler }) {
    const slot = number => `@group(${i.set}) @binding(${number}) var`, block = `${prefix(i)}_block`, uniforms = `${prefix(i)}_uniforms`;
    const texture = `${prefix(i)}_map`, own_sampler = sampler && `${prefix(i)}_sampler`;
    const lines = i.fields.map(({ name, matrix }) => `    ${name}: ${matrix ? 'mat4x4f' : 'vec4f'},\n`);
    const type = components => components === 1 ? 'f32' : `vec${components}f`;
    const slots = [i.block, i.texture, ...sampler ? [i.sampler] : []].map(number => `binding ${number} of group ${i.set}`);
    return declared(i, [block, uniforms, texture, own_sampler], slots, `\nstruct ${block} {\n${lines.join('')}}\n${slot(i.block)}<uniform> ${uniforms}: ${block};\n`
        + `${slot(i.texture)} ${renamed(map, 'map', texture)};\n`
        + (sampler && `${slot(i.sampler)} ${renamed(sampler, 'map_sampler', own_sampler)};\n`)
        + functions(i, (name, f) => `fn ${name}(${joined(f, (own, n) => `${own}: ${type(n)}`)}) -> ${type(f.components)}`,
            f => call(i, f, texture, own_sampler, i.fields.map(({ name }) => `${uniforms}.${name}`), 'cross(dpdx(world), dpdy(world))')));
}

export function declare_in_msl(i, { map, sampler }) {
    const block = `${prefix(i)}_block`;
    const lines = i.fields.map(({ name, matrix }) => `    ${matrix ? 'metal::float4x4' : 'float4'} ${name};\n`);
    return declared(i, [block], [], `\nstruct ${block} {\n${lines.join('')}};\n`
        + functions(i, (name, f) => `inline ${float_type(f.components)} ${name}(constant ${block}& block, `
            + (f.reads_map ? `${map}${sampler && `, ${sampler}`}, ` : '') + `${joined(f, (own, n) => `${float_type(n)} ${own}`)})`,
        f => call(i, f, 'map', sampler && 'map_sampler', i.fields.map(({ name }) => `block.${name}`),
            'metal::cross(metal::dfdx(world), metal::dfdy(world))')));
}
