// SPDX-License-Identifier: MIT
//
// What a function of a shader returns on this machine's GPU, by WebGL 2.

const gl = document.createElement('canvas').getContext('webgl2');
if (!gl?.getExtension('EXT_color_buffer_float')) throw new Error('on_gpu: this browser has no WebGL 2 that draws floats');

/** A texture of four floats per texel under a texture unit. */
function texture(unit, [width, height], texels = null) {
    const made = gl.createTexture();
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, made);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, width, height, 0, gl.RGBA, gl.FLOAT, texels);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);  // the default would need mipmaps
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    return made;
}

function attach(program, stage, text) {
    const shader = gl.createShader(stage);
    gl.shaderSource(shader, `#version 300 es\n${text}`);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS))
        throw new Error(`your function does not compile:\n${gl.getShaderInfoLog(shader)}`);
}

/**
 * @param source   a function in GLSL 300 es. The compiler's messages count its lines
 * @param call     of `map`, a sampler2D, and `point`, a vec3
 * @param map      size in texels, and four floats per texel, sampled at the nearest texel
 * @param inputs   three floats each
 * @return         one float for each input
 */
export function on_gpu(source, call, map, inputs) {
    const program = gl.createProgram(), size = [inputs.length, 1];
    attach(program, gl.VERTEX_SHADER, 'void main() { gl_Position = vec4(gl_VertexID % 2 * 4 - 1, gl_VertexID / 2 * 4 - 1, 0, 1); }');
    attach(program, gl.FRAGMENT_SHADER, `precision highp float;
precision highp sampler2D;
uniform sampler2D map, inputs;
out vec4 result;
#line 1
${source}
void main() { vec3 point = texelFetch(inputs, ivec2(gl_FragCoord), 0).xyz; result = vec4(${call}); }`);
    gl.linkProgram(program);
    gl.useProgram(program);
    gl.uniform1i(gl.getUniformLocation(program, 'inputs'), 1);
    texture(0, map.size, new Float32Array(map.texels));
    texture(1, size, new Float32Array(inputs.flatMap(input => [...input, 0])));
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture(2, size), 0);
    gl.viewport(0, 0, ...size);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const results = new Float32Array(4 * inputs.length);
    gl.readPixels(0, 0, ...size, gl.RGBA, gl.FLOAT, results);
    return inputs.map((_, i) => results[4 * i]);
}
