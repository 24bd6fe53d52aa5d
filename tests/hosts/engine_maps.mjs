// SPDX-License-Identifier: MIT
//
// Depths of an engine's map as the device holds them: past a comparison sampler, by a shader of our own.

/** Depths of a WebGL 2 texture, or of layers one behind the other; for an engine that is thrown away, as its state is not put back. */
export function depths_in_webgl(gl, texture, size, layers) {
    const program = gl.createProgram();
    for (const [type, text] of [
        [gl.VERTEX_SHADER, `void main() {
            vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
            gl_Position = vec4(corner, 0.0, 1.0);
        }`],
        [gl.FRAGMENT_SHADER, `precision highp float;
        uniform highp ${layers ? 'sampler2DArray' : 'sampler2D'} map;
        uniform int layer;
        out vec4 color;
        void main() { color = texelFetch(map, ${layers ? 'ivec3(gl_FragCoord.xy, layer)' : 'ivec2(gl_FragCoord.xy)'}, 0); }`]]) {
        const shader = gl.createShader(type);
        gl.shaderSource(shader, `#version 300 es\n${text}`);
        gl.compileShader(shader);
        gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    const target = gl.createTexture(), kind = layers ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D;
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, target);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA32F, size, size);
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
    gl.bindTexture(kind, texture);
    gl.bindSampler(0, null);
    gl.texParameteri(kind, gl.TEXTURE_COMPARE_MODE, gl.NONE);
    gl.texParameteri(kind, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
    gl.texParameteri(kind, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    gl.bindVertexArray(null);
    for (const state of [gl.DEPTH_TEST, gl.BLEND, gl.CULL_FACE, gl.SCISSOR_TEST, gl.STENCIL_TEST]) gl.disable(state);
    gl.colorMask(true, true, true, true);
    gl.viewport(0, 0, size, size);
    gl.useProgram(program);
    const pixels = new Float32Array(size * size * 4), depths = new Float32Array(size * size * (layers ?? 1));
    for (let layer = 0; layer < (layers ?? 1); ++layer) {
        gl.uniform1i(gl.getUniformLocation(program, 'layer'), layer);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.readPixels(0, 0, size, size, gl.RGBA, gl.FLOAT, pixels);
        depths.set(pixels.filter((_, i) => i % 4 === 0), layer * size * size);
    }
    return depths;
}

/** The same of a WebGPU texture. */
export async function depths_in_webgpu(device, texture, size, layers) {
    const depth = texture.format.startsWith('depth');
    const type = `texture_${depth ? 'depth_' : ''}2d${layers ? '_array' : ''}${depth ? '' : '<f32>'}`;
    const module = device.createShaderModule({ code: `
        @group(0) @binding(0) var map: ${type};
        @group(0) @binding(1) var<storage, read_write> depths: array<f32>;
        @compute @workgroup_size(8, 8) fn main(@builtin(global_invocation_id) id: vec3u) {
            depths[(id.z * ${size}u + id.y) * ${size}u + id.x] = textureLoad(map, id.xy, ${layers ? 'id.z, ' : ''}0)${depth ? '' : '.x'};
        }` });
    const pipeline = device.createComputePipeline({ layout: 'auto', compute: { module } }), bytes = size * size * 4 * (layers ?? 1);
    const written = device.createBuffer({ size: bytes, usage: GPUBufferUsage.STORAGE | GPUBufferUsage.COPY_SRC });
    const read = device.createBuffer({ size: bytes, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ });
    const view = texture.createView({ dimension: layers ? '2d-array' : '2d', aspect: depth ? 'depth-only' : 'all' });
    const encoder = device.createCommandEncoder(), pass = encoder.beginComputePass();
    pass.setPipeline(pipeline);
    pass.setBindGroup(0, device.createBindGroup({ layout: pipeline.getBindGroupLayout(0),
        entries: [{ binding: 0, resource: view }, { binding: 1, resource: { buffer: written } }] }));
    pass.dispatchWorkgroups(size / 8, size / 8, layers ?? 1);
    pass.end();
    encoder.copyBufferToBuffer(written, 0, read, 0, bytes);
    device.queue.submit([encoder.finish()]);
    await read.mapAsync(GPUMapMode.READ);
    return new Float32Array(read.getMappedRange().slice(0));
}
