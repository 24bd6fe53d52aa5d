// SPDX-License-Identifier: MIT
//
// A whole shader around a reader's text: it reads an input, makes the call, and writes what the function returned.
import { plain_type, textures_of, type Subject, type Texture } from './guess';
import { signature, type Global, type Language, type Reading, type Signature } from './read';

/** A value that is called for, and the expression that stands for it. */
export interface Bound {
    name: string;
    type: string;
    expression: string;
}

/** Which function is called, with what. */
export interface Call {
    language: Language;
    text: string;
    subject: Subject;
    of: Signature;
    arguments: Bound[];
    /** Textures and samplers of the text; their expressions are names of the page's. */
    textures: Bound[];
    /** Its uniforms of numbers; their expressions know the map's size alone. */
    uniforms: Bound[];
}

/** A shader, and where the reader's words are in it. */
export interface Program {
    shader: string;
    /** Lines before those of the text, lines of the text, and the line of the first argument. */
    before: number;
    lines: number;
    first_argument: number;
}

/** A sentence for somebody whose text or call cannot run. `line` is one of the text. */
export class Refused extends Error {
    constructor(
        message: string,
        readonly line: number | null = null,
        readonly details = '',
    ) {
        super(message);
    }
}

/** Types of uniforms to which the page gives a value. */
export const settable_uniforms: readonly string[] = ['float', 'vec2', 'vec3', 'vec4', 'int', 'bool'];

/** The page's texture or sampler that a variable of the text is. */
export const texture_of = ({ expression }: Bound) => expression.trim() as Texture;

/** Whether the call takes depths that are filtered, which not all GPUs do with floats. */
export const filters_floats = (call: Call) =>
    [...call.arguments, ...call.textures].some(each => /\blinear_map/.test(each.expression));

export const uniforms_of = ({ globals }: Reading): Global[] => globals.filter(each => each.kind === 'uniform');

const count = (text: string) => text.split('\n').length - 1;

/** The result as four components, zero where the function has none. */
function as_four(type: string, value: string, language: Language): string {
    const four = language === 'wgsl' ? 'vec4f' : 'vec4',
        one = language === 'wgsl' ? 'f32' : 'float';
    const zeros = { vec4: '', vec3: ', 0.0', vec2: ', 0.0, 0.0', float: ', 0.0, 0.0, 0.0' }[type];
    if (zeros === '') return value;
    if (zeros) return `${four}(${value}${zeros})`;
    if (type === 'int' || type === 'bool') return `${four}(${one}(${value}), 0.0, 0.0, 0.0)`;
    throw new Refused(`The function returns ${type}. The page compares floats, and vectors of them.`);
}

/** The call on lines of its own, an argument on each, so that a message about one has its line. */
const call_text = ({ of, arguments: all }: Call): string =>
    all.length ? `${of.name}(\n${all.map(each => each.expression).join(',\n')})` : `${of.name}()`;

/** For a text in another language of shaders. */
const hlsl_hint = ({ language, text }: Call) =>
    language !== 'wgsl' && /\b(float[234]|SamplerState|Texture2D)\b/.test(text)
        ? ' The text looks like HLSL. Browsers run GLSL and WGSL; the program umbrage-check takes HLSL too.'
        : '';

/** Refuses what no compiler has to see. */
export function refuse_unfit(reading: Reading, of: Signature | undefined, call: Call): void {
    if (reading.include)
        throw new Refused(
            `Line ${reading.include.line} includes ${reading.include.file}. ` +
                'Browsers follow no #include. Put the text of that file in its place.',
            reading.include.line,
        );
    if (!of) throw new Refused('The text has no function with a body. Paste a whole function, with what it calls.');
    if (of.returns === '')
        throw new Refused(`${of.name} returns nothing. Wrap it in a function that returns the result.`, of.line);
    if (call.arguments.length !== of.arguments.length)
        throw new Refused(
            `${signature(of)} takes ${of.arguments.length} arguments, and the address has ${call.arguments.length}.`,
            of.line,
        );
    for (const { name, type, expression } of call.textures) {
        const known = textures_of(type);
        if (!(known as string[]).includes(expression.trim()))
            throw new Refused(`${name} is ${expression}. It is of type ${type}, so it can be ${known.join(' or ')}.`);
    }
    for (const { name, type, expression } of [...call.arguments, ...call.uniforms])
        if (expression.trim() === '')
            throw new Refused(
                `Say what stands for ${name || 'the argument'}, of type ${type}.${hlsl_hint(call)}`,
                of.line,
            );
}

// ---- GLSL ----

/** Inputs as variables that expressions may use. */
const glsl_inputs: Record<Subject, string> = {
    filter: 'vec2 size = umbrage_size, coord = umbrage_input.xy, uv = coord / size; float z = umbrage_input.z;',
    pack: 'float z = umbrage_input.x;',
    unpack: 'vec4 c = umbrage_input;',
};

/** A float's bits as four bytes, least first, for targets of bytes. Powers of two change no bit of a mantissa. */
const float_bytes = `
float umbrage_chosen(vec4 v) {
    if (umbrage_component == 0) return v.x;
    if (umbrage_component == 1) return v.y;
    return umbrage_component == 2 ? v.z : v.w;
}
vec4 umbrage_bytes(float v) {
    float a = abs(v), e = 127.0, s = v < 0.0 ? 128.0 : 0.0;
    if (!(v == v)) return vec4(0.0, 0.0, 192.0, 127.0) / 255.0;
    if (a < 1.17549435e-38) return vec4(0.0);
    if (a > 3.4028235e38) return vec4(0.0, 0.0, 128.0, s + 127.0) / 255.0;
    if (a >= 18446744073709551616.0) { a *= 5.421010862427522e-20; e += 64.0; }
    if (a >= 4294967296.0) { a *= 2.3283064365386963e-10; e += 32.0; }
    if (a >= 65536.0) { a *= 1.52587890625e-5; e += 16.0; }
    if (a >= 256.0) { a *= 0.00390625; e += 8.0; }
    if (a >= 16.0) { a *= 0.0625; e += 4.0; }
    if (a >= 4.0) { a *= 0.25; e += 2.0; }
    if (a >= 2.0) { a *= 0.5; e += 1.0; }
    if (a < 1.0842021724855044e-19) { a *= 18446744073709551616.0; e -= 64.0; }
    if (a < 4.656612873077393e-10) { a *= 4294967296.0; e -= 32.0; }
    if (a < 3.0517578125e-5) { a *= 65536.0; e -= 16.0; }
    if (a < 0.0078125) { a *= 256.0; e -= 8.0; }
    if (a < 0.125) { a *= 16.0; e -= 4.0; }
    if (a < 0.5) { a *= 4.0; e -= 2.0; }
    if (a < 1.0) { a *= 2.0; e -= 1.0; }
    float m = (a - 1.0) * 8388608.0, high = floor(m / 65536.0), half_e = floor(e * 0.5);
    float middle = floor((m - high * 65536.0) / 256.0);
    return vec4(m - high * 65536.0 - middle * 256.0, middle, high + (e - half_e * 2.0) * 128.0, s + half_e) / 255.0;
}`;

const precise = ['float', 'int', 'sampler2D', 'samplerCube'].map(type => `precision highp ${type};`).join(' ');
const precise_300 = [
    'sampler2DShadow',
    'sampler2DArray',
    'sampler2DArrayShadow',
    'sampler3D',
    'isampler2D',
    'usampler2D',
    'samplerCubeShadow',
]
    .map(type => `precision highp ${type};`)
    .join(' ');

/** The text's own output, which then carries the results: a shader without locations has one output. */
function output_of(globals: readonly Global[]): string | null {
    const outputs = globals.filter(each => each.kind === 'output');
    if (outputs.length === 0) return null;
    if (outputs.length > 1 || outputs[0]!.type !== 'vec4')
        throw new Refused('The text has outputs other than one vec4. Leave them out, and main() with them.');
    return outputs[0]!.name;
}

/** @param as_bytes   for a target of bytes: one component of the result, whose number is umbrage_component */
export function glsl_program(call: Call, { globals }: Reading, as_bytes: boolean): Program {
    const is_300 = call.language === 'glsl300',
        texture = is_300 ? 'texture' : 'texture2D',
        own = is_300 ? output_of(globals) : null;
    const first = /^[ \t]*#[ \t]*(version|extension)[^\n]*/gm,
        text = call.text.replace(first, ''); // they stand before all else
    const extensions = Array.from(call.text.matchAll(first))
        .filter(match => match[1] === 'extension')
        .map(match => match[0].trim());
    const directives = [...(is_300 ? ['#version 300 es'] : []), ...extensions].map(line => `${line}\n`).join('');
    const before = `${directives}${precise}${is_300 ? precise_300 : ''}
#define main umbrage_main_of_the_text
`;
    const declared = (type: string, name: string) =>
        globals.some(each => each.name === name) ? '' : `uniform highp ${type} ${name};\n`;
    const after = `
#undef main
${precise}
uniform sampler2D umbrage_inputs;
uniform vec2 umbrage_size;
uniform int umbrage_component;
${declared('sampler2D', 'map')}${declared('sampler2D', 'linear_map')}
${is_300 ? declared('sampler2DShadow', 'shadow_map') : ''}
${is_300 ? 'in' : 'varying'} vec2 umbrage_at;
${is_300 && !own ? 'out vec4 umbrage_result;' : ''}${as_bytes ? float_bytes : ''}
void main() {
    vec4 umbrage_input = ${texture}(umbrage_inputs, umbrage_at);
    ${glsl_inputs[call.subject]}
    ${call.of.returns} umbrage_returned = `;
    const target = own ?? (is_300 ? 'umbrage_result' : 'gl_FragColor'),
        result = as_four(plain_type(call.of.returns), 'umbrage_returned', call.language);
    const write = as_bytes ? 'umbrage_bytes(umbrage_chosen(umbrage_four))' : 'umbrage_four';
    const head = before + text + after;
    return {
        shader: `${head}${call_text(call)};\n    vec4 umbrage_four = ${result};\n    ${target} = ${write};\n}\n`,
        before: count(before),
        lines: count(text) + 1,
        first_argument: count(head) + 2,
    };
}

/** A vertex shader that covers the target, with outputs for what the text takes as inputs. */
export function glsl_vertex(language: Language, { globals }: Reading): string {
    const is_300 = language === 'glsl300',
        out = is_300 ? 'out' : 'varying',
        inputs = globals.filter(each => each.kind === 'input');
    const outputs = inputs.map(({ type, name }) => `${/int/.test(type) ? 'flat ' : ''}${out} ${type} ${name};\n`);
    return `${is_300 ? '#version 300 es\n' : ''}precision highp float;
${is_300 ? 'in' : 'attribute'} vec2 corner;
${out} vec2 umbrage_at;
${outputs.join('')}void main() {
    umbrage_at = corner * 0.5 + 0.5;
    gl_Position = vec4(corner, 0.0, 1.0);
}
`;
}

/** The value of a uniform as a call of nothing: its expression in a shader without the text. */
export const uniform_call = ({ language }: Call, { type, expression }: Bound): Call => ({
    language,
    text: '',
    subject: 'filter',
    textures: [],
    uniforms: [],
    arguments: [{ name: '', type, expression }],
    of: { name: '', returns: type, arguments: [], line: 0 },
});

// ---- WGSL ----

/** Group of the page's own textures, which leaves the others to the text. */
export const own_group = 3;
export const own_bindings: readonly [name: Texture | 'umbrage_inputs' | 'umbrage_map', type: string][] = [
    ['umbrage_inputs', 'texture_2d<f32>'],
    ['umbrage_map', 'texture_2d<f32>'], // map, which the text may have as a name of something else
    ['map', 'texture_2d<f32>'],
    ['linear_map', 'texture_2d<f32>'],
    ['shadow_map', 'texture_depth_2d'],
    ['map_sampler', 'sampler'],
    ['linear_map_sampler', 'sampler'],
    ['shadow_map_sampler', 'sampler_comparison'],
];

const wgsl_inputs: Record<Subject, string> = {
    filter: `let size = vec2f(textureDimensions(umbrage_map));
    let coord = umbrage_input.xy; let uv = coord / size; let z = umbrage_input.z;`,
    pack: 'let z = umbrage_input.x;',
    unpack: 'let c = umbrage_input;',
};

/** The text is first, so that its lines are those of the shader. */
export function wgsl_program(call: Call, { globals }: Reading): Program {
    const other = globals.find(each => each.kind === 'uniform' && textures_of(each.type).length === 0);
    if (other)
        throw new Refused(
            `${other.name} is no texture and no sampler. Make what the function takes of it an argument.`,
        );
    const own = own_bindings.map(([name, type], binding) =>
        globals.some(each => each.name === name)
            ? ''
            : `@group(${own_group}) @binding(${binding}) var ${name}: ${type};\n`,
    );
    const head = `${call.text}
${own.join('')}@fragment fn umbrage_check(@builtin(position) umbrage_pixel: vec4f) -> @location(0) vec4f {
    let umbrage_input = textureLoad(umbrage_inputs, vec2i(umbrage_pixel.xy), 0);
    ${wgsl_inputs[call.subject]}
    let umbrage_returned = `;
    const result = as_four(plain_type(call.of.returns), 'umbrage_returned', 'wgsl');
    return {
        shader: `${head}${call_text(call)};\n    return ${result};\n}\n`,
        before: 0,
        lines: count(call.text) + 1,
        first_argument: count(head) + 2,
    };
}

/** A compiler's message about a program, by the reader's lines. */
export function explained(
    call: Call,
    { before, lines, first_argument }: Program,
    messages: readonly { line: number; words: string }[],
): Refused {
    const { line, words: whole } = messages[0] ?? {
        line: 0,
        words: 'The shader does not compile, and the browser gives no reason.',
    };
    const words = whole.split('\n')[0]!;
    const own = line - before,
        argument = call.arguments[line - first_argument];
    const undeclared = /'(\w+)' ?: undeclared identifier|unresolved value '(\w+)'/.exec(words),
        name = undeclared?.[1] ?? undeclared?.[2];
    const hint =
        name && !call.arguments.some(each => each.expression.includes(name))
            ? ` Declare ${name} above the function, such as a uniform, and the page offers to give it a value.`
            : hlsl_hint(call);
    const all = messages.map(each => each.words).join('\n');
    if (own >= 1 && own <= lines) return new Refused(`Line ${own}: ${words}${hint}`, own, all);
    if (argument)
        return new Refused(`${argument.name || 'The argument'} = ${argument.expression}: ${words}`, null, all);
    return new Refused(
        `The call ${call.of.name}(${call.arguments.map(each => each.expression).join(', ')}): ${words}`,
        null,
        all,
    );
}
