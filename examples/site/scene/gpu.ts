// SPDX-License-Identifier: MIT
//
// WebGL 2 without its ceremony: programs, textures, targets.
export type GL = WebGL2RenderingContext;

export function make_program(gl: GL, vertex: string, fragment: string): WebGLProgram {
    const program = gl.createProgram()!;
    for (const [stage, text] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]] as const) {
        const shader = gl.createShader(stage)!;
        gl.shaderSource(shader, text);
        gl.compileShader(shader);
        gl.attachShader(program, shader);
        gl.deleteShader(shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost()) {
        const logs = gl.getAttachedShaders(program)!.map(shader => gl.getShaderInfoLog(shader));
        throw new Error([...logs, gl.getProgramInfoLog(program)].join('\n'));
    }
    return program;
}

/** A texture whose texels are read by their numbers. Formats: RGBA32F, R32F, RGBA8. */
export function make_texture(gl: GL, format: 'RGBA32F' | 'R32F' | 'RGBA8', width: number, height: number): WebGLTexture {
    const texture = gl.createTexture()!;
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl[format], width, height);
    for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.NEAREST);
    for (const name of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, name, gl.CLAMP_TO_EDGE);
    return texture;
}

export interface Target {
    readonly frame: WebGLFramebuffer;
    readonly colors: readonly WebGLTexture[];
    readonly depth: WebGLRenderbuffer | null;
    readonly width: number;
    readonly height: number;
}

/** A framebuffer with a texture for each format, and with depths if asked for. */
export function make_target(gl: GL, formats: readonly ('RGBA32F' | 'R32F' | 'RGBA8')[], width: number, height: number,
                            with_depth: boolean): Target {
    const colors = formats.map(format => make_texture(gl, format, width, height)), frame = gl.createFramebuffer()!;
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    colors.forEach((color, i) =>
        gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, color, 0));
    gl.drawBuffers(colors.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
    const depth = with_depth ? gl.createRenderbuffer() : null;
    if (depth) {
        gl.bindRenderbuffer(gl.RENDERBUFFER, depth);
        gl.renderbufferStorage(gl.RENDERBUFFER, gl.DEPTH_COMPONENT32F, width, height);
        gl.framebufferRenderbuffer(gl.FRAMEBUFFER, gl.DEPTH_ATTACHMENT, gl.RENDERBUFFER, depth);
    }
    return { frame, colors, depth, width, height };
}

export function delete_target(gl: GL, target: Target | undefined) {
    if (!target) return;
    target.colors.forEach(color => gl.deleteTexture(color));
    gl.deleteRenderbuffer(target.depth);
    gl.deleteFramebuffer(target.frame);
}

/** The texels of a target's color, row 0 first: four floats or four bytes each. */
export function read_back(gl: GL, target: Target, color: number, format: 'floats'): Float32Array<ArrayBuffer>;
export function read_back(gl: GL, target: Target, color: number, format: 'bytes'): Uint8Array<ArrayBuffer>;
export function read_back(gl: GL, { frame, width, height }: Target, color: number, format: 'floats' | 'bytes') {
    const texels = format === 'floats' ? new Float32Array(width * height * 4) : new Uint8Array(width * height * 4);
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, frame);
    gl.readBuffer(gl.COLOR_ATTACHMENT0 + color);
    gl.readPixels(0, 0, width, height, gl.RGBA, format === 'floats' ? gl.FLOAT : gl.UNSIGNED_BYTE, texels);
    return texels;
}

/** Binds a texture to a unit, and the program's sampler of that name to it. */
export function use_texture(gl: GL, program: WebGLProgram, name: string, texture: WebGLTexture, unit: number) {
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.uniform1i(gl.getUniformLocation(program, name), unit);
}
