// Declarations of a shadow in a shader: its uniform block, its map, and a function of world and normal alone.
//
// A block is mat4s and vec4s, which std140, cbuffers, WGSL and Metal lay out alike. GLSL 100 to 130 has no blocks:
// there it is an array of vec4, and glUniform4fv takes the same bytes.
const { laid_out } = require('./fill.cjs');

const prefix = i => `umbrage_${i.name}`;
/** A declared parameter under another name: "sampler2D map" as "sampler2D umbrage_sun_map". */
const renamed = (declaration, from, to) => declaration.startsWith(`${from}:`) ? declaration.replace(from, to)
    : declaration.replace(` ${from}`, ` ${to}`);
const call = (i, map, sampler, members) => `umbrage_shadow_${i.name}(${[map, ...sampler ? [sampler] : [], ...members, 'world', 'normal',
    ...i.turns ? ['pixel'] : []].join(', ')})`;
const with_head = (i, head, called) =>
    `\n// ${prefix(i)}: visibility of a point of the world, 1.0 is lit; a normal of zero is none\n`
    + laid_out(`${head} {\n    return ${called};\n}\n`);

function declare_in_glsl(i, { map }, version) {
    if (version === undefined) throw new Error("umbrage: text: version must be given for a shadow's uniforms; got none");
    const number = parseInt(version), es = version === '100' || version.endsWith('es'), high = es ? 'highp ' : '';
    const has_blocks = number >= (es ? 300 : 150), binds = number >= (es ? 310 : 430);
    const block = `${prefix(i)}_block`, texture = `${prefix(i)}_map`;
    let vectors = 0;
    const members = i.fields.map(({ name, matrix }) => {
        if (has_blocks) return `${prefix(i)}_${name}`;
        const vector = () => `${block}[${vectors++}]`;
        return matrix ? `mat4(${vector()}, ${vector()}, ${vector()}, ${vector()})` : vector();
    });
    const head = `layout(std140${binds ? `, binding = ${i.block}` : ''}) uniform ${block} {\n`;
    const lines = i.fields.map(({ name, matrix }) => `    ${high}${matrix ? 'mat4' : 'vec4'} ${prefix(i)}_${name};\n`);
    return '\n' + (has_blocks ? `${head}${lines.join('')}};\n` : `uniform ${high}vec4 ${block}[${vectors}];\n`)
        + `${binds ? `layout(binding = ${i.texture}) ` : ''}uniform ${renamed(map, 'map', texture)};\n`
        + with_head(i, `${high}float ${prefix(i)}(${high}vec3 world, ${high}vec3 normal${i.turns ? `, ${high}vec2 pixel` : ''})`,
            call(i, texture, '', members));
}

function declare_in_hlsl(i, { map, sampler }) {
    const slot = (kind, number) => ` : register(${kind}${number}${i.set > 0 ? `, space${i.set}` : ''})`;
    const texture = `${prefix(i)}_map`, own_sampler = sampler && `${prefix(i)}_sampler`;
    const lines = i.fields.map(({ name, matrix }) =>
        `    ${matrix ? 'column_major float4x4' : 'float4'} ${prefix(i)}_${name};\n`);
    return `\ncbuffer ${prefix(i)}_block${slot('b', i.block)} {\n${lines.join('')}};\n`
        + `${renamed(map, 'map', texture)}${slot('t', i.texture)};\n`
        + (sampler && `${renamed(sampler, 'map_sampler', own_sampler)}${slot('s', i.sampler)};\n`)
        + with_head(i, `float ${prefix(i)}(float3 world, float3 normal${i.turns ? ', float2 pixel' : ''})`,
            call(i, texture, own_sampler, i.fields.map(({ name }) => `${prefix(i)}_${name}`)));
}

function declare_in_wgsl(i, { map, sampler }) {
    const slot = number => `@group(${i.set}) @binding(${number}) var`, block = `${prefix(i)}_block`, uniforms = `${prefix(i)}_uniforms`;
    const texture = `${prefix(i)}_map`, own_sampler = sampler && `${prefix(i)}_sampler`;
    const lines = i.fields.map(({ name, matrix }) => `    ${name}: ${matrix ? 'mat4x4f' : 'vec4f'},\n`);
    return `\nstruct ${block} {\n${lines.join('')}}\n${slot(i.block)}<uniform> ${uniforms}: ${block};\n`
        + `${slot(i.texture)} ${renamed(map, 'map', texture)};\n`
        + (sampler && `${slot(i.sampler)} ${renamed(sampler, 'map_sampler', own_sampler)};\n`)
        + with_head(i, `fn ${prefix(i)}(world: vec3f, normal: vec3f${i.turns ? ', pixel: vec2f' : ''}) -> f32`,
            call(i, texture, own_sampler, i.fields.map(({ name }) => `${uniforms}.${name}`)));
}

function declare_in_msl(i, { map, sampler }) {
    const block = `${prefix(i)}_block`;
    const lines = i.fields.map(({ name, matrix }) => `    ${matrix ? 'metal::float4x4' : 'float4'} ${name};\n`);
    return `\nstruct ${block} {\n${lines.join('')}};\n`
        + with_head(i, `inline float ${prefix(i)}(constant ${block}& block, ${map}${sampler && `, ${sampler}`}, `
            + `float3 world, float3 normal${i.turns ? ', float2 pixel' : ''})`,
        call(i, 'map', sampler && 'map_sampler', i.fields.map(({ name }) => `block.${name}`)));
}

module.exports = {
    declare_in_glsl,
    declare_in_hlsl,
    declare_in_wgsl,
    declare_in_msl,
};
