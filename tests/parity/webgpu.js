// SPDX-License-Identifier: MIT
//
// Draws for remote.cpp with Dawn, without a browser:  node webgpu.js NODE_MODULES DRIVER
//
// DRIVER is the Vulkan loader's description of a driver. Jobs are those of webgl.js, with WGSL as fragment shader.
'use strict';
const dawn = require('./dawn.js');
const { serve, parts_of } = require('./frames.js');
const [modules, driver] = process.argv.slice(2);

const triangle = `@vertex fn main(@builtin(vertex_index) i: u32) -> @builtin(position) vec4f {
    return vec4f(f32(i & 1u) * 4.0 - 1.0, f32(i >> 1) * 4.0 - 1.0, 0.0, 1.0);
}`;

async function draw({ adapter, device }) {
    const textures = [], targets = {};
    let bound = [], compiled, pipeline, pixels;

    async function checked(make) {
        device.pushErrorScope('validation');
        const made = await make();
        const error = await device.popErrorScope();
        if (error) throw new Error(error.message);
        return made;
    }

    function compile(fragment, format) {
        const module = code => device.createShaderModule({ code });
        const texture = { sampleType: 'unfilterable-float' };
        const entries = bound.map(binding => ({ binding, visibility: GPUShaderStage.FRAGMENT, texture }));
        const bindGroupLayouts = [device.createBindGroupLayout({ entries })];
        return checked(() => device.createRenderPipeline({
            layout: device.createPipelineLayout({ bindGroupLayouts }),
            vertex: { module: module(triangle) },
            fragment: { module: module(fragment), targets: [{ format }] },
        }));
    }

    function upload({ unit, size }, values) {
        const old = textures[unit], bytes = { bytesPerRow: size[0] * 16 };
        if (!old || old.width !== size[0] || old.height !== size[1]) {
            if (old) old.destroy();
            const usage = GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST;
            textures[unit] = device.createTexture({ format: 'rgba32float', size, usage });
        }
        device.queue.writeTexture({ texture: textures[unit] }, values, bytes, size);
    }

    await serve(block => checked(async () => {
        const [head, , fragment, ...values] = parts_of(block);
        const job = JSON.parse(head);
        if (job.hello) return Buffer.from(adapter.info.description);
        if (job.textures) {
            job.textures.forEach((t, i) => upload(t, values[i]));
            bound = job.textures.map(t => t.unit);
        }
        const format = job.bytes ? 'rgba8unorm' : 'rgba32float', text = Buffer.from(fragment).toString();
        if (compiled !== format + text) pipeline = await compile(text, format);
        compiled = format + text;

        const [width, height] = job.size, row = width * (job.bytes ? 4 : 16);
        if (!targets[format] || targets[format].height !== height) {
            const usage = GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.COPY_SRC;
            targets[format] = device.createTexture({ format, size: job.size, usage });
        }
        if (!pixels || pixels.size < row * job.rows)
            pixels = device.createBuffer({ size: row * job.rows, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ });
        const commands = device.createCommandEncoder(), view = targets[format].createView();
        const pass = commands.beginRenderPass({ colorAttachments: [{ view, loadOp: 'clear', storeOp: 'store' }] });
        pass.setPipeline(pipeline);
        const entries = bound.map(binding => ({ binding, resource: textures[binding].createView() }));
        pass.setBindGroup(0, device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries }));
        pass.draw(3);
        pass.end();
        commands.copyTextureToBuffer({ texture: targets[format] }, { buffer: pixels, bytesPerRow: row }, [width, job.rows]);
        device.queue.submit([commands.finish()]);
        await pixels.mapAsync(GPUMapMode.READ, 0, row * job.rows);
        const result = Buffer.from(pixels.getMappedRange(0, row * job.rows).slice(0));
        pixels.unmap();
        return result;
    }));
}

dawn.open(modules, driver).then(draw).then(() => process.exit(0), error => {
    console.error('webgpu.js: ' + error.message);
    process.exit(1);
});
