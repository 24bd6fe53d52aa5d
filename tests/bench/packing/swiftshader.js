// SPDX-License-Identifier: MIT
//
// packing.cpp's run of all depths, as a WebGL 2 page: `programs` are its shaders, and the document becomes the
// renderer's name and a line for each run, of worst error, breaks and the value of 1.0.
const gl = new OffscreenCanvas(1, 1).getContext('webgl2');
const depths = 1 << 24, width = 4096, height = 1024;
if (!gl || !gl.getExtension('EXT_color_buffer_float')) throw new Error('no WebGL 2 with float targets');

const targets = {};
for (const [name, format, type] of [['bytes', gl.RGBA8, gl.UNSIGNED_BYTE], ['written', gl.RGBA32F, gl.FLOAT],
                                    ['values', gl.RGBA32F, gl.FLOAT]]) {
    const texture = gl.createTexture(), frame = gl.createFramebuffer();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    gl.texImage2D(gl.TEXTURE_2D, 0, format, width, height, 0, gl.RGBA, type, null);
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    targets[name] = {texture, frame};
}
gl.disable(gl.DITHER);
gl.viewport(0, 0, width, height);

function link(fragment) {
    const program = gl.createProgram();
    for (const [kind, text] of [[gl.VERTEX_SHADER, programs.vertex], [gl.FRAGMENT_SHADER, fragment]]) {
        const stage = gl.createShader(kind);
        gl.shaderSource(stage, text);
        gl.compileShader(stage);
        gl.attachShader(program, stage);
        if (!gl.getShaderParameter(stage, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(stage));
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program));
    return program;
}

function draw(program, first, from, to) {
    gl.bindFramebuffer(gl.FRAMEBUFFER, targets[to].frame);
    gl.bindTexture(gl.TEXTURE_2D, targets[from].texture);
    gl.useProgram(program);
    gl.uniform1i(gl.getUniformLocation(program, 'first'), first);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
}

const texels = new Float32Array(4 * width * height), truncate = link(programs.truncate);
let lines = gl.getParameter(gl.getExtension('WEBGL_debug_renderer_info').UNMASKED_RENDERER_WEBGL);
for (const run of programs.runs) {
    const encode = link(run.encode), decode = link(run.decode);
    let worst = 0, breaks = 0, last = -Infinity;
    for (let first = 0; first <= depths; first += width * height) {
        draw(encode, first, 'values', run.truncates ? 'written' : 'bytes');
        if (run.truncates) draw(truncate, first, 'written', 'bytes');
        draw(decode, first, 'bytes', 'values');
        gl.readPixels(0, 0, width, first < depths ? height : 1, gl.RGBA, gl.FLOAT, texels);
        const count = Math.min(width * height, depths + 1 - first);
        for (let i = 0; i < count; ++i) {
            const decoded = texels[4 * i], error = Math.abs(decoded - (first + i) / depths);
            if (first + i < depths && !(error <= worst)) worst = Number.isNaN(error) ? Infinity : error;
            if (!(decoded >= last)) ++breaks;
            last = decoded;
        }
    }
    lines += `\n${worst === Infinity ? 'inf' : worst} ${breaks} ${last}`;
    gl.deleteProgram(encode);
    gl.deleteProgram(decode);
}
if (gl.getError()) throw new Error('a WebGL call failed');
document.body.textContent = lines;
