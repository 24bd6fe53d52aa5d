// SPDX-License-Identifier: MIT
//
// What a function's arguments stand for, guessed from their types and names. A reader can put any expression there.
import { without_comments, type Language, type Needed, type Signature } from './read';

/** Kinds of functions, in the order of check::subject. */
export const subjects = { filter: 'reads a shadow map', pack: 'packs a depth', unpack: 'unpacks a depth' } as const;
export type Subject = keyof typeof subjects;

/** A word of expressions, those of the program umbrage-check. `only`: the languages that have it. */
interface Word {
    word: string;
    means: string;
    only?: readonly Language[];
}
export const words: Record<Subject, readonly Word[]> = {
    filter: [
        { word: 'map', means: 'the depths, as a texture of floats' },
        { word: 'linear_map', means: 'the same, filtered' },
        { word: 'shadow_map', means: 'the depths, behind a comparison', only: ['glsl300', 'wgsl'] },
        {
            word: 'map_sampler',
            means: 'a sampler for each: also linear_map_sampler, shadow_map_sampler',
            only: ['wgsl'],
        },
        { word: 'size', means: 'the size of the map in texels, two floats' },
        { word: 'coord', means: 'the receiver in texels, two floats' },
        { word: 'uv', means: 'coord / size' },
        { word: 'z', means: 'the depth of the receiver, a float' },
    ],
    pack: [{ word: 'z', means: 'the depth to pack, a float' }],
    unpack: [{ word: 'c', means: 'the four channels to unpack, as sampled' }],
};

/** Textures and samplers of the page, and the types of variables that they can be. */
export const textures = {
    map: ['sampler2D', 'texture_2d'],
    linear_map: ['sampler2D', 'texture_2d'],
    shadow_map: ['sampler2DShadow', 'texture_depth_2d'],
    map_sampler: ['sampler'],
    linear_map_sampler: ['sampler'],
    shadow_map_sampler: ['sampler_comparison'],
} as const;
export type Texture = keyof typeof textures;

/** Those of a type, the usual one first; none for a type that is no texture. */
export const textures_of = (type: string): Texture[] =>
    (Object.keys(textures) as Texture[]).filter(name =>
        (textures[name] as readonly string[]).includes(plain_type(type)),
    );

/** A type as its kind and, for vectors, the number of components: "vec3f", "vec3<f32>" and "vec3" are the same. */
export const plain_type = (type: string) =>
    type
        .replace(/<f32>$|^(vec\d)f$/g, '$1')
        .replace(/^f32$/, 'float')
        .replace(/^[iu]32$|^uint$/, 'int');

const is_size = /size|resolution|dim|extent/i,
    is_step = /texel|pixel|inv|step|rcp/i,
    is_bias = /bias|offset|epsilon/i;

/** Coordinates of the library's own functions are in texels, all others' that we met in [0, 1]. */
const coordinate = ({ name }: Signature, argument: string) =>
    name.startsWith('umbrage_') || /texels?$/i.test(argument) ? 'coord' : 'uv';

function in_filter({ type, name }: Needed, of: Signature, body: string, vec: (n: number) => string): string {
    switch (plain_type(type)) {
        case 'vec2':
            if (is_step.test(name)) return '1.0 / size';
            return is_size.test(name) ? 'size' : coordinate(of, name);
        case 'vec3':
            return /normal|light|dir/i.test(name)
                ? `${vec(3)}(0.0, 0.0, 1.0)`
                : `${vec(3)}(${coordinate(of, name)}, z)`;
        case 'vec4': // a function that halves its argument takes it as the light's matrix gives it, from -1 to 1
            return /\*\s*0?\.5f?\s*\+/.test(body)
                ? `${vec(4)}(uv * 2.0 - 1.0, z * 2.0 - 1.0, 1.0)`
                : `${vec(4)}(${coordinate(of, name)}, z, 1.0)`;
        case 'float':
            if (is_bias.test(name)) return '0.0';
            if (is_size.test(name)) return 'size.x';
            if (is_step.test(name)) return '1.0 / size.x';
            if (/radius|spread|soft|scale|intensity|strength/i.test(name)) return '1.0';
            return 'z';
        case 'int':
            return /radius/i.test(name) ? '1' : '0';
        case 'bool':
            return 'false';
        default:
            return '';
    }
}

/** What kind of function it is. `reads_map`: the text has a texture of its own. */
export function subject_of({ arguments: all }: Signature, reads_map: boolean): Subject {
    const takes = all.map(each => plain_type(each.type)),
        one = takes.length === 1 ? takes[0]! : '';
    if (/^vec[234]$/.test(one) && !reads_map) return 'unpack';
    return one === 'float' && !reads_map ? 'pack' : 'filter';
}

/** An expression for something that is needed; empty where there is none to guess. */
export function guess(needed: Needed, of: Signature, subject: Subject, language: Language, body: string): string {
    const type = plain_type(needed.type),
        vec = (n: number) => (language === 'wgsl' ? `vec${n}f` : `vec${n}`);
    const [texture] = textures_of(type);
    if (texture) return texture;
    if (subject === 'filter') return in_filter(needed, of, body, vec);
    if (subject === 'pack') return type === 'float' ? 'z' : type === 'int' ? '0' : '';
    return { vec4: 'c', vec3: 'c.xyz', vec2: 'c.xy', float: 'c.x', int: '0' }[type] ?? '';
}

/** Names of functions that a reader means, the likeliest first. */
const telling = [/shadow|pcf|visib/i, /depth/i, /pack|filter|code/i, /./];

/** Functions that return something, and that no other of these calls. */
function outermost(functions: readonly Signature[], text: string): Signature[] {
    const lines = without_comments(text).split('\n'),
        returning = functions.filter(each => each.returns !== '');
    const body = (of: Signature) => {
        const next = functions[functions.indexOf(of) + 1];
        return lines.slice(of.line - 1, next && next.line - 1);
    };
    const calls = (of: Signature, name: string) => new RegExp(`\\b${name}\\s*\\(`).test(body(of).join('\n'));
    return returning.filter(each => !returning.some(other => other.name !== each.name && calls(other, each.name)));
}

/** The function that a reader means, most probably: an outermost one, of the likeliest name the last. */
export function chosen(functions: readonly Signature[], text: string): Signature | undefined {
    const outer = outermost(functions, text);
    for (const names of telling) {
        const found = outer.filter(each => names.test(each.name)).at(-1);
        if (found) return found;
    }
    return functions.at(-1);
}
