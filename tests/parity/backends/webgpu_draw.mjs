// SPDX-License-Identifier: MIT
//
// Draws jobs in WebGPU: parity's in webgpu.js, and those of a page. Jobs are those of webgl_draw.mjs, with WGSL as
// fragment shader.
import { parts_of } from './parts.mjs';

const triangle = `@vertex fn main(@builtin(vertex_index) i: u32) -> @builtin(position) vec4f {
    return vec4f(f32(i & 1u) * 4.0 - 1.0, f32(i >> 1) * 4.0 - 1.0, 0.0, 1.0);
}`;

const copy_depth = `@group(0) @binding(0) var depths: texture_2d<f32>;
@fragment fn main(@builtin(position) pixel: vec4f) -> @builtin(frag_depth) f32 {
    return textureLoad(depths, vec2i(pixel.xy), 0).x;
}`;

// shape, format and compare are numbers of texture_image in texture.hpp.
const formats = [
    { format: 'rgba32float', bytes: 16, sampleType: 'unfilterable-float' },
    { format: 'rgba32uint', bytes: 16, sampleType: 'uint' },
    { format: 'depth32float', bytes: 4, sampleType: 'depth' },
    { format: 'depth16unorm', bytes: 2, sampleType: 'depth' },
    { format: 'rgba8unorm', bytes: 4, sampleType: 'float' },
];
const shapes = ['2d', '2d-array', 'cube'], comparisons = [undefined, 'less-equal', 'greater-equal'];

/** Name that an adapter gives itself, as far as it does. */
function name_of({ description, vendor, architecture, device }) {
    return description || [vendor, architecture, device].filter(Boolean).join(' ') || 'unknown';
}

/** Function that draws a job and gives its pixels. */
export function webgpu({ adapter, device }) {
    const textures = [], targets = {}, module = code => device.createShaderModule({ code });
    let bound = [], compiled, pipeline, pixels, depth_pipeline;

    async function checked(make) {
        device.pushErrorScope('validation');
        const made = await make();
        const error = await device.popErrorScope();
        if (error) throw new Error(error.message);
        return made;
    }

    function compile(fragment, format) {
        const visibility = GPUShaderStage.FRAGMENT;
        const entries = bound.flatMap(({ what: t }) => [
            { binding: t.unit, visibility,
                texture: { sampleType: formats[t.format].sampleType, viewDimension: shapes[t.shape] } },
            ...t.sampler ? [{ binding: t.sampler, visibility,
                sampler: { type: t.compare ? 'comparison' : 'non-filtering' } }] : []]);
        const bindGroupLayouts = [device.createBindGroupLayout({ entries })];
        return checked(() => device.createRenderPipeline({
            layout: device.createPipelineLayout({ bindGroupLayouts }),
            vertex: { module: module(triangle) },
            fragment: { module: module(fragment), targets: [{ format }] },
        }));
    }

    function create(t, usage, format) {
        const size = [...t.size, t.layers];
        return device.createTexture({ format, size, usage: usage | GPUTextureUsage.TEXTURE_BINDING });
    }

    function write(texture, t, values) {
        const [width, height] = t.size, layout = { bytesPerRow: width * formats[t.format].bytes, rowsPerImage: height };
        device.queue.writeTexture({ texture }, values, layout, [width, height, t.layers]);
    }

    // Depths that are floats cannot be written: they are drawn.
    function draw_depths(texture, t, values) {
        depth_pipeline ||= device.createRenderPipeline({
            layout: 'auto',
            vertex: { module: module(triangle) },
            fragment: { module: module(copy_depth), targets: [] },
            depthStencil: { format: texture.format, depthWriteEnabled: true, depthCompare: 'always' },
        });
        const floats = create(t, GPUTextureUsage.COPY_DST, 'r32float'), commands = device.createCommandEncoder();
        write(floats, t, values);
        for (let baseArrayLayer = 0; baseArrayLayer < t.layers; ++baseArrayLayer) {
            const layer = of => of.createView({ dimension: '2d', baseArrayLayer, arrayLayerCount: 1 });
            const pass = commands.beginRenderPass({ colorAttachments: [], depthStencilAttachment:
                { view: layer(texture), depthLoadOp: 'clear', depthClearValue: 0, depthStoreOp: 'store' } });
            pass.setPipeline(depth_pipeline);
            const entries = [{ binding: 0, resource: layer(floats) }];
            pass.setBindGroup(0, device.createBindGroup({ layout: depth_pipeline.getBindGroupLayout(0), entries }));
            pass.draw(3);
            pass.end();
        }
        device.queue.submit([commands.finish()]);
    }

    function upload(t, values) {
        const { format } = formats[t.format], drawn = format === 'depth32float', key = JSON.stringify(t);
        if (textures[t.unit]?.key !== key) {
            textures[t.unit]?.texture.destroy();
            const texture = create(t, drawn ? GPUTextureUsage.RENDER_ATTACHMENT : GPUTextureUsage.COPY_DST, format);
            const filter = t.linear ? 'linear' : 'nearest';
            const compare = comparisons[t.compare];
            const sampler = device.createSampler({ magFilter: filter, minFilter: filter, compare });
            const view = texture.createView({ dimension: shapes[t.shape] });
            const resources = [{ binding: t.unit, resource: view }];
            if (t.sampler) resources.push({ binding: t.sampler, resource: sampler });
            textures[t.unit] = { key, what: t, texture, resources };
        }
        (drawn ? draw_depths : write)(textures[t.unit].texture, t, values);
        return textures[t.unit];
    }

    return block => checked(async () => {
        const [head, , fragment, ...values] = parts_of(block), text_of = part => new TextDecoder().decode(part);
        const job = JSON.parse(text_of(head));
        if (job.hello) return new TextEncoder().encode(name_of(adapter.info));
        if (job.textures) bound = job.textures.map((t, i) => upload(t, values[i]));
        const format = job.bytes ? 'rgba8unorm' : 'rgba32float', text = text_of(fragment);
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
        const entries = bound.flatMap(t => t.resources);
        pass.setBindGroup(0, device.createBindGroup({ layout: pipeline.getBindGroupLayout(0), entries }));
        pass.draw(3);
        pass.end();
        commands.copyTextureToBuffer({ texture: targets[format] }, { buffer: pixels, bytesPerRow: row }, [width, job.rows]);
        device.queue.submit([commands.finish()]);
        await pixels.mapAsync(GPUMapMode.READ, 0, row * job.rows);
        const result = new Uint8Array(pixels.getMappedRange(0, row * job.rows).slice(0));
        pixels.unmap();
        return result;
    });
}
