// SPDX-License-Identifier: MIT
//
// Runs a call in WebGL 1 or 2: a triangle over a target that has a pixel for each input.
import {
    explained,
    filters_floats,
    glsl_program,
    glsl_vertex,
    Refused,
    texture_of,
    uniform_call,
    type Bound,
    type Call,
} from './program';
import type { Reading } from './read';
import type { Batch, Gpu, Prepared } from './run';

type GL = WebGL2RenderingContext; // of which WebGL 1 has what is used for it
const width = 256;
const units = { umbrage_inputs: 0, map: 1, linear_map: 2, shadow_map: 3 } as const,
    spare_unit = 4;

const canvas = () => (typeof document === 'undefined' ? new OffscreenCanvas(1, 1) : document.createElement('canvas'));

export function open_webgl(version: 1 | 2): Gpu {
    const name = `WebGL ${version}`,
        gl = canvas().getContext(version === 1 ? 'webgl' : 'webgl2', { antialias: false }) as GL | null;
    if (!gl) throw new Refused(`This browser offers no ${name}.`);
    if (version === 1 && !gl.getExtension('OES_texture_float'))
        throw new Refused('WebGL 1 has no textures of floats here, which hold the inputs.');
    const as_bytes = !gl.getExtension(version === 1 ? 'WEBGL_color_buffer_float' : 'EXT_color_buffer_float');
    const smooth = gl.getExtension('OES_texture_float_linear') !== null,
        names = gl.getExtension('WEBGL_debug_renderer_info');
    gl.disable(gl.DITHER);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 3, -1, -1, 3]), gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 0, 0);
    const rows = new Target(gl, version, as_bytes);
    return {
        name,
        device: String(gl.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : gl.RENDERER)),
        async prepare(call, reading) {
            if (filters_floats(call) && !smooth) throw new Refused(`${name} does not filter textures of floats here.`);
            return prepare(gl, version, rows, call, reading);
        },
    };
}

/** A target of as many rows as were ever needed. */
class Target {
    private readonly frame: WebGLFramebuffer;
    private rows = 0;
    constructor(
        private readonly gl: GL,
        private readonly version: 1 | 2,
        readonly as_bytes: boolean,
    ) {
        this.frame = gl.createFramebuffer()!;
    }

    bind(rows: number): void {
        const { gl } = this;
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.frame);
        if (rows !== this.rows) {
            const color = texture(gl, spare_unit);
            if (this.as_bytes)
                gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, width, rows, 0, gl.RGBA, gl.UNSIGNED_BYTE, null);
            else upload(gl, this.version, width, rows, null);
            gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, color, 0);
            if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE)
                throw new Refused('The browser takes no such target.');
            gl.activeTexture(gl.TEXTURE0 + spare_unit);
            gl.bindTexture(gl.TEXTURE_2D, null);
            this.rows = rows;
        }
        gl.viewport(0, 0, width, rows);
    }
}

/** A new texture in the place of the unit's last one. */
function texture(gl: GL, unit: number, filter: number = gl.NEAREST): WebGLTexture {
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.deleteTexture(gl.getParameter(gl.TEXTURE_BINDING_2D));
    const made = gl.createTexture()!;
    gl.bindTexture(gl.TEXTURE_2D, made);
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, filter);
    for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
    return made;
}

const upload = (gl: GL, version: 1 | 2, columns: number, rows: number, floats: Float32Array | null) =>
    gl.texImage2D(gl.TEXTURE_2D, 0, version === 1 ? gl.RGBA : gl.RGBA32F, columns, rows, 0, gl.RGBA, gl.FLOAT, floats);

/** Depths as red. A depth texture's other channels are 0, 0 and 1. */
const red = (depths: Float32Array) =>
    Float32Array.from({ length: depths.length * 4 }, (_, i) => (i % 4 === 0 ? depths[i / 4]! : i % 4 === 3 ? 1 : 0));

function give_map(gl: GL, version: 1 | 2, { size: [columns, rows], map }: Batch): void {
    for (const [unit, filter] of [
        [units.map, gl.NEAREST],
        [units.linear_map, gl.LINEAR],
    ] as const) {
        texture(gl, unit, filter);
        upload(gl, version, columns, rows, red(map));
    }
    if (version === 1) return;
    texture(gl, units.shadow_map, gl.LINEAR);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_COMPARE_FUNC, gl.LEQUAL);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.DEPTH_COMPONENT32F, columns, rows, 0, gl.DEPTH_COMPONENT, gl.FLOAT, map);
}

/** Messages of a log: "ERROR: 0:12: 'x' : undeclared identifier". */
const messages = (log: string) =>
    Array.from(log.matchAll(/^ERROR: \d+:(\d+): (.*)$/gm), ([, line, words]) => ({
        line: Number(line),
        words: words!.trim(),
    }));

function link(gl: GL, call: Call, reading: Reading, as_bytes: boolean): WebGLProgram {
    const made = gl.createProgram(),
        program = glsl_program(call, reading, as_bytes);
    const [fragment, vertex] = (
        [
            [gl.FRAGMENT_SHADER, program.shader],
            [gl.VERTEX_SHADER, glsl_vertex(call.language, reading)],
        ] as const
    ).map(([stage, text]) => {
        const shader = gl.createShader(stage)!;
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        gl.attachShader(made, shader);
        return shader;
    });
    gl.bindAttribLocation(made, 0, 'corner');
    gl.linkProgram(made);
    if (gl.getProgramParameter(made, gl.LINK_STATUS)) return made;
    if (gl.isContextLost()) throw new Refused('The browser took the GPU away. Load the page again.');
    const logs = [fragment!, vertex!].map(shader => gl.getShaderInfoLog(shader) ?? ''),
        found = messages(logs[0]!);
    throw found.length
        ? explained(call, program, found)
        : new Refused(`The shader does not link: ${[...logs, gl.getProgramInfoLog(made)].join(' ').trim()}`);
}

/** Names of what the function uses of its uniforms, which must all have a value. */
function used_uniforms(gl: GL, program: WebGLProgram, { textures, uniforms }: Call): Set<string> {
    const count: number = gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS);
    const all = Array.from({ length: count }, (_, i) => gl.getActiveUniform(program, i)!.name);
    const given = [
        ...Object.keys(units),
        'umbrage_size',
        'umbrage_component',
        ...[...textures, ...uniforms].map(each => each.name),
    ];
    const missing = all.find(name => !given.includes(name));
    if (missing)
        throw new Refused(
            `The function uses the uniform ${missing}, and the page has no value of its type. Make it an argument.`,
        );
    return new Set(all);
}

function prepare(gl: GL, version: 1 | 2, target: Target, call: Call, reading: Reading): Prepared {
    const program = link(gl, call, reading, target.as_bytes),
        used = used_uniforms(gl, program, call);
    const values = call.uniforms
        .filter(each => used.has(each.name))
        .map(each => ({
            each,
            value: prepare(gl, version, target, uniform_call(call, each), { ...reading, globals: [] }),
        }));
    return {
        async run(batch) {
            const given = await Promise.all(
                values.map(
                    async ({ each, value }) =>
                        [each, await value.run({ ...batch, inputs: new Float32Array(4) })] as const,
                ),
            );
            const rows = Math.ceil(batch.inputs.length / 4 / width),
                padded = new Float32Array(width * rows * 4);
            padded.set(batch.inputs);
            texture(gl, units.umbrage_inputs);
            upload(gl, version, width, rows, padded);
            if (batch.map.length) give_map(gl, version, batch);
            gl.useProgram(program);
            const at = (name: string) => gl.getUniformLocation(program, name);
            for (const [name, unit] of Object.entries(units)) gl.uniform1i(at(name), unit);
            for (const each of call.textures)
                gl.uniform1i(at(each.name), units[texture_of(each) as keyof typeof units]);
            gl.uniform2f(at('umbrage_size'), ...batch.size);
            for (const [{ name, type }, value] of given) set_uniform(gl, at(name), type, value);
            target.bind(rows);
            return draw(gl, at('umbrage_component'), rows, target.as_bytes).slice(0, batch.inputs.length);
        },
    };
}

function set_uniform(
    gl: GL,
    at: WebGLUniformLocation | null,
    type: Bound['type'],
    [x = 0, y = 0, z = 0, w = 0]: Float32Array,
): void {
    if (type === 'vec4') gl.uniform4f(at, x, y, z, w);
    else if (type === 'vec3') gl.uniform3f(at, x, y, z);
    else if (type === 'vec2') gl.uniform2f(at, x, y);
    else if (type === 'float') gl.uniform1f(at, x);
    else gl.uniform1i(at, x); // int, bool: settable_uniforms has no other
}

/** Draws, and gives four floats for each pixel. A target of bytes takes one component at a time. */
function draw(gl: GL, component: WebGLUniformLocation | null, rows: number, as_bytes: boolean): Float32Array {
    const all = new Float32Array(width * rows * 4),
        bytes = new Uint8Array(as_bytes ? width * rows * 4 : 0),
        floats = new Float32Array(bytes.buffer);
    for (let k = 0; k < (as_bytes ? 4 : 1); ++k) {
        gl.uniform1i(component, k);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        if (as_bytes) gl.readPixels(0, 0, width, rows, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
        else gl.readPixels(0, 0, width, rows, gl.RGBA, gl.FLOAT, all);
        floats.forEach((value, i) => {
            all[4 * i + k] = value;
        });
    }
    const error = gl.getError();
    if (error)
        throw new Refused(
            gl.isContextLost()
                ? 'The browser took the GPU away. Load the page again.'
                : `WebGL error ${error}. It comes of what the shader declares and the page does not bind.`,
        );
    return all;
}
